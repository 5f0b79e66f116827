"""SwissCube as released, plain BOP folders, and what `macram data render` writes: one reader.

SwissCube puts one level more than BOP between a sequence and its pictures (``seq_000400/000000``) and lists
its pictures in ``training.txt``, ``validation.txt`` and ``testing.txt``. Frame numbers have gaps, and the
keys of the JSON files are plain or padded with zeros. A frame that a list names must be there: nothing is
skipped or replaced.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import numpy as np

from macram.data.files import read_json, read_lines, read_object
from macram.data.frame import Frame, Model
from macram.data.geometry import Floats, box_corners, is_camera, is_rotation
from macram.data.ply import read_vertices

LISTS = ("training", "validation", "testing")
SWISSCUBE_DIAMETER_MM = 178.46
"""Diagonal of SwissCube's body without antennas; the release does not store it."""
SWISSCUBE_SIZE = (1024, 1024)
SUFFIXES = (".jpg", ".png", ".jpeg", ".tif")


class SwissCube:
    """A data set of one object in SwissCube or BOP layout.

    Args:
        root: its folder.
        shrink: whole factor by which pictures are reduced; intrinsics follow. The paper halves SwissCube.
        object_id: the object to read.

    Raises:
        ValueError: not such a folder, or a bad file; one line that names it.
    """

    def __init__(self, root: Path, shrink: int = 1, object_id: int = 1) -> None:
        self.root, self.shrink, self.object_id = root, shrink, object_id
        if not root.is_dir():
            raise ValueError(f"{root}: no such folder")
        if shrink < 1:
            raise ValueError(f"shrink must be 1 or more, not {shrink}")
        self.listed = tuple(name for name in LISTS if (root / f"{name}.txt").is_file())
        self.splits = self.listed or tuple(
            sorted({path.parents[1].name for path in root.glob("*/*/scene_gt.json")})
        )
        """Names of the splits that are there."""
        if not self.splits:
            own = root / "dataset.json"
            if own.is_file() and not read_object(own).get("complete"):
                raise ValueError(f"{own}: the data set is not complete; render again to go on")
            raise ValueError(
                f"{root}: neither training.txt nor */*/scene_gt.json; not a SwissCube or BOP folder"
            )

    @cached_property
    def stored(self) -> tuple[int, int] | None:
        """Width and height of the files where the data set fixes them."""
        own = self.root / "dataset.json"
        if own.is_file():
            size = _field(_field(read_json(own), own, "spec"), own, "size")
            width, height = _numbers(size, own, "spec.size of 2 numbers", (2,)).astype(int).tolist()
            return width, height
        return SWISSCUBE_SIZE if (self.root / "swisscube_bbox.json").is_file() else None

    @cached_property
    def model(self) -> Model:
        """The object: box corners, diameter, mesh."""
        mesh = self.root / f"models/obj_{self.object_id:06d}.ply"
        vertices = read_vertices(mesh) if mesh.is_file() else None
        boxes = sorted(self.root.glob("*_bbox.json"))
        about_path = self.root / "models/models_info.json"
        about = None
        if about_path.is_file():
            about = _by_number(read_json(about_path), about_path).get(self.object_id)
            if about is None:
                raise ValueError(f"{about_path}: no object {self.object_id}")
        if boxes:
            corners = _numbers(read_json(boxes[0]), boxes[0], "8 corners of 3 numbers", (1, 8, 3), (8, 3))
            corners = corners.reshape(8, 3)
        elif about is not None:
            low, size = (
                _numbers(
                    [_field(about, about_path, f"{what}_{axis}") for axis in "xyz"],
                    about_path,
                    f"{what}_x, {what}_y, {what}_z to be numbers",
                    (3,),
                )
                for what in ("min", "size")
            )
            corners = box_corners(low, low + size)
        elif vertices is not None:
            corners = box_corners(vertices.min(axis=0), vertices.max(axis=0))
        else:
            raise ValueError(
                f"{self.root}: no *_bbox.json, models/models_info.json or {mesh.name}; the object is unknown"
            )
        name = boxes[0].name.removesuffix("_bbox.json") if boxes else self.root.name
        if about is not None:
            diameter = float(
                _numbers(_field(about, about_path, "diameter"), about_path, "a number as diameter", ())
            )
            if diameter <= 0:
                raise ValueError(f"{about_path}: diameter must be above 0, not {diameter:g}")
        else:
            diameter = (
                SWISSCUBE_DIAMETER_MM
                if name == "swisscube"
                else float(np.linalg.norm(corners[0] - corners[7]))
            )
        return Model(name, corners, diameter, corners if vertices is None else vertices, is_box=True)

    def frames(self, split: str) -> list[Frame]:
        """All frames of a split that show the object, in the order of its list, or by sequence and number.

        Raises:
            ValueError: unknown split, a file that is missing or malformed, a pose that is none.
        """
        if split not in self.splits:
            raise ValueError(f"{self.root}: no split {split!r}; it has {', '.join(self.splits)}")
        return list(self._listed(split) if self.listed else self._found(split))

    def _listed(self, split: str) -> Iterable[Frame]:
        path = self.root / f"{split}.txt"
        scene: _Scene | None = None
        for number, line in enumerate(read_lines(path), 1):
            if not line.strip():
                continue
            image = self.root / line.strip()
            if image.parent.name != "rgb" or not image.stem.isdecimal():
                raise ValueError(f"{path}: line {number} is {line.strip()!r}, not SEQUENCE/rgb/NUMBER.jpg")
            folder = image.parents[1]
            if scene is None or scene.folder != folder:
                scene = _Scene(folder)
            frame = self._frame(scene, int(image.stem), image)
            if frame is None:
                raise ValueError(
                    f"{folder / 'scene_gt.json'}: no object {self.object_id} in frame {int(image.stem)}"
                )
            yield frame

    def _found(self, split: str) -> Iterable[Frame]:
        for path in sorted((self.root / split).glob("*/scene_gt.json")):
            scene = _Scene(path.parent)
            for number in sorted(scene.poses):
                frame = self._frame(scene, number, None)
                if frame is not None:
                    yield frame

    def _frame(self, scene: _Scene, number: int, image: Path | None) -> Frame | None:
        """The frame, or None if the object is not in it."""
        gt, cameras = scene.folder / "scene_gt.json", scene.folder / "scene_camera.json"
        if number not in scene.poses:
            raise ValueError(f"{gt}: no entry for frame {number}")
        if number not in scene.cameras:
            raise ValueError(f"{cameras}: no entry for frame {number}")
        if not isinstance(scene.poses[number], list):
            raise ValueError(f"{gt}: frame {number}: expected a list of objects")
        found = [
            (index, pose)
            for index, pose in enumerate(scene.poses[number])
            if _field(pose, gt, "obj_id") == self.object_id
        ]
        if not found:
            return None
        index, pose = found[0]
        where = f"frame {number}: "
        rotation = _numbers(
            _field(pose, gt, "cam_R_m2c"), gt, where + "cam_R_m2c of 9 numbers", (9,)
        ).reshape(3, 3)
        translation = _numbers(_field(pose, gt, "cam_t_m2c"), gt, where + "cam_t_m2c of 3 numbers", (3,))
        if not is_rotation(rotation):
            raise ValueError(f"{gt}: {where}cam_R_m2c is not a rotation")
        if translation[2] <= 0:
            raise ValueError(f"{gt}: {where}cam_t_m2c puts the object behind the camera")
        camera = _camera(scene.cameras[number], cameras, number)
        camera[:2] /= self.shrink
        if image is None:
            image = next(
                (p for p in (scene.folder / f"rgb/{number:06d}{s}" for s in SUFFIXES) if scene.has(p)), None
            )
            if image is None:
                raise ValueError(f"{scene.folder / f'rgb/{number:06d}.*'}: file is missing")
        mask = scene.folder / f"mask_visib/{number:06d}_{index:06d}.png"
        for path in (image, mask):
            if not scene.has(path):
                raise ValueError(f"{path}: file is missing")
        background = scene.folder / f"background/{number:06d}.jpg"
        sequence = scene.folder.relative_to(self.root).as_posix()
        return Frame(
            name=f"{sequence}/{number:06d}",
            sequence=sequence,
            image=image,
            mask=mask,
            background=background if scene.has(background) else None,
            stored=self.stored,
            camera=camera,
            rotation=rotation,
            translation=translation,
            model=self.model,
            shrink=self.shrink,
        )


