"""macram: quantised convolution layers on a Processing-In-Memory array, proven code by code."""

__version__ = "0.1.0"
