"""The demo's report: comparisons, pictures, JSON and page, with network and simulator replaced."""

from __future__ import annotations

import json
import re
import sys
import types
from contextlib import nullcontext
from html.parser import HTMLParser

import numpy as np
import pytest
from PIL import Image

from macram import golden, weights
from macram.cli import main
from macram.cli.console import open_console
from macram.cli.stages import Stages
from macram.golden import random_case, run_layer
from macram.layer_job import COUNTERS
from macram.report.page import cycle_rows, render
from macram.spec import ConvSpec

SPEC = ConvSpec(9, 12, 10, 14)


class Page(HTMLParser):
    """Checks that tags nest and collects text and the addresses a page names."""

    VOID = ("meta", "img", "br")

    def __init__(self, html):
        super().__init__()
        self.open, self.addresses, self.text = [], [], []
        self.feed(html)
        assert not self.open, f"unclosed {self.open}"

    def handle_starttag(self, tag, attrs):
        if tag not in self.VOID:
            self.open.append(tag)
        self.addresses += [value for key, value in attrs if key in ("src", "href")]

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if self.open and self.open[-1] != "style":
            self.text.append(data)


@pytest.fixture
def chain(monkeypatch):
    """The demo with a small layer: `.hardware` and `.deployed` may spoil the codes of either."""
    same = lambda codes: codes  # noqa: E731
    state = types.SimpleNamespace(hardware=same, deployed=same, spec=SPEC, front=[], learned=same)

    def learned_front(image, network, *, focal):
        case = random_case(state.spec, 1)
        about = network.about
        report = {
            "image": image.name, "cam_K": [1.0] * 9, "camera": "assumed", "network": network.name,
            "form": "3 bit", "solver": "RANSAC", "layer": "stage2.unit1.expand",
            "sha256": about["sha256"], "scores": about["scores"],
            "pose": {"cam_t_m2c": [1.0, 2.0, 300.0], "score": 0.5},
            "errors": {"rotation_deg": 2.5, "translation_mm": 3.5, "distance_mm": 301.0, "add_corners_d": 0.0625},
        }  # fmt: skip
        picture = np.asarray(Image.open(image).convert("RGB"))
        codes = state.learned(run_layer(case))
        return types.SimpleNamespace(report=report, picture=picture, case=case, deployed_codes=codes)

    def reference_case(image, **options):
        state.front.append((image, options))
        case = random_case(state.spec, options["seed"])
        return types.SimpleNamespace(
            case=case,
            deployed_codes=state.deployed(run_layer(case)),
            differing={"image": 0.0, "stage2": 0.00125},
            picture=np.asarray(Image.open(image).convert("RGB")),
            provenance={"image": image.name, "weights": "seeded <initialisation>", "steps": {"a": 0.5}},
        )

    def simulate(packed, codes, **options):
        expected = next(
            run_layer(case)
            for case in (random_case(state.spec, seed) for seed in (1, options["seed"]))
            if np.array_equal(case.input, codes)
        )
        counters = {name: 100 - 9 * i for i, name in enumerate(COUNTERS)}
        counters["cycles"] = sum(counters.values())
        produced = state.hardware(expected)
        return types.SimpleNamespace(
            codes=produced, counters=counters, build_seconds=0.0, wall_seconds=0.1, waves=None
        )

    monkeypatch.setitem(sys.modules, "macram.front", types.SimpleNamespace(reference_case=reference_case))
    pose = weights.role("pose")
    monkeypatch.setattr(weights, "role", {"pose": pose, "reference_layer": None}.get)
    learned = types.SimpleNamespace(learned_front=learned_front)
    monkeypatch.setitem(sys.modules, "macram.train.learned", learned)
    fake = types.SimpleNamespace(simulate=simulate, build_array=lambda array, *, waves: None)
    monkeypatch.setitem(sys.modules, "macram_sim", types.ModuleType("macram_sim"))
    monkeypatch.setitem(sys.modules, "macram_sim.array", fake)
    tools = types.SimpleNamespace(source="wheel", version="5.0")
    monkeypatch.setitem(sys.modules, "macram_sim.tools", types.SimpleNamespace(find_toolchain=lambda: tools))
    return state


@pytest.fixture
def photo(tmp_path):
    path = tmp_path / "photo.png"
    Image.fromarray(np.arange(24 * 32 * 3, dtype=np.uint8).reshape(24, 32, 3)).save(path)
    return path


