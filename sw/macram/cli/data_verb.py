"""``macram data render | info | show | verify | compare``."""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console
    from rich.progress import Progress

    from macram.data.spec import RenderSpec

LINES = 20
"""Problems that ``verify`` prints before it only counts."""


def data(arguments: argparse.Namespace) -> int:
    """Run one action."""
    # Late: the grammar above is loaded by every command, OpenCV and the renderer are not.
    from macram.cli.console import open_console  # noqa: PLC0415

    action: Callable[[argparse.Namespace, Console], int] = ACTIONS[arguments.action]
    return action(arguments, open_console())


def _render(arguments: argparse.Namespace, console: Console) -> int:
    import os  # noqa: PLC0415

    from macram.data.produce import produce  # noqa: PLC0415
    from macram.data.recipe import read_recipe  # noqa: PLC0415

    recipe = None if arguments.recipe is None else read_recipe(arguments.recipe)
    spec = spec_of(arguments) if recipe is None else recipe.spec
    jobs = arguments.jobs or os.cpu_count() or 1
    start, before = time.perf_counter(), None
    _announce(console, f"rendering {spec.total} pictures into {arguments.out}")
    with _bar(console, "img/s") as bar:
        task = bar.add_task("rendering", total=spec.total, rate=0.0)
        told = 0
        for done in produce(arguments.out, spec, jobs):
            before = done if before is None else before
            seconds = time.perf_counter() - start
            rate = (done - before) / seconds
            bar.update(task, completed=done, rate=rate)
            # Without a terminal there is no bar: a line per tenth.
            if not console.is_terminal and done * 10 // spec.total > told:
                told = done * 10 // spec.total
                left = (spec.total - done) / rate if rate else 0.0
                console.print(f"{done}/{spec.total} pictures, {rate:.1f} img/s, {left:.0f} s to go")
    if recipe is not None:
        recipe.check(arguments.out)
    made = spec.total - (before or 0)
    seconds = time.perf_counter() - start
    console.print(
        f"{arguments.out}: {spec.total} pictures, {made} of them new, {seconds:.1f} s",
        highlight=False, markup=False, soft_wrap=True,
    )  # fmt: skip
    return 0


def spec_of(arguments: argparse.Namespace) -> RenderSpec:
    """The specification that a command line asks for."""
    from macram.data.spec import TIERS as SPECS  # noqa: PLC0415
    from macram.data.spec import as_speed  # noqa: PLC0415

    spec = SPECS[arguments.tier]
    if arguments.format == "speed":
        if arguments.size is not None or arguments.focal is not None:
            raise ValueError("--size and --focal are fixed in SPEED's format; leave them away")
        spec = as_speed(spec)
    size = spec.size if arguments.size is None else (arguments.size, arguments.size)
    near = spec.depth[0] if arguments.dmin is None else arguments.dmin
    far = spec.depth[1] if arguments.dmax is None else arguments.dmax
    return replace(
        spec,
        size=size,
        focal=spec.focal if arguments.focal is None else arguments.focal,
        depth=(near, far),
        sequences=tuple(arguments.seqs or spec.sequences),
        frames=spec.frames if arguments.frames is None else arguments.frames,
        seed=arguments.seed,
        background=arguments.background,
    )


def _info(arguments: argparse.Namespace, console: Console) -> int:
    import json  # noqa: PLC0415

    from rich.table import Table  # noqa: PLC0415

    from macram.data.open import open_dataset  # noqa: PLC0415
    from macram.data.summary import summarise  # noqa: PLC0415

    report = summarise(open_dataset(arguments.root))
    if arguments.json:
        print(json.dumps(report, indent=2))
        return 0
    model = report["model"]
    title = f"{model['name']}, {model['diameter_mm']:.2f} mm, {model['keypoints']} keypoints"
    table = Table(title=title)
    names = ("split", "frames", "sequences", "depth d", "near", "medium", "far", "mask px 5, 50, 95 %")
    for column in names:
        table.add_column(column, justify="left" if column == "split" else "right")
    for split, row in report["splits"].items():
        if not row["frames"]:
            table.add_row(split, "0")
            continue
        depth, masks = row["depth_diameters"], row["mask_pixels"]
        table.add_row(
            split,
            str(row["frames"]),
            str(row["sequences"]),
            f"{depth[0]:.2f} to {depth[1]:.2f}",
            *(str(count) for count in row["buckets"].values()),
            f"{masks['p5']} / {masks['p50']} / {masks['p95']}",
        )
    console.print(table)
    for split, row in report["splits"].items():
        bins = row.get("depth_histogram", [])
        most = max((line["frames"] for line in bins), default=1)
        for line in bins:
            length = round(40 * line["frames"] / most)
            console.print(
                f"{split:>12} {line['from']:4.0f}d {'█' * length} {line['frames']}", highlight=False
            )
    return 0


