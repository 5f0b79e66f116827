"""What an array takes of a device without synthesis, and that `macram export` refuses what is too large."""

from __future__ import annotations

import json
import re
from collections import Counter
from dataclasses import replace
from pathlib import Path

import pytest

from macram.cli import main
from macram.spec import ArrayConfig
from macram.synth import cost
from macram.synth.devices import DEVICES
from macram.synth.fit import check_fits
from macram.synth.memories import BlockMemory, block_memories, block_ram, dsp_slices
from macram.synth.stat import instances, read_stat
from macram.synth.tools import run_yosys
from macram_hw.export import export_verilog, model_path

CONFIGS = Path(__file__).parents[2] / "configs"
TINY = ArrayConfig.from_toml(CONFIGS / "tiny.toml")
ZU3EG = DEVICES["xczu3eg"]
ARRAYS = {
    "tiny": TINY,
    "odd sizes": replace(
        TINY, rows=3, row_words=24, max_c_out=40, weight_depth=77, ingest=1, partial_sum_c_in=64
    ),
    "slices at both clocks": replace(
        TINY, rows=5, engine="dsp48e2_2x", soft_rows=1, requant_ram="distributed"
    ),
    "slices at one clock": replace(TINY, rows=4, engine="dsp48e2", soft_rows=1, residual_stream_bits=64),
}


@pytest.mark.parametrize("name", list(ARRAYS))
def test_memories_and_slices_are_those_of_the_verilog(name, tmp_path):
    array = ARRAYS[name]
    export_verilog(array, tmp_path)
    top, unit = ((tmp_path / f"macram_{part}.v").read_text() for part in ("top", "unit"))
    found = Counter()
    for text in re.findall(r"\bmacram_ram #\((.*?)\n  \)", top, re.S):
        number = {key: int(value) for key, value in re.findall(r"\.(\w+)\(32'd(\d+)\)", text)}
        if "distributed" not in text:
            found[number["WIDTH"], number["DEPTH"], number["LANES"]] += 1
    wanted = Counter()
    for memory in block_memories(array):
        wanted[memory.width, memory.depth, memory.lanes] += memory.count
    assert found == wanted
    assert len(re.findall(r"\bDSP48E2 #?", unit)) * array.units == dsp_slices(array)


MEMORIES = [(18, 64, 1), (24, 64, 4), (96, 16, 4), (228, 16, 1), (99, 1024, 1), (36, 1100, 1), (132, 1024, 4)]
"""Bits, words and write enables; memories of the tiny array and of the large ones among them."""


@pytest.mark.slow
def test_block_ram_is_what_yosys_takes(tmp_path):
    """Each memory by itself: with the sizes of the test above it is the block RAM of whole arrays."""
    for index, (width, depth, lanes) in enumerate(MEMORIES):
        bits = (depth - 1).bit_length()
        (tmp_path / f"m{index}.v").write_text(
            f"module m{index}(input clk, en, input [{lanes - 1}:0] we, input [{bits - 1}:0] wa, ra, "
            f"input [{width - 1}:0] wd, output [{width - 1}:0] rd);\n"
            f"macram_ram #(.WIDTH({width}), .DEPTH({depth}), .ADDR_BITS({bits}), .LANES({lanes})) ram(.clk(clk), "
            ".write_en(we), .write_addr(wa), .write_data(wd), .read_en(en), .read_addr(ra), .read_data(rd));\n"
            "endmodule\n"
        )
    names = [f"m{index}" for index in range(len(MEMORIES))]
    ports = ", ".join(f"input c{n}" for n in names)
    body = "".join(f"{name} {name}_i(.clk(c{name}));\n" for name in names)
    (tmp_path / "top.v").write_text(f"module top({ports});\n{body}endmodule\n")
    (tmp_path / "ram.v").write_text(model_path("macram_ram.v").read_text())
    script = f"read_verilog ram.v top.v {' '.join(f'{name}.v' for name in names)}\n"
    script += (
        "setattr -mod -set keep_hierarchy 1 m*\nsynth_xilinx -family xcup -top top -run begin:map_ffram\n"
    )
    run_yosys(f"{script}tee -q -o stat.json stat -json\n", tmp_path, name="memories", timeout=300)
    modules = read_stat(tmp_path / "stat.json")
    for name, (width, depth, lanes) in zip(names, MEMORIES, strict=True):
        cells = Counter()
        for module, times in instances(modules, name).items():
            for cell, number in modules[module].cells.items():
                cells[cell] += times * number
        counted = cells["RAMB36E2"] + cells["RAMB18E2"] / 2
        assert BlockMemory(name, 1, width, depth, lanes).ramb36 == counted, (width, depth, lanes)


