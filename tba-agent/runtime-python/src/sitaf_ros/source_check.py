"""Finds in the sources of a node, before they run, what of ROS's API is not available."""

from __future__ import annotations

import ast
import functools
import importlib.util
from collections.abc import Iterable, Mapping
from pathlib import Path

API = Path(__file__).parent / "api"
# Packages of ROS without a Python package on PyPI of the same name and meaning.
NOT_AVAILABLE = (
    "cv_bridge",
    "image_geometry",
    "image_transport_py",
    "launch",
    "launch_ros",
    "laser_geometry",
    "moveit",
    "nav2_common",
    "nav2_simple_commander",
    "osrf_pycommon",
    "PyKDL",
    "rclpy_components",
    "ros2cli",
    "rosbag2_py",
    "rosidl_parser",
    "rospy",
    "rqt_gui_py",
    "sros2",
    "tf2_kdl",
)


def check(folders: list[Path], entry: Path, types: Mapping[str, Mapping[str, list[str]]]) -> list[str]:
    """Return one line for each problem of a file and of what it imports from the folders.

    `types` are the names of types by package and kind.
    """
    problems: list[str] = []
    seen: dict[Path, None] = {entry: None}
    waiting = [entry]
    while waiting:
        file = waiting.pop(0)
        shown = next((file.relative_to(folder) for folder in folders if file.is_relative_to(folder)), file)
        try:
            tree = ast.parse(file.read_text(encoding="utf-8"), str(file))
        except SyntaxError as e:
            problems.append(f"{shown}:{e.lineno}: {e.msg}")
            continue
        problems += [f"{shown}:{line}: {text}" for line, text in _Uses(types).of(tree)]
        for found in _imported(tree, file, folders):
            if found not in seen:
                seen[found] = None
                waiting.append(found)
    return problems


def module_file(module: str, folders: Iterable[Path]) -> Path | None:
    """Return the file of a module in the folders."""
    for folder in folders:
        path = folder.joinpath(*module.split("."))
        for file in (path / "__init__.py", path.with_suffix(".py")):
            if file.is_file():
                return file
    return None


def _imported(tree: ast.Module, file: Path, folders: list[Path]) -> list[Path]:
    """Return the files of the folders that a module imports, packages before what is in them."""
    names: list[str] = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names += [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            base = node.module or ""
            if node.level:
                parent = file.parent
                for _ in range(node.level - 1):
                    parent = parent.parent
                folder = next((f for f in folders if parent.is_relative_to(f)), None)
                if folder is None:
                    continue
                base = ".".join([*parent.relative_to(folder).parts, *base.split(".")]).strip(".")
            names += [base, *(f"{base}.{alias.name}" for alias in node.names)]
    found: list[Path] = []
    for name in names:
        parts = name.split(".")
        files = [module_file(".".join(parts[: i + 1]), [*folders, file.parent]) for i in range(len(parts))]
        found += [f for f in files if f is not None]
    return found


class _Uses(ast.NodeVisitor):
    """The uses of ROS packages in one module."""

    def __init__(self, types: Mapping[str, Mapping[str, list[str]]]) -> None:
        self._types = types
        self._found: dict[tuple[int, str], None] = {}
        self._modules: dict[str, str] = {}
        """Local names of modules: `np: numpy`."""

    def of(self, tree: ast.Module) -> list[tuple[int, str]]:
        """Return line and text of each problem."""
        self.visit(tree)
        for node in ast.walk(tree):
            if isinstance(node, ast.Attribute):
                self._attribute(node)
        return sorted(self._found)

    def visit_Try(self, node: ast.Try) -> None:
        """Imports that the module expects to fail are its own matter."""
        caught = {
            n.id for h in node.handlers for n in ast.walk(h.type or ast.Name("Exception")) if isinstance(n, ast.Name)
        }
        if not caught & {"ImportError", "ModuleNotFoundError", "Exception"}:
            self.generic_visit(node)

    def visit_Import(self, node: ast.Import) -> None:
        """`import a.b`, `import a.b as c`."""
        for alias in node.names:
            self._module(alias.name, node.lineno)
            local = alias.asname or alias.name.split(".")[0]
            self._modules[local] = alias.name if alias.asname else local

    def visit_ImportFrom(self, node: ast.ImportFrom) -> None:
        """`from a.b import c`."""
        if node.level or node.module is None or not self._module(node.module, node.lineno):
            return
        for alias in node.names:
            if alias.name == "*":
                continue
            if _is_ours(node.module):
                if _has(node.module, alias.name):
                    if _file(f"{node.module}.{alias.name}") is not None:
                        self._modules[alias.asname or alias.name] = f"{node.module}.{alias.name}"
                else:
                    self._note(node.lineno, f"{node.module}.{alias.name} is not available")
            self._type(node.module, alias.name, node.lineno)

    def _module(self, name: str, line: int) -> bool:
        top = name.split(".", maxsplit=1)[0]
        if top in NOT_AVAILABLE and importlib.util.find_spec(top) is None:
            self._note(line, f"{top} is not available")
            return False
        if _is_ours(name) and _file(name) is None:
            self._note(line, f"{name} is not available")
            return False
        package, _, kind = name.partition(".")
        if kind in ("msg", "srv", "action") and package in self._types and kind not in self._types[package]:
            self._note(line, f"{name}: the package {package} has no .{kind} files")
            return False
        return True

    def _type(self, module: str, name: str, line: int) -> None:
        package, _, kind = module.partition(".")
        known = self._types.get(package, {}).get(kind)
        whole = name.split("_", maxsplit=1)[0]
        if known is not None and name not in known and whole not in known and not name.startswith("_"):
            self._note(line, f"{package}/{kind}/{name}: no such type")

    def _attribute(self, node: ast.Attribute) -> None:
        names: list[str] = [node.attr]
        value = node.value
        while isinstance(value, ast.Attribute):
            names.insert(0, value.attr)
            value = value.value
        if not isinstance(value, ast.Name) or value.id not in self._modules:
            return
        module = self._modules[value.id]
        if not _is_ours(module):
            if len(names) == 2 and names[0] in ("msg", "srv", "action"):
                self._type(f"{module}.{names[0]}", names[1], node.lineno)
            return
        for name in names:
            if _file(f"{module}.{name}") is not None:
                module = f"{module}.{name}"
                continue
            if not _has(module, name):
                self._note(node.lineno, f"{module}.{name} is not available")
            return

    def _note(self, line: int, text: str) -> None:
        self._found[line, text] = None


def _is_ours(module: str) -> bool:
    return (API / module.split(".", maxsplit=1)[0]).is_dir()


@functools.cache
def _file(module: str) -> Path | None:
    path = API.joinpath(*module.split("."))
    if (path / "__init__.py").is_file():
        return path / "__init__.py"
    return path.with_suffix(".py") if path.with_suffix(".py").is_file() else None


def _has(module: str, name: str) -> bool:
    return name in _names(module) or _file(f"{module}.{name}") is not None


@functools.cache
def _names(module: str) -> frozenset[str]:
    """Return the names at the top of one of the API's modules."""
    file = _file(module)
    if file is None:
        return frozenset()
    found = {"__name__", "__file__", "__doc__", "__path__", "__version__"}
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            found.add(node.name)
        elif isinstance(node, ast.Import | ast.ImportFrom):
            for alias in node.names:
                if alias.name == "*" and isinstance(node, ast.ImportFrom):
                    base = module.rpartition(".")[0] if node.level else ""
                    found |= _names(".".join(part for part in (base, node.module or "") if part))
                found.add(alias.asname or alias.name)
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            found.add(node.id)
    return frozenset(found)
