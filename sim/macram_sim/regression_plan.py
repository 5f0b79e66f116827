"""Constrained-random cases for the array: which layer, which traffic, which disturbance.

Every choice deals from a shuffled deck that holds each option once, so that a short run already meets every option
and a long one meets them equally often. The plan depends on the array and the seed alone; case i is the same in a run
of any length.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TypeVar

from macram.golden.cases import KINDS
from macram.spec import GROUP, TAPS, ArrayConfig, ConvSpec
from macram_sim.streams import PATTERNS

SCENARIOS = (
    "plain",
    "reuse",
    "reload",
    "snooped",
    "back to back",
    "writes while busy",
    "load while busy",
    "bad accesses",
    "reset waiting",
    "reset filling",
    "reset emitting",
    "reset ending",
    "reset in weights",
    "reset in requant",
    "reset with commands",
    "hard reset",
    "early TLAST",
    "missing TLAST",
    "truncated image",
    "bad weights load",
    "bad requant load",
    "bad shape",
    "bad mode",
    "bad command",
)
"""What `macram_sim.bench_regression` does with a case; each ends with a whole image and exact codes."""
_LARGER = {"reset filling", "reset emitting", "reset ending", "early TLAST", "truncated image", "hard reset"}
_KERNELS = ((3, 1), (3, 2), (1, 1))
_WIDEST, _HIGHEST = 4, 7
"""Groups of pixels in a row and rows of an image, to keep a case in the tens of milliseconds."""

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class Case:
    """One case; ``moment`` in 0..1 places the disturbance, ``seed`` draws codes, gaps and what is written."""

    index: int
    scenario: str
    spec: ConvSpec
    kind: str
    image_gaps: str
    param_gaps: str
    stalls: str
    moment: float
    seed: int

    def __str__(self) -> str:
        spec = self.spec
        return (
            f"case {self.index} ({self.scenario}; {spec.c_in} -> {spec.c_out} channels, {spec.height} x {spec.width}, "
            f"kernel {spec.kernel}, stride {spec.stride}; codes {self.kind}; gaps {self.image_gaps}, "
            f"{self.param_gaps}, stalls {self.stalls})"
        )


def admits(array: ArrayConfig, kernel: int, stride: int) -> bool:
    """Whether the array runs this kernel and stride on a small image."""
    try:
        array.check_admits(_spec(array, 1, 1, 3, 3, kernel, stride))
    except ValueError:
        return False
    return True


def fullest(array: ArrayConfig) -> list[tuple[int, int]]:
    """Channel blocks and tiles of the 3x3 layers that need as many weight words as fit the memory."""
    wanted = array.weight_depth // TAPS
    return [
        (blocks, wanted // blocks)
        for blocks in range(1, array.blocks(array.max_c_in) + 1)
        if wanted % blocks == 0 and wanted // blocks <= array.max_tiles
    ]


def plan(array: ArrayConfig, seed: int) -> Iterator[Case]:
    """Cases without end.

    Raises:
        ValueError: ``seed`` is negative.
    """
    if seed < 0:
        raise ValueError(f"the seed must be 0 or more, not {seed}")
    rng = random.Random(f"plan {seed}")
    blocks = [array.blocks(c) for c in range(1, array.max_c_in + 1)]
    scenarios, kinds = _deal(SCENARIOS, rng), _deal(KINDS, rng)
    traffic = _deal([(gaps, stalls) for gaps in PATTERNS for stalls in PATTERNS], rng)
    params = _deal(PATTERNS, rng)
    kernels = _deal([pair for pair in _KERNELS if admits(array, *pair)], rng)
    tails, rows = _deal((*range(GROUP), None), rng), _deal(("1", "2", "odd", "even", "any"), rng)
    inputs = _deal(("one", "few", "whole", "odd blocks", "any", "most"), rng)
    outputs = _deal(("one", "part", "whole", "tiles", "any", "most"), rng)
    full = _deal([*fullest(array), *[None] * 9], rng)
    index = 0
    while True:
        scenario, (image_gaps, stalls) = next(scenarios), next(traffic)
        kernel, stride = next(kernels)
        tail, row = next(tails), next(rows)
        if tail is None:
            tail, width = 1, 1
        else:
            width = tail + GROUP * (rng.randrange(_WIDEST) if tail else rng.randint(1, _WIDEST))
        height = {"1": 1, "2": 2, "odd": rng.choice((3, 5, 7)), "even": rng.choice((4, 6))}.get(
            row, rng.randint(1, _HIGHEST)
        )
        if scenario in _LARGER:
            height, width = max(height, 3), max(width, GROUP + tail)
        c_in = {
            "one": 1,
            "few": rng.randint(1, max(1, array.rows - 1)),
            "whole": array.rows * rng.randint(1, max(blocks)),
            "odd blocks": array.rows * (array.ingest * rng.randrange(max(blocks) // array.ingest or 1) + 1),
            "most": array.max_c_in,
        }.get(next(inputs), rng.randint(1, array.max_c_in))
        c_out = {
            "one": 1,
            "part": rng.randint(1, array.units - 1),
            "whole": array.units * rng.randint(1, array.max_tiles),
            "tiles": rng.randint(min(array.units + 1, array.max_c_out), array.max_c_out),
            "most": array.max_c_out,
        }.get(next(outputs), rng.randint(1, array.max_c_out))
        if (pair := next(full)) is not None and kernel == TAPS:
            c_in, c_out = min(pair[0] * array.rows, array.max_c_in), pair[1] * array.units
        spec = _fit(array, min(c_in, array.max_c_in), c_out, height, width, kernel, stride)
        yield Case(
            index,
            scenario,
            spec,
            next(kinds),
            image_gaps,
            next(params),
            stalls,
            rng.random(),
            rng.randrange(1 << 30),
        )
        index += 1


def _deal(options: Sequence[T], rng: random.Random) -> Iterator[T]:
    deck: list[T] = []
    while True:
        if not deck:
            deck = rng.sample(list(options), len(options))
        yield deck.pop()


def _fit(
    array: ArrayConfig, c_in: int, c_out: int, height: int, width: int, kernel: int, stride: int
) -> ConvSpec:
    """The layer, with fewer columns, output or input channels if the array has no room for it."""
    while True:
        spec = _spec(array, c_in, c_out, height, width, kernel, stride)
        try:
            array.check_admits(spec)
            return spec
        except ValueError:
            if array.weight_words(spec) > array.weight_depth and c_out > array.units:
                c_out -= array.units
            elif width > GROUP:
                width -= GROUP
            elif c_in > 1:
                c_in -= 1
            else:
                raise


def _spec(
    array: ArrayConfig, c_in: int, c_out: int, height: int, width: int, kernel: int, stride: int
) -> ConvSpec:
    return ConvSpec(
        c_in, c_out, height, width, kernel, stride, kernel // 2,
        weight=array.weight, input=array.input, output=array.output,
    )  # fmt: skip
