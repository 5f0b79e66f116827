"""Layers with more output channels than an array holds: one pass over the image per part of the channels."""

from __future__ import annotations

import dataclasses

from macram.spec.array import TAPS, ArrayConfig
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
    if _one_pass(layer, array):
        return [range(layer.c_out)]
    places = array.weight_depth // array.steps(layer)
    most = min(array.max_tiles // 2, _tiles_in(places // 2, layer, array)) or min(
        array.max_tiles, _tiles_in(places, layer, array)
    )
    step = most * array.units
    return [range(first, min(first + step, layer.c_out)) for first in range(0, layer.c_out, step)]


def _one_pass(layer: ConvSpec, array: ArrayConfig) -> bool:
    return array.tiles(layer.c_out) <= array.max_tiles and array.weight_words(layer) <= array.weight_depth


def _tiles_in(places: int, layer: ConvSpec, array: ArrayConfig) -> int:
    """So many tiles, and any smaller number, take no more than ``places`` tiles' words."""
    # Up to two tiles are left over from triples; they take a place each.
    return max(places, TAPS * (places - 1)) if array.packs(layer) else places


def pass_specs(layer: ConvSpec, array: ArrayConfig) -> list[ConvSpec]:
    """The layer of each pass; every one is admitted.

    Raises:
        ValueError: as `channel_passes`.
    """
    return [dataclasses.replace(layer, c_out=len(part)) for part in channel_passes(layer, array)]
