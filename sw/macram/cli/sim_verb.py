"""``macram sim``: the reference layer at full size and odd shapes, each compared code by code."""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from rich.box import SIMPLE
from rich.table import Table

from macram.cli.console import open_console
from macram.cli.stages import Stages
from macram.layer_job import LayerRun, Traffic, array_for, layer_table, run_layer_job
from macram.report.files import write_json
from macram.report.latency import REFERENCE
from macram.report.versions import machine, versions
from macram.spec import ArrayConfig, ConvSpec

if TYPE_CHECKING:
    from macram.layer_file import LayerCase

CYCLE_BOUND = 205_000
"""The reference layer without gaps or stalls must stay at or below this."""
ODD_SHAPES = ((1, 1, 1, 1), (7, 5, 9, 13), (65, 67, 5, 3), (9, 129, 4, 18), (136, 64, 3, 31))
"""Channels in and out, height, width: below, at and above a block, a tile, a 4-pixel group."""


@dataclass(frozen=True)
class Outcome:
    """One row of the table: what was run, and the run or the line that says why there is none."""

    name: str
    spec: ConvSpec
    traffic: Traffic
    run: LayerRun | None = None
    fault: str = ""

    @property
    def passed(self) -> bool:
        """Compared equal, and within the cycle bound where that applies."""
        return self.run is not None and self.run.passed and not self.fault

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON."""
        if self.run is None:
            table: dict[str, Any] = {"passed": False, "layer": layer_table(self.spec)}
        else:
            table = self.run.report() | {"passed": self.passed}
            del table["versions"], table["array"], table["format"]
        return {"name": self.name, "fault": self.fault, **table}


def sim(arguments: argparse.Namespace) -> int:
    """Run all of them, print the table, write ``sim.json``; 0 only if every row passed."""
    if arguments.seed < 0:
        raise ValueError(f"--seed must be 0 or more, not {arguments.seed}")
    console = open_console()
    stages = Stages(console)
    seed, waves = arguments.seed, arguments.waves
    quiet = Traffic(seed=seed, waves=waves)
    rough = Traffic(gaps="random", stalls="random", load="stream", seed=seed, waves=waves)
    with stages("the reference layer's codes"):
        source, reference = _reference(arguments)
    arguments.out.mkdir(parents=True, exist_ok=True)
    outcomes = [_odd(shape, rough, stages) for shape in ODD_SHAPES]
    outcomes.append(_attempt(f"reference, {source}", reference, quiet, stages, bound=CYCLE_BOUND))
    outcomes.append(_attempt("reference, gaps and stalls", reference, rough, stages))
    console.print(table_of(outcomes))
    passed = all(outcome.passed for outcome in outcomes)
    write_json(
        arguments.out / "sim.json",
        {
            "format": 1,
            "passed": passed,
            "seed": seed,
            "array": ArrayConfig().to_dict(),
            "runs": [outcome.to_dict() for outcome in outcomes],
            "stages": stages.done,
            "machine": machine(),
            "versions": versions(),
        },
    )
    for outcome in outcomes:
        if not outcome.passed:
            reason = outcome.fault or (str(outcome.run.comparison) if outcome.run else "did not run")
            console.print(f"FAILED {outcome.name}: {reason}", markup=False, soft_wrap=True)
    failed = sum(not outcome.passed for outcome in outcomes)
    console.print(
        f"{len(outcomes)} runs, {failed} failed, seed {seed}; {arguments.out / 'sim.json'}",
        highlight=False,
        markup=False,
        soft_wrap=True,
    )
    return 0 if passed else 1


def _odd(shape: tuple[int, int, int, int], traffic: Traffic, stages: Stages) -> Outcome:
    from macram.golden import random_case  # noqa: PLC0415

    spec = ConvSpec(*shape)
    return _attempt("odd shape", random_case(spec, traffic.seed), traffic, stages)


def _reference(arguments: argparse.Namespace) -> tuple[str, LayerCase]:
    """The full-size layer: from an image through the network, or random codes."""
    if arguments.random:
        from macram.golden import random_case  # noqa: PLC0415

        return "random codes", random_case(REFERENCE, arguments.seed)
    from macram.demo import reference_front  # noqa: PLC0415

    image, front = reference_front(arguments.image, checkpoint=None, seed=arguments.seed)
    return image.name, front.case


def _attempt(
    name: str, case: LayerCase, traffic: Traffic, stages: Stages, bound: int | None = None
) -> Outcome:
    """Run one; a simulation that dies is a failed row, and the others still run.

    With ``bound``, for undisturbed streams, the cycles must also equal the closed form and not exceed it.
    """
    spec = case.spec
    label = f"{name} {spec.c_in} -> {spec.c_out}, {spec.height} x {spec.width}"
    try:
        with stages(label):
            run = run_layer_job(case, array=array_for(spec), traffic=traffic)
    except RuntimeError as error:
        return Outcome(name, spec, traffic, fault=" ".join(str(error).split()))
    fault = ""
    if bound is not None and run.cycles > bound:
        fault = f"{run.cycles:,} cycles, at most {bound:,} are allowed"
    elif bound is not None and run.estimate["exact"] and run.cycles != run.estimate["total"]:
        fault = f"{run.cycles:,} cycles, the closed form says {run.estimate['total']:,}"
    elif run.cycles_without_cause:
        fault = f"{run.cycles_without_cause} cycles have no cause in the counters"
    return Outcome(name, spec, traffic, run, fault)


def table_of(outcomes: list[Outcome]) -> Table:
    """One row per run: shape, codes compared and different, cycles measured and estimated, seconds."""
    table = Table(title="array simulation against the golden model", box=SIMPLE, padding=(0, 1, 0, 0))
    columns = ("run", "shape", "compared", "differ", "cycles", "estimate", "util %", "s", "")
    for column in columns:
        table.add_column(
            column, justify="left" if column in ("run", "shape", "") else "right", no_wrap=column != "run"
        )
    for outcome in outcomes:
        spec, run = outcome.spec, outcome.run
        shape = f"{spec.c_in}->{spec.c_out} {spec.height}x{spec.width}"
        verdict = "ok" if outcome.passed else "FAILED"
        if run is None:
            table.add_row(outcome.name, shape, "", "", "", "", "", "", verdict)
            continue
        table.add_row(
            outcome.name,
            shape,
            f"{run.comparison.compared:,}",
            f"{run.comparison.mismatches:,}",
            f"{run.cycles:,}",
            f"{run.estimate['total']:,}",
            f"{100 * run.report()['utilisation']:.1f}",
            f"{run.wall_seconds:.1f}",
            verdict,
        )
    return table
