"""Batch normalisation and ReLU as one operation on a GPU, in Triton, which PyTorch for CUDA brings along.

A map is taken as rows of channels, whose number must be a power of two. For sums each program takes every so many
rows and leaves a partial sum; results do not depend on the order in which the GPU works.
"""

from __future__ import annotations

from typing import Any

import torch
import triton
import triton.language as tl
from torch import Tensor, nn
from torch.autograd.function import once_differentiable

from macram.model.backbone import summed
from macram.train.distributed import follow_statistics

TILE = 4096
"""Elements that a program takes at a time."""
PROGRAMS = 512
"""Most programs that share a sum: about four for each multiprocessor of a large GPU."""
CHANNELS = 16
"""Channels for which one program adds up the partial sums."""


def forward(x: Tensor, weight: Tensor, bias: Tensor, eps: float) -> tuple[Tensor, Tensor]:
    """``[N, C, H, W]``, channels last -> ``relu(norm(x))``, and float32 ``[4, C]``.

    Its rows: mean and variance of the batch, and slope and offset with which ``y = relu(slope * x + offset)``.
    """
    rows, channels, tile, programs = _work(x)
    parts = torch.empty((2, programs, channels), dtype=torch.float32, device=x.device)
    stats = torch.empty((4, channels), dtype=torch.float32, device=x.device)
    _moments[(programs,)](x, parts, rows, channels, tile)
    one = min(CHANNELS, channels)
    padded = triton.next_power_of_2(programs)
    _finish_moments[(channels // one,)](
        parts, x, weight, bias, stats, rows, programs, eps, channels, one, padded
    )
    y = torch.empty_like(x)
    _rectify[(programs,)](x, y, stats, rows, channels, tile)
    return y, stats


def backward(
    grad: Tensor, x: Tensor, weight: Tensor, stats: Tensor, eps: float
) -> tuple[Tensor, Tensor, Tensor]:
    """Gradients of x, weight and bias, given that of y, ``[N, C, H, W]``, channels last, and `forward`'s stats."""
    rows, channels, tile, programs = _work(x)
    parts = torch.empty((2, programs, channels), dtype=torch.float32, device=x.device)
    factors = torch.empty((2, channels), dtype=torch.float32, device=x.device)
    to_weight, to_bias = torch.empty_like(weight), torch.empty_like(weight)
    _gradient_moments[(programs,)](grad, x, stats, parts, rows, channels, tile)
    one = min(CHANNELS, channels)
    padded = triton.next_power_of_2(programs)
    _finish_gradients[(channels // one,)](
        parts, stats, factors, to_weight, to_bias, rows, programs, eps, channels, one, padded
    )
    to_x = torch.empty_like(x)
    _spread[(programs,)](grad, x, stats, factors, to_x, rows, channels, tile)
    return to_x, to_weight, to_bias


def _work(x: Tensor) -> tuple[int, int, int, int]:
    """Rows, channels, rows a tile, programs."""
    channels = x.shape[1]
    rows, tile = x.numel() // channels, TILE // channels
    return rows, channels, tile, min(PROGRAMS, triton.cdiv(rows, tile))


class _NormRelu(torch.autograd.Function):
    """Training-mode batch normalisation and ReLU of a map."""

    @staticmethod
    def forward(
        ctx: Any, x: Tensor, weight: Tensor, bias: Tensor, eps: float
    ) -> tuple[Tensor, Tensor, Tensor]:
        x = x.contiguous(memory_format=torch.channels_last)
        y, stats = forward(x, weight, bias, eps)
        ctx.save_for_backward(x, weight, stats)
        ctx.eps = eps
        mean, variance = stats[0], stats[1]
        ctx.mark_non_differentiable(mean, variance)
        return y, mean, variance

    @staticmethod
    @once_differentiable  # type: ignore[untyped-decorator]
    def backward(ctx: Any, *grads: Tensor) -> tuple[Tensor | None, ...]:
        x, weight, stats = ctx.saved_tensors
        grad = grads[0].contiguous(memory_format=torch.channels_last)
        return (*backward(grad, x, weight, stats, ctx.eps), None)


class RectifyingBatchNorm2d(nn.BatchNorm2d):
    """Batch normalisation that can apply the ReLU behind it too."""

    def rectified(self, input: Tensor, plus: Tensor | None = None) -> Tensor:
        """``relu(self(input)) + plus``, ``[N, C, H, W]``: normalised and rectified in one go while training."""
        count = input.numel() // input.shape[1]
        if not self.training or count == 1:  # one value has no variance: PyTorch's layer says so
            return summed(torch.relu(self(input)), plus)
        y, mean, variance = _NormRelu.apply(input, self.weight, self.bias, self.eps)  # type: ignore[no-untyped-call]
        follow_statistics(self, mean, variance, count)
        return summed(y, plus)


def fuse_batch_norm(module: nn.Module) -> None:
    """Lets batch normalisations in ``module`` of suitable width take the ReLU behind them along."""
    for layer in module.modules():
        if (
            type(layer) is nn.BatchNorm2d
            and layer.num_features.bit_count() == 1
            and layer.num_features <= TILE
        ):
            # The same parameters, names and state under another forward, as for several processes.
            layer.__class__ = RectifyingBatchNorm2d


@triton.jit
def _moments(x, parts, rows, channels: tl.constexpr, tile: tl.constexpr):
    program, programs = tl.program_id(0), tl.num_programs(0)
    channel = tl.arange(0, channels)
    row = tl.arange(0, tile)[:, None]
    place = row * channels + channel[None, :]
    # Sums of squares lose the variance of a channel far from zero; so they are taken about one of its values.
    pivot = tl.load(x + channel).to(tl.float32)[None, :]
    first = tl.zeros((tile, channels), tl.float32)
    second = tl.zeros((tile, channels), tl.float32)
    for start in range(program * tile, rows, programs * tile):
        begin = tl.cast(start, tl.int64) * channels
        inside = row < rows - start
        value = tl.load(x + begin + place, mask=inside, other=0.0).to(tl.float32)
        value = tl.where(inside, value - pivot, 0.0)
        first += value
        second += value * value
    tl.store(parts + program * channels + channel, tl.sum(first, 0))
    tl.store(parts + (programs + program) * channels + channel, tl.sum(second, 0))


@triton.jit
def _finish_moments(
    parts, x, weight, bias, stats, rows, programs, eps,
    channels: tl.constexpr, one: tl.constexpr, padded: tl.constexpr,
):  # fmt: skip
    channel = tl.program_id(0) * one + tl.arange(0, one)
    first, second = _totals(parts, programs, channel, channels, padded)
    first, second = first / rows, second / rows
    mean = tl.load(x + channel).to(tl.float32) + first
    variance = tl.maximum(second - first * first, 0.0)
    slope = tl.load(weight + channel) / tl.sqrt(variance + eps)
    tl.store(stats + channel, mean)
    tl.store(stats + channels + channel, variance)
    tl.store(stats + 2 * channels + channel, slope)
    tl.store(stats + 3 * channels + channel, tl.load(bias + channel) - mean * slope)


@triton.jit
def _totals(parts, programs, channel, channels: tl.constexpr, padded: tl.constexpr):
    program = tl.arange(0, padded)[:, None]
    place = parts + program * channels + channel[None, :]
    inside = program < programs
    first = tl.sum(tl.load(place, mask=inside, other=0.0), 0)
    second = tl.sum(tl.load(place + programs * channels, mask=inside, other=0.0), 0)
    return first, second


@triton.jit
def _rectify(x, y, stats, rows, channels: tl.constexpr, tile: tl.constexpr):
    channel = tl.arange(0, channels)
    row = tl.arange(0, tile)[:, None]
    place = row * channels + channel[None, :]
    slope = tl.load(stats + 2 * channels + channel)[None, :]
    offset = tl.load(stats + 3 * channels + channel)[None, :]
    for start in range(tl.program_id(0) * tile, rows, tl.num_programs(0) * tile):
        begin = tl.cast(start, tl.int64) * channels
        inside = row < rows - start
        value = tl.load(x + begin + place, mask=inside, other=0.0).to(tl.float32)
        value = tl.maximum(slope * value + offset, 0.0)
        tl.store(y + begin + place, value.to(y.dtype.element_ty), mask=inside)


@triton.jit
def _gradient_moments(grad, x, stats, parts, rows, channels: tl.constexpr, tile: tl.constexpr):
    program, programs = tl.program_id(0), tl.num_programs(0)
    channel = tl.arange(0, channels)
    row = tl.arange(0, tile)[:, None]
    place = row * channels + channel[None, :]
    mean = tl.load(stats + channel)[None, :]
    slope = tl.load(stats + 2 * channels + channel)[None, :]
    offset = tl.load(stats + 3 * channels + channel)[None, :]
    first = tl.zeros((tile, channels), tl.float32)
    second = tl.zeros((tile, channels), tl.float32)
    for start in range(program * tile, rows, programs * tile):
        begin = tl.cast(start, tl.int64) * channels
        inside = row < rows - start
        value = tl.load(x + begin + place, mask=inside, other=0.0).to(tl.float32)
        passed = tl.load(grad + begin + place, mask=inside, other=0.0).to(tl.float32)
        passed = tl.where(slope * value + offset > 0, passed, 0.0)
        first += passed
        second += passed * (value - mean)
    tl.store(parts + program * channels + channel, tl.sum(first, 0))
    tl.store(parts + (programs + program) * channels + channel, tl.sum(second, 0))


@triton.jit
def _finish_gradients(
    parts, stats, factors, to_weight, to_bias, rows, programs, eps,
    channels: tl.constexpr, one: tl.constexpr, padded: tl.constexpr,
):  # fmt: skip
    channel = tl.program_id(0) * one + tl.arange(0, one)
    first, second = _totals(parts, programs, channel, channels, padded)
    inverse = 1.0 / tl.sqrt(tl.load(stats + channels + channel) + eps)
    slope = tl.load(stats + 2 * channels + channel)
    tl.store(to_weight + channel, second * inverse)
    tl.store(to_bias + channel, first)
    tl.store(factors + channel, slope * inverse * inverse * second / rows)
    tl.store(factors + channels + channel, slope * first / rows)


@triton.jit
def _spread(grad, x, stats, factors, to_x, rows, channels: tl.constexpr, tile: tl.constexpr):
    channel = tl.arange(0, channels)
    row = tl.arange(0, tile)[:, None]
    place = row * channels + channel[None, :]
    mean = tl.load(stats + channel)[None, :]
    slope = tl.load(stats + 2 * channels + channel)[None, :]
    offset = tl.load(stats + 3 * channels + channel)[None, :]
    tilt = tl.load(factors + channel)[None, :]
    shift = tl.load(factors + channels + channel)[None, :]
    for start in range(tl.program_id(0) * tile, rows, tl.num_programs(0) * tile):
        begin = tl.cast(start, tl.int64) * channels
        inside = row < rows - start
        value = tl.load(x + begin + place, mask=inside, other=0.0).to(tl.float32)
        passed = tl.load(grad + begin + place, mask=inside, other=0.0).to(tl.float32)
        passed = tl.where(slope * value + offset > 0, passed, 0.0)
        result = slope * passed - tilt * (value - mean) - shift
        tl.store(to_x + begin + place, result.to(to_x.dtype.element_ty), mask=inside)
