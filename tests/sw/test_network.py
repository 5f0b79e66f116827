"""The table of simulated layer shapes: which there are, what counts as done, what is red, what the pages say."""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path

import pytest

from macram.cli import main
from macram.designs import describe
from macram.layer_job import COUNTERS, layer_table
from macram.model.counts import conv_runs
from macram.model.sizes import spacenet_config
from macram.network import distinct_shapes, find_record, network_table, wanted_shapes
from macram.network.page import HEAD, cells, markdown, summary, write_network
from macram.network.record import record_path
from macram.perf import estimate_passes
from macram.spec import ArrayConfig

CONFIGS = Path(__file__).parents[2] / "configs"
ZU3EG = ArrayConfig.from_toml(CONFIGS / "zu3eg.toml")
TINY = ArrayConfig.from_toml(CONFIGS / "tiny-blocks.toml")


@pytest.fixture(scope="module")
def runs():
    """Convolutions of the full-size network that run on an array."""
    return [
        dataclasses.asdict(run)
        for run in conv_runs(spacenet_config("paper", "deployable"))
        if run.part != "first"
    ]


@pytest.fixture(scope="module")
def shapes(runs):
    return distinct_shapes(runs, ZU3EG)


def as_estimated(shape, **changes):
    """A record whose counters are the closed form's."""
    row = describe(shape.array, [run_of(shape)]).layers[0]["estimate"]
    counters = dict.fromkeys(COUNTERS, 0)
    counters |= {f"{cause}_cycles": row[cause] for cause in ("mac", "fill", "drain")}
    counters |= {"input_stalls": row["stall"], "cycles": row["total"]}
    counters |= {name: counters[name] + changes.pop(name) for name in list(changes) if name in counters}
    spec = shape.spec
    codes = spec.c_out * spec.out_height * spec.out_width
    return {"counters": counters, "compared": codes, "mismatches": 0, "simulation_seconds": 1.0} | changes


def run_of(shape):
    spec = shape.spec
    fields = ("c_in", "c_out", "height", "width", "kernel", "stride")
    return {"name": shape.names[0], "part": shape.part} | {name: getattr(spec, name) for name in fields}


def test_the_shapes_are_all_convolutions(shapes, runs):
    """117 convolutions in 34 shapes, the reference layer's shape twice; together the cycles of macram designs."""
    assert (len(runs), len(shapes), sum(len(shape.names) for shape in shapes)) == (117, 34, 117)
    assert len({shape.label for shape in shapes}) == 34
    reference = next(shape for shape in shapes if shape.label == "64-128-128x128-3x3-1")
    assert reference.names == tuple(f"backbone.stages.1.units.{unit}.expand.conv" for unit in (0, 1))
    assert reference.cycles == 148_057
    whole = describe(ZU3EG, runs).network["cycles"]
    assert sum(shape.cycles * len(shape.names) for shape in shapes) == whole
    assert sum(shape.spec.macs * len(shape.names) for shape in shapes) == sum(run["macs"] for run in runs)


def test_some_can_be_chosen_the_shortest_first(shapes):
    assert {shape.part for shape in wanted_shapes(shapes, ["head"])} == {"head", "pyramids"}
    for texts in ([], ["head."], ["64-128-", "fpn.top"]):
        cycles = [shape.cycles for shape in wanted_shapes(shapes, texts)]
        assert cycles == sorted(cycles)
    assert [shape.label for shape in wanted_shapes(shapes, ["units.1.reduce", "64-128-128"])] == [
        "1024-512-16x16-1x1-1",
        "512-256-32x32-1x1-1",
        "256-128-64x64-1x1-1",
        "128-64-128x128-1x1-1",
        "64-128-128x128-3x3-1",
    ]
    with pytest.raises(ValueError, match="--only tail: no convolution has this"):
        wanted_shapes(shapes, ["head", "tail"])


def test_what_the_array_refuses_is_no_work(runs):
    shapes = distinct_shapes(runs, TINY)
    refused = [shape for shape in shapes if shape.refused]
    assert refused
    assert not set(wanted_shapes(shapes, [])) & set(refused)
    table = network_table(TINY, shapes, {})
    assert table.total["on_array"] == 117 - sum(len(shape.names) for shape in refused)
    assert f"The array refuses {sum(len(shape.names) for shape in refused)}." in summary(table)
    assert "partial_sum_c_in" in markdown(table, "", "")


def test_totals_count_every_convolution(shapes, runs):
    """With every shape simulated as estimated, the table is that of macram designs."""
    table = network_table(ZU3EG, shapes, {shape: as_estimated(shape) for shape in shapes})
    assert table.passed
    assert table.complete
    total, wanted = table.total, describe(ZU3EG, runs).network
    for name in ("macs", "cycles", "ms", "macs_per_cycle"):
        assert total[name] == wanted[name]
    assert total["lost"]["total"] == wanted["cycles"] == total["estimated"] == total["estimated_simulated"]
    assert total["lost"]["needed"] == pytest.approx(wanted["lost"]["needed"], rel=1e-12)
    assert total["macs_per_cycle_per_dsp"] == total["macs_per_cycle"] / 320
    assert total["compared"] == sum(row["compared"] for row in table.rows)


