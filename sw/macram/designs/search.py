"""Which array is the fastest that fits a device: every mix of units and engines, its cycles, and what stops it."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from macram.designs.lut_model import LutModel
from macram.perf import estimate_passes
from macram.report.latency import REFERENCE
from macram.spec import ArrayConfig, ConvSpec, ceil_div, layer_passes
from macram.synth.devices import Device
from macram.synth.memories import block_memories, block_ram, dsp_slices

UNITS = (16, 32, 64, 128, 256)
SOFT_ROWS = range(9)
DEPTHS = (1024, 512, 2048, 4096)
"""Weight words per unit, in the order in which they are tried."""
ROW_WORDS = (256, 512, 1024, 2048)
SPACE = (
    f"{UNITS[0]} to {UNITS[-1]} units, powers of two; row engines in DSP slices at one clock or in pairs at two, as "
    f"many slices as the device has; 0 to {SOFT_ROWS[-1]} row engines in LUTs beside them; the smallest line buffer "
    "that runs every layer; weight memories of 1,024 words where they suffice and fit, else of 512 or more; the "
    "requantiser's words in block RAM where they fit, else in LUTs; streams, line-buffer banks and drain as in zu3eg"
)
"""What `mixes` and `_sized` goes through, in words."""


@dataclass(frozen=True)
class Candidate:
    """One array of the search.

    Attributes:
        array: the configuration.
        reference: cycles of the reference layer.
        network: cycles of all layers.
        loads: cycles in which the array waits for words of the next pass: all of a load where two passes' words do
            not lie in the memories at a time, else what is longer than the run beside it.
        used: ``lut`` (estimate), ``dsp`` and ``bram``.
        stopped_by: a phrase for each resource of which it takes too much; empty if it fits.
    """

    array: ArrayConfig
    reference: int
    network: int
    loads: int
    used: dict[str, float]
    stopped_by: tuple[str, ...]

    @property
    def mix(self) -> str:
        """Units and engines in words; ``2x`` for slices at twice the clock."""
        array = self.array
        slices = dsp_slices(array) // array.units
        parts = [f"{slices} DSP{' 2x' if array.paired_rows else ''}"] if slices else []
        parts += [f"{array.row_kinds.count('soft')} soft"] if "soft" in array.row_kinds else []
        return f"{array.units} x ({' + '.join(parts)})"

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON."""
        return {
            "array": self.array.to_dict(), "mix": self.mix, "row_engines": self.array.units * self.array.rows,
            "reference_cycles": self.reference, "network_cycles": self.network, "load_cycles": self.loads,
            "used": self.used, "stopped_by": list(self.stopped_by),
        }  # fmt: skip

    @property
    def total(self) -> int:
        """Cycles of the network with its loads, by which candidates are ranked."""
        return self.network + self.loads


def search(
    base: ArrayConfig,
    device: Device,
    runs: Sequence[Mapping[str, Any]],
    model: LutModel,
    *,
    track: Callable[[Sequence[ArrayConfig]], Iterable[ArrayConfig]] = iter,
) -> list[Candidate]:
    """Every array of the space that runs all layers, the fastest on the network first.

    Args:
        base: gives formats, streams, drain and channel limits.
        device: its limits are those of ``macram synth``.
        runs: convolutions of a network, as for `macram.designs.describe`.
        model: estimates LUTs.
        track: goes through the arrays; the command line shows a bar.
    """
    layers = [layer_shape(run, base) for run in runs]
    reference = _reference(base)
    sized = (_sized(mix, device, [*dict.fromkeys(layers), reference]) for mix in track(mixes(base, device)))
    found = [candidate(array, device, layers, model) for array in sized if array is not None]
    return sorted(found, key=lambda one: (one.total, one.reference, one.used["lut"]))


