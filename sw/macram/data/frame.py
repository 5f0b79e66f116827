"""One picture with its pose, whichever data set it comes from."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from macram.data.files import Picture, read_picture
from macram.data.geometry import Floats, bucket, project


@dataclass(frozen=True, eq=False)
class Model:
    """The object that a data set shows.

    Attributes:
        name: for messages and reports.
        keypoints: ``[K, 3]`` mm; the 8 corners of the body's box in the order of
            `macram.data.geometry.box_corners` where the data set has a box, else points of its own.
        diameter: mm; the unit of depth buckets and pose errors.
        vertices: ``[V, 3]`` mm for mesh distances; the keypoints where no mesh is given.
        is_box: whether the keypoints are box corners, so that edges can be drawn.
    """

    name: str
    keypoints: Floats
    diameter: float
    vertices: Floats
    is_box: bool


@dataclass(frozen=True, eq=False)
class Frame:
    """A picture and its labels; nothing is decoded before it is asked for.

    Attributes:
        name: unique within the data set, e.g. ``testing/seq_000400/000000/000012``.
        sequence: what of the name its neighbours share.
        image: file.
        mask: file, or None: the convex hull of the projected keypoints stands in for it.
        background: the same picture without the target, where the data set has it.
        stored: width and height of the files, pixels; None where the data set does not fix them.
        camera: ``[3, 3]`` intrinsics of the picture as `read_image` returns it.
        rotation: ``[3, 3]`` object to camera.
        translation: ``[3]`` mm.
        model: the object.
        pad: black rows added above and below.
        shrink: whole factor by which the padded picture is reduced.
    """

    name: str
    sequence: str
    image: Path
    mask: Path | None
    background: Path | None
    stored: tuple[int, int] | None
    camera: Floats
    rotation: Floats
    translation: Floats
    model: Model
    pad: int = 0
    shrink: int = 1

    @property
    def bucket(self) -> str:
        """``near``, ``medium`` or ``far``, by the depth of the object's origin."""
        return bucket(float(self.translation[2]), self.model.diameter)

    @property
    def points(self) -> Floats:
        """``[K, 2]`` projected keypoints, pixels of `read_image`."""
        return project(self.camera, self.rotation, self.translation[:, None], self.model.keypoints)

    def read_image(self) -> Picture:
        """``[H, W, 3]`` RGB; a grey picture has three equal channels.

        Raises:
            ValueError: missing, broken or of the wrong size; one line that names the file.
        """
        return self._fit(read_picture(self.image, colour=True, size=self.stored))

    def read_background(self) -> Picture:
        """``[H, W, 3]`` RGB without the target.

        Raises:
            ValueError: the data set has none, or the file is bad.
        """
        if self.background is None:
            raise ValueError(f"{self.image}: this data set has no background picture")
        return self._fit(read_picture(self.background, colour=True, size=self.stored))

    def read_mask(self) -> NDArray[np.bool_]:
        """``[H, W]`` where the target is seen.

        Raises:
            ValueError: missing, broken or of the wrong size; one line that names the file.
        """
        if self.mask is not None:
            return np.asarray(self._fit(read_picture(self.mask, colour=False, size=self.stored)) > 127)
        if self.stored is None:
            raise ValueError(f"{self.image}: a hull mask needs the size of the picture")
        width, height = (self.stored[0] // self.shrink, (self.stored[1] + 2 * self.pad) // self.shrink)
        return hull_mask(self.points, (height, width))

    def _fit(self, picture: Picture) -> Picture:
        if self.pad:
            picture = np.pad(picture, [(self.pad, self.pad), *[(0, 0)] * (picture.ndim - 1)])
        if self.shrink > 1:
            height, width = picture.shape[:2]
            size = (width // self.shrink, height // self.shrink)
            picture = np.asarray(cv2.resize(picture, size, interpolation=cv2.INTER_AREA), np.uint8)
        return picture


def hull_mask(points: Floats, shape: tuple[int, int]) -> NDArray[np.bool_]:
    """``[H, W]`` where a pixel's centre, a whole number plus a half, lies in the hull of pixels ``[K, 2]``.

    OpenCV finds the hull, but its polygon fill also sets every pixel that the outline touches: a rim that
    would add a fifth to a far target.
    """
    hull = cv2.convexHull(points.astype(np.float32)).reshape(-1, 2)
    mask = np.zeros(shape, np.bool_)
    low = np.clip(np.floor(hull.min(axis=0)), 0, shape[::-1]).astype(int)
    high = np.clip(np.ceil(hull.max(axis=0)), 0, shape[::-1]).astype(int)
    if (high <= low).any():
        return mask
    x = np.arange(low[0], high[0]) + 0.5
    y = np.arange(low[1], high[1])[:, None] + 0.5
    sides = [
        (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])
        for a, b in zip(hull.astype(np.float64), np.roll(hull, -1, axis=0).astype(np.float64), strict=True)
    ]
    # OpenCV's releases do not agree on the sense of the outline.
    inside = np.all([side >= 0 for side in sides], axis=0) | np.all([side <= 0 for side in sides], axis=0)
    mask[low[1] : high[1], low[0] : high[0]] = inside
    return mask
