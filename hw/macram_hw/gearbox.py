"""Width converters between stream beats and the words of the line buffer and the output buffer."""

from amaranth.hdl import Const, Module, Mux, Signal
from amaranth.lib import data, stream, wiring
from amaranth.lib.wiring import In, Out

__all__ = ["Beat", "EmitGearbox", "IngestGearbox", "PixelWord"]


class Beat(data.StructLayout):
    """A stream beat: ``data`` and ``last`` (TLAST)."""

    def __init__(self, width: int):
        super().__init__({"data": width, "last": 1})


class PixelWord(data.StructLayout):
    """A word of one pixel; ``pixel_last`` marks its last word, ``last`` the image's last pixel."""

    def __init__(self, width: int):
        super().__init__({"data": width, "pixel_last": 1, "last": 1})


class IngestGearbox(wiring.Component):
    """Beats of a pixel -> its ingest words; every pixel starts on a beat, so leftover bits are dropped.

    Throughput is one beat and one word per cycle: a pixel of B beats and N words takes max(B, N) cycles when
    a beat holds at least a word. Latency is one cycle. A stalled output stalls the input once the buffer
    (one beat and one word) is full.

    Members:
        beats_per_pixel, words_per_pixel: In, constant during a run and a cycle before it, at least 1.
        i: In stream, `Beat`.
        o: Out stream, words.
    """

    def __init__(self, *, beat_bits: int, word_bits: int):
        self._beat, self._word = beat_bits, word_bits
        super().__init__({
            "beats_per_pixel": In(16),
            "words_per_pixel": In(16),
            "i": In(stream.Signature(beat_bits)),
            "o": Out(stream.Signature(word_bits)),
        })  # fmt: skip

    def elaborate(self, platform):
        m = Module()
        capacity = self._beat + self._word
        buffer = Signal(capacity)
        level = Signal(range(capacity + 1))
        beats_in, words_out = Signal(16), Signal(16)

        taken, pixel_done, put = Signal(), Signal(), Signal()
        level_after, beats_after = Signal.like(level), Signal(16)
        final_word = Signal(16)
        m.d.sync += final_word.eq(self.words_per_pixel - 1)
        m.d.comb += [
            self.o.payload.eq(buffer[: self._word]),
            self.o.valid.eq((level >= self._word) | (beats_in == self.beats_per_pixel)),
            taken.eq(self.o.valid & self.o.ready),
            pixel_done.eq(taken & (words_out == final_word)),
            beats_after.eq(Mux(pixel_done, 0, beats_in)),
            level_after.eq(
                Mux(pixel_done, 0, Mux(taken, Mux(level >= self._word, level - self._word, 0), level))
            ),
            self.i.ready.eq((beats_after != self.beats_per_pixel) & (level_after <= self._word)),
            put.eq(self.i.valid & self.i.ready),
        ]
        # Bits above the level stay zero: a pixel's missing top bits read as code 0.
        kept = Mux(pixel_done, 0, Mux(taken, buffer >> self._word, buffer))
        fresh = Mux(put, self.i.payload, Const(0, self._beat)) << level_after
        m.d.sync += [
            buffer.eq(kept | fresh),
            level.eq(level_after + Mux(put, self._beat, 0)),
            beats_in.eq(beats_after + put),
        ]
        with m.If(taken):
            m.d.sync += words_out.eq(Mux(pixel_done, 0, words_out + 1))
        return m


class EmitGearbox(wiring.Component):
    """Words of a pixel -> its beats; every pixel is padded with zeros to whole beats.

    Throughput is one word and one beat per cycle, with at most one idle input cycle per pixel. Latency is one
    cycle. A stalled output stalls the input once the buffer (one beat and one word) is full; a waiting beat
    does not change.

    Members:
        beats_per_pixel: In, constant during a run and a cycle before it; bits above them are dropped.
        i: In stream, `PixelWord`.
        o: Out stream, `Beat`.
    """

    def __init__(self, *, word_bits: int, beat_bits: int):
        self._word, self._beat = word_bits, beat_bits
        super().__init__({
            "beats_per_pixel": In(16),
            "i": In(stream.Signature(PixelWord(word_bits))),
            "o": Out(stream.Signature(Beat(beat_bits))),
        })  # fmt: skip

    def elaborate(self, platform):
        m = Module()
        capacity = self._beat + self._word
        buffer = Signal(capacity)
        level = Signal(range(capacity + 1))
        beats_out = Signal(16)
        complete, image_last = Signal(), Signal()

        taken, pixel_done, put = Signal(), Signal(), Signal()
        level_after = Signal.like(level)
        # Not `beats_out + 1 == beats_per_pixel`: that carry chain is where the array's longest path would begin.
        final_beat, last_beat = Signal(16), Signal()
        m.d.sync += final_beat.eq(self.beats_per_pixel - 1)
        m.d.comb += [
            last_beat.eq(beats_out == final_beat),
            self.o.payload.data.eq(buffer[: self._beat]),
            self.o.payload.last.eq(last_beat & image_last),
            self.o.valid.eq((level >= self._beat) | complete),
            taken.eq(self.o.valid & self.o.ready),
            pixel_done.eq(taken & last_beat),
            level_after.eq(
                Mux(pixel_done, 0, Mux(taken, Mux(level >= self._beat, level - self._beat, 0), level))
            ),
            self.i.ready.eq((~complete | pixel_done) & (level_after <= self._beat)),
            put.eq(self.i.valid & self.i.ready),
        ]
        kept = Mux(pixel_done, 0, Mux(taken, buffer >> self._beat, buffer))
        fresh = Mux(put, self.i.payload.data, Const(0, self._word)) << level_after
        m.d.sync += [
            buffer.eq(kept | fresh),
            level.eq(level_after + Mux(put, self._word, 0)),
        ]
        with m.If(put):
            m.d.sync += [complete.eq(self.i.payload.pixel_last), image_last.eq(self.i.payload.last)]
        with m.Elif(pixel_done):
            m.d.sync += complete.eq(0)
        with m.If(taken):
            m.d.sync += beats_out.eq(Mux(pixel_done, 0, beats_out + 1))
        return m
