# The block design: Zynq UltraScale+ PS, the array, one DMA per stream, SmartConnects. Sourced by build.tcl.

# The newest version in the catalogue of an IP core, as vendor:library:name:version.
proc newest {name} {
    set found [get_ipdefs -quiet -all "xilinx.com:ip:${name}:*"]
    if {[llength $found] == 0} {
        error "this Vivado has no IP core $name; install device support for Zynq UltraScale+"
    }
    return [lindex [lsort -dictionary $found] end]
}

proc add_cell {name ip {configuration {}}} {
    set cell [create_bd_cell -type ip -vlnv [newest $ip] $name]
    if {[llength $configuration]} {
        set_property -dict $configuration $cell
    }
    return $cell
}

# One net from a driver to every pin of a list.
proc fan_out {driver pins} {
    foreach pin $pins {
        connect_bd_net [get_bd_pins $driver] [get_bd_pins $pin]
    }
}

proc join_interfaces {from to} {
    connect_bd_intf_net [get_bd_intf_pins $from] [get_bd_intf_pins $to]
}

# A DMA without scatter-gather: `sends` bits wide from memory to stream and, unless `receives` is 0, so many bits back.
# 26 bits is the longest length register there is; 32 address bits reach all 2 GiB of the board.
proc add_dma {name sends receives} {
    set configuration [list \
        CONFIG.c_include_sg 0 \
        CONFIG.c_sg_include_stscntrl_strm 0 \
        CONFIG.c_sg_length_width 26 \
        CONFIG.c_addr_width 32 \
        CONFIG.c_include_mm2s 1 \
        CONFIG.c_include_mm2s_dre 0 \
        CONFIG.c_m_axi_mm2s_data_width $sends \
        CONFIG.c_m_axis_mm2s_tdata_width $sends \
        CONFIG.c_mm2s_burst_size 64 \
        CONFIG.c_include_s2mm [expr {$receives > 0}]]
    if {$receives} {
        lappend configuration \
            CONFIG.c_include_s2mm_dre 0 \
            CONFIG.c_m_axi_s2mm_data_width $receives \
            CONFIG.c_s_axis_s2mm_tdata_width $receives \
            CONFIG.c_s2mm_burst_size 64
    }
    return [add_cell $name axi_dma $configuration]
}

# Only what the programmable logic sees. With board files, DDR, pins and clocks of the PS come from them. Without,
# they keep Vivado's defaults, which is enough for an overlay: PYNQ loads it on a PS that its own boot image has set
# up, and never runs the initialisation of this design.
proc add_processor {has_board} {
    global macram
    set ps [add_cell ps zynq_ultra_ps_e]
    if {$has_board} {
        apply_bd_automation -rule xilinx.com:bd_rule:zynq_ultra_ps_e -config {apply_board_preset 1} $ps
    }
    set_property -dict [list \
        CONFIG.PSU__USE__M_AXI_GP0 1 \
        CONFIG.PSU__MAXIGP0__DATA_WIDTH 128 \
        CONFIG.PSU__USE__M_AXI_GP1 0 \
        CONFIG.PSU__USE__M_AXI_GP2 0 \
        CONFIG.PSU__USE__S_AXI_GP2 1 \
        CONFIG.PSU__SAXIGP2__DATA_WIDTH 128 \
        CONFIG.PSU__USE__IRQ0 0 \
        CONFIG.PSU__FPGA_PL0_ENABLE 1 \
        CONFIG.PSU__CRL_APB__PL0_REF_CTRL__FREQMHZ $macram(clock_mhz) \
        CONFIG.PSU__USE__FABRIC__RST 1 \
        CONFIG.PSU__NUM_FABRIC_RESETS 1] $ps
}

