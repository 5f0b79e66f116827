"""Quantisers of activations while training on the CPU, one pass over memory each way, in C++.

PyTorch's operations read and write a map a dozen times for the same. On a GPU `macram.quant.one_pass` does it.
"""

from __future__ import annotations

from typing import Any, cast

import torch
from torch import Tensor, nn
from torch.autograd.function import once_differentiable

from macram.quant.lsq import MIN_STEP, LsqQuantizer
from macram.train.compiled import call, library
from macram.train.norm_relu import KERNELS


class _Lsq(torch.autograd.Function):
    """As `macram.quant.lsq` says, in float32 inside whatever the map's numbers are."""

    @staticmethod
    def forward(ctx: Any, v: Tensor, step: Tensor, bounds: tuple[int, int], scale: float) -> Tensor:
        v = v.contiguous(memory_format=torch.channels_last)
        positive, y = step.clamp_min(MIN_STEP), torch.empty_like(v)
        ctx.save_for_backward(v, positive)
        ctx.bounds, ctx.scale = bounds, scale
        _call("quantise", v, y, positive, bounds=bounds)
        return y

    @staticmethod
    @once_differentiable
    def backward(ctx: Any, *grads: Tensor) -> tuple[Tensor | None, ...]:
        v, step = ctx.saved_tensors
        grad = grads[0].contiguous(memory_format=torch.channels_last)
        to_v, to_step = torch.empty_like(v), torch.empty_like(step)
        _call("gradients", v, grad, to_v, to_step, step, bounds=ctx.bounds)
        return to_v, to_step * ctx.scale, None, None


def _call(function: str, *tensors: Tensor, bounds: tuple[int, int]) -> None:
    """Calls a function of ``lsq.cpp`` for maps of one shape and layout, the first of ``tensors``, and for steps."""
    v, (low, high) = tensors[0], bounds
    kernel = f"{function}_{KERNELS[v.dtype]}"
    call("lsq", kernel, v.numel(), torch.get_num_threads(), *tensors, float(low), float(high))


class CpuQuantizer(LsqQuantizer):
    """A quantiser of activations that is one pass each way while training."""

    def forward(self, v: Tensor) -> Tensor:
        """As `LsqQuantizer.forward`. In float32 the step's gradient alone is rounded otherwise.

        Of bfloat16, which PyTorch's operations round at each step, results alone are rounded here.
        """
        possible = v.device.type == "cpu" and v.dtype in KERNELS and self.step.dtype == torch.float32
        possible = possible and v.dim() == 4 and v.numel() > 0
        if self.observer is not None or not torch.is_grad_enabled() or not possible:
            return super().forward(v)
        bounds = self.code_format.lo, self.code_format.hi
        return cast(Tensor, _Lsq.apply(v, self.step, bounds, self.gradient_scale(v)))  # type: ignore[no-untyped-call]


def fuse_quantizers(module: nn.Module) -> None:
    """Lets every quantiser of activations in ``module`` take one pass, where that can be compiled."""
    if library("lsq") is None:
        return
    for layer in module.modules():
        if type(layer) is LsqQuantizer and layer.batched and layer.step.dim() == 0:
            # The same parameters, names and state under another forward, as for batch normalisation.
            layer.__class__ = CpuQuantizer
