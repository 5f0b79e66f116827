"""The residual adder in the simulated array: codes and sums equal the golden rule, with every stream stalling."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from macram import golden, perf
from macram.golden import ResidualRule
from macram.pack import pack_layer
from macram.spec import ArrayConfig, ConvSpec
from macram_sim.array import simulate
from macram_sim.runner import choose_seed

ARRAY = ArrayConfig.from_toml(Path(__file__).parents[2] / "configs" / "tiny-residual.toml")
SEED = choose_seed()


def random_residual(spec, seed):
    rng = np.random.default_rng(seed)
    table = np.sort(rng.integers(0, 256, 1 << spec.output.bits))
    bounds = np.sort(rng.integers(0, 256, (1 << spec.output.bits) - 1))
    stream = rng.integers(0, 256, (spec.c_out, spec.out_height, spec.out_width))
    return ResidualRule(spec.output, table, bounds), stream


@pytest.mark.parametrize(
    ("shape", "traffic"),
    [
        ((1, 1, 1, 1), {}),
        ((3, 9, 5, 7), {"gaps": "random", "stalls": "random"}),
        ((8, 31, 4, 8), {"gaps": "bursty", "stalls": "bursty", "snoop": True}),
        ((5, 32, 9, 4), {"load": "stream", "random_init": True}),
    ],
)
def test_sums_and_next_codes(toolchain, shape, traffic):
    case = golden.random_case(ConvSpec(*shape), SEED)
    rule, stream = random_residual(case.spec, SEED)
    sums, codes = rule.apply(golden.run_layer(case), stream)
    result = simulate(
        pack_layer(case, ARRAY), case.input, residual=(rule, stream), seed=SEED, runs=2, **traffic
    )
    for run in result.all_codes:
        np.testing.assert_array_equal(run, codes)
    np.testing.assert_array_equal(result.sums, sums)
    for counters in result.all_counters:
        assert counters["cycles"] == sum(value for name, value in counters.items() if name != "cycles")


@pytest.mark.parametrize("shape", [(16, 8, 6, 8), (16, 9, 5, 6), (2, 32, 3, 7), (7, 31, 2, 1)])
@pytest.mark.parametrize("used", [False, True])
def test_cycles(toolchain, shape, used):
    """The adder costs its latency once; its streams are a limit like the others."""
    case = golden.random_case(ConvSpec(*shape), SEED)
    residual = random_residual(case.spec, SEED) if used else None
    result = simulate(pack_layer(case, ARRAY), case.input, residual=residual, seed=SEED)
    estimate = perf.estimate(case.spec, ARRAY, residual=used)
    if estimate.exact:
        assert result.counters["cycles"] == estimate.total
    else:
        assert abs(result.counters["cycles"] / estimate.total - 1) < 0.05
