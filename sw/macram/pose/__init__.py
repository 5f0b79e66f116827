"""Poses from 2D-3D pairs, their errors and their pictures; NumPy and OpenCV only.

Names and units follow the BOP toolkit: ``R`` 3x3, ``t`` 3x1, millimetres, OpenCV camera axes.
"""

from macram.data.geometry import BOX_EDGES, box_corners, project, transform
from macram.pose.correspond import Candidates, LevelCells, decode, level_quota, select_candidates
from macram.pose.detection import Detection, detect
from macram.pose.draw import draw_pose
from macram.pose.evaluation import Evaluation, GroundTruth, evaluate
from macram.pose.metrics import add, adi, proj, re, sample_vertices, te
from macram.pose.pnp import PnpResult, RansacSettings, epnp, solve_pnp
from macram.pose.rigid import Pose, camera_matrix
from macram.pose.score import SpeedScore, speed_score

__all__ = [
    "BOX_EDGES",
    "Candidates",
    "Detection",
    "Evaluation",
    "GroundTruth",
    "LevelCells",
    "PnpResult",
    "Pose",
    "RansacSettings",
    "SpeedScore",
    "add",
    "adi",
    "box_corners",
    "camera_matrix",
    "decode",
    "detect",
    "draw_pose",
    "epnp",
    "evaluate",
    "level_quota",
    "proj",
    "project",
    "re",
    "sample_vertices",
    "select_candidates",
    "solve_pnp",
    "speed_score",
    "te",
    "transform",
]
