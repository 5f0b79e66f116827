"""Shape decoder: refuses at run time exactly what the spec refuses."""

import random
from dataclasses import replace

import pytest
from stream_testing import simulate

from macram.spec import ArrayConfig, ConvSpec, Error, StreamLayout, ceil_div
from macram.spec.registers import MODE_3X3
from macram_hw.shape import ShapeDecoder

CONFIG = ArrayConfig(
    units=16, rows=4, drain=4, max_c_in=64, max_c_out=96, weight_depth=64, row_words=48, stream_bits=32
)


def admitted(config, height, width, c_in, c_out):
    try:
        config.check_admits(ConvSpec(c_in, c_out, height, width))
    except ValueError:
        return False
    return True


@pytest.mark.parametrize("rows", [4, 3, 11])
def test_hardware_and_spec_agree_on_every_shape(rows):
    config = replace(CONFIG, rows=rows)
    rng = random.Random(6)
    edges = {
        "width": [0, 1, 3, 4, 5, 96, 97, 192, 193, 65532, 65533, 65535, 65536, 0x10004, 0xFFFFFFFF],
        "c_in": [0, 1, 4, 63, 64, 65],
        "c_out": [0, 1, 95, 96, 97],
    }
    shapes = [
        (
            rng.choice([0, 1, 7, 65535, 65536, 0x10007]),
            *(rng.choice([*values, rng.randrange(100)]) for values in edges.values()),
        )
        for _ in range(800)
    ]
    dut = ShapeDecoder(config)
    seen = set()

    async def bench(ctx):
        for height, width, c_in, c_out in shapes:
            for name, value in (("height", height), ("width", width), ("c_in", c_in), ("c_out", c_out)):
                ctx.set(getattr(dut, name), value)
            ctx.set(dut.mode, MODE_3X3)
            await ctx.tick().repeat(ShapeDecoder.LATENCY)
            fits = admitted(config, height, width, c_in, c_out)
            assert ctx.get(dut.error) == (Error.NONE if fits else Error.BAD_SHAPE), (
                height,
                width,
                c_in,
                c_out,
            )
            seen.add(fits)
            if not fits:
                continue
            layer = ConvSpec(c_in, c_out, height, width)
            expected = {
                "height": height,
                "width": width,
                "groups": config.groups(width),
                "tail": width % 4,
                "blocks": config.blocks(c_in),
                "ingest_words": ceil_div(config.blocks(c_in), config.ingest),
                "tiles": config.tiles(c_out),
                "output_words": ceil_div(c_out, config.output_word_channels),
                "beats_in": StreamLayout(c_in, layer.input, config.stream_bits).beats_per_pixel,
                "beats_out": StreamLayout(c_out, layer.output, config.stream_bits).beats_per_pixel,
            }
            assert {name: ctx.get(getattr(dut.shape, name)) for name in expected} == expected

    simulate(dut, bench)
    assert seen == {True, False}


def test_another_mode_is_refused():
    dut = ShapeDecoder(CONFIG)

    async def bench(ctx):
        for name in ("height", "width", "c_in", "c_out"):
            ctx.set(getattr(dut, name), 4)
        for mode in (0x0001_0203, 0x0000_0103, 0x0001_0101, 0):
            ctx.set(dut.mode, mode)
            await ctx.tick().repeat(ShapeDecoder.LATENCY)
            assert ctx.get(dut.error) == Error.BAD_MODE

    simulate(dut, bench)
