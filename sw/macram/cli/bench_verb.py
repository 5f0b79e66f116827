"""``macram bench``."""

from __future__ import annotations

import argparse
from typing import Any

from rich.table import Table

from macram.bench import measure, measure_only_network
from macram.cli.console import open_console
from macram.cli.stages import Stages
from macram.network_latency import SIDES
from macram.report.files import write_json


def bench(arguments: argparse.Namespace) -> int:
    """Measure, print a table, write ``bench.json``."""
    if arguments.seed < 0:
        raise ValueError(f"--seed must be 0 or more, not {arguments.seed}")
    if arguments.repeat < 1:
        raise ValueError(f"--repeat must be at least 1, not {arguments.repeat}")
    if arguments.side and not arguments.network:
        raise ValueError("--side goes with --network SIZE; add it")
    if arguments.network:
        return _only_network(arguments)
    arguments.out.mkdir(parents=True, exist_ok=True)
    console = open_console()
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
    console.print(_table_vi(report["table_vi"]))
    console.print(_network(report["network"]))
    write_json(arguments.out / "bench.json", report)
    console.print(f"{arguments.out / 'bench.json'}", highlight=False, markup=False, soft_wrap=True)
    return 0


def _only_network(arguments: argparse.Namespace) -> int:
    """Measure one network, print a table, write ``network-SIZE.json``."""
    console = open_console()
    report = measure_only_network(
        repeat=arguments.repeat,
        seed=arguments.seed,
        stage=Stages(console),
        size=arguments.network,
        sides=arguments.side or SIDES,
    )
    arguments.out.mkdir(parents=True, exist_ok=True)
    path = arguments.out / f"network-{arguments.network}.json"
    write_json(path, report)
    console.print(_network(report["network"]))
    console.print(f"{path}", highlight=False, markup=False, soft_wrap=True)
    return 0


def _table_vi(table: dict[str, Any]) -> Table:
    """The paper's latencies, this processor's, and the simulated array's, in milliseconds."""
    rows = Table(title="the same layer beside the paper's table VI")
    for column in ("where", "threads", "ms"):
        rows.add_column(column, justify="left" if column == "where" else "right")
    for row in table["paper_ms"]:
        rows.add_row(f"{row['device']}, as printed in the paper", "", f"{row['ms']:.2f}")
    for row in table["this_cpu"]:
        rows.add_row(f"this processor, {row['name']}", str(row["threads"]), f"{row['median_ms']:.2f}")
    array = table["array_simulated"]
    rows.add_row(
        f"the array, {array['cycles']:,} simulated cycles at 100 MHz", "", f"{array['ms_at_100mhz']:.2f}"
    )
    return rows


def _network(measured: list[dict[str, Any]]) -> Table:
    """The whole network as integers beside its float32 forward pass."""
    rows = Table(title="the whole network on this processor")
    for column in ("network", "picture", "threads", "float32 ms", "integers ms", "ratio", "peak GiB"):
        rows.add_column(column, justify="left" if column == "network" else "right")
    for row in measured:
        picture = f"{row['side']} x {row['side']}"
        times = f"{row['float_ms']:.1f}", f"{row['integer_ms']:.1f}", f"{row['ratio']:.2f}"
        memory = f"{row['peak_gib']:.2f}"
        rows.add_row(row["network"], picture, str(row["threads"]), *times, memory)
    return rows
