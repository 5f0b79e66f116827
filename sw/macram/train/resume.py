"""What a checkpoint and the run that goes on from it must have in common."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from torch import Tensor

FREE_TO_CHANGE = ("log", "run.out", "run.init", "data.cache", "schedule.max_minutes")
"""What a resumed run may have otherwise: it does not touch the numbers."""


def check_same_run(path: Path, mine: Mapping[str, Any], theirs: Mapping[str, Any]) -> None:
    """Refuses to resume with a configuration that would give other numbers.

    Args:
        path: of the checkpoint, for the message.
        mine: the configuration of the run, as nested tables.
        theirs: the checkpoint's.

    Raises:
        ValueError: a value differs that matters.
    """
    ours, stored = _flat(mine), _flat(theirs)
    for key in sorted(ours.keys() | stored.keys()):
        free = any(key == name or key.startswith(f"{name}.") for name in FREE_TO_CHANGE)
        if not free and ours.get(key) != stored.get(key):
            raise ValueError(f"{path}: was trained with {key} = {stored.get(key)!r}, not {ours.get(key)!r}")


def under(tensors: Mapping[str, Tensor], prefix: str) -> dict[str, Tensor]:
    """The tensors whose names begin with ``prefix``, without it."""
    return {name.removeprefix(prefix): value for name, value in tensors.items() if name.startswith(prefix)}


def _flat(table: Any, prefix: str = "") -> dict[str, Any]:
    """Nested tables as dotted keys; JSON and Python agree on the values."""
    result: dict[str, Any] = {}
    items = table.items() if isinstance(table, dict) else enumerate(table)
    for key, value in items:
        name = f"{prefix}{key}"
        if isinstance(value, dict) or (isinstance(value, list | tuple) and value):
            result |= _flat(value, f"{name}.")
        else:
            result[name] = list(value) if isinstance(value, tuple) else value
    return result
