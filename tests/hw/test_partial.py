"""Partial sums in Amaranth's simulator: the streams of words, and layers in blocks through the whole array."""

import os
import random
from dataclasses import replace

import numpy as np
import pytest
from amaranth.hdl import ResetInserter, Signal
from stream_testing import get, put, simulate

from macram.golden import conv2d, random_case, run_layer
from macram.pack import pack_passes
from macram.perf import estimate_passes
from macram.spec import GROUP, ArrayConfig, Control, ConvSpec, Error, IntFormat, StreamLayout, SumLayout
from macram.spec.registers import mode_word
from macram_hw.array import COUNTERS, Array
from macram_hw.partial import SumGiver, SumTaker

SEED = int(os.environ.get("SEED") or 2022)
ARRAY = ArrayConfig(
    units=4, rows=2, drain=1, max_c_in=4, max_c_out=8, weight_depth=18, row_words=8, stream_bits=32,
    partial_sum_c_in=24,
)  # fmt: skip
# One beat per word; many beats that a word does not fill; the widest sums.
ARRAYS = {
    "small": ARRAY,
    "one beat": replace(ARRAY, stream_bits=64),
    "wide": replace(
        ARRAY, units=8, drain=2, weight=IntFormat(8, signed=True), input=IntFormat(8), output=IntFormat(8),
        partial_sum_c_in=1 << 16, stream_bits=128,
    ),
}  # fmt: skip


def random_words(array, count, rng):
    """Sums ``[words][channel][slot]``, with both ends of the range among them."""
    lo, hi = array.sum.lo, array.sum.hi
    words = [[[rng.randint(lo, hi) for _ in range(GROUP)] for _ in range(array.drain)] for _ in range(count)]
    words[0] = [[lo] * GROUP] * array.drain
    words[-1] = [[hi] * GROUP] * array.drain
    return words


def beats_of(array, words):
    """By the definition: signed fields of whole bytes side by side, each word padded to whole beats."""
    field, beat = array.sum_field_bits, array.stream_bits
    beats = []
    for word in words:
        values = [value for channel in word for value in channel]
        whole = sum((value & ((1 << field) - 1)) << (field * at) for at, value in enumerate(values))
        beats += [whole >> (beat * at) & ((1 << beat) - 1) for at in range(array.sum_word_beats)]
    return beats


@pytest.mark.parametrize(("gap", "stall"), [(0.0, 0.0), (0.5, 0.3), (0.0, 0.7)])
@pytest.mark.parametrize("name", ARRAYS)
def test_words_come_in(name, gap, stall):
    """Two images; between them nothing is taken, and what is left in the register adds nothing."""
    array, rng = ARRAYS[name], random.Random(SEED)
    dut, words = SumTaker(array), random_words(array, 5, rng)
    beats = [{"data": beat, "last": 0} for beat in beats_of(array, words)]
    beats[-1]["last"] = 1

    async def source(ctx):
        for _ in range(2):
            await put(ctx, dut.i, beats, gap=gap, rng=rng)

    async def sink(ctx):
        for enable in (1, 0, 1):
            ctx.set(dut.enable, enable)
            ctx.set(dut.start, 1)
            await ctx.tick()
            ctx.set(dut.start, 0)
            if not enable:
                for _ in range(5):
                    await ctx.tick()
                    assert not ctx.get(dut.i.ready)
                    assert not ctx.get(dut.o.valid)
                    assert not any(ctx.get(value) for channel in dut.o.payload for value in channel)
                continue
            for index, word in enumerate(words):
                ctx.set(dut.last, index == len(words) - 1)
                (got,) = await get(ctx, dut.o, 1, stall=stall, rng=rng)
                assert [list(channel) for channel in got] == word
            for _ in range(3):
                await ctx.tick()
                assert not ctx.get(dut.i.ready)

    async def no_fault(ctx):
        async for *_, fault in ctx.tick().sample(dut.fault):
            assert not fault

    simulate(dut, source, sink, background=[no_fault])


