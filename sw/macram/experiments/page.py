"""``docs/results.md``: made of the plan, the records, the cited figures and the index of shipped weights alone."""

from __future__ import annotations

import tomllib
from pathlib import Path

from macram.experiments import beside, cost, materials, sections, seeds
from macram.experiments.curves import curves_svg
from macram.experiments.finished import finished
from macram.experiments.plan import Plan
from macram.experiments.tried import tried
from macram.report.files import write_bytes, write_text

PAGE = "results.md"


def write_page(plan: Plan, results: Path, out: Path) -> Path:
    """Writes the page and its pictures.

    Args:
        plan: the rows.
        results: folder of records, with ``dataset.json`` and ``cited.toml``.
        out: folder of the page; pictures go to ``images`` in it.

    Returns:
        The page's path.

    Raises:
        ValueError: a record or one of the other files is missing or broken.
    """
    done = finished(plan, results)
    (out / "images").mkdir(parents=True, exist_ok=True)
    if done:
        write_bytes(
            out / "images/curves.svg",
            curves_svg([(f.job.key, results / f.job.key / "curve.csv") for f in done]),
        )
    for key in sections.SHOWN:
        if (picture := results / key / "frames.jpg").is_file():
            write_bytes(out / f"images/{key}.jpg", picture.read_bytes())
    write_text(out / PAGE, page(plan, results))
    return out / PAGE


def page(plan: Plan, results: Path) -> str:
    """The text of the page; arguments and errors as for `write_page`."""
    done = finished(plan, results)
    cited = tomllib.loads((results / "cited.toml").read_text())
    parts = [
        "# Results\n\nWritten by `macram experiments table` from the records in `results/`; nothing here "
        "is typed by "
        "hand. `macram experiments list` says how far every row is, `macram experiments run ROW` runs "
        "one.\n\nAll scores are "
        "on rendered data and not comparable with tables on SwissCube or SPEED.",
        beside.introduction(plan),
        *materials.data(plan, results),
        *materials.shipped(results),
        *sections.questions(done),
        *beside.questions(done),
        *seeds.section(plan, done),
        *sections.more_data(done),
        *sections.quantised(done, cited),
        *beside.quantised(done),
        *cost.costs(done, cited, results),
        *beside.front(done),
        *sections.cited(cited),
        *sections.curves(done),
        *sections.limits(done),
        *tried(results, {str(f.table["model_sha256"]) for f in done}),
        *sections.missing(plan, results),
    ]
    return "\n\n".join(parts) + "\n"
