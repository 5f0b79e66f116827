"""The demo's learned half: the pose of the shipped example and a layer with learned weights."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from macram.demo import demo_image, learned_pose
from macram.golden import run_layer
from macram.layer_job import array_for


@pytest.fixture(scope="module")
def learned():
    return learned_pose(None, None)[1]


def test_the_shipped_network_finds_the_example(learned):
    errors = learned.report["errors"]
    assert errors["translation_mm"] < 0.05 * errors["distance_mm"]
    assert errors["rotation_deg"] < 30
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
    assert "errors" not in report
    with pytest.raises(ValueError, match="--focal must be above 0"):
        learned_pose(Path(picture), -1.0)
