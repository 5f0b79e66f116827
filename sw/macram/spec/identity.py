"""The read-only registers by which an array says how it was built."""

from __future__ import annotations

from macram.spec.array import ArrayConfig
from macram.spec.formats import IntFormat
from macram.spec.registers import ID_VALUE, VERSION_VALUE


def identity(array: ArrayConfig) -> dict[str, int]:
    """Register name -> value of those that describe ``array``, laid out as in `macram.spec.registers`."""

    def form(value: IntFormat) -> int:
        return value.bits | value.signed << 7

    return {
        "ID": ID_VALUE,
        "VERSION": VERSION_VALUE,
        "GEOMETRY": array.units | array.rows << 16 | array.drain << 24,
        "FORMATS": array.weight.bits | form(array.input) << 8 | form(array.output) << 16,
        "WEIGHT_DEPTH": array.weight_depth,
        "ROW_WORDS": array.row_words,
        "MAX_CHANNELS": array.max_c_in | array.max_c_out << 16,
        "RESIDUAL": array.residual_stream_bits,
        "PARTIAL_C_IN": array.partial_sum_c_in,
    }