def _show(arguments: argparse.Namespace, console: Console) -> int:
    import numpy as np  # noqa: PLC0415

    from macram.data.files import write_picture  # noqa: PLC0415
    from macram.data.open import open_dataset  # noqa: PLC0415
    from macram.data.sheet import contact_sheet  # noqa: PLC0415

    if arguments.number < 1 or arguments.columns < 1:
        raise ValueError("--number and --columns must be 1 or more")
    if arguments.out.suffix not in (".png", ".jpg"):
        raise ValueError(f"{arguments.out}: the contact sheet is a .png or .jpg file")
    dataset = open_dataset(arguments.root)
    split = arguments.split or dataset.splits[0]
    frames = dataset.frames(split)
    if not frames:
        raise ValueError(f"{arguments.root}: split {split} is empty")
    chosen = np.unique(
        np.linspace(0, len(frames) - 1, min(arguments.number, len(frames))).round().astype(int)
    )
    sheet = contact_sheet([frames[index] for index in chosen], arguments.columns)
    arguments.out.parent.mkdir(parents=True, exist_ok=True)
    write_picture(arguments.out, sheet)
    console.print(f"{arguments.out}", highlight=False, markup=False, soft_wrap=True)
    return 0


def _verify(arguments: argparse.Namespace, console: Console) -> int:
    from macram.data.open import open_dataset  # noqa: PLC0415
    from macram.data.verify import check_all  # noqa: PLC0415

    dataset = open_dataset(arguments.root)
    total = sum(len(dataset.frames(split)) for split in dataset.splits)
    problems: list[str] = []
    start = time.perf_counter()
    _announce(console, f"checking {total} frames of {arguments.root}")
    with _bar(console, "img/s") as bar:
        task = bar.add_task("checking", total=total, rate=0.0)
        for number, problem in enumerate(check_all(dataset), 1):
            bar.update(task, completed=min(number, total), rate=number / (time.perf_counter() - start))
            if problem is not None:
                problems.append(problem)
    for line in problems[:LINES]:
        console.print(line, highlight=False, markup=False, soft_wrap=True)
    if len(problems) > LINES:
        console.print(f"... and {len(problems) - LINES} more")
    verdict = f"{len(problems)} problems" if problems else "no problem"
    console.print(
        f"{arguments.root}: {total} frames, {verdict}", highlight=False, markup=False, soft_wrap=True
    )
    return 1 if problems else 0


def _compare(arguments: argparse.Namespace, console: Console) -> int:
    from macram.data.compare import chosen_frames, compare, comparison_sheet  # noqa: PLC0415
    from macram.data.files import write_picture  # noqa: PLC0415

    if arguments.samples < 1:
        raise ValueError(f"--samples must be 1 or more, not {arguments.samples}")
    if arguments.out.suffix not in (".png", ".jpg"):
        raise ValueError(f"{arguments.out}: the comparison is a .png or .jpg file")
    spec, frames = chosen_frames(arguments.root, arguments.split, arguments.frames)
    rows = []
    start = time.perf_counter()
    _announce(console, f"tracing {len(frames)} frames of {arguments.root}")
    with _bar(console, "img/s") as bar:
        task = bar.add_task("tracing", total=len(frames), rate=0.0)
        for number, frame in enumerate(frames, 1):
            rows.append(compare(spec, frame, arguments.samples))
            bar.update(task, completed=number, rate=number / (time.perf_counter() - start))
    for row in rows:
        console.print(
            f"{row.name}: silhouettes overlap {100 * row.overlap:.2f} %",
            highlight=False, markup=False, soft_wrap=True,
        )  # fmt: skip
    arguments.out.parent.mkdir(parents=True, exist_ok=True)
    write_picture(arguments.out, comparison_sheet(rows))
    console.print(f"{arguments.out}", highlight=False, markup=False, soft_wrap=True)
    return 0


def _announce(console: Console, work: str) -> None:
    """Where there is no bar, say what takes its time before it does."""
    if not console.is_terminal:
        console.print(f"{work} ...", highlight=False, markup=False, soft_wrap=True)


def _bar(console: Console, unit: str) -> Progress:
    """Progress with rate and time left; silent without a terminal."""
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn  # noqa: PLC0415

    return Progress(
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("{task.fields[rate]:.1f} " + unit),
        TimeRemainingColumn(),
        console=console,
        disable=not console.is_terminal,
    )


ACTIONS: dict[str, Callable[[argparse.Namespace, Console], int]] = {
    "render": _render,
    "info": _info,
    "show": _show,
    "verify": _verify,
    "compare": _compare,
}
