"""Row engines: 4 neighbouring pixels of one channel times the 3 taps of one kernel row."""

from amaranth.hdl import Module, Shape, signed, unsigned
from amaranth.lib import data, wiring
from amaranth.lib.wiring import In, Out

from macram.spec import GROUP, LANES, TAPS, ArrayConfig, IntFormat, accumulator_range, signed_format_for

__all__ = ["RowEngine", "adder_tree", "hdl_shape", "lane_shape"]


def hdl_shape(format: IntFormat) -> Shape:
    """The Amaranth shape of an integer format."""
    return signed(format.bits) if format.signed else unsigned(format.bits)


def lane_shape(config: ArrayConfig, engines: int = 1) -> Shape:
    """Shape of one lane summed over ``engines`` row engines: exact, 8 bits for one at 3 x 3 bits."""
    return hdl_shape(signed_format_for(*accumulator_range(config.weight, config.input, TAPS * engines)))


def adder_tree(values: list):
    """Balanced sum of ``values``."""
    while len(values) > 1:
        pairs = [a + b for a, b in zip(values[::2], values[1::2], strict=False)]
        values = pairs + values[len(values) & ~1 :]
    return values[0]


class RowEngine(wiring.Component):
    """Twelve products, six lane sums: ``lane[k] = sum of pixel[i] * tap[j] over i + j = k``.

    With taps stored reversed (``tap[j]`` is kernel column ``2 - j``) lane k of pixel group g is a partial sum
    of output column ``4 g + k - 1``. This is the portable kind: plain multipliers, left to the synthesiser.

    Latency is `LATENCY` cycle, throughput one group per cycle; it never stalls.

    Members:
        pixels: In, 4 activations of one channel.
        taps: In, 3 weights.
        lanes: Out, 6 signed sums, exact.
    """

    LATENCY = 1

    def __init__(self, config: ArrayConfig):
        super().__init__({
            "pixels": In(data.ArrayLayout(hdl_shape(config.input), GROUP)),
            "taps": In(data.ArrayLayout(hdl_shape(config.weight), TAPS)),
            "lanes": Out(data.ArrayLayout(lane_shape(config), LANES)),
        })  # fmt: skip

    def elaborate(self, platform):
        m = Module()
        for k in range(LANES):
            products = [self.pixels[k - j] * self.taps[j] for j in range(TAPS) if 0 <= k - j < GROUP]
            m.d.sync += self.lanes[k].eq(adder_tree(products))
        return m
