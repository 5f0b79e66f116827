"""Rotations, boxes, buckets, masks: against closed forms."""

from __future__ import annotations

import numpy as np
import pytest

from macram.data.erase import erase
from macram.data.frame import hull_mask
from macram.data.geometry import (
    BOX_EDGES,
    box_corners,
    bucket,
    is_rotation,
    matrix_of_quaternion,
    project,
    quaternion_of_matrix,
    turn,
)
from macram.data.ply import ply_text, read_vertices


def test_scalar_first_quaternion_turns_x_towards_y():
    """Reading the official code's transposed matrix as it stands is the classic mistake."""
    half = 0.3
    matrix = matrix_of_quaternion([np.cos(half), 0, 0, np.sin(half)])
    assert np.allclose(matrix @ [1, 0, 0], [np.cos(0.6), np.sin(0.6), 0])


@pytest.mark.parametrize("seed", range(20))
def test_quaternion_and_matrix_agree(seed):
    quaternion = np.random.default_rng(seed).normal(size=4)
    quaternion /= np.linalg.norm(quaternion) * np.sign(quaternion[0])
    assert np.allclose(quaternion_of_matrix(matrix_of_quaternion(quaternion)), quaternion, atol=1e-12)


@pytest.mark.parametrize("axis", range(3))
def test_half_turns_have_a_quaternion(axis):
    matrix = turn(np.eye(3)[axis], np.pi)
    assert np.allclose(matrix_of_quaternion(quaternion_of_matrix(matrix)), matrix, atol=1e-12)


def test_corner_order_is_x_slowest_z_fastest():
    corners = box_corners([-1, -2, -3], [1, 2, 3])
    assert corners[:4].tolist() == [[-1, -2, -3], [-1, -2, 3], [-1, 2, -3], [-1, 2, 3]]
    assert corners[4].tolist() == [1, -2, -3]
    for a, b in BOX_EDGES:
        assert np.count_nonzero(corners[a] != corners[b]) == 1


def test_projection_by_hand():
    camera = np.array([[100.0, 0, 64], [0, 100, 48], [0, 0, 1]])
    pixels = project(camera, np.eye(3), [[0], [0], [10.0]], np.array([[1.0, 0, 0], [0, -2, 0]]))
    assert pixels.tolist() == [[74, 48], [64, 28]]


@pytest.mark.parametrize(
    ("depth", "name"),
    [(0.5, "near"), (3.999, "near"), (4, "medium"), (6.999, "medium"), (7, "far"), (12, "far")],
)
def test_bucket_limits(depth, name):
    assert bucket(depth * 170, 170) == name


def test_rotations_and_impostors():
    good = turn(np.array([0, 0.6, 0.8]), 1.0)
    assert is_rotation(good)
    assert not is_rotation(good * 1.01)
    assert not is_rotation(np.diag([1.0, 1, -1]))
    assert not is_rotation(np.full((3, 3), np.nan))


def test_erasing_grows_the_mask_by_two_pixels():
    image = np.full((9, 11, 3), 200, np.uint8)
    mask = np.zeros((9, 11), np.bool_)
    mask[4, 5] = True
    erased = erase(image, mask)
    black = (erased == 0).all(axis=2)
    assert black.sum() == 25
    assert black[2:7, 3:8].all()
    assert image.min() == 200


def test_hull_mask_counts_pixel_centres():
    mask = hull_mask(np.array([[2.0, 3], [8, 3], [8, 7], [2, 7], [5, 5]]), (10, 12))
    assert mask[3:7, 2:8].all()
    assert mask.sum() == 6 * 4


def test_hull_mask_is_cut_at_the_border():
    assert hull_mask(np.array([[-5.0, -5], [3, -5], [3, 2], [-5, 2]]), (10, 12)).sum() == 3 * 2
    assert not hull_mask(np.array([[20.0, 1], [25, 1], [22, 4]]), (10, 12)).any()


def test_hull_mask_has_the_area_of_the_hull():
    angle = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    circle = 50 + 30 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    area = 0.5 * 40 * 30**2 * np.sin(2 * np.pi / 40)
    assert abs(hull_mask(circle, (100, 100)).sum() - area) < 0.01 * area


@pytest.mark.parametrize("kind", ["ascii", "binary_little_endian", "binary_big_endian"])
def test_ply_vertices(kind, tmp_path):
    points = np.random.default_rng(5).normal(size=(7, 3)).astype(np.float32)
    path = tmp_path / "mesh.ply"
    if kind == "ascii":
        path.write_text(ply_text(points.astype(np.float64), np.array([[0, 1, 2]])))
    else:
        head = (
            f"ply\nformat {kind} 1.0\ncomment made by hand\nelement vertex 7\nproperty uchar red\n"
            "property float x\nproperty float y\nproperty double z\nelement face 0\n"
            "property list uchar int vertex_indices\nend_header\n"
        )
        order = "<" if "little" in kind else ">"
        rows = np.zeros(7, [("r", "u1"), ("x", order + "f4"), ("y", order + "f4"), ("z", order + "f8")])
        for name, column in zip("xyz", points.T, strict=True):
            rows[name] = column
        path.write_bytes(head.encode() + rows.tobytes())
    assert np.allclose(read_vertices(path), points, rtol=1e-5)


@pytest.mark.parametrize("content", [b"", b"ply\nformat ascii 1.0\nend_header\n", b"solid cube\n"])
def test_a_broken_ply_is_named(content, tmp_path):
    path = tmp_path / "broken.ply"
    path.write_bytes(content)
    with pytest.raises(ValueError, match=r"broken\.ply: not a readable PLY") as error:
        read_vertices(path)
    assert "\n" not in str(error.value)
