"""Signed input codes on an array of unsigned inputs: what raising them by half their range adds to a sum.

The array takes code ``x`` as ``x + half``, and so the padding, which is 0, as ``half``. Every accumulator of
channel c then holds ``acc + half * sum(weights[c])``, which the requantiser's parameters take up. Two columns lack
a part of it: no step reads padding left of column 0, or right of the last column where a group ends there. The
part is the same for the whole column, and the requantiser adds it as the channel's border terms.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from macram.spec import GROUP, TAPS, ArrayConfig, ConvSpec


@dataclass(frozen=True, eq=False)
class Rise:
    """What raised input codes add per channel, int64 ``[c_out]`` each; zeros where codes go in as they are.

    Attributes:
        total: to every complete sum.
        left: the part of it that column 0 lacks.
        right: the part of it that the last column lacks.
    """

    total: NDArray[np.int64]
    left: NDArray[np.int64]
    right: NDArray[np.int64]

    @classmethod
    def of(cls, weights: NDArray[np.int64], spec: ConvSpec, array: ArrayConfig) -> Rise:
        """For codes ``[c_out, c_in, kernel, kernel]`` of a layer on ``array``."""
        half = 1 << (spec.input.bits - 1) if array.biased(spec) else 0
        total = half * weights.sum(axis=(1, 2, 3))
        none = np.zeros_like(total)
        if spec.kernel != TAPS:
            return cls(total, none, none)
        # With stride 2 the last column's right neighbour is in its own group, or masked and so raised.
        at_group_end = spec.stride == 1 and spec.out_width % GROUP == 0
        return cls(
            total,
            half * weights[..., 0].sum(axis=(1, 2)),
            half * weights[..., TAPS - 1].sum(axis=(1, 2)) if at_group_end else none,
        )
