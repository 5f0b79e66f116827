"""The CPU side of the paper's table VI: the reference layer on this machine's processor."""

from __future__ import annotations

import os
import statistics
import time
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from macram.report.latency import REFERENCE


def measure_cpu(repeat: int) -> list[dict[str, Any]]:
    """Time the reference layer in PyTorch float32 and int8 and in the golden model.

    Args:
        repeat: runs per measurement, after one that warms caches; the figure is their median.

    Returns:
        Rows with ``name``, ``threads``, ``median_ms`` and ``runs_ms``; int8 is left out where this build of
        PyTorch has no quantised convolution for this processor. Empty without PyTorch.
    """
    try:
        import torch  # noqa: PLC0415
    except ModuleNotFoundError:
        return []
    from threadpoolctl import threadpool_limits  # noqa: PLC0415

    from macram.golden import conv2d  # noqa: PLC0415

    rng = np.random.default_rng(0)
    codes = rng.integers(0, REFERENCE.input.hi + 1, (REFERENCE.c_in, REFERENCE.height, REFERENCE.width))
    weights = rng.integers(-4, 4, (REFERENCE.c_out, REFERENCE.c_in, REFERENCE.kernel, REFERENCE.kernel))
    image = torch.from_numpy(codes).float()[None]
    kernel = torch.from_numpy(weights).float()
    every = os.cpu_count() or 1
    rows = []
    for threads in sorted({1, every}):
        with torch_threads(torch, threads), torch.inference_mode(), warnings.catch_warnings():
            rows.append(
                _row(
                    "PyTorch float32",
                    threads,
                    repeat,
                    lambda: torch.nn.functional.conv2d(image, kernel, padding=REFERENCE.padding),
                )
            )
            if quantised := _int8(torch, image, kernel):
                rows.append(_row("PyTorch int8", threads, repeat, quantised))
        with threadpool_limits(threads):
            rows.append(_row("golden model (NumPy)", threads, repeat, lambda: conv2d(codes, weights)))
    return rows


def _int8(torch: Any, image: Any, kernel: Any) -> Callable[[], object] | None:
    """PyTorch's own 8-bit convolution of the same codes, weights packed beforehand; None if it has none."""
    # PyTorch has announced that these operators will go; while they are here they are worth a row.
    warnings.filterwarnings("ignore", message=".*quantize_per_tensor", category=UserWarning)
    try:
        packed = torch.ops.quantized.conv2d_prepack(
            torch.quantize_per_tensor(kernel, 1.0, 0, torch.qint8),
            None,
            [1, 1],
            [REFERENCE.padding] * 2,
            [1, 1],
            1,
        )
        codes = torch.quantize_per_tensor(image, 1.0, 0, torch.quint8)
        codes = codes.contiguous(memory_format=torch.channels_last)
        torch.ops.quantized.conv2d(codes, packed, 64.0, 128)
    except (RuntimeError, NotImplementedError):
        return None
    return lambda: torch.ops.quantized.conv2d(codes, packed, 64.0, 128)


@contextmanager
def torch_threads(torch: Any, threads: int) -> Iterator[None]:
    """While open, PyTorch uses so many threads."""
    before = torch.get_num_threads()
    torch.set_num_threads(threads)
    try:
        yield
    finally:
        torch.set_num_threads(before)


def _row(name: str, threads: int, repeat: int, work: Callable[[], object]) -> dict[str, Any]:
    work()
    runs = []
    for _ in range(repeat):
        start = time.perf_counter()
        work()
        runs.append(1e3 * (time.perf_counter() - start))
    return {
        "name": name,
        "threads": threads,
        "median_ms": round(statistics.median(runs), 2),
        "runs_ms": [round(value, 2) for value in runs],
    }