def flip(codes):
    codes = codes.copy()
    codes[2, 3, 4] ^= 1
    return codes


def test_demo_leaves_everything_it_promises(chain, photo, tmp_path, capsys):
    out = tmp_path / "demo"
    assert main(["demo", "--image", str(photo), "-o", str(out), "--seed", "5"]) == 0
    lines = capsys.readouterr().out
    assert "[2/9] image through the paper-size network to the reference layer" in lines
    assert f"{12 * 10 * 14:,} output codes compared, 0 differ" in " ".join(lines.split())
    assert "report.html" in lines
    report = json.loads((out / "report.json").read_text())
    assert report["passed"]
    assert [row["compared"] for row in report["comparisons"]] == [1680] * 3
    assert len(report["stages"]) == 9
    names = [report["gallery"]["image"]["file"], report["gallery"]["sheet"]]
    names += [item["file"] for item in report["gallery"]["inputs"]]
    names += [item[k] for item in report["gallery"]["outputs"] for k in ("hardware", "golden", "difference")]
    for name in names:
        Image.open(out / name).verify()
    files = {path.name for path in out.iterdir()}
    names += ["pose.png"]
    assert files == {
        "layer.npz",
        "learned_layer.npz",
        "packed",
        "output.npz",
        "report.json",
        "report.html",
        *names,
    }
    assert chain.front[0][1]["seed"] == 5
    assert str(tmp_path) not in (out / "report.json").read_text() + (out / "report.html").read_text()


def test_page_is_whole_and_needs_nothing_else(chain, photo, tmp_path):
    assert main(["demo", "--image", str(photo), "-o", str(tmp_path / "d")]) == 0
    html = (tmp_path / "d/report.html").read_text()
    page = Page(html)
    text = " ".join(" ".join(page.text).split())
    assert len(page.addresses) == 2 + 8 + 3 * 6
    assert all(address.startswith("data:image/png;base64,") for address in page.addresses)
    assert "<script" not in html
    assert not re.search(r"url\(|@import|https?:", html)
    assert "1,680 output codes compared, 0 differ" in text
    assert "seeded <initialisation>" in text
    for name in ("multiply-accumulate", "fill", "input stall", "output stall", "drain"):
        assert name in text


@pytest.mark.parametrize(("wrong", "rows"), [("hardware", [0, 1, 1]), ("deployed", [1, 0, 1])])
def test_any_of_the_three_being_wrong_fails(wrong, rows, chain, photo, tmp_path, capsys):
    setattr(chain, wrong, flip)
    assert main(["demo", "--image", str(photo), "-o", str(tmp_path / "d")]) == 1
    report = json.loads((tmp_path / "d/report.json").read_text())
    assert [row["mismatches"] for row in report["comparisons"]] == rows
    assert not report["passed"]
    page = (tmp_path / "d/report.html").read_text()
    assert 'class="verdict bad"' in page
    assert "(2, 3, 4)" in page
    assert "1 differ" in capsys.readouterr().out


def test_a_wrong_code_of_the_learned_layer_fails(chain, photo, tmp_path, capsys):
    chain.learned = flip
    assert main(["demo", "--image", str(photo), "-o", str(tmp_path / "d")]) == 1
    report = json.loads((tmp_path / "d/report.json").read_text())
    assert [row["mismatches"] for row in report["pose"]["comparisons"]] == [1, 0, 1]
    assert not any(row["mismatches"] for row in report["comparisons"])


def test_three_times_the_same_wrong_code_is_no_proof_of_golden(chain, photo, tmp_path):
    chain.hardware = chain.deployed = flip
    assert main(["demo", "--image", str(photo), "-o", str(tmp_path / "d")]) == 1


def test_latency_appears_for_the_layer_of_the_paper_alone(chain, photo, tmp_path, monkeypatch):
    from macram.report import latency  # noqa: PLC0415

    assert main(["demo", "--image", str(photo), "-o", str(tmp_path / "d")]) == 0
    assert "26.16 ms" not in (tmp_path / "d/report.html").read_text()
    monkeypatch.setattr(latency, "REFERENCE", SPEC)
    assert main(["demo", "--image", str(photo), "-o", str(tmp_path / "d")]) == 0
    page = (tmp_path / "d/report.html").read_text()
    for text in ("26.16 ms", "10.25 ms", "5.99 ms", "Nothing has been timed on silicon"):
        assert text in page


