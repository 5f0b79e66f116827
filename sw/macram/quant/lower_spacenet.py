"""The whole deployable network as an integer program: backbone, pyramids, difference, head."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import cast

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn

from macram.golden import derive_requant
from macram.model import Prediction, SpaceNet
from macram.model.config import PYRAMID_INPUTS
from macram.model.fpn import FeaturePyramid
from macram.quant.convert import LsqConv2d
from macram.quant.fold import fold_batch_norm, fold_bias
from macram.quant.lower import INPUT, addend_table, backbone_operations, code_table
from macram.quant.lsq import LsqQuantizer
from macram.quant.network import QuantDarkNet53
from macram.quant.program import AccumulateOp, AddOp, ConvOp, LookupOp, Op, Program
from macram.spec import ConvSpec

Place = tuple[str, LsqQuantizer]
"""Name of a tensor of codes and the quantiser whose codes they are."""
Size = tuple[int, int]
FIRST_LEVEL = 3


def lower_network(net: SpaceNet, height: int, width: int) -> Program:
    """The integer program of a network quantised in mode III.

    Tensors of the backbone are named as by `macram.quant.lower`; then come ``fpn.*``, ``fpn_pseudo.*``,
    ``direct.pK`` and ``head.pK.*`` for the levels K = 3 to 7. All but the accumulators ``head.pK.class`` and
    ``head.pK.pose`` stand in the order in which the training graph calls its activation quantisers.

    Args:
        net: deployable, calibrated or trained; its batch normalisation is taken in evaluation mode.
        height: rows of the image, a multiple of 32.
        width: columns of the image, a multiple of 32.

    Raises:
        ValueError: the network is not deployable or not quantised in mode III, or a step was never set.
    """
    backbone = net.backbone
    if not isinstance(backbone, QuantDarkNet53) or not isinstance(net.head.classes, LsqConv2d):
        raise ValueError("only a deployable network in mode III is all integers; see macram.quant.quantise")
    if height % 32 or width % 32 or min(height, width) < 32:
        raise ValueError(f"height and width must be multiples of 32, not {height} and {width}")
    ops = list(backbone_operations(backbone, height, width))
    ops += _rest(net, backbone, ops, (height, width))
    shape = (backbone.init.conv.out_channels, height, width)
    return Program(INPUT, backbone.precision.activation, shape, tuple(ops))


def host_predictions(program: Program, tensors: dict[str, Tensor]) -> tuple[Prediction, ...]:
    """What the host makes of the accumulators: float32 predictions of P3 to P7, batch of one.

    Args:
        program: from `lower_network`.
        tensors: from `macram.quant.DeployedNetwork`, int64.
    """
    values = {}
    for op in program.ops:
        if isinstance(op, AccumulateOp):
            scale, offset = (torch.from_numpy(v).reshape(-1, 1, 1) for v in (op.scale, op.offset))
            values[op.name] = (tensors[op.name] * scale + offset).float()[None]
    levels = range(FIRST_LEVEL, FIRST_LEVEL + len(values) // 2)
    return tuple(Prediction(values[f"head.p{k}.class"], values[f"head.p{k}.pose"]) for k in levels)


def _rest(net: SpaceNet, backbone: QuantDarkNet53, ops: list[Op], size: Size) -> Iterator[Op]:
    maps: list[Place] = []
    for s, stage in enumerate(backbone.stages, start=1):
        units = len(cast(Sequence[nn.Module], stage.units))
        name = f"stage{s}.unit{units}" if units else f"stage{s}.entry"
        maps.append((name, cast(LsqQuantizer, stage.stream_quant)))
    depth = len(maps)
    sizes = [(size[0] >> k, size[1] >> k) for k in range(depth - PYRAMID_INPUTS + 1, depth + 1)]
    taps = [cast(LsqQuantizer, tap) for tap in net.taps]
    level_sizes = [*sizes, *(_halved(sizes[-1], times) for times in (1, 2))]
    yield from _pyramid("fpn", net.fpn, maps[-PYRAMID_INPUTS:], sizes, taps)
    inputs = [f"fpn.p{k}" for k in range(FIRST_LEVEL, FIRST_LEVEL + len(taps))]
    if net.fpn_pseudo is not None:
        yield from _pyramid("fpn_pseudo", net.fpn_pseudo, maps[-PYRAMID_INPUTS:], sizes, taps)
        for level, tap in enumerate(taps):
            k, form = level + FIRST_LEVEL, tap.code_format
            background, inputs[level] = f"fpn_pseudo.p{k}", f"direct.p{k}"
            if net.config.tde_factor != 1:
                table = addend_table(tap, tap, net.config.tde_factor)  # at most 1, so no code leaves
                yield LookupOp(f"{background}.scaled", background, table, form.lo)
                background += ".scaled"
            table = addend_table(tap, tap, -1.0)
            yield AddOp(inputs[level], f"fpn.p{k}", background, table, form.hi, floor=form.lo, low=form.lo)
    for level, tap in enumerate(taps):
        yield from _head(net, level, (inputs[level], tap), level_sizes[level])


def _pyramid(
    name: str, pyramid: FeaturePyramid, maps: list[Place], sizes: list[Size], taps: list[LsqQuantizer]
) -> Iterator[Op]:
    above: Place | None = None
    merged: list[Place] = []
    for index in reversed(range(len(maps))):
        k, total = index + FIRST_LEVEL, cast(LsqQuantizer, pyramid.sums[index])
        lateral = f"{name}.p{k}.lateral"
        yield from _conv(lateral, maps[index], pyramid.laterals[index], total, sizes[index])
        here = lateral
        if above is not None:
            here, form = f"{name}.p{k}.merged", total.code_format
            low = above[1].code_format.lo
            table = addend_table(above[1], total)
            yield AddOp(here, lateral, above[0], table, form.hi, floor=form.lo, low=low, doubled=True)
        above = here, total
        merged.insert(0, above)
    for index, place in enumerate(merged):
        output = f"{name}.p{index + FIRST_LEVEL}"
        yield from _conv(output, place, pyramid.outputs[index], taps[index], sizes[index])
    yield from _conv(f"{name}.p6", maps[-1], pyramid.top.p6, taps[3], sizes[-1])
    # The ReLU before P7 is the table's: its codes have no negative values.
    p6 = f"{name}.p6", taps[3]
    yield from _conv(f"{name}.p7", p6, pyramid.top.p7, taps[4], _halved(sizes[-1], 1))


def _head(net: SpaceNet, level: int, source: Place, size: Size) -> Iterator[Op]:
    head, prefix = net.head, f"head.p{level + FIRST_LEVEL}"
    scale = head.scales[level].detach().double().item()
    for kind, tower, last, factor in (
        ("class", head.class_tower, head.classes, 1.0),
        ("pose", head.pose_tower, head.pose, scale),
    ):
        convs = [cast(LsqConv2d, conv) for conv in (*tower.convs, last)]
        here = f"{prefix}.{kind}.conv1.input"
        first = convs[0].input_quant
        yield LookupOp(here, source[0], code_table(source[1], first), source[1].code_format.lo)
        for i, (conv, after) in enumerate(pairwise(convs)):
            norms = cast(nn.ModuleList, tower.norms[i])
            affine = fold_batch_norm(
                cast(nn.BatchNorm2d, norms[level]),
                conv.weight_quant.positive_step,
                conv.input_quant.positive_step,
                after.input_quant.positive_step,
            )
            # The ReLU is the clip of the unsigned code.
            made = f"{prefix}.{kind}.conv{i + 2}.input"
            spec = _spec(conv, after.input_quant, size)
            yield ConvOp(made, here, spec, _codes(conv), *affine, derive_requant(spec, *affine))
            here = made
        yield _accumulate(f"{prefix}.{kind}", here, convs[-1], size, factor)


def _conv(
    name: str, source: Place, conv: nn.Module, output: LsqQuantizer, size: Size
) -> Iterator[LookupOp | ConvOp]:
    """Requantisation of the source to the convolution's input, then the convolution with its bias."""
    assert isinstance(conv, LsqConv2d)
    steps = conv.weight_quant.positive_step, conv.input_quant.positive_step, output.positive_step
    table = code_table(source[1], conv.input_quant)
    yield LookupOp(f"{name}.input", source[0], table, source[1].code_format.lo)
    affine = fold_bias(cast(Tensor, conv.bias), *steps)
    spec = _spec(conv, output, size)
    yield ConvOp(name, f"{name}.input", spec, _codes(conv), *affine, derive_requant(spec, *affine))


