from __future__ import annotations

import argparse
import json
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest
import torch
from train_scene import CORNERS, DIAMETER, write_scene

from macram.cli.evaluate_verb import add_evaluate, evaluate
from macram.cli.predict_verb import add_predict, predict
from macram.data.open import open_dataset
from macram.model import SpaceNet, spacenet_config
from macram.pose import Candidates, EdgeSettings, LevelCells, Pose, PoseSettings, project, refine_on_edges
from macram.quant import calibrate_batch_norm, calibrate_steps, quantise
from macram.train.checkpoint import Card, load_model, save_model
from macram.train.predict import Predictor, evaluate_frames

FOCAL = 76.0


def network(**fields):
    config = spacenet_config("tiny", "deployable", image_size=64, counterfactual=False, **fields)
    net = SpaceNet(config, torch.Generator().manual_seed(1)).eval()
    corners = tuple(tuple(map(float, corner)) for corner in CORNERS)
    return net, Card(config, corners, DIAMETER, "box", True, FOCAL)


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    return write_scene(tmp_path_factory.mktemp("scene") / "data")


@pytest.fixture(scope="module")
def frames(scene):
    return open_dataset(scene).frames("validation")


@pytest.fixture(scope="module")
def weights(tmp_path_factory):
    path = tmp_path_factory.mktemp("weights") / "model.safetensors"
    save_model(path, *network())
    return path


@pytest.fixture(scope="module")
def quantised(tmp_path_factory):
    """A calibrated 3-bit network, its training graph as close to the integers as 3 bits let it be."""
    net, card = network()
    images = torch.randn(8, 3, 64, 64, generator=torch.Generator().manual_seed(2))
    calibrate_batch_norm(net, images)
    card = replace(card, mode="III", bits=3)
    net = quantise(net, card.mode, card.precision)
    calibrate_steps(net, images)
    path = tmp_path_factory.mktemp("weights") / "model.safetensors"
    save_model(path, net, card)
    return path


def truthful(predictor, frames):
    """Makes a predictor see the truth: four cells that know the corners, whatever the picture is."""
    known = {}
    for frame in frames:
        image, camera = predictor.fit(frame.read_image(), frame.camera)
        known[image.tobytes()] = project(camera, frame.rotation, frame.translation[:, None], CORNERS)

    def levels(images):
        cells = []
        for image in images:
            points = np.repeat(known[image.tobytes()][None], 4, axis=0)
            nothing = LevelCells(np.zeros(1), np.zeros((1, 8, 2)))
            cells.append([LevelCells(np.full(4, 0.9), points), *[nothing] * 4])
        return cells

    predictor.levels = levels
    return predictor


def test_a_truthful_network_scores_full_marks(frames):
    predictor = truthful(Predictor(*network()), frames)
    evaluation, found = evaluate_frames(predictor, frames)
    table = evaluation.summary["fixed"]["all"]
    assert table["add"]["0.05"] == 100
    assert table["te_mm_median"] < 1e-3
    assert all(d is not None and d.score == pytest.approx(np.sqrt(0.9)) for d in found)


@pytest.mark.parametrize("focal", [38.0, 114.0, 152.0])
def test_another_focal_length_gives_the_same_pose(frames, focal):
    # Trained at half, 1.5 or twice the focal length of these pictures: they are scaled, the pose is not.
    net, card = network()
    predictor = truthful(Predictor(net, replace(card, focal=focal)), frames)
    found = predictor.detect(frames[0].read_image(), frames[0].camera)
    assert np.abs(found.pose.t[:, 0] - frames[0].translation).max() < 1e-2
    image, camera = predictor.fit(frames[0].read_image(), frames[0].camera)
    assert image.shape[0] % 32 == image.shape[1] % 32 == 0
    assert camera[0, 0] == pytest.approx(focal)
    assert camera[0, 2] == pytest.approx(32 * focal / FOCAL)


def test_pictures_of_any_size_are_padded_not_stretched():
    predictor = Predictor(*network())
    image, camera = predictor.fit(
        np.zeros((50, 70, 3), np.uint8), np.array([[FOCAL, 0, 35], [0, FOCAL, 25], [0, 0, 1]])
    )
    assert image.shape == (64, 96, 3)
    assert (image[50:] == 128).all()
    assert camera.tolist() == [[FOCAL, 0, 35], [0, FOCAL, 25], [0, 0, 1]]


def test_levels_are_the_networks_outputs(frames):
    net, card = network()
    predictor = Predictor(net, card)
    images = [frame.read_image() for frame in frames[:3]]
    together = predictor.levels(images)
    assert [len(cells.probability) for cells in together[0]] == [64, 16, 4, 1, 1]
    for n, image in enumerate(images):
        for one, other in zip(predictor.levels([image])[0], together[n], strict=True):
            assert np.abs(one.points - other.points).max() < 1e-2
            assert np.abs(one.probability - other.probability).max() < 1e-5


