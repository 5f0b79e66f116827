"""Scenarios of the registers: accesses while the array runs, and commands that must be refused."""

from __future__ import annotations

import random

import cocotb
from cocotb.triggers import ClockCycles, Event

from macram.spec import MAX_SIDE, REGISTERS, Control, Error, Status
from macram.spec.registers import (
    ADDRESS_BITS,
    LOAD_REGISTERS,
    MODE_3X3,
    MODE_BIASED,
    MODE_RESIDUAL,
    MODE_SUMS_IN,
    MODE_SUMS_OUT,
)
from macram_sim.regression.case import CaseBench
from macram_sim.regression.loads import Scenario, begin_load


async def writes_while_busy(bench: CaseBench, rng: random.Random) -> None:
    """In the middle of an image, whose last beat waits for them; the image goes on unharmed."""
    stored = [r for r in REGISTERS if r.access == "RW" and r.name not in LOAD_REGISTERS]
    before = {r.name: await bench.read(r.name) for r in stored}
    hold = Event()
    await bench.start()
    image = cocotb.start_soon(bench.stream(hold=hold))
    await bench.until(lambda moved: moved["image"] >= bench.case.moment * (len(bench.run.beats["image"]) - 1))
    await bench.refused(rng.choice(stored).offset, rng.getrandbits(32), "a register written while busy")
    await bench.write("CONTROL", rng.choice([1, 3, 5, 7]))
    assert await bench.read("ERROR") == Error.BAD_COMMAND
    bench.events.add("a command while busy")
    hold.set()
    await image
    await bench.ended(Error.BAD_COMMAND)
    after = {r.name: await bench.read(r.name) for r in stored}
    assert before == after, f"a refused write changed a register: {before} became {after}"


async def load_while_busy(bench: CaseBench, rng: random.Random) -> None:
    """A load onto the running layer is refused, of whatever words if the run takes sums; the image is unharmed."""
    taking = bench.run.part.sums_in
    code = Error.BAD_COMMAND if taking else Error.BAD_RANGE
    await bench.start()
    await ClockCycles(bench.dut.aclk, 4)
    await begin_load(bench, weights=rng.random() < 0.5)
    assert await bench.read("ERROR") == code
    assert not await bench.read("STATUS") & Status.LOADING
    await bench.stream()
    await bench.ended(code)
    bench.events.add(
        "BAD_COMMAND, a load while sums come" if taking else "BAD_RANGE, a load onto the running layer"
    )


async def start_in_load(bench: CaseBench, rng: random.Random) -> None:
    """A run of words that are being loaded is refused, and the load goes on."""
    beats = await begin_load(bench, weights=rng.random() < 0.5)
    part = int(bench.case.moment * (len(beats) - 1))
    await bench.transport.send("params", beats[:part], ())
    await bench.start()
    await bench.fails_with(Error.BAD_RANGE, "BAD_RANGE, a start in the load of its words")
    assert not bench.open("image"), "the image stream is open"
    assert await bench.read("STATUS") & Status.LOADING, "a refused start ended a load"
    await bench.transport.send("params", beats[part:])
    await ClockCycles(bench.dut.aclk, 4)
    assert await bench.read("STATUS") == Status.ERROR


async def bad_accesses(bench: CaseBench, rng: random.Random) -> None:
    """Reads and writes of what is not there, while an image runs."""
    known = {r.offset for r in REGISTERS}
    nowhere = [offset for offset in range(0, 1 << ADDRESS_BITS, 4) if offset not in known]
    read_only = rng.choice([r for r in REGISTERS if r.access == "RO"])
    await bench.start()
    image = cocotb.start_soon(bench.stream())
    await bench.refused(read_only.offset, rng.getrandbits(32), "a read-only register written")
    await bench.refused(rng.choice(nowhere), rng.getrandbits(32), "an unmapped address written")
    await bench.refused(rng.choice(nowhere), None, "an unmapped address read")
    await image
    await bench.ended()


async def bad_shape(bench: CaseBench, rng: random.Random) -> None:
    """Each register out of range by itself, then layers that do not fit the memories; no beat is taken."""
    array = bench.array
    one_each = [("HEIGHT", 0), ("WIDTH", 0), ("C_IN", 0), ("C_OUT", 0)]
    too_large = [
        ("HEIGHT", MAX_SIDE + 1), ("WIDTH", MAX_SIDE + 1),
        ("C_IN", array.max_c_in + 1), ("C_OUT", array.max_c_out + 1),
    ]  # fmt: skip
    bad: list[tuple[str, dict[str, int]]] = [
        *((f"BAD_SHAPE, {name} 0", {name: value}) for name, value in one_each),
        *((f"BAD_SHAPE, {name} too large", {name: value}) for name, value in too_large),
        ("BAD_SHAPE, row too long", {"WIDTH": MAX_SIDE, "HEIGHT": 1}),
    ]
    if 3 * array.max_tiles * array.blocks(array.max_c_in) > array.weight_depth:
        widest = {"MODE": MODE_3X3, "WIDTH": 1, "C_IN": array.max_c_in, "C_OUT": array.max_c_out}
        bad.append(("BAD_SHAPE, too many weights", widest))
    for event, values in bad:
        await _refused_start(bench, values, Error.BAD_SHAPE, event)


