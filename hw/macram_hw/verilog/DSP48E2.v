// Simulation model of the DSP48E2 slice (AMD UG579), as far as the row engines use it: pre-adder on the B side,
// 27 x 18 multiplier, 48-bit ALU adding the product to zero, all pipeline registers. Bit-true; not for synthesis, where
// the vendor's primitive of the same name takes its place. A setting that is not modelled stops the simulation.
module DSP48E2 #(
    parameter AMULTSEL = "A",
    parameter BMULTSEL = "B",
    parameter PREADDINSEL = "A",
    parameter A_INPUT = "DIRECT",
    parameter B_INPUT = "DIRECT",
    parameter USE_MULT = "MULTIPLY",
    parameter USE_SIMD = "ONE48",
    parameter AREG = 1,
    parameter ACASCREG = 1,
    parameter BREG = 1,
    parameter BCASCREG = 1,
    parameter CREG = 1,
    parameter DREG = 1,
    parameter ADREG = 1,
    parameter MREG = 1,
    parameter PREG = 1,
    parameter INMODEREG = 1,
    parameter OPMODEREG = 1,
    parameter ALUMODEREG = 1,
    parameter CARRYINREG = 1,
    parameter CARRYINSELREG = 1
) (
    input  wire        CLK,
    input  wire [29:0] A,
    input  wire [17:0] B,
    input  wire [47:0] C,
    input  wire [26:0] D,
    input  wire [4:0]  INMODE,
    input  wire [8:0]  OPMODE,
    input  wire [3:0]  ALUMODE,
    input  wire        CARRYIN,
    input  wire [2:0]  CARRYINSEL,
    input  wire [29:0] ACIN,
    input  wire [17:0] BCIN,
    input  wire [47:0] PCIN,
    input  wire        CARRYCASCIN,
    input  wire        MULTSIGNIN,
    input  wire        CEA1, CEA2, CEAD, CEALUMODE, CEB1, CEB2, CEC, CECARRYIN, CECTRL, CED, CEINMODE, CEM, CEP,
    input  wire        RSTA, RSTALLCARRYIN, RSTALUMODE, RSTB, RSTC, RSTCTRL, RSTD, RSTINMODE, RSTM, RSTP,
    output reg  [47:0] P
);
    initial begin
        if (AMULTSEL != "A" || BMULTSEL != "AD" || PREADDINSEL != "B" || USE_MULT != "MULTIPLY"
            || USE_SIMD != "ONE48" || A_INPUT != "DIRECT" || B_INPUT != "DIRECT")
            $fatal(1, "DSP48E2 model: only A * (D - B) with direct inputs is modelled");
        if (AREG != 2 || ACASCREG != 2 || BREG != 1 || BCASCREG != 1 || DREG != 1 || ADREG != 1 || MREG != 1
            || PREG != 1 || CREG + INMODEREG + OPMODEREG + ALUMODEREG + CARRYINREG + CARRYINSELREG != 0)
            $fatal(1, "DSP48E2 model: only two A registers and one of B, D, AD, M and P are modelled");
    end

    reg signed [29:0] a1, a2;
    reg signed [17:0] b2;
    reg signed [26:0] d1, ad;
    reg signed [44:0] m;
    initial begin
        a1 = 0; a2 = 0; b2 = 0; d1 = 0; ad = 0; m = 0; P = 0;
    end

    // UG579 table 2-2: INMODE[3] subtracts, INMODE[2] lets D in, INMODE[1] blocks the B side.
    wire signed [26:0] b_side = INMODE[1] ? 27'sd0 : {{9{b2[17]}}, b2};
    wire signed [26:0] d_side = INMODE[2] ? d1 : 27'sd0;
    wire signed [17:0] b_factor = ad[17:0];
    wire signed [26:0] a_factor = a2[26:0];

    always @(posedge CLK) begin
        if (RSTA) begin a1 <= 0; a2 <= 0; end
        else begin
            if (CEA1) a1 <= A;
            if (CEA2) a2 <= a1;
        end
        if (RSTB) b2 <= 0; else if (CEB2) b2 <= B;
        if (RSTD) begin d1 <= 0; ad <= 0; end
        else begin
            if (CED) d1 <= D;
            if (CEAD) ad <= INMODE[3] ? d_side - b_side : d_side + b_side;
        end
        if (RSTM) m <= 0; else if (CEM) m <= a_factor * b_factor;
        if (RSTP) P <= 0; else if (CEP) P <= {{3{m[44]}}, m};
        if (OPMODE != 9'b000000101 || ALUMODE != 4'd0 || CARRYIN || CARRYINSEL != 3'd0)
            $fatal(1, "DSP48E2 model: only P = M is modelled");
    end

    wire unused = &{1'b0, C, ACIN, BCIN, PCIN, CARRYCASCIN, MULTSIGNIN, CEALUMODE, CEB1, CEC, CECARRYIN, CECTRL,
                    CEINMODE, RSTALLCARRYIN, RSTALUMODE, RSTC, RSTCTRL, RSTINMODE, a2[29:27], ad[26:18],
                    INMODE[4], INMODE[0]};
endmodule
