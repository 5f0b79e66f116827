"""What may be recorded as a CUDA graph: steps that never look at a value. Seen on the CPU, without a GPU."""

from __future__ import annotations

from contextlib import contextmanager

import pytest
import torch
from torch.overrides import TorchFunctionMode
from torch.utils._python_dispatch import TorchDispatchMode
from train_scene import write_scene

from macram.train.config import TrainConfig
from macram.train.distributed import Processes
from macram.train.loop import MODEL, Run

ALONE = Processes(0, 1, torch.device("cpu"))
WAITING = {
    "aten::_local_scalar_dense": "reads a value",
    "aten::is_nonzero": "reads a value",
    "aten::nonzero": "has a shape that depends on values",
    "aten::masked_select": "has a shape that depends on values",
    "aten::unique2": "has a shape that depends on values",
    "aten::linalg_inv_ex": "checks for singular matrices",
    "aten::lift_fresh": "brings a number from the host",
}


class NoWaiting(TorchDispatchMode):
    """Refuses every operation for which a GPU would wait for its host, or the host for it."""

    def __torch_dispatch__(self, func, types, args=(), kwargs=None):
        name = func.name().split(".")[0]
        reason = WAITING.get(name)
        if name == "aten::index" and any(
            i is not None and i.dtype in {torch.bool, torch.uint8} for i in args[1]
        ):
            reason = "has a shape that depends on values"
        if reason:
            raise AssertionError(f"{func} {reason}")
        return func(*args, **(kwargs or {}))


class NoNumbers(TorchFunctionMode):
    """Refuses `torch.where` with a number, which PyTorch copies to a GPU and waits for."""

    def __torch_function__(self, func, types, args=(), kwargs=None):
        if func in {torch.where, torch.Tensor.where} and any(isinstance(a, int | float) for a in args):
            raise AssertionError(f"{func.__name__} brings a number from the host")
        return func(*args, **(kwargs or {}))


@contextmanager
def no_waiting():
    with NoWaiting(), NoNumbers():
        yield


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    return write_scene(tmp_path_factory.mktemp("scene") / "data")


def run_of(scene, out, stage="wdr", **tables):
    table = {
        "run": {"stage": stage, "out": str(out), "precision": "fp32"},
        "data": {"root": str(scene), "cache": str(scene.parent / "cache")},
        "network": {"size": "tiny", "image_size": 64, "surface": stage == "wdr"},
        "optimiser": {"kind": "adamw", "lr": 1e-3},
        "schedule": {"steps": 2, "batch": 4, "warmup": 0},
        "quant": {"calibration": 4},
        "log": {"evaluate_frames": 2},
    }
    for name, values in tables.items():
        table[name] = {**table[name], **values}
    return Run(TrainConfig.from_dict(table), ALONE, None)


@pytest.fixture(scope="module")
def wdr(scene, tmp_path_factory):
    out = tmp_path_factory.mktemp("wdr")
    run_of(scene, out).train()
    return str(out / MODEL)


FAULTS = ["dead_top", "drifting_statistics", "untrained_counterfactual", "misaligned_warp", "refitted_poses"]


@pytest.mark.parametrize(
    ("stage", "tables"),
    [
        ("wdr", {}),
        ("wdr", {"network": {"variant": "corrected"}}),
        ("wdr", {"network": {"variant": "published"}}),
        ("control", {}),
        ("counterfactual", {}),
        ("counterfactual", {"network": {"faults": FAULTS}}),
        ("lsq", {"quant": {"bits": 3, "mode": "III"}}),
        ("lsq", {"quant": {"bits": 8, "mode": "I"}}),
        ("lsq", {"quant": {"bits": 3, "mode": "III", "teacher": "wdr"}}),
    ],
)
def test_forward_losses_and_backward_never_look_at_a_value(stage, tables, scene, tmp_path, wdr):
    if stage != "wdr":
        tables = {**tables, "run": {"init": wdr}}
    if taught := tables.get("quant", {}).get("teacher") == "wdr":
        tables = {**tables, "quant": {**tables["quant"], "teacher": wdr}}
    run = run_of(scene, tmp_path / "run", stage, **tables)
    run.stage.module.train()
    batch, cells, _ = run._next_batch(4, 0.0)
    assert bool(batch.inside.any())
    with no_waiting():
        losses = run._backward(batch, cells, 4, stage == "wdr")
    assert all(torch.isfinite(value) and not value.requires_grad for value in losses.values())
    assert ("surface" in losses) == (stage == "wdr")
    assert ("imitation" in losses) == taught
    assert any(p.grad is not None for p in run.names)


def test_the_watch_never_looks_either_where_looking_costs():
    from macram.train.watch import Watch  # noqa: PLC0415

    watch = Watch(torch.device("cpu"))
    watch.free = False
    values = torch.tensor([1.0, torch.nan, 3.0]).unbind()
    with no_waiting():
        for step, value in enumerate(values, 1):
            watch.note(step, value, value)
    with pytest.raises(RuntimeError, match="step 2 has loss nan"):
        watch.check()
