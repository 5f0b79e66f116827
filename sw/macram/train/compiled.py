"""C++ of this package, compiled for this processor the first time it is wanted."""

from __future__ import annotations

import ctypes
import functools
import hashlib
import numbers
import os
import platform
import subprocess
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from torch import Tensor

from macram.kept import kept

SOURCES = Path(__file__).parent
COMMAND = (
    *("g++", "-std=c++17", "-O3", "-march=native", "-fno-math-errno", "-fno-trapping-math"),
    *("-fopenmp", "-fPIC", "-shared"),
)
"""OpenMP's threads are PyTorch's own: its library is loaded already, and the names are found there."""
PATIENCE = 120
"""Seconds for the compiler, which needs about two."""


@functools.cache
def library(name: str) -> ctypes.CDLL | None:
    """``name.cpp`` compiled; None where there is no compiler that can do it, or no folder to keep the result."""
    try:
        source = SOURCES / f"{name}.cpp"
        path = kept("native") / f"{name}-{_key(source)}.so"
        if path.is_file():
            try:
                return ctypes.CDLL(str(path))
            except OSError:  # damaged, or linked against libraries that are gone
                pass
        _compile(source, path)
        return ctypes.CDLL(str(path))
    except (OSError, RuntimeError, subprocess.SubprocessError):  # RuntimeError: nobody's home is known
        return None


def call(name: str, function: str, *arguments: Any) -> None:
    """Calls a function of the library ``name``, which is there.

    Args:
        name: see `library`.
        function: without a result.
        arguments: tensors and arrays, whose memory is passed by address as it lies; None is the null pointer. Whole
            numbers go as ``std::int64_t``, others as ``double``.

    Raises:
        TypeError: something else.
    """
    passed: list[Any] = []
    for value in arguments:
        if isinstance(value, Tensor):
            passed.append(ctypes.c_void_p(value.data_ptr()))
        elif isinstance(value, np.ndarray):
            assert value.flags.c_contiguous
            passed.append(ctypes.c_void_p(value.ctypes.data))
        elif value is None:
            passed.append(ctypes.c_void_p())
        elif isinstance(value, numbers.Integral):
            passed.append(ctypes.c_int64(int(value)))
        elif isinstance(value, numbers.Real):
            passed.append(ctypes.c_double(float(value)))
        else:
            raise TypeError(f"{function} takes tensors, arrays and numbers, not {value!r}")
    getattr(library(name), function)(*passed)


def _compile(source: Path, path: Path) -> None:
    """Writes ``path`` in one step: another process may want it at the same time."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="compile-", dir=path.parent) as folder:
        made = Path(folder) / path.name
        subprocess.run(
            [*COMMAND, str(source), "-o", str(made)], check=True, capture_output=True, timeout=PATIENCE
        )
        with made.open("rb") as file:
            os.fsync(file.fileno())  # half a library would not fail to load but end the process
        made.replace(path)


def _key(source: Path) -> str:
    """Changes with the source, all headers, the command and the processor, whose own instructions are used."""
    digest = hashlib.sha256(source.read_bytes())
    for header in sorted(source.parent.glob("*.hpp")):
        digest.update(header.read_bytes())
    digest.update(repr((COMMAND, platform.machine())).encode())
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        lines = [platform.processor()]
    digest.update(repr(sorted({line for line in lines if line.startswith(("flags", "model name"))})).encode())
    return digest.hexdigest()[:16]
