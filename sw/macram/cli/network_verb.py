"""``macram network``: every convolution of a network simulated at full size, estimates beside counted cycles."""

from __future__ import annotations

import argparse
import dataclasses
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from macram.cli.examples import say_more
from macram.cli.status import FAILED, OK

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from macram.network import NetworkTable, Shape

SEED = 2022
DETAIL = (
    "Simulates every distinct layer shape of the network on the array's exported Verilog, with random codes, compares "
    "every output code with the golden model and the cycles with the closed form. Writes network.html, network.md and "
    "network.json. A shape that is done is not simulated again, as long as array, gateware and seed are the same: stop "
    "and go on at will. With --weights a picture goes through a trained network, every convolution of it on the array "
    "with what the array gave before, and every code is compared with the deployed network; writes picture.html, "
    "picture.md, picture.json and picture.png with the pose."
)
EXAMPLES = """\
examples:
  macram network configs/zu3eg.toml                     all shapes of CA-SpaceNet at 512 x 512
  macram network configs/zu3eg.toml --only head         those of the head
  macram network configs/zu3eg.toml --only 64-128-      those with 64 input and 128 output channels
  macram network configs/zu3eg.toml --limit 5           five more, the shortest first
  macram network configs/zu3eg.toml --limit 0           only the table of what is done
  macram network configs/zu3eg.toml --weights quarter-w3a3     an example picture to its pose, all on the array

The array needs partial sums for --weights, because some convolutions must leave exact sums; where the
configuration has none, partial_sum_c_in is set to max_c_in. The simulator is kept as by macram layer.
"""


def add_network(verb: Callable[[str, str, str, str], argparse.ArgumentParser]) -> None:
    """The grammar of ``macram network``; ``verb`` makes a top-level verb."""
    sub = verb("network", "network_verb", "simulate every convolution of a network at full size", DETAIL)
    say_more(sub, EXAMPLES)
    sub.add_argument(
        "config", nargs="?", type=Path, metavar="CONFIG.toml", help="array (default: the reference array)"
    )
    sub.add_argument(
        "--size",
        help="network: paper, quarter, eighth, paper-front or tiny (default: paper)",
    )
    sub.add_argument("--side", type=int, metavar="N", help="pictures of N x N pixels (default: 512)")
    sub.add_argument(
        "--only",
        action="append",
        default=[],
        metavar="TEXT",
        help="simulate only shapes with TEXT in a layer's name or in the shape, as 64-128-128x128-3x3-1; repeatable",
    )
    sub.add_argument(
        "--limit", type=int, metavar="N", help="simulate at most N more shapes, the shortest first"
    )
    sub.add_argument("--seed", type=int, help=f"of the codes (default: {SEED})")
    sub.add_argument(
        "--weights",
        metavar="MODEL",
        help="a picture through this network instead: model.safetensors of a run, or a shipped name",
    )
    sub.add_argument("--image", type=Path, help="picture for --weights (default: an example)")
    sub.add_argument("--focal", type=float, help="its focal length in pixels (default: as of macram demo)")
    sub.add_argument(
        "-o", "--out", type=Path, metavar="DIR", help="default: build/network/ARRAY or ARRAY-MODEL"
    )


def network(arguments: argparse.Namespace) -> int:
    """Simulate what is not done yet, write the table; 1 if a code or a cycle differs."""
    from macram.cli.console import open_console  # noqa: PLC0415
    from macram.cli.stages import Stages  # noqa: PLC0415
    from macram.network import distinct_shapes, find_record, network_table, wanted_shapes  # noqa: PLC0415
    from macram.network.page import summary, write_network  # noqa: PLC0415
    from macram.report.versions import machine, versions  # noqa: PLC0415
    from macram.spec import ArrayConfig  # noqa: PLC0415
    from macram.synth.sources import design_hash  # noqa: PLC0415

    for name, least in (("seed", 0), ("limit", 0), ("side", 32)):
        value = getattr(arguments, name)
        if value is not None and value < least:
            raise ValueError(f"--{name} must be {least} or more, not {value}")
    array = ArrayConfig() if arguments.config is None else ArrayConfig.from_toml(arguments.config)
    if arguments.weights is not None:
        from macram.cli.network_picture import network_picture  # noqa: PLC0415

        return network_picture(arguments, array)
    if arguments.image is not None or arguments.focal is not None:
        raise ValueError(
            "--image and --focal go with --weights; name a network, such as --weights quarter-w3a3"
        )
    size, seed = arguments.size or "paper", SEED if arguments.seed is None else arguments.seed
    out = arguments.out or Path("build/network") / array.name
    side, runs = _runs(size, arguments.side)
    shapes = distinct_shapes(runs, array)
    wanted = wanted_shapes(shapes, arguments.only)
    records_of = out / "shapes"
    records_of.mkdir(parents=True, exist_ok=True)
    console = open_console()
    with Stages(console)(f"{array.name}: export the Verilog"):
        design = design_hash(array)
    found = {shape: find_record(records_of, shape, design, seed) for shape in shapes}
    records = {shape: record for shape, record in found.items() if record is not None}
    missing = [shape for shape in wanted if not records.get(shape, {}).get("passed")][: arguments.limit]
    records |= _simulate(missing, records_of, design, seed, console)
    table = network_table(array, shapes, records)
    page = write_network(
        out,
        table,
        network=f"{size}, deployable, {side} x {side} pixels",
        command=_command(arguments.config, size, arguments.side, seed),
        about={"design": design, "seed": seed, "versions": versions(), "machine": machine()},
    )
    console.print(_printed(table))
    for line in (summary(table), str(page)):
        console.print(line, highlight=False, markup=False, soft_wrap=True)
    return OK if table.passed else FAILED


