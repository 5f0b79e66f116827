// Small RAM in LUTs: a synchronous write port and an asynchronous read port.
module macram_lutram #(
    parameter WIDTH = 38,
    parameter DEPTH = 16,
    parameter ADDR_BITS = 4,
    parameter LANES = 1,
    parameter INIT_FILE = ""
) (
    input  wire                 clk,
    input  wire [LANES-1:0]     write_en,
    input  wire [ADDR_BITS-1:0] write_addr,
    input  wire [WIDTH-1:0]     write_data,
    input  wire [ADDR_BITS-1:0] read_addr,
    output wire [WIDTH-1:0]     read_data
);
    localparam LANE = WIDTH / LANES;

    (* ram_style = "distributed" *) reg [WIDTH-1:0] mem [0:DEPTH-1];

    integer i;
    initial begin
        for (i = 0; i < DEPTH; i = i + 1) mem[i] = {WIDTH{1'b0}};
        if (INIT_FILE != "") $readmemh(INIT_FILE, mem);
    end

    integer lane;
    always @(posedge clk)
        for (lane = 0; lane < LANES; lane = lane + 1)
            if (write_en[lane]) mem[write_addr][lane*LANE +: LANE] <= write_data[lane*LANE +: LANE];

    assign read_data = mem[read_addr];
endmodule
