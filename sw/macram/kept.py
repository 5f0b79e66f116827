"""Where what was built once is kept for the next time."""

from __future__ import annotations

import os
from pathlib import Path


def kept(name: str) -> Path:
    """``$MACRAM_BUILD_DIR/name``, else ``macram/name`` in ``$XDG_CACHE_HOME``, else in ``~/.cache``.

    Not below the current directory: the same thing would be built again in every folder somebody works in.

    Raises:
        RuntimeError: no variable says where, and nobody's home is known.
    """
    if chosen := os.environ.get("MACRAM_BUILD_DIR"):
        return (Path(chosen) / name).resolve()
    return cache() / name


def cache() -> Path:
    """``macram`` in ``$XDG_CACHE_HOME``, else in ``~/.cache``.

    Raises:
        RuntimeError: the variable does not say where, and nobody's home is known.
    """
    chosen = Path(os.environ.get("XDG_CACHE_HOME", ""))
    # The XDG specification says that a relative path is to be ignored.
    return (chosen if chosen.is_absolute() else Path.home() / ".cache") / "macram"
