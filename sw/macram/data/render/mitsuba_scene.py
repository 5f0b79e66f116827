"""The renderer's scene for Mitsuba 3, a path tracer: an independent opinion on shape, shadow and shading.

Mitsuba's world is our camera frame in millimetres. The same patches, texture pages, Sun, ground and clouds go
in; what the Earth's air adds, and the grain of the ground finer than its chart, stay out.
"""

from __future__ import annotations

import importlib
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from macram.data.geometry import Floats
from macram.data.render.cubesat import cubesat
from macram.data.render.earth import CHART, Earth
from macram.data.render.faces import PAGES, atlases
from macram.data.render.patches import Floats32
from macram.data.render.plan import EARTH_KM, Plan, View

Scene = dict[str, Any]
"""As `mitsuba.load_dict` takes it, but with arrays for transforms ``[4, 4]`` and bitmaps ``[H, W, C]``."""

KM = 1e4
"""Millimetres that stand for a kilometre. Only directions matter so far away, and float32 keeps those: the target
is still 10,000 times smaller than its height over the ground."""

EARTH_ROWS, EARTH_COLUMNS = 2048, 1024
"""Texels of the globe from the camera's zenith to its nadir, and around that axis."""

BOUNCES = 4


def scene_of(plan: Plan, earth: Earth, number: int, view: View, samples: int) -> Scene:
    """One frame as Mitsuba's scene; needs no Mitsuba.

    Args:
        plan: of the sequence.
        earth: of the same plan.
        number: of the frame in the plan.
        view: camera.
        samples: per pixel.
    """
    camera = plan.cameras[number]
    centre = -(EARTH_KM + plan.altitude) * KM * camera[:, 2]
    return {
        "type": "scene",
        "integrator": {"type": "path", "max_depth": BOUNCES, "hide_emitters": True},
        "sensor": _sensor(view, samples),
        "sun": {
            "type": "directional",
            "direction": (-camera @ plan.sun).tolist(),
            "irradiance": {"type": "rgb", "value": 1.0},
        },
        "earth": {
            "type": "sphere",
            "to_world": _placed(EARTH_KM * KM * camera, centre),
            "bsdf": {"type": "diffuse", "reflectance": _bitmap(_globe(earth, plan.drift[number]))},
        },
        **_target(plan.rotations[number], plan.translations[number]),
    }


def silhouette_of(scene: Scene) -> Scene:
    """The same scene with the target alone; its alpha channel is the target's coverage."""
    kept = {name: value for name, value in scene.items() if name not in ("sun", "earth")}
    return {**kept, "integrator": {"type": "depth"}}


def trace(scene: Scene, seed: int = 0) -> Floats32:
    """``[H, W, 4]`` linear radiance and coverage.

    Raises:
        ValueError: Mitsuba is not installed.
    """
    try:
        mitsuba = importlib.import_module("mitsuba")
    except ImportError:
        raise ValueError("Mitsuba is not installed; pip install 'macram[mitsuba]'") from None
    mitsuba.set_variant("scalar_rgb")
    # It warns of shear in a sphere whose float32 rotation is off by 1e-6 of a radius in millimetres.
    mitsuba.set_log_level(mitsuba.LogLevel.Error)
    loaded = mitsuba.load_dict(_native(mitsuba, scene))
    return np.array(mitsuba.render(loaded, seed=seed), np.float32)


def _native(mitsuba: Any, value: Any, name: str = "") -> Any:
    """Arrays turned into Mitsuba's own types."""
    if isinstance(value, dict):
        return {key: _native(mitsuba, part, key) for key, part in value.items()}
    if isinstance(value, np.ndarray):
        return mitsuba.Bitmap(value) if name == "bitmap" else mitsuba.ScalarTransform4f(value)
    return value


