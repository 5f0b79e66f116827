"""Division by a constant: the arithmetic over every value, the hardware over the range of the channel registers."""

import numpy as np
import pytest
from amaranth.hdl import Module, Signal
from amaranth.lib import wiring
from amaranth.lib.wiring import In, Out
from stream_testing import simulate

from macram.spec import ceil_div
from macram_hw.divide import ceil_div_constant, reciprocal

LIMIT = 8192


def test_the_reciprocal_is_exact_over_the_whole_range():
    """All row counts and channel counts that a configuration may have; one factor less fails somewhere."""
    for divisor in range(1, 65):
        values = np.arange(LIMIT + divisor)
        factor, shift = reciprocal(divisor, LIMIT + divisor - 1)
        np.testing.assert_array_equal(values * factor >> shift, values // divisor)
        assert ((values * (factor - 1) >> shift) != values // divisor).any()


class Divider(wiring.Component):
    def __init__(self, divisor, limit):
        self._divisor, self._limit = divisor, limit
        super().__init__({"value": In(32), "quotient": Out(14)})

    def elaborate(self, platform):
        m = Module()
        quotient = Signal(14)
        m.d.sync += quotient.eq(ceil_div_constant(self.value, self._divisor, self._limit))
        m.d.comb += self.quotient.eq(quotient)
        return m


@pytest.mark.parametrize(("divisor", "limit"), [(1, 5), (3, 1024), (5, 63), (6, 1024), (8, 1024), (11, 1021)])
def test_the_hardware_divides_every_value(divisor, limit):
    dut = Divider(divisor, limit)

    async def bench(ctx):
        for value in range(limit + 1):
            ctx.set(dut.value, value)
            await ctx.tick()
            assert ctx.get(dut.quotient) == ceil_div(value, divisor), value

    simulate(dut, bench)
