"""The renderer: labels that fit the picture, seeds that decide everything, light that behaves."""

from __future__ import annotations

import itertools

import cv2
import numpy as np
import pytest

from macram.data.frame import hull_mask
from macram.data.geometry import is_rotation, turn
from macram.data.render.cubesat import DIAMETER_MM, SIZE_MM, corners, cubesat, mesh
from macram.data.render.faces import FACES, PAGES, atlases
from macram.data.render.fields import power_field
from macram.data.render.patches import Patches, see, see_parallel
from macram.data.render.plan import SUN_CLEARANCE, View, plan_sequence
from macram.data.render.sensor import develop, grain
from macram.data.render.sequence import render_sequence

VIEW = View(96, 80, 110.0)


@pytest.fixture(scope="module")
def frames():
    return [
        frame for sequence in range(3) for frame in render_sequence((2022, 0, sequence), 3, VIEW, (1.5, 4.0))
    ]


# ---- shape ---------------------------------------------------------------------------------------------


def test_the_body_fills_its_box_exactly():
    vertices, triangles = mesh()
    assert np.allclose(vertices.min(axis=0), -SIZE_MM / 2)
    assert np.allclose(vertices.max(axis=0), SIZE_MM / 2)
    assert abs(DIAMETER_MM - 178.43) < 0.005
    distance = np.linalg.norm(vertices[:, None] - vertices[None], axis=2).max()
    assert np.isclose(distance, DIAMETER_MM)
    assert triangles.max() == len(vertices) - 1
    present = {tuple(vertex) for vertex in np.round(vertices, 3)}
    assert all(tuple(corner) in present for corner in np.round(corners(), 3))


def test_six_faces_face_outwards_and_look_different():
    patches = cubesat()
    for page, axis in enumerate(([1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1])):
        (chosen,) = np.flatnonzero(patches.page == page)
        assert np.allclose(patches.normal[chosen], axis)
        assert patches.origin[chosen] @ axis > 40
    level = atlases()[-1]
    size = level.size[0]
    # Even at a dozen texels, in any of four turns, no face is another.
    pages = [
        level.texels[level.start[p] : level.start[p] + size**2, :3].reshape(size, size, 3) for p in range(6)
    ]
    for a, b in itertools.combinations(pages, 2):
        for quarter in range(4):
            assert np.abs(np.rot90(a, quarter) - b).mean() > 0.08


def test_pages_are_physical():
    for level in atlases():
        assert level.texels[:, :3].min() >= 0
        assert level.texels[:, :3].max() <= 1
        assert level.texels[:, 4].min() > 0
        assert len(level.size) == len(PAGES) > len(FACES)


# ---- visibility ----------------------------------------------------------------------------------------


def scene(*squares):
    """Squares of half side ``h`` at ``z``, facing the camera at the origin (towards -z)."""
    origin = np.array([[h, -h, z] for h, z in squares], np.float64)
    across = np.array([[-2 * h, 0, 0] for h, _ in squares], np.float64)
    up = np.array([[0, 2 * h, 0] for h, _ in squares], np.float64)
    return Patches(origin, across, up, np.zeros(len(squares), np.intp), np.ones(len(squares), np.bool_))


GRID = np.array([[10.0, 0, 19.5], [0, 10.0, 19.5], [0, 0, 1]])


@pytest.mark.parametrize("order", [1, -1])
def test_the_nearer_square_hides_the_farther(order):
    squares = [(50, 100), (140, 200)][::order]
    seen = see(scene(*squares), GRID, np.eye(3), np.zeros(3), (40, 40))
    near, far = (0, 1) if order == 1 else (1, 0)
    assert (seen.patch == near).sum() == 100
    assert (seen.patch == far).sum() == 14**2 - 10**2
    depth = 1 / seen.nearness[seen.patch == near]
    assert np.allclose(depth, 100, rtol=1e-5)
    u = seen.u[20, 15:25] / seen.nearness[20, 15:25]
    assert np.allclose(u, 0.95 - 0.1 * np.arange(10), atol=1e-4)


def test_backs_are_not_seen():
    turned = turn(np.array([0, 1.0, 0]), np.pi)
    seen = see(scene((50, 100)), GRID, turned, np.array([0, 0, 200.0]), (40, 40))
    assert (seen.patch == -1).all()


def test_a_square_that_reaches_behind_the_camera_is_cut():
    """A floor below the camera, from far ahead to far behind: visible below the horizon only."""
    floor = Patches(
        np.array([[-500.0, 30, -500]]), np.array([[0, 0, 1000.0]]), np.array([[1000.0, 0, 0]]),
        np.zeros(1, np.intp), np.ones(1, np.bool_),
    )  # fmt: skip
    assert floor.normal[0, 1] != 0
    if floor.normal[0] @ floor.origin[0] > 0:
        floor = Patches(floor.origin, floor.up, floor.across, floor.page, floor.body)
    seen = see(floor, GRID, np.eye(3), np.zeros(3), (40, 40))
    assert (seen.patch[:20] == -1).all()
    assert (seen.patch[24:34] == 0).all()
    assert (seen.patch[35:] == -1).all()  # nearer than 20 mm


