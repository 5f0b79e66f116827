"""``macram verify``: the constrained-random regression, the proofs, and the mutation run."""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

    from macram.spec import ArrayConfig

SEED = 2022

EPILOG = """\
examples:
  macram verify regression                        60 random cases on each of eight small arrays, scored
  macram verify regression --cases 1000 --seed 7  a long run
  macram verify regression --seed 7 --only 66     the case that failed, alone
  macram verify formal                            every proof, and that broken gateware fails it
  macram verify mutate --count 80                 break the gateware in 80 places; stop and go on at will
"""


def add_verify(verb: Callable[[str, str, str, str], argparse.ArgumentParser]) -> None:
    """Register the verb and its three parts."""
    top = verb(
        "verify",
        "verify_verb",
        "random regression with coverage, formal proofs, mutation run",
        "How well is the array checked? docs/verification.md explains what each part shows.",
    )
    top.epilog = EPILOG
    top.formatter_class = argparse.RawDescriptionHelpFormatter
    parts = top.add_subparsers(dest="part", metavar="PART", required=True)

    regression = parts.add_parser(
        "regression",
        help="random layers, traffic, faults and resets on small arrays; exact codes after each; coverage bins",
    )
    regression.add_argument("--cases", type=int, default=60, help="cases per array, at least 1 (default: 60)")
    regression.add_argument(
        "--only", type=int, metavar="CASE", help="run this case alone, as a failure names it"
    )
    regression.add_argument(
        "--array",
        help="only the small array of this name: portable, dsp48e2, 8-bit, signed, triples, residual, partial, soft",
    )
    regression.add_argument("--config", type=Path, metavar="CONFIG.toml", help="another array instead")
    _common(regression, "build/regression")

    formal = parts.add_parser(
        "formal",
        help="prove stream rules, ranges, bus protocol, arithmetic and progress on the exported Verilog",
    )
    formal.add_argument(
        "--module", dest="about", help="only proofs about this gateware module, such as gearbox"
    )
    formal.add_argument("--fast", action="store_true", help="only proofs that take seconds")
    formal.add_argument(
        "--sound-only", action="store_true", help="do not also show that broken gateware fails"
    )
    formal.add_argument(
        "-o", "--out", type=Path, default=Path("build/formal"), metavar="DIR", help="default: build/formal"
    )

    mutate = parts.add_parser(
        "mutate", help="break the gateware in one place at a time and count what notices (long)"
    )
    mutate.add_argument("--count", type=int, default=80, help="mutants to judge (default: 80)")
    mutate.add_argument(
        "--fresh", action="store_true", help="begin again instead of going on with DIR/mutate.json"
    )
    mutate.add_argument(
        "--quick",
        action="store_true",
        help="unit tests only; a later run without it judges the survivors further",
    )
    _common(mutate, "build/mutate")


def _common(sub: argparse.ArgumentParser, folder: str) -> None:
    sub.add_argument("-o", "--out", type=Path, default=Path(folder), metavar="DIR", help=f"default: {folder}")
    sub.add_argument("--seed", type=int, default=SEED, help=f"default: {SEED}")


def verify(arguments: argparse.Namespace) -> int:
    """Run the chosen part; 0 if everything held."""
    return {"regression": _regression, "formal": _formal, "mutate": _mutate}[arguments.part](arguments)


# ---- regression ---------------------------------------------------------------------------------------------


def _regression(arguments: argparse.Namespace) -> int:
    """0 only if every case passed and every bin that the arrays admit was met (or one case was picked)."""
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn  # noqa: PLC0415

    from macram.cli.console import open_console  # noqa: PLC0415
    from macram.report.files import write_json  # noqa: PLC0415
    from macram_sim.regression import choose_cases, regress  # noqa: PLC0415

    arrays = _arrays(arguments)
    console = open_console()
    total = len(arrays) * len(choose_cases(arguments.seed, arguments.cases, arguments.only))
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(*columns, console=console) as bar:
        task = bar.add_task("cases", total=total)
        result = regress(
            arrays,
            seed=arguments.seed,
            cases=arguments.cases,
            only=arguments.only,
            progress=lambda done: bar.update(task, completed=done),
        )
        bar.update(task, completed=total)
    table = result.to_dict()
    arguments.out.mkdir(parents=True, exist_ok=True)
    write_json(arguments.out / "regression.json", table)
    console.print(
        f"{table['cases']} cases, {table['images']} whole images, {table['cycles']:,} cycles, seed {result.seed}: "
        f"all codes exact\ncoverage {table['bins_met']} of {table['bins']} bins = {100 * result.coverage.share:.1f} %",
        highlight=False,
    )
    for name in result.coverage.missed:
        console.print(f"  not met: {name}", highlight=False, markup=False)
    for name in result.coverage.impossible:
        console.print(f"  not admitted by these arrays: {name}", highlight=False, markup=False)
    console.print(f"{arguments.out / 'regression.json'}", highlight=False, markup=False, soft_wrap=True)
    return 0 if not result.coverage.missed or arguments.only is not None else 1


