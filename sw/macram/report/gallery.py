"""The pictures of a demo: the image, some input maps, some output maps from hardware beside golden."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from macram.report.maps import Rgb, codes_rgb, contact_sheet, difference_rgb, lively_channels, png

if TYPE_CHECKING:
    from macram.layer_file import LayerCase

INPUT_MAPS = 8
OUTPUT_MAPS = 6
SHEET_ROWS = 3


def gallery(
    name: str, picture: Rgb, case: LayerCase, produced: NDArray[np.integer], expected: NDArray[np.integer]
) -> tuple[dict[str, Any], dict[str, bytes]]:
    """Pictures of one run.

    Args:
        name: of the image.
        picture: what the network saw, RGB ``[height, width, 3]``.
        case: the layer with its input codes.
        produced: output codes ``[channels, height, width]`` of the hardware.
        expected: those of the golden model.

    Returns:
        The plain table for ``report.json`` and the PNG files it names, by file name.
    """
    files: dict[str, bytes] = {}
    spec = case.spec
    files["image.png"] = png(picture)

    inputs = []
    for channel in lively_channels(case.input, INPUT_MAPS):
        file = f"input_{channel:03d}.png"
        files[file] = png(codes_rgb(case.input[channel], spec.input))
        inputs.append({"channel": channel, "file": file})

    outputs, sheet = [], []
    for channel in lively_channels(expected, OUTPUT_MAPS):
        ours, wanted = produced[channel], expected[channel]
        pictures = {
            "hardware": codes_rgb(ours, spec.output),
            "golden": codes_rgb(wanted, spec.output),
            "difference": difference_rgb(ours, wanted, spec.output),
        }
        row: dict[str, Any] = {"channel": channel, "differ": int(np.count_nonzero(ours != wanted))}
        for kind, colours in pictures.items():
            row[kind] = f"output_{channel:03d}_{kind}.png"
            files[row[kind]] = png(colours)
        outputs.append(row)
        sheet.append((f"channel {channel}", list(pictures.values())))

    files["maps.png"] = contact_sheet(
        "Output codes of the simulated array",
        ["hardware", "golden", "difference"],
        sheet[:SHEET_ROWS],
    )
    table = {
        "image": {
            "file": "image.png",
            "label": f"{name}, as the network saw it: {picture.shape[1]} × {picture.shape[0]}",
        },
        "inputs": inputs,
        "outputs": outputs,
        "input_levels": f"{spec.input.lo} to {spec.input.hi}",
        "output_levels": f"{spec.output.lo} to {spec.output.hi}",
        "sheet": "maps.png",
    }
    return table, files
