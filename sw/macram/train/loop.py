"""One training run from configuration to checkpoint."""

from __future__ import annotations

import copy
import math
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import torch
from rich.console import Console
from torch import Tensor, nn

from macram.data.files import write_picture
from macram.quant import calibrate_steps
from macram.train.checkpoint import (
    optimiser_tensors,
    read_tensors,
    restore_optimiser,
    save_model,
    write_tensors,
)
from macram.train.config import TrainConfig, completed
from macram.train.distributed import Processes, share_batch_norm
from macram.train.feed import Feed
from macram.train.fused import fuse_batch_norm
from macram.train.logs import Bar, Log
from macram.train.lsq_cpu import fuse_quantizers
from macram.train.mixed import autocast_helps, exact_layers
from macram.train.narrow import narrow_convolutions
from macram.train.objective import Objective
from macram.train.optimiser import Follower, make_optimiser
from macram.train.pack import pack_frames
from macram.train.replay import Replay
from macram.train.resume import check_same_run, under
from macram.train.samples import score, validation_frames
from macram.train.schedule import crop_phase, learning_rate, progress
from macram.train.stages import Stage
from macram.train.stopping import Clock, stop_on_signal
from macram.train.warp import Batch, Cells
from macram.train.watch import Watch

LAST, MODEL = "last.safetensors", "model.safetensors"


