"""The whole array in Amaranth's simulator: loads, images, faults and a reset, with gaps and stalls."""

import os
import random

import numpy as np
import pytest
from amaranth.hdl import ResetInserter, Signal
from stream_testing import get, put, simulate

from macram.golden import random_case, run_layer
from macram.pack import pack_layer
from macram.perf import estimate
from macram.spec import ArrayConfig, Control, ConvSpec, Error, IntFormat, StreamLayout
from macram.spec.registers import MODE_3X3, mode_word
from macram_hw.array import COUNTERS, Array

SEED = int(os.environ.get("SEED") or 2022)
SMALL = {
    "units": 4,
    "rows": 2,
    "drain": 1,
    "max_c_in": 6,
    "max_c_out": 8,
    "weight_depth": 18,
    "row_words": 8,
    "stream_bits": 32,
}
DEEP = SMALL | {"rows": 1, "max_c_in": 14, "max_c_out": 16, "weight_depth": 42, "row_words": 28}
ARRAYS = {
    "triples": ArrayConfig(**DEEP),
    "portable": ArrayConfig(**SMALL),
    "dsp48e2": ArrayConfig(**SMALL, engine="dsp48e2"),
    "wide": ArrayConfig(**{**SMALL, "row_words": 16}),
    "8-bit": ArrayConfig(
        **SMALL, weight=IntFormat(5, signed=True), input=IntFormat(4, signed=True), output=IntFormat(5)
    ),
}


class Bench:
    """An array with its streams, commanded without registers."""

    def __init__(self, array, layer, gap, stall):
        self.array, self.layer, self.gap, self.stall = array, layer, gap, stall
        self.rng = random.Random(SEED)
        self.reset = Signal()
        self.core = Array(array)
        self.dut = ResetInserter(self.reset)(self.core)
        spec = layer.spec
        self.packed = pack_layer(layer, array)
        self.beats_in = values(StreamLayout(spec.c_in, spec.input, array.stream_bits).pack(layer.input))
        self.output = StreamLayout(spec.c_out, array.output, array.stream_bits)
        self.beats_out = spec.out_height * spec.out_width * self.output.beats_per_pixel

    async def command(self, ctx, command, **registers):
        spec = self.layer.spec
        shape = {"height": spec.height, "width": spec.width, "c_in": spec.c_in, "c_out": spec.c_out}
        mode = mode_word(spec.kernel, spec.stride, spec.padding, biased=self.array.biased(spec))
        for name, value in {**shape, "mode": mode, **registers}.items():
            ctx.set(getattr(self.core, name), value)
        ctx.set(self.core.command, command)
        await ctx.tick()
        ctx.set(self.core.command, 0)
        await ctx.tick().repeat(4)

    async def load(self, ctx):
        weights, requant = self.packed.load_beats()
        for command, words, beats in (
            (Control.LOAD_WEIGHTS, self.packed.weight_words, weights),
            (Control.LOAD_REQUANT, self.packed.requant_words, requant),
        ):
            await self.command(ctx, command, words=words)
            assert ctx.get(self.core.loading)
            await put(ctx, self.core.params, with_last(values(beats)), gap=self.gap, rng=self.rng)
            await ctx.tick().repeat(2)
            assert not ctx.get(self.core.loading)
            assert ctx.get(self.core.error) == Error.NONE

    async def take(self, ctx):
        beats = await get(ctx, self.core.o, self.beats_out, stall=self.stall, rng=self.rng)
        assert [bool(beat.last) for beat in beats] == [False] * (self.beats_out - 1) + [True]
        raw = np.array([list(beat.data.to_bytes(4, "little")) for beat in beats], np.uint8)
        spec = self.layer.spec
        np.testing.assert_array_equal(
            self.output.unpack(raw, spec.out_height, spec.out_width), run_layer(self.layer)
        )
        await ctx.tick()
        if (spec.kernel, spec.stride) == (1, 2):
            # It is through before the last input row, which it does not need, is.
            while not ctx.get(self.core.done):
                await ctx.tick()
        assert (ctx.get(self.core.busy), ctx.get(self.core.done)) == (0, 1)
        assert not ctx.get(self.core.i.ready)
        counters = {name: ctx.get(getattr(self.core, name)) for name in COUNTERS}
        assert counters["cycles"] == sum(counters.values()) - counters["cycles"]
        closed = estimate(spec, self.array)
        assert counters["mac_cycles"] == closed.mac
        if not self.gap and not self.stall and closed.exact:
            assert counters["fill_cycles"] == closed.fill
            assert counters["drain_cycles"] == closed.drain
            assert counters["cycles"] == closed.total


def values(beats):
    return [int.from_bytes(row.tobytes(), "little") for row in beats]


def with_last(beats):
    return [{"data": beat, "last": index == len(beats) - 1} for index, beat in enumerate(beats)]


@pytest.mark.parametrize(
    ("name", "shape", "gap", "stall"),
    [
        ("portable", (5, 7, 3, 5), 0.0, 0.0),
        ("portable", (2, 8, 2, 8), 0.0, 0.6),
        ("dsp48e2", (3, 5, 5, 4), 0.5, 0.3),
        ("8-bit", (4, 8, 3, 6), 0.3, 0.3),
    ],
)
def test_two_images_after_a_load(name, shape, gap, stall):
    run_two_images(ARRAYS[name], shape, gap, stall)


