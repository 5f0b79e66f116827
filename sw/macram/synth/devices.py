"""FPGA devices: what they hold, how Yosys is told about them, and how its cells are counted."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

RESOURCES = ("lut", "ff", "dsp", "bram")
LUT_SHARE = 0.8
"""Share of the LUTs that a design may take: above it routing gets slow or fails."""

_LUTS_XILINX = {f"LUT{inputs}": {"lut": 1.0} for inputs in range(1, 7)}
_FLIP_FLOPS = {name: {"ff": 1.0} for name in ("FDRE", "FDSE", "FDCE", "FDPE", "LDCE", "LDPE")}
_LUT_MEMORIES = {
    "LUT6_2": 1, "SRL16E": 1, "SRLC16E": 1, "SRLC32E": 1, "RAM32X1S": 1, "RAM64X1S": 1, "RAM32X1D": 2, "RAM64X1D": 2,
    "RAM128X1S": 2, "RAM128X1D": 4, "RAM256X1S": 4, "RAM256X1D": 8, "RAM32M": 4, "RAM64M": 4, "RAM32M16": 8,
    "RAM64M8": 8, "RAM32X16DR8": 8, "RAM64X8SW": 8,
}  # fmt: skip
_FREE_XILINX = (
    "INV",
    "CARRY4",
    "CARRY8",
    "MUXF7",
    "MUXF8",
    "MUXF9",
    "BUFG",
    "BUFGCE",
    "IBUF",
    "OBUF",
    "GND",
    "VCC",
)

XILINX_CELLS: Mapping[str, Mapping[str, float]] = {
    **_LUTS_XILINX,
    **_FLIP_FLOPS,
    **{name: {"lut": float(luts)} for name, luts in _LUT_MEMORIES.items()},
    **{name: {} for name in _FREE_XILINX},
    "DSP48E2": {"dsp": 1.0},
    "RAMB36E2": {"bram": 1.0},
    "RAMB18E2": {"bram": 0.5},
}
"""UltraScale+: a LUT of any size, a shift register and each LUT of a LUT memory is one LUT; an inverter goes into
its neighbours; carry and wide-mux cells have places of their own. Block RAM in units of RAMB36."""

ECP5_CELLS: Mapping[str, Mapping[str, float]] = {
    "LUT4": {"lut": 1.0},
    "CCU2C": {"lut": 2.0},
    "TRELLIS_DPR16X4": {"lut": 6.0},
    "PFUMX": {},
    "L6MUX21": {},
    "TRELLIS_FF": {"ff": 1.0},
    "DP16KD": {"bram": 1.0},
    "PDPW16KD": {"bram": 1.0},
    "MULT18X18D": {"dsp": 1.0},
    "EHXPLLL": {},
    "TRELLIS_IO": {},
    "GND": {},
    "VCC": {},
}
"""ECP5: a carry cell takes two LUT4; a 16 x 4 memory takes four and the write port's two. Block RAM in units of
18 kbit."""


@dataclass(frozen=True, slots=True)
class Device:
    """A device and its synthesis.

    Attributes:
        capacity: LUT, FF, DSP and block RAM that it has.
        cells: cell type of Yosys -> what one takes of each resource.
        synth: the Yosys command that maps to it, without ``-top``.
        unit, modules, whole: what is added to it for the unit, as one module; for the rest, module by module; for
            everything as one module.
    """

    name: str
    title: str
    capacity: Mapping[str, int]
    cells: Mapping[str, Mapping[str, float]]
    synth: str
    unit: str
    modules: str
    whole: str

    def count(self, cells: Mapping[str, int]) -> dict[str, float]:
        """Resources of a number of cells per type; types that begin with ``$`` are bookkeeping of Yosys.

        Raises:
            ValueError: a type is not in the device's table.
        """
        total = dict.fromkeys(RESOURCES, 0.0)
        for cell, number in cells.items():
            if cell.startswith("$"):
                continue
            if cell not in self.cells:
                raise ValueError(
                    f"{self.name}: cell {cell} has no entry in macram.synth.devices; add what it takes"
                )
            for resource, each in self.cells[cell].items():
                total[resource] += number * each
        return total

    def limit(self, resource: str) -> int:
        """What a design may take of a resource: `LUT_SHARE` of the LUTs, all of the others."""
        return int(self.capacity[resource] * (LUT_SHARE if resource == "lut" else 1.0))

    def excess(self, used: Mapping[str, float]) -> list[str]:
        """A phrase for each resource of which ``used`` takes more than the device allows."""
        return [
            f"{used[key]:,.{1 if used[key] % 1 else 0}f} {key.upper()} of {self.limit(key):,}"
            for key in RESOURCES
            if used[key] > self.limit(key)
        ]


DEVICES = {
    device.name: device
    for device in (
        Device(
            "xczu3eg",
            "AMD Zynq UltraScale+ ZU3EG (Ultra96v2)",
            {"lut": 70_560, "ff": 141_120, "dsp": 360, "bram": 216},
            XILINX_CELLS,
            "synth_xilinx -family xcup -noiopad -noclkbuf",
            unit=" -flatten",
            modules="",
            whole=" -flatten",
        ),
        Device(
            "ecp5-85k",
            "Lattice ECP5-85F",
            {"lut": 83_640, "ff": 83_640, "dsp": 156, "bram": 208},
            ECP5_CELLS,
            "synth_ecp5",
            unit=" -nodsp",
            modules=" -noflatten",
            whole=" -nodsp",
        ),
    )
}
"""Known devices by the names that the command line takes. In an ECP5's unit multipliers are forbidden: Yosys would
spend one of the 156 on each 3-bit product."""
