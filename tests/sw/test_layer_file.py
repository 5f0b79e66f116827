from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from macram.golden import KINDS, random_case
from macram.layer_file import LayerCase
from macram.spec import ConvSpec, IntFormat

ARRAYS = ("weights", "input", "scale", "offset")


def entries(**changes):
    """The keys of a good file, some replaced; a key set to None is left out."""
    case = random_case(ConvSpec(3, 4, 5, 6), seed=1)
    good = {
        **{key: getattr(case, key) for key in ARRAYS},
        "weight_bits": 3, "input_bits": 3, "output_bits": 3, "stride": 1, "padding": 1,
    }  # fmt: skip
    return {key: value for key, value in {**good, **changes}.items() if value is not None}


@st.composite
def cases(draw):
    kernel = draw(st.sampled_from([1, 3]))
    spec = ConvSpec(
        c_in=draw(st.integers(1, 4)),
        c_out=draw(st.integers(1, 4)),
        height=draw(st.integers(3, 6)),
        width=draw(st.integers(3, 6)),
        kernel=kernel,
        stride=draw(st.sampled_from([1, 2])),
        padding=draw(st.sampled_from([0, kernel // 2])),
        weight=IntFormat(draw(st.integers(2, 8)), signed=True),
        input=IntFormat(draw(st.integers(2, 8)), signed=draw(st.booleans())),
        output=IntFormat(draw(st.integers(2, 8)), signed=draw(st.booleans())),
    )
    return random_case(spec, draw(st.integers(0, 2**32)), draw(st.sampled_from(KINDS)))


@settings(deadline=None, max_examples=50)
@given(cases())
def test_save_then_load_changes_nothing(tmp_path_factory, case):
    path = tmp_path_factory.mktemp("layer") / "layer.npz"
    case.save(path)
    back = LayerCase.load(path)
    assert back.spec == case.spec
    for key in ARRAYS:
        assert np.array_equal(getattr(back, key), getattr(case, key))
        assert getattr(back, key).dtype == getattr(case, key).dtype
    assert [p.name for p in path.parent.iterdir()] == ["layer.npz"]


@pytest.mark.parametrize("bits", [7, 8])
@pytest.mark.parametrize("signed", [False, True])
def test_the_widest_codes_survive_their_stored_type(tmp_path, bits, signed):
    spec = ConvSpec(2, 2, 4, 4, weight=IntFormat(8, signed=True), input=IntFormat(bits, signed))
    case = random_case(spec, 0, "extremes")
    case.save(tmp_path / "a.npz")
    assert np.array_equal(LayerCase.load(tmp_path / "a.npz").input, case.input)


@pytest.mark.parametrize("dtype", [np.int8, np.uint8, np.int16, np.int64])
def test_any_integer_type_and_absent_switches(tmp_path, dtype):
    good = entries()
    np.savez(tmp_path / "a.npz", **{**good, "input": good["input"].astype(dtype)})
    case = LayerCase.load(tmp_path / "a.npz")
    assert case.spec == ConvSpec(3, 4, 5, 6)
    assert np.array_equal(case.input, good["input"])
    assert case.input.dtype == np.int64


def test_switches_make_signed_formats(tmp_path):
    np.savez(tmp_path / "a.npz", **entries(input=np.full((3, 5, 6), -4), input_signed=1, output_signed=1))
    spec = LayerCase.load(tmp_path / "a.npz").spec
    assert (str(spec.input), str(spec.output)) == ("s3", "s3")


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"bias": np.zeros(4)}, "unknown key 'bias'; remove it"),
        ({"scale": None}, "key 'scale' is missing; add it"),
        ({"stride": None}, "key 'stride' is missing"),
        (
            {"weights": np.zeros((4, 3, 3), int)},
            r"weights must have the shape \[c_out, c_in, k, k\], not \[4, 3, 3\]",
        ),
        ({"weights": np.zeros((4, 3, 3, 1), int)}, "square kernel, not 3x1"),
        ({"weights": np.zeros((4, 3, 5, 5), int)}, "kernel must be 1 or 3, not 5"),
        ({"weights": np.zeros((4, 2, 3, 3), int)}, r"input must have the shape \[2, 5, 6\], not \[3, 5, 6\]"),
        (
            {"weights": np.full((4, 3, 3, 3), 4)},
            r"weights codes must lie in -4\.\.3 \(s3\), not 4; .*weight_bits",
        ),
        ({"weights": np.full((4, 3, 3, 3), -5)}, r"not -5"),
        ({"weights": np.zeros((4, 3, 3, 3))}, "weights must hold integer codes, not float64; round"),
        ({"weights": np.zeros((4, 3, 3, 3), bool)}, "weights must hold integer codes, not bool"),
        ({"input": np.full((3, 5, 6), 8)}, r"input codes must lie in 0\.\.7 \(u3\), not 8"),
        ({"input": np.full((3, 5, 6), -1)}, "not -1"),
        ({"input": np.full((3, 5, 6), 2**64 - 1, np.uint64)}, "not 18446744073709551615"),
        ({"input": np.zeros((3, 5, 6), np.float32)}, "input must hold integer codes, not float32"),
        ({"input": np.zeros((1, 3, 5, 6), int)}, r"input must have the shape \[c_in, height, width\]"),
        ({"input": np.zeros((3, 0, 6), int)}, "height must be at least 1, not 0"),
        ({"scale": np.ones(3)}, r"scale must have the shape \[4\], one per output channel, not \[3\]"),
        ({"scale": np.array([1, np.nan, 1, 1])}, "scale must be finite, not nan in channel 1"),
        ({"offset": np.array([1, 1, 1, -np.inf])}, "offset must be finite, not -inf in channel 3"),
        ({"offset": np.zeros(4, int)}, "offset must be float64, not int64"),
        ({"scale": np.zeros(4, complex)}, "scale must be float64, not complex128"),
        ({"weight_bits": 9}, r"weight_bits must be in 2\.\.8, not 9"),
        ({"input_bits": 1}, r"input_bits must be in 2\.\.8, not 1"),
        ({"output_bits": 3.0}, "output_bits must be one integer, not float64"),
        ({"output_bits": [3, 3]}, r"output_bits must be one integer, not int64 of shape \[2\]"),
        ({"stride": 3}, "stride must be 1 or 2, not 3"),
        ({"padding": 2}, "padding of a 3x3 kernel must be 0 or 1, not 2"),
        ({"input_signed": 2}, "input_signed must be 0 or 1, not 2"),
        ({"input": np.array([None])}, "plain arrays"),
    ],
)
def test_bad_files_are_refused_in_one_line(tmp_path, changes, words):
    path = tmp_path / "bad.npz"
    np.savez(path, **entries(**changes))
    with pytest.raises(ValueError, match=words) as caught:
        LayerCase.load(path)
    assert str(caught.value).startswith(f"{path}: ")
    assert "\n" not in str(caught.value)


