"""The float network that a quantised one imitates: knowledge distillation on the features that the head reads.

Few bits need many pictures if the labels alone teach them: ten cells of a picture carry a pose. A teacher speaks of
every cell and channel. LSQ trained this way too (Esser et al. 2020), on class scores; a pose network's
features say more (FitNets, Romero et al. 2015).
"""

from __future__ import annotations

from pathlib import Path

import torch
from torch import Tensor

from macram.model import SpaceNet
from macram.train.checkpoint import Card, load_model
from macram.train.fused import fuse_batch_norm


class Teacher:
    """A float network, frozen, in evaluation mode.

    Args:
        path: its ``model.safetensors``.
        student: the network that imitates it.
        target: card of the student.
        device: of the student.

    Raises:
        ValueError: no such network, a quantised one, one of another target, or one with other features than
            ``student``.
    """

    def __init__(self, path: Path, student: SpaceNet, target: Card, device: torch.device) -> None:
        self.net, card = load_model(path)
        if card.mode:
            raise ValueError(f"{path}: is quantised; set quant.teacher to a float network")
        if card.keypoints != target.keypoints:
            raise ValueError(
                f"{path}: has the keypoints of {card.target!r}, the network those of {target.target!r}"
            )
        theirs, mine = self.net.config.pyramid, student.config.pyramid
        if theirs != mine:
            raise ValueError(
                f"{path}: its pyramid has {theirs} channels, that of the network {mine}; set quant.teacher to a "
                "network of the same size"
            )
        self.net.requires_grad_(False).eval()
        self.net.to(device).to(memory_format=torch.channels_last)  # type: ignore[call-overload]
        fuse_batch_norm(self.net, device)

    @torch.no_grad()
    def features(self, image: Tensor) -> tuple[Tensor, ...]:
        """``[N, 3, H, W]`` -> what the head would read, P3 to P7."""
        return self.net.features(image).direct
