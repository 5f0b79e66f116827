"""Pose errors with the names, arguments and units of the BOP toolkit, over any leading batch shape.

Everywhere ``R_*`` is ``[..., 3, 3]``, ``t_*`` is ``[..., 3, 1]`` in mm, ``pts`` is ``[n, 3]`` in mm and the
result has the leading shape. A single pose is the case without leading dimensions.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from macram.data.geometry import project, transform
from macram.pose.rigid import Floats

# Rows of the distance table at a time: it then stays in the cache, which is five times faster than whole.
_ROWS = 64


def add(R_est: ArrayLike, t_est: ArrayLike, R_gt: ArrayLike, t_gt: ArrayLike, pts: ArrayLike) -> Floats:
    """Mean distance of the SAME model points under both poses, mm.

    This is what CA-SpaceNet and WDR publish under the name ADI.
    """
    difference = transform(R_est, t_est, pts) - transform(R_gt, t_gt, pts)
    return np.asarray(np.linalg.norm(difference, axis=-1).mean(axis=-1))


def adi(R_est: ArrayLike, t_est: ArrayLike, R_gt: ArrayLike, t_gt: ArrayLike, pts: ArrayLike) -> Floats:
    """Mean distance from each point under the true pose to the NEAREST estimated one, mm.

    Never above `add`; far below it where the object is symmetric and the estimate is a symmetric twin.
    """
    estimated = transform(R_est, t_est, pts)
    true = transform(R_gt, t_gt, pts)
    estimated, true = np.broadcast_arrays(estimated, true)
    lead = true.shape[:-2]
    flat_true, flat_estimated = (a.reshape(-1, *a.shape[-2:]) for a in (true, estimated))
    errors = np.array([_nearest(a, b) for a, b in zip(flat_true, flat_estimated, strict=True)], np.float64)
    return errors.reshape(lead)


def _nearest(queries: Floats, points: Floats) -> float:
    """Mean distance of each query to its nearest point, both ``[n, 3]``."""
    # The expanded square finds the neighbour with one matrix product; it loses digits when points nearly
    # coincide, so the distance itself comes from the plain difference.
    centre = queries.mean(axis=0)
    a, b = queries - centre, points - centre
    squares, doubled = (b * b).sum(axis=1), np.ascontiguousarray(2.0 * b.T)
    rows = range(0, len(a), _ROWS)
    index = np.concatenate([(squares - a[i : i + _ROWS] @ doubled).argmin(axis=1) for i in rows])
    return float(np.linalg.norm(a - b[index], axis=1).mean())


def re(R_est: ArrayLike, R_gt: ArrayLike) -> Floats:
    """Angle between two rotations, degrees in 0..180."""
    return np.asarray(np.degrees(rotation_angle(R_est, R_gt)))


def te(t_est: ArrayLike, t_gt: ArrayLike) -> Floats:
    """Distance between two translations, mm."""
    difference = np.asarray(t_est, np.float64) - np.asarray(t_gt, np.float64)
    return np.asarray(np.linalg.norm(difference, axis=(-2, -1)))


def proj(
    R_est: ArrayLike, t_est: ArrayLike, R_gt: ArrayLike, t_gt: ArrayLike, K: ArrayLike, pts: ArrayLike
) -> Floats:
    """Mean distance of projected model points, px of the camera ``K [..., 3, 3]``.

    NaN where a point lies at or behind the camera plane under either pose.
    """
    difference = project(K, R_est, t_est, pts) - project(K, R_gt, t_gt, pts)
    return np.asarray(np.linalg.norm(difference, axis=-1).mean(axis=-1))


def rotation_angle(R_est: ArrayLike, R_gt: ArrayLike) -> Floats:
    """Angle between two rotations, rad in 0..pi; equal to ``2 acos |<q_est, q_gt>|`` of their quaternions.

    Sine and cosine together keep full precision at 0 and at pi, where either alone loses half the digits.
    """
    relative = np.asarray(R_est, np.float64) @ np.swapaxes(np.asarray(R_gt, np.float64), -1, -2)
    axis = np.stack(
        [
            relative[..., 2, 1] - relative[..., 1, 2],
            relative[..., 0, 2] - relative[..., 2, 0],
            relative[..., 1, 0] - relative[..., 0, 1],
        ],
        axis=-1,
    )
    twice_cosine = np.trace(relative, axis1=-2, axis2=-1) - 1.0
    return np.asarray(np.arctan2(np.linalg.norm(axis, axis=-1), twice_cosine))


def sample_vertices(vertices: ArrayLike, count: int = 1000, seed: int = 0) -> Floats:
    """``[count, 3]`` vertices drawn with replacement as in the published evaluation, but from a fixed seed.

    A mesh of at most ``count`` vertices is returned whole: drawing from it would only add noise.

    Raises:
        ValueError: ``vertices`` is not ``[n, 3]`` with n >= 1 finite rows, or ``count < 1``.
    """
    mesh = np.asarray(vertices, np.float64)
    if mesh.ndim != 2 or mesh.shape[1] != 3 or not len(mesh) or not np.isfinite(mesh).all():
        raise ValueError(f"vertices must be finite numbers [n, 3], not {list(mesh.shape)}")
    if count < 1:
        raise ValueError(f"count is {count}; at least one vertex is needed")
    if len(mesh) <= count:
        return mesh
    return np.asarray(mesh[np.random.default_rng(seed).integers(0, len(mesh), count)])
