"""Exit codes of every verb."""

OK, FAILED, BAD_INPUT = 0, 1, 2
"""All well; a check failed; bad input or a missing tool."""
