"""The report on designs: its rows against figures known from elsewhere, its pages against its JSON."""

import dataclasses
import json
from pathlib import Path

import pytest

from macram.cli.app import main
from macram.designs import describe, describe_layer, find_resources
from macram.designs.losses import LOSSES
from macram.designs.peers import PEERS
from macram.model.counts import conv_runs, count_network
from macram.model.sizes import spacenet_config
from macram.spec import ArrayConfig, ConvSpec
from macram.synth import cost
from macram.synth.sources import design_hash

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


COUNTERS = {
    "cycles": 300_000, "mac_cycles": 280_000, "fill_cycles": 9_000, "input_stalls": 7_000, "output_stalls": 3_000,
    "drain_cycles": 1_000,
}  # fmt: skip


def test_simulated_cycles_replace_the_estimate():
    design = describe(ArrayConfig(), simulated=COUNTERS, resources={"dsp": 256, "lut": 40_000})
    assert design.reference["lost"] == {
        "needed": 196_608, "unused": 83_392, "fill": 9_000, "stall": 10_000, "drain": 1_000, "total": 300_000,
    }  # fmt: skip
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
    assert design.network["lost"]["drain"] == sum(row["estimate"]["drain"] for row in admitted)
    assert design.network["lost"]["total"] == design.network["cycles"]
    # 512 -> 1024 with stride 2: 384 words for each of 16 tiles, in halves of 512 words.
    assert max(row["passes"] for row in admitted) == 16
    assert design.network["cycles"] == sum(row["cycles"] for row in admitted)
    for row in admitted:
        parts = row["estimate"]
        assert row["cycles"] == parts["fill"] + parts["mac"] + parts["stall"] + parts["drain"]
        assert row["utilisation"] <= 1
        lost = row["lost"]
        assert lost["total"] == row["cycles"]
        assert lost["needed"] + sum(lost[cause] for cause in LOSSES) == pytest.approx(
            row["cycles"], rel=1e-12
        )
        assert min(lost.values()) >= 0
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
    (tmp_path / "synth").mkdir()
    arrays = ["configs/reference.toml", "configs/tiny.toml"]
    assert main(["designs", *arrays, "-o", str(tmp_path), "--synth", str(tmp_path / "synth")]) == 0
    said = capsys.readouterr().out
    assert "reference: 197,205 cycles, 1.972 ms at 100 MHz" in said
    assert "has no counts of this design as it is now; macram synth configs/tiny.toml makes them" in said
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
        assert text.count("not yet: macram synth on its configuration") == 2
        assert "Closed form: the cycles that a simulation" in text
        assert "Ours is a simulation" not in text
        assert all(peer.name in text.replace("&#39;", "'") for peer in PEERS)
    for name in ("latency.png", "roofline-reference.png"):
        assert (tmp_path / name).read_bytes().startswith(b"\x89PNG")
        assert f"({name})" in markdown
    assert page.count("data:image/png;base64,") == 2
    assert not (tmp_path / "roofline-tiny.png").exists()


# ---- counts of macram synth ----------------------------------------------------------------------------

CONFIG = Path(__file__).parents[2] / "configs/tiny.toml"
TINY = ArrayConfig.from_toml(CONFIG)


@pytest.fixture
def synthesised(tmp_path, monkeypatch):
    """A folder with what ``macram synth`` writes for the tiny array; Yosys is replaced by a number of cells."""
    stat = {"modules": {"\\macram_top": {"num_cells_by_type": {"LUT6": 7_056, "DSP48E2": 36, "RAMB18E2": 3}}}}

    def fake(script, folder, **_):
        (folder / "stat.json").write_text(json.dumps(stat))

    monkeypatch.setattr(cost, "run_yosys", fake)
    folder = tmp_path / "counts"
    assert main(["synth", str(CONFIG), "-o", str(folder / "tiny")]) == 0
    return folder


def change(path, **values):
    path.write_text(json.dumps(json.loads(path.read_text()) | values))


def test_counts_are_found_by_the_design(synthesised):
    found = find_resources(TINY, synthesised)
    assert (found["lut"], found["dsp"], found["bram"], found["percent"]["lut"]) == (7_056, 36, 1.5, 10.0)
    assert (found["mode"], found["fits"], found["design"]) == ("hierarchical", True, design_hash(TINY))
    assert find_resources(dataclasses.replace(TINY, name="renamed"), synthesised) == found
    assert find_resources(dataclasses.replace(TINY, weight_depth=65), synthesised) is None
    assert find_resources(TINY, synthesised / "elsewhere") is None


@pytest.mark.parametrize(
    "values",
    [{"design": "0" * 64}, {"device": "ecp5-85k"}, {"format": 1}],
    ids=["of older gateware", "of another device", "of an older version"],
)
def test_counts_of_something_else_are_not_used(synthesised, values):
    change(synthesised / "tiny/synth.json", **values)
    assert find_resources(TINY, synthesised) is None


def test_the_flat_count_goes_before_the_other(synthesised):
    report = json.loads((synthesised / "tiny/synth.json").read_text())
    for name, mode in (("a", "hierarchical"), ("z", "flat")):
        (synthesised / name).mkdir()
        (synthesised / name / "synth.json").write_text(json.dumps(report | {"mode": mode}))
    for name, text in (("broken", "{"), ("other", "[1]")):
        (synthesised / name).mkdir()
        (synthesised / name / "synth.json").write_text(text)
    assert find_resources(TINY, synthesised)["file"] == (synthesised / "z/synth.json").as_posix()


def test_the_pages_have_the_counts(synthesised, tmp_path, capsys):
    small = ArrayConfig(name="small", units=8, drain=2)
    config = tmp_path / "small.toml"
    lines = [f"{key} = {json.dumps(value)}\n" for key, value in small.to_dict().items()]
    config.write_text("[array]\n" + "".join(lines))
    assert main(["synth", str(config), "-o", str(synthesised / "small")]) == 0
    out = tmp_path / "out"
    arguments = ["designs", str(config), str(CONFIG), "--network", "none", "--synth", str(synthesised)]
    capsys.readouterr()
    assert main([*arguments, "-o", str(out)]) == 0
    assert "has no counts" not in capsys.readouterr().out
    table = json.loads((out / "designs.json").read_text())
    rate = describe(small).reference["macs_per_cycle"]
    assert table["designs"][0]["density"]["macs_per_klut"] == 1e3 * rate / 7_056
    assert table["designs"][1]["resources"]["dsp"] == 36
    for kind in ("md", "html"):
        text = (out / f"designs.{kind}").read_text()
        assert text.count("36 (10 %)") == 2
        assert f"hierarchical, xczu3eg; design {design_hash(TINY)[:12]}" in text
        assert f"{rate / 7.056:.1f}" in text, "MAC per cycle and thousand LUTs"
        assert "needed at the peak" in text
    assert {path.name for path in out.glob("density*")} == {"density.png", "density-lut.png"}


def test_a_missing_folder_of_counts_is_named(tmp_path, capsys):
    assert main(["designs", "--synth", str(tmp_path / "none"), "-o", str(tmp_path / "out")]) == 2
    assert "none: no such folder; name the one that macram synth wrote to" in capsys.readouterr().err


def test_two_arrays_of_one_name_are_refused(tmp_path, capsys):
    config = "configs/tiny.toml"
    assert main(["designs", config, config, "-o", str(tmp_path / "out")]) == 2
    assert "two arrays are named 'tiny'; give each configuration its own name" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
