"""LSQ modes on the whole network, and the deployable one as integers: golden = PyTorch on every tensor."""

from __future__ import annotations

import copy
from dataclasses import replace

import numpy as np
import pytest
import torch
from torch import nn

from macram.model import SpaceNet, ThreePaths, spacenet_config
from macram.quant import (
    DeployedNetwork,
    LsqConv2d,
    LsqQuantizer,
    Precision,
    calibrate_batch_norm,
    calibrate_steps,
    differing_shares,
    host_codes,
    host_predictions,
    layer_differences,
    lower_network,
    quantise,
    run_golden,
    training_codes,
)
from macram.quant.deploy import _Table
from macram.quant.lower import code_table
from macram.quant.network import QuantConv
from macram.quant.program import AccumulateOp, AddOp, LookupOp, Program
from macram.spec import ConvSpec, IntFormat

THREE = Precision()
EIGHT = Precision(IntFormat(8, signed=True), IntFormat(8), IntFormat(8))


def generator(seed=0):
    return torch.Generator().manual_seed(seed)


def images(n=2, height=64, width=96, seed=1):
    return torch.randn((n, 3, height, width), generator=generator(seed))


def trained(variant="deployable", seed=0, **fields):
    """A network whose parameters all matter: signs of gamma mixed, biases and level scales not trivial."""
    model = SpaceNet(spacenet_config("tiny", variant, **fields), generator(seed))
    source = generator(seed + 100)
    with torch.no_grad():
        for name, p in model.named_parameters():
            if p.ndim == 1:
                p.copy_(torch.randn(p.shape, generator=source) * (0.02 if name.endswith("bias") else 1.0))
    calibrate_batch_norm(model, images(4))
    return model


def quantised_convs(net):
    return {n: m for n, m in net.named_modules() if isinstance(m, LsqConv2d | QuantConv)}


@pytest.mark.parametrize("variant", ["published", "deployable"])
def test_modes_quantise_51_65_and_75_convolutions(variant):
    config = spacenet_config("eighth", variant)
    model = SpaceNet(config, generator())
    own_top = 2 if variant == "deployable" else 0  # the published pyramids share it
    for mode, count in (("I", 51), ("II", 65 + own_top), ("III", 75 + own_top)):
        net = quantise(model, mode, THREE)
        convs = quantised_convs(net)
        assert len(convs) == count
        steps = [m for conv in convs.values() for m in conv.children() if isinstance(m, LsqQuantizer)]
        assert len(steps) == 2 * count
        assert type(net.backbone.init.conv) is nn.Conv2d  # float32 in every mode
        if variant == "published":
            every = [m for m in net.modules() if isinstance(m, LsqQuantizer)]
            assert len(every) == 2 * count  # nothing beside the paper's two per convolution
    assert not quantised_convs(model)


def signs(net):
    return {
        name: conv.input_quant.code_format.signed
        for name, conv in quantised_convs(net).items()
        if not name.startswith("backbone")
    }


def test_inputs_are_signed_where_they_may_be_negative():
    net = quantise(trained(), "III", THREE)
    signed = {name for name, flag in signs(net).items() if flag}
    pyramids = {f"{fpn}.outputs.{k}" for fpn in ("fpn", "fpn_pseudo") for k in range(3)}
    assert signed == pyramids | {"head.class_tower.convs.0", "head.pose_tower.convs.0"}
    assert all(m.weight_quant.code_format.signed for m in quantised_convs(net).values())


def test_a_leaky_backbone_needs_signed_inputs():
    net = quantise(trained("corrected"), "III", THREE)
    signed = {name for name, flag in signs(net).items() if flag}
    assert {"fpn.laterals.0", "fpn.top.p6", "fpn_pseudo.top.p6", "fpn.outputs.1"} < signed
    assert not signed & {"fpn.top.p7", "head.pose", "head.classes", "head.pose_tower.convs.1"}
    assert net.backbone.stages[1].units[0].expand.conv.input_quant.code_format.signed


