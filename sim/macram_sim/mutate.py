"""The mutation run: break the gateware in one place at a time and see whether the checks notice.

Which places, in which order, and how each mutant ended; `macram_sim.mutant_checks` is what judges one.
"""

from __future__ import annotations

import random
import time
import tomllib
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import macram_hw
from macram_sim.mutant_checks import CHECKS, MutantChecks
from macram_sim.mutation_points import Mutation, mutations
from macram_sim.regression import ARRAYS

EQUIVALENTS = Path(__file__).with_name("equivalents.toml")


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
        root = Path(str(macram_hw.__file__)).resolve().parents[2]
        if not (root / "tests" / "hw").is_dir():
            raise ValueError(
                "the mutation run needs the tests; start it from a checkout, installed with pip -e"
            )
        self.seed, self.count, self.quick = seed, count, quick
        self._checks = MutantChecks(root, Path(out).resolve(), seed=seed, quick=quick)
        self.verdicts: list[Verdict] = []
        self.no_mutants = 0
        self._tried = 0
        if earlier and earlier["seed"] == seed and earlier["sources"] == self._checks.digest:
            self.verdicts = [Verdict(**row) for row in earlier["mutants"]]
            self._tried, self.no_mutants = earlier["tried"], earlier["no_mutants"]
        self._equivalents = {
            (row["file"], row["old"], row["new"]): row["reason"]
            for row in tomllib.loads(EQUIVALENTS.read_text())["equivalent"]
        }

    def candidates(self) -> list[Mutation]:
        """Every mutation of the gateware in the seeded order in which they are tried.

        Files take turns by their share of the mutations, so that a short run touches every module.
        """
        rng = random.Random(f"mutants {self.seed}")
        ranked = []
        for name, text in self._checks.sources.items():
            found = mutations(name, text)
            rng.shuffle(found)
            ranked += [((i + rng.random()) / len(found), m) for i, m in enumerate(found)]
        return [mutation for _, mutation in sorted(ranked, key=lambda pair: pair[0])]

    def steps(self) -> Iterator[Verdict]:
        """Judge mutants until there are enough; yields each verdict."""
        sound = self._checks.fingerprints({})
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
        text = self._checks.sources[verdict.file]
        return next(
            mutation
            for mutation in mutations(verdict.file, text)
            if (mutation.line, mutation.kind, *mutation.lines(text))
            == (verdict.line, verdict.kind, verdict.old, verdict.new)
        )

    def _judge(self, mutation: Mutation, sound: dict[str, str]) -> Verdict | None:
        """None if it does not elaborate or changes no small array."""
        started = time.perf_counter()
        old, new = mutation.lines(self._checks.sources[mutation.file])
        with self._checks.applied(mutation):
            changed = self._checks.fingerprints(sound) or {}
        array = next((name for name in changed if changed[name] != sound[name]), None)
        if array is None:
            return None
        killed_by, how = self._checks.kill(mutation, array)
        if killed_by == "survived" and (reason := self._equivalents.get((mutation.file, old, new))):
            killed_by, how = "equivalent", reason
        seconds = round(time.perf_counter() - started, 1)
        return Verdict(mutation.file, mutation.line, mutation.kind, old, new, array, killed_by, how, seconds)

    def clear(self) -> None:
        """Remove the frozen copy."""
        self._checks.clear()

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON; what a later call goes on from."""
        by = [v.killed_by for v in self.verdicts]
        real = len(by) - by.count("equivalent")
        killed = real - by.count("survived")
        return {
            "format": 1,
            "seed": self.seed,
            "sources": self._checks.digest,
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
            "killed_by": {name: by.count(name) for name in CHECKS},
            "mutants": [asdict(verdict) for verdict in self.verdicts],
        }


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
    work.clear()
    return work.to_dict()
