"""The evaluation of a network on a set of frames as JSON, Markdown and plots."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from macram.pose.evaluation import BUCKETS, DISTANCE_THRESHOLDS_D, REPROJECTION_THRESHOLDS_PX, Evaluation
from macram.report.files import write_bytes, write_json, write_text

_RANGES = (*BUCKETS, "all")
_COLOURS = {"near": "#2b8cbe", "medium": "#e6842a", "far": "#b3368c", "all": "#222222", "outside": "#999999"}
_DIVISIONS = {
    "fixed": "Ranges 1d-4d, 4d-7d, 7d-10d of the depth",
    "thirds": "Three equal parts of the depths in this set, as published",
}


def write_evaluation(
    folder: Path,
    evaluation: Evaluation,
    *,
    title: str = "Evaluation",
    details: Mapping[str, str] | None = None,
    layers: Sequence[Mapping[str, Any]] = (),
) -> list[Path]:
    """Write ``evaluation.json`` (all rows), ``evaluation.md`` and ``evaluation.png`` into an existing folder.

    Args:
        folder: where to.
        evaluation: from `macram.pose.evaluate`.
        title: heading of page and picture.
        details: what was evaluated (data, checkpoint, ...), printed as given.
        layers: of a network with an integer form, rows of `macram.quant.layer_differences`.

    Returns:
        The three paths.

    Raises:
        OSError: the folder is missing or not writable.
    """
    about = dict(details or {})
    paths = [folder / f"evaluation.{ending}" for ending in ("json", "md", "png")]
    table = {"title": title, "details": about, "summary": evaluation.summary, "rows": evaluation.rows}
    if layers:
        table["layers"] = [dict(row) for row in layers]
    write_bytes(paths[2], evaluation_png(evaluation, title))
    write_text(paths[1], evaluation_markdown(evaluation.summary, title, about) + layers_markdown(layers))
    write_json(paths[0], table)
    return paths


def evaluation_markdown(summary: Mapping[str, Any], title: str, details: Mapping[str, str]) -> str:
    """The summary as a Markdown page; percentages with two digits, as the paper prints them."""
    lines = [f"# {title}", ""]
    lines += [f"- {name}: {value}" for name, value in details.items()]
    misses, frames = summary["misses"], summary["frames"]
    lines += [
        f"- frames: {frames}, without a pose: {misses} ({100 * misses / frames:.2f} %), "
        "each counted as an error of 1.0 d",
        f"- object diameter d: {summary['diameter_mm']:g} mm; {summary['vertices']} model points",
        "",
        "ADD: mean distance of the same model points, the figure published as ADI-0.1d. "
        "ADI: mean distance to the nearest point.",
        "",
    ]
    for division, heading in _DIVISIONS.items():
        limits = ", ".join(f"{limit:.1f}" for limit in summary["limits_mm"][division])
        lines += [f"## {heading}", "", f"Limits: {limits} mm.", ""]
        if division == "fixed" and summary["outside"]:
            lines += [f"{summary['outside']} frames lie outside the limits and count in *all* only.", ""]
        lines += [*_range_table(summary[division]), ""]
    return "\n".join([*lines, *_speed_table(summary["speed"])]) + "\n"


def layers_markdown(layers: Sequence[Mapping[str, Any]]) -> str:
    """Where the training graph's codes differ from the deployed integers; empty without layers."""
    if not layers:
        return ""
    codes = sum(row["codes"] for row in layers)
    lines = ["", "## Training graph (float32) against deployed integers", ""]
    lines += [
        f"{codes:,} codes of {len(layers)} tensors. *Alone*: every layer reads the deployed codes, so that the "
        "difference is its own; *accumulated*: it reads what the training graph made.",
        "",
        "| tensor | codes | alone (%) | accumulated (%) | largest difference, alone |",
        "| --- | ---: | ---: | ---: | ---: |",
    ]
    whole = {key: sum(row["codes"] * row[key] for row in layers) / codes for key in ("alone", "accumulated")}
    largest = max(row["largest"] for row in layers)
    shown = [{"name": "**all**", "codes": codes, "largest": largest, **whole}, *layers]
    for row in shown:
        shares = " | ".join(f"{100 * row[key]:.4f}" for key in ("alone", "accumulated"))
        lines.append(f"| {row['name']} | {row['codes']:,} | {shares} | {row['largest']} |")
    return "\n".join(lines) + "\n"


