"""Compiles a C++ node to a shared library; the runtime of nodes is compiled once and shared.

`python -m sitaf_ros.cpp.build runtime ...` and `... node ...`; errors of the user's sources are lines
`FILE<tab>LINE<tab>COLUMN<tab>TEXT` on the standard output, with exit code 1.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from sitaf_ros.application import OWN_DEFINITIONS
from sitaf_ros.cpp.entry import Entry, EntryError, find_entry
from sitaf_ros.cpp.headers import CppHeaders
from sitaf_ros.cpp.instrumentation import Instrumentation, InstrumentationError
from sitaf_ros.cpp.sources import NodeSources
from sitaf_ros.definitions import DefinitionError, LayeredTypes, TypeFolders

# Types that the runtime itself uses.
_OF_RUNTIME = ("action_msgs", "builtin_interfaces", "rcl_interfaces", "unique_identifier_msgs", "lifecycle_msgs")
_OF_TRANSFORMS = ("tf2_msgs", "geometry_msgs", "std_msgs", "diagnostic_msgs", "sensor_msgs", "nav_msgs")
LIBRARY = "libnode.so"
_OPTIONS = ["-O1", "-g1", "-fPIC", "-pthread", "-fdiagnostics-color=never", "-fno-diagnostics-show-caret"]
_STANDARD = "-std=c++17"
_PLACE = r"^(?P<file>[^:\n]+):(?P<line>\d+):(?P<column>\d+): "
_ERROR = re.compile(_PLACE + r"(?:fatal )?error: (?P<text>.*)$")
_REQUIRED = re.compile(_PLACE + r" +(?:recursively )?required (?:from|by)")
# What the linker replaces in the node.
_WRAPPING = ("wrapped.cpp", "terminal.cpp")
_WRAPPED = re.compile(r"\b__wrap_(\w+)\(")
_PARALLEL = 2


def types_of(interfaces: Path) -> LayeredTypes:
    """The types of a test application, and those that come along."""
    return LayeredTypes(TypeFolders([interfaces]), TypeFolders([OWN_DEFINITIONS]))


def _run(command: list[str], folder: Path) -> subprocess.CompletedProcess[str]:
    # The compiler, with files of the node, in the sandbox of the caller.
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)  # noqa: S603


def build_runtime(compiler: str, sources: Path, interfaces: Path, into: Path) -> None:
    """Compile the runtime: objects, and its headers as one precompiled header."""
    headers = CppHeaders(types_of(interfaces))
    generated = into / "generated"
    wanted = [n for n in types_of(interfaces).names() if n.split("/")[0] in (*_OF_RUNTIME, *_OF_TRANSFORMS)]
    headers.write(wanted, generated)
    include = ["-I", str(sources / "include"), "-I", str(generated)]
    units = sorted((sources / "src").glob("*.cpp"))

    def compile_unit(unit: Path) -> None:
        command = [compiler, _STANDARD, *_OPTIONS, "-w", *include, "-c", str(unit), "-o", str(into / f"{unit.stem}.o")]
        done = _run(command, into)
        if done.returncode:
            raise SystemExit(f"the runtime of C++ nodes does not compile: {done.stderr}")

    header = into / "sitaf_precompiled.hpp"
    header.write_text('#include "rclcpp/rclcpp.hpp"\n', encoding="utf-8")

    def precompile(_: object) -> None:
        done = _run([compiler, _STANDARD, *_OPTIONS, "-w", *include, "-x", "c++-header", str(header)], into)
        if done.returncode:
            raise SystemExit(f"the headers of C++ nodes do not compile: {done.stderr}")

    with ThreadPoolExecutor(_PARALLEL) as pool:
        tasks = [pool.submit(precompile, None), *(pool.submit(compile_unit, unit) for unit in units)]
        for task in tasks:
            task.result()


class Build:
    """One node."""

    def __init__(self, arguments: argparse.Namespace) -> None:
        self._compiler: str = arguments.compiler
        self._api: Path = arguments.api
        self._runtime: Path = arguments.runtime
        self._into: Path = arguments.into
        self._scratch: Path = arguments.scratch
        self._package: Path = arguments.package
        self._packages: list[str] = arguments.packages
        self._types = types_of(arguments.interfaces)
        self._is_main: bool = arguments.main
        self._entry: str = arguments.entry
        self._instrumentation = Instrumentation(arguments.compiler, arguments.coverage, tuple(arguments.sanitize))
        # What the compiler records in place of the folder of the package.
        self._recorded: str = arguments.recorded_as or str(self._package)
        self._errors: list[str] = []

    def run(self) -> int:
        """Compile and link; return the exit code."""
        try:
            self._instrumentation.prepare(self._into)
        except InstrumentationError as e:
            return self._report([f"\t0\t0\t{e}"])
        headers = CppHeaders(self._types)
        sources = NodeSources(self._package, self._api / "include", headers)
        try:
            entry = find_entry(self._package, self._entry, self._is_main, sources)
        except EntryError as e:
            return self._report([f"{e.file}\t{e.line}\t0\t{e}"])
        problems = self._prepare(sources, entry, headers)
        if problems:
            return self._report(problems)
        self._write_configured(sources)
        generated = self._scratch / "sitaf_entry.cpp"
        generated.write_text(self._text(entry), encoding="utf-8")
        units = [generated, *(u for u in entry.units if u not in entry.included)]
        flags, problem = self._package_flags(sources)
        if problem:
            return self._report([f"\t0\t0\t{problem}"])
        objects = [self._scratch / f"unit{i}.o" for i in range(len(units))]

        def compile_one(unit: Path, into: Path) -> bool:
            return self._compile(unit, into, sources, entry, flags)

        with ThreadPoolExecutor(_PARALLEL) as pool:
            results = list(pool.map(compile_one, units, objects))
        if not all(results):
            return self._report(self._errors)
        self._instrumentation.keep_notes(self._scratch, self._into)
        return self._link(objects, flags)

    def _text(self, entry: Entry) -> str:
        """The generated unit."""
        return entry.text

    def _prepare(self, sources: NodeSources, entry: Entry, headers: CppHeaders) -> list[str]:
        """Write the headers of messages; return what is not there, one line each."""
        problems = sources.problems(entry.units)
        if problems:
            return problems
        try:
            headers.with_builders = sources.builds_messages(entry.units)
            headers.write(sources.types(entry.units), self._scratch / "generated")
        except DefinitionError as e:
            return [f"\t0\t0\t{e}"]
        return []

    def _of_ros(self, standard: int) -> list[str]:
        """Options for the headers of ROS."""
        folders = (self._scratch / "generated", self._api / "include", self._runtime / "generated")
        precompiled = ["-include", str(self._runtime / "sitaf_precompiled.hpp")] if standard == 17 else []
        return [*precompiled, *(f"-I{folder}" for folder in folders)]

    def _compile(self, unit: Path, into: Path, sources: NodeSources, entry: Entry, flags: dict[str, list[str]]) -> bool:
        include = [self._scratch / "configured", *sources.include_folders(entry.units)]
        options = [*(f"-I{folder}" for folder in include), *self._of_ros(sources.standard)]
        standard = [f"-std=c++{sources.standard}"]
        main = ["-Dmain=sitaf_node_main"] if unit != self._scratch / "sitaf_entry.cpp" else []
        command = [self._compiler, *standard, *_OPTIONS, "-Wall", *self._instrumentation.of_unit(self._package)]
        command += [f"-ffile-prefix-map={self._package}/={self._recorded}/", *main]
        command += [*sources.definitions, *options, *flags["--cflags"], "-c", str(unit), "-o", str(into)]
        done = _run(command, self._scratch)
        if done.returncode:
            found = self._compiler_errors(done.stderr)
            self._errors += found or [f"{unit}\t0\t0\t{done.stderr.strip() or 'the compiler failed'}"]
        return done.returncode == 0

    def _compiler_errors(self, text: str) -> list[str]:
        """A line for each error; one in a template of a library is at the line of the package that needs it."""
        errors: list[str] = []
        place = ""
        for line in text.splitlines():
            if ": In instantiation of" in line or ": In substitution of" in line:
                place = ""
            required = _REQUIRED.match(line)
            if required and required["file"].startswith(f"{self._package}/"):
                place = f"{required['file']}\t{required['line']}\t{required['column']}"
            error = _ERROR.match(line)
            if error:
                here = f"{error['file']}\t{error['line']}\t{error['column']}"
                outside = not error["file"].startswith((f"{self._package}/", f"{self._scratch}/"))
                errors.append(f"{place if place and outside else here}\t{error['text']}")
        return errors

    def _write_configured(self, sources: NodeSources) -> None:
        """Write what generate_export_header and configure_file make."""
        folder = self._scratch / "configured"
        folder.mkdir(exist_ok=True)
        for name, text in sources.cmake.generated_headers.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(text, encoding="utf-8")
        for template, name in sources.cmake.configured:
            text = template.read_text(encoding="utf-8", errors="replace")
            text = re.sub(r"@(\w+)@|\$\{(\w+)\}", lambda m: sources.cmake.variable(m[1] or m[2]), text)
            text = re.sub(r"^#cmakedefine (\w+).*$", lambda m: f"/* #undef {m[1]} */", text, flags=re.M)
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(text, encoding="utf-8")

    def _package_flags(self, sources: NodeSources) -> tuple[dict[str, list[str]], str]:
        """The flags of pkg-config packages that the activity or CMakeLists.txt names."""
        flags: dict[str, list[str]] = {"--cflags": [], "--libs": []}
        for package, required in [*((p, True) for p in self._packages), *((p, False) for p in sources.packages())]:
            for option, found in flags.items():
                done = _run(["pkg-config", option, package], self._scratch)
                if done.returncode and required:
                    return flags, f"packages: pkg-config does not know {package}: {done.stderr.strip()}"
                if not done.returncode:
                    found.extend(done.stdout.split())
        return flags, ""

    def _link(self, objects: list[Path], flags: dict[str, list[str]]) -> int:
        texts = [(self._api / "src" / file).read_text(encoding="utf-8") for file in _WRAPPING]
        names = sorted(set(_WRAPPED.findall("".join(texts))))
        runtime = sorted(self._runtime.glob("*.o"))
        library = self._into / LIBRARY
        command = [self._compiler, "-shared", "-pthread", "-Wl,--no-undefined", "-Wl,-Bsymbolic"]
        command += [*self._instrumentation.of_library(), *(f"-Wl,--wrap={name}" for name in names)]
        command += [*map(str, objects), *map(str, runtime), *flags["--libs"], "-o", str(library)]
        return self._linked(command)

    def _linked(self, command: list[str]) -> int:
        done = _run(command, self._scratch)
        if done.returncode:
            missing = sorted(set(re.findall(r"undefined reference to `([^']+)'", done.stderr)))
            text = f"undefined: {', '.join(missing[:10])}" if missing else done.stderr.strip()
            return self._report([f"\t0\t0\tthe node cannot be linked: {text}"])
        return 0

    def _report(self, problems: list[str]) -> int:
        for problem in sorted(set(problems)):
            sys.stdout.write(problem.replace("\n", " ") + "\n")
        return 1


def main() -> int:
    """Run one of the two builds."""
    parser = argparse.ArgumentParser()
    parser.add_argument("what", choices=["runtime", "node"])
    parser.add_argument("--compiler", default=os.environ.get("CXX") or "g++")
    for name in ("api", "interfaces", "into", "runtime", "scratch", "package"):
        parser.add_argument(f"--{name}", type=Path)
    parser.add_argument("--entry", default="")
    parser.add_argument("--main", action="store_true")
    parser.add_argument("--packages", nargs="*", default=[])
    parser.add_argument("--coverage", action="store_true")
    parser.add_argument("--sanitize", nargs="*", default=[])
    parser.add_argument("--recorded-as", default="")
    parser.add_argument("--ros", nargs="*", default=[], type=Path)
    arguments = parser.parse_args()
    if arguments.what == "runtime":
        build_runtime(arguments.compiler, arguments.api, arguments.interfaces, arguments.into)
        return 0
    if arguments.ros:
        from sitaf_ros.cpp.installed_build import InstalledBuild

        return InstalledBuild(arguments).run()
    return Build(arguments).run()


if __name__ == "__main__":
    sys.exit(main())
