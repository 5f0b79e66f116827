
module macram_unit(activations, control, shift, chain_i, clk, rst, chain_o, weight);
  reg \$auto$verilog_backend.cc:2355:dump_module$1  = 0;
  wire [8:0] \$1 ;
  wire [9:0] \$10 ;
  wire [8:0] \$11 ;
  wire [8:0] \$12 ;
  wire [9:0] \$13 ;
  wire [10:0] \$14 ;
  wire [8:0] \$15 ;
  wire [8:0] \$16 ;
  wire [9:0] \$17 ;
  wire [8:0] \$18 ;
  wire [8:0] \$19 ;
  wire [8:0] \$2 ;
  wire [9:0] \$20 ;
  wire [10:0] \$21 ;
  wire [8:0] \$22 ;
  wire [8:0] \$23 ;
  wire [9:0] \$24 ;
  wire [8:0] \$25 ;
  wire [8:0] \$26 ;
  wire [9:0] \$27 ;
  wire [10:0] \$28 ;
  wire [8:0] \$29 ;
  wire [9:0] \$3 ;
  wire [8:0] \$30 ;
  wire [9:0] \$31 ;
  wire [8:0] \$32 ;
  wire [8:0] \$33 ;
  wire [9:0] \$34 ;
  wire [10:0] \$35 ;
  wire [8:0] \$36 ;
  wire [8:0] \$37 ;
  wire [9:0] \$38 ;
  wire [8:0] \$39 ;
  wire [8:0] \$4 ;
  wire [8:0] \$40 ;
  wire [9:0] \$41 ;
  wire [10:0] \$42 ;
  wire [18:0] \$43 ;
  wire [10:0] \$44 ;
  wire [19:0] \$45 ;
  wire [18:0] \$46 ;
  wire [18:0] \$47 ;
  wire [19:0] \$48 ;
  wire [18:0] \$49 ;
  wire [8:0] \$5 ;
  wire [19:0] \$50 ;
  wire [18:0] \$51 ;
  wire [19:0] \$52 ;
  wire [18:0] \$53 ;
  wire [19:0] \$54 ;
  wire [18:0] \$55 ;
  wire [19:0] \$56 ;
  reg [18:0] \$57 ;
  reg [18:0] \$58 ;
  reg [18:0] \$59 ;
  wire [9:0] \$6 ;
  reg [18:0] \$60 ;
  reg [18:0] \$61 ;
  reg [18:0] \$62 ;
  reg [75:0] \$63 ;
  wire [10:0] \$7 ;
  wire [8:0] \$8 ;
  wire [8:0] \$9 ;
  reg [18:0] acc0 = 19'h00000;
  reg [18:0] acc1 = 19'h00000;
  reg [18:0] acc2 = 19'h00000;
  reg [18:0] acc3 = 19'h00000;
  reg [18:0] acc4 = 19'h00000;
  reg [18:0] acc5 = 19'h00000;
  input [95:0] activations;
  wire [95:0] activations;
  wire [3:0] carried__addr;
  wire [37:0] carried__data;
  wire [18:0] \carried__data[0] ;
  wire [18:0] \carried__data[1] ;
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
  input [7:0] control;
  wire [7:0] control;
  wire \control.edge ;
  wire \control.en ;
  wire \control.first ;
  wire \control.last ;
  wire [3:0] \control.tile ;
  wire done;
  wire [3:0] kept__addr;
  wire [37:0] kept__data;
  wire [18:0] \kept__data[0] ;
  wire [18:0] \kept__data[1] ;
  wire kept__en;
  wire [47:0] lanes;
  wire [47:0] \lanes$11 ;
  wire [7:0] \lanes$11[0] ;
  wire [7:0] \lanes$11[1] ;
  wire [7:0] \lanes$11[2] ;
  wire [7:0] \lanes$11[3] ;
  wire [7:0] \lanes$11[4] ;
  wire [7:0] \lanes$11[5] ;
  wire [47:0] \lanes$12 ;
  wire [7:0] \lanes$12[0] ;
  wire [7:0] \lanes$12[1] ;
  wire [7:0] \lanes$12[2] ;
  wire [7:0] \lanes$12[3] ;
  wire [7:0] \lanes$12[4] ;
  wire [7:0] \lanes$12[5] ;
  wire [47:0] \lanes$13 ;
  wire [7:0] \lanes$13[0] ;
  wire [7:0] \lanes$13[1] ;
  wire [7:0] \lanes$13[2] ;
  wire [7:0] \lanes$13[3] ;
  wire [7:0] \lanes$13[4] ;
  wire [7:0] \lanes$13[5] ;
  wire [47:0] \lanes$14 ;
  wire [7:0] \lanes$14[0] ;
  wire [7:0] \lanes$14[1] ;
  wire [7:0] \lanes$14[2] ;
  wire [7:0] \lanes$14[3] ;
  wire [7:0] \lanes$14[4] ;
  wire [7:0] \lanes$14[5] ;
  wire [47:0] \lanes$15 ;
  wire [7:0] \lanes$15[0] ;
  wire [7:0] \lanes$15[1] ;
  wire [7:0] \lanes$15[2] ;
  wire [7:0] \lanes$15[3] ;
  wire [7:0] \lanes$15[4] ;
  wire [7:0] \lanes$15[5] ;
  wire [47:0] \lanes$16 ;
  wire [7:0] \lanes$16[0] ;
  wire [7:0] \lanes$16[1] ;
  wire [7:0] \lanes$16[2] ;
  wire [7:0] \lanes$16[3] ;
  wire [7:0] \lanes$16[4] ;
  wire [7:0] \lanes$16[5] ;
  wire [47:0] \lanes$17 ;
  wire [7:0] \lanes$17[0] ;
  wire [7:0] \lanes$17[1] ;
  wire [7:0] \lanes$17[2] ;
  wire [7:0] \lanes$17[3] ;
  wire [7:0] \lanes$17[4] ;
  wire [7:0] \lanes$17[5] ;
  wire [7:0] \lanes[0] ;
  wire [7:0] \lanes[1] ;
  wire [7:0] \lanes[2] ;
  wire [7:0] \lanes[3] ;
  wire [7:0] \lanes[4] ;
  wire [7:0] \lanes[5] ;
  wire [11:0] pixels;
  wire [11:0] \pixels$40 ;
  wire [2:0] \pixels$40[0] ;
  wire [2:0] \pixels$40[1] ;
  wire [2:0] \pixels$40[2] ;
  wire [2:0] \pixels$40[3] ;
  wire [11:0] \pixels$42 ;
  wire [2:0] \pixels$42[0] ;
  wire [2:0] \pixels$42[1] ;
  wire [2:0] \pixels$42[2] ;
  wire [2:0] \pixels$42[3] ;
  wire [11:0] \pixels$44 ;
  wire [2:0] \pixels$44[0] ;
  wire [2:0] \pixels$44[1] ;
  wire [2:0] \pixels$44[2] ;
  wire [2:0] \pixels$44[3] ;
  wire [11:0] \pixels$46 ;
  wire [2:0] \pixels$46[0] ;
  wire [2:0] \pixels$46[1] ;
  wire [2:0] \pixels$46[2] ;
  wire [2:0] \pixels$46[3] ;
  wire [11:0] \pixels$48 ;
  wire [2:0] \pixels$48[0] ;
  wire [2:0] \pixels$48[1] ;
  wire [2:0] \pixels$48[2] ;
  wire [2:0] \pixels$48[3] ;
  wire [11:0] \pixels$50 ;
  wire [2:0] \pixels$50[0] ;
  wire [2:0] \pixels$50[1] ;
  wire [2:0] \pixels$50[2] ;
  wire [2:0] \pixels$50[3] ;
  wire [11:0] \pixels$52 ;
  wire [2:0] \pixels$52[0] ;
  wire [2:0] \pixels$52[1] ;
  wire [2:0] \pixels$52[2] ;
  wire [2:0] \pixels$52[3] ;
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
  reg [10:0] sum0 = 11'h000;
  reg [10:0] sum1 = 11'h000;
  reg [10:0] sum2 = 11'h000;
  reg [10:0] sum3 = 11'h000;
  reg [10:0] sum4 = 11'h000;
  reg [10:0] sum5 = 11'h000;
  wire [8:0] taps;
  wire [8:0] \taps$39 ;
  wire [2:0] \taps$39[0] ;
  wire [2:0] \taps$39[1] ;
  wire [2:0] \taps$39[2] ;
  wire [8:0] \taps$41 ;
  wire [2:0] \taps$41[0] ;
  wire [2:0] \taps$41[1] ;
  wire [2:0] \taps$41[2] ;
  wire [8:0] \taps$43 ;
  wire [2:0] \taps$43[0] ;
  wire [2:0] \taps$43[1] ;
  wire [2:0] \taps$43[2] ;
  wire [8:0] \taps$45 ;
  wire [2:0] \taps$45[0] ;
  wire [2:0] \taps$45[1] ;
  wire [2:0] \taps$45[2] ;
  wire [8:0] \taps$47 ;
  wire [2:0] \taps$47[0] ;
  wire [2:0] \taps$47[1] ;
  wire [2:0] \taps$47[2] ;
  wire [8:0] \taps$49 ;
  wire [2:0] \taps$49[0] ;
  wire [2:0] \taps$49[1] ;
  wire [2:0] \taps$49[2] ;
  wire [8:0] \taps$51 ;
  wire [2:0] \taps$51[0] ;
  wire [2:0] \taps$51[1] ;
  wire [2:0] \taps$51[2] ;
  wire [2:0] \taps[0] ;
  wire [2:0] \taps[1] ;
  wire [2:0] \taps[2] ;
  wire [18:0] total0;
  wire [18:0] total1;
  wire [18:0] total2;
  wire [18:0] total3;
  wire [18:0] total4;
  wire [18:0] total5;
  input [71:0] weight;
  wire [71:0] weight;
  reg [71:0] \weight$8  = 72'h000000000000000000;
  assign \$37  = $signed(\lanes$12 [47:40]) + $signed(\lanes$13 [47:40]);
  assign \$38  = $signed(\$36 ) + $signed(\$37 );
  assign \$39  = $signed(\lanes$14 [47:40]) + $signed(\lanes$15 [47:40]);
  assign \$40  = $signed(\lanes$16 [47:40]) + $signed(\lanes$17 [47:40]);
  assign \$41  = $signed(\$39 ) + $signed(\$40 );
  assign \$42  = $signed(\$38 ) + $signed(\$41 );
  assign \$43  = control[1] ? carried__data[18:0] : acc0;
  assign \$44  = control[3] ? 11'h000 : sum0;
  assign \$45  = $signed(\$43 ) + $signed(\$44 );
  assign \$46  = control[3] ? 19'h00000 : carried__data[37:19];
  assign \$47  = control[1] ? \$46  : acc1;
  assign \$48  = $signed(\$47 ) + $signed(sum1);
  assign \$49  = control[1] ? 19'h00000 : acc2;
  assign \$50  = $signed(\$49 ) + $signed(sum2);
  assign \$51  = control[1] ? 19'h00000 : acc3;
  assign \$52  = $signed(\$51 ) + $signed(sum3);
  assign \$53  = control[1] ? 19'h00000 : acc4;
  assign \$54  = $signed(\$53 ) + $signed(sum4);
  assign \$55  = control[1] ? 19'h00000 : acc5;
  assign \$56  = $signed(\$55 ) + $signed(sum5);
  assign done = control[0] & control[2];
  always @(posedge clk)
    \weight$8  <= weight;
  always @(posedge clk)
    sum0 <= \$7 ;
  always @(posedge clk)
    sum1 <= \$14 ;
  always @(posedge clk)
    sum2 <= \$21 ;
  always @(posedge clk)
    sum3 <= \$28 ;
  always @(posedge clk)
    sum4 <= \$35 ;
  always @(posedge clk)
    sum5 <= \$42 ;
  always @(posedge clk)
    acc0 <= \$57 ;
  always @(posedge clk)
    acc1 <= \$58 ;
  always @(posedge clk)
    acc2 <= \$59 ;
  always @(posedge clk)
    acc3 <= \$60 ;
  always @(posedge clk)
    acc4 <= \$61 ;
  always @(posedge clk)
    acc5 <= \$62 ;
  always @(posedge clk)
    chain_o <= \$63 ;
  assign \$1  = $signed(lanes[7:0]) + $signed(\lanes$11 [7:0]);
  assign \$2  = $signed(\lanes$12 [7:0]) + $signed(\lanes$13 [7:0]);
  assign \$3  = $signed(\$1 ) + $signed(\$2 );
  assign \$4  = $signed(\lanes$14 [7:0]) + $signed(\lanes$15 [7:0]);
  assign \$5  = $signed(\lanes$16 [7:0]) + $signed(\lanes$17 [7:0]);
  assign \$6  = $signed(\$4 ) + $signed(\$5 );
  assign \$7  = $signed(\$3 ) + $signed(\$6 );
  assign \$8  = $signed(lanes[15:8]) + $signed(\lanes$11 [15:8]);
  assign \$9  = $signed(\lanes$12 [15:8]) + $signed(\lanes$13 [15:8]);
  assign \$10  = $signed(\$8 ) + $signed(\$9 );
  assign \$11  = $signed(\lanes$14 [15:8]) + $signed(\lanes$15 [15:8]);
  assign \$12  = $signed(\lanes$16 [15:8]) + $signed(\lanes$17 [15:8]);
  assign \$13  = $signed(\$11 ) + $signed(\$12 );
  assign \$14  = $signed(\$10 ) + $signed(\$13 );
  assign \$15  = $signed(lanes[23:16]) + $signed(\lanes$11 [23:16]);
  assign \$16  = $signed(\lanes$12 [23:16]) + $signed(\lanes$13 [23:16]);
  assign \$17  = $signed(\$15 ) + $signed(\$16 );
  assign \$18  = $signed(\lanes$14 [23:16]) + $signed(\lanes$15 [23:16]);
  assign \$19  = $signed(\lanes$16 [23:16]) + $signed(\lanes$17 [23:16]);
  assign \$20  = $signed(\$18 ) + $signed(\$19 );
  assign \$21  = $signed(\$17 ) + $signed(\$20 );
  assign \$22  = $signed(lanes[31:24]) + $signed(\lanes$11 [31:24]);
  assign \$23  = $signed(\lanes$12 [31:24]) + $signed(\lanes$13 [31:24]);
  assign \$24  = $signed(\$22 ) + $signed(\$23 );
  assign \$25  = $signed(\lanes$14 [31:24]) + $signed(\lanes$15 [31:24]);
  assign \$26  = $signed(\lanes$16 [31:24]) + $signed(\lanes$17 [31:24]);
  assign \$27  = $signed(\$25 ) + $signed(\$26 );
  assign \$28  = $signed(\$24 ) + $signed(\$27 );
  assign \$29  = $signed(lanes[39:32]) + $signed(\lanes$11 [39:32]);
  assign \$30  = $signed(\lanes$12 [39:32]) + $signed(\lanes$13 [39:32]);
  assign \$31  = $signed(\$29 ) + $signed(\$30 );
  assign \$32  = $signed(\lanes$14 [39:32]) + $signed(\lanes$15 [39:32]);
  assign \$33  = $signed(\lanes$16 [39:32]) + $signed(\lanes$17 [39:32]);
  assign \$34  = $signed(\$32 ) + $signed(\$33 );
  assign \$35  = $signed(\$31 ) + $signed(\$34 );
  assign \$36  = $signed(lanes[47:40]) + $signed(\lanes$11 [47:40]);
  macram_lutram #(
    .ADDR_BITS(32'd4),
    .DEPTH(32'd16),
    .INIT_FILE(),
    .LANES(32'd1),
    .WIDTH(32'd38)
  ) carry (
    .clk(clk),
    .read_addr(control[7:4]),
    .read_data(carried__data),
    .write_addr(control[7:4]),
    .write_data(kept__data),
    .write_en(done)
  );
  \macram_unit.engine0  engine0 (
    .clk(clk),
    .lanes(lanes),
    .pixels(pixels),
    .rst(rst),
    .taps(\weight$8 [8:0])
  );
  \macram_unit.engine1  engine1 (
    .clk(clk),
    .lanes(\lanes$11 ),
    .pixels(\pixels$40 ),
    .rst(rst),
    .taps(\weight$8 [17:9])
  );
  \macram_unit.engine2  engine2 (
    .clk(clk),
    .lanes(\lanes$12 ),
    .pixels(\pixels$42 ),
    .rst(rst),
    .taps(\weight$8 [26:18])
  );
  \macram_unit.engine3  engine3 (
    .clk(clk),
    .lanes(\lanes$13 ),
    .pixels(\pixels$44 ),
    .rst(rst),
    .taps(\weight$8 [35:27])
  );
  \macram_unit.engine4  engine4 (
    .clk(clk),
    .lanes(\lanes$14 ),
    .pixels(\pixels$46 ),
    .rst(rst),
    .taps(\weight$8 [44:36])
  );
  \macram_unit.engine5  engine5 (
    .clk(clk),
    .lanes(\lanes$15 ),
    .pixels(\pixels$48 ),
    .rst(rst),
    .taps(\weight$8 [53:45])
  );
  \macram_unit.engine6  engine6 (
    .clk(clk),
    .lanes(\lanes$16 ),
    .pixels(\pixels$50 ),
    .rst(rst),
    .taps(\weight$8 [62:54])
  );
  \macram_unit.engine7  engine7 (
    .clk(clk),
    .lanes(\lanes$17 ),
    .pixels(\pixels$52 ),
    .rst(rst),
    .taps(\weight$8 [71:63])
  );
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$57  = acc0;
    if (control[0]) begin
      \$57  = \$45 [18:0];
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$58  = acc1;
    if (control[0]) begin
      \$58  = \$48 [18:0];
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$59  = acc2;
    if (control[0]) begin
      \$59  = \$50 [18:0];
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$60  = acc3;
    if (control[0]) begin
      \$60  = \$52 [18:0];
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$61  = acc4;
    if (control[0]) begin
      \$61  = \$54 [18:0];
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$62  = acc5;
    if (control[0]) begin
      \$62  = \$56 [18:0];
    end
  end
  always @* begin
    if (\$auto$verilog_backend.cc:2355:dump_module$1 ) begin end
    \$63  = chain_o;
    if (done) begin
      \$63 [18:0] = \$45 [18:0];
      \$63 [37:19] = \$48 [18:0];
      \$63 [56:38] = \$50 [18:0];
      \$63 [75:57] = \$52 [18:0];
    end else if (shift) begin
      \$63  = chain_i;
    end
  end
  assign total0 = \$45 [18:0];
  assign total1 = \$48 [18:0];
  assign total2 = \$50 [18:0];
  assign total3 = \$52 [18:0];
  assign total4 = \$54 [18:0];
  assign total5 = \$56 [18:0];
  assign result = chain_o;
  assign taps = \weight$8 [8:0];
  assign \taps$39  = \weight$8 [17:9];
  assign \taps$41  = \weight$8 [26:18];
  assign \taps$43  = \weight$8 [35:27];
  assign \taps$45  = \weight$8 [44:36];
  assign \taps$47  = \weight$8 [53:45];
  assign \taps$49  = \weight$8 [62:54];
  assign \taps$51  = \weight$8 [71:63];
  assign carried__addr = control[7:4];
  assign kept__addr = control[7:4];
  assign kept__en = done;
  assign \control.en  = control[0];
  assign \control.first  = control[1];
  assign \control.last  = control[2];
  assign \control.edge  = control[3];
  assign \control.tile  = control[7:4];
  assign \chain_i[0]  = chain_i[18:0];
  assign \chain_i[1]  = chain_i[37:19];
  assign \chain_i[2]  = chain_i[56:38];
  assign \chain_i[3]  = chain_i[75:57];
  assign \chain_o[0]  = chain_o[18:0];
  assign \chain_o[1]  = chain_o[37:19];
  assign \chain_o[2]  = chain_o[56:38];
  assign \chain_o[3]  = chain_o[75:57];
  assign \lanes[0]  = lanes[7:0];
  assign \lanes[1]  = lanes[15:8];
  assign \lanes[2]  = lanes[23:16];
  assign \lanes[3]  = lanes[31:24];
  assign \lanes[4]  = lanes[39:32];
  assign \lanes[5]  = lanes[47:40];
  assign \lanes$11[0]  = \lanes$11 [7:0];
  assign \lanes$11[1]  = \lanes$11 [15:8];
  assign \lanes$11[2]  = \lanes$11 [23:16];
  assign \lanes$11[3]  = \lanes$11 [31:24];
  assign \lanes$11[4]  = \lanes$11 [39:32];
  assign \lanes$11[5]  = \lanes$11 [47:40];
  assign \lanes$12[0]  = \lanes$12 [7:0];
  assign \lanes$12[1]  = \lanes$12 [15:8];
  assign \lanes$12[2]  = \lanes$12 [23:16];
  assign \lanes$12[3]  = \lanes$12 [31:24];
  assign \lanes$12[4]  = \lanes$12 [39:32];
  assign \lanes$12[5]  = \lanes$12 [47:40];
  assign \lanes$13[0]  = \lanes$13 [7:0];
  assign \lanes$13[1]  = \lanes$13 [15:8];
  assign \lanes$13[2]  = \lanes$13 [23:16];
  assign \lanes$13[3]  = \lanes$13 [31:24];
  assign \lanes$13[4]  = \lanes$13 [39:32];
  assign \lanes$13[5]  = \lanes$13 [47:40];
  assign \lanes$14[0]  = \lanes$14 [7:0];
  assign \lanes$14[1]  = \lanes$14 [15:8];
  assign \lanes$14[2]  = \lanes$14 [23:16];
  assign \lanes$14[3]  = \lanes$14 [31:24];
  assign \lanes$14[4]  = \lanes$14 [39:32];
  assign \lanes$14[5]  = \lanes$14 [47:40];
  assign \lanes$15[0]  = \lanes$15 [7:0];
  assign \lanes$15[1]  = \lanes$15 [15:8];
  assign \lanes$15[2]  = \lanes$15 [23:16];
  assign \lanes$15[3]  = \lanes$15 [31:24];
  assign \lanes$15[4]  = \lanes$15 [39:32];
  assign \lanes$15[5]  = \lanes$15 [47:40];
  assign \lanes$16[0]  = \lanes$16 [7:0];
  assign \lanes$16[1]  = \lanes$16 [15:8];
  assign \lanes$16[2]  = \lanes$16 [23:16];
  assign \lanes$16[3]  = \lanes$16 [31:24];
  assign \lanes$16[4]  = \lanes$16 [39:32];
  assign \lanes$16[5]  = \lanes$16 [47:40];
  assign \lanes$17[0]  = \lanes$17 [7:0];
  assign \lanes$17[1]  = \lanes$17 [15:8];
  assign \lanes$17[2]  = \lanes$17 [23:16];
  assign \lanes$17[3]  = \lanes$17 [31:24];
  assign \lanes$17[4]  = \lanes$17 [39:32];
  assign \lanes$17[5]  = \lanes$17 [47:40];
  assign \result[0]  = chain_o[18:0];
  assign \result[1]  = chain_o[37:19];
  assign \result[2]  = chain_o[56:38];
  assign \result[3]  = chain_o[75:57];
  assign \taps[0]  = \weight$8 [2:0];
  assign \taps[1]  = \weight$8 [5:3];
  assign \taps[2]  = \weight$8 [8:6];
  assign \pixels[0]  = pixels[2:0];
  assign \pixels[1]  = pixels[5:3];
  assign \pixels[2]  = pixels[8:6];
  assign \pixels[3]  = pixels[11:9];
  assign \taps$39[0]  = \weight$8 [11:9];
  assign \taps$39[1]  = \weight$8 [14:12];
  assign \taps$39[2]  = \weight$8 [17:15];
  assign \pixels$40[0]  = \pixels$40 [2:0];
  assign \pixels$40[1]  = \pixels$40 [5:3];
  assign \pixels$40[2]  = \pixels$40 [8:6];
  assign \pixels$40[3]  = \pixels$40 [11:9];
  assign \taps$41[0]  = \weight$8 [20:18];
  assign \taps$41[1]  = \weight$8 [23:21];
  assign \taps$41[2]  = \weight$8 [26:24];
  assign \pixels$42[0]  = \pixels$42 [2:0];
  assign \pixels$42[1]  = \pixels$42 [5:3];
  assign \pixels$42[2]  = \pixels$42 [8:6];
  assign \pixels$42[3]  = \pixels$42 [11:9];
  assign \taps$43[0]  = \weight$8 [29:27];
  assign \taps$43[1]  = \weight$8 [32:30];
  assign \taps$43[2]  = \weight$8 [35:33];
  assign \pixels$44[0]  = \pixels$44 [2:0];
  assign \pixels$44[1]  = \pixels$44 [5:3];
  assign \pixels$44[2]  = \pixels$44 [8:6];
  assign \pixels$44[3]  = \pixels$44 [11:9];
  assign \taps$45[0]  = \weight$8 [38:36];
  assign \taps$45[1]  = \weight$8 [41:39];
  assign \taps$45[2]  = \weight$8 [44:42];
  assign \pixels$46[0]  = \pixels$46 [2:0];
  assign \pixels$46[1]  = \pixels$46 [5:3];
  assign \pixels$46[2]  = \pixels$46 [8:6];
  assign \pixels$46[3]  = \pixels$46 [11:9];
  assign \taps$47[0]  = \weight$8 [47:45];
  assign \taps$47[1]  = \weight$8 [50:48];
  assign \taps$47[2]  = \weight$8 [53:51];
  assign \pixels$48[0]  = \pixels$48 [2:0];
  assign \pixels$48[1]  = \pixels$48 [5:3];
  assign \pixels$48[2]  = \pixels$48 [8:6];
  assign \pixels$48[3]  = \pixels$48 [11:9];
  assign \taps$49[0]  = \weight$8 [56:54];
  assign \taps$49[1]  = \weight$8 [59:57];
  assign \taps$49[2]  = \weight$8 [62:60];
  assign \pixels$50[0]  = \pixels$50 [2:0];
  assign \pixels$50[1]  = \pixels$50 [5:3];
  assign \pixels$50[2]  = \pixels$50 [8:6];
  assign \pixels$50[3]  = \pixels$50 [11:9];
  assign \taps$51[0]  = \weight$8 [65:63];
  assign \taps$51[1]  = \weight$8 [68:66];
  assign \taps$51[2]  = \weight$8 [71:69];
  assign \pixels$52[0]  = \pixels$52 [2:0];
  assign \pixels$52[1]  = \pixels$52 [5:3];
  assign \pixels$52[2]  = \pixels$52 [8:6];
  assign \pixels$52[3]  = \pixels$52 [11:9];
  assign \carried__data[0]  = carried__data[18:0];
  assign \carried__data[1]  = carried__data[37:19];
  assign \kept__data[0]  = kept__data[18:0];
  assign \kept__data[1]  = kept__data[37:19];
  assign kept__data[37:19] = \$56 [18:0];
  assign kept__data[18:0] = \$54 [18:0];
  assign \pixels$52 [11:9] = activations[95:93];
  assign \pixels$52 [8:6] = activations[71:69];
  assign \pixels$52 [5:3] = activations[47:45];
  assign \pixels$52 [2:0] = activations[23:21];
  assign \pixels$50 [11:9] = activations[92:90];
  assign \pixels$50 [8:6] = activations[68:66];
  assign \pixels$50 [5:3] = activations[44:42];
  assign \pixels$50 [2:0] = activations[20:18];
  assign \pixels$48 [11:9] = activations[89:87];
  assign \pixels$48 [8:6] = activations[65:63];
  assign \pixels$48 [5:3] = activations[41:39];
  assign \pixels$48 [2:0] = activations[17:15];
  assign \pixels$46 [11:9] = activations[86:84];
  assign \pixels$46 [8:6] = activations[62:60];
  assign \pixels$46 [5:3] = activations[38:36];
  assign \pixels$46 [2:0] = activations[14:12];
  assign \pixels$44 [11:9] = activations[83:81];
  assign \pixels$44 [8:6] = activations[59:57];
  assign \pixels$44 [5:3] = activations[35:33];
  assign \pixels$44 [2:0] = activations[11:9];
  assign \pixels$42 [11:9] = activations[80:78];
  assign \pixels$42 [8:6] = activations[56:54];
  assign \pixels$42 [5:3] = activations[32:30];
  assign \pixels$42 [2:0] = activations[8:6];
  assign \pixels$40 [11:9] = activations[77:75];
  assign \pixels$40 [8:6] = activations[53:51];
  assign \pixels$40 [5:3] = activations[29:27];
  assign \pixels$40 [2:0] = activations[5:3];
  assign pixels[11:9] = activations[74:72];
  assign pixels[8:6] = activations[50:48];
  assign pixels[5:3] = activations[26:24];
  assign pixels[2:0] = activations[2:0];
endmodule

module \macram_unit.engine0 (rst, taps, pixels, lanes, clk);
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
  input [11:0] pixels;
  wire [11:0] pixels;
  wire [2:0] \pixels[0] ;
  wire [2:0] \pixels[1] ;
  wire [2:0] \pixels[2] ;
  wire [2:0] \pixels[3] ;
  input rst;
  wire rst;
  input [8:0] taps;
  wire [8:0] taps;
  wire [2:0] \taps[0] ;
  wire [2:0] \taps[1] ;
  wire [2:0] \taps[2] ;
  assign \$1  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[2:0]);
  assign \$2  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[2:0]);
  assign \$3  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[5:3]);
  assign \$4  = $signed(\$2 ) + $signed(\$3 );
  assign \$5  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[2:0]);
  assign \$6  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[5:3]);
  assign \$7  = $signed(\$5 ) + $signed(\$6 );
  assign \$8  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[8:6]);
  assign \$9  = $signed(\$7 ) + $signed(\$8 );
  assign \$10  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[2:0]);
  assign \$11  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[5:3]);
  assign \$12  = $signed(\$10 ) + $signed(\$11 );
  assign \$13  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[8:6]);
  assign \$14  = $signed(\$12 ) + $signed(\$13 );
  assign \$15  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[5:3]);
  assign \$16  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[8:6]);
  assign \$17  = $signed(\$15 ) + $signed(\$16 );
  assign \$18  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[8:6]);
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
  assign \lanes[0]  = lanes[7:0];
  assign \lanes[1]  = lanes[15:8];
  assign \lanes[2]  = lanes[23:16];
  assign \lanes[3]  = lanes[31:24];
  assign \lanes[4]  = lanes[39:32];
  assign \lanes[5]  = lanes[47:40];
  assign \pixels[0]  = pixels[2:0];
  assign \pixels[1]  = pixels[5:3];
  assign \pixels[2]  = pixels[8:6];
  assign \pixels[3]  = pixels[11:9];
  assign \taps[0]  = taps[2:0];
  assign \taps[1]  = taps[5:3];
  assign \taps[2]  = taps[8:6];
