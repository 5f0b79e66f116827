"""The lit target: visibility, shadow, Sun, earthshine and reflections, averaged to pixels."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import cv2
import numpy as np
from numpy.typing import NDArray

from macram.data.geometry import Floats
from macram.data.render.cubesat import SIZE_MM, corners, cubesat
from macram.data.render.faces import TEXELS, Atlas, atlases
from macram.data.render.patches import Floats32, Samples, see, see_parallel
from macram.data.render.surround import Surround

SHADOW = 512
"""Rows and columns of the shadow map over the body."""
SHADOW_BIAS_MM = 0.3


@dataclass(frozen=True)
class Drawn:
    """The target in a window of the picture.

    Attributes:
        window: rows and columns of the picture.
        light: ``[h, w, 3]`` radiance times coverage.
        coverage: ``[h, w]`` share of each pixel that the target covers.
    """

    window: tuple[slice, slice]
    light: Floats32
    coverage: Floats32


@cache
def _levels() -> list[Atlas]:
    return atlases()


def draw(
    shape: tuple[int, int],
    matrix: Floats,
    rotation: Floats,
    translation: Floats,
    sun: Floats,
    surround: Surround,
    camera: Floats,
) -> Drawn | None:
    """The target in a picture of ``shape``, or None where it is outside.

    Args:
        shape: height and width in pixels.
        matrix: ``[3, 3]`` intrinsics.
        rotation: ``[3, 3]`` target to camera.
        translation: ``[3]`` mm.
        sun: ``[3]`` unit vector to the Sun, camera frame.
        surround: what the target mirrors.
        camera: ``[3, 3]`` world to camera.
    """
    window = _window(shape, matrix, rotation, translation)
    if window is None:
        return None
    rows, columns = window
    width_px = matrix[0, 0] * SIZE_MM[0] / translation[2]
    factor = 2 if width_px > 100 else 3 if width_px > 40 else 4
    # Sample s lies at (s + 0.5) / factor pixels; pixel centres are whole numbers plus a half in `matrix`.
    grid = np.array(
        [[factor, 0, -0.5 - factor * columns.start], [0, factor, -0.5 - factor * rows.start], [0, 0, 1.0]]
    )
    grid = grid @ matrix
    size = (factor * (rows.stop - rows.start), factor * (columns.stop - columns.start))
    seen = see(cubesat(), grid, rotation, translation, size)
    picture = np.zeros((*size, 3), np.float32)
    y, x = np.nonzero(seen.patch >= 0)
    if not len(y):
        return None
    texels = TEXELS / (width_px * factor)
    level = int(np.clip(np.floor(np.log2(max(texels, 1.0)) + 0.4), 0, len(_levels()) - 1))
    picture[y, x] = _shade(seen, y, x, grid, _levels()[level], rotation, translation, sun, surround, camera)
    smaller = (columns.stop - columns.start, rows.stop - rows.start)
    covered = (seen.patch >= 0).astype(np.float32)
    return Drawn(
        window=window,
        light=np.asarray(cv2.resize(picture, smaller, interpolation=cv2.INTER_AREA), np.float32),
        coverage=np.asarray(cv2.resize(covered, smaller, interpolation=cv2.INTER_AREA), np.float32),
    )


def outline(matrix: Floats, rotation: Floats, translation: Floats) -> tuple[Floats, bool]:
    """Pixels ``[N, 2]`` of every corner of every part, and whether some part is not before the camera."""
    points = cubesat().corners.reshape(-1, 3) @ rotation.T + translation
    ahead = points[:, 2] > 20
    seen = points[ahead] @ matrix.T
    return seen[:, :2] / seen[:, 2:], not bool(ahead.all())


def _window(
    shape: tuple[int, int], matrix: Floats, rotation: Floats, translation: Floats
) -> tuple[slice, slice] | None:
    pixels, cut = outline(matrix, rotation, translation)
    if cut:
        return slice(0, shape[0]), slice(0, shape[1])
    low, high = np.floor(pixels.min(axis=0)), np.ceil(pixels.max(axis=0))
    x0, y0 = np.clip(low, 0, [shape[1], shape[0]]).astype(int)
    x1, y1 = np.clip(high, 0, [shape[1], shape[0]]).astype(int)
    return (slice(int(y0), int(y1)), slice(int(x0), int(x1))) if x1 > x0 and y1 > y0 else None


def _shade(
    seen: Samples,
    y: NDArray[np.intp],
    x: NDArray[np.intp],
    grid: Floats,
    atlas: Atlas,
    rotation: Floats,
    translation: Floats,
    sun: Floats,
    surround: Surround,
    camera: Floats,
) -> Floats32:
    """``[N, 3]`` radiance of the samples at rows ``y`` and columns ``x``."""
    patches = cubesat()
    patch = seen.patch[y, x]
    depth = 1 / seen.nearness[y, x]
    u, v = seen.u[y, x] * depth, seen.v[y, x] * depth

    page = patches.page[patch]
    size = atlas.size[page]
    column = np.clip(u * size, 0, size - 1).astype(np.intp)
    row = np.clip((1 - v) * size, 0, size - 1).astype(np.intp)
    texel = atlas.texels[atlas.start[page] + row * size + column]
    albedo, metal, rough = texel[:, :3], texel[:, 3:4], texel[:, 4]

    right = _unit(patches.across) @ rotation.T
    up = _unit(patches.up) @ rotation.T
    flat = patches.normal @ rotation.T
    normal = flat.astype(np.float32)[patch]
    if texel[:, 5:].any():
        tilt = right.astype(np.float32)[patch] * texel[:, 5:6]
        tilt += up.astype(np.float32)[patch] * texel[:, 6:7]
        normal = normal + tilt
        normal /= np.sqrt(np.einsum("ij,ij->i", normal, normal))[:, None]

    inverse = np.linalg.inv(grid).astype(np.float32)
    view = -(
        np.outer(x.astype(np.float32), inverse[:, 0])
        + np.outer(y.astype(np.float32), inverse[:, 1])
        + inverse[:, 2]
    )
    place = np.asarray(-view * depth[:, None], np.float32)
    view /= np.sqrt(np.einsum("ij,ij->i", view, view))[:, None]

    light = sun.astype(np.float32)
    facing = np.maximum(normal @ light, 0) * (flat.astype(np.float32) @ light > 0)[patch]
    lit = np.flatnonzero(facing > 0)
    if len(lit):
        slant = np.asarray(flat @ sun, np.float32)[patch[lit]]
        facing[lit] *= _sunlit(place[lit], slant, rotation, translation, sun)
    looking = np.maximum(np.einsum("ij,ij->i", normal, view), 0.02)

    base = 0.04 * (1 - metal) + albedo * metal
    diffuse = albedo * (1 - metal) * np.float32(1 / np.pi)
    half = view + light
    half /= np.sqrt(np.einsum("ij,ij->i", half, half))[:, None]
    squared = rough**4
    cosine = np.einsum("ij,ij->i", half, normal)
    lobe = squared / (np.pi * (cosine**2 * (squared - 1) + 1) ** 2)
    k = (rough + 1) ** 2 / 8
    lobe *= 0.25 / ((looking * (1 - k) + k) * (np.maximum(facing, 0.02) * (1 - k) + k))
    fresnel = (1 - np.maximum(half @ light, 0)) ** 5
    glossy = base + (1 - base) * fresnel[:, None]
    result = (diffuse + glossy * np.minimum(lobe, 12)[:, None]) * facing[:, None]

    result += diffuse * surround.irradiance(flat @ camera)[patch]
    mirrored = (2 * looking[:, None] * normal - view) @ camera.astype(np.float32)
    rim = np.maximum(1 - looking, 0) ** 5
    result += surround.reflection(mirrored, rough) * (base + (1 - base) * (rim * (1 - rough))[:, None])
    return np.asarray(result, np.float32)


def _unit(vectors: Floats) -> Floats:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=1, keepdims=True))


def _sunlit(place: Floats32, slant: Floats32, rotation: Floats, translation: Floats, sun: Floats) -> Floats32:
    """Share of sunlight, four taps, at ``[N, 3]`` places in the camera frame.

    ``slant`` ``[N]`` is the cosine between face and Sun: a texel of the map spans more height on steep faces.
    """
    towards = rotation.T @ sun
    side = np.cross(towards, np.eye(3)[int(np.argmin(np.abs(towards)))])
    side /= np.linalg.norm(side)
    axes = np.zeros((3, 4))
    axes[:, :3] = np.stack([side, np.cross(towards, side), towards])
    # The body fills the map; only antennas lie beside it, and nothing of the body can shade what is there.
    extent = corners() @ axes[:2, :3].T
    scale = (SHADOW - 8) / (extent.max(axis=0) - extent.min(axis=0)).max()
    axes[:2, :3] *= scale
    axes[:2, 3] = SHADOW / 2 - 0.5
    height = see_parallel(cubesat(), axes, (SHADOW, SHADOW)).nearness
    steep = axes[:, :3] @ rotation.T
    spot = place @ steep.T.astype(np.float32) + (axes[:, 3] - steep @ translation).astype(np.float32)
    inside = ((spot[:, :2] >= 1) & (spot[:, :2] < SHADOW - 2)).all(axis=1)
    bias = SHADOW_BIAS_MM + 1.6 / scale * np.sqrt(1 - np.minimum(slant**2, 1)) / np.maximum(slant, 0.05)
    share = np.ones(len(place), np.float32)
    x, y, z = spot[inside, 0], spot[inside, 1], spot[inside, 2] + bias[inside].astype(np.float32)
    column, row = x.astype(np.intp), y.astype(np.intp)
    a, b = x - column, y - row
    flat = row * SHADOW + column
    level = height.reshape(-1)
    share[inside] = (1 - a) * ((1 - b) * (level[flat] <= z) + b * (level[flat + SHADOW] <= z)) + a * (
        (1 - b) * (level[flat + 1] <= z) + b * (level[flat + SHADOW + 1] <= z)
    )
    return share
