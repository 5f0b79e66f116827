"""Batch normalisation and ReLU as one operation on the CPU, in fewer passes over memory than as two.

Together PyTorch's kernels move 14 maps through memory in a training step: six forward, eight backward. The ones
in ``norm_relu.cpp`` move eight, and keep one map for the backward pass instead of two. In a frozen backbone they
move two or three instead of five to seven. On a GPU `macram.train.norm_relu_gpu` does the same while training.
"""

from __future__ import annotations

from typing import Any, cast

import torch
from torch import Tensor, nn
from torch.autograd.function import once_differentiable

from macram.model.backbone import summed
from macram.train.compiled import call, library
from macram.train.distributed import follow_statistics
from macram.train.few_channels import WideBatchNorm2d

KERNELS = {torch.bfloat16: "bfloat16", torch.float32: "float32"}


class _NormRelu(torch.autograd.Function):
    """Training-mode batch normalisation and ReLU of a map, and the sum with another."""

    @staticmethod
    def forward(
        ctx: Any, x: Tensor, plus: Tensor | None, weight: Tensor, bias: Tensor, eps: float
    ) -> tuple[Tensor, Tensor, Tensor]:
        x = x.contiguous(memory_format=torch.channels_last)
        y, mean, variance = torch.empty_like(x), torch.empty_like(weight), torch.empty_like(weight)
        if plus is not None:
            plus = plus.contiguous(memory_format=torch.channels_last)
        _call("forward", x, x, plus, y, weight, bias, eps, mean, variance)
        ctx.save_for_backward(x, weight, bias, mean, variance)
        ctx.eps = eps
        ctx.mark_non_differentiable(mean, variance)
        return y, mean, variance

    @staticmethod
    @once_differentiable
    def backward(ctx: Any, *grads: Tensor) -> tuple[Tensor | None, ...]:
        x, weight, bias, mean, variance = ctx.saved_tensors
        grad = grads[0].contiguous(memory_format=torch.channels_last)
        to_x, to_weight, to_bias = torch.empty_like(x), torch.empty_like(weight), torch.empty_like(bias)
        _call("backward", x, grad, x, to_x, weight, bias, mean, variance, ctx.eps, to_weight, to_bias)
        return to_x, grads[0] if ctx.needs_input_grad[1] else None, to_weight, to_bias, None


def _call(function: str, x: Tensor, *arguments: Tensor | float | None) -> None:
    """Calls a function of ``norm_relu.cpp`` for maps like ``x``: rows, channels, threads, then ``arguments``."""
    rows, channels = x.numel() // x.shape[1], x.shape[1]
    call("norm_relu", f"{function}_{KERNELS[x.dtype]}", rows, channels, torch.get_num_threads(), *arguments)


class RectifyingBatchNorm2d(WideBatchNorm2d):
    """Batch normalisation that can apply the ReLU behind it too."""

    def rectified(self, input: Tensor, plus: Tensor | None = None) -> Tensor:
        """``relu(self(input)) + plus``, ``[N, C, H, W]``: in one go in bfloat16 or float32.

        In evaluation mode only where no gradient is wanted, as in a frozen backbone.
        """
        count = input.numel() // input.shape[1]
        possible = count > 1 if self.training else self._constant(input, plus)
        possible = possible and input.dtype in KERNELS and self.weight.dtype == torch.float32
        if not possible or (plus is not None and (plus.shape, plus.dtype) != (input.shape, input.dtype)):
            return summed(torch.relu(self(input)), plus)
        if not self.training:
            return self._applied(input, plus)
        result, mean, variance = _NormRelu.apply(  # type: ignore[no-untyped-call]
            input, plus, self.weight, self.bias, self.eps
        )
        follow_statistics(self, mean, variance, count)
        return cast(Tensor, result)

    def _constant(self, input: Tensor, plus: Tensor | None) -> bool:
        """Whether nothing here is differentiated, and running statistics in float32 are kept."""
        used = [tensor for tensor in (input, plus, self.weight, self.bias) if tensor is not None]
        wanted = torch.is_grad_enabled() and any(tensor.requires_grad for tensor in used)
        kept = self.running_mean is not None and self.running_mean.dtype == torch.float32
        return kept and not wanted

    def _applied(self, input: Tensor, plus: Tensor | None) -> Tensor:
        """With the running statistics."""
        x = input.contiguous(memory_format=torch.channels_last)
        if plus is not None:
            plus = plus.contiguous(memory_format=torch.channels_last)
        y = torch.empty_like(x)
        statistics = self.running_mean, self.running_var
        _call("apply", x, x, plus, y, self.weight, self.bias, *statistics, self.eps)
        return y


def fuse_batch_norm(module: nn.Module) -> None:
    """Lets every batch normalisation in ``module`` take the ReLU behind it along, where that can be compiled."""
    if library("norm_relu") is None:
        return
    for layer in module.modules():
        if type(layer) in (nn.BatchNorm2d, WideBatchNorm2d):
            # The same parameters, names and state under another forward, as for several processes.
            layer.__class__ = RectifyingBatchNorm2d
