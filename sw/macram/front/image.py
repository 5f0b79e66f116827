"""Reading a picture for the network."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import torch
from numpy.typing import NDArray
from PIL import Image, UnidentifiedImageError
from torch import Tensor

IMAGE_SIZE = 512
"""The network's input is square, this many pixels a side."""
MODES = ("1", "L", "LA", "P", "RGB", "RGBA", "CMYK", "YCbCr")
"""Pillow modes of 8 bits per channel; deeper ones would be clipped, not scaled, by a conversion to RGB."""
IMAGENET_MEAN = (0.485, 0.456, 0.406)
IMAGENET_STD = (0.229, 0.224, 0.225)


def read_image(path: Path, size: int = IMAGE_SIZE) -> NDArray[np.uint8]:
    """A PNG or JPEG as RGB ``[size, size, 3]``, 0..255.

    The longer side is scaled to ``size``; a picture that is not square is centred on black, never stretched,
    so that one scale serves both axes.

    Raises:
        ValueError: the file is missing, is no picture, or has more than 8 bits per channel.
    """
    try:
        with Image.open(path) as picture:
            picture.load()
            if picture.mode not in MODES:
                raise ValueError(
                    f"{path}: pixels must have 8 bits per channel, not mode {picture.mode}; convert it"
                )
            rgb = picture.convert("RGB")
    except FileNotFoundError as error:
        raise ValueError(f"{path}: no such image") from error
    except UnidentifiedImageError as error:
        raise ValueError(f"{path}: is not a picture that can be read; give a PNG or JPEG") from error
    except (OSError, SyntaxError, Image.DecompressionBombError) as error:
        raise ValueError(f"{path}: cannot be read ({error}); give a PNG or JPEG") from error
    scale = size / max(rgb.size)
    width, height = (max(1, round(side * scale)) for side in rgb.size)
    if rgb.size != (width, height):
        rgb = rgb.resize((width, height), Image.Resampling.LANCZOS)
    square = Image.new("RGB", (size, size))
    square.paste(rgb, ((size - width) // 2, (size - height) // 2))
    return np.asarray(square)


def normalise(picture: NDArray[np.uint8]) -> Tensor:
    """RGB ``[H, W, 3]`` -> float32 ``[3, H, W]`` with ImageNet's mean 0 and deviation 1 per channel."""
    scaled = torch.from_numpy(picture.astype(np.float32) / 255).permute(2, 0, 1)
    mean, std = (torch.tensor(values).reshape(3, 1, 1) for values in (IMAGENET_MEAN, IMAGENET_STD))
    return ((scaled - mean) / std).contiguous()
