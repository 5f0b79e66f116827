"""Unit core: steps with carry between groups against a plain 1-D convolution over whole rows."""

from dataclasses import replace

import numpy as np
import pytest
from amaranth.hdl import Module
from stream_testing import simulate

from macram.spec import ENGINE_LATENCY, GROUP, TAPS, ArrayConfig
from macram_hw.engine_2x import Interleaver
from macram_hw.unit import UnitCore, control_delay, unit_latency

CONFIG = ArrayConfig(
    units=8, rows=2, drain=2, max_c_in=16, max_c_out=32, weight_depth=64, row_words=32, stream_bits=32
)


def interleaved(core, config):
    """A unit core with its activations also at twice the clock, as in the array."""
    m = Module()
    m.submodules.core = core
    m.submodules.interleaver = interleaver = Interleaver(config)
    m.d.comb += [
        interleaver.word.eq(core.activations),
        core.pixels_2x.eq(interleaver.pixels),
        core.second.eq(interleaver.second),
    ]
    return m


@pytest.mark.parametrize(
    ("engine", "soft_rows"), [*((engine, 0) for engine in ENGINE_LATENCY), ("dsp48e2", 1)]
)
@pytest.mark.parametrize("kind", ["random", "most negative", "most positive", "zero"])
def test_rows_of_several_tiles_interleave_without_mixing(kind, engine, soft_rows):
    """Two rows of 12 columns, 3 tiles, 2 steps per sum: all columns but the last of the last row appear."""
    rng = np.random.default_rng(5)
    rows, width, tiles, steps = 2, 12, 3, 2
    groups = width // GROUP
    if kind == "random":
        acts = rng.integers(0, 8, (rows, steps, CONFIG.rows, width))
        taps = rng.integers(-4, 4, (tiles, steps, CONFIG.rows, TAPS))
    else:
        value = {"most negative": -4, "most positive": 3, "zero": 0}[kind]
        acts = np.full((rows, steps, CONFIG.rows, width), 7)
        taps = np.full((tiles, steps, CONFIG.rows, TAPS), value)
    # Reversed taps: column x gets pixel x + 1 with tap 0, pixel x with tap 1, pixel x - 1 with tap 2.
    padded = np.pad(acts, ((0, 0),) * 3 + ((1, 1),))
    expected = sum(
        np.einsum("tsr,ysrx->ytx", taps[..., j], padded[..., 2 - j : 2 - j + width]) for j in range(TAPS)
    )

    plan = [
        (y, g, t, s) for y in range(rows) for g in range(groups) for t in range(tiles) for s in range(steps)
    ]
    config = replace(CONFIG, engine=engine, soft_rows=soft_rows)
    dut = UnitCore(config)
    design = interleaved(dut, config) if config.paired_rows else dut
    results = {}

    async def bench(ctx):
        await ctx.tick().repeat(2)
        depth = unit_latency(config) + 1
        for cycle in range(len(plan) + depth + 1):
            if cycle >= depth and cycle - depth < len(plan):
                y, g, t, s = plan[cycle - depth]
                if s == steps - 1:
                    results[y, g, t] = [ctx.get(dut.chain_o[i]) for i in range(GROUP)]
            weight = 0
            if cycle < len(plan):
                _, _, t, s = plan[cycle]
                for position, tap in enumerate(taps[t, s].reshape(-1)):
                    weight |= (int(tap) & 7) << (3 * position)
            ctx.set(dut.weight, weight)
            word = 0
            if 0 <= cycle - 1 < len(plan):
                y, g, _, s = plan[cycle - 1]
                for position, code in enumerate(acts[y, s, :, GROUP * g : GROUP * g + GROUP].T.reshape(-1)):
                    word |= int(code) << (3 * position)
            ctx.set(dut.activations, word)
            at = cycle - 1 - control_delay(config)
            active = 0 <= at < len(plan)
            ctx.set(dut.control.en, active)
            if active:
                _, g, t, s = plan[at]
                ctx.set(dut.control.first, s == 0)
                ctx.set(dut.control.carried, s == 0)
                ctx.set(dut.control.last, s == steps - 1)
                ctx.set(dut.control.edge, g == 0)
                ctx.set(dut.control.tile, t)
            await ctx.tick()

    simulate(design, bench)
    checked = 0
    for (y, g, t), slots in results.items():
        for slot, value in enumerate(slots):
            row, x = (y, GROUP * g - 1 + slot) if (g, slot) != (0, 0) else (y - 1, width - 1)
            if row >= 0:
                assert value == expected[row, t, x], (row, t, x)
                checked += 1
    assert checked == rows * tiles * width - tiles


