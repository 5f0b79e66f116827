"""cocotb tests on ``echo.v``; test_runner.py and test_streams.py run them, each expected to pass or to
fail."""

from __future__ import annotations

import os
import random

import cocotb
import numpy as np
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, gather

from macram_sim.streams import AxisSink, AxisSource, pauses


async def start(dut):
    Clock(dut.aclk, 10, unit="ns").start()
    dut.aresetn.value = 0
    dut.fault.value = int(os.environ.get("ECHO_FAULT", "0"))
    dut.s_axis_tvalid.value = 0
    dut.m_axis_echo_tready.value = 0
    await ClockCycles(dut.aclk, 3)
    dut.aresetn.value = 1
    await ClockCycles(dut.aclk, 1)


@cocotb.test()
async def stream(dut):
    await start(dut)
    seed = os.environ.get("COCOTB_RANDOM_SEED", "0")
    gaps, stalls = os.environ.get("ECHO_GAPS", "none"), os.environ.get("ECHO_STALLS", "none")
    source = AxisSource(dut, "s_axis", pauses(gaps, random.Random(f"g{seed}")))
    sink = AxisSink(dut, "m_axis_echo", pauses(stalls, random.Random(f"s{seed}")))
    rng = np.random.default_rng(int(seed))
    for count in (1, 2, 300):
        beats = rng.integers(0, 256, (count, 5), np.uint8)
        received, _ = await gather(sink.receive(count), source.send(beats))
        np.testing.assert_array_equal(received, beats)
    assert sink.moved == source.moved == 303
    if gaps == stalls == "none":
        cycles = cocotb.utils.get_sim_time("ns") / 10
        assert cycles < 303 + 20, "one beat per cycle"


@cocotb.test()
async def memory_and_power_up(dut):
    await start(dut)
    assert int(dut.word.value) == 0x5A
    assert (int(dut.unset.value) == 0) == (os.environ["ECHO_ZERO"] == "1")


@cocotb.test()
async def broken(dut):
    await start(dut)
    raise ValueError("this bench is broken on purpose")


@cocotb.test()
async def dies(dut):
    await start(dut)
    os._exit(3)


@cocotb.test()
async def never_ends(dut):
    await start(dut)
    while True:
        await ClockCycles(dut.aclk, 1000)


@cocotb.test()
async def inner_signals_are_hidden(dut):
    await start(dut)
    inner = getattr(dut, "inner", None)
    assert inner is None or not hasattr(inner, "hidden")