def _arrays(arguments: argparse.Namespace) -> list[ArrayConfig]:
    from macram.spec import ArrayConfig  # noqa: PLC0415
    from macram_sim.regression import ARRAYS  # noqa: PLC0415

    if arguments.config is not None:
        return [ArrayConfig.from_toml(arguments.config)]
    chosen = [array for array in ARRAYS if arguments.array in (None, array.name)]
    if not chosen:
        names = ", ".join(array.name for array in ARRAYS)
        raise ValueError(f"--array must be one of {names}, not {arguments.array!r}")
    return chosen


# ---- proofs -------------------------------------------------------------------------------------------------


def _formal(arguments: argparse.Namespace) -> int:
    """0 only if every proof passed and every broken module failed."""
    from rich.box import SIMPLE  # noqa: PLC0415
    from rich.table import Table  # noqa: PLC0415

    from macram.cli.console import open_console  # noqa: PLC0415
    from macram.cli.stages import Stages  # noqa: PLC0415
    from macram.report.files import write_json  # noqa: PLC0415
    from macram_sim.formal import PROOFS, prove  # noqa: PLC0415

    chosen = [
        proof
        for proof in PROOFS
        if arguments.about in (None, *proof.modules) and (proof.fast or not arguments.fast)
    ]
    console = open_console()
    stages = Stages(console, total=len(chosen))
    arguments.out.mkdir(parents=True, exist_ok=True)
    table = Table(title="proofs on the exported Verilog", box=SIMPLE, padding=(0, 1, 0, 0))
    for name in ("proof", "what it shows", "how", "CPU s", "broken modules", ""):
        table.add_column(name, overflow="fold")
    target, rows = arguments.out / "formal.json", list[dict[str, Any]]()

    def result() -> dict[str, Any]:
        """What has been shown so far; passed only if that is all."""
        passed = len(rows) == len(chosen) and all(row["passed"] for row in rows)
        seconds = sum(row["cpu_seconds"] + row["broken_cpu_seconds"] for row in rows)
        return {"format": 1, "passed": passed, "cpu_seconds": round(seconds, 2), "proofs": rows}

    for proof in chosen:
        with stages(proof.name):
            verdict = prove(proof, arguments.out, mutants=not arguments.sound_only)
        rows.append(verdict.to_dict())
        write_json(target, result())
        noticed = f"{sum(verdict.noticed.values())} of {len(verdict.noticed)} fail, {verdict.broken_cpu_seconds:.1f} s"
        table.add_row(
            proof.name,
            proof.claim,
            proof.method,
            f"{verdict.cpu_seconds:.1f}",
            noticed if verdict.noticed else "",
            "ok" if verdict.passed else "FAILED",
        )
    console.print(table)
    write_json(target, result())
    console.print(f"{result()['cpu_seconds']:.0f} CPU seconds in all", highlight=False)
    for row in rows:
        if not row["passed"]:
            console.print(f"FAILED {row['name']}: {row['fault']}", markup=False, soft_wrap=True)
    console.print(f"{target}", highlight=False, markup=False, soft_wrap=True)
    return 0 if result()["passed"] else 1


# ---- mutants ------------------------------------------------------------------------------------------------


def _mutate(arguments: argparse.Namespace) -> int:
    """0 only if no mutant survived that is not in the reviewed list of equivalents."""
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn  # noqa: PLC0415

    from macram.cli.console import open_console  # noqa: PLC0415
    from macram.report.files import write_json  # noqa: PLC0415
    from macram_sim.mutate import Verdict, run_mutants  # noqa: PLC0415

    target = arguments.out / "mutate.json"
    earlier = json.loads(target.read_text()) if target.is_file() and not arguments.fresh else None
    arguments.out.mkdir(parents=True, exist_ok=True)
    console = open_console()
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(*columns, console=console) as bar:
        task = bar.add_task("mutants", total=arguments.count)

        def keep(table: dict[str, Any], verdict: Verdict | None) -> None:
            write_json(target, table)
            bar.update(task, completed=table["judged"])
            if verdict is not None:
                bar.console.print(
                    f"{verdict.killed_by:10}  {verdict.file}:{verdict.line}  {verdict.new}  ({verdict.seconds:.0f} s)",
                    highlight=False, markup=False, soft_wrap=True,
                )  # fmt: skip

        table = run_mutants(
            arguments.out,
            seed=arguments.seed,
            count=arguments.count,
            earlier=earlier,
            quick=arguments.quick,
            keep=keep,
        )
    for row in table["mutants"]:
        if row["killed_by"] == "survived":
            console.print(
                f"SURVIVED {row['file']}:{row['line']} ({row['kind']}, array {row['array']})\n"
                f"  - {row['old']}\n  + {row['new']}",
                highlight=False, markup=False, soft_wrap=True,
            )  # fmt: skip
    by = ", ".join(f"{count} by {name}" for name, count in table["killed_by"].items())
    console.print(
        f"{table['judged']} mutants, {table['killed']} killed ({by}), {table['equivalent']} equivalent, "
        f"{table['survived']} survived: {100 * table['share_killed']:.1f} % killed, seed {table['seed']}\n{target}",
        highlight=False, soft_wrap=True,
    )  # fmt: skip
    return 0 if not table["survived"] else 1