def _runs(size: str, side: int | None) -> tuple[int, list[dict[str, Any]]]:
    """Side of the picture, and the convolutions that run on an array: all but the first, which stays on the host."""
    from macram.model.counts import PARTS, conv_runs  # noqa: PLC0415
    from macram.model.sizes import spacenet_config  # noqa: PLC0415

    config = spacenet_config(size, "deployable")
    if side is not None:
        config = dataclasses.replace(config, image_size=side)
    runs = [dataclasses.asdict(run) for run in conv_runs(config) if run.part != PARTS[0]]
    return config.image_size, runs


def _simulate(
    shapes: list[Shape], folder: Path, design: str, seed: int, console: Console
) -> dict[Shape, dict[str, Any]]:
    """Simulate the shapes one after the other, a line for each and a bar in cycles; their records."""
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn  # noqa: PLC0415

    from macram.cli.stages import Stages  # noqa: PLC0415
    from macram.network import simulate_shape  # noqa: PLC0415
    from macram_sim.array import build_array  # noqa: PLC0415

    records: dict[Shape, dict[str, Any]] = {}
    if not shapes:
        return records
    with Stages(console)("build its simulator"):
        build_array(shapes[0].array)
    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        TextColumn("{task.percentage:.0f} % of the cycles"),
    )
    times = (TimeElapsedColumn(), TextColumn("left:"), TimeRemainingColumn())
    with Progress(*columns, *times, console=console, speed_estimate_period=600) as bar:
        task = bar.add_task("", total=sum(shape.cycles for shape in shapes))
        done = 0
        for index, shape in enumerate(shapes, 1):
            place = f"[{index}/{len(shapes)}] {shape.label}"
            bar.update(task, description=place, completed=done)

            def told(share: float, before: int = done, cycles: int = shape.cycles) -> None:
                bar.update(task, completed=before + share * cycles)

            record = records[shape] = simulate_shape(folder, shape, design, seed, told)
            done += shape.cycles
            bar.update(task, completed=done)
            bar.console.print(
                f"{place}: {shape.cycles:,} cycles estimated, {record['cycles']:,} simulated, "
                f"{record['mismatches']:,} of {record['compared']:,} codes differ, "
                f"{record['simulation_seconds']:.0f} s",
                highlight=False,
                markup=False,
                soft_wrap=True,
            )
    return records


def _printed(table: NetworkTable) -> Table:
    """The table for a terminal: what stands on the page, without the lost cycles' columns."""
    from rich.box import SIMPLE  # noqa: PLC0415
    from rich.table import Table  # noqa: PLC0415

    from macram.designs.losses import LOSSES  # noqa: PLC0415
    from macram.network.page import HEAD, LEFT, cells  # noqa: PLC0415

    shown = [index for index, head in enumerate(HEAD) if head not in (HEAD[0], "passes", *LOSSES)]
    grid = Table(title=f"{table.array.name}: convolutions by shape", box=SIMPLE, padding=(0, 1, 0, 0))
    for index in shown:
        grid.add_column(
            HEAD[index], justify="left" if index in LEFT else "right", no_wrap=index < len(HEAD) - 1
        )
    for row in cells(table):
        grid.add_row(*(row[index] for index in shown))
    return grid


def _command(config: Path | None, size: str, side: int | None, seed: int) -> str:
    """What to type to get the same again; which part of it was run when does not matter."""
    words = ["macram network", *([str(config)] if config else [])]
    words += [f"--size {size}"] if size != "paper" else []
    words += [f"--side {side}"] if side is not None else []
    return " ".join([*words, f"--seed {seed}"])
