"""The overlay folder: what a board needs beside the bitstream to run the layer and judge the result."""

from __future__ import annotations

import hashlib
import json
from importlib import resources
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from macram.board import MANIFEST
from macram.export.settings import CLOCK_MHZ
from macram.layer_file import LayerCase
from macram.spec import ArrayConfig

MODULES = ("__init__.py", "board.py", "driver.py", "layer_file.py", "pynq_transport.py", "transport.py")
PACKAGES = ("golden", "pack", "spec")
"""The part of macram that the driver needs. It imports NumPy and the standard library, on Python 3.10 or newer."""
SCRIPTS = ("README.md", "run_reference.py", "selftest.py")


def write_overlay(folder: Path, array: ArrayConfig, case: LayerCase, expected: NDArray[np.int64]) -> None:
    """Write layer, golden codes, scripts, the driver's modules and the manifest into an empty folder.

    Args:
        folder: made if missing.
        array: the array the bitstream will be built from.
        case: the layer whose weights the bitstream starts up with.
        expected: its golden output codes ``[c_out, out_height, out_width]``.
    """
    folder.mkdir(parents=True, exist_ok=True)
    case.save(folder / "layer.npz")
    np.savez_compressed(folder / "expected.npz", codes=expected.astype(np.int16))  # codes have 8 bits at most
    scripts = resources.files("macram.export") / "onboard"
    for name in SCRIPTS:
        (folder / name).write_text((scripts / name).read_text(encoding="utf-8"), encoding="utf-8")
    _copy_modules(folder / "macram")
    files = sorted(path for path in folder.rglob("*") if path.is_file())
    manifest = {
        "format": 1,
        "array": array.to_dict(),
        "clock_mhz": CLOCK_MHZ,
        "sha256": {
            path.relative_to(folder).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in files
        },
    }
    (folder / MANIFEST).write_text(json.dumps(manifest, indent=2) + "\n", encoding="utf-8")


def _copy_modules(target: Path) -> None:
    package = resources.files("macram")
    sources = [(name, package / name) for name in MODULES]
    for name in PACKAGES:
        sources += [
            (f"{name}/{one.name}", one) for one in (package / name).iterdir() if one.name.endswith(".py")
        ]
    for name, source in sources:
        path = target / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(source.read_text(encoding="utf-8"), encoding="utf-8")