def test_figures_of_the_shipped_arrays():
    """RAMB36 as `macram synth` counts them, docs/synthesis.md; slices of the units alone."""
    figures = {}
    for name in ("zu3eg", "paper", "tiny", "tiny-blocks"):
        array = ArrayConfig.from_toml(CONFIGS / f"{name}.toml")
        figures[name] = dsp_slices(array), block_ram(block_memories(array))
        check_fits(array, ZU3EG, None)
    assert figures == {"zu3eg": (320, 203), "paper": (320, 84.5), "tiny": (0, 10), "tiny-blocks": (0, 10.5)}


def test_all_slices_fit_and_one_row_more_does_not():
    most = replace(TINY, rows=45, max_c_in=45, engine="dsp48e2")
    assert dsp_slices(most) == 360
    check_fits(most, ZU3EG, None)
    with pytest.raises(
        ValueError, match=r"tiny does not fit xczu3eg: 368 DSP of 360; use fewer units or rows"
    ):
        check_fits(replace(most, rows=46), ZU3EG, None)


def test_all_block_ram_fits_and_one_word_more_does_not():
    most = replace(TINY, drain=1, weight_depth=53 * 1024)
    assert block_ram(block_memories(most)) == 216
    check_fits(most, ZU3EG, None)
    with pytest.raises(
        ValueError, match=r"220 BRAM of 216; the weights take 216 RAMB36: use less weight_depth"
    ):
        check_fits(replace(most, weight_depth=53 * 1024 + 1), ZU3EG, None)
    with pytest.raises(ValueError, match=r"216\.5 BRAM of 216; the weights"):
        check_fits(replace(most, max_c_in=200), ZU3EG, None)


def test_counted_luts_fit_up_to_their_share():
    check_fits(TINY, ZU3EG, {"lut": 56_448, "ff": 141_120})
    with pytest.raises(ValueError, match="56,449 LUT of 56,448; use fewer units or rows, or another engine"):
        check_fits(TINY, ZU3EG, {"lut": 56_449, "ff": 0})


# ---- the command ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"rows": 46, "max_c_in": 46, "engine": '"dsp48e2"'}, "368 DSP of 360; use fewer"),
        ({"weight_depth": 60_000}, "242 BRAM of 216; the weights take 236 RAMB36"),
    ],
)
def test_the_export_refuses_and_writes_nothing(change, message, tmp_path, capsys):
    config = write_config(tmp_path, change)
    assert main(["export", "vivado", "--config", str(config), "-o", str(tmp_path / "out")]) == 2
    error = capsys.readouterr().err.strip()
    assert f"array tiny does not fit xczu3eg: {message}" in error
    assert "\n" not in error
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("luts", [56_448, 56_449])
def test_the_export_heeds_counted_luts(luts, tmp_path, monkeypatch, capsys):
    config, counts, out = write_config(tmp_path, {}), tmp_path / "counts", tmp_path / "out"
    counts.mkdir()
    command = ["export", "vivado", "--config", str(config), "--synth", str(counts), "-o", str(out)]
    assert main(command) == 0
    wanted = f"LUTs not checked: {counts} has no counts of this design as it is now; macram synth {config} makes them"
    assert wanted in capsys.readouterr().out

    def fake(script, folder, **_):
        stat = {"modules": {"\\macram_top": {"num_cells_by_type": {"LUT6": luts}}}}
        (folder / "stat.json").write_text(json.dumps(stat))

    monkeypatch.setattr(cost, "run_yosys", fake)
    main(["synth", str(config), "-o", str(counts / "tiny")])
    capsys.readouterr()
    fits = luts == ZU3EG.limit("lut")
    assert main(command) == (0 if fits else 2)
    said = capsys.readouterr()
    assert "not checked" not in said.out
    assert ("56,449 LUT of 56,448" in said.err) is not fits


def test_a_missing_folder_of_counts_is_named(tmp_path, capsys):
    command = ["export", "vivado", "--synth", str(tmp_path / "nowhere"), "-o", str(tmp_path / "out")]
    assert main(command) == 2
    assert "nowhere: no such folder; name the one that macram synth wrote to" in capsys.readouterr().err


def write_config(folder, change):
    values = {key: json.dumps(value) for key, value in TINY.to_dict().items()} | change
    path = folder / "array.toml"
    path.write_text("[array]\n" + "".join(f"{key} = {value}\n" for key, value in values.items()))
    return path
