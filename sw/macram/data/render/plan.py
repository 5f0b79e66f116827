"""What happens in one sequence: orbit, Sun, camera and target motion, all from one seed.

The world frame is level at the camera: x east, y north, z up. Everything here is float64 and rounded where it
becomes a label, so that the labels are the same on every machine.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from macram.data.geometry import Floats, turn

EARTH_KM = 6371.0
ALTITUDE_KM = (450.0, 850.0)
SUN_CLEARANCE = np.cos(np.radians(60))
"""The Sun stays outside this cone around the optical axis."""
EARTH_IN_VIEW = 0.7
"""Share of sequences that are aimed so that the Earth is seen."""
GROUND_SPEED_KM = 7.0
"""Way of the ground below the camera from one frame to the next."""


@dataclass(frozen=True)
class View:
    """Size and intrinsics of the pictures: ``width`` x ``height`` pixels, ``focal`` pixels, centred."""

    width: int
    height: int
    focal: float

    @property
    def matrix(self) -> Floats:
        """``[3, 3]`` intrinsics."""
        return np.array([[self.focal, 0, self.width / 2], [0, self.focal, self.height / 2], [0, 0, 1.0]])


@dataclass(frozen=True)
class Plan:
    """One sequence of N frames.

    Attributes:
        altitude: of the camera, km.
        latitude, longitude: of the ground point below the camera in the middle of the sequence, radians.
        sun: ``[3]`` unit vector towards the Sun, world frame.
        cameras: ``[N, 3, 3]`` world to camera.
        rotations: ``[N, 3, 3]`` target to camera.
        translations: ``[N, 3]`` target origin in the camera frame, mm.
        drift: ``[N, 2]`` way of the ground point from the middle of the sequence, km east and north.
        gains: ``[N]`` factors on the automatic exposure.
        grain: ``[N]`` seeds of the sensor noise.
        weather: seed of clouds and stars.
        cloudiness: share of the sky covered, 0 to 1.
    """

    altitude: float
    latitude: float
    longitude: float
    sun: Floats
    cameras: Floats
    rotations: Floats
    translations: Floats
    drift: Floats
    gains: Floats
    grain: tuple[int, ...]
    weather: int
    cloudiness: float


def plan_sequence(
    seed: tuple[int, int, int],
    frames: int,
    view: View,
    depth: tuple[float, float],
    width: float,
) -> Plan:
    """Draw a sequence.

    Args:
        seed: base seed, number of the split, number of the sequence; nothing else decides the result.
        frames: how many frames.
        view: camera.
        depth: nearest and farthest depth of the target's origin, mm.
        width: a typical width of the target, mm; keeps most of it in the picture.
    """
    random = np.random.default_rng(np.random.SeedSequence(list(seed)))
    altitude = random.uniform(*ALTITUDE_KM)
    latitude = np.arcsin(random.uniform(-0.93, 0.93))
    longitude = random.uniform(-np.pi, np.pi)
    horizon = np.arcsin(EARTH_KM / (EARTH_KM + altitude))
    steps = np.linspace(-0.5, 0.5, frames) if frames > 1 else np.zeros(1)

    while True:
        sun = _direction(random)
        # Behind the Earth when below the horizon, with a margin for the dim red ring around it.
        if np.arccos(np.clip(-sun[2], -1, 1)) < horizon + np.radians(4):
            continue
        if random.random() < EARTH_IN_VIEW:
            away = random.uniform(0.0, horizon + np.radians(12))
            azimuth = random.uniform(0, 2 * np.pi)
            axis = np.array([np.sin(away) * np.cos(azimuth), np.sin(away) * np.sin(azimuth), -np.cos(away)])
        else:
            axis = _direction(random)
        start = _looking_along(axis, random.uniform(0, 2 * np.pi))
        slew_axis, slew = _direction(random), np.radians(random.uniform(0, 12))
        cameras = np.stack([turn(slew_axis, slew * step) @ start for step in steps])
        if (cameras[:, 2] @ sun).max() < SUN_CLEARANCE:
            break

    spin, rate = _direction(random), np.radians(random.uniform(4, 18)) * max(frames - 1, 1)
    first = _any_rotation(random)
    rotations = np.stack([turn(spin, rate * step) @ first for step in steps])

    ends = random.uniform(*depth, 2)
    depths = ends[0] + (ends[1] - ends[0]) * (steps + 0.5)
    half = np.array([view.width, view.height]) / 2
    # In units of the room that the target leaves: at the ends of this range a good part stays visible.
    way = random.uniform(-1, 1, (2, 2))
    room = np.maximum(half[None, :] - 0.36 * view.focal * width / depths[:, None], 0.12 * half[None, :])
    offset = (way[0] + (way[1] - way[0]) * (steps[:, None] + 0.5)) * room
    translations = np.column_stack([offset * depths[:, None] / view.focal, depths])

    heading = random.uniform(0, 2 * np.pi)
    along = GROUND_SPEED_KM * max(frames - 1, 1) * steps
    return Plan(
        altitude=float(altitude),
        latitude=float(latitude),
        longitude=float(longitude),
        sun=sun,
        cameras=cameras,
        rotations=np.round(rotations, 12),
        translations=np.round(translations, 6),
        drift=along[:, None] * np.array([np.cos(heading), np.sin(heading)]),
        gains=np.exp(random.normal(0.0, 0.22, frames)),
        grain=tuple(int(value) for value in random.integers(0, 2**32, frames)),
        weather=int(random.integers(0, 2**32)),
        cloudiness=float(random.uniform(0.2, 0.65)),
    )


def _direction(random: np.random.Generator) -> Floats:
    """Uniform unit vector."""
    vector = random.normal(size=3)
    return np.asarray(vector / np.linalg.norm(vector))


def _any_rotation(random: np.random.Generator) -> Floats:
    """Uniform rotation matrix, from a uniform quaternion."""
    quaternion = random.normal(size=4)
    w, *axis = quaternion / np.linalg.norm(quaternion)
    length = float(np.linalg.norm(axis))
    return turn(np.asarray(axis) / length, 2 * float(np.arctan2(length, w)))


def _looking_along(axis: Floats, roll: float) -> Floats:
    """World-to-camera rotation whose third row is ``axis``."""
    other = np.eye(3)[int(np.argmin(np.abs(axis)))]
    right = np.cross(other, axis)
    right /= np.linalg.norm(right)
    level = np.stack([right, np.cross(axis, right), axis])
    return np.asarray(turn(np.array([0.0, 0.0, 1.0]), roll) @ level)
