"""How far the training graph, in float32, is from the deployed integers: codes that differ, layer by layer."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, cast

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn

from macram.model import SpaceNet
from macram.quant.deploy import DeployedNetwork, host_codes
from macram.quant.lower_spacenet import lower_network
from macram.quant.lsq import LsqQuantizer
from macram.quant.network import QuantDarkNet53
from macram.quant.program import AccumulateOp, Codes, Program


def training_codes(
    net: nn.Module,
    image: Tensor,
    program: Program,
    depth: int | None = None,
    *,
    given: Mapping[str, Tensor] | None = None,
) -> dict[str, Codes]:
    """The codes that the float32 training graph rounds to, under the names of the program's tensors.

    Sums that leave as accumulators are in no quantiser and so not among them.

    Args:
        net: quantised backbone or whole network, in evaluation mode.
        image: ``[3, H, W]``, normalised.
        program: lowered from ``net``; its tensors stand in the order of the graph's activation quantisers.
        depth: of a backbone, stages to run, enough for the program.
        given: codes by name, from `DeployedNetwork`. Behind every quantiser the graph goes on with these instead
            of its own, so that a layer's difference is its own and not what earlier ones have passed on.
    """
    names = [program.input, *(op.name for op in program.ops if not isinstance(op, AccumulateOp))]
    recorded: list[Codes] = []

    def record(module: nn.Module, args: tuple[Any, ...], output: Tensor) -> Tensor | None:
        assert isinstance(module, LsqQuantizer)
        if len(recorded) == len(names):
            return None
        recorded.append(module.to_codes(args[0])[0].numpy())
        return None if given is None else given[names[len(recorded) - 1]][None] * module.positive_step

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
    training: Mapping[str, Codes], deployed: Mapping[str, NDArray[np.integer]]
) -> dict[str, float]:
    """Share of codes, 0 to 1, in which the training graph and the deployed network differ, per tensor.

    Raises:
        ValueError: the two do not hold the same tensors.
    """
    if training.keys() != deployed.keys():
        raise ValueError(f"tensors differ: {sorted(training.keys() ^ deployed.keys())}")
    return {name: float(np.mean(training[name] != deployed[name])) for name in training}


def layer_differences(net: SpaceNet, images: Sequence[Tensor]) -> list[dict[str, Any]]:
    """Every layer of a whole network, training graph against deployed integers, over some pictures.

    Args:
        net: deployable, quantised in mode III, in evaluation mode.
        images: ``[3, H, W]`` each, normalised, all of one size.

    Returns:
        Rows in the order of execution: ``name``; ``codes``, how many were compared; ``alone``, the share of them
        that differs, 0 to 1, when the layer reads the deployed codes; ``accumulated``, when it reads its own
        predecessors' as in training; ``largest``, the largest difference of ``alone``, in codes.

    Raises:
        ValueError: the network has no integer form; see `lower_network`.
    """
    program = lower_network(net, *images[0].shape[1:])
    run = DeployedNetwork(program)
    rows: dict[str, dict[str, Any]] = {}
    for image in images:
        tensors = run(host_codes(cast(QuantDarkNet53, net.backbone), image))
        alone = training_codes(net, image, program, given=tensors)
        accumulated = training_codes(net, image, program)
        for name, codes in alone.items():
            deployed = tensors[name].numpy()
            row = rows.setdefault(
                name, {"name": name, "codes": 0, "alone": 0.0, "accumulated": 0.0, "largest": 0}
            )
            row["codes"] += codes.size
            row["largest"] = max(row["largest"], int(np.abs(codes - deployed).max()))
            row["alone"] += float(np.mean(codes != deployed)) / len(images)
            row["accumulated"] += float(np.mean(accumulated[name] != deployed)) / len(images)
    return list(rows.values())
