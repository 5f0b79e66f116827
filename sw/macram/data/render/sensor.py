"""From radiance to bytes: exposure, bloom, blur of the optics, noise, response; and a field of stars."""

from __future__ import annotations

from functools import cache

import cv2
import numpy as np
from numpy.typing import NDArray

from macram.data.render.patches import Floats32

BLUR_PIXELS = 0.45
BLOOM_SHARE = 0.018
FULL_WELL = 9000.0
"""Electrons at signal 1."""
READ_NOISE = 9.0
"""Electrons."""
GAIN_LIMITS = (0.8, 60.0)
STARS = 9000
_STEPS = 4096


def gain(scene: Floats32, target: Floats32) -> float:
    """Automatic exposure: bright parts of target and background near the top of the curve.

    Args:
        scene: ``[H, W, 3]`` radiance of the picture.
        target: ``[N, 3]`` radiance of the target's pixels; may be empty.
    """
    weights = np.array([0.30, 0.55, 0.15], np.float32)
    level = 0.68 * float(np.quantile(scene[::4, ::4] @ weights, 0.97))
    if len(target):
        level = max(level, 0.9 * float(np.quantile(target @ weights, 0.88)))
    return float(np.clip(0.75 / max(level, 1e-6), *GAIN_LIMITS))


def grain(shape: tuple[int, int], seed: int) -> Floats32:
    """``[H, W, 3]`` standard normal noise."""
    return np.random.default_rng(seed).standard_normal((*shape, 3), np.float32)


def develop(radiance: Floats32, exposure: float, noise: Floats32) -> NDArray[np.uint8]:
    """``[H, W, 3]`` radiance -> sRGB bytes; the same ``noise`` makes twins comparable."""
    signal = radiance * np.float32(exposure)
    height, width = signal.shape[:2]
    signal = np.asarray(cv2.GaussianBlur(signal, (5, 5), BLUR_PIXELS), np.float32)
    small = cv2.resize(
        np.minimum(signal, 6), (max(width // 8, 1), max(height // 8, 1)), interpolation=cv2.INTER_AREA
    )
    halo = cv2.resize(cv2.GaussianBlur(small, (0, 0), 1.6), (width, height), interpolation=cv2.INTER_LINEAR)
    signal += np.float32(BLOOM_SHARE) * halo
    spread = np.sqrt(
        np.maximum(signal, 0) * np.float32(1 / FULL_WELL) + np.float32((READ_NOISE / FULL_WELL) ** 2)
    )
    signal += spread * noise
    index = np.clip(signal * np.float32(_STEPS / 4), 0, _STEPS - 1).astype(np.int32)
    return np.asarray(_response()[index])


@cache
def _response() -> NDArray[np.uint8]:
    """Bytes for signals 0 to 4: straight up to 0.6, then a shoulder to white, then the sRGB curve."""
    x = (np.arange(_STEPS) + 0.5) * 4 / _STEPS
    knee = 0.6
    curved = np.where(x < knee, x, knee + (1 - knee) * (1 - np.exp(-(x - knee) / (1 - knee))))
    srgb = np.where(curved <= 0.0031308, 12.92 * curved, 1.055 * curved ** (1 / 2.4) - 0.055)
    return np.asarray(np.rint(np.clip(srgb, 0, 1) * 255), np.uint8)


class Stars:
    """A sky of its own: uniform directions, ten to the half more stars per magnitude."""

    def __init__(self, seed: int) -> None:
        random = np.random.default_rng([seed, 7])
        vectors = random.standard_normal((STARS, 3))
        self.directions = vectors / np.linalg.norm(vectors, axis=1, keepdims=True)
        magnitude = 7.0 + 2 * np.log10(1 - random.random(STARS))
        self.flux = 10 ** (-0.4 * magnitude)
        warmth = random.uniform(-0.25, 0.25, STARS)
        self.colour = np.stack([1 + warmth, np.ones(STARS), 1 - warmth], axis=1)

    def add(
        self, picture: Floats32, camera: NDArray[np.float64], grid: NDArray[np.float64], brightness: float
    ) -> None:
        """Splat into ``[H, W, 3]``, only where it is dark.

        Args:
            picture: radiance, changed in place.
            camera: ``[3, 3]`` world to camera.
            grid: ``[3, 3]`` camera to pixels, centres at whole numbers.
            brightness: radiance of a pixel that holds a star of magnitude 0.
        """
        height, width = picture.shape[:2]
        seen = self.directions @ (grid @ camera).T
        ahead = np.flatnonzero(seen[:, 2] > 0.05)
        place = seen[ahead, :2] / seen[ahead, 2:]
        inside = ((place >= 0) & (place < [width - 1, height - 1])).all(axis=1)
        place, chosen = place[inside], ahead[inside]
        corner = np.floor(place).astype(int)
        part = place - corner
        light = brightness * self.flux[chosen, None] * self.colour[chosen]
        for dy in (0, 1):
            for dx in (0, 1):
                x, y = corner[:, 0] + dx, corner[:, 1] + dy
                share = np.abs(1 - dx - part[:, 0]) * np.abs(1 - dy - part[:, 1])
                dark = picture[y, x].max(axis=1) < 0.002
                np.add.at(picture, (y, x), (light * (share * dark)[:, None]).astype(np.float32))
