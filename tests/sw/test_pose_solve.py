from __future__ import annotations

import cv2
import numpy as np
import pytest

from macram.pose import (
    LevelCells,
    Pose,
    PoseSettings,
    RansacSettings,
    add,
    box_corners,
    detect,
    epnp,
    project,
    solve_pnp,
)
from macram.pose import pnp as pnp_module

K = np.array([[303.787, 0.0, 256.0], [0.0, 303.787, 256.0], [0.0, 0.0, 1.0]])
BOX = box_corners((-50, -50, -54.4), (50, 50, 54.4))
D = 178.43


def random_pose(rng, near=1.2, far=10.0):
    z = rng.uniform(near, far) * D
    rotation = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    rotation *= np.sign(np.linalg.det(rotation))
    return Pose(rotation, [rng.uniform(-0.3, 0.3) * z, rng.uniform(-0.3, 0.3) * z, z])


def pairs(rng, pose, *, cells=10, sigma=0.0, outliers=0.0):
    """Cells times corners with half-correlated noise, some thrown anywhere."""
    pixels = project(K, pose.R, pose.t, BOX)
    noise = (rng.normal(size=(1, 8, 2)) + rng.normal(size=(cells, 8, 2))) * sigma / np.sqrt(2)
    seen = (pixels + noise).reshape(-1, 2)
    wrong = rng.random(len(seen)) < outliers
    seen[wrong] = rng.uniform(0, 512, (int(wrong.sum()), 2))
    return np.tile(BOX, (cells, 1)), seen, wrong


def error_d(pose, truth):
    return float(add(pose.R, pose.t, truth.R, truth.t, BOX)) / D


@pytest.mark.parametrize("refine", [False, True])
def test_clean_pairs_give_the_pose_back(refine):
    rng = np.random.default_rng(0)
    for _ in range(20):
        truth = random_pose(rng)
        result = solve_pnp(*pairs(rng, truth)[:2], K, RansacSettings(refine=refine))
        assert error_d(result.pose, truth) < 1e-4
        assert result.inliers.all()
        assert result.rms_px < 1e-3


def test_gross_outliers_are_named_and_do_no_harm():
    rng = np.random.default_rng(1)
    for _ in range(20):
        truth = random_pose(rng, 1.2, 4.0)
        model, seen, wrong = pairs(rng, truth, sigma=0.3, outliers=0.2)
        result = solve_pnp(model, seen, K)
        assert error_d(result.pose, truth) < 0.05
        far = np.linalg.norm(seen - project(K, truth.R, truth.t, model), axis=1) > 10
        assert not result.inliers[far].any()
        assert result.inliers[~wrong].all()


def accuracy(sigma, outliers, *, refine, count=150):
    rng = np.random.default_rng(7)
    shares, depths = [], []
    for _ in range(count):
        truth = random_pose(rng)
        result = solve_pnp(
            *pairs(rng, truth, sigma=sigma, outliers=outliers)[:2], K, RansacSettings(refine=refine)
        )
        shares.append(error_d(result.pose, truth))
        depths.append(truth.t[2, 0] / D)
    shares, depths = np.array(shares), np.array(depths)
    near = 100 * (shares[depths < 4] < 0.1).mean()
    return near, 100 * (shares < 0.1).mean(), np.median(shares)


def test_accuracy_is_that_of_ransac_and_refinement_helps():
    near, total, median = accuracy(1.0, 0.1, refine=False)
    near_lm, total_lm, median_lm = accuracy(1.0, 0.1, refine=True)
    # Ten cells with 1 px of noise and a tenth of outliers: near frames succeed, far ones to about two fifths.
    assert near >= 97
    assert near_lm >= 97
    assert 60 < total < 90
    assert total_lm >= total
    assert median_lm < median


def test_same_input_same_pose():
    rng = np.random.default_rng(3)
    model, seen, _ = pairs(rng, random_pose(rng), sigma=2.0, outliers=0.3)
    first = solve_pnp(model, seen, K)
    cv2.setRNGSeed(99)
    cv2.randu(np.zeros(100), 0, 1)
    second = solve_pnp(model, seen, K)
    assert np.array_equal(first.pose.R, second.pose.R)
    assert np.array_equal(first.pose.t, second.pose.t)
    assert np.array_equal(first.inliers, second.inliers)


@pytest.mark.parametrize("count", [0, 1, 3])
def test_too_few_pairs_have_no_pose(count):
    assert solve_pnp(BOX[:count].reshape(-1, 3), np.zeros((count, 2)), K) is None
    assert epnp(BOX[:count].reshape(-1, 3), np.zeros((count, 2)), K) is None


def test_degenerate_pairs_have_no_pose_and_raise_nothing():
    rng = np.random.default_rng(4)
    pixels = rng.uniform(0, 512, (20, 2))
    same = np.repeat(BOX[:1], 20, axis=0)
    three = np.tile(BOX[:3], (7, 1))[:20]
    for model in (same, three):
        assert solve_pnp(model, pixels, K) is None
        assert epnp(model, pixels, K) is None
    # Points on one line, and all pixels equal: whatever OpenCV makes of it, no exception and no NaN.
    line = np.arange(20)[:, None] * np.ones(3)
    for model, seen in ((line, pixels), (np.tile(BOX, (3, 1))[:20], np.full((20, 2), 256.0))):
        result = solve_pnp(model, seen, K)
        assert result is None or (np.isfinite(result.pose.t).all() and result.pose.t[2, 0] > 0)


