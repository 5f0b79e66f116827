"""Latency of the reference layer beside the figures the CA-SpaceNet paper prints in its table VI."""

from __future__ import annotations

from typing import Any

from macram.spec import ConvSpec

PAPER_TABLE_VI = (
    ("ARM v8.2", 26.16),
    ("Intel i7-8700K", 10.25),
    ("PIM accelerator on Ultra96v2, 100 MHz", 5.99),
)
"""Device and milliseconds, as printed."""
PAPER_PEAK_MACS = 201.6e9
"""Peak multiply-accumulates per second quoted for the paper's accelerator (Jiao et al., ASP-DAC 2021)."""
REFERENCE = ConvSpec(64, 128, 128, 128)
"""The layer of table VI: 64x128x128 input, 128x64x3x3 kernel, stride 1, padding 1."""

PAPER_NOTE = (
    "Nothing has been timed on silicon. The paper's 5.99 ms equals the layer's "
    "1,207,959,552 multiply-accumulates divided by 201.6e9 per second, the accelerator's peak rate, to every "
    "printed digit: it contains no fill, no drain and no stall, ours does."
)
NOTE = (
    "Ours is a simulation: cycles counted by the array's own registers in a cycle-accurate Verilator run, "
    f"multiplied by 10 ns. {PAPER_NOTE}"
)


def latency_report(layer: ConvSpec, milliseconds: float) -> dict[str, Any] | None:
    """Our latency beside the paper's, or None for a layer that table VI does not measure."""
    if layer_shape(layer) != layer_shape(REFERENCE):
        return None
    rows: list[dict[str, Any]] = [
        {"device": name, "ms": ms, "kind": "printed in the paper"} for name, ms in PAPER_TABLE_VI
    ]
    rows.append({"device": "this array at 100 MHz", "ms": milliseconds, "kind": "simulated cycles"})
    for row in rows:
        row["speedup"] = row["ms"] / milliseconds
    return {
        "source": "CA-SpaceNet, table VI",
        "rows": rows,
        "paper_ms_from_peak_rate": 1e3 * layer.macs / PAPER_PEAK_MACS,
        "note": NOTE,
    }


def layer_shape(layer: ConvSpec) -> tuple[int, ...]:
    """What table VI fixes: channels, size, kernel, stride, padding."""
    return (
        layer.c_in, layer.c_out, layer.height, layer.width, layer.kernel, layer.stride, layer.padding,
    )  # fmt: skip
