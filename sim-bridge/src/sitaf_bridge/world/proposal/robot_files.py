"""Finds the files of a robot on disk: those next to it, and those of the ROS packages that it names.

A package is an enclosing folder of its name, or a folder next to an enclosing one. Nothing else of the host is read.
"""

import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path

from sitaf_bridge.errors import BadWorld, LimitReached, Problem

TEXTS = (".urdf", ".xacro", ".xml", ".yaml", ".yml")
MESHES = (".stl", ".obj", ".msh", ".png", ".ktx", ".bin", ".skn", ".txt")
NAMED = re.compile(rb"(?:package|model)://+([\w-]+)/|\$\(find ([\w-]+)\)")
MAX_TEXT_BYTES = 4 * 1024 * 1024
MAX_FOUND = 20_000
# How far above the robot's file a package is searched.
MAX_LEVELS = 6


class RobotFiles(Mapping[str, bytes]):
    """The files that a robot may refer to, by their path in the new world; read when they are needed."""

    def __init__(self, robot: Path) -> None:
        self.robot = robot.resolve()
        self._paths: dict[str, Path] = {}
        self.packages: dict[str, str] = {}
        if not self.robot.is_file():
            raise BadWorld([Problem(str(robot), None, "does not exist")])
        self._add(self.robot.parent, "")
        self.main = self.robot.name
        self._paths[self.main] = self.robot
        self._find_packages()
        self.read: set[str] = set()

    def __getitem__(self, path: str) -> bytes:
        """The content of a file, which is remembered as one that the robot needs."""
        content = self._paths[path].read_bytes()
        self.read.add(path)
        return content

    def __iter__(self) -> Iterator[str]:
        """All paths."""
        return iter(self._paths)

    def __len__(self) -> int:
        """The number of files."""
        return len(self._paths)

    def texts(self) -> dict[str, bytes]:
        """All files that xacro may include."""
        return {
            path: place.read_bytes()
            for path, place in self._paths.items()
            if path.lower().endswith(TEXTS) and place.stat().st_size <= MAX_TEXT_BYTES
        }

    def _find_packages(self) -> None:
        seen: set[str] = set()
        while True:
            names = {
                (match[1] or match[2]).decode()
                for path, content in self.texts().items()
                if path == self.main or "/" in path
                for match in NAMED.finditer(content)
            } - seen
            if not names:
                break
            for name in sorted(names):
                folder = self._package(name)
                if folder is not None:
                    self._add(folder, name + "/")
                    self.packages[name] = name
            seen |= names
        inside = next((name for name in self.packages if self.robot.is_relative_to(self._package(name) or "/-")), None)
        if inside is not None:
            # The robot belongs to a package: its own folder is in there, once.
            root = self._package(inside)
            assert root is not None  # noqa: S101
            self._paths = {path: place for path, place in self._paths.items() if path.startswith(tuple(self.packages))}
            self.main = f"{inside}/{self.robot.relative_to(root).as_posix()}"

    def _package(self, name: str) -> Path | None:
        for folder in list(self.robot.parents)[:MAX_LEVELS]:
            if folder.name == name:
                return folder
            if (folder / name).is_dir() and folder != Path("/"):
                return folder / name
        return None

    def _add(self, folder: Path, prefix: str) -> None:
        for parent, folders, names in os.walk(folder):
            folders[:] = [f for f in folders if not f.startswith(".")]
            for name in names:
                path = Path(parent) / name
                if name.lower().endswith(TEXTS + MESHES) and path.is_file() and not path.is_symlink():
                    self._paths[prefix + path.relative_to(folder).as_posix()] = path
                if len(self._paths) > MAX_FOUND:
                    raise LimitReached(
                        f"{folder}: more than {MAX_FOUND} files; copy the robot into a folder of its own"
                    )
