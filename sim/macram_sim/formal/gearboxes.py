"""Proofs about the gearboxes: offers stay until taken; every bit comes out once, in its place, nothing else does."""

from __future__ import annotations

from macram_sim.formal.designs import BEAT, WORD
from macram_sim.formal.harness import OPENING, stable_stream
from macram_sim.formal.proof import Break, Proof

_INGEST_PORTS = f"""
    (* anyconst *) reg [15:0] beats; (* anyconst *) reg [15:0] words;
    (* anyseq *) wire [{BEAT - 1}:0] beat; (* anyseq *) wire in_valid; (* anyseq *) wire out_ready;
    wire in_ready, out_valid; wire [{WORD - 1}:0] word;
    dut dut(.clk(clk), .rst(rst), .beats_per_pixel(beats), .words_per_pixel(words), .i__payload(beat),
        .i__valid(in_valid), .i__ready(in_ready), .o__payload(word), .o__valid(out_valid), .o__ready(out_ready));
"""
_EMIT_PORTS = f"""
    (* anyconst *) reg [15:0] beats; (* anyconst *) reg [15:0] words;
    (* anyseq *) wire [{WORD - 1}:0] word; (* anyseq *) wire in_valid; (* anyseq *) wire out_ready;
    (* anyseq *) wire last;
    wire in_ready, out_valid; wire [{BEAT - 1}:0] beat; wire tlast; wire pixel_last;
    dut dut(.clk(clk), .rst(rst), .beats_per_pixel(beats), .i__payload({{last, pixel_last, word}}),
        .i__valid(in_valid), .i__ready(in_ready), .o__payload({{tlast, beat}}), .o__valid(out_valid),
        .o__ready(out_ready));
"""
_LIMITS = f"""
    always @* assume (beats >= 1 && beats <= 2 && words >= 1 && words <= 3);
    // The last word holds a bit of the beats, and the last beat a bit of the words.
    always @* assume ((words - 1) * {WORD} < beats * {BEAT} && (beats - 1) * {BEAT} < words * {WORD});
"""
_TAG = f"""
    // One bit of one pixel, any of them: its place among the beats and among the words.
    (* anyconst *) reg tag_pixel; (* anyconst *) reg tag_beat; (* anyconst *) reg [1:0] tag_word;
    (* anyconst *) reg [2:0] beat_bit; (* anyconst *) reg [2:0] word_bit;
    always @* assume (beat_bit < {BEAT} && word_bit < {WORD});
    wire [4:0] bit_of_beats = tag_beat * {BEAT} + beat_bit, bit_of_words = tag_word * {WORD} + word_bit;
    always @* assume (bit_of_beats == bit_of_words);
    reg [3:0] in_at = 0, in_pixel = 0, out_at = 0, out_pixel = 0;
    reg seen = 0, bit_in;
"""


_ORDER = """
    always @* assume (tag_{given} < {given}s);
    wire in_last = in_at + 1 == {taken}s, out_last = out_at + 1 == {given}s;
    always @(posedge clk) if (!rst) begin
        if (in_valid && in_ready) begin
            in_at <= in_last ? 0 : in_at + 1;
            in_pixel <= in_pixel + in_last;
            if (in_pixel == tag_pixel && in_at == tag_{taken}) begin seen <= 1; bit_in <= {taken}[{taken}_bit]; end
        end
        if (out_valid && out_ready) begin
            out_at <= out_last ? 0 : out_at + 1;
            out_pixel <= out_pixel + out_last;
            if (out_pixel == tag_pixel && out_at == tag_{given}) begin
                if (tag_{taken} < {taken}s) begin
                    assert (seen);
                    assert ({given}[{given}_bit] == bit_in);
                end else begin
                    assert (in_pixel > tag_pixel);
                    assert (!{given}[{given}_bit]);
                end
            end
        end
        // A pixel that is inside is on offer, so none can be lost; and at most one is.
        assert (in_pixel == out_pixel || out_valid);
        assert (in_pixel <= out_pixel + 1);
    end
"""
_TLAST = """
    assign pixel_last = in_last;
    reg tag_last, stalled = 0, was_last;
    always @(posedge clk) if (!rst) begin
        stalled <= out_valid && !out_ready; was_last <= tlast;
        if (stalled) assert (tlast == was_last);
        if (in_valid && in_ready && in_pixel == tag_pixel && pixel_last) tag_last <= last;
        // TLAST on the last beat of a pixel that is the image's last, and nowhere else.
        if (out_valid && out_ready) begin
            if (!out_last) assert (!tlast);
            else if (out_pixel == tag_pixel) assert (tlast == tag_last);
        end
    end
"""


