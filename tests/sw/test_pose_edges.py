"""Edges of a painted box bring a wrong pose back; what shows none leaves it alone."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from macram.pose import EdgeSettings, Pose, box_corners, project, re, refine_on_edges
from macram.pose.edges import _search, visible_edges
from macram.pose.robust import moved, projected, robust_pose

K = np.array([[300.0, 0.0, 128.0], [0.0, 290.0, 120.0], [0.0, 0.0, 1.0]])
BOX = box_corners((-50, -50, -54.4), (50, 50, 54.4))
SIDES = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]]
FINE = 8


def turned(vector):
    return np.asarray(cv2.Rodrigues(np.array(vector, np.float64))[0])


TRUE = Pose(turned([0.5, -0.6, 0.3]), np.array([15.0, -10.0, 700.0]))
FACING = Pose(np.eye(3), np.array([0.0, 0.0, 250.0]))


def painted(pose, box=BOX, size=(256, 256)):
    """The box with a grey level of its own on each side, smoothed as a lens would; linear light to bytes."""
    picture = np.full((size[1] * FINE, size[0] * FINE), 0.02, np.float32)
    depth = (box @ pose.R.T + pose.t[:, 0])[:, 2]
    pixels = project(K, pose.R, pose.t, box) * FINE - 0.5
    for n in sorted(range(6), key=lambda n: -depth[SIDES[n]].mean()):
        cv2.fillPoly(picture, [np.rint(pixels[SIDES[n]]).astype(np.int32)], 0.15 + 0.12 * n)
    small = cv2.resize(picture, size, interpolation=cv2.INTER_AREA)
    grey = np.rint(255 * small ** (1 / 2.2)).astype(np.uint8)
    return np.repeat(grey[..., None], 3, axis=2)


def off(share=1.04, vector=(0.03, -0.04, 0.05)):
    return Pose(turned(vector) @ TRUE.R, TRUE.t * share)


def depth_error(pose):
    return abs(pose.t[2, 0] / TRUE.t[2, 0] - 1)


def test_edges_bring_a_pose_back():
    found = refine_on_edges(painted(TRUE), off(), K, BOX)
    assert depth_error(off()) == pytest.approx(0.04)
    assert depth_error(found) < 0.004
    assert re(off().R, TRUE.R) > 3.5
    assert re(found.R, TRUE.R) < 0.7
    assert np.abs(found.R @ found.R.T - np.eye(3)).max() < 1e-9


def test_a_smaller_box_of_edges_is_farther_away_without_saying_so():
    picture = painted(TRUE, 0.95 * BOX)
    assert refine_on_edges(picture, off(), K, BOX).t[2, 0] > 1.03 * TRUE.t[2, 0]
    assert depth_error(refine_on_edges(picture, off(), K, BOX, EdgeSettings(box=0.95))) < 0.006


def test_the_outline_is_preferred_to_stronger_steps_inside():
    """A bright panel on the nearest side, whose rim is a stronger step than the side's own, a little inside."""
    panel = painted(FACING) // 2
    corners = project(K, FACING.R, FACING.t, 0.92 * BOX[SIDES[4]] + 0.08 * BOX[SIDES[4]].mean(axis=0))
    cv2.fillConvexPoly(panel, np.rint(corners).astype(np.int32), (140, 140, 140))
    start = Pose(FACING.R, 1.03 * FACING.t)
    depths = [
        refine_on_edges(panel, start, K, BOX, EdgeSettings(nearer=1.0, outward=outward)).t[2, 0]
        for outward in (0.0, EdgeSettings().outward)
    ]
    assert depths[0] > 1.05 * FACING.t[2, 0]
    assert depths[1] == pytest.approx(FACING.t[2, 0], rel=0.004)


def test_steps_of_the_outline_alone_are_preferred_farther_out():
    """In noise there is a step at every place."""
    noise = np.random.default_rng(1).uniform(0, 255, (256, 256, 3)).astype(np.float32)
    R, t, settings = TRUE.R, TRUE.t[:, 0], EdgeSettings()
    plain, pushed = (_search((noise, noise), K, R, t, BOX, 8.0, o, settings) for o in (0.0, 2.0))
    outline = np.repeat(list(visible_edges(R, t, BOX).values()), settings.points)
    assert np.array_equal(plain.place[~outline], pushed.place[~outline])
    moved_by = (pushed.place - plain.place)[outline][:, None] * plain.normals[outline]
    away = (project(K, TRUE.R, TRUE.t, plain.points) - project(K, TRUE.R, TRUE.t, BOX).mean(axis=0))[outline]
    outwards = (moved_by * away).sum(axis=1)
    assert (outwards >= 0).all()
    assert (outwards > 0).mean() > 0.5


