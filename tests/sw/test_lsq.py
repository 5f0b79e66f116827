"""LSQ quantisers against the published closed form, written here a second time in NumPy."""

from __future__ import annotations

import math

import numpy as np
import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st

from macram.quant.lsq import MIN_STEP, LsqQuantizer
from macram.spec import IntFormat

S3, U3, S8, U8 = IntFormat(3, signed=True), IntFormat(3), IntFormat(8, signed=True), IntFormat(8)
RANGES = {S3: (4, 3), U3: (0, 7), S8: (128, 127), U8: (0, 255)}
FORMATS = list(RANGES)


def closed_form(v, step, fmt, upstream, features):
    """Values, codes, dL/dv and dL/dstep, element by element, from the paper's equations 1-5."""
    qn, qp = RANGES[fmt]
    v_hat, codes, grad_v, grad_s = [], [], [], 0.0
    for value, g in zip(v.ravel().tolist(), upstream.ravel().tolist(), strict=True):
        q = value / step
        code = int(np.rint(max(-qn, min(qp, q))))
        codes.append(code)
        v_hat.append(code * step)
        if q <= -qn:
            slope, passes = -qn, 0.0
        elif q >= qp:
            slope, passes = qp, 0.0
        else:
            slope, passes = int(np.rint(q)) - q, 1.0
        grad_v.append(g * passes)
        grad_s += g * slope
    grad_s /= math.sqrt(features * qp)
    return (*(np.array(x).reshape(v.shape) for x in (v_hat, codes, grad_v)), grad_s)


def quantizer(fmt, step, *, batched=False):
    module = LsqQuantizer(fmt, batched=batched).double()
    with torch.no_grad():
        module.step.fill_(step)
    return module


def values(fmt, step, seed, shape=(3, 4, 5)):
    """Inside, saturated on both sides, exact ties, exact codes, exact bounds and zeros."""
    rng = np.random.default_rng(seed)
    qn, qp = RANGES[fmt]
    q = rng.uniform(-1.5 * qn - 2, 1.5 * qp + 2, shape).ravel()
    q[:12] = [0.5, 1.5, -0.5, 2.5, -1.5, 0.0, 1.0, qp, -qn, qp - 0.5, -qn - 0.5, qp + 0.5]
    return (q * step).reshape(shape)


@pytest.mark.parametrize("batched", [False, True])
@pytest.mark.parametrize("fmt", FORMATS, ids=str)
@pytest.mark.parametrize("step", [0.25, 0.3, 2.0])
def test_forward_and_both_gradients_equal_the_closed_form(fmt, step, batched):
    v = values(fmt, step, seed=7)
    upstream = np.random.default_rng(8).normal(size=v.shape)
    module = quantizer(fmt, step, batched=batched)
    features = v.size // v.shape[0] if batched else v.size
    v_hat, codes, grad_v, grad_s = closed_form(v, step, fmt, upstream, features)

    x = torch.tensor(v, requires_grad=True)
    y = module(x)
    y.backward(torch.tensor(upstream))
    assert (y.detach().numpy() == v_hat).all()
    assert (module.to_codes(x).numpy() == codes).all()
    assert (x.grad.numpy() == grad_v).all()
    assert module.step.grad.item() == pytest.approx(grad_s, rel=1e-12, abs=1e-12)


@settings(deadline=None, max_examples=60)
@given(
    fmt=st.sampled_from(FORMATS),
    step=st.floats(1e-3, 1e3),
    qs=st.lists(st.floats(-400, 400), min_size=1, max_size=20),
)
def test_any_values(fmt, step, qs):
    v = np.array(qs) * step
    v_hat, codes, _, _ = closed_form(v, step, fmt, np.ones_like(v), v.size)
    module = quantizer(fmt, step)
    out = module(torch.tensor(v))
    assert (module.to_codes(torch.tensor(v)).numpy() == codes).all()
    assert (out.detach().numpy() == v_hat).all()
    # a value that is already representable stays what it is
    assert (module.to_codes(out).numpy() == codes).all()


def test_ties_go_to_the_even_code():
    module = quantizer(S3, 1.0)
    v = torch.tensor([-2.5, -1.5, -0.5, 0.5, 1.5, 2.5], dtype=torch.float64)
    assert module.to_codes(v).tolist() == [-2, -2, 0, 0, 2, 2]


