"""Layers with more output channels than an array holds: one pass over the image per part of the channels."""

from __future__ import annotations

import dataclasses

from macram.spec.array import ArrayConfig
from macram.spec.layer import ConvSpec


def channel_passes(layer: ConvSpec, array: ArrayConfig) -> list[range]:
    """Output channels of each pass, in order; one pass if the array holds the whole layer.

    Several passes are cut so that two of them fit side by side, where that is possible: the words of the next
    one then load while the array computes.

    Raises:
        ValueError: not even one tile of output channels fits; the line names the limit.
    """
    one_tile = dataclasses.replace(layer, c_out=min(layer.c_out, array.units))
    array.check_admits(one_tile)
    most = min(array.max_tiles, array.weight_depth // array.steps(layer))
    if array.tiles(layer.c_out) > most:
        most = most // 2 or most
    step = most * array.units
    return [range(first, min(first + step, layer.c_out)) for first in range(0, layer.c_out, step)]


def pass_specs(layer: ConvSpec, array: ArrayConfig) -> list[ConvSpec]:
    """The layer of each pass; every one is admitted.

    Raises:
        ValueError: as `channel_passes`.
    """
    return [dataclasses.replace(layer, c_out=len(part)) for part in channel_passes(layer, array)]
