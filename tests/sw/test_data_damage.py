"""Every value of every table of a data set, broken in every way: one line that names the file, or no harm."""

from __future__ import annotations

import copy
import json
import warnings

import cv2
import numpy as np
import pytest

from macram.data.files import read_json
from macram.data.geometry import box_corners
from macram.data.open import dataset_version, open_dataset
from macram.data.ply import ply_text
from macram.data.summary import summarise
from macram.data.verify import check_all

RUBBISH = (None, -1, 0, "x", [], {}, [[1]], [None], True, 1e400, float("nan"), {"a": 1})
BOX = box_corners([-50, -50, -50], [50, 50, 50])
POSE = {"cam_R_m2c": np.eye(3).ravel().tolist(), "cam_t_m2c": [0, 0, 900], "obj_id": 1}
CAMERA = {"cam_K": [60, 0, 32, 0, 60, 24, 0, 0, 1]}
INFO = {
    "diameter": 173.2,
    "min_x": -50,
    "min_y": -50,
    "min_z": -50,
    "size_x": 100,
    "size_y": 100,
    "size_z": 100,
}
ABOUT = {
    "version": "box-v1",
    "complete": True,
    "poses_sha256": "0",
    "spec": {"size": [64, 48]},
    "frames": {"training": 1},
    "model": {"name": "box", "size_mm": [100, 100, 100], "diameter_mm": 173.2},
}
ENTRY = {"filename": "img000001.jpg", "q_vbs2tango": [1, 0, 0, 0], "r_Vo2To_vbs_true": [0, 0, 9]}
SEQUENCE = "training/seq_000000/000000"


def write(path, table):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(table))


def picture(path, shape):
    path.parent.mkdir(parents=True, exist_ok=True)
    assert cv2.imwrite(str(path), np.zeros(shape, np.uint8))


@pytest.fixture
def swisscube(tmp_path):
    write(tmp_path / "dataset.json", ABOUT)
    write(tmp_path / "box_bbox.json", [BOX.tolist()])
    write(tmp_path / "models/models_info.json", {"1": INFO})
    (tmp_path / "models/obj_000001.ply").write_text(ply_text(BOX, np.array([[0, 1, 2]])))
    write(tmp_path / SEQUENCE / "scene_gt.json", {"3": [POSE]})
    write(tmp_path / SEQUENCE / "scene_camera.json", {"3": CAMERA})
    picture(tmp_path / SEQUENCE / "rgb/000003.jpg", (48, 64, 3))
    picture(tmp_path / SEQUENCE / "mask_visib/000003_000000.png", (48, 64))
    (tmp_path / "training.txt").write_text(f"{SEQUENCE}/rgb/000003.jpg\n")
    return tmp_path


@pytest.fixture
def bop(swisscube):
    """The same without lists, box file and dataset.json: box and diameter come from models_info.json."""
    for name in ("training.txt", "box_bbox.json", "dataset.json"):
        (swisscube / name).unlink()
    (swisscube / SEQUENCE).rename(swisscube / "training/000000")
    return swisscube


@pytest.fixture
def speed(tmp_path):
    write(tmp_path / "dataset.json", {key: value for key, value in ABOUT.items() if key != "spec"})
    write(tmp_path / "train.json", [ENTRY])
    picture(tmp_path / "images/train/img000001.jpg", (1200, 1920))
    return tmp_path


def places(node, so_far=()):
    yield so_far
    items = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
    for key, value in items:
        yield from places(value, (*so_far, key))


def replaced(node, place, value):
    if not place:
        return value
    node = copy.deepcopy(node)
    inner = node
    for key in place[:-1]:
        inner = inner[key]
    if value is places:  # stands for "remove it"
        del inner[place[-1]]
    else:
        inner[place[-1]] = value
    return node


def use(root):
    """Everything that reads a data set's tables; how many frames and problems there are."""
    dataset = open_dataset(root)
    dataset_version(root)
    for split in dataset.splits:
        dataset.frames(split)
    summarise(dataset)
    return sum(1 for _ in check_all(dataset))


def complaint(root):
    """What the reader refuses the data set for, or None; any other error is a failure."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")  # NumPy's, where a number is none
            use(root)
    except ValueError as error:
        return str(error)
    return None


@pytest.mark.parametrize(
    ("layout", "names"),
    [
        ("swisscube", ("dataset.json", "box_bbox.json", f"{SEQUENCE}/scene_gt.json", f"{SEQUENCE}/scene_camera.json")),
        ("bop", ("models/models_info.json", "training/000000/scene_gt.json")),
        ("speed", ("dataset.json", "train.json")),
    ],
)  # fmt: skip
def test_any_damage_is_one_line_that_names_the_file(request, layout, names):
    root = request.getfixturevalue(layout)
    assert use(root) >= 1
    refused = 0
    for name in names:
        path = root / name
        table = read_json(path)
        for place in places(table):
            for value in (*RUBBISH, *([places] if place else [])):
                write(path, replaced(table, place, value))
                message = complaint(root)
                assert message is None or (str(root) in message and "\n" not in message), (name, place, value)
                refused += message is not None
        write(path, table)
    assert refused > 50


@pytest.mark.parametrize("matrix", [[0, 0, 32, 0, 60, 24, 0, 0, 1], [60, 0, 32, 5, 60, 24, 0, 0, 1],
                                    [60, 0, 32, 0, -60, 24, 0, 0, 1], [60, 0, 32, 0, 60, 24, 0, 0, 2]])  # fmt: skip
def test_intrinsics_that_are_none(swisscube, matrix):
    write(swisscube / SEQUENCE / "scene_camera.json", {"3": {"cam_K": matrix}})
    with pytest.raises(ValueError, match=r"scene_camera\.json: frame 3: cam_K is not the matrix of a camera"):
        open_dataset(swisscube).frames("training")


def test_a_data_set_without_frames_has_a_problem(swisscube, speed):
    (swisscube / "train.json").unlink()  # both fixtures share a folder
    (swisscube / "training.txt").write_text("\n")
    assert any("no frames" in str(problem) for problem in check_all(open_dataset(swisscube)))
    write(speed / "train.json", [])
    with pytest.raises(ValueError, match=r"train\.json: expected a list of pictures"):
        open_dataset(speed).frames("training")


def test_an_unfinished_data_set_says_so(tmp_path):
    write(tmp_path / "dataset.json", {**ABOUT, "complete": False})
    with pytest.raises(ValueError, match=r"dataset\.json: the data set is not complete; render again"):
        open_dataset(tmp_path)


def test_a_list_that_is_no_text(swisscube):
    (swisscube / "training.txt").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(ValueError, match=r"training\.txt: not a text file"):
        open_dataset(swisscube).frames("training")


def test_a_digit_that_is_no_decimal_is_one_clear_line(swisscube):
    write(swisscube / SEQUENCE / "scene_gt.json", {"²": [POSE]})
    with pytest.raises(ValueError, match=r"scene_gt.json: expected an object whose keys are numbers"):
        list(open_dataset(swisscube).frames("training"))


def test_json_nested_too_deep_is_one_line(tmp_path):
    path = tmp_path / "deep.json"
    path.write_text(200_000 * "[")
    with pytest.raises(ValueError, match=r"deep\.json: .*nested too deep"):
        read_json(path)
