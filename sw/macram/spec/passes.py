"""Layers that an array does not hold: one run over the image per part of the output and block of the input channels."""

from __future__ import annotations

import dataclasses
import itertools
from dataclasses import dataclass

from macram.spec.array import ArrayConfig
from macram.spec.fixed import TAPS
from macram.spec.formats import ceil_div
from macram.spec.layer import ConvSpec


@dataclass(frozen=True, slots=True)
class LayerPass:
    """One run over the image.

    Attributes:
        layer: what the array runs: the layer with this pass's channels alone.
        c_in: input channels of this pass, a block of the layer's.
        c_out: output channels of this pass.
        sums_in: the run starts from the sums of the blocks before.
        sums_out: it gives its sums, for the block after it, instead of codes.
    """

    layer: ConvSpec
    c_in: range
    c_out: range
    sums_in: bool
    sums_out: bool


def layer_passes(layer: ConvSpec, array: ArrayConfig) -> list[LayerPass]:
    """The runs that make up ``layer``, in order; one if the array holds the whole layer.

    Output channels are cut into parts, input channels into blocks only where a run cannot take them all and the
    array has partial sums; the blocks of one part follow each other, about equal in size. Parts are cut so that two
    runs fit side by side, where that is possible: the words of the next one then load while the array computes.

    Raises:
        ValueError: not even one tile of output channels fits; the line names the limit.
    """
    blocks = _input_blocks(layer, array)
    if len(blocks) == 1 and _one_pass(layer, array):
        step = layer.c_out
    else:
        widest = dataclasses.replace(layer, c_in=len(blocks[0]))
        places = array.weight_depth // array.steps(widest)
        most = min(array.max_tiles // 2, _tiles_in(places // 2, widest, array)) or min(
            array.max_tiles, _tiles_in(places, widest, array)
        )
        step = most * array.units
    return [
        LayerPass(
            dataclasses.replace(layer, c_in=len(block), c_out=len(part)),
            block,
            part,
            sums_in=block.start > 0,
            sums_out=block.stop < layer.c_in,
        )
        for first in range(0, layer.c_out, step)
        for part in [range(first, min(first + step, layer.c_out))]
        for block in blocks
    ]


def _input_blocks(layer: ConvSpec, array: ArrayConfig) -> list[range]:
    """Blocks of input channels, as few as one tile of output channels allows; none is larger than the first."""
    limit = array.partial_sum_c_in
    if limit and layer.c_in > limit:
        raise ValueError(
            f"c_in must be at most {limit}, not {layer.c_in}; build an array with a larger partial_sum_c_in"
        )
    row_blocks = array.blocks(layer.c_in)
    one_tile = dataclasses.replace(layer, c_out=min(layer.c_out, array.units))
    count = 1
    while True:
        size = ceil_div(row_blocks, count) * array.rows
        try:
            array.check_admits(dataclasses.replace(one_tile, c_in=min(size, layer.c_in)))
        except ValueError:
            if not limit or size == array.rows:
                raise
            count += 1
        else:
            break
    larger = row_blocks % count or count
    sizes = [size if index < larger else size - array.rows for index in range(count)]
    ends = [0, *itertools.accumulate(sizes)]
    return [range(first, min(end, layer.c_in)) for first, end in itertools.pairwise(ends)]


def _one_pass(layer: ConvSpec, array: ArrayConfig) -> bool:
    return array.tiles(layer.c_out) <= array.max_tiles and array.weight_words(layer) <= array.weight_depth


def _tiles_in(places: int, layer: ConvSpec, array: ArrayConfig) -> int:
    """So many tiles, and any smaller number, take no more than ``places`` tiles' words."""
    # Up to two tiles are left over from triples; they take a place each.
    return max(places, TAPS * (places - 1)) if array.packs(layer) else places
