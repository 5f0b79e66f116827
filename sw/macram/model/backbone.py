"""DarkNet-53, the backbone of CA-SpaceNet (the residual network of YOLOv3, without its classifier).

A 3x3 convolution, then five stages that each halve the image: one strided 3x3 block and a few residual units.
At width 1 and stages (1, 2, 8, 8, 4) these are 52 convolutions with 40,549,216 weights.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import cast

import torch
from torch import Tensor, nn

ACTIVATIONS = ("relu", "leaky")
LEAK = 0.1
"""Slope of the published network's LeakyReLU; ReLU is what unsigned activation codes need."""
INIT_CHANNELS = 32
"""Channels of the first convolution at width 1; stage k has ``32 * 2**k``."""
FRONT_STAGES = 2
"""Stages that keep ``width`` when ``late_width`` differs: those up to the reference layer."""


@dataclass(frozen=True, slots=True)
class BackboneConfig:
    """Shape of a DarkNet.

    Attributes:
        width: channel multiplier, 1 for the published network; ``32 * width`` must be a whole number.
        stages: residual units per stage; one stage per entry.
        activation: ``relu`` (quantised networks) or ``leaky`` (the published floating-point weights).
        late_width: the multiplier from stage 3 on; None for ``width`` throughout.

    Raises:
        ValueError: a field is out of range.
    """

    width: float = 1.0
    stages: tuple[int, ...] = (1, 2, 8, 8, 4)
    activation: str = "relu"
    late_width: float | None = None

    def __post_init__(self) -> None:
        for field, width in (("width", self.width), ("late_width", self._late)):
            channels = INIT_CHANNELS * width
            if not (channels >= 1 and channels == int(channels)):
                raise ValueError(f"{field} must be a positive multiple of 1/{INIT_CHANNELS}, not {width!r}")
        if not self.stages or min(self.stages) < 0:
            raise ValueError(f"stages must be unit counts of at least 0, not {self.stages!r}")
        if self.activation not in ACTIVATIONS:
            raise ValueError(f"activation must be one of {', '.join(ACTIVATIONS)}, not {self.activation!r}")

    @property
    def channels(self) -> tuple[int, ...]:
        """Output channels of the first convolution and of every stage: (32, 64, ..., 1024) at width 1."""
        widths = [self.width if k <= FRONT_STAGES else self._late for k in range(len(self.stages) + 1)]
        return tuple(int(INIT_CHANNELS * width) << k for k, width in enumerate(widths))

    @property
    def _late(self) -> float:
        return self.width if self.late_width is None else self.late_width


class DarkNet53(nn.Module):
    """The backbone, with seeded weights: Kaiming-normal convolutions, identity batch normalisation.

    Args:
        config: widths, depths, activation.
        generator: source of the initial weights. The global random state is neither read nor changed.
    """

    def __init__(self, config: BackboneConfig, generator: torch.Generator) -> None:
        super().__init__()
        self.config = config
        first, *rest = config.channels
        self.init = ConvBlock(3, first, kernel=3, stride=1, activation=config.activation)
        self.stages = nn.ModuleList(
            Stage(c_in, c_out, units, config.activation)
            for c_in, c_out, units in zip(config.channels, rest, config.stages, strict=False)
        )
        self.initialise(generator)

    def initialise(self, generator: torch.Generator) -> None:
        """Draws every convolution weight anew, in the order of `modules`."""
        slope = 0.0 if self.config.activation == "relu" else LEAK
        for module in self.modules():
            if isinstance(module, nn.Conv2d):
                nn.init.kaiming_normal_(module.weight, a=slope, generator=generator)

    def forward(self, image: Tensor, depth: int | None = None) -> tuple[Tensor, ...]:
        """``[N, 3, H, W]`` -> one map per stage, ``[N, 64, H/2, W/2]`` to ``[N, 1024, H/32, W/32]``.

        Args:
            image: normalised image; H and W are multiples of 32 for exact halving.
            depth: run only this many stages.
        """
        x: Tensor = self.init(image)  # [N, 32, H, W]
        maps = []
        for stage in self.stages[:depth]:
            x = stage(x)  # [N, 64 << k, H >> (k + 1), W >> (k + 1)]
            maps.append(x)
        return tuple(maps)


class Stage(nn.Module):
    """A strided block that halves the image and doubles the channels, then residual units."""

    def __init__(self, c_in: int, c_out: int, units: int, activation: str) -> None:
        super().__init__()
        self.entry = ConvBlock(c_in, c_out, kernel=3, stride=2, activation=activation)
        self.units = nn.ModuleList(ResidualUnit(c_out, activation) for _ in range(units))

    def forward(self, x: Tensor) -> Tensor:
        """``[N, C, H, W]`` -> ``[N, 2C, H/2, W/2]``."""
        x = self.entry(x)
        for unit in self.units:
            x = unit(x)
        return x


class ResidualUnit(nn.Module):
    """1x1 to half the channels, 3x3 back, plus the input; nothing follows the sum."""

    def __init__(self, channels: int, activation: str) -> None:
        super().__init__()
        self.reduce = ConvBlock(channels, channels // 2, kernel=1, stride=1, activation=activation)
        self.expand = ConvBlock(channels // 2, channels, kernel=3, stride=1, activation=activation)

    def forward(self, x: Tensor) -> Tensor:
        """``[N, C, H, W]`` -> the same shape."""
        return cast(Tensor, self.expand(self.reduce(x), plus=x))


class ConvBlock(nn.Module):
    """Convolution without bias, batch normalisation, activation; in residual units the sum too."""

    def __init__(self, c_in: int, c_out: int, *, kernel: int, stride: int, activation: str) -> None:
        super().__init__()
        self.conv = bare_conv(c_in, c_out, kernel=kernel, stride=stride, bias=False)
        self.bn = nn.BatchNorm2d(c_out)
        self.act = nn.ReLU() if activation == "relu" else nn.LeakyReLU(LEAK)

    def forward(self, x: Tensor, plus: Tensor | None = None) -> Tensor:
        """``[N, c_in, H, W]`` -> ``[N, c_out, H/stride, W/stride]``, to which ``plus`` is added."""
        y: Tensor = self.conv(x)
        if isinstance(self.act, nn.ReLU):
            return rectified(self.bn, y, plus)
        return summed(self.act(self.bn(y)), plus)


def rectified(norm: nn.Module, x: Tensor, plus: Tensor | None = None) -> Tensor:
    """``relu(norm(x))``, and ``plus`` added: by the layer's own method ``rectified`` where it has one."""
    if together := getattr(norm, "rectified", None):
        return cast(Tensor, together(x, plus))
    return summed(torch.relu(norm(x)), plus)


def summed(y: Tensor, plus: Tensor | None) -> Tensor:
    """``plus + y``, or ``y`` where there is nothing to add."""
    return y if plus is None else plus + y


def bare_conv(c_in: int, c_out: int, *, kernel: int, stride: int = 1, bias: bool) -> nn.Conv2d:
    """A padded convolution whose weights and bias wait for their initial values, on the default device."""
    # On "meta" nothing is initialised: the default would draw from the global random state, to no use.
    conv = nn.Conv2d(c_in, c_out, kernel, stride=stride, padding=kernel // 2, bias=bias, device="meta")
    return conv.to_empty(device=torch.get_default_device())
