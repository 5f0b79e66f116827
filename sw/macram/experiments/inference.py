"""What was tried at inference, without training: every setting on the validation split, few on the test split.

The box of visible edges is measured on the training split from true poses, without a network.
"""

from __future__ import annotations

import hashlib
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from macram.data.files import read_json
from macram.data.frame import Frame
from macram.data.open import dataset_version, open_dataset
from macram.pose import (
    EdgeSettings,
    LevelCells,
    LookSettings,
    Pose,
    PoseSettings,
    RansacSettings,
    refine_on_edges,
)
from macram.pose.evaluation import BUCKETS
from macram.pose.warp import Image
from macram.report.files import write_json
from macram.train.checkpoint import load_model
from macram.train.pack import thinned
from macram.train.predict import Predictor, evaluate_frames
from macram.weights import sha256

TRIES = "inference-*.json"
SPLITS = ("validation", "testing")
MEASURING = EdgeSettings(nearer=1.0, outward=0.0)
"""How the box of edges is measured from true poses."""
MEASURED_ON = 250
"""Training frames that the box of edges is measured on."""


def tries_file(model: Path, *, integer: bool) -> str:
    """Name of a network's record: of the folder of its run."""
    return TRIES.replace("*", f"{model.resolve().parent.name}{'-integers' if integer else ''}")


@dataclass(frozen=True, slots=True)
class Try:
    """One setting.

    Attributes:
        name: as the table calls it.
        settings: of the solver; the box of its edges is replaced by the measured one unless ``own_box``.
        options: of ``macram evaluate`` that ask for it; empty where none do.
        tested: whether it is scored on the test split as well.
        own_box: keep the box of ``settings``.
    """

    name: str
    settings: PoseSettings
    options: str = ""
    tested: bool = False
    own_box: bool = False

    def with_box(self, box: float) -> PoseSettings:
        """The settings, edges on the measured ``box`` unless they have their own."""
        edges = self.settings.edges
        if edges is None or self.own_box:
            return self.settings
        return replace(self.settings, edges=replace(edges, box=box))


def _edges(**changes: Any) -> PoseSettings:
    return PoseSettings(edges=EdgeSettings(**changes))


def _looks(edges: bool = False, **changes: Any) -> PoseSettings:
    return PoseSettings(looks=LookSettings(**changes), edges=EdgeSettings() if edges else None)


ALL = (
    Try("as published", PoseSettings(published=True, ransac=RansacSettings(refine=False)), "--published"),
    Try("single look, the recorded procedure", PoseSettings(), "(default)", tested=True),
    Try("one voting cell", PoseSettings(total=1)),
    Try("5 voting cells", PoseSettings(total=5)),
    Try("20 voting cells", PoseSettings(total=20)),
    Try("cells from a probability of 0.1", PoseSettings(confidence=0.1)),
    Try("inliers within 2 px", PoseSettings(ransac=RansacSettings(threshold_px=2.0))),
    Try("inliers within 10 px", PoseSettings(ransac=RansacSettings(threshold_px=10.0))),
    Try("1,000 rounds of RANSAC", PoseSettings(ransac=RansacSettings(iterations=1000, confidence=0.9999))),
    Try("4 looks", _looks(), "--looks 4", tested=True),
    Try("4 looks, target 40 px", _looks(size=40)),
    Try("4 looks, target 80 px", _looks(size=80)),
    Try("8 looks", _looks(turns=8), "--looks 8"),
    Try("edges, box of the keypoints, from the keypoints' depth", _edges(nearer=1.0), own_box=True),
    Try("edges, from the keypoints' depth", _edges(nearer=1.0)),
    Try("edges, outline not preferred", _edges(outward=0.0)),
    Try("edges", _edges(), "--edges BOX", tested=True),
    Try("edges, from 3 % nearer", _edges(nearer=0.97)),
    Try("edges, from 7 % nearer", _edges(nearer=0.93)),
    Try("edges, smoothing of 1 px", _edges(blur_px=1.0)),
    Try("edges, keypoints holding three times as fast", _edges(hold=0.033)),
    Try("edges, reach doubled at first", _edges(reach=(0.12, 0.06, 0.04, 0.025))),
    Try("4 looks, edges", _looks(edges=True), "--looks 4 --edges BOX", tested=True),
    Try("8 looks, edges", _looks(edges=True, turns=8), "--looks 8 --edges BOX", tested=True),
)  # fmt: skip


class _Remembering(Predictor):
    """A predictor that runs no picture twice, but counts the network's time whenever it is asked.

    Attributes:
        spent: CPU seconds that its answers cost when they were computed.
        computed: CPU seconds of computing.
    """

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.spent = self.computed = 0.0
        self._known: dict[bytes, tuple[list[LevelCells], float]] = {}

    def levels(self, images: Sequence[Image]) -> list[list[LevelCells]]:
        """As the predictor's."""
        keys = [
            image.shape[0].to_bytes(4, "big") + hashlib.sha256(image.tobytes()).digest() for image in images
        ]
        new = {key: image for key, image in zip(keys, images, strict=True) if key not in self._known}
        if new:
            start = time.process_time()
            outputs = super().levels(list(new.values()))
            taken = time.process_time() - start
            self.computed += taken
            self._known |= {key: (cells, taken / len(new)) for key, cells in zip(new, outputs, strict=True)}
        self.spent += sum(self._known[key][1] for key in keys)
        return [self._known[key][0] for key in keys]


