"""Formal proofs on the exported Verilog."""

PROOFS = ()


def prove():
    """Later."""
