"""Amaranth -> Verilog without weights: one file per design, memories and the unit as shared modules."""

import hashlib
import json
import re
from dataclasses import dataclass
from importlib import resources
from pathlib import Path

import amaranth
from amaranth.back import verilog
from amaranth.hdl import ClockDomain, ClockSignal, Fragment, Instance, ResetSignal, Value
from amaranth.hdl._ir import PortDirection
from amaranth.hdl._xfrm import DomainCollector
from amaranth.lib import memory
from amaranth.lib.wiring import In

from macram.spec import ArrayConfig
from macram.spec.registers import register_table
from macram_hw.top import Top
from macram_hw.unit import UnitCore

__all__ = ["TOPLEVEL", "Export", "component_verilog", "export_verilog", "model_path"]

TOPLEVEL = "macram_top"
UNIT = "macram_unit"
FORMAT = 1
BLOCK = "block"
"""Style of ``macram_ram`` unless its ``STYLE`` says otherwise."""


@dataclass(frozen=True)
class Export:
    """What `export_verilog` wrote: ``sources`` in compile order, with lint waivers and simulation models."""

    directory: Path
    sources: list[Path]
    toplevel: str = TOPLEVEL


class _ExportPlatform:
    """Replaces memories by ``macram_ram`` instances and every unit core by an instance of one shared module.

    ``macram_ram`` reads its contents from a file named by a parameter, so the Verilog carries no weights.
    """

    def get_memory(self, store: memory.Memory):
        (write,), (read,) = store.write_ports, store.read_ports
        width = Value.cast(write.data).shape().width
        module = "macram_lutram" if read.domain == "comb" else "macram_ram"
        options = {} if read.domain == "comb" else {"i_read_en": read.en}
        if store.attrs.get("macram.style", BLOCK) != BLOCK:
            options["p_STYLE"] = store.attrs["macram.style"]
        return Instance(
            module,
            p_WIDTH=width,
            p_DEPTH=store.depth,
            p_ADDR_BITS=max(1, (store.depth - 1).bit_length()),
            p_LANES=len(write.en),
            p_INIT_FILE=store.attrs.get("macram.init_file", ""),
            i_clk=ClockSignal(),
            i_write_en=write.en,
            i_write_addr=write.addr,
            i_write_data=Value.cast(write.data),
            i_read_addr=read.addr,
            o_read_data=Value.cast(read.data),
            **options,
        )

    @staticmethod
    def unit_instance(core) -> Instance:
        """An instance of the unit's Verilog module on the interface ``core``."""
        ports = {
            f"{'i' if member.flow == In else 'o'}_{name}": Value.cast(getattr(core, name))
            for name, member in core.signature.members.items()
        }
        double = {"i_double_clk": ClockSignal("double")} if "second" in core.signature.members else {}
        return Instance(UNIT, i_clk=ClockSignal(), i_rst=ResetSignal(), **double, **ports)


def model_path(name: str) -> Path:
    """A hand-written Verilog file of this package."""
    return Path(str(resources.files("macram_hw") / "verilog" / name))


def component_verilog(component, name: str) -> str:
    """One component as a Verilog module ``name``, memories and primitives as instances; the same bytes each time."""
    fragment = Fragment.get(component, _ExportPlatform())
    # With directions: an output that this component leaves at its initial value would else become an input.
    ports = {
        "__".join(map(str, path)): (
            Value.cast(value),
            PortDirection.Input if member.flow == In else PortDirection.Output,
        )
        for path, member, value in component.signature.flatten(component)
    }
    for domain in _missing_domains(fragment):
        fragment.add_domains(domain)
        ports |= {
            port.name: (port, PortDirection.Input) for port in (domain.clk, domain.rst) if port is not None
        }
    text = verilog.convert(fragment, name, ports=ports, emit_src=False, strip_internal_attrs=True)
    # The banner names the generator's build; the same configuration must give the same bytes.
    return re.sub(r"\A/\*.*?\*/\n", "", text, count=1)


def _missing_domains(fragment: Fragment) -> list[ClockDomain]:
    """Clock domains that a component uses and does not define, the array's first.

    Amaranth would add them by itself, but in the order of a set of names, which differs from process to process.
    """
    collector = DomainCollector()
    collector(fragment)
    names = sorted(collector.used_domains - collector.defined_domains, reverse=True)
    return [ClockDomain(name, reset_less=name == "double") for name in names]


def export_verilog(config: ArrayConfig, directory: Path, *, mem_dir: Path | None = None) -> Export:
    """Write the array as Verilog, with the hand-written memories, lint waivers, file list and manifest.

    The same configuration gives the same bytes; files whose text has not changed are left alone.

    Args:
        config: the array.
        directory: made if missing.
        mem_dir: where the array's ``.mem`` files lie, listed in the manifest with their hashes.
    """
    directory = Path(directory)
    texts = {
        "macram_top.v": component_verilog(Top(config), TOPLEVEL),
        "macram_unit.v": component_verilog(UnitCore(config), UNIT),
    }
    by_hand = ["lint.vlt", "macram_ram.v", "macram_lutram.v", "macram_add3.v"]
    if "soft" in config.row_kinds:
        by_hand.append("macram_product.v")
    order = [*by_hand, "macram_unit.v", "macram_top.v"]
    texts |= {name: model_path(name).read_text() for name in by_hand}
    texts["macram_top.f"] = "".join(f"{name}\n" for name in order)
    if {"dsp48e2", "dsp48e2_2x"} & set(config.row_kinds):
        # For simulation only, so not in the file list.
        order.insert(1, "DSP48E2.v")
        texts["DSP48E2.v"] = model_path("DSP48E2.v").read_text()
    texts["registers.md"] = register_table()
    hashes = {name: hashlib.sha256(text.encode()).hexdigest() for name, text in sorted(texts.items())}
    if mem_dir is not None:
        # By name: what else may lie in the folder is no part of this array.
        names = ["requant.mem", *sorted(f"unit_{unit:03d}.mem" for unit in range(config.units))]
        hashes |= {
            f"mem/{name}": hashlib.sha256((Path(mem_dir) / name).read_bytes()).hexdigest() for name in names
        }
    manifest = {
        "format": FORMAT,
        "toplevel": TOPLEVEL,
        "array": config.to_dict(),
        "amaranth": amaranth.__version__,
        "sha256": hashes,
    }
    texts["manifest.json"] = json.dumps(manifest, indent=2) + "\n"

    directory.mkdir(parents=True, exist_ok=True)
    for name, text in texts.items():
        _write_if_changed(directory / name, text)
    return Export(directory, [directory / name for name in order])


def _write_if_changed(path: Path, text: str) -> None:
    if path.exists() and path.read_text() == text:
        return
    draft = path.with_suffix(path.suffix + ".tmp")
    draft.write_text(text)
    draft.replace(path)