def _range_table(ranges: Mapping[str, Any]) -> list[str]:
    rows = [["", *_RANGES], ["---", *("---:" for _ in _RANGES)]]
    for name in ("frames", "misses"):
        rows.append([name, *(str(ranges[r][name]) for r in _RANGES)])
    for metric in ("add", "adi"):
        for limit in DISTANCE_THRESHOLDS_D:
            label = f"{metric.upper()}-{limit:g}d (%)"
            # The figure to compare with the paper stands out.
            label = f"**{label}**" if (metric, limit) == ("add", 0.1) else label
            rows.append([label, *(_number(ranges[r][metric][f"{limit:g}"], 2) for r in _RANGES)])
    for limit in REPROJECTION_THRESHOLDS_PX:
        name = f"reprojection < {limit:g} px (%)"
        rows.append([name, *(_number(ranges[r]["proj"][f"{limit:g}"], 2) for r in _RANGES)])
    for key, name, digits in (
        ("add_d_median", "median ADD (d)", 4),
        ("adi_d_median", "median ADI (d)", 4),
        ("proj_px_median", "median reprojection (px)", 2),
        ("re_deg_median", "median rotation error, found only (deg)", 2),
        ("te_mm_median", "median translation error, found only (mm)", 1),
    ):
        rows.append([name, *(_number(ranges[r][key], digits) for r in _RANGES)])
    return [f"| {' | '.join(row)} |" for row in rows]


def _speed_table(speed: Mapping[str, Any]) -> list[str]:
    lines = ["## SPEED score", "", "| misses | frames | e_q (rad) | e_t | e_q + e_t |"]
    lines.append("| --- | ---: | ---: | ---: | ---: |")
    names = {"count": "counted (e_q = pi, e_t = 1)", "skip": "skipped, as published"}
    for convention, name in names.items():
        row = speed[convention]
        figures = " | ".join(_number(row[key], 6) for key in ("e_q", "e_t", "score"))
        lines.append(f"| {name} | {row['counted']} | {figures} |")
    return lines


def _number(value: float | None, digits: int) -> str:
    return "-" if value is None else f"{value:.{digits}f}"


