"""The plan: rows with their configurations, one job per row and seed, and how far each job is."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

from macram.data.files import read_json
from macram.data.recipe import read_recipe
from macram.pose import EdgeSettings, LookSettings, PoseSettings
from macram.train.checkpoint import read_tensors
from macram.train.config import TrainConfig, load_config

PLAN = Path("configs/experiments.toml")
RESULTS = Path("results")
RUNS = Path("build/experiments")
GROUPS = ("questions", "seeds", "data", "quantised", "front")
DEFAULT_SEED = 2022
MODEL, LAST, RESULT = "model.safetensors", "last.safetensors", "result.json"


@dataclass(frozen=True, slots=True)
class Row:
    """A line of a table.

    Attributes:
        name: to run it by.
        title: as the table calls it.
        group: one of `GROUPS`, the table it belongs to.
        config: training configuration.
        set: dotted keys and values over the configuration's.
        after: row whose network it continues; empty for none.
        teacher: row whose network it imitates; empty for none.
        seeds: one job each.
    """

    name: str
    title: str
    group: str
    config: Path
    set: dict[str, Any] = field(default_factory=dict)
    after: str = ""
    teacher: str = ""
    seeds: tuple[int, ...] = (DEFAULT_SEED,)


@dataclass(frozen=True, slots=True)
class Refined:
    """The second way to find poses that every row is scored by, calibrated without test frames.

    Attributes:
        looks: turned crops around the first pose, chosen on validation frames.
        edges: size of the box of visible edges in boxes of the keypoints, measured on training frames.

    Raises:
        ValueError: a value out of range.
    """

    looks: int
    edges: float

    def __post_init__(self) -> None:
        if type(self.looks) is not int or type(self.edges) not in {int, float}:
            raise ValueError(f"looks must be a whole number and edges a number, not {self}")
        _ = self.settings

    @property
    def settings(self) -> PoseSettings:
        """For the predictor."""
        return PoseSettings(looks=LookSettings(turns=self.looks), edges=EdgeSettings(box=self.edges))

    @property
    def options(self) -> str:
        """Of ``macram evaluate``."""
        return f"--looks {self.looks} --edges {self.edges}"


@dataclass(frozen=True, slots=True)
class Source:
    """A data set.

    Attributes:
        data: its folder.
        recipe: what it must be.
    """

    data: Path
    recipe: Path

    def check(self) -> None:
        """Holds the folder against the recipe.

        Raises:
            ValueError: see `Recipe.check`.
        """
        read_recipe(self.recipe).check(self.data)


@dataclass(frozen=True, slots=True)
class Plan:
    """All rows of one file.

    Attributes:
        scoring: whose test split scores the rows.
        training: what rows learn from, unless they set ``data.root``.
        refined: how rows are scored beside the single look.
        rows: in the order of the file, so that none comes before a row it continues or imitates.
    """

    scoring: Source
    training: Source
    refined: Refined
    rows: tuple[Row, ...]

    def source(self, root: str) -> Source | None:
        """The data set in the folder ``root``; None if the plan does not know it."""
        known = (source for source in (self.scoring, self.training) if str(source.data) == root)
        return next(known, None)

    def row(self, name: str) -> Row:
        """The row called ``name``.

        Raises:
            ValueError: there is none.
        """
        for row in self.rows:
            if row.name == name:
                return row
        raise ValueError(f"no row {name!r}; rows: {', '.join(row.name for row in self.rows)}")

    def job(self, name: str, seed: int | None) -> Job:
        """The row called ``name`` with ``seed``, or with its first.

        Raises:
            ValueError: there is no such row.
        """
        row = self.row(name)
        return Job(self, row, row.seeds[0] if seed is None else seed)

    def jobs(self) -> Iterator[Job]:
        """Every row with every seed."""
        return (Job(self, row, seed) for row in self.rows for seed in row.seeds)


@dataclass(frozen=True, slots=True)
class Job:
    """One row with one seed."""

    plan: Plan
    row: Row
    seed: int

    @property
    def key(self) -> str:
        """Name of its folders of run and result."""
        return f"{self.row.name}.s{self.seed}"

    def before(self) -> Job | None:
        """The job whose network this one continues: of the same seed, or the only one of its row."""
        return self._of(self.row.after)

    def teacher(self) -> Job | None:
        """The job whose network this one imitates: of the same seed, or the only one of its row."""
        return self._of(self.row.teacher)

    def _of(self, name: str) -> Job | None:
        if not name:
            return None
        row = self.plan.row(name)
        return Job(self.plan, row, row.seeds[0] if len(row.seeds) == 1 else self.seed)

    def unquantised(self) -> Job | None:
        """The nearest job before this one that is no quantised row: what losses are against."""
        before = self.before()
        while before is not None and before.row.group == "quantised":
            before = before.before()
        return before

    def folder(self, runs: Path) -> Path:
        """Of checkpoints and logs."""
        return runs / self.key

    def config(self, runs: Path) -> TrainConfig:
        """The training run.

        Raises:
            ValueError: the configuration or a change to it is wrong.
        """
        changes = {
            "data.root": str(self.plan.training.data),
            **self.row.set,
            "run.seed": self.seed,
            "run.out": str(self.folder(runs)),
        }
        for key, job in (("run.init", self.before()), ("quant.teacher", self.teacher())):
            if job is not None:
                changes[key] = str(job.folder(runs) / MODEL)
        return load_config(self.row.config, changes)

    def state(self, runs: Path, results: Path) -> str:
        """``finished``, ``trained``, ``interrupted`` or ``waiting``, from the files that are there."""
        if (results / self.key / RESULT).is_file():
            return "finished"
        return (
            "trained"
            if self.trained(runs)
            else "interrupted"
            if (self.folder(runs) / LAST).is_file()
            else "waiting"
        )

    def trained(self, runs: Path) -> bool:
        """Whether its training came to its end; a network without a checkpoint was trained elsewhere."""
        last = self.folder(runs) / LAST
        if not last.is_file():
            return (self.folder(runs) / MODEL).is_file()
        about, schedule = read_tensors(last)[1]["state"], self.config(runs).schedule
        timed = bool(schedule.max_minutes) and about["minutes"] >= schedule.max_minutes
        return bool(about["step"] >= schedule.steps or timed)


def read_plan(path: Path = PLAN) -> Plan:
    """The rows of a file.

    Raises:
        ValueError: no such file, not TOML, a field that is unknown, missing or out of range, a name that is there
            twice, or a row that continues or imitates one that does not stand before it or has several seeds but
            not all of its.
    """
    try:
        table = tomllib.loads(path.read_text())
        entries = table["row"]
        scoring, training = (
            Source(Path(table[name]["data"]), Path(table[name]["recipe"])) for name in ("scoring", "training")
        )
    except FileNotFoundError:
        raise ValueError(
            f"{path}: no such plan; run this in the repository or name one with --plan"
        ) from None
    except (tomllib.TOMLDecodeError, KeyError, TypeError) as error:
        raise ValueError(f"{path}: not a plan ({error})") from None
    try:
        refined = Refined(**table.get("refined", {}))
    except (TypeError, ValueError) as error:
        raise ValueError(f"{path}: [refined] needs looks and edges alone ({error})") from None
    rows: dict[str, Row] = {}
    for entry in entries:
        row = _row(path, entry)
        if row.name in rows:
            raise ValueError(f"{path}: row {row.name!r} is there twice")
        for verb, other in (("continues", row.after), ("imitates", row.teacher)):
            if other and not (other in rows and _has_one_for_each(rows[other], row)):
                raise ValueError(
                    f"{path}: row {row.name!r} {verb} {other!r}, which must stand before it, with its seeds or "
                    "with one alone"
                )
        if row.teacher and rows[row.teacher].group == "quantised":
            raise ValueError(f"{path}: row {row.name!r} imitates {row.teacher!r}, which is no float network")
        rows[row.name] = row
    return Plan(scoring, training, refined, tuple(rows.values()))


def _has_one_for_each(before: Row, row: Row) -> bool:
    """Whether ``before`` has a network for each seed of ``row``: its own, or the only one there is."""
    return len(before.seeds) == 1 or set(row.seeds) <= set(before.seeds)


def _row(path: Path, entry: dict[str, Any]) -> Row:
    known = {f.name for f in fields(Row)}
    if unknown := sorted(set(entry) - known):
        raise ValueError(
            f"{path}: a row has the unknown field {unknown[0]!r}; known are {', '.join(sorted(known))}"
        )
    if missing := sorted({"name", "title", "group", "config"} - set(entry)):
        raise ValueError(f"{path}: a row has no {missing[0]}")
    if entry["group"] not in GROUPS:
        raise ValueError(f"{path}: group must be one of {', '.join(GROUPS)}, not {entry['group']!r}")
    return Row(
        **{**entry, "config": Path(entry["config"]), "seeds": tuple(entry.get("seeds", (DEFAULT_SEED,)))}
    )


def read_result(folder: Path) -> dict[str, Any]:
    """``result.json`` of a finished job.

    Raises:
        ValueError: missing or not JSON.
    """
    table = read_json(folder / RESULT)
    if not isinstance(table, dict):
        raise ValueError(f"{folder / RESULT}: not a result; remove the folder and run the row again")
    return table
