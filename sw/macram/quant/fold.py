"""Folding batch normalisation, activation scales and the next step into one scale and offset per channel.

The convolution of codes gives an integer ``acc``; its value is ``acc * s_w * s_a``. Batch normalisation
makes that ``gamma * (acc * s_w * s_a - mu) / sigma + beta`` and the next quantiser divides by its step
``s_out``. So::

    code  = clip(rint(scale * acc + offset), lo, hi)
    scale  = gamma * s_w * s_a / (sigma * s_out)
    offset = (beta - mu * gamma / sigma) / s_out

A ReLU in between needs no extra work: it is the clip at 0 of an unsigned code.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import torch
from numpy.typing import NDArray
from torch import nn


class Affine(NamedTuple):
    """Requantisation of one layer: float64 ``scale`` and ``offset``, ``[c_out]``, of either sign or zero."""

    scale: NDArray[np.float64]
    offset: NDArray[np.float64]


def fold_batch_norm(
    bn: nn.BatchNorm2d, weight_step: torch.Tensor, input_step: torch.Tensor, output_step: torch.Tensor
) -> Affine:
    """Scale and offset of the codes that follow ``bn`` in evaluation mode, computed in float64.

    Args:
        bn: batch normalisation with running statistics and affine parameters.
        weight_step: one step, or ``[c_out, 1, 1, 1]`` steps.
        input_step: the step of the convolution's input codes.
        output_step: the step of the next quantiser.

    Raises:
        ValueError: a step is not positive and finite, or the batch normalisation holds something not finite.
    """
    if bn.running_mean is None or bn.running_var is None:
        raise ValueError("batch normalisation must keep running statistics (track_running_stats=True)")
    s_w, s_a, s_out = _steps(weight=weight_step, input=input_step, output=output_step)
    gamma, beta, mu, var = (
        tensor.detach().to(torch.float64).cpu().numpy()
        for tensor in (bn.weight, bn.bias, bn.running_mean, bn.running_var)
    )
    sigma = np.sqrt(var + bn.eps)
    scale = gamma * s_w * s_a / (sigma * s_out)
    offset = (beta - mu * gamma / sigma) / s_out
    if not (np.isfinite(scale).all() and np.isfinite(offset).all()):
        raise ValueError("folded scale and offset must be finite; check the batch-normalisation parameters")
    return Affine(scale, offset)


def fold_bias(
    bias: torch.Tensor, weight_step: torch.Tensor, input_step: torch.Tensor, output_step: torch.Tensor
) -> Affine:
    """Scale and offset behind a convolution with ``bias``, ``[c_out]``, and no normalisation, in float64.

    Arguments and errors as for `fold_batch_norm`; an output step of 1 gives values instead of codes.
    """
    s_w, s_a, s_out = _steps(weight=weight_step, input=input_step, output=output_step)
    offset = bias.detach().to(torch.float64).cpu().numpy() / s_out
    if not np.isfinite(offset).all():
        raise ValueError("bias must be finite; check the parameters")
    return Affine(np.broadcast_to(s_w * s_a / s_out, offset.shape).copy(), offset)


def _steps(**steps: torch.Tensor) -> list[NDArray[np.float64]]:
    values = [step.detach().to(torch.float64).cpu().reshape(-1).numpy() for step in steps.values()]
    for name, step in zip(steps, values, strict=True):
        if not (np.isfinite(step).all() and (step > 0).all()):
            raise ValueError(f"{name} step must be positive and finite, not {step.min()}; calibrate first")
    return values
