"""Partial sums: how a layer's raw sums leave the array after one block of input channels and come back for the next."""

from amaranth.hdl import Cat, Module, Mux, Signal, signed
from amaranth.lib import data, stream, wiring
from amaranth.lib.wiring import In, Out, connect

from macram.spec import GROUP, ArrayConfig, Error
from macram_hw.engine import hdl_shape
from macram_hw.gearbox import Beat

__all__ = ["PartialSums", "SumGiver", "SumTaker", "SumWord", "sum_layout"]


def sum_layout(config: ArrayConfig) -> data.ArrayLayout:
    """Partial sums of one drain cycle: ``[channel][slot]``, as the chains bring them."""
    return data.ArrayLayout(data.ArrayLayout(hdl_shape(config.sum), GROUP), config.drain)


class SumWord(data.StructLayout):
    """Partial sums of one drain cycle; ``last`` marks the last word of the image."""

    def __init__(self, config: ArrayConfig):
        super().__init__({"sums": sum_layout(config), "last": 1})


class SumTaker(wiring.Component):
    """Beats -> words of partial sums: a shift register that is filled, then taken whole.

    Throughput is one word every ``sum_word_beats`` + 1 cycles, latency one cycle after a word's last beat. The input
    is stalled while a word waits, and outside of runs that start from sums; in other runs ``o`` is never valid and
    its payload 0, so that it may be added always.

    Members:
        start: In, begin an image. enable: In, in that cycle: the run starts from sums.
        last: In, in the cycle in which a word is taken: it is the image's last.
        i: In stream, `Beat`. o: Out stream, ``sum_layout``.
        fault, error: Out, strobe when TLAST comes early or is missing on the last beat.
    """

    def __init__(self, config: ArrayConfig):
        self._config = config
        super().__init__({
            "start": In(1),
            "enable": In(1),
            "last": In(1),
            "i": In(stream.Signature(Beat(config.stream_bits))),
            "o": Out(stream.Signature(sum_layout(config))),
            "fault": Out(1),
            "error": Out(Error, init=Error.NONE),
        })  # fmt: skip

    def elaborate(self, platform):
        config = self._config
        beats, field, bits = config.sum_word_beats, config.sum_field_bits, config.sum.bits
        m = Module()
        word = Signal(beats * config.stream_bits)
        is_open, index, ended = Signal(), Signal(range(beats)), Signal()
        put, word_last, take, early, missing = Signal(), Signal(), Signal(), Signal(), Signal()
        m.d.comb += [
            self.i.ready.eq(is_open & ~self.o.valid),
            put.eq(self.i.valid & self.i.ready),
            word_last.eq(index == beats - 1),
            take.eq(self.o.valid & self.o.ready),
            early.eq((put & self.i.payload.last & ~word_last) | (take & ended & ~self.last)),
            missing.eq(take & ~ended & self.last),
            self.fault.eq(early | missing),
            self.error.eq(Mux(early, Error.TLAST_EARLY, Error.TLAST_MISSING)),
        ]
        for at, value in enumerate(value for channel in self.o.payload for value in channel):
            m.d.comb += value.eq(word[at * field : at * field + bits].as_signed())
        with m.If(put):
            m.d.sync += [
                word.eq(Cat(word[config.stream_bits :], self.i.payload.data)),
                index.eq(Mux(word_last, 0, index + 1)),
                self.o.valid.eq(word_last),
                ended.eq(self.i.payload.last),
            ]
        with m.If(take):
            m.d.sync += self.o.valid.eq(0)
            with m.If(self.last):
                m.d.sync += is_open.eq(0)
        with m.If(self.start):
            m.d.sync += [is_open.eq(self.enable), self.o.valid.eq(0), index.eq(0), word.eq(0)]
        return m


