"""What the self-test on a board sends and what it must get back: one plan for the gateware and the software."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

SCRAMBLER_SHIFTS = {32: (13, 17, 5), 64: (13, 7, 17)}
"""Stream width -> shifts (left, right, left) of the xorshift generator of that width (Marsaglia 2003); with these it
walks through all values but 0."""


@dataclass(frozen=True, slots=True)
class SelfTestPlan:
    """One run of one layer, as numbers.

    Attributes:
        writes: register writes in order, ``(byte offset, value)``; the last one starts the array.
        checks: registers and the values they must hold after the run.
        seed: first image beat, not 0; each further beat is the next value of the xorshift generator.
        beats_in, beats_out: of the image and of the output.
        crc: CRC-32 (as of zlib) of all output beats, low byte first.
        cycles: what the run takes, first input beat to last output beat.
    """

    writes: tuple[tuple[int, int], ...]
    checks: tuple[tuple[int, int], ...]
    seed: int
    beats_in: int
    beats_out: int
    crc: int
    cycles: int


def scrambled_beats(seed: int, beats: int, beat_bits: int) -> NDArray[np.uint8]:
    """The image beats that the self-test makes: ``[beats, beat_bits // 8]`` bytes, low byte first.

    Raises:
        ValueError: ``seed`` is 0 or does not fit, or there is no generator of this width.
    """
    shifts = scrambler_shifts(beat_bits)
    mask = (1 << beat_bits) - 1
    if not 0 < seed <= mask:
        raise ValueError(f"seed must be in 1..2**{beat_bits} - 1, not {seed}")
    words = bytearray()
    value = seed
    for _ in range(beats):
        words += value.to_bytes(beat_bits // 8, "little")
        value ^= value << shifts[0] & mask
        value ^= value >> shifts[1]
        value ^= value << shifts[2] & mask
    return np.frombuffer(bytes(words), np.uint8).reshape(beats, beat_bits // 8)


def scrambler_shifts(beat_bits: int) -> tuple[int, int, int]:
    """The generator's shifts for a stream width.

    Raises:
        ValueError: there is none of this width.
    """
    if beat_bits not in SCRAMBLER_SHIFTS:
        widths = " or ".join(map(str, SCRAMBLER_SHIFTS))
        raise ValueError(f"the self-test needs stream_bits of {widths}, not {beat_bits}")
    return SCRAMBLER_SHIFTS[beat_bits]
