"""Run one convolution layer on the array: pack, simulate the exported Verilog, compare with the golden model.

This is what stands behind ``macram layer`` and the last stages of ``macram demo``. The parts it joins are
imported where they are used, so that importing this module needs NumPy alone.
"""

from __future__ import annotations

import dataclasses
import time
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from macram.report.comparison import Comparison, compare
from macram.report.files import write_json, write_npz
from macram.report.versions import versions
from macram.spec import ArrayConfig, ConvSpec, layer_passes

if TYPE_CHECKING:
    from macram.layer_file import LayerCase
    from macram.pack import PackedLayer
    from macram.perf import CycleEstimate

CLOCK_HZ = 100_000_000
"""The clock of the paper's accelerator; every latency in a report is cycles at this clock."""

COUNTERS = ("mac_cycles", "fill_cycles", "input_stalls", "output_stalls", "drain_cycles")
"""Hardware counters whose sum is ``cycles``: each cycle has exactly one cause."""

PATTERNS = ("none", "random", "bursty")
"""Of a stream: always moving, often pausing shortly, seldom pausing long."""

Stage = Callable[[str], AbstractContextManager[Any]]
"""Opens a named stage; the demo prints a line with its seconds."""


@dataclass(frozen=True)
class Traffic:
    """How the streams behave in a simulation.

    Attributes:
        gaps: idle cycles of the sources, one of `PATTERNS`.
        stalls: not-ready cycles of the sink, one of `PATTERNS`.
        load: how weights reach the array: ``file`` (memory initialisation) or ``stream``.
        seed: of the patterns.
        waves: write a waveform.
    """

    gaps: str = "none"
    stalls: str = "none"
    load: str = "file"
    seed: int = 0
    waves: bool = False


@dataclass(frozen=True)
class LayerRun:
    """One finished simulation with everything needed to judge and to report it.

    Attributes:
        case: the layer that was run.
        array: the array it ran on.
        passes: the BRAM images, one for each pass, see `macram.spec.layer_passes`.
        expected: golden codes, int64 ``[c_out, out_height, out_width]``.
        produced: codes of the simulated hardware, same shape.
        comparison: ``expected`` against ``produced``.
        counters: the array's cycle counters by lower-case register name.
        estimate: `macram.perf` for this layer, see `estimate_table`.
        traffic: stream patterns and their seed.
        build_seconds: export and Verilator build, little when both were cached.
        wall_seconds: the simulation.
        simulator: Verilator and C++ compiler that ran it, as they call themselves.
        waves: waveform file, or None.
    """

    case: LayerCase
    array: ArrayConfig
    passes: list[PackedLayer]
    expected: NDArray[np.int64]
    produced: NDArray[np.int64]
    comparison: Comparison
    counters: dict[str, int]
    estimate: dict[str, Any]
    traffic: Traffic
    build_seconds: float
    wall_seconds: float
    simulator: str
    waves: Path | None = None

    @property
    def cycles(self) -> int:
        """First accepted input beat to last output beat, both counted."""
        return self.counters["cycles"]

    @property
    def passed(self) -> bool:
        """Nothing differs and every cycle has a cause."""
        return self.comparison.equal and self.cycles_without_cause == 0

    @property
    def cycles_without_cause(self) -> int:
        """Cycles that no counter explains; anything but 0 is a fault of the hardware's counters."""
        return self.cycles - sum(self.counters[name] for name in COUNTERS)

    def report(self) -> dict[str, Any]:
        """The plain values of ``report.json``; times in milliseconds or seconds as named."""
        spec = self.case.spec
        return {
            "format": 1,
            "passed": self.passed,
            "compared": self.comparison.compared,
            "mismatches": self.comparison.mismatches,
            "first_difference": self.comparison.first,
            "cycles": self.cycles,
            "macs": spec.macs,
            "macs_per_cycle": spec.macs / self.cycles,
            "utilisation": spec.macs / (self.cycles * self.array.peak_macs),
            "ms_at_100mhz": 1e3 * self.cycles / CLOCK_HZ,
            "counters": dict(self.counters),
            "cycle_shares": {name: self.counters[name] / self.cycles for name in COUNTERS},
            "cycles_without_step": self.cycles - self.counters["mac_cycles"],
            "cycles_beyond_estimate": self.cycles - self.estimate["total"],
            "cycles_without_cause": self.cycles_without_cause,
            "estimate": self.estimate,
            "layer": layer_table(spec),
            "array": self.array.to_dict() | {"peak_macs_per_cycle": self.array.peak_macs},
            "traffic": dataclasses.asdict(self.traffic),
            "seed": self.traffic.seed,
            "build_seconds": round(self.build_seconds, 3),
            "simulation_seconds": round(self.wall_seconds, 3),
            "versions": versions() | {"simulator": self.simulator},
        }


def layer_table(spec: ConvSpec) -> dict[str, Any]:
    """Shapes and formats of a layer as plain values."""
    table: dict[str, Any] = dataclasses.asdict(spec)
    table |= {key: str(getattr(spec, key)) for key in ("weight", "input", "output")}
    table["out_height"], table["out_width"] = spec.out_height, spec.out_width
    table["accumulator"] = str(spec.accumulator)
    return table


