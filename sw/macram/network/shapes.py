"""The distinct layer shapes of a network: what has to be simulated once to know every convolution's cycles."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from macram.perf import estimate_passes
from macram.spec import ArrayConfig, ConvSpec


@dataclass(frozen=True)
class Shape:
    """Convolutions that are alike but for their codes.

    Attributes:
        spec: the layer in the array's code formats.
        array: the array it runs on.
        names: of every convolution of this shape, in order, once per run.
        part: of the network, of the first of them.
    """

    spec: ConvSpec
    array: ArrayConfig
    names: tuple[str, ...]
    part: str

    @property
    def label(self) -> str:
        """Channels, size of the input, kernel and stride, such as ``64-128-128x128-3x3-1``."""
        spec = self.spec
        return (
            f"{spec.c_in}-{spec.c_out}-{spec.height}x{spec.width}-{spec.kernel}x{spec.kernel}-{spec.stride}"
        )

    @cached_property
    def refused(self) -> str | None:
        """Why the array cannot run it, if it cannot."""
        try:
            estimate_passes(self.spec, self.array)
        except ValueError as error:
            return str(error)
        return None

    @cached_property
    def cycles(self) -> int:
        """Of all passes by the closed form.

        Raises:
            ValueError: the array refuses the layer.
        """
        return sum(part.total for part in estimate_passes(self.spec, self.array))


def distinct_shapes(runs: Iterable[Mapping[str, Any]], array: ArrayConfig) -> list[Shape]:
    """The shapes of a network's convolutions, in order of their first run.

    Args:
        runs: convolutions: ``name``, ``part`` and the shape fields of `ConvSpec`, as of `macram.model.counts`.
        array: whose code formats they get.
    """
    names: dict[ConvSpec, list[str]] = {}
    parts: dict[ConvSpec, str] = {}
    for run in runs:
        kernel = run["kernel"]
        spec = ConvSpec(
            run["c_in"], run["c_out"], run["height"], run["width"],
            kernel=kernel, stride=run["stride"], padding=kernel // 2,
            weight=array.weight, input=array.input, output=array.output,
        )  # fmt: skip
        names.setdefault(spec, []).append(str(run["name"]))
        parts.setdefault(spec, str(run["part"]))
    return [Shape(spec, array, tuple(found), parts[spec]) for spec, found in names.items()]


def wanted_shapes(shapes: Sequence[Shape], only: Sequence[str]) -> list[Shape]:
    """The shapes that the array runs and one of whose names, or whose label, holds one of the texts ``only``.

    Shortest first, so that a run that is stopped early leaves as many results as possible. All if ``only`` is empty.

    Raises:
        ValueError: a text that nothing holds.
    """
    for text in only:
        if not any(_holds(shape, text) for shape in shapes):
            raise ValueError(
                f"--only {text}: no convolution has this in its name or shape; shapes are written like "
                f"{shapes[0].label}, names like {shapes[0].names[0]}"
            )
    found = [shape for shape in shapes if not only or any(_holds(shape, text) for text in only)]
    return sorted((shape for shape in found if shape.refused is None), key=lambda shape: shape.cycles)


def _holds(shape: Shape, text: str) -> bool:
    return text in shape.label or any(text in name for name in shape.names)
