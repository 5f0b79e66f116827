"""Poses of many frames by several processes: the solver, not the network, is what a GPU's host waits for."""

from __future__ import annotations

import multiprocessing
import os
import signal
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import cache, partial
from pathlib import Path

import cv2
import torch

from macram.data.frame import Frame
from macram.pose import Detection, PoseSettings
from macram.train.predict import BATCH, Predictor

MOST_PROCESSES = 8
"""Each has the network in memory of its own and takes seconds to start."""


def detect_frames(
    model: Path,
    frames: Sequence[Frame],
    device: str,
    settings: PoseSettings,
    told: Callable[[int, int], None] | None = None,
) -> list[Detection | None]:
    """What a network finds in each frame; on a CPU the same to the last bit for any number of processes.

    For that each has one thread, on whose number the sums of a convolution depend.

    Args:
        model: ``model.safetensors`` of a run.
        frames: any number.
        device: that every process runs the network on, ``cpu`` or ``cuda:0``.
        settings: how outputs become a pose.
        told: called with the number of frames done and their total.

    Raises:
        ValueError: a bad file, or edges of a target that is no box.
    """
    # Parts are the network's batches of a single process, so that every sum is the same sum.
    parts = [frames[start : start + BATCH] for start in range(0, len(frames), BATCH)]
    processes = min(len(os.sched_getaffinity(0)), len(parts), MOST_PROCESSES)
    if processes <= 1:
        predictor = Predictor.load(model, torch.device(device), settings=settings)
        threads = torch.get_num_threads()
        torch.set_num_threads(1)
        try:
            return _gathered((_detect(predictor, part) for part in parts), len(frames), told)
        finally:
            torch.set_num_threads(threads)
    pool = ProcessPoolExecutor(processes, multiprocessing.get_context("spawn"), _start_worker)
    try:
        return _gathered(pool.map(partial(_work, model, device, settings), parts), len(frames), told)
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


def _gathered(
    parts: Iterable[list[Detection | None]], total: int, told: Callable[[int, int], None] | None
) -> list[Detection | None]:
    found: list[Detection | None] = []
    for part in parts:
        found += part
        if told is not None:
            told(len(found), total)
    return found


def _start_worker() -> None:
    # The terminal sends Ctrl-C to everybody; the parent alone decides.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    torch.set_num_threads(1)
    cv2.setNumThreads(1)


@cache
def _predictor(model: Path, device: str, settings: PoseSettings) -> Predictor:
    """A worker's own, loaded once."""
    return Predictor.load(model, torch.device(device), settings=settings)


def _work(
    model: Path, device: str, settings: PoseSettings, frames: Sequence[Frame]
) -> list[Detection | None]:
    return _detect(_predictor(model, device, settings), frames)


def _detect(predictor: Predictor, frames: Sequence[Frame]) -> list[Detection | None]:
    return list(predictor.detections([(frame.read_image(), frame.camera) for frame in frames]))
