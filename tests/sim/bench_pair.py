"""cocotb test that lets ``pair_all_operands.sv`` run to its end."""

from __future__ import annotations

import cocotb
from cocotb.triggers import ClockCycles

from macram_sim.clocks import start_clocks


@cocotb.test()
async def every_operand_in_both_halves(dut):
    start_clocks(dut)
    await ClockCycles(dut.aclk, 2**18 + 16)
    assert dut.done.value == 1
    assert int(dut.compared.value) == 2 * 2**21
    assert int(dut.wrong.value) == 0, (
        f"{int(dut.wrong.value)} of 2 * 2**21 operand combinations give a wrong lane"
    )
