
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
  wire [31:0] partial_c_in;
  wire [31:0] requant_base;
  wire [31:0] \requant_base$74 ;
  wire [31:0] residual;
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
    .\error$642 (error),
    .fill_cycles(fill_cycles),
    .height(height),
    .\i__payload$6 (params__payload),
    .\i__payload$62 (i__payload),
    .\i__ready$64 (s_axis_tready),
    .\i__valid$10 (s_axis_param_tvalid),
    .\i__valid$66 (s_axis_tvalid),
    .input_stalls(input_stalls),
    .mac_cycles(mac_cycles),
    .mode(mode),
    .\o__payload$12 (o__payload),
    .\o__ready$14 (m_axis_tready),
    .\o__valid$16 (m_axis_tvalid),
    .output_stalls(output_stalls),
    .params__ready(s_axis_param_tready),
    .\port$1314$0 (command),
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
    .\port$1368$0 (done),
    .\port$1374$0 (error),
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
  assign residual = 32'd0;
  assign partial_c_in = 32'd0;
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

module \macram_top.array (\i__valid$66 , \i__valid$10 , \o__ready$14 , rst, busy, \i__ready$64 , \o__valid$16 , \i__payload$62 , \i__payload$6 , \port$1314$0 , height, width, c_in, c_out, mode, words, base, weight_base, requant_base, done, \error$642 
, cycles, mac_cycles, fill_cycles, input_stalls, output_stalls, drain_cycles, \o__payload$12 , params__ready, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$1  = 0;
  wire \$1 ;
  wire \$10 ;
  wire \$11 ;
  wire \$12 ;
  wire [3:0] \$13 ;
  wire [3:0] \$14 ;
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
  wire \$27 ;
  wire \$28 ;
  wire \$29 ;
  wire \$3 ;
  wire \$30 ;
  wire [3:0] \$31 ;
  wire [3:0] \$32 ;
  wire \$33 ;
  wire \$34 ;
  wire [2:0] \$35 ;
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
  reg \$53 ;
  reg [1:0] \$54 ;
  reg \$55 ;
  reg \$56 ;
  reg \$57 ;
  reg [2:0] \$58 ;
  reg [9:0] \$59 ;
  wire [10:0] \$6 ;
  reg [9:0] \$60 ;
  reg [9:0] \$61 ;
  reg [9:0] \$62 ;
  reg \$63 ;
  reg \$64 ;
  reg \$65 ;
  reg [31:0] \$66 ;
  reg [31:0] \$67 ;
  reg [31:0] \$68 ;
  reg [31:0] \$69 ;
  wire [10:0] \$7 ;
  reg [31:0] \$70 ;
  reg [31:0] \$71 ;
  wire [9:0] \$72 ;
  wire [7:0] \$73 ;
  wire [671:0] \$74 ;
  wire \$8 ;
  wire [31:0] \$9 ;
  wire \$signal ;
  wire \$signal$48 ;
  wire \$signal$52 ;
  (* enum_base_type = "Error" *)
  (* enum_value_000 = "NONE" *)
  (* enum_value_001 = "BAD_SHAPE" *)
  (* enum_value_010 = "BAD_MODE" *)
  (* enum_value_011 = "TLAST_EARLY" *)
  (* enum_value_100 = "TLAST_MISSING" *)
  (* enum_value_101 = "BAD_COMMAND" *)
  (* enum_value_110 = "BAD_RANGE" *)
  reg [2:0] \$signal$54 ;
  wire \$signal$634 ;
  reg \$signal$635  = 1'h0;
  reg \$signal$653  = 1'h0;
  wire [95:0] activations;
  wire [95:0] \activations$133 ;
  wire [95:0] \activations$142 ;
  wire [95:0] \activations$151 ;
  wire [95:0] \activations$160 ;
  wire [95:0] \activations$168 ;
  wire [95:0] \activations$176 ;
  wire [95:0] \activations$184 ;
  wire [95:0] \activations$192 ;
  wire [95:0] \activations$200 ;
  wire [95:0] \activations$208 ;
  wire [95:0] \activations$216 ;
  wire [95:0] \activations$224 ;
  wire [95:0] \activations$232 ;
  wire [95:0] \activations$240 ;
  wire [95:0] \activations$248 ;
  wire [95:0] \activations$256 ;
  wire [95:0] \activations$264 ;
  wire [95:0] \activations$272 ;
  wire [95:0] \activations$280 ;
  wire [95:0] \activations$288 ;
  wire [95:0] \activations$296 ;
  wire [95:0] \activations$304 ;
  wire [95:0] \activations$312 ;
  wire [95:0] \activations$320 ;
  wire [95:0] \activations$328 ;
  wire [95:0] \activations$336 ;
  wire [95:0] \activations$344 ;
  wire [95:0] \activations$352 ;
  wire [95:0] \activations$360 ;
  wire [95:0] \activations$368 ;
  wire [95:0] \activations$376 ;
  wire [95:0] \activations$384 ;
  wire [95:0] \activations$392 ;
  wire [95:0] \activations$400 ;
  wire [95:0] \activations$408 ;
  wire [95:0] \activations$416 ;
  wire [95:0] \activations$424 ;
  wire [95:0] \activations$432 ;
  wire [95:0] \activations$440 ;
  wire [95:0] \activations$448 ;
  wire [95:0] \activations$456 ;
  wire [95:0] \activations$464 ;
  wire [95:0] \activations$472 ;
  wire [95:0] \activations$480 ;
  wire [95:0] \activations$488 ;
  wire [95:0] \activations$496 ;
  wire [95:0] \activations$504 ;
  wire [95:0] \activations$512 ;
  wire [95:0] \activations$520 ;
  wire [95:0] \activations$528 ;
  wire [95:0] \activations$536 ;
  wire [95:0] \activations$544 ;
  wire [95:0] \activations$552 ;
  wire [95:0] \activations$560 ;
  wire [95:0] \activations$568 ;
  wire [95:0] \activations$576 ;
  wire [95:0] \activations$584 ;
  wire [95:0] \activations$592 ;
  wire [95:0] \activations$600 ;
  wire [95:0] \activations$608 ;
  wire [95:0] \activations$615 ;
  wire [95:0] \activations$622 ;
  wire [95:0] \activations$629 ;
  wire [9:0] address;
  wire [9:0] \address$130 ;
  wire [9:0] \address$139 ;
  wire [9:0] \address$148 ;
  wire [9:0] \address$157 ;
  wire [9:0] \address$165 ;
  wire [9:0] \address$173 ;
  wire [9:0] \address$181 ;
  wire [9:0] \address$189 ;
  wire [9:0] \address$197 ;
  wire [9:0] \address$205 ;
  wire [9:0] \address$213 ;
  wire [9:0] \address$221 ;
  wire [9:0] \address$229 ;
  wire [9:0] \address$237 ;
  wire [9:0] \address$245 ;
  wire [9:0] \address$253 ;
  wire [9:0] \address$261 ;
  wire [9:0] \address$269 ;
  wire [9:0] \address$277 ;
  wire [9:0] \address$285 ;
  wire [9:0] \address$293 ;
  wire [9:0] \address$301 ;
  wire [9:0] \address$309 ;
  wire [9:0] \address$317 ;
  wire [9:0] \address$325 ;
  wire [9:0] \address$333 ;
  wire [9:0] \address$341 ;
  wire [9:0] \address$349 ;
  wire [9:0] \address$357 ;
  wire [9:0] \address$365 ;
  wire [9:0] \address$373 ;
  wire [9:0] \address$381 ;
  wire [9:0] \address$389 ;
  wire [9:0] \address$397 ;
  wire [9:0] \address$405 ;
  wire [9:0] \address$413 ;
  wire [9:0] \address$421 ;
  wire [9:0] \address$429 ;
  wire [9:0] \address$437 ;
  wire [9:0] \address$445 ;
  wire [9:0] \address$453 ;
  wire [9:0] \address$461 ;
  wire [9:0] \address$469 ;
  wire [9:0] \address$477 ;
  wire [9:0] \address$485 ;
  wire [9:0] \address$493 ;
  wire [9:0] \address$501 ;
  wire [9:0] \address$509 ;
  wire [9:0] \address$517 ;
  wire [9:0] \address$525 ;
  wire [9:0] \address$533 ;
  wire [9:0] \address$541 ;
  wire [9:0] \address$549 ;
  wire [9:0] \address$557 ;
  wire [9:0] \address$565 ;
  wire [9:0] \address$573 ;
  wire [9:0] \address$581 ;
  wire [9:0] \address$589 ;
  wire [9:0] \address$597 ;
  wire [9:0] \address$605 ;
  wire [9:0] \address$612 ;
  wire [9:0] \address$619 ;
  wire [9:0] \address$626 ;
  input [31:0] base;
  wire [31:0] base;
  wire [15:0] beats;
  wire [15:0] beats_per_pixel;
  wire [15:0] \beats_per_pixel$92 ;
  wire blocked;
  output busy;
  wire busy;
  wire \busy$43 ;
  input [31:0] c_in;
  wire [31:0] c_in;
  wire [31:0] \c_in$26 ;
  input [31:0] c_out;
  wire [31:0] c_out;
  wire [31:0] \c_out$28 ;
  wire [75:0] chain_i;
  wire [75:0] \chain_i$137 ;
  wire [18:0] \chain_i$137[0] ;
  wire [18:0] \chain_i$137[1] ;
  wire [18:0] \chain_i$137[2] ;
  wire [18:0] \chain_i$137[3] ;
  wire [75:0] \chain_i$146 ;
  wire [18:0] \chain_i$146[0] ;
  wire [18:0] \chain_i$146[1] ;
  wire [18:0] \chain_i$146[2] ;
  wire [18:0] \chain_i$146[3] ;
  wire [75:0] \chain_i$155 ;
  wire [18:0] \chain_i$155[0] ;
  wire [18:0] \chain_i$155[1] ;
  wire [18:0] \chain_i$155[2] ;
  wire [18:0] \chain_i$155[3] ;
  wire [75:0] \chain_i$163 ;
  wire [18:0] \chain_i$163[0] ;
  wire [18:0] \chain_i$163[1] ;
  wire [18:0] \chain_i$163[2] ;
  wire [18:0] \chain_i$163[3] ;
  wire [75:0] \chain_i$171 ;
  wire [18:0] \chain_i$171[0] ;
  wire [18:0] \chain_i$171[1] ;
  wire [18:0] \chain_i$171[2] ;
  wire [18:0] \chain_i$171[3] ;
  wire [75:0] \chain_i$179 ;
  wire [18:0] \chain_i$179[0] ;
  wire [18:0] \chain_i$179[1] ;
  wire [18:0] \chain_i$179[2] ;
  wire [18:0] \chain_i$179[3] ;
  wire [75:0] \chain_i$187 ;
  wire [18:0] \chain_i$187[0] ;
  wire [18:0] \chain_i$187[1] ;
  wire [18:0] \chain_i$187[2] ;
  wire [18:0] \chain_i$187[3] ;
  wire [75:0] \chain_i$195 ;
  wire [18:0] \chain_i$195[0] ;
  wire [18:0] \chain_i$195[1] ;
  wire [18:0] \chain_i$195[2] ;
  wire [18:0] \chain_i$195[3] ;
  wire [75:0] \chain_i$203 ;
  wire [18:0] \chain_i$203[0] ;
  wire [18:0] \chain_i$203[1] ;
  wire [18:0] \chain_i$203[2] ;
  wire [18:0] \chain_i$203[3] ;
  wire [75:0] \chain_i$211 ;
  wire [18:0] \chain_i$211[0] ;
  wire [18:0] \chain_i$211[1] ;
  wire [18:0] \chain_i$211[2] ;
  wire [18:0] \chain_i$211[3] ;
  wire [75:0] \chain_i$219 ;
  wire [18:0] \chain_i$219[0] ;
  wire [18:0] \chain_i$219[1] ;
  wire [18:0] \chain_i$219[2] ;
  wire [18:0] \chain_i$219[3] ;
  wire [75:0] \chain_i$227 ;
  wire [18:0] \chain_i$227[0] ;
  wire [18:0] \chain_i$227[1] ;
  wire [18:0] \chain_i$227[2] ;
  wire [18:0] \chain_i$227[3] ;
  wire [75:0] \chain_i$235 ;
  wire [18:0] \chain_i$235[0] ;
  wire [18:0] \chain_i$235[1] ;
  wire [18:0] \chain_i$235[2] ;
  wire [18:0] \chain_i$235[3] ;
  wire [75:0] \chain_i$243 ;
  wire [18:0] \chain_i$243[0] ;
  wire [18:0] \chain_i$243[1] ;
  wire [18:0] \chain_i$243[2] ;
  wire [18:0] \chain_i$243[3] ;
  wire [75:0] \chain_i$251 ;
  wire [18:0] \chain_i$251[0] ;
  wire [18:0] \chain_i$251[1] ;
  wire [18:0] \chain_i$251[2] ;
  wire [18:0] \chain_i$251[3] ;
  wire [75:0] \chain_i$259 ;
  wire [18:0] \chain_i$259[0] ;
  wire [18:0] \chain_i$259[1] ;
  wire [18:0] \chain_i$259[2] ;
  wire [18:0] \chain_i$259[3] ;
  wire [75:0] \chain_i$267 ;
  wire [18:0] \chain_i$267[0] ;
  wire [18:0] \chain_i$267[1] ;
  wire [18:0] \chain_i$267[2] ;
  wire [18:0] \chain_i$267[3] ;
  wire [75:0] \chain_i$275 ;
  wire [18:0] \chain_i$275[0] ;
  wire [18:0] \chain_i$275[1] ;
  wire [18:0] \chain_i$275[2] ;
  wire [18:0] \chain_i$275[3] ;
  wire [75:0] \chain_i$283 ;
  wire [18:0] \chain_i$283[0] ;
  wire [18:0] \chain_i$283[1] ;
  wire [18:0] \chain_i$283[2] ;
  wire [18:0] \chain_i$283[3] ;
  wire [75:0] \chain_i$291 ;
  wire [18:0] \chain_i$291[0] ;
  wire [18:0] \chain_i$291[1] ;
  wire [18:0] \chain_i$291[2] ;
  wire [18:0] \chain_i$291[3] ;
  wire [75:0] \chain_i$299 ;
  wire [18:0] \chain_i$299[0] ;
  wire [18:0] \chain_i$299[1] ;
  wire [18:0] \chain_i$299[2] ;
  wire [18:0] \chain_i$299[3] ;
  wire [75:0] \chain_i$307 ;
  wire [18:0] \chain_i$307[0] ;
  wire [18:0] \chain_i$307[1] ;
  wire [18:0] \chain_i$307[2] ;
  wire [18:0] \chain_i$307[3] ;
  wire [75:0] \chain_i$315 ;
  wire [18:0] \chain_i$315[0] ;
  wire [18:0] \chain_i$315[1] ;
  wire [18:0] \chain_i$315[2] ;
  wire [18:0] \chain_i$315[3] ;
  wire [75:0] \chain_i$323 ;
  wire [18:0] \chain_i$323[0] ;
  wire [18:0] \chain_i$323[1] ;
  wire [18:0] \chain_i$323[2] ;
  wire [18:0] \chain_i$323[3] ;
  wire [75:0] \chain_i$331 ;
  wire [18:0] \chain_i$331[0] ;
  wire [18:0] \chain_i$331[1] ;
  wire [18:0] \chain_i$331[2] ;
  wire [18:0] \chain_i$331[3] ;
  wire [75:0] \chain_i$339 ;
  wire [18:0] \chain_i$339[0] ;
  wire [18:0] \chain_i$339[1] ;
  wire [18:0] \chain_i$339[2] ;
  wire [18:0] \chain_i$339[3] ;
  wire [75:0] \chain_i$347 ;
  wire [18:0] \chain_i$347[0] ;
  wire [18:0] \chain_i$347[1] ;
  wire [18:0] \chain_i$347[2] ;
  wire [18:0] \chain_i$347[3] ;
  wire [75:0] \chain_i$355 ;
  wire [18:0] \chain_i$355[0] ;
  wire [18:0] \chain_i$355[1] ;
  wire [18:0] \chain_i$355[2] ;
  wire [18:0] \chain_i$355[3] ;
  wire [75:0] \chain_i$363 ;
  wire [18:0] \chain_i$363[0] ;
  wire [18:0] \chain_i$363[1] ;
  wire [18:0] \chain_i$363[2] ;
  wire [18:0] \chain_i$363[3] ;
  wire [75:0] \chain_i$371 ;
  wire [18:0] \chain_i$371[0] ;
  wire [18:0] \chain_i$371[1] ;
  wire [18:0] \chain_i$371[2] ;
  wire [18:0] \chain_i$371[3] ;
  wire [75:0] \chain_i$379 ;
  wire [18:0] \chain_i$379[0] ;
  wire [18:0] \chain_i$379[1] ;
  wire [18:0] \chain_i$379[2] ;
  wire [18:0] \chain_i$379[3] ;
  wire [75:0] \chain_i$387 ;
  wire [18:0] \chain_i$387[0] ;
  wire [18:0] \chain_i$387[1] ;
  wire [18:0] \chain_i$387[2] ;
  wire [18:0] \chain_i$387[3] ;
  wire [75:0] \chain_i$395 ;
  wire [18:0] \chain_i$395[0] ;
  wire [18:0] \chain_i$395[1] ;
  wire [18:0] \chain_i$395[2] ;
  wire [18:0] \chain_i$395[3] ;
  wire [75:0] \chain_i$403 ;
  wire [18:0] \chain_i$403[0] ;
  wire [18:0] \chain_i$403[1] ;
  wire [18:0] \chain_i$403[2] ;
  wire [18:0] \chain_i$403[3] ;
  wire [75:0] \chain_i$411 ;
  wire [18:0] \chain_i$411[0] ;
  wire [18:0] \chain_i$411[1] ;
  wire [18:0] \chain_i$411[2] ;
  wire [18:0] \chain_i$411[3] ;
  wire [75:0] \chain_i$419 ;
  wire [18:0] \chain_i$419[0] ;
  wire [18:0] \chain_i$419[1] ;
  wire [18:0] \chain_i$419[2] ;
  wire [18:0] \chain_i$419[3] ;
  wire [75:0] \chain_i$427 ;
  wire [18:0] \chain_i$427[0] ;
  wire [18:0] \chain_i$427[1] ;
  wire [18:0] \chain_i$427[2] ;
  wire [18:0] \chain_i$427[3] ;
  wire [75:0] \chain_i$435 ;
  wire [18:0] \chain_i$435[0] ;
  wire [18:0] \chain_i$435[1] ;
  wire [18:0] \chain_i$435[2] ;
  wire [18:0] \chain_i$435[3] ;
  wire [75:0] \chain_i$443 ;
  wire [18:0] \chain_i$443[0] ;
  wire [18:0] \chain_i$443[1] ;
  wire [18:0] \chain_i$443[2] ;
  wire [18:0] \chain_i$443[3] ;
  wire [75:0] \chain_i$451 ;
  wire [18:0] \chain_i$451[0] ;
  wire [18:0] \chain_i$451[1] ;
  wire [18:0] \chain_i$451[2] ;
  wire [18:0] \chain_i$451[3] ;
  wire [75:0] \chain_i$459 ;
  wire [18:0] \chain_i$459[0] ;
  wire [18:0] \chain_i$459[1] ;
  wire [18:0] \chain_i$459[2] ;
  wire [18:0] \chain_i$459[3] ;
  wire [75:0] \chain_i$467 ;
  wire [18:0] \chain_i$467[0] ;
  wire [18:0] \chain_i$467[1] ;
  wire [18:0] \chain_i$467[2] ;
  wire [18:0] \chain_i$467[3] ;
  wire [75:0] \chain_i$475 ;
  wire [18:0] \chain_i$475[0] ;
  wire [18:0] \chain_i$475[1] ;
  wire [18:0] \chain_i$475[2] ;
  wire [18:0] \chain_i$475[3] ;
  wire [75:0] \chain_i$483 ;
  wire [18:0] \chain_i$483[0] ;
  wire [18:0] \chain_i$483[1] ;
  wire [18:0] \chain_i$483[2] ;
  wire [18:0] \chain_i$483[3] ;
  wire [75:0] \chain_i$491 ;
  wire [18:0] \chain_i$491[0] ;
  wire [18:0] \chain_i$491[1] ;
  wire [18:0] \chain_i$491[2] ;
  wire [18:0] \chain_i$491[3] ;
  wire [75:0] \chain_i$499 ;
  wire [18:0] \chain_i$499[0] ;
  wire [18:0] \chain_i$499[1] ;
  wire [18:0] \chain_i$499[2] ;
  wire [18:0] \chain_i$499[3] ;
  wire [75:0] \chain_i$507 ;
  wire [18:0] \chain_i$507[0] ;
  wire [18:0] \chain_i$507[1] ;
  wire [18:0] \chain_i$507[2] ;
  wire [18:0] \chain_i$507[3] ;
  wire [75:0] \chain_i$515 ;
  wire [18:0] \chain_i$515[0] ;
  wire [18:0] \chain_i$515[1] ;
  wire [18:0] \chain_i$515[2] ;
  wire [18:0] \chain_i$515[3] ;
  wire [75:0] \chain_i$523 ;
  wire [18:0] \chain_i$523[0] ;
  wire [18:0] \chain_i$523[1] ;
  wire [18:0] \chain_i$523[2] ;
  wire [18:0] \chain_i$523[3] ;
  wire [75:0] \chain_i$531 ;
  wire [18:0] \chain_i$531[0] ;
  wire [18:0] \chain_i$531[1] ;
  wire [18:0] \chain_i$531[2] ;
  wire [18:0] \chain_i$531[3] ;
  wire [75:0] \chain_i$539 ;
  wire [18:0] \chain_i$539[0] ;
  wire [18:0] \chain_i$539[1] ;
  wire [18:0] \chain_i$539[2] ;
  wire [18:0] \chain_i$539[3] ;
  wire [75:0] \chain_i$547 ;
  wire [18:0] \chain_i$547[0] ;
  wire [18:0] \chain_i$547[1] ;
  wire [18:0] \chain_i$547[2] ;
  wire [18:0] \chain_i$547[3] ;
  wire [75:0] \chain_i$555 ;
  wire [18:0] \chain_i$555[0] ;
  wire [18:0] \chain_i$555[1] ;
  wire [18:0] \chain_i$555[2] ;
  wire [18:0] \chain_i$555[3] ;
  wire [75:0] \chain_i$563 ;
  wire [18:0] \chain_i$563[0] ;
  wire [18:0] \chain_i$563[1] ;
  wire [18:0] \chain_i$563[2] ;
  wire [18:0] \chain_i$563[3] ;
  wire [75:0] \chain_i$571 ;
  wire [18:0] \chain_i$571[0] ;
  wire [18:0] \chain_i$571[1] ;
  wire [18:0] \chain_i$571[2] ;
  wire [18:0] \chain_i$571[3] ;
  wire [75:0] \chain_i$579 ;
  wire [18:0] \chain_i$579[0] ;
  wire [18:0] \chain_i$579[1] ;
  wire [18:0] \chain_i$579[2] ;
  wire [18:0] \chain_i$579[3] ;
  wire [75:0] \chain_i$587 ;
  wire [18:0] \chain_i$587[0] ;
  wire [18:0] \chain_i$587[1] ;
  wire [18:0] \chain_i$587[2] ;
  wire [18:0] \chain_i$587[3] ;
  wire [75:0] \chain_i$595 ;
  wire [18:0] \chain_i$595[0] ;
  wire [18:0] \chain_i$595[1] ;
  wire [18:0] \chain_i$595[2] ;
  wire [18:0] \chain_i$595[3] ;
  wire [75:0] \chain_i$603 ;
  wire [18:0] \chain_i$603[0] ;
  wire [18:0] \chain_i$603[1] ;
  wire [18:0] \chain_i$603[2] ;
  wire [18:0] \chain_i$603[3] ;
  wire [75:0] \chain_i$611 ;
  wire [18:0] \chain_i$611[0] ;
  wire [18:0] \chain_i$611[1] ;
  wire [18:0] \chain_i$611[2] ;
  wire [18:0] \chain_i$611[3] ;
  wire [75:0] \chain_i$618 ;
  wire [18:0] \chain_i$618[0] ;
  wire [18:0] \chain_i$618[1] ;
  wire [18:0] \chain_i$618[2] ;
  wire [18:0] \chain_i$618[3] ;
  wire [75:0] \chain_i$625 ;
  wire [18:0] \chain_i$625[0] ;
  wire [18:0] \chain_i$625[1] ;
  wire [18:0] \chain_i$625[2] ;
  wire [18:0] \chain_i$625[3] ;
  wire [75:0] \chain_i$632 ;
  wire [18:0] \chain_i$632[0] ;
  wire [18:0] \chain_i$632[1] ;
  wire [18:0] \chain_i$632[2] ;
  wire [18:0] \chain_i$632[3] ;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  wire [75:0] chain_o;
  wire [75:0] \chain_o$129 ;
  wire [18:0] \chain_o$129[0] ;
  wire [18:0] \chain_o$129[1] ;
  wire [18:0] \chain_o$129[2] ;
  wire [18:0] \chain_o$129[3] ;
  wire [75:0] \chain_o$136 ;
  wire [18:0] \chain_o$136[0] ;
  wire [18:0] \chain_o$136[1] ;
  wire [18:0] \chain_o$136[2] ;
  wire [18:0] \chain_o$136[3] ;
  wire [75:0] \chain_o$138 ;
  wire [18:0] \chain_o$138[0] ;
  wire [18:0] \chain_o$138[1] ;
  wire [18:0] \chain_o$138[2] ;
  wire [18:0] \chain_o$138[3] ;
  wire [75:0] \chain_o$145 ;
  wire [18:0] \chain_o$145[0] ;
  wire [18:0] \chain_o$145[1] ;
  wire [18:0] \chain_o$145[2] ;
  wire [18:0] \chain_o$145[3] ;
  wire [75:0] \chain_o$147 ;
  wire [18:0] \chain_o$147[0] ;
  wire [18:0] \chain_o$147[1] ;
  wire [18:0] \chain_o$147[2] ;
  wire [18:0] \chain_o$147[3] ;
  wire [75:0] \chain_o$154 ;
  wire [18:0] \chain_o$154[0] ;
  wire [18:0] \chain_o$154[1] ;
  wire [18:0] \chain_o$154[2] ;
  wire [18:0] \chain_o$154[3] ;
  wire [75:0] \chain_o$156 ;
  wire [18:0] \chain_o$156[0] ;
  wire [18:0] \chain_o$156[1] ;
  wire [18:0] \chain_o$156[2] ;
  wire [18:0] \chain_o$156[3] ;
  wire [75:0] \chain_o$164 ;
  wire [18:0] \chain_o$164[0] ;
  wire [18:0] \chain_o$164[1] ;
  wire [18:0] \chain_o$164[2] ;
  wire [18:0] \chain_o$164[3] ;
  wire [75:0] \chain_o$172 ;
  wire [18:0] \chain_o$172[0] ;
  wire [18:0] \chain_o$172[1] ;
  wire [18:0] \chain_o$172[2] ;
  wire [18:0] \chain_o$172[3] ;
  wire [75:0] \chain_o$180 ;
  wire [18:0] \chain_o$180[0] ;
  wire [18:0] \chain_o$180[1] ;
  wire [18:0] \chain_o$180[2] ;
  wire [18:0] \chain_o$180[3] ;
  wire [75:0] \chain_o$188 ;
  wire [18:0] \chain_o$188[0] ;
  wire [18:0] \chain_o$188[1] ;
  wire [18:0] \chain_o$188[2] ;
  wire [18:0] \chain_o$188[3] ;
  wire [75:0] \chain_o$196 ;
  wire [18:0] \chain_o$196[0] ;
  wire [18:0] \chain_o$196[1] ;
  wire [18:0] \chain_o$196[2] ;
  wire [18:0] \chain_o$196[3] ;
  wire [75:0] \chain_o$204 ;
  wire [18:0] \chain_o$204[0] ;
  wire [18:0] \chain_o$204[1] ;
  wire [18:0] \chain_o$204[2] ;
  wire [18:0] \chain_o$204[3] ;
  wire [75:0] \chain_o$212 ;
  wire [18:0] \chain_o$212[0] ;
  wire [18:0] \chain_o$212[1] ;
  wire [18:0] \chain_o$212[2] ;
  wire [18:0] \chain_o$212[3] ;
  wire [75:0] \chain_o$220 ;
  wire [18:0] \chain_o$220[0] ;
  wire [18:0] \chain_o$220[1] ;
  wire [18:0] \chain_o$220[2] ;
  wire [18:0] \chain_o$220[3] ;
  wire [75:0] \chain_o$228 ;
  wire [18:0] \chain_o$228[0] ;
  wire [18:0] \chain_o$228[1] ;
  wire [18:0] \chain_o$228[2] ;
  wire [18:0] \chain_o$228[3] ;
  wire [75:0] \chain_o$236 ;
  wire [18:0] \chain_o$236[0] ;
  wire [18:0] \chain_o$236[1] ;
  wire [18:0] \chain_o$236[2] ;
  wire [18:0] \chain_o$236[3] ;
  wire [75:0] \chain_o$244 ;
  wire [18:0] \chain_o$244[0] ;
  wire [18:0] \chain_o$244[1] ;
  wire [18:0] \chain_o$244[2] ;
  wire [18:0] \chain_o$244[3] ;
  wire [75:0] \chain_o$252 ;
  wire [18:0] \chain_o$252[0] ;
  wire [18:0] \chain_o$252[1] ;
  wire [18:0] \chain_o$252[2] ;
  wire [18:0] \chain_o$252[3] ;
  wire [75:0] \chain_o$260 ;
  wire [18:0] \chain_o$260[0] ;
  wire [18:0] \chain_o$260[1] ;
  wire [18:0] \chain_o$260[2] ;
  wire [18:0] \chain_o$260[3] ;
  wire [75:0] \chain_o$268 ;
  wire [18:0] \chain_o$268[0] ;
  wire [18:0] \chain_o$268[1] ;
  wire [18:0] \chain_o$268[2] ;
  wire [18:0] \chain_o$268[3] ;
  wire [75:0] \chain_o$276 ;
  wire [18:0] \chain_o$276[0] ;
  wire [18:0] \chain_o$276[1] ;
  wire [18:0] \chain_o$276[2] ;
  wire [18:0] \chain_o$276[3] ;
  wire [75:0] \chain_o$284 ;
  wire [18:0] \chain_o$284[0] ;
  wire [18:0] \chain_o$284[1] ;
  wire [18:0] \chain_o$284[2] ;
  wire [18:0] \chain_o$284[3] ;
  wire [75:0] \chain_o$292 ;
  wire [18:0] \chain_o$292[0] ;
  wire [18:0] \chain_o$292[1] ;
  wire [18:0] \chain_o$292[2] ;
  wire [18:0] \chain_o$292[3] ;
  wire [75:0] \chain_o$300 ;
  wire [18:0] \chain_o$300[0] ;
  wire [18:0] \chain_o$300[1] ;
  wire [18:0] \chain_o$300[2] ;
  wire [18:0] \chain_o$300[3] ;
  wire [75:0] \chain_o$308 ;
  wire [18:0] \chain_o$308[0] ;
  wire [18:0] \chain_o$308[1] ;
  wire [18:0] \chain_o$308[2] ;
  wire [18:0] \chain_o$308[3] ;
  wire [75:0] \chain_o$316 ;
  wire [18:0] \chain_o$316[0] ;
  wire [18:0] \chain_o$316[1] ;
  wire [18:0] \chain_o$316[2] ;
  wire [18:0] \chain_o$316[3] ;
  wire [75:0] \chain_o$324 ;
  wire [18:0] \chain_o$324[0] ;
  wire [18:0] \chain_o$324[1] ;
  wire [18:0] \chain_o$324[2] ;
  wire [18:0] \chain_o$324[3] ;
  wire [75:0] \chain_o$332 ;
  wire [18:0] \chain_o$332[0] ;
  wire [18:0] \chain_o$332[1] ;
  wire [18:0] \chain_o$332[2] ;
  wire [18:0] \chain_o$332[3] ;
  wire [75:0] \chain_o$340 ;
  wire [18:0] \chain_o$340[0] ;
  wire [18:0] \chain_o$340[1] ;
  wire [18:0] \chain_o$340[2] ;
  wire [18:0] \chain_o$340[3] ;
  wire [75:0] \chain_o$348 ;
  wire [18:0] \chain_o$348[0] ;
  wire [18:0] \chain_o$348[1] ;
  wire [18:0] \chain_o$348[2] ;
  wire [18:0] \chain_o$348[3] ;
  wire [75:0] \chain_o$356 ;
  wire [18:0] \chain_o$356[0] ;
  wire [18:0] \chain_o$356[1] ;
  wire [18:0] \chain_o$356[2] ;
  wire [18:0] \chain_o$356[3] ;
  wire [75:0] \chain_o$364 ;
  wire [18:0] \chain_o$364[0] ;
  wire [18:0] \chain_o$364[1] ;
  wire [18:0] \chain_o$364[2] ;
  wire [18:0] \chain_o$364[3] ;
  wire [75:0] \chain_o$372 ;
  wire [18:0] \chain_o$372[0] ;
  wire [18:0] \chain_o$372[1] ;
  wire [18:0] \chain_o$372[2] ;
  wire [18:0] \chain_o$372[3] ;
  wire [75:0] \chain_o$380 ;
  wire [18:0] \chain_o$380[0] ;
  wire [18:0] \chain_o$380[1] ;
  wire [18:0] \chain_o$380[2] ;
  wire [18:0] \chain_o$380[3] ;
  wire [75:0] \chain_o$388 ;
  wire [18:0] \chain_o$388[0] ;
  wire [18:0] \chain_o$388[1] ;
  wire [18:0] \chain_o$388[2] ;
  wire [18:0] \chain_o$388[3] ;
  wire [75:0] \chain_o$396 ;
  wire [18:0] \chain_o$396[0] ;
  wire [18:0] \chain_o$396[1] ;
  wire [18:0] \chain_o$396[2] ;
  wire [18:0] \chain_o$396[3] ;
  wire [75:0] \chain_o$404 ;
  wire [18:0] \chain_o$404[0] ;
  wire [18:0] \chain_o$404[1] ;
  wire [18:0] \chain_o$404[2] ;
  wire [18:0] \chain_o$404[3] ;
  wire [75:0] \chain_o$412 ;
  wire [18:0] \chain_o$412[0] ;
  wire [18:0] \chain_o$412[1] ;
  wire [18:0] \chain_o$412[2] ;
  wire [18:0] \chain_o$412[3] ;
  wire [75:0] \chain_o$420 ;
  wire [18:0] \chain_o$420[0] ;
  wire [18:0] \chain_o$420[1] ;
  wire [18:0] \chain_o$420[2] ;
  wire [18:0] \chain_o$420[3] ;
  wire [75:0] \chain_o$428 ;
  wire [18:0] \chain_o$428[0] ;
  wire [18:0] \chain_o$428[1] ;
  wire [18:0] \chain_o$428[2] ;
  wire [18:0] \chain_o$428[3] ;
  wire [75:0] \chain_o$436 ;
  wire [18:0] \chain_o$436[0] ;
  wire [18:0] \chain_o$436[1] ;
  wire [18:0] \chain_o$436[2] ;
  wire [18:0] \chain_o$436[3] ;
  wire [75:0] \chain_o$444 ;
  wire [18:0] \chain_o$444[0] ;
  wire [18:0] \chain_o$444[1] ;
  wire [18:0] \chain_o$444[2] ;
  wire [18:0] \chain_o$444[3] ;
  wire [75:0] \chain_o$452 ;
  wire [18:0] \chain_o$452[0] ;
  wire [18:0] \chain_o$452[1] ;
  wire [18:0] \chain_o$452[2] ;
  wire [18:0] \chain_o$452[3] ;
  wire [75:0] \chain_o$460 ;
  wire [18:0] \chain_o$460[0] ;
  wire [18:0] \chain_o$460[1] ;
  wire [18:0] \chain_o$460[2] ;
  wire [18:0] \chain_o$460[3] ;
  wire [75:0] \chain_o$468 ;
  wire [18:0] \chain_o$468[0] ;
  wire [18:0] \chain_o$468[1] ;
  wire [18:0] \chain_o$468[2] ;
  wire [18:0] \chain_o$468[3] ;
  wire [75:0] \chain_o$476 ;
  wire [18:0] \chain_o$476[0] ;
  wire [18:0] \chain_o$476[1] ;
  wire [18:0] \chain_o$476[2] ;
  wire [18:0] \chain_o$476[3] ;
  wire [75:0] \chain_o$484 ;
  wire [18:0] \chain_o$484[0] ;
  wire [18:0] \chain_o$484[1] ;
  wire [18:0] \chain_o$484[2] ;
  wire [18:0] \chain_o$484[3] ;
  wire [75:0] \chain_o$492 ;
  wire [18:0] \chain_o$492[0] ;
  wire [18:0] \chain_o$492[1] ;
  wire [18:0] \chain_o$492[2] ;
  wire [18:0] \chain_o$492[3] ;
  wire [75:0] \chain_o$500 ;
  wire [18:0] \chain_o$500[0] ;
  wire [18:0] \chain_o$500[1] ;
  wire [18:0] \chain_o$500[2] ;
  wire [18:0] \chain_o$500[3] ;
  wire [75:0] \chain_o$508 ;
  wire [18:0] \chain_o$508[0] ;
  wire [18:0] \chain_o$508[1] ;
  wire [18:0] \chain_o$508[2] ;
  wire [18:0] \chain_o$508[3] ;
  wire [75:0] \chain_o$516 ;
  wire [18:0] \chain_o$516[0] ;
  wire [18:0] \chain_o$516[1] ;
  wire [18:0] \chain_o$516[2] ;
  wire [18:0] \chain_o$516[3] ;
  wire [75:0] \chain_o$524 ;
  wire [18:0] \chain_o$524[0] ;
  wire [18:0] \chain_o$524[1] ;
  wire [18:0] \chain_o$524[2] ;
  wire [18:0] \chain_o$524[3] ;
  wire [75:0] \chain_o$532 ;
  wire [18:0] \chain_o$532[0] ;
  wire [18:0] \chain_o$532[1] ;
  wire [18:0] \chain_o$532[2] ;
  wire [18:0] \chain_o$532[3] ;
  wire [75:0] \chain_o$540 ;
  wire [18:0] \chain_o$540[0] ;
  wire [18:0] \chain_o$540[1] ;
  wire [18:0] \chain_o$540[2] ;
  wire [18:0] \chain_o$540[3] ;
  wire [75:0] \chain_o$548 ;
  wire [18:0] \chain_o$548[0] ;
  wire [18:0] \chain_o$548[1] ;
  wire [18:0] \chain_o$548[2] ;
  wire [18:0] \chain_o$548[3] ;
  wire [75:0] \chain_o$556 ;
  wire [18:0] \chain_o$556[0] ;
  wire [18:0] \chain_o$556[1] ;
  wire [18:0] \chain_o$556[2] ;
  wire [18:0] \chain_o$556[3] ;
  wire [75:0] \chain_o$564 ;
  wire [18:0] \chain_o$564[0] ;
  wire [18:0] \chain_o$564[1] ;
  wire [18:0] \chain_o$564[2] ;
  wire [18:0] \chain_o$564[3] ;
  wire [75:0] \chain_o$572 ;
  wire [18:0] \chain_o$572[0] ;
  wire [18:0] \chain_o$572[1] ;
  wire [18:0] \chain_o$572[2] ;
  wire [18:0] \chain_o$572[3] ;
  wire [75:0] \chain_o$580 ;
  wire [18:0] \chain_o$580[0] ;
  wire [18:0] \chain_o$580[1] ;
  wire [18:0] \chain_o$580[2] ;
  wire [18:0] \chain_o$580[3] ;
  wire [75:0] \chain_o$588 ;
  wire [18:0] \chain_o$588[0] ;
  wire [18:0] \chain_o$588[1] ;
  wire [18:0] \chain_o$588[2] ;
  wire [18:0] \chain_o$588[3] ;
  wire [75:0] \chain_o$596 ;
  wire [18:0] \chain_o$596[0] ;
  wire [18:0] \chain_o$596[1] ;
  wire [18:0] \chain_o$596[2] ;
  wire [18:0] \chain_o$596[3] ;
  wire [75:0] \chain_o$604 ;
  wire [18:0] \chain_o$604[0] ;
  wire [18:0] \chain_o$604[1] ;
  wire [18:0] \chain_o$604[2] ;
  wire [18:0] \chain_o$604[3] ;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  wire [2:0] command;
  reg [9:0] control = 10'h000;
  (* init = 10'h000 *)
  wire [9:0] \control$134 ;
  wire \control$134.carried ;
  wire \control$134.edge ;
  wire \control$134.en ;
  wire \control$134.first ;
  wire \control$134.last ;
  wire [3:0] \control$134.tile ;
  wire \control$134.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$143 ;
  wire \control$143.carried ;
  wire \control$143.edge ;
  wire \control$143.en ;
  wire \control$143.first ;
  wire \control$143.last ;
  wire [3:0] \control$143.tile ;
  wire \control$143.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$152 ;
  wire \control$152.carried ;
  wire \control$152.edge ;
  wire \control$152.en ;
  wire \control$152.first ;
  wire \control$152.last ;
  wire [3:0] \control$152.tile ;
  wire \control$152.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$161 ;
  wire \control$161.carried ;
  wire \control$161.edge ;
  wire \control$161.en ;
  wire \control$161.first ;
  wire \control$161.last ;
  wire [3:0] \control$161.tile ;
  wire \control$161.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$169 ;
  wire \control$169.carried ;
  wire \control$169.edge ;
  wire \control$169.en ;
  wire \control$169.first ;
  wire \control$169.last ;
  wire [3:0] \control$169.tile ;
  wire \control$169.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$177 ;
  wire \control$177.carried ;
  wire \control$177.edge ;
  wire \control$177.en ;
  wire \control$177.first ;
  wire \control$177.last ;
  wire [3:0] \control$177.tile ;
  wire \control$177.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$185 ;
  wire \control$185.carried ;
  wire \control$185.edge ;
  wire \control$185.en ;
  wire \control$185.first ;
  wire \control$185.last ;
  wire [3:0] \control$185.tile ;
  wire \control$185.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$193 ;
  wire \control$193.carried ;
  wire \control$193.edge ;
  wire \control$193.en ;
  wire \control$193.first ;
  wire \control$193.last ;
  wire [3:0] \control$193.tile ;
  wire \control$193.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$201 ;
  wire \control$201.carried ;
  wire \control$201.edge ;
  wire \control$201.en ;
  wire \control$201.first ;
  wire \control$201.last ;
  wire [3:0] \control$201.tile ;
  wire \control$201.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$209 ;
  wire \control$209.carried ;
  wire \control$209.edge ;
  wire \control$209.en ;
  wire \control$209.first ;
  wire \control$209.last ;
  wire [3:0] \control$209.tile ;
  wire \control$209.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$217 ;
  wire \control$217.carried ;
  wire \control$217.edge ;
  wire \control$217.en ;
  wire \control$217.first ;
  wire \control$217.last ;
  wire [3:0] \control$217.tile ;
  wire \control$217.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$225 ;
  wire \control$225.carried ;
  wire \control$225.edge ;
  wire \control$225.en ;
  wire \control$225.first ;
  wire \control$225.last ;
  wire [3:0] \control$225.tile ;
  wire \control$225.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$233 ;
  wire \control$233.carried ;
  wire \control$233.edge ;
  wire \control$233.en ;
  wire \control$233.first ;
  wire \control$233.last ;
  wire [3:0] \control$233.tile ;
  wire \control$233.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$241 ;
  wire \control$241.carried ;
  wire \control$241.edge ;
  wire \control$241.en ;
  wire \control$241.first ;
  wire \control$241.last ;
  wire [3:0] \control$241.tile ;
  wire \control$241.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$249 ;
  wire \control$249.carried ;
  wire \control$249.edge ;
  wire \control$249.en ;
  wire \control$249.first ;
  wire \control$249.last ;
  wire [3:0] \control$249.tile ;
  wire \control$249.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$257 ;
  wire \control$257.carried ;
  wire \control$257.edge ;
  wire \control$257.en ;
  wire \control$257.first ;
  wire \control$257.last ;
  wire [3:0] \control$257.tile ;
  wire \control$257.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$265 ;
  wire \control$265.carried ;
  wire \control$265.edge ;
  wire \control$265.en ;
  wire \control$265.first ;
  wire \control$265.last ;
  wire [3:0] \control$265.tile ;
  wire \control$265.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$273 ;
  wire \control$273.carried ;
  wire \control$273.edge ;
  wire \control$273.en ;
  wire \control$273.first ;
  wire \control$273.last ;
  wire [3:0] \control$273.tile ;
  wire \control$273.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$281 ;
  wire \control$281.carried ;
  wire \control$281.edge ;
  wire \control$281.en ;
  wire \control$281.first ;
  wire \control$281.last ;
  wire [3:0] \control$281.tile ;
  wire \control$281.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$289 ;
  wire \control$289.carried ;
  wire \control$289.edge ;
  wire \control$289.en ;
  wire \control$289.first ;
  wire \control$289.last ;
  wire [3:0] \control$289.tile ;
  wire \control$289.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$297 ;
  wire \control$297.carried ;
  wire \control$297.edge ;
  wire \control$297.en ;
  wire \control$297.first ;
  wire \control$297.last ;
  wire [3:0] \control$297.tile ;
  wire \control$297.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$305 ;
  wire \control$305.carried ;
  wire \control$305.edge ;
  wire \control$305.en ;
  wire \control$305.first ;
  wire \control$305.last ;
  wire [3:0] \control$305.tile ;
  wire \control$305.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$313 ;
  wire \control$313.carried ;
  wire \control$313.edge ;
  wire \control$313.en ;
  wire \control$313.first ;
  wire \control$313.last ;
  wire [3:0] \control$313.tile ;
  wire \control$313.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$321 ;
  wire \control$321.carried ;
  wire \control$321.edge ;
  wire \control$321.en ;
  wire \control$321.first ;
  wire \control$321.last ;
  wire [3:0] \control$321.tile ;
  wire \control$321.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$329 ;
  wire \control$329.carried ;
  wire \control$329.edge ;
  wire \control$329.en ;
  wire \control$329.first ;
  wire \control$329.last ;
  wire [3:0] \control$329.tile ;
  wire \control$329.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$337 ;
  wire \control$337.carried ;
  wire \control$337.edge ;
  wire \control$337.en ;
  wire \control$337.first ;
  wire \control$337.last ;
  wire [3:0] \control$337.tile ;
  wire \control$337.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$345 ;
  wire \control$345.carried ;
  wire \control$345.edge ;
  wire \control$345.en ;
  wire \control$345.first ;
  wire \control$345.last ;
  wire [3:0] \control$345.tile ;
  wire \control$345.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$353 ;
  wire \control$353.carried ;
  wire \control$353.edge ;
  wire \control$353.en ;
  wire \control$353.first ;
  wire \control$353.last ;
  wire [3:0] \control$353.tile ;
  wire \control$353.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$361 ;
  wire \control$361.carried ;
  wire \control$361.edge ;
  wire \control$361.en ;
  wire \control$361.first ;
  wire \control$361.last ;
  wire [3:0] \control$361.tile ;
  wire \control$361.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$369 ;
  wire \control$369.carried ;
  wire \control$369.edge ;
  wire \control$369.en ;
  wire \control$369.first ;
  wire \control$369.last ;
  wire [3:0] \control$369.tile ;
  wire \control$369.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$377 ;
  wire \control$377.carried ;
  wire \control$377.edge ;
  wire \control$377.en ;
  wire \control$377.first ;
  wire \control$377.last ;
  wire [3:0] \control$377.tile ;
  wire \control$377.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$385 ;
  wire \control$385.carried ;
  wire \control$385.edge ;
  wire \control$385.en ;
  wire \control$385.first ;
  wire \control$385.last ;
  wire [3:0] \control$385.tile ;
  wire \control$385.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$393 ;
  wire \control$393.carried ;
  wire \control$393.edge ;
  wire \control$393.en ;
  wire \control$393.first ;
  wire \control$393.last ;
  wire [3:0] \control$393.tile ;
  wire \control$393.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$401 ;
  wire \control$401.carried ;
  wire \control$401.edge ;
  wire \control$401.en ;
  wire \control$401.first ;
  wire \control$401.last ;
  wire [3:0] \control$401.tile ;
  wire \control$401.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$409 ;
  wire \control$409.carried ;
  wire \control$409.edge ;
  wire \control$409.en ;
  wire \control$409.first ;
  wire \control$409.last ;
  wire [3:0] \control$409.tile ;
  wire \control$409.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$417 ;
  wire \control$417.carried ;
  wire \control$417.edge ;
  wire \control$417.en ;
  wire \control$417.first ;
  wire \control$417.last ;
  wire [3:0] \control$417.tile ;
  wire \control$417.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$425 ;
  wire \control$425.carried ;
  wire \control$425.edge ;
  wire \control$425.en ;
  wire \control$425.first ;
  wire \control$425.last ;
  wire [3:0] \control$425.tile ;
  wire \control$425.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$433 ;
  wire \control$433.carried ;
  wire \control$433.edge ;
  wire \control$433.en ;
  wire \control$433.first ;
  wire \control$433.last ;
  wire [3:0] \control$433.tile ;
  wire \control$433.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$441 ;
  wire \control$441.carried ;
  wire \control$441.edge ;
  wire \control$441.en ;
  wire \control$441.first ;
  wire \control$441.last ;
  wire [3:0] \control$441.tile ;
  wire \control$441.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$449 ;
  wire \control$449.carried ;
  wire \control$449.edge ;
  wire \control$449.en ;
  wire \control$449.first ;
  wire \control$449.last ;
  wire [3:0] \control$449.tile ;
  wire \control$449.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$457 ;
  wire \control$457.carried ;
  wire \control$457.edge ;
  wire \control$457.en ;
  wire \control$457.first ;
  wire \control$457.last ;
  wire [3:0] \control$457.tile ;
  wire \control$457.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$465 ;
  wire \control$465.carried ;
  wire \control$465.edge ;
  wire \control$465.en ;
  wire \control$465.first ;
  wire \control$465.last ;
  wire [3:0] \control$465.tile ;
  wire \control$465.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$473 ;
  wire \control$473.carried ;
  wire \control$473.edge ;
  wire \control$473.en ;
  wire \control$473.first ;
  wire \control$473.last ;
  wire [3:0] \control$473.tile ;
  wire \control$473.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$481 ;
  wire \control$481.carried ;
  wire \control$481.edge ;
  wire \control$481.en ;
  wire \control$481.first ;
  wire \control$481.last ;
  wire [3:0] \control$481.tile ;
  wire \control$481.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$489 ;
  wire \control$489.carried ;
  wire \control$489.edge ;
  wire \control$489.en ;
  wire \control$489.first ;
  wire \control$489.last ;
  wire [3:0] \control$489.tile ;
  wire \control$489.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$497 ;
  wire \control$497.carried ;
  wire \control$497.edge ;
  wire \control$497.en ;
  wire \control$497.first ;
  wire \control$497.last ;
  wire [3:0] \control$497.tile ;
  wire \control$497.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$505 ;
  wire \control$505.carried ;
  wire \control$505.edge ;
  wire \control$505.en ;
  wire \control$505.first ;
  wire \control$505.last ;
  wire [3:0] \control$505.tile ;
  wire \control$505.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$513 ;
  wire \control$513.carried ;
  wire \control$513.edge ;
  wire \control$513.en ;
  wire \control$513.first ;
  wire \control$513.last ;
  wire [3:0] \control$513.tile ;
  wire \control$513.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$521 ;
  wire \control$521.carried ;
  wire \control$521.edge ;
  wire \control$521.en ;
  wire \control$521.first ;
  wire \control$521.last ;
  wire [3:0] \control$521.tile ;
  wire \control$521.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$529 ;
  wire \control$529.carried ;
  wire \control$529.edge ;
  wire \control$529.en ;
  wire \control$529.first ;
  wire \control$529.last ;
  wire [3:0] \control$529.tile ;
  wire \control$529.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$537 ;
  wire \control$537.carried ;
  wire \control$537.edge ;
  wire \control$537.en ;
  wire \control$537.first ;
  wire \control$537.last ;
  wire [3:0] \control$537.tile ;
  wire \control$537.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$545 ;
  wire \control$545.carried ;
  wire \control$545.edge ;
  wire \control$545.en ;
  wire \control$545.first ;
  wire \control$545.last ;
  wire [3:0] \control$545.tile ;
  wire \control$545.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$553 ;
  wire \control$553.carried ;
  wire \control$553.edge ;
  wire \control$553.en ;
  wire \control$553.first ;
  wire \control$553.last ;
  wire [3:0] \control$553.tile ;
  wire \control$553.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$561 ;
  wire \control$561.carried ;
  wire \control$561.edge ;
  wire \control$561.en ;
  wire \control$561.first ;
  wire \control$561.last ;
  wire [3:0] \control$561.tile ;
  wire \control$561.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$569 ;
  wire \control$569.carried ;
  wire \control$569.edge ;
  wire \control$569.en ;
  wire \control$569.first ;
  wire \control$569.last ;
  wire [3:0] \control$569.tile ;
  wire \control$569.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$577 ;
  wire \control$577.carried ;
  wire \control$577.edge ;
  wire \control$577.en ;
  wire \control$577.first ;
  wire \control$577.last ;
  wire [3:0] \control$577.tile ;
  wire \control$577.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$585 ;
  wire \control$585.carried ;
  wire \control$585.edge ;
  wire \control$585.en ;
  wire \control$585.first ;
  wire \control$585.last ;
  wire [3:0] \control$585.tile ;
  wire \control$585.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$593 ;
  wire \control$593.carried ;
  wire \control$593.edge ;
  wire \control$593.en ;
  wire \control$593.first ;
  wire \control$593.last ;
  wire [3:0] \control$593.tile ;
  wire \control$593.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$601 ;
  wire \control$601.carried ;
  wire \control$601.edge ;
  wire \control$601.en ;
  wire \control$601.first ;
  wire \control$601.last ;
  wire [3:0] \control$601.tile ;
  wire \control$601.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$609 ;
  wire \control$609.carried ;
  wire \control$609.edge ;
  wire \control$609.en ;
  wire \control$609.first ;
  wire \control$609.last ;
  wire [3:0] \control$609.tile ;
  wire \control$609.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$616 ;
  wire \control$616.carried ;
  wire \control$616.edge ;
  wire \control$616.en ;
  wire \control$616.first ;
  wire \control$616.last ;
  wire [3:0] \control$616.tile ;
  wire \control$616.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$623 ;
  wire \control$623.carried ;
  wire \control$623.edge ;
  wire \control$623.en ;
  wire \control$623.first ;
  wire \control$623.last ;
  wire [3:0] \control$623.tile ;
  wire \control$623.unload ;
  (* init = 10'h000 *)
  wire [9:0] \control$630 ;
  wire \control$630.carried ;
  wire \control$630.edge ;
  wire \control$630.en ;
  wire \control$630.first ;
  wire \control$630.last ;
  wire [3:0] \control$630.tile ;
  wire \control$630.unload ;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
  reg [9:0] control0 = 10'h000;
  wire \control0.carried ;
  wire \control0.edge ;
  wire \control0.en ;
  wire \control0.first ;
  wire \control0.last ;
  wire [3:0] \control0.tile ;
  wire \control0.unload ;
  reg [9:0] control1 = 10'h000;
  wire \control1.carried ;
  wire \control1.edge ;
  wire \control1.en ;
  wire \control1.first ;
  wire \control1.last ;
  wire [3:0] \control1.tile ;
  wire \control1.unload ;
  (* init = 10'h000 *)
  wire [9:0] control2;
  wire \control2.carried ;
  wire \control2.edge ;
  wire \control2.en ;
  wire \control2.first ;
  wire \control2.last ;
  wire [3:0] \control2.tile ;
  wire \control2.unload ;
  reg [9:0] control3 = 10'h000;
  wire \control3.carried ;
  wire \control3.edge ;
  wire \control3.en ;
  wire \control3.first ;
  wire \control3.last ;
  wire [3:0] \control3.tile ;
  wire \control3.unload ;
  wire credit;
  wire \credit$106 ;
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
  output [2:0] \error$642 ;
  reg [2:0] \error$642  = 3'h0;
  (* enum_base_type = "Error" *)
  (* enum_value_000 = "NONE" *)
  (* enum_value_001 = "BAD_SHAPE" *)
  (* enum_value_010 = "BAD_MODE" *)
  (* enum_value_011 = "TLAST_EARLY" *)
  (* enum_value_100 = "TLAST_MISSING" *)
  (* enum_value_101 = "BAD_COMMAND" *)
  (* enum_value_110 = "BAD_RANGE" *)
  wire [2:0] \error$645 ;
  (* enum_base_type = "Error" *)
  (* enum_value_000 = "NONE" *)
  (* enum_value_001 = "BAD_SHAPE" *)
  (* enum_value_010 = "BAD_MODE" *)
  (* enum_value_011 = "TLAST_EARLY" *)
  (* enum_value_100 = "TLAST_MISSING" *)
  (* enum_value_101 = "BAD_COMMAND" *)
  (* enum_value_110 = "BAD_RANGE" *)
  wire [2:0] \error$646 ;
  wire fault;
  wire \fault$644 ;
  output [31:0] fill_cycles;
  reg [31:0] fill_cycles = 32'd0;
  wire finished;
  wire first_beat;
  wire flushing;
  wire group_written;
  wire \group_written$102 ;
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
  wire [31:0] \height$22 ;
  wire [15:0] \height$85 ;
  wire [49:0] i__payload;
  input [64:0] \i__payload$6 ;
  wire [64:0] \i__payload$6 ;
  wire [63:0] \i__payload$6.data ;
  wire \i__payload$6.last ;
  input [64:0] \i__payload$62 ;
  wire [64:0] \i__payload$62 ;
  wire [63:0] \i__payload$62.data ;
  wire \i__payload$62.last ;
  wire [64:0] \i__payload$63 ;
  wire [63:0] \i__payload$63.data ;
  wire \i__payload$63.last ;
  wire [63:0] \i__payload$68 ;
  wire [47:0] \i__payload$74 ;
  wire [47:0] \i__payload.data ;
  wire \i__payload.last ;
  wire \i__payload.pixel_last ;
  wire i__ready;
  output \i__ready$64 ;
  wire \i__ready$64 ;
  wire \i__ready$65 ;
  wire \i__ready$71 ;
  wire \i__ready$77 ;
  wire \i__ready$9 ;
  wire i__valid;
  input \i__valid$10 ;
  wire \i__valid$10 ;
  input \i__valid$66 ;
  wire \i__valid$66 ;
  wire \i__valid$67 ;
  wire \i__valid$72 ;
  wire \i__valid$78 ;
  wire idle;
  wire image_written;
  wire \image_written$104 ;
  reg [13:0] info = 14'h0000;
  wire \info.edge ;
  wire \info.image_last ;
  wire \info.inner ;
  wire [3:0] \info.slots ;
  wire [3:0] \info.tile ;
  wire \info.tile_last ;
  wire \info.triple ;
  wire \info.unloaded ;
  reg [13:0] info0 = 14'h0000;
  wire \info0.edge ;
  wire \info0.image_last ;
  wire \info0.inner ;
  wire [3:0] \info0.slots ;
  wire [3:0] \info0.tile ;
  wire \info0.tile_last ;
  wire \info0.triple ;
  wire \info0.unloaded ;
  reg [13:0] info1 = 14'h0000;
  wire \info1.edge ;
  wire \info1.image_last ;
  wire \info1.inner ;
  wire [3:0] \info1.slots ;
  wire [3:0] \info1.tile ;
  wire \info1.tile_last ;
  wire \info1.triple ;
  wire \info1.unloaded ;
  reg [13:0] info2 = 14'h0000;
  wire \info2.edge ;
  wire \info2.image_last ;
  wire \info2.inner ;
  wire [3:0] \info2.slots ;
  wire [3:0] \info2.tile ;
  wire \info2.tile_last ;
  wire \info2.triple ;
  wire \info2.unloaded ;
  (* init = 14'h0000 *)
  wire [13:0] info3;
  wire \info3.edge ;
  wire \info3.image_last ;
  wire \info3.inner ;
  wire [3:0] \info3.slots ;
  wire [3:0] \info3.tile ;
  wire \info3.tile_last ;
  wire \info3.triple ;
  wire \info3.unloaded ;
  output [31:0] input_stalls;
  reg [31:0] input_stalls = 32'd0;
  wire issue;
  wire last_beat;
  wire last_beat0;
  reg last_beat_gone0 = 1'h0;
  wire [32:0] load_end;
  wire loading;
  output [31:0] mac_cycles;
  reg [31:0] mac_cycles = 32'd0;
  input [31:0] mode;
  wire [31:0] mode;
  wire [31:0] \mode$30 ;
  wire [49:0] o__payload;
  output [64:0] \o__payload$12 ;
  wire [64:0] \o__payload$12 ;
  wire [63:0] \o__payload$12.data ;
  wire \o__payload$12.last ;
  wire [64:0] \o__payload$13 ;
  wire [63:0] \o__payload$13.data ;
  wire \o__payload$13.last ;
  wire [63:0] \o__payload$69 ;
  wire [47:0] \o__payload$75 ;
  wire [47:0] \o__payload.data ;
  wire \o__payload.last ;
  wire \o__payload.pixel_last ;
  wire o__ready;
  input \o__ready$14 ;
  wire \o__ready$14 ;
  wire \o__ready$15 ;
  wire \o__ready$70 ;
  wire \o__ready$76 ;
  wire o__valid;
  output \o__valid$16 ;
  wire \o__valid$16 ;
  wire \o__valid$17 ;
  wire \o__valid$73 ;
  wire \o__valid$79 ;
  wire open;
  output [31:0] output_stalls;
  reg [31:0] output_stalls = 32'd0;
  wire overlaps;
  wire [31:0] param_base;
  wire [64:0] params__payload;
  wire [63:0] \params__payload.data ;
  wire \params__payload.last ;
  output params__ready;
  wire params__ready;
  wire params__valid;
  input [3:0] \port$1314$0 ;
  wire [3:0] \port$1314$0 ;
  wire [16:0] read;
  wire [7:0] \read.address ;
  wire \read.apart ;
  wire \read.bank ;
  wire \read.inner ;
  wire [3:0] \read.mask ;
  wire [1:0] \read.slot ;
  wire [679:0] requant;
  wire [7:0] \requant.addr ;
  wire [671:0] \requant.data ;
  input [31:0] requant_base;
  wire [31:0] requant_base;
  wire [31:0] \requant_base$34 ;
  wire [7:0] \requant_base$98 ;
  wire requant_en;
  wire [8:0] requant_end;
  wire retire;
  wire \retire$94 ;
  wire retire_row;
  wire \retire_row$96 ;
  input rst;
  wire rst;
  reg running = 1'h0;
  wire [200:0] shape;
  wire [200:0] \shape$61 ;
  wire [15:0] \shape$61.beats_in ;
  wire [15:0] \shape$61.beats_out ;
  wire [15:0] \shape$61.beats_residual ;
  wire \shape$61.biased ;
  wire [13:0] \shape$61.blocks ;
  wire [14:0] \shape$61.column_words ;
  wire [14:0] \shape$61.groups ;
  wire \shape$61.halved ;
  wire [15:0] \shape$61.height ;
  wire [13:0] \shape$61.ingest_words ;
  wire [15:0] \shape$61.out_height ;
  wire [15:0] \shape$61.out_width ;
  wire [11:0] \shape$61.output_words ;
  wire \shape$61.packed ;
  wire \shape$61.pointwise ;
  wire \shape$61.residual ;
  wire [1:0] \shape$61.tail ;
  wire [11:0] \shape$61.tiles ;
  wire [15:0] \shape$61.width ;
  wire [200:0] \shape$80 ;
  wire [15:0] \shape$80.beats_in ;
  wire [15:0] \shape$80.beats_out ;
  wire [15:0] \shape$80.beats_residual ;
  wire \shape$80.biased ;
  wire [13:0] \shape$80.blocks ;
  wire [14:0] \shape$80.column_words ;
  wire [14:0] \shape$80.groups ;
  wire \shape$80.halved ;
  wire [15:0] \shape$80.height ;
  wire [13:0] \shape$80.ingest_words ;
  wire [15:0] \shape$80.out_height ;
  wire [15:0] \shape$80.out_width ;
  wire [11:0] \shape$80.output_words ;
  wire \shape$80.packed ;
  wire \shape$80.pointwise ;
  wire \shape$80.residual ;
  wire [1:0] \shape$80.tail ;
  wire [11:0] \shape$80.tiles ;
  wire [15:0] \shape$80.width ;
  wire [200:0] \shape$81 ;
  wire [15:0] \shape$81.beats_in ;
  wire [15:0] \shape$81.beats_out ;
  wire [15:0] \shape$81.beats_residual ;
  wire \shape$81.biased ;
  wire [13:0] \shape$81.blocks ;
  wire [14:0] \shape$81.column_words ;
  wire [14:0] \shape$81.groups ;
  wire \shape$81.halved ;
  wire [15:0] \shape$81.height ;
  wire [13:0] \shape$81.ingest_words ;
  wire [15:0] \shape$81.out_height ;
  wire [15:0] \shape$81.out_width ;
  wire [11:0] \shape$81.output_words ;
  wire \shape$81.packed ;
  wire \shape$81.pointwise ;
  wire \shape$81.residual ;
  wire [1:0] \shape$81.tail ;
  wire [11:0] \shape$81.tiles ;
  wire [15:0] \shape$81.width ;
  wire [200:0] \shape$82 ;
  wire [15:0] \shape$82.beats_in ;
  wire [15:0] \shape$82.beats_out ;
  wire [15:0] \shape$82.beats_residual ;
  wire \shape$82.biased ;
  wire [13:0] \shape$82.blocks ;
  wire [14:0] \shape$82.column_words ;
  wire [14:0] \shape$82.groups ;
  wire \shape$82.halved ;
  wire [15:0] \shape$82.height ;
  wire [13:0] \shape$82.ingest_words ;
  wire [15:0] \shape$82.out_height ;
  wire [15:0] \shape$82.out_width ;
  wire [11:0] \shape$82.output_words ;
  wire \shape$82.packed ;
  wire \shape$82.pointwise ;
  wire \shape$82.residual ;
  wire [1:0] \shape$82.tail ;
  wire [11:0] \shape$82.tiles ;
  wire [15:0] \shape$82.width ;
  wire [15:0] \shape.beats_in ;
  wire [15:0] \shape.beats_out ;
  wire [15:0] \shape.beats_residual ;
  wire \shape.biased ;
  wire [13:0] \shape.blocks ;
  wire [14:0] \shape.column_words ;
  wire [14:0] \shape.groups ;
  wire \shape.halved ;
  wire [15:0] \shape.height ;
  wire [13:0] \shape.ingest_words ;
  wire [15:0] \shape.out_height ;
  wire [15:0] \shape.out_width ;
  wire [11:0] \shape.output_words ;
  wire \shape.packed ;
  wire \shape.pointwise ;
  wire \shape.residual ;
  wire [1:0] \shape.tail ;
  wire [11:0] \shape.tiles ;
  wire [15:0] \shape.width ;
  wire shift;
  wire \shift$125 ;
  wire \shift$135 ;
  wire \shift$144 ;
  wire \shift$153 ;
  wire \shift$162 ;
  wire \shift$170 ;
  wire \shift$178 ;
  wire \shift$186 ;
  wire \shift$194 ;
  wire \shift$202 ;
  wire \shift$210 ;
  wire \shift$218 ;
  wire \shift$226 ;
  wire \shift$234 ;
  wire \shift$242 ;
  wire \shift$250 ;
  wire \shift$258 ;
  wire \shift$266 ;
  wire \shift$274 ;
  wire \shift$282 ;
  wire \shift$290 ;
  wire \shift$298 ;
  wire \shift$306 ;
  wire \shift$314 ;
  wire \shift$322 ;
  wire \shift$330 ;
  wire \shift$338 ;
  wire \shift$346 ;
  wire \shift$354 ;
  wire \shift$362 ;
  wire \shift$370 ;
  wire \shift$378 ;
  wire \shift$386 ;
  wire \shift$394 ;
  wire \shift$402 ;
  wire \shift$410 ;
  wire \shift$418 ;
  wire \shift$426 ;
  wire \shift$434 ;
  wire \shift$442 ;
  wire \shift$450 ;
  wire \shift$458 ;
  wire \shift$466 ;
  wire \shift$474 ;
  wire \shift$482 ;
  wire \shift$490 ;
  wire \shift$498 ;
  wire \shift$506 ;
  wire \shift$514 ;
  wire \shift$522 ;
  wire \shift$530 ;
  wire \shift$538 ;
  wire \shift$546 ;
  wire \shift$554 ;
  wire \shift$562 ;
  wire \shift$570 ;
  wire \shift$578 ;
  wire \shift$586 ;
  wire \shift$594 ;
  wire \shift$602 ;
  wire \shift$610 ;
  wire \shift$617 ;
  wire \shift$624 ;
  wire \shift$631 ;
  wire soft_reset;
  reg start;
  wire \start$86 ;
  wire \start$87 ;
  wire \start$88 ;
  wire \start$89 ;
  reg start_requant;
  reg start_weights;
  wire starved;
  wire [50:0] step;
  wire [9:0] \step.control ;
  wire \step.control.carried ;
  wire \step.control.edge ;
  wire \step.control.en ;
  wire \step.control.first ;
  wire \step.control.last ;
  wire [3:0] \step.control.tile ;
  wire \step.control.unload ;
  wire [13:0] \step.info ;
  wire \step.info.edge ;
  wire \step.info.image_last ;
  wire \step.info.inner ;
  wire [3:0] \step.info.slots ;
  wire [3:0] \step.info.tile ;
  wire \step.info.tile_last ;
  wire \step.info.triple ;
  wire \step.info.unloaded ;
  wire [16:0] \step.read ;
  wire [7:0] \step.read.address ;
  wire \step.read.apart ;
  wire \step.read.bank ;
  wire \step.read.inner ;
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
  wire [31:0] \weight_base$32 ;
  wire [9:0] \weight_base$97 ;
  wire [10:0] weight_end;
  input [31:0] width;
  wire [31:0] width;
  wire [31:0] \width$24 ;
  wire [15:0] \width$84 ;
  wire [95:0] word;
  input [31:0] words;
  wire [31:0] words;
  wire [31:0] \words$36 ;
  wire [15:0] words_per_pixel;
  wire [679:0] write;
  wire [81:0] \write$118 ;
  wire [9:0] \write$118.addr ;
  wire [71:0] \write$118.data ;
  wire [81:0] \write$132 ;
  wire [9:0] \write$132.addr ;
  wire [71:0] \write$132.data ;
  wire [81:0] \write$141 ;
  wire [9:0] \write$141.addr ;
  wire [71:0] \write$141.data ;
  wire [81:0] \write$150 ;
  wire [9:0] \write$150.addr ;
  wire [71:0] \write$150.data ;
  wire [81:0] \write$159 ;
  wire [9:0] \write$159.addr ;
  wire [71:0] \write$159.data ;
  wire [81:0] \write$167 ;
  wire [9:0] \write$167.addr ;
  wire [71:0] \write$167.data ;
  wire [81:0] \write$175 ;
  wire [9:0] \write$175.addr ;
  wire [71:0] \write$175.data ;
  wire [81:0] \write$183 ;
  wire [9:0] \write$183.addr ;
  wire [71:0] \write$183.data ;
  wire [81:0] \write$191 ;
  wire [9:0] \write$191.addr ;
  wire [71:0] \write$191.data ;
  wire [81:0] \write$199 ;
  wire [9:0] \write$199.addr ;
  wire [71:0] \write$199.data ;
  wire [81:0] \write$207 ;
  wire [9:0] \write$207.addr ;
  wire [71:0] \write$207.data ;
  wire [81:0] \write$215 ;
  wire [9:0] \write$215.addr ;
  wire [71:0] \write$215.data ;
  wire [81:0] \write$223 ;
  wire [9:0] \write$223.addr ;
  wire [71:0] \write$223.data ;
  wire [81:0] \write$231 ;
  wire [9:0] \write$231.addr ;
  wire [71:0] \write$231.data ;
  wire [81:0] \write$239 ;
  wire [9:0] \write$239.addr ;
  wire [71:0] \write$239.data ;
  wire [81:0] \write$247 ;
  wire [9:0] \write$247.addr ;
  wire [71:0] \write$247.data ;
  wire [81:0] \write$255 ;
  wire [9:0] \write$255.addr ;
  wire [71:0] \write$255.data ;
  wire [81:0] \write$263 ;
  wire [9:0] \write$263.addr ;
  wire [71:0] \write$263.data ;
  wire [81:0] \write$271 ;
  wire [9:0] \write$271.addr ;
  wire [71:0] \write$271.data ;
  wire [81:0] \write$279 ;
  wire [9:0] \write$279.addr ;
  wire [71:0] \write$279.data ;
  wire [81:0] \write$287 ;
  wire [9:0] \write$287.addr ;
  wire [71:0] \write$287.data ;
  wire [81:0] \write$295 ;
  wire [9:0] \write$295.addr ;
  wire [71:0] \write$295.data ;
  wire [81:0] \write$303 ;
  wire [9:0] \write$303.addr ;
  wire [71:0] \write$303.data ;
  wire [81:0] \write$311 ;
  wire [9:0] \write$311.addr ;
  wire [71:0] \write$311.data ;
  wire [81:0] \write$319 ;
  wire [9:0] \write$319.addr ;
  wire [71:0] \write$319.data ;
  wire [81:0] \write$327 ;
  wire [9:0] \write$327.addr ;
  wire [71:0] \write$327.data ;
  wire [81:0] \write$335 ;
  wire [9:0] \write$335.addr ;
  wire [71:0] \write$335.data ;
  wire [81:0] \write$343 ;
  wire [9:0] \write$343.addr ;
  wire [71:0] \write$343.data ;
  wire [81:0] \write$351 ;
  wire [9:0] \write$351.addr ;
  wire [71:0] \write$351.data ;
  wire [81:0] \write$359 ;
  wire [9:0] \write$359.addr ;
  wire [71:0] \write$359.data ;
  wire [81:0] \write$367 ;
  wire [9:0] \write$367.addr ;
  wire [71:0] \write$367.data ;
  wire [81:0] \write$375 ;
  wire [9:0] \write$375.addr ;
  wire [71:0] \write$375.data ;
  wire [81:0] \write$383 ;
  wire [9:0] \write$383.addr ;
  wire [71:0] \write$383.data ;
  wire [81:0] \write$391 ;
  wire [9:0] \write$391.addr ;
  wire [71:0] \write$391.data ;
  wire [81:0] \write$399 ;
  wire [9:0] \write$399.addr ;
  wire [71:0] \write$399.data ;
  wire [81:0] \write$407 ;
  wire [9:0] \write$407.addr ;
  wire [71:0] \write$407.data ;
  wire [81:0] \write$415 ;
  wire [9:0] \write$415.addr ;
  wire [71:0] \write$415.data ;
  wire [81:0] \write$423 ;
  wire [9:0] \write$423.addr ;
  wire [71:0] \write$423.data ;
  wire [81:0] \write$431 ;
  wire [9:0] \write$431.addr ;
  wire [71:0] \write$431.data ;
  wire [81:0] \write$439 ;
  wire [9:0] \write$439.addr ;
  wire [71:0] \write$439.data ;
  wire [81:0] \write$447 ;
  wire [9:0] \write$447.addr ;
  wire [71:0] \write$447.data ;
  wire [81:0] \write$455 ;
  wire [9:0] \write$455.addr ;
  wire [71:0] \write$455.data ;
  wire [81:0] \write$463 ;
  wire [9:0] \write$463.addr ;
  wire [71:0] \write$463.data ;
  wire [81:0] \write$471 ;
  wire [9:0] \write$471.addr ;
  wire [71:0] \write$471.data ;
  wire [81:0] \write$479 ;
  wire [9:0] \write$479.addr ;
  wire [71:0] \write$479.data ;
  wire [81:0] \write$487 ;
  wire [9:0] \write$487.addr ;
  wire [71:0] \write$487.data ;
  wire [81:0] \write$495 ;
  wire [9:0] \write$495.addr ;
  wire [71:0] \write$495.data ;
  wire [81:0] \write$503 ;
  wire [9:0] \write$503.addr ;
  wire [71:0] \write$503.data ;
  wire [81:0] \write$511 ;
  wire [9:0] \write$511.addr ;
  wire [71:0] \write$511.data ;
  wire [81:0] \write$519 ;
  wire [9:0] \write$519.addr ;
  wire [71:0] \write$519.data ;
  wire [81:0] \write$527 ;
  wire [9:0] \write$527.addr ;
  wire [71:0] \write$527.data ;
  wire [81:0] \write$535 ;
  wire [9:0] \write$535.addr ;
  wire [71:0] \write$535.data ;
  wire [81:0] \write$543 ;
  wire [9:0] \write$543.addr ;
  wire [71:0] \write$543.data ;
  wire [81:0] \write$551 ;
  wire [9:0] \write$551.addr ;
  wire [71:0] \write$551.data ;
  wire [81:0] \write$559 ;
  wire [9:0] \write$559.addr ;
  wire [71:0] \write$559.data ;
  wire [81:0] \write$567 ;
  wire [9:0] \write$567.addr ;
  wire [71:0] \write$567.data ;
  wire [81:0] \write$575 ;
  wire [9:0] \write$575.addr ;
  wire [71:0] \write$575.data ;
  wire [81:0] \write$583 ;
  wire [9:0] \write$583.addr ;
  wire [71:0] \write$583.data ;
  wire [81:0] \write$591 ;
  wire [9:0] \write$591.addr ;
  wire [71:0] \write$591.data ;
  wire [81:0] \write$599 ;
  wire [9:0] \write$599.addr ;
  wire [71:0] \write$599.data ;
  wire [81:0] \write$607 ;
  wire [9:0] \write$607.addr ;
  wire [71:0] \write$607.data ;
  wire [81:0] \write$614 ;
  wire [9:0] \write$614.addr ;
  wire [71:0] \write$614.data ;
  wire [81:0] \write$621 ;
  wire [9:0] \write$621.addr ;
  wire [71:0] \write$621.data ;
  wire [81:0] \write$628 ;
  wire [9:0] \write$628.addr ;
  wire [71:0] \write$628.data ;
  wire [7:0] \write.addr ;
  wire [671:0] \write.data ;
  wire write_en;
  wire \write_en$116 ;
  wire \write_en$131 ;
  wire \write_en$140 ;
  wire \write_en$149 ;
  wire \write_en$158 ;
  wire \write_en$166 ;
  wire \write_en$174 ;
  wire \write_en$182 ;
  wire \write_en$190 ;
  wire \write_en$198 ;
  wire \write_en$206 ;
  wire \write_en$214 ;
  wire \write_en$222 ;
  wire \write_en$230 ;
  wire \write_en$238 ;
  wire \write_en$246 ;
  wire \write_en$254 ;
  wire \write_en$262 ;
  wire \write_en$270 ;
  wire \write_en$278 ;
  wire \write_en$286 ;
  wire \write_en$294 ;
  wire \write_en$302 ;
  wire \write_en$310 ;
  wire \write_en$318 ;
  wire \write_en$326 ;
  wire \write_en$334 ;
  wire \write_en$342 ;
  wire \write_en$350 ;
  wire \write_en$358 ;
  wire \write_en$366 ;
  wire \write_en$374 ;
  wire \write_en$382 ;
  wire \write_en$390 ;
  wire \write_en$398 ;
  wire \write_en$406 ;
  wire \write_en$414 ;
  wire \write_en$422 ;
  wire \write_en$430 ;
  wire \write_en$438 ;
  wire \write_en$446 ;
  wire \write_en$454 ;
  wire \write_en$462 ;
  wire \write_en$470 ;
  wire \write_en$478 ;
  wire \write_en$486 ;
  wire \write_en$494 ;
  wire \write_en$502 ;
  wire \write_en$510 ;
  wire \write_en$518 ;
  wire \write_en$526 ;
  wire \write_en$534 ;
  wire \write_en$542 ;
  wire \write_en$550 ;
  wire \write_en$558 ;
  wire \write_en$566 ;
  wire \write_en$574 ;
  wire \write_en$582 ;
  wire \write_en$590 ;
  wire \write_en$598 ;
  wire \write_en$606 ;
  wire \write_en$613 ;
  wire \write_en$620 ;
  wire \write_en$627 ;
  assign \$18  = ! words;
  assign \$19  = \$18  | \$signal$48 ;
  assign \$20  = busy & overlaps;
  assign \$21  = \$19  | \$20 ;
  assign \$22  = \wait  == 1'h1;
  assign \$23  = ! error;
  assign \$24  = \$23  & params__ready;
  assign \$26  = \$24  & \$25 ;
  assign \$27  = ! verdict;
  assign \$28  = control3[0] & control3[3];
  assign finished = \$28  | control3[9];
  assign first_beat = \i__valid$66  & \i__ready$64 ;
  assign \$29  = first_beat | \$signal$635 ;
  assign \$30  = ~ ended;
  assign \$signal$634  = \$29  & \$30 ;
  assign \$31  = \port$1314$0 [2:0] - 1'h1;
  assign \$32  = { 1'h0, \port$1314$0 [2:0] } & \$31 ;
  assign \$33  = | \$32 ;
  assign \$34  = | \wait ;
  assign \$35  = \wait  - 1'h1;
  assign \$36  = \wait  == 1'h1;
  assign \$37  = running & delivered;
  assign \$38  = ~ open;
  assign \$39  = \$37  & \$38 ;
  assign \$40  = \$signal$52  & idle;
  assign \$41  = ! \error$642 ;
  assign \$42  = | \$signal$54 ;
  assign \$43  = | verdict;
  assign \$44  = cycles + 1'h1;
  assign \$45  = ~ \$signal$653 ;
  assign \$46  = ~ flushing;
  assign \$47  = blocked & \$46 ;
  assign \$48  = mac_cycles + 1'h1;
  assign \$49  = fill_cycles + 1'h1;
  assign \$50  = input_stalls + 1'h1;
  assign \$51  = output_stalls + 1'h1;
  assign \$52  = drain_cycles + 1'h1;
  always @(posedge clk)
    last_beat_gone0 <= \$53 ;
  always @(posedge clk)
    \wait  <= \$54 ;
  always @(posedge clk)
    done <= \$55 ;
  always @(posedge clk)
    running <= \$56 ;
  always @(posedge clk)
    delivered <= \$57 ;
  always @(posedge clk)
    \error$642  <= \$58 ;
  always @(posedge clk)
    control0 <= \$59 ;
  always @(posedge clk)
    info0 <= step[50:37];
  always @(posedge clk)
    control1 <= \$60 ;
  always @(posedge clk)
    info1 <= info0;
  always @(posedge clk)
    control <= \$61 ;
  always @(posedge clk)
    info2 <= info1;
  always @(posedge clk)
    control3 <= \$62 ;
  always @(posedge clk)
    info <= info2;
  always @(posedge clk)
    \$signal$635  <= \$63 ;
  always @(posedge clk)
    \$signal$653  <= \$64 ;
  always @(posedge clk)
    ended <= \$65 ;
  always @(posedge clk)
    cycles <= \$66 ;
  always @(posedge clk)
    mac_cycles <= \$67 ;
  always @(posedge clk)
    fill_cycles <= \$68 ;
  always @(posedge clk)
    input_stalls <= \$69 ;
  always @(posedge clk)
    output_stalls <= \$70 ;
  always @(posedge clk)
    drain_cycles <= \$71 ;
  assign \$1  = \o__valid$16  & \o__ready$14 ;
  assign last_beat0 = \$1  & \o__payload$12 [64];
  assign \$3  = last_beat0 | last_beat_gone0;
  assign last_beat = \$2  & \$4 ;
  assign \$5  = | \wait ;
  assign busy = running | \$5 ;
  assign \$signal  = params__ready ? to_requant : \port$1314$0 [2];
  assign load_end = base + words;
  assign \$6  = \$signal  ? 11'h100 : 11'h400;
  assign \$signal$48  = load_end > \$6 ;
  assign \$7  = \$signal  ? { 2'h0, requant_end } : weight_end;
  assign \$8  = base < \$7 ;
  assign \$9  = \$signal  ? requant_base : weight_base;
  assign \$10  = load_end > \$9 ;
  assign overlaps = \$8  & \$10 ;
  assign \$signal$52  = | \port$1314$0 [2:0];
  assign \$11  = ~ busy;
  assign \$12  = ~ params__ready;
  assign idle = \$11  & \$12 ;
  assign \$13  = \port$1314$0 [2:0] - 1'h1;
  assign \$14  = { 1'h0, \port$1314$0 [2:0] } & \$13 ;
  assign \$15  = | \$14 ;
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
    .soft_reset(\port$1314$0 [3]),
    .weight_base(weight_base),
    .weight_end(weight_end),
    .width(width)
  );
  \macram_top.array.drain  drain (
    .clk(clk),
    .credit(credit),
    .finished(finished),
    .\heads$75 (heads),
    .info(info),
    .o__payload(i__payload),
    .o__ready(o__ready),
    .reload__addr(\$73 ),
    .reload__data(\$74 ),
    .reload__en(write_en),
    .requant_base(requant_base[7:0]),
    .rst(rst),
    .shape(shape),
    .shift(shift),
    .soft_reset(\port$1314$0 [3]),
    .start(start),
    .valid(i__valid)
  );
  \macram_top.array.emit  emit (
    .beats_per_pixel(shape[163:148]),
    .clk(clk),
    .i__payload(i__payload),
    .i__ready(o__ready),
    .i__valid(i__valid),
    .o__payload(\o__payload$12 ),
    .o__ready(\o__ready$14 ),
    .o__valid(\o__valid$16 ),
    .rst(rst),
    .soft_reset(\port$1314$0 [3])
  );
  \macram_top.array.frame  frame (
    .beats(shape[147:132]),
    .clk(clk),
    .error(\error$645 ),
    .fault(fault),
    .i__payload(\i__payload$62 ),
    .i__ready(\i__ready$64 ),
    .i__valid(\i__valid$66 ),
    .o__ready(\o__ready$70 ),
    .o__valid(\i__valid$72 ),
    .open(open),
    .\port$1409$0 (shape[31:0]),
    .rst(rst),
    .soft_reset(\port$1314$0 [3]),
    .start(start)
  );
  \macram_top.array.ingest  ingest (
    .beats_per_pixel(shape[147:132]),
    .clk(clk),
    .i__payload(\i__payload$62 [63:0]),
    .i__ready(\o__ready$70 ),
    .i__valid(\i__valid$72 ),
    .o__payload(\i__payload$74 ),
    .o__ready(\o__ready$76 ),
    .o__valid(\i__valid$78 ),
    .\port$1409$79 (shape[92:79]),
    .rst(rst),
    .soft_reset(\port$1314$0 [3])
  );
  \macram_top.array.lines  lines (
    .clk(clk),
    .group_written(group_written),
    .i__payload(\i__payload$74 ),
    .i__ready(\o__ready$76 ),
    .i__valid(\i__valid$78 ),
    .image_written(image_written),
    .read(step[16:0]),
    .retire(retire),
    .retire_row(retire_row),
    .rst(rst),
    .shape(shape),
    .soft_reset(\port$1314$0 [3]),
    .start(start),
    .word(activations)
  );
  \macram_top.array.loader  loader (
    .base(base),
    .clk(clk),
    .error(\error$646 ),
    .fault(\fault$644 ),
    .i__payload(\i__payload$6 ),
    .i__ready(params__ready),
    .i__valid(\i__valid$10 ),
    .\port$1691$0 (\$72 ),
    .\port$1693$0 (\$73 ),
    .\port$1695$0 (\$74 ),
    .requant_en(write_en),
    .rst(rst),
    .soft_reset(\port$1314$0 [3]),
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
    .soft_reset(\port$1314$0 [3]),
    .start(start),
    .starved(starved),
    .\step$51 (step),
    .weight_base(weight_base[9:0])
  );
  \macram_top.array.unit000  unit000 (
    .address(step[26:17]),
    .chain_o(chain_o),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(chain_i),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[0])
  );
  \macram_top.array.unit001  unit001 (
    .address(step[26:17]),
    .chain_o(\chain_o$136 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$137 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[1])
  );
  \macram_top.array.unit002  unit002 (
    .address(step[26:17]),
    .chain_o(\chain_o$145 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$146 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[2])
  );
  \macram_top.array.unit003  unit003 (
    .address(step[26:17]),
    .chain_o(\chain_o$154 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$155 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[3])
  );
  \macram_top.array.unit004  unit004 (
    .address(step[26:17]),
    .chain_o(chain_i),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$163 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[4])
  );
  \macram_top.array.unit005  unit005 (
    .address(step[26:17]),
    .chain_o(\chain_i$137 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$171 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[5])
  );
  \macram_top.array.unit006  unit006 (
    .address(step[26:17]),
    .chain_o(\chain_i$146 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$179 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[6])
  );
  \macram_top.array.unit007  unit007 (
    .address(step[26:17]),
    .chain_o(\chain_i$155 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$187 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[7])
  );
  \macram_top.array.unit008  unit008 (
    .address(step[26:17]),
    .chain_o(\chain_i$163 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$195 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[8])
  );
  \macram_top.array.unit009  unit009 (
    .address(step[26:17]),
    .chain_o(\chain_i$171 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$203 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[9])
  );
  \macram_top.array.unit010  unit010 (
    .address(step[26:17]),
    .chain_o(\chain_i$179 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$211 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[10])
  );
  \macram_top.array.unit011  unit011 (
    .address(step[26:17]),
    .chain_o(\chain_i$187 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$219 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[11])
  );
  \macram_top.array.unit012  unit012 (
    .address(step[26:17]),
    .chain_o(\chain_i$195 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$227 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[12])
  );
  \macram_top.array.unit013  unit013 (
    .address(step[26:17]),
    .chain_o(\chain_i$203 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$235 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[13])
  );
  \macram_top.array.unit014  unit014 (
    .address(step[26:17]),
    .chain_o(\chain_i$211 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$243 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[14])
  );
  \macram_top.array.unit015  unit015 (
    .address(step[26:17]),
    .chain_o(\chain_i$219 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$251 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[15])
  );
  \macram_top.array.unit016  unit016 (
    .address(step[26:17]),
    .chain_o(\chain_i$227 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$259 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[16])
  );
  \macram_top.array.unit017  unit017 (
    .address(step[26:17]),
    .chain_o(\chain_i$235 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$267 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[17])
  );
  \macram_top.array.unit018  unit018 (
    .address(step[26:17]),
    .chain_o(\chain_i$243 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$275 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[18])
  );
  \macram_top.array.unit019  unit019 (
    .address(step[26:17]),
    .chain_o(\chain_i$251 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$283 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[19])
  );
  \macram_top.array.unit020  unit020 (
    .address(step[26:17]),
    .chain_o(\chain_i$259 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$291 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[20])
  );
  \macram_top.array.unit021  unit021 (
    .address(step[26:17]),
    .chain_o(\chain_i$267 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$299 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[21])
  );
  \macram_top.array.unit022  unit022 (
    .address(step[26:17]),
    .chain_o(\chain_i$275 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$307 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[22])
  );
  \macram_top.array.unit023  unit023 (
    .address(step[26:17]),
    .chain_o(\chain_i$283 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$315 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[23])
  );
  \macram_top.array.unit024  unit024 (
    .address(step[26:17]),
    .chain_o(\chain_i$291 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$323 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[24])
  );
  \macram_top.array.unit025  unit025 (
    .address(step[26:17]),
    .chain_o(\chain_i$299 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$331 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[25])
  );
  \macram_top.array.unit026  unit026 (
    .address(step[26:17]),
    .chain_o(\chain_i$307 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$339 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[26])
  );
  \macram_top.array.unit027  unit027 (
    .address(step[26:17]),
    .chain_o(\chain_i$315 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$347 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[27])
  );
  \macram_top.array.unit028  unit028 (
    .address(step[26:17]),
    .chain_o(\chain_i$323 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$355 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[28])
  );
  \macram_top.array.unit029  unit029 (
    .address(step[26:17]),
    .chain_o(\chain_i$331 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$363 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[29])
  );
  \macram_top.array.unit030  unit030 (
    .address(step[26:17]),
    .chain_o(\chain_i$339 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$371 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[30])
  );
  \macram_top.array.unit031  unit031 (
    .address(step[26:17]),
    .chain_o(\chain_i$347 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$379 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[31])
  );
  \macram_top.array.unit032  unit032 (
    .address(step[26:17]),
    .chain_o(\chain_i$355 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$387 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[32])
  );
  \macram_top.array.unit033  unit033 (
    .address(step[26:17]),
    .chain_o(\chain_i$363 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$395 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[33])
  );
  \macram_top.array.unit034  unit034 (
    .address(step[26:17]),
    .chain_o(\chain_i$371 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$403 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[34])
  );
  \macram_top.array.unit035  unit035 (
    .address(step[26:17]),
    .chain_o(\chain_i$379 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$411 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[35])
  );
  \macram_top.array.unit036  unit036 (
    .address(step[26:17]),
    .chain_o(\chain_i$387 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$419 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[36])
  );
  \macram_top.array.unit037  unit037 (
    .address(step[26:17]),
    .chain_o(\chain_i$395 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$427 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[37])
  );
  \macram_top.array.unit038  unit038 (
    .address(step[26:17]),
    .chain_o(\chain_i$403 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$435 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[38])
  );
  \macram_top.array.unit039  unit039 (
    .address(step[26:17]),
    .chain_o(\chain_i$411 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$443 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[39])
  );
  \macram_top.array.unit040  unit040 (
    .address(step[26:17]),
    .chain_o(\chain_i$419 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$451 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[40])
  );
  \macram_top.array.unit041  unit041 (
    .address(step[26:17]),
    .chain_o(\chain_i$427 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$459 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[41])
  );
  \macram_top.array.unit042  unit042 (
    .address(step[26:17]),
    .chain_o(\chain_i$435 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$467 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[42])
  );
  \macram_top.array.unit043  unit043 (
    .address(step[26:17]),
    .chain_o(\chain_i$443 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$475 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[43])
  );
  \macram_top.array.unit044  unit044 (
    .address(step[26:17]),
    .chain_o(\chain_i$451 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$483 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[44])
  );
  \macram_top.array.unit045  unit045 (
    .address(step[26:17]),
    .chain_o(\chain_i$459 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$491 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[45])
  );
  \macram_top.array.unit046  unit046 (
    .address(step[26:17]),
    .chain_o(\chain_i$467 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$499 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[46])
  );
  \macram_top.array.unit047  unit047 (
    .address(step[26:17]),
    .chain_o(\chain_i$475 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$507 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[47])
  );
  \macram_top.array.unit048  unit048 (
    .address(step[26:17]),
    .chain_o(\chain_i$483 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$515 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[48])
  );
  \macram_top.array.unit049  unit049 (
    .address(step[26:17]),
    .chain_o(\chain_i$491 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$523 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[49])
  );
  \macram_top.array.unit050  unit050 (
    .address(step[26:17]),
    .chain_o(\chain_i$499 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$531 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[50])
  );
  \macram_top.array.unit051  unit051 (
    .address(step[26:17]),
    .chain_o(\chain_i$507 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$539 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[51])
  );
  \macram_top.array.unit052  unit052 (
    .address(step[26:17]),
    .chain_o(\chain_i$515 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$547 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[52])
  );
  \macram_top.array.unit053  unit053 (
    .address(step[26:17]),
    .chain_o(\chain_i$523 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$555 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[53])
  );
  \macram_top.array.unit054  unit054 (
    .address(step[26:17]),
    .chain_o(\chain_i$531 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$563 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[54])
  );
  \macram_top.array.unit055  unit055 (
    .address(step[26:17]),
    .chain_o(\chain_i$539 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$571 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[55])
  );
  \macram_top.array.unit056  unit056 (
    .address(step[26:17]),
    .chain_o(\chain_i$547 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$579 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[56])
  );
  \macram_top.array.unit057  unit057 (
    .address(step[26:17]),
    .chain_o(\chain_i$555 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$587 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[57])
  );
  \macram_top.array.unit058  unit058 (
    .address(step[26:17]),
    .chain_o(\chain_i$563 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$595 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[58])
  );
  \macram_top.array.unit059  unit059 (
    .address(step[26:17]),
    .chain_o(\chain_i$571 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$603 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[59])
  );
  \macram_top.array.unit060  unit060 (
    .address(step[26:17]),
    .chain_o(\chain_i$579 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(chain_o),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[60])
  );
  \macram_top.array.unit061  unit061 (
    .address(step[26:17]),
    .chain_o(\chain_i$587 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_o$136 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[61])
  );
  \macram_top.array.unit062  unit062 (
    .address(step[26:17]),
    .chain_o(\chain_i$595 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_o$145 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[62])
  );
  \macram_top.array.unit063  unit063 (
    .address(step[26:17]),
    .chain_o(\chain_i$603 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_o$154 ),
    .core__control(control),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$72 ),
    .write__data(\$74 [647:576]),
    .write__en(unit_en[63])
  );
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$signal$54  = 3'h0;
    if (\$15 ) begin
      \$signal$54  = 3'h5;
    end else if (\port$1314$0 [0]) begin
      if (busy) begin
        \$signal$54  = 3'h5;
      end
    end else if (\$signal$52 ) begin
      if (\$17 ) begin
        \$signal$54  = 3'h5;
      end else if (\$21 ) begin
        \$signal$54  = 3'h6;
      end
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    start_weights = 1'h0;
    if (\$15 ) begin
    end else if (\port$1314$0 [0]) begin
    end else if (\$signal$52 ) begin
      (* full_case = 32'd1 *)
      if (\$17 ) begin
      end else if (\$21 ) begin
      end else begin
        start_weights = \port$1314$0 [1];
      end
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    start_requant = 1'h0;
    if (\$15 ) begin
    end else if (\port$1314$0 [0]) begin
    end else if (\$signal$52 ) begin
      (* full_case = 32'd1 *)
      if (\$17 ) begin
      end else if (\$21 ) begin
      end else begin
        start_requant = \port$1314$0 [2];
      end
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    verdict = 3'h0;
    if (\$22 ) begin
      (* full_case = 32'd1 *)
      if (\$26 ) begin
        verdict = 3'h6;
      end else begin
        verdict = error;
      end
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    start = 1'h0;
    if (\$22 ) begin
      start = \$27 ;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$53  = last_beat_gone0;
    if (start) begin
      \$53  = 1'h0;
    end else if (last_beat0) begin
      \$53  = 1'h1;
    end
    if (\port$1314$0 [3]) begin
      \$53  = 1'h0;
    end
    if (rst) begin
      \$53  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$54  = \wait ;
    if (\$33 ) begin
    end else if (\port$1314$0 [0]) begin
      (* full_case = 32'd1 *)
      if (busy) begin
      end else begin
        \$54  = 2'h3;
      end
    end
    if (\$34 ) begin
      \$54  = \$35 [1:0];
    end
    if (\port$1314$0 [3]) begin
      \$54  = 2'h0;
    end
    if (rst) begin
      \$54  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$55  = done;
    if (\$33 ) begin
    end else if (\port$1314$0 [0]) begin
      (* full_case = 32'd1 *)
      if (busy) begin
      end else begin
        \$55  = 1'h0;
      end
    end
    if (\$39 ) begin
      \$55  = 1'h1;
    end
    if (\$40 ) begin
      \$55  = 1'h0;
    end
    if (\port$1314$0 [3]) begin
      \$55  = 1'h0;
    end
    if (rst) begin
      \$55  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$56  = running;
    if (\$36 ) begin
      \$56  = start;
    end
    if (\$39 ) begin
      \$56  = 1'h0;
    end
    if (\port$1314$0 [3]) begin
      \$56  = 1'h0;
    end
    if (rst) begin
      \$56  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$57  = delivered;
    if (last_beat) begin
      \$57  = 1'h1;
    end
    if (\$39 ) begin
      \$57  = 1'h0;
    end
    if (\port$1314$0 [3]) begin
      \$57  = 1'h0;
    end
    if (rst) begin
      \$57  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$58  = \error$642 ;
    if (\$40 ) begin
      \$58  = \$signal$54 ;
    end else if (\$41 ) begin
      if (\$42 ) begin
        \$58  = \$signal$54 ;
      end else if (\$43 ) begin
        \$58  = verdict;
      end else if (fault) begin
        \$58  = \error$645 ;
      end else if (\fault$644 ) begin
        \$58  = \error$646 ;
      end
    end
    if (\port$1314$0 [3]) begin
      \$58  = 3'h0;
    end
    if (rst) begin
      \$58  = 3'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$59  = step[36:27];
    if (\port$1314$0 [3]) begin
      \$59  = 10'h000;
    end
    if (rst) begin
      \$59  = 10'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$60  = control0;
    if (\port$1314$0 [3]) begin
      \$60  = 10'h000;
    end
    if (rst) begin
      \$60  = 10'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$61  = control1;
    if (\port$1314$0 [3]) begin
      \$61  = 10'h000;
    end
    if (rst) begin
      \$61  = 10'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$62  = control;
    if (\port$1314$0 [3]) begin
      \$62  = 10'h000;
    end
    if (rst) begin
      \$62  = 10'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$63  = \$signal$635 ;
    if (first_beat) begin
      \$63  = 1'h1;
    end
    if (start) begin
      \$63  = 1'h0;
    end
    if (\port$1314$0 [3]) begin
      \$63  = 1'h0;
    end
    if (rst) begin
      \$63  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$64  = \$signal$653 ;
    if (issue) begin
      \$64  = 1'h1;
    end
    if (start) begin
      \$64  = 1'h0;
    end
    if (\port$1314$0 [3]) begin
      \$64  = 1'h0;
    end
    if (rst) begin
      \$64  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$65  = ended;
    if (last_beat) begin
      \$65  = 1'h1;
    end
    if (start) begin
      \$65  = 1'h0;
    end
    if (\port$1314$0 [3]) begin
      \$65  = 1'h0;
    end
    if (rst) begin
      \$65  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$66  = cycles;
    if (\$signal$634 ) begin
      \$66  = \$44 [31:0];
    end
    if (start) begin
      \$66  = 32'd0;
    end
    if (\port$1314$0 [3]) begin
      \$66  = 32'd0;
    end
    if (rst) begin
      \$66  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$67  = mac_cycles;
    if (\$signal$634 ) begin
      if (issue) begin
        \$67  = \$48 [31:0];
      end
    end
    if (start) begin
      \$67  = 32'd0;
    end
    if (\port$1314$0 [3]) begin
      \$67  = 32'd0;
    end
    if (rst) begin
      \$67  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$68  = fill_cycles;
    if (\$signal$634 ) begin
      if (issue) begin
      end else if (\$45 ) begin
        \$68  = \$49 [31:0];
      end
    end
    if (start) begin
      \$68  = 32'd0;
    end
    if (\port$1314$0 [3]) begin
      \$68  = 32'd0;
    end
    if (rst) begin
      \$68  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$69  = input_stalls;
    if (\$signal$634 ) begin
      if (issue) begin
      end else if (\$45 ) begin
      end else if (starved) begin
        \$69  = \$50 [31:0];
      end
    end
    if (start) begin
      \$69  = 32'd0;
    end
    if (\port$1314$0 [3]) begin
      \$69  = 32'd0;
    end
    if (rst) begin
      \$69  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$70  = output_stalls;
    if (\$signal$634 ) begin
      if (issue) begin
      end else if (\$45 ) begin
      end else if (starved) begin
      end else if (\$47 ) begin
        \$70  = \$51 [31:0];
      end
    end
    if (start) begin
      \$70  = 32'd0;
    end
    if (\port$1314$0 [3]) begin
      \$70  = 32'd0;
    end
    if (rst) begin
      \$70  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$71  = drain_cycles;
    if (\$signal$634 ) begin
      (* full_case = 32'd1 *)
      if (issue) begin
      end else if (\$45 ) begin
      end else if (starved) begin
      end else if (\$47 ) begin
      end else begin
        \$71  = \$52 [31:0];
      end
    end
    if (start) begin
      \$71  = 32'd0;
    end
    if (\port$1314$0 [3]) begin
      \$71  = 32'd0;
    end
    if (rst) begin
      \$71  = 32'd0;
    end
  end
  assign o__payload = i__payload;
  assign i__ready = o__ready;
  assign o__valid = i__valid;
  assign params__payload = \i__payload$6 ;
  assign \i__ready$9  = params__ready;
  assign params__valid = \i__valid$10 ;
  assign \o__payload$13  = \o__payload$12 ;
  assign \o__ready$15  = \o__ready$14 ;
  assign \o__valid$17  = \o__valid$16 ;
  assign \height$22  = height;
  assign \width$24  = width;
  assign \c_in$26  = c_in;
  assign \c_out$28  = c_out;
  assign \mode$30  = mode;
  assign \weight_base$32  = weight_base;
  assign \requant_base$34  = requant_base;
  assign \words$36  = words;
  assign param_base = base;
  assign loading = params__ready;
  assign \busy$43  = params__ready;
  assign command = \port$1314$0 [2:0];
  assign \shape$61  = shape;
  assign \i__payload$63  = \i__payload$62 ;
  assign \i__ready$65  = \i__ready$64 ;
  assign \i__valid$67  = \i__valid$66 ;
  assign \i__payload$68  = \i__payload$62 [63:0];
  assign \o__payload$69  = \i__payload$62 [63:0];
  assign \i__ready$71  = \o__ready$70 ;
  assign \o__valid$73  = \i__valid$72 ;
  assign \o__payload$75  = \i__payload$74 ;
  assign \i__ready$77  = \o__ready$76 ;
  assign \o__valid$79  = \i__valid$78 ;
  assign \shape$80  = shape;
  assign \shape$81  = shape;
  assign \shape$82  = shape;
  assign beats = shape[147:132];
  assign \width$84  = shape[31:16];
  assign \height$85  = shape[15:0];
  assign \start$86  = start;
  assign \start$87  = start;
  assign \start$88  = start;
  assign \start$89  = start;
  assign beats_per_pixel = shape[147:132];
  assign words_per_pixel = { 2'h0, shape[92:79] };
  assign \beats_per_pixel$92  = shape[163:148];
  assign \retire$94  = retire;
  assign \retire_row$96  = retire_row;
  assign \weight_base$97  = weight_base[9:0];
  assign \requant_base$98  = requant_base[7:0];
  assign read = step[16:0];
  assign \group_written$102  = group_written;
  assign \image_written$104  = image_written;
  assign \credit$106  = credit;
  assign requant_en = write_en;
  assign write = { \$74 , \$73  };
  assign requant = { \$74 , \$73  };
  assign info3 = info;
  assign address = step[26:17];
  assign \write_en$116  = unit_en[0];
  assign \write$118  = { \$74 [647:576], \$72  };
  assign weight = { \$74 [647:576], \$72  };
  assign word = activations;
  assign control2 = control;
  assign \shift$125  = shift;
  assign \chain_o$129  = chain_i;
  assign \address$130  = step[26:17];
  assign \write_en$131  = unit_en[1];
  assign \write$132  = { \$74 [647:576], \$72  };
  assign \activations$133  = activations;
  assign \control$134  = control;
  assign \shift$135  = shift;
  assign \chain_o$138  = \chain_i$137 ;
  assign \address$139  = step[26:17];
  assign \write_en$140  = unit_en[2];
  assign \write$141  = { \$74 [647:576], \$72  };
  assign \activations$142  = activations;
  assign \control$143  = control;
  assign \shift$144  = shift;
  assign \chain_o$147  = \chain_i$146 ;
  assign \address$148  = step[26:17];
  assign \write_en$149  = unit_en[3];
  assign \write$150  = { \$74 [647:576], \$72  };
  assign \activations$151  = activations;
  assign \control$152  = control;
  assign \shift$153  = shift;
  assign \chain_o$156  = \chain_i$155 ;
  assign \address$157  = step[26:17];
  assign \write_en$158  = unit_en[4];
  assign \write$159  = { \$74 [647:576], \$72  };
  assign \activations$160  = activations;
  assign \control$161  = control;
  assign \shift$162  = shift;
  assign \chain_o$164  = \chain_i$163 ;
  assign \address$165  = step[26:17];
  assign \write_en$166  = unit_en[5];
  assign \write$167  = { \$74 [647:576], \$72  };
  assign \activations$168  = activations;
  assign \control$169  = control;
  assign \shift$170  = shift;
  assign \chain_o$172  = \chain_i$171 ;
  assign \address$173  = step[26:17];
  assign \write_en$174  = unit_en[6];
  assign \write$175  = { \$74 [647:576], \$72  };
  assign \activations$176  = activations;
  assign \control$177  = control;
  assign \shift$178  = shift;
  assign \chain_o$180  = \chain_i$179 ;
  assign \address$181  = step[26:17];
  assign \write_en$182  = unit_en[7];
  assign \write$183  = { \$74 [647:576], \$72  };
  assign \activations$184  = activations;
  assign \control$185  = control;
  assign \shift$186  = shift;
  assign \chain_o$188  = \chain_i$187 ;
  assign \address$189  = step[26:17];
  assign \write_en$190  = unit_en[8];
  assign \write$191  = { \$74 [647:576], \$72  };
  assign \activations$192  = activations;
  assign \control$193  = control;
  assign \shift$194  = shift;
  assign \chain_o$196  = \chain_i$195 ;
  assign \address$197  = step[26:17];
  assign \write_en$198  = unit_en[9];
  assign \write$199  = { \$74 [647:576], \$72  };
  assign \activations$200  = activations;
  assign \control$201  = control;
  assign \shift$202  = shift;
  assign \chain_o$204  = \chain_i$203 ;
  assign \address$205  = step[26:17];
  assign \write_en$206  = unit_en[10];
  assign \write$207  = { \$74 [647:576], \$72  };
  assign \activations$208  = activations;
  assign \control$209  = control;
  assign \shift$210  = shift;
  assign \chain_o$212  = \chain_i$211 ;
  assign \address$213  = step[26:17];
  assign \write_en$214  = unit_en[11];
  assign \write$215  = { \$74 [647:576], \$72  };
  assign \activations$216  = activations;
  assign \control$217  = control;
  assign \shift$218  = shift;
  assign \chain_o$220  = \chain_i$219 ;
  assign \address$221  = step[26:17];
  assign \write_en$222  = unit_en[12];
  assign \write$223  = { \$74 [647:576], \$72  };
  assign \activations$224  = activations;
  assign \control$225  = control;
  assign \shift$226  = shift;
  assign \chain_o$228  = \chain_i$227 ;
  assign \address$229  = step[26:17];
  assign \write_en$230  = unit_en[13];
  assign \write$231  = { \$74 [647:576], \$72  };
  assign \activations$232  = activations;
  assign \control$233  = control;
  assign \shift$234  = shift;
  assign \chain_o$236  = \chain_i$235 ;
  assign \address$237  = step[26:17];
  assign \write_en$238  = unit_en[14];
  assign \write$239  = { \$74 [647:576], \$72  };
  assign \activations$240  = activations;
  assign \control$241  = control;
  assign \shift$242  = shift;
  assign \chain_o$244  = \chain_i$243 ;
  assign \address$245  = step[26:17];
  assign \write_en$246  = unit_en[15];
  assign \write$247  = { \$74 [647:576], \$72  };
  assign \activations$248  = activations;
  assign \control$249  = control;
  assign \shift$250  = shift;
  assign \chain_o$252  = \chain_i$251 ;
  assign \address$253  = step[26:17];
  assign \write_en$254  = unit_en[16];
  assign \write$255  = { \$74 [647:576], \$72  };
  assign \activations$256  = activations;
  assign \control$257  = control;
  assign \shift$258  = shift;
  assign \chain_o$260  = \chain_i$259 ;
  assign \address$261  = step[26:17];
  assign \write_en$262  = unit_en[17];
  assign \write$263  = { \$74 [647:576], \$72  };
  assign \activations$264  = activations;
  assign \control$265  = control;
  assign \shift$266  = shift;
  assign \chain_o$268  = \chain_i$267 ;
  assign \address$269  = step[26:17];
  assign \write_en$270  = unit_en[18];
  assign \write$271  = { \$74 [647:576], \$72  };
  assign \activations$272  = activations;
  assign \control$273  = control;
  assign \shift$274  = shift;
  assign \chain_o$276  = \chain_i$275 ;
  assign \address$277  = step[26:17];
  assign \write_en$278  = unit_en[19];
  assign \write$279  = { \$74 [647:576], \$72  };
  assign \activations$280  = activations;
  assign \control$281  = control;
  assign \shift$282  = shift;
  assign \chain_o$284  = \chain_i$283 ;
  assign \address$285  = step[26:17];
  assign \write_en$286  = unit_en[20];
  assign \write$287  = { \$74 [647:576], \$72  };
  assign \activations$288  = activations;
  assign \control$289  = control;
  assign \shift$290  = shift;
  assign \chain_o$292  = \chain_i$291 ;
  assign \address$293  = step[26:17];
  assign \write_en$294  = unit_en[21];
  assign \write$295  = { \$74 [647:576], \$72  };
  assign \activations$296  = activations;
  assign \control$297  = control;
  assign \shift$298  = shift;
  assign \chain_o$300  = \chain_i$299 ;
  assign \address$301  = step[26:17];
  assign \write_en$302  = unit_en[22];
  assign \write$303  = { \$74 [647:576], \$72  };
  assign \activations$304  = activations;
  assign \control$305  = control;
  assign \shift$306  = shift;
  assign \chain_o$308  = \chain_i$307 ;
  assign \address$309  = step[26:17];
  assign \write_en$310  = unit_en[23];
  assign \write$311  = { \$74 [647:576], \$72  };
  assign \activations$312  = activations;
  assign \control$313  = control;
  assign \shift$314  = shift;
  assign \chain_o$316  = \chain_i$315 ;
  assign \address$317  = step[26:17];
  assign \write_en$318  = unit_en[24];
  assign \write$319  = { \$74 [647:576], \$72  };
  assign \activations$320  = activations;
  assign \control$321  = control;
  assign \shift$322  = shift;
  assign \chain_o$324  = \chain_i$323 ;
  assign \address$325  = step[26:17];
  assign \write_en$326  = unit_en[25];
  assign \write$327  = { \$74 [647:576], \$72  };
  assign \activations$328  = activations;
  assign \control$329  = control;
  assign \shift$330  = shift;
  assign \chain_o$332  = \chain_i$331 ;
  assign \address$333  = step[26:17];
  assign \write_en$334  = unit_en[26];
  assign \write$335  = { \$74 [647:576], \$72  };
  assign \activations$336  = activations;
  assign \control$337  = control;
  assign \shift$338  = shift;
  assign \chain_o$340  = \chain_i$339 ;
  assign \address$341  = step[26:17];
  assign \write_en$342  = unit_en[27];
  assign \write$343  = { \$74 [647:576], \$72  };
  assign \activations$344  = activations;
  assign \control$345  = control;
  assign \shift$346  = shift;
  assign \chain_o$348  = \chain_i$347 ;
  assign \address$349  = step[26:17];
  assign \write_en$350  = unit_en[28];
  assign \write$351  = { \$74 [647:576], \$72  };
  assign \activations$352  = activations;
  assign \control$353  = control;
  assign \shift$354  = shift;
  assign \chain_o$356  = \chain_i$355 ;
  assign \address$357  = step[26:17];
  assign \write_en$358  = unit_en[29];
  assign \write$359  = { \$74 [647:576], \$72  };
  assign \activations$360  = activations;
  assign \control$361  = control;
  assign \shift$362  = shift;
  assign \chain_o$364  = \chain_i$363 ;
  assign \address$365  = step[26:17];
  assign \write_en$366  = unit_en[30];
  assign \write$367  = { \$74 [647:576], \$72  };
  assign \activations$368  = activations;
  assign \control$369  = control;
  assign \shift$370  = shift;
  assign \chain_o$372  = \chain_i$371 ;
  assign \address$373  = step[26:17];
  assign \write_en$374  = unit_en[31];
  assign \write$375  = { \$74 [647:576], \$72  };
  assign \activations$376  = activations;
  assign \control$377  = control;
  assign \shift$378  = shift;
  assign \chain_o$380  = \chain_i$379 ;
  assign \address$381  = step[26:17];
  assign \write_en$382  = unit_en[32];
  assign \write$383  = { \$74 [647:576], \$72  };
  assign \activations$384  = activations;
  assign \control$385  = control;
  assign \shift$386  = shift;
  assign \chain_o$388  = \chain_i$387 ;
  assign \address$389  = step[26:17];
  assign \write_en$390  = unit_en[33];
  assign \write$391  = { \$74 [647:576], \$72  };
  assign \activations$392  = activations;
  assign \control$393  = control;
  assign \shift$394  = shift;
  assign \chain_o$396  = \chain_i$395 ;
  assign \address$397  = step[26:17];
  assign \write_en$398  = unit_en[34];
  assign \write$399  = { \$74 [647:576], \$72  };
  assign \activations$400  = activations;
  assign \control$401  = control;
  assign \shift$402  = shift;
  assign \chain_o$404  = \chain_i$403 ;
  assign \address$405  = step[26:17];
  assign \write_en$406  = unit_en[35];
  assign \write$407  = { \$74 [647:576], \$72  };
  assign \activations$408  = activations;
  assign \control$409  = control;
  assign \shift$410  = shift;
  assign \chain_o$412  = \chain_i$411 ;
  assign \address$413  = step[26:17];
  assign \write_en$414  = unit_en[36];
  assign \write$415  = { \$74 [647:576], \$72  };
  assign \activations$416  = activations;
  assign \control$417  = control;
  assign \shift$418  = shift;
  assign \chain_o$420  = \chain_i$419 ;
  assign \address$421  = step[26:17];
  assign \write_en$422  = unit_en[37];
  assign \write$423  = { \$74 [647:576], \$72  };
  assign \activations$424  = activations;
  assign \control$425  = control;
  assign \shift$426  = shift;
  assign \chain_o$428  = \chain_i$427 ;
  assign \address$429  = step[26:17];
  assign \write_en$430  = unit_en[38];
  assign \write$431  = { \$74 [647:576], \$72  };
  assign \activations$432  = activations;
  assign \control$433  = control;
  assign \shift$434  = shift;
  assign \chain_o$436  = \chain_i$435 ;
  assign \address$437  = step[26:17];
  assign \write_en$438  = unit_en[39];
  assign \write$439  = { \$74 [647:576], \$72  };
  assign \activations$440  = activations;
  assign \control$441  = control;
  assign \shift$442  = shift;
  assign \chain_o$444  = \chain_i$443 ;
  assign \address$445  = step[26:17];
  assign \write_en$446  = unit_en[40];
  assign \write$447  = { \$74 [647:576], \$72  };
  assign \activations$448  = activations;
  assign \control$449  = control;
  assign \shift$450  = shift;
  assign \chain_o$452  = \chain_i$451 ;
  assign \address$453  = step[26:17];
  assign \write_en$454  = unit_en[41];
  assign \write$455  = { \$74 [647:576], \$72  };
  assign \activations$456  = activations;
  assign \control$457  = control;
  assign \shift$458  = shift;
  assign \chain_o$460  = \chain_i$459 ;
  assign \address$461  = step[26:17];
  assign \write_en$462  = unit_en[42];
  assign \write$463  = { \$74 [647:576], \$72  };
  assign \activations$464  = activations;
  assign \control$465  = control;
  assign \shift$466  = shift;
  assign \chain_o$468  = \chain_i$467 ;
  assign \address$469  = step[26:17];
  assign \write_en$470  = unit_en[43];
  assign \write$471  = { \$74 [647:576], \$72  };
  assign \activations$472  = activations;
  assign \control$473  = control;
  assign \shift$474  = shift;
  assign \chain_o$476  = \chain_i$475 ;
  assign \address$477  = step[26:17];
  assign \write_en$478  = unit_en[44];
  assign \write$479  = { \$74 [647:576], \$72  };
  assign \activations$480  = activations;
  assign \control$481  = control;
  assign \shift$482  = shift;
  assign \chain_o$484  = \chain_i$483 ;
  assign \address$485  = step[26:17];
  assign \write_en$486  = unit_en[45];
  assign \write$487  = { \$74 [647:576], \$72  };
  assign \activations$488  = activations;
  assign \control$489  = control;
  assign \shift$490  = shift;
  assign \chain_o$492  = \chain_i$491 ;
  assign \address$493  = step[26:17];
  assign \write_en$494  = unit_en[46];
  assign \write$495  = { \$74 [647:576], \$72  };
  assign \activations$496  = activations;
  assign \control$497  = control;
  assign \shift$498  = shift;
  assign \chain_o$500  = \chain_i$499 ;
  assign \address$501  = step[26:17];
  assign \write_en$502  = unit_en[47];
  assign \write$503  = { \$74 [647:576], \$72  };
  assign \activations$504  = activations;
  assign \control$505  = control;
  assign \shift$506  = shift;
  assign \chain_o$508  = \chain_i$507 ;
  assign \address$509  = step[26:17];
  assign \write_en$510  = unit_en[48];
  assign \write$511  = { \$74 [647:576], \$72  };
  assign \activations$512  = activations;
  assign \control$513  = control;
  assign \shift$514  = shift;
  assign \chain_o$516  = \chain_i$515 ;
  assign \address$517  = step[26:17];
  assign \write_en$518  = unit_en[49];
  assign \write$519  = { \$74 [647:576], \$72  };
  assign \activations$520  = activations;
  assign \control$521  = control;
  assign \shift$522  = shift;
  assign \chain_o$524  = \chain_i$523 ;
  assign \address$525  = step[26:17];
  assign \write_en$526  = unit_en[50];
  assign \write$527  = { \$74 [647:576], \$72  };
  assign \activations$528  = activations;
  assign \control$529  = control;
  assign \shift$530  = shift;
  assign \chain_o$532  = \chain_i$531 ;
  assign \address$533  = step[26:17];
  assign \write_en$534  = unit_en[51];
  assign \write$535  = { \$74 [647:576], \$72  };
  assign \activations$536  = activations;
  assign \control$537  = control;
  assign \shift$538  = shift;
  assign \chain_o$540  = \chain_i$539 ;
  assign \address$541  = step[26:17];
  assign \write_en$542  = unit_en[52];
  assign \write$543  = { \$74 [647:576], \$72  };
  assign \activations$544  = activations;
  assign \control$545  = control;
  assign \shift$546  = shift;
  assign \chain_o$548  = \chain_i$547 ;
  assign \address$549  = step[26:17];
  assign \write_en$550  = unit_en[53];
  assign \write$551  = { \$74 [647:576], \$72  };
  assign \activations$552  = activations;
  assign \control$553  = control;
  assign \shift$554  = shift;
  assign \chain_o$556  = \chain_i$555 ;
  assign \address$557  = step[26:17];
  assign \write_en$558  = unit_en[54];
  assign \write$559  = { \$74 [647:576], \$72  };
  assign \activations$560  = activations;
  assign \control$561  = control;
  assign \shift$562  = shift;
  assign \chain_o$564  = \chain_i$563 ;
  assign \address$565  = step[26:17];
  assign \write_en$566  = unit_en[55];
  assign \write$567  = { \$74 [647:576], \$72  };
  assign \activations$568  = activations;
  assign \control$569  = control;
  assign \shift$570  = shift;
  assign \chain_o$572  = \chain_i$571 ;
  assign \address$573  = step[26:17];
  assign \write_en$574  = unit_en[56];
  assign \write$575  = { \$74 [647:576], \$72  };
  assign \activations$576  = activations;
  assign \control$577  = control;
  assign \shift$578  = shift;
  assign \chain_o$580  = \chain_i$579 ;
  assign \address$581  = step[26:17];
  assign \write_en$582  = unit_en[57];
  assign \write$583  = { \$74 [647:576], \$72  };
  assign \activations$584  = activations;
  assign \control$585  = control;
  assign \shift$586  = shift;
  assign \chain_o$588  = \chain_i$587 ;
  assign \address$589  = step[26:17];
  assign \write_en$590  = unit_en[58];
  assign \write$591  = { \$74 [647:576], \$72  };
  assign \activations$592  = activations;
  assign \control$593  = control;
  assign \shift$594  = shift;
  assign \chain_o$596  = \chain_i$595 ;
  assign \address$597  = step[26:17];
  assign \write_en$598  = unit_en[59];
  assign \write$599  = { \$74 [647:576], \$72  };
  assign \activations$600  = activations;
  assign \control$601  = control;
  assign \shift$602  = shift;
  assign \chain_o$604  = \chain_i$603 ;
  assign \address$605  = step[26:17];
  assign \write_en$606  = unit_en[60];
  assign \write$607  = { \$74 [647:576], \$72  };
  assign \activations$608  = activations;
  assign \control$609  = control;
  assign \shift$610  = shift;
  assign \chain_i$611  = chain_o;
  assign \address$612  = step[26:17];
  assign \write_en$613  = unit_en[61];
  assign \write$614  = { \$74 [647:576], \$72  };
  assign \activations$615  = activations;
  assign \control$616  = control;
  assign \shift$617  = shift;
  assign \chain_i$618  = \chain_o$136 ;
  assign \address$619  = step[26:17];
  assign \write_en$620  = unit_en[62];
  assign \write$621  = { \$74 [647:576], \$72  };
  assign \activations$622  = activations;
  assign \control$623  = control;
  assign \shift$624  = shift;
  assign \chain_i$625  = \chain_o$145 ;
  assign \address$626  = step[26:17];
  assign \write_en$627  = unit_en[63];
  assign \write$628  = { \$74 [647:576], \$72  };
  assign \activations$629  = activations;
  assign \control$630  = control;
  assign \shift$631  = shift;
  assign \chain_i$632  = \chain_o$154 ;
  assign soft_reset = \port$1314$0 [3];
  assign \i__payload.data  = i__payload[47:0];
  assign \i__payload.pixel_last  = i__payload[48];
  assign \i__payload.last  = i__payload[49];
  assign \o__payload.data  = i__payload[47:0];
  assign \o__payload.pixel_last  = i__payload[48];
  assign \o__payload.last  = i__payload[49];
  assign \i__payload$6.data  = \i__payload$6 [63:0];
  assign \i__payload$6.last  = \i__payload$6 [64];
  assign \params__payload.data  = \i__payload$6 [63:0];
  assign \params__payload.last  = \i__payload$6 [64];
  assign \o__payload$12.data  = \o__payload$12 [63:0];
  assign \o__payload$12.last  = \o__payload$12 [64];
  assign \o__payload$13.data  = \o__payload$12 [63:0];
  assign \o__payload$13.last  = \o__payload$12 [64];
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
  assign \shape.packed  = shape[166];
  assign \shape.biased  = shape[167];
  assign \shape.residual  = shape[168];
  assign \shape.out_width  = shape[184:169];
  assign \shape.beats_residual  = shape[200:185];
  assign \shape$61.height  = shape[15:0];
  assign \shape$61.width  = shape[31:16];
  assign \shape$61.out_height  = shape[47:32];
  assign \shape$61.groups  = shape[62:48];
  assign \shape$61.tail  = shape[64:63];
  assign \shape$61.blocks  = shape[78:65];
  assign \shape$61.ingest_words  = shape[92:79];
  assign \shape$61.column_words  = shape[107:93];
  assign \shape$61.tiles  = shape[119:108];
  assign \shape$61.output_words  = shape[131:120];
  assign \shape$61.beats_in  = shape[147:132];
  assign \shape$61.beats_out  = shape[163:148];
  assign \shape$61.pointwise  = shape[164];
  assign \shape$61.halved  = shape[165];
  assign \shape$61.packed  = shape[166];
  assign \shape$61.biased  = shape[167];
  assign \shape$61.residual  = shape[168];
  assign \shape$61.out_width  = shape[184:169];
  assign \shape$61.beats_residual  = shape[200:185];
  assign \i__payload$62.data  = \i__payload$62 [63:0];
  assign \i__payload$62.last  = \i__payload$62 [64];
  assign \i__payload$63.data  = \i__payload$62 [63:0];
  assign \i__payload$63.last  = \i__payload$62 [64];
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
  assign \shape$80.packed  = shape[166];
  assign \shape$80.biased  = shape[167];
  assign \shape$80.residual  = shape[168];
  assign \shape$80.out_width  = shape[184:169];
  assign \shape$80.beats_residual  = shape[200:185];
  assign \shape$81.height  = shape[15:0];
  assign \shape$81.width  = shape[31:16];
  assign \shape$81.out_height  = shape[47:32];
  assign \shape$81.groups  = shape[62:48];
  assign \shape$81.tail  = shape[64:63];
  assign \shape$81.blocks  = shape[78:65];
  assign \shape$81.ingest_words  = shape[92:79];
  assign \shape$81.column_words  = shape[107:93];
  assign \shape$81.tiles  = shape[119:108];
  assign \shape$81.output_words  = shape[131:120];
  assign \shape$81.beats_in  = shape[147:132];
  assign \shape$81.beats_out  = shape[163:148];
  assign \shape$81.pointwise  = shape[164];
  assign \shape$81.halved  = shape[165];
  assign \shape$81.packed  = shape[166];
  assign \shape$81.biased  = shape[167];
  assign \shape$81.residual  = shape[168];
  assign \shape$81.out_width  = shape[184:169];
  assign \shape$81.beats_residual  = shape[200:185];
  assign \shape$82.height  = shape[15:0];
  assign \shape$82.width  = shape[31:16];
  assign \shape$82.out_height  = shape[47:32];
  assign \shape$82.groups  = shape[62:48];
  assign \shape$82.tail  = shape[64:63];
  assign \shape$82.blocks  = shape[78:65];
  assign \shape$82.ingest_words  = shape[92:79];
  assign \shape$82.column_words  = shape[107:93];
  assign \shape$82.tiles  = shape[119:108];
  assign \shape$82.output_words  = shape[131:120];
  assign \shape$82.beats_in  = shape[147:132];
  assign \shape$82.beats_out  = shape[163:148];
  assign \shape$82.pointwise  = shape[164];
  assign \shape$82.halved  = shape[165];
  assign \shape$82.packed  = shape[166];
  assign \shape$82.biased  = shape[167];
  assign \shape$82.residual  = shape[168];
  assign \shape$82.out_width  = shape[184:169];
  assign \shape$82.beats_residual  = shape[200:185];
  assign \read.slot  = step[1:0];
  assign \read.address  = step[9:2];
  assign \read.bank  = step[10];
  assign \read.mask  = step[14:11];
  assign \read.apart  = step[15];
  assign \read.inner  = step[16];
  assign \step.read  = step[16:0];
  assign \step.read.slot  = step[1:0];
  assign \step.read.address  = step[9:2];
  assign \step.read.bank  = step[10];
  assign \step.read.mask  = step[14:11];
  assign \step.read.apart  = step[15];
  assign \step.read.inner  = step[16];
  assign \step.weight  = step[26:17];
  assign \step.control  = step[36:27];
  assign \step.control.en  = step[27];
  assign \step.control.first  = step[28];
  assign \step.control.carried  = step[29];
  assign \step.control.last  = step[30];
  assign \step.control.edge  = step[31];
  assign \step.control.tile  = step[35:32];
  assign \step.control.unload  = step[36];
  assign \step.info  = step[50:37];
  assign \step.info.tile  = step[40:37];
  assign \step.info.tile_last  = step[41];
  assign \step.info.slots  = step[45:42];
  assign \step.info.edge  = step[46];
  assign \step.info.image_last  = step[47];
  assign \step.info.triple  = step[48];
  assign \step.info.inner  = step[49];
  assign \step.info.unloaded  = step[50];
  assign \write.addr  = \$73 ;
  assign \write.data  = \$74 ;
  assign \requant.addr  = \$73 ;
  assign \requant.data  = \$74 ;
  assign \control3.en  = control3[0];
  assign \control3.first  = control3[1];
  assign \control3.carried  = control3[2];
  assign \control3.last  = control3[3];
  assign \control3.edge  = control3[4];
  assign \control3.tile  = control3[8:5];
  assign \control3.unload  = control3[9];
  assign \info.tile  = info[3:0];
  assign \info.tile_last  = info[4];
  assign \info.slots  = info[8:5];
  assign \info.edge  = info[9];
  assign \info.image_last  = info[10];
  assign \info.triple  = info[11];
  assign \info.inner  = info[12];
  assign \info.unloaded  = info[13];
  assign \info3.tile  = info[3:0];
  assign \info3.tile_last  = info[4];
  assign \info3.slots  = info[8:5];
  assign \info3.edge  = info[9];
  assign \info3.image_last  = info[10];
  assign \info3.triple  = info[11];
  assign \info3.inner  = info[12];
  assign \info3.unloaded  = info[13];
  assign \write$118.addr  = \$72 ;
  assign \write$118.data  = \$74 [647:576];
  assign \weight.addr  = \$72 ;
  assign \weight.data  = \$74 [647:576];
  assign \control.en  = control[0];
  assign \control.first  = control[1];
  assign \control.carried  = control[2];
  assign \control.last  = control[3];
  assign \control.edge  = control[4];
  assign \control.tile  = control[8:5];
  assign \control.unload  = control[9];
  assign \control2.en  = control[0];
  assign \control2.first  = control[1];
  assign \control2.carried  = control[2];
  assign \control2.last  = control[3];
  assign \control2.edge  = control[4];
  assign \control2.tile  = control[8:5];
  assign \control2.unload  = control[9];
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
  assign \chain_o$129[0]  = chain_i[18:0];
  assign \chain_o$129[1]  = chain_i[37:19];
  assign \chain_o$129[2]  = chain_i[56:38];
  assign \chain_o$129[3]  = chain_i[75:57];
  assign \write$132.addr  = \$72 ;
  assign \write$132.data  = \$74 [647:576];
  assign \control$134.en  = control[0];
  assign \control$134.first  = control[1];
  assign \control$134.carried  = control[2];
  assign \control$134.last  = control[3];
  assign \control$134.edge  = control[4];
  assign \control$134.tile  = control[8:5];
  assign \control$134.unload  = control[9];
  assign \chain_o$136[0]  = \chain_o$136 [18:0];
  assign \chain_o$136[1]  = \chain_o$136 [37:19];
  assign \chain_o$136[2]  = \chain_o$136 [56:38];
  assign \chain_o$136[3]  = \chain_o$136 [75:57];
  assign \chain_i$137[0]  = \chain_i$137 [18:0];
  assign \chain_i$137[1]  = \chain_i$137 [37:19];
  assign \chain_i$137[2]  = \chain_i$137 [56:38];
  assign \chain_i$137[3]  = \chain_i$137 [75:57];
  assign \chain_o$138[0]  = \chain_i$137 [18:0];
  assign \chain_o$138[1]  = \chain_i$137 [37:19];
  assign \chain_o$138[2]  = \chain_i$137 [56:38];
  assign \chain_o$138[3]  = \chain_i$137 [75:57];
  assign \write$141.addr  = \$72 ;
  assign \write$141.data  = \$74 [647:576];
  assign \control$143.en  = control[0];
  assign \control$143.first  = control[1];
  assign \control$143.carried  = control[2];
  assign \control$143.last  = control[3];
  assign \control$143.edge  = control[4];
  assign \control$143.tile  = control[8:5];
  assign \control$143.unload  = control[9];
  assign \chain_o$145[0]  = \chain_o$145 [18:0];
  assign \chain_o$145[1]  = \chain_o$145 [37:19];
  assign \chain_o$145[2]  = \chain_o$145 [56:38];
  assign \chain_o$145[3]  = \chain_o$145 [75:57];
  assign \chain_i$146[0]  = \chain_i$146 [18:0];
  assign \chain_i$146[1]  = \chain_i$146 [37:19];
  assign \chain_i$146[2]  = \chain_i$146 [56:38];
  assign \chain_i$146[3]  = \chain_i$146 [75:57];
  assign \chain_o$147[0]  = \chain_i$146 [18:0];
  assign \chain_o$147[1]  = \chain_i$146 [37:19];
  assign \chain_o$147[2]  = \chain_i$146 [56:38];
  assign \chain_o$147[3]  = \chain_i$146 [75:57];
  assign \write$150.addr  = \$72 ;
  assign \write$150.data  = \$74 [647:576];
  assign \control$152.en  = control[0];
  assign \control$152.first  = control[1];
  assign \control$152.carried  = control[2];
  assign \control$152.last  = control[3];
  assign \control$152.edge  = control[4];
  assign \control$152.tile  = control[8:5];
  assign \control$152.unload  = control[9];
  assign \chain_o$154[0]  = \chain_o$154 [18:0];
  assign \chain_o$154[1]  = \chain_o$154 [37:19];
  assign \chain_o$154[2]  = \chain_o$154 [56:38];
  assign \chain_o$154[3]  = \chain_o$154 [75:57];
  assign \chain_i$155[0]  = \chain_i$155 [18:0];
  assign \chain_i$155[1]  = \chain_i$155 [37:19];
  assign \chain_i$155[2]  = \chain_i$155 [56:38];
  assign \chain_i$155[3]  = \chain_i$155 [75:57];
  assign \chain_o$156[0]  = \chain_i$155 [18:0];
  assign \chain_o$156[1]  = \chain_i$155 [37:19];
  assign \chain_o$156[2]  = \chain_i$155 [56:38];
  assign \chain_o$156[3]  = \chain_i$155 [75:57];
  assign \write$159.addr  = \$72 ;
  assign \write$159.data  = \$74 [647:576];
  assign \control$161.en  = control[0];
  assign \control$161.first  = control[1];
  assign \control$161.carried  = control[2];
  assign \control$161.last  = control[3];
  assign \control$161.edge  = control[4];
  assign \control$161.tile  = control[8:5];
  assign \control$161.unload  = control[9];
  assign \chain_i$163[0]  = \chain_i$163 [18:0];
  assign \chain_i$163[1]  = \chain_i$163 [37:19];
  assign \chain_i$163[2]  = \chain_i$163 [56:38];
  assign \chain_i$163[3]  = \chain_i$163 [75:57];
  assign \chain_o$164[0]  = \chain_i$163 [18:0];
  assign \chain_o$164[1]  = \chain_i$163 [37:19];
  assign \chain_o$164[2]  = \chain_i$163 [56:38];
  assign \chain_o$164[3]  = \chain_i$163 [75:57];
  assign \write$167.addr  = \$72 ;
  assign \write$167.data  = \$74 [647:576];
  assign \control$169.en  = control[0];
  assign \control$169.first  = control[1];
  assign \control$169.carried  = control[2];
  assign \control$169.last  = control[3];
  assign \control$169.edge  = control[4];
  assign \control$169.tile  = control[8:5];
  assign \control$169.unload  = control[9];
  assign \chain_i$171[0]  = \chain_i$171 [18:0];
  assign \chain_i$171[1]  = \chain_i$171 [37:19];
  assign \chain_i$171[2]  = \chain_i$171 [56:38];
  assign \chain_i$171[3]  = \chain_i$171 [75:57];
  assign \chain_o$172[0]  = \chain_i$171 [18:0];
  assign \chain_o$172[1]  = \chain_i$171 [37:19];
  assign \chain_o$172[2]  = \chain_i$171 [56:38];
  assign \chain_o$172[3]  = \chain_i$171 [75:57];
  assign \write$175.addr  = \$72 ;
  assign \write$175.data  = \$74 [647:576];
  assign \control$177.en  = control[0];
  assign \control$177.first  = control[1];
  assign \control$177.carried  = control[2];
  assign \control$177.last  = control[3];
  assign \control$177.edge  = control[4];
  assign \control$177.tile  = control[8:5];
  assign \control$177.unload  = control[9];
  assign \chain_i$179[0]  = \chain_i$179 [18:0];
  assign \chain_i$179[1]  = \chain_i$179 [37:19];
  assign \chain_i$179[2]  = \chain_i$179 [56:38];
  assign \chain_i$179[3]  = \chain_i$179 [75:57];
  assign \chain_o$180[0]  = \chain_i$179 [18:0];
  assign \chain_o$180[1]  = \chain_i$179 [37:19];
  assign \chain_o$180[2]  = \chain_i$179 [56:38];
  assign \chain_o$180[3]  = \chain_i$179 [75:57];
  assign \write$183.addr  = \$72 ;
  assign \write$183.data  = \$74 [647:576];
  assign \control$185.en  = control[0];
  assign \control$185.first  = control[1];
  assign \control$185.carried  = control[2];
  assign \control$185.last  = control[3];
  assign \control$185.edge  = control[4];
  assign \control$185.tile  = control[8:5];
  assign \control$185.unload  = control[9];
  assign \chain_i$187[0]  = \chain_i$187 [18:0];
  assign \chain_i$187[1]  = \chain_i$187 [37:19];
  assign \chain_i$187[2]  = \chain_i$187 [56:38];
  assign \chain_i$187[3]  = \chain_i$187 [75:57];
  assign \chain_o$188[0]  = \chain_i$187 [18:0];
  assign \chain_o$188[1]  = \chain_i$187 [37:19];
  assign \chain_o$188[2]  = \chain_i$187 [56:38];
  assign \chain_o$188[3]  = \chain_i$187 [75:57];
  assign \write$191.addr  = \$72 ;
  assign \write$191.data  = \$74 [647:576];
  assign \control$193.en  = control[0];
  assign \control$193.first  = control[1];
  assign \control$193.carried  = control[2];
  assign \control$193.last  = control[3];
  assign \control$193.edge  = control[4];
  assign \control$193.tile  = control[8:5];
  assign \control$193.unload  = control[9];
  assign \chain_i$195[0]  = \chain_i$195 [18:0];
  assign \chain_i$195[1]  = \chain_i$195 [37:19];
  assign \chain_i$195[2]  = \chain_i$195 [56:38];
  assign \chain_i$195[3]  = \chain_i$195 [75:57];
  assign \chain_o$196[0]  = \chain_i$195 [18:0];
  assign \chain_o$196[1]  = \chain_i$195 [37:19];
  assign \chain_o$196[2]  = \chain_i$195 [56:38];
  assign \chain_o$196[3]  = \chain_i$195 [75:57];
  assign \write$199.addr  = \$72 ;
  assign \write$199.data  = \$74 [647:576];
  assign \control$201.en  = control[0];
  assign \control$201.first  = control[1];
  assign \control$201.carried  = control[2];
  assign \control$201.last  = control[3];
  assign \control$201.edge  = control[4];
  assign \control$201.tile  = control[8:5];
  assign \control$201.unload  = control[9];
  assign \chain_i$203[0]  = \chain_i$203 [18:0];
  assign \chain_i$203[1]  = \chain_i$203 [37:19];
  assign \chain_i$203[2]  = \chain_i$203 [56:38];
  assign \chain_i$203[3]  = \chain_i$203 [75:57];
  assign \chain_o$204[0]  = \chain_i$203 [18:0];
  assign \chain_o$204[1]  = \chain_i$203 [37:19];
  assign \chain_o$204[2]  = \chain_i$203 [56:38];
  assign \chain_o$204[3]  = \chain_i$203 [75:57];
  assign \write$207.addr  = \$72 ;
  assign \write$207.data  = \$74 [647:576];
  assign \control$209.en  = control[0];
  assign \control$209.first  = control[1];
  assign \control$209.carried  = control[2];
  assign \control$209.last  = control[3];
  assign \control$209.edge  = control[4];
  assign \control$209.tile  = control[8:5];
  assign \control$209.unload  = control[9];
  assign \chain_i$211[0]  = \chain_i$211 [18:0];
  assign \chain_i$211[1]  = \chain_i$211 [37:19];
  assign \chain_i$211[2]  = \chain_i$211 [56:38];
  assign \chain_i$211[3]  = \chain_i$211 [75:57];
  assign \chain_o$212[0]  = \chain_i$211 [18:0];
  assign \chain_o$212[1]  = \chain_i$211 [37:19];
  assign \chain_o$212[2]  = \chain_i$211 [56:38];
  assign \chain_o$212[3]  = \chain_i$211 [75:57];
  assign \write$215.addr  = \$72 ;
  assign \write$215.data  = \$74 [647:576];
  assign \control$217.en  = control[0];
  assign \control$217.first  = control[1];
  assign \control$217.carried  = control[2];
  assign \control$217.last  = control[3];
  assign \control$217.edge  = control[4];
  assign \control$217.tile  = control[8:5];
  assign \control$217.unload  = control[9];
  assign \chain_i$219[0]  = \chain_i$219 [18:0];
  assign \chain_i$219[1]  = \chain_i$219 [37:19];
  assign \chain_i$219[2]  = \chain_i$219 [56:38];
  assign \chain_i$219[3]  = \chain_i$219 [75:57];
  assign \chain_o$220[0]  = \chain_i$219 [18:0];
  assign \chain_o$220[1]  = \chain_i$219 [37:19];
  assign \chain_o$220[2]  = \chain_i$219 [56:38];
  assign \chain_o$220[3]  = \chain_i$219 [75:57];
  assign \write$223.addr  = \$72 ;
  assign \write$223.data  = \$74 [647:576];
  assign \control$225.en  = control[0];
  assign \control$225.first  = control[1];
  assign \control$225.carried  = control[2];
  assign \control$225.last  = control[3];
  assign \control$225.edge  = control[4];
  assign \control$225.tile  = control[8:5];
  assign \control$225.unload  = control[9];
  assign \chain_i$227[0]  = \chain_i$227 [18:0];
  assign \chain_i$227[1]  = \chain_i$227 [37:19];
  assign \chain_i$227[2]  = \chain_i$227 [56:38];
  assign \chain_i$227[3]  = \chain_i$227 [75:57];
  assign \chain_o$228[0]  = \chain_i$227 [18:0];
  assign \chain_o$228[1]  = \chain_i$227 [37:19];
  assign \chain_o$228[2]  = \chain_i$227 [56:38];
  assign \chain_o$228[3]  = \chain_i$227 [75:57];
  assign \write$231.addr  = \$72 ;
  assign \write$231.data  = \$74 [647:576];
  assign \control$233.en  = control[0];
  assign \control$233.first  = control[1];
  assign \control$233.carried  = control[2];
  assign \control$233.last  = control[3];
  assign \control$233.edge  = control[4];
  assign \control$233.tile  = control[8:5];
  assign \control$233.unload  = control[9];
  assign \chain_i$235[0]  = \chain_i$235 [18:0];
  assign \chain_i$235[1]  = \chain_i$235 [37:19];
  assign \chain_i$235[2]  = \chain_i$235 [56:38];
  assign \chain_i$235[3]  = \chain_i$235 [75:57];
  assign \chain_o$236[0]  = \chain_i$235 [18:0];
  assign \chain_o$236[1]  = \chain_i$235 [37:19];
  assign \chain_o$236[2]  = \chain_i$235 [56:38];
  assign \chain_o$236[3]  = \chain_i$235 [75:57];
  assign \write$239.addr  = \$72 ;
  assign \write$239.data  = \$74 [647:576];
  assign \control$241.en  = control[0];
  assign \control$241.first  = control[1];
  assign \control$241.carried  = control[2];
  assign \control$241.last  = control[3];
  assign \control$241.edge  = control[4];
  assign \control$241.tile  = control[8:5];
  assign \control$241.unload  = control[9];
  assign \chain_i$243[0]  = \chain_i$243 [18:0];
  assign \chain_i$243[1]  = \chain_i$243 [37:19];
  assign \chain_i$243[2]  = \chain_i$243 [56:38];
  assign \chain_i$243[3]  = \chain_i$243 [75:57];
  assign \chain_o$244[0]  = \chain_i$243 [18:0];
  assign \chain_o$244[1]  = \chain_i$243 [37:19];
  assign \chain_o$244[2]  = \chain_i$243 [56:38];
  assign \chain_o$244[3]  = \chain_i$243 [75:57];
  assign \write$247.addr  = \$72 ;
  assign \write$247.data  = \$74 [647:576];
  assign \control$249.en  = control[0];
  assign \control$249.first  = control[1];
  assign \control$249.carried  = control[2];
  assign \control$249.last  = control[3];
  assign \control$249.edge  = control[4];
  assign \control$249.tile  = control[8:5];
  assign \control$249.unload  = control[9];
  assign \chain_i$251[0]  = \chain_i$251 [18:0];
  assign \chain_i$251[1]  = \chain_i$251 [37:19];
  assign \chain_i$251[2]  = \chain_i$251 [56:38];
  assign \chain_i$251[3]  = \chain_i$251 [75:57];
  assign \chain_o$252[0]  = \chain_i$251 [18:0];
  assign \chain_o$252[1]  = \chain_i$251 [37:19];
  assign \chain_o$252[2]  = \chain_i$251 [56:38];
  assign \chain_o$252[3]  = \chain_i$251 [75:57];
  assign \write$255.addr  = \$72 ;
  assign \write$255.data  = \$74 [647:576];
  assign \control$257.en  = control[0];
  assign \control$257.first  = control[1];
  assign \control$257.carried  = control[2];
  assign \control$257.last  = control[3];
  assign \control$257.edge  = control[4];
  assign \control$257.tile  = control[8:5];
  assign \control$257.unload  = control[9];
  assign \chain_i$259[0]  = \chain_i$259 [18:0];
  assign \chain_i$259[1]  = \chain_i$259 [37:19];
  assign \chain_i$259[2]  = \chain_i$259 [56:38];
  assign \chain_i$259[3]  = \chain_i$259 [75:57];
  assign \chain_o$260[0]  = \chain_i$259 [18:0];
  assign \chain_o$260[1]  = \chain_i$259 [37:19];
  assign \chain_o$260[2]  = \chain_i$259 [56:38];
  assign \chain_o$260[3]  = \chain_i$259 [75:57];
  assign \write$263.addr  = \$72 ;
  assign \write$263.data  = \$74 [647:576];
  assign \control$265.en  = control[0];
  assign \control$265.first  = control[1];
  assign \control$265.carried  = control[2];
  assign \control$265.last  = control[3];
  assign \control$265.edge  = control[4];
  assign \control$265.tile  = control[8:5];
  assign \control$265.unload  = control[9];
  assign \chain_i$267[0]  = \chain_i$267 [18:0];
  assign \chain_i$267[1]  = \chain_i$267 [37:19];
  assign \chain_i$267[2]  = \chain_i$267 [56:38];
  assign \chain_i$267[3]  = \chain_i$267 [75:57];
  assign \chain_o$268[0]  = \chain_i$267 [18:0];
  assign \chain_o$268[1]  = \chain_i$267 [37:19];
  assign \chain_o$268[2]  = \chain_i$267 [56:38];
  assign \chain_o$268[3]  = \chain_i$267 [75:57];
  assign \write$271.addr  = \$72 ;
  assign \write$271.data  = \$74 [647:576];
  assign \control$273.en  = control[0];
  assign \control$273.first  = control[1];
  assign \control$273.carried  = control[2];
  assign \control$273.last  = control[3];
  assign \control$273.edge  = control[4];
  assign \control$273.tile  = control[8:5];
  assign \control$273.unload  = control[9];
  assign \chain_i$275[0]  = \chain_i$275 [18:0];
  assign \chain_i$275[1]  = \chain_i$275 [37:19];
  assign \chain_i$275[2]  = \chain_i$275 [56:38];
  assign \chain_i$275[3]  = \chain_i$275 [75:57];
  assign \chain_o$276[0]  = \chain_i$275 [18:0];
  assign \chain_o$276[1]  = \chain_i$275 [37:19];
  assign \chain_o$276[2]  = \chain_i$275 [56:38];
  assign \chain_o$276[3]  = \chain_i$275 [75:57];
  assign \write$279.addr  = \$72 ;
  assign \write$279.data  = \$74 [647:576];
  assign \control$281.en  = control[0];
  assign \control$281.first  = control[1];
  assign \control$281.carried  = control[2];
  assign \control$281.last  = control[3];
  assign \control$281.edge  = control[4];
  assign \control$281.tile  = control[8:5];
  assign \control$281.unload  = control[9];
  assign \chain_i$283[0]  = \chain_i$283 [18:0];
  assign \chain_i$283[1]  = \chain_i$283 [37:19];
  assign \chain_i$283[2]  = \chain_i$283 [56:38];
  assign \chain_i$283[3]  = \chain_i$283 [75:57];
  assign \chain_o$284[0]  = \chain_i$283 [18:0];
  assign \chain_o$284[1]  = \chain_i$283 [37:19];
  assign \chain_o$284[2]  = \chain_i$283 [56:38];
  assign \chain_o$284[3]  = \chain_i$283 [75:57];
  assign \write$287.addr  = \$72 ;
  assign \write$287.data  = \$74 [647:576];
  assign \control$289.en  = control[0];
  assign \control$289.first  = control[1];
  assign \control$289.carried  = control[2];
  assign \control$289.last  = control[3];
  assign \control$289.edge  = control[4];
  assign \control$289.tile  = control[8:5];
  assign \control$289.unload  = control[9];
  assign \chain_i$291[0]  = \chain_i$291 [18:0];
  assign \chain_i$291[1]  = \chain_i$291 [37:19];
  assign \chain_i$291[2]  = \chain_i$291 [56:38];
  assign \chain_i$291[3]  = \chain_i$291 [75:57];
  assign \chain_o$292[0]  = \chain_i$291 [18:0];
  assign \chain_o$292[1]  = \chain_i$291 [37:19];
  assign \chain_o$292[2]  = \chain_i$291 [56:38];
  assign \chain_o$292[3]  = \chain_i$291 [75:57];
  assign \write$295.addr  = \$72 ;
  assign \write$295.data  = \$74 [647:576];
  assign \control$297.en  = control[0];
  assign \control$297.first  = control[1];
  assign \control$297.carried  = control[2];
  assign \control$297.last  = control[3];
  assign \control$297.edge  = control[4];
  assign \control$297.tile  = control[8:5];
  assign \control$297.unload  = control[9];
  assign \chain_i$299[0]  = \chain_i$299 [18:0];
  assign \chain_i$299[1]  = \chain_i$299 [37:19];
  assign \chain_i$299[2]  = \chain_i$299 [56:38];
  assign \chain_i$299[3]  = \chain_i$299 [75:57];
  assign \chain_o$300[0]  = \chain_i$299 [18:0];
  assign \chain_o$300[1]  = \chain_i$299 [37:19];
  assign \chain_o$300[2]  = \chain_i$299 [56:38];
  assign \chain_o$300[3]  = \chain_i$299 [75:57];
  assign \write$303.addr  = \$72 ;
  assign \write$303.data  = \$74 [647:576];
  assign \control$305.en  = control[0];
  assign \control$305.first  = control[1];
  assign \control$305.carried  = control[2];
  assign \control$305.last  = control[3];
  assign \control$305.edge  = control[4];
  assign \control$305.tile  = control[8:5];
  assign \control$305.unload  = control[9];
  assign \chain_i$307[0]  = \chain_i$307 [18:0];
  assign \chain_i$307[1]  = \chain_i$307 [37:19];
  assign \chain_i$307[2]  = \chain_i$307 [56:38];
  assign \chain_i$307[3]  = \chain_i$307 [75:57];
  assign \chain_o$308[0]  = \chain_i$307 [18:0];
  assign \chain_o$308[1]  = \chain_i$307 [37:19];
  assign \chain_o$308[2]  = \chain_i$307 [56:38];
  assign \chain_o$308[3]  = \chain_i$307 [75:57];
  assign \write$311.addr  = \$72 ;
  assign \write$311.data  = \$74 [647:576];
  assign \control$313.en  = control[0];
  assign \control$313.first  = control[1];
  assign \control$313.carried  = control[2];
  assign \control$313.last  = control[3];
  assign \control$313.edge  = control[4];
  assign \control$313.tile  = control[8:5];
  assign \control$313.unload  = control[9];
  assign \chain_i$315[0]  = \chain_i$315 [18:0];
  assign \chain_i$315[1]  = \chain_i$315 [37:19];
  assign \chain_i$315[2]  = \chain_i$315 [56:38];
  assign \chain_i$315[3]  = \chain_i$315 [75:57];
  assign \chain_o$316[0]  = \chain_i$315 [18:0];
  assign \chain_o$316[1]  = \chain_i$315 [37:19];
  assign \chain_o$316[2]  = \chain_i$315 [56:38];
  assign \chain_o$316[3]  = \chain_i$315 [75:57];
  assign \write$319.addr  = \$72 ;
  assign \write$319.data  = \$74 [647:576];
  assign \control$321.en  = control[0];
  assign \control$321.first  = control[1];
  assign \control$321.carried  = control[2];
  assign \control$321.last  = control[3];
  assign \control$321.edge  = control[4];
  assign \control$321.tile  = control[8:5];
  assign \control$321.unload  = control[9];
  assign \chain_i$323[0]  = \chain_i$323 [18:0];
  assign \chain_i$323[1]  = \chain_i$323 [37:19];
  assign \chain_i$323[2]  = \chain_i$323 [56:38];
  assign \chain_i$323[3]  = \chain_i$323 [75:57];
  assign \chain_o$324[0]  = \chain_i$323 [18:0];
  assign \chain_o$324[1]  = \chain_i$323 [37:19];
  assign \chain_o$324[2]  = \chain_i$323 [56:38];
  assign \chain_o$324[3]  = \chain_i$323 [75:57];
  assign \write$327.addr  = \$72 ;
  assign \write$327.data  = \$74 [647:576];
  assign \control$329.en  = control[0];
  assign \control$329.first  = control[1];
  assign \control$329.carried  = control[2];
  assign \control$329.last  = control[3];
  assign \control$329.edge  = control[4];
  assign \control$329.tile  = control[8:5];
  assign \control$329.unload  = control[9];
  assign \chain_i$331[0]  = \chain_i$331 [18:0];
  assign \chain_i$331[1]  = \chain_i$331 [37:19];
  assign \chain_i$331[2]  = \chain_i$331 [56:38];
  assign \chain_i$331[3]  = \chain_i$331 [75:57];
  assign \chain_o$332[0]  = \chain_i$331 [18:0];
  assign \chain_o$332[1]  = \chain_i$331 [37:19];
  assign \chain_o$332[2]  = \chain_i$331 [56:38];
  assign \chain_o$332[3]  = \chain_i$331 [75:57];
  assign \write$335.addr  = \$72 ;
  assign \write$335.data  = \$74 [647:576];
  assign \control$337.en  = control[0];
  assign \control$337.first  = control[1];
  assign \control$337.carried  = control[2];
  assign \control$337.last  = control[3];
  assign \control$337.edge  = control[4];
  assign \control$337.tile  = control[8:5];
  assign \control$337.unload  = control[9];
  assign \chain_i$339[0]  = \chain_i$339 [18:0];
  assign \chain_i$339[1]  = \chain_i$339 [37:19];
  assign \chain_i$339[2]  = \chain_i$339 [56:38];
  assign \chain_i$339[3]  = \chain_i$339 [75:57];
  assign \chain_o$340[0]  = \chain_i$339 [18:0];
  assign \chain_o$340[1]  = \chain_i$339 [37:19];
  assign \chain_o$340[2]  = \chain_i$339 [56:38];
  assign \chain_o$340[3]  = \chain_i$339 [75:57];
  assign \write$343.addr  = \$72 ;
  assign \write$343.data  = \$74 [647:576];
  assign \control$345.en  = control[0];
  assign \control$345.first  = control[1];
  assign \control$345.carried  = control[2];
  assign \control$345.last  = control[3];
  assign \control$345.edge  = control[4];
  assign \control$345.tile  = control[8:5];
  assign \control$345.unload  = control[9];
  assign \chain_i$347[0]  = \chain_i$347 [18:0];
  assign \chain_i$347[1]  = \chain_i$347 [37:19];
  assign \chain_i$347[2]  = \chain_i$347 [56:38];
  assign \chain_i$347[3]  = \chain_i$347 [75:57];
  assign \chain_o$348[0]  = \chain_i$347 [18:0];
  assign \chain_o$348[1]  = \chain_i$347 [37:19];
  assign \chain_o$348[2]  = \chain_i$347 [56:38];
  assign \chain_o$348[3]  = \chain_i$347 [75:57];
  assign \write$351.addr  = \$72 ;
  assign \write$351.data  = \$74 [647:576];
  assign \control$353.en  = control[0];
  assign \control$353.first  = control[1];
  assign \control$353.carried  = control[2];
  assign \control$353.last  = control[3];
  assign \control$353.edge  = control[4];
  assign \control$353.tile  = control[8:5];
  assign \control$353.unload  = control[9];
  assign \chain_i$355[0]  = \chain_i$355 [18:0];
  assign \chain_i$355[1]  = \chain_i$355 [37:19];
  assign \chain_i$355[2]  = \chain_i$355 [56:38];
  assign \chain_i$355[3]  = \chain_i$355 [75:57];
  assign \chain_o$356[0]  = \chain_i$355 [18:0];
  assign \chain_o$356[1]  = \chain_i$355 [37:19];
  assign \chain_o$356[2]  = \chain_i$355 [56:38];
  assign \chain_o$356[3]  = \chain_i$355 [75:57];
  assign \write$359.addr  = \$72 ;
  assign \write$359.data  = \$74 [647:576];
  assign \control$361.en  = control[0];
  assign \control$361.first  = control[1];
  assign \control$361.carried  = control[2];
  assign \control$361.last  = control[3];
  assign \control$361.edge  = control[4];
  assign \control$361.tile  = control[8:5];
  assign \control$361.unload  = control[9];
  assign \chain_i$363[0]  = \chain_i$363 [18:0];
  assign \chain_i$363[1]  = \chain_i$363 [37:19];
  assign \chain_i$363[2]  = \chain_i$363 [56:38];
  assign \chain_i$363[3]  = \chain_i$363 [75:57];
  assign \chain_o$364[0]  = \chain_i$363 [18:0];
  assign \chain_o$364[1]  = \chain_i$363 [37:19];
  assign \chain_o$364[2]  = \chain_i$363 [56:38];
  assign \chain_o$364[3]  = \chain_i$363 [75:57];
  assign \write$367.addr  = \$72 ;
  assign \write$367.data  = \$74 [647:576];
  assign \control$369.en  = control[0];
  assign \control$369.first  = control[1];
  assign \control$369.carried  = control[2];
  assign \control$369.last  = control[3];
  assign \control$369.edge  = control[4];
  assign \control$369.tile  = control[8:5];
  assign \control$369.unload  = control[9];
  assign \chain_i$371[0]  = \chain_i$371 [18:0];
  assign \chain_i$371[1]  = \chain_i$371 [37:19];
  assign \chain_i$371[2]  = \chain_i$371 [56:38];
  assign \chain_i$371[3]  = \chain_i$371 [75:57];
  assign \chain_o$372[0]  = \chain_i$371 [18:0];
  assign \chain_o$372[1]  = \chain_i$371 [37:19];
  assign \chain_o$372[2]  = \chain_i$371 [56:38];
  assign \chain_o$372[3]  = \chain_i$371 [75:57];
  assign \write$375.addr  = \$72 ;
  assign \write$375.data  = \$74 [647:576];
  assign \control$377.en  = control[0];
  assign \control$377.first  = control[1];
  assign \control$377.carried  = control[2];
  assign \control$377.last  = control[3];
  assign \control$377.edge  = control[4];
  assign \control$377.tile  = control[8:5];
  assign \control$377.unload  = control[9];
  assign \chain_i$379[0]  = \chain_i$379 [18:0];
  assign \chain_i$379[1]  = \chain_i$379 [37:19];
  assign \chain_i$379[2]  = \chain_i$379 [56:38];
  assign \chain_i$379[3]  = \chain_i$379 [75:57];
  assign \chain_o$380[0]  = \chain_i$379 [18:0];
  assign \chain_o$380[1]  = \chain_i$379 [37:19];
  assign \chain_o$380[2]  = \chain_i$379 [56:38];
  assign \chain_o$380[3]  = \chain_i$379 [75:57];
  assign \write$383.addr  = \$72 ;
  assign \write$383.data  = \$74 [647:576];
  assign \control$385.en  = control[0];
  assign \control$385.first  = control[1];
  assign \control$385.carried  = control[2];
  assign \control$385.last  = control[3];
  assign \control$385.edge  = control[4];
  assign \control$385.tile  = control[8:5];
  assign \control$385.unload  = control[9];
  assign \chain_i$387[0]  = \chain_i$387 [18:0];
  assign \chain_i$387[1]  = \chain_i$387 [37:19];
  assign \chain_i$387[2]  = \chain_i$387 [56:38];
  assign \chain_i$387[3]  = \chain_i$387 [75:57];
  assign \chain_o$388[0]  = \chain_i$387 [18:0];
  assign \chain_o$388[1]  = \chain_i$387 [37:19];
  assign \chain_o$388[2]  = \chain_i$387 [56:38];
  assign \chain_o$388[3]  = \chain_i$387 [75:57];
  assign \write$391.addr  = \$72 ;
  assign \write$391.data  = \$74 [647:576];
  assign \control$393.en  = control[0];
  assign \control$393.first  = control[1];
  assign \control$393.carried  = control[2];
  assign \control$393.last  = control[3];
  assign \control$393.edge  = control[4];
  assign \control$393.tile  = control[8:5];
  assign \control$393.unload  = control[9];
  assign \chain_i$395[0]  = \chain_i$395 [18:0];
  assign \chain_i$395[1]  = \chain_i$395 [37:19];
  assign \chain_i$395[2]  = \chain_i$395 [56:38];
  assign \chain_i$395[3]  = \chain_i$395 [75:57];
  assign \chain_o$396[0]  = \chain_i$395 [18:0];
  assign \chain_o$396[1]  = \chain_i$395 [37:19];
  assign \chain_o$396[2]  = \chain_i$395 [56:38];
  assign \chain_o$396[3]  = \chain_i$395 [75:57];
  assign \write$399.addr  = \$72 ;
  assign \write$399.data  = \$74 [647:576];
  assign \control$401.en  = control[0];
  assign \control$401.first  = control[1];
  assign \control$401.carried  = control[2];
  assign \control$401.last  = control[3];
  assign \control$401.edge  = control[4];
  assign \control$401.tile  = control[8:5];
  assign \control$401.unload  = control[9];
  assign \chain_i$403[0]  = \chain_i$403 [18:0];
  assign \chain_i$403[1]  = \chain_i$403 [37:19];
  assign \chain_i$403[2]  = \chain_i$403 [56:38];
  assign \chain_i$403[3]  = \chain_i$403 [75:57];
  assign \chain_o$404[0]  = \chain_i$403 [18:0];
  assign \chain_o$404[1]  = \chain_i$403 [37:19];
  assign \chain_o$404[2]  = \chain_i$403 [56:38];
  assign \chain_o$404[3]  = \chain_i$403 [75:57];
  assign \write$407.addr  = \$72 ;
  assign \write$407.data  = \$74 [647:576];
  assign \control$409.en  = control[0];
  assign \control$409.first  = control[1];
  assign \control$409.carried  = control[2];
  assign \control$409.last  = control[3];
  assign \control$409.edge  = control[4];
  assign \control$409.tile  = control[8:5];
  assign \control$409.unload  = control[9];
  assign \chain_i$411[0]  = \chain_i$411 [18:0];
  assign \chain_i$411[1]  = \chain_i$411 [37:19];
  assign \chain_i$411[2]  = \chain_i$411 [56:38];
  assign \chain_i$411[3]  = \chain_i$411 [75:57];
  assign \chain_o$412[0]  = \chain_i$411 [18:0];
  assign \chain_o$412[1]  = \chain_i$411 [37:19];
  assign \chain_o$412[2]  = \chain_i$411 [56:38];
  assign \chain_o$412[3]  = \chain_i$411 [75:57];
  assign \write$415.addr  = \$72 ;
  assign \write$415.data  = \$74 [647:576];
  assign \control$417.en  = control[0];
  assign \control$417.first  = control[1];
  assign \control$417.carried  = control[2];
  assign \control$417.last  = control[3];
  assign \control$417.edge  = control[4];
  assign \control$417.tile  = control[8:5];
  assign \control$417.unload  = control[9];
  assign \chain_i$419[0]  = \chain_i$419 [18:0];
  assign \chain_i$419[1]  = \chain_i$419 [37:19];
  assign \chain_i$419[2]  = \chain_i$419 [56:38];
  assign \chain_i$419[3]  = \chain_i$419 [75:57];
  assign \chain_o$420[0]  = \chain_i$419 [18:0];
  assign \chain_o$420[1]  = \chain_i$419 [37:19];
  assign \chain_o$420[2]  = \chain_i$419 [56:38];
  assign \chain_o$420[3]  = \chain_i$419 [75:57];
  assign \write$423.addr  = \$72 ;
  assign \write$423.data  = \$74 [647:576];
  assign \control$425.en  = control[0];
  assign \control$425.first  = control[1];
  assign \control$425.carried  = control[2];
  assign \control$425.last  = control[3];
  assign \control$425.edge  = control[4];
  assign \control$425.tile  = control[8:5];
  assign \control$425.unload  = control[9];
  assign \chain_i$427[0]  = \chain_i$427 [18:0];
  assign \chain_i$427[1]  = \chain_i$427 [37:19];
  assign \chain_i$427[2]  = \chain_i$427 [56:38];
  assign \chain_i$427[3]  = \chain_i$427 [75:57];
  assign \chain_o$428[0]  = \chain_i$427 [18:0];
  assign \chain_o$428[1]  = \chain_i$427 [37:19];
  assign \chain_o$428[2]  = \chain_i$427 [56:38];
  assign \chain_o$428[3]  = \chain_i$427 [75:57];
  assign \write$431.addr  = \$72 ;
  assign \write$431.data  = \$74 [647:576];
  assign \control$433.en  = control[0];
  assign \control$433.first  = control[1];
  assign \control$433.carried  = control[2];
  assign \control$433.last  = control[3];
  assign \control$433.edge  = control[4];
  assign \control$433.tile  = control[8:5];
  assign \control$433.unload  = control[9];
  assign \chain_i$435[0]  = \chain_i$435 [18:0];
  assign \chain_i$435[1]  = \chain_i$435 [37:19];
  assign \chain_i$435[2]  = \chain_i$435 [56:38];
  assign \chain_i$435[3]  = \chain_i$435 [75:57];
  assign \chain_o$436[0]  = \chain_i$435 [18:0];
  assign \chain_o$436[1]  = \chain_i$435 [37:19];
  assign \chain_o$436[2]  = \chain_i$435 [56:38];
  assign \chain_o$436[3]  = \chain_i$435 [75:57];
  assign \write$439.addr  = \$72 ;
  assign \write$439.data  = \$74 [647:576];
  assign \control$441.en  = control[0];
  assign \control$441.first  = control[1];
  assign \control$441.carried  = control[2];
  assign \control$441.last  = control[3];
  assign \control$441.edge  = control[4];
  assign \control$441.tile  = control[8:5];
  assign \control$441.unload  = control[9];
  assign \chain_i$443[0]  = \chain_i$443 [18:0];
  assign \chain_i$443[1]  = \chain_i$443 [37:19];
  assign \chain_i$443[2]  = \chain_i$443 [56:38];
  assign \chain_i$443[3]  = \chain_i$443 [75:57];
  assign \chain_o$444[0]  = \chain_i$443 [18:0];
  assign \chain_o$444[1]  = \chain_i$443 [37:19];
  assign \chain_o$444[2]  = \chain_i$443 [56:38];
  assign \chain_o$444[3]  = \chain_i$443 [75:57];
  assign \write$447.addr  = \$72 ;
  assign \write$447.data  = \$74 [647:576];
  assign \control$449.en  = control[0];
  assign \control$449.first  = control[1];
  assign \control$449.carried  = control[2];
  assign \control$449.last  = control[3];
  assign \control$449.edge  = control[4];
  assign \control$449.tile  = control[8:5];
  assign \control$449.unload  = control[9];
  assign \chain_i$451[0]  = \chain_i$451 [18:0];
  assign \chain_i$451[1]  = \chain_i$451 [37:19];
  assign \chain_i$451[2]  = \chain_i$451 [56:38];
  assign \chain_i$451[3]  = \chain_i$451 [75:57];
  assign \chain_o$452[0]  = \chain_i$451 [18:0];
  assign \chain_o$452[1]  = \chain_i$451 [37:19];
  assign \chain_o$452[2]  = \chain_i$451 [56:38];
  assign \chain_o$452[3]  = \chain_i$451 [75:57];
  assign \write$455.addr  = \$72 ;
  assign \write$455.data  = \$74 [647:576];
  assign \control$457.en  = control[0];
  assign \control$457.first  = control[1];
  assign \control$457.carried  = control[2];
  assign \control$457.last  = control[3];
  assign \control$457.edge  = control[4];
  assign \control$457.tile  = control[8:5];
  assign \control$457.unload  = control[9];
  assign \chain_i$459[0]  = \chain_i$459 [18:0];
  assign \chain_i$459[1]  = \chain_i$459 [37:19];
  assign \chain_i$459[2]  = \chain_i$459 [56:38];
  assign \chain_i$459[3]  = \chain_i$459 [75:57];
  assign \chain_o$460[0]  = \chain_i$459 [18:0];
  assign \chain_o$460[1]  = \chain_i$459 [37:19];
  assign \chain_o$460[2]  = \chain_i$459 [56:38];
  assign \chain_o$460[3]  = \chain_i$459 [75:57];
  assign \write$463.addr  = \$72 ;
  assign \write$463.data  = \$74 [647:576];
  assign \control$465.en  = control[0];
  assign \control$465.first  = control[1];
  assign \control$465.carried  = control[2];
  assign \control$465.last  = control[3];
  assign \control$465.edge  = control[4];
  assign \control$465.tile  = control[8:5];
  assign \control$465.unload  = control[9];
  assign \chain_i$467[0]  = \chain_i$467 [18:0];
  assign \chain_i$467[1]  = \chain_i$467 [37:19];
  assign \chain_i$467[2]  = \chain_i$467 [56:38];
  assign \chain_i$467[3]  = \chain_i$467 [75:57];
  assign \chain_o$468[0]  = \chain_i$467 [18:0];
  assign \chain_o$468[1]  = \chain_i$467 [37:19];
  assign \chain_o$468[2]  = \chain_i$467 [56:38];
  assign \chain_o$468[3]  = \chain_i$467 [75:57];
  assign \write$471.addr  = \$72 ;
  assign \write$471.data  = \$74 [647:576];
  assign \control$473.en  = control[0];
  assign \control$473.first  = control[1];
  assign \control$473.carried  = control[2];
  assign \control$473.last  = control[3];
  assign \control$473.edge  = control[4];
  assign \control$473.tile  = control[8:5];
  assign \control$473.unload  = control[9];
  assign \chain_i$475[0]  = \chain_i$475 [18:0];
  assign \chain_i$475[1]  = \chain_i$475 [37:19];
  assign \chain_i$475[2]  = \chain_i$475 [56:38];
  assign \chain_i$475[3]  = \chain_i$475 [75:57];
  assign \chain_o$476[0]  = \chain_i$475 [18:0];
  assign \chain_o$476[1]  = \chain_i$475 [37:19];
  assign \chain_o$476[2]  = \chain_i$475 [56:38];
  assign \chain_o$476[3]  = \chain_i$475 [75:57];
  assign \write$479.addr  = \$72 ;
  assign \write$479.data  = \$74 [647:576];
  assign \control$481.en  = control[0];
  assign \control$481.first  = control[1];
  assign \control$481.carried  = control[2];
  assign \control$481.last  = control[3];
  assign \control$481.edge  = control[4];
  assign \control$481.tile  = control[8:5];
  assign \control$481.unload  = control[9];
  assign \chain_i$483[0]  = \chain_i$483 [18:0];
  assign \chain_i$483[1]  = \chain_i$483 [37:19];
  assign \chain_i$483[2]  = \chain_i$483 [56:38];
  assign \chain_i$483[3]  = \chain_i$483 [75:57];
  assign \chain_o$484[0]  = \chain_i$483 [18:0];
  assign \chain_o$484[1]  = \chain_i$483 [37:19];
  assign \chain_o$484[2]  = \chain_i$483 [56:38];
  assign \chain_o$484[3]  = \chain_i$483 [75:57];
  assign \write$487.addr  = \$72 ;
  assign \write$487.data  = \$74 [647:576];
  assign \control$489.en  = control[0];
  assign \control$489.first  = control[1];
  assign \control$489.carried  = control[2];
  assign \control$489.last  = control[3];
  assign \control$489.edge  = control[4];
  assign \control$489.tile  = control[8:5];
  assign \control$489.unload  = control[9];
  assign \chain_i$491[0]  = \chain_i$491 [18:0];
  assign \chain_i$491[1]  = \chain_i$491 [37:19];
  assign \chain_i$491[2]  = \chain_i$491 [56:38];
  assign \chain_i$491[3]  = \chain_i$491 [75:57];
  assign \chain_o$492[0]  = \chain_i$491 [18:0];
  assign \chain_o$492[1]  = \chain_i$491 [37:19];
  assign \chain_o$492[2]  = \chain_i$491 [56:38];
  assign \chain_o$492[3]  = \chain_i$491 [75:57];
  assign \write$495.addr  = \$72 ;
  assign \write$495.data  = \$74 [647:576];
  assign \control$497.en  = control[0];
  assign \control$497.first  = control[1];
  assign \control$497.carried  = control[2];
  assign \control$497.last  = control[3];
  assign \control$497.edge  = control[4];
  assign \control$497.tile  = control[8:5];
  assign \control$497.unload  = control[9];
  assign \chain_i$499[0]  = \chain_i$499 [18:0];
  assign \chain_i$499[1]  = \chain_i$499 [37:19];
  assign \chain_i$499[2]  = \chain_i$499 [56:38];
  assign \chain_i$499[3]  = \chain_i$499 [75:57];
  assign \chain_o$500[0]  = \chain_i$499 [18:0];
  assign \chain_o$500[1]  = \chain_i$499 [37:19];
  assign \chain_o$500[2]  = \chain_i$499 [56:38];
  assign \chain_o$500[3]  = \chain_i$499 [75:57];
  assign \write$503.addr  = \$72 ;
  assign \write$503.data  = \$74 [647:576];
  assign \control$505.en  = control[0];
  assign \control$505.first  = control[1];
  assign \control$505.carried  = control[2];
  assign \control$505.last  = control[3];
  assign \control$505.edge  = control[4];
  assign \control$505.tile  = control[8:5];
  assign \control$505.unload  = control[9];
  assign \chain_i$507[0]  = \chain_i$507 [18:0];
  assign \chain_i$507[1]  = \chain_i$507 [37:19];
  assign \chain_i$507[2]  = \chain_i$507 [56:38];
  assign \chain_i$507[3]  = \chain_i$507 [75:57];
  assign \chain_o$508[0]  = \chain_i$507 [18:0];
  assign \chain_o$508[1]  = \chain_i$507 [37:19];
  assign \chain_o$508[2]  = \chain_i$507 [56:38];
  assign \chain_o$508[3]  = \chain_i$507 [75:57];
  assign \write$511.addr  = \$72 ;
  assign \write$511.data  = \$74 [647:576];
  assign \control$513.en  = control[0];
  assign \control$513.first  = control[1];
  assign \control$513.carried  = control[2];
  assign \control$513.last  = control[3];
  assign \control$513.edge  = control[4];
  assign \control$513.tile  = control[8:5];
  assign \control$513.unload  = control[9];
  assign \chain_i$515[0]  = \chain_i$515 [18:0];
  assign \chain_i$515[1]  = \chain_i$515 [37:19];
  assign \chain_i$515[2]  = \chain_i$515 [56:38];
  assign \chain_i$515[3]  = \chain_i$515 [75:57];
  assign \chain_o$516[0]  = \chain_i$515 [18:0];
  assign \chain_o$516[1]  = \chain_i$515 [37:19];
  assign \chain_o$516[2]  = \chain_i$515 [56:38];
  assign \chain_o$516[3]  = \chain_i$515 [75:57];
  assign \write$519.addr  = \$72 ;
  assign \write$519.data  = \$74 [647:576];
  assign \control$521.en  = control[0];
  assign \control$521.first  = control[1];
  assign \control$521.carried  = control[2];
  assign \control$521.last  = control[3];
  assign \control$521.edge  = control[4];
  assign \control$521.tile  = control[8:5];
  assign \control$521.unload  = control[9];
  assign \chain_i$523[0]  = \chain_i$523 [18:0];
  assign \chain_i$523[1]  = \chain_i$523 [37:19];
  assign \chain_i$523[2]  = \chain_i$523 [56:38];
  assign \chain_i$523[3]  = \chain_i$523 [75:57];
  assign \chain_o$524[0]  = \chain_i$523 [18:0];
  assign \chain_o$524[1]  = \chain_i$523 [37:19];
  assign \chain_o$524[2]  = \chain_i$523 [56:38];
  assign \chain_o$524[3]  = \chain_i$523 [75:57];
  assign \write$527.addr  = \$72 ;
  assign \write$527.data  = \$74 [647:576];
  assign \control$529.en  = control[0];
  assign \control$529.first  = control[1];
  assign \control$529.carried  = control[2];
  assign \control$529.last  = control[3];
  assign \control$529.edge  = control[4];
  assign \control$529.tile  = control[8:5];
  assign \control$529.unload  = control[9];
  assign \chain_i$531[0]  = \chain_i$531 [18:0];
  assign \chain_i$531[1]  = \chain_i$531 [37:19];
  assign \chain_i$531[2]  = \chain_i$531 [56:38];
  assign \chain_i$531[3]  = \chain_i$531 [75:57];
  assign \chain_o$532[0]  = \chain_i$531 [18:0];
  assign \chain_o$532[1]  = \chain_i$531 [37:19];
  assign \chain_o$532[2]  = \chain_i$531 [56:38];
  assign \chain_o$532[3]  = \chain_i$531 [75:57];
  assign \write$535.addr  = \$72 ;
  assign \write$535.data  = \$74 [647:576];
  assign \control$537.en  = control[0];
  assign \control$537.first  = control[1];
  assign \control$537.carried  = control[2];
  assign \control$537.last  = control[3];
  assign \control$537.edge  = control[4];
  assign \control$537.tile  = control[8:5];
  assign \control$537.unload  = control[9];
  assign \chain_i$539[0]  = \chain_i$539 [18:0];
  assign \chain_i$539[1]  = \chain_i$539 [37:19];
  assign \chain_i$539[2]  = \chain_i$539 [56:38];
  assign \chain_i$539[3]  = \chain_i$539 [75:57];
  assign \chain_o$540[0]  = \chain_i$539 [18:0];
  assign \chain_o$540[1]  = \chain_i$539 [37:19];
  assign \chain_o$540[2]  = \chain_i$539 [56:38];
  assign \chain_o$540[3]  = \chain_i$539 [75:57];
  assign \write$543.addr  = \$72 ;
  assign \write$543.data  = \$74 [647:576];
  assign \control$545.en  = control[0];
  assign \control$545.first  = control[1];
  assign \control$545.carried  = control[2];
  assign \control$545.last  = control[3];
  assign \control$545.edge  = control[4];
  assign \control$545.tile  = control[8:5];
  assign \control$545.unload  = control[9];
  assign \chain_i$547[0]  = \chain_i$547 [18:0];
  assign \chain_i$547[1]  = \chain_i$547 [37:19];
  assign \chain_i$547[2]  = \chain_i$547 [56:38];
  assign \chain_i$547[3]  = \chain_i$547 [75:57];
  assign \chain_o$548[0]  = \chain_i$547 [18:0];
  assign \chain_o$548[1]  = \chain_i$547 [37:19];
  assign \chain_o$548[2]  = \chain_i$547 [56:38];
  assign \chain_o$548[3]  = \chain_i$547 [75:57];
  assign \write$551.addr  = \$72 ;
  assign \write$551.data  = \$74 [647:576];
  assign \control$553.en  = control[0];
  assign \control$553.first  = control[1];
  assign \control$553.carried  = control[2];
  assign \control$553.last  = control[3];
  assign \control$553.edge  = control[4];
  assign \control$553.tile  = control[8:5];
  assign \control$553.unload  = control[9];
  assign \chain_i$555[0]  = \chain_i$555 [18:0];
  assign \chain_i$555[1]  = \chain_i$555 [37:19];
  assign \chain_i$555[2]  = \chain_i$555 [56:38];
  assign \chain_i$555[3]  = \chain_i$555 [75:57];
  assign \chain_o$556[0]  = \chain_i$555 [18:0];
  assign \chain_o$556[1]  = \chain_i$555 [37:19];
  assign \chain_o$556[2]  = \chain_i$555 [56:38];
  assign \chain_o$556[3]  = \chain_i$555 [75:57];
  assign \write$559.addr  = \$72 ;
  assign \write$559.data  = \$74 [647:576];
  assign \control$561.en  = control[0];
  assign \control$561.first  = control[1];
  assign \control$561.carried  = control[2];
  assign \control$561.last  = control[3];
  assign \control$561.edge  = control[4];
  assign \control$561.tile  = control[8:5];
  assign \control$561.unload  = control[9];
  assign \chain_i$563[0]  = \chain_i$563 [18:0];
  assign \chain_i$563[1]  = \chain_i$563 [37:19];
  assign \chain_i$563[2]  = \chain_i$563 [56:38];
  assign \chain_i$563[3]  = \chain_i$563 [75:57];
  assign \chain_o$564[0]  = \chain_i$563 [18:0];
  assign \chain_o$564[1]  = \chain_i$563 [37:19];
  assign \chain_o$564[2]  = \chain_i$563 [56:38];
  assign \chain_o$564[3]  = \chain_i$563 [75:57];
  assign \write$567.addr  = \$72 ;
  assign \write$567.data  = \$74 [647:576];
  assign \control$569.en  = control[0];
  assign \control$569.first  = control[1];
  assign \control$569.carried  = control[2];
  assign \control$569.last  = control[3];
  assign \control$569.edge  = control[4];
  assign \control$569.tile  = control[8:5];
  assign \control$569.unload  = control[9];
  assign \chain_i$571[0]  = \chain_i$571 [18:0];
  assign \chain_i$571[1]  = \chain_i$571 [37:19];
  assign \chain_i$571[2]  = \chain_i$571 [56:38];
  assign \chain_i$571[3]  = \chain_i$571 [75:57];
  assign \chain_o$572[0]  = \chain_i$571 [18:0];
  assign \chain_o$572[1]  = \chain_i$571 [37:19];
  assign \chain_o$572[2]  = \chain_i$571 [56:38];
  assign \chain_o$572[3]  = \chain_i$571 [75:57];
  assign \write$575.addr  = \$72 ;
  assign \write$575.data  = \$74 [647:576];
  assign \control$577.en  = control[0];
  assign \control$577.first  = control[1];
  assign \control$577.carried  = control[2];
  assign \control$577.last  = control[3];
  assign \control$577.edge  = control[4];
  assign \control$577.tile  = control[8:5];
  assign \control$577.unload  = control[9];
  assign \chain_i$579[0]  = \chain_i$579 [18:0];
  assign \chain_i$579[1]  = \chain_i$579 [37:19];
  assign \chain_i$579[2]  = \chain_i$579 [56:38];
  assign \chain_i$579[3]  = \chain_i$579 [75:57];
  assign \chain_o$580[0]  = \chain_i$579 [18:0];
  assign \chain_o$580[1]  = \chain_i$579 [37:19];
  assign \chain_o$580[2]  = \chain_i$579 [56:38];
  assign \chain_o$580[3]  = \chain_i$579 [75:57];
  assign \write$583.addr  = \$72 ;
  assign \write$583.data  = \$74 [647:576];
  assign \control$585.en  = control[0];
  assign \control$585.first  = control[1];
  assign \control$585.carried  = control[2];
  assign \control$585.last  = control[3];
  assign \control$585.edge  = control[4];
  assign \control$585.tile  = control[8:5];
  assign \control$585.unload  = control[9];
  assign \chain_i$587[0]  = \chain_i$587 [18:0];
  assign \chain_i$587[1]  = \chain_i$587 [37:19];
  assign \chain_i$587[2]  = \chain_i$587 [56:38];
  assign \chain_i$587[3]  = \chain_i$587 [75:57];
  assign \chain_o$588[0]  = \chain_i$587 [18:0];
  assign \chain_o$588[1]  = \chain_i$587 [37:19];
  assign \chain_o$588[2]  = \chain_i$587 [56:38];
  assign \chain_o$588[3]  = \chain_i$587 [75:57];
  assign \write$591.addr  = \$72 ;
  assign \write$591.data  = \$74 [647:576];
  assign \control$593.en  = control[0];
  assign \control$593.first  = control[1];
  assign \control$593.carried  = control[2];
  assign \control$593.last  = control[3];
  assign \control$593.edge  = control[4];
  assign \control$593.tile  = control[8:5];
  assign \control$593.unload  = control[9];
  assign \chain_i$595[0]  = \chain_i$595 [18:0];
  assign \chain_i$595[1]  = \chain_i$595 [37:19];
  assign \chain_i$595[2]  = \chain_i$595 [56:38];
  assign \chain_i$595[3]  = \chain_i$595 [75:57];
  assign \chain_o$596[0]  = \chain_i$595 [18:0];
  assign \chain_o$596[1]  = \chain_i$595 [37:19];
  assign \chain_o$596[2]  = \chain_i$595 [56:38];
  assign \chain_o$596[3]  = \chain_i$595 [75:57];
  assign \write$599.addr  = \$72 ;
  assign \write$599.data  = \$74 [647:576];
  assign \control$601.en  = control[0];
  assign \control$601.first  = control[1];
  assign \control$601.carried  = control[2];
  assign \control$601.last  = control[3];
  assign \control$601.edge  = control[4];
  assign \control$601.tile  = control[8:5];
  assign \control$601.unload  = control[9];
  assign \chain_i$603[0]  = \chain_i$603 [18:0];
  assign \chain_i$603[1]  = \chain_i$603 [37:19];
  assign \chain_i$603[2]  = \chain_i$603 [56:38];
  assign \chain_i$603[3]  = \chain_i$603 [75:57];
  assign \chain_o$604[0]  = \chain_i$603 [18:0];
  assign \chain_o$604[1]  = \chain_i$603 [37:19];
  assign \chain_o$604[2]  = \chain_i$603 [56:38];
  assign \chain_o$604[3]  = \chain_i$603 [75:57];
  assign \write$607.addr  = \$72 ;
  assign \write$607.data  = \$74 [647:576];
  assign \control$609.en  = control[0];
  assign \control$609.first  = control[1];
  assign \control$609.carried  = control[2];
  assign \control$609.last  = control[3];
  assign \control$609.edge  = control[4];
  assign \control$609.tile  = control[8:5];
  assign \control$609.unload  = control[9];
  assign \chain_i$611[0]  = chain_o[18:0];
  assign \chain_i$611[1]  = chain_o[37:19];
  assign \chain_i$611[2]  = chain_o[56:38];
  assign \chain_i$611[3]  = chain_o[75:57];
  assign \write$614.addr  = \$72 ;
  assign \write$614.data  = \$74 [647:576];
  assign \control$616.en  = control[0];
  assign \control$616.first  = control[1];
  assign \control$616.carried  = control[2];
  assign \control$616.last  = control[3];
  assign \control$616.edge  = control[4];
  assign \control$616.tile  = control[8:5];
  assign \control$616.unload  = control[9];
  assign \chain_i$618[0]  = \chain_o$136 [18:0];
  assign \chain_i$618[1]  = \chain_o$136 [37:19];
  assign \chain_i$618[2]  = \chain_o$136 [56:38];
  assign \chain_i$618[3]  = \chain_o$136 [75:57];
  assign \write$621.addr  = \$72 ;
  assign \write$621.data  = \$74 [647:576];
  assign \control$623.en  = control[0];
  assign \control$623.first  = control[1];
  assign \control$623.carried  = control[2];
  assign \control$623.last  = control[3];
  assign \control$623.edge  = control[4];
  assign \control$623.tile  = control[8:5];
  assign \control$623.unload  = control[9];
  assign \chain_i$625[0]  = \chain_o$145 [18:0];
  assign \chain_i$625[1]  = \chain_o$145 [37:19];
  assign \chain_i$625[2]  = \chain_o$145 [56:38];
  assign \chain_i$625[3]  = \chain_o$145 [75:57];
  assign \write$628.addr  = \$72 ;
  assign \write$628.data  = \$74 [647:576];
  assign \control$630.en  = control[0];
  assign \control$630.first  = control[1];
  assign \control$630.carried  = control[2];
  assign \control$630.last  = control[3];
  assign \control$630.edge  = control[4];
  assign \control$630.tile  = control[8:5];
  assign \control$630.unload  = control[9];
  assign \chain_i$632[0]  = \chain_o$154 [18:0];
  assign \chain_i$632[1]  = \chain_o$154 [37:19];
  assign \chain_i$632[2]  = \chain_o$154 [56:38];
  assign \chain_i$632[3]  = \chain_o$154 [75:57];
  assign \control0.en  = control0[0];
  assign \control0.first  = control0[1];
  assign \control0.carried  = control0[2];
  assign \control0.last  = control0[3];
  assign \control0.edge  = control0[4];
  assign \control0.tile  = control0[8:5];
  assign \control0.unload  = control0[9];
  assign \info0.tile  = info0[3:0];
  assign \info0.tile_last  = info0[4];
  assign \info0.slots  = info0[8:5];
  assign \info0.edge  = info0[9];
  assign \info0.image_last  = info0[10];
  assign \info0.triple  = info0[11];
  assign \info0.inner  = info0[12];
  assign \info0.unloaded  = info0[13];
  assign \control1.en  = control1[0];
  assign \control1.first  = control1[1];
  assign \control1.carried  = control1[2];
  assign \control1.last  = control1[3];
  assign \control1.edge  = control1[4];
  assign \control1.tile  = control1[8:5];
  assign \control1.unload  = control1[9];
  assign \info1.tile  = info1[3:0];
  assign \info1.tile_last  = info1[4];
  assign \info1.slots  = info1[8:5];
  assign \info1.edge  = info1[9];
  assign \info1.image_last  = info1[10];
  assign \info1.triple  = info1[11];
  assign \info1.inner  = info1[12];
  assign \info1.unloaded  = info1[13];
  assign \info2.tile  = info2[3:0];
  assign \info2.tile_last  = info2[4];
  assign \info2.slots  = info2[8:5];
  assign \info2.edge  = info2[9];
  assign \info2.image_last  = info2[10];
  assign \info2.triple  = info2[11];
  assign \info2.inner  = info2[12];
  assign \info2.unloaded  = info2[13];
  assign heads[303:228] = \chain_o$154 ;
  assign heads[227:152] = \chain_o$145 ;
  assign heads[151:76] = \chain_o$136 ;
  assign heads[75:0] = chain_o;
  assign \$2  = last_beat0;
  assign \$4  = \$3 ;
  assign \$16  = 1'h0;
  assign \$17  = params__ready;
  assign \$25  = overlaps;
endmodule

module \macram_top.array.decoder (rst, soft_reset, height, width, c_in, c_out, mode, weight_base, requant_base, shape, error, weight_end, requant_end, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$2  = 0;
  wire [32:0] \$1 ;
  wire \$10 ;
  wire [31:0] \$11 ;
  wire [31:0] \$12 ;
  wire [31:0] \$13 ;
  wire [32:0] \$14 ;
  wire [32:0] \$15 ;
  wire [14:0] \$16 ;
  wire [14:0] \$17 ;
  wire [32:0] \$18 ;
  wire [32:0] \$19 ;
  wire [32:0] \$2 ;
  wire [33:0] \$20 ;
  wire [34:0] \$21 ;
  wire [34:0] \$22 ;
  wire [33:0] \$23 ;
  wire [34:0] \$24 ;
  wire [34:0] \$25 ;
  wire \$26 ;
  wire [12:0] \$27 ;
  wire [5:0] \$28 ;
  wire [8:0] \$29 ;
  wire [14:0] \$3 ;
  wire [8:0] \$30 ;
  wire [10:0] \$31 ;
  wire [10:0] \$32 ;
  wire [12:0] \$33 ;
  wire [26:0] \$34 ;
  wire [27:0] \$35 ;
  wire [28:0] \$36 ;
  wire \$37 ;
  wire \$38 ;
  wire \$39 ;
  wire [14:0] \$4 ;
  wire \$40 ;
  wire \$41 ;
  wire \$42 ;
  wire \$43 ;
  wire \$44 ;
  wire \$45 ;
  wire [29:0] \$46 ;
  wire \$47 ;
  wire \$48 ;
  wire \$49 ;
  wire [32:0] \$5 ;
  wire \$50 ;
  wire [32:0] \$51 ;
  wire \$52 ;
  wire [16:0] \$53 ;
  wire [32:0] \$54 ;
  wire \$55 ;
  wire \$56 ;
  wire [32:0] \$57 ;
  wire [16:0] \$58 ;
  wire [32:0] \$59 ;
  wire [32:0] \$6 ;
  reg [200:0] \$60 ;
  reg [11:0] \$61 ;
  reg [28:0] \$62 ;
  reg \$63 ;
  reg \$64 ;
  reg [2:0] \$65 ;
  reg [10:0] \$66 ;
  reg [8:0] \$67 ;
  wire \$7 ;
  wire \$8 ;
  wire \$9 ;
  wire [13:0] \$signal ;
  wire [25:0] \$signal$10 ;
  reg \$signal$18  = 1'h0;
  wire [11:0] \$signal$3 ;
  wire \$signal$5 ;
  wire [31:0] \$signal$8 ;
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
  input [31:0] height;
  wire [31:0] height;
  wire [13:0] ingest_words;
  reg known_mode;
  input [31:0] mode;
  wire [31:0] mode;
  wire \packed ;
  reg [11:0] places = 12'h000;
  input [31:0] requant_base;
  wire [31:0] requant_base;
  output [8:0] requant_end;
  reg [8:0] requant_end = 9'h000;
  input rst;
  wire rst;
  output [200:0] shape;
  reg [200:0] shape = 201'h000000000000000000000000000000000000000000000000000;
  wire [15:0] \shape.beats_in ;
  wire [15:0] \shape.beats_out ;
  wire [15:0] \shape.beats_residual ;
  wire \shape.biased ;
  wire [13:0] \shape.blocks ;
  wire [14:0] \shape.column_words ;
  wire [14:0] \shape.groups ;
  wire \shape.halved ;
  wire [15:0] \shape.height ;
  wire [13:0] \shape.ingest_words ;
  wire [15:0] \shape.out_height ;
  wire [15:0] \shape.out_width ;
  wire [11:0] \shape.output_words ;
  wire \shape.packed ;
  wire \shape.pointwise ;
  wire \shape.residual ;
  wire [1:0] \shape.tail ;
  wire [11:0] \shape.tiles ;
  wire [15:0] \shape.width ;
  input soft_reset;
  wire soft_reset;
  input [31:0] weight_base;
  wire [31:0] weight_base;
  output [10:0] weight_end;
  reg [10:0] weight_end = 11'h000;
  reg [28:0] weight_words = 29'h00000000;
  input [31:0] width;
  wire [31:0] width;
  assign \$31  = 2'h2 * \$30 ;
  assign \$32  = \packed  ? \$31  : 11'h000;
  assign \$33  = \$6 [11:0] - \$32 ;
  assign \$35  = \$34  + \$signal$10 ;
  assign \$36  = \$35  << shape[165];
  assign \$37  = ~ known_mode;
  assign \$38  = ! height;
  assign \$39  = ! width;
  assign \$40  = ! c_in;
  assign \$41  = ! c_out;
  assign \$42  = height > 16'hffff;
  assign \$43  = width > 16'hffff;
  assign \$44  = c_in > 11'h400;
  assign \$45  = c_out > 11'h400;
  assign \$46  = shape[62:48] * shape[107:93];
  assign \$47  = \$46  > 9'h100;
  assign \$48  = | { \$47 , \$45 , \$44 , \$43 , \$42 , \$41 , \$40 , \$39 , \$38  };
  assign \$49  = weight_words > 11'h400;
  assign \$50  = bad_shape | \$49 ;
  assign \$51  = weight_base + weight_words;
  assign \$52  = \$51  > 11'h400;
  assign \$53  = shape[119:108] * 5'h10;
  assign \$54  = requant_base + \$53 ;
  assign \$55  = \$54  > 9'h100;
  assign \$56  = \$52  | \$55 ;
  assign \$57  = weight_base + weight_words;
  assign \$58  = shape[119:108] * 5'h10;
  assign \$59  = requant_base + \$58 ;
  always @(posedge clk)
    shape <= \$60 ;
  always @(posedge clk)
    places <= \$61 ;
  always @(posedge clk)
    weight_words <= \$62 ;
  always @(posedge clk)
    \$signal$18  <= \$63 ;
  always @(posedge clk)
    bad_shape <= \$64 ;
  always @(posedge clk)
    error <= \$65 ;
  always @(posedge clk)
    weight_end <= \$66 ;
  always @(posedge clk)
    requant_end <= \$67 ;
  assign \$1  = c_in + 3'h7;
  assign \$3  = \$2 [13:0] + 1'h1;
  assign \$5  = c_out + 6'h3f;
  assign \$7  = ~ mode[1];
  assign \$8  = \$2 [13:0] >= 6'h21;
  assign \$9  = \$7  & \$8 ;
  assign \$10  = \$6 [11:0] >= 2'h3;
  assign \packed  = \$9  & \$10 ;
  assign \$11  = width[31:1] + width[0];
  assign \$signal$8  = mode[9] ? \$11  : width;
  assign \$signal$10  = places * shape[78:65];
  assign \$12  = height[31:1] + height[0];
  assign \$13  = mode[9] ? \$12  : height;
  assign \$14  = \$signal$8  + 2'h3;
  assign \$17  = mode[9] ? \$16  : { 1'h0, \$4 [13:0] };
  assign \$18  = c_out + 4'hf;
  assign \$20  = c_in * 2'h3;
  assign \$21  = \$20  + 6'h3f;
  assign \$23  = c_out * 2'h3;
  assign \$24  = \$23  + 6'h3f;
  assign \$26  = ~ mode[1];
  assign \$27  = \$6 [11:0] - 2'h2;
  assign \$28  = \$27 [4:0] + 2'h2;
  assign \$29  = \$28 [4:0] * 4'hb;
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
    \$60 [200:168] = shape[200:168];
    \$60 [15:0] = height[15:0];
    \$60 [31:16] = width[15:0];
    \$60 [47:32] = \$13 [15:0];
    \$60 [62:48] = \$15 [14:0];
    \$60 [64:63] = \$signal$8 [1:0];
    \$60 [78:65] = \$2 [13:0];
    \$60 [92:79] = \$4 [13:0];
    \$60 [107:93] = \$17 ;
    \$60 [119:108] = \$6 [11:0];
    \$60 [131:120] = \$19 [11:0];
    \$60 [147:132] = \$22 [15:0];
    \$60 [163:148] = \$25 [15:0];
    \$60 [164] = \$26 ;
    \$60 [165] = mode[9];
    \$60 [166] = \packed ;
    \$60 [167] = mode[24];
    if (soft_reset) begin
      \$60 [167:0] = 168'h000000000000000000000000000000000000000000;
    end
    if (rst) begin
      \$60  = 201'h000000000000000000000000000000000000000000000000000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$2 ) begin end
    \$61  = \$33 [11:0];
    if (soft_reset) begin
      \$61  = 12'h000;
    end
    if (rst) begin
      \$61  = 12'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$2 ) begin end
    (* full_case = 32'd1 *)
    if (shape[164]) begin
      \$62  = { 3'h0, \$signal$10  };
    end else begin
      \$62  = \$36 ;
    end
    if (soft_reset) begin
      \$62  = 29'h00000000;
    end
    if (rst) begin
      \$62  = 29'h00000000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$2 ) begin end
    \$63  = \$37 ;
    if (soft_reset) begin
      \$63  = 1'h0;
    end
    if (rst) begin
      \$63  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$2 ) begin end
    \$64  = \$48 ;
    if (soft_reset) begin
      \$64  = 1'h0;
    end
    if (rst) begin
      \$64  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$2 ) begin end
    (* full_case = 32'd1 *)
    if (\$signal$18 ) begin
      \$65  = 3'h2;
    end else if (\$50 ) begin
      \$65  = 3'h1;
    end else if (\$56 ) begin
      \$65  = 3'h6;
    end else begin
      \$65  = 3'h0;
    end
    if (soft_reset) begin
      \$65  = 3'h0;
    end
    if (rst) begin
      \$65  = 3'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$2 ) begin end
    \$66  = \$57 [10:0];
    if (soft_reset) begin
      \$66  = 11'h000;
    end
    if (rst) begin
      \$66  = 11'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$2 ) begin end
    \$67  = \$59 [8:0];
    if (soft_reset) begin
      \$67  = 9'h000;
    end
    if (rst) begin
      \$67  = 9'h000;
    end
  end
  assign \$signal  = \$2 [13:0];
  assign ingest_words = \$4 [13:0];
  assign \$signal$3  = \$6 [11:0];
  assign \$signal$5  = mode[9];
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
  assign \shape.packed  = shape[166];
  assign \shape.biased  = shape[167];
  assign \shape.residual  = shape[168];
  assign \shape.out_width  = shape[184:169];
  assign \shape.beats_residual  = shape[200:185];
  assign \$2  = { 3'h0, \$1 [32:3] };
  assign \$4  = { 1'h0, \$3 [14:1] };
  assign \$6  = { 6'h00, \$5 [32:6] };
  assign \$15  = { 2'h0, \$14 [32:2] };
  assign \$16  = { \$4 [13:0], 1'h0 };
  assign \$19  = { 4'h0, \$18 [32:4] };
  assign \$22  = { 6'h00, \$21 [34:6] };
  assign \$25  = { 6'h00, \$24 [34:6] };
  assign \$30  = { 5'h00, \$29 [8:5] };
  assign \$34  = { \$signal$10 , 1'h0 };
endmodule

module \macram_top.array.drain (rst, finished, credit, shift, o__ready, soft_reset, requant_base, start, \heads$75 , info, shape, o__payload, valid, reload__addr, reload__data, reload__en, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$3  = 0;
  wire \$1 ;
  wire \$10 ;
  wire \$11 ;
  wire \$12 ;
  wire \$13 ;
  wire \$14 ;
  wire \$15 ;
  wire \$16 ;
  wire \$17 ;
  wire [1:0] \$18 ;
  wire [4:0] \$19 ;
  wire \$2 ;
  wire [8:0] \$20 ;
  wire \$21 ;
  wire \$22 ;
  wire [3:0] \$23 ;
  reg [3:0] \$24 ;
  wire [12:0] \$25 ;
  wire \$26 ;
  wire \$27 ;
  wire \$28 ;
  wire \$29 ;
  wire \$3 ;
  wire \$30 ;
  wire \$31 ;
  wire \$32 ;
  wire [5:0] \$33 ;
  wire [5:0] \$34 ;
  wire \$35 ;
  wire \$36 ;
  wire [2:0] \$37 ;
  wire [18:0] \$38 ;
  wire \$39 ;
  wire \$4 ;
  wire [18:0] \$40 ;
  wire \$41 ;
  wire [18:0] \$42 ;
  wire \$43 ;
  wire [18:0] \$44 ;
  wire \$45 ;
  wire \$46 ;
  wire \$47 ;
  wire \$48 ;
  wire \$49 ;
  wire \$5 ;
  wire \$50 ;
  wire \$51 ;
  wire \$52 ;
  wire \$53 ;
  wire [2:0] \$54 ;
  wire [12:0] \$55 ;
  wire [2:0] \$56 ;
  reg \$57 ;
  reg [13:0] \$58 ;
  reg \$59 ;
  wire \$6 ;
  reg [4:0] \$60 ;
  reg [13:0] \$61 ;
  reg [3:0] \$62 ;
  reg [1:0] \$63 ;
  reg [303:0] \$64 ;
  reg \$65 ;
  reg \$66 ;
  reg \$67 ;
  reg \$68 ;
  reg \$69 ;
  wire \$7 ;
  reg \$70 ;
  reg \$71 ;
  reg \$72 ;
  reg \$73 ;
  reg \$74 ;
  reg [1:0] \$75 ;
  reg [2:0] \$76 ;
  reg [11:0] \$77 ;
  reg [1:0] \$78 ;
  reg [1:0] \$79 ;
  wire \$8 ;
  reg [3:0] \$80 ;
  reg [3:0] \$81 ;
  reg [3:0] \$82 ;
  reg [3:0] \$83 ;
  reg [3:0] \$84 ;
  reg [3:0] \$85 ;
  wire \$9 ;
  wire \$signal ;
  wire \$signal$10 ;
  reg \$signal$100  = 1'h0;
  reg [5:0] \$signal$101  = 6'h00;
  reg \$signal$102  = 1'h0;
  reg \$signal$103  = 1'h0;
  reg \$signal$104  = 1'h0;
  reg [3:0] \$signal$105  = 4'h0;
  reg \$signal$106  = 1'h0;
  wire \$signal$11 ;
  wire \$signal$12 ;
  wire \$signal$13 ;
  wire \$signal$15 ;
  reg \$signal$16  = 1'h0;
  wire [1:0] \$signal$18 ;
  wire \$signal$2 ;
  reg [3:0] \$signal$3  = 4'h0;
  (* init = 6'h00 *)
  wire [5:0] \$signal$32 ;
  reg \$signal$36  = 1'h0;
  reg \$signal$37  = 1'h0;
  reg \$signal$38  = 1'h0;
  (* init = 8'h00 *)
  wire [7:0] \$signal$43 ;
  reg [1:0] \$signal$46  = 2'h0;
  reg [1:0] \$signal$48  = 2'h0;
  reg [1:0] \$signal$53  = 2'h0;
  reg \$signal$6  = 1'h0;
  reg [7:0] \$signal$77  = 8'h00;
  reg [1:0] \$signal$78  = 2'h0;
  reg \$signal$79  = 1'h0;
  wire \$signal$8 ;
  reg \$signal$80  = 1'h0;
  reg [3:0] \$signal$81  = 4'h0;
  reg \$signal$82  = 1'h0;
  reg [5:0] \$signal$83  = 6'h00;
  reg \$signal$84  = 1'h0;
  reg \$signal$85  = 1'h0;
  reg [7:0] \$signal$86  = 8'h00;
  reg [1:0] \$signal$87  = 2'h0;
  reg \$signal$88  = 1'h0;
  reg \$signal$89  = 1'h0;
  reg [3:0] \$signal$90  = 4'h0;
  reg \$signal$91  = 1'h0;
  reg [5:0] \$signal$92  = 6'h00;
  reg \$signal$93  = 1'h0;
  reg \$signal$94  = 1'h0;
  reg [7:0] \$signal$95  = 8'h00;
  reg [1:0] \$signal$96  = 2'h0;
  reg \$signal$97  = 1'h0;
  reg \$signal$98  = 1'h0;
  reg [3:0] \$signal$99  = 4'h0;
  wire [7:0] \$signature__addr ;
  reg [5:0] \$signature__addr$31  = 6'h00;
  wire [671:0] \$signature__data ;
  wire [23:0] \$signature__data$33 ;
  wire \$signature__en ;
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
  reg [13:0] current = 14'h0000;
  wire \current.edge ;
  wire \current.image_last ;
  wire \current.inner ;
  wire [3:0] \current.slots ;
  wire [3:0] \current.tile ;
  wire \current.tile_last ;
  wire \current.triple ;
  wire \current.unloaded ;
  reg \edge  = 1'h0;
  wire fetch;
  reg [3:0] filled = 4'h0;
  input finished;
  wire finished;
  wire [7:0] get__addr;
  wire [191:0] get__data;
  wire get__en;
  (* init = 304'h0000000000000000000000000000000000000000000000000000000000000000000000000000 *)
  wire [303:0] heads;
  input [303:0] \heads$75 ;
  wire [303:0] \heads$75 ;
  wire [75:0] \heads$75[0] ;
  wire [18:0] \heads$75[0][0] ;
  wire [18:0] \heads$75[0][1] ;
  wire [18:0] \heads$75[0][2] ;
  wire [18:0] \heads$75[0][3] ;
  wire [75:0] \heads$75[1] ;
  wire [18:0] \heads$75[1][0] ;
  wire [18:0] \heads$75[1][1] ;
  wire [18:0] \heads$75[1][2] ;
  wire [18:0] \heads$75[1][3] ;
  wire [75:0] \heads$75[2] ;
  wire [18:0] \heads$75[2][0] ;
  wire [18:0] \heads$75[2][1] ;
  wire [18:0] \heads$75[2][2] ;
  wire [18:0] \heads$75[2][3] ;
  wire [75:0] \heads$75[3] ;
  wire [18:0] \heads$75[3][0] ;
  wire [18:0] \heads$75[3][1] ;
  wire [18:0] \heads$75[3][2] ;
  wire [18:0] \heads$75[3][3] ;
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
  reg [4:0] index = 5'h00;
  input [13:0] info;
  wire [13:0] info;
  wire \info.edge ;
  wire \info.image_last ;
  wire \info.inner ;
  wire [3:0] \info.slots ;
  wire [3:0] \info.tile ;
  wire \info.tile_last ;
  wire \info.triple ;
  wire \info.unloaded ;
  wire [13:0] info_now;
  wire \info_now.edge ;
  wire \info_now.image_last ;
  wire \info_now.inner ;
  wire [3:0] \info_now.slots ;
  wire [3:0] \info_now.tile ;
  wire \info_now.tile_last ;
  wire \info_now.triple ;
  wire \info_now.unloaded ;
  (* init = 6'h00 *)
  wire [5:0] kept__addr;
  wire [23:0] kept__data;
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
  wire [47:0] pixels;
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
  input [200:0] shape;
  wire [200:0] shape;
  wire [15:0] \shape.beats_in ;
  wire [15:0] \shape.beats_out ;
  wire [15:0] \shape.beats_residual ;
  wire \shape.biased ;
  wire [13:0] \shape.blocks ;
  wire [14:0] \shape.column_words ;
  wire [14:0] \shape.groups ;
  wire \shape.halved ;
  wire [15:0] \shape.height ;
  wire [13:0] \shape.ingest_words ;
  wire [15:0] \shape.out_height ;
  wire [15:0] \shape.out_width ;
  wire [11:0] \shape.output_words ;
  wire \shape.packed ;
  wire \shape.pointwise ;
  wire \shape.residual ;
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
  wire [3:0] tile;
  wire [3:0] todo;
  output valid;
  reg valid = 1'h0;
  reg [13:0] waiting = 14'h0000;
  wire \waiting.edge ;
  wire \waiting.image_last ;
  wire \waiting.inner ;
  wire [3:0] \waiting.slots ;
  wire [3:0] \waiting.tile ;
  wire \waiting.tile_last ;
  wire \waiting.triple ;
  wire \waiting.unloaded ;
  reg [11:0] word = 12'h000;
  wire word_last;
  wire [679:0] write;
  wire [7:0] \write.addr ;
  wire [671:0] \write.data ;
  wire write_en;
  assign \$signal$10  = \$10  & \$signal$8 ;
  assign \$11  = \$signal$10  & info_now[4];
  assign \$12  = ~ info_now[11];
  assign \$13  = info_now[13] | \$12 ;
  assign \$signal$12  = \$11  & \$13 ;
  assign \$14  = index[3:0] == 4'h9;
  assign \$15  = \$signal$11  & \$14 ;
  assign \$signal$13  = \$15  & \$signal$8 ;
  assign \$16  = ~ \$signal$6 ;
  assign \$17  = \$signal$16  & \$16 ;
  assign \$signal$15  = \$17  & \$signal$2 ;
  assign \$signal$11  = \$signal$6  | \$signal$15 ;
  assign \$18  = 1'h1 + index[4];
  assign \$signal$18  = info_now[13] ? \$18  : 2'h0;
  assign \$19  = info_now[3:0] + \$signal$18 ;
  assign \$20  = { \$19 [3:0], index[3:0] } + requant_base;
  assign \$21  = \$signal$36  & \$signal$37 ;
  assign \$22  = ~ \$signal$38 ;
  assign \$signature__en  = \$21  & \$22 ;
  assign pixels = \$signal$37  ? { kept__data[23:12], codes[47:36], codes[11:0], kept__data[11:0] } : codes;
  assign \$23  = 1'h1 << \$signal$46 ;
  assign put__en = \$signal$36  ? \$23  : 4'h0;
  assign todo = \$24  >> \$signal$53 ;
  assign \$25  = word + 1'h1;
  assign word_last = \$25  == shape[131:120];
  assign pixel_after = | todo[3:1];
  assign \$26  = ~ valid;
  assign advance = \$26  | o__ready;
  assign \$27  = filled >> \$signal$48 ;
  assign fetch = \$27  & advance;
  assign \$28  = ~ todo[0];
  assign \$29  = word_last | \$28 ;
  assign \$30  = fetch & \$29 ;
  assign \$31  = ~ pixel_after;
  assign section_done = \$30  & \$31 ;
  assign \$32  = ~ \$signal$10 ;
  assign \$33  = index + 1'h1;
  assign \$34  = \$signal$10  ? 6'h00 : \$33 ;
  assign \$37  = section + 1'h1;
  assign \$38  = index[4] ? \heads$75 [56:38] : \heads$75 [37:19];
  assign \$39  = ~ index[4];
  assign \$40  = index[4] ? \heads$75 [132:114] : \heads$75 [113:95];
  assign \$41  = ~ index[4];
  assign \$42  = index[4] ? \heads$75 [208:190] : \heads$75 [189:171];
  assign \$43  = ~ index[4];
  assign \$44  = index[4] ? \heads$75 [284:266] : \heads$75 [265:247];
  assign \$45  = ~ index[4];
  assign \$48  = fetch & todo[0];
  assign \$49  = image_last >> \$signal$48 ;
  assign \$50  = ~ pixel_after;
  assign \$51  = \$49  & \$50 ;
  assign \$52  = ~ todo[0];
  assign \$53  = \$52  | word_last;
  assign \$54  = \$signal$53  + 1'h1;
  assign \$55  = word + 1'h1;
  assign \$56  = \$signal$48  + 1'h1;
  always @(posedge clk)
    \$signal$16  <= \$57 ;
  always @(posedge clk)
    waiting <= \$58 ;
  always @(posedge clk)
    \$signal$6  <= \$59 ;
  always @(posedge clk)
    index <= \$60 ;
  always @(posedge clk)
    current <= \$61 ;
  always @(posedge clk)
    \$signal$3  <= \$62 ;
  always @(posedge clk)
    section <= \$63 ;
  always @(posedge clk)
    accumulators <= \$64 ;
  always @(posedge clk)
    \edge  <= \$65 ;
  always @(posedge clk)
    \$signal$77  <= { section, \$19 [3:0], index[3:2] };
  always @(posedge clk)
    \$signal$78  <= index[1:0];
  always @(posedge clk)
    \$signal$79  <= \$66 ;
  always @(posedge clk)
    \$signal$80  <= \$67 ;
  always @(posedge clk)
    \$signal$81  <= info_now[8:5];
  always @(posedge clk)
    \$signal$82  <= info_now[10];
  always @(posedge clk)
    \$signal$83  <= { \$signal$18 , index[3:0] };
  always @(posedge clk)
    \$signal$84  <= info_now[11];
  always @(posedge clk)
    \$signal$85  <= info_now[12];
  always @(posedge clk)
    \$signal$86  <= \$signal$77 ;
  always @(posedge clk)
    \$signal$87  <= \$signal$78 ;
  always @(posedge clk)
    \$signal$88  <= \$68 ;
  always @(posedge clk)
    \$signal$89  <= \$69 ;
  always @(posedge clk)
    \$signal$90  <= \$signal$81 ;
  always @(posedge clk)
    \$signal$91  <= \$signal$82 ;
  always @(posedge clk)
    \$signal$92  <= \$signal$83 ;
  always @(posedge clk)
    \$signal$93  <= \$signal$84 ;
  always @(posedge clk)
    \$signal$94  <= \$signal$85 ;
  always @(posedge clk)
    \$signal$95  <= \$signal$86 ;
  always @(posedge clk)
    \$signal$96  <= \$signal$87 ;
  always @(posedge clk)
    \$signal$97  <= \$70 ;
  always @(posedge clk)
    \$signal$98  <= \$71 ;
  always @(posedge clk)
    \$signal$99  <= \$signal$90 ;
  always @(posedge clk)
    \$signal$100  <= \$signal$91 ;
  always @(posedge clk)
    \$signal$101  <= \$signal$92 ;
  always @(posedge clk)
    \$signal$102  <= \$signal$93 ;
  always @(posedge clk)
    \$signal$103  <= \$signal$94 ;
  always @(posedge clk)
    put__addr <= \$signal$95 ;
  always @(posedge clk)
    \$signal$46  <= \$signal$96 ;
  always @(posedge clk)
    \$signal$36  <= \$72 ;
  always @(posedge clk)
    \$signal$104  <= \$73 ;
  always @(posedge clk)
    \$signal$105  <= \$signal$99 ;
  always @(posedge clk)
    \$signal$106  <= \$signal$100 ;
  always @(posedge clk)
    \$signature__addr$31  <= \$signal$101 ;
  always @(posedge clk)
    \$signal$37  <= \$signal$102 ;
  always @(posedge clk)
    \$signal$38  <= \$signal$103 ;
  always @(posedge clk)
    valid <= \$74 ;
  always @(posedge clk)
    slot_read <= \$75 ;
  always @(posedge clk)
    meta <= \$76 ;
  always @(posedge clk)
    word <= \$77 ;
  always @(posedge clk)
    \$signal$53  <= \$78 ;
  always @(posedge clk)
    \$signal$48  <= \$79 ;
  always @(posedge clk)
    filled <= \$80 ;
  always @(posedge clk)
    image_last <= \$81 ;
  always @(posedge clk)
    slots0 <= \$82 ;
  always @(posedge clk)
    slots1 <= \$83 ;
  always @(posedge clk)
    slots2 <= \$84 ;
  always @(posedge clk)
    slots3 <= \$85 ;
  assign \$1  = ! waiting[3:0];
  assign \$2  = ~ waiting[12];
  assign \$3  = \$1  & \$2 ;
  assign \$4  = ~ waiting[13];
  assign \$signal  = \$3  & \$4 ;
  assign \$5  = ~ \$signal ;
  assign \$6  = \$signal$3  >> section;
  assign \$7  = ~ \$6 ;
  assign \$signal$2  = \$5  | \$7 ;
  assign info_now = \$signal$6  ? current : waiting;
  assign \$8  = ~ info_now[13];
  assign \$signal$8  = index[4] | \$8 ;
  assign \$9  = index[3:0] == 4'hf;
  assign \$10  = \$signal$11  & \$9 ;
  macram_ram #(
    .ADDR_BITS(32'd8),
    .DEPTH(32'd256),
    .INIT_FILE(),
    .LANES(32'd4),
    .WIDTH(32'd192)
  ) buffer (
    .clk(clk),
    .read_addr({ \$signal$48 , word[5:0] }),
    .read_data(get__data),
    .read_en(advance),
    .write_addr(put__addr),
    .write_data({ pixels, pixels, pixels, pixels }),
    .write_en(put__en)
  );
  macram_lutram #(
    .ADDR_BITS(32'd6),
    .DEPTH(32'd48),
    .INIT_FILE(),
    .LANES(32'd1),
    .WIDTH(32'd24)
  ) outer (
    .clk(clk),
    .read_addr(\$signature__addr$31 ),
    .read_data(kept__data),
    .write_addr(\$signature__addr$31 ),
    .write_data({ codes[47:36], codes[11:0] }),
    .write_en(\$signature__en )
  );
  macram_ram #(
    .ADDR_BITS(32'd8),
    .DEPTH(32'd256),
    .INIT_FILE("requant.mem"),
    .LANES(32'd1),
    .WIDTH(32'd672)
  ) \parameters$110  (
    .clk(clk),
    .read_addr(\$20 [7:0]),
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
    casez (\$signal$48 )
      2'h0:
          \$24  = slots0;
      2'h1:
          \$24  = slots1;
      2'h2:
          \$24  = slots2;
      2'h3:
          \$24  = slots3;
    endcase
  end
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
    \$57  = \$signal$16 ;
    if (finished) begin
      \$57  = 1'h1;
    end else if (\$signal$15 ) begin
      \$57  = 1'h0;
    end
    if (start) begin
      \$57  = 1'h0;
    end
    if (soft_reset) begin
      \$57  = 1'h0;
    end
    if (rst) begin
      \$57  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$58  = waiting;
    if (finished) begin
      \$58  = info;
    end
    if (soft_reset) begin
      \$58  = 14'h0000;
    end
    if (rst) begin
      \$58  = 14'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$59  = \$signal$6 ;
    if (\$signal$11 ) begin
      \$59  = \$32 ;
    end
    if (start) begin
      \$59  = 1'h0;
    end
    if (soft_reset) begin
      \$59  = 1'h0;
    end
    if (rst) begin
      \$59  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$60  = index;
    if (\$signal$11 ) begin
      \$60  = \$34 [4:0];
    end
    if (start) begin
      \$60  = 5'h00;
    end
    if (soft_reset) begin
      \$60  = 5'h00;
    end
    if (rst) begin
      \$60  = 5'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$61  = current;
    if (\$signal$15 ) begin
      \$61  = waiting;
    end
    if (soft_reset) begin
      \$61  = 14'h0000;
    end
    if (rst) begin
      \$61  = 14'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$62  = \$signal$3 ;
    if (\$signal$15 ) begin
      if (\$36 ) begin
        (* full_case = 32'd1 *)
        casez (section)
          2'h0:
              \$62 [0] = 1'h1;
          2'h1:
              \$62 [1] = 1'h1;
          2'h2:
              \$62 [2] = 1'h1;
          2'h3:
              \$62 [3] = 1'h1;
        endcase
      end
    end
    if (section_done) begin
      (* full_case = 32'd1 *)
      casez (\$signal$48 )
        2'h0:
            \$62 [0] = 1'h0;
        2'h1:
            \$62 [1] = 1'h0;
        2'h2:
            \$62 [2] = 1'h0;
        2'h3:
            \$62 [3] = 1'h0;
      endcase
    end
    if (start) begin
      \$62  = 4'h0;
    end
    if (soft_reset) begin
      \$62  = 4'h0;
    end
    if (rst) begin
      \$62  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$63  = section;
    if (\$signal$12 ) begin
      \$63  = \$37 [1:0];
    end
    if (start) begin
      \$63  = 2'h0;
    end
    if (soft_reset) begin
      \$63  = 2'h0;
    end
    if (rst) begin
      \$63  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    { \$64 [303:285], \$64 [246:209], \$64 [170:133], \$64 [94:57], \$64 [18:0] } = { \heads$75 [303:285], \heads$75 [246:209], \heads$75 [170:133], \heads$75 [94:57], \heads$75 [18:0] };
    if (info_now[13]) begin
      \$64 [18:0] = \$38 ;
      if (\$39 ) begin
        \$64 [75:57] = \heads$75 [18:0];
      end
      begin
          \$64 [94:76] = \$40 ;
      end
      if (\$41 ) begin
        \$64 [151:133] = \heads$75 [94:76];
      end
      begin
          \$64 [170:152] = \$42 ;
      end
      if (\$43 ) begin
        \$64 [227:209] = \heads$75 [170:152];
      end
      begin
          \$64 [246:228] = \$44 ;
      end
      if (\$45 ) begin
        \$64 [303:285] = \heads$75 [246:228];
      end
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$65  = info_now[9];
    if (soft_reset) begin
      \$65  = 1'h0;
    end
    if (rst) begin
      \$65  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$66  = \$signal$11 ;
    if (soft_reset) begin
      \$66  = 1'h0;
    end
    if (rst) begin
      \$66  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$67  = \$47 ;
    if (soft_reset) begin
      \$67  = 1'h0;
    end
    if (rst) begin
      \$67  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$68  = \$signal$79 ;
    if (soft_reset) begin
      \$68  = 1'h0;
    end
    if (rst) begin
      \$68  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$69  = \$signal$80 ;
    if (soft_reset) begin
      \$69  = 1'h0;
    end
    if (rst) begin
      \$69  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$70  = \$signal$88 ;
    if (soft_reset) begin
      \$70  = 1'h0;
    end
    if (rst) begin
      \$70  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$71  = \$signal$89 ;
    if (soft_reset) begin
      \$71  = 1'h0;
    end
    if (rst) begin
      \$71  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$72  = \$signal$97 ;
    if (soft_reset) begin
      \$72  = 1'h0;
    end
    if (rst) begin
      \$72  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$73  = \$signal$98 ;
    if (soft_reset) begin
      \$73  = 1'h0;
    end
    if (rst) begin
      \$73  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$74  = valid;
    if (advance) begin
      \$74  = \$48 ;
    end
    if (start) begin
      \$74  = 1'h0;
    end
    if (soft_reset) begin
      \$74  = 1'h0;
    end
    if (rst) begin
      \$74  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$75  = slot_read;
    if (advance) begin
      \$75  = \$signal$53 ;
    end
    if (soft_reset) begin
      \$75  = 2'h0;
    end
    if (rst) begin
      \$75  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$76  = meta;
    if (advance) begin
      \$76 [1] = word_last;
      \$76 [2] = \$51 ;
    end
    if (soft_reset) begin
      \$76 [2:1] = 2'h0;
    end
    if (rst) begin
      \$76  = 3'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$77  = word;
    if (fetch) begin
      (* full_case = 32'd1 *)
      if (\$53 ) begin
        \$77  = 12'h000;
      end else begin
        \$77  = \$55 [11:0];
      end
    end
    if (section_done) begin
      \$77  = 12'h000;
    end
    if (start) begin
      \$77  = 12'h000;
    end
    if (soft_reset) begin
      \$77  = 12'h000;
    end
    if (rst) begin
      \$77  = 12'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$78  = \$signal$53 ;
    if (fetch) begin
      if (\$53 ) begin
        \$78  = \$54 [1:0];
      end
    end
    if (section_done) begin
      \$78  = 2'h0;
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
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$79  = \$signal$48 ;
    if (section_done) begin
      \$79  = \$56 [1:0];
    end
    if (start) begin
      \$79  = 2'h0;
    end
    if (soft_reset) begin
      \$79  = 2'h0;
    end
    if (rst) begin
      \$79  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$80  = filled;
    if (section_done) begin
      (* full_case = 32'd1 *)
      casez (\$signal$48 )
        2'h0:
            \$80 [0] = 1'h0;
        2'h1:
            \$80 [1] = 1'h0;
        2'h2:
            \$80 [2] = 1'h0;
        2'h3:
            \$80 [3] = 1'h0;
      endcase
    end
    if (\$signal$104 ) begin
      (* full_case = 32'd1 *)
      casez (put__addr[7:6])
        2'h0:
            \$80 [0] = 1'h1;
        2'h1:
            \$80 [1] = 1'h1;
        2'h2:
            \$80 [2] = 1'h1;
        2'h3:
            \$80 [3] = 1'h1;
      endcase
    end
    if (start) begin
      \$80  = 4'h0;
    end
    if (soft_reset) begin
      \$80  = 4'h0;
    end
    if (rst) begin
      \$80  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$81  = image_last;
    if (\$signal$104 ) begin
      (* full_case = 32'd1 *)
      casez (put__addr[7:6])
        2'h0:
            \$81 [0] = \$signal$106 ;
        2'h1:
            \$81 [1] = \$signal$106 ;
        2'h2:
            \$81 [2] = \$signal$106 ;
        2'h3:
            \$81 [3] = \$signal$106 ;
      endcase
    end
    if (soft_reset) begin
      \$81  = 4'h0;
    end
    if (rst) begin
      \$81  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$82  = slots0;
    if (\$signal$104 ) begin
      casez (put__addr[7:6])
        2'h0:
            \$82  = \$signal$105 ;
      endcase
    end
    if (soft_reset) begin
      \$82  = 4'h0;
    end
    if (rst) begin
      \$82  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$83  = slots1;
    if (\$signal$104 ) begin
      casez (put__addr[7:6])
        2'h0:
            /* empty */;
        2'h1:
            \$83  = \$signal$105 ;
      endcase
    end
    if (soft_reset) begin
      \$83  = 4'h0;
    end
    if (rst) begin
      \$83  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$84  = slots2;
    if (\$signal$104 ) begin
      casez (put__addr[7:6])
        2'h0:
            /* empty */;
        2'h1:
            /* empty */;
        2'h2:
            \$84  = \$signal$105 ;
      endcase
    end
    if (soft_reset) begin
      \$84  = 4'h0;
    end
    if (rst) begin
      \$84  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$85  = slots3;
    if (\$signal$104 ) begin
      (* full_case = 32'd1 *)
      casez (put__addr[7:6])
        2'h0:
            /* empty */;
        2'h1:
            /* empty */;
        2'h2:
            /* empty */;
        2'h3:
            \$85  = \$signal$105 ;
      endcase
    end
    if (soft_reset) begin
      \$85  = 4'h0;
    end
    if (rst) begin
      \$85  = 4'h0;
    end
  end
  assign tile = \$19 [3:0];
  assign write = { reload__data, reload__addr };
  assign write_en = reload__en;
  assign \$signature__addr  = \$20 [7:0];
  assign \$signature__data  = parameters;
  assign heads = accumulators;
  assign \$signal$32  = \$signature__addr$31 ;
  assign \$signature__data$33  = { codes[47:36], codes[11:0] };
  assign kept__addr = \$signature__addr$31 ;
  assign \$signal$43  = put__addr;
  assign put__data = { pixels, pixels, pixels, pixels };
  assign get__addr = { \$signal$48 , word[5:0] };
  assign get__en = advance;
  assign o__valid = valid;
  assign credit = \$signal$13 ;
  assign shift = \$signal$11 ;
  assign \waiting.tile  = waiting[3:0];
  assign \waiting.tile_last  = waiting[4];
  assign \waiting.slots  = waiting[8:5];
  assign \waiting.edge  = waiting[9];
  assign \waiting.image_last  = waiting[10];
  assign \waiting.triple  = waiting[11];
  assign \waiting.inner  = waiting[12];
  assign \waiting.unloaded  = waiting[13];
  assign \info_now.tile  = info_now[3:0];
  assign \info_now.tile_last  = info_now[4];
  assign \info_now.slots  = info_now[8:5];
  assign \info_now.edge  = info_now[9];
  assign \info_now.image_last  = info_now[10];
  assign \info_now.triple  = info_now[11];
  assign \info_now.inner  = info_now[12];
  assign \info_now.unloaded  = info_now[13];
  assign \current.tile  = current[3:0];
  assign \current.tile_last  = current[4];
  assign \current.slots  = current[8:5];
  assign \current.edge  = current[9];
  assign \current.image_last  = current[10];
  assign \current.triple  = current[11];
  assign \current.inner  = current[12];
  assign \current.unloaded  = current[13];
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
  assign \shape.packed  = shape[166];
  assign \shape.biased  = shape[167];
  assign \shape.residual  = shape[168];
  assign \shape.out_width  = shape[184:169];
  assign \shape.beats_residual  = shape[200:185];
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
  assign \info.triple  = info[11];
  assign \info.inner  = info[12];
  assign \info.unloaded  = info[13];
  assign \heads$75[0]  = \heads$75 [75:0];
  assign \heads$75[0][0]  = \heads$75 [18:0];
  assign \heads$75[0][1]  = \heads$75 [37:19];
  assign \heads$75[0][2]  = \heads$75 [56:38];
  assign \heads$75[0][3]  = \heads$75 [75:57];
  assign \heads$75[1]  = \heads$75 [151:76];
  assign \heads$75[1][0]  = \heads$75 [94:76];
  assign \heads$75[1][1]  = \heads$75 [113:95];
  assign \heads$75[1][2]  = \heads$75 [132:114];
  assign \heads$75[1][3]  = \heads$75 [151:133];
  assign \heads$75[2]  = \heads$75 [227:152];
  assign \heads$75[2][0]  = \heads$75 [170:152];
  assign \heads$75[2][1]  = \heads$75 [189:171];
  assign \heads$75[2][2]  = \heads$75 [208:190];
  assign \heads$75[2][3]  = \heads$75 [227:209];
  assign \heads$75[3]  = \heads$75 [303:228];
  assign \heads$75[3][0]  = \heads$75 [246:228];
  assign \heads$75[3][1]  = \heads$75 [265:247];
  assign \heads$75[3][2]  = \heads$75 [284:266];
  assign \heads$75[3][3]  = \heads$75 [303:285];
  always @*
    \$64 [56:19] = \heads$75 [56:19];
  always @*
    \$64 [132:95] = \heads$75 [132:95];
  always @*
    \$64 [208:171] = \heads$75 [208:171];
  always @*
    \$64 [284:247] = \heads$75 [284:247];
  assign \$35  = 1'h1;
  assign \$36  = \$signal ;
  assign \$46  = 1'h1;
  assign \$47  = \$signal$12 ;
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
  wire [16:0] \$10 ;
  wire [16:0] \$11 ;
  wire \$12 ;
  wire \$13 ;
  wire \$14 ;
  wire [7:0] \$15 ;
  wire [7:0] \$16 ;
  wire [7:0] \$17 ;
  wire [7:0] \$18 ;
  wire \$19 ;
  wire [111:0] \$2 ;
  wire \$20 ;
  wire \$21 ;
  reg [15:0] \$22 ;
  reg [111:0] \$23 ;
  reg [6:0] \$24 ;
  reg \$25 ;
  reg \$26 ;
  reg [15:0] \$27 ;
  wire [111:0] \$3 ;
  wire [111:0] \$4 ;
  wire [47:0] \$5 ;
  wire [174:0] \$6 ;
  wire [174:0] \$7 ;
  wire [5:0] \$8 ;
  wire [7:0] \$9 ;
  reg [15:0] \$signal  = 16'h0000;
  reg \$signal$11  = 1'h0;
  wire \$signal$5 ;
  wire \$signal$6 ;
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
  wire last_beat;
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
  assign \$1  = beats_per_pixel - 1'h1;
  assign \$3  = \$signal$6  ? \$2  : buffer;
  assign \$4  = \$signal$5  ? 112'h0000000000000000000000000000 : \$3 ;
  assign \$5  = put ? i__payload[47:0] : 48'h000000000000;
  assign \$6  = \$5  << \$18 [6:0];
  assign \$7  = { 63'h0000000000000000, \$4  } | \$6 ;
  assign \$8  = put ? 6'h30 : 6'h00;
  assign \$9  = \$18 [6:0] + \$8 ;
  assign \$10  = beats_out + 1'h1;
  assign \$11  = \$signal$5  ? 17'h00000 : \$10 ;
  assign last_beat = beats_out == \$signal ;
  assign \$12  = last_beat & image_last;
  assign \$13  = level >= 7'h40;
  assign o__valid = \$13  | \$signal$11 ;
  assign \$signal$6  = o__valid & o__ready;
  assign \$signal$5  = \$signal$6  & last_beat;
  assign \$14  = level >= 7'h40;
  assign \$15  = level - 7'h40;
  assign \$16  = \$14  ? \$15  : 8'h00;
  assign \$17  = \$signal$6  ? \$16  : { 1'h0, level };
  assign \$18  = \$signal$5  ? 8'h00 : \$17 ;
  assign \$19  = ~ \$signal$11 ;
  assign \$20  = \$19  | \$signal$5 ;
  assign \$21  = \$18 [6:0] <= 7'h40;
  assign i__ready = \$20  & \$21 ;
  assign put = i__valid & i__ready;
  always @(posedge clk)
    \$signal  <= \$22 ;
  always @(posedge clk)
    buffer <= \$23 ;
  always @(posedge clk)
    level <= \$24 ;
  always @(posedge clk)
    \$signal$11  <= \$25 ;
  always @(posedge clk)
    image_last <= \$26 ;
  always @(posedge clk)
    beats_out <= \$27 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$5 ) begin end
    \$22  = \$1 [15:0];
    if (soft_reset) begin
      \$22  = 16'h0000;
    end
    if (rst) begin
      \$22  = 16'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$5 ) begin end
    \$23  = \$7 [111:0];
    if (soft_reset) begin
      \$23  = 112'h0000000000000000000000000000;
    end
    if (rst) begin
      \$23  = 112'h0000000000000000000000000000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$5 ) begin end
    \$24  = \$9 [6:0];
    if (soft_reset) begin
      \$24  = 7'h00;
    end
    if (rst) begin
      \$24  = 7'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$5 ) begin end
    \$25  = \$signal$11 ;
    if (put) begin
      \$25  = i__payload[48];
    end else if (\$signal$5 ) begin
      \$25  = 1'h0;
    end
    if (soft_reset) begin
      \$25  = 1'h0;
    end
    if (rst) begin
      \$25  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$5 ) begin end
    \$26  = image_last;
    if (put) begin
      \$26  = i__payload[49];
    end
    if (soft_reset) begin
      \$26  = 1'h0;
    end
    if (rst) begin
      \$26  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$5 ) begin end
    \$27  = beats_out;
    if (\$signal$6 ) begin
      \$27  = \$11 [15:0];
    end
    if (soft_reset) begin
      \$27  = 16'h0000;
    end
    if (rst) begin
      \$27  = 16'h0000;
    end
  end
  assign level_after = \$18 [6:0];
  assign \i__payload.data  = i__payload[47:0];
  assign \i__payload.pixel_last  = i__payload[48];
  assign \i__payload.last  = i__payload[49];
  assign \o__payload.data  = o__payload[63:0];
  assign \o__payload.last  = o__payload[64];
  assign o__payload[64] = \$12 ;
  assign o__payload[63:0] = buffer[63:0];
  assign \$2  = { 64'h0000000000000000, buffer[111:64] };
endmodule

module \macram_top.array.frame (i__valid, rst, o__valid, i__ready, fault, error, o__ready, i__payload, soft_reset, start, \port$1409$0 , beats, open, clk);
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
  wire \$signal$14 ;
  wire \$signal$8 ;
  reg [15:0] \$signal$9  = 16'h0000;
  input [15:0] beats;
  wire [15:0] beats;
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
  wire [15:0] height;
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
  input [31:0] \port$1409$0 ;
  wire [31:0] \port$1409$0 ;
  reg [15:0] row = 16'h0000;
  input rst;
  wire rst;
  input soft_reset;
  wire soft_reset;
  input start;
  wire start;
  wire [15:0] width;
  assign o__valid = i__valid & open;
  assign i__ready = o__ready & open;
  assign \$signal  = i__valid & i__ready;
  assign \$1  = \$signal$9  + 1'h1;
  assign \$signal$8  = \$1  == beats;
  assign \$2  = \$signal$12  + 1'h1;
  assign \$3  = \$2  == \port$1409$0 [31:16];
  assign \$signal$11  = \$signal$8  & \$3 ;
  assign \$4  = row + 1'h1;
  assign \$5  = \$4  == \port$1409$0 [15:0];
  assign \$signal$14  = \$signal$11  & \$5 ;
  assign \$6  = i__payload[64] != \$signal$14 ;
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
      if (\$signal$14 ) begin
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
  assign width = \port$1409$0 [31:16];
  assign height = \port$1409$0 [15:0];
  assign \i__payload.data  = i__payload[63:0];
  assign \i__payload.last  = i__payload[64];
endmodule

module \macram_top.array.ingest (rst, i__valid, o__valid, i__ready, o__ready, i__payload, soft_reset, \port$1409$79 , beats_per_pixel, o__payload, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$7  = 0;
  wire [16:0] \$1 ;
  wire [16:0] \$10 ;
  wire [16:0] \$11 ;
  wire [16:0] \$12 ;
  wire \$13 ;
  wire \$14 ;
  wire \$15 ;
  wire \$16 ;
  wire [7:0] \$17 ;
  wire [7:0] \$18 ;
  wire [7:0] \$19 ;
  wire [111:0] \$2 ;
  wire [7:0] \$20 ;
  wire \$21 ;
  wire \$22 ;
  reg [15:0] \$23 ;
  reg [111:0] \$24 ;
  reg [6:0] \$25 ;
  reg [15:0] \$26 ;
  reg [15:0] \$27 ;
  wire [111:0] \$3 ;
  wire [111:0] \$4 ;
  wire [63:0] \$5 ;
  wire [190:0] \$6 ;
  wire [190:0] \$7 ;
  wire [6:0] \$8 ;
  wire [7:0] \$9 ;
  wire [6:0] \$like ;
  wire \$signal ;
  reg [15:0] \$signal$11  = 16'h0000;
  wire \$signal$6 ;
  wire [15:0] beats_after;
  input [15:0] beats_per_pixel;
  wire [15:0] beats_per_pixel;
  reg [111:0] buffer = 112'h0000000000000000000000000000;
  input clk;
  wire clk;
  reg [15:0] final_word = 16'h0000;
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
  input [13:0] \port$1409$79 ;
  wire [13:0] \port$1409$79 ;
  wire put;
  input rst;
  wire rst;
  input soft_reset;
  wire soft_reset;
  reg [15:0] words_out = 16'h0000;
  wire [15:0] words_per_pixel;
  assign \$1  = \port$1409$79  - 1'h1;
  assign \$3  = \$signal$6  ? \$2  : buffer;
  assign \$4  = \$signal  ? 112'h0000000000000000000000000000 : \$3 ;
  assign \$5  = put ? i__payload : 64'h0000000000000000;
  assign \$6  = \$5  << \$20 [6:0];
  assign \$7  = { 79'h00000000000000000000, \$4  } | \$6 ;
  assign \$8  = put ? 7'h40 : 7'h00;
  assign \$9  = \$20 [6:0] + \$8 ;
  assign \$10  = beats_after + put;
  assign \$11  = words_out + 1'h1;
  assign \$12  = \$signal  ? 17'h00000 : \$11 ;
  assign \$13  = level >= 6'h30;
  assign \$14  = \$signal$11  == beats_per_pixel;
  assign o__valid = \$13  | \$14 ;
  assign \$signal$6  = o__valid & o__ready;
  assign \$15  = words_out == final_word;
  assign \$signal  = \$signal$6  & \$15 ;
  assign beats_after = \$signal  ? 16'h0000 : \$signal$11 ;
  assign \$16  = level >= 6'h30;
  assign \$17  = level - 6'h30;
  assign \$18  = \$16  ? \$17  : 8'h00;
  assign \$19  = \$signal$6  ? \$18  : { 1'h0, level };
  assign \$20  = \$signal  ? 8'h00 : \$19 ;
  assign \$21  = beats_after != beats_per_pixel;
  assign \$22  = \$20 [6:0] <= 6'h30;
  assign i__ready = \$21  & \$22 ;
  assign put = i__valid & i__ready;
  always @(posedge clk)
    final_word <= \$23 ;
  always @(posedge clk)
    buffer <= \$24 ;
  always @(posedge clk)
    level <= \$25 ;
  always @(posedge clk)
    \$signal$11  <= \$26 ;
  always @(posedge clk)
    words_out <= \$27 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$7 ) begin end
    \$23  = \$1 [15:0];
    if (soft_reset) begin
      \$23  = 16'h0000;
    end
    if (rst) begin
      \$23  = 16'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$7 ) begin end
    \$24  = \$7 [111:0];
    if (soft_reset) begin
      \$24  = 112'h0000000000000000000000000000;
    end
    if (rst) begin
      \$24  = 112'h0000000000000000000000000000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$7 ) begin end
    \$25  = \$9 [6:0];
    if (soft_reset) begin
      \$25  = 7'h00;
    end
    if (rst) begin
      \$25  = 7'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$7 ) begin end
    \$26  = \$10 [15:0];
    if (soft_reset) begin
      \$26  = 16'h0000;
    end
    if (rst) begin
      \$26  = 16'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$7 ) begin end
    \$27  = words_out;
    if (\$signal$6 ) begin
      \$27  = \$12 [15:0];
    end
    if (soft_reset) begin
      \$27  = 16'h0000;
    end
    if (rst) begin
      \$27  = 16'h0000;
    end
  end
  assign words_per_pixel = { 2'h0, \port$1409$79  };
  assign \$like  = \$20 [6:0];
  assign o__payload = buffer[47:0];
  assign \$2  = { 48'h000000000000, buffer[111:48] };
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
  wire \$39 ;
  wire [14:0] \$4 ;
  wire \$40 ;
  wire [23:0] \$41 ;
  wire [23:0] \$42 ;
  wire [23:0] \$43 ;
  wire \$44 ;
  wire \$45 ;
  wire [23:0] \$46 ;
  wire [23:0] \$47 ;
  wire [23:0] \$48 ;
  wire [23:0] \$49 ;
  wire \$5 ;
  wire [23:0] \$50 ;
  wire [23:0] \$51 ;
  reg \$52 ;
  reg [13:0] \$53 ;
  reg [15:0] \$54 ;
  reg [8:0] \$55 ;
  reg [15:0] \$56 ;
  reg \$57 ;
  reg [10:0] \$58 ;
  reg \$59 ;
  wire [16:0] \$6 ;
  reg [3:0] \$60 ;
  reg \$61 ;
  reg \$62 ;
  reg [95:0] \$63 ;
  wire \$7 ;
  wire \$8 ;
  wire \$9 ;
  reg \$like  = 1'h0;
  wire [1:0] \$signal ;
  reg [13:0] \$signal$10  = 14'h0000;
  wire \$signal$11 ;
  wire \$signal$12 ;
  reg [15:0] \$signal$2  = 16'h0000;
  reg \$signal$36  = 1'h0;
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
  reg inner = 1'h0;
  reg [3:0] mask = 4'h0;
  wire [13:0] odd_words;
  reg [95:0] picked;
  input [16:0] read;
  wire [16:0] read;
  wire [7:0] \read.address ;
  wire \read.apart ;
  wire \read.bank ;
  wire \read.inner ;
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
  input [200:0] shape;
  wire [200:0] shape;
  wire [15:0] \shape.beats_in ;
  wire [15:0] \shape.beats_out ;
  wire [15:0] \shape.beats_residual ;
  wire \shape.biased ;
  wire [13:0] \shape.blocks ;
  wire [14:0] \shape.column_words ;
  wire [14:0] \shape.groups ;
  wire \shape.halved ;
  wire [15:0] \shape.height ;
  wire [13:0] \shape.ingest_words ;
  wire [15:0] \shape.out_height ;
  wire [15:0] \shape.out_width ;
  wire [11:0] \shape.output_words ;
  wire \shape.packed ;
  wire \shape.pointwise ;
  wire \shape.residual ;
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
  assign \$28  = free - \$signal$12 ;
  assign \$29  = $signed(\$28 ) + $signed({ 1'h0, retire });
  assign \$30  = retire_row ? shape[62:48] : 15'h0000;
  assign \$31  = $signed(\$29 ) + $signed({ 1'h0, \$30  });
  assign \$32  = shape[164] ? 3'h4 : 3'h3;
  assign \$33  = \$32  * shape[62:48];
  assign \$34  = inner ? picked[47:24] : picked[23:0];
  assign \$35  = mask[0] ? \$34  : 24'h000000;
  assign \$36  = shape[167] ? 24'h924924 : 24'h000000;
  assign \$37  = \$35  ^ \$36 ;
  assign \$38  = mask[1] ? picked[47:24] : 24'h000000;
  assign \$39  = ~ \$signal$36 ;
  assign \$40  = shape[167] & \$39 ;
  assign \$41  = \$40  ? 24'h924924 : 24'h000000;
  assign \$42  = \$38  ^ \$41 ;
  assign \$43  = mask[2] ? picked[71:48] : 24'h000000;
  assign \$44  = ~ \$signal$36 ;
  assign \$45  = shape[167] & \$44 ;
  assign \$46  = \$45  ? 24'h924924 : 24'h000000;
  assign \$47  = \$43  ^ \$46 ;
  assign \$48  = inner ? picked[71:48] : picked[95:72];
  assign \$49  = mask[3] ? \$48  : 24'h000000;
  assign \$50  = shape[167] ? 24'h924924 : 24'h000000;
  assign \$51  = \$49  ^ \$50 ;
  always @(posedge clk)
    group_written <= \$52 ;
  always @(posedge clk)
    \$signal$10  <= \$53 ;
  always @(posedge clk)
    \$signal$2  <= \$54 ;
  always @(posedge clk)
    group_base <= \$55 ;
  always @(posedge clk)
    row <= \$56 ;
  always @(posedge clk)
    image_written <= \$57 ;
  always @(posedge clk)
    free <= \$58 ;
  always @(posedge clk)
    \$like  <= \$59 ;
  always @(posedge clk)
    mask <= \$60 ;
  always @(posedge clk)
    \$signal$36  <= \$61 ;
  always @(posedge clk)
    inner <= \$62 ;
  always @(posedge clk)
    word <= \$63 ;
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
    \$52  = \$signal$12 ;
    if (start) begin
      \$52  = 1'h0;
    end
    if (soft_reset) begin
      \$52  = 1'h0;
    end
    if (rst) begin
      \$52  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$53  = \$signal$10 ;
    if (\$signal$7 ) begin
      \$53  = \$20 [13:0];
    end
    if (start) begin
      \$53  = 14'h0000;
    end
    if (soft_reset) begin
      \$53  = 14'h0000;
    end
    if (rst) begin
      \$53  = 14'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$54  = \$signal$2 ;
    if (\$signal$9 ) begin
      \$54  = \$22 [15:0];
    end
    if (start) begin
      \$54  = 16'h0000;
    end
    if (soft_reset) begin
      \$54  = 16'h0000;
    end
    if (rst) begin
      \$54  = 16'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$55  = group_base;
    if (\$signal$12 ) begin
      \$55  = \$24 [8:0];
    end
    if (start) begin
      \$55  = 9'h000;
    end
    if (soft_reset) begin
      \$55  = 9'h000;
    end
    if (rst) begin
      \$55  = 9'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$56  = row;
    if (\$signal$11 ) begin
      \$56  = \$25 [15:0];
    end
    if (start) begin
      \$56  = 16'h0000;
    end
    if (soft_reset) begin
      \$56  = 16'h0000;
    end
    if (rst) begin
      \$56  = 16'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$57  = image_written;
    if (\$signal$11 ) begin
      if (\$27 ) begin
        \$57  = 1'h1;
      end
    end
    if (start) begin
      \$57  = 1'h0;
    end
    if (soft_reset) begin
      \$57  = 1'h1;
    end
    if (rst) begin
      \$57  = 1'h1;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$58  = \$31 [10:0];
    if (start) begin
      \$58  = \$33 [10:0];
    end
    if (soft_reset) begin
      \$58  = 11'h000;
    end
    if (rst) begin
      \$58  = 11'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$59  = read[10];
    if (soft_reset) begin
      \$59  = 1'h0;
    end
    if (rst) begin
      \$59  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$60  = read[14:11];
    if (soft_reset) begin
      \$60  = 4'h0;
    end
    if (rst) begin
      \$60  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$61  = read[15];
    if (soft_reset) begin
      \$61  = 1'h0;
    end
    if (rst) begin
      \$61  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$62  = read[16];
    if (soft_reset) begin
      \$62  = 1'h0;
    end
    if (rst) begin
      \$62  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$63 [23:0] = \$37 ;
    \$63 [47:24] = \$42 ;
    \$63 [71:48] = \$47 ;
    \$63 [95:72] = \$51 ;
    if (soft_reset) begin
      \$63  = 96'h000000000000000000000000;
    end
    if (rst) begin
      \$63  = 96'h000000000000000000000000;
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
  assign \shape.packed  = shape[166];
  assign \shape.biased  = shape[167];
  assign \shape.residual  = shape[168];
  assign \shape.out_width  = shape[184:169];
  assign \shape.beats_residual  = shape[200:185];
  assign \read.slot  = read[1:0];
  assign \read.address  = read[9:2];
  assign \read.bank  = read[10];
  assign \read.mask  = read[14:11];
  assign \read.apart  = read[15];
  assign \read.inner  = read[16];
endmodule

module \macram_top.array.loader (i__valid, rst, fault, error, i__payload, soft_reset, words, base, start_weights, start_requant, \port$1691$0 , \port$1693$0 , \port$1695$0 , i__ready, to_requant, unit_en, requant_en, clk);
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
  output [9:0] \port$1691$0 ;
  wire [9:0] \port$1691$0 ;
  (* init = 8'h00 *)
  output [7:0] \port$1693$0 ;
  wire [7:0] \port$1693$0 ;
  output [671:0] \port$1695$0 ;
  wire [671:0] \port$1695$0 ;
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
  assign \port$1691$0  = \$27 ;
  assign \port$1693$0  = \$29 ;
  assign \port$1695$0  = shifter[671:0];
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

module \macram_top.array.sequencer (rst, starved, blocked, issue, credit, soft_reset, weight_base, start, shape, group_written, image_written, retire, retire_row, flushing, \step$51 , clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$10  = 0;
  wire [12:0] \$1 ;
  wire \$10 ;
  wire \$100 ;
  wire \$101 ;
  wire [11:0] \$102 ;
  wire [14:0] \$103 ;
  wire [1:0] \$104 ;
  wire [12:0] \$105 ;
  wire [15:0] \$106 ;
  wire [15:0] \$107 ;
  wire \$108 ;
  wire [16:0] \$109 ;
  wire \$11 ;
  wire \$110 ;
  wire \$111 ;
  wire \$112 ;
  wire \$113 ;
  wire \$114 ;
  wire \$115 ;
  wire \$116 ;
  wire \$117 ;
  wire [15:0] \$118 ;
  wire [15:0] \$119 ;
  wire \$12 ;
  wire \$120 ;
  wire [13:0] \$121 ;
  wire [14:0] \$122 ;
  wire [13:0] \$123 ;
  wire [15:0] \$124 ;
  wire [3:0] \$125 ;
  wire \$126 ;
  wire \$127 ;
  wire [3:0] \$128 ;
  wire [3:0] \$129 ;
  wire \$13 ;
  wire [3:0] \$130 ;
  wire [3:0] \$131 ;
  wire \$132 ;
  wire \$133 ;
  wire \$134 ;
  wire [11:0] \$135 ;
  wire [13:0] \$136 ;
  reg \$137 ;
  reg \$138 ;
  reg [17:0] \$139 ;
  wire \$14 ;
  reg \$140 ;
  reg [13:0] \$141 ;
  reg [10:0] \$142 ;
  reg \$143 ;
  reg [1:0] \$144 ;
  reg \$145 ;
  reg \$146 ;
  reg [11:0] \$147 ;
  reg [14:0] \$148 ;
  reg [8:0] \$149 ;
  wire \$15 ;
  reg [15:0] \$150 ;
  reg \$151 ;
  reg \$152 ;
  reg [13:0] \$153 ;
  reg \$154 ;
  reg [50:0] \$155 ;
  wire \$16 ;
  wire \$17 ;
  wire \$18 ;
  wire [12:0] \$19 ;
  wire \$2 ;
  wire \$20 ;
  wire \$21 ;
  wire [12:0] \$22 ;
  wire \$23 ;
  wire [15:0] \$24 ;
  wire [16:0] \$25 ;
  wire \$26 ;
  wire \$27 ;
  wire \$28 ;
  wire \$29 ;
  wire [14:0] \$3 ;
  wire \$30 ;
  wire \$31 ;
  wire \$32 ;
  wire \$33 ;
  wire \$34 ;
  wire \$35 ;
  wire \$36 ;
  wire \$37 ;
  wire \$38 ;
  wire \$39 ;
  wire \$4 ;
  wire \$40 ;
  wire \$41 ;
  wire \$42 ;
  wire [17:0] \$43 ;
  wire [18:0] \$44 ;
  wire [17:0] \$45 ;
  wire [18:0] \$46 ;
  wire [18:0] \$47 ;
  wire \$48 ;
  wire \$49 ;
  wire \$5 ;
  wire \$50 ;
  wire [16:0] \$51 ;
  wire [2:0] \$52 ;
  wire [2:0] \$53 ;
  wire [18:0] \$54 ;
  wire \$55 ;
  wire \$56 ;
  wire \$57 ;
  wire \$58 ;
  wire \$59 ;
  wire \$6 ;
  wire \$60 ;
  wire [3:0] \$61 ;
  wire [4:0] \$62 ;
  wire [4:0] \$63 ;
  wire \$64 ;
  wire \$65 ;
  wire \$66 ;
  wire \$67 ;
  wire \$68 ;
  wire \$69 ;
  wire \$7 ;
  wire \$70 ;
  wire \$71 ;
  wire \$72 ;
  wire \$73 ;
  wire \$74 ;
  wire \$75 ;
  wire \$76 ;
  wire \$77 ;
  wire \$78 ;
  wire \$79 ;
  wire \$8 ;
  wire \$80 ;
  wire \$81 ;
  wire \$82 ;
  wire \$83 ;
  wire \$84 ;
  wire \$85 ;
  wire [18:0] \$86 ;
  wire \$87 ;
  wire \$88 ;
  wire \$89 ;
  wire \$9 ;
  wire [19:0] \$90 ;
  wire [14:0] \$91 ;
  wire [20:0] \$92 ;
  wire \$93 ;
  wire \$94 ;
  wire [14:0] \$95 ;
  wire [11:0] \$96 ;
  wire \$97 ;
  wire \$98 ;
  wire [2:0] \$99 ;
  wire \$signal ;
  reg [1:0] \$signal$10  = 2'h0;
  wire \$signal$12 ;
  reg \$signal$13  = 1'h0;
  wire \$signal$14 ;
  wire \$signal$15 ;
  reg [14:0] \$signal$16  = 15'h0000;
  wire \$signal$17 ;
  reg [15:0] \$signal$18  = 16'h0000;
  reg \$signal$25  = 1'h0;
  wire \$signal$6 ;
  reg \$signal$8  = 1'h0;
  wire \$signal$9 ;
  reg [17:0] ahead = 18'h00000;
  reg [13:0] block = 14'h0000;
  output blocked;
  wire blocked;
  reg busy = 1'h0;
  reg [13:0] carried_info = 14'h0000;
  wire \carried_info.edge ;
  wire \carried_info.image_last ;
  wire \carried_info.inner ;
  wire [3:0] \carried_info.slots ;
  wire [3:0] \carried_info.tile ;
  wire \carried_info.tile_last ;
  wire \carried_info.triple ;
  wire \carried_info.unloaded ;
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
  wire [13:0] info;
  wire \info.edge ;
  wire \info.image_last ;
  wire \info.inner ;
  wire [3:0] \info.slots ;
  wire [3:0] \info.tile ;
  wire \info.tile_last ;
  wire \info.triple ;
  wire \info.unloaded ;
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
  input [200:0] shape;
  wire [200:0] shape;
  wire [15:0] \shape.beats_in ;
  wire [15:0] \shape.beats_out ;
  wire [15:0] \shape.beats_residual ;
  wire \shape.biased ;
  wire [13:0] \shape.blocks ;
  wire [14:0] \shape.column_words ;
  wire [14:0] \shape.groups ;
  wire \shape.halved ;
  wire [15:0] \shape.height ;
  wire [13:0] \shape.ingest_words ;
  wire [15:0] \shape.out_height ;
  wire [15:0] \shape.out_width ;
  wire [11:0] \shape.output_words ;
  wire \shape.packed ;
  wire \shape.pointwise ;
  wire \shape.residual ;
  wire [1:0] \shape.tail ;
  wire [11:0] \shape.tiles ;
  wire [15:0] \shape.width ;
  wire skipped;
  reg [3:0] slots;
  input soft_reset;
  wire soft_reset;
  wire [17:0] source_row;
  wire [16:0] source_row_below;
  input start;
  wire start;
  output starved;
  wire starved;
  wire step;
  output [50:0] \step$51 ;
  reg [50:0] \step$51  = 51'h0000000000000;
  wire [9:0] \step$51.control ;
  wire \step$51.control.carried ;
  wire \step$51.control.edge ;
  wire \step$51.control.en ;
  wire \step$51.control.first ;
  wire \step$51.control.last ;
  wire [3:0] \step$51.control.tile ;
  wire \step$51.control.unload ;
  wire [13:0] \step$51.info ;
  wire \step$51.info.edge ;
  wire \step$51.info.image_last ;
  wire \step$51.info.inner ;
  wire [3:0] \step$51.info.slots ;
  wire [3:0] \step$51.info.tile ;
  wire \step$51.info.tile_last ;
  wire \step$51.info.triple ;
  wire \step$51.info.unloaded ;
  wire [16:0] \step$51.read ;
  wire [7:0] \step$51.read.address ;
  wire \step$51.read.apart ;
  wire \step$51.read.bank ;
  wire \step$51.read.inner ;
  wire [3:0] \step$51.read.mask ;
  wire [1:0] \step$51.read.slot ;
  wire [9:0] \step$51.weight ;
  wire step_last;
  reg [11:0] tile = 12'h000;
  wire triple;
  wire unload;
  reg valid = 1'h0;
  reg [10:0] weight = 11'h000;
  input [9:0] weight_base;
  wire [9:0] weight_base;
  assign \$1  = tile + 2'h2;
  assign \$2  = \$1  < shape[119:108];
  assign triple = shape[166] & \$2 ;
  assign \$3  = block + 1'h1;
  assign \$4  = \$3  == shape[78:65];
  assign \$signal  = flushing | \$4 ;
  assign \$5  = ~ shape[164];
  assign \$signal$6  = shape[165] & \$5 ;
  assign \$6  = ~ \$signal$6 ;
  assign \$7  = \$signal$8  | \$6 ;
  assign kernel_row_last = \$signal  & \$7 ;
  assign \$8  = ! \$signal$10 ;
  assign \$9  = ~ \$signal$8 ;
  assign \$10  = \$8  & \$9 ;
  assign \$11  = ! block;
  assign \$12  = \$10  & \$11 ;
  assign \$signal$9  = flushing | \$12 ;
  assign \$13  = \$signal$10  == 2'h2;
  assign \$14  = shape[164] | \$13 ;
  assign \$15  = kernel_row_last & \$14 ;
  assign last = flushing | \$15 ;
  assign \$16  = ! tile;
  assign \$17  = \$signal$9  & \$16 ;
  assign \$18  = ~ \$signal$13 ;
  assign \$signal$12  = \$17  & \$18 ;
  assign \$19  = tile + 2'h3;
  assign \$20  = \$19  == shape[119:108];
  assign \$21  = \$signal$13  & \$20 ;
  assign \$22  = tile + 1'h1;
  assign \$23  = \$22  == shape[119:108];
  assign \$signal$14  = triple ? \$21  : \$23 ;
  assign \$24  = \$signal$16  + 1'h1;
  assign \$signal$15  = \$24  == shape[62:48];
  assign \$25  = \$signal$18  + 1'h1;
  assign \$signal$17  = \$25  == shape[47:32];
  assign \$26  = ~ \$signal$12 ;
  assign \$27  = \$26  | image_written;
  assign \$28  = $signed(ahead) > $signed(1'h0);
  assign \$29  = \$27  | \$28 ;
  assign pixels_ready = \$29  | flushing;
  assign \$30  = ~ pixels_ready;
  assign starved = busy & \$30 ;
  assign unload = \$signal$25  & credits;
  assign \$31  = busy & pixels_ready;
  assign \$32  = ~ credits;
  assign \$33  = last & \$32 ;
  assign \$34  = \$33  | unload;
  assign blocked = \$31  & \$34 ;
  assign \$35  = busy & pixels_ready;
  assign \$36  = ~ credits;
  assign \$37  = last & \$36 ;
  assign \$38  = ~ \$37 ;
  assign \$39  = \$35  & \$38 ;
  assign \$40  = ~ unload;
  assign step = \$39  & \$40 ;
  assign \$41  = ~ flushing;
  assign issue = step & \$41 ;
  assign \$42  = issue & last;
  assign step_last = \$42  & \$signal$14 ;
  assign \$43  = 2'h2 * \$signal$18 ;
  assign \$44  = \$43  + 2'h2;
  assign \$45  = 2'h2 * \$signal$18 ;
  assign \$46  = \$45  + 2'h3;
  assign \$47  = shape[164] ? \$44  : \$46 ;
  assign \$48  = step_last & \$signal$15 ;
  assign \$49  = \$48  & shape[165];
  assign \$50  = \$47 [16:0] < shape[15:0];
  assign skipped = \$49  & \$50 ;
  assign \$51  = \$signal$18  << shape[165];
  assign \$52  = \$signal$10  - 1'h1;
  assign \$53  = shape[164] ? 3'h0 : \$52 ;
  assign \$54  = $signed({ 1'h0, \$51  }) + $signed(\$53 );
  assign \$55  = $signed(\$54 [17:0]) >= $signed(1'h0);
  assign \$56  = $signed(\$54 [17:0]) < $signed({ 1'h0, shape[15:0] });
  assign \$57  = \$55  & \$56 ;
  assign \$58  = ~ flushing;
  assign row_exists = \$57  & \$58 ;
  assign \$59  = | shape[64:63];
  assign \$60  = \$signal$15  & \$59 ;
  assign \$61  = 1'h1 << shape[64:63];
  assign \$62  = \$61  - 1'h1;
  assign \$63  = \$60  ? \$62  : 5'h0f;
  assign \$64  = ! \$signal$16 ;
  assign \$65  = ~ shape[166];
  assign \edge  = \$64  & \$65 ;
  assign \$66  = ! shape[64:63];
  assign \$67  = | \$signal$18 ;
  assign \$68  = \$66  & \$67 ;
  assign \$69  = \edge  ? \$68  : 1'h1;
  assign \$70  = ~ flushing;
  assign \$71  = ~ flushing;
  assign \$72  = \$71  & \$63 [1];
  assign \$73  = ~ flushing;
  assign \$74  = \$73  & \$63 [2];
  assign \$75  = \$signal$17  & \$signal$15 ;
  assign \$76  = | shape[64:63];
  assign \$77  = \$76  | shape[166];
  assign \$78  = \$75  & \$77 ;
  assign \$79  = flushing | \$78 ;
  assign \$80  = issue & \$signal$14 ;
  assign \$81  = ! \$signal$10 ;
  assign \$82  = \$80  & \$81 ;
  assign \$83  = \$82  & kernel_row_last;
  assign \$84  = step_last & \$signal$15 ;
  assign \$85  = \$84  & shape[165];
  assign \$86  = $signed(ahead) + $signed({ 1'h0, group_written });
  assign \$87  = step & \$signal$12 ;
  assign \$88  = ~ flushing;
  assign \$89  = \$87  & \$88 ;
  assign \$90  = $signed(\$86 ) - $signed({ 1'h0, \$89  });
  assign \$91  = skipped ? shape[62:48] : 15'h0000;
  assign \$92  = $signed(\$90 ) - $signed({ 1'h0, \$91  });
  assign \$93  = step & last;
  assign \$94  = \$93  | unload;
  assign \$95  = block + 1'h1;
  assign \$96  = weight + 1'h1;
  assign \$97  = ~ \$signal$8 ;
  assign \$98  = \$signal$6  & \$97 ;
  assign \$99  = \$signal$10  + 1'h1;
  assign \$100  = ~ \$signal$13 ;
  assign \$101  = triple & \$100 ;
  assign \$102  = weight + 1'h1;
  assign \$103  = \$102  - shape[78:65];
  assign \$104  = triple ? 2'h3 : 2'h1;
  assign \$105  = tile + \$104 ;
  assign \$106  = \$signal$16  + 1'h1;
  assign \$107  = group_base + shape[107:93];
  assign \$108  = \$signal$15  | flushing;
  assign \$109  = \$signal$18  + 1'h1;
  assign \$110  = \$signal$17  | flushing;
  assign \$111  = ! shape[64:63];
  assign \$112  = ~ shape[166];
  assign \$113  = \$111  & \$112 ;
  assign \$114  = ~ flushing;
  assign \$115  = \$113  & \$114 ;
  assign \$116  = shape[15:0] == 1'h1;
  assign \$117  = \$116  | shape[164];
  assign \$118  = - shape[62:48];
  assign \$119  = \$117  ? 16'h0000 : \$118 ;
  assign \$120  = step & last;
  assign \$121  = \$signal$8  ? shape[92:79] : 14'h0000;
  assign \$122  = group_base + \$121 ;
  assign \$124  = \$122  + \$123 ;
  assign \$125  = \$signal$13  ? { \$63 [2], 2'h0, \$63 [1] } : { \$63 [3], 2'h0, \$63 [0] };
  assign \$126  = \$signal$8  & \$signal$15 ;
  assign \$127  = \$126  & shape[16];
  assign \$129  = \$127  ? \$128  : \$63 [3:0];
  assign \$130  = triple ? \$125  : \$129 ;
  assign \$131  = row_exists ? \$130  : 4'h0;
  assign \$132  = ~ shape[166];
  assign \$133  = \$signal$9  & \$132 ;
  assign \$134  = unload | \$133 ;
  assign \$135  = unload ? { 8'h00, carried_info[3:0] } : tile;
  assign \$136  = unload ? carried_info : info;
  always @(posedge clk)
    retire <= \$137 ;
  always @(posedge clk)
    retire_row <= \$138 ;
  always @(posedge clk)
    ahead <= \$139 ;
  always @(posedge clk)
    credits <= \$140 ;
  always @(posedge clk)
    block <= \$141 ;
  always @(posedge clk)
    weight <= \$142 ;
  always @(posedge clk)
    \$signal$8  <= \$143 ;
  always @(posedge clk)
    \$signal$10  <= \$144 ;
  always @(posedge clk)
    \$signal$25  <= \$145 ;
  always @(posedge clk)
    \$signal$13  <= \$146 ;
  always @(posedge clk)
    tile <= \$147 ;
  always @(posedge clk)
    \$signal$16  <= \$148 ;
  always @(posedge clk)
    group_base <= \$149 ;
  always @(posedge clk)
    \$signal$18  <= \$150 ;
  always @(posedge clk)
    flushing <= \$151 ;
  always @(posedge clk)
    busy <= \$152 ;
  always @(posedge clk)
    carried_info <= \$153 ;
  always @(posedge clk)
    valid <= \$154 ;
  always @(posedge clk)
    \step$51  <= \$155 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    (* full_case = 32'd1 *)
    if (shape[166]) begin
      slots = \$63 [3:0];
    end else begin
      slots[0] = \$69 ;
      slots[1] = \$70 ;
      slots[2] = \$72 ;
      slots[3] = \$74 ;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$137  = \$83 ;
    if (start) begin
      \$137  = 1'h0;
    end
    if (soft_reset) begin
      \$137  = 1'h0;
    end
    if (rst) begin
      \$137  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$138  = \$85 ;
    if (start) begin
      \$138  = 1'h0;
    end
    if (soft_reset) begin
      \$138  = 1'h0;
    end
    if (rst) begin
      \$138  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$139  = \$92 [17:0];
    if (start) begin
      \$139  = { \$119 [15], \$119 [15], \$119  };
    end
    if (soft_reset) begin
      \$139  = 18'h00000;
    end
    if (rst) begin
      \$139  = 18'h00000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$140  = credits;
    if (credit) begin
      \$140  = 1'h1;
    end else if (\$94 ) begin
      \$140  = 1'h0;
    end
    if (start) begin
      \$140  = 1'h1;
    end
    if (soft_reset) begin
      \$140  = 1'h0;
    end
    if (rst) begin
      \$140  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$141  = block;
    if (step) begin
      \$141  = \$95 [13:0];
      if (\$signal ) begin
        \$141  = 14'h0000;
      end
    end
    if (start) begin
      \$141  = 14'h0000;
    end
    if (soft_reset) begin
      \$141  = 14'h0000;
    end
    if (rst) begin
      \$141  = 14'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$142  = weight;
    if (step) begin
      \$142  = \$96 [10:0];
      if (last) begin
        if (\$101 ) begin
          \$142  = \$103 [10:0];
        end
        if (\$signal$14 ) begin
          \$142  = { 1'h0, weight_base };
        end
      end
    end
    if (start) begin
      \$142  = { 1'h0, weight_base };
    end
    if (soft_reset) begin
      \$142  = 11'h000;
    end
    if (rst) begin
      \$142  = 11'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$143  = \$signal$8 ;
    if (step) begin
      if (\$signal ) begin
        \$143  = \$98 ;
      end
      if (last) begin
        \$143  = 1'h0;
      end
    end
    if (start) begin
      \$143  = 1'h0;
    end
    if (soft_reset) begin
      \$143  = 1'h0;
    end
    if (rst) begin
      \$143  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$144  = \$signal$10 ;
    if (step) begin
      if (kernel_row_last) begin
        \$144  = \$99 [1:0];
      end
      if (last) begin
        \$144  = 2'h0;
      end
    end
    if (start) begin
      \$144  = 2'h0;
    end
    if (soft_reset) begin
      \$144  = 2'h0;
    end
    if (rst) begin
      \$144  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$145  = \$signal$25 ;
    if (step) begin
      if (last) begin
        \$145  = triple;
      end
    end
    if (unload) begin
      \$145  = 1'h0;
    end
    if (start) begin
      \$145  = 1'h0;
    end
    if (soft_reset) begin
      \$145  = 1'h0;
    end
    if (rst) begin
      \$145  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$146  = \$signal$13 ;
    if (step) begin
      if (last) begin
        (* full_case = 32'd1 *)
        if (\$101 ) begin
          \$146  = 1'h1;
        end else begin
          \$146  = 1'h0;
        end
      end
    end
    if (start) begin
      \$146  = 1'h0;
    end
    if (soft_reset) begin
      \$146  = 1'h0;
    end
    if (rst) begin
      \$146  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$147  = tile;
    if (step) begin
      if (last) begin
        (* full_case = 32'd1 *)
        if (\$101 ) begin
        end else begin
          \$147  = \$105 [11:0];
        end
        if (\$signal$14 ) begin
          \$147  = 12'h000;
        end
      end
    end
    if (start) begin
      \$147  = 12'h000;
    end
    if (soft_reset) begin
      \$147  = 12'h000;
    end
    if (rst) begin
      \$147  = 12'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$148  = \$signal$16 ;
    if (step) begin
      if (last) begin
        if (\$signal$14 ) begin
          \$148  = \$106 [14:0];
          if (\$108 ) begin
            \$148  = 15'h0000;
          end
        end
      end
    end
    if (start) begin
      \$148  = 15'h0000;
    end
    if (soft_reset) begin
      \$148  = 15'h0000;
    end
    if (rst) begin
      \$148  = 15'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$149  = group_base;
    if (step) begin
      if (last) begin
        if (\$signal$14 ) begin
          \$149  = \$107 [8:0];
          if (\$108 ) begin
            \$149  = 9'h000;
          end
        end
      end
    end
    if (start) begin
      \$149  = 9'h000;
    end
    if (soft_reset) begin
      \$149  = 9'h000;
    end
    if (rst) begin
      \$149  = 9'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$150  = \$signal$18 ;
    if (step) begin
      if (last) begin
        if (\$signal$14 ) begin
          if (\$108 ) begin
            \$150  = \$109 [15:0];
          end
        end
      end
    end
    if (start) begin
      \$150  = 16'h0000;
    end
    if (soft_reset) begin
      \$150  = 16'h0000;
    end
    if (rst) begin
      \$150  = 16'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$151  = flushing;
    if (step) begin
      if (last) begin
        if (\$signal$14 ) begin
          if (\$108 ) begin
            if (\$110 ) begin
              (* full_case = 32'd1 *)
              if (\$115 ) begin
                \$151  = 1'h1;
              end else begin
                \$151  = 1'h0;
              end
            end
          end
        end
      end
    end
    if (start) begin
      \$151  = 1'h0;
    end
    if (soft_reset) begin
      \$151  = 1'h0;
    end
    if (rst) begin
      \$151  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$152  = busy;
    if (step) begin
      if (last) begin
        if (\$signal$14 ) begin
          if (\$108 ) begin
            if (\$110 ) begin
              (* full_case = 32'd1 *)
              if (\$115 ) begin
              end else begin
                \$152  = 1'h0;
              end
            end
          end
        end
      end
    end
    if (start) begin
      \$152  = 1'h1;
    end
    if (soft_reset) begin
      \$152  = 1'h0;
    end
    if (rst) begin
      \$152  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$153  = carried_info;
    if (\$120 ) begin
      \$153 [12:0] = info[12:0];
      \$153 [13] = 1'h1;
    end
    if (soft_reset) begin
      \$153  = 14'h0000;
    end
    if (rst) begin
      \$153  = 14'h0000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$154  = step;
    if (soft_reset) begin
      \$154  = 1'h0;
    end
    if (rst) begin
      \$154  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$10 ) begin end
    \$155 [1:0] = \$54 [1:0];
    \$155 [9:2] = \$124 [7:0];
    \$155 [10] = block[0];
    \$155 [14:11] = \$131 ;
    \$155 [15] = triple;
    \$155 [16] = \$signal$13 ;
    \$155 [26:17] = weight[9:0];
    \$155 [27] = step;
    \$155 [28] = \$signal$9 ;
    \$155 [30] = last;
    \$155 [31] = \edge ;
    \$155 [29] = \$134 ;
    \$155 [35:32] = \$135 [3:0];
    \$155 [36] = unload;
    \$155 [50:37] = \$136 ;
    if (soft_reset) begin
      \$155  = 51'h0000000000000;
    end
    if (rst) begin
      \$155  = 51'h0000000000000;
    end
  end
  assign source_row_below = \$47 [16:0];
  assign source_row = \$54 [17:0];
  assign pixels = \$63 [3:0];
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
  assign \shape.packed  = shape[166];
  assign \shape.biased  = shape[167];
  assign \shape.residual  = shape[168];
  assign \shape.out_width  = shape[184:169];
  assign \shape.beats_residual  = shape[200:185];
  assign \info.tile  = info[3:0];
  assign \info.tile_last  = info[4];
  assign \info.slots  = info[8:5];
  assign \info.edge  = info[9];
  assign \info.image_last  = info[10];
  assign \info.triple  = info[11];
  assign \info.inner  = info[12];
  assign \info.unloaded  = info[13];
  assign \carried_info.tile  = carried_info[3:0];
  assign \carried_info.tile_last  = carried_info[4];
  assign \carried_info.slots  = carried_info[8:5];
  assign \carried_info.edge  = carried_info[9];
  assign \carried_info.image_last  = carried_info[10];
  assign \carried_info.triple  = carried_info[11];
  assign \carried_info.inner  = carried_info[12];
  assign \carried_info.unloaded  = carried_info[13];
  assign \step$51.read  = \step$51 [16:0];
  assign \step$51.read.slot  = \step$51 [1:0];
  assign \step$51.read.address  = \step$51 [9:2];
  assign \step$51.read.bank  = \step$51 [10];
  assign \step$51.read.mask  = \step$51 [14:11];
  assign \step$51.read.apart  = \step$51 [15];
  assign \step$51.read.inner  = \step$51 [16];
  assign \step$51.weight  = \step$51 [26:17];
  assign \step$51.control  = \step$51 [36:27];
  assign \step$51.control.en  = \step$51 [27];
  assign \step$51.control.first  = \step$51 [28];
  assign \step$51.control.carried  = \step$51 [29];
  assign \step$51.control.last  = \step$51 [30];
  assign \step$51.control.edge  = \step$51 [31];
  assign \step$51.control.tile  = \step$51 [35:32];
  assign \step$51.control.unload  = \step$51 [36];
  assign \step$51.info  = \step$51 [50:37];
  assign \step$51.info.tile  = \step$51 [40:37];
  assign \step$51.info.tile_last  = \step$51 [41];
  assign \step$51.info.slots  = \step$51 [45:42];
  assign \step$51.info.edge  = \step$51 [46];
  assign \step$51.info.image_last  = \step$51 [47];
  assign \step$51.info.triple  = \step$51 [48];
  assign \step$51.info.inner  = \step$51 [49];
  assign \step$51.info.unloaded  = \step$51 [50];
  assign info[12] = \$signal$13 ;
  assign info[11] = triple;
  assign info[10] = \$79 ;
  assign info[9] = \edge ;
  assign info[8:5] = slots;
  assign info[4] = \$signal$14 ;
  assign info[3:0] = tile[3:0];
  assign info[13] = 1'h0;
  assign \$123  = { 1'h0, block[13:1] };
  assign \$128  = { 1'h0, \$63 [3:1] };
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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

module \macram_top.array.unit060 (rst, core__shift, core__chain_i, chain_o, core__control, core__activations, address, write__addr, write__data, write__en, clk);
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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

module \macram_top.array.unit061 (rst, core__shift, core__chain_i, chain_o, core__control, core__activations, address, write__addr, write__data, write__en, clk);
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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

module \macram_top.array.unit062 (rst, core__shift, core__chain_i, chain_o, core__control, core__activations, address, write__addr, write__data, write__en, clk);
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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

module \macram_top.array.unit063 (rst, core__shift, core__chain_i, chain_o, core__control, core__activations, address, write__addr, write__data, write__en, clk);
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
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
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
  input [9:0] core__control;
  wire [9:0] core__control;
  wire \core__control.carried ;
  wire \core__control.edge ;
  wire \core__control.en ;
  wire \core__control.first ;
  wire \core__control.last ;
  wire [3:0] \core__control.tile ;
  wire \core__control.unload ;
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
  assign chain_i = core__chain_i;
  assign core__chain_o = chain_o;
  assign \write.addr  = write__addr;
  assign \write.data  = write__data;
  assign \core__control.en  = core__control[0];
  assign \core__control.first  = core__control[1];
  assign \core__control.carried  = core__control[2];
  assign \core__control.last  = core__control[3];
  assign \core__control.edge  = core__control[4];
  assign \core__control.tile  = core__control[8:5];
  assign \core__control.unload  = core__control[9];
  assign \control.en  = core__control[0];
  assign \control.first  = core__control[1];
  assign \control.carried  = core__control[2];
  assign \control.last  = core__control[3];
  assign \control.edge  = core__control[4];
  assign \control.tile  = core__control[8:5];
  assign \control.unload  = core__control[9];
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

module \macram_top.registers (axi__awaddr, axi__awvalid, axi__wdata, axi__wstrb, axi__wvalid, axi__bready, axi__araddr, axi__arvalid, axi__rready, rst, \port$2$0 , axi__awready, axi__wready, axi__arready, busy, command, axi__bvalid, axi__bresp, height, width, c_in
, c_out, mode, param_words, param_base, weight_base, requant_base, axi__rvalid, axi__rdata, axi__rresp, \port$1368$0 , \port$1374$0 , cycles, mac_cycles, fill_cycles, input_stalls, output_stalls, drain_cycles, loading, clk);
  reg \$auto$verilog_backend.cc:2355:dump_module$11  = 0;
  wire \$1 ;
  wire \$10 ;
  wire \$11 ;
  wire \$12 ;
  wire \$13 ;
  wire \$14 ;
  wire \$15 ;
  wire \$16 ;
  wire [3:0] \$17 ;
  wire \$18 ;
  reg [4:0] \$19 ;
  wire \$2 ;
  reg \$20 ;
  reg [31:0] \$21 ;
  reg [3:0] \$22 ;
  reg \$23 ;
  reg [3:0] \$24 ;
  reg \$25 ;
  reg [1:0] \$26 ;
  reg [31:0] \$27 ;
  reg [31:0] \$28 ;
  reg [31:0] \$29 ;
  wire \$3 ;
  reg [31:0] \$30 ;
  reg [31:0] \$31 ;
  reg [31:0] \$32 ;
  reg [31:0] \$33 ;
  reg [31:0] \$34 ;
  reg [31:0] \$35 ;
  reg [31:0] \$36 ;
  reg [31:0] \$37 ;
  reg [31:0] \$38 ;
  reg [31:0] \$39 ;
  wire \$4 ;
  reg [4:0] \$40 ;
  reg \$41 ;
  reg \$42 ;
  reg [31:0] \$43 ;
  reg [1:0] \$44 ;
  wire \$5 ;
  wire \$6 ;
  wire \$7 ;
  wire \$8 ;
  wire \$9 ;
  reg [4:0] \$signal  = 5'h00;
  reg [31:0] \$signal$12  = 32'd0;
  reg [3:0] \$signal$14  = 4'h0;
  reg [4:0] \$signal$36  = 5'h00;
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
  wire [31:0] partial_c_in;
  input \port$1368$0 ;
  wire \port$1368$0 ;
  input [2:0] \port$1374$0 ;
  wire [2:0] \port$1374$0 ;
  input \port$2$0 ;
  wire \port$2$0 ;
  output [31:0] requant_base;
  reg [31:0] requant_base = 32'd0;
  wire [31:0] residual;
  reg [31:0] residual_bounds0 = 32'd0;
  reg [31:0] residual_bounds1 = 32'd0;
  reg [31:0] residual_table0 = 32'd0;
  reg [31:0] residual_table1 = 32'd0;
  wire [31:0] row_words;
  input rst;
  wire rst;
  wire [31:0] status;
  output [31:0] weight_base;
  reg [31:0] weight_base = 32'd0;
  wire [31:0] weight_depth;
  output [31:0] width;
  reg [31:0] width = 32'd0;
  always @(posedge clk)
    residual_table0 <= \$36 ;
  always @(posedge clk)
    residual_table1 <= \$37 ;
  always @(posedge clk)
    residual_bounds0 <= \$38 ;
  always @(posedge clk)
    residual_bounds1 <= \$39 ;
  always @(posedge clk)
    \$signal$36  <= \$40 ;
  always @(posedge clk)
    held <= \$41 ;
  always @(posedge clk)
    axi__rvalid <= \$42 ;
  always @(posedge clk)
    axi__rdata <= \$43 ;
  always @(posedge clk)
    axi__rresp <= \$44 ;
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
  assign \$13  = ~ busy;
  assign \$14  = ~ busy;
  assign \$15  = ~ busy;
  assign \$16  = ~ busy;
  assign \$17  = \$signal$14 [0] ? \$signal$12 [3:0] : 4'h0;
  assign \$18  = axi__arvalid & axi__arready;
  always @(posedge clk)
    \$signal  <= \$19 ;
  always @(posedge clk)
    address_held <= \$20 ;
  always @(posedge clk)
    \$signal$12  <= \$21 ;
  always @(posedge clk)
    \$signal$14  <= \$22 ;
  always @(posedge clk)
    data_held <= \$23 ;
  always @(posedge clk)
    command <= \$24 ;
  always @(posedge clk)
    axi__bvalid <= \$25 ;
  always @(posedge clk)
    axi__bresp <= \$26 ;
  always @(posedge clk)
    height <= \$27 ;
  always @(posedge clk)
    width <= \$28 ;
  always @(posedge clk)
    c_in <= \$29 ;
  always @(posedge clk)
    c_out <= \$30 ;
  always @(posedge clk)
    mode <= \$31 ;
  always @(posedge clk)
    param_words <= \$32 ;
  always @(posedge clk)
    param_base <= \$33 ;
  always @(posedge clk)
    weight_base <= \$34 ;
  always @(posedge clk)
    requant_base <= \$35 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$36  = residual_table0;
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
        5'h1a:
            if (\$13 ) begin
              if (\$signal$14 [0]) begin
                \$36 [7:0] = \$signal$12 [7:0];
              end
              if (\$signal$14 [1]) begin
                \$36 [15:8] = \$signal$12 [15:8];
              end
              if (\$signal$14 [2]) begin
                \$36 [23:16] = \$signal$12 [23:16];
              end
              if (\$signal$14 [3]) begin
                \$36 [31:24] = \$signal$12 [31:24];
              end
            end
      endcase
    end
    if (rst) begin
      \$36  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$37  = residual_table1;
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
        5'h1a:
            /* empty */;
        5'h1b:
            if (\$14 ) begin
              if (\$signal$14 [0]) begin
                \$37 [7:0] = \$signal$12 [7:0];
              end
              if (\$signal$14 [1]) begin
                \$37 [15:8] = \$signal$12 [15:8];
              end
              if (\$signal$14 [2]) begin
                \$37 [23:16] = \$signal$12 [23:16];
              end
              if (\$signal$14 [3]) begin
                \$37 [31:24] = \$signal$12 [31:24];
              end
            end
      endcase
    end
    if (rst) begin
      \$37  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$38  = residual_bounds0;
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
        5'h1a:
            /* empty */;
        5'h1b:
            /* empty */;
        5'h1c:
            if (\$15 ) begin
              if (\$signal$14 [0]) begin
                \$38 [7:0] = \$signal$12 [7:0];
              end
              if (\$signal$14 [1]) begin
                \$38 [15:8] = \$signal$12 [15:8];
              end
              if (\$signal$14 [2]) begin
                \$38 [23:16] = \$signal$12 [23:16];
              end
              if (\$signal$14 [3]) begin
                \$38 [31:24] = \$signal$12 [31:24];
              end
            end
      endcase
    end
    if (rst) begin
      \$38  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$39  = residual_bounds1;
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
        5'h1a:
            /* empty */;
        5'h1b:
            /* empty */;
        5'h1c:
            /* empty */;
        5'h1d:
            if (\$16 ) begin
              if (\$signal$14 [0]) begin
                \$39 [7:0] = \$signal$12 [7:0];
              end
              if (\$signal$14 [1]) begin
                \$39 [15:8] = \$signal$12 [15:8];
              end
              if (\$signal$14 [2]) begin
                \$39 [23:16] = \$signal$12 [23:16];
              end
              if (\$signal$14 [3]) begin
                \$39 [31:24] = \$signal$12 [31:24];
              end
            end
      endcase
    end
    if (rst) begin
      \$39  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$40  = \$signal$36 ;
    if (\$18 ) begin
      \$40  = axi__araddr[6:2];
    end
    if (rst) begin
      \$40  = 5'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$41  = held;
    if (\$18 ) begin
      \$41  = 1'h1;
    end
    if (axi__rvalid) begin
      if (axi__rready) begin
        \$41  = 1'h0;
      end
    end
    if (rst) begin
      \$41  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$42  = axi__rvalid;
    if (axi__rvalid) begin
      if (axi__rready) begin
        \$42  = 1'h0;
      end
    end else if (held) begin
      \$42  = 1'h1;
    end
    if (rst) begin
      \$42  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$43  = axi__rdata;
    if (axi__rvalid) begin
    end else if (held) begin
      \$43  = 32'd0;
      casez (\$signal$36 )
        5'h00:
            \$43  = 32'd1296122706;
        5'h01:
            \$43  = 32'd131073;
        5'h02:
            \$43  = 32'd0;
        5'h03:
            \$43  = { 28'h0000000, loading, \port$2$0 , \port$1368$0 , busy };
        5'h04:
            \$43  = { 29'h00000000, \port$1374$0  };
        5'h05:
            \$43  = height;
        5'h06:
            \$43  = width;
        5'h07:
            \$43  = c_in;
        5'h08:
            \$43  = c_out;
        5'h09:
            \$43  = mode;
        5'h0a:
            \$43  = param_words;
        5'h0b:
            \$43  = cycles;
        5'h0c:
            \$43  = mac_cycles;
        5'h0d:
            \$43  = fill_cycles;
        5'h0e:
            \$43  = input_stalls;
        5'h0f:
            \$43  = output_stalls;
        5'h10:
            \$43  = drain_cycles;
        5'h11:
            \$43  = 32'd67633216;
        5'h12:
            \$43  = 32'd197379;
        5'h13:
            \$43  = 32'd1024;
        5'h14:
            \$43  = 32'd512;
        5'h15:
            \$43  = 32'd67109888;
        5'h16:
            \$43  = param_base;
        5'h17:
            \$43  = weight_base;
        5'h18:
            \$43  = requant_base;
        5'h19:
            \$43  = 32'd0;
        5'h1a:
            \$43  = residual_table0;
        5'h1b:
            \$43  = residual_table1;
        5'h1c:
            \$43  = residual_bounds0;
        5'h1d:
            \$43  = residual_bounds1;
        5'h1e:
            \$43  = 32'd0;
      endcase
    end
    if (rst) begin
      \$43  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$44  = axi__rresp;
    if (axi__rvalid) begin
    end else if (held) begin
      \$44  = 2'h0;
      (* full_case = 32'd1 *)
      casez (\$signal$36 )
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
        5'h19:
            /* empty */;
        5'h1a:
            /* empty */;
        5'h1b:
            /* empty */;
        5'h1c:
            /* empty */;
        5'h1d:
            /* empty */;
        5'h1e:
            /* empty */;
        default:
            \$44  = 2'h2;
      endcase
    end
    if (rst) begin
      \$44  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$19  = \$signal ;
    if (\$1 ) begin
      \$19  = axi__awaddr[6:2];
    end
    if (rst) begin
      \$19  = 5'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$20  = address_held;
    if (\$1 ) begin
      \$20  = 1'h1;
    end
    if (axi__bvalid) begin
      if (axi__bready) begin
        \$20  = 1'h0;
      end
    end
    if (rst) begin
      \$20  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$21  = \$signal$12 ;
    if (\$2 ) begin
      \$21  = axi__wdata;
    end
    if (rst) begin
      \$21  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$22  = \$signal$14 ;
    if (\$2 ) begin
      \$22  = axi__wstrb;
    end
    if (rst) begin
      \$22  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$23  = data_held;
    if (\$2 ) begin
      \$23  = 1'h1;
    end
    if (axi__bvalid) begin
      if (axi__bready) begin
        \$23  = 1'h0;
      end
    end
    if (rst) begin
      \$23  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$24  = 4'h0;
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
        5'h1a:
            /* empty */;
        5'h1b:
            /* empty */;
        5'h1c:
            /* empty */;
        5'h1d:
            /* empty */;
        5'h02:
            \$24  = \$17 ;
      endcase
    end
    if (rst) begin
      \$24  = 4'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$25  = axi__bvalid;
    if (axi__bvalid) begin
      if (axi__bready) begin
        \$25  = 1'h0;
      end
    end else if (\$3 ) begin
      \$25  = 1'h1;
    end
    if (rst) begin
      \$25  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$26  = axi__bresp;
    if (axi__bvalid) begin
    end else if (\$3 ) begin
      \$26  = 2'h2;
      casez (\$signal )
        5'h05:
            if (\$4 ) begin
              \$26  = 2'h0;
            end
        5'h06:
            if (\$5 ) begin
              \$26  = 2'h0;
            end
        5'h07:
            if (\$6 ) begin
              \$26  = 2'h0;
            end
        5'h08:
            if (\$7 ) begin
              \$26  = 2'h0;
            end
        5'h09:
            if (\$8 ) begin
              \$26  = 2'h0;
            end
        5'h0a:
            if (\$9 ) begin
              \$26  = 2'h0;
            end
        5'h16:
            if (\$10 ) begin
              \$26  = 2'h0;
            end
        5'h17:
            if (\$11 ) begin
              \$26  = 2'h0;
            end
        5'h18:
            if (\$12 ) begin
              \$26  = 2'h0;
            end
        5'h1a:
            if (\$13 ) begin
              \$26  = 2'h0;
            end
        5'h1b:
            if (\$14 ) begin
              \$26  = 2'h0;
            end
        5'h1c:
            if (\$15 ) begin
              \$26  = 2'h0;
            end
        5'h1d:
            if (\$16 ) begin
              \$26  = 2'h0;
            end
        5'h02:
            \$26  = 2'h0;
      endcase
    end
    if (rst) begin
      \$26  = 2'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$27  = height;
    if (axi__bvalid) begin
    end else if (\$3 ) begin
      casez (\$signal )
        5'h05:
            if (\$4 ) begin
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
    \$28  = width;
    if (axi__bvalid) begin
    end else if (\$3 ) begin
      casez (\$signal )
        5'h05:
            /* empty */;
        5'h06:
            if (\$5 ) begin
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
    \$29  = c_in;
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
    \$30  = c_out;
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
    \$31  = mode;
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
      \$31  = 32'd65795;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$32  = param_words;
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
                \$32 [7:0] = \$signal$12 [7:0];
              end
              if (\$signal$14 [1]) begin
                \$32 [15:8] = \$signal$12 [15:8];
              end
              if (\$signal$14 [2]) begin
                \$32 [23:16] = \$signal$12 [23:16];
              end
              if (\$signal$14 [3]) begin
                \$32 [31:24] = \$signal$12 [31:24];
              end
            end
      endcase
    end
    if (rst) begin
      \$32  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$33  = param_base;
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
                \$33 [7:0] = \$signal$12 [7:0];
              end
              if (\$signal$14 [1]) begin
                \$33 [15:8] = \$signal$12 [15:8];
              end
              if (\$signal$14 [2]) begin
                \$33 [23:16] = \$signal$12 [23:16];
              end
              if (\$signal$14 [3]) begin
                \$33 [31:24] = \$signal$12 [31:24];
              end
            end
      endcase
    end
    if (rst) begin
      \$33  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$34  = weight_base;
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
                \$34 [7:0] = \$signal$12 [7:0];
              end
              if (\$signal$14 [1]) begin
                \$34 [15:8] = \$signal$12 [15:8];
              end
              if (\$signal$14 [2]) begin
                \$34 [23:16] = \$signal$12 [23:16];
              end
              if (\$signal$14 [3]) begin
                \$34 [31:24] = \$signal$12 [31:24];
              end
            end
      endcase
    end
    if (rst) begin
      \$34  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$11 ) begin end
    \$35  = requant_base;
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
                \$35 [7:0] = \$signal$12 [7:0];
              end
              if (\$signal$14 [1]) begin
                \$35 [15:8] = \$signal$12 [15:8];
              end
              if (\$signal$14 [2]) begin
                \$35 [23:16] = \$signal$12 [23:16];
              end
              if (\$signal$14 [3]) begin
                \$35 [31:24] = \$signal$12 [31:24];
              end
            end
      endcase
    end
    if (rst) begin
      \$35  = 32'd0;
    end
  end
  assign status = { 28'h0000000, loading, \port$2$0 , \port$1368$0 , busy };
  assign error = { 29'h00000000, \port$1374$0  };
  assign geometry = 32'd67633216;
  assign formats = 32'd197379;
  assign weight_depth = 32'd1024;
  assign row_words = 32'd512;
  assign max_channels = 32'd67109888;
  assign residual = 32'd0;
  assign partial_c_in = 32'd0;
endmodule
