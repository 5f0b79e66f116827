from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from macram.spec import IntFormat, StreamLayout, words_to_beats


@st.composite
def maps(draw):
    form = IntFormat(draw(st.integers(1, 8)), draw(st.booleans()))
    layout = StreamLayout(draw(st.integers(1, 70)), form, draw(st.sampled_from([8, 32, 64, 128])))
    shape = layout.channels, draw(st.integers(1, 4)), draw(st.integers(1, 4))
    rng = np.random.default_rng(draw(st.integers(0, 2**32)))
    return layout, rng.integers(form.lo, form.hi, shape, endpoint=True)


@settings(deadline=None, max_examples=100)
@given(maps())
def test_beats_hold_pixels_in_order_channel_0_lowest(case):
    layout, codes = case
    beats = layout.pack(codes)
    _, height, width = codes.shape
    assert beats.dtype == np.uint8
    assert beats.shape == (height * width * layout.beats_per_pixel, layout.beat_bits // 8)
    size = layout.beats_per_pixel * layout.beat_bits // 8
    raw = beats.tobytes()
    for pixel, (y, x) in enumerate(np.ndindex(height, width)):
        number = int.from_bytes(raw[pixel * size : (pixel + 1) * size], "little")
        bits = layout.format.bits
        wanted = sum((int(code) % (1 << bits)) << (c * bits) for c, code in enumerate(codes[:, y, x]))
        assert number == wanted  # nothing but zeros above the last channel
    assert np.array_equal(layout.unpack(beats, height, width), codes)


def test_reference_pixel_is_three_beats():
    assert StreamLayout(64, IntFormat(3), 64).beats_per_pixel == 3
    assert StreamLayout(128, IntFormat(3), 64).beats_per_pixel == 6


@given(st.integers(1, 200), st.sampled_from([32, 64, 512]), st.data())
def test_parameter_words_go_low_beat_first(word_bits, beat_bits, data):
    words = data.draw(st.lists(st.integers(0, (1 << word_bits) - 1), min_size=1, max_size=5))
    beats = words_to_beats(words, word_bits, beat_bits)
    each = -(-word_bits // beat_bits)
    assert beats.shape == (each * len(words), beat_bits // 8)
    for index, word in enumerate(words):
        for k in range(each):
            found = int.from_bytes(beats[index * each + k].tobytes(), "little")
            assert found == (word >> (k * beat_bits)) & ((1 << beat_bits) - 1)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ((0, IntFormat(3), 64), "channels must be at least 1, not 0"),
        ((1, IntFormat(3), 12), "beat_bits must be a positive multiple of 8, not 12"),
        ((1, IntFormat(3), 0), "beat_bits must be a positive multiple of 8, not 0"),
        ((1, IntFormat(9), 64), "codes must have at most 8 bits, not 9"),
    ],
)
def test_bad_layouts_are_refused(arguments, words):
    with pytest.raises(ValueError, match=words):
        StreamLayout(*arguments)


def test_bad_maps_are_refused():
    layout = StreamLayout(2, IntFormat(3), 64)
    with pytest.raises(ValueError, match=r"codes must be \[2, height, width\], not \[3, 1, 1\]"):
        layout.pack(np.zeros((3, 1, 1), int))
    with pytest.raises(ValueError, match=r"codes must lie in 0\.\.7, not 0\.\.8"):
        layout.pack(np.array([[[0]], [[8]]]))
    with pytest.raises(ValueError, match="2x2 pixels are 4 beats, not 3"):
        layout.unpack(np.zeros((3, 8), np.uint8), 2, 2)
