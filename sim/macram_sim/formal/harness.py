"""Pieces of harness text that several proofs use."""

from __future__ import annotations

from typing import Any

OPENING = """\
module top(input wire clk);
    reg [15:0] age = 0;
    always @(posedge clk) if (!(&age)) age <= age + 1;
    wire rst = age == 0;
    wire live = age > 1;  // reset is over and a past cycle exists
"""


def stable_stream(valid: str, ready: str, payload: str) -> str:
    """AXI4-Stream: what is offered stays as it is until it is taken, and nothing is offered unasked after reset."""
    return f"""
    reg waits = 0;
    reg [$bits({payload})-1:0] offered;
    always @(posedge clk) begin
        waits <= {valid} && !{ready} && !rst;
        offered <= {payload};
        if (waits && !rst) begin
            assert ({valid});
            assert ({payload} == offered);
        end
    end
"""


def slice_of(layout: Any, name: str) -> str:
    """Verilog range of a field of an Amaranth layout."""
    field = layout[name]
    return f"{field.offset + field.width - 1}:{field.offset}"


def packed(layout: Any, values: dict[str, str]) -> str:
    """A Verilog concatenation of all fields of an Amaranth layout, each the low bits of the vector of that name."""
    fields = sorted(((field.offset, field.width, str(name)) for name, field in layout), reverse=True)
    return "{" + ", ".join(f"{values[name]}[{width - 1}:0]" for _, width, name in fields) + "}"
