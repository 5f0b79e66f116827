"""Synthesis with open tools: what an array costs on a device, and a bitstream that tests itself."""
