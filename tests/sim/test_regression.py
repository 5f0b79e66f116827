"""The constrained-random regression: every bin met, replayable, and a wrong array noticed."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice

import pytest

from macram_sim import regression
from macram_sim.array import build_array
from macram_sim.build import SimulationError
from macram_sim.coverage import BINS, Observation, score
from macram_sim.regression import ARRAYS, regress
from macram_sim.regression_plan import SCENARIOS, admits, plan
from macram_sim.runner import choose_seed

PORTABLE = ARRAYS[0]
SEED = choose_seed()


def test_a_short_run_meets_every_bin(toolchain):
    counts = []
    result = regress([PORTABLE], seed=SEED, cases=90, progress=counts.append)
    assert result.coverage.missed == [], f"seed {SEED}"
    assert len(result.seen) == 90
    assert {seen.scenario for seen in result.seen} == set(SCENARIOS)
    table = result.to_dict()
    assert table["bins"] == table["bins_met"] == len(result.coverage.hits)
    assert set(result.coverage.hits) | set(result.coverage.impossible) == {b.name for b in BINS}
    assert counts == sorted(counts)


def test_a_failing_case_is_named_with_its_replay(toolchain, monkeypatch):
    """The array has twice the row engines of the one that the driver packs for."""
    model = build_array(PORTABLE)
    monkeypatch.setattr(regression, "build_array", lambda array: model)
    with pytest.raises(
        SimulationError, match=r"(?s)CaseFailure: case 2 \(.*again: .* --seed 5 --only 2"
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
        array.check_admits(case.spec)
    used = {(case.spec.kernel, case.spec.stride) for case in cases}
    assert used == {pair for pair in ((3, 1), (3, 2), (1, 1)) if admits(array, *pair)}


def test_a_bin_that_nothing_met_is_missed():
    table = {
        "layer": [3, 5, 2, 4, 3, 1], "scenario": "plain", "kind": "uniform", "patterns": ["none", "random", "bursty"],
        "scales": [-1, 1], "codes": [0, 6], "sums_at_limit": [False, True], "events": ["one image"],
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
        ({"cases": 0}, "cases must be at least 1, not 0"),
        ({"only": -1}, "the case to run must be 0 or more, not -1"),
    ],
)
def test_bad_arguments(changes, message):
    with pytest.raises(ValueError, match=message):
        regress([PORTABLE], seed=1, **changes)
    with pytest.raises(ValueError, match="the seed must be 0 or more, not -1"):
        next(plan(PORTABLE, -1))
