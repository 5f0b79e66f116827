"""The exported folder: its files, and its Tcl run on a model of Vivado."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import vivado_model
from vivado_model import Vivado, VivadoError

from macram.cli import main
from macram.export import default_array, export_vivado
from macram.export.ports import find_interfaces, read_ports
from macram.golden import random_case, selftest_case
from macram.pack import pack_layer, read_packed
from macram.spec import ArrayConfig, ConvSpec

TINY = ArrayConfig(
    name="tiny-array_x.y", units=8, rows=2, drain=2, max_c_in=16, max_c_out=32, weight_depth=64,
    row_words=32, stream_bits=32,
)  # fmt: skip
DOUBLED = ArrayConfig(
    name="doubled", units=8, rows=3, drain=2, max_c_in=15, max_c_out=32, weight_depth=64, row_words=32,
    stream_bits=32, engine="dsp48e2_2x", soft_rows=1, residual_stream_bits=64,
)  # fmt: skip
"""With two clocks and a residual stream of another width than the image's."""
STREAM = ("tdata", "tvalid", "tready", "tlast")


@pytest.fixture(scope="module")
def exported(tmp_path_factory):
    folder = tmp_path_factory.mktemp("export") / "vivado"
    export_vivado(TINY, selftest_case(TINY), folder)
    return folder


@pytest.fixture(scope="module")
def doubled(tmp_path_factory):
    folder = tmp_path_factory.mktemp("export") / "doubled"
    export_vivado(DOUBLED, selftest_case(DOUBLED), folder)
    return folder


@pytest.fixture
def double_folder(doubled, tmp_path):
    return Path(shutil.copytree(doubled, tmp_path / "vivado"))


@pytest.fixture
def folder(exported, tmp_path):
    return Path(shutil.copytree(exported, tmp_path / "vivado"))


def session(folder):
    return Vivado(folder)


# ---- the files -----------------------------------------------------------------------------------------


def test_the_manifest_has_the_hash_of_every_file(exported):
    manifest = json.loads((exported / "manifest.json").read_text())
    found = {path.relative_to(exported).as_posix() for path in exported.rglob("*") if path.is_file()}
    assert found == set(manifest["sha256"]) | {"manifest.json"}
    for name, digest in manifest["sha256"].items():
        assert hashlib.sha256((exported / name).read_bytes()).hexdigest() == digest
    assert ArrayConfig.from_dict(manifest["array"]) == TINY


def test_the_same_array_and_layer_give_the_same_bytes(exported, tmp_path):
    again = export_vivado(TINY, selftest_case(TINY), tmp_path / "again")
    assert again == json.loads((exported / "manifest.json").read_text())


def test_every_process_writes_the_same_bytes(doubled, tmp_path):
    """Sets of names are in another order in every process, unless PYTHONHASHSEED says which."""
    config = tmp_path / "doubled.toml"
    lines = [f"{key} = {json.dumps(value)}\n" for key, value in DOUBLED.to_dict().items()]
    config.write_text("[array]\n" + "".join(lines))
    command = ["export", "vivado", "--config", str(config), "-o"]
    for seed in ("0", "1"):  # which differ in the order of the clock domains' names
        out = tmp_path / seed
        code = f"from macram.cli import main; main({[*command, str(out)]!r})"
        subprocess.run(
            [sys.executable, "-c", code],
            env=os.environ | {"PYTHONHASHSEED": seed},
            check=True,
            capture_output=True,
        )
        assert files_of(out) == files_of(doubled)


def files_of(folder):
    return {
        path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()
    }


def test_memory_images_are_those_of_the_layer(exported):
    packed, wanted = read_packed(exported / "mem"), pack_layer(selftest_case(TINY), TINY)
    assert (packed.weights == wanted.weights).all()
    assert (packed.requant == wanted.requant).all()


def test_simulation_models_and_waivers_stay_away(tmp_path):
    array = ArrayConfig.from_dict(TINY.to_dict() | {"engine": "dsp48e2"})
    export_vivado(array, selftest_case(array), tmp_path / "vivado")
    names = {path.name for path in (tmp_path / "vivado/rtl").iterdir()}
    assert not names & {"DSP48E2.v", "lint.vlt"}
    assert "DSP48E2 #" in (tmp_path / "vivado/rtl/macram_unit.v").read_text(), (
        "the vendor's primitive is used"
    )
    assert "module DSP48E2" not in "".join(p.read_text() for p in (tmp_path / "vivado/rtl").iterdir())


