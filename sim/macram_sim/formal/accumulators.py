"""Proof about a unit: its accumulators hold every sum that its fan-in admits, at full width and for all times."""

from __future__ import annotations

from macram.spec import GROUP, LANES, TAPS
from macram_sim.formal.arithmetic import lane_sums
from macram_sim.formal.designs import CARRIES, UNIT, WATCHED
from macram_sim.formal.harness import OPENING, packed
from macram_sim.formal.proof import Break, Proof

LEAST, MOST = UNIT.weight.lo * UNIT.input.hi, UNIT.weight.hi * UNIT.input.hi
"""Range of a product."""
STEPS = TAPS * UNIT.blocks(UNIT.max_c_in)
"""Steps of the longest sum: the accumulators are sized for exactly these."""
PRODUCTS = [sum(0 <= lane - tap < GROUP for tap in range(TAPS)) for lane in range(LANES)]
"""Products of one row engine in each lane."""


def _within(value: str, count: int) -> str:
    """That ``value`` is a possible sum of ``count`` products."""
    return f"{value} >= {LEAST * count} && {value} <= {MOST * count}"


def _within_so_far(value: str, lane: int) -> str:
    """The same of the products since the sum began, and of those that the group before may have carried to it."""
    carried = STEPS * UNIT.rows * PRODUCTS[lane + GROUP] if lane in CARRIES else 0
    products = PRODUCTS[lane]
    return f"{value} >= least{products} + {LEAST * carried} && {value} <= most{products} + {MOST * carried}"


