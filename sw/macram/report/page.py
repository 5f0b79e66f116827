"""The HTML page of a report: one file, no script, no network; everything it shows is in ``report.json``."""

from __future__ import annotations

import base64
from typing import Any

CAUSES = (
    ("mac_cycles", "multiply-accumulate", "a compute step was issued", "mac"),
    ("fill_cycles", "fill", "before the first compute step: the first image rows arrive", "fill"),
    ("input_stalls", "input stall", "between compute steps, waiting for input", "input"),
    ("output_stalls", "output stall", "between compute steps, waiting for requantiser or output", "output"),
    ("drain_cycles", "drain", "after the last compute step: the last codes leave", "drain"),
)  # fmt: skip
"""Counter, name, meaning and colour class; in this order the counters sum to the total."""


def cycle_rows(report: dict[str, Any]) -> list[dict[str, Any]]:
    """One row per cause of a cycle: measured, estimated (None where the estimate has no such part), share."""
    return [
        {
            "counter": counter,
            "name": name,
            "meaning": meaning,
            "colour": colour,
            "cycles": report["counters"][counter],
            "estimate": report["estimate"].get(counter),
            "share": report["cycle_shares"][counter],
        }
        for counter, name, meaning, colour in CAUSES
    ]


def page_environment() -> Any:
    """Templates of the reports, with filters for numbers; a name that a template misspells is an error."""
    import jinja2  # noqa: PLC0415

    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("macram.report", "."),
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
        undefined=jinja2.StrictUndefined,
    )
    environment.filters["thousands"] = lambda value: f"{value:,}"
    environment.filters["percent"] = lambda value, digits=1: f"{100 * value:.{digits}f} %"
    environment.filters["plain"] = lambda value: f"{value:g}"
    environment.filters["fixed"] = lambda value, digits=1: "" if value is None else f"{value:,.{digits}f}"
    return environment


def inline_png(content: bytes) -> str:
    """A picture as a ``data:`` address, so that a page is one file."""
    return "data:image/png;base64," + base64.b64encode(content).decode()


def render(report: dict[str, Any], pictures: dict[str, bytes]) -> str:
    """The page for ``report``; ``pictures`` are the PNG files it names, by file name.

    Raises:
        KeyError: ``report`` names a picture that is not given.
    """
    environment = page_environment()
    rows = cycle_rows(report)
    idle = [row for row in rows if row["counter"] != "mac_cycles"]
    page: str = environment.get_template("page.html.j2").render(
        r=report,
        causes=rows,
        idle=idle,
        picture=lambda name: inline_png(pictures[name]),
    )
    return page
