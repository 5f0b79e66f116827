from __future__ import annotations

import csv
import os
import shutil
import subprocess
import sys
from dataclasses import replace
from itertools import product
from pathlib import Path

import pytest
import torch
from safetensors.torch import load_file
from train_scene import write_scene

from macram.model import ThreePaths
from macram.model.fpn import PyramidTop
from macram.quant import LsqConv2d
from macram.train.checkpoint import load_model, read_tensors, save_model
from macram.train.config import TrainConfig
from macram.train.distributed import Processes
from macram.train.feed import Feed
from macram.train.loop import LAST, MODEL, Run
from macram.train.mixed import exact_layers
from macram.train.record import stage_records
from macram.train.watch import Watch

ALONE = Processes(0, 1, torch.device("cpu"))


@pytest.fixture(scope="module", autouse=True)
def one_thread():
    """Layers this small lose more to waiting for each other's threads than they win."""
    before = torch.get_num_threads()
    torch.set_num_threads(1)
    yield
    torch.set_num_threads(before)


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    return write_scene(tmp_path_factory.mktemp("scene") / "data")


def config(scene, out, stage="wdr", **tables):
    table = {
        "run": {"stage": stage, "out": str(out), "precision": "fp32"},
        "data": {"root": str(scene), "cache": str(scene.parent / "cache")},
        "network": {"size": "tiny", "image_size": 64, "surface": stage == "wdr"},
        "optimiser": {"kind": "adamw", "lr": 2e-3, "average": 0.9},
        "schedule": {"steps": 6, "batch": 4, "warmup": 2, "shape": "cosine"},
        "crops": [{"until": 0.4, "sizes": [32]}, {"until": 1, "sizes": [0]}],
        "quant": {"calibration": 8},
        "log": {"every": 2, "checkpoint_minutes": 0.0, "evaluate_frames": 2},
    }
    for name, values in tables.items():
        table[name] = {**table.get(name, {}), **values} if isinstance(values, dict) else values
    return TrainConfig.from_dict(table)


@pytest.fixture(scope="module")
def wdr(scene, tmp_path_factory):
    """A finished stage 1."""
    out = tmp_path_factory.mktemp("wdr")
    Run(config(scene, out), ALONE, None).train()
    return out / MODEL


STAGES = ["wdr", "control", "counterfactual", "published", "lsq-8-I", "lsq-3-III"]


def stage_config(name, scene, out, wdr):
    if name == "wdr":
        return config(scene, out)
    if name.startswith("lsq"):
        _, bits, mode = name.split("-")
        return config(scene, out, "lsq", run={"init": str(wdr)}, quant={"bits": int(bits), "mode": mode})
    changes = {"run": {"init": str(wdr)}, "optimiser": {"kind": "sgd", "lr": 1e-3, "average": 0.0}}
    if name == "published":
        faults = [
            "dead_top",
            "drifting_statistics",
            "untrained_counterfactual",
            "misaligned_warp",
            "refitted_poses",
        ]
        changes |= {"network": {"faults": faults}, "crops": [{"until": 1, "sizes": [0]}]}
        name = "counterfactual"
    return config(scene, out, name, **changes)


@pytest.mark.parametrize("stage", STAGES)
def test_resumed_run_equals_an_uninterrupted_one_bit_for_bit(stage, scene, tmp_path, wdr):
    whole = stage_config(stage, scene, tmp_path / "whole", wdr)
    Run(whole, ALONE, None).train()

    parts = replace(whole, run=replace(whole.run, out=str(tmp_path / "parts")))
    first = Run(parts, ALONE, None)
    # What an interruption after step 3 leaves.
    _stop_after(first, 3)
    second = Run(parts, ALONE, None, resume=True)
    assert second.step == 3
    second.train()

    for name in (LAST, MODEL):
        one, other = load_file(tmp_path / "whole" / name), load_file(tmp_path / "parts" / name)
        assert one.keys() == other.keys()
        assert all(torch.equal(one[key], other[key]) for key in one)
    state = [read_tensors(tmp_path / part / LAST)[1]["state"] for part in ("whole", "parts")]
    assert [(s["step"], s["visits"]) for s in state] == [(6, 24), (6, 24)]


def _stop_after(run, steps):
    run.folder.mkdir(parents=True)
    run.stage.module.train()
    for _ in range(steps):
        run._one_step()
    run.save()


