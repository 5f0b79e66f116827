"""The self-test's layer and what the golden model says of it."""

from __future__ import annotations

import zlib
from dataclasses import replace

import numpy as np

from macram import golden, pack
from macram.pack import PackedLayer
from macram.perf import estimate
from macram.spec import ArrayConfig, Control, StreamLayout
from macram.spec.registers import BY_NAME, ID_VALUE, MODE_3X3
from macram.spec.selftest import SelfTestPlan, scrambled_beats

SIDE = 32
"""Rows and columns of the self-test's image, if the line buffer holds so many; a run is then below a millisecond."""


def make_plan(array: ArrayConfig, seed: int) -> tuple[SelfTestPlan, PackedLayer]:
    """A layer that fills the array's channels, its memory images, and what a run of it must give.

    Args:
        array: the array; its stream is 32 or 64 bits wide.
        seed: of weights, requantiser and image, 0 or more.

    Raises:
        ValueError: the self-test cannot be made for this array.
    """
    case = golden.selftest_case(array, seed)
    side = min(SIDE, case.spec.height)
    spec = replace(case.spec, height=side, width=side)
    layout = StreamLayout(spec.c_in, spec.input, array.stream_bits)
    first = int(np.random.default_rng(seed).integers(1, 1 << 31))
    beats_in = side * side * layout.beats_per_pixel
    image = layout.unpack(scrambled_beats(first, beats_in, array.stream_bits), side, side)
    case = replace(case, spec=spec, input=image)
    cycles = estimate(spec, array)
    if not cycles.exact:
        raise ValueError(
            f"the self-test's layer is limited by the {cycles.limited_by} stream, so its cycles are not foretold; "
            "use a wider stream_bits or fewer units"
        )
    output = StreamLayout(spec.c_out, spec.output, array.stream_bits).pack(golden.run_layer(case))
    shape = {"HEIGHT": side, "WIDTH": side, "C_IN": spec.c_in, "C_OUT": spec.c_out, "MODE": MODE_3X3}
    writes = {**shape, "CONTROL": Control.START.value}
    checks = {"ID": ID_VALUE, "ERROR": 0, **shape, "CYCLES": cycles.total, "MAC_CYCLES": cycles.mac}
    plan = SelfTestPlan(
        writes=tuple((BY_NAME[name].offset, value) for name, value in writes.items()),
        checks=tuple((BY_NAME[name].offset, value) for name, value in checks.items()),
        seed=first,
        beats_in=beats_in,
        beats_out=len(output),
        crc=zlib.crc32(output.tobytes()),
        cycles=cycles.total,
    )
    return plan, pack.pack_layer(case, array)
