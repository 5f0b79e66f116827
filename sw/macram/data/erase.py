"""The counterfactual picture: the target blacked out."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

GROWTH = 2
"""Pixels by which the mask grows on each side first, so that no rim of the target is left."""


def grow(mask: NDArray[np.bool_], pixels: int = GROWTH) -> NDArray[np.bool_]:
    """The mask with a border of ``pixels`` on each side of it (published: 2, a 5x5 square)."""
    side = 2 * pixels + 1
    return np.asarray(cv2.dilate(mask.view(np.uint8), np.ones((side, side), np.uint8))) > 0


def erase(image: NDArray[np.uint8], mask: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """A copy of ``[H, W, 3]`` with black where the grown ``[H, W]`` mask is set."""
    result = image.copy()
    result[grow(mask)] = 0
    return result
