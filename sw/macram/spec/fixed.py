"""What is the same in every array: the shape of a row engine, field widths, kinds of engines."""

from __future__ import annotations

from macram.spec.formats import IntFormat

GROUP = 4
"""Pixels of one row that a row engine takes per cycle."""
TAPS = 3
"""Taps of one kernel row; also the kernel rows of a 3x3 kernel."""
LANES = GROUP + TAPS - 1
"""Lane sums of one row engine: lane k of group g belongs to output column ``4 g + k - 1``."""
SECTIONS = 4
"""Pixel groups in the output buffer. With two, a drain as long as the reading would wait for its end."""
MULT_BITS, OFFSET_BITS, SHIFT_BITS = 18, 48, 6
"""Field widths of the multiplier-shift requantiser (5 to 8 output bits)."""
MAX_THRESHOLD_BITS = 4
"""Up to this many output bits the requantiser compares with thresholds."""
STREAM_BITS = (32, 64, 128, 256, 512)
"""Possible widths of TDATA."""
RESIDUAL = IntFormat(8)
"""Codes of a residual stream."""
MAX_BRANCH_BITS = 3
"""Most bits of the codes that the residual adder takes: its table lies in registers."""
MAX_SUM_CHANNELS = 1 << 16
"""Most input channels of a layer in blocks: at 8 bits their sums have 36 bits."""
MAX_SIDE = 0xFFFF
"""Largest height and width of an image."""
ENGINE_LATENCY = {"portable": 1, "dsp48e2": 4, "dsp48e2_2x": 5, "soft": 1}
"""Row-engine kinds and their latencies in cycles. ``portable``: plain multipliers. ``dsp48e2``: twelve products in
one DSP slice of UltraScale+. ``dsp48e2_2x``: the same slice at twice the array's clock, serving two rows. ``soft``:
products as tables in the LUTs of UltraScale+. All but the first take weights and unsigned activations of up to 3
bits."""
DECISION_TO_RESULT = 5
"""Cycles from the decision of a compute step to its sum in the result registers, without the row engine's."""
RAM_STYLES = ("block", "distributed")
"""Values of the synthesis attribute ``ram_style``."""
PACKED_BITS = 3
"""Most bits of an operand of the kinds other than ``portable``: the lanes in a DSP slice lie 7 bits apart, and the
operands of a product in LUTs fill the inputs of one LUT."""
