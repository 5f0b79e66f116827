"""The whole array with every width of weights, activations and outputs from 2 to 8 bits, in Amaranth's simulator."""

import pytest
from test_array_streams import SMALL, run_two_images

from macram.spec import ArrayConfig, IntFormat


@pytest.mark.parametrize(
    ("weight", "act", "output"),
    [("s2", "u2", "u2"), ("s4", "u4", "u4"), ("s5", "u8", "s6"), ("s6", "s5", "u5"), ("s7", "u6", "s8"),
     ("s8", "s7", "u7"), ("s2", "u8", "u3"), ("s8", "u2", "s2")],
)  # fmt: skip
@pytest.mark.parametrize(("c_in", "stride"), [(5, 1), (2, 2)])
def test_codes_and_cycles(weight, act, output, c_in, stride):
    formats = {
        key: IntFormat(int(text[1:]), signed=text[0] == "s")
        for key, text in (("weight", weight), ("input", act), ("output", output))
    }
    run_two_images(ArrayConfig(**SMALL, **formats), (c_in, 7, 3, 5, 3, stride, 1), 0.0, 0.0, kind="extremes")