def read_cameras(path: Path) -> dict[int, Floats]:
    """Intrinsics ``[3, 3]`` by frame number from a ``scene_camera.json``.

    Raises:
        ValueError: missing or malformed; one line that names it.
    """
    table = _by_number(read_json(path), path)
    return {number: _camera(entry, path, number) for number, entry in table.items()}


def _camera(entry: Any, path: Path, number: int) -> Floats:
    """A new ``[3, 3]`` array."""
    what = f"frame {number}: cam_K of 9 numbers"
    camera = _numbers(_field(entry, path, "cam_K"), path, what, (9,)).reshape(3, 3)
    if not is_camera(camera):
        raise ValueError(f"{path}: frame {number}: cam_K is not the matrix of a camera")
    return camera


class _Scene:
    """Tables of one folder of pictures; folders are listed once, not asked for every file."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.poses, self.cameras = (
            _by_number(read_json(folder / name), folder / name)
            for name in ("scene_gt.json", "scene_camera.json")
        )
        self._names = cache(_names)

    def has(self, path: Path) -> bool:
        return path.name in self._names(path.parent)


def _names(folder: Path) -> frozenset[str]:
    return frozenset(path.name for path in folder.iterdir()) if folder.is_dir() else frozenset()


def _by_number(table: Any, path: Path) -> dict[int, Any]:
    """Keys ``"12"`` and ``"000012"`` alike -> 12."""
    if not isinstance(table, dict) or not all(key.isdecimal() for key in table):
        raise ValueError(f"{path}: expected an object whose keys are numbers")
    return {int(key): value for key, value in table.items()}


def _field(table: Any, path: Path, name: str) -> Any:
    if not isinstance(table, dict) or name not in table:
        raise ValueError(f"{path}: {name} is missing")
    return table[name]


def _numbers(value: Any, path: Path, what: str, *shapes: tuple[int, ...]) -> Floats:
    """A new array of one of ``shapes``, finite."""
    try:
        array = np.array(value, np.float64)
    except (ValueError, TypeError):
        array = np.array(np.nan)
    if array.shape not in shapes or not np.isfinite(array).all():
        raise ValueError(f"{path}: expected {what}")
    return array
