"""Row engines: 4 neighbouring pixels of one channel times the 3 taps of one kernel row, in several kinds."""

from amaranth.hdl import Cat, Const, Module, Shape, Signal, signed, unsigned
from amaranth.lib import data, wiring
from amaranth.lib.wiring import In, Out

from macram.spec import (
    ENGINE_LATENCY,
    GROUP,
    LANES,
    TAPS,
    ArrayConfig,
    IntFormat,
    accumulator_range,
    signed_format_for,
)
from macram_hw.dsp48e2 import Dsp48e2

__all__ = [
    "DspEngine",
    "PortableEngine",
    "RowEngine",
    "add_with_carry",
    "adder_tree",
    "hdl_shape",
    "lane_shape",
    "make_engine",
]


def hdl_shape(format: IntFormat) -> Shape:
    """The Amaranth shape of an integer format."""
    return signed(format.bits) if format.signed else unsigned(format.bits)


def lane_shape(config: ArrayConfig, engines: int = 1) -> Shape:
    """Shape of one lane summed over ``engines`` row engines: exact, 8 bits for one at 3 x 3 bits."""
    return hdl_shape(signed_format_for(*accumulator_range(config.weight, config.input, TAPS * engines)))


def add_with_carry(a, b, carry):
    """``a + b + carry`` of two signed values and a bit.

    Written as one adder with one more bit below the operands: synthesisers build that as a single carry chain,
    and two for a sum of three operands.
    """
    return (Cat(Const(1, 1), a).as_signed() + Cat(carry, b).as_signed())[1:].as_signed()


def adder_tree(values: list, carries: list | None = None):
    """Balanced sum of ``values`` with the bits ``carries`` as carry-ins; uses up as many of them as it can."""
    while len(values) > 1:
        pairs = [
            add_with_carry(a, b, carries.pop()) if carries else a + b
            for a, b in zip(values[::2], values[1::2], strict=False)
        ]
        values = pairs + values[len(values) & ~1 :]
    return values[0]


class RowEngine(wiring.Component):
    """Twelve products, six lane sums: ``lane[k] = sum of pixel[i] * tap[j] over i + j = k``.

    With taps stored reversed (``tap[j]`` is kernel column ``2 - j``) lane k of pixel group g is a partial sum
    of output column ``4 g + k - 1``. A lane leaves as a signed number and one bit still to be added to it, which the
    adder tree takes as a carry-in.

    Latency is ``ENGINE_LATENCY[kind]`` cycles (`macram.spec`), throughput one group per cycle; it never stalls.

    Members:
        pixels: In, 4 activations of one channel.
        taps: In, 3 weights.
        lanes: Out, 6 signed numbers.
        carries: Out, 6 bits; ``lanes[k] + carries[k]`` is exact.
    """

    CARRIES: tuple[int, ...] = ()
    """Lanes whose carry can be 1."""

    def __init__(self, config: ArrayConfig):
        self._config = config
        super().__init__({
            "pixels": In(data.ArrayLayout(hdl_shape(config.input), GROUP)),
            "taps": In(data.ArrayLayout(hdl_shape(config.weight), TAPS)),
            "lanes": Out(data.ArrayLayout(lane_shape(config), LANES)),
            "carries": Out(data.ArrayLayout(1, LANES)),
        })  # fmt: skip


class PortableEngine(RowEngine):
    """Plain multipliers, left to the synthesiser; any formats."""

    def elaborate(self, platform):
        m = Module()
        for k in range(LANES):
            products = [self.pixels[k - j] * self.taps[j] for j in range(TAPS) if 0 <= k - j < GROUP]
            m.d.sync += self.lanes[k].eq(adder_tree(products))
        return m


class DspEngine(RowEngine):
    """All twelve products in one DSP48E2: the polynomial ``sum a_i x**i * sum w_j x**j`` at ``x = 2**7``.

    Lane k comes out in the 7-bit field F_k of the product, less a borrow B_k that its sign takes from the field
    above: ``lane_k = F_k - 128 B_k + B_(k-1)``. With three bits a side a lane spans -84..63, 148 values, more than 7
    bits hold, so B_k is not simply the top bit of F_k. But the lowest bit of lane k + 1 is known apart, as the parity
    of at most three ANDs, and differs from the lowest bit of F_(k+1) exactly if B_k is 1. So ``{B_k, F_k}`` is the
    lane in two's complement, and B_(k-1) the bit to be added to it. Checked over all 2**21 operands
    (``tests/sim/test_dsp_engine.py``).

    The weights enter as low parts minus signs in the DSP's pre-adder, so packing them costs no LUT.
    """

    SPACING = 7
    CARRIES = tuple(range(1, LANES))

    def elaborate(self, platform):
        m = Module()
        m.submodules.dsp = dsp = Dsp48e2()
        low_bits = self._config.weight.bits - 1
        at = self.SPACING
        m.d.comb += [
            dsp.a.eq(Cat(*(_field(pixel, at) for pixel in self.pixels))),
            dsp.d.eq(Cat(*(_field(tap[:low_bits], at) for tap in self.taps))),
            dsp.b.eq(Cat(*(_field(Cat(Const(0, low_bits), tap[-1]), at) for tap in self.taps))),
        ]
        # Kept in flip-flops: as shift registers these chains would cost LUTs.
        parity = Signal(LANES - 1)
        m.d.comb += [
            parity[k - 1].eq(
                Cat(
                    *(self.pixels[k - j][0] & self.taps[j][0] for j in range(TAPS) if 0 <= k - j < GROUP)
                ).xor()
            )
            for k in range(1, LANES)
        ]
        for stage in range(ENGINE_LATENCY["dsp48e2"]):
            delayed = Signal.like(parity, name=f"parity{stage}", reset_less=True, attrs={"keep": "true"})
            m.d.sync += delayed.eq(parity)
            parity = delayed
        borrow = Signal(LANES)
        m.d.comb += borrow.eq(
            Cat(*(dsp.p[at * k] ^ parity[k - 1] for k in range(1, LANES)), dsp.p[at * LANES])
        )
        for k in range(LANES):
            m.d.comb += self.lanes[k].eq(Cat(dsp.p[at * k : at * (k + 1)], borrow[k]).as_signed())
            if k:
                m.d.comb += self.carries[k].eq(borrow[k - 1])
        return m


def _field(bits, width: int):
    return Cat(bits, Const(0, width - len(bits)))


_KINDS = {"portable": PortableEngine, "dsp48e2": DspEngine}


def make_engine(kind: str, config: ArrayConfig) -> RowEngine:
    """A row engine of ``kind``."""
    return _KINDS[kind](config)
