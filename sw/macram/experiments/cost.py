"""What quantisation saves: the quantised rows as in the paper's table IV, their storage as in its table V."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from macram.experiments.finished import Finished
from macram.experiments.plan import RUNS
from macram.experiments.sections import paper_accuracy, table
from macram.model.counts import GIGA, MEBI, NetworkCounts, count_network
from macram.weights import read_index

CORNERS = 8
"""Keypoints of the rows' target."""


def costs(done: Sequence[Finished], cited: dict[str, Any], results: Path) -> list[str]:
    """Operations and accuracy by mode, storage by bits; empty without a quantised row.

    Args:
        done: all records.
        cited: figures of the paper.
        results: folder of records; the index of shipped networks lies beside it.
    """
    rows = [f for f in done if f.job.row.group == "quantised"]
    if not rows:
        return []
    trained = (rows[0].job.unquantised() or rows[0].job).config(RUNS).network
    settings = replace(trained, surface=False)  # a head for training alone
    counts = count_network(settings.build(CORNERS))
    side = settings.image_size
    return [
        f"As the paper's table IV, of the rows' own network ({settings.size} width, {side} x {side} pixels; "
        "multiply-accumulates of convolutions, and the share of them that codes take). The paper's column is its "
        "ADI-0.1d on SwissCube:",
        table(
            ["row", "on codes, G", "others, G", "share %", "ADD-0.1d %", "refined %", "paper %"],
            [_operations(f, counts, cited) for f in rows],
        ),
        "As its table V: parameters times bits, and what the shipped file takes with its header, both against 32 bits:",
        table(
            ["bits", "parameters", "MB", "saved %", "shipped as", "file, MB", "saved %"],
            _storage(counts, settings.size, results),
        ),
    ]


def _operations(f: Finished, counts: NetworkCounts, cited: dict[str, Any]) -> list[str]:
    codes, total = counts.quantised_macs(f.table["mode"]), counts.macs()
    refined = None if f.refined is None else f.refined.table["ranges"]["all"]["add"]["0.1"]
    return [
        f.job.row.title,
        f"{codes / GIGA:.3f}",
        f"{(total - codes) / GIGA:.3f}",
        f"{100 * codes / total:.2f}",
        f"{f.table['ranges']['all']['add']['0.1']:.2f}",
        *("-" if value is None else f"{value:.2f}" for value in (refined, paper_accuracy(f, cited))),
    ]


def _storage(counts: NetworkCounts, size: str, results: Path) -> list[list[str]]:
    networks = read_index(results.parent / "weights")["networks"].values()
    shipped = {network["bits"]: network for network in networks if network["size"] == size}
    lines = []
    for row in counts.storage:
        ideal = [f"{row['bits']}", f"{row['parameters']:,}", f"{row['size_bits'] / 8 / MEBI:.2f}"]
        packed = ["-", "-", "-"]
        if network := shipped.get(row["bits"]):
            share = network["bytes"] / (4 * row["parameters"])
            packed = [network["stored"], f"{network['bytes'] / MEBI:.2f}", f"{100 * (1 - share):.2f}"]
        lines.append([*ideal, f"{row['saving_percent']:.2f}", *packed])
    return lines
