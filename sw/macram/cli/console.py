"""Where the verbs print: the terminal as wide as it is, a pipe or a file at one fixed width."""

from __future__ import annotations

from rich.console import Console

PIPED_WIDTH = 140
"""Columns where nobody's terminal says how many; every table fits without wrapping."""


def open_console() -> Console:
    """Standard output."""
    console = Console()
    if not console.is_terminal:
        console.width = PIPED_WIDTH
    return console
