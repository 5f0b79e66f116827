"""Several processes on one batch: each takes its part, and all end up with one process's gradients."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, cast

import torch
import torch.distributed as dist
from torch import Tensor, nn


@dataclass(frozen=True, slots=True)
class Processes:
    """This process among all.

    Attributes:
        rank: number of this process.
        world: number of processes.
        device: that it works on.
    """

    rank: int
    world: int
    device: torch.device

    @property
    def first(self) -> bool:
        """Whether this process is the one that writes and prints."""
        return self.rank == 0

    def sum_gradients(self, parameters: Iterable[nn.Parameter]) -> None:
        """Adds up the gradients of all processes, in one message."""
        if self.world == 1:
            return
        gradients = [p.grad for p in parameters if p.grad is not None]
        flat = torch.cat([g.flatten() for g in gradients])
        dist.all_reduce(flat)
        for gradient, part in zip(gradients, torch.split(flat, [g.numel() for g in gradients]), strict=True):
            gradient.copy_(part.view_as(gradient))

    def from_first(self, value: float) -> float:
        """The first process's value, in all of them."""
        if self.world == 1:
            return value
        tensor = torch.tensor([value], dtype=torch.float64, device=self.device)
        dist.broadcast(tensor, 0)
        return float(tensor)

    def copy_first(self, module: nn.Module) -> None:
        """Gives every process the first one's weights: initialisation may differ in the last digit."""
        if self.world > 1:
            for tensor in module.state_dict().values():
                dist.broadcast(tensor, 0)

    def wait(self) -> None:
        """Until all are here."""
        if self.world > 1:
            dist.barrier()


def join_processes(device: str = "auto") -> Processes:
    """Joins the group that ``torchrun`` started; alone without it.

    Args:
        device: ``cpu``, ``cuda`` or ``auto``: a GPU per process if there is one.

    Raises:
        ValueError: cuda is asked for and not there.
    """
    if device == "cuda" and not torch.cuda.is_available():
        raise ValueError("no CUDA device here; use --device cpu")
    cuda = device != "cpu" and torch.cuda.is_available()
    local, world = int(os.environ.get("LOCAL_RANK", "0")), int(os.environ.get("WORLD_SIZE", "1"))
    place = torch.device("cuda", local) if cuda else torch.device("cpu")
    if cuda:
        torch.cuda.set_device(place)
    if world == 1:
        return Processes(0, 1, place)
    if not dist.is_initialized():
        dist.init_process_group("nccl" if cuda else "gloo")
    return Processes(dist.get_rank(), dist.get_world_size(), place)


def leave_processes() -> None:
    """Ends the group, if there is one."""
    if dist.is_available() and dist.is_initialized():
        dist.destroy_process_group()


class _Sum(torch.autograd.Function):
    """Sum over all processes: every process's loss depends on every summand, so gradients add up likewise."""

    @staticmethod
    def forward(ctx: Any, value: Tensor) -> Tensor:
        total = value.clone()
        dist.all_reduce(total)
        return total

    @staticmethod
    def backward(ctx: Any, *grads: Tensor) -> Tensor:
        total = grads[0].clone()
        dist.all_reduce(total)
        return total


def _summed(value: Tensor) -> Tensor:
    return cast(Tensor, _Sum.apply(value))  # type: ignore[no-untyped-call]


@torch.no_grad()
def follow_statistics(layer: nn.BatchNorm2d, mean: Tensor, variance: Tensor, count: Tensor | float) -> None:
    """Moves running statistics as PyTorch's own layer does, where the layer keeps them.

    Args:
        layer: in training mode.
        mean: of the batch, per channel.
        variance: of the batch, per channel, over ``count`` values (not one less).
        count: values per channel.
    """
    if not layer.track_running_stats or layer.running_mean is None or layer.running_var is None:
        return
    assert layer.num_batches_tracked is not None
    assert layer.momentum is not None
    layer.num_batches_tracked.add_(1)
    layer.running_mean.lerp_(mean, layer.momentum)
    layer.running_var.lerp_(variance * (count / (count - 1)), layer.momentum)


class SharedBatchNorm2d(nn.BatchNorm2d):
    """Batch normalisation whose training statistics are those of all processes' images.

    PyTorch's own works on GPUs only.
    """

    def forward(self, input: Tensor) -> Tensor:
        """``[N, C, H, W]`` -> the same shape."""
        if not self.training:
            return super().forward(input)
        x = input.float()
        sums = torch.cat((x.sum((0, 2, 3)), x.new_tensor([x.numel() / x.shape[1]])))
        sums = _summed(sums)
        count = sums[-1].detach()
        mean = sums[:-1] / count
        centred = x - mean[:, None, None]
        variance = _summed(centred.square().sum((0, 2, 3))) / count
        follow_statistics(self, mean, variance, count)
        scale = self.weight * (variance + self.eps).rsqrt()
        y: Tensor = centred * scale[:, None, None] + self.bias[:, None, None]
        return y.to(input.dtype)


def share_batch_norm(module: nn.Module) -> None:
    """Turns every batch normalisation in ``module`` into a `SharedBatchNorm2d`, in place."""
    for layer in module.modules():
        if type(layer) is nn.BatchNorm2d:
            # The same parameters, names and state under another forward; a new module would lose the sharing.
            layer.__class__ = SharedBatchNorm2d


def processor_name(device: torch.device) -> str:
    """What a run was computed on, in words."""
    return torch.cuda.get_device_name(device) if device.type == "cuda" else "CPU"
