from __future__ import annotations

import csv
from pathlib import Path

import pytest
import torch

from macram.data.produce import produce
from macram.data.spec import TIERS
from macram.train.config import load_config
from macram.train.distributed import Processes
from macram.train.loop import Run

CONFIG = Path(__file__).parents[2] / "configs/train-tiny.toml"


@pytest.mark.slow
@pytest.mark.timeout(600)
def test_a_minute_of_training_lowers_the_loss_and_raises_add(tmp_path):
    for _ in produce(tmp_path / "smoke", TIERS["smoke"], 1):
        pass
    changes = {
        "run.out": str(tmp_path / "run"),
        "data.root": str(tmp_path / "smoke"),
        "data.cache": str(tmp_path / "cache"),
    }
    run = Run(load_config(CONFIG, changes), Processes(0, 1, torch.device("cpu")), None)
    before = run._score(None)
    run.train()
    with (tmp_path / "run/log.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert before["add_0.5"] == 0
    assert float(rows[-1]["add_0.5"]) >= 80
    assert float(rows[-1]["add_0.2"]) >= 40
    assert float(rows[-2]["pose"]) < 0.4 * float(rows[0]["pose"])
    assert float(rows[-2]["class"]) < 0.4 * float(rows[0]["class"])
