"""Errors of a set of predicted poses: one row per frame, and shares per depth range."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from macram.pose import metrics, score
from macram.pose.rigid import Floats, Pose, camera_matrix

BUCKETS = ("near", "medium", "far")
FIXED_LIMITS_D = (1.0, 4.0, 7.0, 10.0)
DISTANCE_THRESHOLDS_D = (0.05, 0.1, 0.2, 0.5)
REPROJECTION_THRESHOLDS_PX = (2.0, 5.0, 10.0, 20.0)

# What a frame without a usable pose is charged, as in the published evaluation.
MISS_D = 1.0
MISS_PX = 50.0

# The published bins end this far above the largest depth, so that the farthest frame falls into the last one.
_BIN_MARGIN = 1e-5

# Poses are compared in blocks: 256 x 1000 points keep the arrays within a few megabytes.
_BLOCK = 256


@dataclass(frozen=True, slots=True, eq=False)
class GroundTruth:
    """The truth about one image.

    Attributes:
        name: unique within a set.
        pose: object to camera, mm.
        K: ``[3, 3]`` intrinsics of the original image, px.
    """

    name: str
    pose: Pose
    K: Floats

    def __post_init__(self) -> None:
        object.__setattr__(self, "K", camera_matrix(self.K))
        if self.pose.t[2, 0] <= 0:
            raise ValueError(
                f"frame {self.name}: depth {self.pose.t[2, 0]:g} mm is not in front of the camera"
            )


@dataclass(frozen=True, slots=True)
class Evaluation:
    """The result of `evaluate`; both parts hold plain values and go into JSON as they are.

    Attributes:
        rows: one per frame, in the order given: ``frame``, ``detected``, ``z_mm``, ``z_d``, ``fixed`` and
            ``thirds`` (bucket names; "outside" beyond the fixed limits), ``add_mm``, ``add_d``, ``adi_mm``,
            ``adi_d``, ``proj_px``, and ``re_deg``, ``te_mm``, ``e_q``, ``e_t``, which are None for a miss.
        summary: see `evaluate`.
    """

    rows: list[dict[str, Any]]
    summary: dict[str, Any]


def fixed_buckets(z: ArrayLike, diameter: float) -> NDArray[np.int64]:
    """Bucket of each depth by the limits 1d, 4d, 7d, 10d: 0 near, 1 medium, 2 far, -1 outside.

    A lower limit belongs to its bucket; 10d itself still counts as far.
    """
    # Nine digits: a depth of 7d stays 7d through the product and this division.
    depth = np.round(np.asarray(z, np.float64) / diameter, 9)
    index = np.searchsorted(FIXED_LIMITS_D, depth, side="right") - 1
    index = np.where(depth == FIXED_LIMITS_D[-1], len(BUCKETS) - 1, index)
    return np.where((index >= 0) & (index < len(BUCKETS)), index, -1)


def third_limits(z: ArrayLike) -> Floats:
    """The published bucket limits ``[4]``: three equal parts of the range of depths in the set itself."""
    depth = np.asarray(z, np.float64)
    return np.linspace(depth.min(), depth.max() + _BIN_MARGIN, len(BUCKETS) + 1)


def third_buckets(z: ArrayLike) -> NDArray[np.int64]:
    """Bucket of each depth by `third_limits`: 0 near, 1 medium, 2 far."""
    depth = np.asarray(z, np.float64)
    return np.clip(np.searchsorted(third_limits(depth), depth, side="right") - 1, 0, len(BUCKETS) - 1)


def evaluate(
    predictions: Mapping[str, Pose | None],
    frames: Sequence[GroundTruth],
    *,
    vertices: ArrayLike,
    diameter: float,
) -> Evaluation:
    """Compare predicted poses with the truth. Pure: no files, no random numbers.

    A frame without a prediction is never left out: it counts as an error of 1.0 d and 50 px, and in the SPEED
    score as set out in `macram.pose.score.speed_score`.

    Args:
        predictions: pose by frame name; None or no entry is a miss.
        frames: the truth.
        vertices: ``[n, 3]`` model points for ADD, ADI and reprojection, mm; see `sample_vertices`.
        diameter: object diameter d, mm.

    Returns:
        Rows and a summary with ``frames``, ``misses``, ``diameter_mm``, ``vertices``, ``limits_mm`` (of both
        divisions), ``outside`` (frames beyond the fixed limits: in "all" only), ``fixed`` and ``thirds``
        (each with ``near``, ``medium``, ``far``, ``all``), ``speed`` (conventions ``count`` and ``skip``). A
        range has ``frames``, ``misses``, ``add`` and ``adi`` (percent of its frames with an error strictly
        below ``0.05`` .. ``0.5`` d), ``proj`` (percent below ``2`` .. ``20`` px), the medians
        ``add_d_median``, ``adi_d_median``, ``proj_px_median`` with misses, ``re_deg_median`` and
        ``te_mm_median`` without. What has no frames is None. ``add["0.1"]`` is the paper's ADI-0.1d.

    Raises:
        ValueError: no frames, a name twice, a prediction for an unknown frame, or a bad diameter.
    """
    points = np.asarray(vertices, np.float64)
    if points.ndim != 2 or points.shape[1] != 3 or not len(points):
        raise ValueError(f"vertices must be [n, 3], not {list(points.shape)}")
    if not (np.isfinite(diameter) and diameter > 0):
        raise ValueError(f"the diameter is {diameter} mm; it must be above 0")
    names = [frame.name for frame in frames]
    _check_names(names, predictions)
    errors = _errors([predictions.get(name) for name in names], frames, points, diameter)
    z = np.array([frame.pose.t[2, 0] for frame in frames])
    groups = {"fixed": fixed_buckets(z, diameter), "thirds": third_buckets(z)}

    summary: dict[str, Any] = {
        "frames": len(frames),
        "misses": int((~errors["detected"]).sum()),
        "diameter_mm": float(diameter),
        "vertices": len(points),
        "limits_mm": {
            "fixed": [limit * float(diameter) for limit in FIXED_LIMITS_D],
            "thirds": third_limits(z).tolist(),
        },
        "outside": int((groups["fixed"] < 0).sum()),
    }
    for division, index in groups.items():
        ranges = {bucket: index == number for number, bucket in enumerate(BUCKETS)}
        ranges["all"] = np.ones(len(frames), bool)
        summary[division] = {bucket: _range(errors, chosen, diameter) for bucket, chosen in ranges.items()}
    conventions: tuple[score.MissConvention, ...] = ("count", "skip")
    summary["speed"] = {
        misses: score.speed_score(errors["e_q"], errors["e_t"], errors["detected"], misses=misses).to_dict()
        for misses in conventions
    }
    return Evaluation(_rows(names, z, diameter, groups, errors), summary)


def _check_names(names: Sequence[str], predictions: Mapping[str, Pose | None]) -> None:
    if not names:
        raise ValueError("no frames to evaluate")
    known = set(names)
    if len(known) < len(names):
        twice = next(name for name in names if names.count(name) > 1)
        raise ValueError(f"frame {twice} is there twice; names must be unique")
    unknown = sorted(set(predictions) - known)
    if unknown:
        raise ValueError(
            f"{len(unknown)} predictions belong to no frame, the first is {unknown[0]}; "
            "evaluate them against their own set"
        )


def _errors(
    poses: Sequence[Pose | None], frames: Sequence[GroundTruth], points: Floats, diameter: float
) -> dict[str, NDArray[Any]]:
    """Errors ``[n]`` by name. Misses: add, adi and proj as charged; re, te, e_q, e_t NaN."""
    count = len(frames)
    found = np.array([pose is not None for pose in poses])
    result: dict[str, NDArray[Any]] = {"detected": found}
    for name, miss in (("add", MISS_D * diameter), ("adi", MISS_D * diameter), ("proj", MISS_PX)):
        result[name] = np.full(count, miss)
    for name in ("re", "te", "e_q", "e_t"):
        result[name] = np.full(count, np.nan)
    pairs = [(i, pose, frames[i]) for i, pose in enumerate(poses) if pose is not None]
    for start in range(0, len(pairs), _BLOCK):
        block = pairs[start : start + _BLOCK]
        index = np.array([i for i, _, _ in block])
        r_est, t_est = np.stack([p.R for _, p, _ in block]), np.stack([p.t for _, p, _ in block])
        r_gt, t_gt = np.stack([f.pose.R for _, _, f in block]), np.stack([f.pose.t for _, _, f in block])
        cameras = np.stack([f.K for _, _, f in block])
        result["add"][index] = metrics.add(r_est, t_est, r_gt, t_gt, points)
        result["adi"][index] = metrics.adi(r_est, t_est, r_gt, t_gt, points)
        # A pose with points behind the camera has no picture to compare; it is charged like a miss.
        pixels = metrics.proj(r_est, t_est, r_gt, t_gt, cameras, points)
        result["proj"][index] = np.where(np.isfinite(pixels), pixels, MISS_PX)
        result["re"][index] = metrics.re(r_est, r_gt)
        result["te"][index] = metrics.te(t_est, t_gt)
        result["e_q"][index] = score.e_q(r_est, r_gt)
        result["e_t"][index] = score.e_t(t_est, t_gt)
    return result


def _range(errors: dict[str, NDArray[Any]], chosen: NDArray[np.bool_], diameter: float) -> dict[str, Any]:
    found = chosen & errors["detected"]
    table: dict[str, Any] = {"frames": int(chosen.sum()), "misses": int(chosen.sum() - found.sum())}
    for name in ("add", "adi"):
        values = errors[name][chosen] / diameter
        table[name] = {f"{limit:g}": _percent(values, limit) for limit in DISTANCE_THRESHOLDS_D}
    table["proj"] = {f"{px:g}": _percent(errors["proj"][chosen], px) for px in REPROJECTION_THRESHOLDS_PX}
    table["add_d_median"] = _median(errors["add"][chosen] / diameter)
    table["adi_d_median"] = _median(errors["adi"][chosen] / diameter)
    table["proj_px_median"] = _median(errors["proj"][chosen])
    table["re_deg_median"] = _median(errors["re"][found])
    table["te_mm_median"] = _median(errors["te"][found])
    return table


def _percent(values: Floats, limit: float) -> float | None:
    return 100.0 * int((values < limit).sum()) / len(values) if len(values) else None


def _median(values: Floats) -> float | None:
    return float(np.median(values)) if len(values) else None


def _rows(
    names: Sequence[str],
    z: Floats,
    diameter: float,
    groups: Mapping[str, NDArray[np.int64]],
    errors: Mapping[str, NDArray[Any]],
) -> list[dict[str, Any]]:
    labels = (*BUCKETS, "outside")
    rows = []
    for i, name in enumerate(names):
        found = bool(errors["detected"][i])
        row: dict[str, Any] = {"frame": name, "detected": found}
        row |= {"z_mm": float(z[i]), "z_d": float(z[i] / diameter)}
        row |= {division: labels[index[i]] for division, index in groups.items()}
        row |= {"add_mm": float(errors["add"][i]), "add_d": float(errors["add"][i] / diameter)}
        row |= {"adi_mm": float(errors["adi"][i]), "adi_d": float(errors["adi"][i] / diameter)}
        row["proj_px"] = float(errors["proj"][i])
        for key, column in (("re_deg", "re"), ("te_mm", "te"), ("e_q", "e_q"), ("e_t", "e_t")):
            row[key] = float(errors[column][i]) if found else None
        rows.append(row)
    return rows
