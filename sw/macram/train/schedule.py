"""Learning rate and view size as functions of how far the run is: nothing to store, nothing to restore."""

from __future__ import annotations

import math

from macram.train.config import TrainConfig
from macram.train.settings import CropPhase, ScheduleSettings


def progress(settings: ScheduleSettings, step: int, minutes: float) -> float:
    """How much of the run is done before ``step``, 0 to 1.

    Args:
        settings: lengths.
        step: counted from 0.
        minutes: spent on training so far; matters only to a run by the clock.
    """
    done = step / settings.steps
    if settings.by_clock:
        done = max(done, minutes / settings.max_minutes)
    return min(done, 1.0)


def learning_rate(settings: ScheduleSettings, base: float, step: int, done: float) -> float:
    """Learning rate of ``step``, counted from 0; the first step of a warm-up is not 0.

    Args:
        settings: shape and warm-up.
        base: rate after the warm-up.
        step: for the warm-up, which always counts steps.
        done: of the run, from `progress`.
    """
    rate = base
    if settings.shape == "cosine":
        rate = 0.5 * base * (1 + math.cos(math.pi * done))
    elif settings.shape == "step":
        rate = base * settings.decay ** sum(done >= milestone for milestone in settings.milestones)
    return rate * min(1.0, (step + 1) / (settings.warmup + 1))


def crop_phase(config: TrainConfig, done: float) -> CropPhase:
    """The phase of a run of which ``done`` is over."""
    return next(phase for phase in config.crops if done < phase.until or phase is config.crops[-1])
