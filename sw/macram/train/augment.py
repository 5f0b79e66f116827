"""Random views of a training frame whose pose labels stay exact; NumPy and OpenCV only.

A turn of the picture about its principal point is a roll of the camera: it moves R and t. Scale and shift of
a perspective picture are no motion of the object, so they go into the camera matrix of the sample. One affine
map covers the resize to the network's input and all three, and the labels follow it without residual.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from macram.data.erase import GROWTH, grow
from macram.pose.rigid import Floats, Pose, camera_matrix
from macram.pose.warp import (
    BORDER,
    Draw,
    Image,
    Mask,
    Warp,
    exact_warp,
    move_points,
    reference_warp,
    warp_image,
    warp_mask,
)

__all__ = [
    "ATTEMPTS",
    "BORDER",
    "FEWEST_PIXELS",
    "GROWTH",
    "NONE",
    "PUBLISHED",
    "AugmentSettings",
    "Draw",
    "Sample",
    "Warp",
    "augment",
    "draw",
    "exact_warp",
    "grow",
    "move_points",
    "reference_warp",
    "warp_image",
    "warp_mask",
]

Labels = Literal["exact", "reference"]
Draws = Literal["shared", "independent"]

# A view is drawn again while fewer object pixels than this remain in it, at most so many times.
FEWEST_PIXELS = 10
ATTEMPTS = 20


@dataclass(frozen=True, slots=True)
class AugmentSettings:
    """How far views are varied.

    Attributes:
        rotation_deg: turn about the principal point, uniform in plus or minus this.
        scale: zoom, uniform in 1 plus or minus this.
        shift: move, uniform in plus or minus this part of width and height.
        gamma: brightness exponent, log-uniform between its inverse and this (1: none).
        exposure: gain, log-uniform between its inverse and this (1: none).
        noise: standard deviation of the added noise, uniform in 0 .. this, grey levels of 255.
        labels: "exact", or "reference": turn and zoom about the image centre, then a pose refitted by EPnP to
            the moved keypoints under the unchanged camera, as published. Such poses do not fit the picture.
        draws: "shared" moves image and counterfactual image alike; "independent" draws twice, as the
            published code does, so that the two show different views.
        centred: bring the model origin to the middle of the view before the shift, for crops around the
            object; with exact labels only.

    Raises:
        ValueError: a value out of range.
    """

    rotation_deg: float = 180.0
    scale: float = 0.1
    shift: float = 0.1
    gamma: float = 1.3
    exposure: float = 1.4
    noise: float = 4.0
    labels: Labels = "exact"
    draws: Draws = "shared"
    centred: bool = False

    def __post_init__(self) -> None:
        if not (0 <= self.rotation_deg <= 180 and 0 <= self.scale < 1 and 0 <= self.shift < 1):
            raise ValueError(
                f"rotation_deg {self.rotation_deg}, scale {self.scale}, shift {self.shift}: "
                "must lie in 0..180, 0..1 and 0..1"
            )
        if not (1 <= self.gamma < np.inf and 1 <= self.exposure < np.inf and 0 <= self.noise <= 255):
            raise ValueError(
                f"gamma {self.gamma}, exposure {self.exposure}, noise {self.noise}: "
                "must be at least 1, at least 1, and 0..255 (1, 1, 0 switch them off)"
            )
        if self.labels not in ("exact", "reference") or self.draws not in ("shared", "independent"):
            raise ValueError(
                f'labels {self.labels!r}, draws {self.draws!r}: choose "exact" or "reference", '
                '"shared" or "independent"'
            )
        if self.centred and self.labels == "reference":
            raise ValueError('labels "reference" keep the camera and cannot be centred; use labels "exact"')


NONE = AugmentSettings(rotation_deg=0.0, scale=0.0, shift=0.0, gamma=1.0, exposure=1.0, noise=0.0)
PUBLISHED = AugmentSettings(gamma=1.0, exposure=1.0, noise=0.0, labels="reference", draws="independent")


@dataclass(frozen=True, slots=True, eq=False)
class Sample:
    """A frame, or a view of one.

    Attributes:
        image: ``[height, width, 3]`` uint8.
        mask: ``[height, width]`` bool, where the object is visible.
        pose: object to camera, mm.
        K: ``[3, 3]`` camera matrix of ``image``.
        counterfactual: the same view without the object, ``[height, width, 3]``. In a frame: the true
            background, or None to have the object erased. In a view: always there.
    """

    image: Image
    mask: Mask
    pose: Pose
    K: Floats
    counterfactual: Image | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "K", camera_matrix(self.K))
        shape = self.image.shape
        if len(shape) != 3 or shape[2] != 3 or self.image.dtype != np.uint8:
            raise ValueError(f"an image is uint8 [height, width, 3], not {self.image.dtype} {list(shape)}")
        if self.mask.shape != shape[:2] or self.mask.dtype != np.bool_:
            raise ValueError(
                f"the mask is {self.mask.dtype} {list(self.mask.shape)}; it must be bool {list(shape[:2])}"
            )
        if self.counterfactual is not None and self.counterfactual.shape != shape:
            raise ValueError(
                f"the background is {list(self.counterfactual.shape)}, the image {list(shape)}; "
                "both must have one size"
            )


def draw(rng: np.random.Generator, settings: AugmentSettings, size: tuple[int, int]) -> Draw:
    """A random move for views of ``size`` ``(width, height)``; shifts are whole pixels, as published."""
    turn = np.radians(settings.rotation_deg)
    angle, zoom = rng.uniform(-turn, turn), rng.uniform(1 - settings.scale, 1 + settings.scale)
    reach = [int(settings.shift * side) for side in size]
    shift = [float(rng.integers(-r, r, endpoint=True)) for r in reach]
    return Draw(float(angle), float(zoom), (shift[0], shift[1]))


def augment(
    frame: Sample,
    rng: np.random.Generator,
    settings: AugmentSettings,
    *,
    target: ArrayLike,
    size: tuple[int, int],
    keypoints: ArrayLike,
) -> Sample:
    """A random view of a frame.

    A draw that leaves fewer than `FEWEST_PIXELS` object pixels in the view is repeated; after `ATTEMPTS` the
    view is the plain one. It is always a view of this frame.

    Args:
        frame: image, mask, pose and camera; its background or None.
        rng: generator; the same state gives the same view.
        settings: how far to go.
        target: ``[3, 3]`` camera matrix of the network's input.
        size: ``(width, height)`` of the network's input, px.
        keypoints: ``[k, 3]`` model points, mm; read by ``labels="reference"`` only.

    Returns:
        The view, with its own K and pose, and a counterfactual image. An erased object is black (0) there,
        whatever the brightness and the noise are.
    """
    warp = _drawn(frame, rng, settings, target, size, keypoints)
    other = warp
    if settings.draws == "independent":
        other = _drawn(frame, rng, settings, target, size, keypoints)
    tone, noise = _photometric(rng, settings, size)
    image = _toned(warp_image(frame.image, warp), tone, noise)
    if frame.counterfactual is not None:
        without = _toned(warp_image(frame.counterfactual, other), tone, noise)
    else:
        without = image.copy() if other is warp else _toned(warp_image(frame.image, other), tone, noise)
        without[warp_mask(grow(frame.mask), other)] = 0
    return Sample(image, warp_mask(frame.mask, warp), warp.pose, warp.K, without)


def _drawn(
    frame: Sample,
    rng: np.random.Generator,
    settings: AugmentSettings,
    target: ArrayLike,
    size: tuple[int, int],
    keypoints: ArrayLike,
) -> Warp:
    for attempt in range(ATTEMPTS + 1):
        move = draw(rng, settings, size) if attempt < ATTEMPTS else Draw()
        if settings.labels == "reference":
            warp = reference_warp(move, frame.K, target, size, frame.pose, keypoints)
        else:
            warp = exact_warp(move, frame.K, target, size, frame.pose, centred=settings.centred)
        if np.count_nonzero(warp_mask(frame.mask, warp)) >= FEWEST_PIXELS:
            break
    return warp


def _photometric(
    rng: np.random.Generator, settings: AugmentSettings, size: tuple[int, int]
) -> tuple[NDArray[np.float32], NDArray[np.float32] | None]:
    """Grey level table ``[256]`` and the noise ``[height, width, 3]`` of one view; no noise: None."""
    gamma = np.exp(rng.uniform(-1, 1) * np.log(settings.gamma))
    gain = np.exp(rng.uniform(-1, 1) * np.log(settings.exposure))
    level = rng.uniform(0, settings.noise)
    tone = np.asarray(255.0 * gain * (np.arange(256) / 255.0) ** gamma, np.float32)
    if level == 0:
        return tone, None
    return tone, np.float32(level) * rng.standard_normal((size[1], size[0], 3), np.float32)


def _toned(image: Image, tone: NDArray[np.float32], noise: NDArray[np.float32] | None) -> Image:
    """Rounded once, after everything, and clipped to 0..255."""
    light = tone[image] if noise is None else tone[image] + noise
    return np.asarray(np.clip(np.rint(light), 0, 255), np.uint8)
