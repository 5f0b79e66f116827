"""Line buffer: contents, zero padding, groups announced, rows that wait for a free slot."""

import random

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
    ("channels", "height", "width"), [(4, 6, 8), (3, 5, 5), (16, 4, 7), (1, 1, 1), (5, 9, 3)]
)
def test_every_word_reads_back_with_padding_blanked(ingest, channels, height, width):
    cfg = config(ingest)
    codes = np.random.default_rng(1).integers(0, 8, (channels, height, width))
    words, per_pixel = ingest_words(codes, cfg)
    groups = ceil_div(width, GROUP)
    dut = LineBuffer(cfg)
    written = []

    async def source(ctx):
        ctx.set(dut.shape.height, height)
        ctx.set(dut.shape.width, width)
        ctx.set(dut.shape.ingest_words, per_pixel)
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
                real = min(GROUP, width - GROUP * g)
                for block in range(ceil_div(channels, cfg.rows)):
                    for mask in {(1 << real) - 1, 0, (1 << real) - 1 & 0b0101}:
                        ctx.set(dut.read.slot, y % ROWS_HELD)
                        ctx.set(dut.read.address, g * per_pixel + block // ingest)
                        ctx.set(dut.read.bank, block % ingest)
                        ctx.set(dut.read.mask, mask)
                        await ctx.tick().repeat(LineBuffer.LATENCY)
                        word = ctx.get(dut.word)
                        for pixel in range(GROUP):
                            for r in range(cfg.rows):
                                c, x = block * cfg.rows + r, GROUP * g + pixel
                                got = word >> (3 * (pixel * cfg.rows + r)) & 7
                                want = codes[c, y, x] if mask >> pixel & 1 and c < channels else 0
                                assert got == want, (c, y, x, mask)
            ctx.set(dut.retire, 1)
            await ctx.tick()
            ctx.set(dut.retire, 0)
        assert ctx.get(dut.image_written)
        assert not ctx.get(dut.i.ready), "an input beat beyond the image was accepted"

    simulate(dut, source, reader, background=[count_groups])
    assert sum(written) == height * groups


def test_a_fourth_row_waits_for_the_first_to_be_retired():
    cfg = config(2)
    dut = LineBuffer(cfg)
    height, width = 5, 4
    words, per_pixel = ingest_words(np.ones((4, height, width), int), cfg)

    async def bench(ctx):
        ctx.set(dut.shape.height, height)
        ctx.set(dut.shape.width, width)
        ctx.set(dut.shape.ingest_words, per_pixel)
        ctx.set(dut.start, 1)
        await ctx.tick()
        ctx.set(dut.start, 0)
        ctx.set(dut.i.valid, 1)
        await ctx.tick().repeat(len(words) // height * (ROWS_HELD - 1))
        for _ in range(5):
            assert not ctx.get(dut.i.ready)
            await ctx.tick()
        ctx.set(dut.retire, 1)
        await ctx.tick()
        ctx.set(dut.retire, 0)
        assert ctx.get(dut.i.ready)

    simulate(dut, bench)
