"""The whole deployable network on rendered pictures: golden = PyTorch integers, tensor by tensor."""

from __future__ import annotations

import numpy as np
import pytest
import torch

from macram.data.render.plan import View
from macram.data.render.sequence import render_sequence
from macram.front.image import normalise
from macram.model import SpaceNet, spacenet_config
from macram.quant import (
    DeployedNetwork,
    Precision,
    calibrate_batch_norm,
    calibrate_steps,
    differing_shares,
    host_codes,
    lower_network,
    quantise,
    run_golden,
    training_codes,
)
from macram.quant.convert import LsqConv2d
from macram.quant.network import QuantConv
from macram.quant.program import AccumulateOp, ConvOp

SEED = 2022
HEIGHT, WIDTH = 128, 160
LEVELS = 5


def rendered(sequence):
    """One picture of the renderer, normalised as the network wants it: ``[3, HEIGHT, WIDTH]``."""
    view = View(WIDTH, HEIGHT, 190.0)
    (frame,) = render_sequence((SEED, 0, sequence), 1, view, (1.5, 3.0), background=False)
    assert frame.mask.sum() > 200, "the target must be in the picture"
    return normalise(frame.image)


@pytest.fixture(scope="module")
def network():
    pictures = torch.stack([rendered(0), rendered(1)])
    model = SpaceNet(spacenet_config("quarter", "deployable"), torch.Generator().manual_seed(SEED))
    calibrate_batch_norm(model, pictures)
    net = quantise(model, "III", Precision())
    calibrate_steps(net, pictures)
    return net, lower_network(net, HEIGHT, WIDTH), pictures


@pytest.fixture(scope="module", params=[0, 1])
def passed(request, network):
    net, program, pictures = network
    picture = pictures[request.param]
    codes = host_codes(net.backbone, picture)
    return picture, codes, DeployedNetwork(program)(codes)


def test_golden_equals_torch_on_every_tensor_of_a_picture(network, passed):
    _, program, _ = network
    _, codes, tensors = passed
    golden = run_golden(program, codes.numpy())
    assert list(golden) == list(tensors) == [program.input, *(op.name for op in program.ops)]
    for name, wanted in golden.items():
        assert np.array_equal(tensors[name].numpy(), wanted), name
        if wanted.size >= 256:
            assert len(np.unique(wanted)) > 1, name  # a constant would prove nothing


def test_every_convolution_of_the_network_is_an_integer_layer(network):
    net, program, _ = network
    layers = [op for op in program.ops if isinstance(op, ConvOp | AccumulateOp)]
    quantised = {n: m for n, m in net.named_modules() if isinstance(m, LsqConv2d | QuantConv)}
    head = [name for name in quantised if name.startswith("head.")]
    # The head's convolutions run once per pyramid level, all others once per picture.
    assert len(layers) == len(quantised) + (LEVELS - 1) * len(head)
    assert all(op.spec.weight.bits == op.spec.input.bits == 3 for op in layers)


def test_the_report_of_differing_shares_has_an_entry_per_layer(network, passed):
    net, program, _ = network
    picture, _, tensors = passed
    training = training_codes(net, picture, program)
    shares = differing_shares(training, {name: tensors[name].numpy() for name in training})
    rounded = {op.name for op in program.ops if not isinstance(op, AccumulateOp)}
    assert set(shares) == rounded | {program.input}
    assert shares[program.input] == 0  # made by the same float32 code on both sides
    assert all(0 <= share <= 1 for share in shares.values())
    # Float32 against exact rounding: where the two first part, single codes next to a threshold do. What one code
    # makes of the later layers says nothing about them: a network without training amplifies it.
    first = next((name for name, share in shares.items() if share), None)
    if first is not None:
        assert shares[first] < 0.005, first
        assert np.abs(training[first] - tensors[first].numpy()).max() == 1, first
