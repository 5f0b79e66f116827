"""``macram experiments list | run | record | refine | integers | inference | table``."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from macram.cli.evaluate_verb import check_limit, frames_progress
from macram.cli.status import OK

DETAIL = (
    "Rows stand in configs/experiments.toml, their records in results/, and docs/results.md is made of the records "
    "alone. Run it in the repository."
)


def add_experiments(verb: Callable[[str, str, str, str], argparse.ArgumentParser]) -> None:
    """The grammar of ``macram experiments``; ``verb`` makes a top-level verb."""
    top = verb("experiments", "experiments_verb", "run the rows behind docs/results.md", DETAIL)
    actions = top.add_subparsers(dest="action", metavar="ACTION", required=True)

    def of_one_row(name: str, help: str, description: str) -> argparse.ArgumentParser:
        action: argparse.ArgumentParser = actions.add_parser(name, help=help, description=description)
        action.add_argument("row", help="as macram experiments list has it")
        action.add_argument("--seed", type=int, help="default: the row's first seed")
        return action

    rows = actions.add_parser("list", help="every row and seed, and how far it is")
    rows.add_argument("--json", action="store_true", help="print JSON")

    run = actions.add_parser(
        "run",
        help="train and score a row",
        description="Trains the row (and those it continues or imitates, if their networks are not there), scores it "
        "on the test split, by a single look and refined ([refined] of the plan), and writes its record. What is done "
        "is not done again; an interrupted run goes on from its checkpoint.",
    )
    run.add_argument("row", help="as macram experiments list has it, or all")
    run.add_argument("--seed", type=int, help="only this one of the row's seeds")

    record = of_one_row(
        "record",
        help="score a row that was trained elsewhere",
        description="The run's own configuration is held against the row's first.",
    )
    record.add_argument("folder", type=Path, metavar="RUN", help="with model.safetensors and log.csv")
    record.add_argument("--device", required=True, help="what it was trained on, in words")
    record.add_argument(
        "--evaluation",
        type=Path,
        metavar="JSON",
        help="evaluation.json of this network by a single look, to save scoring it again",
    )

    refine = of_one_row(
        "refine",
        help="add the refined scores to a record",
        description="For records without them, or after [refined] of the plan or the numbers behind it have changed: "
        "more looks at every picture and its edges, on the record's own frames. The network must be the recorded one, "
        "by its SHA-256. Up to 8 processes share the frames.",
    )
    refine.add_argument("folder", type=Path, metavar="RUN", help="with the row's model.safetensors")

    integers = of_one_row(
        "integers",
        help="add the scores of a quantised row's deployed integers",
        description="From the evaluation.json of macram evaluate --integer; the record says how many frames.",
    )
    integers.add_argument("evaluation", type=Path, metavar="JSON", help="of this row's network")

    inference = actions.add_parser(
        "inference",
        help="score ways to find poses with one trained network",
        description="Every way on the validation split, the chosen ones on the test split; results/inference-RUN.json. "
        "First the box of visible edges is measured on training frames with their true poses. What the record has "
        "by the same numbers is not scored again.",
    )
    inference.add_argument("model", type=Path, metavar="MODEL", help="model.safetensors of a run")
    inference.add_argument(
        "--integer",
        action="store_true",
        help="the deployed integers (mode III), chosen ways, test split alone",
    )

    table = actions.add_parser("table", help="make docs/results.md and its pictures from the records")
    table.add_argument("-o", "--out", type=Path, default=Path("docs"), metavar="DIR", help="default: docs")

    for action in (run, record, inference):
        action.add_argument(
            "--limit", type=int, default=0, help="score only so many frames; the record says so"
        )
    for action in (rows, run, record, refine, integers, inference, table):
        action.add_argument("--plan", type=Path, default=Path("configs/experiments.toml"), metavar="TOML",
                            help="default: configs/experiments.toml")  # fmt: skip
        action.add_argument(
            "--results", type=Path, default=Path("results"), metavar="DIR", help="default: results"
        )
    for action in (rows, run):
        action.add_argument("--runs", type=Path, default=Path("build/experiments"), metavar="DIR",
                            help="checkpoints; default: build/experiments")  # fmt: skip


def experiments(arguments: argparse.Namespace) -> int:
    """Run one action."""
    check_limit(getattr(arguments, "limit", 0))
    action: Callable[[argparse.Namespace], int] = ACTIONS[arguments.action]
    return action(arguments)


def _list(arguments: argparse.Namespace) -> int:
    from rich.table import Table  # noqa: PLC0415

    from macram.cli.console import open_console  # noqa: PLC0415
    from macram.experiments.plan import read_plan, read_result  # noqa: PLC0415
    from macram.experiments.refined import read_refined  # noqa: PLC0415

    jobs = list(read_plan(arguments.plan).jobs())
    states = [job.state(arguments.runs, arguments.results) for job in jobs]
    rows: list[dict[str, Any]] = []
    for job, state in zip(jobs, states, strict=True):
        row: dict[str, Any] = {
            "row": job.row.name,
            "seed": job.seed,
            "title": job.row.title,
            "after": job.row.after,
            "teacher": job.row.teacher,
            "state": state,
        }
        if state == "finished":
            folder = arguments.results / job.key
            record = read_result(folder)
            row["add_0.1"] = record["ranges"]["all"]["add"]["0.1"]
            try:
                if refined := read_refined(job, folder, record):
                    row["refined_add_0.1"] = refined.table["ranges"]["all"]["add"]["0.1"]
            except ValueError as error:
                row["refined_error"] = str(error)
        rows.append(row)
    if arguments.json:
        print(json.dumps(rows, indent=2))
        return OK
    table = Table(title=f"{states.count('finished')} of {len(jobs)} finished", title_justify="left")
    for column in ("row", "seed", "what", "continues", "state", "ADD-0.1d", "refined"):
        table.add_column(column)
    for row in rows:
        scores = [f"{row[key]:.2f} %" if key in row else "" for key in ("add_0.1", "refined_add_0.1")]
        scores[1] = "refine again" if "refined_error" in row else scores[1]
        sources = ", imitates ".join(name for name in (row["after"], row["teacher"]) if name)
        table.add_row(row["row"], str(row["seed"]), row["title"], sources, row["state"], *scores)
    open_console().print(table)
    return OK


def _run(arguments: argparse.Namespace) -> int:
    from macram.train.memory import keep_memory  # noqa: PLC0415

    keep_memory()
    from macram.cli.console import open_console  # noqa: PLC0415
    from macram.experiments.plan import Job, read_plan  # noqa: PLC0415
    from macram.experiments.run import run_job  # noqa: PLC0415

    plan, console = read_plan(arguments.plan), open_console()
    rows = plan.rows if arguments.row == "all" else (plan.row(arguments.row),)
    jobs = [Job(plan, row, seed) for row in rows for seed in row.seeds if arguments.seed in (None, seed)]
    if not jobs:
        raise ValueError(f"row {arguments.row} has no seed {arguments.seed}; see macram experiments list")
    for job in jobs:
        with frames_progress(console) as told:
            folder = run_job(
                job,
                arguments.runs,
                arguments.results,
                console,
                limit=arguments.limit,
                told=told,
            )
        console.print(f"{job.key}: finished, {folder}", highlight=False, markup=False, soft_wrap=True)
    return OK


def _record(arguments: argparse.Namespace) -> int:
    from macram.cli.console import open_console  # noqa: PLC0415
    from macram.experiments.plan import read_plan  # noqa: PLC0415
    from macram.experiments.run import record_job  # noqa: PLC0415

    plan, console = read_plan(arguments.plan), open_console()
    job = plan.job(arguments.row, arguments.seed)
    with frames_progress(console) as told:
        folder = record_job(
            job,
            arguments.folder,
            arguments.results,
            device=arguments.device,
            limit=arguments.limit,
            scored=arguments.evaluation,
            told=told,
        )
    console.print(f"{job.key}: finished, {folder}", highlight=False, markup=False, soft_wrap=True)
    return OK


def _refine(arguments: argparse.Namespace) -> int:
    from macram.cli.console import open_console  # noqa: PLC0415
    from macram.experiments.plan import read_plan  # noqa: PLC0415
    from macram.experiments.run import refine_job  # noqa: PLC0415

    plan, console = read_plan(arguments.plan), open_console()
    job = plan.job(arguments.row, arguments.seed)
    with frames_progress(console) as told:
        path = refine_job(job, arguments.folder, arguments.results, told=told)
    console.print(f"{job.key}: refined, {path}", highlight=False, markup=False, soft_wrap=True)
    return OK


def _integers(arguments: argparse.Namespace) -> int:
    from macram.experiments.integers import record_integers  # noqa: PLC0415
    from macram.experiments.plan import read_plan  # noqa: PLC0415

    plan = read_plan(arguments.plan)
    job = plan.job(arguments.row, arguments.seed)
    print(record_integers(job, arguments.evaluation, arguments.results))
    return OK


def _inference(arguments: argparse.Namespace) -> int:
    from macram.cli.console import open_console  # noqa: PLC0415
    from macram.experiments.inference import tries_file, try_all  # noqa: PLC0415
    from macram.experiments.plan import read_plan  # noqa: PLC0415

    console, data = open_console(), read_plan(arguments.plan).scoring.data

    def told(name: str, done: int, total: int) -> None:
        if done == total:
            console.print(f"{name}: {total} frames scored", highlight=False, markup=False, soft_wrap=True)

    with console.status("scoring"):
        path = try_all(
            arguments.model,
            data,
            arguments.results / tries_file(arguments.model, integer=arguments.integer),
            limit=arguments.limit,
            integer=arguments.integer,
            told=told,
        )
    console.print(str(path), highlight=False, markup=False, soft_wrap=True)
    return OK


def _table(arguments: argparse.Namespace) -> int:
    from macram.experiments.page import write_page  # noqa: PLC0415
    from macram.experiments.plan import read_plan  # noqa: PLC0415

    print(write_page(read_plan(arguments.plan), arguments.results, arguments.out))
    return OK


ACTIONS = {
    "list": _list,
    "run": _run,
    "record": _record,
    "refine": _refine,
    "integers": _integers,
    "inference": _inference,
    "table": _table,
}
