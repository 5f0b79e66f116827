"""``macram synth`` and ``macram bitstream``: resources from synthesis, and a bitstream that tests itself."""

from __future__ import annotations

import argparse
import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

SYNTH_FOLDER = Path("build/synth")
"""Where counts are written, a folder per array and device, and where ``macram designs`` looks for them."""
SYNTH_EPILOG = """\
how cells are counted:
  xczu3eg   LUT1 to LUT6, each LUT of a LUT memory and each shift register one LUT; BRAM in RAMB36 (RAMB18 is 0.5)
  ecp5-85k  LUT4 one, carry cell two, 16 x 4 memory six LUT4; BRAM in 18-kbit blocks
limits: 80 % of the LUTs, all of the rest. A design above them: exit status 1; the figures are written all the same.

examples:
  macram synth configs/tiny.toml
  macram synth configs/ecp5-85k.toml --device ecp5-85k
"""
BITSTREAM_EPILOG = """\
The array is built into a self-test: image beats from a generator, weights in the bitstream, output into a CRC that
the golden model has foretold, cycle counter compared. Lamps from pin A13 on: pass, fail, blink, PLL locked.

files in DIR: macram.bit, bitstream.json, bitstream.md, and every script, netlist and log on the way
example: macram bitstream configs/ecp5-85k.toml -o build/bitstream
"""


def add_parsers(verb: Callable[[str, str, str, str], argparse.ArgumentParser]) -> None:
    """The grammar of both verbs."""
    synth_parser = verb(
        "synth",
        "synth_verb",
        "count an array's LUT, FF, DSP and BRAM by synthesis",
        "Runs Yosys; writes synth.json and synth.md. macram designs takes the figures from there.",
    )
    _lines(synth_parser, SYNTH_EPILOG)
    synth_parser.add_argument("config", type=Path, metavar="CONFIG.toml", help="array to synthesise")
    synth_parser.add_argument(
        "--device", default="xczu3eg", metavar="NAME", help="xczu3eg (default) or ecp5-85k"
    )
    synth_parser.add_argument(
        "--flat", action="store_true", help="as one module: exact and slow (default: module by module)"
    )
    synth_parser.add_argument(
        "-o", "--out", type=Path, metavar="DIR", help="default: build/synth/NAME-DEVICE, with -flat"
    )
    _timeout(synth_parser, 1800)

    bitstream_parser = verb(
        "bitstream",
        "synth_verb",
        "place and route an array with its self-test for the ECP5 evaluation board",
        "Runs Yosys, nextpnr and ecppack.",
    )
    _lines(bitstream_parser, BITSTREAM_EPILOG)
    bitstream_parser.add_argument("config", type=Path, metavar="CONFIG.toml", help="array to build")
    bitstream_parser.add_argument(
        "--mhz", type=int, default=100, help="array clock, a multiple of 4 (default: 100)"
    )
    bitstream_parser.add_argument(
        "--seed", type=int, default=1, help="of the self-test's layer and of nextpnr (default: 1)"
    )
    _out(bitstream_parser, "build/bitstream")
    _timeout(bitstream_parser, 7200)


def synth(arguments: argparse.Namespace) -> int:
    """Synthesise, print and write the counts; 1 if the design is too large for the device."""
    from macram.cli.console import open_console  # noqa: PLC0415
    from macram.cli.stages import Stages  # noqa: PLC0415
    from macram.spec import ArrayConfig  # noqa: PLC0415
    from macram.synth import cost, tables  # noqa: PLC0415
    from macram.synth.devices import DEVICES  # noqa: PLC0415

    if arguments.device not in DEVICES:
        raise ValueError(f"--device must be one of {', '.join(DEVICES)}, not {arguments.device!r}")
    config = ArrayConfig.from_toml(arguments.config)
    _check_timeout(arguments)
    console = open_console()
    device = DEVICES[arguments.device]
    out = arguments.out or SYNTH_FOLDER / _folder_name(config.name, device.name, arguments.flat)
    with Stages(console)(f"Yosys, array {config.name} on {device.name}"):
        report = cost.synthesise(config, device, out, flat=arguments.flat, timeout=arguments.timeout)
    _show(report["note"], tables.COST_COLUMNS, tables.cost_rows(report))
    _write(out / "synth", report, tables.cost_markdown(report))
    if report["excess"]:
        print(
            f"macram: array {config.name} does not fit {device.name}: {'; '.join(report['excess'])}; "
            "use fewer units or rows, or another engine",
            file=sys.stderr,
        )
        return 1
    return 0


def bitstream(arguments: argparse.Namespace) -> int:
    """Build the bitstream, print and write its facts; 1 if the clock is not reached."""
    from macram.cli.console import open_console  # noqa: PLC0415
    from macram.cli.stages import Stages  # noqa: PLC0415
    from macram.spec import ArrayConfig  # noqa: PLC0415
    from macram.synth import tables  # noqa: PLC0415
    from macram.synth.bitstream import build_bitstream  # noqa: PLC0415

    if arguments.seed < 0:
        raise ValueError(f"--seed must be 0 or more, not {arguments.seed}")
    config = ArrayConfig.from_toml(arguments.config)
    _check_timeout(arguments)
    report = build_bitstream(
        config,
        arguments.out,
        mhz=arguments.mhz,
        seed=arguments.seed,
        timeout=arguments.timeout,
        stage=Stages(open_console(), total=4),
    )
    _show("bitstream", tables.BITSTREAM_COLUMNS, tables.bitstream_rows(report))
    _write(arguments.out / "bitstream", report, tables.bitstream_markdown(report))
    if not report["met"]:
        print(
            f"macram: {report['fmax_mhz']} MHz is less than the {report['clock_mhz']} MHz asked for; "
            "try another --seed or a lower --mhz",
            file=sys.stderr,
        )
        return 1
    return 0


def _folder_name(array: str, device: str, flat: bool) -> str:
    return re.sub(r"[^\w.-]", "_", f"{array}-{device}{'-flat' if flat else ''}")


def _show(title: str, columns: tuple[str, ...], rows: list[list[str]]) -> None:
    from rich.table import Table  # noqa: PLC0415

    from macram.cli.console import open_console  # noqa: PLC0415

    table = Table(caption=title)
    for index, column in enumerate(columns):
        table.add_column(column, justify="left" if index == 0 or len(columns) == 2 else "right")
    for row in rows:
        table.add_row(*row)
    open_console().print(table)


def _write(stem: Path, report: dict[str, Any], page: str) -> None:
    from macram.cli.console import open_console  # noqa: PLC0415
    from macram.report.files import write_json, write_text  # noqa: PLC0415

    write_json(stem.with_suffix(".json"), report)
    write_text(stem.with_suffix(".md"), page)
    open_console().print(f"{stem}.json, {stem}.md", highlight=False, markup=False, soft_wrap=True)


def _check_timeout(arguments: argparse.Namespace) -> None:
    if arguments.timeout <= 0:
        raise ValueError(f"--timeout must be more than 0 seconds, not {arguments.timeout:g}")


def _lines(parser: argparse.ArgumentParser, epilog: str) -> None:
    parser.epilog = epilog
    parser.formatter_class = argparse.RawDescriptionHelpFormatter


def _out(parser: argparse.ArgumentParser, folder: str) -> None:
    parser.add_argument(
        "-o", "--out", type=Path, default=Path(folder), metavar="DIR", help=f"default: {folder}"
    )


def _timeout(parser: argparse.ArgumentParser, seconds: int) -> None:
    parser.add_argument(
        "--timeout",
        type=float,
        default=seconds,
        metavar="S",
        help=f"seconds for each tool (default: {seconds})",
    )
