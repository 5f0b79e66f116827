"""The section of ``docs/results.md`` on what was tried at inference."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from pathlib import Path
from typing import Any

from macram.data.files import read_json
from macram.data.geometry import BUCKETS
from macram.experiments.inference import ALL, TRIES, is_of
from macram.experiments.sections import table
from macram.pose import EdgeSettings

LIMITS = ("0.1", "0.2", "0.5")
HEAD = ("setting", "options", *BUCKETS, "ADD-0.1d %", "0.2d %", "0.5d %", "rotation, deg", "CPU s")


def tried(results: Path, shas: Collection[str]) -> list[str]:
    """Every setting on the validation split, the chosen ones on the test split; empty without a record.

    Args:
        results: folder of records.
        shas: SHA-256 of the networks in the tables of rows; others are called earlier ones.

    Raises:
        ValueError: a setting was scored by other numbers than it stands for now.
    """
    records = [_current(path) for path in sorted(results.glob(TRIES))]
    parts = []
    for record in records:
        rows = _rows(record, "validation")
        if rows:
            parts += [
                _introduction(record, rows, _network(record, shas)),
                table(HEAD, [_line(row) for row in rows]),
            ]
    for record in records:
        rows = _rows(record, "testing")
        if rows:
            parts += [
                f"The chosen settings on the test split, {rows[0]['frames']:,} frames, {_network(record, shas)}, "
                f"{record['form']}:",
                table(HEAD, [_line(row) for row in rows]),
            ]
    return ["## What was tried at inference", *parts] if parts else []


def _current(path: Path) -> dict[str, Any]:
    record: dict[str, Any] = read_json(path)
    entries = {entry.name: entry for entry in ALL}
    for row in record["rows"]:
        entry = entries.get(row["name"])
        if entry is None or not is_of(row, entry, record["edge_box"]):
            raise ValueError(
                f"{path}: {row['name']!r} meant other settings then than now; macram experiments inference MODEL"
            )
    return record


def _rows(record: dict[str, Any], split: str) -> list[dict[str, Any]]:
    return [row for row in record["rows"] if row["split"] == split]


def _network(record: dict[str, Any], shas: Collection[str]) -> str:
    sha = record["model_sha256"]
    earlier = "" if sha in shas else f" of an earlier training (SHA-256 {sha[:12]}, not in the tables above)"
    return f"`{record['network']}`{earlier}"


def _introduction(record: dict[str, Any], rows: Sequence[dict[str, Any]], network: str) -> str:
    return (
        f"`macram experiments inference MODEL` on {network}, trained once, {rows[0]['frames']:,} frames of "
        "the validation split. *CPU s* is the time of one core for a picture, network and "
        "reading included; rotation is the median. *Looks* are turned crops around the first pose, in which the target "
        "has 56 of 128 pixels; *edges* align the pose with the picture's steps of brightness along the edges of a box "
        f"of {record['edge_box']:g} of the keypoints' box, measured on {record['edge_box_frames']} training frames "
        f"with their true poses; they start {100 * (1 - EdgeSettings().nearer):.0f} % nearer than the keypoints say "
        "and prefer the outline to edges inside it until the last round. All of these are calibrations on training and "
        "validation frames alone."
    )


def _line(row: dict[str, Any]) -> Sequence[str]:
    return [
        row["name"],
        f"`{row['options']}`" if row["options"] else "",
        *(_number(row["ranges"][bucket], 1) for bucket in BUCKETS),
        *(f"{row['add'][limit]:.1f}" for limit in LIMITS),
        _number(row["re_deg_median"], 1),
        _number(row["seconds"], 3),
    ]


def _number(value: float | None, digits: int) -> str:
    return "" if value is None else f"{value:.{digits}f}"
