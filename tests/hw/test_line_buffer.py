"""Line buffer: contents, zero padding, groups announced, rows that wait for a free slot."""

import random
from itertools import product

import numpy as np
import pytest
from stream_testing import put, simulate

from macram.spec import GROUP, ArrayConfig, ceil_div
from macram_hw.line_buffer import ROWS_HELD, LineBuffer


def config(ingest):
    return ArrayConfig(
        units=8, rows=2, drain=2, max_c_in=16, max_c_out=32, weight_depth=64, row_words=32, ingest=ingest
    )


def ingest_words(codes, cfg):
    """[channels, height, width] -> ingest words in stream order."""
    per_word = cfg.ingest * cfg.rows
    channels, height, width = codes.shape
    words = ceil_div(ceil_div(channels, cfg.rows), cfg.ingest)
    padded = np.zeros((words * per_word, height, width), int)
    padded[:channels] = codes
    pixels = padded.reshape(words, per_word, -1).transpose(2, 0, 1).reshape(-1, per_word)
    return [sum(int(code) << (3 * i) for i, code in enumerate(word)) for word in pixels], words


@pytest.mark.parametrize("ingest", [1, 2, 4])
@pytest.mark.parametrize(
    ("channels", "height", "width", "stride", "biased"),
    [
        (4, 6, 8, 1, False), (3, 5, 5, 1, True), (16, 4, 7, 1, False), (1, 1, 1, 1, False), (5, 9, 3, 1, True),
        (4, 6, 16, 2, False), (3, 5, 9, 2, True), (7, 4, 7, 2, False), (1, 1, 1, 2, True), (16, 9, 3, 2, False),
    ],
)  # fmt: skip
def test_every_word_reads_back_with_padding_blanked(ingest, channels, height, width, stride, biased):
    cfg = config(ingest)
    codes = np.random.default_rng(1).integers(0, 8, (channels, height, width))
    words, per_pixel = ingest_words(codes, cfg)
    groups = ceil_div(ceil_div(width, stride), GROUP)
    dut = LineBuffer(cfg)
    written = []

    async def source(ctx):
        ctx.set(dut.shape.height, height)
        ctx.set(dut.shape.width, width)
        ctx.set(dut.shape.ingest_words, per_pixel)
        ctx.set(dut.shape.column_words, stride * per_pixel)
        ctx.set(dut.shape.groups, groups)
        ctx.set(dut.shape.halved, stride == 2)
        ctx.set(dut.shape.biased, biased)
        ctx.set(dut.start, 1)
        await ctx.tick()
        ctx.set(dut.start, 0)
        await put(ctx, dut.i, words, gap=0.2, rng=random.Random(2))

    async def count_groups(ctx):
        while True:
            *_, pulse = await ctx.tick().sample(dut.group_written)
            written.append(pulse)

    async def reader(ctx):
        for y in range(height):
            while sum(written) < (y + 1) * groups:
                await ctx.tick()
            for g in range(groups):
                # Columns of group g that exist, of the even pixels or of the odd ones.
                for odd in range(stride):
                    real = max(0, min(GROUP, ceil_div(width - odd, stride) - GROUP * g))
                    for block in range(ceil_div(channels, cfg.rows)):
                        for mask in {(1 << real) - 1, 0, (1 << real) - 1 & 0b0101}:
                            ctx.set(dut.read.slot, y % ROWS_HELD)
                            address = (g * stride + odd) * per_pixel + block // ingest
                            ctx.set(dut.read.address, address)
                            ctx.set(dut.read.bank, block % ingest)
                            ctx.set(dut.read.mask, mask)
                            await ctx.tick().repeat(LineBuffer.LATENCY)
                            word = ctx.get(dut.word)
                            for pixel in range(GROUP):
                                for r in range(cfg.rows):
                                    c, x = block * cfg.rows + r, (GROUP * g + pixel) * stride + odd
                                    got = word >> (3 * (pixel * cfg.rows + r)) & 7
                                    want = codes[c, y, x] if mask >> pixel & 1 and c < channels else 0
                                    assert got == want ^ (4 if biased else 0), (c, y, x, mask)
                # Outer or inner two pixels alone, in the outer two places; the other two are 0, not raised.
                for inner, block in product((0, 1), range(ceil_div(channels, cfg.rows))):
                    ctx.set(dut.read.slot, y % ROWS_HELD)
                    ctx.set(dut.read.address, g * stride * per_pixel + block // ingest)
                    ctx.set(dut.read.bank, block % ingest)
                    ctx.set(dut.read.mask, 0b1001)
                    ctx.set(dut.read.apart, 1)
                    ctx.set(dut.read.inner, inner)
                    await ctx.tick().repeat(LineBuffer.LATENCY)
                    word = ctx.get(dut.word)
                    for r, (place, pixel) in product(
                        range(cfg.rows), ((0, inner), (3, 3 - inner), (1, None), (2, None))
                    ):
                        c, x = block * cfg.rows + r, (GROUP * g + (pixel or 0)) * stride
                        got = word >> (3 * (place * cfg.rows + r)) & 7
                        if pixel is None:
                            assert got == 0
                        elif x < width:
                            assert got == (codes[c, y, x] if c < channels else 0) ^ (4 if biased else 0)
                ctx.set(dut.read.apart, 0)
                ctx.set(dut.read.inner, 0)
                ctx.set(dut.retire, 1)
                await ctx.tick()
                ctx.set(dut.retire, 0)
        assert ctx.get(dut.image_written)
        assert not ctx.get(dut.i.ready), "an input beat beyond the image was accepted"

    simulate(dut, source, reader, background=[count_groups])
    assert sum(written) == height * groups


@pytest.mark.parametrize("pointwise", [False, True])
def test_a_group_waits_for_the_one_four_rows_above(pointwise):
    """3x3: row -1 holds a slot too. A retired group makes room for one, a retired row for a row."""
    cfg = config(2)
    dut = LineBuffer(cfg)
    height, width, groups = 6, 8, 2
    words, per_pixel = ingest_words(np.ones((4, height, width), int), cfg)
    words_per_group = len(words) // (height * groups)

    async def takes(ctx, count):
        for _ in range(count):
            assert ctx.get(dut.i.ready)
            await ctx.tick()
        for _ in range(5):
            assert not ctx.get(dut.i.ready)
            await ctx.tick()

    async def pulse(ctx, strobe):
        ctx.set(strobe, 1)
        await ctx.tick()
        ctx.set(strobe, 0)

    async def bench(ctx):
        for name, value in (
            ("height", height), ("width", width), ("ingest_words", per_pixel), ("column_words", per_pixel),
            ("groups", groups), ("pointwise", pointwise),
        ):  # fmt: skip
            ctx.set(getattr(dut.shape, name), value)
        await pulse(ctx, dut.start)
        ctx.set(dut.i.valid, 1)
        await takes(ctx, words_per_group * groups * (ROWS_HELD if pointwise else ROWS_HELD - 1))
        await pulse(ctx, dut.retire)
        await takes(ctx, words_per_group)
        await pulse(ctx, dut.retire_row)
        await takes(ctx, words_per_group * groups)

    simulate(dut, bench)
