"""Progress: a line per stage with its seconds, a spinner while it runs if somebody is watching."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from typing import Any

from rich.console import Console


class Stages:
    """Times named stages and prints a line when each is done.

    Args:
        console: where to print; a terminal gets a spinner and colour, anything else plain lines.
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
        waiting = self.console.status(f"{prefix}{name} ...") if self.console.is_terminal else nullcontext()
        start = time.perf_counter()
        with waiting:
            yield
        seconds = time.perf_counter() - start
        self.done.append({"name": name, "seconds": round(seconds, 3)})
        dots = "." * max(2, 52 - len(name))
        self.console.print(
            f"{prefix}{name} {dots} {seconds:6.1f} s", highlight=False, markup=False, soft_wrap=True
        )
