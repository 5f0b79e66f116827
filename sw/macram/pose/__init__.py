"""Poses from 2D-3D pairs, their errors and their pictures; NumPy and OpenCV only.

Names and units follow the BOP toolkit: ``R`` 3x3, ``t`` 3x1, millimetres, OpenCV camera axes.
"""

from macram.data.geometry import BOX_EDGES, box_corners, project, transform
from macram.pose.correspond import Candidates, LevelCells, decode, level_quota, select_candidates
from macram.pose.detection import Detection, PoseSettings, detect, detect_again
from macram.pose.draw import draw_pose
from macram.pose.edges import EdgeSettings, refine_on_edges
from macram.pose.evaluation import Evaluation, GroundTruth, evaluate
from macram.pose.looks import LookSettings
from macram.pose.metrics import add, adi, proj, re, sample_vertices, te
from macram.pose.pnp import PnpResult, RansacSettings, epnp, solve_pnp
from macram.pose.rigid import Pose, camera_matrix
from macram.pose.score import SpeedScore, speed_score

__all__ = [
    "BOX_EDGES",
    "Candidates",
    "Detection",
    "EdgeSettings",
    "Evaluation",
    "GroundTruth",
    "LevelCells",
    "LookSettings",
    "PnpResult",
    "Pose",
    "PoseSettings",
    "RansacSettings",
    "SpeedScore",
    "add",
    "adi",
    "box_corners",
    "camera_matrix",
    "decode",
    "detect",
    "detect_again",
    "draw_pose",
    "epnp",
    "evaluate",
    "level_quota",
    "proj",
    "project",
    "re",
    "refine_on_edges",
    "sample_vertices",
    "select_candidates",
    "solve_pnp",
    "speed_score",
    "te",
    "transform",
]
