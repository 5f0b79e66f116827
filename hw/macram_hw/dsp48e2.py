"""The DSP slice of UltraScale+ as one multiplier with a pre-adder: ``p = a * (d - b)``."""

from amaranth.hdl import Cat, ClockSignal, Const, Instance, Module, Signal, signed
from amaranth.lib import wiring
from amaranth.lib.wiring import In, Out

from macram.spec import ENGINE_LATENCY

__all__ = ["Dsp48e2"]

A_BITS, B_BITS, D_BITS, P_BITS = 27, 18, 27, 48


class Dsp48e2(wiring.Component):
    """``p = a * (d - b)`` with every register of the slice in use; ``d - b`` must fit 18 signed bits.

    Latency is `LATENCY` cycles, throughput one product per cycle. On export it is the vendor's primitive; in
    Amaranth's simulator the same registers and operations in plain logic. For Verilator the export adds a model of
    the primitive (``DSP48E2.v``), which is not for synthesis.

    Members:
        a: In, 27 bits, the multiplicand. d, b: In, the pre-adder's operands. p: Out, 48 bits.
    """

    LATENCY = ENGINE_LATENCY["dsp48e2"]

    def __init__(self):
        super().__init__({
            "a": In(signed(A_BITS)), "b": In(signed(B_BITS)), "d": In(signed(D_BITS)), "p": Out(signed(P_BITS)),
        })  # fmt: skip

    def elaborate(self, platform):
        if hasattr(platform, "unit_instance"):
            return self._primitive()
        m = Module()
        a1, a2 = Signal(signed(A_BITS)), Signal(signed(A_BITS))
        b, d, difference = Signal(signed(B_BITS)), Signal(signed(D_BITS)), Signal(signed(B_BITS))
        product = Signal(signed(A_BITS + B_BITS))
        m.d.sync += [
            a1.eq(self.a), a2.eq(a1), b.eq(self.b), d.eq(self.d), difference.eq(d - b),
            product.eq(a2 * difference), self.p.eq(product),
        ]  # fmt: skip
        return m

    def _primitive(self) -> Instance:
        on, off = Const(1, 1), Const(0, 1)
        clock_enables = (
            "A1",
            "A2",
            "AD",
            "ALUMODE",
            "B1",
            "B2",
            "C",
            "CARRYIN",
            "CTRL",
            "D",
            "INMODE",
            "M",
            "P",
        )
        resets = ("A", "ALLCARRYIN", "ALUMODE", "B", "C", "CTRL", "D", "INMODE", "M", "P")
        return Instance(
            "DSP48E2",
            p_AMULTSEL="A",
            p_BMULTSEL="AD",
            p_PREADDINSEL="B",
            p_A_INPUT="DIRECT",
            p_B_INPUT="DIRECT",
            p_USE_MULT="MULTIPLY",
            p_USE_SIMD="ONE48",
            p_AREG=2,
            p_ACASCREG=2,
            p_BREG=1,
            p_BCASCREG=1,
            p_DREG=1,
            p_ADREG=1,
            p_MREG=1,
            p_PREG=1,
            p_CREG=0,
            p_INMODEREG=0,
            p_OPMODEREG=0,
            p_ALUMODEREG=0,
            p_CARRYINREG=0,
            p_CARRYINSELREG=0,
            i_CLK=ClockSignal(),
            i_A=Cat(self.a, self.a[-1].replicate(3)),
            i_B=self.b,
            i_C=Const(0, 48),
            i_D=self.d,
            i_INMODE=Const(0b01100, 5),
            i_OPMODE=Const(0b000000101, 9),
            i_ALUMODE=Const(0, 4),
            i_CARRYIN=off,
            i_CARRYINSEL=Const(0, 3),
            i_ACIN=Const(0, 30),
            i_BCIN=Const(0, 18),
            i_PCIN=Const(0, 48),
            i_CARRYCASCIN=off,
            i_MULTSIGNIN=off,
            **{f"i_CE{name}": off if name == "C" else on for name in clock_enables},
            **{f"i_RST{name}": off for name in resets},
            o_P=self.p,
        )
