// Simple dual-port RAM, one clock: a write port with LANES write enables and a registered read port.
// A read of the word being written in the same cycle is not used by the design and returns the old word.
// STYLE: "block", or "distributed" for a memory in LUTs.
// INIT_FILE: $readmemh file, one word per line; without one the memory starts at zero.
module macram_ram #(
    parameter WIDTH = 72,
    parameter DEPTH = 512,
    parameter ADDR_BITS = 9,
    parameter LANES = 1,
    parameter INIT_FILE = "",
    parameter STYLE = "block"
) (
    input  wire                 clk,
    input  wire [LANES-1:0]     write_en,
    input  wire [ADDR_BITS-1:0] write_addr,
    input  wire [WIDTH-1:0]     write_data,
    input  wire                 read_en,
    input  wire [ADDR_BITS-1:0] read_addr,
    output reg  [WIDTH-1:0]     read_data
);
    localparam LANE = WIDTH / LANES;

    (* ram_style = STYLE *) reg [WIDTH-1:0] mem [0:DEPTH-1];

    integer i;
    initial begin
        for (i = 0; i < DEPTH; i = i + 1) mem[i] = {WIDTH{1'b0}};
        if (INIT_FILE != "") $readmemh(INIT_FILE, mem);
        read_data = {WIDTH{1'b0}};
    end

    integer lane;
    always @(posedge clk) begin
        for (lane = 0; lane < LANES; lane = lane + 1)
            if (write_en[lane]) mem[write_addr][lane*LANE +: LANE] <= write_data[lane*LANE +: LANE];
        if (read_en) read_data <= mem[read_addr];
    end
endmodule
