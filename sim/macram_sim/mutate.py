"""The mutation run: break the gateware in one place at a time and see whether the checks notice.

Works on a frozen copy, so the checkout may change meanwhile. A mutant counts only if it elaborates and changes what
a small array elaborates to. It is killed by the first check that fails or does not end in time: the unit tests of its
module and the whole array in Amaranth's simulator, then the regression of that array on Verilator, then the fast proofs
about its module.
"""

from __future__ import annotations

import hashlib
import json
import os
import random
import resource
import shutil
import subprocess
import sys
import time
import tomllib
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import macram_hw
from macram_sim.mutation_points import Mutation, mutations
from macram_sim.regression import ARRAYS

COPIED = ("sw", "hw", "sim", "tests", "configs", "pyproject.toml")
NOT_GATEWARE = {"__init__.py", "export.py"}
COMPARES_BYTES = {"test_rtl_fresh.py", "test_export.py"}
"""They notice every change of the Verilog, whatever it does, and would be no measure."""
WHOLE_ARRAY = "tests/hw/test_array_streams.py"
"""Runs for a mutant of any module, in Amaranth's simulator."""
LIMITS = {"elaborate": 60, "unit tests": 45, "simulation": 240, "proofs": 300}
"""CPU seconds of one process after which a check counts as failed: a mutant that hangs, on a busy machine too."""
EQUIVALENTS = Path(__file__).with_name("equivalents.toml")

_FINGERPRINTS = """
import hashlib, json, sys
from amaranth.back import rtlil
from macram_hw.export import _ExportPlatform
from macram_hw.top import Top
from macram_hw.unit import UnitCore
from macram_sim.regression import ARRAYS
known, digests = json.loads(sys.argv[1]), {}
for array in ARRAYS:
    parts = (Top(array), UnitCore(array))
    text = "".join(rtlil.convert(part, platform=_ExportPlatform(), emit_src=False) for part in parts)
    digests[array.name] = hashlib.sha256(text.encode()).hexdigest()
    if known and digests[array.name] != known[array.name]:
        break
print(json.dumps(digests))
"""
"""Hashes of what the arrays elaborate to, up to the first that differs from what is known."""


@dataclass(frozen=True)
class Verdict:
    """A mutant and how it ended.

    Attributes:
        array: small array whose Verilog it changed.
        killed_by: the check that noticed, ``survived`` or ``equivalent``.
        how: first line of the failure, or the reason of the equivalence.
        old, new: the source line before and after.
    """

    file: str
    line: int
    kind: str
    old: str
    new: str
    array: str
    killed_by: str
    how: str
    seconds: float


