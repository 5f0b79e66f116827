"""One affine map from a frame to a view of it, and the labels that belong to the view.

Pixel centres are whole numbers plus a half, as everywhere with camera matrices here.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import ArrayLike, NDArray

from macram.data.geometry import project
from macram.pose.pnp import epnp
from macram.pose.rigid import Floats, Pose, camera_matrix, roll

Image = NDArray[np.uint8]
Mask = NDArray[np.bool_]

# Value of pixels that no source pixel reaches, as published.
BORDER = 128


@dataclass(frozen=True, slots=True)
class Draw:
    """One random move: a turn by ``angle`` (rad, x towards y), a zoom by ``scale``, a ``shift`` (px)."""

    angle: float = 0.0
    scale: float = 1.0
    shift: tuple[float, float] = (0.0, 0.0)


@dataclass(frozen=True, slots=True, eq=False)
class Warp:
    """A draw worked out for one camera.

    Attributes:
        matrix: ``[3, 3]`` affine map from source pixels to pixels of the view.
        K: ``[3, 3]`` camera matrix of the view.
        pose: of the object in the view.
        size: ``(width, height)`` of the view, px.
    """

    matrix: Floats
    K: Floats
    pose: Pose
    size: tuple[int, int]


def exact_warp(
    move: Draw,
    source: ArrayLike,
    target: ArrayLike,
    size: tuple[int, int],
    pose: Pose,
    *,
    centred: bool = False,
) -> Warp:
    """The move with exact labels.

    Args:
        move: the draw.
        source: ``[3, 3]`` camera matrix of the frame.
        target: ``[3, 3]`` camera matrix of the network's input before the move; it also sets the resize.
        size: ``(width, height)`` of the view.
        pose: of the object in the frame.
        centred: put the model origin at the middle of the view, then shift.
    """
    k_source, k_target = camera_matrix(source), camera_matrix(target)
    turn = roll(move.angle)
    moved = Pose(turn @ pose.R, turn @ pose.t)
    # Zoom about the principal point, then shift. The turn needs no centre: K Rz K^-1 is affine for any K.
    camera = k_target.copy()
    camera[:2, :2] *= move.scale
    if centred:
        camera[:2, 2] += np.divide(size, 2) - project(camera, moved.R, moved.t, np.zeros((1, 3)))[0]
    camera[:2, 2] += move.shift
    return Warp(camera @ turn @ np.linalg.inv(k_source), camera, moved, size)


def reference_warp(
    move: Draw, source: ArrayLike, target: ArrayLike, size: tuple[int, int], pose: Pose, keypoints: ArrayLike
) -> Warp:
    """The move as published: shift, turn and zoom about the image centre, same camera, refitted pose.

    Arguments as in `exact_warp`; ``keypoints`` ``[k, 3]`` mm are projected, moved and fitted.

    Raises:
        ValueError: a keypoint is not in front of the camera, so that there is nothing to fit.
    """
    k_source, k_target = camera_matrix(source), camera_matrix(target)
    centre = np.array([size[0] / 2, size[1] / 2])
    turn = np.eye(3)
    turn[:2, :2] = move.scale * roll(move.angle)[:2, :2]
    turn[:2, 2] = centre - turn[:2, :2] @ centre
    shift = np.eye(3)
    shift[:2, 2] = move.shift
    matrix = turn @ shift @ k_target @ np.linalg.inv(k_source)
    fitted = epnp(keypoints, move_points(matrix, project(k_source, pose.R, pose.t, keypoints)), k_target)
    if fitted is None:
        raise ValueError(f"no pose fits the moved keypoints (pose at {pose.t.ravel().tolist()} mm)")
    return Warp(matrix, k_target, fitted, size)


def move_points(matrix: Floats, points: Floats) -> Floats:
    """``[n, 2]`` pixels under an affine ``[3, 3]`` map."""
    return np.asarray(points @ matrix[:2, :2].T + matrix[:2, 2])


def warp_image(image: Image, warp: Warp) -> Image:
    """A picture in the view: bilinear, border `BORDER`."""
    border = (BORDER, BORDER, BORDER)
    matrix = _between_indices(warp.matrix)
    moved = cv2.warpAffine(image, matrix, warp.size, flags=cv2.INTER_LINEAR, borderValue=border)
    return np.asarray(moved, np.uint8)


def warp_mask(mask: Mask, warp: Warp) -> Mask:
    """A mask in the view: nearest pixel, border off."""
    matrix = _between_indices(warp.matrix)
    moved = cv2.warpAffine(mask.view(np.uint8), matrix, warp.size, flags=cv2.INTER_NEAREST)
    return np.asarray(moved) > 0


def _between_indices(matrix: Floats) -> Floats:
    """The ``[2, 3]`` map of array indices, which are 0.5 less than pixel coordinates, as OpenCV wants it."""
    indices = matrix[:2].copy()
    indices[:, 2] += 0.5 * indices[:, :2].sum(axis=1) - 0.5
    return indices