@pytest.mark.parametrize(
    ("lasts", "error"),
    [
        (set(), Error.TLAST_MISSING),
        ({0, 3 * ARRAY.sum_word_beats - 1}, Error.TLAST_EARLY),
        ({ARRAY.sum_word_beats - 1, 3 * ARRAY.sum_word_beats - 1}, Error.TLAST_EARLY),
    ],
)
def test_a_wrong_tlast_is_a_fault(lasts, error):
    dut, words = SumTaker(ARRAY), random_words(ARRAY, 3, random.Random(SEED))
    seen = []

    async def source(ctx):
        beats = [{"data": beat, "last": index in lasts} for index, beat in enumerate(beats_of(ARRAY, words))]
        ctx.set(dut.enable, 1)
        ctx.set(dut.start, 1)
        await ctx.tick()
        ctx.set(dut.start, 0)
        await put(ctx, dut.i, beats)

    async def sink(ctx):
        for index in range(len(words)):
            ctx.set(dut.last, index == len(words) - 1)
            await get(ctx, dut.o, 1)

    async def faults(ctx):
        async for *_, fault, code in ctx.tick().sample(dut.fault, dut.error):
            seen.extend([Error(code)] if fault else [])

    simulate(dut, source, sink, background=[faults])
    assert seen == [error]


@pytest.mark.parametrize(("gap", "stall"), [(0.0, 0.0), (0.5, 0.3), (0.0, 0.7)])
@pytest.mark.parametrize("name", ARRAYS)
def test_words_go_out(name, gap, stall):
    array, rng = ARRAYS[name], random.Random(SEED)
    dut, words = SumGiver(array), random_words(array, 6, rng)
    payloads = [{"sums": word, "last": index == 5} for index, word in enumerate(words)]
    got = []

    async def source(ctx):
        await put(ctx, dut.i, payloads, gap=gap, rng=rng)

    async def sink(ctx):
        got.extend(await get(ctx, dut.o, len(words) * array.sum_word_beats, stall=stall, rng=rng))

    simulate(dut, source, sink)
    assert [beat.data for beat in got] == beats_of(array, words)
    assert [beat.last for beat in got] == [0] * (len(got) - 1) + [1]


