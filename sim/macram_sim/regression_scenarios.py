"""The scenarios of the regression: how a case disturbs the array, and that it works again afterwards."""

from __future__ import annotations

import random
from collections.abc import Awaitable, Callable
from dataclasses import replace
from typing import Any

import cocotb
import numpy as np
from cocotb.triggers import ClockCycles, RisingEdge, gather

from macram.golden import random_case
from macram.spec import MAX_SIDE, REGISTERS, Control, Error, Status
from macram.spec.registers import ADDRESS_BITS, LOAD_REGISTERS, MODE_3X3
from macram_sim.regression_case import CaseBench

Scenario = Callable[[CaseBench, random.Random], Awaitable[None]]


async def perform(bench: CaseBench, rng: random.Random) -> None:
    """Run the case's scenario from a loaded and configured array, then a whole image."""
    await bench.prepare()
    await _SCENARIOS[bench.case.scenario](bench, rng)
    await bench.works()


# ---- images and reloads -----------------------------------------------------------------------------------


async def _plain(bench: CaseBench, rng: random.Random) -> None:
    bench.events.add("one image")


async def _reuse(bench: CaseBench, rng: random.Random) -> None:
    await bench.works()
    other = random_case(bench.spec, bench.case.seed + 1).input
    bench.use(replace(bench.layer, input=other))
    bench.events.add("another image, same weights")


async def _reload(bench: CaseBench, rng: random.Random) -> None:
    await bench.works()
    bench.use(random_case(bench.spec, bench.case.seed + 1))
    await bench.driver.load(bench.packed)
    bench.events.add("other weights, same shape")


async def _snooped(bench: CaseBench, rng: random.Random) -> None:
    running = True

    async def snoop() -> None:
        while running:
            register = rng.choice(REGISTERS)
            value = await bench.transport.read(register.offset)
            if register.name in ("ID", "VERSION"):
                assert value == register.reset, f"{register.name} reads {value:#x} during a run"
            await ClockCycles(bench.dut.aclk, rng.randrange(1, 30))

    task = cocotb.start_soon(snoop())
    await bench.works()
    running = False
    await task
    bench.events.add("registers read in a run")


async def _back_to_back(bench: CaseBench, rng: random.Random) -> None:
    """The next image's first beat waits at the port, and is the first one after the next START."""
    count = len(bench.beats)
    source = cocotb.start_soon(
        bench.transport.send_image(np.concatenate([bench.beats] * 2), {count - 1, 2 * count - 1})
    )
    for _ in range(2):
        await bench.write("CONTROL", Control.START)
        before = bench.transport.moved[0]
        await bench.receive_codes()
        assert bench.transport.moved[0] - before <= count, "a beat of the next image was taken"
        await _ended(bench, Error.NONE)
    await source
    bench.events.add("the next image waits at the port")


# ---- register accesses -------------------------------------------------------------------------------------


async def _writes_while_busy(bench: CaseBench, rng: random.Random) -> None:
    """In the middle of an image; the image goes on unharmed."""
    stored = [r for r in REGISTERS if r.access == "RW" and r.name not in LOAD_REGISTERS]
    before = {r.name: await bench.read(r.name) for r in stored}
    await bench.write("CONTROL", Control.START)
    image = cocotb.start_soon(bench.stream())
    await _until(bench, lambda moved, start: moved[0] - start[0] >= bench.case.moment * len(bench.beats) - 1)
    refusal = Error.NONE
    if len(bench.beats) > 12:
        # A short image may end before the last of these writes.
        register = rng.choice(stored)
        await bench.refused(register.offset, rng.getrandbits(32), "a register written while busy")
        await bench.write("CONTROL", rng.choice([1, 3, 5, 7]))
        refusal = Error.BAD_COMMAND
        assert await bench.read("ERROR") == refusal
        bench.events.add("a command while busy")
    await image
    await _ended(bench, refusal)
    after = {r.name: await bench.read(r.name) for r in stored}
    assert before == after, f"a refused write changed a register: {before} became {after}"


