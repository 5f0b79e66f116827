"""The golden model: what every layer computes, in NumPy integers."""

from macram.golden.cases import KINDS, random_case, selftest_case
from macram.golden.conv import conv2d
from macram.golden.formula import bias_and_shift, float_code
from macram.golden.requant import Distance, ShiftRequant, ThresholdRequant, derive_requant
from macram.golden.residual import ResidualRule
from macram.golden.run import accumulate, float_codes, run_layer

__all__ = [
    "KINDS",
    "Distance",
    "ResidualRule",
    "ShiftRequant",
    "ThresholdRequant",
    "accumulate",
    "bias_and_shift",
    "conv2d",
    "derive_requant",
    "float_code",
    "float_codes",
    "random_case",
    "run_layer",
    "selftest_case",
]
