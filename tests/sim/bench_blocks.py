"""cocotb test of layers in blocks of input channels, one after the other; test_partial_sums_sim.py runs it.

The job folder holds ``layers.json`` and per layer ``NNN/0``, ``NNN/1``, ... (the packed passes) and ``NNN/input.npy``,
for a layer with a residual sum ``NNN/residual.npz`` too; the bench adds ``NNN/output.npy`` and ``counters.json``.
"""

from __future__ import annotations

import json
import os
from pathlib import Path

import cocotb
import numpy as np

from macram.driver import ArrayDriver
from macram.golden import ResidualRule
from macram.pack import read_packed
from macram_sim.clocks import start_clocks
from macram_sim.transport import CocotbTransport


async def run_with_residual(driver, passes, image, rule, stream):
    """All blocks of one part of the output channels, the residual sum behind the last."""
    first, sums = 0, None
    for packed in passes:
        await driver.load(packed)
        last = not packed.sums_out
        await driver.configure(
            packed.spec, rule if last else None, sums_in=packed.sums_in, sums_out=packed.sums_out
        )
        codes = image[first : first + packed.spec.c_in]
        result = await driver.run(codes, stream if last else None, sums=sums)
        first, sums = first + packed.spec.c_in, result.codes
    return result


@cocotb.test()
async def run_layers(dut):
    folder = Path(os.environ["MACRAM_JOB"])
    job = json.loads((folder / "layers.json").read_text())
    start_clocks(dut)
    transport = CocotbTransport(dut, gaps=job["gaps"], stalls=job["stalls"], seed=job["seed"])
    await transport.reset()
    counters, driver = [], None
    for name, count in job["layers"]:
        passes = [read_packed(folder / name / str(index)) for index in range(count)]
        image = np.load(folder / name / "input.npy")
        if driver is None:
            driver = ArrayDriver(transport, passes[0].array)
            await driver.identify()
        if (residual := folder / name / "residual.npz").exists():
            with np.load(residual) as parts:
                rule = ResidualRule(passes[0].spec.output, parts["table"], parts["bounds"])
                result = await run_with_residual(driver, passes, image, rule, parts["stream"])
            np.save(folder / name / "sums.npy", result.sums)
        else:
            result = await driver.run_passes(passes, image)
        np.save(folder / name / "output.npy", result.codes)
        counters.append(result.counters)
    (folder / "counters.json").write_text(json.dumps(counters))
