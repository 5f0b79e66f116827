"""Rectangles in space, and which of them each sample of a picture sees.

Everything solid is made of flat rectangles. The map from pixels to coordinates on a rectangle is a
homography, so ``u/z``, ``v/z`` and ``1/z`` are affine in the pixel: visibility needs neither division nor
clipping.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from macram.data.geometry import Floats

Floats32 = NDArray[np.float32]

NEAREST_MM = 20.0
"""Nothing nearer to the camera's plane is drawn."""


@dataclass(frozen=True)
class Patches:
    """M rectangles ``origin + u * across + v * up`` with u and v from 0 to 1; mm.

    Attributes:
        origin, across, up: ``[M, 3]``; ``across x up`` points outwards.
        page: ``[M]`` texture page of each.
        body: ``[M]`` whether it belongs to the body, as against the antennas.
    """

    origin: Floats
    across: Floats
    up: Floats
    page: NDArray[np.intp]
    body: NDArray[np.bool_]

    @property
    def normal(self) -> Floats:
        """``[M, 3]`` outward unit normals."""
        normal = np.cross(self.across, self.up)
        return np.asarray(normal / np.linalg.norm(normal, axis=1, keepdims=True))

    @property
    def corners(self) -> Floats:
        """``[M, 4, 3]`` in the order of an outline, anticlockwise seen from outside."""
        a, b = self.across, self.up
        return np.stack([self.origin, self.origin + a, self.origin + a + b, self.origin + b], axis=1)


@dataclass(frozen=True)
class Samples:
    """What each sample of a grid sees.

    Attributes:
        patch: ``[H, W]`` index of the visible rectangle, -1 for none.
        nearness: ``[H, W]`` 1/depth (perspective) or height towards the light (parallel); meaningless at -1.
        u, v: ``[H, W]`` coordinates on the rectangle times `nearness` (perspective).
    """

    patch: NDArray[np.int32]
    nearness: Floats32
    u: Floats32
    v: Floats32


def see(
    patches: Patches, grid: Floats, rotation: Floats, translation: Floats, shape: tuple[int, int]
) -> Samples:
    """Perspective view.

    Args:
        patches: in the target's frame.
        grid: ``[3, 3]`` camera frame to homogeneous sample coordinates, sample centres at whole numbers.
        rotation: ``[3, 3]`` target to camera.
        translation: ``[3]`` mm.
        shape: rows and columns of samples.
    """
    origin = patches.origin @ rotation.T + translation
    across, up = patches.across @ rotation.T, patches.up @ rotation.T
    facing = np.einsum("ij,ij->i", np.cross(across, up), origin) < 0
    chosen = np.flatnonzero(facing)
    matrix = np.stack([across[chosen], up[chosen], origin[chosen]], axis=2)
    forward = np.asarray(np.linalg.inv(grid @ matrix), np.float64)
    corners = patches.corners[chosen] @ rotation.T + translation
    depth = corners[..., 2]
    with np.errstate(divide="ignore", invalid="ignore"):
        seen = corners @ grid.T
        pixels = seen[..., :2] / seen[..., 2:]
    # A rectangle through the camera's plane has no bounding box: look at the whole picture.
    pixels[(depth < NEAREST_MM).any(axis=1)] = np.array([[-1e6, -1e6], [1e6, 1e6]] * 2)
    visible = (depth >= NEAREST_MM).any(axis=1)
    return _resolve(forward[visible], pixels[visible], chosen[visible], shape, None)


def see_parallel(patches: Patches, axes: Floats, shape: tuple[int, int]) -> Samples:
    """Parallel view along the third row of ``axes``: ``[3, 4]``, target frame to column, row and height."""
    chosen = np.flatnonzero(patches.normal @ axes[2, :3] > 1e-3)
    flat = axes[:2, :3]
    corners = patches.corners[chosen]
    pixels = corners @ flat.T + axes[:2, 3]
    matrix = np.zeros((len(chosen), 3, 3))
    matrix[:, :2, 0] = patches.across[chosen] @ flat.T
    matrix[:, :2, 1] = patches.up[chosen] @ flat.T
    matrix[:, :2, 2] = patches.origin[chosen] @ flat.T + axes[:2, 3]
    matrix[:, 2, 2] = 1
    inverse = np.asarray(np.linalg.inv(matrix), np.float64)
    rise = np.stack([p[chosen] @ axes[2, :3] for p in (patches.across, patches.up, patches.origin)], axis=1)
    forward = inverse.copy()
    forward[:, 2] = np.einsum("mk,mkj->mj", rise, inverse)
    forward[:, 2, 2] += axes[2, 3]
    return _resolve(forward, pixels, chosen, shape, 1.0)


def _resolve(
    forward: Floats, pixels: Floats, names: NDArray[np.intp], shape: tuple[int, int], limit: float | None
) -> Samples:
    """Greatest third component wins; inside means both others between 0 and ``limit`` (None: the third)."""
    rows, columns = shape
    nearness = np.full(shape, 0.0 if limit is None else -1e9, np.float32)
    patch = np.full(shape, -1, np.int32)
    u, v = np.zeros(shape, np.float32), np.zeros(shape, np.float32)
    low = np.clip(np.floor(pixels.min(axis=1)), 0, [columns, rows]).astype(int)
    high = np.clip(np.ceil(pixels.max(axis=1)) + 1, 0, [columns, rows]).astype(int)
    for m in np.flatnonzero((high > low).all(axis=1)):
        (x0, y0), (x1, y1) = low[m], high[m]
        # Affine in column and row: one outer sum each; moving the origin first keeps float32 exact enough.
        f = forward[m]
        base = f[:, 2] + f[:, 0] * x0 + f[:, 1] * y0
        dx = np.arange(x1 - x0, dtype=np.float64)
        dy = np.arange(y1 - y0, dtype=np.float64)[:, None]
        a, b, q = (
            np.add((f[i, 1] * dy + base[i]).astype(np.float32), (f[i, 0] * dx).astype(np.float32))
            for i in range(3)
        )
        window = np.s_[y0:y1, x0:x1]
        edge = q if limit is None else np.float32(limit)
        inside = (a >= 0) & (b >= 0) & (a <= edge) & (b <= edge) & (q > nearness[window])
        if limit is None:
            inside &= q < np.float32(1 / NEAREST_MM)
        np.copyto(nearness[window], q, where=inside)
        np.copyto(u[window], a, where=inside)
        np.copyto(v[window], b, where=inside)
        patch[window][inside] = names[m]
    return Samples(patch=patch, nearness=nearness, u=u, v=v)
