"""Counting synthesised cells, names that survive Yosys, and how failures end."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from macram.cli import main
from macram.spec import ArrayConfig
from macram.spec.selftest import scrambled_beats
from macram.synth import board, cost, devices, tools
from macram.synth.bitstream import array_clock
from macram.synth.plan import make_plan
from macram.synth.sources import plain_names, spoken_name
from macram.synth.stat import instances, read_stat, short_name

ROOT = Path(__file__).parents[2]
TINY = ROOT / "configs" / "tiny.toml"
# What Yosys 0.70 writes, cut down to what is read: two units in a top, one memory of a parameterised module each.
MEMORY = "$paramod$0123456789abcdef\\macram_ram"
STAT = {
    "creator": "Yosys 0.70",
    "modules": {
        "\\macram_unit": {"num_cells_by_type": {"LUT2": 3, "LUT6": 7, "FDRE": 5, "RAM32M16": 1, "$scopeinfo": 2}},
        "\\macram_top_DOT_array_DOT_unit000": {
            "num_cells_by_type": {"INV": 1}, "num_submodules_by_type": {"\\macram_unit": 1, MEMORY: 1},
        },
        "\\macram_top_DOT_array_DOT_unit001": {
            "num_cells_by_type": {}, "num_submodules_by_type": {"\\macram_unit": 1, MEMORY: 1},
        },
        MEMORY: {"num_cells_by_type": {"RAMB18E2": 3}},
        "\\macram_top": {
            "num_cells_by_type": {"SRL16E": 4, "DSP48E2": 2, "CARRY4": 9},
            "num_submodules_by_type": {
                "\\macram_top_DOT_array_DOT_unit000": 1, "\\macram_top_DOT_array_DOT_unit001": 1,
            },
        },
    },
}  # fmt: skip


@pytest.fixture
def stored(tmp_path, monkeypatch):
    """Yosys is replaced by its stored statistic."""

    def fake(script, folder, **_):
        (folder / "stat.json").write_text(json.dumps(STAT))

    monkeypatch.setattr(cost, "run_yosys", fake)
    return tmp_path


def test_every_instance_is_counted_once(tmp_path):
    (tmp_path / "stat.json").write_text(json.dumps(STAT))
    modules = read_stat(tmp_path / "stat.json")
    assert instances(modules, "macram_top") == {
        "macram_top": 1, "macram_unit": 2, MEMORY: 2,
        "macram_top_DOT_array_DOT_unit000": 1, "macram_top_DOT_array_DOT_unit001": 1,
    }  # fmt: skip
    with pytest.raises(ValueError, match="no module nothing; it has"):
        instances(modules, "nothing")


def test_resources_of_the_stored_run(stored):
    report = cost.synthesise(
        ArrayConfig.from_toml(TINY), devices.DEVICES["xczu3eg"], stored, flat=False, timeout=1
    )
    # Two units of 3 + 7 + 8 LUT, four shift registers; the inverter is free; RAMB18 are halves.
    assert report["total"] == {"lut": 40, "ff": 10, "dsp": 2, "bram": 3}
    assert report["percent"] == {"lut": 0.1, "ff": 0.0, "dsp": 0.6, "bram": 1.4}
    rows = {row["name"]: row for row in report["modules"]}
    assert set(rows) == {"macram_unit", "macram_ram", "macram_top"}
    assert (rows["macram_unit"]["instances"], rows["macram_unit"]["lut"]) == (2, 36)
    assert (rows["macram_ram"]["instances"], rows["macram_ram"]["bram"]) == (2, 3)
    assert report["excess"] == []


def test_a_design_that_is_too_large_is_written_and_refused(stored, monkeypatch, capsys):
    small = replace(devices.DEVICES["xczu3eg"], capacity={"lut": 49, "ff": 10, "dsp": 1, "bram": 3})
    monkeypatch.setitem(devices.DEVICES, "xczu3eg", small)
    assert main(["synth", str(TINY), "-o", str(stored)]) == 1
    error = capsys.readouterr().err.strip()
    assert error.startswith("macram: array tiny does not fit xczu3eg: 40 LUT of 39; 2 DSP of 1; use fewer")
    assert "\n" not in error
    assert json.loads((stored / "synth.json").read_text())["excess"] == ["40 LUT of 39", "2 DSP of 1"]
    assert "| total |  | 40 | 10 | 2 | 3 |" in (stored / "synth.md").read_text()


def test_an_unknown_cell_is_no_zero():
    with pytest.raises(ValueError, match="cell MYSTERY has no entry"):
        devices.DEVICES["ecp5-85k"].count({"LUT4": 1, "MYSTERY": 1})
    assert devices.DEVICES["ecp5-85k"].count({"LUT4": 1, "CCU2C": 2, "TRELLIS_DPR16X4": 1, "$scopeinfo": 3}) == {
        "lut": 11, "ff": 0, "dsp": 0, "bram": 0,
    }  # fmt: skip


@pytest.mark.parametrize("text", ["{}", '{"modules": 3}', "no JSON"])
def test_a_statistic_that_is_none_is_named(tmp_path, text):
    (tmp_path / "stat.json").write_text(text)
    with pytest.raises(ValueError, match=r"stat\.json is no JSON statistic"):
        read_stat(tmp_path / "stat.json")


def test_names_are_plain_and_can_be_read_again():
    text = plain_names("wire \\$5 ;\nassign \\engine0.lanes[3] = \\$5 ;\n")
    assert "\\" not in text
    assert text.startswith("wire _DOLLAR_5 ;")
    assert spoken_name("macram_top_DOT_array") == "macram_top.array"
    assert short_name("macram_top_DOT_array_DOT_unit017") == "unitNNN"
    assert short_name("macram_top_DOT_array_DOT_drain_DOT_requant") == "drain.requant"
    with pytest.raises(ValueError, match="would both be called a_DOT_b"):
        plain_names("wire \\a.b ; wire \\a_DOT_b ;")


# ---- tools ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("command", [["synth", str(TINY)], ["bitstream", str(TINY)]])
def test_a_missing_tool_says_how_to_install_it(tmp_path, monkeypatch, capsys, command):
    monkeypatch.setattr(tools.importlib.util, "find_spec", lambda name: None)
    assert main([*command, "-o", str(tmp_path)]) == 2
    assert capsys.readouterr().err.strip() == (
        "macram: error: yosys is not installed; pip install 'macram[synth]'"
    )


def test_the_message_of_a_failed_tool_is_quoted(tmp_path):
    with pytest.raises(tools.ToolError, match="yosys failed: ERROR: No such command: nonsense"):
        tools.run_yosys("nonsense\n", tmp_path, name="bad", timeout=120)


def test_a_tool_that_takes_too_long_is_stopped(tmp_path):
    with pytest.raises(tools.ToolTimeout, match=r"yosys had no result after 0\.01 s"):
        tools.run_yosys("help\n", tmp_path, name="slow", timeout=0.01)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ["synth", str(TINY), "--device", "abacus"],
            "--device must be one of xczu3eg, ecp5-85k, not 'abacus'",
        ),
        (["synth", str(TINY), "--timeout", "0"], "--timeout must be more than 0 seconds, not 0"),
        (
            ["bitstream", str(TINY), "--mhz", "101"],
            "the clock must be a multiple of 4 MHz up to 320, not 101 MHz",
        ),
        (["bitstream", str(TINY), "--mhz", "4"], "the PLL's oscillator runs at 400 to 800 MHz"),
        (["bitstream", str(TINY), "--seed", "-1"], "--seed must be 0 or more, not -1"),
    ],
)
def test_bad_arguments_are_one_line(tmp_path, capsys, arguments, message):
    assert main([*arguments, "-o", str(tmp_path)]) == 2
    error = capsys.readouterr().err.strip()
    assert message in error
    assert "\n" not in error


# ---- board and self-test --------------------------------------------------------------------------------


@pytest.mark.parametrize("mhz", [8, 48, 100, 132, 200, 320])
def test_dividers_give_the_clock_within_the_pll_s_range(mhz):
    dividers = board.pll_dividers(mhz)
    assert board.OSCILLATOR_MHZ * dividers["CLKFB_DIV"] == mhz * dividers["CLKI_DIV"]
    assert 400 <= mhz * dividers["CLKOP_DIV"] <= 800


def test_every_port_of_the_board_has_a_pin():
    text = board.constraints()
    verilog = (ROOT / "hw/macram_hw/verilog/macram_ecp5_evn.v").read_text()
    for port in ("clk12", "button_n"):
        assert f'LOCATE COMP "{port}"' in text
        assert f"wire       {port}" in verilog
    assert len(set(board.LEDS)) == 8
    assert text.count("LOCATE") == text.count("IOBUF") == 10


def test_the_slowest_clock_behind_the_pll_counts():
    fmax = {
        "clk": {"achieved": 104.2, "constraint": 100.0},
        "other": {"achieved": 98.5, "constraint": 100.0},
        "clk12": {"achieved": 40.0, "constraint": 12.0},
    }
    assert array_clock(fmax) == 98.5
    with pytest.raises(ValueError, match="no clock above 12 MHz, only clk12"):
        array_clock({"clk12": fmax["clk12"]})


def test_the_generator_s_words():
    """Marsaglia's 32-bit generator from 1: the first values as anybody computes them."""
    words = scrambled_beats(1, 3, 32).view("<u4").ravel().tolist()
    assert words == [1, 270369, 67634689]
    assert scrambled_beats(1 << 63, 2, 64).shape == (2, 8)
    with pytest.raises(ValueError, match="stream_bits of 32 or 64, not 128"):
        scrambled_beats(1, 1, 128)
    with pytest.raises(ValueError, match=r"seed must be in 1\.\."):
        scrambled_beats(0, 1, 32)


