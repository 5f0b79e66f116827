"""Proofs about arithmetic: a row engine gives the plain sums."""

from __future__ import annotations

from macram.spec import ENGINE_LATENCY, GROUP, LANES, TAPS, ArrayConfig
from macram_sim.formal.harness import OPENING
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


def _engine() -> str:
    from macram_hw.engine import make_engine  # noqa: PLC0415

    config = ArrayConfig()
    kind, latency = config.engine, config.engine_latency
    pixels, taps = GROUP * config.input.bits, TAPS * config.weight.bits
    width = len(make_engine(kind, config).lanes[0])
    delays = "".join(f"pixels{i} <= pixels{i - 1}; taps{i} <= taps{i - 1}; " for i in range(1, latency + 1))
    registers = "".join(
        f"    reg [{pixels - 1}:0] pixels{i}; reg [{taps - 1}:0] taps{i};\n" for i in range(1, latency + 1)
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


ARITHMETIC: tuple[Proof, ...] = (
    Proof(
        "engine-portable",
        "a portable row engine gives the six plain lane sums, for all operands",
        "engine",
        _engine,
        ENGINE_LATENCY["portable"] + 2,
        False,
        ("engine",),
        (
            Break(
                "engine.py",
                "self.pixels[k - j] * self.taps[j] for j",
                "self.pixels[k - j] * self.taps[j][:2] for j",
            ),
        ),
    ),
)
