"""A pose drawn to the picture's own edges: those of the target's box, sought across their projections.

The network's keypoints fix the size of a far target to a few percent of it; its edges are seen to a fraction of
a pixel. Points on the visible edges look along their normals for the strongest step of brightness nearby, and
the pose follows by least squares; the keypoints' pose holds whatever the edges leave open. Three rounds, with
ever shorter reach; the first two prefer the outline to what is inside of it. The principle is that of C. Harris,
C. Stennett, "RAPID", BMVC 1990.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import ArrayLike, NDArray

from macram.data.geometry import BOX_EDGES
from macram.pose.rigid import Floats, Pose, camera_matrix
from macram.pose.robust import as_pose, moved, projected

Image = NDArray[np.uint8]
Floats32 = NDArray[np.float32]

_GAMMA = 2.2
_STEP_PX = 0.25
_MEASUREMENTS = 2
"""Of each reach: after the first the normals are better."""
_SOLVER_STEPS = 4
_SMALLEST_PX = 6.0
"""Targets below this have no edges to speak of."""
_LARGEST_PX = 4000.0
"""Targets above this come from a pose that is wrong; the search would reach farther than any picture."""
_NEAREST_MM = 1.0
_MOST_OUTWARD = 10.0


@dataclass(frozen=True, slots=True)
class EdgeSettings:
    """How edges are sought.

    Attributes:
        box: size of the box that the edges lie on, in boxes of the keypoints. Frames, recesses and rounded
            corners make it smaller than 1; see ``macram experiments inference``, which measures it.
        nearer: depth to start from, in depths of the keypoints' pose. Networks see targets in half shadow as
            too small, and from too far away the search meets inner edges first.
        reach: of the search, one round each, in shares of the target's size.
        outward: how much points of the outline prefer steps farther out in the first round: two steps that lie
            a reach apart are alike if the inner one is ``exp(outward)`` times as strong. Falls evenly to 0 in the
            last round, which measures.
        blur_px: standard deviation of the smoothing.
        spread_px: error at which a point counts half; also at least 0.3 % of the target's size.
        hold: how far the keypoints' pose lets go, in shares of the target's size.
        contrast: step of brightness, grey levels per pixel, below which a point does not count.
        points: sought on each edge.

    Raises:
        ValueError: a value that is not above zero; ``outward`` out of 0..10.
    """

    box: float = 1.0
    nearer: float = 0.95
    reach: tuple[float, ...] = (0.06, 0.04, 0.025)
    outward: float = 0.4
    blur_px: float = 0.7
    spread_px: float = 0.15
    hold: float = 0.1
    contrast: float = 8.0
    points: int = 14

    def __post_init__(self) -> None:
        for name in ("box", "nearer", "blur_px", "spread_px", "hold", "contrast", "points"):
            value = getattr(self, name)
            if not (np.isfinite(value) and value > 0):
                raise ValueError(f"edges: {name} must be above 0, not {value!r}")
        if not self.reach or min(self.reach) <= 0:
            raise ValueError(f"edges: reach needs values above 0, not {self.reach!r}")
        if not 0 <= self.outward <= _MOST_OUTWARD:
            raise ValueError(f"edges: outward must be 0 to {_MOST_OUTWARD:g}, not {self.outward!r}")


@dataclass(frozen=True, slots=True, eq=False)
class _Found:
    """Points on edges: ``points [n, 3]`` mm, ``normals [n, 2]``, ``place [n]`` along them in px, ``weight [n]``."""

    points: Floats
    normals: Floats
    place: Floats
    weight: Floats


def refine_on_edges(
    image: Image, pose: Pose, K: ArrayLike, corners: ArrayLike, settings: EdgeSettings | None = None
) -> Pose:
    """``pose`` after alignment with the edges of the target's box.

    Args:
        image: ``[H, W, 3]`` RGB.
        pose: object to camera, mm, off by no more than the first reach.
        K: ``[3, 3]`` intrinsics of ``image``, without skew.
        corners: ``[8, 3]`` box corners, mm, x slowest, z fastest.
        settings: defaults if None.

    Returns:
        The aligned pose; ``pose`` itself where the target is too small, too large or partly behind the camera.

    Raises:
        ValueError: the corners are not those of a box.
    """
    settings = settings or EdgeSettings()
    box = np.asarray(corners, np.float64)
    if box.shape != (8, 3):
        raise ValueError(f"edges need a box, corners [8, 3], not keypoints {list(box.shape)}")
    matrix = camera_matrix(K)
    box = box.mean(axis=0) + settings.box * (box - box.mean(axis=0))
    R, t = pose.R, settings.nearer * pose.t[:, 0]
    if not _ahead(R, t, box):
        return pose
    held = projected(matrix, R, t, box)[0]
    size = float(np.ptp(held, axis=0).max())
    if not _SMALLEST_PX <= size <= _LARGEST_PX:
        return pose
    # Steps are placed in linear light: the response curve would move them towards the dark side.
    grey = image.astype(np.float32)
    linear = np.asarray((grey / 255) ** _GAMMA, np.float32)
    pictures = _smooth(linear, settings.blur_px), _smooth(grey, settings.blur_px)
    last = len(settings.reach) - 1
    for number, share in enumerate(settings.reach):
        reach = max(share * size, 1.0)
        outward = settings.outward * (last - number) / max(last, 1)
        for _ in range(_MEASUREMENTS):
            found = _search(pictures, matrix, R, t, box, reach, outward, settings)
            R, t = _follow(found, matrix, R, t, box, held, size, settings)
            if not _ahead(R, t, box):
                return pose
    return as_pose(R, t)


def _ahead(R: Floats, t: Floats, box: Floats) -> bool:
    return bool(np.all(box @ R[2] + t[2] > _NEAREST_MM))


def visible_edges(R: Floats, t: Floats, box: Floats) -> dict[tuple[int, int], bool]:
    """Edges of a box ``[8, 3]`` on a side that faces the camera, and whether they are part of its outline."""
    centre, eye = box.mean(axis=0), -R.T @ t
    seen = [
        set(np.flatnonzero(sign * (box - centre)[:, axis] > 0).tolist())
        for axis in range(3)
        for sign in (-1, 1)
        if sign * (eye - centre)[axis] > np.abs(box - centre)[:, axis].max()
    ]
    sides = {edge: sum(set(edge) <= side for side in seen) for edge in BOX_EDGES}
    return {edge: count == 1 for edge, count in sides.items() if count}


def _smooth(picture: Floats32, spread: float) -> Floats32:
    return np.asarray(cv2.GaussianBlur(picture, (0, 0), spread), np.float32)


def _search(
    pictures: tuple[Floats32, Floats32],
    K: Floats,
    R: Floats,
    t: Floats,
    box: Floats,
    reach: float,
    outward: float,
    settings: EdgeSettings,
) -> _Found:
    """The strongest step across every visible edge, within about ``reach`` px; see `EdgeSettings.outward`."""
    edges = visible_edges(R, t, box)
    ends = np.array(list(edges))
    share = ((np.arange(settings.points) + 0.5) / settings.points)[:, None]
    points = (box[ends[:, :1]] * (1 - share) + box[ends[:, 1:]] * share).reshape(-1, 3)
    pixels = projected(K, R, t, points)[0]
    along = pixels.reshape(len(ends), settings.points, 2)[:, -1] - pixels[:: settings.points]
    length = np.linalg.norm(along, axis=1)
    normal = np.stack([-along[:, 1], along[:, 0]], axis=1) / np.maximum(length, 1e-6)[:, None]
    normals = np.repeat(normal, settings.points, axis=0)

    half = int(np.ceil(reach / _STEP_PX))
    offsets = np.asarray(np.arange(-half, half + 1) * _STEP_PX, np.float64)
    linear, smooth = (_steps(picture, pixels, normals, offsets) for picture in pictures)
    rows = np.arange(len(points))
    # Among steps alike the nearest is meant, and first of all the one farther out.
    away = pixels - projected(K, R, t, box)[0].mean(axis=0)
    out = np.sign((away * normals).sum(axis=1)) * np.repeat(list(edges.values()), settings.points)
    best = np.argmax(
        linear * np.exp(outward * np.outer(out, offsets / reach) - 0.5 * (offsets / reach) ** 2), axis=1
    )
    inner = np.clip(best, 1, len(offsets) - 2)
    before, peak, after = (linear[rows, inner + d] for d in (-1, 0, 1))
    bend = before - 2 * peak + after
    # The vertex of the parabola through three samples, if they are one's top.
    vertex = np.where(bend < 0, 0.5 * (before - after) / np.where(bend < 0, bend, 1), 0.0)
    place = offsets[inner] + _STEP_PX * np.clip(vertex, -1, 1)

    strength = smooth[rows, inner]
    weight = np.where(strength > settings.contrast, strength / (strength + 2 * settings.contrast), 0.0)
    # A short edge has fewer pixels than points.
    weight *= np.repeat(np.minimum(length / settings.points, 1), settings.points)
    margin = reach + 2
    height, width = pictures[0].shape[:2]
    inside = (pixels > margin).all(axis=1) & (pixels < np.array([width, height]) - margin).all(axis=1)
    return _Found(points, normals, (pixels * normals).sum(axis=1) + place, weight * inside)


def _steps(picture: Floats32, pixels: Floats, normals: Floats, offsets: Floats) -> Floats:
    """Change per pixel ``[n, offsets]``, mean of the channels' sizes, at places across each point."""
    reach = np.concatenate([offsets - _STEP_PX, offsets[-1:] + np.array([0.0, _STEP_PX])])
    places = (pixels[:, None] + normals[:, None] * reach[:, None] - 0.5).astype(np.float32)
    values = cv2.remap(
        picture,
        np.ascontiguousarray(places[..., 0]),
        np.ascontiguousarray(places[..., 1]),
        cv2.INTER_LINEAR,
        borderMode=cv2.BORDER_REPLICATE,
    )
    change = np.abs(np.asarray(values, np.float64)[:, 2:] - values[:, :-2])
    return np.asarray(change.mean(axis=2) / (2 * _STEP_PX))


def _follow(
    found: _Found,
    K: Floats,
    R: Floats,
    t: Floats,
    box: Floats,
    held: Floats,
    size: float,
    settings: EdgeSettings,
) -> tuple[Floats, Floats]:
    """The pose after a few Gauss-Newton steps towards the edges found."""
    spread = max(settings.spread_px, 0.02 * settings.spread_px * size)
    hold = settings.hold * size
    for _ in range(_SOLVER_STEPS):
        pixels, by_pose = projected(K, R, t, found.points)
        error = (pixels * found.normals).sum(axis=1) - found.place
        across = np.einsum("ni,nia->na", found.normals, by_pose)
        weight = found.weight / (1 + (error / spread) ** 2) / spread**2
        corners, by_corner = projected(K, R, t, box)
        pull = (corners - held) / hold
        by_corner = by_corner / hold
        hessian = np.einsum("na,nb,n->ab", across, across, weight) + np.einsum(
            "nia,nib->ab", by_corner, by_corner
        )
        gradient = np.einsum("na,n,n->a", across, error, weight) + np.einsum("nia,ni->a", by_corner, pull)
        R, t = moved(R, t, -np.linalg.solve(hessian, gradient))
        if not _ahead(R, t, box):
            break
    return R, t
