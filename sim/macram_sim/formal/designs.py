"""What the proofs export: real modules of the gateware, small enough to solve.

``python -m macram_sim.formal.designs NAME FOLDER`` writes one of them as Verilog; in a process of its own, so that it
can be another, broken copy of the gateware.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from macram.spec import GROUP, LANES, ArrayConfig, IntFormat

DUT = "dut"
BEAT, WORD = 8, 6
"""Bits of the gearboxes' beats and words: neither divides the other."""
SMALL = ArrayConfig(
    name="proof", units=4, rows=1, drain=1, ingest=1, max_c_in=2, max_c_out=8, weight_depth=12, row_words=4,
    stream_bits=32, weight=IntFormat(2, signed=True), input=IntFormat(2), output=IntFormat(2),
)  # fmt: skip
"""The smallest array with several blocks, tiles and groups."""
UNIT = replace(ArrayConfig(), name="unit", rows=3, max_c_in=1023)
"""Accumulators, formats and tiles of the reference array, on a unit of three row engines, the fewest with an adder."""
WATCHED = UNIT.accumulator.bits + 4
"""Bits of the signals inside a unit that a harness sees: more than their sums need."""
CARRIES = range(LANES - GROUP)
"""Lanes that start from what the group before left."""
LOADS = ArrayConfig()
"""The reference array: words of 2 and of 11 beats, the last of which are not full."""
WATCHED_LOAD = 1024
"""Bits of the signals inside a loader that a harness sees: as many as the widest has, or more."""
DSP_BITS = 48
"""Bits of a DSP slice's result."""
SUMS = replace(SMALL, name="sums", partial_sum_c_in=4096, stream_bits=64)
"""Words of partial sums whose fields are wider than the sums and fill two beats but in part."""
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
CARRY_MEMORY = """
// A carry memory with any contents, but for its last word, which is never written.
module macram_lutram #(parameter WIDTH = 1, DEPTH = 1, ADDR_BITS = 1, LANES = 1, INIT_FILE = "") (
    input wire clk, input wire [LANES-1:0] write_en, input wire [ADDR_BITS-1:0] write_addr,
    input wire [WIDTH-1:0] write_data, input wire [ADDR_BITS-1:0] read_addr, output wire [WIDTH-1:0] read_data
);
    (* anyseq *) wire [WIDTH-1:0] any;
    assign read_data = read_addr == DEPTH - 1 ? {WIDTH{1'b0}} : any;
    always @(posedge clk) if (write_en) assert (write_addr < DEPTH - 1);
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


def _abstract(config: ArrayConfig) -> dict[str, str]:
    from macram_hw.unit import AccumulateControl  # noqa: PLC0415

    widths = {
        "control": AccumulateControl(config).size,
        "weight": config.weight_word_bits,
        "activations": config.line_word_bits,
        "chain": GROUP * config.accumulator.bits,
    }
    text = ABSTRACT
    for name, width in widths.items():
        text = text.replace(f"{{{name}}}", str(width - 1))
    return {"abstract.v": text}


def _drain(config: ArrayConfig) -> dict[str, str]:
    from macram_hw.drain import Drain  # noqa: PLC0415

    return _component(lambda: Drain(config)) | _abstract(config)


def _partial() -> dict[str, str]:
    from macram_hw.partial import PartialSums  # noqa: PLC0415

    return _component(lambda: PartialSums(SUMS))


def _array() -> dict[str, str]:
    from macram_hw.array import Array  # noqa: PLC0415

    return _component(lambda: Array(SMALL)) | _abstract(SMALL)


def _watch(text: str, inside: dict[str, str], shape: str) -> str:
    """The module `DUT` with an output ``watched_NAME`` for each value inside it."""
    before, module = text.split(f"module {DUT}(")
    module, after = module.split("endmodule", 1)
    ports = "".join(f"watched_{name}, " for name in inside)
    wires = "".join(
        f"  output {shape} watched_{name}; assign watched_{name} = {value};\n"
        for name, value in inside.items()
    )
    return f"{before}module {DUT}({ports}{module}{wires}endmodule{after}"


def _connected(text: str, instance: str, port: str) -> str:
    """What lies at a port of an instance."""
    (ports,) = re.findall(rf"\s{instance} \(([^;]*)\);", text)
    (signal,) = re.findall(rf"\.{port}\(([^)]*)\)", ports)
    return str(signal)


def _unit() -> dict[str, str]:
    """A unit whose lanes, lane sums, accumulators and carries are ports too; its carry memories hold anything."""
    from macram_hw.engine import lane_shape  # noqa: PLC0415
    from macram_hw.unit import UnitCore  # noqa: PLC0415

    texts = _component(lambda: UnitCore(UNIT), "macram_add3.v")
    module = texts["dut.v"].split(f"module {DUT}(")[1].split("endmodule")[0]
    inside = {f"acc{k}": f"$signed(acc{k})" for k in range(LANES)}
    for k in range(LANES):
        terms = sorted(set(re.findall(rf"reg .*\b(sum{k}_\d+) =", module)))
        inside[f"sum{k}"] = " + ".join(f"$signed({term})" for term in terms)

    width = lane_shape(UNIT).width
    for row in range(UNIT.rows):
        lanes = _connected(module, f"engine{row}", "lanes")
        inside |= {
            f"engine{row}_{k}": f"$signed({lanes}[{(k + 1) * width - 1}:{k * width}])" for k in range(LANES)
        }
    for k in CARRIES:
        inside[f"read{k}"] = f"$signed({_connected(module, f'carry{k}', 'read_data')})"
        inside[f"write{k}"] = f"$signed({_connected(module, f'carry{k}', 'write_data')})"
    texts["dut.v"] = _watch(texts["dut.v"], inside, f"signed [{WATCHED - 1}:0]")
    return texts | {"carries.v": CARRY_MEMORY}


def _loader() -> dict[str, str]:
    """A loader whose place in the load is a port too."""
    from macram_hw.loader import Loader  # noqa: PLC0415

    texts = _component(lambda: Loader(LOADS))
    inside = {name: name for name in ("shifter", "beat_index", "word_index", "unit")}
    texts["dut.v"] = _watch(texts["dut.v"], inside, f"[{WATCHED_LOAD - 1}:0]")
    return texts


def _engine(kind: str, *models: str) -> dict[str, str]:
    from macram_hw.engine import make_engine  # noqa: PLC0415

    return _component(lambda: make_engine(kind, ArrayConfig(engine=kind)), *models)


def _dsp_engine() -> dict[str, str]:
    """A DSP engine whose slice gives anything; its operands and what it gives are ports too."""
    texts = _engine("dsp48e2")
    inside = {port: f"$signed({_connected(texts['dut.v'], 'dsp', port)})" for port in "ABDP"}
    result = _connected(texts["dut.v"], "dsp", "P")
    anything = f"(* anyseq *) wire [{DSP_BITS - 1}:0] any; assign {result} = any;\n"
    text, slices = re.subn(r"DSP48E2 #\([^;]*\);\n", anything, texts["dut.v"])
    assert slices == 1
    return {"dut.v": _watch(text, inside, f"signed [{DSP_BITS - 1}:0]")}


DESIGNS: dict[str, Callable[[], dict[str, str]]] = {
    "ingest gearbox": _ingest,
    "emit gearbox": _emit,
    "frame check": _frame,
    "registers": _registers,
    "drain": lambda: _drain(SMALL),
    "drain of partial sums": lambda: _drain(SUMS),
    "partial sums": _partial,
    "array": _array,
    "unit": _unit,
    "loader": _loader,
    "engine portable": lambda: _engine("portable"),
    "engine dsp48e2": _dsp_engine,
    "engine soft": lambda: _engine("soft", "macram_add3.v", "macram_product.v"),
}
"""Name -> files of the exported design, the module `DUT` and what it instantiates."""


if __name__ == "__main__":
    for _name, _text in DESIGNS[sys.argv[1]]().items():
        (Path(sys.argv[2]) / _name).write_text(_text)
