"""How training on the CPU takes memory from the system."""

from __future__ import annotations

import ctypes
import os

MMAP_THRESHOLD, TRIM_THRESHOLD = -3, -1
"""Parameters of glibc's mallopt(3)."""
LARGEST, NEVER = 2**31 - 1, -1


def keep_memory() -> None:
    """Asks for large pages, and for freed memory to stay with the process; call it before PyTorch is imported.

    Each step takes and frees the same gigabytes of activations. By default large tensors go back to the
    system when freed, so that every step pays for their page faults again. Without glibc nothing happens.
    """
    os.environ.setdefault("THP_MEM_ALLOC_ENABLE", "1")  # of PyTorch: large tensors in large pages
    mallopt = getattr(ctypes.CDLL(None), "mallopt", None) if os.name == "posix" else None
    if mallopt is not None:
        mallopt(MMAP_THRESHOLD, LARGEST)
        mallopt(TRIM_THRESHOLD, NEVER)
