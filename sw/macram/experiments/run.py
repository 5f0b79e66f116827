"""Running a job to its end: the row before it, training or its resumption, scores, the record."""

from __future__ import annotations

import csv
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console

from macram.data.files import read_json, write_picture
from macram.data.open import dataset_version, open_dataset
from macram.data.recipe import read_recipe
from macram.experiments.plan import LAST, MODEL, RESULT, Job, read_result
from macram.experiments.refined import write_refined
from macram.experiments.scores import frames_csv, score_form, scores
from macram.experiments.statistics import read_frames
from macram.pose import Evaluation, PoseSettings
from macram.report.files import write_json, write_text
from macram.train.checkpoint import Card, load_model
from macram.train.config import completed
from macram.train.distributed import join_processes, processor_name
from macram.train.loop import Run
from macram.train.pack import thinned
from macram.train.predict import Predictor, evaluate_frames
from macram.train.record import differences, goes_on, train_command
from macram.train.samples import sample_sheet
from macram.weights import sha256

SPLIT = "testing"
CURVE_LINES = 120


def run_job(
    job: Job,
    runs: Path,
    results: Path,
    console: Console,
    *,
    limit: int = 0,
    told: Callable[[int, int], None] | None = None,
) -> Path:
    """Brings one job to its record; what is done already is not done again.

    Args:
        job: to run; the rows it continues or imitates are trained first where their networks are not there.
        runs: folder of checkpoints.
        results: folder of records.
        console: for the progress of the training.
        limit: score only so many test frames, and say so in the record; 0 for all.
        told: called with the number of frames scored and their total.

    Returns:
        The folder of its record.

    Raises:
        ValueError: bad configuration or data.
        KeyboardInterrupt: interrupted; the next call goes on from the checkpoint.
    """
    folder = results / job.key
    if (folder / RESULT).is_file():
        return folder
    job.plan.scoring.check()
    device = join_processes("auto").device
    train_job(job, runs, console)
    return record_job(job, job.folder(runs), results, device=processor_name(device), limit=limit, told=told)


def train_job(job: Job, runs: Path, console: Console) -> None:
    """Trains a job, and before it those it continues or imitates, as far as they are not trained yet."""
    if job.trained(runs):
        return
    for needed in (job.before(), job.teacher()):
        if needed is not None:
            train_job(needed, runs, console)
    config = job.config(runs)
    if source := job.plan.source(config.data.root):
        source.check()
    console.print(f"{job.key}: training", highlight=False, markup=False)
    Run(config, join_processes("auto"), console, resume=(job.folder(runs) / LAST).is_file()).train()


def record_job(
    job: Job,
    run: Path,
    results: Path,
    *,
    device: str,
    limit: int = 0,
    scored: Path | None = None,
    told: Callable[[int, int], None] | None = None,
) -> Path:
    """Scores a trained job by a single look and refined, and writes its record.

    That is ``frames.csv``, ``curve.csv``, ``frames.jpg``, ``refined.csv``, ``refined.json`` and ``result.json``.

    Args:
        job: what the run is of.
        run: folder with ``model.safetensors`` and ``log.csv``.
        results: folder of records.
        device: it was trained on, in words.
        limit: score only so many test frames.
        scored: ``evaluation.json`` of this very network on these frames by a single look, where `macram evaluate`
            has run.
        told: called with the number of frames scored and their total.

    Raises:
        ValueError: the network was trained with another configuration than the job's.
    """
    net, card = load_model(run / MODEL)
    check_configuration(job, card)
    place = join_processes("auto").device
    predictor = Predictor(net, card, place)
    frames = thinned(open_dataset(job.plan.scoring.data).frames(SPLIT), limit)
    if scored is None:
        evaluation, _ = evaluate_frames(predictor, frames, told)
    else:
        evaluation = read_evaluation(scored, [frame.name for frame in frames])
    folder = results / job.key
    folder.mkdir(parents=True, exist_ok=True)
    (folder / RESULT).unlink(missing_ok=True)  # no record stands beside the frames of another network
    write_text(folder / "frames.csv", frames_csv(evaluation))
    write_text(folder / "curve.csv", thinned_curve(run / "log.csv"))
    chosen = [frames[index] for index in outcomes(evaluation)]
    shown = list(predictor.detections([(frame.read_image(), frame.camera) for frame in chosen]))
    write_picture(folder / "frames.jpg", sample_sheet(chosen, shown), 85)
    write_refined(job, card, run / MODEL, frames, folder, str(place), told)
    # The record comes last: a row is finished when it is there.
    write_json(folder / RESULT, _record(job, card, run, evaluation, device, limit))
    return folder


