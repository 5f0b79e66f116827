"""Quantisation-aware training graph, calibration, and lowering to integers."""

from macram.quant.calibrate import calibrate_batch_norm, calibrate_steps
from macram.quant.compare import differing_shares, layer_differences, training_codes
from macram.quant.convert import LsqConv2d, quantise
from macram.quant.deploy import DeployedNetwork, host_codes
from macram.quant.fold import Affine, fold_batch_norm
from macram.quant.lower import lower
from macram.quant.lower_spacenet import host_predictions, lower_network
from macram.quant.lsq import LsqQuantizer
from macram.quant.network import Precision, QuantDarkNet53
from macram.quant.program import Program, run_golden

__all__ = [
    "Affine",
    "DeployedNetwork",
    "LsqConv2d",
    "LsqQuantizer",
    "Precision",
    "Program",
    "QuantDarkNet53",
    "calibrate_batch_norm",
    "calibrate_steps",
    "differing_shares",
    "fold_batch_norm",
    "host_codes",
    "host_predictions",
    "layer_differences",
    "lower",
    "lower_network",
    "quantise",
    "run_golden",
    "training_codes",
]