endmodule

module \macram_unit.engine1 (rst, taps, pixels, lanes, clk);
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
  input [11:0] pixels;
  wire [11:0] pixels;
  wire [2:0] \pixels[0] ;
  wire [2:0] \pixels[1] ;
  wire [2:0] \pixels[2] ;
  wire [2:0] \pixels[3] ;
  input rst;
  wire rst;
  input [8:0] taps;
  wire [8:0] taps;
  wire [2:0] \taps[0] ;
  wire [2:0] \taps[1] ;
  wire [2:0] \taps[2] ;
  assign \$1  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[2:0]);
  assign \$2  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[2:0]);
  assign \$3  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[5:3]);
  assign \$4  = $signed(\$2 ) + $signed(\$3 );
  assign \$5  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[2:0]);
  assign \$6  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[5:3]);
  assign \$7  = $signed(\$5 ) + $signed(\$6 );
  assign \$8  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[8:6]);
  assign \$9  = $signed(\$7 ) + $signed(\$8 );
  assign \$10  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[2:0]);
  assign \$11  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[5:3]);
  assign \$12  = $signed(\$10 ) + $signed(\$11 );
  assign \$13  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[8:6]);
  assign \$14  = $signed(\$12 ) + $signed(\$13 );
  assign \$15  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[5:3]);
  assign \$16  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[8:6]);
  assign \$17  = $signed(\$15 ) + $signed(\$16 );
  assign \$18  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[8:6]);
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
  assign \lanes[0]  = lanes[7:0];
  assign \lanes[1]  = lanes[15:8];
  assign \lanes[2]  = lanes[23:16];
  assign \lanes[3]  = lanes[31:24];
  assign \lanes[4]  = lanes[39:32];
  assign \lanes[5]  = lanes[47:40];
  assign \pixels[0]  = pixels[2:0];
  assign \pixels[1]  = pixels[5:3];
  assign \pixels[2]  = pixels[8:6];
  assign \pixels[3]  = pixels[11:9];
  assign \taps[0]  = taps[2:0];
  assign \taps[1]  = taps[5:3];
  assign \taps[2]  = taps[8:6];
