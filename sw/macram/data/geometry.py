"""Boxes, projection, rotations and depth buckets shared by readers, renderer and checks.

Camera frame as in OpenCV and BOP: x right, y down, z forward. Lengths in millimetres.
"""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]

BUCKETS = ("near", "medium", "far")
"""Depth buckets, nearest first."""

BUCKET_LIMITS = (4.0, 7.0)
"""Where medium and far begin, in diameters; what lies below 1 or above 10 counts as near or far."""

BOX_EDGES = ((0, 1), (0, 2), (0, 4), (1, 3), (1, 5), (2, 3), (2, 6), (3, 7), (4, 5), (4, 6), (5, 7), (6, 7))
"""Pairs of corners of `box_corners` that share an edge."""


def box_corners(low: ArrayLike, high: ArrayLike) -> Floats:
    """``[8, 3]`` corners of an axis-aligned box, x slowest and z fastest: (-,-,-), (-,-,+), (-,+,-) ..."""
    limits = np.stack([np.asarray(low, np.float64), np.asarray(high, np.float64)])
    return np.array(
        [[limits[i, 0], limits[j, 1], limits[k, 2]] for i, j, k in itertools.product((0, 1), repeat=3)]
    )


def transform(R: ArrayLike, t: ArrayLike, pts: ArrayLike) -> Floats:
    """Points in the camera frame: ``[..., 3, 3]``, ``[..., 3, 1]``, ``[n, 3]`` mm -> ``[..., n, 3]`` mm."""
    rotation, translation = np.asarray(R, np.float64), np.asarray(t, np.float64)
    points = np.asarray(pts, np.float64)
    return np.asarray(points @ np.swapaxes(rotation, -1, -2) + np.swapaxes(translation, -1, -2))


def project(K: ArrayLike, R: ArrayLike, t: ArrayLike, pts: ArrayLike) -> Floats:
    """Pixels of model points; pixel centres are whole numbers plus a half.

    Args:
        K: ``[..., 3, 3]`` intrinsics, px.
        R: ``[..., 3, 3]`` rotations.
        t: ``[..., 3, 1]`` translations, mm.
        pts: ``[n, 3]`` model points, mm.

    Returns:
        ``[..., n, 2]`` pixels; NaN for points at or behind the camera plane.
    """
    image = transform(R, t, pts) @ np.swapaxes(np.asarray(K, np.float64), -1, -2)
    depth = image[..., 2:]
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(np.where(depth > 0, image[..., :2] / depth, np.nan))


def bucket(depth: float, diameter: float) -> str:
    """``near`` (below 4 diameters), ``medium`` (below 7) or ``far``, for an object's origin at ``depth``."""
    return BUCKETS[int(np.searchsorted(BUCKET_LIMITS, depth / diameter, side="right"))]


def is_rotation(matrix: Floats, tolerance: float = 1e-3) -> bool:
    """Whether ``[3, 3]`` is orthonormal within ``tolerance`` and right-handed."""
    return bool(
        np.isfinite(matrix).all()
        and np.abs(matrix @ matrix.T - np.eye(3)).max() <= tolerance
        and np.linalg.det(matrix) > 0
    )


def is_camera(matrix: Floats) -> bool:
    """Whether ``[3, 3]`` are intrinsics: upper triangular, focal lengths above 0, last row 0 0 1."""
    return bool(
        np.isfinite(matrix).all()
        and (np.diag(matrix)[:2] > 0).all()
        and matrix[1, 0] == 0
        and (matrix[2] == [0, 0, 1]).all()
    )


def matrix_of_quaternion(quaternion: ArrayLike) -> Floats:
    """Rotation matrix of a unit quaternion, scalar first; (cos a/2, 0, 0, sin a/2) turns +x towards +y."""
    w, x, y, z = (float(v) for v in np.asarray(quaternion, np.float64))
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def quaternion_of_matrix(rotation: Floats) -> Floats:
    """Unit quaternion ``[4]``, scalar first and not negative, of a rotation matrix.

    The largest eigenvector of Bar-Itzhack's symmetric matrix: stable for every angle.
    """
    r = rotation
    lower = np.array(
        [
            [r[0, 0] + r[1, 1] + r[2, 2], 0, 0, 0],
            [r[2, 1] - r[1, 2], r[0, 0] - r[1, 1] - r[2, 2], 0, 0],
            [r[0, 2] - r[2, 0], r[0, 1] + r[1, 0], r[1, 1] - r[0, 0] - r[2, 2], 0],
            [r[1, 0] - r[0, 1], r[0, 2] + r[2, 0], r[1, 2] + r[2, 1], r[2, 2] - r[0, 0] - r[1, 1]],
        ]
    )
    vector = np.linalg.eigh(lower, UPLO="L")[1][:, -1]
    return np.asarray(vector if vector[0] >= 0 else -vector)


def turn(axis: Floats, angle: float) -> Floats:
    """Rotation matrix of ``angle`` radians about a unit ``axis``."""
    return matrix_of_quaternion(np.concatenate([[np.cos(angle / 2)], np.sin(angle / 2) * axis]))
