"""The proofs that take seconds, on the gateware and on gateware that is broken on purpose."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

import macram_hw
from macram_sim.formal import PROOFS, Break, prove
from macram_sim.formal.harness import OPENING

FAST = [proof for proof in PROOFS if proof.fast]


@pytest.mark.slow
@pytest.mark.parametrize("proof", FAST, ids=lambda proof: proof.name)
def test_the_property_holds(proof, tmp_path):
    verdict = prove(proof, tmp_path, mutants=False)
    assert verdict.passed, verdict.fault


@pytest.mark.slow
def test_a_broken_module_is_noticed_and_a_sound_one_is_not(tmp_path):
    proof = next(proof for proof in PROOFS if proof.name == "bus-answers")
    harmless = Break("axi_lite.py", "OKAY, SLVERR = 0, 2", "OKAY, SLVERR = 0, 1 + 1")
    verdict = prove(replace(proof, breaks=(proof.breaks[0], harmless)), tmp_path)
    assert list(verdict.noticed.values()) == [True, False]
    assert "not noticed (PASS)" in verdict.fault
    assert (tmp_path / "bus-answers" / "broken0" / "engine_0" / "trace.vcd").is_file()


def test_proofs_have_names_claims_and_broken_modules():
    assert len({proof.name for proof in PROOFS}) == len(PROOFS)
    for proof in PROOFS:
        assert proof.claim
        assert proof.breaks, proof.name
        assert ("all times" in proof.method) == proof.unbounded
        # Made from the layouts of today's gateware: a field that the harness does not know is an error.
        assert "endmodule" in proof.harness(), proof.name


def test_every_broken_module_is_up_to_date():
    sources = Path(str(macram_hw.__file__)).parent
    for proof in PROOFS:
        for change in proof.breaks:
            text = (sources / change.file).read_text()
            assert text.count(change.old) == 1, f"{proof.name}: {change.old!r} in {change.file}"


def test_a_break_that_no_longer_applies_is_an_error(tmp_path):
    (tmp_path / "macram_hw").mkdir()
    (tmp_path / "macram_hw" / "part.py").write_text("a = 1\na = 1\n")
    with pytest.raises(ValueError, match=r"part\.py holds 'a = 1' 2 times; bring"):
        Break("part.py", "a = 1", "a = 2").apply(tmp_path)


@pytest.mark.slow
def test_the_last_cycle_of_a_bounded_proof_counts(tmp_path):
    """An end that never comes shows in the last cycle alone."""
    proof = next(proof for proof in PROOFS if proof.name == "frame")
    never = OPENING + "    always @(posedge clk) assert (age != 4);\nendmodule\n"
    assert prove(replace(proof, harness=lambda: never, depth=4, breaks=()), tmp_path).passed
    assert not prove(replace(proof, harness=lambda: never, depth=5, breaks=()), tmp_path).passed


@pytest.mark.slow
def test_a_late_fault_is_found_without_a_search_before(tmp_path):
    proof = next(proof for proof in PROOFS if proof.name == "frame")
    (change, *_) = proof.breaks
    late = (
        OPENING
        + """
    wire open;
    dut dut(.clk(clk), .rst(rst), .start(1'b0), .i__valid(1'b1), .o__ready(1'b1), .o__valid(open));
    always @(posedge clk) if (age > 1) assert (age < 16 || !open);
endmodule
"""
    )
    verdict = prove(
        replace(proof, harness=lambda: late, depth=17, breaks=(replace(change, late=True),)), tmp_path
    )
    assert list(verdict.noticed.values()) == [True], verdict.fault
