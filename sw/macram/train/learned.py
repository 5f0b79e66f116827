"""A picture through a shipped network as integers: the pose, and one of its layers with learned weights.

The layer is the one at the place of the reference layer: the first 3x3 convolution of DarkNet's second stage.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

import numpy as np
import torch
from numpy.typing import NDArray

from macram.data.files import read_json, read_picture
from macram.front.case import REFERENCE_LAYER
from macram.front.image import normalise
from macram.layer_file import LayerCase
from macram.pose import EdgeSettings, LookSettings, Pose, PoseSettings, draw_pose
from macram.pose.metrics import add, re, te
from macram.pose.rigid import Floats, camera_matrix
from macram.quant import DeployedNetwork, host_codes, lower
from macram.quant.network import QuantDarkNet53
from macram.train.checkpoint import Card, load_model
from macram.train.predict import Predictor
from macram.train.samples import box_of
from macram.weights import Shipped

REFINED = PoseSettings(looks=LookSettings(turns=4), edges=EdgeSettings(box=0.9928))
"""How the demo finds the pose: as the refined scores of ``docs/results.md``, for the rendered CubeSat."""
FRAMES = "test_frames.json"
"""Beside a picture: cameras and true poses of that folder's pictures."""


@dataclass(frozen=True, eq=False, slots=True)
class LearnedFront:
    """What a learned network makes of one picture.

    Attributes:
        report: pose, camera, errors where the truth is known, and where the weights come from; JSON types.
        picture: with the box and axes found, RGB ``[H, W, 3]``.
        case: the layer with learned weights and this picture's codes.
        deployed_codes: the deployed network's output of the layer, int64 ``[C, H, W]``.
    """

    report: dict[str, Any]
    picture: NDArray[np.uint8]
    case: LayerCase
    deployed_codes: NDArray[np.int64]


def learned_front(image: Path, network: Shipped, *, focal: float | None = None) -> LearnedFront:
    """Takes a picture through the integers of a network quantised in mode III.

    Args:
        image: PNG or JPEG.
        network: shipped, in mode III.
        focal: of the picture, pixels; None takes the camera beside the picture, else the training's.

    Raises:
        ValueError: an unreadable picture, or weights that are missing, changed or not in mode III.
    """
    predictor = Predictor.load(network.checked(), integer=True, settings=REFINED)
    card = predictor.card
    picture, camera, source, known = picture_and_camera(image, card, focal)
    found = predictor.detect(picture, camera)
    corners = box_of(np.array(card.keypoints))
    drawn = picture
    if found is not None:
        drawn = draw_pose(picture, found.pose, camera, corners, label=f"{found.score:.2f}")
    fitted, _ = predictor.fit(picture, camera)
    case, codes = _layer(cast(QuantDarkNet53, predictor.net.backbone), fitted)
    report: dict[str, Any] = {
        "image": image.name,
        "cam_K": camera.ravel().tolist(),
        "camera": source,
        "network": network.name,
        "form": f"{card.bits} bit, mode {card.mode}, deployed integers",
        "solver": REFINED.words,
        "sha256": network.about["sha256"],
        "scores": network.about["scores"],
        "pose": None if found is None else found.to_dict(),
        "layer": REFERENCE_LAYER,
        "errors": pose_errors(found.pose, known, corners, card.diameter) if found and known else None,
    }
    return LearnedFront(report, drawn, case, codes)


def picture_and_camera(
    image: Path, card: Card, focal: float | None
) -> tuple[NDArray[np.uint8], Floats, str, dict[str, Any] | None]:
    """A picture for a network, and what is known of it.

    Args:
        image: PNG or JPEG.
        card: of the network.
        focal: of the picture, pixels; None takes the camera beside the picture, else the training's.

    Returns:
        RGB ``[H, W, 3]``, intrinsics ``[3, 3]``, where they come from in words, and the frame's entry of `FRAMES`.

    Raises:
        ValueError: an unreadable picture, or a focal length that is not positive.
    """
    picture = read_picture(image, colour=True, size=None)
    known = _beside(image)
    height, width = picture.shape[:2]
    if focal is None and known is not None:
        return picture, camera_matrix(np.array(known["K"], np.float64).reshape(3, 3)), f"of {FRAMES}", known
    source = "given with --focal"
    if focal is None:
        focal, source = (
            card.focal,
            "assumed: the focal length of the training; name the picture's with --focal",
        )
    if not focal > 0:
        raise ValueError(f"--focal must be above 0, not {focal}")
    camera = camera_matrix(np.array([[focal, 0, width / 2], [0, focal, height / 2], [0, 0, 1.0]]))
    return picture, camera, source, known


def reference_network(network: Shipped) -> tuple[QuantDarkNet53, dict[str, Any]]:
    """The backbone of a shipped network whose first two stages have the paper's width, and its provenance.

    Raises:
        ValueError: weights that are missing, changed, or of another width.
    """
    net, card = load_model(network.checked())
    backbone = net.backbone
    width = card.network.backbone.width
    if not isinstance(backbone, QuantDarkNet53) or width != 1:
        raise ValueError(
            f"{network.name}: is no quantised network of the paper's width; train size paper-front"
        )
    return backbone, {"weights": f"{network.name}, learned", "checkpoint_sha256": network.about["sha256"]}


def _layer(backbone: QuantDarkNet53, picture: NDArray[np.uint8]) -> tuple[LayerCase, NDArray[np.int64]]:
    height, width = picture.shape[:2]
    program = lower(backbone, height, width, last=REFERENCE_LAYER)
    tensor = normalise(picture)
    with torch.no_grad():
        tensors = DeployedNetwork(program)(host_codes(backbone, tensor))
    layer = program.conv(REFERENCE_LAYER)
    source = tensors[layer.source].numpy()
    return (
        LayerCase(layer.spec, layer.weights, source, layer.scale, layer.offset),
        tensors[REFERENCE_LAYER].numpy(),
    )


def _beside(image: Path) -> dict[str, Any] | None:
    """Camera and pose of a picture that `FRAMES` in its folder names."""
    path = image.resolve().parent / FRAMES
    if not path.is_file():
        return None
    frames = {entry["image"]: entry for entry in read_json(path)["frames"]}
    return frames.get(image.name)


def pose_errors(pose: Pose, known: dict[str, Any], corners: Floats, diameter: float) -> dict[str, float]:
    """How far a pose is from the truth ``known``: an entry of `FRAMES`.

    Args:
        pose: found.
        known: with ``R`` and ``t_mm``.
        corners: of the object's box, mm ``[8, 3]``.
        diameter: of the object, mm.
    """
    truth = Pose(np.array(known["R"], np.float64).reshape(3, 3), np.array(known["t_mm"], np.float64))
    r_est, t_est, r_gt, t_gt = pose.R[None], pose.t[None], truth.R[None], truth.t[None]
    return {
        "add_corners_d": float(add(r_est, t_est, r_gt, t_gt, corners)[0]) / diameter,
        "rotation_deg": float(re(r_est, r_gt)[0]),
        "translation_mm": float(te(t_est, t_gt)[0]),
        "distance_mm": float(np.linalg.norm(truth.t)),
    }
