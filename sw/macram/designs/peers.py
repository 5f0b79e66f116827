"""Published low-bit convolution engines, as far as their sources say how fast they are."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class Peer:
    """One published design.

    Attributes:
        name: as it is known.
        device: and clock.
        bits: of weights and activations; rates of bit-serial designs are divided by 9, for 3 x 3 bits.
        macs_per_cycle: multiply-accumulates per cycle of the array's clock.
        macs_per_dsp: of them per DSP slice; None where no DSP is used or the number is not published.
        macs_per_klut: of them per thousand LUTs; None where not published.
        basis: whether the rate is a peak, a sustained one, and how it was come by.
        source: where the figures stand.
    """

    name: str
    device: str
    bits: int
    macs_per_cycle: float
    macs_per_dsp: float | None
    macs_per_klut: float | None
    basis: str
    source: str

    def density(self, kind: str) -> float | None:
        """`macs_per_dsp` for ``dsp``, `macs_per_klut` for ``klut``."""
        return {"dsp": self.macs_per_dsp, "klut": self.macs_per_klut}[kind]

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON."""
        return asdict(self)


PEERS = (
    Peer(
        "CA-SpaceNet's accelerator", "ZU3EG, 100 MHz", 3, 2016, 5.7, None,
        "peak; its 5.99 ms is the layer's MACs over this rate; about 354 DSP from 0.57 GOPS per DSP",
        "CA-SpaceNet, table VI; Jiao et al., ASP-DAC 2021",
    ),
    Peer(
        "SEUer, DAC-SDC 2022 winner", "ZU3EG, 300 MHz target", 4, 1331, 3.7, None,
        "sustained end to end on the board, if run at its 3.3 ns target; 1,944 and 6 per DSP as built",
        "AiArtisan/dac_sdc_2022_champion",
    ),
    Peer(
        "UltraNet, DAC-SDC 2020", "ZU3EG", 4, 448, 1.2, None,
        "sum of SIMD x PE over its layers", "heheda365/ultra_net",
    ),
    Peer("BISMO v2", "ZU3EG, 300 MHz", 1, 2844, None, 61, "peak, from 25,600 binary products", "EECS-NTNU/bismo"),
    Peer("BARVINN", "U250, 250 MHz", 1, 3641, None, None, "peak, from bit-serial products", "arXiv 2301.00290"),
    Peer(
        "DPU B3136", "K26, 300/600 MHz", 8, 1568, 2.86, 34,
        "peak; the vendor's networks reach 27 % and more of it", "AMD Kria documentation",
    ),
    Peer("FINN MVU, 3 x 3 bits", "UltraScale+", 3, 1800, 5, None, "peak of 360 DSP48E2, one clock", "Xilinx/finn"),
    Peer(
        "MixQ filter packing", "UltraScale+", 3, 4320, 12, None,
        "packing table on 360 DSP48E2, not an accelerator", "MatthewLuo7/MixQ_Gen_Accel",
    ),
)  # fmt: skip
"""Rates are of 3-bit products or of the bits named; networks and devices differ, so this is context, not a race."""
