"""Equality of integer codes: how many were compared, how many differ, and where first."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, slots=True)
class Comparison:
    """The result of `compare`.

    Attributes:
        compared: codes looked at.
        mismatches: codes that differ.
        first: the first difference in channel, row, column order as plain values with the keys
            ``channel``, ``y``, ``x``, ``expected`` and ``produced``; None if nothing differs.
    """

    compared: int
    mismatches: int
    first: dict[str, int] | None = None

    @property
    def equal(self) -> bool:
        """Something was compared and nothing differs."""
        return self.compared > 0 and self.mismatches == 0

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON."""
        return {
            "compared": self.compared,
            "mismatches": self.mismatches,
            "first_difference": self.first,
        }

    def __str__(self) -> str:
        text = f"{self.compared:,} output codes compared, {self.mismatches:,} differ"
        if self.first:
            text += (
                "; first at (channel {channel}, y {y}, x {x}): expected {expected}, got {produced}".format(
                    **self.first
                )
            )
        return text


def compare(expected: NDArray[np.integer], produced: NDArray[np.integer]) -> Comparison:
    """Compare ``[channels, height, width]`` codes one by one.

    Raises:
        ValueError: the shapes differ, or an array is not three-dimensional or holds no integers.
    """
    for name, codes in (("expected", expected), ("produced", produced)):
        if codes.ndim != 3 or not np.issubdtype(codes.dtype, np.integer):
            raise ValueError(
                f"{name} codes must be integers [channels, height, width], "
                f"not {codes.dtype} {list(codes.shape)}"
            )
    if expected.shape != produced.shape:
        raise ValueError(
            f"expected codes are {list(expected.shape)}, produced codes are {list(produced.shape)}"
        )
    differs = expected != produced
    count = int(np.count_nonzero(differs))
    first = None
    if count:
        channel, y, x = (int(i) for i in np.unravel_index(int(np.argmax(differs)), differs.shape))
        first = {
            "channel": channel,
            "y": y,
            "x": x,
            "expected": int(expected[channel, y, x]),
            "produced": int(produced[channel, y, x]),
        }
    return Comparison(expected.size, count, first)
