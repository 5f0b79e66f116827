"""`macram data`: whole data sets, resumed, in parallel, in both formats, looked at and checked."""

from __future__ import annotations

import argparse
import json
import shutil
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from macram.cli.data_grammar import add_data
from macram.cli.data_verb import data
from macram.data import produce as produce_module
from macram.data.geometry import BOX_EDGES
from macram.data.open import open_dataset
from macram.data.produce import produce
from macram.data.render.cubesat import corners
from macram.data.sheet import annotated
from macram.data.spec import TIERS, RenderSpec, as_speed
from macram.data.verify import check_all

SMALL = RenderSpec((64, 64), 76.0, (1.5, 8.0), (2, 1, 1), 2, seed=7, background=True)


def run(*words):
    top = argparse.ArgumentParser()
    verbs = top.add_subparsers(dest="verb")
    add_data(lambda name, module, summary, detail: verbs.add_parser(name, help=summary, description=detail))
    return data(top.parse_args(["data", *map(str, words)]))


def files(root):
    return {p.relative_to(root).as_posix(): p.read_bytes() for p in sorted(root.rglob("*")) if p.is_file()}


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    root = tmp_path_factory.mktemp("rendered") / "small"
    assert list(produce(root, SMALL))[-1] == 8
    return root


@pytest.fixture
def small(made, tmp_path):
    return shutil.copytree(made, tmp_path / "small")


def test_layout_is_swisscubes(made):
    names = set(files(made))
    assert {"training.txt", "validation.txt", "testing.txt", "dataset.json", "cubesat1u_bbox.json"} <= names
    assert (made / "training.txt").read_text().splitlines()[2] == "training/seq_000001/000000/rgb/000000.jpg"
    assert (made / "testing.txt").read_text().splitlines()[0] == "testing/seq_000003/000000/rgb/000000.jpg"
    for name in (
        "rgb/000001.jpg",
        "background/000001.jpg",
        "mask_visib/000001_000000.png",
        "scene_gt_info.json",
    ):
        assert f"validation/seq_000002/000000/{name}" in names
    assert not [name for name in names if ".part" in name]
    mask = cv2.imread(
        str(made / "training/seq_000000/000000/mask_visib/000000_000000.png"), cv2.IMREAD_UNCHANGED
    )
    assert mask.shape == (64, 64)
    assert set(np.unique(mask)) <= {0, 255}


def test_reader_gives_back_what_was_rendered(made):
    dataset = open_dataset(made)
    frames = dataset.frames("training")
    assert np.allclose(dataset.model.keypoints, corners())
    assert abs(dataset.model.diameter - 178.43) < 0.005
    assert [len(dataset.frames(split)) for split in dataset.splits] == [4, 2, 2]
    frame = frames[0]
    assert frame.camera.tolist() == [[76, 0, 32], [0, 76, 32], [0, 0, 1]]
    info = json.loads((frame.image.parents[1] / "scene_gt_info.json").read_text())["0"][0]
    assert info["depth_bucket"] == frame.bucket
    assert info["px_count_visib"] == frame.read_mask().sum()
    assert frame.read_background().shape == (64, 64, 3)


def test_two_processes_give_the_same_bytes_as_one(made, tmp_path):
    steps = list(produce(tmp_path / "two", SMALL, jobs=2))
    assert steps[-1] == 8
    assert steps == sorted(steps)
    assert files(tmp_path / "two") == files(made)


def test_a_sequence_does_not_depend_on_the_others(made, tmp_path):
    one = replace(SMALL, sequences=(1, 0, 0))
    list(produce(tmp_path, one))
    name = "training/seq_000000/000000/scene_gt.json"
    assert (tmp_path / name).read_bytes() == (made / name).read_bytes()


