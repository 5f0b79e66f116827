"""The check at the head of an image stream: one image per run, TLAST where it ends."""

from amaranth.hdl import Module, Mux, Signal
from amaranth.lib import stream, wiring
from amaranth.lib.wiring import In, Out

from macram.spec import Error
from macram_hw.gearbox import Beat

__all__ = ["FrameCheck"]


class FrameCheck(wiring.Component):
    """Lets exactly one image pass and compares TLAST with its size.

    No latency: beats pass through; ``i`` is stalled outside an image.

    Members:
        start: In, open for an image.
        beats, width, height: In, constant during a run: beats per pixel, columns, rows.
        i: In stream, `Beat`. o: Out stream, data.
        open: Out, beats of the image are still to come.
        fault, error: Out, strobe when TLAST comes early or is missing on the last beat.
    """

    def __init__(self, *, beat_bits: int):
        super().__init__({
            "start": In(1),
            **{name: In(16) for name in ("beats", "width", "height")},
            "i": In(stream.Signature(Beat(beat_bits))),
            "o": Out(stream.Signature(beat_bits)),
            "open": Out(1),
            "fault": Out(1),
            "error": Out(Error, init=Error.NONE),
        })  # fmt: skip

    def elaborate(self, platform):
        m = Module()
        is_open = self.open
        beat, column, row = Signal(16), Signal(16), Signal(16)
        put, pixel_last, row_last, image_last = Signal(), Signal(), Signal(), Signal()
        m.d.comb += [
            self.o.payload.eq(self.i.payload.data),
            self.o.valid.eq(self.i.valid & is_open),
            self.i.ready.eq(self.o.ready & is_open),
            put.eq(self.i.valid & self.i.ready),
            pixel_last.eq(beat + 1 == self.beats),
            row_last.eq(pixel_last & (column + 1 == self.width)),
            image_last.eq(row_last & (row + 1 == self.height)),
            self.fault.eq(put & (self.i.payload.last != image_last)),
            self.error.eq(Mux(self.i.payload.last, Error.TLAST_EARLY, Error.TLAST_MISSING)),
        ]
        with m.If(put):
            m.d.sync += beat.eq(Mux(pixel_last, 0, beat + 1))
            with m.If(pixel_last):
                m.d.sync += column.eq(Mux(row_last, 0, column + 1))
            with m.If(row_last):
                m.d.sync += row.eq(row + 1)
            with m.If(image_last):
                m.d.sync += is_open.eq(0)
        with m.If(self.start):
            m.d.sync += [is_open.eq(1), beat.eq(0), column.eq(0), row.eq(0)]
        return m
