"""Refined scores: found by several processes as by one, and beside the single look on the page."""

from __future__ import annotations

import json
import os

import pytest
import torch
from train_scene import CORNERS, DIAMETER, write_scene

from macram.data.geometry import BUCKETS
from macram.data.open import open_dataset
from macram.experiments import beside, sections, seeds
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
    about = {"model_sha256": "abc", "options": REFINED.options, "settings": REFINED.settings.to_dict()}
    table = {**about, "ranges": ranges, **fields}
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
            device=f"GPU {name}",
        )
        table = json.loads((folder / "result.json").read_text())
        table["ranges"] |= dict.fromkeys(BUCKETS, table["ranges"]["all"])
        (folder / "result.json").write_text(json.dumps({**table, "frames": 4}))
    done = finished(plan, tmp_path)
    text = "\n".join(sections.more_data(done))
    assert "| Few | few | 50 | 1 | 25.00 |" in text
    assert "| Many | many | 100 | 1 | 50.00 |" in text
    assert "- Many against Few: +25.0 points (" in text
    assert "2.00 times the images (GPU many, GPU few)." in text
    assert sections.more_data([f for f in done if f.job.row.group != "data"]) == []


def test_a_quantised_row_loses_against_the_float_row_of_its_seed(tmp_path):
    plan = rows(tmp_path, {
        "float": ("seeds", "", (1, 2)), "w3": ("quantised", "float", (2,)), "on": ("quantised", "w3", (2,)),
    })  # fmt: skip
    assert [job.unquantised() and job.unquantised().key for job in plan.jobs()] == [
        None, None, "float.s2", "float.s2",
    ]  # fmt: skip
    for key, add in {
        "float.s1": [0.05] * 4,
        "float.s2": [0.05, 0.05, 0.3, 0.3],
        "w3.s2": [0.05, 0.3, 0.3, 0.3],
        "on.s2": [0.3, 0.3, 0.3, 0.3],
    }.items():
        write(tmp_path / key, "result.json", "frames.csv", [0.3] * 4)
        write(tmp_path / key, "refined.json", "refined.csv", add)
    assert beside.front(finished(plan, tmp_path)) == []
    text = "\n".join(beside.quantised(finished(plan, tmp_path)))
    assert "| W3 | 0.00 | 25.00 | 0.00 | 25.00 | 100.00 | 100.00 | -25.0 (" in text
    assert "| On | 0.00 | 0.00 | 0.00 | 0.00 | 100.00 | 100.00 | -50.0 (" in text


def write_seeds(results, name, single, refined=None):
    """Records of as many seeds as there are lists of errors."""
    for seed, add in enumerate(single, 1):
        write(results / f"{name}.s{seed}", "result.json", "frames.csv", add, images=1200)
    for seed, add in enumerate(refined or [], 1):
        write(results / f"{name}.s{seed}", "refined.json", "refined.csv", add)


def test_seeds_have_a_mean_and_a_spread(tmp_path):
    plan = rows(tmp_path, {"eighth": ("seeds", "", (1, 2, 3)), "other": ("seeds", "", (1,))})
    assert "None of `eighth`, `other` has been run" in "\n".join(seeds.section(plan, []))
    assert seeds.section(rows(tmp_path, {}), []) == []
    write_seeds(tmp_path, "eighth", [[0.05] * 4, [0.05, 0.05, 0.3, 0.3]], [[0.15] * 4])
    text = "\n".join(seeds.section(plan, finished(plan, tmp_path)))
    assert "| Eighth | 2 of 3 | 1,200 | 75.00 ± 35.36 |  | 75.00 ± 35.36 |  | 100.00 ± 0.00 |  |" in text
    assert "Other" not in text
    write_seeds(tmp_path, "eighth", [[0.05] * 4, [0.05, 0.05, 0.3, 0.3]], [[0.15] * 4, [0.15] * 4])
    text = "\n".join(seeds.section(plan, finished(plan, tmp_path)))
    assert "| 75.00 ± 35.36 | 0.00 ± 0.00 | 75.00 ± 35.36 | 100.00 ± 0.00 |" in text
    write(tmp_path / "eighth.s2", "result.json", "frames.csv", [0.05] * 4, images=98_000)
    assert "| 1,200 to 98,000 |" in "\n".join(seeds.section(plan, finished(plan, tmp_path)))


def quarters(*right):
    """Errors of four frames for each number of frames that are right."""
    return [[0.05] * n + [0.7] * (4 - n) for n in right]


def test_rows_differ_seed_by_seed(tmp_path):
    plan = rows(tmp_path, {
        "first": ("questions", "", (9,)), "control": ("seeds", "first", (1, 2, 3)), "ca": ("seeds", "first", (1, 2, 3)),
    })  # fmt: skip
    write_seeds(tmp_path, "control", quarters(2, 3, 4))
    write_seeds(tmp_path, "ca", quarters(1, 2, 3), quarters(1, 1, 1))
    text = "\n".join(seeds.section(plan, finished(plan, tmp_path)))
    assert "*Ca* less *Control*, seed by seed. All seeds continue one training of `first` (seed 9)" in text
    assert "| 0.1d %, single | -25.0, -25.0, -25.0 | -25.00 ± 0.00 |  | seeds too alike to tell |" in text
    assert "| 0.1d %, refined |  |  |  |  |" in text
    write_seeds(tmp_path, "control", [[0.05] * (99 - n) + [0.7] * (1 + n) for n in range(3)])
    write_seeds(tmp_path, "ca", [[0.05] * (60 - n) + [0.7] * (40 + n) for n in (0, 1, 3)])
    text = "\n".join(seeds.section(plan, finished(plan, tmp_path)))
    # differences -39, -39, -40: s = 1 / sqrt(3), 4.303 * s / sqrt(3) = 1.434
    assert "| -39.0, -39.0, -40.0 | -39.33 ± 0.58 | -40.8 to -37.9 | worse |" in text
    write_seeds(tmp_path, "control", quarters(2, 3, 4))
    write_seeds(tmp_path, "ca", quarters(1, 4, 4))
    text = "\n".join(seeds.section(plan, finished(plan, tmp_path)))
    # t(0.975; 2) = 4.303 by the published tables: 4.303 * 25 / sqrt(3) = 62.1
    assert (
        "| 0.1d %, single | -25.0, +25.0, +0.0 | +0.00 ± 25.00 | -62.1 to +62.1 | no difference found |"
        in text
    )
    (tmp_path / "ca.s2" / "result.json").unlink()
    (tmp_path / "ca.s3" / "result.json").unlink()
    text = "\n".join(seeds.section(plan, finished(plan, tmp_path)))
    assert "| 0.1d %, single | -25.0 |  |  | one seed alone |" in text


def test_seeds_of_two_stages_say_so(tmp_path):
    plan = rows(tmp_path, {
        "first": ("seeds", "", (1, 2)), "control": ("seeds", "first", (1, 2)), "ca": ("seeds", "first", (1, 2)),
    })  # fmt: skip
    for name in ("control", "ca"):
        write_seeds(tmp_path, name, quarters(1, 2))
    text = "\n".join(seeds.section(plan, finished(plan, tmp_path)))
    assert "Every seed continues its own training of `first`." in text
    assert text.count("less") == 1


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"model_sha256": "def"}, "another network"),
        ({"options": "--looks 8 --edges 0.99"}, "the plan says --looks 4"),
        ({"settings": {}}, "--looks 4 --edges 0.99 meant other settings then"),
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
