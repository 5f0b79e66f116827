"""From an image to integer codes: deployed PyTorch network == golden model, on every tensor, by equality."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import torch
from PIL import Image

from macram.front import (
    IMAGE_SIZE,
    REFERENCE_LAYER,
    load_checkpoint,
    normalise,
    prepare_network,
    read_image,
    reference_case,
    save_checkpoint,
)
from macram.front import case as front_case
from macram.golden import ShiftRequant, ThresholdRequant, derive_requant, float_code, run_layer
from macram.model import BackboneConfig, DarkNet53
from macram.quant import (
    DeployedNetwork,
    Precision,
    QuantDarkNet53,
    calibrate_batch_norm,
    calibrate_steps,
    differing_shares,
    host_codes,
    lower,
    run_golden,
    training_codes,
)
from macram.quant.program import AddOp, ConvOp, LookupOp, Program
from macram.spec import ConvSpec, IntFormat

EXAMPLES = Path(__file__).parents[2] / "examples"
FRAMES = [EXAMPLES / f"frame_{index}.png" for index in (0, 2, 3)]
TENSORS = [
    "stage1.entry.input", "stage1.entry",
    "stage1.unit1.reduce.input", "stage1.unit1.reduce", "stage1.unit1.expand", "stage1.unit1",
    "stage2.entry.input", "stage2.entry",
    "stage2.unit1.reduce.input", "stage2.unit1.reduce", "stage2.unit1.expand",
]  # fmt: skip


@pytest.fixture(scope="module")
def network():
    net, _ = prepare_network(seed=2022, calibration=FRAMES[:1])
    return net


@pytest.fixture(scope="module")
def program(network):
    return lower(network, IMAGE_SIZE, IMAGE_SIZE, last=REFERENCE_LAYER)


def small(seed=0, precision=None, stages=(1, 2), width=0.25):
    """A calibrated small network whose batch normalisation has negative and zero gammas and odd shifts."""
    g = torch.Generator().manual_seed(seed)
    model = DarkNet53(BackboneConfig(width, stages), g)
    images = torch.randn((2, 3, 26, 38), generator=g)
    for module in model.modules():
        if isinstance(module, torch.nn.BatchNorm2d):
            with torch.no_grad():
                module.weight.copy_(torch.randn(module.num_features, generator=g))
                module.bias.copy_(torch.randn(module.num_features, generator=g) * 0.5 + 0.3)
                module.weight[1] = 0.0
    calibrate_batch_norm(model, images)
    net = QuantDarkNet53(model, precision or Precision())
    calibrate_steps(net, images)
    return net, images[0]


def everywhere_equal(net, image, program):
    codes = host_codes(net, image)
    deployed = {name: t.numpy() for name, t in DeployedNetwork(program)(codes).items()}
    golden = run_golden(program, codes.numpy())
    assert list(deployed) == list(golden) == [program.input, *(op.name for op in program.ops)]
    for name, values in golden.items():
        assert values.shape == deployed[name].shape
        assert np.array_equal(values, deployed[name]), name
    return deployed


def test_real_image_deployed_equals_golden_on_every_tensor(network, program):
    image = normalise(read_image(FRAMES[1]))
    tensors = everywhere_equal(network, image, program)
    assert list(tensors) == TENSORS
    for name, codes in tensors.items():
        assert codes.min() == 0
        assert codes.max() > 3, f"{name} makes no use of its range"
        assert 0.05 < (codes > 0).mean() < 0.95
    assert tensors["stage2.unit1.reduce"].shape == (64, 128, 128)
    assert tensors[REFERENCE_LAYER].shape == (128, 128, 128)
    assert program.conv(REFERENCE_LAYER).spec == ConvSpec(64, 128, 128, 128)


def test_program_is_the_arithmetic_contract(program):
    by_kind = {kind: [op for op in program.ops if isinstance(op, kind)] for kind in (ConvOp, LookupOp, AddOp)}
    assert [len(ops) for ops in by_kind.values()] == [6, 3, 1]
    for op in by_kind[ConvOp]:
        kind = ShiftRequant if op.name.endswith("entry") else ThresholdRequant
        assert isinstance(op.requant, kind)
        assert (op.weights.min(), op.weights.max()) == (-4, 3)
    for op in by_kind[LookupOp]:
        assert op.table.shape == (256,)
        assert (np.diff(op.table) >= 0).all()
        assert (op.table[0], op.table[-1]) == (0, 7)
    (add,) = by_kind[AddOp]
    assert add.table.shape == (8,)
    assert add.ceiling == 255


def test_tables_are_the_rounded_ratio_of_the_steps(network, program):
    ops = {op.name: op for op in program.ops}
    stage = network.stages[0]
    stream, branch = stage.stream_quant.step.item(), stage.units[0].branch_quant.step.item()
    reduce = stage.units[0].reduce.input_quant.step.item()
    wanted = [min(7, round(code * stream / reduce)) for code in range(256)]
    assert ops["stage1.unit1.reduce.input"].table.tolist() == wanted
    assert ops["stage1.unit1"].table.tolist() == [round(code * branch / stream) for code in range(8)]


@pytest.mark.parametrize(
    "precision",
    [
        Precision(),
        Precision(per_channel=True),
        Precision(weight=IntFormat(8, signed=True), activation=IntFormat(8)),
        Precision(weight=IntFormat(2, signed=True), activation=IntFormat(4), stream=IntFormat(6)),
    ],
    ids=["3 bits", "per channel", "8 bits", "mixed"],
)
@pytest.mark.parametrize("seed", [0, 1])
def test_small_networks_with_odd_normalisation(precision, seed):
    net, image = small(seed, precision)
    program = lower(net, 26, 38, last="stage2.unit2")
    assert any((op.scale < 0).any() and (op.scale == 0).any() for op in program.ops if isinstance(op, ConvOp))
    deployed = everywhere_equal(net, image, program)
    shares = differing_shares(training_codes(net, image, program), deployed)
    assert shares["stage1.entry.input"] == 0
    if precision.activation.bits <= 4:
        assert max(shares.values()) < 1e-3
    else:  # multiplier and shift stand in for the formula, and a differing code spreads
        assert shares["stage1.entry"] < 1e-3


def test_shares_see_a_change_of_the_training_graph():
    net, image = small()
    program = lower(net, 26, 38, last="stage1.unit1")
    deployed = everywhere_equal(net, image, program)
    with torch.no_grad():
        net.stages[0].units[0].expand.bn.bias += 0.2
    shares = differing_shares(training_codes(net, image, program), deployed)
    assert shares["stage1.unit1.reduce"] < 1e-3
    assert shares["stage1.unit1.expand"] > 0.05
    with pytest.raises(ValueError, match="tensors differ"):
        differing_shares({}, deployed)


def test_ties_go_to_the_even_code():
    """Scale 1/2 puts every odd accumulator on a tie."""
    spec = ConvSpec(1, 2, 1, 8, kernel=1, padding=0)
    scale, offset = np.array([0.5, -0.5]), np.array([0.0, 3.5])
    op = ConvOp(
        "out", "in", spec, np.ones((2, 1, 1, 1), np.int64), scale, offset, derive_requant(spec, scale, offset)
    )
    program = Program("in", IntFormat(3), (1, 1, 8), (op,))
    codes = np.arange(8).reshape(1, 1, 8)
    wanted = [[[0, 0, 1, 2, 2, 2, 3, 4]], [[4, 3, 2, 2, 2, 1, 0, 0]]]
    assert run_golden(program, codes)["out"].tolist() == wanted
    assert DeployedNetwork(program)(torch.from_numpy(codes))["out"].tolist() == wanted


def test_residual_sum_saturates():
    net, image = small()
    with torch.no_grad():
        net.stages[0].stream_quant.step *= 0.02
    program = lower(net, 26, 38, last="stage1.unit1")
    tensors = everywhere_equal(net, image, program)
    ops = {op.name: op for op in program.ops}
    sums = tensors["stage1.entry"] + ops["stage1.unit1"].table[tensors["stage1.unit1.expand"]]
    assert sums.max() > 255
    assert np.array_equal(tensors["stage1.unit1"], np.minimum(sums, 255))


def test_programs_refuse_what_they_cannot_run():
    net, image = small()
    program = lower(net, 26, 38, last="stage1.unit1")
    codes = host_codes(net, image)
    for bad in (codes[:, 1:], codes.double(), codes + 7, codes - 1):
        with pytest.raises(ValueError, match=r"stage1\.entry\.input must"):
            run_golden(program, bad.numpy())
        with pytest.raises(ValueError, match=r"stage1\.entry\.input must"):
            DeployedNetwork(program)(bad)
    with pytest.raises(ValueError, match=r"no convolution 'stage1\.unit1'"):
        program.conv("stage1.unit1")
    with pytest.raises(ValueError, match="last must be a tensor"):
        lower(net, 26, 38, last="stage9.entry")


def test_a_step_that_was_never_set_is_an_error():
    net = QuantDarkNet53(DarkNet53(BackboneConfig(0.25, (1,)), torch.Generator()), Precision())
    with pytest.raises(ValueError, match="calibrate"):
        lower(net, 16, 16, last="stage1.unit1")
    with pytest.raises(ValueError, match="relu"):
        QuantDarkNet53(DarkNet53(BackboneConfig(0.25, (1,), "leaky"), torch.Generator()), Precision())
    with pytest.raises(ValueError, match="saw only zeros"):
        calibrate_steps(net, torch.zeros(1, 3, 16, 16))


def test_calibration_sets_statistics_and_steps_of_the_batch():
    g = torch.Generator().manual_seed(3)
    model = DarkNet53(BackboneConfig(0.25, (1,)), g)
    images = torch.randn((2, 3, 20, 20), generator=g) * 5 + 1
    calibrate_batch_norm(model, images)
    with torch.no_grad():
        raw = model.init.conv(images)
    assert torch.allclose(model.init.bn.running_mean, raw.mean((0, 2, 3)), atol=1e-4)
    assert torch.allclose(model.init.bn.running_var, raw.var((0, 2, 3)), rtol=1e-4)
    assert not model.training
    assert model.init.bn.momentum == 0.1
    net = QuantDarkNet53(model, Precision())
    steps = calibrate_steps(net, images)
    with torch.no_grad():
        entry = model.init(images)
        stage = model.stages[0]
        streams = torch.stack([stage.entry(entry), stage(entry)])
    assert steps["stages.0.entry.input_quant"] == pytest.approx(2 * entry.mean().item() / 7**0.5, rel=1e-5)
    assert steps["stages.0.stream_quant"] == pytest.approx(2 * streams.mean().item() / 255**0.5, rel=1e-5)


def test_reference_case(network, program):
    torch.manual_seed(0)
    before = torch.get_rng_state()
    result = reference_case(FRAMES[0])
    assert torch.equal(torch.get_rng_state(), before)
    case = result.case
    assert case.spec == ConvSpec(64, 128, 128, 128)
    assert case.spec.macs == 1_207_959_552
    assert np.array_equal(run_layer(case), result.deployed_codes)
    assert set(np.unique(case.weights)) == set(range(-4, 4))
    assert set(np.unique(case.input)) == set(range(8))
    assert set(np.unique(result.deployed_codes)) == set(range(8))
    # the same seed and calibration give the same layer
    layer = program.conv(REFERENCE_LAYER)
    assert np.array_equal(case.weights, layer.weights)
    assert np.array_equal(case.scale, layer.scale)
    assert np.array_equal(case.offset, layer.offset)
    assert result.picture.shape == (512, 512, 3)
    assert list(result.differing) == TENSORS
    assert max(result.differing.values()) < 1e-3
    text = json.dumps(result.provenance)
    for part in ("seeded initialisation (seed 2022)", "frame_0.png", "not trained", "image_sha256"):
        assert part in text


def test_thresholds_are_the_formula_on_the_reference_layer(program):
    layer = program.conv(REFERENCE_LAYER)
    reach = np.arange(-64 * 9 * 28, 64 * 9 * 21 + 1)
    acc = np.broadcast_to(reach, (128, reach.size))
    formula = float_code(acc, layer.scale[:, None], layer.offset[:, None], layer.spec.output)
    assert np.array_equal(layer.requant.apply(acc), formula)


# ---- checkpoints ---------------------------------------------------------------------------------


def test_checkpoint_round_trip(tmp_path):
    net, image = small(3)
    path = tmp_path / "net.pt"
    save_checkpoint(net, path)
    assert [p.name for p in tmp_path.iterdir()] == ["net.pt"]
    other, _ = small(4)
    load_checkpoint(other, path)
    program, again = lower(net, 26, 38, last="stage2.unit2"), lower(other, 26, 38, last="stage2.unit2")
    one, two = everywhere_equal(net, image, program), everywhere_equal(other, image, again)
    assert all(np.array_equal(one[name], two[name]) for name in one)


def test_bad_checkpoints_are_refused(tmp_path):
    net, _ = small()
    good = net.state_dict()
    key = "stages.0.entry.conv.weight"
    cases = {
        "missing": ({k: v for k, v in good.items() if k != key}, f"'{key}' is missing"),
        "shape": ({**good, key: good[key][:1]}, rf"'{key}' must be \[16, 8, 3, 3\], not \[1, 8, 3, 3\]"),
        "nan": ({**good, key: good[key] * torch.nan}, f"'{key}' must be finite"),
        "extra": ({**good, "head.weight": torch.ones(1)}, "'head.weight' is unknown"),
        "list": ([1, 2], "must hold a dict of tensors"),
        "nested": ({"state": good}, "must hold a dict of tensors"),
        "code": (Path, "is not a checkpoint"),
    }
    before = {k: v.clone() for k, v in good.items()}
    for name, (state, message) in cases.items():
        path = tmp_path / f"{name}.pt"
        torch.save(state, path)
        with pytest.raises(ValueError, match=message) as error:
            load_checkpoint(net, path)
        assert "\n" not in str(error.value)
        assert str(path) in str(error.value)
    (tmp_path / "text.pt").write_text("not a checkpoint")
    with pytest.raises(ValueError, match="is not a checkpoint"):
        load_checkpoint(net, tmp_path / "text.pt")
    with pytest.raises(ValueError, match="no such checkpoint"):
        load_checkpoint(net, tmp_path / "absent.pt")
    with pytest.raises(ValueError, match="cannot be written"):
        save_checkpoint(net, tmp_path / "absent" / "net.pt")
    assert all(torch.equal(v, before[k]) for k, v in net.state_dict().items())


def test_reference_case_from_a_checkpoint(network, tmp_path):
    path = tmp_path / "trained.pt"
    save_checkpoint(network, path)
    net, provenance = prepare_network(checkpoint=path, seed=1)
    assert provenance["weights"] == "checkpoint trained.pt"
    assert len(provenance["checkpoint_sha256"]) == 64
    one = lower(net, IMAGE_SIZE, IMAGE_SIZE, last=REFERENCE_LAYER).conv(REFERENCE_LAYER)
    two = lower(network, IMAGE_SIZE, IMAGE_SIZE, last=REFERENCE_LAYER).conv(REFERENCE_LAYER)
    assert np.array_equal(one.weights, two.weights)
    assert np.array_equal(one.scale, two.scale)
    with pytest.raises(ValueError, match="at least one calibration image"):
        front_case.prepare_network()


# ---- images --------------------------------------------------------------------------------------


def test_examples_are_read_unchanged():
    for frame in FRAMES:
        picture = read_image(frame)
        assert picture.dtype == np.uint8
        assert np.array_equal(picture, np.asarray(Image.open(frame).convert("RGB")))


def test_normalise():
    picture = np.full((2, 3, 3), [255, 0, 124], np.uint8)
    tensor = normalise(picture)
    assert tensor.shape == (3, 2, 3)
    assert tensor.dtype == torch.float32
    wanted = [(1 - 0.485) / 0.229, (0 - 0.456) / 0.224, (124 / 255 - 0.406) / 0.225]
    assert tensor[:, 1, 2].tolist() == pytest.approx(wanted, rel=1e-5)


@pytest.mark.parametrize(("size", "box"), [((100, 40), (0, 153, 512, 358)), ((40, 100), (153, 0, 358, 512))])
def test_other_shapes_are_centred_not_stretched(tmp_path, size, box):
    path = tmp_path / "wide.png"
    Image.new("RGB", size, (200, 100, 50)).save(path)
    picture = read_image(path)
    assert picture.shape == (512, 512, 3)
    left, top, right, bottom = box
    assert (picture[top:bottom, left:right] == (200, 100, 50)).all()
    assert picture.any(axis=2).sum() == (bottom - top) * (right - left)


def test_grey_palette_and_jpeg_are_read(tmp_path):
    for mode, name in (("L", "a.png"), ("P", "b.png"), ("RGBA", "c.png"), ("L", "d.jpg")):
        path = tmp_path / name
        Image.new(mode, (64, 64), 3).save(path)
        assert read_image(path).shape == (512, 512, 3)


def test_bad_images_are_refused(tmp_path):
    (tmp_path / "text.png").write_text("hello")
    (tmp_path / "cut.png").write_bytes(FRAMES[0].read_bytes()[:5000])
    Image.new("I;16", (8, 8)).save(tmp_path / "deep.png")
    for name, message in (
        ("absent.png", "no such image"),
        ("text.png", "not a picture"),
        ("cut.png", "cannot be read"),
        ("deep.png", "8 bits per channel"),
        (".", "cannot be read"),
    ):
        path = tmp_path / name
        with pytest.raises(ValueError, match=message) as error:
            reference_case(path)
        assert "\n" not in str(error.value)
        assert str(path) in str(error.value)
