"""The packaging half of the model: bus interfaces, port maps and the check of a finished core."""

from __future__ import annotations

from pathlib import Path

import vivado_images
from vivado_images import MemoryImages, expect

COMMANDS = {
    **vivado_images.COMMANDS,
    "ipx::package_project": ("-root_dir -vendor -library -taxonomy", "-import_files", (0, 0)),
    "ipx::current_core": ("", "", (0, 0)),
    "ipx::get_bus_interfaces": ("-of_objects", "-quiet", (0, 1)),
    "ipx::add_bus_interface": ("", "", (2, 2)),
    "ipx::get_port_maps": ("-of_objects", "-quiet", (1, 1)),
    "ipx::add_port_map": ("", "", (2, 2)),
    "ipx::get_bus_parameters": ("-of_objects", "-quiet", (1, 1)),
    "ipx::add_bus_parameter": ("", "", (2, 2)),
    "ipx::get_memory_maps": ("-of_objects", "-quiet", (1, 1)),
    "ipx::add_memory_map": ("", "", (2, 2)),
    "ipx::get_address_blocks": ("-of_objects", "-quiet", (0, 1)),
    "ipx::add_address_block": ("", "", (2, 2)),
    "ipx::associate_bus_interfaces": ("-busif -clock -reset", "", (1, 1)),
    "ipx::create_xgui_files": ("", "", (1, 1)),
    "ipx::update_checksums": ("", "", (1, 1)),
    "ipx::check_integrity": ("", "-quiet", (1, 1)),
    "ipx::save_core": ("", "", (1, 1)),
}
LITE = {
    **dict.fromkeys(
        [
            "AWADDR",
            "AWPROT",
            "AWVALID",
            "WDATA",
            "WSTRB",
            "WVALID",
            "BREADY",
            "ARADDR",
            "ARPROT",
            "ARVALID",
            "RREADY",
        ],
        "output",
    ),
    **dict.fromkeys(["AWREADY", "WREADY", "BRESP", "BVALID", "ARREADY", "RDATA", "RRESP", "RVALID"], "input"),
}
SIGNALS = {
    "xilinx.com:interface:aximm:1.0": LITE,
    "xilinx.com:interface:axis:1.0": {
        "TDATA": "output", "TVALID": "output", "TLAST": "output", "TREADY": "input",
    },
    "xilinx.com:signal:clock:1.0": {"CLK": "output"},
    "xilinx.com:signal:reset:1.0": {"RST": "output"},
}  # fmt: skip
"""Bus type -> logical names with their direction at a master."""


