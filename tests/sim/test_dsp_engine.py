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

HERE = Path(__file__).parent
TINY = ArrayConfig.from_toml(HERE.parents[1] / "configs" / "tiny.toml")
WAIVE = """`verilator_config
lint_off -rule WIDTHEXPAND
lint_off -rule WIDTHTRUNC
no_inline -module "macram_engine"
"""


@pytest.mark.parametrize("kind", ["dsp48e2", "soft"])
def test_every_lane_over_all_operands(toolchain, tmp_path, kind):
    engine = make_engine(kind, ArrayConfig(engine=kind))
    (tmp_path / "engine.v").write_text(component_verilog(engine, "macram_engine"))
    (tmp_path / "waive.vlt").write_text(WAIVE)
    by_hand = ["DSP48E2.v"] if kind == "dsp48e2" else ["macram_add3.v", "macram_product.v"]
    sources = [
        tmp_path / "waive.vlt",
        *map(model_path, by_hand),
        tmp_path / "engine.v",
        HERE / "engine_all_operands.v",
    ]
    model = build.build(sources, "engine_all_operands", parameters={"LATENCY": ENGINE_LATENCY[kind]})
    assert runner.run(model, "bench_engine", tmp_path / "run", seed=1).tests == 1


def test_the_parity_is_what_makes_minus_four_exact():
    """All 2**21 operands in NumPy: exact with a parity for the two wide lanes; with top bits only, 5,000 are not."""
    index = np.arange(1 << 21)
    pixels = [(index >> 3 * i & 7) for i in range(4)]
    taps = [((index >> 12 + 3 * j & 7) ^ 4) - 4 for j in range(3)]
    product = sum(a << 7 * i for i, a in enumerate(pixels)) * sum(w << 7 * j for j, w in enumerate(taps))
    lanes = [sum(pixels[k - j] * taps[j] for j in range(3) if 0 <= k - j < 4) for k in range(6)]
    fields = [product >> 7 * k & 127 for k in range(6)]
    above = [product >> 7 * (k + 1) & 1 for k in range(6)]
    by_top_bit = [field >> 6 for field in fields]
    by_parity = [above[k] ^ lanes[k + 1] & 1 if k in (2, 3) else by_top_bit[k] for k in range(6)]
    wrong = [
        sum(
            int(np.count_nonzero(fields[k] - 128 * borrow[k] + (borrow[k - 1] if k else 0) != lanes[k]))
            for k in range(6)
        )
        for borrow in (by_parity, by_top_bit)
    ]
    assert wrong == [0, 5000]


@pytest.mark.parametrize("kind", ["uniform", "min", "max", "extremes"])
def test_an_array_of_dsp_engines_equals_the_golden_model(toolchain, kind):
    array = replace(TINY, engine="dsp48e2")
    spec = ConvSpec(16, 16, 5, 7)
    case = random_case(spec, seed=4, kind=kind)
    result = simulate(pack_layer(case, array), case.input, seed=4)
    np.testing.assert_array_equal(result.codes, run_layer(case))
    assert result.counters["cycles"] == estimate(spec, array).total