def test_checkpoints_come_back_as_they_were(weights, quantised):
    for path in (weights, quantised):
        net, card = load_model(path)
        save_model(path.with_name("again.safetensors"), net, card)
        assert path.with_name("again.safetensors").read_bytes() == path.read_bytes()


def test_integers_follow_the_training_graph(quantised, frames):
    graph, deployed = Predictor.load(quantised), Predictor.load(quantised, integer=True)
    image = frames[0].read_image()
    ours, theirs = graph.levels([image])[0], deployed.levels([image])[0]
    for one, other in zip(ours, theirs, strict=True):
        spread = np.abs(one.points - one.points.mean(axis=0)).max() + 1
        assert one.points.shape == other.points.shape
        assert np.median(np.abs(one.points - other.points)) < 0.05 * spread
        assert np.median(np.abs(one.probability - other.probability)) < 1e-2


def test_float_networks_have_no_integers(weights):
    with pytest.raises(ValueError, match="mode III"):
        Predictor.load(weights, integer=True)


def test_another_object_is_refused(frames):
    net, card = network(keypoints=11)
    with pytest.raises(ValueError, match="8"):
        evaluate_frames(Predictor(net, replace(card, keypoints=((0.0, 0.0, 0.0),) * 11)), frames)


# ---- command line -----------------------------------------------------------------------------------


def parse(add, *arguments):
    top = argparse.ArgumentParser()
    verbs = top.add_subparsers()
    add(lambda name, module, summary, detail: verbs.add_parser(name))
    return top.parse_args([str(argument) for argument in arguments])


@pytest.fixture
def told_the_truth(monkeypatch, frames):
    build = Predictor.__init__

    def init(self, *args, **kwargs):
        build(self, *args, **kwargs)
        truthful(self, frames)

    monkeypatch.setattr(Predictor, "__init__", init)


@pytest.mark.usefixtures("told_the_truth")
def test_predict_draws_and_writes_poses(scene, frames, weights, tmp_path, capsys):
    images = [frame.image for frame in frames[:2]]
    assert predict(parse(add_predict, "predict", *images, "-o", tmp_path / "out", "--weights", weights)) == 0
    table = json.loads((tmp_path / "out/poses.json").read_text())
    assert table["target"] == "box"
    for frame in frames[:2]:
        pose = table["poses"][frame.image.stem]["pose"]
        assert np.abs(np.array(pose["cam_t_m2c"]) - frame.translation).max() < 1e-2
        drawn = cv2.imread(str(tmp_path / "out" / f"{frame.image.stem}.png"))[..., ::-1]
        assert drawn.shape == (64, 64, 3)
        assert (drawn != frame.read_image()).any()
    assert "score 0.95" in capsys.readouterr().out


def test_predict_without_a_pose_says_so(frames, weights, tmp_path, capsys):
    assert predict(parse(add_predict, "predict", frames[0].image, "-o", tmp_path, "--weights", weights)) == 0
    assert json.loads((tmp_path / "poses.json").read_text())["poses"][frames[0].image.stem]["pose"] is None
    assert "no pose" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("table", "words"),
    [
        ([], r"scene_camera\.json: expected an object whose keys are numbers"),
        ({"3": {"cam_K": [1, 2]}}, r"scene_camera\.json: expected frame 3: cam_K of 9 numbers"),
        ({"3": {"cam_K": [0, 0, 1, 0, 0, 1, 0, 0, 1]}}, r"scene_camera\.json: frame 3: cam_K is not"),
        (
            {"3": {"cam_K": [0.01, 0, 1, 0, 0.01, 1, 0, 0, 1]}},
            r"000003\.png: a focal length of 0\.01 pixels is too far",
        ),
    ],
)
def test_predict_refuses_cameras_that_are_none(table, words, weights, tmp_path):
    picture = tmp_path / "scene/rgb/000003.png"
    picture.parent.mkdir(parents=True)
    cv2.imwrite(str(picture), np.zeros((64, 64, 3), np.uint8))
    (tmp_path / "scene/scene_camera.json").write_text(json.dumps(table))
    with pytest.raises(ValueError, match=words):
        predict(parse(add_predict, "predict", picture, "-o", tmp_path / "out", "--weights", weights))
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("focal", ["nan", "inf", "0", "1e-3", "1e9"])
def test_predict_refuses_focal_lengths_that_are_none(focal, frames, weights, tmp_path):
    words = ("--weights", weights, "--focal", focal)
    with pytest.raises(ValueError, match="--focal"):
        predict(parse(add_predict, "predict", frames[0].image, "-o", tmp_path / "out", *words))
    assert not (tmp_path / "out").exists()


