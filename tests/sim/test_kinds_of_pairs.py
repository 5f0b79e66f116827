"""Every layer kind on an array of double-clocked pairs and a soft row."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest

from macram import perf
from macram.golden import random_case, run_layer
from macram.pack import pack_layer
from macram.spec import ArrayConfig, ConvSpec, IntFormat
from macram_sim.array import simulate

TINY = ArrayConfig.from_toml(Path(__file__).parents[2] / "configs" / "tiny.toml")
ARRAY = dataclasses.replace(
    TINY, name="pairs-and-soft", rows=5, engine="dsp48e2_2x", soft_rows=1, row_words=64, weight_depth=96,
    max_c_in=96,
)  # fmt: skip
SIGNED = IntFormat(3, signed=True)


@pytest.mark.parametrize("traffic", [{}, {"gaps": "random", "stalls": "bursty", "load": "stream"}])
@pytest.mark.parametrize(
    ("spec", "kind"),
    [
        (ConvSpec(11, 9, 7, 9, 3, 2, 1), "uniform"),
        (ConvSpec(13, 17, 6, 8, 1, 1, 0), "extremes"),
        (ConvSpec(10, 8, 5, 12, 3, 1, 1, input=SIGNED), "extremes"),
        (ConvSpec(7, 12, 9, 13, 3, 2, 1, input=SIGNED), "min"),
        (ConvSpec(16, 8, 4, 4, 1, 2, 0, input=SIGNED), "uniform"),
        (ConvSpec(16, 16, 3, 16, 3, 1, 1, input=SIGNED), "max"),
        (ConvSpec(89, 29, 3, 9, 1, 1, 0), "extremes"),
        (ConvSpec(96, 24, 2, 7, 1, 2, 0, input=SIGNED), "uniform"),
    ],
)
def test_codes_and_cycles(toolchain, spec, kind, traffic):
    case = random_case(spec, 22, kind=kind)
    result = simulate(pack_layer(case, ARRAY), case.input, seed=22, **traffic)
    np.testing.assert_array_equal(result.codes, run_layer(case))
    estimate = perf.estimate(spec, ARRAY)
    if estimate.exact and not traffic:
        assert result.counters["cycles"] == estimate.total
