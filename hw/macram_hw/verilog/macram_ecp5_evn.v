// The self-test on Lattice's ECP5 evaluation board (LFE5UM5G-85F-EVN): 12 MHz in, a PLL, eight lamps that light when low.
module macram_ecp5_evn #(
    // 12 MHz / CLKI_DIV * CLKFB_DIV is the array's clock, CLKOP_DIV times that the oscillator's (400 to 800 MHz).
    parameter CLKI_DIV = 3,
    parameter CLKFB_DIV = 25,
    parameter CLKOP_DIV = 6
) (
    input  wire       clk12,
    input  wire       button_n,
    output wire [7:0] led_n
);
    wire clk, locked;

    (* FREQUENCY_PIN_CLKI = "12" *)
    EHXPLLL #(
        .PLLRST_ENA("DISABLED"),
        .INTFB_WAKE("DISABLED"),
        .STDBY_ENABLE("DISABLED"),
        .DPHASE_SOURCE("DISABLED"),
        .OUTDIVIDER_MUXA("DIVA"),
        .OUTDIVIDER_MUXB("DIVB"),
        .OUTDIVIDER_MUXC("DIVC"),
        .OUTDIVIDER_MUXD("DIVD"),
        .CLKI_DIV(CLKI_DIV),
        .CLKOP_ENABLE("ENABLED"),
        .CLKOP_DIV(CLKOP_DIV),
        .CLKOP_CPHASE(CLKOP_DIV - 1),
        .CLKOP_FPHASE(0),
        .FEEDBK_PATH("CLKOP"),
        .CLKFB_DIV(CLKFB_DIV)
    ) pll (
        .RST(1'b0),
        .STDBY(1'b0),
        .CLKI(clk12),
        .CLKOP(clk),
        .CLKFB(clk),
        .CLKINTFB(),
        .PHASESEL0(1'b0),
        .PHASESEL1(1'b0),
        .PHASEDIR(1'b1),
        .PHASESTEP(1'b1),
        .PHASELOADREG(1'b1),
        .PLLWAKESYNC(1'b0),
        .ENCLKOP(1'b0),
        .LOCK(locked)
    );

    // The reset ends with the clock; the button is sampled twice before it counts.
    reg [1:0] held = 2'b11;
    always @(posedge clk) held <= {held[0], !locked || !button_n};

    wire passed, failed, blink;
    macram_selftest selftest (.clk(clk), .rst(held[1]), .passed(passed), .failed(failed), .blink(blink));

    // Pass, fail, blink while runs pass, and the PLL's lock.
    assign led_n = ~{4'b0000, locked, blink, failed, passed};
endmodule
