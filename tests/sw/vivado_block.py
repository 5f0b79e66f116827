"""The block-design half of the model: cells with the pins their configuration gives them, nets, addresses."""

from __future__ import annotations

import re

from vivado_images import expect
from vivado_package import Packager

COMMANDS = {
    "create_bd_design": ("", "", (1, 1)),
    "create_bd_cell": ("-type -vlnv", "", (1, 1)),
    "apply_bd_automation": ("-rule -config", "", (1, 1)),
    "get_bd_pins": ("", "", (1, 1)),
    "get_bd_intf_pins": ("", "", (1, 1)),
    "connect_bd_net": ("", "", (2, 2)),
    "connect_bd_intf_net": ("", "", (2, 2)),
    "get_bd_addr_spaces": ("", "", (1, 1)),
    "get_bd_addr_segs": ("", "-quiet", (1, 1)),
    "assign_bd_address": ("-offset -range -target_address_space", "", (1, 1)),
    "exclude_bd_addr_seg": ("-target_address_space", "", (1, 1)),
    "validate_bd_design": ("", "", (0, 0)),
    "save_bd_design": ("", "", (0, 0)),
}
# What a fresh core is set to, where that matters: the model leans to the side that makes a careless script fail.
DEFAULTS = {
    "zynq_ultra_ps_e": {
        "PSU__USE__M_AXI_GP0": "0", "PSU__USE__M_AXI_GP1": "1", "PSU__USE__M_AXI_GP2": "1",
        "PSU__USE__S_AXI_GP2": "0", "PSU__USE__IRQ0": "1", "PSU__FPGA_PL0_ENABLE": "0",
        "PSU__USE__FABRIC__RST": "0", "PSU__NUM_FABRIC_RESETS": "1", "PSU__MAXIGP0__DATA_WIDTH": "32",
        "PSU__SAXIGP2__DATA_WIDTH": "32", "PSU__CRL_APB__PL0_REF_CTRL__FREQMHZ": "300",
    },
    "axi_dma": {
        "c_include_sg": "1", "c_sg_include_stscntrl_strm": "1", "c_sg_length_width": "14",
        "c_addr_width": "32", "c_include_mm2s": "1", "c_include_mm2s_dre": "0",
        "c_m_axi_mm2s_data_width": "32", "c_m_axis_mm2s_tdata_width": "32", "c_mm2s_burst_size": "16",
        "c_include_s2mm": "1", "c_include_s2mm_dre": "0", "c_m_axi_s2mm_data_width": "32",
        "c_s_axis_s2mm_tdata_width": "32", "c_s2mm_burst_size": "16",
    },
    "smartconnect": {"NUM_SI": "2", "NUM_MI": "1", "NUM_CLKS": "1"},
    "proc_sys_reset": {},
    "clk_wiz": {
        "PRIMITIVE": "PLL", "PRIM_SOURCE": "Single_ended_clock_capable_pin", "NUM_OUT_CLKS": "1",
        "CLKOUT1_REQUESTED_OUT_FREQ": "100", "CLKOUT1_REQUESTED_PHASE": "0",
        "CLKOUT1_MATCHED_ROUTING": "false", "CLKOUT2_USED": "false", "CLKOUT2_REQUESTED_OUT_FREQ": "100",
        "CLKOUT2_REQUESTED_PHASE": "0", "CLKOUT2_MATCHED_ROUTING": "false", "USE_LOCKED": "false",
        "USE_RESET": "false", "RESET_TYPE": "ACTIVE_HIGH", "RESET_PORT": "reset",
    },
}  # fmt: skip
CATALOGUE = {
    "xilinx.com:ip:zynq_ultra_ps_e:3.3", "xilinx.com:ip:zynq_ultra_ps_e:3.5", "xilinx.com:ip:axi_dma:7.1",
    "xilinx.com:ip:smartconnect:1.0", "xilinx.com:ip:proc_sys_reset:5.0", "xilinx.com:ip:clk_wiz:6.0",
}  # fmt: skip
HIGH_PORTS = ("HP0_DDR_LOW", "HP0_DDR_HIGH", "HP0_LPS_OCM", "HP0_QSPI")
HPM0_FPD = range(0xA000_0000, 0xB000_0000)


