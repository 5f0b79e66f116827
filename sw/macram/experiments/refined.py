"""A row's scores by the plan's refined way to find poses, beside those by a single look on the same frames."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from macram.data.files import read_json
from macram.data.frame import Frame
from macram.data.open import dataset_version
from macram.experiments.plan import Job
from macram.experiments.scores import frames_csv, score_form, scores
from macram.experiments.statistics import Frames, read_frames
from macram.report.files import write_json, write_text
from macram.train.checkpoint import Card
from macram.train.detect import detect_frames
from macram.train.predict import evaluate_found
from macram.weights import sha256

REFINED, REFINED_FRAMES = "refined.json", "refined.csv"


@dataclass(frozen=True, eq=False, slots=True)
class RefinedScores:
    """``refined.json`` and ``refined.csv`` of a record."""

    table: dict[str, Any]
    frames: Frames


def write_refined(
    job: Job,
    card: Card,
    model: Path,
    frames: Sequence[Frame],
    folder: Path,
    device: str,
    told: Callable[[int, int], None] | None = None,
) -> Path:
    """Scores a network as the plan's ``[refined]`` says.

    Args:
        job: of the network.
        card: of the network.
        model: its file.
        frames: those of the record.
        folder: of the record.
        device: to run the network on, ``cpu`` or ``cuda:0``.
        told: called with the number of frames scored and their total.

    Returns:
        The path of ``refined.json``.

    Raises:
        ValueError: a bad file, or a target that is no box.
    """
    refined = job.plan.refined
    evaluation = evaluate_found(frames, detect_frames(model, frames, device, refined.settings, told))
    write_text(folder / REFINED_FRAMES, frames_csv(evaluation))
    table = {
        "format": 1,
        "row": job.row.name,
        "seed": job.seed,
        "options": refined.options,
        "solver": refined.settings.words,
        "settings": refined.settings.to_dict(),
        "model_sha256": sha256(model),
        "dataset": dataset_version(job.plan.scoring.data),
        "score_form": score_form(card),
        **scores(evaluation),
    }
    write_json(folder / REFINED, table)
    return folder / REFINED


def read_refined(job: Job, folder: Path, record: dict[str, Any]) -> RefinedScores | None:
    """The refined scores of a record; None where they were not measured.

    Args:
        job: of the record.
        folder: of the record.
        record: its ``result.json``.

    Raises:
        ValueError: they are of another network than the record, or not by the plan's ``[refined]``.
    """
    path = folder / REFINED
    if not path.is_file():
        return None
    table = read_json(path)
    again = f"macram experiments refine {job.row.name} RUN"
    if table["model_sha256"] != record["model_sha256"]:
        raise ValueError(f"{path}: is of another network than the record; {again}")
    if table["options"] != job.plan.refined.options:
        raise ValueError(
            f"{path}: is by {table['options']}, the plan says {job.plan.refined.options}; {again}"
        )
    if table.get("settings") != job.plan.refined.settings.to_dict():
        raise ValueError(f"{path}: {table['options']} meant other settings then than now; {again}")
    return RefinedScores(table, read_frames(folder / REFINED_FRAMES))
