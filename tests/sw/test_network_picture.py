"""A picture through the shipped 3-bit network by ``macram network --weights``, with software in the array's place."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import macram.synth.sources
import macram_sim.array
import macram_sim.hosted
from macram.cli import main
from macram.driver import COUNTERS
from macram.golden import conv2d
from macram.pack import unpack
from macram.pack.layout import unpack_weights
from macram.pack.signed import Rise
from macram.weights import find
from macram_sim.hosted import HostedResult

ROOT = Path(__file__).parents[2]
COMMAND = ["network", str(ROOT / "configs" / "zu3eg.toml"), "--weights", "quarter-w3a3"]


def computed(packed, image):
    """What the array makes of an image with these words: codes, or sums raised where its inputs are."""
    spec = packed.spec
    weights = unpack_weights(packed.weights, spec, packed.array)
    acc = conv2d(image, weights, stride=spec.stride, padding=spec.padding).astype(np.int64)
    if not packed.sums_out:
        return unpack(packed)[1].apply(acc)
    rise = Rise.of(weights, spec, packed.array)
    acc += rise.total[:, None, None]
    acc[:, :, 0] -= rise.left[:, None]
    acc[:, :, -1] -= rise.right[:, None]
    return acc


@pytest.fixture
def software_array(monkeypatch):
    """The simulator's place taken by `computed`; a list of what to break: index of the run, code to add to."""
    broken = []

    def simulate_hosted(layers, next_image, done, *, seed=0, told=None):
        for index, packed in enumerate(layers):
            codes = computed(packed, next_image(index))
            for run, place in broken:
                if run == index:
                    codes[place] ^= 1
            done(index, HostedResult(codes, dict.fromkeys(("cycles", *COUNTERS), 10), 12))

    monkeypatch.setattr(macram_sim.hosted, "simulate_hosted", simulate_hosted)
    monkeypatch.setattr(macram_sim.array, "build_array", lambda array: None)
    monkeypatch.setattr(macram.synth.sources, "design_hash", lambda array: "software")
    return broken


def test_the_pose_is_the_deployed_networks(software_array, tmp_path, capsys):
    """The example picture: 109 convolutions, exact sums from 23 of them, and the pose near the truth."""
    assert main([*COMMAND, "-o", str(tmp_path)]) == 0
    table = json.loads((tmp_path / "picture.json").read_text())
    assert (table["passed"], table["same_pose"], table["total"]["mismatches"]) == (True, True, 0)
    rows = table["convolutions"]
    assert (len(rows), sum(row["sums"] for row in rows)) == (109, 23)
    assert {row["output"] for row in rows if not row["sums"]} == {"u3"}
    assert table["array"]["partial_sum_c_in"] == 1024
    assert table["pose"] == table["pose_deployed"]
    assert table["errors"]["add_corners_d"] < 0.2
    said = capsys.readouterr().out
    for text in (said, (tmp_path / "picture.md").read_text(), (tmp_path / "picture.html").read_text()):
        assert f"0 of {table['total']['compared']:,} codes and sums differ" in text
        assert "the same to the last bit as the deployed network" in text
    assert (tmp_path / "picture.png").read_bytes().startswith(b"\x89PNG")


def test_one_code_is_red(software_array, tmp_path, capsys):
    """One code of the fifth convolution: it and what follows from it differ, and the command says so."""
    picture = tmp_path / "small.png"
    Image.fromarray(np.random.default_rng(1).integers(0, 256, (32, 32, 3)).astype(np.uint8)).save(picture)
    command = [*COMMAND, "--image", str(picture), "--focal", str(focal()), "-o"]
    assert main([*command, str(tmp_path / "well")]) == 0
    software_array.append((4, (0, 0, 0)))
    capsys.readouterr()
    assert main([*command, str(tmp_path / "broken")]) == 1
    assert "FAILED stage2.unit1.reduce: 1 of 1,024 differ" in capsys.readouterr().out
    rows = json.loads((tmp_path / "broken" / "picture.json").read_text())["convolutions"]
    assert [row["mismatches"] for row in rows[:5]] == [0, 0, 0, 0, 1]


def test_a_runs_own_network_is_called_after_its_folder(software_array, tmp_path, capsys, monkeypatch):
    """Every run's network is a model.safetensors: pages of two of them must not take one another's place."""
    monkeypatch.chdir(tmp_path)
    picture, run = tmp_path / "small.png", tmp_path / "run7"
    Image.fromarray(np.zeros((32, 32, 3), np.uint8)).save(picture)
    run.mkdir()
    (run / "model.safetensors").write_bytes(find("quarter-w3a3").path.read_bytes())
    command = [*COMMAND[:-1], "run7/model.safetensors", "--image", str(picture), "--focal", str(focal())]
    assert main(command) == 0
    table = json.loads((tmp_path / "build/network/zu3eg-run7/picture.json").read_text())
    assert table["network"].startswith("run7, 3 bit")


def test_a_damaged_result_is_computed_again(software_array, tmp_path, capsys):
    """Cut short, empty, or with bits that do not unpack: what is behind the last whole convolution is made anew."""
    picture = tmp_path / "small.png"
    Image.fromarray(np.random.default_rng(1).integers(0, 256, (32, 32, 3)).astype(np.uint8)).save(picture)
    command = [*COMMAND, "--image", str(picture), "--focal", str(focal()), "-o", str(tmp_path / "out")]
    assert main(command) == 0
    kept = next((tmp_path / "out" / "results").iterdir()) / "stage2.unit1.reduce.npz"
    whole = kept.read_bytes()
    flipped = bytearray(whole)
    for place in range(60, 90):
        flipped[place] ^= 0xFF
    for damaged in (whole[: len(whole) // 2], b"", bytes(flipped)):
        kept.write_bytes(damaged)
        assert main(command) == 0
        assert kept.read_bytes() != damaged


def focal():
    """Of the shipped network's training, so that the picture keeps its size."""
    from macram.train.checkpoint import load_model  # noqa: PLC0415

    return load_model(find("quarter-w3a3").path)[1].focal
