"""The whole chain once: image, pose, layer, golden model, packing, RTL, simulation, comparison, report."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from macram.layer_job import LayerRun, Stage, Traffic, array_for, output_codes, run_layer_job
from macram.report.bram import bram_report
from macram.report.comparison import compare
from macram.report.files import write_bytes, write_json, write_npz, write_text
from macram.report.gallery import gallery
from macram.report.latency import latency_report
from macram.report.maps import histogram, png
from macram.report.page import render
from macram.report.versions import machine

if TYPE_CHECKING:
    from macram.front import FrontResult
    from macram.train.learned import LearnedFront

PLACES = (Path(__file__).parent / "examples", Path(__file__).resolve().parents[2] / "examples")
"""Example images of an installed package; of a repository."""
STAGES = 9
"""Stages that `run_demo` opens."""
COMPARISON_NOTE = (
    "Three computations of the same codes: the deployed network in PyTorch, the NumPy golden model that "
    "defines every bit, and the array's exported Verilog simulated by Verilator behind its AXI4-Streams."
)


def example_images() -> list[Path]:
    """The 512 x 512 example images without their masks; none if this installation has no examples."""
    return [
        path for folder in PLACES for path in sorted(folder.glob("*.png")) if not path.stem.endswith("_mask")
    ]


def demo_image() -> Path | None:
    """The example that a network was trained for; None if this installation has no examples."""
    return next((path for folder in PLACES if (path := folder / "test_near.jpg").is_file()), None)


def learned_pose(image: Path | None, focal: float | None) -> tuple[Path, LearnedFront]:
    """The pose of ``image``, or of the example, by the shipped network of the role ``pose``, as integers.

    Raises:
        ValueError: an unreadable image, no image at all, or weights that are missing or changed.
    """
    from macram.train.learned import learned_front  # noqa: PLC0415
    from macram.weights import role  # noqa: PLC0415

    image = image or demo_image()
    if image is None:
        raise ValueError("no example image in this installation; name one with --image PICTURE")
    network = role("pose")
    if network is None:
        raise ValueError(
            'the index of the shipped weights names no network for "pose"; run macram weights index --role pose'
        )
    return image, learned_front(image, network, focal=focal)


def reference_front(image: Path | None, *, checkpoint: Path | None, seed: int) -> tuple[Path, FrontResult]:
    """The reference layer's codes for ``image``, or for the first example image.

    Without a checkpoint it is the shipped network of the role ``reference_layer``; while there is none, a seeded
    one calibrated on the examples, or on ``image`` where there are none.

    Raises:
        ValueError: an image or the checkpoint is missing or unfit, or there is no image at all.
    """
    from macram.front import reference_case  # noqa: PLC0415
    from macram.weights import role  # noqa: PLC0415

    examples = example_images()
    if image is None:
        if not examples:
            raise ValueError("no example image in this installation; name one with --image PICTURE")
        image = examples[0]
    network = None if checkpoint else role("reference_layer")
    if network is not None:
        from macram.train.learned import reference_network  # noqa: PLC0415

        return image, reference_case(image, network=reference_network(network))
    return image, reference_case(image, checkpoint=checkpoint, seed=seed, calibration=examples)


def run_demo(
    image: Path | None,
    out: Path,
    *,
    stage: Stage,
    finished: Sequence[dict[str, Any]],
    checkpoint: Path | None = None,
    focal: float | None = None,
    traffic: Traffic | None = None,
    command: str = "macram demo",
) -> tuple[LayerRun, dict[str, Any]]:
    """Run the chain and leave layer, packed memories, output codes, pictures and the report in ``out``.

    The pose comes from a learned network; a layer of it runs on the array beside the paper-size reference
    layer. Files: ``pose.png``, ``learned_layer.npz``, ``layer.npz``, ``packed/``, ``output.npz`` (key
    ``codes``), PNGs, ``report.json``, ``report.html``.

    Args:
        image: a picture the network is shown; None means the first example.
        out: folder for the results; made if missing.
        stage: opens a named stage.
        finished: the stages done so far with their seconds, as ``stage`` fills it.
        checkpoint: weights of the reference layer's network; None means the shipped ones, and the seeded
            initialisation while there are none; the report says which.
        focal: of the picture, pixels; None takes the camera beside it, else the training's.
        traffic: stream patterns and the seed, which also seeds the network.
        command: what to type to get the same again.

    Returns:
        The run, and the table written to ``report.json`` (its key ``passed`` is the verdict).

    Raises:
        ValueError: an unreadable image or checkpoint.
    """
    traffic = traffic or Traffic()
    with stage("image -> pose, by the deployed integers of a learned network"):
        image, learned = learned_pose(image, focal)
    with stage("image through the paper-size network to the reference layer"):
        image, front = reference_front(image, checkpoint=checkpoint, seed=traffic.seed)
    case = front.case
    out.mkdir(parents=True, exist_ok=True)
    case.save(out / "layer.npz")
    run = run_layer_job(case, array=array_for(case.spec), traffic=traffic, stage=stage)
    with stage("the learned network's own layer on the array"):
        learned.case.save(out / "learned_layer.npz")
        own = run_layer_job(learned.case, array=array_for(learned.case.spec), traffic=traffic)
    with stage("compare every code"):
        run.passes[0].write(out / "packed")
        write_npz(out / "output.npz", codes=output_codes(run))
        comparisons = _comparisons(front.deployed_codes, run)
        learned.report["comparisons"] = _comparisons(learned.deployed_codes, own)
        learned.report["run"] = {
            key: own.report()[key] for key in ("layer", "macs", "compared", "mismatches", "cycles")
        }
    with stage("pictures"):
        pictures_table, pictures = gallery(image.name, front.picture, case, run.produced, run.expected)
        pictures |= {"pose.png": png(learned.picture)}
        learned.report["file"] = "pose.png"
        for name, content in pictures.items():
            write_bytes(out / name, content)
    report = run.report()
    report |= {
        "passed": run.passed
        and own.passed
        and not any(row["mismatches"] for row in (*comparisons, *learned.report["comparisons"])),
        "pose": learned.report,
        "comparisons": comparisons,
        "comparison_note": COMPARISON_NOTE,
        "latency": latency_report(case.spec, report["ms_at_100mhz"]),
        "bram": bram_report(run.array, case.spec),
        "codes": {
            f"weights ({case.spec.weight})": histogram(case.weights, case.spec.weight),
            f"input ({case.spec.input})": histogram(case.input, case.spec.input),
            f"output ({case.spec.output})": histogram(run.produced, case.spec.output),
        },
        "gallery": pictures_table,
        "training_graph_differs": front.differing,
        "provenance": front.provenance,
        "stages": list(finished),
        "stage_seconds": round(sum(stage["seconds"] for stage in finished), 3),
        "machine": machine(),
        "command": command,
    }
    page = render(report, pictures)
    write_json(out / "report.json", report)
    write_text(out / "report.html", page)
    return run, report


def _comparisons(deployed: NDArray[np.int64], run: LayerRun) -> list[dict[str, Any]]:
    """Three computations of one layer, each held against another."""
    return [
        {"name": name, **compare(left, right).to_dict()}
        for name, left, right in (
            ("deployed PyTorch = golden model", deployed, run.expected),
            ("golden model = hardware", run.expected, run.produced),
            ("deployed PyTorch = hardware", deployed, run.produced),
        )
    ]
