"""Block RAM and DSP slices that a configuration asks for, without synthesis."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from macram.spec import GROUP, ArrayConfig, ceil_div
from macram.spec.fixed import SECTIONS

ROWS_HELD = 4
"""Image rows in the line buffer."""
BYTE = 9
"""Bits of a block RAM that share a write enable."""
SHAPES = ((512, 36), (1024, 18), (2048, 9), (4096, 4), (8192, 2), (16384, 1))
"""Words and bits of half a RAMB36E2 with a read and a write port; a whole one is as deep and twice as wide."""


@dataclass(frozen=True, slots=True)
class BlockMemory:
    """Equal memories in block RAM.

    Attributes:
        name: what they hold.
        count: how many there are.
        width, depth: bits of a word, and words.
        lanes: write enables; each has an equal share of a word.
    """

    name: str
    count: int
    width: int
    depth: int
    lanes: int = 1

    @property
    def ramb36(self) -> float:
        """RAMB36E2 of all of them, a RAMB18E2 being half of one.

        Every lane begins with a byte of its own, since a byte has one write enable.
        """
        lane = self.width // self.lanes
        width = self.lanes * ceil_div(lane, BYTE) * BYTE if self.lanes > 1 else self.width
        return self.count * halves(width, self.depth) / 2


def halves(width: int, depth: int) -> int:
    """RAMB18E2 of ``depth`` words of ``width`` bits: the shape of which the fewest are needed."""
    return min(ceil_div(width, bits) * ceil_div(depth, words) for words, bits in SHAPES)


def block_memories(config: ArrayConfig) -> tuple[BlockMemory, ...]:
    """The memories of an array that lie in block RAM."""
    row = 1 << (config.row_words // config.ingest - 1).bit_length()
    section = 1 << (config.max_c_out // config.output_word_channels - 1).bit_length()
    word = GROUP * config.output_word_channels * config.output.bits
    memories = [
        BlockMemory("weights", config.units, config.weight_word_bits, config.weight_depth),
        BlockMemory("line buffer", config.ingest, config.line_word_bits, ROWS_HELD * row, GROUP),
        BlockMemory("output buffer", 1, word, SECTIONS * section, GROUP),
    ]
    if config.requant_ram == "block":
        memories.append(BlockMemory("requantiser", 1, config.requant_word_bits, config.requant_depth))
    return tuple(memories)


def block_ram(memories: Iterable[BlockMemory]) -> float:
    """RAMB36E2 of all ``memories`` together."""
    return sum(memory.ramb36 for memory in memories)


def dsp_slices(config: ArrayConfig) -> int:
    """DSP48E2 that the units instantiate: one per row of engine ``dsp48e2``, one per pair of ``dsp48e2_2x``.

    Products outside the units (the shape check, a multiplying requantiser) are left to the tool, which takes LUTs
    for them where it has no slices left.
    """
    return config.units * (config.row_kinds.count("dsp48e2") + config.paired_rows // 2)
