"""What holds for the whole repository: layers, a light command line, no machine paths, true instructions."""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from macram.cli.app import parser
from macram.spec.fixed import ENGINE_LATENCY, SECTIONS

ROOT = Path(__file__).resolve().parents[1]
CODE = {
    "macram": ROOT / "sw/macram",
    "macram_hw": ROOT / "hw/macram_hw",
    "macram_sim": ROOT / "sim/macram_sim",
}

LAYERS = (
    {"macram.spec", "macram.weights", "macram.kept"},
    {"macram.layer_file", "macram.perf", "macram_hw"},
    {"macram.golden"},
    {"macram.pack"},
    {"macram.transport"},
    {"macram.driver"},
    {"macram.pynq_transport", "macram_sim"},
    {"macram.board"},
    {"macram.export"},
    {"macram.data"},
    {"macram.pose"},
    {"macram.model"},
    {"macram.quant"},
    {"macram.front"},
    {"macram.report"},
    {"macram.train"},
    {"macram.layer_job", "macram.experiments"},
    {"macram.cpu_latency"},
    {"macram.synth"},
    {"macram.designs"},
    {"macram.network_latency", "macram.network"},
    {"macram.demo", "macram.bench"},
    {"macram.cli"},
)
"""Lowest first. A module imports its own layer's package and layers below, never another or one above."""
RANK = {name: rank for rank, names in enumerate(LAYERS) for name in names}
NETWORKS = {"macram.model", "macram.quant", "macram.front", "macram.train"}
"""Where networks live: the only place for torch at import time."""
LATE = {"macram.cpu_latency": {"torch"}, "macram.network_latency": {"torch"}, "macram.network": {"torch"}}
"""Imported inside a function, for a measurement."""
HARDWARE = {"amaranth": {"macram_hw"}, "cocotb": {"macram_sim"}, "cocotb_tools": {"macram_sim"}}


def layer_of(module):
    """``macram.pack.bits`` -> ``macram.pack``; ``macram_hw.unit`` -> ``macram_hw``."""
    top, _, rest = module.partition(".")
    return f"{top}.{rest.partition('.')[0]}" if top == "macram" and rest else top


