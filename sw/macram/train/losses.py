"""The losses of CA-SpaceNet, as pure functions of predictions and targets.

Class and pose losses are sums over cells and images, as published: the batch size belongs to the learning
rate. Everything is computed in float32, whatever the network's precision. No shape depends on a value, so that a
GPU can work through them without the host.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import torch
from torch import Tensor
from torch.nn import functional

from macram.train.targets import BACKGROUND, MISSED, POSITIVE, sight

FOCAL_GAMMA = 2
FOCAL_ALPHA = 0.25
PROBABILITY_FLOOR = 1e-6
SQUARES_FLOOR = 1e-6
POSE_SCALE = 50.0
"""Puts the knee of the pose loss at 1/50 of the diameter; the published SPEED code has 200."""


@dataclass(frozen=True, slots=True)
class LossWeights:
    """Factors of the summed losses.

    Attributes:
        classes: of `focal_loss`.
        pose: of `object_space_loss`.
        similarity: of `similarity_loss`; 0.25 in the paper, 1 in the published SwissCube code.
        surface: of the training-only head's loss; departs from the paper.
        imitation: of `imitation_loss`; read where there is a teacher.
        pose_scale: see `POSE_SCALE`; read by the pose loss.

    Raises:
        ValueError: a factor below 0, a scale of 0, or no number.
    """

    classes: float = 0.01
    pose: float = 0.1
    similarity: float = 0.25
    surface: float = 0.1
    imitation: float = 1.0
    pose_scale: float = POSE_SCALE

    def __post_init__(self) -> None:
        for name in ("classes", "pose", "similarity", "surface", "imitation"):
            if not 0 <= getattr(self, name) < math.inf:
                raise ValueError(f"loss.{name} must be a number of at least 0, not {getattr(self, name)!r}")
        if not 0 < self.pose_scale < math.inf:
            raise ValueError(f"loss.pose_scale must be above 0, not {self.pose_scale!r}")


def focal_loss(logits: Tensor, labels: Tensor) -> Tensor:
    """Sum of the sigmoid focal loss (gamma 2, alpha 0.25) over all cells that are not ignored.

    With p the object probability, clipped to 1e-6 from both ends: ``-0.25 (1 - p)^2 log p`` for a positive
    cell, ``-0.75 p^2 log(1 - p)`` for background.

    Args:
        logits: any shape.
        labels: the same shape; `POSITIVE`, `BACKGROUND`, anything else is ignored.
    """
    _same_shape("labels", labels, logits)
    p = torch.sigmoid(logits.float()).clamp(PROBABILITY_FLOOR, 1 - PROBABILITY_FLOOR)
    positive = -FOCAL_ALPHA * (1 - p) ** FOCAL_GAMMA * torch.log(p)
    background = -(1 - FOCAL_ALPHA) * p**FOCAL_GAMMA * torch.log1p(-p)
    return (positive * (labels == POSITIVE) + background * (labels == BACKGROUND)).sum()


def object_space_loss(
    pixels: Tensor, points: Tensor, intrinsics: Tensor, diameter: Tensor | float, scale: float = POSE_SCALE
) -> Tensor:
    """Pose loss in object space: how far each true point lies from the line of sight of its predicted pixel.

    The predicted pixel's ray is ``b = K^-1 [u, v, 1]``; the true point's foot on it, ``b (b.P) / (b.b)``, is
    compared with the point, per coordinate, by a Huber loss of ``scale * (foot - P) / diameter``, over
    ``scale``. Mean over a cell's coordinates, sum over cells. No depth is predicted.

    Args:
        pixels: ``[M, K, 2]``, predicted keypoints of M positive cells; M may be 0.
        points: ``[M, K, 3]``, true keypoints in the camera frame, any unit.
        intrinsics: ``[M, 3, 3]`` or ``[3, 3]``, camera matrix after augmentation.
        diameter: of the object, in the unit of ``points``; one, or ``[M]``.
        scale: see `POSE_SCALE`.

    Raises:
        ValueError: shapes do not agree.
    """
    if pixels.shape[:-1] != points.shape[:-1] or pixels.shape[-1] != 2 or points.shape[-1] != 3:
        raise ValueError(
            "pixels must be [M, K, 2] and points [M, K, 3], "
            f"not {list(pixels.shape)} and {list(points.shape)}"
        )
    rays, points = sight(pixels.float(), intrinsics.float()[..., None, :, :]), points.float()
    foot = rays * ((rays * points).sum(-1, keepdim=True) / (rays * rays).sum(-1, keepdim=True))
    unit = scale / (diameter.float().reshape(-1, 1, 1) if isinstance(diameter, Tensor) else diameter)
    cost = functional.smooth_l1_loss(foot * unit, points * unit, reduction="none", beta=1.0) / scale
    return cost.sum() / (points.shape[-2] * 3)


def similarity_loss(pseudo: tuple[Tensor, ...], counterfactual: tuple[Tensor, ...]) -> Tensor:
    """Sum over the levels of the mean smooth-L1 distance (beta 1); only ``pseudo`` learns.

    Args:
        pseudo: one ``[N, C, H, W]`` per level.
        counterfactual: the same shapes; taken as constants.
    """
    terms = [
        functional.smooth_l1_loss(mine.float(), goal.detach().float(), beta=1.0)
        for mine, goal in zip(pseudo, counterfactual, strict=True)
    ]
    return torch.stack(terms).sum()


def imitation_loss(student: Sequence[Tensor], teacher: Sequence[Tensor], inside: Sequence[Tensor]) -> Tensor:
    """Sum over images of how far the features are from a teacher's, relative to these: 0 if equal.

    Per image and level the squared distance over the teacher's squares, once over all cells and once over those on
    the target, which are few and carry the pose; mean over both and over the levels. A level without a cell on the
    target counts 0 there, as does one where the teacher has nothing but zeros.

    Args:
        student: one ``[N, C, H, W]`` per level.
        teacher: the same shapes; taken as constants.
        inside: bool ``[N, H * W]`` per level, cells on the target.
    """
    terms = []
    for mine, theirs, on in zip(student, teacher, inside, strict=True):
        goal = theirs.detach().float()
        apart = (mine.float() - goal).square().sum(1).flatten(1)
        squares = goal.square().sum(1).flatten(1)
        for distances, whole in (
            (apart.sum(1), squares.sum(1)),
            ((apart * on).sum(1), (squares * on).sum(1)),
        ):
            terms.append(distances / whole.clamp_min(SQUARES_FLOOR) * (whole > 0))
    return torch.stack(terms).mean(0).sum()


def surface_loss(outputs: Tensor, faces: Tensor, coordinates: Tensor) -> Tensor:
    """Loss of the training-only surface head, sum over cells: cross entropy of the face, L1 of the point.

    Args:
        outputs: ``[M, 9]``, six face logits and the object coordinate in half extents.
        faces: int64 ``[M]``, 0..5; -1 where the cell's ray misses the box, which does not count.
        coordinates: ``[M, 3]``, -1..1.
    """
    outputs = outputs.float()
    face = functional.cross_entropy(outputs[:, :6], faces, ignore_index=MISSED, reduction="sum")
    apart = (outputs[:, 6:] - coordinates.float()).abs()
    return face + apart.masked_fill(faces[:, None] == MISSED, 0.0).sum()


def _same_shape(name: str, tensor: Tensor, like: Tensor) -> None:
    if tensor.shape != like.shape:
        raise ValueError(f"{name} must be {list(like.shape)}, not {list(tensor.shape)}")
