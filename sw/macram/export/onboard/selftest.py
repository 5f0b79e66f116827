"""Check an overlay on the board step by step, one line each.

    sudo -E python3 selftest.py

Each step needs those before it, so the first failure ends the test. Exit status 0: all well; 1: a step failed;
2: a file or PYNQ is missing.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np

from macram.board import Board, OverlayFiles, differences, main, open_board, read_overlay
from macram.driver import ArrayError, StreamTimeout
from macram.golden import ResidualRule, random_case, run_layer
from macram.layer_file import LayerCase
from macram.pack import pack_layer
from macram.pynq_transport import run_sync
from macram.spec import BY_NAME, Control, ConvSpec, Error, StreamLayout

TIMEOUT = 0.5
"""Seconds for a DMA transfer. The whole reference image takes a few milliseconds."""


class SelfTest:
    """The steps, in order. Each raises `ArrayError` if it fails.

    Args:
        files: the overlay.
        board: the loaded overlay.
    """

    def __init__(self, files: OverlayFiles, board: Board) -> None:
        self._files = files
        self._board = board
        self._driver = board.driver

    def steps(self) -> dict[str, Callable[[], None]]:
        """What is checked -> how."""
        adder = {"a residual stream is added to, code by code": self.residual}
        return {
            "the array is the one the overlay was exported from": self.identity,
            "registers hold what is written": self.registers,
            "weights in the bitstream give the golden codes": self.preloaded,
            "weights through the stream give the golden codes": self.loaded,
            "a small layer of odd shape gives the golden codes": self.odd_shape,
            **(adder if self._files.array.residual_stream_bits else {}),
            "a command with an impossible shape is refused and forgotten": self.refused,
            "an image that ends early is noticed, and reset recovers": self.truncated,
        }

    def identity(self) -> None:
        """Compare the read-only registers with the configuration."""
        run_sync(self._driver.identify())
        run_sync(self._driver.soft_reset())

    def registers(self) -> None:
        """Write two patterns that are each other's complement."""
        for name in ("HEIGHT", "WIDTH", "C_IN", "C_OUT"):
            for value in (0x5A5A, 0xA5A5):
                self._write(name, value)
                if (found := self._read(name)) != value:
                    raise ArrayError(f"{name} holds {found:#x} after {value:#x} was written")

    def preloaded(self) -> None:
        """Run before anything was loaded."""
        self._run(self._files.case, self._files.expected)

    def loaded(self) -> None:
        """Load other weights first, so that the right ones cannot be left over."""
        case = self._files.case
        flipped = LayerCase(case.spec, np.flip(case.weights, 0), case.input, case.scale, case.offset)
        for one in (flipped, case):
            run_sync(self._driver.load(pack_layer(one, self._files.array)))
        self._run(case, self._files.expected)

    def odd_shape(self) -> None:
        """Compute the golden codes here and now."""
        array = self._files.array
        channels = min(array.max_c_in, 5), min(array.max_c_out, 7)
        spec = ConvSpec(*channels, 3, 5, weight=array.weight, input=array.input, output=array.output)
        case = random_case(spec, seed=2022)
        run_sync(self._driver.load(pack_layer(case, array)))
        self._run(case, run_layer(case))

    def residual(self) -> None:
        """Add the layer's codes to a random stream by a random rule, both streams at once."""
        case, expected = self._files.case, self._files.expected
        rng = np.random.default_rng(2022)
        codes = 1 << case.spec.output.bits
        rule = ResidualRule(
            case.spec.output, np.sort(rng.integers(0, 256, codes)), np.sort(rng.integers(0, 256, codes - 1))
        )
        stream = rng.integers(0, 256, expected.shape)
        sums, following = rule.apply(expected, stream)
        run_sync(self._driver.load(pack_layer(case, self._files.array)))
        run_sync(self._driver.configure(case.spec, rule))
        result = run_sync(self._driver.run(case.input, stream))
        assert result.sums is not None
        for name, found, wanted in (("codes", result.codes, following), ("sums", result.sums, sums)):
            wrong, where = differences(found, wanted)
            if wrong:
                raise ArrayError(f"{wrong} of {wanted.size} {name} differ, {where}")

    def refused(self) -> None:
        """Start with height 0, then run the reference layer as if nothing had been."""
        run_sync(self._driver.load(pack_layer(self._files.case, self._files.array)))
        run_sync(self._driver.configure(self._files.case.spec))
        self._write("HEIGHT", 0)
        self._write("CONTROL", Control.START)
        self._expect_error(Error.BAD_SHAPE)
        run_sync(self._driver.soft_reset())
        self._run(self._files.case, self._files.expected)

    def truncated(self) -> None:
        """Send the first row alone; the array waits for the rest, and so does the DMA that takes the result."""
        case, array = self._files.case, self._files.array
        run_sync(self._driver.configure(case.spec))
        row = StreamLayout(case.spec.c_in, array.input, array.stream_bits).pack(case.input[:, :1])
        if case.spec.height == 1:
            row = row[: len(row) // 2]
        output = StreamLayout(case.spec.c_out, array.output, array.stream_bits)
        self._write("CONTROL", Control.START)
        try:
            beats = case.spec.out_height * case.spec.out_width * output.beats_per_pixel
            run_sync(self._board.transport.begin_stream(row, beats))
            run_sync(self._board.transport.end_stream())
        except StreamTimeout:
            self._expect_error(Error.TLAST_EARLY)
        else:
            raise ArrayError("the array sent a whole result for a part of an image")
        self._board.transport.reset()
        run_sync(self._driver.soft_reset())
        self._run(case, self._files.expected)

    def _run(self, case: LayerCase, expected: np.ndarray) -> None:
        run_sync(self._driver.configure(case.spec))
        result = run_sync(self._driver.run(case.input))
        wrong, where = differences(result.codes, expected)
        if wrong:
            raise ArrayError(f"{wrong} of {expected.size} codes differ, {where}")

    def _expect_error(self, wanted: Error) -> None:
        if (found := self._read("ERROR")) != wanted:
            raise ArrayError(f"ERROR is {found}, expected {wanted.value} ({wanted.name})")

    def _read(self, name: str) -> int:
        return run_sync(self._board.transport.read(BY_NAME[name].offset))

    def _write(self, name: str, value: int) -> None:
        run_sync(self._board.transport.write(BY_NAME[name].offset, int(value)))


def selftest() -> int:
    """Print a line per step; 0 if all pass."""
    files = read_overlay(Path(__file__).resolve().parent)
    print("ok      every file is as exported")
    board = open_board(files, timeout=TIMEOUT)
    print(f"ok      the bitstream is loaded, clock {board.clock_mhz:g} MHz")
    for name, step in SelfTest(files, board).steps().items():
        try:
            step()
        except ArrayError as error:
            print(f"FAILED  {name}: {error}")
            return 1
        print(f"ok      {name}")
    return 0


if __name__ == "__main__":
    sys.exit(main(selftest))
