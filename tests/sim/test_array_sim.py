"""The exported array in Verilator against the golden model, code by code, and its refusals and recoveries."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest

from macram import golden
from macram.pack import pack_layer
from macram.spec import ArrayConfig, ConvSpec
from macram_sim import runner
from macram_sim.array import build_array, simulate
from macram_sim.runner import choose_seed

TINY = ArrayConfig.from_toml(Path(__file__).parents[2] / "configs" / "tiny.toml")
SEED = choose_seed()


@pytest.mark.parametrize(
    ("shape", "traffic"),
    [
        ((1, 1, 1, 1), {}),
        ((3, 9, 5, 7), {"load": "stream"}),
        ((16, 15, 2, 13), {"gaps": "bursty", "stalls": "random", "snoop": True}),
        ((5, 32, 9, 4), {"gaps": "random", "stalls": "bursty", "random_init": True, "load": "stream"}),
    ],
)
def test_codes_equal_the_golden_model(toolchain, shape, traffic):
    case = golden.random_case(ConvSpec(*shape), SEED)
    result = simulate(pack_layer(case, TINY), case.input, seed=SEED, runs=2, **traffic)
    expected = golden.run_layer(case)
    for codes in result.all_codes:
        np.testing.assert_array_equal(codes, expected)
    for counters in result.all_counters:
        assert counters["cycles"] == sum(value for name, value in counters.items() if name != "cycles")
    if traffic.get("snoop"):
        assert result.register_reads > 10


def test_one_flipped_weight_bit_is_seen(toolchain):
    case = golden.random_case(ConvSpec(4, 8, 6, 6), SEED)
    packed = pack_layer(case, TINY)
    weights = packed.weights.copy()
    weights[3, 1, 0] ^= 1
    result = simulate(dataclasses.replace(packed, weights=weights), case.input, seed=SEED)
    differs = (result.codes != golden.run_layer(case)).any(axis=(1, 2))
    assert set(np.flatnonzero(differs)) <= {3}
    changed = dataclasses.replace(case, weights=_flipped(case.weights))
    np.testing.assert_array_equal(result.codes, golden.run_layer(changed))
    assert differs.any() or np.array_equal(golden.run_layer(changed), golden.run_layer(case))


def _flipped(weights):
    """Bit 0 of word 1 of unit 3: channel 3, input channel 2 (engine 0 of block 1), kernel row 0, last tap."""
    weights = weights.copy()
    weights[3, 2, 0, 2] = ((weights[3, 2, 0, 2] & 7 ^ 1) ^ 4) - 4
    return weights


def test_refusals_and_recoveries(toolchain, tmp_path):
    case = golden.random_case(ConvSpec(5, 9, 6, 7), SEED)
    pack_layer(case, TINY).write(tmp_path / "packed")
    np.save(tmp_path / "input.npy", case.input)
    np.save(tmp_path / "expected.npy", golden.run_layer(case))
    done = runner.run(
        build_array(TINY), "bench_recovery", tmp_path / "run", seed=SEED, env={"MACRAM_JOB": str(tmp_path)}
    )
    assert done.tests == 9


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"gaps": "often"}, "gaps must be one of none, random, bursty, not 'often'"),
        ({"load": "tape"}, "load must be one of file, stream, not 'tape'"),
        ({"runs": 0}, "runs must be at least 1, not 0"),
        ({"input_codes": np.zeros((2, 3, 4), int)}, r"integers \[2, 3, 3\], not int64 \[2, 3, 4\]"),
        ({"input_codes": np.zeros((2, 3, 3))}, "not float64"),
        ({"input_codes": np.full((2, 3, 3), 8)}, r"must lie in 0\.\.7, not 8\.\.8"),
    ],
)
def test_bad_arguments(changes, message):
    case = golden.random_case(ConvSpec(2, 3, 3, 3), SEED)
    with pytest.raises(ValueError, match=message):
        simulate(**{"packed": pack_layer(case, TINY), "input_codes": case.input, **changes})
