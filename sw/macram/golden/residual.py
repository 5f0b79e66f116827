"""The residual sum of a stage: a branch's codes added to the 8-bit stream, and the codes that the next layer reads."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from macram.spec import RESIDUAL, IntFormat

Int64 = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class ResidualRule:
    """``sum = min(stream + table[branch], 255)``; the next layer's code is how many of ``bounds`` the sum exceeds.

    Attributes:
        branch: format of the branch, unsigned.
        table: int64 ``[2**bits]`` in 0..255, what each code of the branch adds, in steps of the stream.
        bounds: int64 ``[2**bits - 1]`` in 0..255, ascending; 255 is never exceeded.

    Raises:
        ValueError: wrong shapes, entries out of range, or descending bounds.
    """

    branch: IntFormat
    table: Int64
    bounds: Int64

    def __post_init__(self) -> None:
        codes = 1 << self.branch.bits
        if self.branch.signed:
            raise ValueError(f"a residual branch has unsigned codes, not {self.branch}")
        for name, values, length in (("table", self.table, codes), ("bounds", self.bounds, codes - 1)):
            if values.shape != (length,) or not RESIDUAL.holds(values):
                raise ValueError(
                    f"{name} must be {length} numbers in {RESIDUAL.lo}..{RESIDUAL.hi}, not {values.tolist()}"
                )
        if (np.diff(self.bounds) < 0).any():
            raise ValueError(f"bounds must ascend, not {self.bounds.tolist()}")

    @classmethod
    def from_tables(cls, branch: IntFormat, addend: Int64, following: Int64) -> ResidualRule:
        """The rule of a network's tables.

        Args:
            branch: format of the branch.
            addend: what each code of the branch adds; beyond 255 it saturates any stream.
            following: the next layer's code for each of the stream's 256 codes, ascending from 0.

        Raises:
            ValueError: a table that no rule gives.
        """
        steps = np.arange(1, 1 << branch.bits)
        if following.shape != (RESIDUAL.hi + 1,) or following[0] != 0 or (np.diff(following) < 0).any():
            raise ValueError("the next layer's codes must ascend from 0 over the stream's 256 codes")
        if following[-1] > steps[-1]:
            raise ValueError(f"the next layer's codes must be at most {steps[-1]}, not {following[-1]}")
        below = np.searchsorted(following, steps) - 1
        return cls(branch, np.minimum(addend, RESIDUAL.hi), below.astype(np.int64))

    def apply(self, branch: NDArray[np.integer], stream: NDArray[np.integer]) -> tuple[Int64, Int64]:
        """Sums and the next layer's codes, of the shape of ``branch``.

        Raises:
            ValueError: shapes differ, or codes are out of range.
        """
        if branch.shape != stream.shape:
            raise ValueError(f"the stream must be {list(branch.shape)}, not {list(stream.shape)}")
        for name, codes, form in (("branch", branch, self.branch), ("stream", stream, RESIDUAL)):
            if not form.holds(codes):
                raise ValueError(f"{name} must lie in {form.lo}..{form.hi}, not {codes.min()}..{codes.max()}")
        sums = np.minimum(stream + self.table[branch], RESIDUAL.hi)
        return sums, np.searchsorted(self.bounds, sums).astype(np.int64)
