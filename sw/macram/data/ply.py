"""Vertices of PLY meshes, text or binary."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from macram.data.geometry import Floats

_TYPES = {
    "char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2", "ushort": "u2",
    "uint16": "u2", "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4", "float": "f4", "float32": "f4",
    "double": "f8", "float64": "f8",
}  # fmt: skip


def read_vertices(path: Path) -> Floats:
    """``[V, 3]`` vertices in the file's unit.

    Raises:
        ValueError: missing, or not a PLY file whose first element are vertices with x, y, z.
    """
    try:
        content = path.read_bytes()
    except FileNotFoundError:
        raise ValueError(f"{path}: file is missing") from None
    try:
        return _parse(content)
    except (ValueError, KeyError, IndexError) as error:
        raise ValueError(f"{path}: not a readable PLY mesh ({error})") from None


def _parse(content: bytes) -> Floats:
    head, mark, body = content.partition(b"end_header\n")
    if not mark:
        head, mark, body = content.partition(b"end_header\r\n")
    lines = [line.split() for line in head.decode("ascii").splitlines()]
    if not mark or lines[0] != ["ply"]:
        raise ValueError("no PLY header")
    kind = next(words[1] for words in lines if words[:1] == ["format"])
    elements = [number for number, words in enumerate(lines) if words[:1] == ["element"]]
    first = lines[elements[0]]
    if first[1] != "vertex":
        raise ValueError(f"first element is {first[1]!r}, not vertex")
    end = elements[1] if len(elements) > 1 else len(lines)
    properties = [words for words in lines[elements[0] : end] if words[0] == "property"]
    count, names = int(first[2]), [words[-1] for words in properties]
    columns = [names.index(axis) for axis in "xyz"]
    if kind == "ascii":
        rows = body.split(maxsplit=count * len(names))[: count * len(names)]
        return np.array(rows, np.float64).reshape(count, len(names))[:, columns]
    order = {"binary_little_endian": "<", "binary_big_endian": ">"}[kind]
    record = np.dtype([(words[-1], order + _TYPES[words[1]]) for words in properties])
    table = np.frombuffer(body, record, count)
    return np.stack([table[axis].astype(np.float64) for axis in "xyz"], axis=1)


def ply_text(vertices: Floats, triangles: NDArray[np.intp]) -> str:
    """An ASCII PLY of ``[V, 3]`` vertices and ``[T, 3]`` triangles."""
    head = [
        "ply", "format ascii 1.0", f"element vertex {len(vertices)}",
        "property float x", "property float y", "property float z",
        f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header",
    ]  # fmt: skip
    points = [" ".join(f"{value:.6g}" for value in vertex) for vertex in vertices]
    faces = ["3 " + " ".join(map(str, triangle)) for triangle in triangles]
    return "\n".join([*head, *points, *faces]) + "\n"
