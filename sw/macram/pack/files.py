"""Memory words as ``.mem`` (for ``$readmemh``) and ``.coe`` files with a manifest."""

from __future__ import annotations

import hashlib
import json
import tempfile
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np

from macram.pack.bits import Words
from macram.pack.layout import BIT_ORDER
from macram.spec import ArrayConfig, ConvSpec, IntFormat, ceil_div, parse_format

FORMAT, VERSION = "macram packed layer", 1
MANIFEST = "manifest.json"
SUFFIXES = (".mem", ".coe")
ROLES = ("sums_in", "sums_out")


def write_folder(
    folder: Path,
    spec: ConvSpec,
    array: ArrayConfig,
    requantiser: str,
    memories: dict[str, tuple[Words, int]],
    roles: dict[str, bool],
    *,
    comments: bool,
) -> None:
    """Write every memory twice and the manifest.

    Args:
        folder: made if it is not there, its parents too.
        spec: the layer, for the manifest and the header comments.
        array: the array, for the manifest.
        requantiser: key of `BIT_ORDER` for the memory ``requant``.
        memories: name -> words ``[depth, bytes]`` and their width in bits.
        roles: ``sums_in`` and ``sums_out`` of `macram.spec.LayerPass`, for the manifest.
        comments: begin each ``.mem`` file with the header.

    Raises:
        ValueError: the folder cannot be written.
    """
    texts: dict[str, str] = {}
    for name, (words, width) in memories.items():
        order = BIT_ORDER[requantiser if name == "requant" else "weights"]
        header = [
            f"{name}: {spec.c_in} -> {spec.c_out} channels, {spec.kernel}x{spec.kernel}, "
            f"{spec.height}x{spec.width}, weight {spec.weight}, input {spec.input}, output {spec.output}",
            f"{len(words)} words of {width} bits; {order}",
        ]
        lines = hex_lines(words, width)
        above = [f"// {line}" for line in header] if comments else []
        texts[f"{name}.mem"] = "\n".join([*above, *lines]) + "\n"
        texts[f"{name}.coe"] = (
            "".join(f"; {line.replace(';', ',')}\n" for line in header)
            + "memory_initialization_radix=16;\nmemory_initialization_vector=\n"
            + ",\n".join(lines)
            + ";\n"
        )
    manifest = {
        "format": FORMAT,
        "version": VERSION,
        "layer": _plain(spec),
        "roles": roles,
        "array": array.to_dict(),
        "requantiser": requantiser,
        "bit_order": {"unit_*": BIT_ORDER["weights"], "requant": BIT_ORDER[requantiser]},
        "words": {
            "unit_*": {"depth": array.weight_depth, "bits": array.weight_word_bits},
            "requant": {"depth": array.requant_depth, "bits": array.requant_word_bits},
        },
        "sha256": {name: hashlib.sha256(text.encode()).hexdigest() for name, text in texts.items()},
    }
    texts[MANIFEST] = json.dumps(manifest, indent=2) + "\n"
    try:
        _place(folder, texts)
    except OSError as error:
        raise ValueError(f"{folder}: cannot be written, {error.strerror}; choose another folder") from error


