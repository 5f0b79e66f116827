"""The layer shape as the array's counters need it: derived once from the registers, then checked."""

from amaranth.hdl import Cat, Module, Mux, Signal
from amaranth.lib import data, wiring
from amaranth.lib.wiring import In, Out

from macram.spec import GROUP, MAX_SIDE, RESIDUAL, TAPS, ArrayConfig, Error
from macram.spec.registers import MODE_BIASED, MODE_RESIDUAL, MODE_SUMS_IN, MODE_SUMS_OUT, MODES
from macram_hw.divide import ceil_div_constant

__all__ = ["LayerShape", "ShapeDecoder"]


class LayerShape(data.StructLayout):
    """Counter limits of a layer.

    Fields:
        height, width: rows and columns of the input. out_height: rows of the output.
        groups: 4-pixel groups per output row; with stride 2 four pairs of input pixels meet one group.
        tail: output width modulo 4, 0 if the last group is full.
        blocks: channel blocks; ingest_words: ``ingest`` blocks each, per input pixel.
        column_words: ingest words per output column: one pixel, or a pair with stride 2.
        tiles: output-channel tiles; output_words: output-buffer words per pixel.
        beats_in, beats_out: stream beats per pixel.
        pointwise: the kernel is 1x1, else 3x3. halved: the stride is 2, else 1.
        packed: output-channel tiles come in threes that are computed together, see `ArrayConfig.triples`.
        biased: signed input codes are raised by half their range.
        residual: the residual adder is in use. out_width: columns of the output. beats_residual: its stream
            beats per output pixel.
    """

    def __init__(self):
        super().__init__({
            "height": 16, "width": 16, "out_height": 16, "groups": 15, "tail": 2, "blocks": 14,
            "ingest_words": 14, "column_words": 15, "tiles": 12, "output_words": 12, "beats_in": 16,
            "beats_out": 16, "pointwise": 1, "halved": 1, "packed": 1, "biased": 1,
            "residual": 1, "out_width": 16, "beats_residual": 16,
        })  # fmt: skip


def _ceil_log2_div(value, divisor: int):
    """``ceil(value / divisor)`` for a power of two."""
    return (value + (divisor - 1)) >> (divisor - 1).bit_length()


