"""The grammar of ``macram data render | info | show | verify | compare``."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from pathlib import Path

from macram.cli.examples import say_more

TIERS = ("smoke", "mini", "std", "full")
EXAMPLES = """\
examples:
  macram data render -o build/data/mini --tier mini --background     6,500 pictures, some minutes on two cores
  macram data show build/data/mini                                   look at them: build/sheet.png
  macram data verify build/data/mini                                 files, rotations, masks against corners
  macram data info SwissCube_1.0                                     counts and histograms of any such folder

`macram data ACTION --help` tells more.
"""
ROOT = "SwissCube, BOP or SPEED folder, or what `macram data render` wrote"


def add_data(verb: Callable[[str, str, str, str], argparse.ArgumentParser]) -> None:
    """The grammar of ``macram data``; ``verb`` makes a top-level verb."""
    top = verb(
        "data",
        "data_verb",
        "render a data set, look at one, check one",
        "Reads SwissCube, BOP and SPEED folders and what `macram data render` writes.",
    )
    say_more(top, EXAMPLES)
    actions = top.add_subparsers(dest="action", metavar="ACTION", required=True)

    render = actions.add_parser(
        "render",
        help="make a data set of a CubeSat in orbit",
        description="Interrupted runs go on where they stopped; the result does not depend on --jobs. "
        "Tiers: smoke (30 pictures of 128x128), mini (6,500 of 256x256), std (10,000 of 512x512), "
        "full (50,000 of 1024x1024).",
    )
    render.add_argument("-o", "--out", type=Path, required=True, metavar="DIR", help="folder of the data set")
    render.add_argument("--tier", choices=TIERS, default="mini", help="default: mini")
    render.add_argument(
        "--recipe",
        type=Path,
        metavar="TOML",
        help="a data set fixed for good, in place of all options but --jobs",
    )
    render.add_argument(
        "--seqs",
        type=int,
        nargs=3,
        metavar=("TRAIN", "VAL", "TEST"),
        help="sequences of a split (default: the tier's)",
    )
    render.add_argument("--frames", type=int, help="frames per sequence (default: the tier's)")
    render.add_argument("--size", type=int, help="width and height in pixels (default: the tier's)")
    render.add_argument("--focal", type=float, help="focal length in pixels (default: the tier's)")
    render.add_argument("--dmin", type=float, help="nearest depth in diameters (default: the tier's)")
    render.add_argument("--dmax", type=float, help="farthest depth in diameters (default: the tier's)")
    render.add_argument("--seed", type=int, default=2022, help="default: 2022")
    render.add_argument("--jobs", type=int, default=0, help="processes (default: one per core)")
    render.add_argument("--background", action="store_true", help="also store pictures without the target")
    render.add_argument(
        "--format",
        choices=("bop", "speed"),
        default="bop",
        help="SwissCube's layout or SPEED's (default: bop)",
    )

    info = actions.add_parser(
        "info", help="counts and histograms", description="Counts per split, histograms of depth and size."
    )
    info.add_argument("root", type=Path, metavar="DIR", help=ROOT)
    info.add_argument("--json", action="store_true", help="print JSON")

    show = actions.add_parser(
        "show",
        help="contact sheet with boxes and masks",
        description="Evenly spaced frames on one picture, each with the box of its pose and its mask.",
    )
    show.add_argument("root", type=Path, metavar="DIR", help=ROOT)
    show.add_argument(
        "-o",
        "--out",
        type=Path,
        default=Path("build/sheet.png"),
        metavar="PNG",
        help="default: build/sheet.png",
    )
    show.add_argument("--split", help="default: the first")
    show.add_argument("-n", "--number", type=int, default=24, help="pictures (default: 24)")
    show.add_argument("--columns", type=int, default=6, help="pictures per row (default: 6)")

    verify = actions.add_parser(
        "verify",
        help="decode every file, hold every pose against its mask",
        description="Problems are listed by file; the exit status is 1 if there are any.",
    )
    verify.add_argument("root", type=Path, metavar="DIR", help=ROOT)

    compare = actions.add_parser(
        "compare",
        help="rendered frames beside Mitsuba's picture of the same scenes",
        description="Ours, Mitsuba's, difference of the silhouettes (red: ours alone, blue: Mitsuba's alone). "
        "Needs pip install 'macram[mitsuba]'.",
    )
    compare.add_argument("root", type=Path, metavar="DIR", help="data set of `macram data render`")
    compare.add_argument(
        "-o",
        "--out",
        type=Path,
        default=Path("build/compare.png"),
        metavar="PNG",
        help="default: build/compare.png",
    )
    compare.add_argument("--split", help="default: the first")
    compare.add_argument("--frames", type=int, default=4, help="frames, spread over the split (default: 4)")
    compare.add_argument("--samples", type=int, default=64, help="rays per pixel (default: 64)")
