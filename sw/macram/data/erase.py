"""The counterfactual picture: the target blacked out."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

GROWTH = 5
"""Side of the square by which the mask grows first, so that no rim of the target is left."""


def erase(image: NDArray[np.uint8], mask: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """A copy of ``[H, W, 3]`` with black where the ``[H, W]`` mask, grown by a 5x5 square, is set."""
    square = np.ones((GROWTH, GROWTH), np.uint8)
    grown = cv2.dilate(mask.astype(np.uint8), square)
    result = image.copy()
    result[np.asarray(grown) > 0] = 0
    return result