class MutationRun:
    """One seeded run; `verdicts` grows by one a step, and a run that was stopped goes on where it was.

    Its survivors of the stopped run are judged again first: the checks may have grown. A quick run leaves them to
    a later one that is not.

    Args:
        out: folder for the frozen copy and its builds.
        seed: of the choice of mutants, 0 or more.
        count: mutants to judge.
        earlier: `to_dict` of a run that was stopped; used if seed and sources are the same.
        quick: the unit tests are the only check.

    Raises:
        ValueError: not a checkout, or an argument out of range.
    """

    def __init__(
        self, out: Path, *, seed: int, count: int, earlier: dict[str, Any] | None = None, quick: bool = False
    ) -> None:
        if seed < 0:
            raise ValueError(f"the seed must be 0 or more, not {seed}")
        if count < 1:
            raise ValueError(f"the number of mutants must be at least 1, not {count}")
        self.root = Path(str(macram_hw.__file__)).resolve().parents[2]
        if not (self.root / "tests" / "hw").is_dir():
            raise ValueError(
                "the mutation run needs the tests; start it from a checkout, installed with pip -e"
            )
        self.out, self.seed, self.count, self.quick = Path(out).resolve(), seed, count, quick
        self.verdicts: list[Verdict] = []
        self.no_mutants = 0
        self._tree = self.out / "tree"
        self._sources: dict[str, str] = {}
        self.digest = self._freeze(earlier)
        self._tried = 0
        self._passes: set[tuple[str, ...]] = set()
        if earlier and earlier["seed"] == seed and earlier["sources"] == self.digest:
            self.verdicts = [Verdict(**row) for row in earlier["mutants"]]
            self._tried, self.no_mutants = earlier["tried"], earlier["no_mutants"]
        self._equivalents = {
            (row["file"], row["old"], row["new"]): row["reason"]
            for row in tomllib.loads(EQUIVALENTS.read_text())["equivalent"]
        }

    def _freeze(self, earlier: dict[str, Any] | None) -> str:
        """Copy the checkout, unless the copy of an unfinished run of the same sources is there."""
        digest = hashlib.sha256()
        for path in sorted((self.root / "hw" / "macram_hw").glob("*.py")):
            if path.name not in NOT_GATEWARE:
                self._sources[path.name] = path.read_text()
                digest.update(path.name.encode() + path.read_bytes())
        shutil.rmtree(self._tree, ignore_errors=True)
        self._tree.mkdir(parents=True)
        for name in COPIED:
            source, target = self.root / name, self._tree / name
            if source.is_dir():
                shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__"))
            else:
                shutil.copy2(source, target)
        return digest.hexdigest()

    def candidates(self) -> list[Mutation]:
        """Every mutation of the gateware in the seeded order in which they are tried.

        Files take turns by their share of the mutations, so that a short run touches every module.
        """
        rng = random.Random(f"mutants {self.seed}")
        ranked = []
        for name, text in self._sources.items():
            found = mutations(name, text)
            rng.shuffle(found)
            ranked += [((i + rng.random()) / len(found), m) for i, m in enumerate(found)]
        return [mutation for _, mutation in sorted(ranked, key=lambda pair: pair[0])]

    def steps(self) -> Iterator[Verdict]:
        """Judge mutants until there are enough; yields each verdict."""
        sound = self._fingerprints({})
        if sound is None:
            raise RuntimeError("the frozen copy does not elaborate; see `macram rtl`")
        for index, verdict in enumerate(self.verdicts):
            if verdict.killed_by == "survived" and not self.quick:
                again = self._judge(self._mutation_of(verdict), sound)
                assert again is not None
                self.verdicts[index] = again
                yield again
        for mutation in self.candidates()[self._tried :]:
            if len(self.verdicts) >= self.count:
                return
            judged = self._judge(mutation, sound)
            self._tried += 1
            if judged is None:
                self.no_mutants += 1
            else:
                self.verdicts.append(judged)
                yield judged

    def _mutation_of(self, verdict: Verdict) -> Mutation:
        text = self._sources[verdict.file]
        return next(
            mutation
            for mutation in mutations(verdict.file, text)
            if (mutation.line, mutation.kind, *mutation.lines(text))
            == (verdict.line, verdict.kind, verdict.old, verdict.new)
        )

    def _judge(self, mutation: Mutation, sound: dict[str, str]) -> Verdict | None:
        """None if it does not elaborate or changes no small array."""
        started = time.perf_counter()
        source = self._tree / "hw" / "macram_hw" / mutation.file
        text = self._sources[mutation.file]
        old, new = mutation.lines(text)
        try:
            source.write_text(mutation.apply(text))
            changed = self._fingerprints(sound) or {}
        finally:
            source.write_text(text)
        array = next((name for name in changed if changed[name] != sound[name]), None)
        if array is None:
            return None
        killed_by, how = self._kill(mutation, array)
        if killed_by == "survived" and (reason := self._equivalents.get((mutation.file, old, new))):
            killed_by, how = "equivalent", reason
        seconds = round(time.perf_counter() - started, 1)
        return Verdict(mutation.file, mutation.line, mutation.kind, old, new, array, killed_by, how, seconds)

    def _fingerprints(self, known: dict[str, str]) -> dict[str, str] | None:
        done = self._run("elaborate", [sys.executable, "-c", _FINGERPRINTS, json.dumps(known)])
        if done.returncode:
            return None
        table: dict[str, str] = json.loads(done.stdout)
        return table

    def _kill(self, mutation: Mutation, array: str) -> tuple[str, str]:
        """The first check that fails on the mutant and passes on the sound gateware."""
        source, text = self._tree / "hw" / "macram_hw" / mutation.file, self._sources[mutation.file]
        for name, command in self._checks(mutation.file, array):
            try:
                source.write_text(mutation.apply(text))
                fault = self._fault(name, command)
            finally:
                source.write_text(text)
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
        if self.quick:
            return
        macram = [sys.executable, "-m", "macram.cli", "verify"]
        out = str(self.out / "checks")
        yield "simulation", [*macram, "regression", "--array", array, "--seed", str(self.seed), "-o", out]
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
            "MACRAM_BUILD_DIR": str(self.out / "builds"),
            "SEED": str(self.seed),
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
            shutil.rmtree(self.out / "builds", ignore_errors=True)
        return done

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON; what a later call goes on from."""
        by = [v.killed_by for v in self.verdicts]
        real = len(by) - by.count("equivalent")
        killed = real - by.count("survived")
        return {
            "format": 1,
            "seed": self.seed,
            "sources": self.digest,
            "arrays": [array.to_dict() for array in ARRAYS],
            "quick": self.quick,
            "wanted": self.count,
            "tried": self._tried,
            "no_mutants": self.no_mutants,
            "judged": len(by),
            "equivalent": by.count("equivalent"),
            "killed": killed,
            "survived": by.count("survived"),
            "share_killed": round(killed / real, 4) if real else 0.0,
            "killed_by": {name: by.count(name) for name in ("unit tests", "simulation", "proofs")},
            "mutants": [asdict(verdict) for verdict in self.verdicts],
        }


def _first_fault(text: str) -> str:
    """The line that says what went wrong, shortened."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    fault = next(
        (line for line in lines if line.startswith(("E  ", "macram: error"))), lines[-1] if lines else ""
    )
    return " ".join(fault.removeprefix("E  ").split())[:200]


def run_mutants(
    out: Path,
    *,
    seed: int,
    count: int,
    earlier: dict[str, Any] | None = None,
    quick: bool = False,
    keep: Callable[[dict[str, Any], Verdict | None], None],
) -> dict[str, Any]:
    """Judge ``count`` mutants and call ``keep`` with the table so far after each; returns the final table."""
    work = MutationRun(out, seed=seed, count=count, earlier=earlier, quick=quick)
    keep(work.to_dict(), None)
    for verdict in work.steps():
        keep(work.to_dict(), verdict)
    shutil.rmtree(out / "tree", ignore_errors=True)
    shutil.rmtree(out / "builds", ignore_errors=True)
    return work.to_dict()