endmodule

module \macram_unit.engine2 (rst, taps, pixels, lanes, clk);
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
  input [11:0] pixels;
  wire [11:0] pixels;
  wire [2:0] \pixels[0] ;
  wire [2:0] \pixels[1] ;
  wire [2:0] \pixels[2] ;
  wire [2:0] \pixels[3] ;
  input rst;
  wire rst;
  input [8:0] taps;
  wire [8:0] taps;
  wire [2:0] \taps[0] ;
  wire [2:0] \taps[1] ;
  wire [2:0] \taps[2] ;
  assign \$1  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[2:0]);
  assign \$2  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[2:0]);
  assign \$3  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[5:3]);
  assign \$4  = $signed(\$2 ) + $signed(\$3 );
  assign \$5  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[2:0]);
  assign \$6  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[5:3]);
  assign \$7  = $signed(\$5 ) + $signed(\$6 );
  assign \$8  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[8:6]);
  assign \$9  = $signed(\$7 ) + $signed(\$8 );
  assign \$10  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[2:0]);
  assign \$11  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[5:3]);
  assign \$12  = $signed(\$10 ) + $signed(\$11 );
  assign \$13  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[8:6]);
  assign \$14  = $signed(\$12 ) + $signed(\$13 );
  assign \$15  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[5:3]);
  assign \$16  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[8:6]);
  assign \$17  = $signed(\$15 ) + $signed(\$16 );
  assign \$18  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[8:6]);
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
  assign \lanes[0]  = lanes[7:0];
  assign \lanes[1]  = lanes[15:8];
  assign \lanes[2]  = lanes[23:16];
  assign \lanes[3]  = lanes[31:24];
  assign \lanes[4]  = lanes[39:32];
  assign \lanes[5]  = lanes[47:40];
  assign \pixels[0]  = pixels[2:0];
  assign \pixels[1]  = pixels[5:3];
  assign \pixels[2]  = pixels[8:6];
  assign \pixels[3]  = pixels[11:9];
  assign \taps[0]  = taps[2:0];
  assign \taps[1]  = taps[5:3];
  assign \taps[2]  = taps[8:6];
