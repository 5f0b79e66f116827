"""``macram counts``: the paper's tables IV and V from the instantiated network."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rich.table import Table


def add_parser(verb: Callable[[str, str, str, str], argparse.ArgumentParser]) -> None:
    """Registers the verb."""
    counts = verb(
        "counts",
        "counts_verb",
        "count operations and storage of the network (the paper's tables IV and V)",
        "One operation is one multiply-accumulate of a convolution, for one image. Without options: the "
        "published network at 512 x 512.",
    )
    counts.add_argument("--json", action="store_true", help="print JSON with exact integers, every layer")
    counts.add_argument("--size", default="paper", help="paper, quarter, eighth, paper-front, tiny")
    counts.add_argument("--variant", default="published", help="published, corrected, deployable")
    counts.add_argument("--dataset", default="swisscube", help="swisscube (512 x 512), speed (960 x 960)")


def counts(arguments: argparse.Namespace) -> int:
    """Print the tables, or one JSON object."""
    # Late: the grammar above is loaded by every command, PyTorch and Rich are not.
    from macram.cli.console import open_console  # noqa: PLC0415
    from macram.model.counts import count_network  # noqa: PLC0415
    from macram.model.sizes import spacenet_config  # noqa: PLC0415

    config = spacenet_config(arguments.size, arguments.variant, dataset=arguments.dataset)
    result = count_network(config)
    if arguments.json:
        network = {"size": arguments.size, "variant": arguments.variant, "dataset": arguments.dataset}
        print(json.dumps({"network": network, "image_size": config.image_size, **result.to_dict()}, indent=2))
        return 0
    console = open_console()
    side = config.image_size
    console.print(f"{arguments.size}, {arguments.variant}, {side} x {side}", highlight=False)
    console.print(_operations(result.operations))
    console.print(_storage(result.storage))
    return 0


def _operations(rows: tuple[dict[str, Any], ...]) -> Table:
    from rich.table import Table  # noqa: PLC0415

    table = Table(title="Table IV: operations", title_justify="left")
    for column in ("Mode", "GOPs + GFLOPs", "Perc. (%)", "quantised MACs", "float MACs"):
        table.add_column(column, justify="left" if column == "Mode" else "right")
    for row in rows:
        table.add_row(
            row["mode"],
            f"{row['quantised_g']:.2f} + {row['remaining_g']:.2f}",
            f"{row['share_percent']:.2f}",
            f"{row['quantised_macs']:,}",
            f"{row['remaining_macs']:,}",
        )
    return table


def _storage(rows: tuple[dict[str, Any], ...]) -> Table:
    from rich.table import Table  # noqa: PLC0415

    table = Table(title="Table V: storage (M and MB are 2^20)", title_justify="left")
    for column in ("Format", "#Para.", "Model Size", "Saving (%)", "parameters", "bytes"):
        table.add_column(column, justify="left" if column == "Format" else "right")
    for row in rows:
        table.add_row(
            "FP32" if row["bits"] == 32 else f"{row['bits']}-bit",
            f"{row['parameters_m']:.2f} M",
            f"{row['size_mb']:.2f} MB",
            f"{row['saving_percent']:.2f}",
            f"{row['parameters']:,}",
            f"{row['size_bits'] / 8:,.2f}".removesuffix(".00"),
        )
    return table
