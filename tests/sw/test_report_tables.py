from __future__ import annotations

import json
import stat

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from macram.report.bram import bram_report, memories, ramb36
from macram.report.comparison import compare
from macram.report.files import write_bytes, write_json, write_npz
from macram.report.latency import REFERENCE, latency_report
from macram.report.maps import codes_rgb, difference_rgb, histogram, lively_channels
from macram.report.versions import machine, versions
from macram.spec import ArrayConfig, ConvSpec, IntFormat

# ---- comparison -------------------------------------------------------------------------------------


def codes_of(shape, seed=0):
    return np.random.default_rng(seed).integers(0, 8, shape)


def test_equal_codes():
    result = compare(codes_of((3, 4, 5)), codes_of((3, 4, 5)))
    assert (result.compared, result.mismatches, result.first, result.equal) == (60, 0, None, True)
    assert str(result) == "60 output codes compared, 0 differ"


@settings(deadline=None, max_examples=60)
@given(st.data())
def test_every_planted_difference_is_counted_and_the_first_is_named(data):
    shape = tuple(data.draw(st.integers(1, 6)) for _ in range(3))
    expected = codes_of(shape, data.draw(st.integers(0, 99)))
    places = sorted(data.draw(st.sets(st.integers(0, expected.size - 1), min_size=1)))
    produced = expected.copy().astype(np.int8)
    produced.flat[places] ^= 4
    result = compare(expected, produced)
    channel, y, x = np.unravel_index(places[0], shape)
    assert not result.equal
    assert result.mismatches == len(places)
    assert result.first == {
        "channel": channel,
        "y": y,
        "x": x,
        "expected": expected[channel, y, x],
        "produced": produced[channel, y, x],
    }
    assert f"first at (channel {channel}, y {y}, x {x}): expected {expected[channel, y, x]}" in str(result)


def test_nothing_compared_is_not_equal():
    nothing = np.zeros((0, 3, 3), np.int64)
    assert not compare(nothing, nothing).equal


@pytest.mark.parametrize(
    ("expected", "produced", "message"),
    [
        (np.zeros((1, 2, 3), int), np.zeros((1, 3, 2), int), r"expected codes are \[1, 2, 3\], produced"),
        (np.zeros((2, 3), int), np.zeros((2, 3), int), r"not int64 \[2, 3\]"),
        (np.zeros((1, 2, 3), int), np.zeros((1, 2, 3)), r"produced codes must be integers .* not float64"),
    ],
)
def test_incomparable_arrays_are_refused(expected, produced, message):
    with pytest.raises(ValueError, match=message):
        compare(expected, produced)


# ---- files ------------------------------------------------------------------------------------------


def test_a_failed_write_leaves_the_old_file_and_no_other(tmp_path):
    path = tmp_path / "report.json"
    write_json(path, {"a": 1})
    with pytest.raises(ValueError, match="Out of range float"):
        write_json(path, {"a": float("nan")})
    with pytest.raises(TypeError):
        write_bytes(path, "text, not bytes")
    assert json.loads(path.read_text()) == {"a": 1}
    assert list(tmp_path.iterdir()) == [path]


def test_written_files_are_readable_by_others_and_round_trip(tmp_path):
    path = tmp_path / "output.npz"
    write_npz(path, codes=codes_of((2, 3, 4)))
    assert np.array_equal(np.load(path)["codes"], codes_of((2, 3, 4)))
    (tmp_path / "plain").write_text("")
    assert stat.S_IMODE(path.stat().st_mode) == stat.S_IMODE((tmp_path / "plain").stat().st_mode)


# ---- block RAM --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("depth", "width", "expected"),
    [
        (512, 72, 1), (512, 36, 0.5), (513, 72, 2), (1024, 36, 1), (1, 1, 0.5), (16384, 1, 0.5),
        (2048, 18, 1), (4096, 9, 1), (8192, 4, 1), (32768, 1, 1), (512, 73, 1.5), (256, 536, 7.5),
    ],
)  # fmt: skip
def test_ramb36_of_the_aspect_ratios(depth, width, expected):
    assert ramb36(depth, width) == expected


