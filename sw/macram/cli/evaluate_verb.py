"""``macram evaluate``."""

from __future__ import annotations

import argparse
import shlex
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from macram.cli.examples import say_more
from macram.cli.pose_options import OPTIONS, add_pose_options, pose_settings
from macram.cli.status import OK

if TYPE_CHECKING:
    from rich.console import Console
    from rich.progress import TaskID

QUIET_S = 30.0

DETAIL = (
    "Writes evaluation.json (every frame), evaluation.md, evaluation.png and samples.jpg. Pictures are brought to "
    "the focal length of the training first. A network in mode III is also compared with its deployed integers, layer "
    "by layer, on a few frames; the table stands in evaluation.json and evaluation.md. Scores to hold beside the "
    "paper's take a single look; --looks and --edges spend more on every picture and find better poses."
)
COMPARED = 4
"""Frames on which training graph and integers are compared."""
EXAMPLES = """\
examples:
  macram evaluate build/runs/quarter-wdr/model.safetensors --data build/data/mini
  macram evaluate build/runs/quarter-w3a3/model.safetensors --data build/data/mini --integer --limit 100
  macram evaluate --weights quarter-float --data build/data/mini --looks 4 --edges 0.9928

A frame counts as right at 0.1d if the model's points lie, on average, less than a tenth of the object's diameter
from where they should; a frame without a pose counts as wrong.
"""


def add_evaluate(verb: Callable[[str, str, str, str], argparse.ArgumentParser]) -> None:
    """The grammar of ``macram evaluate``; ``verb`` makes a top-level verb."""
    sub = verb("evaluate", "evaluate_verb", "score a trained network on a data set", DETAIL)
    say_more(sub, EXAMPLES)
    sub.add_argument(
        "model",
        nargs="?",
        default="",
        metavar="MODEL",
        help="model.safetensors that a run has left, or a shipped name (macram weights)",
    )
    sub.add_argument("--weights", default="", metavar="MODEL", help="the same, as macram predict has it")
    sub.add_argument("--data", type=Path, required=True, metavar="DIR", help="SwissCube, BOP or SPEED folder")
    sub.add_argument("--split", help="part of the data set (default: testing, or the last one there is)")
    sub.add_argument(
        "--limit", type=int, default=0, metavar="N", help="only N frames, evenly spaced (default: all)"
    )
    sub.add_argument(
        "-o",
        "--out",
        type=Path,
        default=Path("build/evaluation"),
        metavar="DIR",
        help="default: build/evaluation",
    )
    sub.add_argument("--integer", action="store_true", help="run the deployed integers (mode III, CPU)")
    sub.add_argument("--device", choices=("auto", "cpu", "cuda"), default="auto", help="default: auto")
    sub.add_argument("--no-refine", action="store_true", help="EPnP RANSAC alone, as published")
    sub.add_argument("--published", action="store_true", help="candidates and solver as published")
    add_pose_options(sub)


def check_limit(frames: int) -> None:
    """Before anything is computed.

    Raises:
        ValueError: not a number of frames.
    """
    if frames < 0:
        raise ValueError(f"--limit must be 0 (all frames) or more, not {frames}")


