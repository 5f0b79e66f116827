"""The step sequencer: which weight word meets which four pixels in which cycle."""

from amaranth.hdl import C, Cat, Module, Mux, Signal, signed
from amaranth.lib import data, wiring
from amaranth.lib.wiring import In, Out

from macram.spec import GROUP, TAPS, ArrayConfig
from macram_hw.line_buffer import ROWS_HELD, LineRead
from macram_hw.shape import LayerShape
from macram_hw.unit import AccumulateControl

__all__ = ["GroupInfo", "Sequencer", "Step"]


class GroupInfo(data.StructLayout):
    """What the drain must know of a finished (group, tile).

    Fields:
        tile: output-channel tile. tile_last: last tile of the group.
        slots: which of the result's 4 slots are pixels of the image.
        edge: first group of a row: slot 1 is column 0, slot 0 the last column of the row before.
        image_last: the last group of the image.
        triple: the sum is of this tile and the next two, of the outer two pixels or, if ``inner``, of the inner two.
        unloaded: not the sum, but the lanes of it that were carried.
    """

    def __init__(self, config: ArrayConfig):
        super().__init__({
            "tile": max(1, (config.max_tiles - 1).bit_length()), "tile_last": 1, "slots": GROUP,
            "edge": 1, "image_last": 1, "triple": 1, "inner": 1, "unloaded": 1,
        })  # fmt: skip


class Step(data.StructLayout):
    """One compute step: a line-buffer read, a weight address, what the accumulators do, and what follows."""

    def __init__(self, config: ArrayConfig):
        super().__init__({
            "read": LineRead(config),
            "weight": (config.weight_depth - 1).bit_length(),
            "control": AccumulateControl(config),
            "info": GroupInfo(config),
        })  # fmt: skip


