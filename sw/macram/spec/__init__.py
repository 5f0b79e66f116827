"""Frozen, validated objects that the golden model, the packer and the gateware are all built from."""

from macram.spec.array import ArrayConfig
from macram.spec.fixed import ENGINE_LATENCY, GROUP, LANES, MAX_SIDE, RESIDUAL, TAPS
from macram.spec.formats import IntFormat, ceil_div, parse_format, signed_format_for
from macram.spec.layer import ConvSpec, accumulator_format, accumulator_range
from macram.spec.passes import LayerPass, layer_passes
from macram.spec.place import BOTTOM, TOP, Place, fit_together
from macram.spec.registers import BY_NAME, REGISTERS, Control, Error, Register, Status
from macram.spec.stream import StreamLayout, words_to_beats
from macram.spec.sums import SumLayout

__all__ = [
    "BOTTOM",
    "BY_NAME",
    "ENGINE_LATENCY",
    "GROUP",
    "LANES",
    "MAX_SIDE",
    "REGISTERS",
    "RESIDUAL",
    "TAPS",
    "TOP",
    "ArrayConfig",
    "Control",
    "ConvSpec",
    "Error",
    "IntFormat",
    "LayerPass",
    "Place",
    "Register",
    "Status",
    "StreamLayout",
    "SumLayout",
    "accumulator_format",
    "accumulator_range",
    "ceil_div",
    "fit_together",
    "layer_passes",
    "parse_format",
    "signed_format_for",
    "words_to_beats",
]
