"""How many images a second a training run would see here, and where its steps spend their time."""

from __future__ import annotations

import statistics
import tempfile
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any, cast

import torch
from torch import Tensor

from macram.train.compiled import library
from macram.train.config import TrainConfig
from macram.train.distributed import Processes, processor_name
from macram.train.loop import Run
from macram.train.mixed import exact_layers
from macram.train.warp import Batch, Cells

WARM_STEPS = 8
"""Steps that fill caches, take memory from the system, and do not count."""
LOADING, GRADIENTS, UPDATE = "views", "forward and backward", "optimiser"


class TimedRun(Run):
    """A run that notes how long each part of a step takes.

    Attributes:
        parts: seconds of every step so far, by part.
    """

    def __init__(self, config: TrainConfig, processes: Processes) -> None:
        super().__init__(config, processes, None)
        self.parts: dict[str, list[float]] = {LOADING: [], GRADIENTS: [], UPDATE: []}

    def step_timed(self) -> tuple[int, float]:
        """One step: its images, its seconds."""
        start = time.perf_counter()
        _, images = self._one_step()
        self._wait()
        return images, time.perf_counter() - start

    def _next_batch(self, images: int, done: float) -> tuple[Batch, Cells, int]:
        part = self._timed(LOADING, lambda: super(TimedRun, self)._next_batch(images, done))
        return cast(tuple[Batch, Cells, int], part)

    def _gradients(self, batch: Batch, cells: Cells, images: int, *, surface: bool) -> dict[str, Tensor]:
        losses = self._timed(
            GRADIENTS, lambda: super(TimedRun, self)._gradients(batch, cells, images, surface=surface)
        )
        return cast(dict[str, Tensor], losses)

    def _update(self, rate: float, loss: Tensor) -> Tensor:
        return cast(Tensor, self._timed(UPDATE, lambda: super(TimedRun, self)._update(rate, loss)))

    def _timed(self, part: str, work: Callable[[], Any]) -> Any:
        start = time.perf_counter()
        result = work()
        self._wait()
        self.parts[part].append(time.perf_counter() - start)
        return result

    def _wait(self) -> None:
        if self.processes.device.type == "cuda":
            torch.cuda.synchronize()


def measure_rate(config: TrainConfig, processes: Processes, steps: int) -> dict[str, Any]:
    """Runs the first steps of a training run and leaves nothing behind but the cache of packed frames.

    Args:
        config: of the run; its ``run.out`` is not touched.
        processes: this one.
        steps: to time, after `WARM_STEPS`.

    Returns:
        ``images_per_second`` (median over steps) and of every step ``rates``; ``parts_ms``, medians of
        the views (reading, warping, toning), of forward and backward, and of the optimiser with the
        moving average; ``loading_share`` of the step's time, ``batch``, ``device``, ``threads``, ``precision``, and
        ``compiled``: whether this package's own C++ took part.
    """
    with tempfile.TemporaryDirectory(prefix="macram-rate-") as folder:
        run = TimedRun(replace(config, run=replace(config.run, out=str(Path(folder) / "run"))), processes)
        run.stage.module.train()
        rates = []
        with exact_layers(run.stage.module, processes.device):
            for step in range(WARM_STEPS + steps):
                images, seconds = run.step_timed()
                if step >= WARM_STEPS:
                    rates.append(images / seconds)
    parts = {name: 1e3 * statistics.median(values[WARM_STEPS:]) for name, values in run.parts.items()}
    return {
        "images_per_second": round(statistics.median(rates), 1),
        "rates": [round(rate, 1) for rate in rates],
        "parts_ms": {name: round(value, 1) for name, value in parts.items()},
        "loading_share": round(parts[LOADING] / sum(parts.values()), 3),
        "batch": images,
        "device": processor_name(processes.device),
        "threads": torch.get_num_threads(),
        "precision": "bf16" if run.mixed else "fp32",
        "compiled": processes.device.type == "cpu" and library("norm_relu") is not None,
    }
