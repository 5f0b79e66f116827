"""The top level: AXI ports with the names that Vivado and cocotb expect."""

from amaranth.hdl import Cat, ClockDomain, Const, Module, ResetInserter, Signal
from amaranth.lib import wiring
from amaranth.lib.wiring import In, Out

from macram.spec import ArrayConfig, Control, Error
from macram.spec.registers import ADDRESS_BITS
from macram_hw.array import COUNTERS, RESIDUAL_REGISTERS, Array
from macram_hw.axi_lite import AxiLite, AxiLiteRegisters

__all__ = ["Top", "top_signature"]


def top_signature(config: ArrayConfig) -> wiring.Signature:
    """Ports of `Top`."""
    width, residual = config.stream_bits, config.residual_stream_bits
    return wiring.Signature({
        "aclk": In(1),
        **({"aclk2x": In(1)} if config.paired_rows else {}),
        "aresetn": In(1),
        **{f"s_axi_{name}": member for name, member in AxiLite(ADDRESS_BITS).flip().members.items()},
        **_stream_members("s_axis", In, width),
        **_stream_members("s_axis_param", In, width),
        **_stream_members("m_axis", Out, width),
        **(_stream_members("s_axis_residual", In, residual) if residual else {}),
        **(_stream_members("m_axis_residual", Out, residual) if residual else {}),
    })  # fmt: skip


class Top(wiring.Component):
    """The array behind AXI4-Lite registers, two AXI4-Stream inputs and one output.

    ``aclk`` is the clock of every port, ``aresetn`` the active-low synchronous reset. Arrays with paired rows
    also have ``aclk2x``, twice as fast and in phase: every rising edge of ``aclk`` is one of ``aclk2x``. Nothing
    that runs on it keeps a state, so it needs no reset. A soft reset stops a run and empties the array; registers,
    weights and requantiser parameters stay.

    Members: ``aclk``, ``aclk2x``, ``aresetn``, ``s_axi_*`` (registers), ``s_axis_*`` (image), ``s_axis_param_*``
    (weights and
    requantiser parameters), ``m_axis_*`` (codes). With a residual adder also ``s_axis_residual_*`` and
    ``m_axis_residual_*`` (8-bit codes of the residual stream).
    """

    def __init__(self, config: ArrayConfig):
        self._config = config
        self._registers = AxiLite(ADDRESS_BITS).flip().members
        super().__init__(top_signature(config))

    def elaborate(self, platform):
        config = self._config
        m = Module()
        m.domains.sync = sync = ClockDomain()
        m.d.comb += [sync.clk.eq(self.aclk), sync.rst.eq(~self.aresetn)]
        if config.paired_rows:
            m.domains.double = double = ClockDomain(reset_less=True)
            m.d.comb += double.clk.eq(self.aclk2x)

        m.submodules.registers = registers = AxiLiteRegisters()
        soft_reset = Signal()
        array = Array(config)
        m.submodules.array = ResetInserter(soft_reset)(array)

        for name, member in self._registers.items():
            port, inner = getattr(self, f"s_axi_{name}"), getattr(registers.axi, name)
            m.d.comb += inner.eq(port) if member.flow == In else port.eq(inner)
        m.d.comb += [
            soft_reset.eq(registers.command[Control.SOFT_RESET.bit_length() - 1]),
            array.command.eq(registers.command),
            array.words.eq(registers.param_words),
            array.param_base.eq(registers.param_base),
            *(
                getattr(array, n).eq(getattr(registers, n))
                for n in ("height", "width", "c_in", "c_out", "mode", "weight_base", "requant_base")
            ),
            registers.busy.eq(array.busy),
            registers.loading.eq(array.loading),
            registers.status.eq(Cat(array.busy, array.done, array.error != Error.NONE, array.loading)),
            registers.error.eq(array.error),
            *(getattr(registers, name).eq(getattr(array, name)) for name in COUNTERS),
            *(getattr(registers, name).eq(value) for name, value in capabilities(config).items()),
        ]

        inputs = [("s_axis", array.i), ("s_axis_param", array.params)]
        outputs = [("m_axis", array.o)]
        if config.residual_stream_bits:
            inputs.append(("s_axis_residual", array.residual))
            outputs.append(("m_axis_residual", array.sums))
            m.d.comb += [getattr(array, n).eq(getattr(registers, n)) for n in RESIDUAL_REGISTERS]
        for prefix, stream in inputs:
            m.d.comb += [
                stream.payload.data.eq(getattr(self, f"{prefix}_tdata")),
                stream.payload.last.eq(getattr(self, f"{prefix}_tlast")),
                stream.valid.eq(getattr(self, f"{prefix}_tvalid")),
                getattr(self, f"{prefix}_tready").eq(stream.ready),
            ]
        for prefix, stream in outputs:
            m.d.comb += [
                getattr(self, f"{prefix}_tdata").eq(stream.payload.data),
                getattr(self, f"{prefix}_tlast").eq(stream.payload.last),
                getattr(self, f"{prefix}_tvalid").eq(stream.valid),
                stream.ready.eq(getattr(self, f"{prefix}_tready")),
            ]
        return m


def capabilities(config: ArrayConfig) -> dict[str, Const]:
    """Values of the read-only registers that describe the array, by lower-case name."""
    formats = (
        config.weight.bits
        | config.input.bits << 8
        | config.input.signed << 15
        | config.output.bits << 16
        | config.output.signed << 23
    )
    values = {
        "geometry": config.units | config.rows << 16 | config.drain << 24,
        "formats": formats,
        "weight_depth": config.weight_depth,
        "row_words": config.row_words,
        "max_channels": config.max_c_in | config.max_c_out << 16,
        "residual": config.residual_stream_bits,
        "partial_c_in": config.partial_sum_c_in,
    }
    return {name: Const(value, 32) for name, value in values.items()}


def _stream_members(prefix: str, flow, width: int) -> dict:
    back = Out if flow is In else In
    return {
        f"{prefix}_tdata": flow(width),
        f"{prefix}_tvalid": flow(1),
        f"{prefix}_tready": back(1),
        f"{prefix}_tlast": flow(1),
    }
