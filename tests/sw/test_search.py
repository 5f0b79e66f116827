"""The search for the fastest array that fits: its estimate, its ranking, and what stops what."""

from __future__ import annotations

import dataclasses
import json

import pytest

from macram.cli import main
from macram.cli.designs_search import UNITS, unit_array
from macram.designs import describe, search
from macram.designs.lut_model import LutModel, read_counts, shell_of, unit_of
from macram.export import default_array
from macram.spec import ArrayConfig
from macram.synth.devices import DEVICES

SHIPPED = default_array()
ZU3EG = DEVICES["xczu3eg"]
RUNS = [
    {"name": "a", "part": "backbone", "c_in": 64, "c_out": 128, "height": 32, "width": 32, "kernel": 3, "stride": 1},
    {"name": "b", "part": "backbone", "c_in": 128, "c_out": 64, "height": 32, "width": 32, "kernel": 1, "stride": 1},
    {"name": "c", "part": "head", "c_in": 64, "c_out": 128, "height": 32, "width": 32, "kernel": 3, "stride": 2},
]  # fmt: skip


def report(array, unit, shell, memory, dsp=9):
    """What macram synth writes, with these LUTs of a unit, of the rest and of memories."""
    rows = [
        ("macram_unit", array.units, array.units * unit, 320),
        ("decoder", 1, shell, dsp),
        ("macram_ram", 67, memory, 0),
    ]
    return {
        "array": array.to_dict(), "design": "0" * 64,
        "modules": [dict(zip(("name", "instances", "lut", "dsp"), row, strict=True)) for row in rows],
        "total": {"lut": sum(row[2] for row in rows), "dsp": 320 + dsp},
    }  # fmt: skip


def linear(array):
    """Counts that the model must find again: 200 and 30, 50 and 100 for the engines; outside 4,000 and 100 per row."""
    kinds = array.row_kinds
    terms = 30 * kinds.count("dsp48e2") + 25 * kinds.count("dsp48e2_2x") + 100 * kinds.count("soft")
    return 200 + terms, 4_000 + 100 * array.rows


@pytest.fixture
def model():
    single = dataclasses.replace(SHIPPED, name="single", engine="dsp48e2", rows=6, requant_ram="block")
    arrays = [report(SHIPPED, *linear(SHIPPED), 3_700), report(single, *linear(single), 0)]
    mixes = [unit_array(SHIPPED, *unit) for unit in UNITS]
    units = [{"kinds": list(mix.row_kinds), "lut": linear(mix)[0]} for mix in mixes]
    table = {"units": units + [unit_of(one) for one in arrays], "arrays": [shell_of(one) for one in arrays]}
    return LutModel.fit(table)


def test_a_linear_cost_is_found_again(model):
    assert model.worst < 1e-9
    assert model.unit_terms == pytest.approx([200, 30, 50, 100])
    assert (model.requant_lut, model.shell_dsp) == (3_700, 9)
    array = dataclasses.replace(SHIPPED, units=32, rows=9, soft_rows=3)
    assert model.luts(array) == pytest.approx(32 * (200 + 3 * 50 + 3 * 100) + 4_000 + 900 + 3_700)
    assert model.luts(dataclasses.replace(array, requant_ram="block")) == pytest.approx(
        model.luts(array) - 3_700
    )


def test_an_error_is_told():
    arrays = [shell_of(report(SHIPPED, 600, 5_000, 0)), shell_of(report(SHIPPED, 600, 5_000, 0))]
    kinds = ["dsp48e2"], ["soft"], ["dsp48e2_2x"] * 2, ["soft"] * 2, ["soft"]
    units = [
        {"kinds": list(one), "lut": lut} for one, lut in zip(kinds, (300, 300, 300, 400, 400), strict=True)
    ]
    assert LutModel.fit({"units": units, "arrays": arrays}).worst > 0.1


@pytest.fixture
def small(monkeypatch):
    monkeypatch.setattr(search, "UNITS", (32, 64))
    monkeypatch.setattr(search, "SOFT_ROWS", range(3))


