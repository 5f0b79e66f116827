"""Layers in blocks of input channels: how they are cut, packed, streamed and driven."""

from __future__ import annotations

import os
import random
from dataclasses import replace
from itertools import groupby
from pathlib import Path

import numpy as np
import pytest
from test_driver import FakeArray

from macram.cli import main
from macram.driver import ArrayDriver
from macram.golden import ResidualRule, conv2d, random_case, run_layer
from macram.pack import pack_layer, pack_passes, read_packed, unpack
from macram.pack.layout import unpack_requant, unpack_weights
from macram.pack.signed import Rise
from macram.pynq_transport import run_sync
from macram.spec import (
    BY_NAME,
    GROUP,
    ArrayConfig,
    ConvSpec,
    IntFormat,
    StreamLayout,
    SumLayout,
    layer_passes,
)

CONFIGS = Path(__file__).parents[2] / "configs"
PLAIN = ArrayConfig.from_toml(CONFIGS / "tiny.toml")
TINY = ArrayConfig.from_toml(CONFIGS / "tiny-blocks.toml")
WHOLE = replace(PLAIN, max_c_in=64, weight_depth=512, row_words=512)
"""Holds in one run what `TINY` runs in blocks, with the same formats of sums."""
SEED = int(os.environ.get("SEED") or 2022)
SIGNED = IntFormat(3, signed=True)


# ---- the cut -----------------------------------------------------------------------------------------


def test_the_two_tiny_arrays_differ_in_the_option_alone():
    assert replace(TINY, name="tiny", partial_sum_c_in=0) == PLAIN


@pytest.mark.parametrize("array", [TINY, replace(TINY, rows=3, ingest=1, row_words=31)])
def test_passes_cover_every_pair_of_channels_once(array):
    rng, cut_for_width = random.Random(SEED), 0
    for _ in range(200):
        kernel, stride = rng.choice([1, 3]), rng.choice([1, 2])
        layer = ConvSpec(
            rng.randint(1, 64), rng.randint(1, 70), 5, rng.randint(1, 40), kernel, stride, kernel // 2
        )
        passes = layer_passes(layer, array)
        seen = np.zeros((layer.c_out, layer.c_in), int)
        for part in passes:
            array.check_admits(part.layer)
            assert part.layer == replace(layer, c_in=len(part.c_in), c_out=len(part.c_out))
            seen[np.ix_(part.c_out, part.c_in)] += 1
            assert (part.sums_in, part.sums_out) == (part.c_in[0] > 0, part.c_in[-1] < layer.c_in - 1)
        assert (seen == 1).all()
        for _, chain in groupby(passes, key=lambda part: part.c_out):
            blocks = [part.c_in for part in chain]
            assert [channel for block in blocks for channel in block] == list(range(layer.c_in))
            assert max(map(len, blocks)) == len(blocks[0]) <= len(blocks[-1]) + 2 * array.rows
        if passes[0].sums_out and layer.c_in <= array.max_c_in:
            cut_for_width += 1
        try:
            array.check_admits(replace(layer, c_out=min(layer.c_out, array.units)))
        except ValueError:
            assert passes[0].sums_out
        else:
            assert not passes[0].sums_out
    assert cut_for_width > 5


def test_no_more_blocks_than_needed():
    assert [len(part.c_in) for part in layer_passes(ConvSpec(33, 8, 4, 4), TINY)] == [12, 12, 9]
    assert [len(part.c_in) for part in layer_passes(ConvSpec(17, 8, 4, 4), TINY)] == [10, 7]
    # A row of 40 pixels leaves room for two channel blocks.
    assert [len(part.c_in) for part in layer_passes(ConvSpec(16, 8, 4, 40), TINY)] == [4] * 4


