"""``macram bench``."""

from __future__ import annotations

import argparse

from rich.console import Console
from rich.table import Table

from macram.bench import measure
from macram.cli.stages import Stages
from macram.report.files import write_json


def bench(arguments: argparse.Namespace) -> int:
    """Measure, print a table, write ``bench.json``."""
    if arguments.seed < 0:
        raise ValueError(f"--seed must be 0 or more, not {arguments.seed}")
    arguments.out.mkdir(parents=True, exist_ok=True)
    console = Console()
    report = measure(repeat=arguments.repeat, seed=arguments.seed, stage=Stages(console))
    where = report["machine"]
    table = Table(title=f"reference layer on {where['cpu']}, {where['cores']} cores")
    for column in ("measurement", "median s", "runs s", "cycles/s"):
        table.add_column(column, justify="left" if column == "measurement" else "right")
    for row in report["measurements"]:
        rate = f"{row['cycles_per_second']:,}" if "cycles_per_second" in row else ""
        runs = " ".join(f"{value:.3f}" for value in row["runs_s"])
        table.add_row(row["name"], f"{row['median_s']:.3f}", runs, rate)
    console.print(table)
    write_json(arguments.out / "bench.json", report)
    console.print(f"{arguments.out / 'bench.json'}", highlight=False, markup=False, soft_wrap=True)
    return 0
