"""A bitstream for the ECP5 evaluation board with open tools: Yosys, nextpnr, ecppack."""

from __future__ import annotations

import hashlib
import json
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from macram.layer_job import Stage
from macram.report.versions import machine, versions
from macram.spec import ArrayConfig
from macram.spec.selftest import SelfTestPlan
from macram.synth import board
from macram.synth.cost import JOIN, UNIT, unit_script
from macram.synth.devices import DEVICES
from macram.synth.plan import make_plan
from macram.synth.sources import export_sources, plain_names
from macram.synth.tools import run_tool, run_yosys, tool_versions

TOP = "macram_ecp5_evn"
ECP5 = DEVICES["ecp5-85k"]
FORMAT = 1


def build_bitstream(
    config: ArrayConfig, folder: Path, *, mhz: int, seed: int, timeout: float, stage: Stage
) -> dict[str, Any]:
    """Self-test of an array -> ``macram.bit``; every file on the way stays in ``folder``.

    Args:
        config: the array.
        folder: made if missing.
        mhz: array clock that the PLL makes and nextpnr aims for.
        seed: of the self-test's layer and of nextpnr.
        timeout: seconds for each tool.
        stage: opens a named stage.

    Returns:
        plain values: ``fmax_mhz`` after routing, ``met`` (whether it reaches the clock), ``utilisation`` as nextpnr
        counts it, ``sha256``, ``seconds`` per step, ``selftest``, ``versions`` and so on.

    Raises:
        ToolError: a tool is missing, failed, or was too slow.
        ValueError: no self-test or no clock can be made for these arguments.
    """
    dividers = board.pll_dividers(mhz)
    folder.mkdir(parents=True, exist_ok=True)
    seconds: dict[str, float] = {}

    @contextmanager
    def timed(name: str) -> Iterator[None]:
        start = time.perf_counter()
        with stage(name):
            yield
        seconds[name] = round(time.perf_counter() - start, 1)

    with timed("self-test layer and Verilog"):
        plan, sources = _write_sources(config, folder, seed)
        (folder / "board.lpf").write_text(board.constraints())
    with timed("synthesis"):
        run_yosys(_script(sources, dividers), folder, name="synth", timeout=timeout)
    with timed("place and route"):
        route = [
            *board.NEXTPNR, "--json", "netlist.json", "--lpf", "board.lpf", "--textcfg", "macram.config",
            "--report", "route.json", "--seed", str(seed), "--timing-allow-fail",
        ]  # fmt: skip
        run_tool("nextpnr-ecp5", route, folder, log="route.log", timeout=timeout)
    with timed("bitstream"):
        pack = ["--compress", "macram.config", "macram.bit"]
        run_tool("ecppack", pack, folder, log="pack.log", timeout=timeout)

    routed = json.loads((folder / "route.json").read_text())
    fmax = array_clock(routed["fmax"])
    image = (folder / "macram.bit").read_bytes()
    return {
        "format": FORMAT,
        "board": "ECP5 evaluation board (LFE5UM5G-85F-EVN)",
        "part": board.PART,
        "array": config.to_dict(),
        "clock_mhz": mhz,
        "fmax_mhz": round(fmax, 2),
        "met": fmax >= mhz,
        "utilisation": {
            name: {"used": row["used"], "available": row["available"]}
            for name, row in routed["utilization"].items()
            if row["used"]
        },
        "peak_macs_per_cycle": config.peak_macs,
        "selftest": {
            "beats_in": plan.beats_in,
            "beats_out": plan.beats_out,
            "cycles": plan.cycles,
            "crc32": f"{plan.crc:08x}",
        },
        "seed": seed,
        "bytes": len(image),
        "sha256": hashlib.sha256(image).hexdigest(),
        "seconds": seconds,
        "machine": machine(),
        "versions": versions() | tool_versions(),
    }


def _write_sources(config: ArrayConfig, folder: Path, seed: int) -> tuple[SelfTestPlan, list[str]]:
    """Verilog of array, self-test and board, and the memory contents; names of the Verilog files."""
    from macram_hw.export import component_verilog, model_path  # noqa: PLC0415
    from macram_hw.selftest import SelfTest  # noqa: PLC0415

    plan, packed = make_plan(config, seed)
    packed.write(folder / "mem")
    for memory in sorted((folder / "mem").glob("*.mem")):
        # $readmemh looks where Yosys runs.
        (folder / memory.name).write_bytes(memory.read_bytes())
    sources = export_sources(config, folder, contents=True)
    (folder / "macram_selftest.v").write_text(
        plain_names(component_verilog(SelfTest(config, plan), "macram_selftest"))
    )
    (folder / f"{TOP}.v").write_text(model_path(f"{TOP}.v").read_text())
    return plan, [*sources, "macram_selftest.v", f"{TOP}.v"]


def _script(sources: list[str], dividers: dict[str, int]) -> str:
    """Yosys commands: the unit is mapped once, its engines in LUTs; the rest beside it may use multipliers."""
    parameters = "".join(f" -set {name} {value}" for name, value in dividers.items())
    read = f"read_verilog {' '.join(sources)}\n"
    return (
        f"{unit_script(read, ECP5)}"
        f"{read}"
        f"chparam{parameters} {TOP}\n"
        f"blackbox {UNIT}\n"
        f"{ECP5.synth} -top {TOP}\n"
        f"{JOIN}"
        "flatten -noscopeinfo\n"
        "opt_clean -purge\n"
        "tee -q -o stat.json stat -json\n"
        "write_json netlist.json\n"
    )


def array_clock(fmax: dict[str, dict[str, float]]) -> float:
    """Reached MHz of the array's clock: of the slowest net that is constrained above the oscillator's frequency.

    Raises:
        ValueError: there is no such net.
    """
    reached = [row["achieved"] for row in fmax.values() if row["constraint"] > board.OSCILLATOR_MHZ + 0.5]
    if not reached:
        raise ValueError(
            f"nextpnr reports no clock above {board.OSCILLATOR_MHZ} MHz, only {', '.join(fmax) or 'none'}"
        )
    return min(reached)