NUMBER = re.compile(r"\d+(?:,\d{3})*(?:\.\d+)?")


def shown(value):
    """The ways in which the page may print a number."""
    yield from (f"{value:,}", f"{value:g}", f"{value:,.0f}", *(f"{value:.{digits}f}" for digits in (1, 2, 3)))
    yield from (f"{100 * value:.{digits}f}" for digits in (0, 1, 2, 4))


def numbers_of(table):
    """Every number of a JSON value as the page may print it, those inside its texts and keys too."""
    if isinstance(table, dict):
        return set().union(*map(numbers_of, table.keys()), *map(numbers_of, table.values()))
    if isinstance(table, list):
        return set().union(*map(numbers_of, table))
    if isinstance(table, str):
        return set(NUMBER.findall(table))
    return set() if table is None else set(shown(abs(table)))


def test_every_number_on_the_page_is_in_the_json(chain, photo, tmp_path, monkeypatch):
    from macram.report import latency  # noqa: PLC0415

    monkeypatch.setattr(latency, "REFERENCE", SPEC)
    assert main(["demo", "--image", str(photo), "-o", str(tmp_path / "d")]) == 0
    report = json.loads((tmp_path / "d/report.json").read_text())
    assert report["cycles_without_step"] == report["cycles"] - report["counters"]["mac_cycles"]
    known = numbers_of(report) | {"100", "32"}  # 100 MHz, 100 % in all, float32
    page = " ".join(Page((tmp_path / "d/report.html").read_text()).text)
    assert [number for number in NUMBER.findall(page) if number not in known] == []
    assert len(NUMBER.findall(page)) > 100


def test_cycle_rows_sum_to_the_total():
    counters = dict(zip(COUNTERS, (90, 4, 3, 2, 1), strict=True)) | {"cycles": 100}
    shares = {name: counters[name] / 100 for name in COUNTERS}
    report = {
        "cycles": 100, "counters": counters, "cycle_shares": shares, "estimate": {"total": 97, "fill_cycles": 4},
    }  # fmt: skip
    rows = cycle_rows(report)
    assert {row["counter"] for row in rows} == set(COUNTERS)
    assert sum(row["cycles"] for row in rows) == 100
    assert sum(row["share"] for row in rows) == pytest.approx(1)
    assert [row["estimate"] for row in rows] == [None, 4, None, None, None]


def test_a_missing_picture_is_an_error_not_a_gap(chain, photo, tmp_path):
    assert main(["demo", "--image", str(photo), "-o", str(tmp_path / "d")]) == 0
    report = json.loads((tmp_path / "d/report.json").read_text())
    with pytest.raises(KeyError, match=r"pose\.png"):
        render(report, {})


def test_stages_record_what_finished(capsys):
    stages = Stages(open_console(), 2)
    with stages("first"), nullcontext():
        pass
    with pytest.raises(ValueError, match="x"), stages("second"):
        raise ValueError("x")
    assert [row["name"] for row in stages.done] == ["first"]
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "[1/2] first ..."
    assert lines[1].startswith("[1/2] first ....")
    assert lines[1].endswith(" s")
    assert lines[2:] == ["[2/2] second ..."]


def test_off_a_terminal_a_stage_says_so_when_it_begins(capsys):
    stages = Stages(open_console())
    with stages("slow"):
        assert capsys.readouterr().out == "slow ...\n"
    assert capsys.readouterr().out.startswith("slow ....")


def test_the_stages_of_the_data_verbs_say_so_too(tmp_path, capsys):
    words = ["--tier", "smoke", "--seqs", "1", "1", "1", "--frames", "2", "--size", "64", "--jobs", "1"]
    assert main(["data", "render", "-o", str(tmp_path / "set"), *words]) == 0
    assert capsys.readouterr().out.startswith("rendering 6 pictures into ")
    assert main(["data", "verify", str(tmp_path / "set")]) == 0
    assert capsys.readouterr().out.startswith("checking 6 frames of ")


def test_golden_is_the_middle_of_the_comparison(chain, photo, tmp_path, monkeypatch):
    """The page compares with what the golden model says now, not with what the network says."""
    monkeypatch.setattr(golden, "run_layer", lambda case: flip(run_layer(case)))
    assert main(["demo", "--image", str(photo), "-o", str(tmp_path / "d")]) == 1
    report = json.loads((tmp_path / "d/report.json").read_text())
    assert [row["mismatches"] for row in report["comparisons"]] == [1, 1, 0]
