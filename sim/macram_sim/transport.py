"""The driver's transport to a simulated array: an AXI4-Lite manager and the streams, in cocotb."""

from __future__ import annotations

import random
from collections.abc import Awaitable, Callable
from typing import Any, NoReturn

import cocotb
import numpy as np
from cocotb.triggers import Lock, RisingEdge, Timer, gather, select

from macram.driver import Beats, BusError, StreamTimeout
from macram_sim.clocks import PERIOD_NS
from macram_sim.streams import AxisSink, AxisSource, pauses

QUIET_CYCLES = 50_000
"""Cycles in which no beat moves on any stream before a transfer is given up."""
_LOOK_CYCLES = 1_000
BUS_CYCLES = 1_000
"""Cycles that a register access may take."""
_RESPONSES = ("OKAY", "EXOKAY", "SLVERR", "DECERR")


class AxiLiteManager:
    """Reads and writes 32-bit registers on ``{prefix}_*``, one access at a time."""

    def __init__(self, dut: Any, prefix: str = "s_axi") -> None:
        self._edge = RisingEdge(dut.aclk)
        self._lock = Lock()

        def driven(name: str) -> Any:
            signal = getattr(dut, f"{prefix}_{name}")
            signal.value = 0
            return signal

        self._awaddr, self._awvalid = driven("awaddr"), driven("awvalid")
        self._wdata, self._wstrb, self._wvalid = driven("wdata"), driven("wstrb"), driven("wvalid")
        self._araddr, self._arvalid = driven("araddr"), driven("arvalid")
        self._bready, self._rready = driven("bready"), driven("rready")
        driven("awprot")
        driven("arprot")
        self._awready, self._wready, self._arready, self._bvalid, self._bresp, self._rvalid, self._rresp = (
            getattr(dut, f"{prefix}_{name}")
            for name in ("awready", "wready", "arready", "bvalid", "bresp", "rvalid", "rresp")
        )
        self._rdata = getattr(dut, f"{prefix}_rdata")

    async def write(self, offset: int, value: int) -> None:
        """Write all four bytes; `BusError` on any answer but OKAY, or none."""
        async with self._lock:
            self._awaddr.value, self._wdata.value, self._wstrb.value = offset, value, 0xF
            self._awvalid.value = self._wvalid.value = self._bready.value = 1
            waiting = {self._awready: self._awvalid, self._wready: self._wvalid}
            for _ in range(BUS_CYCLES):
                await self._edge
                for ready, valid in list(waiting.items()):
                    if ready.value:
                        valid.value = 0
                        del waiting[ready]
                if not waiting and self._bvalid.value:
                    break
            else:
                raise BusError(f"the write to {offset:#04x} has no answer after {BUS_CYCLES} cycles")
            self._bready.value = 0
            self._check(self._bresp, f"the write of {value:#x} to {offset:#04x}")

    async def read(self, offset: int) -> int:
        """Value of a register; `BusError` on any answer but OKAY, or none."""
        async with self._lock:
            self._araddr.value = offset
            self._arvalid.value = self._rready.value = 1
            taken = False
            for _ in range(BUS_CYCLES):
                await self._edge
                if not taken and self._arready.value:
                    self._arvalid.value = 0
                    taken = True
                if taken and self._rvalid.value:
                    break
            else:
                raise BusError(f"the read of {offset:#04x} has no answer after {BUS_CYCLES} cycles")
            self._rready.value = 0
            self._check(self._rresp, f"the read of {offset:#04x}")
            return int(self._rdata.value)

    @staticmethod
    def _check(response: Any, access: str) -> None:
        if code := int(response.value):
            raise BusError(f"{access} was answered {_RESPONSES[code]}")


