from __future__ import annotations

import math
from pathlib import Path

import pytest

from macram.cli.train_verb import overrides
from macram.train.config import TrainConfig, completed, load_config
from macram.train.schedule import crop_phase, learning_rate, progress
from macram.train.settings import CropPhase, ScheduleSettings

CONFIGS = Path(__file__).parents[2] / "configs"
LEAST = {"run": {"stage": "wdr", "out": "o"}, "data": {"root": "r"}, "schedule": {"steps": 100}}


def changed(**tables):
    return {**LEAST, **{name: {**LEAST.get(name, {}), **table} for name, table in tables.items()}}


@pytest.mark.parametrize("path", sorted(CONFIGS.glob("train-*.toml")), ids=lambda p: p.stem)
def test_shipped_configurations_load(path):
    assert load_config(path).schedule.steps > 0


def test_there_are_shipped_configurations_of_every_stage():
    stages = {load_config(path).run.stage for path in CONFIGS.glob("train-*.toml")}
    assert stages == {"wdr", "counterfactual", "control", "lsq"}


def test_dict_round_trip():
    table = changed(network={"faults": ["dead_top"]}, schedule={"milestones": [0.5], "by_clock": False})
    table["crops"] = [{"until": 0.5, "sizes": [64, 96]}, {"until": 1, "sizes": [0]}]
    config = TrainConfig.from_dict(table)
    assert config.crops[0] == CropPhase(0.5, (64, 96))
    assert config.network.faults == ("dead_top",)
    assert TrainConfig.from_dict(config.to_dict()) == config


@pytest.mark.parametrize(
    ("table", "words"),
    [
        (changed(run={"stage": "wrd"}), "run.stage must be one of"),
        (changed(run={"stage": "lsq"}), "set run.init"),
        (changed(run={"sede": 1}), "run.sede is unknown"),
        (changed(schedule={"steps": 0}), "schedule.steps must be a number of at least 1"),
        (changed(schedule={"steps": 1.5}), "schedule.steps must be of type int"),
        (changed(schedule={"by_clock": True}), "needs schedule.max_minutes"),
        (changed(optimiser={"lr": -1.0}), "optimiser.lr must be above 0"),
        (changed(optimiser={"lr": math.inf}), "optimiser.lr must be above 0"),
        (changed(optimiser={"clip": math.nan}), "optimiser.clip must be a number"),
        (changed(optimiser={"weight_decay": math.inf}), "optimiser.weight_decay must be a number"),
        (changed(run={"seed": -1}), "run.seed must be a number of at least 0"),
        (changed(schedule={"milestones": [0.5, 2]}), "schedule.milestones must rise"),
        (changed(schedule={"milestones": [0.9, 0.5]}), "schedule.milestones must rise"),
        (changed(schedule={"decay": math.nan}), "schedule.decay must be above 0"),
        (changed(schedule={"max_minutes": math.inf}), "schedule.max_minutes must be a number"),
        (changed(network={"image_size": 100}), "network.image_size must be a multiple of 32"),
        (changed(network={"tde_factor": math.nan}), "network.tde_factor must be above 0"),
        ({**LEAST, "surface_until": math.nan}, "surface_until must lie in 0..1"),
        ({**LEAST, "loss": {"pose": -1}}, "loss.pose must be a number of at least 0"),
        ({**LEAST, "loss": {"pose_scale": 0}}, "loss.pose_scale must be above 0"),
        ({**LEAST, "augment": {"noise": math.inf}}, "noise inf"),
        (changed(network={"size": "half"}), "network.size"),
        (changed(network={"faults": ["dead"]}), "network.faults"),
        (changed(quant={"bits": 4}), "quant.bits must be 3 or 8"),
        (changed(quant={"teacher": "model.safetensors"}), "quant.teacher is for stage 'lsq', not"),
        (changed(loss={"imitation": -1.0}), "loss.imitation must be a number of at least 0"),
        ({**LEAST, "crops": [{"until": 0.5, "sizes": [0]}]}, "the last of them 1"),
        ({**LEAST, "crops": [{"until": 1, "sizes": [50]}]}, "multiples of 32"),
        ({**LEAST, "data": {}}, "data.root is missing"),
        ({**LEAST, "loss": 3}, "loss must be a table"),
        ({**LEAST, "augment": {"labels": "refit"}}, "labels 'refit'"),
        (changed(schedule={"milestones": 0.5}), "schedule.milestones must be a list"),
        ({"run": LEAST["run"], "data": LEAST["data"]}, "schedule is missing"),
        (
            {**LEAST, "augment": {"labels": "reference"}, "crops": [{"until": 1, "sizes": [64]}]},
            "crops need exact labels",
        ),
    ],
)
def test_bad_configurations_name_the_key(table, words):
    with pytest.raises(ValueError, match=words):
        TrainConfig.from_dict(table)


