"""The deployed network in PyTorch, integer codes in and out, and its distance from the training graph."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn
from torch.nn import functional

from macram.golden import ShiftRequant
from macram.quant.lsq import LsqQuantizer
from macram.quant.network import QuantDarkNet53, QuantStage
from macram.quant.program import AddOp, Codes, ConvOp, LookupOp, Program


class DeployedNetwork(nn.Module):
    """Runs a `Program` in PyTorch, independently of the golden model: torch convolutions, torch rounding.

    Up to 4 output bits the codes come from the float64 formula; above, from the integer multiplier and shift
    that define them there.
    """

    def __init__(self, program: Program) -> None:
        super().__init__()
        self.program = program
        self.convs = nn.ModuleDict(
            {_key(op.name): _IntConv(op) for op in program.ops if isinstance(op, ConvOp)}
        )

    def forward(self, codes: Tensor) -> dict[str, Tensor]:
        """``[C, H, W]`` int64 codes of the program's input -> every tensor by name, int64, the input first.

        Raises:
            ValueError: ``codes`` do not fit the program's input.
        """
        self.program.check_input(codes.numpy())
        tensors = {self.program.input: codes}
        for op in self.program.ops:
            match op:
                case ConvOp():
                    tensors[op.name] = self.convs[_key(op.name)](tensors[op.source])
                case LookupOp():
                    tensors[op.name] = torch.from_numpy(op.table)[tensors[op.source]]
                case AddOp():
                    branch = torch.from_numpy(op.table)[tensors[op.branch]]
                    tensors[op.name] = (tensors[op.stream] + branch).clamp_max(op.ceiling)
        return tensors


class _IntConv(nn.Module):
    """One convolution on codes. Weights are kept in float64, where every sum below 2**53 is exact."""

    weight: Tensor

    def __init__(self, op: ConvOp) -> None:
        super().__init__()
        self.op = op
        self.register_buffer("weight", torch.from_numpy(op.weights).double())

    def forward(self, codes: Tensor) -> Tensor:
        """``[c_in, H, W]`` int64 -> ``[c_out, H/stride, W/stride]`` int64."""
        spec, requant = self.op.spec, self.op.requant
        acc = functional.conv2d(codes.double()[None], self.weight, stride=spec.stride, padding=spec.padding)[
            0
        ]
        # Whatever kernel torch may choose errs by far less than a half, so rounding restores the integer.
        acc = acc.round()
        if isinstance(requant, ShiftRequant):
            total = acc.to(torch.int64) * _column(requant.mult) + _column(requant.offset)
            return (total >> _column(requant.shift)).clamp(spec.output.lo, spec.output.hi)
        scaled = acc * _column(self.op.scale) + _column(self.op.offset)
        return scaled.round().clamp(spec.output.lo, spec.output.hi).to(torch.int64)


def _column(values: NDArray[np.int64] | NDArray[np.float64]) -> Tensor:
    """``[c_out]`` -> ``[c_out, 1, 1]``."""
    return torch.from_numpy(values).reshape(-1, 1, 1)


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


def training_codes(
    net: QuantDarkNet53, image: Tensor, program: Program, depth: int | None = None
) -> dict[str, Codes]:
    """The codes that the float32 training graph rounds to, under the names of the program's tensors.

    Args:
        net: in evaluation mode.
        image: ``[3, H, W]``, normalised.
        program: lowered from ``net``; its tensors stand in the order of the graph's activation quantisers.
        depth: stages to run, enough for the program.
    """
    recorded: list[Codes] = []

    def record(module: nn.Module, args: tuple[Any, ...], output: Tensor) -> None:
        assert isinstance(module, LsqQuantizer)
        if len(recorded) <= len(program.ops):
            recorded.append(module.to_codes(args[0])[0].numpy())

    handles = [quantizer.register_forward_hook(record) for quantizer in net.activation_quantizers()]
    try:
        with torch.no_grad():
            net(image[None], depth)
    finally:
        for handle in handles:
            handle.remove()
    names = [program.input, *(op.name for op in program.ops)]
    return dict(zip(names, recorded, strict=True))


def differing_shares(
    training: dict[str, Codes], deployed: dict[str, NDArray[np.integer]]
) -> dict[str, float]:
    """Share of codes, 0 to 1, in which the training graph and the deployed network differ, per tensor.

    Differences accumulate from layer to layer: each side continues with its own codes.

    Raises:
        ValueError: the two do not hold the same tensors.
    """
    if training.keys() != deployed.keys():
        raise ValueError(f"tensors differ: {sorted(training.keys() ^ deployed.keys())}")
    return {name: float(np.mean(training[name] != deployed[name])) for name in training}


def _key(name: str) -> str:
    return name.replace(".", "_")  # dots are not allowed in module names
