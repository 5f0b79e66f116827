"""A stand-in for PYNQ with a board behind it: caches, DMA engines (PG021, PYNQ 3.0) and the array of an overlay.

`OverlayBoard` can be told to have one fault. As module ``pynq`` in a process of its own it takes the fault from the
environment variable BOARD_FAULT.
"""

from __future__ import annotations

import json
import os
from pathlib import Path

import numpy as np
from test_driver import FakeArray

from macram.layer_file import LayerCase
from macram.pack import pack_layer
from macram.spec import BY_NAME, ArrayConfig, ConvSpec, Error, IntFormat, StreamLayout

MAX_BYTES = (1 << 26) - 1


class Buffer(np.ndarray):
    """What the processor sees; ``memory`` is what a DMA sees, and flush and invalidate carry between the two."""

    def __new__(cls, shape, dtype):
        self = np.full(shape, 0xEE, dtype).view(cls)
        self.memory = np.full(shape, 0xDD, dtype)
        self.freed = False
        return self

    def flush(self):
        self.memory[:] = np.asarray(self)

    def invalidate(self):
        np.asarray(self)[:] = self.memory

    def freebuffer(self):
        assert not self.freed
        self.freed = True


class Channel:
    """One direction of a DMA in direct register mode, with PYNQ's refusals; ``move`` says whether it is done."""

    def __init__(self, receives, move):
        self.receives, self.move = receives, move
        self.running, self.error, self.busy, self.transferred = True, False, False, 0
        self.buffer = None

    @property
    def idle(self):
        if self.busy and self.running and self.move(self):
            self.busy = False
        return not self.busy

    def start(self):
        self.running = True

    def transfer(self, buffer):
        if not self.running:
            raise RuntimeError("DMA channel not started")
        if not self.idle:
            raise RuntimeError("DMA channel not idle")
        assert buffer.nbytes <= MAX_BYTES
        if not self.receives:
            buffer.flush()
        self.buffer, self.busy, self.transferred = buffer, True, 0

    def wait(self):
        if self.error:
            raise RuntimeError("DMA Slave Error (cannot access memory map interface)")
        assert self.idle, "PYNQ's wait() would hang here"
        if self.receives:
            self.buffer.invalidate()

    def fail(self):
        self.error, self.running = True, False


class Dma:
    """An AXI DMA: its control register's reset bit, and its channels."""

    def __init__(self, send, receive=None):
        self.sendchannel = Channel(False, send)
        if receive:
            self.recvchannel = Channel(True, receive)
        self.stuck = False
        self.resets = 0

    def write(self, offset, value):
        assert (offset, value) == (0x00, 0x04)
        self.resets += 1
        for channel in (self.sendchannel, getattr(self, "recvchannel", None)):
            if channel:
                channel.running = channel.error = channel.busy = False

    def read(self, offset):
        assert offset == 0x00
        return 0x04 if self.stuck else 0x02