def evaluation_png(evaluation: Evaluation, title: str) -> bytes:
    """Four plots: accuracy over threshold, error over depth, shares per range, rotation and translation."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: PLC0415
    from matplotlib.figure import Figure  # noqa: PLC0415

    figure = Figure(figsize=(11.0, 8.0), dpi=110, facecolor="white")
    FigureCanvasAgg(figure)
    axes: Any = figure.subplots(2, 2)
    _plot_thresholds(axes[0][0], evaluation)
    _plot_depth(axes[0][1], evaluation)
    _plot_ranges(axes[1][0], evaluation.summary)
    _plot_parts(axes[1][1], evaluation)
    for axis in axes.flat:
        axis.spines[["top", "right"]].set_visible(False)
        axis.grid(True, color="#e6e6e6", linewidth=0.7)
        axis.set_axisbelow(True)
    figure.suptitle(title, fontsize=13, fontweight="bold", color="#111")
    figure.tight_layout(pad=1.2)
    buffer = io.BytesIO()
    # Without matplotlib's version the picture depends on the figures alone.
    figure.savefig(buffer, format="png", metadata={"Software": None})
    return buffer.getvalue()


def _column(evaluation: Evaluation, name: str) -> NDArray[np.float64]:
    """One column of the rows; None becomes NaN."""
    return np.array([np.nan if row[name] is None else row[name] for row in evaluation.rows], np.float64)


def _plot_thresholds(axis: Any, evaluation: Evaluation) -> None:
    limits = np.linspace(0.0, 0.5, 251)
    groups = np.array([row["fixed"] for row in evaluation.rows])
    error = _column(evaluation, "add_d")
    for name in _RANGES:
        values = error if name == "all" else error[groups == name]
        if len(values):
            share = 100.0 * (values[:, None] < limits).mean(axis=0)
            axis.plot(limits, share, color=_COLOURS[name], linewidth=1.8, label=f"{name}, ADD")
    adi = 100.0 * (_column(evaluation, "adi_d")[:, None] < limits).mean(axis=0)
    axis.plot(limits, adi, color=_COLOURS["all"], linewidth=1.4, linestyle=":", label="all, ADI")
    axis.axvline(0.1, color="#888", linewidth=0.9, linestyle="--")
    axis.set(xlabel="threshold (d)", ylabel="frames below (%)", xlim=(0, 0.5), ylim=(0, 100.5))
    axis.set_title("Accuracy over the threshold", fontsize=11)
    axis.legend(fontsize=8, frameon=False)


def _plot_depth(axis: Any, evaluation: Evaluation) -> None:
    found = np.array([row["detected"] for row in evaluation.rows], bool)
    depth, error = _column(evaluation, "z_d"), _column(evaluation, "add_d")
    colours = np.array([_COLOURS[row["fixed"]] for row in evaluation.rows])
    # A logarithmic axis has no place for an error of exactly 0.
    shown = np.maximum(error, 1e-4)
    axis.scatter(depth[found], shown[found], s=7, c=colours[found], alpha=0.6, linewidths=0)
    if not found.all():
        missed = int((~found).sum())
        axis.scatter(depth[~found], shown[~found], s=22, c="#d62728", marker="x", label=f"no pose ({missed})")
        axis.legend(fontsize=8, frameon=False)
    axis.axhline(0.1, color="#888", linewidth=0.9, linestyle="--")
    axis.set_yscale("log")
    axis.set(xlabel="depth (d)", ylabel="ADD (d)")
    axis.set_title("Error over the depth", fontsize=11)


def _plot_ranges(axis: Any, summary: Mapping[str, Any]) -> None:
    places = np.arange(len(_RANGES))
    for offset, limit, shade in ((-0.27, "0.1", 1.0), (0.0, "0.2", 0.65), (0.27, "0.5", 0.35)):
        shares = [summary["fixed"][name]["add"][limit] for name in _RANGES]
        heights = [0.0 if share is None else share for share in shares]
        axis.bar(places + offset, heights, 0.25, color="#2b8cbe", alpha=shade, label=f"ADD-{limit}d")
        for place, share in zip(places + offset, shares, strict=True):
            text = "-" if share is None else f"{share:.0f}"
            axis.text(place, (share or 0.0) + 1.0, text, ha="center", fontsize=8, color="#333")
    labels = [f"{name}\n({summary['fixed'][name]['frames']})" for name in _RANGES]
    axis.set_xticks(places, labels)
    axis.set(ylabel="frames below (%)", ylim=(0, 112))
    axis.set_title("Depth ranges 1d-4d, 4d-7d, 7d-10d (frames)", fontsize=11)
    axis.legend(fontsize=8, frameon=False, ncols=3, loc="upper center")


def _plot_parts(axis: Any, evaluation: Evaluation) -> None:
    # Late, as in `evaluation_png`: Matplotlib is slow to load.
    from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter  # noqa: PLC0415

    found = np.array([row["detected"] for row in evaluation.rows], bool)
    colours = np.array([_COLOURS[row["fixed"]] for row in evaluation.rows])[found]
    rotation = np.maximum(_column(evaluation, "re_deg")[found], 1e-3)
    translation = np.maximum(100.0 * _column(evaluation, "e_t")[found], 1e-3)
    if found.any():
        axis.scatter(rotation, translation, s=7, c=colours, alpha=0.6, linewidths=0)
        axis.set_xscale("log")
        axis.set_yscale("log")
        for line in (axis.xaxis, axis.yaxis):
            # Matplotlib's own labels of a range below two decades run into each other.
            line.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
            line.set_major_formatter(StrMethodFormatter("{x:g}"))
            line.set_minor_formatter(NullFormatter())
    axis.set(xlabel="rotation error (deg)", ylabel="translation error (% of the distance)")
    axis.set_title("Rotation against translation", fontsize=11)