endmodule

module \macram_unit.engine3 (rst, taps, pixels, lanes, clk);
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
  input [11:0] pixels;
  wire [11:0] pixels;
  wire [2:0] \pixels[0] ;
  wire [2:0] \pixels[1] ;
  wire [2:0] \pixels[2] ;
  wire [2:0] \pixels[3] ;
  input rst;
  wire rst;
  input [8:0] taps;
  wire [8:0] taps;
  wire [2:0] \taps[0] ;
  wire [2:0] \taps[1] ;
  wire [2:0] \taps[2] ;
  assign \$1  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[2:0]);
  assign \$2  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[2:0]);
  assign \$3  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[5:3]);
  assign \$4  = $signed(\$2 ) + $signed(\$3 );
  assign \$5  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[2:0]);
  assign \$6  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[5:3]);
  assign \$7  = $signed(\$5 ) + $signed(\$6 );
  assign \$8  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[8:6]);
  assign \$9  = $signed(\$7 ) + $signed(\$8 );
  assign \$10  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[2:0]);
  assign \$11  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[5:3]);
  assign \$12  = $signed(\$10 ) + $signed(\$11 );
  assign \$13  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[8:6]);
  assign \$14  = $signed(\$12 ) + $signed(\$13 );
  assign \$15  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[5:3]);
  assign \$16  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[8:6]);
  assign \$17  = $signed(\$15 ) + $signed(\$16 );
  assign \$18  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[8:6]);
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
  assign \lanes[0]  = lanes[7:0];
  assign \lanes[1]  = lanes[15:8];
  assign \lanes[2]  = lanes[23:16];
  assign \lanes[3]  = lanes[31:24];
  assign \lanes[4]  = lanes[39:32];
  assign \lanes[5]  = lanes[47:40];
  assign \pixels[0]  = pixels[2:0];
  assign \pixels[1]  = pixels[5:3];
  assign \pixels[2]  = pixels[8:6];
  assign \pixels[3]  = pixels[11:9];
  assign \taps[0]  = taps[2:0];
  assign \taps[1]  = taps[5:3];
  assign \taps[2]  = taps[8:6];
