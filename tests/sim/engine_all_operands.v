// 8 row engines side by side run through every operand combination: each has its own w2, a counter gives the other
// operands. 2**18 cycles are 2**21 combinations. Every lane is compared with a plain sum.
module engine_all_operands #(parameter LATENCY = 4) (
    input  wire        clk,
    output reg  [21:0] compared,
    output reg  [21:0] wrong,
    output wire        done
);
    reg [18:0] step = 19'd0;
    assign done = step == 19'd262144 + LATENCY;
    wire rst = 1'b0;

    function signed [7:0] product(input [2:0] a, input [2:0] w);
        product = $signed({5'b0, a}) * $signed({{5{w[2]}}, w});
    endfunction

    wire [7:0] fault;
    genvar g;
    generate
        for (g = 0; g < 8; g = g + 1) begin : engines
            wire [2:0] w2 = g[2:0];
            wire [11:0] pixels = step[11:0];
            wire [8:0] taps = {w2, step[17:12]};
            wire [47:0] lanes;
            wire [5:0] carries;
            macram_engine engine (
                .clk(clk), .rst(rst), .pixels(pixels), .taps(taps), .lanes(lanes), .carries(carries));

            // The step whose result comes out now.
            wire [18:0] then = step - LATENCY;
            wire [2:0] a0 = then[2:0], a1 = then[5:3], a2 = then[8:6], a3 = then[11:9];
            wire [2:0] w0 = then[14:12], w1 = then[17:15];
            wire signed [7:0] want0 = product(a0, w0);
            wire signed [7:0] want1 = product(a1, w0) + product(a0, w1);
            wire signed [7:0] want2 = product(a2, w0) + product(a1, w1) + product(a0, w2);
            wire signed [7:0] want3 = product(a3, w0) + product(a2, w1) + product(a1, w2);
            wire signed [7:0] want4 = product(a3, w1) + product(a2, w2);
            wire signed [7:0] want5 = product(a3, w2);
            assign fault[g] = lanes[7:0] + {7'b0, carries[0]} != want0 || lanes[15:8] + {7'b0, carries[1]} != want1
                || lanes[23:16] + {7'b0, carries[2]} != want2 || lanes[31:24] + {7'b0, carries[3]} != want3
                || lanes[39:32] + {7'b0, carries[4]} != want4 || lanes[47:40] + {7'b0, carries[5]} != want5;
        end
    endgenerate

    integer i;
    reg [3:0] faults;
    always @* begin
        faults = 4'd0;
        for (i = 0; i < 8; i = i + 1) faults = faults + {3'b0, fault[i]};
    end

    initial begin compared = 22'd0; wrong = 22'd0; end
    always @(posedge clk)
        if (!done) begin
            step <= step + 19'd1;
            if (step >= LATENCY) begin
                compared <= compared + 22'd8;
                wrong <= wrong + {18'b0, faults};
            end
        end
endmodule