class ShapeDecoder(wiring.Component):
    """Registers -> `LayerShape`, the parameter words the layer takes, and the error a START deserves.

    Latency is `LATENCY` cycles after the registers settle.

    Members:
        height, width, c_in, c_out, mode, weight_base, requant_base: In, from the registers.
        shape: Out. weight_end, requant_end: Out, address after the layer's last word.
        error: Out.
    """

    LATENCY = 3

    def __init__(self, config: ArrayConfig):
        self._config = config
        names = ("height", "width", "c_in", "c_out", "mode", "weight_base", "requant_base")
        super().__init__({
            **{name: In(32) for name in names},
            "shape": Out(LayerShape()),
            "weight_end": Out(range(config.weight_depth + 1)),
            "requant_end": Out(range(config.requant_depth + 1)),
            "error": Out(Error, init=Error.NONE),
        })  # fmt: skip

    def elaborate(self, platform):
        config, shape = self._config, self.shape
        m = Module()
        blocks, ingest_words = Signal(14), Signal(14)
        tiles, places = Signal(12), Signal(12)
        columns, halved, packed = Signal(32), Signal(), Signal()
        m.d.comb += [
            blocks.eq(ceil_div_constant(self.c_in, config.rows, config.max_c_in)),
            ingest_words.eq(_ceil_log2_div(blocks, config.ingest)),
            tiles.eq(_ceil_log2_div(self.c_out, config.units)),
            halved.eq(self.mode[9]),
            packed.eq(~self.mode[1] & (blocks >= config.triple_blocks) & (tiles >= TAPS)),
            columns.eq(Mux(halved, self.width[1:] + self.width[0], self.width)),
        ]
        m.d.sync += [
            shape.height.eq(self.height),
            shape.width.eq(self.width),
            shape.out_height.eq(Mux(halved, self.height[1:] + self.height[0], self.height)),
            shape.groups.eq(_ceil_log2_div(columns, GROUP)),
            shape.tail.eq(columns),
            shape.blocks.eq(blocks),
            shape.ingest_words.eq(ingest_words),
            shape.column_words.eq(Mux(halved, ingest_words << 1, ingest_words)),
            shape.tiles.eq(tiles),
            shape.output_words.eq(_ceil_log2_div(self.c_out, config.output_word_channels)),
            shape.beats_in.eq(_ceil_log2_div(self.c_in * config.input.bits, config.stream_bits)),
            shape.beats_out.eq(_ceil_log2_div(self.c_out * config.output.bits, config.stream_bits)),
            shape.pointwise.eq(~self.mode[1]),
            shape.halved.eq(halved),
            shape.packed.eq(packed),
            places.eq(tiles - Mux(packed, (TAPS - 1) * self._triples(tiles), 0)),
            shape.biased.eq(self.mode[MODE_BIASED]),
        ]
        if config.residual_stream_bits:
            m.d.sync += [
                shape.residual.eq(self.mode[MODE_RESIDUAL]),
                shape.out_width.eq(columns),
                shape.beats_residual.eq(
                    _ceil_log2_div(self.c_out * RESIDUAL.bits, config.residual_stream_bits)
                ),
            ]
        self._check(m, places)
        return m

    def _triples(self, tiles):
        """Threes of ``tiles``, of which there are at least two: ``floor(n / 3) = ceil((n - 2) / 3)``."""
        return ceil_div_constant((tiles - (TAPS - 1))[: len(tiles)], TAPS, self._config.max_tiles)

    def _check(self, m, places):
        """Two more stages: products and limits, then bases and the verdict."""
        config, shape = self._config, self.shape
        sums, weight_words = Signal(26), Signal(29)
        m.d.comb += sums.eq(places * shape.blocks)
        with m.If(shape.pointwise):
            m.d.sync += weight_words.eq(sums)
        with m.Else():
            # Three kernel rows by an adder: a second multiplier behind the first would be the array's longest path.
            m.d.sync += weight_words.eq(((sums << 1) + sums) << shape.halved)
        too_big = Cat(
            self.height == 0,
            self.width == 0,
            self.c_in == 0,
            self.c_out == 0,
            self.height > MAX_SIDE,
            self.width > MAX_SIDE,
            self.c_in > config.max_c_in,
            self.c_out > config.max_c_out,
            shape.groups * shape.column_words > config.row_words // config.ingest,
        )
        known_mode = Signal()
        biased = [1 << MODE_BIASED] if not config.input.signed else []
        residual = [1 << MODE_RESIDUAL] if config.residual_stream_bits else []
        into, out = ([1 << bit] if config.partial_sum_c_in else [] for bit in (MODE_SUMS_IN, MODE_SUMS_OUT))
        # Without codes there is nothing to add to a residual stream.
        ends = [a | b for a in [0, *into] for b in [0, *residual, *out]]
        with m.Switch(self.mode):
            with m.Case(*(mode | sign | end for mode in MODES for sign in [0, *biased] for end in ends)):
                m.d.comb += known_mode.eq(1)
        bad_mode, bad_shape = Signal(), Signal()
        m.d.sync += [bad_mode.eq(~known_mode), bad_shape.eq(too_big.any())]

        requant_words = shape.tiles * config.drain_cycles
        with m.If(bad_mode):
            m.d.sync += self.error.eq(Error.BAD_MODE)
        with m.Elif(bad_shape | (weight_words > config.weight_depth)):
            m.d.sync += self.error.eq(Error.BAD_SHAPE)
        with m.Elif(
            (self.weight_base + weight_words > config.weight_depth)
            | (self.requant_base + requant_words > config.requant_depth)
        ):
            m.d.sync += self.error.eq(Error.BAD_RANGE)
        with m.Else():
            m.d.sync += self.error.eq(Error.NONE)
        m.d.sync += [
            self.weight_end.eq(self.weight_base + weight_words),
            self.requant_end.eq(self.requant_base + requant_words),
        ]