endmodule

module \macram_unit.engine4 (rst, taps, pixels, lanes, clk);
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
  input [11:0] pixels;
  wire [11:0] pixels;
  wire [2:0] \pixels[0] ;
  wire [2:0] \pixels[1] ;
  wire [2:0] \pixels[2] ;
  wire [2:0] \pixels[3] ;
  input rst;
  wire rst;
  input [8:0] taps;
  wire [8:0] taps;
  wire [2:0] \taps[0] ;
  wire [2:0] \taps[1] ;
  wire [2:0] \taps[2] ;
  assign \$1  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[2:0]);
  assign \$2  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[2:0]);
  assign \$3  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[5:3]);
  assign \$4  = $signed(\$2 ) + $signed(\$3 );
  assign \$5  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[2:0]);
  assign \$6  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[5:3]);
  assign \$7  = $signed(\$5 ) + $signed(\$6 );
  assign \$8  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[8:6]);
  assign \$9  = $signed(\$7 ) + $signed(\$8 );
  assign \$10  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[2:0]);
  assign \$11  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[5:3]);
  assign \$12  = $signed(\$10 ) + $signed(\$11 );
  assign \$13  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[8:6]);
  assign \$14  = $signed(\$12 ) + $signed(\$13 );
  assign \$15  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[5:3]);
  assign \$16  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[8:6]);
  assign \$17  = $signed(\$15 ) + $signed(\$16 );
  assign \$18  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[8:6]);
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
  assign \lanes[0]  = lanes[7:0];
  assign \lanes[1]  = lanes[15:8];
  assign \lanes[2]  = lanes[23:16];
  assign \lanes[3]  = lanes[31:24];
  assign \lanes[4]  = lanes[39:32];
  assign \lanes[5]  = lanes[47:40];
  assign \pixels[0]  = pixels[2:0];
  assign \pixels[1]  = pixels[5:3];
  assign \pixels[2]  = pixels[8:6];
  assign \pixels[3]  = pixels[11:9];
  assign \taps[0]  = taps[2:0];
  assign \taps[1]  = taps[5:3];
  assign \taps[2]  = taps[8:6];
