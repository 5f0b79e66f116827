"""Simulator builds of the tests stay in the repository, as those of `make` do, and long files come first."""

from __future__ import annotations

import os
from pathlib import Path

LONGEST = (
    "test_reference_layer.py",
    "test_cycles.py",
    "test_gate_level.py",
    "test_runner.py",
    "test_selftest.py",
    "test_formal.py",
    "test_partial_sums_sim.py",
    "test_kinds.py",
    "test_train_run.py",
    "test_designs.py",
)
"""Longest first. A file is one worker's: a long one that comes last leaves the other worker idle."""


def pytest_configure():
    os.environ.setdefault("MACRAM_BUILD_DIR", str(Path(__file__).resolve().parents[1] / "build"))


def pytest_collection_modifyitems(items):
    def place(item):
        name = item.path.name
        return LONGEST.index(name) if name in LONGEST else len(LONGEST)

    items.sort(key=place)
