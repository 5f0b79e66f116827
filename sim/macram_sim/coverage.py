"""Functional coverage of the array: the reviewed list of what a regression must have met.

Each bin names one thing that can be met and the reason why meeting it matters. A bin counts only where an array of the
run admits it, so bins of layer kinds that the array does not run yet switch on by themselves.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from macram.spec import GROUP, TAPS, ArrayConfig, ConvSpec, ceil_div
from macram_sim.regression_plan import admits, fullest
from macram_sim.streams import PATTERNS


@dataclass(frozen=True, slots=True)
class Observation:
    """What one case met on ``array``, measured by the bench. ``counters``: one table per whole image."""

    array: ArrayConfig
    spec: ConvSpec
    scenario: str
    kind: str
    patterns: tuple[str, str, str]
    scales: frozenset[int]
    codes: tuple[int, int]
    sums_at_limit: tuple[bool, bool]
    counters: tuple[dict[str, int], ...]
    events: frozenset[str]

    @classmethod
    def from_dict(cls, array: ArrayConfig, table: dict[str, Any]) -> Observation:
        """From a line of ``seen.jsonl``."""
        c_in, c_out, height, width, kernel, stride = table["layer"]
        spec = ConvSpec(
            c_in, c_out, height, width, kernel, stride, kernel // 2,
            weight=array.weight, input=array.input, output=array.output,
        )  # fmt: skip
        first, second, third = table["patterns"]
        low, high = table["sums_at_limit"]
        smallest, largest = table["codes"]
        return cls(
            array,
            spec,
            table["scenario"],
            table["kind"],
            (first, second, third),
            frozenset(table["scales"]),
            (smallest, largest),
            (low, high),
            tuple(table["counters"]),
            frozenset(table["events"]),
        )

    @property
    def blocks(self) -> int:
        """Channel blocks of the layer."""
        return self.array.blocks(self.spec.c_in)

    @property
    def tiles(self) -> int:
        """Output-channel tiles of the layer."""
        return self.array.tiles(self.spec.c_out)


def _always(array: ArrayConfig) -> bool:
    return True


@dataclass(frozen=True, slots=True)
class Bin:
    """One thing to be met; ``possible`` says on which arrays it can be."""

    name: str
    reason: str
    hit: Callable[[Observation], bool]
    possible: Callable[[ArrayConfig], bool] = _always


def _beat_bits(seen: Observation) -> int:
    return seen.spec.c_in * seen.array.input.bits


def _counted(seen: Observation, name: str) -> bool:
    return any(counters[name] > 0 for counters in seen.counters)


def _in_triples(seen: Observation) -> bool:
    return seen.array.triples(seen.spec) > 0


def _packs(array: ArrayConfig) -> bool:
    return array.max_tiles >= TAPS and array.blocks(array.max_c_in) >= array.pair_drain


def _shapes() -> Iterable[Bin]:
    for kernel, stride in ((3, 1), (3, 2), (1, 1)):
        yield Bin(
            f"kernel {kernel}x{kernel}, stride {stride}",
            "each walks the line buffer in its own order",
            lambda s, k=kernel, t=stride: (s.spec.kernel, s.spec.stride) == (k, t),  # type: ignore[misc]
            lambda a, k=kernel, t=stride: admits(a, k, t),  # type: ignore[misc]
        )
    for tail in range(GROUP):
        yield Bin(
            f"width mod 4 = {tail}",
            "the last group's mask; 0 sends the last column through the carry and the flush",
            lambda s, t=tail: s.spec.width % GROUP == t,  # type: ignore[misc]
        )
    yield from (
        Bin("width 1", "one pixel is both edges", lambda s: s.spec.width == 1),
        Bin("several groups in a row", "the carry goes from group to group", lambda s: s.spec.width > GROUP),
        Bin("height 1", "both neighbouring rows are padding; the start does not wait", lambda s: s.spec.height == 1),
        Bin("height 2", "every row has one row of padding", lambda s: s.spec.height == 2),
        Bin("height odd, above 2", "row slots do not come out even", lambda s: s.spec.height in range(3, 1000, 2)),
        Bin("height even, above 4", "every row slot is used again", lambda s: s.spec.height in range(6, 1000, 2)),
        Bin("one channel block", "first and last block coincide", lambda s: s.blocks == 1),
        Bin("several channel blocks", "sums run over blocks", lambda s: s.blocks > 1),
        Bin(
            "last block part-filled", "its missing channels must be 0",
            lambda s: s.spec.c_in % s.array.rows != 0, lambda a: a.rows > 1,
        ),
        Bin(
            "blocks do not fill the banks", "the last ingest word is padding in its upper bank",
            lambda s: s.blocks % s.array.ingest != 0, lambda a: a.ingest > 1,
        ),
        Bin("most input channels", "largest fan-in and longest sums", lambda s: s.spec.c_in == s.array.max_c_in),
        Bin("one tile", "no tile order to get wrong", lambda s: s.tiles == 1),
        Bin("several tiles", "carry and weights per tile", lambda s: s.tiles > 1, lambda a: a.max_tiles > 1),
        Bin("three tiles together", "two sums in the place of three", _in_triples, _packs),
        Bin(
            "tiles left over behind three", "sums of both kinds in one group",
            lambda s: _in_triples(s) and s.tiles % TAPS > 0, _packs,
        ),
        Bin(
            "three tiles in a last group that is part-filled", "its missing pixels are dropped",
            lambda s: _in_triples(s) and s.spec.out_width % GROUP > 0, _packs,
        ),
        Bin(
            "three tiles with a step to spare", "the carried lanes move between two steps",
            lambda s: _in_triples(s) and s.blocks >= s.array.pair_drain, _packs,
        ),
        Bin("last tile part-filled", "its missing channels are dropped", lambda s: s.spec.c_out % s.array.units != 0),
        Bin("last tile full", "every unit's result leaves", lambda s: s.spec.c_out % s.array.units == 0),
        Bin("most output channels", "the whole requantiser memory", lambda s: s.spec.c_out == s.array.max_c_out),
        Bin("one beat per input pixel", "every beat ends a pixel", lambda s: _beat_bits(s) <= s.array.stream_bits),
        Bin(
            "several beats per input pixel", "a pixel's words straddle beats",
            lambda s: _beat_bits(s) > s.array.stream_bits,
            lambda a: a.max_c_in * a.input.bits > a.stream_bits,
        ),
        Bin(
            "several beats per output pixel", "a beat is made of more than one word",
            lambda s: s.spec.c_out * s.array.output.bits > s.array.stream_bits,
            lambda a: a.max_c_out * a.output.bits > a.stream_bits,
        ),
        Bin(
            "sums end faster than the drain", "the sequencer must wait for the credit",
            lambda s: s.spec.kernel * s.blocks < s.array.drain_cycles,
            lambda a: a.drain_cycles > 3,
        ),
        Bin(
            "sums end slower than the drain", "the drain must wait for sums",
            lambda s: s.spec.kernel * s.blocks > s.array.drain_cycles,
        ),
        Bin(
            "as many weight words as fit", "the last addresses of the weight memory",
            lambda s: s.tiles * s.blocks == s.array.weight_depth // TAPS,
            lambda a: bool(fullest(a)),
        ),
        Bin(
            "longest row", "the last line-buffer word of a row slot",
            lambda s: s.array.groups(s.spec.width) * ceil_div(s.blocks, s.array.ingest) * s.array.ingest
            == s.array.row_words,
            lambda a: a.row_words <= 4 * ceil_div(a.blocks(a.max_c_in), a.ingest) * a.ingest,
        ),
    )  # fmt: skip


def _values() -> Iterable[Bin]:
    for kind, reason in (
        ("uniform", "ordinary codes"),
        ("extremes", "every product at a corner of its range"),
        ("min", "the accumulator's smallest sums"),
        ("max", "the accumulator's largest sums"),
        ("zero", "nothing may come from nothing"),
        ("impulse", "one product: its place in the output is its place in the kernel"),
    ):
        yield Bin(f"codes: {kind}", reason, lambda s, k=kind: s.kind == k)  # type: ignore[misc]
    for sign, name in ((1, "positive"), (0, "zero"), (-1, "negative")):
        yield Bin(
            f"a {name} scale", "negative scales invert the thresholds, zero ones make them constant",
            lambda s, v=sign: v in s.scales,  # type: ignore[misc]
        )  # fmt: skip
    yield from (
        Bin("lowest output code", "clipping below", lambda s: s.codes[0] == s.spec.output.lo),
        Bin("highest output code", "clipping above", lambda s: s.codes[1] == s.spec.output.hi),
        Bin("smallest sum of the layer", "the lower end of the accumulator", lambda s: s.sums_at_limit[0]),
        Bin("largest sum of the layer", "the upper end of the accumulator", lambda s: s.sums_at_limit[1]),
    )


def _traffic() -> Iterable[Bin]:
    for gaps in PATTERNS:
        for stalls in PATTERNS:
            yield Bin(
                f"input gaps {gaps}, output stalls {stalls}",
                "the two ends of the pipeline disturb each other",
                lambda s, g=gaps, t=stalls: (s.patterns[0], s.patterns[2]) == (g, t),  # type: ignore[misc]
            )
        yield Bin(
            f"parameter gaps {gaps}", "a load must not depend on the pace of its beats",
            lambda s, g=gaps: s.patterns[1] == g,  # type: ignore[misc]
        )  # fmt: skip
    for name, reason in (
        ("input_stalls", "the sequencer has waited for pixels"),
        ("output_stalls", "the sequencer has waited for the drain"),
        ("drain_cycles", "the pipeline has emptied"),
        ("fill_cycles", "the line buffer has filled"),
    ):
        yield Bin(f"{name.upper()} counted", reason, lambda s, n=name: _counted(s, n))  # type: ignore[misc]
    yield Bin(
        "no stall at all", "the undisturbed pace",
        lambda s: any(c["input_stalls"] == c["output_stalls"] == 0 for c in s.counters),
    )  # fmt: skip


_EVENTS = (
    ("one image", "the plain run"),
    ("another image, same weights", "no state of the first image is left"),
    ("other weights, same shape", "a reload replaces every word"),
    ("registers read in a run", "reads disturb nothing"),
    ("the next image waits at the port", "its first beat is neither lost nor taken early"),
    ("a register written while busy", "refused, and the image is unharmed"),
    ("a command while busy", "refused, and the image is unharmed"),
    ("a read-only register written", "refused"),
    ("an unmapped address written", "refused"),
    ("an unmapped address read", "refused"),
    ("soft reset before the first beat", "armed, nothing taken"),
    ("soft reset while the line buffer fills", "input side only"),
    ("soft reset between output beats", "every stage is occupied"),
    ("soft reset after the last input beat", "output side only"),
    ("soft reset in a load of weights", "half a memory written"),
    ("soft reset in a load of the requantiser", "half a memory written"),
    ("soft reset with other commands", "it overrides them"),
    ("reset input in a run", "registers fall back, memories stay"),
    ("TLAST_EARLY in an image", "named, and the image ends by its shape"),
    ("TLAST_MISSING in an image", "named, and the image ends by its shape"),
    ("an image that ends too soon", "named, and a soft reset recovers"),
    ("TLAST_EARLY in a load of weights", "named, and the load ends"),
    ("TLAST_MISSING in a load of weights", "named, and the load ends"),
    ("TLAST_EARLY in a load of the requantiser", "named, and the load ends"),
    ("TLAST_MISSING in a load of the requantiser", "named, and the load ends"),
    *(
        (f"BAD_SHAPE, {name} {fault}", "each limit is compared by itself")
        for name in ("HEIGHT", "WIDTH", "C_IN", "C_OUT")
        for fault in ("0", "too large")
    ),
    ("BAD_SHAPE, row too long", "the line buffer's limit"),
    *((f"BAD_MODE, {what}", "each field of MODE is compared") for what in ("kernel", "stride", "padding")),
    ("BAD_RANGE, no words", "a load that would never end"),
    ("BAD_RANGE, too many weights", "a load beyond the memory"),
    ("BAD_RANGE, too many requantiser words", "a load beyond the memory"),
    ("BAD_RANGE, a load onto the running layer", "refused, and the image is unharmed"),
    ("BAD_COMMAND, two commands", "no order is defined"),
)


def _events() -> Iterable[Bin]:
    for name, reason in _EVENTS:
        yield Bin(name, reason, lambda s, n=name: n in s.events)  # type: ignore[misc]
    yield Bin(
        "BAD_SHAPE, too many weights", "the weight memory's limit",
        lambda s: "BAD_SHAPE, too many weights" in s.events,
        lambda a: 3 * a.max_tiles * a.blocks(a.max_c_in) > a.weight_depth,
    )  # fmt: skip


BINS: tuple[Bin, ...] = (*_shapes(), *_values(), *_traffic(), *_events())
"""The reviewed list."""


@dataclass(frozen=True, slots=True)
class Score:
    """Bins of the list against what was seen.

    Attributes:
        hits: cases that met each bin that an array of the run admits.
        impossible: names of the bins that no array of the run admits.
    """

    hits: dict[str, int]
    impossible: list[str]

    @property
    def missed(self) -> list[str]:
        """Names of bins that should have been met and were not."""
        return [name for name, count in self.hits.items() if not count]

    @property
    def share(self) -> float:
        """Bins met, 0..1 of those that could be."""
        return 1 - len(self.missed) / len(self.hits)


def score(arrays: Sequence[ArrayConfig], seen: Sequence[Observation]) -> Score:
    """Count how often each bin was met."""
    possible = [b for b in BINS if any(b.possible(array) for array in arrays)]
    hits = {b.name: sum(b.possible(s.array) and b.hit(s) for s in seen) for b in possible}
    return Score(hits, [b.name for b in BINS if b not in possible])
