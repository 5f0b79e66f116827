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

from macram.transport import Beats, StreamTimeout

T = TypeVar("T")

MAX_TRANSFER = (1 << 26) - 1
"""Bytes of the longest transfer: the widest length register an AXI DMA can have is 26 bits (PG021)."""
DMACR, DMACR_RESET = 0x00, 1 << 2
"""An AXI DMA's control register, and the bit that resets both of its channels (PG021)."""


class Mmio(Protocol):
    """What is used of ``pynq.MMIO``, and of an overlay's IP driver."""

    def read(self, offset: int) -> int:
        """Value of the 32-bit register at a byte offset."""

    def write(self, offset: int, value: int) -> None:
        """Set the 32-bit register at a byte offset."""


class Channel(Protocol):
    """What is used of one channel of ``pynq.lib.dma.DMA`` (PYNQ 2.6 or newer) without scatter-gather."""

    @property
    def idle(self) -> bool:
        """Whether the last transfer is over."""

    @property
    def error(self) -> bool:
        """Whether the engine has stopped because of an error."""

    @property
    def transferred(self) -> int:
        """Bytes that the last transfer moved, once `wait` has returned."""

    def start(self) -> None:
        """Let the channel run, after a reset of the engine."""

    def transfer(self, buffer: NDArray[np.uint8]) -> None:
        """Bring the buffer out of the cache (sending only) and start moving it."""

    def wait(self) -> None:
        """Wait for the end; RuntimeError on an error. Then make received bytes visible."""


class Dma(Mmio, Protocol):
    """``pynq.lib.dma.DMA``: its registers and channels. The parameters' has no ``recvchannel``."""

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


@dataclass(eq=False)
class _Exchange:
    """An image, or a residual stream, that is on its way: which DMA moves it, and what comes back."""

    dma: Dma
    name: str
    shape: tuple[int, int]
    received: _Lent


