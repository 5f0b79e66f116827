"""Refined scores: found by several processes as by one, and beside the single look on the page."""

from __future__ import annotations

import json
import os

import pytest
import torch
from train_scene import CORNERS, DIAMETER, write_scene

from macram.data.geometry import BUCKETS
from macram.data.open import open_dataset
from macram.experiments import beside, sections
from macram.experiments.finished import finished
from macram.experiments.plan import Plan, Refined, Row, Source
from macram.experiments.run import read_evaluation
from macram.model import SpaceNet, spacenet_config
from macram.pose import EdgeSettings, LookSettings, PoseSettings
from macram.train import detect
from macram.train.checkpoint import Card, save_model
from macram.train.detect import detect_frames
from macram.train.predict import Predictor

SETTINGS = PoseSettings(
    confidence=0.0, looks=LookSettings(turns=2, side=64, size=30), edges=EdgeSettings(box=0.99)
)


def numbers(found):
    return [None if d is None else (d.pose.R.tolist(), d.pose.t.tolist(), d.score, d.pairs) for d in found]


@pytest.fixture
def threads():
    """Sets PyTorch's threads, on whose number the sums of a convolution depend."""
    before = torch.get_num_threads()
    yield torch.set_num_threads
    torch.set_num_threads(before)


def test_a_single_process_has_one_thread_too(monkeypatch, threads):
    threads(3)
    used = []
    monkeypatch.setattr(os, "sched_getaffinity", lambda pid: {0, 1})
    monkeypatch.setattr(Predictor, "load", lambda *a, **k: None)
    monkeypatch.setattr(
        detect, "_detect", lambda _, part: used.append(torch.get_num_threads()) or len(part) * [None]
    )
    assert detect_frames("model", 5 * [None], "cpu", SETTINGS) == 5 * [None]
    assert used == [1]
    assert torch.get_num_threads() == 3


def test_processes_find_what_one_finds_in_order(tmp_path, monkeypatch, threads):
    threads(1)  # for the predictors below
    config = spacenet_config("tiny", "deployable", image_size=64, counterfactual=False)
    net = SpaceNet(config, torch.Generator().manual_seed(1)).eval()
    card = Card(config, tuple(tuple(map(float, c)) for c in CORNERS), DIAMETER, "box", True, 76.0)
    save_model(tmp_path / "model.safetensors", net, card)
    scene = open_dataset(write_scene(tmp_path / "scene"))
    frames = (4 * (scene.frames("training") + scene.frames("validation")))[:37]
    assert len(frames) == 37
    answers, told = [], []
    for cores in ({0}, {0, 1}):
        monkeypatch.setattr(os, "sched_getaffinity", lambda pid, cores=cores: cores)
        found = detect_frames(
            tmp_path / "model.safetensors", frames, "cpu", SETTINGS, lambda *n: told.append(n)
        )
        answers.append(numbers(found))
    assert answers[0] == answers[1]
    assert told == 2 * [(16, 37), (32, 37), (37, 37)]
    for settings, same in ((SETTINGS, True), (PoseSettings(confidence=0.0), False)):
        predictor = Predictor(net, card, settings=settings)
        found = list(predictor.detections([(frame.read_image(), frame.camera) for frame in frames]))
        assert (numbers(found) == answers[0]) is same
    assert None not in answers[0]


def test_a_record_of_a_single_look_wants_an_evaluation_by_one(tmp_path):
    path = tmp_path / "evaluation.json"
    table = {"rows": [{"frame": "a"}], "summary": {}, "details": {"form": "float32"}}
    path.write_text(json.dumps(table))
    assert read_evaluation(path, ["a"]).rows == table["rows"]  # older ones do not name the solver
    table["details"]["solver"] = SETTINGS.words
    path.write_text(json.dumps(table))
    with pytest.raises(ValueError, match="a record wants a single look"):
        read_evaluation(path, ["a"])


# ---- the page ------------------------------------------------------------------------------------------

REFINED = Refined(4, 0.99)


def shares(add):
    return {limit: 100 * sum(a < float(limit) for a in add) / len(add) for limit in ("0.1", "0.2", "0.5")}


def frames_csv(add):
    lines = [f"t/seq_{n}/0/{n},near,2,{a},1,{a}" for n, a in enumerate(add)]
    return "\n".join(["frame,range,z_d,add_d,re_deg,te_d", *lines]) + "\n"


def write(folder, name, frames, add, **fields):
    folder.mkdir(exist_ok=True)
    (folder / frames).write_text(frames_csv(add))
    ranges = {"all": {"add": shares(add)}}
    table = {"model_sha256": "abc", "options": REFINED.options, "ranges": ranges, **fields}
    (folder / name).write_text(json.dumps(table))


def rows(results, groups):
    """A plan of rows ``name -> (group, after, seeds)``."""
    return Plan(Source(results, results), Source(results, results), REFINED, tuple(
        Row(name, name.title(), group, results, after=after, seeds=seeds)
        for name, (group, after, seeds) in groups.items()
    ))  # fmt: skip


