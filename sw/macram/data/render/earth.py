"""The Earth below one sequence: ground, water, clouds and air, for any direction of view.

Once per sequence the visible cap is gathered into a chart: the ground as seen from straight above, so that a
point of the sphere is found by its x and y alone. The radiance of a direction is then a handful of look-ups.
Radiance is relative to the Sun's irradiance of 1: a white sheet facing the Sun has 1/pi.
"""

from __future__ import annotations

from functools import cache
from importlib import resources

import cv2
import numpy as np
from numpy.typing import NDArray

from macram.data.geometry import Floats
from macram.data.render.fields import power_field
from macram.data.render.patches import Floats32
from macram.data.render.plan import EARTH_KM, Plan

CHART = 1024
"""Rows and columns of the chart, of the cloud fields and of the fine detail."""

FINE_KM = 700.0
"""Period of the fine detail on the ground."""

DEPTH_RGB = np.array([0.055, 0.11, 0.24], np.float32)
"""Optical depth of the air straight down: red, green, blue."""

WATER_RGB = np.array([0.010, 0.026, 0.055], np.float32)
GLINT_ROUGHNESS = 0.3


@cache
def _albedo() -> NDArray[np.uint8]:
    """Equirectangular Blue Marble, sRGB bytes, red first."""
    packed = np.frombuffer(
        resources.files("macram.data.render").joinpath("assets/earth.jpg").read_bytes(), np.uint8
    )
    picture = cv2.imdecode(packed, cv2.IMREAD_COLOR)
    return np.asarray(cv2.cvtColor(np.asarray(picture), cv2.COLOR_BGR2RGB), np.uint8)


@cache
def _fields() -> tuple[Floats32, Floats32, Floats32]:
    """Large clouds, cloud detail, terrain: shared by all sequences, which look at different parts of them."""
    return (
        power_field(CHART, 1.75, 101),
        power_field(CHART, 1.25, 102, cutoff=3),
        power_field(CHART, 1.15, 103, cutoff=2),
    )


def _wrapped(texture: Floats32, columns: Floats32, rows: Floats32, cubic: bool = False) -> Floats32:
    """Texture with periodic borders at fractional positions, in texels."""
    method = cv2.INTER_CUBIC if cubic else cv2.INTER_LINEAR
    return np.asarray(cv2.remap(texture, columns, rows, method, borderMode=cv2.BORDER_WRAP), np.float32)


def _step(low: float, high: float, value: Floats32) -> Floats32:
    """0 below ``low``, 1 above ``high``, smooth between."""
    t = np.clip((value - low) * np.float32(1 / (high - low)), 0, 1)
    return np.asarray(t * t * (3 - 2 * t))


def _air(cosine: Floats32) -> Floats32:
    """Path through the air relative to straight down (Rozenberg's formula, 40 at the horizon)."""
    c = np.maximum(cosine, 0)
    return np.asarray(1 / (c + 0.025 * np.exp(-11 * c)))