def imports_of(tree, package):
    """Every imported module of a parsed file, and whether the import runs when the file is imported."""
    late = set()
    for node in ast.walk(tree):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            late |= {id(child) for child in ast.walk(node) if child is not node}
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING":
            late |= {id(child) for body in node.body for child in ast.walk(body)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield alias.name, id(node) not in late
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, "imports are absolute"
            if node.module == "macram":
                for alias in node.names:
                    name = f"macram.{alias.name}"
                    yield (name if name in RANK else "macram"), id(node) not in late
            else:
                yield node.module, id(node) not in late


def sources():
    for package, folder in CODE.items():
        for path in sorted(folder.rglob("*.py")):
            module = ".".join((package, *path.relative_to(folder).with_suffix("").parts))
            yield module.removesuffix(".__init__"), path


def faults_of(module, path):
    """Imports of one file that break the rules, as readable lines."""
    mine, faults = layer_of(module), []
    for name, at_import in imports_of(ast.parse(path.read_text()), module):
        top, theirs = name.partition(".")[0], layer_of(name)
        if top in CODE and theirs not in (mine, "macram"):
            if theirs not in RANK:
                faults.append(f"{module}: {theirs} has no place in LAYERS")
            elif RANK[theirs] >= RANK[mine]:
                faults.append(f"{module} must not import {name}")
        if top == "torch" and mine not in NETWORKS and (at_import or "torch" not in LATE.get(mine, ())):
            faults.append(f"{module} must not import torch")
        if top in HARDWARE and mine not in HARDWARE[top]:
            faults.append(f"{module} must not import {top}")
    return faults


def test_every_module_has_a_layer():
    found = {layer_of(module) for module, _ in sources()} - {"macram"}
    assert found == set(RANK)


def test_imports_point_one_way():
    faults = [line for module, path in sources() for line in faults_of(module, path)]
    assert not faults, "\n".join(faults)


@pytest.mark.parametrize(
    ("module", "text"),
    [
        ("macram.spec.array", "from macram.golden import conv2d"),
        ("macram.spec.array", "from macram import golden"),
        ("macram_hw.unit", "import macram.pack"),
        ("macram_hw.unit", "from macram_sim.runner import build"),
        ("macram.golden.conv", "def f():\n    import torch"),
        ("macram.bench", "import torch"),
        ("macram.pack.bits", "from amaranth.hdl import Module"),
    ],
)
def test_a_wrong_import_is_noticed(module, text, tmp_path):
    path = tmp_path / "module.py"
    path.write_text(text)
    assert faults_of(module, path)


def test_gateware_files_have_no_future_annotations():
    """They would silently empty the annotated components."""
    for path in CODE["macram_hw"].rglob("*.py"):
        assert "from __future__ import annotations" not in path.read_text(), path


# ---- the command starts at once -----------------------------------------------------------------------


def test_the_command_line_imports_nothing_heavy():
    """Up to the end of ``--help``: what is not imported takes no time."""
    code = (
        "import atexit, sys; atexit.register(lambda: print(*sorted(sys.modules), file=sys.stderr));"
        "import macram.cli; macram.cli.main(['--help'])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "examples:" in done.stdout
    loaded = {name.partition(".")[0] for name in done.stderr.split()}
    heavy = {
        "torch",
        "amaranth",
        "cocotb",
        "cv2",
        "numpy",
        "matplotlib",
        "PIL",
        "jinja2",
        "rich",
        "macram_hw",
        "macram_sim",
    }
    assert not loaded & heavy
    assert "macram" in loaded


# ---- the tree ------------------------------------------------------------------------------------------


def tree_files():
    """Tracked files and new ones that git does not ignore."""
    done = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )  # fmt: skip
    if done.returncode:
        pytest.skip("not a git checkout")
    return [ROOT / line for line in done.stdout.splitlines() if (ROOT / line).is_file()]


MACHINE_PATH = re.compile(
    r"(?<![\w.$})/-])/(?:" + "|".join(["work", "home", "root", "Users", "mnt"]) + r")/[\w.]"
)


def test_no_file_names_a_folder_of_somebodys_machine():
    found = []
    for path in tree_files():
        try:
            text = path.read_text()
        except UnicodeDecodeError:
            continue
        found += [f"{path.relative_to(ROOT)}: {match[0]}" for match in MACHINE_PATH.finditer(text)]
    assert not found, "\n".join(found)


def test_the_pattern_finds_such_folders():
    for name in ("work", "home", "Users"):
        assert MACHINE_PATH.search(f"see /{name}/somebody/file")
    assert not MACHINE_PATH.search("sw/work/x, $(BIN)/root/x, network/home/x")


# ---- what the documents tell people to type ------------------------------------------------------------


def documents():
    return [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


def make_targets():
    return set(re.findall(r"^([a-z][a-z-]*):", (ROOT / "Makefile").read_text(), re.MULTILINE))


def typed(text):
    """Command words inside code spans and code blocks: ``("make", "demo")``, ``("macram", "layer")``."""
    code = re.findall(r"```.*?```|`[^`\n]+`", text, re.DOTALL)
    return re.findall(r"(?:^|[`\s;&])(make|macram) ([a-z][a-z-]*)", "\n".join(code), re.MULTILINE)


@pytest.mark.parametrize("path", documents(), ids=lambda path: path.name)
def test_commands_in_documents_exist(path):
    verbs = set(parser()._subparsers._group_actions[0].choices)
    for command, word in typed(path.read_text()):
        assert word in (make_targets() if command == "make" else verbs), f"{path.name}: {command} {word}"


def test_documents_agree_with_the_code():
    names = re.findall(r'\("([^"]+ = [^"]+)", ', (CODE["macram"] / "demo.py").read_text())
    assert len(names) == 3
    readme = (ROOT / "README.md").read_text()
    assert not [name for name in names if f"{name}: " not in readme]
    assert f"output buffer ({SECTIONS} groups)" in (ROOT / "docs/architecture.md").read_text()
    rows = re.findall(r"^\| `(\w+)` \|.* (\d+) \|$", (ROOT / "docs/engines.md").read_text(), re.MULTILINE)
    assert {kind: int(latency) for kind, latency in rows} == ENGINE_LATENCY


def test_typed_commands_are_found():
    text = "`make demo` and\n```\nmake test SEED=7\n.venv/bin/python x; macram layer a\n```\nmake this happen"
    assert typed(text) == [("make", "demo"), ("make", "test"), ("macram", "layer")]


def make(*arguments):
    """What a make prints that knows nothing of the make, if any, that these tests run under."""
    inherited = ("MAKEFLAGS", "MFLAGS", "MAKELEVEL", "MAKEOVERRIDES", "MAKE_TERMOUT", "MAKE_TERMERR")
    own = {key: value for key, value in os.environ.items() if key not in (*inherited, "SEED", "WAVES")}
    done = subprocess.run(
        ["make", "--no-print-directory", *arguments],
        cwd=ROOT, env=own, capture_output=True, text=True, check=True,
    )  # fmt: skip
    return done.stdout


def test_make_help_names_every_public_target():
    assert make_targets() - set(re.findall(r"make ([a-z-]+)", make("help"))) == {"tools"}


@pytest.mark.parametrize("target", ["demo", "test", "sim", "rtl", "bench"])
def test_make_passes_what_was_given(target, monkeypatch):
    monkeypatch.setenv("MAKELEVEL", "1")
    monkeypatch.setenv("MAKEFLAGS", "w -- SEED=8")
    last = make("-n", target, "SEED=7", "WAVES=1", "IMAGE=a b.png").splitlines()[-1]
    if target in ("demo", "sim"):
        assert "--seed 7" in last
        assert "--waves" in last
        assert '--image "a b.png"' in last
    if target == "bench":
        assert "--seed 7" in last


def test_make_keeps_builds_in_the_repository(monkeypatch):
    monkeypatch.delenv("MACRAM_BUILD_DIR", raising=False)
    asked = "asked: ; @echo $$MACRAM_BUILD_DIR"
    assert make("asked", "--eval", asked).strip() == str(ROOT / "build")
    monkeypatch.setenv("MACRAM_BUILD_DIR", "elsewhere")
    assert make("asked", "--eval", asked).strip() == "elsewhere"


def test_the_environment_is_set_up_with_visible_progress():
    recipe = (ROOT / "Makefile").read_text()
    installs = [line for line in recipe.splitlines() if "pip install" in line and "$(BIN)" in line]
    assert installs
    assert not [line for line in installs if re.search(r"\s(-q|--quiet)\b", line)]
