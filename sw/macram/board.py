"""An overlay folder on a PYNQ board: its files, the loaded bitstream, and the driver on it.

Runs on the board with NumPy and PYNQ alone, on Python 3.10 or newer. PYNQ is imported when the board is opened.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from macram.driver import ArrayDriver, ArrayError
from macram.layer_file import LayerCase
from macram.pynq_transport import PynqTransport
from macram.spec import ArrayConfig

MANIFEST = "overlay.json"
BITSTREAM = "macram.bit"
CLOCK_TOLERANCE = 0.01
"""Share by which the PS's clock may be off: its dividers give 99.999 MHz where 100 MHz are asked for."""


@dataclass(frozen=True, eq=False)
class OverlayFiles:
    """What an overlay folder holds, checked against the hashes of its manifest.

    Attributes:
        folder: the folder.
        array: the array the bitstream is built from.
        clock_mhz: the array's clock.
        case: the layer whose weights the bitstream starts up with.
        expected: its output codes by the golden model, int64 ``[c_out, out_height, out_width]``.
    """

    folder: Path
    array: ArrayConfig
    clock_mhz: float
    case: LayerCase
    expected: NDArray[np.int64]


@dataclass(frozen=True)
class Board:
    """The loaded overlay.

    Attributes:
        driver: the array's driver.
        transport: what the driver talks through; its ``reset`` clears transfers that hang.
        clock_mhz: array clock as the PS reports it.
    """

    driver: ArrayDriver
    transport: PynqTransport
    clock_mhz: float


def read_overlay(folder: Path) -> OverlayFiles:
    """Read an overlay folder.

    Raises:
        ValueError: a file is missing or differs from the manifest; the line names it.
    """
    path = folder / MANIFEST
    try:
        manifest = json.loads(path.read_text(encoding="utf-8"))
        array = ArrayConfig.from_dict(manifest["array"])
        clock_mhz, sums = float(manifest["clock_mhz"]), dict(manifest["sha256"])
    except OSError as error:
        raise ValueError(f"{path}: {error.strerror}; copy the whole overlay folder") from error
    except (KeyError, TypeError, ValueError) as error:
        raise ValueError(f"{path}: is not an overlay's manifest ({error}); export it again") from error
    for name, wanted in sums.items():
        try:
            found = hashlib.sha256((folder / name).read_bytes()).hexdigest()
        except OSError as error:
            raise ValueError(f"{folder / name}: {error.strerror}; copy the whole overlay folder") from error
        if found != wanted:
            raise ValueError(
                f"{folder / name}: differs from the one that was exported; copy the folder again"
            )
    with np.load(folder / "expected.npz") as arrays:
        expected = arrays["codes"].astype(np.int64)
    return OverlayFiles(folder, array, clock_mhz, LayerCase.load(folder / "layer.npz"), expected)


def open_board(files: OverlayFiles, *, timeout: float = 10.0) -> Board:
    """Load the bitstream and make the driver.

    Args:
        files: the overlay.
        timeout: seconds a DMA transfer may take.

    Raises:
        ValueError: the bitstream or its hardware description is missing.
        ArrayError: the clock is not what the overlay was built for.
    """
    bitstream = files.folder / BITSTREAM
    for path in (bitstream, bitstream.with_suffix(".hwh")):
        if not path.exists():
            raise ValueError(f"{path}: no such file; build it with Vivado and copy it here")
    import pynq  # noqa: PLC0415

    # Before loading, because a clocking wizard locks to what it then gets. PYNQ sets it again from the .hwh.
    pynq.Clocks.fclk0_mhz = files.clock_mhz
    overlay: Any = pynq.Overlay(str(bitstream))
    clock_mhz = float(pynq.Clocks.fclk0_mhz)
    if abs(clock_mhz - files.clock_mhz) > CLOCK_TOLERANCE * files.clock_mhz:
        raise ArrayError(
            f"pl_clk0 runs at {clock_mhz:g} MHz, the overlay was built for {files.clock_mhz:g} MHz"
        )
    transport = PynqTransport(
        overlay.macram_0,
        overlay.dma_image,
        overlay.dma_param,
        pynq.allocate,
        residual_dma=overlay.dma_residual if files.array.residual_stream_bits else None,
        timeout=timeout,
    )
    return Board(ArrayDriver(transport, files.array), transport, clock_mhz)


def differences(codes: NDArray[np.int64], expected: NDArray[np.int64]) -> tuple[int, str]:
    """How many codes differ, and where the first does: ``(0, "")`` if none.

    Args:
        codes: from the array, ``[c_out, height, width]``.
        expected: from the golden model, same shape.
    """
    wrong = codes != expected
    if not wrong.any():
        return 0, ""
    channel, y, x = (int(i) for i in np.argwhere(wrong)[0])
    return int(wrong.sum()), (
        f"first at channel {channel}, row {y}, column {x}: {codes[channel, y, x]}, "
        f"expected {expected[channel, y, x]}"
    )


def main(job: Callable[[], int]) -> int:
    """Run a script's job and turn what goes wrong into one line: 1 for the array, 2 for files and set-up."""
    try:
        return job()
    except ArrayError as error:
        print(f"FAILED: {error}")
        return 1
    except (ValueError, OSError, ImportError) as error:
        print(f"error: {error}")
        return 2
