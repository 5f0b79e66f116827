"""Which reader a folder needs."""

from __future__ import annotations

from pathlib import Path

from macram.data.speed import Speed
from macram.data.swisscube import SwissCube

Dataset = SwissCube | Speed


def open_dataset(root: Path, shrink: int = 1) -> Dataset:
    """The reader for a folder: SPEED if it has a ``train.json``, else SwissCube or BOP.

    Both have ``splits``, ``model`` and ``frames(split)``.

    Raises:
        ValueError: no such folder, or no layout that is known.
    """
    return Speed(root, shrink=shrink) if (root / "train.json").is_file() else SwissCube(root, shrink=shrink)
