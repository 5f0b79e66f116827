"""Designs as JSON, Markdown and one HTML page."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from macram.designs.design import Design
from macram.designs.losses import LOSSES
from macram.designs.peers import PEERS
from macram.designs.plots import density_png, latency_png, roofline_png
from macram.report.files import write_bytes, write_json, write_text
from macram.report.latency import NOTE, PAPER_NOTE, PAPER_TABLE_VI
from macram.report.page import inline_png, page_environment

HEAD = ("design", "cycles", "from", "ms at 100 MHz", "MAC/cycle", "of peak")
RESOURCE_HEAD = ("design", "DSP", "LUT", "FF", "RAMB36", "MAC/cycle/DSP", "MAC/cycle/kLUT", "counted")
LAYER_HEAD = (
    "layer",
    "part",
    "shape",
    "kernel",
    "passes",
    "cycles",
    "MAC/cycle",
    "of peak",
    *LOSSES,
    "ms",
    "",
)
LOST_HEAD = ("design", "layers", "needed at the peak", *LOSSES, "total")
LOST_NOTE = (
    "Cycles. Needed: the multiply-accumulates at the array's peak. Unused: engines without work in a compute step, "
    "because channels, columns or the kernel do not fill them. Fill: before the first step. Stall: between steps, "
    "waiting for input, drain or output. Drain: after the last. Simulated layers have the array's own counters."
)
DSP_NOTE = (
    "From macram synth (Yosys), in percent of the device. Densities are of the reference layer, per cycle of the "
    "array's clock; slices of engine dsp48e2_2x run at twice that clock."
)
CLOSED_FORM = (
    "Closed form: the cycles that a simulation with undisturbed streams counts, exactly so where no stream is the "
    "limit. "
)
PEER_HEAD = ("design", "device", "bits", "MAC/cycle", "per DSP", "per kLUT", "what the figure is", "source")


def write_designs(
    folder: Path, designs: Sequence[Design], *, network: str, command: str, about: dict[str, Any]
) -> Path:
    """Write ``designs.json``, ``designs.md``, ``designs.html`` and the pictures into an existing folder.

    Args:
        folder: where to.
        designs: at least one.
        network: whose layers the rows are; empty if there are none.
        command: what to type to get the same again.
        about: versions and machine, for the JSON.

    Returns:
        The page.

    Raises:
        OSError: the folder is missing or not writable.
    """
    pictures = {"latency.png": latency_png(designs)}
    for name, kind in (("density.png", "dsp"), ("density-lut.png", "klut")):
        if any(design.density[f"macs_per_{kind}"] is not None for design in designs):
            pictures[name] = density_png(designs, kind)
    pictures |= {
        f"roofline-{design.array.name}.png": roofline_png(design) for design in designs if design.rows
    }
    for name, content in pictures.items():
        write_bytes(folder / name, content)
    table = {
        "format": 1, "command": command, "network": network,
        "designs": [design.to_dict() for design in designs],
        "paper_table_vi_ms": dict(PAPER_TABLE_VI),
        "peers": [peer.to_dict() for peer in PEERS],
        **about,
    }  # fmt: skip
    write_json(folder / "designs.json", table)
    write_text(folder / "designs.md", markdown(designs, network, command, list(pictures)))
    page = page_environment().get_template("designs.html.j2").render(
        designs=designs, network=network, command=command,
        head=HEAD, rows=[design_cells(design) for design in designs], note=note(designs),
        resource_head=RESOURCE_HEAD, resources=[resource_cells(design) for design in designs],
        lost_head=LOST_HEAD, lost=lost_cells(designs), lost_note=LOST_NOTE, dsp_note=DSP_NOTE,
        layer_head=LAYER_HEAD, layer_rows=[[layer_cells(row) for row in design.layers] for design in designs],
        peer_head=PEER_HEAD, peers=peer_cells(),
        pictures={name: inline_png(content) for name, content in pictures.items()},
    )  # fmt: skip
    write_text(folder / "designs.html", page)
    return folder / "designs.html"


def note(designs: Sequence[Design]) -> str:
    """What the milliseconds of the reference layer are, and what the paper's are."""
    measured = all(design.reference["simulated"] for design in designs)
    return NOTE if measured else CLOSED_FORM + PAPER_NOTE


