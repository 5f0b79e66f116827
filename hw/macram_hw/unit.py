"""A PIM unit: a weight memory, row engines beside it, lane sums, accumulators."""

from amaranth.hdl import Cat, Module, Mux, Signal, Value, signed
from amaranth.lib import data, memory, wiring
from amaranth.lib.wiring import In, Out

from macram.spec import ENGINE_LATENCY, GROUP, LANES, TAPS, ArrayConfig
from macram_hw.add3 import Add3, sum_to_two
from macram_hw.engine import hdl_shape, make_engine
from macram_hw.engine_2x import PairedEngine, pixels_2x

__all__ = [
    "AccumulateControl", "PimUnit", "UnitCore", "WeightWrite", "control_delay", "unit_latency", "unit_signature",
]  # fmt: skip


class AccumulateControl(data.StructLayout):
    """What the accumulators do with the lane sums of this cycle.

    Fields:
        en: add the lane sums.
        first: start from 0 instead of from the running sums, lanes 0 and 1 from what ``carried`` says.
        carried: lanes 0 and 1 start from the carried lanes of this tile.
        last: the sums are complete: move pixels to the result registers, keep lanes 4 and 5 as carry.
        edge: first group of a row. Column -1 does not exist: lane 0 is ignored, and the result's slot 0 is
            the last column of the previous row, which only waited in the carry.
        tile: output-channel tile, selects the carry.
        unload: nothing is added; the carried lanes of this tile go to result slots 0 and 3. Never with ``en``, and
            only with ``carried``.
    """

    def __init__(self, config: ArrayConfig):
        super().__init__({
            "en": 1, "first": 1, "carried": 1, "last": 1, "edge": 1,
            "tile": max(1, (config.max_tiles - 1).bit_length()), "unload": 1,
        })  # fmt: skip


class WeightWrite(data.StructLayout):
    """A write to a weight memory."""

    def __init__(self, config: ArrayConfig):
        super().__init__({"addr": (config.weight_depth - 1).bit_length(), "data": config.weight_word_bits})


def _datapath_members(config: ArrayConfig) -> dict:
    results = data.ArrayLayout(hdl_shape(config.accumulator), GROUP)
    paired = {"pixels_2x": In(pixels_2x(config)), "second": In(1)} if config.paired_rows else {}
    return {
        "activations": In(config.line_word_bits),
        **paired,
        "control": In(AccumulateControl(config)),
        "shift": In(1),
        "chain_i": In(results),
        "chain_o": Out(results),
    }


def unit_signature(config: ArrayConfig) -> wiring.Signature:
    """Ports of `UnitCore`."""
    return wiring.Signature({"weight": In(config.weight_word_bits), **_datapath_members(config)})


def control_delay(config: ArrayConfig) -> int:
    """Cycles from activations to their lane sums, which is when a unit wants the control that goes with them."""
    return config.engine_latency


def unit_latency(config: ArrayConfig) -> int:
    """Cycles from activations to the result register: lane sums, sums over the row engines, accumulators."""
    return control_delay(config) + 2


