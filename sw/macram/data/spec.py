"""What a rendered data set is made of: tiers, splits, and a fingerprint of all that decides its content."""

from __future__ import annotations

import hashlib
import json
import math
from dataclasses import asdict, dataclass, replace
from typing import Any

from macram.data.speed import FOCAL, SIZE

SPLITS = ("training", "validation", "testing")
"""Their places are the split's number in the seed: testing sequences never share one with training."""

GENERATOR = 1
"""Raised whenever the same seed would give other pictures or poses."""

FORMATS = ("bop", "speed")


@dataclass(frozen=True)
class RenderSpec:
    """Everything that decides the content.

    Attributes:
        size: width and height, pixels.
        focal: focal length, pixels.
        depth: nearest and farthest depth of the target, diameters.
        sequences: of training, validation and testing.
        frames: per sequence.
        seed: base seed.
        background: also store each picture without the target.
        format: ``bop`` (SwissCube's layout) or ``speed``.
    """

    size: tuple[int, int]
    focal: float
    depth: tuple[float, float]
    sequences: tuple[int, int, int]
    frames: int
    seed: int = 2022
    background: bool = False
    format: str = "bop"

    def __post_init__(self) -> None:
        for name, value in (("size", min(self.size)), ("frames", self.frames)):
            if value < 1:
                raise ValueError(f"{name} must be 1 or more, not {value}")
        if self.size[0] % 8 or self.size[1] % 8:
            raise ValueError(f"size must be a multiple of 8, not {self.size[0]}x{self.size[1]}")
        if not 0 < self.focal < math.inf:
            raise ValueError(f"focal must be above 0, not {self.focal}")
        if min(self.sequences) < 0 or not any(self.sequences):
            raise ValueError(f"sequences must be 0 or more and not all 0, not {self.sequences}")
        if not 0.8 <= self.depth[0] <= self.depth[1] <= 100:
            raise ValueError(
                f"depth must be 0.8 <= dmin <= dmax <= 100, not {self.depth[0]} to {self.depth[1]}"
            )
        if self.seed < 0:
            raise ValueError(f"seed must be 0 or more, not {self.seed}")
        if self.format not in FORMATS:
            raise ValueError(f"format must be one of {', '.join(FORMATS)}, not {self.format!r}")
        if self.format == "speed" and self.size != SIZE:
            raise ValueError(f"SPEED pictures are {SIZE[0]}x{SIZE[1]}, not {self.size[0]}x{self.size[1]}")
        if self.format == "speed" and self.background:
            raise ValueError("SPEED's layout has no place for backgrounds; leave --background away")

    @property
    def total(self) -> int:
        """Number of frames."""
        return sum(self.sequences) * self.frames

    def table(self) -> dict[str, Any]:
        """As it stands in ``dataset.json``."""
        return {"generator": GENERATOR, **json.loads(json.dumps(asdict(self)))}

    def fingerprint(self) -> str:
        """SHA-256 of `table`."""
        return hashlib.sha256(json.dumps(self.table(), sort_keys=True).encode()).hexdigest()


TIERS = {
    "smoke": RenderSpec((128, 128), 151.893258, (1.5, 4.0), (4, 1, 1), 5),
    "mini": RenderSpec((256, 256), 303.786516, (1.5, 10.0), (250, 25, 50), 20),
    "std": RenderSpec((512, 512), 303.786516, (1.0, 10.0), (350, 50, 100), 20),
    "full": RenderSpec((1024, 1024), 607.573032, (1.0, 10.0), (350, 50, 100), 100),
}
"""SwissCube's focal length, or half of it for half its size; smaller pictures are cut out, not scaled down,
since far targets are a matter of fractions of a pixel already. Only `smoke` trades that for speed."""


def as_speed(spec: RenderSpec) -> RenderSpec:
    """The same sequences through SPEED's camera, at depths where its narrow view still holds the target."""
    return replace(spec, size=SIZE, focal=FOCAL, depth=(3.0, 20.0), format="speed")
