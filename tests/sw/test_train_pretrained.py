"""Backbone weights from files in both namings, and the moving average of the weights."""

from __future__ import annotations

import copy
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import torch
from safetensors.torch import save_file

from macram.model import SpaceNet, spacenet_config
from macram.train.optimiser import Follower
from macram.train.pretrained import load_backbone

STAGES = (1, 2, 0, 1, 3)


def network(seed=0):
    config = spacenet_config("tiny", counterfactual=False)
    config = replace(config, backbone=replace(config.backbone, stages=STAGES))
    return SpaceNet(config, torch.Generator().manual_seed(seed))


def foreign(seed=5):
    """A DarkNet of tiny's widths as pytorchcv stores it, written down from its own layout, classifier too."""
    draw = torch.Generator().manual_seed(seed)
    tensors = {}

    def block(name, c_in, c_out, kernel):
        tensors[f"{name}.conv.weight"] = torch.randn(c_out, c_in, kernel, kernel, generator=draw)
        for part in ("weight", "bias", "running_mean", "running_var"):
            tensors[f"{name}.bn.{part}"] = torch.rand(c_out, generator=draw)

    block("features.init_block", 3, 4, 3)
    for stage, units in enumerate(STAGES, 1):
        c = 4 << stage
        block(f"features.stage{stage}.unit1", c // 2, c, 3)
        for unit in range(2, units + 2):
            block(f"features.stage{stage}.unit{unit}.conv1", c, c // 2, 1)
            block(f"features.stage{stage}.unit{unit}.conv2", c // 2, c, 3)
    tensors["output.weight"], tensors["output.bias"] = torch.zeros(1000, 128), torch.zeros(1000)
    return tensors


def saved(path, tensors):
    if path.suffix == ".safetensors":
        save_file(tensors, path)
    else:
        torch.save(tensors, path)
    return path


@pytest.mark.parametrize("name", ["darknet53.pth", "darknet53.safetensors"])
def test_pytorchcv_weights_reach_their_places(tmp_path, name):
    net, tensors = network(), foreign()
    load_backbone(net, saved(tmp_path / name, tensors))
    backbone = net.backbone
    for mine, theirs in (
        (backbone.init, "init_block"),
        (backbone.stages[0].entry, "stage1.unit1"),
        (backbone.stages[1].units[1].reduce, "stage2.unit3.conv1"),
        (backbone.stages[4].units[2].expand, "stage5.unit4.conv2"),
    ):
        assert torch.equal(mine.conv.weight, tensors[f"features.{theirs}.conv.weight"])
        for part in ("weight", "bias", "running_mean", "running_var"):
            assert torch.equal(getattr(mine.bn, part), tensors[f"features.{theirs}.bn.{part}"])
    loaded = {k: v for k, v in backbone.state_dict().items() if not k.endswith("num_batches_tracked")}
    # By order, which both layouts share: every tensor arrived, and nowhere else.
    for mine, theirs in zip(loaded.values(), tensors.values(), strict=False):
        assert torch.equal(mine, theirs)
    assert len(loaded) == len(tensors) - 2


def listed():
    """Names and shapes of pytorchcv's state dict and, from it, the mean magnitude of every stage's output."""
    lines = (Path(__file__).parent / "pytorchcv_darknet53.txt").read_text().splitlines()
    rows = [line.split() for line in lines if line and not line.startswith("#")]
    shapes = {name: tuple(map(int, size)) for name, *size in rows if not name.startswith("stage")}
    return shapes, [float(row[1]) for row in rows if row[0].startswith("stage")]


def filled(shapes):
    """Weights that any NumPy draws alike, scaled so that signals neither vanish nor explode."""
    rng = np.random.default_rng(53)
    tensors = {}
    for name, shape in shapes.items():
        values = rng.standard_normal(shape, np.float32)
        if name.endswith(("running_var", "bn.weight")):
            values = 0.5 + 0.5 * abs(values)
        if values.ndim == 4:
            values *= values[0].size ** -0.5
        counter = name.endswith("num_batches_tracked")
        tensors[name] = torch.tensor(3) if counter else torch.from_numpy(np.asarray(values))
    return tensors


def picture():
    return torch.from_numpy(np.random.default_rng(7).standard_normal((1, 3, 64, 96)))


def test_the_real_pytorchcv_file_gives_the_real_outputs(tmp_path):
    """Its names, its shapes, its forward pass: what pytorchcv itself computed stands in the list."""
    shapes, magnitudes = listed()
    assert len(shapes) == 314
    net = SpaceNet(spacenet_config("paper", counterfactual=False), torch.Generator())
    load_backbone(net, saved(tmp_path / "darknet53.pth", filled(shapes)))
    assert int(net.backbone.init.bn.num_batches_tracked) == 3
    with torch.no_grad():
        maps = net.eval().double().backbone(picture())
    assert [float(m.abs().mean()) for m in maps] == pytest.approx(magnitudes, rel=1e-9)


@pytest.mark.parametrize("prefix", ["", "backbone."])
def test_own_names(tmp_path, prefix):
    net, other = network(0), network(1)
    state = {prefix + name: value for name, value in other.backbone.state_dict().items()}
    load_backbone(net, saved(tmp_path / "own.safetensors", state))
    for name, value in net.backbone.state_dict().items():
        assert torch.equal(value, other.backbone.state_dict()[name])


def changed(**tensors):
    return {name: v for name, v in {**foreign(), **tensors}.items() if v is not None}


@pytest.mark.parametrize(
    ("tensors", "message"),
    [
        (
            changed(**{"features.stage2.unit2.conv1.bn.bias": None}),
            "stages.1.units.0.reduce.bn.bias.*missing",
        ),
        (
            changed(**{"features.init_block.conv.weight": torch.zeros(8, 3, 3, 3)}),
            r"\[4, 3, 3, 3\], not \[8, 3",
        ),
        (changed(**{"features.stage3.unit2.conv1.conv.weight": torch.zeros(1)}), "stages.2.units.0.*unknown"),
        (changed(**{"features.stage1.unit2.conv.weight": torch.zeros(1)}), "unit2.conv.weight.*unknown"),
        (changed(**{"features.stage1.unit1.conv1.bn.bias": torch.zeros(1)}), "unit1.conv1.*unknown"),
        (changed(**{"features.squeeze.weight": torch.zeros(1)}), "squeeze.*unknown"),
        ({"state_dict": foreign()}, "tensors by name"),
        ([1], "not a state dict"),
    ],
)
def test_another_network_is_refused_whole(tmp_path, tensors, message):
    net = network()
    before = copy.deepcopy(net.state_dict())
    with pytest.raises(ValueError, match=message) as error:
        load_backbone(net, saved(tmp_path / "w.pth", tensors))
    assert "\n" not in str(error.value)
    assert "w.pth" in str(error.value)
    for name, value in net.state_dict().items():
        assert torch.equal(value, before[name])


@pytest.mark.parametrize("name", ["w.pth", "w.safetensors"])
@pytest.mark.parametrize("content", [None, b"", b"rubbish"])
def test_unreadable_file(tmp_path, name, content):
    path = tmp_path / name
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(ValueError, match=name) as error:
        load_backbone(network(), path)
    assert "\n" not in str(error.value)


def test_average_follows_weights_statistics_and_counts():
    net = network()
    average = copy.deepcopy(net)
    follower = Follower(average, net)
    start = {name: value.clone() for name, value in net.state_dict().items()}
    net.load_state_dict(network(1).state_dict())  # in place, as a resumed run does
    net.backbone.init.bn.running_mean.fill_(2.0)
    net.backbone.init.bn.num_batches_tracked.fill_(7)
    follower.follow(0.75, 10**6)
    for name, value in average.state_dict().items():
        now = net.state_dict()[name]
        assert torch.equal(value, torch.lerp(start[name], now, 0.25) if now.is_floating_point() else now)
    assert average.backbone.init.bn.running_mean[0] == 0.5
    follower.follow(0.75, 1)  # young: two elevenths stay
    assert average.backbone.init.bn.running_mean[0] == pytest.approx(2 - 1.5 * 2 / 11)
