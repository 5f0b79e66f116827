"""The driver's transport on a PYNQ board: registers by MMIO, streams by AXI DMA.

Nothing of PYNQ is imported: the overlay's objects are handed in, so this also runs off the board on fakes.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Coroutine
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


class PynqTransport:
    """Registers and streams of the array on a board. Every method waits until it is done.

    Args:
        mmio: the array's registers.
        image_dma: DMA of ``s_axis`` and ``m_axis``; its transfers must admit a whole image.
        param_dma: DMA of ``s_axis_param``.
        allocate: ``pynq.allocate``.
        timeout: seconds a transfer may take.
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

    async def read(self, offset: int) -> int:
        """Read the register at a byte offset."""
        return int(self._mmio.read(offset))

    async def write(self, offset: int, value: int) -> None:
        """Write the register at a byte offset."""
        self._mmio.write(offset, value)

    async def send_params(self, beats: Beats) -> None:
        """Send beats ``[n, bytes]`` on the parameter stream.

        Raises:
            StreamTimeout: the transfer took too long.
        """
        buffer = self._filled(beats)
        try:
            self._params.sendchannel.transfer(buffer)
            self._finish(self._params.sendchannel, "parameter stream")
        finally:
            buffer.freebuffer()

    async def run_stream(self, beats: Beats, beats_out: int) -> Beats:
        """Send an image and return the beats ``[beats_out, bytes]`` that come back.

        Raises:
            StreamTimeout: a transfer took too long.
        """
        size = beats.shape[1]
        received = self._allocate(shape=(beats_out * size,), dtype=np.uint8)
        buffer = None
        try:
            buffer = self._filled(beats)
            # The receiver goes first: the array may answer before the whole image is sent.
            self._image.recvchannel.transfer(received)
            self._image.sendchannel.transfer(buffer)
            self._finish(self._image.sendchannel, "input stream")
            self._finish(self._image.recvchannel, "output stream")
            return np.array(received, dtype=np.uint8).reshape(beats_out, size)
        finally:
            received.freebuffer()
            if buffer is not None:
                buffer.freebuffer()

    def _filled(self, beats: Beats) -> Any:
        buffer = self._allocate(shape=(beats.size,), dtype=np.uint8)
        buffer[:] = beats.reshape(-1)
        return buffer

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