def test_parts_written_alone_take_whole_byte_lanes():
    assert ramb36(512, 40, grain=10) == 1  # four grains of two 9-bit lanes: 72 bits
    assert ramb36(512, 40) == 1
    assert ramb36(512, 36, grain=12) == 1  # 54 bits instead of 36
    assert ramb36(16384, 1, grain=1) == 0.5


@settings(deadline=None, max_examples=100)
@given(st.integers(1, 5000), st.integers(1, 600))
def test_ramb36_holds_the_bits_and_grows(depth, width):
    size = ramb36(depth, width)
    assert size * 36 * 1024 >= depth * width
    assert ramb36(depth + 1, width) >= size
    assert ramb36(depth, width + 1) >= size


def test_reference_array_has_64_weight_rams_and_uses_48_words_of_each():
    report = bram_report(ArrayConfig(), REFERENCE)
    weights = report["memories"][0]
    assert (weights["count"], weights["depth"], weights["width"], weights["ramb36"]) == (64, 1024, 72, 128)
    assert weights["used"] == 48  # 2 tiles x 3 kernel rows x 8 blocks
    assert report["ramb36_total"] == sum(row["ramb36"] for row in report["memories"])
    assert report["ramb36_total"] < report["device_ramb36"]


@pytest.mark.parametrize("spec", [REFERENCE, ConvSpec(1, 1, 1, 1), ConvSpec(1024, 64, 16, 16)])
def test_no_layer_uses_more_words_than_there_are(spec):
    ArrayConfig().check_admits(spec)
    for memory in memories(ArrayConfig(), spec):
        assert 0 < memory.used <= memory.depth


# ---- latency, codes, machine ------------------------------------------------------------------------


def test_latency_stands_beside_table_vi_for_its_layer_alone():
    report = latency_report(REFERENCE, 2.0)
    assert [row["ms"] for row in report["rows"]] == [26.16, 10.25, 5.99, 2.0]
    assert report["rows"][2]["speedup"] == pytest.approx(2.995)
    assert round(report["paper_ms_from_peak_rate"], 2) == 5.99
    assert latency_report(ConvSpec(64, 128, 128, 127), 2.0) is None


@pytest.mark.parametrize("fmt", [IntFormat(3), IntFormat(3, signed=True), IntFormat(8), IntFormat(2)])
def test_histogram_counts_every_level(fmt):
    codes = np.random.default_rng(1).integers(fmt.lo, fmt.hi, (3, 5, 7), endpoint=True)
    rows = histogram(codes, fmt)
    assert [row["code"] for row in rows] == list(range(fmt.lo, fmt.hi + 1))
    assert [row["count"] for row in rows] == [int((codes == row["code"]).sum()) for row in rows]
    assert sum(row["share"] for row in rows) == pytest.approx(1)


@pytest.mark.parametrize("fmt", [IntFormat(3), IntFormat(4, signed=True)])
def test_every_level_has_its_own_colour(fmt):
    levels = np.arange(fmt.lo, fmt.hi + 1)[None]
    assert len(np.unique(codes_rgb(levels, fmt)[0], axis=0)) == fmt.hi - fmt.lo + 1


def test_difference_picture_is_black_exactly_where_equal():
    fmt, expected = IntFormat(3), np.array([[0, 3, 7, 2]])
    picture = difference_rgb(np.array([[0, 4, 0, 2]]), expected, fmt)
    assert picture.any(axis=-1).tolist() == [[False, True, True, False]]
    assert picture[0, 1, 0] > picture[0, 1, 2]  # above: red
    assert picture[0, 2, 2] > picture[0, 2, 0]  # below: blue


def test_lively_channels_are_those_that_vary_most():
    maps = np.zeros((5, 4, 4), np.int64)
    maps[3, ::2], maps[1, 0, 0] = 7, 1
    assert lively_channels(maps, 2) == [1, 3]
    assert lively_channels(maps, 9) == [0, 1, 2, 3, 4]
    assert lively_channels(np.zeros((4, 2, 2), int), 2) == [0, 1]


def test_versions_and_machine_name_no_host():
    import platform  # noqa: PLC0415

    found = versions()
    assert {"macram", "python", "numpy"} <= set(found)
    assert machine()["cores"] >= 1
    if len(platform.node()) > 3:
        assert platform.node() not in json.dumps(machine())
