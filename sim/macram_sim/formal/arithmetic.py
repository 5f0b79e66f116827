"""Proofs about arithmetic: row engines give the plain sums, accumulators hold every sum they can meet."""

from __future__ import annotations

from collections.abc import Callable

from macram.spec import ENGINE_LATENCY, GROUP, LANES, TAPS, ArrayConfig
from macram_sim.formal.designs import ONE_CHANNEL, engine_config
from macram_sim.formal.harness import OPENING, packed
from macram_sim.formal.proof import Break, Proof

SUM_BITS = 12
"""Wider than any sum in these proofs needs."""


def lane_sums(config: ArrayConfig, pixels: str, taps: str, name: str) -> str:
    """Plain lane sums of one row engine as signed wires ``name0 ...`` of ``SUM_BITS`` bits."""
    act, weight = config.input.bits, config.weight.bits
    text = []
    for i in range(GROUP):
        field = f"{pixels}[{(i + 1) * act - 1}:{i * act}]"
        text.append(
            f"    wire signed [{SUM_BITS - 1}:0] {name}_p{i} = "
            + (f"$signed({field});" if config.input.signed else f"{field};")
        )
    for j in range(TAPS):
        text.append(
            f"    wire signed [{SUM_BITS - 1}:0] {name}_w{j} = $signed({taps}[{(j + 1) * weight - 1}:{j * weight}]);"
        )
    for k in range(LANES):
        terms = [f"{name}_p{k - j} * {name}_w{j}" for j in range(TAPS) if 0 <= k - j < GROUP]
        text.append(f"    wire signed [{SUM_BITS - 1}:0] {name}{k} = {' + '.join(terms)};")
    return "\n".join(text) + "\n"


def _engine(kind: str) -> Callable[[], str]:
    def harness() -> str:
        from macram_hw.engine import make_engine  # noqa: PLC0415

        config = engine_config(kind)
        latency = ENGINE_LATENCY[kind]
        pixels, taps = GROUP * config.input.bits, TAPS * config.weight.bits
        width = len(make_engine(kind, config).lanes[0])
        delays = "".join(
            f"pixels{i} <= pixels{i - 1}; taps{i} <= taps{i - 1}; " for i in range(1, latency + 1)
        )
        registers = "".join(
            f"    reg [{pixels - 1}:0] pixels{i}; reg [{taps - 1}:0] taps{i};\n"
            for i in range(1, latency + 1)
        )
        checks = "".join(
            f"        assert ($signed(lanes[{(k + 1) * width - 1}:{k * width}])"
            f" + $signed({{1'b0, carries[{k}]}}) == sum{k});\n"
            for k in range(LANES)
        )
        return (
            OPENING
            + f"    (* anyseq *) wire [{pixels - 1}:0] pixels0; (* anyseq *) wire [{taps - 1}:0] taps0;\n"
            + f"    wire [{LANES * width - 1}:0] lanes; wire [{LANES - 1}:0] carries;\n"
            + "    dut dut(.clk(clk), .rst(1'b0), .pixels(pixels0), .taps(taps0), .lanes(lanes), .carries(carries));\n"
            + registers
            + f"    always @(posedge clk) begin {delays}end\n"
            + lane_sums(config, f"pixels{latency}", f"taps{latency}", "sum")
            + f"    always @(posedge clk) if (age > {latency}) begin\n{checks}    end\nendmodule\n"
        )

    return harness


SUM_STEPS = TAPS
"""Steps of the longest sum of `ONE_CHANNEL`: its accumulators are sized for exactly these."""


