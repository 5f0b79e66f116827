"""Experiments: the plan, a row from nothing to its record, and the page made of the records."""

from __future__ import annotations

import hashlib
import json
import tomllib
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import torch
from rich.console import Console
from train_scene import write_scene

from macram.cli import main
from macram.data.recipe import read_recipe
from macram.data.render.cubesat import DIAMETER_MM, SIZE_MM
from macram.data.render.plan import plan_sequence
from macram.data.render.sequence import View
from macram.experiments import refined as refined_module
from macram.experiments import run as run_module
from macram.experiments.cost import costs
from macram.experiments.finished import finished
from macram.experiments.page import page
from macram.experiments.plan import Source, read_plan, read_result
from macram.experiments.run import record_job, run_job
from macram.experiments.statistics import Frames, difference, limits, read_frames, share, share_interval
from macram.pose import EdgeSettings, LookSettings, PoseSettings
from macram.train.checkpoint import load_model
from macram.train.config import load_config
from macram.train.learned import REFINED
from macram.train.record import train_command

ROOT = Path(__file__).resolve().parents[2]
TINY = """
surface_until = 0.5
[run]
stage = "{stage}"
out = "unused"
precision = "fp32"
{init}
[data]
root = "unused"
[network]
size = "tiny"
image_size = 64
[schedule]
steps = 2
batch = 2
warmup = 0
[log]
every = 1
evaluate_frames = 2
"""
PLAN = """
[scoring]
data = "{data}"
recipe = "{folder}/recipe.toml"
[training]
data = "{data}"
recipe = "{folder}/recipe.toml"
[refined]
looks = 2
edges = 0.99
[[row]]
name = "first"
title = "First"
group = "seeds"
config = "{folder}/wdr.toml"
seeds = [1, 2]
[[row]]
name = "second"
title = "Second"
group = "questions"
config = "{folder}/control.toml"
after = "first"
seeds = [1]
set = {{ "schedule.steps" = 3 }}
"""


@pytest.fixture
def plan(tmp_path, monkeypatch):
    scene = write_scene(tmp_path / "scene")
    (tmp_path / "wdr.toml").write_text(TINY.format(stage="wdr", init=""))
    (tmp_path / "control.toml").write_text(TINY.format(stage="control", init='init = "unused"'))
    (tmp_path / "plan.toml").write_text(PLAN.format(data=scene, folder=tmp_path))
    monkeypatch.setattr(run_module, "SPLIT", "validation")
    monkeypatch.setattr(Source, "check", lambda self: None)
    monkeypatch.setattr(run_module, "read_recipe", lambda path: SimpleNamespace(version="scene, poses 0123"))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return read_plan(tmp_path / "plan.toml")


def test_a_row_trains_what_it_continues_and_is_done_once(plan, tmp_path, monkeypatch):
    runs, results = tmp_path / "runs", tmp_path / "results"
    first, _, second = plan.jobs()
    assert second.state(runs, results) == "waiting"
    folder = run_job(second, runs, results, Console(quiet=True))
    assert first.state(runs, results) == "trained"
    assert second.state(runs, results) == "finished"
    record = read_result(folder)
    assert (record["steps"], record["images"], record["images_with_earlier_stages"]) == (3, 6, 10)
    assert record["frames"] == 4
    assert "--set schedule.steps=3" in record["train_command"]
    assert "run.seed=1" in record["train_command"]
    assert record["dataset"] == record["scored_on"] == "scene, poses 0123"
    assert {path.name for path in folder.iterdir()} == {
        "result.json",
        "frames.csv",
        "frames.jpg",
        "curve.csv",
        "refined.csv",
        "refined.json",
    }
    frames = read_frames(folder / "frames.csv")
    assert share(frames) == pytest.approx(record["ranges"]["all"]["add"]["0.1"])
    monkeypatch.setattr(run_module, "Run", None)  # training again would fail
    before = (folder / "result.json").stat().st_mtime_ns
    assert run_job(second, runs, results, Console(quiet=True)) == folder
    assert (folder / "result.json").stat().st_mtime_ns == before
    (folder / "result.json").unlink()  # trained, not recorded: scored again, not trained
    run_job(second, runs, results, Console(quiet=True))


