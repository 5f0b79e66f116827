from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from macram.pose import LevelCells, decode, level_quota, select_candidates

ANCHORS = (32, 64, 128, 256, 512)


# Worked out by hand from floor(10 w_k / sum w + 0.5), w_k = exp(-log2(S / s_k)^2).
@pytest.mark.parametrize(
    ("size", "quota"),
    [
        (25, [8, 2, 0, 0, 0]),
        (32, [7, 3, 0, 0, 0]),
        (45, [5, 5, 1, 0, 0]),
        (64, [2, 6, 2, 0, 0]),
        (90, [1, 4, 4, 1, 0]),
        (128, [0, 2, 6, 2, 0]),
        (181, [0, 1, 4, 4, 1]),
        (256, [0, 0, 2, 6, 2]),
        (300, [0, 0, 1, 5, 3]),
        (512, [0, 0, 0, 3, 7]),
    ],
)
def test_quota_table(size, quota):
    assert level_quota(size, ANCHORS).tolist() == quota


def test_quota_of_many_sizes_at_once():
    sizes = np.array([[25.0, 90.0], [300.0, 512.0]])
    batched = level_quota(sizes, ANCHORS)
    assert batched.shape == (2, 2, 5)
    for index in np.ndindex(2, 2):
        assert np.array_equal(batched[index], level_quota(sizes[index], ANCHORS))


@settings(deadline=None, max_examples=100)
@given(st.floats(1e-30, 1e30))
def test_quota_always_sums_to_about_ten(size):
    quota = level_quota(size, ANCHORS)
    assert (quota >= 0).all()
    assert 9 <= quota.sum() <= 11


@pytest.mark.parametrize("size", [0.0, -1.0, np.nan, np.inf])
def test_quota_needs_a_size(size):
    with pytest.raises(ValueError, match="above 0 px"):
        level_quota(size, ANCHORS)


def test_decode_in_closed_form():
    # Two keypoints on a map of 2 rows and 3 columns, stride 8, anchor 32.
    offsets = np.zeros((4, 2, 3))
    offsets[0, 1, 2], offsets[1, 1, 2] = 0.5, -1.0  # x of keypoints 0 and 1
    offsets[2, 1, 2], offsets[3, 1, 2] = 0.25, 2.0  # y
    logits = np.full((1, 2, 3), -1000.0)
    logits[0, 1, 2] = 0.0
    level = decode(logits, offsets, 8, 32)
    assert level.probability.tolist() == [0.0] * 5 + [0.5]
    # Cell (row 1, column 2) has its centre at (20, 12).
    assert level.points[5].tolist() == [[36.0, 20.0], [-12.0, 76.0]]
    assert level.points[1].tolist() == [[12.0, 4.0], [12.0, 4.0]]


def test_decoded_probability_is_the_sigmoid():
    x = np.linspace(-20, 20, 12).reshape(3, 4)
    np.testing.assert_allclose(
        decode(x, np.zeros((2, 3, 4)), 8, 32).probability, (1 / (1 + np.exp(-x))).ravel(), rtol=1e-7
    )
    with pytest.raises(ValueError, match="do not fit"):
        decode(x, np.zeros((2, 4, 4)), 8, 32)
    with pytest.raises(ValueError, match="do not fit"):
        decode(x, np.zeros((3, 3, 4)), 8, 32)


def level(probabilities, side=60.0):
    """Cells whose two keypoints span ``side`` px; the first coordinate tells the cells apart."""
    count = len(probabilities)
    points = np.zeros((count, 2, 2))
    points[:, 0, 0] = np.arange(count)
    points[:, 1] = points[:, 0] + [[side, side / 2]]
    return LevelCells(np.array(probabilities, np.float64), points)


EMPTY = level([0.1, 0.2])


def test_every_level_gives_its_best_cells():
    rng = np.random.default_rng(0)
    fine, coarse = rng.uniform(0.31, 0.8, 50), rng.uniform(0.31, 0.8, 50)
    coarse[30] = 0.9
    chosen = select_candidates([level(fine), level(coarse, 64)], (32, 64))
    assert chosen.size == 64
    assert chosen.quota.tolist() == [3, 7]
    expected = [*np.argsort(-fine)[:3], *np.argsort(-coarse)[:7]]
    assert chosen.cell.tolist() == expected
    assert chosen.level.tolist() == [0] * 3 + [1] * 7
    np.testing.assert_allclose(chosen.confidence**2, [*fine[expected[:3]], *coarse[expected[3:]]])
    assert chosen.points[3, 0, 0] == 30


def test_a_short_level_gives_what_it_has():
    chosen = select_candidates([level([0.9, 0.3, 0.31]), EMPTY], (60, 120))
    # 0.3 itself is not above the threshold.
    assert chosen.cell.tolist() == [0, 2]


def test_ties_go_to_the_first_cell():
    chosen = select_candidates([level([0.5] * 30)], (60,))
    assert chosen.cell.tolist() == list(range(10))


def test_size_comes_from_the_most_confident_cell():
    small, large = level([0.9], 40), level([0.6], 300)
    for levels in ([small, large], [large, small]):
        assert select_candidates(levels, (32, 256)).size == 40
    # While the levels are scanned the published size never shrinks: order matters.
    assert select_candidates([large, small], (32, 256), published=True).size == 300
    assert select_candidates([small, large], (32, 256), published=True).size == 40


def test_other_levels_stand_in_where_the_quota_finds_nothing():
    # An object of 600 px seen by the finest level only: its quota is 0.
    levels = [level([0.5, 0.7, 0.6, *[0.4] * 20], 600.0), *[EMPTY] * 4]
    assert level_quota(600, ANCHORS)[0] == 0
    chosen = select_candidates(levels, ANCHORS)
    assert len(chosen.cell) == 10
    assert chosen.cell[:3].tolist() == [1, 2, 0]
    assert select_candidates(levels, ANCHORS, published=True) is None


def test_nothing_to_choose():
    assert select_candidates([EMPTY, EMPTY], (32, 64)) is None
    assert select_candidates([level([0.9], 0.0)], (32,)) is None
    broken = level([0.9, 0.5])
    broken.points[0, 1, 1] = np.nan
    assert select_candidates([broken], (60,)).cell.tolist() == [1]
    with pytest.raises(ValueError, match="2 levels need"):
        select_candidates([EMPTY, EMPTY], (32,))
    with pytest.raises(ValueError, match="a level needs"):
        LevelCells(np.zeros(3), np.zeros((4, 8, 2)))


def test_pairs_repeat_the_model():
    chosen = select_candidates([level([0.9, 0.8, 0.7])], (60,))
    model = np.array([[1.0, 2, 3], [4, 5, 6]])
    points, pixels = chosen.pairs(model)
    assert points.shape == (6, 3)
    assert pixels.shape == (6, 2)
    for cell in range(3):
        assert np.array_equal(points[2 * cell : 2 * cell + 2], model)
        assert np.array_equal(pixels[2 * cell : 2 * cell + 2], chosen.points[cell])
