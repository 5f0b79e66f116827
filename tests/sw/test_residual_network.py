"""The residual sums of a whole network by the array's rule: the same codes as its program."""

from __future__ import annotations

import numpy as np
import pytest
import torch

from macram.model import SpaceNet, spacenet_config
from macram.quant import (
    Precision,
    calibrate_batch_norm,
    calibrate_steps,
    host_codes,
    lower_network,
    quantise,
    run_golden,
)
from macram.quant.program import AddOp, LookupOp


@pytest.fixture(scope="module")
def lowered():
    generator = torch.Generator().manual_seed(5)
    images = torch.randn((3, 3, 64, 96), generator=generator)
    net = SpaceNet(spacenet_config("tiny", "deployable"), generator)
    calibrate_batch_norm(net, images)
    net = quantise(net, "III", Precision())
    calibrate_steps(net, images)
    program = lower_network(net, 64, 96)
    return program, run_golden(program, host_codes(net.backbone, images[0]).numpy())


def test_every_sum_of_the_backbone(lowered):
    program, tensors = lowered
    sums = [op for op in program.ops if isinstance(op, AddOp) and op.name.startswith("stage")]
    assert len(sums) == 5
    for op in sums:
        reader = next(
            after for after in program.ops if isinstance(after, LookupOp) and after.source == op.name
        )
        total, codes = program.residual_rule(op.name).apply(tensors[op.branch], tensors[op.stream])
        np.testing.assert_array_equal(total, tensors[op.name])
        np.testing.assert_array_equal(codes, tensors[reader.name])
        assert len(np.unique(total)) > 2  # a constant would prove nothing


def test_what_has_no_rule(lowered):
    program, _ = lowered
    for name in ("stage1.entry", "fpn.p4.merged", "nothing"):
        with pytest.raises(ValueError, match=f"the program has no residual sum '{name}'"):
            program.residual_rule(name)