def test_predict_needs_a_focal_length_it_cannot_know(weights, tmp_path):
    picture = tmp_path / "photo.png"
    cv2.imwrite(str(picture), np.zeros((40, 50, 3), np.uint8))
    out = tmp_path / "out"
    with pytest.raises(ValueError, match="give the focal length with --focal"):
        predict(parse(add_predict, "predict", picture, "-o", out, "--weights", weights))
    assert not out.exists()
    assert (
        predict(parse(add_predict, "predict", picture, "-o", out, "--weights", weights, "--focal", 60)) == 0
    )
    table = json.loads((out / "poses.json").read_text())
    assert table["poses"]["photo"]["cam_K"] == [60, 0, 25, 0, 60, 20, 0, 0, 1]


@pytest.mark.usefixtures("told_the_truth")
def test_evaluate_writes_its_report(scene, weights, tmp_path, capsys):
    out = tmp_path / "out"
    chosen = ["evaluate", weights, "--data", scene, "--split", "validation", "-o", out]
    assert evaluate(parse(add_evaluate, *chosen)) == 0
    names = {path.name for path in out.iterdir()}
    assert names == {"evaluation.json", "evaluation.md", "evaluation.png", "samples.jpg"}
    table = json.loads((out / "evaluation.json").read_text())
    assert table["summary"]["fixed"]["all"]["add"]["0.1"] == 100
    assert table["details"]["form"] == "float32"
    assert "4 frames, 0 without a pose: ADD-0.1d 100.00 %" in capsys.readouterr().out


def test_evaluate_runs_the_integers(scene, quantised, tmp_path):
    chosen = ["evaluate", quantised, "--data", scene, "--split", "validation", "-o", tmp_path, "--integer"]
    assert evaluate(parse(add_evaluate, *chosen)) == 0
    table = json.loads((tmp_path / "evaluation.json").read_text())
    assert table["details"]["form"] == "3 bit, mode III, deployed integers"
    assert table["layers"][0]["alone"] == 0
    assert all(row["alone"] <= 0.05 for row in table["layers"])
    assert "| head.p3.pose.conv2.input |" in (tmp_path / "evaluation.md").read_text()
    assert Path(table["details"]["network"]) == quantised


def _four_cells(levels, anchors, **options):
    """What a trained network would give in the middle of a view: an untrained one's cells say nothing."""
    pose = Pose(cv2.Rodrigues(np.array([0.5, 0.6, 0.1]))[0], np.array([0.0, 0.0, 5 * DIAMETER]))
    points = project(np.array([[FOCAL, 0, 32], [0, FOCAL, 32], [0, 0, 1]]), pose.R, pose.t, CORNERS)
    size = float(np.ptp(points, axis=0).max())
    return Candidates(
        np.repeat(points[None], 4, 0), np.ones(4), np.zeros(4, int), np.arange(4), size, np.full(5, 4)
    )


@pytest.mark.parametrize("form", ["weights", "quantised"])
def test_looks_and_edges_run_in_every_form(form, scene, tmp_path, request, monkeypatch):
    """Crops go through the network, float or integer; the answer names what found it."""
    seen = []
    real = Predictor.levels
    monkeypatch.setattr(
        Predictor, "levels", lambda self, images: seen.extend(i.shape for i in images) or real(self, images)
    )
    monkeypatch.setattr("macram.pose.detection.select_candidates", _four_cells)
    boxes = []
    follow = refine_on_edges
    monkeypatch.setattr(
        "macram.train.predict.refine_on_edges", lambda *a: boxes.append(a[-1].box) or follow(*a)
    )
    model = request.getfixturevalue(form)
    chosen = ["evaluate", model, "--data", scene, "--split", "validation", "--limit", 1, "-o", tmp_path]
    options = ["--looks", 2, "--edges", 0.98, *(["--integer"] if form == "quantised" else [])]
    assert evaluate(parse(add_evaluate, *chosen, *options)) == 0
    details = json.loads((tmp_path / "evaluation.json").read_text())["details"]
    assert details["solver"] == "EPnP RANSAC, Levenberg-Marquardt, 2 second looks, edges of a box of 0.98"
    assert "--looks 2 --edges 0.98" in details["command"]
    assert seen.count((128, 128, 3)) == 2
    assert boxes == [0.98]


@pytest.mark.parametrize(
    "options",
    [
        ("--looks", -1), ("--edges", -0.5), ("--edges", "nan"), ("--looks", 1000), ("--limit", -3),
        ("--published", "--looks", 2), ("--no-refine", "--edges"),
    ],
)  # fmt: skip
def test_options_that_cannot_be_leave_nothing(options, scene, weights, tmp_path):
    out = tmp_path / "out"
    with pytest.raises(ValueError, match=options[0].lstrip("-")):
        evaluate(parse(add_evaluate, "evaluate", weights, "--data", scene, "-o", out, *options))
    assert not out.exists()


def test_edges_want_a_box():
    net, card = network()
    with pytest.raises(ValueError, match="leave --edges away"):
        Predictor(net, replace(card, is_box=False), settings=PoseSettings(edges=EdgeSettings()))
