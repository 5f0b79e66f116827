"""Records of finished runs with their frames."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from macram.experiments.integers import read_integers
from macram.experiments.plan import RESULT, Job, Plan, read_result
from macram.experiments.refined import RefinedScores, read_refined
from macram.experiments.statistics import Frames, read_frames


@dataclass(frozen=True, eq=False, slots=True)
class Finished:
    """One record with its frames, and where there are any its refined scores and those of its deployed integers."""

    job: Job
    table: dict[str, Any]
    frames: Frames
    refined: RefinedScores | None
    integers: dict[str, Any] | None


def finished(plan: Plan, results: Path) -> list[Finished]:
    """Every record that is there, in the order of the plan.

    Raises:
        ValueError: a broken file, or one of another network than the record beside it.
    """
    return [
        _finished(job, folder) for job in plan.jobs() if ((folder := results / job.key) / RESULT).is_file()
    ]


def _finished(job: Job, folder: Path) -> Finished:
    record = read_result(folder)
    return Finished(
        job,
        record,
        read_frames(folder / "frames.csv"),
        read_refined(job, folder, record),
        read_integers(job, folder, record),
    )
