"""The array's driver: registers, parameter loading and image runs over any transport.

The same class talks to the simulated array and to one on a board; `macram.pynq_transport` leads to the
latter.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Awaitable, Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from macram.golden import ResidualRule
from macram.pack import PackedLayer
from macram.spec import (
    BOTTOM,
    BY_NAME,
    RESIDUAL,
    TOP,
    ArrayConfig,
    Control,
    ConvSpec,
    Error,
    Place,
    Status,
    StreamLayout,
    SumLayout,
    fit_together,
)
from macram.spec.identity import identity
from macram.spec.registers import mode_word
from macram.transport import ArrayError, Beats, BusError, StreamTimeout, Transport

__all__ = [
    "BOTTOM",
    "COUNTERS",
    "TOP",
    "ArrayDriver",
    "ArrayError",
    "Beats",
    "BusError",
    "Place",
    "RunResult",
    "StreamTimeout",
    "Transport",
]

COUNTERS = ("cycles", "mac_cycles", "fill_cycles", "input_stalls", "output_stalls", "drain_cycles")
"""Lower-case names of the cycle counters; the later ones add up to the first."""
IDLE_POLLS = 10_000
"""Reads of STATUS after the last beat of a stream before an array that stays busy is given up."""


@dataclass(frozen=True)
class RunResult:
    """One image through the array.

    Attributes:
        codes: output codes, int64 ``[c_out, out_height, out_width]``; partial sums if the run was set to give them.
        counters: cycle counters by the names of `COUNTERS`.
        sums: the residual stream with this layer's branch added, int64 of the same shape; None without it.
    """

    codes: NDArray[np.int64]
    counters: dict[str, int]
    sums: NDArray[np.int64] | None = None


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
        self._rule: ResidualRule | None = None
        self._sums_in = self._sums_out = False

    async def identify(self) -> None:
        """Check that the array is there and was built with this driver's geometry.

        Raises:
            ArrayError: naming the first register that differs, its value and the value expected.
        """
        for name, wanted in identity(self._array).items():
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
        for beats in (weights, requant):
            self._transport.check_params(beats)
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

    async def configure(
        self,
        spec: ConvSpec,
        rule: ResidualRule | None = None,
        *,
        place: Place = BOTTOM,
        sums_in: bool = False,
        sums_out: bool = False,
    ) -> None:
        """Set the layer to run.

        Args:
            spec: its shape.
            rule: of the residual sum behind it.
            place: where it was loaded.
            sums_in: it starts from partial sums. A load is not possible while it runs.
            sums_out: it gives partial sums instead of codes; not with a residual sum.

        Raises:
            ValueError: the array does not admit the layer, has no residual adder or no partial sums; nothing is
                written.
        """
        self._array.check_admits(spec)
        if rule is not None and not self._array.residual_stream_bits:
            raise ValueError(
                f"array {self._array.name!r} has no residual adder; build one with residual_stream_bits"
            )
        if rule is not None and rule.branch != spec.output:
            raise ValueError(f"the residual rule takes {rule.branch} codes, the layer gives {spec.output}")
        if (sums_in or sums_out) and not self._array.partial_sum_c_in:
            raise ValueError(
                f"array {self._array.name!r} has no partial sums; build one with partial_sum_c_in"
            )
        if rule is not None and sums_out:
            raise ValueError("a residual sum needs codes; give the rule to the last block of input channels")
        weight_base, requant_base = place.bases(spec, self._array)
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
                    sums_in=sums_in,
                    sums_out=sums_out,
                ),
            ),
            ("WEIGHT_BASE", weight_base),
            ("REQUANT_BASE", requant_base),
            *(rule.registers() if rule is not None else ()),
        ):
            await self._write(name, value)
        self._spec, self._rule = spec, rule
        self._sums_in, self._sums_out = sums_in, sums_out

    async def run(
        self,
        input_codes: NDArray[np.integer],
        residual: NDArray[np.integer] | None = None,
        *,
        sums: NDArray[np.integer] | None = None,
        meanwhile: Callable[[], Awaitable[None]] | None = None,
    ) -> RunResult:
        """Run one image ``[c_in, height, width]`` through the configured layer.

        Args:
            input_codes: the image.
            residual: the stream to add to, `RESIDUAL` codes ``[c_out, out_height, out_width]``; goes with a rule.
            sums: partial sums to start from, of that shape; goes with ``sums_in`` of `configure`.
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
        if (sums is not None) != self._sums_in:
            raise ValueError("partial sums and configure(sums_in=True) go together; give both or none")
        layout = SumLayout(spec, array)
        addends = None if sums is None else layout.pack(sums)
        output = StreamLayout(spec.c_out, array.output, array.stream_bits)
        beats_out = (
            layout.beats if self._sums_out else spec.out_height * spec.out_width * output.beats_per_pixel
        )
        try:
            await self._transport.begin_stream(beats, beats_out, stream, addends)
            try:
                await self._write("CONTROL", Control.START)
                if meanwhile is not None:
                    await meanwhile()
            finally:
                received, *summed = await self._transport.end_stream()
        except StreamTimeout:
            await self._raise_error()
            raise
        await self._wait(Status.BUSY)
        counters = {name: await self._read(name.upper()) for name in COUNTERS}
        size = spec.out_height, spec.out_width
        return RunResult(
            layout.unpack(received) if self._sums_out else output.unpack(received, *size),
            counters,
            None if wide is None else wide.unpack(summed[0], *size),
        )

    async def run_sequence(
        self,
        layers: Sequence[PackedLayer],
        next_image: Callable[[list[RunResult]], NDArray[np.integer]],
    ) -> list[RunResult]:
        """Load and run layers one after the other, each loaded while the one before it runs if both fit.

        A pass that starts from partial sums takes those of the pass before it; nothing can be loaded beside it.

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
            await self.configure(packed.spec, place=place, sums_in=packed.sums_in, sums_out=packed.sums_out)
            following = layers[index + 1] if index + 1 < len(layers) else None
            loaded = (
                following is not None
                and not packed.sums_in
                and fit_together(packed.spec, following.spec, self._array)
            )
            load_next = partial(self.load, following, place=other) if following and loaded else None
            sums = results[-1].codes if packed.sums_in else None
            results.append(await self.run(next_image(results), sums=sums, meanwhile=load_next))
        return results

    async def run_passes(self, passes: Sequence[PackedLayer], input_codes: NDArray[np.integer]) -> RunResult:
        """One layer in passes (`macram.pack.pack_passes`), the image sent each time, or the pass's block of it.

        Returns:
            Codes of all channels, counters added up.
        """
        ends = list(itertools.accumulate(packed.spec.c_in for packed in passes))

        def next_image(before: list[RunResult]) -> NDArray[np.integer]:
            channels = passes[len(before)].spec.c_in
            first = (ends[len(before)] - channels) % len(input_codes)
            return input_codes[first : first + channels]

        results = await self.run_sequence(passes, next_image)
        return RunResult(
            np.concatenate(
                [result.codes for result, packed in zip(results, passes, strict=True) if not packed.sums_out]
            ),
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
