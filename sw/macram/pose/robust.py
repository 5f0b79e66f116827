"""Poses by weighted least squares over many pairs, with a loss that outliers cannot drag."""

from __future__ import annotations

import cv2
import numpy as np

from macram.pose.rigid import Floats, Pose

_ROUNDS = 15
_ATTEMPTS = 8
_CONVERGED = 1e-7


def projected(K: Floats, R: Floats, t: Floats, points: Floats) -> tuple[Floats, Floats]:
    """Pixels of model points, and how they move with the pose.

    Args:
        K: ``[3, 3]`` intrinsics without skew.
        R: ``[3, 3]``.
        t: ``[3]`` mm.
        points: ``[n, 3]`` mm, in front of the camera.

    Returns:
        ``[n, 2]`` pixels, and ``[n, 2, 6]`` their derivatives by a rotation vector (rad) applied after ``R``,
        and by ``t``.
    """
    turned = points @ R.T
    x, y, z = (turned + t).T
    nothing = np.zeros_like(z)
    by_point = np.stack(
        [
            np.stack([K[0, 0] / z, nothing, -K[0, 0] * x / z**2], axis=1),
            np.stack([nothing, K[1, 1] / z, -K[1, 1] * y / z**2], axis=1),
        ],
        axis=1,
    )
    by_turn = np.cross(turned[:, None], by_point)
    pixels = np.stack([K[0, 0] * x / z + K[0, 2], K[1, 1] * y / z + K[1, 2]], axis=1)
    return pixels, np.concatenate([by_turn, by_point], axis=2)


def moved(R: Floats, t: Floats, step: Floats) -> tuple[Floats, Floats]:
    """A pose after a ``step [6]`` as `projected` differentiates by."""
    return np.asarray(cv2.Rodrigues(step[:3])[0], np.float64) @ R, t + step[3:]


def as_pose(R: Floats, t: Floats) -> Pose:
    """A pose whose rotation is the one nearest to ``R``; products of many rotations drift."""
    left, _, right = np.linalg.svd(R)
    return Pose(left @ right, t)


def robust_pose(
    points: Floats, pixels: Floats, weights: Floats, K: Floats, start: Pose, spread: float
) -> Pose:
    """Levenberg-Marquardt over all pairs under Cauchy's loss.

    Args:
        points: ``[n, 3]`` model points, mm; repetitions are allowed.
        pixels: ``[n, 2]`` where they were seen.
        weights: ``[n]``, not negative.
        K: ``[3, 3]`` intrinsics.
        start: with all points in front of the camera; else it is returned as it is.
        spread: error at which a pair counts half, px.
    """
    R, t, damping = start.R, start.t[:, 0], 1e-3
    cost, trust = _cauchy(points, pixels, weights, K, R, t, spread)
    if not np.isfinite(cost):
        return start
    for _ in range(_ROUNDS):
        seen, jacobian = projected(K, R, t, points)
        weight = weights * trust
        hessian = np.einsum("nia,nib,n->ab", jacobian, jacobian, weight)
        gradient = np.einsum("nia,ni,n->a", jacobian, seen - pixels, weight)
        before = cost
        for _ in range(_ATTEMPTS):
            step = -np.linalg.solve(hessian + damping * np.diag(np.diag(hessian)), gradient)
            there = moved(R, t, step)
            lower, trusted = _cauchy(points, pixels, weights, K, *there, spread)
            if lower < cost:
                (R, t), cost, trust, damping = there, lower, trusted, max(damping / 5, 1e-9)
                break
            damping *= 5
        if before - cost <= _CONVERGED * before:
            break
    return as_pose(R, t)


def _cauchy(
    points: Floats, pixels: Floats, weights: Floats, K: Floats, R: Floats, t: Floats, spread: float
) -> tuple[float, Floats]:
    """Loss, infinite with a point behind the camera, and what share ``[n]`` each pair keeps of its weight."""
    if np.any(points @ R[2] + t[2] <= 0):
        return np.inf, weights
    square = ((projected(K, R, t, points)[0] - pixels) ** 2).sum(axis=1) / spread**2
    return float((weights * np.log1p(square)).sum()), 1 / (1 + square)
