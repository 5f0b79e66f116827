"""How far a simulation is: its bench leaves the share in a file of the job folder, whoever started it looks there."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from threading import Event, Thread

FILE = "progress"
LOOK_SECONDS = 0.5


def leave_share(folder: Path, share: float) -> None:
    """Leave the share, 0 to 1, in the job folder; a reader never sees half a number."""
    begun = folder / f".{FILE}"
    begun.write_text(f"{share:.6f}")
    begun.replace(folder / FILE)


@contextmanager
def watching(folder: Path, told: Callable[[float], None] | None) -> Iterator[None]:
    """Call ``told`` with the share of the job in ``folder``, every half second, from a thread of its own."""
    if told is None:
        yield
        return
    over = Event()

    def look() -> None:
        while not over.wait(LOOK_SECONDS):
            with suppress(FileNotFoundError):
                told(float((folder / FILE).read_text()))

    (folder / FILE).unlink(missing_ok=True)
    thread = Thread(target=look, daemon=True)
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join()
