"""The feature pyramid: five levels of equal channels from the last three maps of the backbone.

There is no activation and no normalisation between input and output, except the ReLU before P7.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import cast

import torch
from torch import Tensor, nn
from torch.nn import functional

from macram.model.backbone import bare_conv


class PyramidTop(nn.Module):
    """P6 and P7: two strided convolutions on C5.

    Args:
        c_in: channels of C5.
        channels: channels of the pyramid.
    """

    def __init__(self, c_in: int, channels: int) -> None:
        super().__init__()
        self.p6 = bare_conv(c_in, channels, kernel=3, stride=2, bias=True)
        self.p7 = bare_conv(channels, channels, kernel=3, stride=2, bias=True)


class FeaturePyramid(nn.Module):
    """P3 to P7. Weights are uninitialised until `initialise`.

    Attributes:
        laterals: 1x1 convolutions of C3, C4, C5.
        outputs: 3x3 convolutions that make P3, P4, P5.
        top: makes P6 and P7; another pyramid's may be put here.
        sums: called on every lateral map and on every sum of the top-down path, one per level P3 to P5.
            Identity here; quantised networks put a quantiser in each place.

    Args:
        inputs: channels of C3, C4, C5.
        channels: channels of every level.
    """

    def __init__(self, inputs: Sequence[int], channels: int) -> None:
        super().__init__()
        self.laterals = nn.ModuleList(bare_conv(c, channels, kernel=1, bias=True) for c in inputs)
        self.outputs = nn.ModuleList(bare_conv(channels, channels, kernel=3, bias=True) for _ in inputs)
        self.top = PyramidTop(inputs[-1], channels)
        self.sums = nn.ModuleList(nn.Identity() for _ in inputs)

    def initialise(self, generator: torch.Generator) -> None:
        """Kaiming-uniform weights (a = 1), biases zero."""
        for module in self.modules():
            if isinstance(module, nn.Conv2d):
                nn.init.kaiming_uniform_(module.weight, a=1, generator=generator)
                nn.init.zeros_(cast(Tensor, module.bias))

    def forward(self, maps: Sequence[Tensor], taps: Sequence[nn.Module]) -> tuple[Tensor, ...]:
        """C3, C4, C5 ``[N, c, H/8, W/8]`` to ``[N, c, H/32, W/32]`` -> P3 to P7, ``[N, channels, ...]``.

        Args:
            maps: sides double from one to the next above.
            taps: one per level, called on each output.
        """
        merged: list[Tensor] = []
        for lateral, add, x in reversed(list(zip(self.laterals, self.sums, maps, strict=True))):
            y: Tensor = add(lateral(x))
            if merged:
                y = add(y + functional.interpolate(merged[-1], scale_factor=2.0, mode="nearest"))
            merged.append(y)
        merged.reverse()
        levels = [
            tap(output(x)) for output, tap, x in zip(self.outputs, taps[: len(merged)], merged, strict=True)
        ]
        p6: Tensor = taps[3](self.top.p6(maps[-1]))
        return (*levels, p6, taps[4](self.top.p7(functional.relu(p6))))
