"""Undisturbed runs take exactly the closed form's cycles, cause by cause."""

from __future__ import annotations

import dataclasses
import os
import random
from pathlib import Path

import numpy as np
import pytest

from macram.golden import random_case, run_layer
from macram.pack import pack_layer
from macram.perf import estimate
from macram.spec import ArrayConfig, ConvSpec
from macram_sim.array import simulate

CONFIGS = Path(__file__).parents[2] / "configs"
TINY = ArrayConfig.from_toml(CONFIGS / "tiny.toml")

# Channels in and out, height, width: one pixel, one group, narrow, full last group, drain-bound, many tiles.
SHAPES = [
    (1, 1, 1, 1),
    (3, 11, 1, 1),
    (1, 1, 2, 2),
    (2, 8, 5, 5),
    (7, 9, 6, 3),
    (4, 8, 4, 8),
    (4, 8, 9, 12),
    (5, 16, 4, 16),
    (16, 16, 3, 7),
    (10, 30, 5, 8),
    (12, 17, 2, 19),
    (1, 1, 2, 12),
    (1, 5, 4, 20),
    (2, 4, 4, 9),
]
# The same in every worker of a parallel run; SEED=... tries others.
RANDOM = random.Random(int(os.environ.get("SEED") or 2022))
SHAPES += [
    (RANDOM.randint(1, 16), RANDOM.randint(1, 16), RANDOM.randint(1, 7), RANDOM.randint(1, 16))
    for _ in range(8)
]


def assert_as_estimated(spec, array, counters):
    expected = estimate(spec, array)
    assert expected.exact
    stalls = counters["input_stalls"] + counters["output_stalls"]
    measured = (counters["fill_cycles"], counters["mac_cycles"], stalls, counters["drain_cycles"])
    assert measured == (expected.fill, expected.mac, expected.stall, expected.drain)
    assert counters["cycles"] == expected.total


@pytest.mark.parametrize("shape", SHAPES, ids=lambda shape: "x".join(map(str, shape)))
def test_cycles_are_the_closed_form(toolchain, shape):
    spec = ConvSpec(*shape)
    case = random_case(spec, seed=3)
    result = simulate(pack_layer(case, TINY), case.input, seed=3, runs=2)
    for codes, counters in zip(result.all_codes, result.all_counters, strict=True):
        np.testing.assert_array_equal(codes, run_layer(case))
        assert_as_estimated(spec, TINY, counters)


@pytest.mark.parametrize(
    ("rows", "engine", "soft_rows"),
    [
        (3, "soft", 0),
        (6, "dsp48e2", 1),
        pytest.param(5, "portable", 2, marks=pytest.mark.slow),
    ],
)
def test_any_number_of_rows_of_any_kinds(toolchain, rows, engine, soft_rows):
    """Row counts that are no power of two, mixed kinds; a part block, one whole block and many, extreme codes."""
    array = dataclasses.replace(
        TINY, rows=rows, engine=engine, soft_rows=soft_rows, max_c_in=3 * rows + 1, row_words=64
    )
    for channels, kind in ((2, "uniform"), (rows, "min"), (rows, "max"), (3 * rows + 1, "extremes")):
        spec = ConvSpec(channels, 11, 4, 12)
        case = random_case(spec, seed=rows, kind=kind)
        result = simulate(pack_layer(case, array), case.input, seed=rows)
        np.testing.assert_array_equal(result.codes, run_layer(case))
        assert_as_estimated(spec, array, result.counters)
