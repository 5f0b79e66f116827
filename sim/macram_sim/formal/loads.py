"""Proofs about loads: every word is written once, whole, in its place; a load of no or too many words is refused."""

from __future__ import annotations

from macram.spec import Error, ceil_div
from macram_sim.formal.designs import LOADS, SMALL, WATCHED_LOAD
from macram_sim.formal.harness import OPENING, slice_of
from macram_sim.formal.proof import Break, Proof

_WEIGHT_BEATS = ceil_div(LOADS.weight_word_bits, LOADS.stream_bits)
_REQUANT_BEATS = ceil_div(LOADS.requant_word_bits, LOADS.stream_bits)


def _loader() -> str:
    """Loads of weights and of the requantiser one after the other, any data, gaps, sizes, bases and TLAST faults.

    Where the loader is in a load is watched and shown to be where it should, which makes the proof one of all times.
    """
    from macram_hw.drain import RequantWrite  # noqa: PLC0415
    from macram_hw.unit import WeightWrite  # noqa: PLC0415

    bits, units = LOADS.stream_bits, LOADS.units
    weight, requant = WeightWrite(LOADS), RequantWrite(LOADS)
    most = max(_WEIGHT_BEATS, _REQUANT_BEATS)
    wide = most * bits
    return (
        OPENING
        + f"""
    (* anyseq *) wire start_weights, start_requant, valid, last; (* anyseq *) wire [{bits - 1}:0] data;
    (* anyseq *) wire [31:0] any_words, any_base;
    wire ready, busy, fault, requant_en, is_requant; wire [2:0] error; wire [{units - 1}:0] unit_en;
    wire [{weight.size - 1}:0] weight; wire [{requant.size - 1}:0] requant;
    wire [{WATCHED_LOAD - 1}:0] shifter, beat_index, word_index, unit_bit;
    // Words and base are registers that are locked during a load; what is beyond a memory is refused before.
    reg [31:0] words_were, base_was;
    wire [31:0] words = busy ? words_were : any_words, base = busy ? base_was : any_base;
    always @(posedge clk) begin words_were <= words; base_was <= base; end
    wire to_drain_now = busy ? to_requant : start_requant;
    always @* assume (words >= 1 && words <= 32'hffff && base <= 32'hffff);
    always @* assume (base + words <= (to_drain_now ? {LOADS.requant_depth} : {LOADS.weight_depth}));
    always @* assume (!(start_weights && start_requant) && !(busy && (start_weights || start_requant)));
    dut dut(.clk(clk), .rst(rst), .words(words), .base(base), .start_weights(start_weights),
        .start_requant(start_requant), .i__payload({{last, data}}), .i__valid(valid), .i__ready(ready), .busy(busy),
        .fault(fault), .error(error), .unit_en(unit_en), .weight(weight), .requant_en(requant_en),
        .requant(requant), .to_requant(is_requant), .watched_shifter(shifter), .watched_beat_index(beat_index),
        .watched_word_index(word_index), .watched_unit(unit_bit));

    // The place of the next beat in the load, and the beats of its word so far.
    reg running = 0, to_requant; reg [15:0] beat, word, unit; reg [{wide - 1}:0] so_far;
    wire taken = valid && ready;
    wire [15:0] beats = to_requant ? {_REQUANT_BEATS} : {_WEIGHT_BEATS};
    wire word_ends = beat + 1 == beats;
    wire unit_ends = word_ends && word + 1 == words;
    wire load_ends = unit_ends && (to_requant || unit == {units - 1});
    wire [{wide - 1}:0] whole = so_far | ({{{wide - bits}'d0, data}} << (beat * {bits}));
    // What must be written now: the word that the beat before completed.
    reg to_unit = 0, to_drain = 0; reg [15:0] at_unit; reg [31:0] at_word; reg [{wide - 1}:0] value;
    always @(posedge clk) if (!rst) begin
        to_unit <= taken && word_ends && !to_requant;
        to_drain <= taken && word_ends && to_requant;
        at_unit <= unit; at_word <= base + word; value <= whole;
        if (start_weights || start_requant) begin
            running <= 1; to_requant <= start_requant; beat <= 0; word <= 0; unit <= 0; so_far <= 0;
        end else if (taken) begin
            running <= !last && !load_ends;
            beat <= word_ends ? 0 : beat + 1; so_far <= word_ends ? 0 : whole;
            word <= unit_ends ? 0 : word + word_ends; unit <= unit + unit_ends;
        end
        assert (busy == running && ready == running);
        assert (fault == (taken && last != load_ends));
        if (fault) assert (error == (last ? {int(Error.TLAST_EARLY)} : {int(Error.TLAST_MISSING)}));
        assert (unit_en == (to_unit ? {units}'d1 << at_unit : 0));
        assert (requant_en == to_drain);
        if (to_unit) assert (weight[{slice_of(weight, "addr")}] == at_word
            && weight[{slice_of(weight, "data")}] == value[{LOADS.weight_word_bits - 1}:0]);
        if (to_drain) assert (requant[{slice_of(requant, "addr")}] == at_word
            && requant[{slice_of(requant, "data")}] == value[{LOADS.requant_word_bits - 1}:0]);
        if (running) begin
            assert (beat < beats && word < words && unit < {units} && !(to_requant && unit != 0));
            assert (is_requant == to_requant && beat_index == beat && word_index == word);
            assert (unit_bit == {units}'d1 << unit);
            assert (shifter[{wide - 1}:0] >> (({most} - beat) * {bits}) == so_far);
        end
    end
endmodule
"""
    )


