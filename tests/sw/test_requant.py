from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from macram.golden import ShiftRequant, ThresholdRequant, derive_requant, float_codes, random_case, run_layer
from macram.golden.formula import staircase
from macram.golden.requant import Distance, _closest
from macram.spec import ConvSpec, IntFormat, accumulator_range

FORMATS = [IntFormat(bits, signed=signed) for bits in range(2, 9) for signed in (False, True)]
FINITE = st.floats(allow_nan=False, allow_infinity=False)


def spec_of(channels, output, c_in=3, act=IntFormat(3)):  # noqa: B008
    return ConvSpec(c_in, channels, 4, 4, input=act, output=output)


def reachable(spec):
    lo, hi = accumulator_range(spec.weight, spec.input, spec.fan_in)
    return np.arange(lo, hi + 1)


def formula(acc, m, b, output):
    """The contract, one Python float at a time: round() is half to even."""
    value = float(m) * float(acc) + float(b)
    if math.isinf(value):
        return output.hi if value > 0 else output.lo
    return min(max(round(value), output.lo), output.hi)


def hard_parameters(reach, output):
    """Scales and offsets that have broken requantisers: ties, zero, tiny, huge, negative, off the range."""
    top = max(abs(reach[0]), reach[1])
    scales = [
        0.0, -0.0, 0.5, -0.5, 0.25, 1.0, -1.0, 1 / 3, 0.01, -0.013, 1.5, 7.0, 300.0, -1e6, 1e-9, -1e-9,
        1e-300, 5e-324, -5e-324, 1e300, -1e300, 1.7e308, 2.0**-17, (output.hi - output.lo) / top,
    ]  # fmt: skip
    offsets = [
        0.0, 0.5, -0.5, 1.5, 2.5, output.hi + 0.5, output.lo - 0.5, 3.49999999, 1e5, -1e5, 1e300,
        -1.7e308, -0.25,
    ]  # fmt: skip
    grid = np.array([(m, b) for m in scales for b in offsets])
    return grid[:, 0].copy(), grid[:, 1].copy()


@pytest.mark.parametrize("output", [f for f in FORMATS if f.bits <= 4], ids=str)
@pytest.mark.parametrize("act", [IntFormat(3), IntFormat(4, signed=True)], ids=str)
def test_thresholds_equal_the_formula_for_every_reachable_accumulator(output, act):
    probe = spec_of(1, output, act=act)
    acc = reachable(probe)
    scale, offset = hard_parameters((acc[0], acc[-1]), output)
    spec = spec_of(len(scale), output, act=act)
    requant = derive_requant(spec, scale, offset)
    assert isinstance(requant, ThresholdRequant)
    codes = requant.apply(np.broadcast_to(acc, (len(scale), len(acc))))
    wanted = [[formula(a, m, b, output) for a in acc] for m, b in zip(scale, offset, strict=True)]
    assert np.array_equal(codes, wanted)
    # What the hardware does: count, then invert.
    n = (acc[None, :, None] >= requant.thresholds[:, None, :]).sum(axis=2)
    ones = (1 << output.bits) - 1
    assert np.array_equal(output.lo + np.where(requant.invert[:, None], n ^ ones, n), wanted)
    # Every threshold fits the accumulator that the layer needs.
    assert spec.accumulator.holds(requant.thresholds)


@settings(deadline=None, max_examples=60)
@given(
    st.lists(
        st.tuples(
            FINITE | st.floats(-2, 2) | st.integers(-8, 8).map(lambda n: n / 4),
            FINITE | st.integers(-40, 40).map(lambda n: n / 4),
        ),
        min_size=1, max_size=6,
    ),
    st.sampled_from([f for f in FORMATS if f.bits <= 4]),
)  # fmt: skip
def test_thresholds_equal_the_formula_property(pairs, output):
    scale, offset = np.array(pairs).T
    spec = spec_of(len(pairs), output, c_in=2)
    acc = reachable(spec)
    codes = derive_requant(spec, scale, offset).apply(np.broadcast_to(acc, (len(pairs), len(acc))))
    assert np.array_equal(codes, [[formula(a, m, b, output) for a in acc] for m, b in pairs])


def test_reference_reach_is_covered_to_both_ends():
    spec = ConvSpec(64, 4, 8, 8)
    acc = reachable(spec)
    assert (acc[0], acc[-1]) == (-16128, 12096)
    scale = np.array([7 / 28224, -7 / 28224, 1e-4, 0.0])
    offset = np.array([4.0, 3.0, -1.1129, 3.5])
    requant = derive_requant(spec, scale, offset)
    codes = requant.apply(np.broadcast_to(acc, (4, len(acc))))
    wanted = np.clip(np.rint(scale[:, None] * acc + offset[:, None]), 0, 7)
    assert np.array_equal(codes, wanted)
    assert requant.invert.tolist() == [False, True, False, False]
    assert set(requant.thresholds[3]) == {-16128, 12097}
    assert codes[3, 0] == 4


