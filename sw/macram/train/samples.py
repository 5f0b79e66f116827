"""How well a network in training does on validation frames: a few figures, and pictures beside the truth."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import cv2
import numpy as np
import torch
from numpy.typing import NDArray

from macram.data.frame import Frame
from macram.data.geometry import box_corners
from macram.data.open import open_dataset
from macram.model import SpaceNet
from macram.pose import Detection, Pose, draw_pose
from macram.pose.draw import TRUE
from macram.train.checkpoint import Card
from macram.train.config import TrainConfig
from macram.train.pack import thinned
from macram.train.predict import Predictor, evaluate_frames

PICTURES, COLUMNS, SIDE = 8, 4, 320


def validation_frames(config: TrainConfig) -> list[Frame]:
    """The frames that a run is scored on, evenly spaced in their split.

    Raises:
        ValueError: no such split, an empty one, or a bad file.
    """
    settings = config.data
    frames = open_dataset(Path(settings.root), settings.shrink).frames(settings.validation)
    if not frames:
        raise ValueError(
            f'{settings.root}: split {settings.validation} has no frames; set data.validation to another or ""'
        )
    return thinned(frames, config.log.evaluate_frames)


def score(
    frames: Sequence[Frame], net: SpaceNet, card: Card, device: torch.device
) -> tuple[dict[str, float], NDArray[np.uint8]]:
    """How well a network does on ``frames``.

    Returns:
        Share of frames, %, with ADD below 0.1, 0.2 and 0.5 diameters, and of misses; and `sample_sheet`.
    """
    evaluation, detections = evaluate_frames(Predictor(net, card, device), frames)
    table = evaluation.summary["fixed"]["all"]
    scores = {f"add_{limit}": table["add"][limit] for limit in ("0.1", "0.2", "0.5")}
    scores["misses"] = 100 * table["misses"] / table["frames"]
    return scores, sample_sheet(frames, detections)


def sample_sheet(frames: Sequence[Frame], detections: Sequence[Detection | None]) -> NDArray[np.uint8]:
    """A sheet ``[H, W, 3]`` of up to 8 frames: true boxes amber, predicted ones green with axes."""
    chosen = np.unique(np.linspace(0, len(frames) - 1, PICTURES).round().astype(int))
    cells = [_sample(frames[i], detections[i]) for i in chosen]
    cells += [np.zeros_like(cells[0])] * (-len(cells) % min(COLUMNS, len(cells)))
    columns = min(COLUMNS, len(cells))
    rows = [np.hstack(cells[i : i + columns]) for i in range(0, len(cells), columns)]
    return np.vstack(rows)


def _sample(frame: Frame, detection: Detection | None) -> NDArray[np.uint8]:
    corners = box_of(frame.model.keypoints)
    image = frame.read_image()
    scale = SIDE / max(image.shape[:2])
    size = round(image.shape[1] * scale), round(image.shape[0] * scale)
    image = np.asarray(cv2.resize(image, size, interpolation=cv2.INTER_AREA), np.uint8)
    camera = np.diag([scale, scale, 1.0]) @ frame.camera
    image = draw_pose(
        image, Pose(frame.rotation, frame.translation), camera, corners, colour=TRUE, axes=False
    )
    label = "none" if detection is None else f"{detection.score:.2f}"
    if detection is None:
        return np.asarray(
            cv2.putText(image, label, (8, 20), cv2.FONT_HERSHEY_SIMPLEX, 0.5, (255, 80, 80)), np.uint8
        )
    return draw_pose(image, detection.pose, camera, corners, label=label)


def box_of(keypoints: NDArray[np.float64]) -> NDArray[np.float64]:
    """``[8, 3]`` corners of the box around keypoints ``[K, 3]``, mm; of box corners, themselves."""
    return box_corners(keypoints.min(axis=0), keypoints.max(axis=0))
