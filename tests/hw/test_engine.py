"""Row engine: every lane against numpy's own convolution."""

import itertools

import numpy as np
import pytest
from stream_testing import simulate

from macram.spec import ENGINE_LATENCY, GROUP, LANES, TAPS, ArrayConfig, IntFormat
from macram_hw.engine import make_engine

CASES = [(3, "u3"), (3, "s3"), (2, "u8"), (8, "u8"), (8, "s8"), (4, "u2")]
PACKED_CASES = [(3, "u3"), (2, "u3"), (3, "u2")]


@pytest.mark.parametrize(
    ("kind", "weight", "act"),
    [("portable", *case) for case in CASES]
    + [(kind, *case) for kind in ("dsp48e2", "soft") for case in PACKED_CASES],
)
def test_lanes_are_a_1d_convolution(kind, weight, act):
    cfg = ArrayConfig(
        weight=IntFormat(weight, signed=True),
        input=IntFormat(int(act[1:]), signed=act[0] == "s"),
        engine=kind,
    )
    a, w = cfg.input, cfg.weight
    rng = np.random.default_rng(7)
    corners = itertools.product((a.lo, a.hi), repeat=GROUP), itertools.product((w.lo, 0, w.hi), repeat=TAPS)
    cases = list(itertools.product(*corners))
    cases += [(rng.integers(a.lo, a.hi + 1, GROUP), rng.integers(w.lo, w.hi + 1, TAPS)) for _ in range(400)]
    dut = make_engine(kind, cfg)
    latency = ENGINE_LATENCY[kind]

    async def bench(ctx):
        for cycle in range(len(cases) + latency):
            if cycle >= latency:
                pixels, taps = cases[cycle - latency]
                operands = [dut.operand(k) for k in range(LANES)]
                assert all(operand.lo <= ctx.get(operand.value) <= operand.hi for operand in operands)
                lanes = [ctx.get(operands[k].value) + ctx.get(dut.carries[k]) for k in range(LANES)]
                assert lanes == np.convolve(pixels, taps).tolist(), (pixels, taps)
            pixels, taps = cases[min(cycle, len(cases) - 1)]
            for i, pixel in enumerate(pixels):
                ctx.set(dut.pixels[i], int(pixel))
            for j, tap in enumerate(taps):
                ctx.set(dut.taps[j], int(tap))
            await ctx.tick()

    simulate(dut, bench, cycles=2 * len(cases))


@pytest.mark.parametrize(("weight", "act"), [(4, "u3"), (3, "u4"), (3, "s3")])
@pytest.mark.parametrize(
    ("kind", "soft_rows", "named"), [("dsp48e2", 0, "dsp48e2"), ("soft", 0, "soft"), ("portable", 1, "soft")]
)
def test_the_other_kinds_refuse_other_formats(weight, act, kind, soft_rows, named):
    with pytest.raises(ValueError, match=f"engine {named} takes weights and unsigned inputs of up to 3 bits"):
        ArrayConfig(
            weight=IntFormat(weight, signed=True),
            input=IntFormat(int(act[1:]), signed=act[0] == "s"),
            engine=kind,
            soft_rows=soft_rows,
        )
