"""Designs compared: cycles of every layer, where they go, resources, and published peers beside them."""

from macram.designs.design import Design, describe, describe_layer
from macram.designs.page import write_designs
from macram.designs.resources import find_resources

__all__ = ["Design", "describe", "describe_layer", "find_resources", "write_designs"]
