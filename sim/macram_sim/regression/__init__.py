"""The constrained-random regression with functional coverage; docs/verification.md says what it shows."""

from __future__ import annotations

from macram_sim.regression.arrays import ARRAYS
from macram_sim.regression.run import CASES, Regression, choose_cases, regress

__all__ = ["ARRAYS", "CASES", "Regression", "choose_cases", "regress"]
