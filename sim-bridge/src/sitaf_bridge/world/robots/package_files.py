"""Finds the files that a robot refers to among the files of the world: relative, or in a ROS package."""

import posixpath
import re
from collections.abc import Mapping

# Where `$(find PACKAGE)` points to while xacro runs; there is no such folder.
ROOT = "/world-files/"
SCHEME = re.compile(r"(?:package|model):///?(?P<package>[^/]+)/(?P<path>.+)")


class Missing(Exception):
    """A file or package is not among the files of the world; the message says how to add it."""


class PackageFiles:
    """The files of a world, by paths relative to its description, and the folders of ROS packages among them."""

    def __init__(self, files: Mapping[str, bytes], packages: Mapping[str, str]) -> None:
        self.files = files
        self._packages = packages

    def folder(self, package: str) -> str:
        """The folder of a package: the declared one, else a folder of its name. Raises Missing."""
        declared = self._packages.get(package)
        if declared is not None:
            return "" if declared == "." else declared.strip("/")
        found = {
            path[: match.end() - 1]
            for path in self.files
            if (match := re.search(rf"(?:^|/){re.escape(package)}/", path)) is not None
        }
        if len(found) == 1:
            return found.pop()
        there = "several folders have its name" if found else "no folder of the world has its name"
        raise Missing(f"the package {package!r} is not known: {there}; write `packages: {{{package}: FOLDER}}`")

    def find(self, reference: str, base: str) -> bytes:
        """The content of a file; relative paths start at the folder `base`. Raises Missing."""
        match = SCHEME.fullmatch(reference)
        if match is not None:
            path = posixpath.join(self.folder(match["package"]), match["path"])
        else:
            path = reference.removeprefix("file://")
            path = path.removeprefix(ROOT) if path.startswith(ROOT) else posixpath.join(base, path)
        path = posixpath.normpath(path)
        if path not in self.files:
            outside = path.startswith(("/", ".."))
            advice = "files of this machine are not read; copy it next to the world" if outside else "add the file"
            raise Missing(f"{path!r} is not among the files of the world; {advice}")
        return self.files[path]
