"""Requantisers: accumulators to output codes, one word of channel parameters per cycle."""

from amaranth.hdl import Module, Mux, Signal, signed
from amaranth.lib import data, wiring
from amaranth.lib.wiring import In, Out

from macram.spec import GROUP, ArrayConfig
from macram.spec.array import MULT_BITS, OFFSET_BITS, SHIFT_BITS
from macram_hw.engine import adder_tree, hdl_shape

__all__ = ["Requantiser"]


class Requantiser(wiring.Component):
    """``drain`` channels x 4 pixels per cycle, each channel with its own parameters.

    Up to 4 output bits: code = number of thresholds not above the accumulator, inverted bit by bit where the
    channel's scale is negative; for signed outputs the code's top bit is flipped, which subtracts half
    the range.
    Above: code = clip((accumulator * mult + offset) >> shift), floor.

    Latency is `LATENCY` cycles, throughput one word per cycle; it never stalls.

    Members:
        parameters: In, ``drain`` entries, channel 0 in the low bits.
        accumulators: In, ``[channel][slot]``.
        codes: Out, ``[slot][channel]`` as plain bits, slot 0 and channel 0 lowest.
    """

    LATENCY = 2

    def __init__(self, config: ArrayConfig):
        self._config = config
        acc = hdl_shape(config.accumulator)
        super().__init__({
            "parameters": In(config.requant_word_bits),
            "accumulators": In(data.ArrayLayout(data.ArrayLayout(acc, GROUP), config.drain)),
            "codes": Out(config.drain * GROUP * config.output.bits),
        })  # fmt: skip

    def elaborate(self, platform):
        config = self._config
        bits = config.output.bits
        m = Module()
        lane = self._threshold_lane if config.thresholds else self._shift_lane
        entry_bits = config.requant_entry_bits
        for channel in range(config.drain):
            entry = self.parameters[channel * entry_bits : (channel + 1) * entry_bits]
            for slot in range(GROUP):
                at = (slot * config.drain + channel) * bits
                code = lane(m, entry, self.accumulators[channel][slot], f"{channel}_{slot}")
                m.d.sync += self.codes[at : at + bits].eq(code)
        return m

    def _threshold_lane(self, m, entry, accumulator, suffix):
        config = self._config
        width, count, bits = config.accumulator.bits, config.thresholds, config.output.bits
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
        shift = entry[MULT_BITS + OFFSET_BITS :]
        total = Signal(signed(OFFSET_BITS + 1), name=f"scaled_{suffix}", reset_less=True)
        amount = Signal(SHIFT_BITS, name=f"shift_{suffix}", reset_less=True)
        m.d.sync += [total.eq(accumulator * mult + offset), amount.eq(shift)]
        scaled = Signal(signed(OFFSET_BITS + 1), name=f"shifted_{suffix}")
        m.d.comb += scaled.eq(total >> amount)
        return Mux(scaled < output.lo, output.lo, Mux(scaled > output.hi, output.hi, scaled[: output.bits]))