def test_interrupted_runs_go_on(made, tmp_path, monkeypatch):
    root, real, calls = tmp_path / "cut", produce_module.write_sequence, []

    def stops_in_the_second(root, spec, split, sequence, tick):
        def interrupt():
            tick()
            if len(calls) == 2:
                raise KeyboardInterrupt

        calls.append(sequence)
        real(root, spec, split, sequence, interrupt)

    monkeypatch.setattr(produce_module, "write_sequence", stops_in_the_second)
    with pytest.raises(KeyboardInterrupt):
        list(produce(root, SMALL))
    assert [p.name for p in (root / "training").iterdir()] == ["seq_000000"]
    assert not list(root.glob(".part*"))
    assert not json.loads((root / "dataset.json").read_text())["complete"]

    monkeypatch.setattr(produce_module, "write_sequence", real)
    assert next(iter(produce(root, SMALL))) == 2
    list(produce(root, SMALL))
    assert files(root) == files(made)


def test_a_finished_data_set_is_left_alone(small):
    before = {p: p.stat().st_mtime_ns for p in small.rglob("*")}
    assert list(produce(small, SMALL)) == [8]
    assert {p: p.stat().st_mtime_ns for p in small.rglob("*")} == before


def test_another_specification_is_refused(small, tmp_path):
    with pytest.raises(ValueError, match="another specification"):
        list(produce(small, replace(SMALL, seed=8)))
    (tmp_path / "full").mkdir()
    (tmp_path / "full/letter.txt").write_text("mine")
    with pytest.raises(ValueError, match="not empty"):
        list(produce(tmp_path / "full", SMALL))


@pytest.mark.parametrize(
    "change",
    [
        {"size": (0, 64)}, {"size": (60, 60)}, {"focal": 0.0}, {"focal": float("nan")}, {"focal": float("inf")},
        {"depth": (0.5, 4)}, {"depth": (5, 4)},
        {"sequences": (0, 0, 0)}, {"sequences": (-1, 2, 2)}, {"frames": 0}, {"seed": -1}, {"format": "coco"},
        {"format": "speed"},
    ],
)  # fmt: skip
def test_bad_specifications(change):
    with pytest.raises(ValueError, match=r"must|are") as error:
        replace(SMALL, **change)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("jobs", [0, 10**6])
def test_absurd_numbers_of_processes_are_refused_before_anything_starts(jobs, tmp_path):
    with pytest.raises(ValueError, match="jobs must be 1 to 256"):
        next(produce(tmp_path / "data", SMALL, jobs=jobs))
    assert not (tmp_path / "data").exists()


def test_tiers_are_those_that_were_promised():
    assert {name: spec.total for name, spec in TIERS.items()} == {
        "smoke": 30, "mini": 6500, "std": 10000, "full": 50000,
    }  # fmt: skip


# ---- checks --------------------------------------------------------------------------------------------


def problems(root):
    return [line for line in check_all(open_dataset(root)) if line]


def test_a_sound_data_set_has_no_problem(made):
    assert problems(made) == []
    assert run("verify", made) == 0


@pytest.mark.parametrize("shift", [-60, 2000])
def test_a_wrong_pose_is_found(small, shift):
    frame = max(open_dataset(small).frames("training"), key=lambda frame: frame.read_mask().sum())
    path, number = frame.image.parents[1] / "scene_gt.json", str(int(frame.image.stem))
    table = json.loads(path.read_text())
    table[number][0]["cam_t_m2c"][0] += shift
    path.write_text(json.dumps(table))
    found = problems(small)
    assert any(frame.name in line and "disagree" in line for line in found)
    assert any("poses_sha256" in line for line in found)
    assert run("verify", small) == 1


def test_a_swapped_mask_is_found(small):
    a, b = (small / f"training/seq_00000{n}/000000/mask_visib/000000_000000.png" for n in (0, 1))
    b.write_bytes(a.read_bytes())
    assert any("disagree" in line for line in problems(small))


