from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import pytest

from macram.spec import BY_NAME, REGISTERS, ArrayConfig, ConvSpec, IntFormat, layer_passes
from macram.spec.registers import ADDRESS_BITS, ID_VALUE

CONFIGS = Path(__file__).parents[2] / "configs"


def test_reference_figures():
    array = ArrayConfig.from_toml(CONFIGS / "reference.toml")
    assert array == ArrayConfig()
    assert str(array.accumulator) == "s19"
    assert (array.weight_word_bits, array.line_word_bits, array.block_bits) == (72, 96, 24)
    assert (array.thresholds, array.requant_entry_bits, array.requant_word_bits) == (7, 168, 672)
    assert (array.requant_depth, array.max_tiles, array.drain_cycles) == (256, 16, 16)
    assert array.peak_macs == 6144
    layer = ConvSpec(64, 128, 128, 128)
    array.check_admits(layer)
    assert (array.blocks(64), array.tiles(128), array.groups(128), array.weight_words(layer)) == (
        8,
        2,
        32,
        48,
    )
    steps = layer.height * array.groups(128) * array.tiles(128) * 3 * array.blocks(64)
    assert steps == 196_608


ARRAYS = [path for path in sorted(CONFIGS.glob("*.toml")) if "[array]" in path.read_text().splitlines()]


@pytest.mark.parametrize("path", ARRAYS, ids=lambda path: path.stem)
def test_ready_made_configurations_survive_the_round_trip(path):
    array = ArrayConfig.from_toml(path)
    assert ArrayConfig.from_dict(array.to_dict()) == array
    assert array.name == path.stem


def test_the_slowest_kind_of_a_mixed_unit_gives_the_latency():
    mixed = ArrayConfig(rows=6, engine="dsp48e2", soft_rows=2)
    assert mixed.row_kinds == ("dsp48e2",) * 4 + ("soft",) * 2
    assert (mixed.engine_latency, ArrayConfig(engine="soft").engine_latency) == (4, 1)
    assert (mixed.xilinx, ArrayConfig().xilinx) == (True, False)


def test_eight_output_bits_use_the_multiplier():
    array = ArrayConfig(output=IntFormat(8))
    assert (array.thresholds, array.requant_entry_bits) == (0, 18 + 48 + 6 + 2 * 17)
    assert ArrayConfig(output=IntFormat(4)).thresholds == 15


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"name": ""}, "name must be letters, digits, .*, not ''"),
        ({"name": "../x"}, "name must be letters, digits, .*, not '../x'"),
        ({"units": 2}, r"units must be in 4\.\.1024, not 2"),
        ({"units": 48}, "units must be a power of two, not 48"),
        ({"units": 8}, r"units must be a multiple of 4 \* drain = 16, not 8"),
        ({"rows": 0}, r"rows must be in 1\.\.64, not 0"),
        ({"drain": 3}, "drain must be a power of two, not 3"),
        ({"max_c_in": 9000}, r"max_c_in must be in 1\.\.8192, not 9000"),
        ({"max_c_out": 100}, "max_c_out must be a multiple of units = 64, not 100"),
        ({"weight_depth": 2}, r"weight_depth must be in 3\.\.65536, not 2"),
        ({"row_words": 511}, "row_words must be a multiple of ingest = 2, not 511"),
        ({"requant_ram": "ultra"}, "requant_ram must be one of block, distributed, not 'ultra'"),
        ({"engine": "fast"}, "engine must be one of .*portable.*, not 'fast'"),
        ({"soft_rows": 8}, r"soft_rows must be in 0\.\.7 with 8 rows of engine portable, not 8"),
        ({"soft_rows": -1}, r"soft_rows must be in 0\.\.7 .*, not -1"),
        (
            {"engine": "soft", "soft_rows": 1},
            r"soft_rows must be in 0\.\.0 with 8 rows of engine soft, not 1",
        ),
        ({"output": IntFormat(9)}, r"output bits must be in 2\.\.8, not 9"),
        ({"input": IntFormat(1)}, r"input bits must be in 2\.\.8, not 1"),
        ({"weight": IntFormat(3)}, "weight must be a signed format, not u3"),
        ({"stream_bits": 48}, "stream_bits must be 32, 64, 128, 256 or 512, not 48"),
        ({"ingest": 3}, "ingest must be 1, 2, 4 or 8, not 3"),
    ],
)
def test_bad_arrays_are_refused(changes, words):
    with pytest.raises(ValueError, match=words):
        ArrayConfig(**changes)


