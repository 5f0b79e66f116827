"""SPEED as released: grey 1920x1200 pictures, ``train.json``, quaternions with the scalar first, metres.

The release has no masks, no model and no split of its own: masks are convex hulls of projected keypoints, the
points of the Tango satellite are below, and the split is drawn from a seed. Poses of its test part were never
published. Pictures are padded to a square as the paper does.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from macram.data.files import read_json, read_object
from macram.data.frame import Frame, Model
from macram.data.geometry import Floats, box_corners, matrix_of_quaternion

SIZE = (1920, 1200)
FOCAL = 17.6e-3 / 5.86e-6
"""Pixels: 17.6 mm over a pitch of 5.86 micrometres."""
PAD = (SIZE[0] - SIZE[1]) // 2
VALIDATION = 1 / 6
"""Share held back for validation: 2,000 of 12,000."""

# The four corners of the top deck, of the bottom deck, and the tips of three antennas; metres.
TANGO_M = (
    (-0.37, -0.385, 0.3215), (-0.37, 0.385, 0.3215), (0.37, 0.385, 0.3215), (0.37, -0.385, 0.3215),
    (-0.37, -0.264, 0.0), (-0.37, 0.304, 0.0), (0.37, 0.304, 0.0), (0.37, -0.264, 0.0),
    (-0.5427, 0.4877, 0.2535), (0.5427, 0.4877, 0.2591), (0.305, -0.579, 0.2515),
)  # fmt: skip


class Speed:
    """A data set in SPEED's layout.

    Args:
        root: folder with ``train.json`` and ``images/train``.
        pad: add 360 black rows above and below.
        shrink: whole factor by which the padded picture is reduced; the paper halves it.
        seed: of the split.

    Raises:
        ValueError: not such a folder, or a bad file; one line that names it.
    """

    splits = ("training", "validation")

    def __init__(self, root: Path, pad: bool = True, shrink: int = 1, seed: int = 2022) -> None:
        self.root, self.pad, self.shrink, self.seed = root, PAD if pad else 0, shrink, seed
        if not root.is_dir():
            raise ValueError(f"{root}: no such folder")
        if shrink < 1:
            raise ValueError(f"shrink must be 1 or more, not {shrink}")
        self.model = _model(root)
        self._entries: list[Frame] | None = None

    def frames(self, split: str) -> list[Frame]:
        """Frames of ``training`` or ``validation``, in the order of ``train.json``.

        Raises:
            ValueError: unknown split, a file that is missing or malformed, a quaternion not of length 1.
        """
        if split not in self.splits:
            raise ValueError(f"{self.root}: no split {split!r}; it has {', '.join(self.splits)}")
        if self._entries is None:
            self._entries = self._read()
        order = np.random.default_rng(self.seed).permutation(len(self._entries))
        held = max(round(len(order) * VALIDATION), 1)
        chosen = order[:held] if split == "validation" else order[held:]
        return [self._entries[index] for index in sorted(chosen.tolist())]

    def _read(self) -> list[Frame]:
        path = self.root / "train.json"
        table = read_json(path)
        if not isinstance(table, list) or not table:
            raise ValueError(f"{path}: expected a list of pictures")
        folder = self.root / "images/train"
        there = {file.name for file in folder.iterdir()} if folder.is_dir() else set()
        frames = [self._frame(path, number, entry) for number, entry in enumerate(table)]
        for frame in frames:
            if frame.image.name not in there:
                raise ValueError(f"{frame.image}: file is missing")
        return frames

    def _frame(self, path: Path, number: int, entry: Any) -> Frame:
        if not isinstance(entry, dict) or not isinstance(entry.get("filename"), str):
            raise ValueError(f"{path}: entry {number} has no filename")
        name = entry["filename"]
        # SPEED+ calls the same quaternion q_vbs2tango_true.
        quaternion = _vector(
            entry.get("q_vbs2tango", entry.get("q_vbs2tango_true")), 4, path, name, "q_vbs2tango"
        )
        place = _vector(entry.get("r_Vo2To_vbs_true"), 3, path, name, "r_Vo2To_vbs_true")
        length = float(np.linalg.norm(quaternion))
        if abs(length - 1) > 1e-3:
            raise ValueError(f"{path}: {name}: q_vbs2tango has length {length:.6g}, not 1")
        if place[2] <= 0:
            raise ValueError(f"{path}: {name}: r_Vo2To_vbs_true puts the object behind the camera")
        centre = (SIZE[0] / 2, SIZE[1] / 2 + self.pad)
        camera = np.array([[FOCAL, 0, centre[0]], [0, FOCAL, centre[1]], [0, 0, 1.0]])
        camera[:2] /= self.shrink
        return Frame(
            name=Path(name).stem,
            sequence="train",
            image=self.root / "images/train" / name,
            mask=None,
            background=None,
            stored=SIZE,
            camera=camera,
            rotation=matrix_of_quaternion(quaternion / length),
            translation=place * 1000,
            model=self.model,
            pad=self.pad,
            shrink=self.shrink,
        )


def _model(root: Path) -> Model:
    """Tango, or the box that a rendered data set names in ``dataset.json``."""
    own = root / "dataset.json"
    if own.is_file():
        about: Any = read_object(own).get("model")
        try:
            size, diameter = np.array(about["size_mm"], np.float64), float(about["diameter_mm"])
            if size.shape != (3,) or not (size > 0).all() or not np.isfinite([*size, diameter]).all():
                raise ValueError("numbers that are no sizes")
            if not diameter > 0:
                raise ValueError("no diameter")
            corners = box_corners(-size / 2, size / 2)
            return Model(str(about["name"]), corners, diameter, corners, is_box=True)
        except (TypeError, KeyError, ValueError):
            raise ValueError(f"{own}: model needs name, size_mm and diameter_mm, sizes above 0") from None
    points = 1000 * np.array(TANGO_M)
    span = float(np.linalg.norm(points[:, None] - points[None], axis=2).max())
    return Model("tango", points, span, points, is_box=False)


def _vector(value: Any, length: int, path: Path, name: str, field: str) -> Floats:
    try:
        vector = np.array(value, np.float64)
    except (ValueError, TypeError):
        vector = np.array(np.nan)
    if vector.shape != (length,) or not np.isfinite(vector).all():
        raise ValueError(f"{path}: {name}: {field} must be {length} numbers")
    return vector
