"""One case of the regression on a simulated array, and what must hold after every image."""

from __future__ import annotations

from collections import Counter
from collections.abc import Awaitable, Callable, Collection, Mapping
from dataclasses import asdict
from typing import Any

import cocotb
import numpy as np
from cocotb.triggers import ClockCycles, Event, RisingEdge, gather

from macram.driver import BOTTOM, TOP, ArrayDriver, Beats, BusError
from macram.layer_file import LayerCase
from macram.perf import CycleEstimate, estimate
from macram.spec import BY_NAME, ArrayConfig, Control, ConvSpec, Error, Place, Status, accumulator_range
from macram_sim.regression.layer import Codes, LayerRun, draw_layer
from macram_sim.regression.plan import Case
from macram_sim.regression.traffic import CaseTransport

QUIET = 24
"""Cycles after an image in which nothing may come or be taken; longer than the whole pipeline."""


QUIET = 24
"""Cycles after an image in which nothing may come or be taken; longer than the whole pipeline."""


class CaseBench:
    """A case on the array, with what it met.

    Attributes:
        run: what is loaded, run and compared. place: where in the memories it lies.
        events: what happened, in the words of `macram_sim.regression.events`.
    """

    def __init__(self, dut: Any, array: ArrayConfig, case: Case) -> None:
        self.dut, self.array, self.case = dut, array, case
        self.transport = CaseTransport(dut, case)
        self.driver = ArrayDriver(self.transport, array)
        self.events: set[str] = set()
        self._counters: list[dict[str, int]] = []
        self._compared: list[LayerRun] = []
        self.place = TOP if case.at_top else BOTTOM
        self.use(draw_layer(case))

    def use(self, layer: LayerCase) -> None:
        """Make ``layer`` the one of which the case's part is loaded, run and compared."""
        self.run = LayerRun.of(layer, self.case, self.array)

    @property
    def spec(self) -> ConvSpec:
        """The shape of the run."""
        return self.run.spec

    @property
    def other_place(self) -> Place:
        """The other end of the memories."""
        return BOTTOM if self.place.at_top else TOP

    # ---- registers ------------------------------------------------------------------------------------------

    async def prepare(self) -> None:
        """Load the layer and set its shape."""
        await self.driver.load(self.run.packed, place=self.place)
        await self.configure()

    async def configure(self) -> None:
        """Set the layer's shape, place and ends."""
        run = self.run
        rule = run.residual.rule if run.residual else None
        ends = {"sums_in": run.part.sums_in, "sums_out": run.part.sums_out}
        await self.driver.configure(run.spec, rule, place=self.place, **ends)

    async def start(self) -> None:
        """Begin an image."""
        await self.write("CONTROL", Control.START)

    async def write(self, name: str, value: int) -> None:
        """Write a register by name."""
        await self.transport.write(BY_NAME[name].offset, int(value))

    async def read(self, name: str) -> int:
        """Read a register by name."""
        return await self.transport.read(BY_NAME[name].offset)

    async def refused(self, offset: int, value: int | None, event: str) -> None:
        """An access that must be answered SLVERR; ``value`` None reads."""
        try:
            if value is None:
                await self.transport.read(offset)
            else:
                await self.transport.write(offset, value)
        except BusError as error:
            if "SLVERR" not in str(error):
                raise
            self.events.add(event)
            return
        raise AssertionError(f"{event}: the access to {offset:#04x} was answered OKAY")

    async def fails_with(self, code: Error, event: str) -> None:
        """STATUS must have ERROR and not BUSY, with this code."""
        await ClockCycles(self.dut.aclk, QUIET)
        status, value = await self.read("STATUS"), await self.read("ERROR")
        assert status & (Status.BUSY | Status.ERROR) == Status.ERROR, f"{event}: STATUS is {status:#x}"
        assert value == code, f"{event}: ERROR is {value}, not {code.name}"
        self.events.add(event)

    async def ended(self, code: Error = Error.NONE) -> None:
        """The image ends: DONE, not BUSY, and this error; a load may go on."""
        await ClockCycles(self.dut.aclk, 2)
        while (status := await self.read("STATUS")) & Status.BUSY:
            pass
        value = await self.read("ERROR")
        wanted = Status.DONE | (Status.ERROR if code else 0)
        assert (status & ~Status.LOADING, value) == (wanted, code), (
            f"STATUS {status:#x}, ERROR {value} after an image"
        )

    async def stop(self) -> None:
        """Take everything off the streams, reset softly, and see the array idle without an error."""
        self.transport.quiet()
        await self.driver.soft_reset()
        assert await self.read("ERROR") == Error.NONE, "a soft reset left an error"
        assert not await self.read("STATUS") & Status.BUSY, "a soft reset left the array busy"

    # ---- streams --------------------------------------------------------------------------------------------

    async def stream(
        self,
        lasts: Mapping[str, Collection[int]] | None = None,
        *,
        hold: Event | None = None,
        late: Mapping[str, int] | None = None,
    ) -> None:
        """Send and take everything of an image without the driver, and compare.

        Args:
            lasts: the beats with TLAST of some of the sources.
            hold: the image's last beat waits for this.
            late: cycles after which some of the streams begin.
        """
        lasts, late = lasts or {}, late or {}
        moves: dict[str, Awaitable[None]] = {}
        for name, beats in self.run.beats.items():
            held = hold if name == "image" else None
            moves[name] = (
                self._sent_in_two(beats, held) if held else self.transport.send(name, beats, lasts.get(name))
            )
        moves |= {name: self._take(name, count) for name, count in self.run.beats_out.items()}
        await gather(*(self._after(late.get(name, 0), move) for name, move in moves.items()))
        self._compared.append(self.run)

    async def receive(self) -> None:
        """Take everything that leaves in an image, and compare."""
        await gather(*(self._take(name, count) for name, count in self.run.beats_out.items()))
        self._compared.append(self.run)

    def begin(self, cut: Mapping[str, int] | None = None) -> dict[str, Any]:
        """Start moving everything of an image, some of the sources ``cut`` short; tasks by stream, to be cancelled."""
        cut = cut or {}
        moves: dict[str, Any] = {
            name: self.transport.send(name, beats[: cut.get(name, len(beats))])
            for name, beats in self.run.beats.items()
        }
        moves |= {name: self.transport.receive(name, count) for name, count in self.run.beats_out.items()}
        return {name: cocotb.start_soon(move) for name, move in moves.items()}

    def take_all(self) -> None:
        """Take what comes on every output."""
        for name in self.transport.sinks:
            self.transport.line(name, "tready").value = 1

    def open(self, name: str) -> bool:
        """Whether a source would be taken from."""
        return bool(self.transport.line(name, "tready").value)

    async def until(self, reached: Callable[[Counter[str]], bool]) -> None:
        """Wait for the beats moved from now on to be so many."""
        edge, start = RisingEdge(self.dut.aclk), self.transport.moved
        while not reached(self.since(start)):
            await edge

    def since(self, start: Counter[str]) -> Counter[str]:
        """Beats moved since then."""
        moved = self.transport.moved
        moved.subtract(start)
        return moved

    async def _sent_in_two(self, beats: Beats, hold: Event) -> None:
        await self.transport.send("image", beats[:-1], ())
        await hold.wait()
        await self.transport.send("image", beats[-1:])

    async def _after(self, cycles: int, move: Awaitable[None]) -> None:
        if cycles:
            await ClockCycles(self.dut.aclk, cycles)
        await move

    async def _take(self, name: str, count: int) -> None:
        self.compare(name, self.run.unpack(name, await self.transport.receive(name, count)))

    # ---- what must hold -------------------------------------------------------------------------------------

    async def works(self) -> None:
        """A whole image: exact codes, cycles of the closed form, every beat taken once and none too many."""
        run, before = self.run, self.transport.moved
        result = await self.driver.run(
            run.image, run.residual.stream if run.residual else None, sums=run.addends
        )
        self.compare("output", result.codes)
        if result.sums is not None:
            self.compare("residual sums", result.sums)
        self._compared.append(run)
        moved = self.since(before)
        for name, beats in run.beats.items():
            assert moved[name] == len(beats), f"{moved[name]} beats of {name} were taken, not {len(beats)}"
        counters = result.counters
        parts = sum(value for name, value in counters.items() if name != "cycles")
        assert counters["cycles"] == parts, f"{counters} do not add up"
        if self._undisturbed and (closed := self._closed_form()).exact:
            parts_of = (closed.fill, closed.mac, closed.stall, closed.drain)
            stalls = counters["input_stalls"] + counters["output_stalls"]
            measured = (counters["fill_cycles"], counters["mac_cycles"], stalls, counters["drain_cycles"])
            assert measured == parts_of, f"fill, steps, stalls, drain took {measured} cycles, not {parts_of}"
        self._counters.append(counters)
        await self.silence()

    @property
    def _undisturbed(self) -> bool:
        traffic, part = self.case.traffic, self.run.part
        patterns = {traffic.image, traffic.output, traffic.residual, traffic.residual_sums}
        return patterns | ({traffic.params} if part.sums_in else set()) == {"none"}

    def _closed_form(self) -> CycleEstimate:
        part = self.run.part
        return estimate(
            self.spec,
            self.array,
            residual=self.run.residual is not None,
            sums_in=part.sums_in,
            sums_out=part.sums_out,
        )

    def compare(self, name: str, codes: Codes) -> None:
        """Equality with the golden model, every code."""
        wanted = self.run.wanted[name]
        wrong = np.argwhere(codes != wanted)
        assert not len(wrong), (
            f"{len(wrong)} of {codes.size} of {name} differ, first [channel, row, column] {wrong[0].tolist()}: "
            f"{codes[tuple(wrong[0])]}, not {wanted[tuple(wrong[0])]}"
        )

    async def silence(self) -> None:
        """No beat may come out and none be taken between images."""
        edge = RisingEdge(self.dut.aclk)
        line = self.transport.line
        offers = {name: line(name, "tvalid") for name in self.transport.sinks}
        self.take_all()
        for _ in range(QUIET):
            await edge
            for name, valid in offers.items():
                assert not valid.value, f"a beat of {name} was invented after the image"
            for name in self.transport.sources:
                assert not self.open(name), f"the stream {name} is open after the image"
        self.transport.quiet()

    def observation(self) -> dict[str, Any]:
        """What the case met, in plain values: the fields of `macram_sim.regression.observation.Observation`."""
        case, run = self.case, self.run
        spec, whole = run.spec, run.part.c_in.stop * run.spec.kernel**2
        lo, hi = accumulator_range(spec.weight, spec.input, whole)
        codes = np.concatenate([run.branch.ravel() for run in self._compared])
        sums = [run.wanted["residual sums"].ravel() for run in self._compared if run.residual]
        following = [run.wanted["output"].ravel() for run in self._compared if run.residual]
        return {
            "index": case.index,
            "scenario": case.scenario,
            "layer": [spec.c_in, spec.c_out, spec.height, spec.width, spec.kernel, spec.stride],
            "input": str(spec.input),
            "block": case.block,
            "whole_c_in": run.layer.spec.c_in,
            "at_top": self.place.at_top,
            "kind": case.kind,
            "patterns": asdict(case.traffic),
            "scales": sorted({int(np.sign(value)) for value in run.layer.scale}),
            "bias_alone": bool((run.layer.scale == 1).all()),
            "codes": None if run.part.sums_out else _ends(codes),
            "sums_at_limit": [bool((run.sums == lo).any()), bool((run.sums == hi).any())],
            "residual_sums": _ends(np.concatenate(sums)) if sums else None,
            "next_codes": _ends(np.concatenate(following)) if following else None,
            "counters": self._counters,
            "events": sorted(self.events),
        }


def _ends(codes: Codes) -> list[int]:
    return [int(codes.min()), int(codes.max())]
