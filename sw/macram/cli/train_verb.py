"""``macram train``."""

from __future__ import annotations

import argparse
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

from macram.cli.examples import say_more
from macram.cli.status import OK

DETAIL = (
    "Stages: wdr (factual path), counterfactual, control (wdr for the same extra time), lsq (quantised). Leaves "
    "model.safetensors, last.safetensors, log.csv, TensorBoard events and sample pictures in run.out. Several "
    "processes: torchrun --nproc-per-node N -m macram.cli train CONFIG.toml."
)
EXAMPLES = """\
examples:
  macram data render -o build/data/mini --tier mini --background      pictures to learn from, once
  macram train configs/train-quarter-wdr.toml                         stage 1
  macram train configs/train-quarter-counterfactual.toml              stage 2, from what stage 1 left
  macram train configs/train-quarter-w3a3.toml                        stage 3: 3 bits
  macram train CONFIG.toml --resume                                   exactly as if it had not been interrupted
  macram train CONFIG.toml --set run.precision=fp32                   no bfloat16, if a run diverges

Every key of a configuration, with its meaning and default, stands in macram/train/settings.py (RunSettings
and the classes below it); the stages and variants are explained in docs/vision.md.
"""


def add_train(verb: Callable[[str, str, str, str], argparse.ArgumentParser]) -> None:
    """The grammar of ``macram train``; ``verb`` makes a top-level verb."""
    sub = verb("train", "train_verb", "train a stage of the network", DETAIL)
    say_more(sub, EXAMPLES)
    sub.add_argument("config", type=Path, metavar="CONFIG.toml", help="what to train, on what, for how long")
    sub.add_argument("--resume", action="store_true", help="go on from the checkpoint in run.out")
    sub.add_argument(
        "--device",
        choices=("auto", "cpu", "cuda"),
        default="auto",
        help="auto (default): a GPU if there is one",
    )
    sub.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="KEY=VALUE",
        help="override a value, as in --set schedule.steps=1000 --set run.out=runs/a; may be repeated",
    )


def train(arguments: argparse.Namespace) -> int:
    """Run one stage."""
    # Late: the grammar above is loaded by every command, PyTorch is not.
    from macram.train.memory import keep_memory  # noqa: PLC0415

    keep_memory()
    from rich.console import Console  # noqa: PLC0415

    from macram.train.config import load_config  # noqa: PLC0415
    from macram.train.distributed import join_processes, leave_processes  # noqa: PLC0415
    from macram.train.loop import Run  # noqa: PLC0415

    config = load_config(arguments.config, overrides(arguments.set))
    console = Console()
    processes = join_processes(arguments.device)
    try:
        run = Run(config, processes, console, resume=arguments.resume)
        path = run.train()
    finally:
        leave_processes()
    if processes.first:
        console.print(
            f"{path}: stage {config.run.stage}, {run.step} steps, {run.visits} images, {run.minutes:.1f} min",
            highlight=False, markup=False, soft_wrap=True,
        )  # fmt: skip
    return OK


def overrides(settings: list[str]) -> dict[str, Any]:
    """``["a.b=1", "c=x"]`` -> ``{"a.b": 1, "c": "x"}``: values as in TOML, bare words as text.

    Raises:
        ValueError: no ``=``.
    """
    result: dict[str, Any] = {}
    for setting in settings:
        key, equals, text = setting.partition("=")
        if not (key and equals):
            raise ValueError(f"--set needs KEY=VALUE, not {setting!r}")
        try:
            result[key] = tomllib.loads(f"value = {text}")["value"]
        except tomllib.TOMLDecodeError:
            result[key] = text
    return result
