"""The sections of ``docs/results.md`` on what rows were made with and what came of them: data, shipped networks."""

from __future__ import annotations

from pathlib import Path

from macram.data.files import read_json
from macram.data.geometry import BUCKETS
from macram.data.recipe import read_recipe
from macram.experiments.plan import Plan
from macram.experiments.sections import table
from macram.weights import read_index

MEBI = 2**20


def data(plan: Plan, results: Path) -> list[str]:
    """What the networks were trained and judged on."""
    about = read_json(results / "dataset.json")
    rows = [
        [
            name,
            f"{split['frames']:,}",
            str(split["sequences"]),
            " to ".join(f"{d:.2f}" for d in split["depth_diameters"]),
            *(str(split["buckets"][bucket]) for bucket in BUCKETS),
            " / ".join(str(split["mask_pixels"][p]) for p in ("p5", "p50", "p95")),
        ]
        for name, split in about["splits"].items()
    ]
    scoring, training = read_recipe(plan.scoring.recipe), read_recipe(plan.training.recipe)
    parts = [
        f"## Data\n\n`{scoring.name}`: `macram data render -o {plan.scoring.data} --recipe {plan.scoring.recipe}`; "
        f"statistics by `macram data info {plan.scoring.data} --json`. Depth in diameters of the target "
        f"({about['model']['diameter_mm']:g} mm).",
        table(["split", "frames", "sequences", "depth", *BUCKETS, "mask pixels at 5, 50, 95 %"], rows),
    ]
    if training != scoring:
        sequences = training.spec.sequences[0]
        parts.append(
            f"`{training.name}` (`--recipe {plan.training.recipe}`) has the same validation and testing pictures and "
            f"{sequences:,} training sequences, {sequences * training.spec.frames:,} frames: those of "
            f"`{scoring.name}` and more of the same generator. Rows name what they learned from; all are scored on "
            f"the test split of `{scoring.name}`."
        )
    return parts


def shipped(results: Path) -> list[str]:
    """The networks that come with macram."""
    networks = read_index(results.parent / "weights")["networks"]
    if not networks:
        return []
    rows = []
    for name, about in networks.items():
        sizes, scores = about["sizes"], about["scores"]
        rows.append([
            f"`{name}`", about["stored"], f"{sizes['parameters']:,}",
            *(f"{sizes[key] / MEBI:.3f}" for key in ("ideal", "codes", "floats", "header", "file")),
            *(f"{scores['add'][limit]:.2f}" for limit in ("0.1", "0.2", "0.5")), f"{scores['frames']:,}",
        ])  # fmt: skip
    return [
        "## Shipped networks\n\n`macram weights list`. Sizes in MB of 2^20 bytes: *ideal* is parameters "
        "times bits, as the paper's "
        "table V counts, of the float network 32; the file holds packed codes, what stays floating point, and a "
        "header. Scores are of the shipped file itself.",
        table(["name", "form", "parameters", "ideal", "codes", "floats", "header", "file",
                "ADD-0.1d %", "0.2d %", "0.5d %", "frames"], rows),
    ]  # fmt: skip