def test_parallel_view_gives_heights():
    axes = np.array([[0.1, 0, 0, 20], [0, 0.1, 0, 20], [0, 0, -1.0, 0]])
    seen = see_parallel(scene((50, 100), (150, 200)), axes, (40, 40))
    assert (seen.nearness[seen.patch == 0] == -100).all()
    assert (seen.patch == 0).sum() in range(100, 122)
    assert np.allclose(seen.nearness[seen.patch == 1], -200)


# ---- sequences -----------------------------------------------------------------------------------------


def test_labels_fit_the_pictures(frames):
    for frame in frames:
        assert is_rotation(frame.rotation, 1e-9)
        assert 1.5 * DIAMETER_MM <= frame.translation[2] <= 4 * DIAMETER_MM
        assert frame.bucket == "near"
        hull = hull_mask(frame.corners, frame.mask.shape)
        assert (frame.mask & hull).sum() > 0.8 * hull.sum() > 0
        x, y, width, height = frame.extent
        rows, columns = np.nonzero(frame.mask)
        assert columns.min() >= x - 1
        assert rows.max() <= y + height + 1
        assert columns.max() <= x + width + 1


def test_image_and_background_differ_only_at_the_target(frames):
    for frame in frames:
        assert frame.image.shape == frame.background.shape == (80, 96, 3)
        near = cv2.dilate(frame.mask.astype(np.uint8), np.ones((41, 41), np.uint8)) > 0
        assert np.abs(frame.image.astype(int) - frame.background)[~near].max(initial=0) <= 4
        black = (frame.erased == 0).all(axis=2)
        assert black[frame.mask].all()


def test_the_target_is_seen_in_most_frames(frames):
    differs = [np.abs(frame.image.astype(int) - frame.background)[frame.mask].mean() > 8 for frame in frames]
    assert np.mean(differs) > 0.8


def test_same_seed_same_bytes_other_seed_other_pictures(frames):
    again = list(render_sequence((2022, 0, 1), 3, VIEW, (1.5, 4.0)))
    for one, two in zip(frames[3:6], again, strict=True):
        assert np.array_equal(one.image, two.image)
        assert np.array_equal(one.rotation, two.rotation)
    for seed in ((2023, 0, 1), (2022, 1, 1), (2022, 0, 2)):
        other = next(render_sequence(seed, 3, VIEW, (1.5, 4.0)))
        assert not np.allclose(other.rotation, again[0].rotation)


@pytest.mark.parametrize("sequence", range(40))
def test_plans_keep_their_promises(sequence):
    view = View(256, 256, 303.8)
    plan = plan_sequence((5, 2, sequence), 20, view, (200.0, 1800.0), 108.8)
    assert is_rotation(plan.rotations[7], 1e-9)
    assert is_rotation(plan.cameras[19], 1e-9)
    assert (plan.cameras[:, 2] @ plan.sun).max() < SUN_CLEARANCE
    depth = plan.translations[:, 2]
    assert depth.min() >= 200
    assert depth.max() <= 1800
    pixels = plan.translations[:, :2] / depth[:, None] * view.focal + 128
    assert pixels.min() > 0
    assert pixels.max() < 256
    # The whole box is before the camera even at the nearest depth.
    assert (depth > DIAMETER_MM / 2).all()


def test_one_frame_is_a_sequence_too():
    (frame,) = render_sequence((1, 0, 0), 1, View(32, 24, 40.0), (9.0, 9.0), background=False)
    assert frame.background is None
    assert frame.bucket == "far"


# ---- light and sensor ----------------------------------------------------------------------------------


def test_noise_free_response_is_monotonous_and_clips():
    ramp = np.linspace(0, 5, 64, dtype=np.float32)[None, :, None] * np.ones((8, 1, 3), np.float32)
    picture = develop(ramp, 1.0, np.zeros_like(ramp))
    row = picture[4, :, 0].astype(int)
    assert (np.diff(row) >= 0).all()
    assert row[-1] >= 254
    assert develop(0 * ramp, 1.0, 0 * ramp).max() <= 3


def test_grain_depends_on_its_seed_alone():
    assert np.array_equal(grain((5, 4), 3), grain((5, 4), 3))
    assert not np.array_equal(grain((5, 4), 3), grain((5, 4), 4))


def test_fields_tile_without_a_seam():
    field = power_field(128, 1.6, seed=3)
    inside = np.abs(np.diff(field, axis=0)).mean()
    seam = np.abs(field[0] - field[-1]).mean()
    assert seam < 3 * inside
    assert abs(field.mean()) < 1e-3
    assert abs(field.std() - 1) < 1e-3
