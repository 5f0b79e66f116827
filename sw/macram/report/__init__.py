"""What a run leaves behind: comparisons, JSON, pictures and one HTML page."""
