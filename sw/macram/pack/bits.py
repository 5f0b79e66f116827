"""Bit fields side by side in memory words, as NumPy bytes.

A word of ``bits`` bits is a row of ``ceil(bits / 8)`` bytes, low byte first; field 0 is in its low bits.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from macram.spec import IntFormat

Words = NDArray[np.uint8]


def to_bits(codes: NDArray[np.integer], form: IntFormat) -> NDArray[np.uint8]:
    """Codes ``[...]`` -> their bits ``[..., form.bits]``, low bit first."""
    fields = np.ascontiguousarray(form.to_field(codes), "<u8")[..., None].view(np.uint8)
    return np.unpackbits(fields[..., : -(-form.bits // 8)], axis=-1, count=form.bits, bitorder="little")


def from_bits(bits: NDArray[np.uint8], form: IntFormat) -> NDArray[np.int64]:
    """Inverse of `to_bits`."""
    packed = np.packbits(bits, axis=-1, bitorder="little")
    fields = np.zeros((*packed.shape[:-1], 8), np.uint8)
    fields[..., : packed.shape[-1]] = packed
    return form.from_field(fields.view("<u8")[..., 0])


def bits_to_words(bits: NDArray[np.uint8]) -> Words:
    """Bits ``[..., width]`` -> words ``[..., ceil(width / 8)]``; the top byte is padded with zeros."""
    return np.packbits(bits, axis=-1, bitorder="little")


def words_to_bits(words: Words, width: int) -> NDArray[np.uint8]:
    """Inverse of `bits_to_words`."""
    return np.unpackbits(words, axis=-1, count=width, bitorder="little")


def words_to_ints(words: Words) -> list[int]:
    """Words ``[n, bytes]`` as Python integers."""
    return [int.from_bytes(word, "little") for word in words]
