"""DarkNet-53 against the published counts, and its seeded initialisation."""

from __future__ import annotations

import pytest
import torch
from torch import nn

from macram.model import BackboneConfig, DarkNet53

MACS = {
    "init": 226_492_416,
    "stages.0": 2_550_136_832,
    "stages.1": 3_892_314_112,
    "stages.2": 11_945_377_792,
    "stages.3": 11_945_377_792,
    "stages.4": 6_576_668_672,
}
WEIGHTS = {
    "init": 864,
    "stages.0": 38_912,
    "stages.1": 237_568,
    "stages.2": 2_916_352,
    "stages.3": 11_665_408,
    "stages.4": 25_690_112,
}


def generator(seed=0):
    return torch.Generator().manual_seed(seed)


@pytest.fixture(scope="module")
def full():
    return DarkNet53(BackboneConfig(), generator()).eval()


def test_parameters_of_the_published_network(full):
    convs = [m for m in full.modules() if isinstance(m, nn.Conv2d)]
    norms = [m for m in full.modules() if isinstance(m, nn.BatchNorm2d)]
    assert len(convs) == len(norms) == 52
    assert all(conv.bias is None for conv in convs)
    assert sum(conv.weight.numel() for conv in convs) == 40_549_216
    assert sum(p.numel() for norm in norms for p in norm.parameters()) == 35_712
    assert sum(p.numel() for p in full.parameters()) == 40_584_928
    for part, count in WEIGHTS.items():
        module = full.get_submodule(part)
        assert sum(m.weight.numel() for m in module.modules() if isinstance(m, nn.Conv2d)) == count


def test_macs_and_shapes_at_512_are_the_published_ones(full):
    """On the meta device: every layer reports its shapes, nothing is computed."""
    model = DarkNet53(BackboneConfig(), generator()).eval().to("meta")
    macs = dict.fromkeys(MACS, 0)
    layers = []

    def count(name):
        def hook(module, args, output):
            part = "init" if name.startswith("init") else ".".join(name.split(".")[:2])
            macs[part] += output[0].numel() * module.weight[0].numel()
            layers.append((tuple(args[0].shape[1:]), tuple(module.weight.shape), module.stride[0]))

        return hook

    for name, module in model.named_modules():
        if isinstance(module, nn.Conv2d):
            module.register_forward_hook(count(name))
    maps = model(torch.empty(1, 3, 512, 512, device="meta"))
    assert [tuple(m.shape[1:]) for m in maps] == [
        (64, 256, 256), (128, 128, 128), (256, 64, 64), (512, 32, 32), (1024, 16, 16),
    ]  # fmt: skip
    assert macs == MACS
    assert sum(macs.values()) == 37_136_367_616
    # the layer of the paper's accelerator
    assert layers.count(((64, 128, 128), (128, 64, 3, 3), 1)) == 2


@pytest.mark.parametrize("activation", ["relu", "leaky"])
def test_a_residual_unit_adds_its_input_and_nothing_follows(activation):
    model = DarkNet53(BackboneConfig(0.125, (1, 2), activation), generator()).eval()
    unit = model.stages[0].units[0]
    x = torch.randn((2, 8, 6, 6), generator=generator(3))
    with torch.no_grad():
        assert torch.equal(unit(x), x + unit.expand(unit.reduce(x)))
        low = model(torch.randn((1, 3, 32, 32), generator=generator(4)))[-1].min().item()
    assert (low < 0) == (activation == "leaky")


def test_depth_runs_only_the_first_stages():
    model = DarkNet53(BackboneConfig(0.125, (1, 1, 1)), generator()).eval()
    image = torch.randn((1, 3, 32, 32), generator=generator(1))
    with torch.no_grad():
        maps, first = model(image), model(image, 1)
    assert len(maps) == 3
    assert len(first) == 1
    assert torch.equal(maps[0], first[0])


def test_initialisation_depends_on_the_generator_alone():
    config = BackboneConfig(0.25, (1, 1))
    torch.manual_seed(1)
    before = torch.get_rng_state()
    one, same = DarkNet53(config, generator(5)), DarkNet53(config, generator(5))
    other = DarkNet53(config, generator(6))
    assert torch.equal(torch.get_rng_state(), before)
    for key, value in one.state_dict().items():
        assert torch.equal(value, same.state_dict()[key])
        assert torch.isfinite(value).all()
    assert not torch.equal(one.init.conv.weight, other.init.conv.weight)


def test_weights_are_kaiming_normal(full):
    for name in ("stages.1.entry", "stages.3.units.2.expand"):
        weight = full.get_submodule(name).conv.weight
        assert weight.std().item() == pytest.approx((2 / weight[0].numel()) ** 0.5, rel=0.01)


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"width": 0.0}, "width must be a positive multiple of 1/32, not 0.0"),
        ({"width": -1.0}, "width must be"),
        ({"width": 0.3}, "width must be"),
        ({"width": float("nan")}, "width must be"),
        ({"stages": ()}, "stages must be unit counts"),
        ({"stages": (1, -1)}, "stages must be unit counts"),
        ({"activation": "gelu"}, "activation must be one of relu, leaky, not 'gelu'"),
    ],
)
def test_bad_configurations_are_refused(fields, message):
    with pytest.raises(ValueError, match=message):
        BackboneConfig(**fields)
