"""Shape decoder: refuses at run time exactly what the spec refuses."""

import random
from dataclasses import replace

import pytest
from stream_testing import simulate

from macram.spec import ArrayConfig, ConvSpec, Error, IntFormat, StreamLayout, ceil_div
from macram.spec.registers import MODES
from macram_hw.shape import ShapeDecoder

CONFIG = ArrayConfig(
    units=16, rows=4, drain=4, max_c_in=64, max_c_out=96, weight_depth=64, row_words=48, stream_bits=32
)


RESIDUAL = replace(CONFIG, residual_stream_bits=128)
BLOCKS = replace(CONFIG, partial_sum_c_in=256)
BOTH = replace(RESIDUAL, partial_sum_c_in=64)
SIGNED = replace(CONFIG, input=IntFormat(3, signed=True))


def layer_of(height, width, c_in, c_out, mode):
    """The layer that the registers describe, if any."""
    return ConvSpec(
        c_in, c_out, height, width, kernel=mode & 255, stride=mode >> 8 & 255, padding=mode >> 16 & 255,
        input=IntFormat(3, signed=bool(mode >> 24)),
    )  # fmt: skip


def admitted(config, *registers):
    try:
        config.check_admits(layer_of(*registers))
    except ValueError:
        return False
    return True


def set_registers(ctx, dut, *registers):
    for name, value in zip(("height", "width", "c_in", "c_out", "mode"), registers, strict=True):
        ctx.set(getattr(dut, name), value)


@pytest.mark.parametrize("rows", [4, 3, 11])
def test_hardware_and_spec_agree_on_every_shape(rows):
    config = replace(CONFIG, rows=rows)
    rng = random.Random(6)
    edges = {
        "width": [0, 1, 3, 4, 5, 96, 97, 191, 192, 193, 65532, 65533, 65535, 65536, 0x10004, 0xFFFFFFFF],
        "c_in": [0, 1, 4, 63, 64, 65],
        "c_out": [0, 1, 95, 96, 97],
    }
    modes = [mode | signed << 24 for mode in MODES for signed in (0, 1)]
    shapes = [
        (
            rng.choice([0, 1, 7, 65535, 65536, 0x10007]),
            *(rng.choice([*values, rng.randrange(100)]) for values in edges.values()),
            rng.choice(modes),
        )
        for _ in range(1500)
    ]
    dut = ShapeDecoder(config)
    seen, packed = set(), set()

    async def bench(ctx):
        for registers in shapes:
            set_registers(ctx, dut, *registers)
            await ctx.tick().repeat(ShapeDecoder.LATENCY)
            fits = admitted(config, *registers)
            assert ctx.get(dut.error) == (Error.NONE if fits else Error.BAD_SHAPE), registers
            seen.add((fits, registers[-1]))
            packed.add(fits and config.triples(layer_of(*registers)))
            if not fits:
                continue
            layer = layer_of(*registers)
            ingest_words = ceil_div(config.blocks(layer.c_in), config.ingest)
            expected = {
                "height": layer.height,
                "width": layer.width,
                "out_height": layer.out_height,
                "groups": config.groups(layer.out_width),
                "tail": layer.out_width % 4,
                "blocks": config.blocks(layer.c_in),
                "ingest_words": ingest_words,
                "column_words": ingest_words * layer.stride,
                "tiles": config.tiles(layer.c_out),
                "output_words": ceil_div(layer.c_out, config.output_word_channels),
                "beats_in": StreamLayout(layer.c_in, layer.input, config.stream_bits).beats_per_pixel,
                "beats_out": StreamLayout(layer.c_out, layer.output, config.stream_bits).beats_per_pixel,
                "pointwise": layer.kernel == 1,
                "halved": layer.stride == 2,
                "packed": config.triples(layer) > 0,
                "biased": config.biased(layer),
            }
            assert {name: ctx.get(getattr(dut.shape, name)) for name in expected} == expected
            assert ctx.get(dut.weight_end) == config.weight_words(layer)
            assert ctx.get(dut.requant_end) == config.requant_words(layer)

    simulate(dut, bench, cycles=40_000)
    assert seen == {(fits, mode) for fits in (True, False) for mode in modes}
    # Eleven rows have too few channel blocks for triples.
    assert packed == ({0} if rows == 11 else {0, 1, 2})


@pytest.mark.parametrize("config", [CONFIG, SIGNED, RESIDUAL, BLOCKS, BOTH])
def test_other_modes_are_refused(config):
    dut = ShapeDecoder(config)
    bits = [0] if config.input.signed else [0, 1 << 24]
    ends = [0] + [1 << 25] * bool(config.residual_stream_bits) + [1 << 27] * bool(config.partial_sum_c_in)
    bits = [bit | end for bit in bits for end in ends]
    bits += [bit | 1 << 26 for bit in bits] if config.partial_sum_c_in else []
    known = {mode | bit for mode in MODES for bit in bits}
    neighbours = {mode ^ 1 << bit for mode in known for bit in range(32)} | {0, 0x0100_0000, 0xFFFF_FFFF}

    async def bench(ctx):
        for mode in known | neighbours:
            set_registers(ctx, dut, 4, 4, 4, 4, mode)
            await ctx.tick().repeat(ShapeDecoder.LATENCY)
            assert ctx.get(dut.error) == (Error.NONE if mode in known else Error.BAD_MODE), hex(mode)

    simulate(dut, bench)


def test_words_must_lie_in_the_memories():
    dut = ShapeDecoder(CONFIG)
    weights, requant = 3, CONFIG.drain_cycles

    async def bench(ctx):
        for weight_base, requant_base, error in (
            (CONFIG.weight_depth - weights, CONFIG.requant_depth - requant, Error.NONE),
            (CONFIG.weight_depth - weights + 1, 0, Error.BAD_RANGE),
            (0, CONFIG.requant_depth - requant + 1, Error.BAD_RANGE),
            (0xFFFF_FFFF, 0, Error.BAD_RANGE),
            (0, 0xFFFF_FFFF, Error.BAD_RANGE),
        ):
            set_registers(ctx, dut, 4, 4, 4, 4, MODES[-2])
            ctx.set(dut.weight_base, weight_base)
            ctx.set(dut.requant_base, requant_base)
            await ctx.tick().repeat(ShapeDecoder.LATENCY)
            assert ctx.get(dut.error) == error, (weight_base, requant_base)

    simulate(dut, bench)
