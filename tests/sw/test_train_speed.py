"""What makes training on a CPU fast changes nothing but the time."""

from __future__ import annotations

import copy
import json

import pytest
import torch
from torch import nn
from train_scene import write_scene

from macram.cli.app import main
from macram.train.few_channels import VECTOR, WideBatchNorm2d, widen_batch_norm
from macram.train.narrow import NarrowConv2d, narrow_convolutions


def pair(channels, dtype, **settings):
    plain = nn.BatchNorm2d(channels, **settings)
    draw = torch.Generator().manual_seed(channels)
    with torch.no_grad():
        plain.weight.uniform_(-1, 2, generator=draw)  # negative slopes too
        plain.bias.normal_(generator=draw)
    plain.to(dtype)
    wide = copy.deepcopy(plain)
    widen_batch_norm(wide)
    return plain, wide


def outcome(layer, x, grad):
    x = x.clone().requires_grad_()
    y = layer(x)
    y.backward(grad)
    return y, x.grad, layer.weight.grad, layer.bias.grad, *layer.buffers()


@pytest.mark.parametrize("channels", [1, 2, 3, 4, 8])
@pytest.mark.parametrize("layout", [torch.channels_last, torch.contiguous_format])
def test_few_channels_are_normalised_as_by_pytorch(channels, layout):
    draw = torch.Generator().manual_seed(7)
    plain, wide = pair(channels, torch.float64)
    assert type(wide) is WideBatchNorm2d
    for side in (16, 8):  # running statistics follow over several batches
        height = side * (VECTOR // channels)
        x = (3 + 2 * torch.randn(2, channels, height, 6, generator=draw, dtype=torch.float64)).to(
            memory_format=layout
        )
        grad = torch.randn(x.shape, generator=draw, dtype=torch.float64)
        for ours, theirs in zip(outcome(wide, x, grad), outcome(plain, x, grad), strict=True):
            torch.testing.assert_close(ours, theirs, rtol=1e-11, atol=1e-11)
    assert wide.num_batches_tracked == 2


def test_mixed_precision_keeps_statistics_in_float32():
    draw = torch.Generator().manual_seed(3)
    plain, wide = pair(8, torch.float32)
    x = (50 + torch.randn(4, 8, 32, 32, generator=draw)).bfloat16().to(memory_format=torch.channels_last)
    grad = torch.randn(x.shape, generator=draw).bfloat16()
    ours, exact = outcome(wide, x, grad), outcome(plain.double(), x.double(), grad.double())
    assert ours[0].dtype == ours[1].dtype == torch.bfloat16
    for mine, true in zip(ours[:2], exact[:2], strict=True):  # rounded once or twice to 8 bits
        torch.testing.assert_close(mine.double(), true, rtol=2**-7, atol=2**-6)
    for mine, true in zip(ours[2:], exact[2:], strict=True):
        torch.testing.assert_close(mine.double(), true.double(), rtol=1e-4, atol=1e-3)


def test_other_layers_stay_as_they_are():
    plain, wide = pair(8, torch.float32)
    odd = torch.randn(1, 8, 3, 5, generator=torch.Generator().manual_seed(1))  # 15 pixels: no fours
    assert torch.equal(wide(odd), plain(odd))
    for layer in (plain, wide):
        layer.eval()
    even = torch.randn(1, 8, 4, 4, generator=torch.Generator().manual_seed(2))
    assert torch.equal(wide(even), plain(even))
    many = nn.Sequential(nn.BatchNorm2d(VECTOR), nn.GroupNorm(2, 8))
    widen_batch_norm(many)
    assert [type(layer) for layer in many] == [nn.BatchNorm2d, nn.GroupNorm]


def test_frozen_statistics_do_not_move():
    _, wide = pair(4, torch.float32)
    wide.track_running_stats = False
    before = copy.deepcopy(wide.state_dict())
    wide(torch.randn(2, 4, 8, 8, generator=torch.Generator().manual_seed(5)))
    assert all(torch.equal(value, before[name]) for name, value in wide.state_dict().items())


@pytest.mark.parametrize(("kernel", "bias"), [((3, 3), True), ((1, 5), False)])
@pytest.mark.parametrize("size", [(1, 1), (4, 7)])
def test_one_output_channel_is_convolved_as_by_pytorch(kernel, bias, size):
    draw = torch.Generator().manual_seed(6)
    plain = nn.Conv2d(5, 1, kernel, padding=tuple(k // 2 for k in kernel), bias=bias, dtype=torch.float64)
    narrow = copy.deepcopy(plain)
    narrow_convolutions(narrow)
    assert type(narrow) is NarrowConv2d
    x = torch.randn(3, 5, *size, generator=draw, dtype=torch.float64)
    results = []
    for layer in (plain, narrow):
        inner = x.clone().requires_grad_()
        y = layer(inner)
        y.square().sum().backward()
        results.append([y, inner.grad, *(p.grad for p in layer.parameters())])
    for mine, true in zip(*results, strict=True):
        torch.testing.assert_close(mine, true, rtol=1e-12, atol=1e-12)
    narrow.eval()
    assert torch.equal(narrow(x), plain(x))


@pytest.mark.parametrize(
    "other",
    [
        {"out_channels": 2},
        {"stride": 2},
        {"dilation": 2},
        {"padding": 0},
        {"padding_mode": "reflect"},
        {"kernel_size": 1, "padding": 0},
    ],
)
def test_other_convolutions_stay_as_they_are(other):
    layer = nn.Conv2d(**{"in_channels": 4, "out_channels": 1, "kernel_size": 3, "padding": 1} | other)
    narrow_convolutions(layer)
    assert type(layer) is nn.Conv2d


def test_bench_times_a_training_run(tmp_path, capsys):
    write_scene(tmp_path / "data")
    config = tmp_path / "run.toml"
    config.write_text(
        f"""
[run]
stage = "wdr"
out = "{tmp_path / "out"}"
[data]
root = "{tmp_path / "data"}"
cache = "{tmp_path / "cache"}"
[network]
size = "tiny"
image_size = 64
[schedule]
steps = 100
batch = 4
"""
    )
    command = ["bench", "--train", str(config), "--repeat", "1", "-o", str(tmp_path / "bench")]
    assert main([*command, "--set", "schedule.batch=2", "--side", "32"]) == 0
    report = json.loads((tmp_path / "bench" / "train.json").read_text())
    assert report["batch"] == 2
    assert report["compiled"] is True
    assert len(report["rates"]) == 5
    assert min(report["rates"]) <= report["images_per_second"] <= max(report["rates"])
    assert set(report["parts_ms"]) == {"views", "forward and backward", "optimiser"}
    assert 0 < report["loading_share"] < 1
    assert not (tmp_path / "out").exists()
    capsys.readouterr()
    assert main(["bench", "--set", "a=1"]) == 2
    assert "--set goes with --train" in capsys.readouterr().err
    assert main([*command, "--network", "tiny"]) == 2
    assert "choose one" in capsys.readouterr().err
