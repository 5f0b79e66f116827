"""Learned step size quantisation (Esser et al., ICLR 2020): a quantiser whose step is a trained parameter.

With ``q = v / s`` and the code range ``-Qn..Qp``::

    code    = round(clip(q, -Qn, Qp))        half to even
    v_hat   = code * s
    d/dv    = 1 if -Qn < q < Qp else 0
    d/ds    = g * (round(q) - q) inside, -g * Qn below, g * Qp above
    g       = 1 / sqrt(N * Qp)
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, cast

import torch
from torch import Tensor, nn

from macram.quant.one_pass import Function, has_one_pass, in_one_pass
from macram.spec import IntFormat

MIN_STEP = 1e-8
"""Smallest step in force. An optimiser may push the parameter below it or below zero; codes do not."""


class LsqQuantizer(nn.Module):
    """Quantises a tensor to the codes of a format, with one learned step (or one per output channel).

    The step is NaN until `set_step` or a loaded state gives it a value: forgotten calibration shows at once.

    Args:
        code_format: range of the codes, for example s3 (-4..3) for weights and u3 (0..7) after a ReLU.
        step_shape: ``()`` for one step, ``(c_out, 1, 1, 1)`` for one per output channel of a weight.
        batched: the first axis is the batch and does not count in the gradient's N (activations).

    Attributes:
        observer: while set, called with the quantiser and each value, which then passes unquantised.
    """

    def __init__(self, code_format: IntFormat, *, step_shape: tuple[int, ...] = (), batched: bool) -> None:
        super().__init__()
        self.code_format = code_format
        self.batched = batched
        self.observer: Callable[[LsqQuantizer, Tensor], None] | None = None
        self.step = nn.Parameter(torch.full(step_shape, math.nan))

    @property
    def positive_step(self) -> Tensor:
        """The step in force: never below `MIN_STEP`."""
        return self.step.detach().clamp_min(MIN_STEP)

    def set_step(self, mean_abs: Tensor | float) -> None:
        """Sets the step to ``2 * mean|v| / sqrt(Qp)``, given the mean magnitude of what will be quantised.

        Raises:
            ValueError: ``mean_abs`` is not finite or not positive, so no step would fit.
        """
        mean = torch.as_tensor(mean_abs, dtype=torch.float64)
        if not bool((torch.isfinite(mean) & (mean > 0)).all()):
            raise ValueError(f"mean magnitude must be positive and finite, not {mean.min().item()}")
        with torch.no_grad():
            self.step.copy_(2.0 * mean / math.sqrt(self.code_format.hi))

    def forward(self, v: Tensor) -> Tensor:
        """Values -> the nearest representable values ``code * step``, same shape, differentiable."""
        if self.observer is not None:
            self.observer(self, v)
            return v
        lo, hi = self.code_format.lo, self.code_format.hi
        one_pass = self.batched and torch.is_grad_enabled() and has_one_pass(v)
        return cast(Tensor, _Lsq.apply(v, self.step, lo, hi, self.gradient_scale(v), one_pass))  # type: ignore[no-untyped-call]

    def gradient_scale(self, v: Tensor) -> float:
        """The factor g of the step's gradient for values like ``v``."""
        features = v.numel() // self.step.numel()
        if self.batched:
            features //= v.shape[0]
        return 1.0 / math.sqrt(features * self.code_format.hi)

    def to_codes(self, v: Tensor) -> Tensor:
        """Values -> int64 codes ``lo..hi``: exactly the codes that `forward` multiplies by the step."""
        codes = _codes(v.detach() / self.positive_step, self.code_format.lo, self.code_format.hi)
        return codes.to(torch.int64)

    def extra_repr(self) -> str:
        """Format and step, for ``print(module)``."""
        steps = f"step={self.step.item():.4g}" if self.step.numel() == 1 else f"steps={self.step.numel()}"
        return f"{self.code_format}, {steps}"


def _codes(q: Tensor, lo: int, hi: int) -> Tensor:
    return q.clamp(lo, hi).round()


class _Lsq(torch.autograd.Function):
    @staticmethod
    def forward(ctx: Any, v: Tensor, step: Tensor, lo: int, hi: int, scale: float, one_pass: bool) -> Tensor:
        positive = step.clamp_min(MIN_STEP)
        ctx.save_for_backward(v, positive)
        ctx.bounds, ctx.scale, ctx.one_pass = (lo, hi), scale, one_pass
        return _called(one_pass, _quantised, (v,), positive, lo, hi)[0]

    @staticmethod
    def backward(ctx: Any, *grads: Tensor) -> tuple[Tensor | None, ...]:
        v, step = ctx.saved_tensors
        grad_v, to_step = _called(ctx.one_pass, _gradients, (v, *grads), step, *ctx.bounds)
        return grad_v, to_step.sum_to_size(step.shape) * ctx.scale, None, None, None, None


def _called(one_pass: bool, function: Function, maps: tuple[Tensor, ...], *others: Any) -> tuple[Tensor, ...]:
    return in_one_pass(function, maps, *others) if one_pass else function(*maps, *others)


def _quantised(v: Tensor, step: Tensor, lo: int, hi: int) -> tuple[Tensor]:
    return (_codes(v / step, lo, hi) * step,)


def _gradients(v: Tensor, grad: Tensor, step: Tensor, lo: int, hi: int) -> tuple[Tensor, Tensor]:
    """Of the value, and what adds up to that of the step."""
    q = v / step
    inside = (q > lo) & (q < hi)
    slope = torch.where(inside, q.round() - q, q.clamp(lo, hi))
    return grad * inside, grad * slope