def array_for(spec: ConvSpec, base: ArrayConfig | None = None) -> ArrayConfig:
    """The geometry of ``base`` (default: the reference array) with the code formats of ``spec``.

    Raises:
        ValueError: the geometry cannot be built with these formats, or does not admit the layer.
    """
    array = base or ArrayConfig()
    formats: dict[str, Any] = {"weight": spec.weight, "input": spec.input, "output": spec.output}
    if spec.input.signed and spec.input.bits == array.input.bits:
        # Arrays of unsigned inputs take signed codes as well.
        formats["input"] = array.input
    if any(getattr(array, key) != value for key, value in formats.items()):
        name = "-".join([array.name, *map(str, formats.values())])
        array = dataclasses.replace(array, name=name, **formats)
    layer_passes(spec, array)
    return array


def run_layer_job(
    case: LayerCase,
    *,
    array: ArrayConfig | None = None,
    traffic: Traffic | None = None,
    stage: Stage | None = None,
    expected: NDArray[np.int64] | None = None,
    job_dir: Path | None = None,
    told: Callable[[float], None] | None = None,
) -> LayerRun:
    """Pack ``case``, simulate it on ``array`` and compare every output code with the golden model.

    Args:
        case: the layer.
        array: the array to run on; by default the reference geometry with the layer's formats.
        traffic: stream patterns, by default undisturbed.
        stage: opens a named stage, for progress.
        expected: golden codes where the caller has them already.
        job_dir: where inputs, log and waveform of the simulation go and stay; default a folder among the builds.
        told: called now and then, from another thread, with the share of the simulation that is done.

    Raises:
        ValueError: the array does not admit the layer.
    """
    from macram import golden, pack, perf  # noqa: PLC0415
    from macram_sim.array import build_array, simulate  # noqa: PLC0415
    from macram_sim.tools import find_toolchain  # noqa: PLC0415

    tools = find_toolchain()
    stage = stage or nullcontext
    traffic = traffic or Traffic()
    if array is None:
        array = array_for(case.spec)
    if expected is None:
        with stage("golden model"):
            expected = golden.run_layer(case)
    with stage("pack weights and thresholds"):
        passes = pack.pack_passes(case, array)
    started = time.perf_counter()
    with stage("export the Verilog and build its simulator"):
        build_array(array, waves=traffic.waves)
    build_seconds = time.perf_counter() - started
    with stage("simulate"):
        result = simulate(
            passes[0] if len(passes) == 1 else passes,
            case.input,
            job_dir=job_dir,
            told=told,
            **dataclasses.asdict(traffic),
        )
    return LayerRun(
        case=case,
        array=array,
        passes=passes,
        expected=expected,
        produced=result.codes,
        comparison=compare(expected, result.codes),
        counters={name: int(result.counters[name]) for name in ("cycles", *COUNTERS)},
        estimate=estimate_table(perf.estimate_passes(case.spec, array)),
        traffic=traffic,
        build_seconds=build_seconds,
        wall_seconds=result.wall_seconds,
        simulator=f"{tools.source} Verilator {tools.version}",
        waves=result.waves,
    )


def write_run(run: LayerRun, folder: Path) -> None:
    """Write ``output.npz`` (key ``codes``) and ``report.json`` into ``folder``, each whole or not at all."""
    folder.mkdir(parents=True, exist_ok=True)
    write_npz(folder / "output.npz", codes=output_codes(run))
    write_json(folder / "report.json", run.report())


def output_codes(run: LayerRun) -> NDArray[np.integer]:
    """The codes of the hardware in the byte type that holds them all."""
    output = run.case.spec.output
    return run.produced.astype(np.int8 if output.signed or output.bits < 8 else np.uint8)


def estimate_table(passes: Sequence[CycleEstimate]) -> dict[str, Any]:
    """Cycle estimates, added up, under the names of the counters that they predict, for undisturbed streams."""
    return {
        "total": sum(part.total for part in passes),
        "mac_cycles": sum(part.mac for part in passes),
        "fill_cycles": sum(part.fill for part in passes),
        "input_stalls": 0,
        "output_stalls": sum(part.stall for part in passes),
        "drain_cycles": sum(part.drain for part in passes),
        "exact": all(part.exact for part in passes),
        "limited_by": next((part.limited_by for part in passes if not part.exact), "compute"),
        "passes": len(passes),
    }


def run_summary(run: LayerRun) -> str:
    """What was compared and how long it took, in one line; the first difference if there is one."""
    from macram.report.latency import latency_report  # noqa: PLC0415

    milliseconds = 1e3 * run.cycles / CLOCK_HZ
    paper = " (paper 5.99 ms)" if latency_report(run.case.spec, milliseconds) else ""
    line = f"{run.comparison}; {run.cycles:,} cycles, {milliseconds:.3f} ms at 100 MHz{paper}"
    if run.waves:
        line += f"; waveform {run.waves}"
    if run.cycles_without_cause:
        line += f"; {run.cycles_without_cause:,} cycles have no cause in the counters"
    return line
