"""The quantisation-aware DarkNet: the training graph, in floating point, with every LSQ quantiser in place.

Every convolution but the first takes quantised activations and weights. The residual stream of a stage is
quantised too, finely and with one step per stage, and so is each branch before it is added: then the sum is
an integer sum when the network is deployed, and each convolution's input is a coarser requantisation of it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import cast

from torch import Tensor, nn
from torch.nn import functional

from macram.model import ConvBlock, DarkNet53, ResidualUnit, Stage
from macram.model.backbone import rectified
from macram.quant.lsq import LsqQuantizer
from macram.spec import IntFormat


@dataclass(frozen=True, slots=True)
class Precision:
    """Code formats of a quantised network.

    Attributes:
        weight: convolution weights.
        activation: convolution inputs and residual branches.
        stream: residual streams.
        per_channel: one weight step per output channel instead of one per layer.

    Raises:
        ValueError: weights are unsigned, or activations or streams signed (they follow a ReLU).
    """

    weight: IntFormat = IntFormat(3, signed=True)
    activation: IntFormat = IntFormat(3)
    stream: IntFormat = IntFormat(8)
    per_channel: bool = False

    def __post_init__(self) -> None:
        if not self.weight.signed:
            raise ValueError(f"weight must be a signed format, not {self.weight}")
        for name in ("activation", "stream"):
            if getattr(self, name).signed:
                raise ValueError(f"{name} must be an unsigned format, not {getattr(self, name)}")

    @property
    def signed_activation(self) -> IntFormat:
        """As ``activation``, for convolution inputs that may be negative."""
        return IntFormat(self.activation.bits, signed=True)

    @property
    def signed_stream(self) -> IntFormat:
        """As ``stream``, for sums and differences that may be negative."""
        return IntFormat(self.stream.bits, signed=True)


class QuantDarkNet53(nn.Module):
    """The training graph of a quantised backbone. Shares (not copies) the parameters of ``model``.

    Weight steps are initialised from the weights; activation steps are NaN until calibrated or loaded.

    Raises:
        ValueError: the backbone is leaky, which unsigned activation codes cannot follow.
    """

    def __init__(self, model: DarkNet53, precision: Precision) -> None:
        super().__init__()
        if model.config.activation != "relu":
            raise ValueError(f"a quantised backbone needs activation 'relu', not {model.config.activation!r}")
        self.precision = precision
        self.init = model.init  # stays in float32, on the host
        self.stages = nn.ModuleList(QuantStage(cast(Stage, stage), precision) for stage in model.stages)

    def forward(self, image: Tensor, depth: int | None = None) -> tuple[Tensor, ...]:
        """``[N, 3, H, W]`` -> one map per stage as `DarkNet53.forward`, on the stages' stream steps."""
        x: Tensor = self.init(image)
        maps = []
        for stage in self.stages[:depth]:
            x = stage(x)
            maps.append(x)
        return tuple(maps)

    def activation_quantizers(self) -> Iterator[LsqQuantizer]:
        """Every quantiser but the weights'."""
        return (m for m in self.modules() if isinstance(m, LsqQuantizer) and m.batched)


class QuantStage(nn.Module):
    """`Stage` with its residual stream on one quantiser."""

    def __init__(self, stage: Stage, precision: Precision) -> None:
        super().__init__()
        self.entry = QuantConv(stage.entry, precision)
        self.stream_quant = LsqQuantizer(precision.stream, batched=True)
        self.units = nn.ModuleList(QuantUnit(cast(ResidualUnit, unit), precision) for unit in stage.units)

    def forward(self, x: Tensor) -> Tensor:
        """``[N, C, H, W]`` -> ``[N, 2C, H/2, W/2]``."""
        stream: Tensor = self.stream_quant(self.entry(x))
        for unit in self.units:
            stream = self.stream_quant(stream + unit(stream))
        return stream


class QuantUnit(nn.Module):
    """The branch of a residual unit; the stage adds it to its stream."""

    def __init__(self, unit: ResidualUnit, precision: Precision) -> None:
        super().__init__()
        self.reduce = QuantConv(unit.reduce, precision)
        self.expand = QuantConv(unit.expand, precision)
        self.branch_quant = LsqQuantizer(precision.activation, batched=True)

    def forward(self, x: Tensor) -> Tensor:
        """``[N, C, H, W]`` stream -> the addend of the same shape."""
        return cast(Tensor, self.branch_quant(self.expand(self.reduce(x))))


class QuantConv(nn.Module):
    """A convolution block on quantised input and weights, followed by batch normalisation and ReLU."""

    def __init__(self, block: ConvBlock, precision: Precision) -> None:
        super().__init__()
        self.conv, self.bn = block.conv, block.bn
        weight = self.conv.weight.detach()
        shape = (weight.shape[0], 1, 1, 1) if precision.per_channel else ()
        self.input_quant = LsqQuantizer(precision.activation, batched=True)
        self.weight_quant = LsqQuantizer(precision.weight, step_shape=shape, batched=False)
        magnitude = weight.abs().double()
        self.weight_quant.set_step(
            magnitude.mean((1, 2, 3), keepdim=True) if precision.per_channel else magnitude.mean()
        )

    def forward(self, x: Tensor) -> Tensor:
        """``[N, c_in, H, W]`` -> ``[N, c_out, H/stride, W/stride]``, not yet quantised."""
        y = functional.conv2d(
            self.input_quant(x),
            self.weight_quant(self.conv.weight),
            stride=self.conv.stride,
            padding=cast(tuple[int, int], self.conv.padding),
        )
        return rectified(self.bn, y)
