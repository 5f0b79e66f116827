"""The parts of a training configuration: frozen, checked dataclasses, one per table of the TOML file."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace

from macram.model import SIZES, VARIANTS, Faults, SpaceNetConfig, spacenet_config
from macram.model.counts import MODES

STAGES = ("wdr", "counterfactual", "control", "lsq")
"""1: factual path. 2: the three paths. 1 continued for as long as 2, to compare. 3: quantised."""
FILLS = ("erase", "background", "inpaint")
"""What the counterfactual picture shows in the target's place: black, the true background, a guess."""
POSITIVES = ("mask", "hull")
BITS = (3, 8)


def _choice(name: str, value: str, known: tuple[str, ...]) -> None:
    if value not in known:
        raise ValueError(f"{name} must be one of {', '.join(known)}, not {value!r}")


def _least(name: str, value: float, lowest: float) -> None:
    if not lowest <= value < math.inf:
        raise ValueError(f"{name} must be a number of at least {lowest:g}, not {value!r}")


@dataclass(frozen=True, slots=True)
class RunSettings:
    """The run as a whole.

    Attributes:
        stage: one of `STAGES`.
        out: folder of checkpoints and logs.
        init: checkpoint to start from; empty for none. Stage wdr needs none, the others do. Stage lsq starts from a
            float network, or goes on with one of its bits and mode: better from the run's own file than from a
            packed one, which has forgotten how near the weights were to other codes.
        backbone: file with weights of the backbone alone, such as ImageNet's, in this project's tensor names or
            pytorchcv's; see `macram.train.pretrained`. Empty for none.
        seed: decides weights, order of the frames and every random view.
        precision: ``bf16`` (mixed), ``fp32``, or ``auto``: bf16 where the processor has it, except in lsq.
        freeze_backbone: train pyramids and head only; always so in the counterfactual stage.
        graphs: record each kind of step as a CUDA graph and replay it; read on one GPU.
    """

    stage: str
    out: str
    init: str = ""
    backbone: str = ""
    seed: int = 2022
    precision: str = "auto"
    freeze_backbone: bool = False
    graphs: bool = True

    def __post_init__(self) -> None:
        _choice("run.stage", self.stage, STAGES)
        _choice("run.precision", self.precision, ("auto", "bf16", "fp32"))
        _least("run.seed", self.seed, 0)
        if not self.out:
            raise ValueError("run.out must name a folder for checkpoints and logs")
        if self.stage != "wdr" and not self.init:
            raise ValueError(
                f"stage {self.stage!r} continues a network; set run.init to its model.safetensors"
            )
        if self.init and self.backbone:
            raise ValueError("run.init brings its own backbone; leave run.backbone away")


@dataclass(frozen=True, slots=True)
class DataSettings:
    """The pictures.

    Attributes:
        root: SwissCube, BOP, SPEED or rendered folder.
        train: split to learn from.
        validation: split for the scores while training; empty for none.
        shrink: whole factor by which pictures are reduced (2 for SwissCube).
        counterfactual: one of `FILLS`; read by the counterfactual stage.
        limit: use only this many frames, evenly spaced; 0 for all.
        cache: folder for packed frames; empty for the user's cache folder.
        positives: which cells may learn the pose: those on the ``mask``, as published, or only those of them inside
            the ``hull`` of the keypoints, without antennas and whatever else sticks out.
    """

    root: str
    train: str = "training"
    validation: str = "validation"
    shrink: int = 1
    counterfactual: str = "erase"
    limit: int = 0
    cache: str = ""
    positives: str = "mask"

    def __post_init__(self) -> None:
        _choice("data.counterfactual", self.counterfactual, FILLS)
        _choice("data.positives", self.positives, POSITIVES)
        _least("data.shrink", self.shrink, 1)
        _least("data.limit", self.limit, 0)


@dataclass(frozen=True, slots=True)
class OptimiserSettings:
    """How weights move.

    Attributes:
        kind: ``sgd`` (Nesterov) or ``adamw``.
        lr: base learning rate. Losses are summed over images as published, but per 8 of them.
        momentum: of sgd; first beta of adamw.
        weight_decay: on every parameter, as published; adamw leaves vectors (norms, biases, steps) out.
        clip: largest norm of all gradients together; 0 for no clipping.
        average: decay of the moving average of the weights that is evaluated and shipped; 0 for none.
    """

    kind: str = "sgd"
    lr: float = 0.01
    momentum: float = 0.9
    weight_decay: float = 1e-4
    clip: float = 5.0
    average: float = 0.0

    def __post_init__(self) -> None:
        _choice("optimiser.kind", self.kind, ("sgd", "adamw"))
        if not 0 < self.lr < math.inf:
            raise ValueError(f"optimiser.lr must be above 0, not {self.lr!r}")
        for name in ("momentum", "average"):
            if not 0 <= getattr(self, name) < 1:
                raise ValueError(
                    f"optimiser.{name} must be 0 or more and below 1, not {getattr(self, name)!r}"
                )
        _least("optimiser.weight_decay", self.weight_decay, 0)
        _least("optimiser.clip", self.clip, 0)


