"""Simulation tests need Verilator and a C++ compiler; without them they are skipped, or fail where that is
asked."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from macram_sim.tools import ToolError, find_toolchain


def pytest_collection_modifyitems(items):
    here = Path(__file__).parent
    for item in items:
        if here in item.path.parents:
            item.add_marker(pytest.mark.sim)


@pytest.fixture
def toolchain():
    try:
        return find_toolchain()
    except ToolError as error:
        if os.environ.get("MACRAM_REQUIRE_TOOLS", "0") not in ("", "0"):
            raise
        pytest.skip(str(error))
