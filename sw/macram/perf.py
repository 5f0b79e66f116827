"""Closed-form cycles of a layer on an array; a simulation with undisturbed streams must give exactly these.

Cycles are counted from the first accepted input beat to the last output beat, both included, when neither
the source nor the sink ever makes the array wait.
"""

from __future__ import annotations

from dataclasses import dataclass

from macram.spec import GROUP, TAPS, ArrayConfig, ConvSpec, StreamLayout, ceil_div

DECISION_TO_RESULT = 5
"""Cycles from the decision of a compute step to its sum in the result registers, without the row engine's."""
RESULT_TO_OUTPUT = 4
"""Cycles from the last drained word to the first word in the output gearbox."""
WRITTEN_TO_DECISION = 2
"""Cycles from the last needed pixel in the line buffer to the first compute step."""


@dataclass(frozen=True, slots=True)
class CycleEstimate:
    """Where the cycles of a run go. `total` is the sum of the parts.

    Attributes:
        fill: before the first compute step: pixels for one row and one group more must arrive.
        mac: compute steps, ``height * groups * tiles * 3 * blocks``.
        stall: between compute steps. If a sum has fewer steps than it takes to drain, the drain is waited for; if
            a stream is the limit, that stream. The array books a wait under the first cause it meets, so only the
            sum of INPUT_STALLS and OUTPUT_STALLS is foretold.
        drain: after the last compute step.
        limited_by: ``"compute"``, or ``"input"``/``"output"`` if a stream is slower than the engines.
    """

    fill: int
    mac: int
    stall: int
    drain: int
    limited_by: str

    @property
    def total(self) -> int:
        """All cycles, fill and drain included."""
        return self.fill + self.mac + self.stall + self.drain

    @property
    def exact(self) -> bool:
        """Whether an undisturbed run takes exactly `total` cycles; where a stream is the limit, it is near."""
        return self.limited_by == "compute"


def estimate(layer: ConvSpec, array: ArrayConfig) -> CycleEstimate:
    """Cycles of ``layer`` on ``array``; 197,204 for the reference layer on the reference array.

    Raises:
        ValueError: the array does not admit the layer.
    """
    array.check_admits(layer)
    groups, tiles = array.groups(layer.width), array.tiles(layer.c_out)
    steps = TAPS * array.blocks(layer.c_in)
    tail = layer.width % GROUP
    pixels = layer.height * layer.width
    pixel_in, pixel_out = pixel_in_cycles(layer, array), pixel_out_cycles(layer, array)

    rows_needed = min(layer.height, 2)
    pixels_needed = (rows_needed - 1) * layer.width + min(GROUP, layer.width)
    fill = pixel_in * pixels_needed + WRITTEN_TO_DECISION - (pixels_needed == pixels)

    to_result = DECISION_TO_RESULT + array.engine_latency
    drain_period = max(array.drain_cycles, to_result + 1)
    period = max(steps, drain_period)
    sums = layer.height * groups * tiles
    mac = sums * steps
    stall = (sums - 1) * (period - steps)

    to_output = to_result + array.drain_cycles + RESULT_TO_OUTPUT
    if tail:
        # The last group's reading: the first of its slots is skipped if the row has no group before it.
        drain = to_output + (groups == 1) + (tail + (groups > 1)) * pixel_out
    else:
        # One pixel is flushed, behind the last group's reading if that takes longer than the flush.
        flush = tiles * drain_period
        single = layer.height == 1 and groups == 1
        before = (GROUP - single) * pixel_out + single
        drain = max(flush, before) + to_output + pixel_out

    limits = {
        "compute": fill + mac + stall + drain,
        "input": pixel_in * pixels + (1 if layer.height == 1 else groups + 1) * tiles * period + drain,
        "output": fill + (tiles - 1) * period + steps + to_output + pixels * pixel_out,
    }
    slowest = max(pixel_in, pixel_out)
    limited_by = "compute"
    if GROUP * slowest > tiles * period:
        limited_by = "input" if pixel_in == slowest else "output"
    total = max(limits["compute"], limits[limited_by])
    return CycleEstimate(fill, mac, total - fill - mac - drain, drain, limited_by)


def pixel_in_cycles(layer: ConvSpec, array: ArrayConfig) -> int:
    """Cycles per input pixel: word w leaves one cycle after the beat that completes it, one per cycle."""
    beats = StreamLayout(layer.c_in, layer.input, array.stream_bits).beats_per_pixel
    words = ceil_div(array.blocks(layer.c_in), array.ingest)
    word_bits = array.ingest * array.block_bits
    completing = [ceil_div((word + 1) * word_bits, array.stream_bits) for word in range(words - 1)] + [beats]
    return max(min(beat, beats) + words - 1 - word for word, beat in enumerate(completing))


def pixel_out_cycles(layer: ConvSpec, array: ArrayConfig) -> int:
    """Cycles per output pixel: beat b leaves one cycle after the word that completes it, one per cycle."""
    beats = StreamLayout(layer.c_out, layer.output, array.stream_bits).beats_per_pixel
    words = ceil_div(layer.c_out, array.output_word_channels)
    word_bits = array.output_word_channels * layer.output.bits
    completing = [ceil_div((beat + 1) * array.stream_bits, word_bits) for beat in range(beats - 1)] + [words]
    return max(word + beats - 1 - beat for beat, word in enumerate(completing))