class CocotbTransport:
    """Registers and streams of a simulated array.

    Args:
        dut: the top; its clock must be running.
        gaps: pattern of the sources, see `macram_sim.streams.PATTERNS`.
        stalls: pattern of the sink.
        seed: of the patterns.
        progress: called now and then with the output beats received and expected.
    """

    def __init__(
        self,
        dut: Any,
        *,
        gaps: str = "none",
        stalls: str = "none",
        seed: int = 0,
        progress: Callable[[int, int], None] | None = None,
    ) -> None:
        self._dut = dut
        self._registers = AxiLiteManager(dut)
        self._image = AxisSource(dut, "s_axis", pauses(gaps, random.Random(f"image {seed}")))
        self._params = AxisSource(dut, "s_axis_param", pauses(gaps, random.Random(f"param {seed}")))
        self._output = AxisSink(dut, "m_axis", pauses(stalls, random.Random(f"output {seed}")))
        self._progress = progress
        self._streams: list[AxisSource | AxisSink] = [self._image, self._params, self._output]
        if hasattr(dut, "s_axis_residual_tdata"):
            self._residual = AxisSource(
                dut, "s_axis_residual", pauses(gaps, random.Random(f"residual {seed}"))
            )
            self._sums = AxisSink(dut, "m_axis_residual", pauses(stalls, random.Random(f"sums {seed}")))
            self._streams += [self._residual, self._sums]
        self._running: Any = None

    async def reset(self, cycles: int = 4) -> None:
        """Hold ``aresetn`` low, then high."""
        edge = RisingEdge(self._dut.aclk)
        for level, count in ((0, cycles), (1, 1)):
            self._dut.aresetn.value = level
            for _ in range(count):
                await edge

    def quiet(self) -> None:
        """Offer and take nothing, as after an image that was given up."""
        for stream in self._streams:
            stream.quiet()

    async def read(self, offset: int) -> int:
        """Read a register."""
        return await self._registers.read(offset)

    async def write(self, offset: int, value: int) -> None:
        """Write a register."""
        await self._registers.write(offset, value)

    async def send_params(self, beats: Beats) -> None:
        """Send beats on the parameter stream."""
        await select(self._params.send(beats), self._watchdog(0))

    def check_params(self, beats: Beats) -> None:
        """Nothing to refuse: a simulated stream takes a packet of any length."""

    async def run_stream(
        self, beats: Beats, beats_out: int, residual: Beats | None = None, sums: Beats | None = None
    ) -> list[Beats]:
        """Send an image, with it a residual stream and partial sums, and return the beats that come back meanwhile."""
        receiving, sending = [self._output.receive(beats_out)], [self._image.send(beats)]
        if residual is not None:
            receiving.append(self._sums.receive(len(residual)))
            sending.append(self._residual.send(residual))
        if sums is not None:
            sending.append(self._params.send(sums))
        _, result = await select(gather(*receiving, *sending), self._watchdog(beats_out))
        return [np.asarray(beats) for beats in result[: len(receiving)]]

    async def begin_stream(
        self, beats: Beats, beats_out: int, residual: Beats | None = None, sums: Beats | None = None
    ) -> None:
        """Start sending an image; its outcome, be it an error, waits for `end_stream`."""
        self._running = cocotb.start_soon(self._outcome(self.run_stream(beats, beats_out, residual, sums)))

    async def end_stream(self) -> list[Beats]:
        """The beats of the image that was begun."""
        outcome: list[Beats] | Exception = await self._running
        if isinstance(outcome, Exception):
            raise outcome
        return outcome

    @staticmethod
    async def _outcome(run: Awaitable[list[Beats]]) -> list[Beats] | Exception:
        try:
            return await run
        except Exception as error:  # cocotb would end the test although someone is going to ask
            return error

    async def _watchdog(self, expected: int) -> NoReturn:
        """Report progress, and raise once nothing has moved for `QUIET_CYCLES`."""
        start = self._output.moved
        before, quiet = -1, 0
        look = Timer(_LOOK_CYCLES * PERIOD_NS, "ns")
        while quiet < QUIET_CYCLES:
            await look
            moved = sum(stream.moved for stream in self._streams)
            quiet = quiet + _LOOK_CYCLES if moved == before else 0
            before = moved
            if self._progress is not None and expected:
                self._progress(self._output.moved - start, expected)
        self.quiet()
        raise StreamTimeout(
            f"no beat moved for {QUIET_CYCLES:,} cycles; {self._output.moved - start:,} of {expected:,} "
            "output beats received"
        )
