"""Running cocotb modules on a Verilated model, and insisting that their tests ran and passed."""

from __future__ import annotations

import os
import random
import shlex
import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

from macram_sim.build import Build, LeanVerilator, SimulationError, waves_wanted
from macram_sim.tools import find_toolchain


@dataclass(frozen=True, slots=True)
class Run:
    """A simulation whose tests all passed.

    Attributes:
        seconds: wall time of the simulator process.
        waves: the waveform file, or None.
    """

    tests: int
    seed: int
    seconds: float
    log: Path
    waves: Path | None


def run(
    model: Build,
    module: str,
    test_dir: Path,
    *,
    testcase: str | None = None,
    seed: int | None = None,
    env: Mapping[str, str] | None = None,
    files: Sequence[Path] = (),
    random_init: bool = False,
    waves: bool | None = None,
    timeout: float | None = None,
    rerun: str | None = None,
) -> Run:
    """Run the cocotb tests of ``module`` on ``model`` in ``test_dir`` and insist that they ran and passed.

    Args:
        model: what `build` returned; built with the same ``waves``.
        module: importable name of the module that holds the tests.
        test_dir: working directory of the simulator; ``$readmemh`` paths start here.
        testcase: run only this test.
        seed: seed of Python's and cocotb's random numbers; default ``SEED`` of the environment, else random.
            Printed.
        env: further environment variables of the simulator.
        files: files to link into ``test_dir``, such as ``.mem`` files.
        random_init: start registers and memories without an initial value from random values of ``seed``.
        waves: write ``dump.fst`` or ``dump.vcd`` into ``test_dir``; ``WAVES`` of the environment wins.
        timeout: seconds after which the simulator is killed.
        rerun: command that repeats the run, for messages; default one made of ``SEED`` and the program's
            arguments.

    Raises:
        SimulationError: a test failed, none ran, the simulator died or the time was up; the message holds the
            first failure, the log's name and the line that runs it again.
        ValueError: waveforms are wanted and ``model`` cannot write them.
    """
    seed = choose_seed(seed)
    traced = waves_wanted(waves)
    if traced and not model.waves:
        raise ValueError(f"{model.directory.name} was built without waves; build it with waves=True")
    test_dir = Path(test_dir).resolve()
    test_dir.mkdir(parents=True, exist_ok=True)
    for file in files:
        _link(Path(file).resolve(), test_dir / Path(file).name)
    log = test_dir / "simulation.log"
    results = test_dir / "results.xml"
    rerun = rerun or f"SEED={seed} {shlex.join(sys.orig_argv)}"
    print(f"{module}: seed {seed}", file=sys.stderr, flush=True)
    start = time.perf_counter()
    trouble = ""
    try:
        # Under pytest cocotb's runner exits by itself; the results file is judged below in either case.
        with suppress(SystemExit):
            LeanVerilator(find_toolchain(), timeout=timeout).test(
                module,
                model.toplevel,
                hdl_toplevel_lang="verilog",
                testcase=testcase,
                seed=seed,
                extra_env={
                    "COCOTB_ANSI_OUTPUT": "0",
                    # pytest's clearer assertions for the bench alone: for every module that it imports, NumPy
                    # too, they take longer than the rest of the start.
                    "COCOTB_REWRITE_ASSERTION_FILES": f"{module.rpartition('.')[2]}.py",
                    "COCOTB_RESULTS_RELATIVE_TO": str(test_dir),
                    **(env or {}),
                },
                plusargs=[
                    f"+verilator+seed+{seed % 0x7FFF_FFFF + 1}",
                    f"+verilator+rand+reset+{2 if random_init else 0}",
                ],
                build_dir=model.directory,
                test_dir=test_dir,
                results_xml=str(results),
                waves=traced,
                log_file=log,
            )
    except subprocess.TimeoutExpired:
        trouble = f"no result after {timeout:g} s"
    seconds = time.perf_counter() - start
    tests, failure = _judge(results)
    trouble = trouble or failure or ("no test ran" if tests == 0 else "")
    if trouble:
        raise SimulationError(f"{module} on {model.toplevel}: {trouble}\n  log: {log}\n  again: {rerun}")
    dump = test_dir / f"dump.{model.waves}"
    return Run(tests, seed, seconds, log, dump if traced else None)


def choose_seed(seed: int | None = None) -> int:
    """``seed``, else ``SEED`` of the environment, else a random one in 0..2**31 - 1.

    Raises:
        ValueError: ``SEED`` is not a whole number.
    """
    if seed is not None:
        return seed
    if text := os.environ.get("SEED", "").strip():
        if not text.isdigit():
            raise ValueError(f"SEED must be a whole number, not {text!r}")
        return int(text)
    return random.SystemRandom().randrange(1 << 31)


def _judge(results: Path) -> tuple[int, str]:
    """Tests that ran, and the first failure or error in one line (empty if there is none)."""
    if not results.is_file():
        return 0, "the simulator ended without results"
    ran, failure = 0, ""
    for case in ElementTree.parse(results).getroot().iter("testcase"):
        if case.find("skipped") is not None:
            continue
        ran += 1
        for kind in ("failure", "error"):
            found = case.find(kind)
            if found is not None and not failure:
                text = found.get("message") or found.get("error_msg") or (found.text or "").strip()
                kind_name = found.get("type") or found.get("error_type") or kind
                failure = f"{case.get('name')}: {kind_name}: {text.strip() or 'no message'}"
    return ran, failure


def _link(source: Path, target: Path) -> None:
    if not source.is_file():
        raise ValueError(f"{source} does not exist")
    target.unlink(missing_ok=True)
    target.symlink_to(source)