def candidate(array: ArrayConfig, device: Device, layers: Sequence[ConvSpec], model: LutModel) -> Candidate:
    """The figures of one array that runs every one of ``layers``, which come in the network's order."""
    passes = {layer: _passes(layer, array) for layer in dict.fromkeys(layers)}
    sequence = [part for layer in layers for part in passes[layer]]
    used = {
        "lut": float(round(model.luts(array))),
        "dsp": float(dsp_slices(array) + model.shell_dsp),
        "bram": block_ram(block_memories(array)),
    }
    return Candidate(
        array,
        sum(part.cycles for part in _passes(_reference(array), array)),
        sum(part.cycles for part in sequence),
        _waits(sequence, array),
        used,
        tuple(device.excess(used | {"ff": 0.0})),
    )


def mixes(base: ArrayConfig, device: Device) -> list[ArrayConfig]:
    """Units and row engines of the space, memories still those of ``base``."""
    found = []
    for units in UNITS:
        for engine, rows_per_slice in (("dsp48e2", 1), ("dsp48e2_2x", 2)):
            for slices in range(1, device.limit("dsp") // units + 1):
                for soft in SOFT_ROWS:
                    rows = slices * rows_per_slice + soft
                    found.append((units, engine, rows, soft))
        found += [(units, "soft", rows, 0) for rows in SOFT_ROWS if rows]
    return [
        dataclasses.replace(
            base, name="candidate", units=units, engine=engine, rows=rows, soft_rows=soft,
            max_c_out=ceil_div(base.max_c_out, units) * units,
        )
        for units, engine, rows, soft in found
        if rows <= 64
    ]  # fmt: skip


def _sized(mix: ArrayConfig, device: Device, layers: Sequence[ConvSpec]) -> ArrayConfig | None:
    """``mix`` with memories that run every layer and, if there are such, fit the device; None if nothing does."""
    runs = None
    for depth in DEPTHS:
        for words in ROW_WORDS:
            array = dataclasses.replace(mix, weight_depth=depth, row_words=words, requant_ram="block")
            if not _runs_all(array, layers):
                continue
            for ram in ("block", "distributed"):
                array = dataclasses.replace(array, requant_ram=ram)
                if block_ram(block_memories(array)) <= device.limit("bram"):
                    return array
            runs = runs or array
            break
    return runs


def _runs_all(array: ArrayConfig, layers: Sequence[ConvSpec]) -> bool:
    try:
        for layer in layers:
            layer_passes(layer, array)
    except ValueError:
        return False
    return True


class _Pass(NamedTuple):
    cycles: int
    weights: int
    requant: int


def _passes(layer: ConvSpec, array: ArrayConfig) -> list[_Pass]:
    """Cycles and words of every pass of a layer."""
    runs = zip(layer_passes(layer, array), estimate_passes(layer, array), strict=True)
    return [_Pass(run.total, array.weight_words(p.layer), array.requant_words(p.layer)) for p, run in runs]


def _waits(sequence: Sequence[_Pass], array: ArrayConfig) -> int:
    """Cycles for which the array stands still in a sequence of passes because the next one's words are on the way."""
    weight_beats = array.units * ceil_div(array.weight_word_bits, array.stream_bits)
    requant_beats = ceil_div(array.requant_word_bits, array.stream_bits)
    waits, before = 0, None
    for part in sequence:
        load = part.weights * weight_beats + part.requant * requant_beats
        beside = before is not None and (
            before.weights + part.weights <= array.weight_depth
            and before.requant + part.requant <= array.requant_depth
        )
        waits += max(0, load - before.cycles) if before is not None and beside else load
        before = part
    return waits


def _reference(array: ArrayConfig) -> ConvSpec:
    return dataclasses.replace(REFERENCE, weight=array.weight, input=array.input, output=array.output)


def layer_shape(run: Mapping[str, Any], base: ArrayConfig) -> ConvSpec:
    """A convolution of a network in the formats of ``base``."""
    kernel = run["kernel"]
    return ConvSpec(
        run["c_in"], run["c_out"], run["height"], run["width"], kernel=kernel, stride=run["stride"],
        padding=kernel // 2, weight=base.weight, input=base.input, output=base.output,
    )  # fmt: skip
