"""What the proofs export: real modules of the gateware, small enough to solve.

``python -m macram_sim.formal.designs NAME FOLDER`` writes one of them as Verilog; in a process of its own, so that it
can be another, broken copy of the gateware.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

from macram.spec import GROUP, ArrayConfig, IntFormat

DUT = "dut"
BEAT, WORD = 8, 6
"""Bits of the gearboxes' beats and words: neither divides the other."""
SMALL = ArrayConfig(
    name="proof", units=4, rows=1, drain=1, ingest=1, max_c_in=2, max_c_out=8, weight_depth=12, row_words=4,
    stream_bits=32, weight=IntFormat(2, signed=True), input=IntFormat(2), output=IntFormat(2),
)  # fmt: skip
"""The smallest array with several blocks, tiles and groups."""
ABSTRACT = """
// Memories and units with any contents: what holds with them holds whatever is stored and computed.
module macram_ram #(parameter WIDTH = 1, DEPTH = 1, ADDR_BITS = 1, LANES = 1, INIT_FILE = "") (
    input wire clk, input wire [LANES-1:0] write_en, input wire [ADDR_BITS-1:0] write_addr,
    input wire [WIDTH-1:0] write_data, input wire read_en, input wire [ADDR_BITS-1:0] read_addr,
    output reg [WIDTH-1:0] read_data
);
    (* anyseq *) wire [WIDTH-1:0] any;
    always @(posedge clk) if (read_en) read_data <= any;
endmodule
module macram_lutram #(parameter WIDTH = 1, DEPTH = 1, ADDR_BITS = 1, LANES = 1, INIT_FILE = "") (
    input wire clk, input wire [LANES-1:0] write_en, input wire [ADDR_BITS-1:0] write_addr,
    input wire [WIDTH-1:0] write_data,
    input wire [ADDR_BITS-1:0] read_addr, output wire [WIDTH-1:0] read_data
);
    (* anyseq *) wire [WIDTH-1:0] any;
    assign read_data = any;
endmodule
module macram_unit(
    input wire clk, rst, shift, input wire [{control}:0] control, input wire [{weight}:0] weight,
    input wire [{activations}:0] activations, input wire [{chain}:0] chain_i, output wire [{chain}:0] chain_o
);
    (* anyseq *) wire [{chain}:0] any;
    assign chain_o = any;
endmodule
"""


def _component(make: Callable[[], object], *extra: str) -> dict[str, str]:
    from macram_hw.export import component_verilog, model_path  # noqa: PLC0415

    texts = {"dut.v": component_verilog(make(), DUT)}
    texts |= {name: model_path(name).read_text() for name in extra}
    return texts


def _ingest() -> dict[str, str]:
    from macram_hw.gearbox import IngestGearbox  # noqa: PLC0415

    return _component(lambda: IngestGearbox(beat_bits=BEAT, word_bits=WORD))


def _emit() -> dict[str, str]:
    from macram_hw.gearbox import EmitGearbox  # noqa: PLC0415

    return _component(lambda: EmitGearbox(beat_bits=BEAT, word_bits=WORD))


def _frame() -> dict[str, str]:
    from macram_hw.frame import FrameCheck  # noqa: PLC0415

    return _component(lambda: FrameCheck(beat_bits=SMALL.stream_bits))


def _registers() -> dict[str, str]:
    from macram_hw.axi_lite import AxiLiteRegisters  # noqa: PLC0415

    return _component(AxiLiteRegisters)


def _abstract() -> dict[str, str]:
    from macram_hw.unit import AccumulateControl  # noqa: PLC0415

    widths = {
        "control": AccumulateControl(SMALL).size,
        "weight": SMALL.weight_word_bits,
        "activations": SMALL.line_word_bits,
        "chain": GROUP * SMALL.accumulator.bits,
    }
    text = ABSTRACT
    for name, width in widths.items():
        text = text.replace(f"{{{name}}}", str(width - 1))
    return {"abstract.v": text}


def _drain() -> dict[str, str]:
    from macram_hw.drain import Drain  # noqa: PLC0415

    return _component(lambda: Drain(SMALL)) | _abstract()


def _array() -> dict[str, str]:
    from macram_hw.array import Array  # noqa: PLC0415

    return _component(lambda: Array(SMALL)) | _abstract()


def _engine() -> dict[str, str]:
    from macram_hw.engine import make_engine  # noqa: PLC0415

    config = ArrayConfig()
    return _component(lambda: make_engine(config.engine, config))


DESIGNS: dict[str, Callable[[], dict[str, str]]] = {
    "ingest gearbox": _ingest,
    "emit gearbox": _emit,
    "frame check": _frame,
    "registers": _registers,
    "drain": _drain,
    "array": _array,
    "engine": _engine,
}
"""Name -> files of the exported design, the module `DUT` and what it instantiates."""


if __name__ == "__main__":
    for _name, _text in DESIGNS[sys.argv[1]]().items():
        (Path(sys.argv[2]) / _name).write_text(_text)
