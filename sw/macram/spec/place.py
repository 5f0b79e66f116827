"""Where in the weight and requantiser memories a layer lies, so that the next one can be loaded beside it."""

from __future__ import annotations

from dataclasses import dataclass

from macram.spec.array import ArrayConfig
from macram.spec.layer import ConvSpec


@dataclass(frozen=True)
class Place:
    """An end of the weight and requantiser memories. Layers at opposite ends are apart if both fit at all.

    Attributes:
        at_top: the layer's last word is the memory's last; else its first word is the first.
    """

    at_top: bool

    def bases(self, spec: ConvSpec, array: ArrayConfig) -> tuple[int, int]:
        """Addresses of the layer's first weight word and first requantiser word."""
        if not self.at_top:
            return 0, 0
        return array.weight_depth - array.weight_words(spec), array.requant_depth - array.requant_words(spec)


BOTTOM, TOP = Place(at_top=False), Place(at_top=True)


def fit_together(one: ConvSpec, other: ConvSpec, array: ArrayConfig) -> bool:
    """Whether two layers can be in the memories at the same time."""
    weights = array.weight_words(one) + array.weight_words(other)
    requant = array.requant_words(one) + array.requant_words(other)
    return weights <= array.weight_depth and requant <= array.requant_depth
