"""1x1 kernels whose output-channel tiles are computed three at a time: codes and cycles."""

from __future__ import annotations

import os
import random
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from test_kinds import run_all

from macram.golden import random_case, run_layer
from macram.pack import pack_passes
from macram.perf import estimate
from macram.spec import ArrayConfig, ConvSpec, IntFormat
from macram_sim.array import simulate

TINY = ArrayConfig.from_toml(Path(__file__).parents[2] / "configs" / "tiny.toml")
DEEP = {"max_c_in": 64, "max_c_out": 64, "weight_depth": 160, "row_words": 160}
ARRAY = replace(TINY, name="triples", **DEEP)
KINDS = [(stride, signed) for stride in (1, 2) for signed in (False, True)]
FILLS = ("uniform", "extremes", "min", "max", "impulse")
# The same in every worker of a parallel run; SEED=... tries others.
SEED = int(os.environ.get("SEED") or 2022)


def random_layers(count, rng):
    """Layers of three tiles and more; some are bound by the drain, some by the engines, some by a stream."""
    layers = []
    while len(layers) < count:
        stride, signed = KINDS[len(layers) % len(KINDS)]
        spec = ConvSpec(
            rng.randint(2 * ARRAY.triple_blocks - 1, ARRAY.max_c_in), rng.randint(17, ARRAY.max_c_out),
            rng.randint(1, 6), rng.choice([rng.randint(1, 20), 1, 4, 8]), 1, stride, 0,
            input=IntFormat(3, signed=signed),
        )  # fmt: skip
        try:
            ARRAY.check_admits(spec)
        except ValueError:
            continue
        assert ARRAY.triples(spec)
        layers.append(spec)
    return layers


def test_codes_and_cycles(toolchain, tmp_path):
    rng = random.Random(SEED)
    layers = random_layers(48, rng)
    cases = [random_case(spec, index, rng.choice(FILLS)) for index, spec in enumerate(layers)]
    codes, counters = run_all(ARRAY, cases, tmp_path)
    left_over, exact, waited = set(), 0, set()
    for case, found, counted in zip(cases, codes, counters, strict=True):
        np.testing.assert_array_equal(found, run_layer(case), err_msg=str(case.spec))
        assert counted["cycles"] == sum(value for key, value in counted.items() if key != "cycles")
        expected = estimate(case.spec, ARRAY)
        stalls = counted["input_stalls"] + counted["output_stalls"]
        measured = (counted["fill_cycles"], counted["mac_cycles"], stalls, counted["drain_cycles"])
        left_over.add(ARRAY.tiles(case.spec.c_out) % 3)
        if expected.exact:
            assert measured == (expected.fill, expected.mac, expected.stall, expected.drain), case.spec
            exact += 1
            waited.add(ARRAY.steps(case.spec) + 1 < ARRAY.pair_drain)
        else:
            assert measured[1] == expected.mac, case.spec
            assert abs(counted["cycles"] - expected.total) <= 4 + 0.2 * expected.total, case.spec
    assert exact >= len(layers) // 3
    assert (left_over, waited) == ({0, 1, 2}, {False, True}), f"SEED={SEED}"


@pytest.mark.parametrize(("gaps", "stalls"), [("random", "bursty"), ("bursty", "random")])
def test_gaps_and_stalls_change_no_code(toolchain, tmp_path, gaps, stalls):
    rng = random.Random(SEED + len(gaps))
    cases = [random_case(spec, index, rng.choice(FILLS)) for index, spec in enumerate(random_layers(12, rng))]
    codes, _ = run_all(ARRAY, cases, tmp_path, gaps=gaps, stalls=stalls)
    for case, found in zip(cases, codes, strict=True):
        np.testing.assert_array_equal(found, run_layer(case), err_msg=str(case.spec))


def test_passes_of_whole_triples(toolchain):
    """More output channels than the memories hold: two passes side by side, both in triples."""
    spec = ConvSpec(56, 75, 2, 6, 1, 1, 0)
    passes = pack_passes(random_case(spec, SEED), ARRAY)
    assert len(passes) > 1
    assert ARRAY.triples(passes[0].spec)
    case = random_case(spec, SEED)
    codes = [simulate(packed, case.input, seed=SEED).codes for packed in passes]
    np.testing.assert_array_equal(np.concatenate(codes), run_layer(case))
