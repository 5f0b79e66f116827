"""cocotb test of one layer in passes, with and without loading beside the run; test_kinds.py runs it.

The job folder holds ``passes.json``, the packed passes and ``input.npy``; the bench adds ``output.npy`` and
``cycles.json``.
"""

from __future__ import annotations

import json
import os
from pathlib import Path

import cocotb
import numpy as np
from cocotb.clock import Clock
from cocotb.utils import get_sim_time

from macram.driver import ArrayDriver
from macram.pack import read_packed
from macram_sim.transport import PERIOD_NS, CocotbTransport


def cycles() -> int:
    return round(get_sim_time("ns") / PERIOD_NS)


@cocotb.test()
async def overlapped_and_one_by_one(dut):
    folder = Path(os.environ["MACRAM_JOB"])
    passes = [read_packed(folder / name) for name in json.loads((folder / "passes.json").read_text())]
    image = np.load(folder / "input.npy")
    Clock(dut.aclk, PERIOD_NS, unit="ns").start()
    transport = CocotbTransport(dut)
    await transport.reset()
    driver = ArrayDriver(transport, passes[0].array)

    start = cycles()
    overlapped = await driver.run_passes(passes, image)
    middle = cycles()
    loading, codes = 0, []
    for packed in passes:
        before = cycles()
        await driver.load(packed)
        loading += cycles() - before
        await driver.configure(packed.spec)
        codes.append((await driver.run(image)).codes)
    end = cycles()

    np.testing.assert_array_equal(np.concatenate(codes), overlapped.codes)
    np.save(folder / "output.npy", overlapped.codes)
    (folder / "cycles.json").write_text(
        json.dumps(
            {
                "overlapped": middle - start,
                "one by one": end - middle,
                "loading": loading,
                "counted": overlapped.counters["cycles"],
            }
        )
    )
