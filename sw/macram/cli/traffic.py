"""Stream patterns from the command line."""

from __future__ import annotations

import argparse

from macram.layer_job import Traffic


def traffic(arguments: argparse.Namespace) -> Traffic:
    """The options ``--gaps --stalls --load --seed --waves``."""
    if arguments.seed < 0:
        raise ValueError(f"--seed must be 0 or more, not {arguments.seed}")
    return Traffic(
        gaps=arguments.gaps,
        stalls=arguments.stalls,
        load=arguments.load,
        seed=arguments.seed,
        waves=arguments.waves,
    )
