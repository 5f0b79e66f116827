"""Trained quantised backbones as files: a plain state dict of `QuantDarkNet53`, steps included."""

from __future__ import annotations

import pickle
import tempfile
from pathlib import Path

import torch
from torch import Tensor

from macram.quant import QuantDarkNet53


def save_checkpoint(net: QuantDarkNet53, path: Path) -> None:
    """Writes the state dict; the file appears under its name only when it is complete.

    Raises:
        ValueError: the folder does not exist or cannot be written.
    """
    path = Path(path)
    try:
        with tempfile.TemporaryDirectory(dir=path.parent, prefix=f".{path.name}-") as folder:
            complete = Path(folder) / "checkpoint.pt"
            torch.save(net.state_dict(), complete)
            complete.replace(path)
    except OSError as error:
        raise ValueError(f"{path}: cannot be written, {error.strerror}; choose another path") from error


def load_checkpoint(net: QuantDarkNet53, path: Path) -> None:
    """Loads a state dict into ``net``, which is left in evaluation mode. Nothing in the file is executed.

    Raises:
        ValueError: the file is missing or no state dict, or a tensor is missing, unknown, of another shape,
            or not finite (only a step may be NaN: never set). ``net`` is then unchanged.
    """
    try:
        state = torch.load(path, map_location="cpu", weights_only=True)
    except FileNotFoundError as error:
        raise ValueError(f"{path}: no such checkpoint") from error
    except (OSError, RuntimeError, EOFError, KeyError, ValueError, pickle.UnpicklingError) as error:
        raise ValueError(
            f"{path}: is not a checkpoint; save one with macram.front.save_checkpoint"
        ) from error
    if not isinstance(state, dict) or not all(isinstance(value, Tensor) for value in state.values()):
        raise ValueError(f"{path}: must hold a dict of tensors; save one with macram.front.save_checkpoint")
    own = net.state_dict()
    for key in own:
        if key not in state:
            raise ValueError(
                f"{path}: tensor {key!r} is missing; save a QuantDarkNet53 of the same configuration"
            )
        if state[key].shape != own[key].shape:
            raise ValueError(
                f"{path}: tensor {key!r} must be {list(own[key].shape)}, not {list(state[key].shape)}"
            )
        if not bool(torch.isfinite(state[key]).all()) and not key.endswith("_quant.step"):
            raise ValueError(f"{path}: tensor {key!r} must be finite; the training has diverged")
    if unknown := sorted(set(map(str, state)) - set(own)):
        raise ValueError(f"{path}: tensor {unknown[0]!r} is unknown; save a QuantDarkNet53 and nothing else")
    net.load_state_dict(state)
    net.eval()
