"""From network outputs to 2D-3D pairs: decoding, candidate quota per level, selection."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from macram.pose.rigid import Floats

TOTAL = 10
CONFIDENCE = 0.3


@dataclass(frozen=True, slots=True, eq=False)
class LevelCells:
    """What one pyramid level says about every cell.

    Attributes:
        probability: ``[cells]`` object probability, 0..1.
        points: ``[cells, keypoints, 2]`` predicted pixels.
    """

    probability: Floats
    points: Floats

    def __post_init__(self) -> None:
        if (
            self.points.ndim != 3
            or self.points.shape[2] != 2
            or self.probability.shape != self.points.shape[:1]
        ):
            raise ValueError(
                "a level needs probability [cells] and points [cells, keypoints, 2], not "
                f"{list(self.probability.shape)} and {list(self.points.shape)}"
            )


@dataclass(frozen=True, slots=True, eq=False)
class Candidates:
    """The cells that vote for the pose, best first within a level.

    Attributes:
        points: ``[n, keypoints, 2]`` predicted pixels.
        confidence: ``[n]`` square root of the probability, as the network's score is defined.
        level: ``[n]`` level of each cell, counted from 0.
        cell: ``[n]`` index of each cell within its level, row by row.
        size: object size S that set the quota, px.
        quota: ``[levels]`` cells granted to each level.
    """

    points: Floats
    confidence: Floats
    level: NDArray[np.int64]
    cell: NDArray[np.int64]
    size: float
    quota: NDArray[np.int64]

    def pairs(self, keypoints: ArrayLike) -> tuple[Floats, Floats]:
        """All pairs: ``[n * k, 3]`` model points (mm) and ``[n * k, 2]`` pixels.

        Raises:
            ValueError: ``keypoints`` is not ``[k, 3]`` with the k of the network.
        """
        model = np.asarray(keypoints, np.float64)
        count = self.points.shape[1]
        if model.shape != (count, 3):
            raise ValueError(f"the network predicts {count} keypoints, the model has {list(model.shape)}")
        return np.tile(model, (len(self.points), 1)), self.points.reshape(-1, 2)


def decode(logits: ArrayLike, offsets: ArrayLike, stride: int, anchor: float) -> LevelCells:
    """Cells of one level from the raw head outputs.

    Args:
        logits: ``[1, height, width]`` or ``[height, width]`` class outputs before the sigmoid.
        offsets: ``[2 k, height, width]`` pose outputs in units of the anchor: k x offsets, then k y offsets.
        stride: pixels per cell; the centre of cell i is ``stride * (i + 0.5)``.
        anchor: anchor size, px.

    Raises:
        ValueError: the two maps do not fit each other.
    """
    raw = np.asarray(offsets, np.float64)
    score = np.asarray(logits, np.float64)
    if raw.ndim != 3 or raw.shape[0] % 2 or score.size != raw[0].size:
        raise ValueError(f"class output {list(score.shape)} and pose output {list(raw.shape)} do not fit")
    _, height, width = raw.shape
    offset = raw.reshape(2, -1, height * width).transpose(2, 1, 0)
    y, x = np.divmod(np.arange(height * width), width)
    centre = stride * (np.stack([x, y], axis=1) + 0.5)
    # tanh has no overflow, unlike exp of a large negative logit.
    probability = 0.5 * (1.0 + np.tanh(0.5 * score.reshape(-1)))
    return LevelCells(probability, offset * anchor + centre[:, None])


def level_quota(
    size: ArrayLike, anchors: ArrayLike, *, total: int = TOTAL, spread: float = 1.0
) -> NDArray[np.int64]:
    """How many cells each level may give for an object of ``size`` px.

    ``floor(total * w_k / sum w + 0.5)`` with ``w_k = exp(-spread * log2(size / anchor_k)^2)``. Rounding makes
    the sum ``total`` give or take one.

    Args:
        size: ``[...]`` object sizes, px, above 0.
        anchors: ``[levels]`` anchor sizes, px.
        total: cells over all levels.
        spread: how sharply the quota falls with the distance in octaves.

    Returns:
        ``[..., levels]`` counts.

    Raises:
        ValueError: a size or an anchor is not above zero.
    """
    sizes, steps = np.asarray(size, np.float64), np.asarray(anchors, np.float64)
    if not (np.all(sizes > 0) and np.all(np.isfinite(sizes)) and np.all(steps > 0)):
        raise ValueError(f"sizes must be above 0 px: size {sizes.tolist()}, anchors {steps.tolist()}")
    exponent = spread * np.log2(sizes[..., None] / steps) ** 2
    # Only ratios count: the subtraction keeps the largest weight at 1 however far the size is off.
    weight = np.exp(exponent.min(axis=-1, keepdims=True) - exponent)
    share: Floats = total * weight / weight.sum(axis=-1, keepdims=True)
    return np.asarray(np.floor(share + 0.5), np.int64)


def select_candidates(
    levels: Sequence[LevelCells],
    anchors: Sequence[float],
    *,
    confidence: float = CONFIDENCE,
    total: int = TOTAL,
    spread: float = 1.0,
    published: bool = False,
) -> Candidates | None:
    """Pick the voting cells of one image; None if no cell is confident enough.

    The object size is read from the most confident cell of all levels; it sets the quota; each level gives
    its most confident cells. Where the quota points at levels without a confident cell, the most confident
    cells of the other levels stand in.

    Args:
        levels: outputs, one per anchor.
        anchors: anchor sizes, px.
        confidence: cells need a probability above this.
        total: as in `level_quota`.
        spread: as in `level_quota`.
        published: reproduce two habits of the published code: while the levels are scanned the size never
            shrinks, even if a more confident cell says so; and nothing stands in for an empty level.

    Raises:
        ValueError: the numbers of levels and anchors differ.
    """
    if len(levels) != len(anchors):
        raise ValueError(f"{len(levels)} levels need as many anchor sizes, not {len(anchors)}")
    ranked = [_ranked(level, confidence) for level in levels]
    size = _object_size(levels, ranked, published)
    if size is None:
        return None
    quota = level_quota(size, anchors, total=total, spread=spread)
    chosen = [(k, cell) for k, cells in enumerate(ranked) for cell in cells[: quota[k]]]
    if not chosen and not published:
        rest = [(-levels[k].probability[cell], k, cell) for k, cells in enumerate(ranked) for cell in cells]
        chosen = [(k, cell) for _, k, cell in sorted(rest)[:total]]
    if not chosen:
        return None
    return Candidates(
        points=np.stack([levels[k].points[cell] for k, cell in chosen]),
        confidence=np.sqrt([levels[k].probability[cell] for k, cell in chosen]),
        level=np.array([k for k, _ in chosen], np.int64),
        cell=np.array([cell for _, cell in chosen], np.int64),
        size=size,
        quota=quota,
    )


def _ranked(level: LevelCells, confidence: float) -> list[int]:
    """Confident cells of one level, best first, ties in cell order; cells with non-finite points are out."""
    usable = (level.probability > confidence) & np.isfinite(level.points).all(axis=(1, 2))
    cells = np.flatnonzero(usable)
    return [int(c) for c in cells[np.argsort(-level.probability[cells], kind="stable")]]


def _object_size(levels: Sequence[LevelCells], ranked: Sequence[list[int]], published: bool) -> float | None:
    """Longer side of the keypoint box of the most confident cell, px; None without one of positive size."""
    best, size = 0.0, 0.0
    for level, cells in zip(levels, ranked, strict=True):
        if cells and level.probability[cells[0]] > best:
            best = float(level.probability[cells[0]])
            side = float(np.ptp(level.points[cells[0]], axis=0).max())
            size = max(size, side) if published else side
    return size if size > 0 else None