@pytest.mark.parametrize(
    ("layer", "words"),
    [
        ({"input": IntFormat(8)}, "the array's input format is u3, the layer's is u8"),
        ({"weight": IntFormat(4, signed=True)}, "the array's weight format is s3, the layer's is s4"),
        ({"output": IntFormat(3, signed=True)}, "the array's output format is u3, the layer's is s3"),
        ({"input": IntFormat(4, signed=True)}, "the array's input format is u3, the layer's is s4"),
        ({"padding": 0}, "not 3x3 with padding 0"),
        ({"padding": 0, "stride": 2}, "not 3x3 with padding 0"),
        ({"c_in": 1025}, "c_in must be at most 1024, not 1025"),
        ({"c_out": 1025}, "c_out must be at most 1024, not 1025"),
        ({"height": 65536}, "height and width must be at most 65535, not 65536x8"),
        (
            {"c_in": 512, "c_out": 384},
            "512 -> 384 channels need 1152 weight words per unit, the array has 1024",
        ),
        (
            {"c_in": 512, "c_out": 192, "stride": 2},
            "512 -> 192 channels need 1152 weight words per unit, the array has 1024",
        ),
        ({"c_in": 8, "width": 2050, "stride": 2, "kernel": 1, "padding": 0}, "needs 1028 line-buffer words"),
        (
            {"c_in": 64, "width": 513, "kernel": 1, "padding": 0, "stride": 2},
            "513 pixels x 64 channels needs 1040 line-buffer words",
        ),
        (
            {"c_in": 64, "width": 260},
            "260 pixels x 64 channels needs 520 line-buffer words, the array has 512",
        ),
        ({"c_in": 65, "width": 208}, "208 pixels x 65 channels needs 520 line-buffer words"),
    ],
)
def test_layers_that_do_not_fit_are_refused(layer, words):
    with pytest.raises(ValueError, match=words):
        ArrayConfig().check_admits(ConvSpec(**{"c_in": 8, "c_out": 8, "height": 8, "width": 8, **layer}))


@pytest.mark.parametrize(
    "layer",
    [
        {"c_in": 512, "c_out": 320},
        {"c_in": 64, "width": 256},
        {"c_in": 64, "width": 256, "stride": 2},
        {"c_in": 1024, "c_out": 128},
        {"c_in": 1024, "c_out": 64, "stride": 2},
        {"c_in": 1024, "c_out": 512, "kernel": 1, "padding": 0},
        {"input": IntFormat(3, signed=True)},
        {"height": 65535},
    ],
)
def test_layers_that_just_fit_are_admitted(layer):
    ArrayConfig().check_admits(ConvSpec(**{"c_in": 8, "c_out": 8, "height": 8, "width": 8, **layer}))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[array]\nunit = 64\n", "unknown key 'unit'; known are drain, .*"),
        ('[array]\nweight = "3"\n', "weight must be 'u' or 's' and a bit count of 2 to 8, such .*, not '3'$"),
        ("[array]\ninput = 3\n", "input must be 'u' or 's' and a bit count of 2 to 8, such as 'u3', not 3$"),
        ('[array]\noutput = "u999"\n', "output must be 'u' or 's' .*, not 'u999'$"),
        ('[array]\noutput = "u²"\n', "output must be 'u' or 's' .*, not 'u²'$"),
        ('[array]\nunits = "64"\n', "units must be a whole number, not '64'$"),
        ("[array]\nunits = 64.0\n", r"units must be a whole number, not 64\.0$"),
        ("[array]\nrows = true\n", "rows must be a whole number, not True$"),
        ("[array]\nstream_bits = [64]\n", r"stream_bits must be a whole number, not \[64\]$"),
        ("[array]\nname = 5\n", "name must be a text in quotes, not 5$"),
        ("[array]\nengine = []\n", r"engine must be a text in quotes, not \[\]$"),
        ("array = 5\n", "array must be a table of fields, not 5$"),
        ("[[array]]\nunits = 64\n", "array must be a table of fields, not "),
        ("[array\n", "is not TOML: .*at line 1"),
        ("units = 64\n", r"has no \[array\] table"),
        ("", r"has no \[array\] table"),
        ("[array]\nunits = 2\n", r"units must be in 4\.\.1024, not 2"),
        ("[array]\n", r"\[array\] has no name; add it, it tells this array's reports from others'$"),
        ('[array]\nname = "a"\nrows = 4\n', r"\[array\] has no units; add it, for example units = 64$"),
        (
            '[array]\nname = "a"\nunits = 64\n',
            r"\[array\] has no rows; add it, row engines per unit, for example",
        ),
    ],
)
def test_bad_files_are_refused_by_name(tmp_path, text, words):
    path = tmp_path / "bad.toml"
    path.write_text(text)
    with pytest.raises(ValueError, match=words) as caught:
        ArrayConfig.from_toml(path)
    assert str(caught.value).startswith(f"{path}: ")


def test_what_a_file_leaves_out_is_the_reference_array_s(tmp_path):
    path = tmp_path / "small.toml"
    path.write_text('[array]\nname = "small"\nunits = 32\nrows = 4\n')
    assert ArrayConfig.from_toml(path) == ArrayConfig(name="small", units=32, rows=4)


