"""Bins of the layers: shapes, how they lie on the array, and the values that they hold."""

from __future__ import annotations

from collections.abc import Iterable

from macram.spec import GROUP, TAPS, ArrayConfig, ceil_div
from macram_sim.regression.observation import Bin, Observation
from macram_sim.regression.plan import KERNELS, admits, fullest


def _beat_bits(seen: Observation) -> int:
    return seen.spec.c_in * seen.array.input.bits


def _in_triples(seen: Observation) -> bool:
    return seen.array.triples(seen.spec) > 0


def _packs(array: ArrayConfig) -> bool:
    return array.max_tiles >= TAPS and array.blocks(array.max_c_in) >= max(
        array.pair_drain, array.triple_blocks
    )


def shapes() -> Iterable[Bin]:
    """Image and kernel."""
    for kernel, stride in KERNELS:
        yield Bin(
            f"kernel {kernel}x{kernel}, stride {stride}",
            "each walks the line buffer in its own order",
            lambda s, k=kernel, t=stride: (s.spec.kernel, s.spec.stride) == (k, t),  # type: ignore[misc]
            lambda a, k=kernel, t=stride: admits(a, k, t),  # type: ignore[misc]
        )
        yield Bin(
            f"signed codes on unsigned inputs, kernel {kernel}x{kernel}, stride {stride}",
            "padding is raised with the codes; which columns lack it depends on the order of the walk",
            lambda s, k=kernel, t=stride: s.biased and (s.spec.kernel, s.spec.stride) == (k, t),  # type: ignore[misc]
            lambda a: not a.input.signed,
        )
    for tail in range(GROUP):
        yield Bin(
            f"width mod 4 = {tail}",
            "the last group's mask; 0 sends the last column through the carry and the flush",
            lambda s, t=tail: s.spec.width % GROUP == t,  # type: ignore[misc]
        )
    yield from (
        Bin(
            "signed codes on unsigned inputs, both border terms",
            "a last column at a group's end is corrected in the next row's first group, or in the flush",
            lambda s: s.biased and (s.spec.kernel, s.spec.stride) == (3, 1) and s.spec.width % GROUP == 0,
            lambda a: not a.input.signed,
        ),
        Bin("width 1", "one pixel is both edges", lambda s: s.spec.width == 1),
        Bin("several groups in a row", "the carry goes from group to group", lambda s: s.spec.width > GROUP),
        Bin("height 1", "both neighbouring rows are padding; the start does not wait", lambda s: s.spec.height == 1),
        Bin("height 2", "every row has one row of padding", lambda s: s.spec.height == 2),
        Bin("height odd, above 2", "row slots do not come out even", lambda s: s.spec.height in range(3, 1000, 2)),
        Bin("height even, above 4", "every row slot is used again", lambda s: s.spec.height in range(6, 1000, 2)),
        Bin("one beat per input pixel", "every beat ends a pixel", lambda s: _beat_bits(s) <= s.array.stream_bits),
        Bin(
            "several beats per input pixel", "a pixel's words straddle beats",
            lambda s: _beat_bits(s) > s.array.stream_bits,
            lambda a: a.max_c_in * a.input.bits > a.stream_bits,
        ),
        Bin(
            "several beats per output pixel", "a beat is made of more than one word",
            lambda s: not s.gives and s.spec.c_out * s.array.output.bits > s.array.stream_bits,
            lambda a: a.max_c_out * a.output.bits > a.stream_bits,
        ),
    )  # fmt: skip


def channels() -> Iterable[Bin]:
    """Channel blocks, tiles, and the memories that they fill."""
    yield from (
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
        Bin(
            "sums end faster than the drain", "the sequencer must wait for the credit",
            lambda s: s.array.steps(s.spec) < s.array.drain_cycles,
            lambda a: a.drain_cycles > 3,
        ),
        Bin(
            "sums end slower than the drain", "the drain must wait for sums",
            lambda s: s.array.steps(s.spec) > s.array.drain_cycles,
        ),
        Bin(
            "as many weight words as fit", "the last addresses of the weight memory",
            lambda s: s.array.weight_words(s.spec) == s.array.weight_depth // TAPS * TAPS,
            lambda a: bool(fullest(a)),
        ),
        Bin(
            "words at the top of the memories", "the layer's bases are added to every address",
            lambda s: s.at_top,
        ),
        Bin("words at the bottom of the memories", "both bases are 0", lambda s: not s.at_top),
        Bin(
            "longest row", "the last line-buffer word of a row slot",
            lambda s: s.array.line_words(s.spec) == s.array.row_words,
            lambda a: a.row_words <= 4 * ceil_div(a.blocks(a.max_c_in), a.ingest) * a.ingest,
        ),
    )  # fmt: skip


def values() -> Iterable[Bin]:
    """Codes, scales and sums."""
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
        Bin(
            "scale 1, bias alone", "thresholds one apart: every step of a sum is a step of the code",
            lambda s: s.bias_alone and not s.gives,
        ),
        Bin("lowest output code", "clipping below", lambda s: s.codes is not None and s.codes[0] == s.spec.output.lo),
        Bin("highest output code", "clipping above", lambda s: s.codes is not None and s.codes[1] == s.spec.output.hi),
        Bin("smallest sum of the layer", "the lower end of the accumulator", lambda s: s.sums_at_limit[0]),
        Bin("largest sum of the layer", "the upper end of the accumulator", lambda s: s.sums_at_limit[1]),
    )  # fmt: skip


def engines() -> Iterable[Bin]:
    """Kinds of row engines and of the requantiser's memory."""
    for engine in ("portable", "dsp48e2", "dsp48e2_2x", "soft"):
        for index, end in enumerate(("smallest", "largest")):
            yield Bin(
                f"{engine} row engines, {end} sum", "each kind takes its products apart in its own way",
                lambda s, e=engine, i=index: e in s.array.row_kinds and s.sums_at_limit[i],  # type: ignore[misc]
                lambda a, e=engine: e in a.row_kinds,  # type: ignore[misc]
            )  # fmt: skip
        if engine.startswith("dsp48e2"):
            yield Bin(
                f"an impulse on soft rows beside {engine}", "whichever engine a row has, it meets its own channel",
                lambda s, e=engine: {e, "soft"} <= set(s.array.row_kinds) and s.kind == "impulse" and s.blocks > 1,  # type: ignore[misc]
                lambda a, e=engine: {e, "soft"} <= set(a.row_kinds),  # type: ignore[misc]
            )  # fmt: skip
    for style in ("block", "distributed"):
        yield Bin(
            f"requantiser words in {style} memory, reloaded", "each kind of memory has its own write and read path",
            lambda s, r=style: s.array.requant_ram == r and "other weights, same shape" in s.events,  # type: ignore[misc]
            lambda a, r=style: a.requant_ram == r,  # type: ignore[misc]
        )  # fmt: skip
