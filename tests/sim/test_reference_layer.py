"""The reference layer at full size on `paper` and `zu3eg`; `macram sim` runs it on `reference`."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from macram.golden import random_case, run_layer
from macram.pack import pack_layer
from macram.perf import estimate
from macram.spec import ArrayConfig, ConvSpec
from macram_sim.array import simulate

CONFIGS = Path(__file__).parents[2] / "configs"


@pytest.mark.slow
@pytest.mark.parametrize(("name", "cycles"), [("paper", 271_200), ("zu3eg", 148_057)])
def test_codes_and_cycles(toolchain, name, cycles):
    """At most 272,000 and 165,000 cycles, 2.72 and 1.65 ms at 100 MHz; the paper's array takes 5.99 ms."""
    spec, array = ConvSpec(64, 128, 128, 128), ArrayConfig.from_toml(CONFIGS / f"{name}.toml")
    case = random_case(spec, seed=3)
    result = simulate(pack_layer(case, array), case.input, seed=3)
    np.testing.assert_array_equal(result.codes, run_layer(case))
    assert result.counters["cycles"] == cycles == estimate(spec, array).total
