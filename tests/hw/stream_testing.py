"""Drivers for `lib.stream` interfaces in Amaranth's simulator, with gaps and stalls."""

import random

from amaranth.sim import Simulator


async def put(ctx, stream, payloads, *, gap=0.0, rng=None):
    """Send ``payloads``; before each, idle with probability ``gap`` per cycle."""
    rng = rng or random.Random(0)
    for payload in payloads:
        while rng.random() < gap:
            await ctx.tick()
        ctx.set(stream.payload, payload)
        ctx.set(stream.valid, 1)
        await ctx.tick().until(stream.ready)
        ctx.set(stream.valid, 0)


async def get(ctx, stream, count, *, stall=0.0, rng=None):
    """Receive ``count`` payloads, refusing with probability ``stall``; a waiting payload must not change."""
    rng = rng or random.Random(1)
    received, waiting = [], None
    while len(received) < count:
        ready = rng.random() >= stall
        ctx.set(stream.ready, ready)
        *_, valid, payload = await ctx.tick().sample(stream.valid, stream.payload)
        if waiting is not None:
            assert valid, "TVALID fell before the beat was taken"
            assert payload == waiting, "the payload changed while it waited"
        waiting = payload if valid and not ready else None
        if valid and ready:
            received.append(payload)
    ctx.set(stream.ready, 0)
    return received


def simulate(dut, *testbenches, background=(), cycles=20_000):
    """Run until every testbench has ended, which must happen within ``cycles`` clock cycles.

    If there is a domain ``double``, it gets twice the clock, in phase.
    """
    sim = Simulator(dut)
    sim.add_clock(1e-8)
    sim.add_clock(0.5e-8, phase=0.5e-8, domain="double", if_exists=True)
    for bench in testbenches:
        sim.add_testbench(bench)
    for bench in background:
        sim.add_testbench(bench, background=True)
    steps = 0
    while sim.advance():
        steps += 1
        assert steps < 8 * cycles, f"not finished after {cycles} cycles"
