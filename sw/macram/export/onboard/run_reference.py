"""Run the overlay's layer on the board once and compare every code with the golden model's.

    sudo -E python3 run_reference.py [--json result.json]

Loads the bitstream, loads the weights through the parameter stream, runs one image. Exit status 0: all codes equal;
1: some differ or the array reports an error; 2: a file or PYNQ is missing.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from pathlib import Path

from macram.board import differences, main, open_board, read_overlay
from macram.pack import pack_layer
from macram.pynq_transport import run_sync


def run_reference() -> int:
    """Everything that the module's docstring says."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--json", type=Path, metavar="FILE", help="also write the result as JSON")
    arguments = parser.parse_args()

    files = read_overlay(Path(__file__).resolve().parent)
    board = open_board(files)
    spec = files.case.spec
    print(f"array {files.array.name!r} at {board.clock_mhz:g} MHz")
    print(f"layer {spec.c_in} -> {spec.c_out} channels, {spec.height}x{spec.width}, kernel {spec.kernel}")

    run_sync(board.driver.identify())
    run_sync(board.driver.soft_reset())
    run_sync(board.driver.load(pack_layer(files.case, files.array)))
    run_sync(board.driver.configure(spec))
    started = time.perf_counter()
    result = run_sync(board.driver.run(files.case.input))
    wall = time.perf_counter() - started

    wrong, where = differences(result.codes, files.expected)
    cycles = result.counters["cycles"]
    print(f"{cycles:,} cycles, {cycles / board.clock_mhz / 1000:.3f} ms on the array")
    print(f"{1000 * wall:.1f} ms seen by Python: packing and unpacking of the streams included")
    for name, value in result.counters.items():
        print(f"  {name:<14} {value:>12,}")
    print(f"{files.expected.size:,} codes compared, {wrong:,} differ" + (f"; {where}" if wrong else ""))
    if arguments.json:
        table = {
            "array": files.array.to_dict(),
            "clock_mhz": board.clock_mhz,
            "counters": result.counters,
            "milliseconds": cycles / board.clock_mhz / 1000,
            "wall_milliseconds": 1000 * wall,
            "compared": files.expected.size,
            "mismatches": wrong,
        }
        draft = arguments.json.with_name(arguments.json.name + ".tmp")
        draft.write_text(json.dumps(table, indent=2) + "\n")
        draft.replace(arguments.json)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(run_reference))