endmodule

module \macram_unit.engine5 (rst, taps, pixels, lanes, clk);
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
  input [11:0] pixels;
  wire [11:0] pixels;
  wire [2:0] \pixels[0] ;
  wire [2:0] \pixels[1] ;
  wire [2:0] \pixels[2] ;
  wire [2:0] \pixels[3] ;
  input rst;
  wire rst;
  input [8:0] taps;
  wire [8:0] taps;
  wire [2:0] \taps[0] ;
  wire [2:0] \taps[1] ;
  wire [2:0] \taps[2] ;
  assign \$1  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[2:0]);
  assign \$2  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[2:0]);
  assign \$3  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[5:3]);
  assign \$4  = $signed(\$2 ) + $signed(\$3 );
  assign \$5  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[2:0]);
  assign \$6  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[5:3]);
  assign \$7  = $signed(\$5 ) + $signed(\$6 );
  assign \$8  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[8:6]);
  assign \$9  = $signed(\$7 ) + $signed(\$8 );
  assign \$10  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[2:0]);
  assign \$11  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[5:3]);
  assign \$12  = $signed(\$10 ) + $signed(\$11 );
  assign \$13  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[8:6]);
  assign \$14  = $signed(\$12 ) + $signed(\$13 );
  assign \$15  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[5:3]);
  assign \$16  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[8:6]);
  assign \$17  = $signed(\$15 ) + $signed(\$16 );
  assign \$18  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[8:6]);
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
  assign \lanes[0]  = lanes[7:0];
  assign \lanes[1]  = lanes[15:8];
  assign \lanes[2]  = lanes[23:16];
  assign \lanes[3]  = lanes[31:24];
  assign \lanes[4]  = lanes[39:32];
  assign \lanes[5]  = lanes[47:40];
  assign \pixels[0]  = pixels[2:0];
  assign \pixels[1]  = pixels[5:3];
  assign \pixels[2]  = pixels[8:6];
  assign \pixels[3]  = pixels[11:9];
  assign \taps[0]  = taps[2:0];
  assign \taps[1]  = taps[5:3];
  assign \taps[2]  = taps[8:6];
