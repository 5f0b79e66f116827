"""Bias, shift and clamp alone in the simulated array, with thresholds and with the multiplying requantiser."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from macram.golden import accumulate, bias_and_shift, random_case
from macram.pack import pack_layer
from macram.spec import ArrayConfig, ConvSpec, IntFormat
from macram_sim.array import simulate
from macram_sim.runner import choose_seed

TINY = ArrayConfig.from_toml(Path(__file__).parents[2] / "configs" / "tiny.toml")
ARRAYS = {
    "thresholds": TINY,
    "multiplier": replace(
        TINY, weight=IntFormat(8, signed=True), input=IntFormat(8), output=IntFormat(8), stream_bits=64
    ),
}
"""The second as in test_formats.py, so that both use one build."""
SEED = choose_seed()


@pytest.mark.parametrize("name", list(ARRAYS))
def test_codes_are_the_shifted_sums(toolchain, name):
    array = ARRAYS[name]
    spec = ConvSpec(9, 13, 4, 7, weight=array.weight, input=array.input, output=array.output)
    case = random_case(spec, SEED)
    acc = accumulate(case)
    shift = int(abs(acc).max()).bit_length() - array.output.bits
    bias = np.random.default_rng(SEED).integers(0, (array.output.hi + 1) << shift, spec.c_out)
    scale, offset = bias_and_shift(bias, shift)
    result = simulate(pack_layer(replace(case, scale=scale, offset=offset), array), case.input, seed=SEED)
    wanted = np.clip((acc + bias[:, None, None]) >> shift, array.output.lo, array.output.hi)
    assert len(np.unique(wanted)) > array.output.hi // 2, "the codes must spread"
    np.testing.assert_array_equal(result.codes, wanted)
