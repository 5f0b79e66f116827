"""Closed-form cycles of a layer on an array, cause by cause; simulation must give exactly these.

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
        output_stall: compute waits for the drain, if a (group, tile) has fewer steps than drain cycles.
        drain: after the last compute step.
        limited_by: ``"compute"``, or ``"input"``/``"output"`` if a stream is slower than the engines; then
            the parts are a lower bound, not exact.
    """

    fill: int
    mac: int
    output_stall: int
    drain: int
    limited_by: str

    @property
    def total(self) -> int:
        """All cycles, fill and drain included."""
        return self.fill + self.mac + self.output_stall + self.drain

    @property
    def exact(self) -> bool:
        """Whether a simulation without stalls must take exactly `total` cycles."""
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

    pixel_in = pixel_in_cycles(layer, array)
    rows_needed = min(layer.height, 2)
    pixels_needed = (rows_needed - 1) * layer.width + min(GROUP, layer.width)
    whole_image = pixels_needed == layer.height * layer.width
    fill = pixel_in * pixels_needed + WRITTEN_TO_DECISION - whole_image

    to_result = DECISION_TO_RESULT + array.engine_latency
    drain_period = max(array.drain_cycles, to_result + 1)
    period = max(steps, drain_period)
    results = layer.height * groups * tiles
    mac = results * steps
    output_stall = (results - 1) * (period - steps)

    pixel_out = pixel_out_cycles(layer, array)
    flush = 0 if tail else tiles * drain_period
    last_pixels = tail + (groups > 1) if tail else 1
    skipped_slot = int(groups == 1 and tail != 0)
    drain = flush + to_result + array.drain_cycles + RESULT_TO_OUTPUT + skipped_slot + last_pixels * pixel_out
    limited_by = "compute"
    if GROUP * pixel_in > tiles * period:
        limited_by = "input"
    elif GROUP * pixel_out > tiles * period:
        limited_by = "output"
    return CycleEstimate(fill, mac, output_stall, drain, limited_by)


def pixel_in_cycles(layer: ConvSpec, array: ArrayConfig) -> int:
    """Cycles per input pixel: a beat and an ingest word per cycle, pixels do not share beats."""
    beats = StreamLayout(layer.c_in, layer.input, array.stream_bits).beats_per_pixel
    words = ceil_div(array.blocks(layer.c_in), array.ingest)
    beats_of_first_word = min(beats, ceil_div(array.ingest * array.block_bits, array.stream_bits))
    return max(beats, words - 1 + beats_of_first_word)


def pixel_out_cycles(layer: ConvSpec, array: ArrayConfig) -> int:
    """Cycles per output pixel: beat b leaves one cycle after the word that completes it, one per cycle."""
    beats = StreamLayout(layer.c_out, layer.output, array.stream_bits).beats_per_pixel
    words = ceil_div(layer.c_out, array.output_word_channels)
    word_bits = array.output_word_channels * layer.output.bits
    completing = [ceil_div((beat + 1) * array.stream_bits, word_bits) for beat in range(beats - 1)] + [words]
    return max(word + beats - 1 - beat for beat, word in enumerate(completing))
