"""The driver over PYNQ's objects, against a fake array that decodes every bit and computes with the golden
model."""

from __future__ import annotations

import asyncio
import dataclasses
import os

import numpy as np
import pytest

from macram import golden
from macram.driver import COUNTERS, ArrayDriver, ArrayError, StreamTimeout
from macram.layer_file import LayerCase
from macram.pack import PackedLayer, pack_layer, pack_passes, unpack
from macram.pynq_transport import PynqTransport, run_sync
from macram.spec import BY_NAME, ArrayConfig, ConvSpec, Error, IntFormat, StreamLayout

SEED = int(os.environ.get("SEED", "41"))
TINY = ArrayConfig(
    name="tiny", units=8, rows=2, max_c_in=16, max_c_out=32, weight_depth=64, row_words=32, stream_bits=32,
    drain=2,
)  # fmt: skip
U3 = IntFormat(3)


class FakeArray:
    """Registers and streams of an array at their bit level; commands and formats as the register map has
    them."""

    def __init__(self, array: ArrayConfig):
        self.array = array
        self.log: list[tuple[str, int]] = []
        self.registers = dict.fromkeys(BY_NAME, 0)
        self.registers |= {
            "ID": 0x4D414352,
            "VERSION": 0x20001,
            "GEOMETRY": int(f"{array.drain:02x}{array.rows:02x}{array.units:04x}", 16),
            "FORMATS": int(f"{array.output.bits:02x}{array.input.bits:02x}{array.weight.bits:02x}", 16),
            "WEIGHT_DEPTH": array.weight_depth,
            "ROW_WORDS": array.row_words,
            "MAX_CHANNELS": int(f"{array.max_c_out:04x}{array.max_c_in:04x}", 16),
            "RESIDUAL": array.residual_stream_bits,
            "PARTIAL_C_IN": array.partial_sum_c_in,
        }
        self.words: dict[tuple[int, int], list[int]] = {}
        self.fault = Error.NONE
        self.busy_reads = 0
        self.hang = False
        self.buffers = 0
        self.output: np.ndarray | None = None
        self.target: np.ndarray | None = None
        self.command = 0
        self.mmio, self.image, self.param = self, FakeDma(self, "image"), FakeDma(self, "param")

    def transport(self) -> PynqTransport:
        return PynqTransport(self.mmio, self.image, self.param, self.allocate, timeout=0.05)

    def allocate(self, shape, dtype):
        self.buffers += 1
        fake = self

        class Buffer(np.ndarray):
            def freebuffer(self):
                fake.buffers -= 1

        return np.full(shape, 0xEE, dtype).view(Buffer)

    def read(self, offset: int) -> int:
        name = next(r.name for r in BY_NAME.values() if r.offset == offset)
        if name == "STATUS":
            self.busy_reads, busy = max(self.busy_reads - 1, 0), self.busy_reads > 0
            return busy | busy << 3 | 2 | (4 if self.fault else 0)
        return int(self.fault) if name == "ERROR" else self.registers[name]

    def write(self, offset: int, value: int) -> None:
        name = next(r.name for r in BY_NAME.values() if r.offset == offset)
        assert BY_NAME[name].access != "RO"
        assert type(value) is int
        self.log.append((name, value))
        if name == "CONTROL":
            self.command, self.busy_reads = value, 3
            if value == 1:
                self.image.sendchannel.deliver()
        else:
            self.registers[name] = value

    def take(self, stream: str, raw: bytes) -> None:
        size = self.array.stream_bits // 8
        assert len(raw) % size == 0
        if stream == "param":
            width = self.array.weight_word_bits if self.command == 2 else self.array.requant_word_bits
            step = -(-width // (8 * size)) * size
            words = [int.from_bytes(raw[i : i + step], "little") for i in range(0, len(raw), step)]
            self.words[self.command, self.registers["PARAM_BASE"]] = words
            per = self.array.units if self.command == 2 else 1
            assert len(words) == per * self.registers["PARAM_WORDS"]
            return
        assert self.command == 1
        r = self.registers
        mode = r["MODE"]
        spec = ConvSpec(
            r["C_IN"], r["C_OUT"], r["HEIGHT"], r["WIDTH"], mode & 255, mode >> 8 & 255, mode >> 16 & 255,
            self.array.weight, dataclasses.replace(self.array.input, signed=bool(mode >> 24 & 1)), self.array.output,
        )  # fmt: skip
        beats = np.frombuffer(raw, np.uint8).reshape(-1, size)
        image = StreamLayout(spec.c_in, spec.input, 8 * size).unpack(beats, spec.height, spec.width)
        weights, requant = unpack(PackedLayer(spec, self.array, *self.memory(spec)))
        codes = requant.apply(golden.conv2d(image, weights, stride=spec.stride, padding=spec.padding))
        self.output = StreamLayout(spec.c_out, spec.output, 8 * size).pack(codes)
        self.registers |= {name.upper(): 1000 + i for i, name in enumerate(COUNTERS)}

    def memory(self, spec: ConvSpec):
        def as_bytes(words, bits):
            return np.array([list(w.to_bytes(-(-bits // 8), "little")) for w in words], np.uint8)

        weights = self.words[2, self.registers["WEIGHT_BASE"]]
        requant = self.words[4, self.registers["REQUANT_BASE"]]
        weights = as_bytes(weights, self.array.weight_word_bits)
        return (
            weights.reshape(self.array.units, -1, weights.shape[1]),
            as_bytes(requant, self.array.requant_word_bits),
        )


class FakeDma:
    """Both channels of one DMA; the receive channel must be armed before the array answers."""

    def __init__(self, fake: FakeArray, stream: str):
        self.sendchannel = FakeChannel(fake, stream)
        if stream == "image":
            self.recvchannel = FakeChannel(fake, "output")


class FakeChannel:
    def __init__(self, fake: FakeArray, stream: str):
        self.fake, self.stream, self.started, self.polls = fake, stream, False, 0
        self.error, self.transferred = False, 0
        self.waiting: bytes | None = None

    @property
    def idle(self) -> bool:
        self.polls += 1
        return self.started and not self.fake.hang and self.polls > 2 and self.waiting is None

    def transfer(self, buffer) -> None:
        self.started, self.polls = True, 0
        if self.stream == "output":
            self.fake.target = buffer
            return
        self.waiting = bytes(buffer)
        if self.stream == "param":
            self.deliver()

    def deliver(self) -> None:
        """The array takes what waits: an image from START on, parameters at once."""
        if self.waiting is not None and not self.fake.hang:
            self.fake.take(self.stream, self.waiting)
            self.waiting = None

    def wait(self) -> None:
        assert self.started
        if self.stream == "output":
            assert self.fake.output is not None
            assert self.fake.target is not None
            self.fake.target[:] = self.fake.output.reshape(-1)
            self.transferred = self.fake.output.size


def random_case(spec: ConvSpec, seed: int) -> LayerCase:
    rng = np.random.default_rng(seed)
    return LayerCase(
        spec,
        rng.integers(-4, 4, (spec.c_out, spec.c_in, 3, 3)),
        rng.integers(0, 8, (spec.c_in, spec.height, spec.width)),
        rng.uniform(-0.05, 0.05, spec.c_out),
        rng.uniform(-2, 9, spec.c_out),
    )


@pytest.mark.parametrize("shape", [(1, 1, 1, 1), (3, 9, 5, 7), (16, 15, 2, 13), (5, 17, 8, 4)])
def test_load_configure_run(shape):
    case = random_case(ConvSpec(*shape), SEED)
    fake = FakeArray(TINY)
    driver = ArrayDriver(fake.transport(), TINY)

    async def job():
        await driver.identify()
        await driver.soft_reset()
        await driver.load(pack_layer(case, TINY))
        await driver.configure(case.spec)
        first = await driver.run(case.input)
        return first, await driver.run(7 - case.input)

    first, second = run_sync(job())
    np.testing.assert_array_equal(first.codes, golden.run_layer(case))
    np.testing.assert_array_equal(
        second.codes, golden.run_layer(dataclasses.replace(case, input=7 - case.input))
    )
    assert first.counters == {name: 1000 + i for i, name in enumerate(COUNTERS)}
    assert fake.buffers == 0, "every buffer is freed"
    assert [value for name, value in fake.log if name == "CONTROL"] == [8, 2, 4, 1, 1]


@pytest.mark.parametrize(("kernel", "stride"), [(3, 1), (3, 2), (1, 1), (1, 2)])
def test_passes_of_every_kind_with_signed_codes(kernel, stride):
    """Weights of the next pass go to the other end of the memories while the image is under way."""
    spec = ConvSpec(16, 60, 5, 7, kernel, stride, kernel // 2, input=IntFormat(3, signed=True))
    case = golden.random_case(spec, SEED)
    fake = FakeArray(TINY)
    passes = pack_passes(case, TINY)
    result = run_sync(ArrayDriver(fake.transport(), TINY).run_passes(passes, case.input))
    np.testing.assert_array_equal(result.codes, golden.run_layer(case))
    assert result.counters["cycles"] == 1000 * len(passes)
    assert fake.buffers == 0
    commands = [value for name, value in fake.log if name == "CONTROL"]
    ends = {value for name, value in fake.log if name == "WEIGHT_BASE"}
    if (kernel, stride) == (3, 2):
        # 48 of 64 words: no two passes fit together.
        assert commands == [2, 4, 1] * 8
    else:
        assert commands == [2, 4, *[1, 2, 4] * (len(passes) - 1), 1]
        assert len(passes) > 1
    assert len(ends) == 2


def test_an_image_must_be_begun_before_it_ends():
    with pytest.raises(StreamTimeout, match=r"call begin_stream\(\) first"):
        run_sync(FakeArray(TINY).transport().end_stream())


@pytest.mark.parametrize(
    ("changes", "register"),
    [
        ({"units": 16}, "GEOMETRY"),
        ({"rows": 4}, "GEOMETRY"),
        ({"drain": 1}, "GEOMETRY"),
        ({"weight": IntFormat(4, signed=True)}, "FORMATS"),
        ({"input": IntFormat(3, signed=True)}, "FORMATS"),
        ({"output": IntFormat(3, signed=True)}, "FORMATS"),
        ({"weight_depth": 65}, "WEIGHT_DEPTH"),
        ({"row_words": 34}, "ROW_WORDS"),
        ({"max_c_in": 17}, "MAX_CHANNELS"),
        ({"max_c_out": 64}, "MAX_CHANNELS"),
        ({"partial_sum_c_in": 64}, "PARTIAL_C_IN"),
    ],
)
def test_identify_names_what_differs(changes, register):
    driver = ArrayDriver(FakeArray(TINY).transport(), dataclasses.replace(TINY, **changes))
    with pytest.raises(ArrayError, match=rf"^{register} is 0x"):
        run_sync(driver.identify())


@pytest.mark.parametrize("register", ["ID", "VERSION"])
def test_identify_wants_this_design(register):
    fake = FakeArray(TINY)
    fake.registers[register] ^= 1
    with pytest.raises(ArrayError, match=rf"^{register} is 0x"):
        run_sync(ArrayDriver(fake.transport(), TINY).identify())


@pytest.mark.parametrize("code", [e for e in Error if e])
def test_errors_are_named(code):
    case = random_case(ConvSpec(2, 3, 2, 2), SEED)
    fake = FakeArray(TINY)
    driver = ArrayDriver(fake.transport(), TINY)
    run_sync(driver.load(pack_layer(case, TINY)))
    run_sync(driver.configure(case.spec))
    fake.fault = code
    with pytest.raises(ArrayError, match=code.name) as caught:
        run_sync(driver.run(case.input))
    assert caught.value.code is code
    fake.hang = True
    with pytest.raises(ArrayError, match=code.name):
        run_sync(driver.run(case.input))


def test_unknown_error_code():
    fake = FakeArray(TINY)
    fake.fault = 99
    with pytest.raises(ArrayError, match="unknown error code 99"):
        run_sync(ArrayDriver(fake.transport(), TINY).soft_reset())


def test_streams_that_hang_are_given_up():
    case = random_case(ConvSpec(2, 3, 2, 2), SEED)
    fake = FakeArray(TINY)
    driver = ArrayDriver(fake.transport(), TINY)
    fake.hang = True
    with pytest.raises(StreamTimeout, match=r"parameter stream did not finish within 0\.05 s"):
        run_sync(driver.load(pack_layer(case, TINY)))
    run_sync(driver.configure(case.spec))
    with pytest.raises(StreamTimeout, match="input stream"):
        run_sync(driver.run(case.input))


def test_memory_that_a_dma_may_still_write_is_kept():
    case = random_case(ConvSpec(2, 3, 2, 2), SEED)
    fake = FakeArray(TINY)
    driver = ArrayDriver(fake.transport(), TINY)
    run_sync(driver.load(pack_layer(case, TINY)))
    run_sync(driver.configure(case.spec))
    fake.hang = True
    with pytest.raises(StreamTimeout, match="input stream did not finish"):
        run_sync(driver.run(case.input))
    assert fake.buffers == 2, "both channels are still at it"
    with pytest.raises(StreamTimeout, match=r"input stream still holds a transfer .* load the overlay again"):
        run_sync(driver.run(case.input))
    assert fake.buffers == 2
    fake.hang = False
    fake.image.sendchannel.deliver()  # the array takes it after all
    first = run_sync(driver.run(case.input)).codes
    np.testing.assert_array_equal(first, golden.run_layer(case))
    assert fake.buffers == 0, "freed once the channels are idle"


def test_a_transfer_that_never_starts_keeps_nothing():
    case = random_case(ConvSpec(2, 3, 2, 2), SEED)
    fake = FakeArray(TINY)

    def allocate(shape, dtype):
        if fake.buffers:
            raise MemoryError
        return fake.allocate(shape, dtype)

    driver = ArrayDriver(PynqTransport(fake, fake.image, fake.param, allocate), TINY)
    run_sync(driver.configure(case.spec))
    with pytest.raises(MemoryError):
        run_sync(driver.run(case.input))
    assert fake.buffers == 0


def test_an_array_that_stays_busy_is_given_up():
    fake = FakeArray(TINY)
    driver = ArrayDriver(fake.transport(), TINY)
    fake.write = lambda offset, value: setattr(fake, "busy_reads", 10**9)
    with pytest.raises(ArrayError, match="still busy"):
        run_sync(driver.soft_reset())


def test_bad_input_reaches_no_register():
    case = random_case(ConvSpec(2, 3, 4, 4), SEED)
    fake = FakeArray(TINY)
    driver = ArrayDriver(fake.transport(), TINY)
    with pytest.raises(ValueError, match=r"call configure\(\) before run\(\)"):
        run_sync(driver.run(case.input))
    with pytest.raises(ValueError, match="packed for array 'reference'"):
        run_sync(driver.load(pack_layer(case, ArrayConfig())))
    with pytest.raises(ValueError, match="padding 0"):
        run_sync(driver.configure(ConvSpec(2, 3, 4, 4, padding=0)))
    assert fake.log == []
    run_sync(driver.configure(case.spec))
    before = list(fake.log)
    with pytest.raises(ValueError, match=r"must be \[2, 4, 4\], not \[2, 4, 5\]"):
        run_sync(driver.run(np.zeros((2, 4, 5), np.int64)))
    with pytest.raises(ValueError, match=r"codes must lie in 0\.\.7"):
        run_sync(driver.run(case.input + 8))
    assert fake.log == before


@pytest.mark.parametrize("reason", ["too long", "held"])
def test_nothing_is_started_that_cannot_be_fed(reason, monkeypatch):
    """Neither a load nor a run is commanded if the transport refuses its packet."""
    case = random_case(ConvSpec(2, 3, 4, 4), SEED)
    fake = FakeArray(TINY)
    driver = ArrayDriver(fake.transport(), TINY)
    run_sync(driver.load(pack_layer(case, TINY)))
    run_sync(driver.configure(case.spec))
    if reason == "too long":
        monkeypatch.setattr("macram.pynq_transport.MAX_TRANSFER", 7)
        refused = pytest.raises(ValueError, match="one DMA transfer at most 7; split the layer")
    else:
        fake.hang = True
        for job in (driver.load(pack_layer(case, TINY)), driver.run(case.input)):
            with pytest.raises(StreamTimeout, match="did not finish"):
                run_sync(job)
        fake.hang = False  # but both transfers are still under way
        refused = pytest.raises(StreamTimeout, match="still holds a transfer that was given up")
    before = list(fake.log)
    for job in (driver.run(case.input), driver.load(pack_layer(case, TINY))):
        with refused:
            run_sync(job)
    assert fake.log == before, "no register was written"


def test_run_sync_refuses_to_wait():
    with pytest.raises(RuntimeError, match="the transport waits"):
        run_sync(asyncio.sleep(0))
