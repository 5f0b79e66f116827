"""Records of finished runs with their frames."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from macram.experiments.plan import RESULT, Job, Plan, read_result
from macram.experiments.statistics import Frames, read_frames


@dataclass(frozen=True, eq=False, slots=True)
class Finished:
    """One record with its frames."""

    job: Job
    table: dict[str, Any]
    frames: Frames


def finished(plan: Plan, results: Path) -> list[Finished]:
    """Every record that is there, in the order of the plan."""
    return [
        Finished(job, read_result(results / job.key), read_frames(results / job.key / "frames.csv"))
        for job in plan.jobs()
        if (results / job.key / RESULT).is_file()
    ]
