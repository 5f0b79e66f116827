"""The clocks of a simulated array."""

from __future__ import annotations

from typing import Any

from cocotb.clock import Clock

PERIOD_NS = 10
"""Of ``aclk``; ``aclk2x``, where there is one, is twice as fast."""


def start_clocks(dut: Any) -> None:
    """Start ``aclk`` and, if the top has it, ``aclk2x``: every rising edge of ``aclk`` is one of ``aclk2x``.

    The simulator's own clock sets both before it evaluates the model, so coinciding edges are one event.
    """
    Clock(dut.aclk, PERIOD_NS, unit="ns").start()
    if hasattr(dut, "aclk2x"):
        Clock(dut.aclk2x, PERIOD_NS // 2, unit="ns").start()
