"""The network: shapes, initial values, anchors, configurations by name."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import pytest
import torch
from torch import nn

from macram.model import SIZES, VARIANTS, BackboneConfig, Levels, SpaceNet, SpaceNetConfig, spacenet_config
from macram.model.anchors import cell_centres, decode, encode


def generator(seed=0):
    return torch.Generator().manual_seed(seed)


def image(seed=1, n=2, side=128):
    return torch.randn((n, 3, side, side), generator=generator(seed))


@pytest.mark.parametrize("variant", VARIANTS)
@pytest.mark.parametrize("size", SIZES)
def test_every_named_network_predicts_on_every_level(size, variant):
    config = spacenet_config(size, variant)
    with torch.device("meta"):
        model = SpaceNet(config, generator()).eval()
    out = model(torch.empty(2, 3, 256, 256, device="meta"))
    assert [tuple(p.logits.shape) for p in out] == [(2, 1, s, s) for s in (32, 16, 8, 4, 2)]
    assert [tuple(p.offsets.shape) for p in out] == [(2, 16, s, s) for s in (32, 16, 8, 4, 2)]
    assert config.deployable == (variant == "deployable")


def test_speed_has_11_keypoints_and_maps_of_960():
    config = spacenet_config("tiny", dataset="speed")
    with torch.device("meta"):
        model = SpaceNet(config, generator())
    out = model(torch.empty(1, 3, 960, 960, device="meta"))
    assert [tuple(p.offsets.shape[1:]) for p in out] == [(22, s, s) for s in (120, 60, 30, 15, 8)]
    assert config.tde_factor == 0.1


def test_paper_front_is_the_paper_up_to_the_reference_layer():
    front = spacenet_config("paper-front").backbone
    assert front.channels == (32, 64, 128, 64, 128, 256)
    assert spacenet_config("paper").backbone.channels == (32, 64, 128, 256, 512, 1024)
    with pytest.raises(ValueError, match=r"late_width must be a positive multiple of 1/32, not 0\.3"):
        BackboneConfig(late_width=0.3)


def test_initial_values():
    model = SpaceNet(spacenet_config("quarter"), generator())
    head = model.head
    assert head.classes.bias.item() == pytest.approx(-4.5951, abs=1e-4)
    assert not head.pose.bias.any()
    assert head.class_tower.convs[0].weight.std().item() == pytest.approx(0.01, rel=0.03)
    assert torch.equal(head.scales, torch.ones(5))
    lateral = model.fpn.laterals[0].weight
    bound = math.sqrt(3 / lateral[0].numel())  # Kaiming uniform, a = 1
    assert 0.98 * bound < lateral.abs().max().item() <= bound
    assert all(torch.isfinite(p).all() for p in model.parameters())


def test_the_seed_alone_decides():
    torch.manual_seed(0)
    before = torch.get_rng_state()
    config = spacenet_config("tiny", "published")
    one, same = SpaceNet(config, generator(4)), SpaceNet(config, generator(4))
    assert torch.equal(torch.get_rng_state(), before)
    for key, value in one.state_dict().items():
        assert torch.equal(value, same.state_dict()[key])


def test_the_pyramid_by_its_definition():
    """Written a second time, straight from the description: no activation but before P7."""
    model = SpaceNet(spacenet_config("tiny"), generator()).eval()
    f = nn.functional
    with torch.no_grad():
        c3, c4, c5 = model.backbone(image())[-3:]
        fpn = model.fpn
        m5 = fpn.laterals[2](c5)
        m4 = fpn.laterals[1](c4) + m5.repeat_interleave(2, 2).repeat_interleave(2, 3)
        m3 = fpn.laterals[0](c3) + m4.repeat_interleave(2, 2).repeat_interleave(2, 3)
        p6 = f.conv2d(c5, fpn.top.p6.weight, fpn.top.p6.bias, stride=2, padding=1)
        p7 = f.conv2d(p6.clamp_min(0), fpn.top.p7.weight, fpn.top.p7.bias, stride=2, padding=1)
        wanted = (*(fpn.outputs[k](m) for k, m in enumerate((m3, m4, m5))), p6, p7)
        found = fpn((c3, c4, c5), model.taps)
    for a, b in zip(found, wanted, strict=True):
        torch.testing.assert_close(a, b)


@pytest.mark.parametrize("factor", [1.0, 0.1])
def test_the_direct_effect_is_factual_less_factor_times_pseudo(factor):
    model = SpaceNet(spacenet_config("tiny", tde_factor=factor), generator()).eval()
    with torch.no_grad():
        features = model.features(image())
    for direct, f, pc in zip(features.direct, features.factual, features.pseudo, strict=True):
        torch.testing.assert_close(direct, f - factor * pc)
        assert not torch.equal(direct, f)


def test_without_counterfactual_the_head_reads_the_factual_features():
    model = SpaceNet(spacenet_config("tiny", counterfactual=False), generator())
    features = model.features(image())
    assert features.pseudo is None
    assert features.direct is features.factual
    assert not any("pseudo" in name for name, _ in model.named_parameters())


def test_level_scales_multiply_the_offsets_alone():
    model = SpaceNet(spacenet_config("tiny"), generator()).eval()
    with torch.no_grad():
        before = model(image())
        model.head.scales[3] = 2.0
        after = model(image())
    for level, (a, b) in enumerate(zip(before, after, strict=True)):
        assert torch.equal(b.logits, a.logits)
        torch.testing.assert_close(b.offsets, a.offsets * (2.0 if level == 3 else 1.0))


def test_the_surface_head_is_there_on_demand_and_changes_nothing_else():
    plain = SpaceNet(spacenet_config("tiny"), generator())
    extra = SpaceNet(spacenet_config("tiny", surface=True), generator())
    assert plain(image())[0].surface is None
    assert extra(image())[1].surface.shape == (2, 9, 8, 8)
    state = {k: v for k, v in extra.state_dict().items() if not k.startswith("head.surface.")}
    plain.load_state_dict(state)
    plain.eval()
    extra.eval()
    assert torch.equal(plain(image())[2].offsets, extra(image())[2].offsets)


def test_batch_norm_in_the_head_is_one_per_level():
    model = SpaceNet(spacenet_config("tiny", "deployable"), generator()).train()
    model(image())
    means = [norm.running_mean for norm in model.head.pose_tower.norms[0]]
    assert len(means) == 5
    assert not torch.equal(means[0], means[4])
    assert not any(isinstance(m, nn.GroupNorm | nn.LeakyReLU) for m in model.modules())
    assert all(conv.bias is None for conv in model.head.class_tower.convs)


LEVELS = Levels()


def test_cell_centres_and_decoding_by_hand():
    centres = cell_centres(2, 3, 16)
    assert centres[1, 2].tolist() == [40.0, 24.0]
    offsets = torch.zeros(1, 4, 2, 3)
    offsets[0, :, 1, 2] = torch.tensor([0.5, -1.0, 0.25, 2.0])  # x of both keypoints, then y of both
    points = decode(offsets, 1, LEVELS)
    assert points.shape == (1, 2, 3, 2, 2)
    assert points[0, 1, 2].tolist() == [[40 + 32.0, 24 + 16.0], [40 - 64.0, 24 + 128.0]]


@pytest.mark.parametrize("level", range(5))
def test_encoding_inverts_decoding(level):
    keypoints = torch.rand((3, 8, 2), generator=generator(7)) * 512
    offsets = encode(keypoints, level, LEVELS, (5, 7))
    assert offsets.shape == (3, 16, 5, 7)
    decoded = decode(offsets, level, LEVELS)
    torch.testing.assert_close(decoded, keypoints[:, None, None].expand_as(decoded), atol=1e-3, rtol=0)


@pytest.mark.parametrize("variant", VARIANTS)
def test_a_configuration_survives_json(variant):
    config = spacenet_config("paper-front", variant, dataset="speed", surface=True)
    assert SpaceNetConfig.from_dict(json.loads(json.dumps(config.to_dict()))) == config
    assert SpaceNetConfig.from_dict({}) == spacenet_config("paper")


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"norm": "layer"}, "norm must be one of group, batch, not 'layer'"),
        ({"pyramid": 12}, "pyramid must be a multiple of 8, not 12"),
        ({"tower": 0}, "tower must be at least 1"),
        ({"image_size": 500}, "image_size must be a multiple of 32, not 500"),
        ({"tde_factor": 0.0}, "tde_factor must be above 0"),
        ({"levels": Levels((8,), (32,))}, "the pyramid has 5 levels, not 1"),
        ({"backbone": BackboneConfig(stages=(1, 1))}, "the pyramid needs 3 stages"),
    ],
)
def test_bad_configurations_are_refused(fields, message):
    with pytest.raises(ValueError, match=message):
        replace(SpaceNetConfig(), **fields)


def test_bad_names_are_refused():
    with pytest.raises(ValueError, match="variant must be one of corrected, published, deployable, not 'x'"):
        spacenet_config("tiny", "x")
    with pytest.raises(ValueError, match="one anchor per stride"):
        Levels((8, 16), (32,))
    with pytest.raises(ValueError, match="strides and anchors must be positive"):
        Levels((0,), (32,))
    with pytest.raises(ValueError, match="'colour' is no field of SpaceNetConfig; known are backbone"):
        SpaceNetConfig.from_dict({"colour": 1})
