"""Shape of the 1U CubeSat: 100 x 100 x 108.8 mm of boxes, and four tape antennas beside its body."""

from __future__ import annotations

from functools import cache

import numpy as np

from macram.data.geometry import Floats, box_corners
from macram.data.render.faces import PAGES
from macram.data.render.patches import Patches

NAME = "cubesat1u"
SIZE_MM = np.array([100.0, 100.0, 108.8])
"""Body without antennas, centred on the origin."""

DIAMETER_MM = float(np.linalg.norm(SIZE_MM))
"""178.43 mm: between opposite corners of the body."""

CORE = np.array([48.0, 48.0, 51.5])
"""Half sizes inside the frame; the frame's rails stand 2 mm and 2.9 mm proud."""

# Outward normal, then the directions of a face's page: to the right and upwards.
SIDES = (
    ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    ((-1, 0, 0), (0, -1, 0), (0, 0, 1)),
    ((0, 1, 0), (-1, 0, 0), (0, 0, 1)),
    ((0, -1, 0), (1, 0, 0), (0, 0, 1)),
    ((0, 0, 1), (1, 0, 0), (0, 1, 0)),
    ((0, 0, -1), (0, 1, 0), (1, 0, 0)),
)

# Side, centre to the right and upwards in mm, width, height, how far it stands out, page.
FITTINGS = (
    (0, 33, 44, 8, 8, 1.6, "gold plate"),
    (1, -17, -34, 22, 12, 1.5, "connector"),
    (2, 34, 36, 16, 16, 1.8, "black"),
    (2, 34, 36, 8, 8, 2.0, "glass"),
    (3, 25, 34, 26, 9, 1.8, "connector"),
    (3, -20, 30, 7, 7, 1.9, "white"),
    (4, 0, 4, 46, 46, 1.8, "ceramic"),
    (4, 4, 4, 30, 30, 2.0, "gold plate"),
    (4, -37, -37, 10, 10, 2.4, "black"),
    (5, -10, 0, 24, 24, 1.6, "black"),
    (5, 24, 16, 11, 16, 1.4, "connector"),
    (5, 26, -22, 12, 8, 2.6, "white"),
    (5, -36, 26, 8, 26, 2.6, "connector"),
)

# Foot, direction (normalised below), direction of the tape's width, length; mm.
ANTENNAS = (
    ((48, 30, 47), (1, 0.05, -0.12), (0, 1, 0), 165),
    ((-48, -30, 47), (-1, 0.04, -0.18), (0, 1, 0), 165),
    ((-28, 48, -47), (0.06, 1, 0.15), (1, 0, 0), 120),
    ((28, -48, -47), (0.03, -1, 0.10), (1, 0, 0), 120),
)


class _Builder:
    def __init__(self) -> None:
        self.rows: list[tuple[Floats, Floats, Floats, int, bool]] = []

    def box(self, centre: Floats, half: Floats, pages: list[int], axes: Floats, body: bool = True) -> None:
        """Six rectangles; ``axes`` has the box's directions as rows, ``pages`` one entry per side."""
        for page, (normal, across, up) in zip(pages, SIDES, strict=True):
            n, a, b = (np.asarray(direction, np.float64) * half for direction in (normal, across, up))
            middle = centre + n @ axes
            self.rows.append((middle - a @ axes - b @ axes, 2 * a @ axes, 2 * b @ axes, page, body))

    def block(self, low: Floats, high: Floats, page: int) -> None:
        """An axis-aligned box of one material."""
        self.box((low + high) / 2, (high - low) / 2, [page] * 6, np.eye(3))


@cache
def cubesat() -> Patches:
    """Every rectangle of the satellite."""
    builder = _Builder()
    builder.box(np.zeros(3), CORE, list(range(6)), np.eye(3))
    half, rail = SIZE_MM / 2, PAGES["rail"]
    for x in (-1, 1):
        for y in (-1, 1):
            outer = np.array([x * half[0], y * half[1]])
            inner = outer - 8.5 * np.array([x, y])
            low, high = np.minimum(outer, inner), np.maximum(outer, inner)
            builder.block(np.append(low, -half[2]), np.append(high, half[2]), rail)
    for z in (-1, 1):
        deck = sorted((z * 46.5, z * 52.8))
        for s in (-1, 1):
            flank = sorted((s * 43.5, s * 49.6))
            builder.block(np.array([-42, flank[0], deck[0]]), np.array([42, flank[1], deck[1]]), rail)
            builder.block(np.array([flank[0], -42, deck[0]]), np.array([flank[1], 42, deck[1]]), rail)
    for side, right, up, width, height, depth, page in FITTINGS:
        n, a, b = (np.asarray(direction, np.float64) for direction in SIDES[side])
        foot = CORE * n + right * a + up * b
        reach = (width * np.abs(a) + height * np.abs(b)) / 2
        low, high, top = foot - reach, foot + reach, depth * n
        builder.block(np.minimum(low, low + top), np.maximum(high, high + top), PAGES[page])
    for base, along, width_axis, length in ANTENNAS:
        direction = np.asarray(along, np.float64)
        direction /= np.linalg.norm(direction)
        wide = np.asarray(width_axis, np.float64)
        wide -= direction * (wide @ direction)
        wide /= np.linalg.norm(wide)
        axes = np.stack([direction, wide, np.cross(direction, wide)])
        centre = np.asarray(base, np.float64) + direction * length / 2
        builder.box(centre, np.array([length / 2, 2.5, 0.4]), [PAGES["tape"]] * 6, axes, body=False)
    origin, across, up_edge, page_of, body = zip(*builder.rows, strict=True)
    return Patches(
        origin=np.stack(origin),
        across=np.stack(across),
        up=np.stack(up_edge),
        page=np.array(page_of, np.intp),
        body=np.array(body, np.bool_),
    )


def corners() -> Floats:
    """``[8, 3]`` corners of the body's box in mm, x slowest."""
    return box_corners(-SIZE_MM / 2, SIZE_MM / 2)


def mesh() -> tuple[Floats, np.ndarray[tuple[int, ...], np.dtype[np.intp]]]:
    """Vertices ``[V, 3]`` in mm and triangles ``[T, 3]`` of the body without antennas."""
    patches = cubesat()
    quads = patches.corners[patches.body]
    vertices, names = np.unique(np.round(quads.reshape(-1, 3), 6), axis=0, return_inverse=True)
    outline = names.reshape(-1, 4)
    return vertices, np.concatenate([outline[:, [0, 1, 2]], outline[:, [0, 2, 3]]])
