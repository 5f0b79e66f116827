"""Element-wise functions of large tensors on a GPU, each compiled to one kernel.

Quantising a map in PyTorch's own operations reads and writes it a dozen times, which would take most of a step.
"""

from __future__ import annotations

import os
import sysconfig
from collections.abc import Callable
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from shutil import which
from typing import Any

import torch
from torch import Tensor

Function = Callable[..., tuple[Tensor, ...]]


@cache
def compiles_kernels() -> bool:
    """Whether kernels for a GPU can be made here: Triton, and the C compiler and Python's headers that it takes."""
    compilers = (os.environ.get("CC"), "gcc", "clang")
    headers = Path(sysconfig.get_path("include"), "Python.h").is_file()
    return find_spec("triton") is not None and headers and any(which(name) for name in compilers if name)


def has_one_pass(map_: Tensor) -> bool:
    """Whether `in_one_pass` serves maps like this one."""
    dense = map_.is_contiguous() or map_.is_contiguous(memory_format=torch.channels_last)
    return map_.is_cuda and map_.dim() == 4 and dense and compiles_kernels()


def in_one_pass(function: Function, maps: tuple[Tensor, ...], *others: Any) -> tuple[Tensor, ...]:
    """``function(*maps, *others)``, compiled.

    Division is a little less exact than PyTorch's: a value on the border between two codes may get the other.

    Args:
        function: element by element; at module level, as it is compiled once.
        maps: of one shape ``[N, C, H, W]``, the first of them dense; results have the shape and layout of it.
        others: scalars and tensors of one element.
    """
    like = maps[0]
    rows = [_row(m if m.stride() == like.stride() else torch.empty_like(like).copy_(m)) for m in maps]
    return tuple(row.as_strided(like.shape, like.stride()) for row in _compiled(function)(*rows, *others))


def _row(map_: Tensor) -> Tensor:
    """All elements in one row, as memory holds them: then one kernel serves every layer.

    Not known as a view to PyTorch, which would look at the shape behind it and compile for that.
    """
    count = (map_.numel(),)
    row: Tensor = torch.ops.aten._unsafe_view(map_.as_strided(count, (1,)), count)
    return row


@cache
def _compiled(function: Function) -> Function:
    return torch.compile(function, dynamic=True)
