"""Batch normalisation as fast as the device at hand allows."""

from __future__ import annotations

import importlib.util

import torch
from torch import nn

from macram.train import few_channels, norm_relu


def fuse_batch_norm(module: nn.Module, device: torch.device) -> None:
    """Changes every batch normalisation in ``module``, which is on ``device``, in place."""
    if device.type == "cpu":
        few_channels.widen_batch_norm(module)
        norm_relu.fuse_batch_norm(module)
    elif importlib.util.find_spec("triton") is not None:
        from macram.train import norm_relu_gpu  # noqa: PLC0415  nothing but PyTorch for CUDA brings Triton

        norm_relu_gpu.fuse_batch_norm(module)
