"""The small arrays of the regression: together they have every kind of engine, requantiser and stream."""

from __future__ import annotations

from dataclasses import replace

from macram.spec import ArrayConfig, IntFormat

_SMALL = ArrayConfig(
    name="portable",
    units=8,
    rows=2,
    max_c_in=16,
    max_c_out=32,
    weight_depth=64,
    row_words=32,
    stream_bits=32,
    drain=2,
)
ARRAYS = (
    _SMALL,
    replace(_SMALL, name="dsp48e2", engine="dsp48e2"),
    replace(
        _SMALL, name="8-bit", weight=IntFormat(8, signed=True), input=IntFormat(8), output=IntFormat(8), stream_bits=64
    ),
    replace(
        _SMALL, name="signed", weight=IntFormat(4, signed=True), input=IntFormat(3, signed=True),
        output=IntFormat(4, signed=True), rows=4, drain=1, ingest=1,
    ),
    replace(_SMALL, name="triples", rows=1, max_c_in=32, row_words=128, weight_depth=120),
    replace(
        _SMALL, name="residual", engine="dsp48e2_2x", rows=3, soft_rows=1, residual_stream_bits=32,
        requant_ram="distributed",
    ),
    replace(
        _SMALL, name="partial", engine="dsp48e2", rows=3, soft_rows=1, max_c_in=12, partial_sum_c_in=48,
        residual_stream_bits=128,
    ),
    replace(_SMALL, name="soft", engine="soft", output=IntFormat(6), drain=1, max_c_in=8, partial_sum_c_in=32),
)  # fmt: skip
"""What each adds: ``8-bit`` the multiplier-and-shift requantiser, ``signed`` signed formats and one bank, ``triples``
1x1 tiles in threes, ``residual`` two clocks beside LUT engines and the residual adder, ``partial`` partial sums with a
residual sum behind them, ``soft`` LUT engines alone and partial sums before multiplier and shift."""