class SumGiver(wiring.Component):
    """Words of partial sums -> beats, each sum a signed field of whole bytes, each word whole beats.

    Throughput is one word every ``sum_word_beats`` + 1 cycles, latency one cycle. The input is stalled until the
    last beat of the word before has gone.

    Members:
        start: In, forget everything on the way.
        i: In stream, `SumWord`. o: Out stream, `Beat`, TLAST on the last beat of the last word.
    """

    def __init__(self, config: ArrayConfig):
        self._config = config
        super().__init__({
            "start": In(1),
            "i": In(stream.Signature(SumWord(config))),
            "o": Out(stream.Signature(Beat(config.stream_bits))),
        })  # fmt: skip

    def elaborate(self, platform):
        config = self._config
        beats, field = config.sum_word_beats, config.sum_field_bits
        m = Module()
        word = Signal(beats * config.stream_bits, reset_less=True)
        left, image_last = Signal(range(beats + 1)), Signal()
        sums = [value for channel in self.i.payload.sums for value in channel]
        fields = [Signal(signed(field), name=f"field{at}") for at in range(len(sums))]
        m.d.comb += [
            *(wide.eq(value) for wide, value in zip(fields, sums, strict=True)),
            self.i.ready.eq(left == 0),
            self.o.valid.eq(left != 0),
            self.o.payload.data.eq(word[: config.stream_bits]),
            self.o.payload.last.eq(image_last & (left == 1)),
        ]
        with m.If(self.i.valid & self.i.ready):
            m.d.sync += [word.eq(Cat(*fields)), left.eq(beats), image_last.eq(self.i.payload.last)]
        with m.Elif(self.o.valid & self.o.ready):
            m.d.sync += [word.eq(word >> config.stream_bits), left.eq(left - 1)]
        with m.If(self.start):
            m.d.sync += left.eq(0)
        return m


class PartialSums(wiring.Component):
    """`SumTaker` and `SumGiver` at the array's streams: sums come on the parameter stream and leave as the output.

    A run that starts from sums has the parameter stream to itself until the last of them has come; a run that gives
    sums has the output to itself.

    Members:
        start: In, begin an image. takes, gives: In, constant during a run: it starts from sums, it gives sums.
        params, loads: In and Out streams, `Beat`: the parameter stream and what of it goes to the loader.
        codes, o: In and Out streams, `Beat`: the output codes, and the output.
        addends: Out stream, what the drain adds. results: In stream, `SumWord`, what it then has.
        last: In, in the cycle in which the drain takes addends: they are the image's last.
        fault, error: Out, as of `SumTaker`.
    """

    def __init__(self, config: ArrayConfig):
        self._config = config
        beats = stream.Signature(Beat(config.stream_bits))
        super().__init__({
            "start": In(1),
            "takes": In(1),
            "gives": In(1),
            "params": In(beats),
            "loads": Out(beats),
            "codes": In(beats),
            "o": Out(beats),
            "addends": Out(stream.Signature(sum_layout(config))),
            "results": In(stream.Signature(SumWord(config))),
            "last": In(1),
            "fault": Out(1),
            "error": Out(Error, init=Error.NONE),
        })  # fmt: skip

    def elaborate(self, platform):
        m = Module()
        m.submodules.taker = taker = SumTaker(self._config)
        m.submodules.giver = giver = SumGiver(self._config)
        connect(m, taker.o, wiring.flipped(self.addends))
        connect(m, wiring.flipped(self.results), giver.i)
        m.d.comb += [
            taker.start.eq(self.start),
            taker.enable.eq(self.takes),
            taker.last.eq(self.last),
            giver.start.eq(self.start),
            self.fault.eq(taker.fault),
            self.error.eq(taker.error),
            # The loader is idle meanwhile and takes nothing.
            self.loads.payload.eq(self.params.payload),
            self.loads.valid.eq(self.params.valid),
            taker.i.payload.eq(self.params.payload),
            taker.i.valid.eq(self.params.valid),
            self.params.ready.eq(self.loads.ready | taker.i.ready),
            # In a run that gives sums there are no codes.
            self.o.payload.eq(Mux(self.gives, giver.o.payload, self.codes.payload)),
            self.o.valid.eq(Mux(self.gives, giver.o.valid, self.codes.valid)),
            self.codes.ready.eq(self.o.ready & ~self.gives),
            giver.o.ready.eq(self.o.ready & self.gives),
        ]
        return m
