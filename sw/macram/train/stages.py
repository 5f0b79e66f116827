"""The network of each stage, made or taken over from the stage before, and its losses."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import torch
from torch import Tensor, nn

from macram.model import SpaceNet, ThreePaths
from macram.quant import quantise
from macram.train.augment import AugmentSettings
from macram.train.checkpoint import Card, load_model, load_state
from macram.train.config import TrainConfig
from macram.train.objective import Objective
from macram.train.pack import PackedFrames
from macram.train.pretrained import load_backbone
from macram.train.teacher import Teacher
from macram.train.warp import Batch, Cells


class Stage:
    """What is trained in a stage.

    Attributes:
        net: the network that will be used.
        module: what has the parameters: ``net``, or the three paths around it.
        card: of ``net``, without this stage's history.
        uncalibrated: whether quantisers wait for their first steps.
        teacher: the network to imitate; None without.

    Args:
        config: of the run.
        frames: to learn from; their object and camera go onto the card.
        device: of training. The teacher is there at once, the network not.

    Raises:
        ValueError: the checkpoint to start from does not suit the stage or the data.
    """

    def __init__(self, config: TrainConfig, frames: PackedFrames, device: torch.device) -> None:
        self.config, self.uncalibrated = config, False
        self.teacher: Teacher | None = None
        generator = torch.Generator().manual_seed(config.run.seed)
        model = frames.model
        self.module: nn.Module
        if config.run.init:
            self._continue(Path(config.run.init), generator)
        else:
            if max(frames.size) != config.network.image_size:
                raise ValueError(
                    f"{config.data.root}: frames of {frames.size[1]}x{frames.size[0]} pixels; set network.image_size "
                    f"to {max(frames.size)}, not {config.network.image_size}"
                )
            self.net = self.module = SpaceNet(config.network.build(len(model.keypoints)), generator)
            if config.run.backbone:
                load_backbone(self.net, Path(config.run.backbone))
            self.card = Card(self.net.config, (), 1.0, "", model.is_box, 1.0)
        if self.net.config.keypoints != len(model.keypoints):
            raise ValueError(
                f"{config.data.root}: the object has {len(model.keypoints)} keypoints, "
                f"the network {self.net.config.keypoints}"
            )
        self.card = replace(
            self.card,
            keypoints=tuple(tuple(map(float, point)) for point in model.keypoints),
            diameter=model.diameter,
            target=model.name,
            is_box=model.is_box,
            focal=float(frames.camera[:, 0, 0].mean()),
        )
        if config.quant.teacher:
            self.teacher = Teacher(Path(config.quant.teacher), self.net, self.card, device)
        if config.run.freeze_backbone and config.run.stage != "counterfactual":
            self.net.freeze_backbone()

    def _continue(self, path: Path, generator: torch.Generator) -> None:
        source, self.card = load_model(path)
        stage, settings = self.config.run.stage, self.config.network
        if stage == "lsq":
            self._quantise(source, path)
            return
        if self.card.mode:
            raise ValueError(f"{path}: is quantised already; stage {stage!r} starts from a float network")
        if source.fpn_pseudo is not None:
            raise ValueError(
                f"{path}: has the pseudo path already; stage {stage!r} starts from a wdr network"
            )
        network = replace(settings.with_faults(source.config), surface=settings.surface)
        if stage == "counterfactual":
            network = replace(network, counterfactual=True, tde_factor=settings.tde_factor)
            self.net = SpaceNet(network, generator)
            self.module = ThreePaths(self.net, generator)
            self.module.load_factual(source.state_dict())
        else:
            self.net = self.module = SpaceNet(network, generator)
            load_state(self.net, source.state_dict(), path)

    def _quantise(self, source: SpaceNet, path: Path) -> None:
        """Quantises a float network; goes on with one that has these very bits and mode."""
        had, mode, bits = self.card.mode, self.config.quant.mode, self.config.quant.bits
        if had and (had, self.card.bits) != (mode, bits):
            raise ValueError(
                f"{path}: has {self.card.bits} bits in mode {had} already; start from a float network, or set "
                f"quant.mode and quant.bits to its own instead of {mode} and {bits}"
            )
        self.card = replace(self.card, mode=mode, bits=bits)
        self.uncalibrated = not had
        self.net = self.module = source if had else quantise(source, mode, self.card.precision)

    @property
    def counterfactual(self) -> bool:
        """Whether pictures without the target are needed."""
        return isinstance(self.module, ThreePaths)

    def augmentation(self) -> AugmentSettings:
        """The run's, with the network's faults on the data side."""
        settings, faults = self.config.augment, self.net.config.faults
        if faults.refitted_poses:
            settings = replace(settings, labels="reference")
        if faults.misaligned_warp:
            settings = replace(settings, draws="independent")
        return settings

    def losses(
        self, objective: Objective, batch: Batch, cells: Cells, images: int, *, surface: bool
    ) -> dict[str, Tensor]:
        """Weighted losses by name; ``images`` are those of all processes together."""
        surface = surface and self.net.head.surface is not None
        if isinstance(self.module, ThreePaths):
            assert batch.erased is not None
            output = self.module(batch.image, batch.erased)
            return objective.three_paths(output, batch, cells, images, surface=surface)
        features = self.net.features(batch.image)
        losses = objective.factual(self.net.predict(features), batch, cells, images, surface=surface)
        if self.teacher is not None:
            goal = self.teacher.features(batch.image)
            losses["imitation"] = objective.imitation(features.direct, goal, batch, cells, images)
        return losses