def _commands() -> str:
    """Load commands on an idle array: any number of words, any base, any command, in every cycle."""
    return (
        OPENING
        + f"""
    (* anyseq *) wire [2:0] any_command; (* anyseq *) wire [31:0] any_words, any_base;
    wire busy, loading, done, ready; wire [2:0] error;
    // Words and base are registers that are locked during a load. Images are another proof's.
    reg [31:0] words_were, base_was;
    wire [31:0] words = loading ? words_were : any_words, base = loading ? base_was : any_base;
    always @(posedge clk) begin words_were <= words; base_was <= base; end
    wire [2:0] command = age > 3 ? any_command & 3'b110 : 3'd0;
    dut dut(.clk(clk), .rst(rst), .height(1), .width(1), .c_in(1), .c_out(1), .mode(0), .words(words),
        .param_base(base), .weight_base(0), .requant_base(0), .command(command), .busy(busy), .loading(loading),
        .done(done), .error(error), .i__payload(0), .i__valid(1'b0), .params__payload(0), .params__valid(1'b0),
        .params__ready(ready), .o__ready(1'b0));
    wire [2:0] both = {int(Error.BAD_COMMAND)}, range = {int(Error.BAD_RANGE)};
    wire [31:0] depth = command[1] ? {SMALL.weight_depth} : {SMALL.requant_depth};
    wire [32:0] load_end = {{1'b0, base}} + {{1'b0, words}};
    wire [2:0] verdict = command == 6 ? both : loading ? both : words == 0 || load_end > depth ? range : 0;
    reg commanded = 0, was_loading = 0; reg [2:0] wanted, error_was = 0;
    always @(posedge clk) if (!rst) begin
        commanded <= command != 0; wanted <= verdict; was_loading <= loading; error_was <= error;
        assert (!busy && !done && ready == loading);
        if (!commanded) assert (loading == was_loading && error == error_was);
        else begin
            assert (loading == (was_loading || wanted == 0));
            // The first error is kept until a command finds the array idle.
            assert (error == (was_loading && error_was != 0 ? error_was : wanted));
        end
    end
endmodule
"""
    )


_LOADER, _ARRAY = "loader.py", "array.py"

LOADING: tuple[Proof, ...] = (
    Proof(
        "loader",
        "every word of a load is written once, whole, to its memory and address, nothing else is; TLAST faults named",
        "loader",
        _loader,
        3,
        True,
        ("loader",),
        (
            Break(
                _LOADER,
                "unit_done.eq(word_done & (word_index + 1 == self.words))",
                "unit_done.eq(word_done & (word_index == self.words))",
            ),
            Break(
                _LOADER, "self.requant_en.eq(word_done & to_requant)", "self.requant_en.eq(put & to_requant)"
            ),
            Break(
                _LOADER, "beat_index.eq(0), word_index.eq(0), unit.eq(1),", "word_index.eq(0), unit.eq(1),"
            ),
            Break(_LOADER, "with m.If(all_done | self.fault):", "with m.If(all_done):"),
            Break(_LOADER, "self.weight.addr.eq(self.base + word_index)", "self.weight.addr.eq(word_index)"),
            Break(
                _LOADER,
                "shifter[-beat * weight_beats :][: config.weight_word_bits]",
                "shifter[: config.weight_word_bits]",
            ),
            Break(_LOADER, "Mux(self.i.payload.last, Error.TLAST_EARLY", "Mux(all_done, Error.TLAST_EARLY"),
        ),
    ),
    Proof(
        "load-commands",
        "a load of no words, beyond its memory, beside another or with another command is refused by its error",
        "array",
        _commands,
        9,
        False,
        ("array", "loader"),
        (
            Break(_ARRAY, "with m.Elif((self.words == 0) | beyond", "with m.Elif(beyond"),
            Break(_ARRAY, "load_end.eq(self.param_base + self.words)", "load_end.eq(self.words)"),
            Break(
                _ARRAY,
                "to_requant, load_end = Signal(), Signal(33)",
                "to_requant, load_end = Signal(), Signal(32)",
            ),
            Break(_ARRAY, "with m.If((self.command & (self.command - 1)).any()):", "with m.If(0):"),
            Break(_ARRAY, "with m.If(self.loading | (self.busy & takes)):", "with m.If(0):"),
        ),
    ),
)
