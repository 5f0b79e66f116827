"""Second looks: the network sees crops around the first pose as well, zoomed and turned, and all cells vote.

A turn of the picture about its principal point is a roll of the camera, zoom and shift go into the camera matrix:
a keypoint seen in a crop has an exact place in the picture, so the pairs of all views make one problem.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np

from macram.data.geometry import project
from macram.pose.correspond import Candidates, LevelCells
from macram.pose.pnp import PnpResult, RansacSettings, solve_pnp
from macram.pose.rigid import Floats, Pose
from macram.pose.robust import robust_pose
from macram.pose.warp import Draw, Image, exact_warp, move_points, warp_image

See = Callable[[list[Image]], list[list[LevelCells]]]

INLIER_SHARE = 0.1
"""Largest error of an inlier among pairs of several views, in shares of the target's size."""
SPREAD_SHARE = 0.06
"""Error at which such a pair counts half, in the same unit."""
# A first pose whose target is smaller or larger than this, in px, is not worth following.
_SIZES_PX = (4.0, 4000.0)
# Below this zoom the crop would skip pixels of the picture.
_MINIFIED = 0.9


@dataclass(frozen=True, slots=True)
class LookSettings:
    """Which crops are seen.

    Attributes:
        turns: crops, evenly turned over the full circle.
        size: of the target in a crop, px.
        side: of a crop, px, a multiple of 32.

    Raises:
        ValueError: a value out of range.
    """

    turns: int = 4
    size: int = 56
    side: int = 128

    def __post_init__(self) -> None:
        if not (
            1 <= self.turns <= 64 and self.side > 0 and self.side % 32 == 0 and 0 < self.size < self.side
        ):
            raise ValueError(
                f"{self.turns} looks at a target of {self.size} px in crops of {self.side}: needs 1 to 64 looks, a "
                "crop of a multiple of 32 px, and a target that is smaller"
            )


@dataclass(frozen=True, slots=True, eq=False)
class View:
    """A crop and the way back: ``image [side, side, 3]``, ``matrix [3, 3]`` from its pixels to the picture's."""

    image: Image
    matrix: Floats

    def back(self, voters: Candidates) -> Candidates:
        """The cells with their points as pixels of the picture."""
        points = move_points(self.matrix, voters.points.reshape(-1, 2)).reshape(voters.points.shape)
        # The zoom is the same in all directions, whatever the turn.
        scale = float(np.sqrt(abs(np.linalg.det(self.matrix[:2, :2]))))
        return replace(voters, points=points, size=voters.size * scale)


def look_closer(image: Image, pose: Pose, K: Floats, keypoints: Floats, settings: LookSettings) -> list[View]:
    """Crops centred on the object at ``pose``; none if it is too small, too large or behind the camera.

    Args:
        image: ``[H, W, 3]`` RGB.
        pose: the first.
        K: ``[3, 3]`` intrinsics of ``image``.
        keypoints: ``[k, 3]`` mm; their extent is what `LookSettings` calls the target's size.
        settings: which crops.
    """
    size = float(np.ptp(project(K, pose.R, pose.t, keypoints), axis=0).max())
    if not _SIZES_PX[0] < size < _SIZES_PX[1]:
        return []
    zoom = settings.size / size
    if zoom < _MINIFIED:
        spread = 0.5 * float(np.sqrt(zoom**-2 - 1))
        image = np.asarray(cv2.GaussianBlur(image, (0, 0), spread), np.uint8)
    views = []
    for turn in range(settings.turns):
        move = Draw(angle=2 * np.pi * turn / settings.turns, scale=zoom)
        warp = exact_warp(move, K, K, (settings.side, settings.side), pose, centred=True)
        views.append(View(warp_image(image, warp), np.asarray(np.linalg.inv(warp.matrix), np.float64)))
    return views


def solve_together(
    voters: Sequence[Candidates], keypoints: Floats, K: Floats, settings: RansacSettings
) -> PnpResult | None:
    """Pose of the cells of several views: RANSAC by a share of the target's size, then `robust_pose` over all.

    Args:
        voters: of each view, points in pixels of one picture.
        keypoints: ``[k, 3]`` mm.
        K: ``[3, 3]`` intrinsics of that picture.
        settings: rounds and seed of RANSAC; threshold and refinement are this function's own.
    """
    size = float(np.median([cells.size for cells in voters]))
    pairs = [cells.pairs(keypoints) for cells in voters]
    model, pixels = (np.concatenate(part) for part in zip(*pairs, strict=True))
    found = solve_pnp(model, pixels, K, replace(settings, threshold_px=INLIER_SHARE * size, refine=False))
    if found is None:
        return None
    probability = np.concatenate([cells.confidence**2 for cells in voters])
    weights = np.repeat(probability, len(keypoints))
    pose = robust_pose(model, pixels, weights, K, found.pose, SPREAD_SHARE * size)
    errors = np.linalg.norm(project(K, pose.R, pose.t, model) - pixels, axis=1)
    inliers = errors < INLIER_SHARE * size
    if not inliers.any():
        return found
    return PnpResult(pose, inliers, float(np.sqrt((errors[inliers] ** 2).mean())))