def refine_job(job: Job, run: Path, results: Path, *, told: Callable[[int, int], None] | None = None) -> Path:
    """Adds ``refined.csv`` and ``refined.json`` to the record of a finished job, on the record's own frames.

    Args:
        job: with a record.
        run: folder with the ``model.safetensors`` that the record is of.
        results: folder of records.
        told: called with the number of frames scored and their total.

    Returns:
        The path of ``refined.json``.

    Raises:
        ValueError: no record, another network than the record's, or other frames in the data set.
    """
    folder, model = results / job.key, run / MODEL
    record = read_result(folder)
    _, card = load_model(model)
    if sha256(model) != record["model_sha256"]:
        raise ValueError(f"{model}: is another network than the record {job.key} has; name the run it is of")
    limit = 0 if record["all_frames"] else record["frames"]
    frames = thinned(open_dataset(job.plan.scoring.data).frames(SPLIT), limit)
    if tuple(frame.name for frame in frames) != read_frames(folder / "frames.csv").names:
        raise ValueError(
            f"{job.plan.scoring.data}: has other test frames than the record {job.key}; record the row again"
        )
    return write_refined(job, card, model, frames, folder, str(join_processes("auto").device), told)


def check_configuration(job: Job, card: Card) -> None:
    """Holds a network's own record against its row.

    Raises:
        ValueError: a setting differs.
    """
    theirs = completed(card.history[-1]["config"])
    mine = job.config(Path("runs")).to_dict()
    if wrong := differences(mine, theirs):
        key, value = next(iter(wrong.items()))
        raise ValueError(
            f"{job.key}: the network was trained with {key} = {value!r}; change the row or train again"
        )


def read_evaluation(path: Path, names: Sequence[str]) -> Evaluation:
    """An ``evaluation.json`` of the float form or training graph.

    Raises:
        ValueError: not an evaluation, of deployed integers, by another solver than the default, or of other frames
            than ``names``.
    """
    table = read_json(path)
    try:
        evaluation, details = Evaluation(table["rows"], table["summary"]), table["details"]
        form, solver = details["form"], details.get("solver", PoseSettings().words)
    except (KeyError, TypeError):
        raise ValueError(f"{path}: not an evaluation; give the evaluation.json of macram evaluate") from None
    if "integers" in form:
        raise ValueError(
            f"{path}: is of the {form}; a record wants the training graph, evaluate without --integer"
        )
    if solver != PoseSettings().words:
        raise ValueError(
            f"{path}: poses by {solver}; a record wants a single look, macram evaluate's default"
        )
    if [row["frame"] for row in evaluation.rows] != list(names):
        raise ValueError(
            f"{path}: is of other frames than the {len(names)} of this row; leave --evaluation away"
        )
    return evaluation


def outcomes(evaluation: Evaluation, count: int = 4) -> list[int]:
    """Frames to show: ``count`` spread over the better half by rank, then ``count`` over the worse half."""
    order = np.argsort([row["add_d"] for row in evaluation.rows], kind="stable")
    ranks = np.linspace(0, len(order) - 1, 2 * count).round().astype(int)
    return [int(order[rank]) for rank in ranks]


def thinned_curve(log: Path) -> str:
    """``log.csv`` with at most `CURVE_LINES` lines, evenly spaced, first, last and scored ones included."""
    with log.open(newline="") as file:
        rows = list(csv.DictReader(file))
    keep = set(np.linspace(0, len(rows) - 1, min(len(rows), CURVE_LINES)).round().astype(int).tolist())
    columns = ("step", "visits", "minutes", "loss", "pose", "similarity", "add_0.1", "add_0.2", "add_0.5")
    lines = [",".join(columns)]
    lines += [
        ",".join(row[column] for column in columns)
        for i, row in enumerate(rows)
        if i in keep or row["add_0.1"]
    ]
    return "\n".join(lines) + "\n"


def _version(job: Job, root: str) -> str:
    """Of a data set, which may have been on another machine."""
    source = job.plan.source(root)
    return read_recipe(source.recipe).version if source else dataset_version(Path(root))


def _record(
    job: Job,
    card: Card,
    run: Path,
    evaluation: Evaluation,
    device: str,
    limit: int,
) -> dict[str, Any]:
    stage = card.history[-1]
    return {
        "format": 1,
        "row": job.row.name,
        "seed": job.seed,
        "command": f"macram experiments run {job.row.name}",
        "train_command": train_command(
            job.row.config, stage["config"], ("run.init",) if goes_on(card.history) else ()
        ),
        "stage": stage["config"]["run"]["stage"],
        "mode": card.mode,
        "bits": card.bits,
        "steps": stage["step"],
        "images": stage["visits"],
        "images_with_earlier_stages": sum(record["visits"] for record in card.history),
        "minutes": round(stage["minutes"], 2),
        "device": device,
        "dataset": _version(job, stage["config"]["data"]["root"]),
        "scored_on": _version(job, str(job.plan.scoring.data)),
        "model_sha256": sha256(run / MODEL),
        "all_frames": not limit,
        "score_form": score_form(card),
        **scores(evaluation),
        "speed": evaluation.summary["speed"],
    }
