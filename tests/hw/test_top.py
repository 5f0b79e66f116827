"""The registers that describe the array: each field at the bits that the register map names."""

import re
from dataclasses import replace

import pytest

from macram.spec import ArrayConfig, IntFormat
from macram.spec.registers import BY_NAME
from macram_hw.top import capabilities

BASE = ArrayConfig(units=32, rows=5, drain=2, max_c_in=37, max_c_out=96, weight_depth=70, row_words=34)
FIELD = re.compile(r"([a-z ]+) (\d+):(\d+)(?: \(signed (\d+)\))?")


def fields_of(register, value):
    """``{field: value}`` and ``{field: signed}`` as the description of the register places them."""
    found = FIELD.findall(BY_NAME[register].description)
    assert found, f"{register} describes no fields"
    numbers, signs, known = {}, {}, 0
    for name, high, low, sign in found:
        width = int(high) - int(low) + 1
        numbers[name.strip()] = value >> int(low) & ((1 << width) - 1)
        known |= ((1 << width) - 1) << int(low)
        if sign:
            signs[name.strip()] = value >> int(sign) & 1
            known |= 1 << int(sign)
    assert not value & ~known, f"{register} sets bits that its description does not name: {value:#x}"
    return numbers, signs


@pytest.mark.parametrize("signed", [False, True])
def test_formats(signed):
    array = replace(BASE, weight=IntFormat(5, signed=True), input=IntFormat(6, signed=signed),
                    output=IntFormat(7, signed=not signed))  # fmt: skip
    numbers, signs = fields_of("FORMATS", capabilities(array)["formats"].value)
    assert numbers == {"weight": 5, "input": 6, "output": 7}
    assert signs == {"input": signed, "output": not signed}


@pytest.mark.parametrize("array", [BASE, ArrayConfig()], ids=["odd", "reference"])
def test_geometry_and_channels(array):
    values = capabilities(array)
    numbers, _ = fields_of("GEOMETRY", values["geometry"].value)
    assert numbers == {"units": array.units, "row engines per unit": array.rows, "drain": array.drain}
    numbers, _ = fields_of("MAX_CHANNELS", values["max_channels"].value)
    assert numbers == {"input channels": array.max_c_in, "output channels": array.max_c_out}


def test_plain_numbers():
    values = {name: value.value for name, value in capabilities(BASE).items()}
    assert (values["weight_depth"], values["row_words"], values["residual"]) == (70, 34, 0)
    assert capabilities(replace(BASE, residual_stream_bits=128))["residual"].value == 128


def test_every_value_is_a_read_only_register_of_the_map():
    for name in capabilities(BASE):
        assert BY_NAME[name.upper()].access == "RO"
