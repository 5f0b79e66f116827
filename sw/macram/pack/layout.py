"""Where every weight and every requantiser parameter lies in the array's memories: the hardware contract.

Weights. Unit u owns the output channels u, u + units, u + 2 units, ...; tile o is ``channel // units``. The
input channels form ``blocks`` blocks of ``rows``. Unless tiles come in triples, the word of unit u at address
``((o * kernel + ky) * phases + phase) * blocks + cb`` holds for row engine r (input channel ``cb * rows + r``)
three fields of the weight format, field j at bit ``(r * 3 + j) * bits``. Field j meets the pixel whose column is
one less than j away from the output column, so with the kernel row ``w`` of the channel pair the fields are

- 3x3, stride 1 (one phase): ``w[2], w[1], w[0]``, taps reversed;
- 3x3, stride 2: phase 0, the even pixels, ``0, w[1], 0``; phase 1, the odd pixels, ``0, w[2], w[0]``;
- 1x1 (one phase): ``0, w[0], 0``.

Where three tiles of a 1x1 kernel are computed together (`ArrayConfig.triples`), field j is the ``w[0]`` of tile
``3 t + j`` in the word at ``t * blocks + cb``, t counting triples. A tile that is left over has its ``w[0]`` in
field 0; its words lie behind those of the triples and of the tiles before it.

Requantiser. The word at address ``o * (units / drain) + d`` holds the channels ``o * units + d * drain + q``
for q in 0..drain - 1, entry q at bit ``q * requant_entry_bits``. A threshold entry is the thresholds in
ascending order, lowest first, each in the format of a whole layer's sums, then the invert bit. A shift entry is
mult (18 bits), offset (48), shift (6), lowest first. On arrays of unsigned inputs both are followed by the left
and the right border term (`macram.pack.signed`), and thresholds and offset allow for raised input codes.

Channels that the layer does not have are weights 0, and requantiser entries that give the code 0: thresholds
at the largest value of that format, which no sum reaches, the lower half of them at its smallest value
if codes are signed; or mult, offset and shift 0.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from macram.golden import ShiftRequant, ThresholdRequant
from macram.pack.bits import Words, bits_to_words, from_bits, to_bits, words_to_bits
from macram.pack.signed import Rise
from macram.spec import TAPS, ArrayConfig, ConvSpec, IntFormat, accumulator_range
from macram.spec.fixed import MULT_BITS, OFFSET_BITS, SHIFT_BITS

Requant = ThresholdRequant | ShiftRequant

BIT_ORDER = {
    "weights": (
        "unit u owns output channels u, u + units, ...; tile o = channel // units; "
        "word ((o * kernel + ky) * phases + phase) * blocks + cb, field j of row engine r at bit "
        "(r * 3 + j) * weight_bits, two's complement; with w = weights[o * units + u, cb * rows + r, ky] the "
        "fields are w[2] w[1] w[0]; for 3x3 with stride 2 0 w[1] 0 in phase 0 and 0 w[2] w[0] in phase 1; "
        "for 1x1 0 w[0] 0; of 1x1 tiles in threes field j of word t * blocks + cb is w[0] of tile 3 * t + j, "
        "and tiles left over follow with w[0] 0 0"
    ),
    "threshold": (
        "word o * (units / drain) + d holds channels o * units + d * drain + q, entry q at bit "
        "q * entry_bits: thresholds ascending from the low end, accumulator_bits each, two's complement, "
        "then 1 invert bit, then left and right border term, border_bits each, on arrays of unsigned inputs"
    ),
    "shift": (
        "word o * (units / drain) + d holds channels o * units + d * drain + q, entry q at bit "
        "q * entry_bits: mult (18 bits, signed), offset (48 bits, signed), shift (6 bits) from the low end, "
        "then left and right border term, border_bits each, on arrays of unsigned inputs"
    ),
}
"""One sentence per memory for manifests and file headers."""

SHIFT_FIELDS = (
    IntFormat(MULT_BITS, signed=True),
    IntFormat(OFFSET_BITS, signed=True),
    IntFormat(SHIFT_BITS),
)


def pack_weights(weights: NDArray[np.int64], spec: ConvSpec, array: ArrayConfig) -> Words:
    """Codes ``[c_out, c_in, kernel, kernel]`` -> words ``[units, weight_words, bytes]``."""
    tiles, blocks = array.tiles(spec.c_out), array.blocks(spec.c_in)
    if array.triples(spec):
        alone = np.zeros((tiles, array.units, blocks, array.rows), np.int64)
        alone.reshape(tiles * array.units, -1)[: spec.c_out, : spec.c_in] = weights[..., 0, 0]
        words = array.weight_words(spec)
        together = np.zeros((array.units, words // blocks, blocks, array.rows, TAPS), np.int64)
        for tile, (place, field) in enumerate(_places(spec, array)):
            together[:, place, ..., field] = alone[tile]
        bits = to_bits(together, array.weight)
        return bits_to_words(bits.reshape(array.units, words, array.weight_word_bits))
    kernel, phases = spec.kernel, array.phases(spec)
    whole = np.zeros((tiles * array.units, blocks * array.rows, kernel, phases, TAPS), np.int64)
    for phase, field, tap in _fields(kernel, phases):
        whole[: spec.c_out, : spec.c_in, :, phase, field] = weights[..., tap]
    fields = whole.reshape(tiles, array.units, blocks, array.rows, kernel, phases, TAPS)
    bits = to_bits(fields.transpose(1, 0, 4, 5, 2, 3, 6), array.weight)
    return bits_to_words(bits.reshape(array.units, array.weight_words(spec), array.weight_word_bits))


def unpack_weights(words: Words, spec: ConvSpec, array: ArrayConfig) -> NDArray[np.int64]:
    """Inverse of `pack_weights`."""
    tiles, blocks = array.tiles(spec.c_out), array.blocks(spec.c_in)
    kernel, phases = spec.kernel, array.phases(spec)
    bits = words_to_bits(words, array.weight_word_bits)
    if array.triples(spec):
        shape = (array.units, -1, blocks, array.rows, TAPS, array.weight.bits)
        together = from_bits(bits.reshape(shape), array.weight)
        alone = np.stack([together[:, place, ..., field] for place, field in _places(spec, array)])
        return alone.reshape(tiles * array.units, -1)[: spec.c_out, : spec.c_in, None, None]
    bits = bits.reshape(array.units, tiles, kernel, phases, blocks, array.rows, TAPS, array.weight.bits)
    fields = from_bits(bits, array.weight).transpose(1, 0, 4, 5, 2, 3, 6)
    whole = fields.reshape(tiles * array.units, blocks * array.rows, kernel, phases, TAPS)
    weights = np.empty((spec.c_out, spec.c_in, kernel, kernel), np.int64)
    for phase, field, tap in _fields(kernel, phases):
        weights[..., tap] = whole[: spec.c_out, : spec.c_in, :, phase, field]
    return weights


def _fields(kernel: int, phases: int) -> tuple[tuple[int, int, int], ...]:
    """Where each tap of a kernel row is stored: (phase, field, tap)."""
    if kernel == 1:
        return ((0, 1, 0),)
    if phases == 1:
        return ((0, 0, 2), (0, 1, 1), (0, 2, 0))
    return ((0, 1, 1), (1, 1, 2), (1, 2, 0))


def _places(spec: ConvSpec, array: ArrayConfig) -> list[tuple[int, int]]:
    """Of each tile, the place (triple or tile left over) of its words and the field in them."""
    tiles, triples = array.tiles(spec.c_out), array.triples(spec)
    return [
        divmod(tile, TAPS) if tile < TAPS * triples else (tile - (TAPS - 1) * triples, 0)
        for tile in range(tiles)
    ]


def pack_requant(requant: Requant, rise: Rise, array: ArrayConfig, words: int) -> Words:
    """Parameters -> words ``[words, bytes]``; channels beyond the layer's get the entry that gives 0."""
    channels = words * array.drain
    if isinstance(requant, ThresholdRequant):
        own = requant.thresholds + rise.total[:, None]
        thresholds = _absent_thresholds(array, channels)
        # What lies beyond the accumulator's range is reached by every sum or by none, like the end of the range.
        thresholds[: len(own)] = own.clip(array.sum.lo, array.sum.hi)
        invert = _column(requant.invert, channels)
        field_bits = array.thresholds * array.sum.bits
        parts = [
            to_bits(thresholds, array.sum).reshape(channels, field_bits),
            to_bits(invert, IntFormat(1)),
        ]
    else:
        offset = requant.offset - requant.mult * rise.total
        columns = zip((requant.mult, offset, requant.shift), SHIFT_FIELDS, strict=True)
        parts = [to_bits(_column(values, channels), form) for values, form in columns]
    if array.border:
        parts += [to_bits(_column(values, channels), array.border) for values in (rise.left, rise.right)]
    return bits_to_words(np.concatenate(parts, axis=1).reshape(words, array.requant_word_bits))


