"""The six painted faces of the CubeSat and its plain materials, as texture pages.

A texel has seven channels: linear albedo (3), metal share, roughness, and the tilt of its normal along the
page's two directions. No two faces look alike: mistaking one for another would be no fault of a network.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from macram.data.render.fields import power_field
from macram.data.render.patches import Floats32

TEXELS = 384
"""Width of a page of a face, height too: pages are stretched over their face."""

FACES = ("cells", "gold", "stripe", "copper", "plate", "board")
"""Pages 0 to 5: on +x, -x, +y, -y, +z, -z."""

Rgb = tuple[float, float, float]

PLAIN: dict[str, tuple[Rgb, float, float]] = {
    "rail": ((0.62, 0.63, 0.65), 0.45, 0.38),
    "black": ((0.02, 0.02, 0.022), 0.0, 0.5),
    "tape": ((0.62, 0.50, 0.26), 0.45, 0.35),
    "ceramic": ((0.75, 0.70, 0.58), 0.0, 0.6),
    "gold plate": ((0.85, 0.60, 0.22), 0.45, 0.3),
    "connector": ((0.10, 0.10, 0.11), 0.2, 0.4),
    "glass": ((0.02, 0.03, 0.06), 0.1, 0.12),
    "white": ((0.80, 0.80, 0.78), 0.0, 0.6),
}
"""Linear albedo, metal share and roughness. Pure metal looks black in space: it has nothing to mirror."""

PAGES = {name: number for number, name in enumerate((*FACES, *PLAIN))}
"""Number of every page."""


@dataclass(frozen=True)
class Atlas:
    """All pages at one level of detail.

    Attributes:
        texels: ``[T, 7]`` texels of all pages, one page after the other, row by row.
        start: ``[P]`` first texel of each page.
        size: ``[P]`` rows, and columns, of each page.
    """

    texels: Floats32
    start: NDArray[np.intp]
    size: NDArray[np.intp]


def atlases() -> list[Atlas]:
    """Levels of detail from `TEXELS` down, each half the one before."""
    pages = [_PAINT[name]() for name in FACES]
    levels = []
    while pages[0].shape[0] >= 12:
        levels.append(_pack(pages))
        pages = [np.asarray(cv2.resize(p, None, fx=0.5, fy=0.5, interpolation=cv2.INTER_AREA)) for p in pages]
    return levels


def _pack(pages: list[Floats32]) -> Atlas:
    plain = [np.array([[[*rgb, metal, rough, 0, 0]]], np.float32) for rgb, metal, rough in PLAIN.values()]
    every = [*pages, *plain]
    counts = np.array([page.shape[0] ** 2 for page in every])
    return Atlas(
        texels=np.concatenate([page.reshape(-1, 7) for page in every]),
        start=np.concatenate([[0], np.cumsum(counts)[:-1]]),
        size=np.array([page.shape[0] for page in every]),
    )


# ---- painting: coordinates in 0..1, x to the right, y downwards -------------------------------------------


def _blank(rgb: Rgb, metal: float, rough: float) -> Floats32:
    page = np.zeros((TEXELS, TEXELS, 7), np.float32)
    page[..., :3] = rgb
    page[..., 3], page[..., 4] = metal, rough
    return page


def _box(
    page: Floats32, x: float, y: float, w: float, h: float, rgb: Rgb, metal: float, rough: float
) -> None:
    x0, x1 = round(x * TEXELS), round((x + w) * TEXELS)
    y0, y1 = round(y * TEXELS), round((y + h) * TEXELS)
    page[y0 : max(y1, y0 + 1), x0 : max(x1, x0 + 1)] = (*rgb, metal, rough, 0, 0)


def _disc(page: Floats32, x: float, y: float, radius: float, rgb: Rgb, metal: float, rough: float) -> None:
    mask = np.zeros(page.shape[:2], np.uint8)
    cv2.circle(mask, (round(x * TEXELS), round(y * TEXELS)), round(radius * TEXELS), 1, -1)
    page[mask > 0] = (*rgb, metal, rough, 0, 0)


def _print(page: Floats32, text: str, x: float, y: float, scale: float, rgb: Rgb, thick: int) -> None:
    mask = np.zeros(page.shape[:2], np.uint8)
    where = (round(x * TEXELS), round(y * TEXELS))
    cv2.putText(mask, text, where, cv2.FONT_HERSHEY_SIMPLEX, scale, 1, thick)
    page[mask > 0, :3] = rgb


def _speckle(page: Floats32, seed: int, exponent: float, depth: float) -> None:
    page[..., :3] *= 1 + depth * np.clip(power_field(TEXELS, exponent, seed), -2.5, 2.5)[..., None]


def _screws(page: Floats32) -> None:
    for x in (0.05, 0.95):
        for y in (0.05, 0.95):
            _disc(page, x, y, 0.016, (0.55, 0.55, 0.56), 0.5, 0.3)
            _disc(page, x, y, 0.006, (0.1, 0.1, 0.1), 0.2, 0.5)


def _cells() -> Floats32:
    page = _blank((0.03, 0.10, 0.06), 0.0, 0.55)
    for y in (0.05, 0.52):
        _box(page, 0.08, y, 0.84, 0.43, (0.016, 0.045, 0.26), 0.1, 0.16)
        for line in range(1, 14):
            _box(page, 0.08 + 0.06 * line, y, 0.004, 0.43, (0.05, 0.11, 0.40), 0.2, 0.25)
        for bar in (0.11, 0.32):
            _box(page, 0.08, y + bar, 0.84, 0.011, (0.62, 0.62, 0.66), 0.45, 0.3)
        # Cropped corners of a wafer, on one side only: the face has no half-turn symmetry.
        for x in (0.08, 0.86):
            _box(page, x, y, 0.06, 0.05, (0.03, 0.10, 0.06), 0.0, 0.55)
    _box(page, 0.41, 0.487, 0.18, 0.024, (0.72, 0.72, 0.70), 0.0, 0.6)
    _speckle(page, 11, 0.6, 0.04)
    _screws(page)
    return page


def _gold() -> Floats32:
    page = _blank((0.80, 0.50, 0.12), 0.45, 0.3)
    wrinkle = power_field(TEXELS, 1.35, 21, cutoff=2)
    folded = np.abs(wrinkle)
    page[..., 5] = np.clip(9 * np.gradient(folded, axis=1), -0.55, 0.55)
    page[..., 6] = np.clip(-9 * np.gradient(folded, axis=0), -0.55, 0.55)
    _speckle(page, 22, 1.0, 0.08)
    for x, y, w, h in ((0, 0.32, 1, 0.006), (0, 0.68, 1, 0.006), (0.34, 0, 0.006, 1)):
        _box(page, x, y, w, h, (0.45, 0.26, 0.05), 0.3, 0.5)
    _box(page, 0.60, 0.10, 0.26, 0.15, (0.02, 0.02, 0.02), 0.0, 0.6)
    _disc(page, 0.20, 0.84, 0.075, (0.55, 0.56, 0.58), 0.45, 0.3)
    _disc(page, 0.20, 0.84, 0.045, (0.03, 0.03, 0.03), 0.0, 0.5)
    return page


def _stripe() -> Floats32:
    page = _blank((0.78, 0.78, 0.76), 0.0, 0.55)
    _speckle(page, 31, 0.9, 0.03)
    _box(page, 0, 0.20, 1, 0.14, (0.62, 0.02, 0.02), 0.0, 0.5)
    _box(page, 0, 0.355, 1, 0.02, (0.62, 0.02, 0.02), 0.0, 0.5)
    _box(page, 0.10, 0.72, 0.62, 0.21, (0.012, 0.035, 0.20), 0.1, 0.18)
    for line in range(1, 6):
        _box(page, 0.10 + 0.1033 * line, 0.72, 0.007, 0.21, (0.5, 0.5, 0.54), 0.4, 0.3)
    _print(page, "MACRAM", 0.10, 0.56, 1.35, (0.03, 0.03, 0.04), 4)
    _print(page, "01", 0.76, 0.90, 1.5, (0.03, 0.03, 0.04), 4)
    _screws(page)
    return page


def _copper() -> Floats32:
    page = _blank((0.016, 0.016, 0.018), 0.0, 0.42)
    _speckle(page, 41, 0.8, 0.10)
    for row in range(3):
        for column in range(5):
            copper: Rgb = (0.72, 0.34, 0.16)
            _box(page, 0.12 + 0.16 * column, 0.55 + 0.13 * row, 0.11, 0.085, copper, 0.45, 0.35)
    _box(page, 0.12, 0.12, 0.30, 0.26, (0.45, 0.46, 0.48), 0.45, 0.35)
    _box(page, 0.15, 0.15, 0.24, 0.20, (0.30, 0.31, 0.33), 0.45, 0.45)
    _print(page, "TX", 0.70, 0.38, 1.3, (0.72, 0.72, 0.68), 4)
    _screws(page)
    return page


def _plate() -> Floats32:
    page = _blank((0.50, 0.51, 0.53), 0.45, 0.36)
    streaks = cv2.GaussianBlur(power_field(TEXELS, 0.2, 51), (0, 0), sigmaX=14, sigmaY=0.7)
    page[..., :3] *= 1 + 0.10 * (streaks / streaks.std())[..., None]
    for x, y in ((0.12, 0.5), (0.88, 0.5), (0.5, 0.88)):
        _disc(page, x, y, 0.035, (0.02, 0.02, 0.02), 0.0, 0.6)
    _box(page, 0.70, 0.06, 0.18, 0.10, (0.75, 0.55, 0.03), 0.0, 0.5)
    _box(page, 0.74, 0.06, 0.03, 0.10, (0.02, 0.02, 0.02), 0.0, 0.5)
    _box(page, 0.81, 0.06, 0.03, 0.10, (0.02, 0.02, 0.02), 0.0, 0.5)
    _screws(page)
    return page


def _board() -> Floats32:
    page = _blank((0.018, 0.13, 0.045), 0.0, 0.4)
    _speckle(page, 61, 0.7, 0.08)
    random = np.random.default_rng(62)
    for _ in range(46):
        x, y, length = random.uniform(0.04, 0.9), random.uniform(0.04, 0.9), random.uniform(0.05, 0.3)
        across = bool(random.random() < 0.5)
        w, h = (length, 0.006) if across else (0.006, length)
        _box(page, x, y, min(w, 0.96 - x), min(h, 0.96 - y), (0.04, 0.22, 0.08), 0.1, 0.4)
    for column in range(12):
        _box(page, 0.10 + 0.068 * column, 0.90, 0.03, 0.05, (0.80, 0.58, 0.20), 0.45, 0.3)
    _box(page, 0.08, 0.06, 0.30, 0.13, (0.74, 0.74, 0.72), 0.0, 0.6)
    _print(page, "1U", 0.12, 0.165, 1.0, (0.03, 0.03, 0.03), 3)
    _screws(page)
    return page


_PAINT: dict[str, Callable[[], Floats32]] = {
    "cells": _cells,
    "gold": _gold,
    "stripe": _stripe,
    "copper": _copper,
    "plate": _plate,
    "board": _board,
}
