"""What a run leaves to read: a CSV log, TensorBoard events, and a progress bar while it lasts."""

from __future__ import annotations

import csv
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

COLUMNS = (
    "step", "visits", "minutes", "lr", "size", "img_s", "loading", "loss", "class", "pose", "surface", "similarity",
    "ideal", "imitation", "grad_norm", "add_0.1", "add_0.2", "add_0.5", "misses",
)  # fmt: skip
"""Of log.csv. Losses are weighted; class, pose, surface and ideal per 8 images, others means. add_* and misses are
percentages of validation frames; loading is the percentage of the time since the last line in which this process read,
warped and labelled pictures."""


class Log:
    """Appends to ``log.csv`` and to TensorBoard, of which PyTorch finds the writer if it is installed.

    Args:
        folder: of the run.
        step: steps already done; later lines of an interrupted run are dropped.
    """

    def __init__(self, folder: Path, step: int) -> None:
        self.path = folder / "log.csv"
        kept = []
        if step and self.path.is_file():
            with self.path.open(newline="") as file:
                kept = [row for row in csv.DictReader(file) if int(row["step"]) <= step]
        with self.path.open("w", newline="") as file:
            writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
            writer.writeheader()
            writer.writerows(kept)
        self.board = _board(folder / "tensorboard", step)

    def line(self, values: Mapping[str, float | int]) -> None:
        """One line, keys from `COLUMNS`."""
        rounded = {k: v if isinstance(v, int) else float(f"{v:.6g}") for k, v in values.items()}
        with self.path.open("a", newline="") as file:
            csv.DictWriter(file, COLUMNS, lineterminator="\n").writerow(rounded)
        if self.board is not None:
            for name, value in values.items():
                if name not in ("step", "visits"):
                    self.board.add_scalar(name, value, int(values["step"]))

    def picture(self, name: str, image: NDArray[np.uint8], step: int) -> None:
        """An RGB picture ``[H, W, 3]`` for TensorBoard."""
        if self.board is not None:
            self.board.add_image(name, image, step, dataformats="HWC")
            self.board.flush()

    def close(self) -> None:
        """Writes what is buffered."""
        if self.board is not None:
            self.board.close()


def _board(folder: Path, step: int) -> Any:
    try:
        from torch.utils.tensorboard import SummaryWriter  # noqa: PLC0415
    except ImportError:
        return None
    return SummaryWriter(str(folder), purge_step=step + 1 if step else None)


class Bar:
    """Progress of a run: steps, loss, img/s, time left; a plain line every half minute without a terminal.

    Args:
        console: where to; None for silence.
        steps: of the run.
        start: steps already done.
        what: to call it.
    """

    EVERY_S = 30.0

    def __init__(self, console: Console | None, steps: int, start: int, what: str) -> None:
        self.console, self.steps, self.what = console, steps, what
        self.told = time.monotonic() - self.EVERY_S
        self.progress: Progress | None = None
        if console is not None and console.is_terminal:
            self.progress = Progress(
                TextColumn("{task.description}"),
                BarColumn(),
                MofNCompleteColumn(),
                TextColumn("loss {task.fields[loss]:.3f}, {task.fields[rate]:.0f} img/s"),
                TimeRemainingColumn(),
                console=console,
            )
            self.task = self.progress.add_task(
                what, total=steps, completed=start, loss=float("nan"), rate=0.0
            )
            self.progress.start()

    def advance(self, step: int) -> None:
        """After ``step`` steps; nothing new to tell."""
        if self.progress is not None:
            self.progress.update(self.task, completed=step)

    def update(self, step: int, loss: float, rate: float, seconds_left: float) -> None:
        """After ``step`` steps."""
        if self.progress is not None:
            self.progress.update(self.task, completed=step, loss=loss, rate=rate)
        elif self.console is not None and time.monotonic() - self.told >= self.EVERY_S:
            self.told = time.monotonic()
            self.say(
                f"{self.what}: step {step}/{self.steps}, loss {loss:.3f}, {rate:.1f} img/s, "
                f"{seconds_left / 60:.1f} min to go"
            )

    def packing(self, done: int, total: int) -> None:
        """Tells of ``done`` decoded frames of ``total``, once every half minute."""
        if time.monotonic() - self.told >= self.EVERY_S or done == total:
            self.told = time.monotonic()
            self.say(f"packing frames: {done}/{total}")

    def say(self, text: str) -> None:
        """A line of its own."""
        if self.console is not None:
            self.console.print(text, highlight=False, markup=False, soft_wrap=True)

    def close(self) -> None:
        """Leaves the bar as it stands."""
        if self.progress is not None:
            self.progress.stop()
