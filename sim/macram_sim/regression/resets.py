"""Scenarios with a reset, soft or hard, at every moment of a run or a load."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Callable

from cocotb.triggers import ClockCycles

from macram.spec import REGISTERS, Control, Status
from macram_sim.regression.case import CaseBench
from macram_sim.regression.loads import Scenario, begin_load

Reached = Callable[[CaseBench, Counter[str]], bool]


async def waiting(bench: CaseBench, rng: random.Random) -> None:
    """Armed, but nothing has come."""
    await bench.start()
    await ClockCycles(bench.dut.aclk, rng.randrange(1, 8))
    assert await bench.read("STATUS") & Status.BUSY
    await bench.stop()
    bench.events.add("soft reset before the first beat")


def when(reached: Reached, event: str, met: Reached) -> Scenario:
    """A soft reset once the beats that have moved are what was ``reached``; ``met`` decides whether it counts."""

    async def scenario(bench: CaseBench, rng: random.Random) -> None:
        await bench.start()
        start = bench.transport.moved
        tasks = bench.begin()
        await bench.until(lambda moved: reached(bench, moved))
        for task in tasks.values():
            task.cancel()
        moved = bench.since(start)
        await bench.stop()
        if met(bench, moved):
            bench.events.add(event)

    return scenario


def _in_run(bench: CaseBench, moved: Counter[str]) -> bool:
    return moved["image"] > 0 and moved["output"] < bench.run.beats_out["output"]


def between(name: str, event: str) -> Scenario:
    """A soft reset between two beats of a stream that has more than one."""

    def count(bench: CaseBench) -> int:
        return len(bench.run.beats[name]) if name in bench.run.beats else bench.run.beats_out[name]

    return when(
        lambda bench, moved: moved[name] >= 1 + bench.case.moment * 0.9 * (count(bench) - 2),
        event,
        lambda bench, moved: 0 < moved[name] < count(bench),
    )


def in_load(weights: bool) -> Scenario:
    """A soft reset when part of a load has come."""

    async def scenario(bench: CaseBench, rng: random.Random) -> None:
        beats = await begin_load(bench, weights)
        part = 1 + int(bench.case.moment * (len(beats) - 1))
        await bench.transport.send("params", beats[:part], ())
        await bench.stop()
        bench.events.add(f"soft reset in a load of {'weights' if weights else 'the requantiser'}")
        await bench.prepare()

    return scenario


async def with_commands(bench: CaseBench, rng: random.Random) -> None:
    """It overrides the commands written with it."""
    await bench.write("CONTROL", Control.SOFT_RESET | rng.choice([1, 2, 4, 7]))
    await ClockCycles(bench.dut.aclk, 8)
    assert await bench.read("STATUS") == 0, "a soft reset did not override the commands written with it"
    bench.events.add("soft reset with other commands")


async def hard(bench: CaseBench, rng: random.Random) -> None:
    """The reset input in the middle of an image: registers at their reset values, memories as they were."""
    await bench.start()
    tasks = bench.begin()
    await bench.until(lambda moved: moved["image"] >= bench.case.moment * len(bench.run.beats["image"]))
    for task in tasks.values():
        task.cancel()
    bench.transport.quiet()
    await bench.transport.reset()
    for register in REGISTERS:
        if register.access == "RW":
            value = await bench.read(register.name)
            assert value == register.reset, f"{register.name} is {value:#x} after a reset"
    assert await bench.read("STATUS") == 0
    await bench.configure()
    bench.events.add("reset input in a run")


SCENARIOS: dict[str, Scenario] = {
    "reset waiting": waiting,
    "reset filling": when(
        lambda bench, moved: moved["image"] >= 1 + bench.case.moment * 2,
        "soft reset while the line buffer fills",
        _in_run,
    ),
    "reset emitting": between("output", "soft reset between output beats"),
    "reset ending": when(
        lambda bench, moved: (
            moved["image"] == len(bench.run.beats["image"])
            or moved["output"] == bench.run.beats_out["output"]
        ),
        "soft reset after the last input beat",
        _in_run,
    ),
    "reset in residual": between("residual", "soft reset between beats of the residual stream"),
    "reset taking sums": between("params", "soft reset between beats of partial sums that come"),
    "reset giving sums": between("output", "soft reset between beats of partial sums that leave"),
    "reset in weights": in_load(weights=True),
    "reset in requant": in_load(weights=False),
    "reset with commands": with_commands,
    "hard reset": hard,
}
