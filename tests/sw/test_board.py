"""The overlay's scripts, each in a process that has only what the overlay brings; and the transport's faults."""

from __future__ import annotations

import dataclasses
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from board_model import OverlayBoard
from test_driver import TINY, random_case

from macram.board import differences, read_overlay
from macram.driver import ArrayDriver, ArrayError, StreamTimeout
from macram.export.overlay import write_overlay
from macram.golden import run_layer
from macram.pack import pack_layer
from macram.pynq_transport import MAX_TRANSFER, PynqTransport, run_sync
from macram.spec import BY_NAME, ConvSpec, Error

HERE = Path(__file__).parent
LAYER = random_case(ConvSpec(16, 14, 6, 9), 11)
SCRIPT = """\
import runpy, sys
class Missing:
    def find_spec(self, name, path=None, target=None):
        if name in ("tomllib", "macram_hw", "amaranth", "rich", "PIL"):
            raise ImportError(f"boards have no {name}")
sys.meta_path.insert(0, Missing())
sys.path[0] = sys.argv[1].rpartition("/")[0]
sys.argv = sys.argv[1:]
try:
    runpy.run_path(sys.argv[0], run_name="__main__")
finally:
    import macram.spec
    used = [m.__file__ for n, m in sys.modules.items() if n.partition(".")[0] == "macram"]
    assert all(name.startswith(sys.path[0]) for name in used), used
"""


@pytest.fixture(scope="module")
def exported(tmp_path_factory):
    return overlay(tmp_path_factory.mktemp("board") / "overlay", TINY)


def overlay(folder, array):
    """An overlay of ``array``, with what Vivado would add and a ``pynq`` beside it."""
    write_overlay(folder, array, LAYER, run_layer(LAYER))
    for name in ("macram.bit", "macram.hwh"):
        (folder / name).write_text("a model")
    (folder.parent / "pynq.py").write_text("from board_model import Clocks, Overlay, allocate\n")
    return folder


def run(folder, script, *arguments, fault="", pynq=True):
    """Exit status and output of one of the overlay's scripts."""
    modules = [str(folder.parent), str(HERE)] if pynq else []
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT, str(folder / script), *arguments],
        env=os.environ | {"PYTHONPATH": os.pathsep.join(modules), "BOARD_FAULT": fault},
        capture_output=True, text=True, check=False, cwd=folder,
    )  # fmt: skip
    assert "Traceback" not in done.stderr, done.stderr
    return done.returncode, done.stdout


def test_run_reference(exported, tmp_path):
    status, text = run(exported, "run_reference.py", "--json", str(tmp_path / "result.json"))
    assert status == 0, text
    assert "array 'tiny' at 99.999 MHz" in text
    table = json.loads((tmp_path / "result.json").read_text())
    assert f"{table['compared']:,} codes compared, 0 differ" in text
    assert (table["compared"], table["mismatches"]) == (run_layer(LAYER).size, 0)
    assert table["counters"]["cycles"] == 1000, "as the model's counter says"
    assert table["milliseconds"] == pytest.approx(1000 / 99.999 / 1000)


def test_selftest(exported):
    status, text = run(exported, "selftest.py")
    assert status == 0, text
    assert [line.partition(" ")[0] for line in text.splitlines()] == ["ok"] * 9


@pytest.fixture(scope="module")
def exported_with_adder(tmp_path_factory):
    array = dataclasses.replace(TINY, name="tiny-residual", residual_stream_bits=64)
    return overlay(tmp_path_factory.mktemp("board") / "overlay", array)


@pytest.mark.parametrize(("fault", "steps"), [("", 10), ("wrong sum", 7)])
def test_selftest_of_an_array_with_a_residual_adder(exported_with_adder, fault, steps):
    status, text = run(exported_with_adder, "selftest.py", fault=fault)
    assert status == bool(fault), text
    said = text.splitlines()
    assert [line.partition(" ")[0] for line in said].count("ok") == steps
    if fault:
        assert said[-1].startswith("FAILED  a residual stream is added to, code by code: ")


@pytest.mark.parametrize(
    ("fault", "said"),
    [
        ("wrong code", "FAILED  weights in the bitstream give the golden codes: 1 of"),
        ("not preloaded", "FAILED  weights in the bitstream give the golden codes"),
        ("another array", "FAILED  the array is the one the overlay was exported from: GEOMETRY is 0x"),
        ("register sticks", "FAILED  registers hold what is written: WIDTH holds 0x5a5b"),
        ("accepts anything", "FAILED  a command with an impossible shape is refused and forgotten: ERROR is 0"),
        ("short output", "FAILED  weights in the bitstream give the golden codes: the output stream ended after"),
        ("memory error", "input stream failed: DMA Slave Error"),
        ("stays busy", "the array is still busy after"),
        ("another clock", "FAILED: pl_clk0 runs at 187.5 MHz, the overlay was built for 100 MHz"),
        ("reset hangs", "FAILED  an image that ends early is noticed, and reset recovers: the image DMA stays"),
        ("hangs", "the input stream did not finish within 0.5 s"),
    ],
)  # fmt: skip
def test_selftest_says_what_is_wrong(exported, fault, said):
    status, text = run(exported, "selftest.py", fault=fault)
    assert status == 1
    assert said in text.splitlines()[-1]


def test_run_reference_counts_wrong_codes(exported):
    status, text = run(exported, "run_reference.py", fault="wrong code")
    assert status == 1
    assert "codes compared, 1 differ; first at channel" in text