class OverlayBoard(FakeArray):
    """The array as the overlay has it: starts up with the layer's weights, keeps the rules of TLAST and busy."""

    def __init__(self, array: ArrayConfig, case: LayerCase, fault: str = ""):
        super().__init__(array)
        self.kind, self.busy, self.buffers_made = fault, False, []
        packed = pack_layer(case, array)
        words = packed.weights.reshape(-1, packed.weights.shape[2])
        self.words = {
            (2, 0): [int.from_bytes(bytes(word), "little") for word in words],
            (4, 0): packed.requant_ints(),
        }
        if fault == "not preloaded":
            self.words[2, 0] = [0] * len(self.words[2, 0])
        if fault == "another array":
            self.registers["GEOMETRY"] += 1
        self.output = None
        self.dma_image, self.dma_param = Dma(self.send_image, self.receive), Dma(self.send_param)
        self.dma_image.stuck = fault == "reset hangs"
        if array.residual_stream_bits:
            self.dma_residual = Dma(self.send_residual, self.receive_sums)
        self.branch, self.stream, self.sums = None, None, None

    def allocate(self, shape, dtype):
        self.buffers_made.append(Buffer(shape, dtype))
        return self.buffers_made[-1]

    def read(self, offset):
        name = next(r.name for r in BY_NAME.values() if r.offset == offset)
        if name == "STATUS":
            return int(self.busy or self.kind == "stays busy") | 4 * bool(self.fault)
        return int(self.fault) if name == "ERROR" else self.registers[name]

    def write(self, offset, value):
        name = next(r.name for r in BY_NAME.values() if r.offset == offset)
        if self.busy:
            assert (name, value) == ("CONTROL", 8), (
                "a write while busy is a bus error, which kills the process"
            )
        super().write(offset, value)
        if self.kind == "register sticks" and name == "WIDTH":
            self.registers[name] |= 1
        if name != "CONTROL":
            return
        self.fault, self.output = Error.NONE, None
        self.branch, self.stream, self.sums = None, None, None
        self.busy = value in (1, 2, 4)
        if value == 1 and not self.registers["HEIGHT"]:
            self.busy, self.fault = False, Error.NONE if self.kind == "accepts anything" else Error.BAD_SHAPE

    def send_image(self, channel):
        if self.kind == "hangs" or self.command != 1:
            return False
        if self.kind == "memory error":
            channel.fail()
            return False
        spec = self.spec()
        layout = StreamLayout(spec.c_in, spec.input, self.array.stream_bits)
        wanted = spec.height * spec.width * layout.beats_per_pixel * self.array.stream_bits // 8
        if len(channel.buffer.memory) < wanted:
            self.fault = Error.TLAST_EARLY
            return True
        self.take("image", bytes(channel.buffer.memory))
        if self.registers["MODE"] >> 25 & 1:
            self.branch, self.output = self.output, None
            self.add()
        if self.kind == "wrong code" and self.output is not None:
            self.output[-1, 0] ^= 1
        if self.kind == "short output":
            self.output = self.output[:-1]
        return True

    def spec(self):
        return ConvSpec(*(self.registers[name] for name in ("C_IN", "C_OUT", "HEIGHT", "WIDTH")))

    def send_param(self, channel):
        self.take("param", bytes(channel.buffer.memory))
        self.busy = False
        return True

    def send_residual(self, channel):
        if self.command != 1:
            return False
        self.stream = np.array(channel.buffer.memory)
        self.add()
        return True

    def add(self):
        """The residual adder, from its registers, once the branch and the stream are there."""
        if self.branch is None or self.stream is None:
            return
        spec = self.spec()
        wide = StreamLayout(spec.c_out, IntFormat(8), self.array.residual_stream_bits)
        narrow = StreamLayout(spec.c_out, spec.output, self.array.stream_bits)
        stream = wide.unpack(
            self.stream.reshape(-1, self.array.residual_stream_bits // 8), spec.height, spec.width
        )
        codes = narrow.unpack(self.branch, spec.height, spec.width)

        def entries(name, count):
            words = (self.registers[f"RESIDUAL_{name}{i // 4}"] >> 8 * (i % 4) for i in range(count))
            return np.array([word & 255 for word in words])

        sums = np.minimum(stream + entries("TABLE", 8)[codes], 255)
        if self.kind == "wrong sum":
            sums[0, 0, 0] ^= 1
        self.sums = wide.pack(sums)
        self.output = narrow.pack((sums[..., None] > entries("BOUNDS", 7)).sum(axis=-1))

    def receive(self, channel):
        return self.answer(channel, "output")

    def receive_sums(self, channel):
        return self.answer(channel, "sums")

    def answer(self, channel, name):
        beats = getattr(self, name)
        if beats is None:
            return False
        flat = beats.reshape(-1)
        channel.buffer.memory[: flat.size] = flat
        channel.transferred = flat.size
        setattr(self, name, None)
        self.busy = self.output is not None or self.sums is not None
        return True


# ---- as module `pynq` --------------------------------------------------------------------------------------

FAULT = os.environ.get("BOARD_FAULT", "")
_boards: list[OverlayBoard] = []


class Clocks:
    fclk0_mhz = 50.0


class Overlay:
    """``pynq.Overlay``: loads what lies beside the bitstream."""

    def __init__(self, bitstream: str):
        folder = Path(bitstream).parent
        array = ArrayConfig.from_dict(json.loads((folder / "overlay.json").read_text())["array"])
        board = OverlayBoard(array, LayerCase.load(folder / "layer.npz"), FAULT)
        _boards.append(board)
        self.macram_0, self.dma_image, self.dma_param = board, board.dma_image, board.dma_param
        if array.residual_stream_bits:
            self.dma_residual = board.dma_residual
        Clocks.fclk0_mhz = 187.5 if FAULT == "another clock" else Clocks.fclk0_mhz * 0.99999


def allocate(shape, dtype):
    return _boards[-1].allocate(shape, dtype)
