"""The optimiser, and the moving average of the weights."""

from __future__ import annotations

import torch
from torch import nn

from macram.train.config import OptimiserSettings


def make_optimiser(settings: OptimiserSettings, parameters: list[nn.Parameter]) -> torch.optim.Optimizer:
    """The optimiser of ``parameters``, which are where they will be trained."""
    fused = parameters[0].is_cuda  # hundreds of small launches less
    if settings.kind == "sgd":
        return torch.optim.SGD(
            parameters,
            settings.lr,
            momentum=settings.momentum,
            weight_decay=settings.weight_decay,
            nesterov=settings.momentum > 0,
            fused=fused,
        )
    groups = [
        {"params": [p for p in parameters if p.ndim > 1], "weight_decay": settings.weight_decay},
        {"params": [p for p in parameters if p.ndim <= 1], "weight_decay": 0.0},
    ]
    return torch.optim.AdamW(groups, settings.lr, betas=(settings.momentum, 0.999), fused=fused)


def follow(average: nn.Module, net: nn.Module, decay: float, step: int) -> None:
    """Moves ``average``, a copy of ``net``, a little towards it: weights and running statistics.

    Args:
        average: changed in place.
        net: after its optimiser step.
        decay: share that stays.
        step: steps so far. Young averages forget faster, else the first random weights would stay for long.
    """
    weight = 1 - min(decay, (1 + step) / (10 + step))
    with torch.no_grad():
        pairs = list(zip(average.state_dict().values(), net.state_dict().values(), strict=True))
        floats = [(a, b) for a, b in pairs if a.is_floating_point()]
        torch._foreach_lerp_([a for a, _ in floats], [b for _, b in floats], weight)
        for a, b in pairs:
            if not a.is_floating_point():
                a.copy_(b)
