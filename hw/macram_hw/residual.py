"""The residual adder: the array's codes plus an 8-bit stream that comes from outside, before they leave."""

from amaranth.hdl import Array, Cat, Module, Mux, Signal
from amaranth.lib import data, stream, wiring
from amaranth.lib.wiring import In, Out

from macram.spec import RESIDUAL, ArrayConfig
from macram_hw.engine import adder_tree
from macram_hw.gearbox import PixelWord

__all__ = ["ResidualAdder", "ResidualTables"]


class ResidualTables(data.StructLayout):
    """Parameters of a layer's sum, see `macram.golden.ResidualRule`."""

    def __init__(self, config: ArrayConfig):
        codes = 1 << config.output.bits
        super().__init__({
            "table": data.ArrayLayout(RESIDUAL.bits, codes),
            "bounds": data.ArrayLayout(RESIDUAL.bits, codes - 1),
        })  # fmt: skip


class ResidualAdder(wiring.Component):
    """``sum = min(residual + table[code], 255)``, and the next layer's code: how many ``bounds`` the sum exceeds.

    Works on words of one pixel, ``4 * drain`` channels side by side. Latency is `LATENCY` cycles, throughput one word
    per cycle. While ``enable`` is low the codes pass unchanged with the same latency, ``residual`` is not taken and
    ``sums`` stays empty. A stalled output stalls both inputs; the two outputs may be taken at different times.

    Members:
        enable, tables: In, constant during a run.
        i: In stream, `PixelWord` of codes. residual: In stream, one word of 8-bit codes for each of ``i``.
        o: Out stream, `PixelWord` of the next layer's codes. sums: Out stream, `PixelWord` of 8-bit sums.
        start: In, forget everything on the way.
    """

    LATENCY = 2

    def __init__(self, config: ArrayConfig):
        self._config = config
        codes = PixelWord(config.output_word_channels * config.output.bits)
        sums = PixelWord(config.output_word_channels * RESIDUAL.bits)
        super().__init__({
            "start": In(1),
            "enable": In(1),
            "tables": In(ResidualTables(config)),
            "i": In(stream.Signature(codes)),
            "residual": In(stream.Signature(config.output_word_channels * RESIDUAL.bits)),
            "o": Out(stream.Signature(codes)),
            "sums": Out(stream.Signature(sums)),
        })  # fmt: skip

    def elaborate(self, platform):
        config = self._config
        bits, wide = config.output.bits, RESIDUAL.bits
        m = Module()

        # Two stages of registers. The second is free when neither output still has to be taken.
        summed, ready_1, ready_2, take = Signal(), Signal(), Signal(), Signal()
        codes, sums = Signal.like(self.i.payload), Signal.like(self.sums.payload)
        both = self.i.valid & (self.residual.valid | ~self.enable)
        m.d.comb += [
            ready_2.eq((~self.o.valid | self.o.ready) & (~self.sums.valid | self.sums.ready)),
            ready_1.eq(~summed | ready_2),
            take.eq(both & ready_1),
            self.i.ready.eq(take),
            self.residual.ready.eq(take & self.enable),
        ]
        with m.If(self.o.ready):
            m.d.sync += self.o.valid.eq(0)
        with m.If(self.sums.ready):
            m.d.sync += self.sums.valid.eq(0)
        with m.If(ready_1):
            m.d.sync += summed.eq(take)
        with m.If(ready_2 & summed):
            m.d.sync += [self.o.valid.eq(1), self.sums.valid.eq(self.enable)]
        with m.If(self.start):
            m.d.sync += [summed.eq(0), self.o.valid.eq(0), self.sums.valid.eq(0)]

        table = Array(self.tables.table)
        following = []
        for channel in range(config.output_word_channels):
            code = self.i.payload.data[channel * bits : (channel + 1) * bits]
            at = slice(channel * wide, (channel + 1) * wide)
            total = Signal(wide + 1, name=f"total{channel}")
            m.d.comb += total.eq(self.residual.payload[at] + table[code])
            with m.If(take):
                m.d.sync += sums.data[at].eq(Mux(total[wide], RESIDUAL.hi, total[:wide]))
            exceeded = [sums.data[at] > bound for bound in self.tables.bounds]
            following.append(adder_tree(exceeded)[:bits])
        with m.If(take):
            m.d.sync += [
                codes.eq(self.i.payload),
                sums.pixel_last.eq(self.i.payload.pixel_last), sums.last.eq(self.i.payload.last),
            ]  # fmt: skip
        with m.If(ready_2 & summed):
            m.d.sync += [self.o.payload.eq(codes), self.sums.payload.eq(sums)]
            with m.If(self.enable):
                m.d.sync += self.o.payload.data.eq(Cat(*following))
        return m