def _sensor(view: View, samples: int) -> Scene:
    return {
        "type": "perspective",
        "fov": float(np.degrees(2 * np.arctan(view.width / (2 * view.focal)))),
        "fov_axis": "x",
        "near_clip": 20.0,
        "far_clip": 3 * EARTH_KM * KM,
        # Mitsuba's camera has x to the left and y upwards.
        "to_world": np.diag([-1.0, -1.0, 1.0, 1.0]),
        "film": {
            "type": "hdrfilm",
            "width": view.width,
            "height": view.height,
            "pixel_format": "rgba",
            "rfilter": {"type": "box"},
        },
        "sampler": {"type": "multijitter", "sample_count": samples},
    }


def _target(rotation: Floats, translation: Floats) -> Scene:
    """Materials and rectangles of the satellite, in the camera frame."""
    atlas, patches = atlases()[0], cubesat()
    scene: Scene = {}
    for name, page in PAGES.items():
        size = int(atlas.size[page])
        texels = atlas.texels[atlas.start[page] :][: size * size].reshape(size, size, 7)
        # Mitsuba's first row is at v = 0, the bottom of a page.
        scene[f"material {name}"] = {
            **_material(np.ascontiguousarray(texels[::-1])),
            "id": f"material {name}",
        }
    names = list(PAGES)
    for m in range(len(patches.page)):
        across, up = patches.across[m] / 2, patches.up[m] / 2
        # Mitsuba's rectangle reaches from -1 to 1.
        linear = rotation @ np.column_stack([across, up, patches.normal[m]])
        centre = rotation @ (patches.origin[m] + across + up) + translation
        scene[f"patch {m:03d}"] = {
            "type": "rectangle",
            "to_world": _placed(linear, centre),
            "bsdf": {"type": "ref", "id": f"material {names[patches.page[m]]}"},
        }
    return scene


def _material(texels: Floats32) -> Scene:
    """Mitsuba's principled BSDF, whose GGX lobe has the same roughness as ours (alpha is its square)."""
    glossy: Scene = {
        "type": "principled",
        "base_color": _bitmap(texels[..., :3]),
        "metallic": _bitmap(texels[..., 3:4]),
        "roughness": _bitmap(texels[..., 4:5]),
        "specular": 0.5,  # reflects 4 % head-on
    }
    if not texels[..., 5:].any():
        return glossy
    normal = np.concatenate([texels[..., 5:], np.ones_like(texels[..., :1])], axis=2)
    normal /= np.linalg.norm(normal, axis=2, keepdims=True)
    return {"type": "normalmap", "normalmap": _bitmap((normal + 1) / 2), "bsdf": glossy}


def _globe(earth: Earth, drift: Floats) -> Floats32:
    """``[EARTH_ROWS, EARTH_COLUMNS, 3]`` albedo of ground and clouds around the camera's zenith.

    The chart holds what the camera can see; its border is repeated over the rest of the globe.
    """
    down = (np.arange(EARTH_ROWS) + 0.5) * np.pi / EARTH_ROWS
    around = (np.arange(EARTH_COLUMNS) + 0.5) * 2 * np.pi / EARTH_COLUMNS
    reach = EARTH_KM * np.sin(np.minimum(down, np.pi / 2))[:, None]
    column = (reach * np.cos(around) + drift[0]) * earth.scale + CHART / 2 - 0.5
    row = (reach * np.sin(around) + drift[1]) * earth.scale + CHART / 2 - 0.5
    ground, sky = (
        cv2.remap(
            chart,
            column.astype(np.float32),
            row.astype(np.float32),
            cv2.INTER_LINEAR,
            borderMode=cv2.BORDER_REPLICATE,
        )
        for chart in (earth.ground, earth.sky)
    )
    cover = np.clip((sky[..., :1] + 0.05) / 0.9, 0, 1)
    cloud = (0.50 + 0.28 * cover) * np.clip(1 + 1.6 * sky[..., 1:], 0.55, 1.35)
    albedo = ground[..., :3] + cover * (cloud - ground[..., :3])
    return np.asarray(np.clip(albedo, 0, 1), np.float32)


def _bitmap(values: NDArray[np.floating]) -> Scene:
    return {"type": "bitmap", "bitmap": np.ascontiguousarray(values, np.float32), "raw": True}


def _placed(linear: Floats, origin: Floats) -> Floats:
    """``[4, 4]`` transform of a linear part and a place."""
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = linear, origin
    return matrix
