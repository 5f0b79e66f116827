"""Constrained-random cases for the array: which layer, which traffic, which disturbance.

Every choice deals from a shuffled deck that holds each option once, so that a short run already meets every option
and a long one meets them equally often. The plan depends on the array and the seed alone; case i is the same in a run
of any length.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

from macram.golden.cases import KINDS
from macram.spec import GROUP, TAPS, ArrayConfig, ConvSpec, fit_together, layer_passes
from macram_sim.regression.settings import BLOCKS, SCENARIOS, Setting, blocks_of
from macram_sim.streams import PATTERNS

KERNELS = ((3, 1), (3, 2), (1, 1), (1, 2))
"""Kernel and stride of every layer that an array may run."""
_WIDEST, _HIGHEST = 4, 7
"""Groups of pixels in a row and rows of an image, to keep a case in the tens of milliseconds."""

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class Traffic:
    """Pattern of idle cycles of each stream, of `macram_sim.streams.PATTERNS`."""

    image: str
    params: str
    output: str
    residual: str
    residual_sums: str


@dataclass(frozen=True, slots=True)
class Case:
    """One case.

    Attributes:
        spec: the whole layer; of its runs the case takes the one that ``block`` says, see `BLOCKS`.
        residual: a residual sum follows.
        bias_alone: every channel's scale is 1, and only its offset differs.
        at_top: the layer lies at the top of the memories.
        moment: in 0..1, places the disturbance.
        seed: draws codes, gaps and what is written.
    """

    index: int
    scenario: str
    spec: ConvSpec
    block: str
    residual: bool
    bias_alone: bool
    at_top: bool
    kind: str
    traffic: Traffic
    moment: float
    seed: int

    def __str__(self) -> str:
        spec, traffic = self.spec, self.traffic
        ends = [] if self.block == "whole" else [f"{self.block} block"]
        ends += ["residual sum"] if self.residual else []
        return (
            f"case {self.index} ({self.scenario}; {spec.c_in} -> {spec.c_out} channels, {spec.height} x {spec.width}, "
            f"kernel {spec.kernel}, stride {spec.stride}, {', '.join([f'input {spec.input}', *ends])}; "
            f"codes {self.kind}; gaps {traffic.image}, {traffic.params}, stalls {traffic.output}"
            + (f"; residual {traffic.residual}, {traffic.residual_sums})" if self.residual else ")")
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
        raise ValueError(f"the seed must be at least 0, not {seed}")
    rng = random.Random(f"plan {seed}")
    shapes = _Shapes(array, rng)
    scenarios = _deal([name for name, setting in SCENARIOS.items() if setting.possible(array)], rng)
    blocks = {
        options: _deal([block for block in options if block in blocks_of(array)], rng)
        for options in {setting.blocks for setting in SCENARIOS.values()}
    }
    kinds, tops = _deal(KINDS, rng), _deal((False, True), rng)
    biases, residuals = _deal((False, False, False, True), rng), _deal((True, True, False), rng)
    ends = _deal((True, False), rng)
    traffic = _deal([(gaps, stalls) for gaps in PATTERNS for stalls in PATTERNS], rng)
    params = _deal(PATTERNS, rng)
    beside = _deal([(gaps, stalls) for gaps in PATTERNS for stalls in PATTERNS], rng)
    index = 0
    while True:
        scenario, kind = next(scenarios), next(kinds)
        setting = SCENARIOS[scenario]
        block = next(blocks[setting.blocks])
        if "last" in setting.blocks and "last" in blocks_of(array) and kind in ("min", "max") and next(ends):
            block = "last"  # where the ends of the sums' range are met
        residual = bool(array.residual_stream_bits) and not BLOCKS[block].sums_out
        residual = residual and (setting.residual or next(residuals))
        (gaps, stalls), param_gaps = next(traffic), next(params)
        yield Case(
            index,
            scenario,
            shapes.next(setting, block, kind),
            block,
            residual,
            next(biases),
            next(tops),
            kind,
            Traffic(gaps, param_gaps, stalls, *(next(beside) if residual else ("none", "none"))),
            rng.random(),
            rng.randrange(1 << 30),
        )
        index += 1


class _Shapes:
    """Layers for an array, dealt from decks."""

    def __init__(self, array: ArrayConfig, rng: random.Random) -> None:
        self._array, self._rng = array, rng
        kinds = [
            (*pair, sign) for pair in KERNELS for sign in (array.input.signed, True) if admits(array, *pair)
        ]
        self._kinds, self._edges = _deal(kinds, rng), _deal((True, False), rng)
        self._tails = _deal((*range(GROUP), None), rng)
        self._rows = _deal(("1", "2", "odd", "even", "any"), rng)
        self._inputs = _deal(("one", "few", "whole", "odd blocks", "any", "most"), rng)
        self._outputs = _deal(("one", "part", "whole", "tiles", "any", "most"), rng)
        self._full = _deal([*fullest(array), *[None] * 9], rng)
        self._wholes = _deal(("few", "any", "most"), rng)

    def next(self, setting: Setting, block: str, kind: str) -> ConvSpec:
        """A layer that has such a block and does what the scenario needs."""
        array, rng = self._array, self._rng
        (kernel, stride, signed), tail, row = next(self._kinds), next(self._tails), next(self._rows)
        if (kernel, stride, signed) == (3, 1, True) and next(self._edges):
            tail = 0  # of signed codes on unsigned inputs both edges are corrected
        if tail is None:
            tail, width = 1, 1
        else:
            width = tail + GROUP * (rng.randrange(_WIDEST) if tail else rng.randint(1, _WIDEST))
        height = {"1": 1, "2": 2, "odd": rng.choice((3, 5, 7)), "even": rng.choice((4, 6))}.get(
            row, rng.randint(1, _HIGHEST)
        )
        if setting.larger:
            height, width = max(height, 3), max(width, GROUP + tail)
        c_in, c_out = self._channels_in(block, kind), self._channels_out()
        if block == "whole" and not setting.beside and (pair := next(self._full)) is not None:
            kernel, stride = TAPS, 1
            c_in, c_out = min(pair[0] * array.rows, array.max_c_in), pair[1] * array.units
        spec = _spec(array, c_in, c_out, height, width, kernel, stride)
        return _fit(array, replace(spec, input=replace(array.input, signed=signed)), block, setting.beside)

    def _channels_in(self, block: str, kind: str) -> int:
        array, rng = self._array, self._rng
        if block != "whole":
            least = array.max_c_in * (1 + (block == "middle")) + 1
            # The ends of the sums' range are met where all channels are.
            choice = "most" if kind in ("min", "max") else next(self._wholes)
            return {
                "few": rng.randint(least, min(least + array.rows, array.partial_sum_c_in)),
                "most": array.partial_sum_c_in,
            }.get(choice, rng.randint(least, array.partial_sum_c_in))
        blocks = array.blocks(array.max_c_in)
        c_in = {
            "one": 1,
            "few": rng.randint(1, max(1, array.rows - 1)),
            "whole": array.rows * rng.randint(1, blocks),
            "odd blocks": array.rows * (array.ingest * rng.randrange(blocks // array.ingest or 1) + 1),
            "most": array.max_c_in,
        }.get(next(self._inputs), rng.randint(1, array.max_c_in))
        return min(c_in, array.max_c_in)

    def _channels_out(self) -> int:
        array, rng = self._array, self._rng
        return {
            "one": 1,
            "part": rng.randint(1, array.units - 1),
            "whole": array.units * rng.randint(1, array.max_tiles),
            "tiles": rng.randint(min(array.units + 1, array.max_c_out), array.max_c_out),
            "most": array.max_c_out,
        }.get(next(self._outputs), rng.randint(1, array.max_c_out))


def _deal(options: Sequence[T], rng: random.Random) -> Iterator[T]:
    deck: list[T] = []
    while True:
        if not deck:
            deck = rng.sample(list(options), len(options))
        yield deck.pop()


def _fit(array: ArrayConfig, spec: ConvSpec, block: str, beside: bool) -> ConvSpec:
    """The layer, with fewer columns, channels or taps if the array has no room for it."""
    while not _fits(array, spec, block, beside):
        narrower = replace(spec, c_in=min(spec.c_in, array.rows) if block != "whole" else spec.c_in)
        if array.line_words(narrower) > array.row_words and spec.width > GROUP:
            spec = replace(spec, width=spec.width - GROUP)
        elif spec.c_out > array.units:
            spec = replace(spec, c_out=spec.c_out - array.units)
        elif block != "whole" and (spec.kernel, spec.stride) != (1, 1):
            # It must keep its channels to have so many blocks; two of them fit side by side with fewer taps.
            kernel = spec.kernel if spec.stride > 1 else 1
            spec = replace(spec, kernel=kernel, stride=1, padding=kernel // 2)
        else:
            spec = replace(spec, c_in=spec.c_in - 1)
    return spec


def _fits(array: ArrayConfig, spec: ConvSpec, block: str, beside: bool) -> bool:
    """Whether the layer has such a block, if asked with room for another one beside it."""
    try:
        parts = layer_passes(spec, array)
    except ValueError:
        return False
    found = [part.layer for part in parts if (part.sums_in, part.sums_out) == BLOCKS[block]]
    if block == "whole" and len(parts) > 1:
        return False
    return bool(found) and not (beside and not fit_together(found[0], found[0], array))


def _spec(
    array: ArrayConfig, c_in: int, c_out: int, height: int, width: int, kernel: int, stride: int
) -> ConvSpec:
    return ConvSpec(
        c_in, c_out, height, width, kernel, stride, kernel // 2,
        weight=array.weight, input=array.input, output=array.output,
    )  # fmt: skip
