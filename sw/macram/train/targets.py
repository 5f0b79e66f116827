"""Which cells learn what: quotas per level, random draw of positive cells, targets of the surface head."""

from __future__ import annotations

import torch
from torch import Tensor

from macram.model.anchors import cell_centres, map_sizes
from macram.model.config import Levels
from macram.pose.correspond import TOTAL, level_quota

POSITIVE, BACKGROUND, IGNORED = 1, 0, -1
MISSED = -1
"""Face of a ray that meets no face."""
QUOTA = TOTAL
"""Positive cells of one object, over all levels, before rounding: as many as are read at inference."""


def target_size(keypoints: Tensor) -> float:
    """Longer side of the box around projected keypoints ``[K, 2]``, plus one pixel."""
    extent = keypoints.amax(0) - keypoints.amin(0)
    return float(extent.max()) + 1.0


def cells_in_mask(mask: Tensor, stride: int, size: tuple[int, int]) -> Tensor:
    """Cells whose centre pixel lies in the mask.

    Args:
        mask: bool ``[H, W]``.
        stride: of the level.
        size: rows and columns of the level's map; centres beyond the image count as its border.

    Returns:
        bool ``[rows, columns]``.
    """
    centres = cell_centres(*size, stride, mask.device).to(torch.int64)  # truncated
    height, width = mask.shape
    return mask[centres[..., 1].clamp(max=height - 1), centres[..., 0].clamp(max=width - 1)]


def draw_labels(
    mask: Tensor, keypoints: Tensor, levels: Levels, generator: torch.Generator
) -> tuple[Tensor, ...]:
    """Labels of every cell for one object.

    Of the cells in the mask each level draws its quota (or all, if there are fewer), uniformly and without
    replacement: `POSITIVE`. The others in the mask are `IGNORED`, those outside `BACKGROUND`.

    Args:
        mask: bool ``[H, W]``, the visible object at network resolution.
        keypoints: ``[K, 2]``, projected true keypoints, pixels.
        levels: strides and anchors.
        generator: on the CPU; decides everything random here.

    Returns:
        int8 ``[rows, columns]`` per level.
    """
    quotas = level_quota(target_size(keypoints), levels.anchors).tolist()
    sizes = map_sizes(mask.shape[0], mask.shape[1], len(levels.strides))
    labels = []
    for stride, size, quota in zip(levels.strides, sizes, quotas, strict=True):
        inside = cells_in_mask(mask, stride, size).flatten()
        candidates = inside.nonzero().flatten()
        order = torch.randperm(len(candidates), generator=generator)[:quota].to(candidates.device)
        level = torch.where(inside, IGNORED, BACKGROUND).to(torch.int8)
        level[candidates[order]] = POSITIVE
        labels.append(level.reshape(size))
    return tuple(labels)


def draw_batch_labels(
    masks: Tensor, keypoints: Tensor, levels: Levels, generator: torch.Generator
) -> tuple[Tensor, ...]:
    """`draw_labels` of every picture of a batch, one object each.

    Args:
        masks: bool ``[N, H, W]``.
        keypoints: ``[N, K, 2]``.
        levels: strides and anchors.
        generator: see `draw_labels`.

    Returns:
        int8 ``[N, 1, rows, columns]`` per level, shaped like the head's logits.
    """
    pictures = [draw_labels(m, k, levels, generator) for m, k in zip(masks, keypoints, strict=True)]
    return tuple(torch.stack(level)[:, None] for level in zip(*pictures, strict=True))


def sight(pixels: Tensor, camera: Tensor) -> Tensor:
    """Pixels ``[..., 2]`` -> rays ``[..., 3]`` to the plane at depth 1; cameras ``[..., 3, 3]`` broadcast.

    By hand, as camera matrices are triangular: inverting each one would stop the GPU.
    """
    y = (pixels[..., 1] - camera[..., 1, 2]) / camera[..., 1, 1]
    x = (pixels[..., 0] - camera[..., 0, 2] - camera[..., 0, 1] * y) / camera[..., 0, 0]
    return torch.stack((x, y, torch.ones_like(x)), dim=-1)


def surface_targets(
    pixels: Tensor, rotation: Tensor, translation: Tensor, intrinsics: Tensor, low: Tensor, high: Tensor
) -> tuple[Tensor, Tensor]:
    """Where the ray through each pixel enters the object's box: which face, and the object coordinate.

    Args:
        pixels: ``[M, 2]`` as (x, y), for example cell centres.
        rotation: ``[M, 3, 3]`` or ``[3, 3]``, object to camera.
        translation: ``[M, 3]`` or ``[3]``, unit of the box.
        intrinsics: ``[M, 3, 3]`` or ``[3, 3]``.
        low: ``[3]``, the box's smallest corner in the object frame.
        high: ``[3]``, its largest corner.

    Returns:
        int64 ``[M]`` faces, ``2 * axis`` for the low and ``2 * axis + 1`` for the high side, -1 where the ray
        misses the box in front of the camera; and ``[M, 3]`` entry points in half extents from the centre,
        -1..1, zero where missed.
    """
    direction = (rotation.mT @ sight(pixels, intrinsics)[..., None]).squeeze(-1)
    origin = -(rotation.mT @ translation[..., None]).squeeze(-1).expand_as(direction)
    # A ray along a face divides by zero; the infinities that result compare as they should.
    to_low, to_high = (low - origin) / direction, (high - origin) / direction
    enter, leave = torch.minimum(to_low, to_high), torch.maximum(to_low, to_high)
    depth, axis = enter.max(-1)
    hit = (depth <= leave.amin(-1)) & (depth > 0)
    from_high = (direction.gather(-1, axis[:, None]) < 0).squeeze(-1)
    faces = (2 * axis + from_high).masked_fill(~hit, MISSED)
    entry = (origin + depth[:, None] * direction - (high + low) / 2) / ((high - low) / 2)
    return faces, entry.clamp(-1, 1).masked_fill(~hit[:, None], 0.0)
