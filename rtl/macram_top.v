
module macram_top(aresetn, s_axi_awaddr, s_axi_awprot, s_axi_awvalid, s_axi_wdata, s_axi_wstrb, s_axi_wvalid, s_axi_bready, s_axi_araddr, s_axi_arprot, s_axi_arvalid, s_axi_rready, s_axis_tdata, s_axis_tvalid, s_axis_tlast, s_axis_param_tdata, s_axis_param_tvalid, s_axis_param_tlast, m_axis_tready, s_axi_awready, s_axi_wready
, s_axi_bresp, s_axi_bvalid, s_axi_arready, s_axi_rdata, s_axi_rresp, s_axi_rvalid, s_axis_tready, s_axis_param_tready, m_axis_tdata, m_axis_tvalid, m_axis_tlast, aclk);
  wire \$1 ;
  input aclk;
  wire aclk;
  input aresetn;
  wire aresetn;
  wire [6:0] axi__araddr;
  wire [2:0] axi__arprot;
  wire axi__arready;
  wire axi__arvalid;
  wire [6:0] axi__awaddr;
  wire [2:0] axi__awprot;
  wire axi__awready;
  wire axi__awvalid;
  wire axi__bready;
  wire [1:0] axi__bresp;
  wire axi__bvalid;
  wire [31:0] axi__rdata;
  wire axi__rready;
  wire [1:0] axi__rresp;
  wire axi__rvalid;
  wire [31:0] axi__wdata;
  wire axi__wready;
  wire [3:0] axi__wstrb;
  wire axi__wvalid;
  wire busy;
  wire \busy$70 ;
  wire [31:0] c_in;
  wire [31:0] \c_in$64 ;
  wire [31:0] c_out;
  wire [31:0] \c_out$66 ;
  wire clk;
  wire [3:0] command;
  wire [2:0] \command$56 ;
  wire [31:0] cycles;
  wire [31:0] \cycles$76 ;
  wire done;
  wire [31:0] drain_cycles;
  wire [31:0] \drain_cycles$86 ;
  (* enum_base_type = "Error" *)
  (* enum_value_000 = "NONE" *)
  (* enum_value_001 = "BAD_SHAPE" *)
  (* enum_value_010 = "BAD_MODE" *)
  (* enum_value_011 = "TLAST_EARLY" *)
  (* enum_value_100 = "TLAST_MISSING" *)
  (* enum_value_101 = "BAD_COMMAND" *)
  wire [2:0] error;
  wire [31:0] \error$74 ;
  wire [31:0] fill_cycles;
  wire [31:0] \fill_cycles$80 ;
  wire [31:0] formats;
  wire [31:0] geometry;
  wire [31:0] height;
  wire [31:0] \height$60 ;
  wire [64:0] i__payload;
  wire [63:0] \i__payload.data ;
  wire \i__payload.last ;
  wire i__ready;
  wire i__valid;
  wire [31:0] input_stalls;
  wire [31:0] \input_stalls$82 ;
  output [63:0] m_axis_tdata;
  wire [63:0] m_axis_tdata;
  output m_axis_tlast;
  wire m_axis_tlast;
  input m_axis_tready;
  wire m_axis_tready;
  output m_axis_tvalid;
  wire m_axis_tvalid;
  wire [31:0] mac_cycles;
  wire [31:0] \mac_cycles$78 ;
  wire [31:0] max_channels;
  wire [31:0] mode;
  wire [31:0] \mode$68 ;
  wire [64:0] o__payload;
  wire [63:0] \o__payload.data ;
  wire \o__payload.last ;
  wire o__ready;
  wire o__valid;
  wire [31:0] output_stalls;
  wire [31:0] \output_stalls$84 ;
  wire [31:0] param_words;
  wire [64:0] params__payload;
  wire [63:0] \params__payload.data ;
  wire \params__payload.last ;
  wire params__ready;
  wire params__valid;
  wire [31:0] row_words;
  wire rst;
  input [6:0] s_axi_araddr;
  wire [6:0] s_axi_araddr;
  input [2:0] s_axi_arprot;
  wire [2:0] s_axi_arprot;
  output s_axi_arready;
  wire s_axi_arready;
  input s_axi_arvalid;
  wire s_axi_arvalid;
  input [6:0] s_axi_awaddr;
  wire [6:0] s_axi_awaddr;
  input [2:0] s_axi_awprot;
  wire [2:0] s_axi_awprot;
  output s_axi_awready;
  wire s_axi_awready;
  input s_axi_awvalid;
  wire s_axi_awvalid;
  input s_axi_bready;
  wire s_axi_bready;
  output [1:0] s_axi_bresp;
  wire [1:0] s_axi_bresp;
  output s_axi_bvalid;
  wire s_axi_bvalid;
  output [31:0] s_axi_rdata;
  wire [31:0] s_axi_rdata;
  input s_axi_rready;
  wire s_axi_rready;
  output [1:0] s_axi_rresp;
  wire [1:0] s_axi_rresp;
  output s_axi_rvalid;
  wire s_axi_rvalid;
  input [31:0] s_axi_wdata;
  wire [31:0] s_axi_wdata;
  output s_axi_wready;
  wire s_axi_wready;
  input [3:0] s_axi_wstrb;
  wire [3:0] s_axi_wstrb;
  input s_axi_wvalid;
  wire s_axi_wvalid;
  input [63:0] s_axis_param_tdata;
  wire [63:0] s_axis_param_tdata;
  input s_axis_param_tlast;
  wire s_axis_param_tlast;
  output s_axis_param_tready;
  wire s_axis_param_tready;
  input s_axis_param_tvalid;
  wire s_axis_param_tvalid;
  input [63:0] s_axis_tdata;
  wire [63:0] s_axis_tdata;
  input s_axis_tlast;
  wire s_axis_tlast;
  output s_axis_tready;
  wire s_axis_tready;
  input s_axis_tvalid;
  wire s_axis_tvalid;
  wire soft_reset;
  wire [31:0] status;
  wire [31:0] weight_depth;
  wire [31:0] width;
  wire [31:0] \width$62 ;
  wire [31:0] words;
  assign rst = ~ aresetn;
  assign \$1  = | error;
  \macram_top.array  array (
    .busy(busy),
    .\busy$16 (s_axis_param_tready),
    .c_in(c_in),
    .c_out(c_out),
    .clk(aclk),
    .cycles(cycles),
    .done(done),
    .drain_cycles(drain_cycles),
    .\error$609 (error),
    .fill_cycles(fill_cycles),
    .height(height),
    .i__payload(i__payload),
    .\i__payload$53 (params__payload),
    .i__ready(s_axis_tready),
    .i__valid(s_axis_tvalid),
    .\i__valid$57 (s_axis_param_tvalid),
    .input_stalls(input_stalls),
    .mac_cycles(mac_cycles),
    .mode(mode),
    .\o__payload$47 (o__payload),
    .\o__ready$49 (m_axis_tready),
    .\o__valid$51 (m_axis_tvalid),
    .output_stalls(output_stalls),
    .\port$1022$0 (command),
    .rst(rst),
    .width(width),
    .words(words)
  );
  \macram_top.registers  registers (
    .axi__araddr(s_axi_araddr),
    .axi__arready(s_axi_arready),
    .axi__arvalid(s_axi_arvalid),
    .axi__awaddr(s_axi_awaddr),
    .axi__awready(s_axi_awready),
    .axi__awvalid(s_axi_awvalid),
    .axi__bready(s_axi_bready),
    .axi__bresp(s_axi_bresp),
    .axi__bvalid(s_axi_bvalid),
    .axi__rdata(s_axi_rdata),
    .axi__rready(s_axi_rready),
    .axi__rresp(s_axi_rresp),
    .axi__rvalid(s_axi_rvalid),
    .axi__wdata(s_axi_wdata),
    .axi__wready(s_axi_wready),
    .axi__wstrb(s_axi_wstrb),
    .axi__wvalid(s_axi_wvalid),
    .busy(busy),
    .c_in(c_in),
    .c_out(c_out),
    .clk(aclk),
    .command(command),
    .cycles(cycles),
    .drain_cycles(drain_cycles),
    .fill_cycles(fill_cycles),
    .height(height),
    .input_stalls(input_stalls),
    .mac_cycles(mac_cycles),
    .mode(mode),
    .output_stalls(output_stalls),
    .param_words(words),
    .\port$1059$0 (error),
    .\port$1061$0 (done),
    .\port$2$0 (\$1 ),
    .rst(rst),
    .width(width)
  );
  assign clk = aclk;
  assign axi__awaddr = s_axi_awaddr;
  assign axi__awprot = s_axi_awprot;
  assign axi__awvalid = s_axi_awvalid;
  assign axi__awready = s_axi_awready;
  assign axi__wdata = s_axi_wdata;
  assign axi__wstrb = s_axi_wstrb;
  assign axi__wvalid = s_axi_wvalid;
  assign axi__wready = s_axi_wready;
  assign axi__bresp = s_axi_bresp;
  assign axi__bvalid = s_axi_bvalid;
  assign axi__bready = s_axi_bready;
  assign axi__araddr = s_axi_araddr;
  assign axi__arprot = s_axi_arprot;
  assign axi__arvalid = s_axi_arvalid;
  assign axi__arready = s_axi_arready;
  assign axi__rdata = s_axi_rdata;
  assign axi__rresp = s_axi_rresp;
  assign axi__rvalid = s_axi_rvalid;
  assign axi__rready = s_axi_rready;
  assign soft_reset = command[3];
  assign \command$56  = command[2:0];
  assign param_words = words;
  assign \height$60  = height;
  assign \width$62  = width;
  assign \c_in$64  = c_in;
  assign \c_out$66  = c_out;
  assign \mode$68  = mode;
  assign \busy$70  = busy;
  assign status = { 29'h00000000, \$1 , done, busy };
  assign \error$74  = { 29'h00000000, error };
  assign \cycles$76  = cycles;
  assign \mac_cycles$78  = mac_cycles;
  assign \fill_cycles$80  = fill_cycles;
  assign \input_stalls$82  = input_stalls;
  assign \output_stalls$84  = output_stalls;
  assign \drain_cycles$86  = drain_cycles;
  assign geometry = 32'd67633216;
  assign formats = 32'd197379;
  assign weight_depth = 32'd512;
  assign row_words = 32'd512;
  assign max_channels = 32'd67109888;
  assign i__valid = s_axis_tvalid;
  assign i__ready = s_axis_tready;
  assign params__valid = s_axis_param_tvalid;
  assign params__ready = s_axis_param_tready;
  assign o__valid = m_axis_tvalid;
  assign o__ready = m_axis_tready;
  assign m_axis_tdata = o__payload[63:0];
  assign m_axis_tlast = o__payload[64];
  assign \i__payload.data  = i__payload[63:0];
  assign \i__payload.last  = i__payload[64];
  assign \params__payload.data  = params__payload[63:0];
  assign \params__payload.last  = params__payload[64];
  assign \o__payload.data  = o__payload[63:0];
  assign \o__payload.last  = o__payload[64];
  assign params__payload[64] = s_axis_param_tlast;
  assign params__payload[63:0] = s_axis_param_tdata;
  assign i__payload[64] = s_axis_tlast;
  assign i__payload[63:0] = s_axis_tdata;
endmodule

module \macram_top.array (i__valid, \i__valid$57 , \o__ready$49 , rst, busy, i__ready, \o__valid$51 , i__payload, \i__payload$53 , \port$1022$0 , height, width, c_in, c_out, mode, words, \error$609 , done, cycles, mac_cycles, fill_cycles
, input_stalls, output_stalls, drain_cycles, \o__payload$47 , \busy$16 , clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$1  = 0;
  wire \$1 ;
  wire \$10 ;
  wire \$11 ;
  wire \$12 ;
  wire \$13 ;
  wire [9:0] \$14 ;
  wire \$15 ;
  wire \$16 ;
  wire \$17 ;
  wire \$18 ;
  wire \$19 ;
  wire \$2 ;
  wire \$20 ;
  wire \$21 ;
  wire \$22 ;
  wire [2:0] \$23 ;
  wire \$24 ;
  wire \$25 ;
  wire \$26 ;
  wire \$27 ;
  wire \$28 ;
  wire [3:0] \$29 ;
  wire \$3 ;
  wire [3:0] \$30 ;
  wire \$31 ;
  wire \$32 ;
  wire \$33 ;
  wire \$34 ;
  wire [9:0] \$35 ;
  wire \$36 ;
  wire \$37 ;
  wire \$38 ;
  wire \$39 ;
  wire \$4 ;
  wire \$40 ;
  wire \$41 ;
  wire \$42 ;
  wire \$43 ;
  wire [32:0] \$44 ;
  wire \$45 ;
  wire \$46 ;
  wire \$47 ;
  wire [32:0] \$48 ;
  wire [32:0] \$49 ;
  wire \$5 ;
  wire [32:0] \$50 ;
  wire [32:0] \$51 ;
  wire [32:0] \$52 ;
  reg [1:0] \$53 ;
  reg \$54 ;
  reg [2:0] \$55 ;
  reg \$56 ;
  reg [7:0] \$57 ;
  reg [7:0] \$58 ;
  reg [7:0] \$59 ;
  wire \$6 ;
  reg [7:0] \$60 ;
  reg \$61 ;
  reg \$62 ;
  reg \$63 ;
  reg [31:0] \$64 ;
  reg [31:0] \$65 ;
  reg [31:0] \$66 ;
  reg [31:0] \$67 ;
  reg [31:0] \$68 ;
  reg [31:0] \$69 ;
  wire \$7 ;
  wire [8:0] \$70 ;
  wire [7:0] \$71 ;
  wire [535:0] \$72 ;
  wire [3:0] \$8 ;
  wire [3:0] \$9 ;
  wire \$signal ;
  wire \$signal$604 ;
  reg \$signal$605  = 1'h0;
  reg \$signal$621  = 1'h0;
  wire [95:0] activations;
  wire [95:0] \activations$106 ;
  wire [95:0] \activations$115 ;
  wire [95:0] \activations$124 ;
  wire [95:0] \activations$133 ;
  wire [95:0] \activations$141 ;
  wire [95:0] \activations$149 ;
  wire [95:0] \activations$157 ;
  wire [95:0] \activations$165 ;
  wire [95:0] \activations$173 ;
  wire [95:0] \activations$181 ;
  wire [95:0] \activations$189 ;
  wire [95:0] \activations$197 ;
  wire [95:0] \activations$205 ;
  wire [95:0] \activations$213 ;
  wire [95:0] \activations$221 ;
  wire [95:0] \activations$229 ;
  wire [95:0] \activations$237 ;
  wire [95:0] \activations$245 ;
  wire [95:0] \activations$253 ;
  wire [95:0] \activations$261 ;
  wire [95:0] \activations$269 ;
  wire [95:0] \activations$277 ;
  wire [95:0] \activations$285 ;
  wire [95:0] \activations$293 ;
  wire [95:0] \activations$301 ;
  wire [95:0] \activations$309 ;
  wire [95:0] \activations$317 ;
  wire [95:0] \activations$325 ;
  wire [95:0] \activations$333 ;
  wire [95:0] \activations$341 ;
  wire [95:0] \activations$349 ;
  wire [95:0] \activations$357 ;
  wire [95:0] \activations$365 ;
  wire [95:0] \activations$373 ;
  wire [95:0] \activations$381 ;
  wire [95:0] \activations$389 ;
  wire [95:0] \activations$397 ;
  wire [95:0] \activations$405 ;
  wire [95:0] \activations$413 ;
  wire [95:0] \activations$421 ;
  wire [95:0] \activations$429 ;
  wire [95:0] \activations$437 ;
  wire [95:0] \activations$445 ;
  wire [95:0] \activations$453 ;
  wire [95:0] \activations$461 ;
  wire [95:0] \activations$469 ;
  wire [95:0] \activations$477 ;
  wire [95:0] \activations$485 ;
  wire [95:0] \activations$493 ;
  wire [95:0] \activations$501 ;
  wire [95:0] \activations$509 ;
  wire [95:0] \activations$517 ;
  wire [95:0] \activations$525 ;
  wire [95:0] \activations$533 ;
  wire [95:0] \activations$541 ;
  wire [95:0] \activations$549 ;
  wire [95:0] \activations$557 ;
  wire [95:0] \activations$565 ;
  wire [95:0] \activations$573 ;
  wire [95:0] \activations$581 ;
  wire [95:0] \activations$587 ;
  wire [95:0] \activations$593 ;
  wire [95:0] \activations$599 ;
  wire [8:0] address;
  wire [8:0] \address$103 ;
  wire [8:0] \address$112 ;
  wire [8:0] \address$121 ;
  wire [8:0] \address$130 ;
  wire [8:0] \address$138 ;
  wire [8:0] \address$146 ;
  wire [8:0] \address$154 ;
  wire [8:0] \address$162 ;
  wire [8:0] \address$170 ;
  wire [8:0] \address$178 ;
  wire [8:0] \address$186 ;
  wire [8:0] \address$194 ;
  wire [8:0] \address$202 ;
  wire [8:0] \address$210 ;
  wire [8:0] \address$218 ;
  wire [8:0] \address$226 ;
  wire [8:0] \address$234 ;
  wire [8:0] \address$242 ;
  wire [8:0] \address$250 ;
  wire [8:0] \address$258 ;
  wire [8:0] \address$266 ;
  wire [8:0] \address$274 ;
  wire [8:0] \address$282 ;
  wire [8:0] \address$290 ;
  wire [8:0] \address$298 ;
  wire [8:0] \address$306 ;
  wire [8:0] \address$314 ;
  wire [8:0] \address$322 ;
  wire [8:0] \address$330 ;
  wire [8:0] \address$338 ;
  wire [8:0] \address$346 ;
  wire [8:0] \address$354 ;
  wire [8:0] \address$362 ;
  wire [8:0] \address$370 ;
  wire [8:0] \address$378 ;
  wire [8:0] \address$386 ;
  wire [8:0] \address$394 ;
  wire [8:0] \address$402 ;
  wire [8:0] \address$410 ;
  wire [8:0] \address$418 ;
  wire [8:0] \address$426 ;
  wire [8:0] \address$434 ;
  wire [8:0] \address$442 ;
  wire [8:0] \address$450 ;
  wire [8:0] \address$458 ;
  wire [8:0] \address$466 ;
  wire [8:0] \address$474 ;
  wire [8:0] \address$482 ;
  wire [8:0] \address$490 ;
  wire [8:0] \address$498 ;
  wire [8:0] \address$506 ;
  wire [8:0] \address$514 ;
  wire [8:0] \address$522 ;
  wire [8:0] \address$530 ;
  wire [8:0] \address$538 ;
  wire [8:0] \address$546 ;
  wire [8:0] \address$554 ;
  wire [8:0] \address$562 ;
  wire [8:0] \address$570 ;
  wire [8:0] \address$578 ;
  wire [8:0] \address$584 ;
  wire [8:0] \address$590 ;
  wire [8:0] \address$596 ;
  wire [15:0] beats_per_pixel;
  wire [15:0] \beats_per_pixel$69 ;
  wire blocked;
  output busy;
  wire busy;
  output \busy$16 ;
  wire \busy$16 ;
  input [31:0] c_in;
  wire [31:0] c_in;
  wire [31:0] \c_in$5 ;
  input [31:0] c_out;
  wire [31:0] c_out;
  wire [31:0] \c_out$7 ;
  wire [75:0] chain_i;
  wire [75:0] \chain_i$110 ;
  wire [18:0] \chain_i$110[0] ;
  wire [18:0] \chain_i$110[1] ;
  wire [18:0] \chain_i$110[2] ;
  wire [18:0] \chain_i$110[3] ;
  wire [75:0] \chain_i$119 ;
  wire [18:0] \chain_i$119[0] ;
  wire [18:0] \chain_i$119[1] ;
  wire [18:0] \chain_i$119[2] ;
  wire [18:0] \chain_i$119[3] ;
  wire [75:0] \chain_i$128 ;
  wire [18:0] \chain_i$128[0] ;
  wire [18:0] \chain_i$128[1] ;
  wire [18:0] \chain_i$128[2] ;
  wire [18:0] \chain_i$128[3] ;
  wire [75:0] \chain_i$136 ;
  wire [18:0] \chain_i$136[0] ;
  wire [18:0] \chain_i$136[1] ;
  wire [18:0] \chain_i$136[2] ;
  wire [18:0] \chain_i$136[3] ;
  wire [75:0] \chain_i$144 ;
  wire [18:0] \chain_i$144[0] ;
  wire [18:0] \chain_i$144[1] ;
  wire [18:0] \chain_i$144[2] ;
  wire [18:0] \chain_i$144[3] ;
  wire [75:0] \chain_i$152 ;
  wire [18:0] \chain_i$152[0] ;
  wire [18:0] \chain_i$152[1] ;
  wire [18:0] \chain_i$152[2] ;
  wire [18:0] \chain_i$152[3] ;
  wire [75:0] \chain_i$160 ;
  wire [18:0] \chain_i$160[0] ;
  wire [18:0] \chain_i$160[1] ;
  wire [18:0] \chain_i$160[2] ;
  wire [18:0] \chain_i$160[3] ;
  wire [75:0] \chain_i$168 ;
  wire [18:0] \chain_i$168[0] ;
  wire [18:0] \chain_i$168[1] ;
  wire [18:0] \chain_i$168[2] ;
  wire [18:0] \chain_i$168[3] ;
  wire [75:0] \chain_i$176 ;
  wire [18:0] \chain_i$176[0] ;
  wire [18:0] \chain_i$176[1] ;
  wire [18:0] \chain_i$176[2] ;
  wire [18:0] \chain_i$176[3] ;
  wire [75:0] \chain_i$184 ;
  wire [18:0] \chain_i$184[0] ;
  wire [18:0] \chain_i$184[1] ;
  wire [18:0] \chain_i$184[2] ;
  wire [18:0] \chain_i$184[3] ;
  wire [75:0] \chain_i$192 ;
  wire [18:0] \chain_i$192[0] ;
  wire [18:0] \chain_i$192[1] ;
  wire [18:0] \chain_i$192[2] ;
  wire [18:0] \chain_i$192[3] ;
  wire [75:0] \chain_i$200 ;
  wire [18:0] \chain_i$200[0] ;
  wire [18:0] \chain_i$200[1] ;
  wire [18:0] \chain_i$200[2] ;
  wire [18:0] \chain_i$200[3] ;
  wire [75:0] \chain_i$208 ;
  wire [18:0] \chain_i$208[0] ;
  wire [18:0] \chain_i$208[1] ;
  wire [18:0] \chain_i$208[2] ;
  wire [18:0] \chain_i$208[3] ;
  wire [75:0] \chain_i$216 ;
  wire [18:0] \chain_i$216[0] ;
  wire [18:0] \chain_i$216[1] ;
  wire [18:0] \chain_i$216[2] ;
  wire [18:0] \chain_i$216[3] ;
  wire [75:0] \chain_i$224 ;
  wire [18:0] \chain_i$224[0] ;
  wire [18:0] \chain_i$224[1] ;
  wire [18:0] \chain_i$224[2] ;
  wire [18:0] \chain_i$224[3] ;
  wire [75:0] \chain_i$232 ;
  wire [18:0] \chain_i$232[0] ;
  wire [18:0] \chain_i$232[1] ;
  wire [18:0] \chain_i$232[2] ;
  wire [18:0] \chain_i$232[3] ;
  wire [75:0] \chain_i$240 ;
  wire [18:0] \chain_i$240[0] ;
  wire [18:0] \chain_i$240[1] ;
  wire [18:0] \chain_i$240[2] ;
  wire [18:0] \chain_i$240[3] ;
  wire [75:0] \chain_i$248 ;
  wire [18:0] \chain_i$248[0] ;
  wire [18:0] \chain_i$248[1] ;
  wire [18:0] \chain_i$248[2] ;
  wire [18:0] \chain_i$248[3] ;
  wire [75:0] \chain_i$256 ;
  wire [18:0] \chain_i$256[0] ;
  wire [18:0] \chain_i$256[1] ;
  wire [18:0] \chain_i$256[2] ;
  wire [18:0] \chain_i$256[3] ;
  wire [75:0] \chain_i$264 ;
  wire [18:0] \chain_i$264[0] ;
  wire [18:0] \chain_i$264[1] ;
  wire [18:0] \chain_i$264[2] ;
  wire [18:0] \chain_i$264[3] ;
  wire [75:0] \chain_i$272 ;
  wire [18:0] \chain_i$272[0] ;
  wire [18:0] \chain_i$272[1] ;
  wire [18:0] \chain_i$272[2] ;
  wire [18:0] \chain_i$272[3] ;
  wire [75:0] \chain_i$280 ;
  wire [18:0] \chain_i$280[0] ;
  wire [18:0] \chain_i$280[1] ;
  wire [18:0] \chain_i$280[2] ;
  wire [18:0] \chain_i$280[3] ;
  wire [75:0] \chain_i$288 ;
  wire [18:0] \chain_i$288[0] ;
  wire [18:0] \chain_i$288[1] ;
  wire [18:0] \chain_i$288[2] ;
  wire [18:0] \chain_i$288[3] ;
  wire [75:0] \chain_i$296 ;
  wire [18:0] \chain_i$296[0] ;
  wire [18:0] \chain_i$296[1] ;
  wire [18:0] \chain_i$296[2] ;
  wire [18:0] \chain_i$296[3] ;
  wire [75:0] \chain_i$304 ;
  wire [18:0] \chain_i$304[0] ;
  wire [18:0] \chain_i$304[1] ;
  wire [18:0] \chain_i$304[2] ;
  wire [18:0] \chain_i$304[3] ;
  wire [75:0] \chain_i$312 ;
  wire [18:0] \chain_i$312[0] ;
  wire [18:0] \chain_i$312[1] ;
  wire [18:0] \chain_i$312[2] ;
  wire [18:0] \chain_i$312[3] ;
  wire [75:0] \chain_i$320 ;
  wire [18:0] \chain_i$320[0] ;
  wire [18:0] \chain_i$320[1] ;
  wire [18:0] \chain_i$320[2] ;
  wire [18:0] \chain_i$320[3] ;
  wire [75:0] \chain_i$328 ;
  wire [18:0] \chain_i$328[0] ;
  wire [18:0] \chain_i$328[1] ;
  wire [18:0] \chain_i$328[2] ;
  wire [18:0] \chain_i$328[3] ;
  wire [75:0] \chain_i$336 ;
  wire [18:0] \chain_i$336[0] ;
  wire [18:0] \chain_i$336[1] ;
  wire [18:0] \chain_i$336[2] ;
  wire [18:0] \chain_i$336[3] ;
  wire [75:0] \chain_i$344 ;
  wire [18:0] \chain_i$344[0] ;
  wire [18:0] \chain_i$344[1] ;
  wire [18:0] \chain_i$344[2] ;
  wire [18:0] \chain_i$344[3] ;
  wire [75:0] \chain_i$352 ;
  wire [18:0] \chain_i$352[0] ;
  wire [18:0] \chain_i$352[1] ;
  wire [18:0] \chain_i$352[2] ;
  wire [18:0] \chain_i$352[3] ;
  wire [75:0] \chain_i$360 ;
  wire [18:0] \chain_i$360[0] ;
  wire [18:0] \chain_i$360[1] ;
  wire [18:0] \chain_i$360[2] ;
  wire [18:0] \chain_i$360[3] ;
  wire [75:0] \chain_i$368 ;
  wire [18:0] \chain_i$368[0] ;
  wire [18:0] \chain_i$368[1] ;
  wire [18:0] \chain_i$368[2] ;
  wire [18:0] \chain_i$368[3] ;
  wire [75:0] \chain_i$376 ;
  wire [18:0] \chain_i$376[0] ;
  wire [18:0] \chain_i$376[1] ;
  wire [18:0] \chain_i$376[2] ;
  wire [18:0] \chain_i$376[3] ;
  wire [75:0] \chain_i$384 ;
  wire [18:0] \chain_i$384[0] ;
  wire [18:0] \chain_i$384[1] ;
  wire [18:0] \chain_i$384[2] ;
  wire [18:0] \chain_i$384[3] ;
  wire [75:0] \chain_i$392 ;
  wire [18:0] \chain_i$392[0] ;
  wire [18:0] \chain_i$392[1] ;
  wire [18:0] \chain_i$392[2] ;
  wire [18:0] \chain_i$392[3] ;
  wire [75:0] \chain_i$400 ;
  wire [18:0] \chain_i$400[0] ;
  wire [18:0] \chain_i$400[1] ;
  wire [18:0] \chain_i$400[2] ;
  wire [18:0] \chain_i$400[3] ;
  wire [75:0] \chain_i$408 ;
  wire [18:0] \chain_i$408[0] ;
  wire [18:0] \chain_i$408[1] ;
  wire [18:0] \chain_i$408[2] ;
  wire [18:0] \chain_i$408[3] ;
  wire [75:0] \chain_i$416 ;
  wire [18:0] \chain_i$416[0] ;
  wire [18:0] \chain_i$416[1] ;
  wire [18:0] \chain_i$416[2] ;
  wire [18:0] \chain_i$416[3] ;
  wire [75:0] \chain_i$424 ;
  wire [18:0] \chain_i$424[0] ;
  wire [18:0] \chain_i$424[1] ;
  wire [18:0] \chain_i$424[2] ;
  wire [18:0] \chain_i$424[3] ;
  wire [75:0] \chain_i$432 ;
  wire [18:0] \chain_i$432[0] ;
  wire [18:0] \chain_i$432[1] ;
  wire [18:0] \chain_i$432[2] ;
  wire [18:0] \chain_i$432[3] ;
  wire [75:0] \chain_i$440 ;
  wire [18:0] \chain_i$440[0] ;
  wire [18:0] \chain_i$440[1] ;
  wire [18:0] \chain_i$440[2] ;
  wire [18:0] \chain_i$440[3] ;
  wire [75:0] \chain_i$448 ;
  wire [18:0] \chain_i$448[0] ;
  wire [18:0] \chain_i$448[1] ;
  wire [18:0] \chain_i$448[2] ;
  wire [18:0] \chain_i$448[3] ;
  wire [75:0] \chain_i$456 ;
  wire [18:0] \chain_i$456[0] ;
  wire [18:0] \chain_i$456[1] ;
  wire [18:0] \chain_i$456[2] ;
  wire [18:0] \chain_i$456[3] ;
  wire [75:0] \chain_i$464 ;
  wire [18:0] \chain_i$464[0] ;
  wire [18:0] \chain_i$464[1] ;
  wire [18:0] \chain_i$464[2] ;
  wire [18:0] \chain_i$464[3] ;
  wire [75:0] \chain_i$472 ;
  wire [18:0] \chain_i$472[0] ;
  wire [18:0] \chain_i$472[1] ;
  wire [18:0] \chain_i$472[2] ;
  wire [18:0] \chain_i$472[3] ;
  wire [75:0] \chain_i$480 ;
  wire [18:0] \chain_i$480[0] ;
  wire [18:0] \chain_i$480[1] ;
  wire [18:0] \chain_i$480[2] ;
  wire [18:0] \chain_i$480[3] ;
  wire [75:0] \chain_i$488 ;
  wire [18:0] \chain_i$488[0] ;
  wire [18:0] \chain_i$488[1] ;
  wire [18:0] \chain_i$488[2] ;
  wire [18:0] \chain_i$488[3] ;
  wire [75:0] \chain_i$496 ;
  wire [18:0] \chain_i$496[0] ;
  wire [18:0] \chain_i$496[1] ;
  wire [18:0] \chain_i$496[2] ;
  wire [18:0] \chain_i$496[3] ;
  wire [75:0] \chain_i$504 ;
  wire [18:0] \chain_i$504[0] ;
  wire [18:0] \chain_i$504[1] ;
  wire [18:0] \chain_i$504[2] ;
  wire [18:0] \chain_i$504[3] ;
  wire [75:0] \chain_i$512 ;
  wire [18:0] \chain_i$512[0] ;
  wire [18:0] \chain_i$512[1] ;
  wire [18:0] \chain_i$512[2] ;
  wire [18:0] \chain_i$512[3] ;
  wire [75:0] \chain_i$520 ;
  wire [18:0] \chain_i$520[0] ;
  wire [18:0] \chain_i$520[1] ;
  wire [18:0] \chain_i$520[2] ;
  wire [18:0] \chain_i$520[3] ;
  wire [75:0] \chain_i$528 ;
  wire [18:0] \chain_i$528[0] ;
  wire [18:0] \chain_i$528[1] ;
  wire [18:0] \chain_i$528[2] ;
  wire [18:0] \chain_i$528[3] ;
  wire [75:0] \chain_i$536 ;
  wire [18:0] \chain_i$536[0] ;
  wire [18:0] \chain_i$536[1] ;
  wire [18:0] \chain_i$536[2] ;
  wire [18:0] \chain_i$536[3] ;
  wire [75:0] \chain_i$544 ;
  wire [18:0] \chain_i$544[0] ;
  wire [18:0] \chain_i$544[1] ;
  wire [18:0] \chain_i$544[2] ;
  wire [18:0] \chain_i$544[3] ;
  wire [75:0] \chain_i$552 ;
  wire [18:0] \chain_i$552[0] ;
  wire [18:0] \chain_i$552[1] ;
  wire [18:0] \chain_i$552[2] ;
  wire [18:0] \chain_i$552[3] ;
  wire [75:0] \chain_i$560 ;
  wire [18:0] \chain_i$560[0] ;
  wire [18:0] \chain_i$560[1] ;
  wire [18:0] \chain_i$560[2] ;
  wire [18:0] \chain_i$560[3] ;
  wire [75:0] \chain_i$568 ;
  wire [18:0] \chain_i$568[0] ;
  wire [18:0] \chain_i$568[1] ;
  wire [18:0] \chain_i$568[2] ;
  wire [18:0] \chain_i$568[3] ;
  wire [75:0] \chain_i$576 ;
  wire [18:0] \chain_i$576[0] ;
  wire [18:0] \chain_i$576[1] ;
  wire [18:0] \chain_i$576[2] ;
  wire [18:0] \chain_i$576[3] ;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  wire [75:0] chain_o;
  wire [75:0] \chain_o$102 ;
  wire [18:0] \chain_o$102[0] ;
  wire [18:0] \chain_o$102[1] ;
  wire [18:0] \chain_o$102[2] ;
  wire [18:0] \chain_o$102[3] ;
  wire [75:0] \chain_o$109 ;
  wire [18:0] \chain_o$109[0] ;
  wire [18:0] \chain_o$109[1] ;
  wire [18:0] \chain_o$109[2] ;
  wire [18:0] \chain_o$109[3] ;
  wire [75:0] \chain_o$111 ;
  wire [18:0] \chain_o$111[0] ;
  wire [18:0] \chain_o$111[1] ;
  wire [18:0] \chain_o$111[2] ;
  wire [18:0] \chain_o$111[3] ;
  wire [75:0] \chain_o$118 ;
  wire [18:0] \chain_o$118[0] ;
  wire [18:0] \chain_o$118[1] ;
  wire [18:0] \chain_o$118[2] ;
  wire [18:0] \chain_o$118[3] ;
  wire [75:0] \chain_o$120 ;
  wire [18:0] \chain_o$120[0] ;
  wire [18:0] \chain_o$120[1] ;
  wire [18:0] \chain_o$120[2] ;
  wire [18:0] \chain_o$120[3] ;
  wire [75:0] \chain_o$127 ;
  wire [18:0] \chain_o$127[0] ;
  wire [18:0] \chain_o$127[1] ;
  wire [18:0] \chain_o$127[2] ;
  wire [18:0] \chain_o$127[3] ;
  wire [75:0] \chain_o$129 ;
  wire [18:0] \chain_o$129[0] ;
  wire [18:0] \chain_o$129[1] ;
  wire [18:0] \chain_o$129[2] ;
  wire [18:0] \chain_o$129[3] ;
  wire [75:0] \chain_o$137 ;
  wire [18:0] \chain_o$137[0] ;
  wire [18:0] \chain_o$137[1] ;
  wire [18:0] \chain_o$137[2] ;
  wire [18:0] \chain_o$137[3] ;
  wire [75:0] \chain_o$145 ;
  wire [18:0] \chain_o$145[0] ;
  wire [18:0] \chain_o$145[1] ;
  wire [18:0] \chain_o$145[2] ;
  wire [18:0] \chain_o$145[3] ;
  wire [75:0] \chain_o$153 ;
  wire [18:0] \chain_o$153[0] ;
  wire [18:0] \chain_o$153[1] ;
  wire [18:0] \chain_o$153[2] ;
  wire [18:0] \chain_o$153[3] ;
  wire [75:0] \chain_o$161 ;
  wire [18:0] \chain_o$161[0] ;
  wire [18:0] \chain_o$161[1] ;
  wire [18:0] \chain_o$161[2] ;
  wire [18:0] \chain_o$161[3] ;
  wire [75:0] \chain_o$169 ;
  wire [18:0] \chain_o$169[0] ;
  wire [18:0] \chain_o$169[1] ;
  wire [18:0] \chain_o$169[2] ;
  wire [18:0] \chain_o$169[3] ;
  wire [75:0] \chain_o$177 ;
  wire [18:0] \chain_o$177[0] ;
  wire [18:0] \chain_o$177[1] ;
  wire [18:0] \chain_o$177[2] ;
  wire [18:0] \chain_o$177[3] ;
  wire [75:0] \chain_o$185 ;
  wire [18:0] \chain_o$185[0] ;
  wire [18:0] \chain_o$185[1] ;
  wire [18:0] \chain_o$185[2] ;
  wire [18:0] \chain_o$185[3] ;
  wire [75:0] \chain_o$193 ;
  wire [18:0] \chain_o$193[0] ;
  wire [18:0] \chain_o$193[1] ;
  wire [18:0] \chain_o$193[2] ;
  wire [18:0] \chain_o$193[3] ;
  wire [75:0] \chain_o$201 ;
  wire [18:0] \chain_o$201[0] ;
  wire [18:0] \chain_o$201[1] ;
  wire [18:0] \chain_o$201[2] ;
  wire [18:0] \chain_o$201[3] ;
  wire [75:0] \chain_o$209 ;
  wire [18:0] \chain_o$209[0] ;
  wire [18:0] \chain_o$209[1] ;
  wire [18:0] \chain_o$209[2] ;
  wire [18:0] \chain_o$209[3] ;
  wire [75:0] \chain_o$217 ;
  wire [18:0] \chain_o$217[0] ;
  wire [18:0] \chain_o$217[1] ;
  wire [18:0] \chain_o$217[2] ;
  wire [18:0] \chain_o$217[3] ;
  wire [75:0] \chain_o$225 ;
  wire [18:0] \chain_o$225[0] ;
  wire [18:0] \chain_o$225[1] ;
  wire [18:0] \chain_o$225[2] ;
  wire [18:0] \chain_o$225[3] ;
  wire [75:0] \chain_o$233 ;
  wire [18:0] \chain_o$233[0] ;
  wire [18:0] \chain_o$233[1] ;
  wire [18:0] \chain_o$233[2] ;
  wire [18:0] \chain_o$233[3] ;
  wire [75:0] \chain_o$241 ;
  wire [18:0] \chain_o$241[0] ;
  wire [18:0] \chain_o$241[1] ;
  wire [18:0] \chain_o$241[2] ;
  wire [18:0] \chain_o$241[3] ;
  wire [75:0] \chain_o$249 ;
  wire [18:0] \chain_o$249[0] ;
  wire [18:0] \chain_o$249[1] ;
  wire [18:0] \chain_o$249[2] ;
  wire [18:0] \chain_o$249[3] ;
  wire [75:0] \chain_o$257 ;
  wire [18:0] \chain_o$257[0] ;
  wire [18:0] \chain_o$257[1] ;
  wire [18:0] \chain_o$257[2] ;
  wire [18:0] \chain_o$257[3] ;
  wire [75:0] \chain_o$265 ;
  wire [18:0] \chain_o$265[0] ;
  wire [18:0] \chain_o$265[1] ;
  wire [18:0] \chain_o$265[2] ;
  wire [18:0] \chain_o$265[3] ;
  wire [75:0] \chain_o$273 ;
  wire [18:0] \chain_o$273[0] ;
  wire [18:0] \chain_o$273[1] ;
  wire [18:0] \chain_o$273[2] ;
  wire [18:0] \chain_o$273[3] ;
  wire [75:0] \chain_o$281 ;
  wire [18:0] \chain_o$281[0] ;
  wire [18:0] \chain_o$281[1] ;
  wire [18:0] \chain_o$281[2] ;
  wire [18:0] \chain_o$281[3] ;
  wire [75:0] \chain_o$289 ;
  wire [18:0] \chain_o$289[0] ;
  wire [18:0] \chain_o$289[1] ;
  wire [18:0] \chain_o$289[2] ;
  wire [18:0] \chain_o$289[3] ;
  wire [75:0] \chain_o$297 ;
  wire [18:0] \chain_o$297[0] ;
  wire [18:0] \chain_o$297[1] ;
  wire [18:0] \chain_o$297[2] ;
  wire [18:0] \chain_o$297[3] ;
  wire [75:0] \chain_o$305 ;
  wire [18:0] \chain_o$305[0] ;
  wire [18:0] \chain_o$305[1] ;
  wire [18:0] \chain_o$305[2] ;
  wire [18:0] \chain_o$305[3] ;
  wire [75:0] \chain_o$313 ;
  wire [18:0] \chain_o$313[0] ;
  wire [18:0] \chain_o$313[1] ;
  wire [18:0] \chain_o$313[2] ;
  wire [18:0] \chain_o$313[3] ;
  wire [75:0] \chain_o$321 ;
  wire [18:0] \chain_o$321[0] ;
  wire [18:0] \chain_o$321[1] ;
  wire [18:0] \chain_o$321[2] ;
  wire [18:0] \chain_o$321[3] ;
  wire [75:0] \chain_o$329 ;
  wire [18:0] \chain_o$329[0] ;
  wire [18:0] \chain_o$329[1] ;
  wire [18:0] \chain_o$329[2] ;
  wire [18:0] \chain_o$329[3] ;
  wire [75:0] \chain_o$337 ;
  wire [18:0] \chain_o$337[0] ;
  wire [18:0] \chain_o$337[1] ;
  wire [18:0] \chain_o$337[2] ;
  wire [18:0] \chain_o$337[3] ;
  wire [75:0] \chain_o$345 ;
  wire [18:0] \chain_o$345[0] ;
  wire [18:0] \chain_o$345[1] ;
  wire [18:0] \chain_o$345[2] ;
  wire [18:0] \chain_o$345[3] ;
  wire [75:0] \chain_o$353 ;
  wire [18:0] \chain_o$353[0] ;
  wire [18:0] \chain_o$353[1] ;
  wire [18:0] \chain_o$353[2] ;
  wire [18:0] \chain_o$353[3] ;
  wire [75:0] \chain_o$361 ;
  wire [18:0] \chain_o$361[0] ;
  wire [18:0] \chain_o$361[1] ;
  wire [18:0] \chain_o$361[2] ;
  wire [18:0] \chain_o$361[3] ;
  wire [75:0] \chain_o$369 ;
  wire [18:0] \chain_o$369[0] ;
  wire [18:0] \chain_o$369[1] ;
  wire [18:0] \chain_o$369[2] ;
  wire [18:0] \chain_o$369[3] ;
  wire [75:0] \chain_o$377 ;
  wire [18:0] \chain_o$377[0] ;
  wire [18:0] \chain_o$377[1] ;
  wire [18:0] \chain_o$377[2] ;
  wire [18:0] \chain_o$377[3] ;
  wire [75:0] \chain_o$385 ;
  wire [18:0] \chain_o$385[0] ;
  wire [18:0] \chain_o$385[1] ;
  wire [18:0] \chain_o$385[2] ;
  wire [18:0] \chain_o$385[3] ;
  wire [75:0] \chain_o$393 ;
  wire [18:0] \chain_o$393[0] ;
  wire [18:0] \chain_o$393[1] ;
  wire [18:0] \chain_o$393[2] ;
  wire [18:0] \chain_o$393[3] ;
  wire [75:0] \chain_o$401 ;
  wire [18:0] \chain_o$401[0] ;
  wire [18:0] \chain_o$401[1] ;
  wire [18:0] \chain_o$401[2] ;
  wire [18:0] \chain_o$401[3] ;
  wire [75:0] \chain_o$409 ;
  wire [18:0] \chain_o$409[0] ;
  wire [18:0] \chain_o$409[1] ;
  wire [18:0] \chain_o$409[2] ;
  wire [18:0] \chain_o$409[3] ;
  wire [75:0] \chain_o$417 ;
  wire [18:0] \chain_o$417[0] ;
  wire [18:0] \chain_o$417[1] ;
  wire [18:0] \chain_o$417[2] ;
  wire [18:0] \chain_o$417[3] ;
  wire [75:0] \chain_o$425 ;
  wire [18:0] \chain_o$425[0] ;
  wire [18:0] \chain_o$425[1] ;
  wire [18:0] \chain_o$425[2] ;
  wire [18:0] \chain_o$425[3] ;
  wire [75:0] \chain_o$433 ;
  wire [18:0] \chain_o$433[0] ;
  wire [18:0] \chain_o$433[1] ;
  wire [18:0] \chain_o$433[2] ;
  wire [18:0] \chain_o$433[3] ;
  wire [75:0] \chain_o$441 ;
  wire [18:0] \chain_o$441[0] ;
  wire [18:0] \chain_o$441[1] ;
  wire [18:0] \chain_o$441[2] ;
  wire [18:0] \chain_o$441[3] ;
  wire [75:0] \chain_o$449 ;
  wire [18:0] \chain_o$449[0] ;
  wire [18:0] \chain_o$449[1] ;
  wire [18:0] \chain_o$449[2] ;
  wire [18:0] \chain_o$449[3] ;
  wire [75:0] \chain_o$457 ;
  wire [18:0] \chain_o$457[0] ;
  wire [18:0] \chain_o$457[1] ;
  wire [18:0] \chain_o$457[2] ;
  wire [18:0] \chain_o$457[3] ;
  wire [75:0] \chain_o$465 ;
  wire [18:0] \chain_o$465[0] ;
  wire [18:0] \chain_o$465[1] ;
  wire [18:0] \chain_o$465[2] ;
  wire [18:0] \chain_o$465[3] ;
  wire [75:0] \chain_o$473 ;
  wire [18:0] \chain_o$473[0] ;
  wire [18:0] \chain_o$473[1] ;
  wire [18:0] \chain_o$473[2] ;
  wire [18:0] \chain_o$473[3] ;
  wire [75:0] \chain_o$481 ;
  wire [18:0] \chain_o$481[0] ;
  wire [18:0] \chain_o$481[1] ;
  wire [18:0] \chain_o$481[2] ;
  wire [18:0] \chain_o$481[3] ;
  wire [75:0] \chain_o$489 ;
  wire [18:0] \chain_o$489[0] ;
  wire [18:0] \chain_o$489[1] ;
  wire [18:0] \chain_o$489[2] ;
  wire [18:0] \chain_o$489[3] ;
  wire [75:0] \chain_o$497 ;
  wire [18:0] \chain_o$497[0] ;
  wire [18:0] \chain_o$497[1] ;
  wire [18:0] \chain_o$497[2] ;
  wire [18:0] \chain_o$497[3] ;
  wire [75:0] \chain_o$505 ;
  wire [18:0] \chain_o$505[0] ;
  wire [18:0] \chain_o$505[1] ;
  wire [18:0] \chain_o$505[2] ;
  wire [18:0] \chain_o$505[3] ;
  wire [75:0] \chain_o$513 ;
  wire [18:0] \chain_o$513[0] ;
  wire [18:0] \chain_o$513[1] ;
  wire [18:0] \chain_o$513[2] ;
  wire [18:0] \chain_o$513[3] ;
  wire [75:0] \chain_o$521 ;
  wire [18:0] \chain_o$521[0] ;
  wire [18:0] \chain_o$521[1] ;
  wire [18:0] \chain_o$521[2] ;
  wire [18:0] \chain_o$521[3] ;
  wire [75:0] \chain_o$529 ;
  wire [18:0] \chain_o$529[0] ;
  wire [18:0] \chain_o$529[1] ;
  wire [18:0] \chain_o$529[2] ;
  wire [18:0] \chain_o$529[3] ;
  wire [75:0] \chain_o$537 ;
  wire [18:0] \chain_o$537[0] ;
  wire [18:0] \chain_o$537[1] ;
  wire [18:0] \chain_o$537[2] ;
  wire [18:0] \chain_o$537[3] ;
  wire [75:0] \chain_o$545 ;
  wire [18:0] \chain_o$545[0] ;
  wire [18:0] \chain_o$545[1] ;
  wire [18:0] \chain_o$545[2] ;
  wire [18:0] \chain_o$545[3] ;
  wire [75:0] \chain_o$553 ;
  wire [18:0] \chain_o$553[0] ;
  wire [18:0] \chain_o$553[1] ;
  wire [18:0] \chain_o$553[2] ;
  wire [18:0] \chain_o$553[3] ;
  wire [75:0] \chain_o$561 ;
  wire [18:0] \chain_o$561[0] ;
  wire [18:0] \chain_o$561[1] ;
  wire [18:0] \chain_o$561[2] ;
  wire [18:0] \chain_o$561[3] ;
  wire [75:0] \chain_o$569 ;
  wire [18:0] \chain_o$569[0] ;
  wire [18:0] \chain_o$569[1] ;
  wire [18:0] \chain_o$569[2] ;
  wire [18:0] \chain_o$569[3] ;
  wire [75:0] \chain_o$577 ;
  wire [18:0] \chain_o$577[0] ;
  wire [18:0] \chain_o$577[1] ;
  wire [18:0] \chain_o$577[2] ;
  wire [18:0] \chain_o$577[3] ;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [2:0] command;
  reg [7:0] control = 8'h00;
  (* init = 8'h00 *)
  wire [7:0] \control$107 ;
  wire \control$107.edge ;
  wire \control$107.en ;
  wire \control$107.first ;
  wire \control$107.last ;
  wire [3:0] \control$107.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$116 ;
  wire \control$116.edge ;
  wire \control$116.en ;
  wire \control$116.first ;
  wire \control$116.last ;
  wire [3:0] \control$116.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$125 ;
  wire \control$125.edge ;
  wire \control$125.en ;
  wire \control$125.first ;
  wire \control$125.last ;
  wire [3:0] \control$125.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$134 ;
  wire \control$134.edge ;
  wire \control$134.en ;
  wire \control$134.first ;
  wire \control$134.last ;
  wire [3:0] \control$134.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$142 ;
  wire \control$142.edge ;
  wire \control$142.en ;
  wire \control$142.first ;
  wire \control$142.last ;
  wire [3:0] \control$142.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$150 ;
  wire \control$150.edge ;
  wire \control$150.en ;
  wire \control$150.first ;
  wire \control$150.last ;
  wire [3:0] \control$150.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$158 ;
  wire \control$158.edge ;
  wire \control$158.en ;
  wire \control$158.first ;
  wire \control$158.last ;
  wire [3:0] \control$158.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$166 ;
  wire \control$166.edge ;
  wire \control$166.en ;
  wire \control$166.first ;
  wire \control$166.last ;
  wire [3:0] \control$166.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$174 ;
  wire \control$174.edge ;
  wire \control$174.en ;
  wire \control$174.first ;
  wire \control$174.last ;
  wire [3:0] \control$174.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$182 ;
  wire \control$182.edge ;
  wire \control$182.en ;
  wire \control$182.first ;
  wire \control$182.last ;
  wire [3:0] \control$182.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$190 ;
  wire \control$190.edge ;
  wire \control$190.en ;
  wire \control$190.first ;
  wire \control$190.last ;
  wire [3:0] \control$190.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$198 ;
  wire \control$198.edge ;
  wire \control$198.en ;
  wire \control$198.first ;
  wire \control$198.last ;
  wire [3:0] \control$198.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$206 ;
  wire \control$206.edge ;
  wire \control$206.en ;
  wire \control$206.first ;
  wire \control$206.last ;
  wire [3:0] \control$206.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$214 ;
  wire \control$214.edge ;
  wire \control$214.en ;
  wire \control$214.first ;
  wire \control$214.last ;
  wire [3:0] \control$214.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$222 ;
  wire \control$222.edge ;
  wire \control$222.en ;
  wire \control$222.first ;
  wire \control$222.last ;
  wire [3:0] \control$222.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$230 ;
  wire \control$230.edge ;
  wire \control$230.en ;
  wire \control$230.first ;
  wire \control$230.last ;
  wire [3:0] \control$230.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$238 ;
  wire \control$238.edge ;
  wire \control$238.en ;
  wire \control$238.first ;
  wire \control$238.last ;
  wire [3:0] \control$238.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$246 ;
  wire \control$246.edge ;
  wire \control$246.en ;
  wire \control$246.first ;
  wire \control$246.last ;
  wire [3:0] \control$246.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$254 ;
  wire \control$254.edge ;
  wire \control$254.en ;
  wire \control$254.first ;
  wire \control$254.last ;
  wire [3:0] \control$254.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$262 ;
  wire \control$262.edge ;
  wire \control$262.en ;
  wire \control$262.first ;
  wire \control$262.last ;
  wire [3:0] \control$262.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$270 ;
  wire \control$270.edge ;
  wire \control$270.en ;
  wire \control$270.first ;
  wire \control$270.last ;
  wire [3:0] \control$270.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$278 ;
  wire \control$278.edge ;
  wire \control$278.en ;
  wire \control$278.first ;
  wire \control$278.last ;
  wire [3:0] \control$278.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$286 ;
  wire \control$286.edge ;
  wire \control$286.en ;
  wire \control$286.first ;
  wire \control$286.last ;
  wire [3:0] \control$286.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$294 ;
  wire \control$294.edge ;
  wire \control$294.en ;
  wire \control$294.first ;
  wire \control$294.last ;
  wire [3:0] \control$294.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$302 ;
  wire \control$302.edge ;
  wire \control$302.en ;
  wire \control$302.first ;
  wire \control$302.last ;
  wire [3:0] \control$302.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$310 ;
  wire \control$310.edge ;
  wire \control$310.en ;
  wire \control$310.first ;
  wire \control$310.last ;
  wire [3:0] \control$310.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$318 ;
  wire \control$318.edge ;
  wire \control$318.en ;
  wire \control$318.first ;
  wire \control$318.last ;
  wire [3:0] \control$318.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$326 ;
  wire \control$326.edge ;
  wire \control$326.en ;
  wire \control$326.first ;
  wire \control$326.last ;
  wire [3:0] \control$326.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$334 ;
  wire \control$334.edge ;
  wire \control$334.en ;
  wire \control$334.first ;
  wire \control$334.last ;
  wire [3:0] \control$334.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$342 ;
  wire \control$342.edge ;
  wire \control$342.en ;
  wire \control$342.first ;
  wire \control$342.last ;
  wire [3:0] \control$342.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$350 ;
  wire \control$350.edge ;
  wire \control$350.en ;
  wire \control$350.first ;
  wire \control$350.last ;
  wire [3:0] \control$350.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$358 ;
  wire \control$358.edge ;
  wire \control$358.en ;
  wire \control$358.first ;
  wire \control$358.last ;
  wire [3:0] \control$358.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$366 ;
  wire \control$366.edge ;
  wire \control$366.en ;
  wire \control$366.first ;
  wire \control$366.last ;
  wire [3:0] \control$366.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$374 ;
  wire \control$374.edge ;
  wire \control$374.en ;
  wire \control$374.first ;
  wire \control$374.last ;
  wire [3:0] \control$374.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$382 ;
  wire \control$382.edge ;
  wire \control$382.en ;
  wire \control$382.first ;
  wire \control$382.last ;
  wire [3:0] \control$382.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$390 ;
  wire \control$390.edge ;
  wire \control$390.en ;
  wire \control$390.first ;
  wire \control$390.last ;
  wire [3:0] \control$390.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$398 ;
  wire \control$398.edge ;
  wire \control$398.en ;
  wire \control$398.first ;
  wire \control$398.last ;
  wire [3:0] \control$398.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$406 ;
  wire \control$406.edge ;
  wire \control$406.en ;
  wire \control$406.first ;
  wire \control$406.last ;
  wire [3:0] \control$406.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$414 ;
  wire \control$414.edge ;
  wire \control$414.en ;
  wire \control$414.first ;
  wire \control$414.last ;
  wire [3:0] \control$414.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$422 ;
  wire \control$422.edge ;
  wire \control$422.en ;
  wire \control$422.first ;
  wire \control$422.last ;
  wire [3:0] \control$422.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$430 ;
  wire \control$430.edge ;
  wire \control$430.en ;
  wire \control$430.first ;
  wire \control$430.last ;
  wire [3:0] \control$430.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$438 ;
  wire \control$438.edge ;
  wire \control$438.en ;
  wire \control$438.first ;
  wire \control$438.last ;
  wire [3:0] \control$438.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$446 ;
  wire \control$446.edge ;
  wire \control$446.en ;
  wire \control$446.first ;
  wire \control$446.last ;
  wire [3:0] \control$446.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$454 ;
  wire \control$454.edge ;
  wire \control$454.en ;
  wire \control$454.first ;
  wire \control$454.last ;
  wire [3:0] \control$454.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$462 ;
  wire \control$462.edge ;
  wire \control$462.en ;
  wire \control$462.first ;
  wire \control$462.last ;
  wire [3:0] \control$462.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$470 ;
  wire \control$470.edge ;
  wire \control$470.en ;
  wire \control$470.first ;
  wire \control$470.last ;
  wire [3:0] \control$470.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$478 ;
  wire \control$478.edge ;
  wire \control$478.en ;
  wire \control$478.first ;
  wire \control$478.last ;
  wire [3:0] \control$478.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$486 ;
  wire \control$486.edge ;
  wire \control$486.en ;
  wire \control$486.first ;
  wire \control$486.last ;
  wire [3:0] \control$486.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$494 ;
  wire \control$494.edge ;
  wire \control$494.en ;
  wire \control$494.first ;
  wire \control$494.last ;
  wire [3:0] \control$494.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$502 ;
  wire \control$502.edge ;
  wire \control$502.en ;
  wire \control$502.first ;
  wire \control$502.last ;
  wire [3:0] \control$502.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$510 ;
  wire \control$510.edge ;
  wire \control$510.en ;
  wire \control$510.first ;
  wire \control$510.last ;
  wire [3:0] \control$510.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$518 ;
  wire \control$518.edge ;
  wire \control$518.en ;
  wire \control$518.first ;
  wire \control$518.last ;
  wire [3:0] \control$518.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$526 ;
  wire \control$526.edge ;
  wire \control$526.en ;
  wire \control$526.first ;
  wire \control$526.last ;
  wire [3:0] \control$526.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$534 ;
  wire \control$534.edge ;
  wire \control$534.en ;
  wire \control$534.first ;
  wire \control$534.last ;
  wire [3:0] \control$534.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$542 ;
  wire \control$542.edge ;
  wire \control$542.en ;
  wire \control$542.first ;
  wire \control$542.last ;
  wire [3:0] \control$542.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$550 ;
  wire \control$550.edge ;
  wire \control$550.en ;
  wire \control$550.first ;
  wire \control$550.last ;
  wire [3:0] \control$550.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$558 ;
  wire \control$558.edge ;
  wire \control$558.en ;
  wire \control$558.first ;
  wire \control$558.last ;
  wire [3:0] \control$558.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$566 ;
  wire \control$566.edge ;
  wire \control$566.en ;
  wire \control$566.first ;
  wire \control$566.last ;
  wire [3:0] \control$566.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$574 ;
  wire \control$574.edge ;
  wire \control$574.en ;
  wire \control$574.first ;
  wire \control$574.last ;
  wire [3:0] \control$574.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$582 ;
  wire \control$582.edge ;
  wire \control$582.en ;
  wire \control$582.first ;
  wire \control$582.last ;
  wire [3:0] \control$582.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$588 ;
  wire \control$588.edge ;
  wire \control$588.en ;
  wire \control$588.first ;
  wire \control$588.last ;
  wire [3:0] \control$588.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$594 ;
  wire \control$594.edge ;
  wire \control$594.en ;
  wire \control$594.first ;
  wire \control$594.last ;
  wire [3:0] \control$594.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$600 ;
  wire \control$600.edge ;
  wire \control$600.en ;
  wire \control$600.first ;
  wire \control$600.last ;
  wire [3:0] \control$600.tile ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  reg [7:0] control0 = 8'h00;
  wire \control0.edge ;
  wire \control0.en ;
  wire \control0.first ;
  wire \control0.last ;
  wire [3:0] \control0.tile ;
  reg [7:0] control1 = 8'h00;
  wire \control1.edge ;
  wire \control1.en ;
  wire \control1.first ;
  wire \control1.last ;
  wire [3:0] \control1.tile ;
  (* init = 8'h00 *)
  wire [7:0] control2;
  wire \control2.edge ;
  wire \control2.en ;
  wire \control2.first ;
  wire \control2.last ;
  wire [3:0] \control2.tile ;
  reg [7:0] control3 = 8'h00;
  wire \control3.edge ;
  wire \control3.en ;
  wire \control3.first ;
  wire \control3.last ;
  wire [3:0] \control3.tile ;
  wire credit;
  wire \credit$79 ;
  output [31:0] cycles;
  reg [31:0] cycles = 32'd0;
  output done;
  reg done = 1'h0;
  output [31:0] drain_cycles;
  reg [31:0] drain_cycles = 32'd0;
  reg ended = 1'h0;
  (* enum_base_type = "Error" *)
  (* enum_value_000 = "NONE" *)
  (* enum_value_001 = "BAD_SHAPE" *)
  (* enum_value_010 = "BAD_MODE" *)
  (* enum_value_011 = "TLAST_EARLY" *)
  (* enum_value_100 = "TLAST_MISSING" *)
  (* enum_value_101 = "BAD_COMMAND" *)
  wire [2:0] error;
  (* enum_base_type = "Error" *)
  (* enum_value_000 = "NONE" *)
  (* enum_value_001 = "BAD_SHAPE" *)
  (* enum_value_010 = "BAD_MODE" *)
  (* enum_value_011 = "TLAST_EARLY" *)
  (* enum_value_100 = "TLAST_MISSING" *)
  (* enum_value_101 = "BAD_COMMAND" *)
  output [2:0] \error$609 ;
  reg [2:0] \error$609  = 3'h0;
  (* enum_base_type = "Error" *)
  (* enum_value_000 = "NONE" *)
  (* enum_value_001 = "BAD_SHAPE" *)
  (* enum_value_010 = "BAD_MODE" *)
  (* enum_value_011 = "TLAST_EARLY" *)
  (* enum_value_100 = "TLAST_MISSING" *)
  (* enum_value_101 = "BAD_COMMAND" *)
  wire [2:0] \error$613 ;
  (* enum_base_type = "Error" *)
  (* enum_value_000 = "NONE" *)
  (* enum_value_001 = "BAD_SHAPE" *)
  (* enum_value_010 = "BAD_MODE" *)
  (* enum_value_011 = "TLAST_EARLY" *)
  (* enum_value_100 = "TLAST_MISSING" *)
  (* enum_value_101 = "BAD_COMMAND" *)
  wire [2:0] \error$614 ;
  wire fault;
  wire \fault$612 ;
  output [31:0] fill_cycles;
  reg [31:0] fill_cycles = 32'd0;
  wire finished;
  wire flushing;
  wire group_written;
  wire \group_written$75 ;
  wire [303:0] heads;
  wire [75:0] \heads[0] ;
  wire [18:0] \heads[0][0] ;
  wire [18:0] \heads[0][1] ;
  wire [18:0] \heads[0][2] ;
  wire [18:0] \heads[0][3] ;
  wire [75:0] \heads[1] ;
  wire [18:0] \heads[1][0] ;
  wire [18:0] \heads[1][1] ;
  wire [18:0] \heads[1][2] ;
  wire [18:0] \heads[1][3] ;
  wire [75:0] \heads[2] ;
  wire [18:0] \heads[2][0] ;
  wire [18:0] \heads[2][1] ;
  wire [18:0] \heads[2][2] ;
  wire [18:0] \heads[2][3] ;
  wire [75:0] \heads[3] ;
  wire [18:0] \heads[3][0] ;
  wire [18:0] \heads[3][1] ;
  wire [18:0] \heads[3][2] ;
  wire [18:0] \heads[3][3] ;
  input [31:0] height;
  wire [31:0] height;
  wire [31:0] \height$1 ;
  input [64:0] i__payload;
  wire [64:0] i__payload;
  wire [64:0] \i__payload$24 ;
  wire [63:0] \i__payload$24.data ;
  wire \i__payload$24.last ;
  wire [63:0] \i__payload$29 ;
  wire [47:0] \i__payload$35 ;
  wire [49:0] \i__payload$41 ;
  wire [47:0] \i__payload$41.data ;
  wire \i__payload$41.last ;
  wire \i__payload$41.pixel_last ;
  input [64:0] \i__payload$53 ;
  wire [64:0] \i__payload$53 ;
  wire [63:0] \i__payload$53.data ;
  wire \i__payload$53.last ;
  wire [63:0] \i__payload.data ;
  wire \i__payload.last ;
  output i__ready;
  wire i__ready;
  wire \i__ready$26 ;
  wire \i__ready$32 ;
  wire \i__ready$38 ;
  wire \i__ready$44 ;
  wire \i__ready$56 ;
  input i__valid;
  wire i__valid;
  wire \i__valid$28 ;
  wire \i__valid$33 ;
  wire \i__valid$39 ;
  wire \i__valid$45 ;
  input \i__valid$57 ;
  wire \i__valid$57 ;
  wire image_written;
  wire \image_written$77 ;
  reg [9:0] info = 10'h000;
  wire \info.image_last ;
  wire [3:0] \info.slots ;
  wire [3:0] \info.tile ;
  wire \info.tile_last ;
  reg [9:0] info0 = 10'h000;
  wire \info0.image_last ;
  wire [3:0] \info0.slots ;
  wire [3:0] \info0.tile ;
  wire \info0.tile_last ;
  reg [9:0] info1 = 10'h000;
  wire \info1.image_last ;
  wire [3:0] \info1.slots ;
  wire [3:0] \info1.tile ;
  wire \info1.tile_last ;
  reg [9:0] info2 = 10'h000;
  wire \info2.image_last ;
  wire [3:0] \info2.slots ;
  wire [3:0] \info2.tile ;
  wire \info2.tile_last ;
  (* init = 10'h000 *)
  wire [9:0] info3;
  wire \info3.image_last ;
  wire [3:0] \info3.slots ;
  wire [3:0] \info3.tile ;
  wire \info3.tile_last ;
  output [31:0] input_stalls;
  reg [31:0] input_stalls = 32'd0;
  wire issue;
  wire last_beat;
  output [31:0] mac_cycles;
  reg [31:0] mac_cycles = 32'd0;
  input [31:0] mode;
  wire [31:0] mode;
  wire [31:0] \mode$9 ;
  wire [63:0] o__payload;
  wire [47:0] \o__payload$36 ;
  wire [49:0] \o__payload$42 ;
  wire [47:0] \o__payload$42.data ;
  wire \o__payload$42.last ;
  wire \o__payload$42.pixel_last ;
  output [64:0] \o__payload$47 ;
  wire [64:0] \o__payload$47 ;
  wire [63:0] \o__payload$47.data ;
  wire \o__payload$47.last ;
  wire [64:0] \o__payload$48 ;
  wire [63:0] \o__payload$48.data ;
  wire \o__payload$48.last ;
  wire o__ready;
  wire \o__ready$37 ;
  wire \o__ready$43 ;
  input \o__ready$49 ;
  wire \o__ready$49 ;
  wire \o__ready$50 ;
  wire o__valid;
  wire \o__valid$40 ;
  wire \o__valid$46 ;
  output \o__valid$51 ;
  wire \o__valid$51 ;
  wire \o__valid$52 ;
  output [31:0] output_stalls;
  reg [31:0] output_stalls = 32'd0;
  wire [64:0] params__payload;
  wire [63:0] \params__payload.data ;
  wire \params__payload.last ;
  wire params__ready;
  wire params__valid;
  input [3:0] \port$1022$0 ;
  wire [3:0] \port$1022$0 ;
  wire [14:0] read;
  wire [7:0] \read.address ;
  wire \read.bank ;
  wire [3:0] \read.mask ;
  wire [1:0] \read.slot ;
  wire [543:0] requant;
  wire [7:0] \requant.addr ;
  wire [535:0] \requant.data ;
  wire requant_en;
  wire retire;
  wire \retire$71 ;
  input rst;
  wire rst;
  reg running = 1'h0;
  wire [132:0] shape;
  wire [132:0] \shape$13 ;
  wire [15:0] \shape$13.beats_in ;
  wire [15:0] \shape$13.beats_out ;
  wire [13:0] \shape$13.blocks ;
  wire [14:0] \shape$13.groups ;
  wire [15:0] \shape$13.height ;
  wire [13:0] \shape$13.ingest_words ;
  wire [11:0] \shape$13.output_words ;
  wire [1:0] \shape$13.tail ;
  wire [11:0] \shape$13.tiles ;
  wire [15:0] \shape$13.width ;
  wire [132:0] \shape$59 ;
  wire [15:0] \shape$59.beats_in ;
  wire [15:0] \shape$59.beats_out ;
  wire [13:0] \shape$59.blocks ;
  wire [14:0] \shape$59.groups ;
  wire [15:0] \shape$59.height ;
  wire [13:0] \shape$59.ingest_words ;
  wire [11:0] \shape$59.output_words ;
  wire [1:0] \shape$59.tail ;
  wire [11:0] \shape$59.tiles ;
  wire [15:0] \shape$59.width ;
  wire [132:0] \shape$60 ;
  wire [15:0] \shape$60.beats_in ;
  wire [15:0] \shape$60.beats_out ;
  wire [13:0] \shape$60.blocks ;
  wire [14:0] \shape$60.groups ;
  wire [15:0] \shape$60.height ;
  wire [13:0] \shape$60.ingest_words ;
  wire [11:0] \shape$60.output_words ;
  wire [1:0] \shape$60.tail ;
  wire [11:0] \shape$60.tiles ;
  wire [15:0] \shape$60.width ;
  wire [132:0] \shape$61 ;
  wire [15:0] \shape$61.beats_in ;
  wire [15:0] \shape$61.beats_out ;
  wire [13:0] \shape$61.blocks ;
  wire [14:0] \shape$61.groups ;
  wire [15:0] \shape$61.height ;
  wire [13:0] \shape$61.ingest_words ;
  wire [11:0] \shape$61.output_words ;
  wire [1:0] \shape$61.tail ;
  wire [11:0] \shape$61.tiles ;
  wire [15:0] \shape$61.width ;
  wire [132:0] \shape$62 ;
  wire [15:0] \shape$62.beats_in ;
  wire [15:0] \shape$62.beats_out ;
  wire [13:0] \shape$62.blocks ;
  wire [14:0] \shape$62.groups ;
  wire [15:0] \shape$62.height ;
  wire [13:0] \shape$62.ingest_words ;
  wire [11:0] \shape$62.output_words ;
  wire [1:0] \shape$62.tail ;
  wire [11:0] \shape$62.tiles ;
  wire [15:0] \shape$62.width ;
  wire [15:0] \shape.beats_in ;
  wire [15:0] \shape.beats_out ;
  wire [13:0] \shape.blocks ;
  wire [14:0] \shape.groups ;
  wire [15:0] \shape.height ;
  wire [13:0] \shape.ingest_words ;
  wire [11:0] \shape.output_words ;
  wire [1:0] \shape.tail ;
  wire [11:0] \shape.tiles ;
  wire [15:0] \shape.width ;
  wire shift;
  wire \shift$108 ;
  wire \shift$117 ;
  wire \shift$126 ;
  wire \shift$135 ;
  wire \shift$143 ;
  wire \shift$151 ;
  wire \shift$159 ;
  wire \shift$167 ;
  wire \shift$175 ;
  wire \shift$183 ;
  wire \shift$191 ;
  wire \shift$199 ;
  wire \shift$207 ;
  wire \shift$215 ;
  wire \shift$223 ;
  wire \shift$231 ;
  wire \shift$239 ;
  wire \shift$247 ;
  wire \shift$255 ;
  wire \shift$263 ;
  wire \shift$271 ;
  wire \shift$279 ;
  wire \shift$287 ;
  wire \shift$295 ;
  wire \shift$303 ;
  wire \shift$311 ;
  wire \shift$319 ;
  wire \shift$327 ;
  wire \shift$335 ;
  wire \shift$343 ;
  wire \shift$351 ;
  wire \shift$359 ;
  wire \shift$367 ;
  wire \shift$375 ;
  wire \shift$383 ;
  wire \shift$391 ;
  wire \shift$399 ;
  wire \shift$407 ;
  wire \shift$415 ;
  wire \shift$423 ;
  wire \shift$431 ;
  wire \shift$439 ;
  wire \shift$447 ;
  wire \shift$455 ;
  wire \shift$463 ;
  wire \shift$471 ;
  wire \shift$479 ;
  wire \shift$487 ;
  wire \shift$495 ;
  wire \shift$503 ;
  wire \shift$511 ;
  wire \shift$519 ;
  wire \shift$527 ;
  wire \shift$535 ;
  wire \shift$543 ;
  wire \shift$551 ;
  wire \shift$559 ;
  wire \shift$567 ;
  wire \shift$575 ;
  wire \shift$583 ;
  wire \shift$589 ;
  wire \shift$595 ;
  wire \shift$601 ;
  wire \shift$98 ;
  wire soft_reset;
  wire start;
  wire \start$63 ;
  wire \start$64 ;
  wire \start$65 ;
  wire \start$66 ;
  reg start_requant;
  reg start_weights;
  wire starved;
  wire [41:0] step;
  wire [7:0] \step.control ;
  wire \step.control.edge ;
  wire \step.control.en ;
  wire \step.control.first ;
  wire \step.control.last ;
  wire [3:0] \step.control.tile ;
  wire [9:0] \step.info ;
  wire \step.info.image_last ;
  wire [3:0] \step.info.slots ;
  wire [3:0] \step.info.tile ;
  wire \step.info.tile_last ;
  wire [14:0] \step.read ;
  wire [7:0] \step.read.address ;
  wire \step.read.bank ;
  wire [3:0] \step.read.mask ;
  wire [1:0] \step.read.slot ;
  wire [8:0] \step.weight ;
  wire [63:0] unit_en;
  reg [1:0] \wait  = 2'h0;
  wire [80:0] weight;
  wire [8:0] \weight.addr ;
  wire [71:0] \weight.data ;
  input [31:0] width;
  wire [31:0] width;
  wire [31:0] \width$3 ;
  wire [95:0] word;
  input [31:0] words;
  wire [31:0] words;
  wire [31:0] \words$11 ;
  wire [15:0] words_per_pixel;
  wire [543:0] write;
  wire [80:0] \write$105 ;
  wire [8:0] \write$105.addr ;
  wire [71:0] \write$105.data ;
  wire [80:0] \write$114 ;
  wire [8:0] \write$114.addr ;
  wire [71:0] \write$114.data ;
  wire [80:0] \write$123 ;
  wire [8:0] \write$123.addr ;
  wire [71:0] \write$123.data ;
  wire [80:0] \write$132 ;
  wire [8:0] \write$132.addr ;
  wire [71:0] \write$132.data ;
  wire [80:0] \write$140 ;
  wire [8:0] \write$140.addr ;
  wire [71:0] \write$140.data ;
  wire [80:0] \write$148 ;
  wire [8:0] \write$148.addr ;
  wire [71:0] \write$148.data ;
  wire [80:0] \write$156 ;
  wire [8:0] \write$156.addr ;
  wire [71:0] \write$156.data ;
  wire [80:0] \write$164 ;
  wire [8:0] \write$164.addr ;
  wire [71:0] \write$164.data ;
  wire [80:0] \write$172 ;
  wire [8:0] \write$172.addr ;
  wire [71:0] \write$172.data ;
  wire [80:0] \write$180 ;
  wire [8:0] \write$180.addr ;
  wire [71:0] \write$180.data ;
  wire [80:0] \write$188 ;
  wire [8:0] \write$188.addr ;
  wire [71:0] \write$188.data ;
  wire [80:0] \write$196 ;
  wire [8:0] \write$196.addr ;
  wire [71:0] \write$196.data ;
  wire [80:0] \write$204 ;
  wire [8:0] \write$204.addr ;
  wire [71:0] \write$204.data ;
  wire [80:0] \write$212 ;
  wire [8:0] \write$212.addr ;
  wire [71:0] \write$212.data ;
  wire [80:0] \write$220 ;
  wire [8:0] \write$220.addr ;
  wire [71:0] \write$220.data ;
  wire [80:0] \write$228 ;
  wire [8:0] \write$228.addr ;
  wire [71:0] \write$228.data ;
  wire [80:0] \write$236 ;
  wire [8:0] \write$236.addr ;
  wire [71:0] \write$236.data ;
  wire [80:0] \write$244 ;
  wire [8:0] \write$244.addr ;
  wire [71:0] \write$244.data ;
  wire [80:0] \write$252 ;
  wire [8:0] \write$252.addr ;
  wire [71:0] \write$252.data ;
  wire [80:0] \write$260 ;
  wire [8:0] \write$260.addr ;
  wire [71:0] \write$260.data ;
  wire [80:0] \write$268 ;
  wire [8:0] \write$268.addr ;
  wire [71:0] \write$268.data ;
  wire [80:0] \write$276 ;
  wire [8:0] \write$276.addr ;
  wire [71:0] \write$276.data ;
  wire [80:0] \write$284 ;
  wire [8:0] \write$284.addr ;
  wire [71:0] \write$284.data ;
  wire [80:0] \write$292 ;
  wire [8:0] \write$292.addr ;
  wire [71:0] \write$292.data ;
  wire [80:0] \write$300 ;
  wire [8:0] \write$300.addr ;
  wire [71:0] \write$300.data ;
  wire [80:0] \write$308 ;
  wire [8:0] \write$308.addr ;
  wire [71:0] \write$308.data ;
  wire [80:0] \write$316 ;
  wire [8:0] \write$316.addr ;
  wire [71:0] \write$316.data ;
  wire [80:0] \write$324 ;
  wire [8:0] \write$324.addr ;
  wire [71:0] \write$324.data ;
  wire [80:0] \write$332 ;
  wire [8:0] \write$332.addr ;
  wire [71:0] \write$332.data ;
  wire [80:0] \write$340 ;
  wire [8:0] \write$340.addr ;
  wire [71:0] \write$340.data ;
  wire [80:0] \write$348 ;
  wire [8:0] \write$348.addr ;
  wire [71:0] \write$348.data ;
  wire [80:0] \write$356 ;
  wire [8:0] \write$356.addr ;
  wire [71:0] \write$356.data ;
  wire [80:0] \write$364 ;
  wire [8:0] \write$364.addr ;
  wire [71:0] \write$364.data ;
  wire [80:0] \write$372 ;
  wire [8:0] \write$372.addr ;
  wire [71:0] \write$372.data ;
  wire [80:0] \write$380 ;
  wire [8:0] \write$380.addr ;
  wire [71:0] \write$380.data ;
  wire [80:0] \write$388 ;
  wire [8:0] \write$388.addr ;
  wire [71:0] \write$388.data ;
  wire [80:0] \write$396 ;
  wire [8:0] \write$396.addr ;
  wire [71:0] \write$396.data ;
  wire [80:0] \write$404 ;
  wire [8:0] \write$404.addr ;
  wire [71:0] \write$404.data ;
  wire [80:0] \write$412 ;
  wire [8:0] \write$412.addr ;
  wire [71:0] \write$412.data ;
  wire [80:0] \write$420 ;
  wire [8:0] \write$420.addr ;
  wire [71:0] \write$420.data ;
  wire [80:0] \write$428 ;
  wire [8:0] \write$428.addr ;
  wire [71:0] \write$428.data ;
  wire [80:0] \write$436 ;
  wire [8:0] \write$436.addr ;
  wire [71:0] \write$436.data ;
  wire [80:0] \write$444 ;
  wire [8:0] \write$444.addr ;
  wire [71:0] \write$444.data ;
  wire [80:0] \write$452 ;
  wire [8:0] \write$452.addr ;
  wire [71:0] \write$452.data ;
  wire [80:0] \write$460 ;
  wire [8:0] \write$460.addr ;
  wire [71:0] \write$460.data ;
  wire [80:0] \write$468 ;
  wire [8:0] \write$468.addr ;
  wire [71:0] \write$468.data ;
  wire [80:0] \write$476 ;
  wire [8:0] \write$476.addr ;
  wire [71:0] \write$476.data ;
  wire [80:0] \write$484 ;
  wire [8:0] \write$484.addr ;
  wire [71:0] \write$484.data ;
  wire [80:0] \write$492 ;
  wire [8:0] \write$492.addr ;
  wire [71:0] \write$492.data ;
  wire [80:0] \write$500 ;
  wire [8:0] \write$500.addr ;
  wire [71:0] \write$500.data ;
  wire [80:0] \write$508 ;
  wire [8:0] \write$508.addr ;
  wire [71:0] \write$508.data ;
  wire [80:0] \write$516 ;
  wire [8:0] \write$516.addr ;
  wire [71:0] \write$516.data ;
  wire [80:0] \write$524 ;
  wire [8:0] \write$524.addr ;
  wire [71:0] \write$524.data ;
  wire [80:0] \write$532 ;
  wire [8:0] \write$532.addr ;
  wire [71:0] \write$532.data ;
  wire [80:0] \write$540 ;
  wire [8:0] \write$540.addr ;
  wire [71:0] \write$540.data ;
  wire [80:0] \write$548 ;
  wire [8:0] \write$548.addr ;
  wire [71:0] \write$548.data ;
  wire [80:0] \write$556 ;
  wire [8:0] \write$556.addr ;
  wire [71:0] \write$556.data ;
  wire [80:0] \write$564 ;
  wire [8:0] \write$564.addr ;
  wire [71:0] \write$564.data ;
  wire [80:0] \write$572 ;
  wire [8:0] \write$572.addr ;
  wire [71:0] \write$572.data ;
  wire [80:0] \write$580 ;
  wire [8:0] \write$580.addr ;
  wire [71:0] \write$580.data ;
  wire [80:0] \write$586 ;
  wire [8:0] \write$586.addr ;
  wire [71:0] \write$586.data ;
  wire [80:0] \write$592 ;
  wire [8:0] \write$592.addr ;
  wire [71:0] \write$592.data ;
  wire [80:0] \write$598 ;
  wire [8:0] \write$598.addr ;
  wire [71:0] \write$598.data ;
  wire [80:0] \write$91 ;
  wire [8:0] \write$91.addr ;
  wire [71:0] \write$91.data ;
  wire [7:0] \write.addr ;
  wire [535:0] \write.data ;
  wire write_en;
  wire \write_en$104 ;
  wire \write_en$113 ;
  wire \write_en$122 ;
  wire \write_en$131 ;
  wire \write_en$139 ;
  wire \write_en$147 ;
  wire \write_en$155 ;
  wire \write_en$163 ;
  wire \write_en$171 ;
  wire \write_en$179 ;
  wire \write_en$187 ;
  wire \write_en$195 ;
  wire \write_en$203 ;
  wire \write_en$211 ;
  wire \write_en$219 ;
  wire \write_en$227 ;
  wire \write_en$235 ;
  wire \write_en$243 ;
  wire \write_en$251 ;
  wire \write_en$259 ;
  wire \write_en$267 ;
  wire \write_en$275 ;
  wire \write_en$283 ;
  wire \write_en$291 ;
  wire \write_en$299 ;
  wire \write_en$307 ;
  wire \write_en$315 ;
  wire \write_en$323 ;
  wire \write_en$331 ;
  wire \write_en$339 ;
  wire \write_en$347 ;
  wire \write_en$355 ;
  wire \write_en$363 ;
  wire \write_en$371 ;
  wire \write_en$379 ;
  wire \write_en$387 ;
  wire \write_en$395 ;
  wire \write_en$403 ;
  wire \write_en$411 ;
  wire \write_en$419 ;
  wire \write_en$427 ;
  wire \write_en$435 ;
  wire \write_en$443 ;
  wire \write_en$451 ;
  wire \write_en$459 ;
  wire \write_en$467 ;
  wire \write_en$475 ;
  wire \write_en$483 ;
  wire \write_en$491 ;
  wire \write_en$499 ;
  wire \write_en$507 ;
  wire \write_en$515 ;
  wire \write_en$523 ;
  wire \write_en$531 ;
  wire \write_en$539 ;
  wire \write_en$547 ;
  wire \write_en$555 ;
  wire \write_en$563 ;
  wire \write_en$571 ;
  wire \write_en$579 ;
  wire \write_en$585 ;
  wire \write_en$591 ;
  wire \write_en$597 ;
  wire \write_en$89 ;
  assign \$22  = | \wait ;
  assign \$23  = \wait  - 1'h1;
  assign \$24  = \wait  == 1'h1;
  assign \$25  = ! error;
  assign \$26  = | \port$1022$0 [2:0];
  assign \$27  = ~ busy;
  assign \$28  = \$26  & \$27 ;
  assign \$29  = \port$1022$0 [2:0] - 1'h1;
  assign \$30  = { 1'h0, \port$1022$0 [2:0] } & \$29 ;
  assign \$31  = ! \$30 ;
  assign \$32  = ~ \$31 ;
  assign \$33  = \port$1022$0 [1] | \port$1022$0 [2];
  assign \$34  = ! words;
  assign \$35  = \port$1022$0 [2] ? 10'h100 : 10'h200;
  assign \$36  = words > \$35 ;
  assign \$37  = \$34  | \$36 ;
  assign \$38  = \$33  & \$37 ;
  assign \$39  = \$32  | \$38 ;
  assign \$40  = running & \o__valid$51 ;
  assign \$41  = \$40  & \o__ready$49 ;
  assign \$42  = \$41  & \o__payload$47 [64];
  assign \$43  = ! \error$609 ;
  assign \$44  = cycles + 1'h1;
  assign \$45  = ~ \$signal$621 ;
  assign \$46  = ~ flushing;
  assign \$47  = blocked & \$46 ;
  assign \$48  = mac_cycles + 1'h1;
  assign \$49  = fill_cycles + 1'h1;
  assign \$50  = input_stalls + 1'h1;
  assign \$51  = output_stalls + 1'h1;
  assign \$52  = drain_cycles + 1'h1;
  always @(posedge clk)
    \wait  <= \$53 ;
  always @(posedge clk)
    running <= \$54 ;
  always @(posedge clk)
    \error$609  <= \$55 ;
  always @(posedge clk)
    done <= \$56 ;
  always @(posedge clk)
    control0 <= \$57 ;
  always @(posedge clk)
    info0 <= step[41:32];
  always @(posedge clk)
    control1 <= \$58 ;
  always @(posedge clk)
    info1 <= info0;
  always @(posedge clk)
    control <= \$59 ;
  always @(posedge clk)
    info2 <= info1;
  always @(posedge clk)
    control3 <= \$60 ;
  always @(posedge clk)
    info <= info2;
  always @(posedge clk)
    \$signal$605  <= \$61 ;
  always @(posedge clk)
    \$signal$621  <= \$62 ;
  always @(posedge clk)
    ended <= \$63 ;
  always @(posedge clk)
    cycles <= \$64 ;
  always @(posedge clk)
    mac_cycles <= \$65 ;
  always @(posedge clk)
    fill_cycles <= \$66 ;
  always @(posedge clk)
    input_stalls <= \$67 ;
  always @(posedge clk)
    output_stalls <= \$68 ;
  always @(posedge clk)
    drain_cycles <= \$69 ;
  assign \$1  = running | \busy$16 ;
  assign \$2  = | \wait ;
  assign busy = \$1  | \$2 ;
  assign \$3  = \wait  == 1'h1;
  assign \$4  = ! error;
  assign start = \$3  & \$4 ;
  assign \$5  = | \port$1022$0 [2:0];
  assign \$6  = ~ busy;
  assign \$7  = \$5  & \$6 ;
  assign \$8  = \port$1022$0 [2:0] - 1'h1;
  assign \$9  = { 1'h0, \port$1022$0 [2:0] } & \$8 ;
  assign \$10  = ! \$9 ;
  assign \$11  = ~ \$10 ;
  assign \$12  = \port$1022$0 [1] | \port$1022$0 [2];
  assign \$13  = ! words;
  assign \$14  = \port$1022$0 [2] ? 10'h100 : 10'h200;
  assign \$15  = words > \$14 ;
  assign \$16  = \$13  | \$15 ;
  assign \$17  = \$12  & \$16 ;
  assign \$18  = \$11  | \$17 ;
  assign finished = control3[0] & control3[2];
  assign \$signal  = i__valid & i__ready;
  assign \$19  = \o__valid$51  & \o__ready$49 ;
  assign last_beat = \$19  & \o__payload$47 [64];
  assign \$20  = \$signal  | \$signal$605 ;
  assign \$21  = ~ ended;
  assign \$signal$604  = \$20  & \$21 ;
  \macram_top.array.decoder  decoder (
    .c_in(c_in),
    .c_out(c_out),
    .clk(clk),
    .error(error),
    .height(height),
    .mode(mode),
    .rst(rst),
    .shape(shape),
    .soft_reset(\port$1022$0 [3]),
    .width(width)
  );
  \macram_top.array.drain  drain (
    .clk(clk),
    .credit(credit),
    .finished(finished),
    .\heads$59 (heads),
    .info(info),
    .o__payload(\i__payload$41 ),
    .o__ready(\o__ready$43 ),
    .reload__addr(\$71 ),
    .reload__data(\$72 ),
    .reload__en(write_en),
    .rst(rst),
    .shape(shape),
    .shift(shift),
    .soft_reset(\port$1022$0 [3]),
    .start(start),
    .valid(\i__valid$45 )
  );
  \macram_top.array.emit  emit (
    .beats_per_pixel(shape[132:117]),
    .clk(clk),
    .i__payload(\i__payload$41 ),
    .i__ready(\o__ready$43 ),
    .i__valid(\i__valid$45 ),
    .o__payload(\o__payload$47 ),
    .o__ready(\o__ready$49 ),
    .o__valid(\o__valid$51 ),
    .rst(rst),
    .soft_reset(\port$1022$0 [3])
  );
  \macram_top.array.frame  frame (
    .clk(clk),
    .error(\error$613 ),
    .fault(fault),
    .i__payload(i__payload),
    .i__ready(i__ready),
    .i__valid(i__valid),
    .o__ready(o__ready),
    .o__valid(\i__valid$33 ),
    .rst(rst),
    .shape(shape),
    .soft_reset(\port$1022$0 [3]),
    .start(start)
  );
  \macram_top.array.ingest  ingest (
    .beats_per_pixel(shape[116:101]),
    .clk(clk),
    .i__payload(i__payload[63:0]),
    .i__ready(o__ready),
    .i__valid(\i__valid$33 ),
    .o__payload(\i__payload$35 ),
    .o__ready(\o__ready$37 ),
    .o__valid(\i__valid$39 ),
    .\port$1096$63 (shape[76:63]),
    .rst(rst),
    .soft_reset(\port$1022$0 [3])
  );
  \macram_top.array.lines  lines (
    .clk(clk),
    .group_written(group_written),
    .i__payload(\i__payload$35 ),
    .i__ready(\o__ready$37 ),
    .i__valid(\i__valid$39 ),
    .image_written(image_written),
    .read(step[14:0]),
    .retire(retire),
    .rst(rst),
    .shape(shape),
    .soft_reset(\port$1022$0 [3]),
    .start(start),
    .word(activations)
  );
  \macram_top.array.loader  loader (
    .clk(clk),
    .error(\error$614 ),
    .fault(\fault$612 ),
    .i__payload(\i__payload$53 ),
    .i__ready(\busy$16 ),
    .i__valid(\i__valid$57 ),
    .\port$1305$0 (\$70 ),
    .\port$1307$0 (\$71 ),
    .\port$1309$0 (\$72 ),
    .requant_en(write_en),
    .rst(rst),
    .soft_reset(\port$1022$0 [3]),
    .start_requant(start_requant),
    .start_weights(start_weights),
    .unit_en(unit_en),
    .words(words)
  );
  \macram_top.array.sequencer  sequencer (
    .blocked(blocked),
    .clk(clk),
    .credit(credit),
    .flushing(flushing),
    .group_written(group_written),
    .image_written(image_written),
    .issue(issue),
    .retire(retire),
    .rst(rst),
    .shape(shape),
    .soft_reset(\port$1022$0 [3]),
    .start(start),
    .starved(starved),
    .\step$37 (step)
  );
  \macram_top.array.unit000  unit000 (
    .address(step[23:15]),
    .chain_o(chain_o),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(chain_i),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[0])
  );
  \macram_top.array.unit001  unit001 (
    .address(step[23:15]),
    .chain_o(\chain_o$109 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$110 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[1])
  );
  \macram_top.array.unit002  unit002 (
    .address(step[23:15]),
    .chain_o(\chain_o$118 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$119 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[2])
  );
  \macram_top.array.unit003  unit003 (
    .address(step[23:15]),
    .chain_o(\chain_o$127 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$128 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[3])
  );
  \macram_top.array.unit004  unit004 (
    .address(step[23:15]),
    .chain_o(chain_i),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$136 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[4])
  );
  \macram_top.array.unit005  unit005 (
    .address(step[23:15]),
    .chain_o(\chain_i$110 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$144 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[5])
  );
  \macram_top.array.unit006  unit006 (
    .address(step[23:15]),
    .chain_o(\chain_i$119 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$152 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[6])
  );
  \macram_top.array.unit007  unit007 (
    .address(step[23:15]),
    .chain_o(\chain_i$128 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$160 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[7])
  );
  \macram_top.array.unit008  unit008 (
    .address(step[23:15]),
    .chain_o(\chain_i$136 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$168 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[8])
  );
  \macram_top.array.unit009  unit009 (
    .address(step[23:15]),
    .chain_o(\chain_i$144 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$176 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[9])
  );
  \macram_top.array.unit010  unit010 (
    .address(step[23:15]),
    .chain_o(\chain_i$152 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$184 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[10])
  );
  \macram_top.array.unit011  unit011 (
    .address(step[23:15]),
    .chain_o(\chain_i$160 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$192 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[11])
  );
  \macram_top.array.unit012  unit012 (
    .address(step[23:15]),
    .chain_o(\chain_i$168 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$200 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[12])
  );
  \macram_top.array.unit013  unit013 (
    .address(step[23:15]),
    .chain_o(\chain_i$176 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$208 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[13])
  );
  \macram_top.array.unit014  unit014 (
    .address(step[23:15]),
    .chain_o(\chain_i$184 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$216 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[14])
  );
  \macram_top.array.unit015  unit015 (
    .address(step[23:15]),
    .chain_o(\chain_i$192 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$224 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[15])
  );
  \macram_top.array.unit016  unit016 (
    .address(step[23:15]),
    .chain_o(\chain_i$200 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$232 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[16])
  );
  \macram_top.array.unit017  unit017 (
    .address(step[23:15]),
    .chain_o(\chain_i$208 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$240 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[17])
  );
  \macram_top.array.unit018  unit018 (
    .address(step[23:15]),
    .chain_o(\chain_i$216 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$248 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[18])
  );
  \macram_top.array.unit019  unit019 (
    .address(step[23:15]),
    .chain_o(\chain_i$224 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$256 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[19])
  );
  \macram_top.array.unit020  unit020 (
    .address(step[23:15]),
    .chain_o(\chain_i$232 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$264 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[20])
  );
  \macram_top.array.unit021  unit021 (
    .address(step[23:15]),
    .chain_o(\chain_i$240 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$272 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[21])
  );
  \macram_top.array.unit022  unit022 (
    .address(step[23:15]),
    .chain_o(\chain_i$248 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$280 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[22])
  );
  \macram_top.array.unit023  unit023 (
    .address(step[23:15]),
    .chain_o(\chain_i$256 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$288 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[23])
  );
  \macram_top.array.unit024  unit024 (
    .address(step[23:15]),
    .chain_o(\chain_i$264 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$296 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[24])
  );
  \macram_top.array.unit025  unit025 (
    .address(step[23:15]),
    .chain_o(\chain_i$272 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$304 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[25])
  );
  \macram_top.array.unit026  unit026 (
    .address(step[23:15]),
    .chain_o(\chain_i$280 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$312 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[26])
  );
  \macram_top.array.unit027  unit027 (
    .address(step[23:15]),
    .chain_o(\chain_i$288 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$320 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[27])
  );
  \macram_top.array.unit028  unit028 (
    .address(step[23:15]),
    .chain_o(\chain_i$296 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$328 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[28])
  );
  \macram_top.array.unit029  unit029 (
    .address(step[23:15]),
    .chain_o(\chain_i$304 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$336 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[29])
  );
  \macram_top.array.unit030  unit030 (
    .address(step[23:15]),
    .chain_o(\chain_i$312 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$344 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[30])
  );
  \macram_top.array.unit031  unit031 (
    .address(step[23:15]),
    .chain_o(\chain_i$320 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$352 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[31])
  );
  \macram_top.array.unit032  unit032 (
    .address(step[23:15]),
    .chain_o(\chain_i$328 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$360 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[32])
  );
  \macram_top.array.unit033  unit033 (
    .address(step[23:15]),
    .chain_o(\chain_i$336 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$368 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[33])
  );
  \macram_top.array.unit034  unit034 (
    .address(step[23:15]),
    .chain_o(\chain_i$344 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$376 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[34])
  );
  \macram_top.array.unit035  unit035 (
    .address(step[23:15]),
    .chain_o(\chain_i$352 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$384 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[35])
  );
  \macram_top.array.unit036  unit036 (
    .address(step[23:15]),
    .chain_o(\chain_i$360 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$392 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[36])
  );
  \macram_top.array.unit037  unit037 (
    .address(step[23:15]),
    .chain_o(\chain_i$368 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$400 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[37])
  );
  \macram_top.array.unit038  unit038 (
    .address(step[23:15]),
    .chain_o(\chain_i$376 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$408 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[38])
  );
  \macram_top.array.unit039  unit039 (
    .address(step[23:15]),
    .chain_o(\chain_i$384 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$416 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[39])
  );
  \macram_top.array.unit040  unit040 (
    .address(step[23:15]),
    .chain_o(\chain_i$392 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$424 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[40])
  );
  \macram_top.array.unit041  unit041 (
    .address(step[23:15]),
    .chain_o(\chain_i$400 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$432 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[41])
  );
  \macram_top.array.unit042  unit042 (
    .address(step[23:15]),
    .chain_o(\chain_i$408 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$440 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[42])
  );
  \macram_top.array.unit043  unit043 (
    .address(step[23:15]),
    .chain_o(\chain_i$416 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$448 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[43])
  );
  \macram_top.array.unit044  unit044 (
    .address(step[23:15]),
    .chain_o(\chain_i$424 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$456 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[44])
  );
  \macram_top.array.unit045  unit045 (
    .address(step[23:15]),
    .chain_o(\chain_i$432 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$464 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[45])
  );
  \macram_top.array.unit046  unit046 (
    .address(step[23:15]),
    .chain_o(\chain_i$440 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$472 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[46])
  );
  \macram_top.array.unit047  unit047 (
    .address(step[23:15]),
    .chain_o(\chain_i$448 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$480 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[47])
  );
  \macram_top.array.unit048  unit048 (
    .address(step[23:15]),
    .chain_o(\chain_i$456 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$488 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[48])
  );
  \macram_top.array.unit049  unit049 (
    .address(step[23:15]),
    .chain_o(\chain_i$464 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$496 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[49])
  );
  \macram_top.array.unit050  unit050 (
    .address(step[23:15]),
    .chain_o(\chain_i$472 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$504 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[50])
  );
  \macram_top.array.unit051  unit051 (
    .address(step[23:15]),
    .chain_o(\chain_i$480 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$512 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[51])
  );
  \macram_top.array.unit052  unit052 (
    .address(step[23:15]),
    .chain_o(\chain_i$488 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$520 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[52])
  );
  \macram_top.array.unit053  unit053 (
    .address(step[23:15]),
    .chain_o(\chain_i$496 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$528 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[53])
  );
  \macram_top.array.unit054  unit054 (
    .address(step[23:15]),
    .chain_o(\chain_i$504 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$536 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[54])
  );
  \macram_top.array.unit055  unit055 (
    .address(step[23:15]),
    .chain_o(\chain_i$512 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$544 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[55])
  );
  \macram_top.array.unit056  unit056 (
    .address(step[23:15]),
    .chain_o(\chain_i$520 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$552 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[56])
  );
  \macram_top.array.unit057  unit057 (
    .address(step[23:15]),
    .chain_o(\chain_i$528 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$560 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[57])
  );
  \macram_top.array.unit058  unit058 (
    .address(step[23:15]),
    .chain_o(\chain_i$536 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$568 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[58])
  );
  \macram_top.array.unit059  unit059 (
    .address(step[23:15]),
    .chain_o(\chain_i$544 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$576 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[59])
  );
  \macram_top.array.unit060  unit060 (
    .address(step[23:15]),
    .chain_o(\chain_i$552 ),
    .clk(clk),
    .core__activations(activations),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[60])
  );
  \macram_top.array.unit061  unit061 (
    .address(step[23:15]),
    .chain_o(\chain_i$560 ),
    .clk(clk),
    .core__activations(activations),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[61])
  );
  \macram_top.array.unit062  unit062 (
    .address(step[23:15]),
    .chain_o(\chain_i$568 ),
    .clk(clk),
    .core__activations(activations),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[62])
  );
  \macram_top.array.unit063  unit063 (
    .address(step[23:15]),
    .chain_o(\chain_i$576 ),
    .clk(clk),
    .core__activations(activations),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[63])
  );
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    start_weights = 1'h0;
    if (\$7 ) begin
      (* full_case = 32'd1 *)
      if (\$18 ) begin
      end else if (\port$1022$0 [0]) begin
      end else begin
        start_weights = \port$1022$0 [1];
      end
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    start_requant = 1'h0;
    if (\$7 ) begin
      (* full_case = 32'd1 *)
      if (\$18 ) begin
      end else if (\port$1022$0 [0]) begin
      end else begin
        start_requant = \port$1022$0 [2];
      end
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$53  = \wait ;
    if (\$22 ) begin
      \$53  = \$23 [1:0];
    end
    if (\$28 ) begin
      if (\$39 ) begin
      end else if (\port$1022$0 [0]) begin
        \$53  = 2'h2;
      end
    end
    if (\port$1022$0 [3]) begin
      \$53  = 2'h0;
    end
    if (rst) begin
      \$53  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$54  = running;
    if (\$22 ) begin
      if (\$24 ) begin
        \$54  = \$25 ;
      end
    end
    if (\$42 ) begin
      \$54  = 1'h0;
    end
    if (\port$1022$0 [3]) begin
      \$54  = 1'h0;
    end
    if (rst) begin
      \$54  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$55  = \error$609 ;
    if (\$22 ) begin
      if (\$24 ) begin
        \$55  = error;
      end
    end
    if (\$28 ) begin
      \$55  = 3'h0;
      if (\$39 ) begin
        \$55  = 3'h5;
      end
    end
    if (\$43 ) begin
      if (fault) begin
        \$55  = \error$613 ;
      end else if (\fault$612 ) begin
        \$55  = \error$614 ;
      end
    end
    if (\port$1022$0 [3]) begin
      \$55  = 3'h0;
    end
    if (rst) begin
      \$55  = 3'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$56  = done;
    if (\$28 ) begin
      \$56  = 1'h0;
    end
    if (\$42 ) begin
      \$56  = 1'h1;
    end
    if (\port$1022$0 [3]) begin
      \$56  = 1'h0;
    end
    if (rst) begin
      \$56  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$57  = step[31:24];
    if (\port$1022$0 [3]) begin
      \$57  = 8'h00;
    end
    if (rst) begin
      \$57  = 8'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$58  = control0;
    if (\port$1022$0 [3]) begin
      \$58  = 8'h00;
    end
    if (rst) begin
      \$58  = 8'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$59  = control1;
    if (\port$1022$0 [3]) begin
      \$59  = 8'h00;
    end
    if (rst) begin
      \$59  = 8'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$60  = control;
    if (\port$1022$0 [3]) begin
      \$60  = 8'h00;
    end
    if (rst) begin
      \$60  = 8'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$61  = \$signal$605 ;
    if (\$signal ) begin
      \$61  = 1'h1;
    end
    if (start) begin
      \$61  = 1'h0;
    end
    if (\port$1022$0 [3]) begin
      \$61  = 1'h0;
    end
    if (rst) begin
      \$61  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$62  = \$signal$621 ;
    if (issue) begin
      \$62  = 1'h1;
    end
    if (start) begin
      \$62  = 1'h0;
    end
    if (\port$1022$0 [3]) begin
      \$62  = 1'h0;
    end
    if (rst) begin
      \$62  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$63  = ended;
    if (last_beat) begin
      \$63  = 1'h1;
    end
    if (start) begin
      \$63  = 1'h0;
    end
    if (\port$1022$0 [3]) begin
      \$63  = 1'h0;
    end
    if (rst) begin
      \$63  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$64  = cycles;
    if (\$signal$604 ) begin
      \$64  = \$44 [31:0];
    end
    if (start) begin
      \$64  = 32'd0;
    end
    if (\port$1022$0 [3]) begin
      \$64  = 32'd0;
    end
    if (rst) begin
      \$64  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$65  = mac_cycles;
    if (\$signal$604 ) begin
      if (issue) begin
        \$65  = \$48 [31:0];
      end
    end
    if (start) begin
      \$65  = 32'd0;
    end
    if (\port$1022$0 [3]) begin
      \$65  = 32'd0;
    end
    if (rst) begin
      \$65  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$66  = fill_cycles;
    if (\$signal$604 ) begin
      if (issue) begin
      end else if (\$45 ) begin
        \$66  = \$49 [31:0];
      end
    end
    if (start) begin
      \$66  = 32'd0;
    end
    if (\port$1022$0 [3]) begin
      \$66  = 32'd0;
    end
    if (rst) begin
      \$66  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$67  = input_stalls;
    if (\$signal$604 ) begin
      if (issue) begin
      end else if (\$45 ) begin
      end else if (starved) begin
        \$67  = \$50 [31:0];
      end
    end
    if (start) begin
      \$67  = 32'd0;
    end
    if (\port$1022$0 [3]) begin
      \$67  = 32'd0;
    end
    if (rst) begin
      \$67  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$68  = output_stalls;
    if (\$signal$604 ) begin
      if (issue) begin
      end else if (\$45 ) begin
      end else if (starved) begin
      end else if (\$47 ) begin
        \$68  = \$51 [31:0];
      end
    end
    if (start) begin
      \$68  = 32'd0;
    end
    if (\port$1022$0 [3]) begin
      \$68  = 32'd0;
    end
    if (rst) begin
      \$68  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$69  = drain_cycles;
    if (\$signal$604 ) begin
      (* full_case = 32'd1 *)
      if (issue) begin
      end else if (\$45 ) begin
      end else if (starved) begin
      end else if (\$47 ) begin
      end else begin
        \$69  = \$52 [31:0];
      end
    end
    if (start) begin
      \$69  = 32'd0;
    end
    if (\port$1022$0 [3]) begin
      \$69  = 32'd0;
    end
    if (rst) begin
      \$69  = 32'd0;
    end
  end
  assign \height$1  = height;
  assign \width$3  = width;
  assign \c_in$5  = c_in;
  assign \c_out$7  = c_out;
  assign \mode$9  = mode;
  assign \words$11  = words;
  assign \shape$13  = shape;
  assign command = \port$1022$0 [2:0];
  assign \i__payload$24  = i__payload;
  assign \i__ready$26  = i__ready;
  assign \i__valid$28  = i__valid;
  assign \i__payload$29  = i__payload[63:0];
  assign o__payload = i__payload[63:0];
  assign \i__ready$32  = o__ready;
  assign o__valid = \i__valid$33 ;
  assign \o__payload$36  = \i__payload$35 ;
  assign \i__ready$38  = \o__ready$37 ;
  assign \o__valid$40  = \i__valid$39 ;
  assign \o__payload$42  = \i__payload$41 ;
  assign \i__ready$44  = \o__ready$43 ;
  assign \o__valid$46  = \i__valid$45 ;
  assign \o__payload$48  = \o__payload$47 ;
  assign \o__ready$50  = \o__ready$49 ;
  assign \o__valid$52  = \o__valid$51 ;
  assign params__payload = \i__payload$53 ;
  assign params__ready = \busy$16 ;
  assign \i__ready$56  = \busy$16 ;
  assign params__valid = \i__valid$57 ;
  assign \shape$59  = shape;
  assign \shape$60  = shape;
  assign \shape$61  = shape;
  assign \shape$62  = shape;
  assign \start$63  = start;
  assign \start$64  = start;
  assign \start$65  = start;
  assign \start$66  = start;
  assign beats_per_pixel = shape[116:101];
  assign words_per_pixel = { 2'h0, shape[76:63] };
  assign \beats_per_pixel$69  = shape[132:117];
  assign \retire$71  = retire;
  assign read = step[14:0];
  assign \group_written$75  = group_written;
  assign \image_written$77  = image_written;
  assign \credit$79  = credit;
  assign requant_en = write_en;
  assign write = { \$72 , \$71  };
  assign requant = { \$72 , \$71  };
  assign info3 = info;
  assign address = step[23:15];
  assign \write_en$89  = unit_en[0];
  assign \write$91  = { \$72 [519:448], \$70  };
  assign weight = { \$72 [519:448], \$70  };
  assign word = activations;
  assign control2 = control;
  assign \shift$98  = shift;
  assign \chain_o$102  = chain_i;
  assign \address$103  = step[23:15];
  assign \write_en$104  = unit_en[1];
  assign \write$105  = { \$72 [519:448], \$70  };
  assign \activations$106  = activations;
  assign \control$107  = control;
  assign \shift$108  = shift;
  assign \chain_o$111  = \chain_i$110 ;
  assign \address$112  = step[23:15];
  assign \write_en$113  = unit_en[2];
  assign \write$114  = { \$72 [519:448], \$70  };
  assign \activations$115  = activations;
  assign \control$116  = control;
  assign \shift$117  = shift;
  assign \chain_o$120  = \chain_i$119 ;
  assign \address$121  = step[23:15];
  assign \write_en$122  = unit_en[3];
  assign \write$123  = { \$72 [519:448], \$70  };
  assign \activations$124  = activations;
  assign \control$125  = control;
  assign \shift$126  = shift;
  assign \chain_o$129  = \chain_i$128 ;
  assign \address$130  = step[23:15];
  assign \write_en$131  = unit_en[4];
  assign \write$132  = { \$72 [519:448], \$70  };
  assign \activations$133  = activations;
  assign \control$134  = control;
  assign \shift$135  = shift;
  assign \chain_o$137  = \chain_i$136 ;
  assign \address$138  = step[23:15];
  assign \write_en$139  = unit_en[5];
  assign \write$140  = { \$72 [519:448], \$70  };
  assign \activations$141  = activations;
  assign \control$142  = control;
  assign \shift$143  = shift;
  assign \chain_o$145  = \chain_i$144 ;
  assign \address$146  = step[23:15];
  assign \write_en$147  = unit_en[6];
  assign \write$148  = { \$72 [519:448], \$70  };
  assign \activations$149  = activations;
  assign \control$150  = control;
  assign \shift$151  = shift;
  assign \chain_o$153  = \chain_i$152 ;
  assign \address$154  = step[23:15];
  assign \write_en$155  = unit_en[7];
  assign \write$156  = { \$72 [519:448], \$70  };
  assign \activations$157  = activations;
  assign \control$158  = control;
  assign \shift$159  = shift;
  assign \chain_o$161  = \chain_i$160 ;
  assign \address$162  = step[23:15];
  assign \write_en$163  = unit_en[8];
  assign \write$164  = { \$72 [519:448], \$70  };
  assign \activations$165  = activations;
  assign \control$166  = control;
  assign \shift$167  = shift;
  assign \chain_o$169  = \chain_i$168 ;
  assign \address$170  = step[23:15];
  assign \write_en$171  = unit_en[9];
  assign \write$172  = { \$72 [519:448], \$70  };
  assign \activations$173  = activations;
  assign \control$174  = control;
  assign \shift$175  = shift;
  assign \chain_o$177  = \chain_i$176 ;
  assign \address$178  = step[23:15];
  assign \write_en$179  = unit_en[10];
  assign \write$180  = { \$72 [519:448], \$70  };
  assign \activations$181  = activations;
  assign \control$182  = control;
  assign \shift$183  = shift;
  assign \chain_o$185  = \chain_i$184 ;
  assign \address$186  = step[23:15];
  assign \write_en$187  = unit_en[11];
  assign \write$188  = { \$72 [519:448], \$70  };
  assign \activations$189  = activations;
  assign \control$190  = control;
  assign \shift$191  = shift;
  assign \chain_o$193  = \chain_i$192 ;
  assign \address$194  = step[23:15];
  assign \write_en$195  = unit_en[12];
  assign \write$196  = { \$72 [519:448], \$70  };
  assign \activations$197  = activations;
  assign \control$198  = control;
  assign \shift$199  = shift;
  assign \chain_o$201  = \chain_i$200 ;
  assign \address$202  = step[23:15];
  assign \write_en$203  = unit_en[13];
  assign \write$204  = { \$72 [519:448], \$70  };
  assign \activations$205  = activations;
  assign \control$206  = control;
  assign \shift$207  = shift;
  assign \chain_o$209  = \chain_i$208 ;
  assign \address$210  = step[23:15];
  assign \write_en$211  = unit_en[14];
  assign \write$212  = { \$72 [519:448], \$70  };
  assign \activations$213  = activations;
  assign \control$214  = control;
  assign \shift$215  = shift;
  assign \chain_o$217  = \chain_i$216 ;
  assign \address$218  = step[23:15];
  assign \write_en$219  = unit_en[15];
  assign \write$220  = { \$72 [519:448], \$70  };
  assign \activations$221  = activations;
  assign \control$222  = control;
  assign \shift$223  = shift;
  assign \chain_o$225  = \chain_i$224 ;
  assign \address$226  = step[23:15];
  assign \write_en$227  = unit_en[16];
  assign \write$228  = { \$72 [519:448], \$70  };
  assign \activations$229  = activations;
  assign \control$230  = control;
  assign \shift$231  = shift;
  assign \chain_o$233  = \chain_i$232 ;
  assign \address$234  = step[23:15];
  assign \write_en$235  = unit_en[17];
  assign \write$236  = { \$72 [519:448], \$70  };
  assign \activations$237  = activations;
  assign \control$238  = control;
  assign \shift$239  = shift;
  assign \chain_o$241  = \chain_i$240 ;
  assign \address$242  = step[23:15];
  assign \write_en$243  = unit_en[18];
  assign \write$244  = { \$72 [519:448], \$70  };
  assign \activations$245  = activations;
  assign \control$246  = control;
  assign \shift$247  = shift;
  assign \chain_o$249  = \chain_i$248 ;
  assign \address$250  = step[23:15];
  assign \write_en$251  = unit_en[19];
  assign \write$252  = { \$72 [519:448], \$70  };
  assign \activations$253  = activations;
  assign \control$254  = control;
  assign \shift$255  = shift;
  assign \chain_o$257  = \chain_i$256 ;
  assign \address$258  = step[23:15];
  assign \write_en$259  = unit_en[20];
  assign \write$260  = { \$72 [519:448], \$70  };
  assign \activations$261  = activations;
  assign \control$262  = control;
  assign \shift$263  = shift;
  assign \chain_o$265  = \chain_i$264 ;
  assign \address$266  = step[23:15];
  assign \write_en$267  = unit_en[21];
  assign \write$268  = { \$72 [519:448], \$70  };
  assign \activations$269  = activations;
  assign \control$270  = control;
  assign \shift$271  = shift;
  assign \chain_o$273  = \chain_i$272 ;
  assign \address$274  = step[23:15];
  assign \write_en$275  = unit_en[22];
  assign \write$276  = { \$72 [519:448], \$70  };
  assign \activations$277  = activations;
  assign \control$278  = control;
  assign \shift$279  = shift;
  assign \chain_o$281  = \chain_i$280 ;
  assign \address$282  = step[23:15];
  assign \write_en$283  = unit_en[23];
  assign \write$284  = { \$72 [519:448], \$70  };
  assign \activations$285  = activations;
  assign \control$286  = control;
  assign \shift$287  = shift;
  assign \chain_o$289  = \chain_i$288 ;
  assign \address$290  = step[23:15];
  assign \write_en$291  = unit_en[24];
  assign \write$292  = { \$72 [519:448], \$70  };
  assign \activations$293  = activations;
  assign \control$294  = control;
  assign \shift$295  = shift;
  assign \chain_o$297  = \chain_i$296 ;
  assign \address$298  = step[23:15];
  assign \write_en$299  = unit_en[25];
  assign \write$300  = { \$72 [519:448], \$70  };
  assign \activations$301  = activations;
  assign \control$302  = control;
  assign \shift$303  = shift;
  assign \chain_o$305  = \chain_i$304 ;
  assign \address$306  = step[23:15];
  assign \write_en$307  = unit_en[26];
  assign \write$308  = { \$72 [519:448], \$70  };
  assign \activations$309  = activations;
  assign \control$310  = control;
  assign \shift$311  = shift;
  assign \chain_o$313  = \chain_i$312 ;
  assign \address$314  = step[23:15];
  assign \write_en$315  = unit_en[27];
  assign \write$316  = { \$72 [519:448], \$70  };
  assign \activations$317  = activations;
  assign \control$318  = control;
  assign \shift$319  = shift;
  assign \chain_o$321  = \chain_i$320 ;
  assign \address$322  = step[23:15];
  assign \write_en$323  = unit_en[28];
  assign \write$324  = { \$72 [519:448], \$70  };
  assign \activations$325  = activations;
  assign \control$326  = control;
  assign \shift$327  = shift;
  assign \chain_o$329  = \chain_i$328 ;
  assign \address$330  = step[23:15];
  assign \write_en$331  = unit_en[29];
  assign \write$332  = { \$72 [519:448], \$70  };
  assign \activations$333  = activations;
  assign \control$334  = control;
  assign \shift$335  = shift;
  assign \chain_o$337  = \chain_i$336 ;
  assign \address$338  = step[23:15];
  assign \write_en$339  = unit_en[30];
  assign \write$340  = { \$72 [519:448], \$70  };
  assign \activations$341  = activations;
  assign \control$342  = control;
  assign \shift$343  = shift;
  assign \chain_o$345  = \chain_i$344 ;
  assign \address$346  = step[23:15];
  assign \write_en$347  = unit_en[31];
  assign \write$348  = { \$72 [519:448], \$70  };
  assign \activations$349  = activations;
  assign \control$350  = control;
  assign \shift$351  = shift;
  assign \chain_o$353  = \chain_i$352 ;
  assign \address$354  = step[23:15];
  assign \write_en$355  = unit_en[32];
  assign \write$356  = { \$72 [519:448], \$70  };
  assign \activations$357  = activations;
  assign \control$358  = control;
  assign \shift$359  = shift;
  assign \chain_o$361  = \chain_i$360 ;
  assign \address$362  = step[23:15];
  assign \write_en$363  = unit_en[33];
  assign \write$364  = { \$72 [519:448], \$70  };
  assign \activations$365  = activations;
  assign \control$366  = control;
  assign \shift$367  = shift;
  assign \chain_o$369  = \chain_i$368 ;
  assign \address$370  = step[23:15];
  assign \write_en$371  = unit_en[34];
  assign \write$372  = { \$72 [519:448], \$70  };
  assign \activations$373  = activations;
  assign \control$374  = control;
  assign \shift$375  = shift;
  assign \chain_o$377  = \chain_i$376 ;
  assign \address$378  = step[23:15];
  assign \write_en$379  = unit_en[35];
  assign \write$380  = { \$72 [519:448], \$70  };
  assign \activations$381  = activations;
  assign \control$382  = control;
  assign \shift$383  = shift;
  assign \chain_o$385  = \chain_i$384 ;
  assign \address$386  = step[23:15];
  assign \write_en$387  = unit_en[36];
  assign \write$388  = { \$72 [519:448], \$70  };
  assign \activations$389  = activations;
  assign \control$390  = control;
  assign \shift$391  = shift;
  assign \chain_o$393  = \chain_i$392 ;
  assign \address$394  = step[23:15];
  assign \write_en$395  = unit_en[37];
  assign \write$396  = { \$72 [519:448], \$70  };
  assign \activations$397  = activations;
  assign \control$398  = control;
  assign \shift$399  = shift;
  assign \chain_o$401  = \chain_i$400 ;
  assign \address$402  = step[23:15];
  assign \write_en$403  = unit_en[38];
  assign \write$404  = { \$72 [519:448], \$70  };
  assign \activations$405  = activations;
  assign \control$406  = control;
  assign \shift$407  = shift;
  assign \chain_o$409  = \chain_i$408 ;
  assign \address$410  = step[23:15];
  assign \write_en$411  = unit_en[39];
  assign \write$412  = { \$72 [519:448], \$70  };
  assign \activations$413  = activations;
  assign \control$414  = control;
  assign \shift$415  = shift;
  assign \chain_o$417  = \chain_i$416 ;
  assign \address$418  = step[23:15];
  assign \write_en$419  = unit_en[40];
  assign \write$420  = { \$72 [519:448], \$70  };
  assign \activations$421  = activations;
  assign \control$422  = control;
  assign \shift$423  = shift;
  assign \chain_o$425  = \chain_i$424 ;
  assign \address$426  = step[23:15];
  assign \write_en$427  = unit_en[41];
  assign \write$428  = { \$72 [519:448], \$70  };
  assign \activations$429  = activations;
  assign \control$430  = control;
  assign \shift$431  = shift;
  assign \chain_o$433  = \chain_i$432 ;
  assign \address$434  = step[23:15];
  assign \write_en$435  = unit_en[42];
  assign \write$436  = { \$72 [519:448], \$70  };
  assign \activations$437  = activations;
  assign \control$438  = control;
  assign \shift$439  = shift;
  assign \chain_o$441  = \chain_i$440 ;
  assign \address$442  = step[23:15];
  assign \write_en$443  = unit_en[43];
  assign \write$444  = { \$72 [519:448], \$70  };
  assign \activations$445  = activations;
  assign \control$446  = control;
  assign \shift$447  = shift;
  assign \chain_o$449  = \chain_i$448 ;
  assign \address$450  = step[23:15];
  assign \write_en$451  = unit_en[44];
  assign \write$452  = { \$72 [519:448], \$70  };
  assign \activations$453  = activations;
  assign \control$454  = control;
  assign \shift$455  = shift;
  assign \chain_o$457  = \chain_i$456 ;
  assign \address$458  = step[23:15];
  assign \write_en$459  = unit_en[45];
  assign \write$460  = { \$72 [519:448], \$70  };
  assign \activations$461  = activations;
  assign \control$462  = control;
  assign \shift$463  = shift;
  assign \chain_o$465  = \chain_i$464 ;
  assign \address$466  = step[23:15];
  assign \write_en$467  = unit_en[46];
  assign \write$468  = { \$72 [519:448], \$70  };
  assign \activations$469  = activations;
  assign \control$470  = control;
  assign \shift$471  = shift;
  assign \chain_o$473  = \chain_i$472 ;
  assign \address$474  = step[23:15];
  assign \write_en$475  = unit_en[47];
  assign \write$476  = { \$72 [519:448], \$70  };
  assign \activations$477  = activations;
  assign \control$478  = control;
  assign \shift$479  = shift;
  assign \chain_o$481  = \chain_i$480 ;
  assign \address$482  = step[23:15];
  assign \write_en$483  = unit_en[48];
  assign \write$484  = { \$72 [519:448], \$70  };
  assign \activations$485  = activations;
  assign \control$486  = control;
  assign \shift$487  = shift;
  assign \chain_o$489  = \chain_i$488 ;
  assign \address$490  = step[23:15];
  assign \write_en$491  = unit_en[49];
  assign \write$492  = { \$72 [519:448], \$70  };
  assign \activations$493  = activations;
  assign \control$494  = control;
  assign \shift$495  = shift;
  assign \chain_o$497  = \chain_i$496 ;
  assign \address$498  = step[23:15];
  assign \write_en$499  = unit_en[50];
  assign \write$500  = { \$72 [519:448], \$70  };
  assign \activations$501  = activations;
  assign \control$502  = control;
  assign \shift$503  = shift;
  assign \chain_o$505  = \chain_i$504 ;
  assign \address$506  = step[23:15];
  assign \write_en$507  = unit_en[51];
  assign \write$508  = { \$72 [519:448], \$70  };
  assign \activations$509  = activations;
  assign \control$510  = control;
  assign \shift$511  = shift;
  assign \chain_o$513  = \chain_i$512 ;
  assign \address$514  = step[23:15];
  assign \write_en$515  = unit_en[52];
  assign \write$516  = { \$72 [519:448], \$70  };
  assign \activations$517  = activations;
  assign \control$518  = control;
  assign \shift$519  = shift;
  assign \chain_o$521  = \chain_i$520 ;
  assign \address$522  = step[23:15];
  assign \write_en$523  = unit_en[53];
  assign \write$524  = { \$72 [519:448], \$70  };
  assign \activations$525  = activations;
  assign \control$526  = control;
  assign \shift$527  = shift;
  assign \chain_o$529  = \chain_i$528 ;
  assign \address$530  = step[23:15];
  assign \write_en$531  = unit_en[54];
  assign \write$532  = { \$72 [519:448], \$70  };
  assign \activations$533  = activations;
  assign \control$534  = control;
  assign \shift$535  = shift;
  assign \chain_o$537  = \chain_i$536 ;
  assign \address$538  = step[23:15];
  assign \write_en$539  = unit_en[55];
  assign \write$540  = { \$72 [519:448], \$70  };
  assign \activations$541  = activations;
  assign \control$542  = control;
  assign \shift$543  = shift;
  assign \chain_o$545  = \chain_i$544 ;
  assign \address$546  = step[23:15];
  assign \write_en$547  = unit_en[56];
  assign \write$548  = { \$72 [519:448], \$70  };
  assign \activations$549  = activations;
  assign \control$550  = control;
  assign \shift$551  = shift;
  assign \chain_o$553  = \chain_i$552 ;
  assign \address$554  = step[23:15];
  assign \write_en$555  = unit_en[57];
  assign \write$556  = { \$72 [519:448], \$70  };
  assign \activations$557  = activations;
  assign \control$558  = control;
  assign \shift$559  = shift;
  assign \chain_o$561  = \chain_i$560 ;
  assign \address$562  = step[23:15];
  assign \write_en$563  = unit_en[58];
  assign \write$564  = { \$72 [519:448], \$70  };
  assign \activations$565  = activations;
  assign \control$566  = control;
  assign \shift$567  = shift;
  assign \chain_o$569  = \chain_i$568 ;
  assign \address$570  = step[23:15];
  assign \write_en$571  = unit_en[59];
  assign \write$572  = { \$72 [519:448], \$70  };
  assign \activations$573  = activations;
  assign \control$574  = control;
  assign \shift$575  = shift;
  assign \chain_o$577  = \chain_i$576 ;
  assign \address$578  = step[23:15];
  assign \write_en$579  = unit_en[60];
  assign \write$580  = { \$72 [519:448], \$70  };
  assign \activations$581  = activations;
  assign \control$582  = control;
  assign \shift$583  = shift;
  assign \address$584  = step[23:15];
  assign \write_en$585  = unit_en[61];
  assign \write$586  = { \$72 [519:448], \$70  };
  assign \activations$587  = activations;
  assign \control$588  = control;
  assign \shift$589  = shift;
  assign \address$590  = step[23:15];
  assign \write_en$591  = unit_en[62];
  assign \write$592  = { \$72 [519:448], \$70  };
  assign \activations$593  = activations;
  assign \control$594  = control;
  assign \shift$595  = shift;
  assign \address$596  = step[23:15];
  assign \write_en$597  = unit_en[63];
  assign \write$598  = { \$72 [519:448], \$70  };
  assign \activations$599  = activations;
  assign \control$600  = control;
  assign \shift$601  = shift;
  assign soft_reset = \port$1022$0 [3];
  assign \shape.height  = shape[15:0];
  assign \shape.width  = shape[31:16];
  assign \shape.groups  = shape[46:32];
  assign \shape.tail  = shape[48:47];
  assign \shape.blocks  = shape[62:49];
  assign \shape.ingest_words  = shape[76:63];
  assign \shape.tiles  = shape[88:77];
  assign \shape.output_words  = shape[100:89];
  assign \shape.beats_in  = shape[116:101];
  assign \shape.beats_out  = shape[132:117];
  assign \shape$13.height  = shape[15:0];
  assign \shape$13.width  = shape[31:16];
  assign \shape$13.groups  = shape[46:32];
  assign \shape$13.tail  = shape[48:47];
  assign \shape$13.blocks  = shape[62:49];
  assign \shape$13.ingest_words  = shape[76:63];
  assign \shape$13.tiles  = shape[88:77];
  assign \shape$13.output_words  = shape[100:89];
  assign \shape$13.beats_in  = shape[116:101];
  assign \shape$13.beats_out  = shape[132:117];
  assign \i__payload.data  = i__payload[63:0];
  assign \i__payload.last  = i__payload[64];
  assign \i__payload$24.data  = i__payload[63:0];
  assign \i__payload$24.last  = i__payload[64];
  assign \i__payload$41.data  = \i__payload$41 [47:0];
  assign \i__payload$41.pixel_last  = \i__payload$41 [48];
  assign \i__payload$41.last  = \i__payload$41 [49];
  assign \o__payload$42.data  = \i__payload$41 [47:0];
  assign \o__payload$42.pixel_last  = \i__payload$41 [48];
  assign \o__payload$42.last  = \i__payload$41 [49];
  assign \o__payload$47.data  = \o__payload$47 [63:0];
  assign \o__payload$47.last  = \o__payload$47 [64];
  assign \o__payload$48.data  = \o__payload$47 [63:0];
  assign \o__payload$48.last  = \o__payload$47 [64];
  assign \i__payload$53.data  = \i__payload$53 [63:0];
  assign \i__payload$53.last  = \i__payload$53 [64];
  assign \params__payload.data  = \i__payload$53 [63:0];
  assign \params__payload.last  = \i__payload$53 [64];
  assign \shape$59.height  = shape[15:0];
  assign \shape$59.width  = shape[31:16];
  assign \shape$59.groups  = shape[46:32];
  assign \shape$59.tail  = shape[48:47];
  assign \shape$59.blocks  = shape[62:49];
  assign \shape$59.ingest_words  = shape[76:63];
  assign \shape$59.tiles  = shape[88:77];
  assign \shape$59.output_words  = shape[100:89];
  assign \shape$59.beats_in  = shape[116:101];
  assign \shape$59.beats_out  = shape[132:117];
  assign \shape$60.height  = shape[15:0];
  assign \shape$60.width  = shape[31:16];
  assign \shape$60.groups  = shape[46:32];
  assign \shape$60.tail  = shape[48:47];
  assign \shape$60.blocks  = shape[62:49];
  assign \shape$60.ingest_words  = shape[76:63];
  assign \shape$60.tiles  = shape[88:77];
  assign \shape$60.output_words  = shape[100:89];
  assign \shape$60.beats_in  = shape[116:101];
  assign \shape$60.beats_out  = shape[132:117];
  assign \shape$61.height  = shape[15:0];
  assign \shape$61.width  = shape[31:16];
  assign \shape$61.groups  = shape[46:32];
  assign \shape$61.tail  = shape[48:47];
  assign \shape$61.blocks  = shape[62:49];
  assign \shape$61.ingest_words  = shape[76:63];
  assign \shape$61.tiles  = shape[88:77];
  assign \shape$61.output_words  = shape[100:89];
  assign \shape$61.beats_in  = shape[116:101];
  assign \shape$61.beats_out  = shape[132:117];
  assign \shape$62.height  = shape[15:0];
  assign \shape$62.width  = shape[31:16];
  assign \shape$62.groups  = shape[46:32];
  assign \shape$62.tail  = shape[48:47];
  assign \shape$62.blocks  = shape[62:49];
  assign \shape$62.ingest_words  = shape[76:63];
  assign \shape$62.tiles  = shape[88:77];
  assign \shape$62.output_words  = shape[100:89];
  assign \shape$62.beats_in  = shape[116:101];
  assign \shape$62.beats_out  = shape[132:117];
  assign \read.slot  = step[1:0];
  assign \read.address  = step[9:2];
  assign \read.bank  = step[10];
  assign \read.mask  = step[14:11];
  assign \step.read  = step[14:0];
  assign \step.read.slot  = step[1:0];
  assign \step.read.address  = step[9:2];
  assign \step.read.bank  = step[10];
  assign \step.read.mask  = step[14:11];
  assign \step.weight  = step[23:15];
  assign \step.control  = step[31:24];
  assign \step.control.en  = step[24];
  assign \step.control.first  = step[25];
  assign \step.control.last  = step[26];
  assign \step.control.edge  = step[27];
  assign \step.control.tile  = step[31:28];
  assign \step.info  = step[41:32];
  assign \step.info.tile  = step[35:32];
  assign \step.info.tile_last  = step[36];
  assign \step.info.slots  = step[40:37];
  assign \step.info.image_last  = step[41];
  assign \write.addr  = \$71 ;
  assign \write.data  = \$72 ;
  assign \requant.addr  = \$71 ;
  assign \requant.data  = \$72 ;
  assign \control3.en  = control3[0];
  assign \control3.first  = control3[1];
  assign \control3.last  = control3[2];
  assign \control3.edge  = control3[3];
  assign \control3.tile  = control3[7:4];
  assign \info.tile  = info[3:0];
  assign \info.tile_last  = info[4];
  assign \info.slots  = info[8:5];
  assign \info.image_last  = info[9];
  assign \info3.tile  = info[3:0];
  assign \info3.tile_last  = info[4];
  assign \info3.slots  = info[8:5];
  assign \info3.image_last  = info[9];
  assign \write$91.addr  = \$70 ;
  assign \write$91.data  = \$72 [519:448];
  assign \weight.addr  = \$70 ;
  assign \weight.data  = \$72 [519:448];
  assign \control.en  = control[0];
  assign \control.first  = control[1];
  assign \control.last  = control[2];
  assign \control.edge  = control[3];
  assign \control.tile  = control[7:4];
  assign \control2.en  = control[0];
  assign \control2.first  = control[1];
  assign \control2.last  = control[2];
  assign \control2.edge  = control[3];
  assign \control2.tile  = control[7:4];
  assign \heads[0]  = heads[75:0];
  assign \heads[0][0]  = heads[18:0];
  assign \heads[0][1]  = heads[37:19];
  assign \heads[0][2]  = heads[56:38];
  assign \heads[0][3]  = heads[75:57];
  assign \heads[1]  = heads[151:76];
  assign \heads[1][0]  = heads[94:76];
  assign \heads[1][1]  = heads[113:95];
  assign \heads[1][2]  = heads[132:114];
  assign \heads[1][3]  = heads[151:133];
  assign \heads[2]  = heads[227:152];
  assign \heads[2][0]  = heads[170:152];
  assign \heads[2][1]  = heads[189:171];
  assign \heads[2][2]  = heads[208:190];
  assign \heads[2][3]  = heads[227:209];
  assign \heads[3]  = heads[303:228];
  assign \heads[3][0]  = heads[246:228];
  assign \heads[3][1]  = heads[265:247];
  assign \heads[3][2]  = heads[284:266];
  assign \heads[3][3]  = heads[303:285];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \chain_i[0]  = chain_i[18:0];
  assign \chain_i[1]  = chain_i[37:19];
  assign \chain_i[2]  = chain_i[56:38];
  assign \chain_i[3]  = chain_i[75:57];
  assign \chain_o$102[0]  = chain_i[18:0];
  assign \chain_o$102[1]  = chain_i[37:19];
  assign \chain_o$102[2]  = chain_i[56:38];
  assign \chain_o$102[3]  = chain_i[75:57];
  assign \write$105.addr  = \$70 ;
  assign \write$105.data  = \$72 [519:448];
  assign \control$107.en  = control[0];
  assign \control$107.first  = control[1];
  assign \control$107.last  = control[2];
  assign \control$107.edge  = control[3];
  assign \control$107.tile  = control[7:4];
  assign \chain_o$109[0]  = \chain_o$109 [18:0];
  assign \chain_o$109[1]  = \chain_o$109 [37:19];
  assign \chain_o$109[2]  = \chain_o$109 [56:38];
  assign \chain_o$109[3]  = \chain_o$109 [75:57];
  assign \chain_i$110[0]  = \chain_i$110 [18:0];
  assign \chain_i$110[1]  = \chain_i$110 [37:19];
  assign \chain_i$110[2]  = \chain_i$110 [56:38];
  assign \chain_i$110[3]  = \chain_i$110 [75:57];
  assign \chain_o$111[0]  = \chain_i$110 [18:0];
  assign \chain_o$111[1]  = \chain_i$110 [37:19];
  assign \chain_o$111[2]  = \chain_i$110 [56:38];
  assign \chain_o$111[3]  = \chain_i$110 [75:57];
  assign \write$114.addr  = \$70 ;
  assign \write$114.data  = \$72 [519:448];
  assign \control$116.en  = control[0];
  assign \control$116.first  = control[1];
  assign \control$116.last  = control[2];
  assign \control$116.edge  = control[3];
  assign \control$116.tile  = control[7:4];
  assign \chain_o$118[0]  = \chain_o$118 [18:0];
  assign \chain_o$118[1]  = \chain_o$118 [37:19];
  assign \chain_o$118[2]  = \chain_o$118 [56:38];
  assign \chain_o$118[3]  = \chain_o$118 [75:57];
  assign \chain_i$119[0]  = \chain_i$119 [18:0];
  assign \chain_i$119[1]  = \chain_i$119 [37:19];
  assign \chain_i$119[2]  = \chain_i$119 [56:38];
  assign \chain_i$119[3]  = \chain_i$119 [75:57];
  assign \chain_o$120[0]  = \chain_i$119 [18:0];
  assign \chain_o$120[1]  = \chain_i$119 [37:19];
  assign \chain_o$120[2]  = \chain_i$119 [56:38];
  assign \chain_o$120[3]  = \chain_i$119 [75:57];
  assign \write$123.addr  = \$70 ;
  assign \write$123.data  = \$72 [519:448];
  assign \control$125.en  = control[0];
  assign \control$125.first  = control[1];
  assign \control$125.last  = control[2];
  assign \control$125.edge  = control[3];
  assign \control$125.tile  = control[7:4];
  assign \chain_o$127[0]  = \chain_o$127 [18:0];
  assign \chain_o$127[1]  = \chain_o$127 [37:19];
  assign \chain_o$127[2]  = \chain_o$127 [56:38];
  assign \chain_o$127[3]  = \chain_o$127 [75:57];
  assign \chain_i$128[0]  = \chain_i$128 [18:0];
  assign \chain_i$128[1]  = \chain_i$128 [37:19];
  assign \chain_i$128[2]  = \chain_i$128 [56:38];
  assign \chain_i$128[3]  = \chain_i$128 [75:57];
  assign \chain_o$129[0]  = \chain_i$128 [18:0];
  assign \chain_o$129[1]  = \chain_i$128 [37:19];
  assign \chain_o$129[2]  = \chain_i$128 [56:38];
  assign \chain_o$129[3]  = \chain_i$128 [75:57];
  assign \write$132.addr  = \$70 ;
  assign \write$132.data  = \$72 [519:448];
  assign \control$134.en  = control[0];
  assign \control$134.first  = control[1];
  assign \control$134.last  = control[2];
  assign \control$134.edge  = control[3];
  assign \control$134.tile  = control[7:4];
  assign \chain_i$136[0]  = \chain_i$136 [18:0];
  assign \chain_i$136[1]  = \chain_i$136 [37:19];
  assign \chain_i$136[2]  = \chain_i$136 [56:38];
  assign \chain_i$136[3]  = \chain_i$136 [75:57];
  assign \chain_o$137[0]  = \chain_i$136 [18:0];
  assign \chain_o$137[1]  = \chain_i$136 [37:19];
  assign \chain_o$137[2]  = \chain_i$136 [56:38];
  assign \chain_o$137[3]  = \chain_i$136 [75:57];
  assign \write$140.addr  = \$70 ;
  assign \write$140.data  = \$72 [519:448];
  assign \control$142.en  = control[0];
  assign \control$142.first  = control[1];
  assign \control$142.last  = control[2];
  assign \control$142.edge  = control[3];
  assign \control$142.tile  = control[7:4];
  assign \chain_i$144[0]  = \chain_i$144 [18:0];
  assign \chain_i$144[1]  = \chain_i$144 [37:19];
  assign \chain_i$144[2]  = \chain_i$144 [56:38];
  assign \chain_i$144[3]  = \chain_i$144 [75:57];
  assign \chain_o$145[0]  = \chain_i$144 [18:0];
  assign \chain_o$145[1]  = \chain_i$144 [37:19];
  assign \chain_o$145[2]  = \chain_i$144 [56:38];
  assign \chain_o$145[3]  = \chain_i$144 [75:57];
  assign \write$148.addr  = \$70 ;
  assign \write$148.data  = \$72 [519:448];
  assign \control$150.en  = control[0];
  assign \control$150.first  = control[1];
  assign \control$150.last  = control[2];
  assign \control$150.edge  = control[3];
  assign \control$150.tile  = control[7:4];
  assign \chain_i$152[0]  = \chain_i$152 [18:0];
  assign \chain_i$152[1]  = \chain_i$152 [37:19];
  assign \chain_i$152[2]  = \chain_i$152 [56:38];
  assign \chain_i$152[3]  = \chain_i$152 [75:57];
  assign \chain_o$153[0]  = \chain_i$152 [18:0];
  assign \chain_o$153[1]  = \chain_i$152 [37:19];
  assign \chain_o$153[2]  = \chain_i$152 [56:38];
  assign \chain_o$153[3]  = \chain_i$152 [75:57];
  assign \write$156.addr  = \$70 ;
  assign \write$156.data  = \$72 [519:448];
  assign \control$158.en  = control[0];
  assign \control$158.first  = control[1];
  assign \control$158.last  = control[2];
  assign \control$158.edge  = control[3];
  assign \control$158.tile  = control[7:4];
  assign \chain_i$160[0]  = \chain_i$160 [18:0];
  assign \chain_i$160[1]  = \chain_i$160 [37:19];
  assign \chain_i$160[2]  = \chain_i$160 [56:38];
  assign \chain_i$160[3]  = \chain_i$160 [75:57];
  assign \chain_o$161[0]  = \chain_i$160 [18:0];
  assign \chain_o$161[1]  = \chain_i$160 [37:19];
  assign \chain_o$161[2]  = \chain_i$160 [56:38];
  assign \chain_o$161[3]  = \chain_i$160 [75:57];
  assign \write$164.addr  = \$70 ;
  assign \write$164.data  = \$72 [519:448];
  assign \control$166.en  = control[0];
  assign \control$166.first  = control[1];
  assign \control$166.last  = control[2];
  assign \control$166.edge  = control[3];
  assign \control$166.tile  = control[7:4];
  assign \chain_i$168[0]  = \chain_i$168 [18:0];
  assign \chain_i$168[1]  = \chain_i$168 [37:19];
  assign \chain_i$168[2]  = \chain_i$168 [56:38];
  assign \chain_i$168[3]  = \chain_i$168 [75:57];
  assign \chain_o$169[0]  = \chain_i$168 [18:0];
  assign \chain_o$169[1]  = \chain_i$168 [37:19];
  assign \chain_o$169[2]  = \chain_i$168 [56:38];
  assign \chain_o$169[3]  = \chain_i$168 [75:57];
  assign \write$172.addr  = \$70 ;
  assign \write$172.data  = \$72 [519:448];
  assign \control$174.en  = control[0];
  assign \control$174.first  = control[1];
  assign \control$174.last  = control[2];
  assign \control$174.edge  = control[3];
  assign \control$174.tile  = control[7:4];
  assign \chain_i$176[0]  = \chain_i$176 [18:0];
  assign \chain_i$176[1]  = \chain_i$176 [37:19];
  assign \chain_i$176[2]  = \chain_i$176 [56:38];
  assign \chain_i$176[3]  = \chain_i$176 [75:57];
  assign \chain_o$177[0]  = \chain_i$176 [18:0];
  assign \chain_o$177[1]  = \chain_i$176 [37:19];
  assign \chain_o$177[2]  = \chain_i$176 [56:38];
  assign \chain_o$177[3]  = \chain_i$176 [75:57];
  assign \write$180.addr  = \$70 ;
  assign \write$180.data  = \$72 [519:448];
  assign \control$182.en  = control[0];
  assign \control$182.first  = control[1];
  assign \control$182.last  = control[2];
  assign \control$182.edge  = control[3];
  assign \control$182.tile  = control[7:4];
  assign \chain_i$184[0]  = \chain_i$184 [18:0];
  assign \chain_i$184[1]  = \chain_i$184 [37:19];
  assign \chain_i$184[2]  = \chain_i$184 [56:38];
  assign \chain_i$184[3]  = \chain_i$184 [75:57];
  assign \chain_o$185[0]  = \chain_i$184 [18:0];
  assign \chain_o$185[1]  = \chain_i$184 [37:19];
  assign \chain_o$185[2]  = \chain_i$184 [56:38];
  assign \chain_o$185[3]  = \chain_i$184 [75:57];
  assign \write$188.addr  = \$70 ;
  assign \write$188.data  = \$72 [519:448];
  assign \control$190.en  = control[0];
  assign \control$190.first  = control[1];
  assign \control$190.last  = control[2];
  assign \control$190.edge  = control[3];
  assign \control$190.tile  = control[7:4];
  assign \chain_i$192[0]  = \chain_i$192 [18:0];
  assign \chain_i$192[1]  = \chain_i$192 [37:19];
  assign \chain_i$192[2]  = \chain_i$192 [56:38];
  assign \chain_i$192[3]  = \chain_i$192 [75:57];
  assign \chain_o$193[0]  = \chain_i$192 [18:0];
  assign \chain_o$193[1]  = \chain_i$192 [37:19];
  assign \chain_o$193[2]  = \chain_i$192 [56:38];
  assign \chain_o$193[3]  = \chain_i$192 [75:57];
  assign \write$196.addr  = \$70 ;
  assign \write$196.data  = \$72 [519:448];
  assign \control$198.en  = control[0];
  assign \control$198.first  = control[1];
  assign \control$198.last  = control[2];
  assign \control$198.edge  = control[3];
  assign \control$198.tile  = control[7:4];
  assign \chain_i$200[0]  = \chain_i$200 [18:0];
  assign \chain_i$200[1]  = \chain_i$200 [37:19];
  assign \chain_i$200[2]  = \chain_i$200 [56:38];
  assign \chain_i$200[3]  = \chain_i$200 [75:57];
  assign \chain_o$201[0]  = \chain_i$200 [18:0];
  assign \chain_o$201[1]  = \chain_i$200 [37:19];
  assign \chain_o$201[2]  = \chain_i$200 [56:38];
  assign \chain_o$201[3]  = \chain_i$200 [75:57];
  assign \write$204.addr  = \$70 ;
  assign \write$204.data  = \$72 [519:448];
  assign \control$206.en  = control[0];
  assign \control$206.first  = control[1];
  assign \control$206.last  = control[2];
  assign \control$206.edge  = control[3];
  assign \control$206.tile  = control[7:4];
  assign \chain_i$208[0]  = \chain_i$208 [18:0];
  assign \chain_i$208[1]  = \chain_i$208 [37:19];
  assign \chain_i$208[2]  = \chain_i$208 [56:38];
  assign \chain_i$208[3]  = \chain_i$208 [75:57];
  assign \chain_o$209[0]  = \chain_i$208 [18:0];
  assign \chain_o$209[1]  = \chain_i$208 [37:19];
  assign \chain_o$209[2]  = \chain_i$208 [56:38];
  assign \chain_o$209[3]  = \chain_i$208 [75:57];
  assign \write$212.addr  = \$70 ;
  assign \write$212.data  = \$72 [519:448];
  assign \control$214.en  = control[0];
  assign \control$214.first  = control[1];
  assign \control$214.last  = control[2];
  assign \control$214.edge  = control[3];
  assign \control$214.tile  = control[7:4];
  assign \chain_i$216[0]  = \chain_i$216 [18:0];
  assign \chain_i$216[1]  = \chain_i$216 [37:19];
  assign \chain_i$216[2]  = \chain_i$216 [56:38];
  assign \chain_i$216[3]  = \chain_i$216 [75:57];
  assign \chain_o$217[0]  = \chain_i$216 [18:0];
  assign \chain_o$217[1]  = \chain_i$216 [37:19];
  assign \chain_o$217[2]  = \chain_i$216 [56:38];
  assign \chain_o$217[3]  = \chain_i$216 [75:57];
  assign \write$220.addr  = \$70 ;
  assign \write$220.data  = \$72 [519:448];
  assign \control$222.en  = control[0];
  assign \control$222.first  = control[1];
  assign \control$222.last  = control[2];
  assign \control$222.edge  = control[3];
  assign \control$222.tile  = control[7:4];
  assign \chain_i$224[0]  = \chain_i$224 [18:0];
  assign \chain_i$224[1]  = \chain_i$224 [37:19];
  assign \chain_i$224[2]  = \chain_i$224 [56:38];
  assign \chain_i$224[3]  = \chain_i$224 [75:57];
  assign \chain_o$225[0]  = \chain_i$224 [18:0];
  assign \chain_o$225[1]  = \chain_i$224 [37:19];
  assign \chain_o$225[2]  = \chain_i$224 [56:38];
  assign \chain_o$225[3]  = \chain_i$224 [75:57];
  assign \write$228.addr  = \$70 ;
  assign \write$228.data  = \$72 [519:448];
  assign \control$230.en  = control[0];
  assign \control$230.first  = control[1];
  assign \control$230.last  = control[2];
  assign \control$230.edge  = control[3];
  assign \control$230.tile  = control[7:4];
  assign \chain_i$232[0]  = \chain_i$232 [18:0];
  assign \chain_i$232[1]  = \chain_i$232 [37:19];
  assign \chain_i$232[2]  = \chain_i$232 [56:38];
  assign \chain_i$232[3]  = \chain_i$232 [75:57];
  assign \chain_o$233[0]  = \chain_i$232 [18:0];
  assign \chain_o$233[1]  = \chain_i$232 [37:19];
  assign \chain_o$233[2]  = \chain_i$232 [56:38];
  assign \chain_o$233[3]  = \chain_i$232 [75:57];
  assign \write$236.addr  = \$70 ;
  assign \write$236.data  = \$72 [519:448];
  assign \control$238.en  = control[0];
  assign \control$238.first  = control[1];
  assign \control$238.last  = control[2];
  assign \control$238.edge  = control[3];
  assign \control$238.tile  = control[7:4];
  assign \chain_i$240[0]  = \chain_i$240 [18:0];
  assign \chain_i$240[1]  = \chain_i$240 [37:19];
  assign \chain_i$240[2]  = \chain_i$240 [56:38];
  assign \chain_i$240[3]  = \chain_i$240 [75:57];
  assign \chain_o$241[0]  = \chain_i$240 [18:0];
  assign \chain_o$241[1]  = \chain_i$240 [37:19];
  assign \chain_o$241[2]  = \chain_i$240 [56:38];
  assign \chain_o$241[3]  = \chain_i$240 [75:57];
  assign \write$244.addr  = \$70 ;
  assign \write$244.data  = \$72 [519:448];
  assign \control$246.en  = control[0];
  assign \control$246.first  = control[1];
  assign \control$246.last  = control[2];
  assign \control$246.edge  = control[3];
  assign \control$246.tile  = control[7:4];
  assign \chain_i$248[0]  = \chain_i$248 [18:0];
  assign \chain_i$248[1]  = \chain_i$248 [37:19];
  assign \chain_i$248[2]  = \chain_i$248 [56:38];
  assign \chain_i$248[3]  = \chain_i$248 [75:57];
  assign \chain_o$249[0]  = \chain_i$248 [18:0];
  assign \chain_o$249[1]  = \chain_i$248 [37:19];
  assign \chain_o$249[2]  = \chain_i$248 [56:38];
  assign \chain_o$249[3]  = \chain_i$248 [75:57];
  assign \write$252.addr  = \$70 ;
  assign \write$252.data  = \$72 [519:448];
  assign \control$254.en  = control[0];
  assign \control$254.first  = control[1];
  assign \control$254.last  = control[2];
  assign \control$254.edge  = control[3];
  assign \control$254.tile  = control[7:4];
  assign \chain_i$256[0]  = \chain_i$256 [18:0];
  assign \chain_i$256[1]  = \chain_i$256 [37:19];
  assign \chain_i$256[2]  = \chain_i$256 [56:38];
  assign \chain_i$256[3]  = \chain_i$256 [75:57];
  assign \chain_o$257[0]  = \chain_i$256 [18:0];
  assign \chain_o$257[1]  = \chain_i$256 [37:19];
  assign \chain_o$257[2]  = \chain_i$256 [56:38];
  assign \chain_o$257[3]  = \chain_i$256 [75:57];
  assign \write$260.addr  = \$70 ;
  assign \write$260.data  = \$72 [519:448];
  assign \control$262.en  = control[0];
  assign \control$262.first  = control[1];
  assign \control$262.last  = control[2];
  assign \control$262.edge  = control[3];
  assign \control$262.tile  = control[7:4];
  assign \chain_i$264[0]  = \chain_i$264 [18:0];
  assign \chain_i$264[1]  = \chain_i$264 [37:19];
  assign \chain_i$264[2]  = \chain_i$264 [56:38];
  assign \chain_i$264[3]  = \chain_i$264 [75:57];
  assign \chain_o$265[0]  = \chain_i$264 [18:0];
  assign \chain_o$265[1]  = \chain_i$264 [37:19];
  assign \chain_o$265[2]  = \chain_i$264 [56:38];
  assign \chain_o$265[3]  = \chain_i$264 [75:57];
  assign \write$268.addr  = \$70 ;
  assign \write$268.data  = \$72 [519:448];
  assign \control$270.en  = control[0];
  assign \control$270.first  = control[1];
  assign \control$270.last  = control[2];
  assign \control$270.edge  = control[3];
  assign \control$270.tile  = control[7:4];
  assign \chain_i$272[0]  = \chain_i$272 [18:0];
  assign \chain_i$272[1]  = \chain_i$272 [37:19];
  assign \chain_i$272[2]  = \chain_i$272 [56:38];
  assign \chain_i$272[3]  = \chain_i$272 [75:57];
  assign \chain_o$273[0]  = \chain_i$272 [18:0];
  assign \chain_o$273[1]  = \chain_i$272 [37:19];
  assign \chain_o$273[2]  = \chain_i$272 [56:38];
  assign \chain_o$273[3]  = \chain_i$272 [75:57];
  assign \write$276.addr  = \$70 ;
  assign \write$276.data  = \$72 [519:448];
  assign \control$278.en  = control[0];
  assign \control$278.first  = control[1];
  assign \control$278.last  = control[2];
  assign \control$278.edge  = control[3];
  assign \control$278.tile  = control[7:4];
  assign \chain_i$280[0]  = \chain_i$280 [18:0];
  assign \chain_i$280[1]  = \chain_i$280 [37:19];
  assign \chain_i$280[2]  = \chain_i$280 [56:38];
  assign \chain_i$280[3]  = \chain_i$280 [75:57];
  assign \chain_o$281[0]  = \chain_i$280 [18:0];
  assign \chain_o$281[1]  = \chain_i$280 [37:19];
  assign \chain_o$281[2]  = \chain_i$280 [56:38];
  assign \chain_o$281[3]  = \chain_i$280 [75:57];
  assign \write$284.addr  = \$70 ;
  assign \write$284.data  = \$72 [519:448];
  assign \control$286.en  = control[0];
  assign \control$286.first  = control[1];
  assign \control$286.last  = control[2];
  assign \control$286.edge  = control[3];
  assign \control$286.tile  = control[7:4];
  assign \chain_i$288[0]  = \chain_i$288 [18:0];
  assign \chain_i$288[1]  = \chain_i$288 [37:19];
  assign \chain_i$288[2]  = \chain_i$288 [56:38];
  assign \chain_i$288[3]  = \chain_i$288 [75:57];
  assign \chain_o$289[0]  = \chain_i$288 [18:0];
  assign \chain_o$289[1]  = \chain_i$288 [37:19];
  assign \chain_o$289[2]  = \chain_i$288 [56:38];
  assign \chain_o$289[3]  = \chain_i$288 [75:57];
  assign \write$292.addr  = \$70 ;
  assign \write$292.data  = \$72 [519:448];
  assign \control$294.en  = control[0];
  assign \control$294.first  = control[1];
  assign \control$294.last  = control[2];
  assign \control$294.edge  = control[3];
  assign \control$294.tile  = control[7:4];
  assign \chain_i$296[0]  = \chain_i$296 [18:0];
  assign \chain_i$296[1]  = \chain_i$296 [37:19];
  assign \chain_i$296[2]  = \chain_i$296 [56:38];
  assign \chain_i$296[3]  = \chain_i$296 [75:57];
  assign \chain_o$297[0]  = \chain_i$296 [18:0];
  assign \chain_o$297[1]  = \chain_i$296 [37:19];
  assign \chain_o$297[2]  = \chain_i$296 [56:38];
  assign \chain_o$297[3]  = \chain_i$296 [75:57];
  assign \write$300.addr  = \$70 ;
  assign \write$300.data  = \$72 [519:448];
  assign \control$302.en  = control[0];
  assign \control$302.first  = control[1];
  assign \control$302.last  = control[2];
  assign \control$302.edge  = control[3];
  assign \control$302.tile  = control[7:4];
  assign \chain_i$304[0]  = \chain_i$304 [18:0];
  assign \chain_i$304[1]  = \chain_i$304 [37:19];
  assign \chain_i$304[2]  = \chain_i$304 [56:38];
  assign \chain_i$304[3]  = \chain_i$304 [75:57];
  assign \chain_o$305[0]  = \chain_i$304 [18:0];
  assign \chain_o$305[1]  = \chain_i$304 [37:19];
  assign \chain_o$305[2]  = \chain_i$304 [56:38];
  assign \chain_o$305[3]  = \chain_i$304 [75:57];
  assign \write$308.addr  = \$70 ;
  assign \write$308.data  = \$72 [519:448];
  assign \control$310.en  = control[0];
  assign \control$310.first  = control[1];
  assign \control$310.last  = control[2];
  assign \control$310.edge  = control[3];
  assign \control$310.tile  = control[7:4];
  assign \chain_i$312[0]  = \chain_i$312 [18:0];
  assign \chain_i$312[1]  = \chain_i$312 [37:19];
  assign \chain_i$312[2]  = \chain_i$312 [56:38];
  assign \chain_i$312[3]  = \chain_i$312 [75:57];
  assign \chain_o$313[0]  = \chain_i$312 [18:0];
  assign \chain_o$313[1]  = \chain_i$312 [37:19];
  assign \chain_o$313[2]  = \chain_i$312 [56:38];
  assign \chain_o$313[3]  = \chain_i$312 [75:57];
  assign \write$316.addr  = \$70 ;
  assign \write$316.data  = \$72 [519:448];
  assign \control$318.en  = control[0];
  assign \control$318.first  = control[1];
  assign \control$318.last  = control[2];
  assign \control$318.edge  = control[3];
  assign \control$318.tile  = control[7:4];
  assign \chain_i$320[0]  = \chain_i$320 [18:0];
  assign \chain_i$320[1]  = \chain_i$320 [37:19];
  assign \chain_i$320[2]  = \chain_i$320 [56:38];
  assign \chain_i$320[3]  = \chain_i$320 [75:57];
  assign \chain_o$321[0]  = \chain_i$320 [18:0];
  assign \chain_o$321[1]  = \chain_i$320 [37:19];
  assign \chain_o$321[2]  = \chain_i$320 [56:38];
  assign \chain_o$321[3]  = \chain_i$320 [75:57];
  assign \write$324.addr  = \$70 ;
  assign \write$324.data  = \$72 [519:448];
  assign \control$326.en  = control[0];
  assign \control$326.first  = control[1];
  assign \control$326.last  = control[2];
  assign \control$326.edge  = control[3];
  assign \control$326.tile  = control[7:4];
  assign \chain_i$328[0]  = \chain_i$328 [18:0];
  assign \chain_i$328[1]  = \chain_i$328 [37:19];
  assign \chain_i$328[2]  = \chain_i$328 [56:38];
  assign \chain_i$328[3]  = \chain_i$328 [75:57];
  assign \chain_o$329[0]  = \chain_i$328 [18:0];
  assign \chain_o$329[1]  = \chain_i$328 [37:19];
  assign \chain_o$329[2]  = \chain_i$328 [56:38];
  assign \chain_o$329[3]  = \chain_i$328 [75:57];
  assign \write$332.addr  = \$70 ;
  assign \write$332.data  = \$72 [519:448];
  assign \control$334.en  = control[0];
  assign \control$334.first  = control[1];
  assign \control$334.last  = control[2];
  assign \control$334.edge  = control[3];
  assign \control$334.tile  = control[7:4];
  assign \chain_i$336[0]  = \chain_i$336 [18:0];
  assign \chain_i$336[1]  = \chain_i$336 [37:19];
  assign \chain_i$336[2]  = \chain_i$336 [56:38];
  assign \chain_i$336[3]  = \chain_i$336 [75:57];
  assign \chain_o$337[0]  = \chain_i$336 [18:0];
  assign \chain_o$337[1]  = \chain_i$336 [37:19];
  assign \chain_o$337[2]  = \chain_i$336 [56:38];
  assign \chain_o$337[3]  = \chain_i$336 [75:57];
  assign \write$340.addr  = \$70 ;
  assign \write$340.data  = \$72 [519:448];
  assign \control$342.en  = control[0];
  assign \control$342.first  = control[1];
  assign \control$342.last  = control[2];
  assign \control$342.edge  = control[3];
  assign \control$342.tile  = control[7:4];
  assign \chain_i$344[0]  = \chain_i$344 [18:0];
  assign \chain_i$344[1]  = \chain_i$344 [37:19];
  assign \chain_i$344[2]  = \chain_i$344 [56:38];
  assign \chain_i$344[3]  = \chain_i$344 [75:57];
  assign \chain_o$345[0]  = \chain_i$344 [18:0];
  assign \chain_o$345[1]  = \chain_i$344 [37:19];
  assign \chain_o$345[2]  = \chain_i$344 [56:38];
  assign \chain_o$345[3]  = \chain_i$344 [75:57];
  assign \write$348.addr  = \$70 ;
  assign \write$348.data  = \$72 [519:448];
  assign \control$350.en  = control[0];
  assign \control$350.first  = control[1];
  assign \control$350.last  = control[2];
  assign \control$350.edge  = control[3];
  assign \control$350.tile  = control[7:4];
  assign \chain_i$352[0]  = \chain_i$352 [18:0];
  assign \chain_i$352[1]  = \chain_i$352 [37:19];
  assign \chain_i$352[2]  = \chain_i$352 [56:38];
  assign \chain_i$352[3]  = \chain_i$352 [75:57];
  assign \chain_o$353[0]  = \chain_i$352 [18:0];
  assign \chain_o$353[1]  = \chain_i$352 [37:19];
  assign \chain_o$353[2]  = \chain_i$352 [56:38];
  assign \chain_o$353[3]  = \chain_i$352 [75:57];
  assign \write$356.addr  = \$70 ;
  assign \write$356.data  = \$72 [519:448];
  assign \control$358.en  = control[0];
  assign \control$358.first  = control[1];
  assign \control$358.last  = control[2];
  assign \control$358.edge  = control[3];
  assign \control$358.tile  = control[7:4];
  assign \chain_i$360[0]  = \chain_i$360 [18:0];
  assign \chain_i$360[1]  = \chain_i$360 [37:19];
  assign \chain_i$360[2]  = \chain_i$360 [56:38];
  assign \chain_i$360[3]  = \chain_i$360 [75:57];
  assign \chain_o$361[0]  = \chain_i$360 [18:0];
  assign \chain_o$361[1]  = \chain_i$360 [37:19];
  assign \chain_o$361[2]  = \chain_i$360 [56:38];
  assign \chain_o$361[3]  = \chain_i$360 [75:57];
  assign \write$364.addr  = \$70 ;
  assign \write$364.data  = \$72 [519:448];
  assign \control$366.en  = control[0];
  assign \control$366.first  = control[1];
  assign \control$366.last  = control[2];
  assign \control$366.edge  = control[3];
  assign \control$366.tile  = control[7:4];
  assign \chain_i$368[0]  = \chain_i$368 [18:0];
  assign \chain_i$368[1]  = \chain_i$368 [37:19];
  assign \chain_i$368[2]  = \chain_i$368 [56:38];
  assign \chain_i$368[3]  = \chain_i$368 [75:57];
  assign \chain_o$369[0]  = \chain_i$368 [18:0];
  assign \chain_o$369[1]  = \chain_i$368 [37:19];
  assign \chain_o$369[2]  = \chain_i$368 [56:38];
  assign \chain_o$369[3]  = \chain_i$368 [75:57];
  assign \write$372.addr  = \$70 ;
  assign \write$372.data  = \$72 [519:448];
  assign \control$374.en  = control[0];
  assign \control$374.first  = control[1];
  assign \control$374.last  = control[2];
  assign \control$374.edge  = control[3];
  assign \control$374.tile  = control[7:4];
  assign \chain_i$376[0]  = \chain_i$376 [18:0];
  assign \chain_i$376[1]  = \chain_i$376 [37:19];
  assign \chain_i$376[2]  = \chain_i$376 [56:38];
  assign \chain_i$376[3]  = \chain_i$376 [75:57];
  assign \chain_o$377[0]  = \chain_i$376 [18:0];
  assign \chain_o$377[1]  = \chain_i$376 [37:19];
  assign \chain_o$377[2]  = \chain_i$376 [56:38];
  assign \chain_o$377[3]  = \chain_i$376 [75:57];
  assign \write$380.addr  = \$70 ;
  assign \write$380.data  = \$72 [519:448];
  assign \control$382.en  = control[0];
  assign \control$382.first  = control[1];
  assign \control$382.last  = control[2];
  assign \control$382.edge  = control[3];
  assign \control$382.tile  = control[7:4];
  assign \chain_i$384[0]  = \chain_i$384 [18:0];
  assign \chain_i$384[1]  = \chain_i$384 [37:19];
  assign \chain_i$384[2]  = \chain_i$384 [56:38];
  assign \chain_i$384[3]  = \chain_i$384 [75:57];
  assign \chain_o$385[0]  = \chain_i$384 [18:0];
  assign \chain_o$385[1]  = \chain_i$384 [37:19];
  assign \chain_o$385[2]  = \chain_i$384 [56:38];
  assign \chain_o$385[3]  = \chain_i$384 [75:57];
  assign \write$388.addr  = \$70 ;
  assign \write$388.data  = \$72 [519:448];
  assign \control$390.en  = control[0];
  assign \control$390.first  = control[1];
  assign \control$390.last  = control[2];
  assign \control$390.edge  = control[3];
  assign \control$390.tile  = control[7:4];
  assign \chain_i$392[0]  = \chain_i$392 [18:0];
  assign \chain_i$392[1]  = \chain_i$392 [37:19];
  assign \chain_i$392[2]  = \chain_i$392 [56:38];
  assign \chain_i$392[3]  = \chain_i$392 [75:57];
  assign \chain_o$393[0]  = \chain_i$392 [18:0];
  assign \chain_o$393[1]  = \chain_i$392 [37:19];
  assign \chain_o$393[2]  = \chain_i$392 [56:38];
  assign \chain_o$393[3]  = \chain_i$392 [75:57];
  assign \write$396.addr  = \$70 ;
  assign \write$396.data  = \$72 [519:448];
  assign \control$398.en  = control[0];
  assign \control$398.first  = control[1];
  assign \control$398.last  = control[2];
  assign \control$398.edge  = control[3];
  assign \control$398.tile  = control[7:4];
  assign \chain_i$400[0]  = \chain_i$400 [18:0];
  assign \chain_i$400[1]  = \chain_i$400 [37:19];
  assign \chain_i$400[2]  = \chain_i$400 [56:38];
  assign \chain_i$400[3]  = \chain_i$400 [75:57];
  assign \chain_o$401[0]  = \chain_i$400 [18:0];
  assign \chain_o$401[1]  = \chain_i$400 [37:19];
  assign \chain_o$401[2]  = \chain_i$400 [56:38];
  assign \chain_o$401[3]  = \chain_i$400 [75:57];
  assign \write$404.addr  = \$70 ;
  assign \write$404.data  = \$72 [519:448];
  assign \control$406.en  = control[0];
  assign \control$406.first  = control[1];
  assign \control$406.last  = control[2];
  assign \control$406.edge  = control[3];
  assign \control$406.tile  = control[7:4];
  assign \chain_i$408[0]  = \chain_i$408 [18:0];
  assign \chain_i$408[1]  = \chain_i$408 [37:19];
  assign \chain_i$408[2]  = \chain_i$408 [56:38];
  assign \chain_i$408[3]  = \chain_i$408 [75:57];
  assign \chain_o$409[0]  = \chain_i$408 [18:0];
  assign \chain_o$409[1]  = \chain_i$408 [37:19];
  assign \chain_o$409[2]  = \chain_i$408 [56:38];
  assign \chain_o$409[3]  = \chain_i$408 [75:57];
  assign \write$412.addr  = \$70 ;
  assign \write$412.data  = \$72 [519:448];
  assign \control$414.en  = control[0];
  assign \control$414.first  = control[1];
  assign \control$414.last  = control[2];
  assign \control$414.edge  = control[3];
  assign \control$414.tile  = control[7:4];
  assign \chain_i$416[0]  = \chain_i$416 [18:0];
  assign \chain_i$416[1]  = \chain_i$416 [37:19];
  assign \chain_i$416[2]  = \chain_i$416 [56:38];
  assign \chain_i$416[3]  = \chain_i$416 [75:57];
  assign \chain_o$417[0]  = \chain_i$416 [18:0];
  assign \chain_o$417[1]  = \chain_i$416 [37:19];
  assign \chain_o$417[2]  = \chain_i$416 [56:38];
  assign \chain_o$417[3]  = \chain_i$416 [75:57];
  assign \write$420.addr  = \$70 ;
  assign \write$420.data  = \$72 [519:448];
  assign \control$422.en  = control[0];
  assign \control$422.first  = control[1];
  assign \control$422.last  = control[2];
  assign \control$422.edge  = control[3];
  assign \control$422.tile  = control[7:4];
  assign \chain_i$424[0]  = \chain_i$424 [18:0];
  assign \chain_i$424[1]  = \chain_i$424 [37:19];
  assign \chain_i$424[2]  = \chain_i$424 [56:38];
  assign \chain_i$424[3]  = \chain_i$424 [75:57];
  assign \chain_o$425[0]  = \chain_i$424 [18:0];
  assign \chain_o$425[1]  = \chain_i$424 [37:19];
  assign \chain_o$425[2]  = \chain_i$424 [56:38];
  assign \chain_o$425[3]  = \chain_i$424 [75:57];
  assign \write$428.addr  = \$70 ;
  assign \write$428.data  = \$72 [519:448];
  assign \control$430.en  = control[0];
  assign \control$430.first  = control[1];
  assign \control$430.last  = control[2];
  assign \control$430.edge  = control[3];
  assign \control$430.tile  = control[7:4];
  assign \chain_i$432[0]  = \chain_i$432 [18:0];
  assign \chain_i$432[1]  = \chain_i$432 [37:19];
  assign \chain_i$432[2]  = \chain_i$432 [56:38];
  assign \chain_i$432[3]  = \chain_i$432 [75:57];
  assign \chain_o$433[0]  = \chain_i$432 [18:0];
  assign \chain_o$433[1]  = \chain_i$432 [37:19];
  assign \chain_o$433[2]  = \chain_i$432 [56:38];
  assign \chain_o$433[3]  = \chain_i$432 [75:57];
  assign \write$436.addr  = \$70 ;
  assign \write$436.data  = \$72 [519:448];
  assign \control$438.en  = control[0];
  assign \control$438.first  = control[1];
  assign \control$438.last  = control[2];
  assign \control$438.edge  = control[3];
  assign \control$438.tile  = control[7:4];
  assign \chain_i$440[0]  = \chain_i$440 [18:0];
  assign \chain_i$440[1]  = \chain_i$440 [37:19];
  assign \chain_i$440[2]  = \chain_i$440 [56:38];
  assign \chain_i$440[3]  = \chain_i$440 [75:57];
  assign \chain_o$441[0]  = \chain_i$440 [18:0];
  assign \chain_o$441[1]  = \chain_i$440 [37:19];
  assign \chain_o$441[2]  = \chain_i$440 [56:38];
  assign \chain_o$441[3]  = \chain_i$440 [75:57];
  assign \write$444.addr  = \$70 ;
  assign \write$444.data  = \$72 [519:448];
  assign \control$446.en  = control[0];
  assign \control$446.first  = control[1];
  assign \control$446.last  = control[2];
  assign \control$446.edge  = control[3];
  assign \control$446.tile  = control[7:4];
  assign \chain_i$448[0]  = \chain_i$448 [18:0];
  assign \chain_i$448[1]  = \chain_i$448 [37:19];
  assign \chain_i$448[2]  = \chain_i$448 [56:38];
  assign \chain_i$448[3]  = \chain_i$448 [75:57];
  assign \chain_o$449[0]  = \chain_i$448 [18:0];
  assign \chain_o$449[1]  = \chain_i$448 [37:19];
  assign \chain_o$449[2]  = \chain_i$448 [56:38];
  assign \chain_o$449[3]  = \chain_i$448 [75:57];
  assign \write$452.addr  = \$70 ;
  assign \write$452.data  = \$72 [519:448];
  assign \control$454.en  = control[0];
  assign \control$454.first  = control[1];
  assign \control$454.last  = control[2];
  assign \control$454.edge  = control[3];
  assign \control$454.tile  = control[7:4];
  assign \chain_i$456[0]  = \chain_i$456 [18:0];
  assign \chain_i$456[1]  = \chain_i$456 [37:19];
  assign \chain_i$456[2]  = \chain_i$456 [56:38];
  assign \chain_i$456[3]  = \chain_i$456 [75:57];
  assign \chain_o$457[0]  = \chain_i$456 [18:0];
  assign \chain_o$457[1]  = \chain_i$456 [37:19];
  assign \chain_o$457[2]  = \chain_i$456 [56:38];
  assign \chain_o$457[3]  = \chain_i$456 [75:57];
  assign \write$460.addr  = \$70 ;
  assign \write$460.data  = \$72 [519:448];
  assign \control$462.en  = control[0];
  assign \control$462.first  = control[1];
  assign \control$462.last  = control[2];
  assign \control$462.edge  = control[3];
  assign \control$462.tile  = control[7:4];
  assign \chain_i$464[0]  = \chain_i$464 [18:0];
  assign \chain_i$464[1]  = \chain_i$464 [37:19];
  assign \chain_i$464[2]  = \chain_i$464 [56:38];
  assign \chain_i$464[3]  = \chain_i$464 [75:57];
  assign \chain_o$465[0]  = \chain_i$464 [18:0];
  assign \chain_o$465[1]  = \chain_i$464 [37:19];
  assign \chain_o$465[2]  = \chain_i$464 [56:38];
  assign \chain_o$465[3]  = \chain_i$464 [75:57];
  assign \write$468.addr  = \$70 ;
  assign \write$468.data  = \$72 [519:448];
  assign \control$470.en  = control[0];
  assign \control$470.first  = control[1];
  assign \control$470.last  = control[2];
  assign \control$470.edge  = control[3];
  assign \control$470.tile  = control[7:4];
  assign \chain_i$472[0]  = \chain_i$472 [18:0];
  assign \chain_i$472[1]  = \chain_i$472 [37:19];
  assign \chain_i$472[2]  = \chain_i$472 [56:38];
  assign \chain_i$472[3]  = \chain_i$472 [75:57];
  assign \chain_o$473[0]  = \chain_i$472 [18:0];
  assign \chain_o$473[1]  = \chain_i$472 [37:19];
  assign \chain_o$473[2]  = \chain_i$472 [56:38];
  assign \chain_o$473[3]  = \chain_i$472 [75:57];
  assign \write$476.addr  = \$70 ;
  assign \write$476.data  = \$72 [519:448];
  assign \control$478.en  = control[0];
  assign \control$478.first  = control[1];
  assign \control$478.last  = control[2];
  assign \control$478.edge  = control[3];
  assign \control$478.tile  = control[7:4];
  assign \chain_i$480[0]  = \chain_i$480 [18:0];
  assign \chain_i$480[1]  = \chain_i$480 [37:19];
  assign \chain_i$480[2]  = \chain_i$480 [56:38];
  assign \chain_i$480[3]  = \chain_i$480 [75:57];
  assign \chain_o$481[0]  = \chain_i$480 [18:0];
  assign \chain_o$481[1]  = \chain_i$480 [37:19];
  assign \chain_o$481[2]  = \chain_i$480 [56:38];
  assign \chain_o$481[3]  = \chain_i$480 [75:57];
  assign \write$484.addr  = \$70 ;
  assign \write$484.data  = \$72 [519:448];
  assign \control$486.en  = control[0];
  assign \control$486.first  = control[1];
  assign \control$486.last  = control[2];
  assign \control$486.edge  = control[3];
  assign \control$486.tile  = control[7:4];
  assign \chain_i$488[0]  = \chain_i$488 [18:0];
  assign \chain_i$488[1]  = \chain_i$488 [37:19];
  assign \chain_i$488[2]  = \chain_i$488 [56:38];
  assign \chain_i$488[3]  = \chain_i$488 [75:57];
  assign \chain_o$489[0]  = \chain_i$488 [18:0];
  assign \chain_o$489[1]  = \chain_i$488 [37:19];
  assign \chain_o$489[2]  = \chain_i$488 [56:38];
  assign \chain_o$489[3]  = \chain_i$488 [75:57];
  assign \write$492.addr  = \$70 ;
  assign \write$492.data  = \$72 [519:448];
  assign \control$494.en  = control[0];
  assign \control$494.first  = control[1];
  assign \control$494.last  = control[2];
  assign \control$494.edge  = control[3];
  assign \control$494.tile  = control[7:4];
  assign \chain_i$496[0]  = \chain_i$496 [18:0];
  assign \chain_i$496[1]  = \chain_i$496 [37:19];
  assign \chain_i$496[2]  = \chain_i$496 [56:38];
  assign \chain_i$496[3]  = \chain_i$496 [75:57];
  assign \chain_o$497[0]  = \chain_i$496 [18:0];
  assign \chain_o$497[1]  = \chain_i$496 [37:19];
  assign \chain_o$497[2]  = \chain_i$496 [56:38];
  assign \chain_o$497[3]  = \chain_i$496 [75:57];
  assign \write$500.addr  = \$70 ;
  assign \write$500.data  = \$72 [519:448];
  assign \control$502.en  = control[0];
  assign \control$502.first  = control[1];
  assign \control$502.last  = control[2];
  assign \control$502.edge  = control[3];
  assign \control$502.tile  = control[7:4];
  assign \chain_i$504[0]  = \chain_i$504 [18:0];
  assign \chain_i$504[1]  = \chain_i$504 [37:19];
  assign \chain_i$504[2]  = \chain_i$504 [56:38];
  assign \chain_i$504[3]  = \chain_i$504 [75:57];
  assign \chain_o$505[0]  = \chain_i$504 [18:0];
  assign \chain_o$505[1]  = \chain_i$504 [37:19];
  assign \chain_o$505[2]  = \chain_i$504 [56:38];
  assign \chain_o$505[3]  = \chain_i$504 [75:57];
  assign \write$508.addr  = \$70 ;
  assign \write$508.data  = \$72 [519:448];
  assign \control$510.en  = control[0];
  assign \control$510.first  = control[1];
  assign \control$510.last  = control[2];
  assign \control$510.edge  = control[3];
  assign \control$510.tile  = control[7:4];
  assign \chain_i$512[0]  = \chain_i$512 [18:0];
  assign \chain_i$512[1]  = \chain_i$512 [37:19];
  assign \chain_i$512[2]  = \chain_i$512 [56:38];
  assign \chain_i$512[3]  = \chain_i$512 [75:57];
  assign \chain_o$513[0]  = \chain_i$512 [18:0];
  assign \chain_o$513[1]  = \chain_i$512 [37:19];
  assign \chain_o$513[2]  = \chain_i$512 [56:38];
  assign \chain_o$513[3]  = \chain_i$512 [75:57];
  assign \write$516.addr  = \$70 ;
  assign \write$516.data  = \$72 [519:448];
  assign \control$518.en  = control[0];
  assign \control$518.first  = control[1];
  assign \control$518.last  = control[2];
  assign \control$518.edge  = control[3];
  assign \control$518.tile  = control[7:4];
  assign \chain_i$520[0]  = \chain_i$520 [18:0];
  assign \chain_i$520[1]  = \chain_i$520 [37:19];
  assign \chain_i$520[2]  = \chain_i$520 [56:38];
  assign \chain_i$520[3]  = \chain_i$520 [75:57];
  assign \chain_o$521[0]  = \chain_i$520 [18:0];
  assign \chain_o$521[1]  = \chain_i$520 [37:19];
  assign \chain_o$521[2]  = \chain_i$520 [56:38];
  assign \chain_o$521[3]  = \chain_i$520 [75:57];
  assign \write$524.addr  = \$70 ;
  assign \write$524.data  = \$72 [519:448];
  assign \control$526.en  = control[0];
  assign \control$526.first  = control[1];
  assign \control$526.last  = control[2];
  assign \control$526.edge  = control[3];
  assign \control$526.tile  = control[7:4];
  assign \chain_i$528[0]  = \chain_i$528 [18:0];
  assign \chain_i$528[1]  = \chain_i$528 [37:19];
  assign \chain_i$528[2]  = \chain_i$528 [56:38];
  assign \chain_i$528[3]  = \chain_i$528 [75:57];
  assign \chain_o$529[0]  = \chain_i$528 [18:0];
  assign \chain_o$529[1]  = \chain_i$528 [37:19];
  assign \chain_o$529[2]  = \chain_i$528 [56:38];
  assign \chain_o$529[3]  = \chain_i$528 [75:57];
  assign \write$532.addr  = \$70 ;
  assign \write$532.data  = \$72 [519:448];
  assign \control$534.en  = control[0];
  assign \control$534.first  = control[1];
  assign \control$534.last  = control[2];
  assign \control$534.edge  = control[3];
  assign \control$534.tile  = control[7:4];
  assign \chain_i$536[0]  = \chain_i$536 [18:0];
  assign \chain_i$536[1]  = \chain_i$536 [37:19];
  assign \chain_i$536[2]  = \chain_i$536 [56:38];
  assign \chain_i$536[3]  = \chain_i$536 [75:57];
  assign \chain_o$537[0]  = \chain_i$536 [18:0];
  assign \chain_o$537[1]  = \chain_i$536 [37:19];
  assign \chain_o$537[2]  = \chain_i$536 [56:38];
  assign \chain_o$537[3]  = \chain_i$536 [75:57];
  assign \write$540.addr  = \$70 ;
  assign \write$540.data  = \$72 [519:448];
  assign \control$542.en  = control[0];
  assign \control$542.first  = control[1];
  assign \control$542.last  = control[2];
  assign \control$542.edge  = control[3];
  assign \control$542.tile  = control[7:4];
  assign \chain_i$544[0]  = \chain_i$544 [18:0];
  assign \chain_i$544[1]  = \chain_i$544 [37:19];
  assign \chain_i$544[2]  = \chain_i$544 [56:38];
  assign \chain_i$544[3]  = \chain_i$544 [75:57];
  assign \chain_o$545[0]  = \chain_i$544 [18:0];
  assign \chain_o$545[1]  = \chain_i$544 [37:19];
  assign \chain_o$545[2]  = \chain_i$544 [56:38];
  assign \chain_o$545[3]  = \chain_i$544 [75:57];
  assign \write$548.addr  = \$70 ;
  assign \write$548.data  = \$72 [519:448];
  assign \control$550.en  = control[0];
  assign \control$550.first  = control[1];
  assign \control$550.last  = control[2];
  assign \control$550.edge  = control[3];
  assign \control$550.tile  = control[7:4];
  assign \chain_i$552[0]  = \chain_i$552 [18:0];
  assign \chain_i$552[1]  = \chain_i$552 [37:19];
  assign \chain_i$552[2]  = \chain_i$552 [56:38];
  assign \chain_i$552[3]  = \chain_i$552 [75:57];
  assign \chain_o$553[0]  = \chain_i$552 [18:0];
  assign \chain_o$553[1]  = \chain_i$552 [37:19];
  assign \chain_o$553[2]  = \chain_i$552 [56:38];
  assign \chain_o$553[3]  = \chain_i$552 [75:57];
  assign \write$556.addr  = \$70 ;
  assign \write$556.data  = \$72 [519:448];
  assign \control$558.en  = control[0];
  assign \control$558.first  = control[1];
  assign \control$558.last  = control[2];
  assign \control$558.edge  = control[3];
  assign \control$558.tile  = control[7:4];
  assign \chain_i$560[0]  = \chain_i$560 [18:0];
  assign \chain_i$560[1]  = \chain_i$560 [37:19];
  assign \chain_i$560[2]  = \chain_i$560 [56:38];
  assign \chain_i$560[3]  = \chain_i$560 [75:57];
  assign \chain_o$561[0]  = \chain_i$560 [18:0];
  assign \chain_o$561[1]  = \chain_i$560 [37:19];
  assign \chain_o$561[2]  = \chain_i$560 [56:38];
  assign \chain_o$561[3]  = \chain_i$560 [75:57];
  assign \write$564.addr  = \$70 ;
  assign \write$564.data  = \$72 [519:448];
  assign \control$566.en  = control[0];
  assign \control$566.first  = control[1];
  assign \control$566.last  = control[2];
  assign \control$566.edge  = control[3];
  assign \control$566.tile  = control[7:4];
  assign \chain_i$568[0]  = \chain_i$568 [18:0];
  assign \chain_i$568[1]  = \chain_i$568 [37:19];
  assign \chain_i$568[2]  = \chain_i$568 [56:38];
  assign \chain_i$568[3]  = \chain_i$568 [75:57];
  assign \chain_o$569[0]  = \chain_i$568 [18:0];
  assign \chain_o$569[1]  = \chain_i$568 [37:19];
  assign \chain_o$569[2]  = \chain_i$568 [56:38];
  assign \chain_o$569[3]  = \chain_i$568 [75:57];
  assign \write$572.addr  = \$70 ;
  assign \write$572.data  = \$72 [519:448];
  assign \control$574.en  = control[0];
  assign \control$574.first  = control[1];
  assign \control$574.last  = control[2];
  assign \control$574.edge  = control[3];
  assign \control$574.tile  = control[7:4];
  assign \chain_i$576[0]  = \chain_i$576 [18:0];
  assign \chain_i$576[1]  = \chain_i$576 [37:19];
  assign \chain_i$576[2]  = \chain_i$576 [56:38];
  assign \chain_i$576[3]  = \chain_i$576 [75:57];
  assign \chain_o$577[0]  = \chain_i$576 [18:0];
  assign \chain_o$577[1]  = \chain_i$576 [37:19];
  assign \chain_o$577[2]  = \chain_i$576 [56:38];
  assign \chain_o$577[3]  = \chain_i$576 [75:57];
  assign \write$580.addr  = \$70 ;
  assign \write$580.data  = \$72 [519:448];
  assign \control$582.en  = control[0];
  assign \control$582.first  = control[1];
  assign \control$582.last  = control[2];
  assign \control$582.edge  = control[3];
  assign \control$582.tile  = control[7:4];
  assign \write$586.addr  = \$70 ;
  assign \write$586.data  = \$72 [519:448];
  assign \control$588.en  = control[0];
  assign \control$588.first  = control[1];
  assign \control$588.last  = control[2];
  assign \control$588.edge  = control[3];
  assign \control$588.tile  = control[7:4];
  assign \write$592.addr  = \$70 ;
  assign \write$592.data  = \$72 [519:448];
  assign \control$594.en  = control[0];
  assign \control$594.first  = control[1];
  assign \control$594.last  = control[2];
  assign \control$594.edge  = control[3];
  assign \control$594.tile  = control[7:4];
  assign \write$598.addr  = \$70 ;
  assign \write$598.data  = \$72 [519:448];
  assign \control$600.en  = control[0];
  assign \control$600.first  = control[1];
  assign \control$600.last  = control[2];
  assign \control$600.edge  = control[3];
  assign \control$600.tile  = control[7:4];
  assign \control0.en  = control0[0];
  assign \control0.first  = control0[1];
  assign \control0.last  = control0[2];
  assign \control0.edge  = control0[3];
  assign \control0.tile  = control0[7:4];
  assign \info0.tile  = info0[3:0];
  assign \info0.tile_last  = info0[4];
  assign \info0.slots  = info0[8:5];
  assign \info0.image_last  = info0[9];
  assign \control1.en  = control1[0];
  assign \control1.first  = control1[1];
  assign \control1.last  = control1[2];
  assign \control1.edge  = control1[3];
  assign \control1.tile  = control1[7:4];
  assign \info1.tile  = info1[3:0];
  assign \info1.tile_last  = info1[4];
  assign \info1.slots  = info1[8:5];
  assign \info1.image_last  = info1[9];
  assign \info2.tile  = info2[3:0];
  assign \info2.tile_last  = info2[4];
  assign \info2.slots  = info2[8:5];
  assign \info2.image_last  = info2[9];
  assign heads[303:228] = \chain_o$127 ;
  assign heads[227:152] = \chain_o$118 ;
  assign heads[151:76] = \chain_o$109 ;
  assign heads[75:0] = chain_o;
endmodule

module \macram_top.array.decoder (rst, soft_reset, height, width, c_in, c_out, mode, shape, error, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$2  = 0;
  wire [32:0] \$1 ;
  wire \$10 ;
  wire \$11 ;
  wire \$12 ;
  wire [25:0] \$13 ;
  wire \$14 ;
  wire [28:0] \$15 ;
  wire \$16 ;
  wire [32:0] \$17 ;
  wire [32:0] \$18 ;
  wire [14:0] \$19 ;
  wire [32:0] \$2 ;
  wire [14:0] \$20 ;
  wire [32:0] \$21 ;
  wire [32:0] \$22 ;
  wire [33:0] \$23 ;
  wire [34:0] \$24 ;
  wire [34:0] \$25 ;
  wire [33:0] \$26 ;
  wire [34:0] \$27 ;
  wire [34:0] \$28 ;
  wire \$29 ;
  wire [32:0] \$3 ;
  wire \$30 ;
  reg [132:0] \$31 ;
  reg [2:0] \$32 ;
  wire [32:0] \$4 ;
  wire \$5 ;
  wire \$6 ;
  wire \$7 ;
  wire \$8 ;
  wire \$9 ;
  wire [9:0] bad_shape;
  wire [13:0] blocks;
  input [31:0] c_in;
  wire [31:0] c_in;
  input [31:0] c_out;
  wire [31:0] c_out;
  input clk;
  wire clk;
  (* enum_base_type = "Error" *)
  (* enum_value_000 = "NONE" *)
  (* enum_value_001 = "BAD_SHAPE" *)
  (* enum_value_010 = "BAD_MODE" *)
  (* enum_value_011 = "TLAST_EARLY" *)
  (* enum_value_100 = "TLAST_MISSING" *)
  (* enum_value_101 = "BAD_COMMAND" *)
  output [2:0] error;
  reg [2:0] error = 3'h0;
  input [31:0] height;
  wire [31:0] height;
  input [31:0] mode;
  wire [31:0] mode;
  input rst;
  wire rst;
  output [132:0] shape;
  reg [132:0] shape = 133'h0000000000000000000000000000000000;
  wire [15:0] \shape.beats_in ;
  wire [15:0] \shape.beats_out ;
  wire [13:0] \shape.blocks ;
  wire [14:0] \shape.groups ;
  wire [15:0] \shape.height ;
  wire [13:0] \shape.ingest_words ;
  wire [11:0] \shape.output_words ;
  wire [1:0] \shape.tail ;
  wire [11:0] \shape.tiles ;
  wire [15:0] \shape.width ;
  input soft_reset;
  wire soft_reset;
  wire [11:0] tiles;
  input [31:0] width;
  wire [31:0] width;
  assign \$1  = c_in + 3'h7;
  assign \$3  = c_out + 6'h3f;
  assign \$5  = ! height;
  assign \$6  = ! width;
  assign \$7  = ! c_in;
  assign \$8  = ! c_out;
  assign \$9  = height > 16'hffff;
  assign \$10  = width > 16'hffff;
  assign \$11  = c_in > 11'h400;
  assign \$12  = c_out > 11'h400;
  assign \$13  = shape[88:77] * shape[62:49];
  assign \$14  = \$13  > 8'haa;
  assign \$15  = shape[46:32] * shape[76:63];
  assign \$16  = \$15  > 9'h100;
  assign \$17  = width + 2'h3;
  assign \$19  = \$2 [13:0] + 1'h1;
  assign \$21  = c_out + 4'hf;
  assign \$23  = c_in * 2'h3;
  assign \$24  = \$23  + 6'h3f;
  assign \$26  = c_out * 2'h3;
  assign \$27  = \$26  + 6'h3f;
  assign \$29  = mode != 17'h10103;
  assign \$30  = | bad_shape;
  always @(posedge clk)
    shape <= \$31 ;
  always @(posedge clk)
    error <= \$32 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$2 ) begin end
    \$31 [15:0] = height[15:0];
    \$31 [31:16] = width[15:0];
    \$31 [46:32] = \$18 [14:0];
    \$31 [48:47] = width[1:0];
    \$31 [62:49] = \$2 [13:0];
    \$31 [76:63] = \$20 [13:0];
    \$31 [88:77] = \$4 [11:0];
    \$31 [100:89] = \$22 [11:0];
    \$31 [116:101] = \$25 [15:0];
    \$31 [132:117] = \$28 [15:0];
    if (soft_reset) begin
      \$31  = 133'h0000000000000000000000000000000000;
    end
    if (rst) begin
      \$31  = 133'h0000000000000000000000000000000000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$2 ) begin end
    (* full_case = 32'd1 *)
    if (\$29 ) begin
      \$32  = 3'h2;
    end else if (\$30 ) begin
      \$32  = 3'h1;
    end else begin
      \$32  = 3'h0;
    end
    if (soft_reset) begin
      \$32  = 3'h0;
    end
    if (rst) begin
      \$32  = 3'h0;
    end
  end
  assign blocks = \$2 [13:0];
  assign tiles = \$4 [11:0];
  assign \shape.height  = shape[15:0];
  assign \shape.width  = shape[31:16];
  assign \shape.groups  = shape[46:32];
  assign \shape.tail  = shape[48:47];
  assign \shape.blocks  = shape[62:49];
  assign \shape.ingest_words  = shape[76:63];
  assign \shape.tiles  = shape[88:77];
  assign \shape.output_words  = shape[100:89];
  assign \shape.beats_in  = shape[116:101];
  assign \shape.beats_out  = shape[132:117];
  assign bad_shape[9] = \$16 ;
  assign bad_shape[8] = \$14 ;
  assign bad_shape[7] = \$12 ;
  assign bad_shape[6] = \$11 ;
  assign bad_shape[5] = \$10 ;
  assign bad_shape[4] = \$9 ;
  assign bad_shape[3] = \$8 ;
  assign bad_shape[2] = \$7 ;
  assign bad_shape[1] = \$6 ;
  assign bad_shape[0] = \$5 ;
  assign \$2  = { 3'h0, \$1 [32:3] };
  assign \$4  = { 6'h00, \$3 [32:6] };
  assign \$18  = { 2'h0, \$17 [32:2] };
  assign \$20  = { 1'h0, \$19 [14:1] };
  assign \$22  = { 4'h0, \$21 [32:4] };
  assign \$25  = { 6'h00, \$24 [34:6] };
  assign \$28  = { 6'h00, \$27 [34:6] };
endmodule

module \macram_top.array.drain (rst, start, finished, shift, credit, o__ready, soft_reset, \heads$59 , info, shape, o__payload, valid, reload__addr, reload__data, reload__en, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$3  = 0;
  wire \$1 ;
  reg [3:0] \$10 ;
  wire [12:0] \$11 ;
  wire \$12 ;
  wire \$13 ;
  wire \$14 ;
  wire \$15 ;
  wire \$16 ;
  wire \$17 ;
  wire \$18 ;
  wire [4:0] \$19 ;
  wire \$2 ;
  wire [4:0] \$20 ;
  wire \$21 ;
  wire [2:0] \$22 ;
  wire \$23 ;
  wire \$24 ;
  wire \$25 ;
  wire \$26 ;
  wire \$27 ;
  wire \$28 ;
  wire \$29 ;
  wire \$3 ;
  wire [2:0] \$30 ;
  wire [12:0] \$31 ;
  wire [2:0] \$32 ;
  reg \$33 ;
  reg [9:0] \$34 ;
  reg \$35 ;
  reg [3:0] \$36 ;
  reg [9:0] \$37 ;
  reg [3:0] \$38 ;
  reg [1:0] \$39 ;
  wire \$4 ;
  reg \$40 ;
  reg \$41 ;
  reg \$42 ;
  reg \$43 ;
  reg \$44 ;
  reg \$45 ;
  reg \$46 ;
  reg [1:0] \$47 ;
  reg [2:0] \$48 ;
  reg [11:0] \$49 ;
  wire \$5 ;
  reg [1:0] \$50 ;
  reg [1:0] \$51 ;
  reg [3:0] \$52 ;
  reg [3:0] \$53 ;
  reg [3:0] \$54 ;
  reg [3:0] \$55 ;
  reg [3:0] \$56 ;
  reg [3:0] \$57 ;
  wire \$6 ;
  wire \$7 ;
  wire \$8 ;
  wire [3:0] \$9 ;
  wire \$signal ;
  (* init = 8'h00 *)
  wire [7:0] \$signal$25 ;
  reg \$signal$29  = 1'h0;
  reg \$signal$3  = 1'h0;
  reg [1:0] \$signal$30  = 2'h0;
  reg [1:0] \$signal$32  = 2'h0;
  reg [1:0] \$signal$37  = 2'h0;
  reg \$signal$4  = 1'h0;
  reg [3:0] \$signal$5  = 4'h0;
  reg [7:0] \$signal$60  = 8'h00;
  reg [1:0] \$signal$61  = 2'h0;
  reg \$signal$62  = 1'h0;
  reg \$signal$63  = 1'h0;
  reg [3:0] \$signal$64  = 4'h0;
  reg \$signal$65  = 1'h0;
  reg [7:0] \$signal$66  = 8'h00;
  reg [1:0] \$signal$67  = 2'h0;
  reg \$signal$68  = 1'h0;
  reg \$signal$69  = 1'h0;
  wire \$signal$7 ;
  reg [3:0] \$signal$70  = 4'h0;
  reg \$signal$71  = 1'h0;
  reg \$signal$72  = 1'h0;
  reg [3:0] \$signal$73  = 4'h0;
  reg \$signal$74  = 1'h0;
  wire [7:0] \$signature__addr ;
  wire [535:0] \$signature__data ;
  reg [303:0] accumulators = 304'h0000000000000000000000000000000000000000000000000000000000000000000000000000;
  wire [75:0] \accumulators[0] ;
  wire [18:0] \accumulators[0][0] ;
  wire [18:0] \accumulators[0][1] ;
  wire [18:0] \accumulators[0][2] ;
  wire [18:0] \accumulators[0][3] ;
  wire [75:0] \accumulators[1] ;
  wire [18:0] \accumulators[1][0] ;
  wire [18:0] \accumulators[1][1] ;
  wire [18:0] \accumulators[1][2] ;
  wire [18:0] \accumulators[1][3] ;
  wire [75:0] \accumulators[2] ;
  wire [18:0] \accumulators[2][0] ;
  wire [18:0] \accumulators[2][1] ;
  wire [18:0] \accumulators[2][2] ;
  wire [18:0] \accumulators[2][3] ;
  wire [75:0] \accumulators[3] ;
  wire [18:0] \accumulators[3][0] ;
  wire [18:0] \accumulators[3][1] ;
  wire [18:0] \accumulators[3][2] ;
  wire [18:0] \accumulators[3][3] ;
  wire advance;
  input clk;
  wire clk;
  wire [47:0] codes;
  output credit;
  wire credit;
  reg [9:0] current = 10'h000;
  wire \current.image_last ;
  wire [3:0] \current.slots ;
  wire [3:0] \current.tile ;
  wire \current.tile_last ;
  wire fetch;
  reg [3:0] filled = 4'h0;
  input finished;
  wire finished;
  wire [7:0] get__addr;
  wire [191:0] get__data;
  wire get__en;
  wire group_start;
  (* init = 304'h0000000000000000000000000000000000000000000000000000000000000000000000000000 *)
  wire [303:0] heads;
  input [303:0] \heads$59 ;
  wire [303:0] \heads$59 ;
  wire [75:0] \heads$59[0] ;
  wire [18:0] \heads$59[0][0] ;
  wire [18:0] \heads$59[0][1] ;
  wire [18:0] \heads$59[0][2] ;
  wire [18:0] \heads$59[0][3] ;
  wire [75:0] \heads$59[1] ;
  wire [18:0] \heads$59[1][0] ;
  wire [18:0] \heads$59[1][1] ;
  wire [18:0] \heads$59[1][2] ;
  wire [18:0] \heads$59[1][3] ;
  wire [75:0] \heads$59[2] ;
  wire [18:0] \heads$59[2][0] ;
  wire [18:0] \heads$59[2][1] ;
  wire [18:0] \heads$59[2][2] ;
  wire [18:0] \heads$59[2][3] ;
  wire [75:0] \heads$59[3] ;
  wire [18:0] \heads$59[3][0] ;
  wire [18:0] \heads$59[3][1] ;
  wire [18:0] \heads$59[3][2] ;
  wire [18:0] \heads$59[3][3] ;
  wire [75:0] \heads[0] ;
  wire [18:0] \heads[0][0] ;
  wire [18:0] \heads[0][1] ;
  wire [18:0] \heads[0][2] ;
  wire [18:0] \heads[0][3] ;
  wire [75:0] \heads[1] ;
  wire [18:0] \heads[1][0] ;
  wire [18:0] \heads[1][1] ;
  wire [18:0] \heads[1][2] ;
  wire [18:0] \heads[1][3] ;
  wire [75:0] \heads[2] ;
  wire [18:0] \heads[2][0] ;
  wire [18:0] \heads[2][1] ;
  wire [18:0] \heads[2][2] ;
  wire [18:0] \heads[2][3] ;
  wire [75:0] \heads[3] ;
  wire [18:0] \heads[3][0] ;
  wire [18:0] \heads[3][1] ;
  wire [18:0] \heads[3][2] ;
  wire [18:0] \heads[3][3] ;
  reg [3:0] image_last = 4'h0;
  reg [3:0] index = 4'h0;
  input [9:0] info;
  wire [9:0] info;
  wire \info.image_last ;
  wire [3:0] \info.slots ;
  wire [3:0] \info.tile ;
  wire \info.tile_last ;
  wire [9:0] info_now;
  wire \info_now.image_last ;
  wire [3:0] \info_now.slots ;
  wire [3:0] \info_now.tile ;
  wire \info_now.tile_last ;
  wire last_cycle;
  reg [2:0] meta = 3'h0;
  wire \meta.data ;
  wire \meta.last ;
  wire \meta.pixel_last ;
  output [49:0] o__payload;
  reg [49:0] o__payload;
  wire [47:0] \o__payload.data ;
  wire \o__payload.last ;
  wire \o__payload.pixel_last ;
  input o__ready;
  wire o__ready;
  (* init = 1'h0 *)
  wire o__valid;
  wire [535:0] parameters;
  wire pixel_after;
  reg [7:0] put__addr = 8'h00;
  wire [191:0] put__data;
  wire [3:0] put__en;
  input [7:0] reload__addr;
  wire [7:0] reload__addr;
  input [535:0] reload__data;
  wire [535:0] reload__data;
  input reload__en;
  wire reload__en;
  input rst;
  wire rst;
  reg [1:0] section = 2'h0;
  wire section_done;
  input [132:0] shape;
  wire [132:0] shape;
  wire [15:0] \shape.beats_in ;
  wire [15:0] \shape.beats_out ;
  wire [13:0] \shape.blocks ;
  wire [14:0] \shape.groups ;
  wire [15:0] \shape.height ;
  wire [13:0] \shape.ingest_words ;
  wire [11:0] \shape.output_words ;
  wire [1:0] \shape.tail ;
  wire [11:0] \shape.tiles ;
  wire [15:0] \shape.width ;
  output shift;
  wire shift;
  reg [1:0] slot_read = 2'h0;
  reg [3:0] slots0 = 4'h0;
  reg [3:0] slots1 = 4'h0;
  reg [3:0] slots2 = 4'h0;
  reg [3:0] slots3 = 4'h0;
  input soft_reset;
  wire soft_reset;
  input start;
  wire start;
  wire [3:0] todo;
  output valid;
  reg valid = 1'h0;
  reg [9:0] waiting = 10'h000;
  wire \waiting.image_last ;
  wire [3:0] \waiting.slots ;
  wire [3:0] \waiting.tile ;
  wire \waiting.tile_last ;
  reg [11:0] word = 12'h000;
  wire word_last;
  wire [543:0] write;
  wire [7:0] \write.addr ;
  wire [535:0] \write.data ;
  wire write_en;
  assign \$30  = \$signal$37  + 1'h1;
  assign \$31  = word + 1'h1;
  assign \$32  = \$signal$32  + 1'h1;
  always @(posedge clk)
    \$signal$3  <= \$33 ;
  always @(posedge clk)
    waiting <= \$34 ;
  always @(posedge clk)
    \$signal$4  <= \$35 ;
  always @(posedge clk)
    index <= \$36 ;
  always @(posedge clk)
    current <= \$37 ;
  always @(posedge clk)
    \$signal$5  <= \$38 ;
  always @(posedge clk)
    section <= \$39 ;
  always @(posedge clk)
    accumulators <= \heads$59 ;
  always @(posedge clk)
    \$signal$60  <= { section, info_now[3:0], index[3:2] };
  always @(posedge clk)
    \$signal$61  <= index[1:0];
  always @(posedge clk)
    \$signal$62  <= \$40 ;
  always @(posedge clk)
    \$signal$63  <= \$41 ;
  always @(posedge clk)
    \$signal$64  <= info_now[8:5];
  always @(posedge clk)
    \$signal$65  <= info_now[9];
  always @(posedge clk)
    \$signal$66  <= \$signal$60 ;
  always @(posedge clk)
    \$signal$67  <= \$signal$61 ;
  always @(posedge clk)
    \$signal$68  <= \$42 ;
  always @(posedge clk)
    \$signal$69  <= \$43 ;
  always @(posedge clk)
    \$signal$70  <= \$signal$64 ;
  always @(posedge clk)
    \$signal$71  <= \$signal$65 ;
  always @(posedge clk)
    put__addr <= \$signal$66 ;
  always @(posedge clk)
    \$signal$30  <= \$signal$67 ;
  always @(posedge clk)
    \$signal$29  <= \$44 ;
  always @(posedge clk)
    \$signal$72  <= \$45 ;
  always @(posedge clk)
    \$signal$73  <= \$signal$70 ;
  always @(posedge clk)
    \$signal$74  <= \$signal$71 ;
  always @(posedge clk)
    valid <= \$46 ;
  always @(posedge clk)
    slot_read <= \$47 ;
  always @(posedge clk)
    meta <= \$48 ;
  always @(posedge clk)
    word <= \$49 ;
  always @(posedge clk)
    \$signal$37  <= \$50 ;
  always @(posedge clk)
    \$signal$32  <= \$51 ;
  always @(posedge clk)
    filled <= \$52 ;
  always @(posedge clk)
    image_last <= \$53 ;
  always @(posedge clk)
    slots0 <= \$54 ;
  always @(posedge clk)
    slots1 <= \$55 ;
  always @(posedge clk)
    slots2 <= \$56 ;
  always @(posedge clk)
    slots3 <= \$57 ;
  assign group_start = ! waiting[3:0];
  assign \$1  = ~ \$signal$4 ;
  assign \$2  = \$signal$3  & \$1 ;
  assign \$3  = ~ group_start;
  assign \$4  = \$signal$5  >> section;
  assign \$5  = ~ \$4 ;
  assign \$6  = \$3  | \$5 ;
  assign \$signal  = \$2  & \$6 ;
  assign \$signal$7  = \$signal$4  | \$signal ;
  assign info_now = \$signal$4  ? current : waiting;
  assign \$7  = index == 4'hf;
  assign last_cycle = \$signal$7  & \$7 ;
  assign \$8  = index == 4'h9;
  assign credit = \$signal$7  & \$8 ;
  assign \$9  = 1'h1 << \$signal$30 ;
  assign put__en = \$signal$29  ? \$9  : 4'h0;
  assign todo = \$10  >> \$signal$37 ;
  assign \$11  = word + 1'h1;
  assign word_last = \$11  == shape[100:89];
  assign pixel_after = | todo[3:1];
  assign \$12  = ~ valid;
  assign advance = \$12  | o__ready;
  assign \$13  = filled >> \$signal$32 ;
  assign fetch = \$13  & advance;
  assign \$14  = ~ todo[0];
  assign \$15  = word_last | \$14 ;
  assign \$16  = fetch & \$15 ;
  assign \$17  = ~ pixel_after;
  assign section_done = \$16  & \$17 ;
  assign \$18  = ~ last_cycle;
  assign \$19  = index + 1'h1;
  assign \$20  = last_cycle ? 5'h00 : \$19 ;
  assign \$21  = last_cycle & info_now[4];
  assign \$22  = section + 1'h1;
  assign \$23  = last_cycle & info_now[4];
  assign \$24  = fetch & todo[0];
  assign \$25  = image_last >> \$signal$32 ;
  assign \$26  = ~ pixel_after;
  assign \$27  = \$25  & \$26 ;
  assign \$28  = ~ todo[0];
  assign \$29  = \$28  | word_last;
  macram_ram #(
    .ADDR_BITS(32'd8),
    .DEPTH(32'd256),
    .INIT_FILE(),
    .LANES(32'd4),
    .WIDTH(32'd192)
  ) buffer (
    .clk(clk),
    .read_addr({ \$signal$32 , word[5:0] }),
    .read_data(get__data),
    .read_en(advance),
    .write_addr(put__addr),
    .write_data({ codes, codes, codes, codes }),
    .write_en(put__en)
  );
  macram_ram #(
    .ADDR_BITS(32'd8),
    .DEPTH(32'd256),
    .INIT_FILE("requant.mem"),
    .LANES(32'd1),
    .WIDTH(32'd536)
  ) \parameters$78  (
    .clk(clk),
    .read_addr({ info_now[3:0], index }),
    .read_data(parameters),
    .read_en(1'h1),
    .write_addr(reload__addr),
    .write_data(reload__data),
    .write_en(reload__en)
  );
  \macram_top.array.drain.requant  requant (
    .accumulators(accumulators),
    .clk(clk),
    .codes(codes),
    .parameters(parameters),
    .rst(rst),
    .soft_reset(soft_reset)
  );
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    (* full_case = 32'd1 *)
    casez (slot_read)
      2'h0:
          o__payload[47:0] = { get__data[155:144], get__data[107:96], get__data[59:48], get__data[11:0] };
      2'h1:
          o__payload[47:0] = { get__data[167:156], get__data[119:108], get__data[71:60], get__data[23:12] };
      2'h2:
          o__payload[47:0] = { get__data[179:168], get__data[131:120], get__data[83:72], get__data[35:24] };
      2'h3:
          o__payload[47:0] = { get__data[191:180], get__data[143:132], get__data[95:84], get__data[47:36] };
    endcase
    begin
      begin
        o__payload[48] = meta[1];
        o__payload[49] = meta[2];
      end
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$33  = \$signal$3 ;
    if (finished) begin
      \$33  = 1'h1;
    end else if (\$signal ) begin
      \$33  = 1'h0;
    end
    if (start) begin
      \$33  = 1'h0;
    end
    if (soft_reset) begin
      \$33  = 1'h0;
    end
    if (rst) begin
      \$33  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$34  = waiting;
    if (finished) begin
      \$34  = info;
    end
    if (soft_reset) begin
      \$34  = 10'h000;
    end
    if (rst) begin
      \$34  = 10'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$35  = \$signal$4 ;
    if (\$signal$7 ) begin
      \$35  = \$18 ;
    end
    if (start) begin
      \$35  = 1'h0;
    end
    if (soft_reset) begin
      \$35  = 1'h0;
    end
    if (rst) begin
      \$35  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$36  = index;
    if (\$signal$7 ) begin
      \$36  = \$20 [3:0];
    end
    if (start) begin
      \$36  = 4'h0;
    end
    if (soft_reset) begin
      \$36  = 4'h0;
    end
    if (rst) begin
      \$36  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$37  = current;
    if (\$signal ) begin
      \$37  = waiting;
    end
    if (soft_reset) begin
      \$37  = 10'h000;
    end
    if (rst) begin
      \$37  = 10'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$38  = \$signal$5 ;
    if (\$signal ) begin
      if (group_start) begin
        (* full_case = 32'd1 *)
        casez (section)
          2'h0:
              \$38 [0] = 1'h1;
          2'h1:
              \$38 [1] = 1'h1;
          2'h2:
              \$38 [2] = 1'h1;
          2'h3:
              \$38 [3] = 1'h1;
        endcase
      end
    end
    if (section_done) begin
      (* full_case = 32'd1 *)
      casez (\$signal$32 )
        2'h0:
            \$38 [0] = 1'h0;
        2'h1:
            \$38 [1] = 1'h0;
        2'h2:
            \$38 [2] = 1'h0;
        2'h3:
            \$38 [3] = 1'h0;
      endcase
    end
    if (start) begin
      \$38  = 4'h0;
    end
    if (soft_reset) begin
      \$38  = 4'h0;
    end
    if (rst) begin
      \$38  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$39  = section;
    if (\$21 ) begin
      \$39  = \$22 [1:0];
    end
    if (start) begin
      \$39  = 2'h0;
    end
    if (soft_reset) begin
      \$39  = 2'h0;
    end
    if (rst) begin
      \$39  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$40  = \$signal$7 ;
    if (soft_reset) begin
      \$40  = 1'h0;
    end
    if (rst) begin
      \$40  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$41  = \$23 ;
    if (soft_reset) begin
      \$41  = 1'h0;
    end
    if (rst) begin
      \$41  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$42  = \$signal$62 ;
    if (soft_reset) begin
      \$42  = 1'h0;
    end
    if (rst) begin
      \$42  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$43  = \$signal$63 ;
    if (soft_reset) begin
      \$43  = 1'h0;
    end
    if (rst) begin
      \$43  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$44  = \$signal$68 ;
    if (soft_reset) begin
      \$44  = 1'h0;
    end
    if (rst) begin
      \$44  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$45  = \$signal$69 ;
    if (soft_reset) begin
      \$45  = 1'h0;
    end
    if (rst) begin
      \$45  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$46  = valid;
    if (advance) begin
      \$46  = \$24 ;
    end
    if (start) begin
      \$46  = 1'h0;
    end
    if (soft_reset) begin
      \$46  = 1'h0;
    end
    if (rst) begin
      \$46  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$47  = slot_read;
    if (advance) begin
      \$47  = \$signal$37 ;
    end
    if (soft_reset) begin
      \$47  = 2'h0;
    end
    if (rst) begin
      \$47  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$48  = meta;
    if (advance) begin
      \$48 [1] = word_last;
      \$48 [2] = \$27 ;
    end
    if (soft_reset) begin
      \$48 [2:1] = 2'h0;
    end
    if (rst) begin
      \$48  = 3'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$49  = word;
    if (fetch) begin
      (* full_case = 32'd1 *)
      if (\$29 ) begin
        \$49  = 12'h000;
      end else begin
        \$49  = \$31 [11:0];
      end
    end
    if (section_done) begin
      \$49  = 12'h000;
    end
    if (start) begin
      \$49  = 12'h000;
    end
    if (soft_reset) begin
      \$49  = 12'h000;
    end
    if (rst) begin
      \$49  = 12'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$50  = \$signal$37 ;
    if (fetch) begin
      if (\$29 ) begin
        \$50  = \$30 [1:0];
      end
    end
    if (section_done) begin
      \$50  = 2'h0;
    end
    if (start) begin
      \$50  = 2'h0;
    end
    if (soft_reset) begin
      \$50  = 2'h0;
    end
    if (rst) begin
      \$50  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$51  = \$signal$32 ;
    if (section_done) begin
      \$51  = \$32 [1:0];
    end
    if (start) begin
      \$51  = 2'h0;
    end
    if (soft_reset) begin
      \$51  = 2'h0;
    end
    if (rst) begin
      \$51  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$52  = filled;
    if (section_done) begin
      (* full_case = 32'd1 *)
      casez (\$signal$32 )
        2'h0:
            \$52 [0] = 1'h0;
        2'h1:
            \$52 [1] = 1'h0;
        2'h2:
            \$52 [2] = 1'h0;
        2'h3:
            \$52 [3] = 1'h0;
      endcase
    end
    if (\$signal$72 ) begin
      (* full_case = 32'd1 *)
      casez (put__addr[7:6])
        2'h0:
            \$52 [0] = 1'h1;
        2'h1:
            \$52 [1] = 1'h1;
        2'h2:
            \$52 [2] = 1'h1;
        2'h3:
            \$52 [3] = 1'h1;
      endcase
    end
    if (start) begin
      \$52  = 4'h0;
    end
    if (soft_reset) begin
      \$52  = 4'h0;
    end
    if (rst) begin
      \$52  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$53  = image_last;
    if (\$signal$72 ) begin
      (* full_case = 32'd1 *)
      casez (put__addr[7:6])
        2'h0:
            \$53 [0] = \$signal$74 ;
        2'h1:
            \$53 [1] = \$signal$74 ;
        2'h2:
            \$53 [2] = \$signal$74 ;
        2'h3:
            \$53 [3] = \$signal$74 ;
      endcase
    end
    if (soft_reset) begin
      \$53  = 4'h0;
    end
    if (rst) begin
      \$53  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$54  = slots0;
    if (\$signal$72 ) begin
      casez (put__addr[7:6])
        2'h0:
            \$54  = \$signal$73 ;
      endcase
    end
    if (soft_reset) begin
      \$54  = 4'h0;
    end
    if (rst) begin
      \$54  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$55  = slots1;
    if (\$signal$72 ) begin
      casez (put__addr[7:6])
        2'h0:
            /* empty */;
        2'h1:
            \$55  = \$signal$73 ;
      endcase
    end
    if (soft_reset) begin
      \$55  = 4'h0;
    end
    if (rst) begin
      \$55  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$56  = slots2;
    if (\$signal$72 ) begin
      casez (put__addr[7:6])
        2'h0:
            /* empty */;
        2'h1:
            /* empty */;
        2'h2:
            \$56  = \$signal$73 ;
      endcase
    end
    if (soft_reset) begin
      \$56  = 4'h0;
    end
    if (rst) begin
      \$56  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$57  = slots3;
    if (\$signal$72 ) begin
      (* full_case = 32'd1 *)
      casez (put__addr[7:6])
        2'h0:
            /* empty */;
        2'h1:
            /* empty */;
        2'h2:
            /* empty */;
        2'h3:
            \$57  = \$signal$73 ;
      endcase
    end
    if (soft_reset) begin
      \$57  = 4'h0;
    end
    if (rst) begin
      \$57  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    (* full_case = 32'd1 *)
    casez (\$signal$32 )
      2'h0:
          \$10  = slots0;
      2'h1:
          \$10  = slots1;
      2'h2:
          \$10  = slots2;
      2'h3:
          \$10  = slots3;
    endcase
  end
  assign write = { reload__data, reload__addr };
  assign write_en = reload__en;
  assign \$signature__addr  = { info_now[3:0], index };
  assign \$signature__data  = parameters;
  assign heads = accumulators;
  assign \$signal$25  = put__addr;
  assign put__data = { codes, codes, codes, codes };
  assign get__addr = { \$signal$32 , word[5:0] };
  assign get__en = advance;
  assign o__valid = valid;
  assign shift = \$signal$7 ;
  assign \waiting.tile  = waiting[3:0];
  assign \waiting.tile_last  = waiting[4];
  assign \waiting.slots  = waiting[8:5];
  assign \waiting.image_last  = waiting[9];
  assign \info_now.tile  = info_now[3:0];
  assign \info_now.tile_last  = info_now[4];
  assign \info_now.slots  = info_now[8:5];
  assign \info_now.image_last  = info_now[9];
  assign \current.tile  = current[3:0];
  assign \current.tile_last  = current[4];
  assign \current.slots  = current[8:5];
  assign \current.image_last  = current[9];
  assign \write.addr  = reload__addr;
  assign \write.data  = reload__data;
  assign \accumulators[0]  = accumulators[75:0];
  assign \accumulators[0][0]  = accumulators[18:0];
  assign \accumulators[0][1]  = accumulators[37:19];
  assign \accumulators[0][2]  = accumulators[56:38];
  assign \accumulators[0][3]  = accumulators[75:57];
  assign \accumulators[1]  = accumulators[151:76];
  assign \accumulators[1][0]  = accumulators[94:76];
  assign \accumulators[1][1]  = accumulators[113:95];
  assign \accumulators[1][2]  = accumulators[132:114];
  assign \accumulators[1][3]  = accumulators[151:133];
  assign \accumulators[2]  = accumulators[227:152];
  assign \accumulators[2][0]  = accumulators[170:152];
  assign \accumulators[2][1]  = accumulators[189:171];
  assign \accumulators[2][2]  = accumulators[208:190];
  assign \accumulators[2][3]  = accumulators[227:209];
  assign \accumulators[3]  = accumulators[303:228];
  assign \accumulators[3][0]  = accumulators[246:228];
  assign \accumulators[3][1]  = accumulators[265:247];
  assign \accumulators[3][2]  = accumulators[284:266];
  assign \accumulators[3][3]  = accumulators[303:285];
  assign \heads[0]  = accumulators[75:0];
  assign \heads[0][0]  = accumulators[18:0];
  assign \heads[0][1]  = accumulators[37:19];
  assign \heads[0][2]  = accumulators[56:38];
  assign \heads[0][3]  = accumulators[75:57];
  assign \heads[1]  = accumulators[151:76];
  assign \heads[1][0]  = accumulators[94:76];
  assign \heads[1][1]  = accumulators[113:95];
  assign \heads[1][2]  = accumulators[132:114];
  assign \heads[1][3]  = accumulators[151:133];
  assign \heads[2]  = accumulators[227:152];
  assign \heads[2][0]  = accumulators[170:152];
  assign \heads[2][1]  = accumulators[189:171];
  assign \heads[2][2]  = accumulators[208:190];
  assign \heads[2][3]  = accumulators[227:209];
  assign \heads[3]  = accumulators[303:228];
  assign \heads[3][0]  = accumulators[246:228];
  assign \heads[3][1]  = accumulators[265:247];
  assign \heads[3][2]  = accumulators[284:266];
  assign \heads[3][3]  = accumulators[303:285];
  assign \shape.height  = shape[15:0];
  assign \shape.width  = shape[31:16];
  assign \shape.groups  = shape[46:32];
  assign \shape.tail  = shape[48:47];
  assign \shape.blocks  = shape[62:49];
  assign \shape.ingest_words  = shape[76:63];
  assign \shape.tiles  = shape[88:77];
  assign \shape.output_words  = shape[100:89];
  assign \shape.beats_in  = shape[116:101];
  assign \shape.beats_out  = shape[132:117];
  assign \o__payload.data  = o__payload[47:0];
  assign \o__payload.pixel_last  = o__payload[48];
  assign \o__payload.last  = o__payload[49];
  assign \meta.data  = meta[0];
  assign \meta.pixel_last  = meta[1];
  assign \meta.last  = meta[2];
  assign \info.tile  = info[3:0];
  assign \info.tile_last  = info[4];
  assign \info.slots  = info[8:5];
  assign \info.image_last  = info[9];
  assign \heads$59[0]  = \heads$59 [75:0];
  assign \heads$59[0][0]  = \heads$59 [18:0];
  assign \heads$59[0][1]  = \heads$59 [37:19];
  assign \heads$59[0][2]  = \heads$59 [56:38];
  assign \heads$59[0][3]  = \heads$59 [75:57];
  assign \heads$59[1]  = \heads$59 [151:76];
  assign \heads$59[1][0]  = \heads$59 [94:76];
  assign \heads$59[1][1]  = \heads$59 [113:95];
  assign \heads$59[1][2]  = \heads$59 [132:114];
  assign \heads$59[1][3]  = \heads$59 [151:133];
  assign \heads$59[2]  = \heads$59 [227:152];
  assign \heads$59[2][0]  = \heads$59 [170:152];
  assign \heads$59[2][1]  = \heads$59 [189:171];
  assign \heads$59[2][2]  = \heads$59 [208:190];
  assign \heads$59[2][3]  = \heads$59 [227:209];
  assign \heads$59[3]  = \heads$59 [303:228];
  assign \heads$59[3][0]  = \heads$59 [246:228];
  assign \heads$59[3][1]  = \heads$59 [265:247];
  assign \heads$59[3][2]  = \heads$59 [284:266];
  assign \heads$59[3][3]  = \heads$59 [303:285];
endmodule

module \macram_top.array.drain.requant (rst, parameters, soft_reset, accumulators, codes, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$4  = 0;
  wire \$1 ;
  wire \$10 ;
  wire \$100 ;
  wire \$101 ;
  wire \$102 ;
  wire \$103 ;
  wire [2:0] \$104 ;
  wire \$105 ;
  wire \$106 ;
  wire \$107 ;
  wire \$108 ;
  wire \$109 ;
  wire \$11 ;
  wire \$110 ;
  wire \$111 ;
  wire [2:0] \$112 ;
  wire \$113 ;
  wire \$114 ;
  wire \$115 ;
  wire \$116 ;
  wire \$117 ;
  wire \$118 ;
  wire \$119 ;
  wire \$12 ;
  wire [2:0] \$120 ;
  wire \$121 ;
  wire \$122 ;
  wire \$123 ;
  wire \$124 ;
  wire \$125 ;
  wire \$126 ;
  wire \$127 ;
  wire [2:0] \$128 ;
  wire [1:0] \$129 ;
  wire \$13 ;
  wire [1:0] \$130 ;
  wire [2:0] \$131 ;
  wire [1:0] \$132 ;
  wire [2:0] \$133 ;
  wire [3:0] \$134 ;
  wire [1:0] \$135 ;
  wire [1:0] \$136 ;
  wire [2:0] \$137 ;
  wire [1:0] \$138 ;
  wire [2:0] \$139 ;
  wire \$14 ;
  wire [3:0] \$140 ;
  wire [1:0] \$141 ;
  wire [1:0] \$142 ;
  wire [2:0] \$143 ;
  wire [1:0] \$144 ;
  wire [2:0] \$145 ;
  wire [3:0] \$146 ;
  wire [1:0] \$147 ;
  wire [1:0] \$148 ;
  wire [2:0] \$149 ;
  wire \$15 ;
  wire [1:0] \$150 ;
  wire [2:0] \$151 ;
  wire [3:0] \$152 ;
  wire [1:0] \$153 ;
  wire [1:0] \$154 ;
  wire [2:0] \$155 ;
  wire [1:0] \$156 ;
  wire [2:0] \$157 ;
  wire [3:0] \$158 ;
  wire [1:0] \$159 ;
  wire [2:0] \$16 ;
  wire [1:0] \$160 ;
  wire [2:0] \$161 ;
  wire [1:0] \$162 ;
  wire [2:0] \$163 ;
  wire [3:0] \$164 ;
  wire [1:0] \$165 ;
  wire [1:0] \$166 ;
  wire [2:0] \$167 ;
  wire [1:0] \$168 ;
  wire [2:0] \$169 ;
  wire \$17 ;
  wire [3:0] \$170 ;
  wire [1:0] \$171 ;
  wire [1:0] \$172 ;
  wire [2:0] \$173 ;
  wire [1:0] \$174 ;
  wire [2:0] \$175 ;
  wire [3:0] \$176 ;
  wire [1:0] \$177 ;
  wire [1:0] \$178 ;
  wire [2:0] \$179 ;
  wire \$18 ;
  wire [1:0] \$180 ;
  wire [2:0] \$181 ;
  wire [3:0] \$182 ;
  wire [1:0] \$183 ;
  wire [1:0] \$184 ;
  wire [2:0] \$185 ;
  wire [1:0] \$186 ;
  wire [2:0] \$187 ;
  wire [3:0] \$188 ;
  wire [1:0] \$189 ;
  wire \$19 ;
  wire [1:0] \$190 ;
  wire [2:0] \$191 ;
  wire [1:0] \$192 ;
  wire [2:0] \$193 ;
  wire [3:0] \$194 ;
  wire [1:0] \$195 ;
  wire [1:0] \$196 ;
  wire [2:0] \$197 ;
  wire [1:0] \$198 ;
  wire [2:0] \$199 ;
  wire \$2 ;
  wire \$20 ;
  wire [3:0] \$200 ;
  wire [1:0] \$201 ;
  wire [1:0] \$202 ;
  wire [2:0] \$203 ;
  wire [1:0] \$204 ;
  wire [2:0] \$205 ;
  wire [3:0] \$206 ;
  wire [1:0] \$207 ;
  wire [1:0] \$208 ;
  wire [2:0] \$209 ;
  wire \$21 ;
  wire [1:0] \$210 ;
  wire [2:0] \$211 ;
  wire [3:0] \$212 ;
  wire [1:0] \$213 ;
  wire [1:0] \$214 ;
  wire [2:0] \$215 ;
  wire [1:0] \$216 ;
  wire [2:0] \$217 ;
  wire [3:0] \$218 ;
  wire [1:0] \$219 ;
  wire \$22 ;
  wire [1:0] \$220 ;
  wire [2:0] \$221 ;
  wire [1:0] \$222 ;
  wire [2:0] \$223 ;
  wire [3:0] \$224 ;
  wire [6:0] \$225 ;
  reg [47:0] \$226 ;
  wire [6:0] \$227 ;
  wire [6:0] \$228 ;
  wire [6:0] \$229 ;
  wire \$23 ;
  wire [6:0] \$230 ;
  wire [6:0] \$231 ;
  wire [6:0] \$232 ;
  wire [6:0] \$233 ;
  wire [6:0] \$234 ;
  wire [6:0] \$235 ;
  wire [6:0] \$236 ;
  wire [6:0] \$237 ;
  wire [6:0] \$238 ;
  wire [6:0] \$239 ;
  wire [2:0] \$24 ;
  wire [6:0] \$240 ;
  wire [6:0] \$241 ;
  wire \$25 ;
  wire \$26 ;
  wire \$27 ;
  wire \$28 ;
  wire \$29 ;
  wire \$3 ;
  wire \$30 ;
  wire \$31 ;
  wire [2:0] \$32 ;
  wire \$33 ;
  wire \$34 ;
  wire \$35 ;
  wire \$36 ;
  wire \$37 ;
  wire \$38 ;
  wire \$39 ;
  wire \$4 ;
  wire [2:0] \$40 ;
  wire \$41 ;
  wire \$42 ;
  wire \$43 ;
  wire \$44 ;
  wire \$45 ;
  wire \$46 ;
  wire \$47 ;
  wire [2:0] \$48 ;
  wire \$49 ;
  wire \$5 ;
  wire \$50 ;
  wire \$51 ;
  wire \$52 ;
  wire \$53 ;
  wire \$54 ;
  wire \$55 ;
  wire [2:0] \$56 ;
  wire \$57 ;
  wire \$58 ;
  wire \$59 ;
  wire \$6 ;
  wire \$60 ;
  wire \$61 ;
  wire \$62 ;
  wire \$63 ;
  wire [2:0] \$64 ;
  wire \$65 ;
  wire \$66 ;
  wire \$67 ;
  wire \$68 ;
  wire \$69 ;
  wire \$7 ;
  wire \$70 ;
  wire \$71 ;
  wire [2:0] \$72 ;
  wire \$73 ;
  wire \$74 ;
  wire \$75 ;
  wire \$76 ;
  wire \$77 ;
  wire \$78 ;
  wire \$79 ;
  wire [2:0] \$8 ;
  wire [2:0] \$80 ;
  wire \$81 ;
  wire \$82 ;
  wire \$83 ;
  wire \$84 ;
  wire \$85 ;
  wire \$86 ;
  wire \$87 ;
  wire [2:0] \$88 ;
  wire \$89 ;
  wire \$9 ;
  wire \$90 ;
  wire \$91 ;
  wire \$92 ;
  wire \$93 ;
  wire \$94 ;
  wire \$95 ;
  wire [2:0] \$96 ;
  wire \$97 ;
  wire \$98 ;
  wire \$99 ;
  input [303:0] accumulators;
  wire [303:0] accumulators;
  wire [75:0] \accumulators[0] ;
  wire [18:0] \accumulators[0][0] ;
  wire [18:0] \accumulators[0][1] ;
  wire [18:0] \accumulators[0][2] ;
  wire [18:0] \accumulators[0][3] ;
  wire [75:0] \accumulators[1] ;
  wire [18:0] \accumulators[1][0] ;
  wire [18:0] \accumulators[1][1] ;
  wire [18:0] \accumulators[1][2] ;
  wire [18:0] \accumulators[1][3] ;
  wire [75:0] \accumulators[2] ;
  wire [18:0] \accumulators[2][0] ;
  wire [18:0] \accumulators[2][1] ;
  wire [18:0] \accumulators[2][2] ;
  wire [18:0] \accumulators[2][3] ;
  wire [75:0] \accumulators[3] ;
  wire [18:0] \accumulators[3][0] ;
  wire [18:0] \accumulators[3][1] ;
  wire [18:0] \accumulators[3][2] ;
  wire [18:0] \accumulators[3][3] ;
  input clk;
  wire clk;
  output [47:0] codes;
  reg [47:0] codes = 48'h000000000000;
  reg invert_0_0 = 1'h0;
  reg invert_0_1 = 1'h0;
  reg invert_0_2 = 1'h0;
  reg invert_0_3 = 1'h0;
  reg invert_1_0 = 1'h0;
  reg invert_1_1 = 1'h0;
  reg invert_1_2 = 1'h0;
  reg invert_1_3 = 1'h0;
  reg invert_2_0 = 1'h0;
  reg invert_2_1 = 1'h0;
  reg invert_2_2 = 1'h0;
  reg invert_2_3 = 1'h0;
  reg invert_3_0 = 1'h0;
  reg invert_3_1 = 1'h0;
  reg invert_3_2 = 1'h0;
  reg invert_3_3 = 1'h0;
  wire [2:0] number_0_0;
  wire [2:0] number_0_1;
  wire [2:0] number_0_2;
  wire [2:0] number_0_3;
  wire [2:0] number_1_0;
  wire [2:0] number_1_1;
  wire [2:0] number_1_2;
  wire [2:0] number_1_3;
  wire [2:0] number_2_0;
  wire [2:0] number_2_1;
  wire [2:0] number_2_2;
  wire [2:0] number_2_3;
  wire [2:0] number_3_0;
  wire [2:0] number_3_1;
  wire [2:0] number_3_2;
  wire [2:0] number_3_3;
  input [535:0] parameters;
  wire [535:0] parameters;
  reg [6:0] reached_0_0 = 7'h00;
  reg [6:0] reached_0_1 = 7'h00;
  reg [6:0] reached_0_2 = 7'h00;
  reg [6:0] reached_0_3 = 7'h00;
  reg [6:0] reached_1_0 = 7'h00;
  reg [6:0] reached_1_1 = 7'h00;
  reg [6:0] reached_1_2 = 7'h00;
  reg [6:0] reached_1_3 = 7'h00;
  reg [6:0] reached_2_0 = 7'h00;
  reg [6:0] reached_2_1 = 7'h00;
  reg [6:0] reached_2_2 = 7'h00;
  reg [6:0] reached_2_3 = 7'h00;
  reg [6:0] reached_3_0 = 7'h00;
  reg [6:0] reached_3_1 = 7'h00;
  reg [6:0] reached_3_2 = 7'h00;
  reg [6:0] reached_3_3 = 7'h00;
  input rst;
  wire rst;
  input soft_reset;
  wire soft_reset;
  assign \$1  = $signed(accumulators[18:0]) >= $signed(parameters[18:0]);
  assign \$2  = $signed(accumulators[18:0]) >= $signed(parameters[37:19]);
  assign \$3  = $signed(accumulators[18:0]) >= $signed(parameters[56:38]);
  assign \$4  = $signed(accumulators[18:0]) >= $signed(parameters[75:57]);
  assign \$5  = $signed(accumulators[18:0]) >= $signed(parameters[94:76]);
  assign \$6  = $signed(accumulators[18:0]) >= $signed(parameters[113:95]);
  assign \$7  = $signed(accumulators[18:0]) >= $signed(parameters[132:114]);
  assign \$8  = \$134 [2:0] ^ { invert_0_0, invert_0_0, invert_0_0 };
  assign \$9  = $signed(accumulators[37:19]) >= $signed(parameters[18:0]);
  assign \$10  = $signed(accumulators[37:19]) >= $signed(parameters[37:19]);
  assign \$11  = $signed(accumulators[37:19]) >= $signed(parameters[56:38]);
  assign \$12  = $signed(accumulators[37:19]) >= $signed(parameters[75:57]);
  assign \$13  = $signed(accumulators[37:19]) >= $signed(parameters[94:76]);
  assign \$14  = $signed(accumulators[37:19]) >= $signed(parameters[113:95]);
  assign \$15  = $signed(accumulators[37:19]) >= $signed(parameters[132:114]);
  assign \$16  = \$140 [2:0] ^ { invert_0_1, invert_0_1, invert_0_1 };
  assign \$17  = $signed(accumulators[56:38]) >= $signed(parameters[18:0]);
  assign \$18  = $signed(accumulators[56:38]) >= $signed(parameters[37:19]);
  assign \$19  = $signed(accumulators[56:38]) >= $signed(parameters[56:38]);
  assign \$20  = $signed(accumulators[56:38]) >= $signed(parameters[75:57]);
  assign \$21  = $signed(accumulators[56:38]) >= $signed(parameters[94:76]);
  assign \$22  = $signed(accumulators[56:38]) >= $signed(parameters[113:95]);
  assign \$23  = $signed(accumulators[56:38]) >= $signed(parameters[132:114]);
  assign \$24  = \$146 [2:0] ^ { invert_0_2, invert_0_2, invert_0_2 };
  assign \$25  = $signed(accumulators[75:57]) >= $signed(parameters[18:0]);
  assign \$26  = $signed(accumulators[75:57]) >= $signed(parameters[37:19]);
  assign \$27  = $signed(accumulators[75:57]) >= $signed(parameters[56:38]);
  assign \$28  = $signed(accumulators[75:57]) >= $signed(parameters[75:57]);
  assign \$29  = $signed(accumulators[75:57]) >= $signed(parameters[94:76]);
  assign \$30  = $signed(accumulators[75:57]) >= $signed(parameters[113:95]);
  assign \$31  = $signed(accumulators[75:57]) >= $signed(parameters[132:114]);
  assign \$32  = \$152 [2:0] ^ { invert_0_3, invert_0_3, invert_0_3 };
  assign \$33  = $signed(accumulators[94:76]) >= $signed(parameters[152:134]);
  assign \$34  = $signed(accumulators[94:76]) >= $signed(parameters[171:153]);
  assign \$35  = $signed(accumulators[94:76]) >= $signed(parameters[190:172]);
  assign \$36  = $signed(accumulators[94:76]) >= $signed(parameters[209:191]);
  assign \$37  = $signed(accumulators[94:76]) >= $signed(parameters[228:210]);
  assign \$38  = $signed(accumulators[94:76]) >= $signed(parameters[247:229]);
  assign \$39  = $signed(accumulators[94:76]) >= $signed(parameters[266:248]);
  assign \$40  = \$158 [2:0] ^ { invert_1_0, invert_1_0, invert_1_0 };
  assign \$41  = $signed(accumulators[113:95]) >= $signed(parameters[152:134]);
  assign \$42  = $signed(accumulators[113:95]) >= $signed(parameters[171:153]);
  assign \$43  = $signed(accumulators[113:95]) >= $signed(parameters[190:172]);
  assign \$44  = $signed(accumulators[113:95]) >= $signed(parameters[209:191]);
  assign \$45  = $signed(accumulators[113:95]) >= $signed(parameters[228:210]);
  assign \$46  = $signed(accumulators[113:95]) >= $signed(parameters[247:229]);
  assign \$47  = $signed(accumulators[113:95]) >= $signed(parameters[266:248]);
  assign \$48  = \$164 [2:0] ^ { invert_1_1, invert_1_1, invert_1_1 };
  assign \$49  = $signed(accumulators[132:114]) >= $signed(parameters[152:134]);
  assign \$50  = $signed(accumulators[132:114]) >= $signed(parameters[171:153]);
  assign \$51  = $signed(accumulators[132:114]) >= $signed(parameters[190:172]);
  assign \$52  = $signed(accumulators[132:114]) >= $signed(parameters[209:191]);
  assign \$53  = $signed(accumulators[132:114]) >= $signed(parameters[228:210]);
  assign \$54  = $signed(accumulators[132:114]) >= $signed(parameters[247:229]);
  assign \$55  = $signed(accumulators[132:114]) >= $signed(parameters[266:248]);
  assign \$56  = \$170 [2:0] ^ { invert_1_2, invert_1_2, invert_1_2 };
  assign \$57  = $signed(accumulators[151:133]) >= $signed(parameters[152:134]);
  assign \$58  = $signed(accumulators[151:133]) >= $signed(parameters[171:153]);
  assign \$59  = $signed(accumulators[151:133]) >= $signed(parameters[190:172]);
  assign \$60  = $signed(accumulators[151:133]) >= $signed(parameters[209:191]);
  assign \$61  = $signed(accumulators[151:133]) >= $signed(parameters[228:210]);
  assign \$62  = $signed(accumulators[151:133]) >= $signed(parameters[247:229]);
  assign \$63  = $signed(accumulators[151:133]) >= $signed(parameters[266:248]);
  assign \$64  = \$176 [2:0] ^ { invert_1_3, invert_1_3, invert_1_3 };
  assign \$65  = $signed(accumulators[170:152]) >= $signed(parameters[286:268]);
  assign \$66  = $signed(accumulators[170:152]) >= $signed(parameters[305:287]);
  assign \$67  = $signed(accumulators[170:152]) >= $signed(parameters[324:306]);
  assign \$68  = $signed(accumulators[170:152]) >= $signed(parameters[343:325]);
  assign \$69  = $signed(accumulators[170:152]) >= $signed(parameters[362:344]);
  assign \$70  = $signed(accumulators[170:152]) >= $signed(parameters[381:363]);
  assign \$71  = $signed(accumulators[170:152]) >= $signed(parameters[400:382]);
  assign \$72  = \$182 [2:0] ^ { invert_2_0, invert_2_0, invert_2_0 };
  assign \$73  = $signed(accumulators[189:171]) >= $signed(parameters[286:268]);
  assign \$74  = $signed(accumulators[189:171]) >= $signed(parameters[305:287]);
  assign \$75  = $signed(accumulators[189:171]) >= $signed(parameters[324:306]);
  assign \$76  = $signed(accumulators[189:171]) >= $signed(parameters[343:325]);
  assign \$77  = $signed(accumulators[189:171]) >= $signed(parameters[362:344]);
  assign \$78  = $signed(accumulators[189:171]) >= $signed(parameters[381:363]);
  assign \$79  = $signed(accumulators[189:171]) >= $signed(parameters[400:382]);
  assign \$80  = \$188 [2:0] ^ { invert_2_1, invert_2_1, invert_2_1 };
  assign \$81  = $signed(accumulators[208:190]) >= $signed(parameters[286:268]);
  assign \$82  = $signed(accumulators[208:190]) >= $signed(parameters[305:287]);
  assign \$83  = $signed(accumulators[208:190]) >= $signed(parameters[324:306]);
  assign \$84  = $signed(accumulators[208:190]) >= $signed(parameters[343:325]);
  assign \$85  = $signed(accumulators[208:190]) >= $signed(parameters[362:344]);
  assign \$86  = $signed(accumulators[208:190]) >= $signed(parameters[381:363]);
  assign \$87  = $signed(accumulators[208:190]) >= $signed(parameters[400:382]);
  assign \$88  = \$194 [2:0] ^ { invert_2_2, invert_2_2, invert_2_2 };
  assign \$89  = $signed(accumulators[227:209]) >= $signed(parameters[286:268]);
  assign \$90  = $signed(accumulators[227:209]) >= $signed(parameters[305:287]);
  assign \$91  = $signed(accumulators[227:209]) >= $signed(parameters[324:306]);
  assign \$92  = $signed(accumulators[227:209]) >= $signed(parameters[343:325]);
  assign \$93  = $signed(accumulators[227:209]) >= $signed(parameters[362:344]);
  assign \$94  = $signed(accumulators[227:209]) >= $signed(parameters[381:363]);
  assign \$95  = $signed(accumulators[227:209]) >= $signed(parameters[400:382]);
  assign \$96  = \$200 [2:0] ^ { invert_2_3, invert_2_3, invert_2_3 };
  assign \$97  = $signed(accumulators[246:228]) >= $signed(parameters[420:402]);
  assign \$98  = $signed(accumulators[246:228]) >= $signed(parameters[439:421]);
  assign \$99  = $signed(accumulators[246:228]) >= $signed(parameters[458:440]);
  assign \$100  = $signed(accumulators[246:228]) >= $signed(parameters[477:459]);
  assign \$101  = $signed(accumulators[246:228]) >= $signed(parameters[496:478]);
  assign \$102  = $signed(accumulators[246:228]) >= $signed(parameters[515:497]);
  assign \$103  = $signed(accumulators[246:228]) >= $signed(parameters[534:516]);
  assign \$104  = \$206 [2:0] ^ { invert_3_0, invert_3_0, invert_3_0 };
  assign \$105  = $signed(accumulators[265:247]) >= $signed(parameters[420:402]);
  assign \$106  = $signed(accumulators[265:247]) >= $signed(parameters[439:421]);
  assign \$107  = $signed(accumulators[265:247]) >= $signed(parameters[458:440]);
  assign \$108  = $signed(accumulators[265:247]) >= $signed(parameters[477:459]);
  assign \$109  = $signed(accumulators[265:247]) >= $signed(parameters[496:478]);
  assign \$110  = $signed(accumulators[265:247]) >= $signed(parameters[515:497]);
  assign \$111  = $signed(accumulators[265:247]) >= $signed(parameters[534:516]);
  assign \$112  = \$212 [2:0] ^ { invert_3_1, invert_3_1, invert_3_1 };
  assign \$113  = $signed(accumulators[284:266]) >= $signed(parameters[420:402]);
  assign \$114  = $signed(accumulators[284:266]) >= $signed(parameters[439:421]);
  assign \$115  = $signed(accumulators[284:266]) >= $signed(parameters[458:440]);
  assign \$116  = $signed(accumulators[284:266]) >= $signed(parameters[477:459]);
  assign \$117  = $signed(accumulators[284:266]) >= $signed(parameters[496:478]);
  assign \$118  = $signed(accumulators[284:266]) >= $signed(parameters[515:497]);
  assign \$119  = $signed(accumulators[284:266]) >= $signed(parameters[534:516]);
  assign \$120  = \$218 [2:0] ^ { invert_3_2, invert_3_2, invert_3_2 };
  assign \$121  = $signed(accumulators[303:285]) >= $signed(parameters[420:402]);
  assign \$122  = $signed(accumulators[303:285]) >= $signed(parameters[439:421]);
  assign \$123  = $signed(accumulators[303:285]) >= $signed(parameters[458:440]);
  assign \$124  = $signed(accumulators[303:285]) >= $signed(parameters[477:459]);
  assign \$125  = $signed(accumulators[303:285]) >= $signed(parameters[496:478]);
  assign \$126  = $signed(accumulators[303:285]) >= $signed(parameters[515:497]);
  assign \$127  = $signed(accumulators[303:285]) >= $signed(parameters[534:516]);
  assign \$128  = \$224 [2:0] ^ { invert_3_3, invert_3_3, invert_3_3 };
  assign \$129  = reached_0_0[0] + reached_0_0[1];
  assign \$130  = reached_0_0[2] + reached_0_0[3];
  assign \$131  = \$129  + \$130 ;
  assign \$132  = reached_0_0[4] + reached_0_0[5];
  assign \$133  = \$132  + reached_0_0[6];
  assign \$134  = \$131  + \$133 ;
  assign \$135  = reached_0_1[0] + reached_0_1[1];
  assign \$136  = reached_0_1[2] + reached_0_1[3];
  assign \$137  = \$135  + \$136 ;
  assign \$138  = reached_0_1[4] + reached_0_1[5];
  assign \$139  = \$138  + reached_0_1[6];
  assign \$140  = \$137  + \$139 ;
  assign \$141  = reached_0_2[0] + reached_0_2[1];
  assign \$142  = reached_0_2[2] + reached_0_2[3];
  assign \$143  = \$141  + \$142 ;
  assign \$144  = reached_0_2[4] + reached_0_2[5];
  assign \$145  = \$144  + reached_0_2[6];
  assign \$146  = \$143  + \$145 ;
  assign \$147  = reached_0_3[0] + reached_0_3[1];
  assign \$148  = reached_0_3[2] + reached_0_3[3];
  assign \$149  = \$147  + \$148 ;
  assign \$150  = reached_0_3[4] + reached_0_3[5];
  assign \$151  = \$150  + reached_0_3[6];
  assign \$152  = \$149  + \$151 ;
  assign \$153  = reached_1_0[0] + reached_1_0[1];
  assign \$154  = reached_1_0[2] + reached_1_0[3];
  assign \$155  = \$153  + \$154 ;
  assign \$156  = reached_1_0[4] + reached_1_0[5];
  assign \$157  = \$156  + reached_1_0[6];
  assign \$158  = \$155  + \$157 ;
  assign \$159  = reached_1_1[0] + reached_1_1[1];
  assign \$160  = reached_1_1[2] + reached_1_1[3];
  assign \$161  = \$159  + \$160 ;
  assign \$162  = reached_1_1[4] + reached_1_1[5];
  assign \$163  = \$162  + reached_1_1[6];
  assign \$164  = \$161  + \$163 ;
  assign \$165  = reached_1_2[0] + reached_1_2[1];
  assign \$166  = reached_1_2[2] + reached_1_2[3];
  assign \$167  = \$165  + \$166 ;
  assign \$168  = reached_1_2[4] + reached_1_2[5];
  assign \$169  = \$168  + reached_1_2[6];
  assign \$170  = \$167  + \$169 ;
  assign \$171  = reached_1_3[0] + reached_1_3[1];
  assign \$172  = reached_1_3[2] + reached_1_3[3];
  assign \$173  = \$171  + \$172 ;
  assign \$174  = reached_1_3[4] + reached_1_3[5];
  assign \$175  = \$174  + reached_1_3[6];
  assign \$176  = \$173  + \$175 ;
  assign \$177  = reached_2_0[0] + reached_2_0[1];
  assign \$178  = reached_2_0[2] + reached_2_0[3];
  assign \$179  = \$177  + \$178 ;
  assign \$180  = reached_2_0[4] + reached_2_0[5];
  assign \$181  = \$180  + reached_2_0[6];
  assign \$182  = \$179  + \$181 ;
  assign \$183  = reached_2_1[0] + reached_2_1[1];
  assign \$184  = reached_2_1[2] + reached_2_1[3];
  assign \$185  = \$183  + \$184 ;
  assign \$186  = reached_2_1[4] + reached_2_1[5];
  assign \$187  = \$186  + reached_2_1[6];
  assign \$188  = \$185  + \$187 ;
  assign \$189  = reached_2_2[0] + reached_2_2[1];
  assign \$190  = reached_2_2[2] + reached_2_2[3];
  assign \$191  = \$189  + \$190 ;
  assign \$192  = reached_2_2[4] + reached_2_2[5];
  assign \$193  = \$192  + reached_2_2[6];
  assign \$194  = \$191  + \$193 ;
  assign \$195  = reached_2_3[0] + reached_2_3[1];
  assign \$196  = reached_2_3[2] + reached_2_3[3];
  assign \$197  = \$195  + \$196 ;
  assign \$198  = reached_2_3[4] + reached_2_3[5];
  assign \$199  = \$198  + reached_2_3[6];
  assign \$200  = \$197  + \$199 ;
  assign \$201  = reached_3_0[0] + reached_3_0[1];
  assign \$202  = reached_3_0[2] + reached_3_0[3];
  assign \$203  = \$201  + \$202 ;
  assign \$204  = reached_3_0[4] + reached_3_0[5];
  assign \$205  = \$204  + reached_3_0[6];
  assign \$206  = \$203  + \$205 ;
  assign \$207  = reached_3_1[0] + reached_3_1[1];
  assign \$208  = reached_3_1[2] + reached_3_1[3];
  assign \$209  = \$207  + \$208 ;
  assign \$210  = reached_3_1[4] + reached_3_1[5];
  assign \$211  = \$210  + reached_3_1[6];
  assign \$212  = \$209  + \$211 ;
  assign \$213  = reached_3_2[0] + reached_3_2[1];
  assign \$214  = reached_3_2[2] + reached_3_2[3];
  assign \$215  = \$213  + \$214 ;
  assign \$216  = reached_3_2[4] + reached_3_2[5];
  assign \$217  = \$216  + reached_3_2[6];
  assign \$218  = \$215  + \$217 ;
  assign \$219  = reached_3_3[0] + reached_3_3[1];
  assign \$220  = reached_3_3[2] + reached_3_3[3];
  assign \$221  = \$219  + \$220 ;
  assign \$222  = reached_3_3[4] + reached_3_3[5];
  assign \$223  = \$222  + reached_3_3[6];
  assign \$224  = \$221  + \$223 ;
  always @(posedge clk)
    invert_0_0 <= parameters[133];
  always @(posedge clk)
    reached_0_0 <= \$225 ;
  always @(posedge clk)
    codes <= \$226 ;
  always @(posedge clk)
    invert_0_1 <= parameters[133];
  always @(posedge clk)
    reached_0_1 <= \$227 ;
  always @(posedge clk)
    invert_0_2 <= parameters[133];
  always @(posedge clk)
    reached_0_2 <= \$228 ;
  always @(posedge clk)
    invert_0_3 <= parameters[133];
  always @(posedge clk)
    reached_0_3 <= \$229 ;
  always @(posedge clk)
    invert_1_0 <= parameters[267];
  always @(posedge clk)
    reached_1_0 <= \$230 ;
  always @(posedge clk)
    invert_1_1 <= parameters[267];
  always @(posedge clk)
    reached_1_1 <= \$231 ;
  always @(posedge clk)
    invert_1_2 <= parameters[267];
  always @(posedge clk)
    reached_1_2 <= \$232 ;
  always @(posedge clk)
    invert_1_3 <= parameters[267];
  always @(posedge clk)
    reached_1_3 <= \$233 ;
  always @(posedge clk)
    invert_2_0 <= parameters[401];
  always @(posedge clk)
    reached_2_0 <= \$234 ;
  always @(posedge clk)
    invert_2_1 <= parameters[401];
  always @(posedge clk)
    reached_2_1 <= \$235 ;
  always @(posedge clk)
    invert_2_2 <= parameters[401];
  always @(posedge clk)
    reached_2_2 <= \$236 ;
  always @(posedge clk)
    invert_2_3 <= parameters[401];
  always @(posedge clk)
    reached_2_3 <= \$237 ;
  always @(posedge clk)
    invert_3_0 <= parameters[535];
  always @(posedge clk)
    reached_3_0 <= \$238 ;
  always @(posedge clk)
    invert_3_1 <= parameters[535];
  always @(posedge clk)
    reached_3_1 <= \$239 ;
  always @(posedge clk)
    invert_3_2 <= parameters[535];
  always @(posedge clk)
    reached_3_2 <= \$240 ;
  always @(posedge clk)
    invert_3_3 <= parameters[535];
  always @(posedge clk)
    reached_3_3 <= \$241 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$4 ) begin end
    \$226 [2:0] = \$8 ;
    \$226 [14:12] = \$16 ;
    \$226 [26:24] = \$24 ;
    \$226 [38:36] = \$32 ;
    \$226 [5:3] = \$40 ;
    \$226 [17:15] = \$48 ;
    \$226 [29:27] = \$56 ;
    \$226 [41:39] = \$64 ;
    \$226 [8:6] = \$72 ;
    \$226 [20:18] = \$80 ;
    \$226 [32:30] = \$88 ;
    \$226 [44:42] = \$96 ;
    \$226 [11:9] = \$104 ;
    \$226 [23:21] = \$112 ;
    \$226 [35:33] = \$120 ;
    \$226 [47:45] = \$128 ;
    if (soft_reset) begin
      \$226  = 48'h000000000000;
    end
    if (rst) begin
      \$226  = 48'h000000000000;
    end
  end
  assign number_0_0 = \$134 [2:0];
  assign number_0_1 = \$140 [2:0];
  assign number_0_2 = \$146 [2:0];
  assign number_0_3 = \$152 [2:0];
  assign number_1_0 = \$158 [2:0];
  assign number_1_1 = \$164 [2:0];
  assign number_1_2 = \$170 [2:0];
  assign number_1_3 = \$176 [2:0];
  assign number_2_0 = \$182 [2:0];
  assign number_2_1 = \$188 [2:0];
  assign number_2_2 = \$194 [2:0];
  assign number_2_3 = \$200 [2:0];
  assign number_3_0 = \$206 [2:0];
  assign number_3_1 = \$212 [2:0];
  assign number_3_2 = \$218 [2:0];
  assign number_3_3 = \$224 [2:0];
  assign \accumulators[0]  = accumulators[75:0];
  assign \accumulators[0][0]  = accumulators[18:0];
  assign \accumulators[0][1]  = accumulators[37:19];
  assign \accumulators[0][2]  = accumulators[56:38];
  assign \accumulators[0][3]  = accumulators[75:57];
  assign \accumulators[1]  = accumulators[151:76];
  assign \accumulators[1][0]  = accumulators[94:76];
  assign \accumulators[1][1]  = accumulators[113:95];
  assign \accumulators[1][2]  = accumulators[132:114];
  assign \accumulators[1][3]  = accumulators[151:133];
  assign \accumulators[2]  = accumulators[227:152];
  assign \accumulators[2][0]  = accumulators[170:152];
  assign \accumulators[2][1]  = accumulators[189:171];
  assign \accumulators[2][2]  = accumulators[208:190];
  assign \accumulators[2][3]  = accumulators[227:209];
  assign \accumulators[3]  = accumulators[303:228];
  assign \accumulators[3][0]  = accumulators[246:228];
  assign \accumulators[3][1]  = accumulators[265:247];
  assign \accumulators[3][2]  = accumulators[284:266];
  assign \accumulators[3][3]  = accumulators[303:285];
  assign \$241 [6] = \$127 ;
  assign \$241 [5] = \$126 ;
  assign \$241 [4] = \$125 ;
  assign \$241 [3] = \$124 ;
  assign \$241 [2] = \$123 ;
  assign \$241 [1] = \$122 ;
  assign \$241 [0] = \$121 ;
  assign \$240 [6] = \$119 ;
  assign \$240 [5] = \$118 ;
  assign \$240 [4] = \$117 ;
  assign \$240 [3] = \$116 ;
  assign \$240 [2] = \$115 ;
  assign \$240 [1] = \$114 ;
  assign \$240 [0] = \$113 ;
  assign \$239 [6] = \$111 ;
  assign \$239 [5] = \$110 ;
  assign \$239 [4] = \$109 ;
  assign \$239 [3] = \$108 ;
  assign \$239 [2] = \$107 ;
  assign \$239 [1] = \$106 ;
  assign \$239 [0] = \$105 ;
  assign \$238 [6] = \$103 ;
  assign \$238 [5] = \$102 ;
  assign \$238 [4] = \$101 ;
  assign \$238 [3] = \$100 ;
  assign \$238 [2] = \$99 ;
  assign \$238 [1] = \$98 ;
  assign \$238 [0] = \$97 ;
  assign \$237 [6] = \$95 ;
  assign \$237 [5] = \$94 ;
  assign \$237 [4] = \$93 ;
  assign \$237 [3] = \$92 ;
  assign \$237 [2] = \$91 ;
  assign \$237 [1] = \$90 ;
  assign \$237 [0] = \$89 ;
  assign \$236 [6] = \$87 ;
  assign \$236 [5] = \$86 ;
  assign \$236 [4] = \$85 ;
  assign \$236 [3] = \$84 ;
  assign \$236 [2] = \$83 ;
  assign \$236 [1] = \$82 ;
  assign \$236 [0] = \$81 ;
  assign \$235 [6] = \$79 ;
  assign \$235 [5] = \$78 ;
  assign \$235 [4] = \$77 ;
  assign \$235 [3] = \$76 ;
  assign \$235 [2] = \$75 ;
  assign \$235 [1] = \$74 ;
  assign \$235 [0] = \$73 ;
  assign \$234 [6] = \$71 ;
  assign \$234 [5] = \$70 ;
  assign \$234 [4] = \$69 ;
  assign \$234 [3] = \$68 ;
  assign \$234 [2] = \$67 ;
  assign \$234 [1] = \$66 ;
  assign \$234 [0] = \$65 ;
  assign \$233 [6] = \$63 ;
  assign \$233 [5] = \$62 ;
  assign \$233 [4] = \$61 ;
  assign \$233 [3] = \$60 ;
  assign \$233 [2] = \$59 ;
  assign \$233 [1] = \$58 ;
  assign \$233 [0] = \$57 ;
  assign \$232 [6] = \$55 ;
  assign \$232 [5] = \$54 ;
  assign \$232 [4] = \$53 ;
  assign \$232 [3] = \$52 ;
  assign \$232 [2] = \$51 ;
  assign \$232 [1] = \$50 ;
  assign \$232 [0] = \$49 ;
  assign \$231 [6] = \$47 ;
  assign \$231 [5] = \$46 ;
  assign \$231 [4] = \$45 ;
  assign \$231 [3] = \$44 ;
  assign \$231 [2] = \$43 ;
  assign \$231 [1] = \$42 ;
  assign \$231 [0] = \$41 ;
  assign \$230 [6] = \$39 ;
  assign \$230 [5] = \$38 ;
  assign \$230 [4] = \$37 ;
  assign \$230 [3] = \$36 ;
  assign \$230 [2] = \$35 ;
  assign \$230 [1] = \$34 ;
  assign \$230 [0] = \$33 ;
  assign \$229 [6] = \$31 ;
  assign \$229 [5] = \$30 ;
  assign \$229 [4] = \$29 ;
  assign \$229 [3] = \$28 ;
  assign \$229 [2] = \$27 ;
  assign \$229 [1] = \$26 ;
  assign \$229 [0] = \$25 ;
  assign \$228 [6] = \$23 ;
  assign \$228 [5] = \$22 ;
  assign \$228 [4] = \$21 ;
  assign \$228 [3] = \$20 ;
  assign \$228 [2] = \$19 ;
  assign \$228 [1] = \$18 ;
  assign \$228 [0] = \$17 ;
  assign \$227 [6] = \$15 ;
  assign \$227 [5] = \$14 ;
  assign \$227 [4] = \$13 ;
  assign \$227 [3] = \$12 ;
  assign \$227 [2] = \$11 ;
  assign \$227 [1] = \$10 ;
  assign \$227 [0] = \$9 ;
  assign \$225 [6] = \$7 ;
  assign \$225 [5] = \$6 ;
  assign \$225 [4] = \$5 ;
  assign \$225 [3] = \$4 ;
  assign \$225 [2] = \$3 ;
  assign \$225 [1] = \$2 ;
  assign \$225 [0] = \$1 ;
endmodule

module \macram_top.array.emit (o__ready, rst, o__valid, i__ready, soft_reset, beats_per_pixel, i__payload, i__valid, o__payload, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$5  = 0;
  wire [16:0] \$1 ;
  wire [7:0] \$10 ;
  wire [7:0] \$11 ;
  wire \$12 ;
  wire \$13 ;
  wire \$14 ;
  wire [111:0] \$15 ;
  wire [111:0] \$16 ;
  wire [111:0] \$17 ;
  wire [47:0] \$18 ;
  wire [174:0] \$19 ;
  wire \$2 ;
  wire [174:0] \$20 ;
  wire [5:0] \$21 ;
  wire [7:0] \$22 ;
  wire [16:0] \$23 ;
  wire [16:0] \$24 ;
  reg [111:0] \$25 ;
  reg [6:0] \$26 ;
  reg \$27 ;
  reg \$28 ;
  reg [15:0] \$29 ;
  wire \$3 ;
  wire \$4 ;
  wire [16:0] \$5 ;
  wire \$6 ;
  wire \$7 ;
  wire [7:0] \$8 ;
  wire [7:0] \$9 ;
  reg \$signal  = 1'h0;
  wire \$signal$10 ;
  wire \$signal$8 ;
  reg [15:0] beats_out = 16'h0000;
  input [15:0] beats_per_pixel;
  wire [15:0] beats_per_pixel;
  reg [111:0] buffer = 112'h0000000000000000000000000000;
  input clk;
  wire clk;
  input [49:0] i__payload;
  wire [49:0] i__payload;
  wire [47:0] \i__payload.data ;
  wire \i__payload.last ;
  wire \i__payload.pixel_last ;
  output i__ready;
  wire i__ready;
  input i__valid;
  wire i__valid;
  reg image_last = 1'h0;
  reg [6:0] level = 7'h00;
  wire [6:0] level_after;
  output [64:0] o__payload;
  wire [64:0] o__payload;
  wire [63:0] \o__payload.data ;
  wire \o__payload.last ;
  input o__ready;
  wire o__ready;
  output o__valid;
  wire o__valid;
  wire put;
  input rst;
  wire rst;
  input soft_reset;
  wire soft_reset;
  assign \$1  = beats_out + 1'h1;
  assign \$2  = \$1  == beats_per_pixel;
  assign \$3  = \$2  & image_last;
  assign \$4  = level >= 7'h40;
  assign o__valid = \$4  | \$signal ;
  assign \$signal$8  = o__valid & o__ready;
  assign \$5  = beats_out + 1'h1;
  assign \$6  = \$5  == beats_per_pixel;
  assign \$signal$10  = \$signal$8  & \$6 ;
  assign \$7  = level >= 7'h40;
  assign \$8  = level - 7'h40;
  assign \$9  = \$7  ? \$8  : 8'h00;
  assign \$10  = \$signal$8  ? \$9  : { 1'h0, level };
  assign \$11  = \$signal$10  ? 8'h00 : \$10 ;
  assign \$12  = ~ \$signal ;
  assign \$13  = \$12  | \$signal$10 ;
  assign \$14  = \$11 [6:0] <= 7'h40;
  assign i__ready = \$13  & \$14 ;
  assign put = i__valid & i__ready;
  assign \$16  = \$signal$8  ? \$15  : buffer;
  assign \$17  = \$signal$10  ? 112'h0000000000000000000000000000 : \$16 ;
  assign \$18  = put ? i__payload[47:0] : 48'h000000000000;
  assign \$19  = \$18  << \$11 [6:0];
  assign \$20  = { 63'h0000000000000000, \$17  } | \$19 ;
  assign \$21  = put ? 6'h30 : 6'h00;
  assign \$22  = \$11 [6:0] + \$21 ;
  assign \$23  = beats_out + 1'h1;
  assign \$24  = \$signal$10  ? 17'h00000 : \$23 ;
  always @(posedge clk)
    buffer <= \$25 ;
  always @(posedge clk)
    level <= \$26 ;
  always @(posedge clk)
    \$signal  <= \$27 ;
  always @(posedge clk)
    image_last <= \$28 ;
  always @(posedge clk)
    beats_out <= \$29 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$5 ) begin end
    \$25  = \$20 [111:0];
    if (soft_reset) begin
      \$25  = 112'h0000000000000000000000000000;
    end
    if (rst) begin
      \$25  = 112'h0000000000000000000000000000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$5 ) begin end
    \$26  = \$22 [6:0];
    if (soft_reset) begin
      \$26  = 7'h00;
    end
    if (rst) begin
      \$26  = 7'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$5 ) begin end
    \$27  = \$signal ;
    if (put) begin
      \$27  = i__payload[48];
    end else if (\$signal$10 ) begin
      \$27  = 1'h0;
    end
    if (soft_reset) begin
      \$27  = 1'h0;
    end
    if (rst) begin
      \$27  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$5 ) begin end
    \$28  = image_last;
    if (put) begin
      \$28  = i__payload[49];
    end
    if (soft_reset) begin
      \$28  = 1'h0;
    end
    if (rst) begin
      \$28  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$5 ) begin end
    \$29  = beats_out;
    if (\$signal$8 ) begin
      \$29  = \$24 [15:0];
    end
    if (soft_reset) begin
      \$29  = 16'h0000;
    end
    if (rst) begin
      \$29  = 16'h0000;
    end
  end
  assign level_after = \$11 [6:0];
  assign \o__payload.data  = o__payload[63:0];
  assign \o__payload.last  = o__payload[64];
  assign \i__payload.data  = i__payload[47:0];
  assign \i__payload.pixel_last  = i__payload[48];
  assign \i__payload.last  = i__payload[49];
  assign o__payload[64] = \$3 ;
  assign o__payload[63:0] = buffer[63:0];
  assign \$15  = { 64'h0000000000000000, buffer[111:64] };
endmodule

module \macram_top.array.frame (i__valid, rst, start, o__valid, i__ready, fault, error, o__ready, i__payload, soft_reset, shape, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$6  = 0;
  wire [16:0] \$1 ;
  wire [16:0] \$10 ;
  wire [16:0] \$11 ;
  reg [15:0] \$12 ;
  reg [15:0] \$13 ;
  reg [15:0] \$14 ;
  reg \$15 ;
  wire [16:0] \$2 ;
  wire \$3 ;
  wire [16:0] \$4 ;
  wire \$5 ;
  wire \$6 ;
  wire [16:0] \$7 ;
  wire [16:0] \$8 ;
  wire [16:0] \$9 ;
  wire \$signal ;
  wire \$signal$11 ;
  reg [15:0] \$signal$12  = 16'h0000;
  wire \$signal$13 ;
  wire \$signal$8 ;
  reg [15:0] \$signal$9  = 16'h0000;
  input clk;
  wire clk;
  (* enum_base_type = "Error" *)
  (* enum_value_000 = "NONE" *)
  (* enum_value_001 = "BAD_SHAPE" *)
  (* enum_value_010 = "BAD_MODE" *)
  (* enum_value_011 = "TLAST_EARLY" *)
  (* enum_value_100 = "TLAST_MISSING" *)
  (* enum_value_101 = "BAD_COMMAND" *)
  output [2:0] error;
  wire [2:0] error;
  output fault;
  wire fault;
  input [64:0] i__payload;
  wire [64:0] i__payload;
  wire [63:0] \i__payload.data ;
  wire \i__payload.last ;
  output i__ready;
  wire i__ready;
  input i__valid;
  wire i__valid;
  reg is_open = 1'h0;
  wire [63:0] o__payload;
  input o__ready;
  wire o__ready;
  output o__valid;
  wire o__valid;
  reg [15:0] row = 16'h0000;
  input rst;
  wire rst;
  input [132:0] shape;
  wire [132:0] shape;
  wire [15:0] \shape.beats_in ;
  wire [15:0] \shape.beats_out ;
  wire [13:0] \shape.blocks ;
  wire [14:0] \shape.groups ;
  wire [15:0] \shape.height ;
  wire [13:0] \shape.ingest_words ;
  wire [11:0] \shape.output_words ;
  wire [1:0] \shape.tail ;
  wire [11:0] \shape.tiles ;
  wire [15:0] \shape.width ;
  input soft_reset;
  wire soft_reset;
  input start;
  wire start;
  assign o__valid = i__valid & is_open;
  assign i__ready = o__ready & is_open;
  assign \$signal  = i__valid & i__ready;
  assign \$1  = \$signal$9  + 1'h1;
  assign \$signal$8  = \$1  == shape[116:101];
  assign \$2  = \$signal$12  + 1'h1;
  assign \$3  = \$2  == shape[31:16];
  assign \$signal$11  = \$signal$8  & \$3 ;
  assign \$4  = row + 1'h1;
  assign \$5  = \$4  == shape[15:0];
  assign \$signal$13  = \$signal$11  & \$5 ;
  assign \$6  = i__payload[64] != \$signal$13 ;
  assign fault = \$signal  & \$6 ;
  assign error = i__payload[64] ? 3'h3 : 3'h4;
  assign \$7  = \$signal$9  + 1'h1;
  assign \$8  = \$signal$8  ? 17'h00000 : \$7 ;
  assign \$9  = \$signal$12  + 1'h1;
  assign \$10  = \$signal$11  ? 17'h00000 : \$9 ;
  assign \$11  = row + 1'h1;
  always @(posedge clk)
    \$signal$9  <= \$12 ;
  always @(posedge clk)
    \$signal$12  <= \$13 ;
  always @(posedge clk)
    row <= \$14 ;
  always @(posedge clk)
    is_open <= \$15 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$6 ) begin end
    \$12  = \$signal$9 ;
    if (\$signal ) begin
      \$12  = \$8 [15:0];
    end
    if (start) begin
      \$12  = 16'h0000;
    end
    if (soft_reset) begin
      \$12  = 16'h0000;
    end
    if (rst) begin
      \$12  = 16'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$6 ) begin end
    \$13  = \$signal$12 ;
    if (\$signal ) begin
      if (\$signal$8 ) begin
        \$13  = \$10 [15:0];
      end
    end
    if (start) begin
      \$13  = 16'h0000;
    end
    if (soft_reset) begin
      \$13  = 16'h0000;
    end
    if (rst) begin
      \$13  = 16'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$6 ) begin end
    \$14  = row;
    if (\$signal ) begin
      if (\$signal$11 ) begin
        \$14  = \$11 [15:0];
      end
    end
    if (start) begin
      \$14  = 16'h0000;
    end
    if (soft_reset) begin
      \$14  = 16'h0000;
    end
    if (rst) begin
      \$14  = 16'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$6 ) begin end
    \$15  = is_open;
    if (\$signal ) begin
      if (\$signal$13 ) begin
        \$15  = 1'h0;
      end
    end
    if (start) begin
      \$15  = 1'h1;
    end
    if (soft_reset) begin
      \$15  = 1'h0;
    end
    if (rst) begin
      \$15  = 1'h0;
    end
  end
  assign o__payload = i__payload[63:0];
  assign \i__payload.data  = i__payload[63:0];
  assign \i__payload.last  = i__payload[64];
  assign \shape.height  = shape[15:0];
  assign \shape.width  = shape[31:16];
  assign \shape.groups  = shape[46:32];
  assign \shape.tail  = shape[48:47];
  assign \shape.blocks  = shape[62:49];
  assign \shape.ingest_words  = shape[76:63];
  assign \shape.tiles  = shape[88:77];
  assign \shape.output_words  = shape[100:89];
  assign \shape.beats_in  = shape[116:101];
  assign \shape.beats_out  = shape[132:117];
endmodule

module \macram_top.array.ingest (rst, i__valid, o__valid, i__ready, o__ready, i__payload, soft_reset, \port$1096$63 , beats_per_pixel, o__payload, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$7  = 0;
  wire \$1 ;
  wire \$10 ;
  wire \$11 ;
  wire [111:0] \$12 ;
  wire [111:0] \$13 ;
  wire [111:0] \$14 ;
  wire [63:0] \$15 ;
  wire [190:0] \$16 ;
  wire [190:0] \$17 ;
  wire [6:0] \$18 ;
  wire [7:0] \$19 ;
  wire \$2 ;
  wire [16:0] \$20 ;
  wire [16:0] \$21 ;
  wire [16:0] \$22 ;
  reg [111:0] \$23 ;
  reg [6:0] \$24 ;
  reg [15:0] \$25 ;
  reg [15:0] \$26 ;
  wire [16:0] \$3 ;
  wire \$4 ;
  wire \$5 ;
  wire [7:0] \$6 ;
  wire [7:0] \$7 ;
  wire [7:0] \$8 ;
  wire [7:0] \$9 ;
  wire [6:0] \$like ;
  reg [15:0] \$signal  = 16'h0000;
  wire \$signal$6 ;
  wire \$signal$8 ;
  wire [15:0] beats_after;
  input [15:0] beats_per_pixel;
  wire [15:0] beats_per_pixel;
  reg [111:0] buffer = 112'h0000000000000000000000000000;
  input clk;
  wire clk;
  input [63:0] i__payload;
  wire [63:0] i__payload;
  output i__ready;
  wire i__ready;
  input i__valid;
  wire i__valid;
  reg [6:0] level = 7'h00;
  output [47:0] o__payload;
  wire [47:0] o__payload;
  input o__ready;
  wire o__ready;
  output o__valid;
  wire o__valid;
  input [13:0] \port$1096$63 ;
  wire [13:0] \port$1096$63 ;
  wire put;
  input rst;
  wire rst;
  input soft_reset;
  wire soft_reset;
  reg [15:0] words_out = 16'h0000;
  wire [15:0] words_per_pixel;
  assign \$1  = level >= 6'h30;
  assign \$2  = \$signal  == beats_per_pixel;
  assign o__valid = \$1  | \$2 ;
  assign \$signal$6  = o__valid & o__ready;
  assign \$3  = words_out + 1'h1;
  assign \$4  = \$3  == \port$1096$63 ;
  assign \$signal$8  = \$signal$6  & \$4 ;
  assign beats_after = \$signal$8  ? 16'h0000 : \$signal ;
  assign \$5  = level >= 6'h30;
  assign \$6  = level - 6'h30;
  assign \$7  = \$5  ? \$6  : 8'h00;
  assign \$8  = \$signal$6  ? \$7  : { 1'h0, level };
  assign \$9  = \$signal$8  ? 8'h00 : \$8 ;
  assign \$10  = beats_after != beats_per_pixel;
  assign \$11  = \$9 [6:0] <= 6'h30;
  assign i__ready = \$10  & \$11 ;
  assign put = i__valid & i__ready;
  assign \$13  = \$signal$6  ? \$12  : buffer;
  assign \$14  = \$signal$8  ? 112'h0000000000000000000000000000 : \$13 ;
  assign \$15  = put ? i__payload : 64'h0000000000000000;
  assign \$16  = \$15  << \$9 [6:0];
  assign \$17  = { 79'h00000000000000000000, \$14  } | \$16 ;
  assign \$18  = put ? 7'h40 : 7'h00;
  assign \$19  = \$9 [6:0] + \$18 ;
  assign \$20  = beats_after + put;
  assign \$21  = words_out + 1'h1;
  assign \$22  = \$signal$8  ? 17'h00000 : \$21 ;
  always @(posedge clk)
    buffer <= \$23 ;
  always @(posedge clk)
    level <= \$24 ;
  always @(posedge clk)
    \$signal  <= \$25 ;
  always @(posedge clk)
    words_out <= \$26 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$7 ) begin end
    \$23  = \$17 [111:0];
    if (soft_reset) begin
      \$23  = 112'h0000000000000000000000000000;
    end
    if (rst) begin
      \$23  = 112'h0000000000000000000000000000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$7 ) begin end
    \$24  = \$19 [6:0];
    if (soft_reset) begin
      \$24  = 7'h00;
    end
    if (rst) begin
      \$24  = 7'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$7 ) begin end
    \$25  = \$20 [15:0];
    if (soft_reset) begin
      \$25  = 16'h0000;
    end
    if (rst) begin
      \$25  = 16'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$7 ) begin end
    \$26  = words_out;
    if (\$signal$6 ) begin
      \$26  = \$22 [15:0];
    end
    if (soft_reset) begin
      \$26  = 16'h0000;
    end
    if (rst) begin
      \$26  = 16'h0000;
    end
  end
  assign words_per_pixel = { 2'h0, \port$1096$63  };
  assign \$like  = \$9 [6:0];
  assign o__payload = buffer[47:0];
  assign \$12  = { 48'h000000000000, buffer[111:48] };
endmodule

module \macram_top.array.lines (rst, start, i__valid, i__ready, retire, soft_reset, shape, i__payload, group_written, image_written, word, read, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$8  = 0;
  wire \$1 ;
  wire [3:0] \$10 ;
  wire [14:0] \$11 ;
  wire [3:0] \$12 ;
  wire [14:0] \$13 ;
  wire [14:0] \$14 ;
  wire [16:0] \$15 ;
  wire [16:0] \$16 ;
  wire [14:0] \$17 ;
  wire [14:0] \$18 ;
  wire [16:0] \$19 ;
  wire \$2 ;
  wire [16:0] \$20 ;
  wire \$21 ;
  wire [2:0] \$22 ;
  wire [3:0] \$23 ;
  wire [23:0] \$24 ;
  wire [23:0] \$25 ;
  wire [23:0] \$26 ;
  wire [23:0] \$27 ;
  reg \$28 ;
  reg [13:0] \$29 ;
  wire [14:0] \$3 ;
  reg [15:0] \$30 ;
  reg [8:0] \$31 ;
  reg [15:0] \$32 ;
  reg \$33 ;
  reg [1:0] \$34 ;
  reg \$35 ;
  reg [3:0] \$36 ;
  reg [95:0] \$37 ;
  wire \$4 ;
  wire [16:0] \$5 ;
  wire \$6 ;
  wire \$7 ;
  wire \$8 ;
  wire [14:0] \$9 ;
  reg \$like  = 1'h0;
  wire \$signal ;
  wire \$signal$10 ;
  wire \$signal$5 ;
  reg [13:0] \$signal$6  = 14'h0000;
  wire \$signal$8 ;
  reg [15:0] \$signal$9  = 16'h0000;
  input clk;
  wire clk;
  reg [8:0] group_base = 9'h000;
  output group_written;
  reg group_written = 1'h0;
  input [47:0] i__payload;
  wire [47:0] i__payload;
  output i__ready;
  wire i__ready;
  input i__valid;
  wire i__valid;
  output image_written;
  reg image_written = 1'h1;
  reg [3:0] mask = 4'h0;
  reg [95:0] picked;
  input [14:0] read;
  wire [14:0] read;
  wire [7:0] \read.address ;
  wire \read.bank ;
  wire [3:0] \read.mask ;
  wire [1:0] \read.slot ;
  wire [9:0] read__addr;
  wire [9:0] \read__addr$22 ;
  wire [95:0] read__data;
  wire [95:0] \read__data$26 ;
  input retire;
  wire retire;
  reg [15:0] row = 16'h0000;
  reg [1:0] rows_free = 2'h0;
  input rst;
  wire rst;
  input [132:0] shape;
  wire [132:0] shape;
  wire [15:0] \shape.beats_in ;
  wire [15:0] \shape.beats_out ;
  wire [13:0] \shape.blocks ;
  wire [14:0] \shape.groups ;
  wire [15:0] \shape.height ;
  wire [13:0] \shape.ingest_words ;
  wire [11:0] \shape.output_words ;
  wire [1:0] \shape.tail ;
  wire [11:0] \shape.tiles ;
  wire [15:0] \shape.width ;
  input soft_reset;
  wire soft_reset;
  input start;
  wire start;
  output [95:0] word;
  reg [95:0] word = 96'h000000000000000000000000;
  wire [9:0] write__addr;
  wire [9:0] \write__addr$19 ;
  wire [95:0] write__data;
  wire [95:0] \write__data$20 ;
  wire [3:0] write__en;
  wire [3:0] \write__en$21 ;
  assign \$1  = | rows_free;
  assign \$2  = ~ image_written;
  assign i__ready = \$1  & \$2 ;
  assign \$signal  = i__valid & i__ready;
  assign \$3  = \$signal$6  + 1'h1;
  assign \$4  = \$3  == shape[76:63];
  assign \$signal$5  = \$signal  & \$4 ;
  assign \$5  = \$signal$9  + 1'h1;
  assign \$6  = \$5  == shape[31:16];
  assign \$signal$8  = \$signal$5  & \$6 ;
  assign \$7  = & \$signal$9 [1:0];
  assign \$8  = \$signal$5  & \$7 ;
  assign \$signal$10  = \$signal$8  | \$8 ;
  assign \$9  = group_base + \$signal$6 ;
  assign \$10  = 1'h1 << \$signal$9 [1:0];
  assign write__en = \$signal  ? \$10  : 4'h0;
  assign \$11  = group_base + \$signal$6 ;
  assign \$12  = 1'h1 << \$signal$9 [1:0];
  assign \write__en$21  = \$signal  ? \$12  : 4'h0;
  assign \$13  = \$signal$6  + 1'h1;
  assign \$14  = \$signal$5  ? 15'h0000 : \$13 ;
  assign \$15  = \$signal$9  + 1'h1;
  assign \$16  = \$signal$8  ? 17'h00000 : \$15 ;
  assign \$17  = group_base + shape[76:63];
  assign \$18  = \$signal$8  ? 15'h0000 : \$17 ;
  assign \$19  = row + 1'h1;
  assign \$20  = row + 1'h1;
  assign \$21  = \$20  == shape[15:0];
  assign \$22  = rows_free - \$signal$8 ;
  assign \$23  = $signed(\$22 ) + $signed({ 1'h0, retire });
  assign \$24  = mask[0] ? picked[23:0] : 24'h000000;
  assign \$25  = mask[1] ? picked[47:24] : 24'h000000;
  assign \$26  = mask[2] ? picked[71:48] : 24'h000000;
  assign \$27  = mask[3] ? picked[95:72] : 24'h000000;
  always @(posedge clk)
    group_written <= \$28 ;
  always @(posedge clk)
    \$signal$6  <= \$29 ;
  always @(posedge clk)
    \$signal$9  <= \$30 ;
  always @(posedge clk)
    group_base <= \$31 ;
  always @(posedge clk)
    row <= \$32 ;
  always @(posedge clk)
    image_written <= \$33 ;
  always @(posedge clk)
    rows_free <= \$34 ;
  always @(posedge clk)
    \$like  <= \$35 ;
  always @(posedge clk)
    mask <= \$36 ;
  always @(posedge clk)
    word <= \$37 ;
  macram_ram #(
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
    .INIT_FILE(),
    .LANES(32'd4),
    .WIDTH(32'd96)
  ) bank0 (
    .clk(clk),
    .read_addr({ read[1:0], read[9:2] }),
    .read_data(read__data),
    .read_en(1'h1),
    .write_addr({ row[1:0], \$9 [7:0] }),
    .write_data({ i__payload[23:0], i__payload[23:0], i__payload[23:0], i__payload[23:0] }),
    .write_en(write__en)
  );
  macram_ram #(
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
    .INIT_FILE(),
    .LANES(32'd4),
    .WIDTH(32'd96)
  ) bank1 (
    .clk(clk),
    .read_addr({ read[1:0], read[9:2] }),
    .read_data(\read__data$26 ),
    .read_en(1'h1),
    .write_addr({ row[1:0], \$11 [7:0] }),
    .write_data({ i__payload[47:24], i__payload[47:24], i__payload[47:24], i__payload[47:24] }),
    .write_en(\write__en$21 )
  );
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    (* full_case = 32'd1 *)
    casez (\$like )
      1'h0:
          picked = read__data;
      1'h1:
          picked = \read__data$26 ;
    endcase
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$28  = \$signal$10 ;
    if (start) begin
      \$28  = 1'h0;
    end
    if (soft_reset) begin
      \$28  = 1'h0;
    end
    if (rst) begin
      \$28  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$29  = \$signal$6 ;
    if (\$signal ) begin
      \$29  = \$14 [13:0];
    end
    if (start) begin
      \$29  = 14'h0000;
    end
    if (soft_reset) begin
      \$29  = 14'h0000;
    end
    if (rst) begin
      \$29  = 14'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$30  = \$signal$9 ;
    if (\$signal$5 ) begin
      \$30  = \$16 [15:0];
    end
    if (start) begin
      \$30  = 16'h0000;
    end
    if (soft_reset) begin
      \$30  = 16'h0000;
    end
    if (rst) begin
      \$30  = 16'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$31  = group_base;
    if (\$signal$10 ) begin
      \$31  = \$18 [8:0];
    end
    if (start) begin
      \$31  = 9'h000;
    end
    if (soft_reset) begin
      \$31  = 9'h000;
    end
    if (rst) begin
      \$31  = 9'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$32  = row;
    if (\$signal$8 ) begin
      \$32  = \$19 [15:0];
    end
    if (start) begin
      \$32  = 16'h0000;
    end
    if (soft_reset) begin
      \$32  = 16'h0000;
    end
    if (rst) begin
      \$32  = 16'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$33  = image_written;
    if (\$signal$8 ) begin
      if (\$21 ) begin
        \$33  = 1'h1;
      end
    end
    if (start) begin
      \$33  = 1'h0;
    end
    if (soft_reset) begin
      \$33  = 1'h1;
    end
    if (rst) begin
      \$33  = 1'h1;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$34  = \$23 [1:0];
    if (start) begin
      \$34  = 2'h3;
    end
    if (soft_reset) begin
      \$34  = 2'h0;
    end
    if (rst) begin
      \$34  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$35  = read[10];
    if (soft_reset) begin
      \$35  = 1'h0;
    end
    if (rst) begin
      \$35  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$36  = read[14:11];
    if (soft_reset) begin
      \$36  = 4'h0;
    end
    if (rst) begin
      \$36  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$37 [23:0] = \$24 ;
    \$37 [47:24] = \$25 ;
    \$37 [71:48] = \$26 ;
    \$37 [95:72] = \$27 ;
    if (soft_reset) begin
      \$37  = 96'h000000000000000000000000;
    end
    if (rst) begin
      \$37  = 96'h000000000000000000000000;
    end
  end
  assign write__addr = { row[1:0], \$9 [7:0] };
  assign write__data = { i__payload[23:0], i__payload[23:0], i__payload[23:0], i__payload[23:0] };
  assign read__addr = { read[1:0], read[9:2] };
  assign \write__addr$19  = { row[1:0], \$11 [7:0] };
  assign \write__data$20  = { i__payload[47:24], i__payload[47:24], i__payload[47:24], i__payload[47:24] };
  assign \read__addr$22  = { read[1:0], read[9:2] };
  assign \shape.height  = shape[15:0];
  assign \shape.width  = shape[31:16];
  assign \shape.groups  = shape[46:32];
  assign \shape.tail  = shape[48:47];
  assign \shape.blocks  = shape[62:49];
  assign \shape.ingest_words  = shape[76:63];
  assign \shape.tiles  = shape[88:77];
  assign \shape.output_words  = shape[100:89];
  assign \shape.beats_in  = shape[116:101];
  assign \shape.beats_out  = shape[132:117];
  assign \read.slot  = read[1:0];
  assign \read.address  = read[9:2];
  assign \read.bank  = read[10];
  assign \read.mask  = read[14:11];
endmodule

module \macram_top.array.loader (i__valid, rst, fault, error, i__payload, soft_reset, words, start_weights, start_requant, \port$1305$0 , \port$1307$0 , \port$1309$0 , i__ready, unit_en, requant_en, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$9  = 0;
  wire [4:0] \$1 ;
  wire [1086:0] \$10 ;
  wire [4:0] \$11 ;
  wire [4:0] \$12 ;
  wire [10:0] \$13 ;
  wire [10:0] \$14 ;
  wire [64:0] \$15 ;
  wire \$16 ;
  wire \$17 ;
  wire \$18 ;
  wire \$19 ;
  wire [3:0] \$2 ;
  wire \$20 ;
  wire \$21 ;
  wire [63:0] \$22 ;
  wire \$23 ;
  reg [8:0] \$24 ;
  reg [8:0] \$25  = 9'h000;
  reg [7:0] \$26 ;
  reg [7:0] \$27  = 8'h00;
  reg [575:0] \$28 ;
  reg [3:0] \$29 ;
  wire \$3 ;
  reg [9:0] \$30 ;
  reg [63:0] \$31 ;
  reg \$32 ;
  reg \$33 ;
  reg [63:0] \$34 ;
  reg \$35 ;
  wire [10:0] \$4 ;
  wire \$5 ;
  wire \$6 ;
  wire \$7 ;
  wire [575:0] \$8 ;
  wire [1086:0] \$9 ;
  wire \$signal ;
  wire \$signal$10 ;
  wire \$signal$4 ;
  wire \$signal$7 ;
  reg [3:0] beat_index = 4'h0;
  (* init = 1'h0 *)
  wire busy;
  input clk;
  wire clk;
  (* enum_base_type = "Error" *)
  (* enum_value_000 = "NONE" *)
  (* enum_value_001 = "BAD_SHAPE" *)
  (* enum_value_010 = "BAD_MODE" *)
  (* enum_value_011 = "TLAST_EARLY" *)
  (* enum_value_100 = "TLAST_MISSING" *)
  (* enum_value_101 = "BAD_COMMAND" *)
  output [2:0] error;
  wire [2:0] error;
  output fault;
  wire fault;
  input [64:0] i__payload;
  wire [64:0] i__payload;
  wire [63:0] \i__payload.data ;
  wire \i__payload.last ;
  output i__ready;
  reg i__ready = 1'h0;
  input i__valid;
  wire i__valid;
  (* init = 9'h000 *)
  output [8:0] \port$1305$0 ;
  wire [8:0] \port$1305$0 ;
  (* init = 8'h00 *)
  output [7:0] \port$1307$0 ;
  wire [7:0] \port$1307$0 ;
  output [535:0] \port$1309$0 ;
  wire [535:0] \port$1309$0 ;
  wire [543:0] requant;
  wire [7:0] \requant.addr ;
  wire [535:0] \requant.data ;
  output requant_en;
  reg requant_en = 1'h0;
  input rst;
  wire rst;
  reg [575:0] shifter = 576'h000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000;
  input soft_reset;
  wire soft_reset;
  input start_requant;
  wire start_requant;
  input start_weights;
  wire start_weights;
  reg to_requant = 1'h0;
  reg [63:0] unit = 64'h0000000000000000;
  output [63:0] unit_en;
  reg [63:0] unit_en = 64'h0000000000000000;
  wire [80:0] weight;
  wire [8:0] \weight.addr ;
  wire [71:0] \weight.data ;
  reg [9:0] word_index = 10'h000;
  input [31:0] words;
  wire [31:0] words;
  assign \$signal  = i__valid & i__ready;
  assign \$1  = beat_index + 1'h1;
  assign \$2  = to_requant ? 4'h9 : 4'h2;
  assign \$3  = \$1  == \$2 ;
  assign \$signal$4  = \$signal  & \$3 ;
  assign \$4  = word_index + 1'h1;
  assign \$5  = \$4  == words;
  assign \$signal$7  = \$signal$4  & \$5 ;
  assign \$6  = to_requant | unit[63];
  assign \$signal$10  = \$signal$7  & \$6 ;
  assign \$7  = i__payload[64] != \$signal$10 ;
  assign fault = \$signal  & \$7 ;
  assign error = i__payload[64] ? 3'h3 : 3'h4;
  assign \$10  = { 511'h00000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000, \$8  } | \$9 ;
  assign \$11  = beat_index + 1'h1;
  assign \$12  = \$signal$4  ? 5'h00 : \$11 ;
  assign \$13  = word_index + 1'h1;
  assign \$14  = \$signal$7  ? 11'h000 : \$13 ;
  assign \$16  = \$signal$10  | fault;
  assign \$17  = ~ i__ready;
  assign \$18  = start_weights | start_requant;
  assign \$19  = \$17  & \$18 ;
  assign \$20  = ~ to_requant;
  assign \$21  = \$signal$4  & \$20 ;
  assign \$22  = \$21  ? unit : 64'h0000000000000000;
  assign \$23  = \$signal$4  & to_requant;
  always @(posedge clk)
    \$25  <= \$24 ;
  always @(posedge clk)
    \$27  <= \$26 ;
  always @(posedge clk)
    shifter <= \$28 ;
  always @(posedge clk)
    beat_index <= \$29 ;
  always @(posedge clk)
    word_index <= \$30 ;
  always @(posedge clk)
    unit <= \$31 ;
  always @(posedge clk)
    i__ready <= \$32 ;
  always @(posedge clk)
    to_requant <= \$33 ;
  always @(posedge clk)
    unit_en <= \$34 ;
  always @(posedge clk)
    requant_en <= \$35 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$24  = word_index[8:0];
    if (soft_reset) begin
      \$24  = 9'h000;
    end
    if (rst) begin
      \$24  = 9'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$26  = word_index[7:0];
    if (soft_reset) begin
      \$26  = 8'h00;
    end
    if (rst) begin
      \$26  = 8'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$28  = shifter;
    if (\$signal ) begin
      \$28  = \$10 [575:0];
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$29  = beat_index;
    if (\$signal ) begin
      \$29  = \$12 [3:0];
    end
    if (\$19 ) begin
      \$29  = 4'h0;
    end
    if (soft_reset) begin
      \$29  = 4'h0;
    end
    if (rst) begin
      \$29  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$30  = word_index;
    if (\$signal$4 ) begin
      \$30  = \$14 [9:0];
    end
    if (\$19 ) begin
      \$30  = 10'h000;
    end
    if (soft_reset) begin
      \$30  = 10'h000;
    end
    if (rst) begin
      \$30  = 10'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$31  = unit;
    if (\$signal$7 ) begin
      \$31  = \$15 [63:0];
    end
    if (\$19 ) begin
      \$31  = 64'h0000000000000001;
    end
    if (soft_reset) begin
      \$31  = 64'h0000000000000000;
    end
    if (rst) begin
      \$31  = 64'h0000000000000000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$32  = i__ready;
    if (\$16 ) begin
      \$32  = 1'h0;
    end
    if (\$19 ) begin
      \$32  = 1'h1;
    end
    if (soft_reset) begin
      \$32  = 1'h0;
    end
    if (rst) begin
      \$32  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$33  = to_requant;
    if (\$19 ) begin
      \$33  = start_requant;
    end
    if (soft_reset) begin
      \$33  = 1'h0;
    end
    if (rst) begin
      \$33  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$34  = \$22 ;
    if (soft_reset) begin
      \$34  = 64'h0000000000000000;
    end
    if (rst) begin
      \$34  = 64'h0000000000000000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$35  = \$23 ;
    if (soft_reset) begin
      \$35  = 1'h0;
    end
    if (rst) begin
      \$35  = 1'h0;
    end
  end
  assign busy = i__ready;
  assign weight = { shifter[519:448], \$25  };
  assign requant = { shifter[535:0], \$27  };
  assign \port$1305$0  = \$25 ;
  assign \port$1307$0  = \$27 ;
  assign \port$1309$0  = shifter[535:0];
  assign \i__payload.data  = i__payload[63:0];
  assign \i__payload.last  = i__payload[64];
  assign \weight.addr  = \$25 ;
  assign \weight.data  = shifter[519:448];
  assign \requant.addr  = \$27 ;
  assign \requant.data  = shifter[535:0];
  assign \$8  = { 64'h0000000000000000, shifter[575:64] };
  assign \$9  = { 511'h00000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000, i__payload[63:0], 512'h00000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000 };
  assign \$15  = { unit, 1'h0 };
endmodule

module \macram_top.array.sequencer (rst, start, starved, blocked, issue, retire, credit, soft_reset, shape, group_written, image_written, flushing, \step$37 , clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$10  = 0;
  wire [14:0] \$1 ;
  wire [15:0] \$10 ;
  wire [16:0] \$11 ;
  wire \$12 ;
  wire \$13 ;
  wire \$14 ;
  wire \$15 ;
  wire \$16 ;
  wire \$17 ;
  wire \$18 ;
  wire \$19 ;
  wire \$2 ;
  wire \$20 ;
  wire \$21 ;
  wire \$22 ;
  wire \$23 ;
  wire \$24 ;
  wire \$25 ;
  wire \$26 ;
  wire [16:0] \$27 ;
  wire \$28 ;
  wire \$29 ;
  wire \$3 ;
  wire \$30 ;
  wire \$31 ;
  wire \$32 ;
  wire \$33 ;
  wire [3:0] \$34 ;
  wire [4:0] \$35 ;
  wire [4:0] \$36 ;
  wire \$37 ;
  wire \$38 ;
  wire \$39 ;
  wire \$4 ;
  wire \$40 ;
  wire \$41 ;
  wire \$42 ;
  wire \$43 ;
  wire \$44 ;
  wire \$45 ;
  wire [18:0] \$46 ;
  wire \$47 ;
  wire \$48 ;
  wire \$49 ;
  wire \$5 ;
  wire [19:0] \$50 ;
  wire \$51 ;
  wire [14:0] \$52 ;
  wire [10:0] \$53 ;
  wire [2:0] \$54 ;
  wire [12:0] \$55 ;
  wire [15:0] \$56 ;
  wire [14:0] \$57 ;
  wire \$58 ;
  wire [16:0] \$59 ;
  wire \$6 ;
  wire \$60 ;
  wire \$61 ;
  wire \$62 ;
  wire \$63 ;
  wire \$64 ;
  wire [15:0] \$65 ;
  wire [15:0] \$66 ;
  wire [13:0] \$67 ;
  wire [14:0] \$68 ;
  wire [3:0] \$69 ;
  wire \$7 ;
  wire \$70 ;
  wire \$71 ;
  wire \$72 ;
  wire \$73 ;
  reg [17:0] \$74 ;
  reg \$75 ;
  reg [13:0] \$76 ;
  reg [9:0] \$77 ;
  reg [1:0] \$78 ;
  reg [11:0] \$79 ;
  wire \$8 ;
  reg [14:0] \$80 ;
  reg [8:0] \$81 ;
  reg [15:0] \$82 ;
  reg \$83 ;
  reg \$84 ;
  reg \$85 ;
  reg [41:0] \$86 ;
  wire [12:0] \$9 ;
  wire \$signal ;
  wire \$signal$10 ;
  reg [14:0] \$signal$11  = 15'h0000;
  wire \$signal$12 ;
  reg [15:0] \$signal$13  = 16'h0000;
  wire \$signal$4 ;
  reg [1:0] \$signal$5  = 2'h0;
  wire \$signal$7 ;
  wire \$signal$9 ;
  reg [17:0] ahead = 18'h00000;
  reg [13:0] block = 14'h0000;
  output blocked;
  wire blocked;
  reg busy = 1'h0;
  input clk;
  wire clk;
  input credit;
  wire credit;
  reg credits = 1'h0;
  wire \edge ;
  output flushing;
  reg flushing = 1'h0;
  reg [8:0] group_base = 9'h000;
  input group_written;
  wire group_written;
  input image_written;
  wire image_written;
  output issue;
  wire issue;
  wire last;
  wire [3:0] pixels;
  wire pixels_ready;
  output retire;
  wire retire;
  wire row_exists;
  input rst;
  wire rst;
  input [132:0] shape;
  wire [132:0] shape;
  wire [15:0] \shape.beats_in ;
  wire [15:0] \shape.beats_out ;
  wire [13:0] \shape.blocks ;
  wire [14:0] \shape.groups ;
  wire [15:0] \shape.height ;
  wire [13:0] \shape.ingest_words ;
  wire [11:0] \shape.output_words ;
  wire [1:0] \shape.tail ;
  wire [11:0] \shape.tiles ;
  wire [15:0] \shape.width ;
  wire [3:0] slots;
  input soft_reset;
  wire soft_reset;
  wire [17:0] source_row;
  input start;
  wire start;
  output starved;
  wire starved;
  wire step;
  output [41:0] \step$37 ;
  reg [41:0] \step$37  = 42'h00000000000;
  wire [7:0] \step$37.control ;
  wire \step$37.control.edge ;
  wire \step$37.control.en ;
  wire \step$37.control.first ;
  wire \step$37.control.last ;
  wire [3:0] \step$37.control.tile ;
  wire [9:0] \step$37.info ;
  wire \step$37.info.image_last ;
  wire [3:0] \step$37.info.slots ;
  wire [3:0] \step$37.info.tile ;
  wire \step$37.info.tile_last ;
  wire [14:0] \step$37.read ;
  wire [7:0] \step$37.read.address ;
  wire \step$37.read.bank ;
  wire [3:0] \step$37.read.mask ;
  wire [1:0] \step$37.read.slot ;
  wire [8:0] \step$37.weight ;
  reg [11:0] tile = 12'h000;
  reg valid = 1'h0;
  reg [9:0] weight = 10'h000;
  assign \$signal$9  = \$9  == shape[88:77];
  assign \$10  = \$signal$11  + 1'h1;
  assign \$signal$10  = \$10  == shape[46:32];
  assign \$11  = \$signal$13  + 1'h1;
  assign \$signal$12  = \$11  == shape[15:0];
  assign \$12  = ~ \$signal$7 ;
  assign \$13  = \$12  | image_written;
  assign \$14  = $signed(ahead) > $signed(1'h0);
  assign \$15  = \$13  | \$14 ;
  assign pixels_ready = \$15  | flushing;
  assign \$16  = ~ pixels_ready;
  assign starved = busy & \$16 ;
  assign \$17  = busy & pixels_ready;
  assign \$18  = \$17  & last;
  assign \$19  = ~ credits;
  assign blocked = \$18  & \$19 ;
  assign \$20  = busy & pixels_ready;
  assign \$21  = ~ credits;
  assign \$22  = last & \$21 ;
  assign \$23  = ~ \$22 ;
  assign step = \$20  & \$23 ;
  assign \$24  = ~ flushing;
  assign issue = step & \$24 ;
  assign \$25  = issue & last;
  assign \$26  = \$25  & \$signal$9 ;
  assign retire = \$26  & \$signal$10 ;
  assign \$27  = \$signal$13  + \$signal$5 ;
  assign source_row = \$27  - 1'h1;
  assign \$28  = $signed(source_row) >= $signed(1'h0);
  assign \$29  = $signed(source_row) < $signed({ 1'h0, shape[15:0] });
  assign \$30  = \$28  & \$29 ;
  assign \$31  = ~ flushing;
  assign row_exists = \$30  & \$31 ;
  assign \$32  = | shape[48:47];
  assign \$33  = \$signal$10  & \$32 ;
  assign \$34  = 1'h1 << shape[48:47];
  assign \$35  = \$34  - 1'h1;
  assign \$36  = \$33  ? \$35  : 5'h0f;
  assign \edge  = ! \$signal$11 ;
  assign \$37  = ! shape[48:47];
  assign \$38  = | \$signal$13 ;
  assign \$39  = \$37  & \$38 ;
  assign \$40  = \edge  ? \$39  : 1'h1;
  assign \$41  = ~ flushing;
  assign \$42  = ~ flushing;
  assign \$43  = \$42  & \$36 [1];
  assign \$44  = ~ flushing;
  assign \$45  = \$44  & \$36 [2];
  assign \$46  = $signed(ahead) + $signed({ 1'h0, group_written });
  assign \$47  = step & \$signal$7 ;
  assign \$48  = ~ flushing;
  assign \$49  = \$47  & \$48 ;
  assign \$50  = $signed(\$46 ) - $signed({ 1'h0, \$49  });
  assign \$51  = step & last;
  assign \$52  = block + 1'h1;
  assign \$53  = weight + 1'h1;
  assign \$54  = \$signal$5  + 1'h1;
  assign \$55  = tile + 1'h1;
  assign \$56  = \$signal$11  + 1'h1;
  assign \$57  = group_base + shape[76:63];
  assign \$58  = \$signal$10  | flushing;
  assign \$59  = \$signal$13  + 1'h1;
  assign \$60  = \$signal$12  | flushing;
  assign \$61  = ! shape[48:47];
  assign \$62  = ~ flushing;
  assign \$63  = \$61  & \$62 ;
  assign \$64  = shape[15:0] == 1'h1;
  assign \$65  = - shape[46:32];
  assign \$66  = \$64  ? 16'h0000 : \$65 ;
  assign \$68  = group_base + \$67 ;
  assign \$69  = row_exists ? \$36 [3:0] : 4'h0;
  assign \$70  = \$signal$12  & \$signal$10 ;
  assign \$71  = | shape[48:47];
  assign \$72  = \$70  & \$71 ;
  assign \$73  = flushing | \$72 ;
  always @(posedge clk)
    ahead <= \$74 ;
  always @(posedge clk)
    credits <= \$75 ;
  always @(posedge clk)
    block <= \$76 ;
  always @(posedge clk)
    weight <= \$77 ;
  always @(posedge clk)
    \$signal$5  <= \$78 ;
  always @(posedge clk)
    tile <= \$79 ;
  always @(posedge clk)
    \$signal$11  <= \$80 ;
  always @(posedge clk)
    group_base <= \$81 ;
  always @(posedge clk)
    \$signal$13  <= \$82 ;
  always @(posedge clk)
    flushing <= \$83 ;
  always @(posedge clk)
    busy <= \$84 ;
  always @(posedge clk)
    valid <= \$85 ;
  always @(posedge clk)
    \step$37  <= \$86 ;
  assign \$1  = block + 1'h1;
  assign \$2  = \$1  == shape[62:49];
  assign \$signal  = flushing | \$2 ;
  assign \$3  = ! \$signal$5 ;
  assign \$4  = ! block;
  assign \$5  = \$3  & \$4 ;
  assign \$signal$4  = flushing | \$5 ;
  assign \$6  = \$signal$5  == 2'h2;
  assign \$7  = \$6  & \$signal ;
  assign last = flushing | \$7 ;
  assign \$8  = ! tile;
  assign \$signal$7  = \$signal$4  & \$8 ;
  assign \$9  = tile + 1'h1;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$74  = \$50 [17:0];
    if (start) begin
      \$74  = { \$66 [15], \$66 [15], \$66  };
    end
    if (soft_reset) begin
      \$74  = 18'h00000;
    end
    if (rst) begin
      \$74  = 18'h00000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$75  = credits;
    if (credit) begin
      \$75  = 1'h1;
    end else if (\$51 ) begin
      \$75  = 1'h0;
    end
    if (start) begin
      \$75  = 1'h1;
    end
    if (soft_reset) begin
      \$75  = 1'h0;
    end
    if (rst) begin
      \$75  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$76  = block;
    if (step) begin
      \$76  = \$52 [13:0];
      if (\$signal ) begin
        \$76  = 14'h0000;
      end
    end
    if (start) begin
      \$76  = 14'h0000;
    end
    if (soft_reset) begin
      \$76  = 14'h0000;
    end
    if (rst) begin
      \$76  = 14'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$77  = weight;
    if (step) begin
      \$77  = \$53 [9:0];
      if (last) begin
        if (\$signal$9 ) begin
          \$77  = 10'h000;
        end
      end
    end
    if (start) begin
      \$77  = 10'h000;
    end
    if (soft_reset) begin
      \$77  = 10'h000;
    end
    if (rst) begin
      \$77  = 10'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$78  = \$signal$5 ;
    if (step) begin
      if (\$signal ) begin
        \$78  = \$54 [1:0];
      end
      if (last) begin
        \$78  = 2'h0;
      end
    end
    if (start) begin
      \$78  = 2'h0;
    end
    if (soft_reset) begin
      \$78  = 2'h0;
    end
    if (rst) begin
      \$78  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$79  = tile;
    if (step) begin
      if (last) begin
        \$79  = \$55 [11:0];
        if (\$signal$9 ) begin
          \$79  = 12'h000;
        end
      end
    end
    if (start) begin
      \$79  = 12'h000;
    end
    if (soft_reset) begin
      \$79  = 12'h000;
    end
    if (rst) begin
      \$79  = 12'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$80  = \$signal$11 ;
    if (step) begin
      if (last) begin
        if (\$signal$9 ) begin
          \$80  = \$56 [14:0];
          if (\$58 ) begin
            \$80  = 15'h0000;
          end
        end
      end
    end
    if (start) begin
      \$80  = 15'h0000;
    end
    if (soft_reset) begin
      \$80  = 15'h0000;
    end
    if (rst) begin
      \$80  = 15'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$81  = group_base;
    if (step) begin
      if (last) begin
        if (\$signal$9 ) begin
          \$81  = \$57 [8:0];
          if (\$58 ) begin
            \$81  = 9'h000;
          end
        end
      end
    end
    if (start) begin
      \$81  = 9'h000;
    end
    if (soft_reset) begin
      \$81  = 9'h000;
    end
    if (rst) begin
      \$81  = 9'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$82  = \$signal$13 ;
    if (step) begin
      if (last) begin
        if (\$signal$9 ) begin
          if (\$58 ) begin
            \$82  = \$59 [15:0];
          end
        end
      end
    end
    if (start) begin
      \$82  = 16'h0000;
    end
    if (soft_reset) begin
      \$82  = 16'h0000;
    end
    if (rst) begin
      \$82  = 16'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$83  = flushing;
    if (step) begin
      if (last) begin
        if (\$signal$9 ) begin
          if (\$58 ) begin
            if (\$60 ) begin
              (* full_case = 32'd1 *)
              if (\$63 ) begin
                \$83  = 1'h1;
              end else begin
                \$83  = 1'h0;
              end
            end
          end
        end
      end
    end
    if (start) begin
      \$83  = 1'h0;
    end
    if (soft_reset) begin
      \$83  = 1'h0;
    end
    if (rst) begin
      \$83  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$84  = busy;
    if (step) begin
      if (last) begin
        if (\$signal$9 ) begin
          if (\$58 ) begin
            if (\$60 ) begin
              (* full_case = 32'd1 *)
              if (\$63 ) begin
              end else begin
                \$84  = 1'h0;
              end
            end
          end
        end
      end
    end
    if (start) begin
      \$84  = 1'h1;
    end
    if (soft_reset) begin
      \$84  = 1'h0;
    end
    if (rst) begin
      \$84  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$85  = step;
    if (soft_reset) begin
      \$85  = 1'h0;
    end
    if (rst) begin
      \$85  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$86 [1:0] = source_row[1:0];
    \$86 [9:2] = \$68 [7:0];
    \$86 [10] = block[0];
    \$86 [14:11] = \$69 ;
    \$86 [23:15] = weight[8:0];
    \$86 [24] = step;
    \$86 [25] = \$signal$4 ;
    \$86 [26] = last;
    \$86 [27] = \edge ;
    \$86 [31:28] = tile[3:0];
    \$86 [35:32] = tile[3:0];
    \$86 [36] = \$signal$9 ;
    \$86 [40:37] = slots;
    \$86 [41] = \$73 ;
    if (soft_reset) begin
      \$86  = 42'h00000000000;
    end
    if (rst) begin
      \$86  = 42'h00000000000;
    end
  end
  assign pixels = \$36 [3:0];
  assign \shape.height  = shape[15:0];
  assign \shape.width  = shape[31:16];
  assign \shape.groups  = shape[46:32];
  assign \shape.tail  = shape[48:47];
  assign \shape.blocks  = shape[62:49];
  assign \shape.ingest_words  = shape[76:63];
  assign \shape.tiles  = shape[88:77];
  assign \shape.output_words  = shape[100:89];
  assign \shape.beats_in  = shape[116:101];
  assign \shape.beats_out  = shape[132:117];
  assign \step$37.read  = \step$37 [14:0];
  assign \step$37.read.slot  = \step$37 [1:0];
  assign \step$37.read.address  = \step$37 [9:2];
  assign \step$37.read.bank  = \step$37 [10];
  assign \step$37.read.mask  = \step$37 [14:11];
  assign \step$37.weight  = \step$37 [23:15];
  assign \step$37.control  = \step$37 [31:24];
  assign \step$37.control.en  = \step$37 [24];
  assign \step$37.control.first  = \step$37 [25];
  assign \step$37.control.last  = \step$37 [26];
  assign \step$37.control.edge  = \step$37 [27];
  assign \step$37.control.tile  = \step$37 [31:28];
  assign \step$37.info  = \step$37 [41:32];
  assign \step$37.info.tile  = \step$37 [35:32];
  assign \step$37.info.tile_last  = \step$37 [36];
  assign \step$37.info.slots  = \step$37 [40:37];
  assign \step$37.info.image_last  = \step$37 [41];
  assign slots[3] = \$45 ;
  assign slots[2] = \$43 ;
  assign slots[1] = \$41 ;
  assign slots[0] = \$40 ;
  assign \$67  = { 1'h0, block[13:1] };
endmodule

module \macram_top.array.unit000 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_000.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit001 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_001.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit002 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_002.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit003 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_003.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit004 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_004.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit005 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_005.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit006 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_006.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit007 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_007.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit008 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_008.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit009 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_009.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit010 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_010.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit011 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_011.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit012 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_012.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit013 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_013.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit014 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_014.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit015 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_015.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit016 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_016.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit017 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_017.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit018 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_018.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit019 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_019.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit020 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_020.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit021 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_021.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit022 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_022.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit023 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_023.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit024 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_024.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit025 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_025.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit026 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_026.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit027 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_027.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit028 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_028.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit029 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_029.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit030 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_030.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit031 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_031.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit032 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_032.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit033 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_033.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit034 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_034.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit035 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_035.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit036 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_036.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit037 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_037.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit038 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_038.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit039 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_039.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit040 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_040.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit041 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_041.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit042 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_042.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit043 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_043.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit044 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_044.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit045 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_045.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit046 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_046.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit047 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_047.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit048 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_048.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit049 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_049.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit050 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_050.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit051 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_051.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit052 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_052.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit053 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_053.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit054 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_054.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit055 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_055.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit056 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_056.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit057 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_057.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit058 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_058.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit059 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  input [75:0] core__chain_i;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(core__chain_i),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_059.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = core__chain_i[18:0];
  assign \core__chain_i[1]  = core__chain_i[37:19];
  assign \core__chain_i[2]  = core__chain_i[56:38];
  assign \core__chain_i[3]  = core__chain_i[75:57];
  assign \chain_i[0]  = core__chain_i[18:0];
  assign \chain_i[1]  = core__chain_i[37:19];
  assign \chain_i[2]  = core__chain_i[56:38];
  assign \chain_i[3]  = core__chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit060 (rst, core__shift, chain_o, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(76'h0000000000000000000),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_060.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign core__chain_i = 76'h0000000000000000000;
  assign chain_i = 76'h0000000000000000000;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = 19'h00000;
  assign \core__chain_i[1]  = 19'h00000;
  assign \core__chain_i[2]  = 19'h00000;
  assign \core__chain_i[3]  = 19'h00000;
  assign \chain_i[0]  = 19'h00000;
  assign \chain_i[1]  = 19'h00000;
  assign \chain_i[2]  = 19'h00000;
  assign \chain_i[3]  = 19'h00000;
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit061 (rst, core__shift, chain_o, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(76'h0000000000000000000),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_061.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign core__chain_i = 76'h0000000000000000000;
  assign chain_i = 76'h0000000000000000000;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = 19'h00000;
  assign \core__chain_i[1]  = 19'h00000;
  assign \core__chain_i[2]  = 19'h00000;
  assign \core__chain_i[3]  = 19'h00000;
  assign \chain_i[0]  = 19'h00000;
  assign \chain_i[1]  = 19'h00000;
  assign \chain_i[2]  = 19'h00000;
  assign \chain_i[3]  = 19'h00000;
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit062 (rst, core__shift, chain_o, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(76'h0000000000000000000),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_062.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign core__chain_i = 76'h0000000000000000000;
  assign chain_i = 76'h0000000000000000000;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = 19'h00000;
  assign \core__chain_i[1]  = 19'h00000;
  assign \core__chain_i[2]  = 19'h00000;
  assign \core__chain_i[3]  = 19'h00000;
  assign \chain_i[0]  = 19'h00000;
  assign \chain_i[1]  = 19'h00000;
  assign \chain_i[2]  = 19'h00000;
  assign \chain_i[3]  = 19'h00000;
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.array.unit063 (rst, core__shift, chain_o, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [8:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [8:0] address;
  wire [8:0] address;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  wire [75:0] chain_o;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  input [95:0] core__activations;
  wire [95:0] core__activations;
  wire [75:0] core__chain_i;
  wire [18:0] \core__chain_i[0] ;
  wire [18:0] \core__chain_i[1] ;
  wire [18:0] \core__chain_i[2] ;
  wire [18:0] \core__chain_i[3] ;
  wire [75:0] core__chain_o;
  wire [18:0] \core__chain_o[0] ;
  wire [18:0] \core__chain_o[1] ;
  wire [18:0] \core__chain_o[2] ;
  wire [18:0] \core__chain_o[3] ;
  input [7:0] core__control;
  wire [7:0] core__control;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  input core__shift;
  wire core__shift;
  wire [71:0] core__weight;
  input rst;
  wire rst;
  wire shift;
  wire [80:0] write;
  wire [8:0] \write.addr ;
  wire [71:0] \write.data ;
  input [8:0] write__addr;
  wire [8:0] write__addr;
  input [71:0] write__data;
  wire [71:0] write__data;
  input write__en;
  wire write__en;
  wire write_en;
  macram_unit core (
    .activations(core__activations),
    .chain_i(76'h0000000000000000000),
    .chain_o(chain_o),
    .clk(clk),
    .control(core__control),
    .rst(rst),
    .shift(core__shift),
    .weight(core__weight)
  );
  macram_ram #(
    .ADDR_BITS(32'd9),
    .DEPTH(32'd512),
    .INIT_FILE("unit_063.mem"),
    .LANES(32'd1),
    .WIDTH(32'd72)
  ) weights (
    .clk(clk),
    .read_addr(address),
    .read_data(core__weight),
    .read_en(1'h1),
    .write_addr(write__addr),
    .write_data(write__data),
    .write_en(write__en)
  );
  assign \$signature__addr  = address;
  assign write = { write__data, write__addr };
  assign write_en = write__en;
  assign \$signature__data  = core__weight;
  assign activations = core__activations;
  assign control = core__control;
  assign shift = core__shift;
  assign core__chain_i = 76'h0000000000000000000;
  assign chain_i = 76'h0000000000000000000;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.last  = core__control[2];
  assign \core__control.edge  = core__control[3];
  assign \core__control.tile  = core__control[7:4];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.last  = core__control[2];
  assign \control.edge  = core__control[3];
  assign \control.tile  = core__control[7:4];
  assign \core__chain_i[0]  = 19'h00000;
  assign \core__chain_i[1]  = 19'h00000;
  assign \core__chain_i[2]  = 19'h00000;
  assign \core__chain_i[3]  = 19'h00000;
  assign \chain_i[0]  = 19'h00000;
  assign \chain_i[1]  = 19'h00000;
  assign \chain_i[2]  = 19'h00000;
  assign \chain_i[3]  = 19'h00000;
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \core__chain_o[0]  = chain_o[18:0];
  assign \core__chain_o[1]  = chain_o[37:19];
  assign \core__chain_o[2]  = chain_o[56:38];
  assign \core__chain_o[3]  = chain_o[75:57];
endmodule

module \macram_top.registers (axi__awaddr, axi__awvalid, axi__wdata, axi__wstrb, axi__wvalid, axi__bready, axi__araddr, axi__arvalid, axi__rready, rst, \port$2$0 , axi__awready, axi__wready, axi__arready, busy, command, axi__bvalid, axi__bresp, height, width, c_in
, c_out, mode, param_words, axi__rvalid, axi__rdata, axi__rresp, \port$1059$0 , \port$1061$0 , cycles, mac_cycles, fill_cycles, input_stalls, output_stalls, drain_cycles, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$11  = 0;
  wire \$1 ;
  wire \$10 ;
  wire [3:0] \$11 ;
  wire [4:0] \$12 ;
  wire \$13 ;
  wire \$14 ;
  wire \$15 ;
  wire [3:0] \$16 ;
  wire \$17 ;
  reg [4:0] \$18 ;
  reg \$19 ;
  wire \$2 ;
  reg [31:0] \$20 ;
  reg [3:0] \$21 ;
  reg \$22 ;
  reg [3:0] \$23 ;
  reg \$24 ;
  reg [1:0] \$25 ;
  reg [31:0] \$26 ;
  reg [31:0] \$27 ;
  reg [31:0] \$28 ;
  reg [31:0] \$29 ;
  wire \$3 ;
  reg [31:0] \$30 ;
  reg [31:0] \$31 ;
  reg [4:0] \$32 ;
  reg \$33 ;
  reg \$34 ;
  reg [31:0] \$35 ;
  reg [1:0] \$36 ;
  wire \$4 ;
  wire \$5 ;
  wire \$6 ;
  wire \$7 ;
  wire \$8 ;
  wire \$9 ;
  reg [4:0] \$signal  = 5'h00;
  reg [31:0] \$signal$12  = 32'd0;
  reg [3:0] \$signal$14  = 4'h0;
  reg [4:0] \$signal$28  = 5'h00;
  reg address_held = 1'h0;
  input [6:0] axi__araddr;
  wire [6:0] axi__araddr;
  output axi__arready;
  wire axi__arready;
  input axi__arvalid;
  wire axi__arvalid;
  input [6:0] axi__awaddr;
  wire [6:0] axi__awaddr;
  output axi__awready;
  wire axi__awready;
  input axi__awvalid;
  wire axi__awvalid;
  input axi__bready;
  wire axi__bready;
  output [1:0] axi__bresp;
  reg [1:0] axi__bresp = 2'h0;
  output axi__bvalid;
  reg axi__bvalid = 1'h0;
  output [31:0] axi__rdata;
  reg [31:0] axi__rdata = 32'd0;
  input axi__rready;
  wire axi__rready;
  output [1:0] axi__rresp;
  reg [1:0] axi__rresp = 2'h0;
  output axi__rvalid;
  reg axi__rvalid = 1'h0;
  input [31:0] axi__wdata;
  wire [31:0] axi__wdata;
  output axi__wready;
  wire axi__wready;
  input [3:0] axi__wstrb;
  wire [3:0] axi__wstrb;
  input axi__wvalid;
  wire axi__wvalid;
  input busy;
  wire busy;
  output [31:0] c_in;
  reg [31:0] c_in = 32'd0;
  output [31:0] c_out;
  reg [31:0] c_out = 32'd0;
  input clk;
  wire clk;
  output [3:0] command;
  reg [3:0] command = 4'h0;
  input [31:0] cycles;
  wire [31:0] cycles;
  reg data_held = 1'h0;
  input [31:0] drain_cycles;
  wire [31:0] drain_cycles;
  wire [31:0] error;
  input [31:0] fill_cycles;
  wire [31:0] fill_cycles;
  wire [31:0] formats;
  wire [31:0] geometry;
  output [31:0] height;
  reg [31:0] height = 32'd0;
  reg held = 1'h0;
  input [31:0] input_stalls;
  wire [31:0] input_stalls;
  input [31:0] mac_cycles;
  wire [31:0] mac_cycles;
  wire [31:0] max_channels;
  output [31:0] mode;
  reg [31:0] mode = 32'd65795;
  input [31:0] output_stalls;
  wire [31:0] output_stalls;
  output [31:0] param_words;
  reg [31:0] param_words = 32'd0;
  input [2:0] \port$1059$0 ;
  wire [2:0] \port$1059$0 ;
  input \port$1061$0 ;
  wire \port$1061$0 ;
  input \port$2$0 ;
  wire \port$2$0 ;
  wire [31:0] row_words;
  input rst;
  wire rst;
  wire [31:0] status;
  wire [31:0] weight_depth;
  output [31:0] width;
  reg [31:0] width = 32'd0;
  assign axi__awready = ~ address_held;
  assign axi__wready = ~ data_held;
  assign axi__arready = ~ held;
  assign \$1  = axi__awvalid & axi__awready;
  assign \$2  = axi__wvalid & axi__wready;
  assign \$3  = address_held & data_held;
  assign \$4  = ~ busy;
  assign \$5  = ~ busy;
  assign \$6  = ~ busy;
  assign \$7  = ~ busy;
  assign \$8  = ~ busy;
  assign \$9  = ~ busy;
  assign \$10  = ~ busy;
  assign \$11  = \$signal$14 [0] ? \$signal$12 [3:0] : 4'h0;
  assign \$13  = | \$12 ;
  assign \$14  = ~ \$13 ;
  assign \$15  = \$10  | \$14 ;
  assign \$16  = \$signal$14 [0] ? \$signal$12 [3:0] : 4'h0;
  assign \$17  = axi__arvalid & axi__arready;
  always @(posedge clk)
    \$signal  <= \$18 ;
  always @(posedge clk)
    address_held <= \$19 ;
  always @(posedge clk)
    \$signal$12  <= \$20 ;
  always @(posedge clk)
    \$signal$14  <= \$21 ;
  always @(posedge clk)
    data_held <= \$22 ;
  always @(posedge clk)
    command <= \$23 ;
  always @(posedge clk)
    axi__bvalid <= \$24 ;
  always @(posedge clk)
    axi__bresp <= \$25 ;
  always @(posedge clk)
    height <= \$26 ;
  always @(posedge clk)
    width <= \$27 ;
  always @(posedge clk)
    c_in <= \$28 ;
  always @(posedge clk)
    c_out <= \$29 ;
  always @(posedge clk)
    mode <= \$30 ;
  always @(posedge clk)
    param_words <= \$31 ;
  always @(posedge clk)
    \$signal$28  <= \$32 ;
  always @(posedge clk)
    held <= \$33 ;
  always @(posedge clk)
    axi__rvalid <= \$34 ;
  always @(posedge clk)
    axi__rdata <= \$35 ;
  always @(posedge clk)
    axi__rresp <= \$36 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$18  = \$signal ;
    if (\$1 ) begin
      \$18  = axi__awaddr[6:2];
    end
    if (rst) begin
      \$18  = 5'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$19  = address_held;
    if (\$1 ) begin
      \$19  = 1'h1;
    end
    if (axi__bvalid) begin
      if (axi__bready) begin
        \$19  = 1'h0;
      end
    end
    if (rst) begin
      \$19  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$20  = \$signal$12 ;
    if (\$2 ) begin
      \$20  = axi__wdata;
    end
    if (rst) begin
      \$20  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$21  = \$signal$14 ;
    if (\$2 ) begin
      \$21  = axi__wstrb;
    end
    if (rst) begin
      \$21  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$22  = data_held;
    if (\$2 ) begin
      \$22  = 1'h1;
    end
    if (axi__bvalid) begin
      if (axi__bready) begin
        \$22  = 1'h0;
      end
    end
    if (rst) begin
      \$22  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$23  = 4'h0;
    if (axi__bvalid) begin
    end else if (\$3 ) begin
      casez (\$signal )
        5'h05:
            /* empty */;
        5'h06:
            /* empty */;
        5'h07:
            /* empty */;
        5'h08:
            /* empty */;
        5'h09:
            /* empty */;
        5'h0a:
            /* empty */;
        5'h02:
            if (\$15 ) begin
              \$23  = \$16 ;
            end
      endcase
    end
    if (rst) begin
      \$23  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$24  = axi__bvalid;
    if (axi__bvalid) begin
      if (axi__bready) begin
        \$24  = 1'h0;
      end
    end else if (\$3 ) begin
      \$24  = 1'h1;
    end
    if (rst) begin
      \$24  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$25  = axi__bresp;
    if (axi__bvalid) begin
    end else if (\$3 ) begin
      \$25  = 2'h2;
      casez (\$signal )
        5'h05:
            if (\$4 ) begin
              \$25  = 2'h0;
            end
        5'h06:
            if (\$5 ) begin
              \$25  = 2'h0;
            end
        5'h07:
            if (\$6 ) begin
              \$25  = 2'h0;
            end
        5'h08:
            if (\$7 ) begin
              \$25  = 2'h0;
            end
        5'h09:
            if (\$8 ) begin
              \$25  = 2'h0;
            end
        5'h0a:
            if (\$9 ) begin
              \$25  = 2'h0;
            end
        5'h02:
            if (\$15 ) begin
              \$25  = 2'h0;
            end
      endcase
    end
    if (rst) begin
      \$25  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$26  = height;
    if (axi__bvalid) begin
    end else if (\$3 ) begin
      casez (\$signal )
        5'h05:
            if (\$4 ) begin
              if (\$signal$14 [0]) begin
                \$26 [7:0] = \$signal$12 [7:0];
              end
              if (\$signal$14 [1]) begin
                \$26 [15:8] = \$signal$12 [15:8];
              end
              if (\$signal$14 [2]) begin
                \$26 [23:16] = \$signal$12 [23:16];
              end
              if (\$signal$14 [3]) begin
                \$26 [31:24] = \$signal$12 [31:24];
              end
            end
      endcase
    end
    if (rst) begin
      \$26  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$27  = width;
    if (axi__bvalid) begin
    end else if (\$3 ) begin
      casez (\$signal )
        5'h05:
            /* empty */;
        5'h06:
            if (\$5 ) begin
              if (\$signal$14 [0]) begin
                \$27 [7:0] = \$signal$12 [7:0];
              end
              if (\$signal$14 [1]) begin
                \$27 [15:8] = \$signal$12 [15:8];
              end
              if (\$signal$14 [2]) begin
                \$27 [23:16] = \$signal$12 [23:16];
              end
              if (\$signal$14 [3]) begin
                \$27 [31:24] = \$signal$12 [31:24];
              end
            end
      endcase
    end
    if (rst) begin
      \$27  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$28  = c_in;
    if (axi__bvalid) begin
    end else if (\$3 ) begin
      casez (\$signal )
        5'h05:
            /* empty */;
        5'h06:
            /* empty */;
        5'h07:
            if (\$6 ) begin
              if (\$signal$14 [0]) begin
                \$28 [7:0] = \$signal$12 [7:0];
              end
              if (\$signal$14 [1]) begin
                \$28 [15:8] = \$signal$12 [15:8];
              end
              if (\$signal$14 [2]) begin
                \$28 [23:16] = \$signal$12 [23:16];
              end
              if (\$signal$14 [3]) begin
                \$28 [31:24] = \$signal$12 [31:24];
              end
            end
      endcase
    end
    if (rst) begin
      \$28  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$29  = c_out;
    if (axi__bvalid) begin
    end else if (\$3 ) begin
      casez (\$signal )
        5'h05:
            /* empty */;
        5'h06:
            /* empty */;
        5'h07:
            /* empty */;
        5'h08:
            if (\$7 ) begin
              if (\$signal$14 [0]) begin
                \$29 [7:0] = \$signal$12 [7:0];
              end
              if (\$signal$14 [1]) begin
                \$29 [15:8] = \$signal$12 [15:8];
              end
              if (\$signal$14 [2]) begin
                \$29 [23:16] = \$signal$12 [23:16];
              end
              if (\$signal$14 [3]) begin
                \$29 [31:24] = \$signal$12 [31:24];
              end
            end
      endcase
    end
    if (rst) begin
      \$29  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$30  = mode;
    if (axi__bvalid) begin
    end else if (\$3 ) begin
      casez (\$signal )
        5'h05:
            /* empty */;
        5'h06:
            /* empty */;
        5'h07:
            /* empty */;
        5'h08:
            /* empty */;
        5'h09:
            if (\$8 ) begin
              if (\$signal$14 [0]) begin
                \$30 [7:0] = \$signal$12 [7:0];
              end
              if (\$signal$14 [1]) begin
                \$30 [15:8] = \$signal$12 [15:8];
              end
              if (\$signal$14 [2]) begin
                \$30 [23:16] = \$signal$12 [23:16];
              end
              if (\$signal$14 [3]) begin
                \$30 [31:24] = \$signal$12 [31:24];
              end
            end
      endcase
    end
    if (rst) begin
      \$30  = 32'd65795;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$31  = param_words;
    if (axi__bvalid) begin
    end else if (\$3 ) begin
      casez (\$signal )
        5'h05:
            /* empty */;
        5'h06:
            /* empty */;
        5'h07:
            /* empty */;
        5'h08:
            /* empty */;
        5'h09:
            /* empty */;
        5'h0a:
            if (\$9 ) begin
              if (\$signal$14 [0]) begin
                \$31 [7:0] = \$signal$12 [7:0];
              end
              if (\$signal$14 [1]) begin
                \$31 [15:8] = \$signal$12 [15:8];
              end
              if (\$signal$14 [2]) begin
                \$31 [23:16] = \$signal$12 [23:16];
              end
              if (\$signal$14 [3]) begin
                \$31 [31:24] = \$signal$12 [31:24];
              end
            end
      endcase
    end
    if (rst) begin
      \$31  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$32  = \$signal$28 ;
    if (\$17 ) begin
      \$32  = axi__araddr[6:2];
    end
    if (rst) begin
      \$32  = 5'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$33  = held;
    if (\$17 ) begin
      \$33  = 1'h1;
    end
    if (axi__rvalid) begin
      if (axi__rready) begin
        \$33  = 1'h0;
      end
    end
    if (rst) begin
      \$33  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$34  = axi__rvalid;
    if (axi__rvalid) begin
      if (axi__rready) begin
        \$34  = 1'h0;
      end
    end else if (held) begin
      \$34  = 1'h1;
    end
    if (rst) begin
      \$34  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$35  = axi__rdata;
    if (axi__rvalid) begin
    end else if (held) begin
      \$35  = 32'd0;
      casez (\$signal$28 )
        5'h00:
            \$35  = 32'd1296122706;
        5'h01:
            \$35  = 32'd65536;
        5'h02:
            \$35  = 32'd0;
        5'h03:
            \$35  = { 29'h00000000, \port$2$0 , \port$1061$0 , busy };
        5'h04:
            \$35  = { 29'h00000000, \port$1059$0  };
        5'h05:
            \$35  = height;
        5'h06:
            \$35  = width;
        5'h07:
            \$35  = c_in;
        5'h08:
            \$35  = c_out;
        5'h09:
            \$35  = mode;
        5'h0a:
            \$35  = param_words;
        5'h0b:
            \$35  = cycles;
        5'h0c:
            \$35  = mac_cycles;
        5'h0d:
            \$35  = fill_cycles;
        5'h0e:
            \$35  = input_stalls;
        5'h0f:
            \$35  = output_stalls;
        5'h10:
            \$35  = drain_cycles;
        5'h11:
            \$35  = 32'd67633216;
        5'h12:
            \$35  = 32'd197379;
        5'h13:
            \$35  = 32'd512;
        5'h14:
            \$35  = 32'd512;
        5'h15:
            \$35  = 32'd67109888;
      endcase
    end
    if (rst) begin
      \$35  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$36  = axi__rresp;
    if (axi__rvalid) begin
    end else if (held) begin
      \$36  = 2'h0;
      (* full_case = 32'd1 *)
      casez (\$signal$28 )
        5'h00:
            /* empty */;
        5'h01:
            /* empty */;
        5'h02:
            /* empty */;
        5'h03:
            /* empty */;
        5'h04:
            /* empty */;
        5'h05:
            /* empty */;
        5'h06:
            /* empty */;
        5'h07:
            /* empty */;
        5'h08:
            /* empty */;
        5'h09:
            /* empty */;
        5'h0a:
            /* empty */;
        5'h0b:
            /* empty */;
        5'h0c:
            /* empty */;
        5'h0d:
            /* empty */;
        5'h0e:
            /* empty */;
        5'h0f:
            /* empty */;
        5'h10:
            /* empty */;
        5'h11:
            /* empty */;
        5'h12:
            /* empty */;
        5'h13:
            /* empty */;
        5'h14:
            /* empty */;
        5'h15:
            /* empty */;
        default:
            \$36  = 2'h2;
      endcase
    end
    if (rst) begin
      \$36  = 2'h0;
    end
  end
  assign status = { 29'h00000000, \port$2$0 , \port$1061$0 , busy };
  assign error = { 29'h00000000, \port$1059$0  };
  assign geometry = 32'd67633216;
  assign formats = 32'd197379;
  assign weight_depth = 32'd512;
  assign row_words = 32'd512;
  assign max_channels = 32'd67109888;
  assign \$12 [3] = 1'h0;
  assign { \$12 [4], \$12 [2:0] } = { 1'h0, \$11 [2:0] };
endmodule
