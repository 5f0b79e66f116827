"""Batch normalisation as fast as the device at hand allows."""

from __future__ import annotations

import torch
from torch import nn

from macram.quant.one_pass import compiles_kernels
from macram.train import few_channels, norm_relu


def fuse_batch_norm(module: nn.Module, device: torch.device) -> None:
    """Changes every batch normalisation in ``module``, which is on ``device``, in place."""
    if device.type == "cpu":
        few_channels.widen_batch_norm(module)
        norm_relu.fuse_batch_norm(module)
    elif compiles_kernels():
        # Nothing but PyTorch for CUDA brings Triton.
        from macram.train import norm_relu_gpu  # noqa: PLC0415

        norm_relu_gpu.fuse_batch_norm(module)
