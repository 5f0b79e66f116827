"""Hand-off to vendor tools: a folder that Vivado builds in one command, and the overlay it fills."""

from macram.export.default import default_array
from macram.export.vivado import export_vivado

__all__ = ["default_array", "export_vivado"]
