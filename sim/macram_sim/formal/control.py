"""Proofs about control: the register bus answers every request once, and a run comes to its end."""

from __future__ import annotations

from macram.spec import BY_NAME, REGISTERS
from macram.spec.registers import ADDRESS_BITS, LOAD_REGISTERS, MODE_3X3
from macram_sim.formal.designs import SMALL
from macram_sim.formal.harness import OPENING
from macram_sim.formal.proof import Break, Proof

_REGISTERS = f"""
    (* anyseq *) wire [{ADDRESS_BITS - 1}:0] awaddr, araddr; (* anyseq *) wire awvalid, wvalid, bready;
    (* anyseq *) wire arvalid, rready;
    (* anyseq *) wire [31:0] wdata; (* anyseq *) wire [3:0] wstrb; (* anyseq *) wire busy, loading;
    wire awready, wready, bvalid, arready, rvalid; wire [1:0] bresp, rresp; wire [31:0] rdata; wire [3:0] command;
    wire [31:0] height, mode, width;
    dut dut(.clk(clk), .rst(rst), .axi__awaddr(awaddr), .axi__awprot(3'd0), .axi__awvalid(awvalid),
        .axi__awready(awready), .axi__wdata(wdata), .axi__wstrb(wstrb), .axi__wvalid(wvalid), .axi__wready(wready),
        .axi__bresp(bresp), .axi__bvalid(bvalid), .axi__bready(bready), .axi__araddr(araddr), .axi__arprot(3'd0),
        .axi__arvalid(arvalid), .axi__arready(arready), .axi__rdata(rdata), .axi__rresp(rresp), .axi__rvalid(rvalid),
        .axi__rready(rready), .busy(busy), .loading(loading), .command(command), .height(height),
        .width(width), .mode(mode));
    // A manager keeps what it offers.
    reg aw_waits = 0, w_waits = 0, ar_waits = 0; reg [{ADDRESS_BITS - 1}:0] aw_was, ar_was; reg [35:0] w_was;
    always @(posedge clk) begin
        aw_waits <= awvalid && !awready && !rst; aw_was <= awaddr;
        w_waits <= wvalid && !wready && !rst; w_was <= {{wdata, wstrb}};
        ar_waits <= arvalid && !arready && !rst; ar_was <= araddr;
    end
    always @* begin
        if (aw_waits) assume (awvalid && awaddr == aw_was);
        if (w_waits) assume (wvalid && {{wdata, wstrb}} == w_was);
        if (ar_waits) assume (arvalid && araddr == ar_was);
    end
    reg has_address = 0, has_data = 0, has_read = 0;
    always @(posedge clk) if (rst) begin has_address <= 0; has_data <= 0; has_read <= 0; end else begin
        if (awvalid && awready) has_address <= 1; else if (bvalid && bready) has_address <= 0;
        if (wvalid && wready) has_data <= 1; else if (bvalid && bready) has_data <= 0;
        if (arvalid && arready) has_read <= 1; else if (rvalid && rready) has_read <= 0;
    end
"""


def _answers() -> str:
    """One request of each kind in flight; an answer exactly when one is, at once, and held until taken."""
    return (
        OPENING
        + _REGISTERS
        + """
    reg b_waits = 0, r_waits = 0, both = 0, read = 0; reg [1:0] b_was, r_was; reg [31:0] data_was;
    always @(posedge clk) begin
        b_waits <= bvalid && !bready && !rst; b_was <= bresp;
        r_waits <= rvalid && !rready && !rst; r_was <= rresp; data_was <= rdata;
        both <= has_address && has_data && !bvalid && !rst;
        read <= has_read && !rvalid && !rst;
        if (!rst) begin
            assert (awready == !has_address && wready == !has_data && arready == !has_read);
            if (bvalid) assert (has_address && has_data);
            if (rvalid) assert (has_read);
            if (b_waits) assert (bvalid && bresp == b_was);
            if (r_waits) assert (rvalid && rresp == r_was && rdata == data_was);
            if (both) assert (bvalid);
            if (read) assert (rvalid);
            if (command != 0) assert (bvalid && bresp == 0);
        end
    end
endmodule
"""
    )


