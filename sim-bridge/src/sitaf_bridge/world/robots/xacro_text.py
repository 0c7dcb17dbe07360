"""Expands xacro in a separate process that cannot open files: its expressions are Python.

Includes, YAML files and `$(find PACKAGE)` see the files of the world only; the environment is empty. Attributes that
lead from a value to the interpreter are refused before an expression is evaluated.
"""

import ast
import io
import os
import posixpath
import re
import sys

# Used by xacro when it parses; the separate process cannot load it.
import xml.dom.expatbuilder
import xml.dom.minidom
from collections.abc import Mapping
from types import SimpleNamespace
from typing import Any

import xacro
import yaml
from xacro import substitution_args
from yaml import parser

from sitaf_bridge.world.isolation import CPU_SECONDS, MEMORY_BYTES, Crashed, TooSlow, isolated
from sitaf_bridge.world.robots.package_files import ROOT, Missing, PackageFiles

MAX_TEXT = 16 * 1024 * 1024
MAX_EXPRESSION = 10_000
# Of functions, generators, frames and types; expressions of robots need none of them.
HIDDEN = re.compile(r"(_.*|(gi|cr|ag|tb|f|co|func)_.*|mro)")
# Names of xacro that give access to any attribute of a value.
TOO_POWERFUL = ("vars", "type")


class BadXacro(Exception):
    """xacro cannot expand the file; the message says why."""


def expand(path: str, files: PackageFiles, arguments: Mapping[str, str]) -> bytes:
    """The URDF that xacro makes of the file at `path`. Raises BadXacro."""
    try:
        answer = isolated(_expanded, (path, files, dict(arguments)))
    except TooSlow as error:
        raise BadXacro(f"xacro takes longer than {CPU_SECONDS} s; is a macro or an expression endless?") from error
    except Crashed as error:
        raise BadXacro(f"xacro's process ended with {error}") from error
    if answer.word == "expanded":
        return answer.content
    raise BadXacro(answer.text)


def _expanded(path: str, files: PackageFiles, arguments: Mapping[str, str]) -> tuple[str, bytes]:
    """Run in the separate process."""
    try:
        _confine(files)
        # xacro writes warnings about deprecated names to stderr.
        sys.stderr = io.StringIO()
        document: Any = xacro.process_file(ROOT + path, mappings=dict(arguments))
        text = document.toxml().encode()
    except Exception as error:  # whatever hostile expressions raise
        reason: Any = error
        while isinstance(reason, xacro.XacroException) and reason.exc is not None:
            reason = reason.exc
        if isinstance(reason, MemoryError):
            return "refused", f"xacro needs more memory than the limit of {MEMORY_BYTES >> 20} MiB".encode()
        if isinstance(reason, RecursionError):
            return "refused", b"macros, properties or includes are nested too deep; does one contain itself?"
        where = _shown(xacro.filestack[-1]) if getattr(xacro, "filestack", None) else path
        place = "" if where == path else f"in {where}: "
        text = " ".join(f"{place}{str(error) or type(error).__name__}".split())
        return "refused", text.replace(ROOT, "")[:2000].encode()
    if len(text) > MAX_TEXT:
        return "refused", f"xacro makes {len(text)} bytes; the limit is {MAX_TEXT}".encode()
    return "expanded", text


def _shown(path: str | None) -> str:
    return (path or "the file").removeprefix(ROOT)


def _confine(files: PackageFiles) -> None:
    """Give xacro the files of the world instead of the host's, in this process only."""

    def opened(path: str, *_: Any, **__: Any) -> io.StringIO:
        name = posixpath.normpath(path).removeprefix(ROOT)
        if name not in files.files:
            raise FileNotFoundError(f"{name!r} is not among the files of the world")
        return io.StringIO(files.files[name].decode("utf-8"))

    def found(package: str) -> str:
        try:
            return ROOT + files.folder(package)
        except Missing as error:
            raise substitution_args.SubstitutionException(str(error)) from error

    def parse(inp: Any, filename: str | None = None) -> Any:
        content = inp.read() if inp is not None else opened(filename or "").read()
        if "<!DOCTYPE" in content:
            raise xacro.XacroException("a document type (<!DOCTYPE ...>) is not allowed; remove it")
        # Safe without a document type; the process has limits, too.
        return xml.dom.minidom.parseString(content)  # noqa: S318

    os.environ.clear()
    places: Any = xacro
    places.open = opened
    places.parse = parse
    places.safe_eval = _safe_eval
    places.glob.glob = lambda _pattern: []
    namespace = xacro._global_symbols["python"]
    for name in TOO_POWERFUL:
        dict.pop(namespace, name, None)
    arguments: Any = substitution_args
    arguments._eval_find = found
    arguments._eval_dict["find"] = found
    arguments.eval = lambda text, _globals, names: _safe_eval(text, {}, names)
    # The safe loader constructs no Python objects.
    arguments.yaml = SimpleNamespace(load=yaml.safe_load, parser=parser)


def _safe_eval(expression: str, names: dict[str, Any], local: Any = None) -> Any:
    if len(expression) > MAX_EXPRESSION:
        raise xacro.XacroException(f"an expression has {len(expression)} characters; the limit is {MAX_EXPRESSION}")
    tree = ast.parse(expression.strip(), "<expression>", "eval")
    for node in ast.walk(tree):
        name = node.attr if isinstance(node, ast.Attribute) else node.id if isinstance(node, ast.Name) else ""
        if HIDDEN.fullmatch(name) and (isinstance(node, ast.Attribute) or name.startswith("__")):
            raise xacro.XacroException(f"the name {name!r} is not allowed in expressions")
    names.update(__builtins__={})
    return eval(compile(tree, "<expression>", "eval"), names, local)  # noqa: S307  # what xacro is; see above
