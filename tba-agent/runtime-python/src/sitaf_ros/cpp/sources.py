"""Reads the sources of a C++ package: what they include, and what CMakeLists.txt says about them."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

from sitaf_ros.cpp.cmake import CMake
from sitaf_ros.cpp.headers import CppHeaders

_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n]+)[>"]', re.M)
_COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.S)
# Packages of ROS whose headers would otherwise be taken for those of the system.
_ROS_NAMES = re.compile(
    r"(rcl\w*|rmw\w*|ros\w*|tf2?\w*|nav2\w*|nav_\w+|\w+_msgs|\w+_interfaces|\w+_srvs|\w+_ros\w*|controller_\w+|moveit\w*"
    r"|pluginlib|class_loader|image_transport|cv_bridge|pcl_\w+|hardware_interface|laser_geometry|urdf|kdl_parser"
    r"|angles|filters|bond\w*|behaviortree_cpp\w*|lifecycle_\w+|ament_\w+|message_filters|diagnostic_updater)$"
)
_BUILD = re.compile(r"::\s*build\s*<")
UNITS = (".cpp", ".cc", ".cxx", ".c++", ".C")
MOST_CHARACTERS = 2_000_000


class NodeSources:
    """The sources of a package, the folder of package.xml."""

    def __init__(self, package: Path, api: Path, headers: CppHeaders) -> None:
        self._package = package
        self._api = api
        self._headers = headers
        self._texts: dict[Path, str] = {}
        cmake = package / "CMakeLists.txt"
        self.cmake = CMake(cmake.read_text(encoding="utf-8", errors="replace") if cmake.is_file() else "", package)
        self._reached: dict[frozenset[Path], set[Path]] = {}

    @property
    def standard(self) -> int:
        """Return the C++ standard that CMakeLists.txt sets, at least 17."""
        return max(17, self.cmake.standard)

    @property
    def definitions(self) -> list[str]:
        """Return the options of definitions."""
        return [f"-D{name}" for name in self.cmake.definitions]

    def text(self, file: Path) -> str:
        """Return the text of a file of the package."""
        if file not in self._texts:
            self._texts[file] = file.read_text(encoding="utf-8", errors="replace")[:MOST_CHARACTERS]
        return self._texts[file]

    def units(self) -> list[Path]:
        """Return all translation units, sorted."""
        found = sorted(f for f in self._package.rglob("*") if f.suffix in UNITS and f.is_file())
        return [f for f in found if not {"test", "tests"} & set(f.relative_to(self._package).parts[:-1])]

    def include_folders(self, units: Iterable[Path]) -> list[Path]:
        """Return the folders in which quoted and other headers are searched."""
        folders = [self._package / "include", *self.cmake.include_folders, self._package / "src", self._package]
        folders += [unit.parent for unit in units]
        kept: list[Path] = []
        for folder in folders:
            if folder.is_dir() and folder not in kept:
                kept.append(folder)
        return kept

    def reached(self, units: Iterable[Path]) -> set[Path]:
        """Return the units and the package's headers that they include."""
        units = list(units)
        key = frozenset(units)
        if key in self._reached:
            return self._reached[key]
        seen: set[Path] = set()
        pending = [*units]
        folders = self.include_folders(units)
        while pending:
            file = pending.pop()
            if file in seen:
                continue
            seen.add(file)
            for _, name in self._includes(file):
                own = self._own(file, name, folders)
                if own is not None:
                    pending.append(own)
        self._reached[key] = seen
        return seen

    def _includes(self, file: Path) -> list[tuple[int, str]]:
        text = self.text(file)
        plain = _COMMENT.sub(lambda m: re.sub(r"[^\n]", " ", m[0]), text)
        return [(plain.count("\n", 0, m.start()) + 1, m[2].strip()) for m in _INCLUDE.finditer(plain)]

    @staticmethod
    def _own(file: Path, name: str, folders: list[Path]) -> Path | None:
        for folder in [file.parent, *folders]:
            found = folder / name
            if found.is_file():
                return found.resolve()
        return None

    def types(self, units: Iterable[Path]) -> list[str]:
        """Return the message types whose headers are included."""
        found = {self._headers.type_of(name) for file in self.reached(units) for _, name in self._includes(file)}
        return sorted(name for name in found if name)

    def builds_messages(self, units: Iterable[Path]) -> bool:
        """Tell whether messages are made with `build<T>()`."""
        return any(_BUILD.search(self.text(file)) for file in self.reached(units))

    def problems(self, units: Iterable[Path]) -> list[str]:
        """Return a line for each header of ROS that is not there."""
        units = list(units)
        folders = self.include_folders(units)
        problems = []
        for file in sorted(self.reached(units)):
            for line, name in self._includes(file):
                package = name.split("/", 1)[0]
                if "/" not in name or self._own(file, name, folders) or (self._api / name).is_file():
                    continue
                if self._headers.type_of(name) or name in self.cmake.generated_headers:
                    continue
                if package in self._headers.packages:
                    problems.append(f"{file}\t{line}\t0\t{name}: the package {package} has no such interface")
                elif (self._api / package).is_dir() and _ROS_NAMES.match(package):
                    problems.append(
                        f"{file}\t{line}\t0\t{name}: the test application brings {package}, but not this header of it"
                    )
                elif _ROS_NAMES.match(package):
                    problems.append(
                        f"{file}\t{line}\t0\t{name}: the test application does not bring this header of ROS; it brings "
                        f"{', '.join(self._brought())} and the messages"
                    )
        return problems

    def _brought(self) -> list[str]:
        hidden = {"sitaf_ros", "rcl", "rmw", "rcutils", "rosidl_runtime_cpp"}
        hidden |= self._headers.packages
        return sorted(f.name for f in self._api.iterdir() if f.is_dir() and f.name not in hidden)

    def packages(self) -> list[str]:
        """Return names of pkg-config for packages that CMakeLists.txt finds."""
        return self.cmake.system_packages
