"""cocotb test that waits for the self-test's verdict and counts its runs."""

from __future__ import annotations

import os

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles


@cocotb.test()
async def verdict(dut):
    """Two runs are looked at: the second shows that everything starts over."""
    cycles = int(os.environ["SELFTEST_CYCLES"])
    dut.rst.value = 1
    Clock(dut.clk, 10, unit="ns").start()
    await ClockCycles(dut.clk, 3)
    dut.rst.value = 0
    await ClockCycles(dut.clk, cycles // 2)
    assert (dut.passed.value, dut.failed.value) == (0, 0), "a verdict before the first run can have ended"
    for _ in range(2):
        await ClockCycles(dut.clk, int(os.environ["SELFTEST_PATIENCE"]) * cycles + 400)
        verdict = "pass" if dut.passed.value == 1 else "fail" if dut.failed.value == 1 else "none"
        assert verdict == os.environ["SELFTEST_VERDICT"], verdict
        assert dut.passed.value != dut.failed.value
