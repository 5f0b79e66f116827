"""When a run ends early: its clock, and requests to stop."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any


class Clock:
    """Minutes of this run, those before a resumption included."""

    def __init__(self, minutes: float) -> None:
        self.start = time.monotonic() - 60 * minutes

    @property
    def minutes(self) -> float:
        """Until now."""
        return (time.monotonic() - self.start) / 60


@contextmanager
def stop_on_signal() -> Iterator[threading.Event]:
    """While open, the first SIGINT or SIGTERM asks to stop after the step; a second one acts as ever."""
    stop = threading.Event()
    if threading.current_thread() is not threading.main_thread():
        yield stop
        return
    before = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)}

    def ask(number: int, frame: Any) -> None:
        stop.set()
        for n, handler in before.items():
            signal.signal(n, handler)

    for number in before:
        signal.signal(number, ask)
    try:
        yield stop
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
