"""From pictures to poses with a trained network: float, quantised, or as the integers that get deployed."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Protocol, Self, cast

import cv2
import numpy as np
import torch
from numpy.typing import ArrayLike, NDArray
from torch import Tensor

from macram.data.frame import Frame
from macram.front.image import normalise
from macram.model import Prediction, SpaceNet
from macram.pose import (
    Detection,
    Evaluation,
    GroundTruth,
    LevelCells,
    Pose,
    PoseSettings,
    decode,
    detect_again,
    evaluate,
    refine_on_edges,
)
from macram.pose.metrics import sample_vertices
from macram.pose.rigid import Floats, camera_matrix
from macram.quant import DeployedNetwork, host_codes, host_predictions, layer_differences, lower_network
from macram.quant.network import QuantDarkNet53
from macram.quant.program import Program
from macram.train.checkpoint import Card, load_model

Image = NDArray[np.uint8]
MULTIPLE = 32
BORDER = 128
BATCH = 16
VERTEX_SEED = 0


class Deployed(Protocol):
    """What runs an integer program: a `DeployedNetwork`, or hardware."""

    program: Program

    def accumulators(self, codes: Tensor) -> dict[str, Tensor]:
        """``[C, H, W]`` codes of the program's input -> the sums that the host needs."""
        ...


class Predictor:
    """A network with all that turns its outputs into poses.

    Attributes:
        card: what the network is about.
        deployed: what runs the integer program, by size of the picture; a `DeployedNetwork` where nothing is set.

    Args:
        net: in evaluation mode.
        card: of ``net``.
        device: to run on.
        integer: run the integer program instead of the training graph, one picture at a time, on the CPU.
        settings: how its outputs become a pose.

    Raises:
        ValueError: ``integer`` with a network that has no integer form, or edges of a target that is no box.
    """

    def __init__(
        self,
        net: SpaceNet,
        card: Card,
        device: torch.device | None = None,
        *,
        integer: bool = False,
        settings: PoseSettings | None = None,
    ) -> None:
        if integer and card.mode != "III":
            raise ValueError(
                "only a network quantised in mode III runs as integers, as the shipped quarter-w3a3 and quarter-w8a8 do"
            )
        self.device = torch.device("cpu") if integer or device is None else device
        self.net = net.to(self.device)
        self.card, self.integer, self.settings = card, integer, settings or PoseSettings()
        if self.settings.edges is not None and not card.is_box:
            raise ValueError(
                f"{card.target}: its keypoints are no box, so its edges are not known; leave --edges away"
            )
        self.keypoints = np.array(card.keypoints)
        self.deployed: dict[tuple[int, int], Deployed] = {}

    @classmethod
    def load(
        cls,
        path: Path,
        device: torch.device | None = None,
        *,
        integer: bool = False,
        settings: PoseSettings | None = None,
    ) -> Self:
        """From a run's ``model.safetensors``.

        Raises:
            ValueError: not such a file, or see the class.
        """
        net, card = load_model(path)
        return cls(net, card, device, integer=integer, settings=settings)

    def detect(self, image: Image, K: ArrayLike) -> Detection | None:
        """The pose of the object in an RGB picture ``[H, W, 3]`` with intrinsics ``K``, or None."""
        return next(self.detections([(image, camera_matrix(K))]))

    def detections(self, pictures: Sequence[tuple[Image, Floats]]) -> Iterator[Detection | None]:
        """`detect` for several; neighbours of one size run through the network together."""
        inputs = [self.fit(image, camera) for image, camera in pictures]
        start = 0
        while start < len(inputs):
            shape = inputs[start][0].shape
            stop = start + 1
            while stop < min(len(inputs), start + BATCH) and inputs[stop][0].shape == shape:
                stop += 1
            levels = self.levels([image for image, _ in inputs[start:stop]])
            for n, cells in enumerate(levels, start):
                yield self._detection(cells, inputs[n], pictures[n])
            start = stop

    def _detection(
        self, cells: list[LevelCells], fitted: tuple[Image, Floats], picture: tuple[Image, Floats]
    ) -> Detection | None:
        """Pose from the outputs for a picture as ``fitted`` to the network."""
        image, camera = fitted
        anchors = self.card.network.levels.anchors
        found = detect_again(image, cells, anchors, self.keypoints, camera, self.levels, self.settings)
        if found is None or self.settings.edges is None:
            return found
        pose = refine_on_edges(picture[0], found.pose, picture[1], self.keypoints, self.settings.edges)
        return replace(found, pose=pose)

    def fit(self, image: Image, camera: Floats) -> tuple[Image, Floats]:
        """A picture at the focal length of the training, sides multiples of 32, and its intrinsics."""
        scale = self.card.focal / camera[0, 0]
        height, width = image.shape[:2]
        if abs(scale - 1) > 1e-3:
            size = max(1, round(width * scale)), max(1, round(height * scale))
            how = cv2.INTER_AREA if scale < 1 else cv2.INTER_LINEAR
            image = np.asarray(cv2.resize(image, size, interpolation=how), np.uint8)
            camera = np.diag([size[0] / width, size[1] / height, 1.0]) @ camera
        below, right = -image.shape[0] % MULTIPLE, -image.shape[1] % MULTIPLE
        if below or right:
            image = np.pad(image, ((0, below), (0, right), (0, 0)), constant_values=BORDER)
        return image, camera

    def levels(self, images: Sequence[Image]) -> list[list[LevelCells]]:
        """Decoded cells of every level of every picture; all ``[H, W, 3]`` of one size."""
        tensor = torch.stack([normalise(image) for image in images])
        network = self.card.network
        with torch.no_grad(), torch.backends.cudnn.flags(allow_tf32=False):
            if self.integer:
                predictions = [self._deployed(picture) for picture in tensor]
                maps = [Prediction(*(torch.cat(p) for p in zip(*((m.logits, m.offsets) for m in level), strict=True)))
                        for level in zip(*predictions, strict=True)]  # fmt: skip
            else:
                tensor = tensor.to(self.device, memory_format=torch.channels_last)
                maps = list(self.net(tensor))
        outputs = [(m.logits.float().cpu().numpy(), m.offsets.float().cpu().numpy()) for m in maps]
        shapes = list(zip(network.levels.strides, network.levels.anchors, strict=True))
        return [
            [
                decode(logits[n], offsets[n], stride, anchor)
                for (logits, offsets), (stride, anchor) in zip(outputs, shapes, strict=True)
            ]
            for n in range(len(images))
        ]

    def _deployed(self, picture: Tensor) -> tuple[Prediction, ...]:
        size = int(picture.shape[1]), int(picture.shape[2])
        if size not in self.deployed:
            self.deployed[size] = DeployedNetwork(lower_network(self.net, *size))
        deployed = self.deployed[size]
        codes = host_codes(cast(QuantDarkNet53, self.net.backbone), picture)
        return host_predictions(deployed.program, deployed.accumulators(codes))


