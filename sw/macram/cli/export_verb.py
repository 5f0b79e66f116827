"""``macram export``: a folder that a vendor tool builds."""

from __future__ import annotations

import argparse
import textwrap
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console

    from macram.cli.stages import Stages
    from macram.layer_file import LayerCase
    from macram.spec import ArrayConfig

EPILOG = """\
then, on a machine with Vivado:
  cd DIR && vivado -mode batch -source build.tcl     bitstream, .hwh and reports
  cd DIR && vivado -mode batch -source ooc.tcl       timing and utilisation of the array alone
and on a board with PYNQ, in a copy of DIR/overlay:
  python3 selftest.py                                registers, weights, error recovery
  python3 run_reference.py                           the layer, every code compared, cycles and milliseconds

DIR/README.md says what is in the folder and what has not been run on silicon.

An array that is larger than the board's device (360 DSP48E2, 216 RAMB36, 80 % of 70,560 LUT) is refused. DSP slices
and block RAM follow from the configuration; LUTs are checked if macram synth has counted exactly this design.
"""


def add_export(verb: Callable[[str, str, str, str], argparse.ArgumentParser]) -> None:
    """Registers the verb."""
    export = verb(
        "export",
        "export_verb",
        "write a Vivado project with an overlay for the Ultra96-V2",
        "",
    )
    export.description = textwrap.fill(
        "Write RTL, memory images, Tcl scripts (IP packaging, block design, build), constraints and a PYNQ overlay "
        "folder with driver, self-test and the golden codes of one layer. The same array and layer give the "
        "same bytes.",
        100,
    )
    export.epilog = EPILOG
    export.formatter_class = argparse.RawDescriptionHelpFormatter
    export.add_argument("target", choices=["vivado"], help="the tool to export for")
    export.add_argument("-o", "--out", type=Path, required=True, metavar="DIR", help="folder to write")
    export.add_argument(
        "--config",
        type=Path,
        metavar="CONFIG.toml",
        help="array to build (default: configs/zu3eg.toml, of those that fit the board's device the fastest on the "
        "reference layer)",
    )
    export.add_argument(
        "--synth", type=Path, metavar="DIR", help="where macram synth wrote its counts (default: build/synth)"
    )
    layer = export.add_mutually_exclusive_group()
    layer.add_argument(
        "--layer",
        type=Path,
        metavar="FILE.npz",
        help="layer whose weights the bitstream holds and the board runs (default: random codes of a seeded layer "
        "that fills the array)",
    )
    layer.add_argument(
        "--reference",
        action="store_true",
        help="the reference layer with the codes of the first example image (needs PyTorch)",
    )


def export(arguments: argparse.Namespace) -> int:
    """Write the folder."""
    # Late: the grammar above is loaded by every command, NumPy and Amaranth are not.
    from macram.cli.console import open_console  # noqa: PLC0415
    from macram.cli.stages import Stages  # noqa: PLC0415
    from macram.export import default_array, export_vivado  # noqa: PLC0415
    from macram.spec import ArrayConfig  # noqa: PLC0415

    array = default_array() if arguments.config is None else ArrayConfig.from_toml(arguments.config)
    console = open_console()
    stages = Stages(console)
    _check_fits(array, arguments, console)
    case = _case(arguments, array, stages)
    manifest = export_vivado(array, case, arguments.out, stage=stages)
    clocks = " and ".join(manifest["clocks"])
    console.print(
        f"array {array.name} with clocks {clocks}: {len(manifest['sha256'])} files in {arguments.out}; next, "
        f"there: vivado -mode batch -source build.tcl",
        highlight=False,
        markup=False,
        soft_wrap=True,
    )
    return 0


def _check_fits(array: ArrayConfig, arguments: argparse.Namespace, console: Console) -> None:
    """Refuse an array that is larger than the board's device; say so where its LUTs are not known."""
    from macram.cli.synth_verb import SYNTH_FOLDER  # noqa: PLC0415
    from macram.designs import find_resources  # noqa: PLC0415
    from macram.designs.resources import DEVICE  # noqa: PLC0415
    from macram.synth.devices import DEVICES  # noqa: PLC0415
    from macram.synth.fit import check_fits  # noqa: PLC0415

    folder = arguments.synth or SYNTH_FOLDER
    if arguments.synth is not None and not folder.is_dir():
        raise ValueError(f"{folder}: no such folder; name the one that macram synth wrote to")
    counted = find_resources(array, folder)
    check_fits(array, DEVICES[DEVICE], counted)
    if counted is None:
        console.print(
            f"LUTs not checked: {folder} has no counts of this design as it is now; "
            f"macram synth {arguments.config or 'configs/zu3eg.toml'} makes them",
            highlight=False,
            markup=False,
            soft_wrap=True,
        )


def _case(arguments: argparse.Namespace, array: ArrayConfig, stages: Stages) -> LayerCase:
    if arguments.reference:
        from macram.cli.app import SEED  # noqa: PLC0415
        from macram.demo import reference_front  # noqa: PLC0415

        with stages("image through the network to the layer"):
            return reference_front(None, checkpoint=None, seed=SEED)[1].case
    if arguments.layer is None:
        from macram.golden import selftest_case  # noqa: PLC0415

        return selftest_case(array)
    from macram.layer_file import LayerCase  # noqa: PLC0415

    case = LayerCase.load(arguments.layer)
    try:
        array.check_admits(case.spec)
    except ValueError as error:
        raise ValueError(f"{arguments.layer}: {error}") from error
    return case
