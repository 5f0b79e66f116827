"""Options of ``macram evaluate`` and ``macram predict`` that say how network outputs become a pose."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from macram.pose import PoseSettings

OPTIONS = ("looks", "edges")


def add_pose_options(sub: argparse.ArgumentParser) -> None:
    """``--looks`` and ``--edges``; without them poses are found as the paper's evaluation does, by a single look."""
    sub.add_argument(
        "--looks",
        type=int,
        default=0,
        metavar="N",
        help="show the network N turned crops around the first pose as well, all cells voting together; with 4 a "
        "picture takes between two and three times as long (default: 0)",
    )
    sub.add_argument(
        "--edges",
        type=float,
        nargs="?",
        const=1.0,
        default=0.0,
        metavar="BOX",
        help="align the pose with the edges of the target's box in the picture, some milliseconds; BOX is the size of "
        "the box of visible edges in boxes of the keypoints, 0.9928 for the rendered cubesat1u (default: off, BOX 1)",
    )


def pose_settings(
    arguments: argparse.Namespace, *, refine: bool = True, published: bool = False
) -> PoseSettings:
    """What the options ask for.

    Raises:
        ValueError: a number out of range, or refinement that ``refine`` rules out.
    """
    from macram.pose import EdgeSettings, LookSettings, PoseSettings, RansacSettings  # noqa: PLC0415

    if arguments.looks < 0:
        raise ValueError(f"--looks must be 0 or more, not {arguments.looks}")
    if not 0 <= arguments.edges < float("inf"):
        raise ValueError(f"--edges must be above 0, not {arguments.edges}")
    if not refine and (arguments.looks or arguments.edges):
        raise ValueError(
            "--published and --no-refine are a single look as published; leave --looks and --edges away"
        )
    return PoseSettings(
        published=published,
        ransac=RansacSettings(refine=refine),
        looks=LookSettings(turns=arguments.looks) if arguments.looks else None,
        edges=EdgeSettings(box=arguments.edges) if arguments.edges else None,
    )
