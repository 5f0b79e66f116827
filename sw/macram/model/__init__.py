"""The networks, in PyTorch and in floating point."""

from macram.model.backbone import BackboneConfig, ConvBlock, DarkNet53, ResidualUnit, Stage
from macram.model.config import PUBLISHED_FAULTS, SPEED_LEVELS, Faults, Levels, SpaceNetConfig
from macram.model.head import Prediction
from macram.model.sizes import SIZES, VARIANTS, spacenet_config
from macram.model.spacenet import Features, SpaceNet, ThreePaths, TrainingOutput

__all__ = [
    "PUBLISHED_FAULTS",
    "SIZES",
    "SPEED_LEVELS",
    "VARIANTS",
    "BackboneConfig",
    "ConvBlock",
    "DarkNet53",
    "Faults",
    "Features",
    "Levels",
    "Prediction",
    "ResidualUnit",
    "SpaceNet",
    "SpaceNetConfig",
    "Stage",
    "ThreePaths",
    "TrainingOutput",
    "spacenet_config",
]
