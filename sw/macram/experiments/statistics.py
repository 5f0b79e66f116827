"""Shares of frames with their spread, and the difference of two rows on the same frames.

Frames of one sequence look alike, so sequences, not frames, are drawn again (bootstrap, 95 % between the
percentiles). This is the spread over test scenes; the spread over trainings needs several seeds.
"""

from __future__ import annotations

import csv
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from macram.data.geometry import BUCKETS

DRAWS = 2000
SEED = 2022
THRESHOLD_D = 0.1


@dataclass(frozen=True, eq=False, slots=True)
class Frames:
    """Errors of one record, frame by frame; NaN where nothing was found.

    Attributes:
        names: of the frames, ``testing/seq_000275/000000/000000``.
        ranges: near, medium, far or outside.
        z_d: depth, diameters.
        add_d: ADD, diameters; a miss counts as 1.
        re_deg: rotation error.
        te_d: translation error, diameters.
    """

    names: tuple[str, ...]
    ranges: NDArray[np.str_]
    z_d: NDArray[np.float64]
    add_d: NDArray[np.float64]
    re_deg: NDArray[np.float64]
    te_d: NDArray[np.float64]

    @property
    def sequences(self) -> NDArray[np.int64]:
        """Number of each frame's sequence, from 0."""
        folders = [name.rpartition("/")[0] for name in self.names]
        return np.unique(folders, return_inverse=True)[1].astype(np.int64)

    def within(self, name: str) -> NDArray[np.bool_]:
        """Frames of a range; ``all`` for every frame."""
        return np.ones(len(self.names), bool) if name == "all" else self.ranges == name


def read_frames(path: Path) -> Frames:
    """``frames.csv`` of a record.

    Raises:
        ValueError: missing or broken.
    """
    try:
        with path.open(newline="") as file:
            rows = list(csv.DictReader(file))
        numbers = {
            key: np.array([float(row[key]) if row[key] else np.nan for row in rows])
            for key in ("z_d", "add_d", "re_deg", "te_d")
        }
        return Frames(tuple(r["frame"] for r in rows), np.array([r["range"] for r in rows]), **numbers)
    except FileNotFoundError:
        raise ValueError(f"{path}: is missing; run the row again") from None
    except (KeyError, ValueError, TypeError) as error:
        raise ValueError(f"{path}: not a list of frames ({error}); run the row again") from None


def share(frames: Frames, name: str = "all", threshold: float = THRESHOLD_D) -> float:
    """Percent of a range's frames whose ADD is below ``threshold`` diameters."""
    return 100.0 * float((frames.add_d[frames.within(name)] < threshold).mean())


def interval(values: NDArray[np.float64], sequences: NDArray[np.int64]) -> tuple[float, float]:
    """95 % interval of the mean of ``values`` when sequences are drawn again."""
    count = int(sequences.max()) + 1
    sums = np.bincount(sequences, values, count)
    sizes = np.bincount(sequences, minlength=count)
    drawn = np.random.default_rng(SEED).integers(0, count, (DRAWS, count))
    means = sums[drawn].sum(axis=1) / sizes[drawn].sum(axis=1)
    low, high = np.percentile(means, (2.5, 97.5))
    return float(low), float(high)


def share_interval(frames: Frames, threshold: float = THRESHOLD_D) -> tuple[float, float]:
    """95 % interval of `share` over all frames."""
    return interval(100.0 * (frames.add_d < threshold).astype(np.float64), frames.sequences)


def difference(one: Frames, other: Frames, threshold: float = THRESHOLD_D) -> tuple[float, float, float]:
    """``one`` minus ``other`` in percentage points, and its 95 % interval; both on the same frames.

    Raises:
        ValueError: other frames.
    """
    if one.names != other.names:
        raise ValueError("two rows were scored on different frames; score both on all of them")
    values = 100.0 * ((one.add_d < threshold).astype(np.float64) - (other.add_d < threshold))
    return float(values.mean()), *interval(values, one.sequences)


def limits(frames: Frames) -> list[dict[str, Any]]:
    """By range that has frames, and over all: what keeps poses from being within 0.1 d."""
    table = []
    for name in (*BUCKETS, "all"):
        chosen = frames.within(name)
        if not chosen.any():
            continue
        turned, moved = frames.re_deg[chosen], frames.te_d[chosen]
        found = np.isfinite(turned)
        table.append(
            {
                "range": name,
                "frames": int(chosen.sum()),
                "add": share(frames, name),
                "placed": 100.0 * float((moved[found] < THRESHOLD_D).sum()) / int(chosen.sum()),
                "te_d": float(np.median(moved[found])),
                "re_deg": float(np.median(turned[found])),
                "flipped": 100.0 * float((turned[found] > FLIP_DEG).sum()) / int(chosen.sum()),
            }
        )
    return table


FLIP_DEG = 45.0
"""A rotation error beyond half a quarter turn: another face was taken for the one that is seen."""


def spread(values: Sequence[float]) -> tuple[float, float]:
    """Mean and standard deviation (n - 1) over seeds; 0 for a single one."""
    return float(np.mean(values)), float(np.std(values, ddof=1)) if len(values) > 1 else 0.0
