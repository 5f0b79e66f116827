"""How a case goes: its scenario on a loaded and configured array, then a whole image."""

from __future__ import annotations

import random

from macram_sim.regression import commands, faults, images, resets
from macram_sim.regression.case import CaseBench
from macram_sim.regression.loads import Scenario

SCENARIOS: dict[str, Scenario] = images.SCENARIOS | commands.SCENARIOS | resets.SCENARIOS | faults.SCENARIOS
"""By the names of `macram_sim.regression.settings.SCENARIOS`."""


async def perform(bench: CaseBench, rng: random.Random) -> None:
    """Run the case's scenario from a loaded and configured array, then a whole image."""
    await bench.prepare()
    await SCENARIOS[bench.case.scenario](bench, rng)
    await bench.works()
