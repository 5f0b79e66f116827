"""``macram demo``."""

from __future__ import annotations

import argparse
import shlex

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
        traffic=traffic(arguments),
        command=_again(arguments),
    )
    for row in report["comparisons"]:
        first = f", first {row['first_difference']}" if row["mismatches"] else ""
        line = f"{row['name']}: {row['compared']:,} codes compared, {row['mismatches']:,} differ{first}"
        console.print(line, highlight=False, markup=False, soft_wrap=True)
    console.print(run_summary(run), highlight=False, markup=False, soft_wrap=True)
    console.print(f"report: {arguments.out / 'report.html'}", highlight=False, markup=False, soft_wrap=True)
    return 0 if report["passed"] else 1


def _again(arguments: argparse.Namespace) -> str:
    """The command that repeats this run, without the folders of this machine."""
    words = ["macram", "demo"]
    for option in ("image", "checkpoint"):
        if path := getattr(arguments, option):
            words += [f"--{option}", path.name]
    words += ["--seed", str(arguments.seed)]
    for option, default in (("gaps", "none"), ("stalls", "none"), ("load", "file")):
        if (value := getattr(arguments, option)) != default:
            words += [f"--{option}", value]
    return shlex.join(words)
