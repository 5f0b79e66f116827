"""Files of one rendered sequence, in SwissCube's layout or SPEED's.

A sequence is written into a folder of its own and then renamed, so that it is there whole or not at all.
"""

from __future__ import annotations

import json
import shutil
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from macram.data.files import write_json, write_picture
from macram.data.geometry import quaternion_of_matrix
from macram.data.render.plan import View
from macram.data.render.sequence import Rendered, render_sequence
from macram.data.spec import SPLITS, RenderSpec

PART = ".part-"
"""Prefix of folders in which a sequence is being written."""

DONE = ".done"
"""Folder with one file per finished SPEED sequence, until the data set is complete."""


def done_path(root: Path, spec: RenderSpec, split: int, sequence: int) -> Path:
    """What is there once a sequence is finished."""
    if spec.format == "speed":
        return root / DONE / f"{SPLITS[split]}-{sequence:06d}.json"
    return root / SPLITS[split] / f"seq_{sequence:06d}"


def first_number(spec: RenderSpec, split: int) -> int:
    """Number of a split's first sequence; SwissCube counts on from split to split, and so do we."""
    return sum(spec.sequences[:split])


def write_sequence(root: Path, spec: RenderSpec, split: int, sequence: int, tick: Callable[[], None]) -> None:
    """Render one sequence into ``root``; ``tick`` is called after every frame and may raise to stop."""
    goal = done_path(root, spec, split, sequence)
    if goal.exists():
        return
    view = View(*spec.size, spec.focal)
    seed = (spec.seed, split, sequence - first_number(spec, split))
    frames = render_sequence(seed, spec.frames, view, spec.depth, spec.background)
    part = Path(tempfile.mkdtemp(prefix=PART, dir=root))
    try:
        part.chmod(0o755)
        write = _write_speed if spec.format == "speed" else _write_bop
        write(root, part, spec, split, sequence, frames, tick)
    finally:
        shutil.rmtree(part, ignore_errors=True)


def _write_bop(
    root: Path,
    part: Path,
    spec: RenderSpec,
    split: int,
    sequence: int,
    frames: Iterator[Rendered],
    tick: Callable[[], None],
) -> None:
    folder = part / "sequence/000000"
    for name in ("rgb", "mask_visib", *(["background"] if spec.background else [])):
        (folder / name).mkdir(parents=True)
    camera = View(*spec.size, spec.focal).matrix.ravel().tolist()
    cameras, poses, infos = {}, {}, {}
    for number, frame in enumerate(frames):
        write_picture(folder / f"rgb/{number:06d}.jpg", frame.image)
        write_picture(
            folder / f"mask_visib/{number:06d}_000000.png", np.where(frame.mask, 255, 0).astype(np.uint8)
        )
        if frame.background is not None:
            write_picture(folder / f"background/{number:06d}.jpg", frame.background)
        cameras[str(number)] = {"cam_K": camera, "depth_scale": 1.0}
        poses[str(number)] = [
            {
                "cam_R_m2c": frame.rotation.ravel().tolist(),
                "cam_t_m2c": frame.translation.tolist(),
                "obj_id": 1,
            }
        ]
        infos[str(number)] = [_info(frame)]
        tick()
    for name, table in (("scene_camera", cameras), ("scene_gt", poses), ("scene_gt_info", infos)):
        lines = ",\n".join(f' "{key}": {json.dumps(value)}' for key, value in table.items())
        (folder / f"{name}.json").write_text(f"{{\n{lines}\n}}\n")
    goal = done_path(root, spec, split, sequence)
    goal.parent.mkdir(exist_ok=True)
    (part / "sequence").rename(goal)


def _info(frame: Rendered) -> dict[str, Any]:
    rows, columns = np.flatnonzero(frame.mask.any(axis=1)), np.flatnonzero(frame.mask.any(axis=0))
    visible = [-1, -1, -1, -1]
    if len(rows):
        x, y = int(columns[0]), int(rows[0])
        visible = [x, y, int(columns[-1]) - x + 1, int(rows[-1]) - y + 1]
    return {
        "bbox_obj": list(frame.extent),
        "bbox_visib": visible,
        "px_count_visib": int(frame.mask.sum()),
        "depth_bucket": frame.bucket,
        "sun_direction": frame.sun.tolist(),
    }


def _write_speed(
    root: Path,
    part: Path,
    spec: RenderSpec,
    split: int,
    sequence: int,
    frames: Iterator[Rendered],
    tick: Callable[[], None],
) -> None:
    folder = root / "images" / ("test" if SPLITS[split] == "testing" else "train")
    folder.mkdir(parents=True, exist_ok=True)
    (root / DONE).mkdir(exist_ok=True)
    entries = []
    for number, frame in enumerate(frames):
        name = f"img{sequence * spec.frames + number + 1:06d}.jpg"
        write_picture(part / name, np.asarray(cv2.cvtColor(frame.image, cv2.COLOR_RGB2GRAY), np.uint8))
        entries.append(
            {
                "filename": name,
                "q_vbs2tango": np.round(quaternion_of_matrix(frame.rotation), 12).tolist(),
                "r_Vo2To_vbs_true": np.round(frame.translation / 1000, 9).tolist(),
            }
        )
        tick()
    for entry in entries:
        (part / entry["filename"]).rename(folder / entry["filename"])
    write_json(done_path(root, spec, split, sequence), entries)
