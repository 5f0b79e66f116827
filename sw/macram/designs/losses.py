"""Where the cycles of a layer go: those that the arithmetic needs, and what each cause adds to them."""

from __future__ import annotations

from typing import Any

LOSSES = ("unused", "fill", "stall", "drain")
"""Causes. ``unused``: engines without work in compute steps, because channels, columns or the kernel do not fill them;
``fill``: before the first step; ``stall``: between steps, for input, drain or output; ``drain``: after the last."""


def lost_cycles(row: dict[str, Any], peak_macs: int) -> dict[str, float]:
    """Cycles of a row of `macram.designs.describe_layer` by cause; ``needed`` and all causes add up to ``total``.

    Args:
        row: of a layer that the array runs.
        peak_macs: multiply-accumulates per cycle of the array at most.

    Returns:
        ``needed`` (the layer's multiply-accumulates at the peak), every one of `LOSSES`, and ``total``. The array's
        own counters where the layer was simulated, else the closed form.
    """
    counted, parts = row["simulated"], row["estimate"]
    if counted is None:
        mac, fill, stall, drain = (parts[name] for name in ("mac", "fill", "stall", "drain"))
    else:
        mac, fill, drain = (counted[f"{name}_cycles"] for name in ("mac", "fill", "drain"))
        stall = counted["input_stalls"] + counted["output_stalls"]
    needed = row["macs"] / peak_macs
    return {
        "needed": needed,
        "unused": mac - needed,
        "fill": fill,
        "stall": stall,
        "drain": drain,
        "total": row["cycles"],
    }
