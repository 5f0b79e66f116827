"""Row engines in pairs: one DSP slice at twice the array's clock computes two rows in turn."""

from dataclasses import dataclass

from amaranth.hdl import DomainRenamer, Module, Mux, Signal, signed
from amaranth.lib import data, wiring
from amaranth.lib.wiring import In, Out

from macram.spec import GROUP, LANES, TAPS, ArrayConfig, accumulator_range, ceil_div, signed_format_for
from macram_hw.add3 import Operand, add
from macram_hw.engine import DspEngine, hdl_shape, lane_products

__all__ = ["Interleaver", "PairedEngine"]


class Interleaver(wiring.Component):
    """Hands the activations of the paired rows over to the double clock: even rows first, then odd rows.

    One for the whole array, so that the units need no multiplexers for activations and half the broadcast
    wires. Domain ``double`` runs at twice the frequency of ``sync``; rising edges of ``sync`` are rising edges of
    ``double``. Every cycle of ``sync`` thus has two halves. A flip-flop that toggles with ``sync``, seen once
    more by ``double``, tells them apart; nothing is ever reset, so no reset can shift the halves. Whatever the
    flip-flops start with, two cycles after the clocks have started the halves are right.

    Latency is half a cycle, throughput one word per cycle; it never stalls.

    Members:
        word: In, 4 pixels x ``rows`` channels, pixel-major.
        pixels: Out, domain ``double``, one group per pair: row 2 i of pair i in the second half of the cycle
            that ``word`` came in, row 2 i + 1 in the first half of the next.
        second: Out, domain ``double``, 1 in the second half of a cycle.
    """

    def __init__(self, config: ArrayConfig):
        self._config = config
        super().__init__({
            "word": In(config.line_word_bits), "pixels": Out(pixels_2x(config)), "second": Out(1),
        })  # fmt: skip

    def elaborate(self, platform):
        config = self._config
        m = Module()
        toggle, seen = Signal(reset_less=True), Signal(reset_less=True)
        m.d.sync += toggle.eq(~toggle)
        m.d.double += [seen.eq(toggle), self.second.eq(toggle ^ seen)]

        bits = config.input.bits
        rows = [
            [self.word[at * bits : (at + 1) * bits] for at in range(row, GROUP * config.rows, config.rows)]
            for row in range(config.paired_rows)
        ]
        for pair, (even, odd) in enumerate(zip(rows[::2], rows[1::2], strict=True)):
            for pixel in range(GROUP):
                m.d.double += self.pixels[pair][pixel].eq(Mux(self.second, odd[pixel], even[pixel]))
        return m


