"""Packed networks are the networks they were made from; shipped ones are what the index says."""

from __future__ import annotations

import dataclasses
import shlex
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import torch

from macram.cli import main
from macram.cli.train_verb import overrides
from macram.model import SpaceNet, spacenet_config
from macram.quant import calibrate_batch_norm, calibrate_steps, lower_network, quantise
from macram.train.checkpoint import Card, load_model, read_tensors, save_model, save_packed, write_tensors
from macram.train.config import completed, load_config
from macram.train.packed import file_sizes
from macram.train.record import stage_records
from macram.weights import INDEX, role, sha256, shipped, weights_file

ROOT = Path(__file__).resolve().parents[2]
CONFIGS = ROOT / "configs"
LIMIT_BYTES = 25 * 1000 * 1000


def network(bits, mode="III"):
    """A calibrated network of random weights, as its training would leave it."""
    config = spacenet_config("tiny", "deployable", image_size=64, counterfactual=False)
    net = SpaceNet(config, torch.Generator().manual_seed(3)).eval()
    corners = tuple((float(x), float(y), float(z)) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1))
    card = Card(config, corners, 3.4, "box", True, 76.0)
    images = torch.randn(4, 3, 64, 64, generator=torch.Generator().manual_seed(4))
    calibrate_batch_norm(net, images)
    if mode:
        card = replace(card, mode=mode, bits=bits)
        net = quantise(net, mode, card.precision)
        calibrate_steps(net, images)
    return net, card


def assert_same(one, other):
    """Every field of two programs, arrays and types included."""
    assert type(one) is type(other)
    if dataclasses.is_dataclass(one):
        for field in dataclasses.fields(one):
            assert_same(getattr(one, field.name), getattr(other, field.name))
    elif isinstance(one, tuple):
        for left, right in zip(one, other, strict=True):
            assert_same(left, right)
    elif isinstance(one, np.ndarray):
        assert one.dtype == other.dtype
        assert np.array_equal(one, other)
    else:
        assert one == other


@pytest.mark.parametrize("bits", [3, 8])
def test_a_packed_network_is_deployed_to_the_same_program(bits, tmp_path):
    net, card = network(bits)
    with torch.no_grad():  # extremes: a code at either end, and a step below the smallest one
        first = net.head.classes
        first.weight[0, 0], first.weight[0, 1] = -1e6, 1e6
        net.head.pose.weight_quant.step.fill_(1e-12)
    save_model(tmp_path / "plain.safetensors", net, card)
    save_packed(tmp_path / "packed.safetensors", net, card)
    plain, _ = load_model(tmp_path / "plain.safetensors")
    packed, found = load_model(tmp_path / "packed.safetensors")
    assert found == replace(card, network=replace(card.network, surface=False))
    assert_same(lower_network(plain, 64, 96), lower_network(packed, 64, 96))
    image = torch.randn(1, 3, 64, 64, generator=torch.Generator().manual_seed(5))
    with torch.no_grad():
        for one, other in zip(plain(image), packed(image), strict=True):
            assert torch.equal(one.logits, other.logits)
            assert torch.equal(one.offsets, other.offsets)


@pytest.mark.parametrize("mode", ["I", "II"])
def test_what_a_mode_leaves_alone_stays_as_it_is(mode, tmp_path):
    net, card = network(3, mode)
    save_packed(tmp_path / "packed.safetensors", net, card)
    packed, _ = load_model(tmp_path / "packed.safetensors")
    assert torch.equal(packed.head.classes.weight, net.head.classes.weight)
    image = torch.randn(1, 3, 64, 64, generator=torch.Generator().manual_seed(6))
    with torch.no_grad():
        assert all(torch.equal(a.offsets, b.offsets) for a, b in zip(net(image), packed(image), strict=True))


