"""Geometry of the PIM array: what is built, and which layers it admits."""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

from macram.spec.admit import check_admits
from macram.spec.buildable import check_fields
from macram.spec.fixed import (
    DECISION_TO_RESULT,
    ENGINE_LATENCY,
    GROUP,
    MAX_THRESHOLD_BITS,
    MULT_BITS,
    OFFSET_BITS,
    SHIFT_BITS,
    TAPS,
)
from macram.spec.formats import IntFormat, ceil_div, signed_format_for
from macram.spec.layer import ConvSpec, accumulator_format
from macram.spec.tables import checked_values, read_table

REQUIRED = {
    "name": "it tells this array's reports from others'",
    "units": "for example units = 64",
    "rows": "row engines per unit, for example rows = 8",
}
"""Fields that a file must give, and what to say where it does not: without them it would be the reference array."""


@dataclass(frozen=True, slots=True)
class ArrayConfig:
    """One PIM array. Every field is a build-time constant; layer shapes are set at run time.

    Attributes:
        name: goes into the manifest and into the names of reports and of their folders.
        units: PIM units; unit u owns output channels u, u + units, ...
        rows: row engines per unit; each takes one input channel per cycle. Any number, not only a power of two.
        weight, input, output: code formats.
        max_c_in: input channels the accumulator is sized for.
        max_c_out: output channels of one pass (requantiser and carry memories).
        weight_depth: weight words per unit; a layer needs `weight_words`. Two layers that fit side by side let
            one be loaded while the other runs.
        row_words: line-buffer words (4 pixels x ``rows`` channels) per image row.
        stream_bits: TDATA width of all three streams.
        ingest: channel blocks written to the line buffer per cycle (one bank each).
        drain: channels requantised per cycle, times 4 pixels.
        engine: kind of the row engines, see `ENGINE_LATENCY`.
        residual_stream_bits: TDATA width of the two streams of the residual adder; 0 leaves it out. It takes
            unsigned output codes of up to 3 bits.
        soft_rows: so many row engines of each unit, the last ones, are ``soft`` instead.
        partial_sum_c_in: input channels of a layer that is run in blocks of channels, whose sums leave the array
            unrounded and come back for the next block; 0 leaves that out.
        requant_ram: where the requantiser's words lie, ``block`` or ``distributed`` (in LUTs), see `RAM_STYLES`.

    Raises:
        ValueError: a field is out of range or two fields do not fit together.
    """

    name: str = "reference"
    units: int = 64
    rows: int = 8
    weight: IntFormat = field(default_factory=lambda: IntFormat(3, signed=True))
    input: IntFormat = field(default_factory=lambda: IntFormat(3))
    output: IntFormat = field(default_factory=lambda: IntFormat(3))
    max_c_in: int = 1024
    max_c_out: int = 1024
    weight_depth: int = 1024
    row_words: int = 512
    stream_bits: int = 64
    ingest: int = 2
    drain: int = 4
    engine: str = "portable"
    residual_stream_bits: int = 0
    soft_rows: int = 0
    partial_sum_c_in: int = 0
    requant_ram: str = "block"

    def __post_init__(self) -> None:
        check_fields(self)

    # ---- derived widths -------------------------------------------------------------------------

    @property
    def accumulator(self) -> IntFormat:
        """Format of every accumulator: exact for ``9 * max_c_in`` products."""
        return accumulator_format(self.weight, self.input, TAPS * TAPS * self.max_c_in)

    @property
    def whole_c_in(self) -> int:
        """Input channels of the largest layer: of one run, or of all its blocks where they can be added up."""
        return self.partial_sum_c_in or self.max_c_in

    @property
    def sum(self) -> IntFormat:
        """Format of a whole layer's sums, which the requantiser takes: exact for ``9 * whole_c_in`` products."""
        return accumulator_format(self.weight, self.input, TAPS * TAPS * self.whole_c_in)

    @property
    def sum_word_beats(self) -> int:
        """Stream beats of a word of ``4 * drain`` partial sums, each of them whole bytes."""
        return ceil_div(GROUP * self.drain * self.sum_field_bits, self.stream_bits)

    @property
    def sum_field_bits(self) -> int:
        """Bits of a partial sum on a stream: whole bytes."""
        return 8 * ceil_div(self.sum.bits, 8)

    @property
    def weight_word_bits(self) -> int:
        """Bits of one weight word: ``rows`` kernel rows of 3 taps (72 for 8 rows at 3 bits)."""
        return self.rows * TAPS * self.weight.bits

    @property
    def line_word_bits(self) -> int:
        """Bits of one line-buffer word: 4 pixels of ``rows`` channels."""
        return GROUP * self.block_bits

    @property
    def block_bits(self) -> int:
        """Bits of one channel block of one pixel."""
        return self.rows * self.input.bits

    @property
    def thresholds(self) -> int:
        """Thresholds per channel, 0 if the requantiser multiplies instead."""
        return (1 << self.output.bits) - 1 if self.output.bits <= MAX_THRESHOLD_BITS else 0

    @property
    def border(self) -> IntFormat | None:
        """Format of a channel's two border terms; None where inputs are signed as they come.

        With signed codes raised by half their range, the padding beside the first and the last column, which no
        step ever reads, counts as that half times the outer taps.
        """
        if self.input.signed:
            return None
        half, count = 1 << (self.input.bits - 1), TAPS * self.whole_c_in
        return signed_format_for(half * count * self.weight.lo, half * count * self.weight.hi)

    @property
    def requant_entry_bits(self) -> int:
        """Bits of one channel's requantiser parameters, border terms included."""
        borders = 2 * self.border.bits if self.border else 0
        if self.thresholds:
            return self.thresholds * self.sum.bits + 1 + borders
        return MULT_BITS + OFFSET_BITS + SHIFT_BITS + borders

    @property
    def requant_word_bits(self) -> int:
        """Bits of one requantiser word: ``drain`` channels."""
        return self.drain * self.requant_entry_bits

    @property
    def requant_depth(self) -> int:
        """Requantiser words."""
        return self.max_c_out // self.drain

    @property
    def max_tiles(self) -> int:
        """Output-channel tiles of one pass."""
        return self.max_c_out // self.units

    @property
    def drain_cycles(self) -> int:
        """Cycles to requantise one 4-pixel group of one tile."""
        return self.units // self.drain

    @property
    def drain_period(self) -> int:
        """Fewest cycles from one sum's way into the result registers to the next one's."""
        return max(self.drain_cycles, DECISION_TO_RESULT + self.engine_latency + 1)

    @property
    def pair_drain(self) -> int:
        """The same after a sum of a triple: three rounds, of which the second waits for the carried lanes."""
        return 2 * self.drain_period + self.drain_cycles

    @property
    def triple_blocks(self) -> int:
        """Fewest channel blocks of a 1x1 kernel for which triples save cycles, see `triples`.

        Three tiles take ``3 * blocks`` cycles one by one and ``2 * max(blocks + 1, pair_drain)`` together. With partial
        sums, more than any layer has: their streams take sums of one tile.
        """
        if self.partial_sum_c_in:
            return self.blocks(self.partial_sum_c_in) + 1
        return 2 * self.pair_drain // 3 + 1

    @property
    def output_word_channels(self) -> int:
        """Channels of one pixel that leave the output buffer per cycle."""
        return GROUP * self.drain

    @property
    def row_kinds(self) -> tuple[str, ...]:
        """Kind of every row engine of a unit."""
        return (self.engine,) * (self.rows - self.soft_rows) + ("soft",) * self.soft_rows

    @property
    def paired_rows(self) -> int:
        """The first rows, served two by two by engines at twice the array's clock; 0 if the array has one clock."""
        return self.row_kinds.count("dsp48e2_2x")

    @property
    def xilinx(self) -> bool:
        """Whether the array is for UltraScale+, so that its primitives may be used throughout."""
        return any(kind != "portable" for kind in self.row_kinds)

    @property
    def engine_latency(self) -> int:
        """Cycles from activations to lane sums: those of the slowest kind, for which the others wait."""
        return max(ENGINE_LATENCY[kind] for kind in self.row_kinds)

    @property
    def peak_macs(self) -> int:
        """Multiply-accumulates per cycle with every engine busy (6144 for 64 x 8)."""
        return self.units * self.rows * GROUP * TAPS

    # ---- how a layer lies on the array ----------------------------------------------------------

    def blocks(self, c_in: int) -> int:
        """Channel blocks of ``rows`` input channels."""
        return ceil_div(c_in, self.rows)

    def tiles(self, c_out: int) -> int:
        """Output-channel tiles of ``units`` channels."""
        return ceil_div(c_out, self.units)

    def groups(self, width: int) -> int:
        """4-pixel groups of one row."""
        return ceil_div(width, GROUP)

    @staticmethod
    def phases(layer: ConvSpec) -> int:
        """Pixel phases that take part in a sum: even and odd columns of a 3x3 kernel with stride 2, else one."""
        return layer.stride if layer.kernel == TAPS else 1

    def steps(self, layer: ConvSpec) -> int:
        """Compute steps of one sum: kernel rows x pixel phases x channel blocks."""
        return layer.kernel * self.phases(layer) * self.blocks(layer.c_in)

    def packs(self, layer: ConvSpec) -> bool:
        """Whether three tiles of ``layer`` together take fewer cycles than one by one."""
        return layer.kernel == 1 and self.blocks(layer.c_in) >= self.triple_blocks

    def triples(self, layer: ConvSpec) -> int:
        """Threes of output-channel tiles that are computed together; the tiles left over come behind them.

        The three taps of a row engine then belong to three tiles, and it takes two pixels instead of four: six
        products instead of four.
        """
        return self.tiles(layer.c_out) // TAPS if self.packs(layer) else 0

    def weight_words(self, layer: ConvSpec) -> int:
        """Weight words per unit that ``layer`` needs: one per step and output-channel tile, or triple of tiles."""
        return (self.tiles(layer.c_out) - (TAPS - 1) * self.triples(layer)) * self.steps(layer)

    def requant_words(self, layer: ConvSpec) -> int:
        """Requantiser words that ``layer`` needs: whole tiles."""
        return self.tiles(layer.c_out) * self.drain_cycles

    def line_words(self, layer: ConvSpec) -> int:
        """Line-buffer words of one image row of ``layer``, those of ingest words begun but not filled included."""
        per_pixel = ceil_div(self.blocks(layer.c_in), self.ingest) * self.ingest
        return self.groups(layer.out_width) * layer.stride * per_pixel

    def biased(self, layer: ConvSpec) -> bool:
        """Whether signed input codes meet an array of unsigned inputs: they are raised by half their range."""
        return layer.input.signed and not self.input.signed

    def check_admits(self, layer: ConvSpec) -> None:
        """Refuse a layer that this array cannot run in one pass, see `macram.spec.admit`."""
        check_admits(self, layer)

    # ---- files ----------------------------------------------------------------------------------

    def to_dict(self) -> dict[str, Any]:
        """Plain values, formats as ``"u3"``/``"s3"``; `from_dict` is the inverse."""
        return {
            f.name: str(v) if isinstance(v := getattr(self, f.name), IntFormat) else v for f in fields(self)
        }

    @classmethod
    def from_dict(cls, table: dict[str, Any]) -> ArrayConfig:
        """Build from plain values.

        Raises:
            ValueError: unknown key, or a value of the wrong kind; the line names the key and what it takes.
        """
        return cls(**checked_values(table, {f.name: str(f.type) for f in fields(cls)}))

    @classmethod
    def from_toml(cls, path: Path) -> ArrayConfig:
        """Read the ``[array]`` table of a TOML file; fields that it leaves out are the reference array's.

        Raises:
            ValueError: naming the file and the fault; `REQUIRED` fields must be there.
        """
        table = read_table(path, "array")
        try:
            array = cls.from_dict(table)
        except ValueError as error:
            raise ValueError(f"{path}: {error}") from error
        if missing := [key for key in REQUIRED if key not in table]:
            raise ValueError(f"{path}: [array] has no {missing[0]}; add it, {REQUIRED[missing[0]]}")
        return array
