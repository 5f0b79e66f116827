"""cocotb test that lets ``engine_all_operands.v`` run to its end."""

from __future__ import annotations

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles


@cocotb.test()
async def every_operand(dut):
    Clock(dut.clk, 10, unit="ns").start()
    await ClockCycles(dut.clk, 2**18 + 16)
    assert dut.done.value == 1
    assert int(dut.compared.value) == 2**21
    assert int(dut.wrong.value) == 0, (
        f"{int(dut.wrong.value)} of 2**21 operand combinations give a wrong lane"
    )
