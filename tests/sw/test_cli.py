"""The command line with the real spec, golden model and packer; only the simulator is replaced."""

from __future__ import annotations

import dataclasses
import json
import os
import re
import subprocess
import sys
import types

import numpy as np
import pytest

import macram
from macram.cli import main
from macram.cli.rtl_verb import out_of_date
from macram.cli.sim_verb import ODD_SHAPES
from macram.golden import random_case, run_layer
from macram.layer_file import KEYS, LayerCase
from macram.layer_job import COUNTERS, array_for, estimate_table
from macram.perf import estimate
from macram.spec import ArrayConfig, ConvSpec, IntFormat

SMALL = ConvSpec(5, 7, 6, 9)
ROUGH = ["--gaps", "random", "--stalls", "random", "--load", "stream", "--seed", "7"]


@pytest.fixture
def simulator(monkeypatch):
    """A stand-in that computes what the packed memories say; `.change` spoils its codes."""
    from macram.pack import unpack  # noqa: PLC0415

    state = types.SimpleNamespace(calls=[], change=lambda codes: codes, lost_cycles=0, error=None)
    state.counters = lambda spec, array: dict.fromkeys(COUNTERS, 20) | {"mac_cycles": 300}

    def simulate(packed, codes, **options):
        if state.error:
            raise state.error
        state.calls.append((packed, options))
        from macram.golden import conv2d  # noqa: PLC0415

        weights, requant = unpack(packed)
        produced = state.change(requant.apply(conv2d(codes, weights)))
        counters = state.counters(packed.spec, packed.array)
        counters["cycles"] = sum(counters.values()) + state.lost_cycles
        return types.SimpleNamespace(
            codes=produced, counters=counters, build_seconds=0.5, wall_seconds=0.25, waves=None
        )

    fake = types.SimpleNamespace(simulate=simulate, build_array=lambda array, *, waves=False: None)
    monkeypatch.setitem(sys.modules, "macram_sim", types.ModuleType("macram_sim"))
    monkeypatch.setitem(sys.modules, "macram_sim.array", fake)
    tools = types.SimpleNamespace(source="wheel", version="5.0")
    monkeypatch.setitem(sys.modules, "macram_sim.tools", types.SimpleNamespace(find_toolchain=lambda: tools))
    return state


@pytest.fixture
def layer_file(tmp_path):
    path = tmp_path / "layer.npz"
    random_case(SMALL, seed=3).save(path)
    return path


def one_line_of(capsys):
    text = capsys.readouterr().err
    assert text.startswith("macram: error: ")
    assert text.count("\n") == 1
    return text


# ---- macram layer ------------------------------------------------------------------------------------


def test_layer_writes_codes_and_report(simulator, layer_file, tmp_path, capsys):
    out = tmp_path / "deep" / "out"
    assert main(["layer", str(layer_file), "-o", str(out), *ROUGH]) == 0
    codes = np.load(out / "output.npz")["codes"]
    assert np.array_equal(codes, run_layer(LayerCase.load(layer_file)))
    report = json.loads((out / "report.json").read_text())
    assert report["compared"] == codes.size == 7 * 6 * 9
    assert (report["mismatches"], report["passed"], report["first_difference"]) == (0, True, None)
    assert report["cycles"] == sum(report["counters"][name] for name in COUNTERS)
    assert report["macs"] == SMALL.macs
    assert report["macs_per_cycle"] == SMALL.macs / report["cycles"]
    assert report["utilisation"] == SMALL.macs / (report["cycles"] * 6144)
    assert report["ms_at_100mhz"] == report["cycles"] * 1000 / 100e6
    assert report["seed"] == 7
    assert {"macram", "python", "numpy"} <= set(report["versions"])
    parts = [report["estimate"][name] for name in COUNTERS]
    assert report["estimate"]["total"] == sum(parts) == estimate(SMALL, ArrayConfig()).total
    options = {
        "gaps": "random",
        "stalls": "random",
        "load": "stream",
        "seed": 7,
        "waves": False,
        "job_dir": None,
        "told": None,
    }
    assert [call[1] for call in simulator.calls] == [options]
    assert "378 output codes compared, 0 differ" in capsys.readouterr().out


def test_the_waveform_goes_beside_the_report(simulator, layer_file, tmp_path):
    assert main(["layer", str(layer_file), "-o", str(tmp_path / "out"), "--waves"]) == 0
    assert simulator.calls[0][1]["job_dir"] == tmp_path / "out/simulation"


