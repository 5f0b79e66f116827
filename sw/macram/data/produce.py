"""A whole rendered data set: sequences in parallel, resumable, the same for any number of processes."""

from __future__ import annotations

import contextlib
import hashlib
import multiprocessing
import os
import shutil
import signal
from collections.abc import Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from pathlib import Path
from typing import Any

import cv2

from macram.data.files import read_json, write_json, write_text
from macram.data.geometry import BUCKET_LIMITS
from macram.data.ply import ply_text
from macram.data.render.cubesat import DIAMETER_MM, NAME, SIZE_MM, corners, mesh
from macram.data.spec import SPLITS, RenderSpec
from macram.data.write import DONE, PART, done_path, first_number, write_sequence

MOST_JOBS = 256
"""A process takes 0.7 GB; more than these are a slip of the keyboard."""

_shared: dict[str, Any] = {}
"""A worker's frame counter and stop flag; set once when it starts."""


class _Stopped(Exception):
    """The parent was interrupted."""


def produce(root: Path, spec: RenderSpec, jobs: int = 1) -> Iterator[int]:
    """Render whatever is missing of a data set; yields the number of frames that are done, now and then.

    The first value counts what was there before. An interrupted run leaves finished sequences only, and the
    next run with the same specification goes on from them.

    Args:
        root: folder of the data set; created.
        spec: what to render.
        jobs: processes; the result does not depend on it.

    Raises:
        ValueError: ``root`` holds something else.
    """
    if not 1 <= jobs <= MOST_JOBS:
        raise ValueError(f"jobs must be 1 to {MOST_JOBS}, not {jobs}")
    complete = _open(root, spec)
    every = [
        (split, first_number(spec, split) + number)
        for split in range(len(SPLITS))
        for number in range(spec.sequences[split])
    ]
    missing = [] if complete else [task for task in every if not done_path(root, spec, *task).exists()]
    before = (len(every) - len(missing)) * spec.frames
    yield before
    if complete:
        return
    if missing:
        steps = _alone(root, spec, missing) if jobs == 1 else _together(root, spec, missing, jobs)
        for frames in steps:
            yield before + frames
    _finish(root, spec)
    yield spec.total


def _alone(root: Path, spec: RenderSpec, tasks: list[tuple[int, int]]) -> Iterator[int]:
    for number, task in enumerate(tasks, 1):
        write_sequence(root, spec, *task, tick=lambda: None)
        yield number * spec.frames


def _together(root: Path, spec: RenderSpec, tasks: list[tuple[int, int]], jobs: int) -> Iterator[int]:
    # Fresh processes: a fork would inherit the threads of OpenCV and BLAS in an unknown state.
    context = multiprocessing.get_context("spawn")
    counter, stop = context.Value("q", 0), context.Event()
    pool = ProcessPoolExecutor(
        min(jobs, len(tasks)), context, initializer=_start_worker, initargs=(counter, stop)
    )
    running: set[Future[None]] = set()
    with _single_threaded():
        try:
            running = {pool.submit(_work, root, spec, *task) for task in tasks}
            while running:
                done, running = wait(running, timeout=0.2, return_when=FIRST_COMPLETED)
                for future in done:
                    future.result()
                yield int(counter.value)
        finally:
            stop.set()
            pool.shutdown(wait=True, cancel_futures=True)


@contextlib.contextmanager
def _single_threaded() -> Iterator[None]:
    """Children see one BLAS thread each: the processes share the cores already."""
    names = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")
    before = {name: os.environ.get(name) for name in names}
    os.environ.update(dict.fromkeys(names, "1"))
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                os.environ.pop(name, None)
            else:
                os.environ[name] = value


def _start_worker(counter: Any, stop: Any) -> None:
    # The terminal sends Ctrl-C to everybody; the parent alone decides, and the flag tells the workers.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    cv2.setNumThreads(1)
    _shared.update(counter=counter, stop=stop)


