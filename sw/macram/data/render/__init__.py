"""A deferred renderer for a CubeSat in orbit, in NumPy and OpenCV alone."""
