"""What a CA-SpaceNet is made of: one frozen configuration, with the published faults as switches."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

from macram.model.backbone import BackboneConfig

NORMS = ("group", "batch")
TOWER_GROUP = 8
"""Channels per group of the head's group normalisation: 32 groups of 256 channels as published."""
PYRAMID_INPUTS = 3
"""Backbone maps that feed a pyramid: the last three."""


@dataclass(frozen=True, slots=True)
class Faults:
    """Faults of the published code; all off is the corrected network.

    Attributes:
        dead_top: the factual and the pseudo pyramid share the convolutions of P6 and P7, so their difference
            there is exactly zero and the head sees nothing of the image.
        drifting_statistics: training mode reaches the frozen backbone, whose batch-normalisation statistics
            then follow every batch; the counterfactual path keeps a copy with the original ones.
        untrained_counterfactual: the counterfactual pyramid is a frozen copy of the stage-1 pyramid and never
            learns what background looks like.
        misaligned_warp: picture and erased picture are augmented by two independent draws. For the data side.
        refitted_poses: after a warp the pose is refitted under the fixed camera, which is exact only for
            rotations. For the data side.
    """

    dead_top: bool = False
    drifting_statistics: bool = False
    untrained_counterfactual: bool = False
    misaligned_warp: bool = False
    refitted_poses: bool = False


PUBLISHED_FAULTS = Faults(True, True, True, True, True)


@dataclass(frozen=True, slots=True)
class Levels:
    """Where the pyramid's levels sit in the image, P3 first.

    Attributes:
        strides: pixels between neighbouring cells.
        anchors: side of the one square anchor of each level, pixels.

    Raises:
        ValueError: the two differ in length, or a value is not positive.
    """

    strides: tuple[int, ...] = (8, 16, 32, 64, 128)
    anchors: tuple[int, ...] = (32, 64, 128, 256, 512)

    def __post_init__(self) -> None:
        if len(self.strides) != len(self.anchors) or not self.strides:
            raise ValueError(f"levels need one anchor per stride, not {self.strides!r} and {self.anchors!r}")
        if min(*self.strides, *self.anchors) < 1:
            raise ValueError(f"strides and anchors must be positive, not {self.strides!r}, {self.anchors!r}")


SWISSCUBE_LEVELS = Levels()
"""512 x 512 images, and crops of them: maps of 64, 32, 16, 8, 4 cells a side at 512."""
SPEED_LEVELS = Levels((8, 16, 32, 64, 120), (32, 64, 128, 256, 480))
"""960 x 960 images: maps of 120, 60, 30, 15, 8 cells a side, which 120 pixels divide exactly."""


@dataclass(frozen=True, slots=True)
class SpaceNetConfig:
    """A whole network.

    Attributes:
        backbone: DarkNet; its last three stages feed the pyramids.
        pyramid: channels of every pyramid level and of the head's towers.
        tower: convolutions per tower.
        norm: ``group`` (published) or ``batch``, one set per level, which folds into integers.
        keypoints: points regressed per cell; 8 box corners, 11 for SPEED.
        levels: strides and anchors; always five.
        image_size: side of the square images that the network is meant for, pixels, a multiple of 32.
        counterfactual: with the pseudo path and the subtraction; without, the factual path alone (WDR).
        tde_factor: of the pseudo features in the subtraction.
        classifier: carry the backbone's ImageNet classifier, which nothing calls.
        surface: carry the training-only head that predicts the visible face and object coordinate.
        faults: which published faults to reproduce.

    Raises:
        ValueError: a field is out of range, or the fields contradict each other.
    """

    backbone: BackboneConfig = field(default_factory=lambda: BackboneConfig(activation="leaky"))
    pyramid: int = 256
    tower: int = 4
    norm: str = "group"
    keypoints: int = 8
    levels: Levels = SWISSCUBE_LEVELS
    image_size: int = 512
    counterfactual: bool = True
    tde_factor: float = 1.0
    classifier: bool = False
    surface: bool = False
    faults: Faults = Faults()

    def __post_init__(self) -> None:
        if len(self.backbone.stages) < PYRAMID_INPUTS:
            raise ValueError(f"the pyramid needs {PYRAMID_INPUTS} stages, not {self.backbone.stages!r}")
        for name in ("pyramid", "tower", "keypoints"):
            if getattr(self, name) < 1:
                raise ValueError(f"{name} must be at least 1, not {getattr(self, name)!r}")
        if self.norm not in NORMS:
            raise ValueError(f"norm must be one of {', '.join(NORMS)}, not {self.norm!r}")
        if self.norm == "group" and self.pyramid % TOWER_GROUP:
            raise ValueError(f"pyramid must be a multiple of {TOWER_GROUP}, not {self.pyramid!r}")
        if len(self.levels.strides) != 5:
            raise ValueError(f"the pyramid has 5 levels, not {len(self.levels.strides)}")
        if self.image_size < 32 or self.image_size % 32:
            raise ValueError(f"image_size must be a multiple of 32, not {self.image_size!r}")
        if not 0 < self.tde_factor <= 1:
            raise ValueError(f"tde_factor must be above 0 and at most 1, not {self.tde_factor!r}")

    @property
    def deployable(self) -> bool:
        """Whether every operation has an integer form: ReLU, and batch normalisation in the head."""
        return self.backbone.activation == "relu" and self.norm == "batch"

    def to_dict(self) -> dict[str, Any]:
        """JSON types only; `from_dict` takes it back."""
        return asdict(self)

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> SpaceNetConfig:
        """Inverse of `to_dict`; lists count as tuples, missing fields take their defaults.

        Raises:
            ValueError: an unknown field, or a value out of range.
        """
        fields = dict(values)
        for name, part in (("backbone", BackboneConfig), ("levels", Levels), ("faults", Faults)):
            if name in fields:
                fields[name] = _build(part, fields[name])
        config = _build(cls, fields)
        assert isinstance(config, cls)
        return config


def _build(part: type, values: Mapping[str, Any]) -> Any:
    known = part.__dataclass_fields__  # type: ignore[attr-defined]
    if unknown := sorted(set(values) - set(known)):
        raise ValueError(f"{unknown[0]!r} is no field of {part.__name__}; known are {', '.join(known)}")
    return part(**{name: tuple(v) if isinstance(v, list) else v for name, v in values.items()})
