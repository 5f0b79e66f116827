"""The deployed network in PyTorch, integer codes in and out."""

from __future__ import annotations

from collections.abc import Iterator
from typing import cast

import numpy as np
import torch
from torch import Tensor, nn
from torch.nn import functional

from macram.golden import ShiftRequant
from macram.quant.network import QuantDarkNet53, QuantStage
from macram.quant.program import AccumulateOp, AddOp, Codes, ConvOp, LookupOp, Op, Program

SAFE_SUM = 1 << 20
"""Integer sums below this survive a float32 convolution, with a margin for any algorithm."""
RADIX = 16
EXACT = 1 << 24
"""Integers below this are exact in float32."""


class DeployedNetwork(nn.Module):
    """Runs a `Program` in PyTorch, independently of the golden model: torch convolutions, torch rounding.

    Up to 4 output bits the codes come from the float64 formula; above, from the multiplier and shift that
    define them there. Between layers codes are carried in float32, channels last, where they are exact and
    every kernel is fast.
    """

    def __init__(self, program: Program) -> None:
        super().__init__()
        self.program = program
        self.convs = nn.ModuleDict(
            {_key(op.name): _IntConv(op) for op in program.ops if isinstance(op, ConvOp | AccumulateOp)}
        )
        self.tables = {op.name: _Table(op) for op in program.ops if isinstance(op, LookupOp | AddOp)}
        self.last_use = {name: i for i, op in enumerate(program.ops) for name in _sources(op)}

    def forward(self, codes: Tensor) -> dict[str, Tensor]:
        """``[C, H, W]`` int64 codes of the program's input -> every tensor by name, int64, the input first.

        Raises:
            ValueError: ``codes`` do not fit the program's input.
        """
        made = {op.name: _whole(value) for op, value in self._results(codes)}
        return {self.program.input: codes, **made}

    def accumulators(self, codes: Tensor) -> dict[str, Tensor]:
        """As `forward`, but only the sums that the host needs; other tensors go as soon as nothing reads them.

        Raises:
            ValueError: ``codes`` do not fit the program's input.
        """
        return {op.name: _whole(value) for op, value in self._results(codes) if isinstance(op, AccumulateOp)}

    @torch.no_grad()
    def _results(self, codes: Tensor) -> Iterator[tuple[Op, Tensor]]:
        """Every operation with the ``[1, C, H, W]`` integers it makes, in floating point that holds them exactly."""
        self.program.check_input(codes.numpy())
        tensors = {self.program.input: codes[None].float().contiguous(memory_format=torch.channels_last)}
        for i, op in enumerate(self.program.ops):
            match op:
                case ConvOp() | AccumulateOp():
                    value = self.convs[_key(op.name)](tensors[op.source])
                case LookupOp():
                    value = self.tables[op.name](tensors[op.source])
                case AddOp():
                    branch = self.tables[op.name](tensors[op.branch])
                    if op.doubled:
                        branch = functional.interpolate(branch, scale_factor=2.0, mode="nearest")
                    value = (tensors[op.stream] + branch).clamp_(op.floor, op.ceiling)
            tensors[op.name] = value
            yield op, value
            for name in (*_sources(op), op.name):
                if self.last_use.get(name, -1) <= i:
                    tensors.pop(name, None)


