"""Which configurations can be built: ranges of the fields, and what must fit together."""

from __future__ import annotations

import operator
import re
from typing import TYPE_CHECKING

from macram.spec.fixed import (
    ENGINE_LATENCY,
    GROUP,
    MAX_BRANCH_BITS,
    MAX_SUM_CHANNELS,
    PACKED_BITS,
    RAM_STYLES,
    STREAM_BITS,
)

if TYPE_CHECKING:
    from macram.spec.array import ArrayConfig

_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*")


def check_fields(array: ArrayConfig) -> None:
    """Refuse a configuration that cannot be built.

    Raises:
        ValueError: a field is out of range or two fields do not fit together.
    """
    if not _NAME.fullmatch(array.name):
        raise ValueError(
            f"name must be letters, digits, '.', '_' and '-', a letter or digit first, not {array.name!r}: it "
            f"becomes part of file names"
        )
    limits = {
        "units": (4, 1024), "rows": (1, 64), "max_c_in": (1, 8192), "max_c_out": (1, 8192),
        "weight_depth": (3, 1 << 16), "row_words": (2, 1 << 16), "drain": (1, 64),
    }  # fmt: skip
    for key, (lo, hi) in limits.items():
        value = operator.index(getattr(array, key))
        if not lo <= value <= hi:
            raise ValueError(f"{key} must be in {lo}..{hi}, not {value}")
    if array.engine not in ENGINE_LATENCY:
        raise ValueError(f"engine must be one of {', '.join(ENGINE_LATENCY)}, not {array.engine!r}")
    if array.requant_ram not in RAM_STYLES:
        raise ValueError(f"requant_ram must be one of {', '.join(RAM_STYLES)}, not {array.requant_ram!r}")
    most = 0 if array.engine == "soft" else array.rows - 1
    if not 0 <= array.soft_rows <= most:
        raise ValueError(
            f"soft_rows must be in 0..{most} with {array.rows} rows of engine {array.engine}, not {array.soft_rows}"
        )
    if array.paired_rows % 2:
        raise ValueError(
            f"engine {array.engine} serves rows in pairs: rows less soft_rows must be an even number, "
            f"not {array.paired_rows}"
        )
    packed = [kind for kind in dict.fromkeys(array.row_kinds) if kind != "portable"]
    if packed and (array.weight.bits > PACKED_BITS or array.input.bits > PACKED_BITS or array.input.signed):
        raise ValueError(
            f"engine {packed[0]} takes weights and unsigned inputs of up to {PACKED_BITS} bits, "
            f"not {array.weight} and {array.input}; use portable"
        )
    for key in ("units", "drain"):
        value = getattr(array, key)
        if value & (value - 1):
            raise ValueError(f"{key} must be a power of two, not {value}")
    for key in ("weight", "input", "output"):
        bits = getattr(array, key).bits
        if not 2 <= bits <= 8:
            raise ValueError(f"{key} bits must be in 2..8, not {bits}")
    if not array.weight.signed:
        raise ValueError(f"weight must be a signed format, not {array.weight}")
    if array.stream_bits not in STREAM_BITS:
        raise ValueError(f"stream_bits must be 32, 64, 128, 256 or 512, not {array.stream_bits!r}")
    if array.residual_stream_bits not in (0, *STREAM_BITS):
        raise ValueError(
            f"residual_stream_bits must be 0, 32, 64, 128, 256 or 512, not {array.residual_stream_bits!r}"
        )
    if array.residual_stream_bits and (array.output.signed or array.output.bits > MAX_BRANCH_BITS):
        raise ValueError(
            f"the residual adder takes unsigned output codes of up to {MAX_BRANCH_BITS} bits, not "
            f"{array.output}; leave residual_stream_bits at 0"
        )
    if array.ingest not in (1, 2, 4, 8):
        raise ValueError(f"ingest must be 1, 2, 4 or 8, not {array.ingest!r}")
    if array.units % (GROUP * array.drain):
        raise ValueError(f"units must be a multiple of 4 * drain = {GROUP * array.drain}, not {array.units}")
    if array.row_words % array.ingest:
        raise ValueError(f"row_words must be a multiple of ingest = {array.ingest}, not {array.row_words}")
    if array.max_c_out % array.units:
        raise ValueError(f"max_c_out must be a multiple of units = {array.units}, not {array.max_c_out}")
    if array.partial_sum_c_in and not array.max_c_in <= array.partial_sum_c_in <= MAX_SUM_CHANNELS:
        raise ValueError(
            f"partial_sum_c_in must be 0 or in {array.max_c_in}..{MAX_SUM_CHANNELS} (from max_c_in), not "
            f"{array.partial_sum_c_in}"
        )
