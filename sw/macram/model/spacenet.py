"""CA-SpaceNet: backbone, factual and pseudo pyramid, their difference, head; and the three-path training net.

The network that is used (`SpaceNet`) looks at one picture. What the background alone would have produced is
imitated by the pseudo pyramid and subtracted. For training, `ThreePaths` adds the counterfactual path, which
sees the picture with the target erased; it is dropped afterwards.
"""

from __future__ import annotations

import copy
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import NamedTuple, Self

import torch
from torch import Tensor, nn

from macram.model.backbone import DarkNet53
from macram.model.config import PYRAMID_INPUTS, SpaceNetConfig
from macram.model.fpn import FeaturePyramid
from macram.model.head import PoseHead, Prediction

Maps = tuple[Tensor, ...]
IMAGENET_CLASSES = 1000
SURFACE = "head.surface."


class Features(NamedTuple):
    """Pyramid features, P3 to P7.

    Attributes:
        factual: total effect, of the picture.
        pseudo: imitated background; None without the counterfactual method.
        direct: their difference, which the head reads.
    """

    factual: Maps
    pseudo: Maps | None
    direct: Maps


class SpaceNet(nn.Module):
    """The network at inference, and all of the factual stage's training.

    Attributes:
        taps: one per level, called on every pyramid output, a scaled background and the difference. Identity
            here; quantised networks put a quantiser in each place.
        backbone_frozen: set by `freeze_backbone`.

    Args:
        config: everything about it.
        generator: source of the initial weights. The global random state is neither read nor changed.
    """

    def __init__(self, config: SpaceNetConfig, generator: torch.Generator) -> None:
        super().__init__()
        self.config = config
        self.backbone_frozen = False
        self.backbone: nn.Module = DarkNet53(config.backbone, generator)
        self.classifier = _classifier(config) if config.classifier else None
        self.fpn = new_pyramid(config, generator)
        self.fpn_pseudo: FeaturePyramid | None = None
        if config.counterfactual:
            self.fpn_pseudo = new_pyramid(config, generator)
            if config.faults.dead_top:
                self.fpn_pseudo.top = self.fpn.top
        self.head = PoseHead(config)
        self.head.initialise(generator)
        self.taps = nn.ModuleList(nn.Identity() for _ in config.levels.strides)

    def forward(self, image: Tensor) -> tuple[Prediction, ...]:
        """``[N, 3, H, W]`` normalised, H and W multiples of 32 -> predictions of P3 to P7."""
        return self.predict(self.features(image))

    def features(self, image: Tensor) -> Features:
        """``[N, 3, H, W]`` -> the features of both paths and their difference."""
        maps = self.backbone(image)[-PYRAMID_INPUTS:]
        factual = self.fpn(maps, self.taps)
        if self.fpn_pseudo is None:
            return Features(factual, None, factual)
        pseudo = self.fpn_pseudo(maps, self.taps)
        return Features(factual, pseudo, self.difference(factual, pseudo))

    def difference(self, factual: Maps, background: Maps) -> Maps:
        """The direct effect, level by level: factual less ``tde_factor`` times background."""
        factor = self.config.tde_factor
        return tuple(
            tap(f - (b if factor == 1 else tap(factor * b)))
            for tap, f, b in zip(self.taps, factual, background, strict=True)
        )

    def predict(self, features: Features) -> tuple[Prediction, ...]:
        """The head on ``features.direct``."""
        predictions: tuple[Prediction, ...] = self.head(features.direct)
        return predictions

    def freeze_backbone(self) -> None:
        """Stops the backbone: no gradients, and running statistics that stay (unless that fault is on)."""
        self.backbone_frozen = True
        for part in (self.backbone, self.classifier):
            if part is not None:
                part.requires_grad_(False)
        self.train(self.training)

    def train(self, mode: bool = True) -> Self:
        """As `nn.Module.train`, but a frozen backbone stays in evaluation mode."""
        super().train(mode)
        if self.backbone_frozen and not self.config.faults.drifting_statistics:
            self.backbone.eval()
        return self


class TrainingOutput(NamedTuple):
    """What the losses of the counterfactual stage need.

    Attributes:
        predictions: of the picture, from factual less pseudo features.
        pseudo: pseudo features, which shall come to equal ``counterfactual``.
        counterfactual: features of the erased picture, without gradient.
        ideal: predictions from factual less counterfactual features, through which the counterfactual pyramid
            learns; None if that pyramid is untrained.
    """

    predictions: tuple[Prediction, ...]
    pseudo: Maps
    counterfactual: Maps
    ideal: tuple[Prediction, ...] | None


