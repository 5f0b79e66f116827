"""Building Verilated models, once per content.

A finished build is one folder, ``<toplevel>-<key>`` in `build_root`, holding the executable and the build log.
The key is the SHA-256 of everything that goes into it, so nothing is ever out of date and nothing needs cleaning
to be right. What all models share (`macram_sim.runtime`) lies beside them in ``runtime-<key>`` and is compiled with
the first.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import shutil
import subprocess
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import cocotb
import cocotb_tools.config
from cocotb_tools import runner as cocotb_runner

from macram_sim.folders import build_root, locked
from macram_sim.runtime import Runtime
from macram_sim.tools import Toolchain, find_toolchain

BUILD_JOBS = 2
VISIBLE = ("--public-depth", "1")
"""Only the top module can be seen from outside."""
VERILATOR_ARGS = (
    "-O3",
    "-fno-dfg",
    "-fno-gate",
    "--x-assign",
    "fast",
    "--x-initial",
    "unique",
    "--no-timing",
)
"""Registers without a reset start at zero, or at random when the run asks for it (``random_init``).

The two passes that are off substitute signals across the borders of modules, so that the 64 units no longer
share one body: 17 MB of C++ instead of 3 MB, four times the compile time, and a slower model.
"""
OPT_FAST, OPT_SLOW = "-O2", "-O0"
"""g++ settings of the code that runs every cycle and of the code that runs once."""


_FAULT = re.compile(r"%Error|%Warning-|\berror:|\*\*\* ")


class SimulationError(RuntimeError):
    """A build or a simulation failed; the message holds the first failure and how to run it again."""


@dataclass(frozen=True, slots=True)
class Build:
    """A finished model: ``directory / toplevel`` is the executable.

    Attributes:
        seconds: time this call spent, near zero when the build was cached.
        waves: ``"fst"`` or ``"vcd"`` if the model can write waveforms, else an empty string.
    """

    directory: Path
    toplevel: str
    seconds: float
    cached: bool
    waves: str


class LeanVerilator(cocotb_runner.Verilator):
    """cocotb's runner with our Verilator, our compiler settings, and only the top's ports visible.

    ``--public-flat-rw`` would make every signal of the design visible: nothing could be optimised away or
    inlined, and the array would take minutes to compile and run several times slower.
    """

    def __init__(self, tools: Toolchain, *, timeout: float | None = None) -> None:
        super().__init__()
        self._tools = tools
        self._timeout = timeout

    def _set_env_common(self) -> None:
        super()._set_env_common()
        libs = self.env["PATH"].removeprefix(os.environ.get("PATH", ""))
        self.env = self._tools.environment(self.env)
        self.env["PATH"] += libs

    def _simulator_in_path_build_only(self) -> None:
        self.executable = str(self._tools.verilator)

    def _build_command(self) -> list[list[str]]:
        verilate, make = super()._build_command()
        at = verilate.index("--public-flat-rw")
        verilate[at : at + 1] = VISIBLE
        make[make.index("-j") + 1] = str(BUILD_JOBS)
        make += [f"OPT_FAST={OPT_FAST}", f"OPT_GLOBAL={OPT_FAST}", f"OPT_SLOW={OPT_SLOW}"]
        shared = [
            "--vpi",
            *VISIBLE,
            *(["--trace"] if self.waves else []),
            *(a.value for a in self._build_args),
        ]
        self._runtime = Runtime(self._tools, tuple(shared), tuple(a for a in make if "=" in a))
        return [verilate, [*make, *self._runtime.headers()]]

    def _execute(self, cmds: Sequence[Sequence[str]], cwd: os.PathLike[str] | str) -> None:
        """As the base class, but a run's stderr stays the caller's: benches report progress there."""
        assert self.log_file is not None
        with Path(self.log_file).open("w", encoding="utf-8") as log:
            for command in cmds:
                building = command[0] in (self.executable, "make") if hasattr(self, "executable") else False
                if command[0] == "make":
                    self._runtime.lay_into(self.build_dir, BUILD_JOBS, log)
                subprocess.run(
                    list(command),
                    cwd=cwd,
                    env=self.env,
                    stdout=log,
                    stderr=subprocess.STDOUT if building else None,
                    stdin=subprocess.DEVNULL,
                    timeout=self._timeout,
                    check=True,
                )


def waves_wanted(waves: bool | None = None) -> bool:
    """``WAVES`` of the environment if it is set, else ``waves``."""
    text = os.environ.get("WAVES", "").strip().lower()
    return bool(waves) if not text else text not in ("0", "no", "n", "off", "false", "disable")


def build(
    sources: Sequence[Path],
    toplevel: str,
    *,
    parameters: Mapping[str, object] | None = None,
    args: Sequence[str] = (),
    waves: bool | None = None,
) -> Build:
    """Verilate and compile, unless a build of the same content exists.

    Args:
        sources: ``.v``, ``.sv`` and ``.vlt`` files, in order.
        toplevel: module to build; its ports are what a bench can see.
        parameters: values of the top's parameters.
        args: further arguments for Verilator, none that means one model, such as a file or ``-G``.
        waves: make a model that can write waveforms; ``WAVES`` of the environment wins. A separate build.

    Raises:
        SimulationError: Verilator or the compiler refused; the message holds the first error line.
        ToolError: a tool is missing.
        ValueError: a source does not exist.
    """
    start = time.perf_counter()
    tools = find_toolchain()
    traced = waves_wanted(waves)
    form = ("fst" if tools.fst else "vcd") if traced else ""
    arguments = [*VERILATOR_ARGS, *args, *(["--trace-fst"] if form == "fst" else [])]
    paths = [Path(source) for source in sources]
    recipe = {
        "toplevel": toplevel,
        "sources": [(path.name, _digest(path)) for path in paths],
        "parameters": {key: str(value) for key, value in (parameters or {}).items()},
        "arguments": [*VISIBLE, *arguments],
        "compiler": [OPT_FAST, OPT_SLOW],
        "waves": form,
        "tools": [tools.version, str(tools.verilator), f"cocotb {cocotb.__version__}"],
        "libraries": str(cocotb_tools.config.libs_dir),
    }
    key = hashlib.sha256(json.dumps(recipe, sort_keys=True).encode()).hexdigest()[:20]
    final = build_root() / f"{toplevel}-{key}"
    final.parent.mkdir(parents=True, exist_ok=True)
    with locked(final.parent / f".{final.name}.lock"):
        cached = (final / toplevel).is_file()
        if not cached:
            _build_into(final, paths, toplevel, parameters or {}, arguments, form, tools)
            (final / "recipe.json").write_text(json.dumps(recipe, indent=2) + "\n", encoding="utf-8")
    return Build(final, toplevel, time.perf_counter() - start, cached, form)


def _build_into(
    final: Path,
    sources: list[Path],
    toplevel: str,
    parameters: Mapping[str, object],
    arguments: list[str],
    form: str,
    tools: Toolchain,
) -> None:
    """Build in a folder of this process's own and move the result into place in one step."""
    work = final.parent / f".{final.name}.{os.getpid()}"
    shutil.rmtree(work, ignore_errors=True)
    (work / "done").mkdir(parents=True)
    log = work / "done" / "build.log"
    try:
        LeanVerilator(tools).build(
            sources=sources,
            hdl_toplevel=toplevel,
            parameters=parameters,
            build_args=arguments,
            build_dir=work / "obj",
            timescale=("1ns", "1ps"),
            waves=bool(form),
            log_file=log,
        )
        shutil.move(work / "obj" / toplevel, work / "done" / toplevel)
        shutil.rmtree(final, ignore_errors=True)
        (work / "done").rename(final)
    except subprocess.CalledProcessError as error:
        kept = final.parent / f"{final.name}.failed.log"
        log.replace(kept)
        lines = kept.read_text(encoding="utf-8", errors="replace").splitlines()
        first = next((line for line in lines if _FAULT.search(line)), lines[-1] if lines else str(error))
        raise SimulationError(f"building {toplevel} failed: {first.strip()} (log: {kept})") from error
    finally:
        shutil.rmtree(work, ignore_errors=True)


def _digest(path: Path) -> str:
    try:
        return hashlib.sha256(path.read_bytes()).hexdigest()
    except OSError as error:
        raise ValueError(f"source {path} cannot be read: {error.strerror}") from error
