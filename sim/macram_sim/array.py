"""One layer on the simulated array: export, build, run, codes back."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from functools import lru_cache
from importlib.metadata import version
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import macram.spec
import macram_hw
from macram.golden import ResidualRule
from macram.pack import PackedLayer
from macram.spec import ArrayConfig
from macram_sim.build import Build, SimulationError, build, waves_wanted
from macram_sim.folders import build_root, gone_if_interrupted, job_folder, locked
from macram_sim.progress import watching
from macram_sim.runner import choose_seed, run
from macram_sim.streams import PATTERNS

LOADS = ("file", "stream")


@dataclass(frozen=True)
class SimulationResult:
    """One image, or the same one several times, through the simulated array.

    Attributes:
        codes: output codes of the last run, int64 ``[c_out, out_height, out_width]``.
        counters: cycle counters of the last run, see `macram.driver.COUNTERS`.
        all_codes: codes of every run ``[runs, c_out, out_height, out_width]``.
        all_counters: counters of every run.
        register_reads: registers read during the runs, on top of what the driver needs.
        wall_seconds: time of the simulation, start of the simulator included.
        build_seconds: time of export and build, little when both were cached.
        sums: of the residual adder, as ``codes``; None without a residual stream.
        seed: of every random choice.
        waves: waveform file, or None.
    """

    codes: NDArray[np.int64]
    counters: dict[str, int]
    all_codes: NDArray[np.int64]
    all_counters: list[dict[str, int]]
    register_reads: int
    wall_seconds: float
    build_seconds: float
    sums: NDArray[np.int64] | None
    seed: int
    waves: Path | None


def simulate(
    packed: PackedLayer | Sequence[PackedLayer],
    input_codes: NDArray[np.integer],
    *,
    residual: tuple[ResidualRule, NDArray[np.integer]] | None = None,
    gaps: str = "none",
    stalls: str = "none",
    load: str = "file",
    seed: int | None = None,
    runs: int = 1,
    snoop: bool = False,
    random_init: bool = False,
    waves: bool | None = None,
    job_dir: Path | None = None,
    timeout: float | None = None,
    told: Callable[[float], None] | None = None,
) -> SimulationResult:
    """Run an image through the exported Verilog of ``packed.array``.

    Args:
        packed: the layer and its array; or the layer in passes (`macram.pack.pack_passes`), which are always loaded
            through the stream.
        input_codes: ``[c_in, height, width]``.
        residual: rule of the residual adder and the stream to add to, codes ``[c_out, out_height, out_width]``.
        gaps: idle cycles of the sources, one of `macram_sim.streams.PATTERNS`.
        stalls: idle cycles of the sink, likewise.
        load: ``file``: the memories start with the layer in them; ``stream``: they start at zero and the
            driver loads them.
        seed: of gaps, stalls and random values; default ``SEED`` of the environment, else random.
        runs: images to run one after the other, all the same.
        snoop: read random registers while the array runs.
        random_init: start all registers without a reset from random values.
        waves: write a waveform; ``WAVES`` of the environment wins.
        job_dir: where inputs, outputs, log and waveform go; default a folder under ``build_root() / "jobs"`` that is
            removed unless something fails or a waveform was wanted.
        timeout: seconds of simulation after which to give up.
        told: called now and then, from another thread, with the share that is done; default lines on stderr.

    Raises:
        ValueError: an argument is out of range or the image does not fit the layer.
        SimulationError: the build or the simulation failed; the message says how to repeat it.
        ToolError: a tool is missing.
    """
    passes = [packed] if isinstance(packed, PackedLayer) else list(packed)
    array = passes[0].array
    _check(passes, input_codes, {"gaps": gaps, "stalls": stalls, "load": load}, runs)
    seed = choose_seed(seed)
    started = time.perf_counter()
    model = build_array(array, waves=waves)
    build_seconds = time.perf_counter() - started
    if keep := job_dir is not None:
        folder = Path(job_dir).resolve()
        folder.mkdir(parents=True, exist_ok=True)
    else:
        folder = job_folder(array.name)
    names = [f"pass_{index}" for index in range(len(passes))]
    for name, part in zip(names, passes, strict=True):
        part.write(folder / name)
    np.save(folder / "input.npy", input_codes.astype(np.int64))
    options = {"gaps": gaps, "stalls": stalls, "load": load, "seed": seed, "runs": runs, "snoop": snoop}
    options |= {"residual": residual is not None, "watched": told is not None}
    if residual is not None:
        rule, stream = residual
        np.savez(folder / "residual.npz", table=rule.table, bounds=rule.bounds, stream=stream)
    options["passes"] = names
    (folder / "job.json").write_text(json.dumps(options, indent=2) + "\n")
    for stale in ("output.npy", "sums.npy", "result.json"):
        (folder / stale).unlink(missing_ok=True)
    with nullcontext() if keep else gone_if_interrupted(folder), watching(folder, told):
        done = run(
            model,
            "macram_sim.bench_array",
            folder / "run",
            seed=seed,
            env={"MACRAM_JOB": str(folder)},
            files=sorted((folder / names[0]).glob("*.mem")) if load == "file" else (),
            random_init=random_init,
            waves=waves,
            timeout=timeout,
        )
    codes = np.load(folder / "output.npy")
    sums = np.load(folder / "sums.npy") if residual is not None else None
    result = json.loads((folder / "result.json").read_text())
    if not keep and not waves_wanted(waves):
        shutil.rmtree(folder, ignore_errors=True)
    return SimulationResult(
        codes=codes[-1],
        counters=result["counters"][-1],
        all_codes=codes,
        all_counters=result["counters"],
        register_reads=result["register_reads"],
        wall_seconds=done.seconds,
        build_seconds=build_seconds,
        sums=sums,
        seed=seed,
        waves=done.waves,
    )


def build_array(array: ArrayConfig, *, waves: bool | None = None) -> Build:
    """Export and build an array, or find it built.

    Raises:
        SimulationError: the build failed.
        ToolError: a tool is missing.
    """
    directory, sources, toplevel = _export(array)
    return build([directory / name for name in sources], toplevel, waves=waves)


def _export(array: ArrayConfig) -> tuple[Path, list[str], str]:
    """The Verilog of ``array`` under ``build_root() / "rtl"``, exported once per geometry and generator source."""
    geometry = {key: value for key, value in array.to_dict().items() if key != "name"}
    key = hashlib.sha256(json.dumps([geometry, _generator()], sort_keys=True).encode()).hexdigest()[:20]
    final = build_root() / "rtl" / key
    final.parent.mkdir(parents=True, exist_ok=True)
    with locked(final.parent / f".{key}.lock"):
        index = final / "sources.json"
        if not index.is_file():
            from macram_hw.export import export_verilog  # noqa: PLC0415  (Amaranth takes a second to import)

            work = final.parent / f".{key}.{os.getpid()}"
            shutil.rmtree(work, ignore_errors=True)
            try:
                export = export_verilog(array, work)
                names = [str(Path(source).relative_to(work)) for source in export.sources]
                (work / index.name).write_text(json.dumps({"sources": names, "toplevel": export.toplevel}))
                shutil.rmtree(final, ignore_errors=True)
                work.rename(final)
            finally:
                shutil.rmtree(work, ignore_errors=True)
    listed = json.loads(index.read_text())
    return final, listed["sources"], listed["toplevel"]


@lru_cache(maxsize=1)
def _generator() -> str:
    """Hash of every source that the Verilog comes from, and of the Amaranth version."""
    digest = hashlib.sha256(version("amaranth").encode())
    for package in (macram.spec, macram_hw):
        root = Path(str(package.__file__)).parent
        for path in sorted(root.rglob("*")):
            if path.suffix in (".py", ".v", ".vlt"):
                digest.update(str(path.relative_to(root)).encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()


def _check(
    passes: Sequence[PackedLayer], image: NDArray[np.integer], choices: Mapping[str, str], runs: int
) -> None:
    for name, value in choices.items():
        allowed = LOADS if name == "load" else PATTERNS
        if value not in allowed:
            raise ValueError(f"{name} must be one of {', '.join(allowed)}, not {value!r}")
    if runs < 1:
        raise ValueError(f"runs must be at least 1, not {runs}")
    spec = passes[0].spec
    blocks = next(index for index, part in enumerate(passes, 1) if not part.sums_out)
    shape = (sum(part.spec.c_in for part in passes[:blocks]), spec.height, spec.width)
    if image.shape != shape or image.dtype.kind not in "iu":
        raise ValueError(f"the image must be integers {list(shape)}, not {image.dtype} {list(image.shape)}")
    if not spec.input.holds(image):
        raise ValueError(
            f"image codes must lie in {spec.input.lo}..{spec.input.hi}, "
            f"not {int(image.min())}..{int(image.max())}"
        )


__all__ = ["SimulationError", "SimulationResult", "build_array", "simulate"]
