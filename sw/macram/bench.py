"""How long the tools take: Verilator build, simulation, golden model, packing. Every number is a median."""

from __future__ import annotations

import os
import statistics
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from macram.layer_job import Stage, array_for
from macram.report.latency import REFERENCE
from macram.report.versions import machine, versions

BUILD_DIR_VARIABLE = "MACRAM_BUILD_DIR"
"""Where `macram_sim` keeps its builds; an empty folder there makes a build cold."""


def measure(*, repeat: int, seed: int, stage: Stage) -> dict[str, Any]:
    """Measure on the reference layer with random codes.

    Args:
        repeat: runs per measurement; the cold build is run once, it dwarfs its own spread.
        seed: of the codes.
        stage: opens a named stage.

    Returns:
        ``measurements``: rows with ``name``, ``median_s``, ``runs_s`` and, where it says something, ``rate``;
        ``machine``, ``versions``, ``seed``.

    Raises:
        ValueError: ``repeat`` is below 1.
    """
    if repeat < 1:
        raise ValueError(f"--repeat must be at least 1, not {repeat}")
    from macram import golden, pack  # noqa: PLC0415
    from macram_sim.array import build_array, simulate  # type: ignore[import-untyped]  # noqa: PLC0415

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
    if scale := _torch_runner():
        with stage("PyTorch float32 convolution, for scale"):
            rows.append(_row("PyTorch float32 convolution of the same shape", _timed(scale, repeat)))
    return {
        "format": 1,
        "measurements": rows,
        "seed": seed,
        "machine": machine(),
        "versions": versions(),
    }


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


def _torch_runner() -> Callable[[], object] | None:
    """The same convolution in PyTorch float32 on this CPU, or None where PyTorch is not installed."""
    try:
        import torch  # noqa: PLC0415
    except ModuleNotFoundError:
        return None
    image = torch.rand(1, REFERENCE.c_in, REFERENCE.height, REFERENCE.width)
    kernel = torch.rand(REFERENCE.c_out, REFERENCE.c_in, REFERENCE.kernel, REFERENCE.kernel)
    return lambda: torch.nn.functional.conv2d(image, kernel, padding=REFERENCE.padding)
