"""These tests are collected where an NVIDIA GPU is; there is nothing in them for other machines."""

from __future__ import annotations

import sys
from pathlib import Path

import torch

sys.path.append(str(Path(__file__).resolve().parents[1] / "sw"))  # the small scene of the other tests
collect_ignore_glob = [] if torch.cuda.is_available() else ["*"]
