"""From an image to a quantised layer with real codes."""

from macram.front.case import REFERENCE_LAYER, FrontResult, prepare_network, reference_case
from macram.front.checkpoint import load_checkpoint, save_checkpoint
from macram.front.image import IMAGE_SIZE, normalise, read_image

__all__ = [
    "IMAGE_SIZE",
    "REFERENCE_LAYER",
    "FrontResult",
    "load_checkpoint",
    "normalise",
    "prepare_network",
    "read_image",
    "reference_case",
    "save_checkpoint",
]
