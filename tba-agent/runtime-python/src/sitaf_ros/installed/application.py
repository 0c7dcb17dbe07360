"""A Python node that runs with the installed rclpy, in the place of the API that comes along."""

from __future__ import annotations

import importlib
import os
import queue
import random
import sys
import tempfile
import threading
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

from sitaf_ros.application import RosApplication
from sitaf_ros.current import CURRENT
from sitaf_ros.errors import RosLoadError
from sitaf_ros.installed import isolation
from sitaf_ros.installed.system import InstalledSystem
from sitaf_ros.settings import ROS_PARAMETERS, RosSettings, is_parameter_file

MODULES = "SITAF_ROS_MODULES"
"""Variable with the folders of the installation's Python modules."""
_END_AT_MOST_S = 5.0
_MISSING = "the ROS 2 of this machine has no rclpy for Python {}.{}: {}"


class InstalledApplication(RosApplication):
    """Sources of a package that run with the installed ROS 2."""

    def __init__(self, *arguments: Any, **named: Any) -> None:
        super().__init__(*arguments, **named)
        self._mains: queue.SimpleQueue[Callable[[], None] | None] = queue.SimpleQueue()
        self._reserved: Any = None
        self._temporary = Path()

    def install(self) -> None:
        """Make the installed packages importable; those of the runtime's environment win."""
        if CURRENT.application is self:
            return
        CURRENT.application = self
        sys.path[:0] = [str(folder) for folder in self.folders if str(folder) not in sys.path]
        modules = [folder for folder in os.environ.get(MODULES, "").split(os.pathsep) if folder]
        sys.path += [folder for folder in modules if folder not in sys.path]
        # Logs of rcl; and a prefix as the package itself would have it when it is installed.
        temporary = self._temporary = Path(tempfile.mkdtemp(prefix="sitaf-ros-"))
        os.environ["ROS_LOG_DIR"] = str(temporary / "log")
        self._as_installed(temporary)
        try:
            importlib.import_module("rclpy")
        except ImportError as e:
            raise RosLoadError([_MISSING.format(*sys.version_info[:2], e)]) from e

    def _as_installed(self, prefix: Path) -> None:
        index = prefix / "share" / "ament_index" / "resource_index" / "packages"
        index.mkdir(parents=True)
        for name, folder in self.share.items():
            (index / name).touch()
            (prefix / "share" / name).symlink_to(folder)
        before = os.environ.get("AMENT_PREFIX_PATH", "")
        os.environ["AMENT_PREFIX_PATH"] = os.pathsep.join(filter(None, (str(prefix), before)))

    def load(self, entry: str, environment: Mapping[str, str] | None = None, arguments: Iterable[str] = ()) -> None:
        """Import the entry; a `main(argv=sys.argv)` reads its arguments now, so the files of parameters have names."""
        self.install()
        super().load(entry, environment, [*arguments, "--ros-args", *self._write_parameters({})])

    def _write_parameters(self, parameters: Mapping[str, Any]) -> list[str]:
        """Write the parameters of a case; return the arguments that name their files."""
        of_all = {"/**": {ROS_PARAMETERS: {"use_sim_time": True}}}
        own = (
            parameters
            if is_parameter_file(parameters)
            else {"/**": {ROS_PARAMETERS: {**parameters, "use_sim_time": True}}}
        )
        yaml: Any = importlib.import_module("yaml")  # rclpy needs it, too
        arguments = []
        for name, content in (("case", own), ("time", of_all)):
            file = self._temporary / f"{name}.yaml"
            file.write_text(yaml.safe_dump(content), encoding="utf-8")
            arguments += ["--params-file", str(file)]
        return arguments

    def _check(self, file: Path | None) -> None:
        """Check nothing: the whole API is there."""

    def run_case(self, action: Callable[[], None], give_up: Callable[[], None]) -> None:
        """Run the driver's side of a case in a thread, and its nodes in this one, the main thread.

        `give_up` ends the process, when the nodes do not end with the case.
        """
        ended = threading.Event()

        def drive() -> None:
            try:
                action()
            finally:
                self._mains.put(None)
                if not ended.wait(_END_AT_MOST_S):
                    give_up()

        driver = threading.Thread(target=drive, name="sitaf-driver")
        driver.start()
        main = self._mains.get()
        if main is not None:
            main()
            self._mains.get()
        ended.set()
        driver.join()

    def end_nodes(self) -> None:
        """End the nodes: spin returns."""
        importlib.import_module("rclpy").try_shutdown()

    def begin(self, main: Callable[[], None]) -> None:
        """Run the nodes in the main thread."""
        self._mains.put(main)

    def start(self, settings: RosSettings) -> Any:
        """Begin a case in this process; its nodes are made in the first `run_until`."""
        if self._run is None:
            raise RuntimeError("call `load` before `start`")
        run = self._run
        if self._reserved is None:
            self._reserved = isolation.enter()
        os.environ.update(settings.environment)
        random.seed(settings.seed)
        _set_input(settings.stdin)
        sys.argv = [
            self.package or "node",
            *settings.arguments,
            "--ros-args",
            *self._write_parameters(settings.parameters),
        ]
        sys.argv += _names(settings)
        return InstalledSystem(self, settings, lambda: run(settings))


def _set_input(lines: tuple[str, ...] | list[str]) -> None:
    """Give the node a terminal with these lines; a read beyond them waits."""
    master, slave = os.openpty()
    for line in lines:
        os.write(master, f"{line}\n".encode())
    os.dup2(slave, 0)
    os.close(slave)
    sys.stdin = os.fdopen(0, encoding="utf-8", closefd=False)


def _names(settings: RosSettings) -> list[str]:
    """The arguments that replace names."""
    arguments: list[str] = []
    for source, target in settings.remap.items():
        arguments += ["-r", f"{source}:={target}"]
    if settings.node_name is not None:
        arguments += ["-r", f"__node:={settings.node_name}"]
    if settings.namespace:
        arguments += ["-r", f"__ns:={settings.namespace}"]
    return arguments
