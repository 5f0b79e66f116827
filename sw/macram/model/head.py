"""The head, shared by all levels: object or not, and where the keypoints are."""

from __future__ import annotations

import math
from typing import NamedTuple, cast

import torch
from torch import Tensor, nn

from macram.model.backbone import bare_conv, rectified
from macram.model.config import TOWER_GROUP, SpaceNetConfig

PRIOR = 0.01
"""Object probability of every cell before training."""
WEIGHT_STD = 0.01
FACES = 6


class Prediction(NamedTuple):
    """What the head says of one level.

    Attributes:
        logits: ``[N, 1, H, W]``, object or background.
        offsets: ``[N, 2K, H, W]``, all x then all y, in anchor sides from the cell's centre.
        surface: ``[N, 9, H, W]`` of the training-only head, six face logits and the object coordinate in
            half extents of the box; None without it.
    """

    logits: Tensor
    offsets: Tensor
    surface: Tensor | None = None


class Tower(nn.Module):
    """3x3 convolutions of constant width, each normalised and rectified.

    Batch normalisation has its own parameters and statistics per level: features of different levels are not
    of one distribution, and running statistics could not serve them together. A convolution in front of it
    has no bias. Group normalisation is shared by the levels.
    """

    def __init__(self, channels: int, depth: int, norm: str, levels: int) -> None:
        super().__init__()
        batch = norm == "batch"
        self.convs = nn.ModuleList(
            bare_conv(channels, channels, kernel=3, bias=not batch) for _ in range(depth)
        )
        self.norms = nn.ModuleList(
            nn.ModuleList(nn.BatchNorm2d(channels) for _ in range(levels))
            if batch
            else nn.GroupNorm(channels // TOWER_GROUP, channels)
            for _ in range(depth)
        )

    def forward(self, x: Tensor, level: int) -> Tensor:
        """``[N, C, H, W]`` features of ``level`` (0 is P3) -> the same shape."""
        for conv, norm in zip(self.convs, self.norms, strict=True):
            per_level = norm[level] if isinstance(norm, nn.ModuleList) else norm
            x = rectified(per_level, conv(x))
        return x


class PoseHead(nn.Module):
    """Two towers and their predictors. Weights are uninitialised until `initialise`.

    Attributes:
        scales: one learned factor per level on the offsets, ``[levels]``.
    """

    def __init__(self, config: SpaceNetConfig) -> None:
        super().__init__()
        channels, levels = config.pyramid, len(config.levels.strides)
        self.class_tower = Tower(channels, config.tower, config.norm, levels)
        self.pose_tower = Tower(channels, config.tower, config.norm, levels)
        self.classes = bare_conv(channels, 1, kernel=3, bias=True)
        self.pose = bare_conv(channels, 2 * config.keypoints, kernel=3, bias=True)
        self.surface = bare_conv(channels, FACES + 3, kernel=3, bias=True) if config.surface else None
        self.scales = nn.Parameter(torch.ones(levels))

    def initialise(self, generator: torch.Generator) -> None:
        """Normal weights of deviation 0.01, biases zero but the class bias, which sets the prior."""
        for module in self.modules():
            if isinstance(module, nn.Conv2d):
                nn.init.normal_(module.weight, std=WEIGHT_STD, generator=generator)
                if module.bias is not None:
                    nn.init.zeros_(module.bias)
        nn.init.constant_(cast(Tensor, self.classes.bias), -math.log((1 - PRIOR) / PRIOR))

    def forward(self, features: tuple[Tensor, ...]) -> tuple[Prediction, ...]:
        """One ``[N, C, H, W]`` map per level -> one prediction per level."""
        return tuple(self.level(x, level) for level, x in enumerate(features))

    def level(self, x: Tensor, level: int) -> Prediction:
        """``[N, C, H, W]`` features of ``level`` (0 is P3) -> its prediction."""
        logits = self.classes(self.class_tower(x, level))
        pose = self.pose_tower(x, level)
        offsets = self.pose(pose) * self.scales[level]
        return Prediction(logits, offsets, None if self.surface is None else self.surface(pose))