class Run:
    """A run in progress.

    Args:
        config: everything about it.
        processes: this process among all.
        console: for progress; None for silence.
        resume: go on from the checkpoint in ``run.out``.

    Raises:
        ValueError: bad data or checkpoint; a checkpoint that would be overwritten, or none to resume.
    """

    def __init__(
        self, config: TrainConfig, processes: Processes, console: Console | None, *, resume: bool = False
    ) -> None:
        self.config, self.processes = config, processes
        self.console = console if processes.first else None
        self.folder = Path(config.run.out)
        found = (self.folder / LAST).is_file()
        if resume and not found:
            raise ValueError(f"{self.folder / LAST}: no checkpoint to resume from")
        if found and not resume:
            raise ValueError(
                f"{self.folder / LAST}: there is a run already; add --resume or choose another run.out"
            )
        for key, source in (("run.init", config.run.init), ("quant.teacher", config.quant.teacher)):
            if source and Path(source).resolve() == (self.folder / MODEL).resolve():
                raise ValueError(f"{source}: {key} is what the run writes; choose another run.out")
        device = processes.device
        self.step, self.visits, self.minutes = 0, 0, 0.0
        if config.data.validation:  # now, not when the first scores are due
            validation_frames(self.config)
        self.frames = self._packed()
        self.stage = Stage(config, self.frames, device)
        if any(min(p.batch or config.schedule.batch for p in config.crops) < n for n in [processes.world]):
            raise ValueError(f"every batch needs an image for each of the {processes.world} processes")
        self.stage.module.to(device).to(memory_format=torch.channels_last)  # type: ignore[call-overload]
        self.feed = Feed(
            config,
            self.frames,
            processes,
            self.stage.net.config.levels,
            self.stage.augmentation(),
            counterfactual=self.stage.counterfactual,
        )
        self.watch = Watch(device)
        if self.stage.uncalibrated and not resume:
            calibrate_steps(self.stage.net, self.feed.plain(config.quant.calibration))
        keypoints = torch.tensor(self.stage.card.keypoints, device=device)
        self.objective = Objective(config.loss, self.stage.card.diameter, keypoints)
        processes.copy_first(self.stage.module)
        if processes.world > 1:
            share_batch_norm(self.stage.module)
        else:
            fuse_batch_norm(self.stage.module, device)
        if device.type == "cpu":
            narrow_convolutions(self.stage.module)
            fuse_quantizers(self.stage.module)
        named = [(n, p) for n, p in self.stage.module.named_parameters() if p.requires_grad]
        self.names: dict[Tensor, str] = {p: n for n, p in named}
        self.optimiser = make_optimiser(config.optimiser, [p for _, p in named])
        self.average = copy.deepcopy(self.stage.net) if config.optimiser.average else None
        self.follower = None if self.average is None else Follower(self.average, self.stage.net)
        if resume:
            self._restore()
        wanted = config.run.precision
        allowed = not self.stage.card.mode and autocast_helps(device)
        self.mixed = wanted == "bf16" or (wanted == "auto" and allowed)
        self.autocast = torch.autocast(device.type, torch.bfloat16, enabled=self.mixed)
        self.replay = None
        if device.type == "cuda" and processes.world == 1 and config.run.graphs:
            self.replay = Replay(self._backward, [p for _, p in named])

    def _packed(self) -> Any:
        config, filled = self.config, self.config.run.stage == "counterfactual"
        if not self.processes.first:
            self.processes.wait()  # until the first has filled the cache
        bar = Bar(self.console, 0, 0, "packing")
        frames = pack_frames(config.data, config.data.train, filled=filled, told=bar.packing)
        bar.close()
        if self.processes.first:
            self.processes.wait()
        return frames

    def train(self) -> Path:
        """Trains to the end, the time limit, or an interruption, and leaves a checkpoint.

        Returns:
            The network's file.

        Raises:
            RuntimeError: a loss or a gradient is no number; the last checkpoint stays.
            KeyboardInterrupt: interrupted; the checkpoint is written.
        """
        config, schedule, first = self.config, self.config.schedule, self.processes.first
        if first:
            self.folder.mkdir(parents=True, exist_ok=True)
        log = Log(self.folder, self.step) if first else None
        bar = Bar(self.console, schedule.steps, self.step, config.run.stage)
        clock = Clock(self.minutes)
        saved = scored = self.minutes
        sums: dict[str, Tensor] = {}
        since, counted, summed = time.monotonic(), 0, 0
        with stop_on_signal() as stop, exact_layers(self.stage.module, self.processes.device):
            self.stage.module.train()
            while self.step < schedule.steps:
                self.minutes = clock.minutes
                if schedule.max_minutes or self.processes.world > 1:
                    self.minutes = self.processes.from_first(self.minutes)
                if schedule.max_minutes and self.minutes >= schedule.max_minutes:
                    break
                if self.processes.from_first(float(stop.is_set())):
                    break
                values, images = self._one_step()
                for name, value in values.items():
                    sums[name] = sums.get(name, torch.zeros_like(value)) + value
                counted, summed = counted + images, summed + 1
                bar.advance(self.step)
                if self.step % config.log.every and self.step < schedule.steps:
                    continue
                self.watch.check()
                means = {name: float(value) / summed for name, value in sums.items()}
                means["loss"] = sum(means.get(n, 0.0) for n in self.loss_names)
                now = time.monotonic()
                rate = counted / max(now - since, 1e-9)
                left = self._seconds_left(clock.minutes)
                bar.update(self.step, means["loss"], rate, left)
                row = {
                    "step": self.step,
                    "visits": self.visits,
                    "minutes": clock.minutes,
                    "img_s": rate,
                    "loading": 100 * self.feed.seconds / max(now - since, 1e-9),
                    **means,
                }
                sums, counted, summed, self.feed.seconds = {}, 0, 0, 0.0
                every = config.log.evaluate_minutes
                if first and every and clock.minutes - scored >= every:
                    row |= self._score(log)
                    scored = clock.minutes
                if first and log is not None:
                    log.line(row)
                if first and clock.minutes - saved >= config.log.checkpoint_minutes:
                    self.minutes = clock.minutes
                    self.save()
                    saved = clock.minutes
                self.processes.wait()
                since = time.monotonic()
            self.minutes = clock.minutes
            if first:
                self.save()
        if first and log is not None:
            if config.data.validation and not stop.is_set():
                log.line(
                    {"step": self.step, "visits": self.visits, "minutes": clock.minutes} | self._score(log)
                )
            log.close()
        bar.close()
        self.processes.wait()
        if stop.is_set():
            raise KeyboardInterrupt
        return self.folder / MODEL

    def _one_step(self) -> tuple[dict[str, Tensor], int]:
        schedule = self.config.schedule
        done = progress(schedule, self.step, self.minutes)
        images = crop_phase(self.config, done).batch or schedule.batch
        batch, cells, side = self._next_batch(images, done)
        losses = self._gradients(batch, cells, images, surface=done < self.config.surface_until)
        rate = learning_rate(schedule, self.config.optimiser.lr, self.step, done)
        norm = self._update(rate, torch.stack(list(losses.values())).sum())
        self.visits += images
        return losses | {
            "grad_norm": norm,
            "lr": torch.tensor(rate),
            "size": torch.tensor(float(side)),
        }, images

    def _next_batch(self, images: int, done: float) -> tuple[Batch, Cells, int]:
        """This process's part of the step's views, their cells, their height."""
        return self.feed.batch(self.step, self.visits, images, done)

    def _gradients(self, batch: Batch, cells: Cells, images: int, *, surface: bool) -> dict[str, Tensor]:
        """Forward and backward: losses by name, gradients of all processes."""
        if self.replay is None:
            self.optimiser.zero_grad(set_to_none=True)
            losses = self._backward(batch, cells, images, surface)
        else:
            losses = self.replay(batch, cells, images, surface)
        self.loss_names = tuple(losses)
        self.processes.sum_gradients(self.names)  # type: ignore[arg-type]
        return losses

    def _backward(self, batch: Batch, cells: Cells, images: int, surface: bool) -> dict[str, Tensor]:
        with self.autocast:
            losses = self.stage.losses(self.objective, batch, cells, images, surface=surface)
        torch.stack(list(losses.values())).sum().backward()  # type: ignore[no-untyped-call]
        return {name: value.detach() for name, value in losses.items()}

    def _update(self, rate: float, loss: Tensor) -> Tensor:
        """One step of the optimiser; the norm that the gradients had."""
        for group in self.optimiser.param_groups:
            group["lr"] = rate
        norm = nn.utils.clip_grad_norm_(self.names, self.config.optimiser.clip or math.inf)
        self.watch.note(self.step + 1, loss, norm)
        self.optimiser.step()
        self.step += 1
        if self.follower is not None:
            self.follower.follow(self.config.optimiser.average, self.step)
        return norm

    def _seconds_left(self, minutes: float) -> float:
        done = max(self.step / self.config.schedule.steps, 1e-9)
        left = minutes * (1 / done - 1)
        if self.config.schedule.max_minutes:
            left = min(left, self.config.schedule.max_minutes - minutes)
        return 60 * left

    @property
    def result(self) -> Any:
        """The network to evaluate and to ship: averaged, if the run averages."""
        return self.stage.net if self.average is None else self.average

    def save(self) -> None:
        """Writes both files, each in one step.

        Raises:
            RuntimeError: a step since the last time went wrong; nothing is written.
        """
        self.watch.check()
        tensors = {f"net/{name}": value for name, value in self.stage.module.state_dict().items()}
        if self.average is not None:
            tensors |= {f"average/{name}": value for name, value in self.average.state_dict().items()}
        remembered = optimiser_tensors(self.optimiser, self.names)
        tensors |= {f"optimiser/{name}": value for name, value in remembered.items()}
        about = {"step": self.step, "visits": self.visits, "minutes": self.minutes}
        write_tensors(self.folder / LAST, tensors, {"state": about, "config": self.config.to_dict()})
        record = {"config": self.config.to_dict(), "frames": len(self.frames), **about}
        card = replace(self.stage.card, history=(*self.stage.card.history, record))
        save_model(self.folder / MODEL, self.result, card)

    def _restore(self) -> None:
        path = self.folder / LAST
        tensors, header = read_tensors(path)
        check_same_run(path, self.config.to_dict(), completed(header["config"]))
        self.stage.module.load_state_dict(under(tensors, "net/"))
        if self.average is not None:
            self.average.load_state_dict(under(tensors, "average/"))
        restore_optimiser(self.optimiser, self.names, under(tensors, "optimiser/"))
        state = header["state"]
        self.step, self.visits, self.minutes = state["step"], state["visits"], state["minutes"]

    def _score(self, log: Log | None) -> dict[str, float]:
        """Accuracy on validation frames, and a sheet of pictures."""
        if not self.config.data.validation:
            return {}
        self.result.eval()
        frames = validation_frames(self.config)
        scores, sheet = score(frames, self.result, self.stage.card, self.processes.device)
        self.stage.module.train()
        (self.folder / "samples").mkdir(parents=True, exist_ok=True)
        write_picture(self.folder / "samples" / f"{self.step:07d}.jpg", sheet)
        if log is not None:
            log.picture("samples", sheet, self.step)
        return scores