def pixels_2x(config: ArrayConfig) -> data.ArrayLayout:
    """One group of pixels for each pair of rows."""
    return data.ArrayLayout(data.ArrayLayout(hdl_shape(config.input), GROUP), config.paired_rows // 2)


@dataclass(frozen=True)
class PairMember:
    """The even or the odd rows of a `PairedEngine`, with the members of a `RowEngine` that a unit adds up."""

    lanes: data.View
    carries: data.View
    ranges: list[tuple[int, int]]
    CARRIES: tuple[int, ...]

    def operand(self, lane: int) -> Operand:
        """Lane ``lane`` with the range of its number, without the bit that is still to be added."""
        operand = Operand(self.lanes[lane], *self.ranges[lane])
        return Operand(operand.value[: operand.bits].as_signed(), operand.lo, operand.hi)


class PairedEngine(wiring.Component):
    """Up to `PAIRS` DSP slices in domain ``double`` and their lane sums, for twice as many rows.

    The slices are `DspEngine`, so packing and decoding are the same. Their lanes are added up at the double clock
    as well, one adder of three per register, which halves the adders. What crosses to ``sync`` are two sums per lane,
    of the even and of the odd rows. The even one waits one half, so that both cross at the same edge, from
    register to register.

    Latency from ``taps`` (and the word that `Interleaver` got) to ``lanes`` is ``ENGINE_LATENCY["dsp48e2_2x"]``
    cycles of ``sync``, throughput two rows per pair and cycle; it never stalls. In halves of a cycle: 1 operands, 4
    the slice, 1 its decoding, `LEVELS` adders, 1 wait, 1 crossing.

    Members:
        pixels: In, domain ``double``, 4 activations per pair, as from `Interleaver`. second: In, likewise.
        taps: In, 3 weights per row.
        lanes: Out, for even and odd rows 6 signed numbers, sums over the pairs.
        carries: Out, for even and odd rows 6 bits; ``lanes[member][k] + carries[member][k]`` is exact.

    Attributes:
        members: the even and the odd rows as `PairMember`.
    """

    LEVELS = 2
    PAIRS = 3**LEVELS

    def __init__(self, config: ArrayConfig, pairs: int):
        self._config = config
        self._pairs = pairs
        spare = pairs
        for sizes in self._groups():
            spare = max(0, spare - 2 * sum(size > 1 for size in sizes))
        carries = DspEngine.CARRIES if spare else ()
        self._ranges = []
        for k in range(LANES):
            lo, hi = accumulator_range(config.weight, config.input, pairs * len(lane_products(k)))
            self._ranges.append((lo - (k in carries), hi))
        width = max(signed_format_for(*range_).bits for range_ in self._ranges)
        super().__init__({
            "pixels": In(data.ArrayLayout(data.ArrayLayout(hdl_shape(config.input), GROUP), pairs)),
            "second": In(1),
            "taps": In(data.ArrayLayout(data.ArrayLayout(hdl_shape(config.weight), TAPS), 2 * pairs)),
            "lanes": Out(data.ArrayLayout(data.ArrayLayout(signed(width), LANES), 2)),
            "carries": Out(data.ArrayLayout(data.ArrayLayout(1, LANES), 2)),
        })  # fmt: skip
        self.members = [PairMember(self.lanes[i], self.carries[i], self._ranges, carries) for i in range(2)]

    def _groups(self) -> list[list[int]]:
        """How many operands each adder of each level takes; one that takes one is none."""
        levels, count = [], self._pairs
        for left in reversed(range(self.LEVELS)):
            # Few operands are only passed on at first: the way from a slice is the longest.
            most = 3 if count > 3**left else 1
            levels.append([min(most, count - at) for at in range(0, count, most)])
            count = ceil_div(count, most)
        return levels

    def elaborate(self, platform):
        m = Module()
        # A copy of its own beside the multiplexers; one half later, so inverted.
        second = Signal(reset_less=True)
        m.d.double += second.eq(~self.second)
        engines = []
        for pair in range(self._pairs):
            engine = DspEngine(self._config)
            m.submodules[f"engine{pair}"] = DomainRenamer("double")(engine)
            engines.append(engine)
            taps = Signal(engine.taps.shape(), name=f"taps{pair}", reset_less=True)
            m.d.double += taps.eq(Mux(second, self.taps[2 * pair + 1], self.taps[2 * pair]))
            m.d.comb += [engine.pixels.eq(self.pixels[pair]), engine.taps.eq(taps)]
        for k in range(LANES):
            total, carries = self._sum(m, k, engines)
            waiting = Signal.like(total, name=f"waiting{k}")
            m.d.double += waiting.eq(total)
            m.d.sync += [self.lanes[0][k].eq(waiting), self.lanes[1][k].eq(total)]
            for carry in carries:
                waiting_carry = Signal.like(carry, name=f"waiting_carry{k}")
                m.d.double += waiting_carry.eq(carry)
                m.d.sync += [self.carries[0][k].eq(waiting_carry), self.carries[1][k].eq(carry)]
        return m

    def _sum(self, m: Module, k: int, engines: list) -> tuple:
        """Lane ``k`` over all pairs and the carries left over, one register more than `LEVELS` after the slices."""
        operands = [engine.operand(k) for engine in engines]
        carries = [engine.carries[k] for engine in engines if k in engine.CARRIES]
        operands, carries = self._registers(m, f"lane{k}", operands, carries)
        for level, sizes in enumerate(self._groups()):
            taken, operands = operands, []
            for size in sizes:
                group, taken = taken[:size], taken[size:]
                if size == 1:
                    operands += group
                    continue
                bits, carries = carries[:2], carries[2:]
                name = f"lane{k}_{level}_add{len(operands)}"
                operands.append(add(m, name, group, bits, xilinx=self._config.xilinx))
            operands, carries = self._registers(m, f"lane{k}_{level}", operands, carries)
        return operands[0].value, carries

    @staticmethod
    def _registers(m: Module, name: str, operands: list[Operand], carries: list) -> tuple[list, list]:
        """The same operands and carries, one register later."""
        held = [
            Operand(Signal(signed(term.bits), name=f"{name}_{i}", reset_less=True), term.lo, term.hi)
            for i, term in enumerate(operands)
        ]
        bits = [Signal(name=f"{name}_carry{i}", reset_less=True) for i in range(len(carries))]
        m.d.double += [register.value.eq(term.value) for register, term in zip(held, operands, strict=True)]
        m.d.double += [register.eq(bit) for register, bit in zip(bits, carries, strict=True)]
        return held, bits