def test_one_wrong_code_fails_and_is_named(simulator, layer_file, tmp_path, capsys):
    expected = run_layer(LayerCase.load(layer_file))

    def flip(codes):
        codes = codes.copy()
        codes[4, 2, 8] ^= 1
        codes[5, 0, 0] ^= 1
        return codes

    simulator.change = flip
    assert main(["layer", str(layer_file), "-o", str(tmp_path)]) == 1
    want, got = int(expected[4, 2, 8]), int(expected[4, 2, 8]) ^ 1
    out = capsys.readouterr().out
    assert f"2 differ; first at (channel 4, y 2, x 8): expected {want}, got {got}" in " ".join(out.split())
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["mismatches"] == 2
    assert not report["passed"]
    assert report["first_difference"]["produced"] == got


def test_a_cycle_without_a_cause_fails(simulator, layer_file, tmp_path, capsys):
    simulator.lost_cycles = 3
    assert main(["layer", str(layer_file), "-o", str(tmp_path)]) == 1
    assert "3 cycles have no cause" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("break_it", "message"),
    [
        (lambda keys: keys.pop("scale"), "'scale' is missing"),
        (lambda keys: keys.update(stride=3), "stride"),
        (lambda keys: keys.update(weights=keys["weights"] * 5), "weights"),
        (lambda keys: keys.update(offset=keys["offset"] * np.nan), "offset"),
        (lambda keys: keys.update(more=1), "unknown key 'more'"),
    ],
)
def test_bad_layers_end_in_one_line_and_leave_nothing(
    break_it, message, simulator, layer_file, tmp_path, capsys
):
    keys = dict(np.load(layer_file))
    break_it(keys)
    np.savez(layer_file, **keys)
    out = tmp_path / "out"
    assert main(["layer", str(layer_file), "-o", str(out)]) == 2
    assert message in one_line_of(capsys)
    assert not out.exists()
    assert not simulator.calls


@pytest.mark.parametrize("verb", ["layer", "pack", "rtl"])
@pytest.mark.parametrize("array", [None, '[array]\nname = "small"\nunits = 64\nrows = 8\nmax_c_in = 4\n'])
def test_an_array_that_refuses_a_layer_names_its_file(verb, array, simulator, layer_file, tmp_path, capsys):
    keys = dict(np.load(layer_file))
    np.savez(layer_file, **(keys if array else keys | {"padding": 0}))
    out, config = tmp_path / "out", tmp_path / "array.toml"
    config.write_text(array or "[array]\n")
    option = "--config" if verb == "rtl" else "--array"
    words = [verb, *(["--layer"] if verb == "rtl" else []), str(layer_file), "-o", str(out)]
    assert main([*words, *([option, str(config)] if array else [])]) == 2
    assert one_line_of(capsys).startswith(f"macram: error: {layer_file}: ")
    assert not out.exists()


def test_bad_paths_end_in_one_line(simulator, layer_file, tmp_path, capsys):
    assert main(["layer", str(tmp_path / "none.npz"), "-o", str(tmp_path)]) == 2
    assert "none.npz" in one_line_of(capsys)
    assert main(["layer", str(layer_file), "-o", str(layer_file)]) == 2
    assert "File exists; name another file or folder" in one_line_of(capsys)
    assert main(["layer", str(layer_file), "-o", str(tmp_path), "--array", str(tmp_path / "a.toml")]) == 2
    assert "a.toml" in one_line_of(capsys)
    assert main(["layer", str(layer_file), "-o", str(tmp_path / "none"), "--seed", "-1"]) == 2
    assert "--seed must be 0 or more, not -1" in one_line_of(capsys)
    assert not (tmp_path / "none").exists()


def test_array_file_is_used_and_must_admit_the_layer(simulator, layer_file, tmp_path, capsys):
    config = tmp_path / "array.toml"
    config.write_text('[array]\nname = "mine"\nunits = 32\nrows = 8\nmax_c_in = 8\n')
    assert main(["layer", str(layer_file), "-o", str(tmp_path), "--array", str(config)]) == 0
    assert simulator.calls[0][0].array.units == 32
    config.write_text('[array]\nname = "four"\nunits = 64\nrows = 8\nweight = "s4"\n')
    capsys.readouterr()
    assert main(["layer", str(layer_file), "-o", str(tmp_path), "--array", str(config)]) == 2
    assert "weight format is s4, the layer's is s3" in one_line_of(capsys)


