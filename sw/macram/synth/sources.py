"""The array's Verilog as Yosys takes it best: a copy with plain names and, if wanted, without memory contents."""

from __future__ import annotations

import hashlib
import re
import tempfile
from pathlib import Path

from macram.spec import ArrayConfig


def export_sources(config: ArrayConfig, folder: Path, *, contents: bool) -> list[str]:
    """Write the array's synthesisable Verilog into ``folder``.

    Args:
        config: the array.
        folder: exists.
        contents: keep the names of the memories' contents. Without them equal memories are one module.

    Returns:
        file names, all in ``folder``.
    """
    from macram_hw.export import export_verilog  # noqa: PLC0415

    rtl = folder / "rtl"
    export_verilog(config, rtl)
    names = [name for name in (rtl / "macram_top.f").read_text().split() if name.endswith(".v")]
    for name in names:
        text = plain_names((rtl / name).read_text())
        if not contents:
            text = re.sub(r'\.INIT_FILE\("[^"]*"\)', ".INIT_FILE()", text)
        (folder / name).write_text(text)
    return names


def design_hash(config: ArrayConfig) -> str:
    """SHA-256 of what `macram synth` reads for an array: equal as long as neither it nor the gateware has changed.

    The array's name and the contents of its memories are no part of it.
    """
    with tempfile.TemporaryDirectory() as scratch:
        return sources_hash(Path(scratch), export_sources(config, Path(scratch), contents=False))


def sources_hash(folder: Path, names: list[str]) -> str:
    """SHA-256 over files of ``folder`` in the order of ``names``, each with its name and length."""
    found = hashlib.sha256()
    for name in names:
        text = (folder / name).read_bytes()
        found.update(f"{name} {len(text)}\n".encode() + text)
    return found.hexdigest()


_TOKENS = {".": "_DOT_", "$": "_DOLLAR_"}


def plain_names(verilog: str) -> str:
    r"""Escaped identifiers as plain ones: ``\engine0.$5 `` -> ``engine0_DOT__DOLLAR_5``.

    ABC's way back into Yosys (abc9) stumbles over wires whose names begin with a dollar sign, as those do that
    Amaranth makes up (``Assert `count_id(wire->name) == 0' failed``).

    Raises:
        ValueError: two names would become one.
    """
    taken: dict[str, str] = {}

    def plain(match: re.Match[str]) -> str:
        name = re.sub(r"\W", lambda other: _TOKENS.get(other[0], f"_X{ord(other[0]):02X}_"), match[1])
        if taken.setdefault(name, match[1]) != match[1]:
            raise ValueError(
                f"identifiers {match[1]} and {taken[name]} would both be called {name}; rename one"
            )
        return f"{name} "

    return re.sub(r"\\(\S+) ", plain, verilog)


def spoken_name(name: str) -> str:
    """The name that `plain_names` made plain, as it was."""
    for character, token in _TOKENS.items():
        name = name.replace(token, character)
    return name
