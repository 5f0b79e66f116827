"""The batches of a run: which frames a step sees, as which views."""

from __future__ import annotations

import time
from dataclasses import replace
from typing import Any

import numpy as np
from torch import Tensor

from macram.model import Levels
from macram.train.augment import NONE, AugmentSettings
from macram.train.config import TrainConfig
from macram.train.distributed import Processes
from macram.train.pack import PackedFrames
from macram.train.schedule import crop_phase
from macram.train.views import VIEWS, draw_views, frame_order
from macram.train.warp import Batch, Cells, Warper


class Feed:
    """Makes batches; what is in one depends on the seed and the step alone.

    Args:
        config: of the run.
        frames: to draw from.
        processes: this process among all; each gets its part of a batch.
        levels: of the network's feature pyramid.
        augment: how views are drawn.
        counterfactual: make the pictures without the target too.

    Attributes:
        seconds: spent here since somebody set it to zero.
    """

    def __init__(
        self,
        config: TrainConfig,
        frames: PackedFrames,
        processes: Processes,
        levels: Levels,
        augment: AugmentSettings,
        *,
        counterfactual: bool,
    ) -> None:
        self.config, self.frames, self.processes = config, frames, processes
        self.levels, self.augment = levels, augment
        self.warper = Warper(frames, processes.device, config.run.seed, counterfactual=counterfactual)
        self.cells: dict[tuple[int, int], Cells] = {}
        self.seconds = 0.0

    def plain(self, count: int) -> Tensor:
        """Up to ``count`` whole frames, spread over all, normalised: ``[count, 3, H, W]``."""
        chosen = np.linspace(0, len(self.frames) - 1, min(count, len(self.frames))).round().astype(np.int64)
        batch, _ = self._batch(chosen, np.random.default_rng(0), self.frames.size, plain=True)
        return batch.image

    def batch(self, step: int, visits: int, images: int, done: float) -> tuple[Batch, Cells, int]:
        """This process's part of a step's views, their cells, their height.

        Args:
            step: how many went before.
            visits: images that went before.
            images: of all processes in this step.
            done: share of the schedule that lies behind; decides the views' size.
        """
        start = time.monotonic()
        rng = np.random.default_rng([self.config.run.seed, VIEWS, step])
        side = int(rng.choice(crop_phase(self.config, done).sizes))
        size = (side, side) if side else self.frames.size
        chosen = frame_order(self.config.run.seed, len(self.frames), visits, images)
        batch, cells = self._batch(chosen, rng, size)
        self.seconds += time.monotonic() - start
        return batch, cells, size[0]

    def _batch(
        self, chosen: Any, rng: np.random.Generator, size: tuple[int, int], *, plain: bool = False
    ) -> tuple[Batch, Cells]:
        if size not in self.cells:
            self.cells[size] = Cells(self.levels, size, self.processes.device)
        cells = self.cells[size]
        settings = NONE if plain else self.augment
        views = draw_views(
            self.frames,
            chosen,
            rng,
            replace(settings, centred=size != self.frames.size),
            size=size,
            anchors=self.levels.anchors,
            cells=len(cells),
            noise_places=self.warper.noise_places(size),
        )
        part = views if plain else views.part(self.processes.rank, self.processes.world)
        return self.warper.batch(part, cells, size), cells