def test_an_off_by_one_threshold_is_seen():
    spec = ConvSpec(2, 1, 4, 4)
    scale, offset = np.array([0.05]), np.array([3.0])
    right = derive_requant(spec, scale, offset)
    acc = reachable(spec)[None]
    moved = right.thresholds.copy()
    moved[0, 3] += 1
    wrong = ThresholdRequant(moved, right.invert, right.output, right.reach)
    assert (wrong.apply(acc) != right.apply(acc)).sum() == 1


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"output": IntFormat(5)}, "up to 4 output bits, not 5"),
        ({"thresholds": np.zeros((1, 3), np.int64)}, r"thresholds must be \[1, 7\], not \[1, 3\]"),
        ({"thresholds": np.arange(7, 0, -1)[None]}, "must ascend"),
        ({"thresholds": np.arange(7)[None] + 95}, r"must lie in -100\.\.100, not 95\.\.101"),
    ],
)
def test_impossible_thresholds_are_refused(change, words):
    parts = {
        "thresholds": np.arange(7)[None], "invert": np.array([False]), "output": IntFormat(3),
        "reach": (-100, 99),
    }  # fmt: skip
    ThresholdRequant(**parts)
    with pytest.raises(ValueError, match=words):
        ThresholdRequant(**{**parts, **change})


# ---- multiplier and shift -----------------------------------------------------------------------------


def shift_formula(acc, mult, offset, shift, output):
    return min(max((int(acc) * int(mult) + int(offset)) >> int(shift), output.lo), output.hi)


@pytest.mark.parametrize("output", [f for f in FORMATS if f.bits > 4], ids=str)
def test_shift_is_the_stated_integer_formula_and_near_the_float_one(output):
    probe = spec_of(1, output)
    acc = reachable(probe)
    scale, offset = hard_parameters((acc[0], acc[-1]), output)
    requant = derive_requant(spec_of(len(scale), output), scale, offset)
    assert isinstance(requant, ShiftRequant)
    codes = requant.apply(np.broadcast_to(acc, (len(scale), len(acc))))
    for c in range(0, len(scale), 7):
        fields = requant.mult[c], requant.offset[c], requant.shift[c]
        assert codes[c].tolist() == [shift_formula(a, *fields, output) for a in acc]
    wanted = np.array([[formula(a, m, b, output) for a in acc] for m, b in zip(scale, offset, strict=True)])
    gap = abs(codes - wanted)
    assert requant.distance(scale, offset) == Distance(wanted.size, int((gap > 0).sum()), int(gap.max()))
    # Only exact ties may differ: half to even needs more than one straight line.
    exact_tie = np.array([any((2 * (m * float(a) + b)) % 2 == 1 for a in acc) if abs(m) < 1e5 and abs(b) < 1e6
                          else False for m, b in zip(scale, offset, strict=True)])  # fmt: skip
    assert gap.max() <= 1
    assert not gap[~exact_tie].any()


@settings(deadline=None, max_examples=60)
@given(
    st.lists(
        st.tuples(
            FINITE | st.floats(-0.02, 0.02),
            FINITE | st.floats(-300, 300),
        ),
        min_size=1, max_size=5,
    ),
    st.sampled_from([f for f in FORMATS if f.bits > 4]),
    st.sampled_from([(IntFormat(3), 2), (IntFormat(8), 1024), (IntFormat(8, signed=True), 8192)]),
    st.integers(0, 2**32),
)  # fmt: skip
def test_shift_never_leaves_48_bits_and_is_close(pairs, output, form, seed):
    act, c_in = form
    scale, offset = np.array(pairs).T.copy()
    weight = IntFormat(3 if c_in == 2 else 8, signed=True)
    spec = ConvSpec(c_in, len(pairs), 4, 4, weight=weight, input=act, output=output)
    requant = derive_requant(spec, scale, offset)
    lo, hi = requant.reach
    assert abs(requant.mult).max() < 1 << 17
    assert requant.shift.min() >= 0
    assert requant.shift.max() <= 47
    for m, b in zip(requant.mult.tolist(), requant.offset.tolist(), strict=True):
        for acc in (lo, hi):
            assert -(1 << 47) <= acc * m < 1 << 47
            assert -(1 << 47) <= acc * m + b < 1 << 47
    rng = np.random.default_rng(seed)
    acc = rng.integers(lo, hi, (len(pairs), 50), endpoint=True)
    acc[:, :2] = lo, hi
    wanted = [[formula(a, m, b, output) for a in row] for row, (m, b) in zip(acc, pairs, strict=True)]
    gap = abs(requant.apply(acc) - wanted)
    assert gap.max() <= requant.distance(scale, offset).largest <= 1