@pytest.mark.parametrize(
    ("mode", "variant"),
    [("III", "published"), ("III", "deployable"), ("II", "corrected"), ("I", "deployable")],
)
def test_every_mode_trains_every_step_it_has(mode, variant):
    net = quantise(trained(variant), mode, EIGHT)  # at 3 bits P7's few cells may all be clipped
    calibrate_steps(net, images())
    net.train()
    sum(p.logits.pow(2).sum() + p.offsets.pow(2).sum() for p in net(images(4))).backward()
    unused = {"classifier"} | ({"fpn.top", "fpn_pseudo.top"} if variant == "published" else set())
    for name, p in net.named_parameters():
        if not name.startswith(tuple(unused)):
            assert p.grad is not None, name
            assert torch.isfinite(p.grad).all(), name
            if name.endswith("quant.step"):
                assert p.grad.abs().sum() > 0, name


def test_many_bits_come_close_to_the_float_network():
    model = trained().eval()
    fine = Precision(IntFormat(14, signed=True), IntFormat(14), IntFormat(16))
    net = quantise(model, "III", fine)
    calibrate_steps(net, images())
    with torch.no_grad():
        wanted, found = model(images()), net(images())
    for a, b in list(zip(found, wanted, strict=True))[:3]:  # a P7 of one cell is mostly chance
        assert (a.offsets - b.offsets).norm() < 0.15 * b.offsets.norm()


def test_float_weights_load_into_the_quantised_network():
    one, other = trained(seed=0), trained(seed=5)
    net = quantise(one, "III", THREE)
    missing, unexpected = net.load_state_dict(other.state_dict(), strict=False)
    assert not unexpected
    assert all(name.endswith("step") for name in missing)
    assert torch.equal(net.fpn.outputs[0].weight, other.fpn.outputs[0].weight)


def test_a_shared_top_is_quantised_once_and_stays_shared():
    net = quantise(trained("published"), "II", THREE)
    assert net.fpn.top is net.fpn_pseudo.top
    assert isinstance(net.fpn.top.p6, LsqConv2d)


def test_three_paths_take_a_quantised_network():
    net = quantise(trained(), "III", THREE)
    calibrate_steps(net, images())
    paths = ThreePaths(net, generator(2), freeze=False).train()
    output = paths(images(4), images(4, seed=2))
    assert output.ideal is not None
    sum(p.logits.sum() for p in output.ideal).backward()
    assert paths.fpn.laterals[0].weight.grad.abs().sum() > 0


CASES = {
    "3 bits": (THREE, {}),
    "8 bits": (EIGHT, {}),
    "mixed": (Precision(IntFormat(4, signed=True), IntFormat(5), IntFormat(6), per_channel=True), {}),
    "factual": (THREE, {"counterfactual": False}),
    "speed": (THREE, {"dataset": "speed"}),
}


@pytest.fixture(scope="module", params=CASES)
def deployed(request):
    precision, fields = CASES[request.param]
    net = quantise(trained(**fields), "III", precision)
    calibrate_steps(net, images())
    image = images(1, seed=7)[0]
    program = lower_network(net, *image.shape[1:])
    codes = host_codes(net.backbone, image)
    return net, program, image, codes, DeployedNetwork(program)(codes)


def test_golden_and_torch_agree_on_every_tensor(deployed):
    _, program, _, codes, tensors = deployed
    golden = run_golden(program, codes.numpy())
    assert list(golden) == list(tensors) == [program.input, *(op.name for op in program.ops)]
    for name, wanted in golden.items():
        assert np.array_equal(tensors[name].numpy(), wanted), name
        if wanted.size >= 64:
            assert len(np.unique(wanted)) > 1, name  # a constant would prove nothing


def test_every_quantiser_call_of_the_training_graph_is_a_tensor(deployed):
    net, program, image, _, tensors = deployed
    training = training_codes(net, image, program)
    accumulators = {op.name for op in program.ops if isinstance(op, AccumulateOp)}
    assert len(accumulators) == 10
    assert set(training) == set(tensors) - accumulators
    found = {name: tensors[name].numpy() for name in training}
    for name, codes in training.items():
        assert codes.shape == found[name].shape
    shares = differing_shares(training, found)
    # Differences accumulate, and a network without training amplifies them; how large a layer's own are, the next
    # test says. On the whole the two sides see the same picture.
    assert np.median(list(shares.values())) < 0.5


