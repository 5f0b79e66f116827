
module macram_unit(activations, control, shift, chain_i, clk, rst, chain_o, weight);
  reg \$auto$verilog_backend.cc:2355:dump_module$1  = 0;
  wire \$1 ;
  wire \$10 ;
  wire \$11 ;
  wire [18:0] \$12 ;
  wire [18:0] \$13 ;
  wire [18:0] \$14 ;
  wire [18:0] \$15 ;
  wire \$16 ;
  wire \$17 ;
  reg [9:0] \$18 ;
  reg [7:0] \$19 ;
  wire \$2 ;
  reg [8:0] \$20 ;
  reg [8:0] \$21 ;
  reg [9:0] \$22 ;
  reg [8:0] \$23 ;
  reg [9:0] \$24 ;
  reg [8:0] \$25 ;
  reg [9:0] \$26 ;
  reg [8:0] \$27 ;
  reg [9:0] \$28 ;
  reg [7:0] \$29 ;
  wire \$3 ;
  reg [8:0] \$30 ;
  reg [18:0] \$31 ;
  reg [18:0] \$32 ;
  reg [18:0] \$33 ;
  reg [18:0] \$34 ;
  reg [18:0] \$35 ;
  reg [18:0] \$36 ;
  reg [75:0] \$37 ;
  wire \$4 ;
  wire \$5 ;
  wire \$6 ;
  wire \$7 ;
  wire [18:0] \$8 ;
  wire [18:0] \$9 ;
  reg [9:0] \$signal  = 10'h000;
  wire \$signal.carried ;
  wire \$signal.edge ;
  wire \$signal.en ;
  wire \$signal.first ;
  wire \$signal.last ;
  wire [3:0] \$signal.tile ;
  wire \$signal.unload ;
  wire [4:0] \$signature__addr ;
  wire [4:0] \$signature__addr$144 ;
  wire [18:0] \$signature__data ;
  wire [18:0] \$signature__data$49 ;
  wire [7:0] a;
  wire [9:0] \a$100 ;
  wire [8:0] \a$104 ;
  wire [8:0] \a$107 ;
  wire [9:0] \a$110 ;
  wire [8:0] \a$114 ;
  wire [8:0] \a$117 ;
  wire [9:0] \a$120 ;
  wire [7:0] \a$124 ;
  wire [7:0] \a$127 ;
  wire [8:0] \a$130 ;
  (* init = 19'h00000 *)
  wire [18:0] \a$134 ;
  (* init = 19'h00000 *)
  wire [18:0] \a$141 ;
  (* init = 19'h00000 *)
  wire [18:0] \a$148 ;
  (* init = 19'h00000 *)
  wire [18:0] \a$151 ;
  (* init = 19'h00000 *)
  wire [18:0] \a$154 ;
  (* init = 19'h00000 *)
  wire [18:0] \a$157 ;
  wire [7:0] \a$72 ;
  wire [8:0] \a$78 ;
  wire [8:0] \a$84 ;
  wire [8:0] \a$87 ;
  wire [9:0] \a$90 ;
  wire [8:0] \a$94 ;
  wire [8:0] \a$97 ;
  reg [18:0] acc0 = 19'h00000;
  reg [18:0] acc1 = 19'h00000;
  reg [18:0] acc2 = 19'h00000;
  reg [18:0] acc3 = 19'h00000;
  reg [18:0] acc4 = 19'h00000;
  reg [18:0] acc5 = 19'h00000;
  input [95:0] activations;
  wire [95:0] activations;
  wire [7:0] b;
  wire [9:0] \b$101 ;
  wire [8:0] \b$105 ;
  wire [8:0] \b$108 ;
  wire [9:0] \b$111 ;
  wire [8:0] \b$115 ;
  wire [8:0] \b$118 ;
  wire [9:0] \b$121 ;
  wire [7:0] \b$125 ;
  wire [7:0] \b$128 ;
  wire [8:0] \b$131 ;
  wire [18:0] \b$135 ;
  wire [18:0] \b$142 ;
  wire [18:0] \b$149 ;
  wire [18:0] \b$152 ;
  wire [18:0] \b$155 ;
  wire [18:0] \b$158 ;
  wire [7:0] \b$74 ;
  wire [8:0] \b$80 ;
  wire [8:0] \b$85 ;
  wire [8:0] \b$88 ;
  wire [9:0] \b$91 ;
  wire [8:0] \b$95 ;
  wire [8:0] \b$98 ;
  wire [7:0] c;
  wire [9:0] \c$102 ;
  wire [8:0] \c$106 ;
  wire [8:0] \c$109 ;
  wire [9:0] \c$112 ;
  wire [8:0] \c$116 ;
  wire [8:0] \c$119 ;
  wire [9:0] \c$122 ;
  wire [7:0] \c$126 ;
  wire [7:0] \c$129 ;
  wire [8:0] \c$132 ;
  wire [18:0] \c$136 ;
  wire [18:0] \c$143 ;
  wire [18:0] \c$150 ;
  wire [18:0] \c$153 ;
  wire [18:0] \c$156 ;
  wire [18:0] \c$159 ;
  wire [7:0] \c$76 ;
  wire [8:0] \c$82 ;
  wire [8:0] \c$86 ;
  wire [8:0] \c$89 ;
  wire [9:0] \c$92 ;
  wire [8:0] \c$96 ;
  wire [8:0] \c$99 ;
  input [75:0] chain_i;
  wire [75:0] chain_i;
  wire [18:0] \chain_i[0] ;
  wire [18:0] \chain_i[1] ;
  wire [18:0] \chain_i[2] ;
  wire [18:0] \chain_i[3] ;
  output [75:0] chain_o;
  reg [75:0] chain_o = 76'h0000000000000000000;
  wire [18:0] \chain_o[0] ;
  wire [18:0] \chain_o[1] ;
  wire [18:0] \chain_o[2] ;
  wire [18:0] \chain_o[3] ;
  input clk;
  wire clk;
  input [9:0] control;
  wire [9:0] control;
  wire \control.carried ;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire \control.unload ;
  wire [18:0] d;
  wire [18:0] \d$145 ;
  wire done;
  wire [47:0] lanes;
  wire [47:0] \lanes$69 ;
  wire [7:0] \lanes$69[0] ;
  wire [7:0] \lanes$69[1] ;
  wire [7:0] \lanes$69[2] ;
  wire [7:0] \lanes$69[3] ;
  wire [7:0] \lanes$69[4] ;
  wire [7:0] \lanes$69[5] ;
  wire [47:0] \lanes$71 ;
  wire [7:0] \lanes$71[0] ;
  wire [7:0] \lanes$71[1] ;
  wire [7:0] \lanes$71[2] ;
  wire [7:0] \lanes$71[3] ;
  wire [7:0] \lanes$71[4] ;
  wire [7:0] \lanes$71[5] ;
  wire [47:0] \lanes$73 ;
  wire [7:0] \lanes$73[0] ;
  wire [7:0] \lanes$73[1] ;
  wire [7:0] \lanes$73[2] ;
  wire [7:0] \lanes$73[3] ;
  wire [7:0] \lanes$73[4] ;
  wire [7:0] \lanes$73[5] ;
  wire [47:0] \lanes$75 ;
  wire [7:0] \lanes$75[0] ;
  wire [7:0] \lanes$75[1] ;
  wire [7:0] \lanes$75[2] ;
  wire [7:0] \lanes$75[3] ;
  wire [7:0] \lanes$75[4] ;
  wire [7:0] \lanes$75[5] ;
  wire [47:0] \lanes$77 ;
  wire [7:0] \lanes$77[0] ;
  wire [7:0] \lanes$77[1] ;
  wire [7:0] \lanes$77[2] ;
  wire [7:0] \lanes$77[3] ;
  wire [7:0] \lanes$77[4] ;
  wire [7:0] \lanes$77[5] ;
  wire [47:0] \lanes$79 ;
  wire [7:0] \lanes$79[0] ;
  wire [7:0] \lanes$79[1] ;
  wire [7:0] \lanes$79[2] ;
  wire [7:0] \lanes$79[3] ;
  wire [7:0] \lanes$79[4] ;
  wire [7:0] \lanes$79[5] ;
  wire [47:0] \lanes$81 ;
  wire [7:0] \lanes$81[0] ;
  wire [7:0] \lanes$81[1] ;
  wire [7:0] \lanes$81[2] ;
  wire [7:0] \lanes$81[3] ;
  wire [7:0] \lanes$81[4] ;
  wire [7:0] \lanes$81[5] ;
  wire [7:0] \lanes[0] ;
  wire [7:0] \lanes[1] ;
  wire [7:0] \lanes[2] ;
  wire [7:0] \lanes[3] ;
  wire [7:0] \lanes[4] ;
  wire [7:0] \lanes[5] ;
  wire [11:0] pixels;
  wire [11:0] \pixels$53 ;
  wire [2:0] \pixels$53[0] ;
  wire [2:0] \pixels$53[1] ;
  wire [2:0] \pixels$53[2] ;
  wire [2:0] \pixels$53[3] ;
  wire [11:0] \pixels$55 ;
  wire [2:0] \pixels$55[0] ;
  wire [2:0] \pixels$55[1] ;
  wire [2:0] \pixels$55[2] ;
  wire [2:0] \pixels$55[3] ;
  wire [11:0] \pixels$57 ;
  wire [2:0] \pixels$57[0] ;
  wire [2:0] \pixels$57[1] ;
  wire [2:0] \pixels$57[2] ;
  wire [2:0] \pixels$57[3] ;
  wire [11:0] \pixels$59 ;
  wire [2:0] \pixels$59[0] ;
  wire [2:0] \pixels$59[1] ;
  wire [2:0] \pixels$59[2] ;
  wire [2:0] \pixels$59[3] ;
  wire [11:0] \pixels$61 ;
  wire [2:0] \pixels$61[0] ;
  wire [2:0] \pixels$61[1] ;
  wire [2:0] \pixels$61[2] ;
  wire [2:0] \pixels$61[3] ;
  wire [11:0] \pixels$63 ;
  wire [2:0] \pixels$63[0] ;
  wire [2:0] \pixels$63[1] ;
  wire [2:0] \pixels$63[2] ;
  wire [2:0] \pixels$63[3] ;
  wire [11:0] \pixels$65 ;
  wire [2:0] \pixels$65[0] ;
  wire [2:0] \pixels$65[1] ;
  wire [2:0] \pixels$65[2] ;
  wire [2:0] \pixels$65[3] ;
  wire [2:0] \pixels[0] ;
  wire [2:0] \pixels[1] ;
  wire [2:0] \pixels[2] ;
  wire [2:0] \pixels[3] ;
  (* init = 76'h0000000000000000000 *)
  wire [75:0] result;
  wire [18:0] \result[0] ;
  wire [18:0] \result[1] ;
  wire [18:0] \result[2] ;
  wire [18:0] \result[3] ;
  input rst;
  wire rst;
  input shift;
  wire shift;
  reg [7:0] sum0_0 = 8'h00;
  reg [8:0] sum0_1 = 9'h000;
  reg [8:0] sum1_0 = 9'h000;
  reg [9:0] sum1_1 = 10'h000;
  reg [8:0] sum2_0 = 9'h000;
  reg [9:0] sum2_1 = 10'h000;
  reg [8:0] sum3_0 = 9'h000;
  reg [9:0] sum3_1 = 10'h000;
  reg [8:0] sum4_0 = 9'h000;
  reg [9:0] sum4_1 = 10'h000;
  reg [7:0] sum5_0 = 8'h00;
  reg [8:0] sum5_1 = 9'h000;
  wire [8:0] taps;
  wire [8:0] \taps$52 ;
  wire [2:0] \taps$52[0] ;
  wire [2:0] \taps$52[1] ;
  wire [2:0] \taps$52[2] ;
  wire [8:0] \taps$54 ;
  wire [2:0] \taps$54[0] ;
  wire [2:0] \taps$54[1] ;
  wire [2:0] \taps$54[2] ;
  wire [8:0] \taps$56 ;
  wire [2:0] \taps$56[0] ;
  wire [2:0] \taps$56[1] ;
  wire [2:0] \taps$56[2] ;
  wire [8:0] \taps$58 ;
  wire [2:0] \taps$58[0] ;
  wire [2:0] \taps$58[1] ;
  wire [2:0] \taps$58[2] ;
  wire [8:0] \taps$60 ;
  wire [2:0] \taps$60[0] ;
  wire [2:0] \taps$60[1] ;
  wire [2:0] \taps$60[2] ;
  wire [8:0] \taps$62 ;
  wire [2:0] \taps$62[0] ;
  wire [2:0] \taps$62[1] ;
  wire [2:0] \taps$62[2] ;
  wire [8:0] \taps$64 ;
  wire [2:0] \taps$64[0] ;
  wire [2:0] \taps$64[1] ;
  wire [2:0] \taps$64[2] ;
  wire [2:0] \taps[0] ;
  wire [2:0] \taps[1] ;
  wire [2:0] \taps[2] ;
  wire [7:0] total;
  wire [8:0] \total$103 ;
  wire [8:0] \total$113 ;
  wire [8:0] \total$123 ;
  wire [8:0] \total$13 ;
  wire [7:0] \total$133 ;
  wire [8:0] \total$15 ;
  wire [9:0] \total$17 ;
  wire [8:0] \total$19 ;
  wire [9:0] \total$21 ;
  wire [8:0] \total$23 ;
  wire [9:0] \total$25 ;
  wire [8:0] \total$27 ;
  wire [9:0] \total$29 ;
  wire [7:0] \total$31 ;
  wire [8:0] \total$33 ;
  wire [18:0] \total$35 ;
  wire [18:0] \total$37 ;
  wire [18:0] \total$39 ;
  wire [18:0] \total$41 ;
  wire [18:0] \total$43 ;
  wire [18:0] \total$45 ;
  wire [7:0] \total$83 ;
  wire [8:0] \total$93 ;
  input [71:0] weight;
  wire [71:0] weight;
  reg [71:0] \weight$8  = 72'h000000000000000000;
  wire [4:0] write__addr;
  wire [4:0] \write__addr$146 ;
  wire [18:0] write__data;
  wire [18:0] \write__data$161 ;
  wire write__en;
  wire \write__en$147 ;
  assign \$1  = control[0] & control[1];
  assign \$2  = control[0] & control[1];
  assign \$3  = control[0] & control[1];
  assign \$4  = control[0] & control[1];
  assign \$5  = control[0] & control[1];
  assign \$6  = control[0] & control[1];
  assign \$7  = done | shift;
  assign \$8  = done ? \total$37  : chain_i[37:19];
  assign \$9  = done ? \total$39  : chain_i[56:38];
  assign \$10  = done | shift;
  assign \$11  = \$10  | \$signal [9];
  assign \$12  = \$signal [9] ? \$signature__data  : chain_i[18:0];
  assign \$13  = done ? \total$35  : \$12 ;
  assign \$14  = \$signal [9] ? \$signature__data$49  : chain_i[75:57];
  assign \$15  = done ? \total$41  : \$14 ;
  assign done = \$signal [0] & \$signal [3];
  assign \$signature__addr  = \$signal [2] ? { 1'h0, \$signal [8:5] } : 5'h10;
  assign \$16  = ~ \$signal [4];
  assign \$17  = \$signal [2] & \$16 ;
  assign \$signature__addr$144  = \$17  ? { 1'h0, \$signal [8:5] } : 5'h10;
  always @(posedge clk)
    \weight$8  <= weight;
  always @(posedge clk)
    \$signal  <= \$18 ;
  always @(posedge clk)
    sum0_0 <= \$19 ;
  always @(posedge clk)
    sum0_1 <= \$20 ;
  always @(posedge clk)
    sum1_0 <= \$21 ;
  always @(posedge clk)
    sum1_1 <= \$22 ;
  always @(posedge clk)
    sum2_0 <= \$23 ;
  always @(posedge clk)
    sum2_1 <= \$24 ;
  always @(posedge clk)
    sum3_0 <= \$25 ;
  always @(posedge clk)
    sum3_1 <= \$26 ;
  always @(posedge clk)
    sum4_0 <= \$27 ;
  always @(posedge clk)
    sum4_1 <= \$28 ;
  always @(posedge clk)
    sum5_0 <= \$29 ;
  always @(posedge clk)
    sum5_1 <= \$30 ;
  always @(posedge clk)
    acc0 <= \$31 ;
  always @(posedge clk)
    acc1 <= \$32 ;
  always @(posedge clk)
    acc2 <= \$33 ;
  always @(posedge clk)
    acc3 <= \$34 ;
  always @(posedge clk)
    acc4 <= \$35 ;
  always @(posedge clk)
    acc5 <= \$36 ;
  always @(posedge clk)
    chain_o <= \$37 ;
  macram_add3 #(
    .WIDTH(32'd19),
    .XILINX(32'd0)
  ) accumulate0 (
    .a(acc0),
    .b({ sum0_0[7], sum0_0[7], sum0_0[7], sum0_0[7], sum0_0[7], sum0_0[7], sum0_0[7], sum0_0[7], sum0_0[7], sum0_0[7], sum0_0[7], sum0_0 }),
    .c({ sum0_1[8], sum0_1[8], sum0_1[8], sum0_1[8], sum0_1[8], sum0_1[8], sum0_1[8], sum0_1[8], sum0_1[8], sum0_1[8], sum0_1 }),
    .ci(1'h0),
    .d(\$signature__data ),
    .sum(\total$35 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd19),
    .XILINX(32'd0)
  ) accumulate1 (
    .a(acc1),
    .b({ sum1_0[8], sum1_0[8], sum1_0[8], sum1_0[8], sum1_0[8], sum1_0[8], sum1_0[8], sum1_0[8], sum1_0[8], sum1_0[8], sum1_0 }),
    .c({ sum1_1[9], sum1_1[9], sum1_1[9], sum1_1[9], sum1_1[9], sum1_1[9], sum1_1[9], sum1_1[9], sum1_1[9], sum1_1 }),
    .ci(1'h0),
    .d(\$signature__data$49 ),
    .sum(\total$37 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd19),
    .XILINX(32'd0)
  ) accumulate2 (
    .a(acc2),
    .b({ sum2_0[8], sum2_0[8], sum2_0[8], sum2_0[8], sum2_0[8], sum2_0[8], sum2_0[8], sum2_0[8], sum2_0[8], sum2_0[8], sum2_0 }),
    .c({ sum2_1[9], sum2_1[9], sum2_1[9], sum2_1[9], sum2_1[9], sum2_1[9], sum2_1[9], sum2_1[9], sum2_1[9], sum2_1 }),
    .ci(1'h0),
    .d(19'h00000),
    .sum(\total$39 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd19),
    .XILINX(32'd0)
  ) accumulate3 (
    .a(acc3),
    .b({ sum3_0[8], sum3_0[8], sum3_0[8], sum3_0[8], sum3_0[8], sum3_0[8], sum3_0[8], sum3_0[8], sum3_0[8], sum3_0[8], sum3_0 }),
    .c({ sum3_1[9], sum3_1[9], sum3_1[9], sum3_1[9], sum3_1[9], sum3_1[9], sum3_1[9], sum3_1[9], sum3_1[9], sum3_1 }),
    .ci(1'h0),
    .d(19'h00000),
    .sum(\total$41 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd19),
    .XILINX(32'd0)
  ) accumulate4 (
    .a(acc4),
    .b({ sum4_0[8], sum4_0[8], sum4_0[8], sum4_0[8], sum4_0[8], sum4_0[8], sum4_0[8], sum4_0[8], sum4_0[8], sum4_0[8], sum4_0 }),
    .c({ sum4_1[9], sum4_1[9], sum4_1[9], sum4_1[9], sum4_1[9], sum4_1[9], sum4_1[9], sum4_1[9], sum4_1[9], sum4_1 }),
    .ci(1'h0),
    .d(19'h00000),
    .sum(\total$43 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd19),
    .XILINX(32'd0)
  ) accumulate5 (
    .a(acc5),
    .b({ sum5_0[7], sum5_0[7], sum5_0[7], sum5_0[7], sum5_0[7], sum5_0[7], sum5_0[7], sum5_0[7], sum5_0[7], sum5_0[7], sum5_0[7], sum5_0 }),
    .c({ sum5_1[8], sum5_1[8], sum5_1[8], sum5_1[8], sum5_1[8], sum5_1[8], sum5_1[8], sum5_1[8], sum5_1[8], sum5_1[8], sum5_1 }),
    .ci(1'h0),
    .d(19'h00000),
    .sum(\total$45 ),
    .x(1'h0)
  );
  macram_lutram #(
    .ADDR_BITS(32'd5),
    .DEPTH(32'd17),
    .INIT_FILE(),
    .LANES(32'd1),
    .WIDTH(32'd19)
  ) carry0 (
    .clk(clk),
    .read_addr(\$signature__addr ),
    .read_data(\$signature__data ),
    .write_addr({ 1'h0, \$signal [8:5] }),
    .write_data(\total$43 ),
    .write_en(done)
  );
  macram_lutram #(
    .ADDR_BITS(32'd5),
    .DEPTH(32'd17),
    .INIT_FILE(),
    .LANES(32'd1),
    .WIDTH(32'd19)
  ) carry1 (
    .clk(clk),
    .read_addr(\$signature__addr$144 ),
    .read_data(\$signature__data$49 ),
    .write_addr({ 1'h0, \$signal [8:5] }),
    .write_data(\total$45 ),
    .write_en(done)
  );
  \macram_unit.engine0  engine0 (
    .clk(clk),
    .lanes(lanes),
    .\port$0$122 (activations[50:48]),
    .\port$0$146 (activations[74:72]),
    .\port$0$74 (activations[2:0]),
    .\port$0$98 (activations[26:24]),
    .rst(rst),
    .taps(\weight$8 [8:0])
  );
  \macram_unit.engine1  engine1 (
    .clk(clk),
    .lanes(\lanes$69 ),
    .\port$0$101 (activations[29:27]),
    .\port$0$125 (activations[53:51]),
    .\port$0$149 (activations[77:75]),
    .\port$0$77 (activations[5:3]),
    .rst(rst),
    .taps(\weight$8 [17:9])
  );
  \macram_unit.engine2  engine2 (
    .clk(clk),
    .lanes(\lanes$71 ),
    .\port$0$104 (activations[32:30]),
    .\port$0$128 (activations[56:54]),
    .\port$0$152 (activations[80:78]),
    .\port$0$80 (activations[8:6]),
    .rst(rst),
    .taps(\weight$8 [26:18])
  );
  \macram_unit.engine3  engine3 (
    .clk(clk),
    .lanes(\lanes$73 ),
    .\port$0$107 (activations[35:33]),
    .\port$0$131 (activations[59:57]),
    .\port$0$155 (activations[83:81]),
    .\port$0$83 (activations[11:9]),
    .rst(rst),
    .taps(\weight$8 [35:27])
  );
  \macram_unit.engine4  engine4 (
    .clk(clk),
    .lanes(\lanes$75 ),
    .\port$0$110 (activations[38:36]),
    .\port$0$134 (activations[62:60]),
    .\port$0$158 (activations[86:84]),
    .\port$0$86 (activations[14:12]),
    .rst(rst),
    .taps(\weight$8 [44:36])
  );
  \macram_unit.engine5  engine5 (
    .clk(clk),
    .lanes(\lanes$77 ),
    .\port$0$113 (activations[41:39]),
    .\port$0$137 (activations[65:63]),
    .\port$0$161 (activations[89:87]),
    .\port$0$89 (activations[17:15]),
    .rst(rst),
    .taps(\weight$8 [53:45])
  );
  \macram_unit.engine6  engine6 (
    .clk(clk),
    .lanes(\lanes$79 ),
    .\port$0$116 (activations[44:42]),
    .\port$0$140 (activations[68:66]),
    .\port$0$164 (activations[92:90]),
    .\port$0$92 (activations[20:18]),
    .rst(rst),
    .taps(\weight$8 [62:54])
  );
  \macram_unit.engine7  engine7 (
    .clk(clk),
    .lanes(\lanes$81 ),
    .\port$0$119 (activations[47:45]),
    .\port$0$143 (activations[71:69]),
    .\port$0$167 (activations[95:93]),
    .\port$0$95 (activations[23:21]),
    .rst(rst),
    .taps(\weight$8 [71:63])
  );
  macram_add3 #(
    .WIDTH(32'd9),
    .XILINX(32'd0)
  ) lane0_add1 (
    .a({ \lanes$79 [5], \lanes$79 [5], \lanes$79 [5], \lanes$79 [5:0] }),
    .b({ \lanes$81 [5], \lanes$81 [5], \lanes$81 [5], \lanes$81 [5:0] }),
    .c({ \total$83 [7], \total$83  }),
    .ci(1'h0),
    .d(9'h000),
    .sum(\total$13 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd8),
    .XILINX(32'd0)
  ) lane0_add3 (
    .a({ \lanes$73 [5], \lanes$73 [5], \lanes$73 [5:0] }),
    .b({ \lanes$75 [5], \lanes$75 [5], \lanes$75 [5:0] }),
    .c({ \lanes$77 [5], \lanes$77 [5], \lanes$77 [5:0] }),
    .ci(1'h0),
    .d(8'h00),
    .sum(total),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd8),
    .XILINX(32'd0)
  ) lane0_add5 (
    .a({ lanes[5], lanes[5], lanes[5:0] }),
    .b({ \lanes$69 [5], \lanes$69 [5], \lanes$69 [5:0] }),
    .c({ \lanes$71 [5], \lanes$71 [5], \lanes$71 [5:0] }),
    .ci(1'h0),
    .d(8'h00),
    .sum(\total$83 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd10),
    .XILINX(32'd0)
  ) lane1_add1 (
    .a({ \lanes$79 [14], \lanes$79 [14], \lanes$79 [14], \lanes$79 [14:8] }),
    .b({ \lanes$81 [14], \lanes$81 [14], \lanes$81 [14], \lanes$81 [14:8] }),
    .c({ \total$93 [8], \total$93  }),
    .ci(1'h0),
    .d(10'h000),
    .sum(\total$17 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd9),
    .XILINX(32'd0)
  ) lane1_add3 (
    .a({ \lanes$73 [14], \lanes$73 [14], \lanes$73 [14:8] }),
    .b({ \lanes$75 [14], \lanes$75 [14], \lanes$75 [14:8] }),
    .c({ \lanes$77 [14], \lanes$77 [14], \lanes$77 [14:8] }),
    .ci(1'h0),
    .d(9'h000),
    .sum(\total$15 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd9),
    .XILINX(32'd0)
  ) lane1_add5 (
    .a({ lanes[14], lanes[14], lanes[14:8] }),
    .b({ \lanes$69 [14], \lanes$69 [14], \lanes$69 [14:8] }),
    .c({ \lanes$71 [14], \lanes$71 [14], \lanes$71 [14:8] }),
    .ci(1'h0),
    .d(9'h000),
    .sum(\total$93 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd10),
    .XILINX(32'd0)
  ) lane2_add1 (
    .a({ \lanes$79 [23], \lanes$79 [23], \lanes$79 [23:16] }),
    .b({ \lanes$81 [23], \lanes$81 [23], \lanes$81 [23:16] }),
    .c({ \total$103 [8], \total$103  }),
    .ci(1'h0),
    .d(10'h000),
    .sum(\total$21 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd9),
    .XILINX(32'd0)
  ) lane2_add3 (
    .a({ \lanes$73 [23], \lanes$73 [23:16] }),
    .b({ \lanes$75 [23], \lanes$75 [23:16] }),
    .c({ \lanes$77 [23], \lanes$77 [23:16] }),
    .ci(1'h0),
    .d(9'h000),
    .sum(\total$19 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd9),
    .XILINX(32'd0)
  ) lane2_add5 (
    .a({ lanes[23], lanes[23:16] }),
    .b({ \lanes$69 [23], \lanes$69 [23:16] }),
    .c({ \lanes$71 [23], \lanes$71 [23:16] }),
    .ci(1'h0),
    .d(9'h000),
    .sum(\total$103 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd10),
    .XILINX(32'd0)
  ) lane3_add1 (
    .a({ \lanes$79 [31], \lanes$79 [31], \lanes$79 [31:24] }),
    .b({ \lanes$81 [31], \lanes$81 [31], \lanes$81 [31:24] }),
    .c({ \total$113 [8], \total$113  }),
    .ci(1'h0),
    .d(10'h000),
    .sum(\total$25 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd9),
    .XILINX(32'd0)
  ) lane3_add3 (
    .a({ \lanes$73 [31], \lanes$73 [31:24] }),
    .b({ \lanes$75 [31], \lanes$75 [31:24] }),
    .c({ \lanes$77 [31], \lanes$77 [31:24] }),
    .ci(1'h0),
    .d(9'h000),
    .sum(\total$23 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd9),
    .XILINX(32'd0)
  ) lane3_add5 (
    .a({ lanes[31], lanes[31:24] }),
    .b({ \lanes$69 [31], \lanes$69 [31:24] }),
    .c({ \lanes$71 [31], \lanes$71 [31:24] }),
    .ci(1'h0),
    .d(9'h000),
    .sum(\total$113 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd10),
    .XILINX(32'd0)
  ) lane4_add1 (
    .a({ \lanes$79 [38], \lanes$79 [38], \lanes$79 [38], \lanes$79 [38:32] }),
    .b({ \lanes$81 [38], \lanes$81 [38], \lanes$81 [38], \lanes$81 [38:32] }),
    .c({ \total$123 [8], \total$123  }),
    .ci(1'h0),
    .d(10'h000),
    .sum(\total$29 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd9),
    .XILINX(32'd0)
  ) lane4_add3 (
    .a({ \lanes$73 [38], \lanes$73 [38], \lanes$73 [38:32] }),
    .b({ \lanes$75 [38], \lanes$75 [38], \lanes$75 [38:32] }),
    .c({ \lanes$77 [38], \lanes$77 [38], \lanes$77 [38:32] }),
    .ci(1'h0),
    .d(9'h000),
    .sum(\total$27 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd9),
    .XILINX(32'd0)
  ) lane4_add5 (
    .a({ lanes[38], lanes[38], lanes[38:32] }),
    .b({ \lanes$69 [38], \lanes$69 [38], \lanes$69 [38:32] }),
    .c({ \lanes$71 [38], \lanes$71 [38], \lanes$71 [38:32] }),
    .ci(1'h0),
    .d(9'h000),
    .sum(\total$123 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd9),
    .XILINX(32'd0)
  ) lane5_add1 (
    .a({ \lanes$79 [45], \lanes$79 [45], \lanes$79 [45], \lanes$79 [45:40] }),
    .b({ \lanes$81 [45], \lanes$81 [45], \lanes$81 [45], \lanes$81 [45:40] }),
    .c({ \total$133 [7], \total$133  }),
    .ci(1'h0),
    .d(9'h000),
    .sum(\total$33 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd8),
    .XILINX(32'd0)
  ) lane5_add3 (
    .a({ \lanes$73 [45], \lanes$73 [45], \lanes$73 [45:40] }),
    .b({ \lanes$75 [45], \lanes$75 [45], \lanes$75 [45:40] }),
    .c({ \lanes$77 [45], \lanes$77 [45], \lanes$77 [45:40] }),
    .ci(1'h0),
    .d(8'h00),
    .sum(\total$31 ),
    .x(1'h0)
  );
  macram_add3 #(
    .WIDTH(32'd8),
    .XILINX(32'd0)
  ) lane5_add5 (
    .a({ lanes[45], lanes[45], lanes[45:40] }),
    .b({ \lanes$69 [45], \lanes$69 [45], \lanes$69 [45:40] }),
    .c({ \lanes$71 [45], \lanes$71 [45], \lanes$71 [45:40] }),
    .ci(1'h0),
    .d(8'h00),
    .sum(\total$133 ),
    .x(1'h0)
  );
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$18  = control;
    if (rst) begin
      \$18  = 10'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$19  = total;
    if (control[4]) begin
      \$19  = 8'h00;
    end
    if (rst) begin
      \$19  = 8'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$20  = \total$13 ;
    if (control[4]) begin
      \$20  = 9'h000;
    end
    if (rst) begin
      \$20  = 9'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$21  = \total$15 ;
    if (rst) begin
      \$21  = 9'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$22  = \total$17 ;
    if (rst) begin
      \$22  = 10'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$23  = \total$19 ;
    if (rst) begin
      \$23  = 9'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$24  = \total$21 ;
    if (rst) begin
      \$24  = 10'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$25  = \total$23 ;
    if (rst) begin
      \$25  = 9'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$26  = \total$25 ;
    if (rst) begin
      \$26  = 10'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$27  = \total$27 ;
    if (rst) begin
      \$27  = 9'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$28  = \total$29 ;
    if (rst) begin
      \$28  = 10'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$29  = \total$31 ;
    if (rst) begin
      \$29  = 8'h00;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$30  = \total$33 ;
    if (rst) begin
      \$30  = 9'h000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$31  = acc0;
    if (\$1 ) begin
      \$31  = 19'h00000;
    end else if (\$signal [0]) begin
      \$31  = \total$35 ;
    end
    if (rst) begin
      \$31  = 19'h00000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$32  = acc1;
    if (\$2 ) begin
      \$32  = 19'h00000;
    end else if (\$signal [0]) begin
      \$32  = \total$37 ;
    end
    if (rst) begin
      \$32  = 19'h00000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$33  = acc2;
    if (\$3 ) begin
      \$33  = 19'h00000;
    end else if (\$signal [0]) begin
      \$33  = \total$39 ;
    end
    if (rst) begin
      \$33  = 19'h00000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$34  = acc3;
    if (\$4 ) begin
      \$34  = 19'h00000;
    end else if (\$signal [0]) begin
      \$34  = \total$41 ;
    end
    if (rst) begin
      \$34  = 19'h00000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$35  = acc4;
    if (\$5 ) begin
      \$35  = 19'h00000;
    end else if (\$signal [0]) begin
      \$35  = \total$43 ;
    end
    if (rst) begin
      \$35  = 19'h00000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$36  = acc5;
    if (\$6 ) begin
      \$36  = 19'h00000;
    end else if (\$signal [0]) begin
      \$36  = \total$45 ;
    end
    if (rst) begin
      \$36  = 19'h00000;
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$37  = chain_o;
    if (\$7 ) begin
      \$37 [37:19] = \$8 ;
      \$37 [56:38] = \$9 ;
    end
    if (\$11 ) begin
      \$37 [18:0] = \$13 ;
      \$37 [75:57] = \$15 ;
    end
  end
  assign result = chain_o;
  assign taps = \weight$8 [8:0];
  assign pixels = { activations[74:72], activations[50:48], activations[26:24], activations[2:0] };
  assign \taps$52  = \weight$8 [17:9];
  assign \pixels$53  = { activations[77:75], activations[53:51], activations[29:27], activations[5:3] };
  assign \taps$54  = \weight$8 [26:18];
  assign \pixels$55  = { activations[80:78], activations[56:54], activations[32:30], activations[8:6] };
  assign \taps$56  = \weight$8 [35:27];
  assign \pixels$57  = { activations[83:81], activations[59:57], activations[35:33], activations[11:9] };
  assign \taps$58  = \weight$8 [44:36];
  assign \pixels$59  = { activations[86:84], activations[62:60], activations[38:36], activations[14:12] };
  assign \taps$60  = \weight$8 [53:45];
  assign \pixels$61  = { activations[89:87], activations[65:63], activations[41:39], activations[17:15] };
  assign \taps$62  = \weight$8 [62:54];
  assign \pixels$63  = { activations[92:90], activations[68:66], activations[44:42], activations[20:18] };
  assign \taps$64  = \weight$8 [71:63];
  assign \pixels$65  = { activations[95:93], activations[71:69], activations[47:45], activations[23:21] };
  assign a = { lanes[5], lanes[5], lanes[5:0] };
  assign b = { \lanes$69 [5], \lanes$69 [5], \lanes$69 [5:0] };
  assign c = { \lanes$71 [5], \lanes$71 [5], \lanes$71 [5:0] };
  assign \a$72  = { \lanes$73 [5], \lanes$73 [5], \lanes$73 [5:0] };
  assign \b$74  = { \lanes$75 [5], \lanes$75 [5], \lanes$75 [5:0] };
  assign \c$76  = { \lanes$77 [5], \lanes$77 [5], \lanes$77 [5:0] };
  assign \a$78  = { \lanes$79 [5], \lanes$79 [5], \lanes$79 [5], \lanes$79 [5:0] };
  assign \b$80  = { \lanes$81 [5], \lanes$81 [5], \lanes$81 [5], \lanes$81 [5:0] };
  assign \c$82  = { \total$83 [7], \total$83  };
  assign \a$84  = { lanes[14], lanes[14], lanes[14:8] };
  assign \b$85  = { \lanes$69 [14], \lanes$69 [14], \lanes$69 [14:8] };
  assign \c$86  = { \lanes$71 [14], \lanes$71 [14], \lanes$71 [14:8] };
  assign \a$87  = { \lanes$73 [14], \lanes$73 [14], \lanes$73 [14:8] };
  assign \b$88  = { \lanes$75 [14], \lanes$75 [14], \lanes$75 [14:8] };
  assign \c$89  = { \lanes$77 [14], \lanes$77 [14], \lanes$77 [14:8] };
  assign \a$90  = { \lanes$79 [14], \lanes$79 [14], \lanes$79 [14], \lanes$79 [14:8] };
  assign \b$91  = { \lanes$81 [14], \lanes$81 [14], \lanes$81 [14], \lanes$81 [14:8] };
  assign \c$92  = { \total$93 [8], \total$93  };
  assign \a$94  = { lanes[23], lanes[23:16] };
  assign \b$95  = { \lanes$69 [23], \lanes$69 [23:16] };
  assign \c$96  = { \lanes$71 [23], \lanes$71 [23:16] };
  assign \a$97  = { \lanes$73 [23], \lanes$73 [23:16] };
  assign \b$98  = { \lanes$75 [23], \lanes$75 [23:16] };
  assign \c$99  = { \lanes$77 [23], \lanes$77 [23:16] };
  assign \a$100  = { \lanes$79 [23], \lanes$79 [23], \lanes$79 [23:16] };
  assign \b$101  = { \lanes$81 [23], \lanes$81 [23], \lanes$81 [23:16] };
  assign \c$102  = { \total$103 [8], \total$103  };
  assign \a$104  = { lanes[31], lanes[31:24] };
  assign \b$105  = { \lanes$69 [31], \lanes$69 [31:24] };
  assign \c$106  = { \lanes$71 [31], \lanes$71 [31:24] };
  assign \a$107  = { \lanes$73 [31], \lanes$73 [31:24] };
  assign \b$108  = { \lanes$75 [31], \lanes$75 [31:24] };
  assign \c$109  = { \lanes$77 [31], \lanes$77 [31:24] };
  assign \a$110  = { \lanes$79 [31], \lanes$79 [31], \lanes$79 [31:24] };
  assign \b$111  = { \lanes$81 [31], \lanes$81 [31], \lanes$81 [31:24] };
  assign \c$112  = { \total$113 [8], \total$113  };
  assign \a$114  = { lanes[38], lanes[38], lanes[38:32] };
  assign \b$115  = { \lanes$69 [38], \lanes$69 [38], \lanes$69 [38:32] };
  assign \c$116  = { \lanes$71 [38], \lanes$71 [38], \lanes$71 [38:32] };
  assign \a$117  = { \lanes$73 [38], \lanes$73 [38], \lanes$73 [38:32] };
  assign \b$118  = { \lanes$75 [38], \lanes$75 [38], \lanes$75 [38:32] };
  assign \c$119  = { \lanes$77 [38], \lanes$77 [38], \lanes$77 [38:32] };
  assign \a$120  = { \lanes$79 [38], \lanes$79 [38], \lanes$79 [38], \lanes$79 [38:32] };
  assign \b$121  = { \lanes$81 [38], \lanes$81 [38], \lanes$81 [38], \lanes$81 [38:32] };
  assign \c$122  = { \total$123 [8], \total$123  };
  assign \a$124  = { lanes[45], lanes[45], lanes[45:40] };
  assign \b$125  = { \lanes$69 [45], \lanes$69 [45], \lanes$69 [45:40] };
  assign \c$126  = { \lanes$71 [45], \lanes$71 [45], \lanes$71 [45:40] };
  assign \a$127  = { \lanes$73 [45], \lanes$73 [45], \lanes$73 [45:40] };
  assign \b$128  = { \lanes$75 [45], \lanes$75 [45], \lanes$75 [45:40] };
  assign \c$129  = { \lanes$77 [45], \lanes$77 [45], \lanes$77 [45:40] };
  assign \a$130  = { \lanes$79 [45], \lanes$79 [45], \lanes$79 [45], \lanes$79 [45:40] };
  assign \b$131  = { \lanes$81 [45], \lanes$81 [45], \lanes$81 [45], \lanes$81 [45:40] };
  assign \c$132  = { \total$133 [7], \total$133  };
  assign \a$134  = acc0;
  assign \b$135  = { sum0_0[7], sum0_0[7], sum0_0[7], sum0_0[7], sum0_0[7], sum0_0[7], sum0_0[7], sum0_0[7], sum0_0[7], sum0_0[7], sum0_0[7], sum0_0 };
  assign \c$136  = { sum0_1[8], sum0_1[8], sum0_1[8], sum0_1[8], sum0_1[8], sum0_1[8], sum0_1[8], sum0_1[8], sum0_1[8], sum0_1[8], sum0_1 };
  assign d = \$signature__data ;
  assign write__addr = { 1'h0, \$signal [8:5] };
  assign write__en = done;
  assign \a$141  = acc1;
  assign \b$142  = { sum1_0[8], sum1_0[8], sum1_0[8], sum1_0[8], sum1_0[8], sum1_0[8], sum1_0[8], sum1_0[8], sum1_0[8], sum1_0[8], sum1_0 };
  assign \c$143  = { sum1_1[9], sum1_1[9], sum1_1[9], sum1_1[9], sum1_1[9], sum1_1[9], sum1_1[9], sum1_1[9], sum1_1[9], sum1_1 };
  assign \d$145  = \$signature__data$49 ;
  assign \write__addr$146  = { 1'h0, \$signal [8:5] };
  assign \write__en$147  = done;
  assign \a$148  = acc2;
  assign \b$149  = { sum2_0[8], sum2_0[8], sum2_0[8], sum2_0[8], sum2_0[8], sum2_0[8], sum2_0[8], sum2_0[8], sum2_0[8], sum2_0[8], sum2_0 };
  assign \c$150  = { sum2_1[9], sum2_1[9], sum2_1[9], sum2_1[9], sum2_1[9], sum2_1[9], sum2_1[9], sum2_1[9], sum2_1[9], sum2_1 };
  assign \a$151  = acc3;
  assign \b$152  = { sum3_0[8], sum3_0[8], sum3_0[8], sum3_0[8], sum3_0[8], sum3_0[8], sum3_0[8], sum3_0[8], sum3_0[8], sum3_0[8], sum3_0 };
  assign \c$153  = { sum3_1[9], sum3_1[9], sum3_1[9], sum3_1[9], sum3_1[9], sum3_1[9], sum3_1[9], sum3_1[9], sum3_1[9], sum3_1 };
  assign \a$154  = acc4;
  assign \b$155  = { sum4_0[8], sum4_0[8], sum4_0[8], sum4_0[8], sum4_0[8], sum4_0[8], sum4_0[8], sum4_0[8], sum4_0[8], sum4_0[8], sum4_0 };
  assign \c$156  = { sum4_1[9], sum4_1[9], sum4_1[9], sum4_1[9], sum4_1[9], sum4_1[9], sum4_1[9], sum4_1[9], sum4_1[9], sum4_1 };
  assign \a$157  = acc5;
  assign \b$158  = { sum5_0[7], sum5_0[7], sum5_0[7], sum5_0[7], sum5_0[7], sum5_0[7], sum5_0[7], sum5_0[7], sum5_0[7], sum5_0[7], sum5_0[7], sum5_0 };
  assign \c$159  = { sum5_1[8], sum5_1[8], sum5_1[8], sum5_1[8], sum5_1[8], sum5_1[8], sum5_1[8], sum5_1[8], sum5_1[8], sum5_1[8], sum5_1 };
  assign write__data = \total$43 ;
  assign \write__data$161  = \total$45 ;
  assign \control.en  = control[0];
  assign \control.first  = control[1];
  assign \control.carried  = control[2];
  assign \control.last  = control[3];
  assign \control.edge  = control[4];
  assign \control.tile  = control[8:5];
  assign \control.unload  = control[9];
  assign \chain_i[0]  = chain_i[18:0];
  assign \chain_i[1]  = chain_i[37:19];
  assign \chain_i[2]  = chain_i[56:38];
  assign \chain_i[3]  = chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \$signal.en  = \$signal [0];
  assign \$signal.first  = \$signal [1];
  assign \$signal.carried  = \$signal [2];
  assign \$signal.last  = \$signal [3];
  assign \$signal.edge  = \$signal [4];
  assign \$signal.tile  = \$signal [8:5];
  assign \$signal.unload  = \$signal [9];
  assign \result[0]  = chain_o[18:0];
  assign \result[1]  = chain_o[37:19];
  assign \result[2]  = chain_o[56:38];
  assign \result[3]  = chain_o[75:57];
  assign \taps[0]  = \weight$8 [2:0];
  assign \taps[1]  = \weight$8 [5:3];
  assign \taps[2]  = \weight$8 [8:6];
  assign \pixels[0]  = activations[2:0];
  assign \pixels[1]  = activations[26:24];
  assign \pixels[2]  = activations[50:48];
  assign \pixels[3]  = activations[74:72];
  assign \taps$52[0]  = \weight$8 [11:9];
  assign \taps$52[1]  = \weight$8 [14:12];
  assign \taps$52[2]  = \weight$8 [17:15];
  assign \pixels$53[0]  = activations[5:3];
  assign \pixels$53[1]  = activations[29:27];
  assign \pixels$53[2]  = activations[53:51];
  assign \pixels$53[3]  = activations[77:75];
  assign \taps$54[0]  = \weight$8 [20:18];
  assign \taps$54[1]  = \weight$8 [23:21];
  assign \taps$54[2]  = \weight$8 [26:24];
  assign \pixels$55[0]  = activations[8:6];
  assign \pixels$55[1]  = activations[32:30];
  assign \pixels$55[2]  = activations[56:54];
  assign \pixels$55[3]  = activations[80:78];
  assign \taps$56[0]  = \weight$8 [29:27];
  assign \taps$56[1]  = \weight$8 [32:30];
  assign \taps$56[2]  = \weight$8 [35:33];
  assign \pixels$57[0]  = activations[11:9];
  assign \pixels$57[1]  = activations[35:33];
  assign \pixels$57[2]  = activations[59:57];
  assign \pixels$57[3]  = activations[83:81];
  assign \taps$58[0]  = \weight$8 [38:36];
  assign \taps$58[1]  = \weight$8 [41:39];
  assign \taps$58[2]  = \weight$8 [44:42];
  assign \pixels$59[0]  = activations[14:12];
  assign \pixels$59[1]  = activations[38:36];
  assign \pixels$59[2]  = activations[62:60];
  assign \pixels$59[3]  = activations[86:84];
  assign \taps$60[0]  = \weight$8 [47:45];
  assign \taps$60[1]  = \weight$8 [50:48];
  assign \taps$60[2]  = \weight$8 [53:51];
  assign \pixels$61[0]  = activations[17:15];
  assign \pixels$61[1]  = activations[41:39];
  assign \pixels$61[2]  = activations[65:63];
  assign \pixels$61[3]  = activations[89:87];
  assign \taps$62[0]  = \weight$8 [56:54];
  assign \taps$62[1]  = \weight$8 [59:57];
  assign \taps$62[2]  = \weight$8 [62:60];
  assign \pixels$63[0]  = activations[20:18];
  assign \pixels$63[1]  = activations[44:42];
  assign \pixels$63[2]  = activations[68:66];
  assign \pixels$63[3]  = activations[92:90];
  assign \taps$64[0]  = \weight$8 [65:63];
  assign \taps$64[1]  = \weight$8 [68:66];
  assign \taps$64[2]  = \weight$8 [71:69];
  assign \pixels$65[0]  = activations[23:21];
  assign \pixels$65[1]  = activations[47:45];
  assign \pixels$65[2]  = activations[71:69];
  assign \pixels$65[3]  = activations[95:93];
  assign \lanes[0]  = lanes[7:0];
  assign \lanes[1]  = lanes[15:8];
  assign \lanes[2]  = lanes[23:16];
  assign \lanes[3]  = lanes[31:24];
  assign \lanes[4]  = lanes[39:32];
  assign \lanes[5]  = lanes[47:40];
  assign \lanes$69[0]  = \lanes$69 [7:0];
  assign \lanes$69[1]  = \lanes$69 [15:8];
  assign \lanes$69[2]  = \lanes$69 [23:16];
  assign \lanes$69[3]  = \lanes$69 [31:24];
  assign \lanes$69[4]  = \lanes$69 [39:32];
  assign \lanes$69[5]  = \lanes$69 [47:40];
  assign \lanes$71[0]  = \lanes$71 [7:0];
  assign \lanes$71[1]  = \lanes$71 [15:8];
  assign \lanes$71[2]  = \lanes$71 [23:16];
  assign \lanes$71[3]  = \lanes$71 [31:24];
  assign \lanes$71[4]  = \lanes$71 [39:32];
  assign \lanes$71[5]  = \lanes$71 [47:40];
  assign \lanes$73[0]  = \lanes$73 [7:0];
  assign \lanes$73[1]  = \lanes$73 [15:8];
  assign \lanes$73[2]  = \lanes$73 [23:16];
  assign \lanes$73[3]  = \lanes$73 [31:24];
  assign \lanes$73[4]  = \lanes$73 [39:32];
  assign \lanes$73[5]  = \lanes$73 [47:40];
  assign \lanes$75[0]  = \lanes$75 [7:0];
  assign \lanes$75[1]  = \lanes$75 [15:8];
  assign \lanes$75[2]  = \lanes$75 [23:16];
  assign \lanes$75[3]  = \lanes$75 [31:24];
  assign \lanes$75[4]  = \lanes$75 [39:32];
  assign \lanes$75[5]  = \lanes$75 [47:40];
  assign \lanes$77[0]  = \lanes$77 [7:0];
  assign \lanes$77[1]  = \lanes$77 [15:8];
  assign \lanes$77[2]  = \lanes$77 [23:16];
  assign \lanes$77[3]  = \lanes$77 [31:24];
  assign \lanes$77[4]  = \lanes$77 [39:32];
  assign \lanes$77[5]  = \lanes$77 [47:40];
  assign \lanes$79[0]  = \lanes$79 [7:0];
  assign \lanes$79[1]  = \lanes$79 [15:8];
  assign \lanes$79[2]  = \lanes$79 [23:16];
  assign \lanes$79[3]  = \lanes$79 [31:24];
  assign \lanes$79[4]  = \lanes$79 [39:32];
  assign \lanes$79[5]  = \lanes$79 [47:40];
  assign \lanes$81[0]  = \lanes$81 [7:0];
  assign \lanes$81[1]  = \lanes$81 [15:8];
  assign \lanes$81[2]  = \lanes$81 [23:16];
  assign \lanes$81[3]  = \lanes$81 [31:24];
  assign \lanes$81[4]  = \lanes$81 [39:32];
  assign \lanes$81[5]  = \lanes$81 [47:40];
endmodule

module \macram_unit.engine0 (\port$0$98 , \port$0$122 , \port$0$146 , clk, rst, taps, lanes, \port$0$74 );
  reg \$auto$verilog_backend.cc:2355:dump_module$2  = 0;
  wire [5:0] \$1 ;
  wire [5:0] \$10 ;
  wire [5:0] \$11 ;
  wire [6:0] \$12 ;
  wire [5:0] \$13 ;
  wire [7:0] \$14 ;
  wire [5:0] \$15 ;
  wire [5:0] \$16 ;
  wire [6:0] \$17 ;
  wire [5:0] \$18 ;
  reg [47:0] \$19 ;
  wire [5:0] \$2 ;
  wire [5:0] \$3 ;
  wire [6:0] \$4 ;
  wire [5:0] \$5 ;
  wire [5:0] \$6 ;
  wire [6:0] \$7 ;
  wire [5:0] \$8 ;
  wire [7:0] \$9 ;
  input clk;
  wire clk;
  output [47:0] lanes;
  reg [47:0] lanes = 48'h000000000000;
  wire [7:0] \lanes[0] ;
  wire [7:0] \lanes[1] ;
  wire [7:0] \lanes[2] ;
  wire [7:0] \lanes[3] ;
  wire [7:0] \lanes[4] ;
  wire [7:0] \lanes[5] ;
  wire [11:0] pixels;
  wire [2:0] \pixels[0] ;
  wire [2:0] \pixels[1] ;
  wire [2:0] \pixels[2] ;
  wire [2:0] \pixels[3] ;
  input [2:0] \port$0$122 ;
  wire [2:0] \port$0$122 ;
  input [2:0] \port$0$146 ;
  wire [2:0] \port$0$146 ;
  input [2:0] \port$0$74 ;
  wire [2:0] \port$0$74 ;
  input [2:0] \port$0$98 ;
  wire [2:0] \port$0$98 ;
  input rst;
  wire rst;
  input [8:0] taps;
  wire [8:0] taps;
  wire [2:0] \taps[0] ;
  wire [2:0] \taps[1] ;
  wire [2:0] \taps[2] ;
  assign \$1  = $signed({ 1'h0, \port$0$74  }) * $signed(taps[2:0]);
  assign \$2  = $signed({ 1'h0, \port$0$98  }) * $signed(taps[2:0]);
  assign \$3  = $signed({ 1'h0, \port$0$74  }) * $signed(taps[5:3]);
  assign \$4  = $signed(\$2 ) + $signed(\$3 );
  assign \$5  = $signed({ 1'h0, \port$0$122  }) * $signed(taps[2:0]);
  assign \$6  = $signed({ 1'h0, \port$0$98  }) * $signed(taps[5:3]);
  assign \$7  = $signed(\$5 ) + $signed(\$6 );
  assign \$8  = $signed({ 1'h0, \port$0$74  }) * $signed(taps[8:6]);
  assign \$9  = $signed(\$7 ) + $signed(\$8 );
  assign \$10  = $signed({ 1'h0, \port$0$146  }) * $signed(taps[2:0]);
  assign \$11  = $signed({ 1'h0, \port$0$122  }) * $signed(taps[5:3]);
  assign \$12  = $signed(\$10 ) + $signed(\$11 );
  assign \$13  = $signed({ 1'h0, \port$0$98  }) * $signed(taps[8:6]);
  assign \$14  = $signed(\$12 ) + $signed(\$13 );
  assign \$15  = $signed({ 1'h0, \port$0$146  }) * $signed(taps[5:3]);
  assign \$16  = $signed({ 1'h0, \port$0$122  }) * $signed(taps[8:6]);
  assign \$17  = $signed(\$15 ) + $signed(\$16 );
  assign \$18  = $signed({ 1'h0, \port$0$146  }) * $signed(taps[8:6]);
  always @(posedge clk)
    lanes <= \$19 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$2 ) begin end
    \$19 [7:0] = { \$1 [5], \$1 [5], \$1  };
    \$19 [15:8] = { \$4 [6], \$4  };
    \$19 [23:16] = \$9 ;
    \$19 [31:24] = \$14 ;
    \$19 [39:32] = { \$17 [6], \$17  };
    \$19 [47:40] = { \$18 [5], \$18 [5], \$18  };
    if (rst) begin
      \$19  = 48'h000000000000;
    end
  end
  assign pixels = { \port$0$146 , \port$0$122 , \port$0$98 , \port$0$74  };
  assign \lanes[0]  = lanes[7:0];
  assign \lanes[1]  = lanes[15:8];
  assign \lanes[2]  = lanes[23:16];
  assign \lanes[3]  = lanes[31:24];
  assign \lanes[4]  = lanes[39:32];
  assign \lanes[5]  = lanes[47:40];
  assign \pixels[0]  = \port$0$74 ;
  assign \pixels[1]  = \port$0$98 ;
  assign \pixels[2]  = \port$0$122 ;
  assign \pixels[3]  = \port$0$146 ;
  assign \taps[0]  = taps[2:0];
  assign \taps[1]  = taps[5:3];
  assign \taps[2]  = taps[8:6];
endmodule

module \macram_unit.engine1 (\port$0$101 , \port$0$125 , \port$0$149 , clk, rst, taps, lanes, \port$0$77 );
  reg \$auto$verilog_backend.cc:2355:dump_module$3  = 0;
  wire [5:0] \$1 ;
  wire [5:0] \$10 ;
  wire [5:0] \$11 ;
  wire [6:0] \$12 ;
  wire [5:0] \$13 ;
  wire [7:0] \$14 ;
  wire [5:0] \$15 ;
  wire [5:0] \$16 ;
  wire [6:0] \$17 ;
  wire [5:0] \$18 ;
  reg [47:0] \$19 ;
  wire [5:0] \$2 ;
  wire [5:0] \$3 ;
  wire [6:0] \$4 ;
  wire [5:0] \$5 ;
  wire [5:0] \$6 ;
  wire [6:0] \$7 ;
  wire [5:0] \$8 ;
  wire [7:0] \$9 ;
  input clk;
  wire clk;
  output [47:0] lanes;
  reg [47:0] lanes = 48'h000000000000;
  wire [7:0] \lanes[0] ;
  wire [7:0] \lanes[1] ;
  wire [7:0] \lanes[2] ;
  wire [7:0] \lanes[3] ;
  wire [7:0] \lanes[4] ;
  wire [7:0] \lanes[5] ;
  wire [11:0] pixels;
  wire [2:0] \pixels[0] ;
  wire [2:0] \pixels[1] ;
  wire [2:0] \pixels[2] ;
  wire [2:0] \pixels[3] ;
  input [2:0] \port$0$101 ;
  wire [2:0] \port$0$101 ;
  input [2:0] \port$0$125 ;
  wire [2:0] \port$0$125 ;
  input [2:0] \port$0$149 ;
  wire [2:0] \port$0$149 ;
  input [2:0] \port$0$77 ;
  wire [2:0] \port$0$77 ;
  input rst;
  wire rst;
  input [8:0] taps;
  wire [8:0] taps;
  wire [2:0] \taps[0] ;
  wire [2:0] \taps[1] ;
  wire [2:0] \taps[2] ;
  assign \$1  = $signed({ 1'h0, \port$0$77  }) * $signed(taps[2:0]);
  assign \$2  = $signed({ 1'h0, \port$0$101  }) * $signed(taps[2:0]);
  assign \$3  = $signed({ 1'h0, \port$0$77  }) * $signed(taps[5:3]);
  assign \$4  = $signed(\$2 ) + $signed(\$3 );
  assign \$5  = $signed({ 1'h0, \port$0$125  }) * $signed(taps[2:0]);
  assign \$6  = $signed({ 1'h0, \port$0$101  }) * $signed(taps[5:3]);
  assign \$7  = $signed(\$5 ) + $signed(\$6 );
  assign \$8  = $signed({ 1'h0, \port$0$77  }) * $signed(taps[8:6]);
  assign \$9  = $signed(\$7 ) + $signed(\$8 );
  assign \$10  = $signed({ 1'h0, \port$0$149  }) * $signed(taps[2:0]);
  assign \$11  = $signed({ 1'h0, \port$0$125  }) * $signed(taps[5:3]);
  assign \$12  = $signed(\$10 ) + $signed(\$11 );
  assign \$13  = $signed({ 1'h0, \port$0$101  }) * $signed(taps[8:6]);
  assign \$14  = $signed(\$12 ) + $signed(\$13 );
  assign \$15  = $signed({ 1'h0, \port$0$149  }) * $signed(taps[5:3]);
  assign \$16  = $signed({ 1'h0, \port$0$125  }) * $signed(taps[8:6]);
  assign \$17  = $signed(\$15 ) + $signed(\$16 );
  assign \$18  = $signed({ 1'h0, \port$0$149  }) * $signed(taps[8:6]);
  always @(posedge clk)
    lanes <= \$19 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$3 ) begin end
    \$19 [7:0] = { \$1 [5], \$1 [5], \$1  };
    \$19 [15:8] = { \$4 [6], \$4  };
    \$19 [23:16] = \$9 ;
    \$19 [31:24] = \$14 ;
    \$19 [39:32] = { \$17 [6], \$17  };
    \$19 [47:40] = { \$18 [5], \$18 [5], \$18  };
    if (rst) begin
      \$19  = 48'h000000000000;
    end
  end
  assign pixels = { \port$0$149 , \port$0$125 , \port$0$101 , \port$0$77  };
  assign \lanes[0]  = lanes[7:0];
  assign \lanes[1]  = lanes[15:8];
  assign \lanes[2]  = lanes[23:16];
  assign \lanes[3]  = lanes[31:24];
  assign \lanes[4]  = lanes[39:32];
  assign \lanes[5]  = lanes[47:40];
  assign \pixels[0]  = \port$0$77 ;
  assign \pixels[1]  = \port$0$101 ;
  assign \pixels[2]  = \port$0$125 ;
  assign \pixels[3]  = \port$0$149 ;
  assign \taps[0]  = taps[2:0];
  assign \taps[1]  = taps[5:3];
  assign \taps[2]  = taps[8:6];
endmodule

module \macram_unit.engine2 (\port$0$104 , \port$0$128 , \port$0$152 , clk, rst, taps, lanes, \port$0$80 );
  reg \$auto$verilog_backend.cc:2355:dump_module$4  = 0;
  wire [5:0] \$1 ;
  wire [5:0] \$10 ;
  wire [5:0] \$11 ;
  wire [6:0] \$12 ;
  wire [5:0] \$13 ;
  wire [7:0] \$14 ;
  wire [5:0] \$15 ;
  wire [5:0] \$16 ;
  wire [6:0] \$17 ;
  wire [5:0] \$18 ;
  reg [47:0] \$19 ;
  wire [5:0] \$2 ;
  wire [5:0] \$3 ;
  wire [6:0] \$4 ;
  wire [5:0] \$5 ;
  wire [5:0] \$6 ;
  wire [6:0] \$7 ;
  wire [5:0] \$8 ;
  wire [7:0] \$9 ;
  input clk;
  wire clk;
  output [47:0] lanes;
  reg [47:0] lanes = 48'h000000000000;
  wire [7:0] \lanes[0] ;
  wire [7:0] \lanes[1] ;
  wire [7:0] \lanes[2] ;
  wire [7:0] \lanes[3] ;
  wire [7:0] \lanes[4] ;
  wire [7:0] \lanes[5] ;
  wire [11:0] pixels;
  wire [2:0] \pixels[0] ;
  wire [2:0] \pixels[1] ;
  wire [2:0] \pixels[2] ;
  wire [2:0] \pixels[3] ;
  input [2:0] \port$0$104 ;
  wire [2:0] \port$0$104 ;
  input [2:0] \port$0$128 ;
  wire [2:0] \port$0$128 ;
  input [2:0] \port$0$152 ;
  wire [2:0] \port$0$152 ;
  input [2:0] \port$0$80 ;
  wire [2:0] \port$0$80 ;
  input rst;
  wire rst;
  input [8:0] taps;
  wire [8:0] taps;
  wire [2:0] \taps[0] ;
  wire [2:0] \taps[1] ;
  wire [2:0] \taps[2] ;
  assign \$1  = $signed({ 1'h0, \port$0$80  }) * $signed(taps[2:0]);
  assign \$2  = $signed({ 1'h0, \port$0$104  }) * $signed(taps[2:0]);
  assign \$3  = $signed({ 1'h0, \port$0$80  }) * $signed(taps[5:3]);
  assign \$4  = $signed(\$2 ) + $signed(\$3 );
  assign \$5  = $signed({ 1'h0, \port$0$128  }) * $signed(taps[2:0]);
  assign \$6  = $signed({ 1'h0, \port$0$104  }) * $signed(taps[5:3]);
  assign \$7  = $signed(\$5 ) + $signed(\$6 );
  assign \$8  = $signed({ 1'h0, \port$0$80  }) * $signed(taps[8:6]);
  assign \$9  = $signed(\$7 ) + $signed(\$8 );
  assign \$10  = $signed({ 1'h0, \port$0$152  }) * $signed(taps[2:0]);
  assign \$11  = $signed({ 1'h0, \port$0$128  }) * $signed(taps[5:3]);
  assign \$12  = $signed(\$10 ) + $signed(\$11 );
  assign \$13  = $signed({ 1'h0, \port$0$104  }) * $signed(taps[8:6]);
  assign \$14  = $signed(\$12 ) + $signed(\$13 );
  assign \$15  = $signed({ 1'h0, \port$0$152  }) * $signed(taps[5:3]);
  assign \$16  = $signed({ 1'h0, \port$0$128  }) * $signed(taps[8:6]);
  assign \$17  = $signed(\$15 ) + $signed(\$16 );
  assign \$18  = $signed({ 1'h0, \port$0$152  }) * $signed(taps[8:6]);
  always @(posedge clk)
    lanes <= \$19 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$4 ) begin end
    \$19 [7:0] = { \$1 [5], \$1 [5], \$1  };
    \$19 [15:8] = { \$4 [6], \$4  };
    \$19 [23:16] = \$9 ;
    \$19 [31:24] = \$14 ;
    \$19 [39:32] = { \$17 [6], \$17  };
    \$19 [47:40] = { \$18 [5], \$18 [5], \$18  };
    if (rst) begin
      \$19  = 48'h000000000000;
    end
  end
  assign pixels = { \port$0$152 , \port$0$128 , \port$0$104 , \port$0$80  };
  assign \lanes[0]  = lanes[7:0];
  assign \lanes[1]  = lanes[15:8];
  assign \lanes[2]  = lanes[23:16];
  assign \lanes[3]  = lanes[31:24];
  assign \lanes[4]  = lanes[39:32];
  assign \lanes[5]  = lanes[47:40];
  assign \pixels[0]  = \port$0$80 ;
  assign \pixels[1]  = \port$0$104 ;
  assign \pixels[2]  = \port$0$128 ;
  assign \pixels[3]  = \port$0$152 ;
  assign \taps[0]  = taps[2:0];
  assign \taps[1]  = taps[5:3];
  assign \taps[2]  = taps[8:6];
endmodule

module \macram_unit.engine3 (\port$0$107 , \port$0$131 , \port$0$155 , clk, rst, taps, lanes, \port$0$83 );
  reg \$auto$verilog_backend.cc:2355:dump_module$5  = 0;
  wire [5:0] \$1 ;
  wire [5:0] \$10 ;
  wire [5:0] \$11 ;
  wire [6:0] \$12 ;
  wire [5:0] \$13 ;
  wire [7:0] \$14 ;
  wire [5:0] \$15 ;
  wire [5:0] \$16 ;
  wire [6:0] \$17 ;
  wire [5:0] \$18 ;
  reg [47:0] \$19 ;
  wire [5:0] \$2 ;
  wire [5:0] \$3 ;
  wire [6:0] \$4 ;
  wire [5:0] \$5 ;
  wire [5:0] \$6 ;
  wire [6:0] \$7 ;
  wire [5:0] \$8 ;
  wire [7:0] \$9 ;
  input clk;
  wire clk;
  output [47:0] lanes;
  reg [47:0] lanes = 48'h000000000000;
  wire [7:0] \lanes[0] ;
  wire [7:0] \lanes[1] ;
  wire [7:0] \lanes[2] ;
  wire [7:0] \lanes[3] ;
  wire [7:0] \lanes[4] ;
  wire [7:0] \lanes[5] ;
  wire [11:0] pixels;
  wire [2:0] \pixels[0] ;
  wire [2:0] \pixels[1] ;
  wire [2:0] \pixels[2] ;
  wire [2:0] \pixels[3] ;
  input [2:0] \port$0$107 ;
  wire [2:0] \port$0$107 ;
  input [2:0] \port$0$131 ;
  wire [2:0] \port$0$131 ;
  input [2:0] \port$0$155 ;
  wire [2:0] \port$0$155 ;
  input [2:0] \port$0$83 ;
  wire [2:0] \port$0$83 ;
  input rst;
  wire rst;
  input [8:0] taps;
  wire [8:0] taps;
  wire [2:0] \taps[0] ;
  wire [2:0] \taps[1] ;
  wire [2:0] \taps[2] ;
  assign \$1  = $signed({ 1'h0, \port$0$83  }) * $signed(taps[2:0]);
  assign \$2  = $signed({ 1'h0, \port$0$107  }) * $signed(taps[2:0]);
  assign \$3  = $signed({ 1'h0, \port$0$83  }) * $signed(taps[5:3]);
  assign \$4  = $signed(\$2 ) + $signed(\$3 );
  assign \$5  = $signed({ 1'h0, \port$0$131  }) * $signed(taps[2:0]);
  assign \$6  = $signed({ 1'h0, \port$0$107  }) * $signed(taps[5:3]);
  assign \$7  = $signed(\$5 ) + $signed(\$6 );
  assign \$8  = $signed({ 1'h0, \port$0$83  }) * $signed(taps[8:6]);
  assign \$9  = $signed(\$7 ) + $signed(\$8 );
  assign \$10  = $signed({ 1'h0, \port$0$155  }) * $signed(taps[2:0]);
  assign \$11  = $signed({ 1'h0, \port$0$131  }) * $signed(taps[5:3]);
  assign \$12  = $signed(\$10 ) + $signed(\$11 );
  assign \$13  = $signed({ 1'h0, \port$0$107  }) * $signed(taps[8:6]);
  assign \$14  = $signed(\$12 ) + $signed(\$13 );
  assign \$15  = $signed({ 1'h0, \port$0$155  }) * $signed(taps[5:3]);
  assign \$16  = $signed({ 1'h0, \port$0$131  }) * $signed(taps[8:6]);
  assign \$17  = $signed(\$15 ) + $signed(\$16 );
  assign \$18  = $signed({ 1'h0, \port$0$155  }) * $signed(taps[8:6]);
  always @(posedge clk)
    lanes <= \$19 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$5 ) begin end
    \$19 [7:0] = { \$1 [5], \$1 [5], \$1  };
    \$19 [15:8] = { \$4 [6], \$4  };
    \$19 [23:16] = \$9 ;
    \$19 [31:24] = \$14 ;
    \$19 [39:32] = { \$17 [6], \$17  };
    \$19 [47:40] = { \$18 [5], \$18 [5], \$18  };
    if (rst) begin
      \$19  = 48'h000000000000;
    end
  end
  assign pixels = { \port$0$155 , \port$0$131 , \port$0$107 , \port$0$83  };
  assign \lanes[0]  = lanes[7:0];
  assign \lanes[1]  = lanes[15:8];
  assign \lanes[2]  = lanes[23:16];
  assign \lanes[3]  = lanes[31:24];
  assign \lanes[4]  = lanes[39:32];
  assign \lanes[5]  = lanes[47:40];
  assign \pixels[0]  = \port$0$83 ;
  assign \pixels[1]  = \port$0$107 ;
  assign \pixels[2]  = \port$0$131 ;
  assign \pixels[3]  = \port$0$155 ;
  assign \taps[0]  = taps[2:0];
  assign \taps[1]  = taps[5:3];
  assign \taps[2]  = taps[8:6];
endmodule

module \macram_unit.engine4 (\port$0$110 , \port$0$134 , \port$0$158 , clk, rst, taps, lanes, \port$0$86 );
  reg \$auto$verilog_backend.cc:2355:dump_module$6  = 0;
  wire [5:0] \$1 ;
  wire [5:0] \$10 ;
  wire [5:0] \$11 ;
  wire [6:0] \$12 ;
  wire [5:0] \$13 ;
  wire [7:0] \$14 ;
  wire [5:0] \$15 ;
  wire [5:0] \$16 ;
  wire [6:0] \$17 ;
  wire [5:0] \$18 ;
  reg [47:0] \$19 ;
  wire [5:0] \$2 ;
  wire [5:0] \$3 ;
  wire [6:0] \$4 ;
  wire [5:0] \$5 ;
  wire [5:0] \$6 ;
  wire [6:0] \$7 ;
  wire [5:0] \$8 ;
  wire [7:0] \$9 ;
  input clk;
  wire clk;
  output [47:0] lanes;
  reg [47:0] lanes = 48'h000000000000;
  wire [7:0] \lanes[0] ;
  wire [7:0] \lanes[1] ;
  wire [7:0] \lanes[2] ;
  wire [7:0] \lanes[3] ;
  wire [7:0] \lanes[4] ;
  wire [7:0] \lanes[5] ;
  wire [11:0] pixels;
  wire [2:0] \pixels[0] ;
  wire [2:0] \pixels[1] ;
  wire [2:0] \pixels[2] ;
  wire [2:0] \pixels[3] ;
  input [2:0] \port$0$110 ;
  wire [2:0] \port$0$110 ;
  input [2:0] \port$0$134 ;
  wire [2:0] \port$0$134 ;
  input [2:0] \port$0$158 ;
  wire [2:0] \port$0$158 ;
  input [2:0] \port$0$86 ;
  wire [2:0] \port$0$86 ;
  input rst;
  wire rst;
  input [8:0] taps;
  wire [8:0] taps;
  wire [2:0] \taps[0] ;
  wire [2:0] \taps[1] ;
  wire [2:0] \taps[2] ;
  assign \$1  = $signed({ 1'h0, \port$0$86  }) * $signed(taps[2:0]);
  assign \$2  = $signed({ 1'h0, \port$0$110  }) * $signed(taps[2:0]);
  assign \$3  = $signed({ 1'h0, \port$0$86  }) * $signed(taps[5:3]);
  assign \$4  = $signed(\$2 ) + $signed(\$3 );
  assign \$5  = $signed({ 1'h0, \port$0$134  }) * $signed(taps[2:0]);
  assign \$6  = $signed({ 1'h0, \port$0$110  }) * $signed(taps[5:3]);
  assign \$7  = $signed(\$5 ) + $signed(\$6 );
  assign \$8  = $signed({ 1'h0, \port$0$86  }) * $signed(taps[8:6]);
  assign \$9  = $signed(\$7 ) + $signed(\$8 );
  assign \$10  = $signed({ 1'h0, \port$0$158  }) * $signed(taps[2:0]);
  assign \$11  = $signed({ 1'h0, \port$0$134  }) * $signed(taps[5:3]);
  assign \$12  = $signed(\$10 ) + $signed(\$11 );
  assign \$13  = $signed({ 1'h0, \port$0$110  }) * $signed(taps[8:6]);
  assign \$14  = $signed(\$12 ) + $signed(\$13 );
  assign \$15  = $signed({ 1'h0, \port$0$158  }) * $signed(taps[5:3]);
  assign \$16  = $signed({ 1'h0, \port$0$134  }) * $signed(taps[8:6]);
  assign \$17  = $signed(\$15 ) + $signed(\$16 );
  assign \$18  = $signed({ 1'h0, \port$0$158  }) * $signed(taps[8:6]);
  always @(posedge clk)
    lanes <= \$19 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$6 ) begin end
    \$19 [7:0] = { \$1 [5], \$1 [5], \$1  };
    \$19 [15:8] = { \$4 [6], \$4  };
    \$19 [23:16] = \$9 ;
    \$19 [31:24] = \$14 ;
    \$19 [39:32] = { \$17 [6], \$17  };
    \$19 [47:40] = { \$18 [5], \$18 [5], \$18  };
    if (rst) begin
      \$19  = 48'h000000000000;
    end
  end
  assign pixels = { \port$0$158 , \port$0$134 , \port$0$110 , \port$0$86  };
  assign \lanes[0]  = lanes[7:0];
  assign \lanes[1]  = lanes[15:8];
  assign \lanes[2]  = lanes[23:16];
  assign \lanes[3]  = lanes[31:24];
  assign \lanes[4]  = lanes[39:32];
  assign \lanes[5]  = lanes[47:40];
  assign \pixels[0]  = \port$0$86 ;
  assign \pixels[1]  = \port$0$110 ;
  assign \pixels[2]  = \port$0$134 ;
  assign \pixels[3]  = \port$0$158 ;
  assign \taps[0]  = taps[2:0];
  assign \taps[1]  = taps[5:3];
  assign \taps[2]  = taps[8:6];
endmodule

module \macram_unit.engine5 (\port$0$113 , \port$0$137 , \port$0$161 , clk, rst, taps, lanes, \port$0$89 );
  reg \$auto$verilog_backend.cc:2355:dump_module$7  = 0;
  wire [5:0] \$1 ;
  wire [5:0] \$10 ;
  wire [5:0] \$11 ;
  wire [6:0] \$12 ;
  wire [5:0] \$13 ;
  wire [7:0] \$14 ;
  wire [5:0] \$15 ;
  wire [5:0] \$16 ;
  wire [6:0] \$17 ;
  wire [5:0] \$18 ;
  reg [47:0] \$19 ;
  wire [5:0] \$2 ;
  wire [5:0] \$3 ;
  wire [6:0] \$4 ;
  wire [5:0] \$5 ;
  wire [5:0] \$6 ;
  wire [6:0] \$7 ;
  wire [5:0] \$8 ;
  wire [7:0] \$9 ;
  input clk;
  wire clk;
  output [47:0] lanes;
  reg [47:0] lanes = 48'h000000000000;
  wire [7:0] \lanes[0] ;
  wire [7:0] \lanes[1] ;
  wire [7:0] \lanes[2] ;
  wire [7:0] \lanes[3] ;
  wire [7:0] \lanes[4] ;
  wire [7:0] \lanes[5] ;
  wire [11:0] pixels;
  wire [2:0] \pixels[0] ;
  wire [2:0] \pixels[1] ;
  wire [2:0] \pixels[2] ;
  wire [2:0] \pixels[3] ;
  input [2:0] \port$0$113 ;
  wire [2:0] \port$0$113 ;
  input [2:0] \port$0$137 ;
  wire [2:0] \port$0$137 ;
  input [2:0] \port$0$161 ;
  wire [2:0] \port$0$161 ;
  input [2:0] \port$0$89 ;
  wire [2:0] \port$0$89 ;
  input rst;
  wire rst;
  input [8:0] taps;
  wire [8:0] taps;
  wire [2:0] \taps[0] ;
  wire [2:0] \taps[1] ;
  wire [2:0] \taps[2] ;
  assign \$1  = $signed({ 1'h0, \port$0$89  }) * $signed(taps[2:0]);
  assign \$2  = $signed({ 1'h0, \port$0$113  }) * $signed(taps[2:0]);
  assign \$3  = $signed({ 1'h0, \port$0$89  }) * $signed(taps[5:3]);
  assign \$4  = $signed(\$2 ) + $signed(\$3 );
  assign \$5  = $signed({ 1'h0, \port$0$137  }) * $signed(taps[2:0]);
  assign \$6  = $signed({ 1'h0, \port$0$113  }) * $signed(taps[5:3]);
  assign \$7  = $signed(\$5 ) + $signed(\$6 );
  assign \$8  = $signed({ 1'h0, \port$0$89  }) * $signed(taps[8:6]);
  assign \$9  = $signed(\$7 ) + $signed(\$8 );
  assign \$10  = $signed({ 1'h0, \port$0$161  }) * $signed(taps[2:0]);
  assign \$11  = $signed({ 1'h0, \port$0$137  }) * $signed(taps[5:3]);
  assign \$12  = $signed(\$10 ) + $signed(\$11 );
  assign \$13  = $signed({ 1'h0, \port$0$113  }) * $signed(taps[8:6]);
  assign \$14  = $signed(\$12 ) + $signed(\$13 );
  assign \$15  = $signed({ 1'h0, \port$0$161  }) * $signed(taps[5:3]);
  assign \$16  = $signed({ 1'h0, \port$0$137  }) * $signed(taps[8:6]);
  assign \$17  = $signed(\$15 ) + $signed(\$16 );
  assign \$18  = $signed({ 1'h0, \port$0$161  }) * $signed(taps[8:6]);
  always @(posedge clk)
    lanes <= \$19 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$7 ) begin end
    \$19 [7:0] = { \$1 [5], \$1 [5], \$1  };
    \$19 [15:8] = { \$4 [6], \$4  };
    \$19 [23:16] = \$9 ;
    \$19 [31:24] = \$14 ;
    \$19 [39:32] = { \$17 [6], \$17  };
    \$19 [47:40] = { \$18 [5], \$18 [5], \$18  };
    if (rst) begin
      \$19  = 48'h000000000000;
    end
  end
  assign pixels = { \port$0$161 , \port$0$137 , \port$0$113 , \port$0$89  };
  assign \lanes[0]  = lanes[7:0];
  assign \lanes[1]  = lanes[15:8];
  assign \lanes[2]  = lanes[23:16];
  assign \lanes[3]  = lanes[31:24];
  assign \lanes[4]  = lanes[39:32];
  assign \lanes[5]  = lanes[47:40];
  assign \pixels[0]  = \port$0$89 ;
  assign \pixels[1]  = \port$0$113 ;
  assign \pixels[2]  = \port$0$137 ;
  assign \pixels[3]  = \port$0$161 ;
  assign \taps[0]  = taps[2:0];
  assign \taps[1]  = taps[5:3];
  assign \taps[2]  = taps[8:6];
endmodule

module \macram_unit.engine6 (\port$0$116 , \port$0$140 , \port$0$164 , clk, rst, taps, lanes, \port$0$92 );
  reg \$auto$verilog_backend.cc:2355:dump_module$8  = 0;
  wire [5:0] \$1 ;
  wire [5:0] \$10 ;
  wire [5:0] \$11 ;
  wire [6:0] \$12 ;
  wire [5:0] \$13 ;
  wire [7:0] \$14 ;
  wire [5:0] \$15 ;
  wire [5:0] \$16 ;
  wire [6:0] \$17 ;
  wire [5:0] \$18 ;
  reg [47:0] \$19 ;
  wire [5:0] \$2 ;
  wire [5:0] \$3 ;
  wire [6:0] \$4 ;
  wire [5:0] \$5 ;
  wire [5:0] \$6 ;
  wire [6:0] \$7 ;
  wire [5:0] \$8 ;
  wire [7:0] \$9 ;
  input clk;
  wire clk;
  output [47:0] lanes;
  reg [47:0] lanes = 48'h000000000000;
  wire [7:0] \lanes[0] ;
  wire [7:0] \lanes[1] ;
  wire [7:0] \lanes[2] ;
  wire [7:0] \lanes[3] ;
  wire [7:0] \lanes[4] ;
  wire [7:0] \lanes[5] ;
  wire [11:0] pixels;
  wire [2:0] \pixels[0] ;
  wire [2:0] \pixels[1] ;
  wire [2:0] \pixels[2] ;
  wire [2:0] \pixels[3] ;
  input [2:0] \port$0$116 ;
  wire [2:0] \port$0$116 ;
  input [2:0] \port$0$140 ;
  wire [2:0] \port$0$140 ;
  input [2:0] \port$0$164 ;
  wire [2:0] \port$0$164 ;
  input [2:0] \port$0$92 ;
  wire [2:0] \port$0$92 ;
  input rst;
  wire rst;
  input [8:0] taps;
  wire [8:0] taps;
  wire [2:0] \taps[0] ;
  wire [2:0] \taps[1] ;
  wire [2:0] \taps[2] ;
  assign \$1  = $signed({ 1'h0, \port$0$92  }) * $signed(taps[2:0]);
  assign \$2  = $signed({ 1'h0, \port$0$116  }) * $signed(taps[2:0]);
  assign \$3  = $signed({ 1'h0, \port$0$92  }) * $signed(taps[5:3]);
  assign \$4  = $signed(\$2 ) + $signed(\$3 );
  assign \$5  = $signed({ 1'h0, \port$0$140  }) * $signed(taps[2:0]);
  assign \$6  = $signed({ 1'h0, \port$0$116  }) * $signed(taps[5:3]);
  assign \$7  = $signed(\$5 ) + $signed(\$6 );
  assign \$8  = $signed({ 1'h0, \port$0$92  }) * $signed(taps[8:6]);
  assign \$9  = $signed(\$7 ) + $signed(\$8 );
  assign \$10  = $signed({ 1'h0, \port$0$164  }) * $signed(taps[2:0]);
  assign \$11  = $signed({ 1'h0, \port$0$140  }) * $signed(taps[5:3]);
  assign \$12  = $signed(\$10 ) + $signed(\$11 );
  assign \$13  = $signed({ 1'h0, \port$0$116  }) * $signed(taps[8:6]);
  assign \$14  = $signed(\$12 ) + $signed(\$13 );
  assign \$15  = $signed({ 1'h0, \port$0$164  }) * $signed(taps[5:3]);
  assign \$16  = $signed({ 1'h0, \port$0$140  }) * $signed(taps[8:6]);
  assign \$17  = $signed(\$15 ) + $signed(\$16 );
  assign \$18  = $signed({ 1'h0, \port$0$164  }) * $signed(taps[8:6]);
  always @(posedge clk)
    lanes <= \$19 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$8 ) begin end
    \$19 [7:0] = { \$1 [5], \$1 [5], \$1  };
    \$19 [15:8] = { \$4 [6], \$4  };
    \$19 [23:16] = \$9 ;
    \$19 [31:24] = \$14 ;
    \$19 [39:32] = { \$17 [6], \$17  };
    \$19 [47:40] = { \$18 [5], \$18 [5], \$18  };
    if (rst) begin
      \$19  = 48'h000000000000;
    end
  end
  assign pixels = { \port$0$164 , \port$0$140 , \port$0$116 , \port$0$92  };
  assign \lanes[0]  = lanes[7:0];
  assign \lanes[1]  = lanes[15:8];
  assign \lanes[2]  = lanes[23:16];
  assign \lanes[3]  = lanes[31:24];
  assign \lanes[4]  = lanes[39:32];
  assign \lanes[5]  = lanes[47:40];
  assign \pixels[0]  = \port$0$92 ;
  assign \pixels[1]  = \port$0$116 ;
  assign \pixels[2]  = \port$0$140 ;
  assign \pixels[3]  = \port$0$164 ;
  assign \taps[0]  = taps[2:0];
  assign \taps[1]  = taps[5:3];
  assign \taps[2]  = taps[8:6];
endmodule

module \macram_unit.engine7 (\port$0$119 , \port$0$143 , \port$0$167 , clk, rst, taps, lanes, \port$0$95 );
  reg \$auto$verilog_backend.cc:2355:dump_module$9  = 0;
  wire [5:0] \$1 ;
  wire [5:0] \$10 ;
  wire [5:0] \$11 ;
  wire [6:0] \$12 ;
  wire [5:0] \$13 ;
  wire [7:0] \$14 ;
  wire [5:0] \$15 ;
  wire [5:0] \$16 ;
  wire [6:0] \$17 ;
  wire [5:0] \$18 ;
  reg [47:0] \$19 ;
  wire [5:0] \$2 ;
  wire [5:0] \$3 ;
  wire [6:0] \$4 ;
  wire [5:0] \$5 ;
  wire [5:0] \$6 ;
  wire [6:0] \$7 ;
  wire [5:0] \$8 ;
  wire [7:0] \$9 ;
  input clk;
  wire clk;
  output [47:0] lanes;
  reg [47:0] lanes = 48'h000000000000;
  wire [7:0] \lanes[0] ;
  wire [7:0] \lanes[1] ;
  wire [7:0] \lanes[2] ;
  wire [7:0] \lanes[3] ;
  wire [7:0] \lanes[4] ;
  wire [7:0] \lanes[5] ;
  wire [11:0] pixels;
  wire [2:0] \pixels[0] ;
  wire [2:0] \pixels[1] ;
  wire [2:0] \pixels[2] ;
  wire [2:0] \pixels[3] ;
  input [2:0] \port$0$119 ;
  wire [2:0] \port$0$119 ;
  input [2:0] \port$0$143 ;
  wire [2:0] \port$0$143 ;
  input [2:0] \port$0$167 ;
  wire [2:0] \port$0$167 ;
  input [2:0] \port$0$95 ;
  wire [2:0] \port$0$95 ;
  input rst;
  wire rst;
  input [8:0] taps;
  wire [8:0] taps;
  wire [2:0] \taps[0] ;
  wire [2:0] \taps[1] ;
  wire [2:0] \taps[2] ;
  assign \$1  = $signed({ 1'h0, \port$0$95  }) * $signed(taps[2:0]);
  assign \$2  = $signed({ 1'h0, \port$0$119  }) * $signed(taps[2:0]);
  assign \$3  = $signed({ 1'h0, \port$0$95  }) * $signed(taps[5:3]);
  assign \$4  = $signed(\$2 ) + $signed(\$3 );
  assign \$5  = $signed({ 1'h0, \port$0$143  }) * $signed(taps[2:0]);
  assign \$6  = $signed({ 1'h0, \port$0$119  }) * $signed(taps[5:3]);
  assign \$7  = $signed(\$5 ) + $signed(\$6 );
  assign \$8  = $signed({ 1'h0, \port$0$95  }) * $signed(taps[8:6]);
  assign \$9  = $signed(\$7 ) + $signed(\$8 );
  assign \$10  = $signed({ 1'h0, \port$0$167  }) * $signed(taps[2:0]);
  assign \$11  = $signed({ 1'h0, \port$0$143  }) * $signed(taps[5:3]);
  assign \$12  = $signed(\$10 ) + $signed(\$11 );
  assign \$13  = $signed({ 1'h0, \port$0$119  }) * $signed(taps[8:6]);
  assign \$14  = $signed(\$12 ) + $signed(\$13 );
  assign \$15  = $signed({ 1'h0, \port$0$167  }) * $signed(taps[5:3]);
  assign \$16  = $signed({ 1'h0, \port$0$143  }) * $signed(taps[8:6]);
  assign \$17  = $signed(\$15 ) + $signed(\$16 );
  assign \$18  = $signed({ 1'h0, \port$0$167  }) * $signed(taps[8:6]);
  always @(posedge clk)
    lanes <= \$19 ;
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$9 ) begin end
    \$19 [7:0] = { \$1 [5], \$1 [5], \$1  };
    \$19 [15:8] = { \$4 [6], \$4  };
    \$19 [23:16] = \$9 ;
    \$19 [31:24] = \$14 ;
    \$19 [39:32] = { \$17 [6], \$17  };
    \$19 [47:40] = { \$18 [5], \$18 [5], \$18  };
    if (rst) begin
      \$19  = 48'h000000000000;
    end
  end
  assign pixels = { \port$0$167 , \port$0$143 , \port$0$119 , \port$0$95  };
  assign \lanes[0]  = lanes[7:0];
  assign \lanes[1]  = lanes[15:8];
  assign \lanes[2]  = lanes[23:16];
  assign \lanes[3]  = lanes[31:24];
  assign \lanes[4]  = lanes[39:32];
  assign \lanes[5]  = lanes[47:40];
  assign \pixels[0]  = \port$0$95 ;
  assign \pixels[1]  = \port$0$119 ;
  assign \pixels[2]  = \port$0$143 ;
  assign \pixels[3]  = \port$0$167 ;
  assign \taps[0]  = taps[2:0];
  assign \taps[1]  = taps[5:3];
  assign \taps[2]  = taps[8:6];
endmodule
