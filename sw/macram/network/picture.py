"""A picture through a trained network whose convolutions all run on the simulated array, and the pose it gives."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from macram.front.image import normalise
from macram.network.on_array import ArrayNetwork, differences
from macram.network.steps import needs_sums
from macram.pose import draw_pose
from macram.quant import DeployedNetwork, host_codes, lower_network
from macram.quant.network import QuantDarkNet53
from macram.spec import ArrayConfig
from macram.train.learned import picture_and_camera, pose_errors
from macram.train.predict import Predictor
from macram.train.samples import box_of


@dataclass(frozen=True, eq=False)
class PictureRun:
    """What came out.

    Attributes:
        rows: one per convolution, see `macram.network.on_array.differences`.
        report: camera, poses of the array and of the deployed network, errors where the truth is known; JSON types.
        picture: with the box and axes that the array's sums gave, RGB ``[H, W, 3]``.
    """

    rows: list[dict[str, Any]]
    report: dict[str, Any]
    picture: NDArray[np.uint8]

    @property
    def passed(self) -> bool:
        """No code differs, and the pose is the same to the last bit."""
        return self.report["same_pose"] and not any(row["mismatches"] for row in self.rows)


class PictureNetwork:
    """A picture in front of a network, lowered to integers.

    Attributes:
        program: the network's integers at this picture's size.
        image: name of the picture.
        array: of the convolutions: the one given, with partial sums where the network needs them.

    Args:
        image: PNG or JPEG.
        weights: of a network in mode III.
        array: to run it on; it gets partial sums where it has none and a convolution's output codes are not its own.
        focal: of the picture, pixels; None takes the camera beside the picture, else the training's.

    Raises:
        ValueError: an unreadable picture, or weights that are missing or not in mode III.
    """

    def __init__(self, image: Path, weights: Path, array: ArrayConfig, focal: float | None = None) -> None:
        self._predictor = Predictor.load(weights, integer=True)
        self._shown, self._camera, self._source, self._known = picture_and_camera(
            image, self._predictor.card, focal
        )
        self._fitted, _ = self._predictor.fit(self._shown, self._camera)
        height, width = self._fitted.shape[:2]
        self.program = lower_network(self._predictor.net, height, width)
        self.image = image.name
        self.array = array
        if needs_sums(self.program, array) and not array.partial_sum_c_in:
            self.array = dataclasses.replace(
                array, name=f"{array.name}-sums", partial_sum_c_in=array.max_c_in
            )

    def on_array(
        self, folder: Path, design: str, told: Callable[[int, float], None] | None = None
    ) -> tuple[ArrayNetwork, Callable[[], PictureRun]]:
        """The network on the array, not yet run, and what runs and judges it.

        Args:
            folder: where results are kept, see `ArrayNetwork`.
            design: `macram.synth.sources.design_hash` of `array`.
            told: as of `ArrayNetwork`.

        Raises:
            ValueError: a convolution that the array does not run.
        """
        network = ArrayNetwork(self.program, self.array, folder, design, told)
        return network, lambda: self._run(network)

    def _run(self, network: ArrayNetwork) -> PictureRun:
        predictor, card = self._predictor, self._predictor.card
        size = cast(tuple[int, int], self._fitted.shape[:2])
        predictor.deployed.pop(size, None)
        wanted = predictor.detect(self._shown, self._camera)
        codes = host_codes(cast(QuantDarkNet53, predictor.net.backbone), normalise(self._fitted))
        deployed = {name: codes.numpy() for name, codes in DeployedNetwork(self.program)(codes).items()}
        predictor.deployed[size] = network
        found = predictor.detect(self._shown, self._camera)
        corners, drawn = box_of(np.array(card.keypoints)), self._shown
        if found is not None:
            drawn = draw_pose(self._shown, found.pose, self._camera, corners, label=f"{found.score:.2f}")
        poses = [None if pose is None else pose.to_dict() for pose in (found, wanted)]
        report = {
            "image": self.image,
            "cam_K": self._camera.ravel().tolist(),
            "camera": self._source,
            "input": [*self.program.input_shape],
            "form": f"{card.bits} bit, mode {card.mode}, deployed integers",
            "pose": poses[0],
            "pose_deployed": poses[1],
            "same_pose": poses[0] == poses[1],
            "errors": pose_errors(found.pose, self._known, corners, card.diameter)
            if found is not None and self._known is not None
            else None,
        }
        return PictureRun(differences(network, deployed), report, drawn)
