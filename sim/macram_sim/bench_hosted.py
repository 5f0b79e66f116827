"""The cocotb bench of layers whose images another process makes: the host's part stays outside the simulator.

The folder named by ``MACRAM_JOB`` holds ``layers.pickle``. Image n is awaited as ``image_n.npy``; the bench leaves
``result_n.npz``: ``codes``, ``counters`` in the order of `macram.driver.COUNTERS` and ``elapsed``.
See `macram_sim.hosted`.
"""

from __future__ import annotations

import os
import pickle
import time
from pathlib import Path
from typing import Any

import cocotb
import numpy as np
from cocotb.utils import get_sim_time
from numpy.typing import NDArray

from macram.driver import COUNTERS, ArrayDriver, RunResult
from macram_sim.clocks import PERIOD_NS, start_clocks
from macram_sim.hosted import HOST_GONE, LAYERS, LOOK_SECONDS, image_file, put, result_file
from macram_sim.progress import leave_share
from macram_sim.transport import CocotbTransport


@cocotb.test()
async def run_layers(dut: Any) -> None:
    """Identify the array, then load and run every layer, each loaded while the one before it runs if both fit."""
    folder = Path(os.environ["MACRAM_JOB"])
    with (folder / LAYERS).open("rb") as file:
        layers = pickle.load(file)
    transport = CocotbTransport(dut, progress=lambda moved, expected: leave_share(folder, moved / expected))
    start_clocks(dut)
    await transport.reset()
    driver = ArrayDriver(transport, layers[0].array)
    await driver.identify()
    before = 0

    def leave(results: list[RunResult]) -> None:
        nonlocal before
        now = round(get_sim_time("ns") / PERIOD_NS)
        counters = np.array([results[-1].counters[name] for name in COUNTERS])
        codes = results[-1].codes
        put(
            folder / result_file(len(results) - 1),
            lambda file: np.savez(file, codes=codes, counters=counters, elapsed=now - before),
        )
        before = now

    def next_image(results: list[RunResult]) -> NDArray[np.int64]:
        if results:
            leave(results)
        # The array's clock stands still while the host works.
        image = folder / image_file(len(results))
        while not image.is_file():
            if (folder / HOST_GONE).is_file():
                raise RuntimeError("the host gave up")
            time.sleep(LOOK_SECONDS)
        leave_share(folder, 0.0)
        codes: NDArray[np.int64] = np.load(image)
        return codes

    leave(await driver.run_sequence(layers, next_image))
