"""A rendered data set that is fixed for good: its specification and the hash of its poses, as a file."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from pathlib import Path

from macram.data.files import read_json
from macram.data.spec import GENERATOR, RenderSpec


@dataclass(frozen=True, slots=True)
class Recipe:
    """A data set by name.

    Attributes:
        name: with its version.
        spec: what to render.
        poses_sha256: of every pose, as ``dataset.json`` has it.
    """

    name: str
    spec: RenderSpec
    poses_sha256: str

    @property
    def version(self) -> str:
        """Name and beginning of the hash, as records have it."""
        return f"{self.name}, poses {self.poses_sha256[:12]}"

    def check(self, root: Path) -> None:
        """Holds a finished data set against the recipe.

        Raises:
            ValueError: other poses, or not finished.
        """
        found = read_json(root / "dataset.json").get("poses_sha256")
        if found != self.poses_sha256:
            raise ValueError(
                f"{root}: its poses have SHA-256 {found}, {self.name} has {self.poses_sha256[:12]}..."
            )


def read_recipe(path: Path) -> Recipe:
    """A recipe from TOML.

    Raises:
        ValueError: no such file, not a recipe, or one for another generator.
    """
    try:
        table = tomllib.loads(path.read_text())
        values = dict(table["render"])
        generator = values.pop("generator")
        for key in ("size", "depth", "sequences"):
            values[key] = tuple(values[key])
        spec, name, poses = RenderSpec(**values), str(table["name"]), str(table["poses_sha256"])
    except FileNotFoundError:
        raise ValueError(f"{path}: no such recipe") from None
    except (tomllib.TOMLDecodeError, KeyError, TypeError) as error:
        raise ValueError(f"{path}: not a recipe ({error}); see configs/cubesat1u-v1.toml") from None
    if generator != GENERATOR:
        raise ValueError(
            f"{path}: is for generator {generator}, this is {GENERATOR}; install the macram of that data"
        )
    return Recipe(name, spec, poses)
