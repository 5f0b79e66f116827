"""The mutation tool: what it changes, what counts as killed, and that a stopped run goes on."""

from __future__ import annotations

import ast
import json
import subprocess
from pathlib import Path

import pytest

import macram_hw
from macram_sim import mutant_checks, mutate
from macram_sim.mutant_checks import MutantChecks
from macram_sim.mutate import MutationRun, run_mutants
from macram_sim.mutation_points import mutations

SOURCE = '''"""Text with 1 + 1."""
WIDTH = 3


class Part:
    def __init__(self):
        self.width = 1 + 1

    def elaborate(self, platform):
        m = Module()
        level = Signal(8)
        m.d.comb += [self.o.eq(Mux(a == b, c, d)), self.p.eq(~level[0] & full.any())]
        with m.If((x + 1) >= y):
            m.d.sync += level.eq(0)
        return m
'''


def test_every_mutation_is_one_change_that_still_parses():
    found = mutations("part.py", SOURCE)
    texts = {m.apply(SOURCE) for m in found}
    assert len(texts) == len(found)
    for text in texts:
        ast.parse(text)
    changed = {m.lines(SOURCE)[1] for m in found}
    assert {
        "m.d.comb += [self.o.eq(Mux(a != b, c, d)), self.p.eq(~level[0] & full.any())]",
        "m.d.comb += [self.o.eq(Mux(a == b, d, c)), self.p.eq(~level[0] & full.any())]",
        "m.d.comb += [self.o.eq(0), self.p.eq(~level[0] & full.any())]",
        "m.d.comb += [self.o.eq(Mux(a == b, c, d)), self.p.eq(level[0] & full.any())]",
        "m.d.comb += [self.o.eq(Mux(a == b, c, d)), self.p.eq(~level[0] | full.any())]",
        "m.d.comb += [self.o.eq(Mux(a == b, c, d)), self.p.eq(~level[0] & full.all())]",
        "with m.If((x + 1) > y):",
        "with m.If((x - 1) >= y):",
        "with m.If(((x + 1) >= y) | 1):",
        "m.d.sync += level.eq(1)",
    } <= changed
    assert not any("Signal(9)" in line or "self.width" in line or "WIDTH" in line for line in changed)


def test_the_gateware_has_mutations_in_every_module():
    root = Path(macram_hw.__file__).parent
    for path in root.glob("*.py"):
        if path.name not in mutant_checks.NOT_GATEWARE:
            assert mutations(path.name, path.read_text()), path.name


@pytest.fixture
def faked(monkeypatch):
    """A run whose checks are decided by the mutant's text, without a simulator. ``log`` holds what was started."""
    log = []

    def fake(self, name, command):
        log.append(name)
        changed = next(
            (f for f, text in self.sources.items() if self.path(f).read_text() != text),
            "",
        )
        verdicts = {
            "elaborate": 0,
            "unit tests": changed == "loader.py",
            "simulation": changed == "drain.py",
            "proofs": 0,
        }
        output = (
            json.dumps({"portable": changed, "dsp48e2": ""}) if name == "elaborate" else "E   it broke\nlast"
        )
        return subprocess.CompletedProcess(command, int(verdicts[name]), output, "")

    monkeypatch.setattr(MutantChecks, "_run", fake)
    return log


