"""What a compiler adds to a node: counters of executed lines for gcov, and the checks of sanitizers."""

from __future__ import annotations

import platform
import re
import shutil
import subprocess
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

# Next to the library of the node.
NOTES = "coverage"
# Holds the path of the library that must be loaded before all others.
PRELOADED = "preloaded"
ADDRESS = "address"


class InstrumentationError(Exception):
    """The compiler cannot do what was requested; the text says what to do."""


@dataclass(frozen=True)
class Instrumentation:
    """Options of a compiler; only sources of the node are instrumented, never the runtime.

    `sanitizers` are names of `-fsanitize`. Coverage is left out where gcov cannot read it, as with clang.
    """

    compiler: str
    coverage: bool
    sanitizers: tuple[str, ...]

    @cached_property
    def _is_clang(self) -> bool:
        return "clang" in self._ask("--version")

    @property
    def _counts(self) -> bool:
        return self.coverage and not self._is_clang

    def of_unit(self, package: Path) -> list[str]:
        """Options to compile a unit; functions from headers outside of the package are not counted."""
        options = list(self._checks())
        if self._counts:
            # A regular expression, in which a semicolon separates.
            inside = re.sub(r"[^\w/]", ".", f"{package}/")
            options += ["--coverage", f"-fprofile-filter-files={inside}.*"]
        return options

    def of_library(self) -> list[str]:
        """Options to link the library of the node."""
        options = list(self._checks())
        if self.sanitizers and self._is_clang:
            options.append("-shared-libsan")
        if self._counts:
            # The runtime saves the counters of a process that ends without exit handlers.
            options += ["--coverage", "-Wl,-u,__gcov_dump", "-Wl,-u,__gcov_reset"]
        return options

    def _checks(self) -> list[str]:
        if not self.sanitizers:
            return []
        return [f"-fsanitize={','.join(self.sanitizers)}", "-fno-sanitize-recover=all", "-fno-omit-frame-pointer"]

    def prepare(self, into: Path) -> None:
        """Write which library must be loaded first; raises InstrumentationError if it is not installed."""
        if ADDRESS not in self.sanitizers:
            return
        name = f"libclang_rt.asan-{platform.machine()}.so" if self._is_clang else "libasan.so"
        found = Path(self._ask(f"-print-file-name={name}"))
        if not found.is_absolute() or not found.exists():
            raise InstrumentationError(
                f"sanitize: address: {self.compiler} has no {name}; install the sanitizer libraries of this compiler"
            )
        (into / PRELOADED).write_text(str(found.resolve()), encoding="utf-8")

    def keep_notes(self, scratch: Path, into: Path) -> None:
        """Keep what gcov needs besides the counters."""
        if self._counts:
            (into / NOTES).mkdir(exist_ok=True)
            for notes in scratch.glob("*.gcno"):
                shutil.copyfile(notes, into / NOTES / notes.name)

    def _ask(self, option: str) -> str:
        done = subprocess.run([self.compiler, option], capture_output=True, text=True, check=False)  # noqa: S603
        return done.stdout.strip()
