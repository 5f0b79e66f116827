"""AXI4-Lite registers in Amaranth's simulator: every register, every refusal, ordering, strobes, latency."""

from __future__ import annotations

import os
import random

import pytest
from amaranth.sim import Simulator

from macram.spec.registers import BY_NAME, LOAD_REGISTERS, MODE_3X3, REGISTERS
from macram_hw.axi_lite import OKAY, SLVERR, AxiLite, AxiLiteRegisters

SEED = int(os.environ.get("SEED", "2207"))
STORED = [r for r in REGISTERS if r.access == "RW"]
INPUTS = [r for r in REGISTERS if r.access == "RO" and r.name not in ("ID", "VERSION")]


class Bus:
    """A manager that can delay each channel; it notes commands and the cycles things took."""

    def __init__(self, ctx, dut):
        self.ctx, self.dut, self.axi = ctx, dut, dut.axi

    async def _send(self, channel, delay, **payload):
        for _ in range(delay):
            await self.ctx.tick()
        for name, value in payload.items():
            self.ctx.set(getattr(self.axi, name), value)
        self.ctx.set(getattr(self.axi, f"{channel}valid"), 1)
        await self.ctx.tick().until(getattr(self.axi, f"{channel}ready"))
        self.ctx.set(getattr(self.axi, f"{channel}valid"), 0)

    async def write(self, offset, value, strobe=0xF, order="both", b_delay=0):
        """Returns (response, command seen with the answer)."""
        ctx, axi = self.ctx, self.axi
        if order == "both":
            ctx.set(axi.awaddr, offset)
            ctx.set(axi.wdata, value)
            ctx.set(axi.wstrb, strobe)
            ctx.set(axi.awvalid, 1)
            ctx.set(axi.wvalid, 1)
            await ctx.tick()
            ctx.set(axi.awvalid, 0)
            ctx.set(axi.wvalid, 0)
        elif order == "address first":
            await self._send("aw", 0, awaddr=offset)
            await self._send("w", 3, wdata=value, wstrb=strobe)
        else:
            await self._send("w", 0, wdata=value, wstrb=strobe)
            await self._send("aw", 3, awaddr=offset)
        while not ctx.get(axi.bvalid):
            await ctx.tick()
        command = ctx.get(self.dut.command)
        for _ in range(b_delay):
            await ctx.tick()
            assert ctx.get(axi.bvalid)
            assert not ctx.get(self.dut.command), "a command lasts one cycle"
            assert (ctx.get(axi.awready), ctx.get(axi.wready)) == (0, 0), "one write at a time"
        response = ctx.get(axi.bresp)
        ctx.set(axi.bready, 1)
        await ctx.tick()
        ctx.set(axi.bready, 0)
        assert not ctx.get(axi.bvalid)
        assert not ctx.get(self.dut.command)
        return response, command

    async def read(self, offset, r_delay=0):
        ctx, axi = self.ctx, self.axi
        await self._send("ar", 0, araddr=offset)
        while not ctx.get(axi.rvalid):
            await ctx.tick()
        seen = ctx.get(axi.rdata), ctx.get(axi.rresp)
        for _ in range(r_delay):
            await ctx.tick()
            assert ctx.get(axi.rvalid)
            assert (ctx.get(axi.rdata), ctx.get(axi.rresp)) == seen, "the answer holds still"
            assert not ctx.get(axi.arready), "one read at a time"
        ctx.set(axi.rready, 1)
        await ctx.tick()
        ctx.set(axi.rready, 0)
        return seen


def simulate(*benches):
    dut = AxiLiteRegisters()
    simulator = Simulator(dut)
    simulator.add_clock(1e-8)
    for bench in benches:

        async def testbench(ctx, bench=bench):
            await bench(ctx, dut, Bus(ctx, dut))

        simulator.add_testbench(testbench)
    simulator.run()


def test_reads_of_every_address():
    async def bench(ctx, dut, bus):
        for index, register in enumerate(INPUTS):
            ctx.set(getattr(dut, register.name.lower()), 0x8000_0001 + (index << 8))
        by_offset = {r.offset: r for r in REGISTERS}
        for offset in range(0, 128, 4):
            data, response = await bus.read(offset, r_delay=offset % 3)
            register = by_offset.get(offset)
            assert response == (OKAY if register else SLVERR), hex(offset)
            if register in INPUTS:
                assert data == 0x8000_0001 + (INPUTS.index(register) << 8), register.name
            else:
                assert data == (register.reset if register else 0), hex(offset)

    simulate(bench)


@pytest.mark.parametrize("order", ["both", "address first", "data first"])
def test_stored_registers(order):
    async def bench(ctx, dut, bus):
        assert ctx.get(dut.mode) == MODE_3X3
        expected = {r.name: r.reset for r in STORED}
        for index, register in enumerate(STORED):
            value = 0xA5C3_0F00 + index
            assert await bus.write(register.offset, value, order=order, b_delay=index % 3) == (OKAY, 0)
            expected[register.name] = value
            for other in STORED:
                assert ctx.get(getattr(dut, other.name.lower())) == expected[other.name], other.name
        for register in STORED:
            assert await bus.read(register.offset) == (expected[register.name], OKAY)

    simulate(bench)