def _ingest_stable() -> str:
    return OPENING + _INGEST_PORTS + stable_stream("out_valid", "out_ready", "word") + "endmodule\n"


def _emit_stable() -> str:
    free = "(* anyseq *) wire any_pixel_last; assign pixel_last = any_pixel_last;\n"
    return OPENING + _EMIT_PORTS + free + stable_stream("out_valid", "out_ready", "beat") + "endmodule\n"


def _ingest_order() -> str:
    return (
        OPENING + _INGEST_PORTS + _LIMITS + _TAG + _ORDER.format(taken="beat", given="word") + "endmodule\n"
    )


def _emit_order() -> str:
    order = _ORDER.format(taken="word", given="beat")
    return OPENING + _EMIT_PORTS + _LIMITS + _TAG + order + _TLAST + "endmodule\n"


_GEARBOX = "gearbox.py"
_INGEST_BREAKS = (
    Break(_GEARBOX, "(level_after <= self._word)", "(level_after <= self._word + 2)"),
    Break(
        _GEARBOX,
        "Mux(put, self.i.payload, Const(0, self._beat)) << level_after",
        "self.i.payload << level_after",
    ),
    Break(
        _GEARBOX,
        "pixel_done.eq(taken & (words_out == final_word))",
        "pixel_done.eq(taken & (words_out + 1 == final_word))",
    ),
)
_EMIT_BREAKS = (
    Break(_GEARBOX, "(level_after <= self._beat)", "(level_after <= self._beat + 4)"),
    Break(
        _GEARBOX,
        "Mux(put, self.i.payload.data, Const(0, self._word)) << level_after",
        "self.i.payload.data << level_after",
    ),
    Break(_GEARBOX, "self.o.payload.last.eq(last_beat & image_last)", "self.o.payload.last.eq(image_last)"),
)

GEARBOXES: tuple[Proof, ...] = (
    Proof(
        "ingest-stable",
        "line-buffer words stay on offer, unchanged, until taken",
        "ingest gearbox",
        _ingest_stable,
        2,
        True,
        ("gearbox", "array"),
        (
            Break(
                _GEARBOX,
                "(level >= self._word) | (beats_in == self.beats_per_pixel)",
                "(level >= self._word) | (beats_in == self.i.payload)",
            ),
            Break(
                _GEARBOX, "Mux(put, self.i.payload, Const(0, self._beat)) << level_after", "self.i.payload"
            ),
        ),
    ),
    Proof(
        "ingest-order",
        "every bit of every beat reaches its place in its word, once; nothing is lost or invented",
        "ingest gearbox",
        _ingest_order,
        11,
        False,
        ("gearbox", "array"),
        _INGEST_BREAKS,
    ),
    Proof(
        "emit-stable",
        "output beats stay on offer, unchanged, until taken",
        "emit gearbox",
        _emit_stable,
        2,
        True,
        ("gearbox", "array", "top"),
        (
            Break(_GEARBOX, "(level >= self._beat) | complete", "(level >= self._beat) | self.i.valid"),
            Break(
                _GEARBOX,
                "Mux(put, self.i.payload.data, Const(0, self._word)) << level_after",
                "self.i.payload.data",
            ),
            Break(
                _GEARBOX,
                "(~complete | pixel_done) & (level_after <= self._beat)",
                "(level_after <= self._beat)",
            ),
        ),
    ),
    Proof(
        "emit-order",
        "every bit of every word reaches its place in its beat, once; TLAST ends the image",
        "emit gearbox",
        _emit_order,
        11,
        False,
        ("gearbox", "array", "top"),
        _EMIT_BREAKS,
    ),
)
