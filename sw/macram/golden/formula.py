"""The float formula that defines every output code, and the accumulators at which it steps.

``code = clip(rint(scale * acc + offset), lo, hi)`` in float64: one rounded product, one rounded sum (never
a fused multiply-add), half to even. Each of these operations is monotone, so the code of a channel is a
monotone staircase over ``acc``, described in full by the accumulators at which it steps.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from macram.spec import IntFormat
from macram.spec.fixed import OFFSET_BITS

OFFSET = IntFormat(OFFSET_BITS, signed=True)
Int64 = NDArray[np.int64]
Float64 = NDArray[np.float64]


def float_code(acc: NDArray[np.integer], scale: Float64, offset: Float64, output: IntFormat) -> Int64:
    """The defining formula; the arguments broadcast, ``|acc|`` must be below ``2**53``."""
    with np.errstate(over="ignore"):
        return np.clip(np.rint(scale * acc.astype(np.float64) + offset), output.lo, output.hi).astype(
            np.int64
        )


def bias_and_shift(bias: NDArray[np.integer], shift: int) -> tuple[Float64, Float64]:
    """Scale and offset of a requantisation without a multiplier, ``clip((acc + bias) >> shift, lo, hi)``.

    The formula never meets a tie with them, so its rounding is that shift's floor, exactly.

    Args:
        bias: integers ``[c_out]`` of up to 48 bits; with ``2**(shift - 1)`` in it the shift rounds half up.
        shift: 0 to 47, the same for all channels.

    Returns:
        float64 ``[c_out]`` each, for `macram.layer_file.LayerCase`.

    Raises:
        ValueError: the bias is not of integers or too large, or the shift is out of range.
    """
    bias = np.asarray(bias)
    if not np.issubdtype(bias.dtype, np.integer) or not OFFSET.holds(bias):
        raise ValueError(
            f"bias must be integers of up to {OFFSET_BITS} bits; give it in units of the accumulator"
        )
    if not 0 <= shift < OFFSET_BITS:
        raise ValueError(f"shift must be in 0..{OFFSET_BITS - 1}, not {shift}")
    scale = np.full(bias.shape, 2.0**-shift, np.float64)
    return scale, (bias.astype(np.float64) + 0.5) * scale - 0.5


def first_true(
    predicate: Callable[[Int64], NDArray[np.bool_]], shape: tuple[int, ...], reach: tuple[int, int]
) -> Int64:
    """Smallest ``acc`` in ``reach`` for which each element of a monotone predicate holds, by bisection.

    Args:
        predicate: elementwise over an int64 array of ``shape``; never turns from true to false as acc grows.
        shape: shape of the searches that run at once.
        reach: smallest and largest accumulator, both included.

    Returns:
        int64 of ``shape``; ``reach[1] + 1`` where the predicate holds nowhere.
    """
    left = np.full(shape, reach[0], np.int64)
    right = np.full(shape, reach[1] + 1, np.int64)
    while (open_ := left < right).any():
        # A finished search may stand at reach[1] + 1: it is evaluated there and ignored.
        middle = (left + right) >> 1
        holds = predicate(middle)
        right = np.where(open_ & holds, middle, right)
        left = np.where(open_ & ~holds, middle + 1, left)
    return left


def staircase(
    scale: Float64, offset: Float64, output: IntFormat, reach: tuple[int, int]
) -> tuple[Int64, NDArray[np.bool_]]:
    """Every step of the float formula over the reachable accumulators, exactly.

    Args:
        scale: ``[channels]``.
        offset: ``[channels]``.
        output: format of the codes.
        reach: smallest and largest reachable accumulator.

    Returns:
        ``steps`` int64 ``[channels, 2**bits - 1]``, ascending, in ``reach[0]..reach[1] + 1``, and ``falling``
        bool ``[channels]``. With n steps at or below acc the code is ``lo + n``, or ``hi - n`` if falling.
    """
    falling = scale < 0
    index = np.arange((1 << output.bits) - 1, dtype=np.int64)
    rising_to, falling_to = output.lo + 1 + index, output.hi - 1 - index
    m, b, down = scale[:, None], offset[:, None], falling[:, None]

    def stepped(acc: Int64) -> NDArray[np.bool_]:
        code = float_code(acc, m, b, output)
        return np.where(down, code <= falling_to, code >= rising_to)

    return first_true(stepped, (len(scale), len(index)), reach), falling
