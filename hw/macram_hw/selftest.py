"""A self-test around the array: a board needs a clock and a few lamps, no processor and no wide port."""

from amaranth.hdl import Array, Cat, ClockSignal, Const, Instance, Module, Signal
from amaranth.lib import crc, wiring
from amaranth.lib.wiring import In, Out

from macram.spec import ArrayConfig
from macram.spec.registers import ADDRESS_BITS
from macram.spec.selftest import SelfTestPlan, scrambler_shifts
from macram_hw.top import top_signature

__all__ = ["SelfTest"]

RESET_CYCLES = 64
BLINK_CYCLES = 1 << 25


class SelfTest(wiring.Component):
    """Runs one layer on the array over and over and compares what comes out with what the plan foretells.

    A run writes the layer's shape to the registers and starts the array, sends pseudo-random image beats without
    a gap, takes every output beat at once into a CRC-32, then reads registers. It passes if the CRC, the number of
    output beats and the registers, the cycle counter among them, are as planned and every access was answered
    OKAY. The weights are those that the array's memories start with.

    The first run begins `RESET_CYCLES` after reset, each further one when the last has passed; a run that fails is
    the last. One that has not ended after twice the planned cycles and 4096 fails.

    Members:
        passed: Out, a run has passed and none has failed. failed: Out, a run has failed; until reset.
        blink: Out, changes about every `BLINK_CYCLES` cycles as long as runs pass.
    """

    def __init__(self, config: ArrayConfig, plan: SelfTestPlan):
        self._config = config
        self._plan = plan
        super().__init__({"passed": Out(1), "failed": Out(1), "blink": Out(1)})

    def elaborate(self, platform):
        plan = self._plan
        m = Module()
        # One Verilog module, so that array and self-test are synthesised from the files that are simulated.
        members = top_signature(self._config).members.items()
        axi = {name: Signal(member.shape, name=name) for name, member in members}
        ports = {f"{'i' if member.flow == In else 'o'}_{name}": axi[name] for name, member in members}
        m.submodules.top = Instance("macram_top", **ports)

        start = Signal()
        ended, checksum_good = Signal(), Signal()
        self._reset(m, axi)
        self._source(m, axi, start)
        self._sink(m, axi, start, ended, checksum_good)

        index = Signal(range(max(len(plan.writes), len(plan.checks)) + 1))
        write, check = (self._table(m, rows, index) for rows in (plan.writes, plan.checks))
        answer = Signal.like(axi["s_axi_rdata"])
        answered, refused = Signal(), Signal()
        fault = Signal()
        limit = 2 * plan.cycles + 4096
        watchdog = Signal(range(limit + 1))
        runs = Signal(max(1, (BLINK_CYCLES // plan.cycles).bit_length()))
        m.d.comb += [
            Cat(axi["s_axi_wdata"], axi["s_axi_awaddr"]).eq(write),
            axi["s_axi_araddr"].eq(check[32:]),
            axi["s_axi_wstrb"].eq(0b1111),
            axi["s_axi_bready"].eq(1),
            axi["s_axi_rready"].eq(1),
            self.blink.eq(runs[-1]),
        ]
        m.d.sync += [
            answer.eq(axi["s_axi_rdata"]),
            answered.eq(axi["s_axi_rvalid"]),
            refused.eq(axi["s_axi_rresp"] != 0),
        ]
        for channel in ("aw", "w", "ar"):
            with m.If(axi[f"s_axi_{channel}ready"]):
                m.d.sync += axi[f"s_axi_{channel}valid"].eq(0)

        with m.FSM():
            with m.State("begin"):
                m.d.sync += [index.eq(0), watchdog.eq(limit)]
                m.d.comb += start.eq(axi["aresetn"])
                with m.If(axi["aresetn"]):
                    m.next = "write table"
            with m.State("write table"):
                m.next = "write"
            with m.State("write"):
                m.d.sync += [axi["s_axi_awvalid"].eq(1), axi["s_axi_wvalid"].eq(1), index.eq(index + 1)]
                m.next = "write answer"
            with m.State("write answer"):
                with m.If(axi["s_axi_bvalid"]):
                    m.d.sync += fault.eq(axi["s_axi_bresp"] != 0)
                    m.next = "write table"
                    with m.If(index == len(plan.writes)):
                        m.next = "run"
                    with m.If(axi["s_axi_bresp"] != 0):
                        m.next = "end"
            with m.State("run"):
                m.d.sync += [index.eq(0), watchdog.eq(watchdog - 1)]
                with m.If(ended):
                    m.next = "read table"
                with m.If(watchdog == 0):
                    m.d.sync += fault.eq(1)
                    m.next = "end"
            with m.State("read table"):
                m.next = "read"
            with m.State("read"):
                m.d.sync += axi["s_axi_arvalid"].eq(1)
                m.next = "read answer"
            with m.State("read answer"):
                with m.If(answered):
                    m.d.sync += index.eq(index + 1)
                    m.next = "read table"
                    with m.If(index == len(plan.checks) - 1):
                        m.next = "end"
                    with m.If(refused | (answer != check[:32])):
                        m.d.sync += fault.eq(1)
                        m.next = "end"
            with m.State("end"):
                with m.If(fault | ~checksum_good):
                    m.d.sync += [self.failed.eq(1), self.passed.eq(0)]
                with m.Else():
                    m.d.sync += [self.passed.eq(1), runs.eq(runs + 1)]
                    m.next = "begin"
        return m

    @staticmethod
    def _table(m, rows, index):
        """The row at ``index`` one cycle later: value in the low 32 bits, byte offset above."""
        row = Signal(32 + ADDRESS_BITS)
        m.d.sync += row.eq(
            Array(Cat(Const(value, 32), Const(offset, ADDRESS_BITS)) for offset, value in rows)[index]
        )
        return row

    @staticmethod
    def _reset(m, axi):
        wait = Signal(range(RESET_CYCLES + 1), init=RESET_CYCLES)
        with m.If(wait != 0):
            m.d.sync += wait.eq(wait - 1)
        m.d.sync += axi["aresetn"].eq(wait == 0)
        m.d.comb += axi["aclk"].eq(ClockSignal())

    def _source(self, m, axi, start):
        """Image beats from a xorshift generator; `macram.spec.selftest.scrambled_beats` gives the same."""
        plan, width = self._plan, self._config.stream_bits
        left, right, again = scrambler_shifts(width)
        beat = Signal(width)
        after = beat ^ (beat << left)[:width]
        after = after ^ (after >> right)
        after = after ^ (after << again)[:width]
        remaining = Signal(range(plan.beats_in + 1))
        m.d.comb += [
            axi["s_axis_tdata"].eq(beat),
            axi["s_axis_tlast"].eq(remaining == 1),
            axi["s_axis_tvalid"].eq(remaining != 0),
        ]
        with m.If(axi["s_axis_tvalid"] & axi["s_axis_tready"]):
            m.d.sync += [beat.eq(after), remaining.eq(remaining - 1)]
        with m.If(start):
            m.d.sync += [beat.eq(plan.seed), remaining.eq(plan.beats_in)]

    def _sink(self, m, axi, start, ended, good):
        """Output beats, each taken in the cycle it comes, into count and CRC one cycle later."""
        plan, width = self._plan, self._config.stream_bits
        m.submodules.crc = checksum = crc.catalog.CRC32_ISO_HDLC(data_width=width).create()
        taken, last = Signal(), Signal()
        count = Signal(range(plan.beats_out + 2))
        m.d.comb += [
            axi["m_axis_tready"].eq(1),
            checksum.start.eq(start),
            checksum.valid.eq(taken),
        ]
        m.d.sync += [
            checksum.data.eq(axi["m_axis_tdata"]),
            taken.eq(axi["m_axis_tvalid"]),
            last.eq(axi["m_axis_tvalid"] & axi["m_axis_tlast"]),
            good.eq((checksum.crc == plan.crc) & (count == plan.beats_out)),
        ]
        with m.If(taken & (count <= plan.beats_out)):
            m.d.sync += count.eq(count + 1)
        with m.If(last):
            m.d.sync += ended.eq(1)
        with m.If(start):
            m.d.sync += [count.eq(0), ended.eq(0)]
