"""Where builds and jobs lie, and the lock that makes each build once."""

from __future__ import annotations

import fcntl
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


def build_root() -> Path:
    """``$MACRAM_BUILD_DIR/sim``, else ``macram/sim`` in ``$XDG_CACHE_HOME``, else in ``~/.cache``.

    Not below the current directory: the same array would be built again in every folder somebody works in.
    """
    if chosen := os.environ.get("MACRAM_BUILD_DIR"):
        return (Path(chosen) / "sim").resolve()
    cache = Path(os.environ.get("XDG_CACHE_HOME", ""))
    # The XDG specification says that a relative path is to be ignored.
    return (cache if cache.is_absolute() else Path.home() / ".cache") / "macram" / "sim"


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