def test_the_size_is_bits_times_weights(tmp_path):
    net, card = network(3)
    path = tmp_path / "packed.safetensors"
    save_packed(path, net, card)
    parameters = sum(p.numel() for p in net.parameters())
    sizes = file_sizes(path, parameters, 3)
    convs = [
        m.weight.numel() for n, m in net.named_modules() if isinstance(m, torch.nn.Conv2d) and "init" not in n
    ]
    assert sizes.codes == sum(-(-3 * count // 8) for count in convs)
    assert sizes.ideal == parameters * 3 / 8
    assert sizes.codes + sizes.floats + sizes.header == sizes.file == path.stat().st_size


def test_a_float_network_keeps_its_vectors(tmp_path):
    net, card = network(32, "")
    save_packed(tmp_path / "packed.safetensors", net, card)
    packed, _ = load_model(tmp_path / "packed.safetensors")
    assert torch.equal(packed.backbone.init.bn.running_var, net.backbone.init.bn.running_var)
    assert torch.equal(packed.head.pose.weight, net.head.pose.weight.half().float())


def test_a_weight_step_that_was_never_set_is_refused(tmp_path):
    net, card = network(3)
    with torch.no_grad():
        net.head.pose.weight_quant.step.fill_(float("nan"))
    with pytest.raises(ValueError, match=r"head\.pose: its step"):
        save_packed(tmp_path / "packed.safetensors", net, card)
    assert not list(tmp_path.iterdir())


def test_a_cut_code_stream_is_named(tmp_path):
    net, card = network(3)
    path = tmp_path / "packed.safetensors"
    save_packed(path, net, card)
    tensors, header = read_tensors(path)
    tensors["head.pose.weight"] = tensors["head.pose.weight"][:-1]
    write_tensors(path, tensors, {key: value for key, value in header.items() if key != "format"})
    with pytest.raises(ValueError, match=r"head\.pose\.weight.*bytes.*fetch it again"):
        load_model(path)


# ---- the shipped files --------------------------------------------------------------------------------


def test_shipped_files_are_what_the_index_says():
    networks = shipped()
    assert {"quarter-float", "quarter-w3a3", "quarter-w8a8"} <= networks.keys()
    assert sum(network.checked().stat().st_size for network in networks.values()) <= LIMIT_BYTES
    for network in networks.values():
        net, card = load_model(network.path)
        about = network.about
        assert (about["mode"], about["bits"]) == (card.mode, card.bits)
        assert (
            about["sizes"]
            == file_sizes(network.path, sum(p.numel() for p in net.parameters()), card.bits).to_dict()
        )
        assert about["scores"]["frames"] == 1000
        assert [stage["images"] for stage in about["stages"]] == [record["visits"] for record in card.history]


def test_the_demo_has_its_network():
    chosen = role("pose")
    assert chosen is not None
    assert chosen.about["mode"] == "III"


def test_recorded_commands_give_the_recorded_configuration():
    for network in shipped().values():
        _, card = load_model(network.path)
        for stage, record in zip(network.about["stages"], card.history, strict=True):
            words = shlex.split(stage["command"])
            config = load_config(ROOT / words[2], overrides(words[4::2])).to_dict()
            theirs = completed(record["config"])
            for table in (config, theirs):
                table["log"], table["run"]["out"], table["run"]["init"] = None, None, None
            assert config == theirs


def test_a_changed_file_is_one_clear_line(tmp_path, capsys, monkeypatch):
    place = tmp_path / "weights"
    place.mkdir()
    source = shipped()["quarter-w3a3"]
    (place / source.path.name).write_bytes(source.path.read_bytes()[:-1] + b"\0")
    (place / INDEX).write_text((source.path.parent / INDEX).read_text())
    monkeypatch.setattr("macram.weights.PLACES", (place,))
    picture = ROOT / "examples/frame_2.png"
    assert main(["predict", str(picture), "-o", str(tmp_path / "out"), "--weights", "quarter-w3a3"]) == 2
    error = capsys.readouterr().err
    assert "SHA-256" in error
    assert error.count("\n") == 1
    assert main(["predict", str(picture), "-o", str(tmp_path / "out"), "--weights", "quarter-w9"]) == 2
    assert "shipped: quarter-float, " in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_paths_win_over_names(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    shutil.copy(shipped()["quarter-w3a3"].path, "quarter-float")
    assert weights_file("quarter-float") == Path("quarter-float")
    assert weights_file("runs/a.safetensors") == Path("runs/a.safetensors")
    assert sha256(weights_file("quarter-w3a3")) == shipped()["quarter-w3a3"].about["sha256"]


def test_stages_need_their_configurations():
    _, card = load_model(shipped()["quarter-w3a3"].path)
    with pytest.raises(ValueError, match="2 stages; give as many"):
        stage_records(card, [CONFIGS / "train-quarter-w3a3.toml"])
    with pytest.raises(ValueError, match="is of stage lsq, the network's was wdr"):
        stage_records(card, [CONFIGS / "train-quarter-w3a3.toml"] * 2)
