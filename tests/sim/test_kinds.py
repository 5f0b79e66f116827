"""Every kind of layer on one array: 3x3 with stride 1 and 2, 1x1, unsigned and signed inputs, codes and cycles."""

from __future__ import annotations

import json
import os
import random
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from macram.golden import random_case, run_layer
from macram.pack import pack_layer, pack_passes
from macram.perf import estimate
from macram.spec import ArrayConfig, ConvSpec, IntFormat
from macram_sim import runner
from macram_sim.array import build_array

TINY = ArrayConfig.from_toml(Path(__file__).parents[2] / "configs" / "tiny.toml")
ARRAYS = {
    "tiny": TINY,
    "dsp48e2": replace(TINY, engine="dsp48e2"),
    "8 bits": replace(
        TINY, weight=IntFormat(8, signed=True), input=IntFormat(8), output=IntFormat(8), stream_bits=64
    ),
    "signed": replace(TINY, input=IntFormat(3, signed=True), output=IntFormat(4, signed=True)),
}
KINDS = [(kernel, stride, signed) for kernel in (1, 3) for stride in (1, 2) for signed in (False, True)]
FILLS = ("uniform", "extremes", "min", "max", "impulse")
# The same in every worker of a parallel run; SEED=... tries others.
SEED = int(os.environ.get("SEED") or 2022)


def random_layers(array, count, rng):
    """Layers of all kinds in turn that the array admits; sides from 1, the widths around whole groups too."""
    layers = []
    while len(layers) < count:
        kernel, stride, signed = KINDS[len(layers) % len(KINDS)]
        spec = ConvSpec(
            rng.randint(1, array.max_c_in), rng.randint(1, array.max_c_out),
            rng.randint(1, 9), rng.choice([rng.randint(1, 40), 8, 16, 7, 9]),
            kernel, stride, kernel // 2, array.weight,
            replace(array.input, signed=signed or array.input.signed), array.output,
        )  # fmt: skip
        try:
            array.check_admits(spec)
        except ValueError:
            continue
        layers.append(spec)
    return layers


def run_all(array, cases, folder, *, gaps="none", stalls="none"):
    """Codes and counters of every case, one after the other on one simulated array."""
    names = [f"{index:03d}" for index in range(len(cases))]
    for name, case in zip(names, cases, strict=True):
        pack_layer(case, array).write(folder / name / "packed")
        np.save(folder / name / "input.npy", case.input)
    (folder / "layers.json").write_text(
        json.dumps({"gaps": gaps, "stalls": stalls, "seed": SEED, "layers": names})
    )
    job = {"MACRAM_JOB": str(folder)}
    runner.run(build_array(array), "bench_layers", folder / "run", seed=SEED, env=job)
    codes = [np.load(folder / name / "output.npy") for name in names]
    return codes, json.loads((folder / "counters.json").read_text())


@pytest.mark.parametrize(("name", "count"), [("tiny", 64), ("dsp48e2", 16), ("8 bits", 16), ("signed", 16)])
def test_codes_and_cycles_of_every_kind(toolchain, tmp_path, name, count):
    array, rng = ARRAYS[name], random.Random(SEED)
    layers = random_layers(array, count, rng)
    cases = [random_case(spec, index, rng.choice(FILLS)) for index, spec in enumerate(layers)]
    codes, counters = run_all(array, cases, tmp_path)
    exact = 0
    for case, found, counted in zip(cases, codes, counters, strict=True):
        np.testing.assert_array_equal(found, run_layer(case), err_msg=str(case.spec))
        assert counted["cycles"] == sum(value for key, value in counted.items() if key != "cycles")
        expected = estimate(case.spec, array)
        stalls = counted["input_stalls"] + counted["output_stalls"]
        measured = (counted["fill_cycles"], counted["mac_cycles"], stalls, counted["drain_cycles"])
        if expected.exact:
            wanted = (expected.fill, expected.mac, expected.stall, expected.drain)
            assert measured == wanted, case.spec
            exact += 1
        else:
            assert measured[1] == expected.mac, case.spec
            assert abs(counted["cycles"] - expected.total) <= 4 + 0.2 * expected.total, case.spec
    assert exact >= count // 3


@pytest.mark.parametrize(("gaps", "stalls"), [("random", "bursty"), ("bursty", "random")])
def test_gaps_and_stalls_change_no_code(toolchain, tmp_path, gaps, stalls):
    rng = random.Random(SEED + len(gaps))
    cases = [
        random_case(spec, index, rng.choice(FILLS)) for index, spec in enumerate(random_layers(TINY, 16, rng))
    ]
    codes, _ = run_all(TINY, cases, tmp_path, gaps=gaps, stalls=stalls)
    for case, found in zip(cases, codes, strict=True):
        np.testing.assert_array_equal(found, run_layer(case), err_msg=str(case.spec))


@pytest.mark.parametrize(("kernel", "stride", "signed"), [(3, 1, True), (3, 2, False)])
def test_passes_load_while_the_array_computes(toolchain, tmp_path, kernel, stride, signed):
    """More output channels than the memories hold; all loads but the first hide behind the runs."""
    spec = ConvSpec(8, 70, 16, 24, kernel, stride, 1, input=IntFormat(3, signed=signed))
    case = random_case(spec, SEED)
    passes = pack_passes(case, TINY)
    names = [f"pass_{index}" for index in range(len(passes))]
    for name, packed in zip(names, passes, strict=True):
        packed.write(tmp_path / name)
    (tmp_path / "passes.json").write_text(json.dumps(names))
    np.save(tmp_path / "input.npy", case.input)
    job = {"MACRAM_JOB": str(tmp_path)}
    runner.run(build_array(TINY), "bench_passes", tmp_path / "run", seed=SEED, env=job)
    np.testing.assert_array_equal(np.load(tmp_path / "output.npy"), run_layer(case))
    took = json.loads((tmp_path / "cycles.json").read_text())
    estimates = [estimate(packed.spec, TINY) for packed in passes]
    if all(part.exact for part in estimates):
        assert took["counted"] == sum(part.total for part in estimates)
    hidden = took["one by one"] - took["overlapped"]
    assert hidden >= 0.95 * took["loading"] * (len(passes) - 1) / len(passes), took
