"""Notices the step at which a run stops making sense."""

from __future__ import annotations

import torch
from torch import Tensor


class Watch:
    """Remembers the first step whose loss or gradient is no number.

    The answer stays on the device until `check` asks for it, so that a GPU is not made to wait at every step.

    Args:
        device: of the values.
    """

    def __init__(self, device: torch.device) -> None:
        self.free = device.type == "cpu"
        self._step = torch.zeros((), dtype=torch.int64, device=device)
        self._values = torch.zeros(2, device=device)

    def note(self, step: int, loss: Tensor, norm: Tensor) -> None:
        """Looks at one step; where looking is free, `check` follows at once.

        Args:
            step: its number, from 1.
            loss: the sum of the losses.
            norm: of all gradients.

        Raises:
            RuntimeError: see `check`.
        """
        values = torch.stack((loss.detach().float(), norm.detach().float()))
        new = ~torch.isfinite(values).all() & (self._step == 0)
        # torch.where would copy the number, and the GPU would wait for it.
        self._step = self._step + new * step
        self._values = torch.where(new, values, self._values)
        if self.free:
            self.check()

    def check(self) -> None:
        """Speaks up if a step went wrong since the run began.

        Raises:
            RuntimeError: with the first such step and what to do.
        """
        if step := int(self._step):
            loss, norm = self._values.tolist()
            raise RuntimeError(
                f"step {step} has loss {loss:g} and gradient norm {norm:g}; the last checkpoint stays as it was: start "
                'a new run with a lower optimiser.lr or optimiser.clip, or with run.precision = "fp32"'
            )
