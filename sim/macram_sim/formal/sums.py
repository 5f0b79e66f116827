"""Proofs about partial sums: they come back as they left, and the drain adds each one to its own sum, once."""

from __future__ import annotations

from macram.spec import GROUP, Error
from macram_sim.formal.designs import SUMS
from macram_sim.formal.harness import OPENING, packed, slice_of, stable_stream
from macram_sim.formal.proof import Break, Proof

WORDS = 3
"""Most words of the image of `_return`."""
BEATS = SUMS.sum_word_beats
FINISHED = 2
"""Finished sums of `_added`."""
_FIELDS = [f"{at * SUMS.sum.bits} +: {SUMS.sum.bits}" for at in range(GROUP * SUMS.drain)]


def _return() -> str:
    """What a run gives is what the next takes: the output led back into the parameter stream, with any gaps.

    TLAST may be wrong on any beat. What else the two streams carry is anything.
    """
    bits, word = SUMS.stream_bits, len(_FIELDS) * SUMS.sum.bits
    return (
        OPENING
        + f"""
    (* anyconst *) reg [1:0] words, tag;  // of the image, and any one of them
    always @* assume (words >= 1 && words <= {WORDS} && tag < words);
    (* anyseq *) wire comes, wanted, go, flip, codes_valid; (* anyseq *) wire [{bits}:0] codes;
    (* anyseq *) wire [{word - 1}:0] sums;
    wire free, ready, out_valid, whole, fault, codes_ready; wire [2:0] error; wire [{word - 1}:0] back;
    wire [{bits - 1}:0] data; wire tlast; wire [{bits}:0] beat = {{tlast, data}};
    wire out_ready = ready && go;
    reg [3:0] given = 0, passed = 0, taken = 0;  // words, beats, words
    wire give = comes && free, pass = out_valid && out_ready, take = whole && wanted && age > 3;
    wire image_last = taken + 1 == words;
    dut dut(.clk(clk), .rst(rst), .start(age == 2), .takes(1'b1), .gives(1'b1), .last(image_last),
        .params__payload({{tlast ^ flip, data}}), .params__valid(out_valid && go), .params__ready(ready),
        .loads__ready(1'b0), .codes__payload(codes), .codes__valid(codes_valid), .codes__ready(codes_ready),
        .o__payload({{tlast, data}}), .o__valid(out_valid), .o__ready(out_ready),
        .addends__payload(back), .addends__valid(whole), .addends__ready(wanted && age > 3),
        .results__payload({{given + 4'd1 == words, sums}}), .results__valid(comes), .results__ready(free),
        .fault(fault), .error(error));
    always @* assume (!(comes && (given == words || age <= 3)));
    reg [{word - 1}:0] kept; reg wrong = 0, named = 0;
    always @(posedge clk) if (!rst) begin
        given <= given + give; passed <= passed + pass; taken <= taken + take;
        if (give && given == tag) kept <= sums;
        // Where every word is: a giver that is free has given all its beats, a taker that offers has all of a word's.
        assert (out_valid == (passed != given * {BEATS}));
        assert (free == !out_valid);
        assert (whole == (passed == (taken + 1) * {BEATS}));
        assert (ready == (age > 2 && !whole && taken != words));
        assert (!codes_ready);
        if (whole && taken == tag) assert (back == kept);
        if (out_valid) assert (tlast == (passed + 1 == words * {BEATS}));
        // A wrong TLAST is named when its word is taken, or before; a right one is not.
        wrong <= (wrong && !take) || (pass && flip);
        named <= (named && !take) || (fault && !take);
        if (take) assert ((named || fault) == wrong);
        if (fault) assert (error == (take && image_last ? {int(Error.TLAST_MISSING)} : {int(Error.TLAST_EARLY)}));
    end
"""
        + stable_stream("out_valid", "out_ready", "beat")
        + "endmodule\n"
    )


