"""The residual adder against its golden rule, with gaps and stalls on all four streams."""

import random

import numpy as np
import pytest
from stream_testing import get, put, simulate

from macram.golden import ResidualRule
from macram.spec import RESIDUAL, ArrayConfig, IntFormat
from macram_hw.residual import ResidualAdder

U3 = IntFormat(3)
RULES = {
    "plain": ResidualRule(U3, np.arange(8) * 9, np.array([3, 20, 41, 60, 100, 180, 254])),
    "saturating": ResidualRule(U3, np.arange(8) * 36, np.array([0, 1, 2, 253, 254, 255, 255])),
    "nothing": ResidualRule(U3, np.zeros(8, np.int64), np.full(7, 255)),
    "all at once": ResidualRule(U3, np.full(8, 255), np.zeros(7, np.int64)),
}
ARRAY = ArrayConfig(units=16, rows=2, drain=4, max_c_in=16, max_c_out=32, weight_depth=64)


def fields(codes, bits):
    """``[words, channels]`` -> one integer per word, channel 0 lowest."""
    return [sum(int(code) << (bits * k) for k, code in enumerate(word)) for word in codes]


def run(rule, branch, stream, *, enable=True, hurry=0.0, seed=0):
    """Words out of the adder: codes, sums, and the pixel marks of both."""
    dut = ResidualAdder(ARRAY)
    rng = random.Random(seed)
    marks = [(rng.random() < 0.3, rng.random() < 0.1) for _ in branch]
    words = [
        {"data": data, "pixel_last": a, "last": b}
        for data, (a, b) in zip(fields(branch, ARRAY.output.bits), marks, strict=True)
    ]
    out, sums = [], []

    async def prepare(ctx):
        ctx.set(dut.enable, enable)
        for name, values in (("table", rule.table), ("bounds", rule.bounds)):
            for k, value in enumerate(values):
                ctx.set(getattr(dut.tables, name)[k], int(value))
        await put(ctx, dut.i, words, gap=hurry, rng=random.Random(seed + 1))

    async def residual(ctx):
        await put(ctx, dut.residual, fields(stream, RESIDUAL.bits), gap=hurry, rng=random.Random(seed + 2))

    async def receive(ctx):
        out.extend(await get(ctx, dut.o, len(words), stall=hurry, rng=random.Random(seed + 3)))

    async def receive_sums(ctx):
        sums.extend(await get(ctx, dut.sums, len(words), stall=hurry, rng=random.Random(seed + 4)))

    async def untouched(ctx):
        ctx.set(dut.residual.valid, 1)
        async for *_, ready, valid in ctx.tick().sample(dut.residual.ready, dut.sums.valid):
            assert not ready
            assert not valid

    if enable:
        simulate(dut, prepare, receive, residual, receive_sums)
    else:
        simulate(dut, prepare, receive, background=[untouched])

    def codes(received, bits):
        count = ARRAY.output_word_channels
        return np.array([[w.data >> (bits * k) & ((1 << bits) - 1) for k in range(count)] for w in received])

    for received in (out, sums) if enable else (out,):
        assert [(w.pixel_last, w.last) for w in received] == marks
    return codes(out, ARRAY.output.bits), codes(sums, RESIDUAL.bits) if enable else None


@pytest.mark.parametrize("hurry", [0.0, 0.4])
@pytest.mark.parametrize("name", RULES)
def test_every_pair_of_codes(name, hurry):
    """All 8 x 256 pairs of branch and stream."""
    rule, channels = RULES[name], ARRAY.output_word_channels
    branch, stream = (values.reshape(-1, channels) for values in np.divmod(np.arange(8 * 256), 256))
    codes, sums = run(rule, branch, stream, hurry=hurry, seed=len(name))
    want_sums, want_codes = rule.apply(branch, stream)
    assert (sums == want_sums).all()
    assert (codes == want_codes).all()


def test_disabled_it_passes_codes_and_takes_no_residual():
    branch = np.random.default_rng(5).integers(0, 8, (40, ARRAY.output_word_channels))
    codes, _ = run(RULES["plain"], branch, None, enable=False, hurry=0.3)
    assert (codes == branch).all()


def test_throughput_and_latency():
    """One word per cycle when nothing waits, `LATENCY` cycles after it was taken."""
    dut = ResidualAdder(ARRAY)
    taken, left = [], []

    async def bench(ctx):
        ctx.set(dut.enable, 1)
        for stream in (dut.i, dut.residual):
            ctx.set(stream.valid, 1)
        for stream in (dut.o, dut.sums):
            ctx.set(stream.ready, 1)
        for cycle in range(20):
            *_, ready, valid, sums = await ctx.tick().sample(dut.i.ready, dut.o.valid, dut.sums.valid)
            assert valid == sums
            taken.extend([cycle] if ready else [])
            left.extend([cycle] if valid else [])

    simulate(dut, bench)
    assert taken == list(range(20))
    assert left == list(range(ResidualAdder.LATENCY, 20))