def test_a_plan_depends_on_its_seed_alone():
    array = ArrayConfig.from_toml(TINY)
    first, packed = make_plan(array, 5)
    assert (first, packed.weights.tobytes()) == (
        make_plan(array, 5)[0],
        make_plan(array, 5)[1].weights.tobytes(),
    )
    assert first.crc != make_plan(array, 6)[0].crc
    assert first.writes[-1] == (8, 1), "the last write starts the array"


@pytest.mark.slow
def test_yosys_on_a_real_array(tmp_path):
    """The smallest array; the figures may drift with Yosys, their relations may not."""
    array = replace(ArrayConfig.from_toml(TINY), units=4, rows=1, drain=1)
    report = cost.synthesise(array, devices.DEVICES["ecp5-85k"], tmp_path, flat=False, timeout=600)
    rows = {row["name"]: row for row in report["modules"]}
    assert rows["macram_unit"]["instances"] == array.units
    assert 300 < rows["macram_unit"]["lut"] / array.units < 900
    for key in ("lut", "ff", "dsp", "bram"):
        assert sum(row[key] for row in rows.values()) == report["total"][key]
    # One memory of 64 x 9 bits per unit, two line-buffer banks, output buffer, requantiser.
    assert report["total"]["bram"] >= array.units + 4