def _added() -> str:
    """Finished sums one after the other; any heads, addends, gaps and stalls; with addends, with results or both."""
    from macram_hw.drain import Drain  # noqa: PLC0415
    from macram_hw.partial import SumWord  # noqa: PLC0415
    from macram_hw.sequencer import GroupInfo  # noqa: PLC0415

    cycles, total, head = SUMS.drain_cycles, SUMS.sum, SUMS.accumulator
    addends, heads = len(_FIELDS) * total.bits, len(_FIELDS) * head.bits
    info, word, drain = GroupInfo(SUMS), SumWord(SUMS), Drain(SUMS)
    fields = {str(name): str(name) for name, _ in info} | {"edge": "at_edge"}
    # Triples are another matter: with partial sums there are none.
    fields |= dict.fromkeys(("triple", "inner", "unloaded"), "no")
    free = "".join(
        f"    (* anyseq *) wire [{info[name].width - 1}:0] {wire};\n"
        for name, wire in fields.items()
        if wire != "no"
    )
    wide = total.bits + 2
    checks = ""
    for at, field in enumerate(_FIELDS):
        low, high = at * head.bits, (at + 1) * head.bits - 1
        checks += (
            f"    wire signed [{head.bits - 1}:0] head{at} = heads[{high}:{low}];\n"
            f"    wire signed [{total.bits - 1}:0] addend{at} = addends[{field}], sum{at} = results[{field}];\n"
            f"    wire signed [{wide - 1}:0] exact{at} = head{at} + addend{at};\n"
            # The range of a sum is that of all its products, of which these are some.
            f"    always @* assume (exact{at} >= {total.lo} && exact{at} <= {total.hi});\n"
            f"    always @(posedge clk) if (results_valid && !rst) assert (sum{at} == exact{at});\n"
        )
    return (
        OPENING
        + free
        + f"""
    (* anyconst *) reg takes, gives; (* anyconst *) reg [{drain.shape.shape().size - 1}:0] shape;
    always @* assume (takes || gives);
    (* anyseq *) wire finished, comes, results_ready, out_ready; (* anyseq *) wire [{addends - 1}:0] any_addends;
    (* anyseq *) wire [{heads - 1}:0] heads;
    wire no = 0; wire addends_ready, results_valid, shift, credit, last;
    wire [{word.size - 1}:0] offer; wire [{addends - 1}:0] results = offer[{slice_of(word, "sums")}];
    // A run that takes no sums has none to add.
    wire [{addends - 1}:0] addends = takes ? any_addends : 0; wire addends_valid = takes && comes;
    dut dut(.clk(clk), .rst(rst), .start(age == 2), .shape(shape), .requant_base(0), .finished(finished),
        .info({packed(info, fields)}), .heads(heads), .shift(shift), .credit(credit), .write_en(1'b0), .write(0),
        .o__ready(out_ready), .takes(takes), .gives(gives), .addends__payload(addends),
        .addends__valid(addends_valid), .addends__ready(addends_ready), .results__payload(offer),
        .results__valid(results_valid), .results__ready(results_ready), .last(last));
    // Sources keep what they offer, the chains what has not been shifted.
    reg kept = 0, unshifted = 0; reg [{addends - 1}:0] addends_were; reg [{heads - 1}:0] heads_were;
    always @(posedge clk) begin
        kept <= addends_valid && !addends_ready; addends_were <= addends;
        unshifted <= !shift && todo != 0; heads_were <= heads;
    end
    always @* begin
        if (kept) assume (addends_valid && addends == addends_were);
        if (unshifted) assume (heads == heads_were);
    end
    // The next sum is finished only after the credit for it.
    reg [3:0] todo = 0; reg [1:0] begun = 0; reg ends, was_last;
    always @* assume (!(finished && (todo != 0 || begun == {FINISHED} || age <= 3)));
    always @(posedge clk) if (!rst) begin
        if (finished) begin
            todo <= {cycles}; begun <= begun + 1; ends <= tile_last && image_last;
        end else todo <= todo - shift;
        assert (!shift || todo != 0);
        assert ((addends_valid && addends_ready) == (takes && shift));
        assert ((results_valid && results_ready) == (gives && shift));
        // Codes wait for a free section before their first word, results for nobody but their streams.
        if (todo != 0 && gives) assert (results_valid == (addends_valid || !takes));
        if (todo != 0 && (gives || todo != {cycles}) && (addends_valid || !takes) && (results_ready || !gives))
            assert (shift);
        assert (credit == (shift && todo == 1));
        if (shift) assert (last == (ends && todo == 1));
        if (results_valid) assert (offer[{slice_of(word, "last")}] == last);
    end
"""
        + checks
        + stable_stream("results_valid", "results_ready", "offer")
        + "endmodule\n"
    )


_PARTIAL, _DRAIN = "partial.py", "drain.py"

PARTIAL_SUMS: tuple[Proof, ...] = (
    Proof(
        "sums-return",
        "partial sums led back come whole and in order, none lost; offers stay; a wrong TLAST is named, no other",
        "partial sums",
        _return,
        4 + WORDS * (BEATS + 2),
        False,
        ("partial",),
        (
            Break(_PARTIAL, "self.i.ready.eq(is_open & ~self.o.valid)", "self.i.ready.eq(is_open)"),
            Break(_PARTIAL, "self.i.ready.eq(left == 0)", "self.i.ready.eq(left <= 1)"),
            Break(_PARTIAL, "word_last.eq(index == beats - 1)", "word_last.eq(self.i.payload.last)"),
            Break(_PARTIAL, "word[at * field : at * field + bits]", "word[at * bits : at * bits + bits]"),
            Break(
                _PARTIAL,
                "self.o.payload.last.eq(image_last & (left == 1))",
                "self.o.payload.last.eq(image_last)",
            ),
            Break(_PARTIAL, "| (take & ended & ~self.last)", "| (take & ended)"),
            Break(_PARTIAL, "missing.eq(take & ~ended & self.last)", "missing.eq(0)"),
            Break(
                _PARTIAL,
                "Mux(self.gives, giver.o.valid, self.codes.valid)",
                "giver.o.valid | self.codes.valid",
            ),
        ),
    ),
    Proof(
        "sums-added",
        "each word of partial sums is added to its own sums, exactly and once; the offer stays until taken",
        "drain of partial sums",
        _added,
        6 + FINISHED * (SUMS.drain_cycles + 2),
        False,
        ("drain", "partial"),
        (
            Break(_DRAIN, "active.eq(can & (self.addends.valid | ~self.takes)", "active.eq(can"),
            Break(
                _DRAIN, "self.heads[channel][slot] + self.addends", "self.heads[channel][slot] | self.addends"
            ),
            Break(_DRAIN, "Mux(self.takes | gives, last_cycle, credit)", "credit"),
            Break(
                _DRAIN,
                "last = (index == cycles - 1) & info.tile_last",
                "last = (index == cycles - 2) & info.tile_last",
            ),
            Break(
                _DRAIN,
                "self.addends.ready.eq(can & self.takes & (self.results.ready | ~self.gives))",
                "self.addends.ready.eq(can & self.takes)",
            ),
            Break(_DRAIN, "busy.eq(~last_cycle), index.eq", "busy.eq(~(index == 0)), index.eq"),
        ),
    ),
)