endmodule

module \macram_unit.engine6 (rst, taps, pixels, lanes, clk);
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
  input [11:0] pixels;
  wire [11:0] pixels;
  wire [2:0] \pixels[0] ;
  wire [2:0] \pixels[1] ;
  wire [2:0] \pixels[2] ;
  wire [2:0] \pixels[3] ;
  input rst;
  wire rst;
  input [8:0] taps;
  wire [8:0] taps;
  wire [2:0] \taps[0] ;
  wire [2:0] \taps[1] ;
  wire [2:0] \taps[2] ;
  assign \$1  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[2:0]);
  assign \$2  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[2:0]);
  assign \$3  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[5:3]);
  assign \$4  = $signed(\$2 ) + $signed(\$3 );
  assign \$5  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[2:0]);
  assign \$6  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[5:3]);
  assign \$7  = $signed(\$5 ) + $signed(\$6 );
  assign \$8  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[8:6]);
  assign \$9  = $signed(\$7 ) + $signed(\$8 );
  assign \$10  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[2:0]);
  assign \$11  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[5:3]);
  assign \$12  = $signed(\$10 ) + $signed(\$11 );
  assign \$13  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[8:6]);
  assign \$14  = $signed(\$12 ) + $signed(\$13 );
  assign \$15  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[5:3]);
  assign \$16  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[8:6]);
  assign \$17  = $signed(\$15 ) + $signed(\$16 );
  assign \$18  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[8:6]);
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
  assign \lanes[0]  = lanes[7:0];
  assign \lanes[1]  = lanes[15:8];
  assign \lanes[2]  = lanes[23:16];
  assign \lanes[3]  = lanes[31:24];
  assign \lanes[4]  = lanes[39:32];
  assign \lanes[5]  = lanes[47:40];
  assign \pixels[0]  = pixels[2:0];
  assign \pixels[1]  = pixels[5:3];
  assign \pixels[2]  = pixels[8:6];
  assign \pixels[3]  = pixels[11:9];
  assign \taps[0]  = taps[2:0];
  assign \taps[1]  = taps[5:3];
  assign \taps[2]  = taps[8:6];
