"""Proofs about arithmetic: a row engine gives the plain sums."""

from __future__ import annotations

from collections.abc import Callable

from macram.spec import ENGINE_LATENCY, GROUP, LANES, TAPS, ArrayConfig
from macram_sim.formal.designs import DSP_BITS
from macram_sim.formal.harness import OPENING
from macram_sim.formal.proof import Break, Proof

SUM_BITS = 12
"""Wider than any lane sum in these proofs needs."""


def lane_sums(config: ArrayConfig, pixels: str, taps: str, name: str, *, row: int = 0, rows: int = 1) -> str:
    """Plain lane sums of one of ``rows`` row engines as signed wires ``name0 ...`` of ``SUM_BITS`` bits.

    Operands lie as in a unit: pixels pixel-major, taps row by row.
    """
    act, weight = config.input.bits, config.weight.bits
    operand, text = f"wire signed [{SUM_BITS - 1}:0] {name}", []
    for i in range(GROUP):
        at = (i * rows + row) * act
        field = f"{pixels}[{at + act - 1}:{at}]"
        text.append(f"{operand}p{i} = {f'$signed({field})' if config.input.signed else field};")
    for j in range(TAPS):
        at = (row * TAPS + j) * weight
        text.append(f"{operand}w{j} = $signed({taps}[{at + weight - 1}:{at}]);")
    for k in range(LANES):
        terms = [f"{name}p{k - j} * {name}w{j}" for j in range(TAPS) if 0 <= k - j < GROUP]
        text.append(f"{operand}{k} = {' + '.join(terms)};")
    return "".join(f"    {line}\n" for line in text)


_SLICE_PORTS = "".join(f", .watched_{port}(slice_{port})" for port in "ABDP")


def _slice(config: ArrayConfig) -> str:
    """The DSP slice without its multiplier.

    Its operands are shown to be two polynomials at ``2 ** SPACING``. What it gives is taken to be their product,
    whose coefficients are the lane sums.
    """
    from macram_hw.engine import DspEngine  # noqa: PLC0415

    def polynomial(name: str, terms: int) -> str:
        return " + ".join(f"({name}{at} <<< {at * DspEngine.SPACING})" for at in range(terms))

    return (
        f"    wire signed [{DSP_BITS - 1}:0] slice_A, slice_B, slice_D, slice_P, factor = slice_D - slice_B;\n"
        + lane_sums(config, "pixels0", "taps0", "now")
        + f"""\
    always @* assume (slice_P == {polynomial("sum", LANES)});
    always @(posedge clk) begin
        assert (slice_A == {polynomial("nowp", GROUP)});
        assert (factor == {polynomial("noww", TAPS)});
        assert (factor >= -(48'sd1 <<< 17) && factor < (48'sd1 <<< 17));  // what the multiplier takes
    end
"""
    )


def _engine(kind: str) -> Callable[[], str]:
    def harness() -> str:
        from macram_hw.engine import make_engine  # noqa: PLC0415

        config, latency = ArrayConfig(engine=kind), ENGINE_LATENCY[kind]
        pixels, taps = GROUP * config.input.bits, TAPS * config.weight.bits
        width = len(make_engine(kind, config).lanes[0])
        ports, slices = ("", "") if kind != "dsp48e2" else (_SLICE_PORTS, _slice(config))
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
            + "    dut dut(.clk(clk), .rst(1'b0), .pixels(pixels0), .taps(taps0), .lanes(lanes),"
            + f" .carries(carries){ports});\n"
            + registers
            + f"    always @(posedge clk) begin {delays}end\n"
            + lane_sums(config, f"pixels{latency}", f"taps{latency}", "sum")
            + slices
            + f"    always @(posedge clk) if (age > {latency}) begin\n{checks}    end\nendmodule\n"
        )

    return harness


_ENGINE = "engine.py"
_BREAKS = {
    "dsp48e2": (
        Break(
            _ENGINE,
            "told = fields[k + 1][0] ^ parity[self.WIDE.index(k)] if wide else fields[k][-1]",
            "told = fields[k][-1]",
        ),
        Break(_ENGINE, "if len(lane_products(k)) == TAPS)", "if len(lane_products(k)) > TAPS)"),
        Break(_ENGINE, "self.carries[k].eq(borrow[k - 1])", "self.carries[k].eq(borrow[k])"),
        Break(_ENGINE, 'range(ENGINE_LATENCY["dsp48e2"])', 'range(ENGINE_LATENCY["dsp48e2"] - 1)'),
        Break(_ENGINE, "Const(0, low_bits), tap[-1]", "Const(0, low_bits), tap[0]"),
        Break(_ENGINE, "_field(pixel, at) for pixel", "_field(pixel, at + 1) for pixel"),
    ),
    "portable": (
        Break(_ENGINE, "self.pixels[i] * self.taps[j] for i", "self.pixels[i] * self.taps[j][:2] for i"),
    ),
    "soft": (
        Break(_ENGINE, "product.a.eq(self.pixels[i])", "product.a.eq(self.pixels[i][:2])"),
        Break("product.py", "i_w=self.w", "i_w=self.w[:2]"),
        Break("add3.py", "i_c=self.c", "i_c=self.c[1:]"),
    ),
}

ARITHMETIC: tuple[Proof, ...] = tuple(
    Proof(
        f"engine-{kind}",
        f"a {kind} row engine gives the six plain lane sums, for all operands"
        + (", if its DSP slice multiplies" if kind == "dsp48e2" else ""),
        f"engine {kind}",
        _engine(kind),
        ENGINE_LATENCY[kind] + 2,
        False,
        ("engine", "product", "add3"),
        breaks,
        primitives=kind == "soft",
    )
    for kind, breaks in _BREAKS.items()
)
