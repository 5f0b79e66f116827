"""The scenarios of the regression by name, and what each needs of the run that it disturbs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from macram.spec import ArrayConfig, ceil_div


class Ends(NamedTuple):
    """How a run is tied to the runs over the other blocks of input channels."""

    sums_in: bool
    sums_out: bool


BLOCKS = {
    "whole": Ends(sums_in=False, sums_out=False),
    "first": Ends(sums_in=False, sums_out=True),
    "middle": Ends(sums_in=True, sums_out=True),
    "last": Ends(sums_in=True, sums_out=False),
}
"""The whole layer in one run, or one of the runs over a block of its input channels."""
_TAKING, _GIVING, _CODES, _ALONE = (
    ("middle", "last"),
    ("first", "middle"),
    ("whole", "last"),
    ("whole", "first"),
)


def blocks_of(array: ArrayConfig) -> list[str]:
    """Kinds of run that ``array`` has room for."""
    runs = ceil_div(array.partial_sum_c_in, array.max_c_in)
    return ["whole", *(["first", "last"] if runs > 1 else []), *(["middle"] if runs > 2 else [])]


@dataclass(frozen=True, slots=True)
class Setting:
    """What a scenario needs.

    Attributes:
        blocks: kinds of run it is for, of `BLOCKS`.
        residual: a residual sum must follow.
        larger: the image must be long enough to be disturbed in the middle.
        beside: another layer of the same shape must fit the memories beside this one.
    """

    blocks: tuple[str, ...] = tuple(BLOCKS)
    residual: bool = False
    larger: bool = False
    beside: bool = False

    def possible(self, array: ArrayConfig) -> bool:
        """Whether ``array`` has such runs."""
        runs = any(block in self.blocks for block in blocks_of(array))
        return (
            runs
            and (not self.residual or bool(array.residual_stream_bits))
            and (not self.beside or array.max_tiles > 1)
        )


_ANY, _LARGER = Setting(), Setting(larger=True)
_RESIDUAL = Setting(_CODES, residual=True, larger=True)
_SUMS = Setting(_TAKING, larger=True)

SCENARIOS = {
    "plain": _ANY,
    "reuse": _ANY,
    "reload": _ANY,
    "snooped": _ANY,
    "back to back": _ANY,
    "late residual": _RESIDUAL,
    "late sums": _SUMS,
    "all blocks": Setting(("first", "middle", "last")),
    "load beside": Setting(_ALONE, larger=True, beside=True),
    "start beside a load": Setting(_ALONE, beside=True),
    "start beside a load, taking sums": Setting(_TAKING, beside=True),
    "start in its load": _ANY,
    "load while busy": Setting(_ALONE),
    "load while busy, taking sums": Setting(_TAKING),
    "writes while busy": _ANY,
    "bad accesses": _ANY,
    "bad shape": _ANY,
    "bad mode": _ANY,
    "bad command": _ANY,
    "reset waiting": _ANY,
    "reset filling": _LARGER,
    "reset emitting": _LARGER,
    "reset ending": _LARGER,
    "reset in residual": _RESIDUAL,
    "reset taking sums": _SUMS,
    "reset giving sums": Setting(_GIVING, larger=True),
    "reset in weights": _ANY,
    "reset in requant": _ANY,
    "reset with commands": _ANY,
    "hard reset": _LARGER,
    "early TLAST": _LARGER,
    "missing TLAST": _ANY,
    "truncated image": _LARGER,
    "bad weights load": _ANY,
    "bad requant load": _ANY,
    "bad TLAST in residual": _RESIDUAL,
    "truncated residual": _RESIDUAL,
    "bad TLAST in sums": _SUMS,
    "truncated sums": _SUMS,
}
"""What `macram_sim.regression.scenarios` does with a case; each ends with a whole image and exact codes."""