endmodule

module \macram_unit.engine7 (rst, taps, pixels, lanes, clk);
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
  input [11:0] pixels;
  wire [11:0] pixels;
  wire [2:0] \pixels[0] ;
  wire [2:0] \pixels[1] ;
  wire [2:0] \pixels[2] ;
  wire [2:0] \pixels[3] ;
  input rst;
  wire rst;
  input [8:0] taps;
  wire [8:0] taps;
  wire [2:0] \taps[0] ;
  wire [2:0] \taps[1] ;
  wire [2:0] \taps[2] ;
  assign \$1  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[2:0]);
  assign \$2  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[2:0]);
  assign \$3  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[5:3]);
  assign \$4  = $signed(\$2 ) + $signed(\$3 );
  assign \$5  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[2:0]);
  assign \$6  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[5:3]);
  assign \$7  = $signed(\$5 ) + $signed(\$6 );
  assign \$8  = $signed({ 1'h0, pixels[2:0] }) * $signed(taps[8:6]);
  assign \$9  = $signed(\$7 ) + $signed(\$8 );
  assign \$10  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[2:0]);
  assign \$11  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[5:3]);
  assign \$12  = $signed(\$10 ) + $signed(\$11 );
  assign \$13  = $signed({ 1'h0, pixels[5:3] }) * $signed(taps[8:6]);
  assign \$14  = $signed(\$12 ) + $signed(\$13 );
  assign \$15  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[5:3]);
  assign \$16  = $signed({ 1'h0, pixels[8:6] }) * $signed(taps[8:6]);
  assign \$17  = $signed(\$15 ) + $signed(\$16 );
  assign \$18  = $signed({ 1'h0, pixels[11:9] }) * $signed(taps[8:6]);
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
  assign \lanes[0]  = lanes[7:0];
  assign \lanes[1]  = lanes[15:8];
  assign \lanes[2]  = lanes[23:16];
  assign \lanes[3]  = lanes[31:24];
  assign \lanes[4]  = lanes[39:32];
  assign \lanes[5]  = lanes[47:40];
  assign \pixels[0]  = pixels[2:0];
  assign \pixels[1]  = pixels[5:3];
  assign \pixels[2]  = pixels[8:6];
  assign \pixels[3]  = pixels[11:9];
  assign \taps[0]  = taps[2:0];
  assign \taps[1]  = taps[5:3];
  assign \taps[2]  = taps[8:6];
endmodule