class PynqTransport:
    """Registers and streams of the array on a board. Every method waits until it is done.

    Args:
        mmio: the array's registers.
        image_dma: DMA of ``s_axis`` and ``m_axis``.
        param_dma: DMA of ``s_axis_param``, parameters and partial sums.
        allocate: ``pynq.allocate``.
        residual_dma: DMA of ``s_axis_residual`` and ``m_axis_residual``, if the array has a residual adder.
        timeout: seconds a transfer may take.

    One packet is one transfer, because a DMA without scatter-gather ends each of its transfers with TLAST; so
    a packet is never split, and one that exceeds `MAX_TRANSFER` is refused.

    A transfer that is given up still belongs to the DMA engine, and only a reset of the engine takes it away:
    PYNQ's ``stop`` waits for the very transfer that hangs. So its buffer is kept until the channel is idle or
    `reset` was called, and nothing is ever written to memory that was handed back.
    """

    def __init__(
        self,
        mmio: Mmio,
        image_dma: Dma,
        param_dma: Dma,
        allocate: Callable[..., Any],
        *,
        residual_dma: Dma | None = None,
        timeout: float = 10.0,
    ) -> None:
        self._mmio = mmio
        self._image = image_dma
        self._params = param_dma
        self._residual = residual_dma
        self._allocate = allocate
        self._timeout = timeout
        self._lent: list[_Lent] = []
        self._exchanges: list[_Exchange] = []
        self._sending: list[tuple[Channel, str]] = []

    async def read(self, offset: int) -> int:
        """Read the register at a byte offset."""
        return int(self._mmio.read(offset))

    async def write(self, offset: int, value: int) -> None:
        """Write the register at a byte offset."""
        self._mmio.write(offset, value)

    async def send_params(self, beats: Beats) -> None:
        """Send beats ``[n, bytes]`` on the parameter stream.

        Raises:
            ValueError: more than `MAX_TRANSFER` bytes.
            StreamTimeout: the transfer took too long or failed, or an earlier one still holds the channel.
        """
        self.check_params(beats)
        channel = self._params.sendchannel
        try:
            self._start(channel, self._filled(beats))
            self._finish(channel, "parameter stream")
        finally:
            self._reclaim()

    def check_params(self, beats: Beats) -> None:
        """Raise what `send_params` would raise before it moves anything."""
        _check_size(beats.size, "parameter stream")
        self._check_free(self._params.sendchannel, "parameter stream")

    async def begin_stream(
        self, beats: Beats, beats_out: int, residual: Beats | None = None, sums: Beats | None = None
    ) -> None:
        """Start the transfers of an image and come back at once.

        With ``residual``, those beats go to the residual adder, and as many come back from it. With ``sums``, those
        beats go on the parameter stream.

        Raises:
            ValueError: more than `MAX_TRANSFER` bytes in or out, or a residual stream without its DMA.
            StreamTimeout: an earlier transfer still holds a channel.
        """
        wanted = [(self._image, "", beats, beats_out)]
        if residual is not None:
            if self._residual is None:
                raise ValueError("the overlay has no residual DMA; give residual_dma")
            wanted.append((self._residual, "residual ", residual, len(residual)))
        for dma, name, sent, count in wanted:
            _check_size(sent.size, f"{name}input stream")
            _check_size(count * sent.shape[1], f"{name}output stream")
            self._check_free(dma.sendchannel, f"{name}input stream")
            self._check_free(dma.recvchannel, f"{name}output stream")
        senders = [(dma.sendchannel, f"{name}input stream", sent) for dma, name, sent, _ in wanted]
        if sums is not None:
            _check_size(sums.size, "parameter stream")
            self._check_free(self._params.sendchannel, "parameter stream")
            senders.append((self._params.sendchannel, "parameter stream", sums))
        try:
            self._exchanges = [
                _Exchange(dma, name, (count, sent.shape[1]), self._borrow(count * sent.shape[1]))
                for dma, name, sent, count in wanted
            ]
            filled = [self._filled(sent) for _, _, sent in senders]
            # The receivers go first: the array may answer before the whole image is sent.
            for exchange in self._exchanges:
                self._start(exchange.dma.recvchannel, exchange.received)
            for (channel, _, _), lent in zip(senders, filled, strict=True):
                self._start(channel, lent)
            self._sending = [(channel, name) for channel, name, _ in senders]
        except BaseException:
            self._exchanges = []
            self._reclaim()
            raise

    async def end_stream(self) -> list[Beats]:
        """Wait for the image that was begun; its beats ``[beats_out, bytes]``, then those of the residual adder.

        Raises:
            StreamTimeout: no image was begun, or a transfer took too long, failed or came back short.
        """
        if not self._exchanges:
            raise StreamTimeout("no image is on its way; call begin_stream() first")
        try:
            for sender, name in self._sending:
                self._finish(sender, name)
            for exchange in self._exchanges:
                channel, size = exchange.dma.recvchannel, exchange.shape[0] * exchange.shape[1]
                self._finish(channel, f"{exchange.name}output stream")
                if (came := channel.transferred) != size:
                    raise StreamTimeout(
                        f"the {exchange.name}output stream ended after {came} of {size} bytes; reset the array"
                    )
            return [
                np.array(exchange.received.buffer, dtype=np.uint8).reshape(exchange.shape)
                for exchange in self._exchanges
            ]
        finally:
            self._exchanges = []
            self._reclaim()

    def reset(self) -> None:
        """Reset the DMA engines, so that a transfer which was given up is gone and its memory free again.

        A reset ends a stream at an arbitrary beat: soft-reset the array after it, not before.

        Raises:
            StreamTimeout: an engine does not come out of its reset.
        """
        engines = [(self._image, "image"), (self._params, "parameter")]
        if self._residual is not None:
            engines.append((self._residual, "residual"))
        for dma, name in engines:
            dma.write(DMACR, DMACR_RESET)
            deadline = time.monotonic() + self._timeout
            while dma.read(DMACR) & DMACR_RESET:
                if time.monotonic() > deadline:
                    raise StreamTimeout(f"the {name} DMA stays in reset; load the overlay again")
            dma.sendchannel.start()
            if dma is not self._params:
                dma.recvchannel.start()
        for lent in self._lent:
            lent.buffer.freebuffer()
        self._lent, self._exchanges = [], []

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
        awaited = [exchange.received for exchange in self._exchanges]
        busy = [
            lent
            for lent in self._lent
            if lent in awaited or (lent.channel is not None and not lent.channel.idle)
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
                f"the {name} still holds a transfer that was given up; reset the transport "
                "or load the overlay again"
            )

    def _finish(self, channel: Channel, name: str) -> None:
        # PYNQ's own wait() never gives up, so it is entered once the channel is done: it then only checks for
        # errors and brings the received bytes out of the cache.
        deadline = time.monotonic() + self._timeout
        while not (channel.idle or channel.error):
            if time.monotonic() > deadline:
                raise StreamTimeout(f"the {name} did not finish within {self._timeout:g} s; reset the array")
        try:
            channel.wait()
        except RuntimeError as error:
            raise StreamTimeout(f"the {name} failed: {error}; reset the transport and the array") from error


def _check_size(size: int, name: str) -> None:
    if size > MAX_TRANSFER:
        raise ValueError(
            f"the {name} would carry {size} bytes, one DMA transfer at most {MAX_TRANSFER}; split the layer"
        )


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