@pytest.mark.parametrize("stage", STAGES)
def test_every_stage_trains_what_it_should(stage, scene, tmp_path, wdr):
    run = Run(stage_config(stage, scene, tmp_path / "run", wdr), ALONE, None)
    before = {name: value.clone() for name, value in run.stage.module.state_dict().items()}
    run.train()
    after = run.stage.module.state_dict()
    moved = {
        name.split(".")[0] + "." + name.split(".")[1]
        for name in before
        if not torch.equal(before[name], after[name])
    }
    if stage in ("counterfactual", "published"):
        assert isinstance(run.stage.module, ThreePaths)
        assert {"model.fpn", "model.fpn_pseudo", "model.head"} <= moved
        # The published fault: statistics of the frozen backbone drift, and the counterfactual pyramid stays.
        assert ("model.backbone" in moved) == (stage == "published")
        assert any(name.startswith("fpn.") for name in moved) == (stage == "counterfactual")
        assert run.feed.augment.draws == ("independent" if stage == "published" else "shared")
        assert run.feed.augment.labels == ("reference" if stage == "published" else "exact")
    else:
        assert {"backbone.init", "fpn.laterals", "head.pose"} <= moved
    net, card = load_model(tmp_path / "run" / MODEL)
    assert (card.mode, card.bits) == (
        {"8": ("I", 8), "3": ("III", 3)}[stage[4]] if "lsq" in stage else ("", 32)
    )
    assert any(isinstance(m, LsqConv2d) for m in net.modules()) == (stage == "lsq-3-III")
    assert next(h["config"]["run"]["stage"] for h in card.history) == "wdr"
    assert card.focal == pytest.approx(76.0)
    assert not any(name.startswith("head.surface") for name in net.state_dict())