class Packager(MemoryImages):
    """One core being packaged.

    Attributes:
        ports: of ``macram_top``, name -> ``input`` or ``output``.
        infers: whether packaging finds the AXI interfaces by their port names.
        bus: interface -> its port maps, parameters and clock.
        memory: memory map -> address blocks.
        properties: (object, name) -> value, of every object that is no cell.
        catalogue: full names of the cores that were saved.
    """

    def __init__(self, ports):
        super().__init__()
        self.ports = ports
        self.infers = True
        self.bus, self.memory, self.core = {}, {}, {}
        self.properties, self.catalogue = {}, set()

    def ipx_package_project(self, root_dir, vendor, library, taxonomy, import_files=False):
        self.core = {"vendor": vendor, "library": library, "root": root_dir}
        expect(import_files, "the core would point at files outside of its folder")
        self.import_sources(Path(root_dir))
        if not self.infers:
            return
        for name in {port.removesuffix("_tdata") for port in self.ports if port.endswith("_tdata")}:
            self.ipx_add_bus_interface(name, "core")
        self.ipx_add_bus_interface("s_axi", "core")
        self.ipx_add_memory_map("s_axi", "core")
        self.ipx_add_address_block("reg0", "memory:s_axi")

    def ipx_current_core(self):
        expect(self.core, "no core is open")
        return "core"

    def ipx_get_bus_interfaces(self, name, of_objects, quiet=False):
        expect(quiet or name in self.bus, f"no bus interface {name}")
        return f"bus:{name}" if name in self.bus else ""

    def ipx_add_bus_interface(self, name, core):
        expect(name not in self.bus, f"bus interface {name} exists")
        self.bus[name] = {"maps": set(), "parameters": set()}
        return f"bus:{name}"

    def ipx_get_port_maps(self, logical, of_objects, quiet=False):
        bus = of_objects.partition(":")[2]
        return f"map:{bus}:{logical}" if logical in self.bus[bus]["maps"] else ""

    def ipx_add_port_map(self, logical, bus):
        self.bus[bus.partition(":")[2]]["maps"].add(logical)
        return f"map:{bus.partition(':')[2]}:{logical}"

    def ipx_get_bus_parameters(self, name, of_objects, quiet=False):
        bus = of_objects.partition(":")[2]
        return f"parameter:{bus}:{name}" if name in self.bus[bus]["parameters"] else ""

    def ipx_add_bus_parameter(self, name, bus):
        expect(name == "POLARITY", f"no parameter {name} is expected")
        self.bus[bus.partition(":")[2]]["parameters"].add(name)
        return f"parameter:{bus.partition(':')[2]}:{name}"

    def ipx_get_memory_maps(self, name, of_objects, quiet=False):
        return f"memory:{name}" if name in self.memory else ""

    def ipx_add_memory_map(self, name, core):
        expect(name not in self.memory, f"memory map {name} exists")
        self.memory[name] = []
        return f"memory:{name}"

    def ipx_get_address_blocks(self, of_objects, quiet=False):
        return " ".join(f"block:{one}" for one in self.memory[of_objects.partition(":")[2]])

    def ipx_add_address_block(self, name, memory):
        self.memory[memory.partition(":")[2]].append(name)
        return f"block:{name}"

    def ipx_associate_bus_interfaces(self, core, clock, busif="", reset=""):
        expect(clock in self.bus, f"no clock {clock}")
        for name in filter(None, (busif, reset)):
            expect(name in self.bus, f"no bus interface {name}")
            self.bus[name]["clock"] = clock

    def ipx_create_xgui_files(self, core):
        pass

    ipx_update_checksums = ipx_check_integrity = ipx_create_xgui_files

    def ipx_save_core(self, core):
        """Check that the core is whole: every port in one interface, with the right direction."""
        mapped = {}
        for name, bus in self.bus.items():
            kind = self.properties[f"bus:{name}", "bus_type_vlnv"]
            expect(
                self.properties[f"bus:{name}", "abstraction_type_vlnv"] == kind.replace(":1.0", "_rtl:1.0"),
                f"{name}: the abstraction does not belong to {kind}",
            )
            mode = self.properties[f"bus:{name}", "interface_mode"]
            wanted = SIGNALS[kind]
            expect(bus["maps"] == set(wanted), f"{name} maps {sorted(bus['maps'])}, not {sorted(wanted)}")
            for logical, master in wanted.items():
                port = self.properties[f"map:{name}:{logical}", "physical_name"]
                expect(port in self.ports, f"macram_top has no port {port}")
                expect(port not in mapped, f"port {port} is mapped twice")
                driven = master if mode == "master" else {"output": "input", "input": "output"}[master]
                expect(self.ports[port] == driven, f"{port} is an {self.ports[port]} in a {mode}")
                mapped[port] = name
            if ":clock" not in kind:
                expect(bus.get("clock") == "aclk", f"{name} is not associated with aclk")
        expect(set(mapped) == set(self.ports), f"unmapped: {sorted(set(self.ports) - set(mapped))}")
        expect(
            self.properties["parameter:aresetn:POLARITY", "value"] == "ACTIVE_LOW", "aresetn is low active"
        )
        expect(self.properties["bus:s_axi", "slave_memory_map_ref"] == "s_axi", "no memory map")
        expect(self.properties["block:reg0", "range"] == "4096", "the registers' block")
        self.check_core_images()
        self.catalogue = {":".join((
            self.core["vendor"], self.core["library"],
            self.properties["core", "name"], self.properties["core", "version"],
        ))}  # fmt: skip
