"""The driver's transport on a PYNQ board: registers by MMIO, streams by AXI DMA.

Nothing of PYNQ is imported: the overlay's objects are handed in, so this also runs off the board on fakes.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Coroutine
from dataclasses import dataclass
from typing import Any, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from macram.driver import Beats, StreamTimeout

T = TypeVar("T")


class Mmio(Protocol):
    """What is used of ``pynq.MMIO``, and of an overlay's IP driver."""

    def read(self, offset: int) -> int:
        """Value of the 32-bit register at a byte offset."""

    def write(self, offset: int, value: int) -> None:
        """Set the 32-bit register at a byte offset."""


class Channel(Protocol):
    """What is used of one channel of ``pynq.lib.dma.DMA``."""

    @property
    def idle(self) -> bool:
        """Whether the last transfer is over."""

    def transfer(self, buffer: NDArray[np.uint8]) -> None:
        """Start moving the buffer."""

    def wait(self) -> None:
        """Wait for the end, check for errors, and make received bytes visible."""


class Dma(Protocol):
    """``pynq.lib.dma.DMA``; that of the parameter stream needs no ``recvchannel``."""

    @property
    def sendchannel(self) -> Channel:
        """Memory to stream."""

    @property
    def recvchannel(self) -> Channel:
        """Stream to memory."""


@dataclass(eq=False)
class _Lent:
    """A buffer in use, and the channel that was told to move it."""

    buffer: Any
    channel: Channel | None = None


class PynqTransport:
    """Registers and streams of the array on a board. Every method waits until it is done.

    Args:
        mmio: the array's registers.
        image_dma: DMA of ``s_axis`` and ``m_axis``; its transfers must admit a whole image.
        param_dma: DMA of ``s_axis_param``.
        allocate: ``pynq.allocate``.
        timeout: seconds a transfer may take.

    A transfer that is given up still belongs to the DMA engine, and only a reset of the engine takes it away:
    PYNQ's ``stop`` waits for the very transfer that hangs. So its buffer is kept until the channel is idle, and
    nothing is ever written to memory that was handed back.
    """

    def __init__(
        self,
        mmio: Mmio,
        image_dma: Dma,
        param_dma: Dma,
        allocate: Callable[..., Any],
        *,
        timeout: float = 10.0,
    ) -> None:
        self._mmio = mmio
        self._image = image_dma
        self._params = param_dma
        self._allocate = allocate
        self._timeout = timeout
        self._lent: list[_Lent] = []
        self._awaited: tuple[_Lent, tuple[int, int]] | None = None

    async def read(self, offset: int) -> int:
        """Read the register at a byte offset."""
        return int(self._mmio.read(offset))

    async def write(self, offset: int, value: int) -> None:
        """Write the register at a byte offset."""
        self._mmio.write(offset, value)

    async def send_params(self, beats: Beats) -> None:
        """Send beats ``[n, bytes]`` on the parameter stream.

        Raises:
            StreamTimeout: the transfer took too long, or an earlier one still holds the channel.
        """
        channel = self._params.sendchannel
        self._check_free(channel, "parameter stream")
        try:
            self._start(channel, self._filled(beats))
            self._finish(channel, "parameter stream")
        finally:
            self._reclaim()

    async def run_stream(self, beats: Beats, beats_out: int) -> Beats:
        """Send an image and return the beats ``[beats_out, bytes]`` that come back.

        Raises:
            StreamTimeout: a transfer took too long, or an earlier one still holds a channel.
        """
        await self.begin_stream(beats, beats_out)
        return await self.end_stream()

    async def begin_stream(self, beats: Beats, beats_out: int) -> None:
        """Start both transfers of an image and come back at once.

        Raises:
            StreamTimeout: an earlier transfer still holds a channel.
        """
        sender, receiver = self._image.sendchannel, self._image.recvchannel
        self._check_free(sender, "input stream")
        self._check_free(receiver, "output stream")
        size = beats.shape[1]
        try:
            received = self._borrow(beats_out * size)
            image = self._filled(beats)
            # The receiver goes first: the array may answer before the whole image is sent.
            self._start(receiver, received)
            self._start(sender, image)
        except BaseException:
            self._reclaim()
            raise
        self._awaited = received, (beats_out, size)

    async def end_stream(self) -> Beats:
        """Wait for the image that was begun.

        Raises:
            StreamTimeout: a transfer took too long.
        """
        if self._awaited is None:
            raise StreamTimeout("no image is on its way; call begin_stream() first")
        received, shape = self._awaited
        try:
            self._finish(self._image.sendchannel, "input stream")
            self._finish(self._image.recvchannel, "output stream")
            return np.array(received.buffer, dtype=np.uint8).reshape(shape)
        finally:
            self._awaited = None
            self._reclaim()

    def _borrow(self, size: int) -> _Lent:
        lent = _Lent(self._allocate(shape=(size,), dtype=np.uint8))
        self._lent.append(lent)
        return lent

    def _filled(self, beats: Beats) -> _Lent:
        lent = self._borrow(beats.size)
        lent.buffer[:] = beats.reshape(-1)
        return lent

    @staticmethod
    def _start(channel: Channel, lent: _Lent) -> None:
        lent.channel = channel  # first, so that a transfer which starts and then fails is not forgotten
        channel.transfer(lent.buffer)

    def _reclaim(self) -> None:
        """Free every buffer that no channel can touch any more and nobody is going to read."""
        awaited = self._awaited[0] if self._awaited else None
        busy = [
            lent
            for lent in self._lent
            if lent is awaited or (lent.channel is not None and not lent.channel.idle)
        ]
        for lent in self._lent:
            if lent not in busy:
                lent.buffer.freebuffer()
        self._lent = busy

    def _check_free(self, channel: Channel, name: str) -> None:
        """Refuse to start beside a transfer that was given up; its end would be taken for that of the next."""
        self._reclaim()
        if any(lent.channel is channel for lent in self._lent):
            raise StreamTimeout(
                f"the {name} still holds a transfer that was given up; load the overlay again"
            )

    def _finish(self, channel: Channel, name: str) -> None:
        # PYNQ's own wait() never gives up, so it is entered once the channel is done: it then only checks for
        # errors and brings the received bytes out of the cache.
        deadline = time.monotonic() + self._timeout
        while not channel.idle:
            if time.monotonic() > deadline:
                raise StreamTimeout(f"the {name} did not finish within {self._timeout:g} s; reset the array")
        channel.wait()


def run_sync(coroutine: Coroutine[Any, Any, T]) -> T:
    """Run a driver coroutine whose transport never really waits, without an event loop.

    Raises:
        RuntimeError: the coroutine wants to wait; it belongs into an event loop.
    """
    try:
        coroutine.send(None)
    except StopIteration as done:
        value: T = done.value
        return value
    coroutine.close()
    raise RuntimeError("the transport waits; use run_sync only with transports like PynqTransport")