def test_a_run_leaves_its_log_and_samples(scene, tmp_path):
    Run(config(scene, tmp_path / "run"), ALONE, None).train()
    with (tmp_path / "run/log.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [int(row["step"]) for row in rows] == [2, 4, 6, 6]
    assert all(float(row["loss"]) > 0 and float(row["img_s"]) > 0 for row in rows[:3])
    assert 0 <= float(rows[3]["add_0.5"]) <= 100
    assert [p.name for p in (tmp_path / "run/samples").iterdir()] == ["0000006.jpg"]
    assert list((tmp_path / "run/tensorboard").iterdir())


def test_an_existing_run_is_neither_overwritten_nor_resumed_otherwise(scene, tmp_path):
    mine = config(scene, tmp_path / "run", schedule={"steps": 2})
    with pytest.raises(ValueError, match="no checkpoint to resume"):
        Run(mine, ALONE, None, resume=True)
    Run(mine, ALONE, None).train()
    with pytest.raises(ValueError, match="add --resume"):
        Run(mine, ALONE, None)
    other = config(scene, tmp_path / "run", schedule={"steps": 2}, optimiser={"lr": 1e-3})
    with pytest.raises(ValueError, match=r"optimiser\.lr = 0\.002, not 0\.001"):
        Run(other, ALONE, None, resume=True)


def test_the_log_tells_what_loading_costs(scene, tmp_path, monkeypatch):
    """By a clock that only loading (9 s a step) and the optimiser (3 s) move."""
    now = 0.0
    update = Run._update

    def passing(seconds, work):
        def slow(*args, **kwargs):
            nonlocal now
            now += seconds
            return work(*args, **kwargs)

        return slow

    monkeypatch.setattr("macram.train.loop.time.monotonic", lambda: now)
    monkeypatch.setattr(Feed, "_batch", passing(9.0, Feed._batch))
    monkeypatch.setattr(Run, "_update", passing(3.0, update))
    Run(config(scene, tmp_path / "run"), ALONE, None).train()
    with (tmp_path / "run/log.csv").open() as file:
        shares = [float(row["loading"]) for row in csv.DictReader(file) if row["loading"]]
    assert shares == [75.0] * 3


@pytest.mark.parametrize(
    ("tables", "words"),
    [
        ({"data": {"validation": "held-out"}}, "no split 'held-out'; it has training, validation"),
        ({"network": {"image_size": 128}}, "frames of 64x64 pixels; set network.image_size to 64, not 128"),
    ],
)
def test_what_would_fail_at_the_end_fails_at_the_start(tables, words, scene, tmp_path):
    with pytest.raises(ValueError, match=words):
        Run(config(scene, tmp_path / "run", **tables), ALONE, None)
    assert not (tmp_path / "run").exists()


def test_an_empty_validation_split_is_named_before_training(scene, tmp_path):
    root = shutil.copytree(scene, tmp_path / "data")
    (root / "validation.txt").write_text("")
    with pytest.raises(ValueError, match=r"split validation has no frames; set data\.validation"):
        Run(config(root, tmp_path / "run"), ALONE, None)


def test_time_limit_ends_a_run_and_leaves_a_checkpoint(scene, tmp_path):
    mine = config(scene, tmp_path / "run", schedule={"steps": 10**6, "max_minutes": 0.02, "by_clock": True})
    run = Run(mine, ALONE, None)
    run.train()
    assert 0 < run.step < 10**6
    assert load_model(tmp_path / "run" / MODEL)[1].history[-1]["step"] == run.step


@pytest.mark.parametrize("free", [True, False])
def test_a_diverged_run_says_so_and_keeps_the_last_checkpoint(free, scene, tmp_path):
    run = Run(config(scene, tmp_path / "run", log={"every": 6}), ALONE, None)
    _stop_after(run, 1)
    before = (tmp_path / "run" / LAST).read_bytes()
    run.watch.free = free  # where looking is not free, it happens at the lines of the log and before saving
    weight, bad = run.stage.net.head.pose.weight, run._one_step

    def spoilt():
        if run.step == 2:
            with torch.no_grad():
                weight[0, 0] = float("nan")
        return bad()

    run._one_step = spoilt
    with pytest.raises(
        RuntimeError, match=r"step 3 has loss nan and gradient norm nan; .* lower optimiser\.lr"
    ):
        run.train()
    assert run.step == (2 if free else 6)
    with pytest.raises(RuntimeError, match="step 3 has"):
        run.save()
    assert (tmp_path / "run" / LAST).read_bytes() == before


def test_an_infinite_gradient_is_noticed_though_the_loss_is_a_number():
    watch = Watch(torch.device("cpu"))
    watch.note(1, torch.tensor(2.0), torch.tensor(1e30))
    with pytest.raises(RuntimeError, match="step 2 has loss 1 and gradient norm inf"):
        watch.note(2, torch.tensor(1.0), torch.tensor(float("inf")))


@pytest.mark.parametrize("stage", ["wdr", "counterfactual"])
def test_small_views_have_exact_gradients_in_mixed_precision(stage, scene, tmp_path, wdr):
    """At 32 x 32 pixels P6 and P7 read maps one column wide, the convolution that bfloat16 gets wrong."""
    run = Run(stage_config(stage, scene, tmp_path / "run", wdr), ALONE, None)
    tops = {m for m in run.stage.module.modules() if isinstance(m, PyramidTop) and m.p7.weight.requires_grad}
    made = []
    handles = [
        layer.register_forward_hook(lambda *args: made.append(args[2].dtype), prepend=True)
        for top in tops
        for layer in (top.p6, top.p7)
    ]
    run.stage.module.train()
    run.autocast = torch.autocast("cpu", torch.bfloat16)
    with exact_layers(run.stage.module, ALONE.device):
        run._one_step()
    for handle in handles:
        handle.remove()
    assert len(tops) == (3 if stage == "counterfactual" else 1)
    assert made.count(torch.float32) == len(made) >= 2 * len(tops)
    for top in tops:
        for layer in (top.p6, top.p7):
            assert torch.isfinite(layer.weight.grad).all()
            beside = layer.weight.grad.clone()
            beside[:, :, 1, 1] = 0
            assert not beside.any()  # these taps have seen nothing but padding


@pytest.fixture(scope="module")
def quantised(scene, wdr, tmp_path_factory):
    """A finished network of 3 bits in mode III."""
    out = tmp_path_factory.mktemp("quantised")
    return Run(stage_config("lsq-3-III", scene, out, wdr), ALONE, None).train()


@pytest.mark.parametrize(
    ("stage", "words", "bits"),
    [
        ("counterfactual", "is quantised already", 3),
        ("control", "is quantised already", 3),
        ("lsq", "has 3 bits in mode III already", 8),
    ],
)
def test_stages_refuse_unsuitable_checkpoints(stage, words, bits, scene, tmp_path, quantised):
    changes = {"run": {"init": str(quantised)}, "quant": {"bits": bits, "mode": "III"}}
    with pytest.raises(ValueError, match=words):
        Run(config(scene, tmp_path / "next", stage, **changes), ALONE, None)


def test_a_run_does_not_write_what_it_starts_from(scene, quantised):
    with pytest.raises(ValueError, match=r"run\.init is what the run writes; choose another run\.out"):
        Run(stage_config("lsq-3-III", scene, quantised.parent, quantised), ALONE, None, resume=True)


def test_a_quantised_network_is_trained_on_with_the_steps_it_has(scene, tmp_path, quantised):
    before, old = load_model(quantised)
    run = Run(stage_config("lsq-3-III", scene, tmp_path / "on", quantised), ALONE, None)
    state = run.stage.net.state_dict()
    assert all(torch.equal(state[name], value) for name, value in before.state_dict().items())
    run.train()
    after, card = load_model(tmp_path / "on" / MODEL)
    assert not torch.equal(after.head.pose.weight, before.head.pose.weight)
    assert (card.mode, card.bits) == ("III", 3)
    assert [h["config"]["run"]["stage"] for h in card.history] == ["wdr", "lsq", "lsq"]
    assert card.history[:2] == old.history
    _stop_after(Run(stage_config("lsq-3-III", scene, tmp_path / "parts", quantised), ALONE, None), 3)
    Run(stage_config("lsq-3-III", scene, tmp_path / "parts", quantised), ALONE, None, resume=True).train()
    resumed, whole = load_file(tmp_path / "parts" / MODEL), load_file(tmp_path / "on" / MODEL)
    assert all(torch.equal(resumed[key], value) for key, value in whole.items())


def test_commands_of_a_network_trained_on_name_what_it_started_from(scene, tmp_path, quantised, monkeypatch):
    monkeypatch.chdir(tmp_path)
    shutil.copy(quantised, "first.safetensors")
    path = Run(stage_config("lsq-3-III", scene, Path("on"), "first.safetensors"), ALONE, None).train()
    root = Path(__file__).resolve().parents[2] / "configs"
    files = [root / "train-quarter-wdr.toml", *(2 * [root / "train-quarter-w3a3.toml"])]
    commands = [record["command"] for record in stage_records(load_model(path)[1], files)]
    assert "--set run.init=first.safetensors --set run.out=on" in commands[2]
    assert not any("run.init" in command for command in commands[:2])


def taught(scene, out, init, teacher, **tables):
    quant = {"bits": 3, "mode": "III", "teacher": str(teacher)}
    return config(scene, out, "lsq", run={"init": str(init)}, quant=quant, **tables)


def distance(net, teacher, image):
    """How far the features that the head reads are from a teacher's, relative to these."""
    with torch.no_grad():
        pairs = zip(net.eval().features(image).direct, teacher.eval().features(image).direct, strict=True)
        return sum(((mine - goal).square().sum() / goal.square().sum()).item() for mine, goal in pairs)


def test_a_quantised_network_comes_to_imitate_its_teacher(scene, tmp_path, wdr):
    without_labels = {"classes": 0.0, "pose": 0.0, "imitation": 10.0}
    schedule = {"steps": 100, "batch": 4, "warmup": 2}
    imitating = Run(
        taught(scene, tmp_path / "on", wdr, wdr, schedule=schedule, loss=without_labels), ALONE, None
    )
    float_net, _ = load_model(wdr)
    image = imitating.feed.plain(8)
    before = distance(imitating.stage.net, float_net, image)
    path = imitating.train()
    assert distance(load_model(path)[0], float_net, image) < 0.8 * before
    # The teacher stays, statistics included.
    kept = imitating.stage.teacher.net.state_dict()
    assert all(torch.equal(kept[name], value) for name, value in float_net.state_dict().items())
    with (tmp_path / "on" / "log.csv").open(newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["loss"]]
    assert all(float(row["loss"]) == pytest.approx(float(row["imitation"]), rel=1e-4) for row in rows)


def test_an_imitating_run_resumes_bit_for_bit(scene, tmp_path, wdr):
    whole = Run(taught(scene, tmp_path / "whole", wdr, wdr), ALONE, None).train()
    parts = taught(scene, tmp_path / "parts", wdr, wdr)
    _stop_after(Run(parts, ALONE, None), 3)
    resumed = load_file(Run(parts, ALONE, None, resume=True).train())
    plain = load_file(Run(stage_config("lsq-3-III", scene, tmp_path / "plain", wdr), ALONE, None).train())
    assert all(torch.equal(resumed[name], value) for name, value in load_file(whole).items())
    assert not all(torch.equal(plain[name], value) for name, value in resumed.items())


def test_unsuitable_teachers_are_refused(scene, tmp_path, wdr, quantised):
    with pytest.raises(ValueError, match=r"is quantised; set quant\.teacher to a float network"):
        Run(taught(scene, tmp_path / "on", wdr, quantised), ALONE, None)
    with pytest.raises(ValueError, match=r"quant\.teacher is what the run writes"):
        Run(taught(scene, wdr.parent, quantised, wdr), ALONE, None, resume=True)
    other, card = load_model(wdr)
    elsewhere = tuple((x + 1, y, z) for x, y, z in card.keypoints)
    save_model(tmp_path / "other.safetensors", other, replace(card, target="other", keypoints=elsewhere))
    with pytest.raises(ValueError, match=r"other\.safetensors: has the keypoints of 'other'"):
        Run(taught(scene, tmp_path / "on", wdr, tmp_path / "other.safetensors"), ALONE, None)
    with pytest.raises(ValueError, match=r"none\.safetensors: no such checkpoint"):
        Run(taught(scene, tmp_path / "on", wdr, "none.safetensors"), ALONE, None)
    wide = Run(config(scene, tmp_path / "wide", network={"size": "eighth", "image_size": 64}), ALONE, None)
    wide.folder.mkdir()
    wide.save()
    with pytest.raises(ValueError, match=r"its pyramid has \d+ channels.*of the same size"):
        Run(taught(scene, tmp_path / "on", wdr, wide.folder / MODEL), ALONE, None)
    assert not (tmp_path / "on").exists()


def test_damaged_checkpoints_are_named(tmp_path, wdr):
    cut = tmp_path / "cut.safetensors"
    cut.write_bytes(wdr.read_bytes()[:-100])
    with pytest.raises(ValueError, match=r"cut\.safetensors: not a safetensors file"):
        load_model(cut)
    with pytest.raises(ValueError, match=r"none\.safetensors: no such checkpoint"):
        load_model(tmp_path / "none.safetensors")
    with pytest.raises(ValueError, match="is no network"):
        load_model(wdr.parent / LAST)


# ---- several processes ------------------------------------------------------------------------------

WORKER = """
import sys, torch
from macram.train.config import TrainConfig
from macram.train.distributed import join_processes, leave_processes
from macram.train.loop import Run
import json
torch.set_num_threads(1)
tables, out = json.loads(sys.argv[1]), sys.argv[2]
processes = join_processes("cpu")
for stage, table in tables.items():
    run = Run(TrainConfig.from_dict(table), processes, None)
    run.stage.module.train()
    gradients = []
    run.optimiser.step = lambda: gradients.append({run.names[p]: p.grad.clone() for p in run.names})
    run._one_step()
    buffers = {n: b for n, b in run.stage.module.state_dict().items() if "running" in n}
    torch.save((gradients[0], buffers), f"{out}/{stage}-{processes.rank}-{processes.world}.pt")
leave_processes()
"""


def test_two_processes_have_one_process_gradients(scene, tmp_path, wdr):
    """Of both kinds of stage, in the same processes: to start them is most of the time."""
    import json  # noqa: PLC0415

    tables = {}
    for stage in ("wdr", "counterfactual"):
        mine = stage_config(stage, scene, tmp_path / stage, wdr)
        optimiser, schedule = replace(mine.optimiser, clip=0.0), replace(mine.schedule, batch=5)
        tables[stage] = replace(mine, optimiser=optimiser, schedule=schedule).to_dict()
    script = tmp_path / "worker.py"
    script.write_text(WORKER)
    arguments = [str(script), json.dumps(tables), str(tmp_path)]
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "PYTHONPATH": str(Path(__file__).parents[2] / "sw")}
    torchrun = ["-m", "torch.distributed.run", "--standalone", "--nproc-per-node", "2"]
    for before in ([], torchrun):
        subprocess.run([sys.executable, *before, *arguments], env=environment, check=True, timeout=120)
    for stage, rank in product(tables, range(2)):
        one, statistics = torch.load(tmp_path / f"{stage}-0-1.pt")
        both, shared = torch.load(tmp_path / f"{stage}-{rank}-2.pt")
        assert both.keys() == one.keys()
        for name in one:
            # Sums in another order, through some twenty layers of float32.
            scale = one[name].abs().max()
            assert (both[name] - one[name]).abs().max() <= 1e-4 * scale + 1e-7, name
        for name in statistics:
            assert torch.allclose(shared[name], statistics[name], rtol=1e-5, atol=1e-6), name
