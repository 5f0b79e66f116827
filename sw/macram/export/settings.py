"""What the Tcl scripts need to know of one array: ``settings.tcl`` and ``constraints.xdc``."""

from __future__ import annotations

from dataclasses import dataclass

from macram.export.ports import IMAGE, REGISTERS, Interface, Port, clocks, find_interfaces, question_of
from macram.spec import ArrayConfig

CLOCK_MHZ = 100
"""Array clock. A doubled clock is twice that."""
VENDOR, LIBRARY, VERSION = "macram", "user", "1.0"
"""Of the packaged core: its full name in Vivado's catalogue is ``macram:user:macram_top:1.0``."""
PARTS = ("xczu3eg-sbva484-1-i", "xczu3eg-sbva484-1-e")
BOARDS = ("avnet.com:ultra96v2:*", "em.avnet.com:ultra96v2:*")
WINDOW_BASE, WINDOW_STEP = 0xA000_0000, 0x1_0000
"""First address of the PS's M_AXI_HPM0_FPD, and from one block of registers to the next."""
WINDOW_OF_ARRAY, WINDOW_OF_DMA = 0x1000, 0x1_0000
"""Bytes that a block of registers answers to."""


def dma_of(stream: str) -> str:
    """Name of the DMA that feeds a stream: ``dma_image``, ``dma_param``, ..."""
    return "dma_image" if stream == IMAGE else "dma_" + stream.removeprefix(f"{IMAGE}_")


@dataclass(frozen=True)
class Dma:
    """A DMA of the block design.

    Attributes:
        name: of the instance.
        sends: the array's stream that it feeds.
        receives: the array's stream that it takes, empty if it takes none.
        bits: TDATA width of either stream, 0 where there is none.
    """

    name: str
    sends: str
    receives: str
    bits: tuple[int, int]


def dmas(interfaces: list[Interface], ports: dict[str, Port]) -> list[Dma]:
    """One per stream into the array, that of the image first; it also takes the stream that answers."""
    streams = [one for one in interfaces if one.kind == "axis"]
    answers = {question_of(one.name): one.name for one in streams if one.mode == "master"}

    def bits(name: str) -> int:
        return ports[f"{name}_tdata"].width if name else 0

    found = []
    for name in sorted(
        (one.name for one in streams if one.mode == "slave"), key=lambda name: (name != IMAGE, name)
    ):
        receives = answers.get(name, "")
        found.append(Dma(dma_of(name), name, receives, (bits(name), bits(receives))))
    return found


def windows(names: list[str]) -> dict[str, tuple[int, int]]:
    """Address segment of the block design -> its offset and bytes in the processor's address space.

    Args:
        names: of the DMAs.
    """
    segments = {f"macram_0/{REGISTERS}/reg0": (WINDOW_BASE, WINDOW_OF_ARRAY)}
    for i, name in enumerate(names, start=1):
        segments[f"{name}/S_AXI_LITE/Reg"] = (WINDOW_BASE + i * WINDOW_STEP, WINDOW_OF_DMA)
    return segments


def settings_tcl(array: ArrayConfig, ports: dict[str, Port], sources: list[str]) -> str:
    """The Tcl array ``macram`` that every other script reads.

    Args:
        array: the array, for its name.
        ports: of the exported top level.
        sources: Verilog files relative to the folder, in compile order.

    Raises:
        ValueError: the ports do not form the interfaces that the block design connects.
    """
    interfaces = find_interfaces(ports)
    engines = dmas(interfaces, ports)
    values = {
        "name": _word(array.name),
        "vendor": VENDOR,
        "library": LIBRARY,
        "version": VERSION,
        "parts": _list(PARTS),
        "boards": _list(BOARDS),
        "clock_mhz": str(CLOCK_MHZ),
        "clocks": _list(clocks(ports)),
        "sources": _list(sources),
        "interfaces": _list([_interface(one) for one in interfaces]),
        "dmas": _list(
            [f"{one.name} {one.sends} {one.bits[0]} {{{one.receives}}} {one.bits[1]}" for one in engines]
        ),
        "windows": _list(
            [
                f"{name} 0x{at:08X} 0x{size:X}"
                for name, (at, size) in windows([one.name for one in engines]).items()
            ]
        ),
    }
    return "# Written by macram export; the other scripts are the same for every array.\n" + "".join(
        f"set macram({key}) {value}\n" for key, value in values.items()
    )


def constraints_xdc(ports: dict[str, Port]) -> str:
    """Clocks of the array out of context; in the block design they come from the PS or the clocking wizard."""
    period = 1000 / CLOCK_MHZ
    lines = [
        "# Clocks at the edge of macram_top, for ooc.tcl alone. In the block design the PS sets the clock."
    ]
    for factor, name in enumerate(clocks(ports), start=1):
        lines.append(f"create_clock -name {name} -period {period / factor:.3f} [get_ports {name}]")
    if len(clocks(ports)) > 1:
        lines.append(
            "# Both start at 0 and are related, as one MMCM makes them: paths between them are timed."
        )
    return "\n".join(lines) + "\n"


def _interface(one: Interface) -> str:
    pairs = " ".join(f"{logical} {port}" for logical, port in one.ports.items())
    return f"{{{one.name} {one.kind} {one.mode} {{{pairs}}}}}"


def _list(items: list[str] | tuple[str, ...]) -> str:
    if len(items) == 1:
        return f"{{{items[0]}}}"
    return "{\n" + "".join(f"    {item}\n" for item in items) + "}"


def _word(text: str) -> str:
    """Free text as one Tcl word; array names come from a file that people write."""
    return '"' + "".join("\\" + c if c in '\\"[]${}' else c for c in " ".join(text.split())) + '"'
