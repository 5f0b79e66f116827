"""The ``macram`` command. Nothing heavy is imported before a verb runs."""

from macram.cli.app import main

__all__ = ["main"]
