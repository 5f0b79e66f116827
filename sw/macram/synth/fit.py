"""Whether an array fits a device, as far as that is known without synthesis or from a report of it."""

from __future__ import annotations

from collections.abc import Mapping

from macram.spec import ArrayConfig
from macram.synth.devices import Device
from macram.synth.memories import block_memories, block_ram, dsp_slices

FIELDS = {
    "weights": "weight_depth, rows or units",
    "line buffer": "row_words or rows",
    "output buffer": "max_c_out",
    "requantiser": "max_c_out, or set requant_ram = 'distributed'",
}
"""Memory -> the fields of a configuration that make it smaller."""


def check_fits(config: ArrayConfig, device: Device, counted: Mapping[str, float] | None) -> None:
    """Refuse an array that is larger than a device of the UltraScale+ family.

    Args:
        config: the array.
        device: its limits are those of ``macram synth``.
        counted: ``lut`` and ``ff`` of this very design as ``macram synth`` counted them; None if it has not. DSP
            slices and block RAM are checked in any case: they follow from the configuration.

    Raises:
        ValueError: naming every resource of which the array takes too much, and what to change.
    """
    memories = block_memories(config)
    used = {"lut": 0.0, "ff": 0.0, "dsp": float(dsp_slices(config)), "bram": block_ram(memories)}
    used |= {key: counted[key] for key in ("lut", "ff")} if counted else {}
    excess = device.excess(used)
    if not excess:
        return
    fix = "use fewer units or rows, or another engine"
    if used["dsp"] <= device.limit("dsp") and used["bram"] > device.limit("bram"):
        largest = max(memories, key=lambda memory: memory.ramb36)
        fix = f"the {largest.name} take {largest.ramb36:g} RAMB36: use less {FIELDS[largest.name]}"
    raise ValueError(f"array {config.name} does not fit {device.name}: {'; '.join(excess)}; {fix}")
