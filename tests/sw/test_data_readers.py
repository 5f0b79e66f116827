"""Readers on small folders in exactly the released formats, and one clear line for every kind of damage."""

from __future__ import annotations

import json
import shutil

import cv2
import numpy as np
import pytest

from macram.data.geometry import box_corners, matrix_of_quaternion, turn
from macram.data.open import open_dataset
from macram.data.ply import ply_text
from macram.data.speed import FOCAL, TANGO_M, Speed
from macram.data.swisscube import SwissCube

K = [607.5730322397038, 0, 512, 0, 607.5730322397038, 512, 0, 0, 1]
BOX = box_corners([-52.1, -55.4, -56.75], [52.1, 53.9, 58.0])
MESH = ply_text(BOX, np.array([[0, 1, 2]]))
POSE = {
    "cam_R_m2c": turn(np.array([0, 0, 1.0]), 0.5).ravel().tolist(),
    "cam_t_m2c": [10.0, -20, 900],
    "obj_id": 1,
}


def picture(path, shape, value=90):
    path.parent.mkdir(parents=True, exist_ok=True)
    assert cv2.imwrite(str(path), np.full(shape, value, np.uint8))


def write(path, table):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(table if isinstance(table, str) else json.dumps(table))


@pytest.fixture(scope="module")
def released(tmp_path_factory):
    """SwissCube's quirks: one level more, gaps, both kinds of keys, sequences numbered through."""
    root = tmp_path_factory.mktemp("data") / "SwissCube_1.0"
    write(root / "swisscube_bbox.json", [BOX.tolist()])
    write(root / "models/obj_000001.ply", MESH)
    for split, sequence, frames, key in (
        ("training", 0, (0, 12, 57), "{}"),
        ("training", 3, (4,), "{:06d}"),
        ("validation", 350, (9,), "{}"),
        ("testing", 400, (35,), "{:06d}"),
    ):
        folder = root / f"{split}/seq_{sequence:06d}/000000"
        for number in frames:
            picture(folder / f"rgb/{number:06d}.jpg", (1024, 1024, 3))
            mask = np.zeros((1024, 1024), np.uint8)
            mask[480:520, 500:540] = 255
            (folder / "mask_visib").mkdir(exist_ok=True)
            cv2.imwrite(str(folder / f"mask_visib/{number:06d}_000000.png"), mask)
        write(folder / "scene_gt.json", {key.format(n): [POSE] for n in frames})
        write(folder / "scene_camera.json", {key.format(n): {"cam_K": K, "depth_scale": 1.0} for n in frames})
        write(folder / "scene_gt_info.json", {key.format(n): [{"bbox_visib": [-1] * 4}] for n in frames})
        lines = [f"{split}/seq_{sequence:06d}/000000/rgb/{n:06d}.jpg\n" for n in frames]
        with (root / f"{split}.txt").open("a") as file:
            file.writelines(lines)
    return root


@pytest.fixture
def swisscube(released, tmp_path):
    return shutil.copytree(released, tmp_path / "SwissCube_1.0")


def test_swisscube_as_released(released):
    data = open_dataset(released)
    assert isinstance(data, SwissCube)
    frames = data.frames("training")
    assert [frame.name for frame in frames] == [
        "training/seq_000000/000000/000000",
        "training/seq_000000/000000/000012",
        "training/seq_000000/000000/000057",
        "training/seq_000003/000000/000004",
    ]
    assert [len(data.frames(split)) for split in data.splits] == [4, 1, 1]
    frame = frames[1]
    assert frame.camera.ravel().tolist() == K
    assert frame.rotation.ravel().tolist() == POSE["cam_R_m2c"]
    assert frame.translation.tolist() == [10, -20, 900]
    assert frame.bucket == "medium"
    assert frame.model.diameter == 178.46
    assert np.array_equal(frame.model.keypoints, BOX)
    assert len(frame.model.vertices) == 8
    assert frame.read_image().shape == (1024, 1024, 3)
    assert frame.read_mask().sum() == 1600


def test_halving_moves_intrinsics_along(released):
    frame = open_dataset(released, shrink=2).frames("testing")[0]
    assert frame.camera.tolist() == [[303.7865161198519, 0, 256], [0, 303.7865161198519, 256], [0, 0, 1]]
    assert frame.read_image().shape == (512, 512, 3)
    assert frame.read_mask().sum() == 400


