# Which device and which board files this Vivado has, and how strict it is. Sourced by build.tcl and ooc.tcl.

# A memory image that is not found is only a critical warning, and the memory then starts up with zeros. Here it ends
# the build.
proc insist_on_memory_images {} {
    set_msg_config -id {Synth 8-4445} -new_severity ERROR
}

# The Ultra96-V2 carries the industrial grade, early ones the extended grade, both of speed grade -1.
proc choose_part {} {
    global macram
    foreach part $macram(parts) {
        if {[llength [get_parts -quiet $part]]} {
            return $part
        }
    }
    error "this Vivado knows neither [join $macram(parts) { nor }]; install device support for Zynq UltraScale+"
}

# The newest board files of the Ultra96-V2, or nothing.
proc choose_board {} {
    global macram
    set found {}
    foreach pattern $macram(boards) {
        set found [concat $found [get_board_parts -quiet $pattern]]
    }
    return [lindex [lsort -dictionary $found] end]
}