@pytest.mark.parametrize(
    ("layer", "array", "line"),
    [
        (ConvSpec(17, 8, 4, 4), PLAIN, "c_in must be at most 16, not 17; .* or with partial_sum_c_in = 17$"),
        (ConvSpec(16, 8, 4, 40), PLAIN, "32; split the width, or set partial_sum_c_in$"),
        # 17 groups of one ingest word of two row-engine blocks: no block of channels is narrow enough.
        (ConvSpec(16, 8, 4, 65), PLAIN, "32; split the width, or build an array with row_words = 136$"),
        (ConvSpec(65, 8, 4, 4), TINY, "at most 64, not 65; build an array with a larger partial_sum_c_in$"),
        (
            ConvSpec(64, 8, 4, 65),
            TINY,
            "2 channels needs 34 .* 32; split the width, or build .* row_words = 34$",
        ),
        (ConvSpec(64, 8, 4, 4, output=IntFormat(4)), TINY, "output format is u3, the layer's is u4"),
    ],
)
def test_what_no_block_helps_is_refused(layer, array, line):
    with pytest.raises(ValueError, match=line):
        layer_passes(layer, array)


@pytest.mark.parametrize("value", [15, -1, 65537])
def test_the_option_is_checked(value):
    with pytest.raises(ValueError, match=rf"partial_sum_c_in must be 0 or in 16\.\.65536 .* not {value}"):
        replace(TINY, partial_sum_c_in=value)


def test_formats_follow_from_the_whole_layer():
    assert (str(PLAIN.sum), str(PLAIN.accumulator)) == ("s13", "s13")
    assert (str(TINY.sum), str(TINY.accumulator), TINY.sum_field_bits) == ("s15", "s13", 16)
    assert TINY.requant_word_bits == WHOLE.requant_word_bits
    widest = replace(
        TINY,
        weight=IntFormat(8, signed=True),
        input=IntFormat(8),
        output=IntFormat(8),
        partial_sum_c_in=65536,
    )
    assert (str(widest.sum), widest.sum_field_bits) == ("s36", 40)


# ---- the layout --------------------------------------------------------------------------------------