def _accumulate(name: str, source: str, conv: LsqConv2d, size: Size, factor: float) -> AccumulateOp:
    steps = conv.weight_quant.positive_step, conv.input_quant.positive_step
    scale, offset = fold_bias(cast(Tensor, conv.bias), *steps, torch.ones(()))
    spec = _spec(conv, None, size)
    return AccumulateOp(name, source, spec, _codes(conv), factor * scale, factor * offset)


def _spec(conv: LsqConv2d, output: LsqQuantizer | None, size: Size) -> ConvSpec:
    """Shapes and formats; without a quantiser behind it the output format is the accumulator's."""
    kernel, weight, inputs = conv.kernel_size[0], conv.weight_quant.code_format, conv.input_quant.code_format
    spec = ConvSpec(
        conv.in_channels, conv.out_channels, *size,
        kernel=kernel, stride=conv.stride[0], padding=kernel // 2, weight=weight, input=inputs,
    )  # fmt: skip
    return dataclasses.replace(spec, output=spec.accumulator if output is None else output.code_format)


def _codes(conv: LsqConv2d) -> NDArray[np.int64]:
    return cast(NDArray[np.int64], conv.weight_quant.to_codes(conv.weight).cpu().numpy())


def _halved(size: Size, times: int) -> Size:
    """Rows and columns behind ``times`` strided convolutions."""
    return -(-size[0] >> times), -(-size[1] >> times)
