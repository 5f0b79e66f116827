"""Counts and histograms of a data set."""

from __future__ import annotations

from typing import Any

import numpy as np

from macram.data.frame import Frame
from macram.data.geometry import BUCKETS
from macram.data.open import Dataset

MASKS = 200
"""At most so many masks are decoded per split, evenly spaced."""


def summarise(dataset: Dataset) -> dict[str, Any]:
    """Per split: frames, sequences, depth in diameters, frames per bucket, mask pixels, depth histogram.

    Raises:
        ValueError: a file is missing or malformed; one line that names it.
    """
    model = dataset.model
    return {
        "root": str(dataset.root),
        "model": {
            "name": model.name,
            "diameter_mm": model.diameter,
            "keypoints": len(model.keypoints),
            "vertices": len(model.vertices),
        },
        "splits": {split: _split(dataset.frames(split)) for split in dataset.splits},
    }


def _split(frames: list[Frame]) -> dict[str, Any]:
    if not frames:
        return {"frames": 0, "sequences": 0}
    depth = np.array([frame.translation[2] / frame.model.diameter for frame in frames])
    counts, edges = np.histogram(depth, bins=np.arange(np.floor(depth.min()), np.floor(depth.max()) + 1.5))
    chosen = np.unique(np.linspace(0, len(frames) - 1, min(MASKS, len(frames))).round().astype(int))
    masks = [int(frames[index].read_mask().sum()) for index in chosen]
    names = [frame.bucket for frame in frames]
    return {
        "frames": len(frames),
        "sequences": len({frame.sequence for frame in frames}),
        "depth_diameters": [round(float(depth.min()), 3), round(float(depth.max()), 3)],
        "buckets": {name: names.count(name) for name in BUCKETS},
        "mask_pixels": {
            "pictures": len(masks),
            **{f"p{p}": int(np.percentile(masks, p)) for p in (5, 50, 95)},
        },
        "depth_histogram": [
            {"from": float(low), "frames": int(count)} for low, count in zip(edges[:-1], counts, strict=True)
        ],
    }
