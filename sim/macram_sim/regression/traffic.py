"""The streams of a case, each with its own pattern of idle cycles."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Collection
from typing import Any

from macram.driver import Beats
from macram_sim.regression.plan import Case
from macram_sim.streams import AxisSink, AxisSource, pauses
from macram_sim.transport import CocotbTransport

PORTS = {
    "image": "s_axis",
    "params": "s_axis_param",
    "residual": "s_axis_residual",
    "output": "m_axis",
    "residual sums": "m_axis_residual",
}
"""Port of every stream. ``params`` carries partial sums in, ``output`` carries them out."""


class CaseTransport(CocotbTransport):
    """`CocotbTransport` whose streams have patterns of their own, and can be moved one by one.

    Attributes:
        sources: ``image``, ``params`` and, where the array has it, ``residual``.
        sinks: ``output`` and, where the array has it, ``residual sums``.
    """

    def __init__(self, dut: Any, case: Case) -> None:
        traffic, seed = case.traffic, case.seed
        super().__init__(dut, gaps=traffic.image, stalls=traffic.output, seed=seed)
        self._params = AxisSource(dut, "s_axis_param", pauses(traffic.params, random.Random(f"param {seed}")))
        self.sources, self.sinks = {"image": self._image, "params": self._params}, {"output": self._output}
        if hasattr(dut, "s_axis_residual_tdata"):
            self._residual = AxisSource(
                dut, "s_axis_residual", pauses(traffic.residual, random.Random(f"residual {seed}"))
            )
            self._sums = AxisSink(
                dut, "m_axis_residual", pauses(traffic.residual_sums, random.Random(f"sums {seed}"))
            )
            self.sources["residual"], self.sinks["residual sums"] = self._residual, self._sums
        self._streams = [*self.sources.values(), *self.sinks.values()]

    def line(self, name: str, signal: str) -> Any:
        """A signal of a stream, such as ``tready``."""
        return getattr(self._dut, f"{PORTS[name]}_{signal}")

    @property
    def moved(self) -> Counter[str]:
        """Beats moved so far on every stream."""
        return Counter({name: stream.moved for name, stream in (self.sources | self.sinks).items()})

    async def send(self, name: str, beats: Beats, lasts: Collection[int] | None = None) -> None:
        """Send beats on a source, TLAST where ``lasts`` says, by default on the last."""
        if len(beats):
            await self.sources[name].send(beats, lasts)

    async def receive(self, name: str, count: int) -> Beats:
        """Take beats from a sink, the last of which must have TLAST."""
        return await self.sinks[name].receive(count)
