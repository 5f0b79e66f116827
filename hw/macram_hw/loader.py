"""The parameter loader: stream beats -> weight memories and requantiser parameters."""

from amaranth.hdl import Module, Mux, Signal
from amaranth.lib import stream, wiring
from amaranth.lib.wiring import In, Out

from macram.spec import ArrayConfig, Error, ceil_div
from macram_hw.drain import RequantWrite
from macram_hw.gearbox import Beat
from macram_hw.unit import WeightWrite

__all__ = ["Loader"]


class Loader(wiring.Component):
    """Words arrive low beat first, each padded to whole beats; weights go unit by unit, in address order.

    Throughput is one beat per cycle; the stream is never stalled while a load runs and always while
    none does.
    TLAST must be on the last beat and nowhere else.

    Members:
        start_weights, start_requant: In, strobes. words: In, words per unit, or in all for the requantiser.
        base: In, address of the first of them. Both must not change while busy.
        i: In stream, `Beat`.
        unit_en: Out, one write enable per unit. weight: Out. requant_en, requant: Out.
        busy: Out. to_requant: Out, whether the load goes, or last went, to the requantiser.
        error: Out, `Error`, valid in the cycle in which ``fault`` is high.
    """

    def __init__(self, config: ArrayConfig):
        self._config = config
        super().__init__({
            "start_weights": In(1),
            "start_requant": In(1),
            "words": In(32),
            "base": In(32),
            "i": In(stream.Signature(Beat(config.stream_bits))),
            "unit_en": Out(config.units),
            "weight": Out(WeightWrite(config)),
            "requant_en": Out(1),
            "requant": Out(RequantWrite(config)),
            "busy": Out(1),
            "to_requant": Out(1),
            "fault": Out(1),
            "error": Out(Error, init=Error.NONE),
        })  # fmt: skip

    def elaborate(self, platform):
        config = self._config
        beat = config.stream_bits
        weight_beats = ceil_div(config.weight_word_bits, beat)
        requant_beats = ceil_div(config.requant_word_bits, beat)
        m = Module()

        shifter = Signal(beat * max(weight_beats, requant_beats), reset_less=True)
        to_requant = self.to_requant
        beat_index = Signal(range(max(weight_beats, requant_beats) + 1))
        word_index = Signal(range(max(config.weight_depth, config.requant_depth) + 1))
        unit = Signal(config.units)
        put, word_done, unit_done, all_done = Signal(), Signal(), Signal(), Signal()
        beats = Mux(to_requant, requant_beats, weight_beats)
        m.d.comb += [
            self.i.ready.eq(self.busy),
            put.eq(self.i.valid & self.i.ready),
            word_done.eq(put & (beat_index + 1 == beats)),
            unit_done.eq(word_done & (word_index + 1 == self.words)),
            all_done.eq(unit_done & (to_requant | unit[-1])),
            self.fault.eq(put & (self.i.payload.last != all_done)),
            self.error.eq(Mux(self.i.payload.last, Error.TLAST_EARLY, Error.TLAST_MISSING)),
        ]
        with m.If(put):
            # The first beat of a word ends lowest among those shifted in since.
            m.d.sync += [
                shifter.eq((shifter >> beat) | (self.i.payload.data << (len(shifter) - beat))),
                beat_index.eq(Mux(word_done, 0, beat_index + 1)),
            ]
        with m.If(word_done):
            m.d.sync += word_index.eq(Mux(unit_done, 0, word_index + 1))
        with m.If(unit_done):
            m.d.sync += unit.eq(unit << 1)
        with m.If(all_done | self.fault):
            m.d.sync += self.busy.eq(0)
        with m.If(~self.busy & (self.start_weights | self.start_requant)):
            m.d.sync += [
                self.busy.eq(1), to_requant.eq(self.start_requant),
                beat_index.eq(0), word_index.eq(0), unit.eq(1),
            ]  # fmt: skip

        # The write happens in the cycle after the word's last beat.
        m.d.sync += [
            self.unit_en.eq(Mux(word_done & ~to_requant, unit, 0)),
            self.requant_en.eq(word_done & to_requant),
            self.weight.addr.eq(self.base + word_index),
            self.requant.addr.eq(self.base + word_index),
        ]
        m.d.comb += [
            self.weight.data.eq(shifter[-beat * weight_beats :][: config.weight_word_bits]),
            self.requant.data.eq(shifter[-beat * requant_beats :][: config.requant_word_bits]),
        ]
        return m
