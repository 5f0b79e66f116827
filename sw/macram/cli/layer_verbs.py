"""``macram layer``, ``macram pack`` and ``macram example``: everything that takes or gives a layer file."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from macram.cli.console import open_console
from macram.cli.stages import Stages
from macram.cli.traffic import traffic
from macram.layer_job import array_for, run_layer_job, run_summary, write_run
from macram.spec import ArrayConfig, ConvSpec, IntFormat, layer_passes

if TYPE_CHECKING:
    from macram.layer_file import LayerCase


def layer(arguments: argparse.Namespace) -> int:
    """Run a layer file; 0 only if no code differs."""
    case, array = _case(arguments)
    streams = traffic(arguments)
    _folder(arguments)
    console = open_console()
    # A waveform belongs to the report; without one nothing of the simulation is worth keeping.
    job_dir = arguments.out / "simulation" if streams.waves else None
    run = run_layer_job(case, array=array, traffic=streams, stage=Stages(console), job_dir=job_dir)
    write_run(run, arguments.out)
    console.print(run_summary(run), highlight=False, markup=False, soft_wrap=True)
    console.print(
        f"{run.cycles:,} cycles measured, {run.estimate['total']:,} estimated; "
        f"results in {arguments.out}, seed {run.traffic.seed}",
        highlight=False,
        markup=False,
        soft_wrap=True,
    )
    return 0 if run.passed else 1


def pack(arguments: argparse.Namespace) -> int:
    """Write the BRAM images of a layer file."""
    from macram.pack import pack_passes  # noqa: PLC0415

    case, array = _case(arguments)
    passes = pack_passes(case, array)
    first = passes[0].spec
    _folder(arguments)
    for index, packed in enumerate(passes):
        packed.write(arguments.out if len(passes) == 1 else arguments.out / f"pass_{index}")
    print(
        f"{case.spec.c_out} x {case.spec.fan_in} weights packed for array {array.name} into {arguments.out}"
        + (f", in {len(passes)} passes of up to {first.c_in} -> {first.c_out} channels" if passes[1:] else "")
    )
    return 0


def example(arguments: argparse.Namespace) -> int:
    """Write a random layer file."""
    from macram.golden import random_case  # noqa: PLC0415

    (c_in, c_out), (height, width) = arguments.channels, arguments.size
    weight, into, out = arguments.bits
    if arguments.seed < 0:
        raise ValueError(f"--seed must be 0 or more, not {arguments.seed}")
    spec = ConvSpec(
        c_in,
        c_out,
        height,
        width,
        kernel=arguments.kernel,
        stride=arguments.stride,
        padding=arguments.kernel // 2,
        weight=IntFormat(weight, signed=True),
        input=IntFormat(into, signed=arguments.signed_input),
        output=IntFormat(out, signed=arguments.signed_output),
    )
    array_for(spec)
    random_case(spec, arguments.seed).save(arguments.file)
    print(
        f"{arguments.file}: {c_in} -> {c_out} channels, {height} x {width}, kernel {spec.kernel}x{spec.kernel}, "
        f"stride {spec.stride}; run it with"
    )
    print(f"  macram layer {arguments.file} -o build/layer")
    return 0


def _case(arguments: argparse.Namespace) -> tuple[LayerCase, ArrayConfig]:
    """The layer, and the array named on the command line, else the reference geometry in the layer's formats."""
    from macram.layer_file import LayerCase  # noqa: PLC0415

    case = LayerCase.load(arguments.file)
    given = None if arguments.array is None else ArrayConfig.from_toml(arguments.array)
    try:
        if given is None:
            return case, array_for(case.spec)
        layer_passes(case.spec, given)
    except ValueError as error:
        raise ValueError(f"{arguments.file}: {error}") from error
    return case, given


def _folder(arguments: argparse.Namespace) -> None:
    """Make the output folder before work is spent."""
    arguments.out.mkdir(parents=True, exist_ok=True)