class BlockDesign(Packager):
    """Cells, nets and addresses; pins are ``cell/pin`` without a leading slash.

    Attributes:
        widths: port of ``macram_top`` -> its bits.
        cells: name -> kind of core.
        configuration: name -> parameter -> value.
        nets: input pin -> the pin that drives it.
        links: master interface -> slave interface.
        windows: address space -> list of (segment, offset, range).
    """

    def __init__(self, ports, widths):
        super().__init__(ports)
        self.widths = widths
        self.cells, self.configuration = {}, {}
        self.nets, self.links, self.windows, self.excluded = {}, {}, {}, set()
        self.automated = self.validated = self.saved = False

    # ---- what a cell has -----------------------------------------------------------------------------

    def pins(self, cell):
        """Name -> ``in``, ``out`` or ``optional`` (an input with a safe default)."""
        kind, c = self.cells[cell], self.configuration[cell]
        if kind == "zynq_ultra_ps_e":
            wanted = {
                "maxihpm0_fpd_aclk": c["PSU__USE__M_AXI_GP0"], "maxihpm1_fpd_aclk": c["PSU__USE__M_AXI_GP1"],
                "maxihpm0_lpd_aclk": c["PSU__USE__M_AXI_GP2"], "saxihp0_fpd_aclk": c["PSU__USE__S_AXI_GP2"],
            }  # fmt: skip
            found = {name: "in" for name, used in wanted.items() if used == "1"}
            if c["PSU__FPGA_PL0_ENABLE"] == "1":
                found["pl_clk0"] = "out"
            if c["PSU__USE__FABRIC__RST"] == "1":
                found["pl_resetn0"] = "out"
            return found
        if kind == "axi_dma":
            found = {"s_axi_lite_aclk": "in", "axi_resetn": "in"}
            for side in ("mm2s", "s2mm"):
                if c[f"c_include_{side}"] == "1":
                    found |= {f"m_axi_{side}_aclk": "in", f"{side}_introut": "out"}
            return found | ({"m_axi_sg_aclk": "in"} if c["c_include_sg"] == "1" else {})
        if kind == "smartconnect":
            return {"aclk": "in", "aresetn": "in"}
        if kind == "proc_sys_reset":
            return {
                "slowest_sync_clk": "in", "ext_reset_in": "in", "dcm_locked": "optional",
                "aux_reset_in": "optional", "peripheral_aresetn": "out", "interconnect_aresetn": "out",
            }  # fmt: skip
        if kind == "clk_wiz":
            found = {"clk_in1": "in", "clk_out1": "out"}
            if c["CLKOUT2_USED"] == "true":
                found["clk_out2"] = "out"
            if c["USE_LOCKED"] == "true":
                found["locked"] = "out"
            return found | ({c["RESET_PORT"]: "in"} if c["USE_RESET"] == "true" else {})
        return {
            name: "in" for name in self.bus if ":signal:" in self.properties[f"bus:{name}", "bus_type_vlnv"]
        }

    def interfaces(self, cell):
        """Name -> mode, protocol, bits of a stream (or None), and the clock pin."""
        kind, c = self.cells[cell], self.configuration[cell]
        if kind == "zynq_ultra_ps_e":
            return {
                name: (mode, "mm", None, clock)
                for name, mode, clock, used in (
                    ("M_AXI_HPM0_FPD", "master", "maxihpm0_fpd_aclk", c["PSU__USE__M_AXI_GP0"]),
                    ("S_AXI_HP0_FPD", "slave", "saxihp0_fpd_aclk", c["PSU__USE__S_AXI_GP2"]),
                )
                if used == "1"
            }
        if kind == "axi_dma":
            found = {"S_AXI_LITE": ("slave", "mm", None, "s_axi_lite_aclk")}
            if c["c_include_mm2s"] == "1":
                bits = int(c["c_m_axis_mm2s_tdata_width"])
                found["M_AXI_MM2S"] = ("master", "mm", None, "m_axi_mm2s_aclk")
                found["M_AXIS_MM2S"] = ("master", "axis", bits, "m_axi_mm2s_aclk")
            if c["c_include_s2mm"] == "1":
                bits = int(c["c_s_axis_s2mm_tdata_width"])
                found["M_AXI_S2MM"] = ("master", "mm", None, "m_axi_s2mm_aclk")
                found["S_AXIS_S2MM"] = ("slave", "axis", bits, "m_axi_s2mm_aclk")
            return found
        if kind == "smartconnect":
            found = {f"S{i:02d}_AXI": ("slave", "mm", None, "aclk") for i in range(int(c["NUM_SI"]))}
            return found | {f"M{i:02d}_AXI": ("master", "mm", None, "aclk") for i in range(int(c["NUM_MI"]))}
        if kind != "macram_top":
            return {}
        return {
            name: (
                self.properties[f"bus:{name}", "interface_mode"],
                "mm" if name == "s_axi" else "axis",
                None if name == "s_axi" else self.widths[f"{name}_tdata"],
                self.bus[name]["clock"],
            )
            for name in self.bus
            if ":interface:" in self.properties[f"bus:{name}", "bus_type_vlnv"]
        }

    # ---- commands ------------------------------------------------------------------------------------

    def create_bd_design(self, name):
        expect(name == "macram", "another design")

    def get_ipdefs(self, pattern, quiet=False, all=False):
        known = re.compile(pattern.replace("*", ".*"))
        return " ".join(one for one in sorted(CATALOGUE | self.catalogue) if known.fullmatch(one))

    def create_bd_cell(self, name, type, vlnv):
        expect(type == "ip" and vlnv in CATALOGUE | self.catalogue, f"no core {vlnv}")
        expect(name not in self.cells, f"cell {name} exists")
        self.cells[name] = vlnv.split(":")[2]
        self.configuration[name] = dict(DEFAULTS.get(self.cells[name], {}))
        return f"cell:{name}"

    def apply_bd_automation(self, cell, rule, config):
        expect(self.boards and rule == "xilinx.com:bd_rule:zynq_ultra_ps_e", "no board preset")
        self.automated = True

    def configure(self, cell, name, value):
        """``set_property CONFIG.name value`` on a cell."""
        name = name.removeprefix("CONFIG.")
        expect(name in self.configuration[cell], f"{cell} has no parameter {name}")
        self.configuration[cell][name] = value

    def get_bd_pins(self, path):
        cell, _, pin = path.partition("/")
        expect(cell in self.cells, f"no cell {cell}")
        expect(pin in self.pins(cell), f"{cell} has no pin {pin}")
        return path

    def get_bd_intf_pins(self, path):
        cell, _, pin = path.partition("/")
        expect(cell in self.cells, f"no cell {cell}")
        expect(pin in self.interfaces(cell), f"{cell} has no interface {pin}")
        return path

    def connect_bd_net(self, driver, pin):
        expect(self._pin(driver) == "out", f"{driver} drives nothing")
        expect(self._pin(pin) != "out", f"{pin} is an output")
        expect(pin not in self.nets, f"{pin} has a driver")
        self.nets[pin] = driver

    def connect_bd_intf_net(self, one, two):
        (mode, *_), (other, *_) = self._interface(one), self._interface(two)
        expect((mode, other) == ("master", "slave"), f"{one} is a {mode}, {two} a {other}")
        expect(one not in self.links and two not in self.links.values(), f"{one} or {two} is taken")
        self.links[one] = two

    def get_bd_addr_spaces(self, name):
        masters = {f"{cell}/Data_{side}" for cell in self.cells for side in ("MM2S", "S2MM")
                   if f"M_AXI_{side}" in self.interfaces(cell)}  # fmt: skip
        expect(name in masters | {"ps/Data"}, f"no address space {name}")
        return name

    def get_bd_addr_segs(self, name, quiet=False):
        known = {f"ps/SAXIGP2/{one}" for one in HIGH_PORTS}
        known |= {f"{cell}/S_AXI_LITE/Reg" for cell, kind in self.cells.items() if kind == "axi_dma"}
        known |= {f"macram_0/{memory}/{block}" for memory, blocks in self.memory.items() for block in blocks}
        expect(quiet or name in known, f"no address segment {name}")
        return name if name in known else ""

    def assign_bd_address(self, segment, offset, target_address_space, **others):
        begin, size = int(offset, 0), int(others["range"], 0)
        expect(begin % size == 0, f"{segment}: {offset} is not a multiple of its range")
        expect(size & (size - 1) == 0, f"{segment}: range {size} is no power of two")
        taken = self.windows.setdefault(target_address_space, [])
        for name, start, length in taken:
            expect(begin >= start + length or start >= begin + size, f"{segment} overlaps {name}")
        taken.append((segment, begin, size))

    def exclude_bd_addr_seg(self, segment, target_address_space):
        self.excluded.add((target_address_space, segment))

    def save_bd_design(self):
        expect(self.validated, "saved before it was valid")
        self.saved = True

    def validate_bd_design(self):
        """Everything connected, one clock across every connection, resets of that clock, every address mapped."""
        for cell in self.cells:
            for pin, direction in self.pins(cell).items():
                expect(direction != "in" or f"{cell}/{pin}" in self.nets, f"{cell}/{pin} is open")
            for name, (mode, *_) in self.interfaces(cell).items():
                ends = self.links if mode == "master" else self.links.values()
                expect(f"{cell}/{name}" in ends, f"interface {cell}/{name} is open")
        for one, two in self.links.items():
            (_, kind, bits, _), (_, other, width, _) = self._interface(one), self._interface(two)
            expect(kind == other and bits == width, f"{one} and {two} differ: {kind} {bits}, {other} {width}")
            expect(self._clock(one) == self._clock(two), f"{one} and {two} have different clocks")
        for one, two in self.links.items():
            if one.startswith("macram_0/m_axis"):
                question = one.replace("m_axis", "s_axis")
                (feeder,) = (master for master, slave in self.links.items() if slave == question)
                expect(
                    feeder.partition("/")[0] == two.partition("/")[0],
                    f"{question} and {one} have different DMAs",
                )
        expect(self.configuration["ps"]["PSU__USE__IRQ0"] == "0", "an interrupt input is open")
        self._validate_clocks()
        self._validate_addresses()
        self.validated = True

    def _validate_clocks(self):
        main = self.nets["macram_0/aclk"]
        expect(self.nets["reset/slowest_sync_clk"] == main, "the reset belongs to another clock")
        for pin, driver in self.nets.items():
            if pin.endswith(("aresetn", "axi_resetn")):
                expect(driver == "reset/peripheral_aresetn", f"{pin} is reset by {driver}")
        rate = self.configuration["ps"]["PSU__CRL_APB__PL0_REF_CTRL__FREQMHZ"]
        expect(rate == "100", f"pl_clk0 runs at {rate}")
        if "aclk2x" not in self.bus:
            expect(main == "ps/pl_clk0", f"aclk comes from {main}")
            return
        wizard, other = main.split("/")[0], self.nets["macram_0/aclk2x"].split("/")[0]
        c = self.configuration[wizard]
        expect(wizard == other and self.cells[wizard] == "clk_wiz", "two sources of clocks")
        expect(c["PRIMITIVE"] == "MMCM" and c["PRIM_SOURCE"] == "Global_buffer", "not one MMCM")
        expect(main == f"{wizard}/clk_out1", "aclk is not the first clock")
        fast, slow = (float(c[f"CLKOUT{i}_REQUESTED_OUT_FREQ"]) for i in (2, 1))
        expect((slow, fast) == (100, 200), f"clocks of {slow} and {fast} MHz")
        for i in (1, 2):
            expect(c[f"CLKOUT{i}_MATCHED_ROUTING"] == "true", "the clocks are not matched")
        expect(c["RESET_TYPE"] == "ACTIVE_LOW", "the wizard's reset has the wrong polarity")
        expect(self.nets.get("reset/dcm_locked") == f"{wizard}/locked", "nothing waits for the MMCM")

    def _validate_addresses(self):
        mapped = {segment for segment, *_ in self.windows["ps/Data"]}
        for cell, kind in self.cells.items():
            if kind == "axi_dma":
                expect(f"{cell}/S_AXI_LITE/Reg" in mapped, f"{cell} has no address")
                for side in ("MM2S", "S2MM"):
                    if f"M_AXI_{side}" in self.interfaces(cell):
                        self._validate_memory(f"{cell}/Data_{side}")
        expect("macram_0/s_axi/reg0" in mapped, "the array has no address")
        for segment, begin, size in self.windows["ps/Data"]:
            expect(begin in HPM0_FPD and begin + size - 1 in HPM0_FPD, f"{segment} is out of reach")

    def _validate_memory(self, space):
        expect(
            self.windows.get(space) == [("ps/SAXIGP2/HP0_DDR_LOW", 0, 1 << 31)],
            f"{space} does not see the memory",
        )
        for one in HIGH_PORTS[1:]:
            expect((space, f"ps/SAXIGP2/{one}") in self.excluded, f"{one} is neither mapped nor excluded")

    def _pin(self, path):
        cell, _, pin = path.partition("/")
        return self.pins(cell)[pin]

    def _interface(self, path):
        cell, _, name = path.partition("/")
        return self.interfaces(cell)[name]

    def _clock(self, path):
        return self.nets[f"{path.partition('/')[0]}/{self._interface(path)[3]}"]
