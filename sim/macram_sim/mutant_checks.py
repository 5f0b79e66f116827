"""What judges a mutant of the gateware: the unit tests, the regression and the proofs, in a frozen copy.

The checkout may change meanwhile. A mutant counts only if it elaborates and changes what a small array elaborates to.
It is killed by the first check that fails or does not end in time: the unit tests of its module and the whole array
in Amaranth's simulator, then the regression of that array on Verilator, then the fast proofs about its module.
"""

from __future__ import annotations

import hashlib
import json
import os
import resource
import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from macram_sim.mutation_points import Mutation

CHECKS = ("unit tests", "simulation", "proofs")
COPIED = ("sw", "hw", "sim", "tests", "configs", "pyproject.toml")
NOT_GATEWARE = {"__init__.py", "export.py", "selftest.py"}
"""No part of an array. The self-test, which drives one, has tests of its own on Verilator."""
COMPARES_BYTES = {"test_rtl_fresh.py", "test_export.py"}
"""They notice every change of the Verilog, whatever it does, and would be no measure."""
WHOLE_ARRAY = "tests/hw/test_array_streams.py"
"""Runs for a mutant of any module, in Amaranth's simulator."""
CASES = 120
"""Of the regression: one array by itself may leave a bin of the default number unmet, which would fail the check."""
LIMITS = {"elaborate": 60, "unit tests": 90, "simulation": 240, "proofs": 300}
"""CPU seconds of one process after which a check counts as failed: a mutant that hangs, on a busy machine too."""
_FINGERPRINTS = """
import hashlib, json, sys
from amaranth.back import rtlil
from macram_hw.export import _ExportPlatform
from macram_hw.top import Top
from macram_hw.unit import UnitCore
from macram_sim.regression import ARRAYS
known, digests = json.loads(sys.argv[1]), {}
for array in reversed(ARRAYS):  # the last have most of what not all have
    parts = (Top(array), UnitCore(array))
    text = "".join(rtlil.convert(part, platform=_ExportPlatform(), emit_src=False) for part in parts)
    digests[array.name] = hashlib.sha256(text.encode()).hexdigest()
    if known and digests[array.name] != known[array.name]:
        break
print(json.dumps(digests))
"""
"""Hashes of what the arrays elaborate to, up to the first that differs from what is known."""


class MutantChecks:
    """A frozen copy of the checkout, in which one mutant at a time is elaborated and checked.

    Args:
        root: the checkout.
        out: folder for the copy and its builds.
        seed: of the checks, 0 or more.
        quick: the unit tests are the only check.

    Attributes:
        sources: gateware file -> text.
        digest: hash of the sources.
    """

    def __init__(self, root: Path, out: Path, *, seed: int, quick: bool) -> None:
        self._out, self._seed, self._quick = out, seed, quick
        self._tree = out / "tree"
        self.sources: dict[str, str] = {}
        self.digest = self._freeze(root)
        self._passes: set[tuple[str, ...]] = set()

    def _freeze(self, root: Path) -> str:
        """Copy the checkout; the hash of its gateware."""
        digest = hashlib.sha256()
        for path in sorted((root / "hw" / "macram_hw").glob("*.py")):
            if path.name not in NOT_GATEWARE:
                self.sources[path.name] = path.read_text()
                digest.update(path.name.encode() + path.read_bytes())
        shutil.rmtree(self._tree, ignore_errors=True)
        self._tree.mkdir(parents=True)
        for name in COPIED:
            source, target = root / name, self._tree / name
            if source.is_dir():
                shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__"))
            else:
                shutil.copy2(source, target)
        return digest.hexdigest()

    def clear(self) -> None:
        """Remove the copy and its builds."""
        for name in ("tree", "builds"):
            shutil.rmtree(self._out / name, ignore_errors=True)

    def path(self, file: str) -> Path:
        """Of a gateware file in the copy."""
        return self._tree / "hw" / "macram_hw" / file

    @contextmanager
    def applied(self, mutation: Mutation) -> Iterator[None]:
        """The copy with this mutation."""
        path, text = self.path(mutation.file), self.sources[mutation.file]
        try:
            path.write_text(mutation.apply(text))
            yield
        finally:
            path.write_text(text)

    def fingerprints(self, known: dict[str, str]) -> dict[str, str] | None:
        """Hashes by array, up to the first that is not as known; None if the copy does not elaborate."""
        done = self._run("elaborate", [sys.executable, "-c", _FINGERPRINTS, json.dumps(known)])
        if done.returncode:
            return None
        table: dict[str, str] = json.loads(done.stdout)
        return table

    def kill(self, mutation: Mutation, array: str) -> tuple[str, str]:
        """The first check that fails on the mutant and passes on the sound gateware."""
        for name, command in self._checks(mutation.file, array):
            with self.applied(mutation):
                fault = self._fault(name, command)
            if not fault:
                continue
            if tuple(command) not in self._passes:
                if sound := self._fault(name, command):
                    raise RuntimeError(f"the {name} fail on the unchanged gateware: {sound}")
                self._passes.add(tuple(command))
            return name, fault
        return "survived", ""

    def _checks(self, file: str, array: str) -> Iterator[tuple[str, list[str]]]:
        """Name and command of each check for a mutant of ``file``, the quickest first."""
        module = file.removesuffix(".py")
        tests = [
            str(path.relative_to(self._tree))
            for path in sorted((self._tree / "tests" / "hw").glob("test_*.py"))
            if path.name not in COMPARES_BYTES and f"macram_hw.{module} " in path.read_text()
        ]
        pytest = [sys.executable, "-m", "pytest", "-xq", "-p", "no:cacheprovider"]
        yield "unit tests", [*pytest, *tests, *([] if WHOLE_ARRAY in tests else [WHOLE_ARRAY])]
        if self._quick:
            return
        macram = [sys.executable, "-m", "macram.cli", "verify"]
        out = str(self._out / "checks")
        regression = [*macram, "regression", "--array", array, "--cases", str(CASES)]
        yield "simulation", [*regression, "--seed", str(self._seed), "-o", out]
        yield "proofs", [*macram, "formal", "--module", module, "--fast", "--sound-only", "-o", out]

    def _fault(self, name: str, command: list[str]) -> str:
        """Why the check fails, empty if it passes."""
        done = self._run(name, command)
        return _first_fault(done.stdout + done.stderr) or "no message" if done.returncode else ""

    def _run(self, name: str, command: list[str]) -> subprocess.CompletedProcess[str]:
        """The finished process; one that took too long was killed."""
        env = {
            **os.environ,
            "PYTHONPATH": os.pathsep.join(str(self._tree / part) for part in ("sw", "hw", "sim")),
            "PYTHONDONTWRITEBYTECODE": "1",
            "MACRAM_BUILD_DIR": str(self._out / "builds"),
            "SEED": str(self._seed),
        }
        seconds = LIMITS[name]
        done = subprocess.run(
            command,
            cwd=self._tree,
            env=env,
            capture_output=True,
            text=True,
            check=False,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds)),
        )
        # Every mutant has builds of its own, which nobody uses again.
        if name == "simulation":
            shutil.rmtree(self._out / "builds", ignore_errors=True)
        return done


def _first_fault(text: str) -> str:
    """The line that says what went wrong, shortened."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    fault = next(
        (line for line in lines if line.startswith(("E  ", "macram: error"))), lines[-1] if lines else ""
    )
    return " ".join(fault.removeprefix("E  ").split())[:200]
