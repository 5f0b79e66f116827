"""An integer program whose convolutions all run on the simulated array; the host keeps sums and tables."""

from __future__ import annotations

import hashlib
import json
import zipfile
import zlib
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from macram.layer_job import COUNTERS
from macram.network.steps import ArrayStep, array_steps
from macram.quant.program import AccumulateOp, AddOp, Codes, LookupOp, Program, golden_tensor
from macram.report.files import write_npz
from macram.spec import ArrayConfig

if TYPE_CHECKING:
    from torch import Tensor

    from macram_sim.hosted import HostedResult


FIGURES = ("cycles", *COUNTERS, "elapsed")


class ArrayNetwork:
    """Stands in for `macram.quant.DeployedNetwork` where a `macram.train.predict.Predictor` runs one.

    Every convolution's input is what the array gave before, through the host's integer sums and tables. What a run
    gives is kept in ``folder``: a network that was stopped goes on behind the last convolution that is whole there.

    Attributes:
        program: what is run.
        steps: its convolutions.
        tensors: every tensor of the last image by name, from the array's own results.
        runs: of every convolution of the last image by name: the array's counters, and ``elapsed`` cycles with loads
            and register accesses.

    Args:
        program: from `macram.quant.lower_network`.
        array: to run it on.
        folder: of the results that are kept.
        design: `macram.synth.sources.design_hash` of the array; other Verilog, other results.
        told: called with the number of convolutions that are done and the share of the next one's present run, also
            from another thread.

    Raises:
        ValueError: a convolution that the array does not run.
    """

    def __init__(
        self,
        program: Program,
        array: ArrayConfig,
        folder: Path,
        design: str,
        told: Callable[[int, float], None] | None = None,
    ) -> None:
        self.program = program
        self.steps: list[ArrayStep] = array_steps(program, array)
        self.tensors: dict[str, Codes] = {}
        self.runs: dict[str, dict[str, int]] = {}
        self._folder, self._design, self._told = folder, design, told

    def accumulators(self, codes: Tensor) -> dict[str, Tensor]:
        """As of `macram.quant.DeployedNetwork`: ``[C, H, W]`` codes of the input -> the sums that the host needs."""
        import torch  # noqa: PLC0415

        tensors = self.run(codes.numpy())
        names = [op.name for op in self.program.ops if isinstance(op, AccumulateOp)]
        return {name: torch.from_numpy(tensors[name]) for name in names}

    def run(self, codes: NDArray[np.integer]) -> dict[str, Codes]:
        """Every tensor of the program by name, int64, the input first.

        Args:
            codes: of the input.

        Raises:
            ValueError: ``codes`` do not fit the program's input.
            RuntimeError: the simulation failed.
        """
        from macram_sim.hosted import simulate_hosted  # noqa: PLC0415

        self.program.check_input(codes)
        self.tensors = {self.program.input: codes.astype(np.int64)}
        self.runs = {}
        kept = self._folder / self._key(codes)
        kept.mkdir(parents=True, exist_ok=True)
        whole = self._take_over(kept)
        steps = self.steps[whole:]
        order = [(step, index) for step in steps for index in range(len(step.passes))]
        found: list[HostedResult] = []

        def next_image(at: int) -> NDArray[np.int64]:
            step, index = order[at]
            self._host_until(step)
            channels = step.channels[index]
            return self.tensors[step.op.source][channels.start : channels.stop]

        def done(at: int, result: HostedResult) -> None:
            step, index = order[at]
            found.append(result)
            if index + 1 == len(step.passes):
                self._finish(step, found)
                write_npz(
                    kept / f"{step.op.name}.npz",
                    codes=self.tensors[step.op.name],
                    runs=np.array(list(self.runs[step.op.name].values())),
                )
                found.clear()
                self._tell(len(self.runs))

        if order:
            layers = [step.passes[index] for step, index in order]
            simulate_hosted(layers, next_image, done, told=lambda share: self._tell(len(self.runs), share))
        self._host_until(None)
        return self.tensors

    def _take_over(self, kept: Path) -> int:
        """Results of an earlier run; how many convolutions it had done."""
        for count, step in enumerate(self.steps):
            try:
                with np.load(kept / f"{step.op.name}.npz") as parts:
                    self.tensors[step.op.name] = parts["codes"]
                    self.runs[step.op.name] = dict(zip(FIGURES, parts["runs"].tolist(), strict=True))
            except (OSError, EOFError, ValueError, KeyError, zipfile.BadZipFile, zlib.error):
                return count  # missing or damaged
            self._host_until(step)
            self._tell(count + 1)
        return len(self.steps)

    def _finish(self, step: ArrayStep, found: Sequence[HostedResult]) -> None:
        self.tensors[step.op.name] = step.tensor([result.codes for result in found])
        figures = [result.counters | {"elapsed": result.elapsed} for result in found]
        self.runs[step.op.name] = {name: sum(figure[name] for figure in figures) for name in FIGURES}

    def _host_until(self, step: ArrayStep | None) -> None:
        """The host's own operations in front of a convolution, or to the end."""
        for op in self.program.ops:
            if step is not None and op is step.op:
                return
            if isinstance(op, LookupOp | AddOp) and op.name not in self.tensors:
                self.tensors[op.name] = golden_tensor(op, self.tensors)

    def _tell(self, done: int, share: float = 0.0) -> None:
        if self._told is not None:
            self._told(done, share)

    def _key(self, codes: NDArray[np.integer]) -> str:
        """Of everything that decides the results: Verilog, weights, requantisers, input."""
        digest = hashlib.sha256(self._design.encode())
        digest.update(np.ascontiguousarray(codes, np.int64).tobytes())
        for step in self.steps:
            for packed in step.passes:
                digest.update(json.dumps([step.op.name, repr(packed.spec), packed.sums_out]).encode())
                digest.update(packed.weights.tobytes() + packed.requant.tobytes())
            digest.update(step.op.scale.tobytes() + step.op.offset.tobytes())
        for op in self.program.ops:
            if isinstance(op, LookupOp | AddOp):
                digest.update(op.table.tobytes())
        return digest.hexdigest()[:16]


def differences(network: ArrayNetwork, deployed: dict[str, Codes]) -> list[dict[str, Any]]:
    """Every convolution's tensor from the array against the deployed network's.

    Args:
        network: after a run.
        deployed: tensors of the same image by name.

    Returns:
        One row per convolution, JSON types: shape, formats, cycles, ``compared`` and ``mismatches``.
    """
    rows = []
    for step in network.steps:
        op, spec = step.op, step.op.spec
        produced, expected = network.tensors[op.name], deployed[op.name]
        rows.append(
            {
                "name": op.name, "c_in": spec.c_in, "c_out": spec.c_out, "height": spec.height,
                "width": spec.width, "kernel": spec.kernel, "stride": spec.stride, "macs": spec.macs,
                "input": str(spec.input), "output": str(spec.output), "sums": step.as_sums,
                "passes": len(step.passes), "estimated": step.cycles, "exact": step.exact,
                **network.runs[op.name],
                "compared": expected.size, "mismatches": int(np.count_nonzero(produced != expected)),
            }
        )  # fmt: skip
    return rows
