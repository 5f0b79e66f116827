"""Requantisers: accumulators to output codes, one word of channel parameters per cycle."""

from amaranth.hdl import Module, Mux, Signal, signed
from amaranth.lib import data, wiring
from amaranth.lib.wiring import In, Out

from macram.spec import GROUP, ArrayConfig
from macram.spec.fixed import MULT_BITS, OFFSET_BITS, SHIFT_BITS
from macram_hw.engine import adder_tree, hdl_shape

__all__ = ["Requantiser"]


class Requantiser(wiring.Component):
    """``drain`` channels x 4 pixels per cycle, each channel with its own parameters.

    Up to 4 output bits: code = number of thresholds not above the accumulator, inverted bit by bit where the
    channel's scale is negative; for signed outputs the code's top bit is flipped, which subtracts half
    the range.
    Above: code = clip((accumulator * mult + offset) >> shift), floor.

    Before that, in the first group of a row, the channel's border terms are added: the left one to slot 1, which
    is column 0, the right one to slot 0, the last column of the row before. They stand for padding that no step
    reads, and are 0 unless signed codes run on unsigned inputs.

    Latency is `LATENCY` cycles, throughput one word per cycle; it never stalls.

    Members:
        parameters: In, ``drain`` entries, channel 0 in the low bits. edge: In, first group of a row.
        accumulators: In, ``[channel][slot]``.
        codes: Out, ``[slot][channel]`` as plain bits, slot 0 and channel 0 lowest.
    """

    LATENCY = 3

    def __init__(self, config: ArrayConfig):
        self._config = config
        acc = hdl_shape(config.sum)
        super().__init__({
            "parameters": In(config.requant_word_bits),
            "edge": In(1),
            "accumulators": In(data.ArrayLayout(data.ArrayLayout(acc, GROUP), config.drain)),
            "codes": Out(config.drain * GROUP * config.output.bits),
        })  # fmt: skip

    def elaborate(self, platform):
        config = self._config
        bits = config.output.bits
        m = Module()
        lane = self._threshold_lane if config.thresholds else self._shift_lane
        entry_bits = config.requant_entry_bits
        parameters = Signal.like(self.parameters, reset_less=True)
        m.d.sync += parameters.eq(self.parameters)
        for channel in range(config.drain):
            first, end = channel * entry_bits, (channel + 1) * entry_bits
            left, right = self._borders(self.parameters[first:end])
            for slot in range(GROUP):
                border = {0: right, 1: left}.get(slot, 0)
                whole = Signal(hdl_shape(config.sum), name=f"whole_{channel}_{slot}", reset_less=True)
                m.d.sync += whole.eq(self.accumulators[channel][slot] + Mux(self.edge, border, 0))
                at = (slot * config.drain + channel) * bits
                code = lane(m, parameters[first:end], whole, f"{channel}_{slot}")
                m.d.sync += self.codes[at : at + bits].eq(code)
        return m

    def _borders(self, entry):
        """The border terms, left and right, from the top of an entry."""
        if self._config.border is None:
            return 0, 0
        bits = self._config.border.bits
        return entry[-2 * bits : -bits].as_signed(), entry[-bits:].as_signed()

    def _threshold_lane(self, m, entry, accumulator, suffix):
        config = self._config
        width, count, bits = config.sum.bits, config.thresholds, config.output.bits
        reached = Signal(count, name=f"reached_{suffix}", reset_less=True)
        invert = Signal(name=f"invert_{suffix}", reset_less=True)
        m.d.sync += invert.eq(entry[count * width])
        for i in range(count):
            threshold = entry[i * width : (i + 1) * width].as_signed()
            m.d.sync += reached[i].eq(accumulator >= threshold)
        number = Signal(bits, name=f"number_{suffix}")
        m.d.comb += number.eq(adder_tree(list(reached)))
        code = number ^ invert.replicate(bits)
        return code ^ (1 << (bits - 1)) if config.output.signed else code

    def _shift_lane(self, m, entry, accumulator, suffix):
        output = self._config.output
        mult = entry[:MULT_BITS].as_signed()
        offset = entry[MULT_BITS : MULT_BITS + OFFSET_BITS].as_signed()
        shift = entry[MULT_BITS + OFFSET_BITS :][:SHIFT_BITS]
        total = Signal(signed(OFFSET_BITS + 1), name=f"scaled_{suffix}", reset_less=True)
        amount = Signal(SHIFT_BITS, name=f"shift_{suffix}", reset_less=True)
        m.d.sync += [total.eq(accumulator * mult + offset), amount.eq(shift)]
        scaled = Signal(signed(OFFSET_BITS + 1), name=f"shifted_{suffix}")
        m.d.comb += scaled.eq(total >> amount)
        return Mux(scaled < output.lo, output.lo, Mux(scaled > output.hi, output.hi, scaled[: output.bits]))
