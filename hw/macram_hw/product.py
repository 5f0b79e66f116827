"""One product of 3-bit operands in LUTs."""

from amaranth.hdl import Instance, Module, signed
from amaranth.lib import wiring
from amaranth.lib.wiring import In, Out

from macram.spec.fixed import PACKED_BITS

__all__ = ["Product"]


class Product(wiring.Component):
    """``p = a * w``, combinational. On export it is ``macram_product.v``, five LUTs of UltraScale.

    Members:
        a: In, 3 unsigned bits. w: In, 3 signed bits. p: Out.
    """

    def __init__(self):
        super().__init__({
            "a": In(PACKED_BITS), "w": In(signed(PACKED_BITS)), "p": Out(signed(2 * PACKED_BITS)),
        })  # fmt: skip

    def elaborate(self, platform):
        if hasattr(platform, "unit_instance"):
            return Instance("macram_product", i_a=self.a, i_w=self.w, o_p=self.p)
        m = Module()
        m.d.comb += self.p.eq(self.a * self.w)
        return m
