"""Scenarios with a fault on a stream: TLAST that comes early or not at all, and streams that end too soon."""

from __future__ import annotations

import random
from collections.abc import Collection

from cocotb.triggers import ClockCycles

from macram.spec import Error, Status
from macram_sim.regression.case import CaseBench
from macram_sim.regression.loads import Scenario, begin_load


async def _ends_by_its_shape(
    bench: CaseBench, name: str, lasts: Collection[int], code: Error, event: str
) -> None:
    """With TLAST there the run goes on by the shape: exact codes, DONE and the error."""
    await bench.start()
    await bench.stream({name: lasts})
    await bench.ended(code)
    bench.events.add(event)


async def early(bench: CaseBench, rng: random.Random) -> None:
    """TLAST inside the image."""
    last = len(bench.run.beats["image"]) - 1
    at = int(bench.case.moment * last)
    await _ends_by_its_shape(bench, "image", {at, last}, Error.TLAST_EARLY, "TLAST_EARLY in an image")


async def missing(bench: CaseBench, rng: random.Random) -> None:
    """No TLAST on the image."""
    await _ends_by_its_shape(bench, "image", (), Error.TLAST_MISSING, "TLAST_MISSING in an image")


async def in_residual(bench: CaseBench, rng: random.Random) -> None:
    """Both faults of TLAST on the residual stream."""
    last = len(bench.run.beats["residual"]) - 1
    at, where = int(bench.case.moment * last), "in a residual stream"
    await _ends_by_its_shape(bench, "residual", {at, last}, Error.TLAST_EARLY, f"TLAST_EARLY {where}")
    await _ends_by_its_shape(bench, "residual", (), Error.TLAST_MISSING, f"TLAST_MISSING {where}")


async def in_sums(bench: CaseBench, rng: random.Random) -> None:
    """All faults of TLAST on partial sums: in the middle of a word, at a word's end, and none."""
    count, beats = len(bench.run.beats["params"]), bench.array.sum_word_beats
    word = int(bench.case.moment * (count // beats - 1))
    cases = [
        (word * beats + beats - 1, "TLAST_EARLY at the end of a word of sums"),
        (word * beats + rng.randrange(max(1, beats - 1)), "TLAST_EARLY within a word of sums"),
    ]
    for at, event in cases[: 1 + (beats > 1)]:
        await _ends_by_its_shape(bench, "params", {at, count - 1}, Error.TLAST_EARLY, event)
    await _ends_by_its_shape(bench, "params", (), Error.TLAST_MISSING, "TLAST_MISSING in partial sums")


def truncated(name: str, event: str) -> Scenario:
    """A stream that ends too soon: the array names the fault, stays busy, and a soft reset recovers it."""

    async def scenario(bench: CaseBench, rng: random.Random) -> None:
        await bench.start()
        part = 1 + int(bench.case.moment * (len(bench.run.beats[name]) - 2))
        tasks = bench.begin({name: part})
        await tasks[name]
        # Of partial sums the end of a word is looked at when the drain takes it.
        while not (code := await bench.read("ERROR")):
            pass
        assert code == Error.TLAST_EARLY
        await ClockCycles(bench.dut.aclk, 300)
        assert await bench.read("STATUS") & Status.BUSY, f"the array ended without the rest of {name}"
        for task in tasks.values():
            task.cancel()
        await bench.stop()
        bench.events.add(event)

    return scenario


def bad_load(weights: bool) -> Scenario:
    """Both faults of TLAST in a load, each of which ends it."""

    async def scenario(bench: CaseBench, rng: random.Random) -> None:
        what = "weights" if weights else "the requantiser"
        beats = bench.run.packed.load_beats()[not weights]
        if len(beats) > 1:
            await begin_load(bench, weights)
            part = 1 + int(bench.case.moment * (len(beats) - 2))
            await bench.transport.send("params", beats[:part])
            await bench.fails_with(Error.TLAST_EARLY, f"TLAST_EARLY in a load of {what}")
        await begin_load(bench, weights)
        await bench.transport.send("params", beats, ())
        await bench.fails_with(Error.TLAST_MISSING, f"TLAST_MISSING in a load of {what}")
        await bench.prepare()

    return scenario


SCENARIOS: dict[str, Scenario] = {
    "early TLAST": early,
    "missing TLAST": missing,
    "truncated image": truncated("image", "an image that ends too soon"),
    "bad weights load": bad_load(weights=True),
    "bad requant load": bad_load(weights=False),
    "bad TLAST in residual": in_residual,
    "truncated residual": truncated("residual", "a residual stream that ends too soon"),
    "bad TLAST in sums": in_sums,
    "truncated sums": truncated("params", "partial sums that end too soon"),
}