def read_folder(folder: Path) -> tuple[ConvSpec, ArrayConfig, dict[str, Words], dict[str, bool]]:
    """Inverse of `write_folder`: the layer, the array, every memory at full depth, and the roles.

    Raises:
        ValueError: one line naming the file and the fault.
    """
    path = folder / MANIFEST
    try:
        manifest = json.loads(path.read_text())
        if not isinstance(manifest, dict) or (manifest.get("format"), manifest.get("version")) != (
            FORMAT,
            VERSION,
        ):
            raise ValueError(f"is not a {FORMAT}, version {VERSION}; pack the layer again")
        spec, array = _spec(manifest["layer"]), ArrayConfig.from_dict(manifest["array"])
        sums = dict(manifest["sha256"])
        roles = {name: bool(manifest["roles"][name]) for name in ROLES}
    except FileNotFoundError as error:
        raise ValueError(f"{path}: no such file; pack the layer into this folder first") from error
    except KeyError as error:
        raise ValueError(f"{path}: key {error} is missing; pack the layer again") from error
    except (OSError, TypeError, ValueError) as error:
        raise ValueError(f"{path}: {error}") from error
    widths = {f"unit_{unit:03d}": (array.weight_word_bits, array.weight_depth) for unit in range(array.units)}
    widths["requant"] = (array.requant_word_bits, array.requant_depth)
    if set(sums) != {name + suffix for name in widths for suffix in SUFFIXES}:
        raise ValueError(f"{path}: does not list the files of this array; pack the layer again")
    texts = {name: _verified(folder / name, wanted) for name, wanted in sums.items()}
    memories = {}
    for name, (width, depth) in widths.items():
        try:
            memories[name] = words_from_mem(texts[f"{name}.mem"], width, depth)
        except ValueError as error:
            raise ValueError(f"{folder / name}.mem: {error}") from error
    return spec, array, memories, roles


def hex_lines(words: Words, width: int) -> list[str]:
    """Words ``[n, bytes]`` -> one hexadecimal number each, padded to ``ceil(width / 4)`` digits."""
    size, digits = words.shape[1], ceil_div(width, 4)
    text = np.ascontiguousarray(words[:, ::-1]).tobytes().hex()
    return [text[end - digits : end] for end in range(2 * size, len(text) + 1, 2 * size)]


def words_from_mem(text: str, width: int, depth: int) -> Words:
    """Inverse of `hex_lines` on the text of a ``.mem`` file.

    Raises:
        ValueError: other than ``depth`` words, or a line that is not a word of ``ceil(width / 4)`` digits.
    """
    size, digits = ceil_div(width, 8), ceil_div(width, 4)
    lines = [line for line in text.splitlines() if line and not line.startswith("//")]
    if len(lines) != depth:
        raise ValueError(f"must have {depth} words, not {len(lines)}")
    if wrong := [line for line in lines if len(line) != digits]:
        raise ValueError(f"words must have {digits} hexadecimal digits, not {wrong[0]!r}")
    raw = bytes.fromhex("".join(line.zfill(2 * size) for line in lines))
    return np.ascontiguousarray(np.frombuffer(raw, np.uint8).reshape(depth, size)[:, ::-1])


def _place(folder: Path, texts: dict[str, str]) -> None:
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder.parent, prefix=f".{folder.name}-") as staging:
        for name, text in texts.items():
            (Path(staging) / name).write_text(text)
        folder.mkdir(exist_ok=True)
        # Without its manifest a folder is refused, so no mixture of two layers is ever read.
        stale = _listed(folder)
        (folder / MANIFEST).unlink(missing_ok=True)
        for name in stale - set(texts):
            (folder / name).unlink(missing_ok=True)
        for name in texts:
            (Path(staging) / name).replace(folder / name)


def _listed(folder: Path) -> set[str]:
    """Memory files of the layer that lies in ``folder``, if any; only such names are ever removed."""
    try:
        names = set(json.loads((folder / MANIFEST).read_text())["sha256"])
    except (OSError, ValueError, KeyError, TypeError):
        return set()
    return {name for name in names if Path(name).name == name and name.endswith(SUFFIXES)}


def _verified(path: Path, wanted: str) -> str:
    try:
        raw = path.read_bytes()
    except OSError as error:
        raise ValueError(f"{path}: {error.strerror}; pack the layer again") from error
    if (found := hashlib.sha256(raw).hexdigest()) != wanted:
        raise ValueError(f"{path}: SHA-256 is {found[:12]}..., the manifest has {str(wanted)[:12]}...")
    return raw.decode()


def _plain(spec: ConvSpec) -> dict[str, Any]:
    return {
        field.name: str(value) if isinstance(value := getattr(spec, field.name), IntFormat) else value
        for field in fields(spec)
    }


def _spec(table: dict[str, Any]) -> ConvSpec:
    formats = {key: parse_format(table[key]) for key in ("weight", "input", "output")}
    return ConvSpec(**{**table, **formats})
