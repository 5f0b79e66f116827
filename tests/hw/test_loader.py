"""Parameter loader: every word at its address, TLAST faults named."""

import random

import pytest
from stream_testing import put, simulate

from macram.spec import ArrayConfig, Error, ceil_div
from macram_hw.loader import Loader

CONFIG = ArrayConfig(
    units=8, rows=4, drain=2, max_c_in=16, max_c_out=32, weight_depth=64, row_words=32, stream_bits=32
)


def beats(words, bits):
    return [
        word >> (CONFIG.stream_bits * b) & ((1 << CONFIG.stream_bits) - 1)
        for word in words
        for b in range(ceil_div(bits, CONFIG.stream_bits))
    ]


def load(kind, words, per_unit, *, last_at=-1, gap=0.3, base=0):
    bits = CONFIG.weight_word_bits if kind == "weights" else CONFIG.requant_word_bits
    flat = beats(words, bits)
    last = len(flat) - 1 if last_at == -1 else last_at
    payloads = [{"data": beat, "last": index == last} for index, beat in enumerate(flat)]
    dut = Loader(CONFIG)
    writes, faults = [], []

    async def source(ctx):
        assert not ctx.get(dut.i.ready), "beats are accepted although nothing is being loaded"
        ctx.set(dut.words, per_unit)
        ctx.set(dut.base, base)
        ctx.set(getattr(dut, f"start_{kind}"), 1)
        await ctx.tick()
        ctx.set(getattr(dut, f"start_{kind}"), 0)
        stop = len(payloads) if last_at in (-1, None) else last_at + 1
        await put(ctx, dut.i, payloads[:stop], gap=gap, rng=random.Random(9))
        await ctx.tick().repeat(3)
        assert not ctx.get(dut.busy)

    async def monitor(ctx):
        while True:
            *_, unit_en, weight, requant_en, requant, fault, error = await ctx.tick().sample(
                dut.unit_en, dut.weight, dut.requant_en, dut.requant, dut.fault, dut.error
            )
            for unit in range(CONFIG.units):
                if unit_en >> unit & 1:
                    writes.append((unit, weight.addr, weight.data))
            if requant_en:
                writes.append((requant.addr, requant.data))
            if fault:
                faults.append(error)

    simulate(dut, source, background=[monitor])
    return writes, faults


def test_weights_go_unit_by_unit():
    rng = random.Random(4)
    words = [rng.getrandbits(CONFIG.weight_word_bits) for _ in range(CONFIG.units * 5)]
    writes, faults = load("weights", words, 5, base=7)
    assert writes == [(i // 5, 7 + i % 5, word) for i, word in enumerate(words)]
    assert not faults


def test_requantiser_words_go_in_order():
    rng = random.Random(5)
    words = [rng.getrandbits(CONFIG.requant_word_bits) for _ in range(7)]
    writes, faults = load("requant", words, 7, base=9)
    assert writes == list(enumerate(words, 9))
    assert not faults


@pytest.mark.parametrize("kind", ["weights", "requant"])
def test_an_early_tlast_ends_the_load_with_its_error(kind):
    words = list(range(1, 1 + (CONFIG.units if kind == "weights" else 1) * 4))
    _, faults = load(kind, words, 4, last_at=2)
    assert faults == [Error.TLAST_EARLY]


def test_a_missing_tlast_is_an_error():
    _, faults = load("requant", [1, 2, 3], 3, last_at=None)
    assert faults == [Error.TLAST_MISSING]
