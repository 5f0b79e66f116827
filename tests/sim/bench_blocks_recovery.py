"""cocotb tests of refusals and recoveries of runs with partial sums; test_partial_sums_sim.py runs them.

The job folder holds ``0``, ``1``, ... (the packed passes), ``input.npy`` and ``expected.npy``.
"""

from __future__ import annotations

import os
from pathlib import Path

import cocotb
import numpy as np
import pytest
from cocotb.triggers import ClockCycles, select

from macram.driver import BOTTOM, TOP, ArrayDriver, ArrayError
from macram.pack import read_packed
from macram.spec import BY_NAME, Control, Error, Status, StreamLayout, SumLayout
from macram_sim import transport as transport_module
from macram_sim.clocks import start_clocks
from macram_sim.transport import CocotbTransport

transport_module.QUIET_CYCLES = 4_000


class Bench:
    """An array, a layer in two blocks, and the sums of the first."""

    @classmethod
    async def start(cls, dut):
        self = cls()
        folder = Path(os.environ["MACRAM_JOB"])
        self.first, self.second = (read_packed(folder / name) for name in "01")
        self.image, self.expected = np.load(folder / "input.npy"), np.load(folder / "expected.npy")
        cut = self.first.spec.c_in
        self.blocks = self.image[:cut], self.image[cut:]
        start_clocks(dut)
        self.dut, self.transport = dut, CocotbTransport(dut)
        await self.transport.reset()
        self.driver = ArrayDriver(self.transport, self.first.array)
        await self.give()
        self.beats = [
            StreamLayout(len(block), self.first.spec.input, self.first.array.stream_bits).pack(block)
            for block in self.blocks
        ]
        await self.driver.load(self.second, place=TOP)
        return self

    async def write(self, name, value):
        await self.transport.write(BY_NAME[name].offset, int(value))

    async def read(self, name):
        return await self.transport.read(BY_NAME[name].offset)

    async def give(self):
        """The first block's run."""
        await self.driver.load(self.first)
        await self.driver.configure(self.first.spec, sums_out=True)
        self.sums = (await self.driver.run(self.blocks[0])).codes

    async def works(self):
        """The second block's run, whose words are at the top."""
        await self.driver.configure(self.second.spec, place=TOP, sums_in=True)
        result = await self.driver.run(self.blocks[1], sums=self.sums)
        np.testing.assert_array_equal(result.codes, self.expected)


@cocotb.test()
async def a_load_beside_a_run_that_takes_sums_is_refused(dut):
    bench = await Bench.start(dut)
    await bench.driver.configure(bench.second.spec, place=TOP, sums_in=True)
    seen = []

    async def load():
        await bench.write("PARAM_BASE", 0)
        await bench.write("PARAM_WORDS", 1)
        for command in (Control.LOAD_WEIGHTS, Control.LOAD_REQUANT):
            await bench.write("CONTROL", command)
            seen.append((Status(await bench.read("STATUS")), await bench.read("ERROR")))

    with pytest.raises(ArrayError, match="BAD_COMMAND"):
        await bench.driver.run(bench.blocks[1], sums=bench.sums, meanwhile=load)
    assert seen == [(Status.BUSY | Status.ERROR, Error.BAD_COMMAND)] * 2
    await ClockCycles(dut.aclk, 10)
    assert await bench.read("STATUS") == Status.DONE | Status.ERROR
    await bench.works()
    await bench.give()


@cocotb.test()
async def a_run_that_takes_sums_does_not_start_beside_a_load(dut):
    bench = await Bench.start(dut)
    await bench.driver.configure(bench.second.spec, place=TOP, sums_in=True)
    weights, _ = bench.first.load_beats()
    await bench.write("PARAM_BASE", 0)
    await bench.write("PARAM_WORDS", bench.first.weight_words)
    await bench.write("CONTROL", Control.LOAD_WEIGHTS)
    await bench.write("CONTROL", Control.START)
    await ClockCycles(dut.aclk, 10)
    assert await bench.read("ERROR") == Error.BAD_RANGE
    assert await bench.read("STATUS") == Status.LOADING | Status.ERROR
    await bench.transport.send_params(weights)
    await ClockCycles(dut.aclk, 10)
    assert await bench.read("STATUS") == Status.ERROR
    await bench.works()


@cocotb.test()
async def a_run_that_gives_sums_lets_a_load_pass(dut):
    bench = await Bench.start(dut)
    await bench.driver.configure(bench.first.spec, place=BOTTOM, sums_out=True)
    result = await bench.driver.run(
        bench.blocks[0], meanwhile=lambda: bench.driver.load(bench.second, place=TOP)
    )
    np.testing.assert_array_equal(result.codes, bench.sums)
    await bench.works()


@cocotb.test()
async def tlast_faults_of_the_sums_are_named(dut):
    bench = await Bench.start(dut)
    layout = SumLayout(bench.second.spec, bench.second.array)
    whole = layout.pack(bench.sums)
    begin = bench.transport.begin_stream
    for count, code in ((len(whole) - 1, Error.TLAST_EARLY), (len(whole) + 1, Error.TLAST_MISSING)):
        sums = np.resize(whole, (count, whole.shape[1]))
        bench.transport.begin_stream = lambda *given, sums=sums: begin(*given[:3], sums)
        await bench.driver.configure(bench.second.spec, place=TOP, sums_in=True)
        with pytest.raises(ArrayError, match=code.name) as caught:
            await bench.driver.run(bench.blocks[1], sums=bench.sums)
        assert caught.value.code is code
        bench.transport.begin_stream = begin
        await bench.driver.soft_reset()
        await bench.works()


@cocotb.test()
async def soft_reset_in_the_middle(dut):
    """Of both kinds of runs; nothing of the sums is left behind, not for runs without them either."""
    bench = await Bench.start(dut)
    sums = SumLayout(bench.second.spec, bench.second.array).pack(bench.sums)
    for cycles in range(3, 240, 23):
        for block, packed in enumerate((bench.first, bench.second)):
            place = (BOTTOM, TOP)[block]
            await bench.driver.configure(
                packed.spec, place=place, sums_in=packed.sums_in, sums_out=packed.sums_out
            )
            await bench.write("CONTROL", Control.START)
            given = bench.transport.run_stream(bench.beats[block], 100_000, None, sums if block else None)
            await select(given, ClockCycles(dut.aclk, cycles))
            bench.transport.quiet()
            assert await bench.read("STATUS") & Status.BUSY
            await bench.driver.soft_reset()
            await bench.driver.configure(bench.first.spec, sums_out=True)
            again = await bench.driver.run(bench.blocks[0])
            np.testing.assert_array_equal(again.codes, bench.sums)
            await bench.works()


@cocotb.test()
async def sums_with_a_residual_sum_behind_them_are_a_bad_mode(dut):
    bench = await Bench.start(dut)
    await bench.driver.configure(bench.first.spec, sums_out=True)
    for bit, code in ((25, Error.BAD_MODE), (28, Error.BAD_MODE)):
        mode = await bench.read("MODE")
        await bench.write("MODE", mode | 1 << bit)
        await bench.write("CONTROL", Control.START)
        await ClockCycles(dut.aclk, 20)
        assert await bench.read("ERROR") == code
        await bench.write("MODE", mode)
    await bench.works()
