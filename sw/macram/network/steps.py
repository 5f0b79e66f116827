"""A convolution of an integer program as runs on an array, and its tensor from what they give."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from macram.layer_file import LayerCase
from macram.pack import PackedLayer, pack_passes
from macram.pack.signed import Rise
from macram.perf import estimate
from macram.quant.program import AccumulateOp, Codes, ConvOp, Program
from macram.spec import ArrayConfig, layer_passes


@dataclass(frozen=True, eq=False)
class ArrayStep:
    """One convolution on the array.

    Attributes:
        op: the convolution.
        passes: its runs in order.
        channels: input channels of every run.
        last: whether a run ends a block of output channels, so that it gives codes or whole sums.
        as_sums: the array has no such output codes: exact sums leave it, and the host requantises them.
        rise: what the array adds to these sums, where it raises signed input codes.
    """

    op: ConvOp | AccumulateOp
    passes: tuple[PackedLayer, ...]
    channels: tuple[range, ...]
    last: tuple[bool, ...]
    as_sums: bool
    rise: Rise

    @cached_property
    def cycles(self) -> int:
        """Of all passes by the closed form."""
        return sum(
            estimate(part.spec, part.array, sums_in=part.sums_in, sums_out=part.sums_out).total
            for part in self.passes
        )

    @cached_property
    def exact(self) -> bool:
        """Whether these are the cycles of an undisturbed run, not only near them."""
        return all(
            estimate(part.spec, part.array, sums_in=part.sums_in, sums_out=part.sums_out).exact
            for part in self.passes
        )

    def tensor(self, results: Sequence[NDArray[np.int64]]) -> Codes:
        """The tensor of the program from the codes or sums of every run, ``[c_out, out_height, out_width]``."""
        found = np.concatenate([codes for codes, last in zip(results, self.last, strict=True) if last])
        if not self.as_sums:
            return found
        sums = found - self.rise.total[:, None, None]
        sums[:, :, 0] += self.rise.left[:, None]
        sums[:, :, -1] += self.rise.right[:, None]
        return self.op.requant.apply(sums) if isinstance(self.op, ConvOp) else sums


def array_steps(program: Program, array: ArrayConfig) -> list[ArrayStep]:
    """Every convolution of a program packed for ``array``, in order.

    Raises:
        ValueError: a convolution that the array does not run; the line names it and the limit.
    """
    steps = []
    for op in program.ops:
        if isinstance(op, ConvOp | AccumulateOp):
            try:
                steps.append(_step(op, array))
            except ValueError as error:
                raise ValueError(f"{op.name}: {error}") from error
    return steps


def needs_sums(program: Program, array: ArrayConfig) -> bool:
    """Whether a convolution has other output codes than the array, so that its sums must leave."""
    return any(op.spec.output != array.output for op in program.ops if isinstance(op, ConvOp | AccumulateOp))


def _step(op: ConvOp | AccumulateOp, array: ArrayConfig) -> ArrayStep:
    as_sums = op.spec.output != array.output
    spec = dataclasses.replace(op.spec, output=array.output)
    scale, offset = (np.zeros(spec.c_out),) * 2 if as_sums else (op.scale, op.offset)
    blank = np.zeros((spec.c_in, spec.height, spec.width), np.int64)
    parts = layer_passes(spec, array)
    passes = pack_passes(LayerCase(spec, op.weights, blank, scale, offset), array)
    if as_sums:
        passes = [dataclasses.replace(packed, sums_out=True) for packed in passes]
    return ArrayStep(
        op,
        tuple(passes),
        tuple(part.c_in for part in parts),
        tuple(not part.sums_out for part in parts),
        as_sums,
        Rise.of(op.weights, spec, array),
    )