class Earth:
    """The planet as one sequence sees it.

    Args:
        plan: orbit, Sun and weather.
    """

    def __init__(self, plan: Plan) -> None:
        self.radius = EARTH_KM / (EARTH_KM + plan.altitude)  # the camera is at height 1 above the centre
        self.altitude = plan.altitude
        self.sun = plan.sun.astype(np.float32)
        reach = EARTH_KM * float(np.sqrt(1 - self.radius**2)) + 260
        self.scale = CHART / (2 * reach)
        random = np.random.default_rng(plan.weather)
        self.shift = random.uniform(0, CHART, (4, 2)).astype(np.float32)
        axis = (np.arange(CHART, dtype=np.float32) + 0.5 - CHART / 2) / np.float32(self.scale)
        self._terrain = _fields()[2]
        self.ground = self._chart_ground(plan, axis)
        self.sky = self._chart_clouds(plan, axis, float(random.uniform(0, np.pi)))

    def _chart_ground(self, plan: Plan, axis: Floats32) -> Floats32:
        """``[CHART, CHART, 4]`` linear albedo and share of water."""
        # Fractal coastlines: the map's cells of 20 km are displaced by terrain of the chart's finer cells.
        rough = np.roll(self._terrain, (int(self.shift[0, 0]), int(self.shift[0, 1])), (0, 1))
        x = (axis[None, :] + 9 * rough) / np.float32(EARTH_KM)
        y = (axis[:, None] + 9 * np.roll(rough, CHART // 3, 0)) / np.float32(EARTH_KM)
        z = np.sqrt(np.maximum(1 - x * x - y * y, 0.02))
        sine, cosine = np.float32(np.sin(plan.latitude)), np.float32(np.cos(plan.latitude))
        north = np.clip(y * cosine + z * sine, -1, 1)
        latitude = np.arcsin(north)
        longitude = np.arctan2(x, z * cosine - y * sine) + np.float32(plan.longitude)
        picture = _albedo()
        rows, columns = picture.shape[:2]
        column = (longitude / np.float32(2 * np.pi) + 0.5) * columns - 0.5
        row = (0.5 - latitude / np.float32(np.pi)) * rows - 0.5
        colour = cv2.remap(
            picture, column, np.clip(row, 0, rows - 1), cv2.INTER_LINEAR, borderMode=cv2.BORDER_WRAP
        )
        linear = _linear()[colour]
        # Deep water is dark and blue; ice and land are not.
        water = _step(0.012, 0.035, linear[..., 2] - 1.15 * linear[..., 0]) * (
            1 - _step(0.10, 0.2, linear[..., 0])
        )
        grey = linear.mean(axis=2, keepdims=True)
        land = (0.72 * linear + 0.28 * grey) * np.float32(0.82) + np.float32(0.01)
        land *= (1 + 0.10 * np.clip(rough, -2.5, 2.5))[..., None]
        ground = np.empty((CHART, CHART, 4), np.float32)
        ground[..., :3] = land + water[..., None] * (WATER_RGB + 0.25 * linear - land)
        ground[..., 3] = water
        return ground

    def _chart_clouds(self, plan: Plan, axis: Floats32, heading: float) -> Floats32:
        """``[CHART, CHART, 2]`` cloud density, 0 at the edge of a cloud, and its slope towards the Sun."""
        broad, fine, _ = _fields()
        texels = np.float32(CHART / 7200.0)
        c, s = np.float32(np.cos(heading)), np.float32(np.sin(heading))
        # Streaks: stretched along a heading, then bent by a slow field.
        along = (c * axis[None, :] + s * axis[:, None]) * texels
        across = (c * axis[:, None] - s * axis[None, :]) * texels * np.float32(1.7)
        bend = cv2.resize(broad[::8, ::8], (CHART, CHART), interpolation=cv2.INTER_CUBIC)
        bend = np.roll(bend, (int(self.shift[3, 0]), int(self.shift[3, 1])), (0, 1))
        first = _wrapped(broad, along + 22 * bend + self.shift[1, 0], across + 30 * bend + self.shift[1, 1])
        second = _wrapped(fine, 3 * along + 24 * bend + self.shift[2, 0], 2.4 * across + self.shift[2, 1])
        density = first + np.float32(0.30) * second
        density -= np.float32(np.quantile(density[::8, ::8], 1 - plan.cloudiness))
        slope = np.gradient(cv2.GaussianBlur(density, (0, 0), 1.2))
        lit = slope[1] * self.sun[0] + slope[0] * self.sun[1]
        return np.ascontiguousarray(np.stack([density, -lit], axis=2), np.float32)

    def radiance(self, directions: Floats32, drift: Floats, footprint: float) -> Floats32:
        """Light from the Earth and its air.

        Args:
            directions: ``[H, W, 3]`` unit vectors, world frame.
            drift: ``[2]`` way of the ground point from the chart's centre, km.
            footprint: km on the ground per sample straight down; finer detail is left out.

        Returns:
            ``[H, W, 3]`` radiance; 0 where there is only space.
        """
        d = directions
        result = np.zeros((*d.shape[:2], 3), np.float32)
        lowest = np.where(d[..., 2] < 0, np.sqrt(np.maximum(1 - d[..., 2] ** 2, 0)), 1)
        above = (lowest - self.radius) * np.float32(EARTH_KM / self.radius)
        hit = above <= 0
        if hit.any():
            rows, columns = np.flatnonzero(hit.any(axis=1)), np.flatnonzero(hit.any(axis=0))
            window = np.s_[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
            surface = self._surface(d[window], drift, footprint)
            np.copyto(result[window], surface, where=hit[window][..., None])
        rim = (above > 0) & (above < 220)
        if rim.any():
            result[rim] = self._limb(d[rim], np.asarray(above[rim], np.float32))
        return result

    def _surface(self, d: Floats32, drift: Floats, footprint: float) -> Floats32:
        b = d[..., 2]
        root = np.sqrt(np.maximum(b * b - np.float32(1 - self.radius**2), 0))
        way = -b - root
        normal = d * (way / np.float32(self.radius))[..., None]
        normal[..., 2] += np.float32(1 / self.radius)
        view = np.maximum(root / np.float32(self.radius), 0)
        sun = normal @ self.sun
        x = normal[..., 0] * np.float32(EARTH_KM) + np.float32(drift[0])
        y = normal[..., 1] * np.float32(EARTH_KM) + np.float32(drift[1])
        column = x * np.float32(self.scale) + np.float32(CHART / 2 - 0.5)
        row = y * np.float32(self.scale) + np.float32(CHART / 2 - 0.5)
        chart = cv2.remap(self.ground, column, row, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
        sky = cv2.remap(self.sky, column, row, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
        fine = np.float32(CHART / FINE_KM)
        detail = _wrapped(self._terrain, x * fine, y * fine)
        # Detail smaller than a sample would only be grain.
        size = (
            footprint * way * np.float32((EARTH_KM + self.altitude) / self.altitude) / np.maximum(view, 0.05)
        )
        detail *= np.clip(4.0 / (size + 1.0) - 0.35, 0, 1).astype(np.float32)

        water = chart[..., 3]
        albedo = chart[..., :3] * (1 + 0.12 * detail * (1 - water))[..., None]
        density = sky[..., 0] + np.float32(0.20) * detail
        cover = _step(-0.05, 0.85, density)
        day = np.maximum(sun, 0)
        sunlight = np.exp(-DEPTH_RGB * _air(sun)[..., None])
        sunlight *= np.maximum(day, 0.35 * _step(-0.10, 0.12, sun) ** 2 * 0.3)[..., None]
        relief = np.clip(1 + 1.6 * sky[..., 1] + 0.10 * detail, 0.55, 1.35)
        cloud = (0.50 + 0.28 * _step(0.1, 1.4, density)) * relief / np.float32(np.pi)
        ground = albedo * np.float32(1 / np.pi)
        if water.any():
            ground += (self._glint(d, normal, sun, view) * water)[..., None]
        light = ground + cover[..., None] * (cloud[..., None] - ground)
        light *= sunlight

        column_air = _air(view)[..., None]
        through = np.exp(-DEPTH_RGB * (column_air * (1 - 0.55 * cover[..., None])))
        return np.asarray(light * through + self._scattered(d, sun, through), np.float32)

    def _scattered(self, d: Floats32, sun: Floats32, through: Floats32) -> Floats32:
        """Sunlight scattered by the air on the way: blue haze, bright at the limb, red at the terminator."""
        phase = 0.75 * (1 + (d @ self.sun) ** 2)
        lit = _step(-0.12, 0.25, sun)[..., None]
        colour = np.exp(-DEPTH_RGB * np.minimum(0.35 * _air(sun + 0.04), 4.0)[..., None])
        return np.asarray((1 - through) * (lit * colour) * (np.float32(0.085) * phase)[..., None], np.float32)

    def _limb(self, d: Floats32, above: Floats32) -> Floats32:
        """``[N, 3]`` glow of rays that pass ``above`` km over the ground."""
        tangent = d * -d[:, 2:]
        tangent[:, 2] += 1
        tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
        column = 26 * np.exp(-above / 11) + 1.1 * np.exp(-above / 30)
        through = np.asarray(np.exp(-DEPTH_RGB * column[:, None]), np.float32)
        return self._scattered(d, np.asarray(tangent @ self.sun, np.float32), through)

    def _glint(self, d: Floats32, normal: Floats32, sun: Floats32, view: Floats32) -> Floats32:
        """The Sun's reflection on a rough sea, GGX with Schlick's Fresnel term for water."""
        half = self.sun - d
        half /= np.linalg.norm(half, axis=2, keepdims=True)
        cosine = np.einsum("ijk,ijk->ij", half, normal)
        squared = np.float32(GLINT_ROUGHNESS**4)
        lobe = squared / (np.pi * (cosine**2 * (squared - 1) + 1) ** 2)
        fresnel = 0.02 + 0.98 * np.maximum(1 - half @ self.sun, 0) ** 5
        return np.asarray(lobe * fresnel * 0.25 / np.maximum(sun * view, 0.15) * (sun > 0), np.float32)


@cache
def _linear() -> Floats32:
    """Linear value of each sRGB byte."""
    value = np.arange(256) / 255
    return np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4).astype(np.float32)