def _work(root: Path, spec: RenderSpec, split: int, sequence: int) -> None:
    def tick() -> None:
        if _shared["stop"].is_set():
            raise _Stopped
        with _shared["counter"].get_lock():
            _shared["counter"].value += 1

    write_sequence(root, spec, split, sequence, tick)


def _open(root: Path, spec: RenderSpec) -> bool:
    """Claim ``root`` for ``spec``; whether it is complete already."""
    about = root / "dataset.json"
    if about.is_file():
        found = read_json(about)
        if not isinstance(found, dict) or found.get("spec_sha256") != spec.fingerprint():
            raise ValueError(
                f"{root}: holds a data set of another specification; choose another folder or remove it"
            )
        return bool(found.get("complete"))
    if root.exists() and (not root.is_dir() or any(root.iterdir())):
        raise ValueError(f"{root}: not empty and not a rendered data set; choose another folder")
    root.mkdir(parents=True, exist_ok=True)
    write_json(about, _about(spec, complete=False))
    return False


def _about(spec: RenderSpec, complete: bool) -> dict[str, Any]:
    return {
        "name": NAME,
        "version": f"{NAME}-v{spec.table()['generator']}",
        "complete": complete,
        "spec": spec.table(),
        "spec_sha256": spec.fingerprint(),
        "model": {"name": NAME, "size_mm": SIZE_MM.tolist(), "diameter_mm": round(DIAMETER_MM, 4)},
        "depth_buckets_diameters": list(BUCKET_LIMITS),
        "frames": {split: count * spec.frames for split, count in zip(SPLITS, spec.sequences, strict=True)},
    }


def _finish(root: Path, spec: RenderSpec) -> None:
    """Lists and model; ``dataset.json`` says complete last."""
    poses = hashlib.sha256()
    if spec.format == "speed":
        _finish_speed(root, spec, poses)
    else:
        _finish_bop(root, spec, poses)
    for left in root.glob(f"{PART}*"):
        shutil.rmtree(left, ignore_errors=True)
    write_json(root / "dataset.json", {**_about(spec, complete=True), "poses_sha256": poses.hexdigest()})


def _finish_bop(root: Path, spec: RenderSpec, poses: Any) -> None:
    for number, split in enumerate(SPLITS):
        lines = []
        for sequence in range(spec.sequences[number]):
            folder = done_path(root, spec, number, first_number(spec, number) + sequence) / "000000"
            poses.update((folder / "scene_gt.json").read_bytes())
            relative = folder.relative_to(root).as_posix()
            lines += [f"{relative}/rgb/{frame:06d}.jpg\n" for frame in range(spec.frames)]
        write_text(root / f"{split}.txt", "".join(lines))
    models = root / "models"
    models.mkdir(exist_ok=True)
    write_text(models / "obj_000001.ply", ply_text(*mesh()))
    low = dict(zip(("min_x", "min_y", "min_z"), (-SIZE_MM / 2).tolist(), strict=True))
    size = dict(zip(("size_x", "size_y", "size_z"), SIZE_MM.tolist(), strict=True))
    write_json(models / "models_info.json", {"1": {"diameter": round(DIAMETER_MM, 4), **low, **size}})
    write_json(root / f"{NAME}_bbox.json", [corners().tolist()])


def _finish_speed(root: Path, spec: RenderSpec, poses: Any) -> None:
    tables: dict[str, list[dict[str, Any]]] = {"train": [], "test": []}
    for number, split in enumerate(SPLITS):
        for sequence in range(spec.sequences[number]):
            path = done_path(root, spec, number, first_number(spec, number) + sequence)
            poses.update(path.read_bytes())
            entries = read_json(path)
            # As in the release: poses of the test part stay unpublished.
            tables["test" if split == "testing" else "train"] += (
                [{"filename": entry["filename"]} for entry in entries] if split == "testing" else entries
            )
    for name, table in tables.items():
        write_json(root / f"{name}.json", table)
    shutil.rmtree(root / DONE, ignore_errors=True)