def test_questions_stand_beside_the_control(tmp_path):
    plan = rows(tmp_path, {
        "quarter-control": ("questions", "", (1,)), "ca": ("questions", "", (1,)), "bare": ("questions", "", (1,)),
    })  # fmt: skip
    for name in ("quarter-control", "ca", "bare"):
        write(tmp_path / f"{name}.s1", "result.json", "frames.csv", [0.05, 0.3, 0.3, 0.6])
    assert beside.questions(finished(plan, tmp_path)) == []
    write(tmp_path / "quarter-control.s1", "refined.json", "refined.csv", [0.05, 0.05, 0.15, 0.3])
    write(tmp_path / "ca.s1", "refined.json", "refined.csv", [0.15, 0.15, 0.25, 0.25])
    text = "\n".join(beside.questions(finished(plan, tmp_path)))
    assert "| Quarter-Control | 25.00 | 50.00 | 25.00 | 75.00 | 75.00 | 100.00 |  |" in text
    assert "| Ca | 25.00 | 0.00 | 25.00 | 50.00 | 75.00 | 100.00 | -50.0 (" in text
    assert "| Bare | 25.00 |  | 25.00 |  | 75.00 |  |  |" in text


def test_more_data_stands_beside_the_same_training_on_less(tmp_path):
    plan = rows(
        tmp_path, {"few": ("data", "", (1,)), "many": ("questions", "", (1,)), "later": ("seeds", "", (2,))}
    )
    for name, add, images in (("few", [0.05, 0.3, 0.3, 0.6], 50), ("many", [0.05, 0.05, 0.3, 0.6], 100)):
        folder = tmp_path / f"{name}.s1"
        write(
            folder,
            "result.json",
            "frames.csv",
            add,
            images=images,
            minutes=1,
            dataset=f"cubesat1u-{name}, poses",
        )
        table = json.loads((folder / "result.json").read_text())
        table["ranges"] |= dict.fromkeys(BUCKETS, table["ranges"]["all"])
        (folder / "result.json").write_text(json.dumps({**table, "frames": 4}))
    done = finished(plan, tmp_path)
    text = "\n".join(sections.more_data(done))
    assert "| Few | few | 50 | 1 | 25.00 |" in text
    assert "| Many | many | 100 | 1 | 50.00 |" in text
    assert "- Few: +25.0 points (" in text
    assert "2.00 times the images." in text
    assert sections.more_data([f for f in done if f.job.row.group != "data"]) == []


def test_a_quantised_row_loses_against_the_float_row_of_its_seed(tmp_path):
    plan = rows(tmp_path, {"float": ("seeds", "", (1, 2)), "w3": ("quantised", "float", (2,))})
    for key, add in {
        "float.s1": [0.05] * 4,
        "float.s2": [0.05, 0.05, 0.3, 0.3],
        "w3.s2": [0.05, 0.3, 0.3, 0.3],
    }.items():
        write(tmp_path / key, "result.json", "frames.csv", [0.3] * 4)
        write(tmp_path / key, "refined.json", "refined.csv", add)
    text = "\n".join(beside.quantised(finished(plan, tmp_path)))
    assert "| W3 | 0.00 | 25.00 | 0.00 | 25.00 | 100.00 | 100.00 | -25.0 (" in text


def test_seeds_spread_over_those_that_have_both(tmp_path):
    plan = rows(tmp_path, {"eighth": ("seeds", "", (1, 2, 3)), "other": ("seeds", "", (1,))})
    for seed, add in ((1, [0.05] * 4), (2, [0.05, 0.05, 0.3, 0.3]), (3, [0.7] * 4)):
        write(tmp_path / f"eighth.s{seed}", "result.json", "frames.csv", add)
    assert beside.seeds(plan, finished(plan, tmp_path)) == []
    write(tmp_path / "eighth.s1", "refined.json", "refined.csv", [0.15] * 4)
    assert "| Eighth | 1 of 3 | 100.00 | 0.00 |" in "\n".join(beside.seeds(plan, finished(plan, tmp_path)))
    write(tmp_path / "eighth.s2", "refined.json", "refined.csv", [0.15] * 4)
    text = "\n".join(beside.seeds(plan, finished(plan, tmp_path)))
    assert "| Eighth | 2 of 3 | 75.00 ± 35.36 | 0.00 ± 0.00 | 75.00 ± 35.36 | 100.00 ± 0.00 |" in text
    assert "Other" not in text


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"model_sha256": "def"}, "another network"),
        ({"options": "--looks 8 --edges 0.99"}, "the plan says --looks 4"),
    ],
)
def test_refined_scores_of_something_else_are_refused(fields, words, tmp_path):
    plan = rows(tmp_path, {"ca": ("questions", "", (1,))})
    write(tmp_path / "ca.s1", "result.json", "frames.csv", [0.3] * 4)
    write(tmp_path / "ca.s1", "refined.json", "refined.csv", [0.3] * 4, **fields)
    with pytest.raises(ValueError, match=words) as error:
        finished(plan, tmp_path)
    assert "macram experiments refine ca RUN" in str(error.value)


def test_the_introduction_says_what_refined_is(tmp_path):
    assert "`macram evaluate --looks 4 --edges 0.99`" in beside.introduction(rows(tmp_path, {}))
