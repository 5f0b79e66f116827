"""Functional coverage of the array: the reviewed list of what a regression must have met.

Each bin names one thing that can be met and the reason why meeting it matters. A bin counts only where an array of the
run admits it, so bins of layer kinds that the array does not run yet switch on by themselves.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from macram.spec import ArrayConfig
from macram_sim.regression import bins_events, bins_layers, bins_streams
from macram_sim.regression.observation import Bin, Observation

BINS: tuple[Bin, ...] = (
    *bins_layers.shapes(),
    *bins_layers.channels(),
    *bins_layers.values(),
    *bins_layers.engines(),
    *bins_streams.traffic(),
    *bins_streams.residual_sums(),
    *bins_streams.partial_sums(),
    *bins_events.events(),
)
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
