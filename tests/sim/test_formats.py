"""Arrays of other formats: 8 bits through the multiplying requantiser, signed inputs and outputs."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from macram.golden import random_case, run_layer
from macram.pack import pack_layer
from macram.perf import estimate
from macram.spec import ArrayConfig, ConvSpec, IntFormat
from macram_sim.array import simulate

TINY = ArrayConfig.from_toml(Path(__file__).parents[2] / "configs" / "tiny.toml")
ARRAYS = {
    "8 bits": replace(
        TINY, weight=IntFormat(8, signed=True), input=IntFormat(8), output=IntFormat(8), stream_bits=64
    ),
    "signed": replace(TINY, input=IntFormat(3, signed=True), output=IntFormat(4, signed=True)),
}


@pytest.mark.parametrize("kind", ["uniform", "min", "max", "impulse"])
@pytest.mark.parametrize("name", list(ARRAYS))
def test_codes_and_cycles(toolchain, name, kind):
    array = ARRAYS[name]
    for shape in ((9, 13, 4, 7), (16, 8, 5, 8)):
        spec = ConvSpec(*shape, weight=array.weight, input=array.input, output=array.output)
        case = random_case(spec, seed=6, kind=kind)
        result = simulate(pack_layer(case, array), case.input, seed=6, load="stream")
        np.testing.assert_array_equal(result.codes, run_layer(case))
        expected = estimate(spec, array)
        assert expected.exact
        assert result.counters["cycles"] == expected.total