@pytest.mark.parametrize("fmt", FORMATS, ids=str)
def test_gradient_equals_autograd_of_straight_through_rounding(fmt):
    """Away from the bounds, torch's own derivative of clip and a straight-through round is the same thing."""
    qn, qp = RANGES[fmt]
    step = 0.37
    v = torch.tensor(values(fmt, step, seed=3).ravel()[12:], requires_grad=True)
    s = torch.tensor(step, dtype=torch.float64, requires_grad=True)
    q = (v / s).clamp(-qn, qp)
    ((q + (q.round() - q).detach()) * s).square().sum().backward()

    module = quantizer(fmt, step)
    x = v.detach().clone().requires_grad_(True)
    module(x).square().sum().backward()
    assert torch.equal(x.grad != 0, v.grad != 0)
    assert torch.allclose(x.grad, v.grad, rtol=1e-12, atol=1e-12)
    scale = 1 / math.sqrt(v.numel() * qp)
    assert module.step.grad.item() == pytest.approx(s.grad.item() * scale, rel=1e-10)


@pytest.mark.parametrize(("fmt", "q"), [(S3, 9.0), (S3, -9.0), (U8, 300.0), (U3, -1.0)])
def test_step_gradient_of_saturated_values_is_the_true_derivative(fmt, q):
    step, h = 0.5, 1e-6
    v = torch.full((4,), q * step, dtype=torch.float64)
    module = quantizer(fmt, step)
    module(v).sum().backward()
    difference = (quantizer(fmt, step + h)(v) - quantizer(fmt, step - h)(v)).sum().item() / (2 * h)
    assert module.step.grad.item() * math.sqrt(4 * RANGES[fmt][1]) == pytest.approx(difference, rel=1e-6)


def test_batch_does_not_count_in_the_gradient_scale():
    v = torch.full((8, 2, 3), 100.0, dtype=torch.float64)
    activations, weights = quantizer(U3, 1.0, batched=True), quantizer(S3, 1.0)
    activations(v).sum().backward()
    weights(v).sum().backward()
    assert activations.step.grad.item() == pytest.approx(48 * 7 / math.sqrt(6 * 7))
    assert weights.step.grad.item() == pytest.approx(48 * 3 / math.sqrt(48 * 3))


def test_one_step_per_output_channel():
    rng = np.random.default_rng(5)
    v, upstream = rng.normal(size=(3, 2, 3, 3)) * 3, rng.normal(size=(3, 2, 3, 3))
    steps = [0.3, 1.0, 2.5]
    module = LsqQuantizer(S3, step_shape=(3, 1, 1, 1), batched=False).double()
    with torch.no_grad():
        module.step.copy_(torch.tensor(steps, dtype=torch.float64).reshape(3, 1, 1, 1))
    x = torch.tensor(v, requires_grad=True)
    y = module(x)
    y.backward(torch.tensor(upstream))
    for channel, step in enumerate(steps):
        v_hat, codes, grad_v, grad_s = closed_form(v[channel], step, S3, upstream[channel], 18)
        assert (y.detach().numpy()[channel] == v_hat).all()
        assert (module.to_codes(x).numpy()[channel] == codes).all()
        assert (x.grad.numpy()[channel] == grad_v).all()
        assert module.step.grad[channel].item() == pytest.approx(grad_s, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize(("fmt", "qp"), [(S3, 3), (U3, 7), (S8, 127), (U8, 255)], ids=str)
def test_initial_step(fmt, qp):
    v = torch.tensor([-1.0, 2.0, -3.0, 6.0])
    module = LsqQuantizer(fmt, batched=False)
    assert torch.isnan(module.step)
    module.set_step(v.abs().mean())
    assert module.step.item() == pytest.approx(2 * 3.0 / math.sqrt(qp), rel=1e-6)


@pytest.mark.parametrize("mean", [0.0, -1.0, math.nan, math.inf])
def test_initial_step_refuses(mean):
    with pytest.raises(ValueError, match="mean magnitude must be positive and finite"):
        LsqQuantizer(U3, batched=True).set_step(mean)


def test_step_stays_positive_and_can_recover():
    """An optimiser pushes the parameter to -1: codes use a positive step, the gradient flows."""
    module = quantizer(U3, -1.0)
    v = torch.tensor([0.0, 1.0, 2.0], dtype=torch.float64)
    out = module(v)
    assert module.positive_step.item() == MIN_STEP
    assert torch.isfinite(out).all()
    assert (out >= 0).all()
    assert module.to_codes(v).tolist() == [0, 7, 7]
    (out - v).square().sum().backward()
    assert module.step.grad.item() < 0  # descent makes the step larger


def test_float32_codes_times_step_is_the_forward():
    torch_rng = torch.Generator().manual_seed(1)
    v = torch.randn((64, 50), generator=torch_rng)
    for fmt in FORMATS:
        module = LsqQuantizer(fmt, batched=False)
        module.set_step(v.abs().mean())
        codes = module.to_codes(v)
        assert fmt.holds(codes.numpy())
        assert torch.equal(module(v), codes.float() * module.step)
