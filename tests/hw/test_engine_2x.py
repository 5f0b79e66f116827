"""Paired rows on two clocks: both sums of every lane against numpy, pair counts of every depth of the adders."""

import random

import numpy as np
import pytest
from amaranth.hdl import Module
from stream_testing import simulate

from macram.spec import ENGINE_LATENCY, GROUP, LANES, TAPS, ArrayConfig, IntFormat
from macram_hw.engine_2x import Interleaver, PairedEngine

LATENCY = ENGINE_LATENCY["dsp48e2_2x"]


def operands(rng, rows):
    """Random words between the four that drive every lane of every row to its ends, in any order."""
    extremes = [(7, -4), (7, 3), (0, -4), (0, 3)]
    cases = [
        (np.full((rows, GROUP), pixel), np.full((rows, TAPS), tap))
        for pixel, tap in extremes
        for _ in range(4)
    ]
    cases += [(rng.integers(0, 8, (rows, GROUP)), rng.integers(-4, 4, (rows, TAPS))) for _ in range(48)]
    random.Random(int(rng.integers(1 << 31))).shuffle(cases)
    return cases


@pytest.mark.parametrize("offset", [0, 1])
@pytest.mark.parametrize("rows", [2, 4, 6, 8, 10, 18])
def test_even_and_odd_rows_are_summed_apart(rows, offset):
    """Two cycles settle the halves; ``offset`` more, so that either state of the toggle meets the first word."""
    config = ArrayConfig(engine="dsp48e2_2x", rows=rows)
    cases = operands(np.random.default_rng(rows), rows)
    m = Module()
    m.submodules.interleaver = interleaver = Interleaver(config)
    m.submodules.engine = engine = PairedEngine(config, rows // 2)
    m.d.comb += [engine.pixels.eq(interleaver.pixels), engine.second.eq(interleaver.second)]

    async def bench(ctx):
        await ctx.tick().repeat(2 + offset)
        for cycle in range(len(cases) + LATENCY):
            if cycle >= LATENCY:
                pixels, taps = cases[cycle - LATENCY]
                for member in range(2):
                    want = sum(np.convolve(pixels[r], taps[r]) for r in range(member, rows, 2))
                    lanes = [
                        ctx.get(engine.lanes[member][k]) + ctx.get(engine.carries[member][k])
                        for k in range(LANES)
                    ]
                    assert lanes == want.tolist(), (cycle, member)
            pixels, taps = cases[min(cycle, len(cases) - 1)]
            word = 0
            for position, code in enumerate(pixels.T.reshape(-1)):
                word |= int(code) << (3 * position)
            ctx.set(interleaver.word, word)
            for row in range(rows):
                for j in range(TAPS):
                    ctx.set(engine.taps[row][j], int(taps[row, j]))
            await ctx.tick()

    simulate(m, bench)


@pytest.mark.parametrize(("changes", "left"), [({"rows": 1}, 1), ({"rows": 8, "soft_rows": 1}, 7)])
def test_rows_come_in_pairs(changes, left):
    message = (
        f"engine dsp48e2_2x serves rows in pairs: rows less soft_rows must be an even number, not {left}"
    )
    with pytest.raises(ValueError, match=message):
        ArrayConfig(engine="dsp48e2_2x", **changes)


def test_other_formats_are_refused():
    with pytest.raises(
        ValueError, match="engine dsp48e2_2x takes weights and unsigned inputs of up to 3 bits"
    ):
        ArrayConfig(engine="dsp48e2_2x", weight=IntFormat(4, signed=True))
