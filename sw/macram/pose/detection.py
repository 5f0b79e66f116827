"""One pose per image: candidates, pairs, RANSAC."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from numpy.typing import ArrayLike

from macram.pose.correspond import CONFIDENCE, LevelCells, select_candidates
from macram.pose.pnp import RansacSettings, solve_pnp
from macram.pose.rigid import Pose


@dataclass(frozen=True, slots=True, eq=False)
class Detection:
    """A pose with its evidence.

    Attributes:
        pose: object to camera, mm.
        score: confidence of the best voting cell, 0..1.
        cells: voting cells.
        pairs: 2D-3D pairs they gave.
        inliers: pairs that agree with the pose.
        rms_px: reprojection error of those, px of the network's input.
    """

    pose: Pose
    score: float
    cells: int
    pairs: int
    inliers: int
    rms_px: float

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON, poses under BOP's names (row-wise, mm)."""
        return {
            "cam_R_m2c": self.pose.R.ravel().tolist(),
            "cam_t_m2c": self.pose.t.ravel().tolist(),
            "score": self.score,
            "cells": self.cells,
            "pairs": self.pairs,
            "inliers": self.inliers,
            "rms_px": self.rms_px,
        }


def detect(
    levels: Sequence[LevelCells],
    anchors: Sequence[float],
    keypoints: ArrayLike,
    K: ArrayLike,
    *,
    confidence: float = CONFIDENCE,
    settings: RansacSettings | None = None,
    published: bool = False,
) -> Detection | None:
    """Pose of the one object in an image, or None.

    The pose needs no conversion between the network's input and the original picture: a resize belongs into
    ``K``, the pose stays.

    Args:
        levels: decoded outputs of the pyramid levels.
        anchors: anchor size of each level, px.
        keypoints: ``[k, 3]`` model points the network predicts, mm.
        K: ``[3, 3]`` intrinsics of the network's input.
        confidence: lowest probability of a voting cell.
        settings: of the solver.
        published: as in `select_candidates`; the solver's refinement is set by ``settings``.

    Raises:
        ValueError: shapes do not fit each other.
    """
    candidates = select_candidates(levels, anchors, confidence=confidence, published=published)
    if candidates is None:
        return None
    model, pixels = candidates.pairs(keypoints)
    result = solve_pnp(model, pixels, K, settings)
    if result is None:
        return None
    return Detection(
        pose=result.pose,
        score=float(candidates.confidence.max()),
        cells=len(candidates.points),
        pairs=len(model),
        inliers=int(result.inliers.sum()),
        rms_px=result.rms_px,
    )
