"""Closed-form cycles of a layer on an array; a simulation with undisturbed streams must give exactly these.

Cycles are counted from the first accepted input beat to the last output beat, both included, when neither
the source nor the sink ever makes the array wait.
"""

from __future__ import annotations

from dataclasses import dataclass

from macram.spec import (
    GROUP,
    RESIDUAL,
    TAPS,
    ArrayConfig,
    ConvSpec,
    IntFormat,
    StreamLayout,
    ceil_div,
    layer_passes,
)
from macram.spec.fixed import DECISION_TO_RESULT

RESULT_TO_OUTPUT = 5
"""Cycles from the last drained word to the first word in the output gearbox."""
RESIDUAL_LATENCY = 2
"""Cycles through the residual adder, in use or not."""
WRITTEN_TO_DECISION = 2
"""Cycles from the last needed pixel in the line buffer to the first compute step."""


@dataclass(frozen=True, slots=True)
class CycleEstimate:
    """Where the cycles of a run go. `total` is the sum of the parts.

    Attributes:
        fill: before the first compute step: pixels for one row and one group more must arrive.
        mac: compute steps, ``out_height * groups * tiles * kernel * phases * blocks``; three tiles that are computed
            together count as two.
        stall: between compute steps. If a sum has fewer steps than it takes to drain, on the streams of partial sums
            if they are used, the drain is waited for; a sum of three tiles always takes one cycle more. If another
            stream is the limit, that stream. The array books a wait under the first cause it meets, so only the sum
            of INPUT_STALLS and OUTPUT_STALLS is foretold.
        drain: after the last compute step.
        limited_by: ``"compute"``, or ``"input"``/``"output"`` if a stream is slower than the engines; ``"sums"`` if
            the first partial sums come later than what they are added to.
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


def estimate_passes(layer: ConvSpec, array: ArrayConfig) -> list[CycleEstimate]:
    """Cycles of every pass of ``layer`` on ``array``, see `macram.spec.layer_passes`.

    Raises:
        ValueError: the array does not admit even one tile of the layer.
    """
    return [
        estimate(part.layer, array, sums_in=part.sums_in, sums_out=part.sums_out)
        for part in layer_passes(layer, array)
    ]


def estimate(
    layer: ConvSpec,
    array: ArrayConfig,
    *,
    residual: bool = False,
    sums_in: bool = False,
    sums_out: bool = False,
) -> CycleEstimate:
    """Cycles of ``layer`` on ``array``; 197,205 for the reference layer on the reference array.

    Args:
        layer: what is run.
        array: on what.
        residual: with a residual sum behind it.
        sums_in: it starts from partial sums.
        sums_out: it gives partial sums instead of codes.

    Raises:
        ValueError: the array does not admit the layer.
    """
    array.check_admits(layer)
    groups, tiles = array.groups(layer.out_width), array.tiles(layer.c_out)
    steps = array.steps(layer)
    tail = layer.out_width % GROUP
    pixels, pixels_out = layer.height * layer.width, layer.out_height * layer.out_width
    pixel_in, pixel_out = pixel_in_cycles(layer, array), pixel_out_cycles(layer, array)
    if residual:
        pixel_out = max(pixel_out, pixel_residual_cycles(layer, array))
    group_in = min(GROUP * layer.stride, layer.width)

    rows_above = min(layer.height - 1, layer.padding)
    pixels_needed = rows_above * layer.width + group_in
    fill = pixel_in * pixels_needed + WRITTEN_TO_DECISION - (pixels_needed == pixels)

    to_result = DECISION_TO_RESULT + array.engine_latency
    to_drained, drain_period = array.drain_cycles, array.drain_period
    if sums_in or sums_out:
        # Each word of sums takes its beats and a cycle; the next sum may be finished once the last is drained.
        word = array.sum_word_beats + 1
        to_drained = (array.drain_cycles - 1) * word + 1
        drain_period = max(to_result + to_drained, array.drain_cycles * word)
    period, pair_period = max(steps, drain_period), max(steps + 1, array.pair_drain)
    out_groups = layer.out_height * groups
    # Of three tiles that are computed together each sum is one of two pixels.
    triples = array.triples(layer)
    pairs, singles = 2 * triples, tiles - TAPS * triples
    last_period = period if singles else pair_period
    group_period = pairs * pair_period + singles * period
    mac = out_groups * (pairs + singles) * steps
    stall = out_groups * group_period - mac - (last_period - steps)

    adder = RESIDUAL_LATENCY if array.residual_stream_bits else 0
    to_output = to_result + to_drained + RESULT_TO_OUTPUT + adder
    if sums_out:
        drain = (0 if tail else tiles * drain_period) + to_result + to_drained + array.sum_word_beats - 1
        pixel_out = 0
    elif triples:
        rounds = 0 if singles else drain_period + array.drain_cycles
        drain = to_output + rounds + (tail or GROUP) * pixel_out
    elif tail:
        # The last group's reading: the first of its slots is skipped if the row has no group before it.
        drain = to_output + (groups == 1) + (tail + (groups > 1)) * pixel_out
    else:
        # One pixel is flushed, behind the last group's reading if that takes longer than the flush.
        flush = tiles * drain_period
        single = layer.out_height == 1 and groups == 1
        before = (GROUP - single) * pixel_out + single
        drain = max(flush, before) + to_output + pixel_out

    compute = fill + mac + stall + drain
    rows_used = min(layer.height, (layer.out_height - 1) * layer.stride + layer.kernel - layer.padding)
    # Sums left when the last needed pixel is in: those of the last output row, or of the last group.
    waits_for_row = rows_above and (layer.stride == 1 or layer.height % 2)
    groups_after = groups * bool(waits_for_row) + (layer.stride == 1 or not waits_for_row)
    # A group of the last row may still be computed when the pixels of those behind it are there: with a stride of 2
    # they come twice as fast within a row as over all rows, and the last group may have few.
    behind = 0
    if not waits_for_row:
        to_come = (max(0, layer.width - group * group_in) * pixel_in for group in range(1, groups + 1))
        behind = max((groups - group) * group_period - left for group, left in enumerate(to_come, 1))
        behind += behind > 0  # the cycle between the pixels' coming and the first step
    limits = {
        "input": pixel_in * rows_used * layer.width
        + 1
        + behind
        + groups_after * group_period
        - (last_period - steps)
        + drain,
        "output": fill + group_period - last_period + steps + to_output + pixels_out * pixel_out,
    }
    group_cycles = {"input": group_in * layer.stride * pixel_in, "output": GROUP * pixel_out}
    limited_by = "compute"
    # Behind a triple the cycle for its carried lanes falls into the next group, which so asks for pixels before that.
    early = not singles
    if late := _late_row_cycles(layer, array, period):
        # The last row may lack the late one.
        limited_by = "input"
        limits["input"] = max(limits["input"], compute + late * (layer.height // 2 - 1))
    elif out_groups > 1 and max(group_cycles.values()) > group_period - early:
        limited_by = max(group_cycles, key=lambda stream: group_cycles[stream])
    if sums_in and array.sum_word_beats >= fill + steps + to_result:
        limited_by = "sums"
    total = max(compute, limits.get(limited_by, 0))
    return CycleEstimate(fill, mac, total - fill - mac - drain, drain, limited_by)


def _late_row_cycles(layer: ConvSpec, array: ArrayConfig, period: int) -> int:
    """Cycles for which an output row of a single group waits for its lowest input row.

    With stride 2 that row takes the place of the uppermost row of the output row before, which is free once the
    last sum there is through its first kernel row.
    """
    if (layer.kernel, layer.stride) != (3, 2) or array.groups(layer.out_width) > 1 or layer.height < 4:
        return 0
    written = layer.width * pixel_in_cycles(layer, array) + WRITTEN_TO_DECISION
    return max(0, written - (period - array.steps(layer) // layer.kernel))


def pixel_in_cycles(layer: ConvSpec, array: ArrayConfig) -> int:
    """Cycles per input pixel: word w leaves one cycle after the beat that completes it, one per cycle."""
    beats = StreamLayout(layer.c_in, layer.input, array.stream_bits).beats_per_pixel
    words = ceil_div(array.blocks(layer.c_in), array.ingest)
    return _ingest_cycles(beats, array.stream_bits, words, array.ingest * array.block_bits)


def pixel_out_cycles(layer: ConvSpec, array: ArrayConfig) -> int:
    """Cycles per output pixel: beat b leaves one cycle after the word that completes it, one per cycle."""
    return _emit_cycles(layer, array, layer.output, array.stream_bits)


def pixel_residual_cycles(layer: ConvSpec, array: ArrayConfig) -> int:
    """Cycles per output pixel on the slower of the residual adder's streams."""
    beat_bits = array.residual_stream_bits
    beats = StreamLayout(layer.c_out, RESIDUAL, beat_bits).beats_per_pixel
    words = ceil_div(layer.c_out, array.output_word_channels)
    coming = _ingest_cycles(beats, beat_bits, words, array.output_word_channels * RESIDUAL.bits)
    return max(coming, _emit_cycles(layer, array, RESIDUAL, beat_bits))


def _ingest_cycles(beats: int, beat_bits: int, words: int, word_bits: int) -> int:
    completing = [ceil_div((word + 1) * word_bits, beat_bits) for word in range(words - 1)] + [beats]
    return max(min(beat, beats) + words - 1 - word for word, beat in enumerate(completing))


def _emit_cycles(layer: ConvSpec, array: ArrayConfig, form: IntFormat, beat_bits: int) -> int:
    beats = StreamLayout(layer.c_out, form, beat_bits).beats_per_pixel
    words = ceil_div(layer.c_out, array.output_word_channels)
    word_bits = array.output_word_channels * form.bits
    completing = [ceil_div((beat + 1) * beat_bits, word_bits) for beat in range(beats - 1)] + [words]
    return max(word + beats - 1 - beat for beat, word in enumerate(completing))
