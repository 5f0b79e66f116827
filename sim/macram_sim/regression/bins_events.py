"""Bins of what happened: reloads, resets, faults, and what was refused."""

from __future__ import annotations

from collections.abc import Iterable

from macram_sim.regression.observation import Bin, adds_blocks, adds_residual, always

_ON_EVERY_ARRAY = (
    ("one image", "the plain run"),
    ("another image, same weights", "no state of the first image is left"),
    ("other weights, same shape", "a reload replaces every word"),
    ("a layer loaded while an image runs", "neither disturbs the other"),
    ("a run of the layer that was loaded beside another", "its words are where its bases say"),
    ("an image begun and ended beside a load", "neither disturbs the other"),
    ("registers read in a run", "reads disturb nothing"),
    ("the next image waits at the port", "its first beat is neither lost nor taken early"),
    ("a register written while busy", "refused, and the image is unharmed"),
    ("a command while busy", "refused, and the image is unharmed"),
    ("a read-only register written", "refused"),
    ("an unmapped address written", "refused"),
    ("an unmapped address read", "refused"),
    ("soft reset before the first beat", "armed, nothing taken"),
    ("soft reset while the line buffer fills", "input side only"),
    ("soft reset between output beats", "every stage is occupied"),
    ("soft reset after the last input beat", "output side only"),
    ("soft reset in a load of weights", "half a memory written"),
    ("soft reset in a load of the requantiser", "half a memory written"),
    ("soft reset with other commands", "it overrides them"),
    ("reset input in a run", "registers fall back, memories stay"),
    ("TLAST_EARLY in an image", "named, and the image ends by its shape"),
    ("TLAST_MISSING in an image", "named, and the image ends by its shape"),
    ("an image that ends too soon", "named, and a soft reset recovers"),
    ("TLAST_EARLY in a load of weights", "named, and the load ends"),
    ("TLAST_MISSING in a load of weights", "named, and the load ends"),
    ("TLAST_EARLY in a load of the requantiser", "named, and the load ends"),
    ("TLAST_MISSING in a load of the requantiser", "named, and the load ends"),
    *(
        (f"BAD_SHAPE, {name} {fault}", "each limit is compared by itself")
        for name in ("HEIGHT", "WIDTH", "C_IN", "C_OUT")
        for fault in ("0", "too large")
    ),
    ("BAD_SHAPE, row too long", "the line buffer's limit"),
    *((f"BAD_MODE, {what}", "each field of MODE is compared") for what in ("kernel", "stride", "padding")),
    ("BAD_MODE, a bit that the array lacks", "a driver must not take it for an array that has it"),
    ("BAD_RANGE, no words", "a load that would never end"),
    ("BAD_RANGE, too many weights", "a load beyond the memory"),
    ("BAD_RANGE, too many requantiser words", "a load beyond the memory"),
    ("BAD_RANGE, weights beyond the end", "base and words together"),
    ("BAD_RANGE, requantiser words beyond the end", "base and words together"),
    ("BAD_RANGE, a layer beyond the weights", "its base and its words together"),
    ("BAD_RANGE, a layer beyond the requantiser", "its base and its words together"),
    ("BAD_RANGE, a start in the load of its words", "refused, and the load goes on"),
    ("BAD_RANGE, a load onto the running layer", "refused, and the image is unharmed"),
    ("BAD_COMMAND, two commands", "no order is defined"),
)
_WITH_RESIDUAL = (
    ("a residual stream that comes late", "codes wait for it; the image does not until the buffers are full"),
    ("residual sums that are taken late", "codes wait for them"),
    (
        "soft reset between beats of the residual stream",
        "half a pixel in the gearboxes on both sides of the adder",
    ),
    ("TLAST_EARLY in a residual stream", "named, and the image ends by its shape"),
    ("TLAST_MISSING in a residual stream", "named, and the image ends by its shape"),
    ("a residual stream that ends too soon", "named, and a soft reset recovers"),
)
_WITH_BLOCKS = (
    ("a layer in blocks, its own sums coming back", "what leaves is what comes in"),
    ("partial sums that come late", "the drain waits, then the sequencer, then the image"),
    ("soft reset between beats of partial sums that come", "part of a word in the shift register"),
    ("soft reset between beats of partial sums that leave", "part of a word in the shift register"),
    ("TLAST_EARLY within a word of sums", "named at its beat, and the image ends by its shape"),
    (
        "TLAST_EARLY at the end of a word of sums",
        "named when the word is taken, and the image ends by its shape",
    ),
    ("TLAST_MISSING in partial sums", "named, and the image ends by its shape"),
    ("partial sums that end too soon", "named, and a soft reset recovers"),
    ("BAD_RANGE, a start that takes sums beside a load", "they share the port of the parameters"),
    ("BAD_COMMAND, a load while sums come", "they share the port of the parameters"),
)


def events() -> Iterable[Bin]:
    """Events, of which some are for arrays with residual or partial sums."""
    for table, possible in (
        (_ON_EVERY_ARRAY, always),
        (_WITH_RESIDUAL, adds_residual),
        (_WITH_BLOCKS, adds_blocks),
    ):
        for name, reason in table:
            yield Bin(name, reason, lambda s, n=name: n in s.events, possible)  # type: ignore[misc]
    yield Bin(
        "BAD_SHAPE, too many weights", "the weight memory's limit",
        lambda s: "BAD_SHAPE, too many weights" in s.events,
        lambda a: 3 * a.max_tiles * a.blocks(a.max_c_in) > a.weight_depth,
    )  # fmt: skip
    yield Bin(
        "BAD_MODE, a residual sum where sums leave", "a residual sum needs codes",
        lambda s: "BAD_MODE, a residual sum where sums leave" in s.events,
        lambda a: adds_blocks(a) and adds_residual(a),
    )  # fmt: skip