@pytest.mark.parametrize("gap", [0.0, 0.8])
@pytest.mark.parametrize(
    ("kernel", "stride", "height", "width"),
    [(1, 1, 3, 7), (1, 2, 5, 7), (1, 2, 6, 7), (3, 2, 5, 7), (3, 2, 6, 6)],
)
def test_other_kernels_and_strides(kernel, stride, height, width, gap):
    """Few output channels and a slow source: a row that is read before it is there gives wrong codes.

    Of two pixels that stride 2 takes together the second is missing at the end of an odd width alone.
    """
    run_two_images(ARRAYS["wide"], (2, 2, height, width, kernel, stride, kernel // 2), gap, 0.0)


def run_two_images(array, shape, gap, stall, kind="uniform"):
    form = {key: getattr(array, key) for key in ("weight", "input", "output")}
    run_images(Bench(array, random_case(ConvSpec(*shape, **form), SEED, kind), gap, stall))


def run_images(bench, images=2):
    async def source(ctx):
        await bench.load(ctx)
        for image in range(images):
            while ctx.get(bench.core.busy):
                await ctx.tick()
            await ctx.tick().repeat(3)
            await bench.command(ctx, Control.START)
            # Cycles count from the first beat, whenever it comes.
            await ctx.tick().repeat(1 + 7 * image)
            await put(ctx, bench.core.i, with_last(bench.beats_in), gap=bench.gap, rng=bench.rng)

    async def sink(ctx):
        for _ in range(images):
            await bench.take(ctx)

    simulate(bench.dut, source, sink)


@pytest.mark.parametrize(
    ("shape", "stride", "signed", "gap", "stall"),
    [
        ((14, 12, 2, 6), 1, False, 0.0, 0.0),
        ((13, 15, 3, 8), 1, True, 0.0, 0.0),
        ((14, 11, 4, 7), 2, True, 0.3, 0.4),
    ],
)
def test_three_tiles_of_a_1x1_kernel_together(shape, stride, signed, gap, stall):
    array = ARRAYS["triples"]
    spec = ConvSpec(*shape, 1, stride, 0, input=IntFormat(3, signed=signed))
    assert array.triples(spec) == 1
    run_images(Bench(array, random_case(spec, SEED, "extremes"), gap, stall))


def test_faults_and_a_reset():
    array = ARRAYS["portable"]
    bench = Bench(array, random_case(ConvSpec(3, 5, 3, 4), SEED), 0.0, 0.0)
    core = bench.core

    async def source(ctx):
        await bench.load(ctx)
        for registers, command, code in (
            ({"width": 0}, Control.START, Error.BAD_SHAPE),
            ({"mode": MODE_3X3 + 1}, Control.START, Error.BAD_MODE),
            ({"words": 0}, Control.LOAD_WEIGHTS, Error.BAD_RANGE),
            ({"words": array.weight_depth + 1}, Control.LOAD_WEIGHTS, Error.BAD_RANGE),
            ({"words": array.requant_depth + 1}, Control.LOAD_REQUANT, Error.BAD_RANGE),
            ({"words": 1}, Control.LOAD_REQUANT | Control.START, Error.BAD_COMMAND),
        ):
            await bench.command(ctx, command, **registers)
            assert (ctx.get(core.busy), ctx.get(core.done), ctx.get(core.error)) == (0, 0, code)
        for beats, code in (
            (with_last(bench.beats_in[:3]), Error.TLAST_EARLY),
            ([{"data": beat, "last": 0} for beat in bench.beats_in], Error.TLAST_MISSING),
        ):
            await bench.command(ctx, Control.START)
            await put(ctx, core.i, beats)
            await ctx.tick().repeat(2)
            assert ctx.get(core.error) == code
            # A command that is refused leaves the first error, and the run.
            await bench.command(ctx, Control.START)
            assert (ctx.get(core.busy), ctx.get(core.error)) == (1, code)
            ctx.set(bench.reset, 1)
            await ctx.tick()
            ctx.set(bench.reset, 0)
            await ctx.tick()
            assert (ctx.get(core.busy), ctx.get(core.error)) == (0, Error.NONE)
        await bench.command(ctx, Control.START)
        ctx.set(reached, 1)
        await put(ctx, core.i, with_last(bench.beats_in))

    reached = Signal()

    async def sink(ctx):
        while not ctx.get(reached):
            await ctx.tick()
        await bench.take(ctx)

    simulate(bench.dut, source, sink)


@pytest.mark.parametrize(
    ("command", "base", "words", "allowed"),
    [
        (Control.LOAD_WEIGHTS, 0, 6, True),
        (Control.LOAD_WEIGHTS, 0, 7, False),
        (Control.LOAD_WEIGHTS, 11, 1, False),
        (Control.LOAD_WEIGHTS, 12, 6, True),
        (Control.LOAD_REQUANT, 1, 1, True),
        (Control.LOAD_REQUANT, 1, 2, False),
        (Control.LOAD_REQUANT, 5, 3, False),
        (Control.LOAD_REQUANT, 6, 2, True),
    ],
)
def test_a_load_beside_an_image_may_touch_but_not_overlap_its_words(command, base, words, allowed):
    """The layer has the weight words 6 to 11 and the requantiser words 2 to 5."""
    bench = Bench(ARRAYS["portable"], random_case(ConvSpec(3, 4, 3, 4), SEED), 0.0, 0.0)
    core = bench.core

    async def source(ctx):
        await bench.command(ctx, Control.START, weight_base=6, requant_base=2)
        assert (ctx.get(core.busy), ctx.get(core.error)) == (1, Error.NONE)
        await bench.command(ctx, command, weight_base=6, requant_base=2, param_base=base, words=words)
        wanted = (1, Error.NONE) if allowed else (0, Error.BAD_RANGE)
        assert (ctx.get(core.loading), ctx.get(core.error)) == wanted
        assert ctx.get(core.busy)

    simulate(bench.dut, source)
