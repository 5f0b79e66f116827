"""Second looks: crops show the target where they say, and what is seen in them has its place in the picture."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from macram.pose import LevelCells, LookSettings, Pose, PoseSettings, box_corners, detect_again, project
from macram.pose.looks import look_closer

K = np.array([[300.0, 0.0, 128.0], [0.0, 300.0, 128.0], [0.0, 0.0, 1.0]])
BOX = box_corners((-50, -50, -54.4), (50, 50, 54.4))
TRUE = Pose(np.asarray(cv2.Rodrigues(np.array([0.4, -0.7, 0.2]))[0]), np.array([60.0, -40.0, 900.0]))
ANCHORS = (32, 64)
EMPTY = LevelCells(np.zeros(1), np.zeros((1, 8, 2)))


def dotted(pixels, size=256):
    """A black picture with a soft white dot at each of the pixels."""
    y, x = np.mgrid[:size, :size] + 0.5
    light = sum(np.exp(-((x - u) ** 2 + (y - v) ** 2) / 2) for u, v in pixels)
    return np.repeat(np.rint(255 * np.clip(light, 0, 1)).astype(np.uint8)[..., None], 3, axis=2)


def cells(points, noise=0.0, seed=0, count=6):
    rng = np.random.default_rng(seed)
    several = (
        points + rng.normal(0, noise, (count, *points.shape)) if noise else np.repeat(points[None], count, 0)
    )
    return [LevelCells(np.full(count, 0.8), several), EMPTY]


@pytest.mark.parametrize("size", [24, 56])
def test_crops_show_the_target_where_they_say(size):
    pixels = project(K, TRUE.R, TRUE.t, BOX)
    one = pixels[3]
    views = look_closer(dotted([one]), TRUE, K, BOX, LookSettings(turns=5, size=size))
    assert len(views) == 5
    for view in views:
        assert view.image.shape == (128, 128, 3)
        there = np.linalg.inv(view.matrix) @ [*one, 1]
        y, x = np.mgrid[:128, :128] + 0.5
        weight = view.image[..., 0] * (np.hypot(x - there[0], y - there[1]) < 8.0)
        seen = np.array([(weight * x).sum(), (weight * y).sum(), weight.sum()])
        back = view.matrix @ (seen / weight.sum())
        assert np.abs(back[:2] - one).max() < 0.1
        middle = view.matrix @ [64, 64, 1]
        assert np.allclose(middle[:2], project(K, TRUE.R, TRUE.t, np.zeros((1, 3)))[0])
        extent = float(np.ptp(pixels, axis=0).max())
        assert np.linalg.norm(view.matrix[:2, 0]) == pytest.approx(extent / size)


@pytest.mark.parametrize(("turns", "within"), [(1, 0.035), (4, 0.015)])
def test_cells_of_all_views_vote_together(turns, within):
    """Each view errs in its own way; together they err less than the first alone."""
    pixels = project(K, TRUE.R, TRUE.t, BOX)
    wrong = pixels.mean(axis=0) + 0.95 * (pixels - pixels.mean(axis=0))
    asked = []

    def see(images):
        asked.append([image.shape for image in images])
        views = look_closer(images_of, first, K, BOX, settings.looks)
        inverse = [np.linalg.inv(view.matrix) for view in views]
        return [cells(pixels @ m[:2, :2].T + m[:2, 2]) for m in inverse]

    images_of = np.zeros((256, 256, 3), np.uint8)
    settings = PoseSettings(looks=LookSettings(turns=turns))
    alone = detect_again(images_of, cells(wrong), ANCHORS, BOX, K, see, PoseSettings())
    assert not asked
    first = alone.pose
    found = detect_again(images_of, cells(wrong), ANCHORS, BOX, K, see, settings)
    assert asked == [[(128, 128, 3)] * turns]
    assert alone.pose.t[2, 0] > 1.04 * TRUE.t[2, 0]
    assert found.pose.t[2, 0] == pytest.approx(TRUE.t[2, 0], rel=within)
    origins = [project(K, pose.R, pose.t, np.zeros((1, 3))) for pose in (found.pose, TRUE)]
    assert np.abs(origins[0] - origins[1]).max() < 0.2
    assert found.cells == alone.cells + 3 * turns
    assert found.pairs == 8 * found.cells
    assert 0 < found.inliers <= found.pairs


def test_views_that_see_nothing_change_little():
    pixels = project(K, TRUE.R, TRUE.t, BOX)
    nothing = [EMPTY, EMPTY]
    found = detect_again(
        np.zeros((256, 256, 3), np.uint8), cells(pixels), ANCHORS, BOX, K,
        lambda images: [nothing] * len(images), PoseSettings(looks=LookSettings()),
    )  # fmt: skip
    assert np.abs(found.pose.t - TRUE.t).max() < 0.1


def test_nothing_found_is_not_looked_at_again():
    def see(images):
        raise AssertionError

    looks = PoseSettings(looks=LookSettings())
    image = np.zeros((256, 256, 3), np.uint8)
    assert detect_again(image, [EMPTY, EMPTY], ANCHORS, BOX, K, see, looks) is None


@pytest.mark.parametrize("t", [[0.0, 0.0, -900.0], [0.0, 0.0, 1e5]])
def test_no_crops_of_what_is_behind_or_too_small(t):
    pose = Pose(np.eye(3), np.array(t))
    assert look_closer(np.zeros((64, 64, 3), np.uint8), pose, K, BOX, LookSettings()) == []


@pytest.mark.parametrize("values", [{"turns": 0}, {"side": 100}, {"size": 128}])
def test_settings_out_of_range(values):
    with pytest.raises(ValueError, match="looks"):
        LookSettings(**values)


def test_words_name_the_solver():
    assert PoseSettings().words == "EPnP RANSAC and Levenberg-Marquardt"
    assert (
        PoseSettings(looks=LookSettings(turns=3)).words == "EPnP RANSAC, Levenberg-Marquardt, 3 second looks"
    )
