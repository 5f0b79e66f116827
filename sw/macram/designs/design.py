"""What is known of one array: cycles of the reference layer and of every layer of a network, resources, densities."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from macram.designs.losses import LOSSES, lost_cycles
from macram.perf import estimate_passes, pixel_in_cycles, pixel_out_cycles
from macram.report.latency import REFERENCE
from macram.spec import ArrayConfig, ConvSpec

CLOCK_HZ = 100_000_000
"""The clock of the paper's accelerator; all milliseconds are cycles at this clock."""


@dataclass(frozen=True)
class Design:
    """One array with its figures, all plain values.

    Attributes:
        array: the configuration.
        reference: row of the reference layer, see `describe_layer`; its ``simulated`` is the array's own counters.
        layers: rows of a network's layers in order; empty without a network.
        network: totals over ``layers``.
        resources: from synthesis, see `macram.designs.resources.find_resources`; None where not synthesised.
    """

    array: ArrayConfig
    reference: dict[str, Any]
    layers: tuple[dict[str, Any], ...]
    network: dict[str, Any]
    resources: dict[str, Any] | None

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The reference layer and the network's layers, without those that the array refuses."""
        return [row for row in (self.reference, *self.layers) if row["refused"] is None]

    @property
    def density(self) -> dict[str, float | None]:
        """Multiply-accumulates per cycle of the reference layer, per DSP and per thousand LUTs."""
        rate = self.reference["macs_per_cycle"]
        have = self.resources or {}
        return {
            "macs_per_cycle": rate,
            "macs_per_dsp": rate / have["dsp"] if rate and have.get("dsp") else None,
            "macs_per_klut": 1e3 * rate / have["lut"] if rate and have.get("lut") else None,
        }

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON."""
        return {
            "name": self.array.name,
            "array": self.array.to_dict() | {"peak_macs_per_cycle": self.array.peak_macs},
            "reference": self.reference,
            "density": self.density,
            "resources": self.resources,
            "network": self.network,
            "layers": list(self.layers),
        }


def describe(
    array: ArrayConfig,
    runs: Iterable[Mapping[str, Any]] = (),
    *,
    simulated: Mapping[str, Any] | None = None,
    resources: dict[str, Any] | None = None,
) -> Design:
    """Everything about ``array``.

    Args:
        array: the configuration.
        runs: convolutions of a network: ``name``, ``part`` and the shape fields of `ConvSpec`.
        simulated: counters of the reference layer's simulation, by lower-case register name.
        resources: from synthesis, see `macram.designs.resources.find_resources`.
    """
    reference = describe_layer(array, "reference", "", REFERENCE, simulated)
    layers = tuple(describe_layer(array, str(run["name"]), str(run["part"]), _shape(run)) for run in runs)
    return Design(array, reference, layers, _totals(layers), resources)


def describe_layer(
    array: ArrayConfig, name: str, part: str, layer: ConvSpec, simulated: Mapping[str, Any] | None = None
) -> dict[str, Any]:
    """One layer on one array; a layer that the array refuses has the reason in ``refused`` and no cycles.

    The formats are the array's: only the shape of ``layer`` counts. Cycles are those of all passes
    together, without loads that do not hide behind a run.
    """
    layer = dataclasses.replace(layer, weight=array.weight, input=array.input, output=array.output)
    row: dict[str, Any] = {
        "name": name, "part": part, "c_in": layer.c_in, "c_out": layer.c_out, "height": layer.height,
        "width": layer.width, "kernel": layer.kernel, "stride": layer.stride, "macs": layer.macs,
        "macs_per_beat": layer.macs / max(beats_in(layer, array), beats_out(layer, array)),
        "refused": None, "passes": None, "cycles": None, "macs_per_cycle": None, "utilisation": None, "ms": None,
        "estimate": None, "simulated": None, "lost": None,
    }  # fmt: skip
    try:
        passes = estimate_passes(layer, array)
    except ValueError as error:
        return row | {"refused": str(error)}
    total = sum(part.total for part in passes)
    row["passes"] = len(passes)
    row["estimate"] = {
        **{
            cause: sum(getattr(part, cause) for part in passes) for cause in ("fill", "mac", "stall", "drain")
        },
        "limited_by": passes[0].limited_by,
        "total": total,
        "exact": all(part.exact for part in passes),
    }
    if simulated is not None:
        row["simulated"], total = dict(simulated), simulated["cycles"]
    row |= {
        "cycles": total,
        "macs_per_cycle": layer.macs / total,
        "utilisation": layer.macs / (total * array.peak_macs),
        "ms": 1e3 * total / CLOCK_HZ,
    }
    return row | {"lost": lost_cycles(row, array.peak_macs)}


def beats_in(layer: ConvSpec, array: ArrayConfig) -> int:
    """Cycles that the input stream alone needs."""
    return layer.height * layer.width * pixel_in_cycles(layer, array)


def beats_out(layer: ConvSpec, array: ArrayConfig) -> int:
    """Cycles that the output stream alone needs."""
    return layer.out_height * layer.out_width * pixel_out_cycles(layer, array)


def _shape(run: Mapping[str, Any]) -> ConvSpec:
    kernel = run["kernel"]
    return ConvSpec(
        run["c_in"], run["c_out"], run["height"], run["width"],
        kernel=kernel, stride=run["stride"], padding=kernel // 2,
    )  # fmt: skip


def _totals(rows: tuple[dict[str, Any], ...]) -> dict[str, Any]:
    run = [row for row in rows if row["refused"] is None]
    cycles, macs = sum(row["cycles"] for row in run), sum(row["macs"] for row in run)
    return {
        "layers": len(rows), "on_array": len(run), "macs": sum(row["macs"] for row in rows),
        "macs_on_array": macs, "cycles": cycles, "ms": 1e3 * cycles / CLOCK_HZ,
        "macs_per_cycle": macs / cycles if cycles else None,
        "lost": {cause: sum(row["lost"][cause] for row in run) for cause in ("needed", *LOSSES, "total")},
    }  # fmt: skip
