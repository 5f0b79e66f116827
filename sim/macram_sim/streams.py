"""Lean AXI4-Stream source and sink for cocotb: a few microseconds of Python per cycle.

Both sample before the clock edge and write after it. A pattern says how many idle cycles follow each beat.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Collection
from typing import Any

import numpy as np
from cocotb.triggers import RisingEdge
from numpy.typing import NDArray

from macram.driver import Beats

PATTERNS = ("none", "random", "bursty")
"""``none``: a beat in every cycle; ``random``: 0 to 3 idle cycles; ``bursty``: seldom, but up to 60 of
them."""


class ProtocolError(AssertionError):
    """A stream broke a rule of AXI4-Stream; the message says on which port, which and at which beat."""


def pauses(pattern: str, rng: random.Random) -> Callable[[], int] | None:
    """Idle cycles before the next beat, drawn per beat; None where there are none.

    Raises:
        ValueError: ``pattern`` is not one of `PATTERNS`.
    """
    if pattern not in PATTERNS:
        raise ValueError(f"a pattern must be one of {', '.join(PATTERNS)}, not {pattern!r}")
    if pattern == "none":
        return None
    if pattern == "random":
        return lambda: max(0, rng.randrange(6) - 2)
    return lambda: rng.randrange(61) if rng.random() < 0.04 else 0


class AxisSource:
    """Drives ``{prefix}_tdata``, ``_tvalid`` and ``_tlast``.

    Attributes:
        moved: beats taken so far, over all calls of `send`.
    """

    def __init__(self, dut: Any, prefix: str, pause: Callable[[], int] | None = None) -> None:
        self._edge = RisingEdge(dut.aclk)
        self._data, self._valid, self._ready, self._last = (
            getattr(dut, f"{prefix}_{name}") for name in ("tdata", "tvalid", "tready", "tlast")
        )
        self._pause = pause
        self.moved = 0
        self.quiet()

    def quiet(self) -> None:
        """Offer nothing."""
        self._valid.value = 0

    async def send(self, beats: Beats, lasts: Collection[int] | None = None) -> None:
        """Send beats ``[n, bytes]``; returns in the cycle that took the last of them.

        A beat once offered stays until it is taken. The data lines carry noise while nothing is offered.

        Args:
            beats: what to send.
            lasts: indices of the beats with TLAST; default the last one alone.
        """
        edge, data, ready, pause = self._edge, self._data, self._ready, self._pause
        words = [int.from_bytes(row, "little") for row in np.ascontiguousarray(beats)]
        ends = {len(words) - 1} if lasts is None else set(lasts)
        changes = {0, *ends, *(end + 1 for end in ends)}
        noise = words[0] ^ ((1 << 8 * beats.shape[1]) - 1)
        for index, word in enumerate(words):
            if pause is not None and (idle := pause()):
                self._valid.value = 0
                data.value = noise
                self._last.value = 1
                for _ in range(idle):
                    await edge
            data.value = word
            if pause is not None or index in changes:
                self._valid.value = 1
                self._last.value = int(index in ends)
            await edge
            while not ready.value:
                await edge
            self.moved += 1
        self.quiet()


class AxisSink:
    """Drives ``{prefix}_tready`` and watches the rest.

    Attributes:
        moved: beats taken so far, over all calls of `receive`.
    """

    def __init__(self, dut: Any, prefix: str, pause: Callable[[], int] | None = None) -> None:
        self._edge = RisingEdge(dut.aclk)
        self._data, self._valid, self._ready, self._last = (
            getattr(dut, f"{prefix}_{name}") for name in ("tdata", "tvalid", "tready", "tlast")
        )
        self._prefix, self._pause = prefix, pause
        self.moved = 0
        self.quiet()

    def quiet(self) -> None:
        """Take nothing."""
        self._ready.value = 0

    async def receive(self, count: int) -> NDArray[np.uint8]:
        """Take ``count`` beats ``[count, bytes]``, the last of which must have TLAST, and no other.

        Raises:
            ProtocolError: TLAST is early or missing, or TVALID, TDATA or TLAST changed during a stall.
        """
        edge, data, valid, last, pause = self._edge, self._data, self._valid, self._last, self._pause
        taken: list[str] = []
        final = count - 1
        for index in range(count):
            held = None
            if pause is not None and (idle := pause()):
                held = await self._stall(idle, index)
            if pause is not None or index == 0:
                self._ready.value = 1
            await edge
            if held is not None:
                self._check_held(held, index)
            while not valid.value:
                await edge
            taken.append(str(data.value))
            self.moved += 1
            if bool(last.value) is not (index == final):
                what = "missing on the last" if index == final else f"early, on beat {index},"
                raise ProtocolError(f"{self._prefix}_tlast is {what} of {count} beats")
        self.quiet()
        bits = np.frombuffer("".join(taken).encode("ascii"), np.uint8).reshape(count, -1) & 1
        return np.packbits(bits[:, ::-1], axis=1, bitorder="little")

    async def _stall(self, cycles: int, index: int) -> tuple[str, bool] | None:
        """Take nothing for some cycles; returns what is offered by the last of them, None if nothing is."""
        self._ready.value = 0
        held: tuple[str, bool] | None = None
        for _ in range(cycles):
            await self._edge
            if held is not None:
                self._check_held(held, index)
            elif self._valid.value:
                held = (str(self._data.value), bool(self._last.value))
        return held

    def _check_held(self, held: tuple[str, bool], index: int) -> None:
        """An offered beat must stay as it is until it is taken."""
        if not self._valid.value:
            raise ProtocolError(f"{self._prefix}: tvalid fell while beat {index} was stalled")
        if (str(self._data.value), bool(self._last.value)) != held:
            raise ProtocolError(f"{self._prefix}: the payload changed while beat {index} was stalled")
