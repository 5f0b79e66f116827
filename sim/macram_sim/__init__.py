"""Simulation of the exported Verilog: Verilator driven by cocotb."""