def edge_box(frames: list[Frame]) -> float:
    """Size of the box of visible edges, in boxes of the keypoints, by true poses.

    Edges inside the keypoints' box let an aligned box appear farther away than it is, by the same factor.
    """
    box = 1.0
    for _ in range(2):
        settings = replace(MEASURING, box=box)
        ratios = []
        for frame in frames:
            true = Pose(frame.rotation, frame.translation)
            found = refine_on_edges(frame.read_image(), true, frame.camera, frame.model.keypoints, settings)
            ratios.append(float(found.t[2, 0] / true.t[2, 0]))
        box /= float(np.median(ratios))
    return round(box, 4)


def try_all(
    model: Path,
    data: Path,
    out: Path,
    *,
    limit: int = 0,
    integer: bool = False,
    tries: Sequence[Try] = ALL,
    told: Callable[[str, int, int], None] | None = None,
) -> Path:
    """Scores every setting that the record does not have yet, by its name and numbers; written after each.

    What the record has beside them is left away: settings of that name which meant something else then.

    Args:
        model: ``model.safetensors`` of a network whose keypoints are a box's corners.
        data: data set with the splits training, validation and testing.
        out: the record; begun anew where it is of another network, data set or limit.
        limit: only so many frames of a split; 0 for all.
        integer: the deployed integers of a network in mode III, on the test split alone.
        tries: the settings.
        told: called with the name of a setting, the frames scored and their total.

    Raises:
        ValueError: a bad file, or keypoints that are no box.
    """
    dataset, (net, card) = open_dataset(data), load_model(model)
    about = {
        "format": 1,
        "network": model.resolve().parent.name,
        "form": f"{card.bits} bit, deployed integers"
        if integer
        else "training graph"
        if card.mode
        else "float32",
        "model_sha256": sha256(model),
        "dataset": dataset_version(data),
        "limit": limit,
    }
    out.parent.mkdir(parents=True, exist_ok=True)
    record = read_json(out) if out.is_file() else {}
    if any(record.get(key) != value for key, value in about.items()):
        record = {**about, "rows": []}
    measured = PoseSettings(edges=MEASURING).to_dict()["edges"]
    if record.get("edge_box_settings") != measured:
        box = edge_box(thinned(dataset.frames("training"), MEASURED_ON))
        record |= {"edge_box": box, "edge_box_frames": MEASURED_ON, "edge_box_settings": measured}
        write_json(out, record)
    wanted = {entry.name: entry for entry in tries}
    known = {
        (row["name"], row["split"]): {**row, "options": wanted[row["name"]].options}
        for row in record["rows"]
        if row["name"] in wanted and is_of(row, wanted[row["name"]], record["edge_box"])
    }
    for split in SPLITS[1:] if integer else SPLITS:
        frames = thinned(dataset.frames(split), limit)
        predictor = _Remembering(net, card, integer=integer)
        for entry in tries:
            if (entry.name, split) in known or (split == "testing" and not entry.tested):
                continue
            settings = entry.with_box(record["edge_box"])
            known[entry.name, split] = _row(predictor, settings, entry, split, frames, told)
            _write(out, record, known, tries)
    _write(out, record, known, tries)
    return out


def is_of(row: dict[str, Any], entry: Try, box: float) -> bool:
    """Whether a record's row was scored by the numbers that ``entry`` stands for now."""
    return bool(row.get("settings") == entry.with_box(box).to_dict())


def _write(
    out: Path, record: dict[str, Any], known: dict[tuple[str, str], dict[str, Any]], tries: Sequence[Try]
) -> None:
    places = ((entry.name, split) for split in SPLITS for entry in tries)
    write_json(out, {**record, "rows": [known[place] for place in places if place in known]})


def _row(
    predictor: _Remembering,
    settings: PoseSettings,
    entry: Try,
    split: str,
    frames: list[Frame],
    told: Callable[[str, int, int], None] | None,
) -> dict[str, Any]:
    name = f"{entry.name}, {split}"
    predictor.settings, predictor.spent = settings, 0.0
    known, start = predictor.computed, time.process_time()
    evaluation, _ = evaluate_frames(
        predictor, frames, None if told is None else lambda done, total: told(name, done, total)
    )
    # What was remembered costs its first time; what was computed now is in both clocks.
    seconds = time.process_time() - start - (predictor.computed - known) + predictor.spent
    table = evaluation.summary["fixed"]
    return {
        "name": entry.name,
        "options": entry.options,
        "settings": settings.to_dict(),
        "split": split,
        "frames": table["all"]["frames"],
        "misses": table["all"]["misses"],
        "add": table["all"]["add"],
        "ranges": {bucket: table[bucket]["add"]["0.1"] for bucket in BUCKETS},
        "re_deg_median": table["all"]["re_deg_median"],
        "te_mm_median": table["all"]["te_mm_median"],
        "seconds": round(seconds / len(frames), 4),
    }
