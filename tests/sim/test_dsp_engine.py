"""The emitted Verilog of the 3-bit row engines over all 2**21 operand combinations, and a whole array of them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from macram.golden import random_case, run_layer
from macram.pack import pack_layer
from macram.perf import estimate
from macram.spec import ENGINE_LATENCY, ArrayConfig, ConvSpec
from macram_hw.engine import make_engine
from macram_hw.export import component_verilog, model_path
from macram_sim import build, runner
from macram_sim.array import simulate
from macram_sim.build import SimulationError

HERE = Path(__file__).parent
TINY = ArrayConfig.from_toml(HERE.parents[1] / "configs" / "tiny.toml")
WAIVE = """`verilator_config
lint_off -rule WIDTHEXPAND
lint_off -rule WIDTHTRUNC
no_inline -module "macram_engine"
"""


def run_all_operands(kind, folder, edit=lambda text: text):
    config = ArrayConfig(engine=kind)
    (folder / "engine.v").write_text(edit(component_verilog(make_engine(kind, config), "macram_engine")))
    (folder / "waive.vlt").write_text(WAIVE)
    sources = [
        folder / "waive.vlt",
        model_path("DSP48E2.v"),
        folder / "engine.v",
        HERE / "engine_all_operands.v",
    ]
    model = build.build(sources, "engine_all_operands", parameters={"LATENCY": ENGINE_LATENCY[kind]})
    return runner.run(model, "bench_engine", folder / "run", seed=1)


@pytest.mark.parametrize("kind", list(ENGINE_LATENCY))
def test_every_lane_over_all_operands(toolchain, kind, tmp_path):
    assert run_all_operands(kind, tmp_path).tests == 1


def test_without_the_parity_lanes_go_wrong(toolchain, tmp_path):
    """The -4 level is the trap: with the top bit of each field for its borrow, 5,000 lanes would be wrong."""

    def naive(text):
        changed = text
        for k in range(1, 6):
            changed = changed.replace(f"dsp_p[{7 * k}] ^ ", f"dsp_p[{7 * k - 1}] ^ 1'b0 & ")
        assert changed != text
        return changed

    with pytest.raises(SimulationError, match=r"of 2\*\*21 operand combinations give a wrong lane"):
        run_all_operands("dsp48e2", tmp_path, naive)


@pytest.mark.parametrize("kind", ["uniform", "min", "max", "extremes"])
def test_an_array_of_dsp_engines_equals_the_golden_model(toolchain, kind):
    array = replace(TINY, engine="dsp48e2")
    spec = ConvSpec(16, 16, 5, 7)
    case = random_case(spec, seed=4, kind=kind)
    result = simulate(pack_layer(case, array), case.input, seed=4)
    np.testing.assert_array_equal(result.codes, run_layer(case))
    assert result.counters["cycles"] == estimate(spec, array).total
