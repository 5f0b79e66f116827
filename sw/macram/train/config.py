"""What one training run is: a TOML file -> frozen, checked dataclasses."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from macram.train.augment import AugmentSettings
from macram.train.losses import LossWeights
from macram.train.settings import (
    CropPhase,
    DataSettings,
    LogSettings,
    NetworkSettings,
    OptimiserSettings,
    QuantSettings,
    RunSettings,
    ScheduleSettings,
)
from macram.train.tables import build, read_table


@dataclass(frozen=True, slots=True)
class TrainConfig:
    """A whole run; see the parts. `surface_until` ends the surface head's loss, as a share of the run."""

    run: RunSettings
    data: DataSettings
    schedule: ScheduleSettings
    network: NetworkSettings = NetworkSettings()
    optimiser: OptimiserSettings = OptimiserSettings()
    crops: tuple[CropPhase, ...] = (CropPhase(1.0, (0,)),)
    augment: AugmentSettings = field(default_factory=AugmentSettings)
    loss: LossWeights = LossWeights()
    quant: QuantSettings = QuantSettings()
    log: LogSettings = LogSettings()
    surface_until: float = 0.8

    def __post_init__(self) -> None:
        ends = [phase.until for phase in self.crops]
        if ends != sorted(ends) or ends[-1:] != [1.0]:
            raise ValueError(f"crops need rising ends, the last of them 1, not {ends!r}")
        if not 0 <= self.surface_until <= 1:
            raise ValueError(f"surface_until must lie in 0..1, not {self.surface_until!r}")
        if self.quant.teacher and self.run.stage != "lsq":
            raise ValueError(f"quant.teacher is for stage 'lsq', not {self.run.stage!r}; leave it away")
        if self.augment.labels == "reference" and any(any(phase.sizes) for phase in self.crops):
            raise ValueError('crops need exact labels; set augment.labels to "exact" or crops.sizes to [0]')
        if self.augment.centred:
            raise ValueError("augment.centred follows from crops; leave it away")

    def to_dict(self) -> dict[str, Any]:
        """JSON types; `from_dict` takes it back."""
        return asdict(self)

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> TrainConfig:
        """From nested tables.

        Raises:
            ValueError: a table or key is unknown or missing, or a value has the wrong type or range.
        """
        config = build(cls, values)
        assert isinstance(config, cls)
        return config


def completed(values: Mapping[str, Any]) -> dict[str, Any]:
    """A recorded configuration with the settings that were added since, at their defaults: what it meant."""
    return TrainConfig.from_dict(values).to_dict()


def load_config(path: Path, overrides: Mapping[str, Any] | None = None) -> TrainConfig:
    """Reads a TOML file.

    Args:
        path: the file. Paths in it count from the working folder.
        overrides: dotted keys and values over the file's, such as ``{"schedule.steps": 10}``.

    Raises:
        ValueError: no such file, not TOML, or not a training configuration; one line that names it.
    """
    table = read_table(path, overrides)
    try:
        return TrainConfig.from_dict(table)
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from None
