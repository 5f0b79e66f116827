"""What one unit costs, by synthesis of its arithmetic alone: seconds where a whole array takes minutes."""

from __future__ import annotations

import dataclasses
import hashlib
from pathlib import Path

from macram.spec import GROUP, ArrayConfig
from macram.synth.cost import TOP, UNIT, unit_script
from macram.synth.devices import RESOURCES, Device
from macram.synth.sources import export_sources, plain_names
from macram.synth.stat import instances, read_stat
from macram.synth.tools import run_yosys


def count_unit(config: ArrayConfig, device: Device, folder: Path, *, timeout: float) -> dict[str, float]:
    """Resources of the arithmetic of one unit (``macram_unit``), as in the report of the whole array.

    Args:
        config: the array; its unit is that of a smaller array with as many tiles, which is what is exported.
        device: what to map to.
        folder: script, log and sources go here; made if missing.
        timeout: seconds after which Yosys is stopped.

    Raises:
        ToolError: Yosys is missing or failed.
        ToolTimeout: the time was up.
    """
    folder.mkdir(parents=True, exist_ok=True)
    units = GROUP * config.drain
    small = dataclasses.replace(config, units=units, max_c_out=units * config.max_tiles)
    names = [name for name in export_sources(small, folder, contents=False) if name != f"{TOP}.v"]
    script = unit_script(f"read_verilog {' '.join(names)}\n", device)
    run_yosys(
        f"{script}design -load unit\ntee -q -o stat.json stat -json\n", folder, name="unit", timeout=timeout
    )
    modules = read_stat(folder / "stat.json")
    total = dict.fromkeys(RESOURCES, 0.0)
    for module, times in instances(modules, UNIT).items():
        for resource, amount in device.count(modules[module].cells).items():
            total[resource] += times * amount
    return total


def unit_hash(config: ArrayConfig) -> str:
    """SHA-256 of a unit's Verilog: equal as long as neither its configuration nor the gateware has changed."""
    from macram_hw.export import component_verilog  # noqa: PLC0415
    from macram_hw.unit import UnitCore  # noqa: PLC0415

    return hashlib.sha256(plain_names(component_verilog(UnitCore(config), UNIT)).encode()).hexdigest()
