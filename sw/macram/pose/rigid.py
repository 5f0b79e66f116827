"""Poses, cameras and projection, with the names and units of the BOP toolkit.

Pixel (0, 0) covers 0..1 in both directions: pixel centres are whole numbers plus a half, and the middle of a
picture of 512 pixels is 256. Array indices are 0.5 less.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]

# JSON carries rotations with six or more digits; anything further from orthonormal is no rotation.
_ORTHONORMAL = 1e-3


@dataclass(frozen=True, slots=True, eq=False)
class Pose:
    """Object-to-camera motion ``x_cam = R x + t``, OpenCV axes (x right, y down, z forward).

    Attributes:
        R: ``[3, 3]`` rotation.
        t: ``[3, 1]`` translation, mm. Three numbers in any shape are accepted.

    Raises:
        ValueError: a wrong shape, a number that is not finite, or ``R`` is not a rotation.
    """

    R: Floats
    t: Floats

    def __post_init__(self) -> None:
        rotation = np.asarray(self.R, np.float64)
        translation = np.asarray(self.t, np.float64)
        if rotation.shape != (3, 3) or translation.size != 3:
            raise ValueError(
                f"a pose needs R [3, 3] and t [3, 1], not {list(rotation.shape)} and "
                f"{list(translation.shape)}"
            )
        if not (np.isfinite(rotation).all() and np.isfinite(translation).all()):
            raise ValueError("a pose needs finite numbers; leave a frame without a pose out instead")
        error = float(np.abs(rotation @ rotation.T - np.eye(3)).max())
        if error > _ORTHONORMAL or np.linalg.det(rotation) < 0:
            raise ValueError(
                f"R is not a rotation (R R^T is off by {error:.3g}, determinant "
                f"{np.linalg.det(rotation):.3g}); normalise it first"
            )
        object.__setattr__(self, "R", rotation)
        object.__setattr__(self, "t", translation.reshape(3, 1))


def camera_matrix(value: ArrayLike) -> Floats:
    """``[3, 3]`` intrinsics from nine numbers in row order.

    Raises:
        ValueError: not nine finite numbers, focal lengths not positive, or a last row that is not 0 0 1.
    """
    matrix = np.asarray(value, np.float64)
    if matrix.size != 9 or not np.isfinite(matrix).all():
        raise ValueError(f"a camera matrix has nine finite numbers, not {matrix.tolist()}")
    matrix = matrix.reshape(3, 3)
    if matrix[0, 0] <= 0 or matrix[1, 1] <= 0 or matrix[1, 0] != 0 or matrix[2].tolist() != [0, 0, 1]:
        raise ValueError(f"{matrix.tolist()} is not a camera matrix [[fx, s, cx], [0, fy, cy], [0, 0, 1]]")
    return matrix


def roll(angle: float) -> Floats:
    """``[3, 3]`` turn about the optical axis; a positive angle (rad) takes x towards y."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
