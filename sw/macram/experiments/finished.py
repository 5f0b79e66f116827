"""Records of finished runs with their frames."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from macram.data.files import read_json
from macram.experiments.integers import INTEGERS
from macram.experiments.plan import RESULT, Job, Plan, read_result
from macram.experiments.statistics import Frames, read_frames


@dataclass(frozen=True, eq=False, slots=True)
class Finished:
    """One record with its frames, and the scores of its deployed integers where there are any."""

    job: Job
    table: dict[str, Any]
    frames: Frames
    integers: dict[str, Any] | None


def finished(plan: Plan, results: Path) -> list[Finished]:
    """Every record that is there, in the order of the plan."""
    return [
        Finished(job, read_result(folder), read_frames(folder / "frames.csv"), _integers(folder / INTEGERS))
        for job in plan.jobs()
        if ((folder := results / job.key) / RESULT).is_file()
    ]


def _integers(path: Path) -> dict[str, Any] | None:
    return read_json(path) if path.is_file() else None
