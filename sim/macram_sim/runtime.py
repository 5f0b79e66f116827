"""What all Verilated models share, compiled once: Verilator's run-time library and the headers of every file.

For a small model that is most of the compiler's work. Models are built with the same arguments, so the objects and
the precompiled headers are the same too; only a model's own classes are left to compile.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import IO

from macram_sim.folders import build_root, locked
from macram_sim.tools import Toolchain

HEADER = "shared.h"
FILES = {
    "shared.v": "module shared; endmodule\n",
    HEADER: '#include "verilated.h"\n',
    "shared.mk": f"shared: $(VK_GLOBAL_OBJS) {HEADER}.fast.gch {HEADER}.slow.gch\n",
}
"""An empty model, what every file of every model includes, and a target with everything but the model itself."""


@dataclass(frozen=True, slots=True)
class Runtime:
    """The shared part of the models made with one set of arguments.

    Attributes:
        arguments: of Verilator, those that name neither files nor a model.
        settings: variables on make's command line.
    """

    tools: Toolchain
    arguments: tuple[str, ...]
    settings: tuple[str, ...]

    @property
    def directory(self) -> Path:
        """``runtime-<key>`` in `build_root`; the key is the hash of everything that goes into it."""
        recipe = [self.tools.version, str(self.tools.verilator), self.arguments, self.settings]
        key = hashlib.sha256(json.dumps(recipe).encode()).hexdigest()[:20]
        return build_root() / f"runtime-{key}"

    def headers(self) -> list[str]:
        """Variables for a model's make: the shared precompiled headers in the place of its own."""
        header = self.directory / HEADER
        read = f"$(CFG_CXXFLAGS_PCH_I) {header}.%s$(CFG_GCH_IF_CLANG)"
        return [f"VK_PCH_H={header}", f"VK_PCH_I_FAST={read % 'fast'}", f"VK_PCH_I_SLOW={read % 'slow'}"]

    def lay_into(self, folder: Path, jobs: int, log: IO[str]) -> None:
        """Copy the objects into a model's folder, where its make finds them newer than their sources.

        Raises:
            subprocess.CalledProcessError: Verilator or the compiler failed; ``log`` says why.
        """
        final = self.directory
        with locked(final.parent / f".{final.name}.lock"):
            if not final.is_dir():
                self._build(final, jobs, log)
        for compiled in final.glob("*.o"):
            shutil.copyfile(compiled, folder / compiled.name)

    def _build(self, final: Path, jobs: int, log: IO[str]) -> None:
        """Build in a folder of this process's own and move what is kept into place in one step."""
        work = final.parent / f".{final.name}.{os.getpid()}"
        shutil.rmtree(work, ignore_errors=True)
        (work / "done").mkdir(parents=True)
        for name, text in FILES.items():
            (work / name).write_text(text, encoding="utf-8")
        verilator = [str(self.tools.verilator), "-cc", *self.arguments, "-Mdir", ".", "shared.v"]
        make = ["make", "-j", str(jobs), "-f", "Vshared.mk", "-f", "shared.mk", *self.settings, "shared"]
        try:
            self._run(verilator, work, log)
            self._run(make, work, log)
            for kept in (*work.glob("*.o"), *work.glob("*.gch"), work / HEADER):
                kept.rename(work / "done" / kept.name)
            (work / "done").rename(final)
        finally:
            shutil.rmtree(work, ignore_errors=True)

    def _run(self, command: Sequence[str], folder: Path, log: IO[str]) -> None:
        subprocess.run(
            command,
            cwd=folder,
            env=self.tools.environment(),
            stdout=log,
            stderr=subprocess.STDOUT,
            stdin=subprocess.DEVNULL,
            check=True,
        )
