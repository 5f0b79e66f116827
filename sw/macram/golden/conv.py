"""Integer convolution, exact, at the speed of a floating-point matrix product.

Why floating point is exact here: every operand is an integer, so is every product and every partial sum, in
whatever order the products are added and whether or not multiply and add are fused. All of them are at most
``bound = max|input| * max over output channels of sum|weights|`` in magnitude, and a float of p significand
bits holds every integer up to ``2**p``. So float32 (p = 24) is exact while ``bound < 2**24``, float64
(p = 53) while ``bound < 2**53``; the choice is made from the operands themselves. The reference layer is
bounded by 64 * 9 * 4 * 7 = 16,128.
"""

from __future__ import annotations

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

BAND_ELEMENTS = 1 << 22
"""Elements of the unrolled input held at once: 16 MiB of float32."""


def conv2d(
    input: NDArray[np.integer], weights: NDArray[np.integer], *, stride: int = 1, padding: int = 1
) -> NDArray[np.int32] | NDArray[np.int64]:
    """Convolve integer codes (correlation, as in deep learning) with zero padding on all four sides.

    Args:
        input: ``[c_in, height, width]``, any integer type.
        weights: ``[c_out, c_in, k, k]``, any integer type, ``k`` 1 or 3.
        stride: 1 or 2.
        padding: 0 or ``k // 2``.

    Returns:
        ``[c_out, out_height, out_width]``; int32 if the largest possible sum fits, else int64.

    Raises:
        ValueError: wrong rank, type, kernel, stride or padding, channels that do not agree, an input
            smaller than the kernel, or operands so large that a sum may reach ``2**53``.
    """
    _check(input, weights, stride, padding)
    c_out, c_in, k, _ = weights.shape
    bound = sum_bound(input, weights)
    if bound >= 1 << 53:
        raise ValueError(f"sums must stay below 2**53, these may reach {bound}; use fewer bits")
    real = np.float32 if bound < 1 << 24 else np.float64
    whole = np.int32 if bound < 1 << 31 else np.int64

    padded = np.pad(input.astype(real), ((0, 0), (padding, padding), (padding, padding)))
    windows = sliding_window_view(padded, (k, k), axis=(1, 2))[:, ::stride, ::stride]
    height, width = windows.shape[1:3]
    kernels = weights.astype(real).reshape(c_out, -1)
    out = np.empty((c_out, height, width), whole)
    band = max(1, BAND_ELEMENTS // (c_in * k * k * width))
    for top in range(0, height, band):
        rows = windows[:, top : top + band]
        columns = rows.transpose(0, 3, 4, 1, 2).reshape(c_in * k * k, -1)
        out[:, top : top + band] = (kernels @ columns).reshape(c_out, -1, width)
    return out


def sum_bound(input: NDArray[np.integer], weights: NDArray[np.integer]) -> int:
    """No partial sum of the convolution of these operands exceeds this magnitude, in any order.

    Exact while the magnitudes of a channel's weights add up to less than ``2**53``; from there on it is at
    least ``2**53`` times the largest input.
    """
    largest = max(abs(int(input.min())), abs(int(input.max())))
    # Non-negative float64 partial sums of integers are exact below 2**53, and once there they stay there.
    heaviest = np.abs(weights.astype(np.float64)).reshape(len(weights), -1).sum(axis=1).max()
    return int(heaviest) * largest


def _check(input: NDArray[np.integer], weights: NDArray[np.integer], stride: int, padding: int) -> None:
    for name, array, axes in (
        ("input", input, "c_in, height, width"),
        ("weights", weights, "c_out, c_in, k, k"),
    ):
        if array.ndim != axes.count(",") + 1 or not array.size:
            raise ValueError(f"{name} must have the shape [{axes}], not {list(array.shape)}")
        if array.dtype.kind not in "iu":
            raise ValueError(f"{name} must hold integers, not {array.dtype}")
    k = weights.shape[2]
    if weights.shape[3] != k or k not in (1, 3):
        raise ValueError(f"the kernel must be 1x1 or 3x3, not {k}x{weights.shape[3]}")
    if weights.shape[1] != input.shape[0]:
        raise ValueError(
            f"the weights take {weights.shape[1]} input channels, the input has {input.shape[0]}"
        )
    if stride not in (1, 2):
        raise ValueError(f"stride must be 1 or 2, not {stride!r}")
    if padding not in (0, k // 2):
        raise ValueError(f"padding must be 0 or {k // 2}, not {padding!r}")
    if min(input.shape[1:]) + 2 * padding < k:
        raise ValueError(f"the input must be at least {k}x{k} without padding, not {list(input.shape[1:])}")
