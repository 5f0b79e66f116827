"""What an array costs on a device, by synthesis."""

from __future__ import annotations

import time
from collections import defaultdict
from pathlib import Path
from typing import Any

from macram.report.versions import versions
from macram.spec import ArrayConfig
from macram.synth.devices import RESOURCES, Device
from macram.synth.sources import export_sources, sources_hash
from macram.synth.stat import instances, read_stat, short_name
from macram.synth.tools import run_yosys, tool_versions

TOP, UNIT = "macram_top", "macram_unit"
FORMAT = 2
NOTES = {
    "hierarchical": (
        "hierarchical: every module synthesised by itself, the unit's arithmetic (macram_unit, flattened) once, as a "
        "black box in the rest and counted once per instance; nothing is optimised across module borders"
    ),
    "flat": "flat: the whole design as one module",
}


def synthesise(
    config: ArrayConfig, device: Device, folder: Path, *, flat: bool, timeout: float
) -> dict[str, Any]:
    """Synthesise an array and count its resources.

    Args:
        config: the array.
        device: what to map to.
        folder: scripts, logs and sources go here; made if missing.
        flat: as one module instead of module by module. The whole of 64 units takes much longer.
        timeout: seconds after which Yosys is stopped.

    Returns:
        plain values: ``device``, ``array``, ``design`` (`macram.synth.sources.design_hash`), ``mode`` and ``note``,
        ``modules`` (rows of name, instances and resources of all of them together), ``total``, ``percent`` of the
        device, ``limits``, ``excess`` (empty if it fits), ``seconds``, ``versions``.

    Raises:
        ToolError: Yosys is missing or failed.
        ToolTimeout: the time was up.
        ValueError: the netlist holds a cell that the device's table does not know.
    """
    folder.mkdir(parents=True, exist_ok=True)
    names = export_sources(config, folder, contents=False)
    start = time.perf_counter()
    run_yosys(_script(names, device, flat), folder, name="synth", timeout=timeout)
    modules = read_stat(folder / "stat.json")
    total = dict.fromkeys(RESOURCES, 0.0)
    number: dict[str, int] = defaultdict(int)
    rows: dict[str, dict[str, float]] = defaultdict(lambda: dict.fromkeys(RESOURCES, 0.0))
    for module, times in instances(modules, TOP).items():
        name = short_name(module)
        number[name] += times
        for resource, amount in device.count(modules[module].cells).items():
            rows[name][resource] += times * amount
            total[resource] += times * amount
    return {
        "format": FORMAT,
        "device": device.name,
        "device_title": device.title,
        "array": config.to_dict(),
        "design": sources_hash(folder, names),
        "mode": "flat" if flat else "hierarchical",
        "note": NOTES["flat" if flat else "hierarchical"],
        "modules": [
            {"name": name, "instances": number[name], **used}
            for name, used in sorted(rows.items(), key=lambda row: -row[1]["lut"])
            if any(used.values())
        ],
        "total": total,
        "capacity": dict(device.capacity),
        "percent": {key: round(100 * total[key] / device.capacity[key], 1) for key in RESOURCES},
        "limits": {key: device.limit(key) for key in RESOURCES},
        "excess": device.excess(total),
        "seconds": round(time.perf_counter() - start, 1),
        "versions": versions() | tool_versions(),
    }


def _script(names: list[str], device: Device, flat: bool) -> str:
    """Yosys commands that end in ``stat.json``."""
    read = f"read_verilog {' '.join(names)}\n"
    if flat:
        body = f"{read}{device.synth}{device.whole} -top {TOP}\n"
    else:
        body = f"{unit_script(read, device)}{read}blackbox {UNIT}\n{device.synth}{device.modules} -top {TOP}\n{JOIN}"
    return f"{body}tee -q -o stat.json stat -json\n"


def unit_script(read: str, device: Device) -> str:
    """Yosys commands that map the unit as one module and put it aside; ``read`` reads the sources."""
    return f"{read}{device.synth}{device.unit} -top {UNIT}\ndesign -stash unit\n"


JOIN = f"delete ={UNIT}\ndesign -copy-from unit {UNIT}\n"
"""Yosys commands that put the unit that `unit_script` mapped in the place of the black box."""