@dataclass(frozen=True, slots=True)
class ScheduleSettings:
    """How long, and how the learning rate goes.

    Attributes:
        steps: optimiser steps of the whole run.
        batch: images per step, over all processes.
        warmup: steps of linear rise from 0.
        shape: ``step`` (times ``decay`` at each milestone), ``cosine`` (to 0) or ``constant``.
        milestones: shares of ``steps``; published 2/3 and 5/6.
        decay: factor at a milestone.
        max_minutes: stop after so many minutes of training, all resumptions counted; 0 for no limit.
        by_clock: let schedule and crops follow the clock where ``max_minutes`` ends before ``steps`` do, so
            that a run of a given time is complete. Such a run is not repeatable.
    """

    steps: int
    batch: int = 8
    warmup: int = 1000
    shape: str = "step"
    milestones: tuple[float, ...] = (2 / 3, 5 / 6)
    decay: float = 0.1
    max_minutes: float = 0.0
    by_clock: bool = False

    def __post_init__(self) -> None:
        _choice("schedule.shape", self.shape, ("step", "cosine", "constant"))
        _least("schedule.steps", self.steps, 1)
        _least("schedule.batch", self.batch, 1)
        _least("schedule.warmup", self.warmup, 0)
        _least("schedule.max_minutes", self.max_minutes, 0)
        if not all(0 < share <= 1 for share in self.milestones) or list(self.milestones) != sorted(
            self.milestones
        ):
            raise ValueError(
                f"schedule.milestones must rise, above 0 and at most 1, not {list(self.milestones)!r}"
            )
        if not 0 < self.decay <= 1:
            raise ValueError(f"schedule.decay must be above 0 and at most 1, not {self.decay!r}")
        if self.by_clock and not self.max_minutes:
            raise ValueError("schedule.by_clock needs schedule.max_minutes")


@dataclass(frozen=True, slots=True)
class CropPhase:
    """Sizes of the views during a part of the run.

    Attributes:
        until: share of the run at which the phase ends; the last one needs 1.
        sizes: sides of square views, pixels, multiples of 32; one is drawn per step. 0 is the whole frame;
            smaller ones are centred on the target and zoom out where it would not fit.
        batch: images per step over all processes in this phase; 0 for the schedule's.
    """

    until: float
    sizes: tuple[int, ...]
    batch: int = 0

    def __post_init__(self) -> None:
        if not self.sizes or any(size < 0 or size % 32 for size in self.sizes):
            raise ValueError(
                f"crops.sizes must be multiples of 32, or 0 for whole frames, not {self.sizes!r}"
            )
        if not 0 < self.until <= 1:
            raise ValueError(f"crops.until must be above 0 and at most 1, not {self.until!r}")
        _least("crops.batch", self.batch, 0)


@dataclass(frozen=True, slots=True)
class QuantSettings:
    """Stage lsq.

    Attributes:
        mode: ``I`` backbone, ``II`` pyramids too, ``III`` head too.
        bits: of weights and activations, 3 or 8.
        calibration: images that set the activation steps; a network that has them keeps them.
        teacher: float network whose features the quantised one learns to imitate, beside the labels; empty for none.
            Departs from the paper; see `macram.train.teacher`.
    """

    mode: str = "III"
    bits: int = 3
    calibration: int = 64
    teacher: str = ""

    def __post_init__(self) -> None:
        _choice("quant.mode", self.mode, MODES)
        if self.bits not in BITS:
            raise ValueError(f"quant.bits must be 3 or 8, not {self.bits!r}")
        _least("quant.calibration", self.calibration, 1)


@dataclass(frozen=True, slots=True)
class LogSettings:
    """What is left behind, and how often.

    Attributes:
        every: steps between lines of the log.
        checkpoint_minutes: between checkpoints; there is one at the end in any case.
        evaluate_minutes: between scores and pictures on validation frames; 0 only at the end.
        evaluate_frames: validation frames, evenly spaced.
    """

    every: int = 50
    checkpoint_minutes: float = 5.0
    evaluate_minutes: float = 10.0
    evaluate_frames: int = 200

    def __post_init__(self) -> None:
        _least("log.every", self.every, 1)
        _least("log.checkpoint_minutes", self.checkpoint_minutes, 0)
        _least("log.evaluate_minutes", self.evaluate_minutes, 0)
        _least("log.evaluate_frames", self.evaluate_frames, 1)


@dataclass(frozen=True, slots=True)
class NetworkSettings:
    """The network of stage wdr; later stages take it from the checkpoint.

    Attributes:
        size: one of `macram.model.SIZES`.
        variant: one of `macram.model.VARIANTS`.
        dataset: ``swisscube`` or ``speed``: levels, image size, keypoints.
        image_size: side of the frames, pixels.
        surface: carry the training-only surface head; read by every stage.
        faults: names of the published faults to reproduce; left away, those of the variant or checkpoint.
            The counterfactual stage reads it too.
        tde_factor: of the pseudo features in the subtraction; read by the counterfactual stage.
    """

    size: str = "quarter"
    variant: str = "deployable"
    dataset: str = "swisscube"
    image_size: int = 256
    surface: bool = False
    faults: tuple[str, ...] | None = None
    tde_factor: float = 1.0

    def __post_init__(self) -> None:
        _choice("network.size", self.size, tuple(SIZES))
        _choice("network.variant", self.variant, VARIANTS)
        if self.image_size < 32 or self.image_size % 32:
            raise ValueError(f"network.image_size must be a multiple of 32, not {self.image_size!r}")
        if not 0 < self.tde_factor <= 1:
            raise ValueError(f"network.tde_factor must be above 0 and at most 1, not {self.tde_factor!r}")
        for fault in self.faults or ():
            _choice("network.faults", fault, tuple(f.name for f in fields(Faults)))

    def build(self, keypoints: int) -> SpaceNetConfig:
        """The network's configuration, as the factual path alone."""
        config = spacenet_config(
            self.size,
            self.variant,
            dataset=self.dataset,
            image_size=self.image_size,
            surface=self.surface,
            counterfactual=False,
            keypoints=keypoints,
        )
        return self.with_faults(config)

    def with_faults(self, config: SpaceNetConfig) -> SpaceNetConfig:
        """``config`` with the faults asked for, or its own if nothing was asked."""
        if self.faults is None:
            return config
        return replace(config, faults=Faults(**dict.fromkeys(self.faults, True)))
