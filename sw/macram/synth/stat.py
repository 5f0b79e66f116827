"""Reading what Yosys' ``stat -json`` counts."""

from __future__ import annotations

import json
import re
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from macram.synth.sources import spoken_name


@dataclass(frozen=True, slots=True)
class ModuleCells:
    """One module of a netlist.

    Attributes:
        cells: type -> number of the primitive cells directly in it.
        children: module -> number of instances directly in it.
    """

    cells: dict[str, int]
    children: dict[str, int]


def read_stat(path: Path) -> dict[str, ModuleCells]:
    """Module name, without the leading backslash, -> its cells.

    Raises:
        ValueError: the file is not such a statistic.
    """
    try:
        modules: dict[str, dict[str, Any]] = json.loads(path.read_text())["modules"]
        names = {name.removeprefix("\\") for name in modules}
        found = {}
        for name, table in modules.items():
            # Newer versions list submodules apart, older ones among the cells.
            listed = Counter(table["num_cells_by_type"]) + Counter(table.get("num_submodules_by_type", {}))
            plain = {cell.removeprefix("\\"): number for cell, number in listed.items()}
            found[name.removeprefix("\\")] = ModuleCells(
                {cell: number for cell, number in plain.items() if cell not in names},
                {cell: number for cell, number in plain.items() if cell in names},
            )
    except (OSError, KeyError, TypeError, AttributeError, json.JSONDecodeError) as error:
        raise ValueError(f"{path} is no JSON statistic of Yosys; run the synthesis again") from error
    return found


def instances(modules: dict[str, ModuleCells], top: str) -> Counter[str]:
    """How often each module occurs in the whole design below ``top``, itself once.

    Raises:
        ValueError: there is no module ``top``.
    """
    if top not in modules:
        raise ValueError(f"the statistic has no module {top}; it has {', '.join(sorted(modules))}")
    found: Counter[str] = Counter()

    def visit(name: str, times: int) -> None:
        found[name] += times
        for child, number in modules[name].children.items():
            visit(child, times * number)

    visit(top, 1)
    return found


def short_name(module: str) -> str:
    """A module's name for people; the units' numbers and parameter hashes go, so that equal modules share a row."""
    module = spoken_name(module)
    if parameter := re.match(r"\$paramod\$[0-9a-f]+\\(.*)", module):
        return parameter[1]
    return re.sub(r"\bunit\d{3}\b", "unitNNN", module.removeprefix("macram_top.").removeprefix("array."))
