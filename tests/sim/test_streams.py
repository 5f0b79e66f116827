"""The stream source and sink: every beat arrives under any pattern, and every broken rule is noticed."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from macram_sim import build, runner
from macram_sim.build import SimulationError
from macram_sim.streams import PATTERNS, pauses

HERE = Path(__file__).parent


def stream(tmp_path, **settings):
    model = build.build([HERE / "echo.v"], "echo")
    (tmp_path / "echo.mem").write_text("0\n0\n0\n0\n")
    env = {f"ECHO_{name.upper()}": str(value) for name, value in settings.items()}
    return runner.run(
        model,
        "bench_echo",
        tmp_path / "run",
        testcase="stream",
        env=env,
        files=[tmp_path / "echo.mem"],
        timeout=20,
    )


@pytest.mark.parametrize(
    ("gaps", "stalls"), [("none", "none"), ("random", "none"), ("none", "bursty"), ("bursty", "random")]
)
def test_every_beat_arrives(toolchain, tmp_path, gaps, stalls):
    assert stream(tmp_path, gaps=gaps, stalls=stalls).tests == 1


@pytest.mark.parametrize(
    ("fault", "stalls", "message"),
    [
        (1, "random", "m_axis_echo: tvalid fell while beat"),
        (2, "random", "m_axis_echo: the payload changed while beat"),
        (3, "none", r"m_axis_echo_tlast is early, on beat \d, of 300 beats"),
        (4, "none", "m_axis_echo_tlast is missing on the last of 1 beats"),
    ],
)
def test_broken_rules_are_noticed(toolchain, tmp_path, fault, stalls, message):
    with pytest.raises(SimulationError, match=message):
        stream(tmp_path, fault=fault, stalls=stalls)


def test_patterns():
    for name in PATTERNS[1:]:
        draw = pauses(name, random.Random(1))
        idle = [draw() for _ in range(3000)]
        assert min(idle) == 0
        assert 0.5 < sum(idle) / len(idle) < 3
        again = pauses(name, random.Random(1))
        assert idle == [again() for _ in range(3000)]
    assert pauses("none", random.Random(1)) is None
    with pytest.raises(ValueError, match="one of none, random, bursty, not 'often'"):
        pauses("often", random.Random(1))
