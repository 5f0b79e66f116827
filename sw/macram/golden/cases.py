"""Reproducible layers for tests and benches."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from macram.golden.conv import conv2d
from macram.layer_file import LayerCase
from macram.spec import GROUP, ArrayConfig, ConvSpec, IntFormat, ceil_div

KINDS = ("uniform", "extremes", "min", "max", "zero", "impulse")
"""What `random_case` fills a layer with."""


def random_case(spec: ConvSpec, seed: int, kind: str = "uniform") -> LayerCase:
    """A layer with codes of one kind and a requantisation that spreads the output codes over their range.

    About every fifth channel has a negative scale and every ninth a zero scale, from two and three channels
    on at least one of each. All values depend on the arguments alone.

    Args:
        spec: shapes and formats.
        seed: of the random generator, 0 or more.
        kind: ``uniform`` all codes alike; ``extremes`` only the smallest and the largest code; ``min`` and
            ``max`` every accumulator as small or as large as it can be; ``zero`` all codes 0; ``impulse`` one
            weight per output channel and one input pixel per channel at the code furthest from 0, else 0.

    Raises:
        ValueError: unknown kind.
    """
    if kind not in KINDS:
        raise ValueError(f"kind must be one of {', '.join(KINDS)}, not {kind!r}")
    rng = np.random.default_rng(seed)
    shape_w = (spec.c_out, spec.c_in, spec.kernel, spec.kernel)
    shape_x = (spec.c_in, spec.height, spec.width)
    if kind in ("min", "max"):
        w, x = _operands_of_extreme(spec, largest=kind == "max")
        weights, codes = np.full(shape_w, w), np.full(shape_x, x)
    else:
        weights, codes = _fill(rng, spec.weight, shape_w, kind), _fill(rng, spec.input, shape_x, kind)
    scale, offset = _spread(rng, spec, conv2d(codes, weights, stride=spec.stride, padding=spec.padding))
    return LayerCase(spec, weights, codes, scale, offset)


def selftest_case(array: ArrayConfig, seed: int = 2022) -> LayerCase:
    """The layer whose memory images an array starts up with, for a first run on a board.

    Two tiles of eight blocks at up to 128 x 128, or what the array admits of that; on the reference array the
    reference layer's shape. All codes are random. Scales are powers of two and offsets quarters, so that the
    thresholds are the same on every machine.
    """
    c_in, tiles = min(array.max_c_in, 8 * array.rows), min(array.max_tiles, 2)
    while 3 * tiles * array.blocks(c_in) > array.weight_depth:
        c_in, tiles = (c_in, 1) if tiles > 1 else (ceil_div(c_in, 2), 1)
    words_per_group = ceil_div(array.blocks(c_in), array.ingest) * array.ingest
    size = min(128, GROUP * (array.row_words // words_per_group))
    spec = ConvSpec(
        c_in, tiles * array.units, size, size, weight=array.weight, input=array.input, output=array.output
    )
    rng = np.random.default_rng(seed)
    weights = _fill(rng, spec.weight, (spec.c_out, c_in, 3, 3), "uniform")
    codes = _fill(rng, spec.input, (c_in, size, size), "uniform")
    # About one deviation of a sum of random products per two output codes.
    deviation = (array.weight.hi * array.input.hi) ** 2 * spec.fan_in // 12
    step = 1 << max(0, deviation.bit_length() // 2 - array.output.bits + 2)
    scale = rng.choice([-1.0, 0.0, 1.0], spec.c_out, p=[0.2, 0.1, 0.7]) / step
    offset = rng.integers(0, 4 * array.output.hi, spec.c_out, endpoint=True) / 4.0
    mean = weights.reshape(spec.c_out, -1).sum(axis=1) * ((array.input.lo + array.input.hi) // 2)
    return LayerCase(spec, weights, codes, scale, offset - scale * mean)


def _operands_of_extreme(spec: ConvSpec, *, largest: bool) -> tuple[int, int]:
    pairs = [(w, x) for w in (spec.weight.lo, spec.weight.hi) for x in (spec.input.lo, spec.input.hi)]
    return sorted(pairs, key=lambda pair: pair[0] * pair[1])[-1 if largest else 0]


def _fill(rng: np.random.Generator, form: IntFormat, shape: tuple[int, ...], kind: str) -> NDArray[np.int64]:
    if kind == "uniform":
        return rng.integers(form.lo, form.hi, shape, endpoint=True)
    if kind == "extremes":
        return rng.choice(np.array([form.lo, form.hi]), shape)
    flat = np.zeros((shape[0], int(np.prod(shape[1:]))), np.int64)
    if kind == "impulse":
        place = rng.integers(0, flat.shape[1], shape[0])
        flat[np.arange(shape[0]), place] = form.lo if form.signed else form.hi
    return flat.reshape(shape)


def _spread(
    rng: np.random.Generator, spec: ConvSpec, acc: NDArray[np.integer]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Scale and offset that map mean -+ 2 deviations of each channel to about the whole output range."""
    flat = acc.reshape(spec.c_out, -1).astype(np.float64)
    levels = 1 << spec.output.bits
    scale = levels / (4 * np.maximum(flat.std(axis=1), 1.0)) * rng.uniform(0.7, 1.4, spec.c_out)
    order = rng.permutation(spec.c_out)
    scale[order[1::5]] *= -1
    scale[order[2::9]] = 0.0
    centre = (spec.output.lo + spec.output.hi) / 2 + rng.uniform(-0.2, 0.2, spec.c_out) * levels
    return scale, centre - scale * flat.mean(axis=1)