@settings(deadline=None, max_examples=150)
@given(
    st.floats(-3, 3).filter(lambda m: abs(m) > 0.1),
    st.floats(-40, 40),
    st.integers(0, 5),
    st.integers(2, 20),
    st.booleans(),
)
def test_an_exact_offset_is_found_wherever_one_exists(slope, offset, shift, top, signed):
    """All multipliers in question and all offsets, tried one by one, at shifts too coarse for comfort."""
    output, reach = IntFormat(5, signed), (-top, top)
    acc = np.arange(-top, top + 1)
    wanted = np.array([formula(a, slope, offset, output) for a in acc])
    if wanted[0] == wanted[-1]:
        return
    one = np.array([slope])
    steps, falling = staircase(one, np.array([offset]), output, reach)
    mult, add = _closest(one, np.array([shift]), steps, falling, output, reach)
    nearest, sign = abs(round(slope * 2**shift)), -1 if slope < 0 else 1
    mults = {sign * max(nearest + step, 1) for step in (-1, 0, 1)}
    assert mult[0] in mults
    span = np.arange(-(1 << shift) * 140, (1 << shift) * 140)
    exists = any(
        (np.clip((acc * m + span[:, None]) >> shift, output.lo, output.hi) == wanted).all(axis=1).any()
        for m in mults
    )
    found = [shift_formula(a, mult[0], add[0], shift, output) for a in acc]
    assert np.array_equal(found, wanted) == exists


def test_distance_of_a_wrong_offset_is_counted_exactly():
    spec = ConvSpec(2, 2, 4, 4, output=IntFormat(8))
    scale, offset = np.array([math.pi / 10, -math.e / 7]), np.array([100.2, 90.0])  # no ties
    right = derive_requant(spec, scale, offset)
    assert right.distance(scale, offset).differing == 0
    wrong = ShiftRequant(
        right.mult, right.offset + (3 << right.shift), right.shift, right.output, right.reach
    )
    acc = np.broadcast_to(reachable(spec), (2, len(reachable(spec))))
    gap = abs(wrong.apply(acc) - right.apply(acc))
    assert wrong.distance(scale, offset) == Distance(acc.size, int((gap > 0).sum()), 3)
    assert wrong.distance(scale, offset).share == (gap > 0).mean() > 0.5


def test_constant_channels_need_no_multiplier():
    spec = ConvSpec(2, 5, 4, 4, output=IntFormat(8, signed=True))
    scale = np.array([0.0, 1e-30, 1.0, -1e300, 0.0])
    offset = np.array([3.7, -5.2, 1e9, 1.7e308, -1e308])
    requant = derive_requant(spec, scale, offset)
    assert requant.mult.tolist()[:3] == [0, 0, 0]
    assert requant.offset.tolist()[:3] == [4, -5, 127]
    assert requant.shift.tolist()[4] == 0
    assert requant.distance(scale, offset).differing == 0


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"mult": np.array([1 << 17])}, r"mult must fit s18, not 131072\.\.131072"),
        ({"offset": np.array([1 << 47])}, "offset must fit s48"),
        ({"shift": np.array([48])}, r"shift must be in 0\.\.47, not 48"),
        ({"shift": np.array([1, 2])}, "must be of one shape"),
        ({"reach": (-(1 << 31), 1 << 31)}, "must fit 48 bits"),
    ],
)
def test_impossible_shift_parameters_are_refused(change, words):
    parts = {
        "mult": np.array([131071]), "offset": np.array([0]), "shift": np.array([4]), "output": IntFormat(8),
        "reach": (-100, 100),
    }  # fmt: skip
    ShiftRequant(**parts)
    with pytest.raises(ValueError, match=words):
        ShiftRequant(**{**parts, **change})


# ---- the entry ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("output", FORMATS, ids=str)
def test_whole_layer_spreads_over_the_codes(output):
    case = random_case(ConvSpec(5, 12, 9, 7, output=output), seed=output.bits)
    codes = run_layer(case)
    assert codes.dtype == np.int64
    assert output.holds(codes)
    assert len(np.unique(codes)) > 0.6 * (1 << min(output.bits, 7))
    if output.bits <= 4:
        assert np.array_equal(codes, float_codes(case))
    else:
        assert abs(codes - float_codes(case)).max() <= 1
    assert (case.scale < 0).any()
    assert (case.scale == 0).any()


@pytest.mark.parametrize("bits", [3, 8])
@pytest.mark.parametrize(
    ("scale", "offset", "words"),
    [
        ([1.0, math.nan], [0.0, 0.0], "scale must be finite, not nan in channel 1"),
        ([1.0, 1.0], [math.inf, 0.0], "offset must be finite, not inf in channel 0"),
        ([1.0], [0.0, 0.0], r"scale must have the shape \[2\], not \[1\]"),
    ],
)
def test_bad_parameters_are_refused(bits, scale, offset, words):
    with pytest.raises(ValueError, match=words):
        derive_requant(spec_of(2, IntFormat(bits)), np.array(scale), np.array(offset))


def test_more_than_8_bits_are_refused():
    with pytest.raises(ValueError, match="output bits must be at most 8, not 9"):
        derive_requant(spec_of(1, IntFormat(9)), np.ones(1), np.ones(1))


@pytest.mark.parametrize("output", [IntFormat(3), IntFormat(8)], ids=str)
def test_accumulators_of_other_channels_are_refused(output):
    requant = derive_requant(spec_of(2, output), np.ones(2), np.ones(2))
    with pytest.raises(ValueError, match=r"acc must be \[2, \.\.\.\], not \[3, 4\]"):
        requant.apply(np.zeros((3, 4), np.int64))
