"""Random views of a whole batch at once, with exact labels: which frames, which moves, which targets.

Everything random here comes from one generator per step. All processes draw the whole batch and take their
part, so the result depends on seed, step and place in the batch, not on how many processes share the work.
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from macram.pose.correspond import level_quota
from macram.pose.rigid import Pose
from macram.pose.warp import Draw, reference_warp
from macram.train.augment import ATTEMPTS, FEWEST_PIXELS, AugmentSettings
from macram.train.pack import PackedFrames

Floats = NDArray[np.float64]
FIT = 0.8
"""Largest share of a centred view's side that the target may take; beyond it the view zooms out."""
ORDER, VIEWS = 0, 1
"""Purposes of random numbers, as part of their seeds."""


@dataclass(frozen=True, eq=False)
class Views:
    """What is to be seen, and the truth about it. First axis: place in the batch.

    Attributes:
        frame: int64 ``[B]``, index of the packed frame.
        matrix: ``[B, 3, 3]`` affine map, frame to view; pixel centres at whole numbers plus a half.
        other: ``[B, 3, 3]`` the same for the counterfactual picture.
        camera: ``[B, 3, 3]`` intrinsics of the view.
        rotation: ``[B, 3, 3]``, object to camera, in the view.
        translation: ``[B, 3]`` mm.
        points: ``[B, K, 3]`` keypoints in the camera frame, mm.
        pixels: ``[B, K, 2]`` keypoints in the view.
        quota: int64 ``[B, levels]`` positive cells.
        tone: ``[B, 3]`` gamma, gain, noise level (grey levels).
        noise: int64 ``[B]``, where in the noise bank each view's noise starts.
        keys: float32 ``[B, cells]``, decide which cells are drawn.
    """

    frame: NDArray[np.int64]
    matrix: Floats
    other: Floats
    camera: Floats
    rotation: Floats
    translation: Floats
    points: Floats
    pixels: Floats
    quota: NDArray[np.int64]
    tone: Floats
    noise: NDArray[np.int64]
    keys: NDArray[np.float32]

    def part(self, rank: int, world: int) -> Views:
        """What process ``rank`` of ``world`` has to do."""
        count = len(self.frame)
        chosen = slice(rank * count // world, (rank + 1) * count // world)
        return Views(**{f.name: getattr(self, f.name)[chosen] for f in fields(self)})


def frame_order(seed: int, count: int, start: int, number: int) -> NDArray[np.int64]:
    """Frames of visits ``start`` to ``start + number``: every epoch a new permutation of all."""
    visits = np.arange(start, start + number)
    epochs = {
        int(epoch): np.random.default_rng([seed, ORDER, int(epoch)]).permutation(count)
        for epoch in np.unique(visits // count)
    }
    return np.array([epochs[int(visit) // count][visit % count] for visit in visits], np.int64)


def draw_views(
    frames: PackedFrames,
    chosen: NDArray[np.int64],
    rng: np.random.Generator,
    settings: AugmentSettings,
    *,
    size: tuple[int, int],
    anchors: tuple[int, ...],
    cells: int,
    noise_places: int,
) -> Views:
    """A random view of each chosen frame.

    A draw that leaves fewer than 10 object pixels in the view is repeated, up to 20 times; then the view is
    the plain one.

    Args:
        frames: packed.
        chosen: int64 ``[B]``.
        rng: decides everything.
        settings: how far views vary; ``settings.centred`` views follow the target and zoom out to hold it.
        size: height and width of the views.
        anchors: of the levels.
        cells: of all levels.
        noise_places: starts in the noise bank.

    Raises:
        ValueError: published labels, and a pose that cannot be refitted.
    """
    first = _draw(frames, chosen, rng, settings, size)
    second = _draw(frames, chosen, rng, settings, size) if settings.draws == "independent" else first
    count = len(chosen)
    exponent = rng.uniform(-1, 1, (count, 2)) * np.log([settings.gamma, settings.exposure])
    tone = np.concatenate((np.exp(exponent), rng.uniform(0, settings.noise, (count, 1))), axis=1)
    points = frames.model.keypoints @ np.swapaxes(first.rotation, 1, 2) + first.translation[:, None]
    pixels = _projected(first.camera, points)
    extent = np.ptp(pixels, axis=1).max(axis=1) + 1.0
    return Views(
        chosen,
        first.matrix,
        second.matrix,
        first.camera,
        first.rotation,
        first.translation,
        points,
        pixels,
        level_quota(extent, anchors),
        tone,
        rng.integers(0, noise_places, count),
        rng.random((count, cells), np.float32),
    )


@dataclass(frozen=True, eq=False)
class _Moves:
    """Moves of a batch worked out: `macram.train.augment.Warp` with a first axis."""

    matrix: Floats
    camera: Floats
    rotation: Floats
    translation: Floats

    def put(self, place: NDArray[np.int64], other: _Moves) -> _Moves:
        """With rows ``place`` replaced by ``other``."""
        changed: dict[str, Any] = {}
        for name in ("matrix", "camera", "rotation", "translation"):
            changed[name] = getattr(self, name).copy()
            changed[name][place] = getattr(other, name)
        return replace(self, **changed)


def _draw(
    frames: PackedFrames,
    chosen: NDArray[np.int64],
    rng: np.random.Generator,
    settings: AugmentSettings,
    size: tuple[int, int],
) -> _Moves:
    moves = _moves(frames, chosen, _random(len(chosen), rng, settings, size), settings, size)
    for attempt in range(1, ATTEMPTS + 1):
        lost = np.flatnonzero(_seen(frames, chosen, moves, size) < FEWEST_PIXELS)
        if not len(lost):
            break
        if attempt < ATTEMPTS:
            again = _random(len(lost), rng, settings, size)
        else:
            again = np.tile([0.0, 1.0, 0.0, 0.0], (len(lost), 1))
        moves = moves.put(lost, _moves(frames, chosen[lost], again, settings, size))
    return moves


def _random(count: int, rng: np.random.Generator, settings: AugmentSettings, size: tuple[int, int]) -> Floats:
    """``[count, 4]``: angle (rad), zoom, shift in x and y (whole pixels)."""
    turn = np.radians(settings.rotation_deg)
    reach = [int(settings.shift * side) for side in (size[1], size[0])]
    return np.column_stack(
        (
            rng.uniform(-turn, turn, count),
            rng.uniform(1 - settings.scale, 1 + settings.scale, count),
            *(rng.integers(-r, r, count, endpoint=True) for r in reach),
        )
    )


def _moves(
    frames: PackedFrames,
    chosen: NDArray[np.int64],
    draws: Floats,
    settings: AugmentSettings,
    size: tuple[int, int],
) -> _Moves:
    source = frames.camera[chosen]
    if settings.labels == "reference":
        return _published(frames, chosen, draws, size)
    angle, zoom, shift = draws[:, 0], draws[:, 1], draws[:, 2:]
    turn = np.zeros((len(chosen), 3, 3))
    turn[:, 0, 0] = turn[:, 1, 1] = np.cos(angle)
    turn[:, 1, 0] = np.sin(angle)
    turn[:, 0, 1] = -turn[:, 1, 0]
    turn[:, 2, 2] = 1
    rotation = turn @ frames.rotation[chosen]
    translation = (turn @ frames.translation[chosen][:, :, None])[:, :, 0]
    camera = source.copy()
    if settings.centred:
        points = frames.model.keypoints @ np.swapaxes(rotation, 1, 2) + translation[:, None]
        extent = np.ptp(_projected(source, points), axis=1).max(axis=1)
        zoom = zoom * np.minimum(1.0, FIT * min(size) / extent)
    # Zoom about the principal point, then shift. The turn needs no centre: K Rz K^-1 is affine for any K.
    camera[:, :2, :2] *= zoom[:, None, None]
    if settings.centred:
        origin = _projected(camera, translation[:, None])[:, 0]
        camera[:, :2, 2] += np.array([size[1] / 2, size[0] / 2]) - origin
    camera[:, :2, 2] += shift
    return _Moves(camera @ turn @ np.linalg.inv(source), camera, rotation, translation)


def _published(
    frames: PackedFrames, chosen: NDArray[np.int64], draws: Floats, size: tuple[int, int]
) -> _Moves:
    warps = []
    for index, (angle, zoom, right, down) in zip(chosen, draws, strict=True):
        camera = frames.camera[index]
        pose = Pose(frames.rotation[index], frames.translation[index])
        move = Draw(float(angle), float(zoom), (float(right), float(down)))
        warps.append(reference_warp(move, camera, camera, (size[1], size[0]), pose, frames.model.keypoints))
    return _Moves(
        np.stack([warp.matrix for warp in warps]),
        np.stack([warp.K for warp in warps]),
        np.stack([warp.pose.R for warp in warps]),
        np.stack([warp.pose.t[:, 0] for warp in warps]),
    )


def _seen(frames: PackedFrames, chosen: NDArray[np.int64], moves: _Moves, size: tuple[int, int]) -> Floats:
    """Object pixels ``[B]`` in each view, estimated from the packed mask points."""
    linear = moves.matrix[:, :2, :2]
    moved = frames.mask_points[chosen] @ np.swapaxes(linear, 1, 2) + moves.matrix[:, None, :2, 2]
    inside = ((moved >= 0) & (moved < np.array([size[1], size[0]]))).all(axis=2)
    return np.asarray(inside.mean(axis=1) * frames.mask_pixels[chosen] * np.abs(np.linalg.det(linear)))


def _projected(camera: Floats, points: Floats) -> Floats:
    """``[B, n, 2]`` pixels of ``[B, n, 3]`` points in the camera frame."""
    image = points @ np.swapaxes(camera, 1, 2)
    return np.asarray(image[..., :2] / image[..., 2:])
