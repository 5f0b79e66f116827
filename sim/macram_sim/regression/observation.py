"""What one case of the regression met, and the bins that ask for it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from macram.spec import ArrayConfig, ConvSpec, parse_format
from macram_sim.regression.settings import BLOCKS, blocks_of


@dataclass(frozen=True, slots=True)
class Observation:
    """What one case met on ``array``, measured by the bench.

    Attributes:
        spec: shape of the run; of the layer that it is part of, ``whole_c_in`` are the input channels.
        block: kind of the run, see `macram_sim.regression.settings.BLOCKS`.
        patterns: of idle cycles, by the names of `macram_sim.regression.plan.Traffic`.
        scales: signs of the channels' scales. bias_alone: all scales are 1.
        codes: smallest and largest code of the requantiser, None where sums leave instead.
        sums_at_limit: whether a sum was the smallest, the largest that there can be.
        residual_sums, next_codes: smallest and largest of the residual adder, None without a residual sum.
        counters: one table per whole image.
    """

    array: ArrayConfig
    spec: ConvSpec
    whole_c_in: int
    block: str
    at_top: bool
    scenario: str
    kind: str
    patterns: dict[str, str]
    scales: frozenset[int]
    bias_alone: bool
    codes: tuple[int, int] | None
    sums_at_limit: tuple[bool, bool]
    residual_sums: tuple[int, int] | None
    next_codes: tuple[int, int] | None
    counters: tuple[dict[str, int], ...]
    events: frozenset[str]

    @classmethod
    def from_dict(cls, array: ArrayConfig, table: dict[str, Any]) -> Observation:
        """From a line of ``seen.jsonl``."""
        c_in, c_out, height, width, kernel, stride = table["layer"]
        spec = ConvSpec(
            c_in, c_out, height, width, kernel, stride, kernel // 2,
            weight=array.weight, input=parse_format(table["input"]), output=array.output,
        )  # fmt: skip
        low, high = table["sums_at_limit"]
        return cls(
            array=array,
            spec=spec,
            whole_c_in=table["whole_c_in"],
            block=table["block"],
            at_top=table["at_top"],
            scenario=table["scenario"],
            kind=table["kind"],
            patterns=table["patterns"],
            scales=frozenset(table["scales"]),
            bias_alone=table["bias_alone"],
            codes=_ends(table["codes"]),
            sums_at_limit=(low, high),
            residual_sums=_ends(table["residual_sums"]),
            next_codes=_ends(table["next_codes"]),
            counters=tuple(table["counters"]),
            events=frozenset(table["events"]),
        )

    @property
    def blocks(self) -> int:
        """Channel blocks of the run."""
        return self.array.blocks(self.spec.c_in)

    @property
    def tiles(self) -> int:
        """Output-channel tiles of the run."""
        return self.array.tiles(self.spec.c_out)

    @property
    def biased(self) -> bool:
        """Signed codes run on unsigned inputs."""
        return self.array.biased(self.spec)

    @property
    def takes(self) -> bool:
        """The run starts from partial sums."""
        return BLOCKS[self.block].sums_in

    @property
    def gives(self) -> bool:
        """The run gives partial sums."""
        return BLOCKS[self.block].sums_out

    @property
    def residual(self) -> bool:
        """A residual sum follows."""
        return self.residual_sums is not None


def _ends(values: list[int] | None) -> tuple[int, int] | None:
    return None if values is None else (values[0], values[1])


def always(array: ArrayConfig) -> bool:
    """Every array."""
    return True


def adds_residual(array: ArrayConfig) -> bool:
    """Arrays with a residual adder."""
    return bool(array.residual_stream_bits)


def adds_blocks(array: ArrayConfig) -> bool:
    """Arrays that run layers in blocks of input channels."""
    return "last" in blocks_of(array)


@dataclass(frozen=True, slots=True)
class Bin:
    """One thing to be met; ``possible`` says on which arrays it can be."""

    name: str
    reason: str
    hit: Callable[[Observation], bool]
    possible: Callable[[ArrayConfig], bool] = always