@pytest.mark.parametrize(
    ("error", "status", "message"),
    [
        (RuntimeError("array hung\nafter 3 beats"), 1, "array hung after 3 beats"),
        (type("ToolError", (RuntimeError,), {})("g++ is not on PATH"), 2, "g++ is not on PATH"),
        (
            ModuleNotFoundError("No module named 'cocotb'", name="cocotb.handle"),
            2,
            "pip install 'macram[sim]'",
        ),
    ],
)
def test_faults_of_the_simulation(error, status, message, simulator, layer_file, tmp_path, capsys):
    simulator.error = error
    assert main(["layer", str(layer_file), "-o", str(tmp_path)]) == status
    assert message in one_line_of(capsys)


def test_verbose_shows_the_traceback(simulator, layer_file, tmp_path, capsys):
    simulator.error = RuntimeError("array hung")
    main(["layer", str(layer_file), "-o", str(tmp_path), "-v"])
    assert "Traceback" in capsys.readouterr().err


# ---- macram sim and bench ----------------------------------------------------------------------------


@pytest.fixture
def small_reference(simulator, monkeypatch):
    """`macram sim` on small layers, the simulated array as fast as the closed form says."""
    monkeypatch.setattr("macram.cli.sim_verb.REFERENCE", SMALL)
    monkeypatch.setattr("macram.bench.REFERENCE", SMALL)
    simulator.counters = lambda spec, array: {
        name: value for name, value in estimate_table([estimate(spec, array)]).items() if name in COUNTERS
    }
    return simulator


def test_sim_runs_odd_shapes_and_the_reference_both_ways(small_reference, tmp_path, capsys):
    assert main(["sim", "--random", "-o", str(tmp_path), "--seed", "4"]) == 0
    report = json.loads((tmp_path / "sim.json").read_text())
    assert report["passed"]
    assert len(report["runs"]) == len(ODD_SHAPES) + 2
    assert [row["traffic"]["gaps"] for row in report["runs"]] == ["random"] * 5 + ["none", "random"]
    assert {row["seed"] for row in report["runs"]} == {4}
    assert "7 runs, 0 failed, seed 4" in capsys.readouterr().out


