"""The array's driver: registers, parameter loading and image runs over any transport.

The same class talks to the simulated array and to one on a board; `macram.pynq_transport` leads to the
latter.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from macram.golden import ResidualRule
from macram.pack import PackedLayer
from macram.spec import (
    BY_NAME,
    RESIDUAL,
    ArrayConfig,
    Control,
    ConvSpec,
    Error,
    IntFormat,
    Status,
    StreamLayout,
)
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


class Transport(Protocol):
    """What the driver needs of the world outside. Offsets are bytes, register values 32 bits unsigned."""

    async def read(self, offset: int) -> int:
        """Read a register; `BusError` if it is refused."""

    async def write(self, offset: int, value: int) -> None:
        """Write a register; `BusError` if it is refused."""

    async def send_params(self, beats: Beats) -> None:
        """Send beats on the parameter stream, TLAST on the last; `StreamTimeout` if they are not taken."""

    async def run_stream(self, beats: Beats, beats_out: int, residual: Beats | None = None) -> list[Beats]:
        """Send an image, TLAST on its last beat, and return the ``beats_out`` beats that come back meanwhile.

        With ``residual``, those beats go to the residual adder, and as many come back from it, second in the list.

        Raises:
            StreamTimeout: no stream moves any more.
        """


@dataclass(frozen=True)
class RunResult:
    """One image through the array.

    Attributes:
        codes: output codes, int64 ``[c_out, out_height, out_width]``.
        counters: cycle counters by the names of `COUNTERS`.
        sums: the residual stream with this layer's branch added, int64 of the same shape; None without it.
    """

    codes: NDArray[np.int64]
    counters: dict[str, int]
    sums: NDArray[np.int64] | None = None


class ArrayDriver:
    """Commands one array: `identify`, `load` (unless the memories are preloaded), `configure`, then `run`.

    Args:
        transport: the way to the registers and streams.
        array: the array that is expected there.
    """

    def __init__(self, transport: Transport, array: ArrayConfig) -> None:
        self._transport = transport
        self._array = array
        self._spec: ConvSpec | None = None
        self._rule: ResidualRule | None = None

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
        await self._wait_idle()

    async def load(self, packed: PackedLayer) -> None:
        """Write a layer's weights and requantiser through the parameter stream.

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
        for command, words, beats in (
            (Control.LOAD_WEIGHTS, packed.weight_words, weights),
            (Control.LOAD_REQUANT, packed.requant_words, requant),
        ):
            await self._write("PARAM_WORDS", words)
            await self._write("CONTROL", command)
            try:
                await self._transport.send_params(beats)
            except StreamTimeout:
                await self._raise_error()
                raise
            await self._wait_idle()

    async def configure(self, spec: ConvSpec, rule: ResidualRule | None = None) -> None:
        """Set the shape of the layer to run, and the rule of the residual sum behind it if there is one.

        Raises:
            ValueError: the array does not admit the layer or has no residual adder; nothing is written.
        """
        self._array.check_admits(spec)
        if rule is not None and not self._array.residual_stream_bits:
            raise ValueError(
                f"array {self._array.name!r} has no residual adder; build one with residual_stream_bits"
            )
        if rule is not None and rule.branch != spec.output:
            raise ValueError(f"the residual rule takes {rule.branch} codes, the layer gives {spec.output}")
        for name, value in (
            ("HEIGHT", spec.height),
            ("WIDTH", spec.width),
            ("C_IN", spec.c_in),
            ("C_OUT", spec.c_out),
            (
                "MODE",
                mode_word(
                    spec.kernel,
                    spec.stride,
                    spec.padding,
                    biased=self._array.biased(spec),
                    residual=rule is not None,
                ),
            ),
            *(rule.registers() if rule is not None else ()),
        ):
            await self._write(name, value)
        self._spec, self._rule = spec, rule

    async def run(
        self, input_codes: NDArray[np.integer], residual: NDArray[np.integer] | None = None
    ) -> RunResult:
        """Run one image ``[c_in, height, width]`` through the configured layer.

        Args:
            input_codes: the image.
            residual: the stream to add to, `RESIDUAL` codes ``[c_out, out_height, out_width]``; goes with a rule.

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
        if (residual is None) != (self._rule is None):
            raise ValueError("a residual stream and a residual rule go together; give both or none")
        wide = None
        if residual is not None:
            # As many beats come back as go in: both streams are 8-bit codes of the output's shape.
            shape = (spec.c_out, spec.out_height, spec.out_width)
            if residual.shape != shape:
                raise ValueError(f"the residual stream must be {list(shape)}, not {list(residual.shape)}")
            wide = StreamLayout(spec.c_out, RESIDUAL, array.residual_stream_bits)
        stream = wide.pack(residual) if wide is not None and residual is not None else None
        output = StreamLayout(spec.c_out, array.output, array.stream_bits)
        beats_out = spec.out_height * spec.out_width * output.beats_per_pixel
        await self._write("CONTROL", Control.START)
        try:
            received, *sums = await self._transport.run_stream(beats, beats_out, stream)
        except StreamTimeout:
            await self._raise_error()
            raise
        await self._wait_idle()
        counters = {name: await self._read(name.upper()) for name in COUNTERS}
        size = spec.out_height, spec.out_width
        return RunResult(
            output.unpack(received, *size), counters, None if wide is None else wide.unpack(sums[0], *size)
        )

    async def _read(self, name: str) -> int:
        return await self._transport.read(BY_NAME[name].offset)

    async def _write(self, name: str, value: int) -> None:
        await self._transport.write(BY_NAME[name].offset, int(value))

    async def _wait_idle(self) -> None:
        for _ in range(IDLE_POLLS):
            status = Status(await self._read("STATUS"))
            if Status.ERROR in status:
                await self._raise_error()
            if Status.BUSY not in status:
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
        "RESIDUAL": array.residual_stream_bits,
    }
