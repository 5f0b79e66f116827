"""Which layers an array runs in one pass."""

from __future__ import annotations

from typing import TYPE_CHECKING

from macram.spec.fixed import MAX_SIDE
from macram.spec.layer import ConvSpec

if TYPE_CHECKING:
    from macram.spec.array import ArrayConfig


def check_admits(array: ArrayConfig, layer: ConvSpec) -> None:
    """Refuse a layer that this array cannot run in one pass.

    Raises:
        ValueError: naming the first limit that is broken and the value that breaks it.
    """
    for key in ("weight", "input", "output"):
        mine, theirs = getattr(array, key), getattr(layer, key)
        raised = key == "input" and array.biased(layer) and mine.bits == theirs.bits
        if mine != theirs and not raised:
            raise ValueError(
                f"the array's {key} format is {mine}, the layer's is {theirs}; name an array with "
                f'{key} = "{theirs}"'
            )
    if layer.padding != layer.kernel // 2:
        raise ValueError(
            f"the array runs 3x3 kernels with padding 1 and 1x1 kernels with padding 0, not "
            f"{layer.kernel}x{layer.kernel} with padding {layer.padding}"
        )
    if layer.c_in > array.max_c_in:
        raise ValueError(
            f"c_in must be at most {array.max_c_in}, not {layer.c_in}; build an array with a larger max_c_in, "
            f"or with partial_sum_c_in = {layer.c_in}"
        )
    if layer.c_out > array.max_c_out:
        raise ValueError(f"c_out must be at most {array.max_c_out}, not {layer.c_out}")
    if max(layer.height, layer.width) > MAX_SIDE:
        raise ValueError(f"height and width must be at most {MAX_SIDE}, not {layer.height}x{layer.width}")
    words = array.weight_words(layer)
    if words > array.weight_depth:
        raise ValueError(
            f"{layer.c_in} -> {layer.c_out} channels need {words} weight words per unit, "
            f"the array has {array.weight_depth}; split the output channels, or set partial_sum_c_in"
        )
    row = array.line_words(layer)
    if row > array.row_words:
        # Channels in blocks shorten a row down to one ingest word per pixel.
        shortest = array.groups(layer.out_width) * layer.stride * array.ingest
        blocks = shortest <= array.row_words and not array.partial_sum_c_in
        fix = "set partial_sum_c_in" if blocks else f"build an array with row_words = {row}"
        raise ValueError(
            f"a row of {layer.width} pixels x {layer.c_in} channels needs {row} line-buffer words, "
            f"the array has {array.row_words}; split the width, or {fix}"
        )