def test_a_row_is_refined_before_it_is_finished_and_can_be_refined_later(plan, tmp_path, monkeypatch, capsys):
    runs, results = tmp_path / "runs", tmp_path / "results"
    first, other, _ = plan.jobs()
    with monkeypatch.context() as patch:
        patch.setattr(run_module, "write_refined", lambda *a: 1 / 0)
        with pytest.raises(ZeroDivisionError):
            run_job(first, runs, results, Console(quiet=True), limit=3)
    assert first.state(runs, results) == "trained"

    used = []
    real = refined_module.detect_frames
    monkeypatch.setattr(refined_module, "detect_frames", lambda *a: used.append(a[3]) or real(*a))
    folder = run_job(first, runs, results, Console(quiet=True), limit=3)
    assert used == [PoseSettings(looks=LookSettings(turns=2), edges=EdgeSettings(box=0.99))]
    written = [(folder / name).read_bytes() for name in ("refined.json", "refined.csv")]
    table, record = json.loads(written[0]), read_result(folder)
    assert table["options"] == "--looks 2 --edges 0.99"
    assert table["solver"].endswith("2 second looks, edges of a box of 0.99")
    assert table["model_sha256"] == record["model_sha256"]
    assert table["frames"] == record["frames"] == 3
    frames = read_frames(folder / "refined.csv")
    assert frames.names == read_frames(folder / "frames.csv").names
    assert share(frames) == pytest.approx(table["ranges"]["all"]["add"]["0.1"])

    (folder / "refined.json").unlink()
    (folder / "refined.csv").unlink()
    command = [
        "experiments",
        "refine",
        "first",
        "--plan",
        str(tmp_path / "plan.toml"),
        "--results",
        str(results),
    ]
    assert main([*command, str(first.folder(runs))]) == 0
    assert written == [(folder / name).read_bytes() for name in ("refined.json", "refined.csv")]

    listing = ["experiments", "list", *command[3:], "--runs", str(runs)]
    (folder / "refined.json").write_text(json.dumps({**table, "settings": {}}))
    capsys.readouterr()
    assert main([*listing, "--json"]) == 0
    row = json.loads(capsys.readouterr().out)[0]
    assert row["state"] == "finished"
    assert "refined_add_0.1" not in row
    assert "meant other settings then than now; macram experiments refine first RUN" in row["refined_error"]
    assert main(listing) == 0
    assert "refine" in capsys.readouterr().out
    (folder / "refined.json").write_bytes(written[0])

    run_module.train_job(other, runs, Console(quiet=True))
    assert main([*command, str(other.folder(runs))]) == 2
    assert "is another network than the record first.s1 has" in capsys.readouterr().err
    assert main([*command, str(other.folder(runs)), "--seed", "2"]) == 2  # no record at all
    (folder / "frames.csv").write_text((folder / "frames.csv").read_text().replace("000003,", "000009,"))
    assert main([*command, str(first.folder(runs))]) == 2
    assert "has other test frames than the record first.s1" in capsys.readouterr().err
    assert written == [(folder / name).read_bytes() for name in ("refined.json", "refined.csv")]


def test_a_record_that_is_made_anew_is_whole_or_none(plan, tmp_path, monkeypatch):
    runs, results = tmp_path / "runs", tmp_path / "results"
    first = next(plan.jobs())
    run_job(first, runs, results, Console(quiet=True), limit=2)
    monkeypatch.setattr(run_module, "write_refined", lambda *a: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        run_module.record_job(first, first.folder(runs), results, device="other", limit=3)
    assert len(read_frames(results / first.key / "frames.csv").names) == 3
    assert first.state(runs, results) == "trained"


def test_a_network_of_another_configuration_is_no_record_of_a_row(plan, tmp_path):
    runs, results = tmp_path / "runs", tmp_path / "results"
    first, other, _ = plan.jobs()
    run_module.train_job(first, runs, Console(quiet=True))
    with pytest.raises(ValueError, match=r"first\.s2: .*run\.seed = 1"):
        run_module.record_job(other, first.folder(runs), results, device="CPU")
    assert not results.exists()


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('name = "second"', 'name = "first"', "is there twice"),
        ('after = "first"', 'after = "third"', "must stand before it"),
        ("seeds = [1]\n", "seeds = [3]\n", "with its seeds"),
        ('after = "first"', 'teacher = "third"', "imitates 'third', which must stand before it"),
        (
            'after = "first"\nseeds = [1]',
            'teacher = "first"\nseeds = [3]',
            "imitates 'first'.*with its seeds",
        ),
        ('title = "First"', 'colour = "red"', "unknown field 'colour'"),
        ('group = "seeds"', 'group = "others"', "group must be one of"),
        ("looks = 2", "looks = 2.5", r"\[refined\] .*whole number"),
        ("looks = 2", "looks = 0", r"\[refined\] .*1 to 64 looks"),
        ("edges = 0.99", "edges = nan", r"\[refined\] .*box must be above 0"),
        ("edges = 0.99", "", r"\[refined\] .*missing .*edges"),
        ("edges = 0.99", "edges = 0.99\nturns = 1", r"\[refined\] .*turns"),
    ],
)
def test_a_broken_plan_is_one_line(plan, old, new, message, tmp_path):
    path = tmp_path / "plan.toml"
    path.write_text(path.read_text().replace(old, new, 1))
    with pytest.raises(ValueError, match=message) as error:
        read_plan(path)
    assert "\n" not in str(error.value)


