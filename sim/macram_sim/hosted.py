"""Layers one after the other on one simulated array, every image made by the caller from the results so far."""

from __future__ import annotations

import pickle
import shutil
import time
from collections.abc import Callable, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from macram.driver import COUNTERS
from macram.pack import PackedLayer
from macram_sim.array import build_array
from macram_sim.build import SimulationError
from macram_sim.folders import gone_if_interrupted, job_folder
from macram_sim.progress import watching
from macram_sim.runner import run

LAYERS = "layers.pickle"
HOST_GONE = "stop"
LOOK_SECONDS = 0.01


@dataclass(frozen=True)
class HostedResult:
    """One layer through the array.

    Attributes:
        codes: int64 ``[c_out, out_height, out_width]``; partial sums if the layer gives them.
        counters: cycle counters by the names of `macram.driver.COUNTERS`.
        elapsed: cycles since the layer before was done: loads that did not hide behind it, and register accesses,
            included.
    """

    codes: NDArray[np.int64]
    counters: dict[str, int]
    elapsed: int


def simulate_hosted(
    layers: Sequence[PackedLayer],
    next_image: Callable[[int], NDArray[np.integer]],
    done: Callable[[int, HostedResult], None],
    *,
    seed: int = 0,
    told: Callable[[float], None] | None = None,
) -> None:
    """Load and run layers in order on the exported Verilog, by `macram.driver.ArrayDriver.run_sequence`.

    Args:
        layers: packed for the same array.
        next_image: makes the image ``[c_in, height, width]`` of the layer of an index, once those before are done.
        done: called with every result, in order.
        seed: of the simulator.
        told: called now and then, from another thread, with the share of the present run that is done.

    Raises:
        SimulationError: the build or the simulation failed.
        ToolError: a tool is missing.
    """
    model = build_array(layers[0].array)
    folder = job_folder(layers[0].array.name)
    with (folder / LAYERS).open("wb") as file:
        pickle.dump(list(layers), file)
    with gone_if_interrupted(folder), watching(folder, told), ThreadPoolExecutor(1) as pool:
        simulation = pool.submit(
            run, model, "macram_sim.bench_hosted", folder / "run", seed=seed, env={"MACRAM_JOB": str(folder)}
        )
        try:
            for index in range(len(layers)):
                codes = next_image(index)
                put(folder / image_file(index), lambda file, codes=codes: np.save(file, codes))  # type: ignore[misc]
                done(index, _await(folder / result_file(index), simulation))
        except BaseException:
            (folder / HOST_GONE).touch()
            raise
        simulation.result()
    shutil.rmtree(folder, ignore_errors=True)


def image_file(index: int) -> str:
    """Of a job folder: what the host leaves for the bench."""
    return f"image_{index:04d}.npy"


def result_file(index: int) -> str:
    """Of a job folder: what the bench leaves for the host."""
    return f"result_{index:04d}.npz"


def put(path: Path, write: Callable[[BinaryIO], None]) -> None:
    """Let a file appear when it is complete."""
    begun = path.with_name(f".{path.name}")
    with begun.open("wb") as file:
        write(file)
    begun.replace(path)


def _await(path: Path, simulation: Future[Any]) -> HostedResult:
    while not path.is_file():
        if simulation.done() and not path.is_file():
            simulation.result()
            raise SimulationError(f"the simulation ended without {path.name}; see {path.parent / 'run'}")
        time.sleep(LOOK_SECONDS)
    with np.load(path) as parts:
        counters = dict(zip(COUNTERS, parts["counters"].tolist(), strict=True))
        result = HostedResult(parts["codes"], counters, int(parts["elapsed"]))
    path.unlink()
    return result
