"""What an installed package finds beside itself, where a checkout has folders of its own."""

from __future__ import annotations

import tomllib
from pathlib import Path

from macram import demo, weights

ROOT = Path(__file__).parents[2]


def test_the_wheel_takes_weights_and_examples_along_to_where_they_are_looked_for():
    table = tomllib.loads((ROOT / "pyproject.toml").read_text())
    taken = table["tool"]["hatch"]["build"]["targets"]["wheel"]["force-include"]
    package = Path(demo.__file__).parent
    for source, places in (("weights", weights.PLACES), ("examples", demo.PLACES)):
        installed, checkout = places
        assert installed == package / Path(taken[source]).relative_to("macram")
        assert checkout == ROOT / source
        assert checkout.is_dir()


def test_the_demo_finds_its_examples_beside_an_installed_package(tmp_path, monkeypatch):
    installed = tmp_path / "examples"
    installed.mkdir()
    for name in ("test_near.jpg", "frame_0.png", "frame_0_mask.png"):
        (installed / name).write_bytes((ROOT / "examples" / name).read_bytes())
    monkeypatch.setattr(demo, "PLACES", (installed, tmp_path / "absent"))
    assert demo.demo_image() == installed / "test_near.jpg"
    assert demo.example_images() == [installed / "frame_0.png"]
    monkeypatch.setattr(demo, "PLACES", (tmp_path / "absent",))
    assert demo.demo_image() is None
    assert demo.example_images() == []
