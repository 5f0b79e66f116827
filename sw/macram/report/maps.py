"""Feature maps of integer codes as pictures."""

from __future__ import annotations

import io
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from macram.spec import IntFormat

Rgb = NDArray[np.uint8]


@cache
def _colours(name: str, count: int) -> Rgb:
    """``count`` evenly spaced colours of a matplotlib map, ``[count, 3]``."""
    from matplotlib import colormaps  # noqa: PLC0415

    colours = colormaps[name](np.linspace(0.0, 1.0, count))[:, :3]
    return np.asarray(np.rint(255 * colours), np.uint8)


def codes_rgb(codes: NDArray[np.integer], fmt: IntFormat) -> Rgb:
    """``[height, width]`` codes -> ``[height, width, 3]`` colours, one colour per level of ``fmt``."""
    return np.asarray(_colours("inferno", fmt.hi - fmt.lo + 1)[codes.astype(np.int64) - fmt.lo])


def difference_rgb(produced: NDArray[np.integer], expected: NDArray[np.integer], fmt: IntFormat) -> Rgb:
    """``produced - expected``: black where equal, blue below, red above."""
    span = fmt.hi - fmt.lo
    signed = produced.astype(np.int64) - expected.astype(np.int64)
    level = (80 + 175 * np.abs(signed) // span).astype(np.uint8)
    picture = np.zeros((*signed.shape, 3), np.uint8)
    picture[..., 0] = np.where(signed > 0, level, 0)
    picture[..., 2] = np.where(signed < 0, level, 0)
    picture[..., 1] = np.where(signed != 0, level // 4, 0)
    return picture


def png(picture: Rgb) -> bytes:
    """A picture as an optimised PNG without time stamp or comment."""
    buffer = io.BytesIO()
    Image.fromarray(picture).save(buffer, "PNG", optimize=True)
    return buffer.getvalue()


def lively_channels(maps: NDArray[np.integer], count: int) -> list[int]:
    """The ``count`` channels of ``[channels, height, width]`` codes that vary most, in channel order.

    Ties go to the lower channel, so the same codes always give the same pictures.
    """
    spread = maps.reshape(len(maps), -1).astype(np.float64).var(axis=1)
    return sorted(int(c) for c in np.argsort(-spread, kind="stable")[:count])


def contact_sheet(title: str, columns: list[str], rows: list[tuple[str, list[Rgb]]]) -> bytes:
    """Labelled pictures in a grid, as a PNG for a page or a README.

    Args:
        title: above the grid.
        columns: heading of each column; empty strings leave it away.
        rows: label at the left, then one picture per column.
    """
    from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: PLC0415
    from matplotlib.figure import Figure  # noqa: PLC0415

    high, wide = len(rows), len(columns)
    figure = Figure(figsize=(2.0 * wide + 0.5, 2.0 * high + 0.7), dpi=110, facecolor="white")
    FigureCanvasAgg(figure)
    axes: Any = figure.subplots(high, wide, squeeze=False)
    for y, (label, pictures) in enumerate(rows):
        for x, picture in enumerate(pictures):
            axis = axes[y][x]
            axis.imshow(picture, interpolation="nearest")
            axis.set_xticks([])
            axis.set_yticks([])
            for spine in axis.spines.values():
                spine.set_visible(False)
            if y == 0:
                axis.set_title(columns[x], fontsize=11, color="#333")
            if x == 0:
                axis.set_ylabel(label, fontsize=10, color="#333")
    figure.suptitle(title, fontsize=12, color="#111", fontweight="bold")
    figure.tight_layout(pad=0.6)
    buffer = io.BytesIO()
    # Matplotlib would write its version into the file; the picture should depend on the codes alone.
    figure.savefig(buffer, format="png", metadata={"Software": None})
    return buffer.getvalue()


def histogram(codes: NDArray[np.integer], fmt: IntFormat) -> list[dict[str, Any]]:
    """Share of every level of ``fmt``: rows with ``code``, ``count`` and ``share`` (sums to 1)."""
    counts = np.bincount(codes.astype(np.int64).ravel() - fmt.lo, minlength=fmt.hi - fmt.lo + 1)
    return [
        {"code": fmt.lo + index, "count": int(count), "share": float(count / codes.size)}
        for index, count in enumerate(counts)
    ]
