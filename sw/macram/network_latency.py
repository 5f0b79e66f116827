"""How much slower than its float32 forward pass the whole network runs as integers on this processor."""

from __future__ import annotations

import os
import resource
import statistics
import sys
import time
from collections.abc import Callable, Sequence
from typing import Any

from macram.cpu_latency import torch_threads

SIZE = "quarter"
SIDES = (256, 512)
CALIBRATION_SIDE = 256
GIB = 1 << 30


def measure_network(
    repeat: int, seed: int, *, size: str = SIZE, sides: Sequence[int] = SIDES
) -> list[dict[str, Any]]:
    """Time a whole network, random but calibrated, in float32 and as deployed integers (W3A3, mode III).

    Both start from the same normalised picture and end with the predictions; they take turns, so that what else
    the machine does meets both. What has to be made only once per network is not in the times.

    Args:
        repeat: runs of each, after one that warms caches; the figure is their median.
        seed: of weights and pictures.
        size: one of `macram.model.SIZES`.
        sides: of the square pictures, multiples of 32.

    Returns:
        One row per picture side and number of threads (one, all): ``network``, ``side``, ``threads``, ``float_ms``,
        ``integer_ms``, their ``ratio``, all runs, and ``peak_gib``, the largest memory that this process has had
        until then, with everything it did. Empty without PyTorch.

    Raises:
        ValueError: an unknown size, or a side that is no multiple of 32.
    """
    try:
        import torch  # noqa: PLC0415
    except ModuleNotFoundError:
        return []
    from macram.model import SpaceNet, spacenet_config  # noqa: PLC0415
    from macram.quant import (  # noqa: PLC0415
        DeployedNetwork,
        Precision,
        calibrate_batch_norm,
        calibrate_steps,
        host_codes,
        host_predictions,
        lower_network,
        quantise,
    )

    draw = torch.Generator().manual_seed(seed)
    model = SpaceNet(spacenet_config(size, "deployable"), draw)
    pictures = torch.randn((4, 3, CALIBRATION_SIDE, CALIBRATION_SIDE), generator=draw)
    calibrate_batch_norm(model, pictures)
    net: Any = quantise(model, "III", Precision())
    calibrate_steps(net, pictures)
    model = model.to(memory_format=torch.channels_last)  # type: ignore[call-overload]
    rows = []
    for side in sides:
        picture = torch.randn((1, 3, side, side), generator=draw)
        deployed = DeployedNetwork(lower_network(net, side, side))

        def as_integers(picture: Any = picture, deployed: Any = deployed) -> None:
            codes = host_codes(net.backbone, picture[0])
            host_predictions(deployed.program, deployed.accumulators(codes))

        def as_floats(picture: Any = picture) -> None:
            with torch.no_grad():
                model(picture.contiguous(memory_format=torch.channels_last))

        for threads in sorted({1, os.cpu_count() or 1}):
            with torch_threads(torch, threads):
                rows.append(
                    {"network": size, "side": side, "threads": threads} | _row(as_floats, as_integers, repeat)
                )
    return rows


def _row(as_floats: Callable[[], None], as_integers: Callable[[], None], repeat: int) -> dict[str, Any]:
    runs: dict[str, list[float]] = {"float": [], "integer": []}
    for turn in range(repeat + 1):
        for name, work in (("float", as_floats), ("integer", as_integers)):
            start = time.perf_counter()
            work()
            if turn:
                runs[name].append(1e3 * (time.perf_counter() - start))
    medians = {name: statistics.median(values) for name, values in runs.items()}
    return {
        **{f"{name}_ms": round(value, 2) for name, value in medians.items()},
        "ratio": round(medians["integer"] / medians["float"], 3),
        "peak_gib": round(_peak() / GIB, 3),
        **{f"{name}_runs_ms": [round(v, 2) for v in values] for name, values in runs.items()},
    }


def _peak() -> int:
    """The largest resident memory of this process so far, bytes."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * (1 if sys.platform == "darwin" else 1024)
