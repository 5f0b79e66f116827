"""The self-test layer: admitted by every array, the same everywhere, and worth running."""

import tomllib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from macram.golden import run_layer, selftest_case
from macram.pack import pack_layer
from macram.spec import ArrayConfig, IntFormat

CONFIGS = sorted((Path(__file__).resolve().parents[2] / "configs").glob("*.toml"))
ARRAYS = [path for path in CONFIGS if "array" in tomllib.loads(path.read_text())]


@pytest.mark.parametrize("path", ARRAYS, ids=lambda path: path.stem)
@pytest.mark.parametrize("bits", [3, 8])
def test_every_array_admits_it_and_most_codes_occur(path, bits):
    # Its own geometry; plain multipliers take any formats, the residual adder does not.
    array = replace(ArrayConfig.from_toml(path), engine="portable", soft_rows=0, residual_stream_bits=0)
    array = replace(array, input=IntFormat(bits), output=IntFormat(bits), weight=IntFormat(bits, signed=True))
    case = selftest_case(array)
    pack_layer(case, array)
    counts = np.bincount(run_layer(case).ravel(), minlength=1 << bits)
    assert np.count_nonzero(counts) > 0.9 * len(counts)
    assert counts.max() < 0.5 * counts.sum()


def test_it_is_the_reference_layer_on_the_reference_array():
    spec = selftest_case(ArrayConfig()).spec
    assert (spec.c_in, spec.c_out, spec.height, spec.width) == (64, 128, 128, 128)


def test_scales_and_offsets_are_exact_binary_fractions():
    case = selftest_case(ArrayConfig())
    assert np.array_equal(np.ldexp(np.round(np.ldexp(case.offset, 20)), -20), case.offset)
    assert set(np.sign(case.scale)) == {-1.0, 0.0, 1.0}
    assert np.array_equal(case.scale, selftest_case(ArrayConfig()).scale)
