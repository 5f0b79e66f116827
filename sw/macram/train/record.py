"""What a trained network remembers of its stages, as commands that can be typed."""

from __future__ import annotations

import json
import shlex
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from macram.train.checkpoint import Card
from macram.train.config import completed, load_config

WHEREABOUTS = ("log", "run.out", "run.init", "data.root", "data.cache")
"""Settings that say where and how often, not what."""
NETWORKS = ("quant.teacher",)
"""Files of networks that differ if their last folders or their names do, wherever those folders are."""


def stage_records(card: Card, configs: Sequence[Path]) -> list[dict[str, Any]]:
    """One record per stage: command, seed, steps, images seen, minutes.

    Args:
        card: of the network.
        configs: the configuration files of its stages, in order; what a stage had otherwise becomes ``--set``.

    Raises:
        ValueError: not one file per stage, or a file of another stage.
    """
    if len(configs) != len(card.history):
        raise ValueError(
            f"the network had {len(card.history)} stages; give as many configurations, not {len(configs)}"
        )
    records: list[dict[str, Any]] = []
    for path, record in zip(configs, card.history, strict=True):
        config = record["config"]
        again = goes_on(card.history[: len(records) + 1])
        if (stage := load_config(path).run.stage) != config["run"]["stage"]:
            raise ValueError(f"{path}: is of stage {stage}, the network's was {config['run']['stage']}")
        records.append(
            {
                "stage": config["run"]["stage"],
                "command": train_command(path, config, ("run.init", "run.out") if again else ()),
                "seed": config["run"]["seed"],
                "steps": record["step"],
                "images": record["visits"],
                "minutes": round(record["minutes"], 2),
            }
        )
    return records


def goes_on(history: Sequence[Mapping[str, Any]]) -> bool:
    """Whether the last stage continues one of its own kind: its configuration alone starts from the one before that."""
    kinds = [record["config"]["run"]["stage"] for record in history[-2:]]
    return len(kinds) == 2 and kinds[0] == kinds[1]


def train_command(path: Path, config: Mapping[str, Any], named: Sequence[str] = ()) -> str:
    """``macram train PATH --set ...`` that gives ``config``, folders of this machine apart.

    Args:
        path: the configuration file.
        config: what the run had.
        named: settings to name though they say where: relative paths.
    """
    words, base = ["macram", "train", path.as_posix()], load_config(path)
    changes = differences(base.to_dict(), completed(config))
    for key in NETWORKS:
        if Path(changes.get(key, "")).is_absolute():
            del changes[key]
    root = Path(config["data"]["root"])
    if not root.is_absolute() and root != Path(base.data.root):
        changes["data.root"] = root.as_posix()
    for key in named:
        table, name = key.split(".")
        if not Path(config[table][name]).is_absolute():
            changes[key] = config[table][name]
    for key, value in sorted(changes.items()):
        words += ["--set", f"{key}={value if isinstance(value, str) else _toml(value)}"]
    return shlex.join(words)


def differences(base: Mapping[str, Any], other: Mapping[str, Any], prefix: str = "") -> dict[str, Any]:
    """Dotted keys of ``other`` whose values differ from those of ``base``, but for `WHEREABOUTS`; see also `NETWORKS`.

    Lists differ as a whole: that is how ``--set`` takes them.
    """
    found: dict[str, Any] = {}
    for key in sorted(base.keys() | other.keys()):
        name, mine, theirs = f"{prefix}{key}", base.get(key), other.get(key)
        if name in WHEREABOUTS or (name in NETWORKS and _last(mine) == _last(theirs)):
            continue
        if isinstance(mine, Mapping) and isinstance(theirs, Mapping):
            found |= differences(mine, theirs, f"{name}.")
        elif _plain(mine) != _plain(theirs):
            found[name] = _plain(theirs)
    return found


def _last(path: Any) -> tuple[str, ...]:
    return Path(path).parts[-2:]


def _plain(value: Any) -> Any:
    """As JSON has it: tuples are lists."""
    return json.loads(json.dumps(value))


def _toml(value: Any) -> str:
    """A JSON value as TOML's inline syntax."""
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{key} = {_toml(part)}" for key, part in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(_toml, value)) + "]"
    return json.dumps(value)