def test_a_broken_picture_is_found(small):
    path = small / "testing/seq_000003/000000/background/000001.jpg"
    path.write_bytes(path.read_bytes()[:30])
    assert [str(path) in line for line in problems(small)] == [True]


def test_a_shortened_list_is_found(small):
    (small / "validation.txt").write_text((small / "validation.txt").read_text().splitlines()[0] + "\n")
    assert any("dataset.json says 2" in line for line in problems(small))


# ---- command line --------------------------------------------------------------------------------------


def test_render_info_show(tmp_path, capsys):
    words = ["--tier", "smoke", "--seqs", 1, 0, 1, "--frames", 1, "--size", 64, "--focal", 70, "--jobs", 1]
    assert run("render", "-o", tmp_path / "set", *words, "--dmin", 2, "--dmax", 3, "--seed", 5) == 0
    assert "2 pictures, 2 of them new" in capsys.readouterr().out
    assert run("info", tmp_path / "set", "--json") == 0
    report = json.loads(capsys.readouterr().out)
    assert report["splits"]["training"]["frames"] == 1
    assert report["splits"]["validation"]["frames"] == 0
    assert report["splits"]["testing"]["buckets"] == {"near": 1, "medium": 0, "far": 0}
    assert run("info", tmp_path / "set") == 0
    assert run("show", tmp_path / "set", "-o", tmp_path / "sheet.png", "-n", 4, "--columns", 2) == 0
    assert cv2.imread(str(tmp_path / "sheet.png")).shape == (256, 512, 3)


@pytest.mark.parametrize("words", [["-n", 0], ["--split", "trainig"], ["-o", "sheet.gif"]])
def test_show_refuses(made, words):
    with pytest.raises(ValueError, match=r"\w"):
        run("show", made, *words)


def test_the_sheet_draws_every_edge_of_the_box(made):
    frame = max(open_dataset(made).frames("training"), key=lambda frame: frame.read_mask().sum())
    picture = annotated(frame, 256).astype(int)
    green = (picture[..., 1] > 150) & (picture[..., 0] < 150) & (picture[..., 2] < 150)
    seen = 0
    for a, b in BOX_EDGES:
        x, y = np.rint((frame.points[a] + frame.points[b]) / 2 * 4 - 0.5).astype(int)
        if 2 <= x < 254 and 20 <= y < 254:
            assert green[y - 1 : y + 2, x - 1 : x + 2].any(), (a, b)
            seen += 1
    assert seen >= 4


def test_speed_format_end_to_end(tmp_path):
    spec = replace(as_speed(TIERS["smoke"]), sequences=(1, 0, 1), frames=1, depth=(12.0, 20.0))
    assert list(produce(tmp_path, spec))[-1] == 2
    assert sorted(Path(name).parts[0] for name in files(tmp_path)) == [
        "dataset.json", *["images"] * 2, "test.json", "train.json",
    ]  # fmt: skip
    assert "q_vbs2tango" not in (tmp_path / "test.json").read_text()
    stored = cv2.imread(str(next((tmp_path / "images/train").iterdir())), cv2.IMREAD_UNCHANGED)
    assert stored.shape == (1200, 1920)
    dataset = open_dataset(tmp_path)
    frames = dataset.frames("training") + dataset.frames("validation")
    assert len(frames) == 1
    for frame in frames:
        image, mask = frame.read_image(), frame.read_mask()
        assert image.shape == (1920, 1920, 3)
        # The hull covers the satellite: what it holds differs from the sky or ground around it.
        ring = cv2.dilate(mask.astype(np.uint8), np.ones((61, 61), np.uint8)).astype(bool) & ~mask
        assert mask.sum() > 2000
        assert abs(image[mask].astype(float).std() - image[ring].astype(float).std()) > 1
        assert 12 * 178.4 < frame.translation[2] < 20 * 178.5
    assert problems(tmp_path) == []
    assert list(produce(tmp_path, spec)) == [2]