def test_seeds_continue_the_only_one_there_is(plan, tmp_path):
    path = tmp_path / "plan.toml"
    path.write_text(
        path.read_text().replace("seeds = [1, 2]", "seeds = [7]").replace("seeds = [1]\n", "seeds = [1, 7]\n")
    )
    first, one, seven = read_plan(path).jobs()
    assert first.before() is None
    assert [job.before().key for job in (one, seven)] == ["first.s7", "first.s7"]
    assert one.config(tmp_path).run.init == str(tmp_path / "first.s7" / "model.safetensors")
    assert one.config(tmp_path).run.seed == 1


def test_a_row_trains_the_one_it_imitates_and_its_command_names_it(plan, tmp_path, monkeypatch):
    (tmp_path / "lsq.toml").write_text(TINY.format(stage="lsq", init='init = "unused"'))
    row = '[[row]]\nname = "{}"\ntitle = "Third"\ngroup = "quantised"\nconfig = "{}/lsq.toml"\nafter = "{}"\n{}\n'
    path = tmp_path / "plan.toml"
    text = path.read_text().replace("seeds = [1, 2]", "seeds = [1]")
    text += row.format("alone", tmp_path, "first", "seeds = [1]")
    text += row.format("taught", tmp_path, "first", 'teacher = "second"\nseeds = [1]')
    path.write_text(text + row.format("on", tmp_path, "taught", "seeds = [1]"))
    quantised = row.format("other", tmp_path, "first", 'teacher = "taught"\nseeds = [1]')
    (tmp_path / "wrong.toml").write_text(path.read_text() + quantised)
    with pytest.raises(ValueError, match=r"row 'other' imitates 'taught', which is no float network"):
        read_plan(tmp_path / "wrong.toml")
    _, second, alone, taught, on = read_plan(path).jobs()
    assert taught.teacher() == second
    assert alone.teacher() is None
    monkeypatch.chdir(tmp_path)
    runs, results = Path("kept"), Path("results")
    assert taught.config(runs).quant.teacher == "kept/second.s1/model.safetensors"
    record = read_result(run_job(taught, runs, results, Console(quiet=True)))
    assert "--set quant.teacher=kept/second.s1/model.safetensors" in record["train_command"]
    assert alone.state(runs, results) == "waiting"
    assert "run.init" not in record["train_command"]  # as its configuration has it
    again = read_result(run_job(on, runs, results, Console(quiet=True)))
    assert "--set run.init=kept/taught.s1/model.safetensors" in again["train_command"]
    # Where the teacher lay does not count; that there was one does.
    record_job(taught, taught.folder(runs), Path("again"), device="cpu")
    with pytest.raises(
        ValueError, match=r"alone\.s1: the network was trained with quant\.teacher = 'kept/second"
    ):
        record_job(alone, taught.folder(runs), Path("again"), device="cpu")


def test_a_seed_the_plan_does_not_have_continues_no_other(plan):
    assert plan.job("second", 7).before().key == "first.s7"


def test_the_demo_finds_poses_as_refined_scores_do():
    assert read_plan(ROOT / "configs/experiments.toml").refined.settings == REFINED


# ---- the repository's own plan and page ----------------------------------------------------------------


def test_every_row_is_a_configuration_that_loads(monkeypatch):
    monkeypatch.chdir(ROOT)
    for job in read_plan().jobs():
        config = job.config(Path("build/experiments"))
        assert config.run.seed == job.seed
        assert bool(config.run.init) == (job.before() is not None)
        assert bool(config.quant.teacher) == (job.teacher() is not None)


def test_the_page_is_what_its_records_give(monkeypatch):
    monkeypatch.chdir(ROOT)
    assert (ROOT / "docs/results.md").read_text() == page(read_plan(), Path("results"))


