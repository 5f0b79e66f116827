"""Pictures of one sequence, with their labels."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from macram.data.erase import erase
from macram.data.geometry import Floats, bucket, project
from macram.data.render.cubesat import DIAMETER_MM, SIZE_MM, corners
from macram.data.render.earth import Earth
from macram.data.render.plan import View, plan_sequence
from macram.data.render.sensor import Stars, develop, gain, grain
from macram.data.render.surround import Surround
from macram.data.render.target import draw, outline

STAR_LIGHT = 0.3
"""Radiance of a pixel with a star of magnitude 0, relative to the exposure; far above the true sky's."""

Picture = NDArray[np.uint8]


@dataclass(frozen=True)
class Rendered:
    """One frame.

    Attributes:
        image: ``[H, W, 3]`` RGB bytes.
        background: ``[H, W, 3]`` the same picture without the target, same noise; None if not asked for.
        mask: ``[H, W]`` bool, where the target, antennas included, covers half a pixel or more.
        rotation: ``[3, 3]`` target to camera.
        translation: ``[3]`` mm.
        corners: ``[8, 2]`` projected corners of the body's box, pixels.
        bucket: ``near``, ``medium`` or ``far``.
        sun: ``[3]`` unit vector to the Sun, camera frame.
        extent: x, y, width, height of the whole silhouette, beyond the picture's borders too.
    """

    image: Picture
    background: Picture | None
    mask: NDArray[np.bool_]
    rotation: Floats
    translation: Floats
    corners: Floats
    bucket: str
    sun: Floats
    extent: tuple[int, int, int, int]

    @property
    def erased(self) -> Picture:
        """The image with the target blacked out (`macram.data.erase`)."""
        return erase(self.image, self.mask)


def render_sequence(
    seed: tuple[int, int, int],
    frames: int,
    view: View,
    depth: tuple[float, float],
    background: bool = True,
) -> Iterator[Rendered]:
    """Render frame by frame.

    Args:
        seed: base seed, number of the split, number of the sequence.
        frames: how many.
        view: camera.
        depth: nearest and farthest depth in diameters.
        background: also develop the picture without the target.
    """
    limits = (depth[0] * DIAMETER_MM, depth[1] * DIAMETER_MM)
    plan = plan_sequence(seed, frames, view, limits, float(SIZE_MM.max()))
    earth = Earth(plan)
    surround = Surround(earth, plan.drift[len(plan.drift) // 2])
    stars = Stars(plan.weather)
    shape = (view.height, view.width)
    matrix = view.matrix
    # Pixel centres lie at whole numbers plus a half in `matrix`.
    grid = np.array([[1, 0, -0.5], [0, 1, -0.5], [0, 0, 1.0]]) @ matrix
    rays = _rays(grid, shape)
    footprint = plan.altitude / view.focal

    for number in range(frames):
        camera, rotation, translation = (
            plan.cameras[number],
            plan.rotations[number],
            plan.translations[number],
        )
        sun = camera @ plan.sun
        scene = earth.radiance(rays @ camera.astype(np.float32), plan.drift[number], footprint)
        drawn = draw(shape, matrix, rotation, translation, sun, surround, camera)
        full = scene.copy()
        mask = np.zeros(shape, np.bool_)
        lit = np.zeros((0, 3), np.float32)
        if drawn is not None:
            full[drawn.window] = full[drawn.window] * (1 - drawn.coverage[..., None]) + drawn.light
            mask[drawn.window] = drawn.coverage >= 0.5
            lit = full[mask]
        exposure = gain(full, lit) * float(plan.gains[number])
        stars.add(scene, camera, grid, STAR_LIGHT / exposure)
        if drawn is not None:
            behind = scene[drawn.window]
            full = scene.copy()
            full[drawn.window] = behind * (1 - drawn.coverage[..., None]) + drawn.light
        else:
            full = scene
        noise = grain(shape, plan.grain[number])
        yield Rendered(
            image=develop(full, exposure, noise),
            background=develop(scene, exposure, noise) if background else None,
            mask=mask,
            rotation=rotation,
            translation=translation,
            corners=project(matrix, rotation, translation[:, None], corners()),
            bucket=bucket(float(translation[2]), DIAMETER_MM),
            sun=np.round(sun, 9),
            extent=_extent(matrix, rotation, translation),
        )


def _rays(grid: Floats, shape: tuple[int, int]) -> NDArray[np.float32]:
    """``[H, W, 3]`` unit vectors through the pixel centres, camera frame."""
    inverse = np.linalg.inv(grid)
    y, x = np.mgrid[: shape[0], : shape[1]]
    rays = np.stack([x, y, np.ones(shape)], axis=2) @ inverse.T
    return np.asarray(rays / np.linalg.norm(rays, axis=2, keepdims=True), np.float32)


def _extent(matrix: Floats, rotation: Floats, translation: Floats) -> tuple[int, int, int, int]:
    pixels, _ = outline(matrix, rotation, translation)
    low, high = np.floor(pixels.min(axis=0)), np.ceil(pixels.max(axis=0))
    x, y = (int(value) for value in low)
    return x, y, int(high[0]) - x, int(high[1]) - y
