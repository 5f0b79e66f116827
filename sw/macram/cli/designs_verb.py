"""``macram designs``: arrays compared, on the reference layer and on every layer of the network."""

from __future__ import annotations

import argparse
import dataclasses
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from macram.cli.stages import Stages
    from macram.spec import ArrayConfig

DETAIL = (
    "Writes designs.html, designs.md, designs.json and pictures: cycles, multiply-accumulates per cycle, "
    "utilisation and lost cycles of the reference layer and of every convolution of the network, a roofline, and "
    "bars beside the paper's table VI and published engines. Cycles are the closed form's; --simulate runs the "
    "reference layer on the exported Verilog, compares every code, and takes the array's own counters. LUT, FF, DSP "
    "and RAMB36, and with them the densities, are those of macram synth, if it has counted exactly this design."
)


def add_designs(verb: Callable[[str, str, str, str], argparse.ArgumentParser]) -> None:
    """The grammar of ``macram designs``; ``verb`` makes a top-level verb."""
    sub = verb("designs", "designs_verb", "compare arrays: cycles, where they go, resources, peers", DETAIL)
    sub.add_argument(
        "configs", nargs="*", type=Path, metavar="CONFIG.toml", help="arrays (default: the reference array)"
    )
    sub.add_argument(
        "--network",
        default="paper",
        metavar="SIZE",
        help="network for the layer tables: paper, quarter, eighth, paper-front, tiny, or none (default: paper)",
    )
    sub.add_argument(
        "--synth",
        type=Path,
        metavar="DIR",
        help="where macram synth wrote its counts (default: build/synth); only those of the very same design are taken",
    )
    sub.add_argument(
        "--search",
        metavar="DEVICE",
        help="instead, rank every mix of units and engines that could fit DEVICE (xczu3eg) by the network's cycles: "
        "search.json, search.md and search.png, with the limit that stops each array and the error of the LUT estimate",
    )
    sub.add_argument(
        "--recount",
        action="store_true",
        help="with --search: synthesise the units behind the LUT estimate anew (many minutes) and take the arrays "
        "zu3eg and paper from --synth; else the counts that come with the package are used",
    )
    sub.add_argument("--simulate", action="store_true", help="run the reference layer on every array")
    sub.add_argument("--seed", type=int, default=2022, help="of the simulated codes (default: 2022)")
    sub.add_argument("-o", "--out", type=Path, default=Path("build/designs"), metavar="DIR")


def designs(arguments: argparse.Namespace) -> int:
    """Describe every array, write the pages; 1 if a simulated code differs."""
    from macram.cli.console import open_console  # noqa: PLC0415
    from macram.cli.stages import Stages  # noqa: PLC0415
    from macram.cli.synth_verb import SYNTH_FOLDER  # noqa: PLC0415
    from macram.designs import describe, find_resources, write_designs  # noqa: PLC0415
    from macram.report.versions import machine, versions  # noqa: PLC0415
    from macram.spec import ArrayConfig  # noqa: PLC0415

    if arguments.search is not None:
        from macram.cli.designs_search import search_designs  # noqa: PLC0415

        return search_designs(arguments, _runs(arguments.network))
    if arguments.recount:
        raise ValueError("--recount belongs to --search; name a device with --search xczu3eg")
    if arguments.seed < 0:
        raise ValueError(f"--seed must be 0 or more, not {arguments.seed}")
    arrays = [ArrayConfig.from_toml(path) for path in arguments.configs] or [ArrayConfig()]
    names = [array.name for array in arrays]
    if twice := next((name for name in names if names.count(name) > 1), None):
        raise ValueError(f"two arrays are named {twice!r}; give each configuration its own name")
    network = "" if arguments.network == "none" else f"{arguments.network}, deployable"
    runs = _runs(arguments.network)
    console = open_console()
    stages = Stages(console)
    arguments.out.mkdir(parents=True, exist_ok=True)
    counts = arguments.synth or SYNTH_FOLDER
    if arguments.synth is not None and not counts.is_dir():
        raise ValueError(f"{counts}: no such folder; name the one that macram synth wrote to")
    results, passed, uncounted = [], True, []
    for array, config in zip(arrays, arguments.configs or [None], strict=True):
        counters = None
        if arguments.simulate:
            counters, equal = _simulate(array, arguments.seed, arguments.out / array.name, stages)
            passed &= equal
        with stages(f"{array.name}: every layer"):
            resources = find_resources(array, counts)
            results.append(describe(array, runs, simulated=counters, resources=resources))
        if resources is None:
            uncounted.append(
                f"{array.name}: {counts} has no counts of this design as it is now; "
                f"macram synth {config or 'CONFIG.toml'} makes them"
            )
    with stages("tables and pictures"):
        page = write_designs(
            arguments.out,
            results,
            network=network,
            command=_command(arguments),
            about={"seed": arguments.seed, "versions": versions(), "machine": machine()},
        )
    for design in results:
        row = design.reference
        what = row["refused"] or f"{row['cycles']:,} cycles, {row['ms']:.3f} ms at 100 MHz"
        console.print(f"{design.array.name}: {what}", highlight=False, markup=False, soft_wrap=True)
    for line in uncounted:
        console.print(line, highlight=False, markup=False, soft_wrap=True)
    console.print(str(page), highlight=False, markup=False, soft_wrap=True)
    return 0 if passed else 1


def _runs(size: str) -> list[dict[str, Any]]:
    """Convolutions that run on an array: all but the first, which stays in float on the host."""
    if size == "none":
        return []
    from macram.model.counts import PARTS, conv_runs  # noqa: PLC0415
    from macram.model.sizes import spacenet_config  # noqa: PLC0415

    runs = conv_runs(spacenet_config(size, "deployable"))
    return [dataclasses.asdict(run) for run in runs if run.part != PARTS[0]]


def _simulate(array: ArrayConfig, seed: int, folder: Path, stages: Stages) -> tuple[dict[str, int], bool]:
    from macram.golden import random_case  # noqa: PLC0415
    from macram.layer_job import run_layer_job, write_run  # noqa: PLC0415
    from macram.report.latency import REFERENCE  # noqa: PLC0415

    layer = dataclasses.replace(REFERENCE, weight=array.weight, input=array.input, output=array.output)
    array.check_admits(layer)
    with stages(f"{array.name}: the reference layer on the exported Verilog"):
        run = run_layer_job(random_case(layer, seed), array=array)
    write_run(run, folder)
    if not run.passed:
        stages.console.print(f"FAILED {array.name}: {run.comparison}", markup=False, soft_wrap=True)
    return run.counters, run.passed


def _command(arguments: argparse.Namespace) -> str:
    """What to type to get the same again."""
    words = ["macram designs", *map(str, arguments.configs), f"--network {arguments.network}"]
    words += [f"--synth {arguments.synth}"] if arguments.synth else []
    return " ".join([*words, *(["--simulate"] if arguments.simulate else []), f"--seed {arguments.seed}"])