def compare_frames(predictor: Predictor, frames: Sequence[Frame]) -> list[dict[str, Any]]:
    """Training graph against deployed integers on pictures of a data set, layer by layer.

    Args:
        predictor: of a network quantised in mode III.
        frames: pictures of one size.

    Returns:
        Rows of `macram.quant.layer_differences`.

    Raises:
        ValueError: the network has no integer form, or a bad file.
    """
    pictures = [normalise(predictor.fit(frame.read_image(), frame.camera)[0]) for frame in frames]
    return layer_differences(predictor.net.cpu(), [p for p in pictures if p.shape == pictures[0].shape])


def evaluate_frames(
    predictor: Predictor, frames: Sequence[Frame], told: Callable[[int, int], None] | None = None
) -> tuple[Evaluation, list[Detection | None]]:
    """Poses of a data set's frames against the truth.

    Args:
        predictor: with a network of the same object.
        frames: of one object.
        told: called with the number of frames done and their total.

    Returns:
        The evaluation, and what was detected in each frame.

    Raises:
        ValueError: no frames, a bad file, or another number of keypoints than the network's.
    """
    if not frames:
        raise ValueError("no frames to evaluate")
    model = frames[0].model
    if model.keypoints.shape != predictor.keypoints.shape:
        raise ValueError(
            f"the network predicts {len(predictor.keypoints)} keypoints, {model.name} has {len(model.keypoints)}"
        )
    found: list[Detection | None] = []
    for start in range(0, len(frames), BATCH):
        part = frames[start : start + BATCH]
        found += predictor.detections([(frame.read_image(), frame.camera) for frame in part])
        if told is not None:
            told(len(found), len(frames))
    return evaluate_found(frames, found), found


def evaluate_found(frames: Sequence[Frame], found: Sequence[Detection | None]) -> Evaluation:
    """What was detected in ``frames``, all of one object, against the truth."""
    model = frames[0].model
    truths = [GroundTruth(f.name, Pose(f.rotation, f.translation), f.camera) for f in frames]
    poses = {f.name: None if d is None else d.pose for f, d in zip(frames, found, strict=True)}
    vertices = sample_vertices(model.vertices, seed=VERTEX_SEED)
    return evaluate(poses, truths, vertices=vertices, diameter=model.diameter)