@pytest.mark.parametrize("engine", ["portable", "dsp48e2"])
def test_two_pixels_of_three_tiles(engine):
    """Three sums in a row; in the middle of the next one the carried lanes are moved, between the shifts of a ring."""
    rng = np.random.default_rng(9)
    sums, steps = 3, 4
    config = replace(CONFIG, engine=engine)
    dut = UnitCore(config)
    acts = rng.integers(0, 8, (sums, steps, CONFIG.rows, 2))
    taps = rng.integers(-4, 4, (sums, steps, CONFIG.rows, TAPS))
    acts[1], taps[1] = 7, -4
    expected = np.einsum("nsrp,nsrt->npt", acts, taps)
    # A sum's steps with a hole in them, in which the lanes of the sum before are moved.
    plan = [(n, s) for n in range(sums) for s in (0, 1, None, 2, 3)] + [(sums, None)]
    found = {}

    async def bench(ctx):
        await ctx.tick().repeat(2)
        depth = unit_latency(config) + 1
        for cycle in range(len(plan) + depth + 1):
            if cycle >= depth and cycle - depth < len(plan):
                n, s = plan[cycle - depth]
                slots = [ctx.get(dut.chain_o[slot]) for slot in range(GROUP)]
                if s == steps - 1:
                    found[n] = [[slots[0], slots[1], slots[2]], [slots[3], None, None]]
                elif s is None and n > 0:
                    assert slots[1:3] == found[n - 1][0][1:]
                    found[n - 1][1][1:] = [slots[0], slots[3]]
            n, s = plan[cycle] if cycle < len(plan) else (0, None)
            bits = [int(tap) & 7 for tap in taps[n, s].reshape(-1)] if s is not None else []
            ctx.set(dut.weight, sum(tap << (3 * at) for at, tap in enumerate(bits)))
            n, s = plan[cycle - 1] if 0 <= cycle - 1 < len(plan) else (0, None)
            word = 0
            if s is not None:
                for r in range(CONFIG.rows):
                    outer_left, outer_right = (int(code) for code in acts[n, s, r])
                    word |= outer_left << (3 * r) | outer_right << (3 * (3 * CONFIG.rows + r))
            ctx.set(dut.activations, word)
            at = cycle - 1 - control_delay(config)
            n, s = plan[at] if 0 <= at < len(plan) else (0, None)
            unload = s is None and n > 0
            ctx.set(dut.control.en, s is not None)
            ctx.set(dut.control.first, s == 0)
            ctx.set(dut.control.last, s == steps - 1)
            ctx.set(dut.control.carried, unload)
            ctx.set(dut.control.unload, unload)
            ctx.set(dut.control.tile, n - 1 if unload else n)
            await ctx.tick()

    simulate(dut, bench)
    assert found == {n: expected[n].tolist() for n in range(sums)}


def test_the_result_register_shifts_from_its_neighbour():
    dut = UnitCore(CONFIG)

    async def bench(ctx):
        for slot in range(GROUP):
            ctx.set(dut.chain_i[slot], -5 - slot)
        await ctx.tick()
        assert [ctx.get(dut.chain_o[s]) for s in range(GROUP)] == [0] * GROUP
        ctx.set(dut.shift, 1)
        await ctx.tick()
        assert [ctx.get(dut.chain_o[s]) for s in range(GROUP)] == [-5, -6, -7, -8]

    simulate(dut, bench)
