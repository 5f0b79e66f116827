"""The reference layer with the codes of a real image: what the array is asked to compute.

The layer is the first 3x3 convolution of DarkNet-53's second stage, input 64x128x128, kernel 128x64x3x3. Its
input codes are the deployed network's own: the image passes the first convolution in float32 and everything
after it as integers.
"""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

import numpy as np
import torch
from numpy.typing import NDArray

from macram.front.checkpoint import load_checkpoint
from macram.front.image import IMAGE_SIZE, normalise, read_image
from macram.layer_file import LayerCase
from macram.model import BackboneConfig, DarkNet53
from macram.quant import (
    DeployedNetwork,
    Precision,
    QuantDarkNet53,
    calibrate_batch_norm,
    calibrate_steps,
    differing_shares,
    host_codes,
    lower,
    training_codes,
)
from macram.quant.network import QuantStage, QuantUnit

REFERENCE_LAYER = "stage2.unit1.expand"
STAGES = 2
"""Stages that have to run to reach the reference layer."""


@dataclass(frozen=True, eq=False, slots=True)
class FrontResult:
    """The reference layer of one image.

    Attributes:
        case: codes, weights and requantisation of the layer; the output is in the 3-bit codes of the residual
            branch, the layer's successor.
        deployed_codes: the PyTorch deployed network's output of the layer, int64 ``[128, 128, 128]``.
        differing: share of codes, 0 to 1, in which the float32 training graph differs from the deployed
            network, by tensor name, from the image to the layer's output.
        picture: what the network saw, RGB ``[512, 512, 3]``.
        provenance: where weights, steps and image come from; JSON types only.
    """

    case: LayerCase
    deployed_codes: NDArray[np.int64]
    differing: dict[str, float]
    picture: NDArray[np.uint8]
    provenance: dict[str, Any]


def reference_case(
    image: Path,
    *,
    checkpoint: Path | None = None,
    seed: int = 2022,
    calibration: Sequence[Path] = (),
    network: tuple[QuantDarkNet53, dict[str, Any]] | None = None,
) -> FrontResult:
    """Takes an image through the deployed network to the reference layer.

    Args:
        image: PNG or JPEG; scaled to 512 x 512, a picture that is not square is centred on black.
        checkpoint: as for `prepare_network`.
        seed: as for `prepare_network`.
        calibration: as for `prepare_network`; ``image`` itself if empty.
        network: one that is ready, as `prepare_network` returns it, in place of these three.

    Raises:
        ValueError: an image or the checkpoint is missing or unfit.
    """
    picture = read_image(image)
    net, provenance = network or prepare_network(
        checkpoint=checkpoint, seed=seed, calibration=calibration or [image]
    )
    tensor = normalise(picture)
    program = lower(net, IMAGE_SIZE, IMAGE_SIZE, last=REFERENCE_LAYER)
    tensors = DeployedNetwork(program)(host_codes(net, tensor))
    deployed = {name: codes.numpy() for name, codes in tensors.items()}
    layer = program.conv(REFERENCE_LAYER)
    return FrontResult(
        case=LayerCase(layer.spec, layer.weights, deployed[layer.source], layer.scale, layer.offset),
        deployed_codes=deployed[REFERENCE_LAYER],
        differing=differing_shares(training_codes(net, tensor, program, STAGES), deployed),
        picture=picture,
        provenance={
            "image": Path(image).name,
            "image_sha256": _sha256(image),
            "layer": REFERENCE_LAYER,
            "steps": _reference_steps(net),
            **provenance,
        },
    )


def prepare_network(
    *, checkpoint: Path | None = None, seed: int = 2022, calibration: Sequence[Path] = ()
) -> tuple[QuantDarkNet53, dict[str, Any]]:
    """The full 3-bit backbone, from a checkpoint, or seeded and calibrated as far as the reference layer.

    Args:
        checkpoint: trained `QuantDarkNet53` (see `macram.front.save_checkpoint`).
        seed: of the initial weights, when there is no checkpoint. The global random state is not touched.
        calibration: images for batch-normalisation statistics and steps, when there is no checkpoint.

    Returns:
        The network in evaluation mode, and its provenance as JSON types.

    Raises:
        ValueError: an image or the checkpoint is missing or unfit, or there is neither.
    """
    model = DarkNet53(BackboneConfig(), torch.Generator().manual_seed(seed))
    if checkpoint is not None:
        net = QuantDarkNet53(model, Precision())
        load_checkpoint(net, checkpoint)
        name = Path(checkpoint).name
        return net, {"weights": f"checkpoint {name}", "checkpoint_sha256": _sha256(checkpoint)}
    if not calibration:
        raise ValueError("a network without a checkpoint needs at least one calibration image")
    images = torch.stack([normalise(read_image(path)) for path in calibration])
    calibrate_batch_norm(model, images, STAGES)
    net = QuantDarkNet53(model, Precision())
    calibrate_steps(net, images, STAGES)
    names = ", ".join(Path(path).name for path in calibration)
    return net, {
        "weights": f"seeded initialisation (seed {seed}), LSQ calibration on {names}; not trained",
        "seed": seed,
        "calibration_sha256": {Path(path).name: _sha256(path) for path in calibration},
    }


def _reference_steps(net: QuantDarkNet53) -> dict[str, float]:
    stage = cast(QuantStage, net.stages[1])
    unit = cast(QuantUnit, stage.units[0])
    quantizers = {
        "weight": unit.expand.weight_quant,
        "input": unit.expand.input_quant,
        "output": unit.branch_quant,
        "residual_stream": stage.stream_quant,
    }
    return {name: quantizer.positive_step.item() for name, quantizer in quantizers.items()}


def _sha256(path: Path) -> str:
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()