def test_the_table_of_sim_is_legible_in_a_pipe(small_reference, tmp_path, capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    assert main(["sim", "--random", "-o", str(tmp_path)]) == 0
    rows = [line for line in capsys.readouterr().out.splitlines() if line.rstrip().endswith(" ok")]
    assert len(rows) == len(ODD_SHAPES) + 2
    assert [row.split("  ")[0].strip() for row in rows[-2:]] == [
        "reference, random codes", "reference, gaps and stalls",
    ]  # fmt: skip
    assert "9->129 4x18" in rows[3]


@pytest.mark.parametrize("verb", ["demo", "sim"])
def test_a_refused_image_leaves_nothing(verb, simulator, tmp_path, capsys):
    picture, out = tmp_path / "no.png", tmp_path / "out"
    picture.write_text("no picture")
    assert main([verb, "--image", str(picture), "-o", str(out)]) == 2
    assert "no.png" in one_line_of(capsys)
    assert not out.exists()
    assert not simulator.calls


@pytest.mark.parametrize(
    ("fault", "failed", "message"),
    [
        ({"change": lambda codes: codes ^ (codes.size == SMALL.c_out * 54)}, 2, "378 differ"),
        ({"lost_cycles": 2}, 7, "have no cause"),
        ({"error": RuntimeError("array\nhung")}, 7, "array hung"),
    ],
)
def test_sim_fails_and_says_which(fault, failed, message, small_reference, tmp_path, capsys):
    vars(small_reference).update(fault)
    assert main(["sim", "--random", "-o", str(tmp_path)]) == 1
    out = " ".join(capsys.readouterr().out.split())
    assert f"7 runs, {failed} failed" in out
    assert message in out
    assert not json.loads((tmp_path / "sim.json").read_text())["passed"]


def test_sim_holds_the_undisturbed_run_to_its_bound_and_to_the_closed_form(
    small_reference, tmp_path, monkeypatch, capsys
):
    monkeypatch.setattr("macram.cli.sim_verb.CYCLE_BOUND", 50)
    assert main(["sim", "--random", "-o", str(tmp_path)]) == 1
    assert "at most 50 are allowed" in capsys.readouterr().out
    monkeypatch.setattr("macram.cli.sim_verb.CYCLE_BOUND", 10**6)
    small_reference.counters = lambda spec, array: dict.fromkeys(COUNTERS, 100)
    assert main(["sim", "--random", "-o", str(tmp_path)]) == 1
    out = capsys.readouterr().out
    assert "500 cycles, the closed form says" in out
    assert out.count("FAILED reference") == 1


def test_bench_gives_medians_and_the_machine(small_reference, monkeypatch, tmp_path, capsys):
    monkeypatch.setattr("macram.bench.SIZE", "tiny")
    monkeypatch.setattr("macram.bench.SIDES", (64,))
    folder = os.environ.get("MACRAM_BUILD_DIR")
    assert main(["bench", "-o", str(tmp_path), "--repeat", "2"]) == 0
    report = json.loads((tmp_path / "bench.json").read_text())
    rows = {row["name"]: row for row in report["measurements"]}
    assert rows["simulation, whole layer"]["median_s"] == 0.25
    assert len(rows["golden model, whole layer"]["runs_s"]) == 2
    assert report["machine"]["cores"] >= 1
    for row in report["network"]:
        assert row["ratio"] == pytest.approx(row["integer_ms"] / row["float_ms"], rel=0.01)
        assert len(row["float_runs_ms"]) == len(row["integer_runs_ms"]) == 2
    assert [row["threads"] for row in report["network"]][:1] == [1]
    assert os.environ.get("MACRAM_BUILD_DIR") == folder
    capsys.readouterr()
    assert main(["bench", "-o", str(tmp_path / "none"), "--repeat", "0"]) == 2
    assert "--repeat must be at least 1, not 0" in one_line_of(capsys)
    network = ["bench", "-o", str(tmp_path), "--repeat", "1", "--network", "tiny"]
    assert main([*network, "--side", "64", "--side", "96"]) == 0
    rows = json.loads((tmp_path / "network-tiny.json").read_text())["network"]
    assert {row["side"] for row in rows} == {64, 96}
    assert all(0 < row["peak_gib"] < 24 for row in rows)
    capsys.readouterr()
    for wrong, words in (
        ([*network, "--side", "50"], "multiples of 32, not 50"),
        (["bench", "--side", "64"], "--side goes with --network"),
        (["bench", "--network", "huge"], "'huge'"),
    ):
        assert main(wrong) == 2
        assert words in one_line_of(capsys)
    assert not (tmp_path / "none").exists()


# ---- the array of a layer ----------------------------------------------------------------------------


def test_reference_formats_give_the_reference_array():
    assert array_for(SMALL) == ArrayConfig()


def test_other_formats_keep_the_geometry():
    spec = dataclasses.replace(
        SMALL, weight=IntFormat(8, signed=True), input=IntFormat(4, signed=True), output=IntFormat(8)
    )
    array = array_for(spec)
    assert (array.weight, array.input, array.output) == (spec.weight, spec.input, spec.output)
    assert array.name == "reference-s8-s4-u8"
    reference = {"name": "reference", "weight": "s3", "input": "u3", "output": "u3"}
    assert array.to_dict() | reference == ArrayConfig().to_dict()


# ---- example, pack, rtl, help ------------------------------------------------------------------------


def test_example_runs_through_layer_and_pack(simulator, tmp_path):
    path, packed = tmp_path / "e.npz", tmp_path / "packed"
    arguments = ["--channels", "3", "65", "--size", "5", "7", "--bits", "4", "5", "6", "--seed", "9"]
    assert main(["example", str(path), *arguments]) == 0
    spec = LayerCase.load(path).spec
    assert (spec.c_in, spec.c_out, spec.height, spec.width) == (3, 65, 5, 7)
    assert list(map(str, (spec.weight, spec.input, spec.output))) == ["s4", "u5", "u6"]
    assert main(["layer", str(path), "-o", str(tmp_path / "out")]) == 0
    assert main(["pack", str(path), "-o", str(packed)]) == 0
    assert (packed / "manifest.json").is_file()
    assert (packed / "unit_063.mem").is_file()


def test_example_refuses_what_no_array_runs(tmp_path, capsys):
    path = tmp_path / "e.npz"
    assert main(["example", str(path), "--size", "4", "9999"]) == 2
    one_line_of(capsys)
    assert main(["example", str(path), "--bits", "9", "3", "3"]) == 2
    one_line_of(capsys)
    assert not path.exists()


def test_rtl_check_names_missing_and_changed_files(tmp_path):
    fresh, old = tmp_path / "fresh", tmp_path / "old"
    for folder in (fresh / "lib", old / "lib"):
        folder.mkdir(parents=True)
    for name, text in (("same.v", "a"), ("lib/other.v", "b"), ("gone.v", "c")):
        (fresh / name).write_text(text)
    (old / "same.v").write_text("a")
    (old / "lib/other.v").write_text("B")
    (old / "lib/stray.mem").write_text("0")
    assert out_of_date(fresh, old) == [
        "gone.v: missing", "lib/other.v: differs", "lib/stray.mem: does not belong here, remove it",
    ]  # fmt: skip
    assert out_of_date(fresh, fresh) == []


def test_rtl_writes_checks_and_uses_the_configuration(monkeypatch, tmp_path, capsys):
    def export(config, folder, *, mem_dir):
        folder.mkdir(exist_ok=True)
        (folder / "macram_top.v").write_text(config.name)
        return types.SimpleNamespace(sources=[folder / "macram_top.v"])

    monkeypatch.setitem(sys.modules, "macram_hw", types.ModuleType("macram_hw"))
    monkeypatch.setitem(sys.modules, "macram_hw.export", types.SimpleNamespace(export_verilog=export))
    config, out = tmp_path / "c.toml", tmp_path / "rtl"
    config.write_text('[array]\nname = "mine"\nunits = 64\nrows = 8\n')
    assert main(["rtl", "-o", str(out), "--config", str(config), "--check"]) == 1
    assert "macram_top.v: missing" in capsys.readouterr().err
    assert not out.exists()
    assert main(["rtl", "-o", str(out), "--config", str(config)]) == 0
    assert (out / "macram_top.v").read_text() == "mine"
    assert main(["rtl", "-o", str(out), "--config", str(config), "--check"]) == 0
    assert main(["rtl", "-o", str(out), "--check"]) == 1


def test_an_interrupted_rtl_leaves_the_earlier_one_whole(monkeypatch, tmp_path, capsys):
    """Memory images and Verilog appear together or not at all; files of neither export stay."""

    def export(config, folder, *, mem_dir):
        if config.units == 32:
            raise KeyboardInterrupt
        (folder / f"{config.name}.v").write_text(config.name)
        (folder / "manifest.json").write_text(json.dumps({"sha256": {f"{config.name}.v": ""}}))
        return types.SimpleNamespace(sources=[])

    monkeypatch.setitem(sys.modules, "macram_hw", types.ModuleType("macram_hw"))
    monkeypatch.setitem(sys.modules, "macram_hw.export", types.SimpleNamespace(export_verilog=export))
    config, out = tmp_path / "c.toml", tmp_path / "rtl"
    arguments = ["rtl", "-o", str(out), "--config", str(config)]
    text = '[array]\nname = "{}"\nunits = {}\nrows = 8\n'

    config.write_text(text.format("first", 64))
    assert main(arguments) == 0
    (out / "notes.txt").write_text("mine")
    (out / "mem/notes.txt").write_text("mine")
    before = {path: (path.read_bytes(), path.stat().st_mtime_ns) for path in out.rglob("*") if path.is_file()}
    config.write_text(text.format("second", 32))
    assert main(arguments) == 130
    config.write_text(text.format("first", 64))
    assert main(arguments) == 0
    after = {path: (path.read_bytes(), path.stat().st_mtime_ns) for path in out.rglob("*") if path.is_file()}
    assert after == before
    assert sorted(path.name for path in tmp_path.iterdir()) == ["c.toml", "rtl"]

    config.write_text(text.format("third", 16))
    assert main(arguments) == 0
    assert sorted(path.name for path in out.iterdir()) == ["manifest.json", "mem", "notes.txt", "third.v"]
    images = {f"unit_{unit:03d}{kind}" for unit in range(16) for kind in (".mem", ".coe")}
    wanted = images | {"requant.mem", "requant.coe", "manifest.json", "notes.txt"}
    assert {path.name for path in (out / "mem").iterdir()} == wanted


@pytest.mark.parametrize("verb", ["demo", "layer", "pack", "example", "rtl", "sim", "bench"])
def test_every_verb_explains_itself(verb, capsys):
    with pytest.raises(SystemExit) as stop:
        main([verb, "--help"])
    assert stop.value.code == 0
    assert f"macram {verb}" in capsys.readouterr().out


def test_layer_help_lists_every_key_and_where_builds_are_kept(capsys):
    with pytest.raises(SystemExit):
        main(["layer", "--help"])
    text = capsys.readouterr().out
    assert {*KEYS, "MACRAM_BUILD_DIR", "XDG_CACHE_HOME"} <= set(re.findall(r"\w+", text))
    assert "~/.cache/macram/sim" in text


def test_version(capsys):
    with pytest.raises(SystemExit) as stop:
        main(["--version"])
    assert stop.value.code == 0
    assert capsys.readouterr().out == f"macram {macram.__version__}\n"


def test_usage_errors_exit_with_2():
    done = subprocess.run(
        [sys.executable, "-m", "macram.cli", "layer"], capture_output=True, text=True, check=False
    )
    assert done.returncode == 2
    assert "Traceback" not in done.stderr
