"""What surrounds the target, as a small map of directions: for earthshine and reflections."""

from __future__ import annotations

from functools import cache

import cv2
import numpy as np

from macram.data.geometry import Floats
from macram.data.render.earth import Earth
from macram.data.render.patches import Floats32

MAP = 64
"""Rows and columns of the octahedral map."""
_COARSE = 16
_ROW = 256
_LOBE = 10
"""Power of the cosine that stands for a rough reflection."""


@cache
def _directions(size: int) -> Floats32:
    """``[size, size, 3]`` unit vectors of an octahedral map's cells."""
    axis = (np.arange(size, dtype=np.float32) + 0.5) * (2 / size) - 1
    x, y = np.meshgrid(axis, axis)
    z = 1 - np.abs(x) - np.abs(y)
    fold = np.maximum(-z, 0)
    vectors = np.stack([x - np.sign(x) * fold, y - np.sign(y) * fold, z], axis=2)
    return np.asarray(vectors / np.linalg.norm(vectors, axis=2, keepdims=True), np.float32)


class Surround:
    """Light from the Earth on the target during one sequence.

    Args:
        earth: of the sequence.
        drift: ``[2]`` of its middle frame, km.
    """

    def __init__(self, earth: Earth, drift: Floats) -> None:
        self.sharp = cv2.GaussianBlur(earth.radiance(_directions(MAP), drift, 60.0), (3, 3), 0.8)
        self._vectors = _directions(MAP).reshape(-1, 3)
        # The cells of the map are not equal: solid angle falls with the cube of the octahedron's radius.
        weight = np.abs(self._vectors).sum(axis=1) ** 3
        weight *= 4 * np.pi / weight.sum()
        self._light = np.asarray(self.sharp, np.float32).reshape(-1, 3) * weight[:, None]
        lobe = np.maximum(_directions(_COARSE).reshape(-1, 3) @ self._vectors.T, 0) ** _LOBE
        rough = (lobe @ self._light * np.float32((_LOBE + 1) / (2 * np.pi))).reshape(_COARSE, _COARSE, 3)
        self.rough = cv2.resize(rough, (MAP, MAP), interpolation=cv2.INTER_LINEAR)

    def irradiance(self, normals: Floats) -> Floats32:
        """``[M, 3]`` light that falls on faces with these world normals ``[M, 3]``."""
        return np.asarray(np.maximum(normals.astype(np.float32) @ self._vectors.T, 0) @ self._light)

    def reflection(self, directions: Floats32, rough: Floats32) -> Floats32:
        """``[N, 3]`` light from the world directions ``[N, 3]``, blurred for rougher surfaces."""
        d = directions / np.abs(directions).sum(axis=1, keepdims=True)
        fold = np.maximum(-d[:, 2], 0)
        place = np.zeros(
            (2, -(-len(d) // _ROW) * _ROW), np.float32
        )  # whole rows: remap limits a picture's width
        for i in (0, 1):
            place[i, : len(d)] = (d[:, i] + np.sign(d[:, i]) * fold + 1) * np.float32(MAP / 2) - np.float32(
                0.5
            )
        column, row = place.reshape(2, -1, _ROW)
        sharp, soft = (
            cv2.remap(level, column, row, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE).reshape(-1, 3)[
                : len(d)
            ]
            for level in (self.sharp, self.rough)
        )
        blend = np.clip(rough * 2.2, 0, 1)[:, None]
        return np.asarray(sharp + blend * (soft - sharp), np.float32)
