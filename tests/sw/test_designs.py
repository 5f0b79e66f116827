"""The report on designs: its rows against figures known from elsewhere, its pages against its JSON."""

import dataclasses
import json

import pytest

from macram.cli.app import main
from macram.designs import describe, describe_layer
from macram.designs.peers import PEERS
from macram.model.counts import conv_runs, count_network
from macram.model.sizes import spacenet_config
from macram.spec import ArrayConfig, ConvSpec

PAPER = spacenet_config("paper", "deployable")


@pytest.fixture(scope="module")
def runs():
    return conv_runs(PAPER)


def test_the_reference_layer_of_the_reference_array():
    """The figures of the architecture page."""
    row = describe(ArrayConfig()).reference
    assert (row["cycles"], row["macs"]) == (197_205, 1_207_959_552)
    parts = row["estimate"]
    assert (parts["fill"], parts["mac"], parts["stall"], parts["drain"]) == (530, 196_608, 0, 67)
    assert row["ms"] == 1.97205
    assert row["macs_per_beat"] == 1_207_959_552 / (128 * 128 * 8)


def test_simulated_cycles_replace_the_estimate():
    design = describe(ArrayConfig(), simulated={"cycles": 300_000}, resources={"dsp": 256, "lut": 40_000})
    assert design.reference["cycles"] == 300_000
    rate = 1_207_959_552 / 300_000
    assert design.density == {
        "macs_per_cycle": rate,
        "macs_per_dsp": rate / 256,
        "macs_per_klut": rate / 40,
    }


def test_runs_of_the_network_are_those_that_are_counted(runs):
    """Every convolution once per run; the paper's total (table IV)."""
    assert len(runs) == 118
    assert sum(run.macs for run in runs) == 70_696_882_176 == count_network(PAPER).macs()
    for run in runs:
        layer = ConvSpec(
            run.c_in, run.c_out, run.height, run.width,
            kernel=run.kernel, stride=run.stride, padding=run.kernel // 2,
        )  # fmt: skip
        assert layer.macs == run.macs
    by_name = {run.name: run for run in runs if run.part != "head"}
    first = by_name["backbone.stages.1.units.0.expand.conv"]
    assert (first.c_in, first.c_out, first.height, first.width, first.kernel) == (64, 128, 128, 128, 3)


def test_totals_are_sums_of_rows(runs):
    rows = [dataclasses.asdict(run) for run in runs[1:]]
    design = describe(ArrayConfig(), rows)
    admitted = [row for row in design.layers if row["refused"] is None]
    assert len(design.layers) == 117
    assert design.network["on_array"] == len(admitted) == 117
    # 512 -> 1024 with stride 2: 384 words for each of 16 tiles, in halves of 512 words.
    assert max(row["passes"] for row in admitted) == 16
    assert design.network["cycles"] == sum(row["cycles"] for row in admitted)
    for row in admitted:
        parts = row["estimate"]
        assert row["cycles"] == parts["fill"] + parts["mac"] + parts["stall"] + parts["drain"]
        assert row["utilisation"] <= 1
        # The roof over every point of the roofline.
        assert row["macs_per_cycle"] <= min(row["macs_per_beat"], design.array.peak_macs)


def test_a_refused_layer_says_why():
    array = ArrayConfig(name="tiny", units=8, rows=2, drain=2, max_c_in=16, max_c_out=32, weight_depth=64)
    row = describe_layer(array, "big", "head", ConvSpec(64, 128, 8, 8))
    assert row["cycles"] is None
    wanted = "c_in must be at most 16, not 64; build an array with a larger max_c_in, or with partial_sum_c_in = 64"
    assert row["refused"] == wanted


def test_pages(tmp_path, capsys):
    """Tables, pictures and JSON of one command say the same."""
    assert main(["designs", "configs/reference.toml", "configs/tiny.toml", "-o", str(tmp_path)]) == 0
    assert "reference: 197,205 cycles, 1.972 ms at 100 MHz" in capsys.readouterr().out
    table = json.loads((tmp_path / "designs.json").read_text())
    reference, tiny = table["designs"]
    assert reference["reference"]["cycles"] == 197_205
    assert tiny["reference"]["refused"]
    assert len(table["peers"]) == len(PEERS)
    markdown, page = ((tmp_path / f"designs.{kind}").read_text() for kind in ("md", "html"))
    for text in (markdown, page):
        assert "197,205" in text
        assert f"{reference['network']['cycles']:,}" in text
        assert tiny["reference"]["refused"] in text
        assert all(peer.name in text.replace("&#39;", "'") for peer in PEERS)
    for name in ("latency.png", "roofline-reference.png"):
        assert (tmp_path / name).read_bytes().startswith(b"\x89PNG")
        assert f"({name})" in markdown
    assert page.count("data:image/png;base64,") == 2
    assert not (tmp_path / "roofline-tiny.png").exists()


def test_two_arrays_of_one_name_are_refused(tmp_path, capsys):
    config = "configs/tiny.toml"
    assert main(["designs", config, config, "-o", str(tmp_path / "out")]) == 2
    assert "two arrays are named 'tiny'; give each configuration its own name" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