class Sequencer(wiring.Component):
    """Walks rows, groups, tiles, kernel rows, pixel phases, channel blocks, innermost last; one step per cycle.

    A layer takes ``out_height * groups * tiles * kernel * phases * blocks`` steps. A 3x3 kernel with stride 2
    has two phases: four even columns, then the four odd ones beside them, each with taps of their own.
    In a packed layer three tiles together have two sums in the place of three, one of the outer two pixels of a
    group and one of the inner two. Lanes 4 and 5 of such a sum are carried, and as soon as there is a credit for them
    one cycle without a step moves them to the result registers. Slot s is column ``4 g + s`` there.
    Result slot 0 of the first group of a row is the last column of the row before, if the width is a
    multiple of 4; for the last row one flush step per tile brings it out. A group starts only once the last
    of its pixels are in the line buffer; its last step waits for a drain credit. Steps leave one cycle after
    they are decided.

    Members:
        start: In, begin an image. shape, weight_base: In, constant during a run.
        group_written, image_written: In, from the line buffer. retire, retire_row: Out, to it.
        credit: In, strobe: the result registers will be free in time for one more last step.
        valid, step: Out. busy: Out, steps remain; behind the last one carried lanes may still have to be moved.
        issue, starved, blocked: Out, this cycle decided a multiply-accumulate step, lacked pixels,
        lacked credit.
        flushing: Out, only flush steps remain.
    """

    def __init__(self, config: ArrayConfig):
        self._config = config
        super().__init__({
            "start": In(1),
            "shape": In(LayerShape()),
            "weight_base": In((config.weight_depth - 1).bit_length()),
            "group_written": In(1),
            "image_written": In(1),
            "retire": Out(1),
            "retire_row": Out(1),
            "credit": In(1),
            "valid": Out(1),
            "step": Out(Step(config)),
            "busy": Out(1),
            "issue": Out(1),
            "starved": Out(1),
            "blocked": Out(1),
            "flushing": Out(1),
        })  # fmt: skip

    def elaborate(self, platform):
        config, shape = self._config, self.shape
        m = Module()

        row, group, tile = Signal(16), Signal(15), Signal(12)
        kernel_row, odd, block = Signal(range(TAPS)), Signal(), Signal(14)
        flushing = self.flushing
        # Line-buffer words before this group, and weight words before this step.
        group_base = Signal(range(config.row_words // config.ingest + 1))
        weight = Signal(range(config.weight_depth + 1))

        # Of a triple's two sums the second; the carried lanes of one still have to be moved, and what they are.
        inner, unload_due, unload = Signal(), Signal(), Signal()
        carried_info = Signal(GroupInfo(config))
        triple = Signal()
        m.d.comb += triple.eq(shape.packed & (tile + (TAPS - 1) < shape.tiles))

        first_of_group, first, last = Signal(), Signal(), Signal()
        block_last, tile_last, group_last, row_last = Signal(), Signal(), Signal(), Signal()
        two_phases, kernel_row_last = Signal(), Signal()
        m.d.comb += [
            block_last.eq(flushing | (block + 1 == shape.blocks)),
            two_phases.eq(shape.halved & ~shape.pointwise),
            kernel_row_last.eq(block_last & (odd | ~two_phases)),
            first.eq(flushing | ((kernel_row == 0) & ~odd & (block == 0))),
            last.eq(flushing | (kernel_row_last & (shape.pointwise | (kernel_row == TAPS - 1)))),
            first_of_group.eq(first & (tile == 0) & ~inner),
            tile_last.eq(Mux(triple, inner & (tile + TAPS == shape.tiles), tile + 1 == shape.tiles)),
            group_last.eq(group + 1 == shape.groups),
            row_last.eq(row + 1 == shape.out_height),
        ]

        # Groups written beyond what the current group needs: with a 3x3 kernel, the row below down to itself.
        ahead = Signal(signed(len(group) + 3))
        # With stride 2 every output row but the first takes two more rows; the last only one if it is all there is.
        source_row_below = Signal(17)
        skipped = Signal()
        step_last = Signal()
        credits = Signal()
        pixels_ready = Signal()
        step = Signal()
        m.d.comb += [
            pixels_ready.eq(~first_of_group | self.image_written | (ahead > 0) | flushing),
            self.starved.eq(self.busy & ~pixels_ready),
            unload.eq(unload_due & credits),
            self.blocked.eq(self.busy & pixels_ready & ((last & ~credits) | unload)),
            step.eq(self.busy & pixels_ready & ~(last & ~credits) & ~unload),
            self.issue.eq(step & ~flushing),
            step_last.eq(self.issue & last & tile_last),
            # One more row than the next output row's first.
            source_row_below.eq(Mux(shape.pointwise, 2 * row + 2, 2 * row + 3)),
            skipped.eq(step_last & group_last & shape.halved & (source_row_below < shape.height)),
        ]
        m.d.sync += [
            # The group above the kernel is read out after the first kernel row of the last tile. A cycle
            # later, so that the last read of it comes before any write.
            self.retire.eq(self.issue & tile_last & (kernel_row == 0) & kernel_row_last),
            self.retire_row.eq(step_last & group_last & shape.halved),
            ahead.eq(
                ahead
                + self.group_written
                - (step & first_of_group & ~flushing)
                - Mux(skipped, shape.groups, 0)
            ),
        ]
        with m.If(self.credit):
            m.d.sync += credits.eq(1)
        with m.Elif((step & last) | unload):
            m.d.sync += credits.eq(0)

        # ---- advance ------------------------------------------------------------------------------------
        with m.If(step):
            m.d.sync += [block.eq(block + 1), weight.eq(weight + 1)]
            with m.If(block_last):
                m.d.sync += [block.eq(0), odd.eq(two_phases & ~odd)]
            with m.If(kernel_row_last):
                m.d.sync += kernel_row.eq(kernel_row + 1)
            with m.If(last):
                m.d.sync += [kernel_row.eq(0), odd.eq(0), unload_due.eq(triple)]
                with m.If(triple & ~inner):
                    m.d.sync += [inner.eq(1), weight.eq(weight + 1 - shape.blocks)]
                with m.Else():
                    m.d.sync += [inner.eq(0), tile.eq(tile + Mux(triple, TAPS, 1))]
                with m.If(tile_last):
                    m.d.sync += [tile.eq(0), weight.eq(self.weight_base), group.eq(group + 1)]
                    m.d.sync += group_base.eq(group_base + shape.column_words)
                    with m.If(group_last | flushing):
                        m.d.sync += [group.eq(0), group_base.eq(0), row.eq(row + 1)]
                        with m.If(row_last | flushing):
                            with m.If((shape.tail == 0) & ~shape.packed & ~flushing):
                                m.d.sync += flushing.eq(1)
                            with m.Else():
                                m.d.sync += [self.busy.eq(0), flushing.eq(0)]
        with m.If(unload):
            m.d.sync += unload_due.eq(0)
        with m.If(self.start):
            m.d.sync += [
                row.eq(0), group.eq(0), tile.eq(0), kernel_row.eq(0), odd.eq(0), block.eq(0),
                inner.eq(0), unload_due.eq(0), flushing.eq(0), group_base.eq(0), weight.eq(self.weight_base),
                self.busy.eq(1), credits.eq(1), self.retire.eq(0), self.retire_row.eq(0),
                ahead.eq(Mux((shape.height == 1) | shape.pointwise, 0, -shape.groups)),
            ]  # fmt: skip

        # ---- the step that leaves -----------------------------------------------------------------------
        source_row = Signal(signed(18))
        row_exists = Signal()
        pixels = Signal(GROUP)
        ingest_bits = (config.ingest - 1).bit_length()
        m.d.comb += [
            source_row.eq((row << shape.halved) + Mux(shape.pointwise, 0, kernel_row - 1)),
            row_exists.eq((source_row >= 0) & (source_row < shape.height) & ~flushing),
            pixels.eq(Mux(group_last & (shape.tail != 0), (1 << shape.tail) - 1, 0b1111)),
        ]
        edge = Signal()
        slots = Signal(GROUP)
        m.d.comb += edge.eq((group == 0) & ~shape.packed)
        with m.If(shape.packed):
            m.d.comb += slots.eq(pixels)
        with m.Else():
            # Slot s is column 4 g - 1 + s; slot 0 of the first group is the row before's last column.
            m.d.comb += [
                slots[0].eq(Mux(edge, (shape.tail == 0) & (row != 0), 1)),
                slots[1].eq(~flushing),
                slots[2].eq(~flushing & pixels[1]),
                slots[3].eq(~flushing & pixels[2]),
            ]
        # Of an odd width's last pair only the even pixel exists.
        columns = Mux(odd & group_last & shape.width[0], pixels >> 1, pixels)
        outer_two = Mux(inner, Cat(pixels[1], C(0, 2), pixels[2]), Cat(pixels[0], C(0, 2), pixels[3]))
        out, info = self.step, Signal(GroupInfo(config))
        m.d.comb += [
            info.tile.eq(tile),
            info.tile_last.eq(tile_last),
            info.slots.eq(slots),
            info.edge.eq(edge),
            info.image_last.eq(flushing | (row_last & group_last & ((shape.tail != 0) | shape.packed))),
            info.triple.eq(triple),
            info.inner.eq(inner),
        ]
        with m.If(step & last):
            m.d.sync += [carried_info.eq(info), carried_info.unloaded.eq(1)]
        m.d.sync += [
            self.valid.eq(step),
            out.read.slot.eq(source_row[: (ROWS_HELD - 1).bit_length()]),
            out.read.address.eq(group_base + Mux(odd, shape.ingest_words, 0) + (block >> ingest_bits)),
            out.read.bank.eq(block[:ingest_bits] if ingest_bits else 0),
            out.read.mask.eq(Mux(row_exists, Mux(triple, outer_two, columns), 0)),
            out.read.apart.eq(triple),
            out.read.inner.eq(inner),
            out.weight.eq(weight),
            out.control.en.eq(step),
            out.control.first.eq(first),
            out.control.last.eq(last),
            out.control.edge.eq(edge),
            out.control.carried.eq(unload | (first & ~shape.packed)),
            out.control.tile.eq(Mux(unload, carried_info.tile, tile)),
            out.control.unload.eq(unload),
            out.info.eq(Mux(unload, carried_info, info)),
        ]
        return m