async def _load_while_busy(bench: CaseBench, rng: random.Random) -> None:
    """A load onto the running layer is refused, and the image is unharmed."""
    command, words, _ = _load_of(bench, weights=rng.random() < 0.5)
    await bench.write("PARAM_BASE", 0)
    await bench.write("PARAM_WORDS", words)
    await bench.write("CONTROL", Control.START)
    await ClockCycles(bench.dut.aclk, 4)
    await bench.write("CONTROL", command)
    assert await bench.read("ERROR") == Error.BAD_RANGE
    await bench.stream()
    await _ended(bench, Error.BAD_RANGE)
    bench.events.add("BAD_RANGE, a load onto the running layer")


async def _bad_accesses(bench: CaseBench, rng: random.Random) -> None:
    """Reads and writes of what is not there, while an image runs."""
    known = {r.offset for r in REGISTERS}
    nowhere = [offset for offset in range(0, 1 << ADDRESS_BITS, 4) if offset not in known]
    read_only = rng.choice([r for r in REGISTERS if r.access == "RO"])
    await bench.write("CONTROL", Control.START)
    image = cocotb.start_soon(bench.stream())
    await bench.refused(read_only.offset, rng.getrandbits(32), "a read-only register written")
    await bench.refused(rng.choice(nowhere), rng.getrandbits(32), "an unmapped address written")
    await bench.refused(rng.choice(nowhere), None, "an unmapped address read")
    await image
    await _ended(bench, Error.NONE)


# ---- resets ------------------------------------------------------------------------------------------------


async def _reset_waiting(bench: CaseBench, rng: random.Random) -> None:
    await bench.write("CONTROL", Control.START)
    await ClockCycles(bench.dut.aclk, rng.randrange(1, 8))
    assert await bench.read("STATUS") & Status.BUSY
    await bench.stop()
    bench.events.add("soft reset before the first beat")


def _reset_when(event: str, reached: Callable[[CaseBench, int, int], bool]) -> Scenario:
    """A soft reset once ``reached(bench, input beats, output beats)``; what was met decides the event."""

    async def scenario(bench: CaseBench, rng: random.Random) -> None:
        await bench.write("CONTROL", Control.START)
        start = bench.transport.moved
        tasks: list[Any] = [
            cocotb.start_soon(bench.transport.send_image(bench.beats)),
            cocotb.start_soon(bench.transport.receive(bench.beats_out)),
        ]
        await _until(bench, lambda moved, _: reached(bench, moved[0] - start[0], moved[2] - start[2]))
        moved = bench.transport.moved
        for task in tasks:
            task.cancel()
        await bench.stop()
        taken, came = moved[0] - start[0], moved[2] - start[2]
        if taken > 0 and came < bench.beats_out:
            bench.events.add(event)

    return scenario


def _early(bench: CaseBench, taken: int, came: int) -> bool:
    return taken >= 1 + bench.case.moment * 2


def _emitting(bench: CaseBench, taken: int, came: int) -> bool:
    return came >= 1 + bench.case.moment * 0.9 * (bench.beats_out - 2)


def _ending(bench: CaseBench, taken: int, came: int) -> bool:
    return taken == len(bench.beats) or came == bench.beats_out


def _reset_in_load(weights: bool) -> Scenario:
    async def scenario(bench: CaseBench, rng: random.Random) -> None:
        command, words, beats = _load_of(bench, weights)
        await bench.write("PARAM_WORDS", words)
        await bench.write("CONTROL", command)
        part = 1 + int(bench.case.moment * (len(beats) - 1))
        await bench.transport.send_words(beats[:part], ())
        await bench.stop()
        bench.events.add(f"soft reset in a load of {'weights' if weights else 'the requantiser'}")
        await bench.prepare()

    return scenario


