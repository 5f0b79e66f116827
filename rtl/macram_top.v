
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
    .\error$608 (error),
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
    .\port$1020$0 (command),
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
    .\port$1057$0 (error),
    .\port$1059$0 (done),
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

module \macram_top.array (i__valid, \i__valid$57 , \o__ready$49 , rst, busy, i__ready, \o__valid$51 , i__payload, \i__payload$53 , \port$1020$0 , height, width, c_in, c_out, mode, words, \error$608 , done, cycles, mac_cycles, fill_cycles
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
  wire \$signal$603 ;
  reg \$signal$604  = 1'h0;
  reg \$signal$621  = 1'h0;
  wire [95:0] activations;
  wire [95:0] \activations$105 ;
  wire [95:0] \activations$114 ;
  wire [95:0] \activations$123 ;
  wire [95:0] \activations$132 ;
  wire [95:0] \activations$140 ;
  wire [95:0] \activations$148 ;
  wire [95:0] \activations$156 ;
  wire [95:0] \activations$164 ;
  wire [95:0] \activations$172 ;
  wire [95:0] \activations$180 ;
  wire [95:0] \activations$188 ;
  wire [95:0] \activations$196 ;
  wire [95:0] \activations$204 ;
  wire [95:0] \activations$212 ;
  wire [95:0] \activations$220 ;
  wire [95:0] \activations$228 ;
  wire [95:0] \activations$236 ;
  wire [95:0] \activations$244 ;
  wire [95:0] \activations$252 ;
  wire [95:0] \activations$260 ;
  wire [95:0] \activations$268 ;
  wire [95:0] \activations$276 ;
  wire [95:0] \activations$284 ;
  wire [95:0] \activations$292 ;
  wire [95:0] \activations$300 ;
  wire [95:0] \activations$308 ;
  wire [95:0] \activations$316 ;
  wire [95:0] \activations$324 ;
  wire [95:0] \activations$332 ;
  wire [95:0] \activations$340 ;
  wire [95:0] \activations$348 ;
  wire [95:0] \activations$356 ;
  wire [95:0] \activations$364 ;
  wire [95:0] \activations$372 ;
  wire [95:0] \activations$380 ;
  wire [95:0] \activations$388 ;
  wire [95:0] \activations$396 ;
  wire [95:0] \activations$404 ;
  wire [95:0] \activations$412 ;
  wire [95:0] \activations$420 ;
  wire [95:0] \activations$428 ;
  wire [95:0] \activations$436 ;
  wire [95:0] \activations$444 ;
  wire [95:0] \activations$452 ;
  wire [95:0] \activations$460 ;
  wire [95:0] \activations$468 ;
  wire [95:0] \activations$476 ;
  wire [95:0] \activations$484 ;
  wire [95:0] \activations$492 ;
  wire [95:0] \activations$500 ;
  wire [95:0] \activations$508 ;
  wire [95:0] \activations$516 ;
  wire [95:0] \activations$524 ;
  wire [95:0] \activations$532 ;
  wire [95:0] \activations$540 ;
  wire [95:0] \activations$548 ;
  wire [95:0] \activations$556 ;
  wire [95:0] \activations$564 ;
  wire [95:0] \activations$572 ;
  wire [95:0] \activations$580 ;
  wire [95:0] \activations$586 ;
  wire [95:0] \activations$592 ;
  wire [95:0] \activations$598 ;
  wire [8:0] address;
  wire [8:0] \address$102 ;
  wire [8:0] \address$111 ;
  wire [8:0] \address$120 ;
  wire [8:0] \address$129 ;
  wire [8:0] \address$137 ;
  wire [8:0] \address$145 ;
  wire [8:0] \address$153 ;
  wire [8:0] \address$161 ;
  wire [8:0] \address$169 ;
  wire [8:0] \address$177 ;
  wire [8:0] \address$185 ;
  wire [8:0] \address$193 ;
  wire [8:0] \address$201 ;
  wire [8:0] \address$209 ;
  wire [8:0] \address$217 ;
  wire [8:0] \address$225 ;
  wire [8:0] \address$233 ;
  wire [8:0] \address$241 ;
  wire [8:0] \address$249 ;
  wire [8:0] \address$257 ;
  wire [8:0] \address$265 ;
  wire [8:0] \address$273 ;
  wire [8:0] \address$281 ;
  wire [8:0] \address$289 ;
  wire [8:0] \address$297 ;
  wire [8:0] \address$305 ;
  wire [8:0] \address$313 ;
  wire [8:0] \address$321 ;
  wire [8:0] \address$329 ;
  wire [8:0] \address$337 ;
  wire [8:0] \address$345 ;
  wire [8:0] \address$353 ;
  wire [8:0] \address$361 ;
  wire [8:0] \address$369 ;
  wire [8:0] \address$377 ;
  wire [8:0] \address$385 ;
  wire [8:0] \address$393 ;
  wire [8:0] \address$401 ;
  wire [8:0] \address$409 ;
  wire [8:0] \address$417 ;
  wire [8:0] \address$425 ;
  wire [8:0] \address$433 ;
  wire [8:0] \address$441 ;
  wire [8:0] \address$449 ;
  wire [8:0] \address$457 ;
  wire [8:0] \address$465 ;
  wire [8:0] \address$473 ;
  wire [8:0] \address$481 ;
  wire [8:0] \address$489 ;
  wire [8:0] \address$497 ;
  wire [8:0] \address$505 ;
  wire [8:0] \address$513 ;
  wire [8:0] \address$521 ;
  wire [8:0] \address$529 ;
  wire [8:0] \address$537 ;
  wire [8:0] \address$545 ;
  wire [8:0] \address$553 ;
  wire [8:0] \address$561 ;
  wire [8:0] \address$569 ;
  wire [8:0] \address$577 ;
  wire [8:0] \address$583 ;
  wire [8:0] \address$589 ;
  wire [8:0] \address$595 ;
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
  wire [75:0] \chain_i$109 ;
  wire [18:0] \chain_i$109[0] ;
  wire [18:0] \chain_i$109[1] ;
  wire [18:0] \chain_i$109[2] ;
  wire [18:0] \chain_i$109[3] ;
  wire [75:0] \chain_i$118 ;
  wire [18:0] \chain_i$118[0] ;
  wire [18:0] \chain_i$118[1] ;
  wire [18:0] \chain_i$118[2] ;
  wire [18:0] \chain_i$118[3] ;
  wire [75:0] \chain_i$127 ;
  wire [18:0] \chain_i$127[0] ;
  wire [18:0] \chain_i$127[1] ;
  wire [18:0] \chain_i$127[2] ;
  wire [18:0] \chain_i$127[3] ;
  wire [75:0] \chain_i$135 ;
  wire [18:0] \chain_i$135[0] ;
  wire [18:0] \chain_i$135[1] ;
  wire [18:0] \chain_i$135[2] ;
  wire [18:0] \chain_i$135[3] ;
  wire [75:0] \chain_i$143 ;
  wire [18:0] \chain_i$143[0] ;
  wire [18:0] \chain_i$143[1] ;
  wire [18:0] \chain_i$143[2] ;
  wire [18:0] \chain_i$143[3] ;
  wire [75:0] \chain_i$151 ;
  wire [18:0] \chain_i$151[0] ;
  wire [18:0] \chain_i$151[1] ;
  wire [18:0] \chain_i$151[2] ;
  wire [18:0] \chain_i$151[3] ;
  wire [75:0] \chain_i$159 ;
  wire [18:0] \chain_i$159[0] ;
  wire [18:0] \chain_i$159[1] ;
  wire [18:0] \chain_i$159[2] ;
  wire [18:0] \chain_i$159[3] ;
  wire [75:0] \chain_i$167 ;
  wire [18:0] \chain_i$167[0] ;
  wire [18:0] \chain_i$167[1] ;
  wire [18:0] \chain_i$167[2] ;
  wire [18:0] \chain_i$167[3] ;
  wire [75:0] \chain_i$175 ;
  wire [18:0] \chain_i$175[0] ;
  wire [18:0] \chain_i$175[1] ;
  wire [18:0] \chain_i$175[2] ;
  wire [18:0] \chain_i$175[3] ;
  wire [75:0] \chain_i$183 ;
  wire [18:0] \chain_i$183[0] ;
  wire [18:0] \chain_i$183[1] ;
  wire [18:0] \chain_i$183[2] ;
  wire [18:0] \chain_i$183[3] ;
  wire [75:0] \chain_i$191 ;
  wire [18:0] \chain_i$191[0] ;
  wire [18:0] \chain_i$191[1] ;
  wire [18:0] \chain_i$191[2] ;
  wire [18:0] \chain_i$191[3] ;
  wire [75:0] \chain_i$199 ;
  wire [18:0] \chain_i$199[0] ;
  wire [18:0] \chain_i$199[1] ;
  wire [18:0] \chain_i$199[2] ;
  wire [18:0] \chain_i$199[3] ;
  wire [75:0] \chain_i$207 ;
  wire [18:0] \chain_i$207[0] ;
  wire [18:0] \chain_i$207[1] ;
  wire [18:0] \chain_i$207[2] ;
  wire [18:0] \chain_i$207[3] ;
  wire [75:0] \chain_i$215 ;
  wire [18:0] \chain_i$215[0] ;
  wire [18:0] \chain_i$215[1] ;
  wire [18:0] \chain_i$215[2] ;
  wire [18:0] \chain_i$215[3] ;
  wire [75:0] \chain_i$223 ;
  wire [18:0] \chain_i$223[0] ;
  wire [18:0] \chain_i$223[1] ;
  wire [18:0] \chain_i$223[2] ;
  wire [18:0] \chain_i$223[3] ;
  wire [75:0] \chain_i$231 ;
  wire [18:0] \chain_i$231[0] ;
  wire [18:0] \chain_i$231[1] ;
  wire [18:0] \chain_i$231[2] ;
  wire [18:0] \chain_i$231[3] ;
  wire [75:0] \chain_i$239 ;
  wire [18:0] \chain_i$239[0] ;
  wire [18:0] \chain_i$239[1] ;
  wire [18:0] \chain_i$239[2] ;
  wire [18:0] \chain_i$239[3] ;
  wire [75:0] \chain_i$247 ;
  wire [18:0] \chain_i$247[0] ;
  wire [18:0] \chain_i$247[1] ;
  wire [18:0] \chain_i$247[2] ;
  wire [18:0] \chain_i$247[3] ;
  wire [75:0] \chain_i$255 ;
  wire [18:0] \chain_i$255[0] ;
  wire [18:0] \chain_i$255[1] ;
  wire [18:0] \chain_i$255[2] ;
  wire [18:0] \chain_i$255[3] ;
  wire [75:0] \chain_i$263 ;
  wire [18:0] \chain_i$263[0] ;
  wire [18:0] \chain_i$263[1] ;
  wire [18:0] \chain_i$263[2] ;
  wire [18:0] \chain_i$263[3] ;
  wire [75:0] \chain_i$271 ;
  wire [18:0] \chain_i$271[0] ;
  wire [18:0] \chain_i$271[1] ;
  wire [18:0] \chain_i$271[2] ;
  wire [18:0] \chain_i$271[3] ;
  wire [75:0] \chain_i$279 ;
  wire [18:0] \chain_i$279[0] ;
  wire [18:0] \chain_i$279[1] ;
  wire [18:0] \chain_i$279[2] ;
  wire [18:0] \chain_i$279[3] ;
  wire [75:0] \chain_i$287 ;
  wire [18:0] \chain_i$287[0] ;
  wire [18:0] \chain_i$287[1] ;
  wire [18:0] \chain_i$287[2] ;
  wire [18:0] \chain_i$287[3] ;
  wire [75:0] \chain_i$295 ;
  wire [18:0] \chain_i$295[0] ;
  wire [18:0] \chain_i$295[1] ;
  wire [18:0] \chain_i$295[2] ;
  wire [18:0] \chain_i$295[3] ;
  wire [75:0] \chain_i$303 ;
  wire [18:0] \chain_i$303[0] ;
  wire [18:0] \chain_i$303[1] ;
  wire [18:0] \chain_i$303[2] ;
  wire [18:0] \chain_i$303[3] ;
  wire [75:0] \chain_i$311 ;
  wire [18:0] \chain_i$311[0] ;
  wire [18:0] \chain_i$311[1] ;
  wire [18:0] \chain_i$311[2] ;
  wire [18:0] \chain_i$311[3] ;
  wire [75:0] \chain_i$319 ;
  wire [18:0] \chain_i$319[0] ;
  wire [18:0] \chain_i$319[1] ;
  wire [18:0] \chain_i$319[2] ;
  wire [18:0] \chain_i$319[3] ;
  wire [75:0] \chain_i$327 ;
  wire [18:0] \chain_i$327[0] ;
  wire [18:0] \chain_i$327[1] ;
  wire [18:0] \chain_i$327[2] ;
  wire [18:0] \chain_i$327[3] ;
  wire [75:0] \chain_i$335 ;
  wire [18:0] \chain_i$335[0] ;
  wire [18:0] \chain_i$335[1] ;
  wire [18:0] \chain_i$335[2] ;
  wire [18:0] \chain_i$335[3] ;
  wire [75:0] \chain_i$343 ;
  wire [18:0] \chain_i$343[0] ;
  wire [18:0] \chain_i$343[1] ;
  wire [18:0] \chain_i$343[2] ;
  wire [18:0] \chain_i$343[3] ;
  wire [75:0] \chain_i$351 ;
  wire [18:0] \chain_i$351[0] ;
  wire [18:0] \chain_i$351[1] ;
  wire [18:0] \chain_i$351[2] ;
  wire [18:0] \chain_i$351[3] ;
  wire [75:0] \chain_i$359 ;
  wire [18:0] \chain_i$359[0] ;
  wire [18:0] \chain_i$359[1] ;
  wire [18:0] \chain_i$359[2] ;
  wire [18:0] \chain_i$359[3] ;
  wire [75:0] \chain_i$367 ;
  wire [18:0] \chain_i$367[0] ;
  wire [18:0] \chain_i$367[1] ;
  wire [18:0] \chain_i$367[2] ;
  wire [18:0] \chain_i$367[3] ;
  wire [75:0] \chain_i$375 ;
  wire [18:0] \chain_i$375[0] ;
  wire [18:0] \chain_i$375[1] ;
  wire [18:0] \chain_i$375[2] ;
  wire [18:0] \chain_i$375[3] ;
  wire [75:0] \chain_i$383 ;
  wire [18:0] \chain_i$383[0] ;
  wire [18:0] \chain_i$383[1] ;
  wire [18:0] \chain_i$383[2] ;
  wire [18:0] \chain_i$383[3] ;
  wire [75:0] \chain_i$391 ;
  wire [18:0] \chain_i$391[0] ;
  wire [18:0] \chain_i$391[1] ;
  wire [18:0] \chain_i$391[2] ;
  wire [18:0] \chain_i$391[3] ;
  wire [75:0] \chain_i$399 ;
  wire [18:0] \chain_i$399[0] ;
  wire [18:0] \chain_i$399[1] ;
  wire [18:0] \chain_i$399[2] ;
  wire [18:0] \chain_i$399[3] ;
  wire [75:0] \chain_i$407 ;
  wire [18:0] \chain_i$407[0] ;
  wire [18:0] \chain_i$407[1] ;
  wire [18:0] \chain_i$407[2] ;
  wire [18:0] \chain_i$407[3] ;
  wire [75:0] \chain_i$415 ;
  wire [18:0] \chain_i$415[0] ;
  wire [18:0] \chain_i$415[1] ;
  wire [18:0] \chain_i$415[2] ;
  wire [18:0] \chain_i$415[3] ;
  wire [75:0] \chain_i$423 ;
  wire [18:0] \chain_i$423[0] ;
  wire [18:0] \chain_i$423[1] ;
  wire [18:0] \chain_i$423[2] ;
  wire [18:0] \chain_i$423[3] ;
  wire [75:0] \chain_i$431 ;
  wire [18:0] \chain_i$431[0] ;
  wire [18:0] \chain_i$431[1] ;
  wire [18:0] \chain_i$431[2] ;
  wire [18:0] \chain_i$431[3] ;
  wire [75:0] \chain_i$439 ;
  wire [18:0] \chain_i$439[0] ;
  wire [18:0] \chain_i$439[1] ;
  wire [18:0] \chain_i$439[2] ;
  wire [18:0] \chain_i$439[3] ;
  wire [75:0] \chain_i$447 ;
  wire [18:0] \chain_i$447[0] ;
  wire [18:0] \chain_i$447[1] ;
  wire [18:0] \chain_i$447[2] ;
  wire [18:0] \chain_i$447[3] ;
  wire [75:0] \chain_i$455 ;
  wire [18:0] \chain_i$455[0] ;
  wire [18:0] \chain_i$455[1] ;
  wire [18:0] \chain_i$455[2] ;
  wire [18:0] \chain_i$455[3] ;
  wire [75:0] \chain_i$463 ;
  wire [18:0] \chain_i$463[0] ;
  wire [18:0] \chain_i$463[1] ;
  wire [18:0] \chain_i$463[2] ;
  wire [18:0] \chain_i$463[3] ;
  wire [75:0] \chain_i$471 ;
  wire [18:0] \chain_i$471[0] ;
  wire [18:0] \chain_i$471[1] ;
  wire [18:0] \chain_i$471[2] ;
  wire [18:0] \chain_i$471[3] ;
  wire [75:0] \chain_i$479 ;
  wire [18:0] \chain_i$479[0] ;
  wire [18:0] \chain_i$479[1] ;
  wire [18:0] \chain_i$479[2] ;
  wire [18:0] \chain_i$479[3] ;
  wire [75:0] \chain_i$487 ;
  wire [18:0] \chain_i$487[0] ;
  wire [18:0] \chain_i$487[1] ;
  wire [18:0] \chain_i$487[2] ;
  wire [18:0] \chain_i$487[3] ;
  wire [75:0] \chain_i$495 ;
  wire [18:0] \chain_i$495[0] ;
  wire [18:0] \chain_i$495[1] ;
  wire [18:0] \chain_i$495[2] ;
  wire [18:0] \chain_i$495[3] ;
  wire [75:0] \chain_i$503 ;
  wire [18:0] \chain_i$503[0] ;
  wire [18:0] \chain_i$503[1] ;
  wire [18:0] \chain_i$503[2] ;
  wire [18:0] \chain_i$503[3] ;
  wire [75:0] \chain_i$511 ;
  wire [18:0] \chain_i$511[0] ;
  wire [18:0] \chain_i$511[1] ;
  wire [18:0] \chain_i$511[2] ;
  wire [18:0] \chain_i$511[3] ;
  wire [75:0] \chain_i$519 ;
  wire [18:0] \chain_i$519[0] ;
  wire [18:0] \chain_i$519[1] ;
  wire [18:0] \chain_i$519[2] ;
  wire [18:0] \chain_i$519[3] ;
  wire [75:0] \chain_i$527 ;
  wire [18:0] \chain_i$527[0] ;
  wire [18:0] \chain_i$527[1] ;
  wire [18:0] \chain_i$527[2] ;
  wire [18:0] \chain_i$527[3] ;
  wire [75:0] \chain_i$535 ;
  wire [18:0] \chain_i$535[0] ;
  wire [18:0] \chain_i$535[1] ;
  wire [18:0] \chain_i$535[2] ;
  wire [18:0] \chain_i$535[3] ;
  wire [75:0] \chain_i$543 ;
  wire [18:0] \chain_i$543[0] ;
  wire [18:0] \chain_i$543[1] ;
  wire [18:0] \chain_i$543[2] ;
  wire [18:0] \chain_i$543[3] ;
  wire [75:0] \chain_i$551 ;
  wire [18:0] \chain_i$551[0] ;
  wire [18:0] \chain_i$551[1] ;
  wire [18:0] \chain_i$551[2] ;
  wire [18:0] \chain_i$551[3] ;
  wire [75:0] \chain_i$559 ;
  wire [18:0] \chain_i$559[0] ;
  wire [18:0] \chain_i$559[1] ;
  wire [18:0] \chain_i$559[2] ;
  wire [18:0] \chain_i$559[3] ;
  wire [75:0] \chain_i$567 ;
  wire [18:0] \chain_i$567[0] ;
  wire [18:0] \chain_i$567[1] ;
  wire [18:0] \chain_i$567[2] ;
  wire [18:0] \chain_i$567[3] ;
  wire [75:0] \chain_i$575 ;
  wire [18:0] \chain_i$575[0] ;
  wire [18:0] \chain_i$575[1] ;
  wire [18:0] \chain_i$575[2] ;
  wire [18:0] \chain_i$575[3] ;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  wire [75:0] chain_o;
  wire [75:0] \chain_o$101 ;
  wire [18:0] \chain_o$101[0] ;
  wire [18:0] \chain_o$101[1] ;
  wire [18:0] \chain_o$101[2] ;
  wire [18:0] \chain_o$101[3] ;
  wire [75:0] \chain_o$108 ;
  wire [18:0] \chain_o$108[0] ;
  wire [18:0] \chain_o$108[1] ;
  wire [18:0] \chain_o$108[2] ;
  wire [18:0] \chain_o$108[3] ;
  wire [75:0] \chain_o$110 ;
  wire [18:0] \chain_o$110[0] ;
  wire [18:0] \chain_o$110[1] ;
  wire [18:0] \chain_o$110[2] ;
  wire [18:0] \chain_o$110[3] ;
  wire [75:0] \chain_o$117 ;
  wire [18:0] \chain_o$117[0] ;
  wire [18:0] \chain_o$117[1] ;
  wire [18:0] \chain_o$117[2] ;
  wire [18:0] \chain_o$117[3] ;
  wire [75:0] \chain_o$119 ;
  wire [18:0] \chain_o$119[0] ;
  wire [18:0] \chain_o$119[1] ;
  wire [18:0] \chain_o$119[2] ;
  wire [18:0] \chain_o$119[3] ;
  wire [75:0] \chain_o$126 ;
  wire [18:0] \chain_o$126[0] ;
  wire [18:0] \chain_o$126[1] ;
  wire [18:0] \chain_o$126[2] ;
  wire [18:0] \chain_o$126[3] ;
  wire [75:0] \chain_o$128 ;
  wire [18:0] \chain_o$128[0] ;
  wire [18:0] \chain_o$128[1] ;
  wire [18:0] \chain_o$128[2] ;
  wire [18:0] \chain_o$128[3] ;
  wire [75:0] \chain_o$136 ;
  wire [18:0] \chain_o$136[0] ;
  wire [18:0] \chain_o$136[1] ;
  wire [18:0] \chain_o$136[2] ;
  wire [18:0] \chain_o$136[3] ;
  wire [75:0] \chain_o$144 ;
  wire [18:0] \chain_o$144[0] ;
  wire [18:0] \chain_o$144[1] ;
  wire [18:0] \chain_o$144[2] ;
  wire [18:0] \chain_o$144[3] ;
  wire [75:0] \chain_o$152 ;
  wire [18:0] \chain_o$152[0] ;
  wire [18:0] \chain_o$152[1] ;
  wire [18:0] \chain_o$152[2] ;
  wire [18:0] \chain_o$152[3] ;
  wire [75:0] \chain_o$160 ;
  wire [18:0] \chain_o$160[0] ;
  wire [18:0] \chain_o$160[1] ;
  wire [18:0] \chain_o$160[2] ;
  wire [18:0] \chain_o$160[3] ;
  wire [75:0] \chain_o$168 ;
  wire [18:0] \chain_o$168[0] ;
  wire [18:0] \chain_o$168[1] ;
  wire [18:0] \chain_o$168[2] ;
  wire [18:0] \chain_o$168[3] ;
  wire [75:0] \chain_o$176 ;
  wire [18:0] \chain_o$176[0] ;
  wire [18:0] \chain_o$176[1] ;
  wire [18:0] \chain_o$176[2] ;
  wire [18:0] \chain_o$176[3] ;
  wire [75:0] \chain_o$184 ;
  wire [18:0] \chain_o$184[0] ;
  wire [18:0] \chain_o$184[1] ;
  wire [18:0] \chain_o$184[2] ;
  wire [18:0] \chain_o$184[3] ;
  wire [75:0] \chain_o$192 ;
  wire [18:0] \chain_o$192[0] ;
  wire [18:0] \chain_o$192[1] ;
  wire [18:0] \chain_o$192[2] ;
  wire [18:0] \chain_o$192[3] ;
  wire [75:0] \chain_o$200 ;
  wire [18:0] \chain_o$200[0] ;
  wire [18:0] \chain_o$200[1] ;
  wire [18:0] \chain_o$200[2] ;
  wire [18:0] \chain_o$200[3] ;
  wire [75:0] \chain_o$208 ;
  wire [18:0] \chain_o$208[0] ;
  wire [18:0] \chain_o$208[1] ;
  wire [18:0] \chain_o$208[2] ;
  wire [18:0] \chain_o$208[3] ;
  wire [75:0] \chain_o$216 ;
  wire [18:0] \chain_o$216[0] ;
  wire [18:0] \chain_o$216[1] ;
  wire [18:0] \chain_o$216[2] ;
  wire [18:0] \chain_o$216[3] ;
  wire [75:0] \chain_o$224 ;
  wire [18:0] \chain_o$224[0] ;
  wire [18:0] \chain_o$224[1] ;
  wire [18:0] \chain_o$224[2] ;
  wire [18:0] \chain_o$224[3] ;
  wire [75:0] \chain_o$232 ;
  wire [18:0] \chain_o$232[0] ;
  wire [18:0] \chain_o$232[1] ;
  wire [18:0] \chain_o$232[2] ;
  wire [18:0] \chain_o$232[3] ;
  wire [75:0] \chain_o$240 ;
  wire [18:0] \chain_o$240[0] ;
  wire [18:0] \chain_o$240[1] ;
  wire [18:0] \chain_o$240[2] ;
  wire [18:0] \chain_o$240[3] ;
  wire [75:0] \chain_o$248 ;
  wire [18:0] \chain_o$248[0] ;
  wire [18:0] \chain_o$248[1] ;
  wire [18:0] \chain_o$248[2] ;
  wire [18:0] \chain_o$248[3] ;
  wire [75:0] \chain_o$256 ;
  wire [18:0] \chain_o$256[0] ;
  wire [18:0] \chain_o$256[1] ;
  wire [18:0] \chain_o$256[2] ;
  wire [18:0] \chain_o$256[3] ;
  wire [75:0] \chain_o$264 ;
  wire [18:0] \chain_o$264[0] ;
  wire [18:0] \chain_o$264[1] ;
  wire [18:0] \chain_o$264[2] ;
  wire [18:0] \chain_o$264[3] ;
  wire [75:0] \chain_o$272 ;
  wire [18:0] \chain_o$272[0] ;
  wire [18:0] \chain_o$272[1] ;
  wire [18:0] \chain_o$272[2] ;
  wire [18:0] \chain_o$272[3] ;
  wire [75:0] \chain_o$280 ;
  wire [18:0] \chain_o$280[0] ;
  wire [18:0] \chain_o$280[1] ;
  wire [18:0] \chain_o$280[2] ;
  wire [18:0] \chain_o$280[3] ;
  wire [75:0] \chain_o$288 ;
  wire [18:0] \chain_o$288[0] ;
  wire [18:0] \chain_o$288[1] ;
  wire [18:0] \chain_o$288[2] ;
  wire [18:0] \chain_o$288[3] ;
  wire [75:0] \chain_o$296 ;
  wire [18:0] \chain_o$296[0] ;
  wire [18:0] \chain_o$296[1] ;
  wire [18:0] \chain_o$296[2] ;
  wire [18:0] \chain_o$296[3] ;
  wire [75:0] \chain_o$304 ;
  wire [18:0] \chain_o$304[0] ;
  wire [18:0] \chain_o$304[1] ;
  wire [18:0] \chain_o$304[2] ;
  wire [18:0] \chain_o$304[3] ;
  wire [75:0] \chain_o$312 ;
  wire [18:0] \chain_o$312[0] ;
  wire [18:0] \chain_o$312[1] ;
  wire [18:0] \chain_o$312[2] ;
  wire [18:0] \chain_o$312[3] ;
  wire [75:0] \chain_o$320 ;
  wire [18:0] \chain_o$320[0] ;
  wire [18:0] \chain_o$320[1] ;
  wire [18:0] \chain_o$320[2] ;
  wire [18:0] \chain_o$320[3] ;
  wire [75:0] \chain_o$328 ;
  wire [18:0] \chain_o$328[0] ;
  wire [18:0] \chain_o$328[1] ;
  wire [18:0] \chain_o$328[2] ;
  wire [18:0] \chain_o$328[3] ;
  wire [75:0] \chain_o$336 ;
  wire [18:0] \chain_o$336[0] ;
  wire [18:0] \chain_o$336[1] ;
  wire [18:0] \chain_o$336[2] ;
  wire [18:0] \chain_o$336[3] ;
  wire [75:0] \chain_o$344 ;
  wire [18:0] \chain_o$344[0] ;
  wire [18:0] \chain_o$344[1] ;
  wire [18:0] \chain_o$344[2] ;
  wire [18:0] \chain_o$344[3] ;
  wire [75:0] \chain_o$352 ;
  wire [18:0] \chain_o$352[0] ;
  wire [18:0] \chain_o$352[1] ;
  wire [18:0] \chain_o$352[2] ;
  wire [18:0] \chain_o$352[3] ;
  wire [75:0] \chain_o$360 ;
  wire [18:0] \chain_o$360[0] ;
  wire [18:0] \chain_o$360[1] ;
  wire [18:0] \chain_o$360[2] ;
  wire [18:0] \chain_o$360[3] ;
  wire [75:0] \chain_o$368 ;
  wire [18:0] \chain_o$368[0] ;
  wire [18:0] \chain_o$368[1] ;
  wire [18:0] \chain_o$368[2] ;
  wire [18:0] \chain_o$368[3] ;
  wire [75:0] \chain_o$376 ;
  wire [18:0] \chain_o$376[0] ;
  wire [18:0] \chain_o$376[1] ;
  wire [18:0] \chain_o$376[2] ;
  wire [18:0] \chain_o$376[3] ;
  wire [75:0] \chain_o$384 ;
  wire [18:0] \chain_o$384[0] ;
  wire [18:0] \chain_o$384[1] ;
  wire [18:0] \chain_o$384[2] ;
  wire [18:0] \chain_o$384[3] ;
  wire [75:0] \chain_o$392 ;
  wire [18:0] \chain_o$392[0] ;
  wire [18:0] \chain_o$392[1] ;
  wire [18:0] \chain_o$392[2] ;
  wire [18:0] \chain_o$392[3] ;
  wire [75:0] \chain_o$400 ;
  wire [18:0] \chain_o$400[0] ;
  wire [18:0] \chain_o$400[1] ;
  wire [18:0] \chain_o$400[2] ;
  wire [18:0] \chain_o$400[3] ;
  wire [75:0] \chain_o$408 ;
  wire [18:0] \chain_o$408[0] ;
  wire [18:0] \chain_o$408[1] ;
  wire [18:0] \chain_o$408[2] ;
  wire [18:0] \chain_o$408[3] ;
  wire [75:0] \chain_o$416 ;
  wire [18:0] \chain_o$416[0] ;
  wire [18:0] \chain_o$416[1] ;
  wire [18:0] \chain_o$416[2] ;
  wire [18:0] \chain_o$416[3] ;
  wire [75:0] \chain_o$424 ;
  wire [18:0] \chain_o$424[0] ;
  wire [18:0] \chain_o$424[1] ;
  wire [18:0] \chain_o$424[2] ;
  wire [18:0] \chain_o$424[3] ;
  wire [75:0] \chain_o$432 ;
  wire [18:0] \chain_o$432[0] ;
  wire [18:0] \chain_o$432[1] ;
  wire [18:0] \chain_o$432[2] ;
  wire [18:0] \chain_o$432[3] ;
  wire [75:0] \chain_o$440 ;
  wire [18:0] \chain_o$440[0] ;
  wire [18:0] \chain_o$440[1] ;
  wire [18:0] \chain_o$440[2] ;
  wire [18:0] \chain_o$440[3] ;
  wire [75:0] \chain_o$448 ;
  wire [18:0] \chain_o$448[0] ;
  wire [18:0] \chain_o$448[1] ;
  wire [18:0] \chain_o$448[2] ;
  wire [18:0] \chain_o$448[3] ;
  wire [75:0] \chain_o$456 ;
  wire [18:0] \chain_o$456[0] ;
  wire [18:0] \chain_o$456[1] ;
  wire [18:0] \chain_o$456[2] ;
  wire [18:0] \chain_o$456[3] ;
  wire [75:0] \chain_o$464 ;
  wire [18:0] \chain_o$464[0] ;
  wire [18:0] \chain_o$464[1] ;
  wire [18:0] \chain_o$464[2] ;
  wire [18:0] \chain_o$464[3] ;
  wire [75:0] \chain_o$472 ;
  wire [18:0] \chain_o$472[0] ;
  wire [18:0] \chain_o$472[1] ;
  wire [18:0] \chain_o$472[2] ;
  wire [18:0] \chain_o$472[3] ;
  wire [75:0] \chain_o$480 ;
  wire [18:0] \chain_o$480[0] ;
  wire [18:0] \chain_o$480[1] ;
  wire [18:0] \chain_o$480[2] ;
  wire [18:0] \chain_o$480[3] ;
  wire [75:0] \chain_o$488 ;
  wire [18:0] \chain_o$488[0] ;
  wire [18:0] \chain_o$488[1] ;
  wire [18:0] \chain_o$488[2] ;
  wire [18:0] \chain_o$488[3] ;
  wire [75:0] \chain_o$496 ;
  wire [18:0] \chain_o$496[0] ;
  wire [18:0] \chain_o$496[1] ;
  wire [18:0] \chain_o$496[2] ;
  wire [18:0] \chain_o$496[3] ;
  wire [75:0] \chain_o$504 ;
  wire [18:0] \chain_o$504[0] ;
  wire [18:0] \chain_o$504[1] ;
  wire [18:0] \chain_o$504[2] ;
  wire [18:0] \chain_o$504[3] ;
  wire [75:0] \chain_o$512 ;
  wire [18:0] \chain_o$512[0] ;
  wire [18:0] \chain_o$512[1] ;
  wire [18:0] \chain_o$512[2] ;
  wire [18:0] \chain_o$512[3] ;
  wire [75:0] \chain_o$520 ;
  wire [18:0] \chain_o$520[0] ;
  wire [18:0] \chain_o$520[1] ;
  wire [18:0] \chain_o$520[2] ;
  wire [18:0] \chain_o$520[3] ;
  wire [75:0] \chain_o$528 ;
  wire [18:0] \chain_o$528[0] ;
  wire [18:0] \chain_o$528[1] ;
  wire [18:0] \chain_o$528[2] ;
  wire [18:0] \chain_o$528[3] ;
  wire [75:0] \chain_o$536 ;
  wire [18:0] \chain_o$536[0] ;
  wire [18:0] \chain_o$536[1] ;
  wire [18:0] \chain_o$536[2] ;
  wire [18:0] \chain_o$536[3] ;
  wire [75:0] \chain_o$544 ;
  wire [18:0] \chain_o$544[0] ;
  wire [18:0] \chain_o$544[1] ;
  wire [18:0] \chain_o$544[2] ;
  wire [18:0] \chain_o$544[3] ;
  wire [75:0] \chain_o$552 ;
  wire [18:0] \chain_o$552[0] ;
  wire [18:0] \chain_o$552[1] ;
  wire [18:0] \chain_o$552[2] ;
  wire [18:0] \chain_o$552[3] ;
  wire [75:0] \chain_o$560 ;
  wire [18:0] \chain_o$560[0] ;
  wire [18:0] \chain_o$560[1] ;
  wire [18:0] \chain_o$560[2] ;
  wire [18:0] \chain_o$560[3] ;
  wire [75:0] \chain_o$568 ;
  wire [18:0] \chain_o$568[0] ;
  wire [18:0] \chain_o$568[1] ;
  wire [18:0] \chain_o$568[2] ;
  wire [18:0] \chain_o$568[3] ;
  wire [75:0] \chain_o$576 ;
  wire [18:0] \chain_o$576[0] ;
  wire [18:0] \chain_o$576[1] ;
  wire [18:0] \chain_o$576[2] ;
  wire [18:0] \chain_o$576[3] ;
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
  wire [7:0] \control$106 ;
  wire \control$106.edge ;
  wire \control$106.en ;
  wire \control$106.first ;
  wire \control$106.last ;
  wire [3:0] \control$106.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$115 ;
  wire \control$115.edge ;
  wire \control$115.en ;
  wire \control$115.first ;
  wire \control$115.last ;
  wire [3:0] \control$115.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$124 ;
  wire \control$124.edge ;
  wire \control$124.en ;
  wire \control$124.first ;
  wire \control$124.last ;
  wire [3:0] \control$124.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$133 ;
  wire \control$133.edge ;
  wire \control$133.en ;
  wire \control$133.first ;
  wire \control$133.last ;
  wire [3:0] \control$133.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$141 ;
  wire \control$141.edge ;
  wire \control$141.en ;
  wire \control$141.first ;
  wire \control$141.last ;
  wire [3:0] \control$141.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$149 ;
  wire \control$149.edge ;
  wire \control$149.en ;
  wire \control$149.first ;
  wire \control$149.last ;
  wire [3:0] \control$149.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$157 ;
  wire \control$157.edge ;
  wire \control$157.en ;
  wire \control$157.first ;
  wire \control$157.last ;
  wire [3:0] \control$157.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$165 ;
  wire \control$165.edge ;
  wire \control$165.en ;
  wire \control$165.first ;
  wire \control$165.last ;
  wire [3:0] \control$165.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$173 ;
  wire \control$173.edge ;
  wire \control$173.en ;
  wire \control$173.first ;
  wire \control$173.last ;
  wire [3:0] \control$173.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$181 ;
  wire \control$181.edge ;
  wire \control$181.en ;
  wire \control$181.first ;
  wire \control$181.last ;
  wire [3:0] \control$181.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$189 ;
  wire \control$189.edge ;
  wire \control$189.en ;
  wire \control$189.first ;
  wire \control$189.last ;
  wire [3:0] \control$189.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$197 ;
  wire \control$197.edge ;
  wire \control$197.en ;
  wire \control$197.first ;
  wire \control$197.last ;
  wire [3:0] \control$197.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$205 ;
  wire \control$205.edge ;
  wire \control$205.en ;
  wire \control$205.first ;
  wire \control$205.last ;
  wire [3:0] \control$205.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$213 ;
  wire \control$213.edge ;
  wire \control$213.en ;
  wire \control$213.first ;
  wire \control$213.last ;
  wire [3:0] \control$213.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$221 ;
  wire \control$221.edge ;
  wire \control$221.en ;
  wire \control$221.first ;
  wire \control$221.last ;
  wire [3:0] \control$221.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$229 ;
  wire \control$229.edge ;
  wire \control$229.en ;
  wire \control$229.first ;
  wire \control$229.last ;
  wire [3:0] \control$229.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$237 ;
  wire \control$237.edge ;
  wire \control$237.en ;
  wire \control$237.first ;
  wire \control$237.last ;
  wire [3:0] \control$237.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$245 ;
  wire \control$245.edge ;
  wire \control$245.en ;
  wire \control$245.first ;
  wire \control$245.last ;
  wire [3:0] \control$245.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$253 ;
  wire \control$253.edge ;
  wire \control$253.en ;
  wire \control$253.first ;
  wire \control$253.last ;
  wire [3:0] \control$253.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$261 ;
  wire \control$261.edge ;
  wire \control$261.en ;
  wire \control$261.first ;
  wire \control$261.last ;
  wire [3:0] \control$261.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$269 ;
  wire \control$269.edge ;
  wire \control$269.en ;
  wire \control$269.first ;
  wire \control$269.last ;
  wire [3:0] \control$269.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$277 ;
  wire \control$277.edge ;
  wire \control$277.en ;
  wire \control$277.first ;
  wire \control$277.last ;
  wire [3:0] \control$277.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$285 ;
  wire \control$285.edge ;
  wire \control$285.en ;
  wire \control$285.first ;
  wire \control$285.last ;
  wire [3:0] \control$285.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$293 ;
  wire \control$293.edge ;
  wire \control$293.en ;
  wire \control$293.first ;
  wire \control$293.last ;
  wire [3:0] \control$293.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$301 ;
  wire \control$301.edge ;
  wire \control$301.en ;
  wire \control$301.first ;
  wire \control$301.last ;
  wire [3:0] \control$301.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$309 ;
  wire \control$309.edge ;
  wire \control$309.en ;
  wire \control$309.first ;
  wire \control$309.last ;
  wire [3:0] \control$309.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$317 ;
  wire \control$317.edge ;
  wire \control$317.en ;
  wire \control$317.first ;
  wire \control$317.last ;
  wire [3:0] \control$317.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$325 ;
  wire \control$325.edge ;
  wire \control$325.en ;
  wire \control$325.first ;
  wire \control$325.last ;
  wire [3:0] \control$325.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$333 ;
  wire \control$333.edge ;
  wire \control$333.en ;
  wire \control$333.first ;
  wire \control$333.last ;
  wire [3:0] \control$333.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$341 ;
  wire \control$341.edge ;
  wire \control$341.en ;
  wire \control$341.first ;
  wire \control$341.last ;
  wire [3:0] \control$341.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$349 ;
  wire \control$349.edge ;
  wire \control$349.en ;
  wire \control$349.first ;
  wire \control$349.last ;
  wire [3:0] \control$349.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$357 ;
  wire \control$357.edge ;
  wire \control$357.en ;
  wire \control$357.first ;
  wire \control$357.last ;
  wire [3:0] \control$357.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$365 ;
  wire \control$365.edge ;
  wire \control$365.en ;
  wire \control$365.first ;
  wire \control$365.last ;
  wire [3:0] \control$365.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$373 ;
  wire \control$373.edge ;
  wire \control$373.en ;
  wire \control$373.first ;
  wire \control$373.last ;
  wire [3:0] \control$373.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$381 ;
  wire \control$381.edge ;
  wire \control$381.en ;
  wire \control$381.first ;
  wire \control$381.last ;
  wire [3:0] \control$381.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$389 ;
  wire \control$389.edge ;
  wire \control$389.en ;
  wire \control$389.first ;
  wire \control$389.last ;
  wire [3:0] \control$389.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$397 ;
  wire \control$397.edge ;
  wire \control$397.en ;
  wire \control$397.first ;
  wire \control$397.last ;
  wire [3:0] \control$397.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$405 ;
  wire \control$405.edge ;
  wire \control$405.en ;
  wire \control$405.first ;
  wire \control$405.last ;
  wire [3:0] \control$405.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$413 ;
  wire \control$413.edge ;
  wire \control$413.en ;
  wire \control$413.first ;
  wire \control$413.last ;
  wire [3:0] \control$413.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$421 ;
  wire \control$421.edge ;
  wire \control$421.en ;
  wire \control$421.first ;
  wire \control$421.last ;
  wire [3:0] \control$421.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$429 ;
  wire \control$429.edge ;
  wire \control$429.en ;
  wire \control$429.first ;
  wire \control$429.last ;
  wire [3:0] \control$429.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$437 ;
  wire \control$437.edge ;
  wire \control$437.en ;
  wire \control$437.first ;
  wire \control$437.last ;
  wire [3:0] \control$437.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$445 ;
  wire \control$445.edge ;
  wire \control$445.en ;
  wire \control$445.first ;
  wire \control$445.last ;
  wire [3:0] \control$445.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$453 ;
  wire \control$453.edge ;
  wire \control$453.en ;
  wire \control$453.first ;
  wire \control$453.last ;
  wire [3:0] \control$453.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$461 ;
  wire \control$461.edge ;
  wire \control$461.en ;
  wire \control$461.first ;
  wire \control$461.last ;
  wire [3:0] \control$461.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$469 ;
  wire \control$469.edge ;
  wire \control$469.en ;
  wire \control$469.first ;
  wire \control$469.last ;
  wire [3:0] \control$469.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$477 ;
  wire \control$477.edge ;
  wire \control$477.en ;
  wire \control$477.first ;
  wire \control$477.last ;
  wire [3:0] \control$477.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$485 ;
  wire \control$485.edge ;
  wire \control$485.en ;
  wire \control$485.first ;
  wire \control$485.last ;
  wire [3:0] \control$485.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$493 ;
  wire \control$493.edge ;
  wire \control$493.en ;
  wire \control$493.first ;
  wire \control$493.last ;
  wire [3:0] \control$493.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$501 ;
  wire \control$501.edge ;
  wire \control$501.en ;
  wire \control$501.first ;
  wire \control$501.last ;
  wire [3:0] \control$501.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$509 ;
  wire \control$509.edge ;
  wire \control$509.en ;
  wire \control$509.first ;
  wire \control$509.last ;
  wire [3:0] \control$509.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$517 ;
  wire \control$517.edge ;
  wire \control$517.en ;
  wire \control$517.first ;
  wire \control$517.last ;
  wire [3:0] \control$517.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$525 ;
  wire \control$525.edge ;
  wire \control$525.en ;
  wire \control$525.first ;
  wire \control$525.last ;
  wire [3:0] \control$525.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$533 ;
  wire \control$533.edge ;
  wire \control$533.en ;
  wire \control$533.first ;
  wire \control$533.last ;
  wire [3:0] \control$533.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$541 ;
  wire \control$541.edge ;
  wire \control$541.en ;
  wire \control$541.first ;
  wire \control$541.last ;
  wire [3:0] \control$541.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$549 ;
  wire \control$549.edge ;
  wire \control$549.en ;
  wire \control$549.first ;
  wire \control$549.last ;
  wire [3:0] \control$549.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$557 ;
  wire \control$557.edge ;
  wire \control$557.en ;
  wire \control$557.first ;
  wire \control$557.last ;
  wire [3:0] \control$557.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$565 ;
  wire \control$565.edge ;
  wire \control$565.en ;
  wire \control$565.first ;
  wire \control$565.last ;
  wire [3:0] \control$565.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$573 ;
  wire \control$573.edge ;
  wire \control$573.en ;
  wire \control$573.first ;
  wire \control$573.last ;
  wire [3:0] \control$573.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$581 ;
  wire \control$581.edge ;
  wire \control$581.en ;
  wire \control$581.first ;
  wire \control$581.last ;
  wire [3:0] \control$581.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$587 ;
  wire \control$587.edge ;
  wire \control$587.en ;
  wire \control$587.first ;
  wire \control$587.last ;
  wire [3:0] \control$587.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$593 ;
  wire \control$593.edge ;
  wire \control$593.en ;
  wire \control$593.first ;
  wire \control$593.last ;
  wire [3:0] \control$593.tile ;
  (* init = 8'h00 *)
  wire [7:0] \control$599 ;
  wire \control$599.edge ;
  wire \control$599.en ;
  wire \control$599.first ;
  wire \control$599.last ;
  wire [3:0] \control$599.tile ;
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
  output [2:0] \error$608 ;
  reg [2:0] \error$608  = 3'h0;
  (* enum_base_type = "Error" *)
  (* enum_value_000 = "NONE" *)
  (* enum_value_001 = "BAD_SHAPE" *)
  (* enum_value_010 = "BAD_MODE" *)
  (* enum_value_011 = "TLAST_EARLY" *)
  (* enum_value_100 = "TLAST_MISSING" *)
  (* enum_value_101 = "BAD_COMMAND" *)
  wire [2:0] \error$612 ;
  (* enum_base_type = "Error" *)
  (* enum_value_000 = "NONE" *)
  (* enum_value_001 = "BAD_SHAPE" *)
  (* enum_value_010 = "BAD_MODE" *)
  (* enum_value_011 = "TLAST_EARLY" *)
  (* enum_value_100 = "TLAST_MISSING" *)
  (* enum_value_101 = "BAD_COMMAND" *)
  wire [2:0] \error$613 ;
  wire fault;
  wire \fault$611 ;
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
  input [3:0] \port$1020$0 ;
  wire [3:0] \port$1020$0 ;
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
  wire \shift$107 ;
  wire \shift$116 ;
  wire \shift$125 ;
  wire \shift$134 ;
  wire \shift$142 ;
  wire \shift$150 ;
  wire \shift$158 ;
  wire \shift$166 ;
  wire \shift$174 ;
  wire \shift$182 ;
  wire \shift$190 ;
  wire \shift$198 ;
  wire \shift$206 ;
  wire \shift$214 ;
  wire \shift$222 ;
  wire \shift$230 ;
  wire \shift$238 ;
  wire \shift$246 ;
  wire \shift$254 ;
  wire \shift$262 ;
  wire \shift$270 ;
  wire \shift$278 ;
  wire \shift$286 ;
  wire \shift$294 ;
  wire \shift$302 ;
  wire \shift$310 ;
  wire \shift$318 ;
  wire \shift$326 ;
  wire \shift$334 ;
  wire \shift$342 ;
  wire \shift$350 ;
  wire \shift$358 ;
  wire \shift$366 ;
  wire \shift$374 ;
  wire \shift$382 ;
  wire \shift$390 ;
  wire \shift$398 ;
  wire \shift$406 ;
  wire \shift$414 ;
  wire \shift$422 ;
  wire \shift$430 ;
  wire \shift$438 ;
  wire \shift$446 ;
  wire \shift$454 ;
  wire \shift$462 ;
  wire \shift$470 ;
  wire \shift$478 ;
  wire \shift$486 ;
  wire \shift$494 ;
  wire \shift$502 ;
  wire \shift$510 ;
  wire \shift$518 ;
  wire \shift$526 ;
  wire \shift$534 ;
  wire \shift$542 ;
  wire \shift$550 ;
  wire \shift$558 ;
  wire \shift$566 ;
  wire \shift$574 ;
  wire \shift$582 ;
  wire \shift$588 ;
  wire \shift$594 ;
  wire \shift$600 ;
  wire \shift$97 ;
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
  wire [80:0] \write$104 ;
  wire [8:0] \write$104.addr ;
  wire [71:0] \write$104.data ;
  wire [80:0] \write$113 ;
  wire [8:0] \write$113.addr ;
  wire [71:0] \write$113.data ;
  wire [80:0] \write$122 ;
  wire [8:0] \write$122.addr ;
  wire [71:0] \write$122.data ;
  wire [80:0] \write$131 ;
  wire [8:0] \write$131.addr ;
  wire [71:0] \write$131.data ;
  wire [80:0] \write$139 ;
  wire [8:0] \write$139.addr ;
  wire [71:0] \write$139.data ;
  wire [80:0] \write$147 ;
  wire [8:0] \write$147.addr ;
  wire [71:0] \write$147.data ;
  wire [80:0] \write$155 ;
  wire [8:0] \write$155.addr ;
  wire [71:0] \write$155.data ;
  wire [80:0] \write$163 ;
  wire [8:0] \write$163.addr ;
  wire [71:0] \write$163.data ;
  wire [80:0] \write$171 ;
  wire [8:0] \write$171.addr ;
  wire [71:0] \write$171.data ;
  wire [80:0] \write$179 ;
  wire [8:0] \write$179.addr ;
  wire [71:0] \write$179.data ;
  wire [80:0] \write$187 ;
  wire [8:0] \write$187.addr ;
  wire [71:0] \write$187.data ;
  wire [80:0] \write$195 ;
  wire [8:0] \write$195.addr ;
  wire [71:0] \write$195.data ;
  wire [80:0] \write$203 ;
  wire [8:0] \write$203.addr ;
  wire [71:0] \write$203.data ;
  wire [80:0] \write$211 ;
  wire [8:0] \write$211.addr ;
  wire [71:0] \write$211.data ;
  wire [80:0] \write$219 ;
  wire [8:0] \write$219.addr ;
  wire [71:0] \write$219.data ;
  wire [80:0] \write$227 ;
  wire [8:0] \write$227.addr ;
  wire [71:0] \write$227.data ;
  wire [80:0] \write$235 ;
  wire [8:0] \write$235.addr ;
  wire [71:0] \write$235.data ;
  wire [80:0] \write$243 ;
  wire [8:0] \write$243.addr ;
  wire [71:0] \write$243.data ;
  wire [80:0] \write$251 ;
  wire [8:0] \write$251.addr ;
  wire [71:0] \write$251.data ;
  wire [80:0] \write$259 ;
  wire [8:0] \write$259.addr ;
  wire [71:0] \write$259.data ;
  wire [80:0] \write$267 ;
  wire [8:0] \write$267.addr ;
  wire [71:0] \write$267.data ;
  wire [80:0] \write$275 ;
  wire [8:0] \write$275.addr ;
  wire [71:0] \write$275.data ;
  wire [80:0] \write$283 ;
  wire [8:0] \write$283.addr ;
  wire [71:0] \write$283.data ;
  wire [80:0] \write$291 ;
  wire [8:0] \write$291.addr ;
  wire [71:0] \write$291.data ;
  wire [80:0] \write$299 ;
  wire [8:0] \write$299.addr ;
  wire [71:0] \write$299.data ;
  wire [80:0] \write$307 ;
  wire [8:0] \write$307.addr ;
  wire [71:0] \write$307.data ;
  wire [80:0] \write$315 ;
  wire [8:0] \write$315.addr ;
  wire [71:0] \write$315.data ;
  wire [80:0] \write$323 ;
  wire [8:0] \write$323.addr ;
  wire [71:0] \write$323.data ;
  wire [80:0] \write$331 ;
  wire [8:0] \write$331.addr ;
  wire [71:0] \write$331.data ;
  wire [80:0] \write$339 ;
  wire [8:0] \write$339.addr ;
  wire [71:0] \write$339.data ;
  wire [80:0] \write$347 ;
  wire [8:0] \write$347.addr ;
  wire [71:0] \write$347.data ;
  wire [80:0] \write$355 ;
  wire [8:0] \write$355.addr ;
  wire [71:0] \write$355.data ;
  wire [80:0] \write$363 ;
  wire [8:0] \write$363.addr ;
  wire [71:0] \write$363.data ;
  wire [80:0] \write$371 ;
  wire [8:0] \write$371.addr ;
  wire [71:0] \write$371.data ;
  wire [80:0] \write$379 ;
  wire [8:0] \write$379.addr ;
  wire [71:0] \write$379.data ;
  wire [80:0] \write$387 ;
  wire [8:0] \write$387.addr ;
  wire [71:0] \write$387.data ;
  wire [80:0] \write$395 ;
  wire [8:0] \write$395.addr ;
  wire [71:0] \write$395.data ;
  wire [80:0] \write$403 ;
  wire [8:0] \write$403.addr ;
  wire [71:0] \write$403.data ;
  wire [80:0] \write$411 ;
  wire [8:0] \write$411.addr ;
  wire [71:0] \write$411.data ;
  wire [80:0] \write$419 ;
  wire [8:0] \write$419.addr ;
  wire [71:0] \write$419.data ;
  wire [80:0] \write$427 ;
  wire [8:0] \write$427.addr ;
  wire [71:0] \write$427.data ;
  wire [80:0] \write$435 ;
  wire [8:0] \write$435.addr ;
  wire [71:0] \write$435.data ;
  wire [80:0] \write$443 ;
  wire [8:0] \write$443.addr ;
  wire [71:0] \write$443.data ;
  wire [80:0] \write$451 ;
  wire [8:0] \write$451.addr ;
  wire [71:0] \write$451.data ;
  wire [80:0] \write$459 ;
  wire [8:0] \write$459.addr ;
  wire [71:0] \write$459.data ;
  wire [80:0] \write$467 ;
  wire [8:0] \write$467.addr ;
  wire [71:0] \write$467.data ;
  wire [80:0] \write$475 ;
  wire [8:0] \write$475.addr ;
  wire [71:0] \write$475.data ;
  wire [80:0] \write$483 ;
  wire [8:0] \write$483.addr ;
  wire [71:0] \write$483.data ;
  wire [80:0] \write$491 ;
  wire [8:0] \write$491.addr ;
  wire [71:0] \write$491.data ;
  wire [80:0] \write$499 ;
  wire [8:0] \write$499.addr ;
  wire [71:0] \write$499.data ;
  wire [80:0] \write$507 ;
  wire [8:0] \write$507.addr ;
  wire [71:0] \write$507.data ;
  wire [80:0] \write$515 ;
  wire [8:0] \write$515.addr ;
  wire [71:0] \write$515.data ;
  wire [80:0] \write$523 ;
  wire [8:0] \write$523.addr ;
  wire [71:0] \write$523.data ;
  wire [80:0] \write$531 ;
  wire [8:0] \write$531.addr ;
  wire [71:0] \write$531.data ;
  wire [80:0] \write$539 ;
  wire [8:0] \write$539.addr ;
  wire [71:0] \write$539.data ;
  wire [80:0] \write$547 ;
  wire [8:0] \write$547.addr ;
  wire [71:0] \write$547.data ;
  wire [80:0] \write$555 ;
  wire [8:0] \write$555.addr ;
  wire [71:0] \write$555.data ;
  wire [80:0] \write$563 ;
  wire [8:0] \write$563.addr ;
  wire [71:0] \write$563.data ;
  wire [80:0] \write$571 ;
  wire [8:0] \write$571.addr ;
  wire [71:0] \write$571.data ;
  wire [80:0] \write$579 ;
  wire [8:0] \write$579.addr ;
  wire [71:0] \write$579.data ;
  wire [80:0] \write$585 ;
  wire [8:0] \write$585.addr ;
  wire [71:0] \write$585.data ;
  wire [80:0] \write$591 ;
  wire [8:0] \write$591.addr ;
  wire [71:0] \write$591.data ;
  wire [80:0] \write$597 ;
  wire [8:0] \write$597.addr ;
  wire [71:0] \write$597.data ;
  wire [80:0] \write$91 ;
  wire [8:0] \write$91.addr ;
  wire [71:0] \write$91.data ;
  wire [7:0] \write.addr ;
  wire [535:0] \write.data ;
  wire write_en;
  wire \write_en$103 ;
  wire \write_en$112 ;
  wire \write_en$121 ;
  wire \write_en$130 ;
  wire \write_en$138 ;
  wire \write_en$146 ;
  wire \write_en$154 ;
  wire \write_en$162 ;
  wire \write_en$170 ;
  wire \write_en$178 ;
  wire \write_en$186 ;
  wire \write_en$194 ;
  wire \write_en$202 ;
  wire \write_en$210 ;
  wire \write_en$218 ;
  wire \write_en$226 ;
  wire \write_en$234 ;
  wire \write_en$242 ;
  wire \write_en$250 ;
  wire \write_en$258 ;
  wire \write_en$266 ;
  wire \write_en$274 ;
  wire \write_en$282 ;
  wire \write_en$290 ;
  wire \write_en$298 ;
  wire \write_en$306 ;
  wire \write_en$314 ;
  wire \write_en$322 ;
  wire \write_en$330 ;
  wire \write_en$338 ;
  wire \write_en$346 ;
  wire \write_en$354 ;
  wire \write_en$362 ;
  wire \write_en$370 ;
  wire \write_en$378 ;
  wire \write_en$386 ;
  wire \write_en$394 ;
  wire \write_en$402 ;
  wire \write_en$410 ;
  wire \write_en$418 ;
  wire \write_en$426 ;
  wire \write_en$434 ;
  wire \write_en$442 ;
  wire \write_en$450 ;
  wire \write_en$458 ;
  wire \write_en$466 ;
  wire \write_en$474 ;
  wire \write_en$482 ;
  wire \write_en$490 ;
  wire \write_en$498 ;
  wire \write_en$506 ;
  wire \write_en$514 ;
  wire \write_en$522 ;
  wire \write_en$530 ;
  wire \write_en$538 ;
  wire \write_en$546 ;
  wire \write_en$554 ;
  wire \write_en$562 ;
  wire \write_en$570 ;
  wire \write_en$578 ;
  wire \write_en$584 ;
  wire \write_en$590 ;
  wire \write_en$596 ;
  wire \write_en$89 ;
  assign \$22  = | \wait ;
  assign \$23  = \wait  - 1'h1;
  assign \$24  = \wait  == 1'h1;
  assign \$25  = ! error;
  assign \$26  = | \port$1020$0 [2:0];
  assign \$27  = ~ busy;
  assign \$28  = \$26  & \$27 ;
  assign \$29  = \port$1020$0 [2:0] - 1'h1;
  assign \$30  = { 1'h0, \port$1020$0 [2:0] } & \$29 ;
  assign \$31  = ! \$30 ;
  assign \$32  = ~ \$31 ;
  assign \$33  = \port$1020$0 [1] | \port$1020$0 [2];
  assign \$34  = ! words;
  assign \$35  = \port$1020$0 [2] ? 10'h100 : 10'h200;
  assign \$36  = words > \$35 ;
  assign \$37  = \$34  | \$36 ;
  assign \$38  = \$33  & \$37 ;
  assign \$39  = \$32  | \$38 ;
  assign \$40  = running & \o__valid$51 ;
  assign \$41  = \$40  & \o__ready$49 ;
  assign \$42  = \$41  & \o__payload$47 [64];
  assign \$43  = ! \error$608 ;
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
    \error$608  <= \$55 ;
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
    control2 <= \$59 ;
  always @(posedge clk)
    info2 <= info1;
  always @(posedge clk)
    control3 <= \$60 ;
  always @(posedge clk)
    info <= info2;
  always @(posedge clk)
    \$signal$604  <= \$61 ;
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
  assign \$5  = | \port$1020$0 [2:0];
  assign \$6  = ~ busy;
  assign \$7  = \$5  & \$6 ;
  assign \$8  = \port$1020$0 [2:0] - 1'h1;
  assign \$9  = { 1'h0, \port$1020$0 [2:0] } & \$8 ;
  assign \$10  = ! \$9 ;
  assign \$11  = ~ \$10 ;
  assign \$12  = \port$1020$0 [1] | \port$1020$0 [2];
  assign \$13  = ! words;
  assign \$14  = \port$1020$0 [2] ? 10'h100 : 10'h200;
  assign \$15  = words > \$14 ;
  assign \$16  = \$13  | \$15 ;
  assign \$17  = \$12  & \$16 ;
  assign \$18  = \$11  | \$17 ;
  assign finished = control3[0] & control3[2];
  assign \$signal  = i__valid & i__ready;
  assign \$19  = \o__valid$51  & \o__ready$49 ;
  assign last_beat = \$19  & \o__payload$47 [64];
  assign \$20  = \$signal  | \$signal$604 ;
  assign \$21  = ~ ended;
  assign \$signal$603  = \$20  & \$21 ;
  \macram_top.array.decoder  decoder (
    .c_in(c_in),
    .c_out(c_out),
    .clk(clk),
    .error(error),
    .height(height),
    .mode(mode),
    .rst(rst),
    .shape(shape),
    .soft_reset(\port$1020$0 [3]),
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
    .soft_reset(\port$1020$0 [3]),
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
    .soft_reset(\port$1020$0 [3])
  );
  \macram_top.array.frame  frame (
    .clk(clk),
    .error(\error$612 ),
    .fault(fault),
    .i__payload(i__payload),
    .i__ready(i__ready),
    .i__valid(i__valid),
    .o__ready(o__ready),
    .o__valid(\i__valid$33 ),
    .rst(rst),
    .shape(shape),
    .soft_reset(\port$1020$0 [3]),
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
    .\port$1094$63 (shape[76:63]),
    .rst(rst),
    .soft_reset(\port$1020$0 [3])
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
    .soft_reset(\port$1020$0 [3]),
    .start(start),
    .word(activations)
  );
  \macram_top.array.loader  loader (
    .clk(clk),
    .error(\error$613 ),
    .fault(\fault$611 ),
    .i__payload(\i__payload$53 ),
    .i__ready(\busy$16 ),
    .i__valid(\i__valid$57 ),
    .\port$1307$0 (\$70 ),
    .\port$1309$0 (\$71 ),
    .\port$1311$0 (\$72 ),
    .requant_en(write_en),
    .rst(rst),
    .soft_reset(\port$1020$0 [3]),
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
    .soft_reset(\port$1020$0 [3]),
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
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[0])
  );
  \macram_top.array.unit001  unit001 (
    .address(step[23:15]),
    .chain_o(\chain_o$108 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$109 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[1])
  );
  \macram_top.array.unit002  unit002 (
    .address(step[23:15]),
    .chain_o(\chain_o$117 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$118 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[2])
  );
  \macram_top.array.unit003  unit003 (
    .address(step[23:15]),
    .chain_o(\chain_o$126 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$127 ),
    .core__control(control3),
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
    .core__chain_i(\chain_i$135 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[4])
  );
  \macram_top.array.unit005  unit005 (
    .address(step[23:15]),
    .chain_o(\chain_i$109 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$143 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[5])
  );
  \macram_top.array.unit006  unit006 (
    .address(step[23:15]),
    .chain_o(\chain_i$118 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$151 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[6])
  );
  \macram_top.array.unit007  unit007 (
    .address(step[23:15]),
    .chain_o(\chain_i$127 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$159 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[7])
  );
  \macram_top.array.unit008  unit008 (
    .address(step[23:15]),
    .chain_o(\chain_i$135 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$167 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[8])
  );
  \macram_top.array.unit009  unit009 (
    .address(step[23:15]),
    .chain_o(\chain_i$143 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$175 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[9])
  );
  \macram_top.array.unit010  unit010 (
    .address(step[23:15]),
    .chain_o(\chain_i$151 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$183 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[10])
  );
  \macram_top.array.unit011  unit011 (
    .address(step[23:15]),
    .chain_o(\chain_i$159 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$191 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[11])
  );
  \macram_top.array.unit012  unit012 (
    .address(step[23:15]),
    .chain_o(\chain_i$167 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$199 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[12])
  );
  \macram_top.array.unit013  unit013 (
    .address(step[23:15]),
    .chain_o(\chain_i$175 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$207 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[13])
  );
  \macram_top.array.unit014  unit014 (
    .address(step[23:15]),
    .chain_o(\chain_i$183 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$215 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[14])
  );
  \macram_top.array.unit015  unit015 (
    .address(step[23:15]),
    .chain_o(\chain_i$191 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$223 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[15])
  );
  \macram_top.array.unit016  unit016 (
    .address(step[23:15]),
    .chain_o(\chain_i$199 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$231 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[16])
  );
  \macram_top.array.unit017  unit017 (
    .address(step[23:15]),
    .chain_o(\chain_i$207 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$239 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[17])
  );
  \macram_top.array.unit018  unit018 (
    .address(step[23:15]),
    .chain_o(\chain_i$215 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$247 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[18])
  );
  \macram_top.array.unit019  unit019 (
    .address(step[23:15]),
    .chain_o(\chain_i$223 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$255 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[19])
  );
  \macram_top.array.unit020  unit020 (
    .address(step[23:15]),
    .chain_o(\chain_i$231 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$263 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[20])
  );
  \macram_top.array.unit021  unit021 (
    .address(step[23:15]),
    .chain_o(\chain_i$239 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$271 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[21])
  );
  \macram_top.array.unit022  unit022 (
    .address(step[23:15]),
    .chain_o(\chain_i$247 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$279 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[22])
  );
  \macram_top.array.unit023  unit023 (
    .address(step[23:15]),
    .chain_o(\chain_i$255 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$287 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[23])
  );
  \macram_top.array.unit024  unit024 (
    .address(step[23:15]),
    .chain_o(\chain_i$263 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$295 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[24])
  );
  \macram_top.array.unit025  unit025 (
    .address(step[23:15]),
    .chain_o(\chain_i$271 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$303 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[25])
  );
  \macram_top.array.unit026  unit026 (
    .address(step[23:15]),
    .chain_o(\chain_i$279 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$311 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[26])
  );
  \macram_top.array.unit027  unit027 (
    .address(step[23:15]),
    .chain_o(\chain_i$287 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$319 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[27])
  );
  \macram_top.array.unit028  unit028 (
    .address(step[23:15]),
    .chain_o(\chain_i$295 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$327 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[28])
  );
  \macram_top.array.unit029  unit029 (
    .address(step[23:15]),
    .chain_o(\chain_i$303 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$335 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[29])
  );
  \macram_top.array.unit030  unit030 (
    .address(step[23:15]),
    .chain_o(\chain_i$311 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$343 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[30])
  );
  \macram_top.array.unit031  unit031 (
    .address(step[23:15]),
    .chain_o(\chain_i$319 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$351 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[31])
  );
  \macram_top.array.unit032  unit032 (
    .address(step[23:15]),
    .chain_o(\chain_i$327 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$359 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[32])
  );
  \macram_top.array.unit033  unit033 (
    .address(step[23:15]),
    .chain_o(\chain_i$335 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$367 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[33])
  );
  \macram_top.array.unit034  unit034 (
    .address(step[23:15]),
    .chain_o(\chain_i$343 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$375 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[34])
  );
  \macram_top.array.unit035  unit035 (
    .address(step[23:15]),
    .chain_o(\chain_i$351 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$383 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[35])
  );
  \macram_top.array.unit036  unit036 (
    .address(step[23:15]),
    .chain_o(\chain_i$359 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$391 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[36])
  );
  \macram_top.array.unit037  unit037 (
    .address(step[23:15]),
    .chain_o(\chain_i$367 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$399 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[37])
  );
  \macram_top.array.unit038  unit038 (
    .address(step[23:15]),
    .chain_o(\chain_i$375 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$407 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[38])
  );
  \macram_top.array.unit039  unit039 (
    .address(step[23:15]),
    .chain_o(\chain_i$383 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$415 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[39])
  );
  \macram_top.array.unit040  unit040 (
    .address(step[23:15]),
    .chain_o(\chain_i$391 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$423 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[40])
  );
  \macram_top.array.unit041  unit041 (
    .address(step[23:15]),
    .chain_o(\chain_i$399 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$431 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[41])
  );
  \macram_top.array.unit042  unit042 (
    .address(step[23:15]),
    .chain_o(\chain_i$407 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$439 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[42])
  );
  \macram_top.array.unit043  unit043 (
    .address(step[23:15]),
    .chain_o(\chain_i$415 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$447 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[43])
  );
  \macram_top.array.unit044  unit044 (
    .address(step[23:15]),
    .chain_o(\chain_i$423 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$455 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[44])
  );
  \macram_top.array.unit045  unit045 (
    .address(step[23:15]),
    .chain_o(\chain_i$431 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$463 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[45])
  );
  \macram_top.array.unit046  unit046 (
    .address(step[23:15]),
    .chain_o(\chain_i$439 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$471 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[46])
  );
  \macram_top.array.unit047  unit047 (
    .address(step[23:15]),
    .chain_o(\chain_i$447 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$479 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[47])
  );
  \macram_top.array.unit048  unit048 (
    .address(step[23:15]),
    .chain_o(\chain_i$455 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$487 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[48])
  );
  \macram_top.array.unit049  unit049 (
    .address(step[23:15]),
    .chain_o(\chain_i$463 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$495 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[49])
  );
  \macram_top.array.unit050  unit050 (
    .address(step[23:15]),
    .chain_o(\chain_i$471 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$503 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[50])
  );
  \macram_top.array.unit051  unit051 (
    .address(step[23:15]),
    .chain_o(\chain_i$479 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$511 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[51])
  );
  \macram_top.array.unit052  unit052 (
    .address(step[23:15]),
    .chain_o(\chain_i$487 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$519 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[52])
  );
  \macram_top.array.unit053  unit053 (
    .address(step[23:15]),
    .chain_o(\chain_i$495 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$527 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[53])
  );
  \macram_top.array.unit054  unit054 (
    .address(step[23:15]),
    .chain_o(\chain_i$503 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$535 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[54])
  );
  \macram_top.array.unit055  unit055 (
    .address(step[23:15]),
    .chain_o(\chain_i$511 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$543 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[55])
  );
  \macram_top.array.unit056  unit056 (
    .address(step[23:15]),
    .chain_o(\chain_i$519 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$551 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[56])
  );
  \macram_top.array.unit057  unit057 (
    .address(step[23:15]),
    .chain_o(\chain_i$527 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$559 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[57])
  );
  \macram_top.array.unit058  unit058 (
    .address(step[23:15]),
    .chain_o(\chain_i$535 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$567 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[58])
  );
  \macram_top.array.unit059  unit059 (
    .address(step[23:15]),
    .chain_o(\chain_i$543 ),
    .clk(clk),
    .core__activations(activations),
    .core__chain_i(\chain_i$575 ),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[59])
  );
  \macram_top.array.unit060  unit060 (
    .address(step[23:15]),
    .chain_o(\chain_i$551 ),
    .clk(clk),
    .core__activations(activations),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[60])
  );
  \macram_top.array.unit061  unit061 (
    .address(step[23:15]),
    .chain_o(\chain_i$559 ),
    .clk(clk),
    .core__activations(activations),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[61])
  );
  \macram_top.array.unit062  unit062 (
    .address(step[23:15]),
    .chain_o(\chain_i$567 ),
    .clk(clk),
    .core__activations(activations),
    .core__control(control3),
    .core__shift(shift),
    .rst(rst),
    .write__addr(\$70 ),
    .write__data(\$72 [519:448]),
    .write__en(unit_en[62])
  );
  \macram_top.array.unit063  unit063 (
    .address(step[23:15]),
    .chain_o(\chain_i$575 ),
    .clk(clk),
    .core__activations(activations),
    .core__control(control3),
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
      end else if (\port$1020$0 [0]) begin
      end else begin
        start_weights = \port$1020$0 [1];
      end
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    start_requant = 1'h0;
    if (\$7 ) begin
      (* full_case = 32'd1 *)
      if (\$18 ) begin
      end else if (\port$1020$0 [0]) begin
      end else begin
        start_requant = \port$1020$0 [2];
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
      end else if (\port$1020$0 [0]) begin
        \$53  = 2'h2;
      end
    end
    if (\port$1020$0 [3]) begin
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
    if (\port$1020$0 [3]) begin
      \$54  = 1'h0;
    end
    if (rst) begin
      \$54  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$55  = \error$608 ;
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
        \$55  = \error$612 ;
      end else if (\fault$611 ) begin
        \$55  = \error$613 ;
      end
    end
    if (\port$1020$0 [3]) begin
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
    if (\port$1020$0 [3]) begin
      \$56  = 1'h0;
    end
    if (rst) begin
      \$56  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$57  = step[31:24];
    if (\port$1020$0 [3]) begin
      \$57  = 8'h00;
    end
    if (rst) begin
      \$57  = 8'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$58  = control0;
    if (\port$1020$0 [3]) begin
      \$58  = 8'h00;
    end
    if (rst) begin
      \$58  = 8'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$59  = control1;
    if (\port$1020$0 [3]) begin
      \$59  = 8'h00;
    end
    if (rst) begin
      \$59  = 8'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$60  = control2;
    if (\port$1020$0 [3]) begin
      \$60  = 8'h00;
    end
    if (rst) begin
      \$60  = 8'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$61  = \$signal$604 ;
    if (\$signal ) begin
      \$61  = 1'h1;
    end
    if (start) begin
      \$61  = 1'h0;
    end
    if (\port$1020$0 [3]) begin
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
    if (\port$1020$0 [3]) begin
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
    if (\port$1020$0 [3]) begin
      \$63  = 1'h0;
    end
    if (rst) begin
      \$63  = 1'h0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$64  = cycles;
    if (\$signal$603 ) begin
      \$64  = \$44 [31:0];
    end
    if (start) begin
      \$64  = 32'd0;
    end
    if (\port$1020$0 [3]) begin
      \$64  = 32'd0;
    end
    if (rst) begin
      \$64  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$65  = mac_cycles;
    if (\$signal$603 ) begin
      if (issue) begin
        \$65  = \$48 [31:0];
      end
    end
    if (start) begin
      \$65  = 32'd0;
    end
    if (\port$1020$0 [3]) begin
      \$65  = 32'd0;
    end
    if (rst) begin
      \$65  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$66  = fill_cycles;
    if (\$signal$603 ) begin
      if (issue) begin
      end else if (\$45 ) begin
        \$66  = \$49 [31:0];
      end
    end
    if (start) begin
      \$66  = 32'd0;
    end
    if (\port$1020$0 [3]) begin
      \$66  = 32'd0;
    end
    if (rst) begin
      \$66  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$67  = input_stalls;
    if (\$signal$603 ) begin
      if (issue) begin
      end else if (\$45 ) begin
      end else if (starved) begin
        \$67  = \$50 [31:0];
      end
    end
    if (start) begin
      \$67  = 32'd0;
    end
    if (\port$1020$0 [3]) begin
      \$67  = 32'd0;
    end
    if (rst) begin
      \$67  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$68  = output_stalls;
    if (\$signal$603 ) begin
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
    if (\port$1020$0 [3]) begin
      \$68  = 32'd0;
    end
    if (rst) begin
      \$68  = 32'd0;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$69  = drain_cycles;
    if (\$signal$603 ) begin
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
    if (\port$1020$0 [3]) begin
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
  assign command = \port$1020$0 [2:0];
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
  assign control = control3;
  assign \shift$97  = shift;
  assign \chain_o$101  = chain_i;
  assign \address$102  = step[23:15];
  assign \write_en$103  = unit_en[1];
  assign \write$104  = { \$72 [519:448], \$70  };
  assign \activations$105  = activations;
  assign \control$106  = control3;
  assign \shift$107  = shift;
  assign \chain_o$110  = \chain_i$109 ;
  assign \address$111  = step[23:15];
  assign \write_en$112  = unit_en[2];
  assign \write$113  = { \$72 [519:448], \$70  };
  assign \activations$114  = activations;
  assign \control$115  = control3;
  assign \shift$116  = shift;
  assign \chain_o$119  = \chain_i$118 ;
  assign \address$120  = step[23:15];
  assign \write_en$121  = unit_en[3];
  assign \write$122  = { \$72 [519:448], \$70  };
  assign \activations$123  = activations;
  assign \control$124  = control3;
  assign \shift$125  = shift;
  assign \chain_o$128  = \chain_i$127 ;
  assign \address$129  = step[23:15];
  assign \write_en$130  = unit_en[4];
  assign \write$131  = { \$72 [519:448], \$70  };
  assign \activations$132  = activations;
  assign \control$133  = control3;
  assign \shift$134  = shift;
  assign \chain_o$136  = \chain_i$135 ;
  assign \address$137  = step[23:15];
  assign \write_en$138  = unit_en[5];
  assign \write$139  = { \$72 [519:448], \$70  };
  assign \activations$140  = activations;
  assign \control$141  = control3;
  assign \shift$142  = shift;
  assign \chain_o$144  = \chain_i$143 ;
  assign \address$145  = step[23:15];
  assign \write_en$146  = unit_en[6];
  assign \write$147  = { \$72 [519:448], \$70  };
  assign \activations$148  = activations;
  assign \control$149  = control3;
  assign \shift$150  = shift;
  assign \chain_o$152  = \chain_i$151 ;
  assign \address$153  = step[23:15];
  assign \write_en$154  = unit_en[7];
  assign \write$155  = { \$72 [519:448], \$70  };
  assign \activations$156  = activations;
  assign \control$157  = control3;
  assign \shift$158  = shift;
  assign \chain_o$160  = \chain_i$159 ;
  assign \address$161  = step[23:15];
  assign \write_en$162  = unit_en[8];
  assign \write$163  = { \$72 [519:448], \$70  };
  assign \activations$164  = activations;
  assign \control$165  = control3;
  assign \shift$166  = shift;
  assign \chain_o$168  = \chain_i$167 ;
  assign \address$169  = step[23:15];
  assign \write_en$170  = unit_en[9];
  assign \write$171  = { \$72 [519:448], \$70  };
  assign \activations$172  = activations;
  assign \control$173  = control3;
  assign \shift$174  = shift;
  assign \chain_o$176  = \chain_i$175 ;
  assign \address$177  = step[23:15];
  assign \write_en$178  = unit_en[10];
  assign \write$179  = { \$72 [519:448], \$70  };
  assign \activations$180  = activations;
  assign \control$181  = control3;
  assign \shift$182  = shift;
  assign \chain_o$184  = \chain_i$183 ;
  assign \address$185  = step[23:15];
  assign \write_en$186  = unit_en[11];
  assign \write$187  = { \$72 [519:448], \$70  };
  assign \activations$188  = activations;
  assign \control$189  = control3;
  assign \shift$190  = shift;
  assign \chain_o$192  = \chain_i$191 ;
  assign \address$193  = step[23:15];
  assign \write_en$194  = unit_en[12];
  assign \write$195  = { \$72 [519:448], \$70  };
  assign \activations$196  = activations;
  assign \control$197  = control3;
  assign \shift$198  = shift;
  assign \chain_o$200  = \chain_i$199 ;
  assign \address$201  = step[23:15];
  assign \write_en$202  = unit_en[13];
  assign \write$203  = { \$72 [519:448], \$70  };
  assign \activations$204  = activations;
  assign \control$205  = control3;
  assign \shift$206  = shift;
  assign \chain_o$208  = \chain_i$207 ;
  assign \address$209  = step[23:15];
  assign \write_en$210  = unit_en[14];
  assign \write$211  = { \$72 [519:448], \$70  };
  assign \activations$212  = activations;
  assign \control$213  = control3;
  assign \shift$214  = shift;
  assign \chain_o$216  = \chain_i$215 ;
  assign \address$217  = step[23:15];
  assign \write_en$218  = unit_en[15];
  assign \write$219  = { \$72 [519:448], \$70  };
  assign \activations$220  = activations;
  assign \control$221  = control3;
  assign \shift$222  = shift;
  assign \chain_o$224  = \chain_i$223 ;
  assign \address$225  = step[23:15];
  assign \write_en$226  = unit_en[16];
  assign \write$227  = { \$72 [519:448], \$70  };
  assign \activations$228  = activations;
  assign \control$229  = control3;
  assign \shift$230  = shift;
  assign \chain_o$232  = \chain_i$231 ;
  assign \address$233  = step[23:15];
  assign \write_en$234  = unit_en[17];
  assign \write$235  = { \$72 [519:448], \$70  };
  assign \activations$236  = activations;
  assign \control$237  = control3;
  assign \shift$238  = shift;
  assign \chain_o$240  = \chain_i$239 ;
  assign \address$241  = step[23:15];
  assign \write_en$242  = unit_en[18];
  assign \write$243  = { \$72 [519:448], \$70  };
  assign \activations$244  = activations;
  assign \control$245  = control3;
  assign \shift$246  = shift;
  assign \chain_o$248  = \chain_i$247 ;
  assign \address$249  = step[23:15];
  assign \write_en$250  = unit_en[19];
  assign \write$251  = { \$72 [519:448], \$70  };
  assign \activations$252  = activations;
  assign \control$253  = control3;
  assign \shift$254  = shift;
  assign \chain_o$256  = \chain_i$255 ;
  assign \address$257  = step[23:15];
  assign \write_en$258  = unit_en[20];
  assign \write$259  = { \$72 [519:448], \$70  };
  assign \activations$260  = activations;
  assign \control$261  = control3;
  assign \shift$262  = shift;
  assign \chain_o$264  = \chain_i$263 ;
  assign \address$265  = step[23:15];
  assign \write_en$266  = unit_en[21];
  assign \write$267  = { \$72 [519:448], \$70  };
  assign \activations$268  = activations;
  assign \control$269  = control3;
  assign \shift$270  = shift;
  assign \chain_o$272  = \chain_i$271 ;
  assign \address$273  = step[23:15];
  assign \write_en$274  = unit_en[22];
  assign \write$275  = { \$72 [519:448], \$70  };
  assign \activations$276  = activations;
  assign \control$277  = control3;
  assign \shift$278  = shift;
  assign \chain_o$280  = \chain_i$279 ;
  assign \address$281  = step[23:15];
  assign \write_en$282  = unit_en[23];
  assign \write$283  = { \$72 [519:448], \$70  };
  assign \activations$284  = activations;
  assign \control$285  = control3;
  assign \shift$286  = shift;
  assign \chain_o$288  = \chain_i$287 ;
  assign \address$289  = step[23:15];
  assign \write_en$290  = unit_en[24];
  assign \write$291  = { \$72 [519:448], \$70  };
  assign \activations$292  = activations;
  assign \control$293  = control3;
  assign \shift$294  = shift;
  assign \chain_o$296  = \chain_i$295 ;
  assign \address$297  = step[23:15];
  assign \write_en$298  = unit_en[25];
  assign \write$299  = { \$72 [519:448], \$70  };
  assign \activations$300  = activations;
  assign \control$301  = control3;
  assign \shift$302  = shift;
  assign \chain_o$304  = \chain_i$303 ;
  assign \address$305  = step[23:15];
  assign \write_en$306  = unit_en[26];
  assign \write$307  = { \$72 [519:448], \$70  };
  assign \activations$308  = activations;
  assign \control$309  = control3;
  assign \shift$310  = shift;
  assign \chain_o$312  = \chain_i$311 ;
  assign \address$313  = step[23:15];
  assign \write_en$314  = unit_en[27];
  assign \write$315  = { \$72 [519:448], \$70  };
  assign \activations$316  = activations;
  assign \control$317  = control3;
  assign \shift$318  = shift;
  assign \chain_o$320  = \chain_i$319 ;
  assign \address$321  = step[23:15];
  assign \write_en$322  = unit_en[28];
  assign \write$323  = { \$72 [519:448], \$70  };
  assign \activations$324  = activations;
  assign \control$325  = control3;
  assign \shift$326  = shift;
  assign \chain_o$328  = \chain_i$327 ;
  assign \address$329  = step[23:15];
  assign \write_en$330  = unit_en[29];
  assign \write$331  = { \$72 [519:448], \$70  };
  assign \activations$332  = activations;
  assign \control$333  = control3;
  assign \shift$334  = shift;
  assign \chain_o$336  = \chain_i$335 ;
  assign \address$337  = step[23:15];
  assign \write_en$338  = unit_en[30];
  assign \write$339  = { \$72 [519:448], \$70  };
  assign \activations$340  = activations;
  assign \control$341  = control3;
  assign \shift$342  = shift;
  assign \chain_o$344  = \chain_i$343 ;
  assign \address$345  = step[23:15];
  assign \write_en$346  = unit_en[31];
  assign \write$347  = { \$72 [519:448], \$70  };
  assign \activations$348  = activations;
  assign \control$349  = control3;
  assign \shift$350  = shift;
  assign \chain_o$352  = \chain_i$351 ;
  assign \address$353  = step[23:15];
  assign \write_en$354  = unit_en[32];
  assign \write$355  = { \$72 [519:448], \$70  };
  assign \activations$356  = activations;
  assign \control$357  = control3;
  assign \shift$358  = shift;
  assign \chain_o$360  = \chain_i$359 ;
  assign \address$361  = step[23:15];
  assign \write_en$362  = unit_en[33];
  assign \write$363  = { \$72 [519:448], \$70  };
  assign \activations$364  = activations;
  assign \control$365  = control3;
  assign \shift$366  = shift;
  assign \chain_o$368  = \chain_i$367 ;
  assign \address$369  = step[23:15];
  assign \write_en$370  = unit_en[34];
  assign \write$371  = { \$72 [519:448], \$70  };
  assign \activations$372  = activations;
  assign \control$373  = control3;
  assign \shift$374  = shift;
  assign \chain_o$376  = \chain_i$375 ;
  assign \address$377  = step[23:15];
  assign \write_en$378  = unit_en[35];
  assign \write$379  = { \$72 [519:448], \$70  };
  assign \activations$380  = activations;
  assign \control$381  = control3;
  assign \shift$382  = shift;
  assign \chain_o$384  = \chain_i$383 ;
  assign \address$385  = step[23:15];
  assign \write_en$386  = unit_en[36];
  assign \write$387  = { \$72 [519:448], \$70  };
  assign \activations$388  = activations;
  assign \control$389  = control3;
  assign \shift$390  = shift;
  assign \chain_o$392  = \chain_i$391 ;
  assign \address$393  = step[23:15];
  assign \write_en$394  = unit_en[37];
  assign \write$395  = { \$72 [519:448], \$70  };
  assign \activations$396  = activations;
  assign \control$397  = control3;
  assign \shift$398  = shift;
  assign \chain_o$400  = \chain_i$399 ;
  assign \address$401  = step[23:15];
  assign \write_en$402  = unit_en[38];
  assign \write$403  = { \$72 [519:448], \$70  };
  assign \activations$404  = activations;
  assign \control$405  = control3;
  assign \shift$406  = shift;
  assign \chain_o$408  = \chain_i$407 ;
  assign \address$409  = step[23:15];
  assign \write_en$410  = unit_en[39];
  assign \write$411  = { \$72 [519:448], \$70  };
  assign \activations$412  = activations;
  assign \control$413  = control3;
  assign \shift$414  = shift;
  assign \chain_o$416  = \chain_i$415 ;
  assign \address$417  = step[23:15];
  assign \write_en$418  = unit_en[40];
  assign \write$419  = { \$72 [519:448], \$70  };
  assign \activations$420  = activations;
  assign \control$421  = control3;
  assign \shift$422  = shift;
  assign \chain_o$424  = \chain_i$423 ;
  assign \address$425  = step[23:15];
  assign \write_en$426  = unit_en[41];
  assign \write$427  = { \$72 [519:448], \$70  };
  assign \activations$428  = activations;
  assign \control$429  = control3;
  assign \shift$430  = shift;
  assign \chain_o$432  = \chain_i$431 ;
  assign \address$433  = step[23:15];
  assign \write_en$434  = unit_en[42];
  assign \write$435  = { \$72 [519:448], \$70  };
  assign \activations$436  = activations;
  assign \control$437  = control3;
  assign \shift$438  = shift;
  assign \chain_o$440  = \chain_i$439 ;
  assign \address$441  = step[23:15];
  assign \write_en$442  = unit_en[43];
  assign \write$443  = { \$72 [519:448], \$70  };
  assign \activations$444  = activations;
  assign \control$445  = control3;
  assign \shift$446  = shift;
  assign \chain_o$448  = \chain_i$447 ;
  assign \address$449  = step[23:15];
  assign \write_en$450  = unit_en[44];
  assign \write$451  = { \$72 [519:448], \$70  };
  assign \activations$452  = activations;
  assign \control$453  = control3;
  assign \shift$454  = shift;
  assign \chain_o$456  = \chain_i$455 ;
  assign \address$457  = step[23:15];
  assign \write_en$458  = unit_en[45];
  assign \write$459  = { \$72 [519:448], \$70  };
  assign \activations$460  = activations;
  assign \control$461  = control3;
  assign \shift$462  = shift;
  assign \chain_o$464  = \chain_i$463 ;
  assign \address$465  = step[23:15];
  assign \write_en$466  = unit_en[46];
  assign \write$467  = { \$72 [519:448], \$70  };
  assign \activations$468  = activations;
  assign \control$469  = control3;
  assign \shift$470  = shift;
  assign \chain_o$472  = \chain_i$471 ;
  assign \address$473  = step[23:15];
  assign \write_en$474  = unit_en[47];
  assign \write$475  = { \$72 [519:448], \$70  };
  assign \activations$476  = activations;
  assign \control$477  = control3;
  assign \shift$478  = shift;
  assign \chain_o$480  = \chain_i$479 ;
  assign \address$481  = step[23:15];
  assign \write_en$482  = unit_en[48];
  assign \write$483  = { \$72 [519:448], \$70  };
  assign \activations$484  = activations;
  assign \control$485  = control3;
  assign \shift$486  = shift;
  assign \chain_o$488  = \chain_i$487 ;
  assign \address$489  = step[23:15];
  assign \write_en$490  = unit_en[49];
  assign \write$491  = { \$72 [519:448], \$70  };
  assign \activations$492  = activations;
  assign \control$493  = control3;
  assign \shift$494  = shift;
  assign \chain_o$496  = \chain_i$495 ;
  assign \address$497  = step[23:15];
  assign \write_en$498  = unit_en[50];
  assign \write$499  = { \$72 [519:448], \$70  };
  assign \activations$500  = activations;
  assign \control$501  = control3;
  assign \shift$502  = shift;
  assign \chain_o$504  = \chain_i$503 ;
  assign \address$505  = step[23:15];
  assign \write_en$506  = unit_en[51];
  assign \write$507  = { \$72 [519:448], \$70  };
  assign \activations$508  = activations;
  assign \control$509  = control3;
  assign \shift$510  = shift;
  assign \chain_o$512  = \chain_i$511 ;
  assign \address$513  = step[23:15];
  assign \write_en$514  = unit_en[52];
  assign \write$515  = { \$72 [519:448], \$70  };
  assign \activations$516  = activations;
  assign \control$517  = control3;
  assign \shift$518  = shift;
  assign \chain_o$520  = \chain_i$519 ;
  assign \address$521  = step[23:15];
  assign \write_en$522  = unit_en[53];
  assign \write$523  = { \$72 [519:448], \$70  };
  assign \activations$524  = activations;
  assign \control$525  = control3;
  assign \shift$526  = shift;
  assign \chain_o$528  = \chain_i$527 ;
  assign \address$529  = step[23:15];
  assign \write_en$530  = unit_en[54];
  assign \write$531  = { \$72 [519:448], \$70  };
  assign \activations$532  = activations;
  assign \control$533  = control3;
  assign \shift$534  = shift;
  assign \chain_o$536  = \chain_i$535 ;
  assign \address$537  = step[23:15];
  assign \write_en$538  = unit_en[55];
  assign \write$539  = { \$72 [519:448], \$70  };
  assign \activations$540  = activations;
  assign \control$541  = control3;
  assign \shift$542  = shift;
  assign \chain_o$544  = \chain_i$543 ;
  assign \address$545  = step[23:15];
  assign \write_en$546  = unit_en[56];
  assign \write$547  = { \$72 [519:448], \$70  };
  assign \activations$548  = activations;
  assign \control$549  = control3;
  assign \shift$550  = shift;
  assign \chain_o$552  = \chain_i$551 ;
  assign \address$553  = step[23:15];
  assign \write_en$554  = unit_en[57];
  assign \write$555  = { \$72 [519:448], \$70  };
  assign \activations$556  = activations;
  assign \control$557  = control3;
  assign \shift$558  = shift;
  assign \chain_o$560  = \chain_i$559 ;
  assign \address$561  = step[23:15];
  assign \write_en$562  = unit_en[58];
  assign \write$563  = { \$72 [519:448], \$70  };
  assign \activations$564  = activations;
  assign \control$565  = control3;
  assign \shift$566  = shift;
  assign \chain_o$568  = \chain_i$567 ;
  assign \address$569  = step[23:15];
  assign \write_en$570  = unit_en[59];
  assign \write$571  = { \$72 [519:448], \$70  };
  assign \activations$572  = activations;
  assign \control$573  = control3;
  assign \shift$574  = shift;
  assign \chain_o$576  = \chain_i$575 ;
  assign \address$577  = step[23:15];
  assign \write_en$578  = unit_en[60];
  assign \write$579  = { \$72 [519:448], \$70  };
  assign \activations$580  = activations;
  assign \control$581  = control3;
  assign \shift$582  = shift;
  assign \address$583  = step[23:15];
  assign \write_en$584  = unit_en[61];
  assign \write$585  = { \$72 [519:448], \$70  };
  assign \activations$586  = activations;
  assign \control$587  = control3;
  assign \shift$588  = shift;
  assign \address$589  = step[23:15];
  assign \write_en$590  = unit_en[62];
  assign \write$591  = { \$72 [519:448], \$70  };
  assign \activations$592  = activations;
  assign \control$593  = control3;
  assign \shift$594  = shift;
  assign \address$595  = step[23:15];
  assign \write_en$596  = unit_en[63];
  assign \write$597  = { \$72 [519:448], \$70  };
  assign \activations$598  = activations;
  assign \control$599  = control3;
  assign \shift$600  = shift;
  assign soft_reset = \port$1020$0 [3];
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
  assign \chain_o$101[0]  = chain_i[18:0];
  assign \chain_o$101[1]  = chain_i[37:19];
  assign \chain_o$101[2]  = chain_i[56:38];
  assign \chain_o$101[3]  = chain_i[75:57];
  assign \write$104.addr  = \$70 ;
  assign \write$104.data  = \$72 [519:448];
  assign \control$106.en  = control3[0];
  assign \control$106.first  = control3[1];
  assign \control$106.last  = control3[2];
  assign \control$106.edge  = control3[3];
  assign \control$106.tile  = control3[7:4];
  assign \chain_o$108[0]  = \chain_o$108 [18:0];
  assign \chain_o$108[1]  = \chain_o$108 [37:19];
  assign \chain_o$108[2]  = \chain_o$108 [56:38];
  assign \chain_o$108[3]  = \chain_o$108 [75:57];
  assign \chain_i$109[0]  = \chain_i$109 [18:0];
  assign \chain_i$109[1]  = \chain_i$109 [37:19];
  assign \chain_i$109[2]  = \chain_i$109 [56:38];
  assign \chain_i$109[3]  = \chain_i$109 [75:57];
  assign \chain_o$110[0]  = \chain_i$109 [18:0];
  assign \chain_o$110[1]  = \chain_i$109 [37:19];
  assign \chain_o$110[2]  = \chain_i$109 [56:38];
  assign \chain_o$110[3]  = \chain_i$109 [75:57];
  assign \write$113.addr  = \$70 ;
  assign \write$113.data  = \$72 [519:448];
  assign \control$115.en  = control3[0];
  assign \control$115.first  = control3[1];
  assign \control$115.last  = control3[2];
  assign \control$115.edge  = control3[3];
  assign \control$115.tile  = control3[7:4];
  assign \chain_o$117[0]  = \chain_o$117 [18:0];
  assign \chain_o$117[1]  = \chain_o$117 [37:19];
  assign \chain_o$117[2]  = \chain_o$117 [56:38];
  assign \chain_o$117[3]  = \chain_o$117 [75:57];
  assign \chain_i$118[0]  = \chain_i$118 [18:0];
  assign \chain_i$118[1]  = \chain_i$118 [37:19];
  assign \chain_i$118[2]  = \chain_i$118 [56:38];
  assign \chain_i$118[3]  = \chain_i$118 [75:57];
  assign \chain_o$119[0]  = \chain_i$118 [18:0];
  assign \chain_o$119[1]  = \chain_i$118 [37:19];
  assign \chain_o$119[2]  = \chain_i$118 [56:38];
  assign \chain_o$119[3]  = \chain_i$118 [75:57];
  assign \write$122.addr  = \$70 ;
  assign \write$122.data  = \$72 [519:448];
  assign \control$124.en  = control3[0];
  assign \control$124.first  = control3[1];
  assign \control$124.last  = control3[2];
  assign \control$124.edge  = control3[3];
  assign \control$124.tile  = control3[7:4];
  assign \chain_o$126[0]  = \chain_o$126 [18:0];
  assign \chain_o$126[1]  = \chain_o$126 [37:19];
  assign \chain_o$126[2]  = \chain_o$126 [56:38];
  assign \chain_o$126[3]  = \chain_o$126 [75:57];
  assign \chain_i$127[0]  = \chain_i$127 [18:0];
  assign \chain_i$127[1]  = \chain_i$127 [37:19];
  assign \chain_i$127[2]  = \chain_i$127 [56:38];
  assign \chain_i$127[3]  = \chain_i$127 [75:57];
  assign \chain_o$128[0]  = \chain_i$127 [18:0];
  assign \chain_o$128[1]  = \chain_i$127 [37:19];
  assign \chain_o$128[2]  = \chain_i$127 [56:38];
  assign \chain_o$128[3]  = \chain_i$127 [75:57];
  assign \write$131.addr  = \$70 ;
  assign \write$131.data  = \$72 [519:448];
  assign \control$133.en  = control3[0];
  assign \control$133.first  = control3[1];
  assign \control$133.last  = control3[2];
  assign \control$133.edge  = control3[3];
  assign \control$133.tile  = control3[7:4];
  assign \chain_i$135[0]  = \chain_i$135 [18:0];
  assign \chain_i$135[1]  = \chain_i$135 [37:19];
  assign \chain_i$135[2]  = \chain_i$135 [56:38];
  assign \chain_i$135[3]  = \chain_i$135 [75:57];
  assign \chain_o$136[0]  = \chain_i$135 [18:0];
  assign \chain_o$136[1]  = \chain_i$135 [37:19];
  assign \chain_o$136[2]  = \chain_i$135 [56:38];
  assign \chain_o$136[3]  = \chain_i$135 [75:57];
  assign \write$139.addr  = \$70 ;
  assign \write$139.data  = \$72 [519:448];
  assign \control$141.en  = control3[0];
  assign \control$141.first  = control3[1];
  assign \control$141.last  = control3[2];
  assign \control$141.edge  = control3[3];
  assign \control$141.tile  = control3[7:4];
  assign \chain_i$143[0]  = \chain_i$143 [18:0];
  assign \chain_i$143[1]  = \chain_i$143 [37:19];
  assign \chain_i$143[2]  = \chain_i$143 [56:38];
  assign \chain_i$143[3]  = \chain_i$143 [75:57];
  assign \chain_o$144[0]  = \chain_i$143 [18:0];
  assign \chain_o$144[1]  = \chain_i$143 [37:19];
  assign \chain_o$144[2]  = \chain_i$143 [56:38];
  assign \chain_o$144[3]  = \chain_i$143 [75:57];
  assign \write$147.addr  = \$70 ;
  assign \write$147.data  = \$72 [519:448];
  assign \control$149.en  = control3[0];
  assign \control$149.first  = control3[1];
  assign \control$149.last  = control3[2];
  assign \control$149.edge  = control3[3];
  assign \control$149.tile  = control3[7:4];
  assign \chain_i$151[0]  = \chain_i$151 [18:0];
  assign \chain_i$151[1]  = \chain_i$151 [37:19];
  assign \chain_i$151[2]  = \chain_i$151 [56:38];
  assign \chain_i$151[3]  = \chain_i$151 [75:57];
  assign \chain_o$152[0]  = \chain_i$151 [18:0];
  assign \chain_o$152[1]  = \chain_i$151 [37:19];
  assign \chain_o$152[2]  = \chain_i$151 [56:38];
  assign \chain_o$152[3]  = \chain_i$151 [75:57];
  assign \write$155.addr  = \$70 ;
  assign \write$155.data  = \$72 [519:448];
  assign \control$157.en  = control3[0];
  assign \control$157.first  = control3[1];
  assign \control$157.last  = control3[2];
  assign \control$157.edge  = control3[3];
  assign \control$157.tile  = control3[7:4];
  assign \chain_i$159[0]  = \chain_i$159 [18:0];
  assign \chain_i$159[1]  = \chain_i$159 [37:19];
  assign \chain_i$159[2]  = \chain_i$159 [56:38];
  assign \chain_i$159[3]  = \chain_i$159 [75:57];
  assign \chain_o$160[0]  = \chain_i$159 [18:0];
  assign \chain_o$160[1]  = \chain_i$159 [37:19];
  assign \chain_o$160[2]  = \chain_i$159 [56:38];
  assign \chain_o$160[3]  = \chain_i$159 [75:57];
  assign \write$163.addr  = \$70 ;
  assign \write$163.data  = \$72 [519:448];
  assign \control$165.en  = control3[0];
  assign \control$165.first  = control3[1];
  assign \control$165.last  = control3[2];
  assign \control$165.edge  = control3[3];
  assign \control$165.tile  = control3[7:4];
  assign \chain_i$167[0]  = \chain_i$167 [18:0];
  assign \chain_i$167[1]  = \chain_i$167 [37:19];
  assign \chain_i$167[2]  = \chain_i$167 [56:38];
  assign \chain_i$167[3]  = \chain_i$167 [75:57];
  assign \chain_o$168[0]  = \chain_i$167 [18:0];
  assign \chain_o$168[1]  = \chain_i$167 [37:19];
  assign \chain_o$168[2]  = \chain_i$167 [56:38];
  assign \chain_o$168[3]  = \chain_i$167 [75:57];
  assign \write$171.addr  = \$70 ;
  assign \write$171.data  = \$72 [519:448];
  assign \control$173.en  = control3[0];
  assign \control$173.first  = control3[1];
  assign \control$173.last  = control3[2];
  assign \control$173.edge  = control3[3];
  assign \control$173.tile  = control3[7:4];
  assign \chain_i$175[0]  = \chain_i$175 [18:0];
  assign \chain_i$175[1]  = \chain_i$175 [37:19];
  assign \chain_i$175[2]  = \chain_i$175 [56:38];
  assign \chain_i$175[3]  = \chain_i$175 [75:57];
  assign \chain_o$176[0]  = \chain_i$175 [18:0];
  assign \chain_o$176[1]  = \chain_i$175 [37:19];
  assign \chain_o$176[2]  = \chain_i$175 [56:38];
  assign \chain_o$176[3]  = \chain_i$175 [75:57];
  assign \write$179.addr  = \$70 ;
  assign \write$179.data  = \$72 [519:448];
  assign \control$181.en  = control3[0];
  assign \control$181.first  = control3[1];
  assign \control$181.last  = control3[2];
  assign \control$181.edge  = control3[3];
  assign \control$181.tile  = control3[7:4];
  assign \chain_i$183[0]  = \chain_i$183 [18:0];
  assign \chain_i$183[1]  = \chain_i$183 [37:19];
  assign \chain_i$183[2]  = \chain_i$183 [56:38];
  assign \chain_i$183[3]  = \chain_i$183 [75:57];
  assign \chain_o$184[0]  = \chain_i$183 [18:0];
  assign \chain_o$184[1]  = \chain_i$183 [37:19];
  assign \chain_o$184[2]  = \chain_i$183 [56:38];
  assign \chain_o$184[3]  = \chain_i$183 [75:57];
  assign \write$187.addr  = \$70 ;
  assign \write$187.data  = \$72 [519:448];
  assign \control$189.en  = control3[0];
  assign \control$189.first  = control3[1];
  assign \control$189.last  = control3[2];
  assign \control$189.edge  = control3[3];
  assign \control$189.tile  = control3[7:4];
  assign \chain_i$191[0]  = \chain_i$191 [18:0];
  assign \chain_i$191[1]  = \chain_i$191 [37:19];
  assign \chain_i$191[2]  = \chain_i$191 [56:38];
  assign \chain_i$191[3]  = \chain_i$191 [75:57];
  assign \chain_o$192[0]  = \chain_i$191 [18:0];
  assign \chain_o$192[1]  = \chain_i$191 [37:19];
  assign \chain_o$192[2]  = \chain_i$191 [56:38];
  assign \chain_o$192[3]  = \chain_i$191 [75:57];
  assign \write$195.addr  = \$70 ;
  assign \write$195.data  = \$72 [519:448];
  assign \control$197.en  = control3[0];
  assign \control$197.first  = control3[1];
  assign \control$197.last  = control3[2];
  assign \control$197.edge  = control3[3];
  assign \control$197.tile  = control3[7:4];
  assign \chain_i$199[0]  = \chain_i$199 [18:0];
  assign \chain_i$199[1]  = \chain_i$199 [37:19];
  assign \chain_i$199[2]  = \chain_i$199 [56:38];
  assign \chain_i$199[3]  = \chain_i$199 [75:57];
  assign \chain_o$200[0]  = \chain_i$199 [18:0];
  assign \chain_o$200[1]  = \chain_i$199 [37:19];
  assign \chain_o$200[2]  = \chain_i$199 [56:38];
  assign \chain_o$200[3]  = \chain_i$199 [75:57];
  assign \write$203.addr  = \$70 ;
  assign \write$203.data  = \$72 [519:448];
  assign \control$205.en  = control3[0];
  assign \control$205.first  = control3[1];
  assign \control$205.last  = control3[2];
  assign \control$205.edge  = control3[3];
  assign \control$205.tile  = control3[7:4];
  assign \chain_i$207[0]  = \chain_i$207 [18:0];
  assign \chain_i$207[1]  = \chain_i$207 [37:19];
  assign \chain_i$207[2]  = \chain_i$207 [56:38];
  assign \chain_i$207[3]  = \chain_i$207 [75:57];
  assign \chain_o$208[0]  = \chain_i$207 [18:0];
  assign \chain_o$208[1]  = \chain_i$207 [37:19];
  assign \chain_o$208[2]  = \chain_i$207 [56:38];
  assign \chain_o$208[3]  = \chain_i$207 [75:57];
  assign \write$211.addr  = \$70 ;
  assign \write$211.data  = \$72 [519:448];
  assign \control$213.en  = control3[0];
  assign \control$213.first  = control3[1];
  assign \control$213.last  = control3[2];
  assign \control$213.edge  = control3[3];
  assign \control$213.tile  = control3[7:4];
  assign \chain_i$215[0]  = \chain_i$215 [18:0];
  assign \chain_i$215[1]  = \chain_i$215 [37:19];
  assign \chain_i$215[2]  = \chain_i$215 [56:38];
  assign \chain_i$215[3]  = \chain_i$215 [75:57];
  assign \chain_o$216[0]  = \chain_i$215 [18:0];
  assign \chain_o$216[1]  = \chain_i$215 [37:19];
  assign \chain_o$216[2]  = \chain_i$215 [56:38];
  assign \chain_o$216[3]  = \chain_i$215 [75:57];
  assign \write$219.addr  = \$70 ;
  assign \write$219.data  = \$72 [519:448];
  assign \control$221.en  = control3[0];
  assign \control$221.first  = control3[1];
  assign \control$221.last  = control3[2];
  assign \control$221.edge  = control3[3];
  assign \control$221.tile  = control3[7:4];
  assign \chain_i$223[0]  = \chain_i$223 [18:0];
  assign \chain_i$223[1]  = \chain_i$223 [37:19];
  assign \chain_i$223[2]  = \chain_i$223 [56:38];
  assign \chain_i$223[3]  = \chain_i$223 [75:57];
  assign \chain_o$224[0]  = \chain_i$223 [18:0];
  assign \chain_o$224[1]  = \chain_i$223 [37:19];
  assign \chain_o$224[2]  = \chain_i$223 [56:38];
  assign \chain_o$224[3]  = \chain_i$223 [75:57];
  assign \write$227.addr  = \$70 ;
  assign \write$227.data  = \$72 [519:448];
  assign \control$229.en  = control3[0];
  assign \control$229.first  = control3[1];
  assign \control$229.last  = control3[2];
  assign \control$229.edge  = control3[3];
  assign \control$229.tile  = control3[7:4];
  assign \chain_i$231[0]  = \chain_i$231 [18:0];
  assign \chain_i$231[1]  = \chain_i$231 [37:19];
  assign \chain_i$231[2]  = \chain_i$231 [56:38];
  assign \chain_i$231[3]  = \chain_i$231 [75:57];
  assign \chain_o$232[0]  = \chain_i$231 [18:0];
  assign \chain_o$232[1]  = \chain_i$231 [37:19];
  assign \chain_o$232[2]  = \chain_i$231 [56:38];
  assign \chain_o$232[3]  = \chain_i$231 [75:57];
  assign \write$235.addr  = \$70 ;
  assign \write$235.data  = \$72 [519:448];
  assign \control$237.en  = control3[0];
  assign \control$237.first  = control3[1];
  assign \control$237.last  = control3[2];
  assign \control$237.edge  = control3[3];
  assign \control$237.tile  = control3[7:4];
  assign \chain_i$239[0]  = \chain_i$239 [18:0];
  assign \chain_i$239[1]  = \chain_i$239 [37:19];
  assign \chain_i$239[2]  = \chain_i$239 [56:38];
  assign \chain_i$239[3]  = \chain_i$239 [75:57];
  assign \chain_o$240[0]  = \chain_i$239 [18:0];
  assign \chain_o$240[1]  = \chain_i$239 [37:19];
  assign \chain_o$240[2]  = \chain_i$239 [56:38];
  assign \chain_o$240[3]  = \chain_i$239 [75:57];
  assign \write$243.addr  = \$70 ;
  assign \write$243.data  = \$72 [519:448];
  assign \control$245.en  = control3[0];
  assign \control$245.first  = control3[1];
  assign \control$245.last  = control3[2];
  assign \control$245.edge  = control3[3];
  assign \control$245.tile  = control3[7:4];
  assign \chain_i$247[0]  = \chain_i$247 [18:0];
  assign \chain_i$247[1]  = \chain_i$247 [37:19];
  assign \chain_i$247[2]  = \chain_i$247 [56:38];
  assign \chain_i$247[3]  = \chain_i$247 [75:57];
  assign \chain_o$248[0]  = \chain_i$247 [18:0];
  assign \chain_o$248[1]  = \chain_i$247 [37:19];
  assign \chain_o$248[2]  = \chain_i$247 [56:38];
  assign \chain_o$248[3]  = \chain_i$247 [75:57];
  assign \write$251.addr  = \$70 ;
  assign \write$251.data  = \$72 [519:448];
  assign \control$253.en  = control3[0];
  assign \control$253.first  = control3[1];
  assign \control$253.last  = control3[2];
  assign \control$253.edge  = control3[3];
  assign \control$253.tile  = control3[7:4];
  assign \chain_i$255[0]  = \chain_i$255 [18:0];
  assign \chain_i$255[1]  = \chain_i$255 [37:19];
  assign \chain_i$255[2]  = \chain_i$255 [56:38];
  assign \chain_i$255[3]  = \chain_i$255 [75:57];
  assign \chain_o$256[0]  = \chain_i$255 [18:0];
  assign \chain_o$256[1]  = \chain_i$255 [37:19];
  assign \chain_o$256[2]  = \chain_i$255 [56:38];
  assign \chain_o$256[3]  = \chain_i$255 [75:57];
  assign \write$259.addr  = \$70 ;
  assign \write$259.data  = \$72 [519:448];
  assign \control$261.en  = control3[0];
  assign \control$261.first  = control3[1];
  assign \control$261.last  = control3[2];
  assign \control$261.edge  = control3[3];
  assign \control$261.tile  = control3[7:4];
  assign \chain_i$263[0]  = \chain_i$263 [18:0];
  assign \chain_i$263[1]  = \chain_i$263 [37:19];
  assign \chain_i$263[2]  = \chain_i$263 [56:38];
  assign \chain_i$263[3]  = \chain_i$263 [75:57];
  assign \chain_o$264[0]  = \chain_i$263 [18:0];
  assign \chain_o$264[1]  = \chain_i$263 [37:19];
  assign \chain_o$264[2]  = \chain_i$263 [56:38];
  assign \chain_o$264[3]  = \chain_i$263 [75:57];
  assign \write$267.addr  = \$70 ;
  assign \write$267.data  = \$72 [519:448];
  assign \control$269.en  = control3[0];
  assign \control$269.first  = control3[1];
  assign \control$269.last  = control3[2];
  assign \control$269.edge  = control3[3];
  assign \control$269.tile  = control3[7:4];
  assign \chain_i$271[0]  = \chain_i$271 [18:0];
  assign \chain_i$271[1]  = \chain_i$271 [37:19];
  assign \chain_i$271[2]  = \chain_i$271 [56:38];
  assign \chain_i$271[3]  = \chain_i$271 [75:57];
  assign \chain_o$272[0]  = \chain_i$271 [18:0];
  assign \chain_o$272[1]  = \chain_i$271 [37:19];
  assign \chain_o$272[2]  = \chain_i$271 [56:38];
  assign \chain_o$272[3]  = \chain_i$271 [75:57];
  assign \write$275.addr  = \$70 ;
  assign \write$275.data  = \$72 [519:448];
  assign \control$277.en  = control3[0];
  assign \control$277.first  = control3[1];
  assign \control$277.last  = control3[2];
  assign \control$277.edge  = control3[3];
  assign \control$277.tile  = control3[7:4];
  assign \chain_i$279[0]  = \chain_i$279 [18:0];
  assign \chain_i$279[1]  = \chain_i$279 [37:19];
  assign \chain_i$279[2]  = \chain_i$279 [56:38];
  assign \chain_i$279[3]  = \chain_i$279 [75:57];
  assign \chain_o$280[0]  = \chain_i$279 [18:0];
  assign \chain_o$280[1]  = \chain_i$279 [37:19];
  assign \chain_o$280[2]  = \chain_i$279 [56:38];
  assign \chain_o$280[3]  = \chain_i$279 [75:57];
  assign \write$283.addr  = \$70 ;
  assign \write$283.data  = \$72 [519:448];
  assign \control$285.en  = control3[0];
  assign \control$285.first  = control3[1];
  assign \control$285.last  = control3[2];
  assign \control$285.edge  = control3[3];
  assign \control$285.tile  = control3[7:4];
  assign \chain_i$287[0]  = \chain_i$287 [18:0];
  assign \chain_i$287[1]  = \chain_i$287 [37:19];
  assign \chain_i$287[2]  = \chain_i$287 [56:38];
  assign \chain_i$287[3]  = \chain_i$287 [75:57];
  assign \chain_o$288[0]  = \chain_i$287 [18:0];
  assign \chain_o$288[1]  = \chain_i$287 [37:19];
  assign \chain_o$288[2]  = \chain_i$287 [56:38];
  assign \chain_o$288[3]  = \chain_i$287 [75:57];
  assign \write$291.addr  = \$70 ;
  assign \write$291.data  = \$72 [519:448];
  assign \control$293.en  = control3[0];
  assign \control$293.first  = control3[1];
  assign \control$293.last  = control3[2];
  assign \control$293.edge  = control3[3];
  assign \control$293.tile  = control3[7:4];
  assign \chain_i$295[0]  = \chain_i$295 [18:0];
  assign \chain_i$295[1]  = \chain_i$295 [37:19];
  assign \chain_i$295[2]  = \chain_i$295 [56:38];
  assign \chain_i$295[3]  = \chain_i$295 [75:57];
  assign \chain_o$296[0]  = \chain_i$295 [18:0];
  assign \chain_o$296[1]  = \chain_i$295 [37:19];
  assign \chain_o$296[2]  = \chain_i$295 [56:38];
  assign \chain_o$296[3]  = \chain_i$295 [75:57];
  assign \write$299.addr  = \$70 ;
  assign \write$299.data  = \$72 [519:448];
  assign \control$301.en  = control3[0];
  assign \control$301.first  = control3[1];
  assign \control$301.last  = control3[2];
  assign \control$301.edge  = control3[3];
  assign \control$301.tile  = control3[7:4];
  assign \chain_i$303[0]  = \chain_i$303 [18:0];
  assign \chain_i$303[1]  = \chain_i$303 [37:19];
  assign \chain_i$303[2]  = \chain_i$303 [56:38];
  assign \chain_i$303[3]  = \chain_i$303 [75:57];
  assign \chain_o$304[0]  = \chain_i$303 [18:0];
  assign \chain_o$304[1]  = \chain_i$303 [37:19];
  assign \chain_o$304[2]  = \chain_i$303 [56:38];
  assign \chain_o$304[3]  = \chain_i$303 [75:57];
  assign \write$307.addr  = \$70 ;
  assign \write$307.data  = \$72 [519:448];
  assign \control$309.en  = control3[0];
  assign \control$309.first  = control3[1];
  assign \control$309.last  = control3[2];
  assign \control$309.edge  = control3[3];
  assign \control$309.tile  = control3[7:4];
  assign \chain_i$311[0]  = \chain_i$311 [18:0];
  assign \chain_i$311[1]  = \chain_i$311 [37:19];
  assign \chain_i$311[2]  = \chain_i$311 [56:38];
  assign \chain_i$311[3]  = \chain_i$311 [75:57];
  assign \chain_o$312[0]  = \chain_i$311 [18:0];
  assign \chain_o$312[1]  = \chain_i$311 [37:19];
  assign \chain_o$312[2]  = \chain_i$311 [56:38];
  assign \chain_o$312[3]  = \chain_i$311 [75:57];
  assign \write$315.addr  = \$70 ;
  assign \write$315.data  = \$72 [519:448];
  assign \control$317.en  = control3[0];
  assign \control$317.first  = control3[1];
  assign \control$317.last  = control3[2];
  assign \control$317.edge  = control3[3];
  assign \control$317.tile  = control3[7:4];
  assign \chain_i$319[0]  = \chain_i$319 [18:0];
  assign \chain_i$319[1]  = \chain_i$319 [37:19];
  assign \chain_i$319[2]  = \chain_i$319 [56:38];
  assign \chain_i$319[3]  = \chain_i$319 [75:57];
  assign \chain_o$320[0]  = \chain_i$319 [18:0];
  assign \chain_o$320[1]  = \chain_i$319 [37:19];
  assign \chain_o$320[2]  = \chain_i$319 [56:38];
  assign \chain_o$320[3]  = \chain_i$319 [75:57];
  assign \write$323.addr  = \$70 ;
  assign \write$323.data  = \$72 [519:448];
  assign \control$325.en  = control3[0];
  assign \control$325.first  = control3[1];
  assign \control$325.last  = control3[2];
  assign \control$325.edge  = control3[3];
  assign \control$325.tile  = control3[7:4];
  assign \chain_i$327[0]  = \chain_i$327 [18:0];
  assign \chain_i$327[1]  = \chain_i$327 [37:19];
  assign \chain_i$327[2]  = \chain_i$327 [56:38];
  assign \chain_i$327[3]  = \chain_i$327 [75:57];
  assign \chain_o$328[0]  = \chain_i$327 [18:0];
  assign \chain_o$328[1]  = \chain_i$327 [37:19];
  assign \chain_o$328[2]  = \chain_i$327 [56:38];
  assign \chain_o$328[3]  = \chain_i$327 [75:57];
  assign \write$331.addr  = \$70 ;
  assign \write$331.data  = \$72 [519:448];
  assign \control$333.en  = control3[0];
  assign \control$333.first  = control3[1];
  assign \control$333.last  = control3[2];
  assign \control$333.edge  = control3[3];
  assign \control$333.tile  = control3[7:4];
  assign \chain_i$335[0]  = \chain_i$335 [18:0];
  assign \chain_i$335[1]  = \chain_i$335 [37:19];
  assign \chain_i$335[2]  = \chain_i$335 [56:38];
  assign \chain_i$335[3]  = \chain_i$335 [75:57];
  assign \chain_o$336[0]  = \chain_i$335 [18:0];
  assign \chain_o$336[1]  = \chain_i$335 [37:19];
  assign \chain_o$336[2]  = \chain_i$335 [56:38];
  assign \chain_o$336[3]  = \chain_i$335 [75:57];
  assign \write$339.addr  = \$70 ;
  assign \write$339.data  = \$72 [519:448];
  assign \control$341.en  = control3[0];
  assign \control$341.first  = control3[1];
  assign \control$341.last  = control3[2];
  assign \control$341.edge  = control3[3];
  assign \control$341.tile  = control3[7:4];
  assign \chain_i$343[0]  = \chain_i$343 [18:0];
  assign \chain_i$343[1]  = \chain_i$343 [37:19];
  assign \chain_i$343[2]  = \chain_i$343 [56:38];
  assign \chain_i$343[3]  = \chain_i$343 [75:57];
  assign \chain_o$344[0]  = \chain_i$343 [18:0];
  assign \chain_o$344[1]  = \chain_i$343 [37:19];
  assign \chain_o$344[2]  = \chain_i$343 [56:38];
  assign \chain_o$344[3]  = \chain_i$343 [75:57];
  assign \write$347.addr  = \$70 ;
  assign \write$347.data  = \$72 [519:448];
  assign \control$349.en  = control3[0];
  assign \control$349.first  = control3[1];
  assign \control$349.last  = control3[2];
  assign \control$349.edge  = control3[3];
  assign \control$349.tile  = control3[7:4];
  assign \chain_i$351[0]  = \chain_i$351 [18:0];
  assign \chain_i$351[1]  = \chain_i$351 [37:19];
  assign \chain_i$351[2]  = \chain_i$351 [56:38];
  assign \chain_i$351[3]  = \chain_i$351 [75:57];
  assign \chain_o$352[0]  = \chain_i$351 [18:0];
  assign \chain_o$352[1]  = \chain_i$351 [37:19];
  assign \chain_o$352[2]  = \chain_i$351 [56:38];
  assign \chain_o$352[3]  = \chain_i$351 [75:57];
  assign \write$355.addr  = \$70 ;
  assign \write$355.data  = \$72 [519:448];
  assign \control$357.en  = control3[0];
  assign \control$357.first  = control3[1];
  assign \control$357.last  = control3[2];
  assign \control$357.edge  = control3[3];
  assign \control$357.tile  = control3[7:4];
  assign \chain_i$359[0]  = \chain_i$359 [18:0];
  assign \chain_i$359[1]  = \chain_i$359 [37:19];
  assign \chain_i$359[2]  = \chain_i$359 [56:38];
  assign \chain_i$359[3]  = \chain_i$359 [75:57];
  assign \chain_o$360[0]  = \chain_i$359 [18:0];
  assign \chain_o$360[1]  = \chain_i$359 [37:19];
  assign \chain_o$360[2]  = \chain_i$359 [56:38];
  assign \chain_o$360[3]  = \chain_i$359 [75:57];
  assign \write$363.addr  = \$70 ;
  assign \write$363.data  = \$72 [519:448];
  assign \control$365.en  = control3[0];
  assign \control$365.first  = control3[1];
  assign \control$365.last  = control3[2];
  assign \control$365.edge  = control3[3];
  assign \control$365.tile  = control3[7:4];
  assign \chain_i$367[0]  = \chain_i$367 [18:0];
  assign \chain_i$367[1]  = \chain_i$367 [37:19];
  assign \chain_i$367[2]  = \chain_i$367 [56:38];
  assign \chain_i$367[3]  = \chain_i$367 [75:57];
  assign \chain_o$368[0]  = \chain_i$367 [18:0];
  assign \chain_o$368[1]  = \chain_i$367 [37:19];
  assign \chain_o$368[2]  = \chain_i$367 [56:38];
  assign \chain_o$368[3]  = \chain_i$367 [75:57];
  assign \write$371.addr  = \$70 ;
  assign \write$371.data  = \$72 [519:448];
  assign \control$373.en  = control3[0];
  assign \control$373.first  = control3[1];
  assign \control$373.last  = control3[2];
  assign \control$373.edge  = control3[3];
  assign \control$373.tile  = control3[7:4];
  assign \chain_i$375[0]  = \chain_i$375 [18:0];
  assign \chain_i$375[1]  = \chain_i$375 [37:19];
  assign \chain_i$375[2]  = \chain_i$375 [56:38];
  assign \chain_i$375[3]  = \chain_i$375 [75:57];
  assign \chain_o$376[0]  = \chain_i$375 [18:0];
  assign \chain_o$376[1]  = \chain_i$375 [37:19];
  assign \chain_o$376[2]  = \chain_i$375 [56:38];
  assign \chain_o$376[3]  = \chain_i$375 [75:57];
  assign \write$379.addr  = \$70 ;
  assign \write$379.data  = \$72 [519:448];
  assign \control$381.en  = control3[0];
  assign \control$381.first  = control3[1];
  assign \control$381.last  = control3[2];
  assign \control$381.edge  = control3[3];
  assign \control$381.tile  = control3[7:4];
  assign \chain_i$383[0]  = \chain_i$383 [18:0];
  assign \chain_i$383[1]  = \chain_i$383 [37:19];
  assign \chain_i$383[2]  = \chain_i$383 [56:38];
  assign \chain_i$383[3]  = \chain_i$383 [75:57];
  assign \chain_o$384[0]  = \chain_i$383 [18:0];
  assign \chain_o$384[1]  = \chain_i$383 [37:19];
  assign \chain_o$384[2]  = \chain_i$383 [56:38];
  assign \chain_o$384[3]  = \chain_i$383 [75:57];
  assign \write$387.addr  = \$70 ;
  assign \write$387.data  = \$72 [519:448];
  assign \control$389.en  = control3[0];
  assign \control$389.first  = control3[1];
  assign \control$389.last  = control3[2];
  assign \control$389.edge  = control3[3];
  assign \control$389.tile  = control3[7:4];
  assign \chain_i$391[0]  = \chain_i$391 [18:0];
  assign \chain_i$391[1]  = \chain_i$391 [37:19];
  assign \chain_i$391[2]  = \chain_i$391 [56:38];
  assign \chain_i$391[3]  = \chain_i$391 [75:57];
  assign \chain_o$392[0]  = \chain_i$391 [18:0];
  assign \chain_o$392[1]  = \chain_i$391 [37:19];
  assign \chain_o$392[2]  = \chain_i$391 [56:38];
  assign \chain_o$392[3]  = \chain_i$391 [75:57];
  assign \write$395.addr  = \$70 ;
  assign \write$395.data  = \$72 [519:448];
  assign \control$397.en  = control3[0];
  assign \control$397.first  = control3[1];
  assign \control$397.last  = control3[2];
  assign \control$397.edge  = control3[3];
  assign \control$397.tile  = control3[7:4];
  assign \chain_i$399[0]  = \chain_i$399 [18:0];
  assign \chain_i$399[1]  = \chain_i$399 [37:19];
  assign \chain_i$399[2]  = \chain_i$399 [56:38];
  assign \chain_i$399[3]  = \chain_i$399 [75:57];
  assign \chain_o$400[0]  = \chain_i$399 [18:0];
  assign \chain_o$400[1]  = \chain_i$399 [37:19];
  assign \chain_o$400[2]  = \chain_i$399 [56:38];
  assign \chain_o$400[3]  = \chain_i$399 [75:57];
  assign \write$403.addr  = \$70 ;
  assign \write$403.data  = \$72 [519:448];
  assign \control$405.en  = control3[0];
  assign \control$405.first  = control3[1];
  assign \control$405.last  = control3[2];
  assign \control$405.edge  = control3[3];
  assign \control$405.tile  = control3[7:4];
  assign \chain_i$407[0]  = \chain_i$407 [18:0];
  assign \chain_i$407[1]  = \chain_i$407 [37:19];
  assign \chain_i$407[2]  = \chain_i$407 [56:38];
  assign \chain_i$407[3]  = \chain_i$407 [75:57];
  assign \chain_o$408[0]  = \chain_i$407 [18:0];
  assign \chain_o$408[1]  = \chain_i$407 [37:19];
  assign \chain_o$408[2]  = \chain_i$407 [56:38];
  assign \chain_o$408[3]  = \chain_i$407 [75:57];
  assign \write$411.addr  = \$70 ;
  assign \write$411.data  = \$72 [519:448];
  assign \control$413.en  = control3[0];
  assign \control$413.first  = control3[1];
  assign \control$413.last  = control3[2];
  assign \control$413.edge  = control3[3];
  assign \control$413.tile  = control3[7:4];
  assign \chain_i$415[0]  = \chain_i$415 [18:0];
  assign \chain_i$415[1]  = \chain_i$415 [37:19];
  assign \chain_i$415[2]  = \chain_i$415 [56:38];
  assign \chain_i$415[3]  = \chain_i$415 [75:57];
  assign \chain_o$416[0]  = \chain_i$415 [18:0];
  assign \chain_o$416[1]  = \chain_i$415 [37:19];
  assign \chain_o$416[2]  = \chain_i$415 [56:38];
  assign \chain_o$416[3]  = \chain_i$415 [75:57];
  assign \write$419.addr  = \$70 ;
  assign \write$419.data  = \$72 [519:448];
  assign \control$421.en  = control3[0];
  assign \control$421.first  = control3[1];
  assign \control$421.last  = control3[2];
  assign \control$421.edge  = control3[3];
  assign \control$421.tile  = control3[7:4];
  assign \chain_i$423[0]  = \chain_i$423 [18:0];
  assign \chain_i$423[1]  = \chain_i$423 [37:19];
  assign \chain_i$423[2]  = \chain_i$423 [56:38];
  assign \chain_i$423[3]  = \chain_i$423 [75:57];
  assign \chain_o$424[0]  = \chain_i$423 [18:0];
  assign \chain_o$424[1]  = \chain_i$423 [37:19];
  assign \chain_o$424[2]  = \chain_i$423 [56:38];
  assign \chain_o$424[3]  = \chain_i$423 [75:57];
  assign \write$427.addr  = \$70 ;
  assign \write$427.data  = \$72 [519:448];
  assign \control$429.en  = control3[0];
  assign \control$429.first  = control3[1];
  assign \control$429.last  = control3[2];
  assign \control$429.edge  = control3[3];
  assign \control$429.tile  = control3[7:4];
  assign \chain_i$431[0]  = \chain_i$431 [18:0];
  assign \chain_i$431[1]  = \chain_i$431 [37:19];
  assign \chain_i$431[2]  = \chain_i$431 [56:38];
  assign \chain_i$431[3]  = \chain_i$431 [75:57];
  assign \chain_o$432[0]  = \chain_i$431 [18:0];
  assign \chain_o$432[1]  = \chain_i$431 [37:19];
  assign \chain_o$432[2]  = \chain_i$431 [56:38];
  assign \chain_o$432[3]  = \chain_i$431 [75:57];
  assign \write$435.addr  = \$70 ;
  assign \write$435.data  = \$72 [519:448];
  assign \control$437.en  = control3[0];
  assign \control$437.first  = control3[1];
  assign \control$437.last  = control3[2];
  assign \control$437.edge  = control3[3];
  assign \control$437.tile  = control3[7:4];
  assign \chain_i$439[0]  = \chain_i$439 [18:0];
  assign \chain_i$439[1]  = \chain_i$439 [37:19];
  assign \chain_i$439[2]  = \chain_i$439 [56:38];
  assign \chain_i$439[3]  = \chain_i$439 [75:57];
  assign \chain_o$440[0]  = \chain_i$439 [18:0];
  assign \chain_o$440[1]  = \chain_i$439 [37:19];
  assign \chain_o$440[2]  = \chain_i$439 [56:38];
  assign \chain_o$440[3]  = \chain_i$439 [75:57];
  assign \write$443.addr  = \$70 ;
  assign \write$443.data  = \$72 [519:448];
  assign \control$445.en  = control3[0];
  assign \control$445.first  = control3[1];
  assign \control$445.last  = control3[2];
  assign \control$445.edge  = control3[3];
  assign \control$445.tile  = control3[7:4];
  assign \chain_i$447[0]  = \chain_i$447 [18:0];
  assign \chain_i$447[1]  = \chain_i$447 [37:19];
  assign \chain_i$447[2]  = \chain_i$447 [56:38];
  assign \chain_i$447[3]  = \chain_i$447 [75:57];
  assign \chain_o$448[0]  = \chain_i$447 [18:0];
  assign \chain_o$448[1]  = \chain_i$447 [37:19];
  assign \chain_o$448[2]  = \chain_i$447 [56:38];
  assign \chain_o$448[3]  = \chain_i$447 [75:57];
  assign \write$451.addr  = \$70 ;
  assign \write$451.data  = \$72 [519:448];
  assign \control$453.en  = control3[0];
  assign \control$453.first  = control3[1];
  assign \control$453.last  = control3[2];
  assign \control$453.edge  = control3[3];
  assign \control$453.tile  = control3[7:4];
  assign \chain_i$455[0]  = \chain_i$455 [18:0];
  assign \chain_i$455[1]  = \chain_i$455 [37:19];
  assign \chain_i$455[2]  = \chain_i$455 [56:38];
  assign \chain_i$455[3]  = \chain_i$455 [75:57];
  assign \chain_o$456[0]  = \chain_i$455 [18:0];
  assign \chain_o$456[1]  = \chain_i$455 [37:19];
  assign \chain_o$456[2]  = \chain_i$455 [56:38];
  assign \chain_o$456[3]  = \chain_i$455 [75:57];
  assign \write$459.addr  = \$70 ;
  assign \write$459.data  = \$72 [519:448];
  assign \control$461.en  = control3[0];
  assign \control$461.first  = control3[1];
  assign \control$461.last  = control3[2];
  assign \control$461.edge  = control3[3];
  assign \control$461.tile  = control3[7:4];
  assign \chain_i$463[0]  = \chain_i$463 [18:0];
  assign \chain_i$463[1]  = \chain_i$463 [37:19];
  assign \chain_i$463[2]  = \chain_i$463 [56:38];
  assign \chain_i$463[3]  = \chain_i$463 [75:57];
  assign \chain_o$464[0]  = \chain_i$463 [18:0];
  assign \chain_o$464[1]  = \chain_i$463 [37:19];
  assign \chain_o$464[2]  = \chain_i$463 [56:38];
  assign \chain_o$464[3]  = \chain_i$463 [75:57];
  assign \write$467.addr  = \$70 ;
  assign \write$467.data  = \$72 [519:448];
  assign \control$469.en  = control3[0];
  assign \control$469.first  = control3[1];
  assign \control$469.last  = control3[2];
  assign \control$469.edge  = control3[3];
  assign \control$469.tile  = control3[7:4];
  assign \chain_i$471[0]  = \chain_i$471 [18:0];
  assign \chain_i$471[1]  = \chain_i$471 [37:19];
  assign \chain_i$471[2]  = \chain_i$471 [56:38];
  assign \chain_i$471[3]  = \chain_i$471 [75:57];
  assign \chain_o$472[0]  = \chain_i$471 [18:0];
  assign \chain_o$472[1]  = \chain_i$471 [37:19];
  assign \chain_o$472[2]  = \chain_i$471 [56:38];
  assign \chain_o$472[3]  = \chain_i$471 [75:57];
  assign \write$475.addr  = \$70 ;
  assign \write$475.data  = \$72 [519:448];
  assign \control$477.en  = control3[0];
  assign \control$477.first  = control3[1];
  assign \control$477.last  = control3[2];
  assign \control$477.edge  = control3[3];
  assign \control$477.tile  = control3[7:4];
  assign \chain_i$479[0]  = \chain_i$479 [18:0];
  assign \chain_i$479[1]  = \chain_i$479 [37:19];
  assign \chain_i$479[2]  = \chain_i$479 [56:38];
  assign \chain_i$479[3]  = \chain_i$479 [75:57];
  assign \chain_o$480[0]  = \chain_i$479 [18:0];
  assign \chain_o$480[1]  = \chain_i$479 [37:19];
  assign \chain_o$480[2]  = \chain_i$479 [56:38];
  assign \chain_o$480[3]  = \chain_i$479 [75:57];
  assign \write$483.addr  = \$70 ;
  assign \write$483.data  = \$72 [519:448];
  assign \control$485.en  = control3[0];
  assign \control$485.first  = control3[1];
  assign \control$485.last  = control3[2];
  assign \control$485.edge  = control3[3];
  assign \control$485.tile  = control3[7:4];
  assign \chain_i$487[0]  = \chain_i$487 [18:0];
  assign \chain_i$487[1]  = \chain_i$487 [37:19];
  assign \chain_i$487[2]  = \chain_i$487 [56:38];
  assign \chain_i$487[3]  = \chain_i$487 [75:57];
  assign \chain_o$488[0]  = \chain_i$487 [18:0];
  assign \chain_o$488[1]  = \chain_i$487 [37:19];
  assign \chain_o$488[2]  = \chain_i$487 [56:38];
  assign \chain_o$488[3]  = \chain_i$487 [75:57];
  assign \write$491.addr  = \$70 ;
  assign \write$491.data  = \$72 [519:448];
  assign \control$493.en  = control3[0];
  assign \control$493.first  = control3[1];
  assign \control$493.last  = control3[2];
  assign \control$493.edge  = control3[3];
  assign \control$493.tile  = control3[7:4];
  assign \chain_i$495[0]  = \chain_i$495 [18:0];
  assign \chain_i$495[1]  = \chain_i$495 [37:19];
  assign \chain_i$495[2]  = \chain_i$495 [56:38];
  assign \chain_i$495[3]  = \chain_i$495 [75:57];
  assign \chain_o$496[0]  = \chain_i$495 [18:0];
  assign \chain_o$496[1]  = \chain_i$495 [37:19];
  assign \chain_o$496[2]  = \chain_i$495 [56:38];
  assign \chain_o$496[3]  = \chain_i$495 [75:57];
  assign \write$499.addr  = \$70 ;
  assign \write$499.data  = \$72 [519:448];
  assign \control$501.en  = control3[0];
  assign \control$501.first  = control3[1];
  assign \control$501.last  = control3[2];
  assign \control$501.edge  = control3[3];
  assign \control$501.tile  = control3[7:4];
  assign \chain_i$503[0]  = \chain_i$503 [18:0];
  assign \chain_i$503[1]  = \chain_i$503 [37:19];
  assign \chain_i$503[2]  = \chain_i$503 [56:38];
  assign \chain_i$503[3]  = \chain_i$503 [75:57];
  assign \chain_o$504[0]  = \chain_i$503 [18:0];
  assign \chain_o$504[1]  = \chain_i$503 [37:19];
  assign \chain_o$504[2]  = \chain_i$503 [56:38];
  assign \chain_o$504[3]  = \chain_i$503 [75:57];
  assign \write$507.addr  = \$70 ;
  assign \write$507.data  = \$72 [519:448];
  assign \control$509.en  = control3[0];
  assign \control$509.first  = control3[1];
  assign \control$509.last  = control3[2];
  assign \control$509.edge  = control3[3];
  assign \control$509.tile  = control3[7:4];
  assign \chain_i$511[0]  = \chain_i$511 [18:0];
  assign \chain_i$511[1]  = \chain_i$511 [37:19];
  assign \chain_i$511[2]  = \chain_i$511 [56:38];
  assign \chain_i$511[3]  = \chain_i$511 [75:57];
  assign \chain_o$512[0]  = \chain_i$511 [18:0];
  assign \chain_o$512[1]  = \chain_i$511 [37:19];
  assign \chain_o$512[2]  = \chain_i$511 [56:38];
  assign \chain_o$512[3]  = \chain_i$511 [75:57];
  assign \write$515.addr  = \$70 ;
  assign \write$515.data  = \$72 [519:448];
  assign \control$517.en  = control3[0];
  assign \control$517.first  = control3[1];
  assign \control$517.last  = control3[2];
  assign \control$517.edge  = control3[3];
  assign \control$517.tile  = control3[7:4];
  assign \chain_i$519[0]  = \chain_i$519 [18:0];
  assign \chain_i$519[1]  = \chain_i$519 [37:19];
  assign \chain_i$519[2]  = \chain_i$519 [56:38];
  assign \chain_i$519[3]  = \chain_i$519 [75:57];
  assign \chain_o$520[0]  = \chain_i$519 [18:0];
  assign \chain_o$520[1]  = \chain_i$519 [37:19];
  assign \chain_o$520[2]  = \chain_i$519 [56:38];
  assign \chain_o$520[3]  = \chain_i$519 [75:57];
  assign \write$523.addr  = \$70 ;
  assign \write$523.data  = \$72 [519:448];
  assign \control$525.en  = control3[0];
  assign \control$525.first  = control3[1];
  assign \control$525.last  = control3[2];
  assign \control$525.edge  = control3[3];
  assign \control$525.tile  = control3[7:4];
  assign \chain_i$527[0]  = \chain_i$527 [18:0];
  assign \chain_i$527[1]  = \chain_i$527 [37:19];
  assign \chain_i$527[2]  = \chain_i$527 [56:38];
  assign \chain_i$527[3]  = \chain_i$527 [75:57];
  assign \chain_o$528[0]  = \chain_i$527 [18:0];
  assign \chain_o$528[1]  = \chain_i$527 [37:19];
  assign \chain_o$528[2]  = \chain_i$527 [56:38];
  assign \chain_o$528[3]  = \chain_i$527 [75:57];
  assign \write$531.addr  = \$70 ;
  assign \write$531.data  = \$72 [519:448];
  assign \control$533.en  = control3[0];
  assign \control$533.first  = control3[1];
  assign \control$533.last  = control3[2];
  assign \control$533.edge  = control3[3];
  assign \control$533.tile  = control3[7:4];
  assign \chain_i$535[0]  = \chain_i$535 [18:0];
  assign \chain_i$535[1]  = \chain_i$535 [37:19];
  assign \chain_i$535[2]  = \chain_i$535 [56:38];
  assign \chain_i$535[3]  = \chain_i$535 [75:57];
  assign \chain_o$536[0]  = \chain_i$535 [18:0];
  assign \chain_o$536[1]  = \chain_i$535 [37:19];
  assign \chain_o$536[2]  = \chain_i$535 [56:38];
  assign \chain_o$536[3]  = \chain_i$535 [75:57];
  assign \write$539.addr  = \$70 ;
  assign \write$539.data  = \$72 [519:448];
  assign \control$541.en  = control3[0];
  assign \control$541.first  = control3[1];
  assign \control$541.last  = control3[2];
  assign \control$541.edge  = control3[3];
  assign \control$541.tile  = control3[7:4];
  assign \chain_i$543[0]  = \chain_i$543 [18:0];
  assign \chain_i$543[1]  = \chain_i$543 [37:19];
  assign \chain_i$543[2]  = \chain_i$543 [56:38];
  assign \chain_i$543[3]  = \chain_i$543 [75:57];
  assign \chain_o$544[0]  = \chain_i$543 [18:0];
  assign \chain_o$544[1]  = \chain_i$543 [37:19];
  assign \chain_o$544[2]  = \chain_i$543 [56:38];
  assign \chain_o$544[3]  = \chain_i$543 [75:57];
  assign \write$547.addr  = \$70 ;
  assign \write$547.data  = \$72 [519:448];
  assign \control$549.en  = control3[0];
  assign \control$549.first  = control3[1];
  assign \control$549.last  = control3[2];
  assign \control$549.edge  = control3[3];
  assign \control$549.tile  = control3[7:4];
  assign \chain_i$551[0]  = \chain_i$551 [18:0];
  assign \chain_i$551[1]  = \chain_i$551 [37:19];
  assign \chain_i$551[2]  = \chain_i$551 [56:38];
  assign \chain_i$551[3]  = \chain_i$551 [75:57];
  assign \chain_o$552[0]  = \chain_i$551 [18:0];
  assign \chain_o$552[1]  = \chain_i$551 [37:19];
  assign \chain_o$552[2]  = \chain_i$551 [56:38];
  assign \chain_o$552[3]  = \chain_i$551 [75:57];
  assign \write$555.addr  = \$70 ;
  assign \write$555.data  = \$72 [519:448];
  assign \control$557.en  = control3[0];
  assign \control$557.first  = control3[1];
  assign \control$557.last  = control3[2];
  assign \control$557.edge  = control3[3];
  assign \control$557.tile  = control3[7:4];
  assign \chain_i$559[0]  = \chain_i$559 [18:0];
  assign \chain_i$559[1]  = \chain_i$559 [37:19];
  assign \chain_i$559[2]  = \chain_i$559 [56:38];
  assign \chain_i$559[3]  = \chain_i$559 [75:57];
  assign \chain_o$560[0]  = \chain_i$559 [18:0];
  assign \chain_o$560[1]  = \chain_i$559 [37:19];
  assign \chain_o$560[2]  = \chain_i$559 [56:38];
  assign \chain_o$560[3]  = \chain_i$559 [75:57];
  assign \write$563.addr  = \$70 ;
  assign \write$563.data  = \$72 [519:448];
  assign \control$565.en  = control3[0];
  assign \control$565.first  = control3[1];
  assign \control$565.last  = control3[2];
  assign \control$565.edge  = control3[3];
  assign \control$565.tile  = control3[7:4];
  assign \chain_i$567[0]  = \chain_i$567 [18:0];
  assign \chain_i$567[1]  = \chain_i$567 [37:19];
  assign \chain_i$567[2]  = \chain_i$567 [56:38];
  assign \chain_i$567[3]  = \chain_i$567 [75:57];
  assign \chain_o$568[0]  = \chain_i$567 [18:0];
  assign \chain_o$568[1]  = \chain_i$567 [37:19];
  assign \chain_o$568[2]  = \chain_i$567 [56:38];
  assign \chain_o$568[3]  = \chain_i$567 [75:57];
  assign \write$571.addr  = \$70 ;
  assign \write$571.data  = \$72 [519:448];
  assign \control$573.en  = control3[0];
  assign \control$573.first  = control3[1];
  assign \control$573.last  = control3[2];
  assign \control$573.edge  = control3[3];
  assign \control$573.tile  = control3[7:4];
  assign \chain_i$575[0]  = \chain_i$575 [18:0];
  assign \chain_i$575[1]  = \chain_i$575 [37:19];
  assign \chain_i$575[2]  = \chain_i$575 [56:38];
  assign \chain_i$575[3]  = \chain_i$575 [75:57];
  assign \chain_o$576[0]  = \chain_i$575 [18:0];
  assign \chain_o$576[1]  = \chain_i$575 [37:19];
  assign \chain_o$576[2]  = \chain_i$575 [56:38];
  assign \chain_o$576[3]  = \chain_i$575 [75:57];
  assign \write$579.addr  = \$70 ;
  assign \write$579.data  = \$72 [519:448];
  assign \control$581.en  = control3[0];
  assign \control$581.first  = control3[1];
  assign \control$581.last  = control3[2];
  assign \control$581.edge  = control3[3];
  assign \control$581.tile  = control3[7:4];
  assign \write$585.addr  = \$70 ;
  assign \write$585.data  = \$72 [519:448];
  assign \control$587.en  = control3[0];
  assign \control$587.first  = control3[1];
  assign \control$587.last  = control3[2];
  assign \control$587.edge  = control3[3];
  assign \control$587.tile  = control3[7:4];
  assign \write$591.addr  = \$70 ;
  assign \write$591.data  = \$72 [519:448];
  assign \control$593.en  = control3[0];
  assign \control$593.first  = control3[1];
  assign \control$593.last  = control3[2];
  assign \control$593.edge  = control3[3];
  assign \control$593.tile  = control3[7:4];
  assign \write$597.addr  = \$70 ;
  assign \write$597.data  = \$72 [519:448];
  assign \control$599.en  = control3[0];
  assign \control$599.first  = control3[1];
  assign \control$599.last  = control3[2];
  assign \control$599.edge  = control3[3];
  assign \control$599.tile  = control3[7:4];
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
  assign \control2.en  = control2[0];
  assign \control2.first  = control2[1];
  assign \control2.last  = control2[2];
  assign \control2.edge  = control2[3];
  assign \control2.tile  = control2[7:4];
  assign \info2.tile  = info2[3:0];
  assign \info2.tile_last  = info2[4];
  assign \info2.slots  = info2[8:5];
  assign \info2.image_last  = info2[9];
  assign heads[303:228] = \chain_o$126 ;
  assign heads[227:152] = \chain_o$117 ;
  assign heads[151:76] = \chain_o$108 ;
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

module \macram_top.array.ingest (rst, i__valid, o__valid, i__ready, o__ready, i__payload, soft_reset, \port$1094$63 , beats_per_pixel, o__payload, clk);
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
  input [13:0] \port$1094$63 ;
  wire [13:0] \port$1094$63 ;
  wire put;
  input rst;
  wire rst;
  input soft_reset;
  wire soft_reset;
  reg [15:0] words_out = 16'h0000;
  wire [15:0] words_per_pixel;
  assign \$1  = \port$1094$63  - 1'h1;
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
  assign words_per_pixel = { 2'h0, \port$1094$63  };
  assign \$like  = \$20 [6:0];
  assign o__payload = buffer[47:0];
  assign \$2  = { 48'h000000000000, buffer[111:48] };
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

module \macram_top.array.loader (i__valid, rst, fault, error, i__payload, soft_reset, words, start_weights, start_requant, \port$1307$0 , \port$1309$0 , \port$1311$0 , i__ready, unit_en, requant_en, clk);
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
  output [8:0] \port$1307$0 ;
  wire [8:0] \port$1307$0 ;
  (* init = 8'h00 *)
  output [7:0] \port$1309$0 ;
  wire [7:0] \port$1309$0 ;
  output [535:0] \port$1311$0 ;
  wire [535:0] \port$1311$0 ;
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
  assign \port$1307$0  = \$25 ;
  assign \port$1309$0  = \$27 ;
  assign \port$1311$0  = shifter[535:0];
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
, c_out, mode, param_words, axi__rvalid, axi__rdata, axi__rresp, \port$1057$0 , \port$1059$0 , cycles, mac_cycles, fill_cycles, input_stalls, output_stalls, drain_cycles, clk);
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
  input [2:0] \port$1057$0 ;
  wire [2:0] \port$1057$0 ;
  input \port$1059$0 ;
  wire \port$1059$0 ;
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
            \$35  = { 29'h00000000, \port$2$0 , \port$1059$0 , busy };
        5'h04:
            \$35  = { 29'h00000000, \port$1057$0  };
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
  assign status = { 29'h00000000, \port$2$0 , \port$1059$0 , busy };
  assign error = { 29'h00000000, \port$1057$0  };
  assign geometry = 32'd67633216;
  assign formats = 32'd197379;
  assign weight_depth = 32'd512;
  assign row_words = 32'd512;
  assign max_channels = 32'd67109888;
  assign \$12 [3] = 1'h0;
  assign { \$12 [4], \$12 [2:0] } = { 1'h0, \$11 [2:0] };
endmodule
