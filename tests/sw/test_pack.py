from __future__ import annotations

import dataclasses
import hashlib
import json
import time
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from macram.golden import ThresholdRequant, derive_requant, random_case
from macram.pack import BIT_ORDER, PackedLayer, pack_layer, read_packed, unpack
from macram.spec import ArrayConfig, ConvSpec, IntFormat

CONFIGS = Path(__file__).parents[2] / "configs"
TINY = ArrayConfig.from_toml(CONFIGS / "tiny.toml")
REFERENCE = ArrayConfig.from_toml(CONFIGS / "reference.toml")
S3, S8, U8 = IntFormat(3, signed=True), IntFormat(8, signed=True), IntFormat(8)


def layer_for(array, c_in, c_out, height=5, width=7):
    formats = {"weight": array.weight, "input": array.input, "output": array.output}
    return ConvSpec(c_in, c_out, height, width, **formats)


def field(word, low, bits, *, signed):
    """Bits low..low+bits-1 of a Python integer."""
    value = (word >> low) & ((1 << bits) - 1)
    return value - (1 << bits) if signed and value >> (bits - 1) else value


def same_requant(one, other):
    names = [f.name for f in dataclasses.fields(one)]
    return type(one) is type(other) and all(
        np.array_equal(getattr(one, name), getattr(other, name)) for name in names
    )


@st.composite
def packings(draw):
    drain = draw(st.sampled_from([1, 2, 4]))
    units = 4 * drain * draw(st.integers(1, 2))
    array = ArrayConfig(
        name="drawn",
        units=units,
        rows=draw(st.sampled_from([1, 2, 4, 8])),
        weight=IntFormat(draw(st.integers(2, 8)), signed=True),
        input=IntFormat(draw(st.integers(2, 8)), signed=draw(st.booleans())),
        output=IntFormat(draw(st.integers(2, 8)), signed=draw(st.booleans())),
        max_c_in=draw(st.integers(7, 40)),
        max_c_out=units * draw(st.integers(1, 3)),
        weight_depth=128,
        row_words=256,
        stream_bits=draw(st.sampled_from([32, 64, 128])),
        drain=drain,
    )
    kernel = draw(st.sampled_from([1, 3]))
    # Many blocks of a 1x1 kernel put its tiles in threes.
    c_in = st.integers(1, 7) if kernel == 3 else st.sampled_from([5, array.max_c_in])
    spec = dataclasses.replace(
        layer_for(array, draw(c_in), draw(st.integers(1, array.max_c_out)), 5, draw(st.integers(6, 9))),
        kernel=kernel,
        stride=draw(st.sampled_from([1, 2])),
        padding=kernel // 2,
        input=IntFormat(array.input.bits, signed=array.input.signed or draw(st.booleans())),
    )
    return random_case(
        spec, draw(st.integers(0, 2**32)), draw(st.sampled_from(["uniform", "extremes"]))
    ), array


@settings(deadline=None, max_examples=60)
@given(packings())
def test_every_weight_field_lies_where_the_contract_says(packing):
    case, array = packing
    packed, bits, blocks = pack_layer(case, array), array.weight.bits, array.blocks(case.spec.c_in)
    assert packed.weight_words == array.weight_words(case.spec)
    for u in range(array.units):
        words = packed.unit_words(u)
        for address, word in enumerate(words):
            assert 0 <= word < 1 << array.weight_word_bits
            phases, triples = array.phases(case.spec), array.triples(case.spec)
            rest, cb = divmod(address, blocks)
            rest, phase = divmod(rest, phases)
            tile, ky = divmod(rest, case.spec.kernel)
            tiles = [tile] * 3
            # Field j of the pixel in column 4 g + p counts towards column 4 g + p + j - 1.
            taps = {(1, 1): [None, 0, None], (3, 1): [2, 1, 0]}.get(
                (case.spec.kernel, phases), [[None, 1, None], [None, 2, 0]][phase]
            )
            if triples:
                alone = tile >= triples
                taps = [0, None, None] if alone else [0, 0, 0]
                tiles = [tile + 2 * triples] * 3 if alone else [3 * tile, 3 * tile + 1, 3 * tile + 2]
            for r in range(array.rows):
                for j in range(3):
                    out, inp = tiles[j] * array.units + u, cb * array.rows + r
                    inside = out < case.spec.c_out and inp < case.spec.c_in and taps[j] is not None
                    wanted = case.weights[out, inp, ky, taps[j]] if inside else 0
                    assert field(word, (r * 3 + j) * bits, bits, signed=True) == wanted