def test_a_part_is_only_a_part(shapes):
    some = wanted_shapes(shapes, ["stages.2"])
    table = network_table(ZU3EG, shapes, {shape: as_estimated(shape) for shape in some})
    assert table.passed
    assert not table.complete
    assert table.total["simulated"] == 17
    assert table.total["cycles"] == sum(shape.cycles * len(shape.names) for shape in some)
    assert f"17 of 117 convolutions, {len(some)} of 34 shapes" in summary(table)
    assert markdown(table, "", "").count("not simulated") == 34 - len(some)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"mismatches": 1}, "FAILED: codes differ"),
        ({"drain_cycles": 1, "cycles": 1}, "FAILED: cycles differ"),
        ({"cycles": 1, "mac_cycles": 2}, "FAILED: cycles differ"),
        ({"mac_cycles": -1, "drain_cycles": 2}, "FAILED: cycles differ"),
    ],
    ids=["a code", "a cycle more", "a cause too many", "cycles without a cause"],
)
def test_one_wrong_number_is_red(shapes, changes, said):
    reference = next(shape for shape in shapes if shape.label == "64-128-128x128-3x3-1")
    table = network_table(ZU3EG, shapes, {reference: as_estimated(reference, **changes)})
    assert not table.passed
    assert [row[-1] for row in cells(table) if row[2].startswith("64 -> 128, 128")] == [said]


def test_a_stream_may_be_near(shapes):
    """Where a stream is the limit the closed form says so, and a cycle more is no failure."""
    shape = next(shape for shape in shapes if shape.label == "256-128-64x64-1x1-1")
    table = network_table(ZU3EG, shapes, {shape: as_estimated(shape, cycles=1, input_stalls=1)})
    assert table.passed
    assert "Cycles are exactly the estimated ones in 0 of 1 shapes." in summary(table)
    assert sum("ok; input stream" in row for row in cells(table)) == 1


@pytest.mark.parametrize(
    ("label", "counted"),
    [
        ("128-64-128x128-1x1-1", 114_752),
        ("256-128-64x64-1x1-1", 53_368),
        ("1024-256-16x16-3x3-2", 53_332),
        ("256-256-8x8-3x3-2", 2_651),
    ],
)
def test_near_is_near(shapes, label, counted):
    """Cycles that the array counted, docs/network-zu3eg.md, where its input stream is the limit."""
    shape = next(shape for shape in shapes if shape.label == label)
    assert abs(shape.cycles - counted) <= 4
    assert {part.limited_by for part in estimate_passes(shape.spec, ZU3EG)} == {"input"}


def test_pages_say_what_the_json_says(tmp_path, shapes):
    some = {shape: as_estimated(shape) for shape in wanted_shapes(shapes, ["stages.4"])}
    page = write_network(
        tmp_path,
        network_table(ZU3EG, shapes, some),
        network="paper",
        command="macram network",
        about={"seed": 1},
    )
    table = json.loads((tmp_path / "network.json").read_text())
    assert (table["passed"], table["complete"], table["seed"]) == (True, False, 1)
    for text in (page.read_text().replace("&gt;", ">"), (tmp_path / "network.md").read_text()):
        assert f"{table['total']['cycles']:,}" in text
        for row in table["shapes"]:
            assert f"{row['c_in']} -> {row['c_out']}, {row['height']} x {row['width']}" in text
            assert f"{row['estimated']:,}" in text
        assert all(head in text for head in HEAD)


def test_the_page_has_room_for_its_table(tmp_path, shapes):
    """18 columns do not fit into a page for reading; layers' names may break at their points, and nowhere else."""
    first = dataclasses.replace(shapes[0], names=("a<b.conv",))
    table = network_table(ZU3EG, [first], {first: as_estimated(first)})
    text = write_network(tmp_path, table, network="", command="", about={}).read_text()
    assert '<main class="wide">' in text
    assert "a&lt;b.<wbr>conv" in text
    assert f">{table.rows[0]['estimate']['total']:,}<" in text
    assert text.count("<wbr>") == 1


def test_records_belong_to_design_shape_and_seed(tmp_path, shapes):
    first, second = shapes[:2]
    path = record_path(tmp_path, first, "a" * 64, 1)
    assert path.name.startswith(first.label)
    others = [(second, "a" * 64, 1), (first, "b" * 64, 1), (first, "a" * 64, 2)]
    assert len({path, *(record_path(tmp_path, *other) for other in others)}) == 4
    record = {"design": "a" * 64, "layer": layer_table(first.spec), "seed": 1}
    path.write_text(json.dumps(record))
    assert find_record(tmp_path, first, "a" * 64, 1) == record
    assert all(find_record(tmp_path, *other) is None for other in others)
    for damaged in (json.dumps(record)[:-5], "[]", json.dumps(record | {"design": "b"})):
        path.write_text(damaged)
        assert find_record(tmp_path, first, "a" * 64, 1) is None


@pytest.mark.parametrize(
    ("arguments", "line"),
    [
        (["--limit", "-1"], "--limit must be 0 or more, not -1"),
        (["--side", "33"], "image_size must be a multiple of 32, not 33"),
        (["--only", "nowhere"], "--only nowhere: no convolution has this in its name or shape"),
        (["--size", "huge"], "size must be one of"),
        (["--image", "a.png"], "--image and --focal go with --weights"),
        (["--weights", "quarter-w3a3", "--limit", "3"], "--limit has no part in a run with --weights"),
        (["--weights", "quarter-w3a3", "--limit", "0"], "--limit has no part in a run with --weights"),
        (["--weights", "quarter-w3a3", "--seed", "0"], "--seed has no part in a run with --weights"),
        (["--weights", "nothing"], "no file and no shipped weights 'nothing'"),
    ],
)
def test_bad_input_is_one_line(tmp_path, capsys, arguments, line):
    assert main(["network", str(CONFIGS / "tiny.toml"), "-o", str(tmp_path / "out"), *arguments]) == 2
    assert line in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
