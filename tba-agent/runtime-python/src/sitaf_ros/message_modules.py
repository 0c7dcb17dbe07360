"""Makes `import std_msgs.msg` and its like find generated classes."""

from __future__ import annotations

import importlib
import importlib.util
import sys
from collections.abc import Sequence
from importlib.abc import Loader
from importlib.machinery import ModuleSpec, PathFinder
from types import ModuleType
from typing import Any

from sitaf_ros.messages import MessageClasses, snake_case


class MessageFinder:
    """A finder of `sys.meta_path`; it goes first, but leaves a package that has Python sources to Python."""

    def __init__(self, classes: MessageClasses) -> None:
        self._classes = classes

    def find_spec(self, fullname: str, path: Sequence[str] | None = None, target: Any = None) -> ModuleSpec | None:
        """Return a spec for an interface package or its msg, srv and action modules."""
        package, *rest = fullname.split(".")
        kinds = self._classes.packages.get(package)
        if kinds is None:
            return None
        if not rest:
            python = PathFinder.find_spec(package)
            if python is not None and python.origin is not None:
                return None  # a package with Python sources; a folder without them is none
            return importlib.util.spec_from_loader(fullname, _PackageLoader(kinds), is_package=True)
        if rest[0] not in kinds:
            return None
        if len(rest) == 1:
            shorts = {short: f"{package}/{rest[0]}/{short}" for short in kinds[rest[0]]}
            return importlib.util.spec_from_loader(fullname, _Loader(shorts, self._classes), is_package=True)
        found = {s: f"{package}/{rest[0]}/{s}" for s in kinds[rest[0]] if f"_{snake_case(s)}" == rest[1]}
        if len(rest) == 2 and found:
            return importlib.util.spec_from_loader(fullname, _Loader(found, self._classes))
        return None

    def install(self) -> None:
        """Put the finder first."""
        sys.meta_path.insert(0, self)  # type: ignore[arg-type]


class _PackageLoader(Loader):
    """Makes a package whose msg, srv and action need not be imported by name: rclpy imports many of them in ROS."""

    def __init__(self, kinds: dict[str, list[str]]) -> None:
        self._kinds = kinds

    def create_module(self, spec: ModuleSpec) -> None:
        return None

    def exec_module(self, module: ModuleType) -> None:
        def find(name: str) -> Any:
            if name not in self._kinds:
                raise AttributeError(f"module {module.__name__!r} has no attribute {name!r}")
            return importlib.import_module(f"{module.__name__}.{name}")

        module.__dict__["__getattr__"] = find


class _Loader(Loader):
    def __init__(self, names: dict[str, str], classes: MessageClasses) -> None:
        self._names, self._classes = names, classes

    def create_module(self, spec: ModuleSpec) -> None:
        return None

    def exec_module(self, module: ModuleType) -> None:
        classes, names = self._classes, self._names
        module.__dict__["__all__"] = sorted(names)

        def find(name: str) -> Any:
            if name in names:
                found = classes.message(names[name])
            else:
                whole = name.split("_", maxsplit=1)[0]
                if whole == name or whole not in names:
                    raise AttributeError(f"module {module.__name__!r} has no attribute {name!r}")
                found = classes.message(f"{names[whole]}{name[len(whole) :]}")
            setattr(module, name, found)
            return found

        module.__dict__["__getattr__"] = find
