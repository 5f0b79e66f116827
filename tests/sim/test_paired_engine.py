"""Rows in pairs at twice the clock: the emitted Verilog over all operands, and whole arrays of them."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from macram.golden import random_case, run_layer
from macram.pack import pack_layer
from macram.perf import estimate
from macram.spec import ENGINE_LATENCY, ArrayConfig, ConvSpec
from macram_hw.engine_2x import Interleaver, PairedEngine
from macram_hw.export import component_verilog, model_path
from macram_sim import build, runner
from macram_sim.array import build_array, simulate

HERE = Path(__file__).parent
# Two pairs and a row in LUTs beside them.
ARRAY = replace(
    ArrayConfig.from_toml(HERE.parents[1] / "configs" / "tiny.toml"), engine="dsp48e2_2x", rows=5, soft_rows=1
)
# The same in every worker of a parallel run; SEED=... tries others.
SEED = int(os.environ.get("SEED") or 2022)
WAIVE = """`verilator_config
lint_off -rule WIDTHEXPAND
lint_off -rule WIDTHTRUNC
no_inline -module "macram_interleaver"
no_inline -module "macram_pair"
"""


def test_both_rows_over_all_operands(toolchain, tmp_path):
    config = ArrayConfig(engine="dsp48e2_2x", rows=2)
    (tmp_path / "waive.vlt").write_text(WAIVE)
    (tmp_path / "pair.v").write_text(component_verilog(PairedEngine(config, 1), "macram_pair"))
    (tmp_path / "interleaver.v").write_text(component_verilog(Interleaver(config), "macram_interleaver"))
    sources = [
        tmp_path / "waive.vlt",
        model_path("DSP48E2.v"),
        tmp_path / "interleaver.v",
        tmp_path / "pair.v",
        HERE / "pair_all_operands.sv",
    ]
    model = build.build(sources, "pair_all_operands", parameters={"LATENCY": ENGINE_LATENCY["dsp48e2_2x"]})
    assert runner.run(model, "bench_pair", tmp_path / "run", seed=1).tests == 1


@pytest.mark.parametrize(
    ("shape", "kind", "traffic"),
    [
        ((16, 16, 5, 7), "min", {}),
        ((9, 15, 4, 8), "extremes", {}),
        (
            (16, 13, 5, 9),
            "uniform",
            {"gaps": "bursty", "stalls": "random", "snoop": True, "random_init": True},
        ),
        ((7, 32, 6, 4), "uniform", {"gaps": "random", "stalls": "bursty", "load": "stream"}),
    ],
)
def test_an_array_of_pairs_equals_the_golden_model(toolchain, shape, kind, traffic):
    spec = ConvSpec(*shape)
    case = random_case(spec, SEED, kind=kind)
    result = simulate(pack_layer(case, ARRAY), case.input, seed=SEED, runs=2, **traffic)
    for codes in result.all_codes:
        np.testing.assert_array_equal(codes, run_layer(case))
    if not traffic:
        assert [counters["cycles"] for counters in result.all_counters] == 2 * [estimate(spec, ARRAY).total]


def test_refusals_and_recoveries_on_two_clocks(toolchain, tmp_path):
    case = random_case(ConvSpec(5, 9, 6, 7), SEED)
    pack_layer(case, ARRAY).write(tmp_path / "packed")
    np.save(tmp_path / "input.npy", case.input)
    np.save(tmp_path / "expected.npy", run_layer(case))
    done = runner.run(
        build_array(ARRAY), "bench_recovery", tmp_path / "run", seed=SEED, env={"MACRAM_JOB": str(tmp_path)}
    )
    assert done.tests == 9
