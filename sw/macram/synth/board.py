"""The ECP5 evaluation board: part, pins, and the PLL's dividers for a clock."""

from __future__ import annotations

PART = "LFE5UM5G-85F-8BG381C"
"""The board's FPGA; nextpnr's own names for it are `NEXTPNR`."""
NEXTPNR = ("--um5g-85k", "--package", "CABGA381", "--speed", "8")
OSCILLATOR_MHZ = 12
LEDS = ("A13", "A12", "B19", "A18", "B18", "C17", "A17", "B17")
VCO_MHZ = (400, 800)
"""Range of the PLL's oscillator."""


def constraints() -> str:
    """Pins and the oscillator's frequency (LPF)."""
    pins = {"clk12": ("A10", "LVCMOS33"), "button_n": ("P4", "LVCMOS33")}
    pins |= {f"led_n[{index}]": (site, "LVCMOS25") for index, site in enumerate(LEDS)}
    lines = [f'FREQUENCY PORT "clk12" {OSCILLATOR_MHZ} MHZ;']
    for port, (site, standard) in pins.items():
        lines += [f'LOCATE COMP "{port}" SITE "{site}";', f'IOBUF PORT "{port}" IO_TYPE={standard};']
    return "\n".join(lines) + "\n"


def pll_dividers(mhz: int) -> dict[str, int]:
    """Parameters of the board's top for an array clock of ``mhz``.

    Raises:
        ValueError: the PLL cannot make it.
    """
    lo, hi = VCO_MHZ
    # The phase detector runs at 4 MHz, of which every multiple of 4 MHz can be made.
    reference = OSCILLATOR_MHZ // 3
    if mhz % reference or not 1 <= mhz // reference <= 80:
        raise ValueError(
            f"the clock must be a multiple of {reference} MHz up to {80 * reference}, not {mhz} MHz"
        )
    output = hi // mhz
    if not lo <= output * mhz or output > 128:
        raise ValueError(
            f"the PLL's oscillator runs at {lo} to {hi} MHz, which no divider takes to {mhz} MHz"
        )
    return {"CLKI_DIV": 3, "CLKFB_DIV": mhz // reference, "CLKOP_DIV": output}
