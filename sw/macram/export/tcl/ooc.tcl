# The array alone, out of context: vivado -mode batch -source ooc.tcl
# Synthesises, places and routes macram_top without the block design, against the clocks of constraints.xdc, and
# leaves reports/ooc_timing.rpt and reports/ooc_util.rpt. Nothing that build.tcl needs.

set here [file dirname [file normalize [info script]]]
source [file join $here settings.tcl]
source [file join $here part.tcl]

set part [choose_part]
set reports [file join $here reports]
file mkdir $reports
create_project -in_memory -part $part
insist_on_memory_images
foreach file $macram(sources) {
    read_verilog [file join $here $file]
}
read_mem [glob [file join $here mem *.mem]]
read_xdc -mode out_of_context [file join $here constraints.xdc]

synth_design -top macram_top -part $part -mode out_of_context
report_utilization -hierarchical -file [file join $reports ooc_synth_util.rpt]
opt_design
place_design
phys_opt_design
route_design

report_timing_summary -file [file join $reports ooc_timing.rpt]
report_utilization -hierarchical -file [file join $reports ooc_util.rpt]
set slack [get_property SLACK [get_timing_paths -delay_type max -max_paths 1]]
puts "macram: macram_top on $part at $macram(clock_mhz) MHz, worst setup slack $slack ns"
if {$slack < 0} {
    error "timing is not met; see reports/ooc_timing.rpt"
}
