"""LUTs of an array that was not synthesised: a linear estimate from units and arrays that were, with its error."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from macram.spec import ArrayConfig
from macram.synth.cost import UNIT

COUNTS = "unit_counts.json"
"""Counts that come with the package, written by ``macram designs --search xczu3eg --recount``."""
MEMORY = "macram_ram"
TERMS = ("a unit", "DSP slice", "DSP slice at twice the clock", "soft row engine")


@dataclass(frozen=True, eq=False)
class LutModel:
    """``units * (fixed + slices + soft rows) + shell``, each with LUTs of its own.

    The `TERMS` of a unit are the least squares over the counted units. The shell, all that is outside the units, is
    linear in the width of a line-buffer word, through the counted arrays; the requantiser's words, where they lie in
    LUTs, count as they did there. What a shell gains with the number of units is left out.

    Attributes:
        unit_terms: LUTs of each of `TERMS`.
        shell_terms: LUTs of any shell, and per row engine of a unit.
        requant_lut: LUTs of the requantiser's words in LUTs.
        shell_dsp: most DSP slices outside the units in a counted array.
        units: counted units with ``estimate``.
        arrays: counted arrays with ``estimate``.
    """

    unit_terms: NDArray[np.float64]
    shell_terms: NDArray[np.float64]
    requant_lut: float
    shell_dsp: int
    units: Sequence[dict[str, Any]]
    arrays: Sequence[dict[str, Any]]

    @classmethod
    def fit(cls, counts: Mapping[str, Any]) -> LutModel:
        """From ``units`` (``kinds`` of the row engines, ``lut``) and ``arrays`` (`shell_of`) of a table of counts."""
        rows = np.array([_terms(unit["kinds"]) for unit in counts["units"]])
        unit_terms = np.linalg.lstsq(rows, np.array([unit["lut"] for unit in counts["units"]]), rcond=None)[0]
        shells = counts["arrays"]
        design = np.array([[1.0, shell["array"]["rows"]] for shell in shells])
        shell_terms = np.linalg.lstsq(design, np.array([shell["shell_lut"] for shell in shells]), rcond=None)[
            0
        ]
        model = cls(
            unit_terms,
            shell_terms,
            max(shell["memory_lut"] for shell in shells),
            max(int(shell["shell_dsp"]) for shell in shells),
            [
                dict(unit, estimate=float(row @ unit_terms))
                for unit, row in zip(counts["units"], rows, strict=True)
            ],
            [],
        )
        arrays = [dict(shell, estimate=model.luts(ArrayConfig.from_dict(shell["array"]))) for shell in shells]
        return cls(unit_terms, shell_terms, model.requant_lut, model.shell_dsp, model.units, arrays)

    def luts(self, array: ArrayConfig) -> float:
        """Estimated LUTs of ``array``."""
        shell = self.shell_terms @ np.array([1.0, array.rows])
        memory = self.requant_lut if array.requant_ram == "distributed" else 0.0
        return float(array.units * (np.array(_terms(array.row_kinds)) @ self.unit_terms) + shell + memory)

    @property
    def worst(self) -> float:
        """Largest error over the counted units and arrays, as a share of the count."""
        pairs = [(unit["estimate"], unit["lut"]) for unit in self.units]
        pairs += [(array["estimate"], array["lut"]) for array in self.arrays]
        return max(abs(float(estimate) / float(count) - 1) for estimate, count in pairs)


def shell_of(report: Mapping[str, Any]) -> dict[str, Any]:
    """What the model takes of a hierarchical report of ``macram synth``."""
    modules = {row["name"]: row for row in report["modules"]}
    unit, memory = modules[UNIT], modules[MEMORY]
    return {
        "array": report["array"], "design": report["design"], "lut": report["total"]["lut"],
        "shell_lut": report["total"]["lut"] - unit["lut"] - memory["lut"], "memory_lut": memory["lut"],
        "shell_dsp": report["total"]["dsp"] - unit["dsp"],
    }  # fmt: skip


def unit_of(report: Mapping[str, Any]) -> dict[str, Any]:
    """The unit of such a report as a counted unit."""
    (row,) = (row for row in report["modules"] if row["name"] == UNIT)
    kinds = ArrayConfig.from_dict(report["array"]).row_kinds
    return {"kinds": list(kinds), "lut": row["lut"] / row["instances"]}


def read_counts(path: Path | None = None) -> dict[str, Any]:
    """The package's table of counts, or another one.

    Raises:
        ValueError: the file is no such table.
    """
    source = path or resources.files("macram.designs") / COUNTS
    try:
        table: dict[str, Any] = json.loads(source.read_text(encoding="utf-8"))
        if len(table["units"]) < len(TERMS) or len(table["arrays"]) < 2:
            raise ValueError("too few counts")
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise ValueError(
            f"{source} is no table of counts; write it with macram designs --search xczu3eg --recount"
        ) from error
    return table


def _terms(kinds: Sequence[str]) -> list[float]:
    """Values of `TERMS` for a unit."""
    counts = [kinds.count("dsp48e2"), kinds.count("dsp48e2_2x") / 2, kinds.count("soft")]
    return [1.0, *map(float, counts)]
