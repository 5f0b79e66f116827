"""The residual rule: equal to the network's tables, and what it refuses."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from macram.golden import ResidualRule
from macram.spec import IntFormat


@settings(deadline=None, max_examples=60)
@given(bits=st.integers(2, 3), ratio=st.floats(0.01, 90), follow=st.floats(0.001, 3), seed=st.integers(0, 99))
def test_equals_the_tables_of_a_network(bits, ratio, follow, seed):
    """The tables are those of `macram.quant.lower`: steps of branch, stream and next input in any ratio."""
    top = (1 << bits) - 1
    addend = np.rint(np.arange(top + 1) * ratio).astype(np.int64)
    following = np.rint(np.arange(256) * follow).clip(0, top).astype(np.int64)
    rule = ResidualRule.from_tables(IntFormat(bits), addend, following)
    rng = np.random.default_rng(seed)
    branch, stream = rng.integers(0, top + 1, (3, 4, 5)), rng.integers(0, 256, (3, 4, 5))
    sums, codes = rule.apply(branch, stream)
    want = np.clip(stream + addend[branch], 0, 255)
    assert (sums == want).all()
    assert (codes == following[want]).all()


def good():
    return {"branch": IntFormat(3), "table": np.arange(8), "bounds": np.arange(7)}


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"branch": IntFormat(3, signed=True)}, "unsigned codes, not s3"),
        ({"table": np.arange(7)}, "table must be 8 numbers in 0..255"),
        ({"table": np.arange(8) - 1}, "table must be 8 numbers in 0..255"),
        ({"bounds": np.full(7, 256)}, "bounds must be 7 numbers in 0..255"),
        ({"bounds": np.arange(7)[::-1]}, "bounds must ascend"),
    ],
)
def test_refuses(changed, message):
    with pytest.raises(ValueError, match=message):
        ResidualRule(**(good() | changed))


@pytest.mark.parametrize(
    "following", [np.arange(256) // 32 + 1, np.arange(256)[::-1] // 32, np.arange(255) // 32, np.arange(256)]
)
def test_refuses_tables_that_no_rule_gives(following):
    with pytest.raises(ValueError, match="next layer's codes must"):
        ResidualRule.from_tables(IntFormat(3), np.arange(8), following)


def test_refuses_codes_out_of_range():
    rule = ResidualRule(**good())
    zeros = np.zeros((1, 2, 2), np.int64)
    for branch, stream, message in (
        (zeros + 8, zeros, "branch"),
        (zeros, zeros - 1, "stream must lie"),
        (zeros, zeros[0], "stream must be"),
    ):
        with pytest.raises(ValueError, match=message):
            rule.apply(branch, stream)
