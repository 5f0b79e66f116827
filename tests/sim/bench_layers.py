"""cocotb test that loads and runs many layers one after the other on one array; test_kinds.py runs it.

The job folder holds ``layers.json`` and per layer ``NNN/packed``, ``NNN/input.npy``; the bench adds
``NNN/output.npy`` and ``counters.json``.
"""

from __future__ import annotations

import json
import os
from pathlib import Path

import cocotb
import numpy as np
from cocotb.clock import Clock

from macram.driver import ArrayDriver
from macram.pack import read_packed
from macram_sim.transport import PERIOD_NS, CocotbTransport


@cocotb.test()
async def run_layers(dut):
    folder = Path(os.environ["MACRAM_JOB"])
    job = json.loads((folder / "layers.json").read_text())
    Clock(dut.aclk, PERIOD_NS, unit="ns").start()
    transport = CocotbTransport(dut, gaps=job["gaps"], stalls=job["stalls"], seed=job["seed"])
    await transport.reset()
    counters = []
    for name in job["layers"]:
        packed = read_packed(folder / name / "packed")
        driver = ArrayDriver(transport, packed.array)
        await driver.load(packed)
        await driver.configure(packed.spec)
        result = await driver.run(np.load(folder / name / "input.npy"))
        np.save(folder / name / "output.npy", result.codes)
        counters.append(result.counters)
    (folder / "counters.json").write_text(json.dumps(counters))
