"""From the training graph to integers: weight codes, folded normalisation, tables for residual streams."""

from __future__ import annotations

from collections.abc import Iterator
from typing import cast

import numpy as np
from numpy.typing import NDArray

from macram.golden import derive_requant
from macram.quant.fold import fold_batch_norm
from macram.quant.lsq import LsqQuantizer
from macram.quant.network import QuantConv, QuantDarkNet53, QuantStage, QuantUnit
from macram.quant.program import AddOp, ConvOp, LookupOp, Op, Program
from macram.spec import ConvSpec

INPUT = "stage1.entry.input"


def lower(net: QuantDarkNet53, height: int, width: int, *, last: str) -> Program:
    """The integer program of the backbone up to and with the tensor ``last``.

    Tensors are called ``stageS.entry.input`` (codes that enter the strided block), ``stageS.entry`` (the
    residual stream behind it), ``stageS.unitU.reduce.input``, ``.reduce``, ``.expand`` (the branch) and
    ``stageS.unitU`` (the stream with the branch added); S and U count from 1. They come in the order in which
    the training graph calls its activation quantisers, one tensor per call.

    Args:
        net: calibrated or trained; its batch normalisation is taken in evaluation mode.
        height: rows of the image.
        width: columns of the image.
        last: name of the last tensor.

    Raises:
        ValueError: ``last`` is unknown, or a step that is needed was never set.
    """
    ops: list[Op] = []
    for op in backbone_operations(net, height, width):
        ops.append(op)
        if op.name == last:
            shape = (net.init.conv.out_channels, height, width)
            return Program(INPUT, net.precision.activation, shape, tuple(ops))
    raise ValueError(f"last must be a tensor of the network, such as {ops[-1].name!r}, not {last!r}")


def backbone_operations(net: QuantDarkNet53, height: int, width: int) -> Iterator[Op]:
    """Every operation of the backbone, lazily: steps beyond the last one taken need not be set."""
    size = height, width
    stream, stream_quant = "", None
    for s, stage in enumerate(cast(Iterator[QuantStage], net.stages), start=1):
        source = f"stage{s}.entry.input"
        if stream_quant is not None:
            yield LookupOp(source, stream, code_table(stream_quant, stage.entry.input_quant))
        entry = _conv(f"stage{s}.entry", source, stage.entry, stage.stream_quant, size)
        yield entry
        size = entry.spec.out_height, entry.spec.out_width
        stream, stream_quant = entry.name, stage.stream_quant
        for u, unit in enumerate(cast(Iterator[QuantUnit], stage.units), start=1):
            name = f"stage{s}.unit{u}"
            reduce, expand, branch = unit.reduce, unit.expand, unit.branch_quant
            yield LookupOp(f"{name}.reduce.input", stream, code_table(stream_quant, reduce.input_quant))
            yield _conv(f"{name}.reduce", f"{name}.reduce.input", reduce, expand.input_quant, size)
            yield _conv(f"{name}.expand", f"{name}.reduce", expand, branch, size)
            table = code_table(branch, stream_quant)
            yield AddOp(name, stream, f"{name}.expand", table, stream_quant.code_format.hi)
            stream = name


def _conv(name: str, source: str, block: QuantConv, output: LsqQuantizer, size: tuple[int, int]) -> ConvOp:
    conv, inputs, weights = block.conv, block.input_quant, block.weight_quant
    spec = ConvSpec(
        conv.in_channels, conv.out_channels, *size,
        kernel=conv.kernel_size[0], stride=conv.stride[0], padding=conv.kernel_size[0] // 2,
        weight=weights.code_format, input=inputs.code_format, output=output.code_format,
    )  # fmt: skip
    affine = fold_batch_norm(block.bn, weights.positive_step, inputs.positive_step, output.positive_step)
    codes = weights.to_codes(conv.weight).numpy()
    return ConvOp(name, source, spec, codes, *affine, derive_requant(spec, *affine))


def code_table(source: LsqQuantizer, target: LsqQuantizer) -> NDArray[np.int64]:
    """Code of ``target`` for every code of ``source``, smallest first: the nearest to the same value."""
    return addend_table(source, target).clip(target.code_format.lo, target.code_format.hi)


def addend_table(source: LsqQuantizer, target: LsqQuantizer, factor: float = 1.0) -> NDArray[np.int64]:
    """``factor`` times every code of ``source`` in steps of ``target``, half to even, unlimited.

    Raises:
        ValueError: a step was never set.
    """
    steps = source.positive_step.double().item(), target.positive_step.double().item()
    if not np.isfinite(steps).all():
        raise ValueError("activation steps were never set; calibrate the network or load a checkpoint")
    codes = np.arange(source.code_format.lo, source.code_format.hi + 1)
    nearest: NDArray[np.float64] = np.rint(codes * factor * steps[0] / steps[1])
    return nearest.astype(np.int64)