def _unit() -> str:
    """Sums of any length up to the longest, any operands and gaps, against sums that cannot overflow.

    What the carry memories hold is anything in the range that everything written to them is shown to have.
    """
    from macram_hw.unit import AccumulateControl, control_delay  # noqa: PLC0415

    layout, rows = AccumulateControl(UNIT), UNIT.rows
    acc, pixels, taps = UNIT.accumulator.bits, UNIT.line_word_bits, UNIT.weight_word_bits
    assert control_delay(UNIT) == 1, "the harness registers its lane sums once"
    lanes, wide = range(LANES), f"signed [{WATCHED - 1}:0]"
    watched = [f"acc{k}" for k in lanes] + [f"sum{k}" for k in lanes]
    watched += [f"engine{row}_{k}" for row in range(rows) for k in lanes]
    watched += [f"{what}{k}" for k in CARRIES for what in ("read", "write")]
    starts = ["q_carried ? read0 : 0", "q_carried && !q_edge ? read1 : 0", "0", "0", "0", "0"]
    # Ranges of the sums so far, for lanes of one, two and three products; one more step must fit the fan-in.
    limits = [
        (f"{name}{n}", n * bound * rows)
        for n in sorted(set(PRODUCTS))
        for name, bound in (("least", LEAST), ("most", MOST))
    ]
    fits = " && ".join(
        f"{name}_next + {step} {'>=' if step < 0 else '<='} {STEPS * step}" for name, step in limits
    )
    lines = [
        f"(* anyseq *) wire [{taps - 1}:0] w0; (* anyseq *) wire [{pixels - 1}:0] p0; (* anyseq *) wire go;",
        f"reg [{taps - 1}:0] w1; always @(posedge clk) w1 <= w0;  // a cycle before its pixels",
        # Where nothing is to be added, the rest of the control is anything; edge and tile always are.
        "(* anyseq *) wire [1:0] idle; (* anyseq *) wire any_last, any_carried, any_unload;",
        "(* anyseq *) wire [0:0] at_edge;",
        f"(* anyseq *) wire [{layout['tile'].width - 1}:0] tile;",
        f"always @* assume (tile < {UNIT.max_tiles});",
        "reg within = 0;  // a sum has begun and not ended",
        "wire [0:0] en = go && age > 4, first = en ? !within : idle[0], last = en ? any_last : idle[1];",
        # Only a first step starts from what was carried, and only between steps it is unloaded.
        "wire [0:0] unload = !en && any_unload, carried = (en ? first : 1'b1) && (unload || any_carried);",
        *(
            f"reg {wide} {name} = 0; wire {wide} {name}_next = (first ? 0 : {name}) + ({step});"
            for name, step in limits
        ),
        f"wire fits = {fits};",
        "always @* if (en && !fits) assume (last);",
        "always @(posedge clk) if (en) begin",
        "    within <= !last;",
        *(f"    {name} <= {name}_next;" for name, _ in limits),
        "end",
        f"wire [{GROUP * acc - 1}:0] chain;",
        *(f"wire {wide} {name};" for name in watched),
        "dut dut(.clk(clk), .rst(rst), .weight(w0), .activations(p0), .shift(1'b0), .chain_i(0), .chain_o(chain),",
        "    .control("
        + packed(
            layout, {n: n for n in ("en", "first", "carried", "last", "tile", "unload")} | {"edge": "at_edge"}
        )
        + "),",
        "    " + ", ".join(f".watched_{name}({name})" for name in watched) + ");",
        # Plain lane sums: of each row, then of all, a register behind each as in the unit.
        *(lane_sums(UNIT, "p0", "w1", f"row{row}_", row=row, rows=rows) for row in range(rows)),
        *(
            f"reg {wide} lane{row}_{k}; always @(posedge clk) lane{row}_{k} <= row{row}_{k};"
            for row in range(rows)
            for k in lanes
        ),
        *(
            f"reg {wide} plain{k}; always @(posedge clk) plain{k} <= "
            + ("at_edge ? 0 : " if k == 0 else "")
            + " + ".join(f"lane{row}_{k}" for row in range(rows))
            + ";"
            for k in lanes
        ),
        # The control as the unit holds it, and the sums that cannot overflow.
        "reg q_en = 0, q_first, q_last, q_edge, q_carried, q_unload = 0, q_within = 0, ended = 0, unloaded = 0;",
        *(
            f"reg {wide} run{k}; wire {wide} total{k} = (q_first ? ({starts[k]}) : run{k}) + plain{k};"
            for k in lanes
        ),
        *(f"always @* assume ({_within(f'read{k}', STEPS * rows * PRODUCTS[k + GROUP])});" for k in CARRIES),
        *(f"reg {wide} was_read{k};" for k in CARRIES),
        "always @(posedge clk) begin",
        "    {q_en, q_first, q_last, q_edge, q_carried} <= {en && !rst, first, last, at_edge, carried};",
        "    q_unload <= unload && age > 4; ended <= q_en && q_last; unloaded <= q_unload;",
        *(f"    was_read{k} <= read{k};" for k in CARRIES),
        "    if (q_en) begin",
        "        q_within <= !q_last;",
        *(f"        run{k} <= total{k};" for k in lanes),
        "    end",
        "    assert (within == (q_en ? !q_last : q_within));",
        "    if (q_en) assert (q_first == !q_within);",
        *(
            f"    assert ({name} {'>=' if step < 0 else '<='} {STEPS * step});\n"
            f"    if (within) assert ({name} {'>=' if step < 0 else '<='} {(STEPS - 1) * step});"
            for name, step in limits
        ),
        "    if (age > 4) begin",
        *(f"        assert (engine{row}_{k} == lane{row}_{k});" for row in range(rows) for k in lanes),
        *(
            f"        assert ({_within(f'lane{row}_{k}', PRODUCTS[k])});"
            for row in range(rows)
            for k in lanes
        ),
        *(f"        assert ({_within(f'plain{k}', rows * PRODUCTS[k])});" for k in lanes),
        *(f"        assert (sum{k} == plain{k});" for k in lanes),
        "    end",
        "    if (q_en) begin",
        *(f"        assert ({_within_so_far(f'total{k}', k)});" for k in lanes),
        "    end else if (q_within) begin",
        *(f"        assert ({_within_so_far(f'run{k}', k)});" for k in lanes),
        "    end",
        "    if (q_en && q_first) begin",
        *(f"        assert (acc{k} == 0);" for k in lanes),
        "    end else if (q_within) begin",
        *(f"        assert (acc{k} == run{k});" for k in lanes),
        "    end",
        "    if (q_en && q_last) begin",
        *(f"        assert (write{k} == total{k + GROUP});" for k in CARRIES),
        *(f"        assert ({_within(f'write{k}', STEPS * rows * PRODUCTS[k + GROUP])});" for k in CARRIES),
        "    end",
        "    if (ended) begin",
        *(f"        assert ($signed(chain[{(s + 1) * acc - 1}:{s * acc}]) == run{s});" for s in range(GROUP)),
        "    end",
        "    if (unloaded) begin",
        *(
            f"        assert ($signed(chain[{(s + 1) * acc - 1}:{s * acc}]) == was_read{k});"
            for k, s in zip(CARRIES, (0, GROUP - 1), strict=True)
        ),
        "    end",
        "end",
    ]
    return OPENING + "".join(f"    {line}\n" for line in lines) + "endmodule\n"


_UNIT = "unit.py"

ACCUMULATORS: tuple[Proof, ...] = (
    Proof(
        "accumulators",
        f"every sum of up to {STEPS} steps, any operands and gaps, fits the accumulators, carries and results",
        "unit",
        _unit,
        5,
        True,
        ("unit", "add3", "engine"),
        (
            Break(_UNIT, 'Signal(acc, name=f"acc{k}")', 'Signal(signed(acc.width - 1), name=f"acc{k}")'),
            Break(_UNIT, "Add3(acc.width, xilinx", "Add3(acc.width - 1, xilinx"),
            Break(
                "add3.py",
                "adder = Add3(signed_format_for(lo, hi).bits",
                "adder = Add3(signed_format_for(lo, hi).bits - 1",
            ),
            Break(_UNIT, "with m.If(early.en & early.first):", "with m.If(early.first):"),
            Break(
                _UNIT, "used = control.carried & ~control.edge if k == 1", "used = control.carried if k == 1"
            ),
            Break(_UNIT, "early.edge if k == 0 else None", "None"),
            Break(_UNIT, "Mux(control.unload, value, self.chain_i[slot])", "self.chain_i[slot]"),
            Break(
                _UNIT, "read.addr.eq(Mux(used, control.tile", "read.addr.eq(Mux(control.first, control.tile"
            ),
        ),
        fast=False,
    ),
)
