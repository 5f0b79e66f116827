"""A network as a list of integer operations on named code tensors, and its execution by the golden model.

Every operation makes one tensor, named like the part of the network that it comes from. No torch here.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from macram.golden import ResidualRule, ShiftRequant, ThresholdRequant, conv2d
from macram.spec import ConvSpec, IntFormat

Codes = NDArray[np.int64]


@dataclass(frozen=True, eq=False, slots=True)
class ConvOp:
    """Convolution of ``source``, then requantisation.

    Attributes:
        name: of the tensor made, ``[c_out, out_height, out_width]``.
        source: name of the input, ``[c_in, height, width]``.
        spec: shapes and formats.
        weights: int64 codes ``[c_out, c_in, k, k]``.
        scale: float64 ``[c_out]``; with ``offset`` the float formula of the layer.
        offset: float64 ``[c_out]``.
        requant: the integer form of the formula: thresholds to 4 bits, else multiplier and shift.
    """

    name: str
    source: str
    spec: ConvSpec
    weights: Codes
    scale: NDArray[np.float64]
    offset: NDArray[np.float64]
    requant: ThresholdRequant | ShiftRequant


@dataclass(frozen=True, eq=False, slots=True)
class AccumulateOp:
    """Convolution whose exact sums leave the array; the host takes ``scale * acc + offset`` for their values.

    Attributes:
        name: of the tensor made, ``[c_out, out_height, out_width]``.
        source: name of the input, ``[c_in, height, width]``.
        spec: shapes and formats; the output format is the accumulator's.
        weights: int64 codes ``[c_out, c_in, k, k]``.
        scale: float64 ``[c_out]``.
        offset: float64 ``[c_out]``.
    """

    name: str
    source: str
    spec: ConvSpec
    weights: Codes
    scale: NDArray[np.float64]
    offset: NDArray[np.float64]


@dataclass(frozen=True, eq=False, slots=True)
class LookupOp:
    """Requantisation of a tensor through a table: ``table[code - low]``; ``low`` is its smallest code."""

    name: str
    source: str
    table: Codes
    low: int = 0


@dataclass(frozen=True, eq=False, slots=True)
class AddOp:
    """Sum ``clip(stream + table[branch - low], floor, ceiling)``; the table is in the stream's step.

    Attributes:
        name: of the tensor made.
        stream: name of the first addend, whose step the sum keeps.
        branch: name of the second addend.
        table: what each code of the branch adds.
        ceiling: largest code of the stream.
        floor: smallest code of the stream.
        low: smallest code of the branch.
        doubled: the branch has half the rows and columns; every code of it serves four places.
    """

    name: str
    stream: str
    branch: str
    table: Codes
    ceiling: int
    floor: int = 0
    low: int = 0
    doubled: bool = False


Op = ConvOp | AccumulateOp | LookupOp | AddOp


@dataclass(frozen=True, eq=False, slots=True)
class Program:
    """Operations in order of execution.

    Attributes:
        input: name of the tensor that the host provides.
        input_format: its codes.
        input_shape: ``(channels, height, width)``.
        ops: each reads the input or a tensor made before it.
    """

    input: str
    input_format: IntFormat
    input_shape: tuple[int, int, int]
    ops: tuple[Op, ...]

    def conv(self, name: str) -> ConvOp:
        """The convolution that makes tensor ``name``.

        Raises:
            ValueError: there is none.
        """
        for op in self.ops:
            if op.name == name and isinstance(op, ConvOp):
                return op
        raise ValueError(f"the program has no convolution {name!r}")

    def residual_rule(self, name: str) -> ResidualRule:
        """How the array makes the residual sum ``name`` and the input of the first layer that reads it.

        Raises:
            ValueError: there is no such sum, no layer reads it, or it is none of the backbone's.
        """
        for op in self.ops:
            if op.name == name and isinstance(op, AddOp) and not op.doubled:
                tables = [
                    after.table for after in self.ops if isinstance(after, LookupOp) and after.source == name
                ]
                if not tables:
                    raise ValueError(f"no layer of the program reads {name!r}")
                return ResidualRule.from_tables(self.conv(op.branch).spec.output, op.table, tables[0])
        raise ValueError(f"the program has no residual sum {name!r}")

    def check_input(self, codes: NDArray[np.integer]) -> None:
        """Refuses anything but integer codes of the input's shape and format.

        Raises:
            ValueError: wrong shape, type or range.
        """
        if codes.dtype.kind not in "iu" or codes.shape != self.input_shape:
            raise ValueError(
                f"{self.input} must be integers {list(self.input_shape)}, "
                f"not {codes.dtype} {list(codes.shape)}"
            )
        if not self.input_format.holds(codes):
            raise ValueError(
                f"{self.input} must hold codes {self.input_format.lo}..{self.input_format.hi}, "
                f"not {codes.min()}..{codes.max()}"
            )


def run_golden(program: Program, codes: NDArray[np.integer]) -> dict[str, Codes]:
    """Every tensor of the program by the golden model, in NumPy integers.

    Args:
        program: what to run.
        codes: the input, see `Program.input_shape`.

    Returns:
        int64 codes by name, the input first, then in order of ``program.ops``.

    Raises:
        ValueError: ``codes`` do not fit the program's input.
    """
    program.check_input(codes)
    tensors: dict[str, Codes] = {program.input: codes.astype(np.int64)}
    for op in program.ops:
        tensors[op.name] = golden_tensor(op, tensors)
    return tensors


def golden_tensor(op: Op, tensors: Mapping[str, Codes]) -> Codes:
    """The tensor that ``op`` makes of those before it, in NumPy integers."""
    match op:
        case ConvOp():
            acc = conv2d(tensors[op.source], op.weights, stride=op.spec.stride, padding=op.spec.padding)
            return op.requant.apply(acc)
        case AccumulateOp():
            acc = conv2d(tensors[op.source], op.weights, stride=op.spec.stride, padding=op.spec.padding)
            return acc.astype(np.int64)
        case LookupOp():
            return op.table[tensors[op.source] - op.low]
        case AddOp():
            branch = op.table[tensors[op.branch] - op.low]
            if op.doubled:
                branch = branch.repeat(2, axis=1).repeat(2, axis=2)
            total: Codes = np.clip(tensors[op.stream] + branch, op.floor, op.ceiling)
            return total