def test_every_layer_alone_differs_by_single_roundings(deployed):
    """Given the deployed codes of its inputs, float32 leaves the exact code only beside a rounding boundary."""
    net, program, image, _, tensors = deployed
    training = training_codes(net, image, program, given=tensors)
    codes = differing = 0
    for name, mine in training.items():
        gap = np.abs(mine - tensors[name].numpy())
        assert gap.max() <= 1, name
        codes, differing = codes + gap.size, differing + np.count_nonzero(gap)
        # SPEED's factor of 0.1 puts every tenth code on a tie, which float32 decides by chance.
        limit = 0.05 if name.endswith(".scaled") else 0.002
        assert np.count_nonzero(gap) <= max(3, limit * gap.size), name
    assert differing <= 2e-4 * codes


def test_a_layer_that_differs_is_named_alone(deployed):
    net, program, image, _, tensors = deployed
    changed = copy.deepcopy(net)
    with torch.no_grad():
        changed.backbone.stages[1].units[0].reduce.bn.bias += 0.3
    training = training_codes(changed, image, program, given=tensors)
    shares = differing_shares(training, {name: tensors[name].numpy() for name in training})
    # In a map of two pixels a single code is a large share.
    changed_most = {name for name, share in shares.items() if share > 0.02 and training[name].size >= 256}
    assert changed_most == {"stage2.unit1.reduce"}


def test_the_report_counts_every_tensor_once_per_picture():
    net = quantise(trained(), "III", THREE)
    calibrate_steps(net, images())
    pictures = list(images(2, seed=9))
    rows = layer_differences(net, pictures)
    program = lower_network(net, 64, 96)
    assert [row["name"] for row in rows] == [
        program.input,
        *(op.name for op in program.ops if not isinstance(op, AccumulateOp)),
    ]
    sizes = {
        name: value.numel()
        for name, value in DeployedNetwork(program)(host_codes(net.backbone, pictures[0])).items()
    }
    assert all(row["codes"] == 2 * sizes[row["name"]] for row in rows)
    assert all(row["alone"] <= 0.05 and row["largest"] <= 1 for row in rows)
    assert rows[0]["alone"] == rows[0]["accumulated"] == 0  # made by the same code on both sides


def test_host_predictions_are_the_training_graphs(deployed):
    net, program, image, _, tensors = deployed
    with torch.no_grad():
        wanted = net(image[None])
    found = host_predictions(program, tensors)
    assert len(found) == 5
    for a, b in zip(found, wanted, strict=True):
        assert a.logits.shape == b.logits.shape
        assert a.offsets.shape == b.offsets.shape
        assert (a.offsets - b.offsets).norm() <= 0.5 * b.offsets.norm()


def test_the_reference_layer_is_in_the_program(deployed):
    _, program, *_ = deployed
    assert program.conv("stage2.unit1.expand").spec.kernel == 3


def test_what_cannot_be_lowered_is_refused():
    net = quantise(trained(), "II", THREE)
    with pytest.raises(ValueError, match="only a deployable network in mode III"):
        lower_network(net, 64, 64)
    leaky = quantise(trained("corrected"), "III", THREE)
    with pytest.raises(ValueError, match="only a deployable network in mode III"):
        lower_network(leaky, 64, 64)
    net = quantise(trained(), "III", THREE)
    with pytest.raises(ValueError, match="calibrate"):
        lower_network(net, 64, 64)
    with pytest.raises(ValueError, match="multiples of 32, not 64 and 50"):
        lower_network(net, 64, 50)
    with pytest.raises(ValueError, match="mode must be one of I, II, III, not 'iv'"):
        quantise(trained(), "iv", THREE)


def test_published_networks_stay_out_of_hardware_by_construction():
    config = spacenet_config("tiny", "published")
    assert not config.deployable
    assert not replace(config, norm="batch").deployable


def both(program, codes):
    golden = run_golden(program, codes)
    torch_codes = {k: v.numpy() for k, v in DeployedNetwork(program)(torch.from_numpy(codes)).items()}
    for name, wanted in golden.items():
        assert np.array_equal(torch_codes[name], wanted), name
    return golden


