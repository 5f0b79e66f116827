"""The convolution layer that is computed: shapes and integer formats, nothing about hardware."""

from __future__ import annotations

import operator
from dataclasses import dataclass

from macram.spec.formats import IntFormat, signed_format_for


@dataclass(frozen=True, slots=True)
class ConvSpec:
    """A square 2-D convolution on integer codes, then requantisation to ``output`` codes.

    Input is ``[c_in, height, width]``, weights ``[c_out, c_in, kernel, kernel]``, output
    ``[c_out, out_height, out_width]``. Kernel 1 or 3, stride 1 or 2, zero padding 0 or ``kernel // 2``.

    Raises:
        ValueError: a field is out of range, or the output would be empty.
    """

    c_in: int
    c_out: int
    height: int
    width: int
    kernel: int = 3
    stride: int = 1
    padding: int = 1
    weight: IntFormat = IntFormat(3, signed=True)
    input: IntFormat = IntFormat(3)
    output: IntFormat = IntFormat(3)

    def __post_init__(self) -> None:
        for field in ("c_in", "c_out", "height", "width"):
            value = operator.index(getattr(self, field))
            if value < 1:
                raise ValueError(f"{field} must be at least 1, not {value}")
        if self.kernel not in (1, 3):
            raise ValueError(f"kernel must be 1 or 3, not {self.kernel!r}")
        if self.stride not in (1, 2):
            raise ValueError(f"stride must be 1 or 2, not {self.stride!r}")
        if self.padding not in (0, self.kernel // 2):
            wanted = "0" if self.kernel == 1 else f"0 or {self.kernel // 2}"
            raise ValueError(
                f"padding of a {self.kernel}x{self.kernel} kernel must be {wanted}, not {self.padding!r}"
            )
        if not self.weight.signed:
            raise ValueError(f"weights must be signed, not {self.weight}")
        if self.out_height < 1 or self.out_width < 1:
            raise ValueError(
                f"a {self.height}x{self.width} input without padding is smaller than the "
                f"{self.kernel}x{self.kernel} kernel"
            )

    @property
    def out_height(self) -> int:
        """Rows of the output."""
        return (self.height + 2 * self.padding - self.kernel) // self.stride + 1

    @property
    def out_width(self) -> int:
        """Columns of the output."""
        return (self.width + 2 * self.padding - self.kernel) // self.stride + 1

    @property
    def macs(self) -> int:
        """Multiply-accumulates, padding included (the convention of the paper's table IV)."""
        return self.out_height * self.out_width * self.c_out * self.fan_in

    @property
    def fan_in(self) -> int:
        """Products per output."""
        return self.c_in * self.kernel * self.kernel

    @property
    def accumulator(self) -> IntFormat:
        """Exact accumulator format, see `accumulator_format`; s15 for the reference layer."""
        return accumulator_format(self.weight, self.input, self.fan_in)


def accumulator_range(weight: IntFormat, act: IntFormat, fan_in: int) -> tuple[int, int]:
    """Smallest and largest sum of ``fan_in`` products, over all operand values."""
    products = [w * a for w in (weight.lo, weight.hi) for a in (act.lo, act.hi)]
    return fan_in * min(products), fan_in * max(products)


def accumulator_format(weight: IntFormat, act: IntFormat, fan_in: int) -> IntFormat:
    """Narrowest signed format of every sum, and of ``largest sum + 1``, the threshold nothing reaches."""
    lo, hi = accumulator_range(weight, act, fan_in)
    return signed_format_for(lo, hi + 1)
