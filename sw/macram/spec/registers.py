"""The AXI4-Lite register map: one table for the gateware, the driver and the documentation."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum, IntFlag


@dataclass(frozen=True, slots=True)
class Register:
    """A 32-bit register at byte ``offset``; ``access`` is ``RO``, ``RW`` or ``WO``."""

    name: str
    offset: int
    access: str
    reset: int
    description: str


class Control(IntFlag):
    """Bits of CONTROL; each acts once when written as 1."""

    START = 1
    LOAD_WEIGHTS = 2
    LOAD_REQUANT = 4
    SOFT_RESET = 8


class Status(IntFlag):
    """Bits of STATUS. BUSY: an image is being run. LOADING: a parameter load is under way."""

    BUSY = 1
    DONE = 2
    ERROR = 4
    LOADING = 8


class Error(IntEnum):
    """Values of ERROR. The first fault since the last command or soft reset is kept."""

    NONE = 0
    BAD_SHAPE = 1
    BAD_MODE = 2
    TLAST_EARLY = 3
    TLAST_MISSING = 4
    BAD_COMMAND = 5
    BAD_RANGE = 6


ID_VALUE = 0x4D41_4352
VERSION_VALUE = 0x0002_0001
MODE_3X3 = 0x0001_0103
"""MODE of a 3x3 kernel with stride 1 and padding 1, see `mode_word`."""


MODE_BIASED, MODE_RESIDUAL, MODE_SUMS_IN, MODE_SUMS_OUT = 24, 25, 26, 27
"""Bits of MODE: signed codes on unsigned inputs; the residual adder is in use; the run starts from partial sums,
which come on the parameter stream; it leaves partial sums instead of codes."""


def mode_word(
    kernel: int,
    stride: int,
    padding: int,
    *,
    biased: bool = False,
    residual: bool = False,
    sums_in: bool = False,
    sums_out: bool = False,
) -> int:
    """Value of MODE: kernel in bits 7:0, stride in 15:8, padding in 23:16, and the bits ``MODE_...``."""
    bits = biased << MODE_BIASED | residual << MODE_RESIDUAL
    bits |= sums_in << MODE_SUMS_IN | sums_out << MODE_SUMS_OUT
    return kernel | stride << 8 | padding << 16 | bits


MODES: tuple[int, ...] = tuple(
    mode_word(kernel, stride, kernel // 2) for kernel in (1, 3) for stride in (1, 2)
)
"""What an array runs. `MODE_BIASED` is for arrays of unsigned inputs, `MODE_RESIDUAL` for those with the adder,
`MODE_SUMS_IN` and `MODE_SUMS_OUT` for those with partial sums; the residual sum needs codes, not `MODE_SUMS_OUT`."""

REGISTERS: tuple[Register, ...] = (
    Register("ID", 0x00, "RO", ID_VALUE, "ASCII 'MACR'"),
    Register("VERSION", 0x04, "RO", VERSION_VALUE, "major in 31:16, minor in 15:0"),
    Register("CONTROL", 0x08, "WO", 0, "start 0, load weights 1, load requantiser 2, soft reset 3"),
    Register("STATUS", 0x0C, "RO", 0, "image busy 0, done 1, error 2, loading 3"),
    Register("ERROR", 0x10, "RO", 0, "error code, see the table of codes"),
    Register("HEIGHT", 0x14, "RW", 0, "image rows"),
    Register("WIDTH", 0x18, "RW", 0, "image columns"),
    Register("C_IN", 0x1C, "RW", 0, "input channels"),
    Register("C_OUT", 0x20, "RW", 0, "output channels"),
    Register(
        "MODE",
        0x24,
        "RW",
        MODE_3X3,
        "kernel 7:0, stride 15:8, padding 23:16, signed input codes 24, residual sum 25, partial sums in 26, out 27",
    ),
    Register("PARAM_WORDS", 0x28, "RW", 0, "words to load: per unit for weights, in all for the requantiser"),
    Register("CYCLES", 0x2C, "RO", 0, "first accepted input beat to last output beat, both counted"),
    Register("MAC_CYCLES", 0x30, "RO", 0, "cycles of CYCLES that issued a compute step"),
    Register("FILL_CYCLES", 0x34, "RO", 0, "cycles before the first compute step"),
    Register("INPUT_STALLS", 0x38, "RO", 0, "cycles between compute steps that waited for input"),
    Register("OUTPUT_STALLS", 0x3C, "RO", 0, "cycles between compute steps that waited for drain or output"),
    Register("DRAIN_CYCLES", 0x40, "RO", 0, "cycles after the last compute step"),
    Register("GEOMETRY", 0x44, "RO", 0, "units 15:0, row engines per unit 23:16, drain 31:24"),
    Register("FORMATS", 0x48, "RO", 0, "bits: weight 7:0, input 14:8 (signed 15), output 22:16 (signed 23)"),
    Register("WEIGHT_DEPTH", 0x4C, "RO", 0, "weight words per unit"),
    Register("ROW_WORDS", 0x50, "RO", 0, "line-buffer words per image row"),
    Register("MAX_CHANNELS", 0x54, "RO", 0, "input channels 15:0, output channels 31:16"),
    Register("PARAM_BASE", 0x58, "RW", 0, "address of the first word to load"),
    Register("WEIGHT_BASE", 0x5C, "RW", 0, "address of the layer's first weight word in every unit"),
    Register("REQUANT_BASE", 0x60, "RW", 0, "address of the layer's first requantiser word"),
    Register("RESIDUAL", 0x64, "RO", 0, "bits of a beat of the residual streams, 0 without a residual adder"),
    Register("RESIDUAL_TABLE0", 0x68, "RW", 0, "what codes 0 to 3 add to the residual stream, a byte each"),
    Register("RESIDUAL_TABLE1", 0x6C, "RW", 0, "what codes 4 to 7 add"),
    Register("RESIDUAL_BOUNDS0", 0x70, "RW", 0, "next codes 1 to 4: the sums that they exceed, a byte each"),
    Register("RESIDUAL_BOUNDS1", 0x74, "RW", 0, "next codes 5 to 7"),
    Register("PARTIAL_C_IN", 0x78, "RO", 0, "input channels of a layer in blocks, 0 without partial sums"),
)

LOAD_REGISTERS = frozenset({"PARAM_WORDS", "PARAM_BASE"})
"""Of a load: they can be written while an image runs, and not while a load is under way. The others the reverse."""

BY_NAME: dict[str, Register] = {register.name: register for register in REGISTERS}
ADDRESS_BITS = 7


def register_table() -> str:
    """The register map and the error codes as Markdown."""
    lines = [
        "# Register map",
        "",
        "AXI4-Lite, 32-bit data, byte offsets. Writes to RO or unmapped addresses and reads of unmapped",
        "addresses are answered SLVERR and change nothing; so are writes to PARAM_WORDS and PARAM_BASE during",
        "a load, and to the other RW registers while an image runs. Commands are always taken: one that is",
        "not possible now only sets ERROR, and what runs goes on.",
        "",
        "| offset | name | access | reset | meaning |",
        "| --- | --- | --- | --- | --- |",
    ]
    lines += [
        f"| 0x{r.offset:02X} | {r.name} | {r.access} | 0x{r.reset:08X} | {r.description} |" for r in REGISTERS
    ]
    lines += ["", "| ERROR | name |", "| --- | --- |"]
    lines += [f"| {error.value} | {error.name} |" for error in Error]
    return "\n".join(lines) + "\n"
