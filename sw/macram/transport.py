"""What the driver needs of the world outside: registers, streams, and how they fail."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from macram.spec import Error

Beats = NDArray[np.uint8]
"""``[beats, stream_bits // 8]`` bytes, low byte first."""


class ArrayError(RuntimeError):
    """The array reports an error, or is not the one that was expected.

    Attributes:
        code: the ERROR register; `Error.NONE` where the array itself reports nothing.
    """

    def __init__(self, message: str, code: Error = Error.NONE) -> None:
        super().__init__(message)
        self.code = code


class BusError(ArrayError):
    """A register access was answered with an error."""


class StreamTimeout(ArrayError):
    """A stream stopped moving before its last beat."""


class Transport(Protocol):
    """What the driver needs of the world outside. Offsets are bytes, register values 32 bits unsigned."""

    async def read(self, offset: int) -> int:
        """Read a register; `BusError` if it is refused."""

    async def write(self, offset: int, value: int) -> None:
        """Write a register; `BusError` if it is refused."""

    async def send_params(self, beats: Beats) -> None:
        """Send beats on the parameter stream, TLAST on the last; `StreamTimeout` if they are not taken."""

    def check_params(self, beats: Beats) -> None:
        """Raise what `send_params` would refuse to send, before the load is commanded."""

    async def begin_stream(
        self, beats: Beats, beats_out: int, residual: Beats | None = None, sums: Beats | None = None
    ) -> None:
        """Send an image, TLAST on its last beat, and expect ``beats_out`` beats back.

        It goes on by itself: registers and parameter stream stay free meanwhile. Before START the array takes no beat,
        so it is begun first: what the transport refuses was never started.

        With ``residual``, those beats go to the residual adder, and as many come back from it. With ``sums``, those
        beats go on the parameter stream, which is not free then.
        """

    async def end_stream(self) -> list[Beats]:
        """Wait for the image that was begun; its beats, and second in the list those of the residual adder.

        Raises:
            StreamTimeout: no stream moves any more.
        """