def _unit() -> str:
    """Two whole sums of the longest kind, with any operands, against sums with bits to spare."""
    from macram_hw.unit import AccumulateControl, control_delay  # noqa: PLC0415

    delay = control_delay(ONE_CHANNEL)
    acc, pixels, taps = ONE_CHANNEL.accumulator.bits, ONE_CHANNEL.line_word_bits, ONE_CHANNEL.weight_word_bits
    control = packed(
        AccumulateControl(ONE_CHANNEL), {n: n for n in ("en", "first", "last", "edge")} | {"tile": "tile"}
    )
    chain = "".join(f"w{i} <= w{i - 1}; " for i in range(1, delay + 2)) + "".join(
        f"p{i} <= p{i - 1}; " for i in range(1, delay + 1)
    )
    registers = "".join(f"    reg [{taps - 1}:0] w{i};\n" for i in range(1, delay + 2)) + "".join(
        f"    reg [{pixels - 1}:0] p{i};\n" for i in range(1, delay + 1)
    )
    starts = ["kept0", "edge ? 0 : kept1", "0", "0", "0", "0"]
    addends = ["edge ? 0 : lane0", *(f"lane{k}" for k in range(1, LANES))]
    totals = "".join(
        f"    wire signed [{SUM_BITS - 1}:0] total{k} = (first ? ({starts[k]}) : run{k}) + ({addends[k]});\n"
        f"    reg signed [{SUM_BITS - 1}:0] run{k};\n"
        for k in range(LANES)
    )
    keep = "".join(f"run{k} <= total{k}; " for k in range(LANES))
    results = "".join(f"result{s} <= total{s}; " for s in range(GROUP))
    checks = "".join(
        f"        assert ($signed(chain_o[{(s + 1) * acc - 1}:{s * acc}]) == result{s});\n"
        for s in range(GROUP)
    )
    return (
        OPENING
        + f"""
    (* anyseq *) wire [{taps - 1}:0] w0; (* anyseq *) wire [{pixels - 1}:0] p0; (* anyseq *) wire en;
    (* anyconst *) reg edge_of_first; (* anyconst *) reg [4:0] steps;
    always @* assume (steps >= 1 && steps <= {SUM_STEPS});
    wire [{GROUP * acc - 1}:0] chain_o;
    reg [4:0] step = 0; reg group = 0;
    wire first = step == 0, last = step + 1 == steps, edge = group == 0 && edge_of_first;
    wire [0:0] tile = 0;
    wire go = en && age > {delay + 2};
    dut dut(.clk(clk), .rst(rst), .weight(w0), .activations(p0), .control({control.replace("en[0:0]", "go")}),
        .shift(1'b0), .chain_i(0), .chain_o(chain_o));
{registers}    always @(posedge clk) begin {chain}end
"""
        + lane_sums(ONE_CHANNEL, f"p{delay}", f"w{delay + 1}", "lane")
        + f"    reg signed [{SUM_BITS - 1}:0] kept0 = 0, kept1 = 0;\n"
        + totals
        + "".join(f"    reg signed [{SUM_BITS - 1}:0] result{s};\n" for s in range(GROUP))
        + f"""    reg loaded = 0;
    always @(posedge clk) begin
        if (go) begin
            step <= last ? 0 : step + 1;
            {keep}
            if (last) begin group <= 1; kept0 <= total4; kept1 <= total5; {results} end
        end
        loaded <= loaded || (go && last);
        if (loaded) begin
{checks}        end
    end
endmodule
"""
    )


_ENGINE = "engine.py"
_ENGINE_BREAKS = {
    "portable": (
        Break(
            _ENGINE, "self.pixels[k - j] * self.taps[j] for j", "self.pixels[k - j] * self.taps[j][:2] for j"
        ),
    ),
    "dsp48e2": (
        Break(_ENGINE, "dsp.p[at * k] ^ parity[k - 1]", "dsp.p[at * k - 1]"),
        Break(_ENGINE, "self.carries[k].eq(borrow[k - 1])", "self.carries[k].eq(borrow[k])"),
    ),
}

ARITHMETIC: tuple[Proof, ...] = (
    *(
        Proof(
            f"engine-{kind}",
            f"a {kind} row engine gives the six plain lane sums, for all operands",
            f"engine {kind}",
            _engine(kind),
            latency + 2,
            False,
            ("engine", "dsp48e2"),
            _ENGINE_BREAKS.get(kind, ()),
        )
        for kind, latency in ENGINE_LATENCY.items()
    ),
    Proof(
        "accumulators",
        "accumulators, carries and results hold every sum of 9 * max_c_in products, and two in a row",
        "unit",
        _unit,
        2 * SUM_STEPS + 7,
        False,
        ("unit", "engine"),
        (
            Break("unit.py", "lane_shape(config, config.rows)", "lane_shape(config, 1).width - 1"),
            Break(
                "unit.py",
                "start, addend = carried.data[0], Mux(control.edge, 0, sums[0])",
                "start, addend = carried.data[0], sums[0]",
            ),
            Break("unit.py", "kept.data[1].eq(totals[GROUP + 1])", "kept.data[1].eq(totals[GROUP])"),
        ),
    ),
)
