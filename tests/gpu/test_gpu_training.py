"""A training step on a GPU against the same step without graphs, and its kernels against float64."""

from __future__ import annotations

import pytest
import torch
from torch.nn import functional
from train_scene import write_scene

from macram.quant import LsqQuantizer
from macram.quant import lsq as lsq_module
from macram.spec import IntFormat
from macram.train import norm_relu_gpu
from macram.train.config import TrainConfig
from macram.train.distributed import Processes
from macram.train.loop import MODEL, Run
from macram.train.replay import PLAIN_STEPS

GPU = torch.device("cuda", 0)
SCENE_FRAMES = (8, 4)


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    return write_scene(tmp_path_factory.mktemp("scene") / "data", SCENE_FRAMES)


def run_of(scene, out, stage="wdr", **run):
    return Run(
        TrainConfig.from_dict(
            {
                "run": {"stage": stage, "out": str(out), **run},
                "data": {"root": str(scene), "cache": str(scene.parent / "cache")},
                "network": {"size": "tiny", "image_size": 64, "surface": stage == "wdr"},
                "optimiser": {"kind": "adamw", "lr": 1e-3, "average": 0.9},
                "schedule": {"steps": 3 * PLAIN_STEPS, "batch": 4, "warmup": 0},
                "crops": [{"until": 0.5, "sizes": [32, 0]}, {"until": 1, "sizes": [0]}],
                "quant": {"calibration": 4},
                "log": {"every": 1, "evaluate_frames": 2},
            }
        ),
        Processes(0, 1, GPU),
        None,
    )


@pytest.fixture(scope="module")
def wdr(scene, tmp_path_factory):
    out = tmp_path_factory.mktemp("wdr")
    run_of(scene, out).train()
    return str(out / MODEL)


@pytest.mark.parametrize("stage", ["wdr", "control", "counterfactual", "lsq"])
def test_a_replayed_step_is_the_step_itself(stage, scene, tmp_path, wdr):
    init = {} if stage == "wdr" else {"init": wdr}
    run = run_of(scene, tmp_path / "run", stage, **init)
    run.stage.module.train()
    state = {name: value.clone() for name, value in run.stage.module.state_dict().items()}
    batch, cells, _ = run._next_batch(4, 0.9)
    results = []
    for _ in range(PLAIN_STEPS + 2):
        run.stage.module.load_state_dict(state)
        losses = run._gradients(batch, cells, 4, surface=False)
        gradients = {name: p.grad.clone() for p, name in run.names.items() if p.grad is not None}
        statistics = {name: value.clone() for name, value in run.stage.module.state_dict().items()}
        results.append((losses, gradients, statistics))
    assert len(run.replay.recorded) == 1
    first, last = results[0], results[-1]
    for one, other in zip(first, last, strict=True):
        assert one.keys() == other.keys()
        for name in one:
            torch.testing.assert_close(one[name], other[name], rtol=1e-3, atol=1e-5)


def test_runs_with_and_without_graphs_learn_the_same(scene, tmp_path):
    with_graphs, without = run_of(scene, tmp_path / "a"), run_of(scene, tmp_path / "b", graphs=False)
    for run in (with_graphs, without):
        run.train()
    assert with_graphs.replay.recorded
    assert without.replay is None
    for one, other in zip(with_graphs.names, without.names, strict=True):
        torch.testing.assert_close(one, other, rtol=1e-2, atol=1e-3)


@pytest.mark.parametrize("dtype", [torch.float32, torch.bfloat16])
@pytest.mark.parametrize(
    "shape", [(2, 4, 33, 17), (3, 64, 4, 4), (2, 256, 3, 2), (5, 8, 64, 64), (2, 16, 1, 1)]
)
def test_norm_and_relu_are_those_of_float64(shape, dtype):
    generator = torch.Generator(GPU).manual_seed(3)

    def normal(*size):
        return torch.randn(size, device=GPU, generator=generator)

    channels = shape[1]
    x = (normal(*shape) * 2 + normal(1, channels, 1, 1) * 5).to(dtype)
    x = x.contiguous(memory_format=torch.channels_last)
    grad = normal(*shape).to(dtype).contiguous(memory_format=torch.channels_last)
    weight, bias = normal(channels).abs() + 0.5, normal(channels)
    y, stats = norm_relu_gpu.forward(x, weight, bias, 1e-5)
    found = (y, stats[0], stats[1], *norm_relu_gpu.backward(grad, x, weight, stats, 1e-5))

    exact = [value.double().requires_grad_() for value in (x, weight, bias)]
    wanted = torch.relu(functional.batch_norm(exact[0], None, None, *exact[1:], training=True, eps=1e-5))
    wanted.backward(grad.double())
    mean, variance = x.double().mean((0, 2, 3)), x.double().var((0, 2, 3), unbiased=False)
    bound = 1e-2 if dtype == torch.bfloat16 else 1e-3
    for one, other in zip(found, (wanted, mean, variance, *(e.grad for e in exact)), strict=True):
        assert (one.double() - other).norm() <= bound * other.norm() + 1e-6


@pytest.mark.parametrize("code_format", [IntFormat(3), IntFormat(3, signed=True), IntFormat(8)])
@pytest.mark.parametrize("shape", [(4, 8, 32, 32), (2, 4, 1, 1), (3, 5, 7, 9)])
def test_quantising_in_one_pass_is_quantising(code_format, shape, monkeypatch):
    generator = torch.Generator(GPU).manual_seed(5)
    value = torch.randn(shape, device=GPU, generator=generator).contiguous(memory_format=torch.channels_last)
    grad = torch.randn(shape, device=GPU, generator=generator)
    results = []
    for served in (True, False):
        if not served:
            monkeypatch.setattr(lsq_module, "has_one_pass", lambda map_: False)
        quantizer = LsqQuantizer(code_format, batched=True).to(GPU)
        quantizer.set_step(value.abs().mean())
        leaf = value.clone().requires_grad_()
        result = quantizer(leaf * 1.0)
        result.backward(grad)
        results.append((result, leaf.grad, quantizer.step.grad))
    for one, other in zip(*results, strict=True):
        torch.testing.assert_close(one, other, rtol=1e-4, atol=1e-4)
