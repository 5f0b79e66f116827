"""The networks, in PyTorch and in floating point."""

from macram.model.backbone import BackboneConfig, ConvBlock, DarkNet53, ResidualUnit, Stage

__all__ = ["BackboneConfig", "ConvBlock", "DarkNet53", "ResidualUnit", "Stage"]