# Returns the pin that drives the array's clock. The PS comes to within some parts per million of the wanted rate;
# every other block takes its rate from there, so that no two differ. With a doubled clock both come from one MMCM
# through matched buffers: their rising edges coincide, and the logic stays in reset until the MMCM has locked.
proc add_clocks {} {
    global macram
    add_cell reset proc_sys_reset
    if {[llength $macram(clocks)] == 1} {
        set clock ps/pl_clk0
    } else {
        add_cell clocks clk_wiz [list \
            CONFIG.PRIMITIVE MMCM \
            CONFIG.PRIM_SOURCE Global_buffer \
            CONFIG.NUM_OUT_CLKS 2 \
            CONFIG.CLKOUT1_REQUESTED_OUT_FREQ $macram(clock_mhz) \
            CONFIG.CLKOUT1_REQUESTED_PHASE 0 \
            CONFIG.CLKOUT1_MATCHED_ROUTING true \
            CONFIG.CLKOUT2_USED true \
            CONFIG.CLKOUT2_REQUESTED_OUT_FREQ [expr {2 * $macram(clock_mhz)}] \
            CONFIG.CLKOUT2_REQUESTED_PHASE 0 \
            CONFIG.CLKOUT2_MATCHED_ROUTING true \
            CONFIG.USE_LOCKED true \
            CONFIG.USE_RESET true \
            CONFIG.RESET_TYPE ACTIVE_LOW \
            CONFIG.RESET_PORT resetn]
        set clock clocks/clk_out1
        fan_out ps/pl_clk0 {clocks/clk_in1}
        fan_out ps/pl_resetn0 {clocks/resetn}
        fan_out clocks/locked {reset/dcm_locked}
        fan_out clocks/clk_out2 {macram_0/aclk2x}
    }
    fan_out ps/pl_resetn0 {reset/ext_reset_in}
    fan_out $clock {reset/slowest_sync_clk ps/maxihpm0_fpd_aclk ps/saxihp0_fpd_aclk}
    return $clock
}

# Map every register window of settings.tcl, and the low 2 GiB of memory into every DMA.
proc assign_addresses {masters} {
    global macram
    foreach {segment offset range} $macram(windows) {
        assign_bd_address -offset $offset -range $range \
            -target_address_space [get_bd_addr_spaces ps/Data] [get_bd_addr_segs $segment]
    }
    foreach master $masters {
        set space [get_bd_addr_spaces $master]
        assign_bd_address -offset 0x00000000 -range 0x80000000 \
            -target_address_space $space [get_bd_addr_segs ps/SAXIGP2/HP0_DDR_LOW]
        # What else the port reaches is no business of a DMA.
        foreach segment {HP0_DDR_HIGH HP0_LPS_OCM HP0_QSPI} {
            set other [get_bd_addr_segs -quiet ps/SAXIGP2/$segment]
            if {[llength $other]} {
                exclude_bd_addr_seg -target_address_space $space $other
            }
        }
    }
}

proc build_design {has_board} {
    global macram
    create_bd_design macram
    add_processor $has_board
    create_bd_cell -type ip -vlnv "$macram(vendor):$macram(library):macram_top:$macram(version)" macram_0
    set clock [add_clocks]

    # One DMA per stream into the array; it takes the stream that answers as well.
    set controlled {macram_0/s_axi}
    set memory {}
    set spaces {}
    set clocked {macram_0/aclk control/aclk memory/aclk}
    set held {macram_0/aresetn control/aresetn memory/aresetn}
    foreach {dma question sends answer receives} $macram(dmas) {
        add_dma $dma $sends $receives
        join_interfaces $dma/M_AXIS_MM2S macram_0/$question
        lappend controlled $dma/S_AXI_LITE
        lappend memory $dma/M_AXI_MM2S
        lappend spaces $dma/Data_MM2S
        lappend clocked $dma/s_axi_lite_aclk $dma/m_axi_mm2s_aclk
        lappend held $dma/axi_resetn
        if {$receives} {
            join_interfaces macram_0/$answer $dma/S_AXIS_S2MM
            lappend memory $dma/M_AXI_S2MM
            lappend spaces $dma/Data_S2MM
            lappend clocked $dma/m_axi_s2mm_aclk
        }
    }

    add_cell control smartconnect \
        [list CONFIG.NUM_SI 1 CONFIG.NUM_MI [llength $controlled] CONFIG.NUM_CLKS 1]
    add_cell memory smartconnect [list CONFIG.NUM_SI [llength $memory] CONFIG.NUM_MI 1 CONFIG.NUM_CLKS 1]
    join_interfaces ps/M_AXI_HPM0_FPD control/S00_AXI
    join_interfaces memory/M00_AXI ps/S_AXI_HP0_FPD
    set index 0
    foreach target $controlled {
        join_interfaces control/[format "M%02d_AXI" $index] $target
        incr index
    }
    set index 0
    foreach source $memory {
        join_interfaces $source memory/[format "S%02d_AXI" $index]
        incr index
    }
    fan_out $clock $clocked
    fan_out reset/peripheral_aresetn $held

    assign_addresses $spaces
    validate_bd_design
    save_bd_design
}