def test_costs_are_those_of_the_files_and_layers(monkeypatch):
    monkeypatch.chdir(ROOT)
    done = finished(read_plan(), Path("results"))
    cited = tomllib.loads(Path("results/cited.toml").read_text())
    assert costs([f for f in done if f.job.row.group != "quantised"], cited, Path("results")) == []
    _, operations, _, storage = costs(done, cited, Path("results"))
    net = load_model(Path("weights/quarter-float.safetensors"))[0]
    parameters = sum(p.numel() for p in net.parameters())
    lines = [line.strip("| ").split(" | ") for line in storage.splitlines()[2:]]
    for (bits, count, ideal, _, _, size, saved), name in zip(
        lines, ("quarter-float", "quarter-w8a8", "quarter-w3a3"), strict=True
    ):
        file = Path(f"weights/{name}.safetensors").stat().st_size
        assert int(count.replace(",", "")) == parameters
        assert float(ideal) == pytest.approx(parameters * int(bits) / 8 / 2**20, abs=0.006)
        assert float(size) == pytest.approx(file / 2**20, abs=0.006)
        assert float(saved) == pytest.approx(100 - 100 * file / (4 * parameters), abs=0.006)
    # Multiply-accumulates of one picture by what the convolutions really see.
    seen = {"backbone": 0, "fpn": 0, "head": 0, "first": 0}

    def add(name):
        def hook(layer, inputs, output):
            seen[name] += output[0].numel() * layer.weight[0].numel()

        return hook

    for name, layer in net.named_modules():
        if isinstance(layer, torch.nn.Conv2d) and not name.startswith("head.surface"):
            part = "first" if layer.in_channels == 3 else name.split(".")[0]
            layer.register_forward_hook(add(part))
    with torch.no_grad():
        net.eval()(torch.zeros(1, 3, 256, 256))
    wanted = {"I": seen["backbone"], "II": seen["backbone"] + seen["fpn"]}
    wanted["III"] = wanted["II"] + seen["head"]
    rows = [line.strip("| ").split(" | ") for line in operations.splitlines()[2:]]
    assert len(rows) >= 6
    for title, codes, others, percent, *_ in rows:
        exact = wanted[title.split("mode ")[1].split(",")[0]]
        assert float(codes) == pytest.approx(exact / 1e9, abs=0.0006)
        assert float(others) == pytest.approx((sum(seen.values()) - exact) / 1e9, abs=0.0006)
        assert float(percent) == pytest.approx(100 * exact / sum(seen.values()), abs=0.006)


def test_every_picture_of_the_page_is_there():
    text = (ROOT / "docs/results.md").read_text()
    for name in {part.split(")")[0] for part in text.split("](images/")[1:]}:
        assert (ROOT / "docs/images" / name).is_file()


def test_records_agree_with_their_frames(monkeypatch):
    monkeypatch.chdir(ROOT)
    for path in [*Path("results").glob("*/result.json"), *Path("results").glob("*/refined.json")]:
        frames = read_frames(path.parent / ("frames.csv" if path.name == "result.json" else "refined.csv"))
        for name, table in json.loads(path.read_text())["ranges"].items():
            assert share(frames, name) == pytest.approx(table["add"]["0.1"], abs=0.11), path


def test_the_box_of_refined_scores_is_the_one_measured_on_training_frames():
    plan = read_plan(ROOT / "configs/experiments.toml")
    measured = json.loads((ROOT / "results/inference-quarter-control.json").read_text())
    assert plan.refined.edges == measured["edge_box"]
    name = f"{plan.refined.looks} looks, edges"
    assert any((row["name"], row["split"]) == (name, "validation") for row in measured["rows"])


def test_the_readme_has_the_records_figures():
    results = ROOT / "results"
    tried = json.loads((results / "inference-quarter-w3a3-integers.json").read_text())["rows"]
    integers = {row["options"]: row["add"] for row in tried}
    refined = read_plan(ROOT / "configs/experiments.toml").refined.options
    single = json.loads((results / "quarter-wdr.s2022/result.json").read_text())
    float_refined = json.loads((results / "quarter-wdr.s2022/refined.json").read_text())
    looks, look, both, one = (
        f"{add['0.1']} % and {add['0.2']} %"
        for add in (
            integers["--looks 4 --edges BOX"],
            integers["(default)"],
            float_refined["ranges"]["all"]["add"],
            single["ranges"]["all"]["add"],
        )
    )
    text = " ".join((ROOT / "README.md").read_text().split())
    assert (
        looks.replace("%", "% a pose within 0.1 diameters (ADD)", 1)
        + f" within 0.2 with `{refined}`, {look} by a "
        f"single look; the float network it comes from {both}, and {one}"
    ) in text


def test_the_recipe_is_the_mini_tier_with_backgrounds():
    from dataclasses import replace  # noqa: PLC0415

    from macram.data.spec import TIERS  # noqa: PLC0415

    mini = replace(TIERS["mini"], background=True)
    assert read_recipe(ROOT / "configs/cubesat1u-v1.toml").spec == mini
    longer = read_recipe(ROOT / "configs/cubesat1u-v1-20k.toml").spec
    assert longer == replace(mini, sequences=(1000, *mini.sequences[1:]))


