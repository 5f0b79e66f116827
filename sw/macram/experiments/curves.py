"""Learning curves of every record in one picture."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from pathlib import Path
from typing import Any

COLOURS = 10
"""That matplotlib has; then lines are dashed and points hollow."""
DASHES = ("-", "--", ":")


def curves_svg(curves: Sequence[tuple[str, Path]]) -> bytes:
    """Pose loss and validation accuracy over the images seen, as SVG.

    Args:
        curves: name and ``curve.csv`` of each record.
    """
    import matplotlib as mpl  # noqa: PLC0415
    from matplotlib.backends.backend_svg import FigureCanvasSVG  # noqa: PLC0415
    from matplotlib.figure import Figure  # noqa: PLC0415

    figure = Figure(figsize=(12.0, 4.2), facecolor="white")
    FigureCanvasSVG(figure)
    axes: Any = figure.subplots(1, 2)
    for number, (name, path) in enumerate(curves):
        rows = _rows(path)
        look = {"color": f"C{number % COLOURS}", "linestyle": DASHES[number // COLOURS % len(DASHES)]}
        for axis, column, marker in ((axes[0], "pose", ""), (axes[1], "add_0.1", "o")):
            points = [(float(row["visits"]), float(row[column])) for row in rows if row[column]]
            if points:
                x, y = zip(*points, strict=True)
                filled = "full" if number < COLOURS else "none"
                axis.plot(
                    x, y, marker=marker, fillstyle=filled, linewidth=1.3, markersize=4, label=name, **look
                )
    axes[0].set(xlabel="images of this stage", ylabel="pose loss per 8 images", yscale="log")
    axes[1].set(xlabel="images of this stage", ylabel="ADD-0.1d on validation frames (%)", ylim=(0, None))
    for axis in axes:
        axis.grid(True, color="#e6e6e6", linewidth=0.7)
        axis.spines[["top", "right"]].set_visible(False)
    figure.legend(*axes[0].get_legend_handles_labels(), loc="center right", fontsize=7, frameon=False)
    figure.tight_layout(rect=(0, 0, 0.8, 1))
    buffer = io.BytesIO()
    # Neither a date nor random ids: the same records give the same bytes.
    with mpl.rc_context({"svg.hashsalt": "macram"}):
        figure.savefig(buffer, format="svg", metadata={"Date": None, "Creator": None})
    return buffer.getvalue()


def _rows(path: Path) -> list[dict[str, str]]:
    with path.open(newline="") as file:
        return list(csv.DictReader(file))
