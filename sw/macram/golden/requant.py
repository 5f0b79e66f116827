"""From exact accumulators to output codes in integers: by thresholds (to 4 bits) or multiplier and shift."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from macram.golden.formula import Float64, Int64, first_true, float_code, staircase
from macram.spec import ConvSpec, IntFormat, accumulator_range
from macram.spec.fixed import MAX_THRESHOLD_BITS, MULT_BITS, OFFSET_BITS, SHIFT_BITS

SUM_BITS = 48
"""``acc * mult``, the offset and their sum all fit this many bits, signed (the ALU of a DSP48E2)."""
MAX_SHIFT = 47
T = TypeVar("T", bound=np.generic)


@dataclass(frozen=True, eq=False)
class ThresholdRequant:
    """Codes of up to 4 bits by comparison, equal to the float formula for every reachable accumulator.

    With ``n = #{i : acc >= thresholds[c, i]}`` the code field of channel c is ``n``, or all bits of ``n``
    inverted if ``invert[c]``; the code is ``output.lo`` plus the field.

    Attributes:
        thresholds: int64 ``[channels, 2**bits - 1]``, ascending, in ``reach[0]..reach[1] + 1``: the first is
            always reached, the last never.
        invert: bool ``[channels]``; set where the code falls as the accumulator grows (negative scale).
        output: format of the codes.
        reach: smallest and largest reachable accumulator.

    Raises:
        ValueError: shapes do not agree, thresholds descend or leave ``reach``, or more than 4 output bits.
    """

    thresholds: Int64
    invert: NDArray[np.bool_]
    output: IntFormat
    reach: tuple[int, int]

    def __post_init__(self) -> None:
        if self.output.bits > MAX_THRESHOLD_BITS:
            raise ValueError(
                f"thresholds serve up to {MAX_THRESHOLD_BITS} output bits, not {self.output.bits}"
            )
        shape = (len(self.invert), (1 << self.output.bits) - 1)
        if self.thresholds.shape != shape:
            raise ValueError(f"thresholds must be {list(shape)}, not {list(self.thresholds.shape)}")
        if (np.diff(self.thresholds, axis=1) < 0).any():
            raise ValueError("the thresholds of a channel must ascend")
        lo, hi = self.reach
        if self.thresholds.size and not lo <= self.thresholds.min() <= self.thresholds.max() <= hi + 1:
            raise ValueError(
                f"thresholds must lie in {lo}..{hi + 1}, not {self.thresholds.min()}..{self.thresholds.max()}"
            )

    @classmethod
    def derive(cls, spec: ConvSpec, scale: Float64, offset: Float64) -> ThresholdRequant:
        """Exact thresholds of ``clip(rint(scale * acc + offset), lo, hi)``; float64 ``[c_out]`` each.

        A zero scale, and a step outside the reach, become thresholds that are always or never reached.

        Raises:
            ValueError: more than 4 output bits, or parameters of the wrong shape or not finite.
        """
        reach = accumulator_range(spec.weight, spec.input, spec.fan_in)
        scale, offset = _parameters(spec, scale, offset)
        steps, falling = staircase(scale, offset, spec.output, reach)
        return cls(steps, falling, spec.output, reach)

    def apply(self, acc: NDArray[np.integer]) -> Int64:
        """``[channels, ...]`` accumulators -> codes, same shape, int64."""
        _check_channels(acc, len(self.invert))
        passed = np.zeros(acc.shape, np.uint8)
        for index in range(self.thresholds.shape[1]):
            passed += acc >= _per_channel(self.thresholds[:, index], acc)
        ones = np.where(self.invert, (1 << self.output.bits) - 1, 0).astype(np.uint8)
        return (passed ^ _per_channel(ones, acc)).astype(np.int64) + self.output.lo


@dataclass(frozen=True, slots=True)
class Distance:
    """How far integer codes are from the float formula, over channels x reachable accumulators.

    Attributes:
        compared: pairs of a channel and a reachable accumulator.
        differing: pairs whose two codes differ.
        largest: largest difference of two codes.
    """

    compared: int
    differing: int
    largest: int

    @property
    def share(self) -> float:
        """Differing per compared, 0 to 1."""
        return self.differing / self.compared


@dataclass(frozen=True, eq=False)
class ShiftRequant:
    """Codes by ``clip((acc * mult + offset) >> shift, lo, hi)``; the shift is arithmetic, i.e. a floor.

    For every accumulator in ``reach``, ``acc * mult``, ``offset`` and their sum fit signed 48 bits, so a
    48-bit adder never wraps.

    Attributes:
        mult: int64 ``[channels]``, signed 18 bits.
        offset: int64 ``[channels]``, signed 48 bits; the rounding half is in it.
        shift: int64 ``[channels]``, 0..47.
        output: format of the codes.
        reach: smallest and largest reachable accumulator.

    Raises:
        ValueError: shapes do not agree, a field is out of range, or a sum may leave 48 bits.
    """

    mult: Int64
    offset: Int64
    shift: Int64
    output: IntFormat
    reach: tuple[int, int]

    def __post_init__(self) -> None:
        if not self.mult.shape == self.offset.shape == self.shift.shape == (len(self.mult),):
            raise ValueError("mult, offset and shift must be of one shape, [channels]")
        for name, form in (
            ("mult", IntFormat(MULT_BITS, signed=True)),
            ("offset", IntFormat(OFFSET_BITS, signed=True)),
            ("shift", IntFormat(SHIFT_BITS)),
        ):
            if not form.holds(values := getattr(self, name)):
                raise ValueError(f"{name} must fit {form}, not {values.min()}..{values.max()}")
        if (self.shift > MAX_SHIFT).any():
            raise ValueError(f"shift must be in 0..{MAX_SHIFT}, not {self.shift.max()}")
        if not _fits(self.mult, self.offset, self.reach).all():
            raise ValueError(f"acc * mult + offset must fit {SUM_BITS} bits for acc in {self.reach}")

    @classmethod
    def derive(cls, spec: ConvSpec, scale: Float64, offset: Float64) -> ShiftRequant:
        """The closest multiplier, offset and shift of each channel; float64 ``[c_out]`` each.

        The largest admissible shift carries every coarser choice in it. Given multiplier and shift, each
        step of the float formula bounds the offset from below or above; the middle of the bounds equals the
        formula everywhere if they leave room, and otherwise misses the worst step by least. A channel whose
        code is the same for all reachable accumulators becomes that constant, whatever its scale.

        Raises:
            ValueError: parameters of the wrong shape or not finite.
        """
        reach = accumulator_range(spec.weight, spec.input, spec.fan_in)
        scale, offset = _parameters(spec, scale, offset)
        output = spec.output
        steps, falling = staircase(scale, offset, output, reach)
        ends = float_code(np.array([reach]).repeat(len(scale), 0), scale[:, None], offset[:, None], output)
        constant = ends[:, 0] == ends[:, 1]
        # A slope of 2**bits codes per accumulator leaves at most one accumulator between lo and hi, and so
        # does any steeper one.
        slope = np.clip(scale, -(2.0**output.bits), 2.0**output.bits)
        slope[constant] = 1.0
        # frexp: |slope| < 2**exponent, so |slope * 2**shift| < 2**17; rounding may still reach 2**17.
        shift = np.minimum(MULT_BITS - 1 - np.frexp(slope)[1], MAX_SHIFT).astype(np.int64)
        while True:
            mult, add = _closest(slope, shift, steps, falling, output, reach)
            fits = constant | (_fits(mult, add, reach) & (abs(mult) < 1 << (MULT_BITS - 1)))
            if fits.all():
                break
            shift[~fits] -= 1
        return cls(
            mult=np.where(constant, 0, mult),
            offset=np.where(constant, ends[:, 0], add),
            shift=np.where(constant, 0, shift),
            output=output,
            reach=reach,
        )

    def apply(self, acc: NDArray[np.integer]) -> Int64:
        """``[channels, ...]`` accumulators in ``reach`` -> codes, same shape, int64."""
        _check_channels(acc, len(self.mult))
        total = acc.astype(np.int64) * _per_channel(self.mult, acc) + _per_channel(self.offset, acc)
        codes: Int64 = np.clip(total >> _per_channel(self.shift, acc), self.output.lo, self.output.hi)
        return codes

    def distance(self, scale: Float64, offset: Float64) -> Distance:
        """Compare with the float formula on every reachable accumulator of every channel, exactly.

        Both sides are staircases, so the codes at the steps of either say everything between them too.
        """
        lo, hi = self.reach
        wanted, _ = staircase(scale, offset, self.output, self.reach)
        levels = self.output.lo + 1 + np.arange(wanted.shape[1], dtype=np.int64)
        down = (self.mult < 0)[:, None]
        own = first_true(lambda acc: (self.apply(acc) >= levels) ^ down, wanted.shape, self.reach)
        start = np.full((len(self.mult), 1), lo, np.int64)
        starts = np.sort(np.concatenate([start, wanted, own], axis=1), axis=1)
        spans = np.diff(starts, axis=1, append=hi + 1)
        inside = np.minimum(starts, hi)
        gaps = abs(self.apply(inside) - float_code(inside, scale[:, None], offset[:, None], self.output))
        return Distance(len(self.mult) * (hi + 1 - lo), int(spans[gaps > 0].sum()), int(gaps.max()))


def derive_requant(spec: ConvSpec, scale: Float64, offset: Float64) -> ThresholdRequant | ShiftRequant:
    """The requantiser that serves the layer's output bits, with its parameters.

    Args:
        spec: the layer; sets the output format and the reachable accumulators.
        scale: float64 ``[c_out]``, finite.
        offset: float64 ``[c_out]``, finite.

    Raises:
        ValueError: parameters of the wrong shape or not finite, or more than 8 output bits.
    """
    if spec.output.bits <= MAX_THRESHOLD_BITS:
        return ThresholdRequant.derive(spec, scale, offset)
    if spec.output.bits <= 8:
        return ShiftRequant.derive(spec, scale, offset)
    raise ValueError(f"output bits must be at most 8, not {spec.output.bits}")


def _closest(
    slope: Float64,
    shift: Int64,
    steps: Int64,
    falling: NDArray[np.bool_],
    output: IntFormat,
    reach: tuple[int, int],
) -> tuple[Int64, Int64]:
    """Best of the three multipliers around ``slope * 2**shift``, with the best offset of each."""
    sign = np.where(falling, -1, 1)
    nearest = abs(np.rint(np.ldexp(slope, shift.astype(np.int32)))).astype(np.int64)
    level = np.arange(steps.shape[1], dtype=np.int64)
    level = np.where(falling[:, None], output.hi - level, output.lo + 1 + level) << shift[:, None]
    # `reached` are the accumulators that must give at least the level, `missed` those that must stay below.
    # A step that every accumulator has passed, or none, bounds the offset on one side only.
    reached = np.where(falling[:, None], steps - 1, steps)
    missed = np.where(falling[:, None], steps, steps - 1)
    never = 1 << 61  # far outside every bound, and differences still fit int64
    bounds_low = (reached >= reach[0]) & (reached <= reach[1])
    bounds_high = (missed >= reach[0]) & (missed <= reach[1])
    best: tuple[Int64, Int64, Int64] | None = None
    for step in (0, -1, 1):
        mult = sign * np.maximum(nearest + step, 1)
        low = np.where(bounds_low, level - reached * mult[:, None], -never).max(axis=1)
        high = np.where(bounds_high, level - missed * mult[:, None] - 1, never).min(axis=1)
        # Equal to the formula if low <= high. No channel that varies has a side without bounds.
        excess = np.maximum(low - high, 0)
        middle = (low + high) >> 1
        if best is None:
            best = mult, middle, excess
        else:
            better = excess < best[2]
            best = (
                np.where(better, mult, best[0]),
                np.where(better, middle, best[1]),
                np.where(better, excess, best[2]),
            )
    assert best is not None
    return best[0], best[1]


def _fits(mult: Int64, offset: Int64, reach: tuple[int, int]) -> NDArray[np.bool_]:
    """Whether product, offset and sum fit `SUM_BITS` for every accumulator in ``reach``."""
    limit = 1 << (SUM_BITS - 1)
    fits = np.ones(len(mult), np.bool_) & (-limit <= offset) & (offset < limit)
    for acc in reach:
        for value in (acc * mult, acc * mult + offset):
            fits &= (-limit <= value) & (value < limit)
    return fits


def _parameters(spec: ConvSpec, scale: Float64, offset: Float64) -> tuple[Float64, Float64]:
    for name, values in (("scale", scale), ("offset", offset)):
        if np.shape(values) != (spec.c_out,):
            raise ValueError(f"{name} must have the shape [{spec.c_out}], not {list(np.shape(values))}")
        bad = np.flatnonzero(~np.isfinite(values))
        if bad.size:
            raise ValueError(f"{name} must be finite, not {values[bad[0]]} in channel {bad[0]}")
    return np.asarray(scale, np.float64), np.asarray(offset, np.float64)


def _check_channels(acc: NDArray[np.integer], channels: int) -> None:
    if acc.ndim < 1 or len(acc) != channels:
        raise ValueError(f"acc must be [{channels}, ...], not {list(acc.shape)}")


def _per_channel(values: NDArray[T], like: NDArray[np.integer]) -> NDArray[T]:
    """``[channels]`` shaped to broadcast over ``[channels, ...]``."""
    return values.reshape(-1, *[1] * (like.ndim - 1))
