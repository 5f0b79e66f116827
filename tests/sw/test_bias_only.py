"""Requantisation by bias, shift and clamp alone: the general path gives exactly that."""

from __future__ import annotations

import numpy as np
import pytest

from macram.golden import bias_and_shift, derive_requant
from macram.spec import ConvSpec, IntFormat, accumulator_range

FORMATS = [IntFormat(bits, signed=signed) for bits in range(2, 9) for signed in (False, True)]


@pytest.mark.parametrize("shift", [0, 1, 2, 5, 11])
@pytest.mark.parametrize("output", FORMATS, ids=str)
def test_every_reachable_accumulator_is_shifted_and_clamped(output, shift):
    lo, hi = accumulator_range(IntFormat(3, signed=True), IntFormat(3), 9 * 7)
    bias = np.array([0, 1, -1, 1 << shift >> 1, 37, -1000, lo, hi, -(1 << 20), 1 << 20])
    spec = ConvSpec(7, len(bias), 4, 4, output=output)
    requant = derive_requant(spec, *bias_and_shift(bias, shift))
    acc = np.broadcast_to(np.arange(lo, hi + 1), (len(bias), hi - lo + 1))
    wanted = np.clip((acc + bias[:, None]) >> shift, output.lo, output.hi)
    np.testing.assert_array_equal(requant.apply(acc), wanted)


@pytest.mark.parametrize("bits", [3, 8])
def test_a_bias_far_beyond_the_sums_is_a_constant(bits):
    spec = ConvSpec(1, 2, 4, 4, output=IntFormat(bits))
    scale, offset = bias_and_shift(np.array([-(1 << 47), (1 << 47) - 1]), 0)
    codes = derive_requant(spec, scale, offset).apply(np.array([[-5, 5], [-5, 5]]))
    assert codes.tolist() == [[0, 0], [spec.output.hi] * 2]


@pytest.mark.parametrize(
    ("bias", "shift", "message"),
    [
        ([0.5], 3, "bias must be integers of up to 48 bits; give it in units of the accumulator"),
        ([1 << 47], 3, "bias must be integers of up to 48 bits"),
        ([0], -1, r"shift must be in 0\.\.47, not -1"),
        ([0], 48, r"shift must be in 0\.\.47, not 48"),
    ],
)
def test_bad_parameters_are_named(bias, shift, message):
    with pytest.raises(ValueError, match=message):
        bias_and_shift(np.array(bias), shift)