def _decode() -> str:
    """Who is answered SLVERR, and what a write changes."""
    stored = " || ".join(f"word == {r.offset >> 2}" for r in REGISTERS if r.access == "RW")
    load = " || ".join(f"word == {r.offset >> 2}" for r in REGISTERS if r.name in LOAD_REGISTERS)
    mapped = " || ".join(f"read_word == {r.offset >> 2}" for r in REGISTERS)
    control, wide = BY_NAME["CONTROL"].offset >> 2, BY_NAME["HEIGHT"].offset >> 2
    return (
        OPENING
        + _REGISTERS
        + f"""
    reg [{ADDRESS_BITS - 3}:0] word, read_word; reg [31:0] data; reg [3:0] strobe;
    reg was_busy, was_loading, b_was = 0, r_was = 0; reg [31:0] height_was;
    wire [3:0] wanted = strobe[0] ? data[3:0] : 4'd0;
    wire is_stored = {stored};
    wire is_control = word == {control};
    wire is_load = {load};
    wire accepted = is_control || (is_stored && !(is_load ? was_loading : was_busy));
    always @(posedge clk) begin
        if (awvalid && awready) word <= awaddr >> 2;
        if (arvalid && arready) read_word <= araddr >> 2;
        if (wvalid && wready) begin data <= wdata; strobe <= wstrb; end
        was_busy <= busy; was_loading <= loading; b_was <= bvalid; r_was <= rvalid; height_was <= height;
        if (!rst && age > 1) begin
            if (bvalid && !b_was) begin
                assert (bresp == (accepted ? 0 : 2));
                assert (command == (is_control && accepted ? wanted : 0));
                if (word == {wide} && accepted && strobe[1]) assert (height[15:8] == data[15:8]);
                if (!(word == {wide} && accepted)) assert (height == height_was);
            end else begin
                assert (command == 0 && height == height_was);
            end
            if (rvalid && !r_was) assert (rresp == (({mapped}) ? 0 : 2));
        end
    end
endmodule
"""
    )


RUN_CYCLES = 58
"""Cycles from reset by which every run of `_run` has ended."""


def _run() -> str:
    """From START to DONE: 4 pixels in 2 rows, 2 blocks, or 2 tiles of 2 pixels, or less; any contents, gaps, stalls."""
    bits = SMALL.stream_bits
    return (
        OPENING
        + f"""
    (* anyconst *) reg [1:0] height; (* anyconst *) reg [2:0] width; (* anyconst *) reg [1:0] c_in;
    (* anyconst *) reg [3:0] c_out;
    always @* assume (height >= 1 && height <= 2 && width >= 1 && width <= 4 && height * width <= 4);
    always @* assume (c_in >= 1 && c_in <= 2 && c_out >= 1 && c_out <= 8);
    always @* if (c_out > 4) assume (c_in == 1 && height * width <= 2);
    (* anyseq *) wire valid; (* anyseq *) wire ready; (* anyseq *) wire [{bits - 1}:0] data;
    wire in_ready, out_valid, busy, done; wire [{bits}:0] out; wire [2:0] error;
    reg [5:0] taken = 0, came = 0;
    wire [5:0] pixels = height * width;  // one beat each, in and out
    dut dut(.clk(clk), .rst(rst), .height({{30'd0, height}}), .width({{29'd0, width}}), .c_in({{30'd0, c_in}}),
        .c_out({{28'd0, c_out}}), .mode(32'd{MODE_3X3}), .words(0), .param_base(0), .weight_base(0),
        .requant_base(0), .command(age == 4 ? 3'd1 : 3'd0),
        .busy(busy), .done(done),
        .error(error), .i__payload({{taken + 6'd1 == pixels, data}}), .i__valid(valid), .i__ready(in_ready),
        .params__payload(0), .params__valid(1'b0), .o__payload(out), .o__valid(out_valid), .o__ready(ready));
    // Fair streams: never two idle cycles in a row. A source keeps what it offers.
    reg idle = 0, stalled = 0, waits = 0; reg [{bits - 1}:0] data_was;
    always @(posedge clk) begin
        idle <= !valid; stalled <= !ready; waits <= valid && !in_ready; data_was <= data;
    end
    always @* begin
        assume (!(idle && !valid) && !(stalled && !ready));
        if (waits) assume (valid && data == data_was);
    end
    always @(posedge clk) if (!rst) begin
        taken <= taken + (valid && in_ready); came <= came + (out_valid && ready);
        if (valid && in_ready) assert (taken < pixels);
        if (out_valid) assert (came < pixels && out[{bits}] == (came + 6'd1 == pixels));
        if (out_valid) assert (taken > came || taken == pixels);
        if (done) assert (taken == pixels && came == pixels && !busy);
        assert (error == 0);
        if (age == {RUN_CYCLES}) assert (done);
    end
endmodule
"""
    )


