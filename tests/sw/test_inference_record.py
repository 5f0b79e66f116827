"""Records of settings tried at inference and of deployed integers, and what the page makes of them."""

from __future__ import annotations

import json
import shutil
from dataclasses import replace

import pytest
import torch
from train_scene import CORNERS, DIAMETER, write_scene

from macram.data.open import open_dataset
from macram.experiments import inference
from macram.experiments import tried as module_tried
from macram.experiments.finished import finished
from macram.experiments.inference import ALL, Try, edge_box, tries_file, try_all
from macram.experiments.integers import record_integers
from macram.experiments.plan import Job, Plan, Refined, Row, Source
from macram.experiments.tried import tried
from macram.model import SpaceNet, spacenet_config
from macram.pose import EdgeSettings, LookSettings, PoseSettings
from macram.train.checkpoint import Card, save_model

TRIES = (
    Try("single", PoseSettings(), "(default)", tested=True),
    Try("edges", PoseSettings(edges=EdgeSettings()), "--edges BOX"),
    Try("looks", PoseSettings(looks=LookSettings(turns=2, side=64, size=30))),
)


@pytest.fixture
def scene(tmp_path):
    root = write_scene(tmp_path / "scene")
    shutil.copytree(root / "validation", root / "testing")
    (root / "testing.txt").write_text(
        (root / "validation.txt").read_text().replace("validation/", "testing/")
    )
    return root


@pytest.fixture
def model(tmp_path):
    config = spacenet_config("tiny", "deployable", image_size=64, counterfactual=False)
    net = SpaceNet(config, torch.Generator().manual_seed(1)).eval()
    card = Card(config, tuple(tuple(map(float, c)) for c in CORNERS), DIAMETER, "box", True, 76.0)
    (tmp_path / "net").mkdir()
    save_model(tmp_path / "net/model.safetensors", net, card)
    return tmp_path / "net/model.safetensors"


def test_every_setting_is_scored_once(scene, model, tmp_path, monkeypatch):
    out, told = tmp_path / "results" / tries_file(model, integer=False), []
    try_all(model, scene, out, tries=TRIES, told=lambda name, done, total: told.append((name, done, total)))
    record = json.loads(out.read_text())
    assert [(row["name"], row["split"], row["frames"]) for row in record["rows"]] == [
        ("single", "validation", 4), ("edges", "validation", 4), ("looks", "validation", 4), ("single", "testing", 4),
    ]  # fmt: skip
    assert ("edges, validation", 4, 4) in told
    assert record["network"] == "net"
    # The remembered network's time counts again.
    assert all(row["seconds"] > 0 for row in record["rows"])

    with pytest.raises(ValueError, match=r"inference-net\.json: 'single' meant other settings then"):
        tried(out.parent, ())
    monkeypatch.setattr(module_tried, "ALL", TRIES)
    text = "\n".join(tried(out.parent, {record["model_sha256"]}))
    assert "| edges | `--edges BOX` |" in text
    assert "on the test split, 4 frames, `net`, float32" in text
    earlier = "\n".join(tried(out.parent, {"another"}))
    assert f"`net` of an earlier training (SHA-256 {record['model_sha256'][:12]}, " in earlier

    scored = []
    real = inference.evaluate_frames
    monkeypatch.setattr(inference, "evaluate_frames", lambda *a: scored.append(1) or real(*a))
    try_all(model, scene, out, tries=TRIES)
    assert not scored
    assert json.loads(out.read_text()) == record
    other = replace(TRIES[1], settings=PoseSettings(edges=EdgeSettings(hold=0.2)))
    try_all(model, scene, out, tries=(TRIES[0], other))
    rows = json.loads(out.read_text())["rows"]
    assert len(scored) == 1
    assert [row["name"] for row in rows] == ["single", "edges", "single"]
    assert rows[1]["settings"]["edges"]["hold"] == 0.2
    assert rows[0] == record["rows"][0]
    assert rows[1]["options"] == "--edges BOX"
    with pytest.raises(ValueError, match="'edges' meant other settings then"):
        tried(out.parent, ())
    scored.clear()
    relabelled = (replace(TRIES[0], options="--new"), other)
    monkeypatch.setattr(inference, "MEASURING", EdgeSettings(nearer=0.99))
    boxes = iter([0.9])
    monkeypatch.setattr(inference, "edge_box", lambda frames: next(boxes))
    try_all(model, scene, out, tries=relabelled)
    again = json.loads(out.read_text())
    assert len(scored) == 1  # the edges alone, on the box that is measured otherwise
    assert [row["options"] for row in again["rows"]] == ["--new", "--edges BOX", "--new"]
    assert again["rows"][1]["settings"]["edges"]["box"] == again["edge_box"] == 0.9
    scored.clear()
    boxes = iter([1.0])
    try_all(model, scene, out, tries=TRIES[:1], limit=2)
    assert len(scored) == 2
    assert [row["frames"] for row in json.loads(out.read_text())["rows"]] == [2, 2]