class ThreePaths(nn.Module):
    """The training net of the counterfactual stage: a `SpaceNet` and the counterfactual path beside it.

    The similarity loss alone cannot train the counterfactual pyramid: both sides would agree on a constant.
    So it learns through the head, from the ideal difference that inference only imitates, with the same class
    and pose losses. With the published fault it is a frozen copy of the stage-1 pyramid instead, on a frozen
    copy of the stage-1 backbone.

    Args:
        model: with the pseudo path. Not copied.
        generator: source of the counterfactual pyramid's initial weights.
        freeze: freeze the backbone, as in the counterfactual stage; quantisation-aware training does not.

    Raises:
        ValueError: ``model`` has no pseudo path.
    """

    def __init__(self, model: SpaceNet, generator: torch.Generator, *, freeze: bool = True) -> None:
        super().__init__()
        if model.fpn_pseudo is None:
            raise ValueError("the counterfactual stage needs counterfactual=True in the configuration")
        if freeze:
            model.freeze_backbone()
        self.model = model
        faults = model.config.faults
        self.trained = not faults.untrained_counterfactual
        self.fpn = new_pyramid(model.config, generator)
        # A copy only where the original would not stay what it was.
        self.backbone = copy.deepcopy(model.backbone) if faults.drifting_statistics else None
        self.classifier = copy.deepcopy(model.classifier) if faults.drifting_statistics else None
        for part in (self.backbone, self.classifier):
            if part is not None:
                part.requires_grad_(False)
        self.fpn.requires_grad_(self.trained)
        self.train(self.training)

    def load_factual(self, state: Mapping[str, Tensor]) -> None:
        """Starts from a trained factual stage: its backbone, pyramid and head; its pyramid twice.

        Args:
            state: state dict of a `SpaceNet` of the same configuration with ``counterfactual=False``.

        Raises:
            ValueError: a tensor of the factual path is missing, or does not belong.
        """
        own = dict(self.model.state_dict())
        pseudo = {key for key in own if key.startswith("fpn_pseudo.")}
        if missing := sorted(set(own) - pseudo - set(state)):
            raise ValueError(f"tensor {missing[0]!r} is missing; start from a factual stage of this network")
        # The training-only head is no loss.
        state = {key: value for key, value in state.items() if key in own or not key.startswith(SURFACE)}
        if unknown := sorted(set(state) - set(own)):
            raise ValueError(f"tensor {unknown[0]!r} is unknown; start from a factual stage of this network")
        for key, value in state.items():
            if value.shape != own[key].shape:
                raise ValueError(f"tensor {key!r} must be {list(own[key].shape)}, not {list(value.shape)}")
        self.model.load_state_dict(state, strict=False)
        self.fpn.load_state_dict(self.model.fpn.state_dict())
        for mine, source in (
            (self.backbone, self.model.backbone),
            (self.classifier, self.model.classifier),
        ):
            if mine is not None and source is not None:
                mine.load_state_dict(source.state_dict())

    def forward(self, image: Tensor, erased: Tensor) -> TrainingOutput:
        """Two ``[N, 3, H, W]`` pictures, with the target and without -> everything the losses need."""
        features = self.model.features(image)
        assert features.pseudo is not None
        with torch.no_grad():
            maps = self._background(erased)
        with torch.set_grad_enabled(self.trained and torch.is_grad_enabled()):
            counterfactual: Maps = self.fpn(maps, self.model.taps)
        ideal = None
        if self.trained:
            with _statistics_kept(self.model.head):  # they serve inference, which has no such features
                ideal = self.model.head(self.model.difference(features.factual, counterfactual))
        return TrainingOutput(
            self.model.predict(features),
            features.pseudo,
            tuple(level.detach() for level in counterfactual),
            ideal,
        )

    def _background(self, erased: Tensor) -> Maps:
        backbone = self.model.backbone if self.backbone is None else self.backbone
        training = backbone.training
        backbone.eval()  # the erased picture shall not move statistics either
        maps: Maps = backbone(erased)[-PYRAMID_INPUTS:]
        backbone.train(training)
        return maps

    def train(self, mode: bool = True) -> Self:
        """As `nn.Module.train`, but what is frozen stays in evaluation mode."""
        super().train(mode)
        if self.backbone is not None:
            self.backbone.eval()
        return self


def new_pyramid(config: SpaceNetConfig, generator: torch.Generator) -> FeaturePyramid:
    """An initialised pyramid of the configuration."""
    pyramid = FeaturePyramid(config.backbone.channels[-PYRAMID_INPUTS:], config.pyramid)
    pyramid.initialise(generator)
    return pyramid


@contextmanager
def _statistics_kept(module: nn.Module) -> Iterator[None]:
    """While open, training mode does not move running statistics in ``module``."""
    layers = [m for m in module.modules() if isinstance(m, nn.BatchNorm2d)]
    for layer in layers:
        layer.track_running_stats = False
    try:
        yield
    finally:
        for layer in layers:
            layer.track_running_stats = True


def _classifier(config: SpaceNetConfig) -> nn.Linear:
    """The unused ImageNet classifier, zero."""
    layer = nn.Linear(config.backbone.channels[-1], IMAGENET_CLASSES, device="meta")
    layer = layer.to_empty(device=torch.get_default_device())
    nn.init.zeros_(layer.weight)
    nn.init.zeros_(layer.bias)
    return layer
