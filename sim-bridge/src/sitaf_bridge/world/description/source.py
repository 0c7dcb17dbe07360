"""A world as files in memory. Its paths are never opened on the host."""

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path, PurePosixPath

from sitaf_bridge.errors import BadWorld, InvalidRequest, LimitReached, Problem

DESCRIPTION_SUFFIX = ".world.yaml"
MAX_FILES = 1_000
MAX_BYTES = 48 * 1024 * 1024


def unsafe_path(path: str) -> str | None:
    """Return why a path could leave the file map, or None if it cannot."""
    if not path:
        return "is empty"
    if "\\" in path or "\0" in path:
        return "contains a backslash or a NUL; separate folders with '/'"
    if path.startswith("/") or ":" in path:
        return "is absolute; write it relative to the file that names it"
    if any(part in ("", ".", "..") for part in path.split("/")):
        return "contains '.', '..' or an empty part; remove it"
    return None


@dataclass(frozen=True)
class WorldSource:
    """The key of the world description in `files`, and every file by its relative path."""

    description: str
    files: Mapping[str, bytes]

    def __post_init__(self) -> None:
        """Check the paths and the size."""
        if len(self.files) > MAX_FILES:
            raise LimitReached(f"world: {len(self.files)} files; the limit is {MAX_FILES}")
        size = sum(len(content) for content in self.files.values())
        if size > MAX_BYTES:
            raise LimitReached(f"world: {size} bytes; the limit is {MAX_BYTES}")
        for path in self.files:
            reason = unsafe_path(path)
            if reason is not None:
                raise InvalidRequest(f"world.files: the path {path!r} {reason}")
        if not self.description:
            raise InvalidRequest("world.description is empty; set it to the *.world.yaml among the files")
        if self.description not in self.files:
            known = ", ".join(sorted(p for p in self.files if p.endswith(DESCRIPTION_SUFFIX))) or "none"
            raise InvalidRequest(
                f"world.description: {self.description!r} is not among the files; available descriptions: {known}"
            )
        object.__setattr__(self, "files", dict(self.files))

    @cached_property
    def digest(self) -> str:
        """SHA-256 in hexadecimal over (path length, path, content length, content), sorted by path as bytes.

        Lengths are 8 bytes, big endian.
        """
        digest = hashlib.sha256()
        for path, content in sorted((p.encode(), c) for p, c in self.files.items()):
            for part in (path, content):
                digest.update(len(part).to_bytes(8, "big"))
                digest.update(part)
        return digest.hexdigest()

    @property
    def folder(self) -> str:
        """The description's folder with a trailing '/', or the empty string."""
        parent = str(PurePosixPath(self.description).parent)
        return "" if parent == "." else parent + "/"

    def files_of_folder(self) -> dict[str, bytes]:
        """The files in the description's folder and below, by relative path: all files that MJCF can refer to."""
        folder = self.folder
        return {p.removeprefix(folder): c for p, c in self.files.items() if p.startswith(folder)}


def read_world(description: Path) -> WorldSource:
    """Read a world description and all files in its folder and below from disk.

    Hidden files and links to other folders are ignored. Raises BadWorld if it cannot be read.
    """
    folder = description.parent.resolve()
    files: dict[str, bytes] = {}
    size = 0
    try:
        files[description.name] = description.read_bytes()
        for path in sorted(folder.rglob("*")):
            name = path.relative_to(folder)
            if any(part.startswith(".") for part in name.parts) or not path.is_file():
                continue
            if not path.resolve().is_relative_to(folder):
                continue
            size += path.stat().st_size
            if size > MAX_BYTES:
                raise LimitReached(f"{folder}: more than {MAX_BYTES} bytes; put the world into a separate folder")
            files[name.as_posix()] = path.read_bytes()
    except OSError as error:
        raise BadWorld([Problem(str(description), None, error.strerror or str(error))]) from error
    return WorldSource(description.name, files)
