"""The largest image of CA-SpaceNet's layers, 512 x 512, and the smallest, 4 x 4, on one array."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest

from macram.golden import random_case, run_layer
from macram.pack import pack_layer
from macram.perf import estimate
from macram.spec import ArrayConfig, ConvSpec
from macram_sim.array import simulate

TINY = ArrayConfig.from_toml(Path(__file__).parents[2] / "configs" / "tiny.toml")
ARRAY = dataclasses.replace(TINY, name="wide", row_words=256)
"""512 pixels of three or four channels, or pairs of them with stride 2, fill a row of its line buffer."""


@pytest.mark.slow
@pytest.mark.parametrize("shape", [(3, 5, 512, 512), (2, 32, 512, 512, 3, 2, 1), (16, 16, 4, 4)])
def test_codes_and_cycles(toolchain, shape):
    spec = ConvSpec(*shape)
    case = random_case(spec, seed=4)
    result = simulate(pack_layer(case, ARRAY), case.input, seed=4)
    np.testing.assert_array_equal(result.codes, run_layer(case))
    expected = estimate(spec, ARRAY)
    assert expected.exact
    assert result.counters["cycles"] == expected.total
