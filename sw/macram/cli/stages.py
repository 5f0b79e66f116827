"""Progress: a spinner while a stage runs or a line when it begins, and a line with its seconds at its end."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext
from typing import Any

from rich.console import Console


class Stages:
    """Times named stages and says where the work is.

    Args:
        console: where to print; a terminal gets a spinner, anything else a line when a stage begins, so that
            a log shows what is going on. Either gets a line with the seconds when the stage is done.
        total: how many stages there will be, for ``[3/8]``; 0 leaves the count away.

    Attributes:
        done: name and seconds of every finished stage, in order.
    """

    def __init__(self, console: Console, total: int = 0) -> None:
        self.console = console
        self.total = total
        self.done: list[dict[str, Any]] = []

    @contextmanager
    def __call__(self, name: str) -> Iterator[None]:
        """Open the stage ``name``; nothing is recorded if it fails."""
        number = len(self.done) + 1
        prefix = f"[{number}/{self.total}] " if self.total else ""
        if self.console.is_terminal:
            waiting: AbstractContextManager[Any] = self.console.status(f"{prefix}{name} ...")
        else:
            waiting = nullcontext()
            self._print(f"{prefix}{name} ...")
        start = time.perf_counter()
        with waiting:
            yield
        seconds = time.perf_counter() - start
        self.done.append({"name": name, "seconds": round(seconds, 3)})
        dots = "." * max(2, 52 - len(name))
        self._print(f"{prefix}{name} {dots} {seconds:6.1f} s")

    def _print(self, line: str) -> None:
        self.console.print(line, highlight=False, markup=False, soft_wrap=True)
