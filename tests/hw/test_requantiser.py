"""Requantiser: both kinds against the golden model, on packed parameter words."""

import numpy as np
import pytest
from stream_testing import simulate

from macram.golden import derive_requant, random_case
from macram.pack import pack_layer
from macram.pack.signed import Rise
from macram.spec import GROUP, ArrayConfig, ConvSpec, IntFormat, accumulator_range
from macram_hw.requant import Requantiser


@pytest.mark.parametrize("signed", [False, True])
@pytest.mark.parametrize("output", ["u2", "u3", "s3", "u4", "s4", "u5", "s6", "u8", "s8"])
def test_codes_equal_the_golden_model(output, signed):
    """With signed input codes the accumulators come raised, in the first group of a row but for the border terms."""
    form = IntFormat(int(output[1:]), signed=output[0] == "s")
    array = ArrayConfig(units=16, rows=2, drain=4, max_c_in=16, max_c_out=32, weight_depth=64, output=form)
    spec = ConvSpec(9, 29, 5, 8, output=form, input=IntFormat(3, signed=signed))
    case = random_case(spec, seed=11)
    golden = derive_requant(spec, case.scale, case.offset)
    words = pack_layer(case, array).requant_ints()
    rise = Rise.of(case.weights, spec, array)
    assert rise.left.any() == rise.right.any() == signed
    rng = np.random.default_rng(3)
    lo, hi = accumulator_range(spec.weight, spec.input, spec.fan_in)
    # What one channel's weights can reach, so that raised sums stay in the accumulator's range.
    own = case.weights.reshape(spec.c_out, -1)
    above, below = own.clip(min=0).sum(axis=1), own.clip(max=0).sum(axis=1)
    inputs = spec.input
    lows, highs = above * inputs.lo + below * inputs.hi, above * inputs.hi + below * inputs.lo
    dut = Requantiser(array)
    checked = 0

    async def bench(ctx):
        nonlocal checked
        for _ in range(10):
            for at, word in enumerate(words):
                channels = at * array.drain + np.arange(array.drain)
                acc = rng.integers(lo, hi + 1, (array.drain, GROUP))
                if golden_thresholds is not None:
                    # Half of the accumulators sit on a threshold or one below it.
                    for q, c in enumerate(channels):
                        if c < spec.c_out:
                            at_edge = rng.choice(golden_thresholds[c], 2) - rng.integers(0, 2, 2)
                            acc[q, :2] = at_edge
                edge = bool(rng.integers(2))
                ctx.set(dut.edge, edge)
                for q, c in enumerate(channels):
                    if c < spec.c_out:
                        acc[q] = acc[q].clip(lows[c], highs[c])
                ctx.set(dut.parameters, word)
                for q, c in enumerate(channels):
                    terms = [0] * GROUP
                    if c < spec.c_out:
                        missing = (rise.right[c], rise.left[c], 0, 0) if edge else (0, 0, 0, 0)
                        terms = [rise.total[c] - part for part in missing]
                    for slot in range(GROUP):
                        ctx.set(dut.accumulators[q][slot], int(acc[q, slot] + terms[slot]))
                await ctx.tick().repeat(Requantiser.LATENCY)
                codes = ctx.get(dut.codes)
                for q, c in enumerate(channels):
                    if c >= spec.c_out:
                        continue
                    everywhere = np.zeros((spec.c_out, 1, GROUP), np.int64)
                    everywhere[c, 0] = acc[q]
                    want = golden.apply(everywhere)[c, 0]
                    for slot in range(GROUP):
                        field = codes >> (form.bits * (slot * array.drain + q)) & ((1 << form.bits) - 1)
                        assert form.from_field(np.array([field], np.uint64))[0] == want[slot], (
                            c,
                            acc[q, slot],
                        )
                        checked += 1

    golden_thresholds = getattr(golden, "thresholds", None)
    simulate(dut, bench)
    assert checked == 10 * spec.c_out * GROUP
