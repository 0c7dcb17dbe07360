"""Finds the class or main function of a node, and writes the translation unit that runs it."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from sitaf_ros.cpp.sources import UNITS, NodeSources

_REGISTERED = re.compile(r"RCLCPP_COMPONENTS_REGISTER_NODE\s*\(\s*([\w:]+)\s*\)")
_MAIN = re.compile(r"\bint\s+main\s*\(([^)]*)\)")
_CLASS = re.compile(r"[A-Za-z_]\w*(::[A-Za-z_]\w*)*")

_BEGIN = """\
// What each case of the node runs.
#include "sitaf_ros/arguments.hpp"
#include "sitaf_ros/entry.hpp"
"""


class EntryError(Exception):
    """The entry is not in the sources."""

    def __init__(self, text: str, file: str = "", line: int = 0) -> None:
        super().__init__(text)
        self.file, self.line = file, line


@dataclass(frozen=True)
class Entry:
    """The generated unit, the units of the node, and those of them that the generated one includes."""

    text: str
    units: list[Path]
    included: list[Path]


def find_entry(package: Path, entry: str, is_main: bool, sources: NodeSources) -> Entry:
    """Find the entry of a node. Raises EntryError."""
    if is_main:
        return _main(package, entry, sources)
    if not _CLASS.fullmatch(entry):
        raise EntryError(f"class: '{entry}' is not a C++ class such as my_package::Follower")
    units = sources.units()
    registered = [u for u in units if entry in _REGISTERED.findall(sources.text(u))]
    short = entry.rpartition("::")[2]
    declared = re.compile(rf"\b(?:class|struct)\s+(?:\w+\s+)*?{re.escape(short)}\s*(?:final\s*)?(?::(?!:)|\{{)")
    defining = [u for u in units if declared.search(sources.text(u))]
    methods = re.compile(rf"\b{re.escape(short)}::{re.escape(short)}\s*\(")
    implementing = [u for u in units if methods.search(sources.text(u))]
    if not registered and len(defining) > 1:
        listed = ", ".join(str(u.relative_to(package)) for u in defining)
        raise EntryError(f"class: {entry} is in several sources: {listed}; write main: and the file that runs it")
    file = next(iter([*registered, *defining, *implementing]), None)
    if file is None:
        including = [u for u in units if any(declared.search(sources.text(f)) for f in sources.reached([u]))]
        file = next(iter(including), None)
    if file is None:
        headers = sorted(f for f in package.rglob("*") if f.suffix in (".h", ".hpp", ".hxx") and f.is_file())
        file = next((h for h in headers if declared.search(sources.text(h))), None)
    if file is None:
        known = sorted({name for u in units for name in _REGISTERED.findall(sources.text(u))})
        hint = f"; registered components: {', '.join(known)}" if known else ""
        raise EntryError(f"class: no source of the package has the class {entry}{hint}")
    file = file.resolve()
    units = sources.cmake.units_of(file) if file.suffix in UNITS else []
    text = f'{_BEGIN}#include "sitaf_ros/run_node.hpp"\n{_include(file)}'
    text += f"\nvoid sitaf_ros::run_entry() {{sitaf_ros::run_node<{entry}>();}}\n"
    return Entry(text, units or [file], [file])


def _include(file: Path) -> str:
    return f'#define main sitaf_node_main\n#include "{file}"\n#undef main\n'


def _main(package: Path, entry: str, sources: NodeSources) -> Entry:
    file = (package / entry).resolve()
    if not file.is_file() or package.resolve() not in file.parents:
        raise EntryError(f"main: there is no file {entry} in the package")
    found = _MAIN.search(sources.text(file))
    if found is None:
        raise EntryError(f"main: {entry} has no function main")
    call = (
        "::main(sitaf_ros::argument_count(), sitaf_ros::arguments())"
        if found[1].strip() not in ("", "void")
        else "::main()"
    )
    # Not renamed: only `main` may end without a return statement.
    text = f'{_BEGIN}#include "{file}"\n\nvoid sitaf_ros::run_entry() {{(void){call};}}\n'
    return Entry(text, sources.cmake.units_of(file), [file])
