// 8 pairs of rows side by side. The even rows run through every operand combination in the order of a counter, w2 by
// pair; the odd rows through every one in another order, so that a swap or a stale operand gives a wrong lane. 2**18
// cycles are 2**21 combinations of either. Every lane is compared with a plain sum.
module pair_all_operands #(parameter LATENCY = 5) (
    input  wire        aclk,
    input  wire        aclk2x,
    output reg  [22:0] compared,
    output reg  [22:0] wrong,
    output wire        done
);
    reg [18:0] step = 19'd0;
    reg [1:0] settled = 2'd0;
    assign done = step == 19'd262144 + LATENCY;
    wire rst = 1'b0;

    // An odd factor makes the other order one of all combinations again.
    function [17:0] odd_order(input [17:0] index);
        odd_order = index * 18'd176317 + 18'd4951;
    endfunction

    function right(input [2:0] w2, input [17:0] index, input [47:0] lanes, input [5:0] carries);
        integer k, j;
        reg signed [7:0] want, pixel, tap;
        reg [8:0] taps;
        begin
            taps = {w2, index[17:12]};
            right = 1'b1;
            for (k = 0; k < 6; k = k + 1) begin
                want = 8'sd0;
                for (j = 0; j < 3; j = j + 1)
                    if (k - j >= 0 && k - j < 4) begin
                        pixel = {5'b0, index[3 * (k - j) +: 3]};
                        tap = {{5{taps[3 * j + 2]}}, taps[3 * j +: 3]};
                        want = want + pixel * tap;
                    end
                if (lanes[8 * k +: 8] + {7'b0, carries[k]} != want) right = 1'b0;
            end
        end
    endfunction

    wire [15:0] fault;
    genvar g;
    generate
        for (g = 0; g < 8; g = g + 1) begin : pairs
            wire [2:0] even_w2 = g[2:0], odd_w2 = g[2:0] + 3'd3;
            wire [17:0] even = step[17:0], odd = odd_order(step[17:0]);
            wire [95:0] lanes;
            wire [11:0] carries;
            wire [11:0] pixels;
            wire second;
            macram_interleaver interleaver (
                .clk(aclk), .rst(rst), .double_clk(aclk2x), .pixels(pixels), .second(second),
                .word({odd[11:9], even[11:9], odd[8:6], even[8:6], odd[5:3], even[5:3], odd[2:0], even[2:0]}));
            macram_pair pair (
                .clk(aclk), .rst(rst), .double_clk(aclk2x), .pixels(pixels), .second(second),
                .taps({odd_w2, odd[17:12], even_w2, even[17:12]}), .lanes(lanes), .carries(carries));

            // The step whose result comes out now.
            wire [18:0] then = step - LATENCY;
            assign fault[2 * g] = !right(even_w2, then[17:0], lanes[47:0], carries[5:0]);
            assign fault[2 * g + 1] = !right(odd_w2, odd_order(then[17:0]), lanes[95:48], carries[11:6]);
        end
    endgenerate

    initial begin compared = 23'd0; wrong = 23'd0; end
    always @(posedge aclk)
        if (!settled[1]) settled <= settled + 2'd1;
        else if (!done) begin
            step <= step + 19'd1;
            if (step >= LATENCY) begin
                compared <= compared + 23'd16;
                wrong <= wrong + 23'($countones(fault));
            end
        end
endmodule
