"""Requantiser: both kinds against the golden model, on packed parameter words."""

import numpy as np
import pytest
from stream_testing import simulate

from macram.golden import derive_requant, random_case
from macram.pack import pack_layer
from macram.spec import GROUP, ArrayConfig, ConvSpec, IntFormat
from macram_hw.requant import Requantiser


@pytest.mark.parametrize("output", ["u2", "u3", "s3", "u4", "s4", "u5", "s6", "u8", "s8"])
def test_codes_equal_the_golden_model(output):
    form = IntFormat(int(output[1:]), signed=output[0] == "s")
    array = ArrayConfig(units=16, rows=2, drain=4, max_c_in=16, max_c_out=32, weight_depth=64, output=form)
    spec = ConvSpec(9, 29, 5, 5, output=form)
    case = random_case(spec, seed=11)
    golden = derive_requant(spec, case.scale, case.offset)
    words = pack_layer(case, array).requant_ints()
    rng = np.random.default_rng(3)
    lo, hi = -4 * 7 * spec.fan_in, 3 * 7 * spec.fan_in
    dut = Requantiser(array)
    checked = 0

    async def bench(ctx):
        nonlocal checked
        for _ in range(25):
            for at, word in enumerate(words):
                channels = at * array.drain + np.arange(array.drain)
                acc = rng.integers(lo, hi + 1, (array.drain, GROUP))
                if golden_thresholds is not None:
                    # Half of the accumulators sit on a threshold or one below it.
                    for q, c in enumerate(channels):
                        if c < spec.c_out:
                            at_edge = rng.choice(golden_thresholds[c], 2) - rng.integers(0, 2, 2)
                            acc[q, :2] = np.clip(at_edge, lo, hi)
                ctx.set(dut.parameters, word)
                for q in range(array.drain):
                    for slot in range(GROUP):
                        ctx.set(dut.accumulators[q][slot], int(acc[q, slot]))
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
    assert checked == 25 * spec.c_out * GROUP
