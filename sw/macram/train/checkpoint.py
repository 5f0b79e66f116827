"""Checkpoints in safetensors: tensors by name, everything else as JSON in the header; nothing is executed.

``model.safetensors`` holds a network to use. ``last.safetensors`` holds all that a run needs to go on.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

import torch
from safetensors import SafetensorError, safe_open
from safetensors.torch import save
from torch import Tensor

from macram.model import SpaceNet, SpaceNetConfig
from macram.model.counts import MODES
from macram.model.spacenet import SURFACE
from macram.quant import Precision, quantise
from macram.report.files import write_bytes
from macram.spec import IntFormat
from macram.train.packed import PACKED, pack_tensors, unpack_tensors

HEADER = "macram"
FORMAT = 1
STREAM_BITS = 8
"""Residual streams and pyramid sums keep 8 bits, whatever the convolutions have."""


@dataclass(frozen=True, slots=True)
class Card:
    """What a network file says about itself.

    Attributes:
        network: its configuration.
        keypoints: ``[K][3]`` mm, in the order the network predicts.
        diameter: of the object, mm.
        target: name of the object.
        is_box: whether the keypoints are box corners.
        focal: focal length, pixels, of the pictures it was trained on.
        mode: quantised parts, I, II or III; empty for a float network.
        bits: of weights and activations; 32 for a float network.
        history: every stage so far: stage, seed, steps, visits, data, and the command's configuration.
    """

    network: SpaceNetConfig
    keypoints: tuple[tuple[float, ...], ...]
    diameter: float
    target: str
    is_box: bool
    focal: float
    mode: str = ""
    bits: int = 32
    history: tuple[dict[str, Any], ...] = ()

    def to_dict(self) -> dict[str, Any]:
        """JSON types; `from_dict` takes it back."""
        return {**asdict(self), "network": self.network.to_dict()}

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> Card:
        """Inverse of `to_dict`.

        Raises:
            ValueError: a field is missing or wrong.
        """
        try:
            fields = dict(values)
            fields["network"] = SpaceNetConfig.from_dict(fields["network"])
            fields["keypoints"] = tuple(tuple(map(float, point)) for point in fields["keypoints"])
            fields["history"] = tuple(fields["history"])
            return cls(**fields)
        except (KeyError, TypeError) as error:
            raise ValueError(f"not the description of a network ({error})") from None

    @property
    def precision(self) -> Precision:
        """Formats of a quantised network."""
        return Precision(IntFormat(self.bits, signed=True), IntFormat(self.bits), IntFormat(STREAM_BITS))


def write_tensors(path: Path, tensors: Mapping[str, Tensor], header: Mapping[str, Any]) -> None:
    """Replaces ``path`` in one step.

    Raises:
        OSError: the folder is missing or not writable.
    """
    # Copies: safetensors refuses tensors that share memory, as the pyramids' tops may.
    plain = {name: value.detach().cpu().contiguous().clone() for name, value in tensors.items()}
    write_bytes(path, save(plain, {HEADER: json.dumps({"format": FORMAT, **header})}))


def read_tensors(path: Path) -> tuple[dict[str, Tensor], dict[str, Any]]:
    """Tensors (on the CPU) and header of a file of `write_tensors`.

    Raises:
        ValueError: missing, cut off, or of another kind; one line that names it.
    """
    try:
        with safe_open(path, framework="pt", device="cpu") as file:
            header = (file.metadata() or {}).get(HEADER)
            tensors = {name: file.get_tensor(name) for name in file.keys()}  # noqa: SIM118
    except FileNotFoundError:
        raise ValueError(f"{path}: no such checkpoint") from None
    except (SafetensorError, OSError) as error:
        raise ValueError(f"{path}: not a safetensors file ({error}); it may be cut off") from None
    if header is None:
        raise ValueError(f"{path}: carries no description; give a file that `macram train` wrote")
    table = json.loads(header)
    if table.get("format") != FORMAT:
        raise ValueError(f"{path}: has format {table.get('format')}, this version reads {FORMAT}")
    return tensors, table


def save_model(path: Path, net: SpaceNet, card: Card) -> None:
    """Writes a network to use, without its training-only surface head."""
    state = {name: value for name, value in net.state_dict().items() if not name.startswith(SURFACE)}
    card = replace(card, network=replace(net.config, surface=False))
    write_tensors(path, state, {"card": card.to_dict()})


def save_packed(path: Path, net: SpaceNet, card: Card) -> None:
    """Writes a network as small as it goes, see `macram.train.packed`; `load_model` reads it.

    Raises:
        ValueError: a weight step was never set or differs by channel.
    """
    tensors, packed = pack_tensors(net)
    tensors = {name: value for name, value in tensors.items() if not name.startswith(SURFACE)}
    card = replace(card, network=replace(net.config, surface=False))
    write_tensors(path, tensors, {"card": card.to_dict(), PACKED: packed})


def load_model(path: Path) -> tuple[SpaceNet, Card]:
    """A network in evaluation mode, float or quantised as its card says, from a plain or a packed file.

    Raises:
        ValueError: not such a file, or its tensors do not fit its card.
    """
    tensors, header = read_tensors(path)
    if "card" not in header:
        raise ValueError(f"{path}: is no network; give the run's model.safetensors")
    card = Card.from_dict(header["card"])
    net = build(card)
    load_state(net, unpack_tensors(tensors, header.get(PACKED, {}), path), path)
    return net.eval(), card


def build(card: Card) -> SpaceNet:
    """The network of a card, with weights yet to be loaded."""
    net = SpaceNet(card.network, torch.Generator().manual_seed(0))
    if card.mode:
        if card.mode not in MODES:
            raise ValueError(f"mode must be one of {', '.join(MODES)}, not {card.mode!r}")
        net = quantise(net, card.mode, card.precision)
    return net


def load_state(net: torch.nn.Module, tensors: Mapping[str, Tensor], path: Path) -> None:
    """Loads all of ``net``; only a surface head may be absent on either side.

    Raises:
        ValueError: a tensor is missing, unknown or of another shape; ``net`` is then unchanged.
    """
    own = net.state_dict()
    for name in own:
        if name not in tensors and not name.startswith(SURFACE):
            raise ValueError(f"{path}: tensor {name!r} is missing; the file is of another network")
        if name in tensors and tensors[name].shape != own[name].shape:
            shapes = f"{list(own[name].shape)}, not {list(tensors[name].shape)}"
            raise ValueError(f"{path}: tensor {name!r} must be {shapes}; the file is of another network")
    if unknown := [name for name in tensors if name not in own and not name.startswith(SURFACE)]:
        raise ValueError(f"{path}: tensor {unknown[0]!r} is unknown; the file is of another network")
    net.load_state_dict({name: value for name, value in tensors.items() if name in own}, strict=False)


def optimiser_tensors(optimiser: torch.optim.Optimizer, names: Mapping[Tensor, str]) -> dict[str, Tensor]:
    """The optimiser's memory by ``parameter/slot``."""
    return {
        f"{names[parameter]}/{slot}": value
        for parameter, slots in optimiser.state.items()
        for slot, value in slots.items()
        if isinstance(value, Tensor)
    }


def restore_optimiser(
    optimiser: torch.optim.Optimizer, names: Mapping[Tensor, str], tensors: Mapping[str, Tensor]
) -> None:
    """Inverse of `optimiser_tensors`; learning rates and the like stay as they are."""
    parameters = {name: parameter for parameter, name in names.items()}
    by_name: dict[str, dict[str, Tensor]] = {}
    for name, value in tensors.items():
        parameter, _, slot = name.rpartition("/")
        by_name.setdefault(parameter, {})[slot] = _laid_out_as(parameters.get(parameter), value)
    order = [names[p] for group in optimiser.param_groups for p in group["params"]]
    state = optimiser.state_dict()
    state["state"] = {i: by_name[name] for i, name in enumerate(order) if name in by_name}
    optimiser.load_state_dict(state)


def _laid_out_as(parameter: Tensor | None, value: Tensor) -> Tensor:
    """``value`` with the strides of ``parameter``: files hold rows, and fused optimisers go through both alike."""
    if parameter is None or parameter.shape != value.shape:
        return value
    return torch.empty_like(parameter, dtype=value.dtype, device=value.device).copy_(value)
