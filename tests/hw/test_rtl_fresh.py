"""The Verilog that is checked in is what the reference configuration gives, byte for byte."""

from pathlib import Path

from macram.cli import main

ROOT = Path(__file__).resolve().parents[2]


def test_rtl_is_up_to_date(capsys):
    arguments = ["rtl", "-o", str(ROOT / "rtl"), "--config", str(ROOT / "configs/reference.toml"), "--check"]
    assert main(arguments) == 0, capsys.readouterr().err
