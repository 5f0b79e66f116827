"""Where builds and jobs lie, and the lock that makes each build once."""

from __future__ import annotations

import fcntl
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from macram.kept import kept


def build_root() -> Path:
    """Of everything simulated: ``$MACRAM_BUILD_DIR/sim``, or where `macram.kept` has it else."""
    return kept("sim")


def job_folder(name: str) -> Path:
    """A new empty folder in ``build_root() / "jobs"`` for the files of one simulation; its caller removes it."""
    jobs = build_root() / "jobs"
    jobs.mkdir(parents=True, exist_ok=True)
    return Path(tempfile.mkdtemp(prefix=f"{name}-", dir=jobs))


@contextmanager
def gone_if_interrupted(folder: Path) -> Iterator[None]:
    """Removes a job's folder where somebody stops the simulation: what stays is for looking into failures."""
    try:
        yield
    except KeyboardInterrupt:
        shutil.rmtree(folder, ignore_errors=True)
        raise


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """Only one process at a time builds the same thing; the next one finds it done."""
    with path.open("w") as handle:
        fcntl.flock(handle, fcntl.LOCK_EX)
        yield
