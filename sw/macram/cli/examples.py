"""Longer help: examples under a verb's options."""

from __future__ import annotations

import argparse
import textwrap


def say_more(sub: argparse.ArgumentParser, epilog: str) -> None:
    """An epilog that keeps its lines; the description is then wrapped here, as argparse would."""
    sub.description = textwrap.fill(sub.description or "", 100)
    sub.epilog = epilog
    sub.formatter_class = argparse.RawDescriptionHelpFormatter
