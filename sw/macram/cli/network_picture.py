"""``macram network --weights``: a picture through a trained network, every convolution on the simulated array."""

from __future__ import annotations

import argparse
from pathlib import Path

from macram.cli.status import FAILED, OK
from macram.spec import ArrayConfig


def network_picture(arguments: argparse.Namespace, array: ArrayConfig) -> int:
    """Run the picture, or go on where it was stopped; 1 if a code or the pose differs."""
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn  # noqa: PLC0415

    from macram.cli.console import open_console  # noqa: PLC0415
    from macram.cli.stages import Stages  # noqa: PLC0415
    from macram.demo import demo_image  # noqa: PLC0415
    from macram.network.picture import PictureNetwork  # noqa: PLC0415
    from macram.network.picture_page import summary, write_picture  # noqa: PLC0415
    from macram.report.versions import machine, versions  # noqa: PLC0415
    from macram.synth.sources import design_hash  # noqa: PLC0415
    from macram.weights import weights_file  # noqa: PLC0415
    from macram_sim.array import build_array  # noqa: PLC0415

    for name in ("size", "side", "only", "limit", "seed"):
        if getattr(arguments, name) not in (None, []):
            raise ValueError(f"--{name} has no part in a run with --weights; leave it away")
    image = arguments.image or demo_image()
    if image is None:
        raise ValueError("no example image in this installation; name one with --image PICTURE")
    console = open_console()
    stages = Stages(console)
    with stages("the deployed network"):
        shown = PictureNetwork(image, weights_file(arguments.weights), array, arguments.focal)
    path = Path(arguments.weights)
    # A run's network has no name of its own.
    weights = path.resolve().parent.name if path.stem == "model" else path.stem
    out = arguments.out or Path("build/network") / f"{array.name}-{weights}"
    with stages(f"{shown.array.name}: export the Verilog"):
        design = design_hash(shown.array)
    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        TextColumn("{task.percentage:.0f} % of the cycles"),
    )
    times = (TimeElapsedColumn(), TextColumn("left:"), TimeRemainingColumn())
    bar = Progress(*columns, *times, console=console, speed_estimate_period=600)

    def told(done: int, share: float) -> None:
        steps = network.steps
        cycles: float = sum(step.cycles for step in steps[:done])
        here = ""
        if done < len(steps):
            # Of a convolution in passes, the share is that of the present one.
            here, cycles = steps[done].op.name, cycles + share * steps[done].cycles / len(steps[done].passes)
        bar.update(task, description=f"[{done}/{len(steps)}] {here}", completed=cycles)

    network, judge = shown.on_array(out / "results", design, told)
    out.mkdir(parents=True, exist_ok=True)
    with stages("build its simulator"):
        build_array(shown.array)
    task = bar.add_task("", total=sum(step.cycles for step in network.steps))
    with bar:
        run = judge()
    height, width = run.report["input"][1:]
    command = ["macram network", *([str(arguments.config)] if arguments.config else [])]
    command += [f"--weights {arguments.weights}", *([f"--image {image}"] if arguments.image else [])]
    command += [f"--focal {arguments.focal:g}"] if arguments.focal is not None else []
    page = write_picture(
        out,
        run,
        shown.array,
        network=f"{weights}, {run.report['form']}, {height} x {width} pixels",
        command=" ".join(command),
        about={"design": design, "versions": versions(), "machine": machine()},
    )
    for row in run.rows:
        if row["mismatches"]:
            console.print(
                f"FAILED {row['name']}: {row['mismatches']:,} of {row['compared']:,} differ",
                highlight=False, markup=False, soft_wrap=True,
            )  # fmt: skip
    for line in (summary(run), str(page)):
        console.print(line, highlight=False, markup=False, soft_wrap=True)
    return OK if run.passed else FAILED
