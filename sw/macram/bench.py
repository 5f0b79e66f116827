"""How long things take: Verilator build, simulation, golden model, packing, inference. Every number is a median."""

from __future__ import annotations

import os
import statistics
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from macram.cpu_latency import measure_cpu
from macram.layer_job import CLOCK_HZ, Stage, array_for
from macram.network_latency import SIDES, SIZE, measure_network
from macram.report.latency import PAPER_TABLE_VI, REFERENCE
from macram.report.versions import machine, versions

BUILD_DIR_VARIABLE = "MACRAM_BUILD_DIR"
"""Where `macram_sim` keeps its builds; an empty folder there makes a build cold."""


def measure(*, repeat: int, seed: int, stage: Stage) -> dict[str, Any]:
    """Measure on the reference layer with random codes.

    Args:
        repeat: runs per measurement, 1 or more; the cold build is run once, it dwarfs its own spread.
        seed: of the codes.
        stage: opens a named stage.

    Returns:
        ``measurements``: rows with ``name``, ``median_s``, ``runs_s`` and, where it says something, ``rate``;
        ``table_vi``: the layer in the paper, on this processor, on the simulated array; ``network``: the whole
        network as integers beside its float32 forward pass; ``machine``, ``versions``, ``seed``.
    """
    from macram import golden, pack  # noqa: PLC0415
    from macram_sim.array import build_array, simulate  # noqa: PLC0415

    array = array_for(REFERENCE)
    with stage("random codes"):
        case = golden.random_case(REFERENCE, seed)
    rows = []
    with stage("golden model"):
        rows.append(_row("golden model, whole layer", _timed(lambda: golden.run_layer(case), repeat)))
    with stage("packing"):
        rows.append(
            _row("packing weights and thresholds", _timed(lambda: pack.pack_layer(case, array), repeat))
        )
    packed = pack.pack_layer(case, array)
    with _empty_build_folder():
        with stage("Verilog export and Verilator build, cold"):
            start = time.perf_counter()
            build_array(array)
            rows.append(_row("Verilog export and Verilator build, cold", [time.perf_counter() - start]))
        with stage("simulation"):
            results = [simulate(packed, case.input, seed=seed) for _ in range(repeat)]
    seconds = [result.wall_seconds for result in results]
    cycles = int(results[0].counters["cycles"])
    rows.append(
        _row("simulation, whole layer", seconds)
        | {"cycles": cycles, "cycles_per_second": round(cycles / statistics.median(seconds))}
    )
    with stage("the layer on this processor"):
        cpu = measure_cpu(repeat)
    with stage("the whole network on this processor"):
        network = measure_network(repeat, seed, size=SIZE, sides=SIDES)
    return {
        "format": 3,
        "measurements": rows,
        "table_vi": {
            "paper_ms": [{"device": name, "ms": ms} for name, ms in PAPER_TABLE_VI],
            "this_cpu": cpu,
            "array_simulated": {"cycles": cycles, "ms_at_100mhz": 1e3 * cycles / CLOCK_HZ},
        },
        "network": network,
        "seed": seed,
        "machine": machine(),
        "versions": versions(),
    }


def measure_only_network(
    *, repeat: int, seed: int, stage: Stage, size: str, sides: Sequence[int]
) -> dict[str, Any]:
    """The ``network`` part of `measure` alone, of any size, so that its memory is its own.

    Args:
        repeat: runs per measurement.
        seed: of weights and pictures.
        stage: opens a named stage.
        size: one of `macram.model.SIZES`.
        sides: of the square pictures, multiples of 32.

    Raises:
        ValueError: an unknown size, or a side that is no multiple of 32.
    """
    with stage(f"the network {size} on this processor"):
        network = measure_network(repeat, seed, size=size, sides=sides)
    return {"format": 1, "network": network, "seed": seed, "machine": machine(), "versions": versions()}


def _row(name: str, seconds: list[float]) -> dict[str, Any]:
    """One measurement as plain values."""
    return {
        "name": name,
        "median_s": round(statistics.median(seconds), 4),
        "runs_s": [round(value, 4) for value in seconds],
    }


def _timed(work: Callable[[], object], repeat: int) -> list[float]:
    """Seconds of ``repeat`` runs, after one that warms caches."""
    work()
    seconds = []
    for _ in range(repeat):
        start = time.perf_counter()
        work()
        seconds.append(time.perf_counter() - start)
    return seconds


@contextmanager
def _empty_build_folder() -> Iterator[None]:
    """Builds go to a new folder, so the first is cold and the user's cache stays."""
    before = os.environ.get(BUILD_DIR_VARIABLE)
    with tempfile.TemporaryDirectory(prefix="macram-bench-") as folder:
        os.environ[BUILD_DIR_VARIABLE] = str(Path(folder))
        try:
            yield
        finally:
            if before is None:
                del os.environ[BUILD_DIR_VARIABLE]
            else:
                os.environ[BUILD_DIR_VARIABLE] = before
