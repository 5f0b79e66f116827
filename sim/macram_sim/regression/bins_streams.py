"""Bins of the traffic: idle cycles on every stream, residual sums and partial sums."""

from __future__ import annotations

from collections.abc import Iterable

from macram.spec import GROUP, RESIDUAL
from macram_sim.regression.observation import Bin, Observation, adds_blocks, adds_residual
from macram_sim.regression.plan import KERNELS
from macram_sim.regression.settings import blocks_of
from macram_sim.streams import PATTERNS


def _counted(seen: Observation, name: str) -> bool:
    return any(counters[name] > 0 for counters in seen.counters)


def traffic() -> Iterable[Bin]:
    """Idle cycles of image, parameters and output, and what the counters said of them."""
    for gaps in PATTERNS:
        for stalls in PATTERNS:
            yield Bin(
                f"input gaps {gaps}, output stalls {stalls}",
                "the two ends of the pipeline disturb each other",
                lambda s, g=gaps, t=stalls: (s.patterns["image"], s.patterns["output"]) == (g, t),  # type: ignore[misc]
            )
        yield Bin(
            f"parameter gaps {gaps}", "a load must not depend on the pace of its beats",
            lambda s, g=gaps: s.patterns["params"] == g,  # type: ignore[misc]
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


def residual_sums() -> Iterable[Bin]:
    """The residual adder and its two streams."""
    for gaps in PATTERNS:
        for stalls in PATTERNS:
            yield Bin(
                f"residual gaps {gaps}, stalls of its sums {stalls}",
                "the adder waits for two inputs and two outputs, in any order",
                lambda s, g=gaps, t=stalls: (  # type: ignore[misc]
                    s.residual and (s.patterns["residual"], s.patterns["residual_sums"]) == (g, t)
                ),
                adds_residual,
            )

    def bits(seen: Observation) -> int:
        return seen.spec.c_out * RESIDUAL.bits

    for name, reason, hit in (
        (
            "no residual sum where there could be one",
            "codes pass, both streams stay still",
            lambda s: not s.residual,
        ),
        (
            "one residual beat per pixel",
            "every beat ends a pixel",
            lambda s: s.residual and bits(s) <= s.array.residual_stream_bits,
        ),
        (
            "several residual beats per pixel",
            "words of the adder straddle beats",
            lambda s: s.residual and bits(s) > s.array.residual_stream_bits,
        ),
        (
            "a residual sum of several words per pixel",
            "the words of a pixel stay in order",
            lambda s: s.residual and s.spec.c_out > s.array.output_word_channels,
        ),
        (
            "a residual sum after stride 2",
            "its streams have the output's shape",
            lambda s: s.residual and s.spec.stride == 2,
        ),
        (
            "a residual sum that saturates",
            "clipping at 255",
            lambda s: s.residual and s.residual_sums[1] == RESIDUAL.hi,
        ),
        (
            "lowest next code",
            "no bound exceeded",
            lambda s: s.residual and s.next_codes[0] == s.spec.output.lo,
        ),
        (
            "highest next code",
            "every bound exceeded",
            lambda s: s.residual and s.next_codes[1] == s.spec.output.hi,
        ),
    ):
        yield Bin(name, reason, hit, adds_residual)


def partial_sums() -> Iterable[Bin]:
    """Runs over a block of the input channels."""
    for kernel, stride in KERNELS:
        yield Bin(
            f"partial sums come, kernel {kernel}x{kernel}, stride {stride}",
            "sums meet the drain in the order in which the groups end",
            lambda s, k=kernel, t=stride: s.takes and (s.spec.kernel, s.spec.stride) == (k, t),  # type: ignore[misc]
            adds_blocks,
        )
    for pattern in PATTERNS:
        yield Bin(
            f"partial sums come with gaps {pattern}", "the drain waits for each word",
            lambda s, p=pattern: s.takes and s.patterns["params"] == p,  # type: ignore[misc]
            adds_blocks,
        )  # fmt: skip
        yield Bin(
            f"partial sums leave with stalls {pattern}", "the drain waits for each word to be gone",
            lambda s, p=pattern: s.gives and s.patterns["output"] == p,  # type: ignore[misc]
            adds_blocks,
        )  # fmt: skip
    for name, reason, hit in (
        (
            "a whole layer where sums could come",
            "nothing is added, the streams carry words and codes",
            lambda s: s.block == "whole",
        ),
        ("the first block of a layer", "sums leave, none come; codes stay in", lambda s: s.block == "first"),
        (
            "the last block",
            "sums come, and are requantised with the whole layer's words",
            lambda s: s.block == "last",
        ),
        (
            "blocks of as many channels as there can be",
            "the whole width of a sum",
            lambda s: s.whole_c_in == s.array.partial_sum_c_in,
        ),
        (
            "smallest sum of a whole layer in blocks",
            "the lower end of the sums' format",
            lambda s: s.block == "last" and s.whole_c_in == s.array.partial_sum_c_in and s.sums_at_limit[0],
        ),
        (
            "largest sum of a whole layer in blocks",
            "the upper end of the sums' format",
            lambda s: s.block == "last" and s.whole_c_in == s.array.partial_sum_c_in and s.sums_at_limit[1],
        ),
        (
            "partial sums of several tiles",
            "each group has the words of every tile",
            lambda s: (s.takes or s.gives) and s.tiles > 1,
        ),
        (
            "partial sums come, last column in the carry",
            "one more group of words behind the last row",
            lambda s: s.takes and s.spec.out_width % GROUP == 0,
        ),
        (
            "partial sums leave, last column in the carry",
            "one more group of words behind the last row",
            lambda s: s.gives and s.spec.out_width % GROUP == 0,
        ),
        (
            "signed codes on unsigned inputs in the last block",
            "border terms of all channels, once",
            lambda s: s.biased and s.block == "last",
        ),
        (
            "signed codes on unsigned inputs where sums leave",
            "raised sums leave as they are",
            lambda s: s.biased and s.gives,
        ),
    ):
        yield Bin(name, reason, hit, adds_blocks)
    yield Bin(
        "a block in the middle", "sums come and leave",
        lambda s: s.block == "middle", lambda a: "middle" in blocks_of(a),
    )  # fmt: skip
    yield Bin(
        "a residual sum behind the last block", "both pairs of streams in one run",
        lambda s: s.residual and s.block == "last",
        lambda a: adds_blocks(a) and adds_residual(a),
    )  # fmt: skip
