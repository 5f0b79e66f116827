"""How training on the CPU takes memory from the system."""

from __future__ import annotations

import ctypes
import os

MMAP_THRESHOLD, TRIM_THRESHOLD = -3, -1
"""Parameters of glibc's mallopt(3)."""
LARGEST, NEVER = 2**31 - 1, -1
HUGEPAGE = 14
"""Advice to madvise(2): large pages for this range."""
PIECE = 1 << 30
SHARE = 0.5
"""Of the machine's memory, reserved as addresses: nothing is taken before it is used."""


def keep_memory() -> None:
    """Asks for large pages, and for freed memory to stay with the process; call it before PyTorch is imported.

    Each step takes and frees the same gigabytes of activations. By default large tensors go back to the
    system when freed, so that every step pays for their page faults again. Without glibc nothing happens.

    The heap is stretched once and the whole of it advised. PyTorch's own way to large pages
    (``THP_MEM_ALLOC_ENABLE``) aligns every large tensor to one, which leaves gaps that the next tensor of the
    same size does not fit into: the heap grew by half, and every third step paid for it.
    """
    libc = ctypes.CDLL(None) if os.name == "posix" else None
    if libc is None or not hasattr(libc, "mallopt"):
        return
    libc.mallopt(MMAP_THRESHOLD, LARGEST)
    libc.mallopt(TRIM_THRESHOLD, NEVER)
    libc.malloc.restype = ctypes.c_void_p
    libc.malloc.argtypes = (ctypes.c_size_t,)
    libc.free.argtypes = (ctypes.c_void_p,)
    libc.madvise.argtypes = (ctypes.c_void_p, ctypes.c_size_t, ctypes.c_int)
    page, memory = os.sysconf("SC_PAGE_SIZE"), os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    pieces = [libc.malloc(PIECE) for _ in range(int(SHARE * memory) // PIECE)]
    for piece in filter(None, pieces):  # None where there are no such addresses left
        start = -(-piece // page) * page
        libc.madvise(start, (piece + PIECE - start) // page * page, HUGEPAGE)
    for piece in pieces:
        libc.free(piece)