@settings(deadline=None, max_examples=60)
@given(packings())
def test_every_requantiser_field_lies_where_the_contract_says(packing):
    case, array = packing
    packed = pack_layer(case, array)
    requant = derive_requant(case.spec, case.scale, case.offset)
    acc, entry = array.accumulator, array.requant_entry_bits
    spec, half = case.spec, 1 << (array.input.bits - 1) if array.biased(case.spec) else 0
    # Padding that no step reads: left of column 0, and right of a last column that ends its group of four.
    left = half if spec.kernel == 3 else 0
    right = half if spec.kernel == 3 and spec.stride == 1 and spec.width % 4 == 0 else 0
    words = packed.requant_ints()
    assert len(words) == packed.requant_words == array.tiles(case.spec.c_out) * array.units // array.drain
    for address, word in enumerate(words):
        assert 0 <= word < 1 << array.requant_word_bits
        tile, d = divmod(address, array.units // array.drain)
        for q in range(array.drain):
            c, low = tile * array.units + d * array.drain + q, q * entry
            inside = c < case.spec.c_out
            total = half * int(case.weights[c].sum()) if inside else 0
            if array.thresholds:
                found = [
                    field(word, low + i * acc.bits, acc.bits, signed=True) for i in range(array.thresholds)
                ]
                zero = -array.output.lo if array.output.signed else 0
                absent = [acc.lo] * zero + [acc.hi] * (array.thresholds - zero)
                end = low + array.thresholds * acc.bits
                wanted = (requant.thresholds[c] + total).clip(acc.lo, acc.hi).tolist() if inside else absent
                assert found == wanted
                assert field(word, end, 1, signed=False) == (inside and requant.invert[c])
                end += 1
            else:
                end = low + 72
                assert field(word, low, 18, signed=True) == (requant.mult[c] if inside else 0)
                assert field(word, low + 18, 48, signed=True) == (
                    requant.offset[c] - total * requant.mult[c] if inside else 0
                )
                assert field(word, low + 66, 6, signed=False) == (requant.shift[c] if inside else 0)
            if array.border is None:
                assert low + entry == end
                continue
            for at, part, column in ((end, left, 0), (end + array.border.bits, right, -1)):
                outer = part * int(case.weights[c, :, :, column].sum()) if inside else 0
                assert field(word, at, array.border.bits, signed=True) == outer
            assert low + entry == end + 2 * array.border.bits


@settings(deadline=None, max_examples=60)
@given(packings())
def test_unpack_is_the_inverse(packing):
    case, array = packing
    weights, requant = unpack(pack_layer(case, array))
    assert np.array_equal(weights, case.weights)
    wanted = derive_requant(case.spec, case.scale, case.offset)
    if not array.biased(case.spec):
        assert same_requant(requant, wanted)
    # Every sum that these weights can give; of raised codes, thresholds beyond them may have moved.
    inputs = case.spec.input
    above, below = case.weights.clip(min=0).sum(axis=(1, 2, 3)), case.weights.clip(max=0).sum(axis=(1, 2, 3))
    lows, highs = above * inputs.lo + below * inputs.hi, above * inputs.hi + below * inputs.lo
    sums = np.linspace(lows, highs, 200).round().astype(np.int64).T
    assert np.array_equal(requant.apply(sums), wanted.apply(sums))


@settings(deadline=None, max_examples=15)
@given(packings())
def test_files_are_read_back_as_written(tmp_path_factory, packing):
    case, array = packing
    folder = tmp_path_factory.mktemp("packed") / "new" / "layer"
    packed = pack_layer(case, array)
    packed.write(folder)
    back = read_packed(folder)
    assert (back.spec, back.array) == (packed.spec, packed.array)
    assert np.array_equal(back.weights, packed.weights)
    assert np.array_equal(back.requant, packed.requant)
    assert [path.name for path in folder.parent.iterdir()] == ["layer"]


@settings(deadline=None, max_examples=25)
@given(packings())
def test_load_beats_carry_the_words_unit_by_unit(packing):
    case, array = packing
    packed = pack_layer(case, array)
    weights, requant = packed.load_beats()
    every = [word for u in range(array.units) for word in packed.unit_words(u)]
    for beats, words, width in (
        (weights, every, array.weight_word_bits),
        (requant, packed.requant_ints(), array.requant_word_bits),
    ):
        per_word = -(-width // array.stream_bits)
        assert beats.shape == (len(words) * per_word, array.stream_bits // 8)
        numbers = [int.from_bytes(beat.tobytes(), "little") for beat in beats]
        for index, word in enumerate(words):
            chunk = numbers[index * per_word : (index + 1) * per_word]
            assert sum(part << (i * array.stream_bits) for i, part in enumerate(chunk)) == word


def test_one_known_word_by_hand():
    spec = layer_for(TINY, 3, 9)
    case = random_case(spec, 0, "zero")
    weights = np.zeros((9, 3, 3, 3), np.int64)
    weights[8, 2, 1] = [1, -4, 3]  # unit 0, tile 1, kernel row 1, block 1, row engine 0
    weights[8, 1, 1] = [-1, 0, 2]  # block 0, row engine 1
    case = dataclasses.replace(case, weights=weights, scale=np.zeros(9), offset=np.zeros(9))
    packed = pack_layer(case, TINY)
    words = packed.unit_words(0)
    assert len(words) == 2 * 3 * 2
    assert words[(1 * 3 + 1) * 2 + 1] == 0b000_000_000_001_100_011
    assert words[(1 * 3 + 1) * 2 + 0] == 0b111_000_010_000_000_000
    assert sum(map(bool, words)) == 2
    assert not packed.weights[1:].any()


def test_three_tiles_share_a_word():
    array = dataclasses.replace(TINY, max_c_in=32, weight_depth=80, row_words=64)
    spec = dataclasses.replace(layer_for(array, 32, 32, 2, 4), kernel=1, padding=0)
    weights = np.zeros((32, 32, 1, 1), np.int64)
    weights[[3, 11, 19, 27], 30] = np.array([1, -4, 3, -2])[:, None, None]  # unit 3, block 15, row engine 0
    case = dataclasses.replace(random_case(spec, 0), weights=weights)
    packed = pack_layer(case, array)
    words = packed.unit_words(3)
    assert (array.triples(spec), len(words)) == (1, 2 * 16)
    assert (words[15], words[31]) == (0b011_100_001, 0b110)
    assert sum(map(bool, words)) == 2


def test_reference_layer_packs_within_a_second():
    case = random_case(ConvSpec(64, 128, 128, 128), seed=5)
    start = time.perf_counter()
    packed = pack_layer(case, REFERENCE)
    assert time.perf_counter() - start < 1
    assert packed.weights.shape == (64, 48, 9)
    assert packed.requant.shape == (32, 4 * (7 * 19 + 1 + 2 * 17) // 8)
    assert packed.requantiser == "threshold"


def test_memory_files_are_full_padded_and_described(tmp_path):
    case = random_case(layer_for(TINY, 5, 11), seed=2)
    packed = pack_layer(case, TINY)
    packed.write(tmp_path)
    stems = [f"unit_{u:03d}" for u in range(8)] + ["requant"]
    names = [stem + suffix for stem in stems for suffix in (".mem", ".coe")]
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted([*names, "manifest.json"])
    for stem, words, depth, bits in (
        ("unit_003", packed.unit_words(3), TINY.weight_depth, TINY.weight_word_bits),
        ("requant", packed.requant_ints(), TINY.requant_depth, TINY.requant_word_bits),
    ):
        lines = (tmp_path / f"{stem}.mem").read_text().splitlines()
        comments = [line for line in lines if line.startswith("//")]
        body = [line for line in lines if not line.startswith("//")]
        assert lines == comments + body
        assert "5 -> 11 channels" in comments[0]
        assert f"{depth} words of {bits} bits" in comments[1]
        assert len(body) == depth
        assert {len(line) for line in body} == {-(-bits // 4)}
        assert [int(line, 16) for line in body[: len(words)]] == words
        coe = (tmp_path / f"{stem}.coe").read_text()
        head, _, vector = coe.partition("memory_initialization_vector=")
        assert "memory_initialization_radix=16;" in head
        assert all(line.startswith(";") for line in head.splitlines()[:-1])
        assert vector.endswith(";\n")
        assert vector.strip().rstrip(";").replace("\n", "").split(",") == body
    # The requantiser beyond the layer's channels gives the code field 0.
    last = int(body[-1], 16)
    acc = TINY.accumulator
    assert [field(last, i * acc.bits, acc.bits, signed=True) for i in range(7)] == [acc.hi] * 7
    manifest = json.loads((tmp_path / "manifest.json").read_text())
    assert (manifest["format"], manifest["version"]) == ("macram packed layer", 1)
    assert manifest["array"] == TINY.to_dict()
    assert manifest["layer"]["c_out"] == 11
    assert manifest["requantiser"] == "threshold"
    assert manifest["bit_order"]["requant"] == BIT_ORDER["threshold"]
    assert manifest["sha256"] == {
        name: hashlib.sha256((tmp_path / name).read_bytes()).hexdigest() for name in names
    }


def test_writing_is_reproducible_and_replaces_an_earlier_layer(tmp_path):
    one, two = tmp_path / "one", tmp_path / "two"
    big = ArrayConfig.from_dict({**TINY.to_dict(), "units": 16, "name": "wide"})
    pack_layer(random_case(layer_for(big, 4, 16), seed=1), big).write(one)
    (one / "notes.txt").write_text("mine")
    packed = pack_layer(random_case(layer_for(TINY, 4, 16), seed=1), TINY)
    packed.write(one)
    packed.write(two)
    assert (one / "notes.txt").read_text() == "mine"
    (one / "notes.txt").unlink()
    assert {p.name: p.read_bytes() for p in one.iterdir()} == {p.name: p.read_bytes() for p in two.iterdir()}


def flip_digit(path):
    text = path.read_text()
    path.write_text(text[:-2] + ("1" if text[-2] == "0" else "0") + text[-1])


def edit(key, value):
    def change(folder):
        path = folder / "manifest.json"
        manifest = json.loads(path.read_text())
        manifest[key] = value(manifest[key]) if callable(value) else value
        path.write_text(json.dumps(manifest))

    return change


def short_memory(folder):
    path = folder / "unit_001.mem"
    path.write_text(path.read_text().rsplit("\n", 2)[0] + "\n")
    edit("sha256", lambda sums: {**sums, path.name: hashlib.sha256(path.read_bytes()).hexdigest()})(folder)


@pytest.mark.parametrize(
    ("damage", "words"),
    [
        (lambda f: flip_digit(f / "unit_002.mem"), r"unit_002\.mem: SHA-256 is .*, the manifest has"),
        (lambda f: flip_digit(f / "requant.coe"), r"requant\.coe: SHA-256"),
        (lambda f: (f / "unit_000.mem").unlink(), r"unit_000\.mem: No such file"),
        (lambda f: (f / "manifest.json").unlink(), r"manifest\.json: no such file"),
        (lambda f: (f / "manifest.json").write_text("{"), r"manifest\.json: "),
        (lambda f: (f / "manifest.json").write_text("[]"), "is not a macram packed layer"),
        (edit("version", 2), "is not a macram packed layer, version 1"),
        (edit("sha256", lambda sums: {"../unit_000.mem": "0"}), "does not list the files of this array"),
        (edit("layer", lambda layer: {**layer, "kernel": 5}), "kernel must be 1 or 3, not 5"),
        (edit("layer", lambda layer: {**layer, "depth": 5}), "depth"),
        (edit("layer", lambda layer: {**layer, "c_in": 99}), "c_in must be at most 16, not 99"),
        (edit("layer", lambda layer: {"c_in": 4}), "key 'weight' is missing"),
        (edit("array", lambda array: {**array, "units": 16}), "does not list the files of this array"),
        (edit("array", lambda array: {**array, "units": 3}), "units must be in 4"),
        (short_memory, r"unit_001\.mem: must have 64 words, not 63"),
    ],
)
def test_damaged_folders_are_refused(tmp_path, damage, words):
    pack_layer(random_case(layer_for(TINY, 4, 8), seed=3), TINY).write(tmp_path)
    read_packed(tmp_path)
    damage(tmp_path)
    with pytest.raises(ValueError, match=words) as caught:
        read_packed(tmp_path)
    assert "\n" not in str(caught.value)
    assert str(tmp_path) in str(caught.value)


def test_a_layer_the_array_does_not_admit_is_refused():
    case = random_case(ConvSpec(4, 8, 5, 5, padding=0), seed=0)
    with pytest.raises(ValueError, match="runs 3x3 kernels with padding 1 and 1x1 kernels with padding 0"):
        pack_layer(case, TINY)
    with pytest.raises(ValueError, match="c_in must be at most 16, not 17"):
        pack_layer(random_case(layer_for(TINY, 17, 8), seed=0), TINY)


def test_nothing_is_left_where_nothing_can_be_written(tmp_path):
    packed = pack_layer(random_case(layer_for(TINY, 4, 8), seed=3), TINY)
    taken = tmp_path / "taken"
    taken.write_text("a file")
    with pytest.raises(ValueError, match=r"taken: cannot be written, .*; choose another folder"):
        packed.write(taken)
    with pytest.raises(ValueError, match="cannot be written"):
        packed.write(taken / "below")
    assert [path.name for path in tmp_path.iterdir()] == ["taken"]
    assert taken.read_text() == "a file"


def test_words_that_do_not_fit_are_refused():
    packed = pack_layer(random_case(layer_for(TINY, 4, 8), seed=3), TINY)
    with pytest.raises(ValueError, match=r"weights must be uint8 \[8, 6, 3\], not uint8 \[7, 6, 3\]"):
        PackedLayer(packed.spec, TINY, packed.weights[1:], packed.requant)
    wide = packed.weights.copy()
    wide[0, 0, 2] |= 4  # bit 18 of an 18-bit word
    with pytest.raises(ValueError, match="weights words must have at most 18 bits"):
        PackedLayer(packed.spec, TINY, wide, packed.requant)


def test_a_flipped_bit_changes_what_is_unpacked():
    case = random_case(layer_for(TINY, 4, 8), seed=3)
    packed = pack_layer(case, TINY)
    weights = packed.weights.copy()
    weights[5, 1, 0] ^= 1
    changed, _ = unpack(dataclasses.replace(packed, weights=weights))
    assert (changed != case.weights).sum() == 1
    requant = packed.requant.copy()
    invert = TINY.thresholds * TINY.accumulator.bits
    requant[0, invert // 8] ^= 1 << invert % 8
    _, turned = unpack(dataclasses.replace(packed, requant=requant))
    assert isinstance(turned, ThresholdRequant)
    assert turned.invert[0] != unpack(packed)[1].invert[0]