def test_byte_strobes():
    async def bench(ctx, dut, bus):
        for register in STORED:
            value = 0
            await bus.write(register.offset, 0)
            for strobe in range(16):
                data = 0x1122_3344 * (strobe + 1) & 0xFFFF_FFFF
                lanes = sum(0xFF << 8 * b for b in range(4) if strobe >> b & 1)
                value = value & ~lanes | data & lanes
                assert await bus.write(register.offset, data, strobe=strobe) == (OKAY, 0)
                assert ctx.get(getattr(dut, register.name.lower())) == value, (register.name, strobe)

    simulate(bench)


def test_commands_are_one_cycle_strobes_and_touch_no_register():
    async def bench(ctx, dut, bus):
        control = BY_NAME["CONTROL"].offset
        await bus.write(BY_NAME["HEIGHT"].offset, 77)
        for value in (*range(16), 0xFFFF_FFF0):
            assert await bus.write(control, value, b_delay=2) == (OKAY, value & 15)
        assert await bus.write(control, 0xF, strobe=0b1110) == (OKAY, 0)
        assert ctx.get(dut.height) == 77
        assert await bus.read(control) == (0, OKAY)

    simulate(bench)


def test_refused_writes_change_nothing():
    async def bench(ctx, dut, bus):
        stored = {r.offset for r in STORED} | {BY_NAME["CONTROL"].offset}
        before = [ctx.get(getattr(dut, r.name.lower())) for r in STORED]
        for offset in range(0, 128, 4):
            if offset not in stored:
                assert await bus.write(offset, 0xFFFF_FFFF) == (SLVERR, 0), hex(offset)
        for lock, locked in (
            ("busy", {r.name for r in STORED} - LOAD_REGISTERS),
            ("loading", LOAD_REGISTERS),
        ):
            ctx.set(getattr(dut, lock), 1)
            for register in STORED:
                response = SLVERR if register.name in locked else OKAY
                value = await bus.read(register.offset)
                written = 0x1234_5678 if response == SLVERR else value[0]
                assert await bus.write(register.offset, written) == (response, 0), register.name
            assert before == [ctx.get(getattr(dut, r.name.lower())) for r in STORED]
            assert await bus.write(BY_NAME["CONTROL"].offset, 3) == (OKAY, 3), "commands are for the array"
            ctx.set(getattr(dut, lock), 0)
        assert await bus.write(BY_NAME["WIDTH"].offset, 9) == (OKAY, 0)
        assert ctx.get(dut.width) == 9

    simulate(bench)


def test_latency():
    async def bench(ctx, dut, bus):
        axi = dut.axi
        ctx.set(axi.bready, 1)
        ctx.set(axi.rready, 1)
        ctx.set(axi.awaddr, BY_NAME["CONTROL"].offset)
        ctx.set(axi.wdata, 1)
        ctx.set(axi.wstrb, 1)
        ctx.set(axi.araddr, BY_NAME["STATUS"].offset)
        for signal in (axi.awvalid, axi.wvalid, axi.arvalid):
            ctx.set(signal, 1)
        written, read, commands = [], [], []
        for cycle in range(9):
            if ctx.get(axi.bvalid):
                written.append(cycle)
            if ctx.get(axi.rvalid):
                read.append((cycle, ctx.get(axi.rdata)))
            if ctx.get(dut.command):
                commands.append(cycle)
            ctx.set(dut.status, 100 + cycle)
            await ctx.tick()
        w, r = dut.WRITE_LATENCY, dut.READ_LATENCY
        assert written == commands == [w, 2 * w + 1, 3 * w + 2]
        assert read == [(r, 101), (2 * r + 1, 104), (3 * r + 2, 107)]

    simulate(bench)


def test_reads_beside_writes():
    """Random traffic on both channels at once; the registers end as the writes left them."""
    shadow = {r.name: r.reset for r in STORED}
    counts = {"writes": 0, "reads": 0}

    async def writer(ctx, dut, bus):
        rng = random.Random(SEED)
        for _ in range(60):
            register = rng.choice(STORED)
            value = rng.getrandbits(32)
            shadow[register.name] = value
            order = rng.choice(["both", "address first", "data first"])
            assert await bus.write(register.offset, value, order=order, b_delay=rng.randrange(3)) == (OKAY, 0)
            counts["writes"] += 1
        for register in STORED:
            assert ctx.get(getattr(dut, register.name.lower())) == shadow[register.name]

    async def reader(ctx, dut, bus):
        rng = random.Random(SEED + 1)
        ctx.set(dut.cycles, 0xDEAD_BEEF)
        for _ in range(60):
            offset = rng.choice([BY_NAME["CYCLES"].offset, BY_NAME["ID"].offset, 0x7C])
            expected = {0x2C: (0xDEAD_BEEF, OKAY), 0x00: (BY_NAME["ID"].reset, OKAY), 0x7C: (0, SLVERR)}[
                offset
            ]
            assert await bus.read(offset, r_delay=rng.randrange(3)) == expected
            counts["reads"] += 1

    simulate(writer, reader)
    assert counts == {"writes": 60, "reads": 60}, f"SEED={SEED}"


@pytest.mark.parametrize("bits", [1, 65])
def test_bad_address_width(bits):
    with pytest.raises(ValueError, match=rf"address_bits must be in 2\.\.64, not {bits}"):
        AxiLite(bits)
