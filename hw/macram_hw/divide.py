"""Division by a constant as hardware has it: a shift, or one constant multiplication and a shift."""

from amaranth.hdl import Value

__all__ = ["ceil_div_constant", "reciprocal"]


def reciprocal(divisor: int, limit: int) -> tuple[int, int]:
    """Smallest (factor, shift) with ``n * factor >> shift == n // divisor`` for every n in 0..limit.

    With ``excess = factor * divisor - 2**shift`` the product is too large by ``n * excess / divisor`` parts of
    ``2**shift``; the quotient stays exact while ``limit * excess < 2**shift``.
    """
    shift = 0
    while True:
        factor = -(-(1 << shift) // divisor)
        if limit * (factor * divisor - (1 << shift)) < 1 << shift:
            return factor, shift
        shift += 1


def ceil_div_constant(value: Value, divisor: int, limit: int) -> Value:
    """``ceil(value / divisor)`` for ``value`` in 0..limit, whatever its width; beyond the limit, anything.

    A power of two costs an adder, any other divisor also a constant multiplication.
    """
    if divisor & (divisor - 1) == 0:
        return (value + (divisor - 1)) >> (divisor - 1).bit_length()
    raised = (value[: limit.bit_length()] + (divisor - 1))[: (limit + divisor - 1).bit_length()]
    factor, shift = reciprocal(divisor, limit + divisor - 1)
    return (raised * factor) >> shift
