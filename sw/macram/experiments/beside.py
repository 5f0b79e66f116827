"""Refined scores beside those of a single look: a second table in the sections of ``docs/results.md`` on rows."""

from __future__ import annotations

from collections.abc import Sequence

from macram.experiments import statistics
from macram.experiments.finished import Finished
from macram.experiments.plan import Plan
from macram.experiments.sections import CONTROL, SCORE_COLUMNS, score_cells, table

LIMITS = ("0.1", "0.2", "0.5")
COLUMNS = [f"{limit}d %, {way}" for limit in LIMITS for way in ("single", "refined")]


def introduction(plan: Plan) -> str:
    """What refined means, and what it was calibrated on."""
    refined = plan.refined
    return (
        "Scores take a single look, as the paper's evaluation does; those called *refined* take "
        f"{refined.looks} turned looks at every picture as well and align the pose with the edges of a box of "
        f"{refined.edges} of the keypoints' (`macram evaluate {refined.options}`), both calibrated on training and "
        "validation frames alone (*What was tried at inference*, below)."
    )


def questions(done: Sequence[Finished]) -> list[str]:
    """Rows of the questions, refined differences against the control."""
    rows = [f for f in done if f.job.row.group == "questions"]
    control = next((f for f in rows if f.job.row.name == CONTROL), None)
    if not any(f.refined for f in rows):
        return []
    return [
        f"ADD on the same frames, all distances, by a single look and refined:\n\n"
        f"{_beside(rows, [control] * len(rows), 'refined, against the control, points (95 %)')}"
    ]


def quantised(done: Sequence[Finished]) -> list[str]:
    """Quantised rows, refined losses against the float network they come from."""
    rows = [f for f in done if f.job.row.group == "quantised"]
    if not any(f.refined for f in rows):
        return []
    return [
        f"ADD of the training graph on the same frames, all distances, by a single look and refined:\n\n"
        f"{_beside(rows, _floats(rows, done), 'refined loss, points (95 %)')}"
    ]


def front(done: Sequence[Finished]) -> list[str]:
    """Rows of the network that has the reference layer, by a single look and refined."""
    rows = [f for f in done if f.job.row.group == "front"]
    if not rows:
        return []
    return [
        "## The reference layer's network\n\n`paper-front` has the paper's width in its first two stages and quarter "
        "width behind them, so that the layer of 128 x 128 x 64 has learned weights. One training each.",
        table(["row", *SCORE_COLUMNS], [[f.job.row.title, *score_cells(f)] for f in rows]),
        "By a single look and refined:",
        _beside(rows, _floats(rows, done), "refined loss, points (95 %)"),
    ]


def _floats(rows: Sequence[Finished], done: Sequence[Finished]) -> list[Finished | None]:
    """For each row the float network it comes from."""
    by_key = {f.job.key: f for f in done}
    return [None if (before := f.job.unquantised()) is None else by_key.get(before.key) for f in rows]


def _beside(rows: Sequence[Finished], others: Sequence[Finished | None], title: str) -> str:
    lines = []
    for f, other in zip(rows, others, strict=True):
        cells = ["" if score is None else f"{score:.2f}" for score in scores(f)]
        lines.append([f.job.row.title, *cells, _difference(f, other)])
    return table(["row", *COLUMNS, title], lines)


def scores(f: Finished) -> list[float | None]:
    """One for each of `COLUMNS`."""
    single = f.table["ranges"]["all"]["add"]
    refined = {} if f.refined is None else f.refined.table["ranges"]["all"]["add"]
    return [add.get(limit) for limit in LIMITS for add in (single, refined)]


def _difference(one: Finished, other: Finished | None) -> str:
    if other is None or other is one or one.refined is None or other.refined is None:
        return ""
    points, low, high = statistics.difference(one.refined.frames, other.refined.frames)
    return f"{points:+.1f} ({low:+.1f} to {high:+.1f})"
