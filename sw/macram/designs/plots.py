"""Pictures of designs: roofline of the layers, and bars beside the paper's table VI and published peers."""

from __future__ import annotations

import io
from collections.abc import Sequence
from typing import Any

from macram.designs.design import Design
from macram.designs.peers import PEERS
from macram.report.latency import PAPER_TABLE_VI

COLOURS = ("#2f7fc1", "#17917a", "#e0a100", "#b565a7", "#d1495b", "#5b6875")
MARKERS = {"first": "x", "backbone": "o", "pyramids": "s", "head": "^", "": "D"}
THEIRS = "#a9b3bd"


def roofline_png(design: Design) -> bytes:
    """Rate of every layer over the products that a beat of its busier stream feeds; some layer must run."""
    rows = design.rows
    figure, axis = figure_of(7.6, 4.8)
    peak = design.array.peak_macs
    reach = [min(row["macs_per_beat"] for row in rows) / 2, max(row["macs_per_beat"] for row in rows) * 2]
    reach = [min(reach[0], peak / 4), max(reach[1], peak * 4)]
    axis.plot([reach[0], peak, reach[1]], [reach[0], peak, peak], color="#333", linewidth=1.4)
    axis.text(reach[1], peak * 1.06, f"{peak:,} MAC per cycle", ha="right", fontsize=8, color="#333")
    axis.text(reach[0] * 1.15, reach[0] * 1.6, "one beat per cycle", rotation=33, fontsize=8, color="#333")
    for colour, part in zip(COLOURS, ("backbone", "pyramids", "head"), strict=False):
        mine = [row for row in rows if row["part"] == part]
        for kernel, fill in ((3, colour), (1, "white")):
            shown = [row for row in mine if row["kernel"] == kernel]
            if shown:
                axis.scatter(
                    [row["macs_per_beat"] for row in shown], [row["macs_per_cycle"] for row in shown],
                    s=34, marker=MARKERS[part], facecolors=fill, edgecolors=colour,
                    label=f"{part}, {kernel}x{kernel}",
                )  # fmt: skip
    reference = design.reference
    if reference["refused"] is None:
        axis.scatter(
            [reference["macs_per_beat"]], [reference["macs_per_cycle"]],
            s=70, marker="*", color="#d1495b", label="reference layer", zorder=3,
        )  # fmt: skip
    axis.set(xscale="log", yscale="log", xlim=reach, ylim=(None, peak * 1.5))
    axis.set(xlabel="MAC per beat of the busier image stream", ylabel="MAC per cycle")
    axis.set_title(f"Roofline of {design.array.name}", fontsize=11)
    axis.legend(fontsize=8, frameon=False, loc="lower right")
    return png_of(figure)


def latency_png(designs: Sequence[Design]) -> bytes:
    """The reference layer in milliseconds, beside the rows of the paper's table VI."""
    rows = [(name, ms, THEIRS) for name, ms in PAPER_TABLE_VI]
    for design in designs:
        if design.reference["ms"] is not None:
            how = "simulated" if design.reference["simulated"] else "closed form"
            rows.append((f"{design.array.name} ({how})", design.reference["ms"], COLOURS[0]))
    return _bars(
        rows, "ms at 100 MHz, or as printed in the paper", "Reference layer, 1,207,959,552 MAC", ".2f"
    )


def density_png(designs: Sequence[Design], kind: str) -> bytes:
    """Multiply-accumulates per cycle and DSP slice or thousand LUTs, beside published engines.

    Args:
        designs: those without counts are left out, like peers that publish none.
        kind: ``dsp`` or ``klut``.
    """
    unit = {"dsp": "DSP slice", "klut": "thousand LUTs"}[kind]
    bars = [(f"{peer.name} ({peer.bits} bit)", peer.density(kind), THEIRS) for peer in PEERS]
    bars += [(_label(design, kind), design.density[f"macs_per_{kind}"], COLOURS[0]) for design in designs]
    rows = [(name, value, colour) for name, value, colour in bars if value is not None]
    return _bars(rows, f"MAC per cycle and {unit}", f"Density per {unit}", ".1f")


def _label(design: Design, kind: str) -> str:
    doubled = kind == "dsp" and design.array.paired_rows
    return f"{design.array.name} ({design.array.weight.bits} bit{', slices at twice the clock' if doubled else ''})"


def _bars(rows: Sequence[tuple[str, float, str]], label: str, title: str, form: str) -> bytes:
    figure, axis = figure_of(7.6, 0.9 + 0.36 * len(rows))
    places = range(len(rows))
    axis.barh(places, [value for _, value, _ in rows], color=[colour for *_, colour in rows], height=0.68)
    for place, (_, value, _) in enumerate(rows):
        axis.text(value, place, f" {value:{form}}", va="center", fontsize=9)
    axis.set_yticks(places, [name for name, *_ in rows], fontsize=9)
    axis.invert_yaxis()
    axis.margins(x=0.12)
    axis.set_xlabel(label, fontsize=9)
    axis.set_title(title, fontsize=11)
    return png_of(figure)


def figure_of(width: float, height: float) -> tuple[Any, Any]:
    """An empty figure of so many inches, and its axes."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: PLC0415
    from matplotlib.figure import Figure  # noqa: PLC0415

    figure = Figure(figsize=(width, height), dpi=120, facecolor="white")
    FigureCanvasAgg(figure)
    axis: Any = figure.subplots()
    axis.spines[["top", "right"]].set_visible(False)
    axis.grid(True, color="#e6e6e6", linewidth=0.7)
    axis.set_axisbelow(True)
    return figure, axis


def png_of(figure: Any) -> bytes:
    """A figure as PNG, the same bytes for the same figures."""
    figure.tight_layout(pad=1.0)
    buffer = io.BytesIO()
    # Without matplotlib's version the picture depends on the figures alone.
    figure.savefig(buffer, format="png", metadata={"Software": None})
    return buffer.getvalue()