def test_signed_lookup_and_doubled_sum_by_hand():
    s3 = IntFormat(3, signed=True)
    codes = np.array([[[-4, 3], [0, -1]]])
    program = Program(
        "x", s3, (1, 2, 2),
        (
            LookupOp("relu", "x", np.array([0, 0, 0, 0, 0, 2, 4, 6]), -4),
            LookupOp("wide", "x", np.arange(8) - 4, -4),
            AddOp("once", "wide", "x", -np.arange(-4, 4), 3, floor=-4, low=-4),
            AddOp("sum", "x", "x", np.arange(-40, 40, 10), 3, floor=-4, low=-4),
            LookupOp("half", "x", np.array([-2, -2, -1, 0, 0, 0, 1, 2]), -4),
            LookupOp("bent", "x", np.array([5, 1, 2, 2, 7, 0, 3, 4]), -4),
            LookupOp("same", "x", np.full(8, 1 << 25), -4),
        ),
    )  # fmt: skip
    out = both(program, codes)
    assert out["relu"].tolist() == [[[0, 6], [0, 0]]]
    assert not out["once"].any()
    assert out["sum"].tolist() == [[[-4, 3], [0, -4]]]
    assert out["half"].tolist() == [[[-2, 2], [0, 0]]]
    assert out["bent"].tolist() == [[[5, 4], [7, 2]]]
    assert out["same"].tolist() == [[[1 << 25] * 2] * 2]


@pytest.mark.parametrize("steps", [(1.0, 2.0), (0.013, 0.0207), (0.4, 0.01), (0.01, 3.0)])
@pytest.mark.parametrize("form", [IntFormat(3), IntFormat(8), IntFormat(8, signed=True)])
def test_tables_between_steps_need_no_gathering(steps, form):
    """It would still be right, but several times slower."""
    source, target = (LsqQuantizer(f, batched=True) for f in (form, IntFormat(3, signed=form.signed)))
    for quantizer, step in zip((source, target), steps, strict=True):
        quantizer.step.data.fill_(step)
    table = code_table(source, target)
    op = LookupOp("y", "x", table, form.lo)
    codes = np.arange(form.lo, form.hi + 1).reshape(1, 1, -1)
    both(Program("x", form, codes.shape, (op,)), codes)
    assert (_Table(op).ratio is None) == (table.min() == table.max())


def test_only_accumulators_are_kept_when_nothing_else_is_asked_for(deployed):
    _, program, _, codes, tensors = deployed
    sums = DeployedNetwork(program).accumulators(codes)
    assert list(sums) == [op.name for op in program.ops if isinstance(op, AccumulateOp)]
    assert all(torch.equal(value, tensors[name]) for name, value in sums.items())


def test_a_doubled_branch_serves_four_places():
    s3, u3 = IntFormat(3, signed=True), IntFormat(3)
    weights = np.zeros((1, 1, 3, 3), np.int64)
    weights[0, 0, 1, 1] = 1
    spec = ConvSpec(1, 1, 4, 4, stride=2, weight=s3, input=u3, output=IntFormat(16, signed=True))
    half = AccumulateOp("half", "x", spec, weights, np.ones(1), np.zeros(1))
    program = Program(
        "x", u3, (1, 4, 4), (half, AddOp("sum", "x", "half", np.arange(8) * 10, 99, doubled=True))
    )
    codes = np.arange(16).reshape(1, 4, 4) % 8
    wanted = codes + 10 * codes[:, ::2, ::2].repeat(2, 1).repeat(2, 2)
    assert np.array_equal(both(program, codes)["sum"], wanted)


@pytest.mark.parametrize("sign", [1, -1])
def test_the_largest_8_bit_sums_are_exact(sign):
    """All operands at their limits, far beyond what one float32 convolution could add up."""
    s8, u8 = IntFormat(8, signed=True), IntFormat(8)
    c = 512
    weights = np.full((2, c, 3, 3), 127 if sign > 0 else -128)
    weights[1, ::2] = 1
    spec = ConvSpec(c, 2, 4, 4, weight=s8, input=u8, output=IntFormat(30, signed=True))
    program = Program("x", u8, (c, 4, 4), (AccumulateOp("acc", "x", spec, weights, np.ones(2), np.zeros(2)),))
    codes = np.full((c, 4, 4), 255)
    codes[::3] = 254
    largest = both(program, codes)["acc"]
    assert abs(largest).max() > 1 << 24
