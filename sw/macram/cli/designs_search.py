"""``macram designs --search``: which array is the fastest that fits a device."""

from __future__ import annotations

import argparse
import dataclasses
import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rich.console import Console

    from macram.cli.stages import Stages
    from macram.spec import ArrayConfig

DEVICES = ("xczu3eg",)
"""Whose units have been counted."""
ARRAYS = ("zu3eg", "paper")
"""Counted whole, for what lies outside the units."""
UNITS = (
    ("dsp48e2_2x", 1, 0), ("dsp48e2_2x", 2, 1), ("dsp48e2_2x", 2, 3), ("dsp48e2_2x", 5, 0), ("dsp48e2_2x", 5, 3),
    ("dsp48e2_2x", 10, 6), ("dsp48e2", 2, 1), ("dsp48e2", 11, 2), ("soft", 0, 8),
)  # fmt: skip
"""Counted by themselves: engine, DSP slices, soft rows beside them."""


def search_designs(arguments: argparse.Namespace, runs: Sequence[Mapping[str, Any]]) -> int:
    """Search, write the files and print the head of the ranking."""
    from macram.cli.console import open_console  # noqa: PLC0415
    from macram.cli.stages import Stages  # noqa: PLC0415
    from macram.designs.lut_model import COUNTS, LutModel, read_counts  # noqa: PLC0415
    from macram.designs.search import candidate, layer_shape, search  # noqa: PLC0415
    from macram.designs.search_page import HEAD, cells, write_search  # noqa: PLC0415
    from macram.export import default_array  # noqa: PLC0415
    from macram.report.versions import machine, versions  # noqa: PLC0415
    from macram.synth import devices  # noqa: PLC0415

    if arguments.search not in DEVICES:
        raise ValueError(f"--search must be {' or '.join(DEVICES)}, not {arguments.search!r}")
    if not runs:
        raise ValueError("--search ranks by a network; name one with --network")
    if arguments.configs or arguments.simulate:
        raise ValueError("--search goes through arrays of its own; leave out CONFIG.toml and --simulate")
    if arguments.synth is not None and not arguments.recount:
        raise ValueError("--search reads --synth only to count anew; add --recount or leave --synth away")
    device = devices.DEVICES[arguments.search]
    console = open_console()
    stages = Stages(console)
    shipped = default_array()
    arguments.out.mkdir(parents=True, exist_ok=True)
    counts = _recount(shipped, arguments, stages) if arguments.recount else read_counts()
    _say_if_old(counts, shipped, console)
    model = LutModel.fit(counts)
    with stages("every array of the space"):
        found = search(shipped, device, runs, model, track=lambda arrays: _bar(arrays, console))
    base = candidate(shipped, device, [layer_shape(run, shipped) for run in runs], model)
    about = {
        "command": f"macram designs --search {device.name} --network {arguments.network}",
        "network": arguments.network, "counts": COUNTS if not arguments.recount else str(arguments.out / COUNTS),
        "versions": versions(), "machine": machine(),
    }  # fmt: skip
    write_search(arguments.out, found, base, model, device, about)
    fitting = [one for one in found if not one.stopped_by]
    _show(console, f"the fastest of {len(fitting):,} that fit by estimate, then {shipped.name}", HEAD,
          [cells(one) for one in (*fitting[:8], base)])  # fmt: skip
    faster = [one for one in found if one.stopped_by and (not fitting or one.total < fitting[0].total)]
    _show(console, "faster ones, and what stops them", HEAD, [cells(one) for one in faster[:8]])
    for line in (
        f"estimate of LUTs: largest error {100 * model.worst:.1f} % over {len(model.units)} units and "
        f"{len(model.arrays)} arrays that were synthesised; an array near the limit needs macram synth",
        f"{arguments.out}/search.json, {arguments.out}/search.md, {arguments.out}/search.png",
    ):
        console.print(line, highlight=False, markup=False, soft_wrap=True)
    return 0


def _recount(shipped: ArrayConfig, arguments: argparse.Namespace, stages: Stages) -> dict[str, Any]:
    """Synthesise `UNITS`, take `ARRAYS` from the folder of counts, write the table."""
    from macram.cli.synth_verb import SYNTH_FOLDER  # noqa: PLC0415
    from macram.designs import find_resources  # noqa: PLC0415
    from macram.designs.lut_model import COUNTS, shell_of, unit_of  # noqa: PLC0415
    from macram.export.default import config_path  # noqa: PLC0415
    from macram.report.files import write_json  # noqa: PLC0415
    from macram.report.versions import versions  # noqa: PLC0415
    from macram.spec import ArrayConfig  # noqa: PLC0415
    from macram.synth.devices import DEVICES as KNOWN  # noqa: PLC0415
    from macram.synth.unit import count_unit, unit_hash  # noqa: PLC0415

    folder = arguments.synth or SYNTH_FOLDER
    reports = []
    for name in ARRAYS:
        path = config_path(f"{name}.toml")
        counted = find_resources(ArrayConfig.from_toml(path), folder)
        if counted is None or counted["mode"] != "hierarchical":
            raise ValueError(f"{folder} has no hierarchical counts of {name}; macram synth {path} makes them")
        reports.append(json.loads(Path(counted["file"]).read_text(encoding="utf-8")))
    units = []
    for engine, slices, soft in UNITS:
        array = unit_array(shipped, engine, slices, soft)
        with stages(f"Yosys, a unit of {slices} slices ({engine}) and {soft} soft rows"):
            used = count_unit(
                array, KNOWN[arguments.search], arguments.out / f"unit-{engine}-{slices}-{soft}", timeout=1800
            )
        units.append({"kinds": list(array.row_kinds), "lut": used["lut"], "design": unit_hash(array)})
    table = {
        "format": 1, "command": f"macram designs --search {arguments.search} --recount", "versions": versions(),
        "units": units + [unit_of(report) for report in reports], "arrays": [shell_of(report) for report in reports],
    }  # fmt: skip
    write_json(arguments.out / COUNTS, table)
    return table


def unit_array(shipped: ArrayConfig, engine: str, slices: int, soft: int) -> ArrayConfig:
    """An array with such units."""
    rows = soft + slices * (2 if engine == "dsp48e2_2x" else 1)
    return dataclasses.replace(shipped, engine=engine, rows=rows, soft_rows=0 if engine == "soft" else soft)


def _say_if_old(counts: Mapping[str, Any], shipped: ArrayConfig, console: Console) -> None:
    """Whether the counted units are of the gateware as it is now."""
    from macram.synth.unit import unit_hash  # noqa: PLC0415

    today = {unit_hash(unit_array(shipped, *unit)) for unit in UNITS}
    if old := sum(unit["design"] not in today for unit in counts["units"] if "design" in unit):
        console.print(
            f"{old} counted units are of older gateware, so the estimate of LUTs may be off; add --recount",
            highlight=False, markup=False, soft_wrap=True,
        )  # fmt: skip


def _bar(arrays: Sequence[ArrayConfig], console: Console) -> Iterator[ArrayConfig]:
    from rich.progress import track  # noqa: PLC0415

    one_by_one: Iterable[ArrayConfig] = track(
        arrays, "arrays", console=console, disable=not console.is_terminal, transient=True
    )
    yield from one_by_one


def _show(console: Console, title: str, head: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    from rich.table import Table  # noqa: PLC0415

    table = Table(caption=title)
    for index, column in enumerate(head):
        table.add_column(column, justify="right" if 0 < index < len(head) - 1 else "left")
    for row in rows:
        table.add_row(*row)
    console.print(table)
