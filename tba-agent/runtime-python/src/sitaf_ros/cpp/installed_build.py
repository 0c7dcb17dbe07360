"""Compiles a C++ node with the headers and libraries of an installed ROS 2 (`--ros system`)."""

from __future__ import annotations

import argparse
import re
import shutil
from pathlib import Path

from sitaf_ros.cpp.build import LIBRARY, Build
from sitaf_ros.cpp.entry import Entry
from sitaf_ros.cpp.headers import CppHeaders
from sitaf_ros.cpp.sources import NodeSources

# What the entry of a node needs of the project's own headers; the others are those of ROS.
_OWN_HEADERS = ("arguments.hpp", "entry.hpp", "installed.hpp", "run_node.hpp")
_DEPENDENCY = re.compile(r"<(?:\w+_)?depend>\s*([\w-]+)\s*</")
_FOUND = re.compile(r"\bfind_package\s*\(\s*([\w-]+)")
_ALWAYS = ("rclcpp", "rclcpp_components", "rclcpp_lifecycle", "rclcpp_action", "rcl", "rcutils", "rmw", "class_loader")


class InstalledBuild(Build):
    """One node; `arguments.ros` are the prefixes of the installation, the first ones win."""

    def __init__(self, arguments: argparse.Namespace) -> None:
        super().__init__(arguments)
        self._prefixes: list[Path] = arguments.ros

    def _prepare(self, sources: NodeSources, entry: Entry, headers: CppHeaders) -> list[str]:
        own = self._scratch / "entry" / "sitaf_ros"
        own.mkdir(parents=True)
        for name in _OWN_HEADERS:
            shutil.copyfile(self._api / "include" / "sitaf_ros" / name, own / name)
        return []

    def _text(self, entry: Entry) -> str:
        return f'#include "sitaf_ros/installed.hpp"\n{entry.text}'

    def _of_ros(self, standard: int) -> list[str]:
        options = [f"-I{self._scratch / 'entry'}"]
        for prefix in self._prefixes:
            include = prefix / "include"
            # Since Humble, each package has a folder of its own.
            packages = sorted(f for f in include.iterdir() if (f / f.name).is_dir()) if include.is_dir() else []
            options += [f"-isystem{folder}" for folder in (*packages, include)]
        return options

    def _link(self, objects: list[Path], flags: dict[str, list[str]]) -> int:
        command = [self._compiler, "-shared", "-pthread", *self._instrumentation.of_library(), *map(str, objects)]
        folders = [prefix / "lib" for prefix in self._prefixes]
        command += [f"-L{folder}" for folder in folders]
        # The libraries bring theirs along; the dynamic linker finds all of them where the process runs.
        command += ["-Wl,--as-needed", "-Wl,--no-undefined", "-Wl,--allow-shlib-undefined"]
        command += [f"-l{name}" for name in self._libraries(folders)]
        return self._linked([*command, *flags["--libs"], "-o", str(self._into / LIBRARY)])

    def _libraries(self, folders: list[Path]) -> list[str]:
        """The libraries of the packages that the node depends on."""
        names = set(_ALWAYS)
        for file, pattern in (("package.xml", _DEPENDENCY), ("CMakeLists.txt", _FOUND)):
            if (self._package / file).is_file():
                names |= set(pattern.findall((self._package / file).read_text(encoding="utf-8", errors="replace")))
        found: dict[str, None] = {}
        for folder in folders:
            for library in sorted(folder.glob("lib*.so")):
                name = library.name.removeprefix("lib").removesuffix(".so")
                # Such as std_msgs__rosidl_typesupport_cpp of std_msgs.
                if any(name == wanted or name.startswith((f"{wanted}__", f"{wanted}_")) for wanted in names):
                    found[name] = None
        return [
            *found,
            *(n for n in ("rosidl_typesupport_cpp", "rosidl_typesupport_c", "rosidl_runtime_c") if n not in found),
        ]
