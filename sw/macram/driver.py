"""The array's driver: registers, parameter loading and image runs over any transport.

The same class talks to the simulated array and to one on a board; `macram.pynq_transport` leads to the
latter.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Awaitable, Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from macram.pack import PackedLayer
from macram.spec import BY_NAME, ArrayConfig, Control, ConvSpec, Error, IntFormat, Status, StreamLayout
from macram.spec.registers import ID_VALUE, VERSION_VALUE, mode_word

Beats = NDArray[np.uint8]
"""``[beats, stream_bits // 8]`` bytes, low byte first."""

COUNTERS = ("cycles", "mac_cycles", "fill_cycles", "input_stalls", "output_stalls", "drain_cycles")
"""Lower-case names of the cycle counters; the later ones add up to the first."""
IDLE_POLLS = 10_000
"""Reads of STATUS after the last beat of a stream before an array that stays busy is given up."""


class ArrayError(RuntimeError):
    """The array reports an error, or is not the one that was expected.

    Attributes:
        code: the ERROR register; `Error.NONE` where the array itself reports nothing.
    """

    def __init__(self, message: str, code: Error = Error.NONE) -> None:
        super().__init__(message)
        self.code = code


class BusError(ArrayError):
    """A register access was answered with an error."""


class StreamTimeout(ArrayError):
    """A stream stopped moving before its last beat."""


@dataclass(frozen=True)
class Place:
    """An end of the weight and requantiser memories. Layers at opposite ends are apart if both fit at all.

    Attributes:
        at_top: the layer's last word is the memory's last; else its first word is the first.
    """

    at_top: bool

    def bases(self, spec: ConvSpec, array: ArrayConfig) -> tuple[int, int]:
        """Addresses of the layer's first weight word and first requantiser word."""
        if not self.at_top:
            return 0, 0
        return array.weight_depth - array.weight_words(spec), array.requant_depth - array.requant_words(spec)


BOTTOM, TOP = Place(at_top=False), Place(at_top=True)


def fit_together(one: ConvSpec, other: ConvSpec, array: ArrayConfig) -> bool:
    """Whether two layers can be in the memories at the same time."""
    weights = array.weight_words(one) + array.weight_words(other)
    requant = array.requant_words(one) + array.requant_words(other)
    return weights <= array.weight_depth and requant <= array.requant_depth


class Transport(Protocol):
    """What the driver needs of the world outside. Offsets are bytes, register values 32 bits unsigned."""

    async def read(self, offset: int) -> int:
        """Read a register; `BusError` if it is refused."""

    async def write(self, offset: int, value: int) -> None:
        """Write a register; `BusError` if it is refused."""

    async def send_params(self, beats: Beats) -> None:
        """Send beats on the parameter stream, TLAST on the last; `StreamTimeout` if they are not taken."""

    async def run_stream(self, beats: Beats, beats_out: int) -> Beats:
        """Send an image, TLAST on its last beat, and return the ``beats_out`` beats that come back meanwhile.

        Raises:
            StreamTimeout: neither stream moves any more.
        """

    async def begin_stream(self, beats: Beats, beats_out: int) -> None:
        """The first half of `run_stream`: the image is on its way, registers and parameter stream are free."""

    async def end_stream(self) -> Beats:
        """The second half: wait for the image that was begun, and return its beats.

        Raises:
            StreamTimeout: as `run_stream`.
        """


@dataclass(frozen=True)
class RunResult:
    """One image through the array.

    Attributes:
        codes: output codes, int64 ``[c_out, out_height, out_width]``.
        counters: cycle counters by the names of `COUNTERS`.
    """

    codes: NDArray[np.int64]
    counters: dict[str, int]


class ArrayDriver:
    """Commands one array: `identify`, `load` (unless the memories are preloaded), `configure`, then `run`.

    `run_sequence` does the last three for many layers, each loaded while the one before it runs.

    Args:
        transport: the way to the registers and streams.
        array: the array that is expected there.
    """

    def __init__(self, transport: Transport, array: ArrayConfig) -> None:
        self._transport = transport
        self._array = array
        self._spec: ConvSpec | None = None

    async def identify(self) -> None:
        """Check that the array is there and was built with this driver's geometry.

        Raises:
            ArrayError: naming the first register that differs, its value and the value expected.
        """
        for name, wanted in _identity(self._array).items():
            value = await self._read(name)
            if value != wanted:
                raise ArrayError(
                    f"{name} is {value:#010x}, array {self._array.name!r} has {wanted:#010x} "
                    f"({BY_NAME[name].description}); use the configuration the array was built with"
                )

    async def soft_reset(self) -> None:
        """Stop whatever runs, forget any error and empty the data path; registers and memories stay."""
        await self._write("CONTROL", Control.SOFT_RESET)
        await self._wait(Status.BUSY | Status.LOADING)

    async def load(self, packed: PackedLayer, *, place: Place = BOTTOM) -> None:
        """Write a layer's weights and requantiser through the parameter stream, also while an image runs.

        Args:
            packed: the layer.
            place: the end of the memories it goes to; not where the running layer is.

        Raises:
            ValueError: ``packed`` was made for another array.
            ArrayError: the array reports an error.
        """
        if dataclasses.replace(packed.array, name=self._array.name) != self._array:
            raise ValueError(
                f"the layer is packed for array {packed.array.name!r}, this one is {self._array.name!r}; "
                "pack it for this array"
            )
        weights, requant = packed.load_beats()
        weight_base, requant_base = place.bases(packed.spec, self._array)
        for command, base, words, beats in (
            (Control.LOAD_WEIGHTS, weight_base, packed.weight_words, weights),
            (Control.LOAD_REQUANT, requant_base, packed.requant_words, requant),
        ):
            await self._write("PARAM_BASE", base)
            await self._write("PARAM_WORDS", words)
            await self._write("CONTROL", command)
            try:
                await self._transport.send_params(beats)
            except StreamTimeout:
                await self._raise_error()
                raise
            await self._wait(Status.LOADING)

    async def configure(self, spec: ConvSpec, *, place: Place = BOTTOM) -> None:
        """Set the shape of the layer to run, and where it was loaded.

        Raises:
            ValueError: the array does not admit the layer; nothing is written.
        """
        self._array.check_admits(spec)
        weight_base, requant_base = place.bases(spec, self._array)
        for name, value in (
            ("HEIGHT", spec.height),
            ("WIDTH", spec.width),
            ("C_IN", spec.c_in),
            ("C_OUT", spec.c_out),
            (
                "MODE",
                mode_word(spec.kernel, spec.stride, spec.padding, biased=self._array.biased(spec)),
            ),
            ("WEIGHT_BASE", weight_base),
            ("REQUANT_BASE", requant_base),
        ):
            await self._write(name, value)
        self._spec = spec

    async def run(
        self, input_codes: NDArray[np.integer], meanwhile: Callable[[], Awaitable[None]] | None = None
    ) -> RunResult:
        """Run one image ``[c_in, height, width]`` through the configured layer.

        Args:
            input_codes: the image.
            meanwhile: called once the image is on its way, such as a `load` of the next layer.

        Raises:
            ValueError: `configure` was not called, or the image has another shape or codes out of range.
            ArrayError: the array reports an error; the message has its name.
        """
        spec, array = self._spec, self._array
        if spec is None:
            raise ValueError("no layer is set; call configure() before run()")
        if input_codes.shape != (spec.c_in, spec.height, spec.width):
            raise ValueError(
                f"the image must be [{spec.c_in}, {spec.height}, {spec.width}], not {list(input_codes.shape)}"
            )
        beats = StreamLayout(spec.c_in, spec.input, array.stream_bits).pack(input_codes)
        output = StreamLayout(spec.c_out, array.output, array.stream_bits)
        beats_out = spec.out_height * spec.out_width * output.beats_per_pixel
        await self._write("CONTROL", Control.START)
        try:
            if meanwhile is None:
                received = await self._transport.run_stream(beats, beats_out)
            else:
                await self._transport.begin_stream(beats, beats_out)
                try:
                    await meanwhile()
                finally:
                    received = await self._transport.end_stream()
        except StreamTimeout:
            await self._raise_error()
            raise
        await self._wait(Status.BUSY)
        counters = {name: await self._read(name.upper()) for name in COUNTERS}
        return RunResult(output.unpack(received, spec.out_height, spec.out_width), counters)

    async def run_sequence(
        self,
        layers: Sequence[PackedLayer],
        next_image: Callable[[list[RunResult]], NDArray[np.integer]],
    ) -> list[RunResult]:
        """Load and run layers one after the other, each loaded while the one before it runs if both fit.

        Args:
            layers: in order.
            next_image: the image of the next layer, given the results so far.

        Raises:
            ValueError: as `load`, `configure` and `run`.
            ArrayError: likewise.
        """
        results: list[RunResult] = []
        loaded = False
        for index, packed in enumerate(layers):
            place, other = (BOTTOM, TOP) if index % 2 == 0 else (TOP, BOTTOM)
            if not loaded:
                await self.load(packed, place=place)
            await self.configure(packed.spec, place=place)
            following = layers[index + 1] if index + 1 < len(layers) else None
            loaded = following is not None and fit_together(packed.spec, following.spec, self._array)
            load_next = partial(self.load, following, place=other) if following and loaded else None
            results.append(await self.run(next_image(results), load_next))
        return results

    async def run_passes(self, passes: Sequence[PackedLayer], input_codes: NDArray[np.integer]) -> RunResult:
        """One layer in passes over its output channels (`macram.pack.pack_passes`), the image sent each time.

        Returns:
            Codes of all channels, counters added up.
        """
        results = await self.run_sequence(passes, lambda _: input_codes)
        return RunResult(
            np.concatenate([result.codes for result in results]),
            {name: sum(result.counters[name] for result in results) for name in COUNTERS},
        )

    async def _read(self, name: str) -> int:
        return await self._transport.read(BY_NAME[name].offset)

    async def _write(self, name: str, value: int) -> None:
        await self._transport.write(BY_NAME[name].offset, int(value))

    async def _wait(self, until_clear: Status) -> None:
        for _ in range(IDLE_POLLS):
            status = Status(await self._read("STATUS"))
            if Status.ERROR in status:
                await self._raise_error()
            if not status & until_clear:
                return
        raise ArrayError(f"the array is still busy after {IDLE_POLLS} reads of STATUS; reset it")

    async def _raise_error(self) -> None:
        """Raise if ERROR holds a code."""
        value = await self._read("ERROR")
        if value == Error.NONE:
            return
        try:
            code = Error(value)
        except ValueError:
            raise ArrayError(f"the array reports the unknown error code {value}") from None
        raise ArrayError(f"the array reports {code.name} (ERROR = {value})", code)


def _identity(array: ArrayConfig) -> dict[str, int]:
    """Values of the read-only registers that describe ``array``, laid out as in `macram.spec.registers`."""

    def form(value: IntFormat) -> int:
        return value.bits | value.signed << 7

    return {
        "ID": ID_VALUE,
        "VERSION": VERSION_VALUE,
        "GEOMETRY": array.units | array.rows << 16 | array.drain << 24,
        "FORMATS": array.weight.bits | form(array.input) << 8 | form(array.output) << 16,
        "WEIGHT_DEPTH": array.weight_depth,
        "ROW_WORDS": array.row_words,
        "MAX_CHANNELS": array.max_c_in | array.max_c_out << 16,
    }
