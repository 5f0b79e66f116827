"""Designs compared: cycles of every layer, where they go, resources, and published peers beside them."""

from macram.designs.design import Design, describe, describe_layer
from macram.designs.page import write_designs

__all__ = ["Design", "describe", "describe_layer", "write_designs"]
