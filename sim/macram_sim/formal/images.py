"""Proofs about both ends of the image path: the frame check lets one image in, the drain keeps its offers."""

from __future__ import annotations

from macram_sim.formal.designs import SMALL
from macram_sim.formal.harness import OPENING, stable_stream
from macram_sim.formal.proof import Break, Proof


def _frame() -> str:
    bits = SMALL.stream_bits
    return (
        OPENING
        + f"""
    (* anyconst *) reg [1:0] rows; (* anyconst *) reg [1:0] columns; (* anyconst *) reg [1:0] pixel_beats;
    wire [15:0] height = rows, width = columns, beats = pixel_beats;
    always @* assume (height >= 1 && height <= 2 && width >= 1 && width <= 3 && beats >= 1 && beats <= 2);
    (* anyseq *) wire start; (* anyseq *) wire valid; (* anyseq *) wire ready; (* anyseq *) wire last;
    (* anyseq *) wire [{bits - 1}:0] data;
    wire in_ready, out_valid, fault; wire [{bits - 1}:0] out; wire [2:0] error;
    dut dut(.clk(clk), .rst(rst), .height(height), .width(width), .beats(beats), .start(start),
        .i__payload({{last, data}}), .i__valid(valid),
        .i__ready(in_ready), .o__payload(out), .o__valid(out_valid), .o__ready(ready), .fault(fault), .error(error));
    reg [7:0] left = 0;  // beats of the image that are still to pass
    always @(posedge clk) if (!rst) begin
        if (start) left <= {{6'd0, rows}} * {{6'd0, columns}} * {{6'd0, pixel_beats}};
        else if (valid && in_ready) left <= left - 1;
        assert (out == data);
        assert (out_valid == (valid && left != 0));
        assert (in_ready == (ready && left != 0));
        assert (fault == (valid && in_ready && last != (left == 1)));
        if (fault) assert (error == (last ? 3 : 4));
    end
    always @* assume (!(start && left != 0));  // a START while busy is refused before it gets here
endmodule
"""
    )


def _drain() -> str:
    from macram_hw.gearbox import PixelWord  # noqa: PLC0415

    word = PixelWord(SMALL.output_word_channels * SMALL.output.bits).size
    return (
        OPENING
        + f"""
    (* anyconst *) reg [1023:0] shape;
    (* anyseq *) wire [1023:0] info; (* anyseq *) wire [1023:0] heads; (* anyseq *) wire finished;
    (* anyseq *) wire ready; wire valid; wire [{word - 1}:0] word;
    // START comes only when nothing is left of the image before.
    dut dut(.clk(clk), .rst(rst), .start(1'b0), .shape(shape), .finished(finished), .info(info), .heads(heads),
        .write_en(1'b0), .write(0), .o__valid(valid), .o__ready(ready), .o__payload(word));
"""
        + stable_stream("valid", "ready", "word")
        + "endmodule\n"
    )


IMAGES: tuple[Proof, ...] = (
    Proof(
        "frame",
        "exactly one image passes; TLAST early or missing is named, and only then",
        "frame check",
        _frame,
        15,
        False,
        ("frame",),
        (
            Break("frame.py", "self.o.valid.eq(self.i.valid & is_open)", "self.o.valid.eq(self.i.valid)"),
            Break(
                "frame.py",
                "row_last.eq(pixel_last & (column + 1 == self.width))",
                "row_last.eq(pixel_last & (column == self.width))",
            ),
            Break(
                "frame.py",
                "self.fault.eq(put & (self.i.payload.last != image_last))",
                "self.fault.eq(put & ~self.i.payload.last & image_last)",
            ),
        ),
    ),
    Proof(
        "drain-stable",
        "the drain's words stay on offer, unchanged, until taken",
        "drain",
        _drain,
        2,
        True,
        ("drain",),
        (
            Break("drain.py", "get.en.eq(advance)", "get.en.eq(1)"),
            Break("drain.py", "advance.eq(~valid | self.o.ready)", "advance.eq(1)"),
        ),
    ),
)
