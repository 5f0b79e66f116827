"""``macram bench``."""

from __future__ import annotations

import argparse
from dataclasses import replace
from typing import Any

from rich.table import Table

from macram.bench import measure, measure_only_network
from macram.cli.console import open_console
from macram.cli.stages import Stages
from macram.network_latency import SIDES
from macram.report.files import write_json
from macram.report.versions import machine, versions

TRAIN_STEPS = 5
"""Training steps timed per repetition."""


def bench(arguments: argparse.Namespace) -> int:
    """Measure, print a table, write ``bench.json``."""
    if arguments.seed < 0:
        raise ValueError(f"--seed must be 0 or more, not {arguments.seed}")
    if arguments.repeat < 1:
        raise ValueError(f"--repeat must be at least 1, not {arguments.repeat}")
    if arguments.network and arguments.train:
        raise ValueError("--network and --train are two measurements; choose one")
    if arguments.set and not arguments.train:
        raise ValueError("--set goes with --train CONFIG.toml; add it")
    if arguments.side and not (arguments.network or arguments.train):
        raise ValueError("--side goes with --network SIZE or --train CONFIG.toml; add one of them")
    if arguments.network:
        return _only_network(arguments)
    if arguments.train:
        return _training(arguments)
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


def _training(arguments: argparse.Namespace) -> int:
    """Time the first steps of a training run, print a table, write ``train.json``."""
    from macram.train.memory import keep_memory  # noqa: PLC0415

    keep_memory()
    from macram.cli.train_verb import overrides  # noqa: PLC0415
    from macram.train.config import load_config  # noqa: PLC0415
    from macram.train.distributed import join_processes  # noqa: PLC0415
    from macram.train.rate import measure_rate  # noqa: PLC0415
    from macram.train.settings import CropPhase  # noqa: PLC0415

    config = load_config(arguments.train, overrides(arguments.set))
    if arguments.side:
        config = replace(config, crops=(CropPhase(1.0, tuple(arguments.side)),))
    console = open_console()
    with Stages(console)(f"first steps of {arguments.train.name}"):
        report = measure_rate(config, join_processes(), TRAIN_STEPS * arguments.repeat)
    rows = Table(
        title=f"training, {report['batch']} images a step, {report['precision']}, {report['device']}"
    )
    for column in ("part of a step", "median ms"):
        rows.add_column(column, justify="left" if column == "part of a step" else "right")
    for name, milliseconds in report["parts_ms"].items():
        rows.add_row(name, f"{milliseconds:.1f}")
    console.print(rows)
    console.print(f"{report['images_per_second']:.1f} images a second", highlight=False)
    arguments.out.mkdir(parents=True, exist_ok=True)
    path = arguments.out / "train.json"
    write_json(path, {"format": 1, **report, "machine": machine(), "versions": versions()})
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
