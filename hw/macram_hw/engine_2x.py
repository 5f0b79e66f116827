"""Row engines in pairs: one DSP slice at twice the array's clock computes two rows in turn."""

from amaranth.hdl import DomainRenamer, Module, Mux, Signal
from amaranth.lib import data, wiring
from amaranth.lib.wiring import In, Out

from macram.spec import GROUP, LANES, TAPS, ArrayConfig
from macram_hw.engine import DspEngine, add_with_carry, hdl_shape, lane_shape

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


class PairedEngine(wiring.Component):
    """Up to `PAIRS` DSP slices in domain ``double`` and their lane sums, for twice as many rows.

    The slices are `DspEngine`, so packing and decoding are the same. Their lanes are added up at the double clock
    as well, one adder deep per register, which halves the adders. What crosses to ``sync`` are two sums per lane,
    of the even and of the odd rows. The even one waits one half, so that both cross at the same edge, from
    register to register.

    Latency from ``taps`` (and the word that `Interleaver` got) to ``lanes`` is ``ENGINE_LATENCY["dsp48e2_2x"]``
    cycles of ``sync``, throughput two rows per pair and cycle; it never stalls. In halves of a cycle: 1 operands, 4
    the slice, `LEVELS` adders, 1 wait, 1 crossing.

    Members:
        pixels: In, domain ``double``, 4 activations per pair, as from `Interleaver`. second: In, likewise.
        taps: In, 3 weights per row.
        lanes: Out, for even and odd rows 6 signed numbers, sums over the pairs.
        carries: Out, for even and odd rows 6 bits; ``lanes[member][k] + carries[member][k]`` is exact.
    """

    LEVELS = 3
    PAIRS = 1 << LEVELS
    CARRIES = DspEngine.CARRIES

    def __init__(self, config: ArrayConfig, pairs: int):
        self._config = config
        self._pairs = pairs
        super().__init__({
            "pixels": In(data.ArrayLayout(data.ArrayLayout(hdl_shape(config.input), GROUP), pairs)),
            "second": In(1),
            "taps": In(data.ArrayLayout(data.ArrayLayout(hdl_shape(config.weight), TAPS), 2 * pairs)),
            "lanes": Out(data.ArrayLayout(data.ArrayLayout(lane_shape(config, pairs), LANES), 2)),
            "carries": Out(data.ArrayLayout(data.ArrayLayout(1, LANES), 2)),
        })  # fmt: skip

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
            total, carry = self._sum(m, k, engines)
            waiting = Signal.like(total, name=f"waiting{k}")
            m.d.double += waiting.eq(total)
            m.d.sync += [self.lanes[0][k].eq(waiting), self.lanes[1][k].eq(total)]
            if carry is not None:
                waiting_carry = Signal.like(carry, name=f"waiting_carry{k}")
                m.d.double += waiting_carry.eq(carry)
                m.d.sync += [self.carries[0][k].eq(waiting_carry), self.carries[1][k].eq(carry)]
        return m

    def _sum(self, m: Module, k: int, engines: list) -> tuple:
        """Lane ``k`` over all pairs and the carry that is left over, `LEVELS` registers after the slices."""
        terms = [(engine.lanes[k], 1) for engine in engines]
        carries = [engine.carries[k] for engine in engines] if k in self.CARRIES else []
        for level in reversed(range(self.LEVELS)):
            # Few terms are only passed on at first: the way from a slice is the longest.
            if len(terms) > 1 << level:
                paired = [
                    (add_with_carry(a, b, carries.pop()) if carries else a + b, rows + more)
                    for (a, rows), (b, more) in zip(terms[::2], terms[1::2], strict=False)
                ]
                terms = paired + terms[len(terms) & ~1 :]
            terms = [
                (self._register(m, value, lane_shape(self._config, rows), f"lane{k}_{level}_{index}"), rows)
                for index, (value, rows) in enumerate(terms)
            ]
            carries = [
                self._register(m, bit, 1, f"carry{k}_{level}_{index}") for index, bit in enumerate(carries)
            ]
        return terms[0][0], carries[0] if carries else None

    @staticmethod
    def _register(m: Module, value, shape, name: str) -> Signal:
        register = Signal(shape, name=name, reset_less=True)
        m.d.double += register.eq(value)
        return register
