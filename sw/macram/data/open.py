"""Which reader a folder needs."""

from __future__ import annotations

from pathlib import Path

from macram.data.files import read_object
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


def dataset_version(root: Path) -> str:
    """``cubesat1u-v1, poses 54cdb1823...`` of a complete rendered set, else the name of the folder."""
    about = read_object(root / "dataset.json") if (root / "dataset.json").is_file() else {}
    if "poses_sha256" in about and "version" in about:
        return f"{about['version']}, poses {str(about['poses_sha256'])[:12]}"
    return root.name
