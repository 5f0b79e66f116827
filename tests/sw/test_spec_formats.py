from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from macram.spec import (
    ConvSpec,
    IntFormat,
    accumulator_format,
    accumulator_range,
    ceil_div,
    parse_format,
    signed_format_for,
)

FORMATS = st.builds(IntFormat, st.integers(1, 48), st.booleans())


@pytest.mark.parametrize(
    ("form", "lo", "hi"),
    [("s3", -4, 3), ("u3", 0, 7), ("s8", -128, 127), ("u8", 0, 255), ("s1", -1, 0), ("u48", 0, 2**48 - 1)],
)
def test_ranges_and_names(form, lo, hi):
    assert (parse_format(form).lo, parse_format(form).hi) == (lo, hi)
    assert str(parse_format(form)) == form


@given(FORMATS, st.data())
def test_fields_are_twos_complement_and_invertible(form, data):
    codes = np.array(data.draw(st.lists(st.integers(form.lo, form.hi), max_size=8)), np.int64)
    fields = form.to_field(codes)
    assert fields.tolist() == [code % (1 << form.bits) for code in codes.tolist()]
    assert np.array_equal(form.from_field(fields), codes)


@given(FORMATS)
def test_holds_its_range_and_nothing_else(form):
    assert form.holds(np.array([form.lo, form.hi]))
    assert form.holds(np.array([], np.int64))
    assert not form.holds(np.array([form.lo - 1]))
    assert not form.holds(np.array([0, form.hi + 1]))


@given(st.integers(-(2**40), 2**40), st.integers(-(2**40), 2**40))
def test_signed_format_is_the_narrowest(one, two):
    lo, hi = min(one, two), max(one, two)
    form = signed_format_for(lo, hi)
    assert form.signed
    assert form.lo <= lo
    assert hi <= form.hi
    if form.bits > 1:
        narrower = IntFormat(form.bits - 1, signed=True)
        assert not (narrower.lo <= lo and hi <= narrower.hi)


@given(st.integers(0, 10**9), st.integers(1, 10**6))
def test_ceil_div(numerator, denominator):
    assert (ceil_div(numerator, denominator) - 1) * denominator < numerator
    assert ceil_div(numerator, denominator) * denominator >= numerator


@given(st.integers(2, 4), st.integers(1, 4), st.booleans(), st.integers(1, 50))
def test_accumulator_range_is_reached_and_leaves_room_for_never(weight_bits, act_bits, signed, fan_in):
    weight, act = IntFormat(weight_bits, signed=True), IntFormat(act_bits, signed)
    products = np.multiply.outer(
        np.arange(weight.lo, weight.hi + 1), np.arange(act.lo, act.hi + 1)
    )  # every operand pair
    lo, hi = accumulator_range(weight, act, fan_in)
    assert (lo, hi) == (fan_in * products.min(), fan_in * products.max())
    form = accumulator_format(weight, act, fan_in)
    assert form.lo <= lo
    assert hi + 1 <= form.hi


def test_reference_layer_figures():
    spec = ConvSpec(64, 128, 128, 128)
    assert str(spec.accumulator) == "s15"
    assert spec.macs == 1_207_959_552
    assert (spec.out_height, spec.out_width, spec.fan_in) == (128, 128, 576)


@given(
    st.integers(1, 40), st.integers(1, 40), st.sampled_from([1, 3]), st.sampled_from([1, 2]), st.booleans()
)
def test_output_size_counts_the_window_positions(height, width, kernel, stride, padded):
    padding = kernel // 2 if padded else 0
    positions = [len(range(0, size + 2 * padding - kernel + 1, stride)) for size in (height, width)]
    if min(positions) == 0:
        with pytest.raises(ValueError, match="smaller than the"):
            ConvSpec(1, 1, height, width, kernel, stride, padding)
    else:
        spec = ConvSpec(1, 1, height, width, kernel, stride, padding)
        assert [spec.out_height, spec.out_width] == positions


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"c_in": 0}, "c_in must be at least 1, not 0"),
        ({"c_out": -1}, "c_out must be at least 1, not -1"),
        ({"height": 0}, "height must be at least 1, not 0"),
        ({"kernel": 5}, "kernel must be 1 or 3, not 5"),
        ({"stride": 0}, "stride must be 1 or 2, not 0"),
        ({"padding": 2}, "padding of a 3x3 kernel must be 0 or 1, not 2"),
        ({"kernel": 1, "padding": 1}, "padding of a 1x1 kernel must be 0, not 1"),
        ({"weight": IntFormat(3)}, "weights must be signed, not u3"),
        ({"height": 2, "padding": 0}, "a 2x8 input without padding is smaller than the 3x3 kernel"),
    ],
)
def test_bad_layers_are_refused(changes, words):
    with pytest.raises(ValueError, match=words):
        ConvSpec(**{"c_in": 1, "c_out": 1, "height": 8, "width": 8, **changes})


@pytest.mark.parametrize("bits", [0, -1, 49])
def test_bad_widths_are_refused(bits):
    with pytest.raises(ValueError, match=rf"bits must be in 1\.\.48, not {bits}"):
        IntFormat(bits)
    with pytest.raises(TypeError):
        IntFormat(3.0)


@pytest.mark.parametrize("text", ["3", "i3", "u", "u-3", "", "s3 ", None, 3])
def test_bad_format_names_are_refused(text):
    with pytest.raises(ValueError, match="a format is 'u' or 's' and a bit count"):
        parse_format(text)
