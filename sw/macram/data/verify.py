"""Whether a data set agrees with itself: every file decoded, every pose held against its mask."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from macram.data.files import read_object
from macram.data.frame import Frame, hull_mask
from macram.data.geometry import is_rotation
from macram.data.open import Dataset
from macram.data.speed import Speed

HULL_COVERED = 0.8
"""At least so much of the projected body must be mask; rails and relief leave little of the box empty."""
HULL_PIXELS = 60
"""Fewer visible pixels than these say nothing about a pose."""
BESIDE = 0.35
"""At most so much mask lies outside the box, in squares of the diameter; a body covers 0.3 or more."""
EXACT = 1e-6
"""Tolerance of rotations in a rendered data set; SwissCube's are rounded more coarsely."""


def check_frame(frame: Frame) -> str | None:
    """What is wrong with a frame, in one line, or None."""
    try:
        image, mask = frame.read_image(), frame.read_mask()
        if frame.background is not None:
            frame.read_background()
    except ValueError as error:
        return str(error)
    if image.shape[:2] != mask.shape:
        return f"{frame.mask}: mask of {mask.shape[::-1]}, picture of {image.shape[1::-1]} pixels"
    if frame.mask is None or not frame.model.is_box:
        return None
    if (frame.model.keypoints @ frame.rotation[2] + frame.translation[2]).min() <= 0:
        return f"{frame.name}: part of the body is behind the camera"
    hull = hull_mask(frame.points, mask.shape)
    visible = int(hull.sum())
    if visible >= HULL_PIXELS and (mask & hull).sum() < HULL_COVERED * visible:
        share = (mask & hull).sum() / visible
        return f"{frame.name}: only {share:.0%} of the projected box is mask; pose and mask disagree"
    # Antennas lie outside the box, but they are never as large as the body.
    beside = int((mask & ~hull).sum())
    side = frame.camera[0, 0] * frame.model.diameter / frame.translation[2]
    if beside >= HULL_PIXELS and beside > BESIDE * side**2:
        return f"{frame.name}: {beside} mask pixels lie beside the projected box; pose and mask disagree"
    return None


def check_all(dataset: Dataset) -> Iterator[str | None]:
    """One value per frame: a problem or None; then problems of the data set as a whole.

    Raises:
        ValueError: the data set cannot be read at all.
    """
    own = read_object(dataset.root / "dataset.json") if (dataset.root / "dataset.json").is_file() else None
    due = {} if own is None else own.get("frames")
    if not isinstance(due, dict):
        raise ValueError(f"{dataset.root / 'dataset.json'}: frames must be counts by split")
    names: dict[str, str] = {}
    for split in dataset.splits:
        frames = dataset.frames(split)
        for frame in frames:
            problem = check_frame(frame)
            if problem is None and frame.name in names:
                problem = f"{frame.name}: in {names[frame.name]} and again in {split}"
            if problem is None and own is not None and not is_rotation(frame.rotation, EXACT):
                problem = f"{frame.name}: rotation is not orthonormal to {EXACT}"
            names[frame.name] = split
            yield problem
        if own is not None and not isinstance(dataset, Speed) and due.get(split) != len(frames):
            yield f"{dataset.root / f'{split}.txt'}: {len(frames)} frames, dataset.json says {due.get(split)}"
    if not names:
        yield f"{dataset.root}: no frames"
    if own is not None:
        yield from _check_whole(dataset, own)


def _check_whole(dataset: Dataset, own: dict[str, object]) -> Iterator[str]:
    about = dataset.root / "dataset.json"
    if not own.get("complete"):
        yield f"{about}: the data set is not complete; render again to go on"
    elif not isinstance(dataset, Speed) and own.get("poses_sha256") != _poses(dataset.root, dataset.splits):
        yield f"{about}: poses have changed since the data set was made (poses_sha256)"
    if not isinstance(dataset, Speed):
        box = dataset.model.keypoints
        mesh = dataset.model.vertices
        if (
            np.abs(box.min(axis=0) - mesh.min(axis=0)).max() > 0.01
            or np.abs(box.max(axis=0) - mesh.max(axis=0)).max() > 0.01
        ):
            yield f"{dataset.root}: box and mesh have different sizes"


def _poses(root: Path, splits: tuple[str, ...]) -> str:
    poses = hashlib.sha256()
    for split in splits:
        for path in sorted((root / split).glob("seq_*/000000/scene_gt.json")):
            poses.update(path.read_bytes())
    return poses.hexdigest()
