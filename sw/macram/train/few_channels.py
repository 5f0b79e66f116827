"""Batch normalisation of few channels on the CPU, as fast as that of many.

PyTorch's kernels take the channels of a pixel as one vector. Fewer channels than a vector holds run element by
element: eight bfloat16 channels at a tenth of the memory's speed. Here several neighbouring pixels are taken as
one pixel of more channels; the statistics of the copies are merged afterwards.
"""

from __future__ import annotations

from typing import Any, cast

import torch
from torch import Tensor, nn

from macram.train.distributed import follow_statistics

VECTOR = 64
"""Channels taken as one pixel. Layers of more than a quarter of them are faster in PyTorch's own kernels."""


class _Widened(torch.autograd.Function):
    """Training-mode batch normalisation of a map of many channels, each `copies` times.

    Gradients follow Ioffe and Szegedy, "Batch Normalization" (2015), section 3, with the sums taken over all
    copies of a channel.
    """

    @staticmethod
    def forward(
        ctx: Any, x: Tensor, weight: Tensor, bias: Tensor, copies: int, eps: float
    ) -> tuple[Tensor, Tensor, Tensor]:
        unused = weight.new_zeros(2, x.shape[1])  # without, statistics of bfloat16 would come in bfloat16
        means, variances = torch.ops.aten.batch_norm_update_stats(x, *unused, 0.0)
        means, variances = means.view(copies, -1), variances.view(copies, -1)
        mean = means.mean(0)
        variance = variances.mean(0) + (means - mean).square().mean(0)
        ctx.save_for_backward(x, weight, mean, variance)
        ctx.copies, ctx.eps = copies, eps
        y = _scaled(x, weight, bias, mean, variance, copies, eps)
        ctx.mark_non_differentiable(mean, variance)
        return y, mean, variance

    @staticmethod
    def backward(ctx: Any, *grads: Tensor) -> tuple[Tensor | None, ...]:
        x, weight, mean, variance = ctx.saved_tensors
        copies, eps = ctx.copies, ctx.eps
        grad = grads[0].contiguous(memory_format=torch.channels_last)
        spread = [value.repeat(copies) for value in (weight, mean, variance)]
        _, to_weight, to_bias = torch.ops.aten.native_batch_norm_backward(
            grad, x, *spread, None, None, False, eps, [False, True, True]
        )
        to_weight = to_weight.view(copies, -1).sum(0)
        to_bias = to_bias.view(copies, -1).sum(0)
        count = x.numel() / weight.numel()
        scale = weight * (variance + eps).rsqrt()
        # scale * (grad - to_bias / count - normalised * to_weight / count), each half in one pass.
        zero, one = torch.zeros_like(mean), torch.ones_like(mean)
        to_x = _scaled(grad, scale, -scale * to_bias / count, zero, one, copies, 0.0)
        to_x -= _scaled(x, scale * to_weight / count, zero, mean, variance, copies, eps)
        return to_x, to_weight, to_bias, None, None


def _scaled(
    x: Tensor, weight: Tensor, bias: Tensor, mean: Tensor, variance: Tensor, copies: int, eps: float
) -> Tensor:
    """``weight * (x - mean) / sqrt(variance + eps) + bias``, channel by channel, in one pass over ``x``."""
    weight, bias, mean, variance = (value.repeat(copies) for value in (weight, bias, mean, variance))
    y, _, _ = torch.native_batch_norm(x, weight, bias, mean, variance, False, 0.0, eps)
    return y


class WideBatchNorm2d(nn.BatchNorm2d):
    """Batch normalisation that takes ``VECTOR / channels`` neighbouring pixels at a time while training."""

    def forward(self, input: Tensor) -> Tensor:
        """``[N, C, H, W]`` -> the same shape. ``H * W`` must be a multiple of the pixels taken at a time."""
        n, c, h, w = input.shape
        copies = VECTOR // c
        if not self.training or 4 * c > VECTOR or h * w % copies:
            return super().forward(input)
        rows = input.permute(0, 2, 3, 1).contiguous().view(n, -1, 1, copies * c)
        y, mean, variance = _Widened.apply(  # type: ignore[no-untyped-call]
            rows.permute(0, 3, 1, 2), self.weight, self.bias, copies, self.eps
        )
        follow_statistics(self, mean, variance, n * h * w)
        return cast(Tensor, y.permute(0, 2, 3, 1).view(n, h, w, c).permute(0, 3, 1, 2))


def widen_batch_norm(module: nn.Module) -> None:
    """Turns every batch normalisation of few channels in ``module`` into a `WideBatchNorm2d`, in place."""
    for layer in module.modules():
        if type(layer) is nn.BatchNorm2d and 4 * layer.num_features <= VECTOR:
            # The same parameters, names and state under another forward, as for several processes.
            layer.__class__ = WideBatchNorm2d
