# Everything from RTL to an overlay: vivado -mode batch -source build.tcl
# Leaves overlay/macram.bit, overlay/macram.hwh, macram.xsa and reports/; work/ and ip/ can be deleted.

set here [file dirname [file normalize [info script]]]
source [file join $here settings.tcl]
source [file join $here part.tcl]
source [file join $here package_ip.tcl]
source [file join $here design.tcl]

proc finish_run {name} {
    wait_on_run $name
    set run [get_runs $name]
    if {[get_property PROGRESS $run] ne "100%"} {
        error "$name stopped: [get_property STATUS $run]; see work/macram/macram.runs/$name/runme.log"
    }
}

set part [choose_part]
set board [choose_board]
set repository [package_ip $here $part]

set work [file join $here work macram]
file delete -force $work
create_project -force macram $work -part $part
if {$board ne ""} {
    set_property board_part $board [current_project]
} else {
    puts "macram: no board files of the Ultra96-V2 found; building for $part"
}
insist_on_memory_images
set_property ip_repo_paths [list $repository] [current_project]
update_ip_catalog

build_design [expr {$board ne ""}]
set design [get_files macram.bd]
# The core is synthesised in the run of the whole design, under the same severities, not in one of its own.
set_property synth_checkpoint_mode None $design
generate_target all $design
add_files -norecurse [make_wrapper -files $design -top]
set_property top macram_wrapper [current_fileset]
update_compile_order -fileset sources_1

launch_runs synth_1 -jobs 4
finish_run synth_1
launch_runs impl_1 -to_step write_bitstream -jobs 4
finish_run impl_1

open_run impl_1
set reports [file join $here reports]
file mkdir $reports
report_timing_summary -file [file join $reports macram_timing.rpt]
report_utilization -hierarchical -file [file join $reports macram_util.rpt]
report_power -file [file join $reports macram_power.rpt]
report_drc -file [file join $reports macram_drc.rpt]
foreach {kind option} {setup max hold min} {
    set slack [get_property SLACK [get_timing_paths -delay_type $option -max_paths 1]]
    puts "macram: worst $kind slack $slack ns"
    if {$slack < 0} {
        error "timing is not met ($kind slack $slack ns); see reports/macram_timing.rpt"
    }
}

# PYNQ wants the bitstream and the hardware description side by side under one name.
set overlay [file join $here overlay]
file copy -force [file join $work macram.runs impl_1 macram_wrapper.bit] [file join $overlay macram.bit]
set handoffs [concat \
    [glob -nocomplain [file join $work macram.gen sources_1 bd macram hw_handoff macram.hwh]] \
    [glob -nocomplain [file join $work macram.srcs sources_1 bd macram hw_handoff macram.hwh]]]
if {[llength $handoffs] == 0} {
    error "Vivado left no macram.hwh; look for it below work/macram and copy it to overlay/macram.hwh"
}
file copy -force [lindex $handoffs 0] [file join $overlay macram.hwh]
write_hw_platform -fixed -include_bit -force -file [file join $here macram.xsa]
puts "macram: overlay/macram.bit and overlay/macram.hwh are ready; copy overlay/ to the board"
