"""What a record keeps of an evaluation: shares by range, and the errors frame by frame."""

from __future__ import annotations

from typing import Any

from macram.pose import Evaluation
from macram.train.checkpoint import Card

FRAME_COLUMNS = ("frame", "range", "z_d", "add_d", "re_deg", "te_d")


def scores(evaluation: Evaluation) -> dict[str, Any]:
    """Frames, misses, and for each range of depth the frames and the shares within the thresholds, percent."""
    summary = evaluation.summary
    return {
        "frames": summary["frames"],
        "misses": summary["misses"],
        "ranges": {
            name: {"frames": table["frames"], "add": table["add"], "adi": table["adi"], "proj": table["proj"]}
            for name, table in summary["fixed"].items()
        },
    }


def score_form(card: Card) -> str:
    """What of the network was scored, in words."""
    return f"{card.bits} bit, mode {card.mode}, training graph" if card.mode else "float32"


def frames_csv(evaluation: Evaluation) -> str:
    """Errors frame by frame, five digits; empty where nothing was found."""
    diameter = evaluation.summary["diameter_mm"]
    lines = [",".join(FRAME_COLUMNS)]
    for row in evaluation.rows:
        te = None if row["te_mm"] is None else row["te_mm"] / diameter
        numbers = (row["z_d"], row["add_d"], row["re_deg"], te)
        lines.append(
            ",".join([row["frame"], row["fixed"], *("" if n is None else f"{n:.5g}" for n in numbers)])
        )
    return "\n".join(lines) + "\n"
