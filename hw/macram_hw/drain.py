"""The drain: result registers -> requantiser -> output buffer -> words in pixel order."""

from amaranth.hdl import Array, Cat, Const, Module, Mux, Signal
from amaranth.lib import data, memory, stream, wiring
from amaranth.lib.wiring import In, Out

from macram.spec import GROUP, TAPS, ArrayConfig
from macram.spec.fixed import SECTIONS
from macram_hw.engine import hdl_shape
from macram_hw.gearbox import PixelWord
from macram_hw.line_buffer import LineBuffer
from macram_hw.partial import SumWord, sum_layout
from macram_hw.requant import Requantiser
from macram_hw.sequencer import GroupInfo
from macram_hw.shape import LayerShape
from macram_hw.unit import unit_latency

__all__ = ["Drain", "RequantWrite"]


class RequantWrite(data.StructLayout):
    """A write to the requantiser's parameter memory."""

    def __init__(self, config: ArrayConfig):
        super().__init__({"addr": (config.requant_depth - 1).bit_length(), "data": config.requant_word_bits})


class Drain(wiring.Component):
    """Requantises finished sums, ``drain`` channels x 4 pixels per cycle, and puts them in pixel order.

    One (group, tile) takes ``drain_cycles`` cycles. Of a triple the result registers hold two pixels of three tiles:
    the sum's round requantises the first tile, two more the others once the carried lanes have been moved; the chains
    are rings, so a round leaves them as they were. Codes of the outer two pixels wait for those of the inner two.
    The output buffer is a ring of ``SECTIONS`` groups; a
    group starts draining only when its section is free, and then never stops, so the credit can be given back
    early: `credit_at` cycles into the drain.

    Members:
        shape, requant_base: In, constant during a run.
        finished, info: In, strobe when the result registers have been loaded, with a sum or with carried lanes, and for
            which group.
        heads: In, accumulators at the head of the ``drain`` chains. shift: Out, to all units.
        credit: Out, strobe to the sequencer.
        write_en, write: In, parameter reload.
        o: Out stream, `PixelWord` of ``4 * drain`` channels; one per cycle when not stalled.
        takes, gives, addends, results, last: with partial sums only. In, constant during a run: it starts from sums,
            it gives sums instead of codes. In stream, what is added to the heads. Out stream, `SumWord`, their sums.
            Out, the drain is at the image's last word. Each cycle of such a run waits for these streams, so the
            credit is given only with the last shift.
    """

    def __init__(self, config: ArrayConfig):
        self._config = config
        decision_to_result = 1 + LineBuffer.LATENCY + unit_latency(config)
        self.credit_at = max(config.drain_cycles - decision_to_result - 1, 0)
        chains = data.ArrayLayout(data.ArrayLayout(hdl_shape(config.accumulator), GROUP), config.drain)
        super().__init__({
            "start": In(1),
            "shape": In(LayerShape()),
            "requant_base": In((config.requant_depth - 1).bit_length()),
            "finished": In(1),
            "info": In(GroupInfo(config)),
            "heads": In(chains),
            "shift": Out(1),
            "credit": Out(1),
            "write_en": In(1),
            "write": In(RequantWrite(config)),
            "o": Out(stream.Signature(PixelWord(config.output_word_channels * config.output.bits))),
            **({
                "takes": In(1),
                "gives": In(1),
                "addends": In(stream.Signature(sum_layout(config))),
                "results": Out(stream.Signature(SumWord(config))),
                "last": Out(1),
            } if config.partial_sum_c_in else {}),
        })  # fmt: skip

    def elaborate(self, platform):
        config = self._config
        m = Module()
        cycles = config.drain_cycles
        index_bits = (cycles - 1).bit_length()

        # ---- when to drain ------------------------------------------------------------------------------
        pending, busy, section = Signal(), Signal(), Signal(range(SECTIONS))
        occupied, filled = Signal(SECTIONS), Signal(SECTIONS)
        # Carried lanes take two rounds; the top bit tells them apart.
        index = Signal(index_bits + 1)
        waiting, current, info = (
            Signal(GroupInfo(config), name=n) for n in ("waiting", "current", "info_now")
        )
        begin, active, last_cycle, credit = Signal(), Signal(), Signal(), Signal()
        group_start, free, round_last, group_last_cycle = Signal(), Signal(), Signal(), Signal()
        m.d.comb += [
            group_start.eq((waiting.tile == 0) & ~waiting.inner & ~waiting.unloaded),
            free.eq(~group_start | ~occupied.bit_select(section, 1)),
            info.eq(Mux(busy, current, waiting)),
            round_last.eq(index[-1] | ~info.unloaded),
            last_cycle.eq(active & (index[:-1] == cycles - 1) & round_last),
            group_last_cycle.eq(last_cycle & info.tile_last & (info.unloaded | ~info.triple)),
            credit.eq(active & (index[:-1] == self.credit_at) & round_last),
            self.shift.eq(active),
        ]
        if config.partial_sum_c_in:
            can, gives = Signal(), self.gives
            last = (index == cycles - 1) & info.tile_last & info.image_last
            summed = self._partial_sums(m, can, active, last)
            m.d.comb += [
                can.eq(busy | (pending & free)),
                begin.eq(active & ~busy),
                self.credit.eq(Mux(self.takes | gives, last_cycle, credit)),
            ]
        else:
            gives, summed = Const(0), self.heads
            m.d.comb += [
                begin.eq(pending & ~busy & free),
                active.eq(busy | begin),
                self.credit.eq(credit),
            ]
        with m.If(self.finished):
            m.d.sync += [pending.eq(1), waiting.eq(self.info)]
        with m.Elif(begin):
            m.d.sync += pending.eq(0)
        with m.If(active):
            m.d.sync += [busy.eq(~last_cycle), index.eq(Mux(last_cycle, 0, index + 1))]
        with m.If(begin):
            m.d.sync += current.eq(waiting)
            with m.If(group_start & ~gives):
                m.d.sync += occupied.bit_select(section, 1).eq(1)
        with m.If(group_last_cycle):
            m.d.sync += section.eq(section + 1)

        # ---- requantise ---------------------------------------------------------------------------------
        m.submodules.parameters = parameters = memory.Memory(
            shape=config.requant_word_bits,
            depth=config.requant_depth,
            init=[],
            attrs={"macram.init_file": "requant.mem", "macram.style": config.requant_ram},
        )
        read, reload = parameters.read_port(), parameters.write_port()
        m.submodules.requant = requant = Requantiser(config)
        heads = Signal.like(summed, name="heads", reset_less=True)
        # Which round of a triple: its first pixel lies in that slot, the second one beside it in slot 3, 0, 3.
        turn, tile = Signal(2), Signal.like(info.tile)
        m.d.comb += [
            turn.eq(Mux(info.unloaded, 1 + index[-1], 0)),
            tile.eq(info.tile + turn),
            reload.addr.eq(self.write.addr),
            reload.data.eq(self.write.data),
            reload.en.eq(self.write_en),
            read.addr.eq(Cat(index[:-1], tile) + self.requant_base),
            requant.parameters.eq(read.data),
            requant.accumulators.eq(heads),
        ]
        m.d.sync += [heads.eq(summed), requant.edge.eq(info.edge)]
        with m.If(info.unloaded):
            for head, chain in zip(heads, self.heads, strict=True):
                m.d.sync += head[0].eq(Mux(index[-1], chain[2], chain[1]))
                with m.If(~index[-1]):
                    m.d.sync += head[GROUP - 1].eq(chain[0])

        # ---- output buffer: written 4 pixels at a time, read one ----------------------------------------
        write_bits = GROUP * config.drain * config.output.bits
        words_per_section = config.max_c_out // config.output_word_channels
        word_bits = (words_per_section - 1).bit_length()
        m.submodules.buffer = buffer = memory.Memory(
            shape=GROUP * write_bits, depth=SECTIONS << word_bits, init=[]
        )
        put = buffer.write_port(granularity=write_bits)
        get = buffer.read_port()
        delay = 1 + Requantiser.LATENCY
        address = Cat(index[2:-1], tile)[:word_bits] if word_bits else Signal(0)
        at = [
            Cat(address, section),
            index[:2],
            active,
            group_last_cycle & ~gives,
            info.slots,
            info.image_last,
            Cat(index[:-1], turn),
            info.triple,
            info.inner,
        ]
        for _ in range(delay):
            stage = [Signal(len(value), reset_less=i not in (2, 3)) for i, value in enumerate(at)]
            m.d.sync += [register.eq(value) for register, value in zip(stage, at, strict=True)]
            at = stage
        put_address, put_lane, put_en, group_complete, put_slots, put_image_last, place, triple, inner = at

        # ---- codes of a triple's outer two pixels wait for the inner two, and are put together with them -
        lane_bits = config.drain * config.output.bits
        m.submodules.outer = outer = memory.Memory(shape=2 * lane_bits, depth=TAPS << index_bits, init=[])
        keep, kept = outer.write_port(), outer.read_port(domain="comb")
        codes = [requant.codes[slot * lane_bits : (slot + 1) * lane_bits] for slot in range(GROUP)]
        outer_left, outer_right = kept.data[:lane_bits], kept.data[lane_bits:]
        pixels = Signal(GROUP * lane_bits)
        m.d.comb += [
            keep.addr.eq(place),
            keep.data.eq(Cat(codes[0], codes[-1])),
            keep.en.eq(put_en & triple & ~inner),
            kept.addr.eq(place),
            pixels.eq(Mux(triple, Cat(outer_left, codes[0], codes[-1], outer_right), requant.codes)),
            put.addr.eq(put_address),
            put.data.eq(pixels.replicate(GROUP)),
            put.en.eq(Mux(put_en, 1 << put_lane, 0)),
        ]

        # ---- read in pixel order ------------------------------------------------------------------------
        slots = Array(Signal(GROUP, name=f"slots{s}") for s in range(SECTIONS))
        image_last = Signal(SECTIONS)
        out_section, slot, word = Signal(range(SECTIONS)), Signal(range(GROUP)), Signal(12)
        todo = Signal(GROUP)
        word_last, pixel_after, advance, fetch, section_done = (
            Signal(name=n) for n in ("word_last", "pixel_after", "advance", "fetch", "section_done")
        )
        valid = Signal()
        meta = Signal(PixelWord(1))
        slot_read = Signal(range(GROUP))
        m.d.comb += [
            todo.eq(slots[out_section] >> slot),
            word_last.eq(word + 1 == self.shape.output_words),
            pixel_after.eq(todo[1:].any()),
            advance.eq(~valid | self.o.ready),
            fetch.eq(filled.bit_select(out_section, 1) & advance),
            section_done.eq(fetch & (word_last | ~todo[0]) & ~pixel_after),
            get.addr.eq(Cat(word[:word_bits], out_section)),
            get.en.eq(advance),
        ]
        with m.If(advance):
            m.d.sync += [
                valid.eq(fetch & todo[0]),
                slot_read.eq(slot),
                meta.pixel_last.eq(word_last),
                meta.last.eq(image_last.bit_select(out_section, 1) & ~pixel_after),
            ]
        with m.If(fetch):
            with m.If(~todo[0] | word_last):
                m.d.sync += [word.eq(0), slot.eq(slot + 1)]
            with m.Else():
                m.d.sync += word.eq(word + 1)
        with m.If(section_done):
            m.d.sync += [
                slot.eq(0), word.eq(0), out_section.eq(out_section + 1),
                filled.bit_select(out_section, 1).eq(0), occupied.bit_select(out_section, 1).eq(0),
            ]  # fmt: skip
        with m.If(group_complete):
            filled_section = put_address[word_bits:]
            m.d.sync += [
                filled.bit_select(filled_section, 1).eq(1),
                image_last.bit_select(filled_section, 1).eq(put_image_last),
                slots[filled_section].eq(put_slots),
            ]

        # A memory word is [drain cycle mod 4][slot][channel]; a pixel's word takes its slot out of all four.
        with m.Switch(slot_read):
            for s in range(GROUP):
                with m.Case(s):
                    parts = [
                        get.data[d * write_bits + s * lane_bits : d * write_bits + (s + 1) * lane_bits]
                        for d in range(GROUP)
                    ]
                    m.d.comb += self.o.payload.data.eq(Cat(*parts))
        m.d.comb += [
            self.o.valid.eq(valid),
            self.o.payload.pixel_last.eq(meta.pixel_last),
            self.o.payload.last.eq(meta.last),
        ]
        with m.If(self.start):
            m.d.sync += [pending.eq(0), busy.eq(0), index.eq(0), occupied.eq(0), filled.eq(0), valid.eq(0)]
            m.d.sync += [section.eq(0), out_section.eq(0), slot.eq(0), word.eq(0)]
        return m

    def _partial_sums(self, m, can, active, last):
        """The heads with what is added to them; ``active`` where all streams of the run that ``can`` go on do so."""
        summed = Signal(sum_layout(self._config))
        for channel, sums in enumerate(summed):
            m.d.comb += [
                value.eq(self.heads[channel][slot] + self.addends.payload[channel][slot])
                for slot, value in enumerate(sums)
            ]
        m.d.comb += [
            active.eq(can & (self.addends.valid | ~self.takes) & (self.results.ready | ~self.gives)),
            self.addends.ready.eq(can & self.takes & (self.results.ready | ~self.gives)),
            self.results.valid.eq(can & self.gives & (self.addends.valid | ~self.takes)),
            self.results.payload.sums.eq(summed),
            self.results.payload.last.eq(self.last),
            self.last.eq(last),
        ]
        return summed
