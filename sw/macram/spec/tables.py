"""Fields of a configuration from plain values and from TOML, each fault in one line that names it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from macram.spec.formats import parse_format


def checked_values(table: dict[str, Any], known: dict[str, str]) -> dict[str, Any]:
    """Values by field, formats read from their text.

    Args:
        table: as it was read.
        known: field -> name of its type: ``int``, ``str`` or ``IntFormat``.

    Raises:
        ValueError: unknown key, or a value of the wrong kind; the line names the key and what it takes.
    """
    if not isinstance(table, dict):
        raise ValueError(f"array must be a table of fields, not {table!r}")
    if unknown := sorted(set(table) - set(known)):
        raise ValueError(f"unknown key {unknown[0]!r}; known are {', '.join(sorted(known))}")
    values = dict(table)
    for key, value in table.items():
        if known[key] == "IntFormat":
            try:
                values[key] = parse_format(value)
            except ValueError as error:
                raise ValueError(
                    f"{key} must be 'u' or 's' and a bit count of 2 to 8, such as 'u3', not {value!r}"
                ) from error
        elif known[key] == "int" and type(value) is not int:
            raise ValueError(f"{key} must be a whole number, not {value!r}")
        elif known[key] == "str" and not isinstance(value, str):
            raise ValueError(f"{key} must be a text in quotes, not {value!r}")
    return values


def read_table(path: Path, name: str) -> Any:
    """The table ``[name]`` of a TOML file.

    Raises:
        ValueError: naming the file and the fault.
    """
    import tomllib  # noqa: PLC0415 - not before Python 3.11, and boards have 3.10 but read no TOML

    try:
        tables = tomllib.loads(Path(path).read_text(encoding="utf-8"))
    except OSError as error:
        raise ValueError(f"{path}: cannot be read, {error.strerror}; name another file") from error
    except UnicodeDecodeError as error:
        raise ValueError(f"{path}: is not UTF-8 text; save it as such") from error
    except tomllib.TOMLDecodeError as error:
        raise ValueError(f"{path}: is not TOML: {error}") from error
    if name not in tables:
        raise ValueError(f"{path}: has no [{name}] table; put the fields under [{name}]")
    return tables[name]
