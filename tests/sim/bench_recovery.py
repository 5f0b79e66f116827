"""cocotb tests of how the array refuses and recovers, through the driver; test_array_sim.py runs them."""

from __future__ import annotations

import os
from pathlib import Path

import cocotb
import numpy as np
import pytest
from cocotb.triggers import ClockCycles, select

from macram.driver import BOTTOM, TOP, ArrayDriver, ArrayError, BusError
from macram.pack import read_packed
from macram.spec import BY_NAME, REGISTERS, Control, Error, Status, StreamLayout
from macram.spec.registers import LOAD_REGISTERS
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
        self.output = StreamLayout(spec.c_out, spec.output, array.stream_bits)
        self.beats_out = spec.out_height * spec.out_width * self.output.beats_per_pixel
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
async def busy_array_keeps_its_registers(dut):
    bench = await Bench.start(dut)
    await bench.write("CONTROL", Control.START)
    await ClockCycles(dut.aclk, 60)
    locked = [r.name for r in REGISTERS if r.access == "RW" and r.name not in LOAD_REGISTERS]
    before = {name: await bench.read(name) for name in locked}
    for name in locked:
        with pytest.raises(BusError, match="was answered SLVERR"):
            await bench.write(name, before[name] ^ 1)
    assert before == {name: await bench.read(name) for name in locked}
    for name in LOAD_REGISTERS:
        await bench.write(name, 9)
        assert await bench.read(name) == 9
    await bench.recovers()


@cocotb.test()
async def commands_beside_a_run_are_refused_and_it_goes_on(dut):
    """A second start, a load over the running layer, a load beyond the memory: an error code, the codes right."""
    bench = await Bench.start(dut)
    depth, words = bench.packed.array.weight_depth, bench.packed.weight_words
    requant_words = bench.packed.requant_words
    for base, count, command, code in (
        (0, 1, Control.START, Error.BAD_COMMAND),
        (depth - 1, 1, Control.LOAD_WEIGHTS | Control.LOAD_REQUANT, Error.BAD_COMMAND),
        (0, 1, Control.LOAD_WEIGHTS, Error.BAD_RANGE),
        (words - 1, 1, Control.LOAD_WEIGHTS, Error.BAD_RANGE),
        (requant_words - 1, 1, Control.LOAD_REQUANT, Error.BAD_RANGE),
        (depth - 1, 2, Control.LOAD_WEIGHTS, Error.BAD_RANGE),
        (0xFFFF_FFFF, 1, Control.LOAD_WEIGHTS, Error.BAD_RANGE),
        (depth - 1, 0, Control.LOAD_WEIGHTS, Error.BAD_RANGE),
    ):
        await bench.write("CONTROL", Control.START)
        await bench.transport.begin_stream(bench.beats, bench.beats_out)
        await bench.write("PARAM_BASE", base)
        await bench.write("PARAM_WORDS", count)
        await bench.write("CONTROL", command)
        status = Status(await bench.read("STATUS"))
        assert Status.ERROR in status, (base, count, command)
        assert Status.LOADING not in status
        assert await bench.read("ERROR") == code, (base, count, command)
        (received,) = await bench.transport.end_stream()
        codes = bench.output.unpack(received, bench.packed.spec.out_height, bench.packed.spec.out_width)
        np.testing.assert_array_equal(codes, bench.expected)
        await ClockCycles(dut.aclk, 10)
        assert await bench.read("STATUS") == Status.DONE | Status.ERROR
        await bench.works()


@cocotb.test()
async def a_load_beside_a_run_ends_where_it_was_sent(dut):
    """The other end of the memories is loaded while an image runs; then the layer runs from there."""
    bench = await Bench.start(dut)
    spec = bench.packed.spec
    for place, other in ((BOTTOM, TOP), (TOP, BOTTOM), (BOTTOM, TOP)):
        await bench.driver.configure(spec, place=place)
        result = await bench.driver.run(
            bench.image, meanwhile=lambda other=other: bench.driver.load(bench.packed, place=other)
        )
        np.testing.assert_array_equal(result.codes, bench.expected)
    await bench.driver.configure(spec, place=TOP)
    await bench.works()


@cocotb.test()
async def commands_beside_a_load_are_refused_and_it_goes_on(dut):
    bench = await Bench.start(dut)
    words = bench.packed.weight_words
    weights, _ = bench.packed.load_beats()
    for command, code in (
        (Control.LOAD_WEIGHTS, Error.BAD_COMMAND),
        (Control.LOAD_REQUANT, Error.BAD_COMMAND),
        (Control.START, Error.BAD_RANGE),
    ):
        await bench.write("PARAM_BASE", 0)
        await bench.write("PARAM_WORDS", words)
        await bench.write("CONTROL", Control.LOAD_WEIGHTS)
        for name in LOAD_REGISTERS:
            with pytest.raises(BusError, match="was answered SLVERR"):
                await bench.write(name, 1)
        await bench.write("CONTROL", command)
        await ClockCycles(dut.aclk, 10)
        assert await bench.read("ERROR") == code
        assert await bench.read("STATUS") == Status.LOADING | Status.ERROR
        await bench.transport.send_params(weights)
        await ClockCycles(dut.aclk, 10)
        assert await bench.read("STATUS") == Status.ERROR
        await bench.works()


@cocotb.test()
async def layers_beyond_the_memories_are_refused(dut):
    bench = await Bench.start(dut)
    array, packed = bench.packed.array, bench.packed
    for name, value in (
        ("WEIGHT_BASE", array.weight_depth - packed.weight_words + 1),
        ("REQUANT_BASE", array.requant_depth - packed.requant_words + 1),
        ("WEIGHT_BASE", 0xFFFF_FFFF),
    ):
        await bench.write(name, value)
        await bench.write("CONTROL", Control.START)
        await ClockCycles(dut.aclk, 20)
        assert await bench.read("STATUS") == Status.ERROR
        assert await bench.read("ERROR") == Error.BAD_RANGE
        await bench.driver.configure(packed.spec)
        await bench.works()


@cocotb.test()
async def tlast_faults_are_named(dut):
    bench = await Bench.start(dut)
    begin = bench.transport.begin_stream
    for count, code in (
        (len(bench.beats) - 1, Error.TLAST_EARLY),
        (len(bench.beats) + 2, Error.TLAST_MISSING),
    ):
        frame = np.resize(bench.beats, (count, bench.beats.shape[1]))
        bench.transport.begin_stream = lambda _, beats_out, *__, frame=frame: begin(frame, beats_out)
        with pytest.raises(ArrayError, match=code.name) as caught:
            await bench.driver.run(bench.image)
        assert caught.value.code is code
        bench.transport.begin_stream = begin
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
        ("MODE", 0x0001_0303, Control.START, Error.BAD_MODE),
        ("MODE", 0x0000_0103, Control.START, Error.BAD_MODE),
        ("PARAM_WORDS", words, Control.LOAD_WEIGHTS, Error.BAD_RANGE),
        ("PARAM_WORDS", 0, Control.LOAD_REQUANT, Error.BAD_RANGE),
        ("PARAM_WORDS", 1, Control.LOAD_WEIGHTS | Control.START, Error.BAD_COMMAND),
    ):
        await bench.write(name, value)
        await bench.write("CONTROL", command)
        await ClockCycles(dut.aclk, 100)
        assert await bench.read("STATUS") & (Status.BUSY | Status.ERROR) == Status.ERROR, name
        assert await bench.read("ERROR") == code, (name, value)
        await bench.driver.configure(bench.packed.spec)
        await bench.recovers()
