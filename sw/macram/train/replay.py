"""Forward, losses and backward of a step recorded as a CUDA graph: one launch instead of some thousands.

A network of a hundred thin layers keeps a GPU busy for less time than the host needs to launch it. What a step
computes depends on the shapes of its batch alone (see `macram.train.objective`), so each kind of batch is
recorded once and then replayed on new values.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import torch
from torch import Tensor, nn

from macram.train.warp import Batch, Cells

PLAIN_STEPS = 3
"""Steps of each kind that run as they are, before one is recorded: libraries choose their kernels in them."""
Gradients = Callable[[Batch, Cells, int, bool], dict[str, Tensor]]


class Replay:
    """Gradients of steps on one GPU.

    Args:
        gradients: takes a batch, its cells, the number of images and whether the surface head counts; adds to the
            parameters' gradients and returns the losses by name. Must not look at values.
        parameters: that get gradients.
    """

    def __init__(self, gradients: Gradients, parameters: Sequence[nn.Parameter]) -> None:
        self.gradients, self.parameters = gradients, parameters
        self.stream = torch.cuda.Stream()  # type: ignore[no-untyped-call]
        self.pool = torch.cuda.graph_pool_handle()
        self.plain: Counter[Any] = Counter()
        self.taking_part: dict[Any, list[nn.Parameter]] = {}
        self.recorded: dict[Any, _Recorded] = {}
        self.buffers: dict[nn.Parameter, Tensor] = {}

    def __call__(self, batch: Batch, cells: Cells, images: int, surface: bool) -> dict[str, Tensor]:
        """The losses, detached; parameters that took part have their gradients, the others None."""
        key = (batch.image.shape, images, surface)
        if key not in self.recorded:
            if self.plain[key] < PLAIN_STEPS:
                self.plain[key] += 1
                losses = self._as_it_is(batch, cells, images, surface)
                self.taking_part[key] = [p for p in self.parameters if p.grad is not None]
                return losses
            self.recorded[key] = self._record(batch, cells, images, surface, self.taking_part[key])
        recorded = self.recorded[key]
        for place, value in zip(recorded.batch, batch, strict=True):
            if place is not None and value is not None:
                place.copy_(value)
        recorded.graph.replay()
        self._attach(self.taking_part[key])
        return dict(zip(recorded.names, recorded.losses.clone().unbind(), strict=True))

    def _as_it_is(self, batch: Batch, cells: Cells, images: int, surface: bool) -> dict[str, Tensor]:
        self._attach(())
        # On a stream of its own, as recording will be: gradients are added up on the stream of their first use.
        self.stream.wait_stream(torch.cuda.current_stream())
        with torch.cuda.stream(self.stream):
            losses = self.gradients(batch, cells, images, surface)
        torch.cuda.current_stream().wait_stream(self.stream)
        return losses

    def _record(
        self, batch: Batch, cells: Cells, images: int, surface: bool, taking_part: list[nn.Parameter]
    ) -> _Recorded:
        for parameter in taking_part:
            self.buffers.setdefault(parameter, torch.zeros_like(parameter))
        self._attach(taking_part)
        places = Batch._make(None if value is None else value.clone() for value in batch)
        graph = torch.cuda.CUDAGraph()
        with torch.cuda.graph(graph, pool=self.pool, stream=self.stream):
            torch._foreach_zero_([self.buffers[p] for p in taking_part])
            losses = self.gradients(places, cells, images, surface)
            stacked = torch.stack(list(losses.values()))
        return _Recorded(graph, places, tuple(losses), stacked)

    def _attach(self, taking_part: Sequence[nn.Parameter]) -> None:
        for parameter in self.parameters:
            parameter.grad = None
        for parameter in taking_part:
            parameter.grad = self.buffers[parameter]


class _Recorded(NamedTuple):
    """A graph and the tensors that it reads and writes."""

    graph: torch.cuda.CUDAGraph
    batch: Batch
    names: tuple[str, ...]
    losses: Tensor