def test_a_second_export_replaces_the_first_and_leaves_the_products(folder):
    for name in ("overlay/macram.bit", "reports/macram_timing.rpt", "work/x"):
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text("by Vivado")
    case = random_case(ConvSpec(3, 5, 4, 6), 1)
    smaller = ArrayConfig.from_dict(TINY.to_dict() | {"units": 4, "drain": 1, "name": "four"})
    export_vivado(smaller, case, folder)
    assert (folder / "mem/unit_003.mem").exists()
    assert not (folder / "mem/unit_004.mem").exists()
    assert (folder / "overlay/macram.bit").read_text() == "by Vivado"
    assert (read_packed(folder / "mem").array, (folder / "work/x").exists()) == (smaller, True)


def test_somebody_elses_folder_is_left_alone(tmp_path, capsys):
    (tmp_path / "thesis.txt").write_text("mine")
    assert main(["export", "vivado", "-o", str(tmp_path)]) == 2
    assert "holds something other than an earlier export; choose a new" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["thesis.txt"]


def test_the_command(tmp_path, capsys):
    config = tmp_path / "array.toml"
    config.write_text(
        '[array]\nname = "small"\nunits = 8\nrows = 2\ndrain = 2\nmax_c_in = 16\nmax_c_out = 32\nweight_depth = 64\n'
        "row_words = 32\n"
    )
    layer = tmp_path / "layer.npz"
    random_case(ConvSpec(3, 5, 4, 6), 1).save(layer)
    arguments = ["export", "vivado", "-o", str(tmp_path / "out"), "--config", str(config), "--layer"]
    assert main([*arguments, str(layer)]) == 0
    assert "vivado -mode batch -source build.tcl" in capsys.readouterr().out
    random_case(ConvSpec(40, 5, 4, 6), 1).save(layer)
    before = (tmp_path / "out/manifest.json").read_bytes()
    assert main([*arguments, str(layer)]) == 2
    assert "layer.npz: c_in must be at most 16, not 40" in capsys.readouterr().err
    assert (tmp_path / "out/manifest.json").read_bytes() == before
    assert not list(tmp_path.glob(".out-*")), "nothing half-written stays"


def test_the_default_is_the_array_for_the_boards_device():
    array = default_array()
    assert (array.name, array.engine) == ("zu3eg", "dsp48e2_2x")


# ---- the scripts ---------------------------------------------------------------------------------------


