"""The ports of the exported top level, and the bus interfaces that their names say they form."""

from __future__ import annotations

import re
from dataclasses import dataclass

CLOCKS = ("aclk", "aclk2x")
"""Clock inputs in order; the second is there only where DSP slices run at twice the array's clock."""
RESET = "aresetn"
REGISTERS = "s_axi"
"""The AXI4-Lite interface of the registers."""
IMAGE = "s_axis"
"""The stream of the image; every other stream into the array has this name and a suffix."""
RESULT = "m_axis"
"""What the image becomes. A further stream out of the array answers the one into it with the same suffix."""
LITE = (
    "awaddr", "awprot", "awvalid", "awready", "wdata", "wstrb", "wvalid", "wready", "bresp", "bvalid", "bready",
    "araddr", "arprot", "arvalid", "arready", "rdata", "rresp", "rvalid", "rready",
)  # fmt: skip
STREAM = ("tdata", "tvalid", "tready", "tlast")

DECLARATION = re.compile(r"^\s*(input|output)\s+(?:\[(\d+):0\]\s+)?(\w+)\s*;", re.MULTILINE)


@dataclass(frozen=True)
class Port:
    """A port of the top level: ``input`` or ``output``, and its bits."""

    direction: str
    width: int


@dataclass(frozen=True)
class Interface:
    """A bus interface of the top level.

    Attributes:
        name: common prefix of its ports.
        kind: ``axilite`` or ``axis``.
        mode: ``master`` or ``slave``.
        ports: logical name as in the bus definition -> port.
    """

    name: str
    kind: str
    mode: str
    ports: dict[str, str]


def read_ports(verilog: str, module: str) -> dict[str, Port]:
    """The ports of a module in exported Verilog, by name.

    Raises:
        ValueError: the text has no such module.
    """
    start = re.search(rf"^module {module}\b", verilog, re.MULTILINE)
    if start is None:
        raise ValueError(f"the Verilog has no module {module}; export it again")
    body = verilog[start.start() : verilog.index("endmodule", start.start())]
    return {name: Port(direction, int(msb or 0) + 1) for direction, msb, name in DECLARATION.findall(body)}


def find_interfaces(ports: dict[str, Port]) -> list[Interface]:
    """The registers, then the streams in order of their names; every port but clocks and reset is in one.

    Raises:
        ValueError: a clock, the reset or part of an interface is missing, or a port belongs to none.
    """
    for name in (CLOCKS[0], RESET):
        if name not in ports:
            raise ValueError(f"the top level has no port {name}")
    rest = set(ports) - {*CLOCKS, RESET}
    streams = sorted(name.removesuffix("_tdata") for name in rest if name.endswith("_tdata"))
    found = [_interface(REGISTERS, "axilite", LITE, "slave", ports)]
    for stream in streams:
        mode = "slave" if stream.startswith("s_") else "master"
        found.append(_interface(stream, "axis", STREAM, mode, ports))
    if loose := sorted(rest - {port for interface in found for port in interface.ports.values()}):
        raise ValueError(f"port {loose[0]} of the top level belongs to no bus interface")
    for name in (IMAGE, RESULT):
        if name not in streams:
            raise ValueError(f"the top level has no stream {name}")
    for name in streams:
        if name.startswith("m_") and question_of(name) not in streams:
            raise ValueError(f"the stream {name} answers no stream {question_of(name)}; no DMA can take it")
    return found


def question_of(answer: str) -> str:
    """The stream into the array that a stream out of it answers: the same DMA has both."""
    return IMAGE + answer.removeprefix(RESULT)


def clocks(ports: dict[str, Port]) -> list[str]:
    """``aclk``, and ``aclk2x`` where the array has it."""
    return [name for name in CLOCKS if name in ports]


def _interface(
    name: str, kind: str, signals: tuple[str, ...], mode: str, ports: dict[str, Port]
) -> Interface:
    mapped = {signal.upper(): f"{name}_{signal}" for signal in signals}
    if missing := [port for port in mapped.values() if port not in ports]:
        raise ValueError(f"the top level has no port {missing[0]} of the interface {name}")
    valid = ports[f"{name}_{'awvalid' if kind == 'axilite' else 'tvalid'}"].direction
    if valid != ("input" if mode == "slave" else "output"):
        raise ValueError(f"interface {name} is a {mode} by its name, but its valid is an {valid}")
    return Interface(name, kind, mode, mapped)
