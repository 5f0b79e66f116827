"""Tables, as TOML and JSON have them, into dataclasses: unknown keys and wrong types are named, not ignored."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import MISSING, fields
from pathlib import Path
from types import NoneType
from typing import Any, get_args, get_origin, get_type_hints


def read_table(path: Path, overrides: Mapping[str, Any] | None = None) -> dict[str, Any]:
    """A TOML file as nested tables.

    Args:
        path: the file.
        overrides: dotted keys and values over the file's, such as ``{"schedule.steps": 10}``.

    Raises:
        ValueError: no such file, not TOML, or an override below something that is no table.
    """
    try:
        table = tomllib.loads(path.read_text())
    except FileNotFoundError:
        raise ValueError(f"{path}: no such configuration") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise ValueError(f"{path}: not valid TOML ({error})") from None
    for key, value in (overrides or {}).items():
        *parents, last = key.split(".")
        place = table
        for parent in parents:
            place = place.setdefault(parent, {})
            if not isinstance(place, dict):
                raise ValueError(f"{path}: cannot set {key}, {parent} is no table")
        place[last] = value
    return table


def build(kind: type, values: Any, name: str = "") -> Any:
    """A dataclass from a table, its parts likewise.

    Integers count as floats, and lists as tuples.

    Args:
        kind: the dataclass; fields are dataclasses, scalars, tuples of either, or tuples that may be None.
        values: the table.
        name: of the table, for messages.

    Raises:
        ValueError: a key is unknown or missing, a value has the wrong type, or the dataclass refuses it.
    """
    prefix = f"{name}." if name else ""
    if not isinstance(values, Mapping):
        raise ValueError(f"{name} must be a table, not {values!r}")
    hints = get_type_hints(kind)
    known = {field.name: field for field in fields(kind)}
    if unknown := sorted(set(values) - set(known)):
        raise ValueError(f"{prefix}{unknown[0]} is unknown; known are {', '.join(known)}")
    for key, field in known.items():
        if key not in values and field.default is MISSING and field.default_factory is MISSING:
            raise ValueError(f"{prefix}{key} is missing")
    return kind(**{key: _value(hints[key], value, prefix + key) for key, value in values.items()})


def _value(hint: Any, value: Any, name: str) -> Any:
    if NoneType in get_args(hint):
        if value is None:
            return None
        hint = next(kind for kind in get_args(hint) if kind is not NoneType)
    if get_origin(hint) is tuple:
        if not isinstance(value, list | tuple):
            raise ValueError(f"{name} must be a list, not {value!r}")
        return tuple(_value(get_args(hint)[0], entry, name) for entry in value)
    if hasattr(hint, "__dataclass_fields__"):
        return build(hint, value, name)
    # A choice of words is checked by the dataclass that has it.
    kind = hint if isinstance(hint, type) else str
    if kind is float and isinstance(value, int) and not isinstance(value, bool):
        return float(value)
    if not isinstance(value, kind) or (kind is not bool and isinstance(value, bool)):
        raise ValueError(f"{name} must be of type {kind.__name__}, not {value!r}")
    return value