def absent_requant(array: ArrayConfig, words: int) -> Words:
    """Words of channels that no layer has; they give the code 0."""
    none = np.zeros(0, np.int64)
    requant: Requant
    if array.thresholds:
        requant = ThresholdRequant(
            none.reshape(0, array.thresholds), none.astype(np.bool_), array.output, (0, 0)
        )
    else:
        requant = ShiftRequant(none, none, none, array.output, (0, 0))
    return pack_requant(requant, Rise(none, none, none), array, words)


def _absent_thresholds(array: ArrayConfig, channels: int) -> NDArray[np.int64]:
    thresholds = np.full((channels, array.thresholds), array.sum.hi, np.int64)
    if array.output.signed:
        # Code 0 lies half the range up.
        thresholds[:, : -array.output.lo] = array.sum.lo
    return thresholds


def _column(values: NDArray[np.generic], channels: int) -> NDArray[np.int64]:
    column = np.zeros(channels, np.int64)
    column[: len(values)] = values
    return column


def unpack_requant(words: Words, rise: Rise, spec: ConvSpec, array: ArrayConfig) -> Requant:
    """Inverse of `pack_requant`, up to thresholds that no sum reaches or every sum does."""
    bits = words_to_bits(words, array.requant_word_bits).reshape(-1, array.requant_entry_bits)[: spec.c_out]
    reach = accumulator_range(spec.weight, spec.input, spec.fan_in)
    if array.thresholds:
        invert = array.thresholds * array.sum.bits
        fields = bits[:, :invert].reshape(spec.c_out, array.thresholds, array.sum.bits)
        thresholds = from_bits(fields, array.sum) - rise.total[:, None]
        if array.biased(spec):
            thresholds = thresholds.clip(reach[0], reach[1] + 1)
        return ThresholdRequant(thresholds, bits[:, invert].astype(np.bool_), spec.output, reach)
    ends = np.cumsum([form.bits for form in SHIFT_FIELDS])
    mult, offset, shift = (
        from_bits(bits[:, end - form.bits : end], form) for end, form in zip(ends, SHIFT_FIELDS, strict=True)
    )
    return ShiftRequant(mult, offset + mult * rise.total, shift, spec.output, reach)


def unpack_borders(words: Words, spec: ConvSpec, array: ArrayConfig) -> tuple[NDArray[np.int64], ...]:
    """Left and right border terms ``[c_out]`` each; empty tuple where the array has none."""
    if not array.border:
        return ()
    bits = words_to_bits(words, array.requant_word_bits).reshape(-1, array.requant_entry_bits)[: spec.c_out]
    size = array.border.bits
    return from_bits(bits[:, -2 * size : -size], array.border), from_bits(bits[:, -size:], array.border)
