"""The array: line buffer, sequencer, 64 units, drain, loader and counters, without the AXI edge."""

from amaranth.hdl import Cat, Const, Module, Mux, Signal
from amaranth.lib import stream, wiring
from amaranth.lib.wiring import In, Out, connect

from macram.spec import ArrayConfig, Error
from macram.spec.registers import MODE_SUMS_IN, MODE_SUMS_OUT
from macram_hw.drain import Drain
from macram_hw.engine_2x import Interleaver
from macram_hw.frame import FrameCheck
from macram_hw.gearbox import Beat, EmitGearbox, IngestGearbox
from macram_hw.line_buffer import LineBuffer
from macram_hw.loader import Loader
from macram_hw.partial import PartialSums
from macram_hw.residual import ResidualPath
from macram_hw.sequencer import Sequencer
from macram_hw.shape import LayerShape, ShapeDecoder
from macram_hw.unit import PimUnit, control_delay

__all__ = ["COUNTERS", "RESIDUAL_REGISTERS", "Array"]

_SETTINGS = (
    "height", "width", "c_in", "c_out", "mode", "weight_base", "requant_base", "words", "param_base",
)  # fmt: skip
RESIDUAL_REGISTERS = ("residual_table0", "residual_table1", "residual_bounds0", "residual_bounds1")
COUNTERS = ("cycles", "mac_cycles", "fill_cycles", "input_stalls", "output_stalls", "drain_cycles")