def evaluate(arguments: argparse.Namespace) -> int:
    """Score one network."""
    # Late: the grammar above is loaded by every command, PyTorch is not.
    from rich.console import Console  # noqa: PLC0415

    from macram.data.files import write_picture  # noqa: PLC0415
    from macram.data.open import dataset_version, open_dataset  # noqa: PLC0415
    from macram.data.speed import Speed  # noqa: PLC0415
    from macram.report.evaluation import write_evaluation  # noqa: PLC0415
    from macram.train.checkpoint import load_model  # noqa: PLC0415
    from macram.train.distributed import join_processes  # noqa: PLC0415
    from macram.train.pack import thinned  # noqa: PLC0415
    from macram.train.predict import Predictor, compare_frames, evaluate_frames  # noqa: PLC0415
    from macram.train.samples import sample_sheet  # noqa: PLC0415
    from macram.weights import sha256, weights_file  # noqa: PLC0415

    choice = arguments.weights or arguments.model
    if not choice or (arguments.weights and arguments.model):
        raise ValueError("name the network once: macram evaluate MODEL, or macram evaluate --weights MODEL")
    check_limit(arguments.limit)
    settings = pose_settings(
        arguments,
        refine=not (arguments.no_refine or arguments.published),
        published=arguments.published,
    )
    path = weights_file(choice)
    net, card = load_model(path)
    predictor = Predictor(
        net,
        card,
        join_processes("cpu" if arguments.integer else arguments.device).device,
        integer=arguments.integer,
        settings=settings,
    )
    dataset = open_dataset(arguments.data)
    split = arguments.split or ("testing" if "testing" in dataset.splits else dataset.splits[-1])
    frames = thinned(dataset.frames(split), arguments.limit)
    console = Console()
    with frames_progress(console) as told:
        evaluation, found = evaluate_frames(predictor, frames, told)
    arguments.out.mkdir(parents=True, exist_ok=True)
    details = {
        "network": choice,
        "sha256": sha256(path),
        "form": _form(card.mode, card.bits, integer=arguments.integer),
        "data": f"{arguments.data}, {split}",
        "dataset": dataset_version(arguments.data),
        "solver": settings.words,
        "command": _command(arguments, choice),
    }
    layers = []
    if card.mode == "III" and net.config.deployable:
        console.print(f"comparing training graph and integers on {COMPARED} frames", highlight=False)
        layers = compare_frames(predictor, thinned(frames, COMPARED))
    paths = write_evaluation(
        arguments.out, evaluation, title=f"Evaluation on {split}", details=details, layers=layers
    )
    write_picture(arguments.out / "samples.jpg", sample_sheet(frames, found))
    table = evaluation.summary["fixed"]["all"]
    shares = ", ".join(f"ADD-{limit}d {table['add'][limit]:.2f} %" for limit in ("0.1", "0.2", "0.5"))
    if layers:
        codes = sum(row["codes"] for row in layers)
        alone = sum(row["codes"] * row["alone"] for row in layers) / codes
        console.print(
            f"{100 * alone:.4f} % of {codes:,} codes differ, layer by layer, between training graph and integers",
            highlight=False, soft_wrap=True,
        )  # fmt: skip
    lines = [f"{table['frames']} frames, {table['misses']} without a pose: {shares}"]
    if isinstance(dataset, Speed):
        score = evaluation.summary["speed"]["count"]
        lines.append(f"SPEED: e_q {score['e_q']:.4f}, e_t {score['e_t']:.4f}, sum {score['score']:.4f}")
    for line in (*lines, str(paths[1])):
        console.print(line, highlight=False, markup=False, soft_wrap=True)
    return OK


def _form(mode: str, bits: int, *, integer: bool) -> str:
    if not mode:
        return "float32"
    return f"{bits} bit, mode {mode}, " + ("deployed integers" if integer else "training graph")


def _command(arguments: argparse.Namespace, choice: str) -> str:
    """What to type to get the same scores."""
    words = ["macram", "evaluate", choice, "--data", str(arguments.data)]
    for option in ("split", "limit", *OPTIONS):
        if value := getattr(arguments, option):
            words += [f"--{option}", str(value)]
    words += [
        f"--{option.replace('_', '-')}"
        for option in ("integer", "no_refine", "published")
        if getattr(arguments, option)
    ]
    return shlex.join(words)


@contextmanager
def frames_progress(console: Console) -> Iterator[Callable[[int, int], None]]:
    """A bar of scored frames on a terminal, elsewhere a line every half minute; the frames done and their total."""
    from rich.progress import Progress  # noqa: PLC0415

    bar, told = Progress(console=console, disable=not console.is_terminal), time.monotonic()
    task: TaskID | None = None

    def tell(done: int, total: int) -> None:
        nonlocal task, told
        if task is None:  # not before there is something to show: training has a bar of its own
            bar.start()
            task = bar.add_task("evaluating", total=total)
        bar.update(task, completed=done)
        if not console.is_terminal and time.monotonic() - told > QUIET_S:
            told = time.monotonic()
            console.print(f"evaluating: {done}/{total} frames", highlight=False, markup=False)

    try:
        yield tell
    finally:
        bar.stop()
