"""The PIM array in Amaranth."""
