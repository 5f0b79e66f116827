"""A picture's way through the simulated array as JSON, Markdown, one HTML page and the picture with its pose."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from macram.layer_job import CLOCK_HZ
from macram.network.page import page_text
from macram.network.picture import PictureRun
from macram.report.files import write_bytes, write_json, write_text
from macram.report.maps import png
from macram.report.page import inline_png, page_environment
from macram.spec import ArrayConfig

HEAD = (
    "makes", "shape", "kernel", "codes in", "out", "leaves", "passes", "estimated", "simulated", "with loads",
    "compared", "differ", "MAC/cycle", "of peak", "ms",
)  # fmt: skip
LEFT = {0, 1, 2, 3, 4, 5}
"""Columns of text."""
NOTE = (
    "Every convolution's input is what the array gave before it; the host adds residual streams and looks codes up in "
    "tables, in integers. Where the array has no output codes of a convolution's format, its exact sums leave it and "
    "the host requantises them, or takes them as predictions. Compared: with the deployed network in PyTorch. Cycles "
    "as the array counts them; with loads: from the end of the convolution before, register accesses and those loads "
    "included that did not hide behind it. ms: of the counted cycles at 100 MHz."
)


def write_picture(
    folder: Path, run: PictureRun, array: ArrayConfig, *, network: str, command: str, about: dict[str, Any]
) -> Path:
    """Write ``picture.json``, ``picture.md``, ``picture.html`` and ``picture.png`` into an existing folder.

    Args:
        folder: where to.
        run: what came out.
        array: on which it ran.
        network: what was run, in words.
        command: what to type to get the same again.
        about: design, versions and machine, for the JSON.

    Returns:
        The page.

    Raises:
        OSError: the folder is missing or not writable.
    """
    title, picture = f"{array.name}: a picture through every convolution", png(run.picture)
    write_bytes(folder / "picture.png", picture)
    write_json(
        folder / "picture.json",
        {
            "format": 1, "command": command, "network": network, "passed": run.passed, **run.report,
            "array": array.to_dict() | {"peak_macs_per_cycle": array.peak_macs},
            "total": totals(run.rows), "convolutions": run.rows, **about,
        },
    )  # fmt: skip
    rows = cells(run.rows, array)
    text = summary(run)
    write_text(
        folder / "picture.md", page_text(f"{title} ({network})", command, text, (HEAD, LEFT, rows), NOTE)
    )
    page = page_environment().get_template("network.html.j2").render(
        title=title, network=network, command=command, file="picture.json", summary=text, note=NOTE,
        head=HEAD, left=LEFT, rows=rows, picture=inline_png(picture),
    )  # fmt: skip
    write_text(folder / "picture.html", page)
    return folder / "picture.html"


def totals(rows: list[dict[str, Any]]) -> dict[str, int]:
    """Sums over all convolutions."""
    keys = ("macs", "passes", "estimated", "cycles", "elapsed", "compared", "mismatches")
    return {key: sum(row[key] for row in rows) for key in keys}


def summary(run: PictureRun) -> str:
    """What ran and what came out, in one paragraph."""
    total = totals(run.rows)
    sums = sum(row["sums"] for row in run.rows)
    exact = sum(row["cycles"] == row["estimated"] for row in run.rows)
    lines = [
        f"{run.report['image']}: {len(run.rows)} convolutions on the exported Verilog, exact sums from {sums} of them. "
        f"{total['mismatches']:,} of {total['compared']:,} codes and sums differ from the deployed network. Cycles are "
        f"exactly the estimated ones in {exact} convolutions. All together: {total['estimated']:,} cycles estimated, "
        f"{total['cycles']:,} simulated, {total['elapsed']:,} with loads."
    ]
    pose = run.report["pose"]
    if pose is None:
        lines.append("No pose was found")
    else:
        x, y, z = pose["cam_t_m2c"]
        lines.append(
            f"The pose from the array's sums: at {x:.1f} {y:.1f} {z:.1f} mm, score {pose['score']:.2f}"
        )
        if errors := run.report["errors"]:
            lines.append(
                f"({errors['translation_mm']:.1f} mm and {errors['rotation_deg']:.1f} degrees from the truth)"
            )
    same = "the same to the last bit as" if run.report["same_pose"] else "NOT that of"
    return " ".join(lines) + f"; {same} the deployed network's."


def cells(rows: list[dict[str, Any]], array: ArrayConfig) -> list[list[str]]:
    """Rows under `HEAD`, the sum last."""
    total = totals(rows)
    last = ["all", *[""] * 5, str(total["passes"]), *_figures(total, array)]
    return [*(row_cells(row, array) for row in rows), last]


def row_cells(row: dict[str, Any], array: ArrayConfig) -> list[str]:
    """One convolution under `HEAD`."""
    return [
        row["name"], f"{row['c_in']} -> {row['c_out']}, {row['height']} x {row['width']}",
        f"{row['kernel']}x{row['kernel']}/{row['stride']}", row["input"], row["output"],
        "sums" if row["sums"] else "codes", str(row["passes"]), *_figures(row, array),
    ]  # fmt: skip


def _figures(row: dict[str, Any], array: ArrayConfig) -> list[str]:
    rate = row["macs"] / row["cycles"]
    counts = [f"{row[key]:,}" for key in ("estimated", "cycles", "elapsed", "compared", "mismatches")]
    return [
        *counts, f"{rate:,.0f}", f"{100 * rate / array.peak_macs:.1f} %", f"{1e3 * row['cycles'] / CLOCK_HZ:.3f}",
    ]  # fmt: skip