def test_plain_bop(tmp_path):
    """No lists, no extra level, PNG, two objects in a frame, diameter and box from models_info.json."""
    info = {"diameter": 12.0, "min_x": -1, "min_y": -2, "min_z": -3, "size_x": 2, "size_y": 4, "size_z": 6}
    write(tmp_path / "models/models_info.json", {"1": info, "2": info})
    folder = tmp_path / "train_pbr/000000"
    other = {**POSE, "obj_id": 2}
    write(folder / "scene_gt.json", {"3": [other, POSE], "7": [other]})
    write(folder / "scene_camera.json", {"3": {"cam_K": K}, "7": {"cam_K": K}})
    picture(folder / "rgb/000003.png", (48, 64, 3))
    picture(folder / "mask_visib/000003_000001.png", (48, 64), 255)
    data = open_dataset(tmp_path)
    assert data.splits == ("train_pbr",)
    (frame,) = data.frames("train_pbr")
    assert frame.name == "train_pbr/000000/000003"
    assert frame.mask.name == "000003_000001.png"
    assert frame.model.diameter == 12
    assert frame.model.keypoints[-1].tolist() == [1, 2, 3]
    assert frame.read_image().shape == (48, 64, 3)
    assert frame.read_mask().all()


SEQ = "training/seq_000000/000000"


def poses(change):
    return {**{n: [POSE] for n in ("0", "57")}, "12": [{**POSE, **change}]}


@pytest.mark.parametrize(
    ("path", "content", "names", "reason"),
    [
        (f"{SEQ}/rgb/000012.jpg", None, "000012.jpg", "missing"),
        (f"{SEQ}/mask_visib/000057_000000.png", None, "000057_000000.png", "missing"),
        (f"{SEQ}/scene_gt.json", None, "scene_gt.json", "missing"),
        (f"{SEQ}/scene_camera.json", '{"0": ', "scene_camera.json", "JSON"),
        (f"{SEQ}/scene_gt.json", [1, 2], "scene_gt.json", "keys"),
        (f"{SEQ}/scene_gt.json", {"0": [POSE]}, "scene_gt.json", "frame 12"),
        (
            f"{SEQ}/scene_camera.json",
            {"0": {"cam_K": K}, "57": {"cam_K": K}},
            "scene_camera.json",
            "frame 12",
        ),
        (
            f"{SEQ}/scene_gt.json",
            poses({"cam_R_m2c": [1, 0, 0, 0, 1, 0, 0, 0, -1]}),
            "scene_gt.json",
            "not a rotation",
        ),
        (f"{SEQ}/scene_gt.json", poses({"cam_R_m2c": [1, 0, 0]}), "scene_gt.json", "9 numbers"),
        (f"{SEQ}/scene_gt.json", poses({"cam_t_m2c": [0, 0, -5]}), "scene_gt.json", "behind"),
        (f"{SEQ}/scene_gt.json", poses({"cam_t_m2c": ["a", 0, 5]}), "scene_gt.json", "3 numbers"),
        (f"{SEQ}/scene_gt.json", poses({"obj_id": 4}), "scene_gt.json", "no object 1"),
        ("swisscube_bbox.json", [[1, 2]], "swisscube_bbox.json", "8 corners"),
        ("models/obj_000001.ply", "nonsense", "obj_000001.ply", "PLY"),
        ("training.txt", "training/seq_000000/12.jpg\n", "training.txt", "line 1"),
    ],
)
def test_damage_is_named(swisscube, path, content, names, reason):
    if content is None:
        (swisscube / path).unlink()
    else:
        write(swisscube / path, content)
    with pytest.raises(ValueError, match=reason) as error:
        open_dataset(swisscube).frames("training")
    assert names in str(error.value)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("where", ["rgb/000012.jpg", "mask_visib/000012_000000.png"])
@pytest.mark.parametrize("damage", ["size", "cut", "empty"])
def test_bad_pictures_are_named(swisscube, where, damage):
    path = swisscube / SEQ / where
    if damage == "size":
        picture(path, (512, 512, 3))
    else:
        path.write_bytes(path.read_bytes()[:40] if damage == "cut" else b"")
    frame = open_dataset(swisscube).frames("training")[1]
    with pytest.raises(ValueError, match="1024x1024" if damage == "size" else "readable") as error:
        frame.read_image() if where.startswith("rgb") else frame.read_mask()
    assert str(path) in str(error.value)


def test_folders_that_are_none(tmp_path):
    with pytest.raises(ValueError, match="no such folder"):
        open_dataset(tmp_path / "absent")
    with pytest.raises(ValueError, match=r"neither training\.txt"):
        open_dataset(tmp_path)


def test_unknown_split(released):
    with pytest.raises(ValueError, match="it has training, validation, testing"):
        open_dataset(released).frames("test")


# ---- SPEED ---------------------------------------------------------------------------------------------


