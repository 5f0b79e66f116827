"""Scenarios without a fault: images one after the other, reloads, streams that come late, a layer in blocks."""

from __future__ import annotations

import random
from dataclasses import replace

import cocotb
import numpy as np
from cocotb.triggers import ClockCycles, Event

from macram.golden import random_case, run_layer
from macram.pack import pack_passes
from macram.spec import REGISTERS, Control, Error, Status
from macram_sim.regression.case import CaseBench
from macram_sim.regression.layer import LayerRun, draw_layer
from macram_sim.regression.loads import Scenario


async def plain(bench: CaseBench, rng: random.Random) -> None:
    """Nothing before the whole image that ends every case."""
    bench.events.add("one image")


async def reuse(bench: CaseBench, rng: random.Random) -> None:
    """Another image through the same words."""
    await bench.works()
    other = random_case(bench.case.spec, bench.case.seed + 1).input
    bench.use(replace(bench.run.layer, input=other))
    bench.events.add("another image, same weights")


async def reload(bench: CaseBench, rng: random.Random) -> None:
    """Other words of the same shape in the same place."""
    await bench.works()
    bench.use(draw_layer(bench.case, other=1))
    await bench.driver.load(bench.run.packed, place=bench.place)
    await bench.configure()
    bench.events.add("other weights, same shape")


async def snooped(bench: CaseBench, rng: random.Random) -> None:
    """Registers are read all the time."""
    running = True

    async def snoop() -> None:
        while running:
            register = rng.choice(REGISTERS)
            value = await bench.transport.read(register.offset)
            if register.name in ("ID", "VERSION"):
                assert value == register.reset, f"{register.name} reads {value:#x} during a run"
            await ClockCycles(bench.dut.aclk, rng.randrange(1, 30))

    task = cocotb.start_soon(snoop())
    await bench.works()
    running = False
    await task
    bench.events.add("registers read in a run")


async def back_to_back(bench: CaseBench, rng: random.Random) -> None:
    """The next image's first beats wait at the ports, and are the first ones after the next START."""
    sources = []
    for name, beats in bench.run.beats.items():
        count = len(beats)
        twice = bench.transport.send(name, np.concatenate([beats] * 2), {count - 1, 2 * count - 1})
        sources.append(cocotb.start_soon(twice))
    for _ in range(2):
        before = bench.transport.moved
        await bench.start()
        await bench.receive()
        await bench.ended()
        moved = bench.since(before)
        for name, beats in bench.run.beats.items():
            assert moved[name] == len(beats), f"{moved[name]} beats of {name} were taken, not {len(beats)}"
    for source in sources:
        await source
    bench.events.add("the next image waits at the port")


async def late_residual(bench: CaseBench, rng: random.Random) -> None:
    """Nothing leaves before the residual stream comes; its sums may be taken later than the codes."""
    cycles = rng.randrange(100, 300)
    await _late(bench, {"residual": cycles, "residual sums": cycles + rng.randrange(100)})
    bench.events |= {"a residual stream that comes late", "residual sums that are taken late"}


async def late_sums(bench: CaseBench, rng: random.Random) -> None:
    """Nothing leaves before the partial sums come."""
    await _late(bench, {"params": rng.randrange(100, 300)})
    bench.events.add("partial sums that come late")


async def _late(bench: CaseBench, late: dict[str, int]) -> None:
    await bench.start()
    before = bench.transport.moved
    image = cocotb.start_soon(bench.stream(late=late))
    await ClockCycles(bench.dut.aclk, min(late.values()))
    moved = bench.since(before)
    assert moved["image"], "the image waits for another stream from its first beat on"
    assert not moved["output"], f"{moved['output']} beats left before what they are made of came"
    await image
    await bench.ended()


async def all_blocks(bench: CaseBench, rng: random.Random) -> None:
    """The whole layer in its runs: what left the first comes back into the second."""
    layer = bench.run.layer
    result = await bench.driver.run_passes(pack_passes(layer, bench.array), layer.input)
    wrong = np.argwhere(result.codes != run_layer(layer))
    assert not len(wrong), f"{len(wrong)} codes of the layer in blocks differ, first {wrong[0].tolist()}"
    bench.events.add("a layer in blocks, its own sums coming back")
    await bench.prepare()


async def load_beside(bench: CaseBench, rng: random.Random) -> None:
    """The next layer is loaded at the other end of the memories while this one runs, then run from there.

    The image's last beat waits for the load, so the load ends first.
    """
    following = LayerRun.of(draw_layer(bench.case, other=1), bench.case, bench.array)
    hold = Event()
    await bench.start()
    image = cocotb.start_soon(bench.stream(hold=hold))
    await bench.driver.load(following.packed, place=bench.other_place)
    if await bench.read("STATUS") & Status.BUSY:
        bench.events.add("a layer loaded while an image runs")
    hold.set()
    await image
    await bench.ended()
    bench.place, bench.run = bench.other_place, following
    await bench.configure()
    bench.events.add("a run of the layer that was loaded beside another")


async def start_beside_load(bench: CaseBench, rng: random.Random) -> None:
    """START while words at the other end are loaded: refused if the run takes partial sums.

    Else it goes on beside the load, whose last beat waits for the image, so the image ends first.
    """
    beats = bench.run.packed.load_beats()[1]
    _, base = bench.other_place.bases(bench.spec, bench.array)
    await bench.write("PARAM_BASE", base)
    await bench.write("PARAM_WORDS", bench.run.packed.requant_words)
    await bench.write("CONTROL", Control.LOAD_REQUANT)
    half = len(beats) // 2
    await bench.transport.send("params", beats[:half], ())
    await bench.start()
    if bench.run.part.sums_in:
        await bench.fails_with(Error.BAD_RANGE, "BAD_RANGE, a start that takes sums beside a load")
        await bench.transport.send("params", beats[half:])
        return
    image = cocotb.start_soon(bench.stream())
    await bench.transport.send("params", beats[half:-1], ())
    await image
    await bench.ended()
    assert await bench.read("STATUS") & Status.LOADING, "an image ended a load"
    await bench.transport.send("params", beats[-1:])
    bench.events.add("an image begun and ended beside a load")


SCENARIOS: dict[str, Scenario] = {
    "plain": plain,
    "reuse": reuse,
    "reload": reload,
    "snooped": snooped,
    "back to back": back_to_back,
    "late residual": late_residual,
    "late sums": late_sums,
    "all blocks": all_blocks,
    "load beside": load_beside,
    "start beside a load": start_beside_load,
    "start beside a load, taking sums": start_beside_load,
}
