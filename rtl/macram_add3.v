// sum = (a | d) + b + c + x + ci, modulo 2**WIDTH: three operands and two carries in one row of LUTs.
// With XILINX the row is built from the primitives of UltraScale: a LUT adds the three bits of its column, its second
// output is the majority, which goes to the column above, and the carry chain adds both. Without, and in Verilator,
// it is left to the tool. Both are proven equal in tests/hw/test_add3.py.
module macram_add3 #(
    parameter WIDTH = 10,
    parameter XILINX = 0
) (
    input  wire [WIDTH-1:0] a,
    input  wire [WIDTH-1:0] d,
    input  wire [WIDTH-1:0] b,
    input  wire [WIDTH-1:0] c,
    input  wire             x,
    input  wire             ci,
    output wire [WIDTH-1:0] sum
);
`ifdef VERILATOR
    localparam SIMULATED = 1;
`else
    localparam SIMULATED = 0;
`endif
    localparam CHAINS = (WIDTH + 7) / 8;

    // Upper half: the sum bit of columns a | d, b, c and the majority from below; lower half: the majority.
    function [63:0] column(input integer unused);
        integer i;
        for (i = 0; i < 32; i = i + 1) begin
            column[32 + i] = (i[0] | i[1]) ^ i[2] ^ i[3] ^ i[4];
            column[i] = ((i[0] | i[1]) & i[2]) | ((i[0] | i[1]) & i[3]) | (i[2] & i[3]);
        end
    endfunction

    genvar i;
    generate
        if (XILINX != 0 && SIMULATED == 0) begin : primitives
            wire [WIDTH:0] majority;
            wire [8*CHAINS-1:0] propagate, generated, total, carry;
            assign majority[0] = x;
            for (i = 0; i < WIDTH; i = i + 1) begin : columns
                LUT6_2 #(.INIT(column(0))) lut (
                    .I0(a[i]), .I1(d[i]), .I2(b[i]), .I3(c[i]), .I4(majority[i]), .I5(1'b1),
                    .O5(majority[i+1]), .O6(propagate[i]));
                assign generated[i] = majority[i];
            end
            for (i = WIDTH; i < 8 * CHAINS; i = i + 1) begin : padding
                assign propagate[i] = 1'b0;
                assign generated[i] = 1'b0;
            end
            wire [CHAINS:0] between;
            assign between[0] = ci;
            for (i = 0; i < CHAINS; i = i + 1) begin : chains
                CARRY8 carry8 (
                    .CI(between[i]), .CI_TOP(1'b0), .DI(generated[8*i +: 8]), .S(propagate[8*i +: 8]),
                    .O(total[8*i +: 8]), .CO(carry[8*i +: 8]));
                assign between[i+1] = carry[8*i+7];
            end
            assign sum = total[WIDTH-1:0];
        end else begin : plain
            assign sum = (a | d) + b + c + {{(WIDTH-1){1'b0}}, x} + {{(WIDTH-1){1'b0}}, ci};
        end
    endgenerate
endmodule
