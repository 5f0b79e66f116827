// p = a * w, a unsigned and w signed, 3 bits each, in five LUTs of UltraScale: the top and the lowest bit depend on
// five of the six operand bits between them and share one. Verilator gets the plain product; both are proven equal in
// tests/hw/test_add3.py.
module macram_product (
    input  wire [2:0] a,
    input  wire [2:0] w,
    output wire [5:0] p
);
`ifdef VERILATOR
    assign p = {3'b0, a} * {{3{w[2]}}, w};
`else
    // Bit `at` of the product over all operands {w, a}.
    function [63:0] truth(input integer at);
        integer i, product;
        for (i = 0; i < 64; i = i + 1) begin
            product = (i % 8) * (i / 8 < 4 ? i / 8 : i / 8 - 8);
            truth[i] = product[at];
        end
    endfunction

    // The same for operands {w[2], w[0], a}: upper half bit 5 (w[1] does not matter), lower half bit 0.
    function [63:0] outer(input integer unused);
        integer i;
        for (i = 0; i < 32; i = i + 1) begin
            outer[32 + i] = i[4] & (i[0] | i[1] | i[2]);
            outer[i] = i[0] & i[3];
        end
    endfunction

    genvar i;
    generate
        for (i = 1; i < 5; i = i + 1) begin : inner
            LUT6 #(.INIT(truth(i))) lut (
                .I0(a[0]), .I1(a[1]), .I2(a[2]), .I3(w[0]), .I4(w[1]), .I5(w[2]), .O(p[i]));
        end
    endgenerate
    LUT6_2 #(.INIT(outer(0))) lut_outer (
        .I0(a[0]), .I1(a[1]), .I2(a[2]), .I3(w[0]), .I4(w[2]), .I5(1'b1), .O5(p[0]), .O6(p[5]));
`endif
endmodule
