"""Operations and storage of a network, counted on its instantiated modules: the paper's tables IV and V.

One operation is one multiply-accumulate of a convolution, for one image; bias, normalisation, activation,
up-sampling and sums do not count. Both pyramids count, each with every run of its top, and the head on all
five levels; the counterfactual path of the training does not. A parameter is a trained value, counted once
even if two modules share it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import torch
from torch import Tensor, nn

from macram.model.anchors import map_sizes
from macram.model.config import SpaceNetConfig
from macram.model.spacenet import SpaceNet

GIGA = 10**9
MEBI = 2**20
PARTS = ("first", "backbone", "pyramids", "head")
MODES = ("I", "II", "III")
"""What is quantised: the backbone but for its first convolution; the pyramids too; the head too."""
WIDTHS = (32, 8, 3)
"""Bits per parameter of table V."""


@dataclass(frozen=True, slots=True)
class ConvRun:
    """One run of a convolution; padding is ``kernel // 2``.

    Attributes:
        name: in `SpaceNet`. part: one of `PARTS`.
        c_in, c_out: channels.
        height, width: of the input.
        kernel, stride: of both directions.
        macs: multiply-accumulates, padding included.
    """

    name: str
    part: str
    c_in: int
    c_out: int
    height: int
    width: int
    kernel: int
    stride: int
    macs: int


@dataclass(frozen=True, slots=True)
class ConvCount:
    """One convolution.

    Attributes:
        name: in `SpaceNet`.
        part: one of `PARTS`.
        weights: without bias.
        macs: multiply-accumulates over all its runs, one image.
        runs: per image.
    """

    name: str
    part: str
    weights: int
    macs: int
    runs: int


@dataclass(frozen=True)
class NetworkCounts:
    """Everything counted of one network.

    Attributes:
        convs: every convolution, in order of their first runs.
        parameters: trained values.
        cells: of all levels together.
    """

    convs: tuple[ConvCount, ...]
    parameters: int
    cells: int

    def macs(self, *parts: str) -> int:
        """Multiply-accumulates of some of `PARTS`; of all of them without arguments."""
        return sum(conv.macs for conv in self.convs if conv.part in (parts or PARTS))

    def quantised_macs(self, mode: str) -> int:
        """Multiply-accumulates on quantised operands in a mode."""
        return self.macs(*quantised_parts(mode))

    @cached_property
    def operations(self) -> tuple[dict[str, Any], ...]:
        """Table IV's rows: mode, printed figures and exact integers."""
        total = _round(self.macs(), GIGA)
        rows = []
        for mode in MODES:
            exact = self.quantised_macs(mode)
            # The paper rounds first and calculates then; 26.19 and 99.67 come out no other way.
            low = _round(exact, GIGA)
            rows.append(
                {
                    "mode": mode,
                    "quantised_g": low,
                    "remaining_g": round(total - low, 2),
                    "share_percent": round(100 * low / total, 2),
                    "quantised_macs": exact,
                    "remaining_macs": self.macs() - exact,
                }
            )
        return tuple(rows)

    @cached_property
    def storage(self) -> tuple[dict[str, Any], ...]:
        """Table V's rows: bits, printed figures in binary millions, exact integers."""
        rows = []
        full = _round(self.parameters * WIDTHS[0], 8 * MEBI)
        for bits in WIDTHS:
            size = _round(self.parameters * bits, 8 * MEBI)
            rows.append(
                {
                    "bits": bits,
                    "parameters_m": _round(self.parameters, MEBI),
                    "size_mb": size,
                    "saving_percent": round(100 * (1 - size / full), 2),
                    "parameters": self.parameters,
                    "size_bits": self.parameters * bits,
                }
            )
        return tuple(rows)

    def to_dict(self) -> dict[str, Any]:
        """JSON types: tables with exact integers, totals by part, and every convolution."""
        return {
            "parameters": self.parameters,
            "macs": {"total": self.macs(), **{part: self.macs(part) for part in PARTS}},
            "conv_modules": len(self.convs),
            "conv_runs": sum(conv.runs for conv in self.convs),
            "cells": self.cells,
            "table_iv": list(self.operations),
            "table_v": list(self.storage),
            "convs": [
                {"name": c.name, "part": c.part, "weights": c.weights, "macs": c.macs, "runs": c.runs}
                for c in self.convs
            ],
        }


def quantised_parts(mode: str) -> tuple[str, ...]:
    """The `PARTS` whose convolutions are quantised in a mode.

    Raises:
        ValueError: ``mode`` is none of `MODES`.
    """
    if mode not in MODES:
        raise ValueError(f"mode must be one of {', '.join(MODES)}, not {mode!r}")
    return PARTS[1 : 2 + MODES.index(mode)]


def part_of(name: str) -> str:
    """The one of `PARTS` that a convolution of `SpaceNet` belongs to, by its name there."""
    if name.startswith("backbone.init."):
        return "first"
    return {"backbone": "backbone", "head": "head"}.get(name.partition(".")[0], "pyramids")


def conv_runs(config: SpaceNetConfig) -> tuple[ConvRun, ...]:
    """Every run of a convolution for one image, in order. Shapes only: nothing is stored or multiplied."""
    return _trace(config)[1]


def count_network(config: SpaceNetConfig) -> NetworkCounts:
    """Counts a network at its image size. Shapes only: no weight is stored, nothing is multiplied."""
    model, runs = _trace(config)
    names = list(dict.fromkeys(run.name for run in runs))
    modules = dict(model.named_modules())
    convs = []
    for name in names:
        macs = [run.macs for run in runs if run.name == name]
        convs.append(ConvCount(name, part_of(name), _weights(modules[name]), sum(macs), len(macs)))
    side = config.image_size
    cells = sum(rows * columns for rows, columns in map_sizes(side, side))
    return NetworkCounts(tuple(convs), sum(p.numel() for p in model.parameters()), cells)


def _trace(config: SpaceNetConfig) -> tuple[SpaceNet, tuple[ConvRun, ...]]:
    with torch.device("meta"):
        model = SpaceNet(config, torch.Generator("cpu")).eval()
    runs: list[ConvRun] = []

    def hook(name: str, module: nn.Conv2d) -> None:
        def record(_module: nn.Module, args: Sequence[Tensor], output: Tensor) -> None:
            height, width = args[0].shape[-2:]
            shape = module.in_channels, module.out_channels, height, width
            kernel, stride = module.kernel_size[0], module.stride[0]
            macs = output[0].numel() * module.weight[0].numel()
            runs.append(ConvRun(name, part_of(name), *shape, kernel, stride, macs))

        module.register_forward_hook(record)

    for name, module in model.named_modules():
        if isinstance(module, nn.Conv2d):
            hook(name, module)
    side = config.image_size
    with torch.no_grad():
        model(torch.empty(1, 3, side, side, device="meta"))
    return model, tuple(runs)


def _weights(module: nn.Module) -> int:
    assert isinstance(module, nn.Conv2d)
    return module.weight.numel()


def _round(value: int, unit: int) -> float:
    """``value / unit`` to two decimals."""
    return round(value / unit, 2)
