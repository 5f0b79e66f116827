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
from macram_hw.add3 import Add3, Operand
from macram_hw.dsp48e2 import Dsp48e2
from macram_hw.product import Product

__all__ = [
    "DspEngine",
    "PortableEngine",
    "RowEngine",
    "SoftEngine",
    "adder_tree",
    "hdl_shape",
    "lane_shape",
    "make_engine",
]


def hdl_shape(format: IntFormat) -> Shape:
    """The Amaranth shape of an integer format."""
    return signed(format.bits) if format.signed else unsigned(format.bits)


def lane_shape(config: ArrayConfig) -> Shape:
    """Shape of the widest lane of a row engine: 8 bits at 3 x 3 bits."""
    return hdl_shape(signed_format_for(*accumulator_range(config.weight, config.input, TAPS)))


def adder_tree(values: list):
    """Balanced sum of ``values``."""
    while len(values) > 1:
        pairs = [a + b for a, b in zip(values[::2], values[1::2], strict=False)]
        values = pairs + values[len(values) & ~1 :]
    return values[0]


def lane_products(lane: int) -> list[tuple[int, int]]:
    """The (pixel, tap) pairs whose products lane ``lane`` sums: one, two or three."""
    return [(lane - tap, tap) for tap in range(TAPS) if 0 <= lane - tap < GROUP]


class RowEngine(wiring.Component):
    """Twelve products, six lane sums: ``lane[k] = sum of pixel[i] * tap[j] over i + j = k``.

    With taps stored reversed (``tap[j]`` is kernel column ``2 - j``) lane k of pixel group g is a partial sum
    of output column ``4 g + k - 1``. A lane leaves as a signed number and one bit still to be added to it, which the
    adders of the unit take as a carry.

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

    def operand(self, lane: int) -> Operand:
        """Lane ``lane`` with the range of its number, without the bit that is still to be added."""
        config = self._config
        lo, hi = accumulator_range(config.weight, config.input, len(lane_products(lane)))
        operand = Operand(self.lanes[lane], lo - (lane in self.CARRIES), hi)
        return Operand(operand.value[: operand.bits].as_signed(), operand.lo, operand.hi)


class PortableEngine(RowEngine):
    """Plain multipliers, left to the synthesiser; any formats."""

    def elaborate(self, platform):
        m = Module()
        for k in range(LANES):
            products = [self.pixels[i] * self.taps[j] for i, j in lane_products(k)]
            m.d.sync += self.lanes[k].eq(adder_tree(products))
        return m


class SoftEngine(RowEngine):
    """Twelve products in LUTs, each a table of its six operand bits, and an adder of three operands per lane."""

    def elaborate(self, platform):
        m = Module()
        for k in range(LANES):
            products = []
            for i, j in lane_products(k):
                m.submodules[f"product{i}{j}"] = product = Product()
                m.d.comb += [product.a.eq(self.pixels[i]), product.w.eq(self.taps[j])]
                products.append(product.p)
            if len(products) == 1:
                total = products[0]
            else:
                m.submodules[f"lane{k}"] = adder = Add3(self.operand(k).bits, xilinx=self._config.xilinx)
                m.d.comb += [
                    port.eq(p) for port, p in zip((adder.a, adder.b, adder.c), products, strict=False)
                ]
                total = adder.total
            m.d.sync += self.lanes[k].eq(total)
        return m


class DspEngine(RowEngine):
    """All twelve products in one DSP48E2: the polynomial ``sum a_i x**i * sum w_j x**j`` at ``x = 2**7``.

    Lane k comes out in the 7-bit field F_k of the product, less a borrow B_k that its sign takes from the field
    above: ``lane_k = F_k - 128 B_k + B_(k-1)``. Lanes of one or two products span -56..42; with the borrow from
    below that fits 7 bits, and B_k is the top bit of F_k. Lanes 2 and 3 have three products and span -84..63, 148
    values, more than 7 bits hold. But the lowest bit of lane k + 1 is known apart, as the parity of at most three ANDs,
    and differs from the lowest bit of F_(k+1) exactly if B_k is 1. So ``{B_k, F_k}`` is the lane in two's complement,
    and B_(k-1) the bit to be added to it. Checked over all 2**21 operands (``tests/sim/test_dsp_engine.py``).

    The weights enter as low parts minus signs in the DSP's pre-adder, so packing them costs no LUT.
    """

    SPACING = 7
    CARRIES = tuple(range(1, LANES))
    WIDE = tuple(k for k in range(LANES) if len(lane_products(k)) == TAPS)
    """Lanes whose sign 7 bits do not tell."""

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
        parity = Signal(len(self.WIDE))
        for bit, k in zip(parity, self.WIDE, strict=True):
            m.d.comb += bit.eq(
                Cat(*(self.pixels[i][0] & self.taps[j][0] for i, j in lane_products(k + 1))).xor()
            )
        for stage in range(ENGINE_LATENCY["dsp48e2"]):
            delayed = Signal.like(parity, name=f"parity{stage}", reset_less=True, attrs={"keep": "true"})
            m.d.sync += delayed.eq(parity)
            parity = delayed
        fields = [dsp.p[at * k : at * (k + 1)] for k in range(LANES)]
        borrow = Signal(LANES)
        for k in range(LANES):
            wide = k in self.WIDE
            told = fields[k + 1][0] ^ parity[self.WIDE.index(k)] if wide else fields[k][-1]
            m.d.comb += [
                borrow[k].eq(told),
                self.lanes[k].eq(Cat(fields[k], borrow[k]).as_signed()),
            ]
            if k:
                m.d.comb += self.carries[k].eq(borrow[k - 1])
        return m


def _field(bits, width: int):
    return Cat(bits, Const(0, width - len(bits)))


_KINDS = {"portable": PortableEngine, "dsp48e2": DspEngine, "soft": SoftEngine}


def make_engine(kind: str, config: ArrayConfig) -> RowEngine:
    """A row engine of ``kind``."""
    return _KINDS[kind](config)
