"""What the simulation of one layer shape found, as a file that is not made twice."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from macram.golden import random_case
from macram.layer_job import Traffic, layer_table, run_layer_job
from macram.network.shapes import Shape
from macram.report.files import write_json

FORMAT = 1


def record_path(folder: Path, shape: Shape, design: str, seed: int) -> Path:
    """Where the record of a shape lies: its name says the shape, and by a digest design and seed.

    Args:
        folder: of all records.
        shape: of the layer.
        design: `macram.synth.sources.design_hash` of the array: another Verilog, another file.
        seed: of codes and weights.
    """
    what = json.dumps([FORMAT, design, layer_table(shape.spec), seed], sort_keys=True)
    return folder / f"{shape.label}-{hashlib.sha256(what.encode()).hexdigest()[:12]}.json"


def find_record(folder: Path, shape: Shape, design: str, seed: int) -> dict[str, Any] | None:
    """The record of a shape that was simulated before; None without one, or with a damaged one."""
    try:
        record: dict[str, Any] = json.loads(record_path(folder, shape, design, seed).read_text("utf-8"))
    except (OSError, ValueError):
        return None
    if not isinstance(record, dict):
        return None
    same = record.get("design") == design and record.get("layer") == layer_table(shape.spec)
    return record if same and record.get("seed") == seed else None


def simulate_shape(
    folder: Path, shape: Shape, design: str, seed: int, told: Callable[[float], None] | None = None
) -> dict[str, Any]:
    """Simulate random codes through a layer of this shape, compare every output code, and leave the record.

    Args:
        folder: of all records; exists.
        shape: one that its array runs.
        design: as of `record_path`.
        seed: likewise.
        told: called now and then with the share that is done.

    Returns:
        `macram.layer_job.LayerRun.report` and ``design``.

    Raises:
        RuntimeError: the simulation died.
    """
    run = run_layer_job(
        random_case(shape.spec, seed), array=shape.array, traffic=Traffic(seed=seed), told=told
    )
    record = run.report() | {"design": design}
    write_json(record_path(folder, shape, design, seed), record)
    return record
