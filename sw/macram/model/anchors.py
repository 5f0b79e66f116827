"""Cells, anchors and the coding of keypoints as offsets from them, in float32 pixels."""

from __future__ import annotations

import torch
from torch import Tensor

from macram.model.config import Levels


def map_sizes(height: int, width: int, levels: int = 5) -> tuple[tuple[int, int], ...]:
    """Rows and columns of the maps P3, P4, ... of an image: every strided convolution halves, rounding up.

    ``(64, 64)`` to ``(4, 4)`` at 512 x 512; 120, 60, 30, 15, 8 a side at 960 x 960.
    """
    return tuple((-(-height // (8 << k)), -(-width // (8 << k))) for k in range(levels))


def cell_centres(rows: int, columns: int, stride: int, device: torch.device | None = None) -> Tensor:
    """Centres of a level's cells in pixels, ``[rows, columns, 2]`` as (x, y): ``stride * (index + 0.5)``."""
    y = (torch.arange(rows, device=device, dtype=torch.float32) + 0.5) * stride
    x = (torch.arange(columns, device=device, dtype=torch.float32) + 0.5) * stride
    grid_y, grid_x = torch.meshgrid(y, x, indexing="ij")
    return torch.stack((grid_x, grid_y), dim=-1)


def decode(offsets: Tensor, level: int, levels: Levels) -> Tensor:
    """Offsets of a level -> keypoints in pixels.

    Args:
        offsets: ``[N, 2K, H, W]``, all x then all y, in anchor sides.
        level: 0 is P3.
        levels: strides and anchors.

    Returns:
        ``[N, H, W, K, 2]`` as (x, y).
    """
    n, both, rows, columns = offsets.shape
    centres = cell_centres(rows, columns, levels.strides[level], offsets.device)
    pairs = offsets.float().reshape(n, 2, both // 2, rows, columns).permute(0, 3, 4, 2, 1)
    return pairs * levels.anchors[level] + centres[:, :, None]


def encode(keypoints: Tensor, level: int, levels: Levels, size: tuple[int, int]) -> Tensor:
    """Keypoints in pixels -> the offsets that every cell of a level should predict; inverse of `decode`.

    Args:
        keypoints: ``[N, K, 2]`` as (x, y).
        level: 0 is P3.
        levels: strides and anchors.
        size: rows and columns of the level's map.

    Returns:
        ``[N, 2K, H, W]``, all x then all y, in anchor sides.
    """
    centres = cell_centres(*size, levels.strides[level], keypoints.device)
    pairs = (keypoints[:, None, None] - centres[:, :, None]) / levels.anchors[level]  # [N, H, W, K, 2]
    return pairs.permute(0, 4, 3, 1, 2).flatten(1, 2)