@pytest.mark.parametrize("shape", [(1, 1, 1), (9, 4, 3), (32, 5, 2), (17, 8, 3), (8, 12, 1)])
@pytest.mark.parametrize("beat", [32, 128])
def test_every_sum_lies_where_the_definition_says(shape, beat):
    c_out, width, height = shape
    array = replace(TINY, stream_bits=beat, row_words=64)
    layer = ConvSpec(16, c_out, height, width)
    layout = SumLayout(layer, array)
    rng = np.random.default_rng(SEED)
    sums = rng.integers(array.sum.lo, array.sum.hi, (c_out, height, width), endpoint=True)
    sums[0, 0, 0], sums[-1, -1, -1] = array.sum.lo, array.sum.hi
    beats = layout.pack(sums)
    assert beats.shape == (layout.beats, beat // 8)
    raw = beats.tobytes()
    size, word = array.sum_field_bits // 8, array.sum_word_beats * beat // 8
    groups, tiles = -(-width // GROUP), array.tiles(c_out)
    for channel in range(c_out):
        tile, unit = divmod(channel, array.units)
        drained, lane = divmod(unit, array.drain)
        for y in range(height):
            for x in range(width):
                group, slot = divmod(x + 1, GROUP)
                position = ((y * groups + group) * tiles + tile) * array.drain_cycles + drained
                at = position * word + (lane * GROUP + slot) * size
                assert int.from_bytes(raw[at : at + size], "little", signed=True) == sums[channel, y, x]
    np.testing.assert_array_equal(layout.unpack(beats), sums)


def test_wrong_sums_are_refused():
    layout = SumLayout(ConvSpec(16, 8, 2, 3), TINY)
    with pytest.raises(ValueError, match=r"must be \[8, 2, 3\], not \[8, 3, 2\]"):
        layout.pack(np.zeros((8, 3, 2), int))
    with pytest.raises(ValueError, match=r"must fit s15, not 0\.\.16384"):
        layout.pack(np.full((8, 2, 3), 16384) * np.eye(2, 3, dtype=int))
    with pytest.raises(ValueError, match="are 32 beats, not 31"):
        layout.unpack(np.zeros((31, 4), np.uint8))


# ---- the words ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", [(3, 1, SIGNED), (3, 2, SIGNED), (1, 1, IntFormat(3)), (3, 1, IntFormat(3))])
def test_the_last_block_has_the_whole_layers_requantiser(kind):
    kernel, stride, form = kind
    case = random_case(ConvSpec(50, 8, 4, 8, kernel, stride, kernel // 2, input=form), SEED)
    *others, last = pack_passes(case, TINY)
    np.testing.assert_array_equal(last.requant, pack_layer(case, WHOLE).requant)
    assert others
    first = 0
    for packed in (*others, last):
        weights = unpack_weights(packed.weights, packed.spec, TINY)
        np.testing.assert_array_equal(weights, case.weights[:, first : first + packed.spec.c_in])
        first += packed.spec.c_in
    assert first == 50


def test_a_folder_keeps_the_role_of_its_block(tmp_path):
    case = random_case(ConvSpec(40, 8, 4, 4), SEED)
    roles = []
    for index, packed in enumerate(pack_passes(case, TINY)):
        packed.write(tmp_path / str(index))
        again = read_packed(tmp_path / str(index))
        roles.append((again.sums_in, again.sums_out))
        with pytest.raises(ValueError, match="unpack whole layers"):
            unpack(again)
    assert roles == [(False, True), (True, True), (True, False)]


def test_a_block_needs_an_array_with_partial_sums():
    packed = pack_layer(random_case(ConvSpec(4, 8, 4, 4), SEED), PLAIN)
    with pytest.raises(ValueError, match="array 'tiny' has no partial sums; build one with partial_sum_c_in"):
        replace(packed, sums_out=True)


# ---- the driver --------------------------------------------------------------------------------------


class FakeBlocks(FakeArray):
    """With partial sums: they come on the parameter stream in any order with the image, and go out as the output."""

    def __init__(self, c_in):
        super().__init__(TINY)
        self.c_in = c_in
        self.parts = {}
        self.running = self.loading = False
        self.beside: list[bool] = []

    def read(self, offset):
        self.running &= offset != BY_NAME["CYCLES"].offset
        return super().read(offset)

    def write(self, offset, value):
        self.loading = (offset, value) in ((BY_NAME["CONTROL"].offset, 2), (BY_NAME["CONTROL"].offset, 4))
        super().write(offset, value)

    def take(self, stream, raw):
        if self.loading:
            super().take(stream, raw)
            self.loading = False
            if self.command == 2:
                self.beside.append(self.running)
            return
        self.parts[stream] = np.frombuffer(raw, np.uint8).reshape(-1, TINY.stream_bits // 8)
        self.running = True
        mode = self.registers["MODE"]
        sums_in, sums_out = mode >> 26 & 1, mode >> 27 & 1
        if len(self.parts) == 1 + sums_in:
            self.compute(mode, sums_in, sums_out)
            self.parts = {}

    def compute(self, mode, sums_in, sums_out):
        names = ("C_IN", "C_OUT", "HEIGHT", "WIDTH")
        spec = ConvSpec(
            *(self.registers[name] for name in names), mode & 255, mode >> 8 & 255, mode >> 16 & 255
        )
        image = StreamLayout(spec.c_in, spec.input, TINY.stream_bits).unpack(
            self.parts["image"], spec.height, spec.width
        )
        weight_words, requant_words = self.memory(spec)
        weights = unpack_weights(weight_words, spec, TINY)
        sums = conv2d(image, weights, stride=spec.stride, padding=spec.padding)
        layout = SumLayout(spec, TINY)
        if sums_in:
            sums = sums + layout.unpack(self.parts["param"])
        if sums_out:
            self.output = layout.pack(sums)
        else:
            none = Rise(*[np.zeros(spec.c_out, np.int64)] * 3)
            rule = unpack_requant(requant_words, none, replace(spec, c_in=self.c_in), TINY)
            self.output = StreamLayout(spec.c_out, spec.output, TINY.stream_bits).pack(rule.apply(sums))


def test_the_driver_runs_the_blocks_and_loads_beside_those_that_take_no_sums():
    case = random_case(ConvSpec(33, 20, 4, 5, stride=2), SEED)
    passes = pack_passes(case, TINY)
    fake = FakeBlocks(33)
    driver = ArrayDriver(fake.transport(), TINY)
    run_sync(driver.identify())
    result = run_sync(driver.run_passes(passes, case.input))
    np.testing.assert_array_equal(result.codes, run_layer(case))
    # No two of these blocks fit into the memories.
    assert fake.beside == [False] * len(passes)
    case = random_case(ConvSpec(33, 20, 4, 5, 1, 1, 0), SEED)
    passes, fake.beside = pack_passes(case, TINY), []
    result = run_sync(driver.run_passes(passes, case.input))
    np.testing.assert_array_equal(result.codes, run_layer(case))
    # Of three blocks the second is loaded beside the first; those that take sums leave no room on the stream.
    assert fake.beside == [False, True, False] * (len(passes) // 3)
    assert fake.buffers == 0


def test_sums_and_their_setting_go_together():
    case = random_case(ConvSpec(20, 8, 2, 3), SEED)
    first, second = pack_passes(case, TINY)
    driver = ArrayDriver(FakeBlocks(20).transport(), TINY)
    sums = np.zeros((8, 2, 3), np.int64)
    run_sync(driver.configure(second.spec, sums_in=True))
    with pytest.raises(ValueError, match=r"configure\(sums_in=True\) go together; give both or none"):
        run_sync(driver.run(case.input[first.spec.c_in :]))
    run_sync(driver.configure(second.spec))
    with pytest.raises(ValueError, match="go together; give both or none"):
        run_sync(driver.run(case.input[first.spec.c_in :], sums=sums))


def test_what_an_array_does_not_have_is_refused_before_a_register_is_written():
    fake = FakeArray(PLAIN)
    spec = ConvSpec(4, 8, 2, 3)
    for setting in ("sums_in", "sums_out"):
        with pytest.raises(
            ValueError, match="array 'tiny' has no partial sums; build one with partial_sum_c_in"
        ):
            run_sync(ArrayDriver(fake.transport(), PLAIN).configure(spec, **{setting: True}))
    both = replace(TINY, residual_stream_bits=32)
    rule = ResidualRule(IntFormat(3), np.arange(8), np.arange(7))
    with pytest.raises(ValueError, match="give the rule to the last block of input channels"):
        run_sync(ArrayDriver(fake.transport(), both).configure(spec, rule, sums_out=True))
    assert fake.log == []


# ---- the command line --------------------------------------------------------------------------------


def test_a_layer_for_another_array_gets_one_line(tmp_path, capsys):
    random_case(ConvSpec(50, 12, 5, 6), SEED).save(tmp_path / "layer.npz")
    arguments = ["layer", str(tmp_path / "layer.npz"), "-o", str(tmp_path / "out"), "--array"]
    assert main([*arguments, str(CONFIGS / "tiny.toml")]) == 2
    error = capsys.readouterr().err
    assert error.count("\n") == 1
    assert "c_in must be at most 16, not 50; build an array with a larger max_c_in" in error
    assert "partial_sum_c_in = 50" in error
    assert not (tmp_path / "out").exists()


def test_every_block_is_packed_into_a_folder(tmp_path, capsys):
    random_case(ConvSpec(50, 12, 5, 6), SEED).save(tmp_path / "layer.npz")
    arguments = ["pack", str(tmp_path / "layer.npz"), "-o", str(tmp_path / "out")]
    assert main([*arguments, "--array", str(CONFIGS / "tiny-blocks.toml")]) == 0
    assert "in 8 passes of up to 14 -> 8 channels" in capsys.readouterr().out
    assert len(list((tmp_path / "out").glob("pass_*/manifest.json"))) == 8
