"""A model of the Vivado commands that the exported scripts use, on a real Tcl interpreter.

Unknown commands, options, properties, pins and objects are errors; every script error raises `VivadoError`. Pins,
parameters and their spelling are those of the cores' product guides (PG021, PG065, PG164, PG201, PG247) and UG835.
"""

from __future__ import annotations

import os
import re
from pathlib import Path

import pytest
import vivado_block
import vivado_package
from vivado_images import VivadoError, expect

# Options that take a value, options that do not, and how many plain words may follow.
COMMANDS = {
    "create_project": ("-part", "-force -in_memory", (0, 2)),
    "close_project": ("", "", (0, 0)),
    "current_project": ("", "", (0, 0)),
    "current_fileset": ("", "", (0, 0)),
    "add_files": ("-fileset", "-norecurse", (1, 1)),
    "update_compile_order": ("-fileset", "", (0, 0)),
    "update_ip_catalog": ("", "-rebuild", (0, 0)),
    "set_property": ("", "-dict", (2, 3)),
    "get_property": ("", "", (2, 2)),
    "get_parts": ("", "-quiet", (0, 1)),
    "get_board_parts": ("", "-quiet", (0, 1)),
    "get_ipdefs": ("", "-quiet -all", (1, 1)),
    "get_files": ("", "-quiet", (1, 1)),
    "get_runs": ("", "-quiet", (1, 1)),
    "generate_target": ("", "-force", (2, 2)),
    "make_wrapper": ("-files", "-top", (0, 0)),
    "launch_runs": ("-to_step -jobs", "", (1, 1)),
    "wait_on_run": ("", "", (1, 1)),
    "open_run": ("", "", (1, 1)),
    "get_timing_paths": ("-delay_type -max_paths", "", (0, 0)),
    "report_timing_summary": ("-file", "", (0, 0)),
    "report_utilization": ("-file", "-hierarchical", (0, 0)),
    "report_power": ("-file", "", (0, 0)),
    "report_drc": ("-file", "", (0, 0)),
    "write_hw_platform": ("-file", "-fixed -include_bit -force", (0, 0)),
    "read_verilog": ("", "", (1, 1)),
    "read_mem": ("", "", (1, 1)),
    "read_xdc": ("-mode", "", (1, 1)),
    "synth_design": ("-top -part -mode", "", (0, 0)),
    "opt_design": ("", "", (0, 0)),
    "place_design": ("", "", (0, 0)),
    "phys_opt_design": ("", "", (0, 0)),
    "route_design": ("", "", (0, 0)),
    "create_clock": ("-name -period", "", (1, 1)),
    "get_ports": ("", "", (1, 1)),
    **vivado_package.COMMANDS,
    **vivado_block.COMMANDS,
}
PROPERTIES = {
    "project": {"board_part", "ip_repo_paths"},
    "fileset": {"top"},
    "core": {"name", "version", "display_name", "description", "core_revision", "supported_families"},
    "bus": {"abstraction_type_vlnv", "bus_type_vlnv", "interface_mode", "slave_memory_map_ref"},
    "map": {"physical_name"},
    "parameter": {"value"},
    "block": {"name", "range", "width", "usage"},
    "file": {"type"},
    "macram.bd": {"synth_checkpoint_mode"},
}


def tcl_interpreter():
    """Tcl without windows, which Python's tkinter brings; where that was left out, the test says what is missing."""
    try:
        import tkinter  # noqa: PLC0415
    except ImportError:
        if os.environ.get("MACRAM_REQUIRE_TOOLS", "0") not in ("", "0"):
            raise
        pytest.skip("Tcl is missing: install python3-tk")
    return tkinter.Tcl()


def tcl_error():
    from tkinter import TclError  # noqa: PLC0415

    return TclError


def verilog_ports(path):
    """Ports of ``macram_top``, from the module header and the declarations: name -> direction, name -> bits."""
    text = path.read_text()
    text = text[re.search(r"^module macram_top\(", text, re.MULTILINE).start() :]
    text = text[: text.index("\nendmodule")]
    header = re.search(r"^module macram_top\((.*?)\);", text, re.DOTALL | re.MULTILINE)[1]
    names = {name.strip() for name in header.replace("\n", " ").split(",")}
    found = re.findall(r"^  (input|output) (?:\[(\d+):0\] )?(\w+);$", text, re.MULTILINE)
    declared = {name: direction for direction, _, name in found}
    assert names == set(declared)
    return declared, {name: int(msb or 0) + 1 for _, msb, name in found}


