"""Four image rows on chip: written pixel by pixel, read four pixels at a time."""

from amaranth.hdl import Cat, Module, Mux, Signal
from amaranth.lib import data, memory, stream, wiring
from amaranth.lib.wiring import In, Out

from macram.spec import GROUP, ArrayConfig
from macram_hw.shape import LayerShape

__all__ = ["ROWS_HELD", "LineBuffer", "LineRead"]

ROWS_HELD = 4
"""Row slots: three that a 3x3 kernel needs and one that is being filled."""


class LineRead(data.StructLayout):
    """A read: row ``slot``, word ``address`` in its bank, ``bank``, and which of the 4 pixels are real.

    With stride 2 a column is a pair of pixels: the words of the even one, then those of the odd one.
    ``apart`` leaves the outer two of the 4 places, where ``inner`` puts the inner two pixels; ``mask`` counts places.
    """

    def __init__(self, config: ArrayConfig):
        super().__init__({
            "slot": 2,
            "address": (config.row_words // config.ingest - 1).bit_length() or 1,
            "bank": (config.ingest - 1).bit_length() or 1,
            "mask": GROUP,
            "apart": 1,
            "inner": 1,
        })  # fmt: skip


class LineBuffer(wiring.Component):
    """Row y of the image lies in slot y mod 4; channel block b in bank b mod ``ingest``.

    Write throughput is one ingest word (``ingest`` blocks of one pixel) per cycle. A group of 4 columns is
    written once the group four rows above it is retired; for 3x3 kernels row -1, the padding, holds a slot
    like any other. Read latency is `LATENCY` cycles, throughput one word per cycle; pixels that
    ``mask`` leaves out read as 0, which is the zero padding. Where ``shape.biased`` the top bit of every code
    is flipped behind the mask: signed codes, and the padding with them, rise by half their range; the two places
    that ``apart`` empties stay 0.

    Members:
        start: In, begin an image. shape: In, constant during a run.
        i: In stream, ingest words.
        retire: In, strobe: the oldest group is no longer needed. retire_row: In, strobe: a whole row is not.
        group_written: Out, strobe: 4 more columns (or the rest of a row) can be read.
        image_written: Out, all rows have been written.
        read: In, `LineRead`. word: Out, 4 pixels x ``rows`` channels, pixel-major.
    """

    LATENCY = 2

    def __init__(self, config: ArrayConfig):
        self._config = config
        super().__init__({
            "start": In(1),
            "shape": In(LayerShape()),
            "i": In(stream.Signature(config.ingest * config.block_bits)),
            "retire": In(1),
            "retire_row": In(1),
            "group_written": Out(1),
            "image_written": Out(1, init=1),
            "read": In(LineRead(config)),
            "word": Out(config.line_word_bits),
        })  # fmt: skip

    def elaborate(self, platform):
        config, shape = self._config, self.shape
        m = Module()
        per_row = config.row_words // config.ingest
        row_bits = (per_row - 1).bit_length()
        block_bits = config.block_bits

        # ---- write side: word in pixel, pixel in row, row in image --------------------------------------
        word, column, row = Signal(14), Signal(16), Signal(16)
        group_base = Signal(row_bits + 1)
        # Retired rows pile up once the last row is written: at most as many as there are slots, and one.
        free = Signal(range((ROWS_HELD + 2) * per_row + 1))
        # Of a pair the odd pixel's words lie behind the even one's.
        lane, odd_words = Signal(2), Signal(14)
        put, pixel_done, row_done, group_done = Signal(), Signal(), Signal(), Signal()
        m.d.comb += [
            lane.eq(Mux(shape.halved, column[1:3], column[:2])),
            odd_words.eq(Mux(shape.halved & column[0], shape.ingest_words, 0)),
            self.i.ready.eq((free != 0) & ~self.image_written),
            put.eq(self.i.valid & self.i.ready),
            pixel_done.eq(put & (word + 1 == shape.ingest_words)),
            row_done.eq(pixel_done & (column + 1 == shape.width)),
            group_done.eq(row_done | (pixel_done & lane.all() & (column[0] | ~shape.halved))),
        ]
        m.d.sync += self.group_written.eq(group_done)
        with m.If(put):
            m.d.sync += word.eq(Mux(pixel_done, 0, word + 1))
        with m.If(pixel_done):
            m.d.sync += column.eq(Mux(row_done, 0, column + 1))
        with m.If(group_done):
            m.d.sync += group_base.eq(Mux(row_done, 0, group_base + shape.column_words))
        with m.If(row_done):
            m.d.sync += row.eq(row + 1)
            with m.If(row + 1 == shape.height):
                m.d.sync += self.image_written.eq(1)
        m.d.sync += free.eq(free - group_done + self.retire + Mux(self.retire_row, shape.groups, 0))
        with m.If(self.start):
            m.d.sync += [
                word.eq(0), column.eq(0), row.eq(0), group_base.eq(0),
                self.image_written.eq(0), self.group_written.eq(0),
                free.eq(Mux(shape.pointwise, ROWS_HELD, ROWS_HELD - 1) * shape.groups),
            ]  # fmt: skip

        # ---- banks --------------------------------------------------------------------------------------
        words = []
        for bank in range(config.ingest):
            store = memory.Memory(shape=config.line_word_bits, depth=ROWS_HELD * (1 << row_bits), init=[])
            m.submodules[f"bank{bank}"] = store
            write = store.write_port(granularity=block_bits)
            read = store.read_port()
            block = self.i.payload[bank * block_bits : (bank + 1) * block_bits]
            m.d.comb += [
                write.addr.eq(Cat((group_base + odd_words + word)[:row_bits], row[:2])),
                write.data.eq(block.replicate(GROUP)),
                write.en.eq(Mux(put, 1 << lane, 0)),
                read.addr.eq(Cat(self.read.address[:row_bits], self.read.slot)),
            ]
            words.append(read.data)

        # ---- read side: pick the bank, blank the padding ------------------------------------------------
        bank, mask = Signal.like(self.read.bank), Signal(GROUP)
        apart, inner = Signal(), Signal()
        m.d.sync += [
            bank.eq(self.read.bank), mask.eq(self.read.mask),
            apart.eq(self.read.apart), inner.eq(self.read.inner),
        ]  # fmt: skip
        picked = Signal(config.line_word_bits)
        with m.Switch(bank):
            for index, value in enumerate(words):
                with m.Case(index):
                    m.d.comb += picked.eq(value)
        half = sum(1 << (i * config.input.bits - 1) for i in range(1, config.rows + 1))
        pixels = [picked[at * block_bits : (at + 1) * block_bits] for at in range(GROUP)]
        places = [Mux(inner, pixels[1], pixels[0]), *pixels[1:3], Mux(inner, pixels[2], pixels[3])]
        for place, pixel in enumerate(places):
            raised = shape.biased if place in (0, GROUP - 1) else shape.biased & ~apart
            at = slice(place * block_bits, (place + 1) * block_bits)
            m.d.sync += self.word[at].eq(Mux(mask[place], pixel, 0) ^ Mux(raised, half, 0))
        return m
