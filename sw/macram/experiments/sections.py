"""The sections of ``docs/results.md``, each a list of its paragraphs and tables."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from macram.data.geometry import BUCKETS
from macram.experiments import statistics
from macram.experiments.finished import Finished
from macram.experiments.plan import RESULT, Plan

LIMITING = "quarter-control.s2022"
"""The record that 'what limits accuracy' looks into: a float network trained as long as any of its table."""
CONTROL = "quarter-control"
"""The row that others of its table are held against."""
SHOWN = ("quarter-control.s2022", "quarter-w3a3.s2022")
"""Records whose frames are shown."""


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A Markdown table, its first column to the left."""
    lines = [head, ["---", *("---:" for _ in head[1:])], *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _learned_from(entry: Finished) -> str:
    return str(entry.table["dataset"]).split(",")[0].removeprefix("cubesat1u-")


def score_cells(entry: Finished) -> list[str]:
    """One for each of `SCORE_COLUMNS`."""
    low, high = statistics.share_interval(entry.frames)
    every = entry.table["ranges"]["all"]["add"]
    return [
        _learned_from(entry),
        f"{entry.table['images']:,}",
        f"{entry.table['minutes']:g}",
        *(f"{entry.table['ranges'][name]['add']['0.1']:.2f}" for name in BUCKETS),
        f"**{every['0.1']:.2f}** ({low:.1f} to {high:.1f})",
        f"{every['0.2']:.2f}",
        f"{every['0.5']:.2f}",
        f"{entry.table['frames']:,}",
    ]


SCORE_COLUMNS = [
    "data",
    "images",
    "minutes",
    "near %",
    "medium %",
    "far %",
    "all % (95 %)",
    "all, 0.2d %",
    "all, 0.5d %",
    "frames",
]
SCORE_NOTE = (
    'ADD-0.1d (published as "ADI-0.1d") by depth range. In brackets the 95 % interval over test scenes, '
    "sequences drawn again; it says nothing about other trainings. *Data* is what the row's own stage learned "
    "from, *images* and *minutes* are what it took."
)


def questions(done: Sequence[Finished]) -> list[str]:
    """Each question of the plan, answered by its rows."""
    rows = [f for f in done if f.job.row.group == "questions"]
    if not rows:
        return []
    devices = ", ".join(sorted({f.table["device"] for f in rows}))
    parts = [
        f"## The paper's questions\n\nQuarter width, one training each (seed {rows[0].job.seed}, "
        f"{devices}). {SCORE_NOTE}",
        table(["row", *SCORE_COLUMNS], [[f.job.row.title, *score_cells(f)] for f in rows]),
    ]
    by_name = {f.job.row.name: f for f in rows}
    control = by_name.get(CONTROL)
    if control is not None:
        lines = [_difference(f, control) for f in rows if f is not control]
        parts.append(
            "Against the control, which trains the factual path alone, its backbone frozen as in stage 2, on the "
            "same frames, one training each, so that a difference between two seeds is not ruled out:\n\n"
            + "\n".join(lines)
        )
    return parts


def _difference(one: Finished, other: Finished) -> str:
    points, low, high = statistics.difference(one.frames, other.frames)
    verdict = "no difference found" if low <= 0 <= high else "better" if points > 0 else "worse"
    images, others = one.table["images"], other.table["images"]
    seen = "as many images as" if images == others else f"{images / others:.2f} times the images of"
    return (
        f"- {one.job.row.title}: {points:+.1f} points ({low:+.1f} to {high:+.1f}), {verdict} on these "
        f"frames; its stage saw {seen} the control's."
    )


def more_data(done: Sequence[Finished]) -> list[str]:
    """Rows of the group data beside the same training on the plan's own data."""
    pairs = [
        (f, g)
        for f in done
        if f.job.row.group == "data"
        for g in done
        if g.job.seed == f.job.seed and g.job.row.config == f.job.row.config and g.job.row.group != "data"
    ]
    if not pairs:
        return []
    lines = [[entry.job.row.title, *score_cells(entry)] for pair in pairs for entry in pair]
    differences = []
    for few, many in pairs:
        points, low, high = statistics.difference(many.frames, few.frames)
        times = many.table["images"] / few.table["images"]
        differences.append(
            f"- {many.job.row.title} against {few.job.row.title}: {points:+.1f} points ({low:+.1f} to {high:+.1f}) of "
            f"ADD-0.1d, from more frames and {times:.2f} times the images ({many.table['device']}, "
            f"{few.table['device']})."
        )
    return [
        "## More training frames",
        table(["row", *SCORE_COLUMNS], lines),
        "One training each:\n\n" + "\n".join(differences),
    ]


def quantised(done: Sequence[Finished], cited: dict[str, Any]) -> list[str]:
    """Quantised networks beside the float one they come from, and the paper's losses."""
    rows = [f for f in done if f.job.row.group == "quantised"]
    by_key = {f.job.key: f for f in done}
    if not rows:
        return []
    lines = []
    for f in rows:
        before = f.job.unquantised()
        base = None if before is None else by_key.get(before.key)
        loss = (
            ["-"]
            if base is None
            else ["{:+.1f} ({:+.1f} to {:+.1f})".format(*statistics.difference(f.frames, base.frames))]
        )
        theirs = paper_accuracy(f, cited)
        paper = cited["swisscube"]["CA-SpaceNet"][-1]
        lines.append(
            [f.job.row.title, *score_cells(f), *loss, "-" if theirs is None else f"{theirs - paper:+.2f}"]
        )
    return [
        "## Quantised\n\nLSQ from the float network of stage 1. The loss is against that network on the "
        "same frames; the paper's "
        "loss, on SwissCube, is against its float CA-SpaceNet. Operations and shares per mode, to every "
        "digit of table IV: "
        "`macram counts`." + _taught(rows),
        table(["row", *SCORE_COLUMNS, "loss, points (95 %)", "paper's loss"], lines),
        *_integers([f for f in rows if f.integers is not None]),
    ]


def paper_accuracy(f: Finished, cited: dict[str, Any]) -> float | None:
    """Of the paper's network with the bits and mode of a row, percent; None where the paper has none."""
    accuracy: float | None = cited["quantised"].get(f"{f.table['bits']} bit, mode {f.table['mode']}")
    return accuracy


def _taught(rows: Sequence[Finished]) -> str:
    """Which rows learned from more than labels; empty if none did."""
    taught = [f.job for f in rows if f.job.row.teacher]
    if not taught:
        return ""
    which = "; ".join(f"*{job.row.title}* goes on with `{job.row.after}`" for job in taught)
    return (
        " What is *taught* imitates the float network's features beside learning from labels (`quant.teacher`), which "
        f"the paper does not do. {which}; *images* and *minutes* are of the row's own run."
    )


def _integers(rows: Sequence[Finished]) -> list[str]:
    """Deployed integers beside the training graph, on the frames the integers were scored on."""
    lines = []
    for f in rows:
        scores = f.integers or {}
        pairs = [
            f"{scores['add'][limit]:.2f} / {scores['training_graph_add'][limit]:.2f}"
            for limit in ("0.1", "0.2", "0.5")
        ]
        lines.append([f.job.row.title, *pairs, f"{scores['frames_apart']:,}", f"{scores['frames']:,}"])
    if not lines:
        return []
    apart = rows[0].integers or {}
    return [
        "The scores above are of the training graph. Its deployed integers on the same frames (`macram evaluate "
        "--integer`, then `macram experiments integers ROW JSON`), integers / training graph; *apart* counts "
        f"frames whose ADD differs by more than {apart['apart_d']:g} d. The graph computes in float32 "
        "what the integers have as codes and whole sums at every layer; equality, code by code, is between the "
        "integers, the golden model and the array:",
        table(["row", "ADD-0.1d %", "0.2d %", "0.5d %", "apart", "frames"], lines),
    ]


def cited(cited: dict[str, Any]) -> list[str]:
    """Figures of the paper, on other data."""
    swisscube = [[name, *(f"{v:.2f}" for v in values)] for name, values in cited["swisscube"].items()]
    return [
        "## Cited, not comparable\n\nAs the CA-SpaceNet paper prints them (`results/cited.toml`). "
        "ADI-0.1d in percent on SwissCube, "
        "other pictures and another spacecraft than ours:",
        table(["method", "near", "medium", "far", "all"], swisscube),
        "SPEED, e_q + e_t:",
        table(["method", "score"], [[name, f"{value:.4f}"] for name, value in cited["speed"].items()]),
    ]


def curves(done: Sequence[Finished]) -> list[str]:
    """Learning curves and frames."""
    if not done:
        return []
    parts = ["## Learning curves\n\n![Pose loss over the images seen, every row](images/curves.svg)"]
    shown = [f for f in done if f.job.key in SHOWN]
    if shown:
        parts.append(
            "## Successes and failures\n\nEight frames of the test split by rank of their error, best to "
            "worst; true boxes amber, "
            "predicted ones, by a single look, green with axes."
        )
        parts += [f"{f.job.row.title}:\n\n![{f.job.row.title}](images/{f.job.key}.jpg)" for f in shown]
    return parts


def limits(done: Sequence[Finished]) -> list[str]:
    """What limits accuracy, by range."""
    chosen = [f for f in done if f.job.key == LIMITING]
    if not chosen:
        return []
    entry = chosen[0]
    by_range = statistics.limits(entry.frames)
    rows = [
        [line["range"], str(line["frames"]), f"{line['add']:.1f}", f"{line['placed']:.1f}", f"{line['te_d']:.3f}",
         f"{line['re_deg']:.1f}", f"{line['flipped']:.1f}"]
        for line in by_range
    ]  # fmt: skip
    every = by_range[-1]
    worst = min(by_range[:-1], key=lambda line: line["placed"])
    pixels = entry.table["ranges"]["all"]["proj"]["5"]
    return [
        f"## What limits accuracy\n\n{entry.job.row.title}. *Placed* is the share of frames whose "
        f"position alone is within 0.1 d, "
        f"*flipped* the share turned by more than {statistics.FLIP_DEG:g} degrees. All by a single look.",
        table(["range", "frames", "ADD-0.1d %", "placed %", "median position error, d", "median rotation error, deg",
                "flipped %"], rows),
        f"In the picture the poses fit: {pixels:.1f} % of all frames reproject within 5 pixels, against "
        f"{every['add']:.1f} % "
        f"within 0.1 d. Position comes first: it is within 0.1 d in {every['placed']:.1f} % of all frames "
        f"and in "
        f"{worst['placed']:.1f} % in the {worst['range']} range, where 0.1 d is a fraction of a pixel in "
        f"the size of the target. "
        f"Rotation is off by {every['re_deg']:.1f} degrees in the median, and {every['flipped']:.1f} % of "
        f"the frames are turned to "
        "another face.",
    ]  # fmt: skip


def missing(plan: Plan, results: Path) -> list[str]:
    """Rows of the plan without a record."""
    left = [job for job in plan.jobs() if not (results / job.key / RESULT).is_file()]
    if not left:
        return []
    lines = [f"- `macram experiments run {job.row.name} --seed {job.seed}`: {job.row.title}" for job in left]
    return ["## Not run yet\n\n" + "\n".join(lines)]
