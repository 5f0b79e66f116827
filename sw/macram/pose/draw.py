"""Boxes and axes of poses, drawn into a picture."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import ArrayLike, NDArray

from macram.data.geometry import BOX_EDGES, transform
from macram.pose.rigid import Floats, Pose, camera_matrix

Image = NDArray[np.uint8]
Colour = tuple[int, int, int]

PREDICTED: Colour = (64, 224, 120)
TRUE: Colour = (255, 190, 60)
AXES: tuple[Colour, Colour, Colour] = ((255, 82, 82), (94, 222, 94), (92, 152, 255))

# OpenCV takes coordinates in 1/16 px.
_SHIFT = 4
# Lines are cut this far in front of the camera, mm: a corner behind it has no pixel.
_NEAREST = 1.0
# Beyond this OpenCV's 32-bit line arithmetic would overflow.
_FARTHEST_PX = 1e6


@dataclass(frozen=True, slots=True)
class _Pen:
    colour: Colour
    width: int
    opacity: float


def draw_pose(
    image: Image,
    pose: Pose,
    K: ArrayLike,
    corners: ArrayLike,
    *,
    colour: Colour = PREDICTED,
    axes: bool = True,
    label: str = "",
) -> Image:
    """A copy of the picture with the object's box, and its axes if wanted.

    Edges at the far side of the box are thinner and paler, so the picture shows which way the box points. The
    axes start at the box centre; x is red, y green, z blue.

    Args:
        image: ``[height, width, 3]`` RGB.
        pose: object to camera, mm.
        K: ``[3, 3]`` intrinsics of ``image``.
        corners: ``[8, 3]`` box corners, mm, x slowest, z fastest.
        colour: of the box.
        axes: draw the axes.
        label: short ASCII text at the box; empty for none.

    Raises:
        ValueError: a wrong shape.
    """
    box = np.asarray(corners, np.float64)
    if box.shape != (8, 3):
        raise ValueError(f"a box has corners [8, 3], not {list(box.shape)}")
    if image.ndim != 3 or image.shape[2] != 3 or image.dtype != np.uint8:
        raise ValueError(
            f"the picture must be uint8 [height, width, 3], not {image.dtype} {list(image.shape)}"
        )
    matrix = camera_matrix(K)
    picture = np.ascontiguousarray(image).copy()
    width = _line_width(picture, matrix, pose, box)
    hidden = _hidden_edges(pose, box)
    # Far side first, so that near edges lie on top.
    for edge in sorted(BOX_EDGES, key=lambda e: e not in hidden):
        far = edge in hidden
        pen = _Pen(colour, max(1, width - 1) if far else width, 0.45 if far else 0.95)
        _line(picture, matrix, transform(pose.R, pose.t, box[list(edge)]), pen)
    if axes:
        _axes(picture, matrix, pose, box, width)
    if label:
        _label(picture, matrix, transform(pose.R, pose.t, box), label, colour)
    return picture


def _line_width(picture: Image, matrix: Floats, pose: Pose, box: Floats) -> int:
    """Thicker on larger pictures, but one pixel on an object so small that lines would cover it."""
    depth = max(_NEAREST, float((pose.R[2] @ box.mean(axis=0) + pose.t[2])[0]))
    object_px = float(np.linalg.norm(np.ptp(box, axis=0)) * matrix[0, 0]) / depth
    side: int = min(picture.shape[:2])
    return max(1, round(min(side / 300, object_px / 60)))


def _hidden_edges(pose: Pose, box: Floats) -> set[tuple[int, int]]:
    """Edges between two faces that both look away from the camera."""
    centre = box.mean(axis=0)
    away: set[tuple[int, bool]] = set()
    for axis, bit in enumerate((4, 2, 1)):
        for high in (False, True):
            face = box[[c for c in range(8) if bool(c & bit) == high]].mean(axis=0)
            normal = pose.R @ (face - centre)
            if normal @ (pose.R @ face + pose.t[:, 0]) > 0:
                away.add((axis, high))
    result = set()
    for a, b in BOX_EDGES:
        faces = [(axis, bool(a & bit)) for axis, bit in enumerate((4, 2, 1)) if not (a ^ b) & bit]
        if all(face in away for face in faces):
            result.add((a, b))
    return result


def _axes(picture: Image, matrix: Floats, pose: Pose, box: Floats, width: int) -> None:
    centre = box.mean(axis=0)
    length = 0.75 * float(np.ptp(box, axis=0).max())
    ends = centre + length * np.eye(3)
    # Nearest arrow last.
    for axis in np.argsort(-transform(pose.R, pose.t, ends)[:, 2]):
        segment = transform(pose.R, pose.t, np.stack([centre, ends[axis]]))
        # A dark rim keeps the arrow readable on clouds and on the object's own white faces.
        _line(picture, matrix, segment, _Pen((0, 0, 0), width + 2, 0.55))
        _line(picture, matrix, segment, _Pen(AXES[axis], width + (width > 1), 1.0))


def _line(picture: Image, matrix: Floats, segment: Floats, pen: _Pen) -> None:
    """One camera-frame segment ``[2, 3]``, cut at the camera plane, blended with the pen's opacity."""
    near = segment[:, 2] < _NEAREST
    if near.all():
        return
    if near.any():
        a, b = segment[near][0], segment[~near][0]
        cut = b + (a - b) * (b[2] - _NEAREST) / (b[2] - a[2])
        segment = np.stack([cut, b])
    pixels = segment @ matrix.T
    # OpenCV draws in array indices: the centre of pixel 0 is 0, not 0.5.
    pixels = pixels[:, :2] / pixels[:, 2:] - 0.5
    if np.abs(pixels).max() > _FARTHEST_PX:
        return
    start, end = (tuple(int(v) for v in np.rint(p * (1 << _SHIFT))) for p in pixels)
    # Only the touched rectangle is blended: a copy of the whole picture for each line would be slow.
    low = np.floor(pixels.min(axis=0)).astype(int) - pen.width - 2
    high = np.ceil(pixels.max(axis=0)).astype(int) + pen.width + 3
    x0, y0 = (max(0, int(v)) for v in low)
    x1, y1 = min(picture.shape[1], int(high[0])), min(picture.shape[0], int(high[1]))
    if x0 >= x1 or y0 >= y1:
        return
    under = picture[y0:y1, x0:x1].copy()
    cv2.line(picture, start, end, pen.colour, pen.width, cv2.LINE_AA, _SHIFT)
    drawn = picture[y0:y1, x0:x1]
    picture[y0:y1, x0:x1] = cv2.addWeighted(drawn.copy(), pen.opacity, under, 1.0 - pen.opacity, 0.0)


def _label(picture: Image, matrix: Floats, corners: Floats, text: str, colour: Colour) -> None:
    """Text on a dark plate above the box, moved into the picture where needed."""
    seen = corners[corners[:, 2] > _NEAREST]
    if not len(seen):
        return
    pixels = seen @ matrix.T
    pixels = pixels[:, :2] / pixels[:, 2:]
    high, wide = picture.shape[:2]
    scale = max(0.33, min(high, wide) / 1200)
    (across, up), below = cv2.getTextSize(text, cv2.FONT_HERSHEY_SIMPLEX, scale, 1)
    pad = max(2, up // 3)
    x = int(np.clip(pixels[:, 0].min(), pad, max(pad, wide - across - pad - 1)))
    y = int(np.clip(pixels[:, 1].min() - below - 3 * pad, up + pad, max(up + pad, high - below - pad - 1)))
    plate = picture[max(0, y - up - pad) : y + below + pad, max(0, x - pad) : x + across + pad]
    plate[:] = (plate * 0.3).astype(np.uint8)
    cv2.putText(picture, text, (x, y), cv2.FONT_HERSHEY_SIMPLEX, scale, colour, 1, cv2.LINE_AA)
