"""The section on seeds: what a row scores when it is trained again, and how two rows differ seed by seed."""

from __future__ import annotations

import math
from collections.abc import Sequence

from macram.experiments import statistics
from macram.experiments.beside import COLUMNS, scores
from macram.experiments.finished import Finished
from macram.experiments.plan import Plan, Row
from macram.experiments.sections import table

STUDENT = (math.inf, 12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262)
"""Student's t at 97.5 % for 0, 1, ... degrees of freedom; beyond, the last is used, which is too wide."""
ALIKE = 1e-9
"""Points; shares of 1,000 frames are multiples of 0.1, so that few seeds may agree by chance."""
HEAD = "## Spread over seeds\n\n"


def section(plan: Plan, done: Sequence[Finished]) -> list[str]:
    """Mean and spread of every row of the group, and differences against the first that continues the same row."""
    wanted = [row for row in plan.rows if row.group == "seeds"]
    by_row = {row.name: [f for f in done if f.job.row is row] for row in wanted}
    lines = [_line(row, by_row[row.name]) for row in wanted if by_row[row.name]]
    if not wanted:
        return []
    if not lines:
        names = ", ".join(f"`{row.name}`" for row in wanted)
        return [
            f"{HEAD}None of {names} has been run to its end yet, so the spread over trainings is not known."
        ]
    parts = [
        f"{HEAD}ADD on all distances by a single look and refined, mean ± standard deviation over the seeds. *Images* "
        "are those of the row's own stage.",
        table(["row", "seeds", "images", *COLUMNS], lines),
    ]
    for row in wanted:
        base = next(other for other in wanted if other.after == row.after)
        if row.after and base is not row:
            parts += _against(plan, row, base, by_row)
    return parts


def _line(row: Row, found: Sequence[Finished]) -> list[str]:
    images = [f.table["images"] for f in found]
    extremes = sorted({min(images), max(images)})
    columns = zip(*(scores(f) for f in found), strict=True)
    return [
        row.title,
        f"{len(found)} of {len(row.seeds)}",
        " to ".join(f"{n:,}" for n in extremes),
        *(_spread(c) for c in columns),
    ]


def _spread(values: Sequence[float | None]) -> str:
    """Blank unless every seed has the score."""
    known = [value for value in values if value is not None]
    if len(known) < len(values):
        return ""
    mean, deviation = statistics.spread(known)
    return f"{mean:.2f} ± {deviation:.2f}" if len(known) > 1 else f"{mean:.2f}"


def _against(plan: Plan, row: Row, base: Row, by_row: dict[str, list[Finished]]) -> list[str]:
    """The differences of the seeds that both rows have."""
    others = {f.job.seed: f for f in by_row[base.name]}
    pairs = [(f, others[f.job.seed]) for f in by_row[row.name] if f.job.seed in others]
    if not pairs:
        return []
    lines = [
        [column, *_difference([(scores(a)[n], scores(b)[n]) for a, b in pairs])]
        for n, column in enumerate(COLUMNS)
    ]
    before = plan.row(row.after)
    first = (
        f"All seeds continue one training of `{before.name}` (seed {before.seeds[0]}): the spread is that of the "
        "second stage."
        if len(before.seeds) == 1
        else f"Every seed continues its own training of `{before.name}`."
    )
    return [
        f"*{row.title}* less *{base.title}*, seed by seed. {first} The interval is Student's, over the "
        "seeds and on the same test frames; each of the scores has its own, and one in twenty misses:",
        table(["score", "points, each seed", "mean ± standard deviation", "95 %", "verdict"], lines),
    ]


def _difference(pairs: Sequence[tuple[float | None, float | None]]) -> list[str]:
    """Points, each seed; mean and spread; interval; what it says."""
    points = [one - other for one, other in pairs if one is not None and other is not None]
    if not points:
        return ["", "", "", ""]
    each = ", ".join(f"{value:+.1f}" for value in points)
    if len(points) == 1:
        return [each, "", "", "one seed alone"]
    mean, deviation = statistics.spread(points)
    if deviation < ALIKE:
        return [each, f"{mean:+.2f} ± {deviation:.2f}", "", "seeds too alike to tell"]
    wide = STUDENT[min(len(points), len(STUDENT)) - 1] * deviation / math.sqrt(len(points))
    low, high = mean - wide, mean + wide
    verdict = "no difference found" if low <= 0 <= high else "better" if mean > 0 else "worse"
    return [each, f"{mean:+.2f} ± {deviation:.2f}", f"{low:+.1f} to {high:+.1f}", verdict]