def test_the_last_round_prefers_nothing():
    picture, settings = painted(TRUE), [EdgeSettings(reach=(0.03,), outward=o) for o in (0.0, 2.0)]
    one, other = (refine_on_edges(picture, off(1.01), K, BOX, s) for s in settings)
    assert np.array_equal(one.t, other.t)


def test_without_edges_the_pose_stays():
    start = off()
    found = refine_on_edges(np.full((256, 256, 3), 90, np.uint8), start, K, BOX, EdgeSettings(nearer=1.0))
    assert np.allclose(found.t, start.t)
    assert np.allclose(found.R, start.R)


@pytest.mark.parametrize("t", [[0.0, 0.0, 40.0], [0.0, 0.0, 9000.0]])
def test_too_near_and_too_far_are_left_alone(t):
    start = Pose(np.eye(3), np.array(t))
    assert refine_on_edges(painted(TRUE), start, K, BOX) is start


def test_a_pose_right_before_the_camera_is_left_alone():
    """Its target would be some 60,000 px wide, and the search across it wider than a picture may be."""
    start = Pose(np.eye(3), np.array([0.0, 0.0, 56.5 / 0.97]))
    long = np.diag([10.0, 10.0, 1.0]) @ K
    assert refine_on_edges(painted(TRUE), start, long, BOX) is start


def test_visible_edges_by_how_many_sides_face_the_camera():
    far = np.array([0.0, 0.0, 5000.0])
    assert len(visible_edges(np.eye(3), far, BOX)) == 4
    assert len(visible_edges(turned([0.6, 0, 0]), far, BOX)) == 7
    nine = visible_edges(TRUE.R, TRUE.t[:, 0], BOX)
    assert list(nine.values()).count(True) == 6
    nearest = int(np.argmin((BOX @ TRUE.R.T)[:, 2]))
    assert {edge for edge, outline in nine.items() if not outline} == {e for e in nine if nearest in e}
    hidden = int(np.argmax((BOX @ TRUE.R.T)[:, 2]))
    assert len(nine) == 9
    assert not any(hidden in edge for edge in nine)


@pytest.mark.parametrize(
    ("values", "name"),
    [
        ({"box": 0.0}, "box"),
        ({"nearer": float("nan")}, "nearer"),
        ({"reach": ()}, "reach"),
        ({"outward": -0.1}, "outward"),
    ],
)
def test_settings_out_of_range(values, name):
    with pytest.raises(ValueError, match=name):
        EdgeSettings(**values)


def test_edges_need_a_box():
    with pytest.raises(ValueError, match="box"):
        refine_on_edges(painted(TRUE), off(), K, BOX[:7])


# ---- least squares ------------------------------------------------------------------------------------


def test_derivatives_are_differences():
    R, t, step = TRUE.R, TRUE.t[:, 0], 1e-6
    pixels, by_pose = projected(K, R, t, BOX)
    assert np.allclose(pixels, project(K, R, t[:, None], BOX))
    for axis in range(6):
        move = step * np.eye(6)[axis]
        change = (projected(K, *moved(R, t, move), BOX)[0] - projected(K, *moved(R, t, -move), BOX)[0]) / (
            2 * step
        )
        assert np.allclose(by_pose[..., axis], change, rtol=1e-4, atol=1e-5)


def test_outliers_do_not_drag():
    rng = np.random.default_rng(3)
    model = np.tile(BOX, (10, 1))
    pixels = project(K, TRUE.R, TRUE.t, model)
    pixels[:16] += rng.normal(0, 30, (16, 2))
    found = robust_pose(model, pixels, np.ones(80), K, off(), 1.0)
    assert depth_error(found) < 1e-3
    # Without weight they do not count at all.
    pixels[:40] += 25
    weights = np.repeat([0.0, 1.0], 40)
    assert depth_error(robust_pose(model, pixels, weights, K, off(), 1.0)) < 1e-6


def test_a_start_behind_the_camera_stays():
    start = Pose(np.eye(3), np.array([0.0, 0.0, -500.0]))
    assert robust_pose(BOX, np.zeros((8, 2)), np.ones(8), K, start, 1.0) is start