class Array(wiring.Component):
    """The PIM array between three streams, commanded by strobes.

    From START, `ShapeDecoder.LATENCY` + 1 cycles pass before the first input beat is accepted. The
    figures of a run
    without stalls are in `macram.perf`.

    Members:
        height, width, c_in, c_out, mode, weight_base, requant_base: In, from the registers; they must not change
            while busy.
        words, param_base: In, from the registers; they must not change while loading.
        command: In, strobes as in `macram.spec.Control`, without the soft reset. A load may run beside an image,
            into words that the image's layer does not use. A command that is not possible changes nothing
            but ``error``.
        busy: Out, an image is being run. loading: Out, a load is under way. done: Out, the image is complete.
        error: Out. The first error is kept until the next command that finds the array idle.
        cycles ... drain_cycles: Out, counters of the last run, see the register map.
        i, params: In streams, `Beat`. o: Out stream, `Beat`.
        residual, sums: In and Out streams, `Beat`, and residual_table0 ... residual_bounds1: In, from the registers;
            only with a residual adder.
    """

    def __init__(self, config: ArrayConfig):
        self._config = config
        beat = Beat(config.stream_bits)
        adder = {}
        if config.residual_stream_bits:
            wide = stream.Signature(Beat(config.residual_stream_bits))
            adder = {"residual": In(wide), "sums": Out(wide), **{name: In(32) for name in RESIDUAL_REGISTERS}}
        super().__init__({
            **{name: In(32) for name in _SETTINGS},
            "command": In(3),
            "busy": Out(1),
            "loading": Out(1),
            "done": Out(1),
            "error": Out(Error, init=Error.NONE),
            **{name: Out(32) for name in COUNTERS},
            "i": In(stream.Signature(beat)),
            "params": In(stream.Signature(beat)),
            "o": Out(stream.Signature(beat)),
            **adder,
        })  # fmt: skip

    def elaborate(self, platform):
        config = self._config
        m = Module()
        m.submodules.decoder = decoder = ShapeDecoder(config)
        m.submodules.frame = frame = FrameCheck(beat_bits=config.stream_bits)
        m.submodules.ingest = ingest = IngestGearbox(
            beat_bits=config.stream_bits, word_bits=config.ingest * config.block_bits
        )
        m.submodules.lines = lines = LineBuffer(config)
        m.submodules.sequencer = sequencer = Sequencer(config)
        m.submodules.drain = drain = Drain(config)
        m.submodules.emit = emit = EmitGearbox(
            word_bits=config.output_word_channels * config.output.bits, beat_bits=config.stream_bits
        )
        m.submodules.loader = loader = Loader(config)

        start = Signal()
        shape = Signal(LayerShape())
        watched = [frame, loader]
        if config.residual_stream_bits:
            m.submodules.path = path = self._residual_path(m, start, shape)
            watched.append(path)
            connect(m, drain.o, path.i)
            connect(m, path.o, emit.i)
        else:
            connect(m, drain.o, emit.i)
        if config.partial_sum_c_in:
            m.submodules.partial = partial = self._partial_sums(m, start, drain)
            watched.append(partial)
            connect(m, wiring.flipped(self.params), partial.params)
            connect(m, partial.loads, loader.i)
            connect(m, emit.o, partial.codes)
            connect(m, partial.o, wiring.flipped(self.o))
        else:
            connect(m, wiring.flipped(self.params), loader.i)
            connect(m, emit.o, wiring.flipped(self.o))
        last_beat = self._last_beat(m, start, shape)
        self._control(m, decoder, frame, loader, watched, start, last_beat)
        m.d.comb += shape.eq(decoder.shape)

        # ---- image path ---------------------------------------------------------------------------------
        connect(m, wiring.flipped(self.i), frame.i)
        connect(m, frame.o, ingest.i)
        connect(m, ingest.o, lines.i)
        m.d.comb += [
            *(block.shape.eq(shape) for block in (lines, sequencer, drain)),
            frame.beats.eq(shape.beats_in),
            frame.width.eq(shape.width),
            frame.height.eq(shape.height),
            *(block.start.eq(start) for block in (frame, lines, sequencer, drain)),
            ingest.beats_per_pixel.eq(shape.beats_in),
            ingest.words_per_pixel.eq(shape.ingest_words),
            emit.beats_per_pixel.eq(shape.beats_out),
            lines.retire.eq(sequencer.retire),
            lines.retire_row.eq(sequencer.retire_row),
            sequencer.weight_base.eq(self.weight_base),
            drain.requant_base.eq(self.requant_base),
            lines.read.eq(sequencer.step.read),
            sequencer.group_written.eq(lines.group_written),
            sequencer.image_written.eq(lines.image_written),
            sequencer.credit.eq(drain.credit),
            drain.write_en.eq(loader.requant_en),
            drain.write.eq(loader.requant),
        ]

        # ---- the step's control follows it to the accumulators -------------------------------------------
        control, info = sequencer.step.control, sequencer.step.info
        for stage in range(LineBuffer.LATENCY + control_delay(config) + 1):
            # The units hold the last stage themselves.
            unit_control = control
            control_next = Signal.like(control, name=f"control{stage}")
            info_next = Signal.like(info, name=f"info{stage}", reset_less=True)
            m.d.sync += [control_next.eq(control), info_next.eq(info)]
            control, info = control_next, info_next
        m.d.comb += [drain.finished.eq((control.en & control.last) | control.unload), drain.info.eq(info)]

        # ---- units, chained in rings; ring q brings channels q, q + drain, ... to its head ---------------
        if config.paired_rows:
            m.submodules.interleaver = interleaver = Interleaver(config)
            m.d.comb += interleaver.word.eq(lines.word)
        units = [PimUnit(config, index=index) for index in range(config.units)]
        for index, unit in enumerate(units):
            m.submodules[f"unit{index:03d}"] = unit
            m.d.comb += [
                unit.address.eq(sequencer.step.weight),
                unit.write_en.eq(loader.unit_en[index]),
                unit.write.eq(loader.weight),
                unit.activations.eq(lines.word),
                unit.control.eq(unit_control),
                unit.shift.eq(drain.shift),
            ]
            if config.paired_rows:
                m.d.comb += [unit.pixels_2x.eq(interleaver.pixels), unit.second.eq(interleaver.second)]
            if index < config.drain:
                m.d.comb += drain.heads[index].eq(unit.chain_o)
            m.d.comb += unit.chain_i.eq(units[(index + config.drain) % config.units].chain_o)

        self._counters(m, start, sequencer, last_beat)
        return m

    def _residual_path(self, m, start, shape):
        """The adder between drain and output, with its streams and registers."""
        path = ResidualPath(self._config)
        connect(m, wiring.flipped(self.residual), path.residual)
        connect(m, path.sums, wiring.flipped(self.sums))
        table, bounds = path.tables.table.as_value(), path.tables.bounds.as_value()
        m.d.comb += [
            path.start.eq(start),
            path.shape.eq(shape),
            table.eq(Cat(self.residual_table0, self.residual_table1)),
            bounds.eq(Cat(self.residual_bounds0, self.residual_bounds1)),
        ]
        return path

    def _partial_sums(self, m, start, drain):
        """The way of partial sums between the streams and the drain."""
        partial = PartialSums(self._config)
        connect(m, partial.addends, drain.addends)
        connect(m, drain.results, partial.results)
        takes, gives = self.mode[MODE_SUMS_IN], self.mode[MODE_SUMS_OUT]
        m.d.comb += [
            partial.start.eq(start),
            partial.last.eq(drain.last),
            *(block.takes.eq(takes) for block in (partial, drain)),
            *(block.gives.eq(gives) for block in (partial, drain)),
        ]
        return partial

    def _last_beat(self, m, start, shape):
        """Strobe: the last beat of the image leaves, on whichever output is the last to be done."""
        outputs = [(self.o, 1)]
        if self._config.residual_stream_bits:
            outputs.append((self.sums, shape.residual))
        leaving, gone = [], []
        for index, (port, used) in enumerate(outputs):
            beat, before = Signal(name=f"last_beat{index}"), Signal(name=f"last_beat_gone{index}")
            m.d.comb += beat.eq(port.valid & port.ready & port.payload.last)
            with m.If(start):
                m.d.sync += before.eq(~used)
            with m.Elif(beat):
                m.d.sync += before.eq(1)
            leaving.append(beat)
            gone.append(beat | before)
        last_beat = Signal()
        m.d.comb += last_beat.eq(Cat(*leaving).any() & Cat(*gone).all())
        return last_beat

    def _control(self, m, decoder, frame, loader, watched, start, last_beat):
        """Commands, what they may not do, and how a run ends."""
        config = self._config
        for name in ("height", "width", "c_in", "c_out", "mode", "weight_base", "requant_base"):
            m.d.comb += getattr(decoder, name).eq(getattr(self, name))
        wait = Signal(range(decoder.LATENCY + 1))
        running = Signal()
        m.d.comb += [
            loader.words.eq(self.words),
            loader.base.eq(self.param_base),
            self.busy.eq(running | (wait != 0)),
            self.loading.eq(loader.busy),
        ]

        # ---- the words of a load against the memory and against the words of the layer -------------------
        start_command, load_weights, load_requant = self.command
        to_requant, load_end = Signal(), Signal(33)
        beyond, overlaps = Signal(), Signal()
        m.d.comb += [
            to_requant.eq(Mux(loader.busy, loader.to_requant, load_requant)),
            load_end.eq(self.param_base + self.words),
            beyond.eq(load_end > Mux(to_requant, config.requant_depth, config.weight_depth)),
            overlaps.eq(
                (self.param_base < Mux(to_requant, decoder.requant_end, decoder.weight_end))
                & (load_end > Mux(to_requant, self.requant_base, self.weight_base))
            ),
        ]

        # ---- commands ------------------------------------------------------------------------------------
        # A run that starts from partial sums has the parameter stream to itself.
        takes = self.mode[MODE_SUMS_IN] if config.partial_sum_c_in else Const(0)
        commanded, idle = Signal(), Signal()
        refusal, verdict = Signal(Error, init=Error.NONE), Signal(Error, init=Error.NONE)
        m.d.comb += [commanded.eq(self.command.any()), idle.eq(~self.busy & ~self.loading)]
        with m.If((self.command & (self.command - 1)).any()):
            m.d.comb += refusal.eq(Error.BAD_COMMAND)
        with m.Elif(start_command):
            with m.If(self.busy):
                m.d.comb += refusal.eq(Error.BAD_COMMAND)
            with m.Else():
                m.d.sync += [wait.eq(decoder.LATENCY), self.done.eq(0)]
        with m.Elif(commanded):
            with m.If(self.loading | (self.busy & takes)):
                m.d.comb += refusal.eq(Error.BAD_COMMAND)
            with m.Elif((self.words == 0) | beyond | (self.busy & overlaps)):
                m.d.comb += refusal.eq(Error.BAD_RANGE)
            with m.Else():
                m.d.comb += [loader.start_weights.eq(load_weights), loader.start_requant.eq(load_requant)]
        with m.If(wait != 0):
            m.d.sync += wait.eq(wait - 1)
        with m.If(wait == 1):
            with m.If((decoder.error == Error.NONE) & self.loading & (overlaps | takes)):
                m.d.comb += verdict.eq(Error.BAD_RANGE)
            with m.Else():
                m.d.comb += verdict.eq(decoder.error)
            m.d.comb += start.eq(verdict == Error.NONE)
            m.d.sync += running.eq(start)
        # A 1x1 kernel with stride 2 may be through before the last input row, which it does not need, is.
        delivered = Signal()
        with m.If(last_beat):
            m.d.sync += delivered.eq(1)
        with m.If(running & delivered & ~frame.open):
            m.d.sync += [running.eq(0), self.done.eq(1), delivered.eq(0)]

        # ---- the first error -----------------------------------------------------------------------------
        with m.If(commanded & idle):
            m.d.sync += [self.done.eq(0), self.error.eq(refusal)]
        with m.Elif(self.error == Error.NONE):
            with m.If(refusal != Error.NONE):
                m.d.sync += self.error.eq(refusal)
            with m.Elif(verdict != Error.NONE):
                m.d.sync += self.error.eq(verdict)
            for block in watched:
                with m.Elif(block.fault):
                    m.d.sync += self.error.eq(block.error)

    def _counters(self, m, start, sequencer, last_beat):
        """Count every cycle from the first accepted input beat to the last output beat under one cause."""
        seen, issued, ended = Signal(), Signal(), Signal()
        counting, first_beat = Signal(), Signal()
        m.d.comb += [
            first_beat.eq(self.i.valid & self.i.ready),
            counting.eq((first_beat | seen) & ~ended),
        ]
        with m.If(first_beat):
            m.d.sync += seen.eq(1)
        with m.If(sequencer.issue):
            m.d.sync += issued.eq(1)
        with m.If(last_beat):
            m.d.sync += ended.eq(1)
        with m.If(counting):
            m.d.sync += self.cycles.eq(self.cycles + 1)
            with m.If(sequencer.issue):
                m.d.sync += self.mac_cycles.eq(self.mac_cycles + 1)
            with m.Elif(~issued):
                m.d.sync += self.fill_cycles.eq(self.fill_cycles + 1)
            with m.Elif(sequencer.starved):
                m.d.sync += self.input_stalls.eq(self.input_stalls + 1)
            with m.Elif(sequencer.blocked & ~sequencer.flushing):
                m.d.sync += self.output_stalls.eq(self.output_stalls + 1)
            with m.Else():
                m.d.sync += self.drain_cycles.eq(self.drain_cycles + 1)
        with m.If(start):
            m.d.sync += [seen.eq(0), issued.eq(0), ended.eq(0)]
            m.d.sync += [getattr(self, name).eq(0) for name in COUNTERS]
