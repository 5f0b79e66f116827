"""Data sets with a known pose in every picture: readers, a renderer, checks."""
