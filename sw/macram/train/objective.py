"""Targets and losses of a whole batch, in tensors of constant shape: a GPU never waits for the host.

So nothing here asks for a value, and no number is put beside tensors in `torch.where`, which would copy it to the
GPU and wait: `macram.train.replay` records all of it.
"""

from __future__ import annotations

from collections.abc import Sequence

import torch
from torch import Tensor

from macram.model import Prediction, TrainingOutput
from macram.train.losses import (
    LossWeights,
    focal_loss,
    imitation_loss,
    object_space_loss,
    similarity_loss,
    surface_loss,
)
from macram.train.targets import BACKGROUND, IGNORED, MISSED, POSITIVE, QUOTA, surface_targets
from macram.train.warp import Batch, Cells

SLOTS = QUOTA + 2
"""Room for the positive cells of one picture: five rounded quotas of ten exceed it by two at most."""
PER_IMAGES = 8
"""Losses are sums over images, as published, for the published batch."""


def assign(batch: Batch, cells: Cells) -> Tensor:
    """Labels int8 ``[B, cells]``, drawn as `macram.train.targets.draw_labels` does, with the batch's keys."""
    ranked = batch.keys.masked_fill(~batch.inside, 2.0)
    positive = []
    for level, key in enumerate(torch.split(ranked, cells.counts, dim=1)):
        rank = key.argsort(dim=1, stable=True).argsort(dim=1, stable=True)
        positive.append(rank < batch.quota[:, level, None])
    drawn = torch.cat(positive, dim=1) & batch.inside
    labels = torch.full_like(batch.inside, BACKGROUND, dtype=torch.int8)
    return labels.masked_fill_(batch.inside, IGNORED).masked_fill_(drawn, POSITIVE)


class Objective:
    """The sum of the losses, ready for `backward`.

    Args:
        weights: factors.
        diameter: of the object, mm.
        keypoints: ``[K, 3]`` mm; their box is what the surface head is asked about.
    """

    def __init__(self, weights: LossWeights, diameter: float, keypoints: Tensor) -> None:
        self.weights, self.diameter = weights, diameter
        self.low, self.high = keypoints.float().amin(0), keypoints.float().amax(0)

    def factual(
        self, predictions: Sequence[Prediction], batch: Batch, cells: Cells, images: int, *, surface: bool
    ) -> dict[str, Tensor]:
        """Weighted losses of one set of predictions, by name.

        Args:
            predictions: of this process's part of the batch, P3 to P7.
            batch: that part.
            cells: of the views.
            images: in the whole batch. The parts' losses add up to those of the whole.
            surface: with the training-only head's.
        """
        labels = assign(batch, cells)
        logits = torch.cat([p.logits.flatten(1) for p in predictions], dim=1)
        slots, valid = positive_slots(labels)
        pixels = self._pixels(predictions, slots, cells)
        pixels = torch.where(valid[:, :, None, None], pixels, batch.pixels[:, None])
        scale = PER_IMAGES / images
        pose = object_space_loss(
            pixels.flatten(0, 1),
            _per_slot(batch.points),
            _per_slot(batch.camera),
            self.diameter,
            self.weights.pose_scale,
        )
        losses = {
            "class": self.weights.classes * scale * focal_loss(logits, labels),
            "pose": self.weights.pose * scale * pose,
        }
        if surface:
            outputs = [p.surface for p in predictions]
            assert outputs[0] is not None
            maps = torch.cat([o.flatten(2) for o in outputs if o is not None], dim=2)
            chosen = maps.gather(2, slots[:, None].expand(-1, maps.shape[1], -1)).mT.flatten(0, 1)
            faces, places = self._surface_targets(batch, slots, cells)
            faces = faces.masked_fill(~valid.flatten(), MISSED)
            losses["surface"] = self.weights.surface * scale * surface_loss(chosen, faces, places)
        return losses

    def three_paths(
        self, output: TrainingOutput, batch: Batch, cells: Cells, images: int, *, surface: bool
    ) -> dict[str, Tensor]:
        """Losses of the counterfactual stage: of the picture, of the imitation, of the ideal path."""
        losses = self.factual(output.predictions, batch, cells, images, surface=surface)
        # A mean over images, unlike the others.
        share = self.weights.similarity * len(batch.image) / images
        losses["similarity"] = share * similarity_loss(output.pseudo, output.counterfactual)
        if output.ideal is not None:
            ideal = self.factual(output.ideal, batch, cells, images, surface=False)
            losses["ideal"] = ideal["class"] + ideal["pose"]
        return losses

    def imitation(
        self, student: Sequence[Tensor], teacher: Sequence[Tensor], batch: Batch, cells: Cells, images: int
    ) -> Tensor:
        """Weighted loss of features that shall equal a teacher's: P3 to P7 of this process's part of the batch."""
        inside = torch.split(batch.inside, cells.counts, dim=1)
        # A mean over images.
        return self.weights.imitation / images * imitation_loss(student, teacher, inside)

    @staticmethod
    def _pixels(predictions: Sequence[Prediction], slots: Tensor, cells: Cells) -> Tensor:
        """Predicted keypoints of the chosen cells, ``[B, slots, K, 2]``."""
        maps = torch.cat([p.offsets.flatten(2) for p in predictions], dim=2)
        chosen = maps.gather(2, slots[:, None].expand(-1, maps.shape[1], -1)).float()
        pairs = chosen.reshape(len(slots), 2, -1, SLOTS).permute(0, 3, 2, 1)
        pixels: Tensor = pairs * cells.anchors[slots][:, :, None, None] + cells.centres[slots][:, :, None]
        return pixels

    def _surface_targets(self, batch: Batch, slots: Tensor, cells: Cells) -> tuple[Tensor, Tensor]:
        return surface_targets(
            cells.centres[slots].flatten(0, 1),
            _per_slot(batch.rotation),
            _per_slot(batch.translation),
            _per_slot(batch.camera),
            self.low,
            self.high,
        )


def positive_slots(labels: Tensor) -> tuple[Tensor, Tensor]:
    """Indices int64 ``[B, SLOTS]`` of the positive cells first, and bool ``[B, SLOTS]``, which are positive."""
    order = (labels == POSITIVE).to(torch.int8).sort(dim=1, descending=True, stable=True)
    return order.indices[:, :SLOTS], order.values[:, :SLOTS] > 0


def _per_slot(values: Tensor) -> Tensor:
    """``[B, ...]`` -> ``[B * SLOTS, ...]``: each picture's value for each of its slots."""
    return values[:, None].expand(-1, SLOTS, *values.shape[1:]).flatten(0, 1)
