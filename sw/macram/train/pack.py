"""Frames of a split, decoded once into one uint8 memory map, so that training never waits for JPEG."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import tempfile
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from macram.data.erase import grow
from macram.data.frame import Frame, Model, hull_mask
from macram.data.geometry import project
from macram.data.open import open_dataset
from macram.kept import cache
from macram.train.settings import DataSettings

LAYOUT = 1
"""Raised whenever packed files change their meaning."""
PART, BODY = 128, 255
"""Mask values: 0 elsewhere; cells on ``BODY`` may be positive."""
MASK_POINTS = 64
"""Pixels of each mask kept as a list, evenly spread over it, to tell how much of it a view shows."""
INPAINT_RADIUS = 3.0
Told = Callable[[int, int], None]


@dataclass(frozen=True, eq=False)
class PackedFrames:
    """A split in memory maps.

    Attributes:
        names: of the frames.
        pixels: uint8 ``[N, H, W, 4]``: red, green, blue, mask: 255 where the target is seen, 128 where that is
            nothing to learn a pose from, see ``data.positives``.
        filled: uint8 ``[N, H, W, 3]``, the picture without the target; None where it is to be blacked out.
        rotation: float64 ``[N, 3, 3]``, object to camera.
        translation: float64 ``[N, 3]``, mm.
        camera: float64 ``[N, 3, 3]``, pixels; pixel centres at whole numbers plus a half.
        mask_points: float64 ``[N, 64, 2]``, centres of mask pixels; repeated where there are fewer.
        mask_pixels: int64 ``[N]``, mask pixels in all.
        model: the object.
    """

    names: tuple[str, ...]
    pixels: NDArray[np.uint8]
    filled: NDArray[np.uint8] | None
    rotation: NDArray[np.float64]
    translation: NDArray[np.float64]
    camera: NDArray[np.float64]
    mask_points: NDArray[np.float64]
    mask_pixels: NDArray[np.int64]
    model: Model

    def __len__(self) -> int:
        return len(self.names)

    @property
    def size(self) -> tuple[int, int]:
        """Height and width of the frames."""
        return self.pixels.shape[1], self.pixels.shape[2]


def pack_frames(
    settings: DataSettings, split: str, *, filled: bool, told: Told | None = None
) -> PackedFrames:
    """The frames of a split, from the cache or decoded now.

    Args:
        settings: data set, shrink, limit, cache, and what fills the target's place.
        split: which frames.
        filled: pack the pictures without the target too, unless they are made by blacking out.
        told: called with the number of decoded frames and their total.

    Raises:
        ValueError: no frames, frames of different sizes, or a bad file; one line that names it.
    """
    dataset = open_dataset(Path(settings.root), settings.shrink)
    frames = thinned(dataset.frames(split), settings.limit)
    if not frames:
        raise ValueError(f"{settings.root}: split {split} has no frames")
    fill = settings.counterfactual if filled and settings.counterfactual != "erase" else ""
    folder = cache_root(settings) / _key(frames, fill, settings.positives)
    if not (folder / "done.json").is_file():
        _write(folder, frames, fill, settings.positives, told or (lambda done, total: None))
    points = np.load(folder / "mask_points.npy")
    return PackedFrames(
        tuple(frame.name for frame in frames),
        np.load(folder / "pixels.npy", mmap_mode="r"),
        np.load(folder / "filled.npy", mmap_mode="r") if fill else None,
        np.stack([frame.rotation for frame in frames]),
        np.stack([frame.translation for frame in frames]),
        np.stack([frame.camera for frame in frames]),
        points,
        np.load(folder / "mask_pixels.npy"),
        frames[0].model,
    )


def thinned(frames: list[Frame], limit: int) -> list[Frame]:
    """At most ``limit`` frames, evenly spaced; all if it is 0."""
    if not limit or limit >= len(frames):
        return frames
    return [frames[i] for i in np.linspace(0, len(frames) - 1, limit).round().astype(int)]


def cache_root(settings: DataSettings) -> Path:
    """Folder of all packed splits."""
    return Path(settings.cache) if settings.cache else cache() / "frames"


def _key(frames: Sequence[Frame], fill: str, positives: str) -> str:
    """Changes with anything that decides the packed pixels: files by path, size and time."""
    digest = hashlib.sha256(f"{LAYOUT} {fill} {positives}".encode())
    for frame in frames:
        files = [frame.image, frame.mask, frame.background if fill == "background" else None]
        stamps = []
        for path in files:
            if path is None:
                continue
            try:
                status = path.stat()
            except FileNotFoundError:
                raise ValueError(f"{path}: file is missing") from None
            stamps.append((str(path.resolve()), status.st_size, status.st_mtime_ns))
        labels = (frame.camera, frame.rotation, frame.translation)
        digest.update(repr((frame.name, frame.pad, frame.shrink, stamps)).encode())
        digest.update(b"".join(label.tobytes() for label in labels))
    return digest.hexdigest()[:32]


def _write(folder: Path, frames: Sequence[Frame], fill: str, positives: str, told: Told) -> None:
    folder.parent.mkdir(parents=True, exist_ok=True)
    work = Path(tempfile.mkdtemp(dir=folder.parent, prefix=".packing-"))
    try:
        height, width = frames[0].read_image().shape[:2]
        if height % 32 or width % 32:
            raise ValueError(
                f"{frames[0].image}: {width}x{height} pixels; both must be multiples of 32, try another shrink"
            )
        shape = (len(frames), height, width)
        pixels = np.lib.format.open_memmap(work / "pixels.npy", "w+", np.uint8, (*shape, 4))
        filled = None
        if fill:
            filled = np.lib.format.open_memmap(work / "filled.npy", "w+", np.uint8, (*shape, 3))
        points = np.zeros((len(frames), MASK_POINTS, 2))
        counts = np.zeros(len(frames), np.int64)

        def decode(index: int) -> None:
            frame = frames[index]
            image, mask = frame.read_image(), frame.read_mask()
            without = frame.read_background() if fill == "background" else None
            for path, picture in ((frame.image, image), (frame.mask, mask), (frame.background, without)):
                if picture is not None and picture.shape[:2] != (height, width):
                    raise ValueError(
                        f"{path}: {picture.shape[1]}x{picture.shape[0]} pixels, but others have {width}x{height}"
                    )
            body = mask & _hull(frame, mask.shape) if positives == "hull" else mask
            pixels[index, ..., :3] = image
            pixels[index, ..., 3] = np.where(body, BODY, np.where(mask, PART, 0))
            if filled is not None:
                filled[index] = _inpainted(image, mask) if without is None else without
            y, x = np.nonzero(mask)
            counts[index] = len(x)
            if len(x):
                chosen = np.linspace(0, len(x) - 1, MASK_POINTS).round().astype(int)
                points[index] = np.stack((x[chosen], y[chosen]), axis=1) + 0.5

        with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
            for done, _ in enumerate(pool.map(decode, range(len(frames))), 1):
                told(done, len(frames))
        if not counts.any():
            raise ValueError(f"{frames[0].image} and the others show no target; their masks are empty")
        np.save(work / "mask_points.npy", points)
        np.save(work / "mask_pixels.npy", counts)
        pixels.flush()
        if filled is not None:
            filled.flush()
        (work / "done.json").write_text(json.dumps({"frames": len(frames), "fill": fill}))
        try:
            work.replace(folder)
        except OSError:
            if not (folder / "done.json").is_file():  # else another process was faster
                raise
    finally:
        shutil.rmtree(work, ignore_errors=True)


def _hull(frame: Frame, shape: tuple[int, int]) -> NDArray[np.bool_]:
    keypoints = project(frame.camera, frame.rotation, frame.translation[:, None], frame.model.keypoints)
    return hull_mask(keypoints, shape)


def _inpainted(image: NDArray[np.uint8], mask: NDArray[np.bool_]) -> NDArray[np.uint8]:
    return np.asarray(
        cv2.inpaint(image, grow(mask).astype(np.uint8), INPAINT_RADIUS, cv2.INPAINT_TELEA), np.uint8
    )
