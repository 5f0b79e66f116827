"""How codes travel on the AXI4-Streams.

A feature map goes pixel by pixel, row by row. A pixel's codes lie side by side, channel 0 in the least
significant bits, and every pixel is padded with zeros to whole beats, so a pixel address is a beat address.
TLAST marks the last beat of the image. Parameter words go low beat first, each padded to whole beats.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from macram.spec.formats import IntFormat, ceil_div


@dataclass(frozen=True, slots=True)
class StreamLayout:
    """Layout of ``channels`` codes of ``format`` per pixel on beats of ``beat_bits``.

    Raises:
        ValueError: ``beat_bits`` is not a multiple of 8, ``channels`` is below 1, or codes exceed 8 bits.
    """

    channels: int
    format: IntFormat
    beat_bits: int

    def __post_init__(self) -> None:
        if self.channels < 1:
            raise ValueError(f"channels must be at least 1, not {self.channels}")
        if self.format.bits > 8:
            raise ValueError(f"codes must have at most 8 bits, not {self.format.bits}")
        if self.beat_bits < 8 or self.beat_bits % 8:
            raise ValueError(f"beat_bits must be a positive multiple of 8, not {self.beat_bits}")

    @property
    def beats_per_pixel(self) -> int:
        """Beats of one pixel (3 for 64 channels of 3 bits on 64 bits)."""
        return ceil_div(self.channels * self.format.bits, self.beat_bits)

    def pack(self, codes: NDArray[np.integer]) -> NDArray[np.uint8]:
        """``[channels, height, width]`` codes -> ``[beats, beat_bits // 8]`` bytes, low byte first.

        Raises:
            ValueError: wrong rank or channel count, or a code outside the format.
        """
        if codes.ndim != 3 or codes.shape[0] != self.channels:
            raise ValueError(f"codes must be [{self.channels}, height, width], not {list(codes.shape)}")
        if not self.format.holds(codes):
            raise ValueError(
                f"codes must lie in {self.format.lo}..{self.format.hi}, "
                f"not {int(codes.min())}..{int(codes.max())}"
            )
        pixels = self.format.to_field(codes.reshape(self.channels, -1).T).astype(np.uint8)
        bits = np.unpackbits(pixels[..., None], axis=-1, bitorder="little")[..., : self.format.bits]
        flat = bits.reshape(len(pixels), -1)
        row = np.zeros((len(pixels), self.beats_per_pixel * self.beat_bits), np.uint8)
        row[:, : flat.shape[1]] = flat
        return np.packbits(row, axis=1, bitorder="little").reshape(-1, self.beat_bits // 8)

    def unpack(self, beats: NDArray[np.uint8], height: int, width: int) -> NDArray[np.int64]:
        """Inverse of `pack`.

        Raises:
            ValueError: the number of beats does not fit ``height * width`` pixels.
        """
        expected = height * width * self.beats_per_pixel
        if beats.shape != (expected, self.beat_bits // 8):
            raise ValueError(f"{height}x{width} pixels are {expected} beats, not {len(beats)}")
        row = np.unpackbits(beats.reshape(height * width, -1), axis=1, bitorder="little")
        used = row[:, : self.channels * self.format.bits].reshape(-1, self.channels, self.format.bits)
        fields = np.packbits(used, axis=-1, bitorder="little")[..., 0]
        return self.format.from_field(fields).T.reshape(self.channels, height, width)


def words_to_beats(words: list[int], word_bits: int, beat_bits: int) -> NDArray[np.uint8]:
    """Parameter words -> ``[beats, beat_bits // 8]`` bytes, low beat and low byte first."""
    size = ceil_div(word_bits, beat_bits) * beat_bits // 8
    raw = b"".join(word.to_bytes(size, "little") for word in words)
    return np.frombuffer(raw, np.uint8).reshape(-1, beat_bits // 8)