def test_the_ranking(model, small):
    found = search.search(SHIPPED, ZU3EG, RUNS, model)
    assert [one.total for one in found] == sorted(one.total for one in found)
    kinds = {(one.array.units, one.array.row_kinds) for one in found}
    assert len(kinds) == len(found)
    assert (64, SHIPPED.row_kinds) in kinds
    assert (64, ("soft",) * 2) in kinds
    for one in found[:: max(1, len(found) // 12)]:
        design = describe(one.array, RUNS)
        assert one.reference == design.reference["cycles"]
        assert one.network == design.network["cycles"]
        assert design.network["on_array"] == len(RUNS)
    limit = {key: ZU3EG.limit(key) for key in ("lut", "dsp", "bram")}
    for one in found:
        over = [key for key in limit if one.used[key] > limit[key]]
        assert len(one.stopped_by) == len(over)
        assert (
            all(key.upper() in phrase for key, phrase in zip(over, sorted(one.stopped_by), strict=False))
            or len(over) > 1
        )
    assert any(one.stopped_by for one in found)
    assert any(not one.stopped_by for one in found)


def test_waits_for_loads():
    """Words of the next pass load beside a run if both lie in the memories; else the array waits for all of them."""
    array = dataclasses.replace(SHIPPED, units=16, rows=2, soft_rows=0, weight_depth=100, max_c_out=1024)
    requant = -(-array.requant_word_bits // 64)
    part = search._Pass
    load = 16 * 40 + 4 * requant
    assert search._waits([part(10_000, 40, 4)], array) == load
    assert search._waits([part(10_000, 60, 4), part(5, 40, 4)], array) == 16 * 60 + 4 * requant
    assert search._waits([part(100, 60, 4), part(5, 40, 4)], array) == 16 * 60 + 4 * requant + load - 100
    assert search._waits([part(10_000, 61, 4), part(5, 40, 4)], array) == 16 * 61 + 4 * requant + load
    assert search._waits([part(10_000, 4, 253), part(5, 40, 4)], array) == 16 * 4 + 253 * requant + load


def test_the_counts_of_the_package():
    """They fit, the shipped arrays are among them, and the units are those that --recount counts."""
    counts = read_counts()
    model = LutModel.fit(counts)
    assert {array["array"]["name"] for array in counts["arrays"]} == {"zu3eg", "paper"}
    assert [tuple(unit["kinds"]) for unit in counts["units"][: len(UNITS)]] == [
        unit_array(SHIPPED, *unit).row_kinds for unit in UNITS
    ]
    assert model.worst < 0.15
    for array in model.arrays:
        assert abs(array["estimate"] / array["lut"] - 1) < 0.08


def test_the_command(tmp_path, small, capsys):
    out = tmp_path / "search"
    assert main(["designs", "--search", "xczu3eg", "--network", "tiny", "-o", str(out)]) == 0
    said = capsys.readouterr().out
    assert "largest error" in said
    assert "of older gateware" not in said, "the counts of the package are those of today's units"
    table = json.loads((out / "search.json").read_text())
    assert table["shipped"]["array"] == SHIPPED.to_dict()
    assert (table["shipped"]["mix"], table["shipped"]["used"]["bram"]) == ("64 x (5 DSP 2x + 1 soft)", 203)
    assert table["limits"] == {"lut": 56_448, "dsp": 360, "bram": 216}
    totals = [one["network_cycles"] + one["load_cycles"] for one in table["candidates"]]
    assert totals == sorted(totals)
    best = next(one for one in table["candidates"] if not one["stopped_by"])
    text = (out / "search.md").read_text()
    assert f"{best['network_cycles']:,}" in text
    assert best["mix"] in text
    quickest = min(
        (one for one in table["candidates"] if not one["stopped_by"]), key=lambda one: one["reference_cycles"]
    )
    assert (
        f"{quickest['reference_cycles']:,}" in text.split("## The fastest that fit on the reference layer")[1]
    )
    assert (out / "search.png").read_bytes().startswith(b"\x89PNG")
    assert ArrayConfig.from_dict(best["array"]).units in (32, 64)


def test_recounting_writes_a_table_that_can_be_used(tmp_path, small, monkeypatch, capsys):
    """Yosys and the reports of the two arrays are replaced; the table is the package's in form."""
    monkeypatch.setattr("macram.synth.unit.unit_hash", lambda array: str(array.row_kinds))
    monkeypatch.setattr("macram.synth.unit.count_unit", lambda array, *_, **__: {"lut": linear(array)[0]})

    def counted(array, folder):
        path = tmp_path / f"{array.name}.json"
        words = 3_700 if array.requant_ram == "distributed" else 0
        path.write_text(json.dumps(report(array, *linear(array), words)))
        return {"mode": "hierarchical", "file": str(path)}

    monkeypatch.setattr("macram.designs.find_resources", counted)
    out = tmp_path / "out"
    command = ["designs", "--search", "xczu3eg", "--recount", "--network", "tiny", "-o", str(out)]
    assert main(command) == 0
    assert "largest error 0.0 %" in capsys.readouterr().out
    table, package = read_counts(out / "unit_counts.json"), read_counts()
    assert table.keys() == package.keys()
    assert [unit["kinds"] for unit in table["units"]] == [unit["kinds"] for unit in package["units"]]
    assert json.loads((out / "search.json").read_text())["counts"] == str(out / "unit_counts.json")


def test_older_counts_are_told(tmp_path, small, capsys, monkeypatch):
    monkeypatch.setattr("macram.synth.unit.unit_hash", lambda array: "0" * 64)
    assert main(["designs", "--search", "xczu3eg", "--network", "tiny", "-o", str(tmp_path)]) == 0
    assert f"{len(UNITS)} counted units are of older gateware" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--search", "abacus"], "--search must be xczu3eg, not 'abacus'"),
        (
            ["--search", "xczu3eg", "--network", "none"],
            "--search ranks by a network; name one with --network",
        ),
        (["--search", "xczu3eg", "--simulate"], "leave out CONFIG.toml and --simulate"),
        (["--search", "xczu3eg", "--synth", "nowhere"], "--search reads --synth only to count anew"),
        (["--recount"], "--recount belongs to --search; name a device with --search xczu3eg"),
        (
            ["--search", "xczu3eg", "--recount", "--synth", "nowhere"],
            "nowhere has no hierarchical counts of zu3eg",
        ),
    ],
)
def test_bad_arguments_are_one_line(arguments, message, tmp_path, capsys):
    assert main(["designs", *arguments, "-o", str(tmp_path / "out")]) == 2
    error = capsys.readouterr().err.strip()
    assert message in error
    assert "\n" not in error