class Bench:
    """An array that runs a layer in blocks, commanded without registers."""

    def __init__(self, case, array, gap, stall):
        self.case, self.array, self.gap, self.stall = case, array, gap, stall
        self.passes = pack_passes(case, array)
        self.rng = random.Random(SEED)
        self.reset = Signal()
        self.core = Array(array)
        self.dut = ResetInserter(self.reset)(self.core)
        self.jobs: list = []

    async def command(self, ctx, packed, command, **registers):
        spec = packed.spec
        mode = mode_word(
            spec.kernel, spec.stride, spec.padding, biased=self.array.biased(spec), sums_in=packed.sums_in,
            sums_out=packed.sums_out,
        )  # fmt: skip
        shape = {
            "height": spec.height,
            "width": spec.width,
            "c_in": spec.c_in,
            "c_out": spec.c_out,
            "mode": mode,
        }
        for name, value in {**shape, **registers}.items():
            ctx.set(getattr(self.core, name), value)
        ctx.set(self.core.command, command)
        await ctx.tick()
        ctx.set(self.core.command, 0)
        await ctx.tick().repeat(4)

    async def load(self, ctx, packed):
        for command, words, beats in zip(
            (Control.LOAD_WEIGHTS, Control.LOAD_REQUANT), (packed.weight_words, packed.requant_words),
            packed.load_beats(), strict=True,
        ):  # fmt: skip
            await self.command(ctx, packed, command, words=words)
            await put(ctx, self.core.params, with_last(beats))
            await ctx.tick().repeat(2)

    def run(self):
        """All passes; the partial sums of each pass, and the counters."""
        self.codes, self.sums, self.counters = [], [], []
        layer, array = self.case.spec, self.array
        image, params = [], []

        async def source(ctx):
            await self._send(ctx, self.core.i, image)

        async def addends(ctx):
            await self._send(ctx, self.core.params, params)

        async def control(ctx):
            first = 0
            for packed in self.passes:
                spec = packed.spec
                await self.load(ctx, packed)
                codes = self.case.input[first : first + spec.c_in]
                first = (first + spec.c_in) % layer.c_in
                image.append(StreamLayout(spec.c_in, spec.input, array.stream_bits).pack(codes))
                layout = SumLayout(spec, array)
                if packed.sums_in:
                    params.append(layout.pack(self.sums[-1]))
                await self.command(ctx, packed, Control.START)
                output = StreamLayout(spec.c_out, spec.output, array.stream_bits)
                size = spec.out_height, spec.out_width
                count = layout.beats if packed.sums_out else size[0] * size[1] * output.beats_per_pixel
                got = await get(ctx, self.core.o, count, stall=self.stall, rng=self.rng)
                assert [bool(beat.last) for beat in got] == [False] * (count - 1) + [True]
                raw = np.array(
                    [list(b.data.to_bytes(array.stream_bits // 8, "little")) for b in got], np.uint8
                )
                if packed.sums_out:
                    self.sums.append(layout.unpack(raw))
                else:
                    self.codes.append(output.unpack(raw, *size))
                await ctx.tick().repeat(3)
                assert (ctx.get(self.core.busy), ctx.get(self.core.done)) == (0, 1)
                assert ctx.get(self.core.error) == Error.NONE
                assert not ctx.get(self.core.params.ready)
                self.counters.append({name: ctx.get(getattr(self.core, name)) for name in COUNTERS})

        simulate(self.dut, control, background=[source, addends], cycles=60_000)

    async def _send(self, ctx, stream, queue):
        while True:
            while not queue:
                await ctx.tick()
            await put(ctx, stream, with_last(queue.pop()), gap=self.gap, rng=self.rng)


def with_last(beats):
    data = [int.from_bytes(row.tobytes(), "little") for row in beats]
    return [{"data": beat, "last": index == len(data) - 1} for index, beat in enumerate(data)]


@pytest.mark.parametrize(
    ("spec", "kind", "gap", "stall"),
    [
        (ConvSpec(11, 6, 3, 6), "uniform", 0.0, 0.0),
        (ConvSpec(9, 5, 2, 4), "extremes", 0.4, 0.4),
        (ConvSpec(24, 4, 3, 4), "min", 0.0, 0.5),
        (ConvSpec(7, 9, 4, 5, stride=2), "uniform", 0.5, 0.0),
        (ConvSpec(5, 4, 3, 3, 1, 1, 0), "max", 0.0, 0.0),
        (ConvSpec(10, 4, 3, 8, input=IntFormat(3, signed=True)), "extremes", 0.0, 0.3),
    ],
)
def test_a_layer_in_blocks(spec, kind, gap, stall):
    case = random_case(spec, SEED, kind)
    bench = Bench(case, ARRAY, gap, stall)
    assert any(packed.sums_in and packed.sums_out for packed in bench.passes) or spec.c_in < 8
    bench.run()
    np.testing.assert_array_equal(np.concatenate(bench.codes), run_layer(case))
    for counters in bench.counters:
        assert counters["cycles"] == sum(counters.values()) - counters["cycles"]
    for closed, counters in zip(estimate_passes(spec, ARRAY), bench.counters, strict=True):
        assert counters["mac_cycles"] == closed.mac
        if not gap and not stall and closed.exact:
            assert counters["fill_cycles"] == closed.fill
            assert counters["drain_cycles"] == closed.drain
            assert counters["cycles"] == closed.total


@pytest.mark.parametrize(
    ("sums_in", "first", "second", "error", "state"),
    [
        (False, Control.START, Control.LOAD_WEIGHTS, Error.NONE, (1, 1)),
        (True, Control.START, Control.LOAD_WEIGHTS, Error.BAD_COMMAND, (1, 0)),
        (False, Control.LOAD_WEIGHTS, Control.START, Error.NONE, (1, 1)),
        (True, Control.LOAD_WEIGHTS, Control.START, Error.BAD_RANGE, (0, 1)),
        (False, Control.LOAD_WEIGHTS, Control.LOAD_REQUANT, Error.BAD_COMMAND, (0, 1)),
    ],
)
def test_the_parameter_stream_serves_one_at_a_time(sums_in, first, second, error, state):
    """A load, or a run that starts from sums; what comes second is refused and the first goes on."""
    bench = Bench(random_case(ConvSpec(5, 4, 3, 4), SEED), ARRAY, 0.0, 0.0)
    packed = next(packed for packed in bench.passes if packed.sums_in == sums_in)
    # A word that the layer does not use.
    word = {"words": 1, "param_base": ARRAY.weight_depth - 1}

    async def control(ctx):
        await bench.command(ctx, packed, first, **word)
        assert ctx.get(bench.core.error) == Error.NONE
        await bench.command(ctx, packed, second, **word)
        assert ctx.get(bench.core.error) == error
        assert (ctx.get(bench.core.busy), ctx.get(bench.core.loading)) == state

    simulate(bench.dut, control)


def test_partial_sums_are_those_of_the_channels_so_far():
    spec = ConvSpec(13, 3, 4, 4)
    case = random_case(spec, SEED, "extremes")
    bench = Bench(case, ARRAY, 0.0, 0.0)
    bench.run()
    channels = 0
    assert len(bench.sums) == len(bench.passes) - 1
    for packed, sums in zip(bench.passes, bench.sums, strict=False):
        channels += packed.spec.c_in
        np.testing.assert_array_equal(sums, conv2d(case.input[:channels], case.weights[:, :channels]))
