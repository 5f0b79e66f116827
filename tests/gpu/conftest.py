"""These tests are collected where an NVIDIA GPU is; there is nothing in them for other machines."""

from __future__ import annotations

import torch

collect_ignore_glob = [] if torch.cuda.is_available() else ["*"]
