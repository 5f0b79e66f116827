"""The table of a network as JSON, Markdown and one HTML page."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from macram.designs.losses import LOSSES
from macram.layer_job import CLOCK_HZ
from macram.network.table import NetworkTable
from macram.report.files import write_json, write_text
from macram.report.page import page_environment

HEAD = (
    "first of them", "times", "shape", "kernel", "passes", "estimated", "simulated", "compared", "differ",
    "MAC/cycle", "per DSP", "of peak", *LOSSES, "ms", "",
)  # fmt: skip
LEFT = {0, 2, 3, 17}
"""Columns of text."""
NOTE = (
    "Cycles of one run; ms at 100 MHz. Simulated: the array's own counters, from the first input beat to the last "
    "output beat of each pass, streams undisturbed; loads of weights that do not hide behind a run are not among them. "
    "Compared: output codes, of random inputs and weights, against the golden model; all codes have the array's "
    "formats, while a deployed network takes 8-bit codes or sums from some of these layers. Unused: engines without "
    "work in a compute step, because channels, columns or the kernel do not fill them. Fill: before the first step. "
    "Stall: between steps, waiting for input, drain or output. Drain: after the last. Per DSP: of the slices in the "
    "row engines. The estimate is exact where the engines are the limit, near where a stream is."
)


def write_network(
    folder: Path, table: NetworkTable, *, network: str, command: str, about: dict[str, Any]
) -> Path:
    """Write ``network.json``, ``network.md`` and ``network.html`` into an existing folder.

    Args:
        folder: where to.
        table: of the network.
        network: what was run, in words.
        command: what to type to get the same again.
        about: seed, design, versions and machine, for the JSON.

    Returns:
        The page.

    Raises:
        OSError: the folder is missing or not writable.
    """
    array = table.array
    write_json(
        folder / "network.json",
        {
            "format": 1, "command": command, "network": network, "passed": table.passed,
            "complete": table.complete, "array": array.to_dict() | {"peak_macs_per_cycle": array.peak_macs},
            "total": table.total, "shapes": table.rows, **about,
        },
    )  # fmt: skip
    write_text(folder / "network.md", markdown(table, network, command))
    page = page_environment().get_template("network.html.j2").render(
        title=f"{array.name}: every convolution simulated", network=network, command=command, file="network.json",
        summary=summary(table), note=NOTE, head=HEAD, left=LEFT, rows=cells(table), picture="",
    )  # fmt: skip
    write_text(folder / "network.html", page)
    return folder / "network.html"


def markdown(table: NetworkTable, network: str, command: str) -> str:
    """The table as a Markdown page."""
    return page_text(
        f"{table.array.name}: every convolution simulated ({network})",
        command,
        summary(table),
        (HEAD, LEFT, cells(table)),
        NOTE,
    )


def page_text(
    title: str,
    command: str,
    text: str,
    table: tuple[Sequence[str], set[int], Sequence[Sequence[str]]],
    note: str,
) -> str:
    """A Markdown page of one table: its head, the columns of text, its rows."""
    head, left, rows = table
    marks = ["---" if index in left else "---:" for index in range(len(head))]
    lines = [f"| {' | '.join(row)} |" for row in (head, marks, *rows)]
    return "\n".join([f"# {title}", "", f"Written by `{command}`.", "", text, "", *lines, "", note, ""])


def summary(table: NetworkTable) -> str:
    """What was simulated and what came out, in one paragraph."""
    total = table.total
    lines = [
        f"{total['simulated']} of {total['convolutions']} convolutions, {_done(table)} of {len(table.rows)} shapes, "
        "are simulated on the exported Verilog."
    ]
    if refused := total["convolutions"] - total["on_array"]:
        lines.append(f"The array refuses {refused}.")
    if total["simulated"]:
        exact = sum(row["cycles"] == row["estimated"] for row in table.rows if row["passed"] is not None)
        lines.append(
            f"{total['mismatches']:,} of {total['compared']:,} codes differ from the golden model. Cycles are exactly "
            f"the estimated ones in {exact} of {_done(table)} shapes. All of them together: "
            f"{total['estimated_simulated']:,} cycles estimated, {total['cycles']:,} simulated, "
            f"{total['ms']:.1f} ms at 100 MHz, {total['macs_per_cycle']:,.0f} MAC/cycle, "
            f"{100 * total['utilisation']:.1f} % of the peak."
        )
    return " ".join(lines)


def cells(table: NetworkTable) -> list[list[str]]:
    """Rows under `HEAD`, and the sum over every convolution as the last."""
    return [*(row_cells(row) for row in table.rows), total_cells(table.total)]


def row_cells(row: dict[str, Any]) -> list[str]:
    """One shape under `HEAD`; what was not simulated has its estimate alone."""
    shape = f"{row['c_in']} -> {row['c_out']}, {row['height']} x {row['width']}"
    start = [row["names"][0], str(row["count"]), shape, f"{row['kernel']}x{row['kernel']}/{row['stride']}"]
    if row["refused"] is not None:
        return [*start, *[""] * (len(HEAD) - len(start) - 1), row["refused"]]
    start += [str(row["passes"]), f"{row['estimated']:,}"]
    if row["passed"] is None:
        return [*start, *[""] * (len(HEAD) - len(start) - 1), "not simulated"]
    return [
        *start, f"{row['cycles']:,}", f"{row['compared']:,}", f"{row['mismatches']:,}", *_rates(row, row["cycles"]),
        verdict(row),
    ]  # fmt: skip


def total_cells(total: dict[str, Any]) -> list[str]:
    """The sum over every simulated convolution under `HEAD`."""
    start = ["", str(total["simulated"]), "all simulated", "", "", f"{total['estimated_simulated']:,}"]
    if not total["simulated"]:
        return [*start, *[""] * (len(HEAD) - len(start))]
    codes = [f"{total[key]:,}" for key in ("compared", "mismatches")]
    return [*start, f"{total['cycles']:,}", *codes, *_rates(total, total["cycles"]), ""]


def verdict(row: dict[str, Any]) -> str:
    """``ok``, with the stream that is the limit if one is; or what is wrong."""
    if row["mismatches"]:
        return "FAILED: codes differ"
    if not row["passed"]:
        return "FAILED: cycles differ"
    estimate = row["estimate"]
    return "ok" if estimate["exact"] else f"ok; {estimate['limited_by']} stream"


def _rates(row: dict[str, Any], cycles: int) -> list[str]:
    per_dsp = row["macs_per_cycle_per_dsp"]
    return [
        f"{row['macs_per_cycle']:,.0f}", "" if per_dsp is None else f"{per_dsp:.1f}",
        f"{100 * row['utilisation']:.1f} %", *(f"{row['lost'][cause]:,.0f}" for cause in LOSSES),
        f"{1e3 * cycles / CLOCK_HZ:.3f}",
    ]  # fmt: skip


def _done(table: NetworkTable) -> int:
    return sum(row["passed"] is not None for row in table.rows)
