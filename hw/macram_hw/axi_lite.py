"""AXI4-Lite subordinate with the array's registers, made from the table in `macram.spec.registers`."""

import operator

from amaranth import Module, Mux, Signal
from amaranth.lib import wiring
from amaranth.lib.wiring import In, Out

from macram.spec.registers import (
    ADDRESS_BITS,
    ID_VALUE,
    LOAD_REGISTERS,
    REGISTERS,
    VERSION_VALUE,
    Control,
)  # fmt: skip

__all__ = ["OKAY", "SLVERR", "AxiLite", "AxiLiteRegisters"]

OKAY, SLVERR = 0, 2
"""Values of BRESP and RRESP that are used."""
DATA_BITS = 32
_CONSTANTS = {"ID": ID_VALUE, "VERSION": VERSION_VALUE}


class AxiLite(wiring.Signature):
    """AXI4-Lite with 32-bit data, seen from the manager; a subordinate has it as ``In(AxiLite(...))``.

    The members are the lower-case names of the AXI specification, ``awaddr`` to ``rready``.

    Raises:
        ValueError: ``address_bits`` is not in 2..64.
    """

    def __init__(self, address_bits):
        if not 2 <= operator.index(address_bits) <= 64:
            raise ValueError(f"address_bits must be in 2..64, not {address_bits!r}")
        self._address_bits = address_bits
        super().__init__(
            {
                "awaddr": Out(address_bits),
                "awprot": Out(3),
                "awvalid": Out(1),
                "awready": In(1),
                "wdata": Out(DATA_BITS),
                "wstrb": Out(DATA_BITS // 8),
                "wvalid": Out(1),
                "wready": In(1),
                "bresp": In(2),
                "bvalid": In(1),
                "bready": Out(1),
                "araddr": Out(address_bits),
                "arprot": Out(3),
                "arvalid": Out(1),
                "arready": In(1),
                "rdata": In(DATA_BITS),
                "rresp": In(2),
                "rvalid": In(1),
                "rready": Out(1),
            }
        )

    @property
    def address_bits(self):
        """Width of the byte addresses."""
        return self._address_bits

    def __eq__(self, other):
        return isinstance(other, AxiLite) and self._address_bits == other._address_bits

    def __hash__(self):
        return hash((AxiLite, self._address_bits))

    def __repr__(self):
        return f"AxiLite({self._address_bits})"


class AxiLiteRegisters(wiring.Component):
    """The register map behind AXI4-Lite.

    Members besides ``axi``, named after the registers in lower case:

    - ``command`` (out, 4): the `Control` bits of an accepted write to CONTROL, for one cycle.
    - one 32-bit output per RW register, such as ``height``;
    - one 32-bit input per RO register other than ID and VERSION, which are constants;
    - ``loading`` (in): while it is high, writes to `LOAD_REGISTERS` are answered SLVERR and change nothing;
    - ``busy`` (in): while it is high, writes to the other RW registers are.

    Writes to RO or unmapped addresses and reads of unmapped addresses are answered SLVERR; such a read gives
    zero, and so does a read of CONTROL. WSTRB is honoured byte by byte; a command needs byte 0. Address bits
    1:0 are ignored. A soft reset is a strobe like the other commands: the registers keep their values.

    Writes and reads are independent of each other, one of each in flight. The address and the data of a write
    may come in either order. If both come in cycle n, BVALID is high in cycle n + `WRITE_LATENCY`;
    ``command`` and new register values appear in that same cycle. An address taken in cycle n has RVALID in
    cycle n + `READ_LATENCY` with the input's value of cycle n + 1. So a read issued on a write's answer
    already sees its effect, if ``busy`` and the inputs follow ``command`` within one cycle. A channel takes
    its next request in the cycle after its answer is taken.
    """

    WRITE_LATENCY = 2
    READ_LATENCY = 2

    def __init__(self):
        self._inputs = [r for r in REGISTERS if r.access == "RO" and r.name not in _CONSTANTS]
        self._stored = [r for r in REGISTERS if r.access == "RW"]
        super().__init__(
            {
                "axi": In(AxiLite(ADDRESS_BITS)),
                "command": Out(len(Control)),
                "busy": In(1),
                "loading": In(1),
                **{r.name.lower(): Out(DATA_BITS, init=r.reset) for r in self._stored},
                **{r.name.lower(): In(DATA_BITS) for r in self._inputs},
            }
        )

    def elaborate(self, platform):
        m = Module()
        self._write_channel(m)
        self._read_channel(m)
        return m

    def _write_channel(self, m):
        axi = self.axi
        address, address_held = Signal(ADDRESS_BITS - 2), Signal()
        data, strobe, data_held = Signal(DATA_BITS), Signal(DATA_BITS // 8), Signal()
        m.d.comb += [axi.awready.eq(~address_held), axi.wready.eq(~data_held)]
        with m.If(axi.awvalid & axi.awready):
            m.d.sync += [address.eq(axi.awaddr[2:]), address_held.eq(1)]
        with m.If(axi.wvalid & axi.wready):
            m.d.sync += [data.eq(axi.wdata), strobe.eq(axi.wstrb), data_held.eq(1)]

        m.d.sync += self.command.eq(0)
        # The request is held until its answer is taken, which keeps further requests out.
        with m.If(axi.bvalid):
            with m.If(axi.bready):
                m.d.sync += [axi.bvalid.eq(0), address_held.eq(0), data_held.eq(0)]
        with m.Elif(address_held & data_held):
            m.d.sync += [axi.bvalid.eq(1), axi.bresp.eq(SLVERR)]
            with m.Switch(address):
                for register in self._stored:
                    with m.Case(register.offset >> 2):
                        locked = self.loading if register.name in LOAD_REGISTERS else self.busy
                        with m.If(~locked):
                            m.d.sync += axi.bresp.eq(OKAY)
                            self._store(m, getattr(self, register.name.lower()), data, strobe)
                with m.Case(_offset("CONTROL") >> 2):
                    wanted = Mux(strobe[0], data[: len(self.command)], 0)
                    m.d.sync += [axi.bresp.eq(OKAY), self.command.eq(wanted)]

    @staticmethod
    def _store(m, target, data, strobe):
        for byte in range((len(target) + 7) // 8):
            lane = slice(8 * byte, min(8 * byte + 8, len(target)))
            with m.If(strobe[byte]):
                m.d.sync += target[lane].eq(data[lane])

    def _read_channel(self, m):
        axi = self.axi
        address, held = Signal(ADDRESS_BITS - 2), Signal()
        m.d.comb += axi.arready.eq(~held)
        with m.If(axi.arvalid & axi.arready):
            m.d.sync += [address.eq(axi.araddr[2:]), held.eq(1)]
        with m.If(axi.rvalid):
            with m.If(axi.rready):
                m.d.sync += [axi.rvalid.eq(0), held.eq(0)]
        with m.Elif(held):
            m.d.sync += [axi.rvalid.eq(1), axi.rdata.eq(0), axi.rresp.eq(OKAY)]
            with m.Switch(address):
                for register in REGISTERS:
                    with m.Case(register.offset >> 2):
                        m.d.sync += axi.rdata.eq(self._value(register))
                with m.Default():
                    m.d.sync += axi.rresp.eq(SLVERR)

    def _value(self, register):
        if register.access == "WO":
            return 0
        if register.name in _CONSTANTS:
            return _CONSTANTS[register.name]
        return getattr(self, register.name.lower())


def _offset(name):
    return next(r.offset for r in REGISTERS if r.name == name)
