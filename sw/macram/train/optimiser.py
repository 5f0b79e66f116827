"""The optimiser, and the moving average of the weights."""

from __future__ import annotations

import torch
from torch import nn

from macram.train.settings import OptimiserSettings


def make_optimiser(settings: OptimiserSettings, parameters: list[nn.Parameter]) -> torch.optim.Optimizer:
    """The optimiser of ``parameters``, which are where they will be trained.

    Fused: one pass over all parameters instead of a dozen operations for each of hundreds.
    """
    if settings.kind == "sgd":
        return torch.optim.SGD(
            parameters,
            settings.lr,
            momentum=settings.momentum,
            weight_decay=settings.weight_decay,
            nesterov=settings.momentum > 0,
            fused=True,
        )
    groups = [
        {"params": [p for p in parameters if p.ndim > 1], "weight_decay": settings.weight_decay},
        {"params": [p for p in parameters if p.ndim <= 1], "weight_decay": 0.0},
    ]
    return torch.optim.AdamW(groups, settings.lr, betas=(settings.momentum, 0.999), fused=True)


class Follower:
    """Moves a copy of a network a little towards it after each step: weights and running statistics.

    The tensors are looked up once: a walk through the modules per step would take longer than the moving.

    Args:
        average: the copy, changed in place.
        net: its original. Both must keep their tensors, as optimiser steps and `load_state_dict` do.
    """

    def __init__(self, average: nn.Module, net: nn.Module) -> None:
        pairs = list(zip(average.state_dict().values(), net.state_dict().values(), strict=True))
        self.floats = [pair for pair in pairs if pair[0].is_floating_point()]
        self.counts = [pair for pair in pairs if not pair[0].is_floating_point()]

    @torch.no_grad()
    def follow(self, decay: float, step: int) -> None:
        """Takes one step.

        Args:
            decay: share that stays.
            step: steps so far. Young averages forget faster, else the first random weights would stay long.
        """
        weight = 1 - min(decay, (1 + step) / (10 + step))
        torch._foreach_lerp_([a for a, _ in self.floats], [b for _, b in self.floats], weight)
        if self.counts:
            torch._foreach_copy_([a for a, _ in self.counts], [b for _, b in self.counts])
