"""Convolutions with a single output channel on the CPU, as matrix products.

oneDNN computes a whole vector of output channels whether one is wanted or sixteen: the head's class predictor
takes as long as its pose predictor.
"""

from __future__ import annotations

from typing import cast

from torch import Tensor, nn
from torch.nn import functional


class NarrowConv2d(nn.Conv2d):
    """A convolution that is a product while training: every tap's share of each pixel, then their sums."""

    def forward(self, input: Tensor) -> Tensor:
        """``[N, C, H, W]`` -> ``[N, 1, H, W]``; up to rounding `torch.nn.Conv2d`'s."""
        if not self.training:
            return super().forward(input)
        n, c, h, w = input.shape
        kernel, padding = (cast(tuple[int, int], size) for size in (self.kernel_size, self.padding))
        # [taps, C]; flipped, as pixels give what outputs take.
        taps = self.weight[0].reshape(c, -1).flip(1).mT
        shares = taps @ input.permute(0, 2, 3, 1).reshape(n, h * w, c).mT  # [N, taps, H W]
        y = functional.fold(shares, (h, w), kernel, padding=padding)
        return y if self.bias is None else y + self.bias


def narrow_convolutions(module: nn.Module) -> None:
    """Turns every convolution in ``module`` that fits into a `NarrowConv2d`, in place.

    One output channel, stride 1, a kernel of several taps, zeros around and as many outputs as inputs.
    """
    for layer in module.modules():
        if type(layer) is not nn.Conv2d or layer.out_channels > 1 or layer.groups > 1:
            continue
        same = layer.padding == tuple((side - 1) // 2 for side in layer.kernel_size)
        plain = set(layer.stride) == set(layer.dilation) == {1} and all(k % 2 for k in layer.kernel_size)
        if same and plain and layer.kernel_size != (1, 1) and layer.padding_mode == "zeros":
            # The same parameters, names and state under another forward, as for several processes.
            layer.__class__ = NarrowConv2d