def test_files_that_cannot_be_read_are_refused_by_name(tmp_path):
    with pytest.raises(ValueError, match=r"absent\.toml: cannot be read, No such file or directory; name"):
        ArrayConfig.from_toml(tmp_path / "absent.toml")
    (tmp_path / "bad.toml").write_bytes(b'[array]\nname = "\xe9"\n')
    with pytest.raises(ValueError, match=r"bad\.toml: is not UTF-8 text; save it as such$"):
        ArrayConfig.from_toml(tmp_path / "bad.toml")


def test_register_map_is_consistent():
    offsets = [register.offset for register in REGISTERS]
    assert len(set(offsets)) == len(offsets) == len(BY_NAME)
    assert offsets == sorted(offsets)
    for register in REGISTERS:
        assert register.offset % 4 == 0
        assert 0 <= register.offset < 1 << ADDRESS_BITS
        assert register.access in ("RO", "RW", "WO")
        assert 0 <= register.reset < 1 << 32
        assert BY_NAME[register.name] is register
    assert ID_VALUE.to_bytes(4, "big") == b"MACR"


def test_passes_cover_the_channels_and_fit_in_pairs_where_they_can():
    array = ArrayConfig()
    for c_in, c_out, stride, wanted in (
        (64, 128, 1, [128]),
        (512, 1024, 1, [128] * 8),
        (512, 1000, 1, [128] * 7 + [104]),
        (1024, 256, 2, [64] * 4),
        (1024, 1024, 1, [64] * 16),
        (8, 2500, 1, [512] * 4 + [452]),
    ):
        layer = ConvSpec(c_in, c_out, 8, 8, stride=stride)
        passes = layer_passes(layer, array)
        assert [len(part.c_out) for part in passes] == wanted
        assert [channel for part in passes for channel in part.c_out] == list(range(c_out))
        assert not any(part.sums_in or part.sums_out for part in passes)
        for part in passes:
            assert (part.layer.c_in, part.layer.c_out) == (c_in, len(part.c_out))
            array.check_admits(part.layer)
    with pytest.raises(
        ValueError,
        match="c_in must be at most 1024, not 1025; build an array with a larger max_c_in, or with",
    ):
        layer_passes(ConvSpec(1025, 4096, 8, 8), array)


@pytest.mark.parametrize("engine", ["portable", "dsp48e2_2x"])
@pytest.mark.parametrize("drain", [1, 4])
def test_three_tiles_together_exactly_where_that_takes_fewer_cycles(engine, drain):
    array = ArrayConfig(engine=engine, drain=drain, rows=2)
    for blocks in range(1, 500):
        layer = ConvSpec(2 * blocks, 192, 8, 8, 1, 1, 0)
        together = 2 * max(blocks + 1, array.pair_drain)
        assert array.triples(layer) == (together < 3 * max(blocks, array.drain_period))
    assert array.triples(ConvSpec(1024, 191, 8, 8, 1, 1, 0)) == 1
    assert array.triples(ConvSpec(1024, 128, 8, 8, 1, 1, 0)) == 0
    assert array.triples(ConvSpec(1000, 192, 8, 8)) == 0
    summing = replace(array, partial_sum_c_in=2048)  # its streams take sums of one tile
    assert summing.triples(ConvSpec(1024, 192, 8, 8, 1, 1, 0)) == 0


def test_two_taps_of_three_save_weight_words():
    array = ArrayConfig()
    words = {
        tiles: array.weight_words(ConvSpec(512, 64 * tiles, 8, 8, 1, 1, 0)) // 64 for tiles in range(1, 9)
    }
    assert words == {1: 1, 2: 2, 3: 1, 4: 2, 5: 3, 6: 2, 7: 3, 8: 4}


@pytest.mark.parametrize("c_in", [300, 520, 1024])
def test_passes_in_threes_fit_in_pairs_where_they_can(c_in):
    array = ArrayConfig(weight_depth=260, max_c_out=1024)
    for c_out in range(1, 5000, 61):
        layer = ConvSpec(c_in, c_out, 4, 4, 1, 1, 0)
        passes = layer_passes(layer, array)
        assert [channel for part in passes for channel in part.c_out] == list(range(c_out))
        specs = [part.layer for part in passes]
        for spec in specs:
            array.check_admits(spec)
        for one, other in pairwise(specs):
            if c_in < 1024:
                assert array.weight_words(one) + array.weight_words(other) <= array.weight_depth
                assert array.requant_words(one) + array.requant_words(other) <= array.requant_depth


def test_border_terms_hold_half_the_range_times_all_outer_taps():
    assert str(ArrayConfig().border) == "s17"  # 4 * 3 * 1024 * -4 = -49152
    assert ArrayConfig(input=IntFormat(3, signed=True)).border is None
