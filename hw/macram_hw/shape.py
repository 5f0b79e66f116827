"""The layer shape as the array's counters need it: derived once from the registers, then checked."""

from amaranth.hdl import Module, Signal
from amaranth.lib import data, wiring
from amaranth.lib.wiring import In, Out

from macram.spec import GROUP, MAX_SIDE, TAPS, ArrayConfig, Error
from macram.spec.registers import MODE_3X3
from macram_hw.divide import ceil_div_constant

__all__ = ["LayerShape", "ShapeDecoder"]


class LayerShape(data.StructLayout):
    """Counter limits of a layer.

    Fields:
        height, width: rows and columns.
        groups: 4-pixel groups per row.
        tail: width modulo 4, 0 if the last group is full.
        blocks: channel blocks; ingest_words: ``ingest`` blocks each, per pixel.
        tiles: output-channel tiles; output_words: output-buffer words per pixel.
        beats_in, beats_out: stream beats per pixel.
    """

    def __init__(self):
        super().__init__({
            "height": 16, "width": 16, "groups": 15, "tail": 2, "blocks": 14, "ingest_words": 14,
            "tiles": 12, "output_words": 12, "beats_in": 16, "beats_out": 16,
        })  # fmt: skip


def _ceil_log2_div(value, divisor: int):
    """``ceil(value / divisor)`` for a power of two."""
    return (value + (divisor - 1)) >> (divisor - 1).bit_length()


class ShapeDecoder(wiring.Component):
    """Registers -> `LayerShape` and the error a START with these registers deserves.

    Latency is `LATENCY` cycles after the registers settle.
    """

    LATENCY = 2

    def __init__(self, config: ArrayConfig):
        self._config = config
        super().__init__({
            **{name: In(32) for name in ("height", "width", "c_in", "c_out", "mode")},
            "shape": Out(LayerShape()),
            "error": Out(Error, init=Error.NONE),
        })  # fmt: skip

    def elaborate(self, platform):
        config, shape = self._config, self.shape
        m = Module()
        blocks = Signal(14)
        tiles = Signal(12)
        m.d.comb += [
            blocks.eq(ceil_div_constant(self.c_in, config.rows, config.max_c_in)),
            tiles.eq(_ceil_log2_div(self.c_out, config.units)),
        ]
        m.d.sync += [
            shape.height.eq(self.height),
            shape.width.eq(self.width),
            shape.groups.eq(_ceil_log2_div(self.width, GROUP)),
            shape.tail.eq(self.width),
            shape.blocks.eq(blocks),
            shape.ingest_words.eq(_ceil_log2_div(blocks, config.ingest)),
            shape.tiles.eq(tiles),
            shape.output_words.eq(_ceil_log2_div(self.c_out, config.output_word_channels)),
            shape.beats_in.eq(_ceil_log2_div(self.c_in * config.input.bits, config.stream_bits)),
            shape.beats_out.eq(_ceil_log2_div(self.c_out * config.output.bits, config.stream_bits)),
        ]
        too_big = [
            self.height == 0,
            self.width == 0,
            self.c_in == 0,
            self.c_out == 0,
            self.height > MAX_SIDE,
            self.width > MAX_SIDE,
            self.c_in > config.max_c_in,
            self.c_out > config.max_c_out,
            shape.tiles * shape.blocks > config.weight_depth // TAPS,
            shape.groups * shape.ingest_words > config.row_words // config.ingest,
        ]
        bad_shape = Signal(len(too_big))
        m.d.comb += [bit.eq(flag) for bit, flag in zip(bad_shape, too_big, strict=True)]
        with m.If(self.mode != MODE_3X3):
            m.d.sync += self.error.eq(Error.BAD_MODE)
        with m.Elif(bad_shape.any()):
            m.d.sync += self.error.eq(Error.BAD_SHAPE)
        with m.Else():
            m.d.sync += self.error.eq(Error.NONE)
        return m
