"""What a design costs, taken from the reports that ``macram synth`` left."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from macram.spec import ArrayConfig
from macram.synth.cost import FORMAT
from macram.synth.devices import RESOURCES
from macram.synth.sources import design_hash

DEVICE = "xczu3eg"
"""Whose counts stand in the tables: LUTs and block RAMs of different families are not comparable."""


def find_resources(array: ArrayConfig, folder: Path) -> dict[str, Any] | None:
    """Counts of exactly this design, if a report of them lies in ``folder`` or below.

    A report belongs to the design if it is of the same configuration and was made from the same Verilog: one from
    before a change of the gateware is not used. Of several the flat one is taken, which is exact.

    Returns:
        ``lut``, ``ff``, ``dsp``, ``bram`` (RAMB36), ``percent`` of the device by the same names, ``device``, ``mode``
        (``flat`` or ``hierarchical``), ``fits``, ``design`` (SHA-256) and ``file``; None without such a report.
    """
    shape = _nameless(array.to_dict())
    reports = [(path, _report(path)) for path in sorted(folder.rglob("synth.json"))]
    alike = [(path, report) for path, report in reports if report and _nameless(report["array"]) == shape]
    if not alike:
        return None
    design = design_hash(array)
    mine = [(path, report) for path, report in alike if report["design"] == design]
    if not mine:
        return None
    path, report = min(mine, key=lambda found: found[1]["mode"] != "flat")
    return {
        **{kind: report["total"][kind] for kind in RESOURCES},
        "percent": report["percent"],
        "device": report["device"],
        "mode": report["mode"],
        "fits": not report["excess"],
        "design": design,
        "file": path.as_posix(),
    }


def _report(path: Path) -> dict[str, Any] | None:
    """A report of this version for `DEVICE`, else None: what else is called ``synth.json`` is not ours."""
    try:
        report = json.loads(path.read_text(encoding="utf-8"))
        return report if (report["format"], report["device"]) == (FORMAT, DEVICE) else None
    except (OSError, ValueError, KeyError, TypeError):
        return None


def _nameless(array: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in array.items() if key != "name"}
