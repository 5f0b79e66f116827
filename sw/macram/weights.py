"""The networks that come with macram, by name: one index beside them, every file held against its hash.

They lie in ``weights/`` of the repository and, installed with pip, in ``macram/shipped``.
"""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

INDEX = "index.json"
FORMAT = 1
PLACES = (Path(__file__).parent / "shipped", Path(__file__).resolve().parents[2] / "weights")
"""Of an installed package; of a repository."""
ROLES = ("pose", "reference_layer")
"""What the demo takes a network for: the pose of a picture; the paper-size layer that runs on the array."""


@dataclass(frozen=True, slots=True)
class Shipped:
    """One line of the index.

    Attributes:
        name: to load it by.
        path: its file.
        about: everything the index says: ``file``, ``sha256``, ``bytes``, ``sizes``, ``size``, ``variant``,
            ``mode``, ``bits``, ``stored``, ``history`` (command, seed, images of every stage), ``dataset``,
            ``scores``.
    """

    name: str
    path: Path
    about: dict[str, Any]

    def checked(self) -> Path:
        """`path`, if its content is what the index says.

        Raises:
            ValueError: missing, or another SHA-256.
        """
        if not self.path.is_file():
            raise ValueError(f"{self.path}: shipped weights {self.name!r} are missing; fetch the file again")
        found = sha256(self.path)
        if found != self.about["sha256"]:
            raise ValueError(
                f"{self.path}: SHA-256 is {found[:12]}..., the index says {self.about['sha256'][:12]}...; "
                "fetch the file again"
            )
        return self.path


def folder() -> Path:
    """Where the shipped networks and their index are.

    Raises:
        ValueError: this installation has none.
    """
    for place in PLACES:
        if (place / INDEX).is_file():
            return place
    raise ValueError("this installation has no shipped weights; give the path of a model.safetensors")


def shipped(place: Path | None = None) -> dict[str, Shipped]:
    """Every shipped network by name, in the order of the index.

    Args:
        place: folder with an index; by default `folder`.

    Raises:
        ValueError: no index, or a broken one.
    """
    place = place or folder()
    return {
        name: Shipped(name, place / about["file"], about) for name, about in _index(place)["networks"].items()
    }


def role(name: str, place: Path | None = None) -> Shipped | None:
    """The network of one of `ROLES`, or None where none is shipped for it yet.

    Raises:
        ValueError: no index, a broken one, or one that names a network it does not have.
    """
    place = place or folder()
    chosen = _index(place)["demo"].get(name, "")
    return find(chosen, place) if chosen else None


def find(name: str, place: Path | None = None) -> Shipped:
    """The network called ``name``.

    Raises:
        ValueError: there is none.
    """
    known = shipped(place)
    if name not in known:
        raise ValueError(f"no file and no shipped weights {name!r}; shipped: {', '.join(known)}")
    return known[name]


def weights_file(choice: str) -> Path:
    """A network's file: the path given, if it exists or looks like one, else the shipped file of that name.

    Raises:
        ValueError: neither, or the shipped file is not what the index says.
    """
    path = Path(choice)
    if path.is_file() or path.suffix or len(path.parts) != 1:
        return path  # a path that does not exist is refused by whoever reads it, in its own words
    return find(choice).checked()


def read_index(place: Path) -> dict[str, Any]:
    """The index of ``place``, or an empty one where there is none yet."""
    if not (place / INDEX).is_file():
        return {"format": FORMAT, "demo": dict.fromkeys(ROLES, ""), "networks": {}}
    return _index(place)


def sha256(path: Path) -> str:
    """Of a file, as hexadecimal digits."""
    return hashlib.sha256(path.read_bytes()).hexdigest()


def _index(place: Path) -> dict[str, Any]:
    path = place / INDEX
    try:
        table: dict[str, Any] = json.loads(path.read_text())
        if table["format"] != FORMAT:
            raise ValueError(f"{path}: has format {table['format']}, this version reads {FORMAT}")
        if not all({"file", "sha256"} <= about.keys() for about in table["networks"].values()):
            raise ValueError(f"{path}: a network has no file or no sha256; fetch the index again")
    except (OSError, json.JSONDecodeError, KeyError, AttributeError, TypeError) as error:
        raise ValueError(f"{path}: not an index of weights ({error}); fetch it again") from None
    return table
