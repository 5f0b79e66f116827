"""The array that is exported unless another is named: the fastest that fits the board's device."""

from __future__ import annotations

from pathlib import Path

from macram.spec import ArrayConfig

NAME = "zu3eg.toml"
PLACES = (
    Path(__file__).parents[1] / "configs" / NAME,
    Path(__file__).resolve().parents[3] / "configs" / NAME,
)
"""Of an installed package; of a repository."""


def default_array() -> ArrayConfig:
    """The array of ``configs/zu3eg.toml``.

    Raises:
        ValueError: the file is missing or faulty.
    """
    path = next((place for place in PLACES if place.is_file()), PLACES[-1])
    return ArrayConfig.from_toml(path)
