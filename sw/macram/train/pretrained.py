"""Weights of a backbone alone, trained elsewhere: this project's tensor names, or pytorchcv's for DarkNet-53."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

import torch
from safetensors import SafetensorError
from safetensors.torch import load_file
from torch import Tensor

from macram.model import SpaceNet
from macram.train.checkpoint import load_state

# Stage k of pytorchcv: unit1 halves the picture, every further unit is a residual one of two convolutions.
FOREIGN = re.compile(
    r"(?:init_block|stage(?P<stage>[1-9]\d*)\.unit(?P<unit>[1-9]\d*)(?:\.conv(?P<conv>[12]))?)"
    r"\.(?P<tensor>(?:conv|bn)\.\w+)"
)
CLASSIFIER = "output."
PARTS = {"1": "reduce", "2": "expand"}
COUNTER = "num_batches_tracked"


def load_backbone(net: SpaceNet, path: Path) -> None:
    """Loads the backbone of ``net`` from a ``.safetensors`` file or a PyTorch state dict (any other ending).

    The names are those of `DarkNet53`, with or without ``backbone.``, or pytorchcv's
    (``features.stage1.unit1.conv.weight``), whose classifier is left out. Counters of batches, which files of
    old PyTorch versions do not have, may be absent.

    Raises:
        ValueError: missing, unreadable, or of another backbone; ``net`` is then unchanged.
    """
    tensors = renamed(_read(path), path)
    for name, value in net.backbone.state_dict().items():
        if name.endswith(COUNTER):
            tensors.setdefault(name, value)
    load_state(net.backbone, tensors, path)


def renamed(tensors: Mapping[str, Tensor], path: Path) -> dict[str, Tensor]:
    """Tensors under the names of `DarkNet53`.

    Args:
        tensors: by this project's names, which stay, or by pytorchcv's.
        path: for messages.

    Raises:
        ValueError: a name of neither kind among pytorchcv's.
    """
    if not any(name.startswith("features.") for name in tensors):
        return {name.removeprefix("backbone."): value for name, value in tensors.items()}
    return {
        _own_name(name, path): value for name, value in tensors.items() if not name.startswith(CLASSIFIER)
    }


def _own_name(name: str, path: Path) -> str:
    match = FOREIGN.fullmatch(name.removeprefix("features."))
    residual = match is not None and match["unit"] not in (None, "1")
    if match is None or residual != (match["conv"] is not None):
        raise ValueError(f"{path}: tensor {name!r} is unknown; the file is of another network")
    if match["stage"] is None:
        return f"init.{match['tensor']}"
    stage = f"stages.{int(match['stage']) - 1}"
    if not residual:
        return f"{stage}.entry.{match['tensor']}"
    return f"{stage}.units.{int(match['unit']) - 2}.{PARTS[match['conv']]}.{match['tensor']}"


def _read(path: Path) -> dict[str, Tensor]:
    if not path.is_file():
        raise ValueError(
            f"{path}: no such file of backbone weights; put pytorchcv's darknet53 there, name another file with "
            "--set run.backbone=FILE, or begin from random weights with --set run.backbone="
        )
    if path.suffix == ".safetensors":
        try:
            return load_file(path)
        except (SafetensorError, OSError) as error:
            raise ValueError(f"{path}: not a safetensors file ({error}); it may be cut off") from None
    try:
        table = torch.load(path, map_location="cpu", weights_only=True)
    except Exception as error:  # on rubbish the unpickler raises whatever it stumbles over
        reason = str(error).partition("\n")[0]
        raise ValueError(f"{path}: not a PyTorch state dict ({reason}); it may be cut off") from None
    if not isinstance(table, dict) or not all(isinstance(value, Tensor) for value in table.values()):
        raise ValueError(f"{path}: not a state dict; it must hold tensors by name and nothing else")
    return table
