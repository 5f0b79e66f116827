"""The part of the model that asks whether every memory finds its image.

What is modelled: synthesis opens a ``$readmemh`` file by its bare name among the memory files of the sources; a file
that is not found is a critical warning and the memory starts up with zeros, unless that message (Synth 8-4445) was made
an error; a data file holds words and nothing else (UG901); packaging copies Verilog, and what it does with other files
is not to be relied on.
"""

from __future__ import annotations

import re
from pathlib import Path

COMMANDS = {
    "set_msg_config": ("-id -new_severity", "", (0, 0)),
    "ipx::get_file_groups": ("-of_objects", "-quiet", (0, 1)),
    "ipx::get_files": ("-of_objects", "-quiet", (1, 1)),
    "ipx::add_file": ("", "", (2, 2)),
}
GROUPS = ("xilinx_anylanguagesynthesis", "xilinx_anylanguagebehavioralsimulation", "xilinx_xpgui")


class VivadoError(Exception):
    """What the model refuses."""


def expect(condition, message):
    if not condition:
        raise VivadoError(message)


class MemoryImages:
    """Files of the project and of the core.

    Attributes:
        packs: what packaging does with a memory image: ``drops`` it, takes it as type ``unknown``, or as ``mem``.
        groups: file group of the core -> its files.
        files: sources of the project.
        severities: message -> severity it was given.
    """

    def __init__(self):
        self.packs = "drops"
        self.groups = {name: [] for name in GROUPS}
        self.files, self.severities = [], {}

    def import_sources(self, root):
        """What ``ipx::package_project -import_files`` copies to ``root/src`` and lists."""
        (root / "src").mkdir(parents=True, exist_ok=True)
        for file in map(Path, self.files):
            image = file.suffix == ".mem"
            if image and self.packs == "drops":
                continue
            (root / "src" / file.name).write_bytes(file.read_bytes())
            for group in GROUPS[:2]:
                self.groups[group].append(f"src/{file.name}")
                kind = {"unknown": "unknown", "mem": "mem"}[self.packs] if image else "verilogSource"
                self.properties[f"file:{group}:src/{file.name}", "type"] = kind

    def set_msg_config(self, id, new_severity):
        self.severities[id] = new_severity

    def ipx_get_file_groups(self, name="", of_objects="", quiet=False):
        return " ".join(f"group:{one}" for one in self.groups if name in ("", one))

    def ipx_get_files(self, name, of_objects, quiet=False):
        group = of_objects.partition(":")[2]
        found = name in self.groups[group]
        expect(found or quiet, f"{group} has no file {name}")
        return f"file:{group}:{name}" if found else ""

    def ipx_add_file(self, name, group):
        group = group.partition(":")[2]
        expect(name not in self.groups[group], f"{group} has {name} already")
        expect((Path(self.core["root"]) / name).is_file(), f"no file {name} in the core's folder")
        self.groups[group].append(name)
        self.properties[f"file:{group}:{name}", "type"] = "unknown"
        return f"file:{group}:{name}"

    def check_core_images(self):
        """Every image that the core's Verilog names is a memory file beside it, in both groups of sources."""
        root = Path(self.core["root"])
        named = images_named([root / file for file in self.groups[GROUPS[0]] if file.endswith(".v")])
        expect(named, "the core's Verilog names no memory image")
        for group in GROUPS[:2]:
            for image in sorted(named):
                file = f"src/{image}"
                expect(file in self.groups[group], f"{group} of the core lacks the memory image {image}")
                kind = self.properties[f"file:{group}:{file}", "type"]
                expect(kind == "mem", f"{image} is of type {kind}: synthesis passes it over")
                check_words(root / file)

    def check_project_images(self):
        """The same of a project that reads the Verilog directly."""
        named = images_named([Path(file) for file in self.files if file.endswith(".v")])
        images = {Path(file).name: Path(file) for file in self.files if file.endswith(".mem")}
        for name in sorted(named):
            expect(name in images, f"the project lacks the memory image {name}")
            check_words(images[name])

    def check_severity(self):
        severity = self.severities.get("Synth 8-4445")
        expect(severity == "ERROR", "a memory image that is missing would only be a warning")


def images_named(sources):
    """File names that the Verilog gives to its memories."""
    return {name for path in sources for name in re.findall(r'INIT_FILE\("([^"]+)"\)', path.read_text())}


def check_words(path):
    """Nothing but a hexadecimal number on each line."""
    for number, line in enumerate(path.read_text().splitlines(), start=1):
        expect(re.fullmatch("[0-9a-f]+", line), f"{path.name}, line {number} is no word: {line[:20]}")
