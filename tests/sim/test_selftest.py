"""The self-test passes on the array it was made for, and fails if one bit or one cycle is not as planned."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from macram.spec import ArrayConfig
from macram.synth.plan import make_plan
from macram_hw.export import component_verilog, export_verilog
from macram_hw.selftest import SelfTest
from macram_sim import build, runner

TINY = ArrayConfig.from_toml(Path(__file__).parents[2] / "configs" / "tiny.toml")

# The generator writes constants as narrow as they come.
WAIVE = """`verilator_config
lint_off -rule WIDTHEXPAND -file "*selftest.v"
lint_off -rule WIDTHTRUNC -file "*selftest.v"
lint_off -rule CASEINCOMPLETE -file "*selftest.v"
"""


def verdict(tmp_path, plan, packed, wanted, *, flip=False, patience=1):
    packed.write(tmp_path / "mem")
    if flip:
        memory = tmp_path / "mem" / "unit_000.mem"
        lines = memory.read_text().splitlines()
        first = next(i for i, line in enumerate(lines) if not line.startswith("//"))
        lines[first] = f"{int(lines[first], 16) ^ 1:0{len(lines[first])}x}"
        memory.write_text("\n".join(lines) + "\n")
    exported = export_verilog(TINY, tmp_path / "rtl")
    (tmp_path / "rtl" / "selftest.v").write_text(component_verilog(SelfTest(TINY, plan), "macram_selftest"))
    (tmp_path / "rtl" / "waive.vlt").write_text(WAIVE)
    sources = [tmp_path / "rtl" / "waive.vlt", *exported.sources, tmp_path / "rtl" / "selftest.v"]
    model = build.build(sources, "macram_selftest")
    runner.run(
        model,
        "bench_selftest",
        tmp_path / "run",
        seed=1,
        env={
            "SELFTEST_CYCLES": str(plan.cycles),
            "SELFTEST_VERDICT": wanted,
            "SELFTEST_PATIENCE": str(patience),
        },
        files=sorted((tmp_path / "mem").glob("*.mem")),
    )


def test_it_passes_as_planned_and_sees_one_flipped_weight_bit(toolchain, tmp_path):
    plan, packed = make_plan(TINY, seed=3)
    verdict(tmp_path / "good", plan, packed, "pass")
    verdict(tmp_path / "flipped", plan, packed, "fail", flip=True)


@pytest.mark.parametrize("change", ["cycles", "never ends"])
def test_it_fails_if_the_array_is_not_as_planned(toolchain, tmp_path, change):
    plan, packed = make_plan(TINY, seed=3)
    if change == "cycles":
        offset, cycles = plan.checks[-2]
        assert cycles == plan.cycles
        plan = replace(plan, checks=(*plan.checks[:-2], (offset, cycles + 1), plan.checks[-1]))
    else:
        # An array that waits for a row that never comes; only the watchdog ends the run.
        offset, height = plan.writes[0]
        plan = replace(plan, writes=((offset, height + 1), *plan.writes[1:]))
    verdict(tmp_path, plan, packed, "fail", patience=1 if change == "cycles" else 4)
