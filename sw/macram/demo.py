"""The whole chain once: image, network, layer, golden model, packing, RTL, simulation, comparison, report."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from macram.layer_job import LayerRun, Stage, Traffic, array_for, output_codes, run_layer_job
from macram.report.bram import bram_report
from macram.report.comparison import compare
from macram.report.files import write_bytes, write_json, write_npz, write_text
from macram.report.gallery import gallery
from macram.report.latency import latency_report
from macram.report.maps import histogram
from macram.report.page import render
from macram.report.versions import machine

if TYPE_CHECKING:
    from macram.front import FrontResult

STAGES = 7
"""Stages that `run_demo` opens."""
COMPARISON_NOTE = (
    "Three computations of the same codes: the deployed network in PyTorch, the NumPy golden model that "
    "defines every bit, and the array's exported Verilog simulated by Verilator behind its AXI4-Streams."
)


def example_images() -> list[Path]:
    """The images of the repository's ``examples/`` without their masks; none if there is no such folder."""
    folder = Path(__file__).resolve().parents[2] / "examples"
    return [path for path in sorted(folder.glob("*.png")) if not path.stem.endswith("_mask")]


def reference_front(image: Path | None, *, checkpoint: Path | None, seed: int) -> tuple[Path, FrontResult]:
    """The reference layer's codes for ``image``, or for the first example image.

    Without a checkpoint the network is calibrated on the examples, or on ``image`` where there are none.

    Raises:
        ValueError: an image or the checkpoint is missing or unfit, or there is no image at all.
    """
    from macram.front import reference_case  # noqa: PLC0415

    examples = example_images()
    if image is None:
        if not examples:
            raise ValueError("no example image in this installation; name one with --image PICTURE")
        image = examples[0]
    return image, reference_case(image, checkpoint=checkpoint, seed=seed, calibration=examples)


def run_demo(
    image: Path | None,
    out: Path,
    *,
    stage: Stage,
    finished: Sequence[dict[str, Any]],
    checkpoint: Path | None = None,
    traffic: Traffic | None = None,
    command: str = "macram demo",
) -> tuple[LayerRun, dict[str, Any]]:
    """Run the chain and leave layer, packed memories, output codes, pictures and the report in ``out``.

    Files: ``layer.npz``, ``packed/``, ``output.npz`` (key ``codes``), PNGs, ``report.json``,
    ``report.html``.

    Args:
        image: a picture the network is shown; None means the first example.
        out: folder for the results; made if missing.
        stage: opens a named stage.
        finished: the stages done so far with their seconds, as ``stage`` fills it.
        checkpoint: network weights; None means the seeded initialisation, and the report says so.
        traffic: stream patterns and the seed, which also seeds the network.
        command: what to type to get the same again.

    Returns:
        The run, and the table written to ``report.json`` (its key ``passed`` is the verdict).

    Raises:
        ValueError: an unreadable image or checkpoint.
    """
    traffic = traffic or Traffic()
    with stage("image through the network to the layer"):
        image, front = reference_front(image, checkpoint=checkpoint, seed=traffic.seed)
    case = front.case
    out.mkdir(parents=True, exist_ok=True)
    case.save(out / "layer.npz")
    run = run_layer_job(case, array=array_for(case.spec), traffic=traffic, stage=stage)
    with stage("compare every code"):
        run.passes[0].write(out / "packed")
        write_npz(out / "output.npz", codes=output_codes(run))
        comparisons = [
            {"name": name, **compare(left, right).to_dict()}
            for name, left, right in (
                ("deployed PyTorch = golden model", front.deployed_codes, run.expected),
                ("golden model = hardware", run.expected, run.produced),
                ("deployed PyTorch = hardware", front.deployed_codes, run.produced),
            )
        ]
    with stage("pictures"):
        pictures_table, pictures = gallery(image.name, front.picture, case, run.produced, run.expected)
        for name, content in pictures.items():
            write_bytes(out / name, content)
    report = run.report()
    report |= {
        "passed": run.passed and not any(row["mismatches"] for row in comparisons),
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
