"""A PIM unit: a weight memory, row engines beside it, lane sums, accumulators."""

from amaranth.hdl import Module, Mux, Signal
from amaranth.lib import data, memory, wiring
from amaranth.lib.wiring import In, Out

from macram.spec import GROUP, LANES, TAPS, ArrayConfig
from macram_hw.engine import add_with_carry, adder_tree, hdl_shape, lane_shape, make_engine
from macram_hw.engine_2x import PairedEngine, pixels_2x

__all__ = [
    "AccumulateControl", "PimUnit", "UnitCore", "WeightWrite", "control_delay", "unit_latency", "unit_signature",
]  # fmt: skip


class AccumulateControl(data.StructLayout):
    """What the accumulators do with the lane sums of this cycle.

    Fields:
        en: add the lane sums.
        first: start from the carried lanes of this tile instead of from the running sums.
        last: the sums are complete: move pixels to the result registers, keep lanes 4 and 5 as carry.
        edge: first group of a row. Column -1 does not exist: lane 0 is ignored, and the result's slot 0 is
            the last column of the previous row, which only waited in the carry.
        tile: output-channel tile, selects the carry.
    """

    def __init__(self, config: ArrayConfig):
        super().__init__({
            "en": 1, "first": 1, "last": 1, "edge": 1, "tile": max(1, (config.max_tiles - 1).bit_length()),
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
    """Cycles from activations to lane sums added over the row engines."""
    return config.engine_latency + 1


def unit_latency(config: ArrayConfig) -> int:
    """Cycles from activations to the result register."""
    return control_delay(config) + 1


class UnitCore(wiring.Component):
    """The arithmetic of a unit: ``rows`` row engines, a 6-lane adder tree, accumulators, a result register.

    Latency from ``activations`` to ``chain_o`` is `unit_latency` cycles, throughput one step per cycle. It never
    stalls by itself: whoever sends ``last`` must know that the result register will have been shifted out.

    Members:
        weight: In, one weight word, one cycle before the activations it belongs to.
        activations: In, 4 pixels x ``rows`` channels, pixel-major.
        pixels_2x, second: In, the paired rows' activations and phase as from `Interleaver` for the same word; only
            if there are paired rows, whose share of ``activations`` is not used then.
        control: In, `AccumulateControl`, `control_delay` cycles after the activations it belongs to.
        shift: In, load the result register from ``chain_i``.
        chain_i, chain_o: the result register's neighbours; 4 accumulators, output column ``4 g - 1`` first.
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

        tap_bits, act_bits = TAPS * config.weight.bits, config.input.bits
        # Addends of each lane, and the bits to be added to them.
        lanes: list[list] = [[] for _ in range(LANES)]
        carries: list[list] = [[] for _ in range(LANES)]
        for first in range(0, config.paired_rows, 2 * PairedEngine.PAIRS):
            rows = min(config.paired_rows - first, 2 * PairedEngine.PAIRS)
            m.submodules[f"paired{first}"] = engine = PairedEngine(config, rows // 2)
            m.d.comb += [
                engine.taps.eq(weight[first * tap_bits : (first + rows) * tap_bits]),
                engine.second.eq(self.second),
                *(engine.pixels[pair].eq(self.pixels_2x[first // 2 + pair]) for pair in range(rows // 2)),
            ]
            for k in range(LANES):
                lanes[k] += engine.lanes[0][k], engine.lanes[1][k]
                if k in engine.CARRIES:
                    carries[k] += engine.carries[0][k], engine.carries[1][k]
        for row in range(config.paired_rows, config.rows):
            engine = make_engine(config.engine, config)
            m.submodules[f"engine{row}"] = engine
            m.d.comb += engine.taps.eq(weight[row * tap_bits : (row + 1) * tap_bits])
            for pixel in range(GROUP):
                at = (pixel * config.rows + row) * act_bits
                m.d.comb += engine.pixels[pixel].eq(self.activations[at : at + act_bits])
            for k in range(LANES):
                lanes[k].append(engine.lanes[k])
                if k in engine.CARRIES:
                    carries[k].append(engine.carries[k])

        sums = [
            Signal(lane_shape(config, config.rows), name=f"sum{k}", reset_less=True) for k in range(LANES)
        ]
        # N addends have N - 1 adders between them; the carry left over rides into the accumulator.
        spare: list = []
        for k, total in enumerate(sums):
            m.d.sync += total.eq(adder_tree(lanes[k], carries[k]))
            spare.append(Signal(name=f"carry{k}", reset_less=True) if carries[k] else None)
            if carries[k]:
                m.d.sync += spare[k].eq(carries[k][0])

        control = self.control
        carry_shape = data.ArrayLayout(acc, LANES - GROUP)
        m.submodules.carry = carry = memory.Memory(shape=carry_shape, depth=config.max_tiles, init=[])
        carried = carry.read_port(domain="comb")
        kept = carry.write_port()

        running = [Signal(acc, name=f"acc{k}", reset_less=True) for k in range(LANES)]
        totals = []
        for k in range(LANES):
            if k == 0:
                start, addend = carried.data[0], Mux(control.edge, 0, sums[0])
            elif k == 1:
                start, addend = Mux(control.edge, 0, carried.data[1]), sums[1]
            else:
                start, addend = 0, sums[k]
            total = Signal(acc, name=f"total{k}")
            before = Mux(control.first, start, running[k])
            total_is = before + addend if spare[k] is None else add_with_carry(before, addend, spare[k])
            m.d.comb += total.eq(total_is)
            totals.append(total)
            with m.If(control.en):
                m.d.sync += running[k].eq(total)

        done = Signal()
        m.d.comb += [
            done.eq(control.en & control.last),
            carried.addr.eq(control.tile),
            kept.addr.eq(control.tile),
            kept.en.eq(done),
            kept.data[0].eq(totals[GROUP]),
            kept.data[1].eq(totals[GROUP + 1]),
        ]
        result = Signal(data.ArrayLayout(acc, GROUP), reset_less=True)
        with m.If(done):
            m.d.sync += [result[slot].eq(totals[slot]) for slot in range(GROUP)]
        with m.Elif(self.shift):
            m.d.sync += result.eq(self.chain_i)
        m.d.comb += self.chain_o.eq(result)
        return m


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
