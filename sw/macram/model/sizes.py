"""Networks by name: a size (how wide) times a variant (how faithful, how deployable)."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from macram.model.backbone import BackboneConfig
from macram.model.config import PUBLISHED_FAULTS, SPEED_LEVELS, SpaceNetConfig

FULL_DEPTH = (1, 2, 8, 8, 4)
SIZES: dict[str, dict[str, Any]] = {
    "paper": {"width": 1.0, "pyramid": 256},
    "quarter": {"width": 0.25, "pyramid": 64},
    "eighth": {"width": 0.125, "pyramid": 32},
    # Full width up to the reference layer, a quarter behind it: the array's layer with learned weights.
    "paper-front": {"width": 1.0, "late_width": 0.25, "pyramid": 64},
    # For tests: every kind of layer once.
    "tiny": {"width": 0.125, "stages": (1, 1, 1, 1, 1), "pyramid": 16, "tower": 2},
}
VARIANTS = ("corrected", "published", "deployable")


def spacenet_config(
    size: str = "paper", variant: str = "corrected", *, dataset: str = "swisscube", **fields: Any
) -> SpaceNetConfig:
    """The configuration of a named network.

    Args:
        size: one of `SIZES`.
        variant: ``corrected`` (published layers, no fault), ``published`` (every fault and the unused
            classifier) or ``deployable`` (corrected, ReLU for LeakyReLU, batch for group normalisation).
        dataset: ``swisscube`` (512 x 512, 8 corners) or ``speed`` (960 x 960, 11 keypoints, factor 0.1).
        fields: any field of `SpaceNetConfig`, over all of the above.

    Raises:
        ValueError: an unknown name, or a field out of range.
    """
    for name, value, known in (
        ("size", size, tuple(SIZES)),
        ("variant", variant, VARIANTS),
        ("dataset", dataset, ("swisscube", "speed")),
    ):
        if value not in known:
            raise ValueError(f"{name} must be one of {', '.join(known)}, not {value!r}")
    shape = {"stages": FULL_DEPTH, "tower": 4, "late_width": None, **SIZES[size]}
    config = SpaceNetConfig(
        backbone=BackboneConfig(
            shape["width"],
            shape["stages"],
            "relu" if variant == "deployable" else "leaky",
            late_width=shape["late_width"],
        ),
        pyramid=shape["pyramid"],
        tower=shape["tower"],
        norm="batch" if variant == "deployable" else "group",
    )
    if variant == "published":
        config = replace(config, faults=PUBLISHED_FAULTS, classifier=True)
    if dataset == "speed":
        config = replace(config, levels=SPEED_LEVELS, image_size=960, keypoints=11, tde_factor=0.1)
    return replace(config, **fields)
