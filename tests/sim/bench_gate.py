"""cocotb test that clocks ``gate_equals_rtl.v``."""

from __future__ import annotations

import os

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles

CYCLES = 20_000


@cocotb.test()
async def netlist_equals_rtl(dut):
    dut.seed.value = int(os.environ["GATE_SEED"])
    Clock(dut.clk, 10, unit="ns").start()
    await ClockCycles(dut.clk, CYCLES)
    assert int(dut.compared.value) >= CYCLES - 2
    assert int(dut.changes.value) > CYCLES // 4, "the outputs hardly move: nothing is compared"
    assert int(dut.wrong.value) == 0, f"{int(dut.wrong.value)} of {CYCLES} cycles differ"
