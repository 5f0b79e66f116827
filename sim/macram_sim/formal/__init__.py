"""Formal proofs on the exported Verilog: real modules, SymbiYosys, an SMT solver."""

from __future__ import annotations

from macram_sim.formal.accumulators import ACCUMULATORS
from macram_sim.formal.arithmetic import ARITHMETIC
from macram_sim.formal.control import CONTROL
from macram_sim.formal.gearboxes import GEARBOXES
from macram_sim.formal.images import IMAGES
from macram_sim.formal.loads import LOADING
from macram_sim.formal.proof import Break, Proof, ProofVerdict, prove
from macram_sim.formal.sums import PARTIAL_SUMS

PROOFS: tuple[Proof, ...] = (
    *GEARBOXES,
    *IMAGES,
    *PARTIAL_SUMS,
    *LOADING,
    *CONTROL,
    *ARITHMETIC,
    *ACCUMULATORS,
)
"""Every proof."""

__all__ = ["PROOFS", "Break", "Proof", "ProofVerdict", "prove"]
