"""The search's result as JSON, Markdown and a picture of cycles over LUTs."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from macram.designs.lut_model import TERMS, LutModel
from macram.designs.plots import COLOURS, THEIRS, figure_of, png_of
from macram.designs.search import SPACE, Candidate
from macram.report.files import write_bytes, write_json, write_text
from macram.synth.devices import Device

SHOWN = 12
"""Candidates in each table."""
HEAD = (
    "array", "rows", "reference", "network", "waits for loads", "both", "ms", "LUT (estimate)", "DSP", "RAMB36",
    "stopped by",
)  # fmt: skip
NOTE = (
    "Cycles in closed form: of the reference layer, of all convolutions of the network, and the cycles between them in "
    "which the array waits for words of the next pass; ms of the last two together at 100 MHz. DSP and RAMB36 follow "
    "from the configuration, DSP with as many slices outside the units as a counted array has at most. Clock rates are "
    "no part of the search: nothing here was placed and routed."
)


def write_search(
    folder: Path,
    found: Sequence[Candidate],
    base: Candidate,
    model: LutModel,
    device: Device,
    about: dict[str, Any],
) -> None:
    """Write ``search.json``, ``search.md`` and ``search.png`` into an existing folder.

    Args:
        folder: where to.
        found: all candidates, the fastest first.
        base: the shipped array among them, to compare with.
        model: of the LUT estimates.
        device: whose limits stop them.
        about: command, network, versions and machine.
    """
    table = {
        "format": 1, **about, "device": device.name, "space": SPACE, "note": NOTE,
        "limits": {key: device.limit(key) for key in ("lut", "dsp", "bram")},
        "model": {
            "terms": dict(zip(TERMS, (round(float(term), 1) for term in model.unit_terms), strict=True)),
            "shell": [round(float(term), 1) for term in model.shell_terms], "worst": round(model.worst, 4),
            "units": list(model.units), "arrays": list(model.arrays),
        },
        "shipped": base.to_dict(),
        "candidates": [one.to_dict() for one in found],
    }  # fmt: skip
    write_json(folder / "search.json", table)
    write_text(folder / "search.md", markdown(found, base, model, device, about["command"]))
    write_bytes(folder / "search.png", search_png(found, base, device))


def markdown(
    found: Sequence[Candidate], base: Candidate, model: LutModel, device: Device, command: str
) -> str:
    """The ranking and the model's errors as a page."""
    fitting = [one for one in found if not one.stopped_by]
    faster = [one for one in found if one.stopped_by and fitting and one.total < fitting[0].total]
    terms = ", ".join(f"{name} {term:.0f}" for name, term in zip(TERMS, model.unit_terms, strict=True))
    shell, per_row = model.shell_terms
    parts = [
        f"# Arrays for {device.title}",
        f"Written by `{command}`. The space: {SPACE}. {len(found):,} arrays run every layer, {len(fitting):,} of them "
        "fit by estimate.",
        NOTE,
        "## The fastest that fit",
        _table(HEAD, [cells(one) for one in fitting[:SHOWN]]),
        "## The fastest that fit on the reference layer",
        _table(HEAD, [cells(one) for one in sorted(fitting, key=lambda one: one.reference)[:SHOWN]]),
        "## The shipped array",
        _table(HEAD, [cells(base)]),
        "## Faster ones, and what stops them",
        _table(HEAD, [cells(one) for one in faster[:SHOWN]]),
        "![search.png](search.png)",
        "## The estimate of LUTs",
        f"LUTs of a unit: {terms}. Outside the units {shell:.0f}, and {per_row:.0f} for each row engine of a unit. "
        f"Largest error: {100 * model.worst:.1f} %.",
        _table(("counted", "LUT", "estimate", "error"), error_rows(model)),
    ]  # fmt: skip
    return "\n\n".join(parts) + "\n"


def cells(one: Candidate) -> list[str]:
    """One row under `HEAD`."""
    bram = one.used["bram"]
    return [
        one.mix, str(one.array.rows), f"{one.reference:,}", f"{one.network:,}", f"{one.loads:,}", f"{one.total:,}",
        f"{one.total / 1e5:.1f}", f"{one.used['lut']:,.0f}", f"{one.used['dsp']:.0f}",
        f"{bram:g}", "; ".join(one.stopped_by),
    ]  # fmt: skip


def error_rows(model: LutModel) -> list[list[str]]:
    """Each counted unit and array beside its estimate."""
    pairs = [(_unit_name(unit["kinds"]), unit) for unit in model.units]
    pairs += [(f"array {array['array']['name']}", array) for array in model.arrays]
    return [
        [
            name,
            f"{one['lut']:,.0f}",
            f"{one['estimate']:,.0f}",
            f"{100 * (one['estimate'] / one['lut'] - 1):+.1f} %",
        ]
        for name, one in pairs
    ]


def search_png(found: Sequence[Candidate], base: Candidate, device: Device) -> bytes:
    """Cycles of the network with its loads over estimated LUTs; the shipped array and the limit marked."""
    figure, axis = figure_of(7.6, 4.8)
    for fits, colour, label in ((False, THEIRS, "too large"), (True, COLOURS[0], "fits by estimate")):
        mine = [one for one in found if (not one.stopped_by) is fits]
        points = [one.used["lut"] / 1e3 for one in mine], [one.total / 1e6 for one in mine]
        axis.scatter(*points, s=10, color=colour, label=label)
    axis.scatter(
        [base.used["lut"] / 1e3], [base.total / 1e6], s=80, marker="*", color="#d1495b",
        label=f"{base.array.name} (shipped)", zorder=3,
    )  # fmt: skip
    axis.axvline(device.limit("lut") / 1e3, color="#333", linewidth=1, linestyle=":")
    axis.set(
        xscale="log", yscale="log", xlabel="thousand LUTs, estimated", ylabel="million cycles of the network"
    )
    axis.set_title(f"Arrays for {device.name}", fontsize=11)
    axis.legend(fontsize=8, frameon=False)
    return png_of(figure)


def _unit_name(kinds: Sequence[str]) -> str:
    parts = [f"{kinds.count(kind)} {kind}" for kind in dict.fromkeys(kinds)]
    return f"unit of {' + '.join(parts)}"


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    marks = ["---", *["---:"] * (len(head) - 1)]
    return "\n".join(f"| {' | '.join(line)} |" for line in (head, marks, *rows))
