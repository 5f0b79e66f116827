"""``macram rtl``: write the array's Verilog, check that what is there is up to date, or lint it."""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

from macram.spec import ArrayConfig

MANIFEST = "manifest.json"


def rtl(arguments: argparse.Namespace) -> int:
    """Write into the folder; with ``--check`` compare, with ``--lint`` run Verilator over a fresh export."""
    config = ArrayConfig() if arguments.config is None else ArrayConfig.from_toml(arguments.config)
    if not (arguments.check or arguments.lint):
        _write(config, arguments.layer, arguments.out)
        print(f"Verilog of array {config.name} in {arguments.out}")
        return 0
    with tempfile.TemporaryDirectory(prefix="macram-rtl-") as name:
        fresh = Path(name)
        sources = _export(config, arguments.layer, fresh)
        failed = False
        if arguments.check:
            stale = out_of_date(fresh, arguments.out)
            for line in stale:
                print(f"{arguments.out}/{line}", file=sys.stderr)
            print(
                f"{arguments.out} is out of date: run `macram rtl`"
                if stale
                else f"{arguments.out} is what array {config.name} gives"
            )
            failed |= bool(stale)
        if arguments.lint:
            failed |= not _lint(fresh, sources)
    return 1 if failed else 0


def _write(config: ArrayConfig, layer: Path | None, folder: Path) -> None:
    """Export into a folder beside ``folder``, then move what has changed, file by file.

    The manifests leave first and come back last: a folder in which that was interrupted is nobody's export.
    """
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder.parent, prefix=f".{folder.name}-") as staging:
        fresh = Path(staging) / folder.name
        _export(config, layer, fresh)
        wanted = {path.relative_to(fresh) for path in fresh.rglob("*") if path.is_file()}
        stale = _listed(folder) - wanted
        changed = {name for name in wanted if not _equal(folder / name, fresh / name)}
        if not stale | changed:
            return
        manifests = {name for name in wanted if name.name == MANIFEST}
        for name in stale | manifests:
            (folder / name).unlink(missing_ok=True)
        for name in [*sorted(changed - manifests), *sorted(manifests)]:
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (fresh / name).replace(folder / name)


def _listed(folder: Path) -> set[Path]:
    """Files of an earlier export in ``folder`` by its manifests; only such names are ever removed."""
    found = set()
    for manifest in (Path(MANIFEST), Path("mem") / MANIFEST):
        try:
            names = [Path(name) for name in json.loads((folder / manifest).read_text())["sha256"]]
        except (OSError, ValueError, KeyError, TypeError):
            continue
        found |= {
            manifest.parent / name for name in names if ".." not in name.parts and not name.is_absolute()
        }
    return found


def _equal(path: Path, other: Path) -> bool:
    return path.is_file() and path.read_bytes() == other.read_bytes()


def _export(config: ArrayConfig, layer: Path | None, folder: Path) -> list[Path]:
    """Write Verilog, and memory images of ``layer`` or the self-test into ``mem``; the sources in order."""
    from macram.golden import selftest_case  # noqa: PLC0415
    from macram.layer_file import LayerCase  # noqa: PLC0415
    from macram.pack import pack_layer  # noqa: PLC0415
    from macram_hw.export import export_verilog  # noqa: PLC0415

    case = selftest_case(config) if layer is None else LayerCase.load(layer)
    try:
        packed = pack_layer(case, config)
    except ValueError as error:
        raise ValueError(f"{layer}: {error}" if layer else str(error)) from error
    mem_dir = folder / "mem"
    packed.write(mem_dir)
    return list(export_verilog(config, folder, mem_dir=mem_dir).sources)


def out_of_date(fresh: Path, folder: Path) -> list[str]:
    """A line for each file of ``fresh`` that ``folder`` lacks or holds with other bytes, and for each beside."""
    wanted, found = (
        {path.relative_to(root) for path in root.rglob("*") if path.is_file()} for root in (fresh, folder)
    )
    lines = []
    for name in sorted(wanted | found):
        if name not in found:
            lines.append(f"{name}: missing")
        elif name not in wanted:
            lines.append(f"{name}: does not belong here, remove it")
        elif (folder / name).read_bytes() != (fresh / name).read_bytes():
            lines.append(f"{name}: differs")
    return lines


def _lint(folder: Path, sources: list[Path]) -> bool:
    """Verilator's lint of an export, all warnings on; ``sources`` begin with the reasoned waivers."""
    from macram_sim.tools import find_toolchain  # noqa: PLC0415

    tools = find_toolchain()
    done = subprocess.run(
        [str(tools.verilator), "--lint-only", "-Wall", "--top-module", "macram_top", *map(str, sources)],
        env=tools.environment(),
        capture_output=True,
        text=True,
        check=False,
    )
    sys.stderr.write(done.stderr.replace(f"{folder}/", ""))
    print(
        f"verilator --lint-only -Wall: {len(sources)} files, {'clean' if done.returncode == 0 else 'FAILED'}"
    )
    return done.returncode == 0
