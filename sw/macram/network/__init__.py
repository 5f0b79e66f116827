"""Every convolution of a network on the simulated array, shape by shape at full size."""

from macram.network.record import find_record, simulate_shape
from macram.network.shapes import Shape, distinct_shapes, wanted_shapes
from macram.network.table import NetworkTable, network_table

__all__ = [
    "NetworkTable",
    "Shape",
    "distinct_shapes",
    "find_record",
    "network_table",
    "simulate_shape",
    "wanted_shapes",
]
