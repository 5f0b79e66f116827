"""Block RAM of an array, computed from its configuration by the RAMB36E2 aspect-ratio rule.

A RAMB36E2 is 32,768 x 1 up to 1,024 x 36 bits, or 512 x 72 in simple dual port mode; its halves are two
independent RAMB18 of half the depth (AMD UG573). Synthesis may choose otherwise: these are figures from the
geometry, not from a vendor tool, and reports say so.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

from macram.spec import GROUP, ArrayConfig, ConvSpec, ceil_div
from macram.spec.fixed import SECTIONS

RAMB18_SHAPES = ((512, 36), (1024, 18), (2048, 9), (4096, 4), (8192, 2), (16384, 1))
"""Depth x width of half a RAMB36E2; 512 x 36 in simple dual port mode."""
ROWS_HELD = 4
"""Image rows in the line buffer: three for a 3x3 kernel and one being filled."""
ZU3EG_RAMB36 = 216
"""RAMB36 of the Ultra96v2's device."""


@dataclass(frozen=True, slots=True)
class Memory:
    """``count`` equal memories of ``depth`` words of ``width`` bits, ``used`` words taken by a layer.

    Attributes:
        name: what it holds.
        count: how many of them.
        depth: words.
        width: bits of one word.
        grain: bits written together; each grain takes whole 9-bit byte lanes.
        used: words of each that the layer needs, at most ``depth``.
    """

    name: str
    count: int
    depth: int
    width: int
    grain: int
    used: int

    @property
    def ramb36_each(self) -> float:
        """RAMB36 of one memory, a multiple of one half."""
        return ramb36(self.depth, self.width, self.grain)

    def to_dict(self) -> dict[str, Any]:
        """Plain values, with the derived ones a report shows."""
        return asdict(self) | {
            "ramb36_each": self.ramb36_each,
            "ramb36": self.count * self.ramb36_each,
            "used_share": self.used / self.depth,
        }


def ramb36(depth: int, width: int, grain: int | None = None) -> float:
    """RAMB36 (in halves) for ``depth`` words of ``width`` bits, built from one aspect ratio, the best.

    With ``grain`` below ``width`` parts of a word are written alone, which only byte lanes of 9 bits can do.
    """
    lanes = width
    shapes: tuple[tuple[int, int], ...] = RAMB18_SHAPES
    if grain is not None and grain < width:
        lanes = width // grain * ceil_div(grain, 9) * 9
        shapes = tuple(shape for shape in RAMB18_SHAPES if shape[1] >= 9)
    return min(ceil_div(depth, d) * ceil_div(lanes, w) for d, w in shapes) / 2


def memories(array: ArrayConfig, layer: ConvSpec) -> list[Memory]:
    """The array's block memories, and how much of each ``layer`` uses; small ones in LUTs are left out."""
    per_bank = array.row_words // array.ingest
    row_used = array.line_words(layer) // array.ingest
    section = array.max_c_out // array.output_word_channels
    codes = array.output_word_channels * array.output.bits
    rows = (
        ("weights, one per unit", array.units,
         array.weight_depth, array.weight_word_bits, array.weight_word_bits, array.weight_words(layer)),
        ("line buffer, one per bank", array.ingest,
         ROWS_HELD * power_of_two(per_bank), array.line_word_bits, array.block_bits,
         min(ROWS_HELD, layer.height) * row_used),
        ("requantiser", 1,
         array.requant_depth, array.requant_word_bits, array.requant_word_bits,
         ceil_div(layer.c_out, array.drain)),
        ("output buffer", 1,
         SECTIONS * power_of_two(section), GROUP * codes, codes,
         SECTIONS * ceil_div(layer.c_out, array.output_word_channels)),
    )  # fmt: skip
    return [Memory(*row) for row in rows]


def power_of_two(value: int) -> int:
    """Smallest power of two not below ``value``: addresses are concatenated bit fields."""
    return 1 << (value - 1).bit_length()


def bram_report(array: ArrayConfig, layer: ConvSpec) -> dict[str, Any]:
    """Table of `memories` with totals, plain values for JSON."""
    rows = [memory.to_dict() for memory in memories(array, layer)]
    total = sum(row["ramb36"] for row in rows)
    return {
        "basis": "computed from the configuration by the RAMB36E2 aspect-ratio rule, not synthesised",
        "memories": rows,
        "ramb36_total": total,
        "device": "ZU3EG",
        "device_ramb36": ZU3EG_RAMB36,
        "device_share": total / ZU3EG_RAMB36,
    }
