"""The folder that Vivado turns into a bitstream for the Ultra96-V2 in one command."""

from __future__ import annotations

import hashlib
import json
import tempfile
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from importlib import resources
from pathlib import Path
from string import Template
from typing import Any

from macram import __version__
from macram.export.overlay import write_overlay
from macram.export.ports import clocks, read_ports
from macram.export.settings import CLOCK_MHZ, PARTS, constraints_xdc, settings_tcl
from macram.golden import run_layer
from macram.layer_file import LayerCase
from macram.pack import pack_layer
from macram.spec import ArrayConfig
from macram_hw.export import TOPLEVEL, export_verilog

FORMAT, VERSION = "macram vivado export", 1
MANIFEST = "manifest.json"
SCRIPTS = ("build.tcl", "design.tcl", "ooc.tcl", "package_ip.tcl", "part.tcl")

Stage = Callable[[str], AbstractContextManager[Any]]
"""Opens a named stage; the command line prints a line with its seconds."""


def export_vivado(
    array: ArrayConfig, case: LayerCase, folder: Path, *, stage: Stage = nullcontext
) -> dict[str, Any]:
    """Write RTL, memory images, Tcl scripts, constraints and the overlay.

    The same array and layer give the same bytes. In a folder that holds an earlier export its files are replaced;
    what Vivado left there (``work``, ``ip``, ``reports``, the bitstream) stays.

    Args:
        array: the array to build.
        case: the layer whose weights the bitstream starts up with, and that the board runs and compares.
        folder: made if missing.
        stage: opens a named stage.

    Returns:
        The table written to ``manifest.json``: array, layer, clocks and the SHA-256 of every file.

    Raises:
        ValueError: the array does not admit the layer, or ``folder`` holds something else.
    """
    folder = Path(folder)
    earlier = _listed(folder)
    packed = pack_layer(case, array)
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder.parent, prefix=f".{folder.name}-") as staging:
        root = Path(staging)
        with stage("Verilog and memory images"):
            # UG901 allows a data file nothing but words; mem/manifest.json says what they are.
            packed.write(root / "mem", comments=False)
            sources, verilog = _write_rtl(array, root)
        with stage("golden codes of the layer"):
            expected = run_layer(case)
        with stage("scripts and overlay"):
            ports = read_ports(verilog, TOPLEVEL)
            (root / "settings.tcl").write_text(settings_tcl(array, ports, sources))
            (root / "constraints.xdc").write_text(constraints_xdc(ports))
            for name in SCRIPTS:
                (root / name).write_text(_resource(name))
            (root / "README.md").write_text(_readme(array, case, clocks(ports)))
            write_overlay(root / "overlay", array, case, expected)
            manifest = {
                "format": FORMAT,
                "version": VERSION,
                "macram": __version__,
                "array": array.to_dict(),
                "layer": str(case.spec),
                "clocks": clocks(ports),
                "clock_mhz": CLOCK_MHZ,
                "sha256": {
                    path.relative_to(root).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
                    for path in sorted(root.rglob("*"))
                    if path.is_file()
                },
            }
            _place(root, folder, manifest, earlier)
    return manifest


def _write_rtl(array: ArrayConfig, root: Path) -> tuple[list[str], str]:
    """Export into ``root/rtl`` what synthesis reads; the names relative to ``root``, and the top level's text."""
    with tempfile.TemporaryDirectory(dir=root) as scratch:
        export_verilog(array, Path(scratch))
        # The list leaves out simulation models; waivers are for Verilator alone.
        listed = (Path(scratch) / f"{TOPLEVEL}.f").read_text().split()
        names = [name for name in listed if name.endswith(".v")]
        (root / "rtl").mkdir()
        for name in (*names, "registers.md"):
            (Path(scratch) / name).replace(root / "rtl" / name)
    return [f"rtl/{name}" for name in names], (root / f"rtl/{TOPLEVEL}.v").read_text()


def _resource(name: str) -> str:
    return (resources.files("macram.export") / "tcl" / name).read_text(encoding="utf-8")


def _readme(array: ArrayConfig, case: LayerCase, clock_names: list[str]) -> str:
    spec = case.spec
    if len(clock_names) == 1:
        clock = f"`pl_clk0` of the PS at {CLOCK_MHZ} MHz drives everything."
    else:
        clock = (
            f"A clocking wizard (one MMCM, fed by `pl_clk0`) makes `aclk` of {CLOCK_MHZ} MHz and `aclk2x` of "
            f"{2 * CLOCK_MHZ} MHz with aligned edges and matched routing."
        )
    return Template(_resource("README.md")).substitute(
        name=array.name,
        units=array.units,
        rows=array.rows,
        engine=array.engine,
        layer=f"{spec.c_in} -> {spec.c_out} channels, {spec.height}x{spec.width}, kernel {spec.kernel}",
        clock=clock,
        parts=" or ".join(f"`{part}`" for part in PARTS),
    )


def _listed(folder: Path) -> set[str]:
    """Files of an earlier export in ``folder``; only such names are ever removed.

    Raises:
        ValueError: the folder is something else.
    """
    if not folder.exists() or (folder.is_dir() and not any(folder.iterdir())):
        return set()
    try:
        manifest = json.loads((folder / MANIFEST).read_text())
        if manifest["format"] != FORMAT:
            raise ValueError
        return {name for name in manifest["sha256"] if ".." not in name and not name.startswith("/")}
    except (OSError, ValueError, KeyError, TypeError):
        raise ValueError(
            f"{folder}: holds something other than an earlier export; choose a new or empty folder"
        ) from None


def _place(root: Path, folder: Path, manifest: dict[str, Any], earlier: set[str]) -> None:
    folder.mkdir(exist_ok=True)
    # The earlier manifest goes last: should this be interrupted, the next export still knows what is its own.
    for name in manifest["sha256"]:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).replace(folder / name)
    for name in earlier - set(manifest["sha256"]):
        (folder / name).unlink(missing_ok=True)
    (root / MANIFEST).write_text(json.dumps(manifest, indent=2) + "\n")
    (root / MANIFEST).replace(folder / MANIFEST)
