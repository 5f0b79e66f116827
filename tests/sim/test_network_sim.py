"""A tiny network on a tiny simulated array: by the command shape by shape, and whole, layer behind layer."""

from __future__ import annotations

import dataclasses
import json
import threading
from pathlib import Path

import numpy as np
import pytest
import torch

from macram.cli import main
from macram.model import SpaceNet, spacenet_config
from macram.model.backbone import BackboneConfig
from macram.network.on_array import ArrayNetwork, differences
from macram.quant import (
    DeployedNetwork,
    Precision,
    calibrate_batch_norm,
    calibrate_steps,
    host_codes,
    lower_network,
    quantise,
)
from macram.quant.program import ConvOp, Program
from macram.spec import ArrayConfig

CONFIG = Path(__file__).parents[2] / "configs" / "tiny-blocks.toml"
TINY = ArrayConfig.from_toml(CONFIG)


def test_the_command_goes_on_and_notices(toolchain, tmp_path, capsys):
    """Two shapes, then a third; nothing is simulated twice; one number changed on the way is red."""
    out = tmp_path / "out"
    command = ["network", str(CONFIG), "--size", "tiny", "--side", "32", "-o", str(out)]
    only = ["--only", "16-16-4x4-3x3-1", "--only", "16-1-4x4-", "--only", "8-16-16x16-3x3-2"]
    records = out / "shapes"
    assert main([*command, *only, "--limit", "2"]) == 0
    first = {path: path.stat().st_mtime_ns for path in records.iterdir()}
    assert main([*command, *only]) == 0
    after = {path: path.stat().st_mtime_ns for path in records.iterdir()}
    assert (len(first), len(after)) == (2, 3)
    assert first.items() <= after.items()
    said = capsys.readouterr().out
    assert said.count("cycles estimated") == 3 + 2, "a line each, and two summaries"
    table = json.loads((out / "network.json").read_text())
    done = [row for row in table["shapes"] if row["passed"] is not None]
    assert len(done) == 3
    assert [row["cycles"] for row in done] == [row["estimated"] for row in done]
    assert sum(row["mismatches"] for row in done) == 0 < min(row["compared"] for row in done)

    path = next(iter(after))
    record = json.loads(path.read_text())
    counters = record["counters"] | {
        name: record["counters"][name] + 1 for name in ("cycles", "drain_cycles")
    }
    path.write_text(json.dumps(record | {"counters": counters}))
    assert main([*command, "--limit", "0"]) == 1
    assert "FAILED: cycles differ" in capsys.readouterr().out


# ---- a whole network, each layer fed by the one before -------------------------------------------------------


@pytest.fixture(scope="module")
def deployed():
    """Program, input and the deployed network's tensors: all kinds of convolution, signed codes and sums."""
    draw = torch.Generator().manual_seed(3)
    config = dataclasses.replace(
        spacenet_config("tiny", "deployable"),
        backbone=BackboneConfig(1 / 16, (1, 1, 1, 1, 1), "relu"),
        pyramid=8,
        tower=1,
        counterfactual=False,
    )
    model = SpaceNet(config, draw)
    pictures = torch.randn((4, 3, 64, 64), generator=draw)
    calibrate_batch_norm(model, pictures)
    net = quantise(model, "III", Precision())
    calibrate_steps(net, pictures)
    whole = lower_network(net, 32, 32)
    codes = host_codes(net.backbone, torch.randn((3, 32, 32), generator=draw))
    # The head of one level stands for those of all five.
    ops = tuple(
        op for op in whole.ops if not op.name.startswith("head.") or op.name.startswith("head.p3.class")
    )
    program = Program(whole.input, whole.input_format, whole.input_shape, ops)
    tensors = {name: tensor.numpy() for name, tensor in DeployedNetwork(program)(codes).items()}
    return program, codes, tensors


def test_a_network_on_the_array_is_the_deployed_one(toolchain, tmp_path, deployed):
    """Stopped behind its 14th convolution it goes on there; every tensor is equal, every exact cycle as foretold."""
    program, codes, tensors = deployed
    told = []

    def tell(done, share):
        assert 0 <= share <= 1
        if told[-1:] != [done]:
            told.append(done)

    def stop(done, share):
        tell(done, share)
        if done == 14 and threading.current_thread() is threading.main_thread():
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        ArrayNetwork(program, TINY, tmp_path, "design", stop).run(codes.numpy())
    assert [done for done in told if done] == list(range(1, 15))
    kept = {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*.npz")}
    assert len(kept) == 14
    told.clear()
    network = ArrayNetwork(program, TINY, tmp_path, "design", tell)
    sums = network.accumulators(codes)
    assert {path: path.stat().st_mtime_ns for path in kept} == kept
    assert told == list(range(1, len(network.steps) + 1))
    assert list(network.tensors) != list(tensors)  # in another order
    assert network.tensors.keys() == tensors.keys()
    for name, tensor in tensors.items():
        np.testing.assert_array_equal(network.tensors[name], tensor, err_msg=name)
    np.testing.assert_array_equal(sums["head.p3.class"].numpy(), tensors["head.p3.class"])
    rows = differences(network, tensors)
    assert sum(row["mismatches"] for row in rows) == 0
    assert {(row["input"], row["sums"]) for row in rows} == {
        ("u3", False),
        ("u3", True),
        ("s3", False),
        ("s3", True),
    }
    for row in rows:
        assert row["cycles"] == row["estimated"] or not row["exact"], row
        assert row["elapsed"] > row["cycles"]


def test_one_weight_is_seen(toolchain, tmp_path, deployed):
    """One weight of the last convolution that gives codes is changed: it alone differs."""
    program, _, tensors = deployed
    place, conv = next((i, op) for i, op in enumerate(program.ops) if op.name == "head.p3.class.conv2.input")
    weights = conv.weights.copy()
    weights[0, 0, 1, 1] = -4 if weights[0, 0, 1, 1] >= 0 else 3
    ops = list(program.ops)
    ops[place] = dataclasses.replace(conv, weights=weights)
    assert isinstance(conv, ConvOp)
    before = tuple(op for op in ops[:place] if op.name == conv.source)
    given = before[0].source
    shape = tensors[given].shape
    part = Program(given, tensors_format(program, given), shape, (*before, ops[place]))
    network = ArrayNetwork(part, TINY, tmp_path, "design")
    network.run(tensors[given])
    (row,) = differences(network, tensors)
    assert row["mismatches"] > 0


def tensors_format(program, name):
    """Codes of a tensor that a convolution made."""
    return next(op.spec.output for op in program.ops if op.name == name)
