"""The constrained-random regression: many cases in one simulation per array, scored against the list of bins."""

from __future__ import annotations

import json
import resource
import shutil
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from macram.spec import ArrayConfig
from macram_sim.array import build_array
from macram_sim.folders import gone_if_interrupted, job_folder
from macram_sim.regression.arrays import ARRAYS
from macram_sim.regression.coverage import Score, score
from macram_sim.regression.observation import Observation
from macram_sim.runner import run

CASES = 60
"""Default number of cases per array."""


@dataclass(frozen=True)
class Regression:
    """A regression in which every case passed.

    Attributes:
        arrays: configurations that were simulated.
        seen: what each case met.
        coverage: the score.
        seconds: wall time of the simulations, builds left out.
        cpu_seconds: their processor time, which a busy machine does not change.
    """

    arrays: tuple[ArrayConfig, ...]
    seed: int
    seen: tuple[Observation, ...]
    coverage: Score
    seconds: float
    cpu_seconds: float

    @property
    def cycles(self) -> int:
        """Array cycles of the images that ran from start to end."""
        return sum(counters["cycles"] for seen in self.seen for counters in seen.counters)

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON."""
        return {
            "format": 1,
            "seed": self.seed,
            "arrays": [array.to_dict() for array in self.arrays],
            "cases": len(self.seen),
            "images": sum(len(seen.counters) for seen in self.seen),
            "cycles": self.cycles,
            "seconds": round(self.seconds, 2),
            "cpu_seconds": round(self.cpu_seconds, 2),
            "bins": len(self.coverage.hits),
            "bins_met": len(self.coverage.hits) - len(self.coverage.missed),
            "missed": self.coverage.missed,
            "not_admitted": self.coverage.impossible,
            "hits": self.coverage.hits,
        }


def regress(
    arrays: Sequence[ArrayConfig],
    *,
    seed: int,
    cases: int = CASES,
    only: int | None = None,
    progress: Callable[[int], None] | None = None,
) -> Regression:
    """Run the planned cases on every array.

    Args:
        arrays: configurations, each simulated in one process.
        seed: of everything random, 0 or more.
        cases: cases per array.
        only: run this case alone instead.
        progress: called with the number of cases finished so far, over all arrays.

    Raises:
        ValueError: an argument is out of range.
        SimulationError: a case failed; the message names it and the line that replays it.
        ToolError: a tool is missing.
    """
    indices = choose_cases(seed, cases, only)
    seen: list[Observation] = []
    seconds = cpu_seconds = 0.0
    for array in arrays:
        model = build_array(array)
        folder = job_folder(f"regression-{array.name}")
        job = {"array": array.to_dict(), "seed": seed, "indices": indices}
        (folder / "job.json").write_text(json.dumps(job))
        lines = folder / "seen.jsonl"
        before = _children_seconds()
        with gone_if_interrupted(folder), _Following(lines, len(seen), progress):
            done = run(
                model,
                "macram_sim.bench_regression",
                folder / "run",
                seed=seed,
                env={"MACRAM_JOB": str(folder)},
                rerun=_replay(array, seed, cases, only),
            )
        seconds += done.seconds
        cpu_seconds += _children_seconds() - before
        seen += [Observation.from_dict(array, json.loads(line)) for line in lines.read_text().splitlines()]
        shutil.rmtree(folder, ignore_errors=True)
    return Regression(tuple(arrays), seed, tuple(seen), score(arrays, seen), seconds, cpu_seconds)


def _children_seconds() -> float:
    """Processor time of this process's children that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def choose_cases(seed: int, cases: int = CASES, only: int | None = None) -> list[int]:
    """Indices of the cases that `regress` runs on each array.

    Raises:
        ValueError: an argument is out of range.
    """
    if seed < 0:
        raise ValueError(f"the seed must be at least 0, not {seed}")
    if cases < 1:
        raise ValueError(f"cases must be at least 1, not {cases}")
    if only is not None and only < 0:
        raise ValueError(f"the case to run must be at least 0, not {only}")
    return list(range(cases)) if only is None else [only]


def _replay(array: ArrayConfig, seed: int, cases: int, only: int | None) -> str:
    line = (
        "macram verify regression " + (f"--array {array.name} " if array in ARRAYS else "") + f"--seed {seed}"
    )
    return (
        f"{line} --only {only}"
        if only is not None
        else f"{line} --cases {cases} (or --only with the case's number)"
    )


class _Following:
    """Reports the growth of a file of lines while the simulator writes it."""

    def __init__(self, path: Path, before: int, report: Callable[[int], None] | None) -> None:
        self._path, self._before, self._report = path, before, report
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._follow, daemon=True)

    def __enter__(self) -> None:
        if self._report is not None:
            self._thread.start()

    def __exit__(self, *_: object) -> None:
        self._ended.set()
        if self._report is not None:
            self._thread.join()

    def _follow(self) -> None:
        assert self._report is not None
        while not self._ended.wait(0.5):
            if self._path.is_file():
                self._report(self._before + self._path.read_text().count("\n"))
