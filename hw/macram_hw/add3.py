"""Sums of many operands from adders of three operands and two carries, each one row of LUTs on UltraScale."""

from dataclasses import dataclass

from amaranth.hdl import Instance, Module, Value, signed
from amaranth.lib import wiring
from amaranth.lib.wiring import In, Out

from macram.spec import signed_format_for

__all__ = ["Add3", "Operand", "add", "sum_to_two"]


class Add3(wiring.Component):
    """``total = (a | d) + b + c + x + ci`` modulo ``2**width``, combinational.

    On export it is ``macram_add3.v``, in Amaranth's simulator the plain sum.

    Members:
        a, d, b, c: In, ``width`` signed bits. x, ci: In, carries. total: Out.
    """

    def __init__(self, width: int, *, xilinx: bool):
        self._width, self._xilinx = width, xilinx
        super().__init__({
            **{name: In(signed(width)) for name in ("a", "d", "b", "c")},
            "x": In(1), "ci": In(1), "total": Out(signed(width)),
        })  # fmt: skip

    def elaborate(self, platform):
        if hasattr(platform, "unit_instance"):
            return Instance(
                "macram_add3",
                p_WIDTH=self._width,
                p_XILINX=int(self._xilinx),
                i_a=self.a,
                i_d=self.d,
                i_b=self.b,
                i_c=self.c,
                i_x=self.x,
                i_ci=self.ci,
                o_sum=self.total,
            )
        m = Module()
        m.d.comb += self.total.eq((self.a | self.d) + self.b + self.c + self.x + self.ci)
        return m


@dataclass(frozen=True)
class Operand:
    """A signed value that lies in ``lo..hi``."""

    value: Value
    lo: int
    hi: int

    @property
    def bits(self) -> int:
        """Bits that hold the range."""
        return signed_format_for(self.lo, self.hi).bits


def add(m: Module, name: str, operands: list[Operand], carries: list, *, xilinx: bool) -> Operand:
    """The sum of two or three operands and at most two carries by one adder, submodule ``name`` of ``m``."""
    lo = sum(operand.lo for operand in operands)
    hi = sum(operand.hi for operand in operands) + len(carries)
    adder = Add3(signed_format_for(lo, hi).bits, xilinx=xilinx)
    m.submodules[name] = adder
    m.d.comb += [
        port.eq(operand.value) for port, operand in zip((adder.a, adder.b, adder.c), operands, strict=False)
    ]
    m.d.comb += [port.eq(bit) for port, bit in zip((adder.x, adder.ci), carries, strict=False)]
    return Operand(adder.total, lo, hi)


def sum_to_two(
    m: Module, name: str, operands: list[Operand], carries: list, *, xilinx: bool
) -> tuple[list[Operand], list]:
    """Add ``operands`` and the bits ``carries`` until at most two operands and two carries are left to be added.

    The narrowest operands are added first. N operands take ``(N - 1) // 2`` adders; every adder takes two
    carries, so N operands may bring N of them.

    Args:
        m: gets the adders as submodules ``{name}_add0``, ...
        name: of what is summed.
        operands: signed values with their ranges.
        carries: at most as many bits as operands.
        xilinx: build from primitives of UltraScale.

    Returns:
        The operands and carries that are left.
    """
    operands, carries = list(operands), list(carries)
    while len(operands) > 2:
        operands.sort(key=lambda operand: operand.hi - operand.lo)
        # An odd one is best got rid of while the operands are narrow.
        count = 2 if len(operands) % 2 else 3
        taken, operands = operands[:count], operands[count:]
        bits, carries = carries[:2], carries[2:]
        operands.append(add(m, f"{name}_add{len(operands)}", taken, bits, xilinx=xilinx))
    return operands, carries
