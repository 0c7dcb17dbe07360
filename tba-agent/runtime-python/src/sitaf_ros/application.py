"""A ROS node's sources, loaded once; cases are started in processes that are forked afterwards."""

from __future__ import annotations

import ast
import importlib
import os
import random
import sys
import threading
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

from sitaf_ros import simulated_time
from sitaf_ros.current import CURRENT
from sitaf_ros.definitions import DefinitionError, LayeredTypes, MessageTypes, TypeFolders
from sitaf_ros.errors import RosLoadError
from sitaf_ros.message_modules import MessageFinder
from sitaf_ros.messages import MessageClasses
from sitaf_ros.settings import RosSettings
from sitaf_ros.share_folders import share_folder
from sitaf_ros.source_check import check, module_file
from sitaf_ros.system import RosSystem

API = Path(__file__).parent / "api"
_SUPPLY = "name the folder of its package under libraries: in activity.yaml, or its PyPI package in requirements.txt"
OWN_DEFINITIONS = Path(__file__).parent / "definitions"


class RosApplication:
    """Sources of a package, its types, and the entry that each case runs."""

    def __init__(
        self,
        types: MessageTypes,
        package: str = "",
        folders: Iterable[Path] = (),
        share: Mapping[str, Path] | None = None,
    ) -> None:
        self.types = LayeredTypes(TypeFolders([OWN_DEFINITIONS]), types)
        self.classes = MessageClasses(self.types)
        self.package = package
        self.folders = [Path(folder).resolve() for folder in folders]
        self.share = {name: Path(path) for name, path in (share or {}).items()}
        if package and self.folders and package not in self.share:
            self.share[package] = share_folder(package, self.folders[0])
        self._run: Callable[[RosSettings], object] | None = None

    def install(self) -> None:
        """Make the API packages and message classes importable, and clocks of nodes simulated."""
        if CURRENT.application is not None and CURRENT.application is not self:
            raise RuntimeError("another ROS application is loaded in this process")
        if CURRENT.application is None:
            CURRENT.application = self
            for folder in reversed([API, *self.folders]):
                if str(folder) not in sys.path:
                    sys.path.insert(0, str(folder))
            MessageFinder(self.classes).install()
            simulated_time.install()

    def load(self, entry: str, environment: Mapping[str, str] | None = None, arguments: Iterable[str] = ()) -> None:
        """Check the sources and import the entry; `arguments` are those of `main`, which may read them when imported.

        The entry is `module:Class`, `module:function`, the name of a class in the package, or a Python file.
        """
        self.install()
        os.environ.update(environment or {})
        sys.argv = [self.package or "node", *arguments]
        CURRENT.loading_thread = threading.get_ident()
        try:
            self._run = self._entry(entry)
        except RosLoadError:
            raise
        except ModuleNotFoundError as e:
            raise RosLoadError([f"{entry}: the Python module {e.name} is not available; {_SUPPLY}"]) from e
        except (ImportError, AttributeError, SyntaxError, DefinitionError) as e:
            raise RosLoadError([f"{entry}: {type(e).__name__}: {e}"]) from e
        finally:
            CURRENT.loading_thread = None

    def _check(self, file: Path | None) -> None:
        problems = [] if file is None else check(self.folders, file, self.classes.packages)
        if problems:
            raise RosLoadError(problems)

    def _entry(self, entry: str) -> Callable[[RosSettings], object]:
        if entry.endswith(".py"):
            return self._file(entry)
        module_name, _, name = entry.rpartition(":")
        if not module_name and "." in name:
            module_name, _, name = name.rpartition(".")
        if not module_name:
            module_name = self._module_of(name)
        self._check(module_file(module_name, self.folders))
        module = importlib.import_module(module_name)
        found: Any = module
        for part in name.split("."):
            if not hasattr(found, part):
                raise RosLoadError([f"{entry}: module {module_name} has no `{part}`"])
            found = getattr(found, part)
        if isinstance(found, type):
            return lambda settings: _spin(found)
        return lambda settings: found()

    def _file(self, entry: str) -> Callable[[RosSettings], object]:
        candidates = [Path(entry), *(folder / entry for folder in self.folders)]
        file = next((candidate for candidate in candidates if candidate.is_file()), None)
        if file is None:
            raise RosLoadError([f"{entry}: there is no such file in {', '.join(str(f) for f in self.folders)}"])
        file = file.resolve()
        self._check(file)
        code = compile(file.read_text(encoding="utf-8"), str(file), "exec")

        def run(settings: RosSettings) -> None:
            module = type(sys)("__main__")
            module.__file__ = str(file)
            sys.modules["__main__"] = module
            sys.path.insert(0, str(file.parent))
            exec(code, module.__dict__)  # noqa: S102 -- the component under test

        return run

    def _module_of(self, name: str) -> str:
        found: list[str] = []
        for folder in self.folders:
            for file in sorted(folder.rglob("*.py")):
                tree = ast.parse(file.read_text(encoding="utf-8"))
                if any(isinstance(node, ast.ClassDef | ast.FunctionDef) and node.name == name for node in tree.body):
                    parts = [*file.relative_to(folder).with_suffix("").parts]
                    found.append(".".join(parts[:-1] if parts[-1] == "__init__" else parts))
        if len(found) != 1:
            what = f"is in several modules: {', '.join(found)}" if found else "is in no module of the package"
            raise RosLoadError([f"{name} {what}; write `module:{name}`"])
        return found[0]

    def save_coverage(self) -> None:
        """Do nothing: coverage.py records modules."""

    def running(self) -> str:
        """Return what the node did when the last forked process ended; empty if it is not known."""
        return ""

    def run_case(self, action: Callable[[], None], give_up: Callable[[], None]) -> None:
        """Run the driver's side of a case, which drives the nodes; `give_up` ends the process if they do not end."""
        del give_up
        action()

    def start(self, settings: RosSettings) -> RosSystem:
        """Begin a case in this process; its nodes are made in the first `run_until`."""
        if self._run is None:
            raise RuntimeError("call `load` before `start`")
        run = self._run
        self.install()
        _forget_earlier_cases()
        system = RosSystem(self, settings)
        CURRENT.system, CURRENT.threads = system, system.threads
        os.environ.update(settings.environment)
        random.seed(settings.seed)
        simulated_time.seed_numpy(settings.seed)
        sys.stdin = system.stdin
        if settings.arguments:
            sys.argv = [self.package or "node", *settings.arguments]
        system.begin(lambda: run(settings))
        return system


def _spin(node_class: Any) -> None:
    """Make a node and spin it to the end of the case."""
    rclpy: Any = importlib.import_module("rclpy")
    rclpy.init()
    node = node_class()
    rclpy.spin(node)


def _forget_earlier_cases() -> None:
    """Take back what an earlier case in this process left in rclpy."""
    utilities: Any = sys.modules.get("rclpy.utilities")
    rclpy: Any = sys.modules.get("rclpy")
    logging: Any = sys.modules.get("rclpy.logging")
    if utilities is not None:
        utilities._Default.context = None
    if rclpy is not None and hasattr(rclpy, "_Global"):
        rclpy._Global.executor = None
    if logging is not None:
        logging.clear_config()
