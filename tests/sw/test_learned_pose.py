"""The demo's learned half: the pose of the shipped example and a layer with learned weights."""

from __future__ import annotations

import json
from pathlib import Path

import cv2
import numpy as np
import pytest
import torch

from macram.demo import demo_image, learned_pose, reference_front
from macram.experiments.plan import read_plan
from macram.golden import run_layer
from macram.layer_job import array_for
from macram.model import SpaceNet, spacenet_config
from macram.quant import calibrate_batch_norm, calibrate_steps, quantise
from macram.report.latency import REFERENCE
from macram.train.checkpoint import Card, save_packed
from macram.weights import INDEX, sha256, shipped

PLAN = Path(__file__).resolve().parents[2] / "configs/experiments.toml"


@pytest.fixture(scope="module")
def learned():
    return learned_pose(None, None)[1]


def test_the_shipped_network_finds_the_example(learned):
    errors = learned.report["errors"]
    assert errors["translation_mm"] < 0.02 * errors["distance_mm"]
    assert errors["rotation_deg"] < 5
    assert learned.report["solver"] == read_plan(PLAN).refined.settings.words
    assert learned.report["form"] == "3 bit, mode III, deployed integers"
    assert learned.picture.shape == (256, 256, 3)
    assert (learned.picture != cv2.imread(str(demo_image()))[..., ::-1]).any()


def test_its_layer_is_the_golden_models_to_the_last_code(learned):
    assert learned.deployed_codes.shape == (32, 64, 64)
    assert np.array_equal(run_layer(learned.case), learned.deployed_codes)
    assert len(np.unique(learned.deployed_codes)) > 4
    array_for(learned.case.spec)


def test_a_picture_without_a_camera_says_what_was_assumed(tmp_path):
    picture = tmp_path / "grey.png"
    cv2.imwrite(str(picture), np.full((64, 96, 3), 90, np.uint8))
    report = learned_pose(picture, None)[1].report
    assert report["camera"].startswith("assumed")
    assert report["pose"] is None
    assert report["errors"] is None
    with pytest.raises(ValueError, match="--focal must be above 0"):
        learned_pose(Path(picture), -1.0)


def test_a_network_in_the_index_gives_the_reference_layer_its_weights(tmp_path, monkeypatch):
    config = spacenet_config("paper-front", "deployable", image_size=64, counterfactual=False)
    net = SpaceNet(config, torch.Generator().manual_seed(7)).eval()
    images = torch.randn(4, 3, 64, 64, generator=torch.Generator().manual_seed(8))
    calibrate_batch_norm(net, images)
    card = Card(config, ((0.0, 0.0, 0.0),) * 8, 1.0, "box", True, 76.0, mode="III", bits=3)
    net = quantise(net, "III", card.precision)
    calibrate_steps(net, images)
    path = tmp_path / "front.safetensors"
    save_packed(path, net, card)
    table = {"format": 1, "demo": {"pose": "", "reference_layer": "front"}, "networks": {}}
    table["networks"]["front"] = {"file": path.name, "sha256": sha256(path)}
    (tmp_path / INDEX).write_text(json.dumps(table))
    monkeypatch.setattr("macram.weights.PLACES", (tmp_path,))
    _, front = reference_front(demo_image(), checkpoint=None, seed=1)
    assert front.case.spec == REFERENCE
    expand = net.backbone.stages[1].units[0].expand
    assert np.array_equal(front.case.weights, expand.weight_quant.to_codes(expand.conv.weight).numpy())
    assert np.array_equal(run_layer(front.case), front.deployed_codes)
    assert front.provenance["weights"] == "front, learned"


def test_a_narrow_network_is_no_reference_layer(tmp_path, monkeypatch):
    source = shipped()["quarter-w3a3"]
    table = {"format": 1, "demo": {"reference_layer": "narrow"}, "networks": {"narrow": source.about}}
    (tmp_path / source.path.name).write_bytes(source.path.read_bytes())
    (tmp_path / INDEX).write_text(json.dumps(table))
    monkeypatch.setattr("macram.weights.PLACES", (tmp_path,))
    with pytest.raises(ValueError, match="narrow: is no quantised network of the paper's width"):
        reference_front(demo_image(), checkpoint=None, seed=1)
