"""The cocotb bench of the constrained-random regression: one simulation, many cases.

The folder named by ``MACRAM_JOB`` holds ``job.json`` (array, seed, indices of the cases); the bench appends one line
per finished case to ``seen.jsonl``: what `macram_sim.regression.coverage` judges.
"""

from __future__ import annotations

import json
import os
import random
from pathlib import Path
from typing import Any

import cocotb
from cocotb.triggers import SimTimeoutError, with_timeout

from macram.spec import ArrayConfig
from macram_sim.clocks import PERIOD_NS, start_clocks
from macram_sim.regression.case import CaseBench
from macram_sim.regression.plan import Case, plan
from macram_sim.regression.scenarios import perform

CASE_CYCLES = 400_000
"""No case is near this long; one that gets here hangs."""


class CaseFailure(AssertionError):
    """A case failed; the message names it."""


@cocotb.test()
async def regression(dut: Any) -> None:
    """Perform the planned cases one after the other, each from where the one before left the array."""
    folder = Path(os.environ["MACRAM_JOB"])
    job = json.loads((folder / "job.json").read_text())
    array = ArrayConfig.from_dict(job["array"])
    wanted = set(job["indices"])
    start_clocks(dut)
    first = True
    with (folder / "seen.jsonl").open("w") as seen:
        for case in plan(array, job["seed"]):
            if case.index > max(wanted):
                break
            if case.index not in wanted:
                continue
            bench = CaseBench(dut, array, case)
            if first:
                await bench.transport.reset()
                first = False
            await _one(bench, case)
            seen.write(json.dumps(bench.observation()) + "\n")
            seen.flush()


async def _one(bench: CaseBench, case: Case) -> None:
    try:
        await with_timeout(
            perform(bench, random.Random(f"scenario {case.seed}")), CASE_CYCLES * PERIOD_NS, "ns"
        )
    except SimTimeoutError as error:
        raise CaseFailure(f"{case}: not finished after {CASE_CYCLES:,} cycles") from error
    except Exception as error:
        raise CaseFailure(f"{case}: {type(error).__name__}: {' '.join(str(error).split())[:400]}") from error