async def bad_mode(bench: CaseBench, rng: random.Random) -> None:
    """Each field of MODE, and each of its bits that the array has no logic for."""
    array, mode = bench.array, await bench.read("MODE")
    for what, shift, values in (
        ("kernel", 0, (0, 2, 5)),
        ("stride", 8, (0, 3, 255)),
        ("padding", 16, (2, 255)),
    ):
        value = mode & ~(0xFF << shift) | rng.choice(values) << shift
        await _refused_start(bench, {"MODE": value}, Error.BAD_MODE, f"BAD_MODE, {what}")
    lacking = [28, 29, 30, 31]
    lacking += [MODE_BIASED] if array.input.signed else []
    lacking += [] if array.residual_stream_bits else [MODE_RESIDUAL]
    lacking += [] if array.partial_sum_c_in else [MODE_SUMS_IN, MODE_SUMS_OUT]
    for bit in lacking:
        await _refused_start(
            bench, {"MODE": mode | 1 << bit}, Error.BAD_MODE, "BAD_MODE, a bit that the array lacks"
        )
    if array.residual_stream_bits and array.partial_sum_c_in:
        both = {"MODE": mode | 1 << MODE_RESIDUAL | 1 << MODE_SUMS_OUT}
        await _refused_start(bench, both, Error.BAD_MODE, "BAD_MODE, a residual sum where sums leave")


async def bad_command(bench: CaseBench, rng: random.Random) -> None:
    """Loads of no words or beyond the memories, a layer beyond them, two commands at once."""
    array, packed = bench.array, bench.run.packed
    either = rng.choice([Control.LOAD_WEIGHTS, Control.LOAD_REQUANT])
    for event, base, words, command, code in (
        ("BAD_RANGE, no words", 0, 0, either, Error.BAD_RANGE),
        ("BAD_RANGE, too many weights", 0, array.weight_depth + 1, Control.LOAD_WEIGHTS, Error.BAD_RANGE),
        ("BAD_RANGE, too many requantiser words", 0, array.requant_depth + 1, Control.LOAD_REQUANT, Error.BAD_RANGE),
        ("BAD_RANGE, weights beyond the end", array.weight_depth - 1, 2, Control.LOAD_WEIGHTS, Error.BAD_RANGE),
        (
            "BAD_RANGE, requantiser words beyond the end", array.requant_depth - 1, 2,
            Control.LOAD_REQUANT, Error.BAD_RANGE,
        ),
        ("BAD_COMMAND, two commands", 0, 1, rng.choice([3, 5, 6, 7]), Error.BAD_COMMAND),
    ):  # fmt: skip
        await bench.write("PARAM_BASE", base)
        await bench.write("PARAM_WORDS", words)
        await bench.write("CONTROL", command)
        await bench.fails_with(code, event)
    for name, base, event in (
        (
            "WEIGHT_BASE",
            array.weight_depth - packed.weight_words + 1,
            "BAD_RANGE, a layer beyond the weights",
        ),
        (
            "REQUANT_BASE",
            array.requant_depth - packed.requant_words + 1,
            "BAD_RANGE, a layer beyond the requantiser",
        ),
    ):
        await _refused_start(bench, {name: base}, Error.BAD_RANGE, event)


async def _refused_start(bench: CaseBench, values: dict[str, int], code: Error, event: str) -> None:
    """START with these registers changed sets the error and opens no stream."""
    for name, value in values.items():
        await bench.write(name, value)
    await bench.start()
    await bench.fails_with(code, event)
    for name in bench.transport.sources:
        assert not bench.open(name), f"{event}: the stream {name} is open"
    await bench.configure()


SCENARIOS: dict[str, Scenario] = {
    "writes while busy": writes_while_busy,
    "load while busy": load_while_busy,
    "load while busy, taking sums": load_while_busy,
    "start in its load": start_in_load,
    "bad accesses": bad_accesses,
    "bad shape": bad_shape,
    "bad mode": bad_mode,
    "bad command": bad_command,
}
