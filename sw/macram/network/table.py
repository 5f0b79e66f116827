"""Estimated and simulated cycles of every layer shape of a network, and of all its convolutions together."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from macram.designs import describe_layer
from macram.designs.losses import LOSSES
from macram.layer_job import CLOCK_HZ, COUNTERS
from macram.network.shapes import Shape
from macram.spec import ArrayConfig


@dataclass(frozen=True)
class NetworkTable:
    """Figures of an array's network, plain values.

    Attributes:
        array: the configuration.
        rows: one per distinct shape, see `shape_row`.
        total: over every convolution of a simulated shape, see `network_table`.
    """

    array: ArrayConfig
    rows: list[dict[str, Any]]
    total: dict[str, Any]

    @property
    def passed(self) -> bool:
        """Nothing that was simulated differs."""
        return all(row["passed"] is not False for row in self.rows)

    @property
    def complete(self) -> bool:
        """Every convolution is simulated."""
        return bool(self.total["simulated"] == self.total["convolutions"])


def network_table(
    array: ArrayConfig, shapes: Sequence[Shape], records: Mapping[Shape, Mapping[str, Any]]
) -> NetworkTable:
    """Rows and totals of a network on ``array``.

    Args:
        array: the configuration.
        shapes: all of the network's.
        records: of those that were simulated, see `macram.network.simulate_shape`.

    Returns:
        ``total`` has ``convolutions`` of the network, ``on_array``, ``simulated``, the ``estimated`` cycles of all
        that the array runs, and over those that were simulated, each as often as the network runs its shape: ``macs``,
        ``estimated_simulated``, ``cycles``, ``macs_per_cycle``, ``macs_per_cycle_per_dsp``, ``utilisation``, ``ms``,
        ``lost`` cycles, and the codes ``compared`` and ``mismatches`` of one run of each shape.
    """
    rows = [shape_row(shape, records.get(shape)) for shape in shapes]
    run = [row for row in rows if row["refused"] is None]
    done = [row for row in run if row["passed"] is not None]
    cycles, macs = _sum(done, "cycles"), _sum(done, "macs")
    rate = macs / cycles if cycles else None
    total: dict[str, Any] = {
        "convolutions": sum(row["count"] for row in rows),
        "on_array": sum(row["count"] for row in run),
        "simulated": sum(row["count"] for row in done),
        "estimated": _sum(run, "estimated"),
        "estimated_simulated": _sum(done, "estimated"),
        "macs": macs,
        "cycles": cycles,
        "macs_per_cycle": rate,
        "macs_per_cycle_per_dsp": rate / slices(array) if rate and slices(array) else None,
        "utilisation": rate / array.peak_macs if rate else None,
        "ms": 1e3 * cycles / CLOCK_HZ,
        "lost": {
            cause: sum(row["count"] * row["lost"][cause] for row in done)
            for cause in ("needed", *LOSSES, "total")
        },
        "compared": sum(row["compared"] for row in done),
        "mismatches": sum(row["mismatches"] for row in done),
    }
    return NetworkTable(array, rows, total)


def shape_row(shape: Shape, record: Mapping[str, Any] | None) -> dict[str, Any]:
    """One shape: the row of `macram.designs.describe_layer` and what its simulation found.

    Args:
        shape: of the layer.
        record: of its simulation, if there is one.

    Returns:
        Also ``count`` and ``names`` of the convolutions, ``estimated`` cycles, ``compared`` codes, ``mismatches``,
        ``macs_per_cycle_per_dsp`` and ``passed``: every code is equal, every cycle has a cause, and the cycles are the
        estimate's where that is exact; None where nothing was simulated. ``cycles`` are simulated ones, else estimated.
    """
    counters = None if record is None else record["counters"]
    row = describe_layer(shape.array, shape.names[0], shape.part, shape.spec, counters)
    estimate, rate, dsp = row["estimate"], row["macs_per_cycle"], slices(shape.array)
    row |= {
        "count": len(shape.names),
        "names": list(dict.fromkeys(shape.names)),
        "estimated": None if estimate is None else estimate["total"],
        "macs_per_cycle_per_dsp": rate / dsp if rate and dsp else None,
        "compared": None, "mismatches": None, "seconds": None, "passed": None,
    }  # fmt: skip
    if record is None or counters is None or estimate is None:
        return row
    caused = sum(counters[cause] for cause in COUNTERS) == counters["cycles"]
    as_estimated = counters["cycles"] == estimate["total"] or not estimate["exact"]
    return row | {
        "compared": record["compared"],
        "mismatches": record["mismatches"],
        "seconds": record["simulation_seconds"],
        "passed": record["mismatches"] == 0 and caused and as_estimated,
    }


def slices(array: ArrayConfig) -> int:
    """DSP slices of the row engines of all units; 0 for engines that are not built of named slices."""
    per_unit = array.row_kinds.count("dsp48e2") + array.paired_rows // 2
    return array.units * per_unit


def _sum(rows: Sequence[Mapping[str, Any]], key: str) -> int:
    """Over every convolution, not every shape."""
    return sum(row["count"] * row[key] for row in rows)
