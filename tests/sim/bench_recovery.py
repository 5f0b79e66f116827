"""cocotb tests of how the array refuses and recovers, through the driver; test_array_sim.py runs them."""

from __future__ import annotations

import os
from pathlib import Path

import cocotb
import numpy as np
import pytest
from cocotb.triggers import ClockCycles, select

from macram.driver import ArrayDriver, ArrayError, BusError
from macram.pack import read_packed
from macram.spec import BY_NAME, REGISTERS, Control, Error, Status, StreamLayout
from macram_sim import transport as transport_module
from macram_sim.clocks import start_clocks
from macram_sim.transport import CocotbTransport

transport_module.QUIET_CYCLES = 4_000


class Bench:
    """A loaded and configured array, its image and the codes it must give."""

    @classmethod
    async def start(cls, dut):
        self = cls()
        folder = Path(os.environ["MACRAM_JOB"])
        self.packed = read_packed(folder / "packed")
        self.image, self.expected = np.load(folder / "input.npy"), np.load(folder / "expected.npy")
        start_clocks(dut)
        self.dut, self.transport = dut, CocotbTransport(dut)
        await self.transport.reset()
        self.driver = ArrayDriver(self.transport, self.packed.array)
        await self.driver.load(self.packed)
        await self.driver.configure(self.packed.spec)
        spec, array = self.packed.spec, self.packed.array
        self.beats = StreamLayout(spec.c_in, spec.input, array.stream_bits).pack(self.image)
        return self

    async def write(self, name, value):
        await self.transport.write(BY_NAME[name].offset, int(value))

    async def read(self, name):
        return await self.transport.read(BY_NAME[name].offset)

    async def works(self):
        result = await self.driver.run(self.image)
        np.testing.assert_array_equal(result.codes, self.expected)

    async def recovers(self):
        await self.driver.soft_reset()
        assert await self.read("ERROR") == Error.NONE
        await self.works()


@cocotb.test()
async def soft_reset_in_the_middle(dut):
    bench = await Bench.start(dut)
    for cycles in range(3, 240, 9):
        await bench.write("CONTROL", Control.START)
        await select(bench.transport.run_stream(bench.beats, 10_000), ClockCycles(dut.aclk, cycles))
        bench.transport.quiet()
        assert await bench.read("STATUS") & Status.BUSY
        await bench.recovers()


@cocotb.test()
async def busy_array_refuses_writes(dut):
    bench = await Bench.start(dut)
    await bench.write("CONTROL", Control.START)
    await ClockCycles(dut.aclk, 60)
    before = {r.name: await bench.read(r.name) for r in REGISTERS if r.access == "RW"}
    for name, value in (("HEIGHT", 1), ("MODE", 0), ("PARAM_WORDS", 9), ("CONTROL", 1), ("CONTROL", 2)):
        with pytest.raises(BusError, match="was answered SLVERR"):
            await bench.write(name, value)
    assert before == {name: await bench.read(name) for name in before}
    await bench.recovers()


@cocotb.test()
async def tlast_faults_are_named(dut):
    bench = await Bench.start(dut)
    send = bench.transport.run_stream
    for count, code in (
        (len(bench.beats) - 1, Error.TLAST_EARLY),
        (len(bench.beats) + 2, Error.TLAST_MISSING),
    ):
        frame = np.resize(bench.beats, (count, bench.beats.shape[1]))
        bench.transport.run_stream = lambda _, beats_out, residual, frame=frame: send(frame, beats_out)
        with pytest.raises(ArrayError, match=code.name) as caught:
            await bench.driver.run(bench.image)
        assert caught.value.code is code
        bench.transport.run_stream = send
        await bench.recovers()


@cocotb.test()
async def loading_faults_are_named(dut):
    bench = await Bench.start(dut)
    for words, code in ((1, Error.TLAST_MISSING), (bench.packed.weight_words + 1, Error.TLAST_EARLY)):
        await bench.write("PARAM_WORDS", words)
        await bench.write("CONTROL", Control.LOAD_WEIGHTS)
        weights, _ = bench.packed.load_beats()
        try:
            await bench.transport.send_params(weights)
        except ArrayError:
            bench.transport.quiet()
        assert await bench.read("ERROR") == code
        await bench.driver.soft_reset()
        await bench.driver.load(bench.packed)
        await bench.works()


@cocotb.test()
async def bad_commands_and_shapes_are_named(dut):
    bench = await Bench.start(dut)
    words = bench.packed.array.weight_depth + 1
    for name, value, command, code in (
        ("WIDTH", 0, Control.START, Error.BAD_SHAPE),
        ("C_IN", bench.packed.array.max_c_in + 1, Control.START, Error.BAD_SHAPE),
        ("MODE", 0x0001_0203, Control.START, Error.BAD_MODE),
        ("PARAM_WORDS", words, Control.LOAD_WEIGHTS, Error.BAD_COMMAND),
        ("PARAM_WORDS", 1, Control.LOAD_WEIGHTS | Control.START, Error.BAD_COMMAND),
    ):
        await bench.write(name, value)
        await bench.write("CONTROL", command)
        await ClockCycles(dut.aclk, 100)
        assert await bench.read("STATUS") & (Status.BUSY | Status.ERROR) == Status.ERROR, name
        assert await bench.read("ERROR") == code, (name, value)
        await bench.driver.configure(bench.packed.spec)
        await bench.recovers()
