# Packages the array as an IP core in ip/: interfaces, clocks, resets, memory map.
# Vivado infers most of this from the port names. What it does not find is added, and what it finds is mapped
# again port by port, so that the result depends on settings.tcl alone. Sourced by build.tcl.

# The bus interface `name` of `core` with exactly these ports; `pairs` is a list of LOGICAL physical.
proc ensure_interface {core name kind mode pairs} {
    set type [dict get {
        axilite xilinx.com:interface:aximm
        axis xilinx.com:interface:axis
        clock xilinx.com:signal:clock
        reset xilinx.com:signal:reset
    } $kind]
    set bus [ipx::get_bus_interfaces -quiet $name -of_objects $core]
    if {[llength $bus] == 0} {
        set bus [ipx::add_bus_interface $name $core]
    }
    set_property abstraction_type_vlnv "${type}_rtl:1.0" $bus
    set_property bus_type_vlnv "${type}:1.0" $bus
    set_property interface_mode $mode $bus
    foreach {logical physical} $pairs {
        set map [ipx::get_port_maps -quiet $logical -of_objects $bus]
        if {[llength $map] == 0} {
            set map [ipx::add_port_map $logical $bus]
        }
        set_property physical_name $physical $map
    }
    return $bus
}

proc set_bus_parameter {bus name value} {
    set parameter [ipx::get_bus_parameters -quiet $name -of_objects $bus]
    if {[llength $parameter] == 0} {
        set parameter [ipx::add_bus_parameter $name $bus]
    }
    set_property value $value $parameter
}

# The registers as one block of 4 KiB, the smallest that the address editor handles.
proc ensure_memory_map {core name} {
    set map [ipx::get_memory_maps -quiet $name -of_objects $core]
    if {[llength $map] == 0} {
        set map [ipx::add_memory_map $name $core]
    }
    set block [ipx::get_address_blocks -quiet -of_objects $map]
    if {[llength $block] == 0} {
        set block [ipx::add_address_block reg0 $map]
    }
    set_property name reg0 $block
    set_property range 4096 $block
    set_property width 32 $block
    set_property usage register $block
    set_property slave_memory_map_ref $name [ipx::get_bus_interfaces $name -of_objects $core]
}

# Every memory image in every group of sources, beside the Verilog that names it. What the packager did with files
# that are no Verilog differs from version to version: they may be missing, or of a type that synthesis passes over.
proc ensure_memory_images {core root images} {
    set groups {}
    foreach group [ipx::get_file_groups -of_objects $core] {
        set name [get_property name $group]
        if {[string match *synthesis $name] || [string match *simulation $name]} {
            lappend groups $group
        }
    }
    if {[llength $groups] == 0} {
        error "the packaged core has no sources"
    }
    foreach image $images {
        set inside src/[file tail $image]
        file mkdir [file join $root src]
        file copy -force $image [file join $root $inside]
        foreach group $groups {
            set file [ipx::get_files -quiet $inside -of_objects $group]
            if {[llength $file] == 0} {
                set file [ipx::add_file $inside $group]
            }
            set_property type mem $file
        }
    }
}

proc package_ip {here part} {
    global macram
    set root [file join $here ip]
    file delete -force $root [file join $here work package]
    create_project -force package [file join $here work package] -part $part
    foreach file $macram(sources) {
        add_files -norecurse [file join $here $file]
    }
    set images [glob [file join $here mem *.mem]]
    add_files -norecurse $images
    set_property top macram_top [current_fileset]
    update_compile_order -fileset sources_1

    ipx::package_project -root_dir $root -vendor $macram(vendor) -library $macram(library) \
        -taxonomy /UserIP -import_files
    set core [ipx::current_core]
    set_property name macram_top $core
    set_property version $macram(version) $core
    set_property display_name "macram array $macram(name)" $core
    set_property description "Quantised 3x3 convolution on weights kept in block RAM" $core
    set_property core_revision 1 $core
    set_property supported_families {zynquplus Production} $core

    ensure_memory_images $core $root $images
    foreach interface $macram(interfaces) {
        lassign $interface name kind mode pairs
        ensure_interface $core $name $kind $mode $pairs
        if {$kind eq "axilite"} {
            ensure_memory_map $core $name
        }
    }
    # No FREQ_HZ: the rate is that of the block design, and a second opinion would only differ from it.
    foreach clock $macram(clocks) {
        ensure_interface $core $clock clock slave [list CLK $clock]
    }
    set reset [ensure_interface $core aresetn reset slave {RST aresetn}]
    set_bus_parameter $reset POLARITY ACTIVE_LOW
    # Everything at the edge belongs to aclk. The doubled clock, where there is one, drives only DSP slices.
    foreach interface $macram(interfaces) {
        ipx::associate_bus_interfaces -busif [lindex $interface 0] -clock aclk $core
    }
    ipx::associate_bus_interfaces -clock aclk -reset aresetn $core

    ipx::create_xgui_files $core
    ipx::update_checksums $core
    ipx::check_integrity $core
    ipx::save_core $core
    close_project
    return $root
}