QUATERNION = [0.8, 0.0, 0.6, 0.0]


@pytest.fixture(scope="module")
def kelvins(tmp_path_factory):
    root = tmp_path_factory.mktemp("data") / "speed"
    entries = []
    for number in range(1, 13):
        name = f"img{number:06d}.jpg"
        picture(root / "images/train" / name, (1200, 1920), 10 * number)
        place = [0.1, -0.05 * number, 8.0 + number]
        entries.append({"filename": name, "q_vbs2tango": QUATERNION, "r_Vo2To_vbs_true": place})
    write(root / "train.json", entries)
    return root


@pytest.fixture
def speed(kelvins, tmp_path):
    return shutil.copytree(kelvins, tmp_path / "speed")


def test_speed_as_released(kelvins):
    data = open_dataset(kelvins)
    assert isinstance(data, Speed)
    training, validation = data.frames("training"), data.frames("validation")
    assert (len(training), len(validation)) == (10, 2)
    assert not {f.name for f in training} & {f.name for f in validation}
    frame = next(f for f in training + validation if f.name == "img000003")
    assert frame.camera.tolist() == [[FOCAL, 0, 960], [0, FOCAL, 960], [0, 0, 1]]
    assert abs(FOCAL - 3003.413) < 1e-3
    assert np.allclose(frame.translation, [100, -150, 11000])
    assert np.allclose(frame.rotation, matrix_of_quaternion(QUATERNION))
    image = frame.read_image()
    assert image.shape == (1920, 1920, 3)
    assert not image[:360].any()
    assert not image[1560:].any()
    assert (image[361:1559] == 30).all()
    assert frame.model.keypoints.shape == (11, 3)
    assert abs(frame.model.diameter - 1363) < 1


def test_speed_hull_mask_is_where_the_points_are(kelvins):
    for shrink in (1, 2):
        frame = open_dataset(kelvins, shrink=shrink).frames("validation")[0]
        mask = frame.read_mask()
        assert mask.shape == frame.read_image().shape[:2] == (1920 // shrink, 1920 // shrink)
        seen = (np.array(TANGO_M) * 1000) @ frame.rotation.T + frame.translation
        x = seen[:, 0] / seen[:, 2] * FOCAL + 960
        y = seen[:, 1] / seen[:, 2] * FOCAL + 960
        rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
        box = np.array([columns[0], columns[-1] + 1, rows[0], rows[-1] + 1]) * shrink
        assert np.abs(box - [x.min(), x.max(), y.min(), y.max()]).max() < 2 * shrink


def test_speed_without_padding(kelvins):
    frame = Speed(kelvins, pad=False).frames("training")[0]
    assert frame.camera[1, 2] == 600
    assert frame.read_image().shape == (*frame.read_mask().shape, 3) == (1200, 1920, 3)


def test_speed_split_depends_on_the_seed_alone(kelvins):
    def names(seed):
        return [frame.name for frame in Speed(kelvins, seed=seed).frames("validation")]

    assert names(1) == names(1)
    assert len({tuple(names(seed)) for seed in range(8)}) > 1


def test_speed_plus_field_name(speed):
    table = json.loads((speed / "train.json").read_text())
    for entry in table:
        entry["q_vbs2tango_true"] = entry.pop("q_vbs2tango")
    write(speed / "train.json", table)
    assert len(open_dataset(speed).frames("training")) == 10


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"q_vbs2tango": [0.8, 0, 0.6, 0.1]}, "length 1.00499, not 1"),
        ({"q_vbs2tango": [1, 0, 0]}, "q_vbs2tango must be 4 numbers"),
        ({"r_Vo2To_vbs_true": None}, "r_Vo2To_vbs_true must be 3 numbers"),
        ({"r_Vo2To_vbs_true": [0, 0, -3]}, "behind"),
        ({"filename": "img999999.jpg"}, r"img999999\.jpg: file is missing"),
        ({"filename": 3}, "entry 4 has no filename"),
    ],
)
def test_damaged_speed_entries_are_named(speed, change, reason):
    table = json.loads((speed / "train.json").read_text())
    table[4].update(change)
    write(speed / "train.json", table)
    with pytest.raises(ValueError, match=reason) as error:
        open_dataset(speed).frames("training")
    assert "\n" not in str(error.value)
    if "filename" not in change:
        assert "img000005.jpg" in str(error.value)


def test_speed_picture_of_wrong_size(speed):
    for path in (speed / "images/train").iterdir():
        picture(path, (600, 960))
    with pytest.raises(ValueError, match="960x600 pixels, but this data set has 1920x1200"):
        open_dataset(speed).frames("training")[0].read_image()
