"""The whole network prepared for quantisation-aware training, in the paper's modes I, II and III.

Every convolution of the mode takes LSQ-quantised input and weights, one step each; the first convolution is
float32 in every mode. A deployable network also gets quantisers on everything that is added up: residual
streams, the pyramids' top-down sums, and the levels with their difference. Then every sum is one of integers.
"""

from __future__ import annotations

import copy
from typing import cast

from torch import Tensor, nn
from torch.nn import functional

from macram.model import DarkNet53, SpaceNet
from macram.model.counts import part_of, quantised_parts
from macram.quant.lsq import LsqQuantizer
from macram.quant.network import Precision, QuantDarkNet53
from macram.spec import IntFormat


class LsqConv2d(nn.Conv2d):
    """A convolution on quantised input and weights. Shares (not copies) the parameters of ``conv``.

    Args:
        conv: to be replaced; parameter names stay the same.
        input_format: signed where the input may be negative.
        weight_format: signed.
        per_channel: one weight step per output channel.
    """

    def __init__(
        self, conv: nn.Conv2d, input_format: IntFormat, weight_format: IntFormat, *, per_channel: bool = False
    ) -> None:
        kernel, stride = cast(tuple[int, int], conv.kernel_size), cast(tuple[int, int], conv.stride)
        padding = cast(tuple[int, int], conv.padding)
        bias = conv.bias is not None
        super().__init__(
            conv.in_channels, conv.out_channels, kernel, stride, padding, bias=bias, device="meta"
        )
        self.weight, self.bias = conv.weight, conv.bias
        shape = (conv.out_channels, 1, 1, 1) if per_channel else ()
        self.input_quant = LsqQuantizer(input_format, batched=True)
        self.weight_quant = LsqQuantizer(weight_format, step_shape=shape, batched=False)
        magnitude = conv.weight.detach().abs().double()
        self.weight_quant.set_step(
            magnitude.mean((1, 2, 3), keepdim=True) if per_channel else magnitude.mean()
        )

    def forward(self, input: Tensor) -> Tensor:
        """``[N, c_in, H, W]`` -> ``[N, c_out, H/stride, W/stride]``, not yet quantised."""
        return functional.conv2d(
            self.input_quant(input),
            self.weight_quant(self.weight),
            self.bias,
            cast(tuple[int, int], self.stride),
            cast(tuple[int, int], self.padding),
        )


def quantise(model: SpaceNet, mode: str, precision: Precision) -> SpaceNet:
    """A copy of a float network with LSQ quantisers; weight steps set, activation steps NaN until calibrated.

    Parameters keep their names, except for what quantisers add, so float state dicts load with
    ``strict=False``. The training-only surface head is not quantised.

    Args:
        model: as trained in floating point; left unchanged.
        mode: ``I`` backbone, ``II`` pyramids too, ``III`` head too.
        precision: formats; where values may be negative, the signed formats of the same bits.

    Raises:
        ValueError: ``mode`` is unknown.
    """
    parts = quantised_parts(mode)
    net = copy.deepcopy(model)
    if net.config.deployable:
        net.backbone = QuantDarkNet53(cast(DarkNet53, net.backbone), precision)
        if "pyramids" in parts:
            _quantise_sums(net, precision)
    leaky = net.config.backbone.activation == "leaky"
    for prefix, parent in list(net.named_modules()):  # a shared top appears once
        if net.config.deployable and prefix.startswith("backbone"):
            continue
        for child, conv in list(parent.named_children()):
            name = f"{prefix}.{child}"
            if type(conv) is nn.Conv2d and part_of(name) in parts and name != "head.surface":
                signed = _input_is_signed(name, leaky=leaky)
                form = precision.signed_activation if signed else precision.activation
                quantised = LsqConv2d(conv, form, precision.weight, per_channel=precision.per_channel)
                setattr(parent, child, quantised)
    return net


def _quantise_sums(net: SpaceNet, precision: Precision) -> None:
    for pyramid in (net.fpn, net.fpn_pseudo):
        if pyramid is not None:
            pyramid.sums = _signed_quantizers(len(pyramid.sums), precision)
    net.taps = _signed_quantizers(len(net.taps), precision)


def _signed_quantizers(count: int, precision: Precision) -> nn.ModuleList:
    return nn.ModuleList(LsqQuantizer(precision.signed_stream, batched=True) for _ in range(count))


def _input_is_signed(name: str, *, leaky: bool) -> bool:
    """Whether a convolution of `SpaceNet` may see negative values, by its name there."""
    if name.startswith("head."):
        return name.endswith("tower.convs.0")  # the pyramid's features; the others follow a ReLU
    if ".outputs." in name:
        return True  # sums of lateral maps
    return leaky and not name.endswith(".p7")  # P7 reads behind a ReLU; the others read the backbone
