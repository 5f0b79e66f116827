"""The paper's tables IV and V, digit for digit, from the instantiated modules."""

from __future__ import annotations

import argparse
import json
from dataclasses import replace

import pytest
import torch

from macram.cli import counts_verb
from macram.model import Faults, spacenet_config
from macram.model.anchors import map_sizes
from macram.model.counts import count_network, part_of, quantised_parts

PUBLISHED = spacenet_config("paper", "published")


@pytest.fixture(scope="module")
def published():
    return count_network(PUBLISHED)


def parameters(**fields):
    config = replace(PUBLISHED, **fields)
    return count_network(replace(config, image_size=32)).parameters


def test_parameters(published):
    assert published.parameters == 53_783_006


def test_near_misses_are_told_apart():
    assert parameters(faults=Faults()) == 56_732_638
    assert parameters(classifier=False) == 52_758_006
    assert parameters(counterfactual=False) == 51_553_246
    assert parameters(keypoints=11) == 53_796_836


def test_multiply_accumulates(published):
    assert published.macs("first") == 226_492_416
    assert published.quantised_macs("I") == 36_909_875_200
    assert published.quantised_macs("II") == 44_512_051_200
    assert published.quantised_macs("III") == 70_470_389_760
    assert published.macs() == 70_696_882_176
    assert published.macs("pyramids") == 7_602_176_000
    assert published.macs("head") == 25_958_338_560


def test_modules_runs_and_cells(published):
    modules = {p: [c for c in published.convs if c.part == p] for p in ("backbone", "pyramids", "head")}
    assert [len(convs) for convs in modules.values()] == [51, 14, 10]
    assert [sum(c.runs for c in convs) for convs in modules.values()] == [51, 16, 50]
    assert published.cells == 5_456
    assert [rows for rows, _ in map_sizes(512, 512)] == [64, 32, 16, 8, 4]
    assert [rows for rows, _ in map_sizes(960, 960)] == [120, 60, 30, 15, 8]


def test_quantised_weights_of_mode_iii(published):
    assert sum(c.weights for c in published.convs if c.part != "first") == 52_711_680


def test_table_iv(published):
    rows = [
        tuple(f"{row[key]:.2f}" for key in ("quantised_g", "remaining_g", "share_percent"))
        for row in published.operations
    ]
    assert rows == [("36.91", "33.79", "52.21"), ("44.51", "26.19", "62.96"), ("70.47", "0.23", "99.67")]
    assert published.operations[1]["remaining_macs"] == 26_184_830_976


def test_table_v(published):
    rows = [
        tuple(f"{row[key]:.2f}" for key in ("parameters_m", "size_mb", "saving_percent"))
        for row in published.storage
    ]
    assert rows == [
        ("51.29", "205.17", "0.00"),
        ("51.29", "51.29", "75.00"),
        ("51.29", "19.23", "90.63"),
    ]
    assert [row["size_bits"] for row in published.storage] == [53_783_006 * b for b in (32, 8, 3)]


def test_the_corrected_network_costs_the_same_operations(published):
    corrected = count_network(spacenet_config("paper"))
    assert corrected.macs() == published.macs()
    assert [len([c for c in corrected.convs if c.part == p]) for p in ("pyramids", "head")] == [16, 10]


def test_speed_at_960_with_16_outputs():
    fields = {"image_size": 960, "levels": spacenet_config(dataset="speed").levels}
    counts = count_network(replace(PUBLISHED, **fields))
    wanted = {"first": 0.796, "I": 129.76, "II": 156.50, "III": 247.79, "total": 248.59}
    found = {m: counts.quantised_macs(m) for m in ("I", "II", "III")}
    found |= {"first": counts.macs("first"), "total": counts.macs()}
    for name, value in wanted.items():
        assert round(found[name] / 1e9, 3 if name == "first" else 2) == value


def test_counting_touches_no_random_state():
    before = torch.get_rng_state()
    count_network(spacenet_config("tiny"))
    assert torch.equal(torch.get_rng_state(), before)


def test_parts_by_name_and_mode():
    assert part_of("backbone.init.conv") == "first"
    assert part_of("backbone.stages.0.entry.conv") == "backbone"
    assert part_of("fpn_pseudo.laterals.0") == part_of("fpn.top.p7") == "pyramids"
    assert part_of("head.pose") == "head"
    assert quantised_parts("II") == ("backbone", "pyramids")
    with pytest.raises(ValueError, match="mode must be one of I, II, III, not 'IV'"):
        quantised_parts("IV")


def run(capsys, *words):
    top = argparse.ArgumentParser()
    verbs = top.add_subparsers()
    counts_verb.add_parser(lambda name, module, summary, detail: verbs.add_parser(name, help=summary))
    assert counts_verb.counts(top.parse_args(["counts", *words])) == 0
    return capsys.readouterr().out


def test_the_verb_prints_the_published_figures(capsys):
    out = run(capsys)
    for figure in (
        "36.91 + 33.79", "44.51 + 26.19", "70.47 + 0.23", "52.21", "62.96", "99.67",
        "51.29 M", "205.17 MB", "51.29 MB", "19.23 MB", "0.00", "75.00", "90.63",
        "53,783,006", "36,909,875,200", "44,512,051,200", "70,470,389,760",
    ):  # fmt: skip
        assert figure in out


def test_json_carries_the_integers(capsys):
    report = json.loads(run(capsys, "--json"))
    assert report["parameters"] == 53_783_006
    assert report["macs"]["total"] == 70_696_882_176
    assert len(report["convs"]) == report["conv_modules"] == 76
    assert report["conv_runs"] == 118
    assert sum(conv["macs"] for conv in report["convs"]) == 70_696_882_176
    small = json.loads(run(capsys, "--json", "--size", "tiny", "--variant", "deployable"))
    assert small["parameters"] < 1_000_000
    assert small["network"] == {"size": "tiny", "variant": "deployable", "dataset": "swisscube"}


def test_unknown_names_are_refused(capsys):
    with pytest.raises(ValueError, match=r"size must be one of paper, .* not 'huge'"):
        run(capsys, "--size", "huge")
