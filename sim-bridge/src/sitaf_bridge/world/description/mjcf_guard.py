"""Rejects MJCF that refers to other files or expands to too many elements, before MuJoCo reads it.

These checks exist for clear messages. They are not the only protection: `compiler` runs in a process that cannot open
files.
"""

from collections.abc import Mapping
from pathlib import PurePosixPath
from xml.parsers import expat

from sitaf_bridge.errors import BadWorld, Problem
from sitaf_bridge.world.description.mjcf_limits import beyond_limits
from sitaf_bridge.world.description.source import unsafe_path

MAX_ELEMENTS = 100_000
MAX_DEPTH = 200
# Upper bound for the element counter.
MAX_COUNT = 10**12
ROOTS = ("mujoco", "mujocoinclude")
# Allowed asset formats. Decoders of other formats may follow references to files.
ASSET_SUFFIXES = (".xml", ".stl", ".obj", ".msh", ".png", ".ktx", ".bin", ".skn", ".txt")
FILE_ATTRIBUTES = ("filename", "fileback", "filedown", "filefront", "fileleft", "fileright", "fileup", "file")
FOLDER_ATTRIBUTES = ("assetdir", "meshdir", "texturedir")


def check_mjcf(main: str, files: Mapping[str, bytes], folder: str) -> None:
    """Check the MJCF `main` and all XML that it includes; raises BadWorld with every problem.

    `files` are keyed relative to `folder`, which is used in messages only.
    """
    guard = _Guard(files, folder, str(PurePosixPath(main).parent))
    total = guard.elements_of(main, ())
    if not guard.problems and total > MAX_ELEMENTS:
        guard.problems.append(
            Problem(
                folder + main,
                None,
                f"expands to {total} elements, counting copies; the limit is {MAX_ELEMENTS}",
            )
        )
    if guard.problems:
        raise BadWorld(guard.problems)


class _Guard:
    def __init__(self, files: Mapping[str, bytes], folder: str, main_folder: str) -> None:
        self.files = files
        self.folder = folder
        self.main_folder = "" if main_folder == "." else main_folder + "/"
        self.problems: list[Problem] = []
        self._known: dict[str, int] = {}

    def elements_of(self, path: str, outer: tuple[str, ...]) -> int:
        """The number of elements that a file expands to."""
        if path in outer:
            self.problems.append(Problem(self.folder + path, None, "includes itself"))
            return 0
        if path not in self._known:
            self._known[path] = _FileScan(self, path, outer).run()
        return self._known[path]

    def included(self, scan: "_FileScan", name: str, line: int) -> int:
        """The number of elements that an included or attached file expands to."""
        here = str(PurePosixPath(scan.path).parent)
        places = (self.main_folder + name, name if here == "." else f"{here}/{name}", name)
        for place in places:
            if place in self.files:
                return self.elements_of(place, (*scan.outer, scan.path))
        self.problems.append(Problem(self.folder + scan.path, line, f"{name!r} is not among the world's files"))
        return 0


class _FileScan:
    def __init__(self, guard: _Guard, path: str, outer: tuple[str, ...]) -> None:
        self.guard = guard
        self.path = path
        self.outer = outer
        # Number of elements in each open element, multiplied by the copies when it closes.
        self.counts: list[int] = [0]
        self.factors: list[int] = []
        self.parser = expat.ParserCreate("utf-8")
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = self._end
        self.parser.StartDoctypeDeclHandler = self._doctype
        self.parser.XmlDeclHandler = self._declaration

    def run(self) -> int:
        try:
            self.parser.Parse(self.guard.files[self.path], True)
        except expat.ExpatError as error:
            self._problem(f"not well-formed XML: {expat.ErrorString(error.code)}", error.lineno)
            return 0
        except _Stop:
            return 0
        return self.counts[0]

    def _problem(self, message: str, line: int | None = None) -> None:
        line = self.parser.CurrentLineNumber if line is None else line
        self.guard.problems.append(Problem(self.guard.folder + self.path, line, message))

    def _doctype(self, *_: object) -> None:
        self._problem("a document type (<!DOCTYPE ...>) is not allowed; remove it")
        raise _Stop

    def _declaration(self, _version: str, encoding: str | None, _standalone: int) -> None:
        # MuJoCo always reads UTF-8, so another encoding would be parsed differently here.
        if encoding is not None and encoding.lower() not in ("utf-8", "us-ascii"):
            self._problem(f"the encoding {encoding!r} is not supported; save the file as UTF-8")
            raise _Stop

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        if not self.factors and tag not in ROOTS:
            self._problem(f"the root element is <{tag}>; expected <mujoco>")
            raise _Stop
        if len(self.factors) >= MAX_DEPTH:
            self._problem(f"elements are nested deeper than {MAX_DEPTH}")
            raise _Stop
        self.counts.append(0)
        self.factors.append(_copies(attributes))
        for key in FILE_ATTRIBUTES:
            if key in attributes:
                self._check_file(tag, key, attributes[key])
        for key in FOLDER_ATTRIBUTES:
            value = attributes.get(key, "").rstrip("/")
            reason = unsafe_path(value) if value not in ("", ".") else None
            if reason is not None or attributes.get(key, "").startswith("/"):
                self._problem(f"<{tag} {key}={attributes[key]!r}>: the path {reason or 'is absolute'}")
        for message in beyond_limits(tag, attributes):
            self._problem(message)
        if "content_type" in attributes:
            self._problem(f"<{tag} content_type> is not supported; the file's suffix defines the type")

    def _check_file(self, tag: str, key: str, value: str) -> None:
        path = value.removeprefix("./")
        reason = unsafe_path(path)
        if reason is not None:
            self._problem(f"<{tag} {key}={value!r}>: the path {reason}")
        elif not path.lower().endswith(ASSET_SUFFIXES):
            self._problem(f"<{tag} {key}={value!r}>: the suffix must be one of {', '.join(ASSET_SUFFIXES)}")
        elif path.lower().endswith(".xml"):
            self.counts[-1] += self.guard.included(self, path, self.parser.CurrentLineNumber)

    def _end(self, _tag: str) -> None:
        inside = self.counts.pop()
        # Capped, so that nested copies cannot create huge integers.
        self.counts[-1] = min(self.counts[-1] + (1 + inside) * self.factors.pop(), MAX_COUNT)


class _Stop(Exception):
    """Ends the scan of a file after an error that makes the rest meaningless."""


def _copies(attributes: Mapping[str, str]) -> int:
    """The number of copies of its content that an element creates (replicate, composite, flexcomp)."""
    copies = 1
    for key in ("count", "cellcount"):
        for word in attributes.get(key, "").split():
            # MuJoCo rejects other values with its own message.
            digits = word.lstrip("+0")
            if digits.isdecimal():
                copies = min(copies * (int(digits) if len(digits) < 13 else MAX_COUNT), MAX_COUNT)
    return copies