_AXI = "axi_lite.py"

CONTROL: tuple[Proof, ...] = (
    Proof(
        "bus-answers",
        "every register access is answered once, nothing else is, and an answer waits unchanged",
        "registers",
        _answers,
        5,
        True,
        ("axi_lite", "top"),
        (
            Break(_AXI, "axi.awready.eq(~address_held)", "axi.awready.eq(1)"),
            Break(
                _AXI,
                "m.d.sync += [axi.bvalid.eq(0), address_held.eq(0), data_held.eq(0)]",
                "m.d.sync += [axi.bvalid.eq(0), address_held.eq(0)]",
            ),
            Break(_AXI, "m.Elif(address_held & data_held)", "m.Elif(address_held | data_held)"),
            Break(_AXI, "m.d.sync += self.command.eq(0)", "m.d.sync += self.command.eq(self.command)"),
        ),
    ),
    Proof(
        "bus-decode",
        "SLVERR for read-only and unmapped addresses and while busy; refused writes change nothing",
        "registers",
        _decode,
        9,
        False,
        ("axi_lite", "top"),
        (
            Break(_AXI, "with m.If(~locked):", "with m.If(locked | 1):"),
            Break(
                _AXI,
                "m.d.sync += [axi.bresp.eq(OKAY), self.command.eq(wanted)]",
                "m.d.sync += [axi.bresp.eq(SLVERR), self.command.eq(wanted)]",
            ),
            Break(_AXI, "with m.If(strobe[byte]):", "with m.If(strobe[0]):"),
            Break(_AXI, "m.d.sync += axi.rresp.eq(SLVERR)", "m.d.sync += axi.rresp.eq(OKAY)"),
        ),
    ),
    Proof(
        "run-ends",
        "a started run takes and gives exactly its beats and is done in time, whatever gaps and stalls",
        "array",
        _run,
        RUN_CYCLES + 1,
        False,
        ("array", "sequencer", "drain", "line_buffer", "shape", "gearbox"),
        (
            Break(
                "drain.py",
                "credit.eq(active & (index[:-1] == self.credit_at) & round_last)",
                "credit.eq(last_cycle & info.tile_last)",
                late=True,
            ),
            Break(
                "sequencer.py",
                "pixels_ready.eq(~first_of_group | self.image_written | (ahead > 0) | flushing)",
                "pixels_ready.eq(~first_of_group | (ahead > 0) | flushing)",
                late=True,
            ),
            Break(
                "line_buffer.py",
                "free.eq(Mux(shape.pointwise, ROWS_HELD, ROWS_HELD - 1) * shape.groups)",
                "free.eq(shape.groups)",
                late=True,
            ),
            Break(
                "sequencer.py",
                "image_last.eq(flushing | (row_last & group_last & ((shape.tail != 0) | shape.packed)))",
                "image_last.eq(row_last & group_last)",
            ),
        ),
        fast=False,
    ),
)
