"""Networks as small files: quantised weights as codes of their own bits side by side, float ones in 16 bits.

In a packed file the tensor of a quantised convolution's weights is a byte string of two's complement codes,
low bits first, without gaps; the header's table ``packed`` says of each its bits, shape and step. Everything
else (steps, normalisation, biases, the first convolution, parts that the mode leaves alone) stays float32, so
that the deployed network is the same to the last bit. A float network has no codes; its weights get 16 bits.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
import torch
from torch import Tensor, nn

from macram.pack.bits import from_bits, to_bits
from macram.quant import LsqConv2d, LsqQuantizer
from macram.quant.lsq import MIN_STEP
from macram.quant.network import QuantConv
from macram.spec import IntFormat

PACKED = "packed"
"""Key of the table in the header."""
HEADER_BYTES = 8
"""Length field of a safetensors file."""


@dataclass(frozen=True, slots=True)
class FileSizes:
    """What a network costs in theory and on disk; bytes.

    Attributes:
        parameters: trained values.
        bits: per parameter in theory.
        ideal: ``parameters * bits / 8``, every parameter charged alike, as the paper's table V does.
        codes: packed weight codes.
        floats: everything stored as floating point or integer scalars.
        header: names, shapes and the description of the network.
        file: the whole file, the sum of the three before.
    """

    parameters: int
    bits: int
    ideal: float
    codes: int
    floats: int
    header: int
    file: int

    def to_dict(self) -> dict[str, Any]:
        """JSON types."""
        return asdict(self)


def pack_tensors(net: nn.Module) -> tuple[dict[str, Tensor], dict[str, Any]]:
    """The state of a network for a small file.

    Args:
        net: float or quantised.

    Returns:
        Tensors by name, and the header's table ``packed`` (empty for a float network).

    Raises:
        ValueError: a weight step was never set or differs by channel.
    """
    state = dict(net.state_dict())
    table: dict[str, Any] = {}
    for name, weight, quantizer in _quantised(net):
        form, step = quantizer.code_format, quantizer.positive_step
        if step.numel() != 1 or not bool(torch.isfinite(step).all()):
            raise ValueError(
                f"{name}: its step is not one finite number; train the network in stage lsq first"
            )
        codes = quantizer.to_codes(weight).cpu().numpy()
        stream = np.packbits(to_bits(codes.ravel(), form).ravel(), bitorder="little")
        state[f"{name}.weight"] = torch.from_numpy(stream)
        table[f"{name}.weight"] = {
            "bits": form.bits,
            "shape": list(codes.shape),
            "step": next(n for n, p in net.named_parameters() if p is quantizer.step),
        }
    if not table:
        # Vectors are few; normalisation statistics may leave the range of 16 bits.
        state = {name: value.half() if value.ndim > 1 else value for name, value in state.items()}
    return state, table


def unpack_tensors(tensors: Mapping[str, Tensor], table: Mapping[str, Any], path: Path) -> dict[str, Tensor]:
    """Inverse of `pack_tensors`: weights are codes times step, which quantise to these codes again.

    Raises:
        ValueError: the table and the tensors do not fit each other.
    """
    state = dict(tensors)
    for name, about in table.items():
        try:
            form, shape = IntFormat(int(about["bits"]), signed=True), tuple(about["shape"])
            stream, step = tensors[name], tensors[about["step"]]
        except (KeyError, TypeError, ValueError):
            raise ValueError(
                f"{path}: its table of packed weights is broken at {name!r}; fetch it again"
            ) from None
        bits = math.prod(shape) * form.bits
        if stream.dtype != torch.uint8 or stream.numel() != -(-bits // 8):
            raise ValueError(
                f"{path}: {name!r} needs {-(-bits // 8)} bytes, not {stream.numel()}; fetch it again"
            )
        fields = np.unpackbits(stream.numpy(), count=bits, bitorder="little").reshape(-1, form.bits)
        codes = torch.from_numpy(from_bits(fields, form)).reshape(shape)
        state[name] = codes.to(torch.float32) * step.float().clamp_min(MIN_STEP)
    return state


def file_sizes(path: Path, parameters: int, bits: int) -> FileSizes:
    """What a network's file consists of.

    Args:
        path: packed or plain safetensors file.
        parameters: trained values of the network.
        bits: per parameter in theory.
    """
    content = path.read_bytes()
    length = int.from_bytes(content[:HEADER_BYTES], "little")
    header = json.loads(content[HEADER_BYTES : HEADER_BYTES + length])
    about = header.pop("__metadata__", {})
    packed = json.loads(about.get("macram", "{}")).get(PACKED, {})
    spans = {name: entry["data_offsets"][1] - entry["data_offsets"][0] for name, entry in header.items()}
    codes = sum(size for name, size in spans.items() if name in packed)
    return FileSizes(
        parameters=parameters,
        bits=bits,
        ideal=parameters * bits / 8,
        codes=codes,
        floats=sum(spans.values()) - codes,
        header=HEADER_BYTES + length,
        file=len(content),
    )


def _quantised(net: nn.Module) -> Iterator[tuple[str, Tensor, LsqQuantizer]]:
    """Every convolution on codes: the prefix of its weight's name, the weight, its quantiser."""
    for name, module in net.named_modules():
        if isinstance(module, QuantConv):
            yield f"{name}.conv", module.conv.weight, module.weight_quant
        elif isinstance(module, LsqConv2d):
            yield name, module.weight, module.weight_quant
