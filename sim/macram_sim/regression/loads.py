"""Loads, one beat at a time: what the scenarios that disturb them share."""

from __future__ import annotations

import random
from collections.abc import Awaitable, Callable

from macram.driver import Beats
from macram.spec import Control
from macram_sim.regression.case import CaseBench

Scenario = Callable[[CaseBench, random.Random], Awaitable[None]]


async def begin_load(bench: CaseBench, weights: bool) -> Beats:
    """Command a load of the layer's own words; the beats that it takes."""
    packed = bench.run.packed
    weight_base, requant_base = bench.place.bases(bench.spec, bench.array)
    await bench.write("PARAM_BASE", weight_base if weights else requant_base)
    await bench.write("PARAM_WORDS", packed.weight_words if weights else packed.requant_words)
    await bench.write("CONTROL", Control.LOAD_WEIGHTS if weights else Control.LOAD_REQUANT)
    return packed.load_beats()[not weights]
