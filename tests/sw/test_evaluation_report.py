from __future__ import annotations

import io
import json

import numpy as np
import pytest
from PIL import Image

from macram.pose import GroundTruth, Pose, evaluate
from macram.report.evaluation import evaluation_markdown, evaluation_png, write_evaluation

D = 100.0
K = np.array([[300.0, 0.0, 128.0], [0.0, 300.0, 128.0], [0.0, 0.0, 1.0]])
POINTS = np.random.default_rng(0).uniform(-30, 30, (50, 3))


def evaluated(shares, depths=None):
    """Frames with an ADD of exactly these shares of d; None is a miss."""
    depths = np.linspace(1.5, 9.5, len(shares)) if depths is None else depths
    frames = [GroundTruth(f"{i:03d}", Pose(np.eye(3), [0, 0, z * D]), K) for i, z in enumerate(depths)]
    predictions = {
        f.name: Pose(np.eye(3), f.pose.t + np.array([[s * D], [0], [0]]))
        for f, s in zip(frames, shares, strict=True)
        if s is not None
    }
    return evaluate(predictions, frames, vertices=POINTS, diameter=D)


def cells(markdown, label):
    rows = [line for line in markdown.splitlines() if line.strip("| ").startswith(label)]
    return [[c.strip() for c in row.strip("|").split("|")][1:] for row in rows]


def test_markdown_carries_the_figures():
    result = evaluated([0.01, 0.3, 0.04, None, 0.02, 0.15])
    page = evaluation_markdown(result.summary, "Title", {"data": "set A"})
    assert page.startswith("# Title\n\n- data: set A\n- frames: 6, without a pose: 1 (16.67 %)")
    fixed, thirds = cells(page, "**ADD-0.1d (%)**")
    summary = result.summary
    for row, division in ((fixed, "fixed"), (thirds, "thirds")):
        assert row == [f"{summary[division][n]['add']['0.1']:.2f}" for n in ("near", "medium", "far", "all")]
    assert cells(page, "frames")[0] == ["2", "2", "2", "6"]
    assert cells(page, "counted (e_q = pi, e_t = 1)")[0][0] == "6"
    assert cells(page, "skipped, as published")[0][0] == "5"
    # Every table row has the width of its heading.
    for block in page.split("\n\n"):
        if block.startswith("|"):
            assert len({line.count("|") for line in block.splitlines()}) == 1


def test_empty_ranges_are_dashes_and_outside_frames_are_named():
    page = evaluation_markdown(evaluated([0.01, 0.02], [2.0, 12.0]).summary, "T", {})
    assert cells(page, "**ADD-0.1d (%)**")[0] == ["100.00", "-", "-", "100.00"]
    assert "1 frames lie outside the limits" in page


def test_files_are_written_whole(tmp_path):
    result = evaluated([0.01, 0.3, None, 0.02])
    paths = write_evaluation(tmp_path, result, title="T", details={"checkpoint": "x"})
    assert sorted(p.name for p in tmp_path.iterdir()) == [
        "evaluation.json",
        "evaluation.md",
        "evaluation.png",
    ]
    table = json.loads(paths[0].read_text())
    assert table["summary"] == result.summary
    assert table["rows"] == result.rows
    assert table["details"] == {"checkpoint": "x"}
    assert Image.open(paths[2]).size[0] > 800
    with pytest.raises(OSError, match="missing"):
        write_evaluation(tmp_path / "missing", result)


@pytest.mark.parametrize("shares", [[None, None], [0.0], [None, 0.0, 0.2]])
def test_plots_of_extreme_sets(shares):
    picture = np.asarray(Image.open(io.BytesIO(evaluation_png(evaluated(shares), "T"))).convert("RGB"))
    assert picture.std() > 5


def test_plots_depend_on_the_figures_alone():
    good, same, bad = (evaluation_png(evaluated([share] * 6), "T") for share in (0.01, 0.01, 0.3))
    assert good == same
    assert good != bad


def test_layer_differences_are_weighted_by_their_codes(tmp_path):
    layers = [
        {"name": "a", "codes": 300, "alone": 0.0, "accumulated": 0.5, "largest": 0},
        {"name": "b", "codes": 100, "alone": 0.02, "accumulated": 0.1, "largest": 1},
    ]
    paths = write_evaluation(tmp_path, evaluated([0.01, 0.02]), layers=layers)
    assert json.loads(paths[0].read_text())["layers"] == layers
    page = paths[1].read_text()
    assert "| **all** | 400 | 0.5000 | 40.0000 | 1 |" in page
    assert "| b | 100 | 2.0000 | 10.0000 | 1 |" in page
    write_evaluation(tmp_path, evaluated([0.01, 0.02]))
    assert "layers" not in json.loads(paths[0].read_text())
    assert "deployed integers" not in paths[1].read_text()
