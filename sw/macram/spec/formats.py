"""Integer formats: how many bits a code has and whether it is signed."""

from __future__ import annotations

import operator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

MAX_BITS = 48


@dataclass(frozen=True, slots=True)
class IntFormat:
    """Two's-complement (signed) or plain binary (unsigned) integers of ``bits`` bits.

    LSQ codes use ``lo..hi`` in full: -4..3 for signed 3 bits, 0..7 for unsigned 3 bits.

    Raises:
        TypeError: ``bits`` is not an integer.
        ValueError: ``bits`` is outside 1..48.
    """

    bits: int
    signed: bool = False

    def __post_init__(self) -> None:
        if not 1 <= operator.index(self.bits) <= MAX_BITS:
            raise ValueError(f"bits must be in 1..{MAX_BITS}, not {self.bits!r}")

    @property
    def lo(self) -> int:
        """Smallest code."""
        return -(1 << (self.bits - 1)) if self.signed else 0

    @property
    def hi(self) -> int:
        """Largest code."""
        return (1 << (self.bits - 1)) - 1 if self.signed else (1 << self.bits) - 1

    def holds(self, values: NDArray[np.integer]) -> bool:
        """Whether every element lies in ``lo..hi`` (an empty array does)."""
        return values.size == 0 or (int(values.min()) >= self.lo and int(values.max()) <= self.hi)

    def to_field(self, values: NDArray[np.integer]) -> NDArray[np.uint64]:
        """Codes as unsigned bit fields of ``bits`` bits."""
        return values.astype(np.int64).view(np.uint64) & np.uint64((1 << self.bits) - 1)

    def from_field(self, fields: NDArray[np.unsignedinteger]) -> NDArray[np.int64]:
        """Inverse of `to_field`."""
        values = fields.astype(np.int64)
        if self.signed:
            values = np.where(values > self.hi, values - (1 << self.bits), values)
        return values

    def __str__(self) -> str:
        return f"{'s' if self.signed else 'u'}{self.bits}"


def signed_format_for(lo: int, hi: int) -> IntFormat:
    """The narrowest signed format that holds both ``lo`` and ``hi``."""
    bits = 1
    while lo < -(1 << (bits - 1)) or hi > (1 << (bits - 1)) - 1:
        bits += 1
    return IntFormat(bits, signed=True)


def ceil_div(numerator: int, denominator: int) -> int:
    """Smallest integer not below ``numerator / denominator``."""
    return -(-numerator // denominator)


def parse_format(text: str) -> IntFormat:
    """``"u3"`` -> unsigned 3 bits, ``"s8"`` -> signed 8 bits.

    Raises:
        ValueError: any other text.
    """
    if not (isinstance(text, str) and text[:1] in ("u", "s") and text[1:].isdecimal()):
        raise ValueError(f"a format is 'u' or 's' and a bit count, such as 'u3', not {text!r}")
    return IntFormat(int(text[1:]), signed=text[0] == "s")
