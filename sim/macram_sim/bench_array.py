"""The cocotb bench of the whole array: runs one job folder, which `macram_sim.array` writes and reads.

The folder holds ``job.json``, ``input.npy`` ``[c_in, height, width]``, the packed passes and ``residual.npz`` if the
job has a residual sum; the bench adds ``output.npy`` and, with a residual sum, ``sums.npy``
``[c_out, out_height, out_width]``, and ``result.json``.
"""

from __future__ import annotations

import json
import os
import random
import sys
import time
from pathlib import Path
from typing import Any

import cocotb
import numpy as np
from cocotb.triggers import ClockCycles

from macram.driver import ArrayDriver
from macram.golden import ResidualRule
from macram.pack import read_packed
from macram.spec import BY_NAME, REGISTERS
from macram_sim.clocks import start_clocks
from macram_sim.progress import leave_share
from macram_sim.transport import CocotbTransport

PROGRESS_SECONDS = 2.0


class Progress:
    """The share of output beats, every two seconds at most: a line on stderr, or a file for whoever watches it.

    Args:
        transfers: images that will run, passes counted one by one.
        folder: where to leave the share of all of them together; None prints that of each.
    """

    def __init__(self, transfers: int, folder: Path | None) -> None:
        self._start = self._last = time.monotonic()
        self._transfers, self._folder = transfers, folder
        self._done = self._received = 0

    def __call__(self, received: int, expected: int) -> None:
        """Tell if the last time is long enough ago."""
        self._done += received < self._received
        self._received = received
        now = time.monotonic()
        if now - self._last >= PROGRESS_SECONDS:
            self._last = now
            if self._folder is not None:
                leave_share(self._folder, (self._done + received / expected) / self._transfers)
                return
            share = 100 * received / expected
            print(
                f"  simulated {share:5.1f} % of {expected:,} output beats, {now - self._start:.0f} s",
                file=sys.stderr,
                flush=True,
            )


async def snoop(clock: Any, transport: CocotbTransport, seed: int, counts: dict[str, int]) -> None:
    """Read random registers at random moments, and check those whose value is known."""
    rng = random.Random(f"snoop {seed}")
    known = {name: BY_NAME[name].reset for name in ("ID", "VERSION")}
    while True:
        register = rng.choice(REGISTERS)
        value = await transport.read(register.offset)
        assert value == known.get(register.name, value), f"{register.name} reads {value:#x} during a run"
        counts["register_reads"] += 1
        await ClockCycles(clock, rng.randrange(1, 40))


@cocotb.test()
async def run_job(dut: Any) -> None:
    """Identify the array, load and configure the layer, run the image as often as the job says."""
    folder = Path(os.environ["MACRAM_JOB"])
    job = json.loads((folder / "job.json").read_text())
    passes = [read_packed(folder / name) for name in job["passes"]]
    image = np.load(folder / "input.npy")
    progress = Progress(job["runs"] * len(passes), folder if job["watched"] else None)
    transport = CocotbTransport(
        dut, gaps=job["gaps"], stalls=job["stalls"], seed=job["seed"], progress=progress
    )
    start_clocks(dut)
    await transport.reset()
    driver = ArrayDriver(transport, passes[0].array)
    await driver.identify()
    rule, stream = None, None
    if job["residual"]:
        with np.load(folder / "residual.npz") as parts:
            rule = ResidualRule(passes[0].spec.output, parts["table"], parts["bounds"])
            stream = parts["stream"]
    if len(passes) == 1:
        if job["load"] == "stream":
            await driver.load(passes[0])
        await driver.configure(passes[0].spec, rule)
    counts = {"register_reads": 0}
    snooper = cocotb.start_soon(snoop(dut.aclk, transport, job["seed"], counts)) if job["snoop"] else None
    results = [
        await (driver.run(image, stream) if len(passes) == 1 else driver.run_passes(passes, image))
        for _ in range(job["runs"])
    ]
    if snooper is not None:
        snooper.cancel()
    np.save(folder / "output.npy", np.stack([result.codes for result in results]))
    if stream is not None:
        np.save(folder / "sums.npy", np.asarray(results[-1].sums))
    (folder / "result.json").write_text(
        json.dumps({"counters": [result.counters for result in results], **counts})
    )