class _IntConv(nn.Module):
    """One convolution on codes, by float32 convolutions whose sums are integers far below ``2**24``.

    Where the sums may grow larger (8-bit codes), the input is split, ``code = 16 * high + low``. Where that
    is not enough either (8-bit weights at their limits), float64 serves, slowly.
    """

    weight: Tensor
    scale: Tensor
    offset: Tensor

    def __init__(self, op: ConvOp | AccumulateOp) -> None:
        super().__init__()
        self.op = op
        heaviest = int(abs(op.weights).sum(axis=(1, 2, 3)).max())
        largest = max(-op.spec.input.lo, op.spec.input.hi)
        single = heaviest * max(RADIX, -(-largest // RADIX)) < SAFE_SUM
        self.split = single and heaviest * largest >= SAFE_SUM
        weight = torch.from_numpy(op.weights).to(torch.float32 if single else torch.float64)
        self.register_buffer("weight", weight.contiguous(memory_format=torch.channels_last))
        scale, offset = op.scale, op.offset
        requant = op.requant if isinstance(op, ConvOp) else None
        self.floor = isinstance(requant, ShiftRequant)
        if isinstance(requant, ShiftRequant):
            # floor((acc * mult + offset) / 2**shift); products and sums have 48 bits, so float64 never rounds.
            scale, offset = (np.ldexp(v, -requant.shift) for v in (requant.mult, requant.offset))
        self.register_buffer("scale", torch.from_numpy(scale).reshape(-1, 1, 1))
        self.register_buffer("offset", torch.from_numpy(offset).reshape(-1, 1, 1))

    def forward(self, x: Tensor) -> Tensor:
        """``[1, c_in, H, W]`` -> ``[1, c_out, H/stride, W/stride]``: codes in float32, accumulators in float64."""
        op, spec = self.op, self.op.spec
        x = x.to(self.weight.dtype)
        if self.split:
            high = (x / RADIX).floor_()
            x = torch.cat((high, x - RADIX * high))
        sums = functional.conv2d(x, self.weight, stride=spec.stride, padding=spec.padding)
        # Whatever kernel torch may choose errs by far less than a half, so rounding restores the integers.
        sums = sums.round_().double()
        acc = sums[:1].mul_(RADIX).add_(sums[1:]) if self.split else sums
        if isinstance(op, AccumulateOp):
            return acc
        acc = acc.mul_(self.scale).add_(
            self.offset
        )  # two roundings, as in the formula: no fused multiply-add
        acc = acc.floor_() if self.floor else acc.round_()
        return acc.clamp_(spec.output.lo, spec.output.hi).float()


class _Table:
    """A table of codes, by ``clip(rint(ratio * code))`` in float32 if that gives every entry, else by gathering."""

    def __init__(self, op: LookupOp | AddOp) -> None:
        self.low, self.table = op.low, torch.from_numpy(op.table)
        self.limits = int(op.table.min()), int(op.table.max())
        self.ratio = _ratio(op.table, op.low)

    def __call__(self, codes: Tensor) -> Tensor:
        """``[1, C, H, W]`` -> the same shape."""
        if self.ratio is None or codes.dtype != torch.float32:
            entries = self.table[codes.long() - self.low]
            return entries.float() if max(map(abs, self.limits)) < EXACT else entries.double()
        return (codes * self.ratio).round_().clamp_(*self.limits)


def _ratio(table: Codes, low: int) -> float | None:
    """A ratio whose rounded and clipped multiples are the table, tried on all of it; None if none is found."""
    codes = np.arange(low, low + len(table))
    limits = table.min(), table.max()
    # Rounding to an entry bounds the ratio on both sides, being clipped to a limit on one.
    below = np.where(table == limits[0], -np.inf, table - 0.5)[codes != 0]
    above = np.where(table == limits[1], np.inf, table + 0.5)[codes != 0]
    bounds = np.sort((below / codes[codes != 0], above / codes[codes != 0]), axis=0)
    least, most = bounds[0].max(initial=-np.inf), bounds[1].min(initial=np.inf)
    finite = [bound for bound in (least, most) if np.isfinite(bound)]
    if not finite:
        return None  # a constant
    ratio = np.float32(np.mean(finite) if len(finite) == 2 else 2 * finite[0])
    multiples = np.rint(codes.astype(np.float32) * ratio)
    return float(ratio) if np.array_equal(multiples.clip(*limits), table) else None


def _sources(op: Op) -> tuple[str, ...]:
    return (op.stream, op.branch) if isinstance(op, AddOp) else (op.source,)


def _whole(value: Tensor) -> Tensor:
    """``[1, C, H, W]`` integers in floating point -> int64 ``[C, H, W]``."""
    return value[0].to(torch.int64).contiguous()


def host_codes(net: QuantDarkNet53, image: Tensor) -> Tensor:
    """The part that stays on the host: image -> first convolution in float32 -> the first codes.

    Args:
        net: in evaluation mode.
        image: ``[3, H, W]``, normalised.

    Returns:
        int64 ``[32, H, W]``, the input of the integer program.
    """
    entry = cast(QuantStage, net.stages[0]).entry
    with torch.no_grad():
        return entry.input_quant.to_codes(net.init(image[None]))[0]


def _key(name: str) -> str:
    return "op_" + name.replace(".", "_")  # no dots in module names, and no name of a method such as "half"
