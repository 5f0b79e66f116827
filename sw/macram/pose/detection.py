"""One pose per image: candidates, pairs, RANSAC; by a single look or with closer ones."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from macram.pose.correspond import CONFIDENCE, TOTAL, Candidates, LevelCells, select_candidates
from macram.pose.edges import EdgeSettings
from macram.pose.looks import LookSettings, See, look_closer, solve_together
from macram.pose.pnp import PnpResult, RansacSettings, solve_pnp
from macram.pose.rigid import Pose, camera_matrix
from macram.pose.warp import Image


@dataclass(frozen=True, slots=True, eq=False)
class Detection:
    """A pose with its evidence.

    Attributes:
        pose: object to camera, mm.
        score: confidence of the best voting cell, 0..1.
        cells: voting cells.
        pairs: 2D-3D pairs they gave.
        inliers: pairs that agree with the pose.
        rms_px: reprojection error of those, px of the network's input, before edges moved the pose.
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


@dataclass(frozen=True, slots=True)
class PoseSettings:
    """How the outputs of a network become a pose. The defaults are those of the recorded scores.

    Attributes:
        confidence: lowest probability of a voting cell.
        total: voting cells of a picture, about.
        published: as in `select_candidates`; the solver's refinement is set by ``ransac``.
        ransac: the solver.
        looks: crops around the first pose that the network sees as well; None for none.
        edges: alignment with the edges of the picture; None for none.
    """

    confidence: float = CONFIDENCE
    total: int = TOTAL
    published: bool = False
    ransac: RansacSettings = field(default_factory=RansacSettings)
    looks: LookSettings | None = None
    edges: EdgeSettings | None = None

    @property
    def words(self) -> str:
        """The solver in words, for reports."""
        parts = ["EPnP RANSAC"]
        if self.ransac.refine:
            parts.append("Levenberg-Marquardt")
        if self.looks is not None:
            parts.append(f"{self.looks.turns} second looks")
        if self.edges is not None:
            parts.append(f"edges of a box of {self.edges.box:g}")
        return " and ".join(parts) if len(parts) < 3 else ", ".join(parts)

    def to_dict(self) -> dict[str, Any]:
        """Every number, as a JSON file gives it back."""
        table: dict[str, Any] = json.loads(json.dumps(asdict(self)))
        return table

    def voters(self, levels: Sequence[LevelCells], anchors: Sequence[float]) -> Candidates | None:
        """The voting cells of one view."""
        return select_candidates(
            levels, anchors, confidence=self.confidence, total=self.total, published=self.published
        )


def detect(
    levels: Sequence[LevelCells],
    anchors: Sequence[float],
    keypoints: ArrayLike,
    K: ArrayLike,
    settings: PoseSettings | None = None,
) -> Detection | None:
    """Pose of the one object in an image by a single look, or None.

    The pose needs no conversion between the network's input and the original picture: a resize belongs into
    ``K``, the pose stays.

    Args:
        levels: decoded outputs of the pyramid levels.
        anchors: anchor size of each level, px.
        keypoints: ``[k, 3]`` model points the network predicts, mm.
        K: ``[3, 3]`` intrinsics of the network's input.
        settings: defaults if None; its ``looks`` and ``edges``, which need the picture, are not used here.

    Raises:
        ValueError: shapes do not fit each other.
    """
    settings = settings or PoseSettings()
    candidates = settings.voters(levels, anchors)
    if candidates is None:
        return None
    model, pixels = candidates.pairs(keypoints)
    result = solve_pnp(model, pixels, K, settings.ransac)
    return None if result is None else detection([candidates], result)


def detect_again(
    image: Image,
    levels: Sequence[LevelCells],
    anchors: Sequence[float],
    keypoints: ArrayLike,
    K: ArrayLike,
    see: See,
    settings: PoseSettings,
) -> Detection | None:
    """`detect`, then second looks at what was found, all cells voting together.

    Args:
        image: ``[H, W, 3]`` RGB, the network's input.
        levels: its outputs.
        anchors: as in `detect`.
        keypoints: as in `detect`.
        K: intrinsics of ``image``.
        see: the network: outputs of every picture of a list, all of one size.
        settings: with ``looks``.

    Returns:
        None without a first pose; the first pose where a second look is not possible.
    """
    first = detect(levels, anchors, keypoints, K, settings)
    looks, matrix, model = settings.looks, camera_matrix(K), np.asarray(keypoints, np.float64)
    if first is None or looks is None:
        return first
    views = look_closer(image, first.pose, matrix, model, looks)
    voters = [settings.voters(levels, anchors)]
    for view, cells in zip(views, see([view.image for view in views]) if views else [], strict=True):
        found = settings.voters(cells, anchors)
        voters.append(None if found is None else view.back(found))
    chosen = [cells for cells in voters if cells is not None]
    result = solve_together(chosen, model, matrix, settings.ransac) if views else None
    return first if result is None else detection(chosen, result)


def detection(voters: Sequence[Candidates], result: PnpResult) -> Detection:
    """What the voting cells of one or more views have led to."""
    return Detection(
        pose=result.pose,
        score=max(float(cells.confidence.max()) for cells in voters),
        cells=sum(len(cells.points) for cells in voters),
        pairs=len(result.inliers),
        inliers=int(result.inliers.sum()),
        rms_px=result.rms_px,
    )