@pytest.mark.parametrize(
    ("damage", "said"),
    [
        (lambda f: (f / "macram.bit").unlink(), "macram.bit: no such file; build it with Vivado"),
        (lambda f: (f / "macram.hwh").unlink(), "macram.hwh: no such file"),
        (lambda f: (f / "expected.npz").unlink(), "expected.npz: No such file or directory; copy the whole"),
        (lambda f: (f / "layer.npz").write_bytes(b"x"), "layer.npz: differs from the one that was exported"),
        (lambda f: (f / "macram/driver.py").open("a").write("#"), "driver.py: differs from the one"),
        (lambda f: (f / "overlay.json").write_text("{}"), "overlay.json: is not an overlay's manifest"),
        (lambda f: (f / "overlay.json").unlink(), "overlay.json: No such file or directory"),
    ],
)
def test_a_damaged_overlay_is_refused(exported, tmp_path, damage, said):
    folder = Path(shutil.copytree(exported, tmp_path / "overlay"))
    damage(folder)
    status, text = run(folder, "run_reference.py")
    assert status == 2
    assert said in text.splitlines()[-1]


def test_without_pynq(exported):
    assert run(exported, "run_reference.py", pynq=False) == (2, "error: No module named 'pynq'\n")


def test_the_overlay_is_read_back(exported):
    files = read_overlay(exported)
    assert (files.array, files.clock_mhz) == (TINY, 100)
    np.testing.assert_array_equal(files.expected, run_layer(files.case))
    assert differences(files.expected, files.expected) == (0, "")
    wrong = files.expected.copy()
    wrong[2, 1, 3] += 1
    wrong[3, 0, 0] += 1
    count, where = differences(wrong, files.expected)
    assert count == 2
    assert where.startswith("first at channel 2, row 1, column 3: ")


# ---- the transport -------------------------------------------------------------------------------------


def board(fault="", timeout=0.05):
    case = random_case(ConvSpec(3, 5, 4, 6), 7)
    fake = OverlayBoard(TINY, case, fault)
    transport = PynqTransport(fake, fake.dma_image, fake.dma_param, fake.allocate, timeout=timeout)
    driver = ArrayDriver(transport, TINY)
    run_sync(driver.configure(case.spec))
    return case, fake, transport, driver


def test_buffers_go_through_the_cache_and_back():
    case, fake, _, driver = board()
    run_sync(driver.load(pack_layer(case, TINY)))
    np.testing.assert_array_equal(run_sync(driver.run(case.input)).codes, run_layer(case))
    assert len(fake.buffers_made) == 4
    assert all(buffer.freed for buffer in fake.buffers_made)


def test_a_transfer_that_hangs_is_cleared_by_a_reset():
    case, fake, transport, driver = board("hangs")
    with pytest.raises(StreamTimeout, match="input stream did not finish"):
        run_sync(driver.run(case.input))
    assert not any(buffer.freed for buffer in fake.buffers_made), "both channels are still at it"
    fake.kind = ""
    transport.reset()
    assert (fake.dma_image.resets, fake.dma_param.resets) == (1, 1)
    assert all(buffer.freed for buffer in fake.buffers_made)
    run_sync(driver.soft_reset())
    np.testing.assert_array_equal(run_sync(driver.run(case.input)).codes, run_layer(case))


def test_a_dma_error_is_not_waited_for_and_cleared_by_a_reset():
    case, fake, transport, driver = board("memory error", timeout=30)
    with pytest.raises(StreamTimeout, match=r"input stream failed: DMA Slave Error .*; reset the transport"):
        run_sync(driver.run(case.input))
    fake.kind = ""
    transport.reset()
    run_sync(driver.soft_reset())
    np.testing.assert_array_equal(run_sync(driver.run(case.input)).codes, run_layer(case))


def test_a_short_result_is_not_taken_for_a_whole_one():
    case, _, _, driver = board("short output")
    with pytest.raises(StreamTimeout, match=r"output stream ended after \d+ of \d+ bytes"):
        run_sync(driver.run(case.input))


def test_the_arrays_own_error_goes_before_the_timeout():
    case, fake, transport, driver = board()
    wanted = case.spec
    fake.registers["HEIGHT"] += 1
    with pytest.raises(ArrayError, match="TLAST_EARLY") as caught:
        run_sync(driver.run(case.input))
    assert caught.value.code is Error.TLAST_EARLY
    transport.reset()
    run_sync(driver.soft_reset())
    run_sync(driver.configure(wanted))
    np.testing.assert_array_equal(run_sync(driver.run(case.input)).codes, run_layer(case))


def test_an_array_that_stays_busy_is_given_up():
    case, _, _, driver = board("stays busy")
    with pytest.raises(ArrayError, match="still busy after"):
        run_sync(driver.run(case.input))


def test_a_reset_that_hangs_is_given_up():
    _, _, transport, _ = board("reset hangs")
    with pytest.raises(StreamTimeout, match="image DMA stays in reset"):
        transport.reset()


@pytest.mark.parametrize(
    ("beats", "out", "name"), [(MAX_TRANSFER + 1, 1, "input"), (1, MAX_TRANSFER + 1, "output")]
)
def test_more_than_a_transfer_holds_is_refused_before_it_starts(beats, out, name):
    _, fake, transport, _ = board()
    huge = np.broadcast_to(np.uint8(0), (beats, 1))
    with pytest.raises(ValueError, match=rf"{name} stream would carry 67108864 bytes, .* at most 67108863"):
        run_sync(transport.begin_stream(huge, out))
    with pytest.raises(ValueError, match="parameter stream would carry"):
        run_sync(transport.send_params(np.broadcast_to(np.uint8(0), (MAX_TRANSFER + 1, 1))))
    assert fake.buffers_made == []
    run_sync(transport.read(BY_NAME["STATUS"].offset))
