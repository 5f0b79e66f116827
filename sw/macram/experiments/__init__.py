"""The rows behind docs/results.md: what to train and score, what came out, and the page."""
