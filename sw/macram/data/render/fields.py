"""Periodic random textures whose spectrum falls as a power of frequency."""

from __future__ import annotations

import numpy as np

from macram.data.render.patches import Floats32


def power_field(size: int, exponent: float, seed: int, cutoff: float = 0.0) -> Floats32:
    """``[size, size]`` periodic field, mean 0 and deviation 1, amplitude as ``frequency ** -exponent``.

    Synthesis in the frequency domain leaves none of the grid that interpolated lattice noise shows.

    Args:
        size: rows and columns.
        exponent: of the amplitude; 1.5 looks like clouds, 1 like terrain.
        seed: of the phases.
        cutoff: cycles per tile below which nothing is left.
    """
    random = np.random.default_rng(seed)
    rows = np.fft.fftfreq(size, 1 / size)[:, None]
    columns = np.fft.rfftfreq(size, 1 / size)[None, :]
    frequency = np.hypot(rows, columns)
    frequency[0, 0] = 1.0
    amplitude = frequency**-exponent
    amplitude[frequency < cutoff] = 0.0
    amplitude[0, 0] = 0.0
    white = np.fft.rfft2(random.standard_normal((size, size)))
    field = np.fft.irfft2(white * amplitude, s=(size, size))
    return np.asarray(field / field.std(), np.float32)