async def _reset_with_commands(bench: CaseBench, rng: random.Random) -> None:
    """It overrides the commands written with it."""
    await bench.write("CONTROL", Control.SOFT_RESET | rng.choice([1, 2, 4, 7]))
    await ClockCycles(bench.dut.aclk, 8)
    assert await bench.read("STATUS") == 0, "a soft reset did not override the commands written with it"
    bench.events.add("soft reset with other commands")


async def _hard_reset(bench: CaseBench, rng: random.Random) -> None:
    """The reset input in the middle of an image: registers at their reset values, memories as they were."""
    await bench.write("CONTROL", Control.START)
    start = bench.transport.moved
    tasks: list[Any] = [
        cocotb.start_soon(bench.transport.send_image(bench.beats)),
        cocotb.start_soon(bench.transport.receive(bench.beats_out)),
    ]
    await _until(bench, lambda moved, _: moved[0] - start[0] >= bench.case.moment * len(bench.beats))
    for task in tasks:
        task.cancel()
    bench.transport.quiet()
    await bench.transport.reset()
    for register in REGISTERS:
        if register.access == "RW":
            value = await bench.read(register.name)
            assert value == register.reset, f"{register.name} is {value:#x} after a reset"
    assert await bench.read("STATUS") == 0
    await bench.driver.configure(bench.spec)
    bench.events.add("reset input in a run")


# ---- faults on the streams -----------------------------------------------------------------------------------


async def _early_tlast(bench: CaseBench, rng: random.Random) -> None:
    """The run goes on by the shape: exact codes, DONE and the error."""
    early = int(bench.case.moment * (len(bench.beats) - 1))
    await bench.write("CONTROL", Control.START)
    await bench.stream({early, len(bench.beats) - 1})
    await _ended(bench, Error.TLAST_EARLY)
    bench.events.add("TLAST_EARLY in an image")


async def _missing_tlast(bench: CaseBench, rng: random.Random) -> None:
    await bench.write("CONTROL", Control.START)
    await bench.stream(())
    await _ended(bench, Error.TLAST_MISSING)
    bench.events.add("TLAST_MISSING in an image")


async def _truncated(bench: CaseBench, rng: random.Random) -> None:
    """The array names the fault, stays busy, and a soft reset recovers it."""
    await bench.write("CONTROL", Control.START)
    part = 1 + int(bench.case.moment * (len(bench.beats) - 2))
    bench.dut.m_axis_tready.value = 1  # else the output could keep the input from ending
    await bench.transport.send_image(bench.beats[:part])
    await ClockCycles(bench.dut.aclk, 300)
    assert await bench.read("ERROR") == Error.TLAST_EARLY
    assert await bench.read("STATUS") & Status.BUSY, "the array ended an image that never came"
    await bench.stop()
    bench.events.add("an image that ends too soon")


def _bad_load(weights: bool) -> Scenario:
    async def scenario(bench: CaseBench, rng: random.Random) -> None:
        command, words, beats = _load_of(bench, weights)
        what = "weights" if weights else "the requantiser"
        await bench.write("PARAM_WORDS", words)
        if len(beats) > 1:
            await bench.write("CONTROL", command)
            await bench.transport.send_words(beats[: 1 + int(bench.case.moment * (len(beats) - 2))])
            await bench.fails_with(Error.TLAST_EARLY, f"TLAST_EARLY in a load of {what}")
        await bench.write("CONTROL", command)
        await bench.transport.send_words(beats, ())
        await bench.fails_with(Error.TLAST_MISSING, f"TLAST_MISSING in a load of {what}")
        await bench.prepare()

    return scenario


def _load_of(
    bench: CaseBench, weights: bool
) -> tuple[Control, int, np.ndarray[tuple[int, ...], np.dtype[np.uint8]]]:
    beats = bench.packed.load_beats()
    if weights:
        return Control.LOAD_WEIGHTS, bench.packed.weight_words, beats[0]
    return Control.LOAD_REQUANT, bench.packed.requant_words, beats[1]


# ---- refused commands ------------------------------------------------------------------------------------------