@pytest.mark.parametrize("name", ["cubesat1u-v1", "cubesat1u-v1-20k"])
def test_the_hash_of_a_recipe_is_that_of_its_plans(name):
    """Without rendering: poses are decided before."""
    recipe = read_recipe(ROOT / f"configs/{name}.toml")
    spec, digest = recipe.spec, hashlib.sha256()
    view, depth = View(*spec.size, spec.focal), (spec.depth[0] * DIAMETER_MM, spec.depth[1] * DIAMETER_MM)
    for split, count in enumerate(spec.sequences):
        for sequence in range(count):
            seed = (spec.seed, split, sequence)
            plan = plan_sequence(seed, spec.frames, view, depth, float(SIZE_MM.max()))
            lines = [
                f' "{n}": '
                + json.dumps([{"cam_R_m2c": R.ravel().tolist(), "cam_t_m2c": t.tolist(), "obj_id": 1}])
                for n, (R, t) in enumerate(zip(plan.rotations, plan.translations, strict=True))
            ]
            digest.update(("{\n" + ",\n".join(lines) + "\n}\n").encode())
    assert digest.hexdigest() == recipe.poses_sha256


def test_a_command_names_data_of_the_repository_and_none_of_a_machine():
    path = ROOT / "configs/train-quarter-wdr.toml"
    for root, wanted in (
        ("build/data/mini", False),
        ("build/data/other", True),
        ("/data/other", False),
    ):
        config = load_config(path, {"data.root": root}).to_dict()
        assert (f"--set data.root={root}" in train_command(path, config)) is wanted


def test_paper_front_configurations_load():
    for name in ("wdr", "w3a3"):
        load_config(ROOT / f"configs/train-paper-front-{name}.toml")


@pytest.mark.parametrize(
    "action", [["run", "first"], ["record", "first", "RUN", "--device", "a"], ["inference", "M"]]
)
def test_a_limit_below_zero_is_refused_before_any_work(plan, action, tmp_path, capsys):
    command = ["experiments", *action, "--limit", "-1", "--plan", str(tmp_path / "plan.toml")]
    assert main([*command, "--results", str(tmp_path / "results")]) == 2
    assert "--limit must be 0 (all frames) or more, not -1" in capsys.readouterr().err
    assert not (tmp_path / "results").exists()


def test_list_tells_states(plan, tmp_path, capsys):
    arguments = [
        "--plan",
        str(tmp_path / "plan.toml"),
        "--results",
        str(tmp_path),
        "--runs",
        str(tmp_path / "r"),
    ]
    assert main(["experiments", "list", "--json", *arguments]) == 0
    rows = json.loads(capsys.readouterr().out)
    assert [(row["row"], row["seed"], row["state"]) for row in rows] == [
        ("first", 1, "waiting"), ("first", 2, "waiting"), ("second", 1, "waiting"),
    ]  # fmt: skip
    assert main(["experiments", "run", "third", *arguments]) == 2
    assert "no row 'third'; rows: first, second" in capsys.readouterr().err


# ---- statistics ----------------------------------------------------------------------------------------


def frames_of(add, sequences=10):
    names = tuple(f"testing/seq_{i % sequences:06d}/000000/{i:06d}" for i in range(len(add)))
    add = np.asarray(add, float)
    return Frames(names, np.full(len(add), "near"), add, add, 10 * add, add)


def test_a_constant_difference_has_no_spread():
    one, other = frames_of(np.full(100, 0.05)), frames_of(np.full(100, 0.2))
    assert difference(one, other) == (100.0, 100.0, 100.0)
    assert difference(one, one) == (0.0, 0.0, 0.0)
    with pytest.raises(ValueError, match="different frames"):
        difference(one, frames_of(np.full(50, 0.05)))


def test_like_frames_of_a_sequence_widen_the_interval():
    rng = np.random.default_rng(0)
    scene = rng.random(50) < 0.3
    add = np.where(scene[np.arange(1000) % 50], 0.05, 0.5)
    low, high = share_interval(frames_of(add, 50))
    alone = share_interval(frames_of(add, 1000))
    assert low < share(frames_of(add)) < high
    assert high - low > 3 * (alone[1] - alone[0])


def test_limits_count_what_is_not_found_as_not_placed():
    frames = frames_of([0.05, 0.05, 1.0, 0.3])
    frames.te_d[2] = frames.re_deg[2] = np.nan
    every = limits(frames)[-1]
    assert (every["add"], every["placed"], every["flipped"]) == (50.0, 50.0, 0.0)
