"""The constrained-random regression: every bin met, replayable, and a wrong array noticed."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice
from pathlib import Path

import numpy as np
import pytest

from macram.cli import main
from macram.golden import run_layer
from macram.spec import ArrayConfig, ConvSpec, IntFormat, layer_passes
from macram_sim.array import build_array
from macram_sim.build import SimulationError
from macram_sim.regression import ARRAYS, regress, run
from macram_sim.regression.coverage import BINS, score
from macram_sim.regression.layer import LayerRun, draw_layer
from macram_sim.regression.observation import Observation
from macram_sim.regression.plan import KERNELS, Case, Traffic, admits, plan
from macram_sim.regression.scenarios import SCENARIOS as PERFORMED
from macram_sim.regression.settings import BLOCKS, SCENARIOS, blocks_of
from macram_sim.runner import choose_seed

PORTABLE = ARRAYS[0]
BLOCKED = replace(
    ArrayConfig.from_toml(Path(__file__).parents[2] / "configs" / "tiny-blocks.toml"), residual_stream_bits=64
)
"""Residual and partial sums. Other tests simulate it too, so here it is found built; and so is the next."""
PAIRS = replace(
    PORTABLE,
    name="pairs",
    engine="dsp48e2_2x",
    rows=5,
    soft_rows=1,
    row_words=64,
    weight_depth=96,
    max_c_in=96,
)
SEED = choose_seed()


@pytest.mark.parametrize("array", [PORTABLE, BLOCKED], ids=["portable", "blocks and residual"])
def test_a_short_run_meets_every_bin(toolchain, array):
    counts = []
    result = regress([array], seed=SEED, cases=90, progress=counts.append)
    # The shapes of a block are the array's choice: on an array of blocks, what others do not have must be met.
    known = {b.name for b in BINS if b.possible(PORTABLE)} if array is BLOCKED else set()
    assert [name for name in result.coverage.missed if name not in known] == [], f"seed {SEED}"
    assert len(result.seen) == 90
    assert {seen.scenario for seen in result.seen} == {
        name for name, setting in SCENARIOS.items() if setting.possible(array)
    }
    table = result.to_dict()
    assert table["bins"] == len(result.coverage.hits) == table["bins_met"] + len(table["missed"])
    assert set(result.coverage.hits) | set(result.coverage.impossible) == {b.name for b in BINS}
    assert table["cpu_seconds"] > 0
    assert counts == sorted(counts)


def test_an_array_of_two_clocks_and_two_kinds_of_engines(toolchain):
    assert len(regress([PAIRS], seed=SEED, cases=20).seen) == 20


def test_a_failing_case_is_named_with_its_replay(toolchain, monkeypatch):
    """The array has twice the row engines of the one that the driver packs for."""
    model = build_array(PORTABLE)
    monkeypatch.setattr(run, "build_array", lambda array: model)
    with pytest.raises(
        SimulationError,
        match=r"(?s)CaseFailure: case 2 \(.*again: macram verify regression --seed 5 --only 2",
    ) as caught:
        regress([replace(PORTABLE, rows=1)], seed=5, only=2)
    assert "\n  log: " in str(caught.value)


@pytest.mark.parametrize("array", ARRAYS, ids=lambda array: array.name)
def test_the_plan_depends_on_the_seed_alone(array):
    cases = list(islice(plan(array, 3), 200))
    assert cases[:50] == list(islice(plan(array, 3), 50))
    assert cases != list(islice(plan(array, 4), 200))
    assert [case.index for case in cases] == list(range(200))
    for case in cases:
        ends = {(part.sums_in, part.sums_out) for part in layer_passes(case.spec, array)}
        assert BLOCKS[case.block] in ends
        assert len(ends) == 1 or case.block != "whole"
    used = {(case.spec.kernel, case.spec.stride) for case in cases}
    assert used == {pair for pair in KERNELS if admits(array, *pair)}
    assert {case.spec.input.signed for case in cases} == {array.input.signed, True}
    assert {case.block for case in cases} == set(blocks_of(array))
    assert {case.residual for case in cases} == {False, bool(array.residual_stream_bits)}
    assert {case.scenario for case in cases} == {
        name for name, setting in SCENARIOS.items() if setting.possible(array)
    }


@pytest.mark.parametrize(
    ("c_in", "blocks"),
    [(16, {"whole"}), (17, {"whole", "first", "last"}), (32, {"whole", "first", "last"}), (33, set(BLOCKS))],
)
def test_an_array_has_the_blocks_that_its_sums_allow(c_in, blocks):
    array = replace(BLOCKED, partial_sum_c_in=c_in)
    assert {case.block for case in islice(plan(array, SEED), 80)} == blocks


def test_every_scenario_is_performed_and_every_bin_possible_on_some_array():
    assert set(PERFORMED) == set(SCENARIOS)
    assert all(any(setting.possible(array) for array in ARRAYS) for setting in SCENARIOS.values())
    assert [b.name for b in BINS if not any(b.possible(array) for array in ARRAYS)] == []


@pytest.mark.parametrize("width", [1, 3, 4, 5])
@pytest.mark.parametrize(("kernel", "stride"), KERNELS)
def test_sums_of_raised_codes(kernel, stride, width):
    """As the array has them they are those of the raised image, padded as much as the array reads."""
    spec = ConvSpec(40, 3, 4, width, kernel, stride, kernel // 2, input=IntFormat(3, signed=True))
    case = Case(
        0, "plain", spec, "last", False, False, False, "uniform", Traffic(*["none"] * 5), 0.5, SEED % 1000
    )
    given = LayerRun.of(draw_layer(case), case, BLOCKED)
    columns = width + kernel // 2 * 2
    image = np.zeros((40, 4 + kernel // 2 * 2, columns), np.int64)
    inner = slice(kernel // 2, columns - kernel // 2)
    image[:, :, inner] = 4
    if kernel == 3 and not (stride == 1 and width % 4 == 0):
        image[:, :, -1] = 4
    image[:, kernel // 2 : kernel // 2 + 4, inner] += given.layer.input
    before = given.part.c_in.start
    wanted = np.zeros(given.addends.shape, np.int64)
    for y, x in np.ndindex(wanted.shape[1:]):
        window = image[:before, y * stride : y * stride + kernel, x * stride : x * stride + kernel]
        wanted[:, y, x] = np.tensordot(given.layer.weights[:, :before], window, 3)
    np.testing.assert_array_equal(given.addends, wanted)
    np.testing.assert_array_equal(given.wanted["output"], run_layer(given.layer))


def test_bias_alone_leaves_scales_of_one():
    for case in islice(plan(PORTABLE, SEED), 12):
        layer = draw_layer(case)
        assert (layer.scale == 1).all() == case.bias_alone
        assert case.bias_alone or (layer.scale != 1).any()


def test_a_bin_that_nothing_met_is_missed():
    table = {
        "layer": [3, 5, 2, 4, 3, 1], "input": "u3", "block": "whole", "whole_c_in": 3, "at_top": False,
        "scenario": "plain", "kind": "uniform", "scales": [-1, 1], "bias_alone": False, "codes": [0, 6],
        "patterns": {"image": "none", "params": "random", "output": "bursty"},
        "sums_at_limit": [False, True], "residual_sums": None, "next_codes": None, "events": ["one image"],
        "counters": [{"input_stalls": 3, "output_stalls": 0, "drain_cycles": 1, "fill_cycles": 1}],
    }  # fmt: skip
    result = score([PORTABLE], [Observation.from_dict(PORTABLE, table)])
    met = {name for name, count in result.hits.items() if count}
    assert {"width mod 4 = 0", "height 2", "codes: uniform", "INPUT_STALLS counted", "one image"} <= met
    assert {"input gaps none, output stalls bursty", "parameter gaps random", "a negative scale"} <= met
    assert (
        not {"width 1", "highest output code", "a zero scale", "no stall at all", "smallest sum of the layer"}
        & met
    )
    assert set(result.missed) == set(result.hits) - met
    assert result.share == pytest.approx(len(met) / len(result.hits))


def test_every_bin_has_a_reason_and_a_name_of_its_own():
    assert len({b.name for b in BINS}) == len(BINS)
    assert all(b.reason for b in BINS)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"seed": 1, "cases": 0}, "cases must be at least 1, not 0"),
        ({"seed": 1, "only": -1}, "the case to run must be at least 0, not -1"),
        ({"seed": -1}, "the seed must be at least 0, not -1"),
    ],
)
def test_bad_arguments(changes, message):
    with pytest.raises(ValueError, match=message):
        regress([PORTABLE], **changes)


def test_no_cases_are_refused_before_anything_is_shown(capsys):
    assert main(["verify", "regression", "--cases", "0"]) != 0
    shown = capsys.readouterr()
    assert shown.out == ""
    assert shown.err == "macram: error: cases must be at least 1, not 0\n"
