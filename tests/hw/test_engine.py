"""Row engine: every lane against numpy's own convolution."""

import itertools

import numpy as np
import pytest
from stream_testing import simulate

from macram.spec import GROUP, LANES, TAPS, ArrayConfig, IntFormat
from macram_hw.engine import RowEngine


def config(weight=3, act="u3"):
    return ArrayConfig(
        weight=IntFormat(weight, signed=True), input=IntFormat(int(act[1:]), signed=act[0] == "s")
    )


@pytest.mark.parametrize(
    ("weight", "act"), [(3, "u3"), (3, "s3"), (2, "u8"), (8, "u8"), (8, "s8"), (4, "u2")]
)
def test_lanes_are_a_1d_convolution(weight, act):
    cfg = config(weight, act)
    a, w = cfg.input, cfg.weight
    rng = np.random.default_rng(7)
    corners = itertools.product((a.lo, a.hi), repeat=GROUP), itertools.product((w.lo, 0, w.hi), repeat=TAPS)
    cases = list(itertools.product(*corners))
    cases += [(rng.integers(a.lo, a.hi + 1, GROUP), rng.integers(w.lo, w.hi + 1, TAPS)) for _ in range(400)]
    dut = RowEngine(cfg)

    async def bench(ctx):
        for pixels, taps in cases:
            for i, pixel in enumerate(pixels):
                ctx.set(dut.pixels[i], int(pixel))
            for j, tap in enumerate(taps):
                ctx.set(dut.taps[j], int(tap))
            await ctx.tick().repeat(RowEngine.LATENCY)
            lanes = [ctx.get(dut.lanes[k]) for k in range(LANES)]
            assert lanes == np.convolve(pixels, taps).tolist(), (pixels, taps)

    simulate(dut, bench, cycles=2 * len(cases))
