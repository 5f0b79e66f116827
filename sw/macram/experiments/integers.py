"""Scores of a row's deployed integers, beside those of its training graph on the same frames."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from macram.data.files import read_json
from macram.experiments.plan import Job, read_result
from macram.experiments.statistics import read_frames
from macram.pose import PoseSettings
from macram.pose.evaluation import DISTANCE_THRESHOLDS_D
from macram.report.files import write_json

INTEGERS = "integers.json"
APART_D = 0.01
"""Errors of one frame further apart than this, in diameters, count as different."""


def record_integers(job: Job, scored: Path, results: Path) -> Path:
    """Writes ``integers.json`` into the folder of a finished job.

    Args:
        job: with a record.
        scored: ``evaluation.json`` of ``macram evaluate --integer`` of the same network.
        results: folder of records.

    Returns:
        The file's path.

    Raises:
        ValueError: not an evaluation of integers, of another network, or of frames the record does not have.
    """
    folder = results / job.key
    record, frames = read_result(folder), read_frames(folder / "frames.csv")
    table = read_json(scored)
    try:
        details, rows, summary = table["details"], table["rows"], table["summary"]
        form, sha = details["form"], details["sha256"]
    except (KeyError, TypeError):
        raise ValueError(
            f"{scored}: not an evaluation; give the evaluation.json of macram evaluate"
        ) from None
    if "integers" not in form:
        raise ValueError(f"{scored}: is of the form {form!r}; evaluate with --integer")
    if details.get("solver") != PoseSettings().words:
        raise ValueError(
            f"{scored}: poses by {details.get('solver')}; the record takes macram evaluate's default"
        )
    if sha != record["model_sha256"]:
        raise ValueError(f"{scored}: is of another network than the record {job.key}; evaluate that one")
    place = {name: n for n, name in enumerate(frames.names)}
    if unknown := [row["frame"] for row in rows if row["frame"] not in place]:
        raise ValueError(
            f"{scored}: frame {unknown[0]} is not in the record {job.key}; evaluate its test split"
        )
    graph = frames.add_d[[place[row["frame"]] for row in rows]]
    integers = np.array([row["add_d"] for row in rows])
    result: dict[str, Any] = {
        "format": 1,
        "form": form,
        "command": details["command"],
        "model_sha256": sha,
        "dataset": details["dataset"],
        "frames": len(rows),
        "all_frames": len(rows) == len(frames.names),
        "misses": summary["misses"],
        "add": summary["fixed"]["all"]["add"],
        "training_graph_add": {
            f"{limit:g}": 100 * float(np.mean(graph < limit)) for limit in DISTANCE_THRESHOLDS_D
        },
        "frames_apart": int(np.sum(np.abs(integers - graph) > APART_D)),
        "apart_d": APART_D,
    }
    write_json(folder / INTEGERS, result)
    return folder / INTEGERS


def read_integers(job: Job, folder: Path, record: dict[str, Any]) -> dict[str, Any] | None:
    """``integers.json`` of a record; None where they were not measured.

    Args:
        job: of the record.
        folder: of the record.
        record: its ``result.json``.

    Raises:
        ValueError: a broken file, or one of another network than the record.
    """
    path = folder / INTEGERS
    if not path.is_file():
        return None
    table: dict[str, Any] = read_json(path)
    if table.get("model_sha256") != record["model_sha256"]:
        raise ValueError(
            f"{path}: is of another network than the record; macram experiments integers {job.row.name} "
            "EVALUATION.json makes it anew"
        )
    return table
