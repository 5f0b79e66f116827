"""Folders of simulations: gone where somebody stops one, kept where one fails."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from macram.golden import random_case
from macram.pack import pack_passes
from macram.spec import ArrayConfig, ConvSpec
from macram_sim import array, hosted
from macram_sim.build import SimulationError
from macram_sim.regression import run as regression

TINY = ArrayConfig.from_toml(Path(__file__).parents[2] / "configs" / "tiny-blocks.toml")


def layer():
    spec = ConvSpec(4, 4, 4, 4, weight=TINY.weight, input=TINY.input, output=TINY.output)
    return pack_passes(random_case(spec, 1), TINY)[0]


def one(_):
    return array.simulate(layer(), np.zeros((4, 4, 4), int))


def named(folder):
    return array.simulate(layer(), np.zeros((4, 4, 4), int), job_dir=folder / "named")


def several(_):
    return hosted.simulate_hosted(
        [layer()], lambda index: np.zeros((4, 4, 4), int), lambda index, result: None
    )


def random(_):
    return regression.regress([TINY], seed=1, cases=1)


@pytest.mark.parametrize("work", [one, several, random, named])
@pytest.mark.parametrize(("error", "left"), [(KeyboardInterrupt, 0), (SimulationError, 1)])
def test_a_stopped_simulation_leaves_nothing(work, error, left, tmp_path, monkeypatch):
    def stopped(*arguments, **keywords):
        raise error

    monkeypatch.setenv("MACRAM_BUILD_DIR", str(tmp_path / "build"))
    for module in (array, hosted, regression):
        monkeypatch.setattr(module, "build_array", lambda *a, **k: None)
        monkeypatch.setattr(module, "run", stopped)
    with pytest.raises(error):
        work(tmp_path)
    if work is named:  # its caller's own
        assert (tmp_path / "named" / "job.json").is_file()
    else:
        assert len(list((tmp_path / "build/sim/jobs").iterdir())) == left
