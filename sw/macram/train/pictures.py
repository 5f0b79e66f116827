"""Training views on the CPU in one pass over memory, by compiled code."""

from __future__ import annotations

from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from macram.front.image import IMAGENET_MEAN, IMAGENET_STD
from macram.pose.warp import BORDER
from macram.train.compiled import call, library
from macram.train.views import Views

MEAN, DEVIATION = (255 * torch.tensor(value) for value in (IMAGENET_MEAN, IMAGENET_STD))
"""Of ImageNet's colours, grey levels, ``[3]``: what pictures are normalised by."""


def pictures_compiled() -> bool:
    """Whether `draw_pictures` and `seen_mask` can be used here."""
    return library("pictures") is not None


def draw_pictures(pixels: NDArray[np.uint8], views: Views, bank: Tensor, stride: int, image: Tensor) -> None:
    """Draws the views: bilinear, toned, with noise, rounded to whole grey levels, normalised.

    Args:
        pixels: packed frames, ``[N, H, W, 4]``.
        views: which, from where, in what light.
        bank: of noise, float32.
        stride: values of it between the places where noise may start.
        image: float32 ``[B, 3, h, w]``, channels last; written.
    """
    assert image.is_contiguous(memory_format=torch.channels_last)
    count, _, rows, columns = image.shape
    call(
        "pictures",
        "pictures",
        *(count, rows, columns, torch.get_num_threads()),
        *_frames(pixels, views),
        *(_places(views), views.tone.astype(np.float32), bank, views.noise * stride, float(BORDER)),
        *(MEAN, DEVIATION, image),
    )


def seen_mask(pixels: NDArray[np.uint8], views: Views, sampled: Tensor) -> Tensor:
    """The packed mask, uint8 ``[B, cells]``, at ``sampled`` ``[cells, 2]`` pixels of each view; 0 off the frame."""
    result = torch.empty((len(views.frame), len(sampled)), dtype=torch.uint8)
    call("pictures", "masks", *result.shape, *_frames(pixels, views), _places(views), sampled, result)
    return result


def _frames(pixels: NDArray[np.uint8], views: Views) -> tuple[NDArray[Any], NDArray[Any], int, int]:
    if pixels.shape[3] != 4 or not 0 <= views.frame.min() <= views.frame.max() < len(pixels):
        raise ValueError(f"frames {views.frame.tolist()} of packed pixels {pixels.shape} cannot be read")
    return pixels, views.frame, pixels.shape[1], pixels.shape[2]


def _places(views: Views) -> NDArray[np.float32]:
    """View to frame, ``[B, 2, 3]``."""
    return np.linalg.inv(views.matrix)[:, :2].astype(np.float32)