def test_the_tcl_lints(exported):
    tclint = [Path(sys.executable).with_name("tclint"), "--style-line-length", "120"]
    written = [exported / "build.tcl", *exported.glob("[!bs]*.tcl"), exported / "constraints.xdc"]
    assert len(written) == 6
    # In the file that is generated, an interface stands on one line however long.
    for files in (written, ["--ignore", "line-length", exported / "settings.tcl"]):
        done = subprocess.run([*tclint, *files], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr
    faulty = exported.parent / "faulty.tcl"
    faulty.write_text("set x [list 1 2\n")
    assert subprocess.run([*tclint, faulty], capture_output=True, check=False).returncode


@pytest.mark.parametrize("infers", [True, False])
@pytest.mark.parametrize(
    ("boards", "chosen"),
    [
        ([], ""),
        (["em.avnet.com:ultra96v2:part0:1.0"], "em.avnet.com:ultra96v2:part0:1.0"),
        (
            [
                "avnet.com:ultra96v2:part0:1.2",
                "avnet.com:ultra96v2:part0:1.10",
                "avnet.com:ultra96v1:part0:9",
            ],
            "avnet.com:ultra96v2:part0:1.10",
        ),
    ],
)
def test_build(folder, infers, boards, chosen):
    vivado = session(folder)
    vivado.infers, vivado.boards = infers, boards
    vivado.source("build.tcl")
    assert vivado.properties.get(("project", "board_part"), "") == chosen
    assert vivado.automated == bool(chosen)
    assert vivado.cells["ps"] == "zynq_ultra_ps_e"
    assert "xilinx.com:ip:zynq_ultra_ps_e:3.5" in str(vivado.calls), "the newest core is taken"
    assert vivado.links["dma_image/M_AXIS_MM2S"] == "macram_0/s_axis"
    assert vivado.links["dma_param/M_AXIS_MM2S"] == "macram_0/s_axis_param"
    assert vivado.links["macram_0/m_axis"] == "dma_image/S_AXIS_S2MM"
    assert vivado.windows["ps/Data"][0] == ("macram_0/s_axi/reg0", 0xA0000000, 0x1000)
    assert "macram_wrapper.bit" in (folder / "overlay/macram.bit").read_text()
    assert "macram.hwh" in (folder / "overlay/macram.hwh").read_text()
    assert (folder / "macram.xsa").exists()
    assert {path.name for path in (folder / "reports").iterdir()} == {
        f"macram_{kind}.rpt" for kind in ("timing", "util", "power", "drc")
    }


def test_a_build_can_be_repeated(folder):
    for _ in range(2):
        session(folder).source("build.tcl")


def test_build_with_two_clocks_and_a_residual_stream(double_folder):
    vivado = session(double_folder)
    vivado.source("build.tcl")
    nets, links = vivado.nets, vivado.links
    assert nets["macram_0/aclk2x"] == "clocks/clk_out2"
    slow = [pin for pin, driver in nets.items() if driver == "clocks/clk_out1"]
    assert {"macram_0/aclk", "reset/slowest_sync_clk", "ps/saxihp0_fpd_aclk", "ps/maxihpm0_fpd_aclk"} <= set(
        slow
    )
    assert len([pin for pin in slow if pin.startswith("dma_")]) == 8, "two of each DMA, and one per receiver"
    assert nets["clocks/resetn"] == nets["reset/ext_reset_in"] == "ps/pl_resetn0"
    assert nets["reset/dcm_locked"] == "clocks/locked"
    assert nets["dma_residual/axi_resetn"] == nets["macram_0/aresetn"] == "reset/peripheral_aresetn"
    assert links["dma_residual/M_AXIS_MM2S"] == "macram_0/s_axis_residual"
    assert links["macram_0/m_axis_residual"] == "dma_residual/S_AXIS_S2MM"
    widths = vivado.configuration["dma_residual"], vivado.configuration["dma_image"]
    assert [one["c_m_axis_mm2s_tdata_width"] for one in widths] == ["64", "32"]
    assert [one["c_s_axis_s2mm_tdata_width"] for one in widths] == ["64", "32"]
    assert [name for name, *_ in vivado.windows["ps/Data"]] == [
        "macram_0/s_axi/reg0",
        *(f"dma_{name}/S_AXI_LITE/Reg" for name in ("image", "param", "residual")),
    ]
    again = session(double_folder)
    again.source("ooc.tcl")
    assert again.clocks == {"aclk": 10.0, "aclk2x": 5.0}


@pytest.mark.parametrize("packs", ["drops", "unknown", "mem"])
def test_memory_images_reach_synthesis_whatever_packaging_does_with_them(folder, packs):
    vivado = session(folder)
    vivado.packs = packs
    vivado.source("build.tcl")
    images = {path.name for path in (folder / "mem").glob("*.mem")}
    assert len(images) == TINY.units + 1
    assert {path.name for path in (folder / "ip/src").glob("*.mem")} == images
    for group in ("synthesis", "behavioralsimulation"):
        listed = vivado.groups[f"xilinx_anylanguage{group}"]
        assert {Path(name).name for name in listed if name.endswith(".mem")} == images
        assert len(listed) == len(set(listed))


def test_memory_images_hold_words_alone(exported):
    for path in (exported / "mem").glob("*.mem"):
        assert "//" not in path.read_text(), path.name
    lines = (exported / "mem/unit_000.mem").read_text().split()
    assert len(lines) == TINY.weight_depth, "as many as the memory has words"


@pytest.mark.parametrize("script", ["build.tcl", "ooc.tcl"])
def test_a_memory_image_that_is_lost_ends_the_build(folder, script):
    (folder / "mem/unit_002.mem").unlink()
    with pytest.raises(VivadoError, match=r"lacks the memory image unit_002\.mem"):
        session(folder).source(script)


def test_out_of_context(folder):
    vivado = session(folder)
    vivado.source("ooc.tcl")
    assert vivado.clocks == {"aclk": 10.0}
    assert {path.name for path in (folder / "reports").iterdir()} == {
        "ooc_synth_util.rpt", "ooc_util.rpt", "ooc_timing.rpt",
    }  # fmt: skip


def test_what_goes_wrong_in_vivado_is_said(folder):
    vivado = session(folder)
    vivado.parts = {"xc7z020clg400-1"}
    with pytest.raises(
        VivadoError, match="knows neither xczu3eg-sbva484-1-i nor xczu3eg-sbva484-1-e; install device support"
    ):
        vivado.source("build.tcl")
    vivado = session(folder)
    vivado.parts = {"xczu3eg-sbva484-1-e"}
    vivado.slack = -0.1
    with pytest.raises(VivadoError, match=r"timing is not met \(setup slack -0.1 ns\)"):
        vivado.source("build.tcl")
    with pytest.raises(VivadoError, match="timing is not met"):
        vivado.source("ooc.tcl")
    assert not (folder / "overlay/macram.bit").exists(), "a bitstream that misses timing is not handed on"
    vivado = session(folder)
    vivado.failing = {"impl_1"}
    with pytest.raises(VivadoError, match="impl_1 stopped: route_design ERROR; see work"):
        vivado.source("build.tcl")


@pytest.mark.parametrize(
    ("script", "right", "wrong", "message"),
    [
        ("settings.tcl", "AWPROT s_axi_awprot", "AWPROT s_axi_awprt", "no port s_axi_awprt"),
        ("settings.tcl", "TLAST s_axis_param_tlast", "", "maps"),
        ("settings.tcl", "m_axis axis master", "m_axis axis slave", "is an output in a slave"),
        ("settings.tcl", "0xA0010000 0x10000", "0xA0000000 0x10000", "overlaps macram_0"),
        ("settings.tcl", "0xA0020000", "0x80020000", "out of reach"),
        ("settings.tcl", "s_axis 32 {m_axis} 32", "s_axis 64 {m_axis} 32", "differ: axis 64"),
        ("settings.tcl", "s_axis 32 {m_axis} 32", "s_axis 32 {} 0", "m_axis is open"),
        ("settings.tcl", "clock_mhz) 100", "clock_mhz) 90", "pl_clk0 runs at 90"),
        ("package_ip.tcl", "ACTIVE_LOW", "ACTIVE_HIGH", "low active"),
        ("package_ip.tcl", "mem *.mem", "mem unit_*.mem", "lacks the memory image requant.mem"),
        ("package_ip.tcl", "    ensure_memory_images $core $root $images\n", "", "lacks the memory image requant"),
        ("package_ip.tcl", "set_property type mem $file", "", "of type unknown: synthesis passes it over"),
        ("package_ip.tcl", "[string match *simulation $name]", "0", "simulation of the core lacks the memory"),
        ("package_ip.tcl", " -import_files", "", "point at files outside"),
        ("build.tcl", "\ninsist_on_memory_images\n", "\n", "missing would only be a warning"),
        ("build.tcl", "synth_checkpoint_mode None", "synth_checkpoint_mode Hierarchical", "severities of its own"),
        ("mem/unit_003.mem", "0", "// 0", "unit_003.mem, line 1 is no word: //"),
        ("design.tcl", "fan_out reset/peripheral_aresetn $held", "", "aresetn is open"),
        ("design.tcl", "lappend clocked $dma/m_axi_s2mm_aclk", "", "m_axi_s2mm_aclk is open"),
        ("design.tcl", "lappend memory $dma/M_AXI_S2MM", "", "M_AXI_S2MM is open"),
        ("design.tcl", "lappend spaces $dma/Data_S2MM", "", "Data_S2MM does not see"),
        ("design.tcl", "PSU__USE__M_AXI_GP1 0", "PSU__USE__M_AXI_GP1 1", "maxihpm1_fpd_aclk is open"),
        ("design.tcl", "c_include_sg 0", "c_include_sg 1", "m_axi_sg_aclk is open"),
        ("design.tcl", "c_sg_length_width", "c_length_width", "no parameter c_length_width"),
        ("design.tcl", "HP0_DDR_HIGH HP0_LPS_OCM HP0_QSPI", "HP0_DDR_HIGH HP0_LPS_OCM", "HP0_QSPI is neither"),
        ("design.tcl", "ps/saxihp0_fpd_aclk}", "ps/saxihp0_aclk}", "no pin saxihp0_aclk"),
        ("design.tcl", "reset/ext_reset_in", "reset/aux_reset_in", "ext_reset_in is open"),
        ("build.tcl", "set_property top macram_wrapper [current_fileset]", "", "the wrapper is not the top"),
    ],
)  # fmt: skip
def test_the_model_notices_faults(folder, script, right, wrong, message):
    path = folder / script
    text = path.read_text()
    assert right in text
    path.write_text(text.replace(right, wrong, 1))
    with pytest.raises(VivadoError, match=message):
        session(folder).source("build.tcl")


@pytest.mark.parametrize(
    ("right", "wrong", "message"),
    [
        (
            "CLKOUT2_REQUESTED_OUT_FREQ [expr {2",
            "CLKOUT2_REQUESTED_OUT_FREQ [expr {3",
            "clocks of 100.0 and 300.0",
        ),
        ("CLKOUT2_MATCHED_ROUTING true", "CLKOUT2_MATCHED_ROUTING false", "not matched"),
        ("clocks/clk_out2 {macram_0/aclk2x}", "ps/pl_clk0 {macram_0/aclk2x}", "two sources of clocks"),
        ("fan_out clocks/locked {reset/dcm_locked}", "", "nothing waits"),
        ("set clock clocks/clk_out1", "set clock ps/pl_clk0", "two sources of clocks"),
        ("RESET_TYPE ACTIVE_LOW", "RESET_TYPE ACTIVE_HIGH", "wrong polarity"),
        ("join_interfaces macram_0/$answer $dma/S", "join_interfaces macram_0/m_axis $dma/S", "is taken"),
        ("lappend spaces $dma/Data_S2MM", "", "dma_image/Data_S2MM does not see"),
    ],
)
def test_the_model_notices_faults_of_two_clocks(double_folder, right, wrong, message):
    folder = double_folder
    path = folder / "design.tcl"
    text = path.read_text()
    assert right in text
    path.write_text(text.replace(right, wrong))
    with pytest.raises(VivadoError, match=message):
        session(folder).source("build.tcl")


# ---- ports and interfaces ------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda ports: ports.pop("aclk"), "no port aclk"),
        (lambda ports: ports.pop("aresetn"), "no port aresetn"),
        (lambda ports: ports.pop("s_axi_wstrb"), "no port s_axi_wstrb of the interface s_axi"),
        (lambda ports: ports.pop("m_axis_tlast"), "no port m_axis_tlast"),
        (
            lambda ports: ports.update(irq=ports["aclk"]),
            "port irq of the top level belongs to no bus interface",
        ),
        (lambda ports: [ports.pop(f"s_axis_{name}") for name in STREAM], "no stream s_axis"),
        (lambda ports: ports.update(m_axis_tvalid=ports["aclk"]), "is a master by its name"),
        (
            lambda ports: ports.update({f"m_axis_b_{name}": ports[f"m_axis_{name}"] for name in STREAM}),
            "the stream m_axis_b answers no stream s_axis_b",
        ),
    ],
)
def test_a_top_level_that_does_not_fit_is_refused(exported, change, message):
    ports = read_ports((exported / "rtl/macram_top.v").read_text(), "macram_top")
    directions, widths = vivado_model.verilog_ports(exported / "rtl/macram_top.v")
    assert {name: (port.direction, port.width) for name, port in ports.items()} == {
        name: (direction, widths[name]) for name, direction in directions.items()
    }
    find_interfaces(ports)
    change(ports)
    with pytest.raises(ValueError, match=message):
        find_interfaces(ports)


def test_a_file_without_the_module_is_refused():
    with pytest.raises(ValueError, match="no module macram_top"):
        read_ports("module other(a);\nendmodule\n", "macram_top")
