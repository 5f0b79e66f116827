"""Gearboxes: contents against the stream layout, throughput against the closed form."""

import random

import numpy as np
import pytest
from stream_testing import get, put, simulate

from macram.perf import pixel_in_cycles, pixel_out_cycles
from macram.spec import ArrayConfig, ConvSpec, IntFormat, StreamLayout, ceil_div
from macram_hw.gearbox import EmitGearbox, IngestGearbox

SHAPES = [
    (1, 3, 64),
    (64, 3, 64),
    (17, 3, 64),
    (37, 3, 64),
    (128, 3, 64),
    (5, 8, 64),
    (9, 8, 32),
    (16, 5, 128),
]


def beat_values(layout, codes):
    return [int.from_bytes(beat.tobytes(), "little") for beat in layout.pack(codes)]


@pytest.mark.parametrize(("gap", "stall"), [(0, 0), (0.4, 0), (0, 0.5), (0.3, 0.3)])
@pytest.mark.parametrize(("channels", "bits", "beat_bits"), SHAPES)
def test_ingest_words_hold_the_channels_in_order(channels, bits, beat_bits, gap, stall):
    word_channels, pixels = 16, 9
    format = IntFormat(bits)
    layout = StreamLayout(channels, format, beat_bits)
    codes = np.random.default_rng(channels).integers(0, format.hi + 1, (channels, 1, pixels))
    words = ceil_div(channels, word_channels)
    dut = IngestGearbox(beat_bits=beat_bits, word_bits=word_channels * bits)
    seen = []

    async def source(ctx):
        ctx.set(dut.beats_per_pixel, layout.beats_per_pixel)
        ctx.set(dut.words_per_pixel, words)
        await put(ctx, dut.i, beat_values(layout, codes), gap=gap, rng=random.Random(3))

    async def sink(ctx):
        seen.extend(await get(ctx, dut.o, pixels * words, stall=stall, rng=random.Random(4)))

    simulate(dut, source, sink)
    padded = np.zeros((words * word_channels, pixels), int)
    padded[:channels] = codes[:, 0]
    expected = [
        sum(int(code) << (bits * i) for i, code in enumerate(padded[w * word_channels :][:word_channels, p]))
        for p in range(pixels)
        for w in range(words)
    ]
    # Words past the last channel hold whatever the beat's padding gives: zero.
    assert seen == expected


@pytest.mark.parametrize(("gap", "stall"), [(0, 0), (0.4, 0), (0, 0.5), (0.3, 0.3)])
@pytest.mark.parametrize(("channels", "bits", "beat_bits"), SHAPES)
def test_emitted_beats_are_the_stream_layout(channels, bits, beat_bits, gap, stall):
    word_channels, pixels = 16, 9
    format = IntFormat(bits)
    layout = StreamLayout(channels, format, beat_bits)
    codes = np.random.default_rng(channels).integers(0, format.hi + 1, (channels, 1, pixels))
    words = ceil_div(channels, word_channels)
    dut = EmitGearbox(word_bits=word_channels * bits, beat_bits=beat_bits)
    payloads = [
        {
            "data": sum(
                int(code) << (bits * i)
                for i, code in enumerate(codes[w * word_channels : (w + 1) * word_channels, 0, p])
            ),
            "pixel_last": w == words - 1,
            "last": p == pixels - 1,
        }
        for p in range(pixels)
        for w in range(words)
    ]
    seen = []

    async def source(ctx):
        ctx.set(dut.beats_per_pixel, layout.beats_per_pixel)
        await put(ctx, dut.i, payloads, gap=gap, rng=random.Random(3))

    async def sink(ctx):
        seen.extend(await get(ctx, dut.o, pixels * layout.beats_per_pixel, stall=stall, rng=random.Random(4)))

    simulate(dut, source, sink)
    assert [beat.data for beat in seen] == beat_values(layout, codes)
    assert [bool(beat.last) for beat in seen] == [False] * (len(seen) - 1) + [True]


@pytest.mark.parametrize("channels", [1, 8, 17, 33, 64, 112, 128])
@pytest.mark.parametrize(("bits", "beat_bits"), [(3, 64), (8, 64), (8, 128), (5, 32)])
def test_throughput_is_the_closed_form(channels, bits, beat_bits):
    """The cycle of the last transfer grows by the same number with every further pixel."""
    format = IntFormat(bits)
    array = ArrayConfig(input=format, output=format, stream_bits=beat_bits)
    layer = ConvSpec(channels, channels, 4, 4, input=format, output=format)
    layout = StreamLayout(channels, format, beat_bits)
    beats = layout.beats_per_pixel
    ingest_words = ceil_div(array.blocks(channels), array.ingest)
    output_words = ceil_div(channels, array.output_word_channels)

    def last_transfer(dut, settings, payloads, results):
        cycles = []

        async def source(ctx):
            for name, value in settings.items():
                ctx.set(getattr(dut, name), value)
            await put(ctx, dut.i, payloads)

        async def sink(ctx):
            ctx.set(dut.o.ready, 1)
            cycle = 0
            while len(cycles) < results:
                *_, valid = await ctx.tick().sample(dut.o.valid)
                cycle += 1
                cycles.extend([cycle] * valid)

        simulate(dut, source, sink)
        return cycles[-1]

    def ingest(pixels):
        dut = IngestGearbox(beat_bits=beat_bits, word_bits=array.ingest * array.block_bits)
        settings = {"beats_per_pixel": beats, "words_per_pixel": ingest_words}
        return last_transfer(dut, settings, range(pixels * beats), pixels * ingest_words)

    def emit(pixels):
        dut = EmitGearbox(word_bits=array.output_word_channels * bits, beat_bits=beat_bits)
        words = [
            {"data": 0, "pixel_last": k == output_words - 1, "last": 0}
            for _ in range(pixels)
            for k in range(output_words)
        ]
        return last_transfer(dut, {"beats_per_pixel": beats}, words, pixels * beats)

    assert ingest(6) - ingest(3) == 3 * pixel_in_cycles(layer, array)
    assert emit(6) - emit(3) == 3 * pixel_out_cycles(layer, array)
