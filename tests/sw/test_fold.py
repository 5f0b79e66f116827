"""Folded batch normalisation against the unfolded arithmetic."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
import torch
from torch import nn

from macram.quant import fold_batch_norm


def norm(channels, seed):
    bn = nn.BatchNorm2d(channels).eval()
    g = torch.Generator().manual_seed(seed)
    with torch.no_grad():
        bn.weight.copy_(torch.randn(channels, generator=g))
        bn.bias.copy_(torch.randn(channels, generator=g))
        bn.running_mean.copy_(torch.randn(channels, generator=g) * 3)
        bn.running_var.copy_(torch.rand(channels, generator=g) * 4 + 0.01)
        bn.weight[1] = 0.0  # such a channel is constant
        bn.weight[2] = -0.75
    return bn


def step(value):
    return torch.tensor(value, dtype=torch.float64)


@pytest.mark.parametrize("seed", [0, 1, 2])
@pytest.mark.parametrize("per_channel", [False, True])
def test_fold_equals_torch_batch_norm_on_dequantised_accumulators(seed, per_channel):
    channels = 7
    bn = norm(channels, seed)
    rng = np.random.default_rng(seed)
    s_w = step(rng.uniform(0.01, 0.2, (channels, 1, 1, 1)) if per_channel else 0.06)
    s_a, s_out = step(0.3), step(0.21)
    scale, offset = fold_batch_norm(bn, s_w, s_a, s_out)
    assert scale.dtype == offset.dtype == np.float64
    assert scale.shape == offset.shape == (channels,)
    assert scale[1] == 0
    assert scale[2] < 0

    acc = rng.integers(-16128, 12097, (channels, 50))
    value = torch.tensor(acc) * s_w.reshape(-1, 1) * s_a
    wanted = _batch_norm(bn, value) / s_out
    assert np.allclose(scale[:, None] * acc + offset[:, None], wanted.numpy(), rtol=1e-10, atol=1e-10)


def _batch_norm(bn, value):
    return nn.functional.batch_norm(
        value.T.double(),
        bn.running_mean.double(),
        bn.running_var.double(),
        bn.weight.detach().double(),
        bn.bias.detach().double(),
        eps=bn.eps,
    ).T


def test_known_numbers():
    """sigma 2, so scale = 3 * 0.5 * 0.25 / (2 * 0.125) and offset = (1 - 4 * 3 / 2) / 0.125, exactly."""
    bn = nn.BatchNorm2d(1, eps=0.0).eval()
    with torch.no_grad():
        bn.weight.fill_(3.0)
        bn.bias.fill_(1.0)
        bn.running_mean.fill_(4.0)
        bn.running_var.fill_(4.0)
    scale, offset = fold_batch_norm(bn, step(0.5), step(0.25), step(0.125))
    assert Fraction(scale[0]) == Fraction(3, 2)
    assert offset[0] == -40.0


def test_epsilon_counts():
    bn = nn.BatchNorm2d(1, eps=5.0).eval()
    with torch.no_grad():
        bn.running_var.fill_(4.0)
    assert fold_batch_norm(bn, step(1.0), step(1.0), step(1.0)).scale[0] == pytest.approx(1 / 3)


@pytest.mark.parametrize("which", [0, 1, 2])
@pytest.mark.parametrize("bad", [0.0, -0.1, float("nan"), float("inf")])
def test_steps_that_are_not_positive_are_refused(which, bad):
    steps = [step(0.1)] * 3
    steps[which] = step(bad)
    name = ("weight", "input", "output")[which]
    with pytest.raises(ValueError, match=f"{name} step must be positive and finite, not {bad}"):
        fold_batch_norm(norm(4, 0), *steps)


def test_broken_normalisation_is_refused():
    bn = norm(4, 0)
    with torch.no_grad():
        bn.running_var[3] = float("nan")
    with pytest.raises(ValueError, match="must be finite"):
        fold_batch_norm(bn, step(0.1), step(0.1), step(0.1))
    with pytest.raises(ValueError, match="running statistics"):
        fold_batch_norm(nn.BatchNorm2d(4, track_running_stats=False), step(0.1), step(0.1), step(0.1))
