"""Pose from 2D-3D pairs: RANSAC with EPnP, then Levenberg-Marquardt on the inliers."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import ArrayLike, NDArray

from macram.data.geometry import project
from macram.pose.rigid import Floats, Pose, camera_matrix

# EPnP and P3P both need four points; fewer different ones leave the pose open.
_FEWEST = 4


@dataclass(frozen=True, slots=True)
class RansacSettings:
    """How pairs are turned into a pose.

    Attributes:
        threshold_px: largest reprojection error of an inlier.
        iterations: most RANSAC rounds.
        confidence: probability at which the rounds stop early.
        refine: minimise the reprojection error of the inliers afterwards. The published evaluation does not.
        seed: of OpenCV's generator.
    """

    threshold_px: float = 5.0
    iterations: int = 100
    confidence: float = 0.99
    refine: bool = True
    seed: int = 0

    def __post_init__(self) -> None:
        if not self.threshold_px > 0 or self.iterations < 1 or not 0 < self.confidence < 1:
            raise ValueError(
                f"threshold {self.threshold_px} px, {self.iterations} iterations, confidence "
                f"{self.confidence}: needs more than 0 px, at least 1, and a value between 0 and 1"
            )


@dataclass(frozen=True, slots=True, eq=False)
class PnpResult:
    """A pose and the pairs that support it.

    Attributes:
        pose: object to camera, mm.
        inliers: ``[n]`` flags of the pairs given.
        rms_px: root mean square reprojection error of the inliers.
    """

    pose: Pose
    inliers: NDArray[np.bool_]
    rms_px: float


def solve_pnp(
    model: ArrayLike, pixels: ArrayLike, K: ArrayLike, settings: RansacSettings | None = None
) -> PnpResult | None:
    """Pose of a model seen at ``pixels``; the same input always gives the same answer.

    Args:
        model: ``[n, 3]`` model points, mm; repetitions are allowed.
        pixels: ``[n, 2]`` where they were seen; pairs with numbers that are not finite are never inliers.
        K: ``[3, 3]`` intrinsics, no distortion.
        settings: defaults if None.

    Returns:
        None if the pairs do not fix a pose: fewer than four different points, no consensus, or a solution
        with the object at or behind the camera.

    Raises:
        ValueError: the shapes do not fit each other, or ``K`` is no camera matrix.
    """
    settings = settings or RansacSettings()
    points, image = _pairs(model, pixels)
    matrix = camera_matrix(K)
    usable = np.flatnonzero(np.isfinite(points).all(axis=1) & np.isfinite(image).all(axis=1))
    points_ok, image_ok = np.ascontiguousarray(points[usable]), np.ascontiguousarray(image[usable])
    if not _enough(points_ok):
        return None
    cv2.setRNGSeed(settings.seed)
    try:
        found, rvec, tvec, index = cv2.solvePnPRansac(
            points_ok,
            image_ok,
            matrix,
            None,
            iterationsCount=settings.iterations,
            reprojectionError=settings.threshold_px,
            confidence=settings.confidence,
            flags=cv2.SOLVEPNP_EPNP,
        )
    except cv2.error:
        return None
    if not found or index is None or not len(index):
        return None
    chosen = np.asarray(index).reshape(-1)
    pose = _pose(rvec, tvec)
    if settings.refine and _enough(points_ok[chosen]):
        pose = _refined(points_ok[chosen], image_ok[chosen], matrix, rvec, tvec, pose)
    if pose is None or not np.all(pose.R[2] @ points_ok[chosen].T + pose.t[2] > 0):
        return None
    inliers = np.zeros(len(points), bool)
    inliers[usable[chosen]] = True
    return PnpResult(pose, inliers, _rms(pose, matrix, points_ok[chosen], image_ok[chosen]))


def epnp(model: ArrayLike, pixels: ArrayLike, K: ArrayLike) -> Pose | None:
    """Plain EPnP over all pairs, without RANSAC; arguments as in `solve_pnp`.

    Raises:
        ValueError: as in `solve_pnp`.
    """
    points, image = _pairs(model, pixels)
    if not (_enough(points) and np.isfinite(points).all() and np.isfinite(image).all()):
        return None
    try:
        found, rvec, tvec = cv2.solvePnP(points, image, camera_matrix(K), None, flags=cv2.SOLVEPNP_EPNP)
    except cv2.error:
        return None
    return _pose(rvec, tvec) if found else None


def _pairs(model: ArrayLike, pixels: ArrayLike) -> tuple[Floats, Floats]:
    points, image = np.asarray(model, np.float64), np.asarray(pixels, np.float64)
    if points.ndim != 2 or points.shape[1] != 3 or image.shape != (len(points), 2):
        raise ValueError(
            "pairs are model points [n, 3] and pixels [n, 2], "
            f"not {list(points.shape)} and {list(image.shape)}"
        )
    return np.ascontiguousarray(points), np.ascontiguousarray(image)


def _enough(points: Floats) -> bool:
    return len(points) >= _FEWEST and len(np.unique(points, axis=0)) >= _FEWEST


def _pose(rvec: ArrayLike, tvec: ArrayLike) -> Pose | None:
    """None where OpenCV returned numbers that are not finite."""
    vector, translation = np.asarray(rvec, np.float64), np.asarray(tvec, np.float64)
    if not (np.isfinite(vector).all() and np.isfinite(translation).all()):
        return None
    return Pose(np.asarray(cv2.Rodrigues(vector)[0], np.float64), translation)


def _refined(
    points: Floats, image: Floats, matrix: Floats, rvec: ArrayLike, tvec: ArrayLike, start: Pose | None
) -> Pose | None:
    """``start`` after refinement, or ``start`` itself where that did not lower the reprojection error."""
    if start is None:
        return None
    try:
        rotation, translation = cv2.solvePnPRefineLM(
            points, image, matrix, None, np.array(rvec, np.float64), np.array(tvec, np.float64)
        )
    except cv2.error:
        return start
    better = _pose(rotation, translation)
    if better is None or not _rms(better, matrix, points, image) <= _rms(start, matrix, points, image):
        return start
    return better


def _rms(pose: Pose, matrix: Floats, points: Floats, image: Floats) -> float:
    """Root mean square reprojection error, px; NaN if a point lies behind the camera."""
    return float(np.sqrt(((project(matrix, pose.R, pose.t, points) - image) ** 2).sum(axis=1).mean()))