def test_the_measured_box_is_used_unless_a_setting_has_its_own(scene, model, tmp_path, monkeypatch):
    boxes = []
    real = inference.evaluate_frames
    monkeypatch.setattr(inference, "edge_box", lambda frames: 0.9)
    monkeypatch.setattr(
        inference, "evaluate_frames", lambda p, *a: boxes.append(p.settings.edges.box) or real(p, *a)
    )
    own = replace(TRIES[1], name="own", own_box=True)
    try_all(model, scene, tmp_path / "record.json", tries=(TRIES[1], own))
    assert boxes == [0.9, 1.0]


@pytest.mark.parametrize("larger", [1.0, 1.04])
def test_the_box_of_edges_is_measured_by_true_poses(larger, scene):
    """Painted without recesses, its edges are the box's own, to what 64 pixels without smoothing tell."""
    frames = open_dataset(scene).frames("training")
    frames = [replace(f, model=replace(f.model, keypoints=larger * f.model.keypoints)) for f in frames]
    assert edge_box(frames) == pytest.approx(1 / larger, abs=0.015)


def test_no_record_no_section(tmp_path):
    assert tried(tmp_path, ()) == []


def test_names_of_settings_differ():
    assert len({entry.name for entry in ALL}) == len(ALL)


# ---- deployed integers --------------------------------------------------------------------------------


@pytest.fixture
def job(tmp_path):
    folder = tmp_path / "quantised.s1"
    folder.mkdir()
    (folder / "result.json").write_text(json.dumps({"model_sha256": "abc"}))
    lines = ["frame,range,z_d,add_d,re_deg,te_d", "a/0,near,2,0.05,1,0.05", "a/1,far,8,0.3,2,0.3"]
    (folder / "frames.csv").write_text("\n".join(lines) + "\n")
    row = Row("quantised", "Quantised", "quantised", tmp_path / "unused.toml", seeds=(1,))
    return Job(Plan(Source(tmp_path, tmp_path), Source(tmp_path, tmp_path), Refined(4, 0.99), (row,)), row, 1)


def evaluation(path, **details):
    details = {
        "form": "3 bit, mode III, deployed integers",
        "sha256": "abc",
        "solver": PoseSettings().words,
        "command": "x",
        "dataset": "y",
        **details,
    }
    rows = [{"frame": "a/1", "add_d": 0.15}]
    summary = {"misses": 0, "fixed": {"all": {"add": {"0.1": 0.0, "0.2": 100.0}}}}
    path.write_text(json.dumps({"details": details, "rows": rows, "summary": summary}))
    return path


def test_integers_stand_beside_the_training_graph_on_the_same_frames(job, tmp_path):
    table = json.loads(record_integers(job, evaluation(tmp_path / "e.json"), tmp_path).read_text())
    assert table["frames"] == 1
    assert not table["all_frames"]
    assert table["training_graph_add"] == {"0.05": 0, "0.1": 0, "0.2": 0, "0.5": 100}
    assert table["frames_apart"] == 1


@pytest.mark.parametrize(
    ("details", "words"),
    [
        ({"form": "3 bit, mode III, training graph"}, "--integer"),
        ({"sha256": "def"}, "another network"),
        ({"solver": "x"}, "poses by x"),
    ],
)
def test_other_evaluations_are_refused(details, words, job, tmp_path):
    with pytest.raises(ValueError, match=words):
        record_integers(job, evaluation(tmp_path / "e.json", **details), tmp_path)
    assert not (tmp_path / "quantised.s1/integers.json").exists()


def test_integers_of_another_network_are_no_part_of_a_record(job, tmp_path):
    record_integers(job, evaluation(tmp_path / "e.json"), tmp_path)
    (whole,) = finished(job.plan, tmp_path)
    assert whole.integers["frames"] == 1
    (tmp_path / "quantised.s1/result.json").write_text(json.dumps({"model_sha256": "trained again"}))
    with pytest.raises(ValueError, match=r"another network.*macram experiments integers quantised"):
        finished(job.plan, tmp_path)
