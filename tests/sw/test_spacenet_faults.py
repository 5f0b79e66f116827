"""Each fault of the published network that lives in the network, shown and cured."""

from __future__ import annotations

import copy
from dataclasses import replace

import pytest
import torch
from torch import nn

from macram.model import PUBLISHED_FAULTS, Faults, SpaceNet, ThreePaths, spacenet_config
from macram.train.losses import similarity_loss


def generator(seed=0):
    return torch.Generator().manual_seed(seed)


def image(seed=1, n=2, side=128):
    return torch.randn((n, 3, side, side), generator=generator(seed))


def network(variant="corrected", **faults):
    config = spacenet_config("tiny", variant)
    if faults:
        config = replace(config, faults=Faults(**faults))
    return SpaceNet(config, generator())


def gradient_sizes(module):
    return [0.0 if p.grad is None else p.grad.abs().sum().item() for p in module.parameters()]


def test_published_is_every_fault_and_the_default_none():
    assert spacenet_config("paper", "published").faults == PUBLISHED_FAULTS
    assert spacenet_config("paper").faults == spacenet_config("paper", "deployable").faults == Faults()


def test_a_shared_top_makes_p6_and_p7_blind():
    model = network(dead_top=True).eval()
    with torch.no_grad():
        direct = model.features(image()).direct
        one, other = model(image(1)), model(image(2))
    assert [bool(level.any()) for level in direct] == [True, True, True, False, False]
    for level in (3, 4):
        assert torch.equal(one[level].logits, other[level].logits)
        assert torch.equal(one[level].offsets, other[level].offsets)
    assert not torch.equal(one[2].offsets, other[2].offsets)


def test_an_own_top_makes_them_see():
    model = network().eval()
    with torch.no_grad():
        direct = model.features(image()).direct
        one, other = model(image(1)), model(image(2))
    assert all(level.any() for level in direct)
    for level in range(5):
        assert not torch.equal(one[level].logits, other[level].logits)


@pytest.mark.parametrize("dead_top", [True, False])
def test_a_shared_top_gets_no_gradient_from_the_head(dead_top):
    model = network(dead_top=dead_top)
    sum(p.logits.pow(2).sum() + p.offsets.pow(2).sum() for p in model(image())).backward()
    sizes = gradient_sizes(model.fpn.top)
    assert (max(sizes) == 0) == dead_top
    assert min(gradient_sizes(model.fpn.laterals)) > 0


def statistics(module):
    return [b.clone() for name, b in module.named_buffers() if "running" in name]


@pytest.mark.parametrize("drifting", [True, False])
def test_statistics_of_the_frozen_backbone(drifting):
    model = network(drifting_statistics=drifting)
    paths = ThreePaths(model, generator(1))
    before = statistics(model.backbone)
    for _ in range(2):  # an epoch starts with train()
        paths.train()
        paths(image(1), image(2))
    after = statistics(model.backbone)
    moved = [not torch.equal(a, b) for a, b in zip(before, after, strict=True)]
    assert all(moved) if drifting else not any(moved)
    assert not any(p.requires_grad for p in model.backbone.parameters())
    if drifting:  # the counterfactual path keeps the originals
        kept = zip(before, statistics(paths.backbone), strict=True)
        assert all(torch.equal(a, b) for a, b in kept)
    else:
        assert paths.backbone is None


def train_loss(output):
    loss = similarity_loss(output.pseudo, output.counterfactual)
    for predictions in (output.predictions, output.ideal or ()):
        loss = loss + sum(p.logits.pow(2).sum() + p.offsets.pow(2).sum() for p in predictions)
    return loss


@pytest.mark.parametrize("untrained", [True, False])
def test_the_counterfactual_pyramid_learns_or_not(untrained):
    paths = ThreePaths(network(untrained_counterfactual=untrained), generator(1))
    output = paths(image(1), image(2))
    train_loss(output).backward()
    assert (output.ideal is None) == untrained
    sizes = gradient_sizes(paths.fpn)
    assert max(sizes) == 0 if untrained else min(sizes) > 0
    assert any(p.requires_grad for p in paths.fpn.parameters()) != untrained
    assert min(gradient_sizes(paths.model.fpn_pseudo)) > 0
    assert max(gradient_sizes(paths.model.backbone)) == 0