async def _bad_shape(bench: CaseBench, rng: random.Random) -> None:
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
        bad.append(
            (
                "BAD_SHAPE, too many weights",
                {"MODE": MODE_3X3, "WIDTH": 1, "C_IN": array.max_c_in, "C_OUT": array.max_c_out},
            )
        )
    for event, values in bad:
        for name, value in values.items():
            await bench.write(name, value)
        await bench.write("CONTROL", Control.START)
        await bench.fails_with(Error.BAD_SHAPE, event)
        assert not bench.dut.s_axis_tready.value, f"{event}: the image stream is open"
        await bench.driver.configure(bench.spec)


async def _bad_mode(bench: CaseBench, rng: random.Random) -> None:
    for what, shift, values in (
        ("kernel", 0, (0, 2, 5)),
        ("stride", 8, (0, 3, 255)),
        ("padding", 16, (2, 255)),
    ):
        mode = await bench.read("MODE")
        value = rng.choice(values)
        await bench.write("MODE", mode & ~(0xFF << shift) | value << shift)
        await bench.write("CONTROL", Control.START)
        await bench.fails_with(Error.BAD_MODE, f"BAD_MODE, {what}")
        await bench.driver.configure(bench.spec)


async def _bad_command(bench: CaseBench, rng: random.Random) -> None:
    array = bench.array
    for event, words, command, code in (
        ("BAD_RANGE, no words", 0, rng.choice([Control.LOAD_WEIGHTS, Control.LOAD_REQUANT]), Error.BAD_RANGE),
        ("BAD_RANGE, too many weights", array.weight_depth + 1, Control.LOAD_WEIGHTS, Error.BAD_RANGE),
        (
            "BAD_RANGE, too many requantiser words",
            array.requant_depth + 1,
            Control.LOAD_REQUANT,
            Error.BAD_RANGE,
        ),
        ("BAD_COMMAND, two commands", 1, rng.choice([3, 5, 6, 7]), Error.BAD_COMMAND),
    ):
        await bench.write("PARAM_WORDS", words)
        await bench.write("CONTROL", command)
        await bench.fails_with(code, event)


# ---- waiting -----------------------------------------------------------------------------------------------------


async def _until(
    bench: CaseBench, reached: Callable[[tuple[int, int, int], tuple[int, int, int]], bool]
) -> None:
    edge, start = RisingEdge(bench.dut.aclk), bench.transport.moved
    while not reached(bench.transport.moved, start):
        await edge


async def _ended(bench: CaseBench, code: Error) -> None:
    """DONE, not BUSY, and this error."""
    await ClockCycles(bench.dut.aclk, 2)
    status, value = await gather(bench.read("STATUS"), bench.read("ERROR"))
    wanted = Status.DONE | (Status.ERROR if code else 0)
    assert (status, value) == (wanted, code), f"STATUS {status:#x}, ERROR {value} after an image"


_SCENARIOS: dict[str, Scenario] = {
    "plain": _plain,
    "reuse": _reuse,
    "reload": _reload,
    "snooped": _snooped,
    "back to back": _back_to_back,
    "writes while busy": _writes_while_busy,
    "load while busy": _load_while_busy,
    "bad accesses": _bad_accesses,
    "reset waiting": _reset_waiting,
    "reset filling": _reset_when("soft reset while the line buffer fills", _early),
    "reset emitting": _reset_when("soft reset between output beats", _emitting),
    "reset ending": _reset_when("soft reset after the last input beat", _ending),
    "reset in weights": _reset_in_load(weights=True),
    "reset in requant": _reset_in_load(weights=False),
    "reset with commands": _reset_with_commands,
    "hard reset": _hard_reset,
    "early TLAST": _early_tlast,
    "missing TLAST": _missing_tlast,
    "truncated image": _truncated,
    "bad weights load": _bad_load(weights=True),
    "bad requant load": _bad_load(weights=False),
    "bad shape": _bad_shape,
    "bad mode": _bad_mode,
    "bad command": _bad_command,
}
