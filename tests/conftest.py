"""Simulator builds of the tests stay in the repository, as those of `make` do."""

from __future__ import annotations

import os
from pathlib import Path


def pytest_configure():
    os.environ.setdefault("MACRAM_BUILD_DIR", str(Path(__file__).resolve().parents[1] / "build"))
