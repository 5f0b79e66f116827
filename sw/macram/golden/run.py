"""A whole layer: convolution, then codes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from macram.golden.conv import conv2d
from macram.golden.formula import float_code
from macram.golden.requant import derive_requant
from macram.layer_file import LayerCase


def run_layer(case: LayerCase) -> NDArray[np.int64]:
    """Output codes ``[c_out, out_height, out_width]`` as the hardware must produce them, in integers."""
    return derive_requant(case.spec, case.scale, case.offset).apply(accumulate(case))


def float_codes(case: LayerCase) -> NDArray[np.int64]:
    """Output codes by the float64 formula; equal to `run_layer` up to 4 output bits."""
    scale, offset = case.scale[:, None, None], case.offset[:, None, None]
    return float_code(accumulate(case), scale, offset, case.spec.output)


def accumulate(case: LayerCase) -> NDArray[np.int32] | NDArray[np.int64]:
    """Exact accumulators ``[c_out, out_height, out_width]``."""
    return conv2d(case.input, case.weights, stride=case.spec.stride, padding=case.spec.padding)
