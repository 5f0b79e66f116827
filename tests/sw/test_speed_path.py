"""SPEED end to end: pictures in its layout, training, e_q + e_t; the released layout differs in its path alone."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from macram.cli import main
from macram.data.produce import produce
from macram.data.spec import RenderSpec
from macram.data.speed import FOCAL, SIZE, TANGO_M
from macram.train.checkpoint import load_model

CONFIG = Path(__file__).resolve().parents[2] / "configs/train-speed.toml"
SMALL = {
    "network.size": "tiny", "schedule.steps": 2, "schedule.batch": 2, "schedule.warmup": 0,
    "optimiser.average": 0.5, "run.precision": "fp32", "data.validation": "",
}  # fmt: skip


@pytest.fixture(scope="module")
def rendered(tmp_path_factory):
    root = tmp_path_factory.mktemp("speed") / "rendered"
    for _ in produce(root, RenderSpec(SIZE, FOCAL, (3.0, 8.0), (1, 1, 0), 2, format="speed")):
        pass
    return root


def released(rendered, root):
    """The same files as the release has them: nothing but pictures and train.json, and Tango's keypoints."""
    (root / "images").mkdir(parents=True)
    shutil.copytree(rendered / "images/train", root / "images/train")
    shutil.copy(rendered / "train.json", root / "train.json")
    return root


@pytest.mark.parametrize("layout", ["rendered", "released"])
@pytest.mark.slow
@pytest.mark.timeout(600)
def test_train_and_score(layout, rendered, tmp_path, capsys):
    root = rendered if layout == "rendered" else released(rendered, tmp_path / "SPEED")
    changes = {**SMALL, "data.root": root, "run.out": tmp_path / "run", "data.cache": tmp_path / "cache"}
    words = [word for key, value in changes.items() for word in ("--set", f"{key}={value}")]
    assert main(["train", str(CONFIG), *words, "--device", "cpu"]) == 0
    model = tmp_path / "run/model.safetensors"
    _, card = load_model(model)
    assert len(card.keypoints) == (8 if layout == "rendered" else len(TANGO_M))
    assert card.focal == pytest.approx(FOCAL / 2)
    out = tmp_path / "scores"
    assert main(["evaluate", str(model), "--data", str(root), "-o", str(out), "--device", "cpu"]) == 0
    table = json.loads((out / "evaluation.json").read_text())
    assert table["details"]["data"].endswith("validation")
    speed = table["summary"]["speed"]["count"]
    assert speed["counted"] == table["summary"]["frames"] == 1
    assert speed["score"] == pytest.approx(speed["e_q"] + speed["e_t"])
    assert speed["score"] > 0
    assert f"SPEED: e_q {speed['e_q']:.4f}, e_t {speed['e_t']:.4f}, sum" in capsys.readouterr().out
    assert "e_q + e_t" in (out / "evaluation.md").read_text()
