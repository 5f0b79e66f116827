"""What codes need before they mean anything: batch-normalisation statistics and activation steps."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import torch
from torch import Tensor, nn

from macram.quant.lsq import LsqQuantizer


def calibrate_batch_norm(model: nn.Module, images: Tensor, depth: int | None = None) -> None:
    """Sets the running statistics to those of one batch, for a network that has not been trained.

    Args:
        model: backbone or whole network; left in evaluation mode. What it keeps in evaluation mode while it
            trains (a frozen backbone) is not touched.
        images: ``[N, 3, H, W]``, one batch.
        depth: of a backbone, stages to run; later ones keep mean 0 and variance 1.
    """
    model.train()
    layers = [m for m in model.modules() if isinstance(m, nn.BatchNorm2d) and m.training]
    momenta = [layer.momentum for layer in layers]
    for layer in layers:
        layer.reset_running_stats()
        layer.momentum = None  # cumulative: after one batch the statistics are that batch's
    with torch.no_grad():
        _run(model, images, depth)
    for layer, momentum in zip(layers, momenta, strict=True):
        layer.momentum = momentum
    model.eval()


def calibrate_steps(net: nn.Module, images: Tensor, depth: int | None = None) -> dict[str, float]:
    """Sets every reached activation step to ``2 * mean|v| / sqrt(Qp)`` of the unquantised values it sees.

    A stage's stream passes its quantiser once per unit; all passes count.

    Args:
        net: quantised backbone or whole network, left in evaluation mode; weight steps are not touched.
        images: ``[N, 3, H, W]``, one batch.
        depth: of a backbone, stages to run; the steps of later ones stay NaN.

    Returns:
        The steps set, by the quantiser's name in ``net``.

    Raises:
        ValueError: a quantiser saw only zeros, so no step fits it.
    """
    net.eval()
    with _observed(net) as totals, torch.no_grad():
        _run(net, images, depth)
    names = {quantizer: name for name, quantizer in net.named_modules()}
    steps = {}
    for quantizer, (total, count) in totals.items():
        name = names[quantizer]
        if not total > 0:
            raise ValueError(
                f"{name} saw only zeros or NaN on the calibration images; use other images or weights"
            )
        quantizer.set_step(total / count)
        steps[name] = float(quantizer.positive_step)
    return steps


def _run(net: nn.Module, images: Tensor, depth: int | None) -> None:
    if depth is None:
        net(images)
    else:
        net(images, depth)


@contextmanager
def _observed(net: nn.Module) -> Iterator[dict[LsqQuantizer, tuple[float, int]]]:
    """While open, all quantisers pass values through; yields sum and count of |v| of the activations."""
    totals: dict[LsqQuantizer, tuple[float, int]] = {}

    def observe(quantizer: LsqQuantizer, v: Tensor) -> None:
        if quantizer.batched:
            total, count = totals.get(quantizer, (0.0, 0))
            totals[quantizer] = total + v.abs().sum().item(), count + v.numel()

    quantizers = [m for m in net.modules() if isinstance(m, LsqQuantizer)]
    for quantizer in quantizers:
        quantizer.observer = observe
    try:
        yield totals
    finally:
        for quantizer in quantizers:
            quantizer.observer = None
