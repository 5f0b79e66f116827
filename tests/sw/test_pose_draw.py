from __future__ import annotations

import numpy as np
import pytest

from macram.data.geometry import BOX_EDGES
from macram.pose import Pose, box_corners, draw_pose, project
from macram.pose.draw import AXES, PREDICTED

K = np.array([[303.787, 0.0, 128.0], [0.0, 303.787, 128.0], [0.0, 0.0, 1.0]])
BOX = box_corners((-50, -50, -54.4), (50, 50, 54.4))
BLANK = np.zeros((256, 256, 3), np.uint8)
TILTED = Pose(
    np.linalg.qr(np.array([[1.0, 0.4, 0.3], [-0.3, 1.0, 0.5], [0.2, -0.6, 1.0]]))[0] @ np.diag([-1, -1, 1]),
    [10.0, -15.0, 450.0],
)


def test_every_edge_lies_where_the_pose_says():
    picture = draw_pose(BLANK, TILTED, K, BOX, axes=False)
    pixels = project(K, TILTED.R, TILTED.t, BOX) - 0.5
    for a, b in BOX_EDGES:
        for share in (0.25, 0.5, 0.75):
            x, y = np.rint(pixels[a] + share * (pixels[b] - pixels[a])).astype(int)
            assert picture[y - 1 : y + 2, x - 1 : x + 2, 1].max() > 60, (a, b, share)
    # And nowhere else: lines are thin, and nothing lies beyond the corners.
    assert 0.002 < (picture.max(axis=2) > 0).mean() < 0.1
    low, high = pixels.min(axis=0) - 3, pixels.max(axis=0) + 4
    outside = picture.copy()
    outside[int(low[1]) : int(high[1]), int(low[0]) : int(high[0])] = 0
    assert not outside.any()


def test_a_box_on_the_optical_axis_lies_in_the_middle():
    # The middle of 256 pixels is 128, which is array index 127.5.
    drawn = draw_pose(BLANK, Pose(np.eye(3), [0, 0, 450.0]), K, BOX, axes=False)[..., 1].astype(float)
    place = np.mgrid[:256, :256].reshape(2, -1) @ drawn.ravel() / drawn.sum()
    np.testing.assert_allclose(place, 127.5, atol=0.2)


def test_the_far_side_is_paler():
    # Looking straight at a face: the near square is larger and brighter than the far one.
    pose = Pose(np.eye(3), [0, 0, 400.0])
    picture = draw_pose(BLANK, pose, K, BOX, axes=False)
    pixels = np.rint(project(K, pose.R, pose.t, BOX)).astype(int)
    near_x, far_x = pixels[0, 0], pixels[1, 0]
    assert near_x < far_x
    near, far = picture[128, near_x, 1], picture[128, far_x, 1]
    assert near > 1.6 * far > 0


def test_axes_point_along_the_object():
    pose = Pose(np.eye(3), [0, 0, 450.0])
    picture = draw_pose(BLANK, pose, K, BOX).astype(int)
    # x right in red, y down in green.
    assert picture[128, 165, 0] > picture[128, 165, 1] + 50
    assert picture[165, 128, 1] > picture[165, 128, 0] + 50
    plain = draw_pose(BLANK, pose, K, BOX, axes=False)
    assert (picture != plain).any()


def test_the_given_picture_is_not_touched():
    given = np.full((64, 96, 3), 200, np.uint8)
    given.flags.writeable = False
    drawn = draw_pose(given, Pose(np.eye(3), [0, 0, 900.0]), K, BOX, label="0.9")
    assert drawn is not given
    assert (given == 200).all()
    assert drawn.shape == given.shape


@pytest.mark.parametrize(
    "view", [BLANK[:, ::-1], np.zeros((3, 256, 256), np.uint8).transpose(1, 2, 0), BLANK[::2]]
)
def test_any_memory_layout(view):
    drawn = draw_pose(view, TILTED, K, BOX, label="x")
    assert np.array_equal(drawn, draw_pose(np.ascontiguousarray(view), TILTED, K, BOX, label="x"))
    assert drawn.any()


@pytest.mark.parametrize(
    "t",
    [(0, 0, 20), (0, 0, 0.5), (0, 0, -300), (5000, 0, 200), (1e9, 1e9, 1.0), (0, 0, 54.4), (0, 0, 1e6)],
)
def test_poses_at_and_behind_the_camera_draw_or_leave_the_picture(t):
    drawn = draw_pose(BLANK, Pose(TILTED.R, t), K, BOX, label="label")
    assert drawn.shape == BLANK.shape
    if t == (0, 0, -300):
        assert not drawn.any()


def test_a_box_around_the_camera_plane_is_cut_not_flipped():
    # Half of the box lies behind the camera; what is drawn comes from its front half only.
    pose = Pose(np.eye(3), [300.0, 0.0, 40.0])
    drawn = draw_pose(BLANK, pose, K, BOX, axes=False)
    # In front, the box is right of x = 250 / 94.4 * f; mirrored points would fall to the left.
    assert not drawn[:, :128].any()


def test_a_box_of_astronomical_size_is_drawn_or_left_out():
    # Its long edges start far outside the picture and end inside.
    huge = BOX * np.array([1e7, 1e7, 1e8])
    assert draw_pose(BLANK, Pose(np.eye(3), [0, 0, 0]), K, huge, label="x").shape == BLANK.shape


def test_label_is_kept_inside():
    for t in ((-150, -150, 450), (150, 150, 450), (0, 0, 450)):
        with_text = draw_pose(BLANK, Pose(np.eye(3), t), K, BOX, label="0.97  0.45 m").astype(int)
        without = draw_pose(BLANK, Pose(np.eye(3), t), K, BOX).astype(int)
        text = np.argwhere(np.abs(with_text - without).max(axis=2) > 100)
        assert len(text) > 60
        assert text.min() >= 1
        assert text.max() <= 254


def test_bad_arguments():
    with pytest.raises(ValueError, match=r"corners \[8, 3\]"):
        draw_pose(BLANK, TILTED, K, BOX[:4])
    with pytest.raises(ValueError, match="uint8"):
        draw_pose(BLANK.astype(float), TILTED, K, BOX)
    assert len({PREDICTED, *AXES}) == 4