class UnitCore(wiring.Component):
    """The arithmetic of a unit: ``rows`` row engines, adders over them per lane, accumulators, a result register.

    Latency from ``activations`` to ``chain_o`` is `unit_latency` cycles, throughput one step per cycle. It never
    stalls by itself: whoever sends ``last`` must know that the result register will have been shifted out.

    Members:
        weight: In, one weight word, one cycle before the activations it belongs to.
        activations: In, 4 pixels x ``rows`` channels, pixel-major.
        pixels_2x, second: In, the paired rows' activations and phase as from `Interleaver` for the same word; only
            if there are paired rows, whose share of ``activations`` is not used then.
        control: In, `AccumulateControl`, `control_delay` cycles after the activations it belongs to.
        shift: In, load the result register from ``chain_i``.
        chain_i, chain_o: the result register's neighbours; 4 accumulators, lane 0 first.
    """

    def __init__(self, config: ArrayConfig):
        self._config = config
        super().__init__(unit_signature(config))

    def elaborate(self, platform):
        config = self._config
        acc = hdl_shape(config.accumulator)
        m = Module()

        weight = Signal(config.weight_word_bits, reset_less=True)
        m.d.sync += weight.eq(self.weight)

        engines = self._engines(m, weight)
        # Column -1 does not exist: in the first group of a row lane 0 adds nothing.
        early, control = self.control, Signal(AccumulateControl(config))
        m.d.sync += control.eq(early)
        addends = [self._lane_sum(m, engines, k, early.edge if k == 0 else None) for k in range(LANES)]

        # The running sums are 0 at the first step of a sum, where lanes 0 and 1 may start from what was carried. At
        # every other step the carry memory is read at a word that is always 0: that saves a multiplexer per bit.
        done = Signal()
        m.d.comb += done.eq(control.en & control.last)
        totals, kept, stored = [], [], []
        for k, (terms, carries) in enumerate(addends):
            running = Signal(acc, name=f"acc{k}")
            m.submodules[f"accumulate{k}"] = adder = Add3(acc.width, xilinx=config.xilinx)
            m.d.comb += [
                adder.a.eq(running),
                *(port.eq(term) for port, term in zip((adder.b, adder.c), terms, strict=False)),
                *(port.eq(bit) for port, bit in zip((adder.x, adder.ci), carries, strict=False)),
            ]
            # Cleared ahead of each first step, not behind the last: a soft reset leaves a sum unfinished, and it does
            # not reach the unit.
            with m.If(early.en & early.first):
                m.d.sync += running.eq(0)
            with m.Elif(control.en):
                m.d.sync += running.eq(adder.total)
            totals.append(adder.total)
            if k < LANES - GROUP:
                carried = memory.Memory(shape=acc, depth=config.max_tiles + 1, init=[])
                m.submodules[f"carry{k}"] = carried
                read, write = carried.read_port(domain="comb"), carried.write_port()
                used = control.carried & ~control.edge if k == 1 else control.carried
                m.d.comb += [
                    read.addr.eq(Mux(used, control.tile, config.max_tiles)),
                    adder.d.eq(read.data),
                    write.addr.eq(control.tile),
                    write.en.eq(done),
                ]
                kept.append(write)
                stored.append(read.data)
        m.d.comb += [write.data.eq(total) for write, total in zip(kept, totals[GROUP:], strict=True)]

        result = Signal(data.ArrayLayout(acc, GROUP), reset_less=True)
        # One enable and one selection: written as two conditions it takes a second LUT per bit.
        with m.If(done | self.shift):
            m.d.sync += [result[slot].eq(Mux(done, totals[slot], self.chain_i[slot])) for slot in (1, 2)]
        with m.If(done | self.shift | control.unload):
            m.d.sync += [
                result[slot].eq(Mux(done, totals[slot], Mux(control.unload, value, self.chain_i[slot])))
                for slot, value in zip((0, GROUP - 1), stored, strict=True)
            ]
        m.d.comb += self.chain_o.eq(result)
        return m

    def _engines(self, m: Module, weight: Value) -> list:
        """The row engines; the faster kinds of a mixed unit wait for their operands."""
        config = self._config
        tap_bits, act_bits = TAPS * config.weight.bits, config.input.bits
        engines = self._paired_engines(m, weight)
        for row, kind in list(enumerate(config.row_kinds))[config.paired_rows :]:
            m.submodules[f"engine{row}"] = engine = make_engine(kind, config)
            engines.append(engine)
            starts = [(pixel * config.rows + row) * act_bits for pixel in range(GROUP)]
            operands = Cat(
                weight[row * tap_bits : (row + 1) * tap_bits],
                *(self.activations[at : at + act_bits] for at in starts),
            )
            for stage in range(config.engine_latency - ENGINE_LATENCY[kind]):
                # A reset keeps these chains in flip-flops: as shift registers they would cost LUTs.
                delayed = Signal(len(operands), name=f"operands{row}_{stage}")
                m.d.sync += delayed.eq(operands)
                operands = delayed
            m.d.comb += Cat(engine.taps, engine.pixels).eq(operands)
        return engines

    def _paired_engines(self, m: Module, weight: Value) -> list:
        """Sums of the even and of the odd rows of each `PairedEngine`."""
        config = self._config
        tap_bits, most = TAPS * config.weight.bits, 2 * PairedEngine.PAIRS
        sums = []
        for first in range(0, config.paired_rows, most):
            rows = min(config.paired_rows - first, most)
            m.submodules[f"paired{first}"] = engine = PairedEngine(config, rows // 2)
            m.d.comb += [
                engine.taps.eq(weight[first * tap_bits : (first + rows) * tap_bits]),
                engine.second.eq(self.second),
                *(engine.pixels[pair].eq(self.pixels_2x[first // 2 + pair]) for pair in range(rows // 2)),
            ]
            sums += engine.members
        return sums

    def _lane_sum(self, m: Module, engines: list, lane: int, clear: Value | None) -> tuple[list, list]:
        """Lane ``lane`` over all row engines in registers, 0 after ``clear``: two operands and two carries to add."""
        carries = [engine.carries[lane] for engine in engines if lane in engine.CARRIES]
        operands, carries = sum_to_two(
            m,
            f"lane{lane}",
            [engine.operand(lane) for engine in engines],
            carries,
            xilinx=self._config.xilinx,
        )
        held = [Signal(signed(operand.bits), name=f"sum{lane}_{i}") for i, operand in enumerate(operands)]
        bits = [Signal(name=f"carry{lane}_{i}") for i in range(len(carries))]
        m.d.sync += [register.eq(operand.value) for register, operand in zip(held, operands, strict=True)]
        m.d.sync += [register.eq(bit) for register, bit in zip(bits, carries, strict=True)]
        if clear is not None:
            with m.If(clear):
                m.d.sync += [register.eq(0) for register in (*held, *bits)]
        return held, bits


class PimUnit(wiring.Component):
    """A weight memory with a `UnitCore` beside it, so that a weight travels no further than one word line.

    Members as `UnitCore`, but the weight word comes from ``address``, one cycle before the line-buffer word,
    and ``write_en``/``write`` reload the memory.
    """

    def __init__(self, config: ArrayConfig, *, index: int, init: list[int] | None = None):
        self._config = config
        self._init = init or []
        self._index = index
        super().__init__({
            "address": In((config.weight_depth - 1).bit_length()),
            "write_en": In(1),
            "write": In(WeightWrite(config)),
            **_datapath_members(config),
        })  # fmt: skip

    def elaborate(self, platform):
        config = self._config
        m = Module()
        m.submodules.weights = weights = memory.Memory(
            shape=config.weight_word_bits,
            depth=config.weight_depth,
            init=self._init,
            attrs={"macram.init_file": f"unit_{self._index:03d}.mem"},
        )
        read, write = weights.read_port(), weights.write_port()
        m.d.comb += [
            read.addr.eq(self.address),
            write.addr.eq(self.write.addr),
            write.data.eq(self.write.data),
            write.en.eq(self.write_en),
        ]
        if hasattr(platform, "unit_instance"):
            # The export instantiates one shared Verilog module; elsewhere the core is elaborated in place.
            core = unit_signature(config).create(path=("core",))
            m.submodules.core = platform.unit_instance(core)
        else:
            m.submodules.core = core = UnitCore(config)
        m.d.comb += [
            core.weight.eq(read.data),
            core.activations.eq(self.activations),
            core.control.eq(self.control),
            *(
                getattr(core, name).eq(getattr(self, name))
                for name in ("pixels_2x", "second")
                if config.paired_rows
            ),
            core.shift.eq(self.shift),
            core.chain_i.eq(self.chain_i),
            self.chain_o.eq(core.chain_o),
        ]
        return m
