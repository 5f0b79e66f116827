"""``macram weights list | pack | index``."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from macram.cli.status import OK

DETAIL = (
    "Wherever a command takes weights, such a name serves as well as the path of a model.safetensors: "
    "macram predict --weights quarter-w3a3 picture.png -o poses."
)


def add_weights(verb: Callable[[str, str, str, str], argparse.ArgumentParser]) -> None:
    """The grammar of ``macram weights``; ``verb`` makes a top-level verb."""
    top = verb("weights", "weights_verb", "list the shipped networks, pack one, index one", DETAIL)
    actions = top.add_subparsers(dest="action", metavar="ACTION", required=True)

    table = actions.add_parser(
        "list",
        help="names, scores and sizes of the shipped networks",
        description="Checks every file against its SHA-256, then prints scores and sizes: the theory of the "
        "paper's table V (parameters times bits) beside the packed file. M and MB are 2^20.",
    )
    table.add_argument("--json", action="store_true", help="print the index as JSON")

    pack = actions.add_parser(
        "pack",
        help="make a network's file small",
        description="Quantised weights become codes of 3 or 8 bits side by side, the rest stays float32: the "
        "deployed network is the same to the last bit. A float network is stored in 16 bits.",
    )
    pack.add_argument("model", type=Path, metavar="MODEL.safetensors", help="of a run")
    pack.add_argument("-o", "--out", type=Path, required=True, metavar="FILE", help="packed file to write")

    index = actions.add_parser(
        "index",
        help="put a packed file into its folder's index.json",
        description="Takes size, bits, commands and seeds from the file, the version of its data from the folders it "
        "learned from, and its scores from an evaluation of this very file (macram evaluate FILE).",
    )
    index.add_argument("name", help="to load it by")
    index.add_argument("file", type=Path, metavar="FILE", help="in the folder of the index")
    index.add_argument("--config", type=Path, nargs="+", required=True, metavar="TOML",
                       help="training configurations of its stages, in order")  # fmt: skip
    index.add_argument("--evaluation", type=Path, required=True, metavar="JSON", help="of macram evaluate")
    index.add_argument("--role", default="", metavar="ROLE", help="of the demo: pose or reference_layer")


def weights(arguments: argparse.Namespace) -> int:
    """Run one action."""
    action: Callable[[argparse.Namespace], int] = ACTIONS[arguments.action]
    return action(arguments)


def _list(arguments: argparse.Namespace) -> int:
    from rich.table import Table  # noqa: PLC0415

    from macram.cli.console import open_console  # noqa: PLC0415
    from macram.weights import folder, read_index, shipped  # noqa: PLC0415

    networks = shipped()
    for network in networks.values():
        network.checked()
    if arguments.json:
        print(json.dumps(read_index(folder()), indent=2))
        return OK
    table = Table(title=f"shipped networks in {folder().name}/", title_justify="left")
    for column in (
        "name",
        "form",
        "ADD-0.1d",
        "0.2d",
        "0.5d",
        "frames",
        "#Para.",
        "ideal",
        "codes",
        "floats",
        "file",
    ):
        table.add_column(column, justify="left" if column in ("name", "form") else "right")
    for name, network in networks.items():
        about = network.about
        scores, sizes = about["scores"], about["sizes"]
        table.add_row(
            name,
            about["stored"],
            *(f"{scores['add'][limit]:.2f} %" for limit in ("0.1", "0.2", "0.5")),
            f"{scores['frames']:,}",
            f"{sizes['parameters'] / MEBI:.2f} M",
            *(f"{sizes[key] / MEBI:.3f} MB" for key in ("ideal", "codes", "floats", "file")),
        )
    console = open_console()
    console.print(table)
    console.print(
        f"{folder()}: {len(networks)} files, every SHA-256 as in index.json", highlight=False, markup=False
    )
    return OK


def _pack(arguments: argparse.Namespace) -> int:
    from macram.train.checkpoint import load_model, save_packed  # noqa: PLC0415
    from macram.train.packed import file_sizes  # noqa: PLC0415

    net, card = load_model(arguments.model)
    save_packed(arguments.out, net, card)
    sizes = file_sizes(arguments.out, sum(p.numel() for p in net.parameters()), card.bits)
    print(
        f"{arguments.out}: {sizes.file:,} bytes ({sizes.codes:,} of codes, {sizes.floats:,} of floats, "
        f"{sizes.header:,} of header); {sizes.parameters:,} parameters at {sizes.bits} bits are {sizes.ideal:,.1f}"
    )
    return OK


def _index(arguments: argparse.Namespace) -> int:
    from macram.data.open import dataset_version  # noqa: PLC0415
    from macram.report.files import write_json  # noqa: PLC0415
    from macram.train.checkpoint import load_model  # noqa: PLC0415
    from macram.train.packed import file_sizes  # noqa: PLC0415
    from macram.train.record import stage_records  # noqa: PLC0415
    from macram.weights import INDEX, ROLES, read_index, sha256  # noqa: PLC0415

    if arguments.role and arguments.role not in ROLES:
        raise ValueError(f"--role must be one of {', '.join(ROLES)}, not {arguments.role!r}")
    net, card = load_model(arguments.file)
    place = arguments.file.parent
    evaluation = _read(arguments.evaluation)
    details, summary = evaluation["details"], evaluation["summary"]
    if details.get("sha256") != sha256(arguments.file):
        raise ValueError(f"{arguments.evaluation}: is of another file; run macram evaluate {arguments.file}")
    stages = [
        {**stage, "dataset": dataset_version(Path(record["config"]["data"]["root"]))}
        for stage, record in zip(stage_records(card, arguments.config), card.history, strict=True)
    ]
    parameters = sum(p.numel() for p in net.parameters())
    sizes = file_sizes(arguments.file, parameters, card.bits)
    first = card.history[0]["config"]["network"]
    table = read_index(place)
    table["networks"][arguments.name] = {
        "file": arguments.file.name,
        "sha256": sha256(arguments.file),
        "bytes": sizes.file,
        "sizes": sizes.to_dict(),
        "size": first["size"],
        "variant": first["variant"],
        "mode": card.mode,
        "bits": card.bits,
        "stored": f"{card.bits}-bit codes, mode {card.mode}" if card.mode else "float, 16 bits",
        "stages": stages,
        "seed": stages[-1]["seed"],
        "scores": {
            "source": details["command"],
            "dataset": details["dataset"],
            "form": details["form"],
            "frames": summary["frames"],
            "misses": summary["misses"],
            "add": summary["fixed"]["all"]["add"],
        },
    }
    if arguments.role:
        table["demo"][arguments.role] = arguments.name
    write_json(place / INDEX, table)
    print(f"{place / INDEX}: {arguments.name}, SHA-256 {sha256(arguments.file)}")
    return OK


def _read(path: Path) -> Mapping[str, Any]:
    from macram.data.files import read_json  # noqa: PLC0415

    table = read_json(path)
    if not isinstance(table, dict) or "summary" not in table or "details" not in table:
        raise ValueError(f"{path}: not an evaluation; give the evaluation.json of macram evaluate")
    return table


MEBI = 2**20
ACTIONS = {"list": _list, "pack": _pack, "index": _index}
