// A unit as written and the same unit as a netlist of vendor cells get the same inputs; every output bit is compared
// in every cycle. Each 64 cycles the data change their kind: random, all bits 1, all 0, only the top bit of each code.
module gate_equals_rtl #(
    parameter WEIGHT = 18,
    parameter ACTIVATIONS = 24,
    parameter CONTROL = 6,
    parameter CHAIN = 44,
    parameter CYCLES = 20000
) (
    input  wire        clk,
    input  wire [31:0] seed,
    output reg  [31:0] compared,
    output reg  [31:0] wrong,
    output reg  [31:0] changes
);
    reg [WEIGHT-1:0] weight;
    reg [ACTIVATIONS-1:0] activations;
    reg [CONTROL-1:0] control;
    reg [CHAIN-1:0] chain_i;
    reg shift, rst;
    wire [CHAIN-1:0] rtl, gate;

    macram_unit as_written (.clk(clk), .rst(rst), .weight(weight), .activations(activations), .control(control),
        .shift(shift), .chain_i(chain_i), .chain_o(rtl));
    macram_unit_gate as_netlist (.clk(clk), .rst(rst), .weight(weight), .activations(activations), .control(control),
        .shift(shift), .chain_i(chain_i), .chain_o(gate));

    // One xorshift step per 32 bits drawn.
    reg [31:0] state;
    task draw(output [31:0] value);
        begin
            state = state ^ (state << 13);
            state = state ^ (state >> 17);
            state = state ^ (state << 5);
            value = state;
        end
    endtask

    reg [511:0] noise;
    reg [31:0] word, step;
    integer i;
    reg [CHAIN-1:0] previous;
    initial begin
        compared = 0; wrong = 0; changes = 0; step = 0; state = 1; previous = 0;
        weight = 0; activations = 0; control = 0; chain_i = 0; shift = 0; rst = 1; noise = 0; word = 0;
    end
    always @(negedge clk) begin
        if (step == 0) state = seed | 32'd1;
        else begin
            compared <= compared + 1;
            if (rtl !== gate) wrong <= wrong + 1;
            if (rtl !== previous) changes <= changes + 1;
            previous = rtl;
        end
        for (i = 0; i < 16; i = i + 1) begin
            draw(word);
            noise = {noise[479:0], word};
        end
        case (step[8:6])
            3'd1: begin weight = {WEIGHT{1'b1}}; activations = {ACTIVATIONS{1'b1}}; end
            3'd2: begin weight = {WEIGHT/3{3'b100}}; activations = {ACTIVATIONS{1'b1}}; end
            3'd3: begin weight = {WEIGHT/3{3'b011}}; activations = {ACTIVATIONS{1'b1}}; end
            3'd4: begin weight = noise[WEIGHT-1:0]; activations = 0; end
            default: begin weight = noise[WEIGHT-1:0]; activations = noise[ACTIVATIONS+127:128]; end
        endcase
        control = noise[CONTROL+255:256];
        chain_i = noise[CHAIN+299:300];
        shift = noise[500];
        rst = step < 4 || noise[511:502] == 0;
        step = step + 1;
    end
endmodule
