"""Mixed precision: where bfloat16 helps, and the few layers that stay in float32."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import torch
from torch import Tensor, nn

from macram.model.fpn import PyramidTop
from macram.model.head import PoseHead


def autocast_helps(device: torch.device) -> bool:
    """Whether the processor multiplies bfloat16 in hardware."""
    if device.type == "cuda":
        return bool(torch.cuda.is_bf16_supported(including_emulation=False))
    try:
        flags = Path("/proc/cpuinfo").read_text()
    except OSError:
        return False
    return "avx512_bf16" in flags or "amx_bf16" in flags


@contextmanager
def exact_layers(module: nn.Module, device: torch.device) -> Iterator[None]:
    """While open, the layers that need it run in float32 inside autocast.

    The head's last convolutions: their outputs are pixels after a multiplication by up to 512, and eight bits of
    mantissa are too few. On the CPU also P6 and P7: PyTorch 2.13 (oneDNN 3.12) leaves weight gradients of a
    strided bfloat16 convolution unwritten where taps meet nothing but padding, which happens on maps one column
    wide, and small views end in such maps.
    """
    opened: list[torch.autocast] = []

    def before(layer: nn.Module, args: tuple[Any, ...]) -> tuple[Any, ...]:
        opened.append(torch.autocast(device.type, enabled=False))
        opened[-1].__enter__()  # type: ignore[no-untyped-call]
        return (args[0].float(),)

    def after(layer: nn.Module, args: tuple[Any, ...], output: Tensor) -> None:
        opened.pop().__exit__(None, None, None)

    handles = []
    for layer in _layers(module, device):
        handles.append(layer.register_forward_pre_hook(before))
        handles.append(layer.register_forward_hook(after, always_call=True))
    try:
        yield
    finally:
        for handle in handles:
            handle.remove()


def _layers(module: nn.Module, device: torch.device) -> Iterator[nn.Module]:
    for part in module.modules():
        if isinstance(part, PoseHead):
            yield from (layer for layer in (part.classes, part.pose, part.surface) if layer is not None)
        if isinstance(part, PyramidTop) and device.type == "cpu":
            yield from (part.p6, part.p7)
