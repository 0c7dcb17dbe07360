"""A C++ node that is compiled with an installed ROS 2 and runs in the process of the test application."""

from __future__ import annotations

import ctypes
import os
import signal
import sys
from collections.abc import Iterable, Mapping

from sitaf_ros.cpp.library import save_coverage
from sitaf_ros.errors import RosLoadError
from sitaf_ros.installed.application import InstalledApplication
from sitaf_ros.settings import RosSettings


class CppNodeFailedError(Exception):
    """What a C++ node threw."""


class InstalledCppApplication(InstalledApplication):
    """A library that `sitaf_ros.cpp.installed_build` made."""

    _library: ctypes.CDLL | None = None

    def load(self, entry: str, environment: Mapping[str, str] | None = None, arguments: Iterable[str] = ()) -> None:
        """Load the library, the file `entry`; its static variables are made now."""
        del arguments
        self.install()
        os.environ.update(environment or {})
        try:
            library = ctypes.CDLL(entry)
        except OSError as e:
            raise RosLoadError([f"the library of the node cannot be loaded: {e}"]) from e
        library.sitaf_node_run.restype = ctypes.c_char_p
        self._library = library

        def run(settings: RosSettings) -> None:
            del settings
            given = [argument.encode() for argument in sys.argv]
            argv = (ctypes.c_char_p * (len(given) + 1))(*given, None)
            # Python's handler would wait for the interpreter. That of rclcpp, which replaces this, ends spin.
            signal.signal(signal.SIGINT, signal.SIG_IGN)
            thrown = library.sitaf_node_run(len(given), argv)
            if thrown:
                raise CppNodeFailedError(thrown.decode(errors="replace"))

        self._run = run

    def save_coverage(self) -> None:
        """Save which lines of the node this process has executed, if they are counted."""
        if self._library is not None:
            save_coverage(self._library)

    def end_nodes(self) -> None:
        """End the nodes as Ctrl-C does, for which every node is made."""
        os.kill(os.getpid(), signal.SIGINT)