def test_the_similarity_loss_alone_does_not_move_the_counterfactual_pyramid():
    paths = ThreePaths(network(), generator(1))
    output = paths(image(1), image(2))
    similarity_loss(output.pseudo, output.counterfactual).backward()
    assert max(gradient_sizes(paths.fpn)) == 0
    assert min(gradient_sizes(paths.model.fpn_pseudo)) > 0
    assert max(gradient_sizes(paths.model.fpn)) == 0


def test_published_parameter_counts_of_the_counterfactual_stage():
    config = spacenet_config("paper", "published")
    with torch.device("meta"):
        paths = ThreePaths(SpaceNet(config, torch.Generator("cpu")), torch.Generator("cpu"))
    count = sum(p.numel() for m in (paths.backbone, paths.classifier, paths.fpn) for p in m.parameters())
    assert count == 46_789_320
    assert sum(p.numel() for p in paths.parameters() if p.requires_grad) == 12_173_078
    assert sum(p.numel() for p in paths.model.parameters()) == 53_783_006


def test_inference_drops_the_counterfactual_path():
    paths = ThreePaths(network(), generator(1)).eval()
    used = {id(p) for p in paths.model.parameters()}
    assert not used & {id(p) for p in paths.fpn.parameters()}
    with torch.no_grad():
        trained, alone = paths(image(1), image(2)).predictions, paths.model(image(1))
    assert all(torch.equal(a.offsets, b.offsets) for a, b in zip(trained, alone, strict=True))


def test_the_erased_picture_moves_no_statistics():
    model = SpaceNet(spacenet_config("tiny", "deployable"), generator())
    alone = copy.deepcopy(model).train()
    paths = ThreePaths(model, generator(1), freeze=False).train()
    paths(image(1), image(2))
    assert model.backbone.training
    alone(image(1))
    for a, b in zip(statistics(model), statistics(alone), strict=True):
        assert torch.equal(a, b)
    assert all(m.track_running_stats for m in model.modules() if isinstance(m, nn.BatchNorm2d))


@pytest.mark.parametrize("variant", ["corrected", "published", "deployable"])
def test_the_second_stage_starts_from_the_first(variant):
    config = spacenet_config("tiny", variant)
    first = SpaceNet(replace(config, counterfactual=False, surface=True), generator(5))
    paths = ThreePaths(SpaceNet(config, generator(6)), generator(7))
    fresh = copy.deepcopy(paths.model.fpn_pseudo.laterals[0].weight)
    paths.load_factual(first.state_dict())
    state = first.state_dict()
    for key, value in paths.model.state_dict().items():
        if key in state:
            assert torch.equal(value, state[key]), key
    assert torch.equal(paths.fpn.top.p7.weight, first.fpn.top.p7.weight)
    assert torch.equal(paths.model.fpn_pseudo.laterals[0].weight, fresh)
    if variant == "published":
        weight = paths.backbone.init.conv.weight
        assert torch.equal(weight, first.backbone.init.conv.weight)


def test_a_first_stage_of_another_network_is_refused():
    paths = ThreePaths(network(), generator(7))
    state = paths.model.state_dict()
    state.pop("head.scales")
    with pytest.raises(ValueError, match=r"tensor 'head\.scales' is missing"):
        paths.load_factual(state)
    state = paths.model.state_dict()
    with pytest.raises(ValueError, match="tensor 'other' is unknown"):
        paths.load_factual({**state, "other": torch.zeros(1)})
    with pytest.raises(ValueError, match=r"tensor 'head\.scales' must be \[5\], not \[6\]"):
        paths.load_factual({**state, "head.scales": torch.zeros(6)})
    with pytest.raises(ValueError, match="counterfactual=True"):
        ThreePaths(SpaceNet(spacenet_config("tiny", counterfactual=False), generator()), generator())