def markdown(designs: Sequence[Design], network: str, command: str, pictures: Sequence[str]) -> str:
    """The tables as a Markdown page."""
    lines = ["# Designs", "", f"Written by `{command}`.", "", "## Reference layer", ""]
    lines += _table(HEAD, [design_cells(design) for design in designs], left={0, 2})
    lines += ["", note(designs), "", "## Resources", ""]
    lines += [
        *_table(RESOURCE_HEAD, [resource_cells(design) for design in designs], left={0, 7}),
        "",
        DSP_NOTE,
        "",
    ]
    lines += [
        "## Where the cycles go",
        "",
        *_table(LOST_HEAD, lost_cells(designs), left={0, 1}),
        "",
        LOST_NOTE,
        "",
    ]
    lines += [*(f"![{name}]({name})" for name in pictures), ""]
    for design in designs:
        if design.layers:
            total = design.network
            lines += [
                f"## {design.array.name}: every convolution of the network ({network})", "",
                f"{total['on_array']} of {total['layers']} run on the array as one pass or more: "
                f"{total['macs_on_array']:,} of {total['macs']:,} MAC in {total['cycles']:,} cycles, "
                f"{total['ms']:.1f} ms at 100 MHz.", "",
            ]  # fmt: skip
            lines += [*_table(LAYER_HEAD, [layer_cells(r) for r in design.layers], left={0, 1, 2, 3, 13}), ""]
    lines += ["## Published engines", "", *_table(PEER_HEAD, peer_cells(), left={0, 1, 6, 7}), ""]
    return "\n".join(lines)


def design_cells(design: Design) -> list[str]:
    """One row under `HEAD`."""
    row, array = design.reference, design.array
    name = f"{array.name} ({array.units} x {array.rows}, {array.engine})"
    if row["refused"] is not None:
        return [name, "", row["refused"], *[""] * (len(HEAD) - 3)]
    return [
        name, f"{row['cycles']:,}", "simulation" if row["simulated"] else "closed form", f"{row['ms']:.3f}",
        f"{row['macs_per_cycle']:,.0f}", f"{100 * row['utilisation']:.1f} %",
    ]  # fmt: skip


def resource_cells(design: Design) -> list[str]:
    """One row under `RESOURCE_HEAD`; empty where not synthesised."""
    have, density, name = design.resources, design.density, design.array.name
    if have is None:
        return [name, *[""] * (len(RESOURCE_HEAD) - 2), "not yet: macram synth on its configuration"]
    counts = [
        f"{_number(have[kind], 1 if have[kind] % 1 else 0)} ({have['percent'][kind]:.0f} %)"
        for kind in ("dsp", "lut", "ff", "bram")
    ]
    how = f"{have['mode']}, {have['device']}" + ("" if have["fits"] else ", which is too small for it")
    return [
        name, *counts, _number(density["macs_per_dsp"], 1), _number(density["macs_per_klut"], 1),
        f"{how}; design {have['design'][:12]}",
    ]  # fmt: skip


def lost_cells(designs: Sequence[Design]) -> list[list[str]]:
    """Rows under `LOST_HEAD`: the reference layer of each design, and its whole network."""
    rows = []
    for design in designs:
        for layers, row in (("reference layer", design.reference), ("network", design.network)):
            if row["lost"] is not None and row["cycles"]:
                cells = [f"{row['lost'][key]:,.0f}" for key in ("needed", *LOSSES, "total")]
                rows.append([design.array.name, layers, *cells])
    return rows


def layer_cells(row: dict[str, Any]) -> list[str]:
    """One row under `LAYER_HEAD`."""
    shape = f"{row['c_in']} -> {row['c_out']}, {row['height']} x {row['width']}"
    kernel = f"{row['kernel']}x{row['kernel']}/{row['stride']}"
    start = [row["name"], row["part"], shape, kernel]
    if row["refused"] is not None:
        return [*start, *[""] * 9, row["refused"]]
    lost = [f"{row['lost'][cause]:,.0f}" for cause in LOSSES]
    limit = "" if row["estimate"]["limited_by"] == "compute" else f"{row['estimate']['limited_by']} stream"
    return [
        *start, str(row["passes"]), f"{row['cycles']:,}",
        f"{row['macs_per_cycle']:,.0f}", f"{100 * row['utilisation']:.1f} %",
        *lost, f"{row['ms']:.3f}", limit,
    ]  # fmt: skip


def peer_cells() -> list[list[str]]:
    """Rows under `PEER_HEAD`."""
    return [
        [
            peer.name, peer.device, str(peer.bits), f"{peer.macs_per_cycle:,.0f}",
            _number(peer.macs_per_dsp, 1), _number(peer.macs_per_klut, 0), peer.basis, peer.source,
        ]
        for peer in PEERS
    ]  # fmt: skip


def _number(value: float | None, digits: int) -> str:
    return "" if value is None else f"{value:,.{digits}f}"


def _table(head: Sequence[str], rows: Sequence[Sequence[str]], left: set[int]) -> list[str]:
    marks = ["---" if index in left else "---:" for index in range(len(head))]
    return [f"| {' | '.join(cells)} |" for cells in (head, marks, *rows)]
