from __future__ import annotations

import time

import numpy as np
import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st

from macram.golden import conv2d, random_case
from macram.golden.conv import sum_bound
from macram.spec import ConvSpec, IntFormat


def conv2d_naive(x, w, stride, padding):
    """The definition, one product at a time, in Python integers."""
    c_out, c_in, k, _ = w.shape
    _, height, width = x.shape
    rows, cols = (height + 2 * padding - k) // stride + 1, (width + 2 * padding - k) // stride + 1
    out = np.zeros((c_out, rows, cols), object)
    for o, y, z in np.ndindex(out.shape):
        for c, i, j in np.ndindex(c_in, k, k):
            row, col = y * stride + i - padding, z * stride + j - padding
            if 0 <= row < height and 0 <= col < width:
                out[o, y, z] += int(x[c, row, col]) * int(w[o, c, i, j])
    return out


@st.composite
def problems(draw, largest=7):
    k = draw(st.sampled_from([1, 3]))
    padding = draw(st.sampled_from([0, k // 2]))
    side = st.integers(max(1, k - 2 * padding), largest)
    c_in, c_out, height, width = draw(st.integers(1, 5)), draw(st.integers(1, 4)), draw(side), draw(side)
    weight = IntFormat(draw(st.integers(2, 8)), signed=True)
    act = IntFormat(draw(st.integers(1, 8)), signed=draw(st.booleans()))
    rng = np.random.default_rng(draw(st.integers(0, 2**32)))
    x = rng.integers(act.lo, act.hi, (c_in, height, width), endpoint=True)
    w = rng.integers(weight.lo, weight.hi, (c_out, c_in, k, k), endpoint=True)
    return x, w, draw(st.sampled_from([1, 2])), padding


@settings(deadline=None, max_examples=60)
@given(problems())
def test_equals_the_definition(problem):
    x, w, stride, padding = problem
    assert np.array_equal(conv2d(x, w, stride=stride, padding=padding), conv2d_naive(x, w, stride, padding))


@settings(deadline=None, max_examples=60)
@given(problems(largest=19))
def test_equals_torch_in_float64(problem):
    x, w, stride, padding = problem
    wanted = torch.nn.functional.conv2d(
        torch.from_numpy(x).double()[None], torch.from_numpy(w).double(), stride=stride, padding=padding
    )[0].numpy()
    assert np.array_equal(conv2d(x, w, stride=stride, padding=padding), wanted)


def test_reference_layer_equals_torch_and_is_fast():
    case = random_case(ConvSpec(64, 128, 128, 128), seed=11)
    start = time.perf_counter()
    acc = conv2d(case.input, case.weights)
    seconds = time.perf_counter() - start
    wanted = torch.nn.functional.conv2d(
        torch.tensor(case.input, dtype=torch.float64)[None],
        torch.tensor(case.weights, dtype=torch.float64),
        padding=1,
    )[0].numpy()
    assert acc.dtype == np.int32
    assert acc.shape == (128, 128, 128)
    assert np.array_equal(acc, wanted)
    assert seconds < 3


@pytest.mark.parametrize("kind", ["min", "max", "extremes", "zero"])
def test_extremes_reach_the_bound_and_no_further(kind):
    spec = ConvSpec(1024, 2, 3, 5)
    case = random_case(spec, 0, kind)
    acc = conv2d(case.input, case.weights)
    assert spec.accumulator.holds(acc)
    centre = {"min": 9216 * -4 * 7, "max": 9216 * 3 * 7, "zero": 0}
    if kind in centre:
        assert acc[0, 1, 1] == centre[kind]


def test_bands_do_not_show(monkeypatch):
    case = random_case(ConvSpec(3, 4, 11, 6, stride=2), seed=3)
    whole = conv2d(case.input, case.weights, stride=2)
    monkeypatch.setattr("macram.golden.conv.BAND_ELEMENTS", 1)
    assert np.array_equal(conv2d(case.input, case.weights, stride=2), whole)


@pytest.mark.parametrize("weight", [2**12 - 1, 2**12, 2**12 + 3, 2**20 + 1, 2**40 - 1])
def test_exact_on_both_sides_of_every_type_border(weight):
    x = np.array([[[4095, 1], [4095, 4093]]])
    w = np.zeros((2, 1, 3, 3), np.int64)
    w[0, 0, 1:, 1:] = [[weight, 1], [1, 0]]
    w[1, 0, 1, 1] = -weight
    assert np.array_equal(conv2d(x, w), conv2d_naive(x, w, 1, 1))


def test_sum_bound_covers_the_worst_signs():
    assert sum_bound(np.array([[[-8, 7]]]), np.array([[[[3]]], [[[-4]]]])) == 32
    assert sum_bound(np.array([[[1]]]), np.full((1, 9, 1, 1), 2**50)) == 9 * 2**50


@pytest.mark.parametrize(
    ("x", "w", "kwargs", "words"),
    [
        (np.zeros((1, 3, 3)), np.zeros((1, 1, 3, 3), int), {}, "input must hold integers, not float64"),
        (np.zeros((3, 3), int), np.zeros((1, 1, 3, 3), int), {}, r"input must have the shape .*\[3, 3\]"),
        (np.zeros((0, 3, 3), int), np.zeros((1, 0, 3, 3), int), {}, "input must have the shape"),
        (np.zeros((1, 3, 3), int), np.zeros((1, 1, 5, 5), int), {}, "kernel must be 1x1 or 3x3, not 5x5"),
        (np.zeros((1, 3, 3), int), np.zeros((1, 1, 3, 1), int), {}, "not 3x1"),
        (np.zeros((2, 3, 3), int), np.zeros((1, 1, 3, 3), int), {}, "take 1 input channels, the input has 2"),
        (
            np.zeros((1, 3, 3), int),
            np.zeros((1, 1, 3, 3), int),
            {"stride": 3},
            "stride must be 1 or 2, not 3",
        ),
        (np.zeros((1, 3, 3), int), np.zeros((1, 1, 3, 3), int), {"padding": 2}, "padding must be 0 or 1"),
        (np.zeros((1, 2, 3), int), np.zeros((1, 1, 3, 3), int), {"padding": 0}, "at least 3x3"),
        (np.ones((1, 1, 1), int), np.full((1, 1, 1, 1), 2**53), {"padding": 0}, r"below 2\*\*53"),
    ],
)
def test_bad_operands_are_refused(x, w, kwargs, words):
    with pytest.raises(ValueError, match=words):
        conv2d(x, w, **kwargs)