class Vivado(vivado_block.BlockDesign):
    """One Vivado session.

    Attributes:
        parts, boards: what is installed.
        slack: of every timing path, ns.
        failing: names of runs that stop half-way.
        calls: every command with its words.
        clocks: period by port, ns.
    """

    def __init__(self, folder: Path):
        super().__init__(*verilog_ports(folder / "rtl/macram_top.v"))
        self.folder = folder
        self.parts = {"xczu3eg-sbva484-1-i", "xczu3eg-sbva484-1-e"}
        self.boards = []
        self.slack = 0.25
        self.failing = set()
        self.calls = []
        self.clocks = {}

    def source(self, name):
        """Run a script of the folder, as ``vivado -mode batch -source`` does."""
        self.tcl = tcl = tcl_interpreter()
        # A Python exception would leave Tcl without a message; so a fault is handed over as a value.
        tcl.createcommand("model", self._model)
        tcl.eval("namespace eval ipx {}")
        for command in COMMANDS:
            tcl.eval(
                f"proc {command} args {{lassign [model {command} {{*}}$args] failed result\n"
                "if {$failed} {error $result}\nreturn $result}"
            )
        tcl.createcommand("puts", lambda *words: self.calls.append(("puts", *words)) or "")
        try:
            tcl.call("source", str(self.folder / name))
        except tcl_error() as error:
            raise VivadoError(str(error)) from None

    def _model(self, command, *arguments):
        self.calls.append((command, *arguments))
        try:
            return (0, self._run(command, list(arguments)) or "")
        except VivadoError as error:
            return (1, str(error))

    def _run(self, command, rest):
        valued, flags, (low, high) = COMMANDS[command]
        options, plain = {}, []
        while rest:
            word = rest.pop(0)
            if word in valued.split():
                expect(rest, f"{command}: {word} wants a value")
                options[word[1:]] = rest.pop(0)
            elif word in flags.split():
                options[word[1:]] = True
            else:
                expect(not re.match(r"-[a-z]", word), f"{command}: unknown option {word}")
                plain.append(word)
        expect(low <= len(plain) <= high, f"{command}: {len(plain)} words {plain}")
        return getattr(self, command.replace("::", "_"))(*plain, **options)

    def items(self, text):
        return list(self.tcl.splitlist(text))

    # ---- projects, runs, reports ---------------------------------------------------------------------

    def create_project(self, name="", folder="", part="", force=False, in_memory=False):
        expect(part in self.parts, f"no part {part!r}")
        self.files = []
        self.project = Path(folder) if folder else None

    def close_project(self):
        self.project = None

    def current_project(self):
        return "project"

    def current_fileset(self):
        return "fileset"

    def add_files(self, files, fileset="", norecurse=False):
        for file in self.items(files):
            expect(Path(file).is_file(), f"no file {file}")
            self.files.append(file)

    read_verilog = read_mem = add_files

    def update_compile_order(self, fileset=""):
        pass

    update_ip_catalog = opt_design = place_design = phys_opt_design = route_design = update_compile_order

    def get_parts(self, pattern="*", quiet=False):
        return " ".join(part for part in sorted(self.parts) if part == pattern)

    def get_board_parts(self, pattern="*", quiet=False):
        return " ".join(one for one in self.boards if re.fullmatch(pattern.replace("*", ".*"), one))

    def get_files(self, name, quiet=False):
        expect(name == "macram.bd" and self.saved, f"no file {name}")
        return name

    def generate_target(self, what, files, force=False):
        expect((what, files) == ("all", "macram.bd"), f"cannot generate {what} of {files}")

    def make_wrapper(self, files, top=False):
        path = self.project / "macram.gen/sources_1/bd/macram/hdl/macram_wrapper.v"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("module macram_wrapper; endmodule\n")
        return str(path)

    def get_runs(self, name, quiet=False):
        expect(name in ("synth_1", "impl_1"), f"no run {name}")
        return f"run:{name}"

    def launch_runs(self, name, to_step="", jobs="1"):
        self.get_runs(name)
        expect(self.properties.get(("fileset", "top")) == "macram_wrapper", "the wrapper is not the top")
        mode = self.properties.get(("macram.bd", "synth_checkpoint_mode"))
        expect(mode == "None", "the core is synthesised in a run with severities of its own")
        self.check_severity()
        if name == "impl_1" and to_step == "write_bitstream" and name not in self.failing:
            for path in ("runs/impl_1/macram_wrapper.bit", "gen/sources_1/bd/macram/hw_handoff/macram.hwh"):
                product = self.project / f"macram.{path}"
                product.parent.mkdir(parents=True, exist_ok=True)
                product.write_text(f"{path} of the model\n")

    def wait_on_run(self, name):
        self.get_runs(name)

    def open_run(self, name):
        self.get_runs(name)

    def get_timing_paths(self, delay_type="max", max_paths="1"):
        expect(delay_type in ("max", "min"), f"delay_type {delay_type}")
        return "path"

    def _report(self, file, hierarchical=False):
        Path(file).write_text("a report of the model\n")

    report_timing_summary = report_utilization = report_power = report_drc = _report

    def write_hw_platform(self, file, fixed=False, include_bit=False, force=False):
        Path(file).write_text("a platform of the model\n")

    def read_xdc(self, file, mode=""):
        self.tcl.call("source", file)

    def get_ports(self, name):
        expect(name in self.ports, f"macram_top has no port {name}")
        return name

    def create_clock(self, port, name, period):
        expect(self.ports[port] == "input", f"{port} is no input")
        self.clocks[port] = float(period)

    def synth_design(self, top, part, mode):
        expect(top == "macram_top" and mode == "out_of_context" and part in self.parts, "wrong synthesis")
        expect(any(file.endswith("macram_top.v") for file in self.files), "no top level was read")
        self.check_severity()
        self.check_project_images()

    def set_property(self, *words, dict=False):
        if dict:
            pairs, target = words
            for name, value in zip(*[iter(self.items(pairs))] * 2, strict=True):
                self.set_property(name, value, target)
            return
        name, value, target = words
        expect(target, f"nothing to set {name} of")
        kind = target.partition(":")[0]
        if kind == "cell":
            self.configure(target.partition(":")[2], name, value)
            return
        expect(name in PROPERTIES.get(kind, ()), f"{target} has no property {name}")
        self.properties[target, name] = value

    def get_property(self, name, target):
        if target.startswith("run:"):
            stopped = target.partition(":")[2] in self.failing
            return {"PROGRESS": "40%" if stopped else "100%", "STATUS": "route_design ERROR"}[name]
        if target.startswith("group:"):
            return {"name": target.partition(":")[2]}[name]
        return {("SLACK", "path"): str(self.slack)}[name, target]
