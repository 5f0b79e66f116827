"""The score of the Satellite Pose Estimation Challenge (SPEED, 2019)."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from macram.pose.metrics import rotation_angle, te
from macram.pose.rigid import Floats

MissConvention = Literal["count", "skip"]

# A frame without an answer: the largest possible rotation error, and the translation error of the answer 0.
MISS_E_Q = float(np.pi)
MISS_E_T = 1.0

# The published evaluation drops such answers together with the frames that have none.
_ABSURD_E_T = 1000.0


def e_q(R_est: ArrayLike, R_gt: ArrayLike) -> Floats:
    """Quaternion error ``2 acos |<q, q^>|``, rad in 0..pi, of ``[..., 3, 3]`` rotations."""
    return rotation_angle(R_est, R_gt)


def e_t(t_est: ArrayLike, t_gt: ArrayLike) -> Floats:
    """Translation error ``|t - t^| / |t|`` of ``[..., 3, 1]`` translations; no unit.

    Raises:
        ValueError: a true translation is zero.
    """
    distance = np.linalg.norm(np.asarray(t_gt, np.float64), axis=(-2, -1))
    if np.any(distance == 0):
        raise ValueError("a true translation of zero has no relative error; the target is at the camera")
    return np.asarray(te(t_est, t_gt) / distance)


@dataclass(frozen=True, slots=True)
class SpeedScore:
    """Means over a set of frames; ``score = e_q + e_t``. None where no frame is counted.

    Attributes:
        e_q: mean quaternion error, rad.
        e_t: mean relative translation error.
        score: the sum of the two.
        counted: frames in the means.
        skipped: frames left out (only with the convention "skip").
        misses: the convention, as in `speed_score`.
    """

    e_q: float | None
    e_t: float | None
    score: float | None
    counted: int
    skipped: int
    misses: MissConvention

    def to_dict(self) -> dict[str, float | int | str | None]:
        """Plain values for JSON."""
        return asdict(self)


def speed_score(
    e_q: ArrayLike, e_t: ArrayLike, detected: ArrayLike, *, misses: MissConvention = "count"
) -> SpeedScore:
    """Score of a set of frames.

    Args:
        e_q: ``[n]`` quaternion errors, rad; ignored where nothing was detected.
        e_t: ``[n]`` relative translation errors; ignored where nothing was detected.
        detected: ``[n]`` flags.
        misses: "count" charges a frame without an answer `MISS_E_Q` and `MISS_E_T`; "skip" is what the
            published CA-SpaceNet figures do: such frames, and answers with ``e_t > 1000``, leave the mean.

    Raises:
        ValueError: different lengths, or an unknown convention.
    """
    rotation, translation = np.asarray(e_q, np.float64), np.asarray(e_t, np.float64)
    found = np.asarray(detected, bool)
    if not rotation.shape == translation.shape == found.shape or found.ndim != 1:
        raise ValueError(
            f"e_q, e_t and detected must be lists of one length, not {list(rotation.shape)}, "
            f"{list(translation.shape)}, {list(found.shape)}"
        )
    if misses == "count":
        rotation, translation = np.where(found, rotation, MISS_E_Q), np.where(found, translation, MISS_E_T)
    elif misses == "skip":
        kept = found & ~(translation > _ABSURD_E_T)
        rotation, translation = rotation[kept], translation[kept]
    else:
        raise ValueError(f'misses is {misses!r}; choose "count" or "skip"')
    counted, skipped = len(rotation), len(found) - len(rotation)
    if not counted:
        return SpeedScore(None, None, None, 0, skipped, misses)
    mean_q, mean_t = float(rotation.mean()), float(translation.mean())
    return SpeedScore(mean_q, mean_t, mean_q + mean_t, counted, skipped, misses)
