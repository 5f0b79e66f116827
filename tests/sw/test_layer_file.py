from __future__ import annotations

import io
import os
import zipfile

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from macram.golden import KINDS, random_case
from macram.layer_file import LayerCase
from macram.spec import ConvSpec, IntFormat

ARRAYS = ("weights", "input", "scale", "offset")
SEED = int(os.environ.get("SEED", "11"))


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


@pytest.mark.parametrize("dtype", [np.float16, np.float32, np.float64, np.longdouble])
def test_any_floating_type_is_kept_as_float64(tmp_path, dtype):
    values = np.array([0.5, -0.25, 0.1, 3], dtype)
    np.savez(tmp_path / "a.npz", **entries(scale=values, offset=values))
    case = LayerCase.load(tmp_path / "a.npz")
    assert case.scale.dtype == case.offset.dtype == np.float64
    assert np.array_equal(case.scale, values.astype(np.float64))


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
        ({"offset": np.zeros(4, int)}, "offset must hold floating-point numbers, not int64; use astype"),
        ({"scale": np.zeros(4, complex)}, "scale must hold floating-point numbers, not complex128"),
        ({"scale": np.full(4, "1.0")}, "scale must hold floating-point numbers, not <U3"),
        ({"scale": np.full(4, np.longdouble("1e400"))}, "scale must be finite, not inf in channel 0"),
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


def npy(array):
    stream = io.BytesIO()
    np.save(stream, array)
    return stream.getvalue()


def archive(path, method=zipfile.ZIP_STORED, **members):
    """A layer file whose members ``members`` replace by raw bytes."""
    raw = {key: npy(np.asarray(value)) for key, value in entries().items()} | members
    with zipfile.ZipFile(path, "w", method) as file:
        for key, content in raw.items():
            file.writestr(f"{key}.npy", content)


def claims_too_much(path):
    header = npy(np.zeros(4))[:128]
    archive(path, scale=header.replace(b"(4,), }" + 14 * b" ", b"(100000000000000,), }"))
    assert b"(100000000000000,)" in path.read_bytes()


def damaged_lzma(path):
    archive(path, zipfile.ZIP_LZMA, weights=npy(np.random.default_rng(1).bytes(4000)))
    raw = bytearray(path.read_bytes())
    raw[300:600] = b"\xff" * 300
    path.write_bytes(raw)


def encrypted(path):
    archive(path)
    raw = bytearray(path.read_bytes())
    for mark, flags in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        at = -1
        while (at := raw.find(mark, at + 1)) >= 0:
            raw[at + flags] |= 1
    path.write_bytes(raw)


def unknown_compression(path):
    archive(path)
    raw = bytearray(path.read_bytes())
    at = raw.find(b"PK\x01\x02")
    raw[at + 10 : at + 12] = b"\x63\x00"
    path.write_bytes(raw)


def one_array(path):
    path.write_bytes(npy(np.zeros(3)))


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (claims_too_much, "claims arrays that do not fit into memory; save plain arrays with numpy.savez"),
        (damaged_lzma, "is not a whole .npz file of plain arrays; save"),
        (encrypted, "is not a whole .npz file of plain arrays; save"),
        (unknown_compression, "is not a whole .npz file of plain arrays; save"),
        (one_array, "is not a whole .npz file of plain arrays; save"),
        (lambda path: archive(path, scale=b"not an array"), "key 'scale' is not an array; save"),
        (lambda path: archive(path, scale=b""), "key 'scale' is not an array; save"),
    ],
)
def test_hostile_files_are_refused_in_one_line(tmp_path, spoil, words):
    path = tmp_path / "hostile.npz"
    spoil(path)
    with pytest.raises(ValueError, match=f": {words}") as caught:
        LayerCase.load(path)
    assert str(caught.value).startswith(f"{path}: ")
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    "method", [zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED, zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA]
)
def test_any_damage_is_refused_or_harmless(tmp_path, method):
    path, rng = tmp_path / "damaged.npz", np.random.default_rng(SEED)
    archive(path, method)
    whole, lines = path.read_bytes(), []
    for _ in range(150):
        raw = bytearray(whole)
        for at in rng.integers(0, len(raw), rng.integers(1, 9)):
            raw[at] = rng.integers(256)
        path.write_bytes(raw)
        try:
            LayerCase.load(path)
        except ValueError as error:
            lines.append(str(error))
    assert len(lines) > 20
    assert not [line for line in lines if "\n" in line or not line.startswith(f"{path}: ")], SEED


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