def test_killed_survived_and_resumed(faked, tmp_path):
    steps = []
    first = run_mutants(
        tmp_path, seed=8, count=12, keep=lambda table, verdict: steps.append((table, verdict))
    )
    assert [table["judged"] for table, _ in steps] == list(range(13))
    assert steps[0][1] is None
    by = {row["file"]: row["killed_by"] for row in first["mutants"]}
    for file, killed_by in by.items():
        assert killed_by == {"loader.py": "unit tests", "drain.py": "simulation"}.get(file, "survived")
    assert {"survived", "unit tests", "simulation"} <= set(by.values()), "choose a seed that meets all three"
    assert first["killed"] + first["survived"] == first["judged"] == 12
    assert first["share_killed"] == round(first["killed"] / 12, 4)
    assert next(row["how"] for row in first["mutants"] if row["killed_by"] == "simulation") == "it broke"
    # A stopped run goes on: survivors are judged again, the others are not.
    faked.clear()
    stopped = steps[8][0]
    again = run_mutants(tmp_path, seed=8, count=12, earlier=stopped, keep=lambda *_: None)
    drop = [{k: v for k, v in row.items() if k != "seconds"} for row in first["mutants"]]
    assert [{k: v for k, v in row.items() if k != "seconds"} for row in again["mutants"]] == drop
    assert faked.count("proofs") == first["survived"]
    # Another seed is another run.
    assert run_mutants(tmp_path, seed=5, count=2, earlier=first, keep=lambda *_: None)["mutants"] != drop[:2]


def test_a_quick_run_leaves_its_survivors_to_a_later_one(faked, tmp_path):
    quick = run_mutants(tmp_path, seed=8, count=12, quick=True, keep=lambda *_: None)
    assert set(faked) == {"elaborate", "unit tests"}
    assert quick["quick"]
    faked.clear()
    more = run_mutants(tmp_path, seed=8, count=13, earlier=quick, quick=True, keep=lambda *_: None)
    assert faked.count("elaborate") == 2, "the sound gateware and one mutant more"
    full = run_mutants(tmp_path, seed=8, count=13, earlier=more, keep=lambda *_: None)
    assert full["killed_by"]["simulation"] > quick["killed_by"]["simulation"] == 0
    assert not full["quick"]


def test_a_mutant_that_changes_no_array_does_not_count(faked, tmp_path, monkeypatch):
    monkeypatch.setattr(MutantChecks, "fingerprints", lambda self, known: {"portable": "same"})
    table = run_mutants(tmp_path, seed=1, count=3, keep=lambda *_: None)
    assert table["judged"] == 0
    assert table["no_mutants"] == table["tried"] > 1000


def test_a_reviewed_equivalent_is_no_survivor(faked, tmp_path, monkeypatch):
    first = run_mutants(tmp_path, seed=8, count=12, keep=lambda *_: None)
    row = next(row for row in first["mutants"] if row["killed_by"] == "survived")
    listed = tmp_path / "equivalents.toml"
    entry = "\n".join(f"{key} = {json.dumps(row[key])}" for key in ("file", "old", "new"))
    listed.write_text(f'[[equivalent]]\n{entry}\nreason = "the bit is never read"\n')
    monkeypatch.setattr(mutate, "EQUIVALENTS", listed)
    again = run_mutants(tmp_path, seed=8, count=12, earlier=first, keep=lambda *_: None)
    assert (again["equivalent"], again["survived"]) == (1, first["survived"] - 1)
    assert (
        next(r["how"] for r in again["mutants"] if r["killed_by"] == "equivalent") == "the bit is never read"
    )


def test_checks_that_fail_on_sound_gateware_are_no_measure(tmp_path, monkeypatch):
    def fake(self, name, command):
        return subprocess.CompletedProcess(
            command, int(name != "elaborate"), json.dumps({"portable": str(len(command))}), ""
        )

    monkeypatch.setattr(MutantChecks, "_run", fake)
    monkeypatch.setattr(
        MutantChecks, "fingerprints", lambda self, known: {"portable": "new" if known else "old"}
    )
    with pytest.raises(RuntimeError, match="the unit tests fail on the unchanged gateware"):
        run_mutants(tmp_path, seed=1, count=1, keep=lambda *_: None)


@pytest.mark.parametrize(
    ("seed", "count", "message"),
    [(-1, 1, "seed must be 0 or more"), (1, 0, "number of mutants must be at least 1")],
)
def test_bad_arguments(seed, count, message, tmp_path):
    with pytest.raises(ValueError, match=message):
        MutationRun(tmp_path, seed=seed, count=count)