def test_random_pixels_never_break_the_solver():
    rng = np.random.default_rng(5)
    for _ in range(40):
        count = int(rng.integers(4, 12))
        model = BOX[rng.integers(0, 8, count)]
        result = solve_pnp(model, rng.uniform(-1e4, 1e4, (count, 2)), K)
        if result is not None:
            depth = result.pose.R[2] @ model[result.inliers].T + result.pose.t[2]
            assert (depth > 0).all()


@pytest.mark.parametrize("count", [4, 5, 6])
def test_the_fewest_pairs_are_enough(count):
    truth = Pose(np.eye(3), [30, -20, 500])
    corners = BOX[[0, 3, 5, 6, 1, 2]][:count]
    result = solve_pnp(corners, project(K, truth.R, truth.t, corners), K)
    assert error_d(result.pose, truth) < 1e-2


def test_numbers_that_are_not_finite_are_outliers():
    rng = np.random.default_rng(6)
    truth = random_pose(rng, 2, 4)
    model, seen, _ = pairs(rng, truth)
    seen[[0, 17]] = [np.nan, 5.0], [3.0, np.inf]
    result = solve_pnp(model, seen, K)
    assert np.flatnonzero(~result.inliers).tolist() == [0, 17]
    assert error_d(result.pose, truth) < 1e-4
    assert epnp(model, seen, K) is None
    assert solve_pnp(model, np.full_like(seen, np.nan), K) is None


def test_an_exception_of_the_library_is_a_missing_pose(monkeypatch):
    def fail(*_, **__):
        raise cv2.error("refused")

    model, seen, _ = pairs(np.random.default_rng(8), Pose(np.eye(3), [0, 0, 500]))
    monkeypatch.setattr(pnp_module.cv2, "solvePnPRefineLM", fail)
    assert solve_pnp(model, seen, K).inliers.all()
    monkeypatch.setattr(pnp_module.cv2, "solvePnPRansac", fail)
    assert solve_pnp(model, seen, K) is None
    monkeypatch.setattr(pnp_module.cv2, "solvePnP", fail)
    assert epnp(model, seen, K) is None


def test_a_worse_refinement_is_thrown_away(monkeypatch):
    rng = np.random.default_rng(9)
    model, seen, _ = pairs(rng, random_pose(rng, 2, 4), sigma=0.5)
    plain = solve_pnp(model, seen, K, RansacSettings(refine=False))

    def worse(_points, _image, _matrix, _distortion, rvec, tvec):
        return rvec, tvec + 5.0

    monkeypatch.setattr(pnp_module.cv2, "solvePnPRefineLM", worse)
    assert np.array_equal(solve_pnp(model, seen, K).pose.t, plain.pose.t)


def test_wrong_shapes_and_settings_are_errors():
    with pytest.raises(ValueError, match=r"\[n, 3\]"):
        solve_pnp(BOX, np.zeros((7, 2)), K)
    with pytest.raises(ValueError, match="camera matrix"):
        solve_pnp(BOX, np.zeros((8, 2)), np.zeros((3, 3)))
    with pytest.raises(ValueError, match="threshold 0 px"):
        RansacSettings(threshold_px=0)
    with pytest.raises(ValueError, match="0 iterations"):
        RansacSettings(iterations=0)


# ---- the whole way from cells to a pose -------------------------------------------------------------


def outputs(pose, *, cells=40, sigma=0.2, seed=0):
    """Three levels of which all cells see the object; the probabilities differ."""
    rng = np.random.default_rng(seed)
    pixels = project(K, pose.R, pose.t, BOX)
    return [
        LevelCells(rng.uniform(0.35, 0.95, cells), pixels + rng.normal(size=(cells, 8, 2)) * sigma)
        for _ in range(3)
    ]


def test_detection_of_a_clear_object():
    truth = random_pose(np.random.default_rng(12), 2.0, 3.0)
    levels = outputs(truth)
    found = detect(levels, (32, 64, 128), BOX, K)
    assert error_d(found.pose, truth) < 0.02
    assert 9 <= found.cells <= 11
    assert found.pairs == 8 * found.cells
    assert 0.9 * found.pairs <= found.inliers <= found.pairs
    best = max(level.probability.max() for level in levels)
    assert found.score <= np.sqrt(best)
    table = found.to_dict()
    assert Pose(np.reshape(table["cam_R_m2c"], (3, 3)), table["cam_t_m2c"]).t.shape == (3, 1)
    assert table["inliers"] == found.inliers


def test_a_scaled_input_gives_the_same_pose():
    """A resize belongs into K: the pose needs no conversion to the original picture."""
    truth = random_pose(np.random.default_rng(13), 3.0, 4.0)
    levels = outputs(truth, sigma=0.0)
    half = [LevelCells(level.probability, level.points / 2) for level in levels]
    k_half = np.diag([0.5, 0.5, 1.0]) @ K
    found = detect(half, (16, 32, 64), BOX, k_half)
    assert error_d(found.pose, truth) < 1e-4


def test_nothing_confident_is_no_detection():
    levels = outputs(random_pose(np.random.default_rng(14)))
    assert detect(levels, (32, 64, 128), BOX, K, PoseSettings(confidence=0.99)) is None
    dead = [LevelCells(level.probability, np.full_like(level.points, 256.0)) for level in levels]
    assert detect(dead, (32, 64, 128), BOX, K) is None
    with pytest.raises(ValueError, match="predicts 8 keypoints"):
        detect(levels, (32, 64, 128), BOX[:7], K)