def test_files_that_are_no_layers_are_refused(tmp_path):
    good = tmp_path / "good.npz"
    np.savez(good, **entries())
    squeezed = tmp_path / "squeezed.npz"
    np.savez_compressed(squeezed, **entries())
    bad = {
        "text.npz": b"hello",
        "empty.npz": b"",
        "zip.npz": b"PK\x03\x04 broken",
        "cut.npz": good.read_bytes()[:-40],
        "squeezed.npz": squeezed.read_bytes()[:80] + b"\xff" * 20 + squeezed.read_bytes()[100:],
        "torn.npz": good.read_bytes()[:200] + b"\xff" * 50 + good.read_bytes()[250:],
    }
    np.save(tmp_path / "array.npy", np.zeros(3))
    for name, raw in bad.items():
        (tmp_path / name).write_bytes(raw)
    for name in [*bad, "array.npy", "absent.npz", "."]:
        with pytest.raises(ValueError, match=r"cannot be read|no such file|savez") as caught:
            LayerCase.load(tmp_path / name)
        assert str(caught.value).startswith(str(tmp_path / name))
        assert "\n" not in str(caught.value)


def test_save_into_nowhere_is_refused(tmp_path):
    with pytest.raises(ValueError, match="cannot be written, No such file"):
        random_case(ConvSpec(1, 1, 3, 3), 0).save(tmp_path / "no" / "a.npz")
    assert not list(tmp_path.iterdir())


def test_a_case_cannot_be_changed_behind_its_back():
    codes = np.zeros((1, 3, 3), np.int64)
    case = LayerCase(ConvSpec(1, 1, 3, 3), np.zeros((1, 1, 3, 3), np.int64), codes, np.ones(1), np.ones(1))
    codes[:] = 99
    assert not case.input.any()
    with pytest.raises(ValueError, match="read-only"):
        case.input[0] = 1


def test_random_cases_depend_on_the_seed_alone():
    spec = ConvSpec(3, 9, 5, 6)
    one, two, three = random_case(spec, 4), random_case(spec, 4), random_case(spec, 5)
    for key in ARRAYS:
        assert np.array_equal(getattr(one, key), getattr(two, key))
        assert not np.array_equal(getattr(one, key), getattr(three, key))
    impulse = random_case(spec, 4, "impulse")
    assert np.count_nonzero(impulse.weights) == 9
    assert np.count_nonzero(impulse.input) == 3
    assert set(np.unique(random_case(spec, 4, "extremes").weights)) == {-4, 3}
    with pytest.raises(ValueError, match=r"kind must be one of uniform, .*, not 'mean'"):
        random_case(spec, 4, "mean")
