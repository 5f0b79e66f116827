"""Where every weight and every requantiser parameter lies in the array's memories: the hardware contract.

Weights. Unit u owns the output channels u, u + units, u + 2 units, ...; tile o is ``channel // units``. The
input channels form ``blocks`` blocks of ``rows``. The word of unit u at address
``(o * 3 + ky) * blocks + cb`` holds for row engine r (input channel ``cb * rows + r``) three fields of the
weight format; field j, at bit ``(r * 3 + j) * bits``, is
``weights[o * units + u, cb * rows + r, ky, 2 - j]``: taps are stored reversed.

Requantiser. The word at address ``o * (units / drain) + d`` holds the channels ``o * units + d * drain + q``
for q in 0..drain - 1, entry q at bit ``q * requant_entry_bits``. A threshold entry is the thresholds in
ascending order, lowest first, each in the array's accumulator format, then the invert bit. A shift entry is
mult (18 bits), offset (48), shift (6), lowest first.

Channels that the layer does not have are weights 0, and requantiser entries that give the code 0: thresholds
at the array accumulator's largest value, which no sum reaches, the lower half of them at its smallest value
if codes are signed; or mult, offset and shift 0.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from macram.golden import ShiftRequant, ThresholdRequant
from macram.pack.bits import Words, bits_to_words, from_bits, to_bits, words_to_bits
from macram.spec import TAPS, ArrayConfig, ConvSpec, IntFormat, accumulator_range
from macram.spec.array import MULT_BITS, OFFSET_BITS, SHIFT_BITS

BIT_ORDER = {
    "weights": (
        "unit u owns output channels u, u + units, ...; tile o = channel // units; "
        "word (o * 3 + ky) * blocks + cb, field j of row engine r at bit (r * 3 + j) * weight_bits "
        "= weights[o * units + u, cb * rows + r, ky, 2 - j], two's complement"
    ),
    "threshold": (
        "word o * (units / drain) + d holds channels o * units + d * drain + q, entry q at bit "
        "q * entry_bits: thresholds ascending from the low end, accumulator_bits each, two's complement, "
        "then 1 invert bit"
    ),
    "shift": (
        "word o * (units / drain) + d holds channels o * units + d * drain + q, entry q at bit "
        "q * entry_bits: mult (18 bits, signed), offset (48 bits, signed), shift (6 bits) from the low end"
    ),
}
"""One sentence per memory for manifests and file headers."""

SHIFT_FIELDS = (
    IntFormat(MULT_BITS, signed=True),
    IntFormat(OFFSET_BITS, signed=True),
    IntFormat(SHIFT_BITS),
)


def pack_weights(weights: NDArray[np.int64], array: ArrayConfig) -> Words:
    """Codes ``[c_out, c_in, 3, 3]`` -> words ``[units, tiles * 3 * blocks, bytes]``."""
    c_out, c_in = weights.shape[:2]
    tiles, blocks = array.tiles(c_out), array.blocks(c_in)
    whole = np.zeros((tiles * array.units, blocks * array.rows, TAPS, TAPS), np.int64)
    whole[:c_out, :c_in] = weights
    fields = whole.reshape(tiles, array.units, blocks, array.rows, TAPS, TAPS)[..., ::-1]
    bits = to_bits(fields.transpose(1, 0, 4, 2, 3, 5), array.weight)
    return bits_to_words(bits.reshape(array.units, tiles * TAPS * blocks, array.weight_word_bits))


def unpack_weights(words: Words, spec: ConvSpec, array: ArrayConfig) -> NDArray[np.int64]:
    """Inverse of `pack_weights`."""
    tiles, blocks = array.tiles(spec.c_out), array.blocks(spec.c_in)
    bits = words_to_bits(words, array.weight_word_bits)
    bits = bits.reshape(array.units, tiles, TAPS, blocks, array.rows, TAPS, array.weight.bits)
    fields = from_bits(bits, array.weight).transpose(1, 0, 3, 4, 2, 5)[..., ::-1]
    whole = fields.reshape(tiles * array.units, blocks * array.rows, TAPS, TAPS)
    return np.ascontiguousarray(whole[: spec.c_out, : spec.c_in])


def pack_requant(requant: ThresholdRequant | ShiftRequant, array: ArrayConfig, words: int) -> Words:
    """Parameters -> words ``[words, bytes]``; channels beyond the layer's get the entry that gives 0."""
    channels = words * array.drain
    if isinstance(requant, ThresholdRequant):
        thresholds = np.full((channels, array.thresholds), array.accumulator.hi, np.int64)
        if array.output.signed:
            # Code 0 lies half the range up.
            thresholds[:, : -array.output.lo] = array.accumulator.lo
        invert = np.zeros((channels, 1), np.uint8)
        thresholds[: len(requant.invert)] = requant.thresholds
        invert[: len(requant.invert), 0] = requant.invert
        parts = [to_bits(thresholds, array.accumulator).reshape(channels, -1), invert]
    else:
        parts = []
        for values, form in zip((requant.mult, requant.offset, requant.shift), SHIFT_FIELDS, strict=True):
            column = np.zeros(channels, np.int64)
            column[: len(values)] = values
            parts.append(to_bits(column, form))
    return bits_to_words(np.concatenate(parts, axis=1).reshape(words, array.requant_word_bits))


def unpack_requant(words: Words, spec: ConvSpec, array: ArrayConfig) -> ThresholdRequant | ShiftRequant:
    """Inverse of `pack_requant`."""
    bits = words_to_bits(words, array.requant_word_bits).reshape(-1, array.requant_entry_bits)[: spec.c_out]
    reach = accumulator_range(spec.weight, spec.input, spec.fan_in)
    if array.thresholds:
        fields = bits[:, :-1].reshape(spec.c_out, array.thresholds, array.accumulator.bits)
        thresholds = from_bits(fields, array.accumulator)
        return ThresholdRequant(thresholds, bits[:, -1].astype(np.bool_), spec.output, reach)
    ends = np.cumsum([form.bits for form in SHIFT_FIELDS])
    mult, offset, shift = (
        from_bits(bits[:, end - form.bits : end], form) for end, form in zip(ends, SHIFT_FIELDS, strict=True)
    )
    return ShiftRequant(mult, offset, shift, spec.output, reach)


def requant_words(spec: ConvSpec, array: ArrayConfig) -> int:
    """Requantiser words that the layer needs: whole tiles."""
    return array.tiles(spec.c_out) * array.drain_cycles