def test_file_errors_name_the_file(tmp_path):
    with pytest.raises(ValueError, match=r"nothing\.toml: no such configuration"):
        load_config(tmp_path / "nothing.toml")
    broken = tmp_path / "broken.toml"
    broken.write_text("[run")
    with pytest.raises(ValueError, match=r"broken\.toml: not valid TOML"):
        load_config(broken)


def test_overrides_read_toml_values_and_bare_words():
    given = overrides(["schedule.steps=7", "run.out=runs/a", "optimiser.lr=0.5", "network.surface=true"])
    assert given == {"schedule.steps": 7, "run.out": "runs/a", "optimiser.lr": 0.5, "network.surface": True}
    with pytest.raises(ValueError, match="KEY=VALUE"):
        overrides(["steps"])


def test_records_from_before_a_setting_mean_its_default():
    config = TrainConfig.from_dict(changed(optimiser={"lr": 0.5}))
    record = config.to_dict()
    del record["loss"]["pose_scale"]
    assert completed(record) == config.to_dict()


def test_published_schedule():
    # SwissCube, stage 2: 114,000 steps, decay at 76,000 and 95,000, warm-up of 1,000.
    schedule = ScheduleSettings(steps=114_000)
    rates = {
        s: learning_rate(schedule, 0.01, s, progress(schedule, s, 0))
        for s in (0, 999, 1000, 75_999, 76_000, 95_000)
    }
    assert rates[0] == pytest.approx(0.01 / 1001)
    assert rates[999] == pytest.approx(0.01, rel=2e-3)
    assert rates[999] < 0.01
    assert rates[1000] == rates[75_999] == 0.01
    assert rates[76_000] == pytest.approx(1e-3)
    assert rates[95_000] == pytest.approx(1e-4)


def test_cosine_and_clock():
    schedule = ScheduleSettings(steps=1000, warmup=0, shape="cosine", max_minutes=10, by_clock=True)
    assert progress(schedule, 100, 5.0) == 0.5
    assert progress(schedule, 900, 5.0) == 0.9
    assert progress(schedule, 0, 99.0) == 1.0
    assert learning_rate(schedule, 2.0, 100, 0.5) == pytest.approx(1.0)
    assert learning_rate(schedule, 2.0, 100, 1.0) == pytest.approx(0.0)
    assert learning_rate(schedule, 2.0, 0, 0.25) == pytest.approx(1 + math.sqrt(0.5))


def test_crop_phases_follow_each_other():
    table = {
        **LEAST,
        "crops": [
            {"until": 0.2, "sizes": [64]},
            {"until": 0.8, "sizes": [96, 128]},
            {"until": 1, "sizes": [0]},
        ],
    }
    config = TrainConfig.from_dict(table)
    assert [crop_phase(config, done).sizes[0] for done in (0, 0.19, 0.2, 0.79, 0.8, 1.0)] == [
        64,
        64,
        96,
        96,
        0,
        0,
    ]
