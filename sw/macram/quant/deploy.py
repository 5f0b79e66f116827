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
from macram.quant.program import AccumulateOp, AddOp, Codes, ConvOp, LookupOp, Program

SAFE_SUM = 1 << 20
"""Integer sums below this survive a float32 convolution, with a margin for any algorithm."""
RADIX = 16


class DeployedNetwork(nn.Module):
    """Runs a `Program` in PyTorch, independently of the golden model: torch convolutions, torch rounding.

    Up to 4 output bits the codes come from the float64 formula; above, from the integer multiplier and shift
    that define them there.
    """

    def __init__(self, program: Program) -> None:
        super().__init__()
        self.program = program
        self.convs = nn.ModuleDict(
            {_key(op.name): _IntConv(op) for op in program.ops if isinstance(op, ConvOp | AccumulateOp)}
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
                case ConvOp() | AccumulateOp():
                    tensors[op.name] = self.convs[_key(op.name)](tensors[op.source])
                case LookupOp():
                    tensors[op.name] = _looked_up(tensors[op.source], op)
                case AddOp():
                    branch = _looked_up(tensors[op.branch], op)
                    if op.doubled:
                        branch = branch.repeat_interleave(2, 1).repeat_interleave(2, 2)
                    tensors[op.name] = (tensors[op.stream] + branch).clamp(op.floor, op.ceiling)
        return tensors


class _IntConv(nn.Module):
    """One convolution on codes, by float32 convolutions whose sums are integers far below ``2**24``.

    Where the sums may grow larger (8-bit codes), the input is split, ``code = 16 * high + low``. Where that
    is not enough either (8-bit weights at their limits), float64 serves, slowly.
    """

    weight: Tensor

    def __init__(self, op: ConvOp | AccumulateOp) -> None:
        super().__init__()
        self.op = op
        heaviest = int(abs(op.weights).sum(axis=(1, 2, 3)).max())
        largest = max(-op.spec.input.lo, op.spec.input.hi)
        single = heaviest * max(RADIX, -(-largest // RADIX)) < SAFE_SUM
        self.split = single and heaviest * largest >= SAFE_SUM
        weight = torch.from_numpy(op.weights)
        self.register_buffer("weight", weight.float() if single else weight.double())

    def forward(self, codes: Tensor) -> Tensor:
        """``[c_in, H, W]`` int64 -> ``[c_out, H/stride, W/stride]`` int64."""
        op, spec = self.op, self.op.spec
        x = codes.to(self.weight.dtype)[None]
        if self.split:
            high = (x / RADIX).floor_()
            x = torch.cat((high, x - RADIX * high))
        sums = functional.conv2d(x, self.weight, stride=spec.stride, padding=spec.padding)
        # Whatever kernel torch may choose errs by far less than a half, so rounding restores the integers.
        sums = sums.round_().double()
        acc = sums[0].mul_(RADIX).add_(sums[1]) if self.split else sums[0]
        if isinstance(op, AccumulateOp):
            return acc.to(torch.int64)
        if isinstance(requant := op.requant, ShiftRequant):
            total = acc.to(torch.int64).mul_(_column(requant.mult)).add_(_column(requant.offset))
            return total.bitwise_right_shift_(_column(requant.shift)).clamp_(spec.output.lo, spec.output.hi)
        scaled = acc.mul_(_column(op.scale)).add_(_column(op.offset))
        return scaled.round_().clamp_(spec.output.lo, spec.output.hi).to(torch.int64)


def _looked_up(codes: Tensor, op: LookupOp | AddOp) -> Tensor:
    return torch.from_numpy(op.table)[codes - op.low if op.low else codes]


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
    net: nn.Module, image: Tensor, program: Program, depth: int | None = None
) -> dict[str, Codes]:
    """The codes that the float32 training graph rounds to, under the names of the program's tensors.

    Sums that leave as accumulators are in no quantiser and so not among them.

    Args:
        net: quantised backbone or whole network, in evaluation mode.
        image: ``[3, H, W]``, normalised.
        program: lowered from ``net``; its tensors stand in the order of the graph's activation quantisers.
        depth: of a backbone, stages to run, enough for the program.
    """
    names = [program.input, *(op.name for op in program.ops if not isinstance(op, AccumulateOp))]
    recorded: list[Codes] = []

    def record(module: nn.Module, args: tuple[Any, ...], output: Tensor) -> None:
        assert isinstance(module, LsqQuantizer)
        if len(recorded) < len(names):
            recorded.append(module.to_codes(args[0])[0].numpy())

    quantizers = [m for m in net.modules() if isinstance(m, LsqQuantizer) and m.batched]
    handles = [quantizer.register_forward_hook(record) for quantizer in quantizers]
    try:
        with torch.no_grad():
            net(image[None]) if depth is None else net(image[None], depth)
    finally:
        for handle in handles:
            handle.remove()
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
    return "op_" + name.replace(".", "_")  # no dots in module names, and no name of a method such as "half"
