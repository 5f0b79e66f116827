
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
  wire \busy$76 ;
  wire [31:0] c_in;
  wire [31:0] \c_in$66 ;
  wire [31:0] c_out;
  wire [31:0] \c_out$68 ;
  wire clk;
  wire [3:0] command;
  wire [2:0] \command$56 ;
  wire [31:0] cycles;
  wire [31:0] \cycles$84 ;
  wire done;
  wire [31:0] drain_cycles;
  wire [31:0] \drain_cycles$94 ;
  (* enum_base_type = "Error" *)
  (* enum_value_000 = "NONE" *)
  (* enum_value_001 = "BAD_SHAPE" *)
  (* enum_value_010 = "BAD_MODE" *)
  (* enum_value_011 = "TLAST_EARLY" *)
  (* enum_value_100 = "TLAST_MISSING" *)
  (* enum_value_101 = "BAD_COMMAND" *)
  (* enum_value_110 = "BAD_RANGE" *)
  wire [2:0] error;
  wire [31:0] \error$82 ;
  wire [31:0] fill_cycles;
  wire [31:0] \fill_cycles$88 ;
  wire [31:0] formats;
  wire [31:0] geometry;
  wire [31:0] height;
  wire [31:0] \height$62 ;
  wire [64:0] i__payload;
  wire [63:0] \i__payload.data ;
  wire \i__payload.last ;
  wire i__ready;
  wire i__valid;
  wire [31:0] input_stalls;
  wire [31:0] \input_stalls$90 ;
  wire loading;
  wire \loading$78 ;
  output [63:0] m_axis_tdata;
  wire [63:0] m_axis_tdata;
  output m_axis_tlast;
  wire m_axis_tlast;
  input m_axis_tready;
  wire m_axis_tready;
  output m_axis_tvalid;
  wire m_axis_tvalid;
  wire [31:0] mac_cycles;
  wire [31:0] \mac_cycles$86 ;
  wire [31:0] max_channels;
  wire [31:0] mode;
  wire [31:0] \mode$70 ;
  wire [64:0] o__payload;
  wire [63:0] \o__payload.data ;
  wire \o__payload.last ;
  wire o__ready;
  wire o__valid;
  wire [31:0] output_stalls;
  wire [31:0] \output_stalls$92 ;
  wire [31:0] param_base;
  wire [31:0] \param_base$60 ;
  wire [31:0] param_words;
  wire [64:0] params__payload;
  wire [63:0] \params__payload.data ;
  wire \params__payload.last ;
  wire params__ready;
  wire params__valid;
  wire [31:0] requant_base;
  wire [31:0] \requant_base$74 ;
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
  wire [31:0] weight_base;
  wire [31:0] \weight_base$72 ;
  wire [31:0] weight_depth;
  wire [31:0] width;
  wire [31:0] \width$64 ;
  wire [31:0] words;
  assign rst = ~ aresetn;
  assign \$1  = | error;
  \macram_top.array  array (
    .base(param_base),
    .busy(busy),
    .c_in(c_in),
    .c_out(c_out),
    .clk(aclk),
    .cycles(cycles),
    .done(done),
    .drain_cycles(drain_cycles),
    .\error$633 (error),
    .fill_cycles(fill_cycles),
    .height(height),
    .i__payload(i__payload),
    .\i__payload$71 (params__payload),
    .i__ready(s_axis_tready),
    .i__valid(s_axis_tvalid),
    .\i__valid$75 (s_axis_param_tvalid),
    .input_stalls(input_stalls),
    .loading(s_axis_param_tready),
    .mac_cycles(mac_cycles),
    .mode(mode),
    .\o__payload$65 (o__payload),
    .\o__ready$67 (m_axis_tready),
    .\o__valid$69 (m_axis_tvalid),
    .output_stalls(output_stalls),
    .\port$1170$0 (command),
    .requant_base(requant_base),
    .rst(rst),
    .weight_base(weight_base),
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
    .loading(s_axis_param_tready),
    .mac_cycles(mac_cycles),
    .mode(mode),
    .output_stalls(output_stalls),
    .param_base(param_base),
    .param_words(words),
    .\port$1214$0 (done),
    .\port$1220$0 (error),
    .\port$2$0 (\$1 ),
    .requant_base(requant_base),
    .rst(rst),
    .weight_base(weight_base),
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
  assign \param_base$60  = param_base;
  assign \height$62  = height;
  assign \width$64  = width;
  assign \c_in$66  = c_in;
  assign \c_out$68  = c_out;
  assign \mode$70  = mode;
  assign \weight_base$72  = weight_base;
  assign \requant_base$74  = requant_base;
  assign \busy$76  = busy;
  assign loading = s_axis_param_tready;
  assign \loading$78  = s_axis_param_tready;
  assign status = { 28'h0000000, s_axis_param_tready, \$1 , done, busy };
  assign \error$82  = { 29'h00000000, error };
  assign \cycles$84  = cycles;
  assign \mac_cycles$86  = mac_cycles;
  assign \fill_cycles$88  = fill_cycles;
  assign \input_stalls$90  = input_stalls;
  assign \output_stalls$92  = output_stalls;
  assign \drain_cycles$94  = drain_cycles;
  assign geometry = 32'd67633216;
  assign formats = 32'd197379;
  assign weight_depth = 32'd1024;
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

module \macram_top.array (i__valid, \i__valid$75 , \o__ready$67 , rst, busy, i__ready, \o__valid$69 , i__payload, \i__payload$71 , \port$1170$0 , height, width, c_in, c_out, mode, words, base, weight_base, requant_base, done, \error$633 
, cycles, mac_cycles, fill_cycles, input_stalls, output_stalls, drain_cycles, \o__payload$65 , loading, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$1  = 0;
  wire \$1 ;
  wire [3:0] \$10 ;
  wire \$11 ;
  wire \$12 ;
  wire \$13 ;
  wire \$14 ;
  wire \$15 ;
  wire \$16 ;
  wire \$17 ;
  wire \$18 ;
  wire \$19 ;
  wire [10:0] \$2 ;
  wire \$20 ;
  wire \$21 ;
  wire \$22 ;
  wire \$23 ;
  wire [3:0] \$24 ;
  wire [3:0] \$25 ;
  wire \$26 ;
  wire \$27 ;
  wire [2:0] \$28 ;
  wire \$29 ;
  wire [10:0] \$3 ;
  wire \$30 ;
  wire \$31 ;
  wire \$32 ;
  wire \$33 ;
  wire \$34 ;
  wire \$35 ;
  wire \$36 ;
  wire \$37 ;
  wire \$38 ;
  wire [32:0] \$39 ;
  wire \$4 ;
  wire \$40 ;
  wire \$41 ;
  wire \$42 ;
  wire [32:0] \$43 ;
  wire [32:0] \$44 ;
  wire [32:0] \$45 ;
  wire [32:0] \$46 ;
  wire [32:0] \$47 ;
  reg [1:0] \$48 ;
  reg \$49 ;
  wire [31:0] \$5 ;
  reg \$50 ;
  reg \$51 ;
  reg [2:0] \$52 ;
  reg [7:0] \$53 ;
  reg [7:0] \$54 ;
  reg [7:0] \$55 ;
  reg [7:0] \$56 ;
  reg \$57 ;
  reg \$58 ;
  reg \$59 ;
  wire \$6 ;
  reg [31:0] \$60 ;
  reg [31:0] \$61 ;
  reg [31:0] \$62 ;
  reg [31:0] \$63 ;
  reg [31:0] \$64 ;
  reg [31:0] \$65 ;
  wire [9:0] \$66 ;
  wire [7:0] \$67 ;
  wire [671:0] \$68 ;
  wire \$7 ;
  wire \$8 ;
  wire [3:0] \$9 ;
  wire \$signal ;
  wire \$signal$29 ;
  wire \$signal$33 ;
  (* enum_base_type = "Error" *)
  (* enum_value_000 = "NONE" *)
  (* enum_value_001 = "BAD_SHAPE" *)
  (* enum_value_010 = "BAD_MODE" *)
  (* enum_value_011 = "TLAST_EARLY" *)
  (* enum_value_100 = "TLAST_MISSING" *)
  (* enum_value_101 = "BAD_COMMAND" *)
  (* enum_value_110 = "BAD_RANGE" *)
  reg [2:0] \$signal$35 ;
  wire \$signal$623 ;
  wire \$signal$625 ;
  reg \$signal$626  = 1'h0;
  reg \$signal$645  = 1'h0;
  wire [95:0] activations;
  wire [95:0] \activations$127 ;
  wire [95:0] \activations$136 ;
  wire [95:0] \activations$145 ;
  wire [95:0] \activations$154 ;
  wire [95:0] \activations$162 ;
  wire [95:0] \activations$170 ;
  wire [95:0] \activations$178 ;
  wire [95:0] \activations$186 ;
  wire [95:0] \activations$194 ;
  wire [95:0] \activations$202 ;
  wire [95:0] \activations$210 ;
  wire [95:0] \activations$218 ;
  wire [95:0] \activations$226 ;
  wire [95:0] \activations$234 ;
  wire [95:0] \activations$242 ;
  wire [95:0] \activations$250 ;
  wire [95:0] \activations$258 ;
  wire [95:0] \activations$266 ;
  wire [95:0] \activations$274 ;
  wire [95:0] \activations$282 ;
  wire [95:0] \activations$290 ;
  wire [95:0] \activations$298 ;
  wire [95:0] \activations$306 ;
  wire [95:0] \activations$314 ;
  wire [95:0] \activations$322 ;
  wire [95:0] \activations$330 ;
  wire [95:0] \activations$338 ;
  wire [95:0] \activations$346 ;
  wire [95:0] \activations$354 ;
  wire [95:0] \activations$362 ;
  wire [95:0] \activations$370 ;
  wire [95:0] \activations$378 ;
  wire [95:0] \activations$386 ;
  wire [95:0] \activations$394 ;
  wire [95:0] \activations$402 ;
  wire [95:0] \activations$410 ;
  wire [95:0] \activations$418 ;
  wire [95:0] \activations$426 ;
  wire [95:0] \activations$434 ;
  wire [95:0] \activations$442 ;
  wire [95:0] \activations$450 ;
  wire [95:0] \activations$458 ;
  wire [95:0] \activations$466 ;
  wire [95:0] \activations$474 ;
  wire [95:0] \activations$482 ;
  wire [95:0] \activations$490 ;
  wire [95:0] \activations$498 ;
  wire [95:0] \activations$506 ;
  wire [95:0] \activations$514 ;
  wire [95:0] \activations$522 ;
  wire [95:0] \activations$530 ;
  wire [95:0] \activations$538 ;
  wire [95:0] \activations$546 ;
  wire [95:0] \activations$554 ;
  wire [95:0] \activations$562 ;
  wire [95:0] \activations$570 ;
  wire [95:0] \activations$578 ;
  wire [95:0] \activations$586 ;
  wire [95:0] \activations$594 ;
  wire [95:0] \activations$602 ;
  wire [95:0] \activations$608 ;
  wire [95:0] \activations$614 ;
  wire [95:0] \activations$620 ;
  wire [9:0] address;
  wire [9:0] \address$124 ;
  wire [9:0] \address$133 ;
  wire [9:0] \address$142 ;
  wire [9:0] \address$151 ;
  wire [9:0] \address$159 ;
  wire [9:0] \address$167 ;
  wire [9:0] \address$175 ;
  wire [9:0] \address$183 ;
  wire [9:0] \address$191 ;
  wire [9:0] \address$199 ;
  wire [9:0] \address$207 ;
  wire [9:0] \address$215 ;
  wire [9:0] \address$223 ;
  wire [9:0] \address$231 ;
  wire [9:0] \address$239 ;
  wire [9:0] \address$247 ;
  wire [9:0] \address$255 ;
  wire [9:0] \address$263 ;
  wire [9:0] \address$271 ;
  wire [9:0] \address$279 ;
  wire [9:0] \address$287 ;
  wire [9:0] \address$295 ;
  wire [9:0] \address$303 ;
  wire [9:0] \address$311 ;
  wire [9:0] \address$319 ;
  wire [9:0] \address$327 ;
  wire [9:0] \address$335 ;
  wire [9:0] \address$343 ;
  wire [9:0] \address$351 ;
  wire [9:0] \address$359 ;
  wire [9:0] \address$367 ;
  wire [9:0] \address$375 ;
  wire [9:0] \address$383 ;
  wire [9:0] \address$391 ;
  wire [9:0] \address$399 ;
  wire [9:0] \address$407 ;
  wire [9:0] \address$415 ;
  wire [9:0] \address$423 ;
  wire [9:0] \address$431 ;
  wire [9:0] \address$439 ;
  wire [9:0] \address$447 ;
  wire [9:0] \address$455 ;
  wire [9:0] \address$463 ;
  wire [9:0] \address$471 ;
  wire [9:0] \address$479 ;
  wire [9:0] \address$487 ;
  wire [9:0] \address$495 ;
  wire [9:0] \address$503 ;
  wire [9:0] \address$511 ;
  wire [9:0] \address$519 ;
  wire [9:0] \address$527 ;
  wire [9:0] \address$535 ;
  wire [9:0] \address$543 ;
  wire [9:0] \address$551 ;
  wire [9:0] \address$559 ;
  wire [9:0] \address$567 ;
  wire [9:0] \address$575 ;
  wire [9:0] \address$583 ;
  wire [9:0] \address$591 ;
  wire [9:0] \address$599 ;
  wire [9:0] \address$605 ;
  wire [9:0] \address$611 ;
  wire [9:0] \address$617 ;
  input [31:0] base;
  wire [31:0] base;
  wire [15:0] beats_per_pixel;
  wire [15:0] \beats_per_pixel$87 ;
  wire blocked;
  output busy;
  wire busy;
  wire \busy$24 ;
  input [31:0] c_in;
  wire [31:0] c_in;
  wire [31:0] \c_in$5 ;
  input [31:0] c_out;
  wire [31:0] c_out;
  wire [31:0] \c_out$7 ;
  wire [75:0] chain_i;
  wire [75:0] \chain_i$131 ;
  wire [18:0] \chain_i$131[0] ;
  wire [18:0] \chain_i$131[1] ;
  wire [18:0] \chain_i$131[2] ;
  wire [18:0] \chain_i$131[3] ;
  wire [75:0] \chain_i$140 ;
  wire [18:0] \chain_i$140[0] ;
  wire [18:0] \chain_i$140[1] ;
  wire [18:0] \chain_i$140[2] ;
  wire [18:0] \chain_i$140[3] ;
  wire [75:0] \chain_i$149 ;
  wire [18:0] \chain_i$149[0] ;
  wire [18:0] \chain_i$149[1] ;
  wire [18:0] \chain_i$149[2] ;
  wire [18:0] \chain_i$149[3] ;
  wire [75:0] \chain_i$157 ;
  wire [18:0] \chain_i$157[0] ;
  wire [18:0] \chain_i$157[1] ;
  wire [18:0] \chain_i$157[2] ;
  wire [18:0] \chain_i$157[3] ;
  wire [75:0] \chain_i$165 ;
  wire [18:0] \chain_i$165[0] ;
  wire [18:0] \chain_i$165[1] ;
  wire [18:0] \chain_i$165[2] ;
  wire [18:0] \chain_i$165[3] ;
  wire [75:0] \chain_i$173 ;
  wire [18:0] \chain_i$173[0] ;
  wire [18:0] \chain_i$173[1] ;
  wire [18:0] \chain_i$173[2] ;
  wire [18:0] \chain_i$173[3] ;
  wire [75:0] \chain_i$181 ;
  wire [18:0] \chain_i$181[0] ;
  wire [18:0] \chain_i$181[1] ;
  wire [18:0] \chain_i$181[2] ;
  wire [18:0] \chain_i$181[3] ;
  wire [75:0] \chain_i$189 ;
  wire [18:0] \chain_i$189[0] ;
  wire [18:0] \chain_i$189[1] ;
  wire [18:0] \chain_i$189[2] ;
  wire [18:0] \chain_i$189[3] ;
  wire [75:0] \chain_i$197 ;
  wire [18:0] \chain_i$197[0] ;
  wire [18:0] \chain_i$197[1] ;
  wire [18:0] \chain_i$197[2] ;
  wire [18:0] \chain_i$197[3] ;
  wire [75:0] \chain_i$205 ;
  wire [18:0] \chain_i$205[0] ;
  wire [18:0] \chain_i$205[1] ;
  wire [18:0] \chain_i$205[2] ;
  wire [18:0] \chain_i$205[3] ;
  wire [75:0] \chain_i$213 ;
  wire [18:0] \chain_i$213[0] ;
  wire [18:0] \chain_i$213[1] ;
  wire [18:0] \chain_i$213[2] ;
  wire [18:0] \chain_i$213[3] ;
  wire [75:0] \chain_i$221 ;
  wire [18:0] \chain_i$221[0] ;
  wire [18:0] \chain_i$221[1] ;
  wire [18:0] \chain_i$221[2] ;
  wire [18:0] \chain_i$221[3] ;
  wire [75:0] \chain_i$229 ;
  wire [18:0] \chain_i$229[0] ;
  wire [18:0] \chain_i$229[1] ;
  wire [18:0] \chain_i$229[2] ;
  wire [18:0] \chain_i$229[3] ;
  wire [75:0] \chain_i$237 ;
  wire [18:0] \chain_i$237[0] ;
  wire [18:0] \chain_i$237[1] ;
  wire [18:0] \chain_i$237[2] ;
  wire [18:0] \chain_i$237[3] ;
  wire [75:0] \chain_i$245 ;
  wire [18:0] \chain_i$245[0] ;
  wire [18:0] \chain_i$245[1] ;
  wire [18:0] \chain_i$245[2] ;
  wire [18:0] \chain_i$245[3] ;
  wire [75:0] \chain_i$253 ;
  wire [18:0] \chain_i$253[0] ;
  wire [18:0] \chain_i$253[1] ;
  wire [18:0] \chain_i$253[2] ;
  wire [18:0] \chain_i$253[3] ;
  wire [75:0] \chain_i$261 ;
  wire [18:0] \chain_i$261[0] ;
  wire [18:0] \chain_i$261[1] ;
  wire [18:0] \chain_i$261[2] ;
  wire [18:0] \chain_i$261[3] ;
  wire [75:0] \chain_i$269 ;
  wire [18:0] \chain_i$269[0] ;
  wire [18:0] \chain_i$269[1] ;
  wire [18:0] \chain_i$269[2] ;
  wire [18:0] \chain_i$269[3] ;
  wire [75:0] \chain_i$277 ;
  wire [18:0] \chain_i$277[0] ;
  wire [18:0] \chain_i$277[1] ;
  wire [18:0] \chain_i$277[2] ;
  wire [18:0] \chain_i$277[3] ;
  wire [75:0] \chain_i$285 ;
  wire [18:0] \chain_i$285[0] ;
  wire [18:0] \chain_i$285[1] ;
  wire [18:0] \chain_i$285[2] ;
  wire [18:0] \chain_i$285[3] ;
  wire [75:0] \chain_i$293 ;
  wire [18:0] \chain_i$293[0] ;
  wire [18:0] \chain_i$293[1] ;
  wire [18:0] \chain_i$293[2] ;
  wire [18:0] \chain_i$293[3] ;
  wire [75:0] \chain_i$301 ;
  wire [18:0] \chain_i$301[0] ;
  wire [18:0] \chain_i$301[1] ;
  wire [18:0] \chain_i$301[2] ;
  wire [18:0] \chain_i$301[3] ;
  wire [75:0] \chain_i$309 ;
  wire [18:0] \chain_i$309[0] ;
  wire [18:0] \chain_i$309[1] ;
  wire [18:0] \chain_i$309[2] ;
  wire [18:0] \chain_i$309[3] ;
  wire [75:0] \chain_i$317 ;
  wire [18:0] \chain_i$317[0] ;
  wire [18:0] \chain_i$317[1] ;
  wire [18:0] \chain_i$317[2] ;
  wire [18:0] \chain_i$317[3] ;
  wire [75:0] \chain_i$325 ;
  wire [18:0] \chain_i$325[0] ;
  wire [18:0] \chain_i$325[1] ;
  wire [18:0] \chain_i$325[2] ;
  wire [18:0] \chain_i$325[3] ;
  wire [75:0] \chain_i$333 ;
  wire [18:0] \chain_i$333[0] ;
  wire [18:0] \chain_i$333[1] ;
  wire [18:0] \chain_i$333[2] ;
  wire [18:0] \chain_i$333[3] ;
  wire [75:0] \chain_i$341 ;
  wire [18:0] \chain_i$341[0] ;
  wire [18:0] \chain_i$341[1] ;
  wire [18:0] \chain_i$341[2] ;
  wire [18:0] \chain_i$341[3] ;
  wire [75:0] \chain_i$349 ;
  wire [18:0] \chain_i$349[0] ;
  wire [18:0] \chain_i$349[1] ;
  wire [18:0] \chain_i$349[2] ;
  wire [18:0] \chain_i$349[3] ;
  wire [75:0] \chain_i$357 ;
  wire [18:0] \chain_i$357[0] ;
  wire [18:0] \chain_i$357[1] ;
  wire [18:0] \chain_i$357[2] ;
  wire [18:0] \chain_i$357[3] ;
  wire [75:0] \chain_i$365 ;
  wire [18:0] \chain_i$365[0] ;
  wire [18:0] \chain_i$365[1] ;
  wire [18:0] \chain_i$365[2] ;
  wire [18:0] \chain_i$365[3] ;
  wire [75:0] \chain_i$373 ;
  wire [18:0] \chain_i$373[0] ;
  wire [18:0] \chain_i$373[1] ;
  wire [18:0] \chain_i$373[2] ;
  wire [18:0] \chain_i$373[3] ;
  wire [75:0] \chain_i$381 ;
  wire [18:0] \chain_i$381[0] ;
  wire [18:0] \chain_i$381[1] ;
  wire [18:0] \chain_i$381[2] ;
  wire [18:0] \chain_i$381[3] ;
  wire [75:0] \chain_i$389 ;
  wire [18:0] \chain_i$389[0] ;
  wire [18:0] \chain_i$389[1] ;
  wire [18:0] \chain_i$389[2] ;
  wire [18:0] \chain_i$389[3] ;
  wire [75:0] \chain_i$397 ;
  wire [18:0] \chain_i$397[0] ;
  wire [18:0] \chain_i$397[1] ;
  wire [18:0] \chain_i$397[2] ;
  wire [18:0] \chain_i$397[3] ;
  wire [75:0] \chain_i$405 ;
  wire [18:0] \chain_i$405[0] ;
  wire [18:0] \chain_i$405[1] ;
  wire [18:0] \chain_i$405[2] ;
  wire [18:0] \chain_i$405[3] ;
  wire [75:0] \chain_i$413 ;
  wire [18:0] \chain_i$413[0] ;
  wire [18:0] \chain_i$413[1] ;
  wire [18:0] \chain_i$413[2] ;
  wire [18:0] \chain_i$413[3] ;
  wire [75:0] \chain_i$421 ;
  wire [18:0] \chain_i$421[0] ;
  wire [18:0] \chain_i$421[1] ;
  wire [18:0] \chain_i$421[2] ;
  wire [18:0] \chain_i$421[3] ;
  wire [75:0] \chain_i$429 ;
  wire [18:0] \chain_i$429[0] ;
  wire [18:0] \chain_i$429[1] ;
  wire [18:0] \chain_i$429[2] ;
  wire [18:0] \chain_i$429[3] ;
  wire [75:0] \chain_i$437 ;
  wire [18:0] \chain_i$437[0] ;
  wire [18:0] \chain_i$437[1] ;
  wire [18:0] \chain_i$437[2] ;
  wire [18:0] \chain_i$437[3] ;
  wire [75:0] \chain_i$445 ;
  wire [18:0] \chain_i$445[0] ;
  wire [18:0] \chain_i$445[1] ;
  wire [18:0] \chain_i$445[2] ;
  wire [18:0] \chain_i$445[3] ;
  wire [75:0] \chain_i$453 ;
  wire [18:0] \chain_i$453[0] ;
  wire [18:0] \chain_i$453[1] ;
  wire [18:0] \chain_i$453[2] ;
  wire [18:0] \chain_i$453[3] ;
  wire [75:0] \chain_i$461 ;
  wire [18:0] \chain_i$461[0] ;
  wire [18:0] \chain_i$461[1] ;
  wire [18:0] \chain_i$461[2] ;
  wire [18:0] \chain_i$461[3] ;
  wire [75:0] \chain_i$469 ;
  wire [18:0] \chain_i$469[0] ;
  wire [18:0] \chain_i$469[1] ;
  wire [18:0] \chain_i$469[2] ;
  wire [18:0] \chain_i$469[3] ;
  wire [75:0] \chain_i$477 ;
  wire [18:0] \chain_i$477[0] ;
  wire [18:0] \chain_i$477[1] ;
  wire [18:0] \chain_i$477[2] ;
  wire [18:0] \chain_i$477[3] ;
  wire [75:0] \chain_i$485 ;
  wire [18:0] \chain_i$485[0] ;
  wire [18:0] \chain_i$485[1] ;
  wire [18:0] \chain_i$485[2] ;
  wire [18:0] \chain_i$485[3] ;
  wire [75:0] \chain_i$493 ;
  wire [18:0] \chain_i$493[0] ;
  wire [18:0] \chain_i$493[1] ;
  wire [18:0] \chain_i$493[2] ;
  wire [18:0] \chain_i$493[3] ;
  wire [75:0] \chain_i$501 ;
  wire [18:0] \chain_i$501[0] ;
  wire [18:0] \chain_i$501[1] ;
  wire [18:0] \chain_i$501[2] ;
  wire [18:0] \chain_i$501[3] ;
  wire [75:0] \chain_i$509 ;
  wire [18:0] \chain_i$509[0] ;
  wire [18:0] \chain_i$509[1] ;
  wire [18:0] \chain_i$509[2] ;
  wire [18:0] \chain_i$509[3] ;
  wire [75:0] \chain_i$517 ;
  wire [18:0] \chain_i$517[0] ;
  wire [18:0] \chain_i$517[1] ;
  wire [18:0] \chain_i$517[2] ;
  wire [18:0] \chain_i$517[3] ;
  wire [75:0] \chain_i$525 ;
  wire [18:0] \chain_i$525[0] ;
  wire [18:0] \chain_i$525[1] ;
  wire [18:0] \chain_i$525[2] ;
  wire [18:0] \chain_i$525[3] ;
  wire [75:0] \chain_i$533 ;
  wire [18:0] \chain_i$533[0] ;
  wire [18:0] \chain_i$533[1] ;
  wire [18:0] \chain_i$533[2] ;
  wire [18:0] \chain_i$533[3] ;
  wire [75:0] \chain_i$541 ;
  wire [18:0] \chain_i$541[0] ;
  wire [18:0] \chain_i$541[1] ;
  wire [18:0] \chain_i$541[2] ;
  wire [18:0] \chain_i$541[3] ;
  wire [75:0] \chain_i$549 ;
  wire [18:0] \chain_i$549[0] ;
  wire [18:0] \chain_i$549[1] ;
  wire [18:0] \chain_i$549[2] ;
  wire [18:0] \chain_i$549[3] ;
  wire [75:0] \chain_i$557 ;
  wire [18:0] \chain_i$557[0] ;
  wire [18:0] \chain_i$557[1] ;
  wire [18:0] \chain_i$557[2] ;
  wire [18:0] \chain_i$557[3] ;
  wire [75:0] \chain_i$565 ;
  wire [18:0] \chain_i$565[0] ;
  wire [18:0] \chain_i$565[1] ;
  wire [18:0] \chain_i$565[2] ;
  wire [18:0] \chain_i$565[3] ;
  wire [75:0] \chain_i$573 ;
  wire [18:0] \chain_i$573[0] ;
  wire [18:0] \chain_i$573[1] ;
  wire [18:0] \chain_i$573[2] ;
  wire [18:0] \chain_i$573[3] ;
  wire [75:0] \chain_i$581 ;
  wire [18:0] \chain_i$581[0] ;
  wire [18:0] \chain_i$581[1] ;
  wire [18:0] \chain_i$581[2] ;
  wire [18:0] \chain_i$581[3] ;
  wire [75:0] \chain_i$589 ;
  wire [18:0] \chain_i$589[0] ;
  wire [18:0] \chain_i$589[1] ;
  wire [18:0] \chain_i$589[2] ;
  wire [18:0] \chain_i$589[3] ;
  wire [75:0] \chain_i$597 ;
  wire [18:0] \chain_i$597[0] ;
  wire [18:0] \chain_i$597[1] ;
  wire [18:0] \chain_i$597[2] ;
  wire [18:0] \chain_i$597[3] ;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  wire [75:0] chain_o;
  wire [75:0] \chain_o$123 ;
  wire [18:0] \chain_o$123[0] ;
  wire [18:0] \chain_o$123[1] ;
  wire [18:0] \chain_o$123[2] ;
  wire [18:0] \chain_o$123[3] ;
  wire [75:0] \chain_o$130 ;
  wire [18:0] \chain_o$130[0] ;
  wire [18:0] \chain_o$130[1] ;
  wire [18:0] \chain_o$130[2] ;
  wire [18:0] \chain_o$130[3] ;
  wire [75:0] \chain_o$132 ;
  wire [18:0] \chain_o$132[0] ;
  wire [18:0] \chain_o$132[1] ;
  wire [18:0] \chain_o$132[2] ;
  wire [18:0] \chain_o$132[3] ;
  wire [75:0] \chain_o$139 ;
  wire [18:0] \chain_o$139[0] ;
  wire [18:0] \chain_o$139[1] ;
  wire [18:0] \chain_o$139[2] ;
  wire [18:0] \chain_o$139[3] ;
  wire [75:0] \chain_o$141 ;
  wire [18:0] \chain_o$141[0] ;
  wire [18:0] \chain_o$141[1] ;
  wire [18:0] \chain_o$141[2] ;
  wire [18:0] \chain_o$141[3] ;
  wire [75:0] \chain_o$148 ;
  wire [18:0] \chain_o$148[0] ;
  wire [18:0] \chain_o$148[1] ;
  wire [18:0] \chain_o$148[2] ;
  wire [18:0] \chain_o$148[3] ;
  wire [75:0] \chain_o$150 ;
  wire [18:0] \chain_o$150[0] ;
  wire [18:0] \chain_o$150[1] ;
  wire [18:0] \chain_o$150[2] ;
  wire [18:0] \chain_o$150[3] ;
  wire [75:0] \chain_o$158 ;
  wire [18:0] \chain_o$158[0] ;
  wire [18:0] \chain_o$158[1] ;
  wire [18:0] \chain_o$158[2] ;
  wire [18:0] \chain_o$158[3] ;
  wire [75:0] \chain_o$166 ;
  wire [18:0] \chain_o$166[0] ;
  wire [18:0] \chain_o$166[1] ;
  wire [18:0] \chain_o$166[2] ;
  wire [18:0] \chain_o$166[3] ;
  wire [75:0] \chain_o$174 ;
  wire [18:0] \chain_o$174[0] ;
  wire [18:0] \chain_o$174[1] ;
  wire [18:0] \chain_o$174[2] ;
  wire [18:0] \chain_o$174[3] ;
  wire [75:0] \chain_o$182 ;
  wire [18:0] \chain_o$182[0] ;
  wire [18:0] \chain_o$182[1] ;
  wire [18:0] \chain_o$182[2] ;
  wire [18:0] \chain_o$182[3] ;
  wire [75:0] \chain_o$190 ;
  wire [18:0] \chain_o$190[0] ;
  wire [18:0] \chain_o$190[1] ;
  wire [18:0] \chain_o$190[2] ;
  wire [18:0] \chain_o$190[3] ;
  wire [75:0] \chain_o$198 ;
  wire [18:0] \chain_o$198[0] ;
  wire [18:0] \chain_o$198[1] ;
  wire [18:0] \chain_o$198[2] ;
  wire [18:0] \chain_o$198[3] ;
  wire [75:0] \chain_o$206 ;
  wire [18:0] \chain_o$206[0] ;
  wire [18:0] \chain_o$206[1] ;
  wire [18:0] \chain_o$206[2] ;
  wire [18:0] \chain_o$206[3] ;
  wire [75:0] \chain_o$214 ;
  wire [18:0] \chain_o$214[0] ;
  wire [18:0] \chain_o$214[1] ;
  wire [18:0] \chain_o$214[2] ;
  wire [18:0] \chain_o$214[3] ;
  wire [75:0] \chain_o$222 ;
  wire [18:0] \chain_o$222[0] ;
  wire [18:0] \chain_o$222[1] ;
  wire [18:0] \chain_o$222[2] ;
  wire [18:0] \chain_o$222[3] ;
  wire [75:0] \chain_o$230 ;
  wire [18:0] \chain_o$230[0] ;
  wire [18:0] \chain_o$230[1] ;
  wire [18:0] \chain_o$230[2] ;
  wire [18:0] \chain_o$230[3] ;
  wire [75:0] \chain_o$238 ;
  wire [18:0] \chain_o$238[0] ;
  wire [18:0] \chain_o$238[1] ;
  wire [18:0] \chain_o$238[2] ;
  wire [18:0] \chain_o$238[3] ;
  wire [75:0] \chain_o$246 ;
  wire [18:0] \chain_o$246[0] ;
  wire [18:0] \chain_o$246[1] ;
  wire [18:0] \chain_o$246[2] ;
  wire [18:0] \chain_o$246[3] ;
  wire [75:0] \chain_o$254 ;
  wire [18:0] \chain_o$254[0] ;
  wire [18:0] \chain_o$254[1] ;
  wire [18:0] \chain_o$254[2] ;
  wire [18:0] \chain_o$254[3] ;
  wire [75:0] \chain_o$262 ;
  wire [18:0] \chain_o$262[0] ;
  wire [18:0] \chain_o$262[1] ;
  wire [18:0] \chain_o$262[2] ;
  wire [18:0] \chain_o$262[3] ;
  wire [75:0] \chain_o$270 ;
  wire [18:0] \chain_o$270[0] ;
  wire [18:0] \chain_o$270[1] ;
  wire [18:0] \chain_o$270[2] ;
  wire [18:0] \chain_o$270[3] ;
  wire [75:0] \chain_o$278 ;
  wire [18:0] \chain_o$278[0] ;
  wire [18:0] \chain_o$278[1] ;
  wire [18:0] \chain_o$278[2] ;
  wire [18:0] \chain_o$278[3] ;
  wire [75:0] \chain_o$286 ;
  wire [18:0] \chain_o$286[0] ;
  wire [18:0] \chain_o$286[1] ;
  wire [18:0] \chain_o$286[2] ;
  wire [18:0] \chain_o$286[3] ;
  wire [75:0] \chain_o$294 ;
  wire [18:0] \chain_o$294[0] ;
  wire [18:0] \chain_o$294[1] ;
  wire [18:0] \chain_o$294[2] ;
  wire [18:0] \chain_o$294[3] ;
  wire [75:0] \chain_o$302 ;
  wire [18:0] \chain_o$302[0] ;
  wire [18:0] \chain_o$302[1] ;
  wire [18:0] \chain_o$302[2] ;
  wire [18:0] \chain_o$302[3] ;
  wire [75:0] \chain_o$310 ;
  wire [18:0] \chain_o$310[0] ;
  wire [18:0] \chain_o$310[1] ;
  wire [18:0] \chain_o$310[2] ;
  wire [18:0] \chain_o$310[3] ;
  wire [75:0] \chain_o$318 ;
  wire [18:0] \chain_o$318[0] ;
  wire [18:0] \chain_o$318[1] ;
  wire [18:0] \chain_o$318[2] ;
  wire [18:0] \chain_o$318[3] ;
  wire [75:0] \chain_o$326 ;
  wire [18:0] \chain_o$326[0] ;
  wire [18:0] \chain_o$326[1] ;
  wire [18:0] \chain_o$326[2] ;
  wire [18:0] \chain_o$326[3] ;
  wire [75:0] \chain_o$334 ;
  wire [18:0] \chain_o$334[0] ;
  wire [18:0] \chain_o$334[1] ;
  wire [18:0] \chain_o$334[2] ;
  wire [18:0] \chain_o$334[3] ;
  wire [75:0] \chain_o$342 ;
  wire [18:0] \chain_o$342[0] ;
  wire [18:0] \chain_o$342[1] ;
  wire [18:0] \chain_o$342[2] ;
  wire [18:0] \chain_o$342[3] ;
  wire [75:0] \chain_o$350 ;
  wire [18:0] \chain_o$350[0] ;
  wire [18:0] \chain_o$350[1] ;
  wire [18:0] \chain_o$350[2] ;
  wire [18:0] \chain_o$350[3] ;
  wire [75:0] \chain_o$358 ;
  wire [18:0] \chain_o$358[0] ;
  wire [18:0] \chain_o$358[1] ;
  wire [18:0] \chain_o$358[2] ;
  wire [18:0] \chain_o$358[3] ;
  wire [75:0] \chain_o$366 ;
  wire [18:0] \chain_o$366[0] ;
  wire [18:0] \chain_o$366[1] ;
  wire [18:0] \chain_o$366[2] ;
  wire [18:0] \chain_o$366[3] ;
  wire [75:0] \chain_o$374 ;
  wire [18:0] \chain_o$374[0] ;
  wire [18:0] \chain_o$374[1] ;
  wire [18:0] \chain_o$374[2] ;
  wire [18:0] \chain_o$374[3] ;
  wire [75:0] \chain_o$382 ;
  wire [18:0] \chain_o$382[0] ;
  wire [18:0] \chain_o$382[1] ;
  wire [18:0] \chain_o$382[2] ;
  wire [18:0] \chain_o$382[3] ;
  wire [75:0] \chain_o$390 ;
  wire [18:0] \chain_o$390[0] ;
  wire [18:0] \chain_o$390[1] ;
  wire [18:0] \chain_o$390[2] ;
  wire [18:0] \chain_o$390[3] ;
  wire [75:0] \chain_o$398 ;
  wire [18:0] \chain_o$398[0] ;
  wire [18:0] \chain_o$398[1] ;
  wire [18:0] \chain_o$398[2] ;
  wire [18:0] \chain_o$398[3] ;
  wire [75:0] \chain_o$406 ;
  wire [18:0] \chain_o$406[0] ;
  wire [18:0] \chain_o$406[1] ;
  wire [18:0] \chain_o$406[2] ;
  wire [18:0] \chain_o$406[3] ;
  wire [75:0] \chain_o$414 ;
  wire [18:0] \chain_o$414[0] ;
  wire [18:0] \chain_o$414[1] ;
  wire [18:0] \chain_o$414[2] ;
  wire [18:0] \chain_o$414[3] ;
  wire [75:0] \chain_o$422 ;
  wire [18:0] \chain_o$422[0] ;
  wire [18:0] \chain_o$422[1] ;
  wire [18:0] \chain_o$422[2] ;
  wire [18:0] \chain_o$422[3] ;
  wire [75:0] \chain_o$430 ;
  wire [18:0] \chain_o$430[0] ;
  wire [18:0] \chain_o$430[1] ;
  wire [18:0] \chain_o$430[2] ;
  wire [18:0] \chain_o$430[3] ;
  wire [75:0] \chain_o$438 ;
  wire [18:0] \chain_o$438[0] ;
  wire [18:0] \chain_o$438[1] ;
  wire [18:0] \chain_o$438[2] ;
  wire [18:0] \chain_o$438[3] ;
  wire [75:0] \chain_o$446 ;
  wire [18:0] \chain_o$446[0] ;
  wire [18:0] \chain_o$446[1] ;
  wire [18:0] \chain_o$446[2] ;
  wire [18:0] \chain_o$446[3] ;
  wire [75:0] \chain_o$454 ;
  wire [18:0] \chain_o$454[0] ;
  wire [18:0] \chain_o$454[1] ;
  wire [18:0] \chain_o$454[2] ;
  wire [18:0] \chain_o$454[3] ;
  wire [75:0] \chain_o$462 ;
  wire [18:0] \chain_o$462[0] ;
  wire [18:0] \chain_o$462[1] ;
  wire [18:0] \chain_o$462[2] ;
  wire [18:0] \chain_o$462[3] ;
  wire [75:0] \chain_o$470 ;
  wire [18:0] \chain_o$470[0] ;
  wire [18:0] \chain_o$470[1] ;
  wire [18:0] \chain_o$470[2] ;
  wire [18:0] \chain_o$470[3] ;
  wire [75:0] \chain_o$478 ;
  wire [18:0] \chain_o$478[0] ;
  wire [18:0] \chain_o$478[1] ;
  wire [18:0] \chain_o$478[2] ;
  wire [18:0] \chain_o$478[3] ;
  wire [75:0] \chain_o$486 ;
  wire [18:0] \chain_o$486[0] ;
  wire [18:0] \chain_o$486[1] ;
  wire [18:0] \chain_o$486[2] ;
  wire [18:0] \chain_o$486[3] ;
  wire [75:0] \chain_o$494 ;
  wire [18:0] \chain_o$494[0] ;
  wire [18:0] \chain_o$494[1] ;
  wire [18:0] \chain_o$494[2] ;
  wire [18:0] \chain_o$494[3] ;
  wire [75:0] \chain_o$502 ;
  wire [18:0] \chain_o$502[0] ;
  wire [18:0] \chain_o$502[1] ;
  wire [18:0] \chain_o$502[2] ;
  wire [18:0] \chain_o$502[3] ;
  wire [75:0] \chain_o$510 ;
  wire [18:0] \chain_o$510[0] ;
  wire [18:0] \chain_o$510[1] ;
  wire [18:0] \chain_o$510[2] ;
  wire [18:0] \chain_o$510[3] ;
  wire [75:0] \chain_o$518 ;
  wire [18:0] \chain_o$518[0] ;
  wire [18:0] \chain_o$518[1] ;
  wire [18:0] \chain_o$518[2] ;
  wire [18:0] \chain_o$518[3] ;
  wire [75:0] \chain_o$526 ;
  wire [18:0] \chain_o$526[0] ;
  wire [18:0] \chain_o$526[1] ;
  wire [18:0] \chain_o$526[2] ;
  wire [18:0] \chain_o$526[3] ;
  wire [75:0] \chain_o$534 ;
  wire [18:0] \chain_o$534[0] ;
  wire [18:0] \chain_o$534[1] ;
  wire [18:0] \chain_o$534[2] ;
  wire [18:0] \chain_o$534[3] ;
  wire [75:0] \chain_o$542 ;
  wire [18:0] \chain_o$542[0] ;
  wire [18:0] \chain_o$542[1] ;
  wire [18:0] \chain_o$542[2] ;
  wire [18:0] \chain_o$542[3] ;
  wire [75:0] \chain_o$550 ;
  wire [18:0] \chain_o$550[0] ;
  wire [18:0] \chain_o$550[1] ;
  wire [18:0] \chain_o$550[2] ;
  wire [18:0] \chain_o$550[3] ;
  wire [75:0] \chain_o$558 ;
  wire [18:0] \chain_o$558[0] ;
  wire [18:0] \chain_o$558[1] ;
  wire [18:0] \chain_o$558[2] ;
  wire [18:0] \chain_o$558[3] ;
  wire [75:0] \chain_o$566 ;
  wire [18:0] \chain_o$566[0] ;
  wire [18:0] \chain_o$566[1] ;
  wire [18:0] \chain_o$566[2] ;
  wire [18:0] \chain_o$566[3] ;
  wire [75:0] \chain_o$574 ;
  wire [18:0] \chain_o$574[0] ;
  wire [18:0] \chain_o$574[1] ;
  wire [18:0] \chain_o$574[2] ;
  wire [18:0] \chain_o$574[3] ;
  wire [75:0] \chain_o$582 ;
  wire [18:0] \chain_o$582[0] ;
  wire [18:0] \chain_o$582[1] ;
  wire [18:0] \chain_o$582[2] ;
  wire [18:0] \chain_o$582[3] ;
  wire [75:0] \chain_o$590 ;
  wire [18:0] \chain_o$590[0] ;
  wire [18:0] \chain_o$590[1] ;
  wire [18:0] \chain_o$590[2] ;
  wire [18:0] \chain_o$590[3] ;
  wire [75:0] \chain_o$598 ;
  wire [18:0] \chain_o$598[0] ;
  wire [18:0] \chain_o$598[1] ;
  wire [18:0] \chain_o$598[2] ;
  wire [18:0] \chain_o$598[3] ;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [2:0] command;
  (* init = 8'h00 *)
  wire [7:0] control;
  (* init = 8'h00 *)
  wire [7:0] \control$128 ;
  wire \control$128.edge ;
  wire \control$128.en ;
  wire \control$128.first ;
  wire \control$128.last ;
  wire [3:0] \control$128.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$137 ;
  wire \control$137.edge ;
  wire \control$137.en ;
  wire \control$137.first ;
  wire \control$137.last ;
  wire [3:0] \control$137.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$146 ;
  wire \control$146.edge ;
  wire \control$146.en ;
  wire \control$146.first ;
  wire \control$146.last ;
  wire [3:0] \control$146.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$155 ;
  wire \control$155.edge ;
  wire \control$155.en ;
  wire \control$155.first ;
  wire \control$155.last ;
  wire [3:0] \control$155.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$163 ;
  wire \control$163.edge ;
  wire \control$163.en ;
  wire \control$163.first ;
  wire \control$163.last ;
  wire [3:0] \control$163.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$171 ;
  wire \control$171.edge ;
  wire \control$171.en ;
  wire \control$171.first ;
  wire \control$171.last ;
  wire [3:0] \control$171.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$179 ;
  wire \control$179.edge ;
  wire \control$179.en ;
  wire \control$179.first ;
  wire \control$179.last ;
  wire [3:0] \control$179.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$187 ;
  wire \control$187.edge ;
  wire \control$187.en ;
  wire \control$187.first ;
  wire \control$187.last ;
  wire [3:0] \control$187.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$195 ;
  wire \control$195.edge ;
  wire \control$195.en ;
  wire \control$195.first ;
  wire \control$195.last ;
  wire [3:0] \control$195.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$203 ;
  wire \control$203.edge ;
  wire \control$203.en ;
  wire \control$203.first ;
  wire \control$203.last ;
  wire [3:0] \control$203.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$211 ;
  wire \control$211.edge ;
  wire \control$211.en ;
  wire \control$211.first ;
  wire \control$211.last ;
  wire [3:0] \control$211.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$219 ;
  wire \control$219.edge ;
  wire \control$219.en ;
  wire \control$219.first ;
  wire \control$219.last ;
  wire [3:0] \control$219.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$227 ;
  wire \control$227.edge ;
  wire \control$227.en ;
  wire \control$227.first ;
  wire \control$227.last ;
  wire [3:0] \control$227.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$235 ;
  wire \control$235.edge ;
  wire \control$235.en ;
  wire \control$235.first ;
  wire \control$235.last ;
  wire [3:0] \control$235.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$243 ;
  wire \control$243.edge ;
  wire \control$243.en ;
  wire \control$243.first ;
  wire \control$243.last ;
  wire [3:0] \control$243.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$251 ;
  wire \control$251.edge ;
  wire \control$251.en ;
  wire \control$251.first ;
  wire \control$251.last ;
  wire [3:0] \control$251.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$259 ;
  wire \control$259.edge ;
  wire \control$259.en ;
  wire \control$259.first ;
  wire \control$259.last ;
  wire [3:0] \control$259.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$267 ;
  wire \control$267.edge ;
  wire \control$267.en ;
  wire \control$267.first ;
  wire \control$267.last ;
  wire [3:0] \control$267.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$275 ;
  wire \control$275.edge ;
  wire \control$275.en ;
  wire \control$275.first ;
  wire \control$275.last ;
  wire [3:0] \control$275.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$283 ;
  wire \control$283.edge ;
  wire \control$283.en ;
  wire \control$283.first ;
  wire \control$283.last ;
  wire [3:0] \control$283.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$291 ;
  wire \control$291.edge ;
  wire \control$291.en ;
  wire \control$291.first ;
  wire \control$291.last ;
  wire [3:0] \control$291.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$299 ;
  wire \control$299.edge ;
  wire \control$299.en ;
  wire \control$299.first ;
  wire \control$299.last ;
  wire [3:0] \control$299.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$307 ;
  wire \control$307.edge ;
  wire \control$307.en ;
  wire \control$307.first ;
  wire \control$307.last ;
  wire [3:0] \control$307.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$315 ;
  wire \control$315.edge ;
  wire \control$315.en ;
  wire \control$315.first ;
  wire \control$315.last ;
  wire [3:0] \control$315.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$323 ;
  wire \control$323.edge ;
  wire \control$323.en ;
  wire \control$323.first ;
  wire \control$323.last ;
  wire [3:0] \control$323.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$331 ;
  wire \control$331.edge ;
  wire \control$331.en ;
  wire \control$331.first ;
  wire \control$331.last ;
  wire [3:0] \control$331.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$339 ;
  wire \control$339.edge ;
  wire \control$339.en ;
  wire \control$339.first ;
  wire \control$339.last ;
  wire [3:0] \control$339.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$347 ;
  wire \control$347.edge ;
  wire \control$347.en ;
  wire \control$347.first ;
  wire \control$347.last ;
  wire [3:0] \control$347.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$355 ;
  wire \control$355.edge ;
  wire \control$355.en ;
  wire \control$355.first ;
  wire \control$355.last ;
  wire [3:0] \control$355.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$363 ;
  wire \control$363.edge ;
  wire \control$363.en ;
  wire \control$363.first ;
  wire \control$363.last ;
  wire [3:0] \control$363.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$371 ;
  wire \control$371.edge ;
  wire \control$371.en ;
  wire \control$371.first ;
  wire \control$371.last ;
  wire [3:0] \control$371.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$379 ;
  wire \control$379.edge ;
  wire \control$379.en ;
  wire \control$379.first ;
  wire \control$379.last ;
  wire [3:0] \control$379.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$387 ;
  wire \control$387.edge ;
  wire \control$387.en ;
  wire \control$387.first ;
  wire \control$387.last ;
  wire [3:0] \control$387.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$395 ;
  wire \control$395.edge ;
  wire \control$395.en ;
  wire \control$395.first ;
  wire \control$395.last ;
  wire [3:0] \control$395.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$403 ;
  wire \control$403.edge ;
  wire \control$403.en ;
  wire \control$403.first ;
  wire \control$403.last ;
  wire [3:0] \control$403.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$411 ;
  wire \control$411.edge ;
  wire \control$411.en ;
  wire \control$411.first ;
  wire \control$411.last ;
  wire [3:0] \control$411.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$419 ;
  wire \control$419.edge ;
  wire \control$419.en ;
  wire \control$419.first ;
  wire \control$419.last ;
  wire [3:0] \control$419.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$427 ;
  wire \control$427.edge ;
  wire \control$427.en ;
  wire \control$427.first ;
  wire \control$427.last ;
  wire [3:0] \control$427.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$435 ;
  wire \control$435.edge ;
  wire \control$435.en ;
  wire \control$435.first ;
  wire \control$435.last ;
  wire [3:0] \control$435.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$443 ;
  wire \control$443.edge ;
  wire \control$443.en ;
  wire \control$443.first ;
  wire \control$443.last ;
  wire [3:0] \control$443.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$451 ;
  wire \control$451.edge ;
  wire \control$451.en ;
  wire \control$451.first ;
  wire \control$451.last ;
  wire [3:0] \control$451.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$459 ;
  wire \control$459.edge ;
  wire \control$459.en ;
  wire \control$459.first ;
  wire \control$459.last ;
  wire [3:0] \control$459.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$467 ;
  wire \control$467.edge ;
  wire \control$467.en ;
  wire \control$467.first ;
  wire \control$467.last ;
  wire [3:0] \control$467.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$475 ;
  wire \control$475.edge ;
  wire \control$475.en ;
  wire \control$475.first ;
  wire \control$475.last ;
  wire [3:0] \control$475.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$483 ;
  wire \control$483.edge ;
  wire \control$483.en ;
  wire \control$483.first ;
  wire \control$483.last ;
  wire [3:0] \control$483.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$491 ;
  wire \control$491.edge ;
  wire \control$491.en ;
  wire \control$491.first ;
  wire \control$491.last ;
  wire [3:0] \control$491.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$499 ;
  wire \control$499.edge ;
  wire \control$499.en ;
  wire \control$499.first ;
  wire \control$499.last ;
  wire [3:0] \control$499.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$507 ;
  wire \control$507.edge ;
  wire \control$507.en ;
  wire \control$507.first ;
  wire \control$507.last ;
  wire [3:0] \control$507.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$515 ;
  wire \control$515.edge ;
  wire \control$515.en ;
  wire \control$515.first ;
  wire \control$515.last ;
  wire [3:0] \control$515.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$523 ;
  wire \control$523.edge ;
  wire \control$523.en ;
  wire \control$523.first ;
  wire \control$523.last ;
  wire [3:0] \control$523.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$531 ;
  wire \control$531.edge ;
  wire \control$531.en ;
  wire \control$531.first ;
  wire \control$531.last ;
  wire [3:0] \control$531.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$539 ;
  wire \control$539.edge ;
  wire \control$539.en ;
  wire \control$539.first ;
  wire \control$539.last ;
  wire [3:0] \control$539.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$547 ;
  wire \control$547.edge ;
  wire \control$547.en ;
  wire \control$547.first ;
  wire \control$547.last ;
  wire [3:0] \control$547.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$555 ;
  wire \control$555.edge ;
  wire \control$555.en ;
  wire \control$555.first ;
  wire \control$555.last ;
  wire [3:0] \control$555.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$563 ;
  wire \control$563.edge ;
  wire \control$563.en ;
  wire \control$563.first ;
  wire \control$563.last ;
  wire [3:0] \control$563.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$571 ;
  wire \control$571.edge ;
  wire \control$571.en ;
  wire \control$571.first ;
  wire \control$571.last ;
  wire [3:0] \control$571.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$579 ;
  wire \control$579.edge ;
  wire \control$579.en ;
  wire \control$579.first ;
  wire \control$579.last ;
  wire [3:0] \control$579.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$587 ;
  wire \control$587.edge ;
  wire \control$587.en ;
  wire \control$587.first ;
  wire \control$587.last ;
  wire [3:0] \control$587.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$595 ;
  wire \control$595.edge ;
  wire \control$595.en ;
  wire \control$595.first ;
  wire \control$595.last ;
  wire [3:0] \control$595.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$603 ;
  wire \control$603.edge ;
  wire \control$603.en ;
  wire \control$603.first ;
  wire \control$603.last ;
  wire [3:0] \control$603.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$609 ;
  wire \control$609.edge ;
  wire \control$609.en ;
  wire \control$609.first ;
  wire \control$609.last ;
  wire [3:0] \control$609.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$615 ;
  wire \control$615.edge ;
  wire \control$615.en ;
  wire \control$615.first ;
  wire \control$615.last ;
  wire [3:0] \control$615.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$621 ;
  wire \control$621.edge ;
  wire \control$621.en ;
  wire \control$621.first ;
  wire \control$621.last ;
  wire [3:0] \control$621.tile ;
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
  reg [7:0] control2 = 8'h00;
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
  wire \credit$101 ;
  output [31:0] cycles;
  reg [31:0] cycles = 32'd0;
  reg delivered = 1'h0;
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
  (* enum_value_110 = "BAD_RANGE" *)
  wire [2:0] error;
  (* enum_base_type = "Error" *)
  (* enum_value_000 = "NONE" *)
  (* enum_value_001 = "BAD_SHAPE" *)
  (* enum_value_010 = "BAD_MODE" *)
  (* enum_value_011 = "TLAST_EARLY" *)
  (* enum_value_100 = "TLAST_MISSING" *)
  (* enum_value_101 = "BAD_COMMAND" *)
  (* enum_value_110 = "BAD_RANGE" *)
  output [2:0] \error$633 ;
  reg [2:0] \error$633  = 3'h0;
  (* enum_base_type = "Error" *)
  (* enum_value_000 = "NONE" *)
  (* enum_value_001 = "BAD_SHAPE" *)
  (* enum_value_010 = "BAD_MODE" *)
  (* enum_value_011 = "TLAST_EARLY" *)
  (* enum_value_100 = "TLAST_MISSING" *)
  (* enum_value_101 = "BAD_COMMAND" *)
  (* enum_value_110 = "BAD_RANGE" *)
  wire [2:0] \error$636 ;
  (* enum_base_type = "Error" *)
  (* enum_value_000 = "NONE" *)
  (* enum_value_001 = "BAD_SHAPE" *)
  (* enum_value_010 = "BAD_MODE" *)
  (* enum_value_011 = "TLAST_EARLY" *)
  (* enum_value_100 = "TLAST_MISSING" *)
  (* enum_value_101 = "BAD_COMMAND" *)
  (* enum_value_110 = "BAD_RANGE" *)
  wire [2:0] \error$637 ;
  wire fault;
  wire \fault$635 ;
  output [31:0] fill_cycles;
  reg [31:0] fill_cycles = 32'd0;
  wire finished;
  wire flushing;
  wire group_written;
  wire \group_written$97 ;
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
  wire [64:0] \i__payload$42 ;
  wire [63:0] \i__payload$42.data ;
  wire \i__payload$42.last ;
  wire [63:0] \i__payload$47 ;
  wire [47:0] \i__payload$53 ;
  wire [49:0] \i__payload$59 ;
  wire [47:0] \i__payload$59.data ;
  wire \i__payload$59.last ;
  wire \i__payload$59.pixel_last ;
  input [64:0] \i__payload$71 ;
  wire [64:0] \i__payload$71 ;
  wire [63:0] \i__payload$71.data ;
  wire \i__payload$71.last ;
  wire [63:0] \i__payload.data ;
  wire \i__payload.last ;
  output i__ready;
  wire i__ready;
  wire \i__ready$44 ;
  wire \i__ready$50 ;
  wire \i__ready$56 ;
  wire \i__ready$62 ;
  wire \i__ready$74 ;
  input i__valid;
  wire i__valid;
  wire \i__valid$46 ;
  wire \i__valid$51 ;
  wire \i__valid$57 ;
  wire \i__valid$63 ;
  input \i__valid$75 ;
  wire \i__valid$75 ;
  wire idle;
  wire image_written;
  wire \image_written$99 ;
  reg [10:0] info = 11'h000;
  wire \info.edge ;
  wire \info.image_last ;
  wire [3:0] \info.slots ;
  wire [3:0] \info.tile ;
  wire \info.tile_last ;
  reg [10:0] info0 = 11'h000;
  wire \info0.edge ;
  wire \info0.image_last ;
  wire [3:0] \info0.slots ;
  wire [3:0] \info0.tile ;
  wire \info0.tile_last ;
  reg [10:0] info1 = 11'h000;
  wire \info1.edge ;
  wire \info1.image_last ;
  wire [3:0] \info1.slots ;
  wire [3:0] \info1.tile ;
  wire \info1.tile_last ;
  reg [10:0] info2 = 11'h000;
  wire \info2.edge ;
  wire \info2.image_last ;
  wire [3:0] \info2.slots ;
  wire [3:0] \info2.tile ;
  wire \info2.tile_last ;
  (* init = 11'h000 *)
  wire [10:0] info3;
  wire \info3.edge ;
  wire \info3.image_last ;
  wire [3:0] \info3.slots ;
  wire [3:0] \info3.tile ;
  wire \info3.tile_last ;
  output [31:0] input_stalls;
  reg [31:0] input_stalls = 32'd0;
  wire issue;
  wire last_beat;
  wire [32:0] load_end;
  output loading;
  wire loading;
  output [31:0] mac_cycles;
  reg [31:0] mac_cycles = 32'd0;
  input [31:0] mode;
  wire [31:0] mode;
  wire [31:0] \mode$9 ;
  wire [63:0] o__payload;
  wire [47:0] \o__payload$54 ;
  wire [49:0] \o__payload$60 ;
  wire [47:0] \o__payload$60.data ;
  wire \o__payload$60.last ;
  wire \o__payload$60.pixel_last ;
  output [64:0] \o__payload$65 ;
  wire [64:0] \o__payload$65 ;
  wire [63:0] \o__payload$65.data ;
  wire \o__payload$65.last ;
  wire [64:0] \o__payload$66 ;
  wire [63:0] \o__payload$66.data ;
  wire \o__payload$66.last ;
  wire o__ready;
  wire \o__ready$55 ;
  wire \o__ready$61 ;
  input \o__ready$67 ;
  wire \o__ready$67 ;
  wire \o__ready$68 ;
  wire o__valid;
  wire \o__valid$58 ;
  wire \o__valid$64 ;
  output \o__valid$69 ;
  wire \o__valid$69 ;
  wire \o__valid$70 ;
  wire open;
  output [31:0] output_stalls;
  reg [31:0] output_stalls = 32'd0;
  wire overlaps;
  wire [31:0] param_base;
  wire [64:0] params__payload;
  wire [63:0] \params__payload.data ;
  wire \params__payload.last ;
  wire params__ready;
  wire params__valid;
  input [3:0] \port$1170$0 ;
  wire [3:0] \port$1170$0 ;
  wire [14:0] read;
  wire [7:0] \read.address ;
  wire \read.bank ;
  wire [3:0] \read.mask ;
  wire [1:0] \read.slot ;
  wire [679:0] requant;
  wire [7:0] \requant.addr ;
  wire [671:0] \requant.data ;
  input [31:0] requant_base;
  wire [31:0] requant_base;
  wire [31:0] \requant_base$13 ;
  wire [7:0] \requant_base$93 ;
  wire requant_en;
  wire [8:0] requant_end;
  wire retire;
  wire \retire$89 ;
  wire retire_row;
  wire \retire_row$91 ;
  input rst;
  wire rst;
  reg running = 1'h0;
  wire [166:0] shape;
  wire [166:0] \shape$19 ;
  wire [15:0] \shape$19.beats_in ;
  wire [15:0] \shape$19.beats_out ;
  wire \shape$19.biased ;
  wire [13:0] \shape$19.blocks ;
  wire [14:0] \shape$19.column_words ;
  wire [14:0] \shape$19.groups ;
  wire \shape$19.halved ;
  wire [15:0] \shape$19.height ;
  wire [13:0] \shape$19.ingest_words ;
  wire [15:0] \shape$19.out_height ;
  wire [11:0] \shape$19.output_words ;
  wire \shape$19.pointwise ;
  wire [1:0] \shape$19.tail ;
  wire [11:0] \shape$19.tiles ;
  wire [15:0] \shape$19.width ;
  wire [166:0] \shape$77 ;
  wire [15:0] \shape$77.beats_in ;
  wire [15:0] \shape$77.beats_out ;
  wire \shape$77.biased ;
  wire [13:0] \shape$77.blocks ;
  wire [14:0] \shape$77.column_words ;
  wire [14:0] \shape$77.groups ;
  wire \shape$77.halved ;
  wire [15:0] \shape$77.height ;
  wire [13:0] \shape$77.ingest_words ;
  wire [15:0] \shape$77.out_height ;
  wire [11:0] \shape$77.output_words ;
  wire \shape$77.pointwise ;
  wire [1:0] \shape$77.tail ;
  wire [11:0] \shape$77.tiles ;
  wire [15:0] \shape$77.width ;
  wire [166:0] \shape$78 ;
  wire [15:0] \shape$78.beats_in ;
  wire [15:0] \shape$78.beats_out ;
  wire \shape$78.biased ;
  wire [13:0] \shape$78.blocks ;
  wire [14:0] \shape$78.column_words ;
  wire [14:0] \shape$78.groups ;
  wire \shape$78.halved ;
  wire [15:0] \shape$78.height ;
  wire [13:0] \shape$78.ingest_words ;
  wire [15:0] \shape$78.out_height ;
  wire [11:0] \shape$78.output_words ;
  wire \shape$78.pointwise ;
  wire [1:0] \shape$78.tail ;
  wire [11:0] \shape$78.tiles ;
  wire [15:0] \shape$78.width ;
  wire [166:0] \shape$79 ;
  wire [15:0] \shape$79.beats_in ;
  wire [15:0] \shape$79.beats_out ;
  wire \shape$79.biased ;
  wire [13:0] \shape$79.blocks ;
  wire [14:0] \shape$79.column_words ;
  wire [14:0] \shape$79.groups ;
  wire \shape$79.halved ;
  wire [15:0] \shape$79.height ;
  wire [13:0] \shape$79.ingest_words ;
  wire [15:0] \shape$79.out_height ;
  wire [11:0] \shape$79.output_words ;
  wire \shape$79.pointwise ;
  wire [1:0] \shape$79.tail ;
  wire [11:0] \shape$79.tiles ;
  wire [15:0] \shape$79.width ;
  wire [166:0] \shape$80 ;
  wire [15:0] \shape$80.beats_in ;
  wire [15:0] \shape$80.beats_out ;
  wire \shape$80.biased ;
  wire [13:0] \shape$80.blocks ;
  wire [14:0] \shape$80.column_words ;
  wire [14:0] \shape$80.groups ;
  wire \shape$80.halved ;
  wire [15:0] \shape$80.height ;
  wire [13:0] \shape$80.ingest_words ;
  wire [15:0] \shape$80.out_height ;
  wire [11:0] \shape$80.output_words ;
  wire \shape$80.pointwise ;
  wire [1:0] \shape$80.tail ;
  wire [11:0] \shape$80.tiles ;
  wire [15:0] \shape$80.width ;
  wire [15:0] \shape.beats_in ;
  wire [15:0] \shape.beats_out ;
  wire \shape.biased ;
  wire [13:0] \shape.blocks ;
  wire [14:0] \shape.column_words ;
  wire [14:0] \shape.groups ;
  wire \shape.halved ;
  wire [15:0] \shape.height ;
  wire [13:0] \shape.ingest_words ;
  wire [15:0] \shape.out_height ;
  wire [11:0] \shape.output_words ;
  wire \shape.pointwise ;
  wire [1:0] \shape.tail ;
  wire [11:0] \shape.tiles ;
  wire [15:0] \shape.width ;
  wire shift;
  wire \shift$119 ;
  wire \shift$129 ;
  wire \shift$138 ;
  wire \shift$147 ;
  wire \shift$156 ;
  wire \shift$164 ;
  wire \shift$172 ;
  wire \shift$180 ;
  wire \shift$188 ;
  wire \shift$196 ;
  wire \shift$204 ;
  wire \shift$212 ;
  wire \shift$220 ;
  wire \shift$228 ;
  wire \shift$236 ;
  wire \shift$244 ;
  wire \shift$252 ;
  wire \shift$260 ;
  wire \shift$268 ;
  wire \shift$276 ;
  wire \shift$284 ;
  wire \shift$292 ;
  wire \shift$300 ;
  wire \shift$308 ;
  wire \shift$316 ;
  wire \shift$324 ;
  wire \shift$332 ;
  wire \shift$340 ;
  wire \shift$348 ;
  wire \shift$356 ;
  wire \shift$364 ;
  wire \shift$372 ;
  wire \shift$380 ;
  wire \shift$388 ;
  wire \shift$396 ;
  wire \shift$404 ;
  wire \shift$412 ;
  wire \shift$420 ;
  wire \shift$428 ;
  wire \shift$436 ;
  wire \shift$444 ;
  wire \shift$452 ;
  wire \shift$460 ;
  wire \shift$468 ;
  wire \shift$476 ;
  wire \shift$484 ;
  wire \shift$492 ;
  wire \shift$500 ;
  wire \shift$508 ;
  wire \shift$516 ;
  wire \shift$524 ;
  wire \shift$532 ;
  wire \shift$540 ;
  wire \shift$548 ;
  wire \shift$556 ;
  wire \shift$564 ;
  wire \shift$572 ;
  wire \shift$580 ;
  wire \shift$588 ;
  wire \shift$596 ;
  wire \shift$604 ;
  wire \shift$610 ;
  wire \shift$616 ;
  wire \shift$622 ;
  wire soft_reset;
  reg start;
  wire \start$81 ;
  wire \start$82 ;
  wire \start$83 ;
  wire \start$84 ;
  reg start_requant;
  reg start_weights;
  wire starved;
  wire [43:0] step;
  wire [7:0] \step.control ;
  wire \step.control.edge ;
  wire \step.control.en ;
  wire \step.control.first ;
  wire \step.control.last ;
  wire [3:0] \step.control.tile ;
  wire [10:0] \step.info ;
  wire \step.info.edge ;
  wire \step.info.image_last ;
  wire [3:0] \step.info.slots ;
  wire [3:0] \step.info.tile ;
  wire \step.info.tile_last ;
  wire [14:0] \step.read ;
  wire [7:0] \step.read.address ;
  wire \step.read.bank ;
  wire [3:0] \step.read.mask ;
  wire [1:0] \step.read.slot ;
  wire [9:0] \step.weight ;
  wire to_requant;
  wire [63:0] unit_en;
  (* enum_base_type = "Error" *)
  (* enum_value_000 = "NONE" *)
  (* enum_value_001 = "BAD_SHAPE" *)
  (* enum_value_010 = "BAD_MODE" *)
  (* enum_value_011 = "TLAST_EARLY" *)
  (* enum_value_100 = "TLAST_MISSING" *)
  (* enum_value_101 = "BAD_COMMAND" *)
  (* enum_value_110 = "BAD_RANGE" *)
  reg [2:0] verdict;
  reg [1:0] \wait  = 2'h0;
  wire [81:0] weight;
  wire [9:0] \weight.addr ;
  wire [71:0] \weight.data ;
  input [31:0] weight_base;
  wire [31:0] weight_base;
  wire [31:0] \weight_base$11 ;
  wire [9:0] \weight_base$92 ;
  wire [10:0] weight_end;
  input [31:0] width;
  wire [31:0] width;
  wire [31:0] \width$3 ;
  wire [95:0] word;
  input [31:0] words;
  wire [31:0] words;
  wire [31:0] \words$15 ;
  wire [15:0] words_per_pixel;
  wire [679:0] write;
  wire [81:0] \write$113 ;
  wire [9:0] \write$113.addr ;
  wire [71:0] \write$113.data ;
  wire [81:0] \write$126 ;
  wire [9:0] \write$126.addr ;
  wire [71:0] \write$126.data ;
  wire [81:0] \write$135 ;
  wire [9:0] \write$135.addr ;
  wire [71:0] \write$135.data ;
  wire [81:0] \write$144 ;
  wire [9:0] \write$144.addr ;
  wire [71:0] \write$144.data ;
  wire [81:0] \write$153 ;
  wire [9:0] \write$153.addr ;
  wire [71:0] \write$153.data ;
  wire [81:0] \write$161 ;
  wire [9:0] \write$161.addr ;
  wire [71:0] \write$161.data ;
  wire [81:0] \write$169 ;
  wire [9:0] \write$169.addr ;
  wire [71:0] \write$169.data ;
  wire [81:0] \write$177 ;
  wire [9:0] \write$177.addr ;
  wire [71:0] \write$177.data ;
  wire [81:0] \write$185 ;
  wire [9:0] \write$185.addr ;
  wire [71:0] \write$185.data ;
  wire [81:0] \write$193 ;
  wire [9:0] \write$193.addr ;
  wire [71:0] \write$193.data ;
  wire [81:0] \write$201 ;
  wire [9:0] \write$201.addr ;
  wire [71:0] \write$201.data ;
  wire [81:0] \write$209 ;
  wire [9:0] \write$209.addr ;
  wire [71:0] \write$209.data ;
  wire [81:0] \write$217 ;
  wire [9:0] \write$217.addr ;
  wire [71:0] \write$217.data ;
  wire [81:0] \write$225 ;
  wire [9:0] \write$225.addr ;
  wire [71:0] \write$225.data ;
  wire [81:0] \write$233 ;
  wire [9:0] \write$233.addr ;
  wire [71:0] \write$233.data ;
  wire [81:0] \write$241 ;
  wire [9:0] \write$241.addr ;
  wire [71:0] \write$241.data ;
  wire [81:0] \write$249 ;
  wire [9:0] \write$249.addr ;
  wire [71:0] \write$249.data ;
  wire [81:0] \write$257 ;
  wire [9:0] \write$257.addr ;
  wire [71:0] \write$257.data ;
  wire [81:0] \write$265 ;
  wire [9:0] \write$265.addr ;
  wire [71:0] \write$265.data ;
  wire [81:0] \write$273 ;
  wire [9:0] \write$273.addr ;
  wire [71:0] \write$273.data ;
  wire [81:0] \write$281 ;
  wire [9:0] \write$281.addr ;
  wire [71:0] \write$281.data ;
  wire [81:0] \write$289 ;
  wire [9:0] \write$289.addr ;
  wire [71:0] \write$289.data ;
  wire [81:0] \write$297 ;
  wire [9:0] \write$297.addr ;
  wire [71:0] \write$297.data ;
  wire [81:0] \write$305 ;
  wire [9:0] \write$305.addr ;
  wire [71:0] \write$305.data ;
  wire [81:0] \write$313 ;
  wire [9:0] \write$313.addr ;
  wire [71:0] \write$313.data ;
  wire [81:0] \write$321 ;
  wire [9:0] \write$321.addr ;
  wire [71:0] \write$321.data ;
  wire [81:0] \write$329 ;
  wire [9:0] \write$329.addr ;
  wire [71:0] \write$329.data ;
  wire [81:0] \write$337 ;
  wire [9:0] \write$337.addr ;
  wire [71:0] \write$337.data ;
  wire [81:0] \write$345 ;
  wire [9:0] \write$345.addr ;
  wire [71:0] \write$345.data ;
  wire [81:0] \write$353 ;
  wire [9:0] \write$353.addr ;
  wire [71:0] \write$353.data ;
  wire [81:0] \write$361 ;
  wire [9:0] \write$361.addr ;
  wire [71:0] \write$361.data ;
  wire [81:0] \write$369 ;
  wire [9:0] \write$369.addr ;
  wire [71:0] \write$369.data ;
  wire [81:0] \write$377 ;
  wire [9:0] \write$377.addr ;
  wire [71:0] \write$377.data ;
  wire [81:0] \write$385 ;
  wire [9:0] \write$385.addr ;
  wire [71:0] \write$385.data ;
  wire [81:0] \write$393 ;
  wire [9:0] \write$393.addr ;
  wire [71:0] \write$393.data ;
  wire [81:0] \write$401 ;
  wire [9:0] \write$401.addr ;
  wire [71:0] \write$401.data ;
  wire [81:0] \write$409 ;
  wire [9:0] \write$409.addr ;
  wire [71:0] \write$409.data ;
  wire [81:0] \write$417 ;
  wire [9:0] \write$417.addr ;
  wire [71:0] \write$417.data ;
  wire [81:0] \write$425 ;
  wire [9:0] \write$425.addr ;
  wire [71:0] \write$425.data ;
  wire [81:0] \write$433 ;
  wire [9:0] \write$433.addr ;
  wire [71:0] \write$433.data ;
  wire [81:0] \write$441 ;
  wire [9:0] \write$441.addr ;
  wire [71:0] \write$441.data ;
  wire [81:0] \write$449 ;
  wire [9:0] \write$449.addr ;
  wire [71:0] \write$449.data ;
  wire [81:0] \write$457 ;
  wire [9:0] \write$457.addr ;
  wire [71:0] \write$457.data ;
  wire [81:0] \write$465 ;
  wire [9:0] \write$465.addr ;
  wire [71:0] \write$465.data ;
  wire [81:0] \write$473 ;
  wire [9:0] \write$473.addr ;
  wire [71:0] \write$473.data ;
  wire [81:0] \write$481 ;
  wire [9:0] \write$481.addr ;
  wire [71:0] \write$481.data ;
  wire [81:0] \write$489 ;
  wire [9:0] \write$489.addr ;
  wire [71:0] \write$489.data ;
  wire [81:0] \write$497 ;
  wire [9:0] \write$497.addr ;
  wire [71:0] \write$497.data ;
  wire [81:0] \write$505 ;
  wire [9:0] \write$505.addr ;
  wire [71:0] \write$505.data ;
  wire [81:0] \write$513 ;
  wire [9:0] \write$513.addr ;
  wire [71:0] \write$513.data ;
  wire [81:0] \write$521 ;
  wire [9:0] \write$521.addr ;
  wire [71:0] \write$521.data ;
  wire [81:0] \write$529 ;
  wire [9:0] \write$529.addr ;
  wire [71:0] \write$529.data ;
  wire [81:0] \write$537 ;
  wire [9:0] \write$537.addr ;
  wire [71:0] \write$537.data ;
  wire [81:0] \write$545 ;
  wire [9:0] \write$545.addr ;
  wire [71:0] \write$545.data ;
  wire [81:0] \write$553 ;
  wire [9:0] \write$553.addr ;
  wire [71:0] \write$553.data ;
  wire [81:0] \write$561 ;
  wire [9:0] \write$561.addr ;
  wire [71:0] \write$561.data ;
  wire [81:0] \write$569 ;
  wire [9:0] \write$569.addr ;
  wire [71:0] \write$569.data ;
  wire [81:0] \write$577 ;
  wire [9:0] \write$577.addr ;
  wire [71:0] \write$577.data ;
  wire [81:0] \write$585 ;
  wire [9:0] \write$585.addr ;
  wire [71:0] \write$585.data ;
  wire [81:0] \write$593 ;
  wire [9:0] \write$593.addr ;
  wire [71:0] \write$593.data ;
  wire [81:0] \write$601 ;
  wire [9:0] \write$601.addr ;
  wire [71:0] \write$601.data ;
  wire [81:0] \write$607 ;
  wire [9:0] \write$607.addr ;
  wire [71:0] \write$607.data ;
  wire [81:0] \write$613 ;
  wire [9:0] \write$613.addr ;
  wire [71:0] \write$613.data ;
  wire [81:0] \write$619 ;
  wire [9:0] \write$619.addr ;
  wire [71:0] \write$619.data ;
  wire [7:0] \write.addr ;
  wire [671:0] \write.data ;
  wire write_en;
  wire \write_en$111 ;
  wire \write_en$125 ;
  wire \write_en$134 ;
  wire \write_en$143 ;
  wire \write_en$152 ;
  wire \write_en$160 ;
  wire \write_en$168 ;
  wire \write_en$176 ;
  wire \write_en$184 ;
  wire \write_en$192 ;
  wire \write_en$200 ;
  wire \write_en$208 ;
  wire \write_en$216 ;
  wire \write_en$224 ;
  wire \write_en$232 ;
  wire \write_en$240 ;
  wire \write_en$248 ;
  wire \write_en$256 ;
  wire \write_en$264 ;
  wire \write_en$272 ;
  wire \write_en$280 ;
  wire \write_en$288 ;
  wire \write_en$296 ;
  wire \write_en$304 ;
  wire \write_en$312 ;
  wire \write_en$320 ;
  wire \write_en$328 ;
  wire \write_en$336 ;
  wire \write_en$344 ;
  wire \write_en$352 ;
  wire \write_en$360 ;
  wire \write_en$368 ;
  wire \write_en$376 ;
  wire \write_en$384 ;
  wire \write_en$392 ;
  wire \write_en$400 ;
  wire \write_en$408 ;
  wire \write_en$416 ;
  wire \write_en$424 ;
  wire \write_en$432 ;
  wire \write_en$440 ;
  wire \write_en$448 ;
  wire \write_en$456 ;
  wire \write_en$464 ;
  wire \write_en$472 ;
  wire \write_en$480 ;
  wire \write_en$488 ;
  wire \write_en$496 ;
  wire \write_en$504 ;
  wire \write_en$512 ;
  wire \write_en$520 ;
  wire \write_en$528 ;
  wire \write_en$536 ;
  wire \write_en$544 ;
  wire \write_en$552 ;
  wire \write_en$560 ;
  wire \write_en$568 ;
  wire \write_en$576 ;
  wire \write_en$584 ;
  wire \write_en$592 ;
  wire \write_en$600 ;
  wire \write_en$606 ;
  wire \write_en$612 ;
  wire \write_en$618 ;
  assign \$22  = \$signal$623  | \$signal$626 ;
  assign \$23  = ~ ended;
  assign \$signal$625  = \$22  & \$23 ;
  assign \$24  = \port$1170$0 [2:0] - 1'h1;
  assign \$25  = { 1'h0, \port$1170$0 [2:0] } & \$24 ;
  assign \$26  = | \$25 ;
  assign \$27  = | \wait ;
  assign \$28  = \wait  - 1'h1;
  assign \$29  = \wait  == 1'h1;
  assign \$30  = \o__valid$69  & \o__ready$67 ;
  assign \$31  = \$30  & \o__payload$65 [64];
  assign \$32  = running & delivered;
  assign \$33  = ~ open;
  assign \$34  = \$32  & \$33 ;
  assign \$35  = \$signal$33  & idle;
  assign \$36  = ! \error$633 ;
  assign \$37  = | \$signal$35 ;
  assign \$38  = | verdict;
  assign \$39  = cycles + 1'h1;
  assign \$40  = ~ \$signal$645 ;
  assign \$41  = ~ flushing;
  assign \$42  = blocked & \$41 ;
  assign \$43  = mac_cycles + 1'h1;
  assign \$44  = fill_cycles + 1'h1;
  assign \$45  = input_stalls + 1'h1;
  assign \$46  = output_stalls + 1'h1;
  assign \$47  = drain_cycles + 1'h1;
  always @(posedge clk)
    \wait  <= \$48 ;
  always @(posedge clk)
    done <= \$49 ;
  always @(posedge clk)
    running <= \$50 ;
  always @(posedge clk)
    delivered <= \$51 ;
  always @(posedge clk)
    \error$633  <= \$52 ;
  always @(posedge clk)
    control0 <= \$53 ;
  always @(posedge clk)
    info0 <= step[43:33];
  always @(posedge clk)
    control1 <= \$54 ;
  always @(posedge clk)
    info1 <= info0;
  always @(posedge clk)
    control2 <= \$55 ;
  always @(posedge clk)
    info2 <= info1;
  always @(posedge clk)
    control3 <= \$56 ;
  always @(posedge clk)
    info <= info2;
  always @(posedge clk)
    \$signal$626  <= \$57 ;
  always @(posedge clk)
    \$signal$645  <= \$58 ;
  always @(posedge clk)
    ended <= \$59 ;
  always @(posedge clk)
    cycles <= \$60 ;
  always @(posedge clk)
    mac_cycles <= \$61 ;
  always @(posedge clk)
    fill_cycles <= \$62 ;
  always @(posedge clk)
    input_stalls <= \$63 ;
  always @(posedge clk)
    output_stalls <= \$64 ;
  always @(posedge clk)
    drain_cycles <= \$65 ;
  assign \$1  = | \wait ;
  assign busy = running | \$1 ;
  assign \$signal  = loading ? to_requant : \port$1170$0 [2];
  assign load_end = base + words;
  assign \$2  = \$signal  ? 11'h100 : 11'h400;
  assign \$signal$29  = load_end > \$2 ;
  assign \$3  = \$signal  ? { 2'h0, requant_end } : weight_end;
  assign \$4  = base < \$3 ;
  assign \$5  = \$signal  ? requant_base : weight_base;
  assign \$6  = load_end > \$5 ;
  assign overlaps = \$4  & \$6 ;
  assign \$signal$33  = | \port$1170$0 [2:0];
  assign \$7  = ~ busy;
  assign \$8  = ~ loading;
  assign idle = \$7  & \$8 ;
  assign \$9  = \port$1170$0 [2:0] - 1'h1;
  assign \$10  = { 1'h0, \port$1170$0 [2:0] } & \$9 ;
  assign \$11  = | \$10 ;
  assign \$12  = ! words;
  assign \$13  = \$12  | \$signal$29 ;
  assign \$14  = busy & overlaps;
  assign \$15  = \$13  | \$14 ;
  assign \$16  = \wait  == 1'h1;
  assign \$17  = ! error;
  assign \$18  = \$17  & loading;
  assign \$19  = \$18  & overlaps;
  assign \$20  = ! verdict;
  assign finished = control3[0] & control3[2];
  assign \$signal$623  = i__valid & i__ready;
  assign \$21  = \o__valid$69  & \o__ready$67 ;
  assign last_beat = \$21  & \o__payload$65 [64];
  \macram_top.array.decoder  decoder (
    .c_in(c_in),
    .c_out(c_out),
    .clk(clk),
    .error(error),
    .height(height),
    .mode(mode),
    .requant_base(requant_base),
    .requant_end(requant_end),
    .rst(rst),
    .shape(shape),
    .soft_reset(\port$1170$0 [3]),
    .weight_base(weight_base),
    .weight_end(weight_end),
    .width(width)
  );
  \macram_top.array.drain  drain (
    .clk(clk),
    .credit(credit),
    .finished(finished),
    .\heads$60 (heads),
    .info(info),
    .o__payload(\i__payload$59 ),
    .o__ready(\o__ready$61 ),
    .reload__addr(\$67 ),
    .reload__data(\$68 ),
    .reload__en(write_en),
    .requant_base(requant_base[7:0]),
    .rst(rst),
    .shape(shape),
    .shift(shift),
    .soft_reset(\port$1170$0 [3]),
    .start(start),
    .valid(\i__valid$63 )
  );
  \macram_top.array.emit  emit (
    .beats_per_pixel(shape[163:148]),
    .clk(clk),
    .i__payload(\i__payload$59 ),
    .i__ready(\o__ready$61 ),
    .i__valid(\i__valid$63 ),
    .o__payload(\o__payload$65 ),
    .o__ready(\o__ready$67 ),
    .o__valid(\o__valid$69 ),
    .rst(rst),
    .soft_reset(\port$1170$0 [3])
  );
  \macram_top.array.frame  frame (
    .clk(clk),
    .error(\error$636 ),
    .fault(fault),
    .i__payload(i__payload),
    .i__ready(i__ready),
    .i__valid(i__valid),
    .o__ready(o__ready),
    .o__valid(\i__valid$51 ),
    .open(open),
    .rst(rst),
    .shape(shape),
    .soft_reset(\port$1170$0 [3]),
    .start(start)
  );
  \macram_top.array.ingest  ingest (
    .beats_per_pixel(shape[147:132]),
    .clk(clk),
    .i__payload(i__payload[63:0]),
    .i__ready(o__ready),
    .i__valid(\i__valid$51 ),
    .o__payload(\i__payload$53 ),
    .o__ready(\o__ready$55 ),
    .o__valid(\i__valid$57 ),
    .\port$1255$79 (shape[92:79]),
    .rst(rst),
    .soft_reset(\port$1170$0 [3])
  );
  \macram_top.array.lines  lines (
    .clk(clk),
    .group_written(group_written),
    .i__payload(\i__payload$53 ),
    .i__ready(\o__ready$55 ),
    .i__valid(\i__valid$57 ),
    .image_written(image_written),
    .read(step[14:0]),
    .retire(retire),
    .retire_row(retire_row),
    .rst(rst),
    .shape(shape),
    .soft_reset(\port$1170$0 [3]),
    .start(start),
    .word(activations)
  );
  \macram_top.array.loader  loader (
    .base(base),
    .clk(clk),
    .error(\error$637 ),
    .fault(\fault$635 ),
    .i__payload(\i__payload$71 ),
    .i__ready(loading),
    .i__valid(\i__valid$75 ),
    .\port$1507$0 (\$66 ),
    .\port$1509$0 (\$67 ),
    .\port$1511$0 (\$68 ),
    .requant_en(write_en),
    .rst(rst),
    .soft_reset(\port$1170$0 [3]),
    .start_requant(start_requant),
    .start_weights(start_weights),
    .to_requant(to_requant),
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
    .retire_row(retire_row),
    .rst(rst),
    .shape(shape),
    .soft_reset(\port$1170$0 [3]),
    .start(start),
    .starved(starved),
    .\step$45 (step),
    .weight_base(weight_base[9:0])
  );
  \macram_top.array.unit000  unit000 (
    .address(step[24:15]),
    .chain_o(chain_o),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(chain_i),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[0])
  );
  \macram_top.array.unit001  unit001 (
    .address(step[24:15]),
    .chain_o(\chain_o$130 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$131 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[1])
  );
  \macram_top.array.unit002  unit002 (
    .address(step[24:15]),
    .chain_o(\chain_o$139 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$140 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[2])
  );
  \macram_top.array.unit003  unit003 (
    .address(step[24:15]),
    .chain_o(\chain_o$148 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$149 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[3])
  );
  \macram_top.array.unit004  unit004 (
    .address(step[24:15]),
    .chain_o(chain_i),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$157 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[4])
  );
  \macram_top.array.unit005  unit005 (
    .address(step[24:15]),
    .chain_o(\chain_i$131 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$165 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[5])
  );
  \macram_top.array.unit006  unit006 (
    .address(step[24:15]),
    .chain_o(\chain_i$140 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$173 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[6])
  );
  \macram_top.array.unit007  unit007 (
    .address(step[24:15]),
    .chain_o(\chain_i$149 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$181 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[7])
  );
  \macram_top.array.unit008  unit008 (
    .address(step[24:15]),
    .chain_o(\chain_i$157 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$189 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[8])
  );
  \macram_top.array.unit009  unit009 (
    .address(step[24:15]),
    .chain_o(\chain_i$165 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$197 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[9])
  );
  \macram_top.array.unit010  unit010 (
    .address(step[24:15]),
    .chain_o(\chain_i$173 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$205 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[10])
  );
  \macram_top.array.unit011  unit011 (
    .address(step[24:15]),
    .chain_o(\chain_i$181 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$213 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[11])
  );
  \macram_top.array.unit012  unit012 (
    .address(step[24:15]),
    .chain_o(\chain_i$189 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$221 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[12])
  );
  \macram_top.array.unit013  unit013 (
    .address(step[24:15]),
    .chain_o(\chain_i$197 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$229 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[13])
  );
  \macram_top.array.unit014  unit014 (
    .address(step[24:15]),
    .chain_o(\chain_i$205 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$237 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[14])
  );
  \macram_top.array.unit015  unit015 (
    .address(step[24:15]),
    .chain_o(\chain_i$213 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$245 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[15])
  );
  \macram_top.array.unit016  unit016 (
    .address(step[24:15]),
    .chain_o(\chain_i$221 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$253 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[16])
  );
  \macram_top.array.unit017  unit017 (
    .address(step[24:15]),
    .chain_o(\chain_i$229 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$261 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[17])
  );
  \macram_top.array.unit018  unit018 (
    .address(step[24:15]),
    .chain_o(\chain_i$237 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$269 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[18])
  );
  \macram_top.array.unit019  unit019 (
    .address(step[24:15]),
    .chain_o(\chain_i$245 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$277 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[19])
  );
  \macram_top.array.unit020  unit020 (
    .address(step[24:15]),
    .chain_o(\chain_i$253 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$285 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[20])
  );
  \macram_top.array.unit021  unit021 (
    .address(step[24:15]),
    .chain_o(\chain_i$261 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$293 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[21])
  );
  \macram_top.array.unit022  unit022 (
    .address(step[24:15]),
    .chain_o(\chain_i$269 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$301 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[22])
  );
  \macram_top.array.unit023  unit023 (
    .address(step[24:15]),
    .chain_o(\chain_i$277 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$309 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[23])
  );
  \macram_top.array.unit024  unit024 (
    .address(step[24:15]),
    .chain_o(\chain_i$285 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$317 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[24])
  );
  \macram_top.array.unit025  unit025 (
    .address(step[24:15]),
    .chain_o(\chain_i$293 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$325 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[25])
  );
  \macram_top.array.unit026  unit026 (
    .address(step[24:15]),
    .chain_o(\chain_i$301 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$333 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[26])
  );
  \macram_top.array.unit027  unit027 (
    .address(step[24:15]),
    .chain_o(\chain_i$309 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$341 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[27])
  );
  \macram_top.array.unit028  unit028 (
    .address(step[24:15]),
    .chain_o(\chain_i$317 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$349 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[28])
  );
  \macram_top.array.unit029  unit029 (
    .address(step[24:15]),
    .chain_o(\chain_i$325 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$357 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[29])
  );
  \macram_top.array.unit030  unit030 (
    .address(step[24:15]),
    .chain_o(\chain_i$333 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$365 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[30])
  );
  \macram_top.array.unit031  unit031 (
    .address(step[24:15]),
    .chain_o(\chain_i$341 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$373 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[31])
  );
  \macram_top.array.unit032  unit032 (
    .address(step[24:15]),
    .chain_o(\chain_i$349 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$381 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[32])
  );
  \macram_top.array.unit033  unit033 (
    .address(step[24:15]),
    .chain_o(\chain_i$357 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$389 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[33])
  );
  \macram_top.array.unit034  unit034 (
    .address(step[24:15]),
    .chain_o(\chain_i$365 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$397 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[34])
  );
  \macram_top.array.unit035  unit035 (
    .address(step[24:15]),
    .chain_o(\chain_i$373 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$405 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[35])
  );
  \macram_top.array.unit036  unit036 (
    .address(step[24:15]),
    .chain_o(\chain_i$381 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$413 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[36])
  );
  \macram_top.array.unit037  unit037 (
    .address(step[24:15]),
    .chain_o(\chain_i$389 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$421 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[37])
  );
  \macram_top.array.unit038  unit038 (
    .address(step[24:15]),
    .chain_o(\chain_i$397 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$429 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[38])
  );
  \macram_top.array.unit039  unit039 (
    .address(step[24:15]),
    .chain_o(\chain_i$405 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$437 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[39])
  );
  \macram_top.array.unit040  unit040 (
    .address(step[24:15]),
    .chain_o(\chain_i$413 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$445 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[40])
  );
  \macram_top.array.unit041  unit041 (
    .address(step[24:15]),
    .chain_o(\chain_i$421 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$453 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[41])
  );
  \macram_top.array.unit042  unit042 (
    .address(step[24:15]),
    .chain_o(\chain_i$429 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$461 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[42])
  );
  \macram_top.array.unit043  unit043 (
    .address(step[24:15]),
    .chain_o(\chain_i$437 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$469 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[43])
  );
  \macram_top.array.unit044  unit044 (
    .address(step[24:15]),
    .chain_o(\chain_i$445 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$477 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[44])
  );
  \macram_top.array.unit045  unit045 (
    .address(step[24:15]),
    .chain_o(\chain_i$453 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$485 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[45])
  );
  \macram_top.array.unit046  unit046 (
    .address(step[24:15]),
    .chain_o(\chain_i$461 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$493 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[46])
  );
  \macram_top.array.unit047  unit047 (
    .address(step[24:15]),
    .chain_o(\chain_i$469 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$501 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[47])
  );
  \macram_top.array.unit048  unit048 (
    .address(step[24:15]),
    .chain_o(\chain_i$477 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$509 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[48])
  );
  \macram_top.array.unit049  unit049 (
    .address(step[24:15]),
    .chain_o(\chain_i$485 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$517 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[49])
  );
  \macram_top.array.unit050  unit050 (
    .address(step[24:15]),
    .chain_o(\chain_i$493 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$525 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[50])
  );
  \macram_top.array.unit051  unit051 (
    .address(step[24:15]),
    .chain_o(\chain_i$501 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$533 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[51])
  );
  \macram_top.array.unit052  unit052 (
    .address(step[24:15]),
    .chain_o(\chain_i$509 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$541 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[52])
  );
  \macram_top.array.unit053  unit053 (
    .address(step[24:15]),
    .chain_o(\chain_i$517 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$549 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[53])
  );
  \macram_top.array.unit054  unit054 (
    .address(step[24:15]),
    .chain_o(\chain_i$525 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$557 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[54])
  );
  \macram_top.array.unit055  unit055 (
    .address(step[24:15]),
    .chain_o(\chain_i$533 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$565 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[55])
  );
  \macram_top.array.unit056  unit056 (
    .address(step[24:15]),
    .chain_o(\chain_i$541 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$573 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[56])
  );
  \macram_top.array.unit057  unit057 (
    .address(step[24:15]),
    .chain_o(\chain_i$549 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$581 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[57])
  );
  \macram_top.array.unit058  unit058 (
    .address(step[24:15]),
    .chain_o(\chain_i$557 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$589 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[58])
  );
  \macram_top.array.unit059  unit059 (
    .address(step[24:15]),
    .chain_o(\chain_i$565 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$597 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[59])
  );
  \macram_top.array.unit060  unit060 (
    .address(step[24:15]),
    .chain_o(\chain_i$573 ),
    .clk(clk),
    .core__activations(activations),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[60])
  );
  \macram_top.array.unit061  unit061 (
    .address(step[24:15]),
    .chain_o(\chain_i$581 ),
    .clk(clk),
    .core__activations(activations),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[61])
  );
  \macram_top.array.unit062  unit062 (
    .address(step[24:15]),
    .chain_o(\chain_i$589 ),
    .clk(clk),
    .core__activations(activations),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[62])
  );
  \macram_top.array.unit063  unit063 (
    .address(step[24:15]),
    .chain_o(\chain_i$597 ),
    .clk(clk),
    .core__activations(activations),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$66 ),
    .write__data(\$68 [647:576]),
    .write__en(unit_en[63])
  );
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$signal$35  = 3'h0;
    if (\$11 ) begin
      \$signal$35  = 3'h5;
    end else if (\port$1170$0 [0]) begin
      if (busy) begin
        \$signal$35  = 3'h5;
      end
    end else if (\$signal$33 ) begin
      if (loading) begin
        \$signal$35  = 3'h5;
      end else if (\$15 ) begin
        \$signal$35  = 3'h6;
      end
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    start_weights = 1'h0;
    if (\$11 ) begin
    end else if (\port$1170$0 [0]) begin
    end else if (\$signal$33 ) begin
      (* full_case = 32'd1 *)
      if (loading) begin
      end else if (\$15 ) begin
      end else begin
        start_weights = \port$1170$0 [1];
      end
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    start_requant = 1'h0;
    if (\$11 ) begin
    end else if (\port$1170$0 [0]) begin
    end else if (\$signal$33 ) begin
      (* full_case = 32'd1 *)
      if (loading) begin
      end else if (\$15 ) begin
      end else begin
        start_requant = \port$1170$0 [2];
      end
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    verdict = 3'h0;
    if (\$16 ) begin
      (* full_case = 32'd1 *)
      if (\$19 ) begin
        verdict = 3'h6;
      end else begin
        verdict = error;
      end
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    start = 1'h0;
    if (\$16 ) begin
      start = \$20 ;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$48  = \wait ;
    if (\$26 ) begin
    end else if (\port$1170$0 [0]) begin
      (* full_case = 32'd1 *)
      if (busy) begin
      end else begin
        \$48  = 2'h3;
      end
    end
    if (\$27 ) begin
      \$48  = \$28 [1:0];
    end
    if (\port$1170$0 [3]) begin
      \$48  = 2'h0;
    end
    if (rst) begin
      \$48  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$49  = done;
    if (\$26 ) begin
    end else if (\port$1170$0 [0]) begin
      (* full_case = 32'd1 *)
      if (busy) begin
      end else begin
        \$49  = 1'h0;
      end
    end
    if (\$34 ) begin
      \$49  = 1'h1;
    end
    if (\$35 ) begin
      \$49  = 1'h0;
    end
    if (\port$1170$0 [3]) begin
      \$49  = 1'h0;
    end
    if (rst) begin
      \$49  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$50  = running;
    if (\$29 ) begin
      \$50  = start;
    end
    if (\$34 ) begin
      \$50  = 1'h0;
    end
    if (\port$1170$0 [3]) begin
      \$50  = 1'h0;
    end
    if (rst) begin
      \$50  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$51  = delivered;
    if (\$31 ) begin
      \$51  = 1'h1;
    end
    if (\$34 ) begin
      \$51  = 1'h0;
    end
    if (\port$1170$0 [3]) begin
      \$51  = 1'h0;
    end
    if (rst) begin
      \$51  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$52  = \error$633 ;
    if (\$35 ) begin
      \$52  = \$signal$35 ;
    end else if (\$36 ) begin
      if (\$37 ) begin
        \$52  = \$signal$35 ;
      end else if (\$38 ) begin
        \$52  = verdict;
      end else if (fault) begin
        \$52  = \error$636 ;
      end else if (\fault$635 ) begin
        \$52  = \error$637 ;
      end
    end
    if (\port$1170$0 [3]) begin
      \$52  = 3'h0;
    end
    if (rst) begin
      \$52  = 3'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$53  = step[32:25];
    if (\port$1170$0 [3]) begin
      \$53  = 8'h00;
    end
    if (rst) begin
      \$53  = 8'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$54  = control0;
    if (\port$1170$0 [3]) begin
      \$54  = 8'h00;
    end
    if (rst) begin
      \$54  = 8'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$55  = control1;
    if (\port$1170$0 [3]) begin
      \$55  = 8'h00;
    end
    if (rst) begin
      \$55  = 8'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$56  = control2;
    if (\port$1170$0 [3]) begin
      \$56  = 8'h00;
    end
    if (rst) begin
      \$56  = 8'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$57  = \$signal$626 ;
    if (\$signal$623 ) begin
      \$57  = 1'h1;
    end
    if (start) begin
      \$57  = 1'h0;
    end
    if (\port$1170$0 [3]) begin
      \$57  = 1'h0;
    end
    if (rst) begin
      \$57  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$58  = \$signal$645 ;
    if (issue) begin
      \$58  = 1'h1;
    end
    if (start) begin
      \$58  = 1'h0;
    end
    if (\port$1170$0 [3]) begin
      \$58  = 1'h0;
    end
    if (rst) begin
      \$58  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$59  = ended;
    if (last_beat) begin
      \$59  = 1'h1;
    end
    if (start) begin
      \$59  = 1'h0;
    end
    if (\port$1170$0 [3]) begin
      \$59  = 1'h0;
    end
    if (rst) begin
      \$59  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$60  = cycles;
    if (\$signal$625 ) begin
      \$60  = \$39 [31:0];
    end
    if (start) begin
      \$60  = 32'd0;
    end
    if (\port$1170$0 [3]) begin
      \$60  = 32'd0;
    end
    if (rst) begin
      \$60  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$61  = mac_cycles;
    if (\$signal$625 ) begin
      if (issue) begin
        \$61  = \$43 [31:0];
      end
    end
    if (start) begin
      \$61  = 32'd0;
    end
    if (\port$1170$0 [3]) begin
      \$61  = 32'd0;
    end
    if (rst) begin
      \$61  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$62  = fill_cycles;
    if (\$signal$625 ) begin
      if (issue) begin
      end else if (\$40 ) begin
        \$62  = \$44 [31:0];
      end
    end
    if (start) begin
      \$62  = 32'd0;
    end
    if (\port$1170$0 [3]) begin
      \$62  = 32'd0;
    end
    if (rst) begin
      \$62  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$63  = input_stalls;
    if (\$signal$625 ) begin
      if (issue) begin
      end else if (\$40 ) begin
      end else if (starved) begin
        \$63  = \$45 [31:0];
      end
    end
    if (start) begin
      \$63  = 32'd0;
    end
    if (\port$1170$0 [3]) begin
      \$63  = 32'd0;
    end
    if (rst) begin
      \$63  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$64  = output_stalls;
    if (\$signal$625 ) begin
      if (issue) begin
      end else if (\$40 ) begin
      end else if (starved) begin
      end else if (\$42 ) begin
        \$64  = \$46 [31:0];
      end
    end
    if (start) begin
      \$64  = 32'd0;
    end
    if (\port$1170$0 [3]) begin
      \$64  = 32'd0;
    end
    if (rst) begin
      \$64  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$65  = drain_cycles;
    if (\$signal$625 ) begin
      (* full_case = 32'd1 *)
      if (issue) begin
      end else if (\$40 ) begin
      end else if (starved) begin
      end else if (\$42 ) begin
      end else begin
        \$65  = \$47 [31:0];
      end
    end
    if (start) begin
      \$65  = 32'd0;
    end
    if (\port$1170$0 [3]) begin
      \$65  = 32'd0;
    end
    if (rst) begin
      \$65  = 32'd0;
    end
  end
  assign \height$1  = height;
  assign \width$3  = width;
  assign \c_in$5  = c_in;
  assign \c_out$7  = c_out;
  assign \mode$9  = mode;
  assign \weight_base$11  = weight_base;
  assign \requant_base$13  = requant_base;
  assign \words$15  = words;
  assign param_base = base;
  assign \shape$19  = shape;
  assign \busy$24  = loading;
  assign command = \port$1170$0 [2:0];
  assign \i__payload$42  = i__payload;
  assign \i__ready$44  = i__ready;
  assign \i__valid$46  = i__valid;
  assign \i__payload$47  = i__payload[63:0];
  assign o__payload = i__payload[63:0];
  assign \i__ready$50  = o__ready;
  assign o__valid = \i__valid$51 ;
  assign \o__payload$54  = \i__payload$53 ;
  assign \i__ready$56  = \o__ready$55 ;
  assign \o__valid$58  = \i__valid$57 ;
  assign \o__payload$60  = \i__payload$59 ;
  assign \i__ready$62  = \o__ready$61 ;
  assign \o__valid$64  = \i__valid$63 ;
  assign \o__payload$66  = \o__payload$65 ;
  assign \o__ready$68  = \o__ready$67 ;
  assign \o__valid$70  = \o__valid$69 ;
  assign params__payload = \i__payload$71 ;
  assign params__ready = loading;
  assign \i__ready$74  = loading;
  assign params__valid = \i__valid$75 ;
  assign \shape$77  = shape;
  assign \shape$78  = shape;
  assign \shape$79  = shape;
  assign \shape$80  = shape;
  assign \start$81  = start;
  assign \start$82  = start;
  assign \start$83  = start;
  assign \start$84  = start;
  assign beats_per_pixel = shape[147:132];
  assign words_per_pixel = { 2'h0, shape[92:79] };
  assign \beats_per_pixel$87  = shape[163:148];
  assign \retire$89  = retire;
  assign \retire_row$91  = retire_row;
  assign \weight_base$92  = weight_base[9:0];
  assign \requant_base$93  = requant_base[7:0];
  assign read = step[14:0];
  assign \group_written$97  = group_written;
  assign \image_written$99  = image_written;
  assign \credit$101  = credit;
  assign requant_en = write_en;
  assign write = { \$68 , \$67  };
  assign requant = { \$68 , \$67  };
  assign info3 = info;
  assign address = step[24:15];
  assign \write_en$111  = unit_en[0];
  assign \write$113  = { \$68 [647:576], \$66  };
  assign weight = { \$68 [647:576], \$66  };
  assign word = activations;
  assign control = control3;
  assign \shift$119  = shift;
  assign \chain_o$123  = chain_i;
  assign \address$124  = step[24:15];
  assign \write_en$125  = unit_en[1];
  assign \write$126  = { \$68 [647:576], \$66  };
  assign \activations$127  = activations;
  assign \control$128  = control3;
  assign \shift$129  = shift;
  assign \chain_o$132  = \chain_i$131 ;
  assign \address$133  = step[24:15];
  assign \write_en$134  = unit_en[2];
  assign \write$135  = { \$68 [647:576], \$66  };
  assign \activations$136  = activations;
  assign \control$137  = control3;
  assign \shift$138  = shift;
  assign \chain_o$141  = \chain_i$140 ;
  assign \address$142  = step[24:15];
  assign \write_en$143  = unit_en[3];
  assign \write$144  = { \$68 [647:576], \$66  };
  assign \activations$145  = activations;
  assign \control$146  = control3;
  assign \shift$147  = shift;
  assign \chain_o$150  = \chain_i$149 ;
  assign \address$151  = step[24:15];
  assign \write_en$152  = unit_en[4];
  assign \write$153  = { \$68 [647:576], \$66  };
  assign \activations$154  = activations;
  assign \control$155  = control3;
  assign \shift$156  = shift;
  assign \chain_o$158  = \chain_i$157 ;
  assign \address$159  = step[24:15];
  assign \write_en$160  = unit_en[5];
  assign \write$161  = { \$68 [647:576], \$66  };
  assign \activations$162  = activations;
  assign \control$163  = control3;
  assign \shift$164  = shift;
  assign \chain_o$166  = \chain_i$165 ;
  assign \address$167  = step[24:15];
  assign \write_en$168  = unit_en[6];
  assign \write$169  = { \$68 [647:576], \$66  };
  assign \activations$170  = activations;
  assign \control$171  = control3;
  assign \shift$172  = shift;
  assign \chain_o$174  = \chain_i$173 ;
  assign \address$175  = step[24:15];
  assign \write_en$176  = unit_en[7];
  assign \write$177  = { \$68 [647:576], \$66  };
  assign \activations$178  = activations;
  assign \control$179  = control3;
  assign \shift$180  = shift;
  assign \chain_o$182  = \chain_i$181 ;
  assign \address$183  = step[24:15];
  assign \write_en$184  = unit_en[8];
  assign \write$185  = { \$68 [647:576], \$66  };
  assign \activations$186  = activations;
  assign \control$187  = control3;
  assign \shift$188  = shift;
  assign \chain_o$190  = \chain_i$189 ;
  assign \address$191  = step[24:15];
  assign \write_en$192  = unit_en[9];
  assign \write$193  = { \$68 [647:576], \$66  };
  assign \activations$194  = activations;
  assign \control$195  = control3;
  assign \shift$196  = shift;
  assign \chain_o$198  = \chain_i$197 ;
  assign \address$199  = step[24:15];
  assign \write_en$200  = unit_en[10];
  assign \write$201  = { \$68 [647:576], \$66  };
  assign \activations$202  = activations;
  assign \control$203  = control3;
  assign \shift$204  = shift;
  assign \chain_o$206  = \chain_i$205 ;
  assign \address$207  = step[24:15];
  assign \write_en$208  = unit_en[11];
  assign \write$209  = { \$68 [647:576], \$66  };
  assign \activations$210  = activations;
  assign \control$211  = control3;
  assign \shift$212  = shift;
  assign \chain_o$214  = \chain_i$213 ;
  assign \address$215  = step[24:15];
  assign \write_en$216  = unit_en[12];
  assign \write$217  = { \$68 [647:576], \$66  };
  assign \activations$218  = activations;
  assign \control$219  = control3;
  assign \shift$220  = shift;
  assign \chain_o$222  = \chain_i$221 ;
  assign \address$223  = step[24:15];
  assign \write_en$224  = unit_en[13];
  assign \write$225  = { \$68 [647:576], \$66  };
  assign \activations$226  = activations;
  assign \control$227  = control3;
  assign \shift$228  = shift;
  assign \chain_o$230  = \chain_i$229 ;
  assign \address$231  = step[24:15];
  assign \write_en$232  = unit_en[14];
  assign \write$233  = { \$68 [647:576], \$66  };
  assign \activations$234  = activations;
  assign \control$235  = control3;
  assign \shift$236  = shift;
  assign \chain_o$238  = \chain_i$237 ;
  assign \address$239  = step[24:15];
  assign \write_en$240  = unit_en[15];
  assign \write$241  = { \$68 [647:576], \$66  };
  assign \activations$242  = activations;
  assign \control$243  = control3;
  assign \shift$244  = shift;
  assign \chain_o$246  = \chain_i$245 ;
  assign \address$247  = step[24:15];
  assign \write_en$248  = unit_en[16];
  assign \write$249  = { \$68 [647:576], \$66  };
  assign \activations$250  = activations;
  assign \control$251  = control3;
  assign \shift$252  = shift;
  assign \chain_o$254  = \chain_i$253 ;
  assign \address$255  = step[24:15];
  assign \write_en$256  = unit_en[17];
  assign \write$257  = { \$68 [647:576], \$66  };
  assign \activations$258  = activations;
  assign \control$259  = control3;
  assign \shift$260  = shift;
  assign \chain_o$262  = \chain_i$261 ;
  assign \address$263  = step[24:15];
  assign \write_en$264  = unit_en[18];
  assign \write$265  = { \$68 [647:576], \$66  };
  assign \activations$266  = activations;
  assign \control$267  = control3;
  assign \shift$268  = shift;
  assign \chain_o$270  = \chain_i$269 ;
  assign \address$271  = step[24:15];
  assign \write_en$272  = unit_en[19];
  assign \write$273  = { \$68 [647:576], \$66  };
  assign \activations$274  = activations;
  assign \control$275  = control3;
  assign \shift$276  = shift;
  assign \chain_o$278  = \chain_i$277 ;
  assign \address$279  = step[24:15];
  assign \write_en$280  = unit_en[20];
  assign \write$281  = { \$68 [647:576], \$66  };
  assign \activations$282  = activations;
  assign \control$283  = control3;
  assign \shift$284  = shift;
  assign \chain_o$286  = \chain_i$285 ;
  assign \address$287  = step[24:15];
  assign \write_en$288  = unit_en[21];
  assign \write$289  = { \$68 [647:576], \$66  };
  assign \activations$290  = activations;
  assign \control$291  = control3;
  assign \shift$292  = shift;
  assign \chain_o$294  = \chain_i$293 ;
  assign \address$295  = step[24:15];
  assign \write_en$296  = unit_en[22];
  assign \write$297  = { \$68 [647:576], \$66  };
  assign \activations$298  = activations;
  assign \control$299  = control3;
  assign \shift$300  = shift;
  assign \chain_o$302  = \chain_i$301 ;
  assign \address$303  = step[24:15];
  assign \write_en$304  = unit_en[23];
  assign \write$305  = { \$68 [647:576], \$66  };
  assign \activations$306  = activations;
  assign \control$307  = control3;
  assign \shift$308  = shift;
  assign \chain_o$310  = \chain_i$309 ;
  assign \address$311  = step[24:15];
  assign \write_en$312  = unit_en[24];
  assign \write$313  = { \$68 [647:576], \$66  };
  assign \activations$314  = activations;
  assign \control$315  = control3;
  assign \shift$316  = shift;
  assign \chain_o$318  = \chain_i$317 ;
  assign \address$319  = step[24:15];
  assign \write_en$320  = unit_en[25];
  assign \write$321  = { \$68 [647:576], \$66  };
  assign \activations$322  = activations;
  assign \control$323  = control3;
  assign \shift$324  = shift;
  assign \chain_o$326  = \chain_i$325 ;
  assign \address$327  = step[24:15];
  assign \write_en$328  = unit_en[26];
  assign \write$329  = { \$68 [647:576], \$66  };
  assign \activations$330  = activations;
  assign \control$331  = control3;
  assign \shift$332  = shift;
  assign \chain_o$334  = \chain_i$333 ;
  assign \address$335  = step[24:15];
  assign \write_en$336  = unit_en[27];
  assign \write$337  = { \$68 [647:576], \$66  };
  assign \activations$338  = activations;
  assign \control$339  = control3;
  assign \shift$340  = shift;
  assign \chain_o$342  = \chain_i$341 ;
  assign \address$343  = step[24:15];
  assign \write_en$344  = unit_en[28];
  assign \write$345  = { \$68 [647:576], \$66  };
  assign \activations$346  = activations;
  assign \control$347  = control3;
  assign \shift$348  = shift;
  assign \chain_o$350  = \chain_i$349 ;
  assign \address$351  = step[24:15];
  assign \write_en$352  = unit_en[29];
  assign \write$353  = { \$68 [647:576], \$66  };
  assign \activations$354  = activations;
  assign \control$355  = control3;
  assign \shift$356  = shift;
  assign \chain_o$358  = \chain_i$357 ;
  assign \address$359  = step[24:15];
  assign \write_en$360  = unit_en[30];
  assign \write$361  = { \$68 [647:576], \$66  };
  assign \activations$362  = activations;
  assign \control$363  = control3;
  assign \shift$364  = shift;
  assign \chain_o$366  = \chain_i$365 ;
  assign \address$367  = step[24:15];
  assign \write_en$368  = unit_en[31];
  assign \write$369  = { \$68 [647:576], \$66  };
  assign \activations$370  = activations;
  assign \control$371  = control3;
  assign \shift$372  = shift;
  assign \chain_o$374  = \chain_i$373 ;
  assign \address$375  = step[24:15];
  assign \write_en$376  = unit_en[32];
  assign \write$377  = { \$68 [647:576], \$66  };
  assign \activations$378  = activations;
  assign \control$379  = control3;
  assign \shift$380  = shift;
  assign \chain_o$382  = \chain_i$381 ;
  assign \address$383  = step[24:15];
  assign \write_en$384  = unit_en[33];
  assign \write$385  = { \$68 [647:576], \$66  };
  assign \activations$386  = activations;
  assign \control$387  = control3;
  assign \shift$388  = shift;
  assign \chain_o$390  = \chain_i$389 ;
  assign \address$391  = step[24:15];
  assign \write_en$392  = unit_en[34];
  assign \write$393  = { \$68 [647:576], \$66  };
  assign \activations$394  = activations;
  assign \control$395  = control3;
  assign \shift$396  = shift;
  assign \chain_o$398  = \chain_i$397 ;
  assign \address$399  = step[24:15];
  assign \write_en$400  = unit_en[35];
  assign \write$401  = { \$68 [647:576], \$66  };
  assign \activations$402  = activations;
  assign \control$403  = control3;
  assign \shift$404  = shift;
  assign \chain_o$406  = \chain_i$405 ;
  assign \address$407  = step[24:15];
  assign \write_en$408  = unit_en[36];
  assign \write$409  = { \$68 [647:576], \$66  };
  assign \activations$410  = activations;
  assign \control$411  = control3;
  assign \shift$412  = shift;
  assign \chain_o$414  = \chain_i$413 ;
  assign \address$415  = step[24:15];
  assign \write_en$416  = unit_en[37];
  assign \write$417  = { \$68 [647:576], \$66  };
  assign \activations$418  = activations;
  assign \control$419  = control3;
  assign \shift$420  = shift;
  assign \chain_o$422  = \chain_i$421 ;
  assign \address$423  = step[24:15];
  assign \write_en$424  = unit_en[38];
  assign \write$425  = { \$68 [647:576], \$66  };
  assign \activations$426  = activations;
  assign \control$427  = control3;
  assign \shift$428  = shift;
  assign \chain_o$430  = \chain_i$429 ;
  assign \address$431  = step[24:15];
  assign \write_en$432  = unit_en[39];
  assign \write$433  = { \$68 [647:576], \$66  };
  assign \activations$434  = activations;
  assign \control$435  = control3;
  assign \shift$436  = shift;
  assign \chain_o$438  = \chain_i$437 ;
  assign \address$439  = step[24:15];
  assign \write_en$440  = unit_en[40];
  assign \write$441  = { \$68 [647:576], \$66  };
  assign \activations$442  = activations;
  assign \control$443  = control3;
  assign \shift$444  = shift;
  assign \chain_o$446  = \chain_i$445 ;
  assign \address$447  = step[24:15];
  assign \write_en$448  = unit_en[41];
  assign \write$449  = { \$68 [647:576], \$66  };
  assign \activations$450  = activations;
  assign \control$451  = control3;
  assign \shift$452  = shift;
  assign \chain_o$454  = \chain_i$453 ;
  assign \address$455  = step[24:15];
  assign \write_en$456  = unit_en[42];
  assign \write$457  = { \$68 [647:576], \$66  };
  assign \activations$458  = activations;
  assign \control$459  = control3;
  assign \shift$460  = shift;
  assign \chain_o$462  = \chain_i$461 ;
  assign \address$463  = step[24:15];
  assign \write_en$464  = unit_en[43];
  assign \write$465  = { \$68 [647:576], \$66  };
  assign \activations$466  = activations;
  assign \control$467  = control3;
  assign \shift$468  = shift;
  assign \chain_o$470  = \chain_i$469 ;
  assign \address$471  = step[24:15];
  assign \write_en$472  = unit_en[44];
  assign \write$473  = { \$68 [647:576], \$66  };
  assign \activations$474  = activations;
  assign \control$475  = control3;
  assign \shift$476  = shift;
  assign \chain_o$478  = \chain_i$477 ;
  assign \address$479  = step[24:15];
  assign \write_en$480  = unit_en[45];
  assign \write$481  = { \$68 [647:576], \$66  };
  assign \activations$482  = activations;
  assign \control$483  = control3;
  assign \shift$484  = shift;
  assign \chain_o$486  = \chain_i$485 ;
  assign \address$487  = step[24:15];
  assign \write_en$488  = unit_en[46];
  assign \write$489  = { \$68 [647:576], \$66  };
  assign \activations$490  = activations;
  assign \control$491  = control3;
  assign \shift$492  = shift;
  assign \chain_o$494  = \chain_i$493 ;
  assign \address$495  = step[24:15];
  assign \write_en$496  = unit_en[47];
  assign \write$497  = { \$68 [647:576], \$66  };
  assign \activations$498  = activations;
  assign \control$499  = control3;
  assign \shift$500  = shift;
  assign \chain_o$502  = \chain_i$501 ;
  assign \address$503  = step[24:15];
  assign \write_en$504  = unit_en[48];
  assign \write$505  = { \$68 [647:576], \$66  };
  assign \activations$506  = activations;
  assign \control$507  = control3;
  assign \shift$508  = shift;
  assign \chain_o$510  = \chain_i$509 ;
  assign \address$511  = step[24:15];
  assign \write_en$512  = unit_en[49];
  assign \write$513  = { \$68 [647:576], \$66  };
  assign \activations$514  = activations;
  assign \control$515  = control3;
  assign \shift$516  = shift;
  assign \chain_o$518  = \chain_i$517 ;
  assign \address$519  = step[24:15];
  assign \write_en$520  = unit_en[50];
  assign \write$521  = { \$68 [647:576], \$66  };
  assign \activations$522  = activations;
  assign \control$523  = control3;
  assign \shift$524  = shift;
  assign \chain_o$526  = \chain_i$525 ;
  assign \address$527  = step[24:15];
  assign \write_en$528  = unit_en[51];
  assign \write$529  = { \$68 [647:576], \$66  };
  assign \activations$530  = activations;
  assign \control$531  = control3;
  assign \shift$532  = shift;
  assign \chain_o$534  = \chain_i$533 ;
  assign \address$535  = step[24:15];
  assign \write_en$536  = unit_en[52];
  assign \write$537  = { \$68 [647:576], \$66  };
  assign \activations$538  = activations;
  assign \control$539  = control3;
  assign \shift$540  = shift;
  assign \chain_o$542  = \chain_i$541 ;
  assign \address$543  = step[24:15];
  assign \write_en$544  = unit_en[53];
  assign \write$545  = { \$68 [647:576], \$66  };
  assign \activations$546  = activations;
  assign \control$547  = control3;
  assign \shift$548  = shift;
  assign \chain_o$550  = \chain_i$549 ;
  assign \address$551  = step[24:15];
  assign \write_en$552  = unit_en[54];
  assign \write$553  = { \$68 [647:576], \$66  };
  assign \activations$554  = activations;
  assign \control$555  = control3;
  assign \shift$556  = shift;
  assign \chain_o$558  = \chain_i$557 ;
  assign \address$559  = step[24:15];
  assign \write_en$560  = unit_en[55];
  assign \write$561  = { \$68 [647:576], \$66  };
  assign \activations$562  = activations;
  assign \control$563  = control3;
  assign \shift$564  = shift;
  assign \chain_o$566  = \chain_i$565 ;
  assign \address$567  = step[24:15];
  assign \write_en$568  = unit_en[56];
  assign \write$569  = { \$68 [647:576], \$66  };
  assign \activations$570  = activations;
  assign \control$571  = control3;
  assign \shift$572  = shift;
  assign \chain_o$574  = \chain_i$573 ;
  assign \address$575  = step[24:15];
  assign \write_en$576  = unit_en[57];
  assign \write$577  = { \$68 [647:576], \$66  };
  assign \activations$578  = activations;
  assign \control$579  = control3;
  assign \shift$580  = shift;
  assign \chain_o$582  = \chain_i$581 ;
  assign \address$583  = step[24:15];
  assign \write_en$584  = unit_en[58];
  assign \write$585  = { \$68 [647:576], \$66  };
  assign \activations$586  = activations;
  assign \control$587  = control3;
  assign \shift$588  = shift;
  assign \chain_o$590  = \chain_i$589 ;
  assign \address$591  = step[24:15];
  assign \write_en$592  = unit_en[59];
  assign \write$593  = { \$68 [647:576], \$66  };
  assign \activations$594  = activations;
  assign \control$595  = control3;
  assign \shift$596  = shift;
  assign \chain_o$598  = \chain_i$597 ;
  assign \address$599  = step[24:15];
  assign \write_en$600  = unit_en[60];
  assign \write$601  = { \$68 [647:576], \$66  };
  assign \activations$602  = activations;
  assign \control$603  = control3;
  assign \shift$604  = shift;
  assign \address$605  = step[24:15];
  assign \write_en$606  = unit_en[61];
  assign \write$607  = { \$68 [647:576], \$66  };
  assign \activations$608  = activations;
  assign \control$609  = control3;
  assign \shift$610  = shift;
  assign \address$611  = step[24:15];
  assign \write_en$612  = unit_en[62];
  assign \write$613  = { \$68 [647:576], \$66  };
  assign \activations$614  = activations;
  assign \control$615  = control3;
  assign \shift$616  = shift;
  assign \address$617  = step[24:15];
  assign \write_en$618  = unit_en[63];
  assign \write$619  = { \$68 [647:576], \$66  };
  assign \activations$620  = activations;
  assign \control$621  = control3;
  assign \shift$622  = shift;
  assign soft_reset = \port$1170$0 [3];
  assign \shape.height  = shape[15:0];
  assign \shape.width  = shape[31:16];
  assign \shape.out_height  = shape[47:32];
  assign \shape.groups  = shape[62:48];
  assign \shape.tail  = shape[64:63];
  assign \shape.blocks  = shape[78:65];
  assign \shape.ingest_words  = shape[92:79];
  assign \shape.column_words  = shape[107:93];
  assign \shape.tiles  = shape[119:108];
  assign \shape.output_words  = shape[131:120];
  assign \shape.beats_in  = shape[147:132];
  assign \shape.beats_out  = shape[163:148];
  assign \shape.pointwise  = shape[164];
  assign \shape.halved  = shape[165];
  assign \shape.biased  = shape[166];
  assign \shape$19.height  = shape[15:0];
  assign \shape$19.width  = shape[31:16];
  assign \shape$19.out_height  = shape[47:32];
  assign \shape$19.groups  = shape[62:48];
  assign \shape$19.tail  = shape[64:63];
  assign \shape$19.blocks  = shape[78:65];
  assign \shape$19.ingest_words  = shape[92:79];
  assign \shape$19.column_words  = shape[107:93];
  assign \shape$19.tiles  = shape[119:108];
  assign \shape$19.output_words  = shape[131:120];
  assign \shape$19.beats_in  = shape[147:132];
  assign \shape$19.beats_out  = shape[163:148];
  assign \shape$19.pointwise  = shape[164];
  assign \shape$19.halved  = shape[165];
  assign \shape$19.biased  = shape[166];
  assign \i__payload.data  = i__payload[63:0];
  assign \i__payload.last  = i__payload[64];
  assign \i__payload$42.data  = i__payload[63:0];
  assign \i__payload$42.last  = i__payload[64];
  assign \i__payload$59.data  = \i__payload$59 [47:0];
  assign \i__payload$59.pixel_last  = \i__payload$59 [48];
  assign \i__payload$59.last  = \i__payload$59 [49];
  assign \o__payload$60.data  = \i__payload$59 [47:0];
  assign \o__payload$60.pixel_last  = \i__payload$59 [48];
  assign \o__payload$60.last  = \i__payload$59 [49];
  assign \o__payload$65.data  = \o__payload$65 [63:0];
  assign \o__payload$65.last  = \o__payload$65 [64];
  assign \o__payload$66.data  = \o__payload$65 [63:0];
  assign \o__payload$66.last  = \o__payload$65 [64];
  assign \i__payload$71.data  = \i__payload$71 [63:0];
  assign \i__payload$71.last  = \i__payload$71 [64];
  assign \params__payload.data  = \i__payload$71 [63:0];
  assign \params__payload.last  = \i__payload$71 [64];
  assign \shape$77.height  = shape[15:0];
  assign \shape$77.width  = shape[31:16];
  assign \shape$77.out_height  = shape[47:32];
  assign \shape$77.groups  = shape[62:48];
  assign \shape$77.tail  = shape[64:63];
  assign \shape$77.blocks  = shape[78:65];
  assign \shape$77.ingest_words  = shape[92:79];
  assign \shape$77.column_words  = shape[107:93];
  assign \shape$77.tiles  = shape[119:108];
  assign \shape$77.output_words  = shape[131:120];
  assign \shape$77.beats_in  = shape[147:132];
  assign \shape$77.beats_out  = shape[163:148];
  assign \shape$77.pointwise  = shape[164];
  assign \shape$77.halved  = shape[165];
  assign \shape$77.biased  = shape[166];
  assign \shape$78.height  = shape[15:0];
  assign \shape$78.width  = shape[31:16];
  assign \shape$78.out_height  = shape[47:32];
  assign \shape$78.groups  = shape[62:48];
  assign \shape$78.tail  = shape[64:63];
  assign \shape$78.blocks  = shape[78:65];
  assign \shape$78.ingest_words  = shape[92:79];
  assign \shape$78.column_words  = shape[107:93];
  assign \shape$78.tiles  = shape[119:108];
  assign \shape$78.output_words  = shape[131:120];
  assign \shape$78.beats_in  = shape[147:132];
  assign \shape$78.beats_out  = shape[163:148];
  assign \shape$78.pointwise  = shape[164];
  assign \shape$78.halved  = shape[165];
  assign \shape$78.biased  = shape[166];
  assign \shape$79.height  = shape[15:0];
  assign \shape$79.width  = shape[31:16];
  assign \shape$79.out_height  = shape[47:32];
  assign \shape$79.groups  = shape[62:48];
  assign \shape$79.tail  = shape[64:63];
  assign \shape$79.blocks  = shape[78:65];
  assign \shape$79.ingest_words  = shape[92:79];
  assign \shape$79.column_words  = shape[107:93];
  assign \shape$79.tiles  = shape[119:108];
  assign \shape$79.output_words  = shape[131:120];
  assign \shape$79.beats_in  = shape[147:132];
  assign \shape$79.beats_out  = shape[163:148];
  assign \shape$79.pointwise  = shape[164];
  assign \shape$79.halved  = shape[165];
  assign \shape$79.biased  = shape[166];
  assign \shape$80.height  = shape[15:0];
  assign \shape$80.width  = shape[31:16];
  assign \shape$80.out_height  = shape[47:32];
  assign \shape$80.groups  = shape[62:48];
  assign \shape$80.tail  = shape[64:63];
  assign \shape$80.blocks  = shape[78:65];
  assign \shape$80.ingest_words  = shape[92:79];
  assign \shape$80.column_words  = shape[107:93];
  assign \shape$80.tiles  = shape[119:108];
  assign \shape$80.output_words  = shape[131:120];
  assign \shape$80.beats_in  = shape[147:132];
  assign \shape$80.beats_out  = shape[163:148];
  assign \shape$80.pointwise  = shape[164];
  assign \shape$80.halved  = shape[165];
  assign \shape$80.biased  = shape[166];
  assign \read.slot  = step[1:0];
  assign \read.address  = step[9:2];
  assign \read.bank  = step[10];
  assign \read.mask  = step[14:11];
  assign \step.read  = step[14:0];
  assign \step.read.slot  = step[1:0];
  assign \step.read.address  = step[9:2];
  assign \step.read.bank  = step[10];
  assign \step.read.mask  = step[14:11];
  assign \step.weight  = step[24:15];
  assign \step.control  = step[32:25];
  assign \step.control.en  = step[25];
  assign \step.control.first  = step[26];
  assign \step.control.last  = step[27];
  assign \step.control.edge  = step[28];
  assign \step.control.tile  = step[32:29];
  assign \step.info  = step[43:33];
  assign \step.info.tile  = step[36:33];
  assign \step.info.tile_last  = step[37];
  assign \step.info.slots  = step[41:38];
  assign \step.info.edge  = step[42];
  assign \step.info.image_last  = step[43];
  assign \write.addr  = \$67 ;
  assign \write.data  = \$68 ;
  assign \requant.addr  = \$67 ;
  assign \requant.data  = \$68 ;
  assign \control3.en  = control3[0];
  assign \control3.first  = control3[1];
  assign \control3.last  = control3[2];
  assign \control3.edge  = control3[3];
  assign \control3.tile  = control3[7:4];
  assign \info.tile  = info[3:0];
  assign \info.tile_last  = info[4];
  assign \info.slots  = info[8:5];
  assign \info.edge  = info[9];
  assign \info.image_last  = info[10];
  assign \info3.tile  = info[3:0];
  assign \info3.tile_last  = info[4];
  assign \info3.slots  = info[8:5];
  assign \info3.edge  = info[9];
  assign \info3.image_last  = info[10];
  assign \write$113.addr  = \$66 ;
  assign \write$113.data  = \$68 [647:576];
  assign \weight.addr  = \$66 ;
  assign \weight.data  = \$68 [647:576];
  assign \control.en  = control3[0];
  assign \control.first  = control3[1];
  assign \control.last  = control3[2];
  assign \control.edge  = control3[3];
  assign \control.tile  = control3[7:4];
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
  assign \chain_o$123[0]  = chain_i[18:0];
  assign \chain_o$123[1]  = chain_i[37:19];
  assign \chain_o$123[2]  = chain_i[56:38];
  assign \chain_o$123[3]  = chain_i[75:57];
  assign \write$126.addr  = \$66 ;
  assign \write$126.data  = \$68 [647:576];
  assign \control$128.en  = control3[0];
  assign \control$128.first  = control3[1];
  assign \control$128.last  = control3[2];
  assign \control$128.edge  = control3[3];
  assign \control$128.tile  = control3[7:4];
  assign \chain_o$130[0]  = \chain_o$130 [18:0];
  assign \chain_o$130[1]  = \chain_o$130 [37:19];
  assign \chain_o$130[2]  = \chain_o$130 [56:38];
  assign \chain_o$130[3]  = \chain_o$130 [75:57];
  assign \chain_i$131[0]  = \chain_i$131 [18:0];
  assign \chain_i$131[1]  = \chain_i$131 [37:19];
  assign \chain_i$131[2]  = \chain_i$131 [56:38];
  assign \chain_i$131[3]  = \chain_i$131 [75:57];
  assign \chain_o$132[0]  = \chain_i$131 [18:0];
  assign \chain_o$132[1]  = \chain_i$131 [37:19];
  assign \chain_o$132[2]  = \chain_i$131 [56:38];
  assign \chain_o$132[3]  = \chain_i$131 [75:57];
  assign \write$135.addr  = \$66 ;
  assign \write$135.data  = \$68 [647:576];
  assign \control$137.en  = control3[0];
  assign \control$137.first  = control3[1];
  assign \control$137.last  = control3[2];
  assign \control$137.edge  = control3[3];
  assign \control$137.tile  = control3[7:4];
  assign \chain_o$139[0]  = \chain_o$139 [18:0];
  assign \chain_o$139[1]  = \chain_o$139 [37:19];
  assign \chain_o$139[2]  = \chain_o$139 [56:38];
  assign \chain_o$139[3]  = \chain_o$139 [75:57];
  assign \chain_i$140[0]  = \chain_i$140 [18:0];
  assign \chain_i$140[1]  = \chain_i$140 [37:19];
  assign \chain_i$140[2]  = \chain_i$140 [56:38];
  assign \chain_i$140[3]  = \chain_i$140 [75:57];
  assign \chain_o$141[0]  = \chain_i$140 [18:0];
  assign \chain_o$141[1]  = \chain_i$140 [37:19];
  assign \chain_o$141[2]  = \chain_i$140 [56:38];
  assign \chain_o$141[3]  = \chain_i$140 [75:57];
  assign \write$144.addr  = \$66 ;
  assign \write$144.data  = \$68 [647:576];
  assign \control$146.en  = control3[0];
  assign \control$146.first  = control3[1];
  assign \control$146.last  = control3[2];
  assign \control$146.edge  = control3[3];
  assign \control$146.tile  = control3[7:4];
  assign \chain_o$148[0]  = \chain_o$148 [18:0];
  assign \chain_o$148[1]  = \chain_o$148 [37:19];
  assign \chain_o$148[2]  = \chain_o$148 [56:38];
  assign \chain_o$148[3]  = \chain_o$148 [75:57];
  assign \chain_i$149[0]  = \chain_i$149 [18:0];
  assign \chain_i$149[1]  = \chain_i$149 [37:19];
  assign \chain_i$149[2]  = \chain_i$149 [56:38];
  assign \chain_i$149[3]  = \chain_i$149 [75:57];
  assign \chain_o$150[0]  = \chain_i$149 [18:0];
  assign \chain_o$150[1]  = \chain_i$149 [37:19];
  assign \chain_o$150[2]  = \chain_i$149 [56:38];
  assign \chain_o$150[3]  = \chain_i$149 [75:57];
  assign \write$153.addr  = \$66 ;
  assign \write$153.data  = \$68 [647:576];
  assign \control$155.en  = control3[0];
  assign \control$155.first  = control3[1];
  assign \control$155.last  = control3[2];
  assign \control$155.edge  = control3[3];
  assign \control$155.tile  = control3[7:4];
  assign \chain_i$157[0]  = \chain_i$157 [18:0];
  assign \chain_i$157[1]  = \chain_i$157 [37:19];
  assign \chain_i$157[2]  = \chain_i$157 [56:38];
  assign \chain_i$157[3]  = \chain_i$157 [75:57];
  assign \chain_o$158[0]  = \chain_i$157 [18:0];
  assign \chain_o$158[1]  = \chain_i$157 [37:19];
  assign \chain_o$158[2]  = \chain_i$157 [56:38];
  assign \chain_o$158[3]  = \chain_i$157 [75:57];
  assign \write$161.addr  = \$66 ;
  assign \write$161.data  = \$68 [647:576];
  assign \control$163.en  = control3[0];
  assign \control$163.first  = control3[1];
  assign \control$163.last  = control3[2];
  assign \control$163.edge  = control3[3];
  assign \control$163.tile  = control3[7:4];
  assign \chain_i$165[0]  = \chain_i$165 [18:0];
  assign \chain_i$165[1]  = \chain_i$165 [37:19];
  assign \chain_i$165[2]  = \chain_i$165 [56:38];
  assign \chain_i$165[3]  = \chain_i$165 [75:57];
  assign \chain_o$166[0]  = \chain_i$165 [18:0];
  assign \chain_o$166[1]  = \chain_i$165 [37:19];
  assign \chain_o$166[2]  = \chain_i$165 [56:38];
  assign \chain_o$166[3]  = \chain_i$165 [75:57];
  assign \write$169.addr  = \$66 ;
  assign \write$169.data  = \$68 [647:576];
  assign \control$171.en  = control3[0];
  assign \control$171.first  = control3[1];
  assign \control$171.last  = control3[2];
  assign \control$171.edge  = control3[3];
  assign \control$171.tile  = control3[7:4];
  assign \chain_i$173[0]  = \chain_i$173 [18:0];
  assign \chain_i$173[1]  = \chain_i$173 [37:19];
  assign \chain_i$173[2]  = \chain_i$173 [56:38];
  assign \chain_i$173[3]  = \chain_i$173 [75:57];
  assign \chain_o$174[0]  = \chain_i$173 [18:0];
  assign \chain_o$174[1]  = \chain_i$173 [37:19];
  assign \chain_o$174[2]  = \chain_i$173 [56:38];
  assign \chain_o$174[3]  = \chain_i$173 [75:57];
  assign \write$177.addr  = \$66 ;
  assign \write$177.data  = \$68 [647:576];
  assign \control$179.en  = control3[0];
  assign \control$179.first  = control3[1];
  assign \control$179.last  = control3[2];
  assign \control$179.edge  = control3[3];
  assign \control$179.tile  = control3[7:4];
  assign \chain_i$181[0]  = \chain_i$181 [18:0];
  assign \chain_i$181[1]  = \chain_i$181 [37:19];
  assign \chain_i$181[2]  = \chain_i$181 [56:38];
  assign \chain_i$181[3]  = \chain_i$181 [75:57];
  assign \chain_o$182[0]  = \chain_i$181 [18:0];
  assign \chain_o$182[1]  = \chain_i$181 [37:19];
  assign \chain_o$182[2]  = \chain_i$181 [56:38];
  assign \chain_o$182[3]  = \chain_i$181 [75:57];
  assign \write$185.addr  = \$66 ;
  assign \write$185.data  = \$68 [647:576];
  assign \control$187.en  = control3[0];
  assign \control$187.first  = control3[1];
  assign \control$187.last  = control3[2];
  assign \control$187.edge  = control3[3];
  assign \control$187.tile  = control3[7:4];
  assign \chain_i$189[0]  = \chain_i$189 [18:0];
  assign \chain_i$189[1]  = \chain_i$189 [37:19];
  assign \chain_i$189[2]  = \chain_i$189 [56:38];
  assign \chain_i$189[3]  = \chain_i$189 [75:57];
  assign \chain_o$190[0]  = \chain_i$189 [18:0];
  assign \chain_o$190[1]  = \chain_i$189 [37:19];
  assign \chain_o$190[2]  = \chain_i$189 [56:38];
  assign \chain_o$190[3]  = \chain_i$189 [75:57];
  assign \write$193.addr  = \$66 ;
  assign \write$193.data  = \$68 [647:576];
  assign \control$195.en  = control3[0];
  assign \control$195.first  = control3[1];
  assign \control$195.last  = control3[2];
  assign \control$195.edge  = control3[3];
  assign \control$195.tile  = control3[7:4];
  assign \chain_i$197[0]  = \chain_i$197 [18:0];
  assign \chain_i$197[1]  = \chain_i$197 [37:19];
  assign \chain_i$197[2]  = \chain_i$197 [56:38];
  assign \chain_i$197[3]  = \chain_i$197 [75:57];
  assign \chain_o$198[0]  = \chain_i$197 [18:0];
  assign \chain_o$198[1]  = \chain_i$197 [37:19];
  assign \chain_o$198[2]  = \chain_i$197 [56:38];
  assign \chain_o$198[3]  = \chain_i$197 [75:57];
  assign \write$201.addr  = \$66 ;
  assign \write$201.data  = \$68 [647:576];
  assign \control$203.en  = control3[0];
  assign \control$203.first  = control3[1];
  assign \control$203.last  = control3[2];
  assign \control$203.edge  = control3[3];
  assign \control$203.tile  = control3[7:4];
  assign \chain_i$205[0]  = \chain_i$205 [18:0];
  assign \chain_i$205[1]  = \chain_i$205 [37:19];
  assign \chain_i$205[2]  = \chain_i$205 [56:38];
  assign \chain_i$205[3]  = \chain_i$205 [75:57];
  assign \chain_o$206[0]  = \chain_i$205 [18:0];
  assign \chain_o$206[1]  = \chain_i$205 [37:19];
  assign \chain_o$206[2]  = \chain_i$205 [56:38];
  assign \chain_o$206[3]  = \chain_i$205 [75:57];
  assign \write$209.addr  = \$66 ;
  assign \write$209.data  = \$68 [647:576];
  assign \control$211.en  = control3[0];
  assign \control$211.first  = control3[1];
  assign \control$211.last  = control3[2];
  assign \control$211.edge  = control3[3];
  assign \control$211.tile  = control3[7:4];
  assign \chain_i$213[0]  = \chain_i$213 [18:0];
  assign \chain_i$213[1]  = \chain_i$213 [37:19];
  assign \chain_i$213[2]  = \chain_i$213 [56:38];
  assign \chain_i$213[3]  = \chain_i$213 [75:57];
  assign \chain_o$214[0]  = \chain_i$213 [18:0];
  assign \chain_o$214[1]  = \chain_i$213 [37:19];
  assign \chain_o$214[2]  = \chain_i$213 [56:38];
  assign \chain_o$214[3]  = \chain_i$213 [75:57];
  assign \write$217.addr  = \$66 ;
  assign \write$217.data  = \$68 [647:576];
  assign \control$219.en  = control3[0];
  assign \control$219.first  = control3[1];
  assign \control$219.last  = control3[2];
  assign \control$219.edge  = control3[3];
  assign \control$219.tile  = control3[7:4];
  assign \chain_i$221[0]  = \chain_i$221 [18:0];
  assign \chain_i$221[1]  = \chain_i$221 [37:19];
  assign \chain_i$221[2]  = \chain_i$221 [56:38];
  assign \chain_i$221[3]  = \chain_i$221 [75:57];
  assign \chain_o$222[0]  = \chain_i$221 [18:0];
  assign \chain_o$222[1]  = \chain_i$221 [37:19];
  assign \chain_o$222[2]  = \chain_i$221 [56:38];
  assign \chain_o$222[3]  = \chain_i$221 [75:57];
  assign \write$225.addr  = \$66 ;
  assign \write$225.data  = \$68 [647:576];
  assign \control$227.en  = control3[0];
  assign \control$227.first  = control3[1];
  assign \control$227.last  = control3[2];
  assign \control$227.edge  = control3[3];
  assign \control$227.tile  = control3[7:4];
  assign \chain_i$229[0]  = \chain_i$229 [18:0];
  assign \chain_i$229[1]  = \chain_i$229 [37:19];
  assign \chain_i$229[2]  = \chain_i$229 [56:38];
  assign \chain_i$229[3]  = \chain_i$229 [75:57];
  assign \chain_o$230[0]  = \chain_i$229 [18:0];
  assign \chain_o$230[1]  = \chain_i$229 [37:19];
  assign \chain_o$230[2]  = \chain_i$229 [56:38];
  assign \chain_o$230[3]  = \chain_i$229 [75:57];
  assign \write$233.addr  = \$66 ;
  assign \write$233.data  = \$68 [647:576];
  assign \control$235.en  = control3[0];
  assign \control$235.first  = control3[1];
  assign \control$235.last  = control3[2];
  assign \control$235.edge  = control3[3];
  assign \control$235.tile  = control3[7:4];
  assign \chain_i$237[0]  = \chain_i$237 [18:0];
  assign \chain_i$237[1]  = \chain_i$237 [37:19];
  assign \chain_i$237[2]  = \chain_i$237 [56:38];
  assign \chain_i$237[3]  = \chain_i$237 [75:57];
  assign \chain_o$238[0]  = \chain_i$237 [18:0];
  assign \chain_o$238[1]  = \chain_i$237 [37:19];
  assign \chain_o$238[2]  = \chain_i$237 [56:38];
  assign \chain_o$238[3]  = \chain_i$237 [75:57];
  assign \write$241.addr  = \$66 ;
  assign \write$241.data  = \$68 [647:576];
  assign \control$243.en  = control3[0];
  assign \control$243.first  = control3[1];
  assign \control$243.last  = control3[2];
  assign \control$243.edge  = control3[3];
  assign \control$243.tile  = control3[7:4];
  assign \chain_i$245[0]  = \chain_i$245 [18:0];
  assign \chain_i$245[1]  = \chain_i$245 [37:19];
  assign \chain_i$245[2]  = \chain_i$245 [56:38];
  assign \chain_i$245[3]  = \chain_i$245 [75:57];
  assign \chain_o$246[0]  = \chain_i$245 [18:0];
  assign \chain_o$246[1]  = \chain_i$245 [37:19];
  assign \chain_o$246[2]  = \chain_i$245 [56:38];
  assign \chain_o$246[3]  = \chain_i$245 [75:57];
  assign \write$249.addr  = \$66 ;
  assign \write$249.data  = \$68 [647:576];
  assign \control$251.en  = control3[0];
  assign \control$251.first  = control3[1];
  assign \control$251.last  = control3[2];
  assign \control$251.edge  = control3[3];
  assign \control$251.tile  = control3[7:4];
  assign \chain_i$253[0]  = \chain_i$253 [18:0];
  assign \chain_i$253[1]  = \chain_i$253 [37:19];
  assign \chain_i$253[2]  = \chain_i$253 [56:38];
  assign \chain_i$253[3]  = \chain_i$253 [75:57];
  assign \chain_o$254[0]  = \chain_i$253 [18:0];
  assign \chain_o$254[1]  = \chain_i$253 [37:19];
  assign \chain_o$254[2]  = \chain_i$253 [56:38];
  assign \chain_o$254[3]  = \chain_i$253 [75:57];
  assign \write$257.addr  = \$66 ;
  assign \write$257.data  = \$68 [647:576];
  assign \control$259.en  = control3[0];
  assign \control$259.first  = control3[1];
  assign \control$259.last  = control3[2];
  assign \control$259.edge  = control3[3];
  assign \control$259.tile  = control3[7:4];
  assign \chain_i$261[0]  = \chain_i$261 [18:0];
  assign \chain_i$261[1]  = \chain_i$261 [37:19];
  assign \chain_i$261[2]  = \chain_i$261 [56:38];
  assign \chain_i$261[3]  = \chain_i$261 [75:57];
  assign \chain_o$262[0]  = \chain_i$261 [18:0];
  assign \chain_o$262[1]  = \chain_i$261 [37:19];
  assign \chain_o$262[2]  = \chain_i$261 [56:38];
  assign \chain_o$262[3]  = \chain_i$261 [75:57];
  assign \write$265.addr  = \$66 ;
  assign \write$265.data  = \$68 [647:576];
  assign \control$267.en  = control3[0];
  assign \control$267.first  = control3[1];
  assign \control$267.last  = control3[2];
  assign \control$267.edge  = control3[3];
  assign \control$267.tile  = control3[7:4];
  assign \chain_i$269[0]  = \chain_i$269 [18:0];
  assign \chain_i$269[1]  = \chain_i$269 [37:19];
  assign \chain_i$269[2]  = \chain_i$269 [56:38];
  assign \chain_i$269[3]  = \chain_i$269 [75:57];
  assign \chain_o$270[0]  = \chain_i$269 [18:0];
  assign \chain_o$270[1]  = \chain_i$269 [37:19];
  assign \chain_o$270[2]  = \chain_i$269 [56:38];
  assign \chain_o$270[3]  = \chain_i$269 [75:57];
  assign \write$273.addr  = \$66 ;
  assign \write$273.data  = \$68 [647:576];
  assign \control$275.en  = control3[0];
  assign \control$275.first  = control3[1];
  assign \control$275.last  = control3[2];
  assign \control$275.edge  = control3[3];
  assign \control$275.tile  = control3[7:4];
  assign \chain_i$277[0]  = \chain_i$277 [18:0];
  assign \chain_i$277[1]  = \chain_i$277 [37:19];
  assign \chain_i$277[2]  = \chain_i$277 [56:38];
  assign \chain_i$277[3]  = \chain_i$277 [75:57];
  assign \chain_o$278[0]  = \chain_i$277 [18:0];
  assign \chain_o$278[1]  = \chain_i$277 [37:19];
  assign \chain_o$278[2]  = \chain_i$277 [56:38];
  assign \chain_o$278[3]  = \chain_i$277 [75:57];
  assign \write$281.addr  = \$66 ;
  assign \write$281.data  = \$68 [647:576];
  assign \control$283.en  = control3[0];
  assign \control$283.first  = control3[1];
  assign \control$283.last  = control3[2];
  assign \control$283.edge  = control3[3];
  assign \control$283.tile  = control3[7:4];
  assign \chain_i$285[0]  = \chain_i$285 [18:0];
  assign \chain_i$285[1]  = \chain_i$285 [37:19];
  assign \chain_i$285[2]  = \chain_i$285 [56:38];
  assign \chain_i$285[3]  = \chain_i$285 [75:57];
  assign \chain_o$286[0]  = \chain_i$285 [18:0];
  assign \chain_o$286[1]  = \chain_i$285 [37:19];
  assign \chain_o$286[2]  = \chain_i$285 [56:38];
  assign \chain_o$286[3]  = \chain_i$285 [75:57];
  assign \write$289.addr  = \$66 ;
  assign \write$289.data  = \$68 [647:576];
  assign \control$291.en  = control3[0];
  assign \control$291.first  = control3[1];
  assign \control$291.last  = control3[2];
  assign \control$291.edge  = control3[3];
  assign \control$291.tile  = control3[7:4];
  assign \chain_i$293[0]  = \chain_i$293 [18:0];
  assign \chain_i$293[1]  = \chain_i$293 [37:19];
  assign \chain_i$293[2]  = \chain_i$293 [56:38];
  assign \chain_i$293[3]  = \chain_i$293 [75:57];
  assign \chain_o$294[0]  = \chain_i$293 [18:0];
  assign \chain_o$294[1]  = \chain_i$293 [37:19];
  assign \chain_o$294[2]  = \chain_i$293 [56:38];
  assign \chain_o$294[3]  = \chain_i$293 [75:57];
  assign \write$297.addr  = \$66 ;
  assign \write$297.data  = \$68 [647:576];
  assign \control$299.en  = control3[0];
  assign \control$299.first  = control3[1];
  assign \control$299.last  = control3[2];
  assign \control$299.edge  = control3[3];
  assign \control$299.tile  = control3[7:4];
  assign \chain_i$301[0]  = \chain_i$301 [18:0];
  assign \chain_i$301[1]  = \chain_i$301 [37:19];
  assign \chain_i$301[2]  = \chain_i$301 [56:38];
  assign \chain_i$301[3]  = \chain_i$301 [75:57];
  assign \chain_o$302[0]  = \chain_i$301 [18:0];
  assign \chain_o$302[1]  = \chain_i$301 [37:19];
  assign \chain_o$302[2]  = \chain_i$301 [56:38];
  assign \chain_o$302[3]  = \chain_i$301 [75:57];
  assign \write$305.addr  = \$66 ;
  assign \write$305.data  = \$68 [647:576];
  assign \control$307.en  = control3[0];
  assign \control$307.first  = control3[1];
  assign \control$307.last  = control3[2];
  assign \control$307.edge  = control3[3];
  assign \control$307.tile  = control3[7:4];
  assign \chain_i$309[0]  = \chain_i$309 [18:0];
  assign \chain_i$309[1]  = \chain_i$309 [37:19];
  assign \chain_i$309[2]  = \chain_i$309 [56:38];
  assign \chain_i$309[3]  = \chain_i$309 [75:57];
  assign \chain_o$310[0]  = \chain_i$309 [18:0];
  assign \chain_o$310[1]  = \chain_i$309 [37:19];
  assign \chain_o$310[2]  = \chain_i$309 [56:38];
  assign \chain_o$310[3]  = \chain_i$309 [75:57];
  assign \write$313.addr  = \$66 ;
  assign \write$313.data  = \$68 [647:576];
  assign \control$315.en  = control3[0];
  assign \control$315.first  = control3[1];
  assign \control$315.last  = control3[2];
  assign \control$315.edge  = control3[3];
  assign \control$315.tile  = control3[7:4];
  assign \chain_i$317[0]  = \chain_i$317 [18:0];
  assign \chain_i$317[1]  = \chain_i$317 [37:19];
  assign \chain_i$317[2]  = \chain_i$317 [56:38];
  assign \chain_i$317[3]  = \chain_i$317 [75:57];
  assign \chain_o$318[0]  = \chain_i$317 [18:0];
  assign \chain_o$318[1]  = \chain_i$317 [37:19];
  assign \chain_o$318[2]  = \chain_i$317 [56:38];
  assign \chain_o$318[3]  = \chain_i$317 [75:57];
  assign \write$321.addr  = \$66 ;
  assign \write$321.data  = \$68 [647:576];
  assign \control$323.en  = control3[0];
  assign \control$323.first  = control3[1];
  assign \control$323.last  = control3[2];
  assign \control$323.edge  = control3[3];
  assign \control$323.tile  = control3[7:4];
  assign \chain_i$325[0]  = \chain_i$325 [18:0];
  assign \chain_i$325[1]  = \chain_i$325 [37:19];
  assign \chain_i$325[2]  = \chain_i$325 [56:38];
  assign \chain_i$325[3]  = \chain_i$325 [75:57];
  assign \chain_o$326[0]  = \chain_i$325 [18:0];
  assign \chain_o$326[1]  = \chain_i$325 [37:19];
  assign \chain_o$326[2]  = \chain_i$325 [56:38];
  assign \chain_o$326[3]  = \chain_i$325 [75:57];
  assign \write$329.addr  = \$66 ;
  assign \write$329.data  = \$68 [647:576];
  assign \control$331.en  = control3[0];
  assign \control$331.first  = control3[1];
  assign \control$331.last  = control3[2];
  assign \control$331.edge  = control3[3];
  assign \control$331.tile  = control3[7:4];
  assign \chain_i$333[0]  = \chain_i$333 [18:0];
  assign \chain_i$333[1]  = \chain_i$333 [37:19];
  assign \chain_i$333[2]  = \chain_i$333 [56:38];
  assign \chain_i$333[3]  = \chain_i$333 [75:57];
  assign \chain_o$334[0]  = \chain_i$333 [18:0];
  assign \chain_o$334[1]  = \chain_i$333 [37:19];
  assign \chain_o$334[2]  = \chain_i$333 [56:38];
  assign \chain_o$334[3]  = \chain_i$333 [75:57];
  assign \write$337.addr  = \$66 ;
  assign \write$337.data  = \$68 [647:576];
  assign \control$339.en  = control3[0];
  assign \control$339.first  = control3[1];
  assign \control$339.last  = control3[2];
  assign \control$339.edge  = control3[3];
  assign \control$339.tile  = control3[7:4];
  assign \chain_i$341[0]  = \chain_i$341 [18:0];
  assign \chain_i$341[1]  = \chain_i$341 [37:19];
  assign \chain_i$341[2]  = \chain_i$341 [56:38];
  assign \chain_i$341[3]  = \chain_i$341 [75:57];
  assign \chain_o$342[0]  = \chain_i$341 [18:0];
  assign \chain_o$342[1]  = \chain_i$341 [37:19];
  assign \chain_o$342[2]  = \chain_i$341 [56:38];
  assign \chain_o$342[3]  = \chain_i$341 [75:57];
  assign \write$345.addr  = \$66 ;
  assign \write$345.data  = \$68 [647:576];
  assign \control$347.en  = control3[0];
  assign \control$347.first  = control3[1];
  assign \control$347.last  = control3[2];
  assign \control$347.edge  = control3[3];
  assign \control$347.tile  = control3[7:4];
  assign \chain_i$349[0]  = \chain_i$349 [18:0];
  assign \chain_i$349[1]  = \chain_i$349 [37:19];
  assign \chain_i$349[2]  = \chain_i$349 [56:38];
  assign \chain_i$349[3]  = \chain_i$349 [75:57];
  assign \chain_o$350[0]  = \chain_i$349 [18:0];
  assign \chain_o$350[1]  = \chain_i$349 [37:19];
  assign \chain_o$350[2]  = \chain_i$349 [56:38];
  assign \chain_o$350[3]  = \chain_i$349 [75:57];
  assign \write$353.addr  = \$66 ;
  assign \write$353.data  = \$68 [647:576];
  assign \control$355.en  = control3[0];
  assign \control$355.first  = control3[1];
  assign \control$355.last  = control3[2];
  assign \control$355.edge  = control3[3];
  assign \control$355.tile  = control3[7:4];
  assign \chain_i$357[0]  = \chain_i$357 [18:0];
  assign \chain_i$357[1]  = \chain_i$357 [37:19];
  assign \chain_i$357[2]  = \chain_i$357 [56:38];
  assign \chain_i$357[3]  = \chain_i$357 [75:57];
  assign \chain_o$358[0]  = \chain_i$357 [18:0];
  assign \chain_o$358[1]  = \chain_i$357 [37:19];
  assign \chain_o$358[2]  = \chain_i$357 [56:38];
  assign \chain_o$358[3]  = \chain_i$357 [75:57];
  assign \write$361.addr  = \$66 ;
  assign \write$361.data  = \$68 [647:576];
  assign \control$363.en  = control3[0];
  assign \control$363.first  = control3[1];
  assign \control$363.last  = control3[2];
  assign \control$363.edge  = control3[3];
  assign \control$363.tile  = control3[7:4];
  assign \chain_i$365[0]  = \chain_i$365 [18:0];
  assign \chain_i$365[1]  = \chain_i$365 [37:19];
  assign \chain_i$365[2]  = \chain_i$365 [56:38];
  assign \chain_i$365[3]  = \chain_i$365 [75:57];
  assign \chain_o$366[0]  = \chain_i$365 [18:0];
  assign \chain_o$366[1]  = \chain_i$365 [37:19];
  assign \chain_o$366[2]  = \chain_i$365 [56:38];
  assign \chain_o$366[3]  = \chain_i$365 [75:57];
  assign \write$369.addr  = \$66 ;
  assign \write$369.data  = \$68 [647:576];
  assign \control$371.en  = control3[0];
  assign \control$371.first  = control3[1];
  assign \control$371.last  = control3[2];
  assign \control$371.edge  = control3[3];
  assign \control$371.tile  = control3[7:4];
  assign \chain_i$373[0]  = \chain_i$373 [18:0];
  assign \chain_i$373[1]  = \chain_i$373 [37:19];
  assign \chain_i$373[2]  = \chain_i$373 [56:38];
  assign \chain_i$373[3]  = \chain_i$373 [75:57];
  assign \chain_o$374[0]  = \chain_i$373 [18:0];
  assign \chain_o$374[1]  = \chain_i$373 [37:19];
  assign \chain_o$374[2]  = \chain_i$373 [56:38];
  assign \chain_o$374[3]  = \chain_i$373 [75:57];
  assign \write$377.addr  = \$66 ;
  assign \write$377.data  = \$68 [647:576];
  assign \control$379.en  = control3[0];
  assign \control$379.first  = control3[1];
  assign \control$379.last  = control3[2];
  assign \control$379.edge  = control3[3];
  assign \control$379.tile  = control3[7:4];
  assign \chain_i$381[0]  = \chain_i$381 [18:0];
  assign \chain_i$381[1]  = \chain_i$381 [37:19];
  assign \chain_i$381[2]  = \chain_i$381 [56:38];
  assign \chain_i$381[3]  = \chain_i$381 [75:57];
  assign \chain_o$382[0]  = \chain_i$381 [18:0];
  assign \chain_o$382[1]  = \chain_i$381 [37:19];
  assign \chain_o$382[2]  = \chain_i$381 [56:38];
  assign \chain_o$382[3]  = \chain_i$381 [75:57];
  assign \write$385.addr  = \$66 ;
  assign \write$385.data  = \$68 [647:576];
  assign \control$387.en  = control3[0];
  assign \control$387.first  = control3[1];
  assign \control$387.last  = control3[2];
  assign \control$387.edge  = control3[3];
  assign \control$387.tile  = control3[7:4];
  assign \chain_i$389[0]  = \chain_i$389 [18:0];
  assign \chain_i$389[1]  = \chain_i$389 [37:19];
  assign \chain_i$389[2]  = \chain_i$389 [56:38];
  assign \chain_i$389[3]  = \chain_i$389 [75:57];
  assign \chain_o$390[0]  = \chain_i$389 [18:0];
  assign \chain_o$390[1]  = \chain_i$389 [37:19];
  assign \chain_o$390[2]  = \chain_i$389 [56:38];
  assign \chain_o$390[3]  = \chain_i$389 [75:57];
  assign \write$393.addr  = \$66 ;
  assign \write$393.data  = \$68 [647:576];
  assign \control$395.en  = control3[0];
  assign \control$395.first  = control3[1];
  assign \control$395.last  = control3[2];
  assign \control$395.edge  = control3[3];
  assign \control$395.tile  = control3[7:4];
  assign \chain_i$397[0]  = \chain_i$397 [18:0];
  assign \chain_i$397[1]  = \chain_i$397 [37:19];
  assign \chain_i$397[2]  = \chain_i$397 [56:38];
  assign \chain_i$397[3]  = \chain_i$397 [75:57];
  assign \chain_o$398[0]  = \chain_i$397 [18:0];
  assign \chain_o$398[1]  = \chain_i$397 [37:19];
  assign \chain_o$398[2]  = \chain_i$397 [56:38];
  assign \chain_o$398[3]  = \chain_i$397 [75:57];
  assign \write$401.addr  = \$66 ;
  assign \write$401.data  = \$68 [647:576];
  assign \control$403.en  = control3[0];
  assign \control$403.first  = control3[1];
  assign \control$403.last  = control3[2];
  assign \control$403.edge  = control3[3];
  assign \control$403.tile  = control3[7:4];
  assign \chain_i$405[0]  = \chain_i$405 [18:0];
  assign \chain_i$405[1]  = \chain_i$405 [37:19];
  assign \chain_i$405[2]  = \chain_i$405 [56:38];
  assign \chain_i$405[3]  = \chain_i$405 [75:57];
  assign \chain_o$406[0]  = \chain_i$405 [18:0];
  assign \chain_o$406[1]  = \chain_i$405 [37:19];
  assign \chain_o$406[2]  = \chain_i$405 [56:38];
  assign \chain_o$406[3]  = \chain_i$405 [75:57];
  assign \write$409.addr  = \$66 ;
  assign \write$409.data  = \$68 [647:576];
  assign \control$411.en  = control3[0];
  assign \control$411.first  = control3[1];
  assign \control$411.last  = control3[2];
  assign \control$411.edge  = control3[3];
  assign \control$411.tile  = control3[7:4];
  assign \chain_i$413[0]  = \chain_i$413 [18:0];
  assign \chain_i$413[1]  = \chain_i$413 [37:19];
  assign \chain_i$413[2]  = \chain_i$413 [56:38];
  assign \chain_i$413[3]  = \chain_i$413 [75:57];
  assign \chain_o$414[0]  = \chain_i$413 [18:0];
  assign \chain_o$414[1]  = \chain_i$413 [37:19];
  assign \chain_o$414[2]  = \chain_i$413 [56:38];
  assign \chain_o$414[3]  = \chain_i$413 [75:57];
  assign \write$417.addr  = \$66 ;
  assign \write$417.data  = \$68 [647:576];
  assign \control$419.en  = control3[0];
  assign \control$419.first  = control3[1];
  assign \control$419.last  = control3[2];
  assign \control$419.edge  = control3[3];
  assign \control$419.tile  = control3[7:4];
  assign \chain_i$421[0]  = \chain_i$421 [18:0];
  assign \chain_i$421[1]  = \chain_i$421 [37:19];
  assign \chain_i$421[2]  = \chain_i$421 [56:38];
  assign \chain_i$421[3]  = \chain_i$421 [75:57];
  assign \chain_o$422[0]  = \chain_i$421 [18:0];
  assign \chain_o$422[1]  = \chain_i$421 [37:19];
  assign \chain_o$422[2]  = \chain_i$421 [56:38];
  assign \chain_o$422[3]  = \chain_i$421 [75:57];
  assign \write$425.addr  = \$66 ;
  assign \write$425.data  = \$68 [647:576];
  assign \control$427.en  = control3[0];
  assign \control$427.first  = control3[1];
  assign \control$427.last  = control3[2];
  assign \control$427.edge  = control3[3];
  assign \control$427.tile  = control3[7:4];
  assign \chain_i$429[0]  = \chain_i$429 [18:0];
  assign \chain_i$429[1]  = \chain_i$429 [37:19];
  assign \chain_i$429[2]  = \chain_i$429 [56:38];
  assign \chain_i$429[3]  = \chain_i$429 [75:57];
  assign \chain_o$430[0]  = \chain_i$429 [18:0];
  assign \chain_o$430[1]  = \chain_i$429 [37:19];
  assign \chain_o$430[2]  = \chain_i$429 [56:38];
  assign \chain_o$430[3]  = \chain_i$429 [75:57];
  assign \write$433.addr  = \$66 ;
  assign \write$433.data  = \$68 [647:576];
  assign \control$435.en  = control3[0];
  assign \control$435.first  = control3[1];
  assign \control$435.last  = control3[2];
  assign \control$435.edge  = control3[3];
  assign \control$435.tile  = control3[7:4];
  assign \chain_i$437[0]  = \chain_i$437 [18:0];
  assign \chain_i$437[1]  = \chain_i$437 [37:19];
  assign \chain_i$437[2]  = \chain_i$437 [56:38];
  assign \chain_i$437[3]  = \chain_i$437 [75:57];
  assign \chain_o$438[0]  = \chain_i$437 [18:0];
  assign \chain_o$438[1]  = \chain_i$437 [37:19];
  assign \chain_o$438[2]  = \chain_i$437 [56:38];
  assign \chain_o$438[3]  = \chain_i$437 [75:57];
  assign \write$441.addr  = \$66 ;
  assign \write$441.data  = \$68 [647:576];
  assign \control$443.en  = control3[0];
  assign \control$443.first  = control3[1];
  assign \control$443.last  = control3[2];
  assign \control$443.edge  = control3[3];
  assign \control$443.tile  = control3[7:4];
  assign \chain_i$445[0]  = \chain_i$445 [18:0];
  assign \chain_i$445[1]  = \chain_i$445 [37:19];
  assign \chain_i$445[2]  = \chain_i$445 [56:38];
  assign \chain_i$445[3]  = \chain_i$445 [75:57];
  assign \chain_o$446[0]  = \chain_i$445 [18:0];
  assign \chain_o$446[1]  = \chain_i$445 [37:19];
  assign \chain_o$446[2]  = \chain_i$445 [56:38];
  assign \chain_o$446[3]  = \chain_i$445 [75:57];
  assign \write$449.addr  = \$66 ;
  assign \write$449.data  = \$68 [647:576];
  assign \control$451.en  = control3[0];
  assign \control$451.first  = control3[1];
  assign \control$451.last  = control3[2];
  assign \control$451.edge  = control3[3];
  assign \control$451.tile  = control3[7:4];
  assign \chain_i$453[0]  = \chain_i$453 [18:0];
  assign \chain_i$453[1]  = \chain_i$453 [37:19];
  assign \chain_i$453[2]  = \chain_i$453 [56:38];
  assign \chain_i$453[3]  = \chain_i$453 [75:57];
  assign \chain_o$454[0]  = \chain_i$453 [18:0];
  assign \chain_o$454[1]  = \chain_i$453 [37:19];
  assign \chain_o$454[2]  = \chain_i$453 [56:38];
  assign \chain_o$454[3]  = \chain_i$453 [75:57];
  assign \write$457.addr  = \$66 ;
  assign \write$457.data  = \$68 [647:576];
  assign \control$459.en  = control3[0];
  assign \control$459.first  = control3[1];
  assign \control$459.last  = control3[2];
  assign \control$459.edge  = control3[3];
  assign \control$459.tile  = control3[7:4];
  assign \chain_i$461[0]  = \chain_i$461 [18:0];
  assign \chain_i$461[1]  = \chain_i$461 [37:19];
  assign \chain_i$461[2]  = \chain_i$461 [56:38];
  assign \chain_i$461[3]  = \chain_i$461 [75:57];
  assign \chain_o$462[0]  = \chain_i$461 [18:0];
  assign \chain_o$462[1]  = \chain_i$461 [37:19];
  assign \chain_o$462[2]  = \chain_i$461 [56:38];
  assign \chain_o$462[3]  = \chain_i$461 [75:57];
  assign \write$465.addr  = \$66 ;
  assign \write$465.data  = \$68 [647:576];
  assign \control$467.en  = control3[0];
  assign \control$467.first  = control3[1];
  assign \control$467.last  = control3[2];
  assign \control$467.edge  = control3[3];
  assign \control$467.tile  = control3[7:4];
  assign \chain_i$469[0]  = \chain_i$469 [18:0];
  assign \chain_i$469[1]  = \chain_i$469 [37:19];
  assign \chain_i$469[2]  = \chain_i$469 [56:38];
  assign \chain_i$469[3]  = \chain_i$469 [75:57];
  assign \chain_o$470[0]  = \chain_i$469 [18:0];
  assign \chain_o$470[1]  = \chain_i$469 [37:19];
  assign \chain_o$470[2]  = \chain_i$469 [56:38];
  assign \chain_o$470[3]  = \chain_i$469 [75:57];
  assign \write$473.addr  = \$66 ;
  assign \write$473.data  = \$68 [647:576];
  assign \control$475.en  = control3[0];
  assign \control$475.first  = control3[1];
  assign \control$475.last  = control3[2];
  assign \control$475.edge  = control3[3];
  assign \control$475.tile  = control3[7:4];
  assign \chain_i$477[0]  = \chain_i$477 [18:0];
  assign \chain_i$477[1]  = \chain_i$477 [37:19];
  assign \chain_i$477[2]  = \chain_i$477 [56:38];
  assign \chain_i$477[3]  = \chain_i$477 [75:57];
  assign \chain_o$478[0]  = \chain_i$477 [18:0];
  assign \chain_o$478[1]  = \chain_i$477 [37:19];
  assign \chain_o$478[2]  = \chain_i$477 [56:38];
  assign \chain_o$478[3]  = \chain_i$477 [75:57];
  assign \write$481.addr  = \$66 ;
  assign \write$481.data  = \$68 [647:576];
  assign \control$483.en  = control3[0];
  assign \control$483.first  = control3[1];
  assign \control$483.last  = control3[2];
  assign \control$483.edge  = control3[3];
  assign \control$483.tile  = control3[7:4];
  assign \chain_i$485[0]  = \chain_i$485 [18:0];
  assign \chain_i$485[1]  = \chain_i$485 [37:19];
  assign \chain_i$485[2]  = \chain_i$485 [56:38];
  assign \chain_i$485[3]  = \chain_i$485 [75:57];
  assign \chain_o$486[0]  = \chain_i$485 [18:0];
  assign \chain_o$486[1]  = \chain_i$485 [37:19];
  assign \chain_o$486[2]  = \chain_i$485 [56:38];
  assign \chain_o$486[3]  = \chain_i$485 [75:57];
  assign \write$489.addr  = \$66 ;
  assign \write$489.data  = \$68 [647:576];
  assign \control$491.en  = control3[0];
  assign \control$491.first  = control3[1];
  assign \control$491.last  = control3[2];
  assign \control$491.edge  = control3[3];
  assign \control$491.tile  = control3[7:4];
  assign \chain_i$493[0]  = \chain_i$493 [18:0];
  assign \chain_i$493[1]  = \chain_i$493 [37:19];
  assign \chain_i$493[2]  = \chain_i$493 [56:38];
  assign \chain_i$493[3]  = \chain_i$493 [75:57];
  assign \chain_o$494[0]  = \chain_i$493 [18:0];
  assign \chain_o$494[1]  = \chain_i$493 [37:19];
  assign \chain_o$494[2]  = \chain_i$493 [56:38];
  assign \chain_o$494[3]  = \chain_i$493 [75:57];
  assign \write$497.addr  = \$66 ;
  assign \write$497.data  = \$68 [647:576];
  assign \control$499.en  = control3[0];
  assign \control$499.first  = control3[1];
  assign \control$499.last  = control3[2];
  assign \control$499.edge  = control3[3];
  assign \control$499.tile  = control3[7:4];
  assign \chain_i$501[0]  = \chain_i$501 [18:0];
  assign \chain_i$501[1]  = \chain_i$501 [37:19];
  assign \chain_i$501[2]  = \chain_i$501 [56:38];
  assign \chain_i$501[3]  = \chain_i$501 [75:57];
  assign \chain_o$502[0]  = \chain_i$501 [18:0];
  assign \chain_o$502[1]  = \chain_i$501 [37:19];
  assign \chain_o$502[2]  = \chain_i$501 [56:38];
  assign \chain_o$502[3]  = \chain_i$501 [75:57];
  assign \write$505.addr  = \$66 ;
  assign \write$505.data  = \$68 [647:576];
  assign \control$507.en  = control3[0];
  assign \control$507.first  = control3[1];
  assign \control$507.last  = control3[2];
  assign \control$507.edge  = control3[3];
  assign \control$507.tile  = control3[7:4];
  assign \chain_i$509[0]  = \chain_i$509 [18:0];
  assign \chain_i$509[1]  = \chain_i$509 [37:19];
  assign \chain_i$509[2]  = \chain_i$509 [56:38];
  assign \chain_i$509[3]  = \chain_i$509 [75:57];
  assign \chain_o$510[0]  = \chain_i$509 [18:0];
  assign \chain_o$510[1]  = \chain_i$509 [37:19];
  assign \chain_o$510[2]  = \chain_i$509 [56:38];
  assign \chain_o$510[3]  = \chain_i$509 [75:57];
  assign \write$513.addr  = \$66 ;
  assign \write$513.data  = \$68 [647:576];
  assign \control$515.en  = control3[0];
  assign \control$515.first  = control3[1];
  assign \control$515.last  = control3[2];
  assign \control$515.edge  = control3[3];
  assign \control$515.tile  = control3[7:4];
  assign \chain_i$517[0]  = \chain_i$517 [18:0];
  assign \chain_i$517[1]  = \chain_i$517 [37:19];
  assign \chain_i$517[2]  = \chain_i$517 [56:38];
  assign \chain_i$517[3]  = \chain_i$517 [75:57];
  assign \chain_o$518[0]  = \chain_i$517 [18:0];
  assign \chain_o$518[1]  = \chain_i$517 [37:19];
  assign \chain_o$518[2]  = \chain_i$517 [56:38];
  assign \chain_o$518[3]  = \chain_i$517 [75:57];
  assign \write$521.addr  = \$66 ;
  assign \write$521.data  = \$68 [647:576];
  assign \control$523.en  = control3[0];
  assign \control$523.first  = control3[1];
  assign \control$523.last  = control3[2];
  assign \control$523.edge  = control3[3];
  assign \control$523.tile  = control3[7:4];
  assign \chain_i$525[0]  = \chain_i$525 [18:0];
  assign \chain_i$525[1]  = \chain_i$525 [37:19];
  assign \chain_i$525[2]  = \chain_i$525 [56:38];
  assign \chain_i$525[3]  = \chain_i$525 [75:57];
  assign \chain_o$526[0]  = \chain_i$525 [18:0];
  assign \chain_o$526[1]  = \chain_i$525 [37:19];
  assign \chain_o$526[2]  = \chain_i$525 [56:38];
  assign \chain_o$526[3]  = \chain_i$525 [75:57];
  assign \write$529.addr  = \$66 ;
  assign \write$529.data  = \$68 [647:576];
  assign \control$531.en  = control3[0];
  assign \control$531.first  = control3[1];
  assign \control$531.last  = control3[2];
  assign \control$531.edge  = control3[3];
  assign \control$531.tile  = control3[7:4];
  assign \chain_i$533[0]  = \chain_i$533 [18:0];
  assign \chain_i$533[1]  = \chain_i$533 [37:19];
  assign \chain_i$533[2]  = \chain_i$533 [56:38];
  assign \chain_i$533[3]  = \chain_i$533 [75:57];
  assign \chain_o$534[0]  = \chain_i$533 [18:0];
  assign \chain_o$534[1]  = \chain_i$533 [37:19];
  assign \chain_o$534[2]  = \chain_i$533 [56:38];
  assign \chain_o$534[3]  = \chain_i$533 [75:57];
  assign \write$537.addr  = \$66 ;
  assign \write$537.data  = \$68 [647:576];
  assign \control$539.en  = control3[0];
  assign \control$539.first  = control3[1];
  assign \control$539.last  = control3[2];
  assign \control$539.edge  = control3[3];
  assign \control$539.tile  = control3[7:4];
  assign \chain_i$541[0]  = \chain_i$541 [18:0];
  assign \chain_i$541[1]  = \chain_i$541 [37:19];
  assign \chain_i$541[2]  = \chain_i$541 [56:38];
  assign \chain_i$541[3]  = \chain_i$541 [75:57];
  assign \chain_o$542[0]  = \chain_i$541 [18:0];
  assign \chain_o$542[1]  = \chain_i$541 [37:19];
  assign \chain_o$542[2]  = \chain_i$541 [56:38];
  assign \chain_o$542[3]  = \chain_i$541 [75:57];
  assign \write$545.addr  = \$66 ;
  assign \write$545.data  = \$68 [647:576];
  assign \control$547.en  = control3[0];
  assign \control$547.first  = control3[1];
  assign \control$547.last  = control3[2];
  assign \control$547.edge  = control3[3];
  assign \control$547.tile  = control3[7:4];
  assign \chain_i$549[0]  = \chain_i$549 [18:0];
  assign \chain_i$549[1]  = \chain_i$549 [37:19];
  assign \chain_i$549[2]  = \chain_i$549 [56:38];
  assign \chain_i$549[3]  = \chain_i$549 [75:57];
  assign \chain_o$550[0]  = \chain_i$549 [18:0];
  assign \chain_o$550[1]  = \chain_i$549 [37:19];
  assign \chain_o$550[2]  = \chain_i$549 [56:38];
  assign \chain_o$550[3]  = \chain_i$549 [75:57];
  assign \write$553.addr  = \$66 ;
  assign \write$553.data  = \$68 [647:576];
  assign \control$555.en  = control3[0];
  assign \control$555.first  = control3[1];
  assign \control$555.last  = control3[2];
  assign \control$555.edge  = control3[3];
  assign \control$555.tile  = control3[7:4];
  assign \chain_i$557[0]  = \chain_i$557 [18:0];
  assign \chain_i$557[1]  = \chain_i$557 [37:19];
  assign \chain_i$557[2]  = \chain_i$557 [56:38];
  assign \chain_i$557[3]  = \chain_i$557 [75:57];
  assign \chain_o$558[0]  = \chain_i$557 [18:0];
  assign \chain_o$558[1]  = \chain_i$557 [37:19];
  assign \chain_o$558[2]  = \chain_i$557 [56:38];
  assign \chain_o$558[3]  = \chain_i$557 [75:57];
  assign \write$561.addr  = \$66 ;
  assign \write$561.data  = \$68 [647:576];
  assign \control$563.en  = control3[0];
  assign \control$563.first  = control3[1];
  assign \control$563.last  = control3[2];
  assign \control$563.edge  = control3[3];
  assign \control$563.tile  = control3[7:4];
  assign \chain_i$565[0]  = \chain_i$565 [18:0];
  assign \chain_i$565[1]  = \chain_i$565 [37:19];
  assign \chain_i$565[2]  = \chain_i$565 [56:38];
  assign \chain_i$565[3]  = \chain_i$565 [75:57];
  assign \chain_o$566[0]  = \chain_i$565 [18:0];
  assign \chain_o$566[1]  = \chain_i$565 [37:19];
  assign \chain_o$566[2]  = \chain_i$565 [56:38];
  assign \chain_o$566[3]  = \chain_i$565 [75:57];
  assign \write$569.addr  = \$66 ;
  assign \write$569.data  = \$68 [647:576];
  assign \control$571.en  = control3[0];
  assign \control$571.first  = control3[1];
  assign \control$571.last  = control3[2];
  assign \control$571.edge  = control3[3];
  assign \control$571.tile  = control3[7:4];
  assign \chain_i$573[0]  = \chain_i$573 [18:0];
  assign \chain_i$573[1]  = \chain_i$573 [37:19];
  assign \chain_i$573[2]  = \chain_i$573 [56:38];
  assign \chain_i$573[3]  = \chain_i$573 [75:57];
  assign \chain_o$574[0]  = \chain_i$573 [18:0];
  assign \chain_o$574[1]  = \chain_i$573 [37:19];
  assign \chain_o$574[2]  = \chain_i$573 [56:38];
  assign \chain_o$574[3]  = \chain_i$573 [75:57];
  assign \write$577.addr  = \$66 ;
  assign \write$577.data  = \$68 [647:576];
  assign \control$579.en  = control3[0];
  assign \control$579.first  = control3[1];
  assign \control$579.last  = control3[2];
  assign \control$579.edge  = control3[3];
  assign \control$579.tile  = control3[7:4];
  assign \chain_i$581[0]  = \chain_i$581 [18:0];
  assign \chain_i$581[1]  = \chain_i$581 [37:19];
  assign \chain_i$581[2]  = \chain_i$581 [56:38];
  assign \chain_i$581[3]  = \chain_i$581 [75:57];
  assign \chain_o$582[0]  = \chain_i$581 [18:0];
  assign \chain_o$582[1]  = \chain_i$581 [37:19];
  assign \chain_o$582[2]  = \chain_i$581 [56:38];
  assign \chain_o$582[3]  = \chain_i$581 [75:57];
  assign \write$585.addr  = \$66 ;
  assign \write$585.data  = \$68 [647:576];
  assign \control$587.en  = control3[0];
  assign \control$587.first  = control3[1];
  assign \control$587.last  = control3[2];
  assign \control$587.edge  = control3[3];
  assign \control$587.tile  = control3[7:4];
  assign \chain_i$589[0]  = \chain_i$589 [18:0];
  assign \chain_i$589[1]  = \chain_i$589 [37:19];
  assign \chain_i$589[2]  = \chain_i$589 [56:38];
  assign \chain_i$589[3]  = \chain_i$589 [75:57];
  assign \chain_o$590[0]  = \chain_i$589 [18:0];
  assign \chain_o$590[1]  = \chain_i$589 [37:19];
  assign \chain_o$590[2]  = \chain_i$589 [56:38];
  assign \chain_o$590[3]  = \chain_i$589 [75:57];
  assign \write$593.addr  = \$66 ;
  assign \write$593.data  = \$68 [647:576];
  assign \control$595.en  = control3[0];
  assign \control$595.first  = control3[1];
  assign \control$595.last  = control3[2];
  assign \control$595.edge  = control3[3];
  assign \control$595.tile  = control3[7:4];
  assign \chain_i$597[0]  = \chain_i$597 [18:0];
  assign \chain_i$597[1]  = \chain_i$597 [37:19];
  assign \chain_i$597[2]  = \chain_i$597 [56:38];
  assign \chain_i$597[3]  = \chain_i$597 [75:57];
  assign \chain_o$598[0]  = \chain_i$597 [18:0];
  assign \chain_o$598[1]  = \chain_i$597 [37:19];
  assign \chain_o$598[2]  = \chain_i$597 [56:38];
  assign \chain_o$598[3]  = \chain_i$597 [75:57];
  assign \write$601.addr  = \$66 ;
  assign \write$601.data  = \$68 [647:576];
  assign \control$603.en  = control3[0];
  assign \control$603.first  = control3[1];
  assign \control$603.last  = control3[2];
  assign \control$603.edge  = control3[3];
  assign \control$603.tile  = control3[7:4];
  assign \write$607.addr  = \$66 ;
  assign \write$607.data  = \$68 [647:576];
  assign \control$609.en  = control3[0];
  assign \control$609.first  = control3[1];
  assign \control$609.last  = control3[2];
  assign \control$609.edge  = control3[3];
  assign \control$609.tile  = control3[7:4];
  assign \write$613.addr  = \$66 ;
  assign \write$613.data  = \$68 [647:576];
  assign \control$615.en  = control3[0];
  assign \control$615.first  = control3[1];
  assign \control$615.last  = control3[2];
  assign \control$615.edge  = control3[3];
  assign \control$615.tile  = control3[7:4];
  assign \write$619.addr  = \$66 ;
  assign \write$619.data  = \$68 [647:576];
  assign \control$621.en  = control3[0];
  assign \control$621.first  = control3[1];
  assign \control$621.last  = control3[2];
  assign \control$621.edge  = control3[3];
  assign \control$621.tile  = control3[7:4];
  assign \control0.en  = control0[0];
  assign \control0.first  = control0[1];
  assign \control0.last  = control0[2];
  assign \control0.edge  = control0[3];
  assign \control0.tile  = control0[7:4];
  assign \info0.tile  = info0[3:0];
  assign \info0.tile_last  = info0[4];
  assign \info0.slots  = info0[8:5];
  assign \info0.edge  = info0[9];
  assign \info0.image_last  = info0[10];
  assign \control1.en  = control1[0];
  assign \control1.first  = control1[1];
  assign \control1.last  = control1[2];
  assign \control1.edge  = control1[3];
  assign \control1.tile  = control1[7:4];
  assign \info1.tile  = info1[3:0];
  assign \info1.tile_last  = info1[4];
  assign \info1.slots  = info1[8:5];
  assign \info1.edge  = info1[9];
  assign \info1.image_last  = info1[10];
  assign \control2.en  = control2[0];
  assign \control2.first  = control2[1];
  assign \control2.last  = control2[2];
  assign \control2.edge  = control2[3];
  assign \control2.tile  = control2[7:4];
  assign \info2.tile  = info2[3:0];
  assign \info2.tile_last  = info2[4];
  assign \info2.slots  = info2[8:5];
  assign \info2.edge  = info2[9];
  assign \info2.image_last  = info2[10];
  assign heads[303:228] = \chain_o$148 ;
  assign heads[227:152] = \chain_o$139 ;
  assign heads[151:76] = \chain_o$130 ;
  assign heads[75:0] = chain_o;
endmodule

module \macram_top.array.decoder (rst, soft_reset, height, width, c_in, c_out, mode, weight_base, requant_base, shape, error, weight_end, requant_end, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$2  = 0;
  wire [32:0] \$1 ;
  wire [32:0] \$10 ;
  wire [32:0] \$11 ;
  wire [14:0] \$12 ;
  wire [14:0] \$13 ;
  wire [32:0] \$14 ;
  wire [32:0] \$15 ;
  wire [33:0] \$16 ;
  wire [34:0] \$17 ;
  wire [34:0] \$18 ;
  wire [33:0] \$19 ;
  wire [32:0] \$2 ;
  wire [34:0] \$20 ;
  wire [34:0] \$21 ;
  wire \$22 ;
  wire [27:0] \$23 ;
  wire [28:0] \$24 ;
  wire \$25 ;
  wire \$26 ;
  wire \$27 ;
  wire \$28 ;
  wire \$29 ;
  wire [14:0] \$3 ;
  wire \$30 ;
  wire \$31 ;
  wire \$32 ;
  wire \$33 ;
  wire [29:0] \$34 ;
  wire \$35 ;
  wire \$36 ;
  wire \$37 ;
  wire \$38 ;
  wire [32:0] \$39 ;
  wire [14:0] \$4 ;
  wire \$40 ;
  wire [16:0] \$41 ;
  wire [32:0] \$42 ;
  wire \$43 ;
  wire \$44 ;
  wire [32:0] \$45 ;
  wire [16:0] \$46 ;
  wire [32:0] \$47 ;
  reg [166:0] \$48 ;
  reg [28:0] \$49 ;
  wire [32:0] \$5 ;
  reg \$50 ;
  reg \$51 ;
  reg [2:0] \$52 ;
  reg [10:0] \$53 ;
  reg [8:0] \$54 ;
  wire [32:0] \$6 ;
  wire [31:0] \$7 ;
  wire [31:0] \$8 ;
  wire [31:0] \$9 ;
  wire [13:0] \$signal ;
  reg \$signal$16  = 1'h0;
  wire [31:0] \$signal$7 ;
  wire [25:0] \$signal$9 ;
  reg bad_shape = 1'h0;
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
  (* enum_value_110 = "BAD_RANGE" *)
  output [2:0] error;
  reg [2:0] error = 3'h0;
  wire halved;
  input [31:0] height;
  wire [31:0] height;
  wire [13:0] ingest_words;
  reg known_mode;
  input [31:0] mode;
  wire [31:0] mode;
  input [31:0] requant_base;
  wire [31:0] requant_base;
  output [8:0] requant_end;
  reg [8:0] requant_end = 9'h000;
  input rst;
  wire rst;
  output [166:0] shape;
  reg [166:0] shape = 167'h000000000000000000000000000000000000000000;
  wire [15:0] \shape.beats_in ;
  wire [15:0] \shape.beats_out ;
  wire \shape.biased ;
  wire [13:0] \shape.blocks ;
  wire [14:0] \shape.column_words ;
  wire [14:0] \shape.groups ;
  wire \shape.halved ;
  wire [15:0] \shape.height ;
  wire [13:0] \shape.ingest_words ;
  wire [15:0] \shape.out_height ;
  wire [11:0] \shape.output_words ;
  wire \shape.pointwise ;
  wire [1:0] \shape.tail ;
  wire [11:0] \shape.tiles ;
  wire [15:0] \shape.width ;
  input soft_reset;
  wire soft_reset;
  wire [11:0] tiles;
  input [31:0] weight_base;
  wire [31:0] weight_base;
  output [10:0] weight_end;
  reg [10:0] weight_end = 11'h000;
  reg [28:0] weight_words = 29'h00000000;
  input [31:0] width;
  wire [31:0] width;
  assign \$44  = \$40  | \$43 ;
  assign \$45  = weight_base + weight_words;
  assign \$46  = shape[119:108] * 5'h10;
  assign \$47  = requant_base + \$46 ;
  always @(posedge clk)
    shape <= \$48 ;
  always @(posedge clk)
    weight_words <= \$49 ;
  always @(posedge clk)
    \$signal$16  <= \$50 ;
  always @(posedge clk)
    bad_shape <= \$51 ;
  always @(posedge clk)
    error <= \$52 ;
  always @(posedge clk)
    weight_end <= \$53 ;
  always @(posedge clk)
    requant_end <= \$54 ;
  assign \$1  = c_in + 3'h7;
  assign \$3  = \$2 [13:0] + 1'h1;
  assign \$5  = c_out + 6'h3f;
  assign \$7  = width[31:1] + width[0];
  assign \$signal$7  = mode[9] ? \$7  : width;
  assign \$signal$9  = shape[119:108] * shape[78:65];
  assign \$8  = height[31:1] + height[0];
  assign \$9  = mode[9] ? \$8  : height;
  assign \$10  = \$signal$7  + 2'h3;
  assign \$13  = mode[9] ? \$12  : { 1'h0, \$4 [13:0] };
  assign \$14  = c_out + 4'hf;
  assign \$16  = c_in * 2'h3;
  assign \$17  = \$16  + 6'h3f;
  assign \$19  = c_out * 2'h3;
  assign \$20  = \$19  + 6'h3f;
  assign \$22  = ~ mode[1];
  assign \$23  = 2'h3 * \$signal$9 ;
  assign \$24  = \$23  << shape[165];
  assign \$25  = ~ known_mode;
  assign \$26  = ! height;
  assign \$27  = ! width;
  assign \$28  = ! c_in;
  assign \$29  = ! c_out;
  assign \$30  = height > 16'hffff;
  assign \$31  = width > 16'hffff;
  assign \$32  = c_in > 11'h400;
  assign \$33  = c_out > 11'h400;
  assign \$34  = shape[62:48] * shape[107:93];
  assign \$35  = \$34  > 9'h100;
  assign \$36  = | { \$35 , \$33 , \$32 , \$31 , \$30 , \$29 , \$28 , \$27 , \$26  };
  assign \$37  = weight_words > 11'h400;
  assign \$38  = bad_shape | \$37 ;
  assign \$39  = weight_base + weight_words;
  assign \$40  = \$39  > 11'h400;
  assign \$41  = shape[119:108] * 5'h10;
  assign \$42  = requant_base + \$41 ;
  assign \$43  = \$42  > 9'h100;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$2 ) begin end
    known_mode = 1'h0;
    casez (mode)
      32'd257, 32'd16777473, 32'd513, 32'd16777729, 32'd65795, 32'd16843011, 32'd66051, 32'd16843267:
          known_mode = 1'h1;
    endcase
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$2 ) begin end
    \$48 [15:0] = height[15:0];
    \$48 [31:16] = width[15:0];
    \$48 [47:32] = \$9 [15:0];
    \$48 [62:48] = \$11 [14:0];
    \$48 [64:63] = \$signal$7 [1:0];
    \$48 [78:65] = \$2 [13:0];
    \$48 [92:79] = \$4 [13:0];
    \$48 [107:93] = \$13 ;
    \$48 [119:108] = \$6 [11:0];
    \$48 [131:120] = \$15 [11:0];
    \$48 [147:132] = \$18 [15:0];
    \$48 [163:148] = \$21 [15:0];
    \$48 [164] = \$22 ;
    \$48 [165] = mode[9];
    \$48 [166] = mode[24];
    if (soft_reset) begin
      \$48  = 167'h000000000000000000000000000000000000000000;
    end
    if (rst) begin
      \$48  = 167'h000000000000000000000000000000000000000000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$2 ) begin end
    (* full_case = 32'd1 *)
    if (shape[164]) begin
      \$49  = { 3'h0, \$signal$9  };
    end else begin
      \$49  = \$24 ;
    end
    if (soft_reset) begin
      \$49  = 29'h00000000;
    end
    if (rst) begin
      \$49  = 29'h00000000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$2 ) begin end
    \$50  = \$25 ;
    if (soft_reset) begin
      \$50  = 1'h0;
    end
    if (rst) begin
      \$50  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$2 ) begin end
    \$51  = \$36 ;
    if (soft_reset) begin
      \$51  = 1'h0;
    end
    if (rst) begin
      \$51  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$2 ) begin end
    (* full_case = 32'd1 *)
    if (\$signal$16 ) begin
      \$52  = 3'h2;
    end else if (\$38 ) begin
      \$52  = 3'h1;
    end else if (\$44 ) begin
      \$52  = 3'h6;
    end else begin
      \$52  = 3'h0;
    end
    if (soft_reset) begin
      \$52  = 3'h0;
    end
    if (rst) begin
      \$52  = 3'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$2 ) begin end
    \$53  = \$45 [10:0];
    if (soft_reset) begin
      \$53  = 11'h000;
    end
    if (rst) begin
      \$53  = 11'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$2 ) begin end
    \$54  = \$47 [8:0];
    if (soft_reset) begin
      \$54  = 9'h000;
    end
    if (rst) begin
      \$54  = 9'h000;
    end
  end
  assign \$signal  = \$2 [13:0];
  assign ingest_words = \$4 [13:0];
  assign tiles = \$6 [11:0];
  assign halved = mode[9];
  assign \shape.height  = shape[15:0];
  assign \shape.width  = shape[31:16];
  assign \shape.out_height  = shape[47:32];
  assign \shape.groups  = shape[62:48];
  assign \shape.tail  = shape[64:63];
  assign \shape.blocks  = shape[78:65];
  assign \shape.ingest_words  = shape[92:79];
  assign \shape.column_words  = shape[107:93];
  assign \shape.tiles  = shape[119:108];
  assign \shape.output_words  = shape[131:120];
  assign \shape.beats_in  = shape[147:132];
  assign \shape.beats_out  = shape[163:148];
  assign \shape.pointwise  = shape[164];
  assign \shape.halved  = shape[165];
  assign \shape.biased  = shape[166];
  assign \$2  = { 3'h0, \$1 [32:3] };
  assign \$4  = { 1'h0, \$3 [14:1] };
  assign \$6  = { 6'h00, \$5 [32:6] };
  assign \$11  = { 2'h0, \$10 [32:2] };
  assign \$12  = { \$4 [13:0], 1'h0 };
  assign \$15  = { 4'h0, \$14 [32:4] };
  assign \$18  = { 6'h00, \$17 [34:6] };
  assign \$21  = { 6'h00, \$20 [34:6] };
endmodule

module \macram_top.array.drain (rst, finished, shift, credit, o__ready, soft_reset, requant_base, start, \heads$60 , info, shape, o__payload, valid, reload__addr, reload__data, reload__en, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$3  = 0;
  wire \$1 ;
  wire [3:0] \$10 ;
  reg [3:0] \$11 ;
  wire [12:0] \$12 ;
  wire \$13 ;
  wire \$14 ;
  wire \$15 ;
  wire \$16 ;
  wire \$17 ;
  wire \$18 ;
  wire \$19 ;
  wire \$2 ;
  wire [4:0] \$20 ;
  wire [4:0] \$21 ;
  wire \$22 ;
  wire [2:0] \$23 ;
  wire \$24 ;
  wire \$25 ;
  wire \$26 ;
  wire \$27 ;
  wire \$28 ;
  wire \$29 ;
  wire \$3 ;
  wire \$30 ;
  wire [2:0] \$31 ;
  wire [12:0] \$32 ;
  wire [2:0] \$33 ;
  reg \$34 ;
  reg [10:0] \$35 ;
  reg \$36 ;
  reg [3:0] \$37 ;
  reg [10:0] \$38 ;
  reg [3:0] \$39 ;
  wire \$4 ;
  reg [1:0] \$40 ;
  reg \$41 ;
  reg \$42 ;
  reg \$43 ;
  reg \$44 ;
  reg \$45 ;
  reg \$46 ;
  reg \$47 ;
  reg \$48 ;
  reg \$49 ;
  wire \$5 ;
  reg \$50 ;
  reg [1:0] \$51 ;
  reg [2:0] \$52 ;
  reg [11:0] \$53 ;
  reg [1:0] \$54 ;
  reg [1:0] \$55 ;
  reg [3:0] \$56 ;
  reg [3:0] \$57 ;
  reg [3:0] \$58 ;
  reg [3:0] \$59 ;
  wire \$6 ;
  reg [3:0] \$60 ;
  reg [3:0] \$61 ;
  wire \$7 ;
  wire \$8 ;
  wire [8:0] \$9 ;
  wire \$signal ;
  (* init = 8'h00 *)
  wire [7:0] \$signal$26 ;
  reg \$signal$3  = 1'h0;
  reg \$signal$30  = 1'h0;
  reg [1:0] \$signal$31  = 2'h0;
  reg [1:0] \$signal$33  = 2'h0;
  reg [1:0] \$signal$38  = 2'h0;
  reg \$signal$4  = 1'h0;
  reg [3:0] \$signal$5  = 4'h0;
  reg [7:0] \$signal$62  = 8'h00;
  reg [1:0] \$signal$63  = 2'h0;
  reg \$signal$64  = 1'h0;
  reg \$signal$65  = 1'h0;
  reg [3:0] \$signal$66  = 4'h0;
  reg \$signal$67  = 1'h0;
  reg [7:0] \$signal$68  = 8'h00;
  reg [1:0] \$signal$69  = 2'h0;
  wire \$signal$7 ;
  reg \$signal$70  = 1'h0;
  reg \$signal$71  = 1'h0;
  reg [3:0] \$signal$72  = 4'h0;
  reg \$signal$73  = 1'h0;
  reg [7:0] \$signal$74  = 8'h00;
  reg [1:0] \$signal$75  = 2'h0;
  reg \$signal$76  = 1'h0;
  reg \$signal$77  = 1'h0;
  reg [3:0] \$signal$78  = 4'h0;
  reg \$signal$79  = 1'h0;
  reg \$signal$80  = 1'h0;
  reg [3:0] \$signal$81  = 4'h0;
  reg \$signal$82  = 1'h0;
  wire [7:0] \$signature__addr ;
  wire [671:0] \$signature__data ;
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
  reg [10:0] current = 11'h000;
  wire \current.edge ;
  wire \current.image_last ;
  wire [3:0] \current.slots ;
  wire [3:0] \current.tile ;
  wire \current.tile_last ;
  reg \edge  = 1'h0;
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
  input [303:0] \heads$60 ;
  wire [303:0] \heads$60 ;
  wire [75:0] \heads$60[0] ;
  wire [18:0] \heads$60[0][0] ;
  wire [18:0] \heads$60[0][1] ;
  wire [18:0] \heads$60[0][2] ;
  wire [18:0] \heads$60[0][3] ;
  wire [75:0] \heads$60[1] ;
  wire [18:0] \heads$60[1][0] ;
  wire [18:0] \heads$60[1][1] ;
  wire [18:0] \heads$60[1][2] ;
  wire [18:0] \heads$60[1][3] ;
  wire [75:0] \heads$60[2] ;
  wire [18:0] \heads$60[2][0] ;
  wire [18:0] \heads$60[2][1] ;
  wire [18:0] \heads$60[2][2] ;
  wire [18:0] \heads$60[2][3] ;
  wire [75:0] \heads$60[3] ;
  wire [18:0] \heads$60[3][0] ;
  wire [18:0] \heads$60[3][1] ;
  wire [18:0] \heads$60[3][2] ;
  wire [18:0] \heads$60[3][3] ;
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
  input [10:0] info;
  wire [10:0] info;
  wire \info.edge ;
  wire \info.image_last ;
  wire [3:0] \info.slots ;
  wire [3:0] \info.tile ;
  wire \info.tile_last ;
  wire [10:0] info_now;
  wire \info_now.edge ;
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
  wire [671:0] parameters;
  wire pixel_after;
  reg [7:0] put__addr = 8'h00;
  wire [191:0] put__data;
  wire [3:0] put__en;
  input [7:0] reload__addr;
  wire [7:0] reload__addr;
  input [671:0] reload__data;
  wire [671:0] reload__data;
  input reload__en;
  wire reload__en;
  input [7:0] requant_base;
  wire [7:0] requant_base;
  input rst;
  wire rst;
  reg [1:0] section = 2'h0;
  wire section_done;
  input [166:0] shape;
  wire [166:0] shape;
  wire [15:0] \shape.beats_in ;
  wire [15:0] \shape.beats_out ;
  wire \shape.biased ;
  wire [13:0] \shape.blocks ;
  wire [14:0] \shape.column_words ;
  wire [14:0] \shape.groups ;
  wire \shape.halved ;
  wire [15:0] \shape.height ;
  wire [13:0] \shape.ingest_words ;
  wire [15:0] \shape.out_height ;
  wire [11:0] \shape.output_words ;
  wire \shape.pointwise ;
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
  reg [10:0] waiting = 11'h000;
  wire \waiting.edge ;
  wire \waiting.image_last ;
  wire [3:0] \waiting.slots ;
  wire [3:0] \waiting.tile ;
  wire \waiting.tile_last ;
  reg [11:0] word = 12'h000;
  wire word_last;
  wire [679:0] write;
  wire [7:0] \write.addr ;
  wire [671:0] \write.data ;
  wire write_en;
  assign \$26  = image_last >> \$signal$33 ;
  assign \$27  = ~ pixel_after;
  assign \$28  = \$26  & \$27 ;
  assign \$29  = ~ todo[0];
  assign \$30  = \$29  | word_last;
  assign \$31  = \$signal$38  + 1'h1;
  assign \$32  = word + 1'h1;
  assign \$33  = \$signal$33  + 1'h1;
  always @(posedge clk)
    \$signal$3  <= \$34 ;
  always @(posedge clk)
    waiting <= \$35 ;
  always @(posedge clk)
    \$signal$4  <= \$36 ;
  always @(posedge clk)
    index <= \$37 ;
  always @(posedge clk)
    current <= \$38 ;
  always @(posedge clk)
    \$signal$5  <= \$39 ;
  always @(posedge clk)
    section <= \$40 ;
  always @(posedge clk)
    accumulators <= \heads$60 ;
  always @(posedge clk)
    \edge  <= \$41 ;
  always @(posedge clk)
    \$signal$62  <= { section, info_now[3:0], index[3:2] };
  always @(posedge clk)
    \$signal$63  <= index[1:0];
  always @(posedge clk)
    \$signal$64  <= \$42 ;
  always @(posedge clk)
    \$signal$65  <= \$43 ;
  always @(posedge clk)
    \$signal$66  <= info_now[8:5];
  always @(posedge clk)
    \$signal$67  <= info_now[10];
  always @(posedge clk)
    \$signal$68  <= \$signal$62 ;
  always @(posedge clk)
    \$signal$69  <= \$signal$63 ;
  always @(posedge clk)
    \$signal$70  <= \$44 ;
  always @(posedge clk)
    \$signal$71  <= \$45 ;
  always @(posedge clk)
    \$signal$72  <= \$signal$66 ;
  always @(posedge clk)
    \$signal$73  <= \$signal$67 ;
  always @(posedge clk)
    \$signal$74  <= \$signal$68 ;
  always @(posedge clk)
    \$signal$75  <= \$signal$69 ;
  always @(posedge clk)
    \$signal$76  <= \$46 ;
  always @(posedge clk)
    \$signal$77  <= \$47 ;
  always @(posedge clk)
    \$signal$78  <= \$signal$72 ;
  always @(posedge clk)
    \$signal$79  <= \$signal$73 ;
  always @(posedge clk)
    put__addr <= \$signal$74 ;
  always @(posedge clk)
    \$signal$31  <= \$signal$75 ;
  always @(posedge clk)
    \$signal$30  <= \$48 ;
  always @(posedge clk)
    \$signal$80  <= \$49 ;
  always @(posedge clk)
    \$signal$81  <= \$signal$78 ;
  always @(posedge clk)
    \$signal$82  <= \$signal$79 ;
  always @(posedge clk)
    valid <= \$50 ;
  always @(posedge clk)
    slot_read <= \$51 ;
  always @(posedge clk)
    meta <= \$52 ;
  always @(posedge clk)
    word <= \$53 ;
  always @(posedge clk)
    \$signal$38  <= \$54 ;
  always @(posedge clk)
    \$signal$33  <= \$55 ;
  always @(posedge clk)
    filled <= \$56 ;
  always @(posedge clk)
    image_last <= \$57 ;
  always @(posedge clk)
    slots0 <= \$58 ;
  always @(posedge clk)
    slots1 <= \$59 ;
  always @(posedge clk)
    slots2 <= \$60 ;
  always @(posedge clk)
    slots3 <= \$61 ;
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
  assign \$9  = { info_now[3:0], index } + requant_base;
  assign \$10  = 1'h1 << \$signal$31 ;
  assign put__en = \$signal$30  ? \$10  : 4'h0;
  assign todo = \$11  >> \$signal$38 ;
  assign \$12  = word + 1'h1;
  assign word_last = \$12  == shape[131:120];
  assign pixel_after = | todo[3:1];
  assign \$13  = ~ valid;
  assign advance = \$13  | o__ready;
  assign \$14  = filled >> \$signal$33 ;
  assign fetch = \$14  & advance;
  assign \$15  = ~ todo[0];
  assign \$16  = word_last | \$15 ;
  assign \$17  = fetch & \$16 ;
  assign \$18  = ~ pixel_after;
  assign section_done = \$17  & \$18 ;
  assign \$19  = ~ last_cycle;
  assign \$20  = index + 1'h1;
  assign \$21  = last_cycle ? 5'h00 : \$20 ;
  assign \$22  = last_cycle & info_now[4];
  assign \$23  = section + 1'h1;
  assign \$24  = last_cycle & info_now[4];
  assign \$25  = fetch & todo[0];
  macram_ram #(
    .ADDR_BITS(32'd8),
    .DEPTH(32'd256),
    .INIT_FILE(),
    .LANES(32'd4),
    .WIDTH(32'd192)
  ) buffer (
    .clk(clk),
    .read_addr({ \$signal$33 , word[5:0] }),
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
    .WIDTH(32'd672)
  ) \parameters$86  (
    .clk(clk),
    .read_addr(\$9 [7:0]),
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
    .\edge (\edge ),
    .\parameters$3 (parameters),
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
    \$34  = \$signal$3 ;
    if (finished) begin
      \$34  = 1'h1;
    end else if (\$signal ) begin
      \$34  = 1'h0;
    end
    if (start) begin
      \$34  = 1'h0;
    end
    if (soft_reset) begin
      \$34  = 1'h0;
    end
    if (rst) begin
      \$34  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$35  = waiting;
    if (finished) begin
      \$35  = info;
    end
    if (soft_reset) begin
      \$35  = 11'h000;
    end
    if (rst) begin
      \$35  = 11'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$36  = \$signal$4 ;
    if (\$signal$7 ) begin
      \$36  = \$19 ;
    end
    if (start) begin
      \$36  = 1'h0;
    end
    if (soft_reset) begin
      \$36  = 1'h0;
    end
    if (rst) begin
      \$36  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$37  = index;
    if (\$signal$7 ) begin
      \$37  = \$21 [3:0];
    end
    if (start) begin
      \$37  = 4'h0;
    end
    if (soft_reset) begin
      \$37  = 4'h0;
    end
    if (rst) begin
      \$37  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$38  = current;
    if (\$signal ) begin
      \$38  = waiting;
    end
    if (soft_reset) begin
      \$38  = 11'h000;
    end
    if (rst) begin
      \$38  = 11'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$39  = \$signal$5 ;
    if (\$signal ) begin
      if (group_start) begin
        (* full_case = 32'd1 *)
        casez (section)
          2'h0:
              \$39 [0] = 1'h1;
          2'h1:
              \$39 [1] = 1'h1;
          2'h2:
              \$39 [2] = 1'h1;
          2'h3:
              \$39 [3] = 1'h1;
        endcase
      end
    end
    if (section_done) begin
      (* full_case = 32'd1 *)
      casez (\$signal$33 )
        2'h0:
            \$39 [0] = 1'h0;
        2'h1:
            \$39 [1] = 1'h0;
        2'h2:
            \$39 [2] = 1'h0;
        2'h3:
            \$39 [3] = 1'h0;
      endcase
    end
    if (start) begin
      \$39  = 4'h0;
    end
    if (soft_reset) begin
      \$39  = 4'h0;
    end
    if (rst) begin
      \$39  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$40  = section;
    if (\$22 ) begin
      \$40  = \$23 [1:0];
    end
    if (start) begin
      \$40  = 2'h0;
    end
    if (soft_reset) begin
      \$40  = 2'h0;
    end
    if (rst) begin
      \$40  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$41  = info_now[9];
    if (soft_reset) begin
      \$41  = 1'h0;
    end
    if (rst) begin
      \$41  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$42  = \$signal$7 ;
    if (soft_reset) begin
      \$42  = 1'h0;
    end
    if (rst) begin
      \$42  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$43  = \$24 ;
    if (soft_reset) begin
      \$43  = 1'h0;
    end
    if (rst) begin
      \$43  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$44  = \$signal$64 ;
    if (soft_reset) begin
      \$44  = 1'h0;
    end
    if (rst) begin
      \$44  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$45  = \$signal$65 ;
    if (soft_reset) begin
      \$45  = 1'h0;
    end
    if (rst) begin
      \$45  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$46  = \$signal$70 ;
    if (soft_reset) begin
      \$46  = 1'h0;
    end
    if (rst) begin
      \$46  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$47  = \$signal$71 ;
    if (soft_reset) begin
      \$47  = 1'h0;
    end
    if (rst) begin
      \$47  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$48  = \$signal$76 ;
    if (soft_reset) begin
      \$48  = 1'h0;
    end
    if (rst) begin
      \$48  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$49  = \$signal$77 ;
    if (soft_reset) begin
      \$49  = 1'h0;
    end
    if (rst) begin
      \$49  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$50  = valid;
    if (advance) begin
      \$50  = \$25 ;
    end
    if (start) begin
      \$50  = 1'h0;
    end
    if (soft_reset) begin
      \$50  = 1'h0;
    end
    if (rst) begin
      \$50  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$51  = slot_read;
    if (advance) begin
      \$51  = \$signal$38 ;
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
    \$52  = meta;
    if (advance) begin
      \$52 [1] = word_last;
      \$52 [2] = \$28 ;
    end
    if (soft_reset) begin
      \$52 [2:1] = 2'h0;
    end
    if (rst) begin
      \$52  = 3'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$53  = word;
    if (fetch) begin
      (* full_case = 32'd1 *)
      if (\$30 ) begin
        \$53  = 12'h000;
      end else begin
        \$53  = \$32 [11:0];
      end
    end
    if (section_done) begin
      \$53  = 12'h000;
    end
    if (start) begin
      \$53  = 12'h000;
    end
    if (soft_reset) begin
      \$53  = 12'h000;
    end
    if (rst) begin
      \$53  = 12'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$54  = \$signal$38 ;
    if (fetch) begin
      if (\$30 ) begin
        \$54  = \$31 [1:0];
      end
    end
    if (section_done) begin
      \$54  = 2'h0;
    end
    if (start) begin
      \$54  = 2'h0;
    end
    if (soft_reset) begin
      \$54  = 2'h0;
    end
    if (rst) begin
      \$54  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$55  = \$signal$33 ;
    if (section_done) begin
      \$55  = \$33 [1:0];
    end
    if (start) begin
      \$55  = 2'h0;
    end
    if (soft_reset) begin
      \$55  = 2'h0;
    end
    if (rst) begin
      \$55  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$56  = filled;
    if (section_done) begin
      (* full_case = 32'd1 *)
      casez (\$signal$33 )
        2'h0:
            \$56 [0] = 1'h0;
        2'h1:
            \$56 [1] = 1'h0;
        2'h2:
            \$56 [2] = 1'h0;
        2'h3:
            \$56 [3] = 1'h0;
      endcase
    end
    if (\$signal$80 ) begin
      (* full_case = 32'd1 *)
      casez (put__addr[7:6])
        2'h0:
            \$56 [0] = 1'h1;
        2'h1:
            \$56 [1] = 1'h1;
        2'h2:
            \$56 [2] = 1'h1;
        2'h3:
            \$56 [3] = 1'h1;
      endcase
    end
    if (start) begin
      \$56  = 4'h0;
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
    \$57  = image_last;
    if (\$signal$80 ) begin
      (* full_case = 32'd1 *)
      casez (put__addr[7:6])
        2'h0:
            \$57 [0] = \$signal$82 ;
        2'h1:
            \$57 [1] = \$signal$82 ;
        2'h2:
            \$57 [2] = \$signal$82 ;
        2'h3:
            \$57 [3] = \$signal$82 ;
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
    \$58  = slots0;
    if (\$signal$80 ) begin
      casez (put__addr[7:6])
        2'h0:
            \$58  = \$signal$81 ;
      endcase
    end
    if (soft_reset) begin
      \$58  = 4'h0;
    end
    if (rst) begin
      \$58  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$59  = slots1;
    if (\$signal$80 ) begin
      casez (put__addr[7:6])
        2'h0:
            /* empty */;
        2'h1:
            \$59  = \$signal$81 ;
      endcase
    end
    if (soft_reset) begin
      \$59  = 4'h0;
    end
    if (rst) begin
      \$59  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$60  = slots2;
    if (\$signal$80 ) begin
      casez (put__addr[7:6])
        2'h0:
            /* empty */;
        2'h1:
            /* empty */;
        2'h2:
            \$60  = \$signal$81 ;
      endcase
    end
    if (soft_reset) begin
      \$60  = 4'h0;
    end
    if (rst) begin
      \$60  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$61  = slots3;
    if (\$signal$80 ) begin
      (* full_case = 32'd1 *)
      casez (put__addr[7:6])
        2'h0:
            /* empty */;
        2'h1:
            /* empty */;
        2'h2:
            /* empty */;
        2'h3:
            \$61  = \$signal$81 ;
      endcase
    end
    if (soft_reset) begin
      \$61  = 4'h0;
    end
    if (rst) begin
      \$61  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    (* full_case = 32'd1 *)
    casez (\$signal$33 )
      2'h0:
          \$11  = slots0;
      2'h1:
          \$11  = slots1;
      2'h2:
          \$11  = slots2;
      2'h3:
          \$11  = slots3;
    endcase
  end
  assign write = { reload__data, reload__addr };
  assign write_en = reload__en;
  assign \$signature__addr  = \$9 [7:0];
  assign \$signature__data  = parameters;
  assign heads = accumulators;
  assign \$signal$26  = put__addr;
  assign put__data = { codes, codes, codes, codes };
  assign get__addr = { \$signal$33 , word[5:0] };
  assign get__en = advance;
  assign o__valid = valid;
  assign shift = \$signal$7 ;
  assign \waiting.tile  = waiting[3:0];
  assign \waiting.tile_last  = waiting[4];
  assign \waiting.slots  = waiting[8:5];
  assign \waiting.edge  = waiting[9];
  assign \waiting.image_last  = waiting[10];
  assign \info_now.tile  = info_now[3:0];
  assign \info_now.tile_last  = info_now[4];
  assign \info_now.slots  = info_now[8:5];
  assign \info_now.edge  = info_now[9];
  assign \info_now.image_last  = info_now[10];
  assign \current.tile  = current[3:0];
  assign \current.tile_last  = current[4];
  assign \current.slots  = current[8:5];
  assign \current.edge  = current[9];
  assign \current.image_last  = current[10];
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
  assign \shape.out_height  = shape[47:32];
  assign \shape.groups  = shape[62:48];
  assign \shape.tail  = shape[64:63];
  assign \shape.blocks  = shape[78:65];
  assign \shape.ingest_words  = shape[92:79];
  assign \shape.column_words  = shape[107:93];
  assign \shape.tiles  = shape[119:108];
  assign \shape.output_words  = shape[131:120];
  assign \shape.beats_in  = shape[147:132];
  assign \shape.beats_out  = shape[163:148];
  assign \shape.pointwise  = shape[164];
  assign \shape.halved  = shape[165];
  assign \shape.biased  = shape[166];
  assign \o__payload.data  = o__payload[47:0];
  assign \o__payload.pixel_last  = o__payload[48];
  assign \o__payload.last  = o__payload[49];
  assign \meta.data  = meta[0];
  assign \meta.pixel_last  = meta[1];
  assign \meta.last  = meta[2];
  assign \info.tile  = info[3:0];
  assign \info.tile_last  = info[4];
  assign \info.slots  = info[8:5];
  assign \info.edge  = info[9];
  assign \info.image_last  = info[10];
  assign \heads$60[0]  = \heads$60 [75:0];
  assign \heads$60[0][0]  = \heads$60 [18:0];
  assign \heads$60[0][1]  = \heads$60 [37:19];
  assign \heads$60[0][2]  = \heads$60 [56:38];
  assign \heads$60[0][3]  = \heads$60 [75:57];
  assign \heads$60[1]  = \heads$60 [151:76];
  assign \heads$60[1][0]  = \heads$60 [94:76];
  assign \heads$60[1][1]  = \heads$60 [113:95];
  assign \heads$60[1][2]  = \heads$60 [132:114];
  assign \heads$60[1][3]  = \heads$60 [151:133];
  assign \heads$60[2]  = \heads$60 [227:152];
  assign \heads$60[2][0]  = \heads$60 [170:152];
  assign \heads$60[2][1]  = \heads$60 [189:171];
  assign \heads$60[2][2]  = \heads$60 [208:190];
  assign \heads$60[2][3]  = \heads$60 [227:209];
  assign \heads$60[3]  = \heads$60 [303:228];
  assign \heads$60[3][0]  = \heads$60 [246:228];
  assign \heads$60[3][1]  = \heads$60 [265:247];
  assign \heads$60[3][2]  = \heads$60 [284:266];
  assign \heads$60[3][3]  = \heads$60 [303:285];
endmodule

module \macram_top.array.drain.requant (rst, \parameters$3 , soft_reset, accumulators, \edge , codes, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$4  = 0;
  wire [16:0] \$1 ;
  wire [2:0] \$10 ;
  wire [2:0] \$100 ;
  wire \$101 ;
  wire [19:0] \$102 ;
  wire \$103 ;
  wire \$104 ;
  wire \$105 ;
  wire \$106 ;
  wire \$107 ;
  wire \$108 ;
  wire \$109 ;
  wire [16:0] \$11 ;
  wire [2:0] \$110 ;
  wire \$111 ;
  wire [19:0] \$112 ;
  wire \$113 ;
  wire \$114 ;
  wire \$115 ;
  wire \$116 ;
  wire \$117 ;
  wire \$118 ;
  wire \$119 ;
  wire [19:0] \$12 ;
  wire [2:0] \$120 ;
  wire [16:0] \$121 ;
  wire [19:0] \$122 ;
  wire \$123 ;
  wire \$124 ;
  wire \$125 ;
  wire \$126 ;
  wire \$127 ;
  wire \$128 ;
  wire \$129 ;
  wire \$13 ;
  wire [2:0] \$130 ;
  wire [16:0] \$131 ;
  wire [19:0] \$132 ;
  wire \$133 ;
  wire \$134 ;
  wire \$135 ;
  wire \$136 ;
  wire \$137 ;
  wire \$138 ;
  wire \$139 ;
  wire \$14 ;
  wire [2:0] \$140 ;
  wire \$141 ;
  wire [19:0] \$142 ;
  wire \$143 ;
  wire \$144 ;
  wire \$145 ;
  wire \$146 ;
  wire \$147 ;
  wire \$148 ;
  wire \$149 ;
  wire \$15 ;
  wire [2:0] \$150 ;
  wire \$151 ;
  wire [19:0] \$152 ;
  wire \$153 ;
  wire \$154 ;
  wire \$155 ;
  wire \$156 ;
  wire \$157 ;
  wire \$158 ;
  wire \$159 ;
  wire \$16 ;
  wire [2:0] \$160 ;
  wire [1:0] \$161 ;
  wire [1:0] \$162 ;
  wire [2:0] \$163 ;
  wire [1:0] \$164 ;
  wire [2:0] \$165 ;
  wire [3:0] \$166 ;
  wire [1:0] \$167 ;
  wire [1:0] \$168 ;
  wire [2:0] \$169 ;
  wire \$17 ;
  wire [1:0] \$170 ;
  wire [2:0] \$171 ;
  wire [3:0] \$172 ;
  wire [1:0] \$173 ;
  wire [1:0] \$174 ;
  wire [2:0] \$175 ;
  wire [1:0] \$176 ;
  wire [2:0] \$177 ;
  wire [3:0] \$178 ;
  wire [1:0] \$179 ;
  wire \$18 ;
  wire [1:0] \$180 ;
  wire [2:0] \$181 ;
  wire [1:0] \$182 ;
  wire [2:0] \$183 ;
  wire [3:0] \$184 ;
  wire [1:0] \$185 ;
  wire [1:0] \$186 ;
  wire [2:0] \$187 ;
  wire [1:0] \$188 ;
  wire [2:0] \$189 ;
  wire \$19 ;
  wire [3:0] \$190 ;
  wire [1:0] \$191 ;
  wire [1:0] \$192 ;
  wire [2:0] \$193 ;
  wire [1:0] \$194 ;
  wire [2:0] \$195 ;
  wire [3:0] \$196 ;
  wire [1:0] \$197 ;
  wire [1:0] \$198 ;
  wire [2:0] \$199 ;
  wire [19:0] \$2 ;
  wire [2:0] \$20 ;
  wire [1:0] \$200 ;
  wire [2:0] \$201 ;
  wire [3:0] \$202 ;
  wire [1:0] \$203 ;
  wire [1:0] \$204 ;
  wire [2:0] \$205 ;
  wire [1:0] \$206 ;
  wire [2:0] \$207 ;
  wire [3:0] \$208 ;
  wire [1:0] \$209 ;
  wire \$21 ;
  wire [1:0] \$210 ;
  wire [2:0] \$211 ;
  wire [1:0] \$212 ;
  wire [2:0] \$213 ;
  wire [3:0] \$214 ;
  wire [1:0] \$215 ;
  wire [1:0] \$216 ;
  wire [2:0] \$217 ;
  wire [1:0] \$218 ;
  wire [2:0] \$219 ;
  wire [19:0] \$22 ;
  wire [3:0] \$220 ;
  wire [1:0] \$221 ;
  wire [1:0] \$222 ;
  wire [2:0] \$223 ;
  wire [1:0] \$224 ;
  wire [2:0] \$225 ;
  wire [3:0] \$226 ;
  wire [1:0] \$227 ;
  wire [1:0] \$228 ;
  wire [2:0] \$229 ;
  wire \$23 ;
  wire [1:0] \$230 ;
  wire [2:0] \$231 ;
  wire [3:0] \$232 ;
  wire [1:0] \$233 ;
  wire [1:0] \$234 ;
  wire [2:0] \$235 ;
  wire [1:0] \$236 ;
  wire [2:0] \$237 ;
  wire [3:0] \$238 ;
  wire [1:0] \$239 ;
  wire \$24 ;
  wire [1:0] \$240 ;
  wire [2:0] \$241 ;
  wire [1:0] \$242 ;
  wire [2:0] \$243 ;
  wire [3:0] \$244 ;
  wire [1:0] \$245 ;
  wire [1:0] \$246 ;
  wire [2:0] \$247 ;
  wire [1:0] \$248 ;
  wire [2:0] \$249 ;
  wire \$25 ;
  wire [3:0] \$250 ;
  wire [1:0] \$251 ;
  wire [1:0] \$252 ;
  wire [2:0] \$253 ;
  wire [1:0] \$254 ;
  wire [2:0] \$255 ;
  wire [3:0] \$256 ;
  wire [6:0] \$257 ;
  reg [47:0] \$258 ;
  wire [6:0] \$259 ;
  wire \$26 ;
  wire [6:0] \$260 ;
  wire [6:0] \$261 ;
  wire [6:0] \$262 ;
  wire [6:0] \$263 ;
  wire [6:0] \$264 ;
  wire [6:0] \$265 ;
  wire [6:0] \$266 ;
  wire [6:0] \$267 ;
  wire [6:0] \$268 ;
  wire [6:0] \$269 ;
  wire \$27 ;
  wire [6:0] \$270 ;
  wire [6:0] \$271 ;
  wire [6:0] \$272 ;
  wire [6:0] \$273 ;
  wire \$28 ;
  wire \$29 ;
  wire \$3 ;
  wire [2:0] \$30 ;
  wire \$31 ;
  wire [19:0] \$32 ;
  wire \$33 ;
  wire \$34 ;
  wire \$35 ;
  wire \$36 ;
  wire \$37 ;
  wire \$38 ;
  wire \$39 ;
  wire \$4 ;
  wire [2:0] \$40 ;
  wire [16:0] \$41 ;
  wire [19:0] \$42 ;
  wire \$43 ;
  wire \$44 ;
  wire \$45 ;
  wire \$46 ;
  wire \$47 ;
  wire \$48 ;
  wire \$49 ;
  wire \$5 ;
  wire [2:0] \$50 ;
  wire [16:0] \$51 ;
  wire [19:0] \$52 ;
  wire \$53 ;
  wire \$54 ;
  wire \$55 ;
  wire \$56 ;
  wire \$57 ;
  wire \$58 ;
  wire \$59 ;
  wire \$6 ;
  wire [2:0] \$60 ;
  wire \$61 ;
  wire [19:0] \$62 ;
  wire \$63 ;
  wire \$64 ;
  wire \$65 ;
  wire \$66 ;
  wire \$67 ;
  wire \$68 ;
  wire \$69 ;
  wire \$7 ;
  wire [2:0] \$70 ;
  wire \$71 ;
  wire [19:0] \$72 ;
  wire \$73 ;
  wire \$74 ;
  wire \$75 ;
  wire \$76 ;
  wire \$77 ;
  wire \$78 ;
  wire \$79 ;
  wire \$8 ;
  wire [2:0] \$80 ;
  wire [16:0] \$81 ;
  wire [19:0] \$82 ;
  wire \$83 ;
  wire \$84 ;
  wire \$85 ;
  wire \$86 ;
  wire \$87 ;
  wire \$88 ;
  wire \$89 ;
  wire \$9 ;
  wire [2:0] \$90 ;
  wire [16:0] \$91 ;
  wire [19:0] \$92 ;
  wire \$93 ;
  wire \$94 ;
  wire \$95 ;
  wire \$96 ;
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
  input \edge ;
  wire \edge ;
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
  reg [671:0] parameters = 672'h000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000;
  input [671:0] \parameters$3 ;
  wire [671:0] \parameters$3 ;
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
  reg [18:0] whole_0_0 = 19'h00000;
  reg [18:0] whole_0_1 = 19'h00000;
  reg [18:0] whole_0_2 = 19'h00000;
  reg [18:0] whole_0_3 = 19'h00000;
  reg [18:0] whole_1_0 = 19'h00000;
  reg [18:0] whole_1_1 = 19'h00000;
  reg [18:0] whole_1_2 = 19'h00000;
  reg [18:0] whole_1_3 = 19'h00000;
  reg [18:0] whole_2_0 = 19'h00000;
  reg [18:0] whole_2_1 = 19'h00000;
  reg [18:0] whole_2_2 = 19'h00000;
  reg [18:0] whole_2_3 = 19'h00000;
  reg [18:0] whole_3_0 = 19'h00000;
  reg [18:0] whole_3_1 = 19'h00000;
  reg [18:0] whole_3_2 = 19'h00000;
  reg [18:0] whole_3_3 = 19'h00000;
  assign \$1  = \edge  ? \parameters$3 [167:151] : 17'h00000;
  assign \$2  = $signed(accumulators[18:0]) + $signed(\$1 );
  assign \$3  = $signed(whole_0_0) >= $signed(parameters[18:0]);
  assign \$4  = $signed(whole_0_0) >= $signed(parameters[37:19]);
  assign \$5  = $signed(whole_0_0) >= $signed(parameters[56:38]);
  assign \$6  = $signed(whole_0_0) >= $signed(parameters[75:57]);
  assign \$7  = $signed(whole_0_0) >= $signed(parameters[94:76]);
  assign \$8  = $signed(whole_0_0) >= $signed(parameters[113:95]);
  assign \$9  = $signed(whole_0_0) >= $signed(parameters[132:114]);
  assign \$10  = \$166 [2:0] ^ { invert_0_0, invert_0_0, invert_0_0 };
  assign \$11  = \edge  ? \parameters$3 [150:134] : 17'h00000;
  assign \$12  = $signed(accumulators[37:19]) + $signed(\$11 );
  assign \$13  = $signed(whole_0_1) >= $signed(parameters[18:0]);
  assign \$14  = $signed(whole_0_1) >= $signed(parameters[37:19]);
  assign \$15  = $signed(whole_0_1) >= $signed(parameters[56:38]);
  assign \$16  = $signed(whole_0_1) >= $signed(parameters[75:57]);
  assign \$17  = $signed(whole_0_1) >= $signed(parameters[94:76]);
  assign \$18  = $signed(whole_0_1) >= $signed(parameters[113:95]);
  assign \$19  = $signed(whole_0_1) >= $signed(parameters[132:114]);
  assign \$20  = \$172 [2:0] ^ { invert_0_1, invert_0_1, invert_0_1 };
  assign \$22  = $signed(accumulators[56:38]) + $signed(2'h0);
  assign \$23  = $signed(whole_0_2) >= $signed(parameters[18:0]);
  assign \$24  = $signed(whole_0_2) >= $signed(parameters[37:19]);
  assign \$25  = $signed(whole_0_2) >= $signed(parameters[56:38]);
  assign \$26  = $signed(whole_0_2) >= $signed(parameters[75:57]);
  assign \$27  = $signed(whole_0_2) >= $signed(parameters[94:76]);
  assign \$28  = $signed(whole_0_2) >= $signed(parameters[113:95]);
  assign \$29  = $signed(whole_0_2) >= $signed(parameters[132:114]);
  assign \$30  = \$178 [2:0] ^ { invert_0_2, invert_0_2, invert_0_2 };
  assign \$32  = $signed(accumulators[75:57]) + $signed(2'h0);
  assign \$33  = $signed(whole_0_3) >= $signed(parameters[18:0]);
  assign \$34  = $signed(whole_0_3) >= $signed(parameters[37:19]);
  assign \$35  = $signed(whole_0_3) >= $signed(parameters[56:38]);
  assign \$36  = $signed(whole_0_3) >= $signed(parameters[75:57]);
  assign \$37  = $signed(whole_0_3) >= $signed(parameters[94:76]);
  assign \$38  = $signed(whole_0_3) >= $signed(parameters[113:95]);
  assign \$39  = $signed(whole_0_3) >= $signed(parameters[132:114]);
  assign \$40  = \$184 [2:0] ^ { invert_0_3, invert_0_3, invert_0_3 };
  assign \$41  = \edge  ? \parameters$3 [335:319] : 17'h00000;
  assign \$42  = $signed(accumulators[94:76]) + $signed(\$41 );
  assign \$43  = $signed(whole_1_0) >= $signed(parameters[186:168]);
  assign \$44  = $signed(whole_1_0) >= $signed(parameters[205:187]);
  assign \$45  = $signed(whole_1_0) >= $signed(parameters[224:206]);
  assign \$46  = $signed(whole_1_0) >= $signed(parameters[243:225]);
  assign \$47  = $signed(whole_1_0) >= $signed(parameters[262:244]);
  assign \$48  = $signed(whole_1_0) >= $signed(parameters[281:263]);
  assign \$49  = $signed(whole_1_0) >= $signed(parameters[300:282]);
  assign \$50  = \$190 [2:0] ^ { invert_1_0, invert_1_0, invert_1_0 };
  assign \$51  = \edge  ? \parameters$3 [318:302] : 17'h00000;
  assign \$52  = $signed(accumulators[113:95]) + $signed(\$51 );
  assign \$53  = $signed(whole_1_1) >= $signed(parameters[186:168]);
  assign \$54  = $signed(whole_1_1) >= $signed(parameters[205:187]);
  assign \$55  = $signed(whole_1_1) >= $signed(parameters[224:206]);
  assign \$56  = $signed(whole_1_1) >= $signed(parameters[243:225]);
  assign \$57  = $signed(whole_1_1) >= $signed(parameters[262:244]);
  assign \$58  = $signed(whole_1_1) >= $signed(parameters[281:263]);
  assign \$59  = $signed(whole_1_1) >= $signed(parameters[300:282]);
  assign \$60  = \$196 [2:0] ^ { invert_1_1, invert_1_1, invert_1_1 };
  assign \$62  = $signed(accumulators[132:114]) + $signed(2'h0);
  assign \$63  = $signed(whole_1_2) >= $signed(parameters[186:168]);
  assign \$64  = $signed(whole_1_2) >= $signed(parameters[205:187]);
  assign \$65  = $signed(whole_1_2) >= $signed(parameters[224:206]);
  assign \$66  = $signed(whole_1_2) >= $signed(parameters[243:225]);
  assign \$67  = $signed(whole_1_2) >= $signed(parameters[262:244]);
  assign \$68  = $signed(whole_1_2) >= $signed(parameters[281:263]);
  assign \$69  = $signed(whole_1_2) >= $signed(parameters[300:282]);
  assign \$70  = \$202 [2:0] ^ { invert_1_2, invert_1_2, invert_1_2 };
  assign \$72  = $signed(accumulators[151:133]) + $signed(2'h0);
  assign \$73  = $signed(whole_1_3) >= $signed(parameters[186:168]);
  assign \$74  = $signed(whole_1_3) >= $signed(parameters[205:187]);
  assign \$75  = $signed(whole_1_3) >= $signed(parameters[224:206]);
  assign \$76  = $signed(whole_1_3) >= $signed(parameters[243:225]);
  assign \$77  = $signed(whole_1_3) >= $signed(parameters[262:244]);
  assign \$78  = $signed(whole_1_3) >= $signed(parameters[281:263]);
  assign \$79  = $signed(whole_1_3) >= $signed(parameters[300:282]);
  assign \$80  = \$208 [2:0] ^ { invert_1_3, invert_1_3, invert_1_3 };
  assign \$81  = \edge  ? \parameters$3 [503:487] : 17'h00000;
  assign \$82  = $signed(accumulators[170:152]) + $signed(\$81 );
  assign \$83  = $signed(whole_2_0) >= $signed(parameters[354:336]);
  assign \$84  = $signed(whole_2_0) >= $signed(parameters[373:355]);
  assign \$85  = $signed(whole_2_0) >= $signed(parameters[392:374]);
  assign \$86  = $signed(whole_2_0) >= $signed(parameters[411:393]);
  assign \$87  = $signed(whole_2_0) >= $signed(parameters[430:412]);
  assign \$88  = $signed(whole_2_0) >= $signed(parameters[449:431]);
  assign \$89  = $signed(whole_2_0) >= $signed(parameters[468:450]);
  assign \$90  = \$214 [2:0] ^ { invert_2_0, invert_2_0, invert_2_0 };
  assign \$91  = \edge  ? \parameters$3 [486:470] : 17'h00000;
  assign \$92  = $signed(accumulators[189:171]) + $signed(\$91 );
  assign \$93  = $signed(whole_2_1) >= $signed(parameters[354:336]);
  assign \$94  = $signed(whole_2_1) >= $signed(parameters[373:355]);
  assign \$95  = $signed(whole_2_1) >= $signed(parameters[392:374]);
  assign \$96  = $signed(whole_2_1) >= $signed(parameters[411:393]);
  assign \$97  = $signed(whole_2_1) >= $signed(parameters[430:412]);
  assign \$98  = $signed(whole_2_1) >= $signed(parameters[449:431]);
  assign \$99  = $signed(whole_2_1) >= $signed(parameters[468:450]);
  assign \$100  = \$220 [2:0] ^ { invert_2_1, invert_2_1, invert_2_1 };
  assign \$102  = $signed(accumulators[208:190]) + $signed(2'h0);
  assign \$103  = $signed(whole_2_2) >= $signed(parameters[354:336]);
  assign \$104  = $signed(whole_2_2) >= $signed(parameters[373:355]);
  assign \$105  = $signed(whole_2_2) >= $signed(parameters[392:374]);
  assign \$106  = $signed(whole_2_2) >= $signed(parameters[411:393]);
  assign \$107  = $signed(whole_2_2) >= $signed(parameters[430:412]);
  assign \$108  = $signed(whole_2_2) >= $signed(parameters[449:431]);
  assign \$109  = $signed(whole_2_2) >= $signed(parameters[468:450]);
  assign \$110  = \$226 [2:0] ^ { invert_2_2, invert_2_2, invert_2_2 };
  assign \$112  = $signed(accumulators[227:209]) + $signed(2'h0);
  assign \$113  = $signed(whole_2_3) >= $signed(parameters[354:336]);
  assign \$114  = $signed(whole_2_3) >= $signed(parameters[373:355]);
  assign \$115  = $signed(whole_2_3) >= $signed(parameters[392:374]);
  assign \$116  = $signed(whole_2_3) >= $signed(parameters[411:393]);
  assign \$117  = $signed(whole_2_3) >= $signed(parameters[430:412]);
  assign \$118  = $signed(whole_2_3) >= $signed(parameters[449:431]);
  assign \$119  = $signed(whole_2_3) >= $signed(parameters[468:450]);
  assign \$120  = \$232 [2:0] ^ { invert_2_3, invert_2_3, invert_2_3 };
  assign \$121  = \edge  ? \parameters$3 [671:655] : 17'h00000;
  assign \$122  = $signed(accumulators[246:228]) + $signed(\$121 );
  assign \$123  = $signed(whole_3_0) >= $signed(parameters[522:504]);
  assign \$124  = $signed(whole_3_0) >= $signed(parameters[541:523]);
  assign \$125  = $signed(whole_3_0) >= $signed(parameters[560:542]);
  assign \$126  = $signed(whole_3_0) >= $signed(parameters[579:561]);
  assign \$127  = $signed(whole_3_0) >= $signed(parameters[598:580]);
  assign \$128  = $signed(whole_3_0) >= $signed(parameters[617:599]);
  assign \$129  = $signed(whole_3_0) >= $signed(parameters[636:618]);
  assign \$130  = \$238 [2:0] ^ { invert_3_0, invert_3_0, invert_3_0 };
  assign \$131  = \edge  ? \parameters$3 [654:638] : 17'h00000;
  assign \$132  = $signed(accumulators[265:247]) + $signed(\$131 );
  assign \$133  = $signed(whole_3_1) >= $signed(parameters[522:504]);
  assign \$134  = $signed(whole_3_1) >= $signed(parameters[541:523]);
  assign \$135  = $signed(whole_3_1) >= $signed(parameters[560:542]);
  assign \$136  = $signed(whole_3_1) >= $signed(parameters[579:561]);
  assign \$137  = $signed(whole_3_1) >= $signed(parameters[598:580]);
  assign \$138  = $signed(whole_3_1) >= $signed(parameters[617:599]);
  assign \$139  = $signed(whole_3_1) >= $signed(parameters[636:618]);
  assign \$140  = \$244 [2:0] ^ { invert_3_1, invert_3_1, invert_3_1 };
  assign \$142  = $signed(accumulators[284:266]) + $signed(2'h0);
  assign \$143  = $signed(whole_3_2) >= $signed(parameters[522:504]);
  assign \$144  = $signed(whole_3_2) >= $signed(parameters[541:523]);
  assign \$145  = $signed(whole_3_2) >= $signed(parameters[560:542]);
  assign \$146  = $signed(whole_3_2) >= $signed(parameters[579:561]);
  assign \$147  = $signed(whole_3_2) >= $signed(parameters[598:580]);
  assign \$148  = $signed(whole_3_2) >= $signed(parameters[617:599]);
  assign \$149  = $signed(whole_3_2) >= $signed(parameters[636:618]);
  assign \$150  = \$250 [2:0] ^ { invert_3_2, invert_3_2, invert_3_2 };
  assign \$152  = $signed(accumulators[303:285]) + $signed(2'h0);
  assign \$153  = $signed(whole_3_3) >= $signed(parameters[522:504]);
  assign \$154  = $signed(whole_3_3) >= $signed(parameters[541:523]);
  assign \$155  = $signed(whole_3_3) >= $signed(parameters[560:542]);
  assign \$156  = $signed(whole_3_3) >= $signed(parameters[579:561]);
  assign \$157  = $signed(whole_3_3) >= $signed(parameters[598:580]);
  assign \$158  = $signed(whole_3_3) >= $signed(parameters[617:599]);
  assign \$159  = $signed(whole_3_3) >= $signed(parameters[636:618]);
  assign \$160  = \$256 [2:0] ^ { invert_3_3, invert_3_3, invert_3_3 };
  assign \$161  = reached_0_0[0] + reached_0_0[1];
  assign \$162  = reached_0_0[2] + reached_0_0[3];
  assign \$163  = \$161  + \$162 ;
  assign \$164  = reached_0_0[4] + reached_0_0[5];
  assign \$165  = \$164  + reached_0_0[6];
  assign \$166  = \$163  + \$165 ;
  assign \$167  = reached_0_1[0] + reached_0_1[1];
  assign \$168  = reached_0_1[2] + reached_0_1[3];
  assign \$169  = \$167  + \$168 ;
  assign \$170  = reached_0_1[4] + reached_0_1[5];
  assign \$171  = \$170  + reached_0_1[6];
  assign \$172  = \$169  + \$171 ;
  assign \$173  = reached_0_2[0] + reached_0_2[1];
  assign \$174  = reached_0_2[2] + reached_0_2[3];
  assign \$175  = \$173  + \$174 ;
  assign \$176  = reached_0_2[4] + reached_0_2[5];
  assign \$177  = \$176  + reached_0_2[6];
  assign \$178  = \$175  + \$177 ;
  assign \$179  = reached_0_3[0] + reached_0_3[1];
  assign \$180  = reached_0_3[2] + reached_0_3[3];
  assign \$181  = \$179  + \$180 ;
  assign \$182  = reached_0_3[4] + reached_0_3[5];
  assign \$183  = \$182  + reached_0_3[6];
  assign \$184  = \$181  + \$183 ;
  assign \$185  = reached_1_0[0] + reached_1_0[1];
  assign \$186  = reached_1_0[2] + reached_1_0[3];
  assign \$187  = \$185  + \$186 ;
  assign \$188  = reached_1_0[4] + reached_1_0[5];
  assign \$189  = \$188  + reached_1_0[6];
  assign \$190  = \$187  + \$189 ;
  assign \$191  = reached_1_1[0] + reached_1_1[1];
  assign \$192  = reached_1_1[2] + reached_1_1[3];
  assign \$193  = \$191  + \$192 ;
  assign \$194  = reached_1_1[4] + reached_1_1[5];
  assign \$195  = \$194  + reached_1_1[6];
  assign \$196  = \$193  + \$195 ;
  assign \$197  = reached_1_2[0] + reached_1_2[1];
  assign \$198  = reached_1_2[2] + reached_1_2[3];
  assign \$199  = \$197  + \$198 ;
  assign \$200  = reached_1_2[4] + reached_1_2[5];
  assign \$201  = \$200  + reached_1_2[6];
  assign \$202  = \$199  + \$201 ;
  assign \$203  = reached_1_3[0] + reached_1_3[1];
  assign \$204  = reached_1_3[2] + reached_1_3[3];
  assign \$205  = \$203  + \$204 ;
  assign \$206  = reached_1_3[4] + reached_1_3[5];
  assign \$207  = \$206  + reached_1_3[6];
  assign \$208  = \$205  + \$207 ;
  assign \$209  = reached_2_0[0] + reached_2_0[1];
  assign \$210  = reached_2_0[2] + reached_2_0[3];
  assign \$211  = \$209  + \$210 ;
  assign \$212  = reached_2_0[4] + reached_2_0[5];
  assign \$213  = \$212  + reached_2_0[6];
  assign \$214  = \$211  + \$213 ;
  assign \$215  = reached_2_1[0] + reached_2_1[1];
  assign \$216  = reached_2_1[2] + reached_2_1[3];
  assign \$217  = \$215  + \$216 ;
  assign \$218  = reached_2_1[4] + reached_2_1[5];
  assign \$219  = \$218  + reached_2_1[6];
  assign \$220  = \$217  + \$219 ;
  assign \$221  = reached_2_2[0] + reached_2_2[1];
  assign \$222  = reached_2_2[2] + reached_2_2[3];
  assign \$223  = \$221  + \$222 ;
  assign \$224  = reached_2_2[4] + reached_2_2[5];
  assign \$225  = \$224  + reached_2_2[6];
  assign \$226  = \$223  + \$225 ;
  assign \$227  = reached_2_3[0] + reached_2_3[1];
  assign \$228  = reached_2_3[2] + reached_2_3[3];
  assign \$229  = \$227  + \$228 ;
  assign \$230  = reached_2_3[4] + reached_2_3[5];
  assign \$231  = \$230  + reached_2_3[6];
  assign \$232  = \$229  + \$231 ;
  assign \$233  = reached_3_0[0] + reached_3_0[1];
  assign \$234  = reached_3_0[2] + reached_3_0[3];
  assign \$235  = \$233  + \$234 ;
  assign \$236  = reached_3_0[4] + reached_3_0[5];
  assign \$237  = \$236  + reached_3_0[6];
  assign \$238  = \$235  + \$237 ;
  assign \$239  = reached_3_1[0] + reached_3_1[1];
  assign \$240  = reached_3_1[2] + reached_3_1[3];
  assign \$241  = \$239  + \$240 ;
  assign \$242  = reached_3_1[4] + reached_3_1[5];
  assign \$243  = \$242  + reached_3_1[6];
  assign \$244  = \$241  + \$243 ;
  assign \$245  = reached_3_2[0] + reached_3_2[1];
  assign \$246  = reached_3_2[2] + reached_3_2[3];
  assign \$247  = \$245  + \$246 ;
  assign \$248  = reached_3_2[4] + reached_3_2[5];
  assign \$249  = \$248  + reached_3_2[6];
  assign \$250  = \$247  + \$249 ;
  assign \$251  = reached_3_3[0] + reached_3_3[1];
  assign \$252  = reached_3_3[2] + reached_3_3[3];
  assign \$253  = \$251  + \$252 ;
  assign \$254  = reached_3_3[4] + reached_3_3[5];
  assign \$255  = \$254  + reached_3_3[6];
  assign \$256  = \$253  + \$255 ;
  always @(posedge clk)
    parameters <= \parameters$3 ;
  always @(posedge clk)
    whole_0_0 <= \$2 [18:0];
  always @(posedge clk)
    invert_0_0 <= parameters[133];
  always @(posedge clk)
    reached_0_0 <= \$257 ;
  always @(posedge clk)
    codes <= \$258 ;
  always @(posedge clk)
    whole_0_1 <= \$12 [18:0];
  always @(posedge clk)
    invert_0_1 <= parameters[133];
  always @(posedge clk)
    reached_0_1 <= \$259 ;
  always @(posedge clk)
    whole_0_2 <= \$22 [18:0];
  always @(posedge clk)
    invert_0_2 <= parameters[133];
  always @(posedge clk)
    reached_0_2 <= \$260 ;
  always @(posedge clk)
    whole_0_3 <= \$32 [18:0];
  always @(posedge clk)
    invert_0_3 <= parameters[133];
  always @(posedge clk)
    reached_0_3 <= \$261 ;
  always @(posedge clk)
    whole_1_0 <= \$42 [18:0];
  always @(posedge clk)
    invert_1_0 <= parameters[301];
  always @(posedge clk)
    reached_1_0 <= \$262 ;
  always @(posedge clk)
    whole_1_1 <= \$52 [18:0];
  always @(posedge clk)
    invert_1_1 <= parameters[301];
  always @(posedge clk)
    reached_1_1 <= \$263 ;
  always @(posedge clk)
    whole_1_2 <= \$62 [18:0];
  always @(posedge clk)
    invert_1_2 <= parameters[301];
  always @(posedge clk)
    reached_1_2 <= \$264 ;
  always @(posedge clk)
    whole_1_3 <= \$72 [18:0];
  always @(posedge clk)
    invert_1_3 <= parameters[301];
  always @(posedge clk)
    reached_1_3 <= \$265 ;
  always @(posedge clk)
    whole_2_0 <= \$82 [18:0];
  always @(posedge clk)
    invert_2_0 <= parameters[469];
  always @(posedge clk)
    reached_2_0 <= \$266 ;
  always @(posedge clk)
    whole_2_1 <= \$92 [18:0];
  always @(posedge clk)
    invert_2_1 <= parameters[469];
  always @(posedge clk)
    reached_2_1 <= \$267 ;
  always @(posedge clk)
    whole_2_2 <= \$102 [18:0];
  always @(posedge clk)
    invert_2_2 <= parameters[469];
  always @(posedge clk)
    reached_2_2 <= \$268 ;
  always @(posedge clk)
    whole_2_3 <= \$112 [18:0];
  always @(posedge clk)
    invert_2_3 <= parameters[469];
  always @(posedge clk)
    reached_2_3 <= \$269 ;
  always @(posedge clk)
    whole_3_0 <= \$122 [18:0];
  always @(posedge clk)
    invert_3_0 <= parameters[637];
  always @(posedge clk)
    reached_3_0 <= \$270 ;
  always @(posedge clk)
    whole_3_1 <= \$132 [18:0];
  always @(posedge clk)
    invert_3_1 <= parameters[637];
  always @(posedge clk)
    reached_3_1 <= \$271 ;
  always @(posedge clk)
    whole_3_2 <= \$142 [18:0];
  always @(posedge clk)
    invert_3_2 <= parameters[637];
  always @(posedge clk)
    reached_3_2 <= \$272 ;
  always @(posedge clk)
    whole_3_3 <= \$152 [18:0];
  always @(posedge clk)
    invert_3_3 <= parameters[637];
  always @(posedge clk)
    reached_3_3 <= \$273 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$4 ) begin end
    \$258 [2:0] = \$10 ;
    \$258 [14:12] = \$20 ;
    \$258 [26:24] = \$30 ;
    \$258 [38:36] = \$40 ;
    \$258 [5:3] = \$50 ;
    \$258 [17:15] = \$60 ;
    \$258 [29:27] = \$70 ;
    \$258 [41:39] = \$80 ;
    \$258 [8:6] = \$90 ;
    \$258 [20:18] = \$100 ;
    \$258 [32:30] = \$110 ;
    \$258 [44:42] = \$120 ;
    \$258 [11:9] = \$130 ;
    \$258 [23:21] = \$140 ;
    \$258 [35:33] = \$150 ;
    \$258 [47:45] = \$160 ;
    if (soft_reset) begin
      \$258  = 48'h000000000000;
    end
    if (rst) begin
      \$258  = 48'h000000000000;
    end
  end
  assign number_0_0 = \$166 [2:0];
  assign number_0_1 = \$172 [2:0];
  assign number_0_2 = \$178 [2:0];
  assign number_0_3 = \$184 [2:0];
  assign number_1_0 = \$190 [2:0];
  assign number_1_1 = \$196 [2:0];
  assign number_1_2 = \$202 [2:0];
  assign number_1_3 = \$208 [2:0];
  assign number_2_0 = \$214 [2:0];
  assign number_2_1 = \$220 [2:0];
  assign number_2_2 = \$226 [2:0];
  assign number_2_3 = \$232 [2:0];
  assign number_3_0 = \$238 [2:0];
  assign number_3_1 = \$244 [2:0];
  assign number_3_2 = \$250 [2:0];
  assign number_3_3 = \$256 [2:0];
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
  assign \$273 [6] = \$159 ;
  assign \$273 [5] = \$158 ;
  assign \$273 [4] = \$157 ;
  assign \$273 [3] = \$156 ;
  assign \$273 [2] = \$155 ;
  assign \$273 [1] = \$154 ;
  assign \$273 [0] = \$153 ;
  assign \$272 [6] = \$149 ;
  assign \$272 [5] = \$148 ;
  assign \$272 [4] = \$147 ;
  assign \$272 [3] = \$146 ;
  assign \$272 [2] = \$145 ;
  assign \$272 [1] = \$144 ;
  assign \$272 [0] = \$143 ;
  assign \$271 [6] = \$139 ;
  assign \$271 [5] = \$138 ;
  assign \$271 [4] = \$137 ;
  assign \$271 [3] = \$136 ;
  assign \$271 [2] = \$135 ;
  assign \$271 [1] = \$134 ;
  assign \$271 [0] = \$133 ;
  assign \$270 [6] = \$129 ;
  assign \$270 [5] = \$128 ;
  assign \$270 [4] = \$127 ;
  assign \$270 [3] = \$126 ;
  assign \$270 [2] = \$125 ;
  assign \$270 [1] = \$124 ;
  assign \$270 [0] = \$123 ;
  assign \$269 [6] = \$119 ;
  assign \$269 [5] = \$118 ;
  assign \$269 [4] = \$117 ;
  assign \$269 [3] = \$116 ;
  assign \$269 [2] = \$115 ;
  assign \$269 [1] = \$114 ;
  assign \$269 [0] = \$113 ;
  assign \$268 [6] = \$109 ;
  assign \$268 [5] = \$108 ;
  assign \$268 [4] = \$107 ;
  assign \$268 [3] = \$106 ;
  assign \$268 [2] = \$105 ;
  assign \$268 [1] = \$104 ;
  assign \$268 [0] = \$103 ;
  assign \$267 [6] = \$99 ;
  assign \$267 [5] = \$98 ;
  assign \$267 [4] = \$97 ;
  assign \$267 [3] = \$96 ;
  assign \$267 [2] = \$95 ;
  assign \$267 [1] = \$94 ;
  assign \$267 [0] = \$93 ;
  assign \$266 [6] = \$89 ;
  assign \$266 [5] = \$88 ;
  assign \$266 [4] = \$87 ;
  assign \$266 [3] = \$86 ;
  assign \$266 [2] = \$85 ;
  assign \$266 [1] = \$84 ;
  assign \$266 [0] = \$83 ;
  assign \$265 [6] = \$79 ;
  assign \$265 [5] = \$78 ;
  assign \$265 [4] = \$77 ;
  assign \$265 [3] = \$76 ;
  assign \$265 [2] = \$75 ;
  assign \$265 [1] = \$74 ;
  assign \$265 [0] = \$73 ;
  assign \$264 [6] = \$69 ;
  assign \$264 [5] = \$68 ;
  assign \$264 [4] = \$67 ;
  assign \$264 [3] = \$66 ;
  assign \$264 [2] = \$65 ;
  assign \$264 [1] = \$64 ;
  assign \$264 [0] = \$63 ;
  assign \$263 [6] = \$59 ;
  assign \$263 [5] = \$58 ;
  assign \$263 [4] = \$57 ;
  assign \$263 [3] = \$56 ;
  assign \$263 [2] = \$55 ;
  assign \$263 [1] = \$54 ;
  assign \$263 [0] = \$53 ;
  assign \$262 [6] = \$49 ;
  assign \$262 [5] = \$48 ;
  assign \$262 [4] = \$47 ;
  assign \$262 [3] = \$46 ;
  assign \$262 [2] = \$45 ;
  assign \$262 [1] = \$44 ;
  assign \$262 [0] = \$43 ;
  assign \$261 [6] = \$39 ;
  assign \$261 [5] = \$38 ;
  assign \$261 [4] = \$37 ;
  assign \$261 [3] = \$36 ;
  assign \$261 [2] = \$35 ;
  assign \$261 [1] = \$34 ;
  assign \$261 [0] = \$33 ;
  assign \$260 [6] = \$29 ;
  assign \$260 [5] = \$28 ;
  assign \$260 [4] = \$27 ;
  assign \$260 [3] = \$26 ;
  assign \$260 [2] = \$25 ;
  assign \$260 [1] = \$24 ;
  assign \$260 [0] = \$23 ;
  assign \$259 [6] = \$19 ;
  assign \$259 [5] = \$18 ;
  assign \$259 [4] = \$17 ;
  assign \$259 [3] = \$16 ;
  assign \$259 [2] = \$15 ;
  assign \$259 [1] = \$14 ;
  assign \$259 [0] = \$13 ;
  assign \$257 [6] = \$9 ;
  assign \$257 [5] = \$8 ;
  assign \$257 [4] = \$7 ;
  assign \$257 [3] = \$6 ;
  assign \$257 [2] = \$5 ;
  assign \$257 [1] = \$4 ;
  assign \$257 [0] = \$3 ;
  assign \$21  = 1'h0;
  assign \$31  = 1'h0;
  assign \$61  = 1'h0;
  assign \$71  = 1'h0;
  assign \$101  = 1'h0;
  assign \$111  = 1'h0;
  assign \$141  = 1'h0;
  assign \$151  = 1'h0;
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

module \macram_top.array.frame (i__valid, rst, o__valid, i__ready, fault, error, o__ready, i__payload, soft_reset, start, shape, open, clk);
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
  (* enum_value_110 = "BAD_RANGE" *)
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
  wire [63:0] o__payload;
  input o__ready;
  wire o__ready;
  output o__valid;
  wire o__valid;
  output open;
  reg open = 1'h0;
  reg [15:0] row = 16'h0000;
  input rst;
  wire rst;
  input [166:0] shape;
  wire [166:0] shape;
  wire [15:0] \shape.beats_in ;
  wire [15:0] \shape.beats_out ;
  wire \shape.biased ;
  wire [13:0] \shape.blocks ;
  wire [14:0] \shape.column_words ;
  wire [14:0] \shape.groups ;
  wire \shape.halved ;
  wire [15:0] \shape.height ;
  wire [13:0] \shape.ingest_words ;
  wire [15:0] \shape.out_height ;
  wire [11:0] \shape.output_words ;
  wire \shape.pointwise ;
  wire [1:0] \shape.tail ;
  wire [11:0] \shape.tiles ;
  wire [15:0] \shape.width ;
  input soft_reset;
  wire soft_reset;
  input start;
  wire start;
  assign o__valid = i__valid & open;
  assign i__ready = o__ready & open;
  assign \$signal  = i__valid & i__ready;
  assign \$1  = \$signal$9  + 1'h1;
  assign \$signal$8  = \$1  == shape[147:132];
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
    open <= \$15 ;
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
    \$15  = open;
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
  assign \shape.out_height  = shape[47:32];
  assign \shape.groups  = shape[62:48];
  assign \shape.tail  = shape[64:63];
  assign \shape.blocks  = shape[78:65];
  assign \shape.ingest_words  = shape[92:79];
  assign \shape.column_words  = shape[107:93];
  assign \shape.tiles  = shape[119:108];
  assign \shape.output_words  = shape[131:120];
  assign \shape.beats_in  = shape[147:132];
  assign \shape.beats_out  = shape[163:148];
  assign \shape.pointwise  = shape[164];
  assign \shape.halved  = shape[165];
  assign \shape.biased  = shape[166];
endmodule

module \macram_top.array.ingest (rst, i__valid, o__valid, i__ready, o__ready, i__payload, soft_reset, \port$1255$79 , beats_per_pixel, o__payload, clk);
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
  input [13:0] \port$1255$79 ;
  wire [13:0] \port$1255$79 ;
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
  assign \$4  = \$3  == \port$1255$79 ;
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
  assign words_per_pixel = { 2'h0, \port$1255$79  };
  assign \$like  = \$9 [6:0];
  assign o__payload = buffer[47:0];
  assign \$12  = { 48'h000000000000, buffer[111:48] };
endmodule

module \macram_top.array.lines (rst, i__valid, i__ready, soft_reset, start, shape, i__payload, group_written, image_written, word, retire, retire_row, read, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$8  = 0;
  wire \$1 ;
  wire \$10 ;
  wire \$11 ;
  wire \$12 ;
  wire [14:0] \$13 ;
  wire [15:0] \$14 ;
  wire [3:0] \$15 ;
  wire [14:0] \$16 ;
  wire [15:0] \$17 ;
  wire [3:0] \$18 ;
  wire [14:0] \$19 ;
  wire \$2 ;
  wire [14:0] \$20 ;
  wire [16:0] \$21 ;
  wire [16:0] \$22 ;
  wire [15:0] \$23 ;
  wire [15:0] \$24 ;
  wire [16:0] \$25 ;
  wire [16:0] \$26 ;
  wire \$27 ;
  wire [11:0] \$28 ;
  wire [12:0] \$29 ;
  wire \$3 ;
  wire [14:0] \$30 ;
  wire [16:0] \$31 ;
  wire [2:0] \$32 ;
  wire [17:0] \$33 ;
  wire [23:0] \$34 ;
  wire [23:0] \$35 ;
  wire [23:0] \$36 ;
  wire [23:0] \$37 ;
  wire [23:0] \$38 ;
  wire [23:0] \$39 ;
  wire [14:0] \$4 ;
  wire [23:0] \$40 ;
  wire [23:0] \$41 ;
  wire [23:0] \$42 ;
  wire [23:0] \$43 ;
  wire [23:0] \$44 ;
  wire [23:0] \$45 ;
  reg \$46 ;
  reg [13:0] \$47 ;
  reg [15:0] \$48 ;
  reg [8:0] \$49 ;
  wire \$5 ;
  reg [15:0] \$50 ;
  reg \$51 ;
  reg [10:0] \$52 ;
  reg \$53 ;
  reg [3:0] \$54 ;
  reg [95:0] \$55 ;
  wire [16:0] \$6 ;
  wire \$7 ;
  wire \$8 ;
  wire \$9 ;
  reg \$like  = 1'h0;
  wire [1:0] \$signal ;
  reg [13:0] \$signal$10  = 14'h0000;
  wire \$signal$11 ;
  wire \$signal$12 ;
  reg [15:0] \$signal$2  = 16'h0000;
  wire \$signal$7 ;
  wire \$signal$9 ;
  input clk;
  wire clk;
  reg [10:0] free = 11'h000;
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
  wire [13:0] odd_words;
  reg [95:0] picked;
  input [14:0] read;
  wire [14:0] read;
  wire [7:0] \read.address ;
  wire \read.bank ;
  wire [3:0] \read.mask ;
  wire [1:0] \read.slot ;
  wire [9:0] read__addr;
  wire [9:0] \read__addr$24 ;
  wire [95:0] read__data;
  wire [95:0] \read__data$28 ;
  input retire;
  wire retire;
  input retire_row;
  wire retire_row;
  reg [15:0] row = 16'h0000;
  input rst;
  wire rst;
  input [166:0] shape;
  wire [166:0] shape;
  wire [15:0] \shape.beats_in ;
  wire [15:0] \shape.beats_out ;
  wire \shape.biased ;
  wire [13:0] \shape.blocks ;
  wire [14:0] \shape.column_words ;
  wire [14:0] \shape.groups ;
  wire \shape.halved ;
  wire [15:0] \shape.height ;
  wire [13:0] \shape.ingest_words ;
  wire [15:0] \shape.out_height ;
  wire [11:0] \shape.output_words ;
  wire \shape.pointwise ;
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
  wire [9:0] \write__addr$21 ;
  wire [95:0] write__data;
  wire [95:0] \write__data$22 ;
  wire [3:0] write__en;
  wire [3:0] \write__en$23 ;
  assign \$36  = \$34  ^ \$35 ;
  assign \$37  = mask[1] ? picked[47:24] : 24'h000000;
  assign \$38  = shape[166] ? 24'h924924 : 24'h000000;
  assign \$39  = \$37  ^ \$38 ;
  assign \$40  = mask[2] ? picked[71:48] : 24'h000000;
  assign \$41  = shape[166] ? 24'h924924 : 24'h000000;
  assign \$42  = \$40  ^ \$41 ;
  assign \$43  = mask[3] ? picked[95:72] : 24'h000000;
  assign \$44  = shape[166] ? 24'h924924 : 24'h000000;
  assign \$45  = \$43  ^ \$44 ;
  always @(posedge clk)
    group_written <= \$46 ;
  always @(posedge clk)
    \$signal$10  <= \$47 ;
  always @(posedge clk)
    \$signal$2  <= \$48 ;
  always @(posedge clk)
    group_base <= \$49 ;
  always @(posedge clk)
    row <= \$50 ;
  always @(posedge clk)
    image_written <= \$51 ;
  always @(posedge clk)
    free <= \$52 ;
  always @(posedge clk)
    \$like  <= \$53 ;
  always @(posedge clk)
    mask <= \$54 ;
  always @(posedge clk)
    word <= \$55 ;
  assign \$signal  = shape[165] ? \$signal$2 [2:1] : \$signal$2 [1:0];
  assign \$1  = shape[165] & \$signal$2 [0];
  assign odd_words = \$1  ? shape[92:79] : 14'h0000;
  assign \$2  = | free;
  assign \$3  = ~ image_written;
  assign i__ready = \$2  & \$3 ;
  assign \$signal$7  = i__valid & i__ready;
  assign \$4  = \$signal$10  + 1'h1;
  assign \$5  = \$4  == shape[92:79];
  assign \$signal$9  = \$signal$7  & \$5 ;
  assign \$6  = \$signal$2  + 1'h1;
  assign \$7  = \$6  == shape[31:16];
  assign \$signal$11  = \$signal$9  & \$7 ;
  assign \$8  = & \$signal ;
  assign \$9  = \$signal$9  & \$8 ;
  assign \$10  = ~ shape[165];
  assign \$11  = \$signal$2 [0] | \$10 ;
  assign \$12  = \$9  & \$11 ;
  assign \$signal$12  = \$signal$11  | \$12 ;
  assign \$13  = group_base + odd_words;
  assign \$14  = \$13  + \$signal$10 ;
  assign \$15  = 1'h1 << \$signal ;
  assign write__en = \$signal$7  ? \$15  : 4'h0;
  assign \$16  = group_base + odd_words;
  assign \$17  = \$16  + \$signal$10 ;
  assign \$18  = 1'h1 << \$signal ;
  assign \write__en$23  = \$signal$7  ? \$18  : 4'h0;
  assign \$19  = \$signal$10  + 1'h1;
  assign \$20  = \$signal$9  ? 15'h0000 : \$19 ;
  assign \$21  = \$signal$2  + 1'h1;
  assign \$22  = \$signal$11  ? 17'h00000 : \$21 ;
  assign \$23  = group_base + shape[107:93];
  assign \$24  = \$signal$11  ? 16'h0000 : \$23 ;
  assign \$25  = row + 1'h1;
  assign \$26  = row + 1'h1;
  assign \$27  = \$26  == shape[15:0];
  assign \$28  = free - \$signal$12 ;
  assign \$29  = $signed(\$28 ) + $signed({ 1'h0, retire });
  assign \$30  = retire_row ? shape[62:48] : 15'h0000;
  assign \$31  = $signed(\$29 ) + $signed({ 1'h0, \$30  });
  assign \$32  = shape[164] ? 3'h4 : 3'h3;
  assign \$33  = \$32  * shape[62:48];
  assign \$34  = mask[0] ? picked[23:0] : 24'h000000;
  assign \$35  = shape[166] ? 24'h924924 : 24'h000000;
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
    .write_addr({ row[1:0], \$14 [7:0] }),
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
    .read_data(\read__data$28 ),
    .read_en(1'h1),
    .write_addr({ row[1:0], \$17 [7:0] }),
    .write_data({ i__payload[47:24], i__payload[47:24], i__payload[47:24], i__payload[47:24] }),
    .write_en(\write__en$23 )
  );
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    (* full_case = 32'd1 *)
    casez (\$like )
      1'h0:
          picked = read__data;
      1'h1:
          picked = \read__data$28 ;
    endcase
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$46  = \$signal$12 ;
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
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$47  = \$signal$10 ;
    if (\$signal$7 ) begin
      \$47  = \$20 [13:0];
    end
    if (start) begin
      \$47  = 14'h0000;
    end
    if (soft_reset) begin
      \$47  = 14'h0000;
    end
    if (rst) begin
      \$47  = 14'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$48  = \$signal$2 ;
    if (\$signal$9 ) begin
      \$48  = \$22 [15:0];
    end
    if (start) begin
      \$48  = 16'h0000;
    end
    if (soft_reset) begin
      \$48  = 16'h0000;
    end
    if (rst) begin
      \$48  = 16'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$49  = group_base;
    if (\$signal$12 ) begin
      \$49  = \$24 [8:0];
    end
    if (start) begin
      \$49  = 9'h000;
    end
    if (soft_reset) begin
      \$49  = 9'h000;
    end
    if (rst) begin
      \$49  = 9'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$50  = row;
    if (\$signal$11 ) begin
      \$50  = \$25 [15:0];
    end
    if (start) begin
      \$50  = 16'h0000;
    end
    if (soft_reset) begin
      \$50  = 16'h0000;
    end
    if (rst) begin
      \$50  = 16'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$51  = image_written;
    if (\$signal$11 ) begin
      if (\$27 ) begin
        \$51  = 1'h1;
      end
    end
    if (start) begin
      \$51  = 1'h0;
    end
    if (soft_reset) begin
      \$51  = 1'h1;
    end
    if (rst) begin
      \$51  = 1'h1;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$52  = \$31 [10:0];
    if (start) begin
      \$52  = \$33 [10:0];
    end
    if (soft_reset) begin
      \$52  = 11'h000;
    end
    if (rst) begin
      \$52  = 11'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$53  = read[10];
    if (soft_reset) begin
      \$53  = 1'h0;
    end
    if (rst) begin
      \$53  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$54  = read[14:11];
    if (soft_reset) begin
      \$54  = 4'h0;
    end
    if (rst) begin
      \$54  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$55 [23:0] = \$36 ;
    \$55 [47:24] = \$39 ;
    \$55 [71:48] = \$42 ;
    \$55 [95:72] = \$45 ;
    if (soft_reset) begin
      \$55  = 96'h000000000000000000000000;
    end
    if (rst) begin
      \$55  = 96'h000000000000000000000000;
    end
  end
  assign write__addr = { row[1:0], \$14 [7:0] };
  assign write__data = { i__payload[23:0], i__payload[23:0], i__payload[23:0], i__payload[23:0] };
  assign read__addr = { read[1:0], read[9:2] };
  assign \write__addr$21  = { row[1:0], \$17 [7:0] };
  assign \write__data$22  = { i__payload[47:24], i__payload[47:24], i__payload[47:24], i__payload[47:24] };
  assign \read__addr$24  = { read[1:0], read[9:2] };
  assign \shape.height  = shape[15:0];
  assign \shape.width  = shape[31:16];
  assign \shape.out_height  = shape[47:32];
  assign \shape.groups  = shape[62:48];
  assign \shape.tail  = shape[64:63];
  assign \shape.blocks  = shape[78:65];
  assign \shape.ingest_words  = shape[92:79];
  assign \shape.column_words  = shape[107:93];
  assign \shape.tiles  = shape[119:108];
  assign \shape.output_words  = shape[131:120];
  assign \shape.beats_in  = shape[147:132];
  assign \shape.beats_out  = shape[163:148];
  assign \shape.pointwise  = shape[164];
  assign \shape.halved  = shape[165];
  assign \shape.biased  = shape[166];
  assign \read.slot  = read[1:0];
  assign \read.address  = read[9:2];
  assign \read.bank  = read[10];
  assign \read.mask  = read[14:11];
endmodule

module \macram_top.array.loader (i__valid, rst, fault, error, i__payload, soft_reset, words, base, start_weights, start_requant, \port$1507$0 , \port$1509$0 , \port$1511$0 , i__ready, to_requant, unit_en, requant_en, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$9  = 0;
  wire [4:0] \$1 ;
  wire [1086:0] \$10 ;
  wire [4:0] \$11 ;
  wire [4:0] \$12 ;
  wire [11:0] \$13 ;
  wire [11:0] \$14 ;
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
  wire [32:0] \$24 ;
  wire [32:0] \$25 ;
  reg [9:0] \$26 ;
  reg [9:0] \$27  = 10'h000;
  reg [7:0] \$28 ;
  reg [7:0] \$29  = 8'h00;
  wire \$3 ;
  reg [703:0] \$30 ;
  reg [3:0] \$31 ;
  reg [10:0] \$32 ;
  reg [63:0] \$33 ;
  reg \$34 ;
  reg \$35 ;
  reg [63:0] \$36 ;
  reg \$37 ;
  wire [11:0] \$4 ;
  wire \$5 ;
  wire \$6 ;
  wire \$7 ;
  wire [703:0] \$8 ;
  wire [1086:0] \$9 ;
  wire \$signal ;
  wire \$signal$10 ;
  wire \$signal$4 ;
  wire \$signal$7 ;
  input [31:0] base;
  wire [31:0] base;
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
  (* enum_value_110 = "BAD_RANGE" *)
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
  (* init = 10'h000 *)
  output [9:0] \port$1507$0 ;
  wire [9:0] \port$1507$0 ;
  (* init = 8'h00 *)
  output [7:0] \port$1509$0 ;
  wire [7:0] \port$1509$0 ;
  output [671:0] \port$1511$0 ;
  wire [671:0] \port$1511$0 ;
  wire [679:0] requant;
  wire [7:0] \requant.addr ;
  wire [671:0] \requant.data ;
  output requant_en;
  reg requant_en = 1'h0;
  input rst;
  wire rst;
  reg [703:0] shifter = 704'h00000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000;
  input soft_reset;
  wire soft_reset;
  input start_requant;
  wire start_requant;
  input start_weights;
  wire start_weights;
  output to_requant;
  reg to_requant = 1'h0;
  reg [63:0] unit = 64'h0000000000000000;
  output [63:0] unit_en;
  reg [63:0] unit_en = 64'h0000000000000000;
  wire [81:0] weight;
  wire [9:0] \weight.addr ;
  wire [71:0] \weight.data ;
  reg [10:0] word_index = 11'h000;
  input [31:0] words;
  wire [31:0] words;
  assign \$signal  = i__valid & i__ready;
  assign \$1  = beat_index + 1'h1;
  assign \$2  = to_requant ? 4'hb : 4'h2;
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
  assign \$10  = { 383'h000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000, \$8  } | \$9 ;
  assign \$11  = beat_index + 1'h1;
  assign \$12  = \$signal$4  ? 5'h00 : \$11 ;
  assign \$13  = word_index + 1'h1;
  assign \$14  = \$signal$7  ? 12'h000 : \$13 ;
  assign \$16  = \$signal$10  | fault;
  assign \$17  = ~ i__ready;
  assign \$18  = start_weights | start_requant;
  assign \$19  = \$17  & \$18 ;
  assign \$20  = ~ to_requant;
  assign \$21  = \$signal$4  & \$20 ;
  assign \$22  = \$21  ? unit : 64'h0000000000000000;
  assign \$23  = \$signal$4  & to_requant;
  assign \$24  = base + word_index;
  assign \$25  = base + word_index;
  always @(posedge clk)
    \$27  <= \$26 ;
  always @(posedge clk)
    \$29  <= \$28 ;
  always @(posedge clk)
    shifter <= \$30 ;
  always @(posedge clk)
    beat_index <= \$31 ;
  always @(posedge clk)
    word_index <= \$32 ;
  always @(posedge clk)
    unit <= \$33 ;
  always @(posedge clk)
    i__ready <= \$34 ;
  always @(posedge clk)
    to_requant <= \$35 ;
  always @(posedge clk)
    unit_en <= \$36 ;
  always @(posedge clk)
    requant_en <= \$37 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$26  = \$24 [9:0];
    if (soft_reset) begin
      \$26  = 10'h000;
    end
    if (rst) begin
      \$26  = 10'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$28  = \$25 [7:0];
    if (soft_reset) begin
      \$28  = 8'h00;
    end
    if (rst) begin
      \$28  = 8'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$30  = shifter;
    if (\$signal ) begin
      \$30  = \$10 [703:0];
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$31  = beat_index;
    if (\$signal ) begin
      \$31  = \$12 [3:0];
    end
    if (\$19 ) begin
      \$31  = 4'h0;
    end
    if (soft_reset) begin
      \$31  = 4'h0;
    end
    if (rst) begin
      \$31  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$32  = word_index;
    if (\$signal$4 ) begin
      \$32  = \$14 [10:0];
    end
    if (\$19 ) begin
      \$32  = 11'h000;
    end
    if (soft_reset) begin
      \$32  = 11'h000;
    end
    if (rst) begin
      \$32  = 11'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$33  = unit;
    if (\$signal$7 ) begin
      \$33  = \$15 [63:0];
    end
    if (\$19 ) begin
      \$33  = 64'h0000000000000001;
    end
    if (soft_reset) begin
      \$33  = 64'h0000000000000000;
    end
    if (rst) begin
      \$33  = 64'h0000000000000000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$34  = i__ready;
    if (\$16 ) begin
      \$34  = 1'h0;
    end
    if (\$19 ) begin
      \$34  = 1'h1;
    end
    if (soft_reset) begin
      \$34  = 1'h0;
    end
    if (rst) begin
      \$34  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$35  = to_requant;
    if (\$19 ) begin
      \$35  = start_requant;
    end
    if (soft_reset) begin
      \$35  = 1'h0;
    end
    if (rst) begin
      \$35  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$36  = \$22 ;
    if (soft_reset) begin
      \$36  = 64'h0000000000000000;
    end
    if (rst) begin
      \$36  = 64'h0000000000000000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$37  = \$23 ;
    if (soft_reset) begin
      \$37  = 1'h0;
    end
    if (rst) begin
      \$37  = 1'h0;
    end
  end
  assign busy = i__ready;
  assign weight = { shifter[647:576], \$27  };
  assign requant = { shifter[671:0], \$29  };
  assign \port$1507$0  = \$27 ;
  assign \port$1509$0  = \$29 ;
  assign \port$1511$0  = shifter[671:0];
  assign \i__payload.data  = i__payload[63:0];
  assign \i__payload.last  = i__payload[64];
  assign \weight.addr  = \$27 ;
  assign \weight.data  = shifter[647:576];
  assign \requant.addr  = \$29 ;
  assign \requant.data  = shifter[671:0];
  assign \$8  = { 64'h0000000000000000, shifter[703:64] };
  assign \$9  = { 383'h000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000, i__payload[63:0], 640'h0000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000 };
  assign \$15  = { unit, 1'h0 };
endmodule

module \macram_top.array.sequencer (rst, starved, blocked, issue, credit, soft_reset, weight_base, start, shape, group_written, image_written, retire, retire_row, flushing, \step$45 , clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$10  = 0;
  wire [14:0] \$1 ;
  wire \$10 ;
  wire [3:0] \$100 ;
  wire [3:0] \$101 ;
  wire [3:0] \$102 ;
  wire \$103 ;
  wire \$104 ;
  wire \$105 ;
  wire \$106 ;
  reg \$107 ;
  reg \$108 ;
  reg [17:0] \$109 ;
  wire \$11 ;
  reg \$110 ;
  reg [13:0] \$111 ;
  reg [10:0] \$112 ;
  reg \$113 ;
  reg [1:0] \$114 ;
  reg [11:0] \$115 ;
  reg [14:0] \$116 ;
  reg [8:0] \$117 ;
  reg [15:0] \$118 ;
  reg \$119 ;
  wire \$12 ;
  reg \$120 ;
  reg \$121 ;
  reg [43:0] \$122 ;
  wire \$13 ;
  wire \$14 ;
  wire [12:0] \$15 ;
  wire [15:0] \$16 ;
  wire [16:0] \$17 ;
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
  wire \$27 ;
  wire \$28 ;
  wire \$29 ;
  wire \$3 ;
  wire \$30 ;
  wire \$31 ;
  wire [17:0] \$32 ;
  wire [18:0] \$33 ;
  wire [17:0] \$34 ;
  wire [18:0] \$35 ;
  wire [18:0] \$36 ;
  wire \$37 ;
  wire \$38 ;
  wire \$39 ;
  wire \$4 ;
  wire [16:0] \$40 ;
  wire [2:0] \$41 ;
  wire [2:0] \$42 ;
  wire [18:0] \$43 ;
  wire \$44 ;
  wire \$45 ;
  wire \$46 ;
  wire \$47 ;
  wire \$48 ;
  wire \$49 ;
  wire \$5 ;
  wire [3:0] \$50 ;
  wire [4:0] \$51 ;
  wire [4:0] \$52 ;
  wire \$53 ;
  wire \$54 ;
  wire \$55 ;
  wire \$56 ;
  wire \$57 ;
  wire \$58 ;
  wire \$59 ;
  wire \$6 ;
  wire \$60 ;
  wire \$61 ;
  wire \$62 ;
  wire \$63 ;
  wire \$64 ;
  wire \$65 ;
  wire \$66 ;
  wire \$67 ;
  wire [18:0] \$68 ;
  wire \$69 ;
  wire \$7 ;
  wire \$70 ;
  wire \$71 ;
  wire [19:0] \$72 ;
  wire [14:0] \$73 ;
  wire [20:0] \$74 ;
  wire \$75 ;
  wire [14:0] \$76 ;
  wire [11:0] \$77 ;
  wire \$78 ;
  wire \$79 ;
  wire \$8 ;
  wire [2:0] \$80 ;
  wire [12:0] \$81 ;
  wire [15:0] \$82 ;
  wire [15:0] \$83 ;
  wire \$84 ;
  wire [16:0] \$85 ;
  wire \$86 ;
  wire \$87 ;
  wire \$88 ;
  wire \$89 ;
  wire \$9 ;
  wire \$90 ;
  wire \$91 ;
  wire [15:0] \$92 ;
  wire [15:0] \$93 ;
  wire [13:0] \$94 ;
  wire [14:0] \$95 ;
  wire [13:0] \$96 ;
  wire [15:0] \$97 ;
  wire \$98 ;
  wire \$99 ;
  wire \$signal ;
  wire \$signal$10 ;
  wire \$signal$12 ;
  wire \$signal$13 ;
  reg [14:0] \$signal$14  = 15'h0000;
  wire \$signal$15 ;
  reg [15:0] \$signal$16  = 16'h0000;
  wire \$signal$4 ;
  reg \$signal$6  = 1'h0;
  wire \$signal$7 ;
  reg [1:0] \$signal$8  = 2'h0;
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
  wire kernel_row_last;
  wire last;
  wire [3:0] pixels;
  wire pixels_ready;
  output retire;
  reg retire = 1'h0;
  output retire_row;
  reg retire_row = 1'h0;
  wire row_exists;
  input rst;
  wire rst;
  input [166:0] shape;
  wire [166:0] shape;
  wire [15:0] \shape.beats_in ;
  wire [15:0] \shape.beats_out ;
  wire \shape.biased ;
  wire [13:0] \shape.blocks ;
  wire [14:0] \shape.column_words ;
  wire [14:0] \shape.groups ;
  wire \shape.halved ;
  wire [15:0] \shape.height ;
  wire [13:0] \shape.ingest_words ;
  wire [15:0] \shape.out_height ;
  wire [11:0] \shape.output_words ;
  wire \shape.pointwise ;
  wire [1:0] \shape.tail ;
  wire [11:0] \shape.tiles ;
  wire [15:0] \shape.width ;
  wire skipped;
  wire [3:0] slots;
  input soft_reset;
  wire soft_reset;
  wire [17:0] source_row;
  wire [16:0] source_row_below;
  input start;
  wire start;
  output starved;
  wire starved;
  wire step;
  output [43:0] \step$45 ;
  reg [43:0] \step$45  = 44'h00000000000;
  wire [7:0] \step$45.control ;
  wire \step$45.control.edge ;
  wire \step$45.control.en ;
  wire \step$45.control.first ;
  wire \step$45.control.last ;
  wire [3:0] \step$45.control.tile ;
  wire [10:0] \step$45.info ;
  wire \step$45.info.edge ;
  wire \step$45.info.image_last ;
  wire [3:0] \step$45.info.slots ;
  wire [3:0] \step$45.info.tile ;
  wire \step$45.info.tile_last ;
  wire [14:0] \step$45.read ;
  wire [7:0] \step$45.read.address ;
  wire \step$45.read.bank ;
  wire [3:0] \step$45.read.mask ;
  wire [1:0] \step$45.read.slot ;
  wire [9:0] \step$45.weight ;
  wire step_last;
  reg [11:0] tile = 12'h000;
  reg valid = 1'h0;
  reg [10:0] weight = 11'h000;
  input [9:0] weight_base;
  wire [9:0] weight_base;
  assign \$1  = block + 1'h1;
  assign \$2  = \$1  == shape[78:65];
  assign \$signal  = flushing | \$2 ;
  assign \$3  = ~ shape[164];
  assign \$signal$4  = shape[165] & \$3 ;
  assign \$4  = ~ \$signal$4 ;
  assign \$5  = \$signal$6  | \$4 ;
  assign kernel_row_last = \$signal  & \$5 ;
  assign \$6  = ! \$signal$8 ;
  assign \$7  = ~ \$signal$6 ;
  assign \$8  = \$6  & \$7 ;
  assign \$9  = ! block;
  assign \$10  = \$8  & \$9 ;
  assign \$signal$7  = flushing | \$10 ;
  assign \$11  = \$signal$8  == 2'h2;
  assign \$12  = shape[164] | \$11 ;
  assign \$13  = kernel_row_last & \$12 ;
  assign last = flushing | \$13 ;
  assign \$14  = ! tile;
  assign \$signal$10  = \$signal$7  & \$14 ;
  assign \$15  = tile + 1'h1;
  assign \$signal$12  = \$15  == shape[119:108];
  assign \$16  = \$signal$14  + 1'h1;
  assign \$signal$13  = \$16  == shape[62:48];
  assign \$17  = \$signal$16  + 1'h1;
  assign \$signal$15  = \$17  == shape[47:32];
  assign \$18  = ~ \$signal$10 ;
  assign \$19  = \$18  | image_written;
  assign \$20  = $signed(ahead) > $signed(1'h0);
  assign \$21  = \$19  | \$20 ;
  assign pixels_ready = \$21  | flushing;
  assign \$22  = ~ pixels_ready;
  assign starved = busy & \$22 ;
  assign \$23  = busy & pixels_ready;
  assign \$24  = \$23  & last;
  assign \$25  = ~ credits;
  assign blocked = \$24  & \$25 ;
  assign \$26  = busy & pixels_ready;
  assign \$27  = ~ credits;
  assign \$28  = last & \$27 ;
  assign \$29  = ~ \$28 ;
  assign step = \$26  & \$29 ;
  assign \$30  = ~ flushing;
  assign issue = step & \$30 ;
  assign \$31  = issue & last;
  assign step_last = \$31  & \$signal$12 ;
  assign \$32  = 2'h2 * \$signal$16 ;
  assign \$33  = \$32  + 2'h2;
  assign \$34  = 2'h2 * \$signal$16 ;
  assign \$35  = \$34  + 2'h3;
  assign \$36  = shape[164] ? \$33  : \$35 ;
  assign \$37  = step_last & \$signal$13 ;
  assign \$38  = \$37  & shape[165];
  assign \$39  = \$36 [16:0] < shape[15:0];
  assign skipped = \$38  & \$39 ;
  assign \$40  = \$signal$16  << shape[165];
  assign \$41  = \$signal$8  - 1'h1;
  assign \$42  = shape[164] ? 3'h0 : \$41 ;
  assign \$43  = $signed({ 1'h0, \$40  }) + $signed(\$42 );
  assign \$44  = $signed(\$43 [17:0]) >= $signed(1'h0);
  assign \$45  = $signed(\$43 [17:0]) < $signed({ 1'h0, shape[15:0] });
  assign \$46  = \$44  & \$45 ;
  assign \$47  = ~ flushing;
  assign row_exists = \$46  & \$47 ;
  assign \$48  = | shape[64:63];
  assign \$49  = \$signal$13  & \$48 ;
  assign \$50  = 1'h1 << shape[64:63];
  assign \$51  = \$50  - 1'h1;
  assign \$52  = \$49  ? \$51  : 5'h0f;
  assign \edge  = ! \$signal$14 ;
  assign \$53  = ! shape[64:63];
  assign \$54  = | \$signal$16 ;
  assign \$55  = \$53  & \$54 ;
  assign \$56  = \edge  ? \$55  : 1'h1;
  assign \$57  = ~ flushing;
  assign \$58  = ~ flushing;
  assign \$59  = \$58  & \$52 [1];
  assign \$60  = ~ flushing;
  assign \$61  = \$60  & \$52 [2];
  assign \$62  = issue & \$signal$12 ;
  assign \$63  = ! \$signal$8 ;
  assign \$64  = \$62  & \$63 ;
  assign \$65  = \$64  & kernel_row_last;
  assign \$66  = step_last & \$signal$13 ;
  assign \$67  = \$66  & shape[165];
  assign \$68  = $signed(ahead) + $signed({ 1'h0, group_written });
  assign \$69  = step & \$signal$10 ;
  assign \$70  = ~ flushing;
  assign \$71  = \$69  & \$70 ;
  assign \$72  = $signed(\$68 ) - $signed({ 1'h0, \$71  });
  assign \$73  = skipped ? shape[62:48] : 15'h0000;
  assign \$74  = $signed(\$72 ) - $signed({ 1'h0, \$73  });
  assign \$75  = step & last;
  assign \$76  = block + 1'h1;
  assign \$77  = weight + 1'h1;
  assign \$78  = ~ \$signal$6 ;
  assign \$79  = \$signal$4  & \$78 ;
  assign \$80  = \$signal$8  + 1'h1;
  assign \$81  = tile + 1'h1;
  assign \$82  = \$signal$14  + 1'h1;
  assign \$83  = group_base + shape[107:93];
  assign \$84  = \$signal$13  | flushing;
  assign \$85  = \$signal$16  + 1'h1;
  assign \$86  = \$signal$15  | flushing;
  assign \$87  = ! shape[64:63];
  assign \$88  = ~ flushing;
  assign \$89  = \$87  & \$88 ;
  assign \$90  = shape[15:0] == 1'h1;
  assign \$91  = \$90  | shape[164];
  assign \$92  = - shape[62:48];
  assign \$93  = \$91  ? 16'h0000 : \$92 ;
  assign \$94  = \$signal$6  ? shape[92:79] : 14'h0000;
  assign \$95  = group_base + \$94 ;
  assign \$97  = \$95  + \$96 ;
  assign \$98  = \$signal$6  & \$signal$13 ;
  assign \$99  = \$98  & shape[16];
  assign \$101  = \$99  ? \$100  : \$52 [3:0];
  assign \$102  = row_exists ? \$101  : 4'h0;
  assign \$103  = \$signal$15  & \$signal$13 ;
  assign \$104  = | shape[64:63];
  assign \$105  = \$103  & \$104 ;
  assign \$106  = flushing | \$105 ;
  always @(posedge clk)
    retire <= \$107 ;
  always @(posedge clk)
    retire_row <= \$108 ;
  always @(posedge clk)
    ahead <= \$109 ;
  always @(posedge clk)
    credits <= \$110 ;
  always @(posedge clk)
    block <= \$111 ;
  always @(posedge clk)
    weight <= \$112 ;
  always @(posedge clk)
    \$signal$6  <= \$113 ;
  always @(posedge clk)
    \$signal$8  <= \$114 ;
  always @(posedge clk)
    tile <= \$115 ;
  always @(posedge clk)
    \$signal$14  <= \$116 ;
  always @(posedge clk)
    group_base <= \$117 ;
  always @(posedge clk)
    \$signal$16  <= \$118 ;
  always @(posedge clk)
    flushing <= \$119 ;
  always @(posedge clk)
    busy <= \$120 ;
  always @(posedge clk)
    valid <= \$121 ;
  always @(posedge clk)
    \step$45  <= \$122 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$107  = \$65 ;
    if (start) begin
      \$107  = 1'h0;
    end
    if (soft_reset) begin
      \$107  = 1'h0;
    end
    if (rst) begin
      \$107  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$108  = \$67 ;
    if (start) begin
      \$108  = 1'h0;
    end
    if (soft_reset) begin
      \$108  = 1'h0;
    end
    if (rst) begin
      \$108  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$109  = \$74 [17:0];
    if (start) begin
      \$109  = { \$93 [15], \$93 [15], \$93  };
    end
    if (soft_reset) begin
      \$109  = 18'h00000;
    end
    if (rst) begin
      \$109  = 18'h00000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$110  = credits;
    if (credit) begin
      \$110  = 1'h1;
    end else if (\$75 ) begin
      \$110  = 1'h0;
    end
    if (start) begin
      \$110  = 1'h1;
    end
    if (soft_reset) begin
      \$110  = 1'h0;
    end
    if (rst) begin
      \$110  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$111  = block;
    if (step) begin
      \$111  = \$76 [13:0];
      if (\$signal ) begin
        \$111  = 14'h0000;
      end
    end
    if (start) begin
      \$111  = 14'h0000;
    end
    if (soft_reset) begin
      \$111  = 14'h0000;
    end
    if (rst) begin
      \$111  = 14'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$112  = weight;
    if (step) begin
      \$112  = \$77 [10:0];
      if (last) begin
        if (\$signal$12 ) begin
          \$112  = { 1'h0, weight_base };
        end
      end
    end
    if (start) begin
      \$112  = { 1'h0, weight_base };
    end
    if (soft_reset) begin
      \$112  = 11'h000;
    end
    if (rst) begin
      \$112  = 11'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$113  = \$signal$6 ;
    if (step) begin
      if (\$signal ) begin
        \$113  = \$79 ;
      end
      if (last) begin
        \$113  = 1'h0;
      end
    end
    if (start) begin
      \$113  = 1'h0;
    end
    if (soft_reset) begin
      \$113  = 1'h0;
    end
    if (rst) begin
      \$113  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$114  = \$signal$8 ;
    if (step) begin
      if (kernel_row_last) begin
        \$114  = \$80 [1:0];
      end
      if (last) begin
        \$114  = 2'h0;
      end
    end
    if (start) begin
      \$114  = 2'h0;
    end
    if (soft_reset) begin
      \$114  = 2'h0;
    end
    if (rst) begin
      \$114  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$115  = tile;
    if (step) begin
      if (last) begin
        \$115  = \$81 [11:0];
        if (\$signal$12 ) begin
          \$115  = 12'h000;
        end
      end
    end
    if (start) begin
      \$115  = 12'h000;
    end
    if (soft_reset) begin
      \$115  = 12'h000;
    end
    if (rst) begin
      \$115  = 12'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$116  = \$signal$14 ;
    if (step) begin
      if (last) begin
        if (\$signal$12 ) begin
          \$116  = \$82 [14:0];
          if (\$84 ) begin
            \$116  = 15'h0000;
          end
        end
      end
    end
    if (start) begin
      \$116  = 15'h0000;
    end
    if (soft_reset) begin
      \$116  = 15'h0000;
    end
    if (rst) begin
      \$116  = 15'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$117  = group_base;
    if (step) begin
      if (last) begin
        if (\$signal$12 ) begin
          \$117  = \$83 [8:0];
          if (\$84 ) begin
            \$117  = 9'h000;
          end
        end
      end
    end
    if (start) begin
      \$117  = 9'h000;
    end
    if (soft_reset) begin
      \$117  = 9'h000;
    end
    if (rst) begin
      \$117  = 9'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$118  = \$signal$16 ;
    if (step) begin
      if (last) begin
        if (\$signal$12 ) begin
          if (\$84 ) begin
            \$118  = \$85 [15:0];
          end
        end
      end
    end
    if (start) begin
      \$118  = 16'h0000;
    end
    if (soft_reset) begin
      \$118  = 16'h0000;
    end
    if (rst) begin
      \$118  = 16'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$119  = flushing;
    if (step) begin
      if (last) begin
        if (\$signal$12 ) begin
          if (\$84 ) begin
            if (\$86 ) begin
              (* full_case = 32'd1 *)
              if (\$89 ) begin
                \$119  = 1'h1;
              end else begin
                \$119  = 1'h0;
              end
            end
          end
        end
      end
    end
    if (start) begin
      \$119  = 1'h0;
    end
    if (soft_reset) begin
      \$119  = 1'h0;
    end
    if (rst) begin
      \$119  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$120  = busy;
    if (step) begin
      if (last) begin
        if (\$signal$12 ) begin
          if (\$84 ) begin
            if (\$86 ) begin
              (* full_case = 32'd1 *)
              if (\$89 ) begin
              end else begin
                \$120  = 1'h0;
              end
            end
          end
        end
      end
    end
    if (start) begin
      \$120  = 1'h1;
    end
    if (soft_reset) begin
      \$120  = 1'h0;
    end
    if (rst) begin
      \$120  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$121  = step;
    if (soft_reset) begin
      \$121  = 1'h0;
    end
    if (rst) begin
      \$121  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$122 [1:0] = \$43 [1:0];
    \$122 [9:2] = \$97 [7:0];
    \$122 [10] = block[0];
    \$122 [14:11] = \$102 ;
    \$122 [24:15] = weight[9:0];
    \$122 [25] = step;
    \$122 [26] = \$signal$7 ;
    \$122 [27] = last;
    \$122 [28] = \edge ;
    \$122 [32:29] = tile[3:0];
    \$122 [36:33] = tile[3:0];
    \$122 [37] = \$signal$12 ;
    \$122 [41:38] = slots;
    \$122 [42] = \edge ;
    \$122 [43] = \$106 ;
    if (soft_reset) begin
      \$122  = 44'h00000000000;
    end
    if (rst) begin
      \$122  = 44'h00000000000;
    end
  end
  assign source_row_below = \$36 [16:0];
  assign source_row = \$43 [17:0];
  assign pixels = \$52 [3:0];
  assign \shape.height  = shape[15:0];
  assign \shape.width  = shape[31:16];
  assign \shape.out_height  = shape[47:32];
  assign \shape.groups  = shape[62:48];
  assign \shape.tail  = shape[64:63];
  assign \shape.blocks  = shape[78:65];
  assign \shape.ingest_words  = shape[92:79];
  assign \shape.column_words  = shape[107:93];
  assign \shape.tiles  = shape[119:108];
  assign \shape.output_words  = shape[131:120];
  assign \shape.beats_in  = shape[147:132];
  assign \shape.beats_out  = shape[163:148];
  assign \shape.pointwise  = shape[164];
  assign \shape.halved  = shape[165];
  assign \shape.biased  = shape[166];
  assign \step$45.read  = \step$45 [14:0];
  assign \step$45.read.slot  = \step$45 [1:0];
  assign \step$45.read.address  = \step$45 [9:2];
  assign \step$45.read.bank  = \step$45 [10];
  assign \step$45.read.mask  = \step$45 [14:11];
  assign \step$45.weight  = \step$45 [24:15];
  assign \step$45.control  = \step$45 [32:25];
  assign \step$45.control.en  = \step$45 [25];
  assign \step$45.control.first  = \step$45 [26];
  assign \step$45.control.last  = \step$45 [27];
  assign \step$45.control.edge  = \step$45 [28];
  assign \step$45.control.tile  = \step$45 [32:29];
  assign \step$45.info  = \step$45 [43:33];
  assign \step$45.info.tile  = \step$45 [36:33];
  assign \step$45.info.tile_last  = \step$45 [37];
  assign \step$45.info.slots  = \step$45 [41:38];
  assign \step$45.info.edge  = \step$45 [42];
  assign \step$45.info.image_last  = \step$45 [43];
  assign slots[3] = \$61 ;
  assign slots[2] = \$59 ;
  assign slots[1] = \$57 ;
  assign slots[0] = \$56 ;
  assign \$96  = { 1'h0, block[13:1] };
  assign \$100  = { 1'h0, \$52 [3:1] };
endmodule

module \macram_top.array.unit000 (rst, core__shift, chain_o, core__chain_i, core__control, core__activations, address, write__addr, write__data, write__en, clk);
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
  wire [9:0] \$signature__addr ;
  wire [71:0] \$signature__data ;
  wire [95:0] activations;
  input [9:0] address;
  wire [9:0] address;
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
  wire [81:0] write;
  wire [9:0] \write.addr ;
  wire [71:0] \write.data ;
  input [9:0] write__addr;
  wire [9:0] write__addr;
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
    .ADDR_BITS(32'd10),
    .DEPTH(32'd1024),
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
, c_out, mode, param_words, param_base, weight_base, requant_base, axi__rvalid, axi__rdata, axi__rresp, \port$1214$0 , \port$1220$0 , cycles, mac_cycles, fill_cycles, input_stalls, output_stalls, drain_cycles, loading, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$11  = 0;
  wire \$1 ;
  wire \$10 ;
  wire \$11 ;
  wire \$12 ;
  wire [3:0] \$13 ;
  wire \$14 ;
  reg [4:0] \$15 ;
  reg \$16 ;
  reg [31:0] \$17 ;
  reg [3:0] \$18 ;
  reg \$19 ;
  wire \$2 ;
  reg [3:0] \$20 ;
  reg \$21 ;
  reg [1:0] \$22 ;
  reg [31:0] \$23 ;
  reg [31:0] \$24 ;
  reg [31:0] \$25 ;
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
  reg [4:0] \$signal$32  = 5'h00;
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
  input loading;
  wire loading;
  input [31:0] mac_cycles;
  wire [31:0] mac_cycles;
  wire [31:0] max_channels;
  output [31:0] mode;
  reg [31:0] mode = 32'd65795;
  input [31:0] output_stalls;
  wire [31:0] output_stalls;
  output [31:0] param_base;
  reg [31:0] param_base = 32'd0;
  output [31:0] param_words;
  reg [31:0] param_words = 32'd0;
  input \port$1214$0 ;
  wire \port$1214$0 ;
  input [2:0] \port$1220$0 ;
  wire [2:0] \port$1220$0 ;
  input \port$2$0 ;
  wire \port$2$0 ;
  output [31:0] requant_base;
  reg [31:0] requant_base = 32'd0;
  wire [31:0] row_words;
  input rst;
  wire rst;
  wire [31:0] status;
  output [31:0] weight_base;
  reg [31:0] weight_base = 32'd0;
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
  assign \$9  = ~ loading;
  assign \$10  = ~ loading;
  assign \$11  = ~ busy;
  assign \$12  = ~ busy;
  assign \$13  = \$signal$14 [0] ? \$signal$12 [3:0] : 4'h0;
  assign \$14  = axi__arvalid & axi__arready;
  always @(posedge clk)
    \$signal  <= \$15 ;
  always @(posedge clk)
    address_held <= \$16 ;
  always @(posedge clk)
    \$signal$12  <= \$17 ;
  always @(posedge clk)
    \$signal$14  <= \$18 ;
  always @(posedge clk)
    data_held <= \$19 ;
  always @(posedge clk)
    command <= \$20 ;
  always @(posedge clk)
    axi__bvalid <= \$21 ;
  always @(posedge clk)
    axi__bresp <= \$22 ;
  always @(posedge clk)
    height <= \$23 ;
  always @(posedge clk)
    width <= \$24 ;
  always @(posedge clk)
    c_in <= \$25 ;
  always @(posedge clk)
    c_out <= \$26 ;
  always @(posedge clk)
    mode <= \$27 ;
  always @(posedge clk)
    param_words <= \$28 ;
  always @(posedge clk)
    param_base <= \$29 ;
  always @(posedge clk)
    weight_base <= \$30 ;
  always @(posedge clk)
    requant_base <= \$31 ;
  always @(posedge clk)
    \$signal$32  <= \$32 ;
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
    \$15  = \$signal ;
    if (\$1 ) begin
      \$15  = axi__awaddr[6:2];
    end
    if (rst) begin
      \$15  = 5'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$16  = address_held;
    if (\$1 ) begin
      \$16  = 1'h1;
    end
    if (axi__bvalid) begin
      if (axi__bready) begin
        \$16  = 1'h0;
      end
    end
    if (rst) begin
      \$16  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$17  = \$signal$12 ;
    if (\$2 ) begin
      \$17  = axi__wdata;
    end
    if (rst) begin
      \$17  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$18  = \$signal$14 ;
    if (\$2 ) begin
      \$18  = axi__wstrb;
    end
    if (rst) begin
      \$18  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$19  = data_held;
    if (\$2 ) begin
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
    \$20  = 4'h0;
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
        5'h16:
            /* empty */;
        5'h17:
            /* empty */;
        5'h18:
            /* empty */;
        5'h02:
            \$20  = \$13 ;
      endcase
    end
    if (rst) begin
      \$20  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$21  = axi__bvalid;
    if (axi__bvalid) begin
      if (axi__bready) begin
        \$21  = 1'h0;
      end
    end else if (\$3 ) begin
      \$21  = 1'h1;
    end
    if (rst) begin
      \$21  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$22  = axi__bresp;
    if (axi__bvalid) begin
    end else if (\$3 ) begin
      \$22  = 2'h2;
      casez (\$signal )
        5'h05:
            if (\$4 ) begin
              \$22  = 2'h0;
            end
        5'h06:
            if (\$5 ) begin
              \$22  = 2'h0;
            end
        5'h07:
            if (\$6 ) begin
              \$22  = 2'h0;
            end
        5'h08:
            if (\$7 ) begin
              \$22  = 2'h0;
            end
        5'h09:
            if (\$8 ) begin
              \$22  = 2'h0;
            end
        5'h0a:
            if (\$9 ) begin
              \$22  = 2'h0;
            end
        5'h16:
            if (\$10 ) begin
              \$22  = 2'h0;
            end
        5'h17:
            if (\$11 ) begin
              \$22  = 2'h0;
            end
        5'h18:
            if (\$12 ) begin
              \$22  = 2'h0;
            end
        5'h02:
            \$22  = 2'h0;
      endcase
    end
    if (rst) begin
      \$22  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$23  = height;
    if (axi__bvalid) begin
    end else if (\$3 ) begin
      casez (\$signal )
        5'h05:
            if (\$4 ) begin
              if (\$signal$14 [0]) begin
                \$23 [7:0] = \$signal$12 [7:0];
              end
              if (\$signal$14 [1]) begin
                \$23 [15:8] = \$signal$12 [15:8];
              end
              if (\$signal$14 [2]) begin
                \$23 [23:16] = \$signal$12 [23:16];
              end
              if (\$signal$14 [3]) begin
                \$23 [31:24] = \$signal$12 [31:24];
              end
            end
      endcase
    end
    if (rst) begin
      \$23  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$24  = width;
    if (axi__bvalid) begin
    end else if (\$3 ) begin
      casez (\$signal )
        5'h05:
            /* empty */;
        5'h06:
            if (\$5 ) begin
              if (\$signal$14 [0]) begin
                \$24 [7:0] = \$signal$12 [7:0];
              end
              if (\$signal$14 [1]) begin
                \$24 [15:8] = \$signal$12 [15:8];
              end
              if (\$signal$14 [2]) begin
                \$24 [23:16] = \$signal$12 [23:16];
              end
              if (\$signal$14 [3]) begin
                \$24 [31:24] = \$signal$12 [31:24];
              end
            end
      endcase
    end
    if (rst) begin
      \$24  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$25  = c_in;
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
                \$25 [7:0] = \$signal$12 [7:0];
              end
              if (\$signal$14 [1]) begin
                \$25 [15:8] = \$signal$12 [15:8];
              end
              if (\$signal$14 [2]) begin
                \$25 [23:16] = \$signal$12 [23:16];
              end
              if (\$signal$14 [3]) begin
                \$25 [31:24] = \$signal$12 [31:24];
              end
            end
      endcase
    end
    if (rst) begin
      \$25  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$26  = c_out;
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
    \$27  = mode;
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
      \$27  = 32'd65795;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$28  = param_words;
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
    \$29  = param_base;
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
        5'h16:
            if (\$10 ) begin
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
    \$30  = weight_base;
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
        5'h16:
            /* empty */;
        5'h17:
            if (\$11 ) begin
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
      \$30  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$31  = requant_base;
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
        5'h16:
            /* empty */;
        5'h17:
            /* empty */;
        5'h18:
            if (\$12 ) begin
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
    \$32  = \$signal$32 ;
    if (\$14 ) begin
      \$32  = axi__araddr[6:2];
    end
    if (rst) begin
      \$32  = 5'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$33  = held;
    if (\$14 ) begin
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
      casez (\$signal$32 )
        5'h00:
            \$35  = 32'd1296122706;
        5'h01:
            \$35  = 32'd131072;
        5'h02:
            \$35  = 32'd0;
        5'h03:
            \$35  = { 28'h0000000, loading, \port$2$0 , \port$1214$0 , busy };
        5'h04:
            \$35  = { 29'h00000000, \port$1220$0  };
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
            \$35  = 32'd1024;
        5'h14:
            \$35  = 32'd512;
        5'h15:
            \$35  = 32'd67109888;
        5'h16:
            \$35  = param_base;
        5'h17:
            \$35  = weight_base;
        5'h18:
            \$35  = requant_base;
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
      casez (\$signal$32 )
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
        5'h16:
            /* empty */;
        5'h17:
            /* empty */;
        5'h18:
            /* empty */;
        default:
            \$36  = 2'h2;
      endcase
    end
    if (rst) begin
      \$36  = 2'h0;
    end
  end
  assign status = { 28'h0000000, loading, \port$2$0 , \port$1214$0 , busy };
  assign error = { 29'h00000000, \port$1220$0  };
  assign geometry = 32'd67633216;
  assign formats = 32'd197379;
  assign weight_depth = 32'd1024;
  assign row_words = 32'd512;
  assign max_channels = 32'd67109888;
endmodule
