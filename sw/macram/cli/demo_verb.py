"""``macram demo``."""

from __future__ import annotations

import argparse
import shlex
from typing import Any

from macram.cli.console import open_console
from macram.cli.stages import Stages
from macram.cli.traffic import traffic
from macram.demo import STAGES, run_demo
from macram.layer_job import run_summary


def demo(arguments: argparse.Namespace) -> int:
    """Run the chain; 0 only if no code differs anywhere."""
    console = open_console()
    stages = Stages(console, STAGES)
    run, report = run_demo(
        arguments.image,
        arguments.out,
        stage=stages,
        finished=stages.done,
        checkpoint=arguments.checkpoint,
        focal=arguments.focal,
        traffic=traffic(arguments),
        command=_again(arguments),
    )
    console.print(_pose_line(report["pose"]), highlight=False, markup=False, soft_wrap=True)
    own = report["pose"]["run"]
    console.print(
        f"its layer {report['pose']['layer']}, learned weights: {own['compared']:,} codes compared, "
        f"{own['mismatches']:,} differ; {own['cycles']:,} cycles",
        highlight=False, markup=False, soft_wrap=True,
    )  # fmt: skip
    for row in report["comparisons"]:
        first = f", first {row['first_difference']}" if row["mismatches"] else ""
        line = f"{row['name']}: {row['compared']:,} codes compared, {row['mismatches']:,} differ{first}"
        console.print(line, highlight=False, markup=False, soft_wrap=True)
    console.print(run_summary(run), highlight=False, markup=False, soft_wrap=True)
    console.print(f"report: {arguments.out / 'report.html'}", highlight=False, markup=False, soft_wrap=True)
    return 0 if report["passed"] else 1


def _pose_line(pose: dict[str, Any]) -> str:
    """What the learned network found."""
    line = f"{pose['image']} by {pose['network']} ({pose['form']}): "
    if pose["pose"] is None:
        return line + "no pose"
    x, y, z = pose["pose"]["cam_t_m2c"]
    line += f"at {x:.0f} {y:.0f} {z:.0f} mm, score {pose['pose']['score']:.2f}"
    if errors := pose["errors"]:
        line += f"; off by {errors['rotation_deg']:.1f} deg and {errors['translation_mm']:.1f} mm"
    return line


def _again(arguments: argparse.Namespace) -> str:
    """The command that repeats this run, without the folders of this machine."""
    words = ["macram", "demo"]
    for option in ("image", "checkpoint"):
        if path := getattr(arguments, option):
            words += [f"--{option}", path.name]
    if arguments.focal is not None:
        words += ["--focal", str(arguments.focal)]
    words += ["--seed", str(arguments.seed)]
    for option, default in (("gaps", "none"), ("stalls", "none"), ("load", "file")):
        if (value := getattr(arguments, option)) != default:
            words += [f"--{option}", value]
    return shlex.join(words)
