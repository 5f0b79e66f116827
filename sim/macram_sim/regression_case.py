"""One case of the regression on a simulated array: its layer, its traffic, and what must hold after every image."""

from __future__ import annotations

import random
from collections.abc import Collection
from typing import Any

import numpy as np
from cocotb.triggers import ClockCycles, RisingEdge, gather
from numpy.typing import NDArray

from macram.driver import ArrayDriver, Beats, BusError
from macram.golden import random_case, run_layer
from macram.golden.conv import conv2d
from macram.layer_file import LayerCase
from macram.pack import PackedLayer, pack_layer
from macram.perf import estimate
from macram.spec import BY_NAME, ArrayConfig, ConvSpec, Error, Status, StreamLayout, accumulator_range
from macram_sim.regression_plan import Case
from macram_sim.streams import AxisSource, pauses
from macram_sim.transport import CocotbTransport

QUIET = 24
"""Cycles after an image in which nothing may come or be taken; longer than the whole pipeline."""


class CaseTransport(CocotbTransport):
    """`CocotbTransport` whose three streams have patterns of their own, and can be moved one by one."""

    def __init__(self, dut: Any, case: Case) -> None:
        super().__init__(dut, gaps=case.image_gaps, stalls=case.stalls, seed=case.seed)
        self._params = AxisSource(
            dut, "s_axis_param", pauses(case.param_gaps, random.Random(f"param {case.seed}"))
        )

    @property
    def moved(self) -> tuple[int, int, int]:
        """Beats moved so far: image, parameters, output."""
        return self._image.moved, self._params.moved, self._output.moved

    async def send_image(self, beats: Beats, lasts: Collection[int] | None = None) -> None:
        """Send image beats, TLAST where ``lasts`` says."""
        await self._image.send(beats, lasts)

    async def send_words(self, beats: Beats, lasts: Collection[int] | None = None) -> None:
        """Send parameter beats, TLAST where ``lasts`` says."""
        await self._params.send(beats, lasts)

    async def receive(self, count: int) -> Beats:
        """Take output beats, the last of which must have TLAST."""
        return await self._output.receive(count)


class CaseBench:
    """A case on the array, with what it met.

    Attributes:
        events: what happened, in the words of `macram_sim.coverage`.
    """

    def __init__(self, dut: Any, array: ArrayConfig, case: Case) -> None:
        self.dut, self.array, self.case = dut, array, case
        self.transport = CaseTransport(dut, case)
        self.driver = ArrayDriver(self.transport, array)
        self.events: set[str] = set()
        self._counters: list[dict[str, int]] = []
        self._codes: list[NDArray[np.int64]] = []
        self.use(random_case(case.spec, case.seed, case.kind))

    def use(self, layer: LayerCase) -> None:
        """Make ``layer`` the one that is loaded, run and compared."""
        array, spec = self.array, layer.spec
        self.layer = layer
        self.packed: PackedLayer = pack_layer(layer, array)
        self.expected = run_layer(layer)
        self.beats = StreamLayout(spec.c_in, array.input, array.stream_bits).pack(layer.input)
        self.output = StreamLayout(spec.c_out, array.output, array.stream_bits)

    @property
    def spec(self) -> ConvSpec:
        """The layer's shape."""
        return self.layer.spec

    @property
    def beats_out(self) -> int:
        """Output beats of an image."""
        return self.spec.out_height * self.spec.out_width * self.output.beats_per_pixel

    async def prepare(self) -> None:
        """Load the layer and set its shape."""
        await self.driver.load(self.packed)
        await self.driver.configure(self.spec)

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

    async def stop(self) -> None:
        """Take everything off the streams, reset softly, and see the array idle without an error."""
        self.transport.quiet()
        await self.driver.soft_reset()
        assert await self.read("ERROR") == Error.NONE, "a soft reset left an error"
        assert not await self.read("STATUS") & Status.BUSY, "a soft reset left the array busy"

    async def works(self) -> None:
        """A whole image: exact codes, cycles of the closed form, every beat taken once and none too many."""
        before = self.transport.moved
        result = await self.driver.run(self.layer.input)
        self.compare(result.codes)
        taken = self.transport.moved[0] - before[0]
        assert taken == len(self.beats), f"{taken} input beats were taken, not {len(self.beats)}"
        counters = result.counters
        parts = sum(value for name, value in counters.items() if name != "cycles")
        assert counters["cycles"] == parts, f"{counters} do not add up"
        if (
            self.case.image_gaps == self.case.stalls == "none"
            and (closed := estimate(self.spec, self.array)).exact
        ):
            parts_of = (closed.fill, closed.mac, closed.stall, closed.drain)
            stalls = counters["input_stalls"] + counters["output_stalls"]
            measured = (counters["fill_cycles"], counters["mac_cycles"], stalls, counters["drain_cycles"])
            assert measured == parts_of, f"fill, steps, stalls, drain took {measured} cycles, not {parts_of}"
        self._counters.append(counters)
        await self.silence()

    def compare(self, codes: NDArray[np.int64]) -> None:
        """Equality with the golden model, every code."""
        wrong = np.argwhere(codes != self.expected)
        assert not len(wrong), (
            f"{len(wrong)} of {codes.size} codes differ, first [channel, row, column] {wrong[0].tolist()}: "
            f"{codes[tuple(wrong[0])]}, not {self.expected[tuple(wrong[0])]}"
        )
        self._codes.append(codes)

    async def receive_codes(self) -> None:
        """Take an image's output beats and compare."""
        beats = await self.transport.receive(self.beats_out)
        self.compare(self.output.unpack(beats, self.spec.out_height, self.spec.out_width))

    async def stream(self, lasts: Collection[int] | None = None) -> None:
        """Send the image and take its codes, without the driver."""
        await gather(self.transport.send_image(self.beats, lasts), self.receive_codes())

    async def silence(self) -> None:
        """No beat may come out and none be taken between images."""
        edge = RisingEdge(self.dut.aclk)
        self.dut.m_axis_tready.value = 1
        for _ in range(QUIET):
            await edge
            assert not self.dut.m_axis_tvalid.value, "a beat was invented after the image"
            assert not self.dut.s_axis_tready.value, "the image stream is open after the image"
            assert not self.dut.s_axis_param_tready.value, "the parameter stream is open without a load"
        self.dut.m_axis_tready.value = 0

    def observation(self) -> dict[str, Any]:
        """What the case met, in plain values: the fields of `macram_sim.coverage.Observation`."""
        spec, layer = self.spec, self.layer
        sums = conv2d(layer.input, layer.weights, stride=spec.stride, padding=spec.padding)
        lo, hi = accumulator_range(spec.weight, spec.input, spec.fan_in)
        codes = np.concatenate([codes.ravel() for codes in self._codes])
        return {
            "index": self.case.index,
            "scenario": self.case.scenario,
            "layer": [spec.c_in, spec.c_out, spec.height, spec.width, spec.kernel, spec.stride],
            "kind": self.case.kind,
            "patterns": [self.case.image_gaps, self.case.param_gaps, self.case.stalls],
            "scales": sorted({int(np.sign(value)) for value in layer.scale}),
            "codes": [int(codes.min()), int(codes.max())],
            "sums_at_limit": [bool((sums == lo).any()), bool((sums == hi).any())],
            "counters": self._counters,
            "events": sorted(self.events),
        }
